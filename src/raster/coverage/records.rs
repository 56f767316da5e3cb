//! The visible triangles of a tile, with the values at their corners.

use crate::num::LinearRgb;
use crate::raster::coverage::setup::double_area;
use crate::raster::coverage::tile_bins::Piece;
use crate::raster::coverage::triangles::{Corner, DrawnObject, TriangleList};
use crate::raster::frame::job::{Job, Prepared};
use crate::raster::scene::Shape;
use crate::raster::settings::{FlatSample, Interpolation, RenderSettings, Shading, Show};
use crate::raster::shading::surface_colour::ObjectColour;
use crate::raster::view::clip::Shares;
use crate::raster::view::project::ScreenVertex;
use glam::{DVec3, Vec3};

/// What a triangle spreads over its samples: 18 numbers, which vector instructions read four at a time.
#[derive(Clone, Copy, Debug, Default, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct RecordCorners {
    /// The x and y of its corners on the picture, in 256ths of a pixel: whole numbers of at most 24 bits.
    pub(crate) x: [f32; 3],
    pub(crate) y: [f32; 3],
    /// Their [nearness](crate::raster::view::screen_transform::View::nearness), in perspective.
    pub(crate) nearness: [f32; 3],
    /// What is interpolated, at each corner: a normal or a colour.
    pub(crate) values: [Vec3; 3],
}

/// A triangle that is seen, or a piece of one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Record {
    pub(crate) corners: RecordCorners,
    pub(crate) vertices: [u32; 3],
    pub(crate) triangle: u32,
    pub(crate) face: u32,
    pub(crate) object: u32,
    pub(crate) front: bool,
    /// Whether its normals are those of the other side.
    pub(crate) turned: bool,
}

impl Record {
    #[inline(always)]
    pub(crate) fn new(job: &Job, object: &DrawnObject, triangle: u32, v: &[ScreenVertex; 3]) -> Self {
        let front = (double_area(v) < 0.0) != object.mirrored;
        let vertices = object.list.vertices(triangle);
        let nearness = match job.view.has_level() {
            false => v.map(|v| v.depth),
            true => vertices.map(|vertex| {
                let point = object.map.view(object.points.at(vertex));
                job.view.nearness(point.z) as f32
            }),
        };
        Self {
            corners: RecordCorners {
                x: v.map(|v| v.x as f32),
                y: v.map(|v| v.y as f32),
                nearness,
                values: [Vec3::ZERO; 3],
            },
            vertices,
            triangle,
            face: object.list.face(triangle),
            object: object.object as u32,
            front,
            turned: job.objects[object.object].settings.two_sided && !front,
        }
    }

    /// The record of an analytic surface, for all samples that see it.
    pub(crate) fn cast(object: usize) -> Self {
        let corners = RecordCorners { nearness: [1.0; 3], ..RecordCorners::default() };
        Self { corners, object: object as u32, front: true, ..Self::default() }
    }

    pub(crate) fn nearness_at(&self, [x, y]: [i32; 2]) -> f32 {
        let RecordCorners { x: xs, y: ys, nearness, .. } = self.corners;
        let parts = parts(xs.map(|corner| corner as i32 - x), ys.map(|corner| corner as i32 - y));
        let sum = |of: [f32; 3]| {
            parts[0] * f64::from(of[0]) + parts[1] * f64::from(of[1]) + parts[2] * f64::from(of[2])
        };
        (sum(nearness) / sum([1.0; 3])) as f32
    }
}

/// Twice the signed areas of the triangles between the origin and the side opposite to each corner: the weights of the
/// corners at the origin, times twice the area. Exact in doubles for coordinates of 25 bits.
#[inline(always)]
pub(crate) fn parts(x: [i32; 3], y: [i32; 3]) -> [f64; 3] {
    let at = |k: usize| (f64::from(x[k]), f64::from(y[k]));
    let ((x0, y0), (x1, y1), (x2, y2)) = (at(0), at(1), at(2));
    [x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0]
}

/// What is wanted at each sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ValueKind {
    /// Nothing that varies.
    Nothing,
    /// A normal that is interpolated.
    CornerNormals,
    /// The face's normal.
    FaceNormal,
    /// Colours of corners.
    CornerColours,
    /// One colour.
    FaceColour,
}

impl ValueKind {
    pub(crate) fn new(object: &Prepared) -> Self {
        let RenderSettings { shading, show, .. } = object.settings;
        let flat = shading == Shading::Flat;
        match (show, &object.colour) {
            (Show::Depth | Show::FaceId, _) => Self::Nothing,
            (Show::Normals | Show::Facing | Show::Deviation(_), _) if flat => Self::FaceNormal,
            (Show::Normals | Show::Facing | Show::Deviation(_), _) => Self::CornerNormals,
            (Show::Shaded, _) if shading == Shading::Wireframe => Self::Nothing,
            (Show::Shaded, _) if flat => Self::FaceColour,
            (Show::Shaded, ObjectColour::Given(_)) => Self::CornerColours,
            (Show::Shaded, ObjectColour::Lit(_)) if shading == Shading::Gouraud => Self::CornerColours,
            (Show::Shaded, ObjectColour::Lit(_)) => Self::CornerNormals,
        }
    }

    /// Whether values of corners are spread over faces.
    pub(crate) fn varies(self) -> bool {
        matches!(self, Self::CornerNormals | Self::CornerColours)
    }
}

/// The values at the corners of a piece: means of those at the corners of the whole triangle.
pub(crate) fn piece_values(values: [Vec3; 3], piece: &Piece, interpolation: Interpolation) -> [Vec3; 3] {
    piece.shares.map(|Shares { scene, picture }| {
        let shares = if interpolation == Interpolation::Perspective { scene } else { picture };
        (0..3).map(|k| values[k].as_dvec3() * shares[k]).sum::<DVec3>().as_vec3()
    })
}

pub(crate) fn face_corners<'a>(
    object: &'a Prepared,
    drawn: &'a DrawnObject,
    &Record { face, turned, .. }: &Record,
) -> impl ExactSizeIterator<Item = Corner> + use<'a> {
    let (first, vertices): (u32, &[u32]) = match (object.shape, &drawn.list) {
        (Shape::Mesh { mesh, .. }, _) => {
            let range = mesh.faces().range(face as usize);
            (range.start as u32, &mesh.faces().corners()[range])
        }
        (_, TriangleList::Whole(triangles)) => (3 * face, &triangles[face as usize]),
        _ => (0, &[]),
    };
    vertices.iter().enumerate().map(move |(k, &vertex)| Corner { number: first + k as u32, vertex, turned })
}

#[inline(always)]
pub(crate) fn triangle_corners(drawn: &DrawnObject, record: &Record) -> [Corner; 3] {
    let numbers = drawn.list.corners(record.triangle);
    let corner = |k: usize| Corner { number: numbers[k], vertex: record.vertices[k], turned: record.turned };
    [corner(0), corner(1), corner(2)]
}

pub(crate) fn mean_colour(colours: &[LinearRgb], corners: impl ExactSizeIterator<Item = Corner>) -> Vec3 {
    let count = corners.len() as f64;
    let sum = corners.fold(LinearRgb::BLACK, |sum, corner| sum + colours[corner.vertex as usize]);
    single(sum * (1.0 / count))
}

pub(crate) fn single(colour: LinearRgb) -> Vec3 {
    DVec3::from(colour.to_array()).as_vec3()
}

/// Whether flat faces take the mean of what their corners would have.
pub(crate) fn takes_mean(object: &Prepared) -> bool {
    object.settings.flat_sample == FlatSample::VertexMean || matches!(object.colour, ObjectColour::Given(_))
}
