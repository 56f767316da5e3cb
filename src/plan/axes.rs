//! What may be left out of a scene: the choices for an object and for a light, each ordered from expensive to cheap.

use crate::normals::{Precision, Weight};
use crate::num::names;
use crate::raster::{Interpolation, Shading, StoredFormat};
use crate::shade::{Attenuation, Light};
use std::fmt;

/// What a plan may change, in the order in which ties are broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Axis {
    /// Where colours are computed: Phong, Gouraud, flat.
    Shading,
    /// How vertex normals are averaged.
    Weight,
    /// Whether hard edges split normals.
    Creases,
    /// How carefully normals are computed.
    Precision,
    /// How normals are stored.
    Storage,
    /// Whether vertices that agree are one.
    Merging,
    /// How values spread over faces.
    Interpolation,
    /// Which terms of the material are evaluated.
    Reflection,
    /// The cells of an analytic surface.
    Tessellation,
    /// Whether faces are lit on both sides.
    TwoSided,
    /// Kind, attenuation and presence of lights.
    Lights,
    /// Samples of each pixel. It changes the whole picture, so it must be allowed.
    Antialiasing,
}

names! { Axis:
    Shading = "shading", Weight = "weight", Creases = "creases", Precision = "precision",
    Storage = "storage", Merging = "merging", Interpolation = "interpolation", Reflection = "reflection",
    Tessellation = "tessellation", TwoSided = "two-sided", Lights = "lights", Antialiasing = "antialiasing",
}

/// Which terms of a material are evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Terms {
    /// All, with the declared highlight model.
    Declared,
    /// All, with Blinn's highlight in place of Phong's: four times the exponent.
    Blinn,
    /// No highlight.
    Diffuse,
    /// Ambient light alone.
    Ambient,
}

/// Where vertex normals come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// Stored ones, or those of the analytic surface.
    Given,
    /// Computed by this weight.
    Computed(Weight),
}

/// Vertex normals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Normals {
    /// How they are averaged.
    pub source: Source,
    /// Whether hard edges split them.
    pub creases: bool,
    /// How carefully they are computed, if they are.
    pub precision: Precision,
    /// How they are stored; `None` as declared.
    pub format: Option<StoredFormat>,
}

/// Cells along u and v; `None` for meshes and for surfaces that rays are cast at.
pub type Cells = Option<[u32; 2]>;

/// The model of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ObjectModel {
    /// Where colours are computed.
    pub shading: Shading,
    /// Its vertex normals; `None` if no vertex needs one.
    pub normals: Option<Normals>,
    /// How values spread over its faces.
    pub interpolation: Interpolation,
    /// Which terms of its material are evaluated.
    pub terms: Terms,
    /// Cells along u and v, of a tessellated analytic surface.
    pub segments: Cells,
    /// Whether vertices that agree are one.
    pub merged: bool,
    /// Whether it is lit on both sides.
    pub two_sided: bool,
}

impl ObjectModel {
    /// The model with another storage of normals.
    #[must_use]
    pub fn with_format(&self, format: Option<StoredFormat>) -> Self {
        Self { normals: self.normals.map(|normals| Normals { format, ..normals }), ..*self }
    }

    /// The model with the value of another on an axis.
    #[must_use]
    pub fn with(&self, axis: Axis, other: &Self) -> Self {
        let both = self.normals.zip(other.normals);
        let normals = |change: &dyn Fn(Normals, Normals) -> Normals| {
            both.map_or(self.normals, |(own, other)| Some(change(own, other)))
        };
        match axis {
            // Flat shading has no normals of vertices.
            Axis::Shading => {
                let normals =
                    if other.shading == Shading::Flat { None } else { self.normals.or(other.normals) };
                Self { shading: other.shading, normals, ..*self }
            }
            Axis::Weight => {
                Self { normals: normals(&|own, other| Normals { source: other.source, ..own }), ..*self }
            }
            Axis::Creases => {
                Self { normals: normals(&|own, other| Normals { creases: other.creases, ..own }), ..*self }
            }
            Axis::Precision => Self {
                normals: normals(&|own, other| Normals { precision: other.precision, ..own }),
                ..*self
            },
            Axis::Storage => {
                Self { normals: normals(&|own, other| Normals { format: other.format, ..own }), ..*self }
            }
            Axis::Merging => Self { merged: other.merged, ..*self },
            Axis::Interpolation => Self { interpolation: other.interpolation, ..*self },
            Axis::Reflection => Self { terms: other.terms, ..*self },
            Axis::Tessellation => Self { segments: other.segments, ..*self },
            Axis::TwoSided => Self { two_sided: other.two_sided, ..*self },
            Axis::Lights | Axis::Antialiasing => *self,
        }
    }

    /// The axes on which two models differ.
    pub fn differs(&self, other: &Self) -> Vec<Axis> {
        let of = |get: fn(&Normals) -> u64| (self.normals.as_ref().map(get), other.normals.as_ref().map(get));
        let both = self.normals.is_some() && other.normals.is_some();
        let normals = |pair: (Option<u64>, Option<u64>)| both && pair.0 != pair.1;
        let source = |normals: &Normals| match normals.source {
            Source::Given => 0,
            Source::Computed(weight) => 1 + weight as u64,
        };
        let is_other = [
            (Axis::Shading, self.shading != other.shading),
            (Axis::Weight, normals(of(source))),
            (Axis::Creases, normals(of(|normals| normals.creases.into()))),
            (Axis::Precision, normals(of(|normals| normals.precision as u64))),
            (Axis::Storage, normals(of(|normals| normals.format.map_or(0, |format| 1 + format as u64)))),
            (Axis::Merging, self.merged != other.merged),
            (Axis::Interpolation, self.interpolation != other.interpolation),
            (Axis::Reflection, self.terms != other.terms),
            (Axis::Tessellation, self.segments != other.segments),
            (Axis::TwoSided, self.two_sided != other.two_sided),
        ];
        is_other.into_iter().filter(|(_, is_other)| *is_other).map(|(axis, _)| axis).collect()
    }
}

impl ObjectModel {
    /// The value on an axis, as reports call it.
    pub fn value(&self, axis: Axis) -> String {
        let of_normals =
            |get: &dyn Fn(&Normals) -> String| self.normals.as_ref().map_or("none".to_owned(), get);
        match axis {
            Axis::Shading => match self.shading {
                Shading::Flat => "flat",
                Shading::Gouraud => "Gouraud",
                Shading::Phong => "Phong",
                Shading::Wireframe => "wireframe",
                Shading::Exact => "exact",
                Shading::Traced => "traced",
            }
            .to_owned(),
            Axis::Weight => of_normals(&|normals| match normals.source {
                Source::Given => "given".to_owned(),
                Source::Computed(weight) => weight.name().to_owned(),
            }),
            Axis::Creases => of_normals(&|normals| if normals.creases { "kept" } else { "none" }.to_owned()),
            Axis::Precision => of_normals(&|normals| match normals.precision {
                Precision::Faithful => "faithful".to_owned(),
                Precision::Fast => "fast".to_owned(),
            }),
            Axis::Storage => {
                of_normals(&|normals| normals.format.map_or("as declared", StoredFormat::name).to_owned())
            }
            Axis::Merging => if self.merged { "exact" } else { "off" }.to_owned(),
            Axis::Interpolation => match self.interpolation {
                Interpolation::Scanline => "scanline",
                Interpolation::Affine => "affine",
                Interpolation::Perspective => "perspective",
            }
            .to_owned(),
            Axis::Reflection => match self.terms {
                Terms::Declared => "as declared",
                Terms::Blinn => "Blinn",
                Terms::Diffuse => "diffuse",
                Terms::Ambient => "ambient",
            }
            .to_owned(),
            Axis::Tessellation => self.segments.map_or("as declared".to_owned(), |[u, v]| format!("{u}×{v}")),
            Axis::TwoSided => if self.two_sided { "on" } else { "off" }.to_owned(),
            Axis::Lights | Axis::Antialiasing => String::new(),
        }
    }
}

/// A light in place of a declared one; `None` omits it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightModel(pub Option<Light>);

impl fmt::Display for LightModel {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let Some(light) = &self.0 else { return f.write_str("omitted") };
        f.write_str(light.kind())?;
        match light {
            Light::Point { attenuation, .. } | Light::Spot { attenuation, .. } => {
                f.write_str(match attenuation {
                    Attenuation::None => ", constant",
                    _ => ", attenuated",
                })
            }
            _ => Ok(()),
        }
    }
}
