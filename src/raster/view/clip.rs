//! Clipping to the near plane and to the guard band, with everything that is interpolated along.
//!
//! Sutherland & Hodgman 1974, in homogeneous `f64`. A new vertex is always computed from the inner end of an edge
//! towards the outer one, so that two faces that share an edge get the same vertex whatever their winding.

use crate::raster::view::fixed_point::{GUARD, ONE, snap};
use crate::raster::view::project::ScreenVertex;
use crate::raster::view::screen_transform::{View, ViewPoint};

pub(crate) trait Mix: Copy {
    /// The value on the way to another, by the shares of the two in the scene and on the picture.
    fn mix(self, other: Self, scene: [f64; 2], picture: [f64; 2]) -> Self;
}

/// Shares of a triangle's three corners in a point of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Shares {
    pub(crate) scene: [f64; 3],
    /// Barycentric coordinates on the picture, of the triangle or of its part beyond the near plane.
    pub(crate) picture: [f64; 3],
}

impl Shares {
    pub(crate) fn of_corner(corner: usize) -> Self {
        let mut share = [0.0; 3];
        share[corner] = 1.0;
        Self { scene: share, picture: share }
    }
}

impl Mix for Shares {
    fn mix(self, other: Self, scene: [f64; 2], picture: [f64; 2]) -> Self {
        let mix =
            |a: [f64; 3], b: [f64; 3], [of_a, of_b]: [f64; 2]| [0, 1, 2].map(|k| a[k] * of_a + b[k] * of_b);
        Self {
            scene: mix(self.scene, other.scene, scene),
            picture: mix(self.picture, other.picture, picture),
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct ClipVertex<A> {
    pub(crate) point: ViewPoint,
    pub(crate) attribute: A,
}

pub(crate) const NEAR: usize = 0;

/// Clips a polygon by the planes whose bits are set; `spare` is room to work in.
pub(crate) fn clip<A: Mix>(
    view: &View,
    planes: u32,
    polygon: &mut Vec<ClipVertex<A>>,
    spare: &mut Vec<ClipVertex<A>>,
) {
    for plane in (0..5).filter(|plane| planes >> plane & 1 == 1) {
        spare.clear();
        for (i, &from) in polygon.iter().enumerate() {
            let to = polygon[(i + 1) % polygon.len()];
            let (a, b) = (view.inside(from.point)[plane], view.inside(to.point)[plane]);
            if a >= 0.0 {
                spare.push(from);
            }
            match (a >= 0.0, b >= 0.0) {
                (true, false) => spare.push(crossing(view, plane, from, to, [a, b])),
                (false, true) => spare.push(crossing(view, plane, to, from, [b, a])),
                _ => {}
            }
        }
        std::mem::swap(polygon, spare);
    }
}

/// The part of a line within all clipping planes, plane after plane; `None` if nothing is left.
pub(crate) fn clip_line(view: &View, [mut a, mut b]: [ViewPoint; 2]) -> Option<[ViewPoint; 2]> {
    for plane in 0..5 {
        let (at_a, at_b) = (view.inside(a)[plane], view.inside(b)[plane]);
        match (at_a >= 0.0, at_b >= 0.0) {
            (true, true) => {}
            (false, false) => return None,
            (true, false) => b = crossing_point(view, plane, a, b, [at_a, at_b]),
            (false, true) => a = crossing_point(view, plane, b, a, [at_b, at_a]),
        }
    }
    Some([a, b])
}

/// The shares of an edge's ends in the point where it leaves a half-space, by their distances inside of it. Both keep
/// their digits: the share of an end 10²⁰ times as far out as the other is small, but the point depends on it.
fn shares_of_ends([inner, outer]: [f64; 2]) -> [f64; 2] {
    // Halved: the sum of two large numbers is none any more.
    let (inner, outer) = (0.5 * inner, -0.5 * outer);
    [outer / (inner + outer), inner / (inner + outer)]
}

/// The point where an edge leaves the half-space of a plane, exactly on the plane.
fn crossing_point(view: &View, plane: usize, p: ViewPoint, q: ViewPoint, inside: [f64; 2]) -> ViewPoint {
    let [of_p, of_q] = shares_of_ends(inside);
    let mix = |a: f64, b: f64| a * of_p + b * of_q;
    let mut point = ViewPoint { x: mix(p.x, q.x), y: mix(p.y, q.y), z: mix(p.z, q.z), h: mix(p.h, q.h) };
    let guard = f64::from(GUARD) * point.h;
    match plane {
        NEAR => {
            point.z = view.near;
            point.h = if view.perspective { view.near } else { 1.0 };
        }
        1 => point.x = -guard,
        2 => point.x = guard,
        3 => point.y = -guard,
        _ => point.y = guard,
    }
    point
}

/// The corner where an edge leaves the half-space of a plane, by how far its ends are inside of it.
fn crossing<A: Mix>(
    view: &View,
    plane: usize,
    inner: ClipVertex<A>,
    outer: ClipVertex<A>,
    inside: [f64; 2],
) -> ClipVertex<A> {
    let point = crossing_point(view, plane, inner.point, outer.point, inside);
    let scene = shares_of_ends(inside);
    // The new corners at the near plane are corners of what is drawn; those at the guard band are not, so there the
    // interpolation on the picture must not notice them.
    let picture = match plane {
        NEAR => scene,
        _ => {
            let farthest = inner.point.h.max(outer.point.h);
            shares_of_ends([inside[0] * (outer.point.h / farthest), inside[1] * (inner.point.h / farthest)])
        }
    };
    ClipVertex { point, attribute: inner.attribute.mix(outer.attribute, scene, picture) }
}

pub(crate) fn screen_vertex(view: &View, point: ViewPoint) -> ScreenVertex {
    let ([x, y], middle) = (view.on_picture(point), view.middle());
    let within = |place: f64, middle: f64| {
        // Rounding may carry a corner of the guard band over its border by a unit.
        let (low, high) = (snap(middle) - GUARD * ONE, snap(middle) + GUARD * ONE);
        snap(place).clamp(low, high)
    };
    ScreenVertex {
        x: within(x, middle[0]),
        y: within(y, middle[1]),
        depth: view.depth(point.z) as f32,
        outside: 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Radians;
    use crate::num::test_numbers::Numbers;
    use crate::raster::view::camera::{Camera, Projection};
    use crate::raster::view::screen_transform::ObjectMap;
    use glam::{DMat4, DVec3};

    fn view() -> View {
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective(Radians(1.0)),
            near: 0.5,
        };
        View::new(&camera, [100, 100]).unwrap()
    }

    /// What clipping says of a new corner must hold in the scene: the mean of the corners by its shares is the corner.
    #[test]
    fn shares_recover_the_corner() {
        let (view, mut numbers) = (view(), Numbers::new(7));
        let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let mut clipped = 0;
        for _ in 0..2000 {
            let size = if numbers.below(2) == 0 { 4.0 } else { 4000.0 };
            let corners = [0; 3].map(|_| DVec3::from([0; 3].map(|_| (numbers.unit() - 0.5) * size)));
            let mut polygon: Vec<_> = (0..3)
                .map(|k| ClipVertex { point: map.view(corners[k]), attribute: Shares::of_corner(k) })
                .collect();
            clip(&view, 0x1f, &mut polygon, &mut Vec::new());
            assert!(polygon.len() <= 8);
            for vertex in &polygon {
                clipped += usize::from(vertex.attribute.scene.iter().all(|&share| share != 1.0));
                let mean: DVec3 = (0..3).map(|k| corners[k] * vertex.attribute.scene[k]).sum();
                let seen = map.view(mean);
                // Shares are rounded to 2^-53, coordinates are a few thousand units, a unit is 91 pixels.
                let close = |a: f64, b: f64| (a - b).abs() < 1e-8;
                assert!(
                    close(seen.x, vertex.point.x)
                        && close(seen.y, vertex.point.y)
                        && close(seen.z, vertex.point.z)
                );
                let inside = view.inside(vertex.point);
                assert!(inside.iter().all(|&d| d > -1e-6), "{inside:?}");
                let sum: f64 = vertex.attribute.picture.iter().sum();
                assert!((sum - 1.0).abs() < 1e-9, "{sum}");
            }
        }
        assert!(clipped > 1000, "only {clipped} new corners");
    }

    /// At the guard band alone, shares on the picture are those of the place on the picture.
    #[test]
    fn the_guard_band_leaves_the_picture_alone() {
        let view = view();
        let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let corners = [DVec3::new(-1.0, 0.0, -1.0), DVec3::new(900.0, 0.1, -2.0), DVec3::new(0.0, 1.0, -3.0)];
        let points = corners.map(|corner| map.view(corner));
        let mut polygon: Vec<_> =
            (0..3).map(|k| ClipVertex { point: points[k], attribute: Shares::of_corner(k) }).collect();
        clip(&view, 0x1f, &mut polygon, &mut Vec::new());
        assert_eq!(polygon.len(), 4);
        for vertex in polygon {
            let [x, y] = view.on_picture(vertex.point);
            let places = points.map(|point| view.on_picture(point));
            for (k, value) in [x, y].into_iter().enumerate() {
                let mean: f64 = (0..3).map(|i| places[i][k] * vertex.attribute.picture[i]).sum();
                assert!((mean - value).abs() < 1e-7, "{mean} {value}");
            }
        }
    }

    #[test]
    fn both_sides_of_an_edge_get_the_same_corner() {
        let (view, mut numbers) = (view(), Numbers::new(8));
        let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let mut point = || map.view(DVec3::from([0; 3].map(|_| (numbers.unit() - 0.5) * 4.0)));
        for _ in 0..1000 {
            let (a, b) = (point(), point());
            let cut = |from: ViewPoint, to: ViewPoint| {
                let vertex = |point, k| ClipVertex { point, attribute: Shares::of_corner(k) };
                let mut polygon = vec![vertex(from, 0), vertex(to, 1)];
                clip(&view, 1, &mut polygon, &mut Vec::new());
                let mut places: Vec<_> = polygon.iter().map(|v| (v.point.x, v.point.y, v.point.z)).collect();
                places.sort_by(|a, b| a.partial_cmp(b).unwrap());
                places
            };
            assert_eq!(cut(a, b), cut(b, a));
        }
    }
}
