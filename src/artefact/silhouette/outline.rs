//! Outlines of drawn surfaces and the distance between them.

use super::super::prelude::*;
use crate::metric::{Contour, ContourDistance, contour_distance};

pub(super) struct View {
    pub(super) size: u32,
    pub(super) camera: Camera,
    pub(super) light: Light,
}

pub(super) struct Outline {
    contour: Contour,
    /// Its pixels in one of the pictures.
    scale: f64,
}

impl View {
    /// Pictures have smooth edges, so that only corners of polygons are seen.
    const SAMPLES: Samples = Samples::Sixteen;
    /// Samples of outlines, and their width in pixels if they are not larger than four times the pictures.
    const OF_OUTLINES: Samples = Samples::Four;
    const WIDEST: u32 = 2048;

    pub(super) fn draw(&self, object: Object, shading: Shading) -> Result<Image> {
        let settings = RenderSettings { samples: Self::SAMPLES, ..settings([self.size; 2], shading) };
        draw(vec![object], std::slice::from_ref(&self.light), self.camera, settings)
    }

    /// How many of an outline's pixels are one of a picture, along a side.
    fn scale(&self) -> u32 {
        (Self::WIDEST / self.size).clamp(1, 4)
    }

    /// The tolerance of two outlines together, in pixels: each is found to 3/2 − √2 and a quarter of its own.
    pub(super) fn open(&self) -> f64 {
        2.0 * (1.5 - std::f64::consts::SQRT_2 + 0.25) / f64::from(self.scale())
    }

    pub(super) fn outline(&self, object: Object, shading: Shading) -> Result<Outline> {
        let scale = self.scale();
        let settings = RenderSettings {
            samples: Self::OF_OUTLINES,
            keep_linear: false,
            ..settings([scale * self.size; 2], shading)
        };
        let image = draw(vec![object], &[], self.camera, settings)?;
        Ok(Outline { contour: Contour::of(&image, Self::OF_OUTLINES), scale: scale.into() })
    }
}

impl Outline {
    /// How far it is from the true one, in pixels of the pictures.
    pub(super) fn distance(&self, truth: &Outline) -> Result<ContourDistance> {
        Ok(contour_distance(&self.contour, &truth.contour)?.scaled(1.0 / self.scale))
    }
}

/// The share of each pixel that only one of two pictures covers.
pub(super) fn between(image: &Image, truth: &Image) -> Image {
    let share = |(&a, &b): (&u8, &u8)| {
        (a.max(b) > 0).then(|| f64::from(a.abs_diff(b)) / View::SAMPLES.count() as f64)
    };
    let shares: Vec<Option<f64>> = image.coverage.iter().zip(&truth.coverage).map(share).collect();
    map(image.size, &shares, 1.0)
}
