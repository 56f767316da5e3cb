//! Writing an OBJ back into its own text.
//!
//! Every byte outside `vn` and `f` lines is copied. The text is parsed statement by statement, as the reader did, so
//! that the n-th face here is the n-th face there. In `f` lines only normal indices change: vertices and texture
//! coordinates keep their spelling (indices that count back stay right because no `v` or `vt` moves), and so do
//! blanks, continuations and comments between them.

use super::cursor::Cursor;
use super::document::ObjDocument;
use super::new_file::{NormalNumbers, check_emit};
use super::statements::{Keyword, Statement, statements};
use crate::io::text::{Copier, counted, line_end_length, push_integer};
use crate::io::{Loaded, Note, PartEdit, WriteError, WriteOptions, Written};
use crate::mesh::{FaceEdit, Mesh, Storage};
use std::ops::Range;

/// The document with the edit applied. Fails if free-form surfaces refer to normals by number, or for normals of faces.
pub(in crate::io) fn edit(
    document: &ObjDocument,
    loaded: &Loaded,
    edits: &[PartEdit],
    options: &WriteOptions,
) -> Result<Written, WriteError> {
    check_emit(options)?;
    let mesh = &loaded.parts[0].mesh;
    let edit = &edits[0];
    let text = document.source().ok_or_else(WriteError::no_document)?;
    let bytes =
        if changes_nothing(mesh, edit) { text.to_vec() } else { edited((document, text), mesh, edit)? };
    let vertices = mesh.vertex_count() as u64;
    let mut written = Written { bytes, vertices, ..Written::default() };
    let companions = &document.libraries.files;
    if options.stem.is_some() {
        written.companions.clone_from(companions);
    } else if let Some(first) = companions.first() {
        let files = counted(companions.len(), "file", "files");
        let text = format!(
            "not copied to a stream, although the output refers to it: {files} (first: `{}`)",
            first.name
        );
        written.notes.push(Note::remark(text));
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
    let stored = mesh.columns().normals.as_ref();
    stored.is_some_and(|stored| edit.kept == stored.values.len() && new.index == stored.index)
}

fn edited(
    (document, text): (&ObjDocument, &[u8]),
    mesh: &Mesh,
    edit: &PartEdit,
) -> Result<Vec<u8>, WriteError> {
    if edit.normals.is_some() && document.surface_normals {
        let text = "free-form surfaces of this OBJ refer to normals by number, and these would change; write another format";
        return Err(WriteError::Unsupported(text.to_owned()));
    }
    let (insertion, before) = document.insertion;
    let numbers = edit.normals.as_ref();
    let numbers = numbers.map(|normals| NormalNumbers::new(mesh, edit, normals, before, Storage::F32));
    let mut editor = Editor {
        mesh,
        numbers: numbers.as_ref(),
        copy: Copier::new(text, 4),
        faces: &edit.faces,
        tokens: Vec::new(),
        face: 0,
        normal: 0,
    };
    let mut to_insert = numbers.as_ref();
    for statement in statements(text) {
        if statement.start >= insertion
            && let Some(numbers) = to_insert.take()
        {
            editor.copy.copy_to(insertion);
            numbers.push_lines(line_end(text), &mut editor.copy.out);
        }
        match statement.keyword {
            Keyword::Normal => {
                if numbers.as_ref().is_some_and(|numbers| !numbers.keeps(editor.normal)) {
                    editor.copy.skip(statement.start..statement.end);
                }
                editor.normal += 1;
            }
            Keyword::Face => editor.face_line(statement),
            _ => {}
        }
    }
    editor.copy.copy_to(text.len());
    Ok(editor.copy.out)
}

/// The line end of a text: its first one, or LF without any.
fn line_end(text: &[u8]) -> &[u8] {
    let first = memchr::memchr2(b'\n', b'\r', text).map(|at| &text[at..]);
    first.map_or(&b"\n"[..], |rest| &rest[..line_end_length(rest)])
}

/// One corner of a face line: its bytes, and where its `v` or `v/vt` ends.
#[derive(Clone)]
struct Token {
    span: Range<usize>,
    head: usize,
}

struct Editor<'a> {
    mesh: &'a Mesh,
    /// `None` if normals do not change.
    numbers: Option<&'a NormalNumbers<'a>>,
    copy: Copier<'a>,
    faces: &'a FaceEdit,
    tokens: Vec<Token>,
    /// How many faces and normals came before.
    face: usize,
    normal: usize,
}

impl Editor<'_> {
    fn face_line(&mut self, statement: Statement) {
        self.tokens.clear();
        let mut cursor = Cursor::new(self.copy.text, statement.arguments);
        while let Some(start) = cursor.next_argument() {
            let token = cursor.token();
            self.tokens.push(Token { span: start..cursor.at, head: start + head_length(token) });
        }
        if self.tokens.len() < 3 {
            // The reader skipped this one. It may refer to normals that are no longer there.
            if self.numbers.is_some() {
                self.rewrite(None, false);
            }
            return;
        }
        let face = self.face;
        self.face += 1;
        let reversed = self.faces.reverses(face as u32);
        if !self.faces.keeps(face as u32) {
            self.copy.skip(statement.start..statement.end);
        } else if reversed || self.numbers.is_some() {
            self.rewrite(Some(self.mesh.faces().range(face).start), reversed);
        }
    }

    /// Writes a face line with its new normals, or without any if the mesh does not have it. A reversed face keeps its first corner.
    fn rewrite(&mut self, first_corner: Option<usize>, reversed: bool) {
        for (place, token) in self.tokens.iter().enumerate() {
            self.copy.skip(token.span.clone());
            let from = if reversed && place > 0 { self.tokens.len() - place } else { place };
            let source = &self.tokens[from];
            let text = self.copy.text;
            let Some(numbers) = self.numbers else {
                self.copy.out.extend_from_slice(&text[source.span.clone()]);
                continue;
            };
            let head = &text[source.span.start..source.head];
            self.copy.out.extend_from_slice(head);
            if let Some(number) = first_corner.and_then(|first| numbers.of_corner(first + from)) {
                self.copy.out.extend_from_slice(if head.contains(&b'/') { b"/" } else { b"//" });
                push_integer(&mut self.copy.out, number.into());
            }
        }
    }
}

/// The length of `v` or `v/vt` in a corner; a slash without a number behind it does not count.
fn head_length(token: &[u8]) -> usize {
    let mut slashes = memchr::memchr_iter(b'/', token);
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
