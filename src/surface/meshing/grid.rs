//! Grids of parameters, and joining the grids of neighbouring patches.

use crate::mesh::DisjointSets;
use crate::num::parallel;
use crate::surface::error::{MOST_CELLS, Result, check_count};
use crate::surface::meshing::net::{Net, sample};
use crate::surface::meshing::pattern::{GridHash, Pattern, Tessellation};
use crate::surface::shapes::bezier::BezierPatch;
use crate::surface::shapes::chart::{Chart, Parametric, Sample};
use glam::{DVec2, DVec3};

/// Grids on charts, one after the other, not joined.
pub(crate) fn net(charts: &[&dyn Parametric], tessellation: &Tessellation) -> Result<Net> {
    let mut net = Net::default();
    for (part, chart) in charts.iter().enumerate() {
        let grid = Grid::new(chart.chart(), tessellation, part as u32);
        grid.check(charts.len() as u64)?;
        let base = net.samples.len() as u32;
        let places = grid.places();
        let samples = parallel::map_each(&places, |&(i, j)| sample(*chart, grid.parameters(i, j)));
        net.samples.extend(samples.into_iter().collect::<Result<Vec<Sample>>>()?);
        net.first_faces.push(net.faces.len());
        for (i, j) in (0..grid.segments[1]).flat_map(|j| (0..grid.segments[0]).map(move |i| (i, j))) {
            grid.cut(i, j, &mut |corners| {
                let mut vertices = [0; 4];
                vertices.iter_mut().zip(corners).for_each(|(slot, corner)| *slot = base + corner.vertex);
                net.push(&vertices[..corners.len()], corners.iter().map(|corner| corner.parameters));
            });
        }
    }
    Ok(net)
}

#[derive(Clone, Copy)]
struct Corner {
    vertex: u32,
    parameters: DVec2,
}

/// A grid over one chart. Vertex (i, j) is at u = i / segments, v = j / segments but for jitter, at the lower left of cell (i, j).
struct Grid {
    chart: Chart,
    segments: [u32; 2],
    jitter: f64,
    pattern: Pattern,
    hash: GridHash,
}

impl Grid {
    fn new(chart: Chart, tessellation: &Tessellation, part: u32) -> Self {
        let Tessellation { pattern, segments, jitter, seed, .. } = *tessellation;
        let segments = match pattern {
            Pattern::Stretched(ratio) => {
                let [u, v] = segments.map(f64::from);
                // The casts are safe: counts above `u32::MAX` saturate, and the check of counts then rejects them.
                [(u / ratio.sqrt()).round().max(1.0), (v * ratio.sqrt()).round()].map(|count| count as u32)
            }
            _ => segments,
        };
        Self { chart, segments, jitter, pattern, hash: GridHash { seed }.of_part(part) }
    }

    fn check(&self, charts: u64) -> Result<()> {
        let [u, v] = self.segments.map(u64::from);
        let Chart { wraps_u, wraps_v, pole_low, pole_high } = self.chart;
        let least = |wraps, poles| if wraps { 3 } else { 1 + u64::from(poles) };
        check_count("segments in the first direction", u, least(wraps_u, false)..=u64::MAX)?;
        check_count("segments in the second direction", v, least(wraps_v, pole_low && pole_high)..=u64::MAX)?;
        check_count("cells", u.saturating_mul(v).saturating_mul(charts), 0..=MOST_CELLS)
    }

    fn columns(&self) -> u32 {
        self.segments[0] + u32::from(!self.chart.wraps_u)
    }

    /// Whether a row of vertices is one point.
    fn is_pole(&self, j: u32) -> bool {
        self.chart.pole_low && j == 0 || self.chart.pole_high && j == self.segments[1]
    }

    fn places(&self) -> Vec<(u32, u32)> {
        let rows = self.segments[1] + u32::from(!self.chart.wraps_v);
        let columns = |j: u32| if self.is_pole(j) { 1 } else { self.columns() };
        (0..rows).flat_map(|j| (0..columns(j)).map(move |i| (i, j))).collect()
    }

    fn vertex_count(&self) -> u32 {
        let last_row = self.segments[1] - u32::from(self.chart.wraps_v);
        let last_column = self.columns() - 1;
        self.vertex(last_column, last_row) + 1
    }

    fn vertex(&self, i: u32, j: u32) -> u32 {
        let i = if self.is_pole(j) { 0 } else { i % self.columns() };
        let j = if self.chart.wraps_v { j % self.segments[1] } else { j };
        match j {
            0 => i,
            _ if self.chart.pole_low => 1 + (j - 1) * self.columns() + i,
            _ => j * self.columns() + i,
        }
    }

    /// The parameters of a place. On the far side of a chart that wraps they are above 1.
    fn parameters(&self, i: u32, j: u32) -> DVec2 {
        let [columns, rows] = self.segments;
        let inside = |k: u32, count: u32, wraps: bool| wraps || (1..count).contains(&k);
        let moves = inside(i, columns, self.chart.wraps_u) && inside(j, rows, self.chart.wraps_v);
        let offset = match self.pattern {
            Pattern::Slivers(ratio) if j % 2 == 1 && j < rows => DVec2::new(0.0, 1.0 - 1.0 / ratio),
            _ if moves && self.jitter > 0.0 => {
                let (i, j) = (i % columns, j % rows);
                (DVec2::new(self.hash.at(i, j, 1), self.hash.at(i, j, 2)) - 0.5) * self.jitter
            }
            _ => DVec2::ZERO,
        };
        (DVec2::new(i.into(), j.into()) + offset) / DVec2::new(columns.into(), rows.into())
    }

    fn corner(&self, i: u32, j: u32) -> Corner {
        Corner { vertex: self.vertex(i, j), parameters: self.parameters(i, j) }
    }

    /// The pole at one end of a cell; its u is that of the cell's middle.
    fn pole(&self, i: u32, j: u32) -> Corner {
        let [columns, rows] = self.segments.map(f64::from);
        let parameters = DVec2::new((f64::from(i) + 0.5) / columns, f64::from(j) / rows);
        Corner { vertex: self.vertex(i, j), parameters }
    }

    fn cut(&self, i: u32, j: u32, face: &mut impl FnMut(&[Corner])) {
        let [a, b, c, d] = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| self.corner(i, j));
        if self.is_pole(j) {
            face(&[self.pole(i, j), c, d]);
        } else if self.is_pole(j + 1) {
            face(&[a, b, self.pole(i, j + 1)]);
        } else if self.pattern == Pattern::Quads {
            face(&[a, b, c, d]);
        } else if self.jitter == 0.0 || self.hash.at(i, j, 3) >= 0.5 {
            face(&[a, b, c]);
            face(&[a, c, d]);
        } else {
            face(&[a, b, d]);
            face(&[b, c, d]);
        }
    }
}

/// Merges the vertices on common sides of patches: sides with the same four control points, in either direction.
/// Patches that only touch stay separate. The vertex of the first patch remains; where patches meet smoothly, as in the
/// teapot, its normal is that of all.
pub(crate) fn join(net: &mut Net, patches: &[BezierPatch], tessellation: &Tessellation) {
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
        let lowest = sets.find(vertex);
        if lowest == vertex {
            number.push(kept.len() as u32);
            kept.push(net.samples[vertex as usize]);
        } else {
            number.push(number[lowest as usize]);
        }
    }
    net.samples = kept;
    let corners = net.faces.corners().iter().map(|&vertex| number[vertex as usize]).collect();
    net.faces = net.faces.with_corners(corners);
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
