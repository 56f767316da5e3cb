//! The choice of a view in which the worst positions are visible.

use super::model::Model;
use crate::mesh::Obstacles;
use crate::num::unit_scale;
use crate::quality::{Comparison, Diagnosis, Site};
use crate::raster::{Camera, Projection};
use glam::{DMat3, DMat4, DVec3};

/// The direction from which a file is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Sight {
    /// The one that shows most of the worst positions.
    #[default]
    Auto,
    /// From this side.
    From(DVec3),
}

/// The largest number of sites that are considered; more would only cost more.
const MOST_PLACES: usize = 64;

/// The limit of boxes and faces that are tested per ray; beyond it, a site counts as hidden.
const BUDGET: usize = 1 << 14;

/// The weight of a site that is seen edge-on or whose face has no direction, relative to one seen from the front.
const EDGE_ON: f64 = 0.05;

/// The share by which a site is moved towards the middle of its face.
const ASIDE: f64 = 0.02;

/// By how much another view has to be better than the usual one, which shows most shapes well.
const USUAL: f64 = 1.1;

/// The size of a picture relative to the model in it.
const MARGIN: f64 = 1.2;

/// A site that a view should show.
pub(super) struct WantedSite {
    pub(super) weight: f64,
    /// Whether it counts more if its face is seen from the front.
    pub(super) has_side: bool,
    pub(super) site: Site,
}

struct Wanted {
    position: DVec3,
    normal: DVec3,
    /// Its object and face.
    object: usize,
    face: u32,
    weight: f64,
}

impl Wanted {
    /// A site, moved a little into its face: at the corner itself other faces would hide it.
    fn of(model: &Model, site: &Site) -> Option<Self> {
        let (object, position, normal) = model.locate(site)?;
        let (part, place) = model.objects[object];
        let middle = site.face.map_or(position, |face| {
            let mesh = &model.parts[part].mesh;
            let corners = mesh.faces().face(face as usize);
            let sum: DVec3 = corners.iter().map(|&vertex| mesh.positions().at(vertex)).sum();
            place.transform_point3(sum / corners.len() as f64)
        });
        let position = position.lerp(middle, ASIDE);
        Some(Self { position, normal, object, face: site.face.unwrap_or(u32::MAX), weight: 0.0 })
    }
}

/// A camera that shows all of a model, from a side or from where most of the findings and changes are visible; `None` for an
/// empty model.
pub(super) fn camera(
    model: &Model,
    diagnosis: &Diagnosis,
    comparison: Option<&Comparison>,
    sight: Sight,
) -> Option<Camera> {
    camera_of_sites(model, &gravest(diagnosis, comparison), sight)
}

/// A camera that shows all of a model, from a side or from where the most of some sites are visible, by their weights; `None` for
/// an empty model.
pub(super) fn camera_of_sites(model: &Model, sites: &[WantedSite], sight: Sight) -> Option<Camera> {
    all_from(model, |usual| match sight {
        Sight::From(direction) => direction.normalize_or(DVec3::Z),
        Sight::Auto => {
            let place = |WantedSite { weight, has_side, site }: &WantedSite| {
                let wanted = Wanted::of(model, site)?;
                let normal = if *has_side { wanted.normal } else { DVec3::ZERO };
                Some(Wanted { weight: *weight, normal, ..wanted })
            };
            let wanted: Vec<Wanted> = sites.iter().filter_map(place).collect();
            best(model, &model.obstacles(), &wanted, usual)
        }
    })
}

/// A camera that shows all of a model from where a site is visible, and whether it is.
pub(super) fn camera_on(model: &Model, obstacles: &[Obstacles<'_>], site: &Site) -> Option<(Camera, bool)> {
    let place = Wanted { weight: 1.0, ..Wanted::of(model, site)? };
    let wanted = std::slice::from_ref(&place);
    let camera = all_from(model, |usual| best(model, obstacles, wanted, usual))?;
    Some((camera, is_seen(model, obstacles, &place, camera.eye - place.position)))
}

/// A camera that shows all of a model from a direction, computed from the usual one; `None` for an empty model.
fn all_from(model: &Model, direction: impl FnOnce(DVec3) -> DVec3) -> Option<Camera> {
    let framing = Camera::framing(model.bounds()?, 1.0);
    let distance = framing.eye.distance(framing.target);
    let direction = direction((framing.eye - framing.target) / distance);
    let up = if direction.y.abs() > 0.95 { DVec3::NEG_Z } else { DVec3::Y };
    let camera = Camera { eye: framing.target + direction * distance, up, ..framing };
    Some(zoomed(model, camera))
}

/// The sites of findings, errors before warnings before notes, and the largest changes.
fn gravest(diagnosis: &Diagnosis, comparison: Option<&Comparison>) -> Vec<WantedSite> {
    let found = diagnosis.findings.iter().flat_map(|finding| {
        let weight = [1.0, 100.0, 10_000.0][finding.severity as usize];
        finding.places.iter().map(move |site| (weight, site))
    });
    let changed = comparison.into_iter().flat_map(|it| &it.places).map(|site| (10_000.0, site));
    let mut sites: Vec<(f64, &Site)> = found.chain(changed).collect();
    sites.sort_by(|a, b| b.0.total_cmp(&a.0));
    let wanted = |(weight, site): (f64, &Site)| WantedSite { weight, has_side: true, site: site.clone() };
    sites.into_iter().take(MOST_PLACES).map(wanted).collect()
}

/// The best of the directions from a cube's faces, edges and corners; the usual one if it is not much worse. If none of them shows
/// any of the gravest sites, the directions of their face normals are tried as well.
fn best(model: &Model, obstacles: &[Obstacles<'_>], wanted: &[Wanted], usual: DVec3) -> DVec3 {
    if wanted.is_empty() {
        return usual;
    }
    let score = |direction: DVec3| -> f64 {
        let seen = wanted.iter().filter(|place| is_seen(model, obstacles, place, direction));
        seen.map(|place| place.weight * (EDGE_ON + place.normal.dot(direction).max(0.0))).sum()
    };
    let steps = [-1.0, 0.0, 1.0];
    let around =
        steps.iter().flat_map(|&x| steps.iter().flat_map(move |&y| steps.map(|z| DVec3::new(x, y, z))));
    let candidates = around.filter(|direction| *direction != DVec3::ZERO).map(DVec3::normalize);
    let better = |best: (DVec3, f64), direction: DVec3| {
        let score = score(direction);
        if score > best.1 { (direction, score) } else { best }
    };
    let best = candidates.fold((usual, score(usual) * USUAL), better);
    let grave = || wanted.iter().filter(|it| it.weight == wanted[0].weight && it.normal != DVec3::ZERO);
    let shown = |place: &Wanted, direction| is_seen(model, obstacles, place, direction);
    if grave().any(|place| shown(place, best.0)) {
        return best.0;
    }
    let mut sides = grave().map(|it| (it, it.normal)).chain(grave().map(|it| (it, -it.normal)));
    sides.find(|(place, side)| shown(place, *side)).map_or(best.0, |(_, side)| side)
}

pub(super) fn hidden(model: &Model, sites: &[&Site], eye: DVec3) -> Vec<bool> {
    if sites.is_empty() {
        return Vec::new();
    }
    let obstacles = model.obstacles();
    let is_hidden = |site: &&Site| {
        Wanted::of(model, site).is_some_and(|place| !is_seen(model, &obstacles, &place, eye - place.position))
    };
    sites.iter().map(is_hidden).collect()
}

/// Whether a site is visible from a distant eye.
fn is_seen(model: &Model, obstacles: &[Obstacles<'_>], place: &Wanted, direction: DVec3) -> bool {
    model.objects.iter().enumerate().all(|(number, &(part, transform))| {
        let back = inverse(transform);
        let from = obstacles[part].local(back.transform_point3(place.position));
        let own = if number == place.object { place.face } else { u32::MAX };
        let towards = back.transform_vector3(direction).normalize_or_zero();
        obstacles[part].is_free(from, towards, own, BUDGET) == Some(true)
    })
}

/// The distance from a position on a face to the next face in a direction, at most `most`.
pub(super) fn clearance(
    model: &Model,
    obstacles: &[Obstacles<'_>],
    (object, face, position): (usize, u32, DVec3),
    way: DVec3,
    most: f64,
) -> f64 {
    model.objects.iter().enumerate().fold(most, |most, (number, &(part, transform))| {
        let (back, obstacles) = (inverse(transform), &obstacles[part]);
        let from = obstacles.local(back.transform_point3(position));
        let along = obstacles.local_way(back.transform_vector3(way));
        let own = if number == object { face } else { u32::MAX };
        obstacles.clearance((from, along), own, most, BUDGET)
    })
}

/// The inverse of an affine map of any scale, whose determinant may be out of range.
fn inverse(map: DMat4) -> DMat4 {
    let linear = DMat3::from_mat4(map);
    let scale = unit_scale(linear.to_cols_array().into_iter().fold(0.0, |most: f64, x| most.max(x.abs())));
    let back = (linear * scale).inverse() * scale;
    DMat4::from_mat3_translation(back, -(back * map.w_axis.truncate()))
}

/// The same camera with the angle of view of the model.
fn zoomed(model: &Model, camera: Camera) -> Camera {
    let (Projection::Perspective(angle), Ok([right, up, forward])) = (camera.projection, camera.axes())
    else {
        return camera;
    };
    let tangent = |point: DVec3| {
        let seen = point - camera.eye;
        seen.dot(right).abs().max(seen.dot(up).abs()) / seen.dot(forward)
    };
    let widest = model.points().map(tangent).filter(|it| it.is_finite()).fold(0.0, f64::max);
    let fitting = 2.0 * libm::atan(widest * MARGIN);
    if fitting > 0.0 && fitting < angle.0 {
        Camera { projection: Projection::Perspective(crate::num::Radians(fitting)), ..camera }
    } else {
        camera
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Determinants of such scales are zero or infinite.
    #[test]
    fn maps_of_any_scale_are_undone() {
        let turn = DMat4::from_axis_angle(DVec3::new(1.0, 2.0, 3.0).normalize(), 0.7);
        let point = DVec3::new(0.3, -0.2, 0.9);
        for power in [-1000, -400, 0, 400, 1000] {
            let scale = DMat4::from_scale(DVec3::new(-1.0, 2.0, 0.5) * libm::ldexp(1.0, power));
            let map = turn * scale;
            let back = inverse(map).transform_point3(map.transform_point3(point));
            // Some tens of roundings of numbers below 1, and the scales differ by 4.
            assert!(back.distance(point) < 1e-14, "2^{power}: {back}");
        }
    }
}
