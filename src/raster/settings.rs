//! The settings that change the picture.

use crate::num::{Degrees, LinearRgb, Transfer, names};
use crate::raster::view::fixed_point::{GUARD, HALF, ONE};
use crate::shade::{DepthCue, Guards, Terminator, ToneRule};
use serde::Deserialize;

pub(super) const LARGEST_SIDE: u32 = GUARD as u32;

/// Where a surface's colour is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shading {
    /// Once a face, with the face's normal (F18).
    Flat,
    /// At the corners of each face; colours are interpolated (Gouraud 1971; F19, F23).
    Gouraud,
    /// At every sample, with the interpolated normal (Phong 1975; F22).
    #[default]
    Phong,
    /// Nowhere: the edges of the faces are drawn as lines.
    Wireframe,
    /// At every sample, with position and normal of the analytic surface of the object, by casting a ray. An object
    /// without an analytic surface is an error.
    Exact,
    /// At every sample, with shadows, reflection and refraction, by tracing rays (Whitted 1980). Faces are lit with their
    /// interpolated normals as by [`Phong`](Self::Phong); objects may ask for [`Flat`](Self::Flat) or [`Exact`](Self::Exact).
    Traced,
}

/// How values at the corners of a face spread over it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Interpolation {
    /// Along the edges of the polygon, then along the scanline between them, on the picture (Gouraud 1971; F19). The
    /// colours of a face of four corners or more change when it rotates; in triangles it is [`Affine`](Self::Affine).
    Scanline,
    /// Barycentric on the triangles that a face is cut into, on the picture. It depends on the cut, not on the rotation
    /// of the face, and ignores perspective.
    Affine,
    /// Barycentric on the triangles, in the scene: right under perspective.
    #[default]
    Perspective,
}

names! { Interpolation: Scanline = "scanline", Affine = "affine", Perspective = "perspective" }

/// Where a flat face is lit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FlatSample {
    /// At the mean of its corners, with the face's normal.
    #[default]
    Centroid,
    /// The mean of the colours of its corners under [`Shading::Gouraud`] (exercise 1.6.25).
    VertexMean,
}

/// Which faces are not drawn; wireframes omit the edges that only these have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cull {
    /// None.
    #[default]
    None,
    /// Those seen from behind.
    Back,
    /// Those seen from the front.
    Front,
}

impl Cull {
    /// Whether a face stays that is seen from the front, or else from behind.
    #[inline(always)]
    pub(super) fn keeps(self, is_front: bool) -> bool {
        is_front & (self != Cull::Front) | !is_front & (self != Cull::Back)
    }
}

/// What is shown of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Show {
    /// Its colour under the scene's lights.
    #[default]
    Shaded,
    /// Its interpolated unit normal n in the scene's axes, as (n + 1)/2.
    Normals,
    /// Which side is seen: front faces light blue, back faces dark red. They are darker where the interpolated normal is at a
    /// larger angle to the camera's axis, so that the shape is visible.
    Facing,
    /// Distance along the camera's axis: white at the nearest vertex of the scene, black at the farthest.
    Depth,
    /// A colour for each face.
    FaceId,
    /// The angle between the interpolated normal and that of the object's analytic surface, else that of the face. Black at 0, over
    /// red and yellow to white at the given angle and above.
    Deviation(Degrees),
}

/// How lines are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineStyle {
    /// Their colour.
    pub colour: LinearRgb,
    /// Their width in pixels, above 0.
    pub width: f64,
    /// Whether lines behind surfaces are hidden.
    pub hide: bool,
}

impl Default for LineStyle {
    /// White, one pixel wide, hidden lines removed.
    fn default() -> Self {
        Self { colour: LinearRgb::WHITE, width: 1.0, hide: true }
    }
}

/// Bits of each component of the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Bits {
    /// 256 steps.
    #[default]
    Eight,
    /// 65 536 steps.
    Sixteen,
}

impl Bits {
    /// How many there are.
    pub fn count(self) -> u8 {
        match self {
            Self::Eight => 8,
            Self::Sixteen => 16,
        }
    }
}

/// The number of samples of each pixel. Each sample is shaded separately; the pixel is the mean of its samples.
///
/// Positions are in 256ths of a pixel from its upper left corner, in multiples of 16. One sample is at the centre; 4, 8
/// and 16 are the standard patterns of Direct3D 11 (`D3D11_STANDARD_MULTISAMPLE_PATTERN`), in which no two samples
/// share a row or a column.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Samples {
    /// The centre.
    #[default]
    One,
    /// Four, as a rotated square.
    Four,
    /// Eight.
    Eight,
    /// Sixteen.
    Sixteen,
}

// Pairs of x and y, in sixteenths of a pixel from its centre.
const FOUR: [i32; 8] = [-2, -6, 6, -2, -6, 2, 2, 6];
const EIGHT: [i32; 16] = [1, -3, -1, 3, 5, 1, -3, -5, -5, 5, -7, -1, 3, 7, 7, -7];
const SIXTEEN: [i32; 32] = [
    1, 1, -1, -3, -3, 2, 4, -1, -5, -2, 2, 5, 5, 3, 3, -5, -2, 6, 0, -7, -4, -6, -6, 4, -8, 0, 7, -4, 6, 7,
    -7, -8,
];

impl Samples {
    /// The pattern with this many samples: 1, 4, 8 or 16.
    pub fn new(count: usize) -> Option<Self> {
        [Self::One, Self::Four, Self::Eight, Self::Sixteen]
            .into_iter()
            .find(|samples| samples.count() == count)
    }

    /// How many samples a pixel has.
    pub fn count(self) -> usize {
        self.pattern().len()
    }

    /// The places, in pixels from a pixel's upper left corner.
    pub fn places(self) -> impl ExactSizeIterator<Item = [f64; 2]> {
        self.offsets().map(|place| place.map(|x| f64::from(x) / f64::from(ONE)))
    }

    /// The same, in 256ths of a pixel.
    pub(super) fn offsets(self) -> impl ExactSizeIterator<Item = [i32; 2]> {
        self.pattern().iter().map(|place| place.map(|x| HALF + x * ONE / 16))
    }

    fn pattern(self) -> &'static [[i32; 2]] {
        let numbers: &[i32] = match self {
            Self::One => &[0, 0],
            Self::Four => &FOUR,
            Self::Eight => &EIGHT,
            Self::Sixteen => &SIXTEEN,
        };
        numbers.as_chunks().0
    }
}

/// The limits of [`Shading::Traced`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TraceSettings {
    /// Most reflections and refractions along a path, 0 to [`MOST_DEPTH`](Self::MOST_DEPTH).
    pub depth: u32,
    /// Rays with a smaller share of the colour of the sample are not followed: 0 to 1.
    pub weight: f64,
    /// Shadow rays to an area light; 1 to a point or directional light. 0 for no shadows.
    pub shadow_samples: u32,
}

impl TraceSettings {
    /// The largest depth.
    pub const MOST_DEPTH: u32 = 64;
    /// The most shadow rays to an area light.
    pub const MOST_SHADOW_SAMPLES: u32 = 4096;
}

impl Default for TraceSettings {
    fn default() -> Self {
        Self { depth: 8, weight: 1e-3, shadow_samples: 16 }
    }
}

/// Everything about a picture that is not in the scene. The number of threads is not here: drawing uses the current
/// thread pool of rayon, and the picture has the same bytes at any number of threads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderSettings {
    /// Width and height in pixels, 1 to 16384 each.
    pub size: [u32; 2],
    /// Where colours are computed.
    pub shading: Shading,
    /// How they, or normals, spread over faces.
    pub interpolation: Interpolation,
    /// Where flat faces are lit.
    pub flat_sample: FlatSample,
    /// How many samples each pixel has.
    pub samples: Samples,
    /// Faces that are not drawn.
    pub cull: Cull,
    /// Light faces seen from behind on that side: their normals are flipped.
    pub two_sided: bool,
    /// What is shown.
    pub show: Show,
    /// Take the viewer as infinitely far away when lighting, whatever the camera; a parallel projection always does.
    pub infinite_viewer: bool,
    /// The guards of the lighting formulas.
    pub guards: Guards,
    /// The treatment of light that reaches a face from behind, under [`Shading::Phong`] only. Gouraud shading lights
    /// corners, which several faces share, and flat shading has no normal but that of the face.
    pub terminator: Terminator,
    /// Fading with the distance to the viewer.
    pub depth_cue: Option<DepthCue>,
    /// The treatment of colours out of range.
    pub tone: ToneRule,
    /// How linear colours become numbers.
    pub transfer: Transfer,
    /// The bits of each component.
    pub bits: Bits,
    /// Keep the linear colours too, at 12 more bytes a pixel.
    pub keep_linear: bool,
    /// Keep which objects each pixel shows, at 4 more bytes a pixel.
    pub keep_objects: bool,
    /// The lines of [`Shading::Wireframe`].
    pub wire: LineStyle,
    /// The limits of [`Shading::Traced`].
    pub tracing: TraceSettings,
}

impl Default for RenderSettings {
    fn default() -> Self {
        Self {
            size: [640, 480],
            shading: Shading::default(),
            interpolation: Interpolation::default(),
            flat_sample: FlatSample::default(),
            samples: Samples::default(),
            cull: Cull::default(),
            two_sided: false,
            show: Show::default(),
            infinite_viewer: false,
            guards: Guards::default(),
            terminator: Terminator::default(),
            depth_cue: None,
            tone: ToneRule::default(),
            transfer: Transfer::default(),
            bits: Bits::default(),
            keep_linear: false,
            keep_objects: false,
            wire: LineStyle::default(),
            tracing: TraceSettings::default(),
        }
    }
}

/// Settings of one object in place of those of the picture; `None` keeps these. A wireframe is one of all objects, and so is
/// a traced picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ObjectSettings {
    /// Where its colours are computed; [`Shading::Wireframe`] and [`Shading::Traced`] are errors. In a traced picture
    /// only [`Shading::Flat`] and [`Shading::Exact`] count.
    pub shading: Option<Shading>,
    /// How they, or normals, spread over its faces.
    pub interpolation: Option<Interpolation>,
    /// Whether its faces are lit on both sides.
    pub two_sided: Option<bool>,
}

impl RenderSettings {
    /// The settings that an object is drawn with.
    pub(super) fn of(&self, object: &ObjectSettings) -> Self {
        let shading = object.shading.filter(|own| match self.shading {
            Shading::Wireframe => false,
            Shading::Traced => matches!(own, Shading::Flat | Shading::Exact),
            _ => true,
        });
        Self {
            shading: shading.unwrap_or(self.shading),
            interpolation: object.interpolation.unwrap_or(self.interpolation),
            two_sided: object.two_sided.unwrap_or(self.two_sided),
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_samples_share_a_row_or_column() {
        for (samples, count) in
            [(Samples::One, 1), (Samples::Four, 4), (Samples::Eight, 8), (Samples::Sixteen, 16)]
        {
            assert_eq!(Samples::new(count), Some(samples));
            for axis in 0..2 {
                let mut places: Vec<i32> = samples.offsets().map(|place| place[axis]).collect();
                places.sort_unstable();
                places.dedup();
                assert_eq!(places.len(), count);
                assert!(places.iter().all(|place| (0..ONE).contains(place)));
            }
        }
        assert_eq!(Samples::new(2), None);
        assert_eq!(Samples::One.places().next(), Some([0.5, 0.5]));
    }
}
