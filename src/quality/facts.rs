//! What all findings about a part are made from, worked out once.

use crate::mesh::{
    Column, Confidence, Link, Mesh, Orientation, Orientations, Topology, normals_oppose, place_key,
    stored_unit, vector_area,
};
use crate::normals::{FaceField, Fault, FaultReason, Groups, NormalField, NormalRecipe, compute_from};
use crate::num::{UnitVec3, unit_scale};
use crate::quality::catalogue::Kind;
use crate::quality::effect::specular_exponent::Gloss;
use crate::quality::estimate::recipe::{Estimate, estimate};
use crate::quality::finding::Severity;
use crate::quality::geometry::duplicates::Doubles;
use crate::quality::stored::neighbours::Around;
use crate::quality::stored::regions::Region;
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use rustc_hash::FxHashSet;

/// What a face is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Significance {
    /// It has a direction, and its neighbours agree with it.
    Sound,
    /// It runs against its neighbours, or its whole component is inside out: its direction is the opposite.
    Turned,
    /// It has no direction, or one that is noise.
    Silent,
}

/// A part, its topology, and the normals that it should have.
pub(super) struct Facts<'a> {
    around: &'a Around<'a>,
    /// The number of the part in its file.
    part: usize,
    pub(super) mesh: &'a Mesh,
    pub(super) topology: Topology,
    /// The distance, as a share of the diagonal, below which open edges were joined that nothing else joins, if any were.
    pub(super) near: Option<f64>,
    /// The stored normals, if there are any at all.
    pub(super) stored: Option<&'a Column<DVec3>>,
    /// Their directions, value by value, zero where there is none; empty if corners share so few that this would be large.
    units: Vec<DVec3>,
    /// Those of the file, if these are what they are in the space of the mesh.
    pub(super) written: Option<&'a Column<DVec3>>,
    /// How the stored normals were made, as far as they tell.
    pub(super) estimate: Option<Estimate>,
    /// What all stored normals were turned by, if the estimate is of them turned back.
    pub(super) turn: Option<DMat3>,
    /// Normals computed that way; with the default recipe if there are none to go by.
    pub(super) field: NormalField,
    /// Those of faces, as long as that recipe is not known.
    faces: FaceField,
    pub(super) worth: Vec<Significance>,
    /// Area of each face, in units that keep it in range.
    pub(super) area: Vec<f64>,
    /// The area of all faces.
    pub(super) total_area: f64,
    /// The length in that unit that the largest extent of the mesh has.
    pub(super) size: f64,
    /// From lengths of the part to that unit.
    pub(super) scale: f64,
    /// What `--orient outward` would find.
    pub(super) outward: Orientation,
    /// The components that it would turn.
    pub(super) inside_out: Vec<InsideOut>,
    /// Faces that `--orient consistent` would turn, ascending.
    pub(super) minority: Vec<u32>,
    /// Pieces of surface that the rule says nothing about.
    pub(super) apart: Region,
    /// Of each vertex whether a turned face is at it, so that the mean there says nothing; empty if there are none.
    near_reoriented: Vec<bool>,
    /// The corners whose faces cancel: nothing is known of what normal they should have. Ascending.
    cancelling: Vec<u32>,
    /// Where edges without length end and faces stand twice, by their bits.
    two_fans: FxHashSet<[u64; 3]>,
    /// Faces at the place of others.
    pub(super) doubles: Doubles,
    /// How sharp the highlights of faces are.
    pub(super) gloss: Gloss,
    /// Whether the file can share vertices at all; STL cannot.
    pub(super) shares_vertices: bool,
    /// Whether the file has a choice of how normals are stored.
    pub(super) has_normal_formats: bool,
}

impl<'a> Facts<'a> {
    /// Of a part of a file.
    pub(super) fn new(around: &'a Around<'a>, part: usize, confidence: Confidence, gloss: Gloss) -> Self {
        Self::of(around, (part, around.mesh(part)), confidence, gloss)
    }

    /// Of a part of a file with another mesh in place of its own, of the same shape.
    pub(super) fn of(
        around: &'a Around<'a>,
        (part, mesh): (usize, &'a Mesh),
        confidence: Confidence,
        gloss: Gloss,
    ) -> Self {
        let (topology, near) = Topology::build_near(mesh, around.near());
        let stored = mesh.columns().normals.as_ref().filter(|stored| !stored.values.is_empty());
        let faces = FaceField::new(mesh, &topology);
        let orientations = Orientations::new(mesh, &topology);
        let minority = orientations.consistent(mesh).reversed;
        let mut outward = orientations.outward(mesh, confidence, &[]);
        if outward.inside_out + outward.rooms > 0 && !around.cavities(part).is_empty() {
            outward = orientations.outward(mesh, confidence, around.cavities(part));
        }
        let inside_out = InsideOut::all(&orientations, &outward, |faces| {
            normals_oppose(mesh, faces.iter().map(|&face| (face, false)))
        });
        let worth = significance(mesh, &faces.faults(), &minority, &inside_out);
        let extent = mesh.bounds().map_or(0.0, |(low, high)| (high - low).max_element());
        let scale = unit_scale(extent);
        let area: Vec<f64> = (0..mesh.face_count())
            .into_par_iter()
            .map(|face| vector_area(mesh, face, scale).length())
            .collect();
        let mut facts = Self {
            around,
            part,
            mesh,
            topology,
            near: (near > 0).then(|| around.near()),
            stored,
            units: stored.map_or_else(Vec::new, |stored| units(mesh, stored)),
            written: None,
            estimate: None,
            turn: None,
            field: NormalField::default(),
            faces,
            worth,
            total_area: area.iter().sum(),
            area,
            size: extent * scale,
            scale,
            outward,
            inside_out,
            minority,
            apart: Region::default(),
            near_reoriented: Vec::new(),
            cancelling: Vec::new(),
            two_fans: FxHashSet::default(),
            doubles: Doubles::default(),
            gloss,
            shares_vertices: around.shares_vertices(),
            has_normal_formats: around.has_normal_formats(),
        };
        facts.mark_turned();
        facts.doubles = Doubles::new(&facts);
        facts.two_fans = facts.places_of_two_fans();
        if let Some((estimate, turn)) = stored.and_then(|stored| estimate(&facts, stored)) {
            (facts.estimate, facts.turn) = (Some(estimate), turn);
        }
        let has_groups = mesh.columns().smoothing.is_some();
        let recipe = match (facts.estimate, stored) {
            (Some(estimate), _) if has_groups || !estimate.is_default() => estimate.recipe(),
            (None, Some(_)) => NormalRecipe { groups: Groups::Ignore, ..NormalRecipe::default() },
            _ => NormalRecipe::default(),
        };
        facts.field = compute_from(mesh, &facts.topology, &recipe, std::mem::take(&mut facts.faces));
        let cancelling = facts.field.faults.corners.iter();
        let cancelling = cancelling.filter(|fault| fault.reason == FaultReason::CancellingFan);
        facts.cancelling = cancelling.map(|fault| fault.index).collect();
        facts.cancelling.sort_unstable();
        facts.apart = Region::new(&facts, &orientations);
        facts
    }

    fn mark_turned(&mut self) {
        let turned: Vec<usize> =
            (0..self.worth.len()).filter(|&face| self.worth[face] == Significance::Turned).collect();
        if !turned.is_empty() {
            self.near_reoriented = vec![false; self.mesh.vertex_count()];
        }
        for half_edge in turned.into_iter().flat_map(|face| self.mesh.faces().range(face)) {
            let corners = self.mesh.faces().corners();
            self.near_reoriented[corners[half_edge] as usize] = true;
            // Beyond a seam it is another vertex.
            if let Link::Inconsistent(other) = self.topology.link(half_edge as u32) {
                let (tail, head) = self.topology.ends(corners, other);
                self.near_reoriented[tail as usize] = true;
                self.near_reoriented[head as usize] = true;
            }
        }
    }

    /// Where edges without length are, and faces that stand twice.
    fn places_of_two_fans(&self) -> FxHashSet<[u64; 3]> {
        let faces = self.mesh.faces();
        let place = |vertex: u32| place_key(self.mesh.positions()[vertex as usize]);
        // A triangle with such an edge has no area; a polygon may.
        let may_have = |&face: &usize| self.worth[face] == Significance::Silent || faces.face(face).len() > 3;
        let edges = |face: usize| {
            let corners = faces.face(face);
            let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
            pairs.map(|(&a, &b)| [a, b].map(place))
        };
        let edges = (0..faces.len()).filter(may_have).flat_map(edges);
        let collapsed = edges.filter(|[a, b]| a == b).map(|[place, _]| place);
        let doubled = self.doubles.same_way().iter().flat_map(|&face| faces.face(face as usize));
        collapsed.chain(doubled.map(|&vertex| place(vertex))).collect()
    }

    /// Whether an edge without length or a face that stands twice is at a corner's place. Two vertices stand there, and which
    /// faces come one after the other round it depends on whether vertices are told apart by number or by place; or an edge of
    /// three faces, which fans end at. Either fan is right.
    pub(super) fn has_two_fans(&self, corner: usize) -> bool {
        let vertex = self.mesh.faces().corners()[corner] as usize;
        !self.two_fans.is_empty() && self.two_fans.contains(&place_key(self.mesh.positions()[vertex]))
    }

    /// Whether the edge of a half-edge is one of two that only nearly coincide.
    pub(super) fn is_cracked(&self, half_edge: u32) -> bool {
        let Some(Link::Welded(across)) = self.near.map(|_| self.topology.link(half_edge)) else {
            return false;
        };
        let corners = self.mesh.faces().corners();
        let place = |vertex: u32| place_key(self.mesh.positions()[vertex as usize]);
        let (tail, head) = self.topology.ends(corners, half_edge);
        let (other_head, other_tail) = self.topology.ends(corners, across);
        place(tail) != place(other_tail) || place(head) != place(other_head)
    }

    /// Whether the faces round a corner's vertex agree, so that their mean says something.
    pub(super) fn is_judged(&self, corner: usize) -> bool {
        !self.has_turned(corner) && !self.is_cancelling(corner)
    }

    /// Whether faces with directions disagree round a corner's vertex, the corner's own among them, but for those that cancel.
    pub(super) fn is_near_reoriented(&self, corner: usize) -> bool {
        let face = self.topology.face_of(corner as u32) as usize;
        self.has_turned(corner) && self.worth[face] != Significance::Silent && !self.is_cancelling(corner)
    }

    fn has_turned(&self, corner: usize) -> bool {
        let vertex = self.mesh.faces().corners()[corner] as usize;
        // Facets have the normals of their own faces, whatever is beside them.
        !self.are_facets() && self.near_reoriented.get(vertex).is_some_and(|&is| is)
    }

    fn are_facets(&self) -> bool {
        !self.shares_vertices && self.estimate.is_some_and(|estimate| estimate.crease.0 == 0.0)
    }

    fn is_cancelling(&self, corner: usize) -> bool {
        !self.cancelling.is_empty() && self.cancelling.binary_search(&(corner as u32)).is_ok()
    }

    /// The face's own unit normal.
    pub(super) fn face_normal(&self, face: usize) -> DVec3 {
        if self.field.face_normals.is_empty() {
            self.faces.units()[face]
        } else {
            self.field.face_normals[face]
        }
    }

    /// The normal that a corner should have.
    pub(super) fn expected(&self, corner: usize) -> DVec3 {
        let vertex = self.mesh.faces().corners()[corner];
        *self.field.normals.get(corner, vertex).expect("a field has a normal for every corner")
    }

    /// The normal that a corner should have, or that of its face where faces round the vertex disagree. How edges split
    /// stored normals does not change when all of them are turned, so this holds for turned ones as well.
    pub(super) fn right_way(&self, face: usize, corner: usize) -> DVec3 {
        if self.is_judged(corner) { self.expected(corner) } else { self.face_normal(face) }
    }

    /// The normal that a corner has in the file, as a unit vector; `None` if it has none with a direction.
    pub(super) fn stored_unit(&self, corner: usize) -> Option<DVec3> {
        let stored = self.stored?;
        if self.units.is_empty() {
            return stored_unit(stored, self.mesh, corner);
        }
        let slot = stored.slot(corner, self.mesh.faces().corners()[corner])?;
        Some(self.units[slot as usize]).filter(|&unit| unit != DVec3::ZERO)
    }

    /// That normal and what the rule gives there, turned as all are.
    pub(super) fn stored_and_right(&self, corner: usize) -> Option<(DVec3, DVec3)> {
        Some((self.stored_unit(corner)?, self.turn.unwrap_or_default() * self.expected(corner)))
    }

    /// Whether another part of the file has this normal at the place of a corner.
    pub(super) fn goes_on(&self, corner: usize, normal: DVec3) -> bool {
        let position = self.mesh.positions()[self.mesh.faces().corners()[corner] as usize];
        self.around.go_on(self.part, position, normal)
    }

    /// The normal that a corner is shaded with: its own, or the computed one.
    pub(super) fn shaded(&self, corner: usize) -> DVec3 {
        self.stored_unit(corner).unwrap_or_else(|| self.expected(corner))
    }

    /// The position of a corner, scaled.
    pub(super) fn place(&self, corner: usize) -> DVec3 {
        self.mesh.positions()[self.mesh.faces().corners()[corner] as usize] * self.scale
    }
}

/// A component that faces the wrong way as a whole.
pub(super) struct InsideOut {
    /// Its faces, but for those that run against the others, ascending.
    pub(super) faces: Vec<u32>,
    pub(super) is_open: bool,
    /// Whether most of its stored normals point against these faces; `None` if none is stored that says so.
    pub(super) is_opposed: Option<bool>,
}

impl InsideOut {
    fn all(
        orientations: &Orientations,
        outward: &Orientation,
        is_opposed: impl Fn(&[u32]) -> Option<bool>,
    ) -> Vec<Self> {
        let all = orientations.inside_out(&outward.reversed).into_iter();
        let reported = |faces: Vec<u32>| {
            let is_open = faces.first().is_some_and(|face| outward.reversed_open.binary_search(face).is_ok());
            Self { is_opposed: is_opposed(&faces), is_open, faces }
        };
        all.map(reported).collect()
    }

    /// What it is told as.
    pub(super) fn kind(&self) -> Kind {
        if self.is_open { Kind::OpenInsideOut } else { Kind::InsideOut }
    }

    /// How grave it is: less where no stored normals contradict its faces.
    pub(super) fn severity(&self) -> Severity {
        match (self.is_open, self.is_opposed == Some(true)) {
            (_, true) => self.kind().entry().severity,
            (false, false) => Severity::Warning,
            (true, false) => Severity::Note,
        }
    }

    /// Whether its faces are to be taken for the opposite of what they are. Rooms, skies and bowls are seen from within, and
    /// their normals say so as well; without normals, a component with a rim has no inside for certain.
    fn is_fault(&self) -> bool {
        self.is_opposed.unwrap_or(!self.is_open)
    }
}

/// The directions of stored normals, if three corners or more share one: each is asked for a dozen times.
fn units(mesh: &Mesh, stored: &Column<DVec3>) -> Vec<DVec3> {
    if 3 * stored.values.len() > mesh.faces().corner_count() {
        return Vec::new();
    }
    let unit = |&normal: &DVec3| UnitVec3::new(normal).map_or(DVec3::ZERO, UnitVec3::get);
    stored.values.par_iter().map(unit).collect()
}

fn significance(
    mesh: &Mesh,
    faults: &[Fault],
    minority: &[u32],
    inside_out: &[InsideOut],
) -> Vec<Significance> {
    let mut worth = vec![Significance::Sound; mesh.face_count()];
    let wholes = inside_out.iter().filter(|component| component.is_fault());
    for &face in wholes.flat_map(|component| &component.faces).chain(minority) {
        worth[face as usize] = Significance::Turned;
    }
    let silent =
        [FaultReason::ZeroArea, FaultReason::BelowStorage, FaultReason::OutOfRange, FaultReason::NonFinite];
    for fault in faults.iter().filter(|fault| silent.contains(&fault.reason)) {
        worth[fault.index as usize] = Significance::Silent;
    }
    worth
}
