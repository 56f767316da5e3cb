//! Label statements to labels of faces.

use super::cursor::name_text;
use super::notes::SMOOTHING_NAME;
use super::piece::Label;
use super::statements::Keyword;
use crate::io::repeated_notes::RepeatedNotes;
use crate::io::text::integer_prefix;
use crate::mesh::{FaceLabels, NONE, SmoothingGroups};
use rustc_hash::{FxHashMap, FxHashSet};

/// All label statements of a file, in order, with the faces of the whole file counted.
pub(super) struct Labels<'a> {
    pub text: &'a [u8],
    pub all: Vec<Label>,
    pub faces: usize,
}

impl<'a> Labels<'a> {
    fn of(&self, keyword: Keyword) -> impl Iterator<Item = &Label> + Clone + '_ {
        self.all.iter().filter(move |label| label.keyword == keyword)
    }

    fn name(&self, label: &Label) -> &'a [u8] {
        &self.text[label.name.clone()]
    }

    /// The label of each face: `number` gives that of a statement, and faces before the first one get `none`.
    fn of_faces(&self, keyword: Keyword, none: u32, mut number: impl FnMut(&Label) -> u32) -> Vec<u32> {
        let (mut of_face, mut current) = (Vec::with_capacity(self.faces), none);
        for label in self.of(keyword) {
            of_face.resize(label.face as usize, current);
            current = number(label);
        }
        of_face.resize(self.faces, current);
        of_face
    }

    /// The materials, objects or groups of faces; `None` if no face has one. An empty name sets none.
    pub fn names(&self, keyword: Keyword) -> Option<FaceLabels> {
        self.of(keyword).find(|label| !label.name.is_empty())?;
        let (mut numbers, mut names) = (FxHashMap::default(), Vec::new());
        let of_face = self.of_faces(keyword, NONE, |label| match self.name(label) {
            [] => NONE,
            name => *numbers.entry(name).or_insert_with(|| {
                names.push(name_text(name));
                names.len() as u32 - 1
            }),
        });
        of_face.iter().any(|&label| label != NONE).then_some(FaceLabels { of_face, names })
    }

    /// The object of each face: that of `o` if the file has any, else that of `g`.
    pub fn objects(&self) -> Option<FaceLabels> {
        self.names(Keyword::Object).or_else(|| self.names(Keyword::Group))
    }

    /// The smoothing groups; `None` if the file has no statement about them.
    ///
    /// A group's number is a name. `off`, 0 and an empty name mean none; a number that fits is itself; any
    /// other word (`on`, a fraction, a number of 2³² or more) is a group of its own by that name, numbered
    /// from the top down.
    pub fn smoothing(&self, notes: &mut RepeatedNotes) -> Option<SmoothingGroups> {
        let statements = self.of(Keyword::Smoothing);
        let before_first = statements.clone().next()?.face as usize;
        let numbers: FxHashSet<u32> = statements.filter_map(|label| group_number(self.name(label))).collect();
        let mut free = (0..NONE).rev().filter(|id| !numbers.contains(id));
        let mut names: FxHashMap<&[u8], u32> = FxHashMap::default();
        let of_face = self.of_faces(Keyword::Smoothing, 0, |label| {
            let token = self.name(label);
            group_number(token).unwrap_or_else(|| {
                notes.add(SMOOTHING_NAME, label.name.start);
                match token {
                    [] => 0,
                    // A file cannot name more groups than there are numbers.
                    name => *names.entry(name).or_insert_with(|| free.next().unwrap_or(0)),
                }
            })
        });
        Some(SmoothingGroups { of_face, before_first })
    }
}

fn group_number(token: &[u8]) -> Option<u32> {
    if token.eq_ignore_ascii_case(b"off") {
        return Some(0);
    }
    match integer_prefix(token)? {
        (value, length) if length == token.len() && token[0].is_ascii_digit() => {
            u32::try_from(value).ok().filter(|&id| id != NONE)
        }
        _ => None,
    }
}
