//! The mesh with its normals as a file, and the commands that write the same file.

use crate::laboratory::Result;
use crate::subject::Subject;
use crate::view::View;
use crease::io::{OutputContent, WriteOptions, shell_word, write};
use crease::pipeline::{Task, revise};
use serde_json::json;

/// The bytes that `crease normals` writes with the options of a view.
pub(crate) fn save(subject: &Subject, view: &View, format: &str) -> Result {
    let format = subject.format(format)?;
    let task = Task { recipe: view.recipe(), ..Task::default() };
    let revision = revise(&subject.loaded, &task, Some(format), &|_| {});
    let written = write(&subject.loaded, revision.edits, format, &WriteOptions::default())
        .map_err(|error| format!("{}: {error}", subject.name))?;
    let left = written.companions.iter().filter(|file| matches!(file.content, OutputContent::CopyOf(_)));
    let answer = json!({
        "name": output(subject, format.extension()),
        "notes": written.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "left": left.map(|file| &file.name).collect::<Vec<_>>(),
        "vertices": written.vertices,
        "commands": commands(subject, view, format.extension()),
    });
    Ok((answer, vec![written.bytes]))
}

fn output(subject: &Subject, extension: &str) -> String {
    let stem = subject.name.rsplit_once('.').map_or(&*subject.name, |(stem, _)| stem);
    format!("{stem}-normals.{extension}")
}

/// The commands of a file: the one that makes a built-in surface, and the one that computes its normals.
pub(crate) fn commands(subject: &Subject, view: &View, format: &str) -> Vec<String> {
    let mut normals = format!("crease normals {}", shell_word(&subject.name));
    if view.weight != crease::normals::Weight::default() {
        normals.push_str(&format!(" --weight {}", view.weight.name()));
    }
    normals.push_str(&match view.crease {
        180.0.. => " --crease off".to_owned(),
        angle => format!(" --crease {angle}"),
    });
    if view.cone {
        normals.push_str(" --crease-rule cone");
    }
    if !view.groups {
        normals.push_str(" --groups ignore");
    }
    normals.push_str(&format!(" -o {}", shell_word(&output(subject, format))));
    subject.command.iter().cloned().chain([normals]).collect()
}
