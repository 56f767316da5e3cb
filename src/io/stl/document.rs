//! An STL file as it was read, and the detection of its layout.

use crate::io::text::{Words, counted};

/// An STL file as it was read.
#[derive(Clone, Debug)]
pub struct StlDocument {
    pub(in crate::io) bytes: Vec<u8>,
    pub(super) layout: Layout,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    Ascii,
    Binary { facets: usize },
}

/// Bytes of a binary header, behind which the number of facets is.
pub(super) const HEADER: usize = 80;
pub(super) const FIRST: usize = 84;
pub(super) const FACET: usize = 50;

impl StlDocument {
    /// The attribute bytes behind facets, in which some programs keep colours.
    pub(in crate::io) fn outside_meshes(&self) -> Vec<String> {
        let Layout::Binary { facets } = self.layout else { return Vec::new() };
        let (facets, _) = self.bytes[FIRST..FIRST + facets * FACET].as_chunks::<FACET>();
        match facets.iter().filter(|facet| facet[FACET - 2..] != [0, 0]).count() {
            0 => Vec::new(),
            count => vec![format!("the attribute bytes of {}", counted(count, "facet", "facets"))],
        }
    }
}

pub(super) fn declared_facets(bytes: &[u8]) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(HEADER..FIRST)?.try_into().ok()?))
}

/// Whether a file is exactly as long as its number of facets demands.
pub(super) fn has_exact_length(bytes: &[u8]) -> bool {
    declared_facets(bytes)
        .is_some_and(|count| bytes.len() as u64 == FIRST as u64 + u64::from(count) * FACET as u64)
}

/// Whether bytes are certainly an STL: a binary one of the right length, or text with facets at the beginning.
pub(in crate::io) fn is_certain(bytes: &[u8]) -> bool {
    let text = &bytes[..bytes.len().min(HEAD)];
    has_exact_length(bytes) || is_ascii(bytes) && (mentions(text, b"facet") || mentions(text, b"endsolid"))
}

/// As much of a file as is inspected to distinguish text from binary.
const HEAD: usize = 1024;

fn mentions(text: &[u8], word: &[u8]) -> bool {
    text.windows(word.len()).any(|window| window.eq_ignore_ascii_case(word))
}

/// Whether a file starts like an ascii STL and has no control characters where a binary one has numbers.
pub(super) fn is_ascii(bytes: &[u8]) -> bool {
    let text = &bytes[..bytes.len().min(HEAD)];
    let word = Words::new(bytes).next().map_or(&[][..], |word| &bytes[word]);
    let starts_like_ascii = word.eq_ignore_ascii_case(b"solid") || word.eq_ignore_ascii_case(b"facet");
    let is_control = |byte: &u8| *byte < b' ' && !matches!(byte, b'\t'..=b'\r' | 0x1a);
    starts_like_ascii && !text.iter().any(is_control)
}
