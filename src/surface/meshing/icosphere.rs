//! Subdivided icosahedra.

use crate::mesh::Faces;
use crate::surface::error::{Result, check_count};
use crate::surface::meshing::net::Net;
use crate::surface::shapes::chart::Sample;
use crate::surface::shapes::star::StarShaped;
use glam::DVec3;
use rustc_hash::FxHashMap;

/// Level 10 has 21 million triangles.
const HIGHEST: u64 = 10;

/// The surface in the directions of an icosahedron whose triangles are cut in four so many times.
pub(crate) fn net(surface: &dyn StarShaped, level: u32) -> Result<Net> {
    check_count("levels of division", level, 0..=HIGHEST)?;
    let (mut directions, mut triangles) = icosahedron();
    for _ in 0..level {
        triangles = quarter(&mut directions, &triangles);
    }
    let along = |&direction: &DVec3| {
        surface.along(direction).expect("a direction of length 1 leads to a point with a normal")
    };
    let samples: Vec<Sample> = directions.iter().map(along).collect();
    Ok(Net::without_parameters(samples, Faces::triangles(triangles.as_flattened().to_vec())))
}

/// Corners (0, ±1, ±φ) and their cyclic permutations, and the triangles between neighbours, counter-clockwise.
fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners = Vec::with_capacity(12);
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        corners.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
    }
    // Edges have length 2, the next distance is 2φ.
    let meet = |a: u32, b: u32| corners[a as usize].distance_squared(corners[b as usize]) < 5.0;
    let mut triangles = Vec::with_capacity(20);
    for a in 0..12 {
        for b in (a + 1..12).filter(|&b| meet(a, b)) {
            for c in (b + 1..12).filter(|&c| meet(b, c) && meet(c, a)) {
                let [p, q, r] = [a, b, c].map(|k| corners[k as usize]);
                triangles.push(if p.dot(q.cross(r)) > 0.0 { [a, b, c] } else { [a, c, b] });
            }
        }
    }
    (corners.into_iter().map(DVec3::normalize).collect(), triangles)
}

/// Each triangle as four, by the midpoints of its edges moved onto the sphere.
fn quarter(directions: &mut Vec<DVec3>, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut middles: FxHashMap<[u32; 2], u32> = FxHashMap::default();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            directions.push((directions[a as usize] + directions[b as usize]).normalize());
            directions.len() as u32 - 1
        })
    };
    let mut quarters = Vec::with_capacity(4 * triangles.len());
    for &[a, b, c] in triangles {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        quarters.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    quarters
}
