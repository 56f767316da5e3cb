//! The options of `crease journal`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::RunArgs;
use clap::Args;
use std::path::PathBuf;

#[derive(Args)]
pub struct JournalArgs {
    #[arg(value_name = "ACTION", value_parser = one_of::<Action>())]
    pub action: Action,
    #[arg(value_name = "FILE", required = true)]
    pub journals: Vec<PathBuf>,
    #[command(flatten)]
    pub run: RunArgs,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    Summary,
    Failed,
    Merge,
}

choices! { Action: "summary" => Summary, "failed" => Failed, "merge" => Merge }
