//! The elements of a plot as SVG.

use super::axis::Fitted;
use super::series::{Mark, Plot, Series, SeriesStyle, series_styles};
use crate::report::html::escape_html;
use crate::report::panel::text_width;
use std::fmt::Write;

/// Width of a drawing. At 390 pixels, on a telephone, its text of 12 has still 11.7.
pub(super) const WIDTH: f64 = 400.0;
/// How much larger a page shows it where there is room.
const ENLARGED: f64 = 1.4;
/// Height of the field.
pub(super) const HEIGHT: f64 = 220.0;
/// Margins on both sides of the field; the left one may be wider, for the numbers next to it.
pub(super) const LEFT: f64 = 40.0;
pub(super) const RIGHT: f64 = 14.0;
/// Gap on both sides of the numbers next to the field, and between those below it.
const FREE: f64 = 6.0;
/// From one line of text to the next, and the part of a line below its baseline.
const NEXT: f64 = 17.0;
const BELOW: f64 = 4.0;
/// The height of a line of 12 pixels in DejaVu Sans: no usual sans-serif font has wider letters. Titles are wider.
const LINE: f32 = 12.0 * 1.164;
const TITLE: f64 = 14.0 / 12.0 * 1.1;
/// The width of the sample before a name of the legend.
const SAMPLE: f64 = 34.0;

struct Field {
    left: f64,
    top: f64,
    width: f64,
    x: Fitted,
    y: Fitted,
}

impl Field {
    fn x(&self, x: f64) -> f64 {
        self.left + self.x.share(x) * self.width
    }

    fn y(&self, y: f64) -> f64 {
        self.top + (1.0 - self.y.share(y)) * HEIGHT
    }
}

pub(super) fn width_of(words: &str) -> f64 {
    f64::from(text_width(words, LINE))
}

impl Plot {
    /// The plot as an element of a page; the ids of its parts begin with the given one and a dot.
    pub fn svg(&self, id: &str) -> String {
        let styles = series_styles(&self.series);
        let [x, y] = self.fitted();
        let widest = y.ticks().iter().map(|(_, label)| width_of(label)).fold(0.0, f64::max);
        let left = f64::max(LEFT, (FREE + widest + FREE).ceil());
        let mut body = String::new();
        let mut below = 0.0;
        let bold = "font-weight=\"600\" font-size=\"14\"";
        lines(&mut body, &mut below, [RIGHT, TITLE], bold, &self.title);
        lines(&mut body, &mut below, [RIGHT, 1.0], "fill=\"#333\"", &self.y.label);
        let field = Field { left, top: below + 10.0, width: WIDTH - left - RIGHT, x, y };
        axes(self, &field, &mut body);
        let _ = writeln!(
            body,
            "<clipPath id=\"{id}.field\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>",
            left - 1.0,
            field.top - 1.0,
            field.width + 2.0,
            HEIGHT + 2.0
        );
        let _ = writeln!(body, "<g clip-path=\"url(#{id}.field)\">");
        // Measured series are drawn over guides.
        let (guides, measured): (Vec<_>, Vec<_>) =
            self.series.iter().zip(&styles).partition(|(series, _)| series.mark == Mark::Guide);
        for (series, style) in guides.into_iter().chain(measured) {
            draw_series(self, series, style, &field, &mut body);
        }
        body.push_str("</g>\n");
        below = field.top + HEIGHT + NEXT;
        lines(&mut body, &mut below, [left, 1.0], "fill=\"#333\"", &self.x.label);
        legend(self, &styles, &mut below, &mut body);
        let height = (below + 10.0).ceil();
        let (title, description) = (escape_html(&self.title), escape_html(&self.description));
        format!(
            "<svg role=\"img\" aria-labelledby=\"{id}.title {id}.desc\" viewBox=\"0 0 {WIDTH} {height}\" \
             width=\"{:.0}\" height=\"{:.0}\">\n<title id=\"{id}.title\">{title}</title>\n\
             <desc id=\"{id}.desc\">{description}</desc>\n<rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n\
             {body}</svg>",
            WIDTH * ENLARGED,
            height * ENLARGED
        )
    }

    /// The axes, fitted to all points.
    pub(super) fn fitted(&self) -> [Fitted; 2] {
        let taken =
            |axis: usize| self.series.iter().flat_map(|it| kept(self, it)).map(move |point| point[axis]);
        [self.x.fit(taken(0)), self.y.fit(taken(1))]
    }

    /// A number along an axis with the plot's decimal mark.
    pub(super) fn written(&self, number: String) -> String {
        match self.language.decimal_mark() {
            '.' => number,
            mark => number.replace('.', &mark.to_string()),
        }
    }
}

/// Text below what there is, from some x on, in as many lines as it needs; letters are wider by a factor.
fn lines(out: &mut String, below: &mut f64, [left, wider]: [f64; 2], more: &str, words: &str) {
    let room = WIDTH - left - RIGHT;
    let mut line = String::new();
    let mut put = |line: &str| {
        *below += NEXT;
        text(out, [left, *below], "start", more, line);
    };
    for word in words.split_whitespace() {
        let longer = format!("{line} {word}");
        if !line.is_empty() && wider * width_of(&longer) > room {
            put(&line);
            line = word.to_owned();
        } else {
            line = longer.trim_start().to_owned();
        }
    }
    if !line.is_empty() {
        put(&line);
    }
}

/// The points of a series that are on the axes.
pub(super) fn kept<'a>(plot: &'a Plot, series: &'a Series) -> impl Iterator<Item = [f64; 2]> + 'a {
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

/// The names of series below the plot, in as many columns as fit.
fn legend(plot: &Plot, styles: &[SeriesStyle], below: &mut f64, out: &mut String) {
    let named: Vec<_> =
        plot.series.iter().zip(styles).filter(|(series, _)| !series.name.is_empty()).collect();
    let widest = named.iter().map(|(series, _)| width_of(&series.name)).fold(0.0, f64::max);
    let columns = ((WIDTH - 2.0 * RIGHT + FREE) / (SAMPLE + widest + FREE)).max(1.0) as usize;
    let rows = named.len().div_ceil(columns);
    *below += if rows > 0 { FREE } else { 0.0 };
    for (number, (series, style)) in named.into_iter().enumerate() {
        let left = RIGHT + (number / rows) as f64 * (WIDTH - 2.0 * RIGHT) / columns as f64;
        let y = *below + (number % rows + 1) as f64 * NEXT - BELOW;
        if !matches!(series.mark, Mark::Points | Mark::Hollow) {
            line(out, &format!("M{left:.1} {y:.1}h26"), style);
        }
        style.draw_sign(out, [left + 13.0, y]);
        text(out, [left + SAMPLE, y + BELOW], "start", "", &series.name);
    }
    *below += rows as f64 * NEXT;
}

fn axes(plot: &Plot, field: &Field, out: &mut String) {
    let (right, bottom) = (field.left + field.width, field.top + HEIGHT);
    let mut lines = String::new();
    let mut taken = 0.0;
    for (at, label) in field.x.ticks() {
        let x = field.x(at);
        let _ = write!(lines, "M{x:.1} {:.1}V{bottom:.1}", field.top);
        let label = plot.written(label);
        let half = 0.5 * width_of(&label);
        // A number that has no room is not written.
        if x - half >= taken && x + half <= WIDTH {
            text(out, [x, bottom + NEXT], "middle", "", &label);
            taken = x + half + FREE;
        }
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
}

fn draw_series(plot: &Plot, series: &Series, style: &SeriesStyle, field: &Field, out: &mut String) {
    let points: Vec<[f64; 2]> = kept(plot, series).map(|[x, y]| [field.x(x), field.y(y)]).collect();
    let mut path = String::new();
    for (place, &[x, y]) in points.iter().enumerate() {
        path += &match (series.mark, place) {
            (Mark::Points | Mark::Hollow, _) => String::new(),
            (Mark::Steps, 0) => format!("M{x:.1} {:.1}V{y:.1}", field.top + HEIGHT),
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
