//! Faces and vertices that are duplicates of others.

use crate::mesh::{ColumnIndex, FaceLabels, place_key};
use crate::normals::Weight;
use crate::num::parallel;
use crate::quality::estimate::means::term;
use crate::quality::findings::geometry::vertices::{index_mean, index_mean_error};
use crate::quality::findings::prelude::*;
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::FxHashSet;

pub(crate) fn search_faces(facts: &Facts<'_>, found: &mut Found) {
    for face in facts.duplicates.same_way.iter().map(|&face| face as usize) {
        found.add(Kind::DuplicateFaces, Spot::face(face).by(counted_twice(facts, face)), facts.area[face]);
    }
    for face in facts.duplicates.back_to_back.iter().map(|&face| face as usize) {
        found.add(Kind::BackToBack, Spot::face(face).by(180.0), facts.area[face]);
    }
}

/// The largest angle in degrees by which the means at the corners of a face turn if it counts twice.
fn counted_twice(facts: &Facts<'_>, face: usize) -> f64 {
    let turn = |corner: usize| {
        let twice = index_mean(facts, facts.vertex(corner));
        let once = twice - term(facts, corner as u32, Weight::Angle);
        if twice == DVec3::ZERO || once == DVec3::ZERO { 0.0 } else { degrees_between(twice, once) }
    };
    facts.corners_of(face).map(turn).fold(0.0, f64::max)
}

/// Finds vertices of faces that nothing distinguishes from an earlier one. If normals are stored, needless seams report these.
pub(crate) fn search_vertices(facts: &Facts<'_>, found: &mut Found) {
    if facts.stored.is_some() || !facts.file.shares_vertices() {
        return;
    }
    let key = |vertex: usize| {
        let vertex = vertex as u32;
        let is_used = !facts.topology.corners_at(vertex).is_empty();
        is_used.then(|| (place_key(facts.mesh.positions().at(vertex)), vertex))
    };
    let mut keys = parallel::filter_map(facts.mesh.vertex_count(), key);
    keys.par_sort_unstable();
    for at_one_position in keys.chunk_by(|a, b| a.0 == b.0).filter(|chunk| chunk.len() > 1) {
        let mut different: FxHashSet<Vec<u64>> = FxHashSet::default();
        for &(_, vertex) in at_one_position {
            if !different.insert(attributes(facts, vertex)) {
                let spot = Spot::vertex(vertex as usize).by(index_mean_error(facts, vertex));
                found.add(Kind::DuplicateVertices, spot, 0.0);
            }
        }
    }
}

/// All attributes of a vertex but its position, by their bits, with the material and object of its first face.
fn attributes(facts: &Facts<'_>, vertex: u32) -> Vec<u64> {
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
