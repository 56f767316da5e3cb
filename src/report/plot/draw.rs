//! The elements of a plot as SVG.

use super::axis::Fitted;
use super::series::{Mark, Plot, Series};
use super::series::{SIGN, SeriesStyle, series_styles};
use crate::report::html::escape_html;
use crate::report::panel::text_width;
use std::fmt::Write;

/// Margins of the field for numbers and labels, in pixels; the left one may be wider.
const LEFT: f64 = 68.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 52.0;
const RIGHT: f64 = 14.0;
/// The baseline of the upright axis label, and the gap on both sides of the numbers next to it.
const UPRIGHT: f64 = 16.0;
const FREE: f64 = 6.0;
/// The part of a line below its baseline, and the height of a line of 12 pixels, in DejaVu Sans: no usual sans-serif font has
/// wider letters.
const BELOW: f64 = 4.0;
const LINE: f32 = 12.0 * 1.164;
/// The height of a line of the legend, and the width of the sample before the name.
const LEGEND_LINE: f64 = 18.0;
const SAMPLE: f64 = 34.0;

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

pub(super) fn width_of(words: &str) -> f64 {
    f64::from(text_width(words, LINE))
}

impl Plot {
    /// The plot as an element of a page; the ids of its parts begin with the given one and a dot.
    pub fn svg(&self, id: &str) -> String {
        svg(self, id)
    }

    /// A number along an axis with the plot's decimal mark.
    fn written(&self, number: String) -> String {
        match self.decimal_mark {
            '.' => number,
            mark => number.replace('.', &mark.to_string()),
        }
    }
}

fn svg(plot: &Plot, id: &str) -> String {
    let styles = series_styles(&plot.series);
    let (legend, legend_width) = legend(plot, &styles);
    let [width, height] = plot.size.map(f64::from);
    let taken = |axis: usize| {
        plot.series.iter().flat_map(move |series| kept(plot, series).map(move |point| point[axis]))
    };
    let (x, y) = (plot.x.fit(taken(0)), plot.y.fit(taken(1)));
    let widest = y.ticks().iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max);
    let left = f64::max(LEFT, (UPRIGHT + BELOW + FREE + widest + FREE).ceil());
    let field = Field {
        left,
        top: TOP,
        width: (width - left - RIGHT - legend_width).max(50.0),
        height: (height - TOP - BOTTOM).max(50.0),
        x,
        y,
    };
    let mut out = format!(
        "<svg role=\"img\" aria-labelledby=\"{id}.title {id}.desc\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\">\n<title id=\"{id}.title\">{}</title>\n<desc id=\"{id}.desc\">{}</desc>\n",
        escape_html(&plot.title),
        escape_html(&plot.description),
    );
    let _ = writeln!(out, "<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>");
    text(&mut out, [left, 18.0], "start", "font-weight=\"600\" font-size=\"14\"", &plot.title);
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
    // Measured series are drawn over guides.
    let (guides, measured): (Vec<_>, Vec<_>) =
        plot.series.iter().zip(&styles).partition(|(series, _)| series.mark == Mark::Guide);
    for (series, style) in guides.into_iter().chain(measured) {
        draw_series(plot, series, style, &field, &mut out);
    }
    out.push_str("</g>\n");
    let _ = writeln!(
        out,
        "<g transform=\"translate({:.1} {TOP})\">\n{legend}</g>\n</svg>",
        width - legend_width - RIGHT / 2.0
    );
    out
}

/// The points of a series that are on the axes.
fn kept<'a>(plot: &'a Plot, series: &'a Series) -> impl Iterator<Item = [f64; 2]> + 'a {
    series.points.iter().copied().filter(|[x, y]| plot.x.takes(*x) && plot.y.takes(*y))
}

/// Text at a position, with further attributes.
pub(super) fn text(out: &mut String, [x, y]: [f64; 2], anchor: &str, more: &str, words: &str) {
    let words = escape_html(words);
    let _ = writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" {more}>{words}</text>");
}

fn line(out: &mut String, path: &str, style: &SeriesStyle) {
    let SeriesStyle { colour, dash, .. } = style;
    let _ = writeln!(
        out,
        "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.6\" stroke-dasharray=\"{dash}\"/>"
    );
}

fn legend(plot: &Plot, styles: &[SeriesStyle]) -> (String, f64) {
    let named = || plot.series.iter().zip(styles).filter(|(series, _)| !series.name.is_empty());
    let widest = named().map(|(series, _)| width_of(&series.name)).fold(0.0, f64::max);
    if widest == 0.0 {
        return (String::new(), 0.0);
    }
    let mut out = String::new();
    for (number, (series, style)) in named().enumerate() {
        let y = 8.0 + number as f64 * LEGEND_LINE;
        if series.mark != Mark::Points {
            line(&mut out, &format!("M0 {y:.1}H26"), style);
        }
        style.draw_sign(&mut out, [13.0, y]);
        text(&mut out, [SAMPLE, y + 4.0], "start", "", &series.name);
    }
    (out, SAMPLE + widest + 8.0)
}

fn axes(plot: &Plot, field: &Field, out: &mut String) {
    let (right, bottom) = (field.left + field.width, field.top + field.height);
    let mut lines = String::new();
    for (at, label) in field.x.ticks() {
        let x = field.x(at);
        let _ = write!(lines, "M{x:.1} {:.1}V{bottom:.1}", field.top);
        text(out, [x, bottom + 16.0], "middle", "", &plot.written(label));
    }
    for (at, label) in field.y.ticks() {
        let y = field.y(at);
        let _ = write!(lines, "M{:.1} {y:.1}H{right:.1}", field.left);
        text(out, [field.left - FREE, y + BELOW], "end", "", &plot.written(label));
    }
    let _ = writeln!(out, "<path d=\"{lines}\" stroke=\"#e4e4e4\" fill=\"none\"/>");
    let _ = writeln!(
        out,
        "<path d=\"M{:.1} {:.1}V{bottom:.1}H{right:.1}\" stroke=\"#333\" fill=\"none\"/>",
        field.left, field.top
    );
    text(out, [field.left + field.width / 2.0, bottom + 38.0], "middle", "", &plot.x.label);
    let (x, y) = (UPRIGHT, field.top + field.height / 2.0);
    text(out, [x, y], "middle", &format!("transform=\"rotate(-90 {x:.1} {y:.1})\""), &plot.y.label);
}

fn draw_series(plot: &Plot, series: &Series, style: &SeriesStyle, field: &Field, out: &mut String) {
    let points: Vec<[f64; 2]> = kept(plot, series).map(|[x, y]| [field.x(x), field.y(y)]).collect();
    let mut path = String::new();
    for (place, &[x, y]) in points.iter().enumerate() {
        path += &match (series.mark, place) {
            (Mark::Points, _) => String::new(),
            (Mark::Steps, 0) => format!("M{x:.1} {:.1}V{y:.1}", field.top + field.height),
            (_, 0) => format!("M{x:.1} {y:.1}"),
            (Mark::Frontier | Mark::Steps, _) => format!("H{x:.1}V{y:.1}"),
            _ => format!("L{x:.1} {y:.1}"),
        };
    }
    if !path.is_empty() {
        line(out, &path, style);
    }
    for place in style.signed(series.mark, points.len()) {
        style.draw_sign(out, points[place]);
    }
}
