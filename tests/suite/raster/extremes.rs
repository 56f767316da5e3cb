//! Corners from 10⁻³⁰ to 10³⁰ in one scene: drawn where rays hit them, clipped, or omitted; never a wrong pixel.

use super::shapes::{Model, linear, scene, unit};
use crate::random::Random;
use crease::mesh::Faces;
use crease::num::{Degrees, LinearRgb};
use crease::raster::{
    Camera, FlatSample, Image, Interpolation, Paint, Projection, RenderSettings, Scene, Shading, Show,
    default_lights, probe, render,
};
use glam::{DVec2, DVec3};

const SIZE: [u32; 2] = [40, 30];
/// Distance of the eye on the z axis, from which it looks at the origin.
const AWAY: f64 = 6.0;

const INTERPOLATIONS: [Interpolation; 3] =
    [Interpolation::Scanline, Interpolation::Affine, Interpolation::Perspective];

fn projections() -> Vec<Projection> {
    let angles = [0.001, 0.03, 1.0, 25.0, 90.0, 170.0].map(|a| Projection::Perspective(Degrees(a).into()));
    angles.into_iter().chain([1e-3, 3.0, 1e4].map(Projection::Orthographic)).collect()
}

fn camera(projection: Projection) -> Camera {
    let near = if matches!(projection, Projection::Perspective(_)) { 0.006 } else { 0.0 };
    Camera { eye: DVec3::Z * AWAY, target: DVec3::ZERO, up: DVec3::Y, projection, near }
}

/// A point whose coordinates have random signs and magnitudes from 10^−`reach` to 10^`reach`.
fn point(random: &mut Random, reach: f64) -> DVec3 {
    DVec3::from([0; 3].map(|_| {
        let size = libm::pow(10.0, (2.0 * unit(random) - 1.0) * reach);
        if random.one_in(2) { size } else { -size }
    }))
}

/// `count` faces with `corners` corners each, separate or with shared vertices.
fn wild(random: &mut Random, reach: f64, [count, corners]: [usize; 2], shared: bool) -> Model {
    let vertices = if shared { 2 * corners + 6 } else { count * corners };
    let positions = (0..vertices).map(|_| point(random, reach)).collect();
    let mut faces = Faces::new();
    for face in 0..count {
        let first = if shared { random.below(vertices) } else { face * corners };
        let step = if shared { 1 + random.below(vertices / corners - 1) } else { 1 };
        let face: Vec<u32> = (0..corners).map(|k| ((first + k * step) % vertices) as u32).collect();
        faces.push(&face);
    }
    Model::new(positions, faces)
}

fn draw(
    model: &Model,
    projection: Projection,
    paint: Option<&[LinearRgb]>,
    settings: &RenderSettings,
) -> Image {
    let mut object = model.object();
    if let Some(colours) = paint {
        object.paint = Paint::Given(colours.into());
    }
    let camera = camera(projection);
    let scene = Scene { camera, lights: default_lights(&camera).to_vec(), ..scene(vec![object]) };
    let image = render(&scene, settings);
    image.unwrap_or_else(|error| panic!("{error}: {settings:?} {:?}", model.mesh.positions()))
}

/// Every mode draws the scene, over the same pixels, with finite colours.
fn all_modes_draw(model: &Model, projection: Projection, what: &str) {
    let plain = linear(SIZE);
    let expected = draw(model, projection, None, &RenderSettings { show: Show::Facing, ..plain }).coverage;
    let check = |settings: RenderSettings, paint: Option<&[LinearRgb]>| {
        let image = draw(model, projection, paint, &settings);
        let colours = image.linear.unwrap();
        let bad = colours.as_flattened().iter().find(|c| !c.is_finite() || **c < 0.0);
        assert_eq!(bad, None, "{what}, {settings:?}");
        if paint.is_some() {
            // The hull of the corners' colours, up to roundings of single precision.
            let bad = colours.as_flattened().iter().find(|c| **c > 1.00001);
            assert_eq!(bad, None, "{what}, {settings:?}");
        }
        assert!(image.coverage == expected, "{what}, {settings:?}: other pixels are covered");
    };
    let given: Vec<LinearRgb> =
        (0..model.mesh.vertex_count()).map(|k| LinearRgb::new(1.0, (k % 2) as f64, 0.0)).collect();
    for interpolation in INTERPOLATIONS {
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            check(RenderSettings { shading, interpolation, ..plain }, None);
        }
        check(RenderSettings { interpolation, show: Show::Normals, ..plain }, None);
        check(RenderSettings { interpolation, shading: Shading::Gouraud, ..plain }, Some(&given));
    }
    for show in [Show::Depth, Show::Facing, Show::FaceId, Show::Deviation(crease::num::Degrees(15.0))] {
        check(RenderSettings { show, ..plain }, None);
    }
}

/// The hit of a triangle by the ray through a point of the picture, computed in `f64` by edge functions in homogeneous
/// coordinates (Olano & Greer 1997), or by those of the plane in a parallel projection.
enum Met {
    No,
    /// Rounding, or the snapping of corners, decides.
    Perhaps,
    Yes(Meeting),
}

#[derive(Clone, Copy)]
struct Meeting {
    /// Larger is nearer, linear on the picture: AWAY/z less a level, or −z in pixels.
    depth: f64,
    /// How far single precision and snapping may move that.
    room: f64,
    /// Barycentric, in the scene.
    weights: DVec3,
}

/// Corners are snapped to 1/256 of a pixel, so that an edge is at most 1/362 off; with a wide margin.
const SNAPPED: f64 = 1.0 / 64.0;
/// Rounding of a sum of products of doubles, with a wide margin.
const ROUNDED: f64 = 1e-14;

fn meet(projection: Projection, corners: [DVec3; 3], at: DVec2) -> Met {
    let [width, height] = SIZE.map(f64::from);
    let from_middle = DVec2::new(at.x - 0.5 * width, 0.5 * height - at.y);
    let seen = corners.map(|c| DVec3::new(c.x, c.y, AWAY - c.z));
    let at = |k: usize| (seen[(k + 1) % 3], seen[(k + 2) % 3]);
    // For each corner: the function of the opposite edge, its growth by pixels, what rounding may do to it.
    let (edges, scale) = match projection {
        Projection::Perspective(angle) => {
            let scale = 0.5 * height / libm::tan(0.5 * angle.0);
            let ray = (from_middle / scale).extend(1.0);
            let edge = |k: usize| {
                let (b, c) = at(k);
                let normal = b.cross(c);
                let terms = DVec3::new(
                    (b.y * c.z).abs() + (b.z * c.y).abs(),
                    (b.z * c.x).abs() + (b.x * c.z).abs(),
                    (b.x * c.y).abs() + (b.y * c.x).abs(),
                );
                (ray.dot(normal), normal.truncate() / scale, ray.abs().dot(terms) * ROUNDED)
            };
            ([0, 1, 2].map(edge), scale)
        }
        Projection::Orthographic(tall) => {
            let scale = height / tall;
            let place = from_middle / scale;
            let edge = |k: usize| {
                let (b, c) = (at(k).0.truncate() - place, at(k).1.truncate() - place);
                let (b_size, c_size) = (b.abs() + place.abs(), c.abs() + place.abs());
                let room = (b_size.x * c_size.y + b_size.y * c_size.x) * ROUNDED;
                (b.perp_dot(c), DVec2::new(b.y - c.y, c.x - b.x) / scale, room)
            };
            ([0, 1, 2].map(edge), scale)
        }
    };
    let sure = edges.map(|(edge, growth, room)| {
        let room = room + growth.length() * SNAPPED;
        if edge > room {
            1
        } else if edge < -room {
            -1
        } else {
            0
        }
    });
    if sure.contains(&1) && sure.contains(&-1) {
        return Met::No;
    }
    let values = DVec3::from(edges.map(|(edge, _, _)| edge));
    let sum = values.element_sum();
    let growth: DVec2 = edges.iter().map(|(_, growth, _)| *growth).sum();
    let room: f64 = edges.iter().map(|(_, _, room)| room).sum();
    // A linear function of the picture that is the depth, its growth, and what rounding does to it.
    let (depth, growth, room, is_in_front, largest) = match projection {
        Projection::Perspective(_) => {
            let [a, b, c] = seen;
            let volume = a.dot(b.cross(c));
            let terms = |a: DVec3, b: DVec3, c: DVec3| (a.x * b.y * c.z).abs() + (a.x * b.z * c.y).abs();
            let volume_room = (terms(a, b, c) + terms(b, c, a) + terms(c, a, b)) * ROUNDED;
            if volume.abs() <= 4.0 * volume_room {
                return Met::Perhaps;
            }
            let (near, level) = (0.006, level(projection));
            let unit = if level == 0.0 { near } else { AWAY };
            let inverse = unit * sum / volume;
            let (growth, room) = (
                unit * growth / volume,
                unit * room / volume.abs() + inverse.abs() * volume_room / volume.abs(),
            );
            let nearest = unit / near;
            let reach = room + growth.length() * SNAPPED;
            let sure = if inverse > reach && inverse < nearest - reach { 1 } else { 0 };
            let out = inverse < -reach || inverse > nearest + reach;
            (inverse - level, growth, room, if out { -1 } else { sure }, nearest)
        }
        Projection::Orthographic(_) => {
            let z = DVec3::from(seen.map(|c| c.z));
            let mean = values.dot(z) / sum;
            let growth = DVec2::new(
                (0..3).map(|k| edges[k].1.x * (z[k] - mean)).sum::<f64>() / sum,
                (0..3).map(|k| edges[k].1.y * (z[k] - mean)).sum::<f64>() / sum,
            );
            let room = (0..3).map(|k| edges[k].2 * (z[k] - mean).abs()).sum::<f64>() / sum.abs()
                + ROUNDED * values.abs().dot(z.abs()) / sum.abs();
            let reach = room + growth.length() * SNAPPED;
            let sure = if mean > reach { 1 } else { 0 };
            let largest = z.abs().max_element();
            (
                -mean * scale,
                growth * scale,
                room * scale,
                if mean < -reach { -1 } else { sure },
                largest * scale,
            )
        }
    };
    if is_in_front < 0 {
        return Met::No;
    }
    if is_in_front == 0 || sure.contains(&0) || sum == 0.0 {
        return Met::Perhaps;
    }
    // Depth is a plane in single precision, begun in a corner of the tile.
    let in_tile = (depth.abs() + growth.length() * 128.0).min(largest.max(1.0));
    let room = room + growth.length() * SNAPPED + 16.0 * f64::from(f32::EPSILON) * in_tile;
    Met::Yes(Meeting { depth, room, weights: values / sum })
}

/// The level from which depths are counted: that of the target if the eye is far away compared with the size of the view.
fn level(projection: Projection) -> f64 {
    match projection {
        Projection::Perspective(angle) if 128.0 * libm::tan(0.5 * angle.0) < 1.0 => 1.0,
        _ => 0.0,
    }
}

/// How many pixels certainly show a triangle, and how many of them were drawn with corner colours that could be checked.
#[derive(Default)]
struct Tally {
    sure: usize,
    weighed: usize,
}

/// Asserts that each pixel shows the triangle that a ray hits first.
fn rays_agree(model: &Model, projection: Projection, what: &str, tally: &mut Tally) {
    let count = model.mesh.face_count();
    let triangles: Vec<[DVec3; 3]> = (0..count)
        .map(|face| {
            let corners = model.mesh.faces().face(face);
            [0, 1, 2].map(|k| model.mesh.positions().at(corners[k]))
        })
        .collect();
    let numbers: Vec<LinearRgb> = (0..3 * count).map(|k| LinearRgb::grey((k / 3 + 1) as f64)).collect();
    let ends = [LinearRgb::new(1.0, 0.0, 0.0), LinearRgb::new(0.0, 1.0, 0.0), LinearRgb::new(0.0, 0.0, 1.0)];
    let ends: Vec<LinearRgb> = (0..3 * count).map(|k| ends[k % 3]).collect();
    let settings =
        RenderSettings { shading: Shading::Flat, flat_sample: FlatSample::VertexMean, ..linear(SIZE) };
    let owners = draw(model, projection, Some(&numbers), &settings).linear.unwrap();
    let settings = RenderSettings { shading: Shading::Gouraud, ..settings };
    let weights = draw(model, projection, Some(&ends), &settings).linear.unwrap();
    for (pixel, (owner, weights)) in owners.iter().zip(&weights).enumerate() {
        let at = DVec2::new((pixel % SIZE[0] as usize) as f64 + 0.5, (pixel / SIZE[0] as usize) as f64 + 0.5);
        let met: Vec<Met> = triangles.iter().map(|corners| meet(projection, *corners, at)).collect();
        let sure =
            met.iter().filter_map(|met| if let Met::Yes(meeting) = met { Some(*meeting) } else { None });
        let nearest = sure.map(|m| m.depth - m.room).fold(f64::NEG_INFINITY, f64::max);
        let what = || format!("{what}, pixel {at} shows {}: {triangles:?}", owner[0]);
        let Some(number) = (owner[0].round() as usize).checked_sub(1) else {
            assert_eq!(nearest, f64::NEG_INFINITY, "{}, but not what is there", what());
            continue;
        };
        match &met[number] {
            Met::No => panic!("{}, which is elsewhere", what()),
            Met::Perhaps => {}
            Met::Yes(meeting) => {
                let behind = nearest - (meeting.depth + meeting.room);
                assert!(behind <= 0.0, "{}, {behind} behind what is in front", what());
                tally.sure += 1;
                // Snapping may move a corner, so any value within that distance is right.
                let around = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y];
                let around =
                    around.map(|step| match meet(projection, triangles[number], at + step * SNAPPED) {
                        Met::Yes(near) => Some((near.weights - meeting.weights).abs().max_element()),
                        _ => None,
                    });
                let [Some(a), Some(b), Some(c), Some(d)] = around else { continue };
                let room = 2.0 * a.max(b).max(c).max(d) + 1e-5;
                let got = DVec3::from(weights.map(f64::from));
                let error = (got - meeting.weights).abs().max_element();
                assert!(error < room, "{}, weights {got} and not {}", what(), meeting.weights);
                tally.weighed += 1;
            }
        }
    }
}

fn sweep(seed: u64, rounds: usize) -> Tally {
    let mut random = Random(seed);
    let mut tally = Tally::default();
    for round in 0..rounds {
        let reach = [30.0, 30.0, 6.0, 1.0][round % 4];
        let mut wild = |count, shared| wild(&mut random, reach, count, shared);
        let (apart, others) = (wild([20, 3], false), [wild([20, 3], true), wild([6, 5], false)]);
        for projection in projections() {
            let what = format!("seed {seed}, round {round}, {projection:?}");
            all_modes_draw(&apart, projection, &what);
            rays_agree(&apart, projection, &what, &mut tally);
            for other in &others {
                all_modes_draw(other, projection, &what);
            }
        }
    }
    tally
}

/// Most of the 10 800 pixels of a round certainly show one triangle.
#[test]
fn extreme_corners_are_drawn_where_rays_meet_them() {
    let rounds = if crate::hostile::is_long() { 400 } else { 4 };
    let tally = sweep(1, rounds);
    assert!(tally.sure > 5000 * rounds && tally.weighed > 5000 * rounds, "{} {}", tally.sure, tally.weighed);
}

/// A probe reports the colour that the picture shows.
#[test]
fn probes_tell_what_pictures_of_extreme_corners_show() {
    let mut random = Random(3);
    let mut probed = 0;
    for round in 0..12 {
        let model = wild(&mut random, [30.0, 6.0, 1.0][round % 3], [20, 3], false);
        for projection in projections() {
            let settings = linear(SIZE);
            let camera = camera(projection);
            let lights = default_lights(&camera).to_vec();
            let scene = Scene { camera, lights, ..scene(vec![model.object()]) };
            let image = render(&scene, &settings).unwrap();
            for _ in 0..4 {
                let pixel = [0, 1].map(|axis| random.below(SIZE[axis] as usize) as u32);
                let Some(seen) = probe(&scene, &settings, pixel, 0).unwrap() else { continue };
                let reported = seen.colour().to_array();
                let shown = image.linear.as_ref().unwrap()[(pixel[1] * SIZE[0] + pixel[0]) as usize];
                let error =
                    shown.iter().zip(reported).map(|(a, b)| (f64::from(*a) - b).abs()).fold(0.0, f64::max);
                // A step of 8 bits.
                assert!(error < 1.0 / 255.0, "round {round}, {projection:?}, {pixel:?}: {shown:?}, {seen:?}");
                probed += 1;
            }
        }
    }
    assert!(probed > 200, "{probed}");
}

/// With three corners so far from each other, every digit of 1/z is lost if depths are counted from the target.
#[test]
fn a_narrow_view_of_the_horizon_is_drawn() {
    let corners = [
        DVec3::new(-4_768_120_973.0, 1.2e-8, -8.2e19),
        DVec3::new(33_886_869.0, 0.0288, -2.5e-17),
        DVec3::new(1.09, -3.06e12, -0.63),
    ];
    let model = Model::polygon(&corners);
    let projection = Projection::Perspective(Degrees(0.001).into());
    all_modes_draw(&model, projection, "narrow");
    rays_agree(&model, projection, "narrow", &mut Tally::default());
}
