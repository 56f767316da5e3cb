//! Pictures of a site: close up, in the whole, and of its node.

use super::model::{Model, draw};
use super::view_choice::{camera_on, clearance};
use crate::mesh::{Mesh, Obstacles, normal_matrix};
use crate::quality::Site;
use crate::raster::{Camera, Projection, Show};
use crate::report::error::Result;
use crate::report::legend::ring;
use crate::report::overlay::{Overlay, overlay};
use crate::report::picture::Picture;
use glam::{DMat3, DMat4, DVec3};

/// The height of a close-up in short edges.
const EDGES: f64 = 8.0;

/// The size of the close-up as a share of the model where edges have no length, and the least distance of the eye in edges.
const CLOSEST: f64 = 1e-3;

impl Model {
    /// A close-up, lit, with edges; what covers the site is cut away. `None` without a position.
    pub(super) fn close_up(
        &self,
        site: &Site,
        obstacles: &[Obstacles<'_>],
        side: u32,
    ) -> Result<Option<Picture>> {
        let (Some((object, position, normal)), Some((low, high))) = (self.locate(site), self.bounds()) else {
            return Ok(None);
        };
        let (part, place) = self.objects[object];
        let mesh = &self.parts[part].mesh;
        let around = Around::new(mesh, site);
        let local = around.size(mesh, site, place, (high - low).length());
        let size = if local > 0.0 { local } else { CLOSEST * (high - low).length() };
        if size == 0.0 || !size.is_finite() {
            return Ok(None);
        }
        let towards = if normal == DVec3::ZERO {
            around.outward(&self.parts[part].field.face_normals, place)
        } else {
            normal
        };
        let up = if towards.y.abs() > 0.95 { DVec3::NEG_Z } else { DVec3::Y };
        // Half way to the next face in front, if that is nearer than the picture is wide.
        let face = site.face.unwrap_or(u32::MAX);
        let clear = clearance(self, obstacles, (object, face, position), towards, EDGES * size);
        let camera = Camera {
            eye: position + towards * (0.5 * clear).max(CLOSEST * size),
            target: position,
            up,
            projection: Projection::Orthographic(EDGES * size),
            near: 0.0,
        };
        let mut scene = self.scene(camera);
        scene.lines = overlay(&scene, [side; 2], Overlay::Wire);
        let mut picture = draw(&scene, side, Show::Shaded)?;
        ring(&mut picture, [f64::from(side) / 2.0; 2], f64::from(side) / 16.0);
        Ok(Some(picture))
    }

    /// The whole model lit, from where a site is visible, with a ring around it; and whether it is visible.
    pub(super) fn whereabouts(
        &self,
        site: &Site,
        obstacles: &[Obstacles<'_>],
        side: u32,
    ) -> Result<Option<(Picture, bool)>> {
        let (Some((_, position, _)), Some((camera, is_seen))) =
            (self.locate(site), camera_on(self, obstacles, site))
        else {
            return Ok(None);
        };
        let mut picture = self.lit(camera, side)?;
        if let Ok(Some(at)) = camera.on_picture([side; 2], position) {
            ring(&mut picture, at, f64::from(side) / 30.0);
        }
        Ok(Some((picture, is_seen)))
    }

    /// The whole model lit, with a ring around the middle of a node's mesh; `None` if the site is not about a node.
    pub(super) fn node(&self, site: &Site, camera: Option<Camera>, side: u32) -> Result<Option<Picture>> {
        let Some((middle, camera)) = self.middle_of_node(site).zip(camera) else { return Ok(None) };
        let mut picture = self.lit(camera, side)?;
        if let Ok(Some(at)) = camera.on_picture([side; 2], middle) {
            ring(&mut picture, at, f64::from(side) / 12.0);
        }
        Ok(Some(picture))
    }
}

/// The faces with a corner at a site: at its vertex, or at any corner of its face.
struct Around {
    faces: Vec<usize>,
}

impl Around {
    fn new(mesh: &Mesh, site: &Site) -> Self {
        let places: Vec<DVec3> = match (site.vertex, site.face) {
            (None, Some(face)) => points(mesh, face as usize).collect(),
            _ => site.position.into_iter().collect(),
        };
        let faces = 0..mesh.face_count();
        Self {
            faces: faces.filter(|&face| points(mesh, face).any(|point| places.contains(&point))).collect(),
        }
    }

    /// The lower quartile of the lengths of edges there, in the world: long faces end at short edges. It is limited so that the
    /// picture is not much wider than the `whole`; for the site of a face it is large enough to show all of the face.
    fn size(&self, mesh: &Mesh, site: &Site, place: DMat4, whole: f64) -> f64 {
        let edges = self.faces.iter().flat_map(|&face| {
            let ends = points(mesh, face).skip(1).chain(points(mesh, face).take(1));
            points(mesh, face).zip(ends).map(|(tail, head)| place.transform_vector3(head - tail).length())
        });
        let mut lengths: Vec<f64> = edges.collect();
        lengths.sort_unstable_by(f64::total_cmp);
        let short = lengths.get(lengths.len() / 4).copied().unwrap_or(0.0).min(1.25 / EDGES * whole);
        match (site.vertex, site.face, site.position) {
            (None, Some(face), Some(middle)) => {
                let reach =
                    points(mesh, face as usize).map(|point| place.transform_vector3(point - middle).length());
                reach.map(|reach| 2.5 / EDGES * reach).fold(short, f64::max)
            }
            _ => short,
        }
    }

    /// The mean direction of the faces in the world, +z if there is none.
    fn outward(&self, face_normals: &[DVec3], place: DMat4) -> DVec3 {
        let sum: DVec3 = self.faces.iter().map(|&face| face_normals[face]).sum();
        let normal = normal_matrix(DMat3::from_mat4(place)).and_then(|matrix| matrix.apply(sum));
        normal.unwrap_or(DVec3::Z)
    }
}

fn points(mesh: &Mesh, face: usize) -> impl Iterator<Item = DVec3> {
    mesh.faces().face(face).iter().map(|&vertex| mesh.positions().at(vertex))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};

    /// A post a hundred long, and at its end a small square.
    fn post() -> Mesh {
        let corner = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        let positions =
            vec![corner(0.0, 0.0), corner(-100.0, 0.0), corner(0.0, 1.0), corner(1.0, 1.0), corner(1.0, 0.0)];
        let mut faces = Faces::new();
        [&[0, 2, 1][..], &[0, 4, 3, 2]].iter().for_each(|face| faces.push(face));
        MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap()
    }

    /// The close-up of a corner at the end of a long face was as wide as that face.
    #[test]
    fn places_are_shown_by_their_short_edges_where_nodes_put_them() {
        let mesh = post();
        let corner = Site { face: Some(0), vertex: Some(0), position: Some(DVec3::ZERO), ..Site::default() };
        let whole = Site { vertex: None, position: Some(DVec3::new(-33.0, 0.5, 0.0)), ..corner.clone() };
        // A model is never larger than 2¹⁰⁰.
        for scale in [1.0, 1e-3, 1e30] {
            let place = DMat4::from_scale(DVec3::splat(scale));
            let size = |site: &Site| Around::new(&mesh, site).size(&mesh, site, place, 101.0 * scale) / scale;
            assert!((size(&corner) - 1.0).abs() < 1e-12, "{}", size(&corner));
            // The far corner is 67 away: within the picture, and not at its rim.
            let half = 0.5 * EDGES * size(&whole);
            assert!(half > 70.0 && half < 100.0, "{half}");
        }
        // The place is in the middle, and a corner of what is no larger than two edges.
        let small = Around::new(&mesh, &corner).size(&mesh, &corner, DMat4::IDENTITY, 2.0);
        assert_eq!(EDGES * small, 2.5);
        let nowhere = Site { position: Some(DVec3::ONE * 7.0), ..Site::default() };
        assert_eq!(Around::new(&mesh, &nowhere).size(&mesh, &nowhere, DMat4::IDENTITY, 9.0), 0.0);
    }

    #[test]
    fn vertices_are_looked_at_from_where_their_faces_look() {
        let mesh = post();
        let vertex = Site { vertex: Some(0), position: Some(DVec3::ZERO), ..Site::default() };
        let around = Around::new(&mesh, &vertex);
        assert_eq!(around.faces, [0, 1]);
        let normals = [DVec3::NEG_Z, DVec3::NEG_Z];
        assert_eq!(around.outward(&normals, DMat4::IDENTITY), DVec3::NEG_Z);
        let turned = DMat4::from_scale(DVec3::new(1.0, -1.0, -1.0));
        assert_eq!(around.outward(&normals, turned), DVec3::Z);
        assert_eq!(around.outward(&[DVec3::Z, DVec3::NEG_Z], DMat4::IDENTITY), DVec3::Z, "any, if none");
    }
}
