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

/// The names of all experiments together, and of their list.
pub const ALL: &str = "all";
pub const LIST: &str = "list";

const EXAMPLES: &str = "\
Examples:
  crease artefact list
  crease artefact mach-bands --segments 24 --light 60 -o out
  crease artefact all -o gallery";

/// Show the classic artefacts of shading, with numbers
///
/// Each experiment states what textbooks claim, draws it, and measures it next to a closed form. It reports whether
/// the claim holds and under what conditions it fails. With -o it writes a page with all pictures; `all` adds an
/// index. With `all`, an option changes the experiments that take it, and a note names these. A measure that is off
/// its closed form is an error and gives exit code 1.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct ArtefactArgs {
    /// Experiment by its id; `all` for every one, `list` to list them with their options
    #[arg(value_name = "EXPERIMENT", value_parser = experiments())]
    pub experiment: String,

    /// Folder for the page, pictures (PNG) and plots (SVG); created if necessary
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Language of pages, captions and tables
    #[arg(long, value_name = "LANG", default_value = "en", value_parser = one_of::<Language>())]
    pub lang: Language,

    /// GIF file for the animation of the experiment
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
#[command(next_help_heading = "User mesh")]
pub struct OwnArgs {
    /// Mesh to run the experiment on, or `-` for standard input; `crease artefact list` shows what is measured on it
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,

    /// Finer mesh of the same object at the same position, as the truth (`silhouette`)
    #[arg(long, value_name = "FILE", requires = "mesh")]
    pub finer: Option<PathBuf>,

    /// Format of the meshes [default: by content, else by name]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>(), requires = "mesh")]
    pub format: Option<Format>,
}

/// Not every experiment takes all of these: see `crease artefact list`.
#[derive(Args)]
#[command(next_help_heading = "Parameters (`crease artefact list` shows which experiment uses which)")]
pub struct ParameterArgs {
    /// Width and height of each picture in pixels, 32 to 1024
    #[arg(long, value_name = "N")]
    pub size: Option<u32>,

    /// Segments of a circle, or cells of a grid
    #[arg(long, value_name = "N")]
    pub segments: Option<u32>,

    /// Angle of the light, in most experiments from the view direction
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub light: Option<f64>,

    /// Exponent of the highlight
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub exponent: Option<f64>,

    /// Weight of faces in vertex normals
    #[arg(long, value_name = "WEIGHT", value_parser = one_of::<Weight>())]
    pub weight: Option<Weight>,

    /// Crease angle of the cure
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub crease: Option<f64>,

    /// Interpolation in the animation of `orientation`; its pictures show all kinds
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
    let others = [(ALL, "every experiment, with an index"), (LIST, "list the experiments and their options")];
    let others = others.map(|(name, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(named.chain(others).collect::<Vec<_>>())
}
