//! Ascii STL: words in any case, between blanks and line ends of any kind, with comments from `#` to the line's end.

use crate::io::error::{NoteKind, RepeatedNotes};
use crate::io::mesh_checks::{build_part, non_finite_note};
use crate::io::text::{Fault, Words, float, is_blank, line_place, line_places, restore_singles, shown};
use crate::io::{Note, Part, Place, Problem, ReadError, ReadOptions, Severity};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, NONE, Storage};
use glam::DVec3;
use std::ops::Range;

/// The most solids of a file. Each becomes a part, which takes far more memory than the words that make one.
const MOST_SOLIDS: usize = 1 << 16;

const NO_SOLID: NoteKind = NoteKind(0, Severity::Warning, "there is no `solid` line before this line");
const NO_ENDSOLID: NoteKind =
    NoteKind(1, Severity::Warning, "a solid begins before the `endsolid` of the last one");
const UNKNOWN: NoteKind = NoteKind(2, Severity::Warning, "a line that is not STL was skipped");
const NO_NORMAL: NoteKind = NoteKind(3, Severity::Warning, "a facet has no normal of three numbers");
const POLYGON: NoteKind =
    NoteKind(4, Severity::Warning, "a facet with more than 3 vertices was read as a polygon");

/// Where the parts of a facet are in the text.
#[derive(Clone, Debug, Default)]
pub(super) struct FacetText {
    /// From `facet` to `endfacet`.
    pub span: Range<usize>,
    /// The three numbers of the normal, or as many as there are; empty where new ones are to be added.
    pub normal: Range<usize>,
    /// The text before new numbers.
    pub lead: &'static str,
    /// The numbers of each vertex, as a range of [`SolidText::vertices`].
    pub vertices: Range<usize>,
}

/// A solid in the text, and the numbers that it holds.
#[derive(Clone, Debug, Default)]
pub(super) struct SolidText {
    pub name: String,
    pub facets: Vec<FacetText>,
    /// The three numbers of each vertex.
    pub vertices: Vec<Range<usize>>,
    positions: Vec<DVec3>,
    normals: Vec<Option<DVec3>>,
}

pub(super) fn read(text: &[u8], options: &ReadOptions) -> Result<(Vec<Part>, Vec<Note>), ReadError> {
    let mut parser = Parser::new(text);
    parser.run().map_err(|fault| {
        let place = line_place(text, fault.offset);
        fault.at(place)
    })?;
    let Parser { notes, mut solids, .. } = parser;
    let mut notes: Vec<Note> =
        notes.notes(|offsets| line_places(text, offsets)).map(|(_, note)| note).collect();
    let mut positions: Vec<&mut [DVec3]> = solids.iter_mut().map(|solid| &mut solid.positions[..]).collect();
    let storage = restore_singles(&mut positions);
    notes.extend(solids.iter().filter_map(|solid| non_finite_note(&solid.positions, options.non_finite)));
    let parts = solids.into_iter().map(|solid| part(text, solid, storage, options));
    Ok((parts.collect::<Result<_, _>>()?, notes))
}

/// The solids of a text that has been read before.
pub(super) fn solids(text: &[u8]) -> Vec<SolidText> {
    let mut parser = Parser::new(text);
    // It was read without an error, so there is none.
    let _ = parser.run();
    parser.solids
}

fn part(text: &[u8], solid: SolidText, storage: Storage, options: &ReadOptions) -> Result<Part, ReadError> {
    let SolidText { name, facets, vertices, positions, normals } = solid;
    let mut faces = Faces::with_capacity(positions.len());
    let (mut values, mut index) = (Vec::with_capacity(normals.len()), Vec::with_capacity(positions.len()));
    let mut corners = Vec::new();
    for (facet, normal) in facets.iter().zip(&normals) {
        corners.clear();
        corners.extend(facet.vertices.clone().map(|vertex| vertex as u32));
        faces.push(&corners);
        let slot = if normal.is_some() { values.len() as u32 } else { NONE };
        index.extend(corners.iter().map(|_| slot));
        values.extend(normal);
    }
    let normals = (!values.is_empty()).then(|| Column::per_corner(values, index));
    let columns = Columns { normals, ..Columns::default() };
    let builder = MeshBuilder { positions, storage, faces, columns };
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
    /// The loops of the facet that is open.
    facet: Option<Loops>,
    notes: RepeatedNotes,
}

/// Whether a solid is open.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Solid {
    None,
    /// Facets came without the line `solid`.
    Implied,
    Named,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Loops {
    None,
    Open,
    Closed,
}

impl<'a> Parser<'a> {
    fn new(text: &'a [u8]) -> Self {
        let (solids, notes) = (Vec::new(), RepeatedNotes::default());
        Self { text, words: Words::new(text), solids, solid: Solid::None, facet: None, notes }
    }

    fn run(&mut self) -> Result<(), Fault> {
        while let Some(word) = self.words.next() {
            self.statement(word)?;
        }
        if self.facet.is_some() || self.solid == Solid::Named {
            let found =
                if self.facet.is_some() { "the file ends inside a facet" } else { "`endsolid` is missing" };
            let advice = "the file is cut off; if nothing is missing, add the line `endsolid`";
            return Err(Fault::new(Problem::Truncated, self.text.len(), found, advice));
        }
        Ok(())
    }

    fn statement(&mut self, word: Range<usize>) -> Result<(), Fault> {
        let keyword = self.text[word.clone()].to_ascii_lowercase();
        match (&keyword[..], self.facet) {
            (b"solid", None) => self.begin_solid(word.start)?,
            (b"endsolid", None) => {
                self.words.rest_of_line();
                if self.solid == Solid::None {
                    self.notes.add(NO_SOLID, word.start);
                }
                self.solid = Solid::None;
            }
            (b"facet", None) => self.begin_facet(word),
            (b"outer", Some(Loops::None)) => {
                if !self.next_is(b"loop") {
                    let found = format!("`{}` has no `loop` after it", shown(&self.text[word.clone()]));
                    return Err(damaged(word.start, found, "correct the line"));
                }
                self.facet = Some(Loops::Open);
            }
            (b"vertex", Some(Loops::Open)) => self.vertex(word)?,
            (b"endloop", Some(Loops::Open)) => self.facet = Some(Loops::Closed),
            (b"endfacet", Some(Loops::Closed)) => self.end_facet(word)?,
            (b"solid" | b"endsolid" | b"facet" | b"outer" | b"vertex" | b"endloop" | b"endfacet", _) => {
                let found = format!("unexpected `{}`", shown(&self.text[word.clone()]));
                return Err(damaged(word.start, found, "a line before this one is missing or damaged"));
            }
            // Colours and the like, each on a line of its own.
            _ => {
                self.notes.add(UNKNOWN, word.start);
                self.words.rest_of_line();
            }
        }
        Ok(())
    }

    fn next_is(&mut self, expected: &[u8]) -> bool {
        let start = self.words.at;
        let is_next = self.words.next().is_some_and(|word| self.text[word].eq_ignore_ascii_case(expected));
        if !is_next {
            self.words.at = start;
        }
        is_next
    }

    fn begin_solid(&mut self, start: usize) -> Result<(), Fault> {
        if self.solids.len() == MOST_SOLIDS {
            let found = format!("too many solids (limit {MOST_SOLIDS})");
            return Err(Fault::new(Problem::Limit, start, found, "split the file"));
        }
        if self.solid == Solid::Named {
            self.notes.add(NO_ENDSOLID, start);
        }
        let name = self.words.rest_of_line();
        self.solids.push(SolidText { name: solid_name(&self.text[name]), ..SolidText::default() });
        self.solid = Solid::Named;
        Ok(())
    }

    fn begin_facet(&mut self, word: Range<usize>) {
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
        let solid = self.solid();
        let vertices = solid.vertices.len()..solid.vertices.len();
        solid.facets.push(FacetText { span: word, normal, lead, vertices });
        solid.normals.push(value);
        self.facet = Some(Loops::None);
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

    fn vertex(&mut self, word: Range<usize>) -> Result<(), Fault> {
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

    fn end_facet(&mut self, word: Range<usize>) -> Result<(), Fault> {
        self.facet = None;
        let solid = self.solid();
        let count = solid.vertices.len();
        let Some(facet) = solid.facets.last_mut() else { return Ok(()) };
        facet.span.end = word.end;
        facet.vertices.end = count;
        match facet.vertices.len() {
            3 => {}
            4.. => self.notes.add(POLYGON, word.start),
            few => {
                let found = format!("a facet needs 3 vertices, but has {few}");
                return Err(damaged(word.start, found, "correct the facet"));
            }
        }
        Ok(())
    }

    fn solid(&mut self) -> &mut SolidText {
        self.solids.last_mut().expect("a facet opens a solid")
    }
}

fn damaged(offset: usize, found: String, advice: &'static str) -> Fault {
    Fault::new(Problem::Syntax, offset, found, advice)
}

/// The name behind `solid`, without the comment behind that.
fn solid_name(rest: &[u8]) -> String {
    let is_comment = |at: &usize| rest[*at] == b'#' && (*at == 0 || is_blank(rest[at - 1]));
    let end = (0..rest.len()).find(is_comment).unwrap_or(rest.len());
    String::from_utf8_lossy(&rest[..end]).trim().to_owned()
}
