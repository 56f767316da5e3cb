//! Whether one rotation, reflection or matrix stands between the stored normals and the faces, and normals that are all
//! the same.

use super::Thresholds;
use super::catalogue::Kind;
use super::facts::{Facts, Worth};
use super::tally::{Spot, Tallies};
use crate::mesh::normal_matrix;
use crate::num::{Degrees, Radians, angle_between};
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::ops::Range;

/// The mean cosine from which on a rotation is taken to explain the normals.
const AGREES: f64 = 0.9;

/// The least determinant of the mean of stored · expectedᵀ for normals to be spread over all directions.
const SPREAD: f64 = 1e-6;

/// How much of the disagreement an explanation has to take away.
const EXPLAINED: f64 = 0.75;

/// Looks for one cause that explains all stored normals; tells whether there is one.
pub(super) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) -> bool {
    let pairs = Pairs::new(facts);
    let area = facts.total_area;
    if pairs.weight == 0.0 {
        return false;
    }
    if pairs.is_constant {
        // A flat mesh has one normal by right, and so has what no normals could be computed for.
        let bent = [pairs.mean_face, pairs.mean_expected].iter().all(|mean| mean.length() < 0.9);
        if bent {
            found.add(Kind::Constant, Spot::mesh(), area);
        }
        return bent;
    }
    // Normals in one plane fit many a change of axes.
    if pairs.correlation.determinant().abs() < SPREAD * pairs.weight * pairs.weight * pairs.weight {
        return false;
    }
    let as_stored = pairs.agreement(DMat3::IDENTITY);
    let explains = |agreement: f64| explains(agreement, as_stored, thresholds);
    if let Some((axes, _)) = axis_changes()
        .map(|axes| (axes, pairs.agreement(axes)))
        .filter(|(_, it)| explains(*it))
        .max_by(|a, b| a.1.total_cmp(&b.1))
    {
        // The opposite of everything is told from the faces' side: either could be turned round.
        if axes == -DMat3::IDENTITY {
            return false;
        }
        found.add(Kind::SwappedAxes, Spot::mesh(), area);
        found.tally(Kind::SwappedAxes).remark = Some(describe(axes));
        return true;
    }
    if let Some(rotation) = pairs.best_rotation() {
        let angle = rotation_angle(rotation);
        if angle > thresholds.rotation.0 && explains(pairs.agreement(rotation)) {
            found.add(Kind::Rotated, Spot::mesh().by(angle), area);
            found.tally(Kind::Rotated).remark = Some(format!("by {angle:.1}°"));
            return true;
        }
    }
    false
}

/// Whether there is something to explain, by mean cosines, and a turn explains it.
fn explains(turned: f64, as_stored: f64, thresholds: &Thresholds) -> bool {
    // Normals about the axis of a rotation turn by less than it does.
    let least = 0.25 * (1.0 - libm::cos(Radians::from(thresholds.rotation).0));
    let wrong = 1.0 - as_stored;
    wrong > least && turned >= AGREES && 1.0 - turned <= (1.0 - EXPLAINED) * wrong
}

/// Expected and stored normals, summed up: M = Σ stored · expectedᵀ.
struct Pairs {
    correlation: DMat3,
    weight: f64,
    mean_face: DVec3,
    mean_expected: DVec3,
    is_constant: bool,
}

impl Pairs {
    fn new(facts: &Facts<'_>) -> Self {
        /// Fixed, so that sums do not depend on the number of threads.
        const BLOCK: usize = 1 << 14;
        let first = (0..facts.mesh.faces().corner_count()).find_map(|corner| facts.stored_unit(corner));
        let count = facts.mesh.face_count();
        let blocks: Vec<Self> = (0..count.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| Self::of(facts, block * BLOCK..((block + 1) * BLOCK).min(count), first))
            .collect();
        let mut all = Self::of(facts, 0..0, first);
        for block in blocks {
            all.correlation += block.correlation;
            all.weight += block.weight;
            all.mean_face += block.mean_face;
            all.mean_expected += block.mean_expected;
            all.is_constant &= block.is_constant;
        }
        if all.weight > 0.0 {
            all.mean_face /= all.weight;
            all.mean_expected /= all.weight;
        }
        all
    }

    /// The sums over some faces; `first` is the normal that all would be equal to.
    fn of(facts: &Facts<'_>, faces: Range<usize>, first: Option<DVec3>) -> Self {
        let mut pairs = Pairs {
            correlation: DMat3::ZERO,
            weight: 0.0,
            mean_face: DVec3::ZERO,
            mean_expected: DVec3::ZERO,
            is_constant: true,
        };
        for face in faces.filter(|&face| facts.worth[face] != Worth::Silent) {
            let range = facts.mesh.faces().range(face);
            let weight = facts.area[face] / range.len() as f64;
            for corner in range {
                let Some(stored) = facts.stored_unit(corner) else { continue };
                let expected = facts.right_way(face, corner);
                pairs.is_constant &= first.is_some_and(|first| first.dot(stored) > 0.9999);
                let (a, b) = (stored * weight, expected);
                pairs.correlation += DMat3::from_cols(a * b.x, a * b.y, a * b.z);
                pairs.mean_face += facts.face_normal(face) * weight;
                pairs.mean_expected += expected * weight;
                pairs.weight += weight;
            }
        }
        pairs
    }

    /// The mean cosine between the stored normals and the expected ones, turned.
    fn agreement(&self, turn: DMat3) -> f64 {
        let sum = |i: usize| turn.col(i).dot(self.correlation.col(i));
        (sum(0) + sum(1) + sum(2)) / self.weight
    }

    /// The rotation or reflection that fits best: the orthogonal factor of the correlation, by Newton's iteration
    /// (N. Higham, *Computing the polar decomposition*, 1986). `None` if the normals leave one free.
    fn best_rotation(&self) -> Option<DMat3> {
        let mut x = self.correlation * (1.0 / self.weight);
        if x.determinant().abs() < 1e-4 {
            return None;
        }
        for _ in 0..60 {
            let next = (x + x.inverse().transpose()) * 0.5;
            let change =
                (next - x).to_cols_array().iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            x = next;
            if change < 1e-14 {
                break;
            }
        }
        x.is_finite().then_some(x)
    }
}

/// The angle of a rotation, in degrees; of a reflection that of what remains after the sign is taken off.
fn rotation_angle(turn: DMat3) -> f64 {
    let turn = if turn.determinant() < 0.0 { -turn } else { turn };
    let axis = DVec3::new(
        turn.y_axis.z - turn.z_axis.y,
        turn.z_axis.x - turn.x_axis.z,
        turn.x_axis.y - turn.y_axis.x,
    );
    let trace = turn.x_axis.x + turn.y_axis.y + turn.z_axis.z;
    Degrees::from(Radians(libm::atan2(axis.length(), trace - 1.0))).0
}

/// All permutations of the axes with all changes of sign, but the one that changes nothing.
fn axis_changes() -> impl Iterator<Item = DMat3> {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let change = |order: [usize; 3], signs: usize| {
        let column = |i: usize| DVec3::AXES[order[i]] * if signs >> i & 1 == 1 { -1.0 } else { 1.0 };
        DMat3::from_cols(column(0), column(1), column(2))
    };
    ORDERS.into_iter().flat_map(move |order| (0..8).map(move |signs| change(order, signs))).skip(1)
}

/// What became of each axis.
fn describe(axes: DMat3) -> String {
    let name = |column: DVec3| {
        let axis = (0..3).max_by(|&a, &b| column[a].abs().total_cmp(&column[b].abs())).unwrap_or(0);
        format!("{}{}", if column[axis] < 0.0 { "−" } else { "" }, ["x", "y", "z"][axis])
    };
    let changes = ["x", "y", "z"].into_iter().zip([axes.x_axis, axes.y_axis, axes.z_axis]);
    let changed = changes.map(|(from, to)| (from, name(to))).filter(|(from, to)| from != to);
    let said: Vec<String> = changed.map(|(from, to)| format!("{from} stands as {to}")).collect();
    said.join(", ")
}

/// Whether a linear map, or its inverse, stands between the stored normals and the faces.
pub(super) fn explained_by(facts: &Facts<'_>, map: DMat3, thresholds: &Thresholds) -> bool {
    [map, map.inverse()].into_iter().filter_map(normal_matrix).any(|matrix| {
        let (mut with, mut without, mut weight) = (0.0, 0.0, 0.0);
        for (face, range) in facts.mesh.faces().ranges().enumerate() {
            for corner in range.filter(|_| facts.worth[face] != Worth::Silent) {
                let Some(stored) = facts.stored_unit(corner) else { continue };
                let expected = facts.right_way(face, corner);
                let turned = matrix.apply(expected).unwrap_or(expected);
                with += facts.area[face] * stored.dot(turned);
                without += facts.area[face] * stored.dot(expected);
                weight += facts.area[face];
            }
        }
        explains(with / weight, without / weight, thresholds)
    })
}

/// How far a linear map turns normals at most, over the axes and the diagonals, in degrees.
pub(super) fn largest_turn(map: DMat3) -> f64 {
    let [across, up] = [DVec3::new(1.0, -1.0, 1.0), DVec3::new(1.0, 1.0, -1.0)];
    let directions = [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ONE, across, up];
    let Some(matrix) = normal_matrix(map) else { return 0.0 };
    let turn = |d: DVec3| matrix.apply(d).map_or(0.0, |turned| Degrees::from(angle_between(d, turned)).0);
    directions.into_iter().map(turn).fold(0.0, f64::max)
}
