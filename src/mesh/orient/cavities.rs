//! Cavities that are meshes of their own: closed surfaces that face inwards, inside of what another mesh encloses.
//!
//! A single mesh does not distinguish them from surfaces that are inside out. The placement of the meshes in the world does,
//! by a winding number: each closed surface around a point adds 1 to it if it faces outwards and −1 if it faces inwards. Where
//! it is positive there is matter, and a surface that faces inwards there is the wall of a cavity.
//!
//! A point of such a surface is mapped through the world into the space of each mesh around it, and its ray is cast in that
//! space, with a bound on the rounding of the maps. So no mesh is copied, and mirroring maps need no special case: inside
//! stays inside.
//!
//! A cavity of this kind contains air, like a [room](super::shells): shells in it in the same mesh are deeper by one than
//! their own mesh says.

use super::nesting::{Place, Probe, Walls, probes};
use super::policy::Orientations;
use super::shells::{Role, Shell, roles};
use crate::mesh::box_tree::{Bounds, BoxTree};
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::topology::Topology;
use crate::mesh::transform::normal_matrix;
use crate::mesh::weld::Weld;
use crate::num::parallel;
use glam::{DMat3, DMat4, DVec3};

/// Cost limit of all searches for boxes around a point together, and of each; beyond, a surface is judged by its own mesh.
const BOX_BUDGET: (usize, usize) = (1 << 24, 1 << 14);

/// A mesh with its placements.
pub(crate) struct Placed<'a> {
    pub(crate) mesh: &'a Mesh,
    /// From its own space to that of the world, one for each instance.
    pub(crate) places: Vec<DMat4>,
}

/// For each mesh the components that face inwards without a reason in their own mesh, and rightly so: at every placement
/// of the mesh they lie inside of what the other placed meshes enclose. Placements that flatten a mesh do not count.
///
/// Surfaces that would be reversed count as reversed, from the outermost to the innermost: a cavity of a surface that is
/// inside out is a cavity.
pub(crate) fn cavities(parts: &[Placed<'_>], weld: Weld) -> Vec<Vec<usize>> {
    if parts.iter().map(|part| part.places.len()).sum::<usize>() < 2 {
        return vec![Vec::new(); parts.len()];
    }
    let solids = parallel::map_each(parts, |part| Solid::new(part.mesh, weld));
    let mut states: Vec<State<'_>> = solids.iter().map(|solid| State::new(&solid.shells)).collect();
    let mut enclosed = enclosed(parts, &solids, &instances(parts));
    // A shell around another at one placement has less around itself there, in its own mesh or in others.
    enclosed.sort_by_key(|it| (it.places.iter().map(Vec::len).max(), it.depth, it.part, it.shell));
    let mut cavities = vec![Vec::new(); parts.len()];
    for Enclosed { part, shell, places, .. } in enclosed {
        let own = &solids[part].shells[shell];
        if own.is_in_matter(&states[part].is_air) == Some(true) {
            continue;
        }
        // Solids and cavities around it in its own mesh cancel; other air there takes away from what others add.
        let air = own.air_around(&states[part].is_air) as i32;
        let is_matter = |around: &Vec<(usize, usize)>| {
            around.iter().map(|&(part, shell)| states[part].sign(shell)).sum::<i32>() > air
        };
        let is_cavity = !places.is_empty() && places.iter().all(is_matter);
        if is_cavity {
            cavities[part].push(own.component);
        }
        states[part].is_air[shell] = is_cavity || own.seems_room;
        states[part].is_reversed[shell] = !states[part].is_air[shell];
    }
    cavities.iter_mut().for_each(|components| components.sort_unstable());
    cavities
}

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
        let shells = (0..self.shells.len()).map(|shell| (shell as u32, self.faces(shell)));
        Walls::new(mesh, &self.orientations.components.against, shells)
    }
}

struct State<'a> {
    shells: &'a [Shell],
    /// Whether it contains air, although it lies in an even number of other shells of its mesh that do not.
    is_air: Vec<bool>,
    is_reversed: Vec<bool>,
}

impl<'a> State<'a> {
    fn new(shells: &'a [Shell]) -> Self {
        let is_air = roles(shells, &[]).into_iter().map(|role| role == Role::Room).collect();
        Self { shells, is_air, is_reversed: vec![false; shells.len()] }
    }

    /// What a shell adds to the winding number inside of it once its mesh is oriented; undecided shells count as stored.
    fn sign(&self, shell: usize) -> i32 {
        let is_inward = match &self.shells[shell] {
            it if it.is_inward => !self.is_reversed[shell],
            it => it.is_in_matter(&self.is_air) == Some(true),
        };
        if is_inward { -1 } else { 1 }
    }
}

/// A mesh at one of its placements.
struct Instance {
    part: usize,
    world_from_part: DMat4,
    part_from_world: DMat4,
    /// In the world.
    bounds: Bounds,
}

fn instances(parts: &[Placed<'_>]) -> Vec<Instance> {
    let instance = |part: usize, world_from_part: DMat4| {
        let (low, high) = parts[part].mesh.bounds()?;
        normal_matrix(DMat3::from_mat4(world_from_part))?;
        let part_from_world = world_from_part.inverse();
        let bounds = Bounds::of((0..8).map(|corner| {
            let pick = |axis: usize| if corner >> axis & 1 == 1 { high[axis] } else { low[axis] };
            world_from_part.transform_point3(DVec3::from_array([0, 1, 2].map(pick)))
        }));
        let is_finite = part_from_world.is_finite() && bounds.low.is_finite() && bounds.high.is_finite();
        is_finite.then_some(Instance { part, world_from_part, part_from_world, bounds })
    };
    let all = parts.iter().enumerate().flat_map(|(part, it)| it.places.iter().map(move |&map| (part, map)));
    all.filter_map(|(part, map)| instance(part, map)).collect()
}

impl Instance {
    /// A point of another instance's mesh, in the space of this one's mesh.
    fn probe_from(&self, other: &Instance, probe: &Probe) -> Probe {
        let map = |matrix: &DMat4| (DMat3::from_mat4(*matrix), matrix.w_axis.truncate());
        let (to_world, far) = map(&other.world_from_part);
        let (back, near) = map(&self.world_from_part);
        let world = other.world_from_part.transform_point3(probe.at);
        let at = self.part_from_world.transform_point3(world);
        // How far the map back misses the point in the world, and the rounding of both maps: three products and three
        // sums each.
        let missed = (self.world_from_part.transform_point3(at) - world).abs();
        let (there, here) = (to_world.abs() * probe.at.abs() + far.abs(), back.abs() * at.abs() + near.abs());
        let rounded = 4.0 * f64::EPSILON * (there + here + 2.0 * world.abs());
        let off = missed + rounded + to_world.abs() * DVec3::splat(probe.blur);
        let blur = (DMat3::from_mat4(self.part_from_world).abs() * off).max_element();
        // The inverse is rounded itself, by no more than its argument is.
        Probe { at, blur: 2.0 * blur }
    }
}

/// A shell in question, with the shells around it at each placement, as pairs of part and shell. No places if they are
/// undetermined.
struct Enclosed {
    part: usize,
    shell: usize,
    /// In how many others of its mesh it lies.
    depth: Option<u32>,
    places: Vec<Vec<(usize, usize)>>,
}

/// The instances of a shell, each with the instances whose boxes contain it.
type Boxes = Vec<(usize, Vec<u32>)>;

fn enclosed(parts: &[Placed<'_>], solids: &[Solid], instances: &[Instance]) -> Vec<Enclosed> {
    let in_question = |part: usize| {
        let shells = solids[part].shells.iter().enumerate();
        shells.filter(|(_, shell)| shell.is_in_question()).map(move |(shell, _)| (part, shell))
    };
    let questions: Vec<(usize, usize)> = (0..parts.len()).flat_map(in_question).collect();
    let boxes = boxes_around(parts, solids, instances, &questions);
    let mut is_entered = vec![false; parts.len()];
    let entered = boxes.iter().flatten().flat_map(|(_, around)| around);
    entered.for_each(|&instance| is_entered[instances[instance as usize].part] = true);
    let walls: Vec<Option<Walls<'_>>> =
        (0..parts.len()).map(|part| is_entered[part].then(|| solids[part].walls(parts[part].mesh))).collect();
    let rays = boxes.iter().flatten().map(|(_, around)| 24 * around.len()).sum();
    let budget = Walls::budget(walls.iter().flatten(), rays);
    let places = |question: usize| {
        let ((part, shell), boxes) = (questions[question], &boxes[question]);
        let probes = probes(parts[part].mesh, solids[part].faces(shell), 1.0);
        let around = |(own, around): &(usize, Vec<u32>)| -> Option<Vec<(usize, usize)>> {
            let mut found = Vec::new();
            for instance in around.iter().map(|&instance| &instances[instance as usize]) {
                let walls = walls[instance.part].as_ref().expect("built for all that are entered");
                let mapped = probes.iter().map(|probe| {
                    let Probe { at, blur } = instance.probe_from(&instances[*own], probe);
                    Probe { at: at * walls.scale, blur: blur * walls.scale }
                });
                let shells = walls.shells_around(None, &mapped.collect::<Vec<_>>(), budget, |_| true)?;
                // A shell that lies on another surface everywhere is not within it.
                let within = shells.into_iter().filter(|&(_, place)| place == Place::Inside);
                found.extend(within.map(|(shell, _)| (instance.part, shell as usize)));
            }
            Some(found)
        };
        let places = boxes.iter().map(around).collect::<Option<Vec<_>>>().unwrap_or_default();
        let depth = solids[part].shells[shell].nest.as_ref().map(|nest| nest.depth);
        Enclosed { part, shell, depth, places }
    };
    parallel::map(questions.len(), places)
}

/// For each shell in question, as pair of part and shell, its instances with the other instances whose boxes contain it;
/// none at all if one of its instances is in no box or its search became too long.
fn boxes_around(
    parts: &[Placed<'_>],
    solids: &[Solid],
    instances: &[Instance],
    questions: &[(usize, usize)],
) -> Vec<Boxes> {
    let mut instances_of = vec![Vec::new(); parts.len()];
    instances.iter().enumerate().for_each(|(number, it)| instances_of[it.part].push(number));
    let count: usize = questions.iter().map(|&(part, _)| instances_of[part].len()).sum();
    let tree = BoxTree::build(instances.len(), &|instance| instances[instance as usize].bounds);
    let budget = (BOX_BUDGET.0 / count.max(1)).min(BOX_BUDGET.1);
    let boxes = |&(part, shell): &(usize, usize)| {
        let face = solids[part].faces(shell)[0];
        let vertex = parts[part].mesh.faces().face(face as usize)[0];
        let around = |&own: &usize| {
            let at = instances[own].world_from_part.transform_point3(parts[part].mesh.position(vertex));
            let point = Bounds { low: at, high: at };
            let mut found = Vec::new();
            let enough = tree.visit(
                &mut { budget },
                |node| node.contains(point),
                |other| {
                    let contains = other as usize != own && instances[other as usize].bounds.contains(point);
                    found.extend(contains.then_some(other));
                    true
                },
            );
            found.sort_unstable();
            (enough && !found.is_empty()).then_some((own, found))
        };
        instances_of[part].iter().map(around).collect::<Option<Vec<_>>>().unwrap_or_default()
    };
    parallel::map_each(questions, boxes)
}
