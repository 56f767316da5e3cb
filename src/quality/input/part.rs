//! A part of a file before its normals are judged: mesh, topology, faces, their winding, and stored normals.

use crate::mesh::{
    Column, Link, Mesh, Orientation, Orientations, Topology, normals_oppose, place_key, stored_unit,
    vector_area,
};
use crate::normals::{FaceField, FaultReason};
use crate::num::parallel;
use crate::num::{UnitVec3, unit_scale};
use crate::quality::input::duplicates::DuplicateFaces;
use crate::quality::input::file::FileContext;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use rustc_hash::FxHashSet;
use std::ops::Range;

/// How far the direction of a face can be relied on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// It has one, and its neighbours agree.
    Sound,
    /// Its winding is opposite to its neighbours', or its component is inside out: the opposite is right.
    Reversed,
    /// It has none, or one that is rounding noise.
    Undefined,
}

/// A part of a file. Lengths are scaled so that areas stay in range.
pub(crate) struct Part<'a> {
    pub(crate) file: &'a FileContext<'a>,
    pub(crate) thresholds: &'a Thresholds,
    pub(crate) number: usize,
    pub(crate) mesh: &'a Mesh,
    pub(crate) topology: Topology,
    /// Whether open edges were joined that only nearly coincide.
    pub(crate) has_near_edges: bool,
    /// From lengths of the mesh to scaled ones.
    pub(crate) scale: f64,
    /// The largest extent of the mesh, scaled.
    pub(crate) size: f64,
    pub(crate) area: Vec<f64>,
    pub(crate) total_area: f64,
    pub(crate) winding: Winding,
    pub(crate) duplicates: DuplicateFaces,
    pub(crate) stored: Option<&'a Column<DVec3>>,
    /// The directions of the stored values, zero where there is none; empty if few corners share a value.
    stored_units: Vec<DVec3>,
    /// The normals of the faces until the corner normals are computed from them; then empty.
    pub(crate) face_field: FaceField,
    pub(crate) face_normals: Vec<DVec3>,
    directions: Vec<Direction>,
    /// Whether a reversed face is at a vertex, so that the mean of its faces has no meaning; empty if there are none.
    near_reversed: Vec<bool>,
    /// Positions of edges without length and of doubled faces, by their bits.
    two_fans: FxHashSet<[u64; 3]>,
}

impl<'a> Part<'a> {
    /// A part of a file with a mesh in place of its own, of the same shape.
    pub(crate) fn new(file: &'a FileContext<'a>, number: usize, mesh: &'a Mesh) -> Self {
        let (topology, near_edges) = Topology::build_near(mesh, file.thresholds.weld);
        let face_field = FaceField::new(mesh, &topology);
        let winding = Winding::new(file, number, mesh, &topology);
        let directions = directions(mesh, &face_field, &winding);
        let extent = mesh.bounds().map_or(0.0, |(low, high)| (high - low).max_element());
        let scale = unit_scale(extent);
        let area = parallel::map(mesh.face_count(), |face| vector_area(mesh, face, scale).length());
        let stored = mesh.columns().normals.as_ref().filter(|stored| !stored.values.is_empty());
        let duplicates = DuplicateFaces::find(mesh, &area);
        Self {
            near_reversed: vertices_at_reversed(mesh, &topology, &directions),
            two_fans: positions_of_two_fans(mesh, &directions, &duplicates),
            stored_units: stored.map_or_else(Vec::new, |stored| units(mesh, stored)),
            file,
            thresholds: file.thresholds,
            number,
            mesh,
            topology,
            has_near_edges: near_edges > 0,
            scale,
            size: extent * scale,
            total_area: area.iter().sum(),
            area,
            winding,
            duplicates,
            stored,
            face_field,
            face_normals: Vec::new(),
            directions,
        }
    }

    pub(crate) fn direction(&self, face: usize) -> Direction {
        self.directions[face]
    }

    pub(crate) fn is_sound(&self, face: usize) -> bool {
        self.directions[face] == Direction::Sound
    }

    pub(crate) fn has_direction(&self, face: usize) -> bool {
        self.directions[face] != Direction::Undefined
    }

    pub(crate) fn face_normal(&self, face: usize) -> DVec3 {
        match self.face_normals.is_empty() {
            true => self.face_field.units()[face],
            false => self.face_normals[face],
        }
    }

    pub(crate) fn face_of(&self, corner: usize) -> usize {
        self.topology.face_of(corner as u32) as usize
    }

    pub(crate) fn corners_of(&self, face: usize) -> Range<usize> {
        self.mesh.faces().range(face)
    }

    pub(crate) fn vertex(&self, corner: usize) -> u32 {
        self.mesh.faces().corners()[corner]
    }

    /// The scaled position of a corner.
    pub(crate) fn position(&self, corner: usize) -> DVec3 {
        self.mesh.positions().at(self.vertex(corner)) * self.scale
    }

    /// The scaled vector from a corner to the next one of its face.
    pub(crate) fn edge(&self, corner: usize) -> DVec3 {
        self.position(self.topology.next(corner as u32) as usize) - self.position(corner)
    }

    /// The edges between two faces, each once: both half-edges.
    pub(crate) fn across_once(&self, half_edge: u32) -> Option<u32> {
        self.topology.across(half_edge).filter(|&across| half_edge < across)
    }

    /// The normal that a corner has in the file, as a unit vector; `None` if it has none with a direction.
    pub(crate) fn stored_unit(&self, corner: usize) -> Option<DVec3> {
        let stored = self.stored?;
        if self.stored_units.is_empty() {
            return stored_unit(stored, self.mesh, corner);
        }
        let slot = stored.slot(corner, self.vertex(corner))?;
        Some(self.stored_units[slot as usize]).filter(|&unit| unit != DVec3::ZERO)
    }

    pub(crate) fn is_near_reversed(&self, corner: usize) -> bool {
        !self.near_reversed.is_empty() && self.near_reversed[self.vertex(corner) as usize]
    }

    /// Whether an edge without length or a doubled face is at the position of a corner. Two vertices are there, or an edge of
    /// three faces, at which fans end: which faces follow one another depends on whether vertices are the same by number or by
    /// position. Either fan is right.
    pub(crate) fn has_two_fans(&self, corner: usize) -> bool {
        let position = self.mesh.positions().at(self.vertex(corner));
        !self.two_fans.is_empty() && self.two_fans.contains(&place_key(position))
    }

    /// Whether the edge of a half-edge is one of two that only nearly coincide.
    pub(crate) fn is_cracked(&self, half_edge: u32) -> bool {
        let Link::Welded(across) = self.topology.link(half_edge) else { return false };
        let key = |vertex: u32| place_key(self.mesh.positions().at(vertex));
        let ends = |half_edge| self.topology.ends(self.mesh.faces().corners(), half_edge);
        let ((tail, head), (other_head, other_tail)) = (ends(half_edge), ends(across));
        self.has_near_edges && (key(tail) != key(other_tail) || key(head) != key(other_head))
    }

    /// Whether another part of the file has this normal at the position of a corner.
    pub(crate) fn is_shared_with_other_part(&self, corner: usize, normal: DVec3) -> bool {
        let position = self.mesh.positions().at(self.vertex(corner));
        self.file.has_in_other_part(self.number, position, normal)
    }
}

fn directions(mesh: &Mesh, faces: &FaceField, winding: &Winding) -> Vec<Direction> {
    use FaultReason::{BelowStorage, NonFinite, OutOfRange, ZeroArea};
    let mut directions = vec![Direction::Sound; mesh.face_count()];
    winding.reversed().for_each(|face| directions[face as usize] = Direction::Reversed);
    for fault in faces.faults() {
        if matches!(fault.reason, ZeroArea | BelowStorage | OutOfRange | NonFinite) {
            directions[fault.index as usize] = Direction::Undefined;
        }
    }
    directions
}

/// Marks the vertices of reversed faces, and those across their seams.
fn vertices_at_reversed(mesh: &Mesh, topology: &Topology, directions: &[Direction]) -> Vec<bool> {
    let corners = mesh.faces().corners();
    let mut marks = Vec::new();
    let reversed = (0..directions.len()).filter(|&face| directions[face] == Direction::Reversed);
    for half_edge in reversed.flat_map(|face| mesh.faces().range(face)) {
        marks.resize(mesh.vertex_count(), false);
        marks[corners[half_edge] as usize] = true;
        if let Link::Inconsistent(other) = topology.link(half_edge as u32) {
            let (tail, head) = topology.ends(corners, other);
            marks[tail as usize] = true;
            marks[head as usize] = true;
        }
    }
    marks
}

/// The positions of edges without length and of doubled faces.
fn positions_of_two_fans(
    mesh: &Mesh,
    directions: &[Direction],
    duplicates: &DuplicateFaces,
) -> FxHashSet<[u64; 3]> {
    let faces = mesh.faces();
    let key = |&vertex: &u32| place_key(mesh.positions().at(vertex));
    // A triangle with such an edge has no area; a polygon may.
    let may_have = |&face: &usize| directions[face] == Direction::Undefined || faces.face(face).len() > 3;
    let edges = (0..faces.len()).filter(may_have).flat_map(|face| {
        let corners = faces.face(face);
        corners.iter().zip(corners.iter().cycle().skip(1)).map(|(a, b)| [a, b].map(key))
    });
    let collapsed = edges.filter(|[a, b]| a == b).map(|[position, _]| position);
    let doubled = duplicates.all_same_way.iter().flat_map(|&face| faces.face(face as usize));
    collapsed.chain(doubled.map(key)).collect()
}

/// The directions of the stored values if three corners or more share one: each is needed a dozen times.
fn units(mesh: &Mesh, stored: &Column<DVec3>) -> Vec<DVec3> {
    if 3 * stored.values.len() > mesh.faces().corner_count() {
        return Vec::new();
    }
    parallel::map_each(&stored.values, |&normal| UnitVec3::new(normal).map_or(DVec3::ZERO, UnitVec3::get))
}

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
