//! The end of a verb whose command line cannot be carried out.

use super::common::console::Console;
use super::common::failure::{Exit, Failure, FailureKind};
use super::help;
use clap::error::ErrorKind;

/// Prints a message and the verb's usage as clap does for its own errors, and ends the program.
pub fn usage_error(verb: &str, message: impl ToString) -> ! {
    let mut command = help::command();
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
