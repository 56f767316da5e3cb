//! The options of `crease artefact`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::RunArgs;
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

#[derive(Args)]
pub struct ArtefactArgs {
    #[arg(value_name = "EXPERIMENT", value_parser = experiments())]
    pub experiment: String,
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[arg(long, value_name = "LANG", default_value = "en", value_parser = one_of::<Language>())]
    pub lang: Language,
    #[arg(long, value_name = "FILE")]
    pub animate: Option<PathBuf>,
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
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,
    #[arg(long, value_name = "FILE", requires = "mesh")]
    pub finer: Option<PathBuf>,
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>(), requires = "mesh")]
    pub format: Option<Format>,
}

/// Not every experiment takes all of these: see `crease artefact list`.
#[derive(Args)]
#[command(next_help_heading = "Parameters (`crease artefact list` shows which experiment uses which)")]
pub struct ParameterArgs {
    #[arg(long, value_name = "N")]
    pub size: Option<u32>,
    #[arg(long, value_name = "N")]
    pub segments: Option<u32>,
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub light: Option<f64>,
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub turn: Option<f64>,
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub intensity: Option<f64>,
    #[arg(long, value_name = "N", allow_negative_numbers = true)]
    pub exponent: Option<f64>,
    #[arg(long, value_name = "WEIGHT", value_parser = one_of::<Weight>())]
    pub weight: Option<Weight>,
    #[arg(long, value_name = "DEG", allow_negative_numbers = true)]
    pub crease: Option<f64>,
    #[arg(long, value_name = "HOW", value_parser = one_of::<Interpolation>())]
    pub interpolation: Option<Interpolation>,
}

impl ParameterArgs {
    pub fn changes(&self) -> Changes {
        Changes {
            size: self.size,
            segments: self.segments,
            light: self.light.map(Degrees),
            turn: self.turn.map(Degrees),
            intensity: self.intensity,
            exponent: self.exponent,
            weight: self.weight,
            crease: self.crease.map(Degrees),
            interpolation: self.interpolation,
        }
    }
}

choices! { Language: "en" => English, "pt" => Portuguese }

fn experiments() -> PossibleValuesParser {
    let named = EXPERIMENTS.iter().map(|experiment| {
        PossibleValue::new(experiment.id).help(experiment.title().get(Language::English).to_owned())
    });
    let others = [(ALL, "every experiment, with an index"), (LIST, "list the experiments and their options")];
    let others = others.map(|(name, help)| PossibleValue::new(name).help(help));
    PossibleValuesParser::new(named.chain(others).collect::<Vec<_>>())
}
