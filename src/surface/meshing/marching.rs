//! Marching tetrahedra: meshes that are independent of the parameters of the surface.

use crate::mesh::Faces;
use crate::num::parallel;
use crate::surface::error::{MOST_CELLS, Result, SurfaceError, check_count};
use crate::surface::meshing::net::Net;
use crate::surface::meshing::pattern::GridHash;
use crate::surface::shapes::chart::Sample;
use crate::surface::shapes::implicit::{Implicit, Room};
use glam::{DVec3, UVec3};
use rustc_hash::FxHashMap;

/// The six tetrahedra of a cube, one for each order of the axes from its lowest corner to its highest (H. W. Kuhn
/// 1960). Bits of a corner's number, x lowest, are its coordinates. All tetrahedra have the same orientation.
const TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 1, 3, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 5, 1, 7], [0, 3, 2, 7], [0, 6, 4, 7]];

/// The surface within its box, cut by a cubic lattice with so many cells along the longest side. If the surface closes
/// within the box, the lattice is shifted by a random part of a cell, so that its points lie on no plane of symmetry.
pub(crate) fn net(surface: &dyn Implicit, room: Room, cells: u32, hash: GridHash) -> Result<Net> {
    let lattice = Lattice::new(room, cells, hash)?;
    let counts = lattice.cells + UVec3::ONE;
    let total = counts.x as usize * counts.y as usize * counts.z as usize;
    let is_inside = |index: usize| surface.value(lattice.point(lattice.place(index))) < 0.0;
    let inside = parallel::map(total, is_inside);
    // One vertex for each lattice edge that crosses the surface, between a point inside and one outside.
    let (mut numbers, mut edges) = (FxHashMap::default(), Vec::new());
    let mut crossing = |a: usize, b: usize| {
        let edge = if inside[a] { [a, b] } else { [b, a] };
        *numbers.entry(edge).or_insert_with(|| {
            edges.push(edge);
            edges.len() as u32 - 1
        })
    };
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for cell in (0..total).map(|index| lattice.place(index)).filter(|place| place.cmplt(lattice.cells).all())
    {
        let corners: [usize; 8] = std::array::from_fn(|bits| lattice.index(cell + offset(bits)));
        if corners.iter().any(|&corner| inside[corner] != inside[corners[0]]) {
            for tetrahedron in TETRAHEDRA {
                cut(tetrahedron.map(|k| corners[k]), &inside, &mut crossing, &mut triangles);
            }
        }
    }
    let sample = |&[within, without]: &[usize; 2]| {
        let [within, without] = [within, without].map(|index| lattice.point(lattice.place(index)));
        on_surface(surface, within, without)
    };
    let samples: Option<Vec<Sample>> = parallel::map_each(&edges, sample).into_iter().collect();
    let reason = "the surface has no normal at a point where the lattice meets it";
    let samples = samples.ok_or_else(|| SurfaceError::pattern("marching", reason))?;
    Ok(Net::without_parameters(samples, Faces::triangles(triangles.as_flattened().to_vec())))
}

fn offset(bits: usize) -> UVec3 {
    UVec3::new(bits as u32 & 1, bits as u32 >> 1 & 1, bits as u32 >> 2 & 1)
}

struct Lattice {
    origin: DVec3,
    spacing: DVec3,
    cells: UVec3,
}

impl Lattice {
    fn new(room: Room, cells: u32, hash: GridHash) -> Result<Self> {
        const CHANNEL: u32 = 5;
        check_count("cells along a side of the box", cells, 1..=u64::MAX)?;
        let size = room.high - room.low;
        let edge = size.max_element() / f64::from(cells);
        let (mut origin, mut spacing, mut counts) = (room.low, DVec3::splat(edge), UVec3::ONE);
        for axis in 0..3 {
            let needed = (size[axis] / edge).ceil().max(1.0);
            counts[axis] = if room.ends[axis] {
                spacing[axis] = size[axis] / needed;
                needed as u32
            } else {
                // Between a quarter and three quarters of a cell is left free below, at least a quarter above.
                origin[axis] -= edge * (0.25 + 0.5 * hash.at(axis as u32, 0, CHANNEL));
                needed as u32 + 1
            };
        }
        let total = counts.to_array().iter().fold(1_u64, |total, &count| total.saturating_mul(count.into()));
        check_count("cells of the box", total, 0..=MOST_CELLS)?;
        Ok(Self { origin, spacing, cells: counts })
    }

    fn point(&self, place: UVec3) -> DVec3 {
        self.origin + self.spacing * place.as_dvec3()
    }

    /// The place of a lattice point, numbered along x first.
    fn place(&self, index: usize) -> UVec3 {
        let (columns, rows) = (self.cells.x as usize + 1, self.cells.y as usize + 1);
        let (x, y, z) = (index % columns, index / columns % rows, index / columns / rows);
        UVec3::new(x as u32, y as u32, z as u32)
    }

    fn index(&self, place: UVec3) -> usize {
        let UVec3 { x, y, z } = place;
        let (columns, rows) = (self.cells.x as usize + 1, self.cells.y as usize + 1);
        x as usize + columns * (y as usize + rows * z as usize)
    }
}

/// The triangles within a tetrahedron, facing outside. Permutations bring corners that are alone or inside to the
/// front; they are even, so the tetrahedron keeps its orientation.
fn cut(
    corners: [usize; 4],
    inside: &[bool],
    crossing: &mut impl FnMut(usize, usize) -> u32,
    triangles: &mut Vec<[u32; 3]>,
) {
    let mask = (0..4).filter(|&k| inside[corners[k]]).fold(0, |mask, k| mask | 1 << k);
    let [a, b, c, d] = match mask {
        0b0001 | 0b1110 | 0b0011 => [0, 1, 2, 3],
        0b0010 | 0b1101 => [1, 0, 3, 2],
        0b0100 | 0b1011 => [2, 0, 1, 3],
        0b1000 | 0b0111 => [3, 0, 2, 1],
        0b0101 => [0, 2, 3, 1],
        0b1001 => [0, 3, 1, 2],
        0b0110 => [1, 2, 0, 3],
        0b1010 => [1, 3, 2, 0],
        0b1100 => [2, 3, 0, 1],
        _ => return,
    }
    .map(|k: usize| corners[k]);
    if (mask as u32).count_ones() == 2 {
        let [ac, ad, bd, bc] = [crossing(a, c), crossing(a, d), crossing(b, d), crossing(b, c)];
        triangles.extend([[ac, ad, bd], [ac, bd, bc]]);
    } else {
        let [ab, ac, ad] = [crossing(a, b), crossing(a, c), crossing(a, d)];
        triangles.push(if inside[a] { [ab, ac, ad] } else { [ab, ad, ac] });
    }
}

/// The point of the surface between a point inside and one outside, by bisection to the last bits.
fn on_surface(surface: &dyn Implicit, within: DVec3, without: DVec3) -> Option<Sample> {
    const STEPS: usize = 54;
    let at = |t: f64| within + (without - within) * t;
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..STEPS {
        let middle = f64::midpoint(low, high);
        if surface.value(at(middle)) < 0.0 { low = middle } else { high = middle }
    }
    let position = at(f64::midpoint(low, high));
    Some(Sample { position, normal: surface.normal_at(position)? })
}
