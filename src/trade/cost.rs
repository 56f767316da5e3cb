//! The cost of vertex normals, as a multiple of a plain loop.

use super::cases::{NamedSurface, SampleMesh, Tiling};
use super::effort::{Candidate, Effort, Observer, Progress, fewest_seconds};
use super::vertex::recipe;
use crate::mesh::{Faces, Mesh};
use crate::normals::{
    Averaging, Extras, NormalRecipe, Precision, Scratch, Weight, compute_reusing, vertex_normals,
};
use glam::DVec3;
use serde::Serialize;
use std::hint::black_box;

/// Costs on one thread, of a jittered torus whose positions are `f32` values.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Costs {
    /// Triangles of the mesh.
    pub triangles: usize,
    /// Nanoseconds a triangle of the [plain loop](plain_vertex_normals): single precision, area weights, no care.
    pub plain_ns: f64,
    /// The others, each in the same run.
    pub rows: Vec<CostRow>,
}

/// The cost of one weight one way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CostRow {
    /// How normals are computed.
    pub way: Way,
    /// The weight.
    pub weight: Weight,
    /// Nanoseconds a triangle.
    pub ns_per_triangle: f64,
    /// Times the plain loop.
    pub ratio: f64,
}

/// A way to compute vertex normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Way {
    /// [`vertex_normals`]: slices in, slices out, faithful.
    Slices,
    /// The same with [`Precision::Fast`].
    SlicesFast,
    /// [`compute_reusing`] of a mesh, with creases and faults, faithful.
    Mesh,
    /// The same with [`Precision::Fast`], which fits do not have.
    MeshFast,
}

impl Way {
    /// All ways.
    pub const ALL: [Way; 4] = [Way::Slices, Way::SlicesFast, Way::Mesh, Way::MeshFast];

    /// Whether normals of a weight are computed like this.
    fn has(self, weight: Weight) -> bool {
        self == Way::Mesh || !weight.is_fit()
    }

    fn precision(self) -> Precision {
        if matches!(self, Way::Slices | Way::Mesh) { Precision::Faithful } else { Precision::Fast }
    }
}

impl Costs {
    /// Times every weight every way.
    pub fn measure(effort: Effort, observe: Observer) -> Self {
        observe(Progress { stage: "cost", done: 0, total: 1 });
        let (level, rounds) = match effort {
            Effort::Quick => (3, 3),
            Effort::Usual => (4, 5),
            Effort::Full => (5, 7),
        };
        let torus = NamedSurface::torus();
        let sample = SampleMesh::new(&torus, &Tiling::Jittered.tessellation(&torus.surface, level));
        let costs = sample
            .map_or_else(|_| Self::default(), |it| Self::on(&rounded(&it.mesh, |p| p), &Way::ALL, rounds));
        observe(Progress { stage: "cost", done: 1, total: 1 });
        costs
    }

    /// Times every weight some ways on a mesh, whose polygons count as the triangles that they can be cut into.
    pub(super) fn on(mesh: &Mesh, ways: &[Way], rounds: usize) -> Self {
        let positions: Vec<[f32; 3]> = mesh.positions().iter().map(|p| p.as_vec3().to_array()).collect();
        let triangles = fans(mesh.faces());
        let mut candidates: Vec<Candidate> = Vec::new();
        let mut normals = vec![[0.0; 3]; positions.len()];
        let (points, list) = (&positions, &triangles);
        candidates.push(Box::new(move || plain_vertex_normals(points, list, black_box(&mut normals))));
        let pairs = Weight::ALL.into_iter().flat_map(|weight| ways.iter().map(move |&way| (way, weight)));
        let pairs: Vec<(Way, Weight)> = pairs.filter(|&(way, weight)| way.has(weight)).collect();
        for &(way, weight) in &pairs {
            let precision = way.precision();
            if matches!(way, Way::Mesh | Way::MeshFast) {
                let recipe = NormalRecipe { precision, ..recipe(weight) };
                let mut scratch = Scratch::new();
                candidates.push(Box::new(move || {
                    drop(black_box(compute_reusing(mesh, &recipe, Extras::NONE, &mut scratch)));
                }));
                continue;
            }
            let (mut scratch, mut normals) = (Scratch::new(), vec![[0.0; 3]; positions.len()]);
            let averaging = Averaging { weight, precision, ..Averaging::default() };
            candidates.push(Box::new(move || {
                let faults = vertex_normals(points, list, averaging, &mut scratch, &mut normals);
                drop(black_box(faults));
            }));
        }
        let seconds = fewest_seconds(candidates, rounds);
        let count = triangles.len().max(1) as f64;
        let row = |(&(way, weight), &taken): (&(Way, Weight), &f64)| CostRow {
            way,
            weight,
            ns_per_triangle: taken * 1e9 / count,
            ratio: taken / seconds[0],
        };
        Self {
            triangles: triangles.len(),
            plain_ns: seconds[0] * 1e9 / count,
            rows: pairs.iter().zip(&seconds[1..]).map(row).collect(),
        }
    }

    /// The cost of a weight one way.
    pub fn row(&self, way: Way, weight: Weight) -> Option<&CostRow> {
        self.rows.iter().find(|row| row.way == way && row.weight == weight)
    }

    /// The cost of a weight one way, as a multiple of the plain loop.
    pub fn ratio(&self, way: Way, weight: Weight) -> Option<f64> {
        self.row(way, weight).map(|row| row.ratio)
    }

    /// The lowest cost of a weight, faithful: through slices, except for fits.
    pub fn cheapest(&self, weight: Weight) -> Option<f64> {
        self.ratio(Way::Slices, weight).or_else(|| self.ratio(Way::Mesh, weight))
    }
}

/// Vertex normals by the simplest loop: one thread, single precision, area weights, no checks. A vertex whose triangles all
/// have zero area becomes NaN.
///
/// Every cost of this module, and every ratio of the benches, is relative to it, measured in the same run.
///
/// # Panics
/// If a triangle refers to a vertex that does not exist, or there are fewer normals than positions.
pub fn plain_vertex_normals(positions: &[[f32; 3]], triangles: &[[u32; 3]], normals: &mut [[f32; 3]]) {
    normals.fill([0.0; 3]);
    for corners in triangles {
        let [p, q, r] = corners.map(|vertex| positions[vertex as usize]);
        let u = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
        let v = [r[0] - p[0], r[1] - p[1], r[2] - p[2]];
        let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for &vertex in corners {
            let sum = &mut normals[vertex as usize];
            sum[0] += n[0];
            sum[1] += n[1];
            sum[2] += n[2];
        }
    }
    for n in normals {
        let scale = 1.0 / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
        *n = [n[0] * scale, n[1] * scale, n[2] * scale];
    }
}

/// Polygons as fans of triangles: for the time that they take, not for their shape.
fn fans(faces: &Faces) -> Vec<[u32; 3]> {
    let fan = |face: &[u32]| {
        let first = face[0];
        face[1..].windows(2).map(|pair| [first, pair[0], pair[1]]).collect::<Vec<_>>()
    };
    faces.iter().flat_map(fan).collect()
}

/// The mesh with every position moved and then rounded to single precision.
pub(super) fn rounded(mesh: &Mesh, moved: impl Fn(DVec3) -> DVec3) -> Mesh {
    let round = |position: DVec3| moved(position).as_vec3().to_array();
    let positions: Vec<[f32; 3]> = mesh.positions().iter().map(round).collect();
    let mesh = Mesh::new(positions, mesh.faces().clone());
    mesh.expect("the faces are those of a mesh, and places stay in range")
}
