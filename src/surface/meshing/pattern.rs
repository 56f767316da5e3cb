//! How a surface is cut into faces: the pattern, its settings and its random numbers.

use crate::surface::error::{Result, SurfaceError, out_of_range};

/// The arrangement of vertices and faces on a surface. All vertices lie on it unless there is [`Tessellation::noise`].
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pattern {
    /// A grid of the parameters, each cell cut in two along the same diagonal, or with jitter along a random one.
    #[default]
    Triangles,
    /// The same with about as many cells, elongated by that ratio: for 10 a grid of 64 × 32 becomes one of 20 × 101.
    Stretched(f64),
    /// A grid with every other row that many times as close to the next one: slivers next to good triangles. Takes no
    /// jitter, because it would fold the slivers.
    Slivers(f64),
    /// The grid's cells themselves: quadrilaterals that are not plane, triangles at poles.
    Quads,
    /// The dual of the triangles: a polygon around each vertex that is not on an open side, with vertices above the middles of
    /// triangles. That around the tip of a cone is flat and has the normals of the sides: `crease inspect` reports its edges.
    Polygons,
    /// An icosahedron with triangles cut in four that many times at the midpoints of edges, which move onto the sphere.
    /// For [`StarShaped`](crate::surface::StarShaped) surfaces. Takes no segments and no jitter.
    Icosphere(u32),
    /// Marching tetrahedra over a lattice with the first of [`Tessellation::segments`] along the longest side of the
    /// box, for zero sets: valences from 4 up, and slivers where the surface is close to a lattice point. Takes no
    /// jitter.
    Marching,
    /// The Delaunay triangulation of as many scattered points as a grid has, evenly spaced on the sides, for heights over a
    /// rectangle. Takes no jitter.
    Scattered,
}

impl Pattern {
    /// The name of the pattern, as the command line has it.
    pub fn name(&self) -> &'static str {
        match self {
            Pattern::Triangles => "triangles",
            Pattern::Stretched(_) => "stretched",
            Pattern::Slivers(_) => "slivers",
            Pattern::Quads => "quads",
            Pattern::Polygons => "polygons",
            Pattern::Icosphere(_) => "icosphere",
            Pattern::Marching => "marching",
            Pattern::Scattered => "scattered",
        }
    }
}

/// Settings for making a mesh of a surface.
///
/// ```
/// use crease::surface::{Surface, Tessellation, Torus};
///
/// let irregular = Tessellation { jitter: 0.5, ..Tessellation::default() };
/// let mesh = Surface::from(Torus::default()).tessellate(&irregular)?;
/// assert_eq!((mesh.vertex_count(), mesh.face_count()), (64 * 32, 2 * 64 * 32));
/// # Ok::<(), crease::surface::SurfaceError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Tessellation {
    /// The arrangement.
    pub pattern: Pattern,
    /// Cells along u and v; of each patch, for a surface of several.
    #[serde(deserialize_with = "crate::num::list")]
    pub segments: [u32; 2],
    /// Random displacement of vertices within the surface, in cells, by at most half of it in each direction; 0 to 1. Vertices on
    /// open sides and at poles stay. Above 0, cells are cut along random diagonals.
    pub jitter: f64,
    /// Largest random displacement of vertices along the normal, in mean lengths of an edge; 0 to 1. Stored normals stay exact.
    pub noise: f64,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Whether the parameters become texture coordinates, if there are any.
    #[serde(skip)]
    pub uvs: bool,
}

impl Default for Tessellation {
    /// Regular triangles, 64 × 32.
    fn default() -> Self {
        Self { pattern: Pattern::Triangles, segments: [64, 32], jitter: 0.0, noise: 0.0, seed: 0, uvs: false }
    }
}

impl Tessellation {
    pub(super) fn check(&self) -> Result<()> {
        let Self { pattern, jitter, noise, .. } = *self;
        for (what, found) in [("the jitter", jitter), ("the noise", noise)] {
            if !(0.0..=1.0).contains(&found) {
                return Err(out_of_range(what, found, "a number from 0 to 1"));
            }
        }
        if let Pattern::Stretched(ratio) | Pattern::Slivers(ratio) = pattern
            && !(1.0..=1e12).contains(&ratio)
        {
            return Err(out_of_range("the ratio", ratio, "a number from 1 to 1e12"));
        }
        let takes_jitter = matches!(
            pattern,
            Pattern::Triangles | Pattern::Stretched(_) | Pattern::Quads | Pattern::Polygons
        );
        if jitter > 0.0 && !takes_jitter {
            return Err(SurfaceError::pattern(pattern.name(), "it takes no jitter"));
        }
        Ok(())
    }
}

/// Numbers in [0, 1) by grid position: the same on every machine and in any order.
///
/// With seed 0, the hash of h = (73856093 i) ^ (19349663 j) ^ (83492791 c) mod 2³² (M. Teschner et al., *Optimized spatial
/// hashing*, VMV 2003), mixed by two multiplications and two shifts; another seed changes h before mixing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GridHash {
    /// Which of 2³² such families of numbers.
    pub seed: u32,
}

impl GridHash {
    /// The number for a place and a channel.
    ///
    /// ```
    /// # use crease::surface::GridHash;
    /// assert_eq!(GridHash::default().at(10, 20, 3), 0.9537125984206796);
    /// ```
    pub fn at(self, i: u32, j: u32, channel: u32) -> f64 {
        let place =
            i.wrapping_mul(73_856_093) ^ j.wrapping_mul(19_349_663) ^ channel.wrapping_mul(83_492_791);
        let mut h = place ^ self.seed.wrapping_mul(0x9e37_79b9);
        h = h.wrapping_mul(2_654_435_761);
        h ^= h >> 16;
        h = h.wrapping_mul(2_246_822_519);
        h ^= h >> 13;
        f64::from(h) / 4_294_967_296.0
    }

    /// The family for another part of the same surface; part 0 keeps its own.
    pub(crate) fn of_part(self, part: u32) -> Self {
        Self { seed: self.seed.wrapping_add(part.wrapping_mul(0x85eb_ca6b)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_numbers_come_out() {
        for (i, j, channel, expected) in [
            (0, 0, 1, 0.3717674051877111),
            (1, 0, 1, 0.010175860254094),
            (3, 7, 2, 0.5458030328154564),
            (10, 20, 3, 0.9537125984206796),
        ] {
            // 32 bits, printed with 15 or 16 digits.
            assert!((GridHash::default().at(i, j, channel) - expected).abs() < 1e-15, "{i} {j} {channel}");
        }
        assert_ne!(GridHash { seed: 1 }.at(0, 0, 1), GridHash::default().at(0, 0, 1));
    }

    #[test]
    fn numbers_are_spread_evenly() {
        for seed in [0, 1, 7] {
            let mut bins = [0_u32; 16];
            for (i, j) in (0..200).flat_map(|i| (0..200).map(move |j| (i, j))) {
                bins[(GridHash { seed }.at(i, j, 2) * 16.0) as usize] += 1;
            }
            // 40000 numbers: 2500 a bin with a standard deviation of 48, if they were independent.
            assert!(bins.iter().all(|count| (2250..2750).contains(count)), "{bins:?}");
        }
    }
}
