//! Places in text files, and pieces of them for messages.

use memchr::memchr_iter;

/// The number of the physical line that an offset is on, counted from 1, and the column in bytes, likewise.
pub(super) fn line_and_column(text: &[u8], offset: usize) -> (u64, usize) {
    let before = &text[..offset.min(text.len())];
    let feeds = memchr_iter(b'\n', before).count();
    let lone_returns = memchr_iter(b'\r', before).filter(|&at| text.get(at + 1) != Some(&b'\n')).count();
    let start = before.iter().rposition(|&byte| matches!(byte, b'\n' | b'\r')).map_or(0, |end| end + 1);
    ((feeds + lone_returns + 1) as u64, before.len() - start + 1)
}

/// A piece of the text for a message: short and printable.
pub(super) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text: String = bytes[..bytes.len().min(LONGEST)].escape_ascii().to_string().replace("\\\\", "\\");
    if bytes.len() > LONGEST { format!("{text}…") } else { text }
}
