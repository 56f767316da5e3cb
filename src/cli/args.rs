//! The command line: its verbs.

use super::artefact::args::ArtefactArgs;
use super::common::choice::one_of;
use super::common::options::Color;
use super::inspect::args::InspectArgs;
use super::journal::args::JournalArgs;
use super::normals::args::NormalsArgs;
use super::plan::args::PlanArgs;
use super::render::args::RenderArgs;
use super::stress::args::StressArgs;
use super::surface::args::SurfaceArgs;
use super::trade::args::TradeArgs;
use clap::{Parser, Subcommand};
use std::ffi::OsString;

#[derive(Parser)]
#[command(name = "crease", version, max_term_width = 110, disable_help_subcommand = true)]
#[command(subcommand_value_name = "VERB", subcommand_help_heading = "Verbs")]
pub struct Cli {
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
    Plan(Box<PlanArgs>),
    Journal(Box<JournalArgs>),
    Completions { shell: clap_complete::Shell },
    Man { verb: Option<String> },
    Help { verb: Vec<OsString> },
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
