//! Closed surfaces that face inwards: rooms and cavities.
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
use super::volume::faces_outward;
use crate::mesh::face_normals::normals_oppose;
use crate::mesh::polygon_mesh::Mesh;
use rayon::prelude::*;

/// A closed component with a volume.
pub(super) struct Shell {
    pub(super) component: usize,
    /// Whether the faces that run with its lowest one face outwards.
    pub(super) outward: bool,
    /// Whether most of its faces face inwards.
    pub(super) is_inward: bool,
    /// The shells around it in its mesh; those that face inwards are marked. `None` if undetermined.
    pub(super) nest: Option<Nest>,
    /// Whether it is a room, unless it is a cavity.
    pub(super) seems_room: bool,
}

/// The role of a shell in its mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It should face outwards.
    Solid,
    /// It should face inwards, as the wall of a cavity.
    Cavity,
    /// It faces inwards, and should.
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
    let against = components.against();
    let shell = |&component: &usize| {
        let faces = components.faces(component);
        let outward = faces_outward(mesh, faces, against, face_bounds(mesh, faces))?;
        let is_inward = components.is_majority(component, components.side(component, outward).count());
        Some(Shell { component, outward, is_inward, nest: None, seems_room: false })
    };
    let mut shells: Vec<Shell> = closed.par_iter().filter_map(shell).collect();
    let faces: Vec<&[u32]> = shells.iter().map(|shell| components.faces(shell.component)).collect();
    let is_inward: Vec<bool> = shells.iter().map(|shell| shell.is_inward).collect();
    let nests = nests(mesh, against, &faces, &is_inward);
    shells.iter_mut().zip(nests).for_each(|(shell, nest)| shell.nest = nest);
    for room in rooms(mesh, components, &shells) {
        shells[room as usize].seems_room = true;
    }
    shells
}

/// The shells that seem to be rooms.
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
        let against = components.against();
        let faces = components.faces(component).iter();
        normals_oppose(mesh, faces.map(|&face| (face, against[face as usize] == outward)))
    };
    let is_room = |contents: &&[(u32, u32)]| {
        let inward =
            |&&(_, shell): &&(u32, u32)| points_inward(shell).unwrap_or(shells[shell as usize].is_inward);
        points_inward(contents[0].0) == Some(true)
            && 2 * contents.iter().filter(inward).count() <= contents.len()
    };
    let rooms: Vec<&[(u32, u32)]> = within.chunk_by(|a, b| a.0 == b.0).collect();
    rooms.into_par_iter().filter(is_room).map(|contents| contents[0].0).collect()
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
