//! Normals that are all the same, or rotated or reflected as a whole.

use crate::mesh::are_same;
use crate::num::Radians;
use crate::num::parallel;
use crate::quality::estimate::rotation::{are_spread, closest_rotation, outer, rotation_angle};
use crate::quality::findings::prelude::*;
use crate::quality::thresholds::Thresholds;
use glam::{DMat3, DVec3};
use std::ops::Range;

/// The mean cosine from which a rotation explains the normals.
const AGREES: f64 = 0.9;

/// The share of the disagreement that an explanation has to remove.
const EXPLAINED: f64 = 0.75;

/// The difference that rounding makes between equal mean cosines.
pub(crate) const ALIKE: f64 = 1e-6;

/// Searches for one cause that explains all stored normals. Returns whether there is one.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) -> bool {
    let sums = Sums::new(facts);
    let area = facts.total_area;
    if sums.weight == 0.0 {
        return false;
    }
    if sums.is_constant {
        // A flat mesh has one normal, and so has one for which none could be computed.
        let is_fault = [sums.faces, sums.expected].iter().all(|sum| (*sum / sums.weight).length() < 0.9);
        if is_fault {
            found.add_mesh(Kind::Constant, area, worst(facts));
        }
        return is_fault;
    }
    // Two lines leave the rotation open.
    if !are_spread((0..facts.mesh.faces().corner_count()).filter_map(|corner| facts.stored_unit(corner))) {
        return false;
    }
    let closest = closest_rotation(sums.correlation * (1.0 / sums.weight));
    let Some(closest) = facts.rotation.or(closest) else { return false };
    let either_way = sums.either_way / sums.weight;
    let explains = |agreement: f64| explains(agreement, either_way, facts.thresholds);
    let changes: Vec<(DMat3, f64)> = axis_changes()
        .map(|axes| (axes, sums.agreement(axes)))
        .filter(|&(_, agreement)| explains(agreement))
        .collect();
    let is_closest = |axes: DMat3| {
        let between = closest.transpose() * axes;
        between.determinant() > 0.0 && rotation_angle(between) <= facts.thresholds.rotation.0
    };
    if let Some(text) = smallest_of_the_best(&changes, is_closest) {
        found.add_mesh(Kind::SwappedAxes, area, worst(facts));
        found.tally(Kind::SwappedAxes).remark = Some(Remark { weight: facts.mesh.face_count() as f64, text });
        return true;
    }
    let angle = rotation_angle(closest);
    let fits = facts.rotation.is_some() || explains(sums.agreement(closest));
    let is_rotated = fits && angle > facts.thresholds.rotation.0;
    if is_rotated {
        let key = if closest.determinant() < 0.0 { "rotated-and-reversed" } else { "rotated-by" };
        let text = REMARKS.with(key, &[("degrees", Value::digits(&format!("{angle:.1}")))]);
        found.add_mesh(Kind::Rotated, area, worst(facts));
        let tally = found.tally(Kind::Rotated);
        tally.rotation_degrees = Some(angle);
        tally.remark = Some(Remark { weight: angle, text });
    }
    is_rotated
}

pub(crate) fn worst(facts: &Facts<'_>) -> Vec<Spot> {
    let mut found = facts.scan_corners(|face, corner, found| {
        if !facts.is_sound(face) {
            return;
        }
        if let Some(deviation) = facts.deviation(corner) {
            found.add((), Spot::corner(face, corner, deviation), 0.0);
        }
    });
    found.take(()).worst
}

/// The change of axes that agrees best, in words; of several the smallest, with how many others there are. `None` if none of
/// these is the closest rotation.
fn smallest_of_the_best(changes: &[(DMat3, f64)], is_closest: impl Fn(DMat3) -> bool) -> Option<Text> {
    let best = changes.iter().map(|it| it.1).reduce(f64::max)?;
    let alike: Vec<DMat3> = changes.iter().filter(|it| it.1 >= best - ALIKE).map(|it| it.0).collect();
    if !alike.iter().any(|&axes| is_closest(axes)) {
        return None;
    }
    let changed = |axes: &&DMat3| (0..3).filter(|&i| axes.col(i) != DMat3::IDENTITY.col(i)).count();
    let smallest = describe(*alike.iter().min_by_key(changed)?);
    Some(match alike.len() - 1 {
        0 => smallest,
        1 => REMARKS.with("or-another-change", &[("change", smallest.into())]),
        others => REMARKS.with("or-other-changes", &[("change", smallest.into()), ("count", others.into())]),
    })
}

/// Whether there is a disagreement, by mean cosines, and a rotation of all normals explains it. It is no rotation if negating
/// some normals explains it as well: on a box with the normals of some sides negated, half a turn fits.
pub(crate) fn explains(rotated: f64, either_way: f64, thresholds: &Thresholds) -> bool {
    let disagreement = 1.0 - either_way;
    disagreement > least(thresholds) && rotated >= AGREES && 1.0 - rotated <= (1.0 - EXPLAINED) * disagreement
}

/// The least disagreement that is reported. Normals near the axis of a rotation turn by less than its angle.
pub(crate) fn least(thresholds: &Thresholds) -> f64 {
    0.25 * (1.0 - libm::cos(Radians::from(thresholds.rotation).0))
}

/// Sums over the corners of faces with a direction, weighted by area.
#[derive(Clone, Copy)]
struct Sums {
    /// Σ stored · expectedᵀ.
    correlation: DMat3,
    weight: f64,
    /// Cosines, if each stored normal may be replaced by its opposite.
    either_way: f64,
    faces: DVec3,
    expected: DVec3,
    is_constant: bool,
}

impl Sums {
    const NONE: Self = Self {
        correlation: DMat3::ZERO,
        weight: 0.0,
        either_way: 0.0,
        faces: DVec3::ZERO,
        expected: DVec3::ZERO,
        is_constant: true,
    };

    fn new(facts: &Facts<'_>) -> Self {
        /// Fixed, so that sums do not depend on the number of threads.
        const BLOCK: usize = 1 << 14;
        let first = (0..facts.mesh.faces().corner_count()).find_map(|corner| facts.stored_unit(corner));
        let count = facts.mesh.face_count();
        let blocks = parallel::blocks(count, BLOCK, |faces| Self::of(facts, faces, first));
        blocks.into_iter().fold(Self::NONE, |all, block| Self {
            correlation: all.correlation + block.correlation,
            weight: all.weight + block.weight,
            either_way: all.either_way + block.either_way,
            faces: all.faces + block.faces,
            expected: all.expected + block.expected,
            is_constant: all.is_constant && block.is_constant,
        })
    }

    /// The sums over some faces; they are constant if all stored normals are the same as the first.
    fn of(facts: &Facts<'_>, faces: Range<usize>, first: Option<DVec3>) -> Self {
        let mut sums = Self::NONE;
        for face in faces.filter(|&face| facts.has_direction(face)) {
            let weight = facts.corner_area(face);
            for corner in facts.corners_of(face) {
                let Some(stored) = facts.stored_unit(corner) else { continue };
                let expected = facts.expected_or_face(face, corner);
                sums.is_constant &= first.is_some_and(|first| are_same(first, stored));
                sums.correlation += outer(stored * weight, expected);
                sums.either_way += stored.dot(expected).abs() * weight;
                sums.faces += facts.face_normal(face) * weight;
                sums.expected += expected * weight;
                sums.weight += weight;
            }
        }
        sums
    }

    /// The mean cosine between the stored normals and the expected ones, rotated.
    fn agreement(&self, rotation: DMat3) -> f64 {
        let sum = |i: usize| rotation.col(i).dot(self.correlation.col(i));
        (sum(0) + sum(1) + sum(2)) / self.weight
    }
}

/// All permutations of the axes with all changes of sign, without the identity.
fn axis_changes() -> impl Iterator<Item = DMat3> {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let change = |order: [usize; 3], signs: usize| {
        let column = |i: usize| DVec3::AXES[order[i]] * if signs >> i & 1 == 1 { -1.0 } else { 1.0 };
        DMat3::from_cols(column(0), column(1), column(2))
    };
    ORDERS.into_iter().flat_map(move |order| (0..8).map(move |signs| change(order, signs))).skip(1)
}

/// The new axis of each axis that changed, in words.
fn describe(axes: DMat3) -> Text {
    let name = |column: DVec3| {
        let axis = (0..3).max_by(|&a, &b| column[a].abs().total_cmp(&column[b].abs())).unwrap_or(0);
        format!("{}{}", if column[axis] < 0.0 { "−" } else { "" }, ["x", "y", "z"][axis])
    };
    let changes = ["x", "y", "z"].into_iter().zip([axes.x_axis, axes.y_axis, axes.z_axis]);
    let changed = changes.map(|(from, to)| (from, name(to))).filter(|(from, to)| from != to);
    let changed: Vec<Text> = changed
        .map(|(from, to)| REMARKS.with("stored-as", &[("from", from.into()), ("to", to.into())]))
        .collect();
    Text::each(|language| changed.iter().map(|text| text.get(language)).collect::<Vec<_>>().join(", "))
}
