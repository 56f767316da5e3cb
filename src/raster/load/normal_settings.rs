//! How the normals of an object are computed and stored.

use crate::io::NormalFormat;
use crate::mesh::Mesh;
use crate::normals::encoding::{Encoding, Octahedral, Rounding, Snorm};
use crate::normals::{Crease, NormalField, NormalRecipe, Precision, Scope, Weight, When, compute};
use crate::num::{Degrees, Radians, names};
use serde::Deserialize;

/// What a scene states about the normals of an object; `None` is left to the recipe of [`LoadOptions`](crate::raster::LoadOptions).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NormalSettings {
    /// How face normals are averaged.
    pub weight: Option<Weight>,
    /// Which edges are hard.
    pub crease: Option<Crease>,
    /// Whether hard edges give a vertex several normals.
    pub scope: Option<Scope>,
    /// How carefully normals are computed.
    pub precision: Option<Precision>,
    /// How normals are stored.
    pub format: Option<StoredFormat>,
    /// Whether vertices at equal positions are one, and equal normals of theirs as well. It changes no picture.
    pub merge: Option<bool>,
}

/// A storage of normals: what is drawn is what it gives back. By default normals are used as computed, in double precision. Those of three
/// numbers are stored as in glTF, where rounding changes their lengths a little.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StoredFormat {
    /// Three single-precision numbers: 12 bytes.
    F32,
    /// Three normalised 16-bit integers: 6 bytes.
    I16,
    /// Three normalised 8-bit integers: 3 bytes.
    I8,
    /// The nearest octahedral code of 12 + 12 bits: 3 bytes.
    Oct12,
    /// The nearest octahedral code of 8 + 8 bits: 2 bytes.
    Oct8,
}

// The largest first.
names! { StoredFormat: F32 = "f32", I16 = "i16", Oct12 = "oct12", I8 = "i8", Oct8 = "oct8" }

impl StoredFormat {
    /// Makes the normals of vertices what the storage gives back.
    pub(crate) fn round(self, field: &mut NormalField) {
        if let Some(format) = self.in_gltf() {
            return format.round(&mut field.normals.values);
        }
        let encoding = self.encoding();
        for normal in &mut field.normals.values {
            *normal = encoding.decode(encoding.encode(*normal));
        }
    }

    /// The storage in glTF; `None` for octahedral codes, which it does not have.
    pub fn in_gltf(self) -> Option<NormalFormat> {
        match self {
            Self::F32 => Some(NormalFormat::F32),
            Self::I16 => Some(NormalFormat::I16),
            Self::I8 => Some(NormalFormat::I8),
            Self::Oct12 | Self::Oct8 => None,
        }
    }

    /// A bound on the distance between a unit normal and what the storage gives back, as the angle of such a chord.
    ///
    /// Octahedral codes: [`Encoding::worst_angle`]. Three numbers: half a step in each, √3/2 / (2^(bits−1) − 1), and half a unit of
    /// the last place of single precision. With 8 bits, a normal that rounding would make too long or too short takes a neighbour in
    /// one component, which is off by at most 0.522 steps: √(½² + ½² + 0.522²)/127.
    pub fn worst_angle(self) -> Radians {
        let single = 3.0_f64.sqrt() * libm::ldexp(1.0, -25);
        let distance = match self {
            Self::F32 => single,
            Self::I16 => 0.5 * 3.0_f64.sqrt() / 32767.0 + single,
            Self::I8 => (0.5 + 0.522 * 0.522_f64).sqrt() / 127.0 + single,
            Self::Oct12 | Self::Oct8 => return self.encoding().worst_angle().into(),
        };
        Radians(2.0 * libm::asin(0.5 * distance))
    }

    /// The encoding, with its size and its error.
    pub fn encoding(self) -> Encoding {
        let octahedral = |bits| match Octahedral::new(bits) {
            Some(codec) => Encoding::Octahedral(codec, Rounding::Nearest),
            None => Encoding::Single,
        };
        match self {
            Self::F32 => Encoding::Single,
            Self::I16 => Encoding::Snorm(Snorm::SIXTEEN),
            Self::I8 => Encoding::Snorm(Snorm::EIGHT),
            Self::Oct12 => octahedral(12),
            Self::Oct8 => octahedral(8),
        }
    }
}

impl NormalSettings {
    /// These, and where they say nothing, others.
    pub fn or(self, other: Self) -> Self {
        Self {
            weight: self.weight.or(other.weight),
            crease: self.crease.or(other.crease),
            scope: self.scope.or(other.scope),
            precision: self.precision.or(other.precision),
            format: self.format.or(other.format),
            merge: self.merge.or(other.merge),
        }
    }

    /// Whether they concern how normals are computed, not only how they are stored.
    pub fn computes(&self) -> bool {
        self.weight.is_some() || self.crease.is_some() || self.scope.is_some() || self.precision.is_some()
    }

    /// A recipe with these settings.
    pub fn recipe(&self, recipe: &NormalRecipe) -> NormalRecipe {
        NormalRecipe {
            weight: self.weight.unwrap_or(recipe.weight),
            crease: self.crease.unwrap_or(recipe.crease),
            scope: self.scope.unwrap_or(recipe.scope),
            precision: self.precision.unwrap_or(recipe.precision),
            ..*recipe
        }
    }

    /// The normals of a mesh, before they are stored.
    pub(super) fn normals(&self, mesh: &Mesh, recipe: &NormalRecipe, when: When) -> NormalField {
        compute(mesh, &self.recipe(recipe)).selected(mesh, when)
    }
}

/// `crease = DEGREES`, `"off"` or `"none"`.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(try_from = "CreaseText")]
pub(super) struct CreaseValue(Crease, Scope);

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected an angle from 0 to 180 degrees, \"off\" or \"none\"")]
enum CreaseText {
    Degrees(f64),
    Name(CreaseName),
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum CreaseName {
    /// No edge is hard for its angle.
    Off,
    /// No edge is hard: not by smoothing groups either.
    None,
}

impl TryFrom<CreaseText> for CreaseValue {
    type Error = &'static str;

    fn try_from(text: CreaseText) -> Result<Self, Self::Error> {
        match text {
            CreaseText::Degrees(degrees) if (0.0..=180.0).contains(&degrees) => {
                Ok(Self(Crease::Angle(Degrees(degrees)), Scope::Corner))
            }
            CreaseText::Degrees(_) => Err("expected an angle from 0 to 180 degrees, \"off\" or \"none\""),
            CreaseText::Name(CreaseName::Off) => Ok(Self(Crease::OFF, Scope::Corner)),
            CreaseText::Name(CreaseName::None) => Ok(Self(Crease::OFF, Scope::Vertex)),
        }
    }
}

/// `merge = …`
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum MergeName {
    Off,
    Exact,
}

/// The settings of the keys `weight`, `crease`, `precision`, `normal-format` and `merge`.
pub(super) fn of_keys(
    weight: Option<Weight>,
    crease: Option<CreaseValue>,
    precision: Option<Precision>,
    format: Option<StoredFormat>,
    merge: Option<MergeName>,
) -> NormalSettings {
    let (crease, scope) = (crease.map(|it| it.0), crease.map(|it| it.1));
    let merge = merge.map(|name| name == MergeName::Exact);
    NormalSettings { weight, crease, scope, precision, format, merge }
}
