//! What the signs and lines of a plot stand for.

use super::draw::{text, width_of};
use super::look::Look;
use super::{Mark, Plot};
use std::fmt::Write;

/// Height of a line, and width of what stands before the name, in pixels.
const LINE: f64 = 18.0;
const SAMPLE: f64 = 34.0;

/// The legend, and how wide it is: nothing where no series has a name.
pub(super) fn legend(plot: &Plot, looks: &[Look]) -> (String, f64) {
    let named = || plot.series.iter().zip(looks).filter(|(series, _)| !series.name.is_empty());
    let widest = named().map(|(series, _)| width_of(&series.name)).fold(0.0, f64::max);
    if widest == 0.0 {
        return (String::new(), 0.0);
    }
    let mut out = String::new();
    for (line, (series, look)) in named().enumerate() {
        let y = 8.0 + line as f64 * LINE;
        if series.mark != Mark::Points {
            let (colour, dash) = (look.colour, look.dash);
            let _ = writeln!(
                out,
                "<path d=\"M0 {y:.1}H26\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.6\" stroke-dasharray=\"{dash}\"/>"
            );
        }
        look.draw_sign(&mut out, [13.0, y]);
        text(&mut out, [SAMPLE, y + 4.0], "start", "", &series.name);
    }
    (out, SAMPLE + widest + 8.0)
}
