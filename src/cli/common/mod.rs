//! What several verbs share.

/// Inputs from a list, and a share of them.
pub mod batch;
/// Option values out of a fixed list.
pub mod choice;
/// The words that the program was called with.
pub mod command_line;
/// Streams, colours and verbosity.
pub mod console;
/// Why a run failed, and the exit code for that.
pub mod failure;
/// Files and standard input.
pub mod input;
/// Several inputs at a time.
pub mod jobs;
/// What a batch has done.
pub mod journal;
/// The journal of a batch in use.
pub mod ledger;
/// The known name that is most similar to an unknown one.
pub mod nearest;
/// Numbers with the words that belong to them.
pub mod numbers;
/// Options that several verbs have.
pub mod options;
/// Files and standard output, written whole or not at all.
pub mod output;
/// Outputs that would replace an input or another output.
pub mod output_conflicts;
/// Progress bars.
pub mod progress;
/// Members that JSON reports share.
pub mod report;
/// The loop over the inputs of a verb.
pub mod run_batch;
/// Files, and standard input and output.
pub mod stream;
