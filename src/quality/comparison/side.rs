//! The corners of a file, numbered through all its parts, and polygons that are triangles in another file.

use crate::mesh::{Faces, Mesh, triangulate};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Polygons of more corners are only compared from their first corner, and not with triangles.
pub(crate) const MOST_CORNERS: usize = 1024;

/// The corners of all parts of a file, numbered through.
pub(crate) struct Side<'a> {
    meshes: Vec<&'a Mesh>,
    /// The number of the first corner of each part, and of all corners at the end.
    starts: Vec<usize>,
}

impl<'a> Side<'a> {
    pub(crate) fn new(meshes: Vec<&'a Mesh>) -> Self {
        let mut starts = vec![0];
        for mesh in &meshes {
            starts.push(starts[starts.len() - 1] + mesh.faces().corner_count());
        }
        Self { meshes, starts }
    }

    pub(crate) fn corners(&self) -> usize {
        self.starts[self.meshes.len()]
    }

    pub(crate) fn faces(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.face_count()).sum()
    }

    /// The part of a corner, and its number in that part.
    pub(crate) fn locate(&self, corner: u32) -> (usize, usize) {
        let part = self.starts.partition_point(|&start| start <= corner as usize) - 1;
        (part, corner as usize - self.starts[part])
    }

    /// The bits of a corner's position in single precision, −0 taken as +0.
    pub(crate) fn place(&self, corner: u32) -> [u32; 3] {
        let (part, corner) = self.locate(corner);
        let mesh = self.meshes[part];
        let position = mesh.positions().at(mesh.faces().corners()[corner]);
        position.to_array().map(|x| (x as f32 + 0.0).to_bits())
    }

    /// All faces, as lists of corners.
    pub(crate) fn whole(&self) -> Faces {
        let mut faces = Faces::with_capacity(self.corners());
        let mut corners = Vec::new();
        for (mesh, start) in self.meshes.iter().zip(&self.starts) {
            for range in mesh.faces().ranges() {
                corners.clear();
                corners.extend(range.map(|corner| (start + corner) as u32));
                faces.push(&corners);
            }
        }
        faces
    }

    /// The triangles of marked faces, as lists of corners, and the face of each.
    pub(crate) fn triangles(&self, wanted: &[bool]) -> (Faces, Vec<u32>) {
        let (mut corners, mut owners) = (Vec::new(), Vec::new());
        let mut first_face = 0;
        for (mesh, &start) in self.meshes.iter().zip(&self.starts) {
            let cut = triangulate(mesh);
            for (triangle, face) in cut.triangles.iter().zip(cut.source_face) {
                if wanted[first_face + face as usize] {
                    corners.extend(triangle.iter().map(|corner| start as u32 + corner));
                    owners.push((first_face + face as usize) as u32);
                }
            }
            first_face += mesh.face_count();
        }
        (Faces::triangles(corners), owners)
    }
}

/// The most polygons at one position that are tried for a triangle.
const CANDIDATES: usize = 64;

/// A triangle, and the indices of its corners in the polygon that it was cut from.
struct Piece {
    triangle: u32,
    at: [usize; 3],
}

/// A polygon and the triangles that it became.
pub(crate) struct Cut {
    pub(crate) face: u32,
    pub(crate) triangles: Vec<u32>,
    /// Corners of the polygon and of triangles at the same position.
    pub(crate) pairs: Vec<[u32; 2]>,
    /// The number of triangles that run the other way.
    pub(crate) reversed: usize,
}

/// Finds marked polygons of one file that marked triangles of another fill: all corners of each triangle are at corners of the
/// polygon, and each edge of the polygon is an edge of a triangle.
pub(crate) fn cuts(sides: [&Side<'_>; 2], faces: [&Faces; 2], wanted: [&[bool]; 2]) -> Vec<Cut> {
    let corners_at = corners_at(sides[0], faces[0], wanted[0]);
    if corners_at.is_empty() {
        return Vec::new();
    }
    let mut pieces: BTreeMap<u32, Vec<Piece>> = BTreeMap::new();
    for triangle in (0..faces[1].len()).filter(|&face| wanted[1][face] && faces[1].face(face).len() == 3) {
        let places = [0, 1, 2].map(|i| sides[1].place(faces[1].face(triangle)[i]));
        let candidates = corners_at.get(&places[0]).into_iter().flatten().take(CANDIDATES);
        let homes = candidates
            .filter_map(|&face| Some((face, within(sides[0], faces[0].face(face as usize), places)?)));
        // If polygons are several times at one position, each has its own triangles.
        let has_room = |(face, _): &(u32, [usize; 3])| {
            let taken = pieces.get(face).map_or(0, Vec::len);
            taken + 2 < faces[0].face(*face as usize).len()
        };
        if let Some((face, at)) = homes.into_iter().find(has_room) {
            pieces.entry(face).or_default().push(Piece { triangle: triangle as u32, at });
        }
    }
    let filled =
        pieces.into_iter().filter(|(face, pieces)| fill(faces[0].face(*face as usize).len(), pieces));
    filled.map(|(face, pieces)| cut(faces, face, &pieces)).collect()
}

/// The polygons that have a corner at a position.
fn corners_at(side: &Side<'_>, faces: &Faces, wanted: &[bool]) -> FxHashMap<[u32; 3], Vec<u32>> {
    let mut at: FxHashMap<[u32; 3], Vec<u32>> = FxHashMap::default();
    for (face, corners) in faces.iter().enumerate().filter(|&(face, _)| wanted[face]) {
        if (4..=MOST_CORNERS).contains(&corners.len()) {
            for &corner in corners {
                at.entry(side.place(corner)).or_default().push(face as u32);
            }
        }
    }
    at
}

/// The indices of three positions among the corners of a polygon.
fn within(side: &Side<'_>, polygon: &[u32], places: [[u32; 3]; 3]) -> Option<[usize; 3]> {
    let find = |place: [u32; 3]| polygon.iter().position(|&corner| side.place(corner) == place);
    let [a, b, c] = places.map(find);
    let at = [a?, b?, c?];
    (at[0] != at[1] && at[1] != at[2] && at[2] != at[0]).then_some(at)
}

/// Whether triangles fill a polygon: two less than it has corners, and each of its edges is an edge of one.
fn fill(count: usize, pieces: &[Piece]) -> bool {
    let edges = pieces.iter().flat_map(|piece| [0, 1, 2].map(|i| [piece.at[i], piece.at[(i + 1) % 3]]));
    let on_rim = |[a, b]: [usize; 2]| match () {
        () if (a + 1) % count == b => Some(a),
        () if (b + 1) % count == a => Some(b),
        () => None,
    };
    let mut rim: Vec<usize> = edges.filter_map(on_rim).collect();
    rim.sort_unstable();
    pieces.len() + 2 == count && rim.into_iter().eq(0..count)
}

fn cut(faces: [&Faces; 2], face: u32, pieces: &[Piece]) -> Cut {
    let polygon = faces[0].face(face as usize);
    let pairs = pieces.iter().flat_map(|piece| {
        let triangle = faces[1].face(piece.triangle as usize);
        [0, 1, 2].map(|i| [polygon[piece.at[i]], triangle[i]])
    });
    // Once around the polygon its indices fall once.
    let falls = |piece: &Piece| (0..3).filter(|&i| piece.at[i] > piece.at[(i + 1) % 3]).count();
    Cut {
        face,
        triangles: pieces.iter().map(|piece| piece.triangle).collect(),
        pairs: pairs.collect(),
        reversed: pieces.iter().filter(|piece| falls(piece) > 1).count(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(at: &[[usize; 3]]) -> Vec<Piece> {
        at.iter().map(|&at| Piece { triangle: 0, at }).collect()
    }

    #[test]
    fn triangles_fill_a_polygon_or_do_not() {
        assert!(fill(4, &pieces(&[[0, 1, 2], [0, 2, 3]])));
        assert!(fill(4, &pieces(&[[1, 3, 0], [3, 1, 2]])));
        assert!(fill(5, &pieces(&[[1, 2, 3], [4, 1, 3], [4, 0, 1]])));
        assert!(!fill(4, &pieces(&[[0, 1, 2], [0, 1, 2]])), "one of them twice");
        assert!(!fill(4, &pieces(&[[0, 1, 2], [1, 2, 3]])), "they overlap");
        assert!(!fill(5, &pieces(&[[0, 1, 2], [0, 2, 3]])), "one is missing");
    }
}
