//! Writing an OBJ back into its own text.
//!
//! Every byte outside `vn` and `f` lines is copied. The text is read statement by statement, as the reader did, so
//! that the n-th face here is the n-th face there. In `f` lines only normal indices change: vertices and texture
//! coordinates keep their spelling (indices that count back stay right because no `v` or `vt` moves), and so do
//! blanks, continuations and comments between them.

use super::ObjDocument;
use super::lexer::{Cursor, Keyword, Statement, statements};
use super::renumber::Renumbering;
use crate::io::decimal::push_integer;
use crate::io::text::counted;
use crate::io::{Emit, Loaded, Note, PartEdit, WriteError, WriteOptions, Written};
use crate::mesh::{ColumnIndex, Mesh, Storage};
use std::ops::Range;

/// The document with the edit applied.
///
/// # Errors
/// [`WriteError::Unsupported`] for one normal a face, which OBJ does not have, and where free-form surfaces refer to
/// normals by number.
pub(in crate::io) fn edit(
    document: &ObjDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    if options.emit == Emit::Face {
        return Err(WriteError::Unsupported(
            "OBJ has no normals of faces; write those of corners".to_owned(),
        ));
    }
    let mesh = &loaded.parts[0].mesh;
    let edit = &edits[0];
    let text = document.source().ok_or_else(WriteError::no_document)?;
    let bytes =
        if changes_nothing(mesh, edit) { text.to_vec() } else { edited((document, text), mesh, edit)? };
    let vertices = mesh.vertex_count() as u64;
    let mut written = Written { bytes, vertices, ..Written::default() };
    match (&options.stem, document.companions.first()) {
        (Some(_), _) => written.companions.clone_from(&document.companions),
        (None, Some(first)) => {
            let files = counted(document.companions.len(), "file", "files");
            let text = format!(
                "a stream has no folder for what the output refers to: {files}, such as `{}`",
                first.name
            );
            written.notes.push(Note::remark(text));
        }
        (None, None) => {}
    }
    Ok(written)
}

fn changes_nothing(mesh: &Mesh, edit: &PartEdit) -> bool {
    if mesh.face_count() == 0 {
        return true;
    }
    if !edit.faces.is_empty() {
        return false;
    }
    let Some(new) = &edit.normals else { return true };
    let Some(stored) = &mesh.columns().normals else { return false };
    let (ColumnIndex::PerCorner(new_index), ColumnIndex::PerCorner(index)) = (&new.index, &stored.index)
    else {
        return false;
    };
    edit.kept == stored.values.len() && new_index == index
}

fn edited(
    (document, text): (&ObjDocument, &[u8]),
    mesh: &Mesh,
    edit: &PartEdit,
) -> Result<Vec<u8>, WriteError> {
    let renumbering = match &edit.normals {
        Some(_) if document.surface_normals => {
            let text =
                "free-form surfaces of this OBJ refer to normals by number; write another format".to_owned();
            return Err(WriteError::Unsupported(text));
        }
        Some(normals) => Some(Renumbering::new(mesh, edit, normals, document.normals_before, Storage::F32)),
        None => None,
    };
    let mut editor = Editor {
        text,
        mesh,
        edit,
        renumbering: renumbering.as_ref(),
        out: Vec::with_capacity(text.len() + text.len() / 4),
        copied: 0,
        tokens: Vec::new(),
        order: Vec::new(),
        face: 0,
        normal: 0,
        dropped: 0,
        reversed: 0,
    };
    let mut to_insert = renumbering.as_ref();
    for statement in statements(text) {
        if statement.start >= document.insertion
            && let Some(renumbering) = to_insert.take()
        {
            editor.copy_to(document.insertion);
            renumbering.push_lines(line_end(text), &mut editor.out);
        }
        match statement.keyword {
            Keyword::Normal => editor.normal_line(statement),
            Keyword::Face => editor.face_line(statement),
            _ => {}
        }
    }
    editor.copy_to(text.len());
    Ok(editor.out)
}

/// How the lines of a text end, judged by its first.
fn line_end(text: &[u8]) -> &'static [u8] {
    match memchr::memchr2(b'\n', b'\r', text).map(|at| &text[at..]) {
        Some([b'\r', b'\n', ..]) => b"\r\n",
        Some([b'\r', ..]) => b"\r",
        _ => b"\n",
    }
}

/// One corner of a face line: where it is, and where its `v` or `v/vt` ends.
#[derive(Clone)]
struct Token {
    span: Range<usize>,
    head: usize,
}

struct Editor<'a> {
    text: &'a [u8],
    mesh: &'a Mesh,
    edit: &'a PartEdit,
    /// `None` if normals stay as they are.
    renumbering: Option<&'a Renumbering<'a>>,
    out: Vec<u8>,
    /// How much of the text is in `out` or left out.
    copied: usize,
    tokens: Vec<Token>,
    order: Vec<u32>,
    face: usize,
    normal: usize,
    /// How many of the dropped and of the reversed faces have been met.
    dropped: usize,
    reversed: usize,
}

impl Editor<'_> {
    fn copy_to(&mut self, end: usize) {
        self.out.extend_from_slice(&self.text[self.copied..end]);
        self.copied = end;
    }

    fn leave_out(&mut self, statement: Statement) {
        self.copy_to(statement.start);
        self.copied = statement.end;
    }

    fn normal_line(&mut self, statement: Statement) {
        if self.renumbering.is_some_and(|renumbering| !renumbering.keeps(self.normal)) {
            self.leave_out(statement);
        }
        self.normal += 1;
    }

    fn face_line(&mut self, statement: Statement) {
        self.find_tokens(statement.arguments);
        if self.tokens.len() < 3 {
            // The reader skipped this one. It may refer to normals that are no longer there.
            if self.renumbering.is_some() {
                self.rewrite(None);
            }
            return;
        }
        let face = self.face;
        self.face += 1;
        if next_is(&self.edit.faces.dropped, &mut self.dropped, face) {
            // It may be named as reversed as well.
            next_is(&self.edit.faces.reversed, &mut self.reversed, face);
            return self.leave_out(statement);
        }
        let reversed = next_is(&self.edit.faces.reversed, &mut self.reversed, face);
        if !reversed && self.renumbering.is_none() {
            return;
        }
        let corners = self.mesh.faces().range(face);
        self.order.clear();
        self.order.extend(0..corners.len() as u32);
        if reversed {
            self.order[1..].reverse();
        }
        self.rewrite(Some(corners));
    }

    fn find_tokens(&mut self, arguments: usize) {
        self.tokens.clear();
        let mut cursor = Cursor::new(self.text, arguments);
        loop {
            cursor.skip_blanks();
            if cursor.at_statement_end() {
                return;
            }
            let start = cursor.at;
            let token = cursor.token();
            self.tokens.push(Token { span: start..cursor.at, head: start + head_length(token) });
        }
    }

    /// Writes the tokens of a face line in their new order with their new normals; without corners, in the old one
    /// with none.
    fn rewrite(&mut self, corners: Option<Range<usize>>) {
        let tokens = std::mem::take(&mut self.tokens);
        for (place, token) in tokens.iter().enumerate() {
            self.copy_to(token.span.start);
            self.copied = token.span.end;
            let from = corners.as_ref().map_or(place, |_| self.order[place] as usize);
            let source = &tokens[from];
            let Some(renumbering) = self.renumbering else {
                self.out.extend_from_slice(&self.text[source.span.clone()]);
                continue;
            };
            let head = &self.text[source.span.start..source.head];
            self.out.extend_from_slice(head);
            if let Some(number) =
                corners.as_ref().and_then(|corners| renumbering.of_corner(corners.start + from))
            {
                self.out.extend_from_slice(if head.contains(&b'/') { b"/" } else { b"//" });
                push_integer(&mut self.out, number.into());
            }
        }
        self.tokens = tokens;
    }
}

/// Whether `face` is the next of an ascending list of which `met` have been met.
fn next_is(faces: &[u32], met: &mut usize, face: usize) -> bool {
    let is_next = faces.get(*met).is_some_and(|&next| next as usize == face);
    *met += usize::from(is_next);
    is_next
}

/// The length of `v` or `v/vt` in a corner; a slash without a number behind it does not count.
fn head_length(token: &[u8]) -> usize {
    let mut slashes = token.iter().enumerate().filter(|&(_, &byte)| byte == b'/').map(|(at, _)| at);
    let Some(first) = slashes.next() else { return token.len() };
    let second = slashes.next().unwrap_or(token.len());
    if second == first + 1 { first } else { second }
}

#[cfg(test)]
mod tests {
    use crate::io::{self, Format, Loaded, PartEdit, ReadOptions, WriteOptions};
    use crate::mesh::{Column, FaceEdit, NONE};
    use glam::DVec3;

    fn load(text: &str) -> Loaded {
        io::read_bytes(text.as_bytes().to_vec(), Some(Format::Obj), None, &ReadOptions::default()).unwrap()
    }

    fn edited(text: &str, edit: PartEdit) -> String {
        let written = io::write(&load(text), &[edit], Format::Obj, &WriteOptions::default()).unwrap();
        String::from_utf8(written.bytes).unwrap()
    }

    fn normals(values: &[DVec3], index: &[u32], kept: usize) -> PartEdit {
        let normals = Some(Column::per_corner(values.to_vec(), index.to_vec()));
        PartEdit { normals, kept, ..PartEdit::default() }
    }

    const POINTS: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";

    #[test]
    fn new_normals_come_before_the_first_face() {
        let text = format!("{POINTS}vt 0 0\ns 1\nf 1 2/1 3/-1 # x\n# y\nf -4/1/ 3//  \\\n\t2/1\nl 1 2\n");
        let edit = normals(&[DVec3::Z, DVec3::X, DVec3::Z, DVec3::Y], &[0, 0, 1, 2, 1, NONE], 0);
        assert_eq!(
            edited(&text, edit),
            format!(
                "{POINTS}vt 0 0\ns 1\nvn 0 0 1\nvn 1 0 0\nf 1//1 2/1/1 3/-1/2 # x\n# y\nf -4/1/1 3//2  \\\n\t2/1\nl 1 2\n"
            )
        );
    }

    #[test]
    fn old_normals_make_room_where_they_were() {
        let text =
            format!("vn 5 5 5\n{POINTS}vn 1 0 0 # a\r\n# b\nf 1//1 2//2 3//-1\nvn 0 1 0\nf 1//3 2 4\n");
        let edit = normals(&[DVec3::NEG_Z], &[0; 6], 0);
        assert_eq!(
            edited(&text, edit),
            format!("{POINTS}vn 0 0 -1\n# b\nf 1//1 2//1 3//1\nf 1//1 2//1 4//1\n")
        );
    }

    #[test]
    fn kept_normals_keep_their_text_and_are_counted_anew() {
        let text = format!("{POINTS}vn 0.0 0 1.00\nvn 9 9 9\nf 1//1 2//2 3//3\nvn 0 1e0 0\nf 1//-1 2 4\n");
        let stored = [DVec3::Z, DVec3::splat(9.0), DVec3::Y];
        let edit = normals(&[&stored[..], &[DVec3::X]].concat(), &[0, 3, 2, 2, 3, 3], 3);
        assert_eq!(
            edited(&text, edit),
            format!("{POINTS}vn 0.0 0 1.00\nvn 1 0 0\nf 1//1 2//2 3//3\nvn 0 1e0 0\nf 1//3 2//2 4//2\n")
        );
    }

    #[test]
    fn nothing_to_change_changes_nothing() {
        let text = format!("{POINTS}vn 0 0 1\n\n f  1//1 2//-1\t3\nf 1 2\nvn nan 0 0\n");
        assert_eq!(edited(&text, PartEdit::default()), text);
        let stored = load(&text).parts[0].mesh.columns().normals.clone();
        let edit = PartEdit { normals: stored, kept: 2, ..PartEdit::default() };
        assert_eq!(edited(&text, edit), text);
    }

    #[test]
    fn dropped_and_reversed_faces_with_their_normals_as_they_are() {
        let text =
            format!("{POINTS}vn 0 0 1\nvt 1 1\nf 1//1 2 3/1\nf 1 2\nf 2 3 \\\n 4\nf 1 2/1\t3//1 4 # q\n");
        let faces = FaceEdit { dropped: vec![1], reversed: vec![0, 1, 2] };
        let edit = PartEdit { faces, ..PartEdit::default() };
        assert_eq!(
            edited(&text, edit),
            format!("{POINTS}vn 0 0 1\nvt 1 1\nf 1//1 3/1 2\nf 1 2\nf 1 4\t3//1 2/1 # q\n")
        );
    }

    #[test]
    fn reversed_faces_with_new_normals_and_texture_coordinates_at_their_corners() {
        let text = format!("{POINTS}vt 1 1\nvn 1 1 1\nf 1 2//1\nf 1/1 2 3\n");
        let faces = FaceEdit { dropped: Vec::new(), reversed: vec![0] };
        let edit = PartEdit { faces, ..normals(&[DVec3::X, DVec3::Y, DVec3::Z], &[0, 1, 2], 0) };
        assert_eq!(
            edited(&text, edit),
            format!("{POINTS}vt 1 1\nvn 1 0 0\nvn 0 1 0\nvn 0 0 1\nf 1 2\nf 1/1/1 3//3 2//2\n")
        );
    }

    #[test]
    fn line_ends_and_marks_stay() {
        let text = "\u{feff}v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3";
        let edit = normals(&[DVec3::Z], &[0; 3], 0);
        assert_eq!(
            edited(text, edit.clone()),
            "\u{feff}v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvn 0 0 1\r\nf 1//1 2//1 3//1"
        );
        assert_eq!(
            edited("f 1 2 3\rv 0 0 0\rv 1 0 0\rv 0 1 0\r", edit),
            "vn 0 0 1\rf 1//1 2//1 3//1\rv 0 0 0\rv 1 0 0\rv 0 1 0\r"
        );
    }

    #[test]
    fn surfaces_that_count_normals_are_not_left_pointing_elsewhere() {
        let text = format!("{POINTS}vn 0 0 1\nf 1 2 3\nsurf 0 1 0 1 1/1/1\n");
        let loaded = load(&text);
        let edit = normals(&[DVec3::X], &[0; 3], 0);
        assert!(io::write(&loaded, &[edit], Format::Obj, &WriteOptions::default()).is_err());
        assert_eq!(edited(&text, PartEdit::default()), text);
    }
}
