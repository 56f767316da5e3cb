//! The normals of plain triangles, vertex by vertex.
//!
//! Most meshes need no topology: edges are hard for nothing but their angle, none is joined to another by position, every
//! triangle has an area and every sum a direction. Then the corners at each vertex determine its smooth groups.

use crate::mesh::{Column, FacesRef, Mesh, Weld, joins_no_edges};
use crate::normals::creases::coordinate_rounding::turns_by_rounding;
use crate::normals::creases::dihedral_test::CreaseTest;
use crate::normals::creases::hard_edges::{Marks, applied_angle};
use crate::normals::creases::triangle_groups::{GroupMemory, TriangleCreases};
use crate::normals::faces::face_normals::{FaceNormals, face_normals};
use crate::normals::faces::positions::Positions;
use crate::normals::faces::shape::FaceState;
use crate::normals::fault::{Fault, FaultReason, Faults};
use crate::normals::field::{Extras, NormalField, Summary};
use crate::normals::recipe::{CreaseRule, NormalRecipe, Precision, Scope, Weight};
use crate::normals::sums::request::{SumRequest, Sums};
use crate::normals::sums::single_precision::single_sums;
use crate::normals::sums::weighted_sums::{SumScratch, weighted_sums_into};
use crate::num::Degrees;
use glam::DVec3;
use rayon::prelude::*;

/// The field, with the bits that a topology would give. `Err` if the mesh or the recipe needs one, with the normals of faces
/// if they were found on the way.
pub(super) fn triangle_field(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    extras: Extras,
) -> Result<NormalField, Option<FaceNormals>> {
    if !is_plain(mesh, recipe) {
        return Err(None);
    }
    let faces = mesh.faces().view();
    let positions = Positions::F64(mesh.positions(), mesh.storage());
    let angle = applied_angle(mesh, recipe);
    let crease = CreaseTest::new(angle);
    let wants_normals = extras.face_normals || !matches!(crease, CreaseTest::None);
    let normals = if wants_normals { face_normals(faces, positions) } else { FaceNormals::default() };
    if !normals.state.par_iter().all(|&state| state == FaceState::Counted) {
        return Err(Some(normals));
    }

    let turns = extras.edge_counts.then(|| turns(mesh, &crease));
    // Separate triangles meet where their positions are equal: numbering vertices by position joins all that welding would.
    let joined = (recipe.weld == Weld::Exact && mesh.is_soup()).then(|| mesh.first_vertices());
    let creases = TriangleCreases {
        faces: joined.as_ref().map_or(faces, |vertices| FacesRef::triangles(vertices.as_chunks().0)),
        normals: &normals,
        crease,
        slivers: recipe.slivers,
        counts: turns.as_ref().map(Option::as_deref),
    };
    let mut memory = GroupMemory::default();
    let mut corner_slot = bytemuck::zeroed_vec(faces.corners().len());
    let (slots, found) = creases.entries(mesh.vertex_count(), &mut memory, &mut corner_slot);
    let known = |normals| wants_normals.then_some(normals);
    if recipe.weld == Weld::Exact && joined.is_none() && !joins_no_edges(mesh, &found.open) {
        return Err(known(normals));
    }
    let entry_vertex = if joined.is_some() { faces.corners().to_vec() } else { memory.entry_vertices(slots) };
    let is_joined = joined.is_some();
    drop((memory, joined));

    let request = SumRequest {
        faces,
        positions,
        target: &corner_slot,
        slots,
        weight: recipe.weight,
        slivers: recipe.slivers,
    };
    let fast = recipe.precision == Precision::Fast;
    let single = fast.then(|| single_sums(&request)).flatten();
    let fast_declined = fast && single.is_none();
    let unit = match single {
        Some(sums) => sums.unit,
        None => {
            let Sums { mut unit, mut state } = Sums::new(slots);
            let outcome = weighted_sums_into(&request, &mut SumScratch::default(), &mut unit, &mut state);
            if !outcome.all_good || !outcome.unusual.is_empty() {
                return Err(known(normals));
            }
            unit
        }
    };

    let mut summary = Summary {
        crease_degrees: angle.map(|Degrees(angle)| angle),
        referenced_vertices: count_runs(&entry_vertex),
        fast_declined,
        ..Summary::default()
    };
    summary.splits = entry_vertex.len() - summary.referenced_vertices;
    if extras.edge_counts {
        (summary.edges, summary.near_crease) = found.finish(is_joined);
    }
    let (values, corner_entry) = if is_joined {
        let of_corner: Vec<DVec3> = corner_slot.par_iter().map(|&slot| unit[slot as usize]).collect();
        (of_corner, entry_vertex.clone())
    } else {
        (unit, corner_slot)
    };
    let vertices = unreferenced(&entry_vertex, mesh.vertex_count());
    Ok(NormalField {
        normals: Column::per_corner(values, corner_entry),
        entry_vertex,
        face_normals: if extras.face_normals { normals.unit } else { Vec::new() },
        morph_normals: Vec::new(),
        faults: Faults { vertices, ..Faults::default() },
        summary,
    })
}

/// Whether the mesh has only triangles and the recipe asks for nothing that takes a topology.
fn is_plain(mesh: &Mesh, recipe: &NormalRecipe) -> bool {
    let asks_little = recipe.weight != Weight::Quadric
        && (recipe.scope, recipe.rule) == (Scope::Corner, CreaseRule::Fan)
        && matches!(recipe.weld, Weld::Exact | Weld::Off);
    asks_little
        && mesh.faces().is_triangles()
        && mesh.columns().morph_targets.is_empty()
        && Marks::new(mesh, recipe).is_empty()
}

/// By how many radians the rounding of coordinates may turn the normal of each face, if that matters to the test.
pub(super) fn turns(mesh: &Mesh, crease: &CreaseTest) -> Option<Vec<f64>> {
    matches!(crease, CreaseTest::Over { .. }).then(|| turns_by_rounding(mesh)).flatten()
}

/// How many different values an ascending list has.
pub(super) fn count_runs(ascending: &[u32]) -> usize {
    ascending.chunk_by(|a, b| a == b).count()
}

/// The vertices that no entry belongs to.
pub(super) fn unreferenced(entry_vertex: &[u32], vertex_count: usize) -> Vec<Fault> {
    let mut entries = entry_vertex.iter().copied().peekable();
    let vertices = 0..vertex_count as u32;
    vertices
        .filter(|&vertex| {
            let mut used = false;
            while entries.next_if_eq(&vertex).is_some() {
                used = true;
            }
            !used
        })
        .map(|index| Fault { index, reason: FaultReason::Unreferenced })
        .collect()
}
