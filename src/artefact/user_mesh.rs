//! A user's mesh as the input of an experiment.

use super::drawing::front;
use super::error::ArtefactError;
use super::parameters::UserMesh;
use crate::mesh::{Mesh, MeshBuilder};
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Camera, Object, RenderError, Scene};
use crate::shade::Light;
use glam::DVec3;

/// A camera that shows all of some objects, from the front, a little from above and from the right.
pub(super) fn camera(objects: &[Object]) -> Camera {
    let objects = objects.to_vec();
    let (lines, lights, camera) = (Vec::new(), Vec::new(), front(2.0));
    let scene = Scene { objects, lines, lights, camera, background: LinearRgb::BLACK };
    scene.framing(1.0).unwrap_or(camera)
}

/// A light from far away, turned from the viewer to the right.
pub(super) fn light_from(camera: &Camera, Degrees(angle): Degrees) -> Result<Light, ArtefactError> {
    let [right, _, forward] = camera.axes().map_err(RenderError::from)?;
    let (sine, cosine) = libm::sincos(Radians::from(Degrees(angle)).0);
    Ok(Light::Directional { towards: right * sine - forward * cosine, colour: LinearRgb::WHITE })
}

/// That a picture of so many pixels shows nothing of a mesh.
pub(super) fn unseen(own: &UserMesh, size: u32) -> ArtefactError {
    ArtefactError::Mesh {
        found: format!("`{}` covers no pixel of a picture of {size} pixels", own.name),
        advice: "give a larger picture (--size), or a mesh whose faces have an area and are not seen from their edge",
    }
}

/// The box of what is looked at, which is moved to the origin and made 2 wide, so that single precision will do for it.
pub(super) struct Normalisation {
    centre: DVec3,
    half: f64,
}

impl Normalisation {
    pub(super) fn of(own: &UserMesh) -> Result<Self, ArtefactError> {
        let unsuitable = |found: String, advice| Err(ArtefactError::Mesh { found, advice });
        let of = |mesh: &Mesh| {
            let (low, high) = mesh.bounds()?;
            let room = Self { centre: low * 0.5 + high * 0.5, half: (high * 0.5 - low * 0.5).max_element() };
            (mesh.face_count() > 0 && room.half > 0.0).then_some(room)
        };
        let Some(room) = of(own.mesh) else {
            return unsuitable(
                format!("`{}` has no faces or no extent", own.name),
                "give a mesh that can be seen",
            );
        };
        let Some((name, finer)) = own.finer else { return Ok(room) };
        match of(finer) {
            Some(other) if room.is_like(&other) => Ok(other),
            Some(_) => unsuitable(
                format!("`{name}` is elsewhere than `{}`, or of another size", own.name),
                "give a finer mesh of the same thing, in the same place",
            ),
            None => unsuitable(format!("`{name}` has no faces or no extent"), "give a mesh that can be seen"),
        }
    }

    /// Whether two are as good as the same.
    fn is_like(&self, other: &Self) -> bool {
        let apart = (self.centre - other.centre).abs().max_element();
        apart <= 0.25 * other.half && (self.half / other.half - 1.0).abs() <= 0.25
    }

    pub(super) fn apply(&self, mesh: &Mesh) -> Result<Mesh, ArtefactError> {
        let positions = mesh.positions().iter().map(|&place| (place - self.centre) / self.half).collect();
        let builder = MeshBuilder {
            positions,
            storage: mesh.storage(),
            faces: mesh.faces().clone(),
            columns: mesh.columns().clone(),
        };
        Ok(builder.build()?)
    }
}
