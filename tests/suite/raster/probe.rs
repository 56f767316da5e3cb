//! The numbers behind a sample agree with the picture.

use super::shapes::{Model, bumpy, icosphere, linear, scene};
use crate::random::Random;
use crease::num::{LinearRgb, Radians, Transfer};
use crease::raster::{
    Camera, FlatSample, Interpolation, Paint, Projection, RenderSettings, Samples, Scene, Shading, probe,
    render,
};
use crease::shade::{AreaShape, Attenuation, Cone, Light, Material};
use crease::surface::Sphere;
use glam::DVec3;

/// Probes pixels all over a picture and compares them with it: one step of 8 bits, as the issue has it.
fn compare(scene: &Scene, settings: &RenderSettings) -> usize {
    let image = render(scene, settings).unwrap();
    let mut probed = 0;
    for y in (3..settings.size[1]).step_by(7) {
        for x in (2..settings.size[0]).step_by(7) {
            let found = probe(scene, settings, [x, y], 0).unwrap();
            let covered = image.coverage[image.index(x, y).unwrap()] > 0;
            assert_eq!(found.is_some(), covered, "({x}, {y})");
            let Some(found) = found else { continue };
            let colour = found.colour();
            let codes = settings.tone.apply(colour.to_array()).map(|c| settings.transfer.to_u8(c));
            let pixel = image.pixel(x, y).unwrap();
            for (code, pixel) in codes.into_iter().zip(pixel) {
                assert!(code.abs_diff(pixel) <= 1, "({x}, {y}): {codes:?} is not {pixel:?}: {found:?}");
            }
            let shares: f64 = found.lit.iter().map(|lit| lit.share).sum();
            assert!((shares - 1.0).abs() < 1e-9, "{found:?}");
            probed += 1;
        }
    }
    probed
}

#[test]
fn probes_agree_with_pictures() {
    let mut random = Random(41);
    let (ball, stone) = (icosphere(2), bumpy(2, &mut random));
    // A dented quad and a pentagon, out of plane, for the scanline algorithm.
    let quads = {
        let positions: Vec<DVec3> = [
            [-1.2, -1.0, 0.3],
            [0.2, -1.1, 0.0],
            [-0.3, 0.1, 0.1],
            [-0.9, 1.0, 0.2],
            [1.2, -0.6, -0.5],
            [1.3, 0.8, 0.1],
            [0.4, 1.2, 0.2],
        ]
        .map(DVec3::from)
        .to_vec();
        let mut faces = crease::mesh::Faces::new();
        faces.push(&[0, 1, 2, 3]);
        faces.push(&[1, 4, 5, 6, 2]);
        Model::new(positions, faces)
    };
    let point = Light::Point {
        position: DVec3::new(1.0, 2.0, 2.5),
        colour: LinearRgb::new(0.9, 0.8, 0.6),
        attenuation: Attenuation::Offset(0.3),
    };
    let mut probed = 0;
    for model in [&ball, &stone, &quads] {
        let mut object = model.object();
        object.surface = Some(Sphere::new(1.0).unwrap().into());
        let mut scene = scene(vec![object]);
        scene.lights.push(point);
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Exact] {
            for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective]
            {
                for (flat_sample, samples, two_sided) in [
                    (FlatSample::Centroid, Samples::One, false),
                    (FlatSample::VertexMean, Samples::One, true),
                ] {
                    let settings = RenderSettings {
                        shading,
                        interpolation,
                        flat_sample,
                        samples,
                        two_sided,
                        transfer: Transfer::Direct,
                        ..linear([90, 80])
                    };
                    probed += compare(&scene, &settings);
                }
            }
        }
        let colours = (0..model.mesh.vertex_count()).map(|k| LinearRgb::new(0.1, (k % 7) as f64 / 7.0, 0.8));
        scene.objects[0].paint = Paint::Given(colours.collect());
        for shading in [Shading::Flat, Shading::Gouraud] {
            for interpolation in [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective]
            {
                probed += compare(&scene, &RenderSettings { shading, interpolation, ..linear([90, 80]) });
            }
        }
    }
    assert!(probed > 3000, "{probed}");
}

/// The explanation's vectors are the scene's.
#[test]
fn explanations_are_in_the_scene() {
    let ball = icosphere(3);
    let scene = scene(vec![ball.object()]);
    let settings = linear([101, 101]);
    let found = probe(&scene, &settings, [50, 50], 0).unwrap().unwrap();
    assert!(found.front && found.face.is_some() && found.vertices.len() == 3);
    // The ray through the middle meets the ball before (0, 0, 1), within the sagitta of a face of level 3.
    let position = DVec3::from(found.position);
    assert!((position.z - 1.0).abs() < 0.005 && position.truncate().length() < 1e-12, "{found:?}");
    assert!((found.distance - (4.0 - position.z)).abs() < 1e-12);
    assert!(found.interpolated_normal[2] > 0.99 && found.face_normal[2] > 0.99);
    let [lit] = &found.lit[..] else { panic!("one point is lit") };
    let explanation = lit.light.as_ref().unwrap();
    assert!(DVec3::from(explanation.position).distance(position) < 1e-14);
    assert!(DVec3::from(explanation.view).distance(DVec3::Z) < 1e-14);
    assert!((explanation.view_distance.unwrap() - found.distance).abs() < 1e-14);
    assert!(probe(&scene, &settings, [0, 0], 0).unwrap().is_none());
    assert!(probe(&scene, &settings, [101, 0], 0).is_err());
    assert!(probe(&scene, &settings, [0, 0], 1).is_err());
}

/// Point lights have the same effect in the picture of a camera far from its target as in that of a near camera.
#[test]
fn distant_cameras_see_the_same_light() {
    let ball = icosphere(2);
    let position = DVec3::new(0.5, 0.2, 1.6);
    let colour = LinearRgb::grey(0.4);
    let attenuation = Attenuation::InverseSquare;
    let lamps = [
        Light::Point { position, colour, attenuation },
        Light::Spot { position, colour, attenuation, cone: Cone::of_lectures(-position) },
        Light::Area {
            shape: AreaShape::Disc { centre: position, normal: -position, radius: 0.2 },
            colour: colour * 20.0,
        },
    ];
    for (lamp, shading) in
        lamps.iter().flat_map(|&lamp| [Shading::Flat, Shading::Gouraud, Shading::Phong].map(|s| (lamp, s)))
    {
        let settings = RenderSettings { shading, transfer: Transfer::Direct, ..linear([48, 48]) };
        let seen_from = |distance: f64, parallel: bool| {
            let mut object = ball.object();
            object.paint = Paint::Lit(Material::matte(LinearRgb::grey(0.9)));
            let camera = Camera {
                eye: DVec3::Z * distance,
                target: DVec3::ZERO,
                up: DVec3::Y,
                projection: match parallel {
                    true => Projection::Orthographic(3.0),
                    false => Projection::Perspective(Radians(2.0 * libm::atan(1.5 / distance))),
                },
                near: 0.1,
            };
            Scene { camera, lights: vec![lamp], ..scene(vec![object]) }
        };
        let near = render(&seen_from(10.0, true), &settings).unwrap();
        for distance in [1e3, 1e5, 1e7, 1e9, 1e11] {
            for parallel in [true, false] {
                let far = seen_from(distance, parallel);
                assert!(compare(&far, &settings) > 10);
                let image = render(&far, &settings).unwrap();
                // Inside the rim: from 1e3 perspective moves points by a hundredth of a pixel.
                for (x, y) in [(24, 24), (20, 27), (30, 18), (33, 25), (28, 33)] {
                    let (a, b) = (image.pixel(x, y).unwrap(), near.pixel(x, y).unwrap());
                    let is_like = a.into_iter().zip(b).all(|(a, b)| a.abs_diff(b) <= 1);
                    assert!(is_like, "{lamp:?} {shading:?} {parallel} {distance:e} ({x}, {y}): {a:?} {b:?}");
                }
            }
        }
    }
}
