//! A file as a model whose corners have separate colours and normals, and its pictures.

use super::markers::{HeatScale, encode};
use crate::io::Loaded;
use crate::mesh::{Column, Faces, Mesh, Obstacles, normal_matrix};
use crate::normals::{NormalField, Summary};
use crate::num::LinearRgb;
use crate::quality::{Site, Survey};
use crate::raster::{
    Camera, Image, Object, Paint, Recentring, RenderSettings, Samples, Scene, Shape, Show, default_lights,
    render,
};
use crate::report::error::{ReportError, Result};
use crate::report::overlay::{Overlay, overlay};
use crate::report::picture::Picture;
use crate::shade::Material;
use glam::{DMat3, DMat4, DVec3};
use std::borrow::Cow;

pub(super) const OVERVIEW: u32 = 320;

/// A file whose corners have separate colours and normals.
pub(super) struct Model {
    pub(super) parts: Vec<PartModel>,
    pub(super) objects: Vec<(usize, DMat4)>,
    /// The number of each object among the nodes with the same part.
    numbers: Vec<u32>,
    pub(super) scale: HeatScale,
}

pub(super) struct PartModel {
    /// Every corner is a separate vertex.
    pub(super) mesh: Mesh,
    pub(super) field: NormalField,
    /// The normals of the estimated recipe: their creases show the form, whatever is wrong.
    ruled: NormalField,
    /// The deviation of each corner, in degrees.
    pub(super) deviations: Vec<Option<f64>>,
    /// The same, to be drawn.
    encoded: Vec<LinearRgb>,
}

impl Model {
    /// The file with the survey of each part, in colours of a scale.
    pub(super) fn new(loaded: &Loaded, surveys: &[Survey], scale: HeatScale) -> Result<Self> {
        let parts = loaded.parts.iter().zip(surveys);
        let parts: Vec<PartModel> =
            parts.map(|(part, survey)| PartModel::new(&part.mesh, survey)).collect::<Result<_>>()?;
        let has_faces = |part: usize| parts[part].mesh.face_count() > 0;
        let mut objects: Vec<(usize, DMat4)> =
            loaded.nodes.iter().map(|node| (node.part, node.world_from_part)).collect();
        if objects.is_empty() {
            objects = (0..parts.len()).map(|part| (part, DMat4::IDENTITY)).collect();
        }
        let is_flat = |place: DMat4| normal_matrix(DMat3::from_mat4(place)).is_none();
        let number =
            |at: usize| objects[..at].iter().filter(|(part, _)| *part == objects[at].0).count() as u32;
        let is_shown = |&(part, place): &(usize, DMat4)| has_faces(part) && !is_flat(place);
        let numbers = (0..objects.len()).filter(|&at| is_shown(&objects[at])).map(number).collect();
        objects.retain(is_shown);
        let mut model = Self { parts, objects, numbers, scale };
        model.recentre()?;
        Ok(model)
    }

    /// Moves huge, tiny or distant models into the range of a camera.
    fn recentre(&mut self) -> Result<()> {
        let Some((low, high)) = self.bounds() else { return Ok(()) };
        if !(low.is_finite() && high.is_finite()) {
            return Err(ReportError::Range);
        }
        if let Some(recentring) = Recentring::of((low, high)) {
            self.objects.iter_mut().for_each(|(_, place)| recentring.apply(place));
        }
        Ok(())
    }

    /// The object of a site, its world position, and the normal of its face (zero if none).
    pub(super) fn locate(&self, site: &Site) -> Option<(usize, DVec3, DVec3)> {
        let position = site.position?;
        let object = self.objects.iter().position(|(part, _)| *part == site.part)?;
        let place = self.objects[object].1;
        let normals = &self.parts[site.part].field.face_normals;
        let normal = site.face.map_or(DVec3::ZERO, |face| normals[face as usize]);
        let normal = normal_matrix(DMat3::from_mat4(place)).and_then(|matrix| matrix.apply(normal));
        Some((object, place.transform_point3(position), normal.unwrap_or(DVec3::ZERO)))
    }

    /// The middle of a node's part, in the world, if the site is about a node.
    pub(super) fn middle_of_node(&self, site: &Site) -> Option<DVec3> {
        let number = site.place?;
        let is_it = |at: &usize| self.objects[*at].0 == site.part && self.numbers[*at] == number;
        let place = self.objects[(0..self.objects.len()).find(is_it)?].1;
        let (low, high) = self.parts[site.part].mesh.bounds()?;
        Some(place.transform_point3(low.midpoint(high)))
    }

    /// The obstacles of each part, for rays.
    pub(super) fn obstacles(&self) -> Vec<Obstacles<'_>> {
        self.parts.iter().map(|part| Obstacles::new(&part.mesh)).collect()
    }

    /// All points, in the world.
    pub(super) fn points(&self) -> impl Iterator<Item = DVec3> {
        let of = |&(part, place): &(usize, DMat4)| {
            self.parts[part].mesh.positions().iter().map(move |position| place.transform_point3(position))
        };
        self.objects.iter().flat_map(of)
    }

    pub(super) fn scene(&self, camera: Camera) -> Scene<'_> {
        self.painted(camera, |part| &self.parts[part].field, |_| Paint::Lit(Material::default()))
    }

    /// The scene from a camera, with the [encoded](encode) deviation of each corner for its colour.
    pub(super) fn encoded(&self, camera: Camera) -> Scene<'_> {
        let encoded = |part: usize| Paint::Given(Cow::Borrowed(&*self.parts[part].encoded));
        self.painted(camera, |part| &self.parts[part].ruled, encoded)
    }

    /// The scene from a camera, with a colour for each corner of each part.
    pub(super) fn coloured<'a>(&'a self, camera: Camera, colours: &'a [Vec<LinearRgb>]) -> Scene<'a> {
        let given = |part: usize| Paint::Given(Cow::Borrowed(&*colours[part]));
        self.painted(camera, |part| &self.parts[part].ruled, given)
    }

    fn painted<'a>(
        &'a self,
        camera: Camera,
        normals: impl Fn(usize) -> &'a NormalField,
        paint: impl Fn(usize) -> Paint<'a>,
    ) -> Scene<'a> {
        let object = |&(part, transform): &(usize, DMat4)| {
            let shape = Shape::Mesh { mesh: &self.parts[part].mesh, normals: normals(part) };
            Object { paint: paint(part), transform, ..Object::new(shape, Material::default()) }
        };
        Scene {
            objects: self.objects.iter().map(object).collect(),
            lines: Vec::new(),
            lights: default_lights(&camera).to_vec(),
            camera,
            background: LinearRgb::WHITE,
        }
    }

    /// The bounding box in the world; `None` if it is empty.
    pub(super) fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let any = Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0);
        self.scene(any).bounds()
    }

    pub(super) fn lit(&self, camera: Camera, side: u32) -> Result<Picture> {
        draw(&self.scene(camera), side, Show::Shaded)
    }

    /// Front faces light blue, back faces dark red.
    pub(super) fn facing(&self, camera: Camera, side: u32) -> Result<Picture> {
        draw(&self.scene(camera), side, Show::Facing)
    }

    /// Lit, with the edges whose two sides have different normals as lines.
    pub(super) fn creases(&self, camera: Camera, side: u32) -> Result<Picture> {
        let mut scene = self.scene(camera);
        scene.lines = overlay(&scene, [side; 2], Overlay::Creases);
        draw(&scene, side, Show::Shaded)
    }
}

impl PartModel {
    /// The normals that show the form, corner by corner.
    pub(super) fn form_normals(&self) -> &[DVec3] {
        &self.ruled.normals.values
    }

    fn new(mesh: &Mesh, survey: &Survey) -> Result<Self> {
        let corners = mesh.faces().corners();
        let mut faces = Faces::with_capacity(corners.len());
        for range in mesh.faces().ranges() {
            faces.push(&range.map(|corner| corner as u32).collect::<Vec<u32>>());
        }
        let positions: Vec<DVec3> = corners.iter().map(|&vertex| mesh.positions().at(vertex)).collect();
        let separate =
            Mesh::new(positions, faces).map_err(|error| ReportError::Encoder(error.to_string()))?;
        let corner_numbers: Vec<u32> = (0..corners.len() as u32).collect();
        let field = |normals: &[DVec3]| NormalField {
            normals: Column::per_corner(normals.to_vec(), corner_numbers.clone()),
            entry_vertex: corner_numbers.clone(),
            face_normals: survey.face_normals.clone(),
            morph_normals: Vec::new(),
            faults: crate::normals::Faults::default(),
            summary: Summary::default(),
        };
        Ok(Self {
            mesh: separate,
            field: field(&survey.shaded),
            ruled: field(&survey.expected),
            encoded: survey.deviations.iter().copied().map(encode).collect(),
            deviations: survey.deviations.clone(),
        })
    }
}

pub(super) fn draw(scene: &Scene<'_>, side: u32, show: Show) -> Result<Picture> {
    Ok(render_at(scene, side, RenderSettings { show, ..RenderSettings::default() })?.into())
}

/// Renders with the settings of all pictures of a report, and the given other ones.
pub(super) fn render_at(scene: &Scene<'_>, side: u32, settings: RenderSettings) -> Result<Image> {
    let settings = RenderSettings { size: [side; 2], samples: Samples::Four, two_sided: true, ..settings };
    render(scene, &settings).map_err(|error| ReportError::Encoder(error.to_string()))
}
