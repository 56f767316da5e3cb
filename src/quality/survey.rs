//! Data for the pictures and histograms of a report.

use crate::io::Loaded;
use crate::mesh::{Mesh, place_key};
use crate::normals::{NormalRecipe, Weight, compute};
use crate::quality::angles::degrees_between;
use crate::quality::estimate::recipe::Estimate;
use crate::quality::facts::Facts;
use crate::quality::input::file::FileContext;
use crate::quality::thresholds::Thresholds;
use glam::DVec3;
use rayon::prelude::*;

/// The numbers behind the findings about a mesh, element by element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Survey {
    /// The unit normal that each corner is shaded with: the stored one, or the computed one.
    pub shaded: Vec<DVec3>,
    /// The unit normal of each face.
    pub face_normals: Vec<DVec3>,
    /// The unit normal of each corner by the recipe of its mesh.
    pub expected: Vec<DVec3>,
    /// The angle at each corner between its stored normal and the expected one, in degrees; `None` if there is none with a
    /// direction. 0 on a face without a direction, where the expected normal is unknown.
    pub deviations: Vec<Option<f64>>,
    /// The dihedral angle of each edge between two faces, in degrees.
    pub bends: Vec<f64>,
    /// The angle of the face at each corner, in degrees.
    pub corner_angles: Vec<f64>,
    /// The number of faces at each position, ascending by the bits of its coordinates.
    pub valences: Vec<f64>,
    /// The length of the edge that leaves each corner, divided by their median.
    pub edge_lengths: Vec<f64>,
}

impl Survey {
    /// Replaces the expected normals by those of a weight, with the crease angle and the groups of the estimate, or the default
    /// ones; and the deviations by the angles to these.
    pub fn compare_with(&mut self, mesh: &Mesh, weight: Weight, estimate: Option<Estimate>) {
        if mesh.face_count() == 0 {
            return;
        }
        let recipe = estimate.map_or_else(NormalRecipe::default, |estimate| estimate.recipe());
        let recipe = NormalRecipe { weight, ..recipe };
        let field = compute(mesh, &recipe);
        for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
            let Some(&expected) = field.normals.get(corner, vertex) else { continue };
            self.expected[corner] = expected;
            if let Some(degrees) = &mut self.deviations[corner] {
                *degrees = degrees_between(self.shaded[corner], expected);
            }
        }
    }
}

/// Measures each part of a file.
pub fn survey(loaded: &Loaded) -> Vec<Survey> {
    let thresholds = Thresholds::default();
    let file = FileContext::new(loaded, &thresholds);
    let measure = |part: usize| match loaded.parts[part].mesh.face_count() {
        0 => Survey::default(),
        _ => measured(&Facts::new(&file, part)),
    };
    (0..loaded.parts.len()).map(measure).collect()
}

fn measured(facts: &Facts<'_>) -> Survey {
    let corners = 0..facts.mesh.faces().corner_count();
    let deviation = |corner: usize| {
        let has_direction = facts.has_direction(facts.face_of(corner));
        facts.deviation(corner).map(|degrees| if has_direction { degrees } else { 0.0 })
    };
    let bend = |corner: usize| {
        let across = facts.across_once(corner as u32)?;
        let [a, b] = [corner, across as usize].map(|corner| facts.face_of(corner));
        let have_areas = facts.area[a] > 0.0 && facts.area[b] > 0.0;
        have_areas.then(|| degrees_between(facts.face_normal(a), facts.face_normal(b)))
    };
    let angle = |corner: usize| {
        let previous = facts.topology.previous(corner as u32) as usize;
        degrees_between(facts.edge(corner), -facts.edge(previous))
    };
    let mut lengths: Vec<f64> = corners.clone().map(|corner| facts.edge(corner).length()).collect();
    let mut sorted = lengths.clone();
    sorted.sort_unstable_by(f64::total_cmp);
    let median = sorted[sorted.len() / 2];
    if median > 0.0 {
        lengths.iter_mut().for_each(|length| *length /= median);
    }
    Survey {
        shaded: corners.clone().map(|corner| facts.shaded(corner)).collect(),
        face_normals: facts.face_normals.clone(),
        expected: corners.clone().map(|corner| facts.expected(corner)).collect(),
        deviations: corners.clone().map(deviation).collect(),
        bends: corners.clone().filter_map(bend).collect(),
        corner_angles: corners.map(angle).collect(),
        valences: valences(facts.mesh),
        edge_lengths: lengths,
    }
}

/// The number of faces at each position. Several vertices are at one if normals or texture coordinates differ.
fn valences(mesh: &Mesh) -> Vec<f64> {
    let of_face = |face: &[u32]| {
        let mut keys: Vec<_> = face.iter().map(|&vertex| place_key(mesh.positions().at(vertex))).collect();
        keys.sort_unstable();
        keys.dedup();
        keys
    };
    let mut keys: Vec<[u64; 3]> = mesh.faces().iter().flat_map(of_face).collect();
    keys.par_sort_unstable();
    keys.chunk_by(|a, b| a == b).map(|faces| faces.len() as f64).collect()
}
