//! Positions that are not finite: they must be reported and must not spread.

use super::fans::{WEIGHTS, faithful};
use super::prelude::*;
use crate::mesh::MeshError;

/// Vertices along the side of a bumpy sheet.
const SIDE: usize = 9;
const MIDDLE: usize = SIDE * SIDE / 2;

pub(super) fn cases() -> Vec<StressCase> {
    let all = [("NaN", f32::NAN), ("infinity", f32::INFINITY), ("minus infinity", f32::NEG_INFINITY)];
    let case = |(name, bad)| {
        let bounds = (Bound::none_wrong("non-finite-bound"), None);
        StressCase::new(Group::NonFinite, "non-finite", name, bounds, move || measure(bad))
    };
    all.map(case).into()
}

fn measure(bad: f32) -> Measured {
    let (mut positions, triangles) = sheet();
    let touches = |triangle: &[u32; 3]| triangle.contains(&(MIDDLE as u32));
    let others: Vec<[u32; 3]> = triangles.iter().copied().filter(|triangle| !touches(triangle)).collect();
    let expected_faces = normals_of_faces(&positions, &triangles).0;
    let expected = WEIGHTS.map(|weight| faithful(&positions, &others, weight, Slivers::Exclude));
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
        let normals = faithful(&positions, &triangles, weight, Slivers::Exclude);
        let is_wrong = |vertex: &usize| match *vertex {
            MIDDLE => !is_unit(normals[MIDDLE]),
            vertex => normals[vertex] != expected[vertex],
        };
        wrong += (0..positions.len()).filter(is_wrong).count();
    }
    let builder = MeshBuilder {
        positions: positions.iter().map(|p| p.as_dvec3()).collect(),
        faces: Faces::triangles(triangles.as_flattened().to_vec()),
        ..MeshBuilder::default()
    };
    wrong += usize::from(!matches!(builder.build(), Err(MeshError::NonFinite { vertex: MIDDLE, .. })));

    let around = |vertex: usize| -> Vec<[Vec3; 2]> {
        let turned =
            |t: &[u32; 3]| (0..3).find(|&k| t[k] as usize == vertex).map(|k| [1, 2].map(|i| t[(k + i) % 3]));
        triangles.iter().filter_map(turned).map(|pair| pair.map(|v| positions[v as usize])).collect()
    };
    let plain_normal = |vertex| plain::vertex_normal(positions[vertex], &around(vertex), Weight::Uniform);
    let plain = (0..positions.len()).map(|vertex| plain::direction(plain_normal(vertex)));
    let undefined = plain.filter(|normal| normal.is_nan()).count();
    Measured {
        samples: triangles.len() + WEIGHTS.len() * positions.len() + 1,
        faithful: Worst::wrong(wrong),
        plain: Some(Worst { error: 0.0, undefined }),
        ..Measured::default()
    }
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
