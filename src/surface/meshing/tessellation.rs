//! Meshes of surfaces: the pattern is made over samples of the surface and becomes a mesh with exact normals.

use crate::mesh::{Column, Columns, Mesh, MeshBuilder};
use crate::surface::catalogue::Surface;
use crate::surface::error::{Result, SurfaceError};
use crate::surface::meshing::net::{Net, dual, sample};
use crate::surface::meshing::pattern::{GridHash, Pattern, Tessellation};
use crate::surface::meshing::{grid, gridless, marching};
use crate::surface::shapes::chart::Sample;

impl Surface {
    /// A mesh of the surface with its exact normals, one a vertex; faces are counter-clockwise, closed surfaces give closed meshes.
    /// The same settings give the same bits on any machine at any number of threads.
    ///
    /// # Errors
    /// For settings out of range, an impossible pattern, and too few or too many segments (2²⁴ cells).
    pub fn tessellate(&self, tessellation: &Tessellation) -> Result<Mesh> {
        tessellation.check()?;
        let Tessellation { pattern, segments, seed, .. } = *tessellation;
        let hash = GridHash { seed };
        let missing = |reason| SurfaceError::pattern(pattern.name(), reason);
        let net = match pattern {
            Pattern::Icosphere(level) => {
                let star = self
                    .star_shaped()
                    .ok_or_else(|| missing("the pattern needs a sphere, an ellipsoid or a superquadric"))?;
                gridless::icosphere(star, level)?
            }
            Pattern::Marching => {
                let zero_set = self.zero_set().zip(self.room());
                let (surface, room) = zero_set.ok_or_else(|| {
                    missing("the pattern needs a surface other than a Bézier patch or the teapot")
                })?;
                marching::net(surface, room, segments[0], hash)?
            }
            Pattern::Scattered => {
                let height = self
                    .heights()
                    .ok_or_else(|| missing("the pattern needs a plane, a wave or a monkey saddle"))?;
                gridless::scattered(height, segments, hash)?
            }
            _ => self.grid(tessellation)?,
        };
        Ok(into_mesh(net, tessellation))
    }

    fn grid(&self, tessellation: &Tessellation) -> Result<Net> {
        let charts = self.charts();
        let mut net = grid::net(&charts, tessellation)?;
        grid::join(&mut net, self.patches(), tessellation);
        if tessellation.pattern == Pattern::Polygons {
            net = dual(&net, |face, at| sample(charts[net.chart_of(face)], at))?;
        }
        Ok(net)
    }
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
    let builder = MeshBuilder { positions, faces: net.faces, columns };
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
