//! Lights whose cheapest kind follows from a formula.

use super::{assert_near, change, only, planned, scene, srgb, steps, switch};
use crease::plan::Axis;
use std::f64::consts::FRAC_2_PI;

/// A square of half a side 0.75, seen from the front; pixels have 1/16 of a unit, so the farthest centre is at 0.71875 along both sides.
fn frontal_square(lights: &str, transfer: &str) -> String {
    format!(
        "[settings]\nsize = [32, 32]\ntransfer = \"{transfer}\"\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 2\n{lights}\
         [[object]]\npolygons = {{ vertices = [[-0.75, -0.75, 0], [0.75, -0.75, 0], [0.75, 0.75, 0], [-0.75, 0.75, 0]], \
         faces = [[0, 1, 2, 3]] }}\nmaterial = {{ colour = 1, ambient = 0, diffuse = 0.8, specular = 0 }}\n"
    )
}

fn light(text: &str, tolerance: f64) -> Option<String> {
    change(&planned(text, &only(&[Axis::Lights], tolerance)), Axis::Lights).map(str::to_owned)
}

/// A lamp at distance D over the middle lights the farthest pixel, at ρ, with cos θ = D/√(D² + ρ²); a sun lights all with 1. With the
/// inverse-square law the factor is cos³θ.
#[test]
fn a_distant_lamp_is_a_sun() {
    let farthest = 0.71875 * 2.0_f64.sqrt();
    for (attenuation, power) in [("none", 1.0), ("inverse-square", 3.0)] {
        let is_lamp = |distance: f64| {
            let colour = if attenuation == "none" { 1.0 } else { distance * distance };
            let lamp = format!(
                "[[light.point]]\nposition = [0, 0, {distance:?}]\ncolour = {colour:?}\nattenuation = \"{attenuation}\"\n"
            );
            light(&frontal_square(&lamp, "srgb"), 2.0).is_none_or(|kind| !kind.starts_with("directional"))
        };
        let difference = |distance: f64| {
            let cosine = distance / (distance * distance + farthest * farthest).sqrt();
            255.0 * (srgb(0.8) - srgb(0.8 * libm::pow(cosine, power)))
        };
        let expected = switch(1.0, 1000.0, |distance| difference(distance) > 2.0);
        assert_near(switch(1.0, 1000.0, is_lamp), expected, 0.005);
    }
}

/// A square lamp of sides 2 at distance D over the middle: its irradiance is the form factor F, a point lamp of the same power has
/// A/(π D²). Over a tiny square only this difference decides.
#[test]
fn a_distant_area_light_is_a_sun() {
    let form_factor = |distance: f64| {
        let slant = (1.0 + distance * distance).sqrt();
        FRAC_2_PI * 2.0 / slant * libm::atan(1.0 / slant)
    };
    let power = |distance: f64| 2.0 * FRAC_2_PI / (distance * distance);
    let text = |distance: f64| {
        let colour = 1.0 / power(distance);
        format!(
            "[settings]\nsize = [8, 8]\ntransfer = \"direct\"\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 0.04\n\
             [[light.rectangle]]\ncentre = [0, 0, {distance:?}]\nu = [1, 0, 0]\nv = [0, -1, 0]\ncolour = {colour:?}\n[[object]]\n\
             polygons = {{ vertices = [[-0.01, -0.01, 0], [0.01, -0.01, 0], [0.01, 0.01, 0], [-0.01, 0.01, 0]], \
             faces = [[0, 1, 2, 3]] }}\nmaterial = {{ colour = 1, ambient = 0, diffuse = 0.8, specular = 0 }}\n"
        )
    };
    let difference = |distance: f64| 255.0 * 0.8 * (1.0 - form_factor(distance) / power(distance));
    let expected = switch(2.0, 100.0, |distance| difference(distance) > 2.0);
    let found = switch(2.0, 100.0, |distance| light(&text(distance), 2.0).is_none());
    assert_near(found, expected, 0.005);
    assert_eq!(light(&text(1.1 * expected), 2.0).as_deref(), Some("directional"));
}

/// On a larger square the kinds change one after another: an area light, a lamp, a sun.
#[test]
fn an_area_light_becomes_a_lamp_before_it_becomes_a_sun() {
    let kind = |distance: f64| {
        let colour = distance * distance;
        let lamp = format!(
            "[[light.rectangle]]\ncentre = [0, 0, {distance:?}]\nu = [0.3, 0, 0]\nv = [0, -0.3, 0]\ncolour = {colour:?}\n"
        );
        let kind = light(&frontal_square(&lamp, "direct"), 2.0).unwrap_or("rectangle".to_owned());
        kind.split(',').next().unwrap().to_owned()
    };
    let mut kinds: Vec<String> =
        (0..24).map(|number| kind(0.5 * libm::pow(1.3, f64::from(number)))).collect();
    kinds.dedup();
    assert_eq!(kinds.first().map(String::as_str), Some("rectangle"), "{kinds:?}");
    assert_eq!(kinds.last().map(String::as_str), Some("directional"), "{kinds:?}");
    assert!(
        kinds.len() > 2 && kinds[1..kinds.len() - 1].iter().all(|kind| kind == "spot" || kind == "point"),
        "{kinds:?}"
    );
}

/// Two suns, one a hundred times weaker. Next to the other it adds 255 (1 − encode(1/1.01)) = 1.1 steps at white; where it alone shines,
/// it adds 255 encode(0.01) = 25 steps.
#[test]
fn a_weak_light_is_omitted_where_another_outshines_it() {
    let suns = |second: &str| {
        format!(
            "[[light.directional]]\ntowards = [0, 0, 1]\ncolour = {:?}\n[[light.directional]]\ntowards = {second}\ncolour = {:?}\n",
            1.25 / 1.01,
            0.0125 / 1.01
        )
    };
    let text = frontal_square(&suns("[0, 0, 1]"), "srgb");
    let expected = 255.0 * (1.0 - srgb(1.0 / 1.01));
    assert!((1.0..1.2).contains(&expected), "{expected}");
    assert_eq!(light(&text, 2.0).as_deref(), Some("omitted"));
    assert_eq!(light(&text, 0.5), None);
    let found = switch(0.5, 2.0, |tolerance| light(&text, tolerance).is_none());
    assert_near(found, expected, 0.005);

    let ball = |towards: &str| {
        format!(
            "[settings]\nsize = [48, 48]\n[camera]\neye = [10, 0, 0]\ntarget = [0, 0, 0]\nheight = 2\n{}[[object]]\nsurface = {{ sphere = \
             {{ radius = 0.9 }} }}\ntessellation = {{ segments = [32, 16] }}\nmaterial = {{ colour = 1, diffuse = 0.8, specular = 0 }}\n",
            suns(towards)
        )
    };
    assert_eq!(light(&ball("[0, 0, -1]"), 2.0), None);
    let found = switch(2.0, 100.0, |tolerance| light(&ball("[0, 0, -1]"), tolerance).is_none());
    // The outermost pixel that is fully on the ball is lit with almost 1.
    assert_near(found, 255.0 * srgb(0.01 / 1.01), 0.03);
}

/// A scene file without lights has default lights, so a plan that omits the last light must not leave the list empty.
#[test]
fn a_scene_without_light_stays_dark() {
    let text = frontal_square("[[light.directional]]\ntowards = [0, 0, -1]\n", "srgb");
    let plan = planned(&text, &only(&[Axis::Lights], 2.0));
    assert_eq!(change(&plan, Axis::Lights), Some("omitted"));
    assert_eq!(steps(&scene(&text), &scene(&plan.text)), 0.0);
}

/// Lights from behind a ball light nothing that is seen, however many there are.
#[test]
fn many_lights_that_light_nothing_are_omitted() {
    let mut text = "[settings]\nsize = [24, 18]\n[camera]\neye = [0, 0, 9]\ntarget = [0, 0, 0]\nheight = 3\n[[light.directional]]\n\
         towards = [0, 0, 1]\n"
        .to_owned();
    for number in 0..20 {
        text += &format!("[[light.point]]\nposition = [0, {number}, -90]\n");
    }
    text += "[[object]]\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [12, 8] }\n";
    let plan = planned(&text, &only(&[Axis::Lights], 2.0));
    assert!(plan.is_cheapest, "{:?}", plan.end);
    assert_eq!(plan.decisions.len(), 20);
    assert!(plan.decisions.iter().all(|decision| decision.to == "omitted" && decision.number > 0));
}

/// Omitting the far lamp alone saves most of all single steps, and leaves no room for the three suns. As a sun it leaves room for omitting
/// all of them, which saves more. Every change of the lamp near the middle makes the part in view too bright, or leaves it dark.
#[test]
fn the_step_that_saves_most_is_not_always_in_the_cheapest_plan() {
    let step = 1.0 / 255.0;
    let mut text = "[settings]\nsize = [16, 16]\ntransfer = \"direct\"\n[camera]\neye = [-0.75, 0, 10]\ntarget = [-0.75, 0, 0]\n\
         height = 0.4\n"
        .to_owned();
    text += &format!(
        "[[light.point]]\nposition = [0, 0, 1e6]\ncolour = {:?}\nattenuation = \"none\"\n",
        1.8 * step
    );
    text += "[[light.point]]\nposition = [3, 0, 1]\ncolour = 10\nattenuation = \"inverse-square\"\n";
    for _ in 0..3 {
        text += &format!("[[light.directional]]\ntowards = [0, 0, 1]\ncolour = {:?}\n", 0.6 * step);
    }
    text += "[[object]]\npolygons = { vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], faces = [[0, 1, 2, 3]] }\n\
         material = { colour = 1, ambient = 0, diffuse = 1, specular = 0 }\n";
    let plan = planned(&text, &only(&[Axis::Lights], 2.0));
    assert!(plan.is_cheapest, "{:?}", plan.end);
    let changes: Vec<&str> = plan.decisions.iter().map(|decision| decision.to.as_str()).collect();
    assert_eq!(changes, ["directional", "omitted", "omitted", "omitted"], "{}", plan.text);
    assert!((plan.worst.steps - 1.8).abs() < 1e-3, "{:?}", plan.worst);
}

/// Each of these lamps is needed, and there are more combinations than could be listed.
#[test]
fn many_lights_that_are_needed_are_planned() {
    let mut text =
        "[settings]\nsize = [24, 18]\n[camera]\neye = [0, 0, 9]\ntarget = [0, 0, 0]\nheight = 3\n".to_owned();
    for number in 0..12 {
        let angle = f64::from(number) * std::f64::consts::TAU / 12.0;
        text += &format!(
            "[[light.point]]\nposition = [{}, {}, 200]\ncolour = 0.07\n",
            300.0 * libm::cos(angle),
            300.0 * libm::sin(angle)
        );
    }
    text += "[[object]]\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [12, 8] }\n";
    let plan = planned(&text, &only(&[Axis::Lights], 2.0));
    assert!(plan.is_cheapest, "{:?}", plan.end);
    assert_eq!(plan.combinations, 531_441.0, "3 to the power of 12");
    assert_eq!(plan.decisions.len(), 12);
    assert!(plan.decisions.iter().all(|decision| decision.to == "directional"), "{:?}", plan.decisions);
}
