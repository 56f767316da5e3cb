//! The meshes that speed is measured on.

use std::collections::HashMap;

/// A mesh in plain slices.
pub struct Mesh {
    pub name: String,
    pub positions: Vec<[f32; 3]>,
    pub triangles: Vec<[u32; 3]>,
}

/// A displaced square grid of about this many triangles, whose vertices are moved along the plane by up to 0.3 cells: triangles
/// differ in size, as those of real meshes do.
pub fn grid(triangles: usize) -> Mesh {
    let n = ((triangles / 2) as f64).sqrt().round() as u32;
    let position = |i: u32| {
        let moved =
            |cell: u32, step: f64| (f64::from(cell) + 0.3 * libm::sin(step * f64::from(i))) / f64::from(n);
        let (x, y) = (moved(i % (n + 1), 12.9898), moved(i / (n + 1), 78.233));
        let height = 0.1 * libm::sin(17.0 * x) * libm::cos(13.0 * y) + 1e-3 * libm::sin(900.0 * x * y);
        [x as f32, y as f32, height as f32]
    };
    let cell = |i: u32| {
        let a = i / n * (n + 1) + i % n;
        [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]
    };
    Mesh {
        name: "grid".to_owned(),
        positions: (0..(n + 1) * (n + 1)).map(position).collect(),
        triangles: (0..n * n).flat_map(cell).collect(),
    }
}

/// A sphere of about this many triangles: the faces of an icosahedron, cut into triangles and blown up.
pub fn icosphere(triangles: usize) -> Mesh {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        corners.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let near = |a: usize, b: usize| {
        let squared: f64 = (0..3).map(|axis| corners[a][axis] - corners[b][axis]).map(|d| d * d).sum();
        squared < 4.1
    };
    let mut sphere = Sphere {
        corners: &corners,
        cuts: ((triangles / 20) as f64).sqrt().round() as usize,
        shared: HashMap::new(),
        mesh: Mesh { name: "icosphere".to_owned(), positions: Vec::new(), triangles: Vec::new() },
    };
    for a in 0..12 {
        for b in a + 1..12 {
            for c in (b + 1..12).filter(|&c| near(a, b) && near(b, c) && near(c, a)) {
                let outwards = triple_product(corners[a], corners[b], corners[c]) > 0.0;
                sphere.cut(if outwards { [a, b, c] } else { [a, c, b] });
            }
        }
    }
    sphere.mesh
}

fn triple_product(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

struct Sphere<'a> {
    corners: &'a [[f64; 3]],
    cuts: usize,
    /// Vertices on edges and corners of the icosahedron, by their barycentric place.
    shared: HashMap<Vec<(usize, usize)>, u32>,
    mesh: Mesh,
}

impl Sphere<'_> {
    fn cut(&mut self, face: [usize; 3]) {
        let cuts = self.cuts;
        let mut above: Vec<u32> = (0..=cuts).map(|j| self.vertex(face, [cuts - j, 0, j])).collect();
        for i in 1..=cuts {
            let row: Vec<u32> = (0..=cuts - i).map(|j| self.vertex(face, [cuts - i - j, i, j])).collect();
            for j in 0..=cuts - i {
                self.mesh.triangles.push([above[j], row[j], above[j + 1]]);
                if j < cuts - i {
                    self.mesh.triangles.push([row[j], row[j + 1], above[j + 1]]);
                }
            }
            above = row;
        }
    }

    fn vertex(&mut self, face: [usize; 3], parts: [usize; 3]) -> u32 {
        let (corners, positions) = (self.corners, &mut self.mesh.positions);
        let mut push = || {
            let sum = |axis: usize| (0..3).map(|k| corners[face[k]][axis] * parts[k] as f64).sum::<f64>();
            let point = [sum(0), sum(1), sum(2)];
            let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
            positions.push(point.map(|x| (x / length) as f32));
            positions.len() as u32 - 1
        };
        if !parts.contains(&0) {
            return push();
        }
        let mut place: Vec<_> = face.into_iter().zip(parts).filter(|&(_, part)| part > 0).collect();
        place.sort_unstable();
        *self.shared.entry(place).or_insert_with(push)
    }
}

/// The same mesh with vertices and triangles in random order.
pub fn shuffled(mesh: &Mesh) -> Mesh {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut below = |limit: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(state) * limit as u128) >> 64) as usize
    };
    let mut place: Vec<u32> = (0..mesh.positions.len() as u32).collect();
    for i in (1..place.len()).rev() {
        place.swap(i, below(i + 1));
    }
    let mut positions = vec![[0.0; 3]; mesh.positions.len()];
    for (vertex, &position) in mesh.positions.iter().enumerate() {
        positions[place[vertex] as usize] = position;
    }
    let mut triangles: Vec<[u32; 3]> =
        mesh.triangles.iter().map(|corners| corners.map(|vertex| place[vertex as usize])).collect();
    for i in (1..triangles.len()).rev() {
        triangles.swap(i, below(i + 1));
    }
    Mesh { name: format!("{}, shuffled", mesh.name), positions, triangles }
}
