//! The report of `crease surface` as JSON and as text. Members are described in `docs/json.md`.

use super::args::SurfaceArgs;
use super::request::Request;
use crate::cli::common::choice::Choose;
use crate::cli::common::console::Style;
use crate::cli::common::numbers::{count, count_of, face_kinds, size};
use crate::cli::common::report::{Head, MeshOutput};
use crease::io::Note;
use crease::mesh::{Link, Mesh, Topology};
use crease::surface::{Pattern, Tessellation};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

#[derive(Debug, Default, Serialize)]
pub struct SurfaceReport {
    #[serde(flatten)]
    pub head: Head,
    surface: &'static str,
    #[serde(serialize_with = "members")]
    tessellation: Tessellation,
    scale: [f64; 3],
    offset: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mesh: Option<MeshReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<MeshOutput>,
    pub notes: Vec<Note>,
    pub seconds: f64,
}

#[derive(Debug, Serialize)]
pub struct MeshReport {
    vertices: usize,
    faces: usize,
    triangles: usize,
    quads: usize,
    polygons: usize,
    open_edges: usize,
    euler: i64,
    bounds: Option<Bounds>,
}

#[derive(Debug, Serialize)]
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

impl SurfaceReport {
    pub fn new(args: &SurfaceArgs, request: &Request) -> Self {
        Self {
            head: Head::new("crease-surface/1"),
            surface: args.kind.choice(),
            tessellation: request.tessellation,
            scale: args.shape.scale.to_array(),
            offset: args.shape.offset.to_array(),
            ..Self::default()
        }
    }

    pub fn text(&self, style: Style) -> String {
        let (Some(mesh), Some(output)) = (&self.mesh, &self.output) else { return String::new() };
        let sides = match mesh.open_edges {
            0 => "closed".to_owned(),
            open => format!("open at {}", count(open, "edge")),
        };
        format!(
            "{}\n  mesh     {}, {}, {sides}, Euler number {}\n  output   {}, {}\n",
            style.title(self.surface, output.path.as_deref()),
            count_of(mesh.vertices, "vertex", "vertices"),
            face_kinds([mesh.triangles, mesh.quads, mesh.polygons]),
            mesh.euler,
            output.format,
            size(output.bytes),
        )
    }
}

fn members<S: Serializer>(tessellation: &Tessellation, serializer: S) -> Result<S::Ok, S::Error> {
    let Tessellation { pattern, segments, jitter, noise, seed, uvs } = tessellation;
    let mut map = serializer.serialize_map(None)?;
    map.serialize_entry("pattern", pattern.name())?;
    match pattern {
        Pattern::Icosphere(level) => map.serialize_entry("level", level)?,
        _ => map.serialize_entry("segments", segments)?,
    }
    if let Pattern::Stretched(ratio) | Pattern::Slivers(ratio) = pattern {
        map.serialize_entry("ratio", ratio)?;
    }
    map.serialize_entry("jitter", jitter)?;
    map.serialize_entry("noise", noise)?;
    map.serialize_entry("seed", seed)?;
    map.serialize_entry("uv", uvs)?;
    map.end()
}

impl MeshReport {
    pub fn new(mesh: &Mesh) -> Self {
        let topology = Topology::by_index(mesh.faces(), mesh.vertex_count());
        let half_edges = mesh.faces().corner_count();
        let is_open = |half_edge: &u32| topology.link(*half_edge) == Link::Boundary;
        let open_edges = (0..half_edges as u32).filter(is_open).count();
        let edges = (half_edges + open_edges) / 2;
        let of_arity =
            |wanted: &dyn Fn(usize) -> bool| mesh.faces().iter().filter(|face| wanted(face.len())).count();
        Self {
            vertices: mesh.vertex_count(),
            faces: mesh.face_count(),
            triangles: of_arity(&|arity| arity == 3),
            quads: of_arity(&|arity| arity == 4),
            polygons: of_arity(&|arity| arity > 4),
            open_edges,
            euler: mesh.vertex_count() as i64 - edges as i64 + mesh.face_count() as i64,
            bounds: mesh.bounds().map(|(low, high)| Bounds { low: low.to_array(), high: high.to_array() }),
        }
    }
}
