//! The error of angles between faces that the digits of positions allow.

use crate::mesh::{FacesRef, Mesh, PositionsRef, Storage};
use crate::num::parallel;
use glam::DVec3;
use std::f64::consts::PI;

/// With more decimals than this, the angles between faces of any sensible size are right to far less than they are compared by.
const MOST_DECIMALS: i32 = 6;

/// Coordinates that have to end in a digit of their own before the last decimal counts as what others were rounded to, and
/// different digits among them: a box of halves is exact, not rounded.
const FEWEST_ROUNDED: usize = 12;
const FEWEST_DIGITS: u32 = 4;

/// For each face, the angle in radians by which its normal may be off because coordinates were rounded to a few decimals;
/// `None` where they were not.
///
/// The decimals are those of the text, as far as positions show them: the fewest that hold every coordinate, if the last of them
/// takes several values. A corner is then off by δ = √3/2 units of that decimal at most, and the area vector ½Σ Pᵢ × Pᵢ₊₁ by
/// ½δ(Σ|Pᵢ₊₁ − Pᵢ₋₁| + nδ), which turns it by the arc sine of its share in the area. Where that is no angle, it is π.
pub(in crate::normals) fn turns_by_rounding(mesh: &Mesh) -> Option<Vec<f64>> {
    let moved = 0.5 * 3.0_f64.sqrt() * rounded_to(mesh)?;
    let (faces, positions) = (mesh.faces().view(), mesh.positions());
    Some(parallel::map(faces.len(), |face| turn(faces, positions, face, moved)))
}

/// By how much the normal of a face turns at most if its corners move by so much.
fn turn(faces: FacesRef, positions: PositionsRef, face: usize, moved: f64) -> f64 {
    let corners = faces.face(face);
    let at = |corner: usize| positions.at(corners[corner % corners.len()]);
    let first = at(0);
    let (mut doubled_area, mut diagonals) = (DVec3::ZERO, 0.0);
    for corner in 0..corners.len() {
        doubled_area += (at(corner) - first).cross(at(corner + 1) - first);
        diagonals += at(corner + 2).distance(at(corner));
    }
    let sine = moved * (diagonals + corners.len() as f64 * moved) / doubled_area.length();
    if sine < 1.0 { libm::asin(sine) } else { PI }
}

/// The unit of the last decimal that coordinates were rounded to.
fn rounded_to(mesh: &Mesh) -> Option<f64> {
    if mesh.storage() == Storage::F32 {
        return None;
    }
    let mut decimals = 0;
    for coordinate in coordinates(mesh) {
        while last_digit(coordinate, decimals).is_none() {
            decimals += 1;
            if decimals > MOST_DECIMALS {
                return None;
            }
        }
    }
    let mut rounded = 0;
    let mut digits = 0_u32;
    for digit in coordinates(mesh).filter_map(|x| last_digit(x, decimals)) {
        rounded += usize::from(digit != 0);
        digits |= 1 << digit;
        if rounded >= FEWEST_ROUNDED && digits.count_ones() >= FEWEST_DIGITS {
            return Some(1.0 / libm::exp10(f64::from(decimals)));
        }
    }
    None
}

fn coordinates(mesh: &Mesh) -> impl Iterator<Item = f64> {
    mesh.positions().iter().flat_map(|p| p.to_array())
}

/// The last of so many decimals, if there are no more.
fn last_digit(coordinate: f64, decimals: i32) -> Option<u8> {
    let units = (coordinate * libm::exp10(f64::from(decimals))).abs();
    let whole = units.round();
    // A number that was read from decimals is off by half a spacing, and so is the product; beyond 2⁴⁸ that would hide the rest.
    let is_whole = (units - whole).abs() <= 2.0 * f64::EPSILON * units && units < libm::ldexp(1.0, 48);
    is_whole.then(|| (whole % 10.0) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder, Positions};
    use crate::num::test_numbers::Numbers;

    fn strip(round: impl Fn(f64) -> f64, storage: Storage) -> Mesh {
        let mut numbers = Numbers::new(31);
        let mut point = || DVec3::from_array([0; 3].map(|_| round(8.0 * numbers.unit() - 4.0)));
        let positions = (0..40).map(|_| point()).collect();
        let faces = Faces::triangles((0..38).flat_map(|i| [i, i + 1, i + 2]).collect());
        MeshBuilder { positions: Positions::rounded(positions, storage), faces, ..MeshBuilder::default() }
            .build()
            .unwrap()
    }

    fn to_decimals(decimals: i32) -> impl Fn(f64) -> f64 {
        move |x| format!("{x:.*}", decimals as usize).parse().unwrap()
    }

    #[test]
    fn decimals_are_seen_where_there_are_few() {
        for decimals in 0..=MOST_DECIMALS {
            let unit = rounded_to(&strip(to_decimals(decimals), Storage::F64)).unwrap();
            assert!((unit * libm::exp10(f64::from(decimals)) - 1.0).abs() < 1e-15, "{decimals}");
        }
        assert_eq!(rounded_to(&strip(to_decimals(7), Storage::F64)), None);
        assert_eq!(rounded_to(&strip(|x| x, Storage::F64)), None);
        assert_eq!(rounded_to(&strip(to_decimals(2), Storage::F32)), None);
        // Halves are exact.
        assert_eq!(rounded_to(&strip(|x| x.round() + 0.5, Storage::F64)), None);
    }

    /// Faces of exact corners against those of rounded ones.
    #[test]
    fn no_face_turns_by_more_and_some_by_nearly_as_much() {
        let exact = strip(|x| x, Storage::F64);
        let normal = |mesh: &Mesh, face: usize| {
            let [a, b, c] = [0, 1, 2].map(|k| mesh.positions().at((face + k) as u32));
            (b - a).cross(c - a)
        };
        let mut closest = 0.0_f64;
        for decimals in 1..=4 {
            let rounded = strip(to_decimals(decimals), Storage::F64);
            let turns = turns_by_rounding(&rounded).unwrap();
            for (face, allowed) in turns.into_iter().enumerate() {
                let (a, b) = (normal(&exact, face), normal(&rounded, face));
                let turned = libm::atan2(a.cross(b).length(), a.dot(b));
                assert!(turned <= allowed, "{decimals}, {face}: {turned:e} of {allowed:e}");
                closest = closest.max(turned / allowed);
            }
        }
        // All corners at their worst at once are rare: half of it is found.
        assert!(closest > 0.4, "{closest}");
    }
}
