//! What readers and writers of all formats check: sizes, positions, faces, and features that a format does not have.

use super::{Format, Limits, NonFinite, Note, Part, Place, Problem, ReadError, ReadOptions, WriteError};
use crate::mesh::{ColumnIndex, Columns, Faces, Mesh, MeshBuilder, MeshError, NONE, PositionsRef};
use crate::num::parallel;
use glam::DVec3;

pub(super) const DROP_ADVICE: &str = "correct it, or drop the faces at such vertices with `crease normals --force` (`crease render --force` draws the others)";
pub(super) const DAMAGED: &str = "the file is damaged; export it again";

pub(super) fn check_size(bytes: u64, limits: &Limits) -> Result<(), ReadError> {
    if bytes <= limits.bytes {
        return Ok(());
    }
    let found = format!("the file has {bytes} bytes (limit {})", limits.bytes);
    Err(ReadError::new(Problem::Limit, Place::File, found, "split the file"))
}

/// The warning about positions that are not finite in a file that is accepted with them.
pub(super) fn non_finite_note(positions: PositionsRef, non_finite: NonFinite) -> Option<Note> {
    let first = positions.first_non_finite().filter(|_| non_finite == NonFinite::DropFaces)?;
    let count = positions.iter().filter(|position| !position.is_finite()).count();
    let text = format!(
        "no finite position (first: vertex {first}); their faces are dropped; an edited file keeps the stored \
         positions, a new file has the origin instead"
    );
    Note::counted(count, ["vertex has", "vertices have"], text)
}

/// Builds a mesh; also returns the faces that use a vertex without a finite position.
pub(super) fn build_mesh(builder: MeshBuilder, non_finite: NonFinite) -> Result<(Mesh, Vec<u32>), MeshError> {
    match non_finite {
        NonFinite::Refuse => builder.build().map(|mesh| (mesh, Vec::new())),
        NonFinite::DropFaces => builder.build_dropping_non_finite(),
    }
}

/// Builds the mesh of a part. `place` is where the vertex or face of the error is.
pub(super) fn build_part(
    name: String,
    builder: MeshBuilder,
    options: &ReadOptions,
    place: impl FnOnce(&MeshError) -> Place,
) -> Result<Part, ReadError> {
    let (mesh, non_finite_faces) = build_mesh(builder, options.non_finite).map_err(|error| {
        let (problem, advice) = match error {
            MeshError::NonFinite { .. } => (Problem::NonFinite, DROP_ADVICE),
            MeshError::TooLarge { .. } => (Problem::Limit, "split the mesh"),
            _ => (Problem::Range, DAMAGED),
        };
        ReadError::new(problem, place(&error), error.to_string(), advice)
    })?;
    Ok(Part { name, mesh, non_finite_faces })
}

/// Warnings about the faces of a file as a whole.
pub(super) fn face_notes(parts: &[Part]) -> Vec<Note> {
    if parts.iter().all(|part| part.mesh.face_count() == 0) {
        return vec![Note::warning(Place::File, "the file has no faces, so it has no normals")];
    }
    let repeating = parts.iter().map(|part| repeating(part.mesh.faces())).sum();
    let text = "through a vertex more than once; crease uses the enclosed area";
    Note::counted(repeating, ["polygon passes", "polygons pass"], text).into_iter().collect()
}

/// How many polygons pass through a vertex more than once. Triangles that do have no area and are counted as that.
fn repeating(faces: &Faces) -> usize {
    if faces.is_triangles() {
        return 0;
    }
    let repeats = |sorted: &mut Vec<u32>, face: usize| {
        sorted.clear();
        sorted.extend_from_slice(faces.face(face));
        sorted.sort_unstable();
        sorted.len() > 3 && sorted.windows(2).any(|pair| pair[0] == pair[1])
    };
    let repeating = parallel::map_with(faces.len(), Vec::new, repeats);
    repeating.into_iter().filter(|&repeats| repeats).count()
}

/// What a mesh may have: its name, the formats that cannot store it, and whether columns have it.
type Feature = (&'static str, &'static [Format], fn(&Columns) -> bool);

const FEATURES: [Feature; 9] = {
    use Format::{Glb, Gltf, Obj, Ply, Stl};
    [
        ("texture coordinates", &[Stl], |columns| columns.uvs.is_some()),
        ("colours", &[Stl], |columns| columns.colors.is_some()),
        ("materials", &[Stl, Ply], |columns| columns.materials.is_some()),
        ("objects and groups", &[Stl, Ply], |columns| columns.objects.is_some()),
        ("smoothing groups", &[Stl, Ply], |columns| columns.smoothing.is_some()),
        ("hard edges", &[Obj, Ply, Gltf, Glb], |columns| !columns.hard_edges.is_empty()),
        ("morph targets", &Format::ALL, |columns| !columns.morph_targets.is_empty()),
        ("points", &[Stl], |columns| !columns.points.is_empty()),
        ("lines", &[Stl], |columns| !columns.lines.is_empty()),
    ]
};

/// A warning for each feature of the parts that a new file of this format cannot store.
pub(super) fn unsupported_notes(format: Format, parts: &[Part]) -> Vec<Note> {
    let title = if format.is_gltf() { "glTF".to_owned() } else { format.extension().to_ascii_uppercase() };
    let lost = FEATURES.iter().filter(|(_, without, has)| {
        without.contains(&format) && parts.iter().any(|part| has(part.mesh.columns()))
    });
    let text = |name| format!("{title} has no {name}; they were omitted");
    lost.map(|(name, ..)| Note::warning(Place::File, text(name))).collect()
}

/// A warning about corners that the new file gives a texture coordinate, as others of their mesh have one. `is_one_mesh` if all
/// parts become one.
pub(super) fn blank_uv_note<'a>(
    title: &str,
    parts: impl Iterator<Item = &'a Part> + Clone,
    is_one_mesh: bool,
) -> Option<Note> {
    let meshes = parts.map(|part| &part.mesh);
    let are_wanted = is_one_mesh && meshes.clone().any(|mesh| mesh.columns().uvs.is_some());
    let blank = |mesh: &Mesh| match mesh.columns().uvs.as_ref().map(|uvs| &uvs.index) {
        Some(ColumnIndex::PerCorner(index)) => index.iter().filter(|&&uv| uv == NONE).count(),
        None if are_wanted => mesh.faces().corners().len(),
        _ => 0,
    };
    let blank = meshes.map(blank).sum();
    let nouns = ["corner without texture coordinates was", "corners without texture coordinates were"];
    Note::counted(blank, nouns, format_args!("written to the {title} with (0, 0)"))
}

/// The error about a mesh with a position that is infinite as `f32`.
pub(super) fn beyond_f32(mesh: &Mesh) -> WriteError {
    let vertex = mesh.positions().iter().position(|p| !p.as_vec3().is_finite()).unwrap_or(0);
    let DVec3 { x, y, z } = mesh.positions().at(vertex as u32);
    WriteError::Unsupported(format!(
        "vertex {vertex} at ({x:e}, {y:e}, {z:e}) is out of the range of 32-bit floats; scale the model, or write PLY \
         or OBJ"
    ))
}

/// Whether any position of a mesh is not an `f32`.
pub(super) fn needs_f64(mesh: &Mesh) -> bool {
    let PositionsRef::F64(points) = mesh.positions() else { return false };
    points.iter().any(|p| p.as_vec3().as_dvec3() != *p)
}

/// A warning if rounding to `f32` moves vertices far compared with the size of the model: usually by at most 2⁻²⁵ of it.
pub(super) fn displacement_note(mesh: &Mesh) -> Option<Note> {
    let PositionsRef::F64(points) = mesh.positions() else { return None };
    let moved = |p: &DVec3| p.distance(p.as_vec3().as_dvec3());
    let largest = parallel::ranges(points.len(), |range| points[range].iter().map(moved).fold(0.0, f64::max));
    let largest = largest.into_iter().fold(0.0, f64::max);
    let size = mesh.bounds().map_or(0.0, |(low, high)| low.distance(high));
    (size > 0.0 && largest > size / f64::from(1 << 20)).then(|| {
        let text = format!(
            "rounding positions to 32-bit floats moves vertices by up to {largest:.3e}, {:.1e} of the model's size; \
             move the model closer to the origin, or write PLY or OBJ",
            largest / size
        );
        Note::warning(Place::File, text)
    })
}

#[cfg(test)]
mod tests {
    use crate::io::{Format, ReadOptions, read_bytes};

    #[test]
    fn files_without_faces_and_faces_that_come_back_are_reported() {
        let notes = |faces: &str| {
            let text = format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\n{faces}");
            let loaded = read_bytes(text.into(), Some(Format::Obj), None, &ReadOptions::default()).unwrap();
            loaded.notes.iter().map(|note| note.text.clone()).collect::<Vec<_>>()
        };
        assert_eq!(notes(""), ["the file has no faces, so it has no normals"]);
        assert_eq!(notes("f 1 2 3 4\nf 1 2 3\n"), [] as [&str; 0]);
        let reported = "polygon passes through a vertex more than once; crease uses the enclosed area";
        assert_eq!(notes("f 1 2 3 4\nf 1 2 3 5 3 4\n"), [format!("1 {reported}")]);
    }
}
