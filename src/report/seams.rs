//! Edges along which one object ends and another begins, as where the parts of a mesh have different materials.

use glam::DVec3;

/// An edge that an object ends at, in the scene: its ends, and the unit normals there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rim {
    /// Where it begins and ends, the end with the lower coordinates first.
    pub(super) points: [DVec3; 2],
    /// The normals of its face at the ends.
    pub(super) normals: [DVec3; 2],
}

impl Rim {
    /// An edge between two points with their normals, in any order.
    pub(super) fn new(a: (DVec3, DVec3), b: (DVec3, DVec3)) -> Self {
        let (a, b) = if key(a.0) <= key(b.0) { (a, b) } else { (b, a) };
        Self { points: [a.0, b.0], normals: [a.1, b.1] }
    }

    fn key(&self) -> [[u64; 3]; 2] {
        self.points.map(key)
    }
}

/// A point as bits: equal points, and only those, have the same.
fn key(point: DVec3) -> [u64; 3] {
    // −0 lies where 0 does.
    point.to_array().map(|x| (x + 0.0).to_bits())
}

/// The edges at which several rims lie and two of them `differ` in the normals at either end, once each.
pub(super) fn seams(mut rims: Vec<Rim>, differ: impl Fn(DVec3, DVec3) -> bool) -> Vec<[DVec3; 2]> {
    rims.sort_by_cached_key(Rim::key);
    let at_one_place = rims.chunk_by(|a, b| a.key() == b.key());
    let is_seam = |rims: &&[Rim]| {
        // Where no rim is unlike the first, none is unlike another by more than twice what counts as a difference.
        let [first, others @ ..] = *rims else { return false };
        others.iter().any(|rim| (0..2).any(|end| differ(first.normals[end], rim.normals[end])))
    };
    at_one_place.filter(is_seam).map(|rims| rims[0].points).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seam_is_where_rims_meet_whose_normals_differ() {
        let (a, b, c) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let up = Rim::new((a, DVec3::Z), (b, DVec3::Z));
        // The same place the other way round, with zero's other sign.
        let next_to = |normal| Rim::new((b, normal), (-a, DVec3::Z));
        let elsewhere = Rim::new((a, DVec3::X), (c, DVec3::X));
        let unlike = |a: DVec3, b: DVec3| a != b;
        assert_eq!(seams(vec![up, elsewhere, next_to(DVec3::Z)], unlike), [] as [[DVec3; 2]; 0]);
        assert_eq!(seams(vec![up, elsewhere, next_to(DVec3::X)], unlike), [[a, b]]);
        assert_eq!(seams(vec![next_to(DVec3::X)], unlike), [] as [[DVec3; 2]; 0]);
    }
}
