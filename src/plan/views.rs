//! Views of the reference: cameras around a scene, with lights that turn.

use super::axes::ObjectModel;
use super::compare::Truth;
use super::stage::{PlanError, Stage};
use crate::mesh::NONE;
use crate::num::Degrees;
use crate::raster::{Camera, Image};
use crate::shade::{AreaShape, Cone, Light};
use glam::{DQuat, DVec3, dvec3};
use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;

/// A view of the reference.
pub struct View {
    /// The camera.
    pub camera: Camera,
    /// The lights as declared, turned.
    pub lights: Vec<Light>,
    /// How all lights turn.
    pub turn: Turn,
    /// The picture of the reference.
    pub truth: Truth,
    /// Pixels that something covers.
    pub covered: u64,
    /// The number of the object that all samples of a pixel show; [`NONE`] for others.
    pub object_of: Vec<u32>,
    /// Pixels that show only a unit.
    pub pixels: Vec<u64>,
    /// Whether rear faces of a unit may be seen: then it matters whether it is lit on both sides.
    pub shows_rear: Vec<bool>,
    /// The picture of each unit alone, for its outline; drawn where it is needed.
    pub alone: Vec<RefCell<Option<Image>>>,
}

impl View {
    /// Draws the reference from a camera.
    ///
    /// # Errors
    /// What makes the picture impossible.
    pub fn new(stage: &Stage, camera: Camera, lights: &[Light], turn: Turn) -> Result<Self, PlanError> {
        let lights: Vec<Light> = lights.iter().map(|light| turn.of(light)).collect();
        let models: Vec<_> = stage.units.iter().map(|unit| unit.reference).enumerate().collect();
        let image = stage.draw(&models, &lights, &camera)?;
        let covered = image.statistics.covered_pixels;
        let samples_of_pixel = stage.settings.samples.count();
        let objects: HashMap<u32, u32> = (0..stage.objects() as u32)
            .map(|object| (Image::number_of(object as usize, samples_of_pixel), object))
            .collect();
        let numbers = image.objects.iter().flatten();
        let object_of: Vec<u32> =
            numbers.map(|number| objects.get(number).copied().unwrap_or(NONE)).collect();
        let mut pixels = vec![0; stage.units.len()];
        for &object in object_of.iter().filter(|&&object| object != NONE) {
            pixels[stage.unit_of(object)] += 1;
        }
        let shows_rear = match stage.units.iter().any(|unit| unit.reference.two_sided && !unit.is_cast) {
            true => rear_faces(stage, &models, &camera, &object_of)?,
            false => vec![false; stage.units.len()],
        };
        let alone = stage.units.iter().map(|_| RefCell::default()).collect();
        let truth = Truth::new(image, &stage.settings);
        Ok(Self { camera, lights, turn, truth, covered, object_of, pixels, shows_rear, alone })
    }
}

/// Whether a sample shows a rear face of each unit. Front faces have a quarter as much red as blue in a picture of sides, rear faces some
/// thirty times as much, and the background is black. Pixels of several objects count for all units.
fn rear_faces(
    stage: &Stage,
    models: &[(usize, ObjectModel)],
    camera: &Camera,
    object_of: &[u32],
) -> Result<Vec<bool>, PlanError> {
    let image = stage.sides(models, camera)?;
    let mut shown = vec![false; stage.units.len()];
    for (&[red, _, blue], &object) in image.linear.iter().flatten().zip(object_of) {
        if red > 0.3 * blue {
            match object {
                NONE => shown.fill(true),
                object => shown[stage.unit_of(object)] = true,
            }
        }
    }
    Ok(shown)
}

/// Views at the same distance as a camera on a sphere around its target, evenly spread: Fibonacci's lattice (Á. González, *Measurement of areas
/// on a sphere using Fibonacci and latitude–longitude lattices*, Mathematical Geosciences 42, 2010). `offset` from 0 to 1 moves all of them
/// along the spiral: views between the others have one half.
pub fn around(camera: &Camera, count: u32, offset: f64) -> Vec<Camera> {
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let distance = camera.eye.distance(camera.target);
    let view = |number: u32| {
        let place = f64::from(number) + offset;
        let y = 1.0 - 2.0 * (place + 0.5) / (f64::from(count) + 1.0).max(1.0);
        let (ring, angle) = ((1.0 - y * y).max(0.0).sqrt(), golden * place);
        let towards = dvec3(ring * libm::cos(angle), y, ring * libm::sin(angle));
        let up = if y.abs() > 0.99 { DVec3::X } else { DVec3::Y };
        Camera { eye: camera.target + towards * distance, up, ..*camera }
    };
    (0..count).map(view).collect()
}

/// Where a view is, so that it can be found again.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Place {
    /// The position of the camera.
    pub eye: [f64; 3],
    /// The point that it faces.
    pub target: [f64; 3],
    /// How all lights turn around the middle of the scene; `None` if they stay.
    pub turn: Option<TurnOfLights>,
}

/// A rotation of all lights.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct TurnOfLights {
    /// Its axis, a unit vector.
    pub axis: [f64; 3],
    /// Its angle.
    pub degrees: f64,
}

impl View {
    /// Where it is.
    pub fn place(&self) -> Place {
        let rotation = self.turn.rotation;
        let sine = rotation.xyz().length();
        let turn = (sine > 0.0).then(|| TurnOfLights {
            axis: (rotation.xyz() / sine).to_array(),
            degrees: 2.0 * libm::atan2(sine, rotation.w).to_degrees(),
        });
        Place { eye: self.camera.eye.to_array(), target: self.camera.target.to_array(), turn }
    }
}

/// A rotation of all lights around a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    rotation: DQuat,
    middle: DVec3,
}

impl Turn {
    /// No rotation, then if `cone` is above 0 rotations by this angle and by half of it around the coordinate axes, in both directions: each
    /// direction of light moves towards four others or more.
    pub fn sampled(cone: Degrees, middle: DVec3) -> Vec<Self> {
        let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
        let none = Self { rotation: DQuat::IDENTITY, middle };
        [none].into_iter().chain(Self::around_axes(&axes, cone, middle)).collect()
    }

    /// Rotations between the sampled ones, around the diagonals of a cube.
    pub fn held_out(cone: Degrees, middle: DVec3) -> Vec<Self> {
        let signs = (0..8).map(|bits| [1, 2, 4].map(|bit| if bits & bit == 0 { 1.0 } else { -1.0 }));
        let axes: Vec<DVec3> = signs.map(|sign| DVec3::from(sign).normalize()).collect();
        Self::around_axes(&axes, cone, middle)
    }

    fn around_axes(axes: &[DVec3], Degrees(cone): Degrees, middle: DVec3) -> Vec<Self> {
        let angles: &[f64] = if cone > 0.0 { &[1.0, 0.5] } else { &[] };
        let turns = angles.iter().flat_map(|share| {
            let (sin, cos) = libm::sincos(0.5 * share * cone.to_radians());
            let rotation = move |&axis: &DVec3| DQuat::from_vec4((sin * axis).extend(cos));
            axes.iter().map(move |axis| Self { rotation: rotation(axis), middle })
        });
        turns.collect()
    }

    /// A light, turned.
    pub fn of(&self, light: &Light) -> Light {
        if self.rotation == DQuat::IDENTITY {
            return *light;
        }
        let turned = |direction: DVec3| self.rotation * direction;
        let moved = |position: DVec3| self.middle + self.rotation * (position - self.middle);
        match *light {
            Light::Ambient { .. } => *light,
            Light::Directional { towards, colour } => Light::Directional { towards: turned(towards), colour },
            Light::Point { position, colour, attenuation } => {
                Light::Point { position: moved(position), colour, attenuation }
            }
            Light::Spot { position, colour, attenuation, cone } => {
                let cone = Cone { axis: turned(cone.axis), ..cone };
                Light::Spot { position: moved(position), colour, attenuation, cone }
            }
            Light::Area { shape, colour } => {
                let shape = match shape {
                    AreaShape::Rectangle { centre, u, v } => {
                        AreaShape::Rectangle { centre: moved(centre), u: turned(u), v: turned(v) }
                    }
                    AreaShape::Disc { centre, normal, radius } => {
                        AreaShape::Disc { centre: moved(centre), normal: turned(normal), radius }
                    }
                };
                Light::Area { shape, colour }
            }
        }
    }
}
