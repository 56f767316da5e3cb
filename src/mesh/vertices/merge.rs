//! Vertices at equal positions, and vertices that agree in everything: finding and merging them.

use super::split::VertexSplit;
use crate::mesh::columns::{Column, ColumnIndex, NONE};
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::positions::{PositionsRef, Storage};
use crate::mesh::rings::Scatter;
use crate::num::parallel;
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;

/// The bits of a position, with −0 taken as +0: equal for positions that are merged or welded exactly.
#[inline]
pub(crate) fn place_key(p: DVec3) -> [u64; 3] {
    (p + DVec3::ZERO).to_array().map(f64::to_bits)
}

/// For each of so many items, the first one at the same place. `vertex` is the vertex of each; two vertices are at the same
/// place if their [keys](place_key) are equal in every shape, a list of positions.
///
/// A hash of each item, and a flat table of item numbers per thread, each for a share of the hashes: at most 13 bytes an item in
/// addition to the result.
pub(in crate::mesh) fn first_at_place(
    count: usize,
    shapes: &[PositionsRef],
    vertex: impl Fn(u32) -> u32 + Sync,
) -> Vec<u32> {
    // The bits of singles, half as many, are in the same relation.
    if let [PositionsRef::F32(points)] = *shapes {
        let key = |item: u32, _: usize| points[vertex(item) as usize].map(|x| u64::from((x + 0.0).to_bits()));
        return first_of_places(count, &Places { key, shapes: 1 });
    }
    let key = |item: u32, shape: usize| place_key(shapes[shape].at(vertex(item)));
    first_of_places(count, &Places { key, shapes: shapes.len() })
}

/// Items that a thread hashes at a time.
const HASHED: usize = 1 << 14;

fn first_of_places<K: Fn(u32, usize) -> [u64; 3] + Sync>(count: usize, places: &Places<K>) -> Vec<u32> {
    let parts = if count > 1 << 14 { rayon::current_num_threads().clamp(1, 8) } else { 1 };
    let mut hashes = vec![0; count];
    parallel::map_chunks(&mut hashes, HASHED, |number, chunk| {
        chunk.iter_mut().zip(number * HASHED..).for_each(|(hash, item)| *hash = places.hash(item as u32));
    });
    let hashes = &hashes;
    let mut first = Scatter::default();
    first.reserve(count);
    parallel::map(parts, |part| {
        let mut table = PlaceTable { places, hashes, slots: vec![NONE; count / (3 * parts) + 8], used: 0 };
        for (item, &hash) in (0..).zip(hashes) {
            // Slots are by the high bits.
            let mixed = hash.wrapping_mul(0x9e37_79b9);
            if (u64::from(mixed) * parts as u64) >> 32 == part as u64 {
                first.set(item, table.first(item));
            }
        }
    });
    first.into_values()
}

/// Items with positions.
struct Places<K> {
    /// The key of an item in one of the shapes.
    key: K,
    shapes: usize,
}

impl<K: Fn(u32, usize) -> [u64; 3]> Places<K> {
    /// A hash whose bits are all mixed well, although most positions have few significant bits.
    #[inline]
    fn hash(&self, item: u32) -> u32 {
        let mut hash = 0_u64;
        for shape in 0..self.shapes {
            let [x, y, z] = (self.key)(item, shape);
            hash = hash.rotate_left(23).wrapping_mul(0xd6e8_feb8_6659_fd93)
                ^ x.wrapping_mul(0x9e37_79b9_7f4a_7c15)
                    .wrapping_add(y.wrapping_mul(0xc2b2_ae3d_27d4_eb4f))
                    .wrapping_add(z.wrapping_mul(0x1656_67b1_9e37_79f9));
        }
        let product = u128::from(hash ^ hash >> 32) * 0xa076_1d64_78bd_642f;
        (((product >> 64) as u64 ^ product as u64) >> 32) as u32
    }

    #[inline]
    fn are_same(&self, a: u32, b: u32) -> bool {
        (0..self.shapes).all(|shape| (self.key)(a, shape) == (self.key)(b, shape))
    }
}

/// A table of items with linear probing, at most two thirds full.
struct PlaceTable<'a, K> {
    places: &'a Places<K>,
    hashes: &'a [u32],
    slots: Vec<u32>,
    used: usize,
}

impl<K: Fn(u32, usize) -> [u64; 3]> PlaceTable<'_, K> {
    /// The item that came first at the place of this one.
    #[inline]
    fn first(&mut self, item: u32) -> u32 {
        let at = self.slot(item);
        if self.slots[at] != NONE {
            return self.slots[at];
        }
        self.slots[at] = item;
        self.used += 1;
        if 3 * self.used > 2 * self.slots.len() {
            self.grow();
        }
        item
    }

    /// The slot of an item's place, or an empty one for it.
    #[inline]
    fn slot(&self, item: u32) -> usize {
        let hash = self.hashes[item as usize];
        let is_same = |other: u32| self.hashes[other as usize] == hash && self.places.are_same(other, item);
        let mut at = ((u64::from(hash) * self.slots.len() as u64) >> 32) as usize;
        while self.slots[at] != NONE && !is_same(self.slots[at]) {
            at = if at + 1 == self.slots.len() { 0 } else { at + 1 };
        }
        at
    }

    #[cold]
    fn grow(&mut self) {
        let empty = vec![NONE; 2 * self.slots.len()];
        for item in std::mem::replace(&mut self.slots, empty) {
            if item != NONE {
                let at = self.slot(item);
                self.slots[at] = item;
            }
        }
    }
}

/// For each position the first equal one.
pub(crate) fn first_positions(positions: PositionsRef<'_>) -> Vec<u32> {
    first_at_place(positions.len(), &[positions], |vertex| vertex)
}

/// A [`VertexSplit`], borrowed.
#[derive(Clone, Copy)]
pub(crate) struct SplitView<'a> {
    source: &'a [u32],
    sample: &'a [u32],
    corners: &'a [u32],
}

impl<'a> SplitView<'a> {
    /// The split of separate triangles, none of whose vertices has two corners: each number is that of its corner.
    pub(crate) fn of_soup(corners: &'a [u32]) -> Self {
        Self { source: corners, sample: corners, corners }
    }
}

impl<'a> From<&'a VertexSplit> for SplitView<'a> {
    fn from(split: &'a VertexSplit) -> Self {
        Self { source: &split.source, sample: &split.sample, corners: &split.corners }
    }
}

impl Mesh {
    /// For each vertex the first one at the same position.
    pub(crate) fn first_vertices(&self) -> Vec<u32> {
        first_positions(self.positions())
    }

    /// Whether each corner has a vertex of its own, numbered like it: the form of STL and of glTF without indices.
    pub(crate) fn is_soup(&self) -> bool {
        let corners = self.faces.corners();
        let is_own = |(&vertex, corner): (&u32, usize)| vertex as usize == corner;
        let are_own = |range: Range<usize>| corners[range.clone()].iter().zip(range).all(is_own);
        corners.len() == self.vertex_count() && !parallel::ranges(corners.len(), are_own).contains(&false)
    }

    /// Whether no vertex belongs to two corners: each face has vertices of its own.
    pub(crate) fn is_facet_wise(&self) -> bool {
        let corners = self.faces.corners();
        let mut is_used =
            vec![false; if corners.len() > self.vertex_count() { 0 } else { self.vertex_count() }];
        !corners.is_empty()
            && !is_used.is_empty()
            && corners.iter().all(|&vertex| !std::mem::replace(&mut is_used[vertex as usize], true))
    }

    /// The vertices of a split, of which those that agree in position (to the bit, −0 = +0), normal, texture coordinates and
    /// colour are one: the first of them, in the order of the split. Normals agree if they are the same in `normals`, the type that
    /// is written. Points and lines of the mesh must be none.
    ///
    /// Cost: as [`first_at_place`].
    pub(crate) fn merge_split(&self, split: SplitView<'_>, normals: Storage) -> VertexSplit {
        let columns = &self.columns;
        let sample = |item: u32| (split.sample[item as usize], split.source[item as usize]);
        let bits = |n: &DVec3| match normals {
            Storage::F32 => n.as_vec3().to_array().map(|x| u64::from(x.to_bits())),
            Storage::F64 => n.to_array().map(f64::to_bits),
        };
        let normal = |item| vector_key(columns.normals.as_ref(), sample(item), bits);
        let uv = |item| vector_key(columns.uvs.as_ref(), sample(item), |t| [t.x.to_bits(), t.y.to_bits(), 0]);
        let color = |item: u32| {
            columns.colors.as_ref().map_or([0; 3], |colors| {
                let [r, g, b, a] =
                    colors[split.source[item as usize] as usize].map(|c| u64::from(c.to_bits()));
                [r << 32 | g, b << 32 | a, 0]
            })
        };
        let positions = self.positions();
        let key = |item: u32, shape: usize| match shape {
            0 => place_key(positions.at(split.source[item as usize])),
            1 => normal(item),
            2 => uv(item),
            _ => color(item),
        };
        let shapes = match (&columns.colors, &columns.uvs) {
            (Some(_), _) => 4,
            (None, Some(_)) => 3,
            (None, None) => 2,
        };
        let (vertices, representative) = self.representatives(split, shapes);
        let first = first_of_places(
            vertices.len(),
            &Places { key: |item: u32, shape: usize| key(vertices[item as usize], shape), shapes },
        );
        let mut merged = VertexSplit::default();
        let mut number = vec![NONE; first.len()];
        for (item, &first) in first.iter().enumerate() {
            if first as usize == item {
                number[item] = merged.source.len() as u32;
                merged.source.push(split.source[vertices[item] as usize]);
                merged.sample.push(split.sample[vertices[item] as usize]);
            } else {
                number[item] = number[first as usize];
            }
        }
        let corners = split.corners.par_iter();
        merged.corners = corners.map(|&vertex| number[representative[vertex as usize] as usize]).collect();
        merged
    }

    /// Some vertices of a split and, for each of all, the number of one among them that agrees with it. In a mesh that was smoothed
    /// across equal positions, most corners at a place have one entry of the normals: that is found without hashing.
    fn representatives(&self, split: SplitView<'_>, shapes: usize) -> (Vec<u32>, Vec<u32>) {
        let normals = self.columns.normals.as_ref().filter(|_| shapes == 2);
        let entries = normals.and_then(|column| match &column.index {
            ColumnIndex::PerCorner(index) => Some((index, vec![NONE; column.values.len()])),
            ColumnIndex::PerVertex => None,
        });
        let all = split.source.len() as u32;
        let Some((index, mut first)) = entries else { return ((0..all).collect(), (0..all).collect()) };
        let positions = self.positions();
        let place = |item: u32| place_key(positions.at(split.source[item as usize]));
        let mut vertices = Vec::new();
        let mut representative = Vec::with_capacity(all as usize);
        for item in 0..all {
            let corner = split.sample[item as usize];
            let entry = if corner == NONE { None } else { first.get_mut(index[corner as usize] as usize) };
            let known = entry.as_deref().copied().filter(|&known| known != NONE);
            if let Some(known) = known
                && place(vertices[known as usize]) == place(item)
            {
                representative.push(known);
                continue;
            }
            let number = vertices.len() as u32;
            if let Some(entry) = entry {
                *entry = number;
            }
            vertices.push(item);
            representative.push(number);
        }
        (vertices, representative)
    }

    /// The mesh whose normals and texture coordinates are per corner, so that vertices differ in their positions only.
    pub(crate) fn with_corner_columns(mut self) -> Self {
        let corners = self.faces.corners().to_vec();
        let columns = &mut self.columns;
        let per_corner = |index: &mut ColumnIndex| {
            if *index == ColumnIndex::PerVertex {
                *index = ColumnIndex::PerCorner(corners.clone());
            }
        };
        columns.normals.iter_mut().for_each(|column| per_corner(&mut column.index));
        columns.uvs.iter_mut().for_each(|column| per_corner(&mut column.index));
        self
    }

    /// Whether vertices have anything but a position.
    pub(crate) fn has_vertex_attributes(&self) -> bool {
        let columns = &self.columns;
        let of_vertices = |index: &ColumnIndex| *index == ColumnIndex::PerVertex;
        columns.normals.as_ref().is_some_and(|normals| of_vertices(&normals.index))
            || columns.uvs.as_ref().is_some_and(|uvs| of_vertices(&uvs.index))
            || columns.colors.is_some()
            || !(columns.hard_edges.is_empty() && columns.morph_targets.is_empty())
            || !(columns.points.is_empty() && columns.lines.is_empty())
    }

    /// The mesh with one vertex for all vertices at the same position (to the bit, −0 = +0), in the order of their first
    /// occurrence. Unchanged if vertices have other attributes than positions.
    pub(crate) fn with_shared_vertices(mut self) -> Self {
        if self.has_vertex_attributes() {
            return self;
        }
        let mut number = self.first_vertices();
        let mut sources = Vec::new();
        for vertex in 0..number.len() {
            number[vertex] = if number[vertex] as usize == vertex {
                sources.push(vertex as u32);
                sources.len() as u32 - 1
            } else {
                number[number[vertex] as usize]
            };
        }
        let corners = self.faces.corners().iter().map(|&vertex| number[vertex as usize]);
        self.faces = self.faces.with_corners(corners.collect()).into();
        self.positions = Arc::new(self.positions().gather(&sources));
        self
    }
}

/// The bits of a vertex's value in a column; others than those of any value if it has none.
fn vector_key<T>(
    column: Option<&Column<T>>,
    (corner, vertex): (u32, u32),
    bits: impl Fn(&T) -> [u64; 3],
) -> [u64; 3] {
    let value = column.and_then(|column| match (&column.index, corner) {
        (ColumnIndex::PerVertex, _) => column.values.get(vertex as usize),
        (_, NONE) => None,
        _ => column.get(corner as usize, vertex),
    });
    value.map_or([u64::MAX; 3], bits)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Column, Columns, Faces, MeshBuilder};

    fn soup(columns: Columns) -> Mesh {
        let places = [
            [0., 0., 0.],
            [1., 0., 0.],
            [1., 1., 0.],
            [-0., 0., 0.],
            [1., 1., 0.],
            [0., 1., 0.],
            [7., 7., 7.],
        ];
        let positions = places.map(DVec3::from).to_vec();
        let faces = Faces::triangles((0..6).collect());
        MeshBuilder { positions: positions.into(), faces, columns }.build().unwrap()
    }

    #[test]
    fn corners_at_one_place_share_a_vertex() {
        let normals = Column::per_corner(vec![DVec3::Z, DVec3::X], vec![0, 0, 0, 1, 1, 1]);
        let mesh =
            soup(Columns { normals: Some(normals.clone()), ..Columns::default() }).with_shared_vertices();
        assert_eq!(mesh.faces().corners(), [0, 1, 2, 0, 2, 3]);
        assert_eq!(
            mesh.positions().to_vec(),
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [7., 7., 7.]].map(DVec3::from)
        );
        assert_eq!(mesh.columns().normals, Some(normals));
    }

    #[test]
    fn what_vertices_have_keeps_them_separate() {
        let normals = Some(Column::per_vertex(vec![DVec3::Z; 7]));
        for columns in [
            Columns { normals, ..Columns::default() },
            Columns { colors: Some(vec![[1.0; 4]; 7]), ..Columns::default() },
            Columns { points: vec![6], ..Columns::default() },
        ] {
            let mesh = soup(columns);
            assert_eq!(mesh.clone().with_shared_vertices(), mesh);
        }
    }
}
