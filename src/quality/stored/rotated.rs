//! Whether one rotation or reflection stands between the stored normals and the faces, and normals that are all the same.

use crate::mesh::are_same;
use crate::num::{Degrees, Radians, angle_between};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Remark, Spot, Tallies, scan};
use crate::quality::estimate::rotation::{are_spread, closest_turn, outer, rotation_angle};
use crate::quality::facts::{Facts, Significance};
use crate::quality::thresholds::Thresholds;
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::ops::Range;

/// The mean cosine from which on a rotation is taken to explain the normals.
const AGREES: f64 = 0.9;

/// How much of the disagreement an explanation has to take away.
const EXPLAINED: f64 = 0.75;

/// Looks for one cause that explains all stored normals; tells whether there is one.
pub(in crate::quality) fn find(facts: &Facts<'_>, thresholds: &Thresholds, found: &mut Tallies) -> bool {
    let pairs = Pairs::new(facts);
    let area = facts.total_area;
    if pairs.weight == 0.0 {
        return false;
    }
    if pairs.is_constant {
        // A flat mesh has one normal by right, and so has what no normals could be computed for.
        let bent = [pairs.mean_face, pairs.mean_expected].iter().all(|mean| mean.length() < 0.9);
        if bent {
            found.add_mesh(Kind::Constant, area, worst(facts, thresholds.places));
        }
        return bent;
    }
    // Through two lines much can be laid that has nothing to do with them.
    if !are_spread(corners(facts)) {
        return false;
    }
    let closest = closest_turn(pairs.correlation * (1.0 / pairs.weight));
    let Some(closest) = facts.turn.or(closest) else { return false };
    let explains = |agreement: f64| explains(agreement, pairs.either_way, thresholds);
    let changes: Vec<(DMat3, f64)> = axis_changes()
        .map(|axes| (axes, pairs.agreement(axes)))
        .filter(|&(_, agreement)| explains(agreement))
        .collect();
    let is_closest = |axes: DMat3| {
        let between = closest.transpose() * axes;
        between.determinant() > 0.0 && rotation_angle(between) <= thresholds.rotation.0
    };
    if let Some(text) = smallest_of_the_best(&changes, is_closest) {
        found.add_mesh(Kind::SwappedAxes, area, worst(facts, thresholds.places));
        found.tally(Kind::SwappedAxes).remark = Some(Remark { weight: facts.mesh.face_count() as f64, text });
        return true;
    }
    let angle = rotation_angle(closest);
    let fits = facts.turn.is_some() || explains(pairs.agreement(closest));
    let is_turned = fits && angle > thresholds.rotation.0;
    if is_turned {
        let reversed = if closest.determinant() < 0.0 { ", and reversed" } else { "" };
        found.add_mesh(Kind::Rotated, area, worst(facts, thresholds.places));
        found.tally(Kind::Rotated).turn = Some(angle);
        let text = format!("by {angle:.1}°{reversed}");
        found.tally(Kind::Rotated).remark = Some(Remark { weight: angle, text });
    }
    is_turned
}

/// The corners that are furthest from what the faces give.
pub(in crate::quality) fn worst(facts: &Facts<'_>, most: usize) -> Vec<Spot> {
    let mut off = scan(facts.mesh.face_count(), most, |faces, found| {
        for face in faces.filter(|&face| facts.worth[face] == Significance::Sound) {
            for corner in facts.mesh.faces().range(face) {
                if let Some(normal) = facts.stored_unit(corner) {
                    let off = Degrees::from(angle_between(normal, facts.expected(corner))).0;
                    found.add(Kind::Rotated, Spot::corner(face, corner, off), 0.0);
                }
            }
        }
    });
    off.take(Kind::Rotated).worst
}

/// The stored normals of all corners, as unit vectors.
fn corners(facts: &Facts<'_>) -> impl Iterator<Item = DVec3> {
    (0..facts.mesh.faces().corner_count()).filter_map(|corner| facts.stored_unit(corner))
}

/// The change of axes that agrees best, in words; of several that agree as well the smallest, and that there are others.
/// `None` if none of these is the closest turn.
fn smallest_of_the_best(changes: &[(DMat3, f64)], is_closest: impl Fn(DMat3) -> bool) -> Option<String> {
    /// What rounding makes of equal mean cosines.
    const ALIKE: f64 = 1e-6;
    let best = changes.iter().map(|it| it.1).reduce(f64::max)?;
    let alike: Vec<DMat3> = changes.iter().filter(|it| it.1 >= best - ALIKE).map(|it| it.0).collect();
    if !alike.iter().any(|&axes| is_closest(axes)) {
        return None;
    }
    let changed = |axes: &&DMat3| (0..3).filter(|&i| axes.col(i) != DMat3::IDENTITY.col(i)).count();
    let smallest = describe(*alike.iter().min_by_key(changed)?);
    Some(match alike.len() - 1 {
        0 => smallest,
        1 => format!("{smallest} (or another change that this shape does not tell from it)"),
        others => format!("{smallest} (or one of {others} changes that this shape does not tell from it)"),
    })
}

/// Whether there is something to explain, by mean cosines, and a turn of all normals explains it. What turning single ones
/// round explains as well is no turn of all: on a box with some sides' normals reversed half a turn does.
pub(in crate::quality) fn explains(turned: f64, either_way: f64, thresholds: &Thresholds) -> bool {
    let wrong = 1.0 - either_way;
    wrong > least(thresholds) && turned >= AGREES && 1.0 - turned <= (1.0 - EXPLAINED) * wrong
}

/// The least disagreement that is worth a word. Normals about the axis of a rotation turn by less than it does.
pub(in crate::quality) fn least(thresholds: &Thresholds) -> f64 {
    0.25 * (1.0 - libm::cos(Radians::from(thresholds.rotation).0))
}

/// Expected and stored normals, summed up: M = Σ stored · expectedᵀ.
struct Pairs {
    correlation: DMat3,
    weight: f64,
    /// The mean cosine if each stored normal may stand for its opposite.
    either_way: f64,
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
            all.either_way += block.either_way;
            all.mean_face += block.mean_face;
            all.mean_expected += block.mean_expected;
            all.is_constant &= block.is_constant;
        }
        if all.weight > 0.0 {
            all.either_way /= all.weight;
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
            either_way: 0.0,
            mean_face: DVec3::ZERO,
            mean_expected: DVec3::ZERO,
            is_constant: true,
        };
        for face in faces.filter(|&face| facts.worth[face] != Significance::Silent) {
            let range = facts.mesh.faces().range(face);
            let weight = facts.area[face] / range.len() as f64;
            for corner in range {
                let Some(stored) = facts.stored_unit(corner) else { continue };
                let expected = facts.right_way(face, corner);
                pairs.is_constant &= first.is_some_and(|first| are_same(first, stored));
                pairs.correlation += outer(stored * weight, expected);
                pairs.either_way += stored.dot(expected).abs() * weight;
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
