//! What messages are made of: errors at a byte offset, line numbers, counts, text of the file, file names in commands.

use crate::io::{Place, Problem, ReadError};
use memchr::memchr_iter;
use std::borrow::Cow;

/// An error at a byte offset of a text. [`in_text`] finds its line, once it is reported.
pub fn at_byte(problem: Problem, offset: usize, found: impl Into<String>, advice: &str) -> ReadError {
    ReadError::new(problem, Place::Byte(offset as u64), found, advice)
}

pub fn in_text(error: ReadError, text: &[u8]) -> ReadError {
    let Place::Byte(offset) = error.place else { return error };
    ReadError { place: line_place(text, offset as usize), ..error }
}

/// The number of the physical line that an offset is on, counted from 1, and the column in bytes, likewise.
pub fn line_and_column(text: &[u8], offset: usize) -> (u64, usize) {
    let before = &text[..offset.min(text.len())];
    let feeds = memchr_iter(b'\n', before).count();
    let lone_returns = memchr_iter(b'\r', before).filter(|&at| text.get(at + 1) != Some(&b'\n')).count();
    let start = before.iter().rposition(|&byte| matches!(byte, b'\n' | b'\r')).map_or(0, |end| end + 1);
    ((feeds + lone_returns + 1) as u64, before.len() - start + 1)
}

pub fn line_place(text: &[u8], offset: usize) -> Place {
    Place::Line(line_and_column(text, offset).0)
}

/// The lines of ascending offsets, in one pass over the text.
pub fn line_places(text: &[u8], offsets: &[usize]) -> Vec<Place> {
    let mut lines = 1;
    let mut start = 0;
    let line = |&offset: &usize| {
        // Between a carriage return and its line feed nothing begins.
        let (more, _) = line_and_column(&text[start..], offset - start);
        lines += more - 1;
        start = offset;
        Place::Line(lines)
    };
    offsets.iter().map(line).collect()
}

/// A count with its noun in the singular or plural.
pub fn counted(count: impl TryInto<u64>, one: &str, many: &str) -> String {
    match count.try_into().unwrap_or(u64::MAX) {
        1 => format!("1 {one}"),
        count => format!("{count} {many}"),
    }
}

/// A piece of the text for a message: short and printable.
pub fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text: String = bytes[..bytes.len().min(LONGEST)].escape_ascii().to_string().replace("\\\\", "\\");
    if bytes.len() > LONGEST { format!("{text}…") } else { text }
}

/// A file name for a POSIX shell: quoted if necessary, and never mistaken for an option. `-` alone means a stream and stays
/// unchanged.
///
/// ```
/// assert_eq!(crease::io::shell_word("it's here.obj"), "\"it's here.obj\"");
/// ```
pub fn shell_word(name: &str) -> Cow<'_, str> {
    let path =
        if name.len() > 1 && name.starts_with('-') { Cow::from(format!("./{name}")) } else { name.into() };
    // A file name has no NUL, the only character that cannot be quoted.
    shlex::try_quote(&path).map(|word| word.into_owned().into()).unwrap_or(name.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_those_of_every_offset_by_itself() {
        let text = b"a\nbc\r\nd\re\n\n f";
        let offsets: Vec<usize> = (0..text.len()).filter(|&at| !text[at].is_ascii_whitespace()).collect();
        let expected: Vec<u64> = offsets.iter().map(|&at| line_and_column(text, at).0).collect();
        assert_eq!(expected, [1, 2, 2, 3, 4, 6]);
        assert_eq!(line_places(text, &offsets), expected.into_iter().map(Place::Line).collect::<Vec<_>>());
        assert_eq!(line_places(text, &[6, 6, 6]), [const { Place::Line(3) }; 3]);
    }

    #[test]
    fn counts_read_well() {
        assert_eq!(counted(1_usize, "box", "boxes"), "1 box");
        assert_eq!(counted(0_u64, "box", "boxes"), "0 boxes");
    }

    #[test]
    fn names_come_back_from_a_shell() {
        for name in
            ["a.obj", "a b.obj", "it's.obj", "$HOME/`x`.obj", "\"\\.obj", "ä.obj", "-x.obj", "-", "a\nb.obj"]
        {
            let line = format!("crease normals {} -o out.glb", shell_word(name));
            let words = shlex::split(&line).unwrap();
            let expected = if name == "-x.obj" { "./-x.obj" } else { name };
            assert_eq!(words, ["crease", "normals", expected, "-o", "out.glb"], "{line}");
        }
        assert_eq!(shell_word("models/a-1.obj"), "models/a-1.obj");
    }
}
