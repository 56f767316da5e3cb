//! Everything about one pixel: what is seen at its samples, how each is lit, and what the picture shows.

use crate::num::{LinearRgb, Nine, NineEach};
use crate::raster::{ProbePoint, RenderError, RenderSettings, Scene, probe};
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
    Ok(())
}
