//! The one buffer that takes the place of compressed ones, and the text of the document that describes it.

use crate::io::gltf::buffers::{Buffers, Storage};
use crate::io::gltf::data::{Target, view_json};
use crate::io::gltf::fields::{numbered, only_compressed, out_of_range};
use crate::io::gltf::glb::padded;
use crate::io::gltf::json::Value;
use crate::io::gltf::records::{Records, View};
use crate::io::gltf::splice::Splices;
use crate::io::{Place, Problem, ReadError};
use std::collections::{BTreeMap, BTreeSet};

/// Collects what was decompressed.
pub struct Rebuild<'a> {
    pub records: &'a Records,
    pub buffers: &'a Buffers,
    pub splices: Splices<'a>,
    /// The extensions that go.
    pub names: Vec<&'static str>,
    /// The plain bytes of views.
    pub views: BTreeMap<usize, Vec<u8>>,
    /// Views behind those of the document.
    pub added: Vec<AddedView>,
    /// The buffers that become one.
    merged: BTreeSet<usize>,
    /// Bytes that may still be decompressed.
    left: u64,
}

pub struct AddedView {
    pub bytes: Vec<u8>,
    pub stride: Option<usize>,
    pub target: Target,
}

/// A document without its compressed data.
pub struct Rebuilt {
    pub text: String,
    /// The bytes of the new buffer.
    pub content: Vec<u8>,
    /// The old buffer whose object describes the new one.
    pub home: usize,
    /// Which old buffers are in the new one.
    pub is_merged: Vec<bool>,
}

impl<'a> Rebuild<'a> {
    pub fn new(records: &'a Records, buffers: &'a Buffers, limit: u64) -> Self {
        Self {
            records,
            buffers,
            splices: Splices::new(&records.json),
            names: Vec::new(),
            views: BTreeMap::new(),
            added: Vec::new(),
            merged: BTreeSet::new(),
            left: limit,
        }
    }

    /// The compressed bytes at an offset of a buffer, which the new buffer replaces.
    pub fn source(
        &mut self,
        buffer: usize,
        offset: u64,
        length: u64,
        place: impl FnOnce() -> Place,
    ) -> Result<&'a [u8], ReadError> {
        let bytes = self.buffers.bytes(buffer).unwrap_or_default();
        let end = offset.checked_add(length).filter(|&end| end <= bytes.len() as u64);
        let Some(end) = end else {
            let size = bytes.len();
            let found =
                format!("{length} compressed bytes from byte {offset} exceed the buffer of {size} bytes");
            return Err(out_of_range(place(), found));
        };
        self.merge(buffer);
        Ok(&bytes[offset as usize..end as usize])
    }

    pub fn merge(&mut self, buffer: usize) {
        self.merged.insert(buffer);
    }

    /// Takes memory from the budget before something is decompressed.
    pub fn spend(&mut self, bytes: u64, place: impl FnOnce() -> Place) -> Result<(), ReadError> {
        let Some(left) = self.left.checked_sub(bytes) else {
            let found = format!("{bytes} decompressed bytes are more than so small a file may have");
            let advice = "check where the file comes from, or decompress it with another program first";
            return Err(ReadError::new(Problem::Limit, place(), found, advice));
        };
        self.left = left;
        Ok(())
    }

    /// Bytes that may still be decompressed.
    pub fn left(&self) -> u64 {
        self.left
    }

    /// Whether accessors or images have data in a view.
    pub fn is_used(&self, view: usize) -> bool {
        let records = self.records;
        let of_accessors = records.accessors.iter().filter_map(|accessor| accessor.view);
        let of_images = records.images().map(|(_, view)| view);
        of_accessors.chain(records.sparse_views()).chain(of_images).any(|other| other == view)
    }

    /// Takes extensions out of an object.
    pub fn strip(&mut self, object: Value, names: &[&str]) {
        let json = &self.records.json;
        let Some(extensions) = json.member(object, "extensions") else { return };
        let goes = |key| json.string(key).is_some_and(|name| names.contains(&name.as_ref()));
        if json.members(extensions).all(|(key, _)| goes(key)) {
            self.splices.remove(object, "extensions");
        } else {
            names.iter().for_each(|name| self.splices.remove(extensions, name));
        }
    }

    /// Builds the buffer and changes the text.
    ///
    /// # Errors
    /// A view that exceeds a merged buffer, or is stored in one without data.
    pub fn finish(mut self, is_glb: bool) -> Result<Rebuilt, ReadError> {
        let list = &self.buffers.list;
        if is_glb {
            let is_bin = matches!(list.first().map(|buffer| &buffer.storage), Some(Storage::Bin(_)));
            // The first buffer of a GLB is its BIN chunk. Without one, the new buffer has to become the first.
            let stored = (0..list.len()).filter(|&buffer| self.buffers.bytes(buffer).is_some());
            let merged: Vec<usize> = if is_bin { vec![0] } else { stored.collect() };
            self.merged.extend(merged);
        }
        let home = self.merged.first().copied().unwrap_or_default();
        let is_merged: Vec<bool> = (0..list.len()).map(|buffer| self.merged.contains(&buffer)).collect();
        let is_kept: Vec<bool> = (0..list.len()).map(|buffer| buffer == home || !is_merged[buffer]).collect();
        let mut next = 0;
        let number = |&is_kept: &bool| {
            next += usize::from(is_kept);
            next - usize::from(is_kept)
        };
        let mut numbers: Vec<usize> = is_kept.iter().map(number).collect();
        let new = numbers[home];
        self.merged.iter().for_each(|&buffer| numbers[buffer] = new);

        let content = self.place_views(new)?;
        for view in &self.records.views {
            if numbers[view.buffer] != view.buffer {
                self.splices.set(view.object, "buffer", numbers[view.buffer]);
            }
        }
        let object = self.records.buffers[home];
        self.splices.set(object, "byteLength", content.len());
        if is_glb {
            self.splices.remove(object, "uri");
        }
        let names = self.names.clone();
        self.strip(object, &names);
        if is_kept.contains(&false) {
            self.splices.keep("buffers", is_kept);
        }
        self.unlist(&names);
        Ok(Rebuilt { text: self.splices.apply(), content, home, is_merged })
    }

    /// The bytes of the new buffer: plain data first, each group of views that overlap once, then what was decompressed.
    fn place_views(&mut self, buffer: usize) -> Result<Vec<u8>, ReadError> {
        let mut plain: Vec<(usize, View)> = Vec::new();
        for (number, view) in self.records.views.iter().enumerate() {
            if !self.merged.contains(&view.buffer) || self.views.contains_key(&number) {
                continue;
            }
            let place = || numbered("bufferViews", number);
            let Some(bytes) = self.buffers.bytes(view.buffer) else {
                return Err(only_compressed(
                    place(),
                    "the view has no data, and no known extension has them",
                ));
            };
            if end(view) > bytes.len() as u64 {
                let (length, start, size) = (view.length, view.offset, bytes.len());
                let found =
                    format!("a view of {length} bytes from byte {start} exceeds the buffer of {size} bytes");
                return Err(out_of_range(place(), found));
            }
            plain.push((number, *view));
        }
        let mut content: Vec<u8> = Vec::new();
        let bytes = |buffer| self.buffers.bytes(buffer).unwrap_or_default();
        for (number, offset) in copy_views(plain, bytes, &mut content) {
            let view = self.records.views[number];
            self.move_view(&view, offset, view.length);
        }
        for (number, bytes) in std::mem::take(&mut self.views) {
            let view = self.records.views[number];
            content.resize(padded(content.len()), 0);
            self.move_view(&view, content.len() as u64, bytes.len() as u64);
            content.extend_from_slice(&bytes);
        }
        for AddedView { bytes, stride, target } in std::mem::take(&mut self.added) {
            content.resize(padded(content.len()), 0);
            let json = view_json(buffer, content.len() as u64, bytes.len(), stride, target);
            self.splices.push("bufferViews", json);
            content.extend_from_slice(&bytes);
        }
        Ok(content)
    }

    fn move_view(&mut self, view: &View, offset: u64, length: u64) {
        if view.offset != offset {
            self.splices.set(view.object, "byteOffset", offset);
        }
        if view.length != length {
            self.splices.set(view.object, "byteLength", length);
        }
    }

    /// Takes extensions out of the lists of those that the document uses and requires.
    fn unlist(&mut self, names: &[&str]) {
        let json = &self.records.json;
        for list in ["extensionsUsed", "extensionsRequired"] {
            let stays = |value| json.string(value).is_none_or(|name| !names.contains(&name.as_ref()));
            let kept: Vec<bool> = json.items(json.root(), list).map(stays).collect();
            if kept.contains(&false) {
                self.splices.keep(list, kept);
            }
        }
    }
}

/// Copies the bytes of views, those that several of them share once, and returns where each then is.
pub fn copy_views<'a>(
    mut views: Vec<(usize, View)>,
    bytes: impl Fn(usize) -> &'a [u8],
    content: &mut Vec<u8>,
) -> Vec<(usize, u64)> {
    views.sort_by_key(|(number, view)| (view.buffer, view.offset, view.length, *number));
    let mut reach = 0;
    let overlap = |(_, before): &(usize, View), (_, next): &(usize, View)| {
        reach = if before.buffer == next.buffer { reach.max(end(before)) } else { 0 };
        next.offset < reach
    };
    let mut places = Vec::with_capacity(views.len());
    for cluster in views.chunk_by(overlap) {
        let first = cluster[0].1;
        let last = cluster.iter().map(|(_, view)| end(view)).max().unwrap_or(first.offset);
        // Elements keep their alignment.
        let base = padded(content.len()) as u64 + first.offset % 4;
        content.resize(base as usize, 0);
        content.extend_from_slice(&bytes(first.buffer)[first.offset as usize..last as usize]);
        places.extend(cluster.iter().map(|(number, view)| (*number, base + view.offset - first.offset)));
    }
    places
}

fn end(view: &View) -> u64 {
    view.offset.saturating_add(view.length)
}
