//! New data for accessors, in the least invasive place: over the old bytes, or appended.

use crate::io::gltf::GltfDocument;
use crate::io::gltf::container::buffers::Storage;
use crate::io::gltf::container::glb::padded;
use crate::io::gltf::document::records::{Component, Format};
use crate::io::gltf::edit::refs::References;
use crate::io::gltf::json::splice::{Changes, Splices, changed_object};
use crate::io::gltf::json::tree::{Value, quoted};
use crate::io::gltf::writer::data::{Bounds, Target, accessor_json, number_list, view_json};
use rustc_hash::FxHashSet;
use std::borrow::Cow;
use std::ops::Range;

/// Collects the changes to a document.
pub struct Store<'a> {
    pub document: &'a GltfDocument,
    pub splices: Splices<'a>,
    refs: References,
    /// Bytes to write over those of the BIN chunk: where, how far apart, how large, and what.
    patches: Vec<Patch>,
    appended: Vec<u8>,
    /// The views of what is appended, in the order of their numbers where they are new.
    placed: Vec<Placed>,
    home: Home,
    next_view: usize,
    next_accessor: usize,
}

/// Where appended data go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Home {
    /// Into the BIN chunk, from this byte on.
    Bin(usize),
    /// Into a buffer of their own with this number.
    Buffer(usize),
}

struct Patch {
    start: usize,
    stride: usize,
    size: usize,
    bytes: Vec<u8>,
}

/// New elements of an accessor.
pub struct NewData<'d> {
    pub format: Format,
    pub count: usize,
    /// Elements without gaps.
    pub bytes: Cow<'d, [u8]>,
    pub target: Target,
    /// The values are the old ones, only more of each, so that their bounds stay right.
    pub same_bounds: bool,
}

/// All that was collected, in the form that a file is made of.
pub struct Changed {
    pub json: String,
    /// The BIN chunk, if it changed.
    pub bin: Option<Vec<u8>>,
    /// The content of the additional buffer, if there is one.
    pub extra: Option<Vec<u8>>,
    /// The old buffer that the additional one stands in for.
    pub replaced: Option<usize>,
}

impl<'a> Store<'a> {
    pub fn new(document: &'a GltfDocument) -> Self {
        let buffers = &document.buffers.list;
        let home = match (&document.glb, buffers.first().map(|buffer| &buffer.storage)) {
            (Some(_), Some(Storage::Bin(range))) => Home::Bin(padded(range.len())),
            (Some(glb), None) if glb.bin().is_none() => Home::Bin(0),
            _ => Home::Buffer(buffers.len()),
        };
        Self {
            document,
            splices: Splices::new(&document.records.json),
            refs: References::new(document),
            patches: Vec::new(),
            appended: Vec::new(),
            placed: Vec::new(),
            home,
            next_view: document.records.views.len(),
            next_accessor: document.records.accessors.len(),
        }
    }

    /// Whether anything changed.
    pub fn is_empty(&self) -> bool {
        self.patches.is_empty() && self.splices.is_empty()
    }

    /// Stores new elements for a member of the objects `sites`, which all refer to the accessor `old`, or to none.
    pub fn put(&mut self, old: Option<usize>, name: &str, sites: &[Value], data: &NewData<'_>) {
        let Some(old) = old else {
            let view = self.append_view(data);
            let accessor = self.append_accessor(accessor_json(view, data.format, data.count, None));
            sites.iter().for_each(|&site| self.splices.set(site, name, accessor));
            return;
        };
        let json = &self.document.records.json;
        let record = &self.document.records.accessors[old];
        if !self.refs.is_only_at(old, sites.len()) {
            let changes = self.accessor_changes(old, None, data);
            let accessor = self.append_accessor(changed_object(json, record.object, &changes));
            sites.iter().for_each(|&site| self.splices.set(site, name, accessor));
        } else if !self.patch(old, data) {
            let own_view = record.view.filter(|_| record.sparse.is_none());
            let view = own_view
                .filter(|&view| self.refs.is_only_user(view) && !self.document.records.views[view].extended);
            let changes = self.accessor_changes(old, view, data);
            self.splices.change_all(record.object, changes);
        }
    }

    /// Writes over the old bytes, if that touches nothing else.
    fn patch(&mut self, old: usize, data: &NewData<'_>) -> bool {
        let records = &self.document.records;
        let record = &records.accessors[old];
        let same = record.format == Some(data.format)
            && record.count == data.count as u64
            && record.sparse.is_none();
        let Some(view) =
            record.view.filter(|_| same && data.target == Target::Vertices && self.refs.owns_bytes(old))
        else {
            return false;
        };
        let view = &records.views[view];
        if view.extended {
            return false;
        }
        let size = data.format.size();
        let stride = view.stride.map_or(size, |stride| stride as usize);
        let start = (view.offset + record.offset) as usize;
        self.patches.push(Patch { start, stride, size, bytes: data.bytes.to_vec() });
        let changes = self.bound_changes(record.object, data);
        self.splices.change_all(record.object, changes);
        true
    }

    /// What an accessor's JSON must say of new data, which are appended. With `view` that view is moved there
    /// instead of adding one.
    fn accessor_changes(&mut self, old: usize, view: Option<usize>, data: &NewData<'_>) -> Changes {
        let records = &self.document.records;
        let record = &records.accessors[old];
        let number = match view {
            Some(view) => {
                self.move_view(view, data);
                view
            }
            None => self.append_view(data),
        };
        let set = |name: &str, text: String| (name.to_owned(), Some(text));
        let mut changes = vec![("byteOffset".to_owned(), None), ("sparse".to_owned(), None)];
        if record.view != Some(number) {
            changes.push(set("bufferView", number.to_string()));
        }
        if record.count != data.count as u64 {
            changes.push(set("count", data.count.to_string()));
        }
        if record.format.map(|format| format.component) != Some(data.format.component) {
            changes.push(set("componentType", (data.format.component as u32).to_string()));
        }
        if record.format.map(|format| format.normalized) != Some(data.format.normalized) {
            changes.push(("normalized".to_owned(), data.format.normalized.then(|| "true".to_owned())));
        }
        if !data.same_bounds {
            changes.extend(self.bound_changes(record.object, data));
        }
        changes
    }

    /// New `min` and `max`, where the accessor has them.
    fn bound_changes(&self, accessor: Value, data: &NewData<'_>) -> Changes {
        let json = &self.document.records.json;
        let stated: Vec<&str> =
            ["min", "max"].into_iter().filter(|name| json.member(accessor, name).is_some()).collect();
        if stated.is_empty() {
            return Changes::new();
        }
        let bounds = bounds(&data.bytes, data.format);
        let text = |name: &str| number_list(if name == "min" { &bounds.low } else { &bounds.high });
        stated.into_iter().map(|name| (name.to_owned(), Some(text(name)))).collect()
    }

    fn append_view(&mut self, data: &NewData<'_>) -> usize {
        self.append(data, None);
        self.next_view += 1;
        self.next_view - 1
    }

    fn move_view(&mut self, view: usize, data: &NewData<'_>) {
        self.append(data, Some(view));
    }

    /// Writes the views of all that was appended, which begins at this byte of this buffer.
    fn write_views(&mut self, buffer: usize, base: usize) {
        for placed in std::mem::take(&mut self.placed) {
            let Placed { view, start, length, stride, target } = placed;
            let offset = base + start;
            let Some(view) = view else {
                self.push("bufferViews", view_json(buffer, offset as u64, length, stride, target));
                continue;
            };
            let record = &self.document.records.views[view];
            let object = record.object;
            if record.buffer != buffer {
                self.splices.set(object, "buffer", buffer);
            }
            self.splices.set(object, "byteOffset", offset);
            self.splices.set(object, "byteLength", length);
            match stride {
                Some(stride) => self.splices.set(object, "byteStride", stride),
                None => self.splices.remove(object, "byteStride"),
            }
        }
    }

    /// Whether no view is left in a buffer once those that were moved are out of it.
    fn is_deserted(&self, buffer: usize) -> bool {
        let moved: FxHashSet<usize> = self.placed.iter().filter_map(|placed| placed.view).collect();
        let views = &self.document.records.views;
        // An extension of a view may refer to any buffer.
        views
            .iter()
            .enumerate()
            .all(|(number, view)| !view.extended && (view.buffer != buffer || moved.contains(&number)))
    }

    fn append_accessor(&mut self, json: String) -> usize {
        self.push("accessors", json);
        self.next_accessor += 1;
        self.next_accessor - 1
    }

    /// Adds an element to a top-level list, which may have to be made.
    fn push(&mut self, list: &'static str, text: String) {
        let json = &self.document.records.json;
        match json.member(json.root(), list) {
            Some(array) => self.splices.push(array, text),
            None => self.splices.push_new(json.root(), list, text),
        }
    }

    fn append(&mut self, data: &NewData<'_>, view: Option<usize>) {
        let size = data.format.size();
        let step = if data.target == Target::Vertices { padded(size) } else { size };
        let start = padded(self.appended.len());
        self.appended.resize(start, 0);
        if step == size {
            self.appended.extend_from_slice(&data.bytes);
        } else {
            for element in data.bytes.chunks_exact(size) {
                self.appended.extend_from_slice(element);
                self.appended.resize(self.appended.len() + step - size, 0);
            }
        }
        let length = self.appended.len() - start;
        let (stride, target) = ((step != size).then_some(step), data.target);
        self.placed.push(Placed { view, start, length, stride, target });
    }

    /// Makes the document use and require an extension.
    pub fn require(&mut self, name: &str) {
        for list in ["extensionsUsed", "extensionsRequired"] {
            if !self.document.lists(list, name) {
                self.push(list, quoted(name));
            }
        }
    }

    /// Makes all changes. An additional buffer gets the address that `uri` makes of its content; it takes the number
    /// of the buffer `stale`, if nothing is left in that one.
    pub fn finish(mut self, stale: Option<usize>, uri: impl FnOnce(&[u8]) -> Option<String>) -> Changed {
        let document = self.document;
        let bin = document.glb.as_ref().and_then(|glb| glb.bin());
        let old: &[u8] = bin.map_or(&[], |range: Range<usize>| &document.buffers.file[range]);
        let appended = std::mem::take(&mut self.appended);
        let mut new_bin = None;
        let mut extra = None;
        let stale = stale.filter(|&buffer| self.is_deserted(buffer));
        match (self.home, stale) {
            (Home::Bin(base), _) => self.write_views(0, base),
            (Home::Buffer(_), Some(buffer)) | (Home::Buffer(buffer), None) => self.write_views(buffer, 0),
        }
        match self.home {
            Home::Bin(base) if !appended.is_empty() => {
                let length = base + appended.len();
                match document.records.buffers.first() {
                    Some(&buffer) => self.splices.set(buffer, "byteLength", length),
                    None => self.push("buffers", format!("{{\"byteLength\":{length}}}")),
                }
                let mut bytes = Vec::with_capacity(length);
                bytes.extend_from_slice(old);
                bytes.resize(base, 0);
                bytes.extend_from_slice(&appended);
                new_bin = Some(bytes);
            }
            Home::Buffer(_) if !appended.is_empty() => {
                let uri = uri(&appended).map(|uri| quoted(&uri));
                match (stale, uri) {
                    (Some(buffer), Some(uri)) => {
                        let object = document.records.buffers[buffer];
                        self.splices.set(object, "uri", uri);
                        self.splices.set(object, "byteLength", appended.len());
                    }
                    (_, uri) => {
                        let uri = uri.map_or(String::new(), |uri| format!(",\"uri\":{uri}"));
                        self.push("buffers", format!("{{\"byteLength\":{}{uri}}}", appended.len()));
                    }
                }
                extra = Some(appended);
            }
            _ => {}
        }
        if !self.patches.is_empty() {
            let bytes = new_bin.get_or_insert_with(|| old.to_vec());
            for patch in &self.patches {
                let elements = bytes[patch.start..].chunks_mut(patch.stride);
                for (to, from) in elements.zip(patch.bytes.chunks_exact(patch.size)) {
                    to[..patch.size].copy_from_slice(from);
                }
            }
        }
        Changed { json: self.splices.apply(), bin: new_bin, extra, replaced: stale }
    }
}

/// Where appended data are, from their own beginning, and the view of them.
struct Placed {
    /// The view that is moved there; `None` for a new one.
    view: Option<usize>,
    start: usize,
    length: usize,
    stride: Option<usize>,
    target: Target,
}

/// Bounds in the units of the storage, as `min` and `max` are.
fn bounds(bytes: &[u8], format: Format) -> Bounds {
    let size = format.component.size();
    let number = |bytes: &[u8]| match format.component {
        Component::I8 => f64::from(bytes[0] as i8),
        Component::U8 => f64::from(bytes[0]),
        Component::I16 => f64::from(i16::from_le_bytes([bytes[0], bytes[1]])),
        Component::U16 => f64::from(u16::from_le_bytes([bytes[0], bytes[1]])),
        Component::U32 => f64::from(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
        Component::F32 => f64::from(f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])),
    };
    let width = format.width * format.columns;
    let (mut low, mut high) = (vec![f64::INFINITY; width], vec![f64::NEG_INFINITY; width]);
    for element in bytes.chunks_exact(format.size()) {
        for (axis, bytes) in element.chunks_exact(size).take(width).enumerate() {
            let value = number(bytes);
            low[axis] = low[axis].min(value);
            high[axis] = high[axis].max(value);
        }
    }
    Bounds { low, high }
}
