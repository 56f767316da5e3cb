//! What the signs and lines of a plot stand for.

use super::draw::{Look, sign, text};
use super::{Mark, Plot};
use std::fmt::Write;

/// Height of a line, and width of a letter and of what stands before the name, in pixels.
const LINE: f64 = 18.0;
const LETTER: f64 = 6.6;
const SAMPLE: f64 = 34.0;

/// The legend, and how wide it is: nothing where no series has a name.
pub(super) fn legend(plot: &Plot) -> (String, f64) {
    let named = || plot.series.iter().enumerate().filter(|(_, series)| !series.name.is_empty());
    let longest = named().map(|(_, series)| series.name.chars().count()).max();
    let Some(longest) = longest else { return (String::new(), 0.0) };
    let mut out = String::new();
    for (line, (place, series)) in named().enumerate() {
        let y = 8.0 + line as f64 * LINE;
        let look = Look::of(series, place);
        if series.mark != Mark::Points {
            let (colour, dash) = (look.colour, look.dash);
            let _ = writeln!(
                out,
                "<path d=\"M0 {y:.1}H26\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.6\" stroke-dasharray=\"{dash}\"/>"
            );
        }
        if matches!(series.mark, Mark::Points | Mark::Line) {
            sign(&mut out, [13.0, y], &look);
        }
        text(&mut out, [SAMPLE, y + 4.0], "start", "", &series.name);
    }
    (out, SAMPLE + LETTER * longest as f64 + 8.0)
}
