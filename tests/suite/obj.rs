//! OBJ: real files against their manifest and against `tobj`, editing, and generated text.

mod edit;
mod generated;
mod real;

use crease::io::{Loaded, ReadError, ReadOptions, obj};
use crease::mesh::{Column, ColumnIndex, Mesh};

fn read(bytes: &[u8]) -> Result<Loaded, ReadError> {
    obj::read(bytes.to_vec(), None, &ReadOptions::default())
}

fn mesh_of(bytes: &[u8]) -> Mesh {
    read(bytes).unwrap_or_else(|error| panic!("{error}")).parts.remove(0).mesh
}

/// The value at every corner.
fn at_corners<T: Copy>(mesh: &Mesh, column: &Option<Column<T>>) -> Vec<Option<T>> {
    let corners = mesh.faces().corners().iter().enumerate();
    corners
        .map(|(corner, &vertex)| column.as_ref().and_then(|column| column.get(corner, vertex)).copied())
        .collect()
}

/// The index of a column, one a corner.
fn corner_index<T>(column: &Column<T>) -> &[u32] {
    match &column.index {
        ColumnIndex::PerCorner(index) => index,
        ColumnIndex::PerVertex => panic!("OBJ indexes corners"),
    }
}

/// Pseudo-random numbers, the same each time (SplitMix64).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }
}
