//! The polygon in its positions, and its centre over a whole turn.

use super::super::stage::{differences, linear, map, picture};
use super::super::{Chart, Curve, Drawn, Moved, Scale, Shot, Text, Threshold};
use super::texts::TEXTS;
use crate::raster::Image;
use glam::DVec3;

/// The upper half of a picture above the lower half of another of the same size: where both show the same, there is no seam.
fn halves(upper: &Image, lower: &Image) -> Image {
    let [width, height] = upper.size;
    let middle = (width * (height / 2)) as usize;
    let colours = [&linear(upper)[..middle], &linear(lower)[middle..]].concat();
    let coverage = [&upper.coverage[..middle], &lower.coverage[middle..]].concat();
    picture(upper.size, colours, coverage)
}

/// What is to be said of a special case (the lectures' diamond), or of any polygon.
fn either(is_special: bool, special: Text, any: Text) -> Text {
    if is_special { special } else { any }
}

/// The pictures of what was drawn under scanlines (unturned, turned by 45° and 90°, and turned back), under triangles turned
/// back, and cut one way and the other, which are the same where it has one cut only: then they have no difference to show.
pub(super) fn shots(
    [upright, half, turned, back]: [Image; 4],
    triangles_back: &Image,
    [one, other]: [Image; 2],
    has_one_cut: bool,
    is_diamond: bool,
    moved: &Moved,
) -> Vec<Shot> {
    let captioned = |diamond, any| either(is_diamond, diamond, any);
    let largest = |a: &Image, b: &Image| differences(a, b).into_iter().flatten().fold(0.0, f64::max);
    let seam = Moved {
        name: TEXTS.get("moved-largest-change-pixel"),
        bad: largest(&upright, &back),
        cured: largest(&one, triangles_back),
        factor: 10.0,
        ..moved.clone()
    };
    let difference = map(upright.size, &differences(&upright, &back), 0.4);
    let between = map(upright.size, &differences(&one, &other), 0.4);
    let cuts_differ = largest(&one, &other) > Threshold::HALF_STEP.value;
    let same_however_turned = || TEXTS.get("same-colours-however");
    let but_not_the_other = match cuts_differ {
        true => TEXTS.get("also-same-however"),
        false => same_however_turned(),
    };
    let mut shots = vec![
        seam.bad_shot(
            "halves",
            TEXTS.get("halves-title"),
            [
                captioned(
                    TEXTS.get("halves-caption-above-diamond-stands"),
                    TEXTS.get("halves-caption-above-polygon-stands"),
                ),
                TEXTS.get("halves-caption-colours-own-would"),
            ],
            halves(&upright, &back),
        ),
        seam.cured_shot(
            "halves-triangles",
            TEXTS.get("halves-triangles-title"),
            [
                TEXTS.get("halves-triangles-caption-same-triangles"),
                TEXTS.get("halves-triangles-caption-no-seam"),
            ],
            halves(&one, triangles_back),
        ),
        moved.bad_shot(
            "position-1",
            TEXTS.get("position-1-title"),
            [
                captioned(
                    TEXTS.get("position-1-caption-position-scanline-through"),
                    TEXTS.get("position-1-caption-stands-every-pixel"),
                ),
                TEXTS.get("position-1-caption-turned-other-colours"),
            ],
            upright,
        ),
        moved.bad_shot(
            "turned-45",
            TEXTS.get("turned-45-title"),
            [
                captioned(
                    TEXTS.get("turned-45-caption-eighth-turn-scanline"),
                    TEXTS.get("turned-45-caption-eighth-turn-scanlines"),
                ),
                TEXTS.get("turned-45-caption-colours-change-turn"),
            ],
            half,
        ),
        moved.bad_shot(
            "position-2",
            TEXTS.get("position-2-title"),
            [
                captioned(
                    TEXTS.get("position-2-caption-position-scanline-runs"),
                    TEXTS.get("position-2-caption-quarter-turn-scanlines"),
                ),
                TEXTS.get("position-2-caption-same-polygon-other"),
            ],
            turned,
        ),
        Shot::difference(
            "difference",
            TEXTS.get("difference-title"),
            captioned(
                TEXTS.get("difference-caption-position-turned-back"),
                TEXTS.get("difference-caption-drawn-turned-turned"),
            ),
            difference,
        ),
        moved.cured_shot(
            "diagonal-13",
            captioned(TEXTS.get("diagonal-13-title"), TEXTS.get("diagonal-13-caption-triangles-cut-way")),
            [
                captioned(
                    TEXTS.get("diagonal-13-caption-cut-corner-corner"),
                    TEXTS.get("diagonal-13-caption-cut-way"),
                ),
                same_however_turned(),
            ],
            one,
        ),
        moved.cured_shot(
            "diagonal-24",
            captioned(
                TEXTS.get("diagonal-24-title"),
                either(
                    has_one_cut,
                    TEXTS.get("diagonal-24-caption-triangles-same-cut"),
                    TEXTS.get("diagonal-24-caption-triangles-cut-another"),
                ),
            ),
            [
                captioned(
                    TEXTS.get("diagonal-24-caption-cut-corner-corner"),
                    either(
                        has_one_cut,
                        TEXTS.get("diagonal-24-caption-no-other-cut"),
                        TEXTS.get("diagonal-24-caption-cut-another-way"),
                    ),
                ),
                but_not_the_other,
            ],
            other,
        ),
    ];
    if !has_one_cut {
        shots.push(Shot::difference(
            "diagonals",
            captioned(TEXTS.get("diagonals-title"), TEXTS.get("diagonals-caption-difference-cuts")),
            captioned(
                TEXTS.get("diagonals-caption-diagonal-less-other"),
                TEXTS.get("diagonals-caption-cut-less-other"),
            ),
            between,
        ));
    }
    shots
}

pub(super) fn chart(scanline: &[DVec3], laws: &[DVec3], triangles: &[DVec3], moved: &Moved) -> Chart {
    let angle = |turn: usize| 360.0 * turn as f64 / scanline.len() as f64;
    let curve = |name, drawn, colours: &[DVec3], axis: usize| Curve {
        name,
        drawn,
        points: colours.iter().enumerate().map(|(turn, colour)| [angle(turn), colour[axis]]).collect(),
    };
    let mut curves = vec![
        curve(TEXTS.get("r-scanline"), Drawn::Points, scanline, 0),
        curve(TEXTS.get("g-scanline"), Drawn::Points, scanline, 1),
        curve(TEXTS.get("b-scanline"), Drawn::Points, scanline, 2),
        curve(TEXTS.get("g-triangles"), Drawn::Curve, triangles, 1),
    ];
    let names = [TEXTS.get("r-law"), TEXTS.get("g-law"), TEXTS.get("b-law")];
    curves.extend(names.into_iter().enumerate().map(|(axis, name)| curve(name, Drawn::Guide, laws, axis)));
    Chart {
        name: "centre",
        title: TEXTS.get("chart-title"),
        caption: TEXTS.with("chart-caption", &[("bad", moved.bad.into()), ("cured", moved.cured.into())]),
        x: Scale::linear(TEXTS.get("axis-turned-degrees")),
        y: Scale::linear(TEXTS.get("axis-linear-component")),
        curves,
    }
}

#[cfg(test)]
mod tests {
    use super::super::EXPERIMENT;
    use crate::artefact::stage::luminance;
    use crate::artefact::{Parameters, Setup};

    /// The seam's height at the centre: the colours of the exercise's two positions against none.
    #[test]
    fn halves_fit_only_in_triangles() {
        let parameters = Parameters { size: 129, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        let seam = |name: &str| {
            let image = &outcome.shots.iter().find(|shot| shot.name == name).unwrap().image;
            let at = |y| luminance(image)[image.index(64, y).unwrap()];
            (at(63) - at(64)).abs()
        };
        // (0.1, 0.5, 0.5) and (0.2, 0.3, 0.1) as luminances, and what changes from a row to the next.
        let [one, two] =
            [[0.1, 0.5, 0.5], [0.2, 0.3, 0.1]].map(|[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b);
        let row = 2.0 * 0.6 / 112.0;
        let [scanline, triangles] = ["halves", "halves-triangles"].map(seam);
        assert!((scanline - (one - two)).abs() < row && triangles < row, "{scanline} {triangles}");
    }
}
