//! How much longer than wide a highlight is on the sphere.

use super::super::stage::linear;
use super::super::{Measure, Text};
use super::{GRAZING, WINDOW};
use crate::num::{Degrees, Radians};
use crate::raster::Image;

/// Half the width of a highlight at half height, as angles on the sphere: in the plane of light and view, towards the viewer, and
/// across it.
#[derive(Clone, Copy, Debug)]
pub(super) struct HalfWidths {
    along: f64,
    across: f64,
}

/// Phong's: along, cos(2t) = q; across, 2 cos²(t) cos²(β/2) − cos β = q; q = 2^(−1/n).
pub(super) fn of_phong(exponent: f64) -> HalfWidths {
    let beta = Radians::from(GRAZING).0;
    let q = libm::pow(2.0, -1.0 / exponent);
    let half = libm::cos(0.5 * beta);
    HalfWidths {
        along: 0.5 * libm::acos(q),
        across: libm::acos(((q + libm::cos(beta)).max(0.0) / (2.0 * half * half)).sqrt()),
    }
}

/// Blinn's, which is round: cos t = 2^(−1/n).
pub(super) fn of_blinn(exponent: f64) -> HalfWidths {
    let angle = libm::acos(libm::pow(2.0, -1.0 / exponent));
    HalfWidths { along: angle, across: angle }
}

/// Light and viewer in front: how far the normal is from them, in degrees, where Blinn's highlight and Phong's are at half height.
pub(super) fn in_front(exponent: f64) -> [f64; 2] {
    let blinn = Degrees::from(Radians(of_blinn(exponent).along)).0;
    [blinn, 0.5 * blinn]
}

/// The width across the plane of light and view over that along it, against the closed form.
pub(super) fn measure(name: Text, image: &Image, law: HalfWidths, by: Text) -> Measure {
    let measure = Measure::new(name, "", found(image));
    let beta = Radians::from(GRAZING).0;
    // The highlight stands at β/2, where the picture shows cos(β/2) of its length.
    let pixels = law.along * libm::cos(0.5 * beta) * f64::from(image.size[0]) / WINDOW;
    if law.along >= std::f64::consts::FRAC_PI_2 - 0.5 * beta || law.across > 1.0 {
        return measure.beyond(Text::new(
            "the highlight is as wide as the part of the sphere that is lit and seen",
            "o brilho é tão largo quanto a parte iluminada e visível da esfera",
        ));
    }
    if pixels < 1.5 {
        return measure.beyond(Text::new(
            "the highlight is narrower than three pixels",
            "o brilho é mais estreito que três pixels",
        ));
    }
    // Heights between pixel centres are taken from straight lines, which cut a bell of the half-width w off by 0.05/w² of it along
    // and 0.13/w² across.
    let ratio = law.across / law.along;
    let by = Text::each(|language| {
        let cut = Text::new("straight lines between pixel centres", "retas entre centros de pixels");
        format!("{}; {}", by.get(language), cut.get(language))
    });
    measure.expect(ratio, ratio * (0.3 / (pixels * pixels) + 1e-3), by)
}

fn found(image: &Image) -> f64 {
    let (sine, cosine) = libm::sincos(0.5 * Radians::from(GRAZING).0);
    let size = f64::from(image.size[0]);
    let values = linear(image);
    // Between pixel centres, linearly.
    let at = |x: f64, y: f64| {
        let [x, y] = [x, -y].map(|c| (c / WINDOW + 0.5) * size - 0.5);
        let value = |dx: f64, dy: f64| {
            let index = image.index((x.floor() + dx) as u32, (y.floor() + dy) as u32);
            index.map_or(0.0, |i| f64::from(values[i][0]))
        };
        let (s, t) = (x - x.floor(), y - y.floor());
        (value(0.0, 0.0) * (1.0 - s) + value(1.0, 0.0) * s) * (1.0 - t)
            + (value(0.0, 1.0) * (1.0 - s) + value(1.0, 1.0) * s) * t
    };
    // The angle at which half height is reached, by halving.
    let half = |value: &dyn Fn(f64) -> f64| {
        let (mut low, mut high) = (0.0, std::f64::consts::FRAC_PI_2);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if value(middle) > 0.5 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    // Towards the viewer, where the sphere is seen less from the side.
    let along = half(&|t| at(sine * libm::cos(t) - cosine * libm::sin(t), 0.0));
    let across = half(&|t| at(sine * libm::cos(t), libm::sin(t)));
    across / along
}
