//! The error of a colour that follows from an error of a normal.

use super::{HALF_STEP, Lit, diffuse, near, shiny, turned};
use crate::random::Random;
use crate::shade::{direction, uniform};
use crease::num::{Power, Underflow, steepest_slope};
use crease::shade::Reflection;
use glam::{DQuat, DVec3};

/// n and the printed M(n): the largest slope of cosⁿ.
const SLOPES: [(f64, f64); 6] =
    [(2.0, 1.0), (5.0, 1.4311), (10.0, 1.9683), (50.0, 4.3105), (100.0, 6.0805), (1000.0, 19.185)];

#[test]
fn m_is_the_largest_slope_and_n_the_largest_curvature_of_the_power() {
    for (n, printed) in SLOPES {
        let power = Power::<f64>::new(n, Underflow::Gradual);
        let f = |angle: f64| power.of(libm::cos(angle));
        let step = 1e-4 / n.sqrt();
        let angles = || (0..).map(|k| f64::from(k) * step).take_while(|angle| *angle < 1.5);
        let slope =
            angles().map(|a| ((f(a + 0.5 * step) - f(a - 0.5 * step)) / step).abs()).fold(0.0, f64::max);
        // Differences round by 1e-16/step and differ from slopes by step²; five digits are printed.
        assert!((slope / steepest_slope(n) - 1.0).abs() < 1e-6, "n = {n}: {slope}");
        assert!((slope / printed - 1.0).abs() < 5e-5, "n = {n}: {slope}");
        let steepest = libm::atan(1.0 / (n - 1.0).sqrt());
        assert!(((f(steepest + step) - f(steepest - step)) / (2.0 * step) + slope).abs() < 1e-5 * slope);
        let wide = 1e-3 / n.sqrt();
        let bend = |a: f64| ((f(a + wide) + f(a - wide) - 2.0 * f(a)) / (wide * wide)).abs();
        let largest = angles().step_by(10).map(bend).fold(0.0, f64::max);
        assert!((largest / n - 1.0).abs() < 1e-5 && (bend(0.0) / n - 1.0).abs() < 1e-5, "n = {n}: {largest}");
    }
}

/// |Δdiffuse| ≤ δ, |ΔBlinn| ≤ M(n) δ, |ΔPhong| ≤ 2 M(n) δ, and errors that come near.
#[test]
fn a_normal_that_is_off_changes_colours_by_no_more_than_the_slope() {
    let mut random = Random(111);
    let mut check = |material, factor: f64| {
        let mut share: f64 = 0.0;
        for _ in 0..4000 {
            let light = direction(&mut random);
            let lit = Lit::far(&material, light, near(light, 1.0, &mut random));
            let delta = 1e-3 * uniform(&mut random) / factor;
            let normal = near(light, 1.5, &mut random);
            let change = (lit.of(normal) - lit.of(turned(normal, delta, &mut random))).abs();
            assert!(change <= factor * delta + 1e-14, "{change:e} for {delta:e} times {factor}");
            share = share.max(change / (factor * delta + 1e-14));
        }
        share
    };
    let mut shares = vec![check(diffuse(), 1.0)];
    for n in [2.0, 10.0, 100.0] {
        shares.push(check(shiny(Reflection::Blinn, n), steepest_slope(n)));
        shares.push(check(shiny(Reflection::Phong, n), 2.0 * steepest_slope(n)));
    }
    assert!(shares.iter().all(|share| *share > 0.9), "the bounds are needed: {shares:?}");
}

/// The angles, in degrees, that are printed for half a step of 8 bits: at them the worst change is half a step.
#[test]
fn half_step_thresholds_are_where_half_a_step_is_reached() {
    let worst = |material, at: f64, degrees: f64| {
        // Light and viewer in one direction: N·H = N·L.
        let lit = Lit::far(&material, DVec3::Z, DVec3::Z);
        let leaning = |angle: f64| DQuat::from_rotation_y(angle) * DVec3::Z;
        (lit.of(leaning(at)) - lit.of(leaning(at + degrees.to_radians()))).abs()
    };
    // A diffuse surface changes fastest where light grazes it.
    let grazing = std::f64::consts::FRAC_PI_2 - 0.1123_f64.to_radians();
    assert!((worst(diffuse(), grazing, 0.1123) / HALF_STEP - 1.0).abs() < 1e-3);
    for (n, degrees) in [(10.0_f64, 0.0571), (50.0, 0.0261), (100.0, 0.0185), (1000.0, 0.0059)] {
        let steepest = libm::atan(1.0 / (n - 1.0).sqrt());
        let blinn = worst(shiny(Reflection::Blinn, n), steepest - 0.5 * f64::to_radians(degrees), degrees);
        // Three digits are printed, two of the last one.
        assert!((blinn / HALF_STEP - 1.0).abs() < 1e-2, "n = {n}: {blinn}");
        // Phong's ray turns twice as far: half the angle.
        let phong = worst(
            shiny(Reflection::Phong, n),
            0.5 * (steepest - f64::to_radians(degrees) * 0.5),
            0.5 * degrees,
        );
        assert!((phong / HALF_STEP - 1.0).abs() < 1e-2, "n = {n}: {phong}");
    }
}
