//! Meshes without a grid: subdivided icosahedra, and Delaunay triangulations of scattered points.

use crate::mesh::Faces;
use crate::num::unit_scale;
use crate::surface::error::{MOST_CELLS, Result, SurfaceError, check_count};
use crate::surface::meshing::net::{Net, sample_at};
use crate::surface::meshing::pattern::GridHash;
use crate::surface::shapes::chart::Sample;
use crate::surface::shapes::height::Height;
use crate::surface::shapes::star::StarShaped;
use glam::{DVec2, DVec3};
use rustc_hash::FxHashMap;
use spade::{DelaunayTriangulation, Point2, Triangulation};

/// Level 10 has 21 million triangles.
const HIGHEST: u64 = 10;

/// The surface in the directions of an icosahedron whose triangles are cut in four so many times.
pub(crate) fn icosphere(surface: &dyn StarShaped, level: u32) -> Result<Net> {
    check_count("levels of division", level, 0..=HIGHEST)?;
    let (mut directions, mut triangles) = icosahedron();
    for _ in 0..level {
        triangles = quarter(&mut directions, &triangles);
    }
    let along = |&direction: &DVec3| {
        surface.along(direction).expect("a direction of length 1 leads to a point with a normal")
    };
    let samples: Vec<Sample> = directions.iter().map(along).collect();
    Ok(Net::without_parameters(samples, Faces::triangles(triangles.as_flattened().to_vec())))
}

/// Corners (0, ±1, ±φ) and their cyclic permutations, and the triangles between neighbours, counter-clockwise.
fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners = Vec::with_capacity(12);
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        corners.extend([DVec3::new(0.0, a, b), DVec3::new(a, b, 0.0), DVec3::new(b, 0.0, a)]);
    }
    // Edges have length 2, the next distance is 2φ.
    let meet = |a: u32, b: u32| corners[a as usize].distance_squared(corners[b as usize]) < 5.0;
    let mut triangles = Vec::with_capacity(20);
    for a in 0..12 {
        for b in (a + 1..12).filter(|&b| meet(a, b)) {
            for c in (b + 1..12).filter(|&c| meet(b, c) && meet(c, a)) {
                let [p, q, r] = [a, b, c].map(|k| corners[k as usize]);
                triangles.push(if p.dot(q.cross(r)) > 0.0 { [a, b, c] } else { [a, c, b] });
            }
        }
    }
    (corners.into_iter().map(DVec3::normalize).collect(), triangles)
}

/// Each triangle as four, by the midpoints of its edges moved onto the sphere.
fn quarter(directions: &mut Vec<DVec3>, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut middles: FxHashMap<[u32; 2], u32> = FxHashMap::default();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            directions.push((directions[a as usize] + directions[b as usize]).normalize());
            directions.len() as u32 - 1
        })
    };
    let mut quarters = Vec::with_capacity(4 * triangles.len());
    for &[a, b, c] in triangles {
        let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
        quarters.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
    }
    quarters
}

/// As many points as a grid has over the rectangle of a height: evenly spaced on the sides, random within.
pub(crate) fn scattered(surface: &dyn Height, segments: [u32; 2], hash: GridHash) -> Result<Net> {
    let [columns, rows] = segments;
    let cells = u64::from(columns) * u64::from(rows);
    check_count("cells", cells, 1..=MOST_CELLS)?;
    let place = |i: u32, j: u32| {
        let on_side = i == 0 || j == 0 || i == columns || j == rows;
        if on_side {
            DVec2::new(f64::from(i) / f64::from(columns), f64::from(j) / f64::from(rows))
        } else {
            DVec2::new(hash.at(i, j, 1), hash.at(i, j, 2))
        }
    };
    let parameters: Vec<DVec2> =
        (0..=rows).flat_map(|j| (0..=columns).map(move |i| (i, j))).map(|(i, j)| place(i, j)).collect();
    let extent = surface.extent();
    let above = |&at: &DVec2| sample_at(at, surface.above((at - 0.5) * extent));
    let samples: Vec<Sample> = parameters.iter().map(above).collect::<Result<_, _>>()?;
    let triangles = delaunay(&parameters)?;
    let corner_parameters = triangles.as_flattened().iter().map(|&v| parameters[v as usize]).collect();
    let faces = Faces::triangles(triangles.as_flattened().to_vec());
    Ok(Net { samples, faces, corner_parameters, first_faces: vec![0] })
}

/// The error about a scattered point, counted from 0.
fn invalid(point: usize, reason: &str) -> SurfaceError {
    SurfaceError::Invalid(format!("point {point}: {reason}"))
}

/// Triangles of distinct points, counter-clockwise. Coordinates are scaled by a power of two to the range of exact predicates.
pub(crate) fn delaunay(places: &[DVec2]) -> Result<Vec<[u32; 3]>> {
    let scale = unit_scale(places.iter().fold(0.0, |most: f64, p| most.max(p.abs().max_element())));
    let scaled = |place: &DVec2| spade::mitigate_underflow(Point2::new(place.x * scale, place.y * scale));
    let sites: Vec<Point2<f64>> = places.iter().map(scaled).collect();
    let mut order: Vec<u32> = (0..places.len() as u32).collect();
    let key = |k: u32| (sites[k as usize].x + 0.0, sites[k as usize].y + 0.0);
    order.sort_by(|&a, &b| key(a).partial_cmp(&key(b)).expect("finite numbers"));
    if let Some(pair) = order.windows(2).find(|pair| key(pair[0]) == key(pair[1])) {
        let reason = "another point has the same x and y; omit one of them";
        return Err(invalid(pair[0].max(pair[1]) as usize, reason));
    }
    let none = SurfaceError::Invalid("no three points make a triangle".to_owned());
    let triangulation =
        DelaunayTriangulation::<Point2<f64>>::bulk_load_stable(sites).map_err(|_| none.clone())?;
    let mut triangles: Vec<[u32; 3]> =
        triangulation.inner_faces().map(|face| face.vertices().map(|vertex| vertex.index() as u32)).collect();
    if triangles.is_empty() {
        return Err(none);
    }
    // The order must not depend on the library.
    for triangle in &mut triangles {
        let lowest = (0..3).min_by_key(|&k| triangle[k]).unwrap_or(0);
        triangle.rotate_left(lowest);
    }
    triangles.sort_unstable();
    Ok(triangles)
}
