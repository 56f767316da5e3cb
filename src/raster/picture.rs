//! Finished pictures.

use std::time::Duration;

/// The numbers of a picture: red, green, blue of every pixel, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pixels {
    /// 8 bits a component.
    Eight(Vec<[u8; 3]>),
    /// 16 bits a component.
    Sixteen(Vec<[u16; 3]>),
}

/// A picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Its quantised colours.
    pub pixels: Pixels,
    /// The number of samples of each pixel that an object covers, also invisible faces of a wireframe.
    pub coverage: Vec<u8>,
    /// Linear colours, the mean of a pixel's samples, with [`RenderSettings::keep_linear`](crate::raster::RenderSettings::keep_linear).
    pub linear: Option<Vec<[f32; 3]>>,
    /// With [`RenderSettings::keep_objects`](crate::raster::RenderSettings::keep_objects), a number of each pixel: two pixels have the same
    /// number if their samples show the same objects. With one sample a pixel: 0 for the background, 1 + the object's number.
    pub objects: Option<Vec<u32>>,
    /// What was done.
    pub statistics: Statistics,
}

/// Knuth's multiplicative hash (The Art of Computer Programming 3, 6.4), so that orders of samples differ.
const SPREAD: u32 = 2_654_435_769;

/// The number of a pixel with one more sample, of an object or the background.
pub(super) fn with_sample(number: u32, object: Option<u32>) -> u32 {
    number.wrapping_mul(SPREAD).wrapping_add(object.map_or(0, |object| object + 1))
}

impl Image {
    /// The number in [`objects`](Self::objects) of pixels of which all samples show an object.
    pub(crate) fn number_of(object: usize, samples: usize) -> u32 {
        (0..samples).fold(0, |number, _| with_sample(number, Some(object as u32)))
    }

    /// Where in the lists a pixel is; `None` outside the picture.
    pub fn index(&self, x: u32, y: u32) -> Option<usize> {
        (x < self.size[0] && y < self.size[1]).then(|| y as usize * self.size[0] as usize + x as usize)
    }

    /// The colour of a pixel as 8-bit numbers (of 16-bit ones the upper half); `None` outside the picture.
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        let index = self.index(x, y)?;
        Some(match &self.pixels {
            Pixels::Eight(pixels) => pixels[index],
            Pixels::Sixteen(pixels) => pixels[index].map(|component| (component >> 8) as u8),
        })
    }
}

/// Counts and times of a drawing. Only the times differ from run to run.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Statistics {
    /// Pixels with a covered sample; under [`Shading::Wireframe`](crate::raster::Shading::Wireframe) those that show an edge.
    pub covered_pixels: u64,
    /// Triangles handed to the tiles.
    pub triangles_drawn: u64,
    /// Among them, those cut by the near plane or the guard band.
    pub triangles_clipped: u64,
    /// Triangles that are not drawn: culled, without area on the picture, between samples, or out of sight.
    pub triangles_culled: u64,
    /// Rays of a traced picture: of the camera that meet something, reflected and refracted ones, and shadow rays.
    pub rays: u64,
    /// The mean share of light of a covered sample that the limits of rays cut off, between 0 and 1 unless materials add light.
    pub light_cut: f64,
    /// Times of the stages.
    #[serde(rename = "seconds")]
    pub times: Times,
}

/// How long the stages took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Times {
    /// Cutting polygons into triangles and placing vertices on the picture.
    #[serde(serialize_with = "as_seconds")]
    pub geometry: Duration,
    /// Sorting triangles into tiles.
    #[serde(serialize_with = "as_seconds")]
    pub binning: Duration,
    /// Visibility, shading and output, tile by tile.
    #[serde(serialize_with = "as_seconds")]
    pub tiles: Duration,
}

fn as_seconds<S: serde::Serializer>(time: &Duration, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(time.as_secs_f64())
}
