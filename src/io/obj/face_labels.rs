//! Label statements to labels of faces.

use super::cursor::name_text;
use super::notes::SMOOTHING_NAME;
use super::piece::Label;
use super::statements::Keyword;
use crate::io::repeated_notes::RepeatedNotes;
use crate::io::text::parse_number::integer_prefix;
use crate::mesh::{FaceLabels, NONE, SmoothingGroups};
use rustc_hash::{FxHashMap, FxHashSet};

/// All label statements of a file, in order, with the faces of the whole file counted.
pub(super) struct Labels<'a> {
    pub text: &'a [u8],
    pub all: Vec<Label>,
    pub faces: usize,
}

impl<'a> Labels<'a> {
    fn of(&self, keyword: Keyword) -> impl Iterator<Item = (usize, &'a [u8])> + '_ {
        let labels = self.all.iter().filter(move |label| label.keyword == keyword);
        labels.map(|label| (label.face as usize, &self.text[label.name.clone()]))
    }

    /// The materials, objects or groups of faces; `None` if no face has one. An empty name sets none.
    pub fn names(&self, keyword: Keyword) -> Option<FaceLabels> {
        self.of(keyword).find(|(_, name)| !name.is_empty())?;
        let mut numbers: FxHashMap<&[u8], u32> = FxHashMap::default();
        let mut labels = FaceLabels { of_face: Vec::new(), names: Vec::new() };
        let mut current = NONE;
        for (face, name) in self.of(keyword) {
            labels.of_face.resize(face, current);
            current = match name {
                [] => NONE,
                name => *numbers.entry(name).or_insert_with(|| {
                    labels.names.push(name_text(name));
                    labels.names.len() as u32 - 1
                }),
            };
        }
        labels.of_face.resize(self.faces, current);
        labels.of_face.iter().any(|&label| label != NONE).then_some(labels)
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
        let (before_first, _) = self.of(Keyword::Smoothing).next()?;
        let numbers: FxHashSet<u32> =
            self.of(Keyword::Smoothing).filter_map(|(_, token)| group_number(token)).collect();
        let mut free = (0..NONE).rev().filter(|id| !numbers.contains(id));
        let mut names: FxHashMap<&[u8], u32> = FxHashMap::default();
        let mut groups = SmoothingGroups { of_face: Vec::with_capacity(self.faces), before_first };
        let mut current = 0;
        for label in self.all.iter().filter(|label| label.keyword == Keyword::Smoothing) {
            groups.of_face.resize(label.face as usize, current);
            let token = &self.text[label.name.clone()];
            current = group_number(token).unwrap_or_else(|| {
                notes.add(SMOOTHING_NAME, label.name.start);
                match token {
                    [] => 0,
                    // A file cannot name more groups than there are numbers.
                    name => *names.entry(name).or_insert_with(|| free.next().unwrap_or(0)),
                }
            });
        }
        groups.of_face.resize(self.faces, current);
        Some(groups)
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
