//! Which pixels are covered.

use super::shapes::{Model, bumpy, icosphere, linear, pixel_camera, scene, unit};
use crate::random::Random;
use crease::mesh::Faces;
use crease::num::Degrees;
use crease::raster::{Camera, Cull, Object, Projection, RenderSettings, Samples, Shading, Show, render};
use crease::surface::{Surface, Tessellation, Torus};
use glam::{DMat4, DVec3};

fn covered(settings: &RenderSettings, scene: &crease::raster::Scene) -> Vec<u8> {
    render(scene, settings).unwrap().coverage
}

/// Direct3D 9's example has pixel centres at whole numbers and y down; here they are at halves and y is up.
#[test]
fn the_top_left_rule_gives_15_and_10() {
    let at = |x: f64, y: f64| DVec3::new(x + 0.5, 8.0 - (y + 0.5), 0.0);
    let count = |corners: [DVec3; 3]| {
        let model = Model::polygon(&corners);
        let scene = crease::raster::Scene { camera: pixel_camera([8, 8]), ..scene(vec![model.object()]) };
        covered(&linear([8, 8]), &scene)
    };
    let upper = count([at(0.0, 0.0), at(5.0, 0.0), at(5.0, 5.0)]);
    let lower = count([at(0.0, 5.0), at(0.0, 0.0), at(5.0, 5.0)]);
    let sum = |coverage: &[u8]| coverage.iter().map(|&n| u32::from(n)).sum::<u32>();
    assert_eq!((sum(&upper), sum(&lower)), (15, 10));
    assert!(upper.iter().zip(&lower).all(|(a, b)| a + b <= 1));
}

/// Closed meshes of several kinds, about as large as the unit sphere.
fn closed(kind: &str, random: &mut Random) -> Model {
    match kind {
        "bumpy" => bumpy(1, random),
        "flat" => {
            // Slivers: a thousandth as thick as wide, rotated at random.
            let Model { mesh, .. } = bumpy(1, random);
            let turn = DMat4::from_rotation_x(unit(random)) * DMat4::from_rotation_y(3.0 * unit(random));
            let squeeze = |p: DVec3| turn.transform_point3(p * DVec3::new(1.0, 1.0, 1e-3));
            Model::new(mesh.positions().iter().map(squeeze).collect(), mesh.faces().clone())
        }
        _ => {
            let torus = Surface::Primitive(Torus::new(0.8, 0.35).unwrap().into());
            let cut = Tessellation { segments: [10, 5], ..Tessellation::default() };
            let mesh = torus.tessellate(&cut).unwrap();
            let turn = DMat4::from_rotation_x(3.0 * unit(random)) * DMat4::from_rotation_z(unit(random));
            let positions = mesh.positions().iter().map(|p| turn.transform_point3(p)).collect();
            Model::new(positions, mesh.faces().clone())
        }
    }
}

/// Without culling, a closed mesh in front of the near plane shows as many front faces as back faces at each sample: in the
/// middle of the picture, across its rim, and so wide that the guard band clips it. Every face is drawn alone, so that all layers
/// count.
#[test]
fn closed_meshes_are_covered_as_often_by_fronts_as_by_backs() {
    let mut random = Random(5);
    for (round, kind) in ["bumpy", "flat", "torus"].into_iter().cycle().take(18).enumerate() {
        let model = closed(kind, &mut random);
        let place = ["whole", "rim", "guard"][round / 3 % 3];
        let straight = scene(Vec::new()).camera;
        let mut eye = DVec3::new(unit(&mut random), unit(&mut random), unit(&mut random)) * 4.0 - 2.0;
        eye = eye.normalize() * 3.5;
        let mut target = DVec3::ZERO;
        let mut stretch = DMat4::IDENTITY;
        match place {
            "rim" => target = DVec3::new(unit(&mut random), unit(&mut random), unit(&mut random)) * 2.0 - 1.0,
            // Along x, and seen from z: all of it stays in front of the eye.
            "guard" => {
                eye = DVec3::Z * 4.0;
                stretch = DMat4::from_scale(DVec3::new(5e3, 1.0, 1.0));
            }
            _ => {}
        }
        let projection = if round < 9 { straight.projection } else { Projection::Orthographic(2.6) };
        let camera = Camera { eye, target, projection, near: 0.01, ..straight };
        let samples = if round % 2 == 0 { Samples::One } else { Samples::Four };
        let settings = RenderSettings { size: [60, 44], samples, ..RenderSettings::default() };
        let mut balance = vec![0_i32; 60 * 44];
        let (mut layers, mut clipped) = (0, 0);
        for face in 0..model.mesh.face_count() {
            let mut one = Faces::new();
            one.push(model.mesh.faces().face(face));
            let part = Model::new(model.mesh.positions().to_vec(), one);
            let object = Object { transform: stretch, ..part.object() };
            let scene = crease::raster::Scene { camera, ..scene(vec![object]) };
            let front = render(&scene, &RenderSettings { cull: Cull::Back, ..settings }).unwrap();
            clipped += front.statistics.triangles_clipped;
            let back = covered(&RenderSettings { cull: Cull::Front, ..settings }, &scene);
            for ((balance, front), back) in balance.iter_mut().zip(front.coverage).zip(back) {
                *balance += i32::from(front) - i32::from(back);
                layers += i32::from(front);
            }
        }
        let what = format!("round {round}, {kind}, {place}, {projection:?}");
        assert!(balance.iter().all(|&n| n == 0), "{what}");
        assert!(layers > 10, "{what}: only {layers}");
        assert_eq!(clipped > 0, place == "guard", "{what}: {clipped} clipped");
    }
}

/// The triangles of a fan over a convex polygon cover each sample of it exactly once, whatever point they meet in.
#[test]
fn fans_cover_exactly_once() {
    let mut random = Random(6);
    for sides in [3, 5, 12, 64] {
        let rim = |k: usize| {
            let turn = std::f64::consts::TAU * k as f64 / sides as f64;
            DVec3::new(32.0 + 25.3 * libm::cos(turn), 32.0 + 25.3 * libm::sin(turn), 0.0)
        };
        let centre = DVec3::new(25.0 + 14.0 * unit(&mut random), 25.0 + 14.0 * unit(&mut random), 0.0);
        let mut count = vec![0_u8; 64 * 64];
        for k in 0..sides {
            let part = Model::polygon(&[centre, rim(k), rim((k + 1) % sides)]);
            let scene =
                crease::raster::Scene { camera: pixel_camera([64, 64]), ..scene(vec![part.object()]) };
            count.iter_mut().zip(covered(&linear([64, 64]), &scene)).for_each(|(n, c)| *n += c);
        }
        let whole = Model::polygon(&(0..sides).map(rim).collect::<Vec<_>>());
        let scene = crease::raster::Scene { camera: pixel_camera([64, 64]), ..scene(vec![whole.object()]) };
        assert_eq!(count, covered(&linear([64, 64]), &scene), "{sides}");
        assert!(count.contains(&1));
    }
}

/// All that differs between shading and interpolation modes is colour.
#[test]
fn modes_share_one_coverage() {
    use crease::raster::Interpolation::{Affine, Perspective, Scanline};
    let mut random = Random(7);
    let model = bumpy(2, &mut random);
    let scene = scene(vec![model.object()]);
    for samples in [Samples::One, Samples::Eight] {
        let plain = RenderSettings { size: [100, 80], samples, ..RenderSettings::default() };
        let expected = covered(&plain, &scene);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wireframe] {
            for interpolation in [Scanline, Affine, Perspective] {
                let settings = RenderSettings { shading, interpolation, ..plain };
                assert_eq!(covered(&settings, &scene), expected, "{shading:?} {interpolation:?}");
            }
        }
        for show in [
            Show::Normals,
            Show::Facing,
            Show::Depth,
            Show::FaceId,
            Show::Deviation(crease::num::Degrees(15.0)),
        ] {
            assert_eq!(covered(&RenderSettings { show, ..plain }, &scene), expected, "{show:?}");
        }
        assert!(expected.iter().any(|&n| usize::from(n) == samples.count()));
    }
}

/// A ball from inside: half of it is behind the eye, and some triangles cross the near plane. Each pixel is covered.
#[test]
fn from_inside_a_ball_there_is_no_hole() {
    let ball = icosphere(2);
    for (number, target) in
        [DVec3::X, DVec3::new(0.3, 0.9, 0.2), DVec3::new(-0.5, -0.4, 0.7)].into_iter().enumerate()
    {
        for angle in [1.0, 60.0, 179.0] {
            let eye = DVec3::new(0.1, 0.2, -0.3);
            let camera = Camera {
                eye,
                target: eye + target,
                up: DVec3::new(0.1, 0.2, 1.0),
                projection: Projection::Perspective(Degrees(angle).into()),
                near: if number == 0 { 1e-9 } else { 1e-3 },
            };
            let scene = crease::raster::Scene { camera, ..scene(vec![ball.object()]) };
            let image = render(&scene, &linear([150, 130])).unwrap();
            assert_eq!(image.statistics.covered_pixels, 150 * 130, "{target} {angle}");
            if angle > 100.0 {
                assert!(image.statistics.triangles_clipped > 0, "{target} {angle}");
            }
        }
    }
}

/// Of coinciding faces the one with the lower index shows, whatever its winding and its first corner.
#[test]
fn equal_depth_goes_to_the_lower_face() {
    let corners = [DVec3::new(-1.0, -0.7, 0.2), DVec3::new(1.1, -0.4, -0.6), DVec3::new(0.1, 0.9, 0.4)];
    for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]] {
        let mut faces = Faces::triangles(vec![0, 1, 2]);
        faces.push(&order);
        let both = Model::new(corners.to_vec(), faces);
        let first = Model::new(corners.to_vec(), Faces::triangles(vec![0, 1, 2]));
        let settings = RenderSettings { show: Show::FaceId, ..linear([64, 64]) };
        let [both, first] = [&both, &first].map(|model| {
            let image = render(&scene(vec![model.object()]), &settings).unwrap();
            assert!(image.statistics.covered_pixels > 200);
            image.linear.unwrap()
        });
        assert!(both == first, "{order:?}");
    }
}

/// The winding of faces in the scene decides what is culled, also for rotated and mirrored objects.
#[test]
fn mirrored_objects_keep_their_fronts() {
    let model = icosphere(1);
    let plain = scene(vec![model.object()]);
    let mut mirrored = scene(vec![model.object()]);
    mirrored.objects[0].transform = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    for cull in [Cull::Back, Cull::Front] {
        let settings = RenderSettings { cull, show: Show::Facing, ..linear([60, 60]) };
        let [plain, mirrored] = [&plain, &mirrored].map(|scene| render(scene, &settings).unwrap());
        let colour = |image: &crease::raster::Image| image.pixel(30, 30).unwrap();
        assert_eq!(colour(&plain), colour(&mirrored));
        assert_ne!(colour(&plain), [0; 3]);
    }
    // Lit from the same side, a mirrored ball is as bright where it was mirrored to.
    let image = |scene: &crease::raster::Scene| render(scene, &linear([60, 60])).unwrap();
    let mut left = plain.clone();
    left.lights = vec![crease::shade::Light::Directional {
        towards: DVec3::new(-0.8, 0.0, 1.0),
        colour: crease::num::LinearRgb::WHITE,
    }];
    let mut right = mirrored.clone();
    right.lights = vec![crease::shade::Light::Directional {
        towards: DVec3::new(0.8, 0.0, 1.0),
        colour: crease::num::LinearRgb::WHITE,
    }];
    let (left, right) = (image(&left).linear.unwrap(), image(&right).linear.unwrap());
    for y in 0..60 {
        for x in 0..60 {
            let (a, b) = (left[y * 60 + x], right[y * 60 + 59 - x]);
            // Snapping to 1/256 pixel is not symmetric, and a slope of colour is below 0.1 a pixel.
            let is_rim = a == [0.0; 3] || b == [0.0; 3];
            assert!(is_rim || a.iter().zip(b).all(|(a, b)| (a - b).abs() < 2e-3), "{x} {y}: {a:?} {b:?}");
        }
    }
}
