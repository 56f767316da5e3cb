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
  crease inspect part.glb
  crease inspect part.glb --html report.html
  crease inspect part.obj --heatmap deviation.png --view auto
  crease inspect models --recursive --json --fail-on error
  crease inspect part.glb --against mended.glb --html change.html
  crease inspect part.obj --severity warning --ignore needle-faces
  crease inspect part.obj --only stray-normals --deviation 5 -v
  crease inspect --explain averaged-crease";

/// Tell what is wrong with a mesh's normals, why, where, and how much it shows
///
/// Stored normals are compared with those that the mesh's own were most likely made by: the weighting and the crease angle
/// that reproduce them best. Each finding has a stable name, a severity (error: wrong in any picture; warning: shows in
/// some; note: worth knowing, may be meant), a cause, its worst places, and the command that mends it if one does.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct InspectArgs {
    /// Files, folders (with --recursive), or `-` for standard input
    #[arg(value_name = "INPUT", required_unless_present = "explain")]
    pub inputs: Vec<PathBuf>,

    /// Take all mesh files in folders and in the folders below, hidden ones left out
    #[arg(short, long)]
    pub recursive: bool,

    /// Format of the input, where its name cannot tell [default: by name, else by content]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,

    /// Companion files (MTL, glTF buffers) may be read from this folder too and below, those of standard input from here alone
    /// [default: the input's folder]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Tell also what is different in this file, which has the same shape: by how many degrees the normals changed, what
    /// that shows, and which findings came and went. Faces are matched by the places of their corners, so that order,
    /// splits and cuts into triangles do not matter; `-` is standard input (one input only). --fail-on judges the input, not
    /// this file
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
    /// Write a page with pictures, histograms and explanations that opens from disk with nothing else; `-` is standard
    /// output, and the report then goes to standard error; its folder is made if need be
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,

    /// Write the mesh coloured by the deviation of its stored normals, as PNG, with a ring round the worst place of each
    /// error and warning, and a legend; `-` likewise
    #[arg(long, value_name = "FILE")]
    pub heatmap: Option<PathBuf>,

    /// Where pictures are seen from
    #[arg(long, value_name = "SIDE", default_value = "auto", value_parser = one_of::<Sight>())]
    pub view: Sight,
}

#[derive(Args)]
#[command(next_help_heading = "Findings")]
pub struct FindingArgs {
    /// End with exit code 1 if a finding that is told is at least that grave. Where a file of a batch cannot be read, that
    /// comes first: exit code 5, whatever was found in the others
    #[arg(long, value_name = "SEVERITY", value_parser = one_of::<Severity>())]
    pub fail_on: Option<Severity>,

    /// Tell only findings that are at least that grave, and how many others there are; what is not told does not count for
    /// --fail-on either
    #[arg(long, value_name = "SEVERITY", default_value = "note", value_parser = one_of::<Severity>())]
    pub severity: Severity,

    /// Leave these findings out; may be given several times
    #[arg(long, value_name = "ID", value_parser = kind, value_delimiter = ',')]
    pub ignore: Vec<Kind>,

    /// Tell these findings only; may be given several times
    #[arg(long, value_name = "ID", value_parser = kind, value_delimiter = ',')]
    pub only: Vec<Kind>,

    /// How many places of each finding to tell, the worst first [default: 10 in JSON, 1 as text, 10 with -v]
    #[arg(long, value_name = "N")]
    pub places: Option<usize>,

    /// Explain a finding, or all of them with `all`, and end
    #[arg(long, value_name = "ID", value_parser = explained, exclusive = true)]
    pub explain: Option<Explained>,
}

/// What `--explain` is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Explained {
    All,
    One(Kind),
}

#[derive(Args)]
#[command(next_help_heading = "Thresholds (angles in degrees)")]
pub struct ThresholdArgs {
    /// How far a stored normal may be from the one that its mesh's own rule gives [default: 15]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub deviation: Option<Degrees>,

    /// How far past 90° from its face a stored normal may point [default: 5]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub past_face: Option<Degrees>,

    /// How far all stored normals may be turned together [default: 5]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub rotation: Option<Degrees>,

    /// How far the precision of storage may turn normals [default: 0.05]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub quantisation: Option<Degrees>,

    /// How far past the crease angle an edge with one normal on both sides may bend [default: 10]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub past_crease: Option<Degrees>,

    /// How far the normals on the two sides of a smooth edge may be apart at both ends [default: 2]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub seam: Option<Degrees>,

    /// How far a tangent may lean towards its normal or away from it [default: 5]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub tangent: Option<Degrees>,

    /// Most by which the length of a normal may differ from 1 [default: 0.00674]
    #[arg(long, value_name = "LENGTH", value_parser = from_0, allow_negative_numbers = true)]
    pub length: Option<f64>,

    /// The same without a note [default: 0.001]
    #[arg(long, value_name = "LENGTH", value_parser = from_0, allow_negative_numbers = true)]
    pub strict_length: Option<f64>,

    /// How far the corners of a polygon may leave its plane [default: 10]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub planarity: Option<Degrees>,

    /// How close the ends of open edges are that are taken for one, over the bounding box's diagonal [default: 1e-6]
    #[arg(long, value_name = "REL", value_parser = from_0, allow_negative_numbers = true)]
    pub weld: Option<f64>,

    /// Width over length below which a face is a needle: of a triangle, height over longest edge [default: 0.001]
    #[arg(long, value_name = "RATIO", value_parser = from_0, allow_negative_numbers = true)]
    pub needle: Option<f64>,

    /// From which bend on an edge is folded [default: 170]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub fold: Option<Degrees>,

    /// How far rounding positions to 32 bits may turn the normals of faces [default: 0.5]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub rounding: Option<Degrees>,

    /// What it has to be surer than which side of an open component is its outer one, from 0.5 to 1 [default: 0.9]
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true, value_parser = confidence)]
    pub confidence: Option<Confidence>,

    /// Most faces round a vertex [default: 48]
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub valence: Option<u32>,

    /// The highlight that each face has to hold, as its Blinn exponent [default: its material's, or 32]
    #[arg(long, value_name = "N", value_parser = from_1, allow_negative_numbers = true)]
    pub exponent: Option<f64>,

    /// The change of slope at an edge, in 8-bit steps a pixel, that shows as a Mach band [default: 0.1]
    #[arg(long, value_name = "STEPS", value_parser = from_0, allow_negative_numbers = true)]
    pub band: Option<f64>,

    /// How far a normal may lean from its face before shadows break up [default: 20]
    #[arg(long, value_name = "DEG", value_parser = angle, allow_negative_numbers = true)]
    pub terminator: Option<Degrees>,

    /// Pixels by which an outline may cut its curve [default: 1]
    #[arg(long, value_name = "PIXELS", value_parser = from_0, allow_negative_numbers = true)]
    pub outline: Option<f64>,

    /// The width of the mesh on the screen, in pixels, for outlines and bands [default: 512]
    #[arg(long, value_name = "PIXELS", value_parser = from_1, allow_negative_numbers = true)]
    pub size: Option<f64>,
}

impl ThresholdArgs {
    /// The defaults with the options in their place.
    pub fn resolve(&self, places: Option<usize>) -> Thresholds {
        let usual = Thresholds::default();
        let length = self.length.unwrap_or(usual.length);
        Thresholds {
            length,
            strict_length: self.strict_length.unwrap_or(usual.strict_length).min(length),
            deviation: self.deviation.unwrap_or(usual.deviation),
            against: self.past_face.unwrap_or(usual.against),
            rotation: self.rotation.unwrap_or(usual.rotation),
            quantisation: self.quantisation.unwrap_or(usual.quantisation),
            tangent: self.tangent.unwrap_or(usual.tangent),
            crease: self.past_crease.unwrap_or(usual.crease),
            seam: self.seam.unwrap_or(usual.seam),
            weld: self.weld.unwrap_or(usual.weld),
            needle: self.needle.unwrap_or(usual.needle),
            planarity: self.planarity.unwrap_or(usual.planarity),
            fold: self.fold.unwrap_or(usual.fold),
            confidence: self.confidence.unwrap_or(usual.confidence),
            valence: self.valence.unwrap_or(usual.valence),
            rounding: self.rounding.unwrap_or(usual.rounding),
            terminator: self.terminator.unwrap_or(usual.terminator),
            exponent: self.exponent,
            band: self.band.unwrap_or(usual.band),
            outline: self.outline.unwrap_or(usual.outline),
            size: self.size.unwrap_or(usual.size),
            places: places.unwrap_or(usual.places),
        }
    }
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
    "auto" => Auto: "from where most of the worst places face",
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
    "note" => Note: "worth knowing, may be meant",
} }

fn kind(id: &str) -> Result<Kind, String> {
    Kind::of_id(id)
        .ok_or_else(|| "no finding has this name; `crease inspect --explain all` lists them".into())
}

fn explained(id: &str) -> Result<Explained, String> {
    if id == "all" { Ok(Explained::All) } else { kind(id).map(Explained::One) }
}
