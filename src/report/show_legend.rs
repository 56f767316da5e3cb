//! Legends of false colours: the quantity, its unit and its range.

use super::legend::{ColourScale, Key, Legend};
use crate::num::{Degrees, LinearRgb, Radians, three_digits};
use crate::raster::{RenderSettings, Samples, Scene, Shape, Show, depth_range, render};

/// The legend of what is shown in place of light; `None` for a picture of light.
///
/// The settings are those that the picture is drawn with: colours in the legend have the same codes as in the picture. No deviation
/// exceeds a range that `is_fitted` ([`deviation_range`]).
pub fn show_legend(scene: &Scene, settings: &RenderSettings, is_fitted: bool) -> Option<Legend> {
    let coded = |colour: LinearRgb| {
        colour.to_array().map(|light| settings.transfer.encode(light.clamp(0.0, 1.0)) as f32)
    };
    let scale = |colour: &dyn Fn(f64) -> LinearRgb, labels: Vec<(f64, String)>| ColourScale {
        colours: (0..=96).map(|step| coded(colour(f64::from(step) / 96.0))).collect(),
        labels,
    };
    let mut legend = Legend::default();
    match settings.show {
        Show::Shaded => return None,
        Show::Deviation(full) => {
            let has_truth = |wanted: bool| {
                let is_exact = |shape: &Shape| matches!(shape, Shape::Surface(_));
                scene.objects.iter().any(|it| (it.surface.is_some() || is_exact(&it.shape)) == wanted)
            };
            let other = match (has_truth(true), has_truth(false)) {
                (true, false) => "that of the analytic surface",
                (true, true) => "that of the analytic surface, or of the face if there is none",
                _ => "that of the face",
            };
            legend.title = format!("Angle between the interpolated normal and {other}, in degrees");
            let beyond = if is_fitted || full.0 >= 180.0 { "" } else { " and more" };
            let labels = [(0.0, 0.0, ""), (1.0, full.0, beyond), (0.5, 0.5 * full.0, "")]
                .map(|(share, angle, more)| (share, format!("{angle}°{more}")));
            legend.scales.push(scale(&|share| Show::deviation_colour(share), labels.to_vec()));
        }
        Show::Depth => {
            legend.title = "Distance from the camera along its axis, in units of the file".into();
            let [near, far] = depth_range(scene, settings).ok()?;
            let labels = [(0.0, near), (1.0, far), (0.5, 0.5 * (near + far))];
            let labels = labels.map(|(share, distance)| (share, three_digits(distance))).to_vec();
            legend.scales.push(scale(&|share| LinearRgb::grey(1.0 - share), labels));
        }
        Show::Normals => {
            legend.title = "Components of the unit normal (no unit), in the axes of the scene".into();
            for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
                let colour = |share: f64| {
                    let mut colour = [0.5; 3];
                    colour[axis] = share;
                    LinearRgb::from(colour)
                };
                let labels = vec![(0.5, format!("{name} = 0")), (0.0, "−1".into()), (1.0, "1".into())];
                legend.scales.push(scale(&colour, labels));
            }
        }
        Show::Facing => {
            legend.title =
                "Visible side of each face (no unit); darker where the surface is seen at a grazing angle"
                    .into();
            let keys = [(Show::FRONT, "front (counter-clockwise)"), (Show::BACK, "back")];
            legend.keys = keys.map(|(colour, words)| (Key::Area(coded(colour)), words.into())).to_vec();
        }
        Show::FaceId => {
            let faces: usize = scene.objects.iter().map(|object| object.shape.faces().count()).sum();
            let one = if faces == 1 { "face" } else { "faces" };
            legend.title = format!("Number of the face (no unit): a colour for each of {faces} {one}");
        }
    }
    Some(legend)
}

/// The angle at the end of a scale of deviations that holds all visible ones: 1°, 2°, 5°, 10°, … 180°.
///
/// It is measured at the centres of pixels.
pub fn deviation_range(
    scene: &Scene,
    settings: &RenderSettings,
) -> Result<Degrees, crate::raster::RenderError> {
    let largest = Degrees::from(Radians(std::f64::consts::PI));
    let black = Scene { background: LinearRgb::BLACK, lines: Vec::new(), ..scene.clone() };
    let settings = RenderSettings {
        show: Show::Deviation(largest),
        samples: Samples::One,
        keep_linear: true,
        ..*settings
    };
    let image = render(&black, &settings)?;
    // The inverse of the colours: their components add up to three times the share.
    let shares = image.linear.iter().flatten().map(|colour| f64::from(colour.iter().sum::<f32>()) / 3.0);
    let found = shares.fold(0.0, f64::max) * largest.0;
    // Some roundings of single precision are no reason for the next step.
    Ok(Degrees(super::diagnosis::end_above(found * (1.0 - 1e-5))))
}
