//! A mesh rendered with averaged or split normals, compared with its faces; and a user's mesh so rendered.

use super::super::prelude::*;
use crate::metric::{NormalDeviation, normal_deviation};
use crate::normals::Groups;

/// Full scale of the maps of angles, in degrees, and of light.
pub(super) const FULL_ANGLE: f64 = 60.0;
pub(super) const FULL_LIGHT: f64 = 0.5;

pub(super) struct LitMesh {
    pub(super) mesh: Mesh,
    pub(super) camera: Camera,
    pub(super) light: Light,
    pub(super) size: u32,
}

pub(super) struct Rendering {
    pub(super) lit: Image,
    flat: Image,
    /// Between the normals of pixels and those of their faces.
    pub(super) deviation: NormalDeviation,
    /// The angle in degrees between each corner's normal and that of its face.
    corners: Vec<f64>,
}

impl LitMesh {
    /// A mesh seen from the front, a little from above and from the right.
    pub(super) fn from_corner(mesh: Mesh, light: Degrees, size: u32) -> Result<Self> {
        let field = compute(&mesh, &NormalRecipe::default());
        let camera = camera(&[object(&mesh, &field, chalk())]);
        Ok(Self { light: light_from(&camera, light)?, mesh, camera, size })
    }

    pub(super) fn render(&self, weight: Weight, crease: Crease) -> Result<Rendering> {
        let field = self.normals(weight, crease);
        let picture = |shading, show| {
            let settings = RenderSettings { show, ..settings([self.size; 2], shading) };
            let lights = std::slice::from_ref(&self.light);
            draw(vec![object(&self.mesh, &field, chalk())], lights, self.camera, settings)
        };
        let [smooth, faces] = [Shading::Phong, Shading::Flat].map(|shading| picture(shading, Show::Normals));
        Ok(Rendering {
            lit: picture(Shading::Phong, Show::Shaded)?,
            flat: picture(Shading::Flat, Show::Shaded)?,
            deviation: normal_deviation(&smooth?, &faces?)?,
            corners: self.angles(&field),
        })
    }

    /// The mean angle between the corners' normals and those of their faces.
    pub(super) fn mean_of_corners(&self, weight: Weight, crease: Crease) -> f64 {
        let angles = self.angles(&self.normals(weight, crease));
        angles.iter().sum::<f64>() / angles.len().max(1) as f64
    }

    /// By the angle alone: marked edges of a file would hide the effect of averaging.
    fn normals(&self, weight: Weight, crease: Crease) -> NormalField {
        let recipe = NormalRecipe { weight, crease, groups: Groups::Ignore, ..NormalRecipe::default() };
        compute(&self.mesh, &recipe)
    }

    fn angles(&self, field: &NormalField) -> Vec<f64> {
        let faces = self.mesh.faces();
        let owners = faces.owners();
        let angle = |(corner, (&vertex, &face)): (usize, (&u32, &u32))| {
            let normal = *field.normals.get(corner, vertex)?;
            Some(Degrees::from(angle_between(normal, field.face_normals[face as usize])).0)
        };
        faces.corners().iter().zip(&owners).enumerate().filter_map(angle).collect()
    }
}

impl Rendering {
    /// The largest angle of a corner's normal to its face, in degrees.
    pub(super) fn largest(&self) -> f64 {
        self.corners.iter().copied().fold(0.0, f64::max)
    }

    /// The share of corners whose normal is farther from their face.
    pub(super) fn share_over(&self, Degrees(limit): Degrees) -> f64 {
        let over = self.corners.iter().filter(|&&angle| angle > limit).count();
        over as f64 / self.corners.len().max(1) as f64
    }

    pub(super) fn middle(&self) -> f64 {
        LinearRgb::from(centre(&self.lit).to_array()).luminance()
    }

    pub(super) fn true_middle(&self) -> f64 {
        LinearRgb::from(centre(&self.flat).to_array()).luminance()
    }

    /// Maps of the angle between normals, and of the error of diffuse light.
    pub(super) fn maps(&self) -> [Image; 2] {
        let size = self.lit.size;
        [
            map(size, &self.deviation.angles, FULL_ANGLE),
            map(size, &differences(&self.lit, &self.flat), FULL_LIGHT),
        ]
    }
}

pub(super) fn run(own: &UserMesh, parameters: &Parameters, mut out: Recorder) -> Result<Outcome> {
    let &Parameters { size, light, weight, crease, .. } = parameters;
    let mesh = LitMesh::from_corner(Normalisation::of(own)?.apply(own.mesh)?, light, size)?;
    let (smooth, sharp) = (mesh.render(weight, Crease::OFF)?, mesh.render(weight, Crease::Angle(crease))?);
    if smooth.lit.coverage.iter().all(|&covered| covered == 0) {
        return Err(not_visible(own, size));
    }
    out.measure("own-share-averaged", "", smooth.share_over(crease), Check::None);
    out.measure("own-share-split", "", sharp.share_over(crease), Check::None);
    out.measure("own-largest-averaged", "°", smooth.largest(), Check::None);
    out.measure("own-largest-split", "°", sharp.largest(), Check::None);
    out.measure("own-mean-averaged", "°", smooth.deviation.mean, Check::None);
    out.measure("own-mean-split", "°", sharp.deviation.mean, Check::None);
    let present = Threshold { value: crease.0, why: out.text("why-crease-angle") };
    let effect = out.effect("own", "°", [smooth.largest(), sharp.largest()], present, 2.0);
    let [angles, light] = smooth.maps();
    out.bad("own", &effect, smooth.lit);
    out.cured("own-split", &effect, sharp.lit);
    out.difference("own-angles", angles, FULL_ANGLE, "°");
    out.difference("own-light", light, FULL_LIGHT, "");
    let (notes, verdict) = (vec![out.text("own-note")], Verdict::Holds(out.text("own-holds")));
    Ok(out.finish_with_notes(notes, verdict, effect))
}
