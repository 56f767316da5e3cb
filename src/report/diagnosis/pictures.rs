//! Pictures of what was found: deviation as colours, facing, creases, and the worst places close up.

use super::sight::{self, Sight};
use crate::io::Loaded;
use crate::mesh::{Column, Faces, Mesh, MeshBuilder, normal_matrix};
use crate::normals::{NormalField, Summary};
use crate::num::{Degrees, LinearRgb};
use crate::quality::{Diagnosis, Site, Survey, survey};
use crate::raster::{
    Camera, Object, Paint, Recentring, RenderSettings, Samples, Scene, Shape, Show, default_lights, render,
};
use crate::report::label::{draw_text, text_width};
use crate::report::viridis::viridis;
use crate::report::{Overlay, Picture, ReportError, overlay};
use crate::shade::Material;
use glam::{DMat3, DMat4, DVec3};
use std::borrow::Cow;

/// A file taken apart, so that each corner has a colour and a normal of its own.
pub(super) struct Model {
    parts: Vec<PartModel>,
    /// Which part stands where.
    places: Vec<(usize, DMat4)>,
    pub(super) scale: HeatScale,
}

/// Which deviation has the light end of the colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HeatScale {
    full: Degrees,
    /// Some deviations are larger.
    is_clipped: bool,
}

impl HeatScale {
    /// Round angles that scales end at. Below the first, a picture shows nothing of it.
    const ENDS: [f64; 11] = [1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0, 180.0];

    /// The first round angle that no more than one deviation in two hundred is above: single faults do not make all others
    /// look alike.
    pub(super) fn of<'a>(surveys: impl Iterator<Item = &'a Survey>) -> Self {
        let mut all: Vec<f64> = surveys.flat_map(|survey| &survey.deviations).copied().collect();
        all.sort_unstable_by(f64::total_cmp);
        let nearly_all = all.iter().rev().nth(all.len() / 200).copied().unwrap_or_default();
        let full = Self::ENDS.into_iter().find(|&end| end >= nearly_all).unwrap_or(180.0);
        Self { full: Degrees(full), is_clipped: all.last().is_some_and(|&largest| largest > full) }
    }

    /// What stands at the light end, and in the middle.
    fn labels(self) -> [String; 2] {
        let more = if self.is_clipped { " and more" } else { "" };
        [format!("{}°{more}", self.full.0), format!("{}°", self.full.0 / 2.0)]
    }

    /// The same for those who do not see it.
    pub(super) fn words(self) -> String {
        format!("from violet, 0°, to yellow, {}", self.labels()[0])
    }
}

struct PartModel {
    mesh: Mesh,
    field: NormalField,
    colours: Vec<LinearRgb>,
}

impl Model {
    /// The file with what was measured of each part, in colours of a scale.
    pub(super) fn new(loaded: &Loaded, surveys: &[Survey], scale: HeatScale) -> Result<Self, ReportError> {
        let parts = loaded.parts.iter().zip(surveys);
        let parts: Vec<PartModel> = parts
            .map(|(part, survey)| PartModel::new(&part.mesh, survey, scale))
            .collect::<Result<_, _>>()?;
        let has_faces = |part: usize| parts[part].mesh.face_count() > 0;
        let mut places: Vec<(usize, DMat4)> =
            loaded.nodes.iter().map(|node| (node.part, node.world_from_part)).collect();
        if places.is_empty() {
            places = (0..parts.len()).map(|part| (part, DMat4::IDENTITY)).collect();
        }
        let is_flat = |place: DMat4| normal_matrix(DMat3::from_mat4(place)).is_none();
        places.retain(|&(part, place)| has_faces(part) && !is_flat(place));
        let mut model = Self { parts, places, scale };
        model.recentre()?;
        Ok(model)
    }

    /// Brings what is huge, tiny or far away to where a camera can see it.
    fn recentre(&mut self) -> Result<(), ReportError> {
        let Some((low, high)) = self.bounds() else { return Ok(()) };
        if !(low.is_finite() && high.is_finite()) {
            return Err(ReportError::Range);
        }
        if let Some(recentring) = Recentring::of((low, high)) {
            self.places.iter_mut().for_each(|(_, place)| recentring.apply(place));
        }
        Ok(())
    }

    /// Which object a place is on, where that is in the world, and which way its face looks there.
    pub(super) fn stand(&self, site: &Site) -> Option<(usize, DVec3, DVec3)> {
        let position = site.position?;
        let object = self.places.iter().position(|(part, _)| *part == site.part)?;
        let place = self.places[object].1;
        let normals = &self.parts[site.part].field.face_normals;
        let normal = site.face.map_or(DVec3::ZERO, |face| normals[face as usize]);
        let normal = normal_matrix(DMat3::from_mat4(place)).and_then(|matrix| matrix.apply(normal));
        Some((object, place.transform_point3(position), normal.unwrap_or(DVec3::ZERO)))
    }

    /// The mesh of each part, every corner a vertex of its own.
    pub(super) fn meshes(&self) -> impl Iterator<Item = &Mesh> {
        self.parts.iter().map(|part| &part.mesh)
    }

    /// Which part stands where.
    pub(super) fn objects(&self) -> impl Iterator<Item = (usize, DMat4)> {
        self.places.iter().copied()
    }

    /// Which part an object is, and where it stands.
    pub(super) fn object(&self, object: usize) -> (usize, DMat4) {
        self.places[object]
    }

    /// The mesh of a part, every corner a vertex of its own, and the normals of its faces.
    pub(super) fn part(&self, part: usize) -> (&Mesh, &[DVec3]) {
        let PartModel { mesh, field, .. } = &self.parts[part];
        (mesh, &field.face_normals)
    }

    /// All points, in the world.
    pub(super) fn points(&self) -> impl Iterator<Item = DVec3> {
        let of = |&(part, place): &(usize, DMat4)| {
            self.parts[part].mesh.positions().iter().map(move |&position| place.transform_point3(position))
        };
        self.places.iter().flat_map(of)
    }

    /// The scene from a camera, as it is lit, or coloured by deviation.
    pub(super) fn scene(&self, camera: Camera, is_coloured: bool) -> Scene<'_> {
        let object = |&(part, transform): &(usize, DMat4)| {
            let PartModel { mesh, field, colours } = &self.parts[part];
            let plain = Object::new(Shape::Mesh { mesh, normals: field }, Material::default());
            let paint = if is_coloured { Paint::Given(Cow::Borrowed(colours)) } else { plain.paint };
            Object { paint, transform, ..plain }
        };
        Scene {
            objects: self.places.iter().map(object).collect(),
            lines: Vec::new(),
            lights: default_lights(&camera).to_vec(),
            camera,
            background: LinearRgb::WHITE,
        }
    }

    /// The box round all of it, in the world; `None` if there is nothing.
    pub(super) fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let any = Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0);
        self.scene(any, false).bounds()
    }

    /// Coloured by deviation, with a legend, and with rings round some places.
    pub(super) fn deviation(
        &self,
        camera: Camera,
        side: u32,
        sites: &[&Site],
    ) -> Result<Picture, ReportError> {
        let mut scene = self.scene(camera, true);
        // Colours alone show no form.
        scene.lines = overlay(&scene, [side; 2], Overlay::Creases);
        scene.lines.iter_mut().for_each(|lines| lines.style.colour = LinearRgb::grey(0.3));
        let mut picture = draw(&scene, side, Show::Shaded)?;
        for site in sites {
            if let Some((_, position, _)) = self.stand(site)
                && let Ok(Some(at)) = camera.on_picture([side; 2], position)
            {
                ring(&mut picture, at, f64::from(side) / 40.0);
            }
        }
        legend(&mut picture, self.scale);
        Ok(picture)
    }

    /// Lit with the normals that it has.
    pub(super) fn lit(&self, camera: Camera, side: u32) -> Result<Picture, ReportError> {
        draw(&self.scene(camera, false), side, Show::Shaded)
    }

    /// Front faces green, back faces red.
    pub(super) fn facing(&self, camera: Camera, side: u32) -> Result<Picture, ReportError> {
        draw(&self.scene(camera, false), side, Show::Facing)
    }

    /// Lit, with the edges whose two sides have different normals as lines.
    pub(super) fn creases(&self, camera: Camera, side: u32) -> Result<Picture, ReportError> {
        let mut scene = self.scene(camera, false);
        scene.lines = overlay(&scene, [side; 2], Overlay::Creases);
        draw(&scene, side, Show::Shaded)
    }
}

impl PartModel {
    fn new(mesh: &Mesh, survey: &Survey, scale: HeatScale) -> Result<Self, ReportError> {
        let corners = mesh.faces().corners();
        let mut faces = Faces::with_capacity(corners.len());
        for range in mesh.faces().ranges() {
            faces.push(&range.map(|corner| corner as u32).collect::<Vec<u32>>());
        }
        let positions = corners.iter().map(|&vertex| mesh.positions()[vertex as usize]).collect();
        let apart = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build();
        let apart = apart.map_err(|error| ReportError::Encoder(error.to_string()))?;
        let own: Vec<u32> = (0..corners.len() as u32).collect();
        let field = NormalField {
            normals: Column::per_corner(survey.shaded.clone(), own.clone()),
            entry_vertex: own,
            face_normals: survey.face_normals.clone(),
            morph_normals: Vec::new(),
            faults: crate::normals::Faults::default(),
            summary: Summary::default(),
        };
        let colours = survey.deviations.iter().map(|degrees| viridis(degrees / scale.full.0)).collect();
        Ok(Self { mesh: apart, field, colours })
    }
}

/// The heat map of a file alone: how far stored normals are from those that the rule of their mesh gives.
///
/// # Errors
/// If there is nothing to draw, or it cannot be drawn.
pub fn deviation_picture(
    loaded: &Loaded,
    diagnosis: &Diagnosis,
    sight: Sight,
    side: u32,
) -> Result<Picture, ReportError> {
    let surveys = survey(loaded);
    let model = Model::new(loaded, &surveys, HeatScale::of(surveys.iter()))?;
    let camera = sight::camera(&model, diagnosis, None, sight).ok_or(ReportError::Empty)?;
    model.deviation(camera, side, &[])
}

pub(super) fn draw(scene: &Scene<'_>, side: u32, show: Show) -> Result<Picture, ReportError> {
    let settings = RenderSettings {
        size: [side; 2],
        samples: Samples::Four,
        two_sided: true,
        show,
        ..RenderSettings::default()
    };
    Ok(render(scene, &settings).map_err(|error| ReportError::Encoder(error.to_string()))?.into())
}

/// A red ring round a point of a picture.
pub(super) fn ring(picture: &mut Picture, [x, y]: [f64; 2], radius: f64) {
    let reach = radius as i64 + 3;
    for dy in -reach..=reach {
        for dx in -reach..=reach {
            let [px, py] = [x as i64 + dx, y as i64 + dy];
            let distance = libm::hypot(px as f64 + 0.5 - x, py as f64 + 0.5 - y);
            let share = (1.5 - (distance - radius).abs()).clamp(0.0, 1.0);
            picture.blend([px, py], [0.9, 0.1, 0.1], share as f32);
        }
    }
}

/// A bar of the colours with its ends in degrees, along the bottom.
fn legend(picture: &mut Picture, scale: HeatScale) {
    let [width, height] = picture.size.map(i64::from);
    let (bar, text) = ((height / 40).max(6), (height as f32 / 28.0).max(12.0));
    let (left, right, top) = (width / 8, width - width / 8, height - 2 * bar);
    for x in left..right {
        let colour = viridis((x - left) as f64 / (right - left - 1) as f64);
        let coded = crate::num::Srgb8::from(colour).0.map(|c| f32::from(c) / 255.0);
        (top..top + bar).for_each(|y| picture.blend([x, y], coded, 1.0));
    }
    let [full, half] = scale.labels();
    for (label, at) in [("0°", left), (&half, (left + right) / 2), (&full, right)] {
        let wide = text_width(label, text) as i64;
        let x = (at - wide / 2).clamp(0, width - wide);
        draw_text(picture, label, [x, top - text as i64 - 2], text, [0.1; 3]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scales_end_where_the_data_does() {
        let scale = |deviations: Vec<f64>| HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        assert_eq!(scale(vec![]).labels(), ["1°", "0.5°"]);
        assert_eq!(scale(vec![0.0, 3.0]).labels(), ["5°", "2.5°"]);
        assert_eq!(scale(vec![30.0; 7]).labels(), ["30°", "15°"]);
        // One in two hundred is left out, two are not.
        let with = |count: usize| [vec![0.0; 200 - count], vec![180.0; count]].concat();
        assert_eq!(scale(with(1)).words(), "from violet, 0°, to yellow, 1° and more");
        assert_eq!(scale(with(2)).words(), "from violet, 0°, to yellow, 180°");
    }
}
