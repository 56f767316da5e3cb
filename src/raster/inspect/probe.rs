//! The numbers behind one sample, in double precision and from unsnapped vertices.

use crate::num::LinearRgb;
use crate::raster::coverage::records::{Record, face_corners};
use crate::raster::coverage::triangles::DrawnObject;
use crate::raster::error::RenderError;
use crate::raster::frame::job::{Job, shade_settings};
use crate::raster::frame::render::bins;
use crate::raster::frame::tile::Worker;
use crate::raster::inspect::hit_point::{SeenPoint, seen_point, shares};
use crate::raster::scene::{Paint, Scene};
use crate::raster::settings::{FlatSample, Interpolation, RenderSettings, Shading};
use crate::raster::shading::ray_cast::cast;
use crate::raster::shading::scanline::ScanPolygon;
use crate::raster::shading::surface_colour::Ink;
use crate::raster::view::clip::{ClipVertex, NEAR, Shares, clip};
use crate::raster::view::screen_transform::View;
use crate::shade::{Explanation, Probe, SurfacePoint};
use glam::{DVec2, DVec3};

/// What is seen at one sample of a pixel.
///
/// Which face is seen is what the picture shows there, so it is found as the picture finds it, on snapped vertices.
/// Everything else is computed again: at a rim the sample may lie outside the unsnapped face by 1/512 of a pixel, and
/// a weight is then a little below 0.
#[derive(Clone, Debug, PartialEq)]
pub struct ProbePoint {
    /// The number of the object.
    pub object: usize,
    /// The face; `None` on an analytic surface.
    pub face: Option<u32>,
    /// Whether its front is seen.
    pub front: bool,
    /// The vertices that its values are interpolated between: those of the triangle, or of the whole face with
    /// [`Interpolation::Scanline`].
    pub vertices: Vec<u32>,
    /// The weight of each, by the settings' interpolation.
    pub weights: Vec<f64>,
    /// The point of the face that the sample sees, in the scene.
    pub position: DVec3,
    /// Distance along the camera's axis.
    pub distance: f64,
    /// The weighted sum of the vertices' normals, of the side that is lit: shorter than 1 where they differ. On an
    /// analytic surface its own.
    pub normal: DVec3,
    /// The face's normal, of the side that is lit; of an analytic surface its own.
    pub face_normal: DVec3,
    /// The points whose light, by their shares, is the colour: the sample itself under Phong and exact shading, the
    /// vertices under Gouraud, one point or all corners under flat shading.
    pub lit: Vec<LitPoint>,
}

/// A point that is lit for a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LitPoint {
    /// Its share of the colour.
    pub share: f64,
    /// Where it is in the scene.
    pub position: DVec3,
    /// The normal that it is lit with.
    pub normal: DVec3,
    /// Its colour, if it is given and not lit.
    pub given: Option<LinearRgb>,
}

/// Finds out about a sample of a pixel; `None` where nothing is seen.
///
/// # Errors
/// As [`render`](crate::raster::render), and for pixels and samples that are not there.
pub fn probe(
    scene: &Scene,
    settings: &RenderSettings,
    [x, y]: [u32; 2],
    sample: usize,
) -> Result<Option<ProbePoint>, RenderError> {
    let job = Job::new(scene, settings)?;
    let place = settings.samples.places().nth(sample);
    let (Some(place), Some(offset), true) =
        (place, settings.samples.offsets().nth(sample), x < settings.size[0] && y < settings.size[1])
    else {
        return Err(RenderError::Number {
            what: "the place to probe",
            found: format!("sample {sample} of pixel ({x}, {y})"),
            expected: "within the picture",
        });
    };
    let Some(record) = Worker::new().look(&job, &bins(&job), [x, y], offset) else { return Ok(None) };
    let at = [f64::from(x) + place[0], f64::from(y) + place[1]];
    match job.drawn.iter().find(|drawn| drawn.object == record.object as usize) {
        Some(drawn) => Ok(Some(on_face(&job, drawn, &record, at))),
        None => Ok(on_surface(&job, record.object as usize, at)),
    }
}

impl ProbePoint {
    /// How the light of each point of [`lit`](Self::lit) comes about; nothing where colours are given.
    ///
    /// # Errors
    /// As [`render`](crate::raster::render).
    pub fn explain(&self, scene: &Scene, settings: &RenderSettings) -> Result<Vec<Explanation>, RenderError> {
        let object = self.object;
        let Paint::Lit(material) = &scene.objects[object].paint else { return Ok(Vec::new()) };
        let view = View::new(&scene.camera, settings.size)?;
        let frame = crate::raster::frame::job::frame(scene, &view);
        let shade = shade_settings(settings, &view, frame, self.face.is_none());
        let probe = Probe::new(&scene.lights, material, &shade);
        let probe = probe.map_err(|error| RenderError::Shade { object, error })?;
        let explain = |lit: &LitPoint| {
            let position = shade.frame.to_local(lit.position).to_array();
            let point = SurfacePoint { position, normal: lit.normal.to_array() };
            let explanation = match settings.asks_faces() && self.face.is_some() {
                true => probe.explain_on(&point, self.face_normal.to_array()),
                false => probe.explain(&point),
            };
            // What the picture would be an error for, had rounding to single precision not moved it a little.
            match explanation.not_finite() {
                Some(error) => Err(RenderError::NotFinite { object, error }),
                None => Ok(explanation),
            }
        };
        self.lit.iter().map(explain).collect()
    }

    /// The linear colour of the sample, before the tone rule.
    ///
    /// # Errors
    /// As [`render`](crate::raster::render).
    pub fn colour(&self, scene: &Scene, settings: &RenderSettings) -> Result<LinearRgb, RenderError> {
        let explained = self.explain(scene, settings)?;
        let lights = explained.iter().map(|explanation| LinearRgb::from(explanation.sum));
        let given = self.lit.iter().filter_map(|lit| lit.given);
        let parts = lights.chain(given).zip(&self.lit);
        Ok(parts.fold(LinearRgb::BLACK, |sum, (colour, lit)| sum + colour * lit.share))
    }
}

/// A sample of an analytic surface.
fn on_surface(job: &Job, object: usize, at: [f64; 2]) -> Option<ProbePoint> {
    let (hit, distance) = cast(job, object, at)?;
    let turned = job.settings.two_sided && !hit.front;
    let normal = hit.normal.get() * if turned { -1.0 } else { 1.0 };
    Some(ProbePoint {
        object,
        face: None,
        front: hit.front,
        vertices: Vec::new(),
        weights: Vec::new(),
        position: hit.position,
        distance,
        normal,
        face_normal: normal,
        lit: vec![LitPoint { share: 1.0, position: hit.position, normal, given: None }],
    })
}

/// A sample of a face.
fn on_face(job: &Job, drawn: &DrawnObject, record: &Record, at: [f64; 2]) -> ProbePoint {
    let object = &job.objects[drawn.object];
    let triangle = drawn.list.vertices(record.triangle);
    let corners = drawn.list.corners(record.triangle);
    let SeenPoint { weights: in_scene, from_eye: relative } = seen_point(job, drawn, triangle, at);
    let position = |vertex: u32| drawn.map.scene_point(drawn.points.get(vertex));
    let face: Vec<(u32, u32)> = face_corners(object, drawn, record).collect();
    let (corners, weights): (Vec<(u32, u32)>, Vec<f64>) = match job.settings.interpolation {
        Interpolation::Scanline if face.len() > 3 => {
            let weights = scanline_weights(job, drawn, &face, at);
            (face.clone(), weights)
        }
        Interpolation::Perspective => (corners.into_iter().zip(triangle).collect(), in_scene.to_vec()),
        Interpolation::Affine | Interpolation::Scanline => {
            let weights = picture_weights(job, drawn, triangle, at);
            (corners.into_iter().zip(triangle).collect(), weights.to_vec())
        }
    };
    let normal_at =
        |&(corner, vertex): &(u32, u32)| object.exact_corner_normal(corner, vertex, record.turned);
    let normal = corners.iter().zip(&weights).map(|(corner, &weight)| normal_at(corner) * weight).sum();
    let face_normal = match object.has_face_normals() {
        true => object.exact_face_normal(record.face, record.turned),
        false => normal,
    };
    let given = |vertex: u32| match &object.ink {
        Ink::Given(colours) => Some(colours[vertex as usize]),
        Ink::Lit(_) => None,
    };
    let at_corner = |corner: &(u32, u32), share: f64| LitPoint {
        share,
        position: position(corner.1) + job.view.origin,
        normal: normal_at(corner),
        given: given(corner.1),
    };
    let is_given = matches!(object.ink, Ink::Given(_));
    let count = face.len() as f64;
    let lit = match job.settings.shading {
        Shading::Flat if is_given || job.settings.flat_sample == FlatSample::VertexMean => {
            face.iter().map(|corner| at_corner(corner, 1.0 / count)).collect()
        }
        Shading::Flat => {
            let sum: DVec3 = face.iter().map(|&(_, vertex)| position(vertex)).sum();
            vec![LitPoint {
                share: 1.0,
                position: sum / count + job.view.origin,
                normal: face_normal,
                given: None,
            }]
        }
        Shading::Wireframe => Vec::new(),
        Shading::Phong | Shading::Exact if !is_given => {
            vec![LitPoint { share: 1.0, position: relative + job.view.eye, normal, given: None }]
        }
        _ => corners.iter().zip(&weights).map(|(corner, &weight)| at_corner(corner, weight)).collect(),
    };
    ProbePoint {
        object: drawn.object,
        face: Some(record.face),
        front: record.front,
        vertices: corners.iter().map(|&(_, vertex)| vertex).collect(),
        weights,
        position: relative + job.view.eye,
        distance: relative.dot(job.view.axes[2]),
        normal,
        face_normal,
        lit,
    }
}

/// Barycentric coordinates on the picture, of what the near plane leaves of a triangle.
fn picture_weights(job: &Job, drawn: &DrawnObject, triangle: [u32; 3], at: [f64; 2]) -> [f64; 3] {
    let corner = |k: usize| ClipVertex {
        point: drawn.map.view(drawn.points.get(triangle[k])),
        attribute: Shares::of_corner(k),
    };
    let mut polygon: Vec<_> = [0, 1, 2].map(corner).to_vec();
    clip(&job.view, 1 << NEAR, &mut polygon, &mut Vec::new());
    let place =
        |vertex: &ClipVertex<Shares>| DVec2::from(job.view.on_picture(vertex.point)) - DVec2::from(at);
    let fan = polygon.get(1..).unwrap_or_default().windows(2).map(|pair| {
        let corners = [polygon[0], pair[0], pair[1]];
        let [a, b, c] = corners.each_ref().map(place);
        let weights = shares([b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)]);
        let mix = |k: usize| (0..3).map(|i| corners[i].attribute.picture[k] * weights[i]).sum::<f64>();
        (weights.into_iter().fold(f64::INFINITY, f64::min), [0, 1, 2].map(mix))
    });
    // The part that holds the place, or comes closest to holding it.
    fan.max_by(|a, b| a.0.total_cmp(&b.0)).map_or([0.0; 3], |(_, weights)| weights)
}

/// What the scanline algorithm takes of each corner of a face: its value where that corner has 1 and others have 0.
fn scanline_weights(job: &Job, drawn: &DrawnObject, face: &[(u32, u32)], at: [f64; 2]) -> Vec<f64> {
    let points = || face.iter().map(|&(_, vertex)| drawn.map.view(drawn.points.get(vertex)));
    let weight = |corner: usize| {
        let indicator = |k: usize| DVec3::splat(if k == corner { 1.0 } else { 0.0 });
        let corners = points().enumerate().map(|(k, point)| (point, indicator(k)));
        ScanPolygon::unsnapped(&job.view, corners).value(at).x
    };
    (0..face.len()).map(weight).collect()
}
