//! Joining the grids of neighbouring patches.

use crate::mesh::{DisjointSets, Faces};
use crate::surface::meshing::grid::Grid;
use crate::surface::meshing::net::Net;
use crate::surface::meshing::pattern::Tessellation;
use crate::surface::shapes::bezier::BezierPatch;
use crate::surface::shapes::chart::Parametric;
use glam::DVec3;

/// Makes one vertex of those that two patches have at the same place of a common side: sides with the same four control
/// points, in either direction. Patches that merely touch stay apart. The vertex of the first patch stands for all; where
/// patches meet smoothly, as those of the teapot do, that is also everyone's normal.
pub(in crate::surface) fn join(net: &mut Net, patches: &[BezierPatch], tessellation: &Tessellation) {
    if patches.len() < 2 {
        return;
    }
    let sides = sides(patches, tessellation);
    let mut sets = DisjointSets::new(net.samples.len());
    for (number, (points, vertices)) in sides.iter().enumerate() {
        let reversed = [points[3], points[2], points[1], points[0]];
        for (others, theirs) in &sides[number + 1..] {
            if others == points {
                vertices.iter().zip(theirs).for_each(|(&a, &b)| sets.union(a, b));
            } else if *others == reversed {
                vertices.iter().zip(theirs.iter().rev()).for_each(|(&a, &b)| sets.union(a, b));
            }
        }
    }
    // The lowest of each set stays, so numbers only move down.
    let mut number = Vec::with_capacity(net.samples.len());
    let mut kept = Vec::with_capacity(net.samples.len());
    for vertex in 0..net.samples.len() as u32 {
        let stands = sets.find(vertex);
        number.push(if stands == vertex { kept.len() as u32 } else { number[stands as usize] });
        if stands == vertex {
            kept.push(net.samples[vertex as usize]);
        }
    }
    net.samples = kept;
    let corners = net.faces.corners().iter().map(|&vertex| number[vertex as usize]).collect();
    net.faces = match net.faces.offsets() {
        Some(offsets) => Faces::polygons(corners, offsets.to_vec()),
        None => Faces::triangles(corners),
    };
}

/// Every side of every patch that is longer than a point: its control points and its vertices.
fn sides(patches: &[BezierPatch], tessellation: &Tessellation) -> Vec<([DVec3; 4], Vec<u32>)> {
    let mut sides = Vec::with_capacity(4 * patches.len());
    let mut base = 0;
    for (part, patch) in patches.iter().enumerate() {
        let grid = Grid::new(patch.chart(), tessellation, part as u32);
        let [columns, rows] = grid.segments;
        let along_u = |j: u32| (0..=columns).map(|i| base + grid.vertex(i, j)).collect::<Vec<_>>();
        let along_v = |i: u32| (0..=rows).map(|j| base + grid.vertex(i, j)).collect();
        let vertices = [along_u(0), along_u(rows), along_v(0), along_v(columns)];
        sides.extend(patch.sides().into_iter().zip(vertices).filter(|(points, _)| *points != [points[0]; 4]));
        base += grid.vertex_count();
    }
    sides
}
