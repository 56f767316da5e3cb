//! Lines over a picture: edges of faces, creases, seams between objects, normals.

use crate::mesh::{Link, Mesh, Topology, Weld, normal_matrix};
use crate::normals::NormalField;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{LinePath, LineStyle, Lines, Object, Projection, Scene, Shape};
use glam::{DMat3, DVec3};
use rustc_hash::FxHashMap;

/// What is drawn over a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Overlay {
    /// The edges of faces.
    Wire,
    /// Edges whose two sides have different normals: by more than 0.1° at either end. The sides may be of two objects.
    Creases,
    /// A line from each vertex along its normal; several where smooth groups meet. Of vertices closer than a fortieth of the
    /// picture's height only one has lines.
    VertexNormals,
    /// A line from the middle of each face along its normal.
    FaceNormals,
}

impl Overlay {
    /// Colour, and width as a share of [`NORMAL_SIDE`] pixels.
    fn style(self) -> (LinearRgb, f64) {
        match self {
            Overlay::Wire => (LinearRgb::new(0.004, 0.006, 0.012), 1.0),
            Overlay::Creases => (LinearRgb::new(1.0, 0.12, 0.01), 2.2),
            Overlay::VertexNormals => (LinearRgb::new(0.03, 0.45, 1.0), 1.4),
            Overlay::FaceNormals => (LinearRgb::new(0.75, 0.85, 0.02), 1.4),
        }
    }
}

/// The shorter side of a picture, in pixels, in which lines are as wide as [`Overlay::style`] says; in larger ones they
/// are wider.
const NORMAL_SIDE: f64 = 480.0;
/// Length of the lines along normals, as a share of the picture's height where the camera's target is ...
const NORMAL_LENGTH: f64 = 0.06;
/// ... and in distances between vertices with lines, so that those of a dense mesh do not hide it.
const NORMAL_EDGES: f64 = 1.5;
/// The least distance between vertices with lines, as a share of the picture's height where the camera's target is.
const NORMAL_SPACING: f64 = 0.025;
/// Normals closer than this are the same: about the step of 8-bit encodings.
const SAME: Degrees = Degrees(0.1);

/// The lines that show something of a scene's objects, for a picture of this size. Lines behind surfaces are hidden;
/// analytic surfaces have neither edges nor vertices.
pub fn overlay(scene: &Scene, size: [u32; 2], kind: Overlay) -> Vec<Lines> {
    let (colour, width) = kind.style();
    let side = f64::from(size[0].min(size[1]));
    let style = LineStyle { colour, width: width * (side / NORMAL_SIDE).max(1.0), hide: true };
    let height = height_at_target(scene);
    let longest = NORMAL_LENGTH * height;
    let length = |edge: f64| longest.min(NORMAL_EDGES * edge);
    let mut rims = Vec::new();
    let objects = scene.objects.iter().enumerate().filter(|(_, it)| has_directions(it));
    let mut paths: Vec<LinePath> = objects
        .map(|(object, it)| match kind {
            Overlay::Wire => LinePath::Edges { object, edges: it.shape.edges() },
            Overlay::Creases => {
                let rims = (scene.objects.len() > 1).then_some(&mut rims);
                LinePath::Edges { object, edges: creases(it, rims) }
            }
            Overlay::VertexNormals => {
                let (edge, spacing) = (mean_edge(it), NORMAL_SPACING * height);
                let mut normals = it.shape.vertex_normals();
                if edge < spacing {
                    keep_spaced(it, spacing, &mut normals);
                }
                LinePath::VertexNormals { object, normals, length: length(edge.max(spacing)) }
            }
            Overlay::FaceNormals => LinePath::FaceNormals { object, length: length(mean_edge(it)) },
        })
        .collect();
    let seams = seams(rims, differ);
    if !seams.is_empty() {
        let segments = (0..seams.len() as u32).map(|seam| [2 * seam, 2 * seam + 1]).collect();
        paths.push(LinePath::Points { points: seams.into_iter().flatten().collect(), segments });
    }
    paths.into_iter().map(|path| Lines { path, style }).collect()
}

/// Whether an object has vertices, and a transform that leaves normals a direction.
fn has_directions(object: &Object) -> bool {
    !matches!(object.shape, Shape::Surface(_)) && normal_matrix(DMat3::from_mat4(object.transform)).is_some()
}

fn differ(a: DVec3, b: DVec3) -> bool {
    libm::atan2(a.cross(b).length(), a.dot(b)) > Radians::from(SAME).0
}

/// The height of the picture in units of the scene, where the camera's target is.
fn height_at_target(scene: &Scene) -> f64 {
    match scene.camera.projection {
        Projection::Orthographic(height) => height,
        Projection::Perspective(Radians(angle)) => {
            2.0 * scene.camera.eye.distance(scene.camera.target) * libm::tan(0.5 * angle)
        }
    }
}

/// Creases between faces of an object; adds the edges that it ends at to `rims`, if others may end there.
fn creases(object: &Object, rims: Option<&mut Vec<Rim>>) -> Vec<[u32; 2]> {
    let Shape::Mesh { mesh, normals } = object.shape else { return Vec::new() };
    let topology = Topology::build(mesh, Weld::Exact);
    let corners = mesh.faces().corners();
    let normal = |corner: u32| normals.normals.get(corner as usize, corners[corner as usize]);
    if let Some(rims) = rims {
        rims.extend(boundary(object, mesh, normals, &topology));
    }
    let differ = |a: u32, b: u32| match (normal(a), normal(b)) {
        (Some(&a), Some(&b)) => differ(a, b),
        _ => false,
    };
    let is_crease = |&edge: &u32| {
        let next = topology.next(edge);
        match topology.link(edge) {
            Link::Twin(other) | Link::Welded(other) if other > edge => {
                differ(edge, topology.next(other)) || differ(next, other)
            }
            Link::Inconsistent(other) if other > edge => {
                differ(edge, other) || differ(next, topology.next(other))
            }
            Link::NonManifold | Link::Ambiguous => true,
            _ => false,
        }
    };
    let ends = |edge: u32| {
        let (a, b) = topology.ends(corners, edge);
        [a.min(b), a.max(b)]
    };
    let mut creases: Vec<_> = (0..corners.len() as u32).filter(is_crease).map(ends).collect();
    creases.sort_unstable();
    creases.dedup();
    creases
}

/// The edges at which an object ends, in the scene.
fn boundary(object: &Object, mesh: &Mesh, normals: &NormalField, topology: &Topology) -> Vec<Rim> {
    let corners = mesh.faces().corners();
    let Some(matrix) = normal_matrix(DMat3::from_mat4(object.transform)) else { return Vec::new() };
    let end = |corner: u32| {
        let vertex = corners[corner as usize];
        let normal = *normals.normals.get(corner as usize, vertex)?;
        Some((object.transform.transform_point3(object.shape.point(vertex)), matrix.apply(normal)?))
    };
    let edges = (0..corners.len() as u32).filter(|&edge| topology.link(edge) == Link::Boundary);
    edges.filter_map(|edge| Some(Rim::new(end(edge)?, end(topology.next(edge))?))).collect()
}

/// Keeps the normals of one vertex in each cell of a grid of this spacing: the first one.
fn keep_spaced(object: &Object, spacing: f64, normals: &mut Vec<[u32; 2]>) {
    let mut cells = FxHashMap::default();
    normals.retain(|&[vertex, _]| {
        let at = object.transform.transform_point3(object.shape.point(vertex)) / spacing;
        *cells.entry(at.floor().to_array().map(|x| x as i64)).or_insert(vertex) == vertex
    });
}

/// The mean length of the edges of an object's faces, in the scene.
fn mean_edge(object: &Object) -> f64 {
    let at = |vertex: u32| object.transform.transform_point3(object.shape.point(vertex));
    let (mut sum, mut count) = (0.0, 0_usize);
    for face in object.shape.faces() {
        let next = face.iter().cycle().skip(1);
        sum += face.iter().zip(next).map(|(&a, &b)| at(a).distance(at(b))).sum::<f64>();
        count += face.len();
    }
    if count > 0 { sum / count as f64 } else { 0.0 }
}

/// A boundary edge of an object, in the scene: its ends, and the unit normals there.
#[derive(Clone, Copy, Debug)]
struct Rim {
    /// Its ends, the one with the lower coordinates first.
    points: [DVec3; 2],
    /// The normals of its face at the ends.
    normals: [DVec3; 2],
}

impl Rim {
    /// An edge between two points with their normals, in any order.
    fn new(a: (DVec3, DVec3), b: (DVec3, DVec3)) -> Self {
        let (a, b) = if key(a.0) <= key(b.0) { (a, b) } else { (b, a) };
        Self { points: [a.0, b.0], normals: [a.1, b.1] }
    }

    fn key(&self) -> [[u64; 3]; 2] {
        self.points.map(key)
    }
}

/// A point as bits: equal points, and only those, have the same.
fn key(point: DVec3) -> [u64; 3] {
    // −0 and 0 are equal.
    point.to_array().map(|x| (x + 0.0).to_bits())
}

/// The edges with several rims, two of which have normals at either end that `differ`, once each.
fn seams(mut rims: Vec<Rim>, differ: impl Fn(DVec3, DVec3) -> bool) -> Vec<[DVec3; 2]> {
    rims.sort_by_cached_key(Rim::key);
    let at_one_place = rims.chunk_by(|a, b| a.key() == b.key());
    let is_seam = |rims: &&[Rim]| {
        // If none differs from the first, no two differ by more than twice the threshold.
        let [first, others @ ..] = *rims else { return false };
        others.iter().any(|rim| (0..2).any(|end| differ(first.normals[end], rim.normals[end])))
    };
    at_one_place.filter(is_seam).map(|rims| rims[0].points).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};
    use crate::normals::{Crease, NormalRecipe, compute};
    use crate::raster::Camera;
    use crate::shade::Material;

    /// A cube of quads, its corners at ±1.
    fn cube() -> Mesh {
        let sign = |bit: usize, i: usize| if i >> bit & 1 == 1 { 1.0 } else { -1.0 };
        let positions = (0..8).map(|i| DVec3::new(sign(0, i), sign(1, i), sign(2, i))).collect();
        let mut faces = Faces::new();
        for face in [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]] {
            faces.push(&face);
        }
        MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap()
    }

    fn lines(crease: Crease, kind: Overlay) -> Vec<Lines> {
        let mesh = cube();
        let normals = compute(&mesh, &NormalRecipe { crease, ..NormalRecipe::default() });
        let object = Object::new(Shape::Mesh { mesh: &mesh, normals: &normals }, Material::default());
        let camera = Camera::framing((DVec3::splat(-1.0), DVec3::splat(1.0)), 1.0);
        let scene = Scene {
            objects: vec![object],
            lines: Vec::new(),
            lights: Vec::new(),
            camera,
            background: LinearRgb::BLACK,
        };
        overlay(&scene, [960, 1200], kind)
    }

    /// How many lines there are in all sets but those of faces, which are as many as faces.
    fn count(crease: Crease, kind: Overlay) -> usize {
        let of_path = |lines: &Lines| match &lines.path {
            LinePath::Points { segments, .. } => segments.len(),
            LinePath::Edges { edges, .. } => edges.len(),
            LinePath::VertexNormals { normals, .. } => normals.len(),
            LinePath::FaceNormals { .. } => 0,
        };
        lines(crease, kind).iter().map(of_path).sum()
    }

    #[test]
    fn a_cube_has_twelve_edges_that_are_creases_unless_smoothed() {
        let sharp = Crease::Angle(Degrees(40.0));
        assert_eq!(count(sharp, Overlay::Wire), 12);
        assert_eq!((count(sharp, Overlay::Creases), count(Crease::OFF, Overlay::Creases)), (12, 0));
        // Three normals at each corner, or one.
        assert_eq!(
            (count(sharp, Overlay::VertexNormals), count(Crease::OFF, Overlay::VertexNormals)),
            (24, 8)
        );
    }

    #[test]
    fn lines_grow_with_the_picture() {
        let wire = lines(Crease::OFF, Overlay::Wire);
        assert_eq!(wire[0].style.width, 2.0, "960 pixels are twice the normal side");
        let camera = Camera::framing((DVec3::splat(-1.0), DVec3::splat(1.0)), 1.0);
        // The framing camera's height at its target, 30° from top to bottom.
        let height = 2.0 * camera.eye.distance(camera.target) * libm::tan(Radians::from(Degrees(15.0)).0);
        for kind in [Overlay::VertexNormals, Overlay::FaceNormals] {
            let (LinePath::VertexNormals { length, .. } | LinePath::FaceNormals { length, .. }) =
                lines(Crease::OFF, kind)[0].path
            else {
                panic!("lines along normals")
            };
            assert!((length - NORMAL_LENGTH * height).abs() < 1e-12);
        }
    }

    /// A grid of vertices at ±0.5: in a picture of height 1, cells hold about 16 of them.
    #[test]
    fn dense_vertices_share_a_normal() {
        const SIDE: u32 = 160;
        let at = |v: u32| DVec3::new(f64::from(v % SIDE), f64::from(v / SIDE), 0.0) / f64::from(SIDE) - 0.5;
        let quad = |i: u32| [0, 1, SIDE + 1, SIDE].map(|step| i / (SIDE - 1) * SIDE + i % (SIDE - 1) + step);
        let mut faces = Faces::new();
        (0..(SIDE - 1) * (SIDE - 1)).for_each(|i| faces.push(&quad(i)));
        let positions: Vec<DVec3> = (0..SIDE * SIDE).map(at).collect();
        let mesh = MeshBuilder { positions: positions.clone().into(), faces, ..MeshBuilder::default() };
        let mesh = mesh.build().unwrap();
        let normals = compute(&mesh, &NormalRecipe::default());
        let object = Object::new(Shape::Mesh { mesh: &mesh, normals: &normals }, Material::default());
        let mut kept = object.shape.vertex_normals();
        assert_eq!(kept.len(), positions.len());
        keep_spaced(&object, NORMAL_SPACING, &mut kept);
        assert_eq!(kept.len(), 40 * 40);
        let nearest = |&p: &DVec3| {
            let distances = kept.iter().map(|&[vertex, _]| p.distance_squared(positions[vertex as usize]));
            distances.fold(f64::INFINITY, f64::min)
        };
        // A vertex and the one that is kept are in one cell.
        let farthest = positions.iter().step_by(97).map(nearest).fold(0.0, f64::max);
        assert!(farthest <= 2.0 * NORMAL_SPACING * NORMAL_SPACING, "{farthest}");
        // Twice the spacing has a quarter of the cells, and no normal of a vertex is lost that has two.
        let mut pairs: Vec<[u32; 2]> = kept.iter().flat_map(|&[v, n]| [[v, n], [v, n + 1]]).collect();
        keep_spaced(&object, 2.0 * NORMAL_SPACING, &mut pairs);
        assert_eq!(pairs.len(), 2 * 20 * 20);
    }

    #[test]
    fn a_seam_is_where_rims_meet_whose_normals_differ() {
        let (a, b, c) = (DVec3::ZERO, DVec3::X, DVec3::Y);
        let up = Rim::new((a, DVec3::Z), (b, DVec3::Z));
        // The same place the other way round, with zero's other sign.
        let next_to = |normal| Rim::new((b, normal), (-a, DVec3::Z));
        let elsewhere = Rim::new((a, DVec3::X), (c, DVec3::X));
        let unlike = |a: DVec3, b: DVec3| a != b;
        assert_eq!(seams(vec![up, elsewhere, next_to(DVec3::Z)], unlike), [] as [[DVec3; 2]; 0]);
        assert_eq!(seams(vec![up, elsewhere, next_to(DVec3::X)], unlike), [[a, b]]);
        assert_eq!(seams(vec![next_to(DVec3::X)], unlike), [] as [[DVec3; 2]; 0]);
    }
}
