//! The shapes behind the files of `data/`.

use libm::{cos, sin};
use std::f64::consts::{PI, TAU};

/// Polygons with a label each; the writer defines the meaning of labels.
#[derive(Clone, Default)]
pub struct Shape {
    pub positions: Vec<[f64; 3]>,
    pub faces: Vec<Face>,
}

#[derive(Clone)]
pub struct Face {
    pub corners: Vec<u32>,
    pub label: usize,
}

impl Shape {
    pub fn vertex(&mut self, position: [f64; 3]) -> u32 {
        self.positions.push(position);
        self.positions.len() as u32 - 1
    }

    pub fn face(&mut self, corners: &[u32], label: usize) {
        self.faces.push(Face { corners: corners.to_vec(), label });
    }

    /// Volume under the faces, each fanned from its first corner: positive if a closed shape faces outward.
    pub fn signed_volume(&self) -> f64 {
        let volume = |a: [f64; 3], b: [f64; 3], c: [f64; 3]| {
            (a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
                / 6.0
        };
        let at = |v: u32| self.positions[v as usize];
        self.triangles().iter().map(|&[a, b, c]| volume(at(a), at(b), at(c))).sum()
    }

    /// Whether every edge is run through once in each direction.
    pub fn is_closed(&self) -> bool {
        let mut edges = Vec::new();
        for face in &self.faces {
            let next = face.corners.iter().cycle().skip(1);
            edges.extend(face.corners.iter().zip(next).map(|(&a, &b)| (a, b)));
        }
        edges.sort_unstable();
        let unique = edges.windows(2).all(|pair| pair[0] != pair[1]);
        unique && edges.iter().all(|&(a, b)| edges.binary_search(&(b, a)).is_ok())
    }

    /// The faces as fans from their first corners. Only for convex ones and for volumes.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let fan = |face: &Face| {
            let [first, rest @ ..] = face.corners.as_slice() else { unreachable!("an empty face") };
            rest.windows(2).map(|pair| [*first, pair[0], pair[1]]).collect::<Vec<_>>()
        };
        self.faces.iter().flat_map(fan).collect()
    }

    /// Adds a closed prism over an outline in the x-y plane, counter-clockwise seen from +z; the caps are one polygon each.
    /// `side` returns the label of the side that follows each outline point, `cap` is that of the caps.
    fn prism(&mut self, outline: &[[f64; 2]], z: [f64; 2], cap: usize, side: impl Fn(usize) -> usize) {
        let back: Vec<u32> = outline.iter().map(|&[x, y]| self.vertex([x, y, z[0]])).collect();
        let front: Vec<u32> = outline.iter().map(|&[x, y]| self.vertex([x, y, z[1]])).collect();
        self.face(&front, cap);
        self.face(&back.iter().rev().copied().collect::<Vec<_>>(), cap);
        for i in 0..outline.len() {
            let j = (i + 1) % outline.len();
            self.face(&[back[i], back[j], front[j], front[i]], side(i));
        }
    }
}

/// Labels of [`gear`].
pub const GEAR_PARTS: [&str; 4] = ["face", "teeth", "hub", "bore"];

/// A spur gear about the y axis: flat faces, teeth with a 45° chamfer at the top, a hub that leaves the web in a
/// fillet and ends in a rounded rim, and a bore. All rings have the same number of points, so it is all quads.
pub fn gear() -> Shape {
    const TEETH: usize = 14;
    const CORNERS: usize = 6;
    // Radius and place within the tooth's pitch: root, flank (curved, in three points), tip.
    const TOOTH: [[f64; 2]; CORNERS] =
        [[0.86, 0.00], [0.86, 0.30], [0.95, 0.38], [1.00, 0.48], [1.00, 0.82], [0.95, 0.92]];
    let tooth = |i: usize| (TOOTH[i % CORNERS], (i / CORNERS) as f64);
    let angle = |i: usize| {
        let ([_, place], pitch) = tooth(i);
        TAU * (pitch + place) / TEETH as f64
    };
    // The closed cross-section, from the bore's lower rim outward and back: radius (`None`: the teeth's, less
    // the inset), height, and the label of the band that leads to the next ring.
    let mut rings: Vec<(Option<f64>, f64, f64, usize)> =
        vec![(Some(0.2), 0.0, 0.0, 0), (None, 0.0, 0.0, 1), (None, 0.0, 0.21, 1), (None, 0.04, 0.25, 0)];
    let arc = |rings: &mut Vec<_>, centre: [f64; 2], from: f64, to: f64| {
        for step in 0..=4 {
            let turn = (from + (to - from) * f64::from(step) / 4.0) * PI / 180.0;
            rings.push((Some(centre[0] + 0.1 * cos(turn)), 0.0, centre[1] + 0.1 * sin(turn), 2));
        }
    };
    arc(&mut rings, [0.60, 0.35], 270.0, 180.0);
    arc(&mut rings, [0.40, 0.45], 0.0, 90.0);
    rings.last_mut().expect("rings").3 = 0;
    rings.push((Some(0.2), 0.0, 0.55, 3));

    let mut shape = Shape::default();
    let around = TEETH * CORNERS;
    for &(radius, inset, height, _) in &rings {
        for i in 0..around {
            let radius = radius.unwrap_or(tooth(i).0[0] - inset);
            shape.vertex([radius * sin(angle(i)), height, radius * cos(angle(i))]);
        }
    }
    let at = |ring: usize, i: usize| ((ring % rings.len()) * around + i % around) as u32;
    for (ring, &(.., label)) in rings.iter().enumerate() {
        for i in 0..around {
            shape.face(&[at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)], label);
        }
    }
    shape.faces.sort_by_key(|face| face.label);
    shape
}

/// An L-shaped bracket. Labels are smoothing groups: 0 off, 1 the inner fillet with the flats that run into it,
/// 2 the rounded heel. The caps are concave polygons.
pub fn bracket() -> Shape {
    let arc = |centre: [f64; 2], radius: f64, from: f64, to: f64| {
        (0..=6).map(move |step| {
            let turn = (from + (to - from) * f64::from(step) / 6.0) * PI / 180.0;
            [centre[0] + radius * cos(turn), centre[1] + radius * sin(turn)]
        })
    };
    let mut outline: Vec<[f64; 2]> = arc([0.5, 0.5], 0.5, 180.0, 270.0).collect();
    outline.extend([[4.0, 0.0], [4.0, 0.6]]);
    let fillet = outline.len();
    outline.extend(arc([1.6, 1.6], 1.0, 270.0, 180.0));
    outline.extend([[0.6, 4.0], [0.0, 4.0]]);
    let mut shape = Shape::default();
    shape.prism(&outline, [-1.0, 1.0], 0, |side| match side {
        0..6 => 2,
        _ if (fillet - 1..fillet + 7).contains(&side) => 1,
        _ => 0,
    });
    shape
}

/// Prisms over an L with a corner in the middle of a straight edge, a five-pointed star and a U. Labels count
/// the prisms.
pub fn polygons() -> Shape {
    let l = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let star: Vec<[f64; 2]> = (0..10)
        .map(|i| {
            let (radius, turn) = (if i % 2 == 0 { 1.0 } else { 0.4 }, PI / 2.0 + PI * f64::from(i) / 5.0);
            [4.0 + radius * cos(turn), 1.0 + radius * sin(turn)]
        })
        .collect();
    let u = [[6.0, 0.0], [8.0, 0.0], [8.0, 2.0], [7.5, 2.0], [7.5, 0.5], [6.5, 0.5], [6.5, 2.0], [6.0, 2.0]];
    let mut shape = Shape::default();
    for (label, outline) in [&l[..], &star, &u].into_iter().enumerate() {
        shape.prism(outline, [0.0, 0.5], label, |_| label);
    }
    shape
}

/// A wedge-like prism whose edge carries points that are collinear as decimals but not as binary numbers, with
/// caps fanned from the end of that edge, as careless CAD exporters do: seven of eight cap triangles have no
/// direction of their own.
pub fn slivers() -> Shape {
    const STEPS: usize = 8;
    let mut shape = Shape::default();
    let tenth = |k: usize, scale: f64| (k as f64 * scale).round() / 100.0;
    let sheets = [0.1, 0.6].map(|low| {
        let mut sheet: Vec<u32> = (0..=STEPS)
            .map(|k| shape.vertex([tenth(k, 10.0), low + tenth(k, 2.0), -tenth(k, 30.0)]))
            .collect();
        sheet.push(shape.vertex([-0.7, low, -1.3]));
        sheet
    });
    let [bottom, top] = sheets;
    let count = bottom.len();
    for k in 1..count - 1 {
        shape.face(&[top[0], top[k], top[k + 1]], 0);
        shape.face(&[bottom[0], bottom[k + 1], bottom[k]], 0);
    }
    for i in 0..count {
        let j = (i + 1) % count;
        shape.face(&[bottom[i], bottom[j], top[j], top[i]], 0);
    }
    shape
}

/// A closed cylinder about y with a cone on top, in triangles.
pub fn part() -> Shape {
    const SIDES: usize = 16;
    let mut shape = Shape::default();
    let point = |i: usize, y: f64| {
        let turn = TAU * i as f64 / SIDES as f64;
        [5.0 * sin(turn), y, 5.0 * cos(turn)]
    };
    let low: Vec<u32> = (0..SIDES).map(|i| shape.vertex(point(i, 0.0))).collect();
    let high: Vec<u32> = (0..SIDES).map(|i| shape.vertex(point(i, 6.0))).collect();
    let centre = shape.vertex([0.0, 0.0, 0.0]);
    let tip = shape.vertex([0.0, 10.0, 0.0]);
    for i in 0..SIDES {
        let j = (i + 1) % SIDES;
        shape.face(&[low[i], low[j], high[j]], 0);
        shape.face(&[low[i], high[j], high[i]], 0);
        shape.face(&[high[i], high[j], tip], 0);
        shape.face(&[low[j], low[i], centre], 0);
    }
    shape
}

/// A grid of squares over x and z, facing +y where `height` is flat. `n` squares a side, `size` apart.
pub fn patch(n: usize, size: f64, height: impl Fn(f64, f64) -> f64) -> Shape {
    let mut shape = Shape::default();
    for row in 0..=n {
        for column in 0..=n {
            let (x, z) = (column as f64 * size, row as f64 * size);
            shape.vertex([x, height(x, z), z]);
        }
    }
    let at = |row: usize, column: usize| (row * (n + 1) + column) as u32;
    for row in 0..n {
        for column in 0..n {
            let corners =
                [at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1)];
            shape.face(&corners, 0);
        }
    }
    shape
}

/// A leaf as two sheets back to back: the same points twice, the second time wound the other way.
pub fn leaf() -> Shape {
    let mut shape = patch(6, 1.0 / 6.0, |x, z| 0.3 * sin(PI * x) * cos(0.5 * PI * z));
    let (vertices, faces) = (shape.positions.clone(), shape.faces.clone());
    let offset = vertices.len() as u32;
    shape.positions.extend(vertices);
    for Face { corners, .. } in faces {
        shape.face(&corners.iter().rev().map(|v| v + offset).collect::<Vec<_>>(), 1);
    }
    shape
}

/// A sphere cut along a meridian and at the poles, as texture coordinates make it, with those coordinates.
pub fn seamed_sphere() -> (Shape, Vec<[f64; 2]>) {
    const AROUND: usize = 24;
    const DOWN: usize = 12;
    let mut shape = Shape::default();
    let mut uvs = Vec::new();
    for row in 0..=DOWN {
        // At a pole each segment has its own copy, whose texture coordinate lies in the segment's middle.
        let is_pole = row == 0 || row == DOWN;
        for column in 0..AROUND + usize::from(!is_pole) {
            // The seam's two copies must coincide to the bit, so both take their angle modulo.
            let (turn, fall) =
                (TAU * (column % AROUND) as f64 / AROUND as f64, PI * row as f64 / DOWN as f64);
            let radius = if is_pole { 0.0 } else { sin(fall) };
            shape.vertex([radius * sin(turn), cos(fall), radius * cos(turn)]);
            let middle = if is_pole { 0.5 } else { 0.0 };
            uvs.push([(column as f64 + middle) / AROUND as f64, row as f64 / DOWN as f64]);
        }
    }
    let at = |row: usize, column: usize| match row {
        0 => column as u32,
        _ => (AROUND + (row - 1) * (AROUND + 1) + column) as u32,
    };
    for row in 0..DOWN {
        for column in 0..AROUND {
            let (left, right) = ([at(row, column), at(row + 1, column)], column + 1);
            if row + 1 < DOWN {
                shape.face(&[left[0], left[1], at(row + 1, right)], 0);
            } else {
                shape.face(&[left[0], left[1], at(row, right)], 0);
            }
            if row > 0 && row + 1 < DOWN {
                shape.face(&[left[0], at(row + 1, right), at(row, right)], 0);
            }
        }
    }
    (shape, uvs)
}

/// A wedge without any mirror symmetry, so that a mirrored copy looks like one.
pub fn wedge() -> Shape {
    let mut shape = Shape::default();
    let points = [
        [0.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [2.0, 0.0, 1.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.5, 1.0],
    ];
    for point in points {
        shape.vertex(point);
    }
    for corners in [[0, 1, 3], [0, 3, 2], [0, 4, 1], [2, 3, 5], [0, 2, 5], [0, 5, 4], [1, 4, 5], [1, 5, 3]] {
        shape.face(&corners, 0);
    }
    shape
}
