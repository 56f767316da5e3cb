//! The report of `crease plan` as JSON and as text.

use super::args::{PlanArgs, Reference};
use crate::cli::common::console::{Style, escaped};
use crate::cli::common::numbers::{change, count, row, size};
use crate::cli::common::report::Head;
use crease::io::Note;
use crease::num::{six_digits, three_digits};
use crease::plan::{Axis, Decision, End, FileSize, Metric, Minimise, OutlineShift, Place, Plan, limit};
use serde::Serialize;

/// The choices, the formulas of bounds, and how costs are counted.
pub const EXPLANATION: &str = include_str!("explanation.txt");

#[derive(Debug, Default, Serialize)]
pub struct Report {
    #[serde(flatten)]
    pub head: Head,
    pub input: String,
    metric: Metric,
    tolerance: f64,
    reference: Reference,
    light_cone: f64,
    minimise: Minimise,
    #[serde(flatten)]
    pub plan: Option<Plan>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub page: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub picture: Option<String>,
    /// The budget of seconds, with which a plan depends on the machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    most_seconds: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub draw_seconds: Option<DrawSeconds>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<FileReport>,
    pub seconds: f64,
}

/// Times to draw one picture on this machine.
#[derive(Debug, Serialize)]
pub struct DrawSeconds {
    pub declared: f64,
    pub planned: f64,
}

/// A planned file and its input.
#[derive(Debug, Serialize)]
pub struct FileReport {
    pub input: String,
    pub output: String,
    pub before: FileSize,
    pub after: FileSize,
    pub notes: Vec<Note>,
}

impl Report {
    pub fn new(args: &PlanArgs) -> Self {
        Self {
            head: Head::new("crease-plan/1"),
            input: args.scene().display().to_string(),
            metric: args.metric,
            tolerance: args.tolerance(),
            reference: args.reference,
            light_cone: args.light_cone.unwrap_or(0.0),
            minimise: args.minimise(),
            most_seconds: args.seconds,
            ..Self::default()
        }
    }
}

impl FileReport {
    pub fn rows(&self, out: &mut String) {
        let sizes = |of: fn(&FileSize) -> u64| (of(&self.before), of(&self.after));
        let file = change(sizes(|it| it.file_bytes), size);
        row(out, "file", &format!("{} -> {}: {file}", escaped(&self.input), escaped(&self.output)));
        let data = [
            change(sizes(|it| it.vertices), |count| format!("{count} vertices")),
            format!("their data {}", change(sizes(|it| it.vertex_bytes), size)),
            format!("indices {}", change(sizes(|it| it.index_bytes), size)),
        ];
        row(out, "data", &data.join("; "));
    }
}

/// The report for people: one line a decision, then totals.
pub fn text(report: &Report, style: Style) -> String {
    let Some(plan) = &report.plan else { return String::new() };
    let mut out = style.title(&report.input, report.output.as_deref()) + "\n";
    if plan.decisions.is_empty() {
        let unchanged = match plan.is_cheapest {
            true => "nothing can be omitted within the tolerance",
            false => "no cheaper model was found before the search ended",
        };
        row(&mut out, "plan", unchanged);
    }
    for decision in &plan.decisions {
        row(&mut out, "plan", &line(decision, report));
    }
    let totals = |of: fn(&crease::plan::Cost) -> u64| (of(&plan.declared), of(&plan.planned));
    row(&mut out, "work", &change(totals(|cost| cost.work), |work| format!("{work} operations")));
    row(&mut out, "bytes", &change(totals(|cost| cost.bytes), size));
    row(&mut out, "vertices", &change(totals(|cost| cost.vertices), |count| count.to_string()));
    report.files.iter().for_each(|file| file.rows(&mut out));
    let [x, y] = plan.worst.pixel;
    let view = if plan.views > 1 { format!(" of view {}", plan.worst_view) } else { String::new() };
    let steps = match plan.worst.steps {
        0.0 => "no difference".to_owned(),
        steps => format!("{} of 255 at pixel {x},{y}{view}", Metric::Steps.text(steps)),
    };
    let mut worst = match report.metric {
        Metric::Steps => format!(
            "{steps} (tolerance {}); outlines within {} pixels",
            limit(report.tolerance),
            three_digits(plan.outline)
        ),
        Metric::Flip => format!(
            "{} (tolerance {}); {steps}",
            report.metric.text(plan.worst.by(report.metric)),
            limit(report.tolerance)
        ),
    };
    if report.light_cone > 0.0 {
        worst += &format!("; lights rotated by {}° and {}°", 0.5 * report.light_cone, report.light_cone);
    }
    row(&mut out, "worst", &worst);
    if plan.views > 1 && plan.worst.by(report.metric) > 0.0 {
        row(&mut out, "view", &place(&plan.worst_place));
    }
    if let Some((held_out, at)) = plan.held_out.as_ref().zip(plan.held_out_place.as_ref()) {
        let most = three_digits(held_out.by(report.metric));
        let added = match plan.repairs {
            0 => String::new(),
            repairs => format!("; {} added after failing there", count(repairs, "view")),
        };
        row(&mut out, "held out", &format!("{most} in views that the plan was not found with{added}"));
        row(&mut out, "view", &place(at));
    }
    let search = format!(
        "{}; {} refused, {}, {:.0} Mpixels",
        end(plan, report.minimise),
        count(plan.refused as usize, "model"),
        about(plan.combinations),
        plan.drawn as f64 / 1e6
    );
    row(&mut out, "search", &search);
    let mut time = format!("planned in {:.3} s", report.seconds);
    if let Some(DrawSeconds { declared, planned }) = report.draw_seconds {
        time += &format!("; a picture takes {:.1} ms, before {:.1} ms", 1e3 * planned, 1e3 * declared);
    }
    row(&mut out, "time", &time);
    for (label, file) in [("page", &report.page), ("picture", &report.picture)] {
        if let Some(file) = file {
            row(&mut out, label, &escaped(file));
        }
    }
    out
}

/// Why the search ended, and how much cheaper the cheapest plan may be.
fn end(plan: &Plan, minimise: Minimise) -> String {
    let gap = || match plan.is_cheapest {
        true => "no plan is cheaper".to_owned(),
        false => {
            let gap = three_digits(100.0 * plan.gap);
            format!(
                "a cheaper plan saves at most {gap} % more (none costs less than {} {})",
                plan.proven,
                name(minimise)
            )
        }
    };
    match plan.end {
        End::Time { seconds } => {
            format!("{seconds} s used up, so the plan depends on the machine; {}", gap())
        }
        _ if plan.is_cheapest => "the cheapest plan".to_owned(),
        _ => format!("budget used up; {}", gap()),
    }
}

/// A number of combinations.
fn about(combinations: f64) -> String {
    match combinations {
        few if few < 1e7 => count(few as usize, "combination"),
        f64::MAX => "more than 10^308 combinations".to_owned(),
        many => format!("about {} combinations", three_digits(many)),
    }
}

/// The camera and the lights of a view.
fn place(place: &Place) -> String {
    // Zeros without a sign.
    let list = |vector: [f64; 3]| vector.map(|x| six_digits(x + 0.0)).join(",");
    let turn = place.turn.map_or(String::new(), |turn| {
        format!(", lights rotated by {}° around {}", three_digits(turn.degrees), list(turn.axis))
    });
    format!("--camera 'eye={} target={}'{turn}", list(place.eye), list(place.target))
}

fn name(minimise: Minimise) -> &'static str {
    match minimise {
        Minimise::Work => "operations",
        Minimise::Bytes => "bytes",
        Minimise::Vertices => "vertices",
    }
}

fn line(decision: &Decision, report: &Report) -> String {
    let Decision { what, axis, from, to, saved, bound, measured, outline, .. } = decision;
    let (what, axis) = (escaped(what), if *axis == Axis::Lights { "" } else { axis.name() });
    let bounded = |bound: Option<f64>| {
        bound.map_or("no bound".to_owned(), |bound| format!("bound {}", three_digits(bound)))
    };
    let quantity = name(report.minimise);
    let saves = match saved {
        ..0 => format!("takes {} {quantity} more", saved.unsigned_abs()),
        0 => format!("saves no {quantity} alone"),
        _ => format!("saves {saved} {quantity}"),
    };
    let margin = match report.tolerance - measured {
        beyond if beyond < 0.0 => "within the tolerance only together with other changes".to_owned(),
        margin => format!("margin {}", three_digits(margin)),
    };
    let outline = outline.map_or(String::new(), |OutlineShift { measured, bound }| {
        format!("; outline {} pixels alone ({})", three_digits(measured), bounded(bound))
    });
    format!(
        "{what}: {axis}{}{from} to {to}; {saves}; {} alone ({}, {margin}){outline}",
        if axis.is_empty() { "" } else { " " },
        report.metric.text(*measured),
        bounded(*bound),
    )
}
