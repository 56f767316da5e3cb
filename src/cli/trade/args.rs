//! The options of `crease trade`.

use crate::cli::common::choice::{choices, one_of};
use crate::cli::common::options::{RunArgs, crease_angle};
use clap::Args;
use crease::io::Format;
use crease::num::Degrees;
use crease::trade::{Effort, Truth};
use std::path::PathBuf;

choices!(Truth: "estimated" => Estimated, "stored" => Stored);

#[derive(Args)]
pub struct TradeArgs {
    #[arg(value_name = "INPUT")]
    pub input: Option<PathBuf>,
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,
    #[arg(long, conflicts_with_all = ["full", "input"])]
    pub quick: bool,
    #[arg(long, conflicts_with = "input")]
    pub full: bool,
    #[arg(long, conflicts_with_all = ["json", "input"])]
    pub markdown: bool,
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>(), requires = "input")]
    pub format: Option<Format>,
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true, requires = "input")]
    pub crease: Option<Degrees>,
    #[arg(long, value_name = "WHICH", value_parser = one_of::<Truth>(), requires = "input")]
    pub truth: Option<Truth>,

    #[command(flatten)]
    pub run: RunArgs,
}

impl TradeArgs {
    pub fn effort(&self) -> Effort {
        match (self.quick, self.full) {
            (true, _) => Effort::Quick,
            (_, true) => Effort::Full,
            _ => Effort::Usual,
        }
    }
}
