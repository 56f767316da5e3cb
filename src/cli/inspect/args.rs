//! The options of `crease inspect`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::{EXIT_CODES, RunArgs, confidence};
use clap::Args;
use crease::io::Format;
use crease::mesh::Confidence;
use crease::num::Degrees;
use crease::quality::catalogue::Kind;
use crease::quality::{Severity, Thresholds};
use crease::report::Sight;
use glam::DVec3;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  crease inspect part.glb --html report.html
  crease inspect models --recursive --json --fail-on error
  crease inspect --explain faceted";

/// Report what is wrong with a mesh's normals, why, where, and how much it shows
///
/// crease searches for the weight and the crease angle that reproduce the stored normals best, and compares the
/// normals with these. Each finding has a stable id, a severity (error: wrong in any picture; warning: shows in some;
/// note: may be intended), a cause, its worst positions, and the command that fixes it, if there is one.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct InspectArgs {
    /// Files, folders (with --recursive), or `-` for standard input
    #[arg(value_name = "INPUT", required_unless_present = "explain")]
    pub inputs: Vec<PathBuf>,

    /// Include all mesh files in folders and below, except hidden ones
    #[arg(short, long)]
    pub recursive: bool,

    /// Format of the input [default: by content, else by name]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,

    /// Further folder from which companion files (MTL, glTF buffers) may be read; the only one for standard input
    /// [default: the input's folder]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Compare with this file of the same shape: by how many degrees the normals changed, how much that shows, and
    /// which findings were added or removed. Faces are matched by the positions of their corners, so order, splits
    /// and triangulation do not matter. `-` is standard input (one input only). --fail-on judges the input, not this
    /// file
    #[arg(long, value_name = "FILE")]
    pub against: Option<PathBuf>,

    #[command(flatten)]
    pub pictures: PictureArgs,
    #[command(flatten)]
    pub findings: FindingArgs,
    #[command(flatten)]
    pub thresholds: ThresholdArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args)]
#[command(next_help_heading = "Pictures (one input only)")]
pub struct PictureArgs {
    /// File for a page with pictures, histograms and explanations; `-` is standard output, and the report then goes
    /// to standard error
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,

    /// PNG file for the mesh coloured by the deviation of its stored normals, with a legend and a ring around the
    /// worst position of each error and warning; `-` is standard output
    #[arg(long, value_name = "FILE")]
    pub heatmap: Option<PathBuf>,

    /// View direction of the pictures
    #[arg(long, value_name = "SIDE", default_value = "auto", value_parser = one_of::<Sight>())]
    pub view: Sight,
}

#[derive(Args)]
#[command(next_help_heading = "Findings")]
pub struct FindingArgs {
    /// Exit with code 1 if a reported finding has at least this severity. If a file of a batch cannot be read, the
    /// exit code is 5
    #[arg(long, value_name = "SEVERITY", value_parser = one_of::<Severity>())]
    pub fail_on: Option<Severity>,

    /// Report only findings of at least this severity, and count the others; --fail-on ignores these [default: note in
    /// JSON, warning in text without -v]
    #[arg(long, value_name = "SEVERITY", value_parser = one_of::<Severity>())]
    pub severity: Option<Severity>,

    /// Omit these findings; repeatable
    #[arg(long, value_name = "ID", value_parser = kind, value_delimiter = ',')]
    pub ignore: Vec<Kind>,

    /// Report only these findings; repeatable
    #[arg(long, value_name = "ID", value_parser = kind, value_delimiter = ',')]
    pub only: Vec<Kind>,

    /// Positions to report for each finding, worst first [default: 10 in JSON, 1 as text, 10 with -v]
    #[arg(long, value_name = "N")]
    pub places: Option<usize>,

    /// Explain findings by id or symptom (faceted, dark, seam, inside out), or all, and exit
    #[arg(long, value_name = "WORD", num_args = 1.., exclusive = true)]
    pub explain: Vec<String>,
}

/// Makes the options of the thresholds: `option => field of Thresholds: type, parser, name of the value`.
macro_rules! thresholds {
    ($($(#[$help:meta])* $option:ident => $field:ident: $type:ty, $parser:expr, $value:literal;)*) => {
        #[derive(Args)]
        #[command(next_help_heading = "Thresholds (angles in degrees)")]
        pub struct ThresholdArgs {
            $($(#[$help])*
            #[arg(long, value_name = $value, value_parser = $parser, allow_negative_numbers = true)]
            $option: Option<$type>,)*
        }

        impl ThresholdArgs {
            /// The defaults with the options in their place.
            pub fn resolve(&self, places: Option<usize>) -> Thresholds {
                let mut thresholds = Thresholds::default();
                $(if let Some(value) = self.$option {
                    thresholds.$field = value.into();
                })*
                thresholds.strict_length = thresholds.strict_length.min(thresholds.length);
                thresholds.places = places.unwrap_or(thresholds.places);
                thresholds
            }
        }
    };
}

thresholds! {
    /// Maximum angle between a stored normal and the one computed with the estimated recipe, in degrees [default: 15]
    deviation => deviation: Degrees, angle, "DEG";
    /// Maximum angle of a stored normal beyond 90° from its face, in degrees [default: 5]
    past_face => against: Degrees, angle, "DEG";
    /// Maximum common rotation of all stored normals, in degrees [default: 5]
    rotation => rotation: Degrees, angle, "DEG";
    /// Maximum quantisation error of stored normals, in degrees [default: 0.05]
    quantisation => quantisation: Degrees, angle, "DEG";
    /// Maximum dihedral angle of an edge with one normal on both sides beyond the crease angle, in degrees [default:
    /// 10]
    past_crease => crease: Degrees, angle, "DEG";
    /// Maximum angle between the normals on both sides of a smooth edge, in degrees [default: 2]
    seam => seam: Degrees, angle, "DEG";
    /// Maximum deviation of a tangent from perpendicular to its normal, in degrees [default: 5]
    tangent => tangent: Degrees, angle, "DEG";
    /// Maximum deviation of the length of a normal from 1 [default: 0.00674]
    length => length: f64, from_0, "LENGTH";
    /// Tolerance of the length below which no note is given [default: 0.001]
    strict_length => strict_length: f64, from_0, "LENGTH";
    /// Maximum angle between a polygon and the planes at its corners, in degrees [default: 10]
    planarity => planarity: Degrees, angle, "DEG";
    /// Distance below which two open edges count as one, as a fraction of the bounding box's diagonal [default: 1e-6]
    weld => weld: f64, from_0, "REL";
    /// Ratio of width to length below which a face counts as long and thin; of a triangle, height over longest edge
    /// [default: 0.001]
    needle => needle: f64, from_0, "RATIO";
    /// Edges with a larger dihedral angle count as folded, in degrees [default: 170]
    fold => fold: Degrees, angle, "DEG";
    /// Maximum error of face normals from rounding positions to 32 bits, in degrees [default: 0.5]
    rounding => rounding: Degrees, angle, "DEG";
    /// Minimum confidence needed to decide which side of an open surface is outside, from 0.5 to 1 [default: 0.9]
    confidence => confidence: Confidence, confidence, "SHARE";
    /// Maximum number of faces at a vertex [default: 48]
    valence => valence: u32, clap::value_parser!(u32), "N";
    /// Specular exponent (Blinn) at which a face counts as too large [default: its material's, or 32]
    exponent => exponent: f64, from_1, "N";
    /// Change of slope at an edge that shows as a Mach band, in 8-bit steps a pixel [default: 0.1]
    band => band: f64, from_0, "STEPS";
    /// Maximum angle between a normal and its face before shadows break up, in degrees [default: 20]
    terminator => terminator: Degrees, angle, "DEG";
    /// Maximum deviation of an outline from its curve, in pixels [default: 1]
    outline => outline: f64, from_0, "PIXELS";
    /// Width of the mesh on the screen for outlines and bands, in pixels [default: 512]
    size => size: f64, from_1, "PIXELS";
}

fn angle(text: &str) -> Result<Degrees, String> {
    match text.parse() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(Degrees(angle)),
        _ => Err(format!("expected an angle from 0 to 180 degrees, not {text}")),
    }
}

fn from_0(text: &str) -> Result<f64, String> {
    number(text, 0.0)
}

fn from_1(text: &str) -> Result<f64, String> {
    number(text, 1.0)
}

fn number(text: &str, least: f64) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&number: &f64| number.is_finite() && number >= least);
    number.ok_or_else(|| format!("expected a number of {least} or more, not {text}"))
}

choices! { Sight {
    "auto" => Auto: "from the side that most of the worst positions face",
    "front" => From(DVec3::Z): "from +z",
    "back" => From(DVec3::NEG_Z): "from −z",
    "right" => From(DVec3::X): "from +x",
    "left" => From(DVec3::NEG_X): "from −x",
    "top" => From(DVec3::Y): "from +y",
    "bottom" => From(DVec3::NEG_Y): "from −y",
} }

choices! { Severity {
    "error" => Error: "wrong in any picture",
    "warning" => Warning: "shows in some light or some viewer",
    "note" => Note: "for information, may be intended",
} }

fn kind(id: &str) -> Result<Kind, String> {
    Kind::of_id(id).ok_or_else(|| "no finding has this name; `crease inspect --explain all` lists all".into())
}
