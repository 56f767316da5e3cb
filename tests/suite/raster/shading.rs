//! Colours: against the truth, and what must not change them.

use super::shapes::{bumpy, icosphere, linear, scene};
use crate::random::Random;
use crease::normals::{Scratch, face_normals};
use crease::num::LinearRgb;
use crease::raster::{
    Camera, Interpolation, LinePath, LineStyle, Lines, Object, RenderSettings, Samples, Scene, Shading,
    Shape, Show, Triangles, render,
};
use crease::shade::{Attenuation, Light, Material};
use crease::surface::Sphere;
use glam::{DMat4, DVec3};
use std::collections::{BTreeMap, BTreeSet};

fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(work)
}

#[test]
fn threads_change_no_byte() {
    let mut random = Random(21);
    let (first, second) = (bumpy(4, &mut random), bumpy(3, &mut random));
    let mut scene = scene(vec![first.object(), second.object()]);
    scene.objects[1].transform = DMat4::from_translation(DVec3::new(0.4, 0.1, 0.3));
    scene.lines.push(line(DVec3::new(-1.0, -1.0, 0.5), DVec3::new(1.0, 0.8, -0.5)));
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Wireframe] {
        let settings = RenderSettings { shading, samples: Samples::Four, ..linear([300, 200]) };
        let draw = |threads| with_threads(threads, || render(&scene, &settings).unwrap());
        let one = draw(1);
        assert!(one.statistics.covered_pixels > 10_000);
        for threads in [2, 3, 8] {
            let other = draw(threads);
            assert!(one.pixels == other.pixels && one.linear == other.linear, "{shading:?} {threads}");
            assert_eq!(one.coverage, other.coverage);
        }
    }
}

/// F18: flat shading is lit once for each polygon, so that a face has one colour, whatever the light; Gouraud's has many.
#[test]
fn flat_faces_have_one_colour_each() {
    let ball = icosphere(2);
    let mut scene = scene(vec![ball.object()]);
    let position = DVec3::new(1.5, 1.0, 1.5);
    scene.lights = vec![Light::Point { position, colour: LinearRgb::WHITE, attenuation: Attenuation::None }];
    let draw = |shading, show| {
        let settings = RenderSettings { shading, show, ..linear([200, 200]) };
        render(&scene, &settings).unwrap().linear.unwrap()
    };
    let faces = draw(Shading::Flat, Show::FaceId);
    let most_colours_of_a_face = |shading| {
        let mut colours: BTreeMap<[u32; 3], BTreeSet<[u32; 3]>> = BTreeMap::new();
        for (face, colour) in faces.iter().zip(draw(shading, Show::Shaded)) {
            colours.entry(face.map(f32::to_bits)).or_default().insert(colour.map(f32::to_bits));
        }
        assert!(colours.len() > 100, "half of 320 faces and the background");
        colours.values().map(BTreeSet::len).max().unwrap()
    };
    assert_eq!(most_colours_of_a_face(Shading::Flat), 1);
    assert!(most_colours_of_a_face(Shading::Gouraud) > 20);
}

/// Root mean square difference over pixels covered in both where the truth has N·V > 0.2, and the share of pixels that
/// only one covers.
fn against_exact(level: usize, shading: Shading) -> (f64, f64) {
    let ball = icosphere(level);
    let mut object = ball.object();
    object.surface = Some(Sphere::new(1.0).unwrap().into());
    let scene = scene(vec![object]);
    let settings = linear([512, 512]);
    let draw = |shading, show| render(&scene, &RenderSettings { shading, show, ..settings }).unwrap();
    let (exact, got) = (draw(Shading::Exact, Show::Shaded), draw(shading, Show::Shaded));
    let normals = draw(Shading::Exact, Show::Normals).linear.unwrap();
    let (exact_linear, got_linear) = (exact.linear.as_ref().unwrap(), got.linear.as_ref().unwrap());
    let (mut sum, mut count, mut only_one) = (0.0, 0, 0);
    for i in 0..exact_linear.len() {
        if exact.coverage[i] != got.coverage[i] {
            only_one += 1;
        }
        if exact.coverage[i] == 0 || got.coverage[i] == 0 {
            continue;
        }
        let normal = DVec3::from(normals[i].map(|c| 2.0 * f64::from(c) - 1.0));
        // On the unit sphere the normal is the position.
        let view = (scene.camera.eye - normal).normalize();
        if normal.dot(view) > 0.2 {
            count += 3;
            let pairs = exact_linear[i].iter().zip(got_linear[i]);
            sum += pairs.map(|(&a, b)| f64::from(a - b) * f64::from(a - b)).sum::<f64>();
        }
    }
    assert!(count > 100_000, "only {count}");
    ((sum / f64::from(count)).sqrt(), f64::from(only_one) / (512.0 * 512.0))
}

/// With the surface's own normals at the corners, Phong shading converges to the truth with order 2.
#[test]
fn phong_converges_to_exact_with_order_2() {
    let errors = [3, 4, 5, 6].map(|level| against_exact(level, Shading::Phong));
    // The README's table.
    println!("| level | faces | RMSE | order | pixels that only one covers |\n|---:|---:|---:|---:|---:|");
    for (number, &(error, only_one)) in errors.iter().enumerate() {
        let order = number.checked_sub(1).map(|coarser| libm::log2(errors[coarser].0 / error));
        let (level, told) = (number + 3, order.map_or("".into(), |order| format!("{order:.2}")));
        println!("| {level} | {} | {error:.2e} | {told} | {:.4} % |", 20 << (2 * level), 100.0 * only_one);
        assert!(order.is_none_or(|order| (order - 2.0).abs() < 0.15), "{errors:?}");
        // The outline lies within that of the sphere by an eighth of the squared angle between vertices, two thirds of that on
        // average, along a rim of 1141 pixels. In addition, vertices are snapped to 1/256 of a pixel.
        let angle = 1.107 / f64::from(1 << level);
        let rim = 1141.0 * (181.6 * angle * angle / 12.0 + 1.0 / 256.0);
        assert!(only_one * 512.0 * 512.0 < 2.0 * rim, "{only_one}, {rim} pixels expected");
    }
    assert!(errors[0].1 > 0.0 && errors[0].1 > errors[2].1, "{errors:?}");
    // Flat shading converges with order 1 only: the measure distinguishes the two.
    let flat = [4, 5].map(|level| against_exact(level, Shading::Flat).0);
    assert!((libm::log2(flat[0] / flat[1]) - 1.0).abs() < 0.15, "{flat:?}");
}

/// The slices and the mesh are drawn by the same code.
#[test]
fn slices_draw_what_the_mesh_draws() {
    let model = icosphere(3);
    let positions: Vec<[f32; 3]> = model.mesh.positions().iter().map(|p| p.as_vec3().to_array()).collect();
    let rounded: Vec<DVec3> = positions.iter().map(|p| DVec3::from(p.map(f64::from))).collect();
    let normals: Vec<[f32; 3]> =
        model.normals.normals.values.iter().map(|n| n.as_vec3().to_array()).collect();
    assert_eq!(model.normals.entry_vertex, (0..positions.len() as u32).collect::<Vec<_>>());
    let triangles = model.mesh.faces().corners().as_chunks::<3>().0;
    let faces = model.mesh.faces().clone();
    let same = super::shapes::Model::new(rounded, faces).with_vertex_normals(|p| {
        let vertex = positions.iter().position(|q| DVec3::from(q.map(f64::from)) == p).unwrap();
        DVec3::from(normals[vertex].map(f64::from))
    });
    let mut flat = vec![[0.0; 3]; triangles.len()];
    face_normals(&positions, triangles, &mut Scratch::new(), &mut flat).unwrap();
    let slices = Triangles { positions: &positions, triangles, normals: &normals, face_normals: &flat };
    let (mesh, slices) =
        (scene(vec![same.object()]), scene(vec![Object::new(Shape::Triangles(slices), Material::default())]));
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let settings = RenderSettings { shading, ..linear([128, 128]) };
        let [mesh, slices] = [&mesh, &slices].map(|scene| render(scene, &settings).unwrap());
        assert_eq!(mesh.coverage, slices.coverage);
        let (a, b) = (mesh.linear.unwrap(), slices.linear.unwrap());
        let worst =
            a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        // Face normals are rounded once more on the way into the slice; the rest is the same.
        assert!(worst < if shading == Shading::Flat { 2e-6 } else { f32::EPSILON }, "{shading:?}: {worst}");
    }
}

/// Moving everything by 10⁷ or scaling it by 10^±30 does not change the picture.
#[test]
fn size_and_place_do_not_matter() {
    let model = icosphere(3);
    let draw = |transform: DMat4, camera: Camera| {
        let mut scene = scene(vec![model.object()]);
        scene.objects[0].transform = transform;
        scene.camera = camera;
        render(&scene, &linear([100, 100])).unwrap()
    };
    let home = scene(Vec::new()).camera;
    let expected = draw(DMat4::IDENTITY, home);
    let compare = |image: crease::raster::Image, what: &str| {
        let pairs = image.linear.as_ref().unwrap().iter().zip(expected.linear.as_ref().unwrap());
        let differing = pairs.filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| (a - b).abs() > 1e-3)).count();
        // Corners may be snapped to another position, which moves some edges over a sample.
        assert!(differing < 20, "{what}: {differing} pixels differ");
    };
    let offset = DVec3::new(1e7, -2e7, 3e7);
    let far = Camera { eye: home.eye + offset, target: home.target + offset, ..home };
    compare(draw(DMat4::from_translation(offset), far), "far away");
    for scale in [1e-30, 1e-6, 1e6, 1e30] {
        let camera =
            Camera { eye: home.eye * scale, target: home.target * scale, near: home.near * scale, ..home };
        compare(draw(DMat4::from_scale(DVec3::splat(scale)), camera), &format!("{scale:e}"));
    }
}

/// Both sides of a sheet, lit from in front.
#[test]
fn two_sided_lights_the_side_that_is_seen() {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
    let reversed: Vec<DVec3> = corners.iter().rev().copied().collect();
    let (front, back) = (super::shapes::Model::polygon(&corners), super::shapes::Model::polygon(&reversed));
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let draw = |model: &super::shapes::Model, two_sided| {
            let settings = RenderSettings { shading, two_sided, ..linear([20, 20]) };
            render(&scene(vec![model.object()]), &settings).unwrap().linear.unwrap()[20 * 10 + 10]
        };
        assert_eq!(draw(&front, false), draw(&front, true));
        assert_eq!(draw(&back, true), draw(&front, true));
        assert!(draw(&back, false)[0] < 0.5 * draw(&front, false)[0], "{shading:?}");
    }
}

/// One line between two points.
fn line(a: DVec3, b: DVec3) -> Lines {
    let path = LinePath::Points { points: vec![a, b], segments: vec![[0, 1]] };
    Lines { path, style: LineStyle::default() }
}

/// Hidden lines are hidden, and lines in a surface are not.
#[test]
fn hidden_lines_are_removed() {
    let ball = icosphere(2);
    let draw = |hide| {
        let mut settings = RenderSettings { shading: Shading::Wireframe, ..linear([200, 200]) };
        settings.wire.hide = hide;
        let image = render(&scene(vec![ball.object()]), &settings).unwrap();
        let shown = image.linear.unwrap().iter().filter(|colour| colour[0] > 0.0).count();
        // Pixels of edges, not of the faces that hide some.
        assert_eq!(image.statistics.covered_pixels, shown as u64);
        shown as f64
    };
    let (hidden, all) = (draw(true), draw(false));
    // Front and back have as many edges; where they cross the same pixels they count once.
    assert!(hidden > 0.5 * all && hidden < 0.65 * all, "{hidden} of {all}");
    // Lines along a flat face, from edge to edge, all show: 100 pixels long each.
    let plate = super::shapes::Model::polygon(
        &[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, x - 0.3 * y)),
    );
    let mut scene = scene(vec![plate.object()]);
    let on_plate = |x: f64, y: f64| DVec3::new(x, y, x - 0.3 * y);
    let (a, b) = (on_plate(-0.9, -0.3), on_plate(0.9, 0.4));
    scene.lines.push(line(a, b));
    scene.lines[0].style.colour = LinearRgb::new(0.0, 9.0, 0.0);
    let count = |scene: &Scene| {
        let image = render(scene, &linear([200, 200])).unwrap();
        image.linear.unwrap().iter().filter(|colour| **colour == [0.0, 9.0, 0.0]).count()
    };
    let shown = count(&scene);
    scene.lines[0].style.hide = false;
    assert_eq!((shown, shown > 80), (count(&scene), true));
    let behind = |point: DVec3| point - DVec3::Z * 0.2;
    scene.lines[0].path = line(behind(a), behind(b)).path;
    scene.lines[0].style.hide = true;
    assert_eq!(count(&scene), 0);
}

/// Each sample is shaded by itself: the picture with 4 samples is the mean of 4 pictures moved by a part of a pixel.
#[test]
fn samples_are_pictures_of_their_own() {
    let model = icosphere(3);
    let mut scene = scene(vec![model.object()]);
    scene.lights.push(Light::Ambient { colour: LinearRgb::grey(0.2) });
    scene.camera = super::shapes::pixel_camera([40, 40]);
    scene.objects[0].transform =
        DMat4::from_translation(DVec3::new(20.0, 20.0, 0.0)) * DMat4::from_scale(DVec3::splat(17.3));
    let settings = RenderSettings { interpolation: Interpolation::Affine, ..linear([40, 40]) };
    let four =
        render(&scene, &RenderSettings { samples: Samples::Four, ..settings }).unwrap().linear.unwrap();
    let mut mean = vec![[0.0_f32; 3]; 1600];
    for [x, y] in Samples::Four.places() {
        let mut moved = scene.clone();
        let by = DVec3::new(0.5 - x, y - 0.5, 0.0);
        moved.objects[0].transform = DMat4::from_translation(by) * scene.objects[0].transform;
        let one = render(&moved, &settings).unwrap().linear.unwrap();
        for (mean, one) in mean.iter_mut().zip(one) {
            mean.iter_mut().zip(one).for_each(|(mean, one)| *mean += one / 4.0);
        }
    }
    let worst =
        four.as_flattened().iter().zip(mean.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    // Sub-pixel places are multiples of 1/256, but 17.3 is not: some corners snap to the other side.
    assert!(worst < 0.05, "{worst}");
    let close =
        four.iter().zip(&mean).filter(|(a, b)| a.iter().zip(*b).all(|(a, b)| (a - b).abs() < 1e-3)).count();
    assert!(close > 1590, "{close}");
}
