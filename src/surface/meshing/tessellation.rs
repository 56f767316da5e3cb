//! Meshes of surfaces, of good and of bad shape.

use crate::mesh::{Column, Columns, Mesh, MeshBuilder};
use crate::surface::catalogue::Surface;
use crate::surface::error::SurfaceError;
use crate::surface::meshing::dual;
use crate::surface::meshing::grid;
use crate::surface::meshing::hash::GridHash;
use crate::surface::meshing::icosphere;
use crate::surface::meshing::marching;
use crate::surface::meshing::net::{Net, sample};
use crate::surface::meshing::patches;
use crate::surface::meshing::scattered;
use crate::surface::shapes::chart::Sample;

/// Most cells of a tessellation: a mesh of some gigabytes.
pub(in crate::surface) const MOST_CELLS: u64 = 1 << 24;

/// How vertices and faces are arranged on a surface. All vertices lie on it but for [`Tessellation::noise`].
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pattern {
    /// A grid of the parameters, each cell cut in two: all the same way, or with jitter at random.
    #[default]
    Triangles,
    /// The same with cells that many times as long one way, for about as many of them: for 10 a grid of 64 × 32 becomes
    /// one of 20 × 101.
    Stretched(f64),
    /// A grid whose every other row lies that many times as close to the next as it would: needles beside good
    /// triangles. Takes no jitter: needles would fold.
    Slivers(f64),
    /// The grid's cells themselves: quadrilaterals that are not plane, triangles at poles.
    Quads,
    /// The dual of the triangles: a polygon round each of their vertices that is not on an open side, with vertices above
    /// the middles of the triangles. The one round the tip of a cone cuts it off, flat, and has the normals of the sides,
    /// which are exact where its corners are: it is lit as if it were round, and `crease inspect` tells so of its edges
    /// (`averaged-crease`).
    Polygons,
    /// Twenty triangles cut in four that many times by the midpoints of their edges, which move onto the sphere each
    /// time. For surfaces that are spheres but for stretching along rays ([`StarShaped`](crate::surface::StarShaped)). Takes no
    /// segments and no jitter.
    Icosphere(u32),
    /// Marching tetrahedra over a lattice that knows nothing of the surface, with the first of [`Tessellation::segments`]
    /// along the longest side of its bounding box: valences from 4 up, slivers where the surface brushes by a lattice
    /// point. For surfaces that are zero sets. Takes no jitter.
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

/// A way to make a mesh of a surface.
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
    /// How far vertices move at random within the surface: a vertex of the grid anywhere within so many cells about its
    /// place, so by half of it at most each way; 0 to 1. Vertices on open sides and at poles stay. Above 0, cells are cut
    /// along either diagonal at random.
    pub jitter: f64,
    /// How far vertices leave the surface at random along its normal, at most, in mean lengths of an edge; 0 to 1. Their
    /// normals stay those of the surface.
    pub noise: f64,
    /// Which random numbers.
    pub seed: u32,
    /// Whether the mesh gets the parameters as texture coordinates, where there are any.
    #[serde(skip)]
    pub uvs: bool,
}

impl Default for Tessellation {
    /// Regular triangles, 64 × 32.
    fn default() -> Self {
        Self { pattern: Pattern::Triangles, segments: [64, 32], jitter: 0.0, noise: 0.0, seed: 0, uvs: false }
    }
}

impl Surface {
    /// A mesh of the surface with its exact normals, one a vertex. Faces run counter-clockwise seen from where normals
    /// point to; closed surfaces give closed meshes.
    ///
    /// The same settings give the same bits on any machine at any number of threads.
    ///
    /// # Errors
    /// For settings out of range, a pattern that the surface cannot be given, and too few or too many segments (2²⁴
    /// cells).
    pub fn tessellate(&self, tessellation: &Tessellation) -> Result<Mesh, SurfaceError> {
        check(tessellation)?;
        let Tessellation { pattern, segments, seed, .. } = *tessellation;
        let hash = GridHash { seed };
        let missing = |reason| SurfaceError::Pattern { pattern: pattern.name(), reason };
        let net = match pattern {
            Pattern::Icosphere(level) => {
                let star = self.star_shaped().ok_or_else(|| missing("the surface is no stretched sphere"))?;
                icosphere::net(star, level)?
            }
            Pattern::Marching => {
                let zero_set = self.zero_set().zip(self.room());
                let (surface, room) = zero_set.ok_or_else(|| missing("the surface is no zero set"))?;
                marching::net(surface, room, segments[0], hash)?
            }
            Pattern::Scattered => {
                let height =
                    self.heights().ok_or_else(|| missing("the surface is no height over a plane"))?;
                scattered::net(height, segments, hash)?
            }
            _ => self.grid(tessellation)?,
        };
        Ok(into_mesh(net, tessellation))
    }

    /// Patterns that are made of a grid.
    fn grid(&self, tessellation: &Tessellation) -> Result<Net, SurfaceError> {
        let charts = self.charts();
        let mut net = grid::net(&charts, tessellation)?;
        patches::join(&mut net, self.patches(), tessellation);
        if tessellation.pattern == Pattern::Polygons {
            net = dual::net(&net, |face, at| sample(charts[net.chart_of(face)], at))?;
        }
        Ok(net)
    }
}

fn check(tessellation: &Tessellation) -> Result<(), SurfaceError> {
    let Tessellation { pattern, jitter, noise, .. } = *tessellation;
    for (what, found) in [("the jitter", jitter), ("the noise", noise)] {
        if !(0.0..=1.0).contains(&found) {
            return Err(SurfaceError::Setting { what, found, expected: "a number from 0 to 1" });
        }
    }
    if let Pattern::Stretched(ratio) | Pattern::Slivers(ratio) = pattern
        && !(1.0..=1e12).contains(&ratio)
    {
        let expected = "a number from 1 to 1e12";
        return Err(SurfaceError::Setting { what: "the ratio", found: ratio, expected });
    }
    let takes_jitter =
        matches!(pattern, Pattern::Triangles | Pattern::Stretched(_) | Pattern::Quads | Pattern::Polygons);
    if jitter > 0.0 && !takes_jitter {
        let reason = "it takes no jitter";
        return Err(SurfaceError::Pattern { pattern: pattern.name(), reason });
    }
    Ok(())
}

fn into_mesh(net: Net, tessellation: &Tessellation) -> Mesh {
    let lift = lifts(&net, tessellation);
    let lifted = |(sample, lift): (&Sample, f64)| sample.position + sample.normal.get() * lift;
    let positions = net.samples.iter().zip(lift).map(lifted).collect();
    let normals = net.samples.iter().map(|sample| sample.normal.get()).collect();
    let uvs = (tessellation.uvs && !net.corner_parameters.is_empty()).then(|| {
        let index = (0..net.corner_parameters.len() as u32).collect();
        Column::per_corner(net.corner_parameters, index)
    });
    let columns = Columns { normals: Some(Column::per_vertex(normals)), uvs, ..Columns::default() };
    let builder = MeshBuilder { positions, faces: net.faces, columns, ..MeshBuilder::default() };
    builder.build().expect("lengths are bounded, so positions are finite, and faces count their own vertices")
}

/// How far each vertex leaves the surface.
fn lifts(net: &Net, tessellation: &Tessellation) -> impl Iterator<Item = f64> + use<> {
    const CHANNEL: u32 = 4;
    let reach = if tessellation.noise > 0.0 { tessellation.noise * net.mean_edge() } else { 0.0 };
    let hash = GridHash { seed: tessellation.seed };
    (0..).map(move |vertex| reach * (2.0 * hash.at(vertex, 0, CHANNEL) - 1.0))
}

#[cfg(test)]
mod tests;
