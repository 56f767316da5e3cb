//! A GLB without the accessors, buffer views and bytes that nothing uses. All else stays: data move to the front of the BIN chunk.

use super::group::unreadable;
use super::refs::pinned;
use super::view_table::{Used, ViewTable};
use crate::io::WriteError;
use crate::io::gltf::glb::{Glb, padded, unpadded};
use crate::io::gltf::json::{Json, Value};
use crate::io::gltf::records::{Records, Reference, View};
use crate::io::gltf::splice::Splices;

/// Compacts a GLB. `None` if an extension may refer to accessors or buffer views, or if the data are not in its BIN chunk.
///
/// # Errors
/// What makes the file unreadable.
pub fn compact(bytes: &[u8]) -> Result<Option<Vec<u8>>, WriteError> {
    let Some((glb, records, bin)) = opened(bytes)? else { return Ok(None) };
    if !pinned(&records.json).is_empty() || records.views.iter().any(|view| view.extended) {
        return Ok(None);
    }
    let mut compaction = Compaction::new(&records, bin);
    if !compaction.move_views() {
        return Ok(None);
    }
    let (json, bin) = compaction.finish();
    Ok(Some(glb.rewrite(bytes, unpadded(&json), Some([&bin, &[], &[]]))?.0))
}

/// A GLB, its records and its BIN chunk; `None` if its first buffer is not that chunk.
pub fn opened(bytes: &[u8]) -> Result<Option<(Glb, Records, &[u8])>, WriteError> {
    let mut notes = Vec::new();
    let glb = Glb::parse(bytes, &mut notes).map_err(unreadable)?;
    let text = String::from_utf8_lossy(&bytes[glb.json()]).into_owned();
    let records = Records::new(Json::of_edited(text)?, &mut notes).map_err(unreadable)?;
    let first = records.buffers.first();
    let is_bin = first.is_some_and(|&buffer| records.json.member(buffer, "uri").is_none());
    let bin = glb.bin().filter(|_| is_bin);
    Ok(bin.map(|bin| (glb, records, &bytes[bin])))
}

struct Compaction<'a> {
    records: &'a Records,
    old: &'a [u8],
    bin: Vec<u8>,
    splices: Splices<'a>,
    references: Vec<Reference>,
    is_used: Vec<bool>,
    /// Images, and the views that they are in.
    images: Vec<(Value, usize)>,
}

impl<'a> Compaction<'a> {
    fn new(records: &'a Records, old: &'a [u8]) -> Self {
        let references = records.references();
        let mut is_used = vec![false; records.accessors.len()];
        references.iter().for_each(|&(.., accessor)| is_used[accessor] = true);
        let (splices, images) = (Splices::new(&records.json), records.images().collect());
        Self { records, old, bin: Vec::new(), splices, references, is_used, images }
    }

    fn used_accessors(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.is_used.len()).filter(|&accessor| self.is_used[accessor])
    }

    /// The views that hold anything else than the plain elements of accessors: images, sparse values.
    fn whole_views(&self) -> Vec<bool> {
        let mut is_whole = vec![false; self.records.views.len()];
        self.images.iter().for_each(|&(_, view)| is_whole[view] = true);
        for sparse in self.used_accessors().filter_map(|accessor| self.records.accessors[accessor].sparse) {
            is_whole[sparse.indices.0] = true;
            is_whole[sparse.values.0] = true;
        }
        is_whole
    }

    /// Copies the views that are in use, and removes the others. Returns whether all of them are within the BIN chunk.
    fn move_views(&mut self) -> bool {
        let is_whole = self.whole_views();
        let mut is_kept = is_whole.clone();
        for view in self.used_accessors().filter_map(|accessor| self.records.accessors[accessor].view) {
            is_kept[view] = true;
        }
        let views = &self.records.views;
        let mut kept: Vec<(usize, View)> = (0..views.len())
            .filter(|&view| is_kept[view] && views[view].buffer == 0)
            .map(|view| (view, views[view]))
            .collect();
        kept.sort_by_key(|(number, view)| (view.offset, view.length, *number));
        let end = |view: &View| view.offset.saturating_add(view.length);
        if kept.is_empty() || kept.iter().any(|(_, view)| end(view) > self.old.len() as u64) {
            return false;
        }
        let mut reach = 0;
        let overlap = |before: &(usize, View), next: &(usize, View)| {
            reach = end(&before.1).max(reach);
            next.1.offset < reach
        };
        let clusters: Vec<Vec<(usize, View)>> = kept.chunk_by(overlap).map(<[_]>::to_vec).collect();
        for cluster in clusters {
            match cluster[..] {
                [(number, view)] if !is_whole[number] => self.move_table(number, &view),
                _ => self.move_whole(&cluster),
            }
        }
        self.renumber(&is_kept);
        true
    }

    /// Copies views with all of their bytes, which they share.
    fn move_whole(&mut self, cluster: &[(usize, View)]) {
        let start = cluster[0].1.offset as usize;
        let end = cluster.iter().map(|(_, view)| (view.offset + view.length) as usize).max().unwrap_or(start);
        let home = self.align(start);
        self.bin.extend_from_slice(&self.old[start..end]);
        for (_, view) in cluster {
            self.set(view.object, "byteOffset", view.offset as usize, home + view.offset as usize - start);
        }
    }

    /// Copies the rows and columns of a view that accessors use.
    fn move_table(&mut self, number: usize, view: &View) {
        let accessors = &self.records.accessors;
        let in_view: Vec<usize> =
            self.used_accessors().filter(|&accessor| accessors[accessor].view == Some(number)).collect();
        let used = in_view.iter().map(|&accessor| {
            let record = &accessors[accessor];
            let size = record.format?.size();
            Some(Used { offset: record.offset as usize, size, count: record.count as usize })
        });
        let stride = view.stride.map(|stride| stride as usize);
        let table = used.collect::<Option<Vec<Used>>>();
        let Some(table) = table.and_then(|used| ViewTable::new(stride, view.length as usize, &used)) else {
            return self.move_whole(&[(number, *view)]);
        };
        let (start, end) = (view.offset as usize, (view.offset + view.length) as usize);
        let home = self.align(start);
        table.copy(&self.old[start..end], &mut self.bin);
        self.set(view.object, "byteOffset", start, home);
        self.set(view.object, "byteLength", end - start, self.bin.len() - home);
        if let Some(stride) = stride {
            self.set(view.object, "byteStride", stride, table.stride());
        }
        for accessor in in_view {
            let record = &accessors[accessor];
            self.set(
                record.object,
                "byteOffset",
                record.offset as usize,
                table.offset(record.offset as usize),
            );
        }
    }

    /// Fills up the new bytes so that what was at this offset keeps its remainder of four. Returns their length.
    fn align(&mut self, old: usize) -> usize {
        let length = padded(self.bin.len()) + old % 4;
        self.bin.resize(length, 0);
        length
    }

    /// Gives accessors and views that are in use new numbers, and removes the others.
    fn renumber(&mut self, is_kept: &[bool]) {
        let (accessors, views) = (numbers(&self.is_used), numbers(is_kept));
        let json = &self.records.json;
        for (object, name, old) in std::mem::take(&mut self.references) {
            self.set(object, &name, old, accessors[old]);
        }
        for (image, old) in std::mem::take(&mut self.images) {
            self.set(image, "bufferView", old, views[old]);
        }
        for accessor in self.used_accessors().collect::<Vec<_>>() {
            let record = &self.records.accessors[accessor];
            if let Some(old) = record.view {
                self.set(record.object, "bufferView", old, views[old]);
            }
            let sparse = record.sparse.zip(json.member(record.object, "sparse"));
            let Some((sparse, object)) = sparse else { continue };
            for (name, old) in [("indices", sparse.indices.0), ("values", sparse.values.0)] {
                let site = json.member(object, name);
                site.into_iter().for_each(|site| self.set(site, "bufferView", old, views[old]));
            }
        }
        for (list, kept) in [("accessors", &self.is_used), ("bufferViews", &is_kept.to_vec())] {
            if kept.contains(&false) {
                self.splices.keep(list, kept.clone());
            }
        }
    }

    fn set(&mut self, object: Value, name: &str, old: usize, new: usize) {
        if old != new {
            self.splices.set(object, name, new);
        }
    }

    fn finish(mut self) -> (String, Vec<u8>) {
        let json = &self.records.json;
        let buffer = self.records.buffers[0];
        let length = json.integer_member(buffer, "byteLength");
        self.set(buffer, "byteLength", length.unwrap_or(0) as usize, self.bin.len());
        (self.splices.apply(), self.bin)
    }
}

/// The number of each element among those that are kept.
fn numbers(is_kept: &[bool]) -> Vec<usize> {
    let mut next = 0;
    let number = |&is_kept: &bool| {
        next += usize::from(is_kept);
        next.saturating_sub(1)
    };
    is_kept.iter().map(number).collect()
}
