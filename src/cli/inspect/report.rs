//! What `crease inspect` tells programs.
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

use super::super::report::{ErrorReport, InputReport};
use super::against::AgainstReport;
use crease::quality::{Diagnosis, Estimate, Finding, PartDiagnosis, Precision, Severity, Site};
use serde::Serialize;

/// The report of one input.
#[derive(Debug, Serialize)]
pub struct InspectReport {
    pub schema: &'static str,
    pub crease: &'static str,
    pub status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ErrorReport>,
    pub input: InputReport,
    pub verdict: Option<Severity>,
    pub counts: Counts,
    pub hidden: Counts,
    pub parts: Vec<PartReport>,
    pub findings: Vec<FindingReport>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub against: Option<AgainstReport>,
    pub seconds: Seconds,
}

#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct Counts {
    pub error: usize,
    pub warning: usize,
    pub note: usize,
}

impl Counts {
    /// Of all findings.
    pub fn of(diagnosis: &Diagnosis) -> Self {
        let [note, warning, error] = Severity::ALL.map(|severity| diagnosis.count(severity));
        Self { error, warning, note }
    }

    /// Those that are not among others.
    pub fn without(self, others: Self) -> Self {
        Self {
            error: self.error - others.error,
            warning: self.warning - others.warning,
            note: self.note - others.note,
        }
    }
}

#[derive(Debug, Serialize)]
pub struct PartReport {
    pub name: String,
    pub vertices: usize,
    pub faces: usize,
    pub corners: usize,
    pub estimate: Option<EstimateReport>,
    pub precision: Option<PrecisionReport>,
}

#[derive(Debug, Serialize)]
pub struct EstimateReport {
    pub weight: &'static str,
    pub crease: f64,
    pub groups: bool,
    pub turned: bool,
    pub sample: usize,
    pub reproduced: f64,
    pub separated: f64,
    pub median: f64,
}

#[derive(Debug, Serialize)]
pub struct PrecisionReport {
    pub grid: String,
    pub degrees: f64,
    pub exponent: Option<u64>,
}

#[derive(Debug, Serialize)]
pub struct FindingReport {
    pub id: &'static str,
    pub severity: Severity,
    pub family: &'static str,
    pub cause: String,
    pub element: &'static str,
    pub count: u64,
    pub of: u64,
    pub share: f64,
    pub area_share: Option<f64>,
    pub degrees: Option<f64>,
    pub steps: Option<f64>,
    pub measure: Option<MeasureReport>,
    pub confidence: Option<f64>,
    pub command: Option<String>,
    pub places: Vec<SiteReport>,
}

#[derive(Debug, Serialize)]
pub struct MeasureReport {
    pub value: f64,
    pub unit: &'static str,
    /// The value as the text has it.
    #[serde(skip)]
    pub reported: String,
}

#[derive(Debug, Serialize)]
pub struct SiteReport {
    pub part: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertex: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u64>,
}

#[derive(Debug, Default, Serialize)]
pub struct Seconds {
    pub read: f64,
    pub inspect: f64,
    pub total: f64,
}

impl InspectReport {
    pub fn new(path: &str) -> Self {
        Self {
            schema: "crease-inspect/2",
            crease: env!("CARGO_PKG_VERSION"),
            status: "ok",
            error: None,
            input: InputReport { path: path.to_owned(), format: None, bytes: None },
            verdict: None,
            counts: Counts::default(),
            hidden: Counts::default(),
            parts: Vec::new(),
            findings: Vec::new(),
            against: None,
            seconds: Seconds::default(),
        }
    }

    /// Takes over what was found, with the names that a command to mend it would have.
    pub fn fill(&mut self, diagnosis: &Diagnosis, output: &str) {
        self.counts = Counts::of(diagnosis);
        self.verdict = diagnosis.worst();
        self.parts = diagnosis.parts.iter().map(PartReport::new).collect();
        let path = self.input.path.clone();
        self.findings = diagnosis.findings.iter().map(|it| FindingReport::new(it, &path, output)).collect();
    }
}

impl PartReport {
    fn new(part: &PartDiagnosis) -> Self {
        let estimate = |estimate: Estimate| EstimateReport {
            weight: estimate.weight.name(),
            crease: estimate.crease.0,
            groups: estimate.groups,
            turned: estimate.turned,
            sample: estimate.sample,
            reproduced: estimate.reproduced,
            separated: estimate.separated,
            median: estimate.median.0,
        };
        let precision = |precision: &Precision| PrecisionReport {
            grid: precision.grid.clone(),
            degrees: precision.error.0,
            exponent: precision.exponent,
        };
        Self {
            name: part.name.clone(),
            vertices: part.vertices,
            faces: part.faces,
            corners: part.corners,
            estimate: part.estimate.map(estimate),
            precision: part.precision.as_ref().map(precision),
        }
    }
}

impl FindingReport {
    fn new(finding: &Finding, input: &str, output: &str) -> Self {
        let entry = finding.kind.entry();
        Self {
            id: entry.id,
            severity: finding.severity,
            family: entry.family.name(),
            cause: finding.cause.clone(),
            element: entry.element.name(),
            count: finding.count,
            of: finding.of,
            share: finding.share(),
            area_share: finding.area_share,
            degrees: finding.degrees,
            steps: finding.steps,
            measure: (finding.amount.zip(finding.kind.unit())).map(|(value, unit)| {
                let reported = finding.kind.write_amount(value);
                MeasureReport { value, unit, reported }
            }),
            confidence: finding.confidence,
            command: finding.command(input, output),
            places: finding.places.iter().map(SiteReport::new).collect(),
        }
    }
}

impl SiteReport {
    pub fn new(site: &Site) -> Self {
        Self {
            part: site.part,
            face: site.face,
            corner: site.corner,
            vertex: site.vertex,
            position: site.position.map(|position| position.to_array()),
            degrees: site.degrees,
            node: site.node.clone(),
            line: site.line,
        }
    }
}
