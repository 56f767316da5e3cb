//! Reports filled from what the library found.

use super::{
    Edges, ErrorReport, Faults, Head, InputError, InputReport, NoteReport, OrientationReport, OutputReport,
    PartReport, PlaceReport, Recipe, Report, SCHEMA, Seconds, SpotReport, WeldReport,
};
use crate::cli::args::{EMITS, GROUPS, HARD_EDGES, HardEdge, PRECISIONS, RULES, SLIVERS, WHENS};
use crate::cli::choice::name_of;
use crate::cli::inputs::Source;
use crate::cli::normals::Failure;
use crate::cli::request::{Job, Request, Target};
use crease::io::{self, Format, PartEdit, Place, ReadError, Severity, Written};
use crease::mesh::{Orientation, Weld};
use crease::normals::{Broken, Crease, EdgeCounts, FaultReason};
use crease::pipeline::{PartOutcome, ReasonCounts, Spot};
use std::collections::BTreeMap;

impl Report {
    /// A report on an input that nothing has been done with yet.
    pub fn new(job: &Job, request: &Request) -> Self {
        Self {
            head: Head::new(SCHEMA),
            input: InputReport {
                path: match &job.source {
                    Source::Stdin => "-".into(),
                    Source::File(path) => path.to_string_lossy().into_owned(),
                },
                format: job.format.map(Format::extension),
                bytes: None,
            },
            output: None,
            dry_run: request.dry_run,
            recipe: Recipe::new(request),
            parts: Vec::new(),
            notes: Vec::new(),
            seconds: Seconds::default(),
        }
    }

    /// One line.
    pub fn to_json(&self) -> String {
        super::json_line(self)
    }

    /// Notes down why the input was not done.
    pub fn fail(&mut self, failure: &Failure) {
        self.head.fail(ErrorReport::new(failure));
        self.output = None;
    }

    pub fn add_notes(&mut self, notes: &[io::Note]) {
        self.notes.extend(notes.iter().map(NoteReport::new));
    }

    /// Puts face normals into the report.
    pub fn add_rows(&mut self, edits: &[PartEdit]) {
        for (part, edit) in self.parts.iter_mut().zip(edits) {
            let rows = edit.face_normals.iter().flatten().enumerate();
            let rows = rows.map(|(face, row)| edit.faces.keeps(face as u32).then(|| row.to_array()));
            part.face_normals = Some(rows.collect());
        }
    }
}

impl ErrorReport {
    pub fn new(failure: &Failure) -> Self {
        match failure {
            Failure::Read(error) => {
                Self { kind: "input", message: error.to_string(), input: Some(InputError::new(error)) }
            }
            Failure::Usage(message) => Self { kind: "usage", message: message.clone(), input: None },
            Failure::Draw(message) => Self { kind: "input", message: message.clone(), input: None },
            Failure::Write(message) => Self { kind: "output", message: message.clone(), input: None },
            Failure::Internal(message) => Self {
                kind: "internal",
                message: format!("a fault of crease itself, please report it: {message}"),
                input: None,
            },
        }
    }
}

impl NoteReport {
    pub fn new(note: &io::Note) -> Self {
        Self {
            severity: match note.severity {
                Severity::Note => "note",
                Severity::Warning => "warning",
            },
            place: PlaceReport::new(&note.place),
            text: note.text.clone(),
            more: note.more,
            also: note.also.iter().filter_map(PlaceReport::new).collect(),
        }
    }

    /// A warning about the input as a whole.
    pub fn warning(text: String) -> Self {
        Self { severity: "warning", place: None, text, more: 0, also: Vec::new() }
    }
}

impl PlaceReport {
    fn new(place: &Place) -> Option<Self> {
        match place {
            Place::File => None,
            Place::Line(line) => Some(Self::Line(*line)),
            Place::Byte(offset) => Some(Self::Byte(*offset)),
            Place::Json(pointer) => Some(Self::Json(pointer.clone())),
        }
    }
}

impl InputError {
    fn new(error: &ReadError) -> Self {
        Self {
            problem: format!("{:?}", error.problem),
            place: PlaceReport::new(&error.place),
            found: error.found.clone(),
            advice: error.advice.clone(),
        }
    }
}

impl OutputReport {
    /// Of an output that is made but not stored yet.
    pub fn new(target: Option<&Target>, format: Format, unchanged: bool, written: &Written) -> Self {
        Self {
            path: target.map(|target| match target {
                Target::Stdout => "-".into(),
                Target::File(path) => path.to_string_lossy().into_owned(),
            }),
            format: format.extension(),
            bytes: written.bytes.len() as u64,
            vertices: written.vertices,
            added_vertices: written.added_vertices,
            unchanged,
            companions: written.companions.iter().map(|companion| companion.name.clone()).collect(),
        }
    }
}

impl Recipe {
    fn new(request: &Request) -> Self {
        let task = &request.task;
        let recipe = &task.recipe;
        let hard = &recipe.hard_edges;
        let kinds = [
            (hard.uv, HardEdge::Uv),
            (hard.material, HardEdge::Material),
            (hard.authored, HardEdge::Authored),
        ];
        let typed = kinds.iter().filter(|(typed, _)| *typed);
        Self {
            emit: name_of(EMITS, &task.emit),
            weight: recipe.weight.name(),
            crease: match recipe.crease {
                Crease::Default => None,
                Crease::Angle(angle) => Some(angle.0),
            },
            crease_rule: name_of(RULES, &recipe.rule),
            groups: name_of(GROUPS, &recipe.groups),
            hard_edges: typed.map(|(_, kind)| name_of(HARD_EDGES, kind)).collect(),
            when: name_of(WHENS, &task.when),
            weld: match recipe.weld {
                Weld::Exact => WeldReport::Name("exact"),
                Weld::Off => WeldReport::Name("off"),
                Weld::Relative(fraction) => WeldReport::Fraction(fraction),
            },
            slivers: name_of(SLIVERS, &recipe.slivers),
            precision: name_of(PRECISIONS, &recipe.precision),
        }
    }
}

impl PartReport {
    pub fn new(part: &PartOutcome) -> Self {
        let [triangles, quads, polygons] = part.arities;
        let missing = [("Missing", part.replaced.missing)];
        let broken = Broken::ALL.map(|cause| cause.name()).into_iter().zip(part.replaced.broken);
        let replaced = missing.into_iter().chain(broken).filter(|(_, count)| *count > 0);
        Self {
            name: part.name.clone(),
            vertices: part.vertices,
            referenced_vertices: part.summary.referenced_vertices,
            faces: part.faces,
            corners: part.corners,
            triangles,
            quads,
            polygons,
            entries: part.entries,
            splits: part.summary.splits,
            crease_degrees: part.summary.crease_degrees,
            near_crease: part.summary.near_crease,
            edges: Edges::new(&part.summary.edges),
            faults: Faults {
                faces: by_name(&part.faults.faces),
                corners: by_name(&part.faults.corners),
                vertices: by_name(&part.faults.vertices),
            },
            kept_corners: part.kept,
            replaced_corners: replaced.collect(),
            fault_places: spots(&part.fault_places, FaultReason::name),
            broken_places: spots(&part.broken_places, Broken::name),
            reversed_faces: part.reversed_faces,
            dropped_faces: part.dropped_faces,
            non_finite_faces: part.non_finite_faces,
            orientation: part.orientation.as_ref().map(OrientationReport::new),
            quadric_fallbacks: part.summary.quadric_fallbacks,
            cone_declined: part.summary.cone_declined,
            wide_clusters: part.summary.wide_clusters,
            faces_before_groups: part.summary.faces_before_groups,
            fast_declined: part.summary.fast_declined,
            face_normals: None,
        }
    }
}

impl Edges {
    fn new(edges: &EdgeCounts) -> Self {
        let EdgeCounts { smooth, boundary, non_manifold, inconsistent, ambiguous, marked, crease, welded } =
            *edges;
        Self { smooth, boundary, non_manifold, inconsistent, ambiguous, marked, crease, welded }
    }
}

fn spots<R: Copy>(places: &[(Spot, R)], name: impl Fn(R) -> &'static str) -> Vec<SpotReport> {
    let spot = |&(spot, reason): &(Spot, R)| {
        let (face, corner, vertex) = match spot {
            Spot::Face(face) => (Some(face), None, None),
            Spot::Corner { face, corner, vertex } => (Some(face), Some(corner), Some(vertex)),
            Spot::Vertex(vertex) => (None, None, Some(vertex)),
        };
        SpotReport { face, corner, vertex, reason: name(reason) }
    };
    places.iter().map(spot).collect()
}

fn by_name(counts: &ReasonCounts) -> BTreeMap<&'static str, usize> {
    counts.iter().map(|(reason, count)| (reason.name(), count)).collect()
}

impl OrientationReport {
    fn new(found: &Orientation) -> Self {
        Self {
            components: found.components,
            closed: found.closed,
            open_told: found.open_told,
            confidence: (found.open_told > 0).then_some(found.confidence),
            open_left: found.open_left,
            non_orientable: found.non_orientable,
            flat: found.flat,
            undecided: found.undecided,
            inside_out: found.inside_out,
            open_inside_out: found.open_inside_out,
            cavities: found.cavities,
            rooms: found.rooms,
        }
    }
}
