//! Everything about one pixel: what is seen at its samples, how each is lit, and what the picture shows.

use crate::num::{LinearRgb, Nine, NineEach};
use crate::raster::{ProbePoint, RayNode, RenderError, RenderSettings, Scene, ShadowTest, probe};
use serde::Serialize;
use std::fmt;

/// The numbers behind one pixel, computed again in double precision by the formulas of the picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PixelReport {
    /// Column and row, from 0 at the upper left.
    pub pixel: [u32; 2],
    /// Its samples.
    pub samples: Vec<SampleReport>,
    /// The mean of their linear colours, before the tone rule.
    pub linear: [f64; 3],
    /// That after tone rule and transfer, as 8-bit codes.
    pub computed: [u8; 3],
    /// The picture's own codes.
    pub picture: [u8; 3],
}

/// One sample of a pixel.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SampleReport {
    /// Where it is, in pixels from the picture's upper left corner.
    pub place: [f64; 2],
    /// What is seen there; nothing but the background if absent.
    #[serde(flatten)]
    pub seen: Option<ProbePoint>,
    /// Its linear colour, before the tone rule.
    pub colour: [f64; 3],
}

/// Explains a pixel, given what the picture shows there.
///
/// # Errors
/// As [`render`](crate::raster::render()), and for a pixel outside the picture.
pub fn probe_pixel(
    scene: &Scene,
    settings: &RenderSettings,
    pixel: [u32; 2],
    picture: [u8; 3],
) -> Result<PixelReport, RenderError> {
    let mut samples = Vec::with_capacity(settings.samples.count());
    for (number, place) in settings.samples.places().enumerate() {
        let seen = probe(scene, settings, pixel, number)?;
        let colour = seen.as_ref().map_or(scene.background, ProbePoint::colour);
        samples.push(SampleReport {
            place: [0, 1].map(|axis| f64::from(pixel[axis]) + place[axis]),
            seen,
            colour: colour.to_array(),
        });
    }
    let share = 1.0 / samples.len() as f64;
    let sum = samples.iter().fold(LinearRgb::BLACK, |sum, sample| sum + LinearRgb::from(sample.colour));
    let linear = (sum * share).to_array();
    let computed = settings.tone.apply(linear).map(|component| settings.transfer.to_u8(component));
    Ok(PixelReport { pixel, samples, linear, computed, picture })
}

impl PixelReport {
    fn central(&self) -> Option<&SampleReport> {
        let offset = |sample: &&SampleReport| -> f64 {
            let squared = |axis: usize| {
                let d = sample.place[axis] - f64::from(self.pixel[axis]) - 0.5;
                d * d
            };
            squared(0) + squared(1)
        };
        self.samples.iter().min_by(|a, b| offset(a).total_cmp(&offset(b)))
    }
}

impl fmt::Display for PixelReport {
    /// The sample nearest to the middle of the pixel in full, then the pixel as a whole.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [x, y] = self.pixel;
        writeln!(f, "pixel        ({x}, {y})")?;
        if let Some(sample) = self.central() {
            match self.samples.len() {
                1 => {}
                count => writeln!(f, "sample       ({}, {}), of {count}", sample.place[0], sample.place[1])?,
            }
            match &sample.seen {
                Some(point) => write_point(f, point)?,
                None => writeln!(f, "visible      background only")?,
            }
            if self.samples.len() > 1 {
                writeln!(f, "sample's sum {}", NineEach(sample.colour))?;
            }
        }
        writeln!(f, "pixel's sum  {}", NineEach(self.linear))?;
        writeln!(f, "8-bit        {:?}, in the picture {:?}", self.computed, self.picture)
    }
}

fn write_point(f: &mut fmt::Formatter, point: &ProbePoint) -> fmt::Result {
    let side = if point.front { "front" } else { "back" };
    let object = point.object;
    match point.face {
        Some(face) => writeln!(f, "visible      object {object}, face {face}, its {side}")?,
        None => writeln!(f, "visible      object {object}, an analytic surface, its {side}")?,
    }
    for (vertex, weight) in point.vertices.iter().zip(&point.weights) {
        writeln!(f, "  vertex {:<4} weight {}", vertex, Nine(*weight))?;
    }
    writeln!(f, "at           {}, {} along the axis", NineEach(point.position), Nine(point.distance))?;
    writeln!(f, "face normal  {}", NineEach(point.face_normal))?;
    writeln!(f, "normal       {}, as interpolated", NineEach(point.interpolated_normal))?;
    for lit in &point.lit {
        if point.lit.len() > 1 {
            writeln!(f, "with share   {}:", Nine(lit.share))?;
        }
        if let Some(given) = lit.given {
            writeln!(f, "given        {}", NineEach(given))?;
        }
        if let Some(light) = &lit.light {
            writeln!(f, "{light}")?;
        }
    }
    match &point.rays {
        Some(rays) => {
            writeln!(f, "rays")?;
            write_ray(f, rays, 1)
        }
        None => Ok(()),
    }
}

/// A ray and those that go on from its hit, each level indented by two more blanks.
fn write_ray(f: &mut fmt::Formatter, ray: &RayNode, level: usize) -> fmt::Result {
    let indent = "  ".repeat(level);
    writeln!(f, "{indent}{:<11}share {}", ray.kind, NineEach(ray.share))?;
    writeln!(f, "{indent}  direction {}", NineEach(ray.direction))?;
    if ray.transmittance != [1.0; 3] {
        writeln!(f, "{indent}  absorbed to {}", NineEach(ray.transmittance))?;
    }
    match &ray.hit {
        None => writeln!(f, "{indent}  meets     the background")?,
        Some(hit) => {
            let side = if hit.front { "front" } else { "back" };
            let face = hit.face.map(|face| format!(", face {face}")).unwrap_or_default();
            let distance = Nine(hit.distance);
            writeln!(f, "{indent}  meets     object {}{face}, its {side}, after {distance}", hit.object)?;
            writeln!(f, "{indent}  at        {}", NineEach(hit.position))?;
            writeln!(f, "{indent}  N         {}", NineEach(hit.normal))?;
            for ShadowTest { light, visible } in &hit.shadows {
                writeln!(f, "{indent}  light {light:<4}visible {}", NineEach(*visible))?;
            }
            writeln!(f, "{indent}  local     {}", NineEach(hit.local))?;
            if let (Some([before, after]), Some(share)) = (hit.indices, hit.fresnel) {
                writeln!(f, "{indent}  Fresnel   {} from index {before} to {after}", Nine(share))?;
            }
            if hit.cut > 0.0 {
                writeln!(f, "{indent}  cut off   {} of the light of the sample", Nine(hit.cut))?;
            }
            hit.rays.iter().try_for_each(|ray| write_ray(f, ray, level + 1))?;
        }
    }
    writeln!(f, "{indent}  colour    {}", NineEach(ray.colour))
}
