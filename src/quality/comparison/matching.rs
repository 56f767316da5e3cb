//! Which corners of two files are the same corner of the same face.
//!
//! Faces are matched by the places of their corners, in single precision, since that is what most formats keep: neither
//! the order of faces and vertices, nor splits, nor the cut into parts matters. Faces that stand several times at one
//! place are matched in their order. Of what is left over, polygons are matched with the triangles that they became, and
//! polygons that became other polygons as triangles.

use crate::mesh::{Faces, Mesh, triangulate};
use crate::quality::comparison::cut::cuts;
use rayon::prelude::*;

/// Faces of one place that are looked through for one that runs the same way, before any is taken.
const LOOKED_THROUGH: usize = 8;

/// Polygons of more corners are not looked through for where they begin.
pub(super) const MOST_STARTS: usize = 1024;

/// The corners of all parts of a file, numbered through.
pub(super) struct Side<'a> {
    meshes: Vec<&'a Mesh>,
    /// The number of the first corner of each part, and of all corners at the end.
    starts: Vec<usize>,
}

/// What was found to be the same.
#[derive(Default)]
pub(super) struct Matching {
    /// Corners before and after, ascending, each pair once.
    pub(super) pairs: Vec<[u32; 2]>,
    /// Of each file, the faces that have no counterpart, or whose triangles have not all one.
    pub(super) unmatched: [usize; 2],
    /// Faces, or triangles of them, that go round the other way.
    pub(super) turned: usize,
}

impl<'a> Side<'a> {
    pub(super) fn new(meshes: Vec<&'a Mesh>) -> Self {
        let mut starts = vec![0];
        for mesh in &meshes {
            starts.push(starts[starts.len() - 1] + mesh.faces().corner_count());
        }
        Self { meshes, starts }
    }

    /// How many corners there are.
    pub(super) fn corners(&self) -> usize {
        self.starts[self.meshes.len()]
    }

    /// How many faces there are.
    pub(super) fn faces(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.face_count()).sum()
    }

    /// The part of a corner, and its number in that part.
    pub(super) fn locate(&self, corner: u32) -> (usize, usize) {
        let part = self.starts.partition_point(|&start| start <= corner as usize) - 1;
        (part, corner as usize - self.starts[part])
    }

    /// The bits of a corner's position in single precision, −0 taken as +0.
    pub(super) fn place(&self, corner: u32) -> [u32; 3] {
        let (part, corner) = self.locate(corner);
        let mesh = self.meshes[part];
        let position = mesh.positions()[mesh.faces().corners()[corner] as usize];
        position.to_array().map(|x| (x as f32 + 0.0).to_bits())
    }

    /// All faces, as lists of corners.
    fn whole(&self) -> Faces {
        let mut faces = Faces::with_capacity(self.corners());
        let mut corners = Vec::new();
        for (mesh, start) in self.meshes.iter().zip(&self.starts) {
            for range in mesh.faces().ranges() {
                corners.clear();
                corners.extend(range.map(|corner| (start + corner) as u32));
                faces.push(&corners);
            }
        }
        faces
    }

    /// The triangles of some faces, told by a mark for each face, as lists of corners; and the face of each.
    fn triangles(&self, wanted: &[bool]) -> (Faces, Vec<u32>) {
        let (mut corners, mut owners) = (Vec::new(), Vec::new());
        let mut first_face = 0;
        for (mesh, &start) in self.meshes.iter().zip(&self.starts) {
            let cut = triangulate(mesh);
            for (triangle, face) in cut.triangles.iter().zip(cut.source_face) {
                if wanted[first_face + face as usize] {
                    corners.extend(triangle.iter().map(|corner| start as u32 + corner));
                    owners.push((first_face + face as usize) as u32);
                }
            }
            first_face += mesh.face_count();
        }
        (Faces::triangles(corners), owners)
    }
}

impl Matching {
    /// Matches whole faces, polygons with triangles, and what is left over as triangles.
    pub(super) fn find(sides: &[Side<'_>; 2]) -> Self {
        let mut found = Self::default();
        let faces = sides.each_ref().map(Side::whole);
        let mut missing = found.pair_up(sides, &faces);
        for polygons in [0, 1] {
            found.pair_cut(sides, &faces, &mut missing, polygons);
        }
        if missing.iter().all(|missing| missing.contains(&true)) {
            let cut = [0, 1].map(|side| sides[side].triangles(&missing[side]));
            let [(before, owners), (after, others)] = cut;
            let left = found.pair_up(sides, &[before, after]);
            for (missing, (left, owners)) in missing.iter_mut().zip(left.iter().zip([owners, others])) {
                missing.fill(false);
                for (&face, _) in owners.iter().zip(left).filter(|(_, left)| **left) {
                    missing[face as usize] = true;
                }
            }
        }
        found.unmatched = missing.map(|missing| missing.into_iter().filter(|&missing| missing).count());
        found.pairs.par_sort_unstable();
        // Two triangles of a polygon share corners.
        found.pairs.dedup();
        found
    }

    /// Pairs the corners of polygons of one side with those of the triangles that they became on the other.
    fn pair_cut(
        &mut self,
        sides: &[Side<'_>; 2],
        faces: &[Faces; 2],
        missing: &mut [Vec<bool>; 2],
        polygons: usize,
    ) {
        let triangles = 1 - polygons;
        let order = [polygons, triangles];
        for cut in cuts(order.map(|i| &sides[i]), order.map(|i| &faces[i]), order.map(|i| &missing[i][..])) {
            let in_order = |[polygon, triangle]: [u32; 2]| {
                if polygons == 0 { [polygon, triangle] } else { [triangle, polygon] }
            };
            self.pairs.extend(cut.pairs.into_iter().map(in_order));
            self.turned += cut.turned;
            missing[polygons][cut.face as usize] = false;
            cut.triangles.into_iter().for_each(|triangle| missing[triangles][triangle as usize] = false);
        }
    }

    /// Pairs the corners of faces that stand at the same places; marks the faces of each side that found none.
    fn pair_up(&mut self, sides: &[Side<'_>; 2], faces: &[Faces; 2]) -> [Vec<bool>; 2] {
        let keys = [0, 1].map(|side| keys(&sides[side], &faces[side]));
        let mut missing = [0, 1].map(|side| vec![true; faces[side].len()]);
        let mut rest = keys[1].as_slice();
        for run in keys[0].chunk_by(|a, b| a.0 == b.0) {
            rest = &rest[rest.partition_point(|key| key.0 < run[0].0)..];
            let (mut same, other) = rest.split_at(rest.partition_point(|key| key.0 == run[0].0));
            rest = other;
            for &(_, before) in run {
                while same.first().is_some_and(|&(_, after)| !missing[1][after as usize]) {
                    same = &same[1..];
                }
                let first = faces[0].face(before as usize);
                let candidates = same.iter().take(LOOKED_THROUGH).map(|&(_, after)| after);
                let aligned = candidates.filter(|&after| missing[1][after as usize]).filter_map(|after| {
                    Some((after, Alignment::find(sides, first, faces[1].face(after as usize))?))
                });
                let Some((after, alignment)) = aligned.min_by_key(|(_, alignment)| alignment.is_turned)
                else {
                    continue;
                };
                let second = faces[1].face(after as usize);
                self.pairs
                    .extend((0..first.len()).map(|i| [first[i], second[alignment.at(i, second.len())]]));
                self.turned += usize::from(alignment.is_turned);
                missing[0][before as usize] = false;
                missing[1][after as usize] = false;
            }
        }
        missing
    }
}

/// How the corners of a face follow those of another.
#[derive(Clone, Copy)]
struct Alignment {
    /// Where the first corner of the one is in the other.
    start: usize,
    /// Whether the other goes round the other way.
    is_turned: bool,
}

impl Alignment {
    fn find(sides: &[Side<'_>; 2], before: &[u32], after: &[u32]) -> Option<Self> {
        let count = before.len();
        if after.len() != count {
            return None;
        }
        // Among very many corners only the first is tried; such polygons are still matched as triangles.
        let starts = if count > MOST_STARTS { 1 } else { count };
        let ways = [false, true];
        let ways = ways.into_iter().flat_map(|is_turned| (0..starts).map(move |start| (start, is_turned)));
        ways.map(|(start, is_turned)| Self { start, is_turned }).find(|way| {
            (0..count).all(|i| sides[0].place(before[i]) == sides[1].place(after[way.at(i, count)]))
        })
    }

    fn at(self, corner: usize, count: usize) -> usize {
        (self.start + if self.is_turned { count - corner } else { corner }) % count
    }
}

/// Each face with a number that depends on the places of its corners only, not on their order; sorted.
fn keys(side: &Side<'_>, faces: &Faces) -> Vec<(u64, u32)> {
    let mix = |place: [u32; 3]| {
        place.iter().fold(0u64, |hash, &bits| {
            (hash ^ u64::from(bits)).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29)
        })
    };
    let key = |face: usize| {
        faces.face(face).iter().fold(0u64, |sum, &corner| sum.wrapping_add(mix(side.place(corner))))
    };
    let mut keys: Vec<(u64, u32)> =
        (0..faces.len()).into_par_iter().map(|face| (key(face), face as u32)).collect();
    keys.par_sort_unstable();
    keys
}
