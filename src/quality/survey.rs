//! What pictures and histograms of a report are made of.

use crate::io::Loaded;
use crate::mesh::{Confidence, Mesh, place_key};
use crate::num::{Degrees, angle_between};
use crate::quality::effect::specular_exponent::Gloss;
use crate::quality::facts::{Facts, Significance};
use crate::quality::stored::neighbours::Around;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use rayon::prelude::*;

/// The numbers behind the findings about a mesh, element by element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Survey {
    /// The unit normal that each corner is shaded with: the stored one, else the computed one.
    pub shaded: Vec<DVec3>,
    /// The unit normal of each face.
    pub face_normals: Vec<DVec3>,
    /// The unit normal that the rule of its mesh gives each corner.
    pub expected: Vec<DVec3>,
    /// At each corner, the angle between its stored normal and the one that the rule of its mesh gives, in degrees; `None`
    /// where none is stored, or one without a direction: zero, or no number. Of a face without a direction 0: nothing tells what
    /// would be right there.
    pub deviations: Vec<Option<f64>>,
    /// The bend of each edge between two faces, in degrees.
    pub bends: Vec<f64>,
    /// The angle of the face at each corner, in degrees.
    pub corner_angles: Vec<f64>,
    /// The faces that meet at each place, ascending by its coordinates' bits.
    pub valences: Vec<f64>,
    /// The length of the edge that leaves each corner, over the median of them.
    pub edge_lengths: Vec<f64>,
}

/// Measures each part of a file.
pub fn survey(loaded: &Loaded) -> Vec<Survey> {
    let around = Around::new(loaded, Thresholds::default().weld);
    let facts = |part: usize| {
        let gloss = Gloss::new(around.mesh(part), &[], None);
        Facts::new(&around, part, Confidence::default(), gloss)
    };
    let has_faces = |part: usize| around.mesh(part).face_count() > 0;
    let parts = 0..loaded.parts.len();
    parts.map(|part| if has_faces(part) { measured(&facts(part)) } else { Survey::default() }).collect()
}

fn measured(facts: &Facts<'_>) -> Survey {
    let mesh = facts.mesh;
    let corners = mesh.faces().corner_count();
    let between = |a: DVec3, b: DVec3| Degrees::from(angle_between(a, b)).0;
    let edge = |corner: usize| facts.place(facts.topology.next(corner as u32) as usize) - facts.place(corner);
    let deviation = |corner: usize| {
        let is_silent = facts.worth[facts.topology.face_of(corner as u32) as usize] == Significance::Silent;
        let off = |stored: DVec3| if is_silent { 0.0 } else { between(stored, facts.expected(corner)) };
        facts.stored_unit(corner).map(off)
    };
    let bend = |corner: usize| {
        let across = facts.topology.across(corner as u32).filter(|&across| (corner as u32) < across)?;
        let faces = [corner as u32, across].map(|corner| facts.topology.face_of(corner) as usize);
        faces
            .iter()
            .all(|&face| facts.area[face] > 0.0)
            .then(|| between(facts.face_normal(faces[0]), facts.face_normal(faces[1])))
    };
    let angle = |corner: usize| between(edge(corner), -edge(facts.topology.previous(corner as u32) as usize));
    let mut lengths: Vec<f64> = (0..corners).map(|corner| edge(corner).length()).collect();
    let median = {
        let mut sorted = lengths.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted[corners / 2]
    };
    if median > 0.0 {
        lengths.iter_mut().for_each(|length| *length /= median);
    }
    Survey {
        shaded: (0..corners).map(|corner| facts.shaded(corner)).collect(),
        expected: (0..corners).map(|corner| facts.expected(corner)).collect(),
        face_normals: facts.field.face_normals.clone(),
        deviations: (0..corners).map(deviation).collect(),
        bends: (0..corners).filter_map(bend).collect(),
        corner_angles: (0..corners).map(angle).collect(),
        valences: valences(mesh),
        edge_lengths: lengths,
    }
}

/// How many faces meet at each place. Where normals or uvs differ several vertices stand at one.
fn valences(mesh: &Mesh) -> Vec<f64> {
    let mut places: Vec<[u64; 3]> = mesh
        .faces()
        .iter()
        .flat_map(|face| {
            let mut of_face: Vec<_> =
                face.iter().map(|&vertex| place_key(mesh.positions()[vertex as usize])).collect();
            of_face.sort_unstable();
            of_face.dedup();
            of_face
        })
        .collect();
    places.par_sort_unstable();
    places.chunk_by(|a, b| a == b).map(|faces| faces.len() as f64).collect()
}
