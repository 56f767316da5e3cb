//! Writing an ascii STL back into its own text.

use super::ascii::{FacetText, SolidText, solids};
use super::facets::FacetEdit;
use crate::io::decimal::push_f32;

/// The text with its facets edited, one list a solid. Only numbers change, and facets that are dropped go with the
/// lines that they alone stand on.
pub(super) fn edit(text: &[u8], edits: &[Vec<FacetEdit>]) -> Vec<u8> {
    let mut copy = Copy { text, out: Vec::with_capacity(text.len() + text.len() / 8), at: 0 };
    for (solid, edits) in solids(text).iter().zip(edits) {
        for (facet, edit) in solid.facets.iter().zip(edits) {
            copy.facet(solid, facet, edit);
        }
    }
    copy.up_to(text.len());
    copy.out
}

struct Copy<'a> {
    text: &'a [u8],
    out: Vec<u8>,
    /// What is in front of this is done.
    at: usize,
}

impl Copy<'_> {
    fn up_to(&mut self, end: usize) {
        self.out.extend_from_slice(&self.text[self.at..end]);
        self.at = end;
    }

    fn facet(&mut self, solid: &SolidText, facet: &FacetText, edit: &FacetEdit) {
        if edit.dropped {
            let (start, end) = self.lines(facet);
            self.up_to(start);
            self.at = end;
            return;
        }
        if let Some(normal) = edit.normal {
            self.up_to(facet.normal.start);
            self.out.extend_from_slice(facet.lead.as_bytes());
            for (k, value) in normal.into_iter().enumerate() {
                if k > 0 {
                    self.out.push(b' ');
                }
                push_f32(&mut self.out, value);
            }
            self.at = facet.normal.end;
        }
        if edit.reversed {
            // The first corner stays the first.
            let spans = &solid.vertices[facet.vertices.clone()];
            for (here, there) in spans[1..].iter().zip(spans[1..].iter().rev()) {
                self.up_to(here.start);
                self.out.extend_from_slice(&self.text[there.clone()]);
                self.at = here.end;
            }
        }
    }

    /// The bytes that go with a facet: its lines, if nothing else is on them.
    fn lines(&self, facet: &FacetText) -> (usize, usize) {
        let is_space = |byte: &u8| matches!(byte, b' ' | b'\t');
        let before = &self.text[self.at..facet.span.start];
        let start = before.iter().rposition(|byte| !is_space(byte)).map_or(0, |last| last + 1);
        let behind = &self.text[facet.span.end..];
        let blanks = behind.iter().position(|byte| !is_space(byte)).unwrap_or(behind.len());
        let line_end = match behind[blanks..] {
            [b'\r', b'\n', ..] => 2,
            [b'\r' | b'\n', ..] => 1,
            _ => 0,
        };
        let starts_line = self.at + start == 0 || matches!(self.text[self.at + start - 1], b'\n' | b'\r');
        if starts_line && line_end > 0 {
            (self.at + start, facet.span.end + blanks + line_end)
        } else {
            (facet.span.start, facet.span.end)
        }
    }
}
