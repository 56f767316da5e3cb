//! Faces with opposite winding to their neighbours, and components that face the wrong way as a whole.

use crate::mesh::{Mesh, Orientation, Orientations, Topology, normals_oppose};
use crate::quality::input::file::FileContext;

/// The winding of the faces of a part, as `crease normals --orient` would change it.
pub(crate) struct Winding {
    pub(crate) components: Orientations,
    /// What `--orient outward` would find.
    pub(crate) outward: Orientation,
    /// The components that it would reverse.
    pub(crate) inside_out: Vec<InsideOut>,
    /// The faces that `--orient consistent` would reverse, ascending.
    pub(crate) minority: Vec<u32>,
}

/// A component that faces the wrong way as a whole.
pub(crate) struct InsideOut {
    /// Its faces without those that run against the others, ascending.
    pub(crate) faces: Vec<u32>,
    /// Whether it has a rim.
    pub(crate) is_open: bool,
    /// Whether most of its stored normals point against these faces; `None` if they leave it open.
    pub(crate) is_opposed: Option<bool>,
}

impl Winding {
    pub(crate) fn new(file: &FileContext<'_>, part: usize, mesh: &Mesh, topology: &Topology) -> Self {
        let components = Orientations::new(mesh, topology);
        let outward = |cavities: &[usize]| components.outward(mesh, file.thresholds.confidence, cavities);
        let mut outwards = outward(&[]);
        if outwards.inside_out + outwards.rooms > 0 && !file.cavities(part).is_empty() {
            outwards = outward(file.cavities(part));
        }
        let inside_out = components.inside_out(&outwards.reversed).into_iter().map(|faces| InsideOut {
            is_open: faces.first().is_some_and(|face| outwards.reversed_open.binary_search(face).is_ok()),
            is_opposed: normals_oppose(mesh, faces.iter().map(|&face| (face, false))),
            faces,
        });
        Self {
            inside_out: inside_out.collect(),
            minority: components.consistent(mesh).reversed,
            outward: outwards,
            components,
        }
    }

    /// The faces that are taken to point the other way. Normals of rooms, skies and bowls, which are seen from within, agree
    /// with their faces; without normals, the inside of a component with a rim is uncertain.
    pub(crate) fn reversed(&self) -> impl Iterator<Item = u32> {
        let wholes = self.inside_out.iter().filter(|it| it.is_opposed.unwrap_or(!it.is_open));
        wholes.flat_map(|component| &component.faces).chain(&self.minority).copied()
    }
}
