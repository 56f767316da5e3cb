//! The report of `crease inspect` on one input file, as JSON. Members are described in `docs/json.md`.

use crate::cli::common::input::Source;
use crate::cli::common::report::{Head, InputReport};
use crease::num::Degrees;
use crease::quality::{Comparison, Diagnosis, Finding, Fix, PartDiagnosis, Severity, key_light_steps};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

#[derive(Default, Serialize)]
pub struct InspectReport {
    #[serde(flatten)]
    pub head: Head,
    pub input: InputReport,
    pub verdict: Option<Severity>,
    pub counts: Counts,
    pub hidden: Counts,
    pub parts: Vec<PartDiagnosis>,
    pub findings: Vec<FindingReport>,
    pub fix: Option<Fix>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<Against>,
    pub seconds: Seconds,
    /// The name of a fixed version, in the working folder.
    #[serde(skip)]
    pub fix_as: String,
    /// Kinds and paths of the pages and pictures that were written.
    #[serde(skip)]
    pub written: Vec<(&'static str, String)>,
    /// Something is as grave as `--fail-on`.
    #[serde(skip)]
    pub is_grave: bool,
    /// Pictures were drawn of a file with faces in which no normals are stored.
    #[serde(skip)]
    pub lacks_normals: bool,
    /// How many elements have each finding, as an earlier run found.
    #[serde(skip)]
    pub before: BTreeMap<String, u64>,
}

/// The report on an input that an earlier run has inspected: what the journal has.
#[derive(Serialize)]
pub struct SkippedReport<'a> {
    #[serde(flatten)]
    head: &'a Head,
    input: &'a InputReport,
    verdict: Option<Severity>,
    findings: Vec<EarlierFinding<'a>>,
}

#[derive(Serialize)]
struct EarlierFinding<'a> {
    id: &'a str,
    count: u64,
}

impl<'a> SkippedReport<'a> {
    pub fn new(report: &'a InspectReport) -> Self {
        let findings = report.before.iter().map(|(id, &count)| EarlierFinding { id, count }).collect();
        Self { head: &report.head, input: &report.input, verdict: report.verdict, findings }
    }
}

#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Counts {
    pub error: usize,
    pub warning: usize,
    pub note: usize,
}

impl Counts {
    pub fn of(diagnosis: &Diagnosis) -> Self {
        let [note, warning, error] = Severity::ALL.map(|severity| diagnosis.count(severity));
        Self { error, warning, note }
    }

    pub fn total(self) -> usize {
        self.error + self.warning + self.note
    }

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
        Self { head: Head::new("crease-inspect/2"), input: InputReport::new(source, None), ..Self::default() }
    }

    /// Takes over a diagnosis; commands that fix a finding write to `fix_as`.
    pub fn fill(&mut self, diagnosis: &Diagnosis) {
        self.counts = Counts::of(diagnosis);
        self.verdict = diagnosis.worst();
        self.parts.clone_from(&diagnosis.parts);
        let (path, output) = (&self.input.path, &self.fix_as);
        let report = |finding: Finding| FindingReport { command: finding.command(path, output), finding };
        self.findings = diagnosis.findings.iter().cloned().map(report).collect();
    }
}

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
        map.serialize_entry("cause", finding.cause.english())?;
        map.serialize_entry("element", entry.element.name())?;
        map.serialize_entry("count", &finding.count)?;
        map.serialize_entry("of", &finding.of)?;
        map.serialize_entry("share", &finding.share())?;
        map.serialize_entry("area_share", &finding.area_share)?;
        map.serialize_entry("degrees", &finding.degrees)?;
        map.serialize_entry("steps", &finding.steps)?;
        map.serialize_entry(
            "measure",
            &measure.map(|(value, unit)| Measure { value, unit: unit.english().to_owned() }),
        )?;
        map.serialize_entry("confidence", &finding.confidence)?;
        map.serialize_entry("command", command)?;
        map.serialize_entry("places", &finding.places)?;
        map.end()
    }
}

#[derive(Serialize)]
struct Measure {
    value: f64,
    unit: String,
}

pub struct Against {
    pub path: String,
    pub comparison: Comparison,
}

/// An angle, and what it does under a key light.
#[derive(Serialize)]
struct Change {
    degrees: Degrees,
    steps: f64,
}

#[derive(Serialize)]
struct FindingChange {
    id: &'static str,
    before: u64,
    after: u64,
}

impl Serialize for Against {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let it = &self.comparison;
        let [mean, largest] = it.steps();
        let findings = it.findings.iter();
        let findings =
            findings.map(|&(kind, [before, after])| FindingChange { id: kind.id(), before, after });
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("path", &self.path)?;
        map.serialize_entry("faces", &it.faces)?;
        map.serialize_entry("unmatched", &it.unmatched)?;
        map.serialize_entry("turned", &it.turned)?;
        map.serialize_entry("corners", &it.corners)?;
        map.serialize_entry("gained", &it.gained)?;
        map.serialize_entry("lost", &it.lost)?;
        map.serialize_entry("changed", &it.changed)?;
        map.serialize_entry("visible", &it.visible)?;
        map.serialize_entry("mean", &Change { degrees: Degrees(it.angles.mean), steps: mean })?;
        let (rms, percentiles) = (("rms", it.angles.rms), it.percentiles());
        for (name, degrees) in std::iter::once(rms).chain(percentiles) {
            let change = Change { degrees: Degrees(degrees), steps: key_light_steps(degrees) };
            map.serialize_entry(name, &change)?;
        }
        map.serialize_entry("largest", &Change { degrees: it.largest, steps: largest })?;
        map.serialize_entry("places", &it.places)?;
        map.serialize_entry("findings", &findings.collect::<Vec<_>>())?;
        map.end()
    }
}
