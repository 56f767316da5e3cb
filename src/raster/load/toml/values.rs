//! Colours, reflectances and transforms of scene files.

use crate::num::{LinearRgb, List, Srgb8};
use crate::raster::load::rotation::rotation;
use crate::shade::Reflectance;
use glam::{DMat4, DVec3};
use serde::Deserialize;

/// A colour: three linear components, one for a grey, or `"#rrggbb"` in sRGB.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "ColourValue")]
pub(super) struct Colour(pub(super) LinearRgb);

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected 3 linear components, 1 number for a grey, or \"#rrggbb\"")]
enum ColourValue {
    Grey(f64),
    Linear(List<f64, 3>),
    Code(String),
}

impl TryFrom<ColourValue> for Colour {
    type Error = &'static str;

    fn try_from(value: ColourValue) -> Result<Self, Self::Error> {
        let colour = match value {
            ColourValue::Grey(grey) => LinearRgb::grey(grey),
            ColourValue::Linear(components) => LinearRgb::from(components.0),
            ColourValue::Code(code) => {
                srgb(&code).ok_or("expected a colour: `[r, g, b]`, one number for a grey, or \"#80ff00\"")?
            }
        };
        // It is drawn in single precision.
        let is_allowed = |component| (0.0..=f64::from(f32::MAX)).contains(&component);
        match colour.to_array().into_iter().all(is_allowed) {
            true => Ok(Colour(colour)),
            false => Err("expected components that are not negative and at most 3.4e38"),
        }
    }
}

/// `#rrggbb`
fn srgb(code: &str) -> Option<LinearRgb> {
    let digits = code.strip_prefix('#').filter(|digits| digits.len() == 6 && digits.is_ascii())?;
    let [_, r, g, b] = u32::from_str_radix(digits, 16).ok()?.to_be_bytes();
    Some(Srgb8([r, g, b]).into())
}

/// A reflectance: a coefficient k of the material's colour, a colour K, or k and a colour.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(
    untagged,
    deny_unknown_fields,
    expecting = "expected a coefficient k, a colour K = k·O, none of its components negative, or `{ k = …, colour = … }`"
)]
pub(super) enum ReflectanceValue {
    Coefficient(f64),
    Merged(Colour),
    Split {
        k: f64,
        #[serde(alias = "color")]
        colour: Colour,
    },
}

impl ReflectanceValue {
    pub(super) fn of(self, colour: LinearRgb) -> Reflectance {
        match self {
            Self::Coefficient(k) => Reflectance::new(k, colour),
            Self::Merged(Colour(colour)) => Reflectance::Merged(colour),
            Self::Split { k, colour: Colour(colour) } => Reflectance::new(k, colour),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum Step {
    Scale(Scale),
    /// Degrees about x, then y, then z.
    Rotate(List<f64, 3>),
    Translate(List<f64, 3>),
    /// Rows of an affine map.
    Matrix(List<List<f64, 4>, 3>),
}

/// A factor for all axes, or one for each.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(untagged, expecting = "expected one factor for all axes, or 3")]
pub(super) enum Scale {
    Uniform(f64),
    Axes(List<f64, 3>),
}

impl Step {
    pub(super) fn matrix(self) -> DMat4 {
        match self {
            Step::Scale(Scale::Uniform(factor)) => DMat4::from_scale(DVec3::splat(factor)),
            Step::Scale(Scale::Axes(factors)) => DMat4::from_scale(factors.into()),
            Step::Rotate(degrees) => rotation(degrees.into()),
            Step::Translate(by) => DMat4::from_translation(by.into()),
            Step::Matrix(List([x, y, z])) => {
                DMat4::from_cols_array_2d(&[x.0, y.0, z.0, [0.0, 0.0, 0.0, 1.0]]).transpose()
            }
        }
    }
}
