//! Pieces of messages: counts that read well, and text of the file.

/// A count of things that are one or many.
pub(in crate::io) fn counted(count: impl TryInto<u64>, one: &str, many: &str) -> String {
    match count.try_into().unwrap_or(u64::MAX) {
        1 => format!("1 {one}"),
        count => format!("{count} {many}"),
    }
}

/// A piece of the text for a message: short and printable.
pub(in crate::io) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 40;
    let text: String = bytes[..bytes.len().min(LONGEST)].escape_ascii().to_string().replace("\\\\", "\\");
    if bytes.len() > LONGEST { format!("{text}…") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_read_well() {
        assert_eq!(counted(1_usize, "box", "boxes"), "1 box");
        assert_eq!(counted(0_u64, "box", "boxes"), "0 boxes");
    }
}
