//! Pictures of the mesh as RGBA, and the numbers of a pixel.

use crate::deviation;
use crate::laboratory::{Result, value};
use crate::subject::Subject;
use crate::view::View;
use crease::num::{LinearRgb, Radians};
use crease::raster::{
    Camera, Image, Object, Pixels, Projection, RenderSettings, Scene, Shading, Shape, render,
};
use crease::report::{Overlay, overlay, probe_pixel};
use glam::{DMat4, DVec3};
use serde::Deserialize;
use serde_json::{Value, json};

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Kind {
    Flat,
    Gouraud,
    Phong,
    /// The analytic surface.
    Exact,
    /// The angle to other normals.
    Deviation,
}

impl Kind {
    pub(crate) fn shading(self) -> Shading {
        match self {
            Kind::Flat => Shading::Flat,
            Kind::Gouraud => Shading::Gouraud,
            Kind::Phong | Kind::Deviation => Shading::Phong,
            Kind::Exact => Shading::Exact,
        }
    }
}

const BACKGROUND: LinearRgb = LinearRgb::grey(0.015);

/// The mesh with some normals, seen and lit as a view asks.
pub(crate) fn scene<'a>(
    subject: &'a Subject,
    fields: &'a [crease::normals::NormalField],
    view: &View,
) -> Scene<'a> {
    let material = view.material();
    let object = |(part, transform): (usize, DMat4)| {
        let shape = Shape::Mesh { mesh: &subject.loaded.parts[part].mesh, normals: &fields[part] };
        Object { transform, surface: subject.surface, ..Object::new(shape, material) }
    };
    let camera = view.camera(subject.centre, subject.radius);
    let lights = view.lights(&camera).to_vec();
    let objects = subject.places().into_iter().map(object).collect();
    Scene { objects, lines: Vec::new(), lights, camera, background: BACKGROUND }
}

/// Draws pictures: a buffer for each that there is. The answer has a size for each, or the reason why there is no picture,
/// and the places of marks on the picture.
pub(crate) fn draw(subject: &mut Subject, view: &View, kinds: &[Kind], marks: &[[f64; 3]]) -> Result {
    let [width, height] = view.size;
    if !(1..=2048).contains(&width) || !(1..=2048).contains(&height) {
        return Err(format!("a picture of {width}×{height} pixels; give 1 to 2048"));
    }
    let mut buffers = Vec::new();
    let mut pictures = Vec::new();
    for &kind in kinds {
        let drawn = match kind {
            Kind::Exact if subject.surface.is_none() => Err("no-exact".to_owned()),
            Kind::Deviation => deviation::picture(subject, view),
            _ => shaded(subject, view, kind),
        };
        pictures.push(match &drawn {
            Ok(_) => json!({ "size": view.size, "buffer": buffers.len() }),
            Err(reason) => json!({ "missing": reason }),
        });
        buffers.extend(drawn.ok());
    }
    let camera = view.camera(subject.centre, subject.radius);
    let places: Vec<_> =
        marks.iter().map(|&mark| on_picture(&camera, view.size, DVec3::from(mark))).collect();
    Ok((json!({ "pictures": pictures, "marks": places }), buffers))
}

fn shaded(subject: &Subject, view: &View, kind: Kind) -> Result<Vec<u8>> {
    let mut scene = scene(subject, &subject.fields, view);
    let overlays =
        [(view.wire, Overlay::Wire), (view.creases, Overlay::Creases), (view.hairs, Overlay::VertexNormals)];
    for (_, lines) in overlays.into_iter().filter(|&(wanted, _)| wanted && kind != Kind::Exact) {
        scene.lines.extend(overlay(&scene, view.size, lines));
    }
    Ok(rgba(&draw_scene(&scene, &view.settings(kind.shading()))?))
}

pub(crate) fn draw_scene(scene: &Scene, settings: &RenderSettings) -> Result<Image> {
    render(scene, settings).map_err(|error| error.to_string())
}

/// The pixels of a picture with an opacity, as a canvas takes them.
pub(crate) fn rgba(image: &Image) -> Vec<u8> {
    let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
    match &image.pixels {
        Pixels::Eight(pixels) => pixels.iter().flat_map(|&pixel| opaque(pixel)).collect(),
        Pixels::Sixteen(pixels) => {
            pixels.iter().flat_map(|pixel| opaque(pixel.map(|code| (code >> 8) as u8))).collect()
        }
    }
}

/// Where a point is on the picture, in pixels from its upper left corner; `None` behind the viewer.
pub(crate) fn on_picture(camera: &Camera, size: [u32; 2], point: DVec3) -> Option<[f64; 2]> {
    let [right, up, forward] = camera.axes().ok()?;
    let [width, height] = size.map(f64::from);
    let offset = point - camera.eye;
    let depth = offset.dot(forward);
    let half = match camera.projection {
        Projection::Perspective(_) if depth <= 0.0 => return None,
        Projection::Perspective(Radians(angle)) => depth * libm::tan(0.5 * angle),
        Projection::Orthographic(height) => 0.5 * height,
    };
    let scale = 0.5 * height / half;
    Some([0.5 * width + scale * offset.dot(right), 0.5 * height - scale * offset.dot(up)])
}

/// The numbers of a pixel: as text, as JSON, and the vectors at the point as arrows on the picture.
pub(crate) fn probe(subject: &Subject, view: &View, kind: Kind, pixel: [u32; 2]) -> Result<Value> {
    if kind == Kind::Exact && subject.surface.is_none() {
        return Err("this mesh has no analytic surface".to_owned());
    }
    let scene = scene(subject, &subject.fields, view);
    probe_scene(&scene, &view.settings(kind.shading()), pixel, 0.45 * subject.radius)
}

/// The same of any scene; arrows have this length.
pub(crate) fn probe_scene(
    scene: &Scene,
    settings: &RenderSettings,
    pixel: [u32; 2],
    length: f64,
) -> Result<Value> {
    let image = draw_scene(scene, settings)?;
    let Some(code) = image.pixel(pixel[0], pixel[1]) else {
        return Err(format!("the picture has no pixel ({}, {})", pixel[0], pixel[1]));
    };
    let report = probe_pixel(scene, settings, pixel, code).map_err(|error| error.to_string())?;
    let seen = report.samples.first().and_then(|sample| sample.seen.as_ref());
    let mut arrows = Vec::new();
    if let Some(point) = seen {
        // Under Gouraud shading, of the vertex with the largest share, and drawn there.
        let heaviest =
            point.lit.iter().filter(|lit| lit.light.is_some()).max_by(|a, b| a.share.total_cmp(&b.share));
        let lit = heaviest.and_then(|lit| lit.light.as_ref());
        let from = DVec3::from(lit.map_or(point.position, |lit| lit.position));
        let mut arrow = |name: &str, towards: [f64; 3]| {
            let ends = [from, from + DVec3::from(towards) * length];
            let [from, to] = ends.map(|end| on_picture(&scene.camera, settings.size, end));
            arrows.extend(from.zip(to).map(|(from, to)| json!({ "name": name, "from": from, "to": to })));
        };
        if let Some(light) = lit {
            arrow("N", light.normal);
            arrow("V", light.view);
            if let Some(lamp) = light.lights.first() {
                arrow("L", lamp.towards);
                arrow("R", lamp.reflected);
                lamp.half.into_iter().for_each(|half| arrow("H", half));
            }
        }
    }
    Ok(json!({ "text": report.to_string(), "report": value(&report)?, "arrows": arrows }))
}
