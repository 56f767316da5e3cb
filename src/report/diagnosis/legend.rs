//! The legend of a heat map.

use super::markers::{ABSENT, HeatScale, LINE};
use super::texts::Texts;
use crate::num::{LinearRgb, Srgb8, viridis};
use crate::report::legend::{ColourScale, Key, Legend};
use crate::report::picture::Picture;

/// The marks that are drawn over the colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Marks {
    /// Lines along edges with two normals.
    pub(super) lines: bool,
    /// Dots on corners whose faces are too small to be seen.
    pub(super) dots: bool,
    /// Rings round worst positions.
    pub(super) rings: bool,
    /// Some worst positions are not visible, and have no ring.
    pub(super) hidden: bool,
}

impl Marks {
    pub(super) fn of_rings(self, texts: Texts) -> String {
        texts.get(match (self.rings, self.hidden) {
            (_, false) => "worst-seen",
            (true, true) => "worst-partly-hidden",
            (false, true) => "worst-hidden",
        })
    }
}

/// A picture with a legend of its colours and marks below it.
pub(super) fn with_legend(
    picture: &Picture,
    title: &str,
    (scale, marks): (HeatScale, Marks),
    texts: Texts,
) -> Picture {
    let keys = [
        (Key::Area(coded(LinearRgb::from(ABSENT))), texts.get("legend-absent"), scale.is_absent),
        (Key::Line(coded(LinearRgb::grey(LINE))), texts.get("legend-line"), marks.lines),
        (Key::Dot(coded(viridis(1.0))), texts.get("legend-dot"), marks.dots),
        (Key::Ring, marks.of_rings(texts), marks.rings || marks.hidden),
    ];
    let [full, half] = scale.labels(texts);
    let colours = (0..=64).map(|step| coded(viridis(f64::from(step) / 64.0))).collect();
    let labels = vec![(1.0, full), (0.0, "0°".into()), (0.5, half)];
    let legend = Legend {
        title: title.to_owned(),
        scales: scale.is_used.then_some(ColourScale { colours, labels }).into_iter().collect(),
        keys: keys.into_iter().filter(|key| key.2).map(|(key, words, _)| (key, words)).collect(),
    };
    legend.below(picture)
}

/// A colour as shares of the full code.
pub(super) fn coded(colour: LinearRgb) -> [f32; 3] {
    Srgb8::from(colour).0.map(|c| f32::from(c) / 255.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::Survey;
    use crate::text::Language;

    const ENGLISH: Texts = Texts(Language::English);

    /// The longest label, in pictures of few pixels and many, ends before the picture does, and lies on no other.
    #[test]
    fn labels_stay_inside() {
        let deviations: Vec<Option<f64>> =
            [vec![0.0; 400], vec![123.4]].concat().into_iter().map(Some).collect();
        let scale = HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        assert_eq!(scale.labels(ENGLISH)[0], "1° and more, up to 123°");
        for side in [240, 320, 480, 1024] {
            let sheet = with_legend(
                &Picture::filled([side; 2], false, [1.0; 3]),
                "",
                (scale, Marks::default()),
                ENGLISH,
            );
            let crate::raster::Pixels::Eight(pixels) = &sheet.pixels else { panic!("8 bits") };
            let at = |i: usize| i % side as usize;
            let ink = (0..pixels.len()).filter(|&i| pixels[i] != [255; 3]).map(at);
            let margin = side as usize / 32;
            assert!(ink.clone().min() >= Some(margin - 2), "{side}");
            assert!(ink.max() <= Some(side as usize - margin + 1), "{side}");
        }
    }

    #[test]
    fn legends_stand_below_the_picture_and_have_what_there_is() {
        let picture = Picture::filled([320, 320], false, [0.0; 3]);
        let scale =
            |deviations: Vec<Option<f64>>| HeatScale::of([Survey { deviations, ..Survey::default() }].iter());
        let height = |marks| with_legend(&picture, "", (scale(vec![Some(1.0)]), marks), ENGLISH).size[1];
        let plain = height(Marks::default());
        let all = Marks { lines: true, dots: true, rings: true, hidden: true };
        assert!(plain > 320 && height(all) > plain);
        let none = Marks::default();
        for one in [
            Marks { lines: true, ..none },
            Marks { dots: true, ..none },
            Marks { rings: true, ..none },
            Marks { hidden: true, ..none },
        ] {
            assert!(height(one) > plain, "{one:?}");
        }
        let sheet = with_legend(&picture, "", (scale(vec![Some(1.0), None]), all), ENGLISH);
        let crate::raster::Pixels::Eight(pixels) = &sheet.pixels else { panic!("8 bits") };
        assert!(pixels[..320 * 320].iter().all(|pixel| *pixel == [0; 3]), "nothing lies on the picture");
        for colour in [ABSENT.0, Srgb8::from(LinearRgb::grey(LINE)).0, Srgb8::from(viridis(1.0)).0] {
            assert!(pixels[320 * 320..].contains(&colour), "{colour:?}");
        }
    }
}
