//! Lines: wireframes, and lines drawn over the picture or hidden by it.

use crate::mesh::{NormalMatrix, normal_matrix};
use crate::num::parallel;
use crate::raster::coverage::setup::TILE;
use crate::raster::coverage::tile_bins::{TileBox, sort, tiles};
use crate::raster::coverage::triangles::DrawnObject;
use crate::raster::error::{RenderError, Result};
use crate::raster::frame::job::Job;
use crate::raster::scene::{LinePath, Object, Scene, Shape};
use crate::raster::settings::{Cull, LineStyle, Shading};
use crate::raster::view::clip::clip_line;
use crate::raster::view::project::Points;
use crate::raster::view::screen_transform::ObjectMap;
use glam::{DMat3, DMat4, DVec3, Vec3};
use std::borrow::Cow;

/// The ends of many lines, which are in one space.
pub(crate) struct LineEnds<'a> {
    path: Cow<'a, LinePath>,
    points: Points<'a>,
    /// From the points' space to the scene's.
    transform: DMat4,
    /// Of lines along normals, the shape and what brings its normals to the scene.
    normals: Option<(&'a Shape<'a>, NormalMatrix)>,
}

impl<'a> LineEnds<'a> {
    /// The edges of an object's faces that are not culled.
    pub(crate) fn edges(object: &'a Object<'a>, drawn: &DrawnObject<'a>, cull: Cull) -> Self {
        let edges = match cull {
            Cull::None => object.shape.edges(),
            Cull::Back | Cull::Front => {
                let is_kept = drawn.kept_faces(object.shape.face_count(), cull);
                object.shape.edges_of(|face| is_kept[face])
            }
        };
        let path = Cow::Owned(LinePath::Edges { object: drawn.object, edges });
        Self { path, points: drawn.points, transform: object.transform, normals: None }
    }

    /// The ends of the scene's `number`-th set of lines, checked.
    pub(crate) fn new(scene: &'a Scene<'a>, number: usize, path: &'a LinePath) -> Result<Self> {
        let object = match path {
            LinePath::Points { points, segments } => {
                check_finite(points)?;
                check_numbers(segments.as_flattened().iter().copied(), 2, points.len())?;
                let (path, points) = (Cow::Borrowed(path), Points::F64(points));
                return Ok(Self { path, points, transform: DMat4::IDENTITY, normals: None });
            }
            LinePath::Edges { object, .. }
            | LinePath::VertexNormals { object, .. }
            | LinePath::FaceNormals { object, .. } => *object,
        };
        let owner = scene.objects.get(object);
        let found = owner.and_then(|owner| Some((owner, owner.shape.points()?)));
        let (owner, points) = found.ok_or_else(|| {
            let lines = format!("lines {number} run along object {object}, which has no vertices");
            RenderError::Invalid(lines)
        })?;
        match path {
            LinePath::Edges { edges, .. } => {
                check_numbers(edges.as_flattened().iter().copied(), 2, points.len())?;
            }
            LinePath::VertexNormals { normals, .. } => {
                check_numbers(normals.iter().map(|&[vertex, _]| vertex), 1, points.len())?;
                check_numbers(normals.iter().map(|&[_, normal]| normal), 1, owner.shape.normals().len())?;
            }
            LinePath::Points { .. } | LinePath::FaceNormals { .. } => {}
        }
        let mut normals = None;
        if let LinePath::VertexNormals { length, .. } | LinePath::FaceNormals { length, .. } = path {
            let matrix = normal_matrix(DMat3::from_mat4(owner.transform));
            normals = Some((&owner.shape, matrix.ok_or_else(|| RenderError::singular(object))?));
            if !length.is_finite() {
                return Err(self::number("the length of lines", length.to_string()));
            }
        }
        Ok(Self { path: Cow::Borrowed(path), points, transform: owner.transform, normals })
    }

    pub(crate) fn len(&self) -> u32 {
        let count = match &*self.path {
            LinePath::Points { segments: pairs, .. }
            | LinePath::Edges { edges: pairs, .. }
            | LinePath::VertexNormals { normals: pairs, .. } => pairs.len(),
            LinePath::FaceNormals { .. } => {
                self.normals.as_ref().map_or(0, |(shape, _)| shape.face_normals().len())
            }
        };
        count as u32
    }

    /// From the space of what [`get`](Self::get) gives to the scene's, and a point of that space near the lines.
    pub(crate) fn space(&self) -> (DMat4, DVec3) {
        let first = self.points.iter().next().unwrap_or_default();
        match self.normals {
            None => (self.transform, first),
            Some(_) => (DMat4::IDENTITY, self.transform.transform_point3(first)),
        }
    }

    /// Where a line begins and ends; `None` for a normal without direction.
    pub(crate) fn get(&self, line: u32) -> Option<[DVec3; 2]> {
        let place = |vertex: u32| self.transform.transform_point3(self.points.at(vertex));
        let along = |from: DVec3, normal: DVec3, length: f64| {
            let (_, matrix) = self.normals.as_ref()?;
            Some([from, from + matrix.apply(normal)? * length])
        };
        match &*self.path {
            LinePath::Points { segments: pairs, .. } | LinePath::Edges { edges: pairs, .. } => {
                Some(pairs[line as usize].map(|point| self.points.at(point)))
            }
            LinePath::VertexNormals { normals, length, .. } => {
                let [vertex, normal] = normals[line as usize];
                along(place(vertex), self.normals.as_ref()?.0.normals().at(normal), *length)
            }
            LinePath::FaceNormals { length, .. } => {
                let (shape, _) = self.normals.as_ref()?;
                let face = shape.face(line);
                let share = 1.0 / face.len() as f64;
                let middle = face.iter().map(|&vertex| place(vertex) * share).sum::<DVec3>();
                along(middle, shape.face_normals().at(line), *length)
            }
        }
    }
}

fn check_finite(points: &[DVec3]) -> Result<()> {
    let wrong = points.iter().find(|point| !point.is_finite());
    wrong.map_or(Ok(()), |point| Err(number("the end of a line", point.to_string())))
}

fn number(what: &'static str, found: String) -> RenderError {
    RenderError::Number { what, found, expected: "finite" }
}

/// Holds numbers, so many for each line, to how many there are of what they name.
fn check_numbers(numbers: impl Iterator<Item = u32>, each: usize, count: usize) -> Result<()> {
    let wrong = numbers.enumerate().find(|&(_, index)| index as usize >= count);
    wrong.map_or(Ok(()), |(at, index)| Err(RenderError::index("line", at / each, index, count)))
}

pub(crate) struct LineJob<'a> {
    sets: Vec<LineSet<'a>>,
    /// Where each tile's lines begin, with the total at the end; and the lines, as a set and a number in it.
    parts: Vec<(usize, Vec<u32>, Vec<u32>)>,
}

pub(crate) struct LineSet<'a> {
    ends: LineEnds<'a>,
    /// From the space of the ends to view space.
    map: ObjectMap,
    pub(crate) colour: Vec3,
    pub(crate) radius: f64,
    pub(crate) hide: bool,
    pub(crate) is_wireframe: bool,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    /// Its ends, in pixels.
    pub(crate) ends: [[f64; 2]; 2],
    /// Depth there, which is linear in between.
    pub(crate) depth: [f64; 2],
}

impl<'a> LineJob<'a> {
    pub(crate) fn new(job: &Job<'a>, scene: &'a Scene<'a>) -> Result<Self> {
        let mut sets = Vec::new();
        if job.settings.shading == Shading::Wireframe {
            check_style(&job.settings.wire)?;
            let cull = job.settings.cull;
            let edges =
                job.drawn.iter().map(|drawn| LineEnds::edges(&scene.objects[drawn.object], drawn, cull));
            sets.extend(edges.map(|ends| LineSet::new(job, ends, &job.settings.wire, true)));
        }
        for (number, lines) in scene.lines.iter().enumerate() {
            check_style(&lines.style)?;
            sets.push(LineSet::new(job, LineEnds::new(scene, number, &lines.path)?, &lines.style, false));
        }
        let parts = parallel::map(sets.len(), |number| {
            let set = &sets[number];
            let found: Vec<_> = (0..set.ends.len())
                .filter_map(|line| Some((line, set.touched(job, set.segment(job, line)?)?)))
                .collect();
            let (starts, lines) = sort(&found, tiles(job.view.size));
            (number, starts, lines)
        });
        Ok(Self { parts, sets })
    }

    pub(crate) fn is_empty(&self, tile: usize) -> bool {
        self.parts.iter().all(|(_, starts, _)| starts[tile] == starts[tile + 1])
    }

    pub(crate) fn tile(&self, job: &Job, tile: usize) -> impl Iterator<Item = (&LineSet<'a>, Segment)> {
        self.parts.iter().flat_map(move |(number, starts, lines)| {
            let set = &self.sets[*number];
            let range = starts[tile] as usize..starts[tile + 1] as usize;
            lines[range].iter().filter_map(move |&line| Some((set, set.segment(job, line)?)))
        })
    }
}

fn check_style(style: &LineStyle) -> Result<()> {
    let number = |what, found: String, expected| Err(RenderError::Number { what, found, expected });
    if !(style.width.is_finite() && style.width > 0.0) {
        return number("the width of lines", style.width.to_string(), "above 0 and finite");
    }
    if !style.colour.is_finite() {
        return number("the colour of lines", format!("{:?}", style.colour.to_array()), "finite");
    }
    Ok(())
}

impl<'a> LineSet<'a> {
    fn new(job: &Job, ends: LineEnds<'a>, style: &LineStyle, is_wireframe: bool) -> Self {
        let (transform, first) = ends.space();
        let map = ObjectMap::about(&job.view, transform, first);
        let colour = crate::raster::coverage::records::single(style.colour);
        Self { ends, map, colour, radius: 0.5 * style.width, hide: style.hide, is_wireframe }
    }

    /// A line on the picture, clipped to the near plane and the guard band; `None` if nothing is left.
    fn segment(&self, job: &Job, line: u32) -> Option<Segment> {
        let ends = clip_line(&job.view, self.ends.get(line)?.map(|end| self.map.view(end)))?;
        Some(Segment {
            ends: ends.map(|end| job.view.on_picture(end)),
            depth: ends.map(|end| job.view.depth(end.z)),
        })
    }

    fn touched(&self, job: &Job, segment: Segment) -> Option<TileBox> {
        let [a, b] = segment.ends;
        let tiles = |axis: usize| {
            let last = f64::from(job.view.size[axis]) - 1.0;
            let first = (a[axis].min(b[axis]) - self.radius - 1.0).max(0.0);
            let end = (a[axis].max(b[axis]) + self.radius).min(last);
            (first <= end).then_some([first, end].map(|pixel| (pixel as usize / TILE) as u8))
        };
        let ([x0, x1], [y0, y1]) = (tiles(0)?, tiles(1)?);
        Some([x0, y0, x1, y1])
    }
}

impl Segment {
    /// The place of the line nearest to a point of the picture and the depth there, if it is within the radius.
    pub(crate) fn nearest(&self, [x, y]: [f64; 2], radius: f64) -> Option<([f64; 2], f64)> {
        let [a, b] = self.ends;
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let squared = dx * dx + dy * dy;
        let t = if squared > 0.0 { ((x - a[0]) * dx + (y - a[1]) * dy) / squared } else { 0.0 };
        let t = t.clamp(0.0, 1.0);
        let place = [a[0] + dx * t, a[1] + dy * t];
        let (ex, ey) = (place[0] - x, place[1] - y);
        let depth = self.depth[0] + (self.depth[1] - self.depth[0]) * t;
        (ex * ex + ey * ey <= radius * radius).then_some((place, depth))
    }

    /// The pixels of a row that the line may touch, by the height of its samples and their offset in a pixel.
    pub(crate) fn columns(&self, y: f64, radius: f64, offset: f64) -> Option<[f64; 2]> {
        let [a, b] = self.ends;
        if y < a[1].min(b[1]) - radius || y > a[1].max(b[1]) + radius {
            return None;
        }
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (low, high) = (a[0].min(b[0]) - radius, a[0].max(b[0]) + radius);
        // Between the lines on its two sides, or around an end.
        let (middle, half) = (a[0] + (y - a[1]) * (dx / dy), radius * (dx / dy).abs() + 2.0 * radius);
        let [low, high] =
            if middle.is_finite() { [low.max(middle - half), high.min(middle + half)] } else { [low, high] };
        (low <= high).then_some([low - offset, high - offset])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Mesh, MeshBuilder};
    use crate::normals::{Crease, NormalField, NormalRecipe, compute};
    use crate::num::LinearRgb;
    use crate::num::test_numbers::Numbers;
    use crate::raster::frame::job::Job;
    use crate::raster::settings::RenderSettings;
    use crate::raster::view::camera::{Camera, Projection};
    use crate::raster::view::screen_transform::View;
    use crate::shade::Material;
    use crate::surface::Sphere;

    /// The columns that are checked contain every pixel that the line touches.
    #[test]
    fn no_touched_pixel_is_left_out() {
        let mut numbers = Numbers::new(9);
        let mut touched = 0;
        for round in 0..2000 {
            let mut place = || [0; 2].map(|_| numbers.unit() * 80.0 - 10.0);
            let (a, mut b) = (place(), place());
            match round % 8 {
                0 => b[1] = a[1],
                1 => b[0] = a[0],
                2 => b = a,
                _ => {}
            }
            let segment = Segment { ends: [a, b], depth: [1.0, 0.5] };
            let radius = [0.3, 0.5, 1.0, 4.0][round % 4];
            for row in 0..64 {
                let y = f64::from(row) + 0.5;
                let columns = segment.columns(y, radius, 0.5);
                for column in 0..64 {
                    let Some((nearest, depth)) = segment.nearest([f64::from(column) + 0.5, y], radius) else {
                        continue;
                    };
                    touched += 1;
                    let [low, high] = columns.expect("a row that is touched");
                    assert!(
                        f64::from(column) >= low && f64::from(column) <= high,
                        "{segment:?} {column} {row}"
                    );
                    // Within the ends, but for the rounding of a place of at most 80 pixels.
                    let (left, right) = (a[0].min(b[0]) - 1e-13, a[0].max(b[0]) + 1e-13);
                    assert!((0.5..=1.0).contains(&depth) && (left..=right).contains(&nearest[0]));
                }
            }
        }
        assert!(touched > 50_000, "{touched}");
    }

    #[test]
    fn lines_are_cut_where_they_leave() {
        let camera = crate::raster::view::camera::Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: crate::raster::view::camera::Projection::Perspective(crate::num::Radians(1.0)),
            near: 0.5,
        };
        let view = View::new(&camera, [100, 100]).unwrap();
        let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let cut = |a: DVec3, b: DVec3| clip_line(&view, [map.view(a), map.view(b)]);
        let [a, b] = cut(DVec3::new(0.0, 0.0, 3.0), DVec3::new(0.0, 0.0, -3.0)).unwrap();
        assert!((a.z - 0.5).abs() < 1e-15 && b.z == 3.0);
        let [a, b] = cut(DVec3::new(-1e30, 0.0, -1.0), DVec3::new(1e30, 0.0, -1.0)).unwrap();
        let guard = f64::from(crate::raster::view::fixed_point::GUARD);
        assert!((a.x + guard).abs() < 1e-3 * guard && (b.x - guard).abs() < 1e-3 * guard, "{a:?} {b:?}");
        assert_eq!(cut(DVec3::new(-1.0, 0.0, 1.0), DVec3::new(2.0, 0.0, 1.0)), None);
        assert_eq!(cut(DVec3::new(-1e6, 0.0, -1.0), DVec3::new(-2e6, 1.0, -1.0)), None);
    }

    /// An octahedron, its corners at ±1.
    fn octahedron() -> (Mesh, NormalField) {
        let positions = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]).collect();
        let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
        let faces = Faces::triangles(faces.into_iter().flatten().collect());
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
        let normals = compute(&mesh, &NormalRecipe { crease: Crease::OFF, ..NormalRecipe::default() });
        (mesh, normals)
    }

    fn scene<'a>(shape: Shape<'a>, transform: DMat4) -> Scene<'a> {
        let object = Object { transform, ..Object::new(shape, Material::default()) };
        let camera = Camera::framing((DVec3::splat(-1.0), DVec3::splat(1.0)), 1.0);
        let background = LinearRgb::BLACK;
        Scene { objects: vec![object], lines: Vec::new(), lights: Vec::new(), camera, background }
    }

    #[test]
    fn normals_stand_outward_on_moved_and_mirrored_objects() {
        let middle = DVec3::new(5.0, 0.0, 0.0);
        let moved = DMat4::from_translation(middle) * DMat4::from_scale(DVec3::new(-1.0, 2.0, 1.0));
        let (mesh, normals) = octahedron();
        let scene = scene(Shape::Mesh { mesh: &mesh, normals: &normals }, moved);
        let of_vertices = scene.objects[0].shape.vertex_normals();
        assert_eq!(of_vertices.len(), 6);
        let paths = [
            (LinePath::VertexNormals { object: 0, normals: of_vertices, length: 0.25 }, 6),
            (LinePath::FaceNormals { object: 0, length: 0.25 }, 8),
        ];
        for (path, count) in &paths {
            let ends = LineEnds::new(&scene, 0, path).unwrap();
            assert_eq!(ends.len(), *count);
            assert_eq!(ends.space().0, DMat4::IDENTITY);
            for [from, to] in (0..*count).map(|line| ends.get(line).unwrap()) {
                assert!(to.distance(middle) > from.distance(middle), "{from} {to}");
                assert!((to.distance(from) - 0.25).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn an_edge_is_there_once() {
        let (mesh, normals) = octahedron();
        let scene = scene(Shape::Mesh { mesh: &mesh, normals: &normals }, DMat4::IDENTITY);
        let settings = RenderSettings::default();
        let job = Job::new(&scene, &settings).unwrap();
        let ends = LineEnds::edges(&scene.objects[0], &job.drawn[0], Cull::None);
        assert_eq!(ends.len(), 12);
        let long = (0..12).map(|line| ends.get(line).unwrap()).filter(|[a, b]| a.distance_squared(*b) != 2.0);
        assert_eq!(long.count(), 0);
    }

    /// Faces that are not drawn hide the edges that only they have, on either side of a mirror and of the eye, at
    /// any size. All faces of the octahedron look away from its middle.
    #[test]
    fn faces_that_are_left_out_have_no_edges() {
        let (mesh, normals) = octahedron();
        for (across, size, inside) in
            [(1.0, 1.0, 0.0), (-1.0, 1.0, 0.0), (1.0, 1e100, 0.0), (-1.0, 1e-100, 0.0), (1.0, 1.0, 0.9)]
        {
            let transform = DMat4::from_scale(DVec3::new(across, 1.0, 1.0) * size);
            let mut scene = scene(Shape::Mesh { mesh: &mesh, normals: &normals }, transform);
            let corner = DVec3::splat(size);
            let framing = Camera::framing((-corner, corner), 1.0);
            let eye = framing.eye.lerp(DVec3::new(0.1, 0.2, 0.3) * size, inside);
            for projection in [framing.projection, Projection::Orthographic(3.0 * size)] {
                scene.camera = Camera { eye, projection, ..framing };
                let place = |vertex: u32| transform.transform_point3(mesh.positions().at(vertex)) / size;
                let is_front = |face: &[u32]| {
                    let middle = face.iter().map(|&vertex| place(vertex)).sum::<DVec3>();
                    let towards = match projection {
                        Projection::Perspective(_) => eye / size - place(face[0]),
                        Projection::Orthographic(_) => eye / size,
                    };
                    middle.dot(towards) > 0.0
                };
                for (cull, kept) in [(Cull::Back, true), (Cull::Front, false)] {
                    let settings = RenderSettings { cull, ..RenderSettings::default() };
                    let job = Job::new(&scene, &settings).unwrap();
                    let ends = LineEnds::edges(&scene.objects[0], &job.drawn[0], cull);
                    let mut expected: Vec<[u32; 2]> = (0..8)
                        .map(|face| mesh.faces().face(face))
                        .filter(|face| is_front(face) == kept)
                        .flat_map(|face| [[0, 1], [1, 2], [0, 2]].map(|ends| ends.map(|end| face[end])))
                        .map(|[a, b]| [a.min(b), a.max(b)])
                        .collect();
                    expected.sort_unstable();
                    expected.dedup();
                    let LinePath::Edges { edges: found, .. } = &*ends.path else { panic!("edges") };
                    assert_eq!(*found, expected, "{across} {size} {inside} {projection:?} {cull:?}");
                }
            }
        }
    }

    #[test]
    fn lines_of_nothing_are_refused() {
        let (mesh, normals) = octahedron();
        let solid = scene(Shape::Surface(Sphere::default().into()), DMat4::IDENTITY);
        let scene = scene(Shape::Mesh { mesh: &mesh, normals: &normals }, DMat4::IDENTITY);
        let refused =
            |scene: &Scene, path: LinePath| LineEnds::new(scene, 3, &path).err().unwrap().to_string();
        let along = |object| LinePath::FaceNormals { object, length: 1.0 };
        assert_eq!(refused(&scene, along(1)), "lines 3 run along object 1, which has no vertices");
        assert_eq!(refused(&solid, along(0)), "lines 3 run along object 0, which has no vertices");
        let edges = LinePath::Edges { object: 0, edges: vec![[0, 1], [5, 6]] };
        assert_eq!(refused(&scene, edges), "line 1 refers to point 6, but there are only 6");
        let beyond = LinePath::VertexNormals { object: 0, normals: vec![[0, 6]], length: 1.0 };
        assert!(refused(&scene, beyond).contains("point 6"));
        let endless = LinePath::FaceNormals { object: 0, length: f64::INFINITY };
        assert!(refused(&scene, endless).contains("length of lines is inf"));
    }
}
