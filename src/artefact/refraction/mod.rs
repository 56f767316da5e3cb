//! Refraction: a stick in water and a glass ball, against Snell's law in closed form.
//!
//! Rays meet a screen that codes positions as colours: red grows linearly along it, and green is constant. Fresnel's share dims both
//! alike, so their ratio is the position that a ray meets. Two events a path, into the body and out of it, leave out internal
//! reflections.

use super::prelude::*;
use crate::raster::{Scene, TraceSettings, render};
use crate::shade::Optics;
use crate::surface::{Cylinder, Plane};
use std::borrow::Cow;

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Turn, ParameterName::Light],
    // From straight above no depth is seen, and rays that graze the water miss the screen at its bottom.
    ranges: &[(ParameterName::Turn, [1.0, 80.0])],
    defaults: Parameters { turn: Degrees(50.0), ..Parameters::USUAL },
    ..Experiment::new("refraction", &TEXTS, run)
};

/// The refractive indices of water and of glass.
const WATER: f64 = 1.333;
const GLASS: f64 = 1.5;
/// The angles from the vertical at which the depth of water is measured, besides that of the pictures.
const ANGLES: [f64; 3] = [1.0, 20.0, 75.0];
/// The heights of rays above the axis of the ball, in radii.
const HEIGHTS: [f64; 3] = [0.05, 0.3, 0.7];
/// Rounding of positions on the screen, which are colours in single precision.
const ROUNDING: f64 = 2e-4;

fn run(setup: &Setup) -> Result<Outcome> {
    let Parameters { size, turn: view, light, .. } = setup.parameters;
    let share = apparent_depth(view).into();
    let values =
        [("water", WATER.into()), ("glass", GLASS.into()), ("angle", view.0.into()), ("share", share)];
    let mut out = Recorder::new(&TEXTS, &values);
    let mut depths = Vec::new();
    for angle in [view.0].into_iter().chain(ANGLES.into_iter().filter(|&angle| angle != view.0)) {
        out.set("view", angle);
        let depth = Water { ior: WATER }.apparent_depth(Degrees(angle))?;
        out.measure("depth", "", depth, Check::Near(apparent_depth(Degrees(angle)), ROUNDING));
        depths.push([angle, depth]);
    }
    let mut lengths = Vec::new();
    for height in HEIGHTS {
        out.set("height", height);
        let length = Ball { ior: GLASS }.focal_length(height)?;
        // Rounding at the screen, over the slope of the ray.
        out.measure("focus", "R", length, Check::Near(focal_length(height), ROUNDING / height));
        lengths.push([height, length]);
    }
    // A ray at a height of h is off the limit by about h² of it.
    let paraxial = GLASS / (2.0 * (GLASS - 1.0));
    out.measure(
        "paraxial",
        "R",
        lengths[0][1],
        Check::Near(paraxial, HEIGHTS[0] * HEIGHTS[0] * paraxial + ROUNDING / HEIGHTS[0]),
    );
    let effect = effect(view, size, &out)?;
    let law = 1.0 / focal_length(HEIGHTS[1]);
    let off = [law, (1.0 / lengths[1][1] - law).abs()];
    let present = Threshold { value: 0.005, why: out.text("why-power") };
    let focus = out.effect("power", "1/R", off, present, 100.0);
    let draw_water = |ior| Water { ior }.picture(view, light, size);
    let draw_ball = |ior| Ball { ior }.picture(light, size);
    out.bad("stick-straight", &effect, draw_water(1.0)?);
    out.cured("stick", &effect, draw_water(WATER)?);
    out.bad("ball-straight", &focus, draw_ball(1.0)?);
    out.cured("ball", &focus, draw_ball(GLASS)?);
    charts(depths, lengths, &mut out);
    Ok(out.finish(Verdict::HoldsOnlyIf(out.text("holds-only-if")), effect))
}

/// The displacement of the stick's lower end in the picture without refraction, and what is left with it, in pixels.
fn effect(view: Degrees, size: u32, out: &Recorder) -> Result<Effect> {
    let law = apparent_depth(view);
    let pixels = Water::pixels_of_depth(view, size);
    let [straight, bent] = [1.0, WATER].map(|ior| Water { ior }.apparent_depth(view));
    let off = [straight?, bent?].map(|depth| (depth - law).abs() * pixels);
    Ok(out.effect("stick", "px", off, Threshold::half_pixel(), 10.0))
}

/// The depth at which a point in water seems to be, as a share of its depth: tan θ′/tan θ with sin θ = n sin θ′.
fn apparent_depth(view: Degrees) -> f64 {
    let angle = Radians::from(view).0;
    libm::tan(libm::asin(libm::sin(angle) / WATER)) / libm::tan(angle)
}

/// The distance from the centre at which a ray at a height h crosses the axis, in radii: h/sin(2(i − r)).
fn focal_length(height: f64) -> f64 {
    height / libm::sin(2.0 * (libm::asin(height) - libm::asin(height / GLASS)))
}

fn charts(depths: Vec<[f64; 2]>, lengths: Vec<[f64; 2]>, out: &mut Recorder) {
    let angles = (1..85).map(f64::from);
    let law = angles.map(|angle| [angle, apparent_depth(Degrees(angle))]).collect();
    let curves = vec![out.curve("measured", Drawn::Points, depths), out.curve("law", Drawn::Guide, law)];
    out.chart("depth-by-angle", [Axis::Linear; 2], curves);
    let heights = (1..95).map(|k| f64::from(k) / 100.0);
    let law = heights.map(|height| [height, focal_length(height)]).collect();
    let curves = vec![out.curve("measured", Drawn::Points, lengths), out.curve("law", Drawn::Guide, law)];
    out.chart("focus-by-height", [Axis::Linear; 2], curves);
}

/// Half the length of the screen.
const SCREEN: f64 = 16.0;
/// The window of pictures.
const WINDOW: f64 = 2.6;
/// The depth of the water.
const DEPTH: f64 = 1.0;

fn body(ior: f64, absorb: [f64; 3]) -> Optics {
    Optics { transmit: LinearRgb::WHITE, ior, absorb: absorb.into(), ..Optics::NONE }
}

/// A surface that has no colour of its own.
fn clear() -> Material {
    shiny([0.0, 0.0], 1.0)
}

/// A square screen in the plane z = 0 whose red codes x.
fn screen() -> (TriangleMesh, Vec<LinearRgb>) {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let places = corners.map(|[x, y]| DVec3::new(x, y, 0.0) * SCREEN);
    let mesh = TriangleMesh::new(&places, vec![[0, 1, 2], [0, 2, 3]], &[DVec3::Z; 4]);
    let colours = corners.map(|[x, _]| LinearRgb::new(0.5 * (x + 1.0), 1.0, 0.0));
    (mesh, colours.to_vec())
}

/// The position on a screen, placed by a transform, that a ray through the middle of a camera's picture meets.
fn met(body: Object, place: DMat4, camera: Camera) -> Result<f64> {
    let (mesh, colours) = screen();
    let screen = Object {
        paint: Paint::Given(Cow::Owned(colours)),
        transform: place,
        ..mesh.object(Material::default())
    };
    let settings = RenderSettings {
        two_sided: false,
        tracing: TraceSettings { depth: 2, ..TraceSettings::default() },
        ..settings([1, 1], Shading::Traced)
    };
    let scene = Scene {
        objects: vec![body, screen],
        lines: Vec::new(),
        lights: Vec::new(),
        camera,
        background: LinearRgb::BLACK,
    };
    let colour = centre(&render(&scene, &settings)?);
    Ok(SCREEN * (2.0 * colour.x / colour.y - 1.0))
}

fn traced(objects: Vec<Object>, lights: &[Light], camera: Camera, size: u32) -> Result<Image> {
    // Light that was reflected four times inside a body is below a step of 8 bits.
    let tracing = TraceSettings { depth: 4, ..TraceSettings::default() };
    let settings = settings([size; 2], Shading::Traced);
    let settings = RenderSettings { two_sided: false, samples: Samples::Four, tracing, ..settings };
    draw(objects, lights, camera, settings)
}

/// Light from behind the viewer, turned to the right by an angle, and ambient light.
fn lights(light: Degrees) -> [Light; 2] {
    [Light::Ambient { colour: LinearRgb::grey(0.35) }, far_light(direction(light) + DVec3::Y)]
}

/// Water with an upper surface at y = 0.
struct Water {
    ior: f64,
}

impl Water {
    /// A camera that looks down at the origin, at an angle from the vertical.
    fn camera(view: Degrees, window: f64) -> Camera {
        let (sine, cosine) = libm::sincos(Radians::from(view).0);
        let towards = DVec3::new(0.0, cosine, sine);
        Camera { eye: towards * 20.0, up: DVec3::new(0.0, sine, -cosine), ..front(window) }
    }

    fn mesh(half: f64) -> Result<Mesh> {
        let corners = box_corners(DVec3::new(2.0 * half, DEPTH + 0.1, 2.0 * half));
        let mut faces = Faces::new();
        BOX_FACES.iter().for_each(|face| faces.push(face));
        build(corners.into_iter().map(|corner| corner - DVec3::Y * 0.5 * (DEPTH + 0.1)).collect(), faces)
    }

    fn object<'a>(&self, mesh: &'a Mesh, normals: &'a NormalField, absorb: [f64; 3]) -> Object<'a> {
        let mut water = object(mesh, normals, clear());
        water.optics = body(self.ior, absorb);
        water.settings.shading = Some(Shading::Flat);
        water
    }

    /// The depth at which a point of the bottom seems to be, as a share of its depth.
    fn apparent_depth(&self, view: Degrees) -> Result<f64> {
        let mesh = Self::mesh(2.0 * SCREEN)?;
        let normals = compute(&mesh, &NormalRecipe::default());
        // Its x along the water away from the viewer, its normal upwards.
        let place = DMat4::from_cols(
            DVec3::NEG_Z.extend(0.0),
            DVec3::NEG_X.extend(0.0),
            DVec3::Y.extend(0.0),
            (DVec3::NEG_Y * DEPTH).extend(1.0),
        );
        let along = met(self.object(&mesh, &normals, [0.0; 3]), place, Self::camera(view, 1e-3))?;
        Ok(along / (DEPTH * libm::tan(Radians::from(view).0)))
    }

    /// The height of a share of 1 of the depth in a picture, in pixels.
    fn pixels_of_depth(view: Degrees, size: u32) -> f64 {
        DEPTH * libm::sin(Radians::from(view).0) * f64::from(size) / WINDOW
    }

    /// A stick that stands upright in the water.
    fn picture(&self, view: Degrees, light: Degrees, size: u32) -> Result<Image> {
        let mesh = Self::mesh(0.8)?;
        let normals = compute(&mesh, &NormalRecipe::default());
        let stick = Cylinder::new(0.06, 1.7)?;
        let tilted = DMat4::from_translation(DVec3::new(0.05, -0.1, 0.0)) * DMat4::from_rotation_z(-0.5);
        let stick = Object {
            transform: tilted,
            ..Object::new(Shape::Surface(stick.into()), Material::matte(LinearRgb::new(0.6, 0.1, 0.05)))
        };
        let floor = Plane::new(40.0, 40.0)?;
        let below = DMat4::from_translation(DVec3::NEG_Y * (DEPTH + 0.11))
            * DMat4::from_rotation_x(-0.5 * std::f64::consts::PI);
        let floor = Object {
            transform: below,
            ..Object::new(Shape::Surface(floor.into()), Material::matte(LinearRgb::grey(0.7)))
        };
        let water = self.object(&mesh, &normals, [0.35, 0.1, 0.05]);
        let camera = Camera { target: DVec3::NEG_Y * 0.3, ..Self::camera(view, WINDOW) };
        traced(vec![floor, water, stick], &lights(light), camera, size)
    }
}

/// A ball of radius 1 about the origin, seen from +z.
struct Ball {
    ior: f64,
}

impl Ball {
    fn object(&self) -> Object<'static> {
        let ball = Object::new(Shape::Surface(Sphere::default().into()), clear());
        Object { optics: body(self.ior, [0.0; 3]), ..ball }
    }

    /// The distance from the centre at which a ray at a height above the axis crosses it: of the straight line through its
    /// positions on two screens.
    fn focal_length(&self, height: f64) -> Result<f64> {
        let camera = front(1e-3);
        let camera = Camera { eye: camera.eye + DVec3::X * height, target: DVec3::X * height, ..camera };
        let position =
            |distance: f64| met(self.object(), DMat4::from_translation(DVec3::NEG_Z * distance), camera);
        let [near, far] = [2.0, 6.0];
        let (first, second) = (position(near)?, position(far)?);
        Ok(near + first / (first - second) * (far - near))
    }

    /// The ball before stripes, which it turns upside down.
    fn picture(&self, light: Degrees, size: u32) -> Result<Image> {
        let stripes = (0..8).map(|k| {
            let low = f64::from(k) * 0.5 - 2.0;
            let corners = [[-3.0, low], [3.0, low], [3.0, low + 0.5], [-3.0, low + 0.5]];
            let places = corners.map(|[x, y]| DVec3::new(x, y + 0.3 * x, -4.0));
            TriangleMesh::new(&places, vec![[0, 1, 2], [0, 2, 3]], &[DVec3::Z; 4])
        });
        let stripes: Vec<TriangleMesh> = stripes.collect();
        let colour = |k: usize| {
            if k.is_multiple_of(2) { LinearRgb::new(0.1, 0.2, 0.5) } else { LinearRgb::new(0.8, 0.75, 0.6) }
        };
        let mut objects: Vec<Object> =
            stripes.iter().enumerate().map(|(k, stripe)| stripe.object(Material::matte(colour(k)))).collect();
        objects.push(self.object());
        traced(objects, &lights(light), front(WINDOW), size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_follow_snells_law() {
        for size in [32, 96] {
            let parameters = Parameters { size, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Three quarters from above (1/1.333), and 1.5 radii (n/(2(n − 1))).
            assert!((outcome.measures[1].value - 0.7502).abs() < 1e-3, "{:?}", outcome.measures[1]);
            assert!((outcome.measured("glass ball: focal length in the limit") - 1.5).abs() < 0.01);
            assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)), "{:?}", outcome.verdict);
        }
    }

    /// Figures computed outside this program: 50° in water, and a ray at 0.7 radii through glass of 1.5.
    #[test]
    fn closed_forms_have_their_published_values() {
        assert!((apparent_depth(Degrees(50.0)) - 0.589_23).abs() < 1e-4, "{}", apparent_depth(Degrees(50.0)));
        assert!((focal_length(0.7) - 1.277_79).abs() < 1e-4, "{}", focal_length(0.7));
    }
}
