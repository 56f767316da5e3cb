//! What is air within closed surfaces that face inwards, and so does not count for what stands there.
//!
//! By its faces alone a room is a solid that is inside out, and what stands in it, facing outwards, a cavity of that, which is
//! inside out as well. Stored normals tell them apart. A surface seems to be a room if it faces inwards, most of its
//! normals point inwards as well, and of what stands directly in it, by its normals, or by its faces where it has none, at
//! least as much points outwards as inwards. Read as a solid, the surface itself and each thing that points outwards is
//! wrong; read as a room, each thing that points inwards, which then is less.
//!
//! Where nothing stands in it there is nothing to lose, and it is turned as what is inside out. A hollow solid of which all
//! faces *and* normals are turned cannot be told from a room with something in it.

use super::Orientations;
use super::nesting::{Nest, depths};
use super::volume::faces_outward;
use crate::mesh::side::normals_oppose;
use crate::mesh::{Mesh, orient::nesting::face_bounds};
use rayon::prelude::*;

/// A closed component with a volume.
pub(super) struct Shell {
    pub(super) component: usize,
    /// Whether the faces that run with its lowest one face outwards.
    pub(super) outward: bool,
    /// Whether most of its faces face inwards.
    pub(super) is_inward: bool,
    /// Where it lies in its mesh; those that face inwards are marked. `None` if that cannot be told.
    pub(super) nest: Option<Nest>,
    /// Whether it is a room, unless it is a cavity.
    pub(super) seems_room: bool,
}

/// What a shell is in its mesh.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// It should face outwards.
    Solid,
    /// It should face inwards, as the wall of a cavity.
    Cavity,
    /// It faces inwards, and is right so.
    Room,
    Unknown,
}

impl Shell {
    /// Whether matter of its own mesh lies round it, if some of the shells are air within.
    pub(super) fn is_in_matter(&self, is_air: &[bool]) -> Option<bool> {
        let nest = self.nest.as_ref()?;
        Some((nest.depth - self.air_round(is_air)) % 2 == 1)
    }

    /// Whether it faces inwards, and its own mesh may give it no reason to.
    pub(super) fn is_in_question(&self) -> bool {
        let may_be = |nest: &Nest| nest.depth.is_multiple_of(2) || !nest.marked.is_empty();
        self.is_inward && self.nest.as_ref().is_some_and(may_be)
    }

    /// How many shells round it are air within, against what their depth would have them be.
    pub(super) fn air_round(&self, is_air: &[bool]) -> u32 {
        self.nest.iter().flat_map(|nest| &nest.marked).map(|&shell| u32::from(is_air[shell as usize])).sum()
    }
}

impl Orientations {
    /// The closed components with a volume, ascending.
    pub(super) fn shells(&self, mesh: &Mesh) -> Vec<Shell> {
        let against = self.components.against();
        let solid: Vec<(usize, bool)> = self
            .closed
            .par_iter()
            .filter_map(|&component| {
                let faces = self.components.faces(component);
                Some((component, faces_outward(mesh, faces, against, face_bounds(mesh, faces))?))
            })
            .collect();
        let is_inward: Vec<bool> = solid
            .par_iter()
            .map(|&(component, outward)| {
                self.is_inside_out(component, self.faces(component, outward).count())
            })
            .collect();
        let faces: Vec<&[u32]> =
            solid.iter().map(|&(component, _)| self.components.faces(component)).collect();
        let nests = depths(mesh, against, &faces, &is_inward);
        let shell = |((&(component, outward), &is_inward), nest)| Shell {
            component,
            outward,
            is_inward,
            nest,
            seems_room: false,
        };
        let mut shells: Vec<Shell> = solid.iter().zip(&is_inward).zip(nests).map(shell).collect();
        for room in self.rooms(mesh, &shells) {
            shells[room as usize].seems_room = true;
        }
        shells
    }

    /// The shells that seem to be rooms.
    fn rooms(&self, mesh: &Mesh, shells: &[Shell]) -> Vec<u32> {
        if mesh.columns().normals.is_none() {
            return Vec::new();
        }
        // Each marked shell with what stands directly in it.
        let mut within: Vec<(u32, u32)> = Vec::new();
        for (number, shell) in shells.iter().enumerate() {
            let Some(nest) = &shell.nest else { continue };
            let is_direct = |round: &u32| {
                shells[*round as usize].nest.as_ref().is_some_and(|it| it.depth + 1 == nest.depth)
            };
            within.extend(nest.marked.iter().copied().filter(is_direct).map(|round| (round, number as u32)));
        }
        within.sort_unstable();
        let points_inward = |shell: u32| {
            let Shell { component, outward, .. } = shells[shell as usize];
            let against = self.components.against();
            let faces = self.components.faces(component).iter();
            normals_oppose(mesh, faces.map(|&face| (face, against[face as usize] == outward)))
        };
        let is_room = |contents: &&[(u32, u32)]| {
            let inward =
                |&(_, shell): &(u32, u32)| points_inward(shell).unwrap_or(shells[shell as usize].is_inward);
            points_inward(contents[0].0) == Some(true)
                && 2 * contents.iter().filter(|pair| inward(pair)).count() <= contents.len()
        };
        let rooms: Vec<&[(u32, u32)]> = within.chunk_by(|a, b| a.0 == b.0).collect();
        rooms.into_par_iter().filter(is_room).map(|contents| contents[0].0).collect()
    }
}

/// What each shell is, where some components, ascending, are known to lie [inside of another mesh](super::hollows()).
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
