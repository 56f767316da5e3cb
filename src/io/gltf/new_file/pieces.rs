//! What the meshes and primitives of a new file are made of: objects of a part as parts of their own, triangles by primitive.

use crate::io::{Note, Part};
use crate::mesh::{
    Column, ColumnIndex, Columns, FaceLabels, Faces, Mesh, MeshBuilder, NONE, SmoothingGroups, triangulate,
};
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// A part for each object, in the order of their first faces, and one for points and lines; and the number of unused vertices,
/// which are omitted. `None` if all faces are of one object. Normals do not change: objects stay smooth across their borders.
pub fn by_object(part: &Part) -> Option<(Vec<Part>, usize)> {
    let mesh = &part.mesh;
    let labels = mesh.columns().objects.as_ref()?;
    let first = *labels.of_face.first()?;
    if labels.of_face.iter().all(|&label| label == first) {
        return None;
    }
    let mut faces_of: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    let mut order = Vec::new();
    for (face, &label) in labels.of_face.iter().enumerate() {
        let faces = faces_of.entry(label).or_default();
        if faces.is_empty() {
            order.push(label);
        }
        faces.push(face as u32);
    }
    let mut cutter = Cutter::new(mesh);
    let mut pieces = Vec::with_capacity(order.len() + 1);
    for label in order {
        let name = labels.names.get(label as usize).unwrap_or(&part.name).clone();
        pieces.push(Part { name, mesh: cutter.piece(&faces_of[&label]), non_finite_faces: Vec::new() });
    }
    if let Some(mesh) = cutter.loose() {
        pieces.push(Part { name: part.name.clone(), mesh, non_finite_faces: Vec::new() });
    }
    let unused = cutter.vertices.known.iter().filter(|(_, piece)| *piece == 0).count();
    Some((pieces, unused))
}

/// Cuts pieces out of a mesh, with numbers of their own.
struct Cutter<'a> {
    mesh: &'a Mesh,
    vertices: Numbers,
    normals: Numbers,
    uvs: Numbers,
    materials: Numbers,
}

/// Numbers of a list, counted anew for each piece in the order of use.
struct Numbers {
    /// The number within the last piece that uses it, and which piece that is.
    known: Vec<(u32, u32)>,
    piece: u32,
    /// The old numbers of the present piece.
    list: Vec<u32>,
}

impl Numbers {
    fn new(count: usize) -> Self {
        Self { known: vec![(0, 0); count], piece: 0, list: Vec::new() }
    }

    fn begin(&mut self) {
        self.piece += 1;
        self.list.clear();
    }

    fn of(&mut self, old: u32) -> u32 {
        let (number, piece) = &mut self.known[old as usize];
        if *piece != self.piece {
            (*number, *piece) = (self.list.len() as u32, self.piece);
            self.list.push(old);
        }
        *number
    }

    /// The numbers of a piece, which begins with them; [`NONE`] stays.
    fn of_all(&mut self, old: impl Iterator<Item = u32>) -> Vec<u32> {
        self.begin();
        old.map(|old| if old == NONE { NONE } else { self.of(old) }).collect()
    }

    fn values<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.list.iter().map(|&old| values[old as usize].clone()).collect()
    }
}

impl<'a> Cutter<'a> {
    fn new(mesh: &'a Mesh) -> Self {
        let columns = mesh.columns();
        Self {
            mesh,
            vertices: Numbers::new(mesh.vertex_count()),
            normals: Numbers::new(columns.normals.as_ref().map_or(0, |column| column.values.len())),
            uvs: Numbers::new(columns.uvs.as_ref().map_or(0, |column| column.values.len())),
            materials: Numbers::new(columns.materials.as_ref().map_or(0, |labels| labels.names.len())),
        }
    }

    fn piece(&mut self, numbers: &[u32]) -> Mesh {
        let (mesh, old) = (self.mesh, self.mesh.columns());
        let ranges = || numbers.iter().map(|&face| mesh.faces().range(face as usize));
        let corners: Vec<usize> = ranges().flatten().collect();
        let vertices = self.vertices.of_all(corners.iter().map(|&corner| mesh.faces().corners()[corner]));
        let mut faces = Faces::with_capacity(corners.len());
        let mut rest = vertices.as_slice();
        for range in ranges() {
            let (face, after) = rest.split_at(range.len());
            faces.push(face);
            rest = after;
        }
        let columns = Columns {
            normals: old.normals.as_ref().map(|column| cut(mesh, column, &corners, &mut self.normals)),
            // An object may have none.
            uvs: (old.uvs.as_ref().map(|column| cut(mesh, column, &corners, &mut self.uvs)))
                .filter(|column| !column.values.is_empty()),
            smoothing: old.smoothing.as_ref().map(|groups| SmoothingGroups {
                of_face: numbers.iter().map(|&face| groups.of_face[face as usize]).collect(),
                before_first: numbers.partition_point(|&face| (face as usize) < groups.before_first),
            }),
            materials: old.materials.as_ref().map(|labels| {
                let of_face = numbers.iter().map(|&face| labels.of_face[face as usize]);
                let of_face = self.materials.of_all(of_face);
                FaceLabels { of_face, names: self.materials.values(&labels.names) }
            }),
            ..Columns::default()
        };
        self.finish(faces, columns)
    }

    fn loose(&mut self) -> Option<Mesh> {
        let old = self.mesh.columns();
        if old.points.is_empty() && old.lines.is_empty() {
            return None;
        }
        let points = self.vertices.of_all(old.points.iter().copied());
        let line = |line: &Vec<u32>| line.iter().map(|&vertex| self.vertices.of(vertex)).collect();
        let lines = old.lines.iter().map(line).collect();
        let columns = Columns { points, lines, ..Columns::default() };
        Some(self.finish(Faces::new(), columns))
    }

    fn finish(&self, faces: Faces, mut columns: Columns) -> Mesh {
        let (mesh, old) = (self.mesh, self.mesh.columns());
        columns.colors = old.colors.as_ref().map(|colors| self.vertices.values(colors));
        let targets = old.morph_targets.iter();
        columns.morph_targets = targets.map(|target: &Vec<DVec3>| self.vertices.values(target)).collect();
        let positions = mesh.positions().gather(&self.vertices.list);
        let builder = MeshBuilder { positions, faces, columns };
        builder.build().expect("a piece of a valid mesh is valid")
    }
}

fn cut<T: Clone>(mesh: &Mesh, column: &Column<T>, corners: &[usize], numbers: &mut Numbers) -> Column<T> {
    let slot = |&corner: &usize| column.slot(corner, mesh.faces().corners()[corner]).unwrap_or(NONE);
    let index = numbers.of_all(corners.iter().map(slot));
    Column::per_corner(numbers.values(&column.values), index)
}

/// The parts to write: those given, or where one has several objects, these.
pub fn pieces(parts: &[Part]) -> (Vec<Cow<'_, Part>>, usize) {
    let mut all = Vec::with_capacity(parts.len());
    let mut unused = 0;
    for part in parts {
        match by_object(part) {
            None => all.push(Cow::Borrowed(part)),
            Some((pieces, left)) => {
                unused += left;
                all.extend(pieces.into_iter().map(Cow::Owned));
            }
        }
    }
    (all, unused)
}

#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Group {
    pub label: u32,
    pub flat: bool,
}

/// The corners of the triangles of each primitive; `None` for every corner of the mesh in order.
pub fn groups(mesh: &Mesh, notes: &mut Vec<Note>) -> Vec<(Group, Option<Vec<u32>>)> {
    let faces = mesh.face_count();
    // Corner numbers, three a triangle, and the face of each; `None` if the faces are triangles already.
    let triangles = (!mesh.faces().is_triangles()).then(|| {
        let cut = triangulate(mesh);
        if let Some(first) = cut.failed.first() {
            let text = format!("cut into fans, for lack of area or for crossing edges (first: face {first})");
            notes.extend(Note::counted(cut.failed.len(), ["polygon was", "polygons were"], text));
        }
        (cut.triangles, cut.source_face)
    });
    if faces == 0 {
        return Vec::new();
    }
    let flat = faces_without_normals(mesh);
    let labels = mesh.columns().materials.as_ref();
    let of_face = |face: u32| Group {
        label: labels.map_or(NONE, |labels| labels.of_face[face as usize]),
        flat: flat.as_ref().is_some_and(|flat| flat[face as usize]),
    };
    let first = of_face(0);
    if (1..faces as u32).all(|face| of_face(face) == first) {
        return vec![(first, triangles.map(|(corners, _)| corners.into_flattened()))];
    }
    let mut groups: Vec<(Group, Option<Vec<u32>>)> = Vec::new();
    let mut numbers: FxHashMap<Group, usize> = FxHashMap::default();
    for triangle in 0..triangles.as_ref().map_or(faces, |(_, faces)| faces.len()) {
        let (face, corners) = match &triangles {
            None => (triangle as u32, [0, 1, 2].map(|k| (3 * triangle + k) as u32)),
            Some((corners, faces)) => (faces[triangle], corners[triangle]),
        };
        let group = of_face(face);
        let number = *numbers.entry(group).or_insert_with(|| {
            groups.push((group, Some(Vec::new())));
            groups.len() - 1
        });
        groups[number].1.iter_mut().for_each(|all| all.extend(corners));
    }
    groups
}

/// Which faces have a corner without a normal; `None` if all have all or no normals are there at all.
fn faces_without_normals(mesh: &Mesh) -> Option<Vec<bool>> {
    let ColumnIndex::PerCorner(index) = &mesh.columns().normals.as_ref()?.index else { return None };
    let is_flat = |range: std::ops::Range<usize>| index[range].contains(&NONE);
    index.contains(&NONE).then(|| mesh.faces().ranges().map(is_flat).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    #[test]
    fn every_object_takes_along_what_its_faces_use() {
        let labels = |of_face: &[u32], names: &[&str]| {
            let names = names.iter().map(|&name| name.to_owned()).collect();
            Some(FaceLabels { of_face: of_face.to_vec(), names })
        };
        let columns = Columns {
            normals: Some(Column::per_corner(
                vec![DVec3::X, DVec3::Y, DVec3::Z],
                vec![2, 2, 2, 1, 1, NONE, 2, 2, 2, 2],
            )),
            uvs: Some(Column::per_vertex((0..6).map(|v| DVec2::splat(v.into())).collect())),
            colors: Some((0..6).map(|v| [v as f32, 0.0, 0.0, 1.0]).collect()),
            materials: labels(&[NONE, 1, 0], &["red", "blue"]),
            objects: labels(&[0, 1, 0], &["a", "b"]),
            smoothing: Some(SmoothingGroups { of_face: vec![0, 4, 5], before_first: 1 }),
            lines: vec![vec![4, 1]],
            ..Columns::default()
        };
        let mesh = MeshBuilder {
            positions: (0..6).map(|v| DVec3::new(v.into(), (v * v).into(), 0.0)).collect(),
            faces: Faces::polygons(vec![0, 1, 2, 3, 2, 1, 0, 3, 2, 1], vec![0, 3, 6, 10]),
            columns,
        };
        let part = Part { name: "all".into(), mesh: mesh.build().unwrap(), non_finite_faces: Vec::new() };
        let (pieces, unused) = by_object(&part).unwrap();
        assert_eq!(unused, 1, "vertex 5");
        let names: Vec<&str> = pieces.iter().map(|piece| piece.name.as_str()).collect();
        assert_eq!(names, ["a", "b", "all"]);

        // Corner by corner all is as it was, but the numbers.
        let old = &part.mesh;
        for (piece, corners) in pieces.iter().zip([vec![0, 1, 2, 6, 7, 8, 9], vec![3, 4, 5], vec![]]) {
            let mesh = &piece.mesh;
            assert_eq!(mesh.faces().corner_count(), corners.len());
            for (corner, before) in corners.into_iter().enumerate() {
                let (vertex, old_vertex) = (mesh.faces().corners()[corner], old.faces().corners()[before]);
                assert_eq!(mesh.positions().at(vertex), old.positions().at(old_vertex));
                let (new, old) = (mesh.columns(), old.columns());
                assert_eq!(new.colors.as_ref().unwrap()[vertex as usize][0], old_vertex as f32);
                let normal = |columns: &Columns, corner, vertex| {
                    columns.normals.as_ref().unwrap().get(corner, vertex).copied()
                };
                assert_eq!(normal(new, corner, vertex), normal(old, before, old_vertex));
                let uv = new.uvs.as_ref().unwrap().get(corner, vertex).unwrap();
                assert_eq!(*uv, DVec2::splat(old_vertex.into()));
            }
        }
        let material = |piece: usize| pieces[piece].mesh.columns().materials.clone().unwrap();
        assert_eq!((material(0).of_face, material(0).names), (vec![NONE, 0], vec!["red".to_owned()]));
        assert_eq!((material(1).of_face, material(1).names), (vec![0], vec!["blue".to_owned()]));
        let smoothing = pieces[0].mesh.columns().smoothing.as_ref().unwrap();
        assert_eq!((&smoothing.of_face[..], smoothing.before_first), (&[0, 5][..], 1));
        let loose = &pieces[2].mesh;
        assert_eq!((loose.vertex_count(), &loose.columns().lines[..]), (2, &[vec![0, 1]][..]));
        assert_eq!(loose.positions().at(0), old.positions().at(4));
    }

    #[test]
    fn one_object_is_no_reason_to_cut() {
        let with = |of_face: Vec<u32>| {
            let names = vec!["a".to_owned()];
            let columns = Columns { objects: Some(FaceLabels { of_face, names }), ..Columns::default() };
            let faces = Faces::triangles(vec![0, 1, 2, 2, 1, 0]);
            let mesh = MeshBuilder { positions: vec![DVec3::ZERO; 3].into(), faces, columns };
            Part { name: String::new(), mesh: mesh.build().unwrap(), non_finite_faces: Vec::new() }
        };
        assert!(by_object(&with(vec![0, 0])).is_none());
        assert_eq!(by_object(&with(vec![0, NONE])).unwrap().0.len(), 2);
    }
}
