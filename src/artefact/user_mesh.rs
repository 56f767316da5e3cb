//! A user's mesh as the input of an experiment.

use super::drawing::front;
use super::error::{ArtefactError, Result};
use super::parameters::UserMesh;
use crate::mesh::{Mesh, MeshBuilder, Positions};
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
pub(super) fn light_from(camera: &Camera, Degrees(angle): Degrees) -> Result<Light> {
    let [right, _, forward] = camera.axes().map_err(RenderError::from)?;
    let (sine, cosine) = libm::sincos(Radians::from(Degrees(angle)).0);
    Ok(Light::Directional { towards: right * sine - forward * cosine, colour: LinearRgb::WHITE })
}

/// That a picture of so many pixels shows nothing of a mesh.
pub(super) fn not_visible(own: &UserMesh, size: u32) -> ArtefactError {
    let values = [("mesh", own.name.into()), ("size", size.to_string().into())];
    ArtefactError::request("not-visible", &values)
}

/// The bounding box of a mesh, which is moved to the origin and scaled to a width of 2: single precision suffices there.
pub(super) struct Normalisation {
    centre: DVec3,
    half: f64,
}

impl Normalisation {
    pub(super) fn of(own: &UserMesh) -> Result<Self> {
        let no_extent = |name: &str| ArtefactError::request("no-extent", &[("mesh", name.into())]);
        let of = |name, mesh: &Mesh| {
            let (low, high) =
                mesh.bounds().filter(|_| mesh.face_count() > 0).ok_or_else(|| no_extent(name))?;
            let room = Self { centre: low * 0.5 + high * 0.5, half: (high * 0.5 - low * 0.5).max_element() };
            if room.half > 0.0 { Ok(room) } else { Err(no_extent(name)) }
        };
        let room = of(own.name, own.mesh)?;
        let Some((name, finer)) = own.finer else { return Ok(room) };
        let other = of(name, finer)?;
        if room.is_like(&other) {
            return Ok(other);
        }
        let values = [("finer", name.into()), ("mesh", own.name.into())];
        Err(ArtefactError::request("not-alike", &values))
    }

    fn is_like(&self, other: &Self) -> bool {
        let distance = (self.centre - other.centre).abs().max_element();
        distance <= 0.25 * other.half && (self.half / other.half - 1.0).abs() <= 0.25
    }

    pub(super) fn apply(&self, mesh: &Mesh) -> Result<Mesh> {
        let positions = mesh.positions().iter().map(|place| (place - self.centre) / self.half).collect();
        let builder = MeshBuilder {
            positions: Positions::rounded(positions, mesh.storage()),
            faces: mesh.faces().clone(),
            columns: mesh.columns().clone(),
        };
        Ok(builder.build()?)
    }
}
