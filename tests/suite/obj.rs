//! OBJ: real files against their manifest and against `tobj`, editing, and generated text.

mod edit;
mod generated;
mod real;

use crate::random::Random;
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
