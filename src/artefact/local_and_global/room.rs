//! A floor, a ball, a mirror and a glass ball under a distant lamp and ambient light.

use super::super::prelude::*;
use crate::raster::{Scene, TraceSettings, render};
use crate::shade::{Optics, Reflectance};
use crate::surface::Plane;
use std::f64::consts::FRAC_PI_2;

/// Ambient light.
pub(super) const AMBIENT: f64 = 0.25;
/// The share of light that the mirror reflects.
pub(super) const REFLECT: f64 = 0.8;
/// The numbers of the objects.
pub(super) const FLOOR: usize = 0;
pub(super) const BALL: usize = 1;
pub(super) const MIRROR: usize = 2;
pub(super) const GLASS: usize = 3;

/// The lamp's light, and the colour of the floor, which reflects both kinds of light alike.
const LAMP: f64 = 0.75;
const COLOUR: f64 = 0.8;
/// The direction to the lamp: from the left, above, in front.
const TOWARDS: DVec3 = DVec3::new(-0.8, 0.8, 0.5);
/// The centre of the ball.
const CENTRE: DVec3 = DVec3::new(-0.9, 0.6, 0.0);
const RADIUS: f64 = 0.6;

pub(super) struct Room {
    pub(super) ambient: f64,
}

impl Room {
    /// The light from the floor where the lamp does not reach it.
    pub(super) fn shadow(&self) -> f64 {
        COLOUR * self.ambient
    }

    /// The light from the floor where the lamp reaches it: also in the shadow under a local model.
    pub(super) fn light(&self) -> f64 {
        self.shadow() + COLOUR * LAMP * TOWARDS.normalize().y
    }

    /// The floor in the middle of the ball's shadow, seen from straight above.
    pub(super) fn floor_in_shadow(&self, shading: Shading) -> Result<f64> {
        let at = CENTRE - TOWARDS * (CENTRE.y / TOWARDS.y);
        let eye = at + DVec3::Y * 20.0;
        self.seen(Camera { eye, target: at, up: DVec3::NEG_Z, ..front(1e-3) }, shading)
    }

    /// A point of the mirror that shows a lit part of the floor.
    pub(super) fn mirrored_floor(&self, shading: Shading) -> Result<f64> {
        let target = DVec3::new(1.4, 0.6, -1.5);
        let eye = target + DVec3::new(0.0, 6.0, 10.0);
        self.seen(Camera { eye, target, ..front(1e-3) }, shading)
    }

    fn seen(&self, camera: Camera, shading: Shading) -> Result<f64> {
        let settings = RenderSettings { two_sided: false, ..settings([1, 1], shading) };
        Ok(centre(&self.render(camera, settings)?).x)
    }

    /// The whole scene with at most so many reflections and refractions along a path, and the object of each pixel.
    pub(super) fn picture(&self, size: u32, shading: Shading, depth: u32) -> Result<Image> {
        let camera = Camera {
            eye: DVec3::new(0.4, 2.6, 7.0),
            target: DVec3::new(0.0, 0.55, 0.0),
            up: DVec3::Y,
            projection: Projection::Perspective(Radians::from(Degrees(32.0))),
            near: 0.1,
        };
        let tracing = TraceSettings { depth, weight: 0.0, ..TraceSettings::default() };
        let settings =
            RenderSettings { two_sided: false, keep_objects: true, tracing, ..settings([size; 2], shading) };
        self.render(camera, settings)
    }

    fn render(&self, camera: Camera, settings: RenderSettings) -> Result<Image> {
        let matte = |colour: LinearRgb| Material {
            ambient: Reflectance::Merged(colour),
            diffuse: Reflectance::Merged(colour),
            ..Material::matte(colour)
        };
        let clear = || matte(LinearRgb::BLACK);
        let surface = |surface: Primitive, transform: DMat4, material: Material| Object {
            transform,
            ..Object::new(Shape::Surface(surface), material)
        };
        let ball = |centre: DVec3, radius: f64| -> Result<(Primitive, DMat4)> {
            Ok((Sphere::new(radius)?.into(), DMat4::from_translation(centre)))
        };
        let floor = Plane::new(200.0, 200.0)?;
        let mirror = Plane::new(4.4, 2.4)?;
        let (opaque, opaque_at) = ball(CENTRE, RADIUS)?;
        let (glass, glass_at) = ball(DVec3::new(0.75, 0.5, 1.3), 0.5)?;
        let mut objects = vec![
            surface(floor.into(), DMat4::from_rotation_x(-FRAC_PI_2), matte(LinearRgb::grey(COLOUR))),
            surface(opaque, opaque_at, matte(LinearRgb::new(0.7, 0.25, 0.1))),
            surface(mirror.into(), DMat4::from_translation(DVec3::new(0.0, 1.25, -1.5)), clear()),
            surface(glass, glass_at, clear()),
        ];
        objects[MIRROR].optics = Optics { reflect: LinearRgb::grey(REFLECT), ..Optics::NONE };
        objects[GLASS].optics = Optics { transmit: LinearRgb::WHITE, ior: 1.5, ..Optics::NONE };
        let lights = vec![
            Light::Ambient { colour: LinearRgb::grey(self.ambient) },
            Light::Directional { towards: TOWARDS, colour: LinearRgb::grey(LAMP) },
        ];
        let scene = Scene { objects, lines: Vec::new(), lights, camera, background: BACKGROUND };
        Ok(render(&scene, &settings)?)
    }
}
