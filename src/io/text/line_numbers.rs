//! Line numbers of byte offsets.

use crate::io::Place;
use memchr::memchr_iter;

/// The number of the physical line that an offset is on, counted from 1, and the column in bytes, likewise.
pub(in crate::io) fn line_and_column(text: &[u8], offset: usize) -> (u64, usize) {
    let before = &text[..offset.min(text.len())];
    let feeds = memchr_iter(b'\n', before).count();
    let lone_returns = memchr_iter(b'\r', before).filter(|&at| text.get(at + 1) != Some(&b'\n')).count();
    let start = before.iter().rposition(|&byte| matches!(byte, b'\n' | b'\r')).map_or(0, |end| end + 1);
    ((feeds + lone_returns + 1) as u64, before.len() - start + 1)
}

/// The line of an offset.
pub(in crate::io) fn line_place(text: &[u8], offset: usize) -> Place {
    Place::Line(line_and_column(text, offset).0)
}

/// The lines of ascending offsets, in one pass over the text.
pub(in crate::io) fn line_places(text: &[u8], offsets: &[usize]) -> Vec<Place> {
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
}
