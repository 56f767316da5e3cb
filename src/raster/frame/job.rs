//! A scene and settings checked and made ready: what all tiles share.

use crate::mesh::{ColumnIndex, NONE, NormalMatrix, normal_matrix};
use crate::num::parallel;
use crate::num::unit_scale;
use crate::raster::coverage::triangles::{Corner, DrawnObject};
use crate::raster::error::{RenderError, Result};
use crate::raster::scene::{Object, Paint, Scene, Shape};
use crate::raster::settings::{LARGEST_SIDE, RenderSettings, Shading, Show};
use crate::raster::shading::surface_colour::{ObjectColour, Shaders};
use crate::raster::traced::lamp::Lamp;
use crate::raster::traced::world::{TracedScene, World};
use crate::raster::view::project::{NOT_FINITE, ScreenVertex};
use crate::raster::view::screen_transform::{Rays, View};
use crate::shade::{Frame, Guards, Optics, ShadeSettings, Terminator, Viewer};
use crate::surface::Placed;
use glam::{DMat3, DVec3, Vec3};

pub(crate) struct Job<'a> {
    pub(crate) settings: &'a RenderSettings,
    pub(crate) view: View,
    pub(crate) rays: Rays,
    pub(crate) frame: Frame,
    pub(crate) background: [f32; 3],
    pub(crate) objects: Vec<Prepared<'a>>,
    pub(crate) drawn: Vec<DrawnObject<'a>>,
    /// The light on every vertex of each of these, where it was computed in advance.
    pub(crate) lit: Vec<Option<Vec<Vec3>>>,
    /// Smallest and largest distance of a vertex along the axis, for [`Show::Depth`].
    pub(crate) distances: [f64; 2],
    /// Where a picture is traced.
    pub(crate) traced: Option<TracedScene>,
}

pub(crate) struct Prepared<'a> {
    /// Those of the picture and its own.
    pub(crate) settings: RenderSettings,
    pub(crate) shape: &'a Shape<'a>,
    /// How normals reach the scene; `None` if they are there already.
    normals: Option<NormalMatrix>,
    pub(crate) colour: ObjectColour<'a>,
    /// The analytic surface that the object approximates.
    pub(crate) truth: Option<Placed>,
    pub(crate) optics: Optics,
    /// Whether it is drawn by casting rays at its truth.
    pub(crate) is_cast: bool,
}

impl<'a> Job<'a> {
    pub(crate) fn new(scene: &'a Scene<'a>, settings: &'a RenderSettings) -> Result<Self> {
        Self::reusing(scene, settings, &mut Vec::new())
    }

    /// The same in the memory of other jobs' vertices.
    pub(crate) fn reusing(
        scene: &'a Scene<'a>,
        settings: &'a RenderSettings,
        spare: &mut Vec<Vec<ScreenVertex>>,
    ) -> Result<Self> {
        let [width, height] = settings.size;
        if !settings.size.iter().all(|side| (1..=LARGEST_SIDE).contains(side)) {
            let found = format!("the picture is {width} by {height} pixels; each side must be 1 to 16384");
            return Err(RenderError::Invalid(found));
        }
        let view = View::new(&scene.camera, settings.size)?;
        // In single precision, in which it is drawn.
        if !scene.background.to_array().iter().all(|&component| (component as f32).is_finite()) {
            return Err(RenderError::Number {
                what: "the background",
                found: format!("{:?}", scene.background.to_array()),
                expected: "finite",
            });
        }
        let frame = frame(scene, &view);
        let objects = scene.objects.iter().enumerate();
        let objects = objects
            .map(|(number, object)| Prepared::new(number, object, scene, settings, &view, frame))
            .collect::<Result<Vec<_>, _>>()?;
        let (mut drawn, mut first) = (Vec::new(), 0);
        for (number, object) in scene.objects.iter().enumerate().filter(|&(n, _)| !objects[n].is_cast) {
            let mirrored = normal_matrix(DMat3::from_mat4(object.transform)).is_some_and(|n| n.mirrored());
            let ready = DrawnObject::new(
                &object.shape,
                number,
                first as u32,
                object.transform,
                mirrored,
                &view,
                spare,
            );
            let Some(ready) = ready else { continue };
            first += ready.list.len();
            if first > i32::MAX as usize {
                let found = format!("the scene has {first} triangles (limit 2147483647)");
                return Err(RenderError::Invalid(found));
            }
            check_range(&ready)?;
            drawn.push(ready);
        }
        let distances = match settings.show {
            Show::Depth => distances(&drawn, &view, scene),
            _ => [0.0, 1.0],
        };
        let background = scene.background.to_array().map(|c| c as f32);
        let rays = Rays::new(&view, frame.unit);
        let is_traced = settings.shading == Shading::Traced && settings.show == Show::Shaded;
        let traced = is_traced.then(|| traced(scene, &objects, &drawn, frame));
        let lit = vec![None; drawn.len()];
        Ok(Self { settings, view, rays, frame, background, objects, drawn, lit, distances, traced })
    }

    /// The number among [`drawn`](Self::drawn) of the object that a triangle is of.
    pub(crate) fn owner(&self, triangle: u32) -> usize {
        self.drawn.partition_point(|object| object.first <= triangle) - 1
    }

    pub(crate) fn cast_objects(&self) -> impl Iterator<Item = usize> {
        self.objects.iter().enumerate().filter(|(_, object)| object.is_cast).map(|(number, _)| number)
    }
}

/// The scene as rays meet it.
fn traced(scene: &Scene, objects: &[Prepared], drawn: &[DrawnObject], frame: Frame) -> TracedScene {
    let cast = objects.iter().enumerate().filter(|(_, object)| object.is_cast);
    let surfaces = cast.filter_map(|(number, object)| Some((number, object.truth?))).collect();
    TracedScene {
        world: World::new(drawn, surfaces, frame),
        lamps: scene.lights.iter().map(|light| Lamp::new(light, frame)).collect(),
        transmits: objects.iter().any(|object| object.optics.transmits()),
    }
}

/// The frame of shaders: about the view's origin, in a power of two near the camera's distance from its target or, if it is far
/// from it, near the size of the window. Single precision then serves scenes of any size and position.
pub(crate) fn frame(scene: &Scene, view: &View) -> Frame {
    let distance = (scene.camera.target - scene.camera.eye).length();
    // The viewer stays within the 2³¹ units that shaders take in single precision.
    let size = if view.away == 0.0 { distance } else { view.shown().max(distance / f64::from(1 << 29)) };
    let unit = 1.0 / unit_scale(size.clamp(f64::MIN_POSITIVE, f64::MAX));
    Frame { origin: view.origin, unit: unit.clamp(f64::MIN_POSITIVE, f64::MAX) }
}

impl RenderSettings {
    /// The guards for objects that rays are cast at, or for faces: only interpolated normals may stay of any length.
    fn guards(&self, is_cast: bool) -> Guards {
        let interpolates = matches!(self.shading, Shading::Phong | Shading::Traced) && !is_cast;
        Guards { renormalise: self.guards.renormalise || !interpolates, ..self.guards }
    }

    /// Whether what lights a sample depends on the normal of its face as well.
    pub(crate) fn asks_faces(&self) -> bool {
        matches!(self.shading, Shading::Phong | Shading::Traced) && self.terminator != Terminator::Smooth
    }
}

/// What shaders are made with, of objects that rays are cast at or of faces.
pub(crate) fn shade_settings(
    settings: &RenderSettings,
    view: &View,
    frame: Frame,
    is_cast: bool,
) -> ShadeSettings {
    let is_far = !view.perspective || settings.infinite_viewer;
    ShadeSettings {
        viewer: if is_far { Viewer::Towards(-view.axes[2]) } else { Viewer::At(view.eye) },
        frame,
        guards: settings.guards(is_cast),
        terminator: settings.terminator,
        depth_cue: settings.depth_cue,
        // Faces know which side is seen: see `Prepared::corner_normal`.
        two_sided: false,
        tone: settings.tone,
    }
}

impl<'a> Prepared<'a> {
    fn new(
        number: usize,
        object: &'a Object<'a>,
        scene: &Scene,
        settings: &RenderSettings,
        view: &View,
        frame: Frame,
    ) -> Result<Self> {
        let of_all = match object.settings.shading {
            Some(Shading::Wireframe) => Some("be a wireframe"),
            Some(Shading::Traced) => Some("be traced"),
            _ => None,
        };
        if let Some(what) = of_all {
            return Err(RenderError::Invalid(format!("object {number}: a single object cannot {what}")));
        }
        object.optics.check().map_err(|error| RenderError::Shade { object: number, error })?;
        let settings = &settings.of(&object.settings);
        check_lists(number, object, settings)?;
        let linear = DMat3::from_mat4(object.transform);
        let singular = RenderError::singular(number);
        let matrix = normal_matrix(linear).filter(|_| object.transform.is_finite());
        let normals = Some(matrix.ok_or(singular.clone())?).filter(|_| linear != DMat3::IDENTITY);
        let is_cast = settings.shading == Shading::Exact || matches!(object.shape, Shape::Surface(_));
        let colour = match &object.paint {
            Paint::Lit(material) => {
                let shade = shade_settings(settings, view, frame, is_cast);
                let shaders = Shaders::new(&scene.lights, material, &shade);
                ObjectColour::Lit(Box::new(
                    shaders.map_err(|error| RenderError::Shade { object: number, error })?,
                ))
            }
            Paint::Given(colours) => ObjectColour::Given(colours),
        };
        let surface = match object.shape {
            Shape::Surface(primitive) => Some(primitive),
            _ => object.surface,
        };
        let truth = surface.map(|primitive| Placed::new(primitive, object.transform)).transpose();
        let truth = truth.map_err(|_| singular)?;
        if settings.shading == Shading::Exact && truth.is_none() {
            let lack = "exact shading needs an analytic surface, but this is a mesh; choose another shading";
            return Err(RenderError::Lacks { object: number, lack });
        }
        if is_cast && settings.show == Show::Shaded && matches!(colour, ObjectColour::Given(_)) {
            let lack =
                "an analytic surface has no vertex colours; use a material, or a mesh with another shading";
            return Err(RenderError::Lacks { object: number, lack });
        }
        Ok(Self {
            settings: *settings,
            shape: &object.shape,
            normals,
            colour,
            truth,
            optics: object.optics,
            is_cast,
        })
    }

    /// The normal at a corner, in the scene's axes.
    #[inline(always)]
    pub(crate) fn corner_normal(&self, corner: Corner) -> Vec3 {
        match (self.shape, &self.normals) {
            // Single precision stays so: this is most of the cost of gathering.
            (Shape::Triangles(triangles), None) => {
                side(Vec3::from(triangles.normals[corner.vertex as usize]), corner.turned)
            }
            _ => self.exact_corner_normal(corner).as_vec3(),
        }
    }

    /// The normal of a face, likewise.
    #[inline(always)]
    pub(crate) fn face_normal(&self, face: u32, turned: bool) -> Vec3 {
        match (self.shape, &self.normals) {
            (Shape::Triangles(triangles), None) => {
                side(Vec3::from(triangles.face_normals[face as usize]), turned)
            }
            _ => self.exact_face_normal(face, turned).as_vec3(),
        }
    }

    /// The number of a corner's normal in its object: the same number at the same vertex means the same normal.
    #[inline(always)]
    pub(crate) fn entry(&self, corner: u32, vertex: u32) -> u32 {
        match self.shape {
            Shape::Mesh { normals, .. } => normals.normals.slot(corner as usize, vertex).unwrap_or(NONE),
            _ => vertex,
        }
    }

    /// Whether vertices have one normal each.
    pub(crate) fn has_vertex_normals(&self) -> bool {
        match self.shape {
            Shape::Mesh { normals, .. } => matches!(normals.normals.index, ColumnIndex::PerVertex),
            Shape::Triangles(_) => true,
            Shape::Surface(_) => false,
        }
    }

    pub(crate) fn exact_corner_normal(&self, Corner { number, vertex, turned }: Corner) -> DVec3 {
        let normal = match self.shape {
            Shape::Mesh { normals, .. } => normals.normals.get(number as usize, vertex).copied(),
            shape => Some(shape.normals().at(vertex)),
        };
        side(self.in_scene(normal.unwrap_or(DVec3::ZERO)), turned)
    }

    pub(crate) fn exact_face_normal(&self, face: u32, turned: bool) -> DVec3 {
        side(self.in_scene(self.shape.face_normals().at(face)), turned)
    }

    /// Whether faces have normals of their own; triangles of slices need not.
    pub(crate) fn has_face_normals(&self) -> bool {
        !matches!(self.shape, Shape::Triangles(triangles) if triangles.face_normals.is_empty())
    }

    fn in_scene(&self, normal: DVec3) -> DVec3 {
        match &self.normals {
            None => normal,
            Some(matrix) => matrix.apply(normal).unwrap_or(normal),
        }
    }
}

/// A normal, or that of the other side.
#[inline(always)]
fn side<T: std::ops::Neg<Output = T>>(normal: T, turned: bool) -> T {
    if turned { -normal } else { normal }
}

fn check_lists(number: usize, object: &Object, settings: &RenderSettings) -> Result<()> {
    let count = |what, found, per, expected| match found == expected {
        true => Ok(()),
        false => Err(RenderError::Invalid(format!("object {number}: {found} {what}, but {expected} {per}"))),
    };
    let vertices = match &object.shape {
        Shape::Mesh { mesh, normals } => {
            count("face normals", normals.face_normals.len(), "faces", mesh.face_count())?;
            match &normals.normals.index {
                ColumnIndex::PerVertex => {
                    count("normals", normals.normals.values.len(), "vertices", mesh.vertex_count())?;
                }
                ColumnIndex::PerCorner(index) => {
                    count("normals", index.len(), "corners", mesh.faces().corner_count())?;
                }
            }
            mesh.vertex_count()
        }
        Shape::Triangles(triangles) => {
            let vertices = triangles.positions.len();
            count("normals", triangles.normals.len(), "vertices", vertices)?;
            let wants_faces = settings.shading == Shading::Flat
                || matches!(settings.show, Show::Deviation(_))
                || settings.asks_faces();
            if wants_faces || !triangles.face_normals.is_empty() {
                count("face normals", triangles.face_normals.len(), "triangles", triangles.triangles.len())?;
            }
            check_indices(triangles.triangles, vertices)?;
            vertices
        }
        Shape::Surface(_) => return Ok(()),
    };
    match &object.paint {
        Paint::Given(colours) => count("vertex colours", colours.len(), "vertices", vertices),
        Paint::Lit(_) => Ok(()),
    }
}

fn check_indices(triangles: &[[u32; 3]], count: usize) -> Result<()> {
    // The largest index first: a search that stops early is slower.
    let indices = triangles.as_flattened();
    let largest = |indices: &[u32]| indices.iter().fold(0, |largest, &index| index.max(largest));
    let largest = parallel::ranges(indices.len(), |range| largest(&indices[range])).into_iter().max();
    if indices.is_empty() || largest.is_none_or(|largest| (largest as usize) < count) {
        return Ok(());
    }
    let wrong = indices.iter().position(|&index| index as usize >= count).unwrap_or(0);
    Err(RenderError::index("triangle", wrong / 3, indices[wrong], count))
}

/// Whether all vertices have a finite place on the picture.
fn check_range(object: &DrawnObject) -> Result<()> {
    if object.outside & NOT_FINITE == 0 {
        return Ok(());
    }
    let vertex = object.vertices.iter().position(|vertex| vertex.outside & NOT_FINITE != 0).unwrap_or(0);
    let position = object.points.at(vertex as u32);
    let place = format!("object {}: vertex {vertex} at {position}", object.object);
    Err(RenderError::Invalid(format!("{place} has no finite position in front of the camera")))
}

/// The distances along the camera's axis that [`Show::Depth`] draws white and black, in units of the scene.
///
/// # Errors
/// As [`render`](crate::raster::render).
pub fn depth_range(scene: &Scene, settings: &RenderSettings) -> Result<[f64; 2]> {
    let settings = RenderSettings { show: Show::Depth, ..*settings };
    Ok(Job::new(scene, &settings)?.distances)
}

/// The range of distances that [`Show::Depth`] spreads over.
fn distances(drawn: &[DrawnObject], view: &View, scene: &Scene) -> [f64; 2] {
    let each = drawn.iter().flat_map(|object| {
        (0..object.points.len() as u32).map(|vertex| object.map.view(object.points.at(vertex)).z)
    });
    let [low, high] = each
        .filter(|&z| z >= view.near)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
    if low < high {
        return [low, high];
    }
    let distance = (scene.camera.target - scene.camera.eye).length();
    [0.5 * distance, 1.5 * distance]
}
