//! A finding in a file: its cause in words, its numbers and its positions.

use crate::io::shell_word;
use crate::quality::catalogue::{Entry, Kind};
use crate::quality::counts::{Milder, Tally};
use crate::quality::effect::key_light_steps;
use crate::quality::element::Severity;
use crate::quality::findings::remarks::REMARKS;
use crate::quality::spot::Measure;
use crate::text::Text;
use glam::DVec3;
use serde::Serialize;

/// One of the positions of a finding. All numbers count from 0, as the mesh was read.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Site {
    /// The number of the part in the file.
    pub part: usize,
    /// The face, if it is about one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub face: Option<u32>,
    /// The corner of the face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub corner: Option<u32>,
    /// The vertex.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vertex: Option<u32>,
    /// Where that is, in the space of the part.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "as_array")]
    pub position: Option<DVec3>,
    /// The deviation, if it is an angle, in degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub degrees: Option<f64>,
    /// The index among the nodes that have the part, if it is about a node.
    #[serde(skip)]
    pub place: Option<u32>,
    /// The path to the node that has the part, as `body/arm/hand`; to the first one if there are several (glTF).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub node: Option<String>,
    /// The line of the face in the file, or of the vertex if it is about no face (OBJ).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u64>,
}

fn as_array<S: serde::Serializer>(position: &Option<DVec3>, serializer: S) -> Result<S::Ok, S::Error> {
    position.map(|position| position.to_array()).serialize(serializer)
}

/// A fault, or something to know about a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The kind: the key to the [catalogue](crate::quality::catalogue).
    pub kind: Kind,
    /// How much it matters here.
    pub severity: Severity,
    /// The cause in words, with the numbers of this mesh.
    pub cause: Text,
    /// How many elements have it.
    pub count: u64,
    /// How many elements there are.
    pub of: u64,
    /// Their share of the surface's area. A corner has its part of its face; `None` for elements without area.
    pub area_share: Option<f64>,
    /// The largest angle, in degrees, if an angle measures it.
    pub degrees: Option<f64>,
    /// The largest change of the grey value under a key light by that angle
    /// ([`key_light_steps`](crate::quality::key_light_steps)), or by normals that give no light or too much. `None` if no normal
    /// is off.
    pub steps: Option<f64>,
    /// The amount at the worst position, in the [kind's unit](Kind::unit), if it has one.
    pub amount: Option<f64>,
    /// The confidence at the least certain position, from ½ to 1, where there is a choice: which side of a surface is its
    /// outer one ([`Confidence`](crate::mesh::Confidence)).
    pub confidence: Option<f64>,
    /// The worst positions, worst first: as many as [`Thresholds::places`](crate::quality::Thresholds::places).
    pub places: Vec<Site>,
    /// Options of `crease normals` that fix it; `None` if none does.
    pub remedy: Option<String>,
}

impl Finding {
    /// A finding of so many elements, on a surface of some area.
    pub(crate) fn new(entry: &Entry, tally: Tally, of: u64, area: f64, places: Vec<Site>) -> Self {
        let largest = places.iter().filter_map(|site| site.degrees).reduce(f64::max);
        let steps = tally.worst.iter().filter_map(|spot| match spot.measure {
            Measure::Steps => Some(spot.weight),
            _ => spot.degrees.map(|degrees| key_light_steps(tally.rotation_degrees.unwrap_or(degrees))),
        });
        let amount = tally.worst.first().filter(|spot| spot.measure == Measure::Amount);
        let share = || if area > 0.0 { (tally.area / area).min(1.0) } else { 0.0 };
        let remedy = || tally.remedy.clone().or_else(|| entry.remedy.map(str::to_owned));
        Self {
            kind: entry.kind,
            severity: tally.severity.unwrap_or(entry.severity),
            cause: cause(entry, &tally),
            count: tally.count,
            of,
            area_share: entry.element.has_area().then(share),
            degrees: tally.rotation_degrees.or(largest),
            steps: steps.reduce(f64::max),
            amount: amount.map(|spot| spot.weight.abs()),
            confidence: tally.confidence,
            places,
            remedy: if tally.may_be_meant { None } else { remedy() },
        }
    }

    /// The share of elements that have it.
    pub fn share(&self) -> f64 {
        if self.of == 0 { 0.0 } else { self.count as f64 / self.of as f64 }
    }

    /// The command that fixes it, with these names of input and output quoted for a POSIX shell.
    ///
    /// ```
    /// use crease::io::{Format, ReadOptions, read_bytes};
    /// use crease::quality::{Thresholds, diagnose};
    ///
    /// let zero = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 0\nf 1//1 2//1 3//1\n";
    /// let loaded = read_bytes(zero.to_vec(), Some(Format::Obj), None, &ReadOptions::default())?;
    /// let diagnosis = diagnose(&loaded, &Thresholds::default(), &|_| {});
    /// let command = diagnosis.findings[0].command("a.obj", "b.obj");
    /// assert_eq!(command.as_deref(), Some("crease normals a.obj -o b.obj --when broken"));
    /// # Ok::<(), crease::io::ReadError>(())
    /// ```
    pub fn command(&self, input: &str, output: &str) -> Option<String> {
        self.remedy.as_ref().map(|options| fix_command(input, output, options))
    }
}

/// The command that fixes a file with some options of `crease normals`, for a POSIX shell. Standard input (`-`) is read from
/// `FILE`, in place of which the user puts a name.
pub fn fix_command(input: &str, output: &str, options: &str) -> String {
    let space = if options.is_empty() { "" } else { " " };
    let from = if input == "-" { " < FILE" } else { "" };
    let [input, output] = [input, output].map(shell_word);
    format!("crease normals {input} -o {output}{space}{options}{from}")
}

/// The title with the remark or the sum, and with what was not counted.
fn cause(entry: &Entry, tally: &Tally) -> Text {
    let Milder { components, count } = tally.milder;
    let sum = (tally.sum > 0).then(|| sum_in_words(entry.kind, tally.sum));
    let sum = sum.map(|sum| match components {
        0 => sum,
        _ => REMARKS.with(
            "contradicted",
            &[("sum", sum.into()), ("components", components.into()), ("count", count.into())],
        ),
    });
    let remark = tally.remark.as_ref().map(|remark| remark.text.clone()).or(sum);
    let others =
        (components == 0 && count > 0).then(|| REMARKS.with("of-lower-severity", &[("count", count.into())]));
    let details: Vec<Text> = remark.into_iter().chain(others).collect();
    let title = entry.title();
    if details.is_empty() {
        return title;
    }
    Text::each(|language| {
        let details: Vec<&str> = details.iter().map(|text| text.get(language)).collect();
        format!("{}: {}", title.get(language), details.join("; "))
    })
}

fn sum_in_words(kind: Kind, sum: u64) -> Text {
    let key = match kind {
        Kind::NeedlessSeam => "could-be-merged",
        Kind::OpenInsideOut => "in-open-components",
        _ => "in-closed-components",
    };
    REMARKS.with(key, &[("count", sum.into())])
}
