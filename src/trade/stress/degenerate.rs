//! Faces of little or no area, and positions that are not finite, which must be reported and must not spread.

use super::face_normals::{self, FAST, Triangle};
use super::fans::{self, Fan, WEIGHTS};
use super::prelude::*;
use crate::mesh::MeshError;
use crate::trade::exact;

/// Height over length.
const THINNESS: [f64; 8] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-12];
const TRIANGLES: usize = 300;
/// The spacing of `f32` numbers near 1.
const SPACING: f32 = f32::EPSILON;
/// The bounds of a vertex normal that degenerate faces must not change.
const UNCHANGED: (Bound, Option<Bound>) = (Bound::new(3e-6, Unit::Degrees, "unchanged-bound"), Some(FAST));

pub(super) fn sliver_cases() -> Vec<StressCase> {
    let slivers = THINNESS.map(|thinness| {
        let name = format!("height/length {thinness:.0e}");
        face_normals::case(Group::Needle, "slivers", name, move || thin_triangles(thinness))
    });
    let bound = Bound::none_wrong("sliver-threshold-bound");
    let bounds = (bound, Some(bound));
    let others = [
        StressCase::new(Group::Needle, "sliver-threshold", "sliver threshold", bounds, measure_threshold),
        StressCase::new(
            Group::Needle,
            "next-to-sliver",
            "vertex next to a sliver",
            UNCHANGED,
            measure_neighbour,
        ),
    ];
    slivers.into_iter().chain(others).collect()
}

/// Long sides in any direction; one half with a corner at the origin, where numbers are finest.
fn thin_triangles(thinness: f64) -> Vec<Triangle> {
    let mut numbers = Numbers::new(4);
    let triangle = |i: usize| {
        let along = vector(&mut numbers).normalize();
        let across = along.cross(vector(&mut numbers)).normalize();
        let start = if i.is_multiple_of(2) { DVec3::ZERO } else { vector(&mut numbers) };
        let apex = along * numbers.unit() + across * thinness;
        [start, start + along, start + apex].map(|corner| corner.as_vec3())
    };
    (0..TRIANGLES).map(triangle).collect()
}

/// Heights of 1 to 8 spacings over a base from 1 to 1.75, along each pair of axes, at three sizes.
fn measure_threshold() -> Measured {
    let (mut samples, mut declined, mut wrong) = (0, 0, [0; 4]);
    for spacings in 1..=8_u8 {
        for axis in 0..3 {
            let point = |along: f32, up: f32| {
                let mut point = [0.0; 3];
                (point[axis], point[(axis + 1) % 3]) = (along, up);
                point
            };
            for size in [1_048_576.0, 1.0, 1.0 / 1_048_576.0] {
                let height = f32::from(spacings) * SPACING;
                let corners = [point(1.0, 0.0), point(1.75, 0.0), point(1.25, height)];
                let corners = corners.map(|corner| corner.map(|x| x * size));
                let faults = face_normals(&corners, &[[0, 1, 2]], &mut Scratch::new(), &mut [[0.0; 3]]);
                let faults = faults.expect("slices of matching lengths").faces;
                let [a, b, c] = corners.map(Vec3::from);
                let fast = face_normals::fast(&[a, b, c]);
                let [e1, e2] = [b - a, c - a].map(|e| e.as_dvec3());
                let is_sliver = [
                    faults.iter().any(|fault| fault.reason == FaultReason::BelowStorage),
                    fast.fault == Some(FaultReason::BelowStorage),
                    (b - a).cross(c - a).length() < 1e-6,
                    e1.cross(e2).length() < 1e-6,
                ];
                samples += 1;
                declined += usize::from(fast.declined);
                for (wrong, is_sliver) in wrong.iter_mut().zip(is_sliver) {
                    *wrong += usize::from(is_sliver != (spacings < 4));
                }
            }
        }
    }
    let [faithful, fast, plain, definition] = wrong;
    let measured = Measured::wrong(samples, [faithful, plain, definition]);
    Measured { fast: Some(Worst::wrong(fast)), declined, ..measured }
}

/// A sliver, whose direction is rounding, must not change the normal of a vertex.
fn measure_neighbour() -> Measured {
    const FANS: usize = 50;
    let mut numbers = Numbers::new(5);
    let (mut declined, mut definition) = (0, Worst::default());
    let outcomes = [0; FANS].map(|_| {
        let mut fan = Fan::cone(6, 0.3);
        let truth = fan.true_normal(Weight::Uniform);
        // Half way to the rim, but for a spacing.
        let [a, _] = fan.triangles[numbers.below(6)];
        let off = vector(&mut numbers).as_vec3() * SPACING;
        fan.triangles.push([a, fan.centre + (a - fan.centre) * 0.5 + off]);
        let (positions, indices) = (fan.positions(), fan.indices());
        let faithful = fans::faithful(&positions, &indices, Weight::Uniform, Slivers::Exclude)[0];
        let mesh = face_normals::indexed(&positions, &indices);
        let fast = fans::fast(&mesh, Weight::Uniform, Slivers::Exclude);
        declined += usize::from(fast.summary.fast_declined);
        let plain = plain::vertex_normal(fan.centre, &fan.triangles, Weight::Uniform).as_dvec3();
        definition.add(small(&exact::angle(&fan.true_normal(Weight::Uniform), &truth)).to_degrees());
        [faithful, fast.normals.values[0], plain].map(|normal| Outcome::degrees(normal, &truth))
    });
    Measured { declined, definition, ..Measured::triples(outcomes) }
}

pub(super) fn zero_area_cases() -> Vec<StressCase> {
    vec![
        reported_case("collinear", "exactly collinear", collinear_points),
        reported_case("duplicate", "duplicate points", duplicate_points),
        reported_case("far-collinear", "collinear far away", far_collinear_points),
        face_normals::case(Group::Degenerate, "off-line", "one spacing off a line", || {
            sample(off_line_points)
        }),
        StressCase::new(
            Group::Degenerate,
            "next-to-zero-area",
            "vertex next to zero-area faces",
            UNCHANGED,
            || {
                let mut fan = Fan::cone(6, 0.3);
                let (centre, [a, b]) = (fan.centre, fan.triangles[0]);
                fan.triangles.extend([[a, a], [centre, b], [centre, centre]]);
                // 0/0 in any arithmetic.
                fans::measure(&[fan], &WEIGHTS).by_definition()
            },
        ),
    ]
}

/// Every triangle has zero area, which exact arithmetic confirms, and has to be reported.
fn reported_case(texts: &'static str, name: &str, triangle: fn(&mut Numbers) -> Triangle) -> StressCase {
    let bound = Bound::none_wrong("zero-area-bound");
    StressCase::new(Group::Degenerate, texts, name, (bound, Some(bound)), move || {
        let triangles = sample(triangle);
        let is_unit = |normal: [f32; 3]| (Vec3::from(normal).length() - 1.0).abs() < 1e-6;
        let results = face_normals::faithful(&triangles);
        let wrong = triangles.iter().zip(results).filter(|(corners, (normal, is_degenerate))| {
            let truth = exact::degenerate(&corners.map(|corner| corner.as_dvec3()));
            *is_degenerate != truth || !truth || !is_unit(*normal)
        });
        let fast: Vec<_> = triangles.iter().map(face_normals::fast).collect();
        let missed = fast.iter().filter(|fast| {
            fast.fault != Some(FaultReason::ZeroArea) || !is_unit(fast.normal.as_vec3().to_array())
        });
        let samples = triangles.len();
        let plain = triangles.iter().map(|triangle| Outcome::vector(face_normals::plain(triangle), |_| 1.0));
        let plain: Worst = plain.collect();
        Measured {
            samples,
            faithful: Worst::wrong(wrong.count()),
            fast: Some(Worst::wrong(missed.count())),
            declined: fast.iter().filter(|fast| fast.declined).count(),
            plain: Some(Worst { error: (samples - plain.undefined()) as f64, ..plain }),
            // 0/0.
            definition: Worst::not_a_number(samples),
        }
    })
}

fn sample(triangle: impl Fn(&mut Numbers) -> Triangle) -> Vec<Triangle> {
    let mut numbers = Numbers::new(6);
    (0..TRIANGLES).map(|_| triangle(&mut numbers)).collect()
}

/// A vector of whole numbers up to a limit, not zero.
fn whole(numbers: &mut Numbers, limit: usize) -> Vec3 {
    let mut one = || numbers.below(2 * limit + 1) as f32 - limit as f32;
    let v = Vec3::new(one(), one(), one());
    if v == Vec3::ZERO { Vec3::X } else { v }
}

fn collinear_points(numbers: &mut Numbers) -> Triangle {
    let (start, along) = (whole(numbers, 1000), whole(numbers, 1000));
    let size = libm::ldexpf(1.0, numbers.below(40) as i32 - 20);
    [0.0, 1.0, 2.0 + numbers.below(9) as f32].map(|times| (start + along * times) * size)
}

fn far_collinear_points(numbers: &mut Numbers) -> Triangle {
    let (start, along) = (whole(numbers, 1_000_000), whole(numbers, 100));
    [0.0, 1.0, 2.0 + numbers.below(90) as f32].map(|times| start + along * times)
}

fn duplicate_points(numbers: &mut Numbers) -> Triangle {
    let [a, b] = [0; 2].map(|_| Vec3::from_array([0; 3].map(|_| numbers.spread(30) as f32)));
    [[a, a, b], [a, b, a], [b, a, a], [a, a, a]][numbers.below(4)]
}

/// Collinear points, one moved off the line by one spacing.
fn off_line_points(numbers: &mut Numbers) -> Triangle {
    let mut corners = collinear_points(numbers);
    let axis = numbers.below(3);
    let x = &mut corners[2][axis];
    *x = if numbers.below(2) == 0 { x.next_up() } else { x.next_down() };
    corners
}

/// Vertices along the side of a bumpy sheet.
const SIDE: usize = 9;
const MIDDLE: usize = SIDE * SIDE / 2;

pub(super) fn non_finite_cases() -> Vec<StressCase> {
    let all = [("NaN", f32::NAN), ("infinity", f32::INFINITY), ("minus infinity", f32::NEG_INFINITY)];
    let case = |(name, bad)| {
        let bounds = (Bound::none_wrong("non-finite-bound"), None);
        StressCase::new(Group::NonFinite, "non-finite", name, bounds, move || measure_non_finite(bad))
    };
    all.map(case).into()
}

fn measure_non_finite(bad: f32) -> Measured {
    let (mut positions, triangles) = sheet();
    let touches = |triangle: &[u32; 3]| triangle.contains(&(MIDDLE as u32));
    let others: Vec<[u32; 3]> = triangles.iter().copied().filter(|triangle| !touches(triangle)).collect();
    let expected_faces = normals_of_faces(&positions, &triangles).0;
    let expected = WEIGHTS.map(|weight| fans::faithful(&positions, &others, weight, Slivers::Exclude));
    positions[MIDDLE].y = bad;

    let (faces, reported) = normals_of_faces(&positions, &triangles);
    let is_unit = |normal: DVec3| (normal.length() - 1.0).abs() < 1e-6;
    let faces_wrong = (0..triangles.len()).filter(|&face| {
        let (is_bad, normal) = (touches(&triangles[face]), faces[face]);
        reported.contains(&face) != is_bad
            || if is_bad { !is_unit(normal) } else { normal != expected_faces[face] }
    });
    let mut wrong = faces_wrong.count();
    for (weight, expected) in WEIGHTS.into_iter().zip(expected) {
        let normals = fans::faithful(&positions, &triangles, weight, Slivers::Exclude);
        let is_wrong = |vertex: &usize| match *vertex {
            MIDDLE => !is_unit(normals[MIDDLE]),
            vertex => normals[vertex] != expected[vertex],
        };
        wrong += (0..positions.len()).filter(is_wrong).count();
    }
    let points: Vec<DVec3> = positions.iter().map(|p| p.as_dvec3()).collect();
    let mesh = Mesh::new(points, Faces::triangles(triangles.as_flattened().to_vec()));
    wrong += usize::from(!matches!(mesh, Err(MeshError::NonFinite { vertex: MIDDLE, .. })));

    let around = |vertex: usize| -> Vec<[Vec3; 2]> {
        let turned =
            |t: &[u32; 3]| (0..3).find(|&k| t[k] as usize == vertex).map(|k| [1, 2].map(|i| t[(k + i) % 3]));
        triangles.iter().filter_map(turned).map(|pair| pair.map(|v| positions[v as usize])).collect()
    };
    let plain_normal = |vertex| plain::vertex_normal(positions[vertex], &around(vertex), Weight::Uniform);
    let plain = (0..positions.len()).map(|vertex| Outcome::vector(plain_normal(vertex).as_dvec3(), |_| 0.0));
    let measured = Measured {
        samples: triangles.len() + WEIGHTS.len() * positions.len() + 1,
        faithful: Worst::wrong(wrong),
        plain: Some(plain.collect()),
        ..Measured::default()
    };
    measured.by_definition()
}

/// Face normals, and the faces that are reported as not finite.
fn normals_of_faces(positions: &[Vec3], triangles: &[[u32; 3]]) -> (Vec<DVec3>, Vec<usize>) {
    let positions: Vec<[f32; 3]> = positions.iter().map(Vec3::to_array).collect();
    let mut normals = vec![[0.0; 3]; triangles.len()];
    let faults = face_normals(&positions, triangles, &mut Scratch::new(), &mut normals);
    let faults = faults.expect("slices of matching lengths").faces;
    let reported = faults.iter().filter(|fault| fault.reason == FaultReason::NonFinite);
    let reported = reported.map(|fault| fault.index as usize).collect();
    (normals.into_iter().map(|normal| Vec3::from(normal).as_dvec3()).collect(), reported)
}

/// A grid of squares, each cut in two, with a wave in it.
fn sheet() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let at = |x: usize, y: usize| (y * SIDE + x) as u32;
    let point = |i: usize| {
        let (x, y) = ((i % SIDE) as f64, (i / SIDE) as f64);
        DVec3::new(x, y, 0.4 * libm::sin(1.3 * x) * libm::cos(0.9 * y)).as_vec3()
    };
    let cells = (0..SIDE - 1).flat_map(|y| (0..SIDE - 1).map(move |x| (x, y)));
    let triangles = cells.flat_map(|(x, y)| {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        [[a, b, c], [a, c, d]]
    });
    ((0..SIDE * SIDE).map(point).collect(), triangles.collect())
}
