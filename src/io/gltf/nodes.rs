//! The node tree: where meshes stand. No recursion, since chains of any length load.

use super::document::list;
use super::fields::{At, Fields, dangling};
use super::json::Json;
use crate::io::{FileNode, Note, Problem, ReadError};
use glam::{DMat4, DQuat, DVec3};

/// The meshes of the default scene (of all root nodes, where there is none), in the order of the tree.
pub(super) fn read(json: &Json, meshes: usize, notes: &mut Vec<Note>) -> Result<Vec<FileNode>, ReadError> {
    let root = Fields { json, object: json.root(), at: At::default() };
    let nodes = list(&root, "nodes")?;
    let fields = |node: usize| Fields { json, object: nodes[node], at: At::new("nodes", node) };
    let children =
        (0..nodes.len()).map(|node| children(&fields(node), nodes.len())).collect::<Result<Vec<_>, _>>()?;
    let order = tree_order(&children)?;

    let mut placed = Vec::new();
    let mut world = vec![DMat4::IDENTITY; nodes.len()];
    for &node in &order {
        world[node] *= local_matrix(&fields(node))?;
        if !world[node].is_finite() {
            let found = "a node whose place in the world is beyond what numbers can hold";
            return Err(ReadError::new(
                Problem::NonFinite,
                fields(node).at.place(),
                found,
                "check its scale",
            ));
        }
        for &child in &children[node] {
            world[child] = world[node];
        }
    }
    let shown = shown(&root, &children, nodes.len())?;
    let mut skinned_elsewhere = None;
    for &node in order.iter().filter(|&&node| shown[node]) {
        let fields = fields(node);
        let Some(part) = fields.index("mesh")? else { continue };
        if part >= meshes {
            return Err(dangling(fields.at.member("mesh"), "mesh", part, meshes));
        }
        // Only its joints move a skinned mesh; its node's own transform is ignored, says the standard.
        let skinned = fields.index("skin")?.is_some();
        if skinned && world[node] != DMat4::IDENTITY {
            skinned_elsewhere.get_or_insert(node);
        }
        let world_from_part = if skinned { DMat4::IDENTITY } else { world[node] };
        let name = fields.string("name")?.unwrap_or_default().into_owned();
        placed.push((node, FileNode { name, part, world_from_part }));
    }
    warn(&placed, skinned_elsewhere, notes);
    Ok(placed.into_iter().map(|(_, node)| node).collect())
}

fn children(node: &Fields<'_>, count: usize) -> Result<Vec<usize>, ReadError> {
    let children = node.indices("children")?;
    match children.iter().find(|&&child| child >= count) {
        Some(&child) => Err(dangling(node.at.member("children"), "node", child, count)),
        None => Ok(children),
    }
}

/// All nodes, each after its parent and before its next sibling.
fn tree_order(children: &[Vec<usize>]) -> Result<Vec<usize>, ReadError> {
    let mut parent = vec![None; children.len()];
    for (node, child) in
        children.iter().enumerate().flat_map(|(node, list)| list.iter().map(move |&child| (node, child)))
    {
        if let Some(other) = parent[child].replace(node) {
            let found = format!("a node that is a child of node {other} and of node {node}");
            let place = At::new("nodes", child).place();
            return Err(ReadError::new(
                Problem::Range,
                place,
                found,
                "nodes must form trees; export the file again",
            ));
        }
    }
    let mut order = Vec::with_capacity(children.len());
    let mut open: Vec<usize> = (0..children.len()).rev().filter(|&node| parent[node].is_none()).collect();
    while let Some(node) = open.pop() {
        order.push(node);
        open.extend(children[node].iter().rev());
    }
    if order.len() == children.len() {
        return Ok(order);
    }
    // With one parent each, what no root leads to are cycles and what hangs on them.
    let mut reached = vec![false; children.len()];
    order.iter().for_each(|&node| reached[node] = true);
    let mut node = reached.iter().position(|reached| !reached).unwrap_or(0);
    let mut seen = vec![false; children.len()];
    while !std::mem::replace(&mut seen[node], true) {
        node = parent[node].unwrap_or(node);
    }
    let place = At::new("nodes", node).place();
    let found = "a node that is its own ancestor";
    Err(ReadError::new(Problem::Range, place, found, "nodes must form trees; export the file again"))
}

/// Which nodes the default scene shows.
fn shown(root: &Fields<'_>, children: &[Vec<usize>], count: usize) -> Result<Vec<bool>, ReadError> {
    let scenes = list(root, "scenes")?;
    let Some(scene) = root.index("scene")? else { return Ok(vec![true; count]) };
    let Some(&object) = scenes.get(scene) else {
        return Err(dangling(root.at.member("scene"), "scene", scene, scenes.len()));
    };
    let scene = Fields { json: root.json, object, at: At::new("scenes", scene) };
    let mut shown = vec![false; count];
    let mut open = scene.indices("nodes")?;
    if let Some(&node) = open.iter().find(|&&node| node >= count) {
        return Err(dangling(scene.at.member("nodes"), "node", node, count));
    }
    while let Some(node) = open.pop() {
        if !std::mem::replace(&mut shown[node], true) {
            open.extend(&children[node]);
        }
    }
    Ok(shown)
}

fn local_matrix(node: &Fields<'_>) -> Result<DMat4, ReadError> {
    if let Some(columns) = node.numbers::<16>("matrix")? {
        return Ok(DMat4::from_cols_array(&columns));
    }
    let vector = |name, default| Ok(node.numbers::<3>(name)?.map_or(default, DVec3::from_array));
    let (translation, scale) = (vector("translation", DVec3::ZERO)?, vector("scale", DVec3::ONE)?);
    let rotation = node.numbers::<4>("rotation")?.map_or(DQuat::IDENTITY, DQuat::from_array);
    // Quaternions come rounded to a few digits; a length of zero means nothing at all.
    let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    Ok(DMat4::from_scale_rotation_translation(scale, rotation, translation))
}

fn warn(placed: &[(usize, FileNode)], skinned_elsewhere: Option<usize>, notes: &mut Vec<Note>) {
    let mut singular = placed.iter().filter(|(_, node)| node.world_from_part.determinant() == 0.0);
    if let Some((node, _)) = singular.next() {
        let more = match singular.count() {
            0 => String::new(),
            more => format!(" (and {more} more nodes)"),
        };
        let text = format!("a node squeezes its mesh flat: normals have no direction there{more}");
        notes.push(Note::warning(At::new("nodes", *node).place(), text));
    }
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
    fn a_matrix_of_zeros_is_told() {
        let json = Json::parse(br#"{"nodes":[{"mesh":0,"scale":[1,1,0]}]}"#.to_vec(), 0, 32).unwrap();
        let mut notes = Vec::new();
        read(&json, 1, &mut notes).unwrap();
        assert_eq!(notes.len(), 1);
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
