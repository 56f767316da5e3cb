//! A polygon that is turned, and the law of its scanline.

use crate::artefact::stage::{draw, front, settings, smooth};
use crate::artefact::{ArtefactError, UserMesh};
use crate::mesh::{Faces, Mesh, MeshBuilder};
use crate::normals::{NormalField, Weight};
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, Paint, Shading, Shape};
use crate::shade::Material;
use glam::{DMat4, DVec2, DVec3};

/// The colours of the lectures' vertices 1 to 4.
const COLOURS: [[f64; 3]; 4] = [[0.0, 0.4, 0.4], [0.0, 0.2, 0.2], [0.2, 0.6, 0.6], [0.4, 0.4, 0.0]];
/// The side of the window; the farthest corner is at 1.
const WINDOW: f64 = 2.3;

/// A plane polygon with a colour at each corner, about the origin; its farthest corner is at 1.
pub(super) struct Polygon {
    corners: Vec<DVec2>,
    colours: Vec<LinearRgb>,
    mesh: Mesh,
    normals: NormalField,
}

impl Polygon {
    /// The lectures' diamond, or the first face of a mesh that has four corners or more.
    pub(super) fn of(own: Option<&UserMesh>) -> Result<Self, ArtefactError> {
        let Some(own) = own else {
            let corners = vec![DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
            return Self::new(corners, COLOURS.map(LinearRgb::from).to_vec(), None);
        };
        let faces = own.mesh.faces();
        let Some(face) = (0..faces.len()).map(|face| faces.face(face)).find(|face| face.len() > 3) else {
            return Err(ArtefactError::Mesh {
                found: format!(
                    "all faces of `{}` are triangles, whose colours do not depend on orientation",
                    own.name
                ),
                advice: "give a mesh with a face of four corners or more",
            });
        };
        let points: Vec<DVec3> = face.iter().map(|&vertex| own.mesh.positions()[vertex as usize]).collect();
        let colours = match &own.mesh.columns().colors {
            Some(colours) => {
                let of = |&vertex: &u32| {
                    let [r, g, b, _] = colours[vertex as usize].map(f64::from);
                    LinearRgb::new(r, g, b)
                };
                face.iter().map(of).collect()
            }
            None => (0..face.len()).map(|corner| COLOURS[corner % COLOURS.len()].into()).collect(),
        };
        let polygon = Self::new(flattened(&points, own.name)?, colours, None)?;
        match polygon.ends(Degrees(0.0)) {
            [Some(_), Some(_)] => Ok(polygon),
            _ => Err(ArtefactError::Mesh {
                found: format!("the middle of the first polygon of `{}` lies outside of it", own.name),
                advice: "give a mesh whose first polygon is convex",
            }),
        }
    }

    fn new(
        corners: Vec<DVec2>,
        colours: Vec<LinearRgb>,
        triangles: Option<Vec<u32>>,
    ) -> Result<Self, ArtefactError> {
        let count = corners.len() as u32;
        let faces = match triangles {
            Some(triangles) => Faces::triangles(triangles),
            None => Faces::polygons((0..count).collect(), vec![0, count]),
        };
        let positions = corners.iter().map(|corner| corner.extend(0.0)).collect();
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build()?;
        let normals = smooth(&mesh, Weight::Angle);
        Ok(Self { corners, colours, mesh, normals })
    }

    /// The same cut into a fan of triangles about one of its corners.
    pub(super) fn cut(&self, corner: u32) -> Result<Self, ArtefactError> {
        let count = self.corners.len() as u32;
        let at = |k: u32| (corner + k) % count;
        let triangles = (1..count - 1).flat_map(|k| [at(0), at(k), at(k + 1)]).collect();
        Self::new(self.corners.clone(), self.colours.clone(), Some(triangles))
    }

    pub(super) fn draw(
        &self,
        size: u32,
        angle: Degrees,
        interpolation: Interpolation,
    ) -> Result<Image, ArtefactError> {
        let object = Object {
            transform: DMat4::from_cols_array(&turn(angle)),
            paint: Paint::Given(self.colours.as_slice().into()),
            ..Object::new(Shape::Mesh { mesh: &self.mesh, normals: &self.normals }, Material::default())
        };
        draw(vec![object], &[], front(WINDOW), &settings([size; 2], Shading::Gouraud, interpolation))
    }

    /// Where the horizontal line through the origin leaves the polygon turned by an angle, to the left and to the right,
    /// with the colours there: by cutting each edge.
    fn ends(&self, angle: Degrees) -> [Option<(f64, DVec3)>; 2] {
        let (sin, cos) = sin_cos(angle);
        let turned: Vec<DVec2> =
            self.corners.iter().map(|p| DVec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y)).collect();
        let colour = |corner: usize| DVec3::from(self.colours[corner].to_array());
        let mut ends: [Option<(f64, DVec3)>; 2] = [None; 2];
        for (from, to) in (0..turned.len()).map(|corner| (corner, (corner + 1) % turned.len())) {
            let (a, b) = (turned[from], turned[to]);
            if (a.y < 0.0) == (b.y < 0.0) {
                continue;
            }
            let share = a.y / (a.y - b.y);
            let (x, colour) = (a.x + share * (b.x - a.x), colour(from).lerp(colour(to), share));
            let end = &mut ends[usize::from(x > 0.0)];
            if end.is_none_or(|(nearest, _)| x.abs() < nearest.abs()) {
                *end = Some((x, colour));
            }
        }
        ends
    }

    /// The law: the colour at the origin between the two ends of its scanline.
    pub(super) fn scanline(&self, angle: Degrees) -> DVec3 {
        match self.ends(angle) {
            [Some((left, first)), Some((right, second))] => first.lerp(second, left / (left - right)),
            _ => DVec3::ZERO,
        }
    }
}

/// The corners of a polygon in its own plane, about their mean, with the farthest at 1.
fn flattened(points: &[DVec3], name: &str) -> Result<Vec<DVec2>, ArtefactError> {
    let mean = points.iter().sum::<DVec3>() / points.len() as f64;
    let pairs = points.iter().zip(points.iter().cycle().skip(1));
    let normal: DVec3 = pairs.map(|(&a, &b)| (a - mean).cross(b - mean)).sum();
    let largest = points.iter().map(|&point| (point - mean).length()).fold(0.0, f64::max);
    let (Some(normal), true) = (normal.try_normalize(), largest > 0.0) else {
        return Err(ArtefactError::Mesh {
            found: format!("the first polygon of `{name}` has no area"),
            advice: "give a mesh whose first polygon has one",
        });
    };
    let across = (points[0] - mean).reject_from(normal);
    let x = across.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
    let y = normal.cross(x);
    Ok(points.iter().map(|&p| DVec2::new((p - mean).dot(x), (p - mean).dot(y)) / largest).collect())
}

/// Sine and cosine, exact at quarter turns.
pub(super) fn sin_cos(Degrees(angle): Degrees) -> (f64, f64) {
    match angle.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        angle => libm::sincos(Radians::from(Degrees(angle)).0),
    }
}

/// The turn about z by an angle, counter-clockwise, as columns of a matrix.
fn turn(angle: Degrees) -> [f64; 16] {
    let (sin, cos) = sin_cos(angle);
    [cos, sin, 0.0, 0.0, -sin, cos, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
}
