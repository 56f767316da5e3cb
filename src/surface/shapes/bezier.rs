//! Bicubic Bézier patches, and the teapot that is made of 32 of them.

use crate::num::UnitVec3;
use crate::surface::error::{LENGTHS, Result, SurfaceError};
use crate::surface::shapes::chart::{Chart, Parametric, Sample};
use glam::DVec3;
use std::sync::OnceLock;

/// The patch Σ Bᵢ(v) Bⱼ(u) Pᵢⱼ over four rows of four control points, facing along ∂u × ∂v; B are the cubic
/// Bernstein polynomials.
///
/// # Collapsed sides
/// A side whose four control points coincide has no tangent. Next to the side v = 0, ∂u is v·∂u∂v to first order, so
/// the direction of ∂u × ∂v tends to ∂u∂v × ∂v. That limit is the normal there, one for each u. If all of them are
/// equal, as at the top of the teapot's lid, the surface is smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BezierPatch {
    points: [[DVec3; 4]; 4],
}

/// A sheet curved in both directions, of size about 2.
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
    /// [`SurfaceError::Invalid`] if a coordinate is not finite or beyond 1e60.
    pub fn new(points: [[DVec3; 4]; 4]) -> Result<Self> {
        let wrong = |p: &DVec3| !(p.is_finite() && p.abs().max_element() <= *LENGTHS.end());
        match points.as_flattened().iter().position(wrong) {
            Some(index) => {
                let place = format!("row {}, column {}", index / 4, index % 4);
                Err(SurfaceError::Invalid(format!(
                    "the control point in {place} is not finite or beyond 1e60"
                )))
            }
            None => Ok(Self { points }),
        }
    }

    /// The control points, row by row.
    pub fn points(&self) -> &[[DVec3; 4]; 4] {
        &self.points
    }

    /// The control points of a side: v = 0, v = 1, u = 0, u = 1, each in the direction of the parameter that varies.
    pub(crate) fn sides(&self) -> [[DVec3; 4]; 4] {
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

/// The cubic Bézier curve of four points and its derivative. The derivative uses differences of the points: it keeps
/// its digits if they lie close together, and is exactly zero if they coincide.
fn curve([a, b, c, d]: [DVec3; 4], t: f64) -> (DVec3, DVec3) {
    let s = 1.0 - t;
    let point = a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t);
    let slope = (b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t);
    (point, slope * 3.0)
}

/// The published figures; the file states their source.
const FIGURES: &str = include_str!("../../../data/teapot.txt");

/// The 32 patches of Newell's teapot, facing outward, with y up, the spout along +x, the bottom at y = 0 and the top of the lid
/// at y = 3.15: rim 4, body 8, handle 4, spout 4, lid 8, bottom 4.
///
/// Four components intersect but share no edge: pot, lid, handle, spout. Within each the patches meet smoothly. Sides are
/// collapsed at the top of the lid and in the middle of the bottom.
pub fn teapot() -> &'static [BezierPatch] {
    static PATCHES: OnceLock<Vec<BezierPatch>> = OnceLock::new();
    PATCHES.get_or_init(|| read(FIGURES).expect("the figures that this program was built with are complete"))
}

/// The patches of the figures, rotated from z up to y up.
fn read(figures: &str) -> Option<Vec<BezierPatch>> {
    let lines = figures.lines().filter(|line| !line.starts_with('#'));
    let mut words = lines.flat_map(str::split_whitespace);
    let count = heading(&mut words, "points")?;
    let mut number = || words.next()?.parse::<f64>().ok();
    let mut point = || {
        let [x, y, z] = [number()?, number()?, number()?];
        Some(DVec3::new(x, z, 0.0 - y))
    };
    let points = (0..count).map(|_| point()).collect::<Option<Vec<DVec3>>>()?;
    let count = heading(&mut words, "patches")?;
    let mut point = || points.get(words.next()?.parse::<usize>().ok()?).copied();
    let mut patch = || {
        let mut rows = [[DVec3::ZERO; 4]; 4];
        for slot in rows.as_flattened_mut() {
            *slot = point()?;
        }
        BezierPatch::new(rows).ok()
    };
    (0..count).map(|_| patch()).collect()
}

fn heading<'a>(words: &mut impl Iterator<Item = &'a str>, name: &str) -> Option<usize> {
    if words.next()? == name { words.next()?.parse().ok() } else { None }
}
