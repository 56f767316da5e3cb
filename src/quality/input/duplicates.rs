//! Faces whose corners are at the same positions as those of an earlier face.

use crate::mesh::{Mesh, place_key};
use crate::num::parallel;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

#[derive(Debug, Default)]
pub(crate) struct DuplicateFaces {
    /// Those that run the same way as an earlier one.
    pub(crate) same_way: Vec<u32>,
    /// Those with the opposite winding to an earlier one, ascending.
    pub(crate) back_to_back: Vec<u32>,
    /// All faces that have a duplicate that runs the same way, the first ones included, ascending.
    pub(crate) all_same_way: Vec<u32>,
}

impl DuplicateFaces {
    pub(crate) fn find(mesh: &Mesh, area: &[f64]) -> Self {
        let mut found = Self::default();
        let mut first: FxHashMap<Vec<[u64; 3]>, u32> = FxHashMap::default();
        for face in candidates(mesh, area) {
            let mut positions: Vec<[u64; 3]> = mesh.faces().range(face).map(|it| key(mesh, it)).collect();
            let lowest = (0..positions.len()).min_by_key(|&i| positions[i]).unwrap_or(0);
            positions.rotate_left(lowest);
            if let Some(&other) = first.get(&positions) {
                found.same_way.push(face as u32);
                found.all_same_way.extend([face as u32, other]);
                continue;
            }
            let mut reversed = positions.clone();
            reversed[1..].reverse();
            if first.contains_key(&reversed) {
                found.back_to_back.push(face as u32);
            }
            first.insert(positions, face as u32);
        }
        found.all_same_way.sort_unstable();
        found.all_same_way.dedup();
        found
    }

    /// Whether a face is the back of an earlier one.
    pub(crate) fn is_back(&self, face: u32) -> bool {
        self.back_to_back.binary_search(&face).is_ok()
    }

    pub(crate) fn is_doubled(&self, face: u32) -> bool {
        self.all_same_way.binary_search(&face).is_ok()
    }
}

/// Faces that may have a duplicate, ascending: those whose hashes agree with those of others.
fn candidates(mesh: &Mesh, area: &[f64]) -> Vec<usize> {
    const FACTOR: u64 = 0x9e37_79b9_7f4a_7c15;
    /// Sorts behind all faces: none has the highest number of 32 bits.
    const NO_FACE: u64 = u64::MAX;
    let hash = |position: [u64; 3]| {
        position.iter().fold(0u64, |hash, &bits| (hash ^ bits).wrapping_mul(FACTOR).rotate_left(29))
    };
    // A sum of whole numbers does not depend on their order.
    let sum =
        |face: usize| mesh.faces().range(face).fold(0u64, |sum, it| sum.wrapping_add(hash(key(mesh, it))));
    // 32 bits of the hash before the number of the face.
    let packed = |face: usize| match area[face] > 0.0 {
        true => sum(face).wrapping_mul(FACTOR) & !u64::from(u32::MAX) | face as u64,
        false => NO_FACE,
    };
    let mut keys = parallel::map(mesh.face_count(), packed);
    keys.par_sort_unstable();
    let runs = keys[..keys.partition_point(|&key| key < NO_FACE)].chunk_by(|a, b| a >> 32 == b >> 32);
    let alike = runs.filter(|run| run.len() > 1).flatten();
    let mut faces: Vec<usize> = alike.map(|&key| key as u32 as usize).collect();
    faces.sort_unstable();
    faces
}

fn key(mesh: &Mesh, corner: usize) -> [u64; 3] {
    place_key(mesh.positions().at(mesh.faces().corners()[corner]))
}
