//! The corners of groups of triangles, from all over the mesh.

use crate::mesh::PositionsRef;
use crate::normals::sums::partition::BLOCK;
use crate::num::{LANES, Lanes};

/// Three vertices for each triangle of a block, in order.
static IN_ORDER: [[u32; 3]; BLOCK] = {
    let mut triangles = [[0; 3]; BLOCK];
    let mut at = 0;
    while at < 3 * BLOCK {
        triangles[at / 3][at % 3] = at as u32;
        at += 1;
    }
    triangles
};

/// Whether triangles can be read where they are: whole groups, whose vertices exist and are not the last one. A row is read
/// with the number after it.
#[inline(always)]
pub(crate) fn are_in_place(vertices: usize, triangles: &[[u32; 3]]) -> bool {
    let highest = triangles.as_flattened().iter().fold(0, |highest, &vertex| vertex.max(highest));
    (highest as usize) + 1 < vertices && triangles.len().is_multiple_of(LANES)
}

/// Copies the corners of a block that cannot be read in place, as the vertices of [`whole_groups`]. The triangles
/// that complete the last group repeat the first. `None` if a vertex does not exist.
#[inline(never)]
pub(crate) fn copied<P: Copy>(points: &[P], triangles: &[[u32; 3]]) -> Option<Vec<P>> {
    let padding = std::iter::repeat_n(triangles.first()?, LANES);
    // One more, as the number after the last row is read.
    let corners = triangles.iter().chain(padding).flatten();
    corners.map(|&vertex| points.get(vertex as usize).copied()).collect()
}

/// Triangles of which each has three vertices of its own, in order: so many and what completes the last group of eight.
pub(crate) fn whole_groups(triangles: usize) -> &'static [[u32; 3]] {
    &IN_ORDER[..triangles.next_multiple_of(LANES)]
}

/// The coordinates of the corners of eight triangles, multiplied by a factor if they are of double precision.
#[inline(always)]
pub(crate) fn columns<A: Lanes>(
    arch: A,
    positions: PositionsRef,
    triangles: &[[u32; 3]; LANES],
    factor: f64,
) -> Option<[[A::Number; 3]; 3]> {
    match positions {
        PositionsRef::F32(points) => {
            let points = points.as_flattened();
            let p0 = arch.columns_of_singles(rows(points, triangles, 0)?);
            let p1 = arch.columns_of_singles(rows(points, triangles, 1)?);
            Some([p0, p1, arch.columns_of_singles(rows(points, triangles, 2)?)])
        }
        PositionsRef::F64(points) => {
            let points = bytemuck::cast_slice(points);
            let mut corners = [[arch.splat(factor); 3]; 3];
            for (corner, numbers) in corners.iter_mut().enumerate() {
                let [x, y, z, _] = arch.columns(rows(points, triangles, corner)?);
                *numbers = [arch.mul(x, numbers[0]), arch.mul(y, numbers[1]), arch.mul(z, numbers[2])];
            }
            Some(corners)
        }
    }
}

/// The coordinates of one corner of eight triangles and the number after each. `None` if there are not four numbers.
///
/// Triangles that are not [`are_in_place`] give something else: the smaller of two places costs less than a branch for each
/// row, after which a compiler keeps all places at hand until the last row is known to exist.
#[inline(always)]
pub(crate) fn rows<'a, T>(
    coordinates: &'a [T],
    [a, b, c, d, e, f, g, h]: &[[u32; 3]; LANES],
    corner: usize,
) -> Option<[&'a [T; 4]; LANES]> {
    let last = coordinates.len().checked_sub(4)?;
    let row = |triangle: &[u32; 3]| coordinates[last.min(3 * triangle[corner] as usize)..].first_chunk();
    Some([row(a)?, row(b)?, row(c)?, row(d)?, row(e)?, row(f)?, row(g)?, row(h)?])
}
