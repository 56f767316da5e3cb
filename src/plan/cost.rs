//! What a model costs, counted and not timed, so that a plan is the same on every machine.
//!
//! *Work* is a number of floating-point operations for one picture: additions, multiplications and comparisons count 1, divisions and
//! square roots 4, powers 16.
//!
//! | step | operations |
//! |---|---|
//! | place a vertex on the picture | 30 |
//! | compute a normal by a weighted sum, for each corner of a face | 12 (uniform, area), 30 (others), 12 for the face |
//! | compute a normal by a fit, for each vertex | 20 000 |
//! | the same with `fast` | half |
//! | transform a vertex normal | 15 |
//! | interpolate three values at a sample | 12; 8 more in perspective |
//! | make an interpolated normal a unit vector | 10 |
//! | find the position of a sample, if a light or the viewer is near | 12 |
//! | light a point | 6, and for each light the table below |
//! | see which side of a face is lit, at each lit point | 1 |
//!
//! | light | direction and strength | diffuse | Blinn's highlight | Phong's highlight |
//! |---|---:|---:|---:|---:|
//! | ambient | 6 | | | |
//! | directional | 0 | 12 | 36 | 40 |
//! | point | 15, attenuated 8 more | 12 | 36 | 40 |
//! | spot | 30, attenuated 8 more | 12 | 36 | 40 |
//! | rectangle | 4 × 80 | 12 | 36 | 40 |
//! | disc | 64 × 80 | 12 | 36 | 40 |
//!
//! *Bytes* are those of the vertex and index buffers: 12 for a position and the size of the stored normal for each vertex, 12 for each
//! triangle. *Vertices* are those of the vertex buffer, where a vertex with several normals counts several times.

use super::axes::{ObjectModel, Source, Terms};
use crate::normals::{Precision, Weight};
use crate::raster::{Interpolation, Shading};
use crate::shade::{AreaShape, Attenuation, Light, Reflection};

/// What a plan makes as small as possible.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Minimise {
    /// Operations.
    #[default]
    Work,
    /// Bytes of buffers.
    Bytes,
    /// Vertices in buffers.
    Vertices,
}

/// Costs of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Cost {
    /// Operations for all pictures.
    pub work: u64,
    /// Bytes of vertex and index buffers.
    pub bytes: u64,
    /// Vertices in vertex buffers.
    pub vertices: u64,
}

impl Cost {
    /// The cost that counts.
    pub fn of(&self, what: Minimise) -> u64 {
        match what {
            Minimise::Work => self.work,
            Minimise::Bytes => self.bytes,
            Minimise::Vertices => self.vertices,
        }
    }
}

impl std::ops::Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            work: self.work + other.work,
            bytes: self.bytes + other.bytes,
            vertices: self.vertices + other.vertices,
        }
    }
}

impl std::iter::Sum for Cost {
    fn sum<I: Iterator<Item = Self>>(costs: I) -> Self {
        costs.fold(Self::default(), std::ops::Add::add)
    }
}

/// The sizes of an object that its cost follows from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sizes {
    /// Vertices that faces use.
    pub vertices: u64,
    /// Normals: vertices, counted once for each of their normals.
    pub normals: u64,
    /// Faces.
    pub faces: u64,
    /// Triangles that faces are cut into.
    pub triangles: u64,
    /// Corners of faces.
    pub corners: u64,
    /// Samples of all pictures that show the object.
    pub samples: u64,
    /// Pictures.
    pub pictures: u64,
    /// Whether it is an analytic surface that rays are cast at.
    pub is_cast: bool,
}

/// The highlight of a material as far as costs go; `None` if it has none.
pub type Highlight = Option<Reflection>;

/// The cost of an object with a model under lights.
pub fn object_cost(
    sizes: &Sizes,
    model: &ObjectModel,
    highlight: Highlight,
    lights: &[Light],
    far_viewer: bool,
) -> Cost {
    let stored = model.normals.filter(|_| !sizes.is_cast);
    let bytes_of_normal = stored.map_or(0, |normals| match normals.format {
        Some(format) => format.encoding().bytes() as u64,
        None => 12,
    });
    let vertices = if stored.is_some() { sizes.normals } else { sizes.vertices };
    let bytes = vertices * (12 + bytes_of_normal) + 12 * sizes.triangles;
    let computed = stored.map_or(0, |normals| {
        let sums = |corner: u64| corner * sizes.corners + 12 * sizes.faces;
        let work = match normals.source {
            Source::Given => 0,
            Source::Computed(Weight::Uniform | Weight::Area) => sums(12),
            Source::Computed(Weight::Quadric | Weight::Jet) => 20_000 * sizes.vertices,
            Source::Computed(Weight::Best) => 40_000 * sizes.vertices,
            Source::Computed(_) => sums(30),
        };
        if normals.precision == Precision::Fast { work / 2 } else { work }
    });
    let point = lit_point(model, highlight, lights);
    let needs_position = point.1 || highlight_of(model, highlight).is_some() && !far_viewer;
    let interpolated = match model.interpolation {
        Interpolation::Perspective => 20,
        Interpolation::Affine | Interpolation::Scanline => 12,
    };
    let position = if needs_position { 12 } else { 0 };
    let sides = u64::from(model.two_sided);
    let lit = point.0 + sides;
    let shaded = match model.shading {
        _ if sizes.is_cast => sizes.samples * (40 + position + lit),
        Shading::Flat => sizes.pictures * sizes.faces * lit,
        Shading::Gouraud => sizes.pictures * vertices * lit + sizes.samples * interpolated,
        _ => sizes.samples * (interpolated + 10 + position + lit),
    };
    let placed = sizes.pictures * (30 * vertices + if stored.is_some() { 15 * vertices } else { 0 });
    Cost { work: placed + computed + shaded, bytes, vertices }
}

fn highlight_of(model: &ObjectModel, highlight: Highlight) -> Highlight {
    match model.terms {
        Terms::Declared => highlight,
        Terms::Blinn => highlight.map(|_| Reflection::Blinn),
        Terms::Diffuse | Terms::Ambient => None,
    }
}

/// Operations to light a point, and whether they depend on its position.
fn lit_point(model: &ObjectModel, highlight: Highlight, lights: &[Light]) -> (u64, bool) {
    let highlight = match highlight_of(model, highlight) {
        None => 0,
        Some(Reflection::Blinn) => 36,
        Some(Reflection::Phong) => 40,
    };
    let (mut work, mut near) = (6, false);
    for class in lights.iter().map(light_class) {
        match class {
            (_, true) => work += 6,
            _ if model.terms == Terms::Ambient => {}
            (direction, false) => {
                near |= direction > 0;
                work += direction + 12 + highlight;
            }
        }
    }
    (work, near)
}

/// Operations for direction and strength of a light, and whether it is ambient. Costs depend on nothing else of a light. Only directional
/// lights take none: all others are near.
pub fn light_class(light: &Light) -> (u64, bool) {
    let attenuated = |attenuation: Attenuation| if attenuation == Attenuation::None { 0 } else { 8 };
    let direction = match *light {
        Light::Ambient { .. } | Light::Directional { .. } => 0,
        Light::Point { attenuation, .. } => 15 + attenuated(attenuation),
        Light::Spot { attenuation, .. } => 30 + attenuated(attenuation),
        Light::Area { shape: AreaShape::Rectangle { .. }, .. } => 4 * 80,
        Light::Area { shape: AreaShape::Disc { .. }, .. } => 64 * 80,
    };
    (direction, matches!(light, Light::Ambient { .. }))
}
