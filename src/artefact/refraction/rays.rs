//! Water in a box and a ball of glass: rays that meet a screen behind them, and pictures.
//!
//! The screen codes positions as colours: red grows linearly along it, and green is constant. Fresnel's share dims both alike, so
//! their ratio is the position that a ray meets. Two events a path, into the body and out of it, leave out internal reflections.

use super::super::prelude::*;
use crate::raster::{Scene, TraceSettings, render};
use crate::shade::Optics;
use crate::surface::{Cylinder, Plane};
use std::borrow::Cow;

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
pub(super) struct Water {
    pub(super) ior: f64,
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
    pub(super) fn apparent_depth(&self, view: Degrees) -> Result<f64> {
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
    pub(super) fn pixels_of_depth(view: Degrees, size: u32) -> f64 {
        DEPTH * libm::sin(Radians::from(view).0) * f64::from(size) / WINDOW
    }

    /// A stick that stands upright in the water.
    pub(super) fn picture(&self, view: Degrees, light: Degrees, size: u32) -> Result<Image> {
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
pub(super) struct Ball {
    pub(super) ior: f64,
}

impl Ball {
    fn object(&self) -> Object<'static> {
        let ball = Object::new(Shape::Surface(Sphere::default().into()), clear());
        Object { optics: body(self.ior, [0.0; 3]), ..ball }
    }

    /// The distance from the centre at which a ray at a height above the axis crosses it: of the straight line through its
    /// positions on two screens.
    pub(super) fn focal_length(&self, height: f64) -> Result<f64> {
        let camera = front(1e-3);
        let camera = Camera { eye: camera.eye + DVec3::X * height, target: DVec3::X * height, ..camera };
        let position =
            |distance: f64| met(self.object(), DMat4::from_translation(DVec3::NEG_Z * distance), camera);
        let [near, far] = [2.0, 6.0];
        let (first, second) = (position(near)?, position(far)?);
        Ok(near + first / (first - second) * (far - near))
    }

    /// The ball before stripes, which it turns upside down.
    pub(super) fn picture(&self, light: Degrees, size: u32) -> Result<Image> {
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
