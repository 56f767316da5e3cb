//! Flat normals on a shape that is smooth.

use crate::quality::findings::prelude::*;
use rayon::prelude::*;

/// Edges of a smaller dihedral angle, in degrees, do not count.
pub(crate) const FLAT: f64 = 1.0;

/// Edges of a smaller dihedral angle, in degrees, are those of a smooth shape.
pub(crate) const GENTLE: f64 = 30.0;

/// The fewest edges above [`FLAT`] that a smooth shape has.
const FEWEST: usize = 100;

/// The smallest share of these that are gentle on a smooth shape: a horse of 2400 quads has 0.84, a machine part 0.79, one with
/// all its holes 0.60.
const MOSTLY_GENTLE: f64 = 0.75;

/// Finds flat normals on a smooth shape.
pub(crate) fn search(facts: &Facts<'_>, found: &mut Found) {
    let Some(estimate) = facts.estimate.filter(|_| facts.file.shares_vertices()) else { return };
    if estimate.crease.0 == 0.0 && estimate.reproduced >= 0.99 && is_gentle(facts) {
        let flat = Limit::new(FLAT);
        // The largest angles: that between the normals of the two sides.
        let mut gentle = facts.scan_corners(|face, corner, found| {
            if let Some(angle) = angle_over(facts, corner as u32, flat).filter(|&it| it <= GENTLE) {
                found.add((), Spot::corner(face, corner, angle), 0.0);
            }
        });
        found.add_mesh(Kind::Faceted, facts.total_area, gentle.take(()).worst);
    }
}

/// The dihedral angle of an edge between sound faces, in degrees, if it is over a limit; `None` for the second half-edge.
pub(crate) fn angle_over(facts: &Facts<'_>, half_edge: u32, limit: Limit) -> Option<f64> {
    let across = facts.across_once(half_edge)?;
    let [a, b] = [half_edge, across].map(|corner| facts.topology.face_of(corner) as usize);
    let angle = limit.exceeded(facts.face_normal(a), facts.face_normal(b))?;
    (facts.is_sound(a) && facts.is_sound(b)).then_some(angle)
}

/// How many edges have a dihedral angle between two others, in degrees, and how many a larger one.
pub(crate) fn count_edges(facts: &Facts<'_>, [low, high]: [f64; 2]) -> [usize; 2] {
    let limit = Limit::new(low);
    let half_edges = (0..facts.mesh.faces().corner_count() as u32).into_par_iter();
    let counts = half_edges.filter_map(|half_edge| angle_over(facts, half_edge, limit)).map(|angle| {
        let is_larger = usize::from(angle > high);
        [1 - is_larger, is_larger]
    });
    counts.reduce(|| [0; 2], |[a, b], [c, d]| [a + c, b + d])
}

/// Whether most edges that are not flat have small dihedral angles, as on a smooth shape.
pub(crate) fn is_gentle(facts: &Facts<'_>) -> bool {
    let [gentle, others] = count_edges(facts, [FLAT, GENTLE]);
    let all = gentle + others;
    all >= FEWEST && gentle as f64 >= MOSTLY_GENTLE * all as f64
}
