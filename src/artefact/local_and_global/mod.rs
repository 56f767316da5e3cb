//! One scene under Phong's local model and traced: what ambient light replaces, and where both differ.

use super::prelude::*;
use crate::raster::{Scene, TraceSettings, render};
use crate::shade::{Optics, Reflectance};
use crate::surface::Plane;
use std::f64::consts::FRAC_PI_2;

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Light],
    // Higher lamps hide the shadow under the ball, and lower ones throw it out of the picture.
    ranges: &[(ParameterName::Light, [10.0, 80.0])],
    defaults: Parameters { light: Degrees(50.0), ..Parameters::USUAL },
    ..Experiment::new("local-and-global", &TEXTS, run)
};

/// The largest difference that maps show.
const FULL: f64 = 0.6;
/// Reflections and refractions along a path: of the cure, and of the picture that is taken as the true one.
const DEPTHS: [u32; 2] = [8, 24];

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, light, .. } = setup.parameters;
    let mut out = Recorder::new(&TEXTS, &[("full", FULL.into()), ("ambient", AMBIENT.into())]);
    let [room, dark] = [AMBIENT, 0.0].map(|ambient| Room { ambient, towards: towards(light) });
    measure_points(&room, &dark, &mut out)?;
    let local = room.picture(size, Shading::Phong, DEPTHS[0])?;
    let [traced, truth] = DEPTHS.map(|depth| room.picture(size, Shading::Traced, depth));
    let (traced, truth) = (traced?, truth?);
    let [dark, lit] = [dark, room].map(|room| room.picture(size, Shading::Traced, DEPTHS[0]));
    let (dark, lit) = (dark?, lit?);
    measure_regions(&local, &truth, &mut out);
    let rms = |image: &Image| errors(image, &truth).map(|[_, rms]| rms);
    let effect = out.effect("global", "", [rms(&local)?, rms(&traced)?], Threshold::half_step(), 100.0);
    let of_ambient = out.effect("ambient", "", [rms(&dark)?, rms(&lit)?], Threshold::half_step(), 100.0);
    let difference = map([size; 2], &differences(&local, &truth), FULL);
    out.bad("local", &effect, local);
    out.cured("traced", &effect, traced);
    out.difference("difference", difference, FULL, "");
    out.bad("dark", &of_ambient, dark);
    out.cured("lit", &of_ambient, lit);
    Ok(out.finish(Verdict::Fails(out.text("fails")), effect))
}

/// The light at points with a closed form: in the shadow, next to it, and in the mirror.
fn measure_points(room: &Room, dark: &Room, out: &mut Recorder) -> Result<()> {
    // Products of a few numbers in single precision.
    const ROUNDING: f64 = 1e-5;
    let [of_shadow, of_light] = [room.shadow(), room.light()];
    for (name, shading, law) in
        [("shadow-local", Shading::Phong, of_light), ("shadow-traced", Shading::Traced, of_shadow)]
    {
        out.measure(name, "", room.floor_in_shadow(shading)?, Check::Near(law, ROUNDING));
    }
    out.measure("shadow-dark", "", dark.floor_in_shadow(Shading::Traced)?, Check::AtMost(ROUNDING));
    out.measure("mirror-local", "", room.mirrored_floor(Shading::Phong)?, Check::AtMost(ROUNDING));
    let mirrored = room.mirrored_floor(Shading::Traced)?;
    out.measure("mirror-traced", "", mirrored, Check::Near(REFLECT * of_light, ROUNDING));
    Ok(())
}

/// The share of the squared difference on each object, and the largest difference elsewhere: where light comes straight from
/// the lamp, both pictures are alike.
fn measure_regions(local: &Image, traced: &Image, out: &mut Recorder) {
    let numbers = local.objects.as_deref().unwrap_or_default();
    let off = differences(local, traced);
    let squared = |is_counted: &dyn Fn(u32) -> bool| -> f64 {
        let here = off.iter().zip(numbers).filter(|(_, number)| is_counted(**number));
        here.filter_map(|(off, _)| off.map(|off| off * off)).sum()
    };
    let share = |squares: f64, all: f64| if all > 0.0 { 100.0 * squares / all } else { 0.0 };
    let all = squared(&|_| true);
    let regions = [("share-shadow", FLOOR), ("share-mirror", MIRROR), ("share-glass", GLASS)];
    for (name, object) in regions {
        let here = squared(&|number| number == Image::number_of(object, 1));
        out.measure(name, "%", share(here, all), Check::None);
    }
    let is_elsewhere = |number: u32| regions.iter().all(|(_, object)| number != Image::number_of(*object, 1));
    out.measure("share-elsewhere", "%", share(squared(&is_elsewhere), all), Check::AtMost(1e-3));
    // The lit side of the ball may lie in no shadow, and its dark side has none of the lamp's light anyway.
    let of_ball = off.iter().zip(numbers).filter(|(_, number)| **number == Image::number_of(BALL, 1));
    let largest = of_ball.filter_map(|(off, _)| *off).fold(0.0, f64::max);
    out.measure("ball", "", largest, Check::AtMost(0.5 / 255.0));
}

/// Ambient light.
const AMBIENT: f64 = 0.25;
/// The share of light that the mirror reflects.
const REFLECT: f64 = 0.8;
/// The numbers of the objects.
const FLOOR: usize = 0;
const BALL: usize = 1;
const MIRROR: usize = 2;
const GLASS: usize = 3;

/// The lamp's light, and the colour of the floor, which reflects both kinds of light alike.
const LAMP: f64 = 0.75;
const COLOUR: f64 = 0.8;
/// The centre of the ball.
const CENTRE: DVec3 = DVec3::new(-0.9, 0.6, 0.0);
const RADIUS: f64 = 0.6;

/// The direction to the lamp, at an angle from the vertical: from the left, above, in front.
fn towards(light: Degrees) -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(light).0);
    sine * DVec3::new(-0.8, 0.0, 0.5).normalize() + cosine * DVec3::Y
}

/// A floor, a ball, a mirror and a glass ball under a distant lamp and ambient light.
struct Room {
    ambient: f64,
    /// The direction to the lamp.
    towards: DVec3,
}

impl Room {
    /// The light from the floor where the lamp does not reach it.
    fn shadow(&self) -> f64 {
        COLOUR * self.ambient
    }

    /// The light from the floor where the lamp reaches it: also in the shadow under a local model.
    fn light(&self) -> f64 {
        self.shadow() + COLOUR * LAMP * self.towards.y
    }

    /// The floor in the middle of the ball's shadow. The view from the side of the shadow, 6° above the floor, passes under the ball
    /// and under the mirror.
    fn floor_in_shadow(&self, shading: Shading) -> Result<f64> {
        let at = CENTRE - self.towards * (CENTRE.y / self.towards.y);
        let eye = at + DVec3::new(0.5, 0.0, 0.8).normalize() + 0.1 * DVec3::Y;
        self.seen(Camera { eye, target: at, up: DVec3::Y, ..front(1e-3) }, shading)
    }

    /// A point of the mirror that shows a lit part of the floor.
    fn mirrored_floor(&self, shading: Shading) -> Result<f64> {
        let target = DVec3::new(1.4, 0.6, -1.5);
        let eye = target + DVec3::new(0.0, 6.0, 10.0);
        self.seen(Camera { eye, target, ..front(1e-3) }, shading)
    }

    fn seen(&self, camera: Camera, shading: Shading) -> Result<f64> {
        let settings = RenderSettings { two_sided: false, ..settings([1, 1], shading) };
        Ok(centre(&self.render(camera, settings)?).x)
    }

    /// The whole scene with at most so many reflections and refractions along a path, and the object of each pixel.
    fn picture(&self, size: u32, shading: Shading, depth: u32) -> Result<Image> {
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
            Light::Directional { towards: self.towards, colour: LinearRgb::grey(LAMP) },
        ];
        let scene = Scene { objects, lines: Vec::new(), lights, camera, background: BACKGROUND };
        Ok(render(&scene, &settings)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shadows_mirror_and_glass_are_all_that_differs() {
        for size in [64, 128] {
            let parameters = Parameters { size, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            for name in [
                "squared differences in the shadow",
                "squared differences in the mirror",
                "squared differences in the glass",
            ] {
                assert!(outcome.measured(name) > 1.0, "{name}: {}", outcome.measured(name));
            }
            assert!(matches!(outcome.verdict, Verdict::Fails(_)), "{:?}", outcome.verdict);
        }
    }
}
