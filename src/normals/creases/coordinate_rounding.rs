//! The error of angles between faces that the digits of positions allow.

use crate::mesh::{FacesRef, Mesh, PositionsRef, PrintedDigits, Storage, decimals};
use glam::DVec3;
use rayon::prelude::*;
use std::f64::consts::PI;

/// For each face, the angle in radians by which its normal may be off because coordinates were rounded to a few decimals;
/// `None` where they were not.
///
/// The decimals are those of the text, as far as positions show them. A corner is then off by δ = √3/2 units of that decimal at most, and the area vector ½Σ Pᵢ × Pᵢ₊₁ by
/// ½δ(Σ|Pᵢ₊₁ − Pᵢ₋₁| + nδ), which turns it by the arc sine of its share in the area. Where that is no angle, it is π.
pub(in crate::normals) fn turns_by_rounding(mesh: &Mesh) -> Option<Vec<f64>> {
    let moved = 0.5 * 3.0_f64.sqrt() * rounded_to(mesh)?;
    let (faces, positions) = (mesh.faces().view(), mesh.positions());
    Some((0..faces.len()).into_par_iter().map(|face| turn(faces, positions, face, moved)).collect())
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
    let coordinates = mesh.positions().iter().flat_map(|p| p.to_array());
    Some(PrintedDigits::Decimals(decimals(coordinates)?).step(0.0))
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
