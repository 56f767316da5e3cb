//! The parameters of experiments: their names, ranges and values.

use crate::mesh::Mesh;
use crate::normals::Weight;
use crate::num::Degrees;
use crate::raster::Interpolation;
use crate::text::given;
use serde::{Serialize, Serializer};
use std::ops::RangeInclusive;

/// A parameter of experiments. Not every experiment has all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ParameterName {
    /// [`Parameters::size`].
    Size,
    /// [`Parameters::segments`].
    Segments,
    /// [`Parameters::light`].
    Light,
    /// [`Parameters::turn`].
    Turn,
    /// [`Parameters::intensity`].
    Intensity,
    /// [`Parameters::exponent`].
    Exponent,
    /// [`Parameters::weight`].
    Weight,
    /// [`Parameters::crease`].
    Crease,
    /// [`Parameters::interpolation`].
    Interpolation,
    /// [`Setup::mesh`].
    Mesh,
}

/// The name of each parameter, in the order of [`ParameterName`], and the range of a number.
const TABLE: [(&str, Option<RangeInclusive<f64>>); 10] = [
    ("size", Some(32.0..=1024.0)),
    ("segments", Some(3.0..=1024.0)),
    ("light", Some(-180.0..=180.0)),
    ("turn", Some(-180.0..=180.0)),
    ("intensity", Some(0.0..=1e6)),
    ("exponent", Some(0.0..=1e6)),
    ("weight", None),
    ("crease", Some(0.0..=180.0)),
    ("interpolation", None),
    ("mesh", None),
];

impl ParameterName {
    pub(super) const NUMBERS: [Self; 7] =
        [Self::Size, Self::Segments, Self::Light, Self::Turn, Self::Intensity, Self::Exponent, Self::Crease];

    /// The range of a number; `None` for parameters that are not numbers. An experiment may have a smaller range
    /// ([`Experiment::range`](super::Experiment::range)).
    pub fn range(self) -> Option<RangeInclusive<f64>> {
        TABLE[self as usize].1.clone()
    }

    /// Its name, which is also that of the command-line option.
    pub fn name(self) -> &'static str {
        TABLE[self as usize].0
    }
}

/// The settings of an experiment. Its page explains what each means to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Width and height in pixels of each picture, 32 to 1024.
    pub size: u32,
    /// The fineness of meshes: segments of a circle, cells of a grid; 3 to 1024.
    pub segments: u32,
    /// The angle of the light, mostly off the axis of view, −180° to 180°.
    pub light: Degrees,
    /// The rotation of the object or of the view, −180° to 180°.
    pub turn: Degrees,
    /// The intensity of the light, 0 to 10⁶; a white surface that faces light of intensity 1 without attenuation is white.
    pub intensity: f64,
    /// The exponent n of the highlight, 0 to 10⁶.
    pub exponent: f64,
    /// The weighting of faces in vertex normals.
    pub weight: Weight,
    /// The crease angle of the cure, 0° to 180°.
    pub crease: Degrees,
    /// How values at corners are interpolated in the animation.
    pub interpolation: Interpolation,
}

impl Parameters {
    /// The defaults of most experiments: 320 pixels, 16 segments, light 30° off the axis of view, a rotation by 45°, intensity 1,
    /// n = 32, angle weights, creases over 40°, perspective interpolation.
    pub const USUAL: Parameters = Parameters {
        size: 320,
        segments: 16,
        light: Degrees(30.0),
        turn: Degrees(45.0),
        intensity: 1.0,
        exponent: 32.0,
        weight: Weight::Angle,
        crease: Degrees(40.0),
        interpolation: Interpolation::Perspective,
    };

    /// A number; `None` for parameters that are not numbers.
    pub(super) fn number(&self, name: ParameterName) -> Option<f64> {
        match name {
            ParameterName::Size => Some(self.size.into()),
            ParameterName::Segments => Some(self.segments.into()),
            ParameterName::Light => Some(self.light.0),
            ParameterName::Turn => Some(self.turn.0),
            ParameterName::Intensity => Some(self.intensity),
            ParameterName::Exponent => Some(self.exponent),
            ParameterName::Crease => Some(self.crease.0),
            ParameterName::Weight | ParameterName::Interpolation | ParameterName::Mesh => None,
        }
    }

    /// The value of a parameter as the command line has it; `None` for [`ParameterName::Mesh`].
    pub fn value(&self, name: ParameterName) -> Option<String> {
        let choice = match name {
            ParameterName::Weight => self.weight.name(),
            ParameterName::Interpolation => self.interpolation.name(),
            _ => return self.number(name).map(given),
        };
        Some(choice.to_owned())
    }
}

/// Declares [`Changes`]: an optional new value for each field of [`Parameters`].
macro_rules! changes {
    ($($field:ident: $type:ty = $name:ident,)*) => {
        /// Changes of an experiment's default settings.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct Changes {
            $(#[doc = concat!("See [`Parameters::", stringify!($field), "`].")]
            pub $field: Option<$type>,)*
        }

        impl Changes {
            /// The parameters that are changed.
            pub fn names(&self) -> impl Iterator<Item = ParameterName> + use<> {
                let changed = [$((ParameterName::$name, self.$field.is_some()),)*];
                changed.into_iter().filter(|(_, changed)| *changed).map(|(name, _)| name)
            }

            /// The changes of parameters that an experiment takes.
            #[must_use]
            pub fn only(self, takes: &[ParameterName]) -> Self {
                Self { $($field: self.$field.filter(|_| takes.contains(&ParameterName::$name)),)* }
            }

            /// Settings with the changes.
            pub fn apply(&self, to: Parameters) -> Parameters {
                Parameters { $($field: self.$field.unwrap_or(to.$field),)* }
            }
        }
    };
}

changes! {
    size: u32 = Size,
    segments: u32 = Segments,
    light: Degrees = Light,
    turn: Degrees = Turn,
    intensity: f64 = Intensity,
    exponent: f64 = Exponent,
    weight: Weight = Weight,
    crease: Degrees = Crease,
    interpolation: Interpolation = Interpolation,
}

/// The input of a run.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// The settings.
    pub parameters: Parameters,
    /// A user's mesh in place of the experiment's own shapes.
    pub mesh: Option<UserMesh<'a>>,
}

/// A user's mesh.
#[derive(Clone, Copy, Debug)]
pub struct UserMesh<'a> {
    /// Its file name.
    pub name: &'a str,
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The name and mesh of a finer model of the same shape, taken as the true one.
    pub finer: Option<(&'a str, &'a Mesh)>,
}

/// The values of the parameters that an experiment takes, as an object of JSON.
#[derive(Clone, Copy, Debug)]
pub struct ParameterValues<'a> {
    /// The parameters that it takes.
    pub names: &'a [ParameterName],
    /// The values of all parameters.
    pub parameters: &'a Parameters,
}

impl Serialize for ParameterValues<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        #[serde(untagged)]
        enum Value {
            Number(f64),
            Name(String),
        }
        let value = |&name: &ParameterName| {
            let value = self.parameters.number(name).map(Value::Number);
            Some((name.name(), value.or_else(|| self.parameters.value(name).map(Value::Name))?))
        };
        serializer.collect_map(self.names.iter().filter_map(value))
    }
}
