//! The surfaces and tilings that errors are measured on.

use super::angles::angle_between;
use super::described::described;
use super::effort::Effort;
use crate::mesh::{Link, Mesh, Topology};
use crate::normals::NormalField;
use crate::num::Radians;
use crate::num::parallel;
use crate::surface::{
    BezierPatch, Catenoid, Cone, Cylinder, Ellipsoid, MonkeySaddle, Pattern, Primitive, Sphere, Superquadric,
    Surface, SurfaceError, Tessellation, Torus, Wave,
};
use glam::DVec3;
use serde::Serialize;

/// A surface with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedSurface {
    /// The name, as on the command line of `surface`.
    pub name: &'static str,
    /// The surface, with its default dimensions.
    pub surface: Surface,
}

impl NamedSurface {
    /// The ones that are measured: five with [`Effort::Quick`], else all but the plane, on which every normal is exact.
    pub fn all(effort: Effort) -> Vec<NamedSurface> {
        let all: [(&str, Surface); 11] = [
            ("sphere", Sphere::default().into()),
            ("torus", Torus::default().into()),
            ("wave", Surface::Wave(Wave::default())),
            ("catenoid", Surface::Catenoid(Catenoid::default())),
            ("superquadric", Surface::Superquadric(Superquadric::default())),
            ("ellipsoid", Ellipsoid::default().into()),
            ("cylinder", Cylinder::default().into()),
            ("cone", Cone::default().into()),
            ("monkey-saddle", Surface::MonkeySaddle(MonkeySaddle::default())),
            ("bezier", Surface::Patch(Box::<BezierPatch>::default())),
            ("teapot", Surface::Teapot),
        ];
        let count = if effort == Effort::Quick { 5 } else { all.len() };
        all.into_iter().take(count).map(|(name, surface)| NamedSurface { name, surface }).collect()
    }

    /// The torus, which costs and precision are measured on.
    pub(super) fn torus() -> Self {
        NamedSurface { name: "torus", surface: Torus::default().into() }
    }

    /// Whether the surface has a normal at a vertex of it: everywhere but at the tip of a cone.
    fn is_smooth_at(&self, position: DVec3) -> bool {
        let on_axis = position.x == 0.0 && position.z == 0.0;
        !(on_axis && matches!(self.surface, Surface::Primitive(Primitive::Cone(_))))
    }
}

described! {
    /// A way to cut a surface into faces, with the class of meshes that it represents.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
    #[serde(rename_all = "kebab-case")]
    Tiling {
        /// A grid, all cells cut the same way.
        Regular = "regular": "regular grids",
        /// A grid whose vertices move by up to a quarter of a cell each way, its cells cut at random: what scans and
        /// simplified meshes look like.
        Jittered = "jittered": "irregular triangles",
        /// Cells ten times as long one way.
        Stretched = "stretched": "triangles ten times as long as wide",
        /// Every other row a thousand times as close to the next.
        Slivers = "slivers": "good triangles next to slivers",
        /// The cells of a jittered grid, uncut.
        Quads = "quads": "irregular quads",
        /// The dual of a jittered grid.
        Polygons = "polygons": "polygons of many corners",
        /// A subdivided icosahedron.
        Icosphere = "icosphere": "subdivided icosahedra",
        /// Marching tetrahedra.
        Marching = "marching": "marching tetrahedra",
        /// Delaunay triangles of scattered points.
        Scattered = "scattered": "Delaunay triangles of scattered points",
        /// The jittered grid with vertices off the surface by up to a twentieth of an edge.
        Noisy = "noisy": "scans with noise",
    }
}

impl Tiling {
    /// Whether a surface can be cut this way.
    pub fn fits(self, surface: &Surface) -> bool {
        match self {
            Tiling::Icosphere => surface.star_shaped().is_some(),
            Tiling::Marching => surface.zero_set().is_some(),
            Tiling::Scattered => surface.heights().is_some(),
            _ => true,
        }
    }

    /// The settings at a level of resolution. Each level halves the edges of the one before; level 2 is the 64 × 32 that
    /// figures are quoted for, an icosphere of 1280 triangles, and a lattice of 24 along the longest side.
    pub fn tessellation(self, surface: &Surface, level: u32) -> Tessellation {
        let segments = match (self, surface) {
            (Tiling::Marching, _) => [6, 6],
            (_, Surface::Teapot) => [2, 2],
            (_, Surface::Patch(_)) => [12, 12],
            _ if surface.heights().is_some() => [12, 12],
            _ => [16, 8],
        };
        let (pattern, jitter) = match self {
            Tiling::Regular => (Pattern::Triangles, 0.0),
            Tiling::Jittered | Tiling::Noisy => (Pattern::Triangles, 0.5),
            Tiling::Stretched => (Pattern::Stretched(10.0), 0.0),
            Tiling::Slivers => (Pattern::Slivers(1000.0), 0.0),
            Tiling::Quads => (Pattern::Quads, 0.5),
            Tiling::Polygons => (Pattern::Polygons, 0.5),
            Tiling::Icosphere => (Pattern::Icosphere(level + 1), 0.0),
            Tiling::Marching => (Pattern::Marching, 0.0),
            Tiling::Scattered => (Pattern::Scattered, 0.0),
        };
        let noise = if self == Tiling::Noisy { 0.05 } else { 0.0 };
        let segments = segments.map(|n| n << level);
        Tessellation { pattern, segments, jitter, noise, ..Tessellation::default() }
    }

    /// Whether meshes depend on the seed.
    pub fn is_random(self) -> bool {
        !matches!(self, Tiling::Regular | Tiling::Stretched | Tiling::Slivers | Tiling::Icosphere)
    }

    /// The levels that are measured: four, which is three halvings, the last of them the finest. The icosphere of 42
    /// vertices is omitted: by symmetry every weight is exact on it.
    pub(super) fn levels(self, effort: Effort) -> std::ops::Range<u32> {
        let finest = match (effort, self) {
            (Effort::Quick, Tiling::Icosphere) => 4,
            (Effort::Quick, _) => 3,
            (Effort::Usual, _) | (Effort::Full, Tiling::Marching) => 4,
            (Effort::Full, _) => 5,
        };
        finest - 3..finest + 1
    }
}

/// A mesh of a surface with its true normals.
pub(super) struct SampleMesh {
    pub(super) mesh: Mesh,
    pub(super) topology: Topology,
    /// The exact normal of each vertex; `None` where errors are not counted: on boundaries, whose vertices lack half of their
    /// faces, and where the surface has no normal.
    pub(super) truth: Vec<Option<DVec3>>,
}

impl SampleMesh {
    pub(super) fn new(surface: &NamedSurface, tessellation: &Tessellation) -> Result<Self, SurfaceError> {
        let mesh = surface.surface.tessellate(tessellation)?;
        let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
        let normals = mesh.columns().normals.as_ref().map_or(&[][..], |column| &column.values);
        let known = normals.iter().zip(mesh.positions().iter());
        let mut truth: Vec<Option<DVec3>> =
            known.map(|(&normal, position)| surface.is_smooth_at(position).then_some(normal)).collect();
        for (normal, _) in
            truth.iter_mut().zip(boundary_vertices(&mesh, &topology)).filter(|(_, is_on)| *is_on)
        {
            *normal = None;
        }
        Ok(Self { mesh, topology, truth })
    }

    /// The number of vertices that are not counted.
    pub(super) fn excluded(&self) -> usize {
        self.truth.iter().filter(|normal| normal.is_none()).count()
    }

    /// The angle to the truth of every counted entry of a field of this mesh.
    pub(super) fn errors(&self, field: &NormalField) -> Vec<Radians> {
        parallel::filter_map(field.normals.values.len(), |entry| {
            let truth = self.truth[field.entry_vertex[entry] as usize]?;
            Some(angle_between(field.normals.values[entry], truth))
        })
    }
}

/// Which vertices are on an open boundary.
pub(super) fn boundary_vertices(mesh: &Mesh, topology: &Topology) -> Vec<bool> {
    let corners = mesh.faces().corners();
    let mut is_on = vec![false; mesh.vertex_count()];
    for half_edge in (0..corners.len() as u32).filter(|&it| topology.link(it) == Link::Boundary) {
        let (from, to) = topology.ends(corners, half_edge);
        [from, to].into_iter().for_each(|vertex| is_on[vertex as usize] = true);
    }
    is_on
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_surface_can_be_cut_every_way_that_fits() {
        for surface in NamedSurface::all(Effort::Full) {
            for tiling in Tiling::ALL.into_iter().filter(|tiling| tiling.fits(&surface.surface)) {
                let tessellation = tiling.tessellation(&surface.surface, 0);
                let sample = SampleMesh::new(&surface, &tessellation).unwrap();
                let counted = sample.truth.len() - sample.excluded();
                assert!(counted >= 12, "{} {}: {counted}", surface.name, tiling.name());
                let open = !matches!(surface.name, "sphere" | "torus" | "ellipsoid" | "superquadric");
                assert_eq!(sample.excluded() > 0, open, "{} {}", surface.name, tiling.name());
            }
        }
    }

    #[test]
    fn level_two_is_what_figures_are_quoted_for() {
        let torus = Surface::from(Torus::default());
        let tessellation = Tiling::Jittered.tessellation(&torus, 2);
        assert_eq!((tessellation.segments, tessellation.jitter), ([64, 32], 0.5));
        let sphere = Surface::from(Sphere::default());
        let pattern = Tiling::Icosphere.tessellation(&sphere, 2).pattern;
        assert_eq!(pattern, Pattern::Icosphere(3));
    }
}
