//! The options of `crease trade`.

use crate::cli::common::choice::one_of;
use crate::cli::common::options::{EXIT_CODES, RunArgs, crease_angle};
use clap::Args;
use crease::io::Format;
use crease::num::Degrees;
use crease::trade::Effort;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  crease trade --quick
  crease trade -o trade
  crease trade part.stl --crease 30 -o part-trade";

/// Measure accuracy against speed
///
/// Without an input: the error of every weight against surfaces whose normals are known, of encodings of normals and
/// of kinds of shading, with the cost of each; about a minute and a half. Errors are the same in every run. Times
/// depend on the machine. With a mesh: how the weights differ on it, what they cost, and which one to use.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{EXIT_CODES}"))]
pub struct TradeArgs {
    /// User mesh, or `-` for standard input
    #[arg(value_name = "INPUT")]
    pub input: Option<PathBuf>,

    /// Folder for an HTML page with plots and pictures, and for its plots as SVG; created if necessary
    #[arg(short, long, value_name = "DIR")]
    pub output: Option<PathBuf>,

    /// Measure less, in some seconds
    #[arg(long, conflicts_with_all = ["full", "input"])]
    pub quick: bool,

    /// Measure more: finer meshes and larger pictures, in some minutes
    #[arg(long, conflicts_with = "input")]
    pub full: bool,

    /// Print the main tables as Markdown
    #[arg(long, conflicts_with_all = ["json", "input"])]
    pub markdown: bool,

    /// Format of the input [default: by content, else by name]
    #[arg(long, value_name = "FORMAT", value_parser = one_of::<Format>(), requires = "input")]
    pub format: Option<Format>,

    /// Crease angle of the input in degrees; `off` for none [default: 40 without smoothing groups]
    #[arg(long, value_name = "DEG|off", value_parser = crease_angle, allow_negative_numbers = true, requires = "input")]
    pub crease: Option<Degrees>,

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
