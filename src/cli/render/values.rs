//! Values of options of `crease render`.

use crate::cli::common::choice::{Choose, choices};
use crate::cli::common::options::{colour, number};
use crease::num::{Degrees, LinearRgb, Transfer};
use crease::raster::{Bits, Cull, FlatSample, Interpolation, RenderSettings, Samples, Shading, Show};
use crease::report::Overlay;
use crease::shade::{Terminator, ToneRule};

const LARGEST_SIDE: u32 = 16_384;

/// `640x480`.
pub fn size(text: &str) -> Result<[u32; 2], String> {
    let side = |text: &str| text.parse().ok().filter(|side| (1..=LARGEST_SIDE).contains(side));
    let sides = text.split_once(['x', 'X', '×']).map(|(width, height)| (side(width), side(height)));
    match sides {
        Some((Some(width), Some(height))) => Ok([width, height]),
        _ => Err("expected WIDTHxHEIGHT, such as 640x480, each side from 1 to 16384".into()),
    }
}

/// `320,240`.
pub fn pixel(text: &str) -> Result<[u32; 2], String> {
    match text.split_once(',').map(|(x, y)| (x.trim().parse(), y.trim().parse())) {
        Some((Ok(x), Ok(y))) => Ok([x, y]),
        _ => Err("expected the column and row of a pixel, such as 320,240".into()),
    }
}

/// What `--show` shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shown {
    Fixed(Show),
    /// Deviations, over a range that holds all visible ones.
    FittedDeviation,
}

/// `normals`, `facing`, `depth`, `face-id`, `deviation` or `deviation=5`.
pub fn show(text: &str) -> Result<Shown, String> {
    if text == "deviation" {
        return Ok(Shown::FittedDeviation);
    }
    fixed_show(text).map(Shown::Fixed)
}

fn fixed_show(text: &str) -> Result<Show, String> {
    let (name, range) = text.split_once('=').map_or((text, None), |(name, range)| (name, Some(range)));
    match (name, range) {
        ("normals", None) => Ok(Show::Normals),
        ("facing", None) => Ok(Show::Facing),
        ("depth", None) => Ok(Show::Depth),
        ("face-id", None) => Ok(Show::FaceId),
        ("deviation", Some(range)) => match number(range) {
            Ok(degrees) if degrees > 0.0 && degrees <= 180.0 => Ok(Show::Deviation(Degrees(degrees))),
            _ => Err("expected an angle above 0 and up to 180 degrees after deviation=".into()),
        },
        _ => Err("expected normals, facing, depth, face-id, deviation or deviation=DEG".into()),
    }
}

/// What `--background` is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    Colour(LinearRgb),
    Transparent,
    Gradient,
}

/// The default background of meshes: light enough for paper, and darker than highlights.
pub const LIGHT_GREY: LinearRgb = LinearRgb::grey(0.7);

/// The upper and the lower end of `--background gradient`.
pub const GRADIENT: [LinearRgb; 2] = [LinearRgb::grey(0.9), LinearRgb::grey(0.45)];

/// `transparent`, `gradient`, `black`, `white` or a colour.
pub fn background(text: &str) -> Result<Background, String> {
    match text {
        "transparent" => Ok(Background::Transparent),
        "gradient" => Ok(Background::Gradient),
        "black" => Ok(Background::Colour(LinearRgb::BLACK)),
        "white" => Ok(Background::Colour(LinearRgb::WHITE)),
        _ => colour(text)
            .map(Background::Colour)
            .map_err(|error| format!("{error}; or black, white, transparent or gradient")),
    }
}

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
        None => Err(format!("expected NAME=on or NAME=off, with NAME one of {}", Guards::NAMES.join(", "))),
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HiddenLines {
    Remove,
    Show,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    Shading(Shading),
    Interpolation(Interpolation),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReflectionChoice {
    Phong,
    Blinn,
    Given,
}

impl Variant {
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

choices! { Shading:
    "flat" => Flat, "gouraud" => Gouraud, "phong" => Phong, "wireframe" => Wireframe, "exact" => Exact,
    "traced" => Traced,
}

choices! { Interpolation: "scanline" => Scanline, "affine" => Affine, "perspective" => Perspective }

choices! { Variant:
    "flat" => Shading(Shading::Flat), "gouraud" => Shading(Shading::Gouraud),
    "phong" => Shading(Shading::Phong), "wireframe" => Shading(Shading::Wireframe),
    "exact" => Shading(Shading::Exact), "traced" => Shading(Shading::Traced), "scanline" => Interpolation(Interpolation::Scanline),
    "affine" => Interpolation(Interpolation::Affine),
    "perspective" => Interpolation(Interpolation::Perspective),
}

choices! { ReflectionChoice: "phong" => Phong, "blinn" => Blinn, "given" => Given }

choices! { FlatSample: "centroid" => Centroid, "vertex-mean" => VertexMean }

choices! { Overlay:
    "wire" => Wire, "creases" => Creases, "vertex-normals" => VertexNormals, "face-normals" => FaceNormals,
}

choices! { HiddenLines: "remove" => Remove, "show" => Show }

choices! { Cull: "none" => None, "back" => Back, "front" => Front }

choices! { Samples: "1" => One, "4" => Four, "8" => Eight, "16" => Sixteen }

choices! { Bits: "8" => Eight, "16" => Sixteen }

choices! { Terminator: "smooth" => Smooth, "hard" => Hard, "soft" => Soft }

choices! { ToneRule: "clamp" => Clamp, "max" => DivideByMax }

choices! { Transfer: "srgb" => Srgb, "direct" => Direct }

/// The format of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum FileKind {
    Png,
    Gif,
    Jpeg,
    WebP,
}

choices! { FileKind: "png" => Png, "jpeg" => Jpeg, "webp" => WebP, "gif" => Gif }

impl FileKind {
    /// By the end of a file's name.
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension {
            "png" => Some(Self::Png),
            "gif" => Some(Self::Gif),
            "jpg" | "jpeg" => Some(Self::Jpeg),
            "webp" => Some(Self::WebP),
            _ => None,
        }
    }
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
        assert_eq!(show("deviation=5"), Ok(Shown::Fixed(Show::Deviation(Degrees(5.0)))));
        assert_eq!(show("deviation"), Ok(Shown::FittedDeviation));
        assert!(show("deviation=0").is_err() && show("depth=3").is_err() && show("").is_err());
        assert_eq!(guard("spot=off"), Ok(GuardSwitch { name: "spot".into(), on: false }));
        assert!(guard("spot").unwrap_err().contains("renormalise"));
        assert!(guard("lowlight=off").is_err() && guard("spot=maybe").is_err());
    }
}
