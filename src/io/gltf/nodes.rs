//! The node tree: the place of every node in the world. Without recursion, since chains of any length load.

use super::fields::{Fields, numbered};
use super::json::{Json, Value};
use crate::io::{FileNode, Note, Place, Problem, ReadError, Severity};
use crate::num::UnitVec3;
use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};

/// The meshes of the default scene (of all root nodes, where there is none), in the order of the tree.
pub fn read(json: &Json, meshes: usize, notes: &mut Vec<Note>) -> Result<Vec<FileNode>, ReadError> {
    let mut placed = Vec::new();
    let (mut unrotated, mut moved_skin) = (Vec::new(), None);
    NodeTree::new(json)?.each(|node| {
        if node.frame.without_rotation == Some((node.number, "rotation")) {
            unrotated.push(node.number);
        }
        let Some(part) = node.fields.reference("mesh", "mesh", meshes)? else { return Ok(()) };
        if !node.shown {
            return Ok(());
        }
        // Only its joints move a skinned mesh; the standard ignores its node's own transform.
        let is_skinned = node.fields.integer("skin")?.is_some();
        if is_skinned && node.frame.world != DMat4::IDENTITY {
            moved_skin.get_or_insert(node.number);
        }
        let world_from_part = if is_skinned { DMat4::IDENTITY } else { node.frame.world };
        let name = node.fields.name()?;
        placed.push(FileNode { number: node.number, name, part, world_from_part });
        Ok(())
    })?;
    let places = unrotated.iter().map(|&node| Place::Json(format!("/nodes/{node}/rotation")));
    let text = "a rotation of zeros was read as no rotation";
    notes.extend(Note::for_all(Severity::Warning, unrotated.len() as u64, places, text));
    let singular = placed.iter().filter(|node| node.world_from_part.determinant() == 0.0);
    let places = singular.clone().map(|node| numbered("nodes", node.number));
    let text = "the transform of a node flattens its mesh, so normals are undefined there";
    notes.extend(Note::for_all(Severity::Warning, singular.count() as u64, places, text));
    if let Some(node) = moved_skin {
        let text = "a skinned mesh ignores the transform of its node and is read in its bind pose";
        notes.push(Note { place: numbered("nodes", node), ..Note::remark(text) });
    }
    Ok(placed)
}

pub struct Placed<'a> {
    pub number: usize,
    pub fields: Fields<'a>,
    pub frame: Frame,
    pub shown: bool,
}

#[derive(Clone, Copy)]
pub struct Frame {
    pub world: DMat4,
    /// The product of the rotations of the node and of all above it: its orientation with all scaling ignored.
    pub rotation: DQuat,
    /// The nearest node at or above it without a rotation, and the member at fault: a zero quaternion or a singular matrix.
    pub without_rotation: Option<(usize, &'static str)>,
}

impl Frame {
    const WORLD: Self = Self { world: DMat4::IDENTITY, rotation: DQuat::IDENTITY, without_rotation: None };
}

const NO_NODE: u32 = u32::MAX;

/// The nodes of a file and which are whose children. Numbers are small, since a file may have millions of nodes.
pub(crate) struct NodeTree<'a> {
    json: &'a Json,
    nodes: Vec<Value>,
    /// Where each node's children begin in `children`, with the total at the end.
    first_child: Vec<u32>,
    children: Vec<u32>,
    parent: Vec<u32>,
}

impl<'a> NodeTree<'a> {
    /// The most nodes of a path that are named: those nearest to its end.
    const DEEPEST: usize = 32;

    pub fn new(json: &'a Json) -> Result<Self, ReadError> {
        let nodes = Fields::root(json).list("nodes")?;
        let (count, parent) = (nodes.len(), vec![NO_NODE; nodes.len()]);
        let mut tree = Self { json, nodes, first_child: vec![0], children: Vec::new(), parent };
        for node in 0..count {
            let fields = tree.fields(node);
            for child in fields.references("children", "node", count)? {
                let parent = std::mem::replace(&mut tree.parent[child], node as u32);
                if parent != NO_NODE {
                    let found = format!("the node is a child of node {parent} and of node {node}");
                    return Err(no_tree(child, &found));
                }
                tree.children.push(child as u32);
            }
            tree.first_child.push(tree.children.len() as u32);
        }
        Ok(tree)
    }

    fn fields(&self, node: usize) -> Fields<'a> {
        Fields { json: self.json, object: self.nodes[node] }
    }

    fn children(&self, node: u32) -> &[u32] {
        let node = node as usize;
        &self.children[self.first_child[node] as usize..self.first_child[node + 1] as usize]
    }

    /// A node with its ancestors, from the root on, or the nearest of them, and whether there are more.
    fn path_to(&self, node: usize) -> (Vec<usize>, bool) {
        let parent = |&node: &usize| Some(self.parent[node]).filter(|&node| node != NO_NODE);
        let ancestors = std::iter::successors(Some(node), |node| parent(node).map(|node| node as usize));
        let mut path: Vec<usize> = ancestors.take(Self::DEEPEST + 1).collect();
        let is_cut = path.len() > Self::DEEPEST;
        path.truncate(Self::DEEPEST);
        path.reverse();
        (path, is_cut)
    }

    /// The name of a node, or its number, as `#7`, if it has none.
    pub(crate) fn name(&self, node: usize) -> String {
        let name = self.fields(node).name().unwrap_or_default();
        if name.is_empty() { format!("#{node}") } else { name }
    }

    /// The names of a node and its nearest ancestors, from the root on, as `body/arm/hand`.
    pub fn path(&self, node: usize) -> String {
        let (path, is_cut) = self.path_to(node);
        let names: Vec<String> = path.into_iter().map(|node| self.name(node)).collect();
        format!("{}{}", if is_cut { "…/" } else { "" }, names.join("/"))
    }

    /// The matrices that place a mesh, each with the number of its node: those of its node and its nearest ancestors, from the root
    /// on, each from the node's space to its parent's. None for a skinned mesh, which only its joints move.
    pub(crate) fn chain(&self, node: usize) -> Vec<(usize, DMat4)> {
        let is_skinned = self.fields(node).integer("skin").is_ok_and(|skin| skin.is_some());
        let path = if is_skinned { Vec::new() } else { self.path_to(node).0 };
        path.into_iter().filter_map(|node| Some((node, local(&self.fields(node)).ok()?.0))).collect()
    }

    /// Visits all nodes, each after its parent and before its next sibling.
    pub fn each(&self, mut visit: impl FnMut(Placed<'a>) -> Result<(), ReadError>) -> Result<(), ReadError> {
        let shown = self.shown()?;
        // The node at hand with its ancestors.
        let mut path: Vec<(u32, Frame)> = Vec::new();
        for node in self.order()? {
            let number = node as usize;
            while path.last().is_some_and(|&(above, _)| above != self.parent[number]) {
                path.pop();
            }
            let above = path.last().map_or(Frame::WORLD, |&(_, frame)| frame);
            let fields = self.fields(number);
            let (matrix, rotation) = local(&fields)?;
            let frame = Frame {
                world: above.world * matrix,
                rotation: above.rotation * rotation.unwrap_or(DQuat::IDENTITY),
                without_rotation: match rotation {
                    Ok(_) => above.without_rotation,
                    Err(member) => Some((number, member)),
                },
            };
            if !frame.world.is_finite() {
                let found = "the world transform of the node is not finite";
                return Err(ReadError::new(Problem::NonFinite, fields.place(), found, "check its scale"));
            }
            path.push((node, frame));
            visit(Placed { number, fields, frame, shown: shown[number] })?;
        }
        Ok(())
    }

    /// All nodes, each after its parent and before its next sibling.
    fn order(&self) -> Result<Vec<u32>, ReadError> {
        let count = self.parent.len();
        let mut order = Vec::with_capacity(count);
        let is_root = |&node: &u32| self.parent[node as usize] == NO_NODE;
        let mut open: Vec<u32> = (0..count as u32).rev().filter(is_root).collect();
        while let Some(node) = open.pop() {
            order.push(node);
            open.extend(self.children(node).iter().rev());
        }
        if order.len() == count {
            return Ok(order);
        }
        // Each node has one parent, so that no root leads to cycles and to what is below them.
        let mut reached = vec![false; count];
        order.iter().for_each(|&node| reached[node as usize] = true);
        let mut node = reached.iter().position(|reached| !reached).unwrap_or(0);
        while !std::mem::replace(&mut reached[node], true) {
            node = self.parent[node] as usize;
        }
        Err(no_tree(node, "the node is its own ancestor"))
    }

    /// Which nodes the default scene shows; all, where there is none.
    fn shown(&self) -> Result<Vec<bool>, ReadError> {
        let (root, count) = (Fields::root(self.json), self.nodes.len());
        let scenes = root.list("scenes")?;
        let Some(scene) = root.reference("scene", "scene", scenes.len())? else {
            return Ok(vec![true; count]);
        };
        let scene = Fields { object: scenes[scene], ..root };
        let roots = scene.references("nodes", "node", count)?.into_iter();
        let mut open: Vec<u32> = roots.map(|node| node as u32).collect();
        let mut shown = vec![false; count];
        while let Some(node) = open.pop() {
            if !std::mem::replace(&mut shown[node as usize], true) {
                open.extend(self.children(node));
            }
        }
        Ok(shown)
    }
}

fn no_tree(node: usize, found: &str) -> ReadError {
    let advice = "nodes must form trees; export the file again";
    ReadError::new(Problem::Range, numbered("nodes", node), found, advice)
}

/// The transform of a node to its parent's space, and its rotation, or the member that should give one.
fn local(node: &Fields<'_>) -> Result<(DMat4, Result<DQuat, &'static str>), ReadError> {
    if let Some(columns) = node.numbers::<16>("matrix")? {
        let matrix = DMat4::from_cols_array(&columns);
        return Ok((matrix, rotation_of(matrix).ok_or("matrix")));
    }
    let vector = |name, default| Ok(node.numbers::<3>(name)?.map_or(default, DVec3::from_array));
    let (translation, scale) = (vector("translation", DVec3::ZERO)?, vector("scale", DVec3::ONE)?);
    let rotation = node.numbers::<4>("rotation")?.map_or(DQuat::IDENTITY, DQuat::from_array);
    // Quaternions come rounded to a few digits.
    let rotation = (rotation.length_squared() > 0.0).then(|| rotation.normalize());
    let matrix =
        DMat4::from_scale_rotation_translation(scale, rotation.unwrap_or(DQuat::IDENTITY), translation);
    Ok((matrix, rotation.ok_or("rotation")))
}

/// The rotation of a translation times a rotation times a scaling. A mirror counts as a negative scale of x.
fn rotation_of(matrix: DMat4) -> Option<DQuat> {
    let axis = |axis: DVec4| UnitVec3::new(axis.truncate()).map(UnitVec3::get);
    let (x, y, z) = (axis(matrix.x_axis)?, axis(matrix.y_axis)?, axis(matrix.z_axis)?);
    let volume = x.cross(y).dot(z);
    let rotation = DMat3::from_cols(if volume < 0.0 { -x } else { x }, y, z);
    (volume != 0.0).then(|| DQuat::from_mat3(&rotation).normalize())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(text: &str) -> Result<Vec<FileNode>, ReadError> {
        let json = Json::parse(text.as_bytes().to_vec(), 0, 32).unwrap();
        read(&json, 1, &mut Vec::new())
    }

    #[test]
    fn paths_to_nodes_are_identified_by_names() {
        let text = r#"{"nodes":[{"name":"a","children":[1]},{"children":[2]},{"name":"c"}]}"#;
        let json = Json::parse(text.as_bytes().to_vec(), 0, 32).unwrap();
        let tree = NodeTree::new(&json).unwrap();
        assert_eq!([2, 0].map(|node| tree.path(node)), ["a/#1/c", "a"]);
        let chain: Vec<String> = (0..100).map(|i| format!("{{\"children\":[{}]}}", i + 1)).collect();
        let text = format!("{{\"nodes\":[{},{{}}]}}", chain.join(","));
        let json = Json::parse(text.into_bytes(), 0, 32).unwrap();
        let path = NodeTree::new(&json).unwrap().path(100);
        assert!(path.starts_with("…/#69/#70/") && path.ends_with("/#99/#100"), "{path}");
    }

    #[test]
    fn chains_multiply_to_places_in_the_world() {
        let text = r#"{"nodes":[{"children":[1],"rotation":[0,1,0,0]},{"children":[2,3],"scale":[1,2,3]},
            {"mesh":0,"translation":[1,2,3]},{"mesh":0,"skin":0}],"skins":[{"joints":[0]}]}"#;
        let json = Json::parse(text.as_bytes().to_vec(), 0, 32).unwrap();
        let tree = NodeTree::new(&json).unwrap();
        let chain = tree.chain(2);
        assert_eq!(chain.iter().map(|link| link.0).collect::<Vec<_>>(), [0, 1, 2]);
        let product = chain.iter().fold(DMat4::IDENTITY, |above, link| above * link.1);
        let placed = read(&json, 1, &mut Vec::new()).unwrap();
        assert_eq!(placed[0].world_from_part, product);
        assert!(tree.chain(3).is_empty(), "only its joints move it");
    }

    #[test]
    fn transforms_multiply_down_the_tree() {
        let text = r#"{"scene":0,"scenes":[{"nodes":[0]}],"nodes":[
            {"children":[1],"translation":[1,2,3]},{"mesh":0,"scale":[2,2,2],"rotation":[0,0,1,0]},{"mesh":0}]}"#;
        let placed = nodes(text).unwrap();
        assert_eq!(placed.len(), 1, "the last node is not in the scene");
        let corner = placed[0].world_from_part.transform_point3(DVec3::new(1.0, 0.0, 0.0));
        assert_eq!(corner, DVec3::new(-1.0, 2.0, 3.0));
        assert_eq!(nodes(&text.replace("\"scene\":0,", "")).unwrap().len(), 2);
    }

    #[test]
    fn a_matrix_of_zeros_is_reported() {
        let json = Json::parse(br#"{"nodes":[{"mesh":0,"scale":[1,1,0]}]}"#.to_vec(), 0, 32).unwrap();
        let mut notes = Vec::new();
        read(&json, 1, &mut notes).unwrap();
        assert_eq!(notes.len(), 1);
    }

    #[test]
    fn a_rotation_of_zeros_is_reported() {
        let text =
            r#"{"nodes":[{"children":[1],"rotation":[0,0,0,0]},{"mesh":0},{"rotation":[0,0,0,1e-3]}]}"#;
        let json = Json::parse(text.as_bytes().to_vec(), 0, 32).unwrap();
        let mut notes = Vec::new();
        let placed = read(&json, 1, &mut notes).unwrap();
        assert_eq!(placed[0].world_from_part, DMat4::IDENTITY);
        let [note] = &notes[..] else { panic!("{notes:?}") };
        assert_eq!((note.place.to_string(), note.more), ("/nodes/0/rotation".to_owned(), 0));
    }

    #[test]
    fn what_is_no_tree_is_an_error() {
        for broken in [
            r#"{"nodes":[{"children":[0]}]}"#,
            r#"{"nodes":[{},{"children":[2]},{"children":[3]},{"children":[1]}]}"#,
            r#"{"nodes":[{"children":[2]},{"children":[2]},{}]}"#,
            r#"{"nodes":[{"children":[1,1]},{}]}"#,
            r#"{"nodes":[{"children":[9]}]}"#,
            r#"{"nodes":[{"mesh":1}]}"#,
            r#"{"nodes":[{"translation":[1,2]}]}"#,
            r#"{"nodes":[{"scale":[1,2,1e999]}]}"#,
            r#"{"scene":1,"scenes":[{}]}"#,
        ] {
            assert!(nodes(broken).is_err(), "{broken}");
        }
    }
}
