//! The contrast of wireframes with the background.

use super::request::is_solid;
use crease::num::{LinearRgb, Srgb8, Transfer};
use crease::raster::{RenderSettings, SceneFile, Shading, Show};

/// The contrast that graphics need with what surrounds them: WCAG 2.1, success criterion 1.4.11.
const LEAST_CONTRAST: f64 = 3.0;

pub fn faint_wireframe(file: &SceneFile, panels: &[RenderSettings]) -> Option<String> {
    let (wire, background, transfer) = (file.settings.wire.colour, file.background, file.settings.transfer);
    let is_drawn = file.settings.show == Show::Shaded
        && panels.iter().any(|panel| panel.shading == Shading::Wireframe)
        && !file.objects.iter().all(is_solid);
    let found = contrast(wire, background, transfer);
    if !is_drawn || found >= LEAST_CONTRAST {
        return None;
    }
    // Rounded down, so that it is below the limit.
    let reported = (found * 100.0).floor() / 100.0;
    let what = match code(wire, transfer) == code(background, transfer) {
        true => "has the colour of the background".into(),
        false => format!(
            "is hardly visible on the background: contrast {reported:.2}:1 (WCAG 2.1 requires {LEAST_CONTRAST}:1)"
        ),
    };
    Some(format!("the wireframe {what}; choose another --background"))
}

/// The contrast ratio (Y₁ + 0.05)/(Y₂ + 0.05) of the lighter to the darker of two colours, as WCAG 2.1 defines it: 1 of the
/// same luminance, 21 of black and white. Luminances are those that a screen shows for the codes, which it takes for sRGB.
pub fn contrast(a: LinearRgb, b: LinearRgb, transfer: Transfer) -> f64 {
    let luminance = |colour| LinearRgb::from(code(colour, transfer)).luminance() + 0.05;
    let (a, b) = (luminance(a), luminance(b));
    a.max(b) / a.min(b)
}

fn code(colour: LinearRgb, transfer: Transfer) -> Srgb8 {
    Srgb8(colour.to_array().map(|light| transfer.to_u8(light)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contrast_is_that_of_the_codes_on_a_screen() {
        let (black, white) = (LinearRgb::BLACK, LinearRgb::WHITE);
        for transfer in [Transfer::Srgb, Transfer::Direct] {
            assert_eq!(contrast(white, black, transfer), 21.0);
            assert_eq!(contrast(white, white, transfer), 1.0);
        }
        // #767676, the darkest grey that is known for 4.54:1 on white.
        let grey = LinearRgb::from(Srgb8([0x76; 3]));
        assert!((contrast(white, grey, Transfer::Srgb) - 4.54).abs() < 0.005);
        // Light of 0.3 is code 77 if it is written as it is, of luminance 0.0742, and not 149.
        assert!((contrast(white, LinearRgb::grey(0.3), Transfer::Direct) - 1.05 / 0.1242).abs() < 0.01);
        assert!((contrast(LinearRgb::grey(0.3), white, Transfer::Srgb) - 3.0).abs() < 0.02);
    }
}
