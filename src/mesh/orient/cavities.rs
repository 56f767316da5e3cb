//! Cavities that are a mesh of their own: closed surfaces that face inwards, inside of what another mesh encloses.
//!
//! A mesh alone does not tell them from surfaces that are inside out. Where meshes stand in the world does, by a winding
//! number: each closed surface round a place adds 1 to it if it faces outwards and −1 if it faces inwards. Where it is
//! positive there is matter, and what faces inwards there is the wall of a cavity.
//!
//! A point of such a surface goes through the world into the space of whatever mesh stands there, and its ray is cast in
//! that space, with a bound on what the way has rounded. So no mesh is ever copied, and maps that mirror are no matter:
//! inside stays inside.
//!
//! Within a cavity of this kind, as in a [room](super::rooms), there is air: what stands there in the same mesh is deeper
//! by one than its mesh alone tells.

use super::Orientations;
use super::nesting::{Place, Walls};
use super::probe::{Probe, probes};
use super::rooms::{Role, Shell, roles};
use crate::mesh::box_tree::{Bounds, BoxTree};
use crate::mesh::{Mesh, Topology, Weld, normal_matrix};
use glam::{DMat3, DMat4, DVec3};
use rayon::prelude::*;
use std::ops::ControlFlow;

/// What all searches for boxes round a point may cost together, and each alone; beyond, a surface is judged by its mesh
/// alone.
const BOX_BUDGET: (usize, usize) = (1 << 24, 1 << 14);

/// A mesh and where it stands.
pub(crate) struct Placed<'a> {
    pub(crate) mesh: &'a Mesh,
    /// From its own space to that of the world, once for each time that it is there.
    pub(crate) places: Vec<DMat4>,
}

/// For each mesh the components that face inwards, although their own mesh gives no reason for it, and are right so: everywhere that the mesh stands they lie inside of what the meshes that stand elsewhere enclose. Places that
/// flatten a mesh do not count.
///
/// Surfaces that would be turned round are taken to be turned, from the outermost to the innermost: a cavity of what is
/// inside out is a cavity.
pub(crate) fn cavities(parts: &[Placed<'_>], weld: Weld) -> Vec<Vec<usize>> {
    if parts.iter().map(|part| part.places.len()).sum::<usize>() < 2 {
        return vec![Vec::new(); parts.len()];
    }
    let solids: Vec<Solid> = parts.par_iter().map(|part| Solid::new(part.mesh, weld)).collect();
    let stands = stands(parts);
    let mut states: Vec<State<'_>> = solids.iter().map(|solid| State::new(&solid.shells)).collect();
    let mut enclosed = enclosed(parts, &solids, &stands);
    // What lies round another at one place has less round itself there, in its own mesh or in others.
    enclosed.sort_by_key(|it| (it.places.iter().map(Vec::len).max(), it.depth, it.part, it.shell));
    let mut hollows = vec![Vec::new(); parts.len()];
    for Enclosed { part, shell, places, .. } in enclosed {
        let own = &solids[part].shells[shell];
        if own.is_in_matter(&states[part].is_air) == Some(true) {
            continue;
        }
        // Solids and cavities round it in its own mesh are as many; what else is air there takes away from what others add.
        let air = own.air_round(&states[part].is_air) as i32;
        let is_matter = |round: &Vec<(usize, usize)>| {
            round.iter().map(|&(part, shell)| states[part].sign(shell)).sum::<i32>() > air
        };
        let is_hollow = !places.is_empty() && places.iter().all(is_matter);
        if is_hollow {
            hollows[part].push(own.component);
        }
        states[part].is_air[shell] = is_hollow || own.seems_room;
        states[part].is_turned[shell] = !states[part].is_air[shell];
    }
    hollows.iter_mut().for_each(|components| components.sort_unstable());
    hollows
}

/// The closed components of a mesh.
struct Solid {
    orientations: Orientations,
    shells: Vec<Shell>,
}

impl Solid {
    fn new(mesh: &Mesh, weld: Weld) -> Self {
        let orientations = Orientations::new(mesh, &Topology::build(mesh, weld));
        let shells = orientations.shells(mesh);
        Self { orientations, shells }
    }

    fn faces(&self, shell: usize) -> &[u32] {
        self.orientations.components.faces(self.shells[shell].component)
    }

    fn walls<'a>(&self, mesh: &'a Mesh) -> Walls<'a> {
        let faces: Vec<&[u32]> = (0..self.shells.len()).map(|shell| self.faces(shell)).collect();
        let all: Vec<u32> = (0..faces.len() as u32).collect();
        Walls::new(mesh, self.orientations.components.against(), &faces, &all)
    }
}

/// What is known of the shells of a mesh so far.
struct State<'a> {
    shells: &'a [Shell],
    /// Whether there is air within, although it lies in an even number of others of its mesh that have none.
    is_air: Vec<bool>,
    /// Whether it is inside out.
    is_turned: Vec<bool>,
}

impl<'a> State<'a> {
    fn new(shells: &'a [Shell]) -> Self {
        let is_air = roles(shells, &[]).into_iter().map(|role| role == Role::Room).collect();
        Self { shells, is_air, is_turned: vec![false; shells.len()] }
    }

    /// What a shell adds to the winding number inside of it once its mesh is mended; what is in question adds what it
    /// does as it is.
    fn sign(&self, shell: usize) -> i32 {
        let is_inward = match &self.shells[shell] {
            it if it.is_inward => !self.is_turned[shell],
            it => it.is_in_matter(&self.is_air) == Some(true),
        };
        if is_inward { -1 } else { 1 }
    }
}

/// A mesh at a place.
struct Stand {
    part: usize,
    world_from_part: DMat4,
    part_from_world: DMat4,
    /// In the world.
    bounds: Bounds,
}

fn stands(parts: &[Placed<'_>]) -> Vec<Stand> {
    let stand = |part: usize, world_from_part: DMat4| {
        let (low, high) = parts[part].mesh.bounds()?;
        normal_matrix(DMat3::from_mat4(world_from_part))?;
        let part_from_world = world_from_part.inverse();
        let corners = (0..8).map(|corner| {
            let is_high = |axis: u32| corner >> axis & 1 == 1;
            let pick = |axis: usize| if is_high(axis as u32) { high[axis] } else { low[axis] };
            world_from_part.transform_point3(DVec3::from_array([0, 1, 2].map(pick)))
        });
        let bounds = Bounds::of(corners);
        let is_finite = part_from_world.is_finite() && bounds.low.is_finite() && bounds.high.is_finite();
        is_finite.then_some(Stand { part, world_from_part, part_from_world, bounds })
    };
    let all = parts.iter().enumerate().flat_map(|(part, it)| it.places.iter().map(move |&map| (part, map)));
    all.filter_map(|(part, map)| stand(part, map)).collect()
}

impl Stand {
    /// A point of a mesh that stands elsewhere, in the space of this one.
    fn seen_from_here(&self, there: &Stand, probe: &Probe) -> Probe {
        let map = |matrix: &DMat4| (DMat3::from_mat4(*matrix), matrix.w_axis.truncate());
        let (to_world, far) = map(&there.world_from_part);
        let (back, near) = map(&self.world_from_part);
        let world = there.world_from_part.transform_point3(probe.at);
        let at = self.part_from_world.transform_point3(world);
        // How far the way back misses the point in the world, and what that way and the one there may have rounded: three
        // products and three sums each.
        let missed = (self.world_from_part.transform_point3(at) - world).abs();
        let rounded = 4.0
            * f64::EPSILON
            * (to_world.abs() * probe.at.abs()
                + far.abs()
                + back.abs() * at.abs()
                + near.abs()
                + 2.0 * world.abs());
        let off = missed + rounded + to_world.abs() * DVec3::splat(probe.blur);
        let blur = (DMat3::from_mat4(self.part_from_world).abs() * off).max_element();
        // The inverse is rounded itself, which is no larger than what it is applied to.
        Probe { at, blur: 2.0 * blur }
    }
}

/// A shell in question, and which others lie round it wherever it stands, each as its part and its number there. No places
/// if that cannot be told.
struct Enclosed {
    part: usize,
    shell: usize,
    /// In how many others of its mesh it lies.
    depth: Option<u32>,
    places: Vec<Vec<(usize, usize)>>,
}

/// Where a shell stands, and which meshes have it in their boxes there.
type Boxes = Vec<(usize, Vec<u32>)>;

fn enclosed(parts: &[Placed<'_>], solids: &[Solid], stands: &[Stand]) -> Vec<Enclosed> {
    let in_question = |part: usize| {
        let shells = solids[part].shells.iter().enumerate();
        shells.filter(|(_, shell)| shell.is_in_question()).map(move |(shell, _)| (part, shell))
    };
    let questions: Vec<(usize, usize)> = (0..parts.len()).flat_map(in_question).collect();
    let mut stands_of = vec![Vec::new(); parts.len()];
    stands.iter().enumerate().for_each(|(number, stand)| stands_of[stand.part].push(number));
    let count: usize = questions.iter().map(|&(part, _)| stands_of[part].len()).sum();
    let tree = BoxTree::build(stands.len(), |stand| stands[stand as usize].bounds);
    let budget = (BOX_BUDGET.0 / count.max(1)).min(BOX_BUDGET.1);
    // For each place of a shell the meshes whose boxes it is in; none at all if one of its places is in none.
    let boxes: Vec<Boxes> = questions
        .par_iter()
        .map(|&(part, shell)| {
            let face = solids[part].faces(shell)[0];
            let vertex = parts[part].mesh.faces().face(face as usize)[0];
            let point = parts[part].mesh.positions()[vertex as usize];
            let round = |&own: &usize| {
                let at = stands[own].world_from_part.transform_point3(point);
                Some((own, boxes_round(&tree, stands, own, at, budget).filter(|round| !round.is_empty())?))
            };
            stands_of[part].iter().map(round).collect::<Option<Vec<_>>>().unwrap_or_default()
        })
        .collect();
    let mut is_entered = vec![false; parts.len()];
    let entered = boxes.iter().flatten().flat_map(|(_, round)| round);
    entered.for_each(|&stand| is_entered[stands[stand as usize].part] = true);
    let walls: Vec<Option<Walls<'_>>> =
        (0..parts.len()).map(|part| is_entered[part].then(|| solids[part].walls(parts[part].mesh))).collect();
    let rays = boxes.iter().flatten().map(|(_, round)| 24 * round.len()).sum();
    let budget = Walls::budget(walls.iter().flatten(), rays);
    let places = |(&(part, shell), boxes): (&(usize, usize), &Boxes)| {
        let probes = probes(parts[part].mesh, solids[part].faces(shell), 1.0);
        let round = |(own, round): &(usize, Vec<u32>)| -> Option<Vec<(usize, usize)>> {
            let mut found = Vec::new();
            for stand in round.iter().map(|&stand| &stands[stand as usize]) {
                let walls = walls[stand.part].as_ref().expect("built for all that are entered");
                let scaled = |Probe { at, blur }| Probe { at: at * walls.scale, blur: blur * walls.scale };
                let seen = |probe: &Probe| scaled(stand.seen_from_here(&stands[*own], probe));
                let probes = probes.iter().map(seen);
                let shells = walls.round_all(None, &probes.collect::<Vec<_>>(), budget, |_| true)?;
                // What lies on another surface everywhere is not within it.
                let within = shells.into_iter().filter(|&(_, place)| place == Place::Inside);
                found.extend(within.map(|(shell, _)| (stand.part, shell as usize)));
            }
            Some(found)
        };
        let places = boxes.iter().map(round).collect::<Option<Vec<_>>>().unwrap_or_default();
        let depth = solids[part].shells[shell].nest.as_ref().map(|nest| nest.depth);
        Enclosed { part, shell, depth, places }
    };
    questions.par_iter().zip(&boxes).map(places).collect()
}

/// The meshes that stand elsewhere and have a point in their box; `None` if the budget did not reach.
fn boxes_round(
    tree: &BoxTree,
    stands: &[Stand],
    own: usize,
    at: DVec3,
    mut budget: usize,
) -> Option<Vec<u32>> {
    let point = Bounds { low: at, high: at };
    let mut found = Vec::new();
    let enough = tree.visit(
        &mut budget,
        |node| node.contains(point),
        |stand| {
            let is_round = stand as usize != own && stands[stand as usize].bounds.contains(point);
            found.extend(is_round.then_some(stand));
            ControlFlow::Continue(())
        },
    );
    found.sort_unstable();
    enough.then_some(found)
}
