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
        let mut new = *self;
        if let (Some(own), Some(other)) = (&mut new.normals, &other.normals) {
            match axis {
                Axis::Weight => own.source = other.source,
                Axis::Creases => own.creases = other.creases,
                Axis::Precision => own.precision = other.precision,
                Axis::Storage => own.format = other.format,
                _ => {}
            }
        }
        match axis {
            Axis::Shading => {
                new.shading = other.shading;
                // Flat shading has no normals of vertices.
                let has_normals = other.shading != Shading::Flat;
                new.normals = self.normals.or(other.normals).filter(|_| has_normals);
            }
            Axis::Merging => new.merged = other.merged,
            Axis::Interpolation => new.interpolation = other.interpolation,
            Axis::Reflection => new.terms = other.terms,
            Axis::Tessellation => new.segments = other.segments,
            Axis::TwoSided => new.two_sided = other.two_sided,
            _ => {}
        }
        new
    }

    /// The axes on which two models differ. Normals that only one of them has are part of its shading.
    pub fn differs(&self, other: &Self) -> Vec<Axis> {
        let is_other = |axis: &Axis| match axis {
            Axis::Shading => self.shading != other.shading,
            _ => self.with(*axis, other) != *self,
        };
        Axis::ALL.into_iter().filter(is_other).collect()
    }
}

impl ObjectModel {
    /// The value on an axis, as reports call it.
    pub fn value(&self, axis: Axis) -> String {
        let of_normals = |get: &dyn Fn(&Normals) -> &'static str| self.normals.as_ref().map_or("none", get);
        let name = match axis {
            Axis::Shading => match self.shading {
                Shading::Flat => "flat",
                Shading::Gouraud => "Gouraud",
                Shading::Phong => "Phong",
                Shading::Wireframe => "wireframe",
                Shading::Exact => "exact",
                Shading::Traced => "traced",
            },
            Axis::Weight => of_normals(&|normals| match normals.source {
                Source::Given => "given",
                Source::Computed(weight) => weight.name(),
            }),
            Axis::Creases => of_normals(&|normals| if normals.creases { "kept" } else { "none" }),
            Axis::Precision => of_normals(&|normals| normals.precision.name()),
            Axis::Storage => of_normals(&|normals| normals.format.map_or("as declared", StoredFormat::name)),
            Axis::Merging => ["off", "exact"][usize::from(self.merged)],
            Axis::Interpolation => self.interpolation.name(),
            Axis::Reflection => match self.terms {
                Terms::Declared => "as declared",
                Terms::Blinn => "Blinn",
                Terms::Diffuse => "diffuse",
                Terms::Ambient => "ambient",
            },
            Axis::Tessellation => {
                return self.segments.map_or("as declared".to_owned(), |[u, v]| format!("{u}×{v}"));
            }
            Axis::TwoSided => ["off", "on"][usize::from(self.two_sided)],
            Axis::Lights | Axis::Antialiasing => "",
        };
        name.to_owned()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_model_takes_one_value_from_another_on_each_axis() {
        let normals =
            Normals { source: Source::Given, creases: true, precision: Precision::Faithful, format: None };
        let own = ObjectModel {
            shading: Shading::Phong,
            normals: Some(normals),
            interpolation: Interpolation::Perspective,
            terms: Terms::Declared,
            segments: Some([64, 32]),
            merged: false,
            two_sided: true,
        };
        let normals = Normals {
            source: Source::Computed(Weight::Area),
            creases: false,
            precision: Precision::Fast,
            format: Some(StoredFormat::I8),
        };
        let other = ObjectModel {
            shading: Shading::Gouraud,
            normals: Some(normals),
            interpolation: Interpolation::Affine,
            terms: Terms::Diffuse,
            segments: Some([8, 4]),
            merged: true,
            two_sided: false,
        };
        let axes = &Axis::ALL[..10];
        assert_eq!(own.differs(&other), axes);
        for &axis in axes {
            let new = own.with(axis, &other);
            assert_eq!(new.differs(&own), [axis]);
            assert_eq!(new.value(axis), other.value(axis));
        }
        // Flat shading has no vertex normals, so nothing else about them differs.
        let flat = ObjectModel { shading: Shading::Flat, normals: None, ..own };
        assert_eq!((own.differs(&flat), own.with(Axis::Shading, &flat)), (vec![Axis::Shading], flat));
    }
}
