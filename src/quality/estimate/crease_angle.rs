//! Across which edges stored normals are smooth, and the angle that separates those edges from the others.

use crate::normals::SLACK_DEGREES;
use crate::num::Degrees;
use crate::quality::angles::{SAME, degrees_between};
use crate::quality::input::part::Part;

/// Edges of a smaller dihedral angle, in degrees, say nothing about creases.
const FLAT: f64 = 1.0;

/// The dihedral angle of an edge, and whether the stored normals are smooth across it.
#[derive(Clone, Copy)]
pub(crate) struct EdgeSample {
    pub(crate) degrees: f64,
    pub(crate) smooth: bool,
    /// Whether both faces have the same smoothing group, so that the angle decides.
    pub(crate) in_one_group: bool,
}

impl EdgeSample {
    /// The edge that leaves a corner, by the normals at that corner.
    pub(crate) fn at(part: &Part<'_>, corner: u32) -> Option<EdgeSample> {
        let stored = part.stored?;
        let across = part.topology.across(corner)?;
        let corners = [corner, part.topology.next(across)].map(|corner| corner as usize);
        let faces = corners.map(|corner| part.face_of(corner));
        if !faces.iter().all(|&face| part.is_sound(face)) {
            return None;
        }
        let degrees = degrees_between(part.face_normal(faces[0]), part.face_normal(faces[1]));
        if degrees < FLAT {
            return None;
        }
        let slots = corners.map(|corner| stored.slot(corner, part.vertex(corner)));
        let smooth = slots[0] == slots[1]
            || degrees_between(part.stored_unit(corners[0])?, part.stored_unit(corners[1])?) <= SAME;
        let groups = part.mesh.columns().smoothing.as_ref();
        let groups = groups.map(|groups| faces.map(|face| groups.of_face[face]));
        Some(EdgeSample { degrees, smooth, in_one_group: groups.is_none_or(|[a, b]| a == b && a != 0) })
    }
}

/// The lowest crease angle in degrees that gives the corners of a fan the same faces, and the one from which on it does not,
/// from the dihedral angles of the edges inside the fan and at its two ends. One sharp edge at a vertex splits nothing, so a whole
/// one-ring may have one.
pub(crate) fn equal_angles(inside: &[f64], ends: &[f64], is_ring: bool) -> [f64; 2] {
    let mut inside: Vec<f64> = inside.iter().copied().filter(|&degrees| degrees >= FLAT).collect();
    inside.sort_unstable_by(|a, b| b.total_cmp(a));
    let low = inside.get(usize::from(is_ring)).map_or(0.0, |degrees| degrees - SLACK_DEGREES);
    let ends = ends.iter().copied().filter(|&degrees| degrees >= FLAT);
    [low, ends.fold(180.0, |high, degrees| high.min(degrees - SLACK_DEGREES))]
}

/// The angle of [`separating_angle`], more precisely: rounding puts edges of equal angles on both sides of a crease angle. To a
/// hundredth of a degree, if that separates them as well.
pub(crate) fn exact_separating_angle(edges: &[EdgeSample], weight: usize) -> Degrees {
    let mut sorted: Vec<&EdgeSample> = edges.iter().collect();
    sorted.sort_by(|a, b| a.degrees.total_cmp(&b.degrees));
    // Below the first edge, all that are smooth are on the wrong side.
    let mut wrong = sorted.iter().filter(|edge| edge.smooth).count();
    let mut best = (wrong, 0);
    for (at, edge) in sorted.iter().enumerate() {
        wrong = if edge.smooth { wrong - 1 } else { wrong + weight };
        let is_end = sorted.get(at + 1).is_none_or(|next| next.degrees > edge.degrees);
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

/// The whole number of degrees that best separates smooth edges from sharp ones, if a sharp edge below it counts as `weight`
/// smooth ones above it.
pub(crate) fn separating_angle(edges: &[EdgeSample], weight: usize) -> Degrees {
    const BINS: usize = 180;
    let (mut smooth, mut sharp) = ([0usize; BINS], [0usize; BINS]);
    for edge in edges {
        let counts = if edge.smooth { &mut smooth } else { &mut sharp };
        counts[(edge.degrees as usize).min(BINS - 1)] += 1;
    }
    // k degrees are wrong about sharp edges of bins below k and smooth ones of bins from k on.
    let mut wrong = smooth.iter().sum::<usize>();
    let mut costs = vec![wrong];
    for k in 0..BINS {
        wrong = wrong + weight * sharp[k] - smooth[k];
        costs.push(wrong);
    }
    let least = *costs.iter().min().expect("181 angles");
    // The longest run of best angles; among equals the first.
    let (mut low, mut length, mut start) = (0, 0, 0);
    for run in costs.chunk_by(|a, b| a == b) {
        if run[0] == least && run.len() > length {
            (low, length) = (start, run.len());
        }
        start += run.len();
    }
    let range = low..low + length;
    Degrees(match () {
        () if sharp.iter().all(|&count| count == 0) => 180.0,
        // The default is what most normals are made with.
        () if range.contains(&40) => 40.0,
        () if smooth.iter().all(|&count| count == 0) => 0.0,
        () => low.midpoint(low + length - 1) as f64,
    })
}
