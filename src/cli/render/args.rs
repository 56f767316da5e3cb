//! The options of `crease render`.

use super::fields::{self, CameraChange};
use super::values::{self, GuardSwitch, HiddenLines, ReflectionChoice, Variant};
use crate::cli::common::choice::one_of;
use crate::cli::common::options::{EXIT_CODES, RunArgs, crease_angle};
use crate::cli::common::vectors::{colour, not_negative, vector};
use clap::Args;
use crease::io::Format;
use crease::normals::{Weight, When};
use crease::num::{Degrees, LinearRgb, Transfer};
use crease::raster::{Bits, Cull, FlatSample, Interpolation, Samples, Shading, Show};
use crease::report::Overlay;
use crease::shade::{Light, Material, Terminator, ToneRule};
use glam::DVec3;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  crease render gear.obj --shading flat --overlay wire,creases -o gear.png
  crease render ball.glb --compare flat,gouraud,phong -o panels.png
  crease render scene.toml --camera 'eye=3,2,5 target=0,0,0 angle=40' -o scene.png";

const SYNTAX: &str = "\
Cameras, lights and materials are words KEY=VALUE between spaces, in quotes for the shell.
Vectors are X,Y,Z:
  --camera    eye=V target=V up=V near=N
              angle=DEG (from top to bottom) or height=N (parallel projection)
              omitted keys keep their values
  --light     directional towards=V
              point       position=V
              spot        position=V axis=V [cut-off=DEG] [soft-edge=DEG] [exponent=N]
              rectangle   centre=V u=V v=V (from the centre to the middles of two sides)
                          the side of u × v emits
              disc        centre=V normal=V radius=N
              each with [colour=C], point and spot with
              [attenuation=none|inverse-square|inverse-square:RANGE|offset:K|KC,KL,KQ]
  --material  [colour=C] [ka=N] [kd=N] [ks=N] [highlight=C] [exponent=N]
              with a warning if kd times colour plus ks times highlight is over 1
              in red, green or blue
Colours are #rrggbb (sRGB), or linear light: R,G,B, or one number for a grey.
With --transfer direct, which writes light unchanged, #808080 becomes 55, because its light is
0.216; 0.502 becomes 128.";

/// Draw a mesh or a scene
///
/// A mesh is framed automatically, lit by a key light and drawn with the normals that `crease normals` would write. A
/// scene (TOML or glTF) has its own camera, lights and settings; options override them.
#[derive(Args)]
#[command(
    after_help = EXAMPLES,
    after_long_help = format!("{SYNTAX}\n\n{EXAMPLES}\n\n{EXIT_CODES}")
)]
pub struct RenderArgs {
    /// Mesh, glTF file, scene in TOML, or `-` for a mesh from standard input
    #[arg(value_name = "INPUT", required_unless_present = "scene_help")]
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
    pub run: RunArgs,
}

#[derive(Args)]
#[command(next_help_heading = "Input and output")]
pub struct PictureArgs {
    /// Output picture, PNG or GIF by its name, or `-` for standard output
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<PathBuf>,

    /// Format of the input [default: by content, else by name]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,

    /// Further folder from which companion files (meshes of a scene, MTL, glTF buffers) may be read; the only one for
    /// standard input [default: the input's folder]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,

    /// Omit faces with positions that are infinite or not a number, instead of refusing the file
    #[arg(long)]
    pub force: bool,

    /// Width and height in pixels, each up to 16384; with --compare those of each panel [default: 640x480]
    #[arg(long, value_name = "WxH", value_parser = values::size)]
    pub size: Option<[u32; 2]>,

    /// Samples per pixel, each shaded separately; 4, 8 and 16 are the patterns of Direct3D [default: 4; for scenes in
    /// TOML their own value, or 1]
    #[arg(long, value_name = "N", value_parser = one_of::<Samples>())]
    pub samples: Option<Samples>,

    /// Bits of each component [default: 8]
    #[arg(long, value_name = "N", value_parser = one_of::<Bits>())]
    pub bits: Option<Bits>,

    /// Draw panels side by side that differ in shading or interpolation, as --compare flat,gouraud,phong,exact or
    /// --compare scanline,affine,perspective; with --shading only interpolations, with --interpolation only shadings
    #[arg(long, value_name = "WHAT,WHAT", value_parser = one_of::<Variant>(), value_delimiter = ',',
          conflicts_with_all = ["turntable", "probe"])]
    pub compare: Vec<Variant>,

    /// Draw an animation of N frames: one turn about the upright axis; camera and lights stay. Needs a GIF output
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(2..=720), conflicts_with = "probe")]
    pub turntable: Option<u16>,

    /// Print the numbers behind a pixel, from 0 at the upper left: the visible face, N, L, V, R, H and every term.
    /// Objects, faces, vertices and lights count from 0
    #[arg(long, value_name = "X,Y", value_parser = values::pixel, allow_hyphen_values = true, conflicts_with_all = ["show", "overlay"])]
    pub probe: Option<[u32; 2]>,
}

#[derive(Args)]
#[command(next_help_heading = "Shading")]
pub struct ShadingArgs {
    /// Where colours are computed [default: phong]
    #[arg(long, value_name = "HOW", value_parser = one_of::<Shading>())]
    pub shading: Option<Shading>,

    /// Interpolation of values over a face [default: perspective]
    #[arg(long, value_name = "HOW", value_parser = one_of::<Interpolation>())]
    pub interpolation: Option<Interpolation>,

    /// Highlight model, or the stored vertex colours without light [default: blinn]
    #[arg(long, value_name = "MODEL", value_parser = one_of::<ReflectionChoice>())]
    pub reflection: Option<ReflectionChoice>,

    /// Exponent of the highlight, 0 or more: a larger exponent gives a smaller highlight [default: the material's, or
    /// 32]
    #[arg(long, value_name = "N", value_parser = not_negative, allow_negative_numbers = true)]
    pub exponent: Option<f64>,

    /// Point at which flat faces are lit [default: centroid]
    #[arg(long, value_name = "WHERE", value_parser = one_of::<FlatSample>())]
    pub flat_sample: Option<FlatSample>,

    /// Draw normals, facing, depth, face-id or deviation in place of light. `normals`: (n + 1)/2; `facing`: front light blue,
    /// back dark red; `depth`: white near, black far; `face-id`: a colour for each face; `deviation[=DEG]`: the angle between
    /// the interpolated normal and that of the analytic surface of the object, else of the face, from black over red and
    /// yellow to white at 15° or the given angle
    #[arg(long, value_name = "WHAT", value_parser = values::show)]
    pub show: Option<Show>,

    /// Draw lines over the picture
    #[arg(long, value_name = "WHAT,WHAT", value_parser = one_of::<Overlay>(), value_delimiter = ',')]
    pub overlay: Vec<Overlay>,

    /// Treatment of lines behind surfaces [default: remove]
    #[arg(long, value_name = "HOW", value_parser = one_of::<HiddenLines>())]
    pub hidden_lines: Option<HiddenLines>,

    /// Omit faces by their visible side; wireframes omit their edges, overlays keep all lines [default: none]
    #[arg(long, value_name = "WHICH", value_parser = one_of::<Cull>())]
    pub cull: Option<Cull>,

    /// Light back faces on the visible side
    #[arg(long)]
    pub two_sided: bool,
}

#[derive(Args)]
#[command(next_help_heading = "Scene")]
pub struct SceneArgs {
    /// Camera; an invalid one of a glTF file is then ignored [default: frames the mesh, 30° from top to bottom]
    #[arg(long, value_name = "CAMERA", value_parser = fields::camera)]
    pub camera: Option<CameraChange>,

    /// Light, in place of all lights of the scene except ambient light; repeatable
    #[arg(long, value_name = "LIGHT", value_parser = fields::light)]
    pub light: Vec<Light>,

    /// Print the keys of scene files and exit
    #[arg(long, exclusive = true)]
    pub scene_help: bool,

    /// Ambient light, in place of that of the scene
    #[arg(long, value_name = "COLOUR", value_parser = colour, allow_hyphen_values = true)]
    pub ambient: Option<LinearRgb>,

    /// Material of all objects
    #[arg(long, value_name = "MATERIAL", value_parser = fields::material)]
    pub material: Option<Material>,

    /// Background colour; the wireframe of a mesh is black on a bright one [default: black]
    #[arg(long, value_name = "COLOUR", value_parser = colour)]
    pub background: Option<LinearRgb>,

    /// Rotate the objects about the centre of their bounding box, in degrees: about x, then y, then z; camera and
    /// lights stay
    #[arg(long, value_name = "X,Y,Z", value_parser = vector, allow_hyphen_values = true)]
    pub rotate: Option<DVec3>,
}

#[derive(Args)]
#[command(next_help_heading = "Normals (as for `crease normals`)")]
pub struct NormalArgs {
    /// Weight of each face at a corner [default: angle]
    #[arg(long, value_name = "WEIGHT", value_parser = one_of::<Weight>())]
    pub weight: Option<Weight>,

    /// Crease angle in degrees; `off` for none [default: 40 without smoothing groups]
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true)]
    pub crease: Option<Degrees>,

    /// Stored normals to replace [default: always; normals of a scene file only if --weight, --crease or --when is used]
    #[arg(long, value_name = "WHICH", value_parser = one_of::<When>())]
    pub when: Option<When>,
}

impl NormalArgs {
    /// Whether any of them was typed.
    pub fn are_typed(&self) -> bool {
        self.weight.is_some() || self.crease.is_some() || self.when.is_some()
    }
}

#[derive(Args)]
#[command(next_help_heading = "Formulas and numbers")]
pub struct ColourArgs {
    /// Switch one guard on or off: highlight, diffuse, spot, renormalise, underflow; repeatable. A guard keeps the
    /// result of a formula in range; textbooks usually omit it
    #[arg(long, value_name = "NAME=on|off", value_parser = values::guard)]
    pub guard: Vec<GuardSwitch>,

    /// Switch all guards off, except those that --guard switches on
    #[arg(long)]
    pub literal: bool,

    /// Light on faces that point away from it under interpolated normals that do not, in Phong shading [default:
    /// smooth]
    #[arg(long, value_name = "HOW", value_parser = one_of::<Terminator>())]
    pub terminator: Option<Terminator>,

    /// Treatment of colours above 1 [default: clamp]
    #[arg(long, value_name = "RULE", value_parser = one_of::<ToneRule>())]
    pub tone: Option<ToneRule>,

    /// Transfer from linear light to codes [default: srgb; for --show normals and depth, direct]
    #[arg(long, value_name = "CURVE", value_parser = one_of::<Transfer>())]
    pub transfer: Option<Transfer>,
}
