//! The numbers behind one sample, in double precision and from unsnapped vertices.

use crate::num::LinearRgb;
use crate::raster::coverage::records::{Record, face_corners, takes_mean, triangle_corners};
use crate::raster::coverage::triangles::{Corner, DrawnObject, PlanePoint, shares};
use crate::raster::error::{RenderError, Result};
use crate::raster::frame::job::{Job, shade_settings};
use crate::raster::frame::render::bins;
use crate::raster::frame::tile::Worker;
use crate::raster::scene::{Paint, Scene};
use crate::raster::settings::{Interpolation, RenderSettings, Shading};
use crate::raster::shading::ray_cast::cast;
use crate::raster::shading::scan_polygon::ScanPolygon;
use crate::raster::shading::surface_colour::ObjectColour;
use crate::raster::traced::camera_rays::{first_hit, ray_tree};
use crate::raster::traced::ray_tree::RayNode;
use crate::raster::traced::world::TracedScene;
use crate::raster::view::clip::{ClipVertex, NEAR, Shares, clip};
use crate::raster::view::fixed_point::ONE;
use crate::shade::{Explanation, Light, Probe, SurfacePoint};
use glam::{DVec2, DVec3};
use serde::Serialize;

/// The surface that is visible at one sample of a pixel. Objects, faces and vertices count from 0.
///
/// The visible face is that of the picture, on snapped vertices. All numbers are computed from unsnapped ones: at a rim
/// the sample may lie outside the face by 1/512 of a pixel, and a weight may be a little below 0.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProbePoint {
    /// The number of the object.
    pub object: usize,
    /// The face; `None` on an analytic surface.
    pub face: Option<u32>,
    /// Whether its front is seen.
    pub front: bool,
    /// The vertices of the triangle, or of the whole face with [`Interpolation::Scanline`].
    pub vertices: Vec<u32>,
    /// The weight of each, by the settings' interpolation.
    pub weights: Vec<f64>,
    /// The point of the face that the sample sees, in the scene.
    pub position: [f64; 3],
    /// Distance along the camera's axis.
    pub distance: f64,
    /// The weighted sum of the vertices' normals, of the lit side: shorter than 1 where they differ. On an analytic
    /// surface its unit normal.
    pub interpolated_normal: [f64; 3],
    /// The face's normal, of the side that is lit; of an analytic surface its own.
    pub face_normal: [f64; 3],
    /// The points of which the colour consists by their shares: the sample under Phong and exact shading, the vertices under
    /// Gouraud, one point or all corners under flat shading.
    pub lit: Vec<LitPoint>,
    /// The rays of a traced picture, from the camera on; `lit` is then without shadows.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rays: Option<RayNode>,
}

/// A point that is lit for a sample, or has a given colour.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LitPoint {
    /// Its share of the colour.
    pub share: f64,
    /// Its colour, if that is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub given: Option<[f64; 3]>,
    /// The terms of its light, if it is lit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<Explanation>,
}

impl ProbePoint {
    /// The linear colour of the sample, before the tone rule.
    pub fn colour(&self) -> LinearRgb {
        if let Some(rays) = &self.rays {
            return LinearRgb::from(rays.colour);
        }
        let colour = |lit: &LitPoint| lit.light.as_ref().map(|light| light.sum).or(lit.given);
        let parts = self.lit.iter().filter_map(|lit| Some(LinearRgb::from(colour(lit)?) * lit.share));
        parts.fold(LinearRgb::BLACK, |sum, part| sum + part)
    }
}

/// The numbers behind a sample of a pixel; `None` where nothing is seen.
///
/// # Errors
/// As [`render`](crate::raster::render), and for pixels and samples that do not exist.
pub fn probe(
    scene: &Scene,
    settings: &RenderSettings,
    [x, y]: [u32; 2],
    sample: usize,
) -> Result<Option<ProbePoint>> {
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
    let at = [f64::from(x) + place[0], f64::from(y) + place[1]];
    if let Some(traced) = &job.traced {
        let sample = [x, y].map(|n| n as i32 * ONE);
        return probe_rays(&job, scene, traced, at, [sample[0] + offset[0], sample[1] + offset[1]]);
    }
    let Some(record) = Worker::new().visible_record(&job, &bins(&job), [x, y], offset) else {
        return Ok(None);
    };
    let seen = match job.drawn.iter().find(|drawn| drawn.object == record.object as usize) {
        Some(drawn) => Some(on_face(&job, drawn, &record, at)),
        None => on_surface(&job, record.object as usize, at),
    };
    let Some((mut point, sources)) = seen else { return Ok(None) };
    point.lit = lit_points(&job, &scene.objects[point.object].paint, &scene.lights, &point, &sources)?;
    Ok(Some(point))
}

/// The same of a traced picture; the sample is given in 256ths of a pixel, too.
fn probe_rays(
    job: &Job,
    scene: &Scene,
    traced: &TracedScene,
    at: [f64; 2],
    sample: [i32; 2],
) -> Result<Option<ProbePoint>> {
    let Some((ray, hit, _)) = first_hit(job, traced, at) else { return Ok(None) };
    let seen = match hit.triangle {
        None => on_surface(job, hit.object, at),
        Some((number, triangle)) => {
            let drawn = &job.drawn[number];
            let record = Record {
                vertices: drawn.list.vertices(triangle),
                triangle,
                face: drawn.list.face(triangle),
                object: hit.object as u32,
                front: hit.front,
                turned: hit.turned,
                ..Record::default()
            };
            Some(on_face(job, drawn, &record, at))
        }
    };
    let Some((mut point, sources)) = seen else { return Ok(None) };
    point.lit = lit_points(job, &scene.objects[point.object].paint, &scene.lights, &point, &sources)?;
    point.rays = Some(ray_tree(job, traced, (ray, &hit), sample)?);
    Ok(Some(point))
}

struct ColourSource {
    share: f64,
    position: DVec3,
    normal: DVec3,
    given: Option<LinearRgb>,
}

fn lit_points(
    job: &Job,
    paint: &Paint,
    lights: &[Light],
    point: &ProbePoint,
    sources: &[ColourSource],
) -> Result<Vec<LitPoint>> {
    let Paint::Lit(material) = paint else {
        let given = |source: &ColourSource| source.given.map(LinearRgb::to_array);
        let lit = |source: &ColourSource| LitPoint { share: source.share, given: given(source), light: None };
        return Ok(sources.iter().map(lit).collect());
    };
    let object = point.object;
    let settings = &job.objects[object].settings;
    let shade = shade_settings(settings, &job.view, job.frame, point.face.is_none());
    let probe = Probe::new(lights, material, &shade);
    let probe = probe.map_err(|error| RenderError::Shade { object, error })?;
    let lit = |source: &ColourSource| {
        let position = shade.frame.to_local(source.position).to_array();
        let surface = SurfacePoint { position, normal: source.normal.to_array() };
        let face = (settings.asks_faces() && point.face.is_some()).then_some(point.face_normal);
        let light = probe.explain_on(&surface, face);
        // The picture would be an error, too, had rounding to single precision not moved the point.
        match light.not_finite() {
            Some(error) => Err(RenderError::NotFinite { object, error }),
            None => Ok(LitPoint { share: source.share, given: None, light: Some(light) }),
        }
    };
    sources.iter().map(lit).collect()
}

fn on_surface(job: &Job, object: usize, at: [f64; 2]) -> Option<(ProbePoint, Vec<ColourSource>)> {
    let (hit, distance) = cast(job, object, at)?;
    let turned = job.objects[object].settings.two_sided && !hit.front;
    let normal = hit.normal.get() * if turned { -1.0 } else { 1.0 };
    let point = ProbePoint {
        object,
        face: None,
        front: hit.front,
        vertices: Vec::new(),
        weights: Vec::new(),
        position: hit.position.to_array(),
        distance,
        interpolated_normal: normal.to_array(),
        face_normal: normal.to_array(),
        lit: Vec::new(),
        rays: None,
    };
    Some((point, vec![ColourSource { share: 1.0, position: hit.position, normal, given: None }]))
}

fn on_face(job: &Job, drawn: &DrawnObject, record: &Record, at: [f64; 2]) -> (ProbePoint, Vec<ColourSource>) {
    let object = &job.objects[drawn.object];
    let triangle = drawn.list.vertices(record.triangle);
    let PlanePoint { weights: in_scene, from_eye: relative } = drawn.plane_point(&job.view, triangle, at);
    let position = |vertex: u32| drawn.map.scene_point(drawn.points.at(vertex));
    let face: Vec<Corner> = face_corners(object, drawn, record).collect();
    let in_triangle = |weights: [f64; 3]| (triangle_corners(drawn, record).to_vec(), weights.to_vec());
    let (corners, weights): (Vec<Corner>, Vec<f64>) = match object.settings.interpolation {
        Interpolation::Scanline if face.len() > 3 => (face.clone(), scanline_weights(job, drawn, &face, at)),
        Interpolation::Perspective => in_triangle(in_scene),
        Interpolation::Affine | Interpolation::Scanline => {
            in_triangle(picture_weights(job, drawn, triangle, at))
        }
    };
    let normals = corners.iter().zip(&weights);
    let normal = normals.map(|(&corner, &weight)| object.exact_corner_normal(corner) * weight).sum();
    let face_normal = match object.has_face_normals() {
        true => object.exact_face_normal(record.face, record.turned),
        false => normal,
    };
    let at_corner = |&corner: &Corner, share: f64| ColourSource {
        share,
        position: position(corner.vertex) + job.view.origin,
        normal: object.exact_corner_normal(corner),
        given: match &object.colour {
            ObjectColour::Given(colours) => Some(colours[corner.vertex as usize]),
            ObjectColour::Lit(_) => None,
        },
    };
    let is_given = matches!(object.colour, ObjectColour::Given(_));
    let count = face.len() as f64;
    let sources = match object.settings.shading {
        Shading::Flat if takes_mean(object) => {
            face.iter().map(|corner| at_corner(corner, 1.0 / count)).collect()
        }
        Shading::Flat => {
            let sum: DVec3 = face.iter().map(|corner| position(corner.vertex)).sum();
            let position = sum / count + job.view.origin;
            vec![ColourSource { share: 1.0, position, normal: face_normal, given: None }]
        }
        Shading::Wireframe => Vec::new(),
        Shading::Phong | Shading::Exact | Shading::Traced if !is_given => {
            vec![ColourSource { share: 1.0, position: relative + job.view.eye, normal, given: None }]
        }
        _ => corners.iter().zip(&weights).map(|(corner, &weight)| at_corner(corner, weight)).collect(),
    };
    let point = ProbePoint {
        object: drawn.object,
        face: Some(record.face),
        front: record.front,
        vertices: corners.iter().map(|corner| corner.vertex).collect(),
        weights,
        position: (relative + job.view.eye).to_array(),
        distance: relative.dot(job.view.axes[2]),
        interpolated_normal: normal.to_array(),
        face_normal: face_normal.to_array(),
        lit: Vec::new(),
        rays: None,
    };
    (point, sources)
}

/// Barycentric coordinates on the picture, of what the near plane leaves of a triangle.
fn picture_weights(job: &Job, drawn: &DrawnObject, triangle: [u32; 3], at: [f64; 2]) -> [f64; 3] {
    let corner = |k: usize| ClipVertex {
        point: drawn.map.view(drawn.points.at(triangle[k])),
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

/// The weights of corners under the scanline algorithm: the value where that corner has 1 and others have 0.
fn scanline_weights(job: &Job, drawn: &DrawnObject, face: &[Corner], at: [f64; 2]) -> Vec<f64> {
    let weight = |indicated: usize| {
        let corners = face.iter().enumerate().map(|(k, corner)| {
            let value = DVec3::splat(if k == indicated { 1.0 } else { 0.0 });
            (drawn.map.view(drawn.points.at(corner.vertex)), value)
        });
        ScanPolygon::unsnapped(&job.view, corners).value(at).x
    };
    (0..face.len()).map(weight).collect()
}
