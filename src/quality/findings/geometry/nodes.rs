//! Nodes whose matrices mirror or flatten a mesh, and files without faces.

use crate::io::FileNode;
use crate::mesh::normal_matrix;
use crate::quality::definition::{Definition, Found};
use crate::quality::effect::lost_light::key_light_lost;
use crate::quality::element::Element;
use crate::quality::spot::{Measure, Spot};
use glam::DMat3;

pub(crate) static NO_FACES: Definition = Definition::warning("no-faces", Element::Mesh, None);
pub(crate) static MIRRORED_NODE: Definition = Definition::note("mirrored-node", Element::Node, None);
pub(crate) static SINGULAR_NODE: Definition = Definition::warning("singular-node", Element::Node, None);

/// Checks the matrices that place a part in the world.
pub(crate) fn search(nodes: &[&FileNode], found: &mut Found) {
    for (number, node) in nodes.iter().enumerate() {
        match normal_matrix(DMat3::from_mat4(node.world_from_part)) {
            None => {
                let spot = Spot::node(number).of(Measure::Steps, key_light_lost());
                found.add(&SINGULAR_NODE, spot, 0.0);
            }
            // Half a turn in a viewer that does not reverse the winding.
            Some(matrix) if matrix.mirrored() => found.add(&MIRRORED_NODE, Spot::node(number).by(180.0), 0.0),
            Some(_) => {}
        }
    }
}
