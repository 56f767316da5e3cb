//! Pictures by formula.

use crate::raster::{Image, Pixels, Samples, Statistics};

/// A picture covered all over, grey by a function of the places of pixel centres.
pub(super) fn grey(size: [u32; 2], value: impl Fn(f64, f64) -> f64) -> Image {
    let count = (size[0] * size[1]) as usize;
    let centre = |pixel: u32| f64::from(pixel) + 0.5;
    let colour = |i: u32| [value(centre(i % size[0]), centre(i / size[0])) as f32; 3];
    Image {
        size,
        pixels: Pixels::Eight(vec![[0; 3]; count]),
        coverage: vec![1; count],
        linear: Some((0..count as u32).map(colour).collect()),
        objects: None,
        statistics: Statistics::default(),
    }
}

/// A white picture of a shape: each pixel is covered by those of its samples that are inside.
pub(super) fn shape(size: [u32; 2], samples: Samples, inside: impl Fn(f64, f64) -> bool) -> Image {
    let mut image = grey(size, |_, _| 1.0);
    for (i, coverage) in image.coverage.iter_mut().enumerate() {
        let corner = [i as u32 % size[0], i as u32 / size[0]].map(f64::from);
        let covered = samples.places().filter(|[x, y]| inside(corner[0] + x, corner[1] + y)).count();
        *coverage = covered as u8;
    }
    image
}
