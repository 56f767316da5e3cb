//! The options of `crease normals`.

use crate::cli::common::batch::BatchArgs;
use crate::cli::common::choice::{Choose, as_name, choices, one_of, written_formats};
use crate::cli::common::options::{CompanionArgs, RunArgs, confidence, crease_angle};
use clap::{ArgGroup, Args};
use crease::io::{Emit, Format, MaterialFallback, MeshCompression, NormalFormat, TangentPolicy};
use crease::mesh::{Confidence, Orient, UpAxis, Weld};
use crease::normals::{CreaseRule, Groups, Precision, Slivers, Weight, When};
use crease::num::Degrees;
use crease::pipeline::Degenerate;
use serde::{Serialize, Serializer};
use std::path::PathBuf;

#[derive(Args, Clone, Debug)]
#[command(group = ArgGroup::new("destination").args(["output", "out_dir", "in_place"]))]
pub struct NormalsArgs {
    #[arg(value_name = "INPUT", required_unless_present = "manifest", conflicts_with = "manifest")]
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
    pub batch: BatchArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Input and output")]
pub struct OutputArgs {
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "DIR")]
    pub out_dir: Option<PathBuf>,
    #[arg(long)]
    pub in_place: bool,
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,
    #[arg(long, value_name = "FORMAT", value_parser = written_formats())]
    pub to: Option<Format>,
    #[arg(short, long)]
    pub recursive: bool,
    #[command(flatten)]
    pub companions: CompanionArgs,
    #[arg(long)]
    pub dry_run: bool,
    #[arg(long)]
    pub sync: bool,
}

/// The member `recipe` of the report.
#[derive(Args, Clone, Debug, Serialize)]
#[command(next_help_heading = "Normals")]
pub struct RecipeArgs {
    #[arg(long, value_name = "WHAT", default_value = "corner", value_parser = one_of::<Emit>())]
    #[serde(serialize_with = "as_name")]
    pub emit: Emit,
    #[arg(long, value_name = "WEIGHT", default_value = "angle", value_parser = one_of::<Weight>())]
    #[serde(serialize_with = "as_name")]
    pub weight: Weight,
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true)]
    pub crease: Option<Degrees>,
    #[arg(long, value_name = "RULE", default_value = "fan", value_parser = one_of::<CreaseRule>())]
    #[serde(serialize_with = "as_name")]
    pub crease_rule: CreaseRule,
    #[arg(long, value_name = "HOW", default_value = "honour", value_parser = one_of::<Groups>())]
    #[serde(serialize_with = "as_name")]
    pub groups: Groups,
    #[arg(long, value_name = "KIND", value_parser = one_of::<HardEdge>(), value_delimiter = ',')]
    #[serde(serialize_with = "hard_edge_names")]
    pub hard_edges: Vec<HardEdge>,
    #[arg(long, value_name = "WHICH", default_value = "always", value_parser = one_of::<When>())]
    #[serde(serialize_with = "as_name")]
    pub when: When,
    #[arg(long, value_name = "exact|off|REL", default_value = "exact", value_parser = weld, allow_negative_numbers = true)]
    #[serde(serialize_with = "weld_value")]
    pub weld: Weld,
    #[arg(long, value_name = "HOW", default_value = "exclude", value_parser = one_of::<Slivers>())]
    #[serde(serialize_with = "as_name")]
    pub slivers: Slivers,
    #[arg(long, value_name = "HOW", default_value = "faithful", value_parser = one_of::<Precision>())]
    #[serde(serialize_with = "as_name")]
    pub precision: Precision,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Mesh")]
pub struct MeshArgs {
    #[arg(long, value_name = "exact|off|FRACTION", value_parser = merging, allow_negative_numbers = true)]
    pub merge: Option<Merging>,
    #[arg(long, value_name = "AXIS", value_parser = one_of::<UpAxis>())]
    pub up: Option<UpAxis>,
    #[arg(long, value_name = "FACTOR|UNIT", value_parser = scale, allow_negative_numbers = true)]
    pub scale: Option<Scale>,
    #[arg(long, value_name = "HOW", default_value = "keep", value_parser = one_of::<Degenerate>())]
    pub degenerate: Degenerate,
    #[arg(long)]
    pub flip: bool,
    #[arg(long, value_name = "HOW", default_value = "keep", value_parser = one_of::<Orient>())]
    pub orient: Orient,
    #[arg(long, value_name = "SHARE", default_value = "0.9", value_parser = confidence)]
    pub confidence: Confidence,
    #[arg(long)]
    pub force: bool,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "glTF")]
pub struct GltfArgs {
    #[arg(long, value_name = "HOW", default_value = "auto", value_parser = one_of::<TangentPolicy>())]
    pub tangents: TangentPolicy,
    #[arg(long, value_name = "TYPE", default_value = "same", value_parser = one_of::<NormalFormat>())]
    pub normal_format: NormalFormat,
    #[arg(long, value_name = "WHICH", default_value = "default", value_parser = one_of::<MaterialFallback>())]
    pub material: MaterialFallback,
    #[arg(long, value_name = "HOW", default_value = "none", value_parser = one_of::<MeshCompression>())]
    pub compress: MeshCompression,
}

/// A factor for coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    Factor(f64),
    /// The unit of the file that is not glTF, in metres.
    Unit(f64),
}

/// Which vertices are merged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Merging {
    Off,
    Exact,
    /// Those that are closer than this fraction of the diagonal, too.
    Near(f64),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HardEdge {
    Uv,
    Material,
    Authored,
}

choices! { Emit: "corner" => Corner, "vertex" => Vertex, "face" => Face }

choices! { CreaseRule: "fan" => Fan, "cone" => Cone }

choices! { Groups: "honour" => Honour, "ignore" => Ignore }

choices! { HardEdge: "uv" => Uv, "material" => Material, "authored" => Authored }

choices! { Slivers: "exclude" => Exclude, "keep" => Keep }

choices! { Precision: "faithful" => Faithful, "fast" => Fast }

choices! { Degenerate: "keep" => Keep, "drop" => Drop }

choices! { Orient: "keep" => Keep, "consistent" => Consistent, "outward" => Outward }

choices! { TangentPolicy: "auto" => Auto, "drop" => Drop, "keep" => Keep, "regenerate" => Regenerate }

choices! { MeshCompression: "none" => None, "meshopt" => Meshopt }

choices! { NormalFormat: "same" => Same, "f32" => F32, "i16" => I16, "i8" => I8 }

choices! { MaterialFallback: "default" => Plastic, "none" => Omit }

fn weld(text: &str) -> Result<Weld, String> {
    exact_off_or(text, Weld::Exact, Weld::Off, Weld::Relative)
}

fn merging(text: &str) -> Result<Merging, String> {
    exact_off_or(text, Merging::Exact, Merging::Off, Merging::Near)
}

fn exact_off_or<T>(text: &str, exact: T, off: T, near: fn(f64) -> T) -> Result<T, String> {
    match (text, text.parse()) {
        ("exact", _) => Ok(exact),
        ("off", _) => Ok(off),
        (_, Ok(fraction)) if fraction > 0.0 && fraction < 1.0 => Ok(near(fraction)),
        _ => Err("expected `exact`, `off` or a fraction above 0 and below 1 (such as 1e-6)".into()),
    }
}

fn scale(text: &str) -> Result<Scale, String> {
    match (text, text.parse()) {
        ("mm", _) => Ok(Scale::Unit(0.001)),
        ("cm", _) => Ok(Scale::Unit(0.01)),
        ("m", _) => Ok(Scale::Unit(1.0)),
        ("in", _) => Ok(Scale::Unit(0.0254)),
        (_, Ok(factor)) if factor > 0.0 && f64::is_finite(factor) => Ok(Scale::Factor(factor)),
        _ => Err("expected a factor above 0, or a unit: mm, cm, m, in".into()),
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
