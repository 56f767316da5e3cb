//! New data for accessors, in the least invasive place: over the old bytes, or appended.

use super::refs::References;
use crate::io::gltf::accessor::number;
use crate::io::gltf::buffers::Storage;
use crate::io::gltf::data::{Bounds, Target, accessor_json, number_list, view_json};
use crate::io::gltf::document::GltfDocument;
use crate::io::gltf::glb::padded;
use crate::io::gltf::json::{Value, quoted};
use crate::io::gltf::records::Format;
use crate::io::gltf::splice::{Changes, Splices, changed_object};
use crate::io::text::counted;
use crate::io::{Note, Place};
use rustc_hash::FxHashSet;
use std::borrow::Cow;

/// Collects the changes to a document.
pub struct Store<'a> {
    pub document: &'a GltfDocument,
    pub splices: Splices<'a>,
    pub remarks: Remarks,
    refs: References,
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
enum Home {
    /// Into the BIN chunk, from this byte on.
    Bin(usize),
    /// Into a buffer of their own with this number.
    Buffer(usize),
}

/// Elements to write over those of the BIN chunk.
struct Patch {
    start: usize,
    stride: usize,
    size: usize,
    bytes: Vec<u8>,
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

/// New elements of an accessor.
pub struct NewData<'d> {
    pub format: Format,
    /// Elements without gaps.
    pub bytes: Cow<'d, [u8]>,
    pub target: Target,
    /// The values are the old ones, only more of each, so that their bounds stay right.
    pub same_bounds: bool,
}

impl NewData<'_> {
    fn count(&self) -> usize {
        self.bytes.len() / self.format.size()
    }
}

/// All that was collected, in the form that a file is made of.
pub struct Changed {
    pub json: String,
    /// The BIN chunk, if it changed.
    pub bin: Option<Vec<u8>>,
    /// The content of the additional buffer, if there is one.
    pub extra: Option<Vec<u8>>,
    /// The old buffer that the additional one replaces.
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
            remarks: Remarks::default(),
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
        let records = &self.document.records;
        let json = match old {
            Some(old) if self.refs.is_only_at(old, sites.len()) => {
                if !self.patch(old, data) {
                    let record = &records.accessors[old];
                    let own_view = record.view.filter(|_| record.sparse.is_none());
                    let view = own_view
                        .filter(|&view| self.refs.is_only_user(view) && !records.views[view].extended);
                    let changes = self.accessor_changes(old, view, data);
                    self.splices.change(record.object, changes);
                }
                return;
            }
            Some(old) => {
                let changes = self.accessor_changes(old, None, data);
                changed_object(&records.json, records.accessors[old].object, &changes)
            }
            None => accessor_json(self.append(data, None), data.format, data.count(), None),
        };
        self.splices.push("accessors", json);
        sites.iter().for_each(|&site| self.splices.set(site, name, self.next_accessor));
        self.next_accessor += 1;
    }

    /// Writes over the old bytes, if that touches nothing else.
    fn patch(&mut self, old: usize, data: &NewData<'_>) -> bool {
        let records = &self.document.records;
        let record = &records.accessors[old];
        let is_same = record.format == Some(data.format)
            && record.count == data.count() as u64
            && record.sparse.is_none()
            && data.target == Target::Vertices;
        let view = record.view.map(|view| &records.views[view]);
        let Some(view) = view.filter(|view| is_same && !view.extended && self.refs.owns_bytes(old)) else {
            return false;
        };
        let size = data.format.size();
        let stride = view.stride.map_or(size, |stride| stride as usize);
        let start = (view.offset + record.offset) as usize;
        self.patches.push(Patch { start, stride, size, bytes: data.bytes.to_vec() });
        self.splices.change(record.object, self.bound_changes(record.object, data));
        true
    }

    /// Changes to an accessor's JSON for new data, which are appended: into `view`, which is moved, or into a new view.
    fn accessor_changes(&mut self, old: usize, view: Option<usize>, data: &NewData<'_>) -> Changes {
        let record = &self.document.records.accessors[old];
        let view = self.append(data, view);
        let (format, count) = (data.format, data.count());
        let mut changes = vec![("byteOffset".to_owned(), None), ("sparse".to_owned(), None)];
        let mut set = |is_new: bool, name: &str, text: Option<String>| {
            changes.extend(is_new.then(|| (name.to_owned(), text)));
        };
        set(record.view != Some(view), "bufferView", Some(view.to_string()));
        set(record.count != count as u64, "count", Some(count.to_string()));
        let component = record.format.map(|format| format.component);
        let code = format.component.as_gl_enum().to_string();
        set(component != Some(format.component), "componentType", Some(code));
        let normalized = record.format.map(|format| format.normalized);
        let text = format.normalized.then(|| "true".to_owned());
        set(normalized != Some(format.normalized), "normalized", text);
        if !data.same_bounds {
            changes.extend(self.bound_changes(record.object, data));
        }
        changes
    }

    /// New `min` and `max`, where the accessor has them.
    fn bound_changes(&self, accessor: Value, data: &NewData<'_>) -> Changes {
        let json = &self.document.records.json;
        let mut changes = Changes::new();
        let has = |name| json.member(accessor, name).is_some();
        if has("min") || has("max") {
            let bounds = bounds(&data.bytes, data.format);
            for (name, values) in [("min", &bounds.low), ("max", &bounds.high)] {
                changes.extend(has(name).then(|| (name.to_owned(), Some(number_list(values)))));
            }
        }
        changes
    }

    /// Appends data, and returns the number of their view: `view`, which is moved there, or that of a new one.
    fn append(&mut self, data: &NewData<'_>, view: Option<usize>) -> usize {
        let (size, target, stride) = (data.format.size(), data.target, data.target.stride(data.format));
        let start = padded(self.appended.len());
        self.appended.resize(start, 0);
        match stride {
            None => self.appended.extend_from_slice(&data.bytes),
            Some(stride) => {
                for element in data.bytes.chunks_exact(size) {
                    self.appended.extend_from_slice(element);
                    self.appended.resize(self.appended.len() + stride - size, 0);
                }
            }
        }
        let length = self.appended.len() - start;
        self.placed.push(Placed { view, start, length, stride, target });
        view.unwrap_or_else(|| {
            self.next_view += 1;
            self.next_view - 1
        })
    }

    /// Writes the views of all that was appended, which begins at this byte of this buffer.
    fn write_views(&mut self, buffer: usize, base: usize) {
        for Placed { view, start, length, stride, target } in std::mem::take(&mut self.placed) {
            let offset = base + start;
            let Some(view) = view else {
                let json = view_json(buffer, offset as u64, length, stride, target);
                self.splices.push("bufferViews", json);
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
        // An extension of a view may refer to any buffer.
        let mut views = self.document.records.views.iter().enumerate();
        views.all(|(number, view)| !view.extended && (view.buffer != buffer || moved.contains(&number)))
    }

    /// Makes the document use and require an extension.
    pub fn require(&mut self, name: &str) {
        for list in ["extensionsUsed", "extensionsRequired"] {
            if !self.document.lists(list, name) {
                self.splices.push(list, quoted(name));
            }
        }
    }

    /// Makes all changes. An additional buffer gets the address that `uri` makes of its content; it takes the number
    /// of the buffer `stale`, if nothing is left in that one.
    pub fn finish(mut self, stale: Option<usize>, uri: impl FnOnce(&[u8]) -> Option<String>) -> Changed {
        let document = self.document;
        let bin = document.glb.as_ref().and_then(|glb| glb.bin());
        let old: &[u8] = bin.map_or(&[], |range| &document.buffers.file[range]);
        let appended = std::mem::take(&mut self.appended);
        let replaced = stale.filter(|&buffer| self.is_deserted(buffer));
        let (mut bin, mut extra) = (None, None);
        match self.home {
            Home::Bin(base) => self.write_views(0, base),
            Home::Buffer(buffer) => self.write_views(replaced.unwrap_or(buffer), 0),
        }
        match self.home {
            _ if appended.is_empty() => {}
            Home::Bin(base) => {
                let length = base + appended.len();
                match document.records.buffers.first() {
                    Some(&buffer) => self.splices.set(buffer, "byteLength", length),
                    None => self.splices.push("buffers", format!("{{\"byteLength\":{length}}}")),
                }
                let mut bytes = Vec::with_capacity(length);
                bytes.extend_from_slice(old);
                bytes.resize(base, 0);
                bytes.extend_from_slice(&appended);
                bin = Some(bytes);
            }
            Home::Buffer(_) => {
                let (length, uri) = (appended.len(), uri(&appended).map(|uri| quoted(&uri)));
                match (replaced.map(|buffer| document.records.buffers[buffer]), uri) {
                    (Some(object), Some(uri)) => {
                        self.splices.set(object, "uri", uri);
                        self.splices.set(object, "byteLength", length);
                    }
                    (_, uri) => {
                        let uri = uri.map_or(String::new(), |uri| format!(",\"uri\":{uri}"));
                        self.splices.push("buffers", format!("{{\"byteLength\":{length}{uri}}}"));
                    }
                }
                extra = Some(appended);
            }
        }
        if !self.patches.is_empty() {
            let bytes = bin.get_or_insert_with(|| old.to_vec());
            for patch in &self.patches {
                let elements = bytes[patch.start..].chunks_mut(patch.stride);
                for (to, from) in elements.zip(patch.bytes.chunks_exact(patch.size)) {
                    to[..patch.size].copy_from_slice(from);
                }
            }
        }
        Changed { json: self.splices.apply(), bin, extra, replaced }
    }
}

/// Bounds in the units of the storage, as `min` and `max` are.
fn bounds(bytes: &[u8], format: Format) -> Bounds {
    let (size, width) = (format.component.size(), format.width * format.columns);
    let (mut low, mut high) = (vec![f64::INFINITY; width], vec![f64::NEG_INFINITY; width]);
    for element in bytes.chunks_exact(format.size()) {
        for (axis, bytes) in element.chunks_exact(size).take(width).enumerate() {
            let value = number(bytes, format.component);
            low[axis] = low[axis].min(value);
            high[axis] = high[axis].max(value);
        }
    }
    Bounds { low, high }
}

/// Counts of what an edit changed besides normals; each becomes one note.
#[derive(Default)]
pub struct Remarks {
    /// Corners without a normal of their own among others that have one.
    pub without_normal: usize,
    /// Primitives whose morph targets have normal deltas that were not recomputed.
    pub stale_deltas: usize,
    /// Primitives whose tangents were omitted.
    pub tangents_dropped: usize,
    /// Primitives whose morph targets lost their tangents to new ones of the base.
    pub tangent_deltas_dropped: usize,
    /// Primitives that lost all their faces.
    pub emptied: usize,
    /// Primitives whose compressed copy was omitted.
    pub draco_dropped: usize,
    /// Normals are stored as integers.
    pub quantized: bool,
}

impl Remarks {
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
