//! What is odd about faces, whatever file they come from.

use super::text::counted;
use super::{Note, Part, Place};
use crate::mesh::Faces;
use rayon::prelude::*;

/// Warnings about the faces of a file as a whole.
pub(super) fn remarks(parts: &[Part]) -> Vec<Note> {
    if parts.iter().all(|part| part.mesh.face_count() == 0) {
        return vec![Note::warning(Place::File, "it has no faces, and so no normals")];
    }
    let repeating: usize = parts.iter().map(|part| repeating(part.mesh.faces())).sum();
    let text = || {
        let polygons = counted(repeating as u64, "polygon passes", "polygons pass");
        format!("{polygons} through a vertex more than once; what they enclose counts")
    };
    (repeating > 0).then(|| Note::warning(Place::File, text())).into_iter().collect()
}

/// How many faces of four corners or more pass through a vertex more than once. Triangles that do have no area and are
/// counted as that.
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
    (0..faces.len()).into_par_iter().map_init(Vec::new, repeats).filter(|&repeats| repeats).count()
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
        assert_eq!(notes(""), ["it has no faces, and so no normals"]);
        assert_eq!(notes("f 1 2 3 4\nf 1 2 3\n"), [] as [&str; 0]);
        let reported = "polygon passes through a vertex more than once; what they enclose counts";
        assert_eq!(notes("f 1 2 3 4\nf 1 2 3 5 3 4\n"), [format!("1 {reported}")]);
    }
}
