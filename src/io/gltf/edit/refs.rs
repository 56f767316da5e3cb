//! References between records: which accessors, views and bytes may be changed without touching anything else.

use crate::io::gltf::buffers::Storage;
use crate::io::gltf::document::GltfDocument;
use crate::io::gltf::json::{Json, Kind};
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

/// How often each accessor and view is referred to. A number anywhere in an extension may mean either.
pub struct References {
    accessors: FxHashMap<u64, usize>,
    views: FxHashMap<u64, usize>,
    /// Accessors whose bytes in the BIN chunk are no other accessor's.
    pub unaliased: FxHashSet<usize>,
}

/// Extensions full of numbers that mean materials and variants only.
const NO_ACCESSORS: &[&str] = &["KHR_materials_variants", "KHR_lights_punctual"];

impl References {
    pub fn new(document: &GltfDocument) -> References {
        let records = &document.records;
        let json = &records.json;
        let pinned = pinned(json);
        let mut accessors = counts(&pinned);
        let references = records.references();
        references.iter().for_each(|&(.., accessor)| *accessors.entry(accessor as u64).or_default() += 1);

        let other: Vec<u64> =
            pinned.into_iter().chain(records.images().map(|(_, view)| view as u64)).collect();
        let mut views = counts(&other);
        let of_accessors = records.accessors.iter().filter_map(|accessor| accessor.view);
        let of_accessors = of_accessors.chain(records.sparse_views());
        of_accessors.for_each(|view| *views.entry(view as u64).or_default() += 1);
        References { accessors, views, unaliased: unaliased(document, &other) }
    }

    /// Whether all references to an accessor are the `sites` that a change will go through.
    pub fn is_only_at(&self, accessor: usize, sites: usize) -> bool {
        self.accessors.get(&(accessor as u64)) == Some(&sites)
    }

    pub fn is_only_user(&self, view: usize) -> bool {
        self.views.get(&(view as u64)) == Some(&1)
    }
}

fn counts<'a>(numbers: impl IntoIterator<Item = &'a u64>) -> FxHashMap<u64, usize> {
    let mut counts = FxHashMap::default();
    numbers.into_iter().for_each(|&number| *counts.entry(number).or_default() += 1);
    counts
}

/// All integers in extensions of what may refer to accessors or views.
pub fn pinned(json: &Json) -> FxHashSet<u64> {
    let mut pinned = FxHashSet::default();
    let lists = ["meshes", "nodes", "scenes", "skins", "animations", "accessors"];
    let lists = lists.into_iter().filter_map(|name| json.member(json.root(), name));
    let objects =
        lists.flat_map(|list| json.descendants(list)).filter(|&value| json.kind(value) == Kind::Object);
    for object in objects.chain([json.root()]) {
        let Some(extensions) = json.member(object, "extensions") else { continue };
        for (name, extension) in json.members(extensions) {
            if json.string(name).is_some_and(|name| NO_ACCESSORS.contains(&name.as_ref())) {
                continue;
            }
            let values = json.descendants(extension).chain([extension]);
            pinned.extend(values.filter_map(|value| json.integer(value)));
        }
    }
    pinned
}

#[derive(Clone)]
struct Extent {
    bytes: Range<u64>,
    stride: u64,
    size: u64,
    accessor: Option<usize>,
}

impl Extent {
    /// Whether two extents share a byte. Interleaved elements lie between each other without doing so.
    fn meets(&self, other: &Extent) -> bool {
        if self.bytes.end <= other.bytes.start || other.bytes.end <= self.bytes.start {
            return false;
        }
        if self.stride != other.stride || self.stride == WHOLE {
            return true;
        }
        let (own, its) = (self.bytes.start % self.stride, other.bytes.start % self.stride);
        let ahead = if its >= own { its - own } else { its + (self.stride - own) };
        ahead < self.size || (ahead > 0 && self.stride - ahead < other.size)
    }
}

/// The stride of a view that is used from end to end.
const WHOLE: u64 = u64::MAX;

/// More extents than this that overlap are not examined: their bytes count as shared.
const LARGEST_CLUSTER: usize = 64;

/// The accessors whose bytes no other accessor shares, nor any of the `other` views.
fn unaliased(document: &GltfDocument, other: &[u64]) -> FxHashSet<usize> {
    let records = &document.records;
    let in_bin = |view: usize| {
        let buffer = &document.buffers.list[records.views[view].buffer];
        matches!(buffer.storage, Storage::Bin(_))
    };
    let mut extents: Vec<Extent> = Vec::new();
    for (number, accessor) in records.accessors.iter().enumerate() {
        let stored = accessor.view.filter(|&view| in_bin(view)).zip(accessor.format);
        if let Some((view, format)) = stored {
            let (start, size) =
                (records.views[view].offset.saturating_add(accessor.offset), format.size() as u64);
            let stride = records.views[view].stride.unwrap_or(size).max(1);
            let length = stride.saturating_mul(accessor.count.saturating_sub(1)).saturating_add(size);
            let bytes = start..start.saturating_add(length);
            extents.push(Extent { bytes, stride, size, accessor: Some(number) });
        }
        // Rare enough to take their views as used from end to end.
        let sparse = accessor.sparse.iter().flat_map(|sparse| [sparse.indices.0, sparse.values.0]);
        extents.extend(sparse.filter(|&view| in_bin(view)).map(|view| whole(document, view)));
    }
    let other = other.iter().filter_map(|&view| usize::try_from(view).ok());
    let other = other.filter(|&view| view < records.views.len() && in_bin(view));
    extents.extend(other.map(|view| whole(document, view)));
    extents.sort_by_key(|extent| (extent.bytes.start, extent.bytes.end, extent.accessor));

    let mut owners = FxHashSet::default();
    let mut reach = 0;
    let overlaps = |before: &Extent, next: &Extent| {
        reach = reach.max(before.bytes.end);
        next.bytes.start < reach
    };
    for cluster in extents.chunk_by(overlaps).filter(|cluster| cluster.len() <= LARGEST_CLUSTER) {
        for (number, extent) in cluster.iter().enumerate() {
            let alone = !cluster.iter().enumerate().any(|(other, o)| other != number && o.meets(extent));
            owners.extend(extent.accessor.filter(|_| alone));
        }
    }
    owners
}

fn whole(document: &GltfDocument, view: usize) -> Extent {
    let view = &document.records.views[view];
    let bytes = view.offset..view.offset.saturating_add(view.length);
    Extent { bytes, stride: WHOLE, size: view.length, accessor: None }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(start: u64, count: u64, size: u64, stride: u64) -> Extent {
        Extent { bytes: start..start + (count - 1) * stride + size, stride, size, accessor: None }
    }

    #[test]
    fn interleaved_elements_do_not_meet() {
        let positions = extent(100, 10, 12, 24);
        assert!(!positions.meets(&extent(112, 10, 12, 24)));
        assert!(positions.meets(&extent(108, 10, 12, 24)));
        assert!(positions.meets(&extent(88 + 24, 10, 14, 24)), "it runs into the next element");
        assert!(positions.meets(&positions.clone()));
        assert!(positions.meets(&extent(112, 10, 12, 20)), "different strides cross sooner or later");
        assert!(!positions.meets(&extent(0, 10, 10, 10)));
        // The same against every byte set.
        let bytes = |e: &Extent| {
            (e.bytes.clone()).filter(|b| (b - e.bytes.start) % e.stride < e.size).collect::<FxHashSet<_>>()
        };
        for start in 90..140 {
            let other = extent(start, 10, 8, 24);
            assert_eq!(positions.meets(&other), !bytes(&positions).is_disjoint(&bytes(&other)), "{start}");
        }
    }
}
