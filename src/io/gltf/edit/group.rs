//! New normals and tangents for the primitives that share one set of vertices.

use super::member::{Member, drop_draco, rewrite_indices};
use super::rows::{CornerRows, Rows, Stored, Tables, Tangents};
use super::store::{NewData, Remark, Store};
use crate::io::gltf::accessor::{Elements, Source};
use crate::io::gltf::data::Target;
use crate::io::gltf::json::Value;
use crate::io::gltf::records::{Component, Format, VertexAccessors};
use crate::io::gltf::tangent_space::MaterialUses;
use crate::io::{ReadError, TangentPolicy, WriteError, WriteOptions};
use crate::mesh::{VertexSplit, split_vertices};
use std::borrow::Cow;

/// Primitives with the same vertex accessors, all of which get normals.
pub struct Group<'g, 'a> {
    pub vertices: &'g VertexAccessors,
    pub members: &'g [Member<'a>],
    pub source: &'g Source<'a>,
    /// What the materials of the document need tangents for.
    pub materials: &'g [MaterialUses],
    pub options: &'g WriteOptions,
}

/// An attribute of vertices: the set that it is in, its name and its accessor.
#[derive(Clone, Copy)]
pub struct Attribute<'a> {
    pub set: usize,
    pub semantic: &'a str,
    pub accessor: usize,
}

/// Which normals an edit writes or omits.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Replaced {
    Nothing,
    Normals,
    NormalsAndDeltas,
}

impl Group<'_, '_> {
    /// Writes what changes. Returns how many vertices were added; below 0 if more were merged.
    pub fn write(&self, store: &mut Store<'_>, tables: &mut Tables) -> Result<i64, WriteError> {
        if self.options.omit_normals && !self.vertices.need_normals() {
            return self.write_without_normals(store);
        }
        let target_sets = self.vertices.target_sets();
        let morph = self.members.iter().all(|member| member.has_morph_normals(target_sets.len()));
        let stored =
            Stored::new(self.source, self.vertices, self.options.normal_format, morph).map_err(unreadable)?;
        let has_targets = target_sets.clone().next().is_some();
        if !self.may_merge()
            && !has_targets
            && self.is_without_tangents()
            && let Some(rows) = stored.of_vertices(self.members)
        {
            return self.write_in_place(store, &stored, rows).map(|()| 0);
        }
        let rows = CornerRows::new(&stored, self.members, tables);
        store.remark(Remark::WITHOUT_NORMAL, rows.missing);

        let count = self.members[0].block.count as usize;
        let locals: Vec<u32> = self.corners().map(|(member, corner)| member.vertex(corner)).collect();
        let mut split = split_vertices(count, &locals, &[&rows.of_corner]);
        let mut new_rows = rows.gather(&split);
        let is_unchanged = split.added(count) == 0 && stored.is_stored(&new_rows);
        let are_new = self.members.iter().any(Member::has_new_normals);
        // Computed normals may be equal to the stored ones.
        let regenerates = self.options.tangents == TangentPolicy::Regenerate && are_new;
        let tangents = match is_unchanged && !regenerates {
            true => Tangents::Stay,
            false => self.tangents(store, &rows, &locals)?,
        };
        if is_unchanged && matches!(tangents, Tangents::Stay) {
            return self.write_merged(store, &self.others(Replaced::Nothing, true));
        }
        let has_normals = |set| self.vertices.of_set(set, "NORMAL").is_some();
        if are_new && !is_unchanged && !morph && target_sets.clone().any(has_normals) {
            store.remark(Remark::STALE_DELTAS, self.members.len());
        }
        let replaced = if morph { Replaced::NormalsAndDeltas } else { Replaced::Normals };
        let others = self.others(replaced, matches!(tangents, Tangents::Stay));
        let mut tangent_rows = None;
        if let Tangents::New(new) = &tangents {
            split = split_vertices(count, &locals, &[&rows.of_corner, &new.of_corner]);
            new_rows = rows.gather(&split);
            tangent_rows = Some(new.gather(&split));
        }
        let of_vertices: Vec<&Rows> = std::iter::once(&new_rows).chain(&tangent_rows).collect();
        if let Some(merged) = self.merged(store, &split, &of_vertices, &others)? {
            split = merged;
            new_rows = rows.gather(&split);
        }
        stored.repair_unused(&mut new_rows, &split.sample);

        store.is_quantized |= stored.format.component != Component::F32;
        self.put(store, 0, "NORMAL", stored.format, new_rows.take_base(), false);
        for (target, set) in target_sets.enumerate().take(stored.targets) {
            let deltas = new_rows.deltas(target);
            if has_normals(set) || deltas.iter().any(|&byte| byte != 0) {
                self.put(store, set, "NORMAL", Format::vector(Component::F32, false, 3), deltas, false);
            }
        }
        self.write_tangents(store, &split, &tangents);
        if split.is_identity(count) {
            self.repair_positions(store)?;
        } else {
            self.copy(store, &split, &others)?;
        }
        self.write_indices(store, &split)?;
        Ok(split.source.len() as i64 - count as i64)
    }

    /// Writes rows of vertices, none of which is split; `of_vertex` marks those that no corner uses by [`NONE`].
    fn write_in_place(
        &self,
        store: &mut Store<'_>,
        stored: &Stored,
        (mut rows, of_vertex): (Rows, Vec<u32>),
    ) -> Result<(), WriteError> {
        if stored.is_stored(&rows) {
            return self.write_faces(store);
        }
        stored.repair_unused(&mut rows, &of_vertex);
        store.is_quantized |= stored.format.component != Component::F32;
        self.put(store, 0, "NORMAL", stored.format, rows.take_base(), false);
        self.repair_positions(store)?;
        for member in self.members {
            self.write_order(store, member)?;
            drop_draco(store, member);
        }
        Ok(())
    }

    /// Writes dropped and flipped faces, where normals do not change.
    pub fn write_faces(&self, store: &mut Store<'_>) -> Result<(), WriteError> {
        self.repair_positions(store)?;
        for member in self.members {
            if self.write_order(store, member)? {
                drop_draco(store, member);
            }
        }
        Ok(())
    }

    /// Writes the triangles of a primitive, whose vertices did not change, if faces were dropped or flipped. Returns whether it did.
    fn write_order(&self, store: &mut Store<'_>, member: &Member<'_>) -> Result<bool, WriteError> {
        if !member.is_reshaped() {
            return Ok(false);
        }
        let indices = member.corners().map(|corner| member.vertex(corner)).collect();
        rewrite_indices(store, member, indices, member.block.count as usize)
    }

    /// Puts vertices without a finite position at the origin, where the mesh has them; no face uses them any more.
    fn repair_positions(&self, store: &mut Store<'_>) -> Result<(), WriteError> {
        for set in 0..self.vertices.sets.len() {
            let Some(accessor) = self.vertices.of_set(set, "POSITION") else { continue };
            let elements = self.source.elements(accessor).map_err(unreadable)?;
            if let Some(bytes) = finite(&elements) {
                self.put(store, set, "POSITION", elements.format, bytes, false);
            }
        }
        Ok(())
    }

    fn corners(&self) -> impl Iterator<Item = (&Member<'_>, u32)> {
        self.members.iter().flat_map(|member| member.corners().map(move |corner| (member, corner)))
    }

    /// The JSON objects that list the vertex accessors of a set, one a primitive.
    pub fn sites(&self, set: usize) -> Vec<Value> {
        self.members.iter().map(|member| member.primitive.sites[set]).collect()
    }

    fn put(
        &self,
        store: &mut Store<'_>,
        set: usize,
        semantic: &str,
        format: Format,
        bytes: Vec<u8>,
        same_bounds: bool,
    ) {
        let data = NewData { format, bytes, target: Target::Vertices, same_bounds };
        store.put(self.vertices.of_set(set, semantic), semantic, &self.sites(set), data);
    }

    fn write_tangents(&self, store: &mut Store<'_>, split: &VertexSplit, tangents: &Tangents) {
        let sets = std::iter::once(0).chain(self.vertices.target_sets());
        let had = sets.filter(|&set| self.vertices.of_set(set, "TANGENT").is_some());
        match tangents {
            Tangents::Stay => {}
            Tangents::Go => {
                let sites = had.flat_map(|set| self.sites(set));
                sites.for_each(|site| store.splices.remove(site, "TANGENT"));
            }
            Tangents::New(new) => {
                let mut rows = new.gather(split);
                self.put(store, 0, "TANGENT", new.format, rows.take_base(), false);
                for (number, &set) in new.sets.iter().enumerate() {
                    let format = Format::vector(Component::F32, false, 3);
                    self.put(store, set, "TANGENT", format, rows.deltas(number), false);
                }
            }
        }
    }

    /// Copies attributes to new vertices.
    pub fn copy(
        &self,
        store: &mut Store<'_>,
        split: &VertexSplit,
        attributes: &[Attribute<'_>],
    ) -> Result<(), WriteError> {
        for &Attribute { set, semantic, accessor } in attributes {
            let elements = self.source.elements(accessor).map_err(unreadable)?;
            let repaired = if semantic == "POSITION" { finite(&elements) } else { None };
            let same_bounds = repaired.is_none();
            let (raw, size) = (repaired.map_or_else(|| elements.raw(), Cow::Owned), elements.format.size());
            let mut bytes = Vec::with_capacity(size * split.source.len());
            for &vertex in &split.source {
                bytes.extend_from_slice(&raw[vertex as usize * size..(vertex as usize + 1) * size]);
            }
            self.put(store, set, semantic, elements.format, bytes, same_bounds);
        }
        Ok(())
    }

    /// The attributes of vertices, but for normals that are replaced or omitted, and tangents that are.
    fn others(&self, replaced: Replaced, keeps_tangents: bool) -> Vec<Attribute<'_>> {
        let is_kept = |attribute: &Attribute<'_>| match attribute.semantic {
            "NORMAL" => match replaced {
                Replaced::Nothing => true,
                Replaced::Normals => attribute.set > 0,
                Replaced::NormalsAndDeltas => false,
            },
            "TANGENT" => keeps_tangents,
            _ => true,
        };
        let sets = self.vertices.sets.iter().enumerate();
        let all = sets.flat_map(|(set, list)| {
            list.iter().map(move |(semantic, accessor)| Attribute { set, semantic, accessor: *accessor })
        });
        all.filter(is_kept).collect()
    }

    /// Writes the primitives without normals.
    fn write_without_normals(&self, store: &mut Store<'_>) -> Result<i64, WriteError> {
        if self.vertices.get("NORMAL").is_some() {
            self.sites(0).into_iter().for_each(|site| store.splices.remove(site, "NORMAL"));
            self.members.iter().for_each(|member| drop_draco(store, member));
        }
        // Whatever has tangents needs its normals.
        self.write_merged(store, &self.others(Replaced::Normals, true))
    }

    /// Merges vertices whose values do not change, and writes dropped and flipped faces.
    fn write_merged(&self, store: &mut Store<'_>, attributes: &[Attribute<'_>]) -> Result<i64, WriteError> {
        if !self.may_merge() {
            return self.write_faces(store).map(|()| 0);
        }
        let count = self.members[0].block.count as usize;
        let locals: Vec<u32> = self.corners().map(|(member, corner)| member.vertex(corner)).collect();
        let split = split_vertices(count, &locals, &[]);
        let Some(merged) = self.merged(store, &split, &[], attributes)? else {
            self.write_faces(store)?;
            return Ok(0);
        };
        self.copy(store, &merged, attributes)?;
        self.write_indices(store, &merged)?;
        Ok(merged.source.len() as i64 - count as i64)
    }

    /// Stores the triangles of all members, whose vertices changed.
    fn write_indices(&self, store: &mut Store<'_>, split: &VertexSplit) -> Result<(), WriteError> {
        let mut corners = split.corners.iter();
        for member in self.members {
            let indices = corners.by_ref().take(member.corner_count()).copied().collect();
            rewrite_indices(store, member, indices, split.source.len())?;
            drop_draco(store, member);
        }
        Ok(())
    }
}

/// The elements with zeros for those that are not finite; `None` if all are.
fn finite(elements: &Elements<'_>) -> Option<Vec<u8>> {
    let is_finite = |vector: &[f32; 3]| vector.iter().all(|x| x.is_finite());
    if elements.floats::<3>(0.0).all(|vector| is_finite(&vector)) {
        return None;
    }
    // Integers are finite, so these are floats.
    let floats = elements.floats(0.0);
    let repaired: Vec<[f32; 3]> = floats.map(|v| if is_finite(&v) { v } else { [0.0; 3] }).collect();
    Some(bytemuck::cast_slice(&repaired).to_vec())
}

/// Reading checked every attribute, so that this only passes on what should not happen.
pub fn unreadable(error: ReadError) -> WriteError {
    WriteError::Unsupported(error.to_string())
}
