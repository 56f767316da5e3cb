//! The elements of a plot.

use super::axis::Fitted;
use super::legend::legend;
use super::{Mark, Plot, Series};
use crate::report::html::escape_html;
use std::fmt::Write;

/// The colours of M. Okabe and K. Ito, *Color universal design*, 2002; their yellow, too light on white, is last.
const COLOURS: [&str; 8] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#000000", "#e69f00", "#56b4e9", "#b3a100"];
/// Lengths of dashes and gaps, in pixels.
const DASHES: [&str; 4] = ["none", "7 3", "2 3", "9 3 2 3"];
const GREY: &str = "#767676";

/// Room round the field for numbers and labels, in pixels.
const LEFT: f64 = 68.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 52.0;
const RIGHT: f64 = 14.0;
/// Half the height of a sign.
const SIGN: f64 = 4.0;

/// The field of a plot and where numbers lie in it.
struct Field {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
    x: Fitted,
    y: Fitted,
}

impl Field {
    fn x(&self, x: f64) -> f64 {
        self.left + self.x.share(x) * self.width
    }

    fn y(&self, y: f64) -> f64 {
        self.top + (1.0 - self.y.share(y)) * self.height
    }
}

/// How a series looks.
pub(super) struct Look {
    pub(super) colour: &'static str,
    pub(super) dash: &'static str,
    pub(super) sign: usize,
}

impl Look {
    pub(super) fn of(series: &Series, place: usize) -> Self {
        let number = series.colour.unwrap_or(place);
        match series.mark {
            Mark::Frontier => Self { colour: GREY, dash: "6 4", sign: 0 },
            Mark::Guide => Self { colour: GREY, dash: "2 4", sign: 0 },
            _ => Self {
                colour: COLOURS[number % COLOURS.len()],
                dash: DASHES[number / 2 % DASHES.len()],
                sign: number % SIGNS,
            },
        }
    }
}

/// The plot as SVG.
pub(super) fn svg(plot: &Plot, id: &str) -> String {
    let (legend, legend_width) = legend(plot);
    let [width, height] = plot.size.map(f64::from);
    let taken = |axis: usize| {
        plot.series.iter().flat_map(move |series| kept(plot, series).map(move |(_, point)| point[axis]))
    };
    let field = Field {
        left: LEFT,
        top: TOP,
        width: (width - LEFT - RIGHT - legend_width).max(50.0),
        height: (height - TOP - BOTTOM).max(50.0),
        x: plot.x.fit(taken(0)),
        y: plot.y.fit(taken(1)),
    };
    let mut out = format!(
        "<svg role=\"img\" aria-labelledby=\"{id}.title {id}.desc\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\">\n<title id=\"{id}.title\">{}</title>\n<desc id=\"{id}.desc\">{}</desc>\n",
        escape_html(&plot.title),
        escape_html(&plot.description),
    );
    let _ = writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>");
    text(&mut out, [LEFT, 18.0], "start", "font-weight=\"600\" font-size=\"14\"", &plot.title);
    axes(plot, &field, &mut out);
    let _ = writeln!(
        out,
        "<clipPath id=\"{id}.field\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>",
        field.left - SIGN,
        field.top - SIGN,
        field.width + 2.0 * SIGN,
        field.height + 2.0 * SIGN
    );
    let _ = writeln!(out, "<g clip-path=\"url(#{id}.field)\">");
    for (place, series) in plot.series.iter().enumerate() {
        draw_series(plot, series, &Look::of(series, place), &field, &mut out);
    }
    out.push_str("</g>\n");
    let _ = writeln!(
        out,
        "<g transform=\"translate({:.1} {TOP})\">\n{legend}</g>\n</svg>",
        width - legend_width - RIGHT / 2.0
    );
    out
}

/// The points of a series that have a place, with their numbers.
fn kept<'a>(plot: &'a Plot, series: &'a Series) -> impl Iterator<Item = (usize, [f64; 2])> + 'a {
    let points = series.points.iter().copied().enumerate();
    points.filter(|(_, [x, y])| plot.x.takes(*x) && plot.y.takes(*y))
}

/// Text at a place; `more` are further attributes.
pub(super) fn text(out: &mut String, [x, y]: [f64; 2], anchor: &str, more: &str, words: &str) {
    let words = escape_html(words);
    let _ = writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" {more}>{words}</text>");
}

fn axes(plot: &Plot, field: &Field, out: &mut String) {
    let (right, bottom) = (field.left + field.width, field.top + field.height);
    let mut lines = String::new();
    for (at, label) in field.x.ticks() {
        let x = field.x(at);
        let _ = write!(lines, "M{x:.1} {:.1}V{bottom:.1}", field.top);
        text(out, [x, bottom + 16.0], "middle", "", &label);
    }
    for (at, label) in field.y.ticks() {
        let y = field.y(at);
        let _ = write!(lines, "M{:.1} {y:.1}H{right:.1}", field.left);
        text(out, [field.left - 6.0, y + 4.0], "end", "", &label);
    }
    let _ = writeln!(out, "<path d=\"{lines}\" stroke=\"#e4e4e4\" fill=\"none\"/>");
    let _ = writeln!(
        out,
        "<path d=\"M{:.1} {:.1}V{bottom:.1}H{right:.1}\" stroke=\"#333\" fill=\"none\"/>",
        field.left, field.top
    );
    text(out, [field.left + field.width / 2.0, bottom + 38.0], "middle", "", &plot.x.label);
    let (x, y) = (16.0, field.top + field.height / 2.0);
    text(out, [x, y], "middle", &format!("transform=\"rotate(-90 {x:.1} {y:.1})\""), &plot.y.label);
}

fn draw_series(plot: &Plot, series: &Series, look: &Look, field: &Field, out: &mut String) {
    let points: Vec<(usize, [f64; 2])> =
        kept(plot, series).map(|(number, [x, y])| (number, [field.x(x), field.y(y)])).collect();
    let mut path = String::new();
    for (place, &(_, [x, y])) in points.iter().enumerate() {
        let before = place.checked_sub(1).map(|before| points[before].1);
        match (series.mark, before) {
            (Mark::Points, _) => {}
            (Mark::Steps, None) => {
                let _ = write!(path, "M{x:.1} {:.1}V{y:.1}", field.top + field.height);
            }
            (_, None) => {
                let _ = write!(path, "M{x:.1} {y:.1}");
            }
            (Mark::Frontier | Mark::Steps, Some(_)) => {
                let _ = write!(path, "H{x:.1}V{y:.1}");
            }
            (_, Some(_)) => {
                let _ = write!(path, "L{x:.1} {y:.1}");
            }
        }
    }
    if !path.is_empty() {
        let _ = writeln!(
            out,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" stroke-dasharray=\"{}\"/>",
            look.colour, look.dash
        );
    }
    for &(number, at) in &points {
        if matches!(series.mark, Mark::Points | Mark::Line) {
            sign(out, at, look);
        }
        if let Some(label) = series.labels.get(number) {
            // Towards the middle, so that names stay within the field.
            let inwards = at[0] < field.left + 0.8 * field.width;
            let (x, anchor) = if inwards { (at[0] + 8.0, "start") } else { (at[0] - 8.0, "end") };
            text(out, [x, at[1] + 4.0], anchor, "", label);
        }
    }
}

/// How many signs there are.
const SIGNS: usize = 6;

/// One of six signs, which differ in form.
pub(super) fn sign(out: &mut String, [x, y]: [f64; 2], look: &Look) {
    let s = SIGN;
    let path = match look.sign {
        0 => format!("M{:.1} {y:.1}a{s} {s} 0 1 0 {} 0a{s} {s} 0 1 0 {} 0Z", x - s, 2.0 * s, -2.0 * s),
        1 => format!("M{:.1} {:.1}h{}v{}h{}Z", x - s, y - s, 2.0 * s, 2.0 * s, -2.0 * s),
        2 => format!("M{x:.1} {:.1}l{s} {}h{}Z", y - s, 2.0 * s, -2.0 * s),
        3 => format!("M{x:.1} {:.1}l{s} {s}l{} {s}l{} {}Z", y - s, -s, -s, -s),
        4 => format!("M{x:.1} {:.1}l{s} {}h{}Z", y + s, -2.0 * s, -2.0 * s),
        _ => format!(
            "M{:.1} {:.1}l{} {}m0 {}l{} {}",
            x - s,
            y - s,
            2.0 * s,
            2.0 * s,
            -2.0 * s,
            -2.0 * s,
            2.0 * s
        ),
    };
    let _ = writeln!(
        out,
        "<path d=\"{path}\" fill=\"{0}\" fill-opacity=\"0.75\" stroke=\"{0}\" stroke-width=\"1.4\"/>",
        look.colour
    );
}
