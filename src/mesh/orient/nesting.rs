//! How deep closed surfaces lie inside each other.
//!
//! A shell lies in another if its box does and all of a few points spread over it do. A point lies in a shell if
//! the ray from it upwards (+z) leaves the shell once more than it enters, or once less. The faces that a ray may
//! meet are found in a [`BoxTree`]; every decision is taken with a bound on its rounding error, and points that
//! lie too close to a surface for that have no say.
//!
//! Work is linear in faces and n log n in shells, apart from the faces that rays meet. Surfaces made so that
//! every ray meets most faces would be quadratic; each ray has a budget, and a shell with a ray that used it up
//! is left undecided.

use super::box_tree::{Bounds, BoxTree};
use super::probe::{Probe, probes};
use crate::mesh::Mesh;
use crate::num::unit_scale;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// What a search for boxes round a box may cost; beyond, it is taken to have been successful.
const BOX_BUDGET: usize = 512;

/// What a ray may always cost.
const RAY_BUDGET: usize = 512;

/// What all rays together may cost beyond that, shared out evenly: about a second of work.
const SHARED_RAY_BUDGET: usize = 1 << 27;

/// In how many other shells each shell lies; `None` where that cannot be told. Shells are closed components, as
/// lists of faces; `against` tells which faces run against the others of their shell.
pub(super) fn depths(mesh: &Mesh, against: &[bool], shells: &[&[u32]]) -> Vec<Option<u32>> {
    let bounds: Vec<Bounds> = shells.par_iter().map(|faces| face_bounds(mesh, faces)).collect();
    let boxes = BoxTree::build(shells.len(), |shell| bounds[shell as usize]);
    let inner: Vec<bool> = (0..shells.len() as u32)
        .into_par_iter()
        .map(|shell| {
            let own = bounds[shell as usize];
            let round = |other: u32| other != shell && bounds[other as usize].contains(own);
            finds(&boxes, |node| node.contains(own), round)
        })
        .collect();
    let rays: usize = (0..shells.len()).filter(|&s| inner[s]).map(|s| 2 * shells[s].len().min(12)).sum();
    if rays == 0 {
        return vec![Some(0); shells.len()];
    }
    // Only shells that have a box in their own need to be searched for crossings.
    let outer: Vec<u32> = (0..shells.len() as u32)
        .into_par_iter()
        .filter(|&shell| {
            let own = bounds[shell as usize];
            let within = |other: u32| other != shell && own.contains(bounds[other as usize]);
            finds(&boxes, |node| node.overlaps(own), within)
        })
        .collect();
    let walls = Walls::new(mesh, against, shells, &outer);
    let budget = RAY_BUDGET + SHARED_RAY_BUDGET / rays;
    (0..shells.len())
        .into_par_iter()
        .map(|shell| if inner[shell] { walls.depth(shell as u32, &bounds, shells, budget) } else { Some(0) })
        .collect()
}

/// The box of some faces.
pub(super) fn face_bounds(mesh: &Mesh, faces: &[u32]) -> Bounds {
    let corners = faces.iter().flat_map(|&face| mesh.faces().face(face as usize));
    Bounds::of(corners.map(|&vertex| mesh.positions()[vertex as usize]))
}

/// Whether a tree has an item that `hits`, or the search became too long.
fn finds(tree: &BoxTree, enter: impl Fn(Bounds) -> bool, hits: impl Fn(u32) -> bool) -> bool {
    let mut hit = false;
    let enough = tree.visit(&mut { BOX_BUDGET }, enter, |item, _| {
        hit = hits(item);
        if hit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    hit || !enough
}

/// The faces that rays can meet.
struct Walls<'a> {
    mesh: &'a Mesh,
    against: &'a [bool],
    /// (face, shell) of every item of the tree.
    items: Vec<(u32, u32)>,
    tree: BoxTree,
    /// Brings all coordinates below 1, so that products of three stay in range.
    scale: f64,
}

/// Where a point lies as to one shell.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Place {
    Inside,
    TooClose,
}

impl<'a> Walls<'a> {
    fn new(mesh: &'a Mesh, against: &'a [bool], shells: &[&[u32]], outer: &[u32]) -> Self {
        let items: Vec<(u32, u32)> = outer
            .iter()
            .flat_map(|&shell| shells[shell as usize].iter().map(move |&face| (face, shell)))
            .collect();
        let largest = mesh.bounds().map_or(0.0, |(low, high)| low.abs().max(high.abs()).max_element());
        let scale = unit_scale(largest);
        let tree = BoxTree::build(items.len(), |item| {
            let Bounds { low, high } = face_bounds(mesh, &[items[item as usize].0]);
            Bounds { low: low * scale, high: high * scale }
        });
        Self { mesh, against, items, tree, scale }
    }

    fn depth(&self, shell: u32, bounds: &[Bounds], shells: &[&[u32]], budget: usize) -> Option<u32> {
        let probes = probes(self.mesh, shells[shell as usize], self.scale);
        let mut places: Vec<(u32, Place)> = Vec::new();
        for probe in &probes {
            places.extend(self.round(shell, probe, budget)?);
        }
        places.retain(|&(other, _)| bounds[other as usize].contains(bounds[shell as usize]));
        places.sort_unstable_by_key(|&(other, _)| other);
        let mut depth = 0;
        for of_shell in places.chunk_by(|a, b| a.0 == b.0) {
            // A shell that a probe lies outside of is missing from the list of that probe.
            let close = of_shell.iter().filter(|(_, place)| *place == Place::TooClose).count();
            if close == probes.len() {
                return None;
            }
            depth += u32::from(of_shell.len() == probes.len());
        }
        Some(depth)
    }

    /// The shells that a point lies in or too close to; `None` if the budget did not reach.
    fn round(&self, own: u32, probe: &Probe, mut budget: usize) -> Option<Vec<(u32, Place)>> {
        let mut crossings: Vec<(u32, Option<i32>)> = Vec::new();
        let at = probe.at;
        let reach = |node: Bounds| {
            let (low, high) = (node.low - probe.blur, node.high + probe.blur);
            low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y && at.z <= high.z
        };
        let enough = self.tree.visit(&mut budget, reach, |item, budget| {
            let (face, shell) = self.items[item as usize];
            if shell == own {
                return ControlFlow::Continue(());
            }
            let corners = self.mesh.faces().face(face as usize);
            *budget = budget.saturating_sub(corners.len() - 3);
            let place = |vertex: u32| self.mesh.positions()[vertex as usize] * self.scale;
            let sign = if self.against[face as usize] { -1 } else { 1 };
            for edge in corners[1..].windows(2) {
                let crossing = probe.crossing(place(corners[0]), place(edge[0]), place(edge[1]));
                if crossing != Some(0) {
                    crossings.push((shell, crossing.map(|crossing| crossing * sign)));
                }
            }
            ControlFlow::Continue(())
        });
        if !enough {
            return None;
        }
        crossings.sort_unstable();
        let places = crossings.chunk_by(|a, b| a.0 == b.0).filter_map(|of_shell| {
            let winding: Option<i32> = of_shell.iter().map(|&(_, crossing)| crossing).sum();
            match winding {
                None => Some((of_shell[0].0, Place::TooClose)),
                Some(0) => None,
                Some(_) => Some((of_shell[0].0, Place::Inside)),
            }
        });
        Some(places.collect())
    }
}
