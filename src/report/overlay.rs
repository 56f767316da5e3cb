//! Lines over a picture that show what shading is made from: edges, creases, normals.

use super::seams::{Rim, seams};
use crate::mesh::{Link, Mesh, Topology, Weld, normal_matrix};
use crate::normals::NormalField;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{LineStyle, Lines, Object, Projection, Scene, Shape};
use glam::{DMat3, DVec3};

/// What is drawn over a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Overlay {
    /// The edges of faces.
    Wire,
    /// Edges whose two sides have different normals: by more than 0.1° at either end. The sides may be of two objects.
    Creases,
    /// A line from each vertex along its normal; several where smooth groups meet.
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
/// ... and in mean edges of the mesh, so that those of a dense one do not hide it.
const NORMAL_EDGES: f64 = 1.5;
/// Normals closer than this are the same: about the step of 8-bit encodings.
const SAME: Degrees = Degrees(0.1);

/// The lines that show something of a scene's objects, in its own space, for a picture of this size. Lines behind
/// surfaces are hidden; analytic surfaces have neither edges nor vertices.
pub fn overlay(scene: &Scene, size: [u32; 2], kind: Overlay) -> Lines {
    let (colour, width) = kind.style();
    let side = f64::from(size[0].min(size[1]));
    let style = LineStyle { colour, width: width * (side / NORMAL_SIDE).max(1.0), hide: true };
    let mut lines = Lines { points: Vec::new(), segments: Vec::new(), style };
    let longest = NORMAL_LENGTH * height_at_target(scene);
    let mut rims = Vec::new();
    for object in &scene.objects {
        let Some(form) = Form::new(object) else { continue };
        match kind {
            Overlay::Wire => form.join(form.edges(), &mut lines),
            Overlay::Creases => form.join(form.creases(&mut rims), &mut lines),
            Overlay::VertexNormals => form.stand(form.vertex_normals(), longest, &mut lines),
            Overlay::FaceNormals => form.stand(form.face_normals(), longest, &mut lines),
        }
    }
    for points in seams(rims, differ) {
        let first = lines.points.len() as u32;
        lines.points.extend(points);
        lines.segments.push([first, first + 1]);
    }
    lines
}

/// Whether two unit normals are not [`SAME`].
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

/// An object's polygons and normals, whatever arrays they come in.
struct Form<'a> {
    object: &'a Object<'a>,
    source: Source<'a>,
    /// In the scene.
    points: Vec<DVec3>,
}

enum Source<'a> {
    Mesh(&'a Mesh, &'a NormalField),
    Triangles(crate::raster::Triangles<'a>),
}

impl<'a> Form<'a> {
    fn new(object: &'a Object<'a>) -> Option<Self> {
        let place = |point: DVec3| object.transform.transform_point3(point);
        let wide = |p: &[f32; 3]| DVec3::from(p.map(f64::from));
        let (source, points) = match object.shape {
            Shape::Mesh { mesh, normals } => {
                (Source::Mesh(mesh, normals), mesh.positions().iter().map(|&p| place(p)).collect())
            }
            Shape::Triangles(triangles) => (
                Source::Triangles(triangles),
                triangles.positions.iter().map(|point| place(wide(point))).collect(),
            ),
            Shape::Surface(_) => return None,
        };
        Some(Self { object, source, points })
    }

    /// The vertices of each face.
    fn faces(&self) -> Box<dyn Iterator<Item = &[u32]> + '_> {
        match &self.source {
            Source::Mesh(mesh, _) => Box::new(mesh.faces().iter()),
            Source::Triangles(triangles) => Box::new(triangles.triangles.iter().map(|face| &face[..])),
        }
    }

    fn edges(&self) -> Vec<[u32; 2]> {
        let of_face = |face: &[u32]| -> Vec<[u32; 2]> {
            let next = face.iter().cycle().skip(1);
            face.iter().zip(next).map(|(&a, &b)| [a.min(b), a.max(b)]).collect()
        };
        unique(self.faces().flat_map(of_face).collect())
    }

    /// Creases between faces of the object; adds the edges that it ends at to `rims`.
    fn creases(&self, rims: &mut Vec<Rim>) -> Vec<[u32; 2]> {
        let Source::Mesh(mesh, normals) = &self.source else { return Vec::new() };
        let topology = Topology::build(mesh, Weld::Exact);
        let corners = mesh.faces().corners();
        let normal = |corner: u32| normals.normals.get(corner as usize, corners[corner as usize]);
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
        if let Some(matrix) = normal_matrix(DMat3::from_mat4(self.object.transform)) {
            let end = |corner: u32| {
                let point = self.points[corners[corner as usize] as usize];
                Some((point, matrix.apply(*normal(corner)?)?))
            };
            let boundary = (0..corners.len() as u32).filter(|&edge| topology.link(edge) == Link::Boundary);
            rims.extend(boundary.filter_map(|edge| Some(Rim::new(end(edge)?, end(topology.next(edge))?))));
        }
        unique((0..corners.len() as u32).filter(is_crease).map(ends).collect())
    }

    /// Where lines along vertex normals stand, and which way they go.
    fn vertex_normals(&self) -> Vec<[DVec3; 2]> {
        match &self.source {
            Source::Mesh(mesh, normals) => {
                let corners = mesh.faces().corners();
                let slot = |(corner, &vertex): (usize, &u32)| {
                    normals.normals.slot(corner, vertex).map(|slot| [vertex, slot])
                };
                let slots = unique(corners.iter().enumerate().filter_map(slot).collect());
                let at = |[vertex, slot]: [u32; 2]| {
                    [self.points[vertex as usize], normals.normals.values[slot as usize]]
                };
                slots.into_iter().map(at).collect()
            }
            Source::Triangles(triangles) => {
                let normals = triangles.normals.iter().map(|n| DVec3::from(n.map(f64::from)));
                self.points.iter().zip(normals).map(|(&point, normal)| [point, normal]).collect()
            }
        }
    }

    /// Where lines along face normals stand, and which way they go.
    fn face_normals(&self) -> Vec<[DVec3; 2]> {
        let middle = |face: &[u32]| {
            let share = 1.0 / face.len() as f64;
            face.iter().map(|&vertex| self.points[vertex as usize] * share).sum::<DVec3>()
        };
        let normals: Box<dyn Iterator<Item = DVec3>> = match &self.source {
            Source::Mesh(_, normals) => Box::new(normals.face_normals.iter().copied()),
            Source::Triangles(triangles) => {
                Box::new(triangles.face_normals.iter().map(|n| DVec3::from(n.map(f64::from))))
            }
        };
        self.faces().zip(normals).map(|(face, normal)| [middle(face), normal]).collect()
    }

    /// Adds lines between the object's points.
    fn join(&self, edges: Vec<[u32; 2]>, lines: &mut Lines) {
        let first = lines.points.len() as u32;
        lines.points.extend_from_slice(&self.points);
        lines.segments.extend(edges.into_iter().map(|edge| edge.map(|point| first + point)));
    }

    /// Adds lines along normals, which are in the object's own space.
    fn stand(&self, normals: Vec<[DVec3; 2]>, longest: f64, lines: &mut Lines) {
        let Some(matrix) = normal_matrix(DMat3::from_mat4(self.object.transform)) else { return };
        let length = longest.min(NORMAL_EDGES * self.mean_edge());
        for [point, normal] in normals {
            let Some(normal) = matrix.apply(normal) else { continue };
            let first = lines.points.len() as u32;
            lines.points.extend([point, point + normal * length]);
            lines.segments.push([first, first + 1]);
        }
    }

    /// The mean length of the faces' edges.
    fn mean_edge(&self) -> f64 {
        let (mut sum, mut count) = (0.0, 0_usize);
        for face in self.faces() {
            let next = face.iter().cycle().skip(1);
            for (&a, &b) in face.iter().zip(next) {
                sum += self.points[a as usize].distance(self.points[b as usize]);
            }
            count += face.len();
        }
        if count > 0 { sum / count as f64 } else { 0.0 }
    }
}

fn unique(mut pairs: Vec<[u32; 2]>) -> Vec<[u32; 2]> {
    pairs.sort_unstable();
    pairs.dedup();
    pairs
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};
    use crate::normals::{Crease, NormalRecipe, compute};
    use crate::raster::Camera;
    use crate::shade::Material;
    use glam::DMat4;

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

    fn lines(crease: Crease, transform: DMat4, kind: Overlay) -> Lines {
        let mesh = cube();
        let normals = compute(&mesh, &NormalRecipe { crease, ..NormalRecipe::default() });
        let mut object = Object::new(Shape::Mesh { mesh: &mesh, normals: &normals }, Material::default());
        object.transform = transform;
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

    #[test]
    fn a_cube_has_twelve_edges_that_are_creases_unless_smoothed() {
        let sharp = Crease::Angle(Degrees(40.0));
        assert_eq!(lines(sharp, DMat4::IDENTITY, Overlay::Wire).segments.len(), 12);
        assert_eq!(lines(sharp, DMat4::IDENTITY, Overlay::Creases).segments.len(), 12);
        assert_eq!(lines(Crease::OFF, DMat4::IDENTITY, Overlay::Creases).segments.len(), 0);
        // Three normals at each corner, or one.
        assert_eq!(lines(sharp, DMat4::IDENTITY, Overlay::VertexNormals).segments.len(), 24);
        assert_eq!(lines(Crease::OFF, DMat4::IDENTITY, Overlay::VertexNormals).segments.len(), 8);
        assert_eq!(lines(sharp, DMat4::IDENTITY, Overlay::FaceNormals).segments.len(), 6);
    }

    #[test]
    fn normals_stand_outward_on_moved_and_mirrored_objects() {
        let moved = DMat4::from_translation(DVec3::new(5.0, 0.0, 0.0))
            * DMat4::from_scale(DVec3::new(-1.0, 2.0, 1.0));
        for kind in [Overlay::VertexNormals, Overlay::FaceNormals] {
            let lines = lines(Crease::Default, moved, kind);
            for &[from, to] in &lines.segments {
                let [from, to] = [from, to].map(|end| lines.points[end as usize] - DVec3::new(5.0, 0.0, 0.0));
                assert!(to.length() > from.length(), "{from} {to}");
            }
        }
    }

    #[test]
    fn lines_grow_with_the_picture() {
        let wire = lines(Crease::OFF, DMat4::IDENTITY, Overlay::Wire);
        assert_eq!(wire.style.width, 2.0, "960 pixels are twice the normal side");
        let normals = lines(Crease::OFF, DMat4::IDENTITY, Overlay::VertexNormals);
        let [from, to] = normals.segments[0].map(|end| normals.points[end as usize]);
        let camera = Camera::framing((DVec3::splat(-1.0), DVec3::splat(1.0)), 1.0);
        // The framing camera's height at its target, 30° from top to bottom.
        let height = 2.0 * camera.eye.distance(camera.target) * libm::tan(Radians::from(Degrees(15.0)).0);
        assert!((from.distance(to) - NORMAL_LENGTH * height).abs() < 1e-12);
    }
}
