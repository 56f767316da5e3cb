//! The options of `crease inspect`.

use crate::cli::common::batch::BatchArgs;
use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::console::HELP;
use crate::cli::common::nearest::did_you_mean;
use crate::cli::common::options::{CompanionArgs, RunArgs, confidence};
use clap::Args;
use crease::io::Format;
use crease::mesh::Confidence;
use crease::normals::Weight;
use crease::num::Degrees;
use crease::quality::catalogue::{Kind, entries};
use crease::quality::{Finding, Severity, Thresholds};
use crease::report::Sight;
use crease::text::Language;
use glam::DVec3;
use std::path::PathBuf;

#[derive(Args, Clone, Debug)]
pub struct InspectArgs {
    #[arg(value_name = "INPUT", required_unless_present_any = ["explain", "manifest"], conflicts_with = "manifest")]
    pub inputs: Vec<PathBuf>,
    #[arg(short, long)]
    pub recursive: bool,
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>())]
    pub format: Option<Format>,
    #[command(flatten)]
    pub companions: CompanionArgs,
    #[arg(long, value_name = "FILE")]
    pub against: Option<PathBuf>,

    #[command(flatten)]
    pub pictures: PictureArgs,
    #[command(flatten)]
    pub findings: FindingArgs,
    #[command(flatten)]
    pub thresholds: ThresholdArgs,
    #[command(flatten)]
    pub batch: BatchArgs,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Pictures (one input only)")]
pub struct PictureArgs {
    #[arg(long, value_name = "FILE")]
    pub html: Option<PathBuf>,
    #[arg(long, value_name = "FILE")]
    pub heatmap: Option<PathBuf>,
    #[arg(long, value_name = "WHAT", value_parser = heat_map_of, requires = "heatmap")]
    pub heatmap_of: Option<HeatMapOf>,
    #[arg(long, value_name = "SIDE", default_value = "auto", value_parser = one_of::<Sight>())]
    pub view: Sight,
}

impl PictureArgs {
    /// The outputs.
    pub fn paths(&self) -> impl Iterator<Item = &PathBuf> {
        self.html.iter().chain(&self.heatmap)
    }
}

/// Options and groups of options that concern an input.
const OF_INPUTS: [&str; 14] = [
    "inputs",
    "recursive",
    "format",
    "CompanionArgs",
    "against",
    "PictureArgs",
    "ThresholdArgs",
    "BatchArgs",
    "fail_on",
    "severity",
    "ignore",
    "only",
    "places",
    "json",
];

#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Findings")]
pub struct FindingArgs {
    #[arg(long, value_name = "SEVERITY", value_parser = one_of::<Severity>())]
    pub fail_on: Option<Severity>,
    #[arg(long, value_name = "SEVERITY", value_parser = one_of::<Severity>())]
    pub severity: Option<Severity>,
    #[arg(long, value_name = "ID", value_parser = kind, value_delimiter = ',')]
    pub ignore: Vec<Kind>,
    #[arg(long, value_name = "ID", value_parser = kind, value_delimiter = ',')]
    pub only: Vec<Kind>,
    #[arg(long, value_name = "N")]
    pub places: Option<usize>,
    #[arg(long, value_name = "WORD", num_args = 1.., conflicts_with_all = OF_INPUTS)]
    pub explain: Vec<String>,
    #[arg(long, value_name = "LANG", value_parser = one_of::<Language>())]
    pub lang: Option<Language>,
}

impl FindingArgs {
    /// Whether a finding is reported.
    pub fn takes(&self, finding: &Finding) -> bool {
        finding.severity >= self.severity.unwrap_or(Severity::Note)
            && !self.ignore.contains(&finding.kind)
            && (self.only.is_empty() || self.only.contains(&finding.kind))
    }

    /// Whether notes are asked for: the text lists them, and the fix is made for them too.
    pub fn names_notes(&self) -> bool {
        self.severity == Some(Severity::Note) || !self.only.is_empty()
    }
}

/// Makes the options of the thresholds: `option => field of Thresholds: type, parser, name of the value`.
macro_rules! thresholds {
    ($($(#[$help:meta])* $option:ident => $field:ident: $type:ty, $parser:expr, $value:literal;)*) => {
        #[derive(Args, Clone, Debug)]
        #[command(next_help_heading = "Thresholds (angles in degrees)")]
        pub struct ThresholdArgs {
            $($(#[$help])*
            #[arg(long, value_name = $value, value_parser = $parser, allow_negative_numbers = true)]
            $option: Option<$type>,)*
        }

        impl ThresholdArgs {
            /// The default thresholds, replaced by those of the options.
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
    deviation => deviation: Degrees, angle, "DEG";
    past_face => against: Degrees, angle, "DEG";
    rotation => rotation: Degrees, angle, "DEG";
    quantisation => quantisation: Degrees, angle, "DEG";
    past_crease => crease: Degrees, angle, "DEG";
    seam => seam: Degrees, angle, "DEG";
    tangent => tangent: Degrees, angle, "DEG";
    length => length: f64, from_0, "LENGTH";
    strict_length => strict_length: f64, from_0, "LENGTH";
    planarity => planarity: Degrees, angle, "DEG";
    weld => weld: f64, from_0, "REL";
    needle => needle: f64, from_0, "RATIO";
    fold => fold: Degrees, angle, "DEG";
    rounding => rounding: Degrees, angle, "DEG";
    confidence => confidence: Confidence, confidence, "SHARE";
    valence => valence: u32, clap::value_parser!(u32), "N";
    exponent => exponent: f64, from_1, "N";
    band => band: f64, from_0, "STEPS";
    terminator => terminator: Degrees, angle, "DEG";
    outline => outline: f64, from_0, "PIXELS";
    size => size: f64, from_1, "PIXELS";
}

fn angle(text: &str) -> Result<Degrees, String> {
    match text.parse() {
        Ok(angle) if (0.0..=180.0).contains(&angle) => Ok(Degrees(angle)),
        _ => Err("expected an angle from 0 to 180 degrees".into()),
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
    number.ok_or_else(|| format!("expected a number of {least} or more"))
}

choices! { Sight:
    "auto" => Auto, "front" => From(DVec3::Z), "back" => From(DVec3::NEG_Z), "right" => From(DVec3::X),
    "left" => From(DVec3::NEG_X), "top" => From(DVec3::Y), "bottom" => From(DVec3::NEG_Y),
}

choices! { Severity: "error" => Error, "warning" => Warning, "note" => Note }

/// What `--heatmap-of` shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeatMapOf {
    Finding(Kind),
    Deviation,
    Weight(Weight),
}

fn heat_map_of(text: &str) -> Result<HeatMapOf, String> {
    let weight = || Weight::ALL.into_iter().find(|weight| weight.name() == text);
    match text {
        "deviation" => Ok(HeatMapOf::Deviation),
        _ => Kind::of_id(text).map(HeatMapOf::Finding).or_else(|| weight().map(HeatMapOf::Weight)).ok_or_else(|| {
            let names = entries().map(|entry| entry.id).chain(Weight::ALL.map(Weight::name));
            let similar = did_you_mean(text, names.chain(["deviation"]));
            format!("expected the id of a finding, a weight or `deviation`{HELP}{similar}`crease inspect --explain all` lists the findings")
        }),
    }
}

fn kind(id: &str) -> Result<Kind, String> {
    Kind::of_id(id).ok_or_else(|| {
        let similar = did_you_mean(id, entries().map(|entry| entry.id));
        format!("no finding has this id{HELP}{similar}`crease inspect --explain all` lists all")
    })
}
