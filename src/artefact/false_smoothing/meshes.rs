//! Meshes with sharp edges, whose faces share their vertices.

use super::super::prelude::*;
use std::f64::consts::TAU;

pub(super) fn cube() -> Result<Mesh> {
    let mut faces = Faces::new();
    BOX_FACES.iter().for_each(|face| faces.push(face));
    build(box_corners(DVec3::splat(2.0)), faces)
}

const TEETH: u32 = 12;
pub(super) const BORE: u32 = 4 * TEETH;

/// A gear about the z axis with a bore: flat faces, all of whose edges are sharp, but those along the bore.
pub(super) fn gear() -> Result<Mesh> {
    const THICKNESS: f64 = 0.36;
    // Where a tooth's root and tip begin and end, in shares of its part of the circle, and how far out they are.
    const PROFILE: [[f64; 2]; 4] = [[0.0, 0.72], [0.42, 0.72], [0.54, 1.0], [0.88, 1.0]];
    const HOLE: f64 = 0.36;
    let around = |turn: f64, radius: f64| {
        let (sine, cosine) = libm::sincos(TAU * turn);
        DVec2::new(cosine, sine) * radius
    };
    let outline = (0..BORE).map(|k| {
        let [share, radius] = PROFILE[(k % 4) as usize];
        around((f64::from(k / 4) + share) / f64::from(TEETH), radius)
    });
    let bore = (0..BORE).map(|k| around(f64::from(k) / f64::from(BORE), HOLE));
    let ring: Vec<DVec2> = outline.chain(bore).collect();
    let layer = |z: f64| ring.iter().map(move |point| point.extend(z));
    let positions = layer(-0.5 * THICKNESS).chain(layer(0.5 * THICKNESS)).collect();
    let mut faces = Faces::new();
    for (k, next) in (0..BORE).map(|k| (k, (k + 1) % BORE)) {
        let high = 2 * BORE;
        faces.push(&[k, next, next + high, k + high]);
        faces.push(&[BORE + next, BORE + k, BORE + k + high, BORE + next + high]);
        faces.push(&[next, k, BORE + k, BORE + next]);
        faces.push(&[k + high, next + high, BORE + next + high, BORE + k + high]);
    }
    build(positions, faces)
}

/// A sheet folded along upright lines: so many strips of width 1, each leaning by one of these angles in turn, about the origin.
pub(super) fn folded(leans: &[Degrees], strips: u32) -> Result<Mesh> {
    const HALF: f64 = 2.2;
    let mut profile = vec![DVec2::ZERO];
    for strip in 0..strips as usize {
        let (sine, cosine) = libm::sincos(Radians::from(leans[strip % leans.len()]).0);
        profile.push(profile[strip] + DVec2::new(cosine, sine));
    }
    let width = profile[strips as usize].x;
    let row = |y: f64| profile.iter().map(move |point| DVec3::new(point.x - 0.5 * width, y, point.y));
    let positions = row(-HALF).chain(row(HALF)).collect();
    sheets(positions, [strips, 1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Link, Topology, Weld};

    #[test]
    fn solids_are_closed_and_face_outwards() {
        for (mesh, volume) in [(cube().unwrap(), 8.0), (gear().unwrap(), 0.0)] {
            let topology = Topology::build(&mesh, Weld::Off);
            let corners = mesh.faces().corner_count() as u32;
            assert!((0..corners).all(|corner| matches!(topology.link(corner), Link::Twin(_))));
            // Six times the volume, by fans.
            let six: f64 = mesh
                .faces()
                .iter()
                .map(|face| {
                    let p = |k: usize| mesh.positions().at(face[k]);
                    (1..face.len() - 1).map(|k| p(0).dot(p(k).cross(p(k + 1)))).sum::<f64>()
                })
                .sum();
            assert!(six > 0.0 && (volume == 0.0 || (six / 6.0 - volume).abs() < 1e-12), "{six}");
        }
    }
}
