//! What may be changed about an experiment.

use super::ArtefactError;
use crate::mesh::Mesh;
use crate::normals::Weight;
use crate::num::Degrees;
use crate::raster::Interpolation;
use crate::text::given;
use serde::{Serialize, Serializer};
use std::ops::RangeInclusive;

/// Something that may be changed. Not every experiment has all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Knob {
    /// [`Parameters::size`].
    Size,
    /// [`Parameters::segments`].
    Segments,
    /// [`Parameters::light`].
    Light,
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

impl Knob {
    /// All of them.
    pub const ALL: [Knob; 8] = [
        Knob::Size,
        Knob::Segments,
        Knob::Light,
        Knob::Exponent,
        Knob::Weight,
        Knob::Crease,
        Knob::Interpolation,
        Knob::Mesh,
    ];

    /// The least and the most that a number may be; `None` for what is no number. An experiment may take less of it, see
    /// [`Experiment::range`](super::Experiment::range).
    pub fn range(self) -> Option<RangeInclusive<f64>> {
        match self {
            Knob::Size => Some(32.0..=1024.0),
            Knob::Segments => {
                Some(f64::from(*Parameters::SEGMENTS.start())..=f64::from(*Parameters::SEGMENTS.end()))
            }
            Knob::Light => Some(-180.0..=180.0),
            Knob::Exponent => Some(0.0..=1e6),
            Knob::Crease => Some(0.0..=180.0),
            Knob::Weight | Knob::Interpolation | Knob::Mesh => None,
        }
    }

    /// Its name, which on the command line is that of the option.
    pub fn name(self) -> &'static str {
        match self {
            Knob::Size => "size",
            Knob::Segments => "segments",
            Knob::Light => "light",
            Knob::Exponent => "exponent",
            Knob::Weight => "weight",
            Knob::Crease => "crease",
            Knob::Interpolation => "interpolation",
            Knob::Mesh => "mesh",
        }
    }
}

/// The settings of an experiment. What one of them means to it, its page tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Width and height in pixels of each picture, 32 to 1024.
    pub size: u32,
    /// How finely things are cut: segments of a circle, cells of a grid; 3 to 1024.
    pub segments: u32,
    /// The angle of the light, mostly off the axis of view, −180° to 180°.
    pub light: Degrees,
    /// The exponent n of the highlight, 0 to 10⁶.
    pub exponent: f64,
    /// How faces count in vertex normals.
    pub weight: Weight,
    /// The crease angle of the cure, 0° to 180°.
    pub crease: Degrees,
    /// How values at corners spread over faces in the animation.
    pub interpolation: Interpolation,
}

impl Parameters {
    /// How many segments there may be; some experiments take fewer of them.
    pub const SEGMENTS: RangeInclusive<u32> = 3..=1024;
    /// What experiments start from: 320 pixels, 16 segments, light 30° off the axis of view, n = 32, angle weights, creases
    /// over 40°, perspective interpolation.
    pub const USUAL: Parameters = Parameters {
        size: 320,
        segments: 16,
        light: Degrees(30.0),
        exponent: 32.0,
        weight: Weight::Angle,
        crease: Degrees(40.0),
        interpolation: Interpolation::Perspective,
    };

    /// The value of a parameter as the command line has it; `None` for [`Knob::Mesh`].
    pub fn value(&self, knob: Knob) -> Option<String> {
        Some(match knob {
            Knob::Size => self.size.to_string(),
            Knob::Segments => self.segments.to_string(),
            Knob::Light => given(self.light.0),
            Knob::Exponent => given(self.exponent),
            Knob::Weight => self.weight.name().to_owned(),
            Knob::Crease => given(self.crease.0),
            Knob::Interpolation => match self.interpolation {
                Interpolation::Scanline => "scanline",
                Interpolation::Affine => "affine",
                Interpolation::Perspective => "perspective",
            }
            .to_owned(),
            Knob::Mesh => return None,
        })
    }

    /// Whether everything is within its range.
    ///
    /// # Errors
    /// [`ArtefactError::Range`] for the first that is not.
    pub fn check(&self) -> Result<(), ArtefactError> {
        let numbers = [
            (Knob::Size, self.size.into(), "give 32 to 1024 pixels"),
            (Knob::Segments, self.segments.into(), "give a number from 3 to 1024"),
            (Knob::Light, self.light.0, "give an angle from -180 to 180 degrees"),
            (Knob::Exponent, self.exponent, "give a number from 0 to 1000000"),
            (Knob::Crease, self.crease.0, "give an angle from 0 to 180 degrees"),
        ];
        let is_out =
            |(knob, found, _): &(Knob, f64, _)| knob.range().is_some_and(|range| !range.contains(found));
        match numbers.into_iter().find(is_out) {
            Some((knob, found, expected)) => Err(ArtefactError::Range { knob, found, expected }),
            None => Ok(()),
        }
    }
}

/// What is to be different from an experiment's own settings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Changes {
    /// See [`Parameters::size`].
    pub size: Option<u32>,
    /// See [`Parameters::segments`].
    pub segments: Option<u32>,
    /// See [`Parameters::light`].
    pub light: Option<Degrees>,
    /// See [`Parameters::exponent`].
    pub exponent: Option<f64>,
    /// See [`Parameters::weight`].
    pub weight: Option<Weight>,
    /// See [`Parameters::crease`].
    pub crease: Option<Degrees>,
    /// See [`Parameters::interpolation`].
    pub interpolation: Option<Interpolation>,
}

impl Changes {
    /// What is changed.
    pub fn knobs(&self) -> impl Iterator<Item = Knob> + use<> {
        let changed = [
            (Knob::Size, self.size.is_some()),
            (Knob::Segments, self.segments.is_some()),
            (Knob::Light, self.light.is_some()),
            (Knob::Exponent, self.exponent.is_some()),
            (Knob::Weight, self.weight.is_some()),
            (Knob::Crease, self.crease.is_some()),
            (Knob::Interpolation, self.interpolation.is_some()),
        ];
        changed.into_iter().filter(|(_, changed)| *changed).map(|(knob, _)| knob)
    }

    /// Those of the changes that an experiment takes.
    #[must_use]
    pub fn only(self, takes: &[Knob]) -> Self {
        let has = |knob| takes.contains(&knob);
        Self {
            size: self.size.filter(|_| has(Knob::Size)),
            segments: self.segments.filter(|_| has(Knob::Segments)),
            light: self.light.filter(|_| has(Knob::Light)),
            exponent: self.exponent.filter(|_| has(Knob::Exponent)),
            weight: self.weight.filter(|_| has(Knob::Weight)),
            crease: self.crease.filter(|_| has(Knob::Crease)),
            interpolation: self.interpolation.filter(|_| has(Knob::Interpolation)),
        }
    }

    /// Settings with the changes.
    pub fn apply(&self, to: Parameters) -> Parameters {
        Parameters {
            size: self.size.unwrap_or(to.size),
            segments: self.segments.unwrap_or(to.segments),
            light: self.light.unwrap_or(to.light),
            exponent: self.exponent.unwrap_or(to.exponent),
            weight: self.weight.unwrap_or(to.weight),
            crease: self.crease.unwrap_or(to.crease),
            interpolation: self.interpolation.unwrap_or(to.interpolation),
        }
    }
}

/// What an experiment is run with.
#[derive(Clone, Copy, Debug)]
pub struct Setup<'a> {
    /// Its settings.
    pub parameters: Parameters,
    /// A mesh to run it on instead of its own.
    pub mesh: Option<UserMesh<'a>>,
}

/// Somebody's own mesh.
#[derive(Clone, Copy, Debug)]
pub struct UserMesh<'a> {
    /// What it is called where it came from.
    pub name: &'a str,
    /// The mesh.
    pub mesh: &'a Mesh,
    /// A finer mesh of the same thing to take for the truth, after its own name.
    pub finer: Option<(&'a str, &'a Mesh)>,
}

/// Parameters that an experiment takes, as an object of JSON.
#[derive(Clone, Copy, Debug)]
pub struct Taken<'a> {
    /// Which.
    pub knobs: &'a [Knob],
    /// All of them.
    pub parameters: &'a Parameters,
}

impl Serialize for Taken<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Parameters { size, segments, light, exponent, crease, .. } = self.parameters;
        let number = |knob| match knob {
            Knob::Size => Some(f64::from(*size)),
            Knob::Segments => Some(f64::from(*segments)),
            Knob::Light => Some(light.0),
            Knob::Exponent => Some(*exponent),
            Knob::Crease => Some(crease.0),
            Knob::Weight | Knob::Interpolation | Knob::Mesh => None,
        };
        /// A number or a name.
        #[derive(Serialize)]
        #[serde(untagged)]
        enum Value {
            Number(f64),
            Name(String),
        }
        let value = |&knob: &Knob| {
            let value = number(knob).map(Value::Number);
            Some((knob.name(), value.or_else(|| self.parameters.value(knob).map(Value::Name))?))
        };
        serializer.collect_map(self.knobs.iter().filter_map(value))
    }
}
