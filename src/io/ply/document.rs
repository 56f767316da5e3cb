//! A PLY file as it was read, and the roles of its elements and properties in the mesh.

use super::header::{Element, Header, Kind};
use super::scalar::Scalar;
use crate::io::{Place, Problem, ReadError};

/// A PLY file as it was read.
#[derive(Clone, Debug)]
pub struct PlyDocument {
    pub(in crate::io) bytes: Vec<u8>,
    pub(super) header: Header,
    pub(super) roles: Roles,
    /// Whether ascii rows share lines.
    pub(super) shared_lines: bool,
    pub(super) packed: Packed,
}

/// Whether stored normals are normalised integers.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Packed {
    pub vertices: bool,
    pub faces: bool,
}

impl PlyDocument {
    /// The elements and properties that are not part of the mesh.
    pub(in crate::io) fn outside_meshes(&self) -> Vec<String> {
        let mut left = Vec::new();
        for (number, element) in self.header.elements.iter().enumerate() {
            match self.roles.used(number) {
                _ if element.count == 0 => {}
                None => left.push(format!("the element `{}`", element.name)),
                Some(used) => {
                    let names = element.properties.iter().enumerate().filter(|(at, _)| !used.contains(at));
                    let names: Vec<String> =
                        names.map(|(_, property)| format!("`{}`", property.name)).collect();
                    if !names.is_empty() {
                        left.push(format!("{} of the element `{}`", names.join(", "), element.name));
                    }
                }
            }
        }
        left
    }
}

/// The elements that make the mesh, as numbers of the header's.
#[derive(Clone, Debug)]
pub(super) struct Roles {
    pub vertex: VertexRole,
    /// Faces, or else triangle strips.
    pub face: Option<FaceRole>,
    /// The element of edges, and its two vertices.
    pub edge: Option<(usize, [usize; 2])>,
}

#[derive(Clone, Debug)]
pub(super) struct VertexRole {
    pub element: usize,
    pub position: [usize; 3],
    pub normal: Option<[usize; 3]>,
    pub uv: Option<[usize; 2]>,
    pub color: Option<[usize; 3]>,
    pub opacity: Option<usize>,
}

#[derive(Clone, Debug)]
pub(super) struct FaceRole {
    pub element: usize,
    pub are_strips: bool,
    pub list: usize,
    pub normal: Option<[usize; 3]>,
    /// A list of two coordinates a corner.
    pub corner_uvs: Option<usize>,
}

const NORMALS: [[&str; 3]; 3] =
    [["nx", "ny", "nz"], ["normal_x", "normal_y", "normal_z"], ["normalx", "normaly", "normalz"]];
const UVS: [[&str; 2]; 5] =
    [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["texture_s", "texture_t"], ["tx", "ty"]];
const COLORS: [[&str; 3]; 3] =
    [["red", "green", "blue"], ["diffuse_red", "diffuse_green", "diffuse_blue"], ["r", "g", "b"]];
const LISTS: [&str; 4] = ["vertex_indices", "vertex_index", "vertex_indexes", "indices"];

fn first_of<const N: usize>(element: &Element, names: &[[&str; N]]) -> Option<[usize; N]> {
    names.iter().find_map(|&names| element.scalars(names))
}

impl Roles {
    /// Finds the roles. Of several elements with one name, the first has the role; the others are kept in the document.
    pub fn of(header: &Header) -> Result<Roles, ReadError> {
        let named = |name: &str| header.elements.iter().position(|element| element.name == name);
        let Some(vertex) = named("vertex") else {
            let found = "the header has no element `vertex`";
            let advice = "name the element with the vertices `vertex`";
            return Err(ReadError::new(Problem::Syntax, Place::File, found, advice));
        };
        let faces = named("face").map(|element| (element, false));
        let faces = faces.or_else(|| named("tristrips").map(|element| (element, true)));
        let face = faces.map(|(element, are_strips)| face_role(header, element, are_strips)).transpose()?;
        let ends = |element: usize| header.elements[element].scalars(["vertex1", "vertex2"]);
        let edge = named("edge").and_then(|element| Some((element, ends(element)?)));
        Ok(Roles { vertex: vertex_role(header, vertex)?, face, edge })
    }

    /// The properties of an element that have a role; `None` if it has none itself.
    pub fn used(&self, element: usize) -> Option<Vec<usize>> {
        let vertex = &self.vertex;
        if vertex.element == element {
            let triples = [Some(vertex.position), vertex.normal, vertex.color].into_iter().flatten();
            let others = vertex.uv.into_iter().flatten().chain(vertex.opacity);
            return Some(triples.flatten().chain(others).collect());
        }
        if let Some(face) = self.face.as_ref().filter(|face| face.element == element) {
            let normals = face.normal.into_iter().flatten();
            return Some(normals.chain(face.corner_uvs).chain([face.list]).collect());
        }
        self.edge.filter(|edge| edge.0 == element).map(|edge| edge.1.to_vec())
    }
}

fn vertex_role(header: &Header, number: usize) -> Result<VertexRole, ReadError> {
    let element = &header.elements[number];
    let Some(position) = element.scalars(["x", "y", "z"]) else {
        let found = "the vertices have no scalar properties `x`, `y` and `z`";
        return Err(ReadError::new(Problem::Syntax, Place::Line(element.line), found, "correct the header"));
    };
    let color = first_of(element, &COLORS);
    let opacity = ["alpha", "diffuse_alpha", "a"].iter().find_map(|name| element.scalars([*name]));
    Ok(VertexRole {
        element: number,
        position,
        normal: first_of(element, &NORMALS),
        uv: first_of(element, &UVS),
        color,
        opacity: opacity.map(|[at]| at),
    })
}

fn face_role(header: &Header, number: usize, are_strips: bool) -> Result<FaceRole, ReadError> {
    let element = &header.elements[number];
    let is_index_list =
        |&at: &usize| matches!(element.properties[at].kind, Kind::List { item, .. } if item.is_integer());
    let list = LISTS.iter().filter_map(|name| element.property(name)).find(is_index_list);
    let Some(list) = list else {
        let found = format!("the element `{}` has no integer list `vertex_indices`", element.name);
        return Err(ReadError::new(Problem::Syntax, Place::Line(element.line), found, "correct the header"));
    };
    let is_float_list = |&at: &usize| {
        matches!(element.properties[at].kind, Kind::List { item: Scalar::F32 | Scalar::F64, .. })
    };
    let corner_uvs = element.property("texcoord").filter(is_float_list);
    Ok(FaceRole { element: number, are_strips, list, normal: first_of(element, &NORMALS), corner_uvs })
}
