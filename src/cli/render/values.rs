//! Values of options of `crease render`.

use crate::cli::common::choice::{Choice, Choose};
use crate::cli::common::vectors::number;
use crease::num::{Degrees, Transfer};
use crease::raster::{Bits, Cull, FlatSample, Interpolation, RenderSettings, Samples, Shading, Show};
use crease::report::Overlay;
use crease::shade::{Terminator, ToneRule};

/// The largest side of a picture.
const LARGEST_SIDE: u32 = 16_384;

/// `640x480`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=LARGEST_SIDE).contains(side));
    let sides = text.split_once(['x', 'X', '×']).map(|(width, height)| (side(width), side(height)));
    match sides {
        Some((Some(width), Some(height))) => Ok([width, height]),
        _ => Err("WIDTHxHEIGHT was expected, such as 640x480, each side from 1 to 16384".into()),
    }
}

/// `320,240`.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    match text.split_once(',').map(|(x, y)| (x.trim().parse(), y.trim().parse())) {
        Some((Ok(x), Ok(y))) => Ok([x, y]),
        _ => Err("the column and row of a pixel were expected, such as 320,240".into()),
    }
}

/// `normals`, `facing`, `depth`, `face-id`, `deviation` or `deviation=5`.
pub fn show(text: &str) -> Result<Show, String> {
    let (name, range) = text.split_once('=').map_or((text, None), |(name, range)| (name, Some(range)));
    match (name, range) {
        ("normals", None) => Ok(Show::Normals),
        ("facing", None) => Ok(Show::Facing),
        ("depth", None) => Ok(Show::Depth),
        ("face-id", None) => Ok(Show::FaceId),
        ("deviation", None) => Ok(Show::DEVIATION),
        ("deviation", Some(range)) => match number(range) {
            Ok(degrees) if degrees > 0.0 && degrees <= 180.0 => Ok(Show::Deviation(Degrees(degrees))),
            _ => Err("an angle over 0 and up to 180 degrees was expected after deviation=".into()),
        },
        _ => Err("normals, facing, depth, face-id, deviation or deviation=DEG was expected".into()),
    }
}

/// A guard's name and whether it is on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GuardSwitch {
    pub name: String,
    pub on: bool,
}

/// `highlight=off`.
pub fn guard(text: &str) -> Result<GuardSwitch, String> {
    use crease::shade::Guards;
    let (name, state) = text.split_once('=').unwrap_or((text, ""));
    let on = match state {
        "on" => Some(true),
        "off" => Some(false),
        _ => None,
    };
    match on.filter(|&on| Guards::default().set(name, on)) {
        Some(on) => Ok(GuardSwitch { name: name.into(), on }),
        None => Err(format!("NAME=on or NAME=off was expected, of {}", Guards::NAMES.join(", "))),
    }
}

/// What becomes of lines behind surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HiddenLines {
    Remove,
    Show,
}

/// One panel of `--compare`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    Shading(Shading),
    Interpolation(Interpolation),
}

/// What `--reflection` takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReflectionChoice {
    Phong,
    Blinn,
    Given,
}

impl Variant {
    /// The settings of its panel.
    pub fn settings(self, settings: &RenderSettings) -> RenderSettings {
        match self {
            Variant::Shading(shading) => RenderSettings { shading, ..*settings },
            Variant::Interpolation(interpolation) => RenderSettings { interpolation, ..*settings },
        }
    }

    /// Its name as books write it.
    pub fn caption(self) -> &'static str {
        match self {
            Variant::Shading(Shading::Gouraud) => "Gouraud",
            Variant::Shading(Shading::Phong) => "Phong",
            _ => self.choice(),
        }
    }
}

impl Choose for Shading {
    const CHOICES: &'static [Choice<Self>] = &[
        ("flat", Shading::Flat, "once a face"),
        ("gouraud", Shading::Gouraud, "at the corners; colours are interpolated (Gouraud 1971)"),
        ("phong", Shading::Phong, "at every sample; normals are interpolated (Phong 1973)"),
        ("wireframe", Shading::Wireframe, "nowhere: edges are drawn"),
        ("exact", Shading::Exact, "at every sample, on the analytic surface that an object stands for"),
    ];
}

impl Choose for Interpolation {
    const CHOICES: &'static [Choice<Self>] = &[
        (
            "scanline",
            Interpolation::Scanline,
            "along the polygon's edges, then along the scanline: turns with the face",
        ),
        ("affine", Interpolation::Affine, "barycentric on triangles of the picture: ignores perspective"),
        (
            "perspective",
            Interpolation::Perspective,
            "barycentric on triangles of the scene: right under perspective",
        ),
    ];
}

impl Choose for Variant {
    const CHOICES: &'static [Choice<Self>] = &[
        ("flat", Variant::Shading(Shading::Flat), "flat shading"),
        ("gouraud", Variant::Shading(Shading::Gouraud), "Gouraud shading"),
        ("phong", Variant::Shading(Shading::Phong), "Phong shading"),
        ("wireframe", Variant::Shading(Shading::Wireframe), "edges"),
        ("exact", Variant::Shading(Shading::Exact), "the analytic surface"),
        ("scanline", Variant::Interpolation(Interpolation::Scanline), "scanline interpolation"),
        ("affine", Variant::Interpolation(Interpolation::Affine), "affine interpolation"),
        (
            "perspective",
            Variant::Interpolation(Interpolation::Perspective),
            "perspective-correct interpolation",
        ),
    ];
}

impl Choose for ReflectionChoice {
    const CHOICES: &'static [Choice<Self>] = &[
        ("phong", ReflectionChoice::Phong, "(V·R)ⁿ with the mirrored ray (Phong 1973)"),
        ("blinn", ReflectionChoice::Blinn, "(N·H)ⁿ with the half-vector (Blinn 1977)"),
        ("given", ReflectionChoice::Given, "no light: the colours of vertices are interpolated"),
    ];
}

impl Choose for FlatSample {
    const CHOICES: &'static [Choice<Self>] = &[
        ("centroid", FlatSample::Centroid, "at the mean of the corners"),
        ("vertex-mean", FlatSample::VertexMean, "at every corner; the face gets the mean of the colours"),
    ];
}

impl Choose for Overlay {
    const CHOICES: &'static [Choice<Self>] = &[
        ("wire", Overlay::Wire, "edges of faces"),
        ("creases", Overlay::Creases, "edges whose sides have different normals"),
        ("vertex-normals", Overlay::VertexNormals, "lines along the normals of vertices"),
        ("face-normals", Overlay::FaceNormals, "lines along the normals of faces"),
    ];
}

impl Choose for HiddenLines {
    const CHOICES: &'static [Choice<Self>] = &[
        ("remove", HiddenLines::Remove, "they are left out"),
        ("show", HiddenLines::Show, "they are drawn like all others"),
    ];
}

impl Choose for Cull {
    const CHOICES: &'static [Choice<Self>] = &[
        ("none", Cull::None, "none"),
        ("back", Cull::Back, "those seen from behind"),
        ("front", Cull::Front, "those seen from the front"),
    ];
}

impl Choose for Samples {
    const CHOICES: &'static [Choice<Self>] = &[
        ("1", Samples::One, "the centre"),
        ("4", Samples::Four, "a rotated square"),
        ("8", Samples::Eight, "eight places, no two in a row or column"),
        ("16", Samples::Sixteen, "sixteen, likewise"),
    ];
}

impl Choose for Bits {
    const CHOICES: &'static [Choice<Self>] =
        &[("8", Bits::Eight, "256 steps"), ("16", Bits::Sixteen, "65536 steps; PNG only")];
}

impl Choose for Terminator {
    const CHOICES: &'static [Choice<Self>] = &[
        ("smooth", Terminator::Smooth, "it stays: only the interpolated normal counts"),
        ("hard", Terminator::Hard, "it goes, as in the face's own shadow: along the edges of faces"),
        ("soft", Terminator::Soft, "it goes gradually (Chiang, Li and Burley 2019)"),
    ];
}

impl Choose for ToneRule {
    const CHOICES: &'static [Choice<Self>] = &[
        ("clamp", ToneRule::Clamp, "each component is clamped to 1"),
        ("max", ToneRule::DivideByMax, "the colour is divided by its largest component"),
    ];
}

impl Choose for Transfer {
    const CHOICES: &'static [Choice<Self>] = &[
        ("srgb", Transfer::Srgb, "the curve of sRGB"),
        ("direct", Transfer::Direct, "the number itself, as the lectures have it"),
    ];
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_pixels_are_two_whole_numbers() {
        assert_eq!(size("1920x1080"), Ok([1920, 1080]));
        assert_eq!(size("16384X1"), Ok([16_384, 1]));
        for wrong in ["", "640", "0x4", "4x16385", "-4x4", "4x4x4", "4.5x4"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(pixel("320, 240"), Ok([320, 240]));
        assert!(pixel("320").is_err() && pixel("-1,2").is_err() && pixel("1,2,3").is_err());
    }

    #[test]
    fn what_is_shown_and_guarded_has_names() {
        assert_eq!(show("deviation=5"), Ok(Show::Deviation(Degrees(5.0))));
        assert!(show("deviation=0").is_err() && show("depth=3").is_err() && show("").is_err());
        assert_eq!(guard("spot=off"), Ok(GuardSwitch { name: "spot".into(), on: false }));
        assert!(guard("spot").unwrap_err().contains("renormalise"));
        assert!(guard("lowlight=off").is_err() && guard("spot=maybe").is_err());
    }
}
