//! What a single face can do without: when flat is enough, when Gouraud is, and when there is no highlight on it.

use super::{HALF_STEP, Lit, angle, diffuse, near, shiny, turned};
use crate::random::Random;
use crate::shade::{direction, uniform};
use crease::num::{LinearRgb, steepest_slope};
use crease::shade::{Attenuation, Light, Material, Reflectance, Reflection, Viewer};
use glam::{DQuat, DVec3};

/// Weights of three corners that add up to 1.
fn inside(random: &mut Random) -> [f64; 3] {
    let [a, b] = [(); 2].map(|()| uniform(random));
    let [a, b] = if a + b > 1.0 { [1.0 - a, 1.0 - b] } else { [a, b] };
    [1.0 - a - b, a, b]
}

fn mix(corners: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    corners.into_iter().zip(weights).map(|(corner, weight)| corner * weight).sum()
}

/// Three unit vectors, each as far from the others as the angle.
fn equilateral(mutual: f64, random: &mut Random) -> [DVec3; 3] {
    let axis = direction(random);
    // sin of the distance from the axis: a chord of the circle is 2 sin(mutual/2) = √3 sin.
    let off = libm::asin(2.0 * libm::sin(0.5 * mutual) / 3.0_f64.sqrt());
    let first = turned(axis, off, random);
    [0.0, 1.0, 2.0].map(|k| DQuat::from_axis_angle(axis, k * std::f64::consts::TAU / 3.0) * first)
}

/// Gouraud's diffuse colour is N_lin·L to the bit of rounding, and what renormalising adds is 1 − min|N_lin| at most.
#[test]
fn gourauds_diffuse_error_is_what_interpolated_normals_lack_in_length() {
    let mut random = Random(131);
    // Between two normals: 1 − cos(θ/2); among three, each θ from the others: printed figures.
    let edges = [(5.0, 0.00095), (10.0, 0.0038), (20.0, 0.0152), (30.0, 0.0341), (60.0, 0.134)];
    for (degrees, printed) in edges {
        let theta = f64::to_radians(degrees);
        let bound = 1.0 - libm::cos(0.5 * theta);
        // As many digits as are printed.
        assert!((bound - printed).abs() < 0.5 * libm::exp10(libm::floor(libm::log10(printed)) - 1.0));
        let mut worst: f64 = 0.0;
        for _ in 0..3000 {
            let middle = direction(&mut random);
            let a = turned(middle, 0.5 * theta, &mut random);
            let b = DQuat::from_axis_angle(middle.cross(a).normalize(), -theta) * a;
            let lit = Lit::far(&diffuse(), near(middle, 0.5, &mut random), DVec3::Z);
            let t = if random.one_in(3) { 0.5 } else { uniform(&mut random) };
            let normal = a * (1.0 - t) + b * t;
            let gouraud = lit.of(a) * (1.0 - t) + lit.of(b) * t;
            assert!((gouraud - lit.of(normal) * normal.length()).abs() < 1e-15);
            worst = worst.max((lit.of(normal) - gouraud).abs());
        }
        assert!(worst <= bound + 1e-15 && worst > 0.99 * bound, "{degrees}: {worst} of {bound}");
    }
    for (degrees, printed) in [(10.0, 0.00508), (20.0, 0.0203), (30.0, 0.0457)] {
        let theta = f64::to_radians(degrees);
        let mut worst: f64 = 0.0;
        for _ in 0..5000 {
            let corners = equilateral(theta, &mut random);
            let weights = if random.one_in(3) { [1.0 / 3.0; 3] } else { inside(&mut random) };
            let normal = mix(corners, weights);
            let lit = Lit::far(&diffuse(), near(normal, 0.5, &mut random), DVec3::Z);
            let gouraud: f64 =
                corners.iter().zip(weights).map(|(corner, weight)| lit.of(*corner) * weight).sum();
            worst = worst.max((lit.of(normal) - gouraud).abs());
        }
        // The centre of the triangle has the shortest normal.
        assert!((worst / printed - 1.0).abs() < 0.02, "{degrees}: {worst}");
    }
    // Faces whose corners are within 7° never need more than Gouraud for diffuse light.
    assert!(1.0 - libm::cos(f64::to_radians(3.5)) < HALF_STEP);
}

/// Linear interpolation of a highlight over an edge is off by nθ²/8 at most, to leading order: the second derivative of cosⁿ
/// is n at most.
#[test]
fn gourauds_highlight_error_over_an_edge_is_n_theta_squared_over_8() {
    let mut random = Random(132);
    let mut reached: f64 = 0.0;
    for n in [10.0, 50.0, 200.0] {
        let material = shiny(Reflection::Blinn, n);
        for share in [0.02, 0.05, 0.1] {
            let theta = f64::sqrt(8.0 * share / n);
            let bound = n * theta * theta / 8.0;
            for _ in 0..4000 {
                let half = direction(&mut random);
                // Light and viewer in one direction: H is that direction.
                let lit = Lit::far(&material, half, half);
                let a = near(half, 3.0 / n.sqrt(), &mut random);
                let axis = a.cross(if random.one_in(2) { half } else { direction(&mut random) }).normalize();
                let t = uniform(&mut random);
                let [at, b] = [t * theta, theta].map(|angle| DQuat::from_axis_angle(axis, angle) * a);
                let error = (lit.of(at) - (lit.of(a) * (1.0 - t) + lit.of(b) * t)).abs();
                assert!(error <= bound, "n = {n}, {share}: {error} of {bound}");
                reached = reached.max(error / bound);
            }
        }
    }
    assert!(reached > 0.9, "{reached}");
}

/// Over a triangle whose normals lie on a circle of angular radius ρ it is nρ²/2 at most, which the middle of the circle
/// reaches where H lies there.
#[test]
fn gourauds_highlight_error_over_a_triangle_is_n_rho_squared_over_2() {
    let mut random = Random(134);
    let mut reached: f64 = 0.0;
    for n in [10.0, 50.0, 200.0] {
        let material = shiny(Reflection::Blinn, n);
        for share in [0.02, 0.05, 0.1] {
            let rho = f64::sqrt(2.0 * share / n);
            for round in 0..3000 {
                let middle = direction(&mut random);
                let half = if round % 3 == 0 { middle } else { near(middle, 3.0 / n.sqrt(), &mut random) };
                let lit = Lit::far(&material, half, half);
                let (aside, up) = middle.any_orthonormal_pair();
                let start = std::f64::consts::TAU * uniform(&mut random);
                let corners = [0.0, 1.0, 2.0].map(|third| {
                    let turn = start + third * std::f64::consts::TAU / 3.0;
                    let out = aside * libm::cos(turn) + up * libm::sin(turn);
                    middle * libm::cos(rho) + out * libm::sin(rho)
                });
                let weights = if round % 5 == 0 { [1.0 / 3.0; 3] } else { inside(&mut random) };
                let linear: f64 = corners.iter().zip(weights).map(|(corner, w)| lit.of(*corner) * w).sum();
                let error = (lit.of(mix(corners, weights).normalize()) - linear).abs();
                // Chords for arcs: the next order is ρ² of it.
                let bound = share * (1.0 + rho * rho);
                assert!(error <= bound, "n = {n}, {share}: {error} of {bound}");
                reached = reached.max(error / bound);
            }
        }
    }
    assert!(reached > 0.9, "{reached}");
}

/// The same test where light and viewer are near by and H turns over the face: by as much as it does from H of the middle,
/// η, the cone has to be wider.
#[test]
fn the_cone_test_holds_for_a_local_half_vector_widened() {
    let mut random = Random(135);
    let (mut skipped, mut missed_unwidened) = (0, 0);
    for round in 0..4000 {
        let n = [10.0, 50.0, 200.0][round % 3];
        let reach = libm::acos(libm::pow(HALF_STEP, 1.0 / n));
        let axis = direction(&mut random);
        let normals = [(); 3].map(|()| near(axis, 0.3, &mut random));
        let places = [(); 3].map(|()| direction(&mut random) * 0.5);
        let [light, eye] = [(); 2].map(|()| direction(&mut random) * (1.5 + 3.0 * uniform(&mut random)));
        let half_at = |p: DVec3| ((light - p).normalize() + (eye - p).normalize()).normalize_or_zero();
        let samples: Vec<(DVec3, DVec3)> = (0..40)
            .map(|_| {
                let weights = inside(&mut random);
                let place = places.iter().zip(weights).map(|(p, w)| *p * w).sum();
                (mix(normals, weights).normalize(), half_at(place))
            })
            .collect();
        if samples.iter().any(|(_, half)| *half == DVec3::ZERO) {
            continue;
        }
        let middle = half_at((places[0] + places[1] + places[2]) / 3.0);
        let eta = samples.iter().map(|(_, half)| angle(middle, *half)).fold(0.0, f64::max);
        let gamma = normals.iter().map(|normal| angle(axis, *normal)).fold(0.0, f64::max);
        let brightest =
            samples.iter().map(|(normal, half)| libm::pow(normal.dot(*half).max(0.0), n)).fold(0.0, f64::max);
        let room = angle(axis, middle) - gamma - reach;
        if room > eta {
            skipped += 1;
            assert!(brightest < HALF_STEP, "n = {n}: a highlight of {brightest} was missed");
        }
        missed_unwidened += usize::from(room > 0.0 && brightest >= HALF_STEP);
    }
    assert!(skipped > 500, "{skipped}");
    // Highlights that the cone misses if it is not widened.
    assert!(missed_unwidened > 0, "{missed_unwidened}");
}

/// The highlight test: the corner normals of a face lie in a cone of axis a and half-angle γ, and so do all that are
/// interpolated between them. cosⁿ of the angle to H is below ε for all of them if ∠(a, H) − γ > acos(ε^(1/n)).
#[test]
fn the_cone_test_never_misses_a_highlight() {
    let mut random = Random(133);
    let (mut skipped, mut kept, mut missed_by_corners, mut closest) = (0, 0, 0, 0.0_f64);
    for round in 0..6000 {
        let n = [10.0, 50.0, 200.0][round % 3];
        let epsilon = HALF_STEP;
        let reach = libm::acos(libm::pow(epsilon, 1.0 / n));
        let axis = direction(&mut random);
        let corners = [(); 3].map(|()| near(axis, 0.6, &mut random));
        let gamma = corners.iter().map(|corner| angle(axis, *corner)).fold(0.0, f64::max);
        let half = near(axis, gamma + 2.0 * reach, &mut random);
        let lit = Lit::far(&shiny(Reflection::Blinn, n), half, half);
        let skip = angle(axis, half) - gamma > reach;
        let at_corners = corners.iter().map(|corner| lit.of(*corner)).fold(0.0, f64::max);
        let mut brightest = at_corners;
        for _ in 0..60 {
            brightest = brightest.max(lit.of(mix(corners, inside(&mut random))));
        }
        // The bound that the test rests on.
        let bound = libm::pow(libm::cos((angle(axis, half) - gamma).max(0.0)), n);
        assert!(brightest <= bound + 1e-12, "n = {n}: {brightest} of {bound}");
        if skip {
            skipped += 1;
            assert!(brightest < epsilon, "n = {n}: a highlight of {brightest} was missed");
            closest = closest.max(brightest);
        } else {
            kept += 1;
            missed_by_corners += usize::from(at_corners < epsilon && brightest >= epsilon);
        }
    }
    assert!(skipped > 1000 && kept > 1000, "{skipped} {kept}");
    assert!(closest > 0.9 * HALF_STEP, "the test could skip more: {closest}");
    // Highlights that a test of the corners alone would miss.
    assert!(missed_by_corners > 100, "{missed_by_corners}");
}

/// One colour for a face, under a light and a viewer near by: k_d(ε_L + δ) + k_s M(n)(2δ + ε_L + ε_V) at most, with ε as seen
/// from the ends over the face and δ from its normal to the true ones.
#[test]
fn flat_is_off_by_its_own_bound_at_most() {
    let mut random = Random(134);
    let white = Reflectance::Merged(LinearRgb::WHITE);
    let mut reached: f64 = 0.0;
    for round in 0..20_000 {
        let n = [5.0, 20.0, 100.0][round % 3];
        let half = Reflectance::Merged(LinearRgb::grey(0.5));
        let material = Material {
            diffuse: if round % 2 == 0 { half } else { Reflectance::NONE },
            specular: if round % 2 == 0 { half } else { white },
            exponent: n,
            reflection: Reflection::Phong,
            ..Material::default()
        };
        let (k_d, k_s) = if round % 2 == 0 { (0.5, 0.5) } else { (0.0, 1.0) };
        let distance = libm::exp2(2.0 + 8.0 * uniform(&mut random));
        let delta = 0.02 * uniform(&mut random);
        let face = direction(&mut random);
        let towards = near(face, 1.3, &mut random);
        let mirrored = 2.0 * face * face.dot(towards) - towards;
        let eye = near(mirrored, 2.0 / n.sqrt(), &mut random) * distance;
        let light = Light::Point {
            position: towards * distance,
            colour: LinearRgb::WHITE,
            attenuation: Attenuation::None,
        };
        let lit = Lit::new(&material, light, Viewer::At(eye));
        // The face's circumcircle has radius 1; its centre is where it is lit.
        let x = direction(&mut random).cross(face).normalize() * uniform(&mut random);
        let normal = near(face, delta, &mut random);
        // The guard takes the highlight away where light sets, all at once: another bound.
        if normal.dot(towards * distance - x) <= 0.0 {
            continue;
        }
        let error = (lit.at(x, normal) - lit.of(face)).abs();
        let epsilon = libm::asin(1.0 / distance);
        let bound = k_d * (epsilon + delta) + k_s * steepest_slope(n) * (2.0 * delta + 2.0 * epsilon);
        assert!(error <= bound, "n = {n}: {error} of {bound}");
        reached = reached.max(error / bound);
    }
    assert!(reached > 0.5, "{reached}");
}
