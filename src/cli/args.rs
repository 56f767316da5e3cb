//! What may be typed. Nothing here looks at a file; [`request`](super::request) decides what it all means.

use super::artefact::ArtefactArgs;
use super::choice::{Choice, Choices};
use super::inspect::InspectArgs;
use super::render::RenderArgs;
use super::stress::StressArgs;
use super::surface::SurfaceArgs;
use super::trade::TradeArgs;
use clap::{ArgGroup, Args, Parser, Subcommand};
use crease::io::{Emit, Format, NormalFormat, TangentPolicy};
use crease::mesh::{Confidence, Orient, Weld};
use crease::normals::{Crease, CreaseRule, Groups, Precision, Slivers, Weight, When};
use crease::num::Degrees;
use crease::pipeline::Degenerate;
use std::path::PathBuf;

pub const EXIT_CODES: &str = "\
Exit codes:
  0  done
  1  `crease inspect --fail-on` found something, or an expectation of `crease stress` or a number of
     `crease artefact` is not what it should be
  2  wrong usage
  3  an input could not be read
  4  an output could not be made or stored
  5  some files of a batch failed, the others are done, whatever was found in them";

pub const NORMALS_EXAMPLES: &str = "\
Examples:
  crease normals gear.obj --crease 40 -o gear.glb
  crease normals bunny.obj -o bunny.ply --weight max
  crease normals scene.glb -o out.glb --when missing
  crease normals models --recursive --out-dir out --json > report.jsonl
  cat part.stl | crease normals - --format stl --to ply -o - > part.ply
  crease normals part.stl --emit face --json";

/// Mesh normals: compute them, split them at creases, write them back losslessly, draw what they look like.
#[derive(Parser)]
#[command(name = "crease", version, after_help = EXIT_CODES, max_term_width = 110)]
pub struct Cli {
    /// Colour on the terminal
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto", value_parser = Choices(COLORS))]
    pub color: Color,

    #[command(subcommand)]
    pub verb: Verb,
}

#[derive(Subcommand)]
pub enum Verb {
    Artefact(Box<ArtefactArgs>),
    Normals(Box<NormalsArgs>),
    Inspect(Box<InspectArgs>),
    Render(Box<RenderArgs>),
    Stress(Box<StressArgs>),
    Surface(Box<SurfaceArgs>),
    Trade(Box<TradeArgs>),
    /// Print a completion script for a shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Print the manual page of the program, or of one verb
    Man {
        /// The verb; without it, the program
        verb: Option<String>,
    },
}

/// When to use colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Color {
    Auto,
    Always,
    Never,
}

/// Compute normals and write them
///
/// Everything else in a file stays as it is, byte for byte where input and output have the same format.
#[derive(Args)]
#[command(
    after_help = NORMALS_EXAMPLES,
    after_long_help = format!("{NORMALS_EXAMPLES}\n\n{EXIT_CODES}"),
    group = ArgGroup::new("destination").args(["output", "out_dir", "in_place"])
)]
pub struct NormalsArgs {
    /// Files, folders (with --recursive), or `-` for standard input
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,

    #[command(flatten)]
    pub output: OutputArgs,
    #[command(flatten)]
    pub normals: RecipeArgs,
    #[command(flatten)]
    pub mesh: MeshArgs,
    #[command(flatten)]
    pub gltf: GltfArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args)]
#[command(next_help_heading = "Input and output")]
pub struct OutputArgs {
    /// Write to this file, or to standard output with `-` (one input only); its folder is made if need be
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Write into this folder, which is made if need be; files found in an input folder keep their places in it
    #[arg(long, value_name = "DIR")]
    pub out_dir: Option<PathBuf>,

    /// Replace each input
    #[arg(long)]
    pub in_place: bool,

    /// Format of the input, where its name cannot tell [default: by name, else by content]
    #[arg(long, value_name = "FORMAT", value_parser = Choices(FORMATS))]
    pub format: Option<Format>,

    /// Format of the output, where its name cannot tell [default: by name, else that of the input]
    #[arg(long, value_name = "FORMAT", value_parser = Choices(FORMATS))]
    pub to: Option<Format>,

    /// Take all mesh files in folders and in the folders below, hidden ones left out
    #[arg(short, long)]
    pub recursive: bool,

    /// Companion files (MTL, glTF buffers) may be read from this folder too and below, those of standard input from here alone
    /// [default: the input's folder]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Do everything but write
    #[arg(long)]
    pub dry_run: bool,

    /// Wait until each output is on the disk
    #[arg(long)]
    pub sync: bool,
}

#[derive(Args)]
#[command(next_help_heading = "Normals")]
pub struct RecipeArgs {
    /// Which normals to write
    #[arg(long, value_name = "WHAT", default_value = "corner", value_parser = Choices(EMITS))]
    pub emit: Emit,

    /// How much each face counts at a corner
    #[arg(long, value_name = "WEIGHT", default_value = "angle", value_parser = Choices(WEIGHTS))]
    pub weight: Weight,

    /// Edges that bend by more than this many degrees stay sharp; `off` for none. If the file has smoothing groups,
    /// the angle applies beside them only if it is given here [default: 40 without smoothing groups]
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true)]
    pub crease: Option<Degrees>,

    /// What sharp edges do
    #[arg(long, value_name = "RULE", default_value = "fan", value_parser = Choices(RULES))]
    pub crease_rule: CreaseRule,

    /// What smoothing groups of OBJ files do
    #[arg(long, value_name = "HOW", default_value = "honour", value_parser = Choices(GROUPS))]
    pub groups: Groups,

    /// Further edges to keep sharp; may be given several times
    #[arg(long, value_name = "KIND", value_parser = Choices(HARD_EDGES), value_delimiter = ',')]
    pub hard_edges: Vec<HardEdge>,

    /// Which normals of the file to replace
    #[arg(long, value_name = "WHICH", default_value = "always", value_parser = Choices(WHENS))]
    pub when: When,

    /// Which coincident edges are joined for smoothing: those at exactly the same place, none, or those closer than
    /// a fraction of the bounding box's diagonal. Vertices stay apart in any case
    #[arg(long, value_name = "exact|off|REL", default_value = "exact", value_parser = weld, allow_negative_numbers = true)]
    pub weld: Weld,

    /// What faces lower than the rounding of their coordinates do
    #[arg(long, value_name = "HOW", default_value = "exclude", value_parser = Choices(SLIVERS))]
    pub slivers: Slivers,

    /// How carefully to compute
    #[arg(long, value_name = "HOW", default_value = "faithful", value_parser = Choices(PRECISIONS))]
    pub precision: Precision,
}

#[derive(Args)]
#[command(next_help_heading = "Mesh")]
pub struct MeshArgs {
    /// What happens to faces without area
    #[arg(long, value_name = "HOW", default_value = "keep", value_parser = Choices(DEGENERATES))]
    pub degenerate: Degenerate,

    /// Turn every face round, and its normals with it
    #[arg(long)]
    pub flip: bool,

    /// Turn faces so that neighbours agree, or also outward. Stored normals that --when keeps stay as they are
    #[arg(long, value_name = "HOW", default_value = "keep", value_parser = Choices(ORIENTS))]
    pub orient: Orient,

    /// What --orient outward has to be surer than of the outer side of an open component, which a vote of points about what they
    /// see decides, to turn it: from 0.5 to 1; 1 turns none
    #[arg(long, value_name = "SHARE", default_value = "0.9", value_parser = confidence)]
    pub confidence: Confidence,

    /// Drop faces whose positions are infinite or not a number, instead of refusing the file
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(next_help_heading = "glTF")]
pub struct GltfArgs {
    /// What happens to tangents when normals change
    #[arg(long, value_name = "HOW", default_value = "drop", value_parser = Choices(TANGENTS))]
    pub tangents: TangentPolicy,

    /// How normals are stored; other formats have no choice, which a warning says
    #[arg(long, value_name = "TYPE", default_value = "same", value_parser = Choices(NORMAL_FORMATS))]
    pub normal_format: NormalFormat,
}

#[derive(Args)]
#[command(next_help_heading = "Running and reporting")]
pub struct RunArgs {
    /// Threads to use; the output is the same for any number [default: one per processor]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,

    /// Report as JSON, one line per input
    #[arg(long)]
    pub json: bool,

    /// Report errors only
    #[arg(short, long, conflicts_with = "verbose")]
    pub quiet: bool,

    /// Report more: every part, every note
    #[arg(short, long)]
    pub verbose: bool,
}

/// A kind of edge for `--hard-edges`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HardEdge {
    Uv,
    Material,
    Authored,
}

const COLORS: &[Choice<Color>] = &[
    ("auto", Color::Auto, "on a terminal, unless NO_COLOR is set; CLICOLOR_FORCE forces it"),
    ("always", Color::Always, "always"),
    ("never", Color::Never, "never"),
];

pub const FORMATS: &[Choice<Format>] = &[
    ("obj", Format::Obj, "Wavefront OBJ"),
    ("ply", Format::Ply, "PLY, ascii or binary"),
    ("stl", Format::Stl, "STL, ascii or binary"),
    ("gltf", Format::Gltf, "glTF 2.0, JSON"),
    ("glb", Format::Glb, "glTF 2.0, binary"),
];

pub const EMITS: &[Choice<Emit>] = &[
    (
        "corner",
        Emit::Corner,
        "one per corner of a face, shared where equal; vertices are split where the format needs it",
    ),
    ("vertex", Emit::Vertex, "one per vertex, over all faces at it; sharp edges are ignored"),
    ("face", Emit::Face, "one per face: PLY face properties, STL facets, or rows of the JSON report"),
];

pub const WEIGHTS: &[Choice<Weight>] = &[
    ("uniform", Weight::Uniform, "all alike (Gouraud 1971)"),
    ("area", Weight::Area, "area of the face"),
    ("angle", Weight::Angle, "angle of the face at the corner (Thürmer & Wüthrich 1998)"),
    ("angle-area", Weight::AngleArea, "angle times area"),
    (
        "max",
        Weight::Max,
        "sin of the angle over the product of the edge lengths; exact on a sphere (Max 1999)",
    ),
    ("edge", Weight::Edge, "1 over the product of the edge lengths"),
    ("quadric", Weight::Quadric, "least-squares quadric through the two-ring: slow, second order"),
];

pub const RULES: &[Choice<CreaseRule>] = &[
    ("fan", CreaseRule::Fan, "they cut the fan of faces at a vertex into smooth groups with one normal each"),
    ("cone", CreaseRule::Cone, "each corner averages the faces within the angle of its own face"),
];

pub const GROUPS: &[Choice<Groups>] = &[
    ("honour", Groups::Honour, "edges between different groups, or without one, are sharp"),
    ("ignore", Groups::Ignore, "nothing"),
];

pub const HARD_EDGES: &[Choice<HardEdge>] = &[
    ("uv", HardEdge::Uv, "where texture coordinates are cut"),
    ("material", HardEdge::Material, "between materials"),
    ("authored", HardEdge::Authored, "where the stored normals of the two sides differ by more than 0.1°"),
];

pub const WHENS: &[Choice<When>] = &[
    ("always", When::Always, "all"),
    ("missing", When::Missing, "those that corners lack"),
    (
        "broken",
        When::Broken,
        "those too, and those not finite, zero, or against their own face; wrong lengths are divided by",
    ),
];

pub const SLIVERS: &[Choice<Slivers>] = &[
    ("exclude", Slivers::Exclude, "they add nothing, unless a smooth group has no other face"),
    ("keep", Slivers::Keep, "they count like any other"),
];

pub const PRECISIONS: &[Choice<Precision>] = &[
    ("faithful", Precision::Faithful, "right to the last bit, at any magnitude, offset or thinness"),
    (
        "fast",
        Precision::Fast,
        "f32 arithmetic for well-shaped faces of edges 1e-6 to 1e6, else as faithful; on a mesh no faster (`crease trade` tells)",
    ),
];

const DEGENERATES: &[Choice<Degenerate>] =
    &[("keep", Degenerate::Keep, "they stay"), ("drop", Degenerate::Drop, "they are left out")];

const ORIENTS: &[Choice<Orient>] = &[
    ("keep", Orient::Keep, "as they are"),
    ("consistent", Orient::Consistent, "neighbours agree; the lesser part of a component is turned"),
    (
        "outward",
        Orient::Outward,
        "closed components face outward, cavities inward, and rooms if stored normals tell them; open ones the way that sees more, if that is sure",
    ),
];

const TANGENTS: &[Choice<TangentPolicy>] = &[
    ("drop", TangentPolicy::Drop, "left out, and a note says so; readers then generate them"),
    ("keep", TangentPolicy::Keep, "kept as they are"),
    ("regenerate", TangentPolicy::Regenerate, "made again by MikkTSpace where texture coordinates allow"),
];

const NORMAL_FORMATS: &[Choice<NormalFormat>] = &[
    ("same", NormalFormat::Same, "as in the input, else f32"),
    ("f32", NormalFormat::F32, "32-bit floats"),
    ("i16", NormalFormat::I16, "16-bit integers (KHR_mesh_quantization)"),
    ("i8", NormalFormat::I8, "8-bit integers (KHR_mesh_quantization)"),
];

pub fn confidence(text: &str) -> Result<Confidence, String> {
    match text.parse() {
        Ok(share) if (0.5..=1.0).contains(&share) => Ok(Confidence(share)),
        _ => Err("a number from 0.5 to 1 was expected".into()),
    }
}

pub fn crease_angle(text: &str) -> Result<Degrees, String> {
    if text == "off" {
        let Crease::Angle(off) = Crease::OFF else { unreachable!("off is an angle") };
        return Ok(off);
    }
    match text.parse() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(Degrees(angle)),
        _ => Err("an angle from 0 to 180 degrees, or `off`, was expected".into()),
    }
}

fn weld(text: &str) -> Result<Weld, String> {
    match (text, text.parse()) {
        ("exact", _) => Ok(Weld::Exact),
        ("off", _) => Ok(Weld::Off),
        (_, Ok(fraction)) if fraction > 0.0 && fraction < 1.0 => Ok(Weld::Relative(fraction)),
        _ => Err("`exact`, `off` or a fraction above 0 and below 1 (such as 1e-6) was expected".into()),
    }
}
