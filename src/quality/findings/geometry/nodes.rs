//! Nodes whose matrices mirror or flatten a mesh, and files without faces.

use crate::io::FileNode;
use crate::mesh::normal_matrix;
use crate::quality::effect::lost_light::key_light_lost;
use crate::quality::findings::prelude::*;
use glam::DMat3;

/// Checks the matrices that place a part in the world.
pub(crate) fn search(nodes: &[&FileNode], found: &mut Found) {
    for (number, node) in nodes.iter().enumerate() {
        match normal_matrix(DMat3::from_mat4(node.world_from_part)) {
            None => {
                let spot = Spot::node(number).of(Measure::Steps, key_light_lost());
                found.add(Kind::SingularNode, spot, 0.0);
            }
            // Half a turn in a viewer that does not reverse the winding.
            Some(matrix) if matrix.mirrored() => {
                found.add(Kind::MirroredNode, Spot::node(number).by(180.0), 0.0)
            }
            Some(_) => {}
        }
    }
}
