//! The report of `crease inspect` on one input file, as JSON.
//!
//! # The JSON schema, `crease-inspect/2`
//! One object on one line for each input, in the order of the inputs. A change that could break a reader raises the
//! number after the slash; new members may come at any time. Under 1, `area_share` was 0 where it is null now.
//!
//! | member | meaning |
//! |---|---|
//! | `schema`, `crease` | `"crease-inspect/2"`; the program's version |
//! | `status` | `"ok"`: read, and nothing that `--fail-on` asks for; `"findings"`: read, and something; `"failed"`: not read |
//! | `error` | as in `crease-normals/1`, if it failed |
//! | `input` | as in `crease-normals/1` |
//! | `verdict` | the gravest severity told, or null |
//! | `counts` | how many findings are `error`, `warning`, `note` |
//! | `hidden` | the same of what `--severity`, `--ignore` and `--only` left out |
//! | `parts` | `name`, `vertices` (that faces use; in STL three a facet; the `vertex` of a place counts others too), `faces`, `corners`, and `estimate`, null if stored normals do not tell: `weight`, `crease` (degrees), `groups` (whether smoothing groups count too), `turned` (whether all normals were turned or mirrored together: the rest is of them turned back), `sample` (corners), `reproduced`, `separated` (shares), `median` (degrees); and `precision`, null if they were rounded to no grid that tells: `grid` (in words), `degrees` (a bound of what rounding to the nearest turns a normal by), `exponent` (the largest of a highlight that it serves, null if it may show on a matte surface) |
//! | `findings` | the gravest first, below |
//! | `against` | with `--against` only, below |
//! | `seconds` | `read`, `inspect`, `total` |
//!
//! A finding has `id`, `severity`, `family`, `cause` (in words), `element` (what is counted), `count`, `of`, `share`,
//! `area_share` (null for edges, vertices and nodes), `degrees` (the largest angle by which a normal is off, or null: it is not
//! normals, or they have no direction, or the right one), `steps` (what that, or a length, does under a key light, in 8-bit
//! steps, or null), `measure` (how bad the worst place is by another measure: `value` and `unit`, or null), `confidence` (how sure it is which side is the outer one, or null), `command` (what mends it, or null) and
//! `places`: the worst ten, by `measure` where there is one; the largest angle is then not always among them. A place has
//! `part`, and where known `face`, `corner` (of the face), `vertex`, all from 0, `position` (in the space of the part),
//! `degrees`, `node` (the way to
//! the first node that has the part, as `body/arm/hand`, glTF) and `line` (OBJ: of its face, or of its vertex where it is on
//! none, from 1).
//!
//! `against` has `path`, the file that came after; `faces`, `unmatched` (faces without counterpart) as pairs, before and
//! after; `turned` (faces that go round the other way); `corners` (matched; of a polygon that the other file has as triangles
//! those of these), `gained` and `lost` (normals), `changed` (by more than 0.0001°), `visible` (by half an 8-bit step and more
//! under a key light); `mean` and `largest`, each `degrees` and `steps` (the mean of what each change does); `places`, those that changed most, in the input; and `findings`: `id`, `before` and `after`
//! (counts) of what either file has.

use crate::cli::common::input::Source;
use crate::cli::common::report::{Head, InputReport};
use crease::num::Degrees;
use crease::quality::{Comparison, Diagnosis, Finding, PartDiagnosis, Severity, Site};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// The report of one input.
#[derive(Serialize)]
pub struct InspectReport {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    pub verdict: Option<Severity>,
    pub counts: Counts,
    pub hidden: Counts,
    pub parts: Vec<PartDiagnosis>,
    pub findings: Vec<FindingReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<Against>,
    pub seconds: Seconds,
}

#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Counts {
    pub error: usize,
    pub warning: usize,
    pub note: usize,
}

impl Counts {
    /// The counts of all findings.
    pub fn of(diagnosis: &Diagnosis) -> Self {
        let [note, warning, error] = Severity::ALL.map(|severity| diagnosis.count(severity));
        Self { error, warning, note }
    }

    /// The findings that are not among others.
    pub fn without(self, others: Self) -> Self {
        Self {
            error: self.error - others.error,
            warning: self.warning - others.warning,
            note: self.note - others.note,
        }
    }
}

#[derive(Debug, Default, Serialize)]
pub struct Seconds {
    pub read: f64,
    pub inspect: f64,
    pub total: f64,
}

impl InspectReport {
    pub fn new(source: &Source) -> Self {
        Self {
            head: Head::new("crease-inspect/2"),
            input: InputReport::new(source, None),
            verdict: None,
            counts: Counts::default(),
            hidden: Counts::default(),
            parts: Vec::new(),
            findings: Vec::new(),
            against: None,
            seconds: Seconds::default(),
        }
    }

    /// Takes over a diagnosis; commands that fix a finding would write `output`.
    pub fn fill(&mut self, diagnosis: &Diagnosis, output: &str) {
        self.counts = Counts::of(diagnosis);
        self.verdict = diagnosis.worst();
        self.parts.clone_from(&diagnosis.parts);
        let path = &self.input.path;
        let report = |finding: Finding| FindingReport { command: finding.command(path, output), finding };
        self.findings = diagnosis.findings.iter().cloned().map(report).collect();
    }
}

/// A finding and the command that fixes it.
pub struct FindingReport {
    pub finding: Finding,
    pub command: Option<String>,
}

impl Serialize for FindingReport {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { finding, command } = self;
        let entry = finding.kind.entry();
        let measure = finding.amount.zip(finding.kind.unit());
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("id", entry.id)?;
        map.serialize_entry("severity", &finding.severity)?;
        map.serialize_entry("family", entry.family.name())?;
        map.serialize_entry("cause", &finding.cause)?;
        map.serialize_entry("element", entry.element.name())?;
        map.serialize_entry("count", &finding.count)?;
        map.serialize_entry("of", &finding.of)?;
        map.serialize_entry("share", &finding.share())?;
        map.serialize_entry("area_share", &finding.area_share)?;
        map.serialize_entry("degrees", &finding.degrees)?;
        map.serialize_entry("steps", &finding.steps)?;
        map.serialize_entry("measure", &measure.map(|(value, unit)| Measure { value, unit }))?;
        map.serialize_entry("confidence", &finding.confidence)?;
        map.serialize_entry("command", command)?;
        map.serialize_entry("places", &finding.places)?;
        map.end()
    }
}

#[derive(Serialize)]
struct Measure {
    value: f64,
    unit: &'static str,
}

/// What is different in another file.
#[derive(Serialize)]
pub struct Against {
    pub path: String,
    pub faces: [usize; 2],
    pub unmatched: [usize; 2],
    pub turned: usize,
    pub corners: usize,
    pub gained: usize,
    pub lost: usize,
    pub changed: usize,
    pub visible: usize,
    pub mean: Change,
    pub largest: Change,
    pub places: Vec<Site>,
    pub findings: Vec<FindingChange>,
}

/// An angle, and what it does under a key light.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Change {
    pub degrees: Degrees,
    pub steps: f64,
}

#[derive(Debug, Serialize)]
pub struct FindingChange {
    pub id: &'static str,
    pub before: u64,
    pub after: u64,
}

impl Against {
    pub fn new(path: String, comparison: &Comparison) -> Self {
        let [mean, largest] = comparison.steps();
        let findings = comparison.findings.iter();
        Self {
            path,
            faces: comparison.faces,
            unmatched: comparison.unmatched,
            turned: comparison.turned,
            corners: comparison.corners,
            gained: comparison.gained,
            lost: comparison.lost,
            changed: comparison.changed,
            visible: comparison.visible,
            mean: Change { degrees: comparison.mean, steps: mean },
            largest: Change { degrees: comparison.largest, steps: largest },
            places: comparison.places.clone(),
            findings: findings
                .map(|&(kind, [before, after])| FindingChange { id: kind.id(), before, after })
                .collect(),
        }
    }
}
