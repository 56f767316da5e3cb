//! The options of `crease artefact`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::{EXIT_CODES, RunArgs};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use crease::artefact::{Changes, EXPERIMENTS, Language};
use crease::io::Format;
use crease::normals::Weight;
use crease::num::Degrees;
use crease::raster::Interpolation;
use std::path::PathBuf;

/// What stands for every experiment, and for the list of them.
pub const ALL: &str = "all";
pub const LIST: &str = "list";

const EXAMPLES: &str = "\
Examples:
  crease artefact list
  crease artefact mach-bands -o out
  crease artefact mach-bands --segments 24 --light 60 -o out
  crease artefact all -o gallery
  crease artefact all -o galeria --lang pt
  crease artefact silhouette --mesh bunny.obj --json
  crease artefact silhouette --mesh coarse.ply --finer fine.ply -o out
  crease artefact orientation --animate out.gif";

/// Show the classic artefacts of shading, with numbers
///
/// Each experiment states what textbooks claim, runs it, and tells what it measured beside closed forms, whether the claim
/// holds, and under what conditions it fails. With -o it writes a page that explains all of it and each picture as a file; the
/// page of all experiments has an index. Of `all`, an option changes those that take it, which a note names, and those that have
/// another range for its value are left out, with a note. A
/// number that is not what it should be is told as an error, and makes the exit code 1.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct ArtefactArgs {
    /// Which experiment; `all` for every one, `list` to tell what they are and which options they take
    #[arg(value_name = "EXPERIMENT", value_parser = experiments())]
    pub experiment: String,

    /// Write the page, pictures (PNG) and plots (SVG) into this folder, which is made if need be
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// The language of pages, captions and tables
    #[arg(long, value_name = "LANG", default_value = "en", value_parser = one_of::<Language>())]
    pub lang: Language,

    /// Draw the experiment's animation into this GIF file
    #[arg(long, value_name = "FILE")]
    pub animate: Option<PathBuf>,

    /// Frames of the animation
    #[arg(long, value_name = "N", default_value = "36", value_parser = clap::value_parser!(u16).range(2..=720),
          requires = "animate")]
    pub frames: u16,

    #[command(flatten)]
    pub own: OwnArgs,
    #[command(flatten)]
    pub parameters: ParameterArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args)]
#[command(next_help_heading = "A mesh of your own")]
pub struct OwnArgs {
    /// Run it on this mesh, or `-` for standard input; `crease artefact list` tells what is looked at
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,

    /// A finer mesh of the same thing, in the same place, to take for the truth (`silhouette`)
    #[arg(long, value_name = "FILE", requires = "mesh")]
    pub finer: Option<PathBuf>,

    /// Format of the meshes, where their names cannot tell [default: by name, else by content]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>(), requires = "mesh")]
    pub format: Option<Format>,
}

/// Not every experiment takes all of these: see `crease artefact list`.
#[derive(Args)]
#[command(next_help_heading = "Parameters (`crease artefact list` tells which experiment takes which)")]
pub struct ParameterArgs {
    /// Width and height of each picture in pixels, 32 to 1024
    #[arg(long, value_name = "N")]
    pub size: Option<u32>,

    /// How finely things are cut: segments of a circle, cells of a grid
    #[arg(long, value_name = "N")]
    pub segments: Option<u32>,

    /// The light's angle, mostly off the axis of view
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub light: Option<f64>,

    /// The exponent of the highlight
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub exponent: Option<f64>,

    /// How faces count in vertex normals
    #[arg(long, value_name = "WEIGHT", value_parser = one_of::<Weight>())]
    pub weight: Option<Weight>,

    /// The crease angle of the cure
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub crease: Option<f64>,

    /// How values at corners spread over faces in the animation of `orientation`; its pictures show every way
    #[arg(long, value_name = "HOW", value_parser = one_of::<Interpolation>())]
    pub interpolation: Option<Interpolation>,
}

impl ParameterArgs {
    pub fn changes(&self) -> Changes {
        Changes {
            size: self.size,
            segments: self.segments,
            light: self.light.map(Degrees),
            exponent: self.exponent,
            weight: self.weight,
            crease: self.crease.map(Degrees),
            interpolation: self.interpolation,
        }
    }
}

choices! { Language {
    "en" => English: "English",
    "pt" => Portuguese: "Portuguese",
} }

fn experiments() -> PossibleValuesParser {
    let named = EXPERIMENTS.iter().map(|experiment| {
        PossibleValue::new(experiment.id).help(experiment.title().get(Language::English).to_owned())
    });
    let others = [(ALL, "every experiment, with an index"), (LIST, "tell what there is")];
    let others = others.map(|(name, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(named.chain(others).collect::<Vec<_>>())
}
