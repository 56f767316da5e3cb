//! Reference pictures that were checked by eye. Other tests compare their content with formulas; these compare every pixel.
//!
//! `CREASE_BLESS=1 cargo test --test suite golden` writes them again; look at each before committing it. A failure
//! leaves the expected picture, the one that came, and their difference in `target/golden`.

use super::{bytes, gear, with};
use crease::mesh::{Mesh, Weld};
use crease::normals::{NormalRecipe, When, compute};
use crease::num::{Degrees, LinearRgb, Transfer};
use crease::raster::{
    Camera, Interpolation, Object, ObjectSettings, Paint, Projection, RenderSettings, Samples, Scene,
    Shading, Shape, render,
};
use crease::report::{Panel, encode_png, panels};
use crease::shade::{AreaShape, Attenuation, Cone, Light, Material, Optics};
use crease::surface::{Pattern, Plane, Primitive, Sphere, Surface, Tessellation};
use glam::{DMat4, DVec3};
use image::RgbImage;
use std::fs;
use std::path::PathBuf;

/// Asserts that a PNG file is the one of this name in `tests/golden`.
fn hold(name: &str, got: &[u8]) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let expected_path = root.join("tests/golden").join(name).with_extension("png");
    let expected = fs::read(&expected_path).ok();
    let decode = |file: &[u8]| image::load_from_memory(file).unwrap().into_rgb8();
    let got_picture = decode(got);
    let expected_picture = expected.as_deref().map(decode);
    if expected_picture.as_ref() == Some(&got_picture) {
        return;
    }
    if std::env::var_os("CREASE_BLESS").is_some_and(|value| value == "1") {
        fs::create_dir_all(expected_path.parent().unwrap()).unwrap();
        fs::write(&expected_path, got).unwrap();
        println!("{} is written: look at it", expected_path.display());
        return;
    }
    let folder = root.join("target/golden");
    fs::create_dir_all(&folder).unwrap();
    let put =
        |what: &str, picture: &RgbImage| picture.save(folder.join(format!("{name}-{what}.png"))).unwrap();
    put("got", &got_picture);
    let Some(expected) = expected_picture else { panic!("{name} is new: CREASE_BLESS=1 writes it") };
    put("expected", &expected);
    if expected.dimensions() == got_picture.dimensions() {
        put("difference", &difference(&expected, &got_picture));
    }
    panic!("{name} differs: see {}", folder.display());
}

/// Black where two pictures agree, and at least grey where they do not, however little.
fn difference(a: &RgbImage, b: &RgbImage) -> RgbImage {
    RgbImage::from_fn(a.width(), a.height(), |x, y| {
        let (a, b) = (a.get_pixel(x, y).0, b.get_pixel(x, y).0);
        let apart = |k: usize| match a[k].abs_diff(b[k]) {
            0 => 0,
            d => 127 + d / 2,
        };
        image::Rgb([0, 1, 2].map(apart))
    })
}

/// Every shading under every interpolation and one light: nine panels for fifteen pictures, for flat faces, edges and exact
/// surfaces do not depend on the interpolation, which drawing the sheet asserts.
///
/// A rough ball on a floor in perspective: faces are few, so that ways of shading differ where one can see it.
struct Stage {
    ball: Mesh,
    floor: Mesh,
}

const FLOOR: DVec3 = DVec3::new(0.0, -1.0, 0.0);

impl Stage {
    fn new() -> Self {
        let quads = |surface: Surface, segments| {
            let tessellation = Tessellation { pattern: Pattern::Quads, segments, ..Tessellation::default() };
            surface.tessellate(&tessellation).unwrap()
        };
        let floor = Plane::new(5.0, 5.0).unwrap();
        Self { ball: quads(Sphere::default().into(), [12, 7]), floor: quads(floor.into(), [2, 2]) }
    }

    fn sheet(&self, lights: &[Light]) -> Vec<u8> {
        let recipe = NormalRecipe { weld: Weld::Off, ..NormalRecipe::default() };
        let normals = |mesh: &Mesh| compute(mesh, &recipe).selected(mesh, When::Missing);
        let (ball_normals, floor_normals) = (normals(&self.ball), normals(&self.floor));
        let object = |mesh, normals, transform, material, surface: Primitive| Object {
            settings: ObjectSettings::default(),
            shape: Shape::Mesh { mesh, normals },
            transform,
            paint: Paint::Lit(material),
            surface: Some(surface),
            optics: Optics::NONE,
        };
        let lying = DMat4::from_translation(FLOOR)
            * DMat4::from_cols_array(&[1., 0., 0., 0., 0., 0., -1., 0., 0., 1., 0., 0., 0., 0., 0., 1.]);
        let orange = Material::plastic(LinearRgb::new(0.9, 0.35, 0.08));
        let grey = Material::matte(LinearRgb::grey(0.7));
        let floor = Primitive::from(Plane::new(5.0, 5.0).unwrap());
        let scene = Scene {
            objects: vec![
                object(&self.ball, &ball_normals, DMat4::IDENTITY, orange, Sphere::default().into()),
                object(&self.floor, &floor_normals, lying, grey, floor),
            ],
            lines: Vec::new(),
            lights: lights.to_vec(),
            camera: Camera {
                eye: DVec3::new(1.2, 2.0, 4.2),
                target: DVec3::new(0.0, -0.35, 0.0),
                up: DVec3::Y,
                projection: Projection::Perspective(Degrees(38.0).into()),
                near: 0.1,
            },
            background: LinearRgb::new(0.02, 0.03, 0.05),
        };
        let plain = RenderSettings { size: [120, 96], samples: Samples::Four, ..RenderSettings::default() };
        let drawn = |caption: &str, shading, interpolation| {
            let image = render(&scene, &RenderSettings { shading, interpolation, ..plain }).unwrap();
            Panel { caption: caption.into(), picture: image.into() }
        };
        let ways = [
            ("scanline", Interpolation::Scanline),
            ("affine", Interpolation::Affine),
            ("perspective", Interpolation::Perspective),
        ];
        let both = [("Gouraud", Shading::Gouraud), ("Phong", Shading::Phong)];
        let mut sheet: Vec<Panel> = both
            .iter()
            .flat_map(|(name, shading)| {
                ways.iter()
                    .map(move |(way, interpolation)| (format!("{name}, {way}"), *shading, *interpolation))
            })
            .map(|(caption, shading, interpolation)| drawn(&caption, shading, interpolation))
            .collect();
        for (caption, shading) in
            [("flat", Shading::Flat), ("wireframe", Shading::Wireframe), ("exact", Shading::Exact)]
        {
            // One picture for all three methods: where nothing is interpolated, they are the same to the bit.
            let [first, others @ ..] = ways.map(|(_, interpolation)| drawn(caption, shading, interpolation));
            for (other, (way, _)) in others.iter().zip(&ways[1..]) {
                assert!(other.picture == first.picture, "{caption}, {way}, is not {caption}, {}", ways[0].0);
            }
            sheet.push(first);
        }
        encode_png(&panels(&sheet).unwrap(), None, Transfer::Srgb).unwrap()
    }
}

const AMBIENT: Light = Light::Ambient { colour: LinearRgb::grey(0.4) };

fn shading_under(name: &str, light: Light) {
    hold(name, &Stage::new().sheet(&[AMBIENT, light]));
}

#[test]
fn under_ambient_light_alone() {
    hold("ambient", &Stage::new().sheet(&[Light::Ambient { colour: LinearRgb::WHITE }]));
}

#[test]
fn under_a_directional_light() {
    shading_under(
        "directional",
        Light::Directional { towards: DVec3::new(-0.6, 1.0, 0.9), colour: LinearRgb::WHITE },
    );
}

#[test]
fn under_a_point_light() {
    shading_under(
        "point",
        Light::Point {
            position: DVec3::new(-1.3, 1.2, 1.2),
            colour: LinearRgb::grey(3.0),
            attenuation: Attenuation::InverseSquare,
        },
    );
}

#[test]
fn under_a_spot() {
    let cone = Cone {
        axis: DVec3::new(0.55, -1.0, -0.4),
        cut_off: Degrees(28.0).into(),
        soft_edge: Degrees(6.0).into(),
        exponent: 1.0,
    };
    shading_under(
        "spot",
        Light::Spot {
            position: DVec3::new(-1.6, 3.0, 1.6),
            colour: LinearRgb::grey(1.2),
            attenuation: Attenuation::None,
            cone,
        },
    );
}

#[test]
fn under_a_rectangle() {
    let shape = AreaShape::Rectangle { centre: DVec3::new(0.0, 2.2, 0.6), u: DVec3::X, v: DVec3::Z * 0.5 };
    shading_under("rectangle", Light::Area { shape, colour: LinearRgb::grey(4.0) });
}

#[test]
fn under_a_disc() {
    let shape = AreaShape::Disc {
        centre: DVec3::new(-2.0, 1.0, 1.5),
        normal: DVec3::new(2.0, -1.0, -1.5),
        radius: 0.8,
    };
    shading_under("disc", Light::Area { shape, colour: LinearRgb::grey(4.0) });
}

/// Through the program: overlays, what can be shown, panels.
#[test]
fn overlays() {
    let [input, ..] = gear();
    let plain = with(&[input.as_str()], &["--size", "320x240", "--samples", "8", "--background", "0.05"]);
    for (name, lines) in [("edges", "wire,creases"), ("normals", "vertex-normals,face-normals")] {
        hold(&format!("overlay-{name}"), &bytes(&with(&plain, &["--overlay", lines])));
    }
}

#[test]
fn creases_and_normals_of_a_few_faces() {
    let input = crate::cli::path(crate::cli::data("polygons.obj"));
    let sheet = with(
        &[input.as_str()],
        &["--size", "320x240", "--samples", "8", "--background", "black", "--overlay"],
    );
    hold("creases", &bytes(&with(&sheet, &["creases,vertex-normals"])));
}

#[test]
fn what_can_be_shown() {
    for show in ["normals", "facing", "depth", "face-id", "deviation"] {
        let [input, ..] = gear();
        let shown = if show == "deviation" { "deviation=15" } else { show };
        let args = [input.as_str(), "--size", "160x120", "--show", shown, "--rotate", "0,-20,0"];
        hold(&format!("show-{show}"), &bytes(&with(&args, &["--background", "black", "--no-legend"])));
    }
}

#[test]
fn labelled_panels() {
    let [input, ..] = gear();
    let args = [input.as_str(), "--size", "160x120", "--compare", "flat,gouraud,phong,wireframe"];
    hold("panels", &bytes(&with(&args, &["--background", "black"])));
}

#[test]
fn differences_are_seen() {
    let mut a = RgbImage::new(2, 1);
    let b = a.clone();
    a.get_pixel_mut(1, 0).0 = [0, 1, 255];
    assert_eq!(difference(&a, &b).into_raw(), [0, 0, 0, 0, 127, 254]);
}
