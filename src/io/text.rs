//! Places in text files, pieces of them for messages, and counts that read well.

use memchr::memchr_iter;

/// The number of the physical line that an offset is on, counted from 1, and the column in bytes, likewise.
pub(super) fn line_and_column(text: &[u8], offset: usize) -> (u64, usize) {
    let before = &text[..offset.min(text.len())];
    let feeds = memchr_iter(b'\n', before).count();
    let lone_returns = memchr_iter(b'\r', before).filter(|&at| text.get(at + 1) != Some(&b'\n')).count();
    let start = before.iter().rposition(|&byte| matches!(byte, b'\n' | b'\r')).map_or(0, |end| end + 1);
    ((feeds + lone_returns + 1) as u64, before.len() - start + 1)
}

/// The line of each of some offsets, which ascend, in one pass over the text.
pub(super) fn lines_of(text: &[u8], offsets: &[usize]) -> Vec<u64> {
    let mut lines = 1;
    let mut start = 0;
    let line = |&offset: &usize| {
        // Between a carriage return and its line feed nothing begins.
        let (more, _) = line_and_column(&text[start..], offset - start);
        lines += more - 1;
        start = offset;
        lines
    };
    offsets.iter().map(line).collect()
}

/// A count of things that are one or many.
pub(super) fn counted(count: impl TryInto<u64>, one: &str, many: &str) -> String {
    match count.try_into().unwrap_or(u64::MAX) {
        1 => format!("1 {one}"),
        count => format!("{count} {many}"),
    }
}

/// A piece of the text for a message: short and printable.
pub(super) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text: String = bytes[..bytes.len().min(LONGEST)].escape_ascii().to_string().replace("\\\\", "\\");
    if bytes.len() > LONGEST { format!("{text}…") } else { text }
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
        assert_eq!(lines_of(text, &offsets), expected);
        assert_eq!(lines_of(text, &[6, 6, 6]), [3, 3, 3]);
    }

    #[test]
    fn counts_read_well() {
        assert_eq!(counted(1_usize, "box", "boxes"), "1 box");
        assert_eq!(counted(0_u64, "box", "boxes"), "0 boxes");
    }
}
