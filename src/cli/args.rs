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

#[cfg(test)]
mod tests {
    use super::*;

    /// The suite runs the commands of the pages whose output they show; the others take long, or name files of readers.
    #[test]
    fn commands_that_the_pages_only_name_are_accepted() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let docs = std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path());
        let mut count = 0;
        for page in
            docs.chain([root.join("README.md")]).filter(|path| path.extension() == Some("md".as_ref()))
        {
            let text = std::fs::read_to_string(&page).unwrap().replace("\\\n", " ");
            let commands = text.lines().filter(|line| line.starts_with("    crease "));
            for command in commands.map(|line| line.split(['#', '|']).next().unwrap_or_default()) {
                let accepted = Cli::try_parse_from(shlex::split(command.trim()).unwrap());
                assert!(accepted.is_ok(), "{}: {command}: {:?}", page.display(), accepted.err());
                count += 1;
            }
        }
        assert!(count > 5, "{count} commands found");
    }
}
