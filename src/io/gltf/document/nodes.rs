//! The node tree: where meshes stand. No recursion, since chains of any length load.

use crate::io::gltf::document::records::list;
use crate::io::gltf::json::fields::{At, Fields, dangling};
use crate::io::gltf::json::tree::{Json, Value};
use crate::io::{FileNode, Note, Problem, ReadError, Severity};
use crate::num::UnitVec3;
use glam::{DMat3, DMat4, DQuat, DVec3, DVec4};

/// The meshes of the default scene (of all root nodes, where there is none), in the order of the tree.
pub fn read(json: &Json, meshes: usize, notes: &mut Vec<Note>) -> Result<Vec<FileNode>, ReadError> {
    let mut placed = Vec::new();
    let (mut unturned, mut skinned_elsewhere) = (Vec::new(), None);
    each(json, |node| {
        if node.without_rotation == Some((node.number, "rotation")) {
            unturned.push(node.number);
        }
        let Some(part) = node.fields.index("mesh")? else { return Ok(()) };
        if part >= meshes {
            return Err(dangling(node.fields.at.member("mesh"), "mesh", part, meshes));
        }
        if !node.shown {
            return Ok(());
        }
        // Only its joints move a skinned mesh; its node's own transform is ignored, says the standard.
        let skinned = node.fields.index("skin")?.is_some();
        if skinned && node.world != DMat4::IDENTITY {
            skinned_elsewhere.get_or_insert(node.number);
        }
        let world_from_part = if skinned { DMat4::IDENTITY } else { node.world };
        let name = node.fields.string("name")?.unwrap_or_default().into_owned();
        placed.push(FileNode { number: node.number, name, part, world_from_part });
        Ok(())
    })?;
    warn(&placed, &unturned, skinned_elsewhere, notes);
    Ok(placed)
}

/// A node at its place.
pub struct Placed<'a> {
    pub number: usize,
    pub fields: Fields<'a>,
    /// From its own space to the world's.
    pub world: DMat4,
    /// The rotations of the node and of all above it, one after the other: how it stands with all scaling ignored.
    pub turn: DQuat,
    /// The nearest node at or above it that has no rotation, and the member that should give it: a quaternion of length 0,
    /// or a matrix without an inverse.
    pub without_rotation: Option<(usize, &'static str)>,
    /// Whether the default scene has it.
    pub shown: bool,
}

/// The nodes of a file, for questions about single ones.
pub(crate) struct NodeTree<'a> {
    json: &'a Json,
    nodes: Vec<Value>,
    tree: Tree,
}

impl<'a> NodeTree<'a> {
    /// The most nodes of a way that are told: those nearest to its end.
    const DEEPEST: usize = 32;

    pub fn new(json: &'a Json) -> Result<Self, ReadError> {
        let nodes = list(&Fields { json, object: json.root(), at: At::default() }, "nodes")?;
        let fields = |node: usize| Fields { json, object: nodes[node], at: At::new("nodes", node) };
        let tree = Tree::new((0..nodes.len()).map(fields), nodes.len())?;
        Ok(Self { json, nodes, tree })
    }

    fn fields(&self, node: usize) -> Fields<'a> {
        Fields { json: self.json, object: self.nodes[node], at: At::new("nodes", node) }
    }

    /// A node with those above it, from the root on, or from the most that are told, and whether there are more.
    fn way(&self, node: usize) -> (Vec<usize>, bool) {
        let parent = |&node: &usize| Some(self.tree.parent[node] as usize).filter(|_| !self.is_root(node));
        let mut way: Vec<usize> = std::iter::successors(Some(node), parent).take(Self::DEEPEST + 1).collect();
        let is_cut = way.len() > Self::DEEPEST;
        way.truncate(Self::DEEPEST);
        way.reverse();
        (way, is_cut)
    }

    fn is_root(&self, node: usize) -> bool {
        self.tree.parent[node] == NO_NODE
    }

    /// The name of a node, or its number, as `#7`, if it has none.
    pub(crate) fn name(&self, node: usize) -> String {
        let name = self.fields(node).string("name").ok().flatten().unwrap_or_default();
        if name.is_empty() { format!("#{node}") } else { name.into_owned() }
    }

    /// The names of a node and of all above it, from the root on, as `body/arm/hand`. Of very deep ones the names nearest to
    /// the node are told.
    pub fn path(&self, node: usize) -> String {
        let (way, is_cut) = self.way(node);
        let names: Vec<String> = way.into_iter().map(|node| self.name(node)).collect();
        format!("{}{}", if is_cut { "…/" } else { "" }, names.join("/"))
    }

    /// The matrices that place a mesh: of each node above it and of its own, from the root on, from the node's space to its
    /// parent's, beside the node's number. Of very deep ones those nearest to the mesh; none for a skinned mesh, which only its
    /// joints move.
    pub(crate) fn chain(&self, node: usize) -> Vec<(usize, DMat4)> {
        let is_skinned = self.fields(node).index("skin").is_ok_and(|skin| skin.is_some());
        let way = if is_skinned { Vec::new() } else { self.way(node).0 };
        let local = |node: usize| Some((node, Local::new(&self.fields(node)).ok()?.matrix));
        way.into_iter().filter_map(local).collect()
    }
}

/// Visits all nodes, each after its parent and before its next sibling.
pub fn each<'a>(
    json: &'a Json,
    mut visit: impl FnMut(Placed<'a>) -> Result<(), ReadError>,
) -> Result<(), ReadError> {
    let root = Fields { json, object: json.root(), at: At::default() };
    let nodes = list(&root, "nodes")?;
    let fields = |node: usize| Fields { json, object: nodes[node], at: At::new("nodes", node) };
    let tree = Tree::new((0..nodes.len()).map(fields), nodes.len())?;
    let shown = tree.shown(&root)?;
    // The way from a root to the node at hand, with the place of each node in the world.
    let mut path: Vec<(u32, Above)> = Vec::new();
    for node in tree.order()? {
        let number = node as usize;
        while path.last().is_some_and(|&(above, ..)| above != tree.parent[number]) {
            path.pop();
        }
        let fields = fields(number);
        let Local { matrix, rotation, told_by } = Local::new(&fields)?;
        let above = path.last().map_or(Above::ROOT, |&(_, above)| above);
        let world = above.world * matrix;
        let turn = above.turn * rotation.unwrap_or(DQuat::IDENTITY);
        let without_rotation =
            if rotation.is_some() { above.without_rotation } else { Some((number, told_by)) };
        if !world.is_finite() {
            let found = "a node whose place in the world is beyond what numbers can hold";
            return Err(ReadError::new(Problem::NonFinite, fields.at.place(), found, "check its scale"));
        }
        path.push((node, Above { world, turn, without_rotation }));
        visit(Placed { number, fields, world, turn, without_rotation, shown: shown[number] })?;
    }
    Ok(())
}

/// What a node hands down to its children; as in [`Placed`].
#[derive(Clone, Copy)]
struct Above {
    world: DMat4,
    turn: DQuat,
    without_rotation: Option<(usize, &'static str)>,
}

impl Above {
    /// Above the roots.
    const ROOT: Self = Self { world: DMat4::IDENTITY, turn: DQuat::IDENTITY, without_rotation: None };
}

/// No node.
const NO_NODE: u32 = u32::MAX;

/// Who is whose child. Numbers are small, since a file may have millions of nodes.
struct Tree {
    /// Where each node's children begin in `children`, with the total at the end.
    first_child: Vec<u32>,
    children: Vec<u32>,
    parent: Vec<u32>,
}

impl Tree {
    fn new<'a>(nodes: impl Iterator<Item = Fields<'a>>, count: usize) -> Result<Tree, ReadError> {
        let mut tree = Tree { first_child: vec![0], children: Vec::new(), parent: vec![NO_NODE; count] };
        for (node, fields) in nodes.enumerate() {
            for child in fields.indices("children")? {
                let Some(parent) = tree.parent.get_mut(child) else {
                    return Err(dangling(fields.at.member("children"), "node", child, count));
                };
                if *parent != NO_NODE {
                    let found = format!("a node that is a child of node {parent} and of node {node}");
                    return Err(no_tree(child, found));
                }
                *parent = node as u32;
                tree.children.push(child as u32);
            }
            tree.first_child.push(tree.children.len() as u32);
        }
        Ok(tree)
    }

    fn children(&self, node: u32) -> &[u32] {
        let node = node as usize;
        &self.children[self.first_child[node] as usize..self.first_child[node + 1] as usize]
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
        // With one parent each, what no root leads to are cycles and what hangs on them.
        let mut reached = vec![false; count];
        order.iter().for_each(|&node| reached[node as usize] = true);
        let mut node = reached.iter().position(|reached| !reached).unwrap_or(0);
        while !std::mem::replace(&mut reached[node], true) {
            node = self.parent[node] as usize;
        }
        Err(no_tree(node, "a node that is its own ancestor".to_owned()))
    }

    /// Which nodes the default scene shows; all, where there is none.
    fn shown(&self, root: &Fields<'_>) -> Result<Vec<bool>, ReadError> {
        let count = self.parent.len();
        let scenes = list(root, "scenes")?;
        let Some(scene) = root.index("scene")? else { return Ok(vec![true; count]) };
        let Some(&object) = scenes.get(scene) else {
            return Err(dangling(root.at.member("scene"), "scene", scene, scenes.len()));
        };
        let scene = Fields { json: root.json, object, at: At::new("scenes", scene) };
        let mut shown = vec![false; count];
        let mut open: Vec<u32> = Vec::new();
        for node in scene.indices("nodes")? {
            if node >= count {
                return Err(dangling(scene.at.member("nodes"), "node", node, count));
            }
            open.push(node as u32);
        }
        while let Some(node) = open.pop() {
            if !std::mem::replace(&mut shown[node as usize], true) {
                open.extend(self.children(node));
            }
        }
        Ok(shown)
    }
}

fn no_tree(node: usize, found: String) -> ReadError {
    let place = At::new("nodes", node).place();
    ReadError::new(Problem::Range, place, found, "nodes must form trees; export the file again")
}

/// Where a node stands in its parent.
struct Local {
    matrix: DMat4,
    rotation: Option<DQuat>,
    /// The member that tells the rotation.
    told_by: &'static str,
}

impl Local {
    fn new(node: &Fields<'_>) -> Result<Self, ReadError> {
        if let Some(columns) = node.numbers::<16>("matrix")? {
            let matrix = DMat4::from_cols_array(&columns);
            return Ok(Self { matrix, rotation: rotation_of(matrix), told_by: "matrix" });
        }
        let vector = |name, default| Ok(node.numbers::<3>(name)?.map_or(default, DVec3::from_array));
        let (translation, scale) = (vector("translation", DVec3::ZERO)?, vector("scale", DVec3::ONE)?);
        let rotation = node.numbers::<4>("rotation")?.map_or(DQuat::IDENTITY, DQuat::from_array);
        // Quaternions come rounded to a few digits.
        let rotation = (rotation.length_squared() > 0.0).then(|| rotation.normalize());
        let turned = rotation.unwrap_or(DQuat::IDENTITY);
        let matrix = DMat4::from_scale_rotation_translation(scale, turned, translation);
        Ok(Self { matrix, rotation, told_by: "rotation" })
    }
}

/// The rotation of a matrix that is a translation times a rotation times a scaling, as the standard wants each to be. A
/// mirror is taken for a negative scale of x, as is usual: the matrix alone does not tell of which axis it is.
fn rotation_of(matrix: DMat4) -> Option<DQuat> {
    let axis = |axis: DVec4| UnitVec3::new(axis.truncate()).map(UnitVec3::get);
    let (x, y, z) = (axis(matrix.x_axis)?, axis(matrix.y_axis)?, axis(matrix.z_axis)?);
    let volume = x.cross(y).dot(z);
    let turned = DMat3::from_cols(if volume < 0.0 { -x } else { x }, y, z);
    (volume != 0.0).then(|| DQuat::from_mat3(&turned).normalize())
}

fn warn(placed: &[FileNode], unturned: &[usize], skinned_elsewhere: Option<usize>, notes: &mut Vec<Note>) {
    let places = unturned.iter().map(|&node| At::new("nodes", node).member("rotation"));
    let text = "a rotation of zeros is none: the node stands unturned";
    notes.extend(Note::for_all(Severity::Warning, unturned.len() as u64, places, text));
    let singular = placed.iter().filter(|node| node.world_from_part.determinant() == 0.0);
    let places = singular.clone().map(|node| At::new("nodes", node.number).place());
    let text = "a node squeezes its mesh flat: normals have no direction there";
    notes.extend(Note::for_all(Severity::Warning, singular.count() as u64, places, text));
    if let Some(node) = skinned_elsewhere {
        let text = "a skinned mesh under a moved node: only its joints count, so it stands in its bind pose";
        notes.push(Note { place: At::new("nodes", node).place(), ..Note::remark(text) });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(text: &str) -> Result<Vec<FileNode>, ReadError> {
        let json = Json::parse(text.as_bytes().to_vec(), 0, 32).unwrap();
        read(&json, 1, &mut Vec::new())
    }

    #[test]
    fn ways_to_nodes_are_identified_by_names() {
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
