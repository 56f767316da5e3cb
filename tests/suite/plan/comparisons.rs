//! Other comparisons of pictures: by ꟻLIP, under turned lights, with fewer samples, and within a time.

use super::{change, drawn, only, planned, scene};
use crease::metric::{FLIP_PIXELS_PER_DEGREE, flip};
use crease::num::Degrees;
use crease::plan::{Axis, Metric, PlanOptions, plan_with_evidence};
use crease::raster::{Image, LoadOptions, SceneFile};
use crease::shade::Light;
use glam::DQuat;
use std::f64::consts::PI;
use std::path::Path;

/// A square that a sun lights from the front, and another one from behind: no light of it arrives.
const SQUARE: &str = "[settings]\nsize = [32, 32]\nsamples = 16\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 2\n\
    [[light.directional]]\ntowards = [0, 0, 1]\ncolour = 0.2\n[[light.directional]]\ntowards = [0, 0.5, -1]\ncolour = 0.3\n\
    [[object]]\npolygons = { vertices = [[-0.75, -0.75, 0], [0.75, -0.75, 0], [0.75, 0.75, 0], [-0.75, 0.75, 0]], \
    faces = [[0, 1, 2, 3]] }\nmaterial = { colour = 1, ambient = 0, diffuse = 0.8, specular = 0 }\n";

/// The first of two balls is in the dark: its cells are refused for its outline alone, and the page looks at that, not at the lit ball.
#[test]
fn a_step_that_its_outline_refuses_is_shown_there() {
    let ball = |x: f64, material: &str| {
        format!(
            "[[object]]\nsurface = {{ sphere = {{ radius = 1 }} }}\ntessellation = {{ segments = [16, 8] }}\n\
             transform = [{{ translate = [{x:?}, 0, 0] }}]\nmaterial = {material}\n"
        )
    };
    let text = format!(
        "[settings]\nsize = [120, 60]\nbackground = 0.2\n[camera]\neye = [0, 0, 9]\ntarget = [0, 0, 0]\nheight = 3\n\
         [[light.directional]]\ntowards = [1, 1, 1]\n{}{}",
        ball(-1.5, "{ colour = 0, specular = 0 }"),
        ball(1.5, "{ colour = 1 }")
    );
    let options = PlanOptions { outline: 0.1, ..only(&[Axis::Tessellation, Axis::Interpolation], 20.0) };
    let (plan, evidence) =
        plan_with_evidence(&text, Path::new(""), &LoadOptions::default(), &options, &|_| ()).unwrap();
    let refused =
        evidence.refused.iter().find(|step| step.what == "object 0" && step.axis == Axis::Tessellation);
    let shown = &refused.unwrap_or_else(|| panic!("{:?}", plan.decisions)).comparison;
    assert!(shown.outline > 0.1 && shown.worst.steps <= 20.0);
    let [x, y] = shown.pixel;
    let object = |picture: &Image| picture.objects.as_ref().unwrap()[picture.index(x, y).unwrap()];
    // The first ball is in the left half. The reference shows it here, the coarser one does not.
    assert!(x < 60 && object(&shown.reference) != object(&shown.other), "{:?}", shown.pixel);
}

/// Turned by an angle c around the x-axis, the rear light has the direction (0, 0.5 cos c + sin c, 0.5 sin c − cos c): it arrives
/// when tan c > 2, beyond 63.4°.
#[test]
fn turned_lights_are_kept_where_they_arrive() {
    for (cone, is_kept) in [(0.0, false), (62.0, false), (80.0, true)] {
        let options = PlanOptions { light_cone: Degrees(cone), ..only(&[Axis::Lights], 2.0) };
        let plan = planned(SQUARE, &options);
        assert_eq!(change(&plan, Axis::Lights).is_none(), is_kept, "{cone}: {:?}", plan.decisions);
        assert_eq!(plan.held_out.is_some(), cone > 0.0);
        assert_eq!(plan.views, if cone > 0.0 { 13 } else { 1 });
    }
}

/// Under lights that are turned here, without `plan`, the planned scene differs by no more than the tolerance.
#[test]
fn plans_hold_under_turned_lights() {
    let text = "[settings]\nsize = [40, 40]\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 3\n\
        [[light.point]]\nposition = [30, 20, 25]\n[[light.ambient]]\ncolour = 0.2\n\
        [[object]]\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [24, 16] }\n";
    let options =
        PlanOptions { light_cone: Degrees(30.0), ..only(&[Axis::Lights, Axis::Shading, Axis::Storage], 2.0) };
    let plan = planned(text, &options);
    assert!(plan.held_out.is_some_and(|held_out| held_out.steps <= 2.0), "{:?}", plan.held_out);
    let (before, after) = (scene(text), scene(&plan.text));
    for axis in [glam::DVec3::X, glam::DVec3::NEG_Y, glam::DVec3::Z] {
        let turn = DQuat::from_axis_angle(axis, 30.0_f64.to_radians());
        let steps = super::steps(&turned(&before, turn), &turned(&after, turn));
        assert!(steps <= 2.0, "{axis}: {steps}");
    }
}

/// A sun 15° off the axis of a mirror-like square has its highlight only when it is turned by half of a cone of 30°. So the
/// highlight stays, although turns by the whole cone do not show it.
#[test]
fn highlights_within_the_cone_stay() {
    let sun = format!("towards = [0, {}, {}]", libm::sin(PI / 12.0), libm::cos(PI / 12.0));
    let shiny = SQUARE
        .replace("towards = [0, 0, 1]", &sun)
        .replace("specular = 0", "specular = 0.5, exponent = 2000, reflection = \"blinn\"");
    for (cone, expected) in [(0.0, Some("diffuse")), (30.0, None)] {
        let keep = Axis::ALL.into_iter().filter(|axis| *axis != Axis::Reflection).collect();
        let options = PlanOptions { light_cone: Degrees(cone), keep, ..PlanOptions::default() };
        let plan = planned(&shiny, &options);
        assert_eq!(change(&plan, Axis::Reflection), expected, "{cone}: {:?}", plan.decisions);
    }
}

/// The scene with point and directional lights turned around the origin.
fn turned(file: &SceneFile, turn: DQuat) -> SceneFile {
    let mut file = file.clone();
    for light in file.lights.iter_mut().flatten() {
        match light {
            Light::Directional { towards, .. } => *towards = turn * *towards,
            Light::Point { position, .. } => *position = turn * *position,
            _ => {}
        }
    }
    file
}

/// A square that fills the picture has the same colour with one sample as with sixteen. One that does not has an outline that moves by less
/// than half a pixel.
#[test]
fn samples_of_a_pixel_stay_unless_they_are_allowed() {
    let full = SQUARE.replace("height = 2", "height = 1.4");
    let kept = planned(&full, &only(&[], 2.0));
    assert_eq!(change(&kept, Axis::Antialiasing), None);
    let options = PlanOptions { allow_antialiasing: true, ..only(&[], 2.0) };
    let plan = planned(&full, &options);
    assert_eq!(change(&plan, Axis::Antialiasing), Some("1"));
    assert_eq!(scene(&plan.text).settings.samples.count(), 1);
    assert_eq!((plan.worst.steps, plan.outline), (0.0, 0.0));
    // Phong shading costs the same for each sample.
    assert!(plan.planned.work < plan.declared.work / 10, "{:?} {:?}", plan.declared, plan.planned);
    // Half of a sample's distance is beyond a limit of 0.01 pixels, but not of one pixel.
    let tilted = SQUARE.replace(
        "faces = [[0, 1, 2, 3]] }",
        "faces = [[0, 1, 2, 3]] }\ntransform = [{ rotate = [0, 0, 20] }]",
    );
    for (outline, expected) in [(0.01, None), (1.0, Some("1"))] {
        let plan = planned(&tilted, &PlanOptions { outline, ..options.clone() });
        assert_eq!(change(&plan, Axis::Antialiasing), expected, "{outline}: {:?}", plan.outline);
        assert!(plan.outline <= outline);
    }
}

/// The mean of ꟻLIP between two scenes, without `plan`.
fn mean_flip(a: &SceneFile, b: &SceneFile) -> f64 {
    flip(&drawn(b), &drawn(a), FLIP_PIXELS_PER_DEGREE).unwrap().mean
}

/// Each shading of a ball in turn: the plan has the cheapest one whose ꟻLIP is within the tolerance.
#[test]
fn flip_decides_by_the_whole_picture() {
    let text = "[settings]\nsize = [48, 48]\ntransfer = \"srgb\"\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 3\n\
        [[light.directional]]\ntowards = [1, 1, 1]\n[[object]]\nsurface = { sphere = { radius = 1 } }\n\
        tessellation = { segments = [24, 16] }\nmaterial = { specular = 0 }\nshading = \"phong\"\n";
    let declared = scene(text);
    let value = |shading: &str| mean_flip(&declared, &scene(&text.replace("phong", shading)));
    let (gouraud, flat) = (value("gouraud"), value("flat"));
    // The eye blurs facets of two pixels, which are too light and too dark in turn. Gouraud shading is darker everywhere.
    assert!(0.0 < flat && flat < gouraud, "{gouraud} {flat}");
    for tolerance in [0.5 * flat, 1.01 * flat, 1.01 * gouraud] {
        let options = PlanOptions { metric: Metric::Flip, tolerance, ..only(&[Axis::Shading], tolerance) };
        let plan = planned(text, &options);
        let found = mean_flip(&declared, &scene(&plan.text));
        assert!(found <= tolerance, "{found} {tolerance}");
        assert_eq!(plan.worst.flip.unwrap_or(0.0), found);
        let allowed: Vec<&str> = ["Gouraud", "flat"]
            .into_iter()
            .zip([gouraud, flat])
            .filter(|(_, value)| *value <= tolerance)
            .map(|(name, _)| name)
            .collect();
        assert_eq!(change(&plan, Axis::Shading).is_some(), !allowed.is_empty());
        assert!(change(&plan, Axis::Shading).is_none_or(|name| allowed.contains(&name)));
    }
}

/// Without time the reference is the plan, and it is not called the cheapest.
#[test]
fn no_time_leaves_the_reference() {
    let options = PlanOptions { seconds: Some(0.0), ..only(&[Axis::Lights], 2.0) };
    let plan = planned(SQUARE, &options);
    assert!(plan.decisions.is_empty() && !plan.is_cheapest, "{:?}", plan.decisions);
    assert!(plan.proven < plan.planned.work);
    let options = PlanOptions { seconds: Some(600.0), ..options };
    let plan = planned(SQUARE, &options);
    assert!(!plan.decisions.is_empty() && plan.is_cheapest);
}
