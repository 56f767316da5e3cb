//! Ascii STL: words in any case, between blanks and line ends of any kind, with comments from `#` to the line's end.

use super::words::{Words, is_blank};
use crate::io::number;
use crate::io::singles::restore_singles;
use crate::io::tally::{Tally, build_part, non_finite_note};
use crate::io::text::{counted, line_and_column, lines_of, shown};
use crate::io::{Note, Part, Place, Problem, ReadError, ReadOptions, Severity};
use crate::mesh::{Column, Columns, Faces, MeshBuilder, MeshError, NONE, Storage};
use glam::DVec3;
use std::ops::Range;

/// The most solids of a file. Each becomes a part, which takes far more memory than the words that make one.
const MOST_SOLIDS: usize = 1 << 16;

/// Where the parts of a facet are in the text.
#[derive(Clone, Debug, Default)]
pub(super) struct FacetText {
    /// From `facet` to `endfacet`.
    pub span: Range<usize>,
    /// The three numbers of the normal, or what is there of them; empty where they are to be put in.
    pub normal: Range<usize>,
    /// What to put in front of new numbers.
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

/// Whether a file begins as an ascii STL does.
pub(super) fn starts_like_one(text: &[u8]) -> bool {
    let mut words = Words::new(text);
    words.next().is_some_and(|word| {
        let word = &text[word];
        [&b"solid"[..], b"facet"].iter().any(|start| word.eq_ignore_ascii_case(start))
    })
}

/// Reads an ascii file.
pub(super) fn read(text: &[u8], options: &ReadOptions) -> Result<(Vec<Part>, Vec<Note>), ReadError> {
    let mut parser = Parser::new(text);
    parser.run()?;
    let mut notes = parser.notes();
    let mut solids = parser.solids;
    let mut positions: Vec<&mut [DVec3]> = solids.iter_mut().map(|solid| &mut solid.positions[..]).collect();
    let storage = restore_singles(&mut positions);
    notes.extend(solids.iter().filter_map(|solid| non_finite_note(&solid.positions, options.non_finite)));
    Ok((
        solids.into_iter().map(|solid| part(text, (solid, storage), options)).collect::<Result<_, _>>()?,
        notes,
    ))
}

/// The solids of a text that has been read before.
pub(super) fn solids(text: &[u8]) -> Vec<SolidText> {
    let mut parser = Parser::new(text);
    // It was read without an error, so there is none.
    let _ = parser.run();
    parser.solids
}

fn part(
    text: &[u8],
    (solid, storage): (SolidText, Storage),
    options: &ReadOptions,
) -> Result<Part, ReadError> {
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
        MeshError::NonFinite { vertex, .. } => line(text, vertices[*vertex].start),
        _ => Place::File,
    })
}

fn line(text: &[u8], offset: usize) -> Place {
    Place::Line(line_and_column(text, offset).0)
}

struct Parser<'a> {
    text: &'a [u8],
    words: Words<'a>,
    solids: Vec<SolidText>,
    solid: Solid,
    /// The loops of the facet that is open.
    facet: Option<Loops>,
    odd: Unusual,
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

/// What was odd but could be read.
#[derive(Default)]
struct Unusual {
    unknown: Tally,
    without_normal: Tally,
    polygons: Tally,
    unclosed: Tally,
    unopened: Tally,
}

impl<'a> Parser<'a> {
    fn new(text: &'a [u8]) -> Self {
        let (solids, solid, facet, odd) = (Vec::new(), Solid::None, None, Unusual::default());
        Self { text, words: Words::new(text), solids, solid, facet, odd }
    }

    fn run(&mut self) -> Result<(), ReadError> {
        while let Some(word) = self.words.next() {
            self.statement(word)?;
        }
        if self.facet.is_some() || self.solid == Solid::Named {
            let found =
                if self.facet.is_some() { "the file ends inside a facet" } else { "`endsolid` is missing" };
            let advice = "the file was cut off; if nothing is missing, add the line `endsolid`";
            return Err(ReadError::new(Problem::Truncated, line(self.text, self.text.len()), found, advice));
        }
        Ok(())
    }

    fn statement(&mut self, word: Range<usize>) -> Result<(), ReadError> {
        let keyword = self.text[word.clone()].to_ascii_lowercase();
        match (&keyword[..], self.facet) {
            (b"solid", None) => self.begin_solid(word.start)?,
            (b"endsolid", None) => {
                self.words.rest_of_line();
                if self.solid == Solid::None {
                    self.odd.unopened.add(word.start);
                }
                self.solid = Solid::None;
            }
            (b"facet", None) => self.begin_facet(word),
            (b"outer", Some(Loops::None)) => {
                self.expect(b"loop", word)?;
                self.facet = Some(Loops::Open);
            }
            (b"vertex", Some(Loops::Open)) => self.vertex(word)?,
            (b"endloop", Some(Loops::Open)) => self.facet = Some(Loops::Closed),
            (b"endfacet", Some(Loops::Closed)) => self.end_facet(word)?,
            (b"solid" | b"endsolid" | b"facet" | b"outer" | b"vertex" | b"endloop" | b"endfacet", _) => {
                let found = format!("`{}` does not belong here", shown(&self.text[word.clone()]));
                return Err(self.fault(word.start, found, "a line before it is missing or damaged"));
            }
            // Colours and the like, each on a line of its own.
            _ => {
                self.odd.unknown.add(word.start);
                self.words.rest_of_line();
            }
        }
        Ok(())
    }

    fn fault(&self, offset: usize, found: String, advice: &str) -> ReadError {
        ReadError::new(Problem::Syntax, line(self.text, offset), found, advice)
    }

    fn expect(&mut self, expected: &[u8], after: Range<usize>) -> Result<(), ReadError> {
        match self.words.next() {
            Some(word) if self.text[word.clone()].eq_ignore_ascii_case(expected) => Ok(()),
            _ => {
                let found = format!(
                    "`{}` without `{}` behind it",
                    shown(&self.text[after.clone()]),
                    String::from_utf8_lossy(expected)
                );
                Err(self.fault(after.start, found, "the line is damaged"))
            }
        }
    }

    fn begin_solid(&mut self, start: usize) -> Result<(), ReadError> {
        if self.solids.len() == MOST_SOLIDS {
            let found = format!("more than {MOST_SOLIDS} solids");
            let place = line(self.text, start);
            return Err(ReadError::new(Problem::Limit, place, found, "divide the file"));
        }
        if self.solid == Solid::Named {
            self.odd.unclosed.add(start);
        }
        let name = self.words.rest_of_line();
        self.solids.push(SolidText { name: solid_name(&self.text[name]), ..SolidText::default() });
        self.solid = Solid::Named;
        Ok(())
    }

    fn begin_facet(&mut self, word: Range<usize>) {
        if self.solid == Solid::None {
            self.odd.unopened.add(word.start);
            self.solids.push(SolidText::default());
            self.solid = Solid::Implied;
        }
        let (text, ahead) = (self.text, self.words.at);
        let has_keyword = self.words.next().is_some_and(|word| text[word].eq_ignore_ascii_case(b"normal"));
        if !has_keyword {
            self.words.at = ahead;
        }
        let (lead, insertion) = if has_keyword { (" ", self.words.at) } else { (" normal ", ahead) };
        let (numbers, values) = self.numbers();
        let normal = <[f64; 3]>::try_from(values).ok().map(DVec3::from_array);
        if normal.is_none() {
            self.odd.without_normal.add(word.start);
        }
        let (lead, span) = match numbers {
            Some(numbers) => ("", numbers),
            None => (lead, insertion..insertion),
        };
        let solid = self.solid();
        let vertices = solid.vertices.len()..solid.vertices.len();
        solid.facets.push(FacetText { span: word, normal: span, lead, vertices });
        solid.normals.push(normal);
        self.facet = Some(Loops::None);
    }

    /// Up to three numbers, and where they are.
    fn numbers(&mut self) -> (Option<Range<usize>>, Vec<f64>) {
        let (mut span, mut values) = (None::<Range<usize>>, Vec::with_capacity(3));
        while values.len() < 3 {
            let ahead = self.words.at;
            let Some(word) = self.words.next() else { break };
            let Some(value) = number::float(&self.text[word.clone()]) else {
                self.words.at = ahead;
                break;
            };
            values.push(value);
            span = Some(span.map_or(word.start, |span| span.start)..word.end);
        }
        (span, values)
    }

    fn vertex(&mut self, word: Range<usize>) -> Result<(), ReadError> {
        let (span, values) = self.numbers();
        let (Some(span), Ok(values)) = (span, <[f64; 3]>::try_from(values)) else {
            let next = self.words.next().map_or(String::new(), |next| shown(&self.text[next]));
            let found = format!("a vertex needs three numbers, and `{next}` is none");
            return Err(self.fault(word.start, found, "correct the line"));
        };
        let solid = self.solid();
        solid.vertices.push(span);
        solid.positions.push(DVec3::from_array(values));
        Ok(())
    }

    fn end_facet(&mut self, word: Range<usize>) -> Result<(), ReadError> {
        self.facet = None;
        let solid = self.solid();
        let count = solid.vertices.len();
        let Some(facet) = solid.facets.last_mut() else { return Ok(()) };
        facet.span.end = word.end;
        facet.vertices.end = count;
        match facet.vertices.len() {
            3 => {}
            4.. => self.odd.polygons.add(word.start),
            few => {
                let found = format!("a facet with {}; it needs 3", counted(few, "vertex", "vertices"));
                return Err(self.fault(word.start, found, "correct the facet"));
            }
        }
        Ok(())
    }

    /// The solid that is open.
    fn solid(&mut self) -> &mut SolidText {
        if self.solids.is_empty() {
            self.solids.push(SolidText::default());
        }
        let last = self.solids.len() - 1;
        &mut self.solids[last]
    }

    fn notes(&self) -> Vec<Note> {
        let places = |offsets: &[usize]| lines_of(self.text, offsets).into_iter().map(Place::Line).collect();
        let odd = &self.odd;
        [
            (&odd.unopened, "no `solid` line before this"),
            (&odd.unclosed, "a solid begins before `endsolid`"),
            (&odd.unknown, "a line that is no STL was skipped"),
            (&odd.without_normal, "a facet without a normal of three numbers"),
            (&odd.polygons, "a facet with more than three vertices was read as a polygon"),
        ]
        .into_iter()
        .filter_map(|(tally, text)| tally.note(Severity::Warning, places, text))
        .collect()
    }
}

/// The name behind `solid`, without the comment behind that.
fn solid_name(rest: &[u8]) -> String {
    let is_comment = |at: &usize| rest[*at] == b'#' && (*at == 0 || is_blank(rest[at - 1]));
    let end = (0..rest.len()).find(is_comment).unwrap_or(rest.len());
    String::from_utf8_lossy(&rest[..end]).trim().to_owned()
}
