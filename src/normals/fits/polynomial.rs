//! Polynomials over the tangent planes of eight vertices, each through its vertex and near its neighbours.

use crate::normals::fits::rings::MOST;
use crate::num::{
    Column, Eight, Kernel, LANES, Lanes, LeastSquares, Pivoting, ROWS, Scalars, UnitVec3, Vectors, dispatch,
    least_squares, unit_scale,
};
use glam::DVec3;

/// Columns of the largest system: nine unknowns and the heights.
const COLUMNS: usize = 10;

/// What is fitted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Polynomial {
    /// 2 or 3.
    pub(crate) degree: usize,
    /// Rows have the weight 1/d to this power, with d the distance from the vertex: 0, 1 or 2.
    pub(crate) row_power: u8,
    /// Fewest neighbours.
    pub(crate) fewest: usize,
    /// Whether rings are added to two that have fewer.
    pub(crate) adds_rings: bool,
    /// The smallest distance of a column of unit length from the span of those before it.
    pub(crate) nearest: f64,
    /// The order of columns.
    pub(crate) pivoting: Pivoting,
}

impl Polynomial {
    /// Unknowns: the terms of degree 1 to [`degree`](Self::degree).
    pub(crate) fn unknowns(self) -> usize {
        if self.degree == 2 { 5 } else { 9 }
    }
}

/// Eight vertices with their neighbours.
pub(crate) struct Neighbourhoods {
    /// How many lanes are in use, and their numbers of neighbours.
    used: usize,
    counts: [usize; LANES],
    /// The frame of each: two tangents and the normal.
    frames: [[DVec3; 3]; LANES],
    /// From each vertex to its neighbours, unscaled.
    offsets: [Column; 3],
    /// Brings offsets to unit size.
    scales: Eight,
    columns: [Column; COLUMNS],
}

impl Neighbourhoods {
    pub(crate) fn new() -> Box<Self> {
        Box::new(Self {
            used: 0,
            counts: [0; LANES],
            frames: [[DVec3::ZERO; 3]; LANES],
            offsets: [[Eight::ZERO; ROWS + 1]; 3],
            scales: Eight::ZERO,
            columns: [[Eight::ZERO; ROWS + 1]; COLUMNS],
        })
    }

    pub(crate) fn clear(&mut self) {
        self.used = 0;
    }

    /// Adds a vertex with its neighbours, at most 64. The axes depend on its normal alone (Duff et al. 2017).
    pub(crate) fn push(&mut self, centre: DVec3, normal: DVec3, neighbours: &[DVec3]) {
        let lane = self.used;
        let (tangent, bitangent) = normal.any_orthonormal_pair();
        self.frames[lane] = [tangent, bitangent, normal];
        self.counts[lane] = neighbours.len();
        self.used += 1;
        let mut largest = DVec3::ZERO;
        let [x, y, z] = &mut self.offsets;
        for (((neighbour, x), y), z) in neighbours.iter().zip(x).zip(y).zip(z) {
            let offset = *neighbour - centre;
            largest = largest.max(offset.abs());
            x.0[lane] = offset.x;
            y.0[lane] = offset.y;
            z.0[lane] = offset.z;
        }
        self.scales.0[lane] = unit_scale(largest.max_element());
    }

    /// The normal of the polynomial at each vertex, where it can be fitted.
    pub(crate) fn normals(&mut self, polynomial: Polynomial) -> [Option<DVec3>; LANES] {
        self.fill_up();
        let found = dispatch(Fit { neighbourhoods: self, polynomial });
        std::array::from_fn(|lane| {
            let [tangent, bitangent, normal] = self.frames[lane];
            let (a, b) = (found.unknowns[0].0[lane], found.unknowns[1].0[lane]);
            let is_solved = lane < self.used && found.solved >> lane & 1 == 1;
            let normal = is_solved.then(|| UnitVec3::new(normal - a * tangent - b * bitangent));
            normal.flatten().map(UnitVec3::get)
        })
    }

    /// Makes lanes that are not in use copies of the first, and adds rows without neighbours to lanes of fewer.
    fn fill_up(&mut self) {
        for lane in self.used..LANES {
            self.counts[lane] = self.counts[0];
            self.frames[lane] = self.frames[0];
            self.scales.0[lane] = self.scales.0[0];
            for row in self.offsets.iter_mut().flat_map(|column| &mut column[..self.counts[0]]) {
                row.0[lane] = row.0[0];
            }
        }
        let rows = self.rows();
        for column in &mut self.offsets {
            for (lane, &count) in self.counts.iter().enumerate() {
                column[count..rows].iter_mut().for_each(|row| row.0[lane] = 0.0);
            }
        }
    }

    /// At least as many as there are columns, so that lanes of fewer neighbours are dependent and nothing worse.
    fn rows(&self) -> usize {
        self.counts.into_iter().fold(COLUMNS, usize::max)
    }
}

struct Fit<'a> {
    neighbourhoods: &'a mut Neighbourhoods,
    polynomial: Polynomial,
}

impl Kernel for Fit<'_> {
    type Output = LeastSquares;

    #[inline(always)]
    fn run<A: Lanes>(self, arch: A) -> LeastSquares {
        let Self { neighbourhoods, polynomial } = self;
        let rows = neighbourhoods.rows();
        let unknowns = polynomial.unknowns();
        let axis = |which: usize| -> Vectors<A> {
            let component = |i: usize| {
                let lanes = neighbourhoods.frames.map(|frame| frame[which][i]);
                Scalars::load(arch, &Eight(lanes)).value
            };
            Vectors::new(arch, [component(0), component(1), component(2)])
        };
        let (tangent, bitangent, normal) = (axis(0), axis(1), axis(2));
        let scale = Scalars::load(arch, &neighbourhoods.scales);
        let (zero, one) = (Scalars::splat(arch, 0.0), Scalars::splat(arch, 1.0));
        let Neighbourhoods { offsets: [xs, ys, zs], columns, .. } = neighbourhoods;
        for row in 0..rows {
            let component = |column: &Column| Scalars::load(arch, &column[row]).value;
            let offset = Vectors::new(arch, [component(xs), component(ys), component(zs)]).scaled(scale);
            let (x, y) = (offset.dot(tangent), offset.dot(bitangent));
            let squared = offset.squared_length();
            // Rows without a neighbour stay zero.
            let is_neighbour = zero.less(squared);
            let distance = if polynomial.row_power == 1 { squared.sqrt() } else { squared };
            let weight = is_neighbour.select(one / distance, zero);
            let mut put = |column: usize, term: Scalars<A>| {
                let term = if polynomial.row_power > 0 { term * weight } else { term };
                columns[column][row] = term.store();
            };
            let (xx, xy, yy) = (x * x, x * y, y * y);
            put(0, x);
            put(1, y);
            put(2, xx);
            put(3, xy);
            put(4, yy);
            if polynomial.degree > 2 {
                put(5, xx * x);
                put(6, xx * y);
                put(7, x * yy);
                put(8, yy * y);
            }
            put(unknowns, offset.dot(normal));
        }
        least_squares(arch, &mut columns[..=unknowns], rows, polynomial.pivoting, polynomial.nearest)
    }
}

const _: () = assert!(MOST == ROWS, "all neighbours are rows");
