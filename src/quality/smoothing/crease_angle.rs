//! Where stored normals go on across edges, and the angle that tells those edges from the others.

use crate::mesh::Column;
use crate::num::{Degrees, angle_between};
use crate::quality::estimate::recipe::SAME;
use crate::quality::facts::{Facts, Significance};
use glam::DVec3;

/// Edges that bend by less, in degrees, tell nothing about creases.
const FLAT: f64 = 1.0;

/// An edge, by how far it bends and whether the stored normals go on across it.
#[derive(Clone, Copy)]
pub(in crate::quality) struct Bend {
    pub(in crate::quality) degrees: f64,
    pub(in crate::quality) smooth: bool,
    /// Whether smoothing groups leave it to the angle.
    pub(in crate::quality) in_one_group: bool,
}

impl Bend {
    /// The edge that leaves a corner, by the normals at that corner.
    pub(in crate::quality) fn at(facts: &Facts<'_>, stored: &Column<DVec3>, corner: u32) -> Option<Bend> {
        let across = facts.topology.across(corner)?;
        let beyond = facts.topology.next(across) as usize;
        let faces = [corner, across].map(|corner| facts.topology.face_of(corner) as usize);
        if faces.iter().any(|&face| facts.worth[face] != Significance::Sound) {
            return None;
        }
        let degrees =
            Degrees::from(angle_between(facts.face_normal(faces[0]), facts.face_normal(faces[1]))).0;
        if degrees < FLAT {
            return None;
        }
        let corners = facts.mesh.faces().corners();
        let slots = [corner as usize, beyond].map(|corner| stored.slot(corner, corners[corner]));
        let smooth = slots[0] == slots[1] || {
            let (a, b) = (facts.stored_unit(corner as usize)?, facts.stored_unit(beyond)?);
            Degrees::from(angle_between(a, b)).0 <= SAME
        };
        let groups =
            facts.mesh.columns().smoothing.as_ref().map(|groups| faces.map(|face| groups.of_face[face]));
        let in_one_group = groups.is_none_or(|[a, b]| a == b && a != 0);
        Some(Bend { degrees, smooth, in_one_group })
    }
}

/// [`separating_angle`] to less than a degree: rounding puts edges that bend alike on both sides of a crease angle. To a hundredth
/// of a degree, if that tells them as well.
pub(in crate::quality) fn exact_separating_angle(bends: &[Bend], weight: usize) -> Degrees {
    let mut sorted: Vec<&Bend> = bends.iter().collect();
    sorted.sort_by(|a, b| a.degrees.total_cmp(&b.degrees));
    // Below the first, all that look smooth are on the wrong side.
    let mut wrong = sorted.iter().filter(|bend| bend.smooth).count();
    let mut best = (wrong, 0);
    for (at, bend) in sorted.iter().enumerate() {
        wrong = if bend.smooth { wrong - 1 } else { wrong + weight };
        let is_end = sorted.get(at + 1).is_none_or(|next| next.degrees > bend.degrees);
        if is_end && wrong < best.0 {
            best = (wrong, at + 1);
        }
    }
    let (Some(above), Some(below)) = (sorted.get(best.1), best.1.checked_sub(1).map(|at| sorted[at])) else {
        return Degrees(if best.1 == 0 { 0.0 } else { 180.0 });
    };
    let between = 0.5 * (below.degrees + above.degrees);
    let round = (between * 100.0).round() / 100.0;
    Degrees(if below.degrees <= round && round < above.degrees { round } else { between })
}

/// The angle that best tells smooth edges from sharp ones, if one that looks sharp below it is as wrong as so many that look
/// smooth beyond it.
pub(in crate::quality) fn separating_angle(bends: &[Bend], weight: usize) -> Degrees {
    const BINS: usize = 180;
    let bin = |degrees: f64| (degrees as usize).min(BINS - 1);
    let (mut smooth, mut sharp) = ([0usize; BINS], [0usize; BINS]);
    for bend in bends {
        let list = if bend.smooth { &mut smooth } else { &mut sharp };
        list[bin(bend.degrees)] += 1;
    }
    // An angle of k degrees is wrong about sharp edges of bins below k and smooth ones of bins from k on.
    let mut wrong = smooth.iter().sum::<usize>();
    let mut costs = vec![wrong];
    for k in 0..BINS {
        wrong = wrong + weight * sharp[k] - smooth[k];
        costs.push(wrong);
    }
    let least = *costs.iter().min().expect("181 angles");
    let runs = costs.chunk_by(|a, b| a == b);
    // The longest run of best angles; among equals the first.
    let mut best = (0, 0);
    let mut start = 0;
    for run in runs {
        if run[0] == least && run.len() > best.1 {
            best = (start, run.len());
        }
        start += run.len();
    }
    let (low, high) = (best.0, best.0 + best.1 - 1);
    Degrees(match (low, high) {
        _ if sharp.iter().all(|&count| count == 0) => 180.0,
        // What is computed without being asked for is what most have been made with.
        (low, high) if (low..=high).contains(&40) => 40.0,
        _ if smooth.iter().all(|&count| count == 0) => 0.0,
        (low, high) => low.midpoint(high) as f64,
    })
}
