//! How a surface is cut into faces: the pattern and its settings.

use crate::surface::error::{SurfaceError, out_of_range};

/// How vertices and faces are arranged on a surface. All vertices lie on it but for [`Tessellation::noise`].
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pattern {
    /// A grid of the parameters, each cell cut in two along the same diagonal, or with jitter along a random one.
    #[default]
    Triangles,
    /// The same with cells elongated by that ratio, for about as many cells: for 10 a grid of 64 × 32 becomes one of
    /// 20 × 101.
    Stretched(f64),
    /// A grid in which every other row lies that many times as close to the next one: slivers next to good triangles.
    /// Takes no jitter: slivers would fold.
    Slivers(f64),
    /// The grid's cells themselves: quadrilaterals that are not plane, triangles at poles.
    Quads,
    /// The dual of the triangles: a polygon around each vertex that is not on an open side, with vertices above the
    /// middles of the triangles. The one around the tip of a cone cuts it off, flat, and has the normals of the sides,
    /// which are exact at its corners: it is shaded as if it were round, and `crease inspect` reports its edges
    /// (`averaged-crease`).
    Polygons,
    /// Twenty triangles cut in four that many times by the midpoints of their edges, which move onto the sphere each
    /// time. For surfaces that are spheres but for stretching along rays ([`StarShaped`](crate::surface::StarShaped)). Takes no
    /// segments and no jitter.
    Icosphere(u32),
    /// Marching tetrahedra over a lattice, with the first of [`Tessellation::segments`] along the longest side of the
    /// bounding box: valences from 4 up, slivers where the surface passes close to a lattice point. For surfaces that
    /// are zero sets. Takes no jitter.
    Marching,
    /// The Delaunay triangulation of scattered points, as many as the grid would have, and evenly spaced ones on the
    /// sides. For heights over a rectangle. Takes no jitter.
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
    pub segments: [u32; 2],
    /// Random displacement of vertices within the surface, in cells: by at most half of it in each direction; 0 to 1.
    /// Vertices on open sides and at poles stay. Above 0, cells are cut along random diagonals.
    pub jitter: f64,
    /// Largest random displacement of vertices along the normal, in mean lengths of an edge; 0 to 1. The stored normals
    /// stay those of the surface.
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
    /// Checks the numbers, and that the pattern takes them.
    pub(super) fn check(&self) -> Result<(), SurfaceError> {
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
            let reason = "it takes no jitter";
            return Err(SurfaceError::Pattern { pattern: pattern.name(), reason });
        }
        Ok(())
    }
}
