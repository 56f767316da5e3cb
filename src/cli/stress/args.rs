//! The options of `crease stress`.

use crate::cli::common::options::RunArgs;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use crease::trade::stress::Group;

#[derive(Args)]
pub struct StressArgs {
    #[arg(long, value_name = "GROUP", value_parser = groups(), value_delimiter = ',')]
    pub only: Vec<Group>,
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
