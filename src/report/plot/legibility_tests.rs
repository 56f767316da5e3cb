//! Assertions for tests of all plots: no text overlaps another, signs are inside, and series differ without colour.

use super::draw::{HEIGHT, LEFT, RIGHT, WIDTH, kept, width_of};
use super::series::{Mark, Plot, SIGN, series_styles};
use std::collections::BTreeSet;

/// A text and its ends: left, top, right, bottom.
type Words = (String, [f64; 4]);

/// Where the texts of a drawing are, by the widths of letters that it was laid out for.
fn texts(svg: &str) -> Vec<Words> {
    let number = |text: &str| -> f64 { text.parse().unwrap() };
    let mut moved = [0.0; 2];
    let mut found = Vec::new();
    for element in svg.split('<') {
        let value = |name: &str| {
            let rest = element.split_once(&format!(" {name}=\""))?.1;
            rest.split_once('"').map(|(value, _)| value)
        };
        if let Some(place) = value("transform").and_then(|to| to.strip_prefix("translate(")) {
            let place: Vec<f64> = place.trim_end_matches(')').split(' ').map(number).collect();
            moved = [place[0], place[1]];
        } else if element.starts_with("/g>") {
            moved = [0.0; 2];
        } else if element.starts_with("text ") {
            let words = element.split_once('>').unwrap().1;
            let [x, y] = ["x", "y"].map(|name| number(value(name).unwrap()));
            let size = value("font-size").map_or(1.0, |size| number(size) / 12.0);
            let width = width_of(words) * size;
            let before = match value("text-anchor").unwrap() {
                "start" => 0.0,
                "middle" => 0.5 * width,
                _ => width,
            };
            // Capitals are 0.73 of the size high, descenders 0.24 deep.
            let (above, below) = (8.8 * size, 2.9 * size);
            let ends = match value("transform") {
                Some(_) => [x - above, y - before, x + below, y - before + width],
                None => [x - before, y - above, x - before + width, y + below],
            };
            let [right, down] = moved;
            found
                .push((words.to_owned(), [ends[0] + right, ends[1] + down, ends[2] + right, ends[3] + down]));
        }
    }
    found
}

impl Plot {
    /// Asserts that every text lies within the plot and none over another, that signs of measured points lie within the field,
    /// and that no two series have both dash and sign in common.
    pub(in crate::report) fn assert_legible(&self) {
        let svg = self.svg("plot");
        let texts = texts(&svg);
        let size = svg.split_once("viewBox=\"0 0 ").and_then(|(_, rest)| rest.split_once('"')).unwrap().0;
        let (width, height) = size.split_once(' ').unwrap();
        let [width, height]: [f64; 2] = [width, height].map(|length| length.parse().unwrap());
        for (place, (words, [left, top, right, bottom])) in texts.iter().enumerate() {
            let is_inside = *left >= 0.0 && *top >= 0.0 && *right <= width && *bottom <= height;
            assert!(is_inside, "{}: {words} leaves the plot", self.title);
            for (other, [from_left, from_top, to_right, to_bottom]) in &texts[..place] {
                let apart = left >= to_right || from_left >= right || top >= to_bottom || from_top >= bottom;
                assert!(apart, "{}: {words} lies over {other}", self.title);
            }
        }
        let [x, y] = self.fitted();
        // The left margin may be wider.
        let (across, up) = (SIGN / (0.8 * (WIDTH - LEFT - RIGHT)), SIGN / HEIGHT);
        for series in
            self.series.iter().filter(|it| matches!(it.mark, Mark::Points | Mark::Hollow | Mark::Line))
        {
            for [at, high] in kept(self, series) {
                let is_inside = (across..=1.0 - across).contains(&x.share(at))
                    && (up..=1.0 - up).contains(&y.share(high));
                assert!(is_inside, "{}: the sign at {at}, {high} leaves the field", self.title);
            }
        }
        let styles = series_styles(&self.series);
        let in_grey = styles.iter().zip(&self.series).map(|(style, series)| style.in_grey(series.mark));
        let different: BTreeSet<_> = in_grey.collect();
        assert_eq!(different.len(), self.series.len(), "{}: series look alike in grey", self.title);
    }
}
