//! Traced pictures against Phong's shading, closed forms and mirrored scenes.

use super::shapes::{Model, bumpy, icosphere, linear, scene};
use crate::random::Random;
use crease::num::{Degrees, LinearRgb, Radians};
use crease::raster::{
    Camera, Image, Object, ObjectSettings, Projection, RayHit, RayNode, RenderSettings, Scene, Shading,
    Shape, TraceSettings, probe, render,
};
use crease::shade::{AreaShape, Light, Material, Optics, Reflectance, fresnel, refraction_angle};
use crease::surface::{Plane, Primitive, Sphere};
use glam::{DMat4, DVec3};

const SIZE: [u32; 2] = [96, 72];

fn traced(shadow_samples: u32) -> RenderSettings {
    let tracing = TraceSettings { shadow_samples, ..TraceSettings::default() };
    RenderSettings { shading: Shading::Traced, tracing, ..linear(SIZE) }
}

/// A material without a colour of its own.
fn black() -> Material {
    let none = Reflectance::NONE;
    Material { ambient: none, diffuse: none, specular: none, ..Material::default() }
}

fn glass() -> Optics {
    Optics { transmit: LinearRgb::WHITE, ior: 1.5, ..Optics::NONE }
}

/// The pixels of which all neighbours, up to two pixels away, are `inside`.
fn inner(size: [u32; 2], inside: impl Fn(usize) -> bool) -> Vec<usize> {
    let [width, height] = size.map(|n| n as usize);
    let is_inner = |at: &usize| {
        let (x, y) = (at % width, at / width);
        let near = |n: usize, most: usize| n.saturating_sub(2)..(n + 3).min(most);
        near(y, height).all(|y| near(x, width).all(|x| inside(y * width + x)))
    };
    (0..width * height).filter(is_inner).collect()
}

/// The largest difference of 8-bit codes at some pixels.
fn steps(a: &Image, b: &Image, pixels: &[usize]) -> u8 {
    let code =
        |image: &Image, at: usize| image.pixel(at as u32 % image.size[0], at as u32 / image.size[0]).unwrap();
    let pixels = pixels.iter().flat_map(|&at| code(a, at).into_iter().zip(code(b, at)));
    pixels.map(|(a, b)| a.abs_diff(b)).max().unwrap()
}

#[test]
fn without_shadows_and_mirrors_a_picture_is_that_of_phong() {
    let models = [icosphere(2), bumpy(2, &mut Random(5))];
    for (model, camera_height) in models.iter().zip([0.0, 1.5]) {
        for (two_sided, terminator) in
            [(false, crease::shade::Terminator::Smooth), (true, crease::shade::Terminator::Soft)]
        {
            let mut scene = scene(vec![model.object()]);
            scene.camera.eye.y = camera_height;
            scene.lights.push(Light::Point {
                position: DVec3::new(-2.0, 1.0, 2.0),
                colour: LinearRgb::new(0.2, 0.4, 0.9),
                attenuation: crease::shade::Attenuation::InverseSquare,
            });
            let traced = RenderSettings { two_sided, terminator, keep_objects: true, ..traced(0) };
            let phong = RenderSettings { shading: Shading::Phong, ..traced };
            let [phong, traced] = [phong, traced].map(|settings| render(&scene, &settings).unwrap());
            let covered = |image: &Image, at: usize| image.coverage[at] > 0;
            let pixels = inner(SIZE, |at| covered(&phong, at) && covered(&traced, at));
            assert!(pixels.len() > 1000, "{}", pixels.len());
            // At inner outlines of the bumpy one vertices are snapped.
            let same: Vec<usize> = if camera_height == 0.0 {
                pixels
            } else {
                pixels.into_iter().filter(|&at| steps(&phong, &traced, &[at]) < 40).collect()
            };
            assert!(steps(&phong, &traced, &same) <= 1);
            assert!(same.len() > 1000);
            assert_eq!(phong.objects.as_ref().map(Vec::len), traced.objects.as_ref().map(Vec::len));
        }
    }
}

#[test]
fn smooth_bodies_do_not_shade_themselves() {
    let model = icosphere(3);
    let scene = scene(vec![model.object()]);
    let [free, shadowed] = [0, 1].map(|samples| render(&scene, &traced(samples)).unwrap());
    let pixels = inner(SIZE, |at| free.coverage[at] > 0);
    // Measured: 0. Without lifted starts of shadow rays the faces behind the terminator are dark.
    assert!(steps(&free, &shadowed, &pixels) <= 1);
    assert!(shadowed.statistics.rays > free.statistics.rays);
}

#[test]
fn a_mirror_shows_the_mirrored_scene() {
    let model = icosphere(3);
    let mirror = Plane::new(40.0, 40.0).unwrap();
    let lying = DMat4::from_rotation_x(-std::f64::consts::FRAC_PI_2);
    let above = DMat4::from_translation(DVec3::new(0.2, 2.0, 0.0));
    let camera = Camera {
        eye: DVec3::new(0.0, 1.5, 6.0),
        target: DVec3::new(0.0, -2.0, 0.0),
        up: DVec3::Y,
        projection: Projection::Perspective(Degrees(24.0).into()),
        near: 0.1,
    };
    let picture = |objects, y: f64, settings: RenderSettings| {
        let lights =
            vec![Light::Directional { towards: DVec3::new(0.5, 0.3 * y, 1.0), colour: LinearRgb::WHITE }];
        render(&Scene { lights, camera, ..scene(objects) }, &settings).unwrap()
    };
    let plane = Object {
        transform: lying,
        optics: Optics { reflect: LinearRgb::WHITE, ..Optics::NONE },
        ..Object::new(Shape::Surface(Primitive::Plane(mirror)), black())
    };
    let ball = Object { transform: above, ..model.object() };
    let mirrored = DMat4::from_scale(DVec3::new(1.0, -1.0, 1.0));
    let image = Object { transform: mirrored * above, ..model.object() };
    let seen = picture(vec![plane, ball], 1.0, traced(0));
    let expected = picture(vec![image], -1.0, RenderSettings { shading: Shading::Phong, ..traced(0) });
    let pixels = inner(SIZE, |at| expected.coverage[at] > 0);
    assert!(pixels.len() > 500, "{}", pixels.len());
    assert!(steps(&seen, &expected, &pixels) <= 1);
    // Around it there is nothing but mirrored background.
    let around = inner(SIZE, |at| expected.coverage[at] == 0);
    assert_eq!(steps(&seen, &expected, &around), 0);
}

/// The rays behind the middle of a picture.
fn rays(scene: &Scene, settings: &RenderSettings, pixel: [u32; 2]) -> RayNode {
    probe(scene, settings, pixel, 0).unwrap().unwrap().rays.unwrap()
}

fn hit(node: &RayNode) -> &RayHit {
    node.hit.as_ref().unwrap()
}

fn next<'a>(node: &'a RayNode, kind: &str) -> &'a RayNode {
    hit(node).rays.iter().find(|node| node.kind == kind).unwrap()
}

/// A parallel camera whose middle pixel is a ray from `eye` along `direction`.
fn pointing(eye: DVec3, direction: DVec3) -> Camera {
    let up = if direction.x.abs() < 0.5 { DVec3::X } else { DVec3::Z };
    Camera { eye, target: eye + direction * 4.0, up, projection: Projection::Orthographic(1.0), near: 0.0 }
}

const MIDDLE: [u32; 2] = [1, 1];
const SMALL: [u32; 2] = [3, 3];

#[test]
fn a_glass_sphere_deviates_rays_as_snell_says() {
    let settings = RenderSettings { size: SMALL, ..traced(1) };
    for height in [0.0, 0.1, 0.35, 0.7, 0.95] {
        let sphere = Primitive::from(Sphere::new(1.0).unwrap());
        let object = Object { optics: glass(), ..Object::new(Shape::Surface(sphere), black()) };
        let camera = pointing(DVec3::new(0.0, height, 4.0), DVec3::NEG_Z);
        let tree = rays(&Scene { camera, ..scene(vec![object]) }, &settings, MIDDLE);
        let (inside, after) = (next(&tree, "refracted"), next(next(&tree, "refracted"), "refracted"));
        let incidence = Radians(libm::asin(height));
        let refracted = refraction_angle(1.0, 1.5, incidence).unwrap();
        // Twice the bend of one surface. Normals are in single precision.
        let expected = 2.0 * (incidence.0 - refracted.0);
        let direction = DVec3::from(after.direction);
        let deviation = libm::atan2(-direction.y, -direction.z);
        assert!((deviation - expected).abs() < 1e-6, "{height}: {deviation}, not {expected}");
        let length = DVec3::from(hit(inside).position).distance(DVec3::from(hit(&tree).position));
        assert!((length - 2.0 * libm::cos(refracted.0)).abs() < 1e-6);
        let reflected = fresnel(1.0, 1.5, incidence).reflected();
        assert!((hit(&tree).fresnel.unwrap() - reflected).abs() < 1e-6);
        assert_eq!((hit(&tree).indices, hit(inside).indices), (Some([1.0, 1.5]), Some([1.5, 1.0])));
        assert!(after.hit.is_none() && !hit(inside).front);
    }
}

/// A box of quads with half the edges `half`.
fn block(half: DVec3) -> Model {
    let corner = |n: u32| {
        let sign = |bit: u32| if n >> bit & 1 == 0 { -1.0 } else { 1.0 };
        half * DVec3::new(sign(0), sign(1), sign(2))
    };
    let mut faces = crease::mesh::Faces::new();
    for face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
        faces.push(&face);
    }
    Model::new((0..8).map(corner).collect(), faces)
}

fn flat() -> ObjectSettings {
    ObjectSettings { shading: Some(Shading::Flat), ..ObjectSettings::default() }
}

#[test]
fn a_slab_shifts_rays_and_absorbs_by_beers_law() {
    let slab = block(DVec3::new(20.0, 20.0, 0.5));
    let absorb = LinearRgb::new(0.0, 0.3, 2.0);
    let optics = Optics { absorb, ..glass() };
    for degrees in [0.0, 20.0, 60.0] {
        let object = Object { optics, settings: flat(), ..Object::new(slab.shape(), black()) };
        let (sin, cos) = libm::sincos(f64::to_radians(degrees));
        let direction = DVec3::new(0.0, -sin, -cos);
        let camera = pointing(direction * -4.0, direction);
        let settings = RenderSettings { size: SMALL, ..traced(1) };
        let tree = rays(&Scene { camera, ..scene(vec![object]) }, &settings, MIDDLE);
        let (inside, after) = (next(&tree, "refracted"), next(next(&tree, "refracted"), "refracted"));
        let out = DVec3::from(after.direction);
        // Positions of meshes are in single precision.
        assert!(out.distance(direction) < 1e-6, "{degrees}: {out}");
        let refracted = refraction_angle(1.0, 1.5, Radians(f64::to_radians(degrees))).unwrap().0;
        let shift = libm::sin(f64::to_radians(degrees) - refracted) / libm::cos(refracted);
        let line = DVec3::from(after.origin) - DVec3::from(tree.origin);
        let found = line.cross(direction).length();
        // Rays start 1/65 536 of the frame's unit of 4 off the faces.
        assert!((found - shift).abs() < 2e-4, "{degrees}: {found}, not {shift}");
        let length = 1.0 / libm::cos(refracted);
        for (found, a) in inside.transmittance.into_iter().zip(absorb.to_array()) {
            assert!((found - libm::exp(-a * length)).abs() < 1e-4, "{degrees}: {found}");
        }
    }
}

#[test]
fn reflection_is_total_beyond_the_critical_angle() {
    let body = block(DVec3::splat(4.0));
    let object = Object { optics: glass(), settings: flat(), ..Object::new(body.shape(), black()) };
    let critical = libm::asin(1.0 / 1.5);
    let (mut total, mut partial) = (0, 0);
    for step in 0..60 {
        let angle = critical + f64::from(step - 30) * 1e-3 + 1e-5;
        let (sin, cos) = libm::sincos(angle);
        // From inside the body.
        let camera = pointing(DVec3::ZERO, DVec3::new(0.0, -sin, -cos));
        let settings = RenderSettings { size: SMALL, ..traced(1) };
        let tree = rays(&Scene { camera, ..scene(vec![object.clone()]) }, &settings, MIDDLE);
        let share = hit(&tree).fresnel.unwrap();
        assert_eq!(share == 1.0, angle > critical, "{angle}: {share}");
        assert_eq!(hit(&tree).rays.iter().any(|ray| ray.kind == "refracted"), angle < critical);
        total += u32::from(share == 1.0);
        partial += u32::from(share < 1.0);
    }
    assert!(total >= 29 && partial >= 29);
}

#[test]
fn a_disc_light_has_umbra_and_penumbra_of_the_right_width() {
    // The edge of a half-plane at x = 0 and a height of 1, below a disc of radius 0.5 at a height of 3.
    let screen = Model::polygon(&[
        DVec3::new(-9.0, 1.0, 9.0),
        DVec3::new(0.0, 1.0, 9.0),
        DVec3::new(0.0, 1.0, -9.0),
        DVec3::new(-9.0, 1.0, -9.0),
    ]);
    let floor = Model::polygon(&[
        DVec3::new(-9.0, 0.0, 9.0),
        DVec3::new(9.0, 0.0, 9.0),
        DVec3::new(9.0, 0.0, -9.0),
        DVec3::new(-9.0, 0.0, -9.0),
    ]);
    let light = Light::Area {
        shape: AreaShape::Disc { centre: DVec3::new(0.0, 3.0, 0.0), normal: DVec3::NEG_Y, radius: 0.5 },
        colour: LinearRgb::grey(4.0),
    };
    let visible = |x: f64, samples: u32| {
        let camera = pointing(DVec3::new(x, 0.5, 0.0), DVec3::NEG_Y);
        let scene = Scene { camera, lights: vec![light], ..scene(vec![floor.object(), screen.object()]) };
        let settings = RenderSettings { size: SMALL, ..traced(samples) };
        hit(&rays(&scene, &settings, MIDDLE)).shadows[0].visible[0]
    };
    // By similar triangles: 0.5 · 1/(3 − 1).
    let half_width = 0.25;
    for samples in [16, 256] {
        assert_eq!(visible(-half_width - 1e-3, samples), 0.0);
        assert_eq!(visible(half_width + 1e-3, samples), 1.0);
        let shares = [-0.2, -0.1, 0.0, 0.1, 0.2].map(|x| visible(x, samples));
        assert!(shares.is_sorted() && shares.iter().all(|share| (0.0..=1.0).contains(share)), "{shares:?}");
        // Half of the disc; 16 samples are off by a few.
        let room = if samples == 16 { 0.15 } else { 0.02 };
        assert!((shares[2] - 0.5).abs() < room, "{shares:?}");
    }
    let near = visible(half_width - 0.01, 4096);
    assert!(near < 1.0 && visible(-half_width + 0.01, 4096) > 0.0, "{near}");
}

#[test]
fn lights_that_nothing_hides_have_their_closed_form() {
    let floor = Model::polygon(&[
        DVec3::new(-2.0, -1.0, 0.0),
        DVec3::new(2.0, -1.0, 0.0),
        DVec3::new(2.0, 1.0, 0.3),
        DVec3::new(-2.0, 1.0, 0.3),
    ]);
    let mut scene = scene(vec![floor.object()]);
    let rectangle =
        AreaShape::Rectangle { centre: DVec3::new(0.0, 1.0, 2.0), u: DVec3::X, v: DVec3::NEG_Y * 0.5 };
    let disc = AreaShape::Disc { centre: DVec3::new(-1.0, 0.0, 1.0), normal: DVec3::NEG_Z, radius: 0.5 };
    for shape in [rectangle, disc] {
        scene.lights.push(Light::Area { shape, colour: LinearRgb::WHITE });
    }
    let [without, with] = [0, 16].map(|samples| render(&scene, &traced(samples)).unwrap());
    assert!(without.statistics.covered_pixels > 1000);
    assert_eq!(without.linear, with.linear);
}

#[test]
fn any_number_of_threads_draws_the_same_bytes() {
    let (ball, bumps) = (icosphere(2), bumpy(2, &mut Random(8)));
    let glassy = Object { optics: Optics { reflect: LinearRgb::grey(0.1), ..glass() }, ..ball.object() };
    let behind = Object { transform: DMat4::from_translation(DVec3::new(0.5, 0.0, -2.0)), ..bumps.object() };
    let mut scene = scene(vec![glassy, behind]);
    let shape = AreaShape::Disc { centre: DVec3::new(-2.0, 2.0, 3.0), normal: DVec3::NEG_ONE, radius: 0.5 };
    scene.lights.push(Light::Area { shape, colour: LinearRgb::WHITE });
    let pictures = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let picture = pool.install(|| render(&scene, &traced(4))).unwrap();
        (picture.pixels, picture.linear, picture.statistics.rays, picture.statistics.light_cut.to_bits())
    });
    assert_eq!(pictures[0], pictures[1]);
    assert_eq!(pictures[0], pictures[2]);
}

#[test]
fn limits_report_the_light_that_they_cut_off() {
    // Two mirrors that face each other.
    let mirror = Primitive::from(Plane::new(50.0, 50.0).unwrap());
    let wall = |z: f64, turn: f64| Object {
        transform: DMat4::from_translation(DVec3::Z * z) * DMat4::from_rotation_y(turn),
        optics: Optics { reflect: LinearRgb::grey(0.5), ..Optics::NONE },
        ..Object::new(Shape::Surface(mirror), black())
    };
    let mut scene = scene(vec![wall(-1.0, 0.0), wall(5.0, std::f64::consts::PI)]);
    scene.camera.projection = Projection::Orthographic(2.0);
    for (depth, cut) in [(0, 0.5), (3, 0.0625), (8, 1.0 / 512.0), (64, 0.0)] {
        let tracing = TraceSettings { depth, weight: 0.0, shadow_samples: 0 };
        let picture = render(&scene, &RenderSettings { tracing, ..traced(0) }).unwrap();
        assert!(
            (picture.statistics.light_cut - cut).abs() < 1e-12,
            "{depth}: {}",
            picture.statistics.light_cut
        );
    }
    // Light that a weight cuts off is counted, too: 1/16 is followed, 1/32 is not.
    let tracing = TraceSettings { depth: 64, weight: 0.05, shadow_samples: 0 };
    let picture = render(&scene, &RenderSettings { tracing, ..traced(0) }).unwrap();
    assert_eq!(picture.statistics.light_cut, 1.0 / 32.0);
}
