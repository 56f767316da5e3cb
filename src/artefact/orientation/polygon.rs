//! A rotated polygon, and the law of its scanline.

use super::super::prelude::*;
use crate::mesh::triangulate;

const MOST_CORNERS: usize = 1024;

/// A plane polygon with a colour at each corner, about the origin; its farthest corner is at 1.
pub(super) struct Polygon {
    corners: Vec<DVec2>,
    colours: Vec<LinearRgb>,
    mesh: Mesh,
    normals: NormalField,
}

impl Polygon {
    /// The colours of the lectures' vertices 1 to 4.
    pub(super) const LECTURES: [[f64; 3]; 4] =
        [[0.0, 0.4, 0.4], [0.0, 0.2, 0.2], [0.2, 0.6, 0.6], [0.4, 0.4, 0.0]];

    /// The side of the window; the farthest corner is at 1.
    pub(super) const WINDOW: f64 = 2.3;

    /// The lectures' diamond, or the first face of a mesh that has four corners or more, or its first.
    ///
    /// # Errors
    /// A polygon that visits a place twice, crosses itself, or is thinner than two pixels of a picture of this size.
    pub(super) fn of(own: Option<&UserMesh>, size: u32) -> Result<Self> {
        let Some(own) = own else {
            let corners = vec![DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];
            return Self::new(corners, Self::LECTURES.map(LinearRgb::from).to_vec(), None);
        };
        let unsuitable = |key, values: &[(&'static str, String)]| {
            let name = ("mesh", Value::from(own.name));
            let values = values.iter().map(|(name, value)| (*name, value.as_str().into()));
            ArtefactError::request(key, &values.chain([name]).collect::<Vec<_>>())
        };
        let pair = |[first, second]: [usize; 2]| {
            [("first", first), ("second", second)].map(|(name, number)| (name, number.to_string()))
        };
        let faces = own.mesh.faces();
        let Some(face) = faces.iter().find(|face| face.len() > 3).or_else(|| faces.iter().next()) else {
            return Err(unsuitable("no-faces", &[]));
        };
        if face.len() > MOST_CORNERS {
            return Err(unsuitable("many-corners", &[("corners", face.len().to_string())]));
        }
        let points: Vec<DVec3> = face.iter().map(|&vertex| own.mesh.positions().at(vertex)).collect();
        let colours = match &own.mesh.columns().colors {
            Some(colours) => {
                let of = |&vertex: &u32| {
                    let [r, g, b, _] = colours[vertex as usize].map(f64::from);
                    LinearRgb::new(r, g, b)
                };
                face.iter().map(of).collect()
            }
            None => {
                (0..face.len()).map(|corner| Self::LECTURES[corner % Self::LECTURES.len()].into()).collect()
            }
        };
        if let Some(corners) = same_place(&points) {
            return Err(unsuitable("corners-in-one-place", &pair(corners)));
        }
        let flat = flattened(&points).ok_or_else(|| unsuitable("no-area", &[]))?;
        if let Some(edges) = crossing(&flat) {
            return Err(unsuitable("crossing-edges", &pair(edges)));
        }
        let width = mean_width(&flat) * f64::from(size) / Self::WINDOW;
        if width <= ROUNDING * f64::from(size) {
            return Err(unsuitable("no-area", &[]));
        }
        if width < 2.0 {
            let values = [("width", format!("{width:.2}")), ("size", size.to_string())];
            return Err(unsuitable("thin-polygon", &values));
        }
        Self::new(centred(flat)?, colours, None)
    }

    fn new(corners: Vec<DVec2>, colours: Vec<LinearRgb>, triangles: Option<Vec<u32>>) -> Result<Self> {
        let count = corners.len() as u32;
        let faces = match triangles {
            Some(triangles) => Faces::triangles(triangles),
            None => Faces::polygons((0..count).collect(), vec![0, count]),
        };
        let positions = corners.iter().map(|corner| corner.extend(0.0)).collect();
        let mesh = build(positions, faces)?;
        let normals = smooth(&mesh, Weight::Angle);
        Ok(Self { corners, colours, mesh, normals })
    }

    /// The same cut into triangles, one way or the other: convex polygons into a fan about the first or second corner, others by
    /// Delaunay's rule, or so with a diagonal turned.
    pub(super) fn cut(&self, other_way: bool) -> Result<Self> {
        let count = self.corners.len() as u32;
        let triangles = if self.is_convex() {
            let at = |k: u32| (u32::from(other_way) + k) % count;
            (1..count - 1).map(|k| [at(0), at(k), at(k + 1)]).collect()
        } else {
            let mut triangles = triangulate(&self.mesh).triangles;
            if other_way {
                self.turn_a_diagonal(&mut triangles);
            }
            triangles
        };
        Self::new(self.corners.clone(), self.colours.clone(), Some(triangles.concat()))
    }

    /// Whether another cut is into the same triangles, as where no diagonal can be turned.
    pub(super) fn is_cut_as(&self, other: &Self) -> bool {
        let triangles = |cut: &Self| {
            let mut triangles: Vec<Vec<u32>> = cut.mesh.faces().iter().map(|face| face.to_vec()).collect();
            triangles.iter_mut().for_each(|triangle| triangle.sort_unstable());
            triangles.sort_unstable();
            triangles
        };
        triangles(self) == triangles(other)
    }

    fn turns_left(&self, [a, b, c]: [u32; 3]) -> bool {
        let [a, b, c] = [a, b, c].map(|corner| self.corners[corner as usize]);
        (b - a).perp_dot(c - b) > 0.0
    }

    fn is_convex(&self) -> bool {
        let count = self.corners.len() as u32;
        (0..count).all(|corner| self.turns_left([corner, (corner + 1) % count, (corner + 2) % count]))
    }

    /// Exchanges the first diagonal whose two triangles are a convex quadrilateral for the other one of that.
    fn turn_a_diagonal(&self, triangles: &mut [[u32; 3]]) {
        for (first, second) in
            (0..triangles.len()).flat_map(|i| (i + 1..triangles.len()).map(move |j| (i, j)))
        {
            for [a, b, c] in rotations(triangles[first]) {
                let beyond = rotations(triangles[second]).find(|&[from, to, _]| [from, to] == [b, a]);
                let Some([_, _, d]) = beyond else { continue };
                // Round the quadrilateral: c, a, d, b.
                if self.turns_left([c, a, d]) && self.turns_left([d, b, c]) {
                    (triangles[first], triangles[second]) = ([a, d, c], [d, b, c]);
                    return;
                }
            }
        }
    }

    pub(super) fn draw(&self, size: u32, angle: Degrees, interpolation: Interpolation) -> Result<Image> {
        self.draw_from(front(Self::WINDOW), DMat4::IDENTITY, size, angle, interpolation)
    }

    /// The same turned by an angle in its plane, then placed, seen by a camera.
    pub(super) fn draw_from(
        &self,
        camera: Camera,
        place: DMat4,
        size: u32,
        angle: Degrees,
        interpolation: Interpolation,
    ) -> Result<Image> {
        let object = Object {
            transform: place * DMat4::from_cols_array(&turn(angle)),
            ..painted(&self.mesh, &self.normals, &self.colours)
        };
        let settings = RenderSettings { interpolation, ..settings([size; 2], Shading::Gouraud) };
        draw(vec![object], &[], camera, settings)
    }

    /// The largest change of a colour along an edge, and the shortest edge in pixels.
    fn steepest(&self, size: u32) -> [f64; 2] {
        let count = self.corners.len();
        let edges = (0..count).map(|corner| (corner, (corner + 1) % count));
        let colour = |corner: usize| DVec3::from(self.colours[corner].to_array());
        let measured = edges.map(|(a, b)| {
            let length = (self.corners[b] - self.corners[a]).length() * f64::from(size) / Self::WINDOW;
            [(colour(b) - colour(a)).abs().max_element(), length]
        });
        measured.fold([0.0, f64::INFINITY], |[most, least], [change, length]| {
            [most.max(change), least.min(length)]
        })
    }

    /// The tolerance of colours in a picture of this size.
    ///
    /// Corners move by up to 1/512 of a pixel each way, over colours that change along edges, or across a narrow corner within a
    /// fifth of the picture's side. Colours are of single precision: a few roundings.
    pub(super) fn tolerance(&self, size: u32) -> f64 {
        let [change, shortest] = self.steepest(size);
        let snapped = 4.0 * change / (256.0 * shortest.min(0.2 * f64::from(size)));
        let brightest = self.colours.iter().map(|colour| colour.largest()).fold(0.0, f64::max);
        snapped + 4.0 * f64::from(f32::EPSILON) * brightest
    }

    /// The check of a number by the law, which does not cover edges shorter than a pixel: scanlines may pass over them.
    pub(super) fn check(&self, size: u32, law: f64, tolerance: f64) -> Check {
        let [_, shortest] = self.steepest(size);
        if shortest < 1.0 { Check::Untested("short-edges") } else { Check::Near(law, tolerance) }
    }

    /// The ends of the scanline through a place of the polygon turned by an angle, left and right, with the colours there.
    fn ends(&self, place: DVec2, angle: Degrees) -> [Option<(f64, DVec3)>; 2] {
        let (sine, cosine) = sin_cos(angle);
        let turn = DVec2::new(cosine, sine);
        let colour = |corner: usize| DVec3::from(self.colours[corner].to_array());
        let mut ends: [Option<(f64, DVec3)>; 2] = [None; 2];
        let count = self.corners.len();
        for (from, to) in (0..count).map(|corner| (corner, (corner + 1) % count)) {
            let [a, b] = [from, to].map(|corner| turn.rotate(self.corners[corner] - place));
            if (a.y < 0.0) == (b.y < 0.0) {
                continue;
            }
            let share = a.y / (a.y - b.y);
            let (x, colour) = (a.x + share * (b.x - a.x), colour(from).lerp(colour(to), share));
            let end = &mut ends[usize::from(x > 0.0)];
            if end.is_none_or(|(nearest, _)| x.abs() < nearest.abs()) {
                *end = Some((x, colour));
            }
        }
        ends
    }

    /// Whether the law jumps at the scanline of a place: an edge lies along it, or the tip of a notch that snapping may move.
    pub(super) fn jumps(&self, place: DVec2, angle: Degrees, size: u32, tolerance: f64) -> bool {
        let (sine, cosine) = sin_cos(angle);
        // A 128th of a pixel upwards in the picture.
        let up = DVec2::new(sine, cosine) * (Self::WINDOW / (128.0 * f64::from(size)));
        let [above, below] = [place + up, place - up].map(|place| self.scanline(place, angle));
        (above - below).abs().max_element() > tolerance
    }

    /// The law: the colour at a place between the two ends of its scanline, when the polygon is turned by an angle.
    pub(super) fn scanline(&self, place: DVec2, angle: Degrees) -> DVec3 {
        match self.ends(place, angle) {
            [Some((left, first)), Some((right, second))] => first.lerp(second, left / (left - right)),
            _ => DVec3::ZERO,
        }
    }

    /// Where on the polygon the centre of a pixel lies, in a picture of so many pixels of it unturned.
    pub(super) fn place(pixel: [u32; 2], size: u32) -> DVec2 {
        let from_middle = pixel.map(|k| f64::from(k) + 0.5 - 0.5 * f64::from(size));
        DVec2::new(from_middle[0], -from_middle[1]) * (Self::WINDOW / f64::from(size))
    }
}

fn rotations([a, b, c]: [u32; 3]) -> impl Iterator<Item = [u32; 3]> {
    [[a, b, c], [b, c, a], [c, a, b]].into_iter()
}

/// Shares of a polygon's size below which a length, and of its square below which an area, is rounding.
const ROUNDING: f64 = 1e-12;

/// The corners of a polygon in its own plane, about their mean, with the farthest at 1; `None` if they lie on a line.
fn flattened(points: &[DVec3]) -> Option<Vec<DVec2>> {
    let mean = points.iter().sum::<DVec3>() / points.len() as f64;
    let largest = points.iter().map(|&point| (point - mean).length()).fold(0.0, f64::max);
    let from_mean: Vec<DVec3> = points.iter().map(|&point| (point - mean) / largest).collect();
    let pairs = from_mean.iter().zip(from_mean.iter().cycle().skip(1));
    let crosses = pairs.map(|(&a, &b)| a.cross(b));
    let whole: DVec3 = crosses.clone().sum();
    // Parts that turn opposite ways may leave nothing, as in a bow tie, but still lie in a plane.
    let widest = crosses.max_by(|a, b| a.length().total_cmp(&b.length()))?;
    let normal = [whole, widest].into_iter().find(|area| area.length() > ROUNDING)?.normalize();
    let across = (points[0] - mean).reject_from(normal);
    let x = across.try_normalize().unwrap_or_else(|| normal.any_orthonormal_vector());
    let y = normal.cross(x);
    Some(from_mean.iter().map(|p| DVec2::new(p.dot(x), p.dot(y))).collect())
}

fn same_place(points: &[DVec3]) -> Option<[usize; 2]> {
    let pairs = (0..points.len()).flat_map(|i| (i + 1..points.len()).map(move |j| [i, j]));
    pairs.into_iter().find(|&[i, j]| points[i] == points[j])
}

fn crossing(corners: &[DVec2]) -> Option<[usize; 2]> {
    let count = corners.len();
    let edge = |k: usize| [corners[k], corners[(k + 1) % count]];
    let parts = |[a, b]: [DVec2; 2], [c, d]: [DVec2; 2]| {
        let [one, other] = [c, d].map(|point| (b - a).perp_dot(point - a));
        (one < 0.0 && other > 0.0) || (one > 0.0 && other < 0.0)
    };
    let mut pairs = (0..count).flat_map(|i| (i + 2..count).map(move |j| [i, j]));
    pairs.find(|&[i, j]| parts(edge(i), edge(j)) && parts(edge(j), edge(i)))
}

/// The area of a polygon over the distance of its farthest corners from its mean, twice of which it is long.
fn mean_width(corners: &[DVec2]) -> f64 {
    let pairs = corners.iter().zip(corners.iter().cycle().skip(1));
    let area = 0.5 * pairs.map(|(a, b)| a.perp_dot(*b)).sum::<f64>().abs();
    area / (2.0 * corners.iter().map(|corner| corner.length()).fold(0.0, f64::max))
}

/// A polygon about its mean, or if that lies outside, about the middle of its largest triangle. The farthest corner is at 1.
fn centred(corners: Vec<DVec2>) -> Result<Vec<DVec2>> {
    let pairs = || corners.iter().zip(corners.iter().cycle().skip(1));
    let is_left =
        |(a, b): &(&DVec2, &DVec2)| (a.y < 0.0) != (b.y < 0.0) && a.x + a.y / (a.y - b.y) * (b.x - a.x) < 0.0;
    if pairs().filter(is_left).count() % 2 == 1 {
        return Ok(corners);
    }
    let count = corners.len() as u32;
    let positions = corners.iter().map(|corner| corner.extend(0.0)).collect();
    let mesh = build(positions, Faces::polygons((0..count).collect(), vec![0, count]))?;
    let triangles = triangulate(&mesh).triangles;
    let points = |triangle: &[u32; 3]| triangle.map(|corner| corners[corner as usize]);
    let area = |triangle: &[u32; 3]| {
        let [a, b, c] = points(triangle);
        (b - a).perp_dot(c - a).abs()
    };
    let largest = triangles.iter().max_by(|a, b| area(a).total_cmp(&area(b)));
    let middle = largest.map_or(DVec2::ZERO, |largest| points(largest).into_iter().sum::<DVec2>() / 3.0);
    let moved = corners.iter().map(|&corner| corner - middle);
    let farthest = moved.clone().map(DVec2::length).fold(0.0, f64::max);
    Ok(moved.map(|corner| corner / farthest).collect())
}

/// Sine and cosine, exact at quarter turns.
pub(super) fn sin_cos(Degrees(angle): Degrees) -> (f64, f64) {
    match angle.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        angle => libm::sincos(Radians::from(Degrees(angle)).0),
    }
}

/// The turn about z by an angle, counter-clockwise, as columns of a matrix.
fn turn(angle: Degrees) -> [f64; 16] {
    let (sin, cos) = sin_cos(angle);
    [cos, sin, 0.0, 0.0, -sin, cos, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]
}
