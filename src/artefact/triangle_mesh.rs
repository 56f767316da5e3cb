//! Bodies of triangles whose normals are chosen, not computed.

use crate::raster::{Object, Shape, Triangles};
use crate::shade::Material;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The corners of a box about the origin. Bits of their numbers say on which side of each axis they lie.
pub(super) fn box_corners(sides: DVec3) -> Vec<DVec3> {
    let sign = |k: u32, bit: u32| if k >> bit & 1 == 0 { -0.5 } else { 0.5 };
    (0..8).map(|k| sides * DVec3::new(sign(k, 0), sign(k, 1), sign(k, 2))).collect()
}

/// The faces of a box by its corners, counter-clockwise from outside: of each axis the low and the high one.
pub(super) const BOX_FACES: [[u32; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

#[derive(Clone, Debug)]
pub(super) struct TriangleMesh {
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) face_normals: Vec<[f32; 3]>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Diagonal {
    /// From the lower left to the upper right.
    Rising,
    /// From the upper left to the lower right.
    Falling,
}

impl TriangleMesh {
    /// Triangles with area only: others have no normal and are left out.
    pub(super) fn new(positions: &[DVec3], triangles: Vec<[u32; 3]>, normals: &[DVec3]) -> Self {
        let single = |v: &DVec3| v.as_vec3().to_array();
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|vertex| positions[vertex as usize]);
            (b - a).cross(c - a).try_normalize()
        };
        let (triangles, face_normals) =
            triangles.into_iter().filter_map(|t| Some((t, area(&t)?.as_vec3().to_array()))).unzip();
        Self {
            positions: positions.iter().map(single).collect(),
            triangles,
            normals: normals.iter().map(single).collect(),
            face_normals,
        }
    }

    /// Squares over 0…1 by 0…1, so many each way, cut into triangles; `point` gives a place and its normal.
    pub(super) fn grid(
        cells: [u32; 2],
        diagonal: Diagonal,
        point: impl Fn(f64, f64) -> (DVec3, DVec3),
    ) -> Self {
        let [columns, rows] = cells;
        let at = |k: u32| {
            let (u, v) = (k % (columns + 1), k / (columns + 1));
            point(f64::from(u) / f64::from(columns), f64::from(v) / f64::from(rows))
        };
        let (positions, normals): (Vec<DVec3>, Vec<DVec3>) = (0..(columns + 1) * (rows + 1)).map(at).unzip();
        let cut = |k: u32| {
            let a = k / columns * (columns + 1) + k % columns;
            let (b, c, d) = (a + 1, a + columns + 2, a + columns + 1);
            match diagonal {
                Diagonal::Rising => [[a, b, c], [a, c, d]],
                Diagonal::Falling => [[a, b, d], [b, c, d]],
            }
        };
        Self::new(&positions, (0..columns * rows).flat_map(cut).collect(), &normals)
    }

    /// The unit sphere with its own normals: circles of so many vertices around the y axis, of which one is the
    /// equator. A vertex of the equator is rotated from +z to the right by an angle in radians.
    pub(super) fn globe(segments: u32, turn: f64) -> Self {
        let rows = 2 * segments.div_ceil(4);
        Self::grid([segments, rows], Diagonal::Rising, |u, v| {
            let (latitude, longitude) = (PI * (v - 0.5), TAU * u + turn);
            // Of the poles, exactly one point each, so that their triangles are seen to have no area.
            let ring = if v == 0.0 || v == 1.0 { 0.0 } else { libm::cos(latitude) };
            let place =
                DVec3::new(ring * libm::sin(longitude), libm::sin(latitude), ring * libm::cos(longitude));
            (place, place)
        })
    }

    pub(super) fn object(&self, material: Material) -> Object<'_> {
        let Self { positions, triangles, normals, face_normals } = self;
        Object::new(Shape::Triangles(Triangles { positions, triangles, normals, face_normals }), material)
    }
}
