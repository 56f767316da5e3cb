//! Collects the findings of an experiment. Each text is looked up by the name of what it describes.

use super::effect::{Caption, Effect, MapScale, Role, Shot, Threshold};
use super::outcome::{Chart, Curve, Drawn, Expected, Measure, Outcome, Range, Scale, Verdict};
use crate::raster::Image;
use crate::text::{Catalogue, Text, Value};
use std::mem::take;

/// An outcome under construction. The keys of texts are the name of a measure, picture, chart or curve, followed by `-measure`,
/// `-by`, `-effect`, `-cure`, `-title`, `-caption`, `-seen`, `-x`, `-y` or `-curve`.
pub(super) struct Recorder {
    texts: &'static Catalogue,
    values: Vec<(&'static str, Value)>,
    pub(super) measures: Vec<Measure>,
    shots: Vec<Shot>,
    charts: Vec<Chart>,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Check {
    /// Nothing.
    None,
    /// A value with a tolerance, by the text `-by`.
    Near(f64, f64),
    /// A bound, by the text `-by`. What is bounded is never negative.
    AtMost(f64),
    /// Nothing under these parameters, for the reason in the text of this key.
    Untested(&'static str),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Axis {
    Linear,
    Log,
}

impl Recorder {
    /// Nothing yet, with values for the placeholders of all texts.
    pub(super) fn new(texts: &'static Catalogue, values: &[(&'static str, Value)]) -> Self {
        let (measures, shots, charts) = (Vec::new(), Vec::new(), Vec::new());
        Self { texts, values: values.to_vec(), measures, shots, charts }
    }

    /// Changes or adds the value of a placeholder for the texts that follow.
    pub(super) fn set(&mut self, placeholder: &'static str, value: impl Into<Value>) {
        self.values.retain(|(name, _)| *name != placeholder);
        self.values.push((placeholder, value.into()));
    }

    pub(super) fn text(&self, key: &str) -> Text {
        self.texts.with(key, &self.values)
    }

    fn part(&self, name: &str, part: &str) -> Text {
        self.text(&key(name, part))
    }

    pub(super) fn measure(&mut self, name: &str, unit: &'static str, value: f64, check: Check) {
        let range = match check {
            Check::Near(value, tolerance) => Some(Range::Near { value, tolerance }),
            Check::AtMost(at_most) => Some(Range::AtMost { at_most }),
            Check::None | Check::Untested(_) => None,
        };
        let agrees = range.map(|range| range.contains(value));
        let expected = range.map(|range| Expected { range, by: self.part(name, "by") });
        let beyond = match check {
            Check::Untested(reason) => Some(self.text(reason)),
            _ => None,
        };
        let name = self.part(name, "measure");
        self.measures.push(Measure { name, unit, value, expected, agrees, beyond });
    }

    /// A number with the artefact and with the cure, which has to make it smaller by a factor.
    pub(super) fn effect(
        &self,
        name: &str,
        unit: &'static str,
        [bad, cured]: [f64; 2],
        present: Threshold,
        factor: f64,
    ) -> Effect {
        let (name, cure) = (self.part(name, "effect"), self.part(name, "cure"));
        Effect { name, unit, bad, present, cure, cured, factor }
    }

    pub(super) fn bad(&mut self, name: &'static str, effect: &Effect, image: Image) {
        self.shots.push(effect.shot(name, false, self.caption(name), image));
    }

    pub(super) fn cured(&mut self, name: &'static str, effect: &Effect, image: Image) {
        self.shots.push(effect.shot(name, true, self.caption(name), image));
    }

    /// Records the difference of two pictures, or a map of an error, with the value of its last colour and the unit.
    pub(super) fn difference(&mut self, name: &'static str, image: Image, full: f64, unit: &'static str) {
        self.unmeasured(name, Role::Difference, image);
        self.scaled(full, unit);
    }

    /// States the scale of the last picture, which is a map: the value of its last colour, and its unit.
    pub(super) fn scaled(&mut self, full: f64, unit: &'static str) {
        if let Some(shot) = self.shots.last_mut() {
            shot.map = Some(MapScale { full, unit });
        }
    }

    /// Records a picture of an artefact that is too faint to be visible without maps.
    pub(super) fn seen(&mut self, name: &'static str, image: Image) {
        self.unmeasured(name, Role::Seen, image);
    }

    pub(super) fn truth(&mut self, name: &'static str, image: Image) {
        self.unmeasured(name, Role::Truth, image);
    }

    fn unmeasured(&mut self, name: &'static str, role: Role, image: Image) {
        let Caption { label, drawn, .. } = self.caption(name);
        self.shots.push(Shot { name, role, label, caption: drawn, measured: None, map: None, image });
    }

    fn caption(&self, name: &str) -> Caption {
        let seen = self.texts.has(&key(name, "seen")).then(|| self.part(name, "seen"));
        Caption { label: self.part(name, "title"), drawn: self.part(name, "caption"), seen }
    }

    pub(super) fn curve(&self, name: &str, drawn: Drawn, points: Vec<[f64; 2]>) -> Curve {
        Curve { name: self.part(name, "curve"), drawn, points }
    }

    pub(super) fn chart(&mut self, name: &'static str, [x, y]: [Axis; 2], curves: Vec<Curve>) {
        let scale = |part: &str, axis| Scale { label: self.part(name, part), logarithmic: axis == Axis::Log };
        let (x, y) = (scale("x", x), scale("y", y));
        let (title, caption) = (self.part(name, "title"), self.part(name, "caption"));
        self.charts.push(Chart { name, title, caption, x, y, curves });
    }

    /// The outcome, with the notes of the texts `note-1`, `note-2`, ….
    pub(super) fn finish(&mut self, verdict: Verdict, effect: Effect) -> Outcome {
        let keys =
            (1..).map(|number: u32| key("note", &number.to_string())).take_while(|key| self.texts.has(key));
        let notes = keys.map(|key| self.text(&key)).collect();
        self.finish_with_notes(notes, verdict, effect)
    }

    pub(super) fn finish_with_notes(
        &mut self,
        notes: Vec<Text>,
        verdict: Verdict,
        effect: Effect,
    ) -> Outcome {
        let (measures, shots, charts) =
            (take(&mut self.measures), take(&mut self.shots), take(&mut self.charts));
        Outcome { verdict, effect, measures, shots, charts, notes }
    }
}

/// The key of a part of the texts of a name.
fn key(name: &str, part: &str) -> String {
    format!("{name}-{part}")
}
