//! Notes on an input, for people.

use super::console::{Console, Verbosity};
use super::report::{NoteReport, PlaceReport};

/// How many notes of an input are printed unless all are asked for.
const NOTES: usize = 20;

/// Prints the notes of an input: when brief, warnings only.
pub fn print(path: &str, notes: &[NoteReport], brief: bool, console: &Console) {
    let all = console.verbosity == Verbosity::Verbose;
    let most = if all { usize::MAX } else { NOTES };
    let wanted: Vec<_> = notes.iter().filter(|note| !brief || note.severity == "warning").collect();
    for note in wanted.iter().take(most) {
        let at = note.place.as_ref().map_or(String::new(), |at| format!("{}: ", place(at)));
        let text = format!("{}: {at}{}{}", path, note.text, more_like_it(note, all));
        if note.severity == "warning" { console.warning(&text) } else { console.note(&text) }
    }
    if wanted.len() > most {
        console.note(&format!("{}: {} more; -v shows them", path, wanted.len() - most));
    }
}

fn place(place: &PlaceReport) -> String {
    match place {
        PlaceReport::Line(line) => format!("line {line}"),
        PlaceReport::Byte(offset) => format!("byte {offset}"),
        PlaceReport::Json(pointer) => pointer.clone(),
    }
}

/// How many things there are that a note could be repeated for, and if asked for, where.
fn more_like_it(note: &NoteReport, with_places: bool) -> String {
    if note.more == 0 {
        return String::new();
    }
    let mut places: Vec<String> = note.also.iter().map(place).collect();
    if !with_places || places.is_empty() {
        return format!(" (and {} more like it)", note.more);
    }
    if note.more > places.len() as u64 {
        places.push("…".into());
    }
    format!(" (and {} more like it: {})", note.more, places.join(", "))
}
