//! Faces and vertices that stand twice at one place.

use crate::mesh::{ColumnIndex, FaceLabels, place_key};
use crate::quality::catalogue::Kind;
use crate::quality::counts::{Spot, Tallies};
use crate::quality::estimate::other_programs;
use crate::quality::facts::Facts;
use rayon::prelude::*;
use rustc_hash::{FxHashMap, FxHashSet};

/// Faces with the same places for corners as an earlier one.
#[derive(Debug, Default)]
pub(in crate::quality) struct Doubles {
    /// Those that go round the same way, and each the one that they are of.
    again: Vec<[u32; 2]>,
    /// Those that go round the other way, ascending.
    back_to_back: Vec<u32>,
    /// All that stand twice the same way, ascending.
    same_way: Vec<u32>,
}

impl Doubles {
    pub(in crate::quality) fn new(facts: &Facts<'_>) -> Self {
        let mut doubles = Self::default();
        let mut first: FxHashMap<Vec<[u64; 3]>, u32> = FxHashMap::default();
        for face in crowded_faces(facts) {
            let places = places(facts, face);
            let lowest = (0..places.len()).min_by_key(|&i| places[i]).unwrap_or(0);
            let mut turned = places.clone();
            turned.rotate_left(lowest);
            let mut reversed = turned.clone();
            reversed[1..].reverse();
            if let Some(&other) = first.get(&turned) {
                doubles.again.push([face as u32, other]);
                continue;
            }
            if first.contains_key(&reversed) {
                doubles.back_to_back.push(face as u32);
            }
            first.insert(turned, face as u32);
        }
        doubles.same_way = doubles.again.as_flattened().to_vec();
        doubles.same_way.sort_unstable();
        doubles.same_way.dedup();
        doubles
    }

    /// Whether a face is the back of an earlier one.
    pub(in crate::quality) fn is_back(&self, face: u32) -> bool {
        self.back_to_back.binary_search(&face).is_ok()
    }

    /// All faces that stand twice the same way, ascending.
    pub(in crate::quality) fn same_way(&self) -> &[u32] {
        &self.same_way
    }
}

/// Tells of faces that stand twice.
pub(in crate::quality) fn faces(facts: &Facts<'_>, found: &mut Tallies) {
    let mut tell = |kind: Kind, face: u32, degrees: f64| {
        found.add(kind, Spot::face(face as usize, 0.0).by(degrees), facts.area[face as usize]);
    };
    for &[face, _] in &facts.doubles.again {
        tell(Kind::DuplicateFaces, face, other_programs::once_more(facts, face as usize));
    }
    facts.doubles.back_to_back.iter().for_each(|&face| tell(Kind::BackToBack, face, 180.0));
}

/// Faces that may have their corners at the same places as another: the only ones worth comparing corner by corner, and in most
/// meshes next to none.
fn crowded_faces(facts: &Facts<'_>) -> Vec<usize> {
    const UNUSUAL: u64 = 0x9e37_79b9_7f4a_7c15;
    let key = |face: usize| {
        let range = facts.mesh.faces().range(face);
        // The sum of the places does not depend on their order if it is one of whole numbers.
        let hash = |place: [u64; 3]| {
            place.iter().fold(0u64, |hash, &bits| (hash ^ bits).wrapping_mul(UNUSUAL).rotate_left(29))
        };
        range.fold(0u64, |sum, corner| sum.wrapping_add(hash(place(facts, corner)))).wrapping_mul(UNUSUAL)
    };
    // 32 bits of the key before the face: what they take for alike is compared by places, and is little.
    let packed = |face: usize| match facts.area[face] > 0.0 {
        true => key(face) & !u64::from(u32::MAX) | face as u64,
        false => NO_FACE,
    };
    let mut keys: Vec<u64> = (0..facts.mesh.face_count()).into_par_iter().map(packed).collect();
    keys.par_sort_unstable();
    let mut faces: Vec<usize> = keys[..keys.partition_point(|&key| key < NO_FACE)]
        .chunk_by(|a, b| a >> 32 == b >> 32)
        .filter(|chunk| chunk.len() > 1)
        .flat_map(|chunk| chunk.iter().map(|&key| key as u32 as usize))
        .collect();
    faces.sort_unstable();
    faces
}

/// In place of a key, behind all of them: no face has the highest number of 32 bits.
const NO_FACE: u64 = u64::MAX;

fn places(facts: &Facts<'_>, face: usize) -> Vec<[u64; 3]> {
    facts.mesh.faces().range(face).map(|corner| place(facts, corner)).collect()
}

/// The position of a corner.
fn place(facts: &Facts<'_>, corner: usize) -> [u64; 3] {
    place_key(facts.mesh.positions()[facts.mesh.faces().corners()[corner] as usize])
}

/// Finds vertices, of those that faces use, that nothing tells from an earlier one. Where normals are stored, seams tell.
pub(in crate::quality) fn vertices(facts: &Facts<'_>, found: &mut Tallies) {
    if facts.stored.is_some() || !facts.shares_vertices {
        return;
    }
    let place = |vertex: u32| place_key(facts.mesh.positions()[vertex as usize]);
    let used = (0..facts.mesh.vertex_count() as u32)
        .into_par_iter()
        .filter(|&vertex| !facts.topology.corners_at(vertex).is_empty());
    let mut keys: Vec<([u64; 3], u32)> = used.map(|vertex| (place(vertex), vertex)).collect();
    keys.par_sort_unstable();
    for at_one_place in keys.chunk_by(|a, b| a.0 == b.0).filter(|chunk| chunk.len() > 1) {
        let mut different: FxHashSet<Vec<u64>> = FxHashSet::default();
        for &(_, vertex) in at_one_place {
            if !different.insert(said_of(facts, vertex)) {
                let spot = Spot::vertex(vertex as usize, 0.0).by(other_programs::by_index(facts, vertex));
                found.add(Kind::DuplicateVertices, spot, 0.0);
            }
        }
    }
}

/// All that a file may say of a vertex beside its place, by its bits, and the material and object of its first face.
fn said_of(facts: &Facts<'_>, vertex: u32) -> Vec<u64> {
    let columns = facts.mesh.columns();
    let face = facts.topology.face_of(facts.topology.corners_at(vertex)[0]) as usize;
    let vertex = vertex as usize;
    let label = |labels: &Option<FaceLabels>| labels.as_ref().map(|labels| u64::from(labels.of_face[face]));
    let uv = columns.uvs.iter().filter(|uvs| matches!(uvs.index, ColumnIndex::PerVertex));
    let uv = uv.flat_map(|uvs| uvs.values[vertex].to_array().map(f64::from));
    let colour = columns.colors.iter().flat_map(|colours| colours[vertex].map(f64::from));
    let morphed = columns.morph_targets.iter().flat_map(|target| target[vertex].to_array());
    // Zero has two signs and is one number.
    let bits = uv.chain(colour).chain(morphed).map(|x| (x + 0.0).to_bits());
    bits.chain([&columns.materials, &columns.objects].into_iter().filter_map(label)).collect()
}
