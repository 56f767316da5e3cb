//! Face normals against exact arithmetic: rational cross products, a 256-bit root.

use crate::mesh::{Faces, MeshBuilder, Positions, Storage};
use crate::normals::compute::compute;
use crate::normals::faces::face_normals::FaceNormals;
use crate::normals::faces::face_normals::face_normals;
use crate::normals::faces::shape::FaceState;
use crate::normals::fault::{Fault, FaultReason};
use crate::normals::recipe::NormalRecipe;
use crate::normals::scratch::Scratch;
use crate::num::power_of_two;
use crate::num::test_numbers::Numbers;
use crate::trade::exact::{distance, error_in_ulps, face_normal};
use glam::DVec3;

/// How many cases of each kind: the sum over kinds is above 50 000, or a million with `CREASE_LONG=1`.
fn cases() -> usize {
    if std::env::var_os("CREASE_LONG").is_some_and(|value| value == "1") { 130_000 } else { 6_500 }
}

/// Polygons that are hard on cross products, with `f32` coordinates: one kind after the other.
fn hard_polygon(numbers: &mut Numbers, kind: usize, corners: usize) -> Vec<DVec3> {
    let any = |numbers: &mut Numbers| loop {
        let x = f32::from_bits(numbers.bits() as u32);
        if x.is_finite() {
            break f64::from(x);
        }
    };
    let point = |numbers: &mut Numbers, scale: f64| {
        DVec3::from(std::array::from_fn(|_| (2.0 * numbers.unit() - 1.0) * scale))
    };
    let round = |p: DVec3| DVec3::from(p.to_array().map(|x| f64::from(x as f32)));
    let scale = power_of_two(numbers.below(235) as i32 - 122);
    let vertex = |numbers: &mut Numbers, i: usize, first: DVec3, along: DVec3| match kind {
        // The whole range of f32, subnormals included, every coordinate for itself.
        0 => DVec3::from(std::array::from_fn(|_| any(numbers))),
        // Well-shaped, at any scale.
        1 => point(numbers, scale),
        // Far from the origin.
        2 => first * power_of_two(10 + i as i32 % 2) + point(numbers, scale * 1e-3),
        // Nearly collinear: rounding alone gives it an area.
        3 => first + along * (numbers.unit() * i as f64),
        // Corners a few steps of f32 apart.
        4 if i == 1 => first * (1.0 + 3e-7 * numbers.unit()),
        4 => first + along * i as f64,
        // A flat face with a tilt at the end of what its exponents allow.
        5 => DVec3::new(numbers.unit(), numbers.unit(), numbers.unit() * 1e-30 + 1e-36 * i as f64),
        // Nothing but subnormals.
        6 => DVec3::from(std::array::from_fn(|_| {
            f64::from(f32::from_bits(numbers.bits() as u32 & 0x803f_ffff))
        })),
        // Small whole numbers: degenerate often, and then exactly.
        _ => DVec3::from(std::array::from_fn(|_| numbers.below(4) as f64)),
    };
    let (first, along) = (point(numbers, scale), point(numbers, scale));
    let first = if kind >= 5 { vertex(numbers, 0, first, along) } else { first };
    let mut polygon = vec![round(first)];
    polygon.extend((1..corners).map(|i| round(vertex(numbers, i, first, along))));
    polygon
}

const KINDS: usize = 8;

/// The cross product as it is usually written.
fn naive(points: &[DVec3]) -> [f32; 3] {
    let [p, q, r] = [0, 1, 2].map(|i| points[i].as_vec3());
    let cross = (q - p).cross(r - p);
    (cross / cross.length()).to_array()
}

#[test]
fn triangles_of_f32_are_right_to_an_ulp_or_exactly_degenerate() {
    let mut numbers = Numbers::new(0xface);
    let (mut worst, mut degenerate, mut naive_wrong) = (0.0, 0, 0);
    for kind in 0..KINDS {
        let polygons: Vec<Vec<DVec3>> = (0..cases()).map(|_| hard_polygon(&mut numbers, kind, 3)).collect();
        let positions: Vec<[f32; 3]> = polygons.iter().flatten().map(|p| p.as_vec3().to_array()).collect();
        let triangles: Vec<[u32; 3]> =
            (0..polygons.len() as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
        let mut normals = vec![[0.0; 3]; polygons.len()];
        let faults =
            crate::normals::face_normals(&positions, &triangles, &mut Scratch::new(), &mut normals).unwrap();
        let mut without = faults
            .faces
            .iter()
            .filter(|fault| fault.reason == crate::normals::FaultReason::ZeroArea)
            .peekable();
        for (i, polygon) in polygons.iter().enumerate() {
            let reported = without.next_if(|fault| fault.index as usize == i).is_some();
            let Some(truth) = face_normal(polygon) else {
                assert!(reported, "kind {kind}: a degenerate triangle was not found: {polygon:?}");
                degenerate += 1;
                continue;
            };
            assert!(!reported, "kind {kind}: {polygon:?} is not degenerate");
            let error = error_in_ulps(normals[i], &truth);
            assert!(error <= 1.0, "kind {kind}: {error} ulp: {polygon:?}");
            worst = f64::max(worst, error);
            let close = error_in_ulps(naive(polygon), &truth) <= 1.0;
            naive_wrong += usize::from(!close);
        }
    }
    // Rounding to f32 itself takes half an ulp; f64 arithmetic adds next to nothing.
    assert!(worst <= 0.500_001, "{worst}");
    assert!(degenerate > cases() / 20, "{degenerate} degenerate triangles are too few to tell");
    assert!(naive_wrong > 3 * cases(), "only {naive_wrong} triangles fail a plain f32 cross product");
}

/// The faces as a mesh of either storage.
fn normals_of(polygons: &[Vec<DVec3>], storage: Storage) -> FaceNormals {
    let points: Vec<DVec3> = polygons.iter().flatten().copied().collect();
    let mut faces = Faces::new();
    let mut next = 0..;
    for polygon in polygons {
        faces.push(&next.by_ref().take(polygon.len()).collect::<Vec<u32>>());
    }
    face_normals(faces.view(), Positions::rounded(points, storage).view())
}

#[test]
fn quads_of_f32_are_right_to_an_ulp_or_exactly_degenerate() {
    let mut numbers = Numbers::new(0xfade);
    for kind in 0..KINDS {
        let polygons: Vec<_> = (0..cases() / 5).map(|_| hard_polygon(&mut numbers, kind, 4)).collect();
        let normals = normals_of(&polygons, Storage::F32);
        for (i, polygon) in polygons.iter().enumerate() {
            match face_normal(polygon) {
                None => assert_eq!(normals.state[i], FaceState::ZeroArea, "kind {kind}: {polygon:?}"),
                Some(truth) => {
                    let error = error_in_ulps(normals.unit[i].as_vec3().to_array(), &truth);
                    assert!(error <= 0.500_001, "kind {kind}: {error} ulp: {polygon:?}");
                }
            }
        }
    }
}

/// What (B) promises.
fn check_angles(polygons: &[Vec<DVec3>], storage: Storage) -> usize {
    let normals = normals_of(polygons, storage);
    let mut out_of_range = 0;
    for (i, polygon) in polygons.iter().enumerate() {
        match (face_normal(polygon), normals.state[i]) {
            (None, state) => assert_eq!(state, FaceState::ZeroArea, "{polygon:?}"),
            (Some(_), FaceState::OutOfRange) => out_of_range += 1,
            (Some(truth), state) => {
                assert!(state.has_direction(), "{state:?}: {polygon:?}");
                let error = distance(normals.unit[i], &truth);
                assert!(error <= 1e-12, "{error:e} rad: {polygon:?}");
            }
        }
    }
    out_of_range
}

#[test]
fn polygons_of_f32_are_right_to_a_millionth_of_a_millionth() {
    let mut numbers = Numbers::new(0xfeed);
    for kind in 0..KINDS {
        let polygons: Vec<_> =
            (0..cases() / 10).map(|i| hard_polygon(&mut numbers, kind, 5 + i % 7)).collect();
        assert_eq!(check_angles(&polygons, Storage::F32), 0);
    }
}

#[test]
fn faces_of_f64_are_right_to_a_millionth_of_a_millionth() {
    let mut numbers = Numbers::new(0xf64);
    let perturb = |numbers: &mut Numbers, p: DVec3| {
        DVec3::from(
            p.to_array().map(|x| x * (1.0 + (numbers.unit() - 0.5) * [0.0, 1e-9, 1e-15][numbers.below(3)])),
        )
    };
    for kind in 0..KINDS {
        let polygons = (0..cases() / 5).map(|i| {
            let polygon = hard_polygon(&mut numbers, kind, 3 + i % 5);
            polygon.into_iter().map(|p| perturb(&mut numbers, p)).collect()
        });
        let polygons: Vec<Vec<DVec3>> = polygons.collect();
        assert_eq!(check_angles(&polygons, Storage::F64), 0, "kind {kind}");
    }
}

#[test]
fn coordinates_at_the_ends_of_f64_are_right_or_reported() {
    let mut numbers = Numbers::new(0xe308);
    for exponent in [-1060, -1000, -640, -330, 330, 640, 1000, 1022] {
        let polygons: Vec<Vec<DVec3>> = (0..200)
            .map(|i| (0..3 + i % 4).map(|_| DVec3::from(std::array::from_fn(|_| numbers.unit()))).collect())
            .map(|polygon: Vec<DVec3>| polygon.into_iter().map(|p| crate::num::scale(p, exponent)).collect())
            .collect();
        assert_eq!(check_angles(&polygons, Storage::F64), 0, "2^{exponent}");
    }
    // Every coordinate has a magnitude of its own: normals are right, or reported as out of range.
    let polygons: Vec<Vec<DVec3>> = (0..2000)
        .map(|i| (0..3 + i % 3).map(|_| DVec3::from(std::array::from_fn(|_| numbers.spread(1020)))).collect())
        .collect();
    let out_of_range = check_angles(&polygons, Storage::F64);
    assert!((1..2000).contains(&out_of_range), "{out_of_range}");
}

/// As docs/normals.md states: only faces with coordinates below 2⁻¹¹⁴⁰ of the largest one, or of a height below 2⁻⁶⁰⁰ of their
/// length, are out of range.
#[test]
fn faces_are_out_of_range_beyond_the_documented_limits_only() {
    let mut numbers = Numbers::new(0x1140);
    // A large face with a coordinate of 2¹⁰⁰⁰, and one with coordinates from 1 to 3 times some powers of two.
    let mut faces = |corners: usize, size: i32, height: i32| {
        let mut point = |i: usize| {
            let angle = i as f64 + 0.5 * numbers.unit();
            let [x, y] = [libm::cos(angle), libm::sin(angle)].map(|x| 2.0 + x);
            crate::num::scale(DVec3::new(x, power_of_two(height) * y, 0.0), size)
        };
        let large = [DVec3::ZERO, DVec3::X, DVec3::Y].map(|p| crate::num::scale(p, 1000));
        [large.to_vec(), (0..corners).map(&mut point).collect()]
    };
    for corners in 3..=6 {
        for _ in 0..50 {
            let within = [faces(corners, -140, 0), faces(corners, 900, -596)];
            assert_eq!(within.map(|polygons| check_angles(&polygons, Storage::F64)), [0, 0], "{corners}");
            let beyond = [faces(corners, -160, 0), faces(corners, 900, -640)];
            let states = beyond.map(|polygons| normals_of(&polygons, Storage::F64).state);
            let expected = [FaceState::Counted, FaceState::OutOfRange];
            assert_eq!(states, [expected, expected], "{corners}");
        }
    }
    let positions: Vec<DVec3> = faces(3, -160, 0).concat();
    let faces = Faces::triangles((0..6).collect());
    let mesh = MeshBuilder { positions: positions.into(), faces, ..MeshBuilder::default() }.build().unwrap();
    let field = compute(&mesh, &NormalRecipe::default());
    assert_eq!(field.faults.faces, [Fault { index: 1, reason: FaultReason::OutOfRange }]);
    assert_eq!(field.faults.corners.len(), 3);
}
