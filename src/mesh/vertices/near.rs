//! Moving vertices that are close together to one position.

use crate::mesh::box_tree::Bounds;
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::positions::Positions;
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// How far vertices were moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct Movement {
    /// The number of vertices that were moved.
    pub vertices: usize,
    /// The longest distance, in the unit of the positions.
    pub longest: f64,
}

impl Movement {
    /// The movement in two meshes.
    pub fn and(self, other: Self) -> Self {
        Self { vertices: self.vertices + other.vertices, longest: self.longest.max(other.longest) }
    }
}

impl Mesh {
    /// Moves each vertex to the first vertex that stays and is at most `fraction` of the bounding box's diagonal away; a vertex
    /// without one stays. So vertices that stay are farther apart than that, and none moves farther. Chains do not grow.
    ///
    /// A grid with cells of that distance finds the neighbours: time and memory are linear in the vertices. Positions that are not
    /// finite stay.
    pub(crate) fn move_together(&mut self, fraction: f64) -> Movement {
        let points = self.positions().to_vec();
        let bounds = Bounds::of(points.iter().copied().filter(|p| p.is_finite()));
        // Halved before they are subtracted: the bounds may reach the largest numbers there are.
        let distance = fraction * (0.5 * bounds.high - 0.5 * bounds.low).length() * 2.0;
        let mut movement = Movement::default();
        if !(distance > 0.0 && distance.is_finite()) {
            return movement;
        }
        let cell_of = |p: DVec3| ((p - bounds.low) / distance).floor().to_array().map(|x| x as i64);
        let mut cells: FxHashMap<[i64; 3], Vec<u32>> = FxHashMap::default();
        let mut targets: Vec<u32> = (0..points.len() as u32).collect();
        for (vertex, &point) in points.iter().enumerate() {
            if !point.is_finite() {
                continue;
            }
            let cell = cell_of(point);
            let near = neighbours(cell).filter_map(|cell| cells.get(&cell)).flatten().copied();
            let first = near.filter(|&other| points[other as usize].distance(point) <= distance).min();
            match first {
                None => cells.entry(cell).or_default().push(vertex as u32),
                Some(first) => {
                    targets[vertex] = first;
                    let moved = points[first as usize].distance(point);
                    if moved > 0.0 {
                        movement = movement.and(Movement { vertices: 1, longest: moved });
                    }
                }
            }
        }
        if movement.vertices > 0 {
            let moved: Positions = self.positions().gather(&targets);
            self.positions = Arc::new(moved);
        }
        movement
    }
}

/// A cell and the 26 around it.
fn neighbours([x, y, z]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    let steps = [-1, 0, 1];
    steps.into_iter().flat_map(move |dx| {
        steps.into_iter().flat_map(move |dy| {
            steps
                .into_iter()
                .map(move |dz| [x.saturating_add(dx), y.saturating_add(dy), z.saturating_add(dz)])
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Columns, Faces, MeshBuilder};

    fn points(positions: Vec<DVec3>) -> Mesh {
        MeshBuilder {
            positions: positions.into(),
            faces: Faces::triangles(Vec::new()),
            columns: Columns::default(),
        }
        .build()
        .unwrap()
    }

    #[test]
    fn vertices_move_to_the_first_within_the_distance_and_no_farther() {
        // Steps of 0.4 in a diagonal of 10: with 0.05 (0.5), each second vertex moves by one step, and chains do not grow.
        let mut mesh = points((0..26).map(|k| DVec3::new(0.4 * f64::from(k), 0.0, 0.0)).collect());
        let movement = mesh.move_together(0.05);
        assert_eq!(movement.vertices, 13);
        assert!((movement.longest - 0.4).abs() < 1e-12, "{movement:?}");
        let xs: Vec<f64> = mesh.positions().iter().map(|p| p.x).collect();
        assert_eq!(xs[..4], [0.0, 0.0, 0.8, 0.8]);
    }

    #[test]
    fn vertices_that_stay_have_more_than_the_distance_between_them() {
        let noise = |k: u32, factor: u32| f64::from(k.wrapping_mul(factor) % 1009) / 1009.0;
        let all: Vec<DVec3> =
            (0..2000).map(|k| DVec3::new(noise(k, 37), noise(k, 101), noise(k, 577))).collect();
        let mut mesh = points(all.clone());
        let movement = mesh.move_together(0.05);
        let bounds = Bounds::of(all.iter().copied());
        let distance = 0.05 * (bounds.high - bounds.low).length();
        let mut stay: Vec<DVec3> = mesh.positions().to_vec();
        stay.sort_by(|a, b| a.to_array().partial_cmp(&b.to_array()).unwrap());
        stay.dedup();
        assert!(stay.len() < 1000 && movement.vertices > 1000 && movement.longest <= distance);
        for (k, a) in stay.iter().enumerate() {
            assert!(stay[k + 1..].iter().all(|b| a.distance(*b) > distance));
        }
        for (before, after) in all.iter().zip(mesh.positions().iter()) {
            assert!(before.distance(after) <= distance);
        }
    }

    #[test]
    fn points_at_one_position_and_huge_ones_do_not_move() {
        let mut mesh = points(vec![DVec3::ONE; 3]);
        assert_eq!(mesh.move_together(0.1), Movement::default());
        let mut mesh = points(vec![DVec3::splat(f64::MAX), DVec3::splat(-f64::MAX)]);
        assert_eq!(mesh.move_together(1e-9), Movement::default());
    }
}
