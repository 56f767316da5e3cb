//! The command line: its verbs, and the message for wrong usage.

use super::artefact::args::ArtefactArgs;
use super::common::choice::one_of;
use super::common::console::Console;
use super::common::failure::{Exit, Failure, FailureKind};
use super::common::options::{Color, EXIT_CODES};
use super::inspect::args::InspectArgs;
use super::normals::args::NormalsArgs;
use super::render::args::RenderArgs;
use super::stress::args::StressArgs;
use super::surface::args::SurfaceArgs;
use super::trade::args::TradeArgs;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, Subcommand};

/// Mesh normals: compute them, split them at creases, write them back losslessly, draw what they look like.
#[derive(Parser)]
#[command(name = "crease", version, after_help = EXIT_CODES, max_term_width = 110)]
pub struct Cli {
    /// Colour on the terminal
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto", value_parser = one_of::<Color>())]
    pub color: Color,

    #[command(subcommand)]
    pub verb: Verb,
}

#[derive(Subcommand)]
pub enum Verb {
    Normals(Box<NormalsArgs>),
    Inspect(Box<InspectArgs>),
    Render(Box<RenderArgs>),
    Artefact(Box<ArtefactArgs>),
    Surface(Box<SurfaceArgs>),
    Trade(Box<TradeArgs>),
    Stress(Box<StressArgs>),
    /// Print a completion script for a shell
    Completions {
        /// The shell
        shell: clap_complete::Shell,
    },
    /// Print the manual page of the program, or of one verb
    Man {
        /// The verb; without it, the program
        verb: Option<String>,
    },
}

/// Prints a message and the verb's usage as clap does for its own errors, and ends the program.
pub fn usage_error(verb: &str, message: impl ToString) -> ! {
    let mut command = Cli::command();
    command.build();
    let verb = command.find_subcommand_mut(verb).expect("a verb of this program");
    verb.error(ErrorKind::ArgumentConflict, message.to_string()).exit()
}

/// Ends a verb whose command line cannot be carried out; wrong usage ends the program.
pub fn refused(verb: &str, failure: &Failure, console: &Console) -> Exit {
    if failure.kind == FailureKind::Usage {
        usage_error(verb, &failure.message);
    }
    console.error(&failure.message);
    failure.exit()
}
