//! Everything about one pixel: what is seen at its samples, how each is lit, and what the picture shows.

use crate::num::{LinearRgb, Nine, NineEach};
use crate::raster::{ProbePoint, RenderError, RenderSettings, Scene, probe};
use crate::shade::Explanation;
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
    pub seen: Option<SeenReport>,
    /// Its linear colour, before the tone rule.
    pub colour: [f64; 3],
}

/// What a sample sees. Objects, faces and vertices are counted from 0, in the text for people from 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SeenReport {
    /// The object.
    pub object: usize,
    /// The face; absent on an analytic surface.
    pub face: Option<u32>,
    /// Whether its front is seen.
    pub front: bool,
    /// The vertices that values are interpolated between.
    pub vertices: Vec<u32>,
    /// The weight of each.
    pub weights: Vec<f64>,
    /// The point that is seen, in the scene.
    pub position: [f64; 3],
    /// Distance along the camera's axis.
    pub distance: f64,
    /// The interpolated normal, not renormalised.
    pub interpolated_normal: [f64; 3],
    /// The face's normal.
    pub face_normal: [f64; 3],
    /// The points that are lit for this sample.
    pub lit: Vec<LitReport>,
}

/// One point that is lit, or has a given colour.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LitReport {
    /// Its share of the sample's colour.
    pub share: f64,
    /// Its colour, if that is given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub given: Option<[f64; 3]>,
    /// How its light comes about, if it is lit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub light: Option<Explanation>,
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
        let colour = match &seen {
            Some(point) => point.colour(scene, settings)?,
            None => scene.background,
        };
        samples.push(SampleReport {
            place: [0, 1].map(|axis| f64::from(pixel[axis]) + place[axis]),
            seen: seen.map(|point| SeenReport::new(&point, scene, settings)).transpose()?,
            colour: colour.to_array(),
        });
    }
    let share = 1.0 / samples.len() as f64;
    let sum = samples.iter().fold(LinearRgb::BLACK, |sum, sample| sum + LinearRgb::from(sample.colour));
    let linear = (sum * share).to_array();
    let computed = settings.tone.apply(linear).map(|component| settings.transfer.to_u8(component));
    Ok(PixelReport { pixel, samples, linear, computed, picture })
}

impl SeenReport {
    fn new(point: &ProbePoint, scene: &Scene, settings: &RenderSettings) -> Result<Self, RenderError> {
        let mut explained = point.explain(scene, settings)?.into_iter();
        let lit = point.lit.iter().map(|lit| LitReport {
            share: lit.share,
            given: lit.given.map(LinearRgb::to_array),
            light: explained.next(),
        });
        Ok(Self {
            object: point.object,
            face: point.face,
            front: point.front,
            vertices: point.vertices.clone(),
            weights: point.weights.clone(),
            position: point.position.to_array(),
            distance: point.distance,
            interpolated_normal: point.normal.to_array(),
            face_normal: point.face_normal.to_array(),
            lit: lit.collect(),
        })
    }
}

impl PixelReport {
    /// The sample nearest to the middle of the pixel.
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
                Some(seen) => write!(f, "{seen}")?,
                None => writeln!(f, "seen         nothing but the background")?,
            }
            if self.samples.len() > 1 {
                writeln!(f, "sample's sum {}", NineEach(sample.colour))?;
            }
        }
        writeln!(f, "pixel's sum  {}", NineEach(self.linear))?;
        writeln!(f, "8-bit        {:?}, in the picture {:?}", self.computed, self.picture)
    }
}

impl fmt::Display for SeenReport {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let side = if self.front { "front" } else { "back" };
        match self.face {
            Some(face) => {
                let counted = "counted from 1; in JSON from 0";
                writeln!(
                    f,
                    "seen         object {}, face {}, its {side} ({counted})",
                    self.object + 1,
                    face + 1
                )?
            }
            None => writeln!(f, "seen         object {}, an analytic surface, its {side}", self.object + 1)?,
        }
        for (vertex, weight) in self.vertices.iter().zip(&self.weights) {
            writeln!(f, "  vertex {:<4} weight {}", vertex + 1, Nine(*weight))?;
        }
        writeln!(f, "at           {}, {} along the axis", NineEach(self.position), Nine(self.distance))?;
        writeln!(f, "face normal  {}", NineEach(self.face_normal))?;
        writeln!(f, "normal       {}, as interpolated", NineEach(self.interpolated_normal))?;
        let many = self.lit.len() > 1;
        for lit in &self.lit {
            if many {
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
}
