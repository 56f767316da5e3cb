//! Pictures of what was found: deviation as colours, facing, creases, and the worst places close up.

use super::deviation::measure;
use super::heat::HeatScale;
use super::sight::{self, Sight};
use crate::io::Loaded;
use crate::mesh::{Column, Faces, Mesh, MeshBuilder, Obstacles, normal_matrix};
use crate::normals::{NormalField, Summary};
use crate::num::LinearRgb;
use crate::quality::{Diagnosis, Severity, Site, Survey, survey};
use crate::raster::{
    Camera, Image, Object, Paint, Recentring, RenderSettings, Samples, Scene, Shape, Show, default_lights,
    render,
};
use crate::report::{Overlay, Picture, ReportError, overlay};
use crate::shade::Material;
use glam::{DMat3, DMat4, DVec3};
use std::borrow::Cow;

/// A file taken apart, so that each corner has a colour and a normal of its own.
pub(super) struct Model {
    parts: Vec<PartModel>,
    /// Which part stands where.
    places: Vec<(usize, DMat4)>,
    /// Which of the nodes that have that part it is, in their order.
    numbers: Vec<u32>,
    pub(super) scale: HeatScale,
}

struct PartModel {
    mesh: Mesh,
    field: NormalField,
    /// The normals that the rule of the mesh gives: edges that are sharp by it show its form, whatever is wrong.
    ruled: NormalField,
    deviations: Vec<Option<f64>>,
    /// The same, to be drawn.
    measures: Vec<LinearRgb>,
}

impl Model {
    /// The file with what was measured of each part, in colours of a scale.
    pub(super) fn new(loaded: &Loaded, surveys: &[Survey], scale: HeatScale) -> Result<Self, ReportError> {
        let parts = loaded.parts.iter().zip(surveys);
        let parts: Vec<PartModel> =
            parts.map(|(part, survey)| PartModel::new(&part.mesh, survey)).collect::<Result<_, _>>()?;
        let has_faces = |part: usize| parts[part].mesh.face_count() > 0;
        let mut places: Vec<(usize, DMat4)> =
            loaded.nodes.iter().map(|node| (node.part, node.world_from_part)).collect();
        if places.is_empty() {
            places = (0..parts.len()).map(|part| (part, DMat4::IDENTITY)).collect();
        }
        let is_flat = |place: DMat4| normal_matrix(DMat3::from_mat4(place)).is_none();
        let number = |at: usize| places[..at].iter().filter(|(part, _)| *part == places[at].0).count() as u32;
        let is_shown = |&(part, place): &(usize, DMat4)| has_faces(part) && !is_flat(place);
        let numbers = (0..places.len()).filter(|&at| is_shown(&places[at])).map(number).collect();
        places.retain(is_shown);
        let mut model = Self { parts, places, numbers, scale };
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

    /// The middle of what a node shows of its part, in the world, if the place is about a node.
    pub(super) fn middle_of_node(&self, site: &Site) -> Option<DVec3> {
        let number = site.place?;
        let is_it = |at: &usize| self.places[*at].0 == site.part && self.numbers[*at] == number;
        let place = self.places[(0..self.places.len()).find(is_it)?].1;
        let (low, high) = self.parts[site.part].mesh.bounds()?;
        Some(place.transform_point3(low.midpoint(high)))
    }

    /// What rays may meet of each part.
    pub(super) fn obstacles(&self) -> Vec<Obstacles<'_>> {
        self.parts.iter().map(|part| Obstacles::new(&part.mesh)).collect()
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

    /// The mesh of a part, every corner a vertex of its own, and how far the normals of these are off.
    pub(super) fn deviations(&self, part: usize) -> (&Mesh, &[Option<f64>]) {
        let PartModel { mesh, deviations, .. } = &self.parts[part];
        (mesh, deviations)
    }

    /// The scene from a camera, as it is lit.
    pub(super) fn scene(&self, camera: Camera) -> Scene<'_> {
        let paint = |_: &PartModel| Paint::Lit(Material::default());
        self.painted(camera, |part| &part.field, paint)
    }

    /// The scene from a camera, with the [measure] of each corner for its colour.
    pub(super) fn measured(&self, camera: Camera) -> Scene<'_> {
        self.painted(camera, |part| &part.ruled, |part| Paint::Given(Cow::Borrowed(&part.measures)))
    }

    fn painted<'a>(
        &'a self,
        camera: Camera,
        normals: impl Fn(&'a PartModel) -> &'a NormalField,
        paint: impl Fn(&'a PartModel) -> Paint<'a>,
    ) -> Scene<'a> {
        let object = |&(part, transform): &(usize, DMat4)| {
            let part = &self.parts[part];
            let shape = Shape::Mesh { mesh: &part.mesh, normals: normals(part) };
            Object { paint: paint(part), transform, ..Object::new(shape, Material::default()) }
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
        self.scene(any).bounds()
    }

    /// Lit with the normals that it has.
    pub(super) fn lit(&self, camera: Camera, side: u32) -> Result<Picture, ReportError> {
        draw(&self.scene(camera), side, Show::Shaded)
    }

    /// Front faces light blue, back faces dark red.
    pub(super) fn facing(&self, camera: Camera, side: u32) -> Result<Picture, ReportError> {
        draw(&self.scene(camera), side, Show::Facing)
    }

    /// Lit, with the edges whose two sides have different normals as lines.
    pub(super) fn creases(&self, camera: Camera, side: u32) -> Result<Picture, ReportError> {
        let mut scene = self.scene(camera);
        scene.lines = overlay(&scene, [side; 2], Overlay::Creases);
        draw(&scene, side, Show::Shaded)
    }
}

impl PartModel {
    fn new(mesh: &Mesh, survey: &Survey) -> Result<Self, ReportError> {
        let corners = mesh.faces().corners();
        let mut faces = Faces::with_capacity(corners.len());
        for range in mesh.faces().ranges() {
            faces.push(&range.map(|corner| corner as u32).collect::<Vec<u32>>());
        }
        let positions = corners.iter().map(|&vertex| mesh.positions()[vertex as usize]).collect();
        let apart = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build();
        let apart = apart.map_err(|error| ReportError::Encoder(error.to_string()))?;
        let own: Vec<u32> = (0..corners.len() as u32).collect();
        let field = |normals: &[DVec3]| NormalField {
            normals: Column::per_corner(normals.to_vec(), own.clone()),
            entry_vertex: own.clone(),
            face_normals: survey.face_normals.clone(),
            morph_normals: Vec::new(),
            faults: crate::normals::Faults::default(),
            summary: Summary::default(),
        };
        Ok(Self {
            mesh: apart,
            field: field(&survey.shaded),
            ruled: field(&survey.expected),
            measures: survey.deviations.iter().copied().map(measure).collect(),
            deviations: survey.deviations.clone(),
        })
    }
}

/// The worst place of each error and warning.
pub(super) fn worst_places(diagnosis: &Diagnosis) -> Vec<&Site> {
    let grave = diagnosis.findings.iter().filter(|finding| finding.severity > Severity::Note);
    grave.filter_map(|finding| finding.places.first()).collect()
}

/// The heat map of a file alone: how far stored normals are from those that the rule of their mesh gives, with a ring round
/// the worst place of each error and warning that is seen, and a legend below; as many pixels wide as it is asked for, and higher by the
/// legend. The deviation spreads over faces from corner to corner, and each pixel has the colour of the mean of what it
/// shows. Corners whose faces are too small to be seen are marked with dots, the worst uppermost; where corners have no stored
/// normal that has a direction, the surface has a colour of its own.
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
    Ok(model.deviation(camera, side, &worst_places(diagnosis))?.0)
}

pub(super) fn draw(scene: &Scene<'_>, side: u32, show: Show) -> Result<Picture, ReportError> {
    Ok(render_at(scene, side, RenderSettings { show, ..RenderSettings::default() })?.into())
}

/// As all pictures of a report are drawn, with other settings as they are given.
pub(super) fn render_at(
    scene: &Scene<'_>,
    side: u32,
    settings: RenderSettings,
) -> Result<Image, ReportError> {
    let settings = RenderSettings { size: [side; 2], samples: Samples::Four, two_sided: true, ..settings };
    render(scene, &settings).map_err(|error| ReportError::Encoder(error.to_string()))
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
