//! The options of `crease stress`.

use crate::cli::common::options::{EXIT_CODES, RunArgs};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use crease::trade::stress::Group;

const EXAMPLES: &str = "\
Examples:
  crease stress --only needle,offset -v
  crease stress --list
  crease stress --json > stress.json";

/// Run the numerical extremes and print what holds
///
/// Each case computes something at the ends of the number range and compares it with exact arithmetic, or with the
/// same formula in 256 bits. The table shows the worst error of `faithful` and of `fast` (of f64 and f32 where there
/// is no such choice) next to that of plain f32 code. A cross marks visible errors: half a step of an 8-bit picture
/// or more. With -v it prints what is computed, and the source of each bound.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct StressArgs {
    /// Run only these groups of cases; repeatable
    #[arg(long, value_name = "GROUP", value_parser = groups(), value_delimiter = ',')]
    pub only: Vec<Group>,

    /// List the cases without running them
    #[arg(long, conflicts_with = "json")]
    pub list: bool,

    #[command(flatten)]
    pub run: RunArgs,
}

fn groups() -> impl TypedValueParser<Value = Group> {
    let values = Group::ALL.map(|group| PossibleValue::new(group.name()).help(group.about()));
    let group = |name: String| Group::ALL.into_iter().find(|group| group.name() == name);
    PossibleValuesParser::new(values).map(move |name| group(name).expect("clap has checked the name"))
}
