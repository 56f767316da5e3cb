//! A bicubic Bézier patch.

use crate::num::UnitVec3;
use crate::surface::error::SurfaceError;
use crate::surface::shapes::chart::{Chart, Parametric, Sample};
use glam::DVec3;

/// The patch Σ Bᵢ(v) Bⱼ(u) Pᵢⱼ over four rows of four control points, facing the way of ∂u × ∂v; B are the cubic
/// Bernstein polynomials.
///
/// # Collapsed sides
/// A side whose four control points are one point has no tangent of its own. Next to the side v = 0, ∂u is v·∂u∂v to
/// first order, so the direction of ∂u × ∂v tends to ∂u∂v × ∂v: that limit is the normal given there, one for each way of
/// approach u. Where all approaches agree (the top of the teapot's lid) the surface is smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BezierPatch {
    points: [[DVec3; 4]; 4],
}

/// A sheet bent both ways, of size about 2.
impl Default for BezierPatch {
    fn default() -> Self {
        const HEIGHTS: [[f64; 4]; 4] =
            [[0.0, 0.6, 0.6, -0.4], [0.5, 0.9, -0.6, 0.3], [-0.3, 1.2, 0.0, 0.6], [0.4, -0.5, 0.8, 0.0]];
        let place = |k: usize| 2.0 * k as f64 / 3.0 - 1.0;
        let point = |row: usize, column: usize| DVec3::new(place(column), place(row), HEIGHTS[row][column]);
        Self { points: std::array::from_fn(|row| std::array::from_fn(|column| point(row, column))) }
    }
}

impl BezierPatch {
    /// A patch of four rows of control points: u runs along a row, v from row to row.
    ///
    /// # Errors
    /// [`SurfaceError::ControlPoint`] if a coordinate is not finite or beyond 1e60.
    pub fn new(points: [[DVec3; 4]; 4]) -> Result<Self, SurfaceError> {
        let largest = *crate::surface::error::LENGTHS.end();
        let wrong = |p: &DVec3| !(p.is_finite() && p.abs().max_element() <= largest);
        match points.as_flattened().iter().position(wrong) {
            Some(index) => Err(SurfaceError::ControlPoint { row: index / 4, column: index % 4 }),
            None => Ok(Self { points }),
        }
    }

    /// The control points, row by row.
    pub fn points(&self) -> &[[DVec3; 4]; 4] {
        &self.points
    }

    /// The control points of a side: v = 0, v = 1, u = 0, u = 1, each in the direction of the parameter that varies.
    pub(in crate::surface) fn sides(&self) -> [[DVec3; 4]; 4] {
        let column = |k: usize| self.points.map(|row| row[k]);
        [self.points[0], self.points[3], column(0), column(3)]
    }

    /// The point of two parameters and ∂u × ∂v there, or its limit on a collapsed side.
    fn point_and_normal(&self, u: f64, v: f64) -> (DVec3, DVec3) {
        let rows = self.points.map(|row| curve(row, u));
        let (position, dv) = curve(rows.map(|row| row.0), v);
        let (du, mixed) = curve(rows.map(|row| row.1), v);
        let [low_v, high_v, low_u, high_u] = self.sides().map(|side| side == [side[0]; 4]);
        let normal = match (u, v) {
            (_, 0.0) if low_v => mixed.cross(dv),
            (_, 1.0) if high_v => -mixed.cross(dv),
            (0.0, _) if low_u => du.cross(mixed),
            (1.0, _) if high_u => -du.cross(mixed),
            _ => du.cross(dv),
        };
        (position, normal)
    }
}

impl Parametric for BezierPatch {
    fn chart(&self) -> Chart {
        let [pole_low, pole_high, ..] = self.sides().map(|side| side == [side[0]; 4]);
        Chart { pole_low, pole_high, ..Chart::SHEET }
    }

    fn at(&self, u: f64, v: f64) -> Option<Sample> {
        let (position, normal) = self.point_and_normal(u, v);
        Some(Sample { position, normal: UnitVec3::new(normal)? })
    }
}

/// The cubic Bézier curve of four points and its derivative. The latter is made of differences of the points, so it keeps
/// its digits where they lie close together and is exactly zero where they are one point.
fn curve([a, b, c, d]: [DVec3; 4], t: f64) -> (DVec3, DVec3) {
    let s = 1.0 - t;
    let point = a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t);
    let slope = (b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t);
    (point, slope * 3.0)
}
