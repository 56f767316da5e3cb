//! Notes on an input, as text.

use super::console::{Console, Verbosity};
use crease::io::{Note, Place, Severity};

/// How many notes of an input are printed unless all are asked for.
const NOTES: usize = 20;

/// Prints the notes of an input: when brief, warnings only.
pub fn print(path: &str, notes: &[Note], brief: bool, console: &Console) {
    let all = console.verbosity == Verbosity::Verbose;
    let most = if all { usize::MAX } else { NOTES };
    let wanted: Vec<_> = notes.iter().filter(|note| !brief || note.severity == Severity::Warning).collect();
    for note in wanted.iter().take(most) {
        let text = if all { with_places(note) } else { note.to_string() };
        console.about(note.severity, &format!("{path}: {text}"));
    }
    if wanted.len() > most {
        console.note(&format!("{}: {} more; -v shows them", path, wanted.len() - most));
    }
}

/// A note with the places of those that are alike.
fn with_places(note: &Note) -> String {
    let mut places: Vec<String> = note.also.iter().map(Place::to_string).collect();
    if places.is_empty() {
        return note.to_string();
    }
    if note.more > places.len() as u64 {
        places.push("…".into());
    }
    let text = note.to_string();
    format!("{}: {})", text.trim_end_matches(')'), places.join(", "))
}
