//! How deep closed surfaces lie inside each other.
//!
//! A shell lies in another if its box does and all of a few points spread over it do. A point lies in a shell if
//! the ray from it upwards (+z) leaves the shell once more than it enters, or once less. The faces that a ray may
//! meet are found in a [`BoxTree`]; every decision is taken with a bound on its rounding error, and points that
//! lie too close to a surface for that have no say.
//!
//! Work is n log n in faces, apart from the triangles that rays meet. Surfaces made so that every ray meets most
//! triangles would be quadratic: each ray has a budget, and a shell with a ray that used it up is undecided.

use super::probe::{Probe, probes};
use crate::mesh::Mesh;
use crate::mesh::box_tree::{Bounds, BoxTree};
use crate::num::unit_scale;
use rayon::prelude::*;
use std::ops::ControlFlow;

/// What a search for boxes round a box may cost; beyond, it is taken to have been successful.
const BOX_BUDGET: usize = 512;

/// What all rays together may cost, shared out evenly: so much, and so much for each triangle. A ray through
/// a million triangles of well-shaped shells costs some hundreds.
const RAY_BUDGET: (usize, usize) = (1 << 26, 256);

/// What a shell lies in.
#[derive(Clone, Default)]
pub(super) struct Nest {
    /// In how many others of its mesh.
    pub(super) depth: u32,
    /// Those among them that are marked, ascending.
    pub(super) marked: Vec<u32>,
}

/// What each shell lies in; `None` where that cannot be told. Shells are closed components, as lists of faces, some
/// of them marked; `against` tells which faces run against the others of their shell.
pub(super) fn depths(
    mesh: &Mesh,
    against: &[bool],
    shells: &[&[u32]],
    is_marked: &[bool],
) -> Vec<Option<Nest>> {
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
        return vec![Some(Nest::default()); shells.len()];
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
    let budget = Walls::budget(std::iter::once(&walls), rays);
    let nest = |shell: usize| {
        if !inner[shell] {
            return Some(Nest::default());
        }
        let round = walls.shells_round(shell as u32, shells[shell], &bounds, budget)?;
        let marked = round.iter().copied().filter(|&other| is_marked[other as usize]).collect();
        Some(Nest { depth: round.len() as u32, marked })
    };
    (0..shells.len()).into_par_iter().map(nest).collect()
}

/// The box of some faces.
pub(super) fn face_bounds(mesh: &Mesh, faces: &[u32]) -> Bounds {
    let corners = faces.iter().flat_map(|&face| mesh.faces().face(face as usize));
    Bounds::of(corners.map(|&vertex| mesh.positions()[vertex as usize]))
}

/// Whether a tree has an item that `hits`, or the search became too long.
fn finds(tree: &BoxTree, enter: impl Fn(Bounds) -> bool, hits: impl Fn(u32) -> bool) -> bool {
    let mut hit = false;
    let enough = tree.visit(&mut { BOX_BUDGET }, enter, |item| {
        hit = hits(item);
        if hit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    hit || !enough
}

/// The triangles that rays can meet.
pub(super) struct Walls<'a> {
    mesh: &'a Mesh,
    /// The shell and the vertices of each; all of a shell agree.
    triangles: Vec<(u32, [u32; 3])>,
    tree: BoxTree,
    /// Brings all coordinates below 1, so that differences stay in range.
    pub(super) scale: f64,
}

/// Where a point, or a shell, lies as to another shell, if not outside.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Place {
    Inside,
    TooClose,
}

impl<'a> Walls<'a> {
    /// Those of some shells, the `outer` ones.
    pub(super) fn new(mesh: &'a Mesh, against: &[bool], shells: &[&[u32]], outer: &[u32]) -> Self {
        let fan = |face: u32| {
            let corners = mesh.faces().face(face as usize);
            let against = against[face as usize];
            corners[1..].windows(2).map(move |edge| {
                let [a, b] = if against { [edge[1], edge[0]] } else { [edge[0], edge[1]] };
                [corners[0], a, b]
            })
        };
        let triangles: Vec<(u32, [u32; 3])> = outer
            .iter()
            .flat_map(|&shell| shells[shell as usize].iter().map(move |&face| (shell, face)))
            .flat_map(|(shell, face)| fan(face).map(move |triangle| (shell, triangle)))
            .collect();
        let largest = mesh.bounds().map_or(0.0, |(low, high)| low.abs().max(high.abs()).max_element());
        let scale = unit_scale(largest);
        let tree = BoxTree::build(triangles.len(), |item| {
            let (_, triangle) = triangles[item as usize];
            Bounds::of(triangle.iter().map(|&vertex| scale * mesh.positions()[vertex as usize]))
        });
        Self { mesh, triangles, tree, scale }
    }

    /// What each of so many rays may cost.
    pub(super) fn budget<'w>(walls: impl Iterator<Item = &'w Self>, rays: usize) -> usize
    where
        'a: 'w,
    {
        let triangles: usize = walls.map(|walls| walls.triangles.len()).sum();
        (RAY_BUDGET.0 + RAY_BUDGET.1 * triangles) / rays.max(1)
    }

    /// The others that a shell lies in, ascending.
    fn shells_round(&self, shell: u32, faces: &[u32], bounds: &[Bounds], budget: usize) -> Option<Vec<u32>> {
        let probes = probes(self.mesh, faces, self.scale);
        let own = bounds[shell as usize];
        let round =
            self.round_all(Some(shell), &probes, budget, |other| bounds[other as usize].contains(own))?;
        round.into_iter().map(|(other, place)| (place == Place::Inside).then_some(other)).collect()
    }

    /// The wanted shells that all points of a surface lie in, or that all of them lie too close to, other than the one
    /// that they are points of. Points are scaled as the walls are. `None` if the budget of a ray did not reach.
    pub(super) fn round_all(
        &self,
        own: Option<u32>,
        probes: &[Probe],
        budget: usize,
        is_wanted: impl Fn(u32) -> bool,
    ) -> Option<Vec<(u32, Place)>> {
        let mut places: Vec<(u32, Place)> = Vec::new();
        for probe in probes {
            let mut round = self.round(own, probe, budget)?;
            round.retain(|&(other, _)| is_wanted(other));
            if round.is_empty() {
                return Some(Vec::new());
            }
            places.extend(round);
        }
        places.sort_unstable_by_key(|&(other, _)| other);
        let all = places.chunk_by(|a, b| a.0 == b.0).filter_map(|of_shell| {
            // A shell that a probe lies outside of is missing from the list of that probe.
            let is_close = of_shell.iter().all(|(_, place)| *place == Place::TooClose);
            let place = if is_close { Place::TooClose } else { Place::Inside };
            (of_shell.len() == probes.len()).then_some((of_shell[0].0, place))
        });
        Some(all.collect())
    }

    /// The other shells that a point lies in or too close to; `None` if the budget did not reach.
    fn round(&self, own: Option<u32>, probe: &Probe, mut budget: usize) -> Option<Vec<(u32, Place)>> {
        let at = probe.at;
        let reach = |node: Bounds| {
            let (low, high) = (node.low - probe.blur, node.high + probe.blur);
            low.x <= at.x && at.x <= high.x && low.y <= at.y && at.y <= high.y && at.z <= high.z
        };
        let mut crossings: Vec<(u32, Option<i32>)> = Vec::new();
        let enough = self.tree.visit(&mut budget, reach, |item| {
            let (shell, triangle) = self.triangles[item as usize];
            if Some(shell) != own {
                let [a, b, c] = triangle.map(|vertex| self.scale * self.mesh.positions()[vertex as usize]);
                let crossing = probe.crossing(a, b, c);
                crossings.extend((crossing != Some(0)).then_some((shell, crossing)));
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
