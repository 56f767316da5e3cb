//! One scene under Phong's local model and traced: what ambient light replaces, and where both differ.

// The scene, and the light in it in closed form.
mod room;

use super::prelude::*;
use room::{AMBIENT, BALL, FLOOR, GLASS, MIRROR, Room};

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment =
    Experiment { takes: &[ParameterName::Size], ..Experiment::new("local-and-global", &TEXTS, run) };

/// The largest difference that maps show.
const FULL: f64 = 0.6;
/// Reflections and refractions along a path: of the cure, and of the picture that is taken as the true one.
const DEPTHS: [u32; 2] = [8, 24];

fn run(setup: &Setup) -> Result<Outcome> {
    let size = setup.parameters.size;
    let mut out = Recorder::new(&TEXTS, &[("full", FULL.into()), ("ambient", AMBIENT.into())]);
    measure_points(&mut out)?;
    let room = Room { ambient: AMBIENT };
    let local = room.picture(size, Shading::Phong, DEPTHS[0])?;
    let [traced, truth] = DEPTHS.map(|depth| room.picture(size, Shading::Traced, depth));
    let (traced, truth) = (traced?, truth?);
    let [dark, lit] =
        [Room { ambient: 0.0 }, room].map(|room| room.picture(size, Shading::Traced, DEPTHS[0]));
    let (dark, lit) = (dark?, lit?);
    measure_regions(&local, &truth, &mut out);
    let rms = |image: &Image| errors(image, &truth).map(|[_, rms]| rms);
    let effect = out.effect("global", "", [rms(&local)?, rms(&traced)?], Threshold::half_step(), 100.0);
    let of_ambient = out.effect("ambient", "", [rms(&dark)?, rms(&lit)?], Threshold::half_step(), 100.0);
    let difference = map([size; 2], &differences(&local, &truth), FULL);
    out.bad("local", &effect, local);
    out.cured("traced", &effect, traced);
    out.difference("difference", difference, FULL, "");
    out.bad("dark", &of_ambient, dark);
    out.cured("lit", &of_ambient, lit);
    Ok(out.finish(Verdict::Fails(out.text("fails")), effect))
}

/// The light at points with a closed form: in the shadow, next to it, and in the mirror.
fn measure_points(out: &mut Recorder) -> Result<()> {
    // Products of a few numbers in single precision.
    const ROUNDING: f64 = 1e-5;
    let room = Room { ambient: AMBIENT };
    let [of_shadow, of_light] = [room.shadow(), room.light()];
    for (name, shading, law) in
        [("shadow-local", Shading::Phong, of_light), ("shadow-traced", Shading::Traced, of_shadow)]
    {
        out.measure(name, "", room.floor_in_shadow(shading)?, Check::Near(law, ROUNDING));
    }
    let dark = Room { ambient: 0.0 };
    out.measure("shadow-dark", "", dark.floor_in_shadow(Shading::Traced)?, Check::AtMost(ROUNDING));
    out.measure("mirror-local", "", room.mirrored_floor(Shading::Phong)?, Check::AtMost(ROUNDING));
    let mirrored = room.mirrored_floor(Shading::Traced)?;
    out.measure("mirror-traced", "", mirrored, Check::Near(room::REFLECT * of_light, ROUNDING));
    Ok(())
}

/// The share of the squared difference on each object, and the largest difference elsewhere: where light comes straight from
/// the lamp, both pictures are alike.
fn measure_regions(local: &Image, traced: &Image, out: &mut Recorder) {
    let numbers = local.objects.as_deref().unwrap_or_default();
    let off = differences(local, traced);
    let squared = |is_counted: &dyn Fn(u32) -> bool| -> f64 {
        let here = off.iter().zip(numbers).filter(|(_, number)| is_counted(**number));
        here.filter_map(|(off, _)| off.map(|off| off * off)).sum()
    };
    let share = |squares: f64, all: f64| if all > 0.0 { 100.0 * squares / all } else { 0.0 };
    let all = squared(&|_| true);
    let regions = [("share-shadow", FLOOR), ("share-mirror", MIRROR), ("share-glass", GLASS)];
    for (name, object) in regions {
        let here = squared(&|number| number == Image::number_of(object, 1));
        out.measure(name, "%", share(here, all), Check::None);
    }
    let is_elsewhere = |number: u32| regions.iter().all(|(_, object)| number != Image::number_of(*object, 1));
    out.measure("share-elsewhere", "%", share(squared(&is_elsewhere), all), Check::AtMost(1e-3));
    // The lit side of the ball may lie in no shadow, and its dark side has none of the lamp's light anyway.
    let of_ball = off.iter().zip(numbers).filter(|(_, number)| **number == Image::number_of(BALL, 1));
    let largest = of_ball.filter_map(|(off, _)| *off).fold(0.0, f64::max);
    out.measure("ball", "", largest, Check::AtMost(0.5 / 255.0));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shadows_mirror_and_glass_are_all_that_differs() {
        for size in [64, 128] {
            let parameters = Parameters { size, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            for name in [
                "squared differences in the shadow",
                "squared differences in the mirror",
                "squared differences in the glass",
            ] {
                assert!(outcome.measured(name) > 1.0, "{name}: {}", outcome.measured(name));
            }
            assert!(matches!(outcome.verdict, Verdict::Fails(_)), "{:?}", outcome.verdict);
        }
    }
}
