//! Up to eight corners at a vertex of a triangle mesh, matched by one comparison of vertex numbers each.

use crate::mesh::NONE;
use crate::normals::creases::dihedral_test::AngleFilter;
use crate::normals::faces::shape::FaceState;
use crate::num::{LANES, Lanes};
use glam::DVec3;

/// The corners at a vertex, laid out side by side: their triangles, and the vertices after and before theirs.
#[repr(align(32))]
pub(crate) struct Spokes {
    pub(crate) to: [u32; LANES],
    from: [u32; LANES],
    pub(crate) faces: [u32; LANES],
    /// How many; 0 as well if they are too many.
    pub(crate) count: usize,
}

impl Spokes {
    pub(crate) const NONE: Self =
        Self { to: [NONE; LANES], from: [NONE; LANES], faces: [0; LANES], count: 0 };

    /// Lays out the corners of a ring; none if there are more corners than lanes.
    #[inline(always)]
    pub(crate) fn lay_out(&mut self, triangles: &[[u32; 3]], vertex: u32, ring: &[u32]) {
        *self = Self::NONE;
        if ring.len() > LANES {
            return;
        }
        self.count = ring.len();
        for (i, &corner) in ring.iter().enumerate() {
            let face = corner / 3;
            let [a, b, c] = triangles[face as usize];
            let to = if b == vertex { c } else { a };
            let to = if a == vertex { b } else { to };
            // Of three numbers and one of them, the other two are left.
            (self.to[i], self.from[i], self.faces[i]) = (to, a ^ b ^ c ^ vertex ^ to, face);
        }
    }

    /// How many edges lead to a vertex of a higher number.
    #[inline(always)]
    pub(crate) fn edges_to_higher(&self, vertex: u32) -> usize {
        self.to[..self.count].iter().filter(|&&to| to > vertex).count()
    }

    /// How the corners follow each other. `None` for no corners or too many, for an edge of more than two triangles or of two that
    /// are wound against each other, and for a triangle that does not add to sums, as one with two corners here. Without states,
    /// all triangles add to sums.
    #[inline(always)]
    pub(crate) fn links<A: Lanes>(&self, arch: A, state: &[FaceState]) -> Option<Links> {
        let Self { to, from, faces, count } = self;
        let mut links = Links { next: 0, linked: 0 };
        let (mut reached, mut irregular) = (0, 0);
        for (at, &to) in to[..*count].iter().enumerate() {
            // The corners whose triangles come after this one's.
            let met = arch.equal_bits(from, to);
            irregular |= met & met.wrapping_sub(1) | met & reached;
            reached |= met;
            links.linked |= u8::from(met != 0) << at;
            links.next |= u64::from(met.trailing_zeros() % 8) << (8 * at + 3);
        }
        let is_linked = |at: usize| links.linked >> at & 1 == 1;
        let leaves_alone = |at: usize| arch.equal_bits(to, to[at]).is_power_of_two();
        if irregular != 0 || *count == 0 || !(0..*count).all(|at| is_linked(at) || leaves_alone(at)) {
            return None;
        }
        let is_counted = |&face: &u32| state[face as usize] == FaceState::Counted;
        (state.is_empty() || faces[..*count].iter().all(is_counted)).then_some(links)
    }

    /// The corners before edges of which the filter does not show that they are smooth. `turns`: by how many radians rounding may have
    /// turned the normal of each face.
    #[inline(always)]
    pub(crate) fn uncertain(
        &self,
        links: Links,
        unit: &[DVec3],
        turns: Option<&[f64]>,
        filter: Option<AngleFilter>,
    ) -> u8 {
        let Some(filter) = filter else { return 0 };
        let mut uncertain = 0;
        for at in 0..self.count {
            let [face, next] = [at, links.after(at)].map(|at| self.faces[at % LANES] as usize);
            let turn = turns.map_or(0.0, |turns| turns[face] + turns[next]);
            uncertain |= u8::from(!filter.is_surely_within(unit[face], unit[next], turn)) << at;
        }
        uncertain & links.linked
    }
}

/// How the corners at a vertex follow each other, each across an edge of just two triangles.
#[derive(Clone, Copy)]
pub(crate) struct Links {
    /// For each corner eight times the number of the next one, a byte each: the number by which to shift for that one's byte.
    next: u64,
    /// Which corners have a next one.
    pub(crate) linked: u8,
}

impl Links {
    /// The next corner of a corner that has one.
    #[inline(always)]
    pub(crate) fn after(self, at: usize) -> usize {
        (self.next >> (8 * at) & 0xff) as usize / 8
    }

    /// Whether they are one closed fan of so many. No two have the same next one.
    #[inline(always)]
    pub(crate) fn are_one_cycle(self, count: usize) -> bool {
        if self.linked.count_ones() as usize != count {
            return false;
        }
        let (mut at, mut steps) = (self.next & 0xff, 1);
        while at != 0 {
            at = self.next >> at & 0xff;
            steps += 1;
        }
        steps == count
    }

    /// The groups, by their lowest corner; each corner of a group is one bit.
    pub(crate) fn groups(self, count: usize) -> impl Iterator<Item = u8> {
        let all = u8::MAX >> (8 - count);
        let mut starts = all;
        for at in (0..count).filter(|at| self.linked >> at & 1 == 1) {
            starts &= !(1 << self.after(at));
        }
        let (mut found, mut rest) = ([0_u8; LANES], all);
        while rest != 0 {
            // Open fans come first. A closed fan may start at any corner.
            let start = if starts != 0 { starts } else { rest }.trailing_zeros() as usize;
            let (mut group, mut at) = (1 << start, start);
            while self.linked >> at & 1 == 1 && self.after(at) != start {
                at = self.after(at);
                group |= 1 << at;
            }
            (starts, rest) = (starts & !group, rest & !group);
            found[group.trailing_zeros() as usize] = group;
        }
        found.into_iter().filter(|&group| group != 0)
    }
}
