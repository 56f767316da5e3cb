//! Scenes with extreme or invalid geometry, cameras and lights.

use super::shapes::{Model, icosphere, linear, scene, unit};
use crate::meshes;
use crate::random::Random;
use crease::io::{ReadOptions, read};
use crease::mesh::Faces;
use crease::normals::{NormalRecipe, compute};
use crease::num::{Degrees, LinearRgb};
use crease::raster::{
    Camera, CameraError, Interpolation, LinePath, LineStyle, Lines, Object, Paint, Projection, RenderError,
    RenderSettings, Samples, Scene, Shading, Shape, Show, Triangles, default_lights, probe, render,
};
use crease::shade::{Attenuation, Light, Material};
use crease::surface::{Primitive, Sphere};
use glam::{DMat4, DVec3};

/// Triangles of all sizes and places, slivers, needles, some behind the eye.
fn wild(random: &mut Random, count: usize) -> Model {
    let mut positions = Vec::new();
    for _ in 0..count {
        let exponent = 60.0 * unit(random) - 30.0;
        let size = libm::pow(10.0, exponent);
        let centre = DVec3::new(unit(random), unit(random), unit(random)) * 8.0 - 4.0;
        for _ in 0..3 {
            let away = DVec3::new(unit(random), unit(random), unit(random)) * 2.0 - 1.0;
            let thin = if random.one_in(3) { 1e-9 } else { 1.0 };
            positions.push(centre + away * DVec3::new(size, size * thin, size));
        }
    }
    let faces = Faces::triangles((0..positions.len() as u32).collect());
    Model::new(positions, faces)
}

/// A scene with the default lights and a near viewer, so that V and its distance matter.
fn lit(objects: Vec<Object>) -> Scene {
    let scene = scene(objects);
    Scene { lights: default_lights(&scene.camera).to_vec(), ..scene }
}

/// No panic, and the same picture at each run.
#[test]
fn wild_triangles_are_drawn_or_clipped() {
    let model = wild(&mut Random(31), 3000);
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wireframe] {
        for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective] {
            let settings =
                RenderSettings { shading, interpolation, samples: Samples::Four, ..linear([130, 70]) };
            let [first, second] = [(); 2].map(|()| render(&lit(vec![model.object()]), &settings).unwrap());
            assert!(first.linear == second.linear);
            assert!(first.linear.unwrap().as_flattened().iter().all(|c| c.is_finite()));
            assert!(first.statistics.triangles_clipped > 100 && first.statistics.triangles_culled > 100);
        }
    }
}

/// A triangle from behind the eye to where depths differ by more than a double has digits.
#[test]
fn a_triangle_from_behind_the_eye_to_the_horizon_is_drawn() {
    for far in [1e10, 1e13, 1e14, 1e16, 1e18, 1e25, 1e30] {
        let corners = [DVec3::new(0.75, 1.1, 16.0), DVec3::new(-0.2, -1.9, 0.0), DVec3::new(0.0, 1.0, -far)];
        let model = Model::new(corners.to_vec(), Faces::triangles(vec![0, 1, 2]));
        for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective] {
            let settings = RenderSettings { shading: Shading::Phong, interpolation, ..linear([64, 48]) };
            // A near distance for a view of near objects, not of the horizon.
            let camera = Camera {
                eye: DVec3::new(0.0, 0.0, 6.0),
                target: DVec3::ZERO,
                up: DVec3::Y,
                projection: Projection::Perspective(Degrees(25.0).into()),
                near: 0.006,
            };
            let lights = default_lights(&camera).to_vec();
            let image = render(&Scene { camera, lights, ..scene(vec![model.object()]) }, &settings).unwrap();
            assert!(image.statistics.covered_pixels > 300, "{far:e} {interpolation:?}");
            assert!(image.linear.unwrap().as_flattened().iter().all(|c| c.is_finite()));
        }
    }
}

/// Every pixel that a wild triangle does not take shows what it shows without it.
#[test]
fn wild_triangles_leave_other_pixels_alone() {
    let (mut random, ball) = (Random(7), icosphere(2));
    let (mut taken, mut left) = (0, 0);
    for round in 0..40 {
        let wild = wild(&mut random, 1);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            let settings = RenderSettings { shading, ..linear([96, 64]) };
            let alone = render(&lit(vec![ball.object()]), &settings).unwrap().linear.unwrap();
            let magenta = vec![LinearRgb::new(1.0, 0.0, 1.0); wild.mesh.vertex_count()];
            let given = Object { paint: Paint::Given(magenta.into()), ..wild.object() };
            let marked = render(&lit(vec![ball.object(), given]), &settings).unwrap().linear.unwrap();
            let both = render(&lit(vec![ball.object(), wild.object()]), &settings).unwrap().linear.unwrap();
            for (at, (marked, both)) in marked.iter().zip(&both).enumerate() {
                // Lit plastic is grey, and nothing is black.
                let is_taken = marked[0] > 0.5 && marked[1] == 0.0;
                assert!(
                    is_taken || *marked == alone[at],
                    "round {round}, {shading:?}: pixel {at} is {marked:?}"
                );
                assert!(is_taken || *both == alone[at], "round {round}, {shading:?}: pixel {at} is {both:?}");
                *if is_taken { &mut taken } else { &mut left } += 1;
            }
        }
    }
    assert!(taken > 10_000 && left > 100_000, "{taken} {left}");
}

/// Light does not change where a triangle extends beyond the range of single precision: it is that of its corners, which have the
/// same directions.
#[test]
fn distance_beyond_single_precision_changes_no_light() {
    let draw = |size: f64, shading: Shading| {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, -1.5) * size);
        let plate = Model::polygon(&corners);
        let settings = RenderSettings { shading, ..linear([16, 16]) };
        render(&lit(vec![plate.object()]), &settings).unwrap().linear.unwrap()
    };
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let expected = draw(1e9, shading);
        for size in [1e18, 1e25, 1e30, 1e40, 1e100] {
            for (got, expected) in draw(size, shading).as_flattened().iter().zip(expected.as_flattened()) {
                // The eye is 4 units away: V differs by 4e-9, less than roundings of single precision.
                assert!((got - expected).abs() < 1e-5, "{size:e} {shading:?}: {got}, not {expected}");
            }
        }
    }
}

/// A parallel view of a spot on a face that is larger by any factor: the face covers all of it, and its corners, which are out
/// of the range of fixed-point numbers, nothing else.
#[test]
fn a_view_far_smaller_than_the_face_is_covered() {
    let plate = Model::polygon(
        &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0)),
    );
    // Next to the picture: not visible, however far its corners are.
    let aside = Object { transform: DMat4::from_translation(DVec3::new(5.0, 0.0, 0.0)), ..plate.object() };
    for exponent in -30..=0 {
        let height = libm::pow(10.0, f64::from(exponent));
        let eye = DVec3::new(0.3, 0.2, 1.0);
        let camera = Camera {
            eye,
            target: DVec3 { z: 0.0, ..eye },
            projection: Projection::Orthographic(height),
            near: 0.0,
            ..scene(Vec::new()).camera
        };
        let scene = Scene { camera, ..scene(vec![aside.clone(), plate.object()]) };
        let counts = render(&scene, &linear([40, 30])).unwrap().statistics;
        assert_eq!(counts.covered_pixels, 1200, "{height:e}");
    }
}

/// A floor far wider than the picture: clipped on all sides, and right to the pixel where the horizon is.
#[test]
fn a_floor_of_any_width_is_the_same_floor() {
    let draw = |half: f64| {
        let corners = [[-half, -half], [-half, half], [half, half], [half, -half]];
        let floor = Model::polygon(&corners.map(|[x, z]| DVec3::new(x, -1.0, z)));
        let camera = Camera { target: DVec3::new(0.0, 0.0, -4.0), ..scene(Vec::new()).camera };
        let scene = Scene { camera, ..scene(vec![floor.object()]) };
        render(&scene, &linear([160, 120])).unwrap()
    };
    let expected = draw(1e4);
    // Below the horizon, at half the height, everything is floor; the last row of pixels before it is 0.4 % of the
    // distance wide, so 1e4 units are enough for all but that row.
    assert_eq!(expected.statistics.covered_pixels, 160 * 60);
    for half in [1e6, 1e12, 1e20, 1e30] {
        assert_eq!(draw(half).coverage, expected.coverage, "{half:e}");
    }
}

#[test]
fn bad_scenes_are_distinguished() {
    let model = icosphere(0);
    let good = || scene(vec![model.object()]);
    let fails = |scene: &Scene, settings: &RenderSettings, expected: &str| {
        let message = render(scene, settings).unwrap_err().to_string();
        assert!(message.contains(expected), "{message:?} does not say {expected:?}");
    };
    let settings = linear([16, 16]);
    for size in [[0, 5], [5, 0], [16385, 5], [5, u32::MAX]] {
        fails(&good(), &RenderSettings { size, ..settings }, "each side must be 1 to 16384");
    }
    let with = |change: &dyn Fn(&mut Scene)| {
        let mut scene = good();
        change(&mut scene);
        scene
    };
    fails(&with(&|s| s.camera.target = s.camera.eye), &settings, "same point");
    fails(&with(&|s| s.camera.near = f64::NAN), &settings, "not finite");
    fails(&with(&|s| s.background = LinearRgb::new(0.0, f64::NAN, 0.0)), &settings, "background");
    let flat = DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0));
    fails(&with(&|s| s.objects[0].transform = flat), &settings, "object 0: its transform flattens");
    fails(&with(&|s| s.objects[0].transform = DMat4::NAN), &settings, "object 0: its transform");
    let huge = DMat4::from_scale(DVec3::splat(1e308)) * DMat4::from_translation(DVec3::splat(20.0));
    fails(&with(&|s| s.objects[0].transform = huge), &settings, "object 0");
    let exact = RenderSettings { shading: Shading::Exact, ..settings };
    fails(&good(), &exact, "object 0: exact shading needs an analytic surface");
    fails(
        &with(&|s| s.objects[0].paint = Paint::Given(vec![].into())),
        &settings,
        "0 vertex colours, but 12",
    );
    // An analytic surface has no vertices that could have a colour.
    let ball = || Object::new(Shape::Surface(Sphere::default().into()), Material::default());
    let coloured = Object { paint: Paint::Given(vec![LinearRgb::WHITE; 3].into()), ..ball() };
    fails(
        &scene(vec![ball(), coloured.clone()]),
        &settings,
        "object 1: an analytic surface has no vertex colours",
    );
    let shown = RenderSettings { show: Show::Normals, ..settings };
    assert!(render(&scene(vec![coloured]), &shown).is_ok(), "no colour is asked for");
    let negative = Material { exponent: -2.0, ..Material::default() };
    fails(&with(&|s| s.objects[0].paint = Paint::Lit(negative)), &settings, "exponent");
    let mut thin = settings;
    thin.shading = Shading::Wireframe;
    thin.wire.width = 0.0;
    fails(&good(), &thin, "width of lines");
    let path = LinePath::Points { points: vec![DVec3::X], segments: vec![[0, 1]] };
    let lines = Lines { path, style: LineStyle::default() };
    fails(&with(&|s| s.lines.push(lines.clone())), &settings, "line 0 refers to point 1");
    let triangles = Triangles {
        positions: &[[0.0; 3]],
        triangles: &[[0, 0, 1]],
        normals: &[[0.0; 3]],
        face_normals: &[],
    };
    let slices = scene(vec![Object::new(Shape::Triangles(triangles), Material::default())]);
    fails(&slices, &settings, "triangle 0 refers to point 1, but there are only 1");
    let short = Triangles { triangles: &[[0, 0, 0]], normals: &[], ..triangles };
    let slices = scene(vec![Object::new(Shape::Triangles(short), Material::default())]);
    fails(&slices, &settings, "0 normals, but 1 vertices");
    let not_finite = Triangles { positions: &[[f32::NAN; 3]], triangles: &[[0, 0, 0]], ..triangles };
    let slices = scene(vec![Object::new(Shape::Triangles(not_finite), Material::default())]);
    fails(&slices, &settings, "vertex 0");
    let camera = Camera { eye: DVec3::NAN, ..good().camera };
    assert_eq!(
        render(&with(&|s| s.camera = camera), &settings).unwrap_err(),
        RenderError::Camera(CameraError::NonFinite("eye"))
    );
}

/// A light in the surface itself has no finite colour there, which is an error and not drawn.
#[test]
fn a_colour_that_is_not_finite_is_an_error() {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let plate = Model::polygon(&corners);
    let mut scene = scene(vec![plate.object()]);
    scene.lights = vec![Light::Point {
        position: corners[0],
        colour: LinearRgb::WHITE,
        attenuation: Attenuation::InverseSquare,
    }];
    let settings = RenderSettings { shading: Shading::Gouraud, ..linear([32, 32]) };
    let error = render(&scene, &settings).unwrap_err();
    assert!(matches!(error, RenderError::NotFinite { object: 0, .. }), "{error}");
}

/// A light so near the surface that single precision rounds it to a point of the surface still lights that point: at a vertex, at
/// the middle of a face, and at a sample of a plate and of an analytic surface.
#[test]
fn a_light_closer_than_single_precision_can_tell_is_drawn() {
    let above = |point: DVec3| {
        vec![Light::Point {
            position: point + DVec3::Z * libm::exp2(-30.0),
            colour: LinearRgb::WHITE,
            attenuation: Attenuation::None,
        }]
    };
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let plate = Model::polygon(&corners);
    let ball =
        || Object::new(Shape::Surface(Primitive::from(Sphere::default())), Material::matte(LinearRgb::WHITE));
    let cases = [
        (Shading::Gouraud, plate.object(), corners[0]),
        (Shading::Flat, plate.object(), DVec3::ZERO),
        (Shading::Phong, plate.object(), DVec3::ZERO),
        (Shading::Exact, ball(), DVec3::Z),
    ];
    for (shading, object, point) in cases {
        let scene = Scene { lights: above(point), ..scene(vec![object]) };
        // A sample is exactly in the middle.
        let settings = RenderSettings { shading, ..linear([33, 33]) };
        let image = render(&scene, &settings).unwrap().linear.unwrap();
        let mut brightest = 0.0_f64;
        for (index, colour) in (0..).zip(&image) {
            let Some(seen) = probe(&scene, &settings, [index % 33, index / 33], 0).unwrap() else { continue };
            let truth = seen.colour();
            // Corners are snapped to 1/256 pixel, so weights on edges of 11 pixels differ by up to 1/2800. That is within half an
            // 8-bit step; a missed light is not.
            let error = (f64::from(colour[0]) - truth.r).abs();
            assert!(error < 0.5 / 255.0, "{shading:?}: {colour:?} instead of {truth:?}");
            brightest = brightest.max(truth.r);
        }
        assert!(brightest > 0.2, "{shading:?}: nothing is lit, {brightest}");
    }
}

/// From far away depths are nearly alike, and what is in front is in front all the same: of a ball of flat faces, and of two
/// plates a hundredth of their size apart. A parallel view from near by is the truth.
#[test]
fn an_eye_far_away_sees_what_is_in_front() {
    let ball = icosphere(2);
    let plate = |z: f64| {
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        Model::polygon(&corners.map(|[x, y]| DVec3::new(x, y, z)))
    };
    let (front, back) = (plate(0.01), plate(-0.01));
    let camera = |distance: f64, parallel: bool| Camera {
        eye: DVec3::Z * distance,
        target: DVec3::ZERO,
        up: DVec3::Y,
        projection: match parallel {
            true => Projection::Orthographic(3.0),
            false => Projection::Perspective(crease::num::Radians(2.0 * libm::atan(1.5 / distance))),
        },
        near: 0.1,
    };
    let settings = RenderSettings { shading: Shading::Flat, infinite_viewer: true, ..linear([64, 64]) };
    let ball_from = |distance, parallel| {
        let scene = Scene { camera: camera(distance, parallel), ..scene(vec![ball.object()]) };
        render(&scene, &settings).unwrap().linear.unwrap()
    };
    let near = ball_from(10.0, true);
    for parallel in [true, false] {
        for distance in [1e5, 1e7, 1e9] {
            let far = ball_from(distance, parallel);
            let unlike = far.iter().zip(&near).filter(|(a, b)| a != b).count();
            // From 1e5 perspective moves points by 2e-4 pixels: some edge may pass over some sample.
            assert!(unlike <= if parallel { 0 } else { 4 }, "{parallel} {distance:e}: {unlike} pixels");
            let mut red = front.object();
            red.paint = Paint::Lit(Material::matte(LinearRgb { r: 1.0, g: 0.0, b: 0.0 }));
            for objects in [vec![red.clone(), back.object()], vec![back.object(), red.clone()]] {
                let scene = Scene { camera: camera(distance, parallel), ..scene(objects) };
                let image = render(&scene, &settings).unwrap().linear.unwrap();
                let [r, g, _] = image[32 * 64 + 32];
                assert!(r > 0.1 && g == 0.0, "{parallel} {distance:e}: the plate behind is seen");
            }
        }
    }
}

/// Every good file with faces is framed by itself, and something of it is seen.
#[test]
fn all_real_meshes_show_something() {
    let rows = meshes::rows("", &["obj", "ply", "stl", "glb", "gltf"]);
    let mut drawn = 0;
    for row in rows {
        if row.name().starts_with("bad/") {
            continue;
        }
        let Ok(loaded) = read(&row.path, None, &ReadOptions::default()) else { continue };
        for part in &loaded.parts {
            let mesh = &part.mesh;
            if mesh.face_count() == 0 || mesh.face_count() > 400_000 {
                continue;
            }
            let field = compute(mesh, &NormalRecipe::default());
            let bounds = mesh.bounds().unwrap();
            let object = Object::new(Shape::Mesh { mesh, normals: &field }, Material::default());
            let scene = Scene { camera: Camera::framing(bounds, 1.0), ..scene(vec![object]) };
            let image = render(&scene, &RenderSettings { size: [64, 64], ..RenderSettings::default() });
            let image = image.unwrap_or_else(|error| panic!("{}: {error}", row.name()));
            drawn += 1;
            assert!(
                image.statistics.covered_pixels > 0 || bounds.0 == bounds.1,
                "{}: nothing of {} faces is seen",
                row.name(),
                mesh.face_count()
            );
        }
    }
    println!("{drawn} meshes drawn");
}
