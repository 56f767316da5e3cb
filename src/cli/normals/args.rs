//! The options of `crease normals`.

use crate::cli::common::choice::{Choose, as_name, choices, one_of};
use crate::cli::common::options::{EXIT_CODES, RunArgs, confidence, crease_angle};
use clap::{ArgGroup, Args};
use crease::io::{Emit, Format, NormalFormat, TangentPolicy};
use crease::mesh::{Confidence, Orient, Weld};
use crease::normals::{CreaseRule, Groups, Precision, Slivers, Weight, When};
use crease::num::Degrees;
use crease::pipeline::Degenerate;
use serde::{Serialize, Serializer};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  crease normals gear.obj --crease 40 -o gear.glb
  crease normals scan.ply --crease off --weight quadric -o smooth.ply
  crease normals models --recursive --out-dir out --json > report.jsonl";

/// Compute normals and write them
///
/// Everything else in a file stays unchanged, byte for byte if input and output have the same format.
#[derive(Args)]
#[command(
    after_help = EXAMPLES,
    after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"),
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
    /// Output file, or `-` for standard output (one input only); folders are created if necessary
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Output folder, created if necessary; files of an input folder keep their relative paths
    #[arg(long, value_name = "DIR")]
    pub out_dir: Option<PathBuf>,

    /// Replace each input
    #[arg(long)]
    pub in_place: bool,

    /// Format of the input [default: by content, else by name]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,

    /// Format of the output [default: by name, else that of the input]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub to: Option<Format>,

    /// Include all mesh files in folders and below, except hidden ones
    #[arg(short, long)]
    pub recursive: bool,

    /// Further folder from which companion files (MTL, glTF buffers) may be read; the only one for standard input
    /// [default: the input's folder]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Do everything except writing
    #[arg(long)]
    pub dry_run: bool,

    /// Wait until each output is on the disk
    #[arg(long)]
    pub sync: bool,
}

/// The member `recipe` of the report.
#[derive(Args, Serialize)]
#[command(next_help_heading = "Normals")]
pub struct RecipeArgs {
    /// Kind of normals to write
    #[arg(long, value_name = "WHAT", default_value = "corner", value_parser = one_of::<Emit>())]
    #[serde(serialize_with = "as_name")]
    pub emit: Emit,

    /// Weight of each face at a corner
    #[arg(long, value_name = "WEIGHT", default_value = "angle", value_parser = one_of::<Weight>())]
    #[serde(serialize_with = "as_name")]
    pub weight: Weight,

    /// Crease angle in degrees: edges with a larger dihedral angle stay sharp; `off` for none. The test adds 0.01° (or a
    /// tenth of DEG, if that is less), so that chamfers at exactly DEG stay smooth. If the file has smoothing groups, the angle applies in addition to them only if it is given here [default: 40 without
    /// smoothing groups]
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true)]
    pub crease: Option<Degrees>,

    /// Effect of sharp edges
    #[arg(long, value_name = "RULE", default_value = "fan", value_parser = one_of::<CreaseRule>())]
    #[serde(serialize_with = "as_name")]
    pub crease_rule: CreaseRule,

    /// Use of smoothing groups of OBJ files
    #[arg(long, value_name = "HOW", default_value = "honour", value_parser = one_of::<Groups>())]
    #[serde(serialize_with = "as_name")]
    pub groups: Groups,

    /// Further edges to keep sharp; repeatable
    #[arg(long, value_name = "KIND", value_parser = one_of::<HardEdge>(), value_delimiter = ',')]
    #[serde(serialize_with = "hard_edge_names")]
    pub hard_edges: Vec<HardEdge>,

    /// Stored normals to replace
    #[arg(long, value_name = "WHICH", default_value = "always", value_parser = one_of::<When>())]
    #[serde(serialize_with = "as_name")]
    pub when: When,

    /// Coincident edges to smooth across: those with equal positions, none, or those closer than a fraction of the
    /// bounding box's diagonal. Vertices are not merged
    #[arg(long, value_name = "exact|off|REL", default_value = "exact", value_parser = weld, allow_negative_numbers = true)]
    #[serde(serialize_with = "weld_value")]
    pub weld: Weld,

    /// Use of slivers: faces with a height below the rounding of their coordinates
    #[arg(long, value_name = "HOW", default_value = "exclude", value_parser = one_of::<Slivers>())]
    #[serde(serialize_with = "as_name")]
    pub slivers: Slivers,

    /// Precision of the computation
    #[arg(long, value_name = "HOW", default_value = "faithful", value_parser = one_of::<Precision>())]
    #[serde(serialize_with = "as_name")]
    pub precision: Precision,
}

#[derive(Args)]
#[command(next_help_heading = "Mesh")]
pub struct MeshArgs {
    /// Treatment of faces without area
    #[arg(long, value_name = "HOW", default_value = "keep", value_parser = one_of::<Degenerate>())]
    pub degenerate: Degenerate,

    /// Reverse every face, and its normals with it
    #[arg(long)]
    pub flip: bool,

    /// Reverse faces so that neighbours agree, or also outward. Stored normals that --when keeps stay unchanged
    #[arg(long, value_name = "HOW", default_value = "keep", value_parser = one_of::<Orient>())]
    pub orient: Orient,

    /// Minimum confidence for --orient outward to reverse an open component, whose outer side is found by counting escaping rays:
    /// from 0.5 to 1; 1 reverses none
    #[arg(long, value_name = "SHARE", default_value = "0.9", value_parser = confidence)]
    pub confidence: Confidence,

    /// Drop faces whose positions are infinite or not a number, instead of refusing the file
    #[arg(long)]
    pub force: bool,
}

#[derive(Args)]
#[command(next_help_heading = "glTF")]
pub struct GltfArgs {
    /// Treatment of tangents when normals change
    #[arg(long, value_name = "HOW", default_value = "drop", value_parser = one_of::<TangentPolicy>())]
    pub tangents: TangentPolicy,

    /// Storage of normals in glTF; other formats have no choice, and a warning says so
    #[arg(long, value_name = "TYPE", default_value = "same", value_parser = one_of::<NormalFormat>())]
    pub normal_format: NormalFormat,
}

/// A kind of edge for `--hard-edges`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HardEdge {
    Uv,
    Material,
    Authored,
}

choices! { Emit {
    "corner" => Corner: "one per corner of a face, shared where equal; vertices are split where the format needs it",
    "vertex" => Vertex: "one per vertex, over all faces at it; sharp edges are ignored",
    "face" => Face: "one per face: PLY face properties, STL facets, or rows of the JSON report",
} }

choices! { CreaseRule {
    "fan" => Fan: "sharp edges cut the fan of faces at a vertex into smooth groups with one normal each",
    "cone" => Cone: "each corner averages the faces within the angle of its own face",
} }

choices! { Groups {
    "honour" => Honour: "edges between different groups, or without one, are sharp",
    "ignore" => Ignore: "none",
} }

choices! { HardEdge {
    "uv" => Uv: "edges with different texture coordinates on both sides",
    "material" => Material: "edges between two materials",
    "authored" => Authored: "edges whose stored normals on both sides differ by more than 0.1°",
} }

choices! { Slivers {
    "exclude" => Exclude: "ignored, unless a smooth group has no other face",
    "keep" => Keep: "averaged like any other face",
} }

choices! { Precision {
    "faithful" => Faithful: "correct to the last bit, at any magnitude, offset or thinness",
    "fast" => Fast: "f32 arithmetic for well-shaped faces with edges of 1e-6 to 1e6, else as faithful; cheaper (see `crease trade`)",
} }

choices! { Degenerate {
    "keep" => Keep: "they stay, with a fallback normal",
    "drop" => Drop: "they are removed",
} }

choices! { Orient {
    "keep" => Keep: "faces stay unchanged",
    "consistent" => Consistent: "neighbours agree; in each component the minority is reversed",
    "outward" => Outward: "closed components face outward, cavities inward, rooms as their stored normals; open components face their outer side, if it is certain",
} }

choices! { TangentPolicy {
    "drop" => Drop: "omitted, with a note; readers then generate them",
    "keep" => Keep: "kept unchanged",
    "regenerate" => Regenerate: "computed by MikkTSpace where texture coordinates allow",
} }

choices! { NormalFormat {
    "same" => Same: "as in the input, else f32",
    "f32" => F32: "32-bit floats",
    "i16" => I16: "16-bit integers (KHR_mesh_quantization)",
    "i8" => I8: "8-bit integers (KHR_mesh_quantization)",
} }

fn weld(text: &str) -> Result<Weld, String> {
    match (text, text.parse()) {
        ("exact", _) => Ok(Weld::Exact),
        ("off", _) => Ok(Weld::Off),
        (_, Ok(fraction)) if fraction > 0.0 && fraction < 1.0 => Ok(Weld::Relative(fraction)),
        _ => Err("`exact`, `off` or a fraction above 0 and below 1 (such as 1e-6) was expected".into()),
    }
}

fn weld_value<S: Serializer>(weld: &Weld, serializer: S) -> Result<S::Ok, S::Error> {
    match weld {
        Weld::Exact => serializer.serialize_str("exact"),
        Weld::Off => serializer.serialize_str("off"),
        Weld::Relative(fraction) => serializer.serialize_f64(*fraction),
    }
}

/// Each kind once, in the order of the help.
fn hard_edge_names<S: Serializer>(kinds: &[HardEdge], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        HardEdge::CHOICES.iter().filter(|choice| kinds.contains(&choice.1)).map(|choice| choice.0),
    )
}
