//! A cube and a long box, whose six faces can be cut in 64 ways, and what weightings make of them.

use super::super::prelude::*;
use super::surfaces::{FLAT, ROUND, View};

/// The sides of the cube and of the long box.
pub(super) const CUBE: DVec3 = DVec3::ONE;
pub(super) const LONG: DVec3 = DVec3::new(10.0, 1.0, 1.0);
/// Full scale of the map of light.
const FULL_LIGHT: f64 = 0.3;

/// Over all corners and all 64 cuts: the largest angle, and the others that are of interest.
pub(super) fn measure(weight: Weight, out: &mut Recorder) -> Result<()> {
    let check = |law: Option<f64>| law.map_or(Check::None, |law| Check::Near(law, 1e-9));
    let [cube_law, long_law] = [CUBE, LONG].map(|sides| law(sides, weight));
    let cube = measured(CUBE, weight)?;
    out.measure("cube-largest", "°", cube.largest, check(cube_law.map(|law| law.largest)));
    if cube.next < cube.largest {
        out.measure("cube-next", "°", cube.next, check(cube_law.map(|law| law.next)));
    }
    let long = measured(LONG, weight)?;
    out.measure("box-largest", "°", long.largest, check(long_law.map(|law| law.largest)));
    if long.least > 1.0 {
        out.measure("box-least", "°", long.least, check(long_law.map(|law| law.least)));
    }
    Ok(())
}

/// The largest angle on a box by some weights, and by those that do not depend on the cut.
pub(super) fn effect(name: &str, sides: DVec3, weight: Weight, out: &Recorder) -> Result<Effect> {
    let angles = [measured(sides, weight)?.largest, measured(sides, FLAT)?.largest];
    Ok(out.effect(name, "°", angles, Threshold::half_step_of_tilt(), 1000.0))
}

/// The cube in two cuts, and the long box by Max's weights, which favour its ends.
pub(super) fn show(of_cube: &Effect, weight: Weight, view: &View, out: &mut Recorder) -> Result<()> {
    let of_box = effect("box", LONG, ROUND, out)?;
    let (one, other) = (draw_box(CUBE, 0, weight, view)?, draw_box(CUBE, CUTS - 1, weight, view)?);
    let between = map(one.size, &differences(&one, &other), FULL_LIGHT);
    out.set("full-light", FULL_LIGHT);
    out.bad("cube-1", of_cube, one);
    out.bad("cube-2", of_cube, other);
    out.difference("cube-difference", between, FULL_LIGHT, "");
    out.cured("cube-angle", of_cube, draw_box(CUBE, 0, FLAT, view)?);
    out.bad("box-max", &of_box, draw_box(LONG, 0, ROUND, view)?);
    out.cured("box-angle", &of_box, draw_box(LONG, 0, FLAT, view)?);
    Ok(())
}

fn draw_box(sides: DVec3, cut: u32, weight: Weight, view: &View) -> Result<Image> {
    let mesh = cut_box(sides, cut)?;
    let field = smooth(&mesh, weight);
    let object = object(&mesh, &field, chalk());
    let camera = camera(std::slice::from_ref(&object));
    let light = light_from(&camera, view.light)?;
    draw(vec![object], &[light], camera, settings([view.size; 2], Shading::Phong))
}

pub(super) const CUTS: u32 = 64;

/// A box about the origin. Bit k of `cut` says along which diagonal face k is cut.
pub(super) fn cut_box(sides: DVec3, cut: u32) -> Result<Mesh> {
    let triangles = BOX_FACES.iter().enumerate().flat_map(|(face, &[a, b, c, d])| match cut >> face & 1 {
        0 => [a, b, c, a, c, d],
        _ => [a, b, d, b, c, d],
    });
    let faces = Faces::triangles(triangles.collect());
    build(box_corners(sides), faces)
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Range {
    pub(super) least: f64,
    /// The least that is not 0; infinite if all are.
    pub(super) next: f64,
    pub(super) largest: f64,
}

impl Range {
    fn of(angles: impl Iterator<Item = f64>) -> Self {
        /// Far above rounding, far below what a cut does.
        const NOTHING: f64 = 1e-9;
        let none = Self { least: f64::INFINITY, next: f64::INFINITY, largest: 0.0 };
        angles.fold(none, |Self { least, next, largest }, angle| Self {
            least: least.min(angle),
            next: if angle > NOTHING { next.min(angle) } else { next },
            largest: largest.max(angle),
        })
    }
}

/// The angles between averaged normals at the corners of a box and the diagonals, over all corners and all cuts.
pub(super) fn measured(sides: DVec3, weight: Weight) -> Result<Range> {
    let mut angles = Vec::new();
    for cut in 0..CUTS {
        let mesh = cut_box(sides, cut)?;
        let field = smooth(&mesh, weight);
        let off = |(normal, &vertex): (&DVec3, &u32)| {
            let diagonal = mesh.positions().at(vertex).signum();
            Degrees::from(angle_between(*normal, diagonal)).0
        };
        angles.extend(field.normals.values.iter().zip(&field.entry_vertex).map(off));
    }
    Ok(Range::of(angles.into_iter()))
}

/// The same by the formulas: each face at a corner counts as one triangle or two. `None` for weights that are no sum.
pub(super) fn law(sides: DVec3, weight: Weight) -> Option<Range> {
    // Of the faces at right angles to each axis, cut past the corner and through it.
    let [x, y, z] = sides.to_array();
    let weights = [[y, z], [z, x], [x, y]].map(|[a, b]| of_face(weight, a, b));
    let [of_x, of_y, of_z] = weights;
    let (of_x, of_y, of_z) = (of_x?, of_y?, of_z?);
    let sum = |k: usize| DVec3::new(of_x[k & 1], of_y[k >> 1 & 1], of_z[k >> 2]);
    Some(Range::of((0..8).map(|k| Degrees::from(angle_between(sum(k), DVec3::ONE)).0)))
}

/// What a face with the sides a and b counts at a corner, whole and cut there.
fn of_face(weight: Weight, a: f64, b: f64) -> Option<[f64; 2]> {
    let diagonal = libm::hypot(a, b);
    Some(match weight {
        Weight::Uniform => [1.0, 2.0],
        Weight::Area => [0.5 * a * b, a * b],
        Weight::Angle => [1.0, 1.0],
        // Either half has half the area.
        Weight::AngleArea => [a * b, a * b],
        // (a² + b²)/(ab d²) of both halves.
        Weight::Max => [1.0 / (a * b), 1.0 / (a * b)],
        Weight::Edge => [1.0 / (a * b), (1.0 / a + 1.0 / b) / diagonal],
        Weight::Quadric | Weight::Jet | Weight::Best => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Figures computed outside this program.
    #[test]
    fn all_cuts_of_boxes_have_their_published_values() {
        let long = DVec3::new(1.0, 1.0, 10.0);
        for (sides, weight, least, largest) in [
            (DVec3::ONE, Weight::Angle, 0.0, 0.0),
            (DVec3::ONE, Weight::Max, 0.0, 0.0),
            (DVec3::ONE, Weight::Uniform, 0.0, 19.4712),
            (DVec3::ONE, Weight::Area, 0.0, 19.4712),
            (DVec3::ONE, Weight::Edge, 0.0, 9.736),
            (long, Weight::Angle, 0.0, 0.0),
            (long, Weight::Uniform, 0.0, 19.471),
            (long, Weight::Area, 27.2, 36.9),
            (long, Weight::Max, 46.686, 46.686),
        ] {
            let digits = if sides == long && weight == Weight::Area { 0.05 } else { 6e-4 };
            for range in [measured(sides, weight).unwrap(), law(sides, weight).unwrap()] {
                let off = (range.least - least).abs().max((range.largest - largest).abs());
                assert!(off < digits, "{weight:?} {sides}: {range:?}");
            }
        }
    }

    #[test]
    fn a_cube_has_three_angles() {
        let Range { least, next, largest } = measured(DVec3::ONE, Weight::Uniform).unwrap();
        assert!(least < 1e-12 && (next - 15.7932).abs() < 5e-5 && (largest - 19.4712).abs() < 5e-5);
        assert!((measured(DVec3::ONE, Weight::Edge).unwrap().next - 8.699).abs() < 5e-4);
    }

    #[test]
    fn laws_and_meshes_agree_on_boxes_of_any_sides() {
        for weight in Weight::ALL {
            let sides = DVec3::new(0.7, 2.0, 3.1);
            let Some(law) = law(sides, weight) else { continue };
            let found = measured(sides, weight).unwrap();
            let off = (found.least - law.least).abs().max((found.largest - law.largest).abs());
            // A few roundings, in degrees.
            assert!(off < 1e-12, "{weight:?}: {found:?} {law:?}");
        }
    }
}
