//! The angle between the normals and others: pixel by pixel as a picture, and corner by corner as numbers.

use crate::laboratory::Result;
use crate::pictures::{draw_scene, scene};
use crate::subject::Subject;
use crate::view::View;
use crease::num::{Degrees, LinearRgb, Transfer, angle_between, viridis};
use crease::raster::{Image, RenderSettings, Shading, Show};
use glam::DVec3;
use serde_json::{Value, json};

/// The background of a map, which no colour of the map resembles.
const BACKGROUND: LinearRgb = LinearRgb::grey(0.07);

/// The angle in colours from dark violet for none over green to yellow: between interpolated normals, or to the normal of the
/// analytic surface that is visible at the same pixel.
pub(crate) fn picture(subject: &mut Subject, view: &View) -> Result<Vec<u8>> {
    let is_cast = view.against == "exact" && subject.surface.is_some();
    let own = normals(&scene(subject, &subject.fields, view), view, Shading::Phong)?;
    let other = if is_cast {
        normals(&scene(subject, &subject.fields, view), view, Shading::Exact)?
    } else {
        let fields = others(subject, view)?;
        normals(&scene(subject, &fields, view), view, Shading::Phong)?
    };
    let most = view.most.max(1e-6);
    let code = |colour: LinearRgb| {
        let [r, g, b] = colour.to_array().map(|component| Transfer::Srgb.to_u8(component));
        [r, g, b, 255]
    };
    let pixels =
        (0..own.coverage.len()).flat_map(|pixel| match [&own, &other].map(|image| at(image, pixel)) {
            [Some(a), Some(b)] => code(viridis(Degrees::from(angle_between(a, b)).0 / most)),
            _ => code(BACKGROUND),
        });
    Ok(pixels.collect())
}

/// A copy of the other normals, so that the mesh can be lent at the same time.
fn others(subject: &mut Subject, view: &View) -> Result<Vec<crease::normals::NormalField>> {
    if view.against == "exact" && !subject.has_truth() {
        return Err("no-exact".to_owned());
    }
    Ok(subject.others(view).ok_or("no-stored")?.to_vec())
}

fn normals(scene: &crease::raster::Scene, view: &View, shading: Shading) -> Result<Image> {
    let settings = RenderSettings { show: Show::Normals, keep_linear: true, ..view.settings(shading) };
    draw_scene(scene, &settings)
}

/// The normal that a pixel shows, if it shows one.
fn at(image: &Image, pixel: usize) -> Option<DVec3> {
    let colour = image.linear.as_ref()?.get(pixel).filter(|_| image.coverage[pixel] > 0)?;
    Some(DVec3::from(colour.map(f64::from)) * 2.0 - 1.0)
}

/// The root mean square and the largest angle over all corners, in degrees.
pub(crate) fn numbers(subject: &mut Subject, view: &View) -> Result<Value> {
    let others = match others(subject, view) {
        Ok(others) => others,
        Err(reason) => return Ok(json!({ "missing": reason })),
    };
    let (mut sum, mut largest, mut count) = (0.0, 0.0_f64, 0_usize);
    for ((part, own), other) in subject.loaded.parts.iter().zip(&subject.fields).zip(&others) {
        for (corner, &vertex) in part.mesh.faces().corners().iter().enumerate() {
            let Some((a, b)) = own.normals.get(corner, vertex).zip(other.normals.get(corner, vertex)) else {
                continue;
            };
            let angle = Degrees::from(angle_between(*a, *b)).0;
            sum += angle * angle;
            largest = largest.max(angle);
            count += 1;
        }
    }
    Ok(json!({ "rms": libm::sqrt(sum / count.max(1) as f64), "largest": largest, "corners": count }))
}
