//! Ascii STL: words in any case, between blanks and line ends of any kind, with comments from `#` to the line's end.

use crate::io::error::{NoteKind, RepeatedNotes};
use crate::io::mesh_checks::{build_part, non_finite_note};
use crate::io::text::{
    Words, at_byte, float, in_text, is_blank, line_place, line_places, shown, storage_of_text,
};
use crate::io::{Note, Part, Place, Problem, ReadError, ReadOptions};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, NONE, Positions, PositionsRef, Storage};
use glam::DVec3;
use std::ops::Range;

/// The most solids of a file. Each becomes a part, which takes far more memory than the words that make one.
const MOST_SOLIDS: usize = 1 << 16;

const NO_SOLID: NoteKind = NoteKind::warning(0, "there is no `solid` line before this line");
const NO_ENDSOLID: NoteKind = NoteKind::warning(1, "a solid begins before the `endsolid` of the last one");
const UNKNOWN: NoteKind = NoteKind::warning(2, "a line that is not STL was skipped");
const NO_NORMAL: NoteKind = NoteKind::warning(3, "a facet has no normal of three numbers");
const POLYGON: NoteKind = NoteKind::warning(4, "a facet with more than 3 vertices was read as a polygon");

/// Where the parts of a facet are in the text.
#[derive(Clone, Debug, Default)]
pub(super) struct FacetText {
    pub span: Range<usize>,
    /// The three numbers of the normal, or as many as there are; empty where new ones are to be added.
    pub normal: Range<usize>,
    pub lead: &'static str,
    /// The numbers of each vertex, as a range of [`SolidText::vertices`].
    pub vertices: Range<usize>,
    /// The normal, if it has three numbers.
    value: Option<DVec3>,
}

/// A solid in the text, and the numbers that it holds.
#[derive(Clone, Debug, Default)]
pub(super) struct SolidText {
    pub name: String,
    pub facets: Vec<FacetText>,
    /// The three numbers of each vertex.
    pub vertices: Vec<Range<usize>>,
    positions: Vec<DVec3>,
}

pub(super) fn read(text: &[u8], options: &ReadOptions) -> Result<(Vec<Part>, Vec<Note>), ReadError> {
    let mut parser = Parser::new(text);
    parser.run().map_err(|error| in_text(error, text))?;
    let Parser { notes, solids, .. } = parser;
    let mut notes: Vec<Note> =
        notes.notes(|offsets| line_places(text, offsets)).map(|(_, note)| note).collect();
    let positions: Vec<&[DVec3]> = solids.iter().map(|solid| &solid.positions[..]).collect();
    let storage = storage_of_text(&positions);
    let non_finite = |positions| non_finite_note(PositionsRef::F64(positions), options.non_finite);
    notes.extend(positions.into_iter().filter_map(non_finite));
    let parts = solids.into_iter().map(|solid| part(text, solid, storage, options));
    Ok((parts.collect::<Result<_, _>>()?, notes))
}

pub(super) fn solids(text: &[u8]) -> Vec<SolidText> {
    let mut parser = Parser::new(text);
    // It was read without an error, so there is none.
    let _ = parser.run();
    parser.solids
}

fn part(text: &[u8], solid: SolidText, storage: Storage, options: &ReadOptions) -> Result<Part, ReadError> {
    let SolidText { name, facets, vertices, positions } = solid;
    let mut faces = Faces::with_capacity(positions.len());
    let (mut values, mut index) = (Vec::with_capacity(facets.len()), Vec::with_capacity(positions.len()));
    let mut corners = Vec::new();
    for facet in &facets {
        corners.clear();
        corners.extend(facet.vertices.clone().map(|vertex| vertex as u32));
        faces.push(&corners);
        let slot = if facet.value.is_some() { values.len() as u32 } else { NONE };
        index.extend(corners.iter().map(|_| slot));
        values.extend(facet.value);
    }
    let normals = (!values.is_empty()).then(|| Column::per_corner(values, index));
    let columns = Columns { normals, ..Columns::default() };
    let builder = MeshBuilder { positions: Positions::rounded(positions, storage), faces, columns };
    build_part(name, builder, options, |error| match error {
        MeshError::NonFinite { vertex, .. } => line_place(text, vertices[*vertex].start),
        _ => Place::File,
    })
}

struct Parser<'a> {
    text: &'a [u8],
    words: Words<'a>,
    solids: Vec<SolidText>,
    solid: Solid,
    notes: RepeatedNotes,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Solid {
    None,
    /// Facets came without the line `solid`.
    Implied,
    Named,
}

const KEYWORDS: [&[u8]; 7] = [b"solid", b"endsolid", b"facet", b"outer", b"vertex", b"endloop", b"endfacet"];

impl<'a> Parser<'a> {
    fn new(text: &'a [u8]) -> Self {
        let (solids, notes) = (Vec::new(), RepeatedNotes::default());
        Self { text, words: Words::new(text), solids, solid: Solid::None, notes }
    }

    fn run(&mut self) -> Result<(), ReadError> {
        while let Some((keyword, word)) = self.keyword() {
            match keyword {
                b"solid" => self.begin_solid(word.start)?,
                b"endsolid" => {
                    self.words.rest_of_line();
                    if self.solid == Solid::None {
                        self.notes.add(NO_SOLID, word.start);
                    }
                    self.solid = Solid::None;
                }
                b"facet" => self.facet(word)?,
                _ => return Err(self.unexpected(word)),
            }
        }
        if self.solid == Solid::Named { Err(self.truncated("`endsolid` is missing")) } else { Ok(()) }
    }

    /// The next keyword and its bytes. Lines that start with another word, such as colours, are skipped.
    fn keyword(&mut self) -> Option<(&'static [u8], Range<usize>)> {
        loop {
            let word = self.words.next()?;
            let known =
                KEYWORDS.into_iter().find(|known| self.text[word.clone()].eq_ignore_ascii_case(known));
            match known {
                Some(keyword) => return Some((keyword, word)),
                None => {
                    self.notes.add(UNKNOWN, word.start);
                    self.words.rest_of_line();
                }
            }
        }
    }

    fn keyword_in_facet(&mut self) -> Result<(&'static [u8], Range<usize>), ReadError> {
        self.keyword().ok_or_else(|| self.truncated("the file ends inside a facet"))
    }

    fn expect(&mut self, expected: &[u8]) -> Result<Range<usize>, ReadError> {
        let (keyword, word) = self.keyword_in_facet()?;
        if keyword == expected { Ok(word) } else { Err(self.unexpected(word)) }
    }

    /// Passes the next word if it is the expected one.
    fn next_is(&mut self, expected: &[u8]) -> bool {
        let start = self.words.at;
        let is_next = self.words.next().is_some_and(|word| self.text[word].eq_ignore_ascii_case(expected));
        if !is_next {
            self.words.at = start;
        }
        is_next
    }

    fn unexpected(&self, word: Range<usize>) -> ReadError {
        let found = format!("unexpected `{}`", shown(&self.text[word.clone()]));
        damaged(word.start, found, "a line before this one is missing or damaged")
    }

    fn truncated(&self, found: &str) -> ReadError {
        let advice = "the file is cut off; if nothing is missing, add the line `endsolid`";
        at_byte(Problem::Truncated, self.text.len(), found, advice)
    }

    fn begin_solid(&mut self, start: usize) -> Result<(), ReadError> {
        if self.solids.len() == MOST_SOLIDS {
            let found = format!("too many solids (limit {MOST_SOLIDS})");
            return Err(at_byte(Problem::Limit, start, found, "split the file"));
        }
        if self.solid == Solid::Named {
            self.notes.add(NO_ENDSOLID, start);
        }
        let name = self.words.rest_of_line();
        self.solids.push(SolidText { name: solid_name(&self.text[name]), ..SolidText::default() });
        self.solid = Solid::Named;
        Ok(())
    }

    fn facet(&mut self, word: Range<usize>) -> Result<(), ReadError> {
        if self.solid == Solid::None {
            self.notes.add(NO_SOLID, word.start);
            self.solids.push(SolidText::default());
            self.solid = Solid::Implied;
        }
        let has_keyword = self.next_is(b"normal");
        let (normal, values) = self.numbers();
        let lead = match values[..] {
            [] if has_keyword => " ",
            [] => " normal ",
            _ => "",
        };
        let value = <[f64; 3]>::try_from(values).ok().map(DVec3::from_array);
        if value.is_none() {
            self.notes.add(NO_NORMAL, word.start);
        }
        let outer = self.expect(b"outer")?;
        if !self.next_is(b"loop") {
            let found = format!("`{}` has no `loop` after it", shown(&self.text[outer.clone()]));
            return Err(damaged(outer.start, found, "correct the line"));
        }
        let first = self.solid().vertices.len();
        loop {
            match self.keyword_in_facet()? {
                (b"vertex", word) => self.vertex(word)?,
                (b"endloop", _) => break,
                (_, word) => return Err(self.unexpected(word)),
            }
        }
        let end = self.expect(b"endfacet")?;
        let vertices = first..self.solid().vertices.len();
        match vertices.len() {
            3 => {}
            4.. => self.notes.add(POLYGON, end.start),
            few => {
                let found = format!("a facet needs 3 vertices, but has {few}");
                return Err(damaged(end.start, found, "correct the facet"));
            }
        }
        let facet = FacetText { span: word.start..end.end, normal, lead, vertices, value };
        self.solid().facets.push(facet);
        Ok(())
    }

    /// Up to three numbers and their bytes.
    fn numbers(&mut self) -> (Range<usize>, Vec<f64>) {
        let (mut span, mut values) = (self.words.at..self.words.at, Vec::with_capacity(3));
        while values.len() < 3 {
            let Some(word) = self.words.next() else { break };
            let Some(value) = float(&self.text[word.clone()]) else {
                self.words.at = span.end;
                break;
            };
            span = if values.is_empty() { word } else { span.start..word.end };
            values.push(value);
        }
        (span, values)
    }

    fn vertex(&mut self, word: Range<usize>) -> Result<(), ReadError> {
        let (span, values) = self.numbers();
        let Ok(values) = <[f64; 3]>::try_from(values) else {
            let next = self.words.next().map_or(String::new(), |next| shown(&self.text[next]));
            let found = format!("a vertex needs 3 numbers, but `{next}` is not a number");
            return Err(damaged(word.start, found, "correct the line"));
        };
        let solid = self.solid();
        solid.vertices.push(span);
        solid.positions.push(DVec3::from_array(values));
        Ok(())
    }

    fn solid(&mut self) -> &mut SolidText {
        self.solids.last_mut().expect("a facet opens a solid")
    }
}

fn damaged(offset: usize, found: String, advice: &'static str) -> ReadError {
    at_byte(Problem::Syntax, offset, found, advice)
}

/// The name behind `solid`, without the comment behind that.
fn solid_name(rest: &[u8]) -> String {
    let is_comment = |at: &usize| rest[*at] == b'#' && (*at == 0 || is_blank(rest[at - 1]));
    let end = (0..rest.len()).find(is_comment).unwrap_or(rest.len());
    String::from_utf8_lossy(&rest[..end]).trim().to_owned()
}
