//! The options of `crease render`.

use super::fields::{self, CameraChange, TypedMaterial};
use super::values::{self, Background, FileKind, GuardSwitch, HiddenLines, ReflectionChoice, Shown, Variant};
use crate::cli::common::batch::BatchArgs;
use crate::cli::common::choice::one_of;
use crate::cli::common::options::{CompanionArgs, RunArgs, colour, crease_angle, not_negative, vector};
use clap::Args;
use crease::io::Format;
use crease::mesh::UpAxis;
use crease::normals::{Weight, When};
use crease::num::{Degrees, LinearRgb, Transfer};
use crease::raster::{Bits, Cull, FlatSample, Interpolation, Samples, Shading};
use crease::report::Overlay;
use crease::shade::{Light, Terminator, ToneRule};
use glam::DVec3;
use std::path::PathBuf;

#[derive(Args, Clone, Debug)]
pub struct RenderArgs {
    #[arg(value_name = "INPUT", required_unless_present_any = ["scene_help", "manifest"], conflicts_with = "manifest")]
    pub input: Option<PathBuf>,

    #[command(flatten)]
    pub output: PictureArgs,
    #[command(flatten)]
    pub shading: ShadingArgs,
    #[command(flatten)]
    pub scene: SceneArgs,
    #[command(flatten)]
    pub normals: NormalArgs,
    #[command(flatten)]
    pub colour: ColourArgs,
    #[command(flatten)]
    pub batch: BatchArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Input and output")]
pub struct PictureArgs {
    #[arg(short, long, value_name = "FILE", conflicts_with = "manifest")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "DIR", requires = "manifest", conflicts_with = "output")]
    pub out_dir: Option<PathBuf>,
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<FileKind>())]
    pub to: Option<FileKind>,
    #[command(flatten)]
    pub companions: CompanionArgs,
    #[arg(long)]
    pub force: bool,
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    pub size: Option<[u32; 2]>,
    #[arg(long, value_name = "N", value_parser = one_of::<Samples>())]
    pub samples: Option<Samples>,
    #[arg(long, value_name = "N", value_parser = one_of::<Bits>())]
    pub bits: Option<Bits>,
    #[arg(long, value_name = "WHAT,WHAT", value_parser = one_of::<Variant>(), value_delimiter = ',',
          conflicts_with_all = ["turntable", "probe"])]
    pub compare: Vec<Variant>,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=720), conflicts_with = "probe")]
    pub turntable: Option<u16>,
    #[arg(long, value_name = "X,Y", value_parser = values::pixel, allow_hyphen_values = true, conflicts_with_all = ["show", "overlay", "manifest"])]
    pub probe: Option<[u32; 2]>,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Shading")]
pub struct ShadingArgs {
    #[arg(long, value_name = "HOW", value_parser = one_of::<Shading>())]
    pub shading: Option<Shading>,
    #[arg(long, value_name = "HOW", value_parser = one_of::<Interpolation>())]
    pub interpolation: Option<Interpolation>,
    #[arg(long, value_name = "MODEL", value_parser = one_of::<ReflectionChoice>())]
    pub reflection: Option<ReflectionChoice>,
    #[arg(long, value_name = "N", value_parser = not_negative, allow_negative_numbers = true)]
    pub exponent: Option<f64>,
    #[arg(long, value_name = "WHERE", value_parser = one_of::<FlatSample>())]
    pub flat_sample: Option<FlatSample>,
    #[arg(long, value_name = "WHAT", value_parser = values::show)]
    pub show: Option<Shown>,
    #[arg(long, requires = "show")]
    pub no_legend: bool,
    #[arg(long, value_name = "WHAT,WHAT", value_parser = one_of::<Overlay>(), value_delimiter = ',')]
    pub overlay: Vec<Overlay>,
    #[arg(long, value_name = "HOW", value_parser = one_of::<HiddenLines>())]
    pub hidden_lines: Option<HiddenLines>,
    #[arg(long, value_name = "WHICH", value_parser = one_of::<Cull>())]
    pub cull: Option<Cull>,
    #[arg(long)]
    pub two_sided: bool,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Scene")]
pub struct SceneArgs {
    #[arg(long, value_name = "CAMERA", value_parser = fields::camera)]
    pub camera: Option<CameraChange>,
    #[arg(long, value_name = "AXIS", value_parser = one_of::<UpAxis>())]
    pub up: Option<UpAxis>,
    #[arg(long, value_name = "LIGHT", value_parser = fields::light)]
    pub light: Vec<Light>,
    #[arg(long, exclusive = true)]
    pub scene_help: bool,
    #[arg(long, value_name = "COLOUR", value_parser = colour, allow_hyphen_values = true)]
    pub ambient: Option<LinearRgb>,
    #[arg(long, value_name = "MATERIAL", value_parser = fields::material)]
    pub material: Option<TypedMaterial>,
    #[arg(long, value_name = "COLOUR", value_parser = values::background)]
    pub background: Option<Background>,
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub rotate: Option<DVec3>,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Normals (as for `crease normals`)")]
pub struct NormalArgs {
    #[arg(long, value_name = "WEIGHT", value_parser = one_of::<Weight>())]
    pub weight: Option<Weight>,
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true)]
    pub crease: Option<Degrees>,
    #[arg(long, value_name = "WHICH", value_parser = one_of::<When>())]
    pub when: Option<When>,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Formulas and numbers")]
pub struct ColourArgs {
    #[arg(long, value_name = "NAME=on|off", value_parser = values::guard)]
    pub guard: Vec<GuardSwitch>,
    #[arg(long)]
    pub literal: bool,
    #[arg(long, value_name = "HOW", value_parser = one_of::<Terminator>())]
    pub terminator: Option<Terminator>,
    #[arg(long, value_name = "RULE", value_parser = one_of::<ToneRule>())]
    pub tone: Option<ToneRule>,
    #[arg(long, value_name = "CURVE", value_parser = one_of::<Transfer>())]
    pub transfer: Option<Transfer>,
}
