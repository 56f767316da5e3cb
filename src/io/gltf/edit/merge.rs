//! Vertices that agree in everything that is stored of them.

use super::group::{Attribute, Group, unreadable};
use super::member::index_component;
use super::rows::Rows;
use super::store::Store;
use crate::io::gltf::glb::padded;
use crate::io::{Merge, WriteError};
use crate::mesh::{NONE, VertexSplit};
use rustc_hash::FxHashMap;
use std::collections::hash_map::Entry;

/// Bytes of JSON for the accessor and the view of indices, which a primitive without indices needs once vertices are merged.
const TEXT_OF_INDICES: usize = 200;

impl Group<'_, '_> {
    /// The vertices of a split, of which those that agree in their rows and in all other attributes are one: the first of them.
    /// `None` unless that saves bytes or is [wanted](Merge::Exact), and if an extension may refer to vertices by number.
    pub fn merged(
        &self,
        store: &Store<'_>,
        split: &VertexSplit,
        rows: &[&Rows],
        others: &[Attribute<'_>],
    ) -> Result<Option<VertexSplit>, WriteError> {
        let is_ordered = || self.members.iter().any(|member| member.has_ordered_vertices(store.document));
        if !self.may_merge() || is_ordered() {
            return Ok(None);
        }
        let (keys, size) = self.keys(split, rows, others)?;
        let merged = first_of_equal(split, keys.chunks_exact(size));
        let is_wanted = match self.options.merge {
            Merge::Exact => merged.source.len() < split.source.len(),
            Merge::Off | Merge::FacetWise => self.saved_bytes(store, (split, &merged), rows, others) > 0,
        };
        Ok(Some(merged).filter(|_| is_wanted))
    }

    /// Whether the options allow to merge vertices.
    pub fn may_merge(&self) -> bool {
        self.options.compact || self.options.merge == Merge::Exact
    }

    /// All that is stored of each vertex of a split, and its size.
    fn keys(
        &self,
        split: &VertexSplit,
        rows: &[&Rows],
        others: &[Attribute<'_>],
    ) -> Result<(Vec<u8>, usize), WriteError> {
        let elements = others.iter().map(|other| self.source.elements(other.accessor).map_err(unreadable));
        let elements = elements.collect::<Result<Vec<_>, _>>()?;
        let of_rows = rows.iter().map(|rows| rows.size);
        let size = of_rows.chain(elements.iter().map(|elements| elements.format.size())).sum();
        let mut keys = vec![0; size * split.source.len()];
        let mut at = 0;
        for rows in rows {
            for (vertex, key) in keys.chunks_exact_mut(size).enumerate() {
                key[at..at + rows.size].copy_from_slice(rows.get(vertex));
            }
            at += rows.size;
        }
        for elements in elements {
            let (raw, width) = (elements.raw(), elements.format.size());
            for (key, &source) in keys.chunks_exact_mut(size).zip(&split.source) {
                key[at..at + width].copy_from_slice(&raw[source as usize * width..][..width]);
            }
            at += width;
        }
        Ok((keys, size))
    }

    /// Bytes that merging saves: in attributes and in indices, which change.
    fn saved_bytes(
        &self,
        store: &Store<'_>,
        (split, merged): (&VertexSplit, &VertexSplit),
        rows: &[&Rows],
        others: &[Attribute<'_>],
    ) -> i64 {
        let (before, after) = (split.source.len(), merged.source.len());
        if before == after {
            return 0;
        }
        let records = &store.document.records;
        let is_copied = !split.is_identity(self.members[0].block.count as usize);
        let size: usize = rows.iter().map(|rows| rows.size).sum();
        let mut saved = ((before - after) * size) as i64;
        for other in others {
            let stride = records.accessors[other.accessor].format.map_or(0, |format| padded(format.size()));
            // The old values stay if something else uses them.
            let is_freed = is_copied || store.is_only_at(other.accessor, self.members.len());
            saved += (stride * if is_freed { before } else { 0 }) as i64 - (stride * after) as i64;
        }
        for member in self.members.iter().filter(|_| !is_copied) {
            let component = index_component(store.document, member.primitive, after);
            let old = member.primitive.indices.map(|accessor| (accessor, &records.accessors[accessor]));
            let freed = match old {
                None => 0,
                Some((accessor, _)) if !store.is_only_at(accessor, 1) => 0,
                Some((_, old)) => old.format.map_or(0, |format| format.size() * old.count as usize),
            };
            let text = if old.is_none() { TEXT_OF_INDICES } else { 0 };
            saved += freed as i64 - (component.size() * member.corner_count() + text) as i64;
        }
        saved
    }
}

/// A split with the first of equal vertices in the place of each, by their keys.
fn first_of_equal<'k>(split: &VertexSplit, keys: impl Iterator<Item = &'k [u8]>) -> VertexSplit {
    let mut merged = VertexSplit::default();
    let mut first: FxHashMap<&[u8], u32> = FxHashMap::default();
    let mut number_of = Vec::with_capacity(split.source.len());
    for ((key, &source), &sample) in keys.zip(&split.source).zip(&split.sample) {
        let number = match first.entry(key) {
            Entry::Occupied(known) => *known.get(),
            Entry::Vacant(new) => {
                merged.source.push(source);
                merged.sample.push(NONE);
                *new.insert(merged.source.len() as u32 - 1)
            }
        };
        let known = &mut merged.sample[number as usize];
        *known = if *known == NONE { sample } else { *known };
        number_of.push(number);
    }
    merged.corners = split.corners.iter().map(|&vertex| number_of[vertex as usize]).collect();
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_of_equal_vertices_stays() {
        let split = VertexSplit {
            source: vec![0, 1, 2, 3, 1],
            sample: vec![NONE, 0, 1, 2, 3],
            corners: vec![1, 2, 3, 4, 3, 2],
        };
        let keys: [&[u8]; 5] = [b"a", b"b", b"a", b"b", b"c"];
        let merged = first_of_equal(&split, keys.into_iter());
        assert_eq!(merged.source, [0, 1, 1]);
        // Vertex 0 is unused, but equal to a used one.
        assert_eq!(merged.sample, [1, 0, 3]);
        assert_eq!(merged.corners, [1, 0, 1, 2, 1, 0]);
    }
}
