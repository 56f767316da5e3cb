//! New data for accessors, in the least invasive place: over the old bytes, or appended.

use super::refs::References;
use crate::io::Place;
use crate::io::gltf::buffers::Storage;
use crate::io::gltf::data::{Target, accessor_json, bounds, number_list, view_json};
use crate::io::gltf::document::GltfDocument;
use crate::io::gltf::glb::padded;
use crate::io::gltf::json::{Value, quoted};
use crate::io::gltf::records::Format;
use crate::io::gltf::splice::{Changes, Splices, changed_object};
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;

pub struct Store<'a> {
    pub document: &'a GltfDocument,
    pub splices: Splices<'a>,
    pub is_quantized: bool,
    /// How often each remark applies.
    pub remarks: BTreeMap<Remark, usize>,
    /// Where each warning applies.
    pub warnings: BTreeMap<String, Vec<Place>>,
    refs: References,
    patches: Vec<Patch>,
    appended: Vec<u8>,
    /// The views of what is appended, in the order of their numbers where they are new.
    placed: Vec<Placed>,
    /// The buffer that appended data go into, and where they begin in it.
    home: (usize, usize),
    /// Whether that is the BIN chunk. If not, it is a new buffer.
    in_bin: bool,
    next_view: usize,
    next_accessor: usize,
}

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

pub struct NewData {
    pub format: Format,
    pub bytes: Vec<u8>,
    pub target: Target,
    /// The values are the old ones, only more of each, so that their bounds stay right.
    pub same_bounds: bool,
}

impl NewData {
    fn count(&self) -> usize {
        self.bytes.len() / self.format.size()
    }
}

/// A BIN chunk: the old one with new data behind it and over parts of it.
pub struct NewBin<'a> {
    old: &'a [u8],
    /// Where new data begin.
    base: usize,
    appended: Vec<u8>,
    patches: Vec<Patch>,
}

impl NewBin<'_> {
    /// The bytes before they are [patched](Self::patch).
    pub fn pieces(&self) -> [&[u8]; 3] {
        let filler = if self.appended.is_empty() { 0 } else { self.base - self.old.len() };
        [self.old, &[0; 4][..filler], &self.appended]
    }

    /// Writes new data over the old ones.
    pub fn patch(&self, bytes: &mut [u8]) {
        for patch in &self.patches {
            let elements = bytes[patch.start..].chunks_mut(patch.stride);
            for (to, from) in elements.zip(patch.bytes.chunks_exact(patch.size)) {
                to[..patch.size].copy_from_slice(from);
            }
        }
    }

    pub fn to_vec(&self) -> Vec<u8> {
        let mut bytes = self.pieces().concat();
        self.patch(&mut bytes);
        bytes
    }
}

/// All that was collected, in the form that a file is made of.
pub struct Changed<'a> {
    pub json: String,
    pub bin: Option<NewBin<'a>>,
    /// The content of the additional buffer, if there is one.
    pub extra: Option<Vec<u8>>,
    /// The old buffer that the additional one replaces.
    pub replaced: Option<usize>,
}

impl<'a> Store<'a> {
    pub fn new(document: &'a GltfDocument) -> Self {
        let buffers = &document.buffers.list;
        let (home, in_bin) = match (&document.glb, buffers.first().map(|buffer| &buffer.storage)) {
            (Some(_), Some(Storage::Bin(range))) => ((0, padded(range.len())), true),
            (Some(glb), None) if glb.bin().is_none() => ((0, 0), true),
            _ => ((buffers.len(), 0), false),
        };
        Self {
            document,
            splices: Splices::new(&document.records.json),
            is_quantized: false,
            remarks: BTreeMap::new(),
            warnings: BTreeMap::new(),
            refs: References::new(document),
            patches: Vec::new(),
            appended: Vec::new(),
            placed: Vec::new(),
            home,
            in_bin,
            next_view: document.records.views.len(),
            next_accessor: document.records.accessors.len(),
        }
    }

    /// Whether nothing but these objects, which refer to an accessor, uses it.
    pub fn is_only_at(&self, accessor: usize, sites: usize) -> bool {
        self.refs.is_only_at(accessor, sites)
    }

    pub fn is_empty(&self) -> bool {
        self.patches.is_empty() && self.splices.is_empty()
    }

    /// Stores new elements for a member of the objects `sites`, which all refer to the accessor `old`, or to none.
    pub fn put(&mut self, old: Option<usize>, name: &str, sites: &[Value], data: NewData) {
        let records = &self.document.records;
        let json = match old {
            Some(old) if self.refs.is_only_at(old, sites.len()) => {
                if self.is_patch(old, &data) {
                    self.patch(old, data);
                } else {
                    let record = &records.accessors[old];
                    let own_view = record.view.filter(|_| record.sparse.is_none());
                    let view = own_view
                        .filter(|&view| self.refs.is_only_user(view) && !records.views[view].extended);
                    let changes = self.accessor_changes(old, view, &data);
                    self.splices.change(record.object, changes);
                }
                return;
            }
            Some(old) => {
                let changes = self.accessor_changes(old, None, &data);
                changed_object(&records.json, records.accessors[old].object, &changes)
            }
            None => accessor_json(self.append(&data, None), data.format, data.count(), None),
        };
        self.splices.push("accessors", json);
        sites.iter().for_each(|&site| self.splices.set(site, name, self.next_accessor));
        self.next_accessor += 1;
    }

    /// Whether data can be written over the old bytes, which touches nothing else.
    fn is_patch(&self, old: usize, data: &NewData) -> bool {
        let records = &self.document.records;
        let record = &records.accessors[old];
        let is_same = record.format == Some(data.format)
            && record.count == data.count() as u64
            && record.sparse.is_none()
            && data.target == Target::Vertices;
        let is_own = |view: usize| !records.views[view].extended && self.refs.unaliased.contains(&old);
        is_same && record.view.is_some_and(is_own)
    }

    /// Writes over the old bytes.
    fn patch(&mut self, old: usize, data: NewData) {
        let records = &self.document.records;
        let record = &records.accessors[old];
        let Some(view) = record.view.map(|view| &records.views[view]) else { return };
        let size = data.format.size();
        let stride = view.stride.map_or(size, |stride| stride as usize);
        let start = (view.offset + record.offset) as usize;
        self.splices.change(record.object, self.bound_changes(record.object, &data));
        self.patches.push(Patch { start, stride, size, bytes: data.bytes });
    }

    /// Changes to an accessor's JSON for new data, which are appended: into `view`, which is moved, or into a new view.
    fn accessor_changes(&mut self, old: usize, view: Option<usize>, data: &NewData) -> Changes {
        let record = &self.document.records.accessors[old];
        let view = self.append(data, view);
        let (Format { component, normalized, .. }, count) = (data.format, data.count());
        let old = record.format;
        let is_other_component = old.is_none_or(|old| old.component != component);
        let is_other_scale = old.is_none_or(|old| old.normalized != normalized);
        let changes = [
            ("byteOffset", true, None),
            ("sparse", true, None),
            ("bufferView", record.view != Some(view), Some(view.to_string())),
            ("count", record.count != count as u64, Some(count.to_string())),
            ("componentType", is_other_component, Some(component.as_gl_enum().to_string())),
            ("normalized", is_other_scale, normalized.then(|| "true".to_owned())),
        ];
        let changes = changes.into_iter().filter(|(_, is_new, _)| *is_new);
        let mut changes: Changes = changes.map(|(name, _, text)| (name.to_owned(), text)).collect();
        if !data.same_bounds {
            changes.extend(self.bound_changes(record.object, data));
        }
        changes
    }

    /// New `min` and `max`, where the accessor has them.
    fn bound_changes(&self, accessor: Value, data: &NewData) -> Changes {
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
    fn append(&mut self, data: &NewData, view: Option<usize>) -> usize {
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

    pub fn remark(&mut self, remark: Remark, count: usize) {
        *self.remarks.entry(remark).or_default() += count;
    }

    pub fn warn(&mut self, place: Place, text: String) {
        self.warnings.entry(text).or_default().push(place);
    }

    /// Makes all changes. An additional buffer has the address that `uri` makes of its content; it replaces an unused `stale` one.
    pub fn finish(mut self, stale: Option<usize>, uri: impl FnOnce(&[u8]) -> Option<String>) -> Changed<'a> {
        let document = self.document;
        let bin = document.glb.as_ref().and_then(|glb| glb.bin());
        let old: &[u8] = bin.map_or(&[], |range| &document.buffers.file[range]);
        let appended = std::mem::take(&mut self.appended);
        let replaced = stale.filter(|&buffer| self.is_deserted(buffer));
        let mut bin = NewBin {
            old,
            base: self.home.1,
            appended: Vec::new(),
            patches: std::mem::take(&mut self.patches),
        };
        let mut extra = None;
        let (buffer, base) = self.home;
        self.write_views(replaced.filter(|_| !self.in_bin).unwrap_or(buffer), base);
        if appended.is_empty() {
        } else if self.in_bin {
            let length = base + appended.len();
            match document.records.buffers.first() {
                Some(&buffer) => self.splices.set(buffer, "byteLength", length),
                None => self.splices.push("buffers", format!("{{\"byteLength\":{length}}}")),
            }
            bin.appended = appended;
        } else {
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
        let bin = Some(bin).filter(|bin| !bin.appended.is_empty() || !bin.patches.is_empty());
        Changed { json: self.splices.apply(), bin, extra, replaced }
    }
}

/// What an edit changes besides normals: its rank among the notes, the noun for its count, and its text.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Remark(u8, pub [&'static str; 2], pub &'static str);

impl Remark {
    /// Whether the change is one that an edit of normals is meant to make.
    pub fn is_expected(self) -> bool {
        self == Self::TANGENTS_COMPUTED
    }
}

const HAVE: [&str; 2] = ["primitive has", "primitives have"];
const LOST: [&str; 2] = ["primitive lost", "primitives lost"];

impl Remark {
    pub const WITHOUT_NORMAL: Self =
        Self(0, ["corner has", "corners have"], "no new normal; the stored one was kept, or +Z written");
    pub const STALE_DELTAS: Self = Self(1, HAVE, "morph targets with normals that belong to the old normals");
    pub const TANGENTS_REMOVED: Self = Self(2, LOST, "the tangents of the old normals (see --tangents)");
    pub const TANGENTS_COMPUTED: Self =
        Self(3, HAVE, "new tangents, which go with the new normals (see --tangents)");
    pub const EMPTIED: Self =
        Self(4, HAVE, "no faces left; one triangle without area was written, because glTF needs one");
    pub const DRACO_REMOVED: Self = Self(5, LOST, "the Draco copy; the plain data were kept");
}
