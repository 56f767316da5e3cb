//! Closed surfaces: the sign of their volume, and those that face inwards, as rooms and cavities.
//!
//! By its faces alone a room is a solid that is inside out, and its contents, facing outwards, are inverted cavities.
//! Stored normals distinguish them. A surface seems to be a room if it faces inwards, most of its normals point inwards as
//! well, and of the surfaces directly in it, by their normals, or by their faces if they have none, at least half point
//! outwards. Read as a solid, the surface itself and each content that points outwards is wrong; read as a room, each
//! content that points inwards, which are fewer.
//!
//! An empty room is reversed as a surface that is inside out. A hollow solid with all faces *and* normals inverted cannot be
//! distinguished from a room with contents.

use super::components::Components;
use super::nesting::{Nest, face_bounds, nests};
use crate::mesh::box_tree::Bounds;
use crate::mesh::face_normals::normals_oppose;
use crate::mesh::polygon_mesh::Mesh;
use crate::mesh::transform::permanent;
use crate::num::parallel;
use crate::num::{CompensatedSum, unit_scale};
use glam::DVec3;

/// A closed component with a volume.
pub(super) struct Shell {
    pub(super) component: usize,
    /// Whether the faces that run with its lowest one face outwards.
    pub(super) outward: bool,
    pub(super) is_inward: bool,
    /// The shells around it in its mesh; those that face inwards are marked. `None` if undetermined.
    pub(super) nest: Option<Nest>,
    /// Whether it is a room, unless it is a cavity.
    pub(super) seems_room: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It should face outwards.
    Solid,
    /// It should face inwards, as the wall of a cavity.
    Cavity,
    /// It faces inwards, and is right.
    Room,
    Unknown,
}

impl Shell {
    /// Whether it lies in the matter of its own mesh, if some of the shells contain air.
    pub(super) fn is_in_matter(&self, is_air: &[bool]) -> Option<bool> {
        let nest = self.nest.as_ref()?;
        Some((nest.depth - self.air_around(is_air)) % 2 == 1)
    }

    /// Whether it faces inwards, and its own mesh may give no reason for it.
    pub(super) fn is_in_question(&self) -> bool {
        let may_be = |nest: &Nest| nest.depth.is_multiple_of(2) || !nest.marked.is_empty();
        self.is_inward && self.nest.as_ref().is_some_and(may_be)
    }

    /// How many shells around it contain air, although by their depth they would be solid.
    pub(super) fn air_around(&self, is_air: &[bool]) -> u32 {
        self.nest.iter().flat_map(|nest| &nest.marked).map(|&shell| u32::from(is_air[shell as usize])).sum()
    }
}

/// Those of the closed components that have a volume, ascending.
pub(super) fn shells(mesh: &Mesh, components: &Components, closed: &[usize]) -> Vec<Shell> {
    let against = &components.against;
    let shell = |i: usize| {
        let component = closed[i];
        let faces = components.faces(component);
        let outward = faces_outward(mesh, faces, against, face_bounds(mesh, faces))?;
        let is_inward = components.is_majority(component, components.side(component, outward).count());
        Some(Shell { component, outward, is_inward, nest: None, seems_room: false })
    };
    let mut shells = parallel::filter_map(closed.len(), shell);
    let faces: Vec<&[u32]> = shells.iter().map(|shell| components.faces(shell.component)).collect();
    let is_inward: Vec<bool> = shells.iter().map(|shell| shell.is_inward).collect();
    let nests = nests(mesh, against, &faces, &is_inward);
    shells.iter_mut().zip(nests).for_each(|(shell, nest)| shell.nest = nest);
    for room in rooms(mesh, components, &shells) {
        shells[room as usize].seems_room = true;
    }
    shells
}

fn rooms(mesh: &Mesh, components: &Components, shells: &[Shell]) -> Vec<u32> {
    if mesh.columns().normals.is_none() {
        return Vec::new();
    }
    // Each marked shell with each shell directly in it.
    let mut within: Vec<(u32, u32)> = Vec::new();
    for (number, shell) in shells.iter().enumerate() {
        let Some(nest) = &shell.nest else { continue };
        let is_direct = |around: &u32| {
            shells[*around as usize].nest.as_ref().is_some_and(|it| it.depth + 1 == nest.depth)
        };
        within.extend(nest.marked.iter().copied().filter(is_direct).map(|around| (around, number as u32)));
    }
    within.sort_unstable();
    let points_inward = |shell: u32| {
        let Shell { component, outward, .. } = shells[shell as usize];
        let against = &components.against;
        let faces = components.faces(component).iter();
        normals_oppose(mesh, faces.map(|&face| (face, against[face as usize] == outward)))
    };
    let is_room = |contents: &[(u32, u32)]| {
        let inward =
            |&&(_, shell): &&(u32, u32)| points_inward(shell).unwrap_or(shells[shell as usize].is_inward);
        points_inward(contents[0].0) == Some(true)
            && 2 * contents.iter().filter(inward).count() <= contents.len()
    };
    let rooms: Vec<&[(u32, u32)]> = within.chunk_by(|a, b| a.0 == b.0).collect();
    parallel::filter_map(rooms.len(), |i| is_room(rooms[i]).then_some(rooms[i][0].0))
}

/// The role of each shell, if some components, ascending, are known to be [cavities](super::cavities::cavities) of another
/// mesh.
pub(super) fn roles(shells: &[Shell], cavities: &[usize]) -> Vec<Role> {
    let mut is_air: Vec<bool> =
        shells.iter().map(|shell| cavities.binary_search(&shell.component).is_ok()).collect();
    let mut outermost_first: Vec<usize> =
        (0..shells.len()).filter(|&shell| shells[shell].seems_room).collect();
    outermost_first.sort_by_key(|&shell| shells[shell].nest.as_ref().map(|nest| nest.depth));
    let mut is_room = vec![false; shells.len()];
    for shell in outermost_first {
        is_room[shell] = !is_air[shell] && shells[shell].is_in_matter(&is_air) == Some(false);
        is_air[shell] |= is_room[shell];
    }
    let role = |(number, shell): (usize, &Shell)| match shell.is_in_matter(&is_air) {
        None => Role::Unknown,
        Some(_) if is_room[number] => Role::Room,
        Some(false) if !is_air[number] => Role::Solid,
        Some(_) => Role::Cavity,
    };
    shells.iter().enumerate().map(role).collect()
}

/// Whether a closed component faces outwards, once its faces agree with its lowest one. `None` if the volume is not above
/// its rounding error (a flat component), or not above the part that depends on how non-planar polygons are triangulated
/// (a sheet with two sides).
///
/// The volume is the sum of the tetrahedra between the faces and the middle of the component's box, in units of the box's
/// size, so that neither size nor distance from the origin matters.
fn faces_outward(mesh: &Mesh, faces: &[u32], against: &[bool], bounds: Bounds) -> Option<bool> {
    /// Faces of a task; fixed, so that partial sums do not depend on the number of threads.
    const BLOCK: usize = 1 << 13;
    let middle = bounds.middle();
    let scale = unit_scale((bounds.high - middle).max(middle - bounds.low).max_element());
    let place = |vertex: u32| (mesh.position(vertex) - middle) * scale;
    let sums = parallel::blocks(faces.len(), BLOCK, |block| {
        let mut sums = Sums::default();
        for &face in &faces[block] {
            let sign = if against[face as usize] { -1.0 } else { 1.0 };
            for triangle in mesh.faces().fan(face) {
                let [a, b, c] = triangle.map(place);
                sums.volume += sign * a.dot(b.cross(c));
                let area = sign * (b - a).cross(c - a);
                sums.area.iter_mut().zip(area.to_array()).for_each(|(sum, term)| *sum += term);
                sums.magnitude += permanent(a, b, c);
            }
            let corners = mesh.faces().face(face as usize);
            for quad in corners[1..].windows(3) {
                let [a, b, c, d] = [corners[0], quad[0], quad[1], quad[2]].map(place);
                sums.between_cuts += (b - a).dot((c - a).cross(d - a)).abs();
            }
        }
        sums
    });
    let mut total = Sums::default();
    sums.into_iter().for_each(|sums| total.merge(sums));
    total.sign()
}

/// Sums over the triangles of a surface, relative to a point inside its box and in units of that box.
#[derive(Default)]
struct Sums {
    /// Six times the volume.
    volume: CompensatedSum,
    /// Twice the vector area: zero for a surface without gaps.
    area: [CompensatedSum; 3],
    /// Six times the volume with all products counted as positive; rounding errors are proportional to it.
    magnitude: f64,
    /// Six times the volume between both ways to cut polygons along a diagonal.
    between_cuts: f64,
}

impl Sums {
    fn merge(&mut self, other: Sums) {
        self.volume += other.volume;
        self.area.iter_mut().zip(other.area).for_each(|(sum, term)| *sum += term);
        self.magnitude += other.magnitude;
        self.between_cuts += other.between_cuts;
    }

    fn sign(&self) -> Option<bool> {
        // Three rounded differences, two products and three sums: 8 roundings of ε/2 to first order; twice that.
        let rounding = 8.0 * f64::EPSILON * self.magnitude;
        // If edges meet only within the welding distance, the volume depends on the reference point, which could be
        // any other of the box, which is less than 2 wide.
        let gaps = 2.0 * 3f64.sqrt() * DVec3::from(self.area.map(CompensatedSum::value)).length();
        let volume = self.volume.value();
        (volume.abs() > rounding + gaps + self.between_cuts).then_some(volume > 0.0)
    }
}
