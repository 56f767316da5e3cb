//! Notes on an edit, and edits that are refused.

use crate::io::gltf::GltfDocument;
use crate::io::gltf::edit::member::Member;
use crate::io::gltf::edit::store::Store;
use crate::io::gltf::extensions::{DRACO, ORDERED, has_implicit_features};
use crate::io::text::counted;
use crate::io::{Note, Place, WriteError};

/// Counts of what an edit changed besides normals; each becomes one note.
#[derive(Default)]
pub struct Remarks {
    /// Corners without a normal of their own among others that have one.
    pub without_normal: usize,
    /// Primitives whose morph targets have normal deltas that were not recomputed.
    pub stale_deltas: usize,
    /// Primitives whose tangents were left out.
    pub tangents_dropped: usize,
    /// Primitives whose morph targets lost their tangents to new ones of the base.
    pub tangent_deltas_dropped: usize,
    /// Primitives that lost all their faces.
    pub emptied: usize,
    /// Primitives whose compressed copy was left out.
    draco_dropped: usize,
    /// Normals are stored as integers.
    pub quantized: bool,
}

impl Remarks {
    /// Refuses to break an extension that counts vertices or triangles. `indices` are the new ones; `moved` if
    /// some of them are of other vertices.
    pub fn check_order(
        &self,
        document: &GltfDocument,
        member: &Member<'_>,
        indices: &[u32],
        moved: bool,
    ) -> Result<(), WriteError> {
        let at = member.primitive.at;
        let primitive = document.records.fields(member.primitive.object, at);
        let mesh = document.records.fields(document.records.meshes[member.part].object, at);
        let refuse = |name: &str, what: &str| {
            let text = format!(
                "{}: the extension {name} refers to {what} by number, and these would change; keep them as they are \
                 (--crease off or --emit vertex splits none, --degenerate keep and no --flip or --orient keeps all \
                 faces), or take the extension out first",
                at.place()
            );
            Err(WriteError::Unsupported(text))
        };
        for extension in ORDERED {
            if primitive.extension(extension.name).is_none() && mesh.extension(extension.name).is_none() {
                continue;
            }
            if moved && extension.vertices {
                return refuse(extension.name, "vertices");
            }
            if member.reshaped && extension.triangles {
                return refuse(extension.name, "triangles");
            }
        }
        if moved && has_implicit_features(&primitive) {
            return refuse("EXT_mesh_features", "vertices");
        }
        if document.lists("extensionsUsed", "FB_ngon_encoding") && !same_polygons(member, indices) {
            return refuse("FB_ngon_encoding", "the first corners of triangles");
        }
        Ok(())
    }

    /// Leaves out a compressed copy of a primitive that no longer is one.
    pub fn drop_draco(&mut self, store: &mut Store<'_>, member: &Member<'_>) {
        let json = &store.document.records.json;
        let extensions = json.member(member.primitive.object, "extensions");
        if let Some(extensions) = extensions.filter(|&extensions| json.member(extensions, DRACO).is_some()) {
            store.splices.remove(extensions, DRACO);
            self.draco_dropped += 1;
        }
    }

    /// Adds a note for each count.
    pub fn add_to(&self, notes: &mut Vec<Note>) {
        let (corners, primitives) = (["corner", "corners"], ["primitive", "primitives"]);
        for (count, [one, many], text) in [
            (
                self.without_normal,
                corners,
                "without a normal to write, the stored one is kept, or +Z written",
            ),
            (self.stale_deltas, primitives, "normal deltas of morph targets still belong to the old normals"),
            (
                self.tangents_dropped,
                primitives,
                "tangents belonged to the old normals and were left out; viewers make them again (a validator then \
                 reports MESH_PRIMITIVE_GENERATED_TANGENT_SPACE where there is a normal map), see --tangents",
            ),
            (
                self.tangent_deltas_dropped,
                primitives,
                "morph targets had tangents for the old ones of the base, which were left out",
            ),
            (
                self.emptied,
                primitives,
                "all faces are gone, and one triangle without area stands for them, as glTF needs one",
            ),
            (self.draco_dropped, primitives, "the Draco copy was left out and the plain data kept"),
        ] {
            if count > 0 {
                let text = format!("{text}: {}", counted(count, one, many));
                notes.push(Note::warning(Place::File, text));
            }
        }
    }
}

/// Whether triangles that `FB_ngon_encoding` makes into polygons still are, and no others: neighbours in the list
/// belong together if they have the same first corner.
fn same_polygons(member: &Member<'_>, indices: &[u32]) -> bool {
    let first_corners = || member.corners.chunks_exact(3).zip(indices.chunks_exact(3));
    first_corners().zip(first_corners().skip(1)).all(|((old, new), (old_next, new_next))| {
        // Triangles that were not neighbours before belong to different polygons whatever their corners.
        let neighbours = old[0] / 3 + 1 == old_next[0] / 3;
        let before = neighbours && member.vertex(old[0]) == member.vertex(old_next[0]);
        before == (new[0] == new_next[0])
    })
}
