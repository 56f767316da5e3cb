//! Polygons of real meshes, cut into triangles.

use crate::flat::face_normal;
use crate::meshes::rows;
use crease::io::{self, ReadOptions};
use crease::mesh::triangulate;
use glam::DVec3;

#[test]
fn real_polygons_are_covered() {
    let mut polygons = 0;
    for row in rows("", &["obj", "ply"]).iter().filter(|row| row.text("expect").starts_with("load")) {
        let loaded = io::read(&row.path, None, &ReadOptions::default()).unwrap();
        let mesh = &loaded.parts[0].mesh;
        let cut = triangulate(mesh);
        let expected: usize = mesh.faces().ranges().map(|range| range.len() - 2).sum();
        assert_eq!(cut.triangles.len(), expected, "{}", row.name());
        // What is reported is degenerate or crosses itself; these files have little of that.
        assert!(
            cut.failed.len() <= mesh.face_count() / 100 + 3,
            "{}: {} failed",
            row.name(),
            cut.failed.len()
        );
        let mut covered = vec![0.0; mesh.face_count()];
        let axes: Vec<DVec3> = (0..mesh.face_count()).map(|face| face_normal(mesh, face)).collect();
        for (triangle, &face) in cut.triangles.iter().zip(&cut.source_face) {
            let range = mesh.faces().range(face as usize);
            assert!(triangle.iter().all(|&corner| range.contains(&(corner as usize))), "{}", row.name());
            let [a, b, c] =
                triangle.map(|corner| mesh.positions().at(mesh.faces().corners()[corner as usize]));
            covered[face as usize] += (b - a).cross(c - a).dot(axes[face as usize]);
        }
        for (face, range) in mesh.faces().ranges().enumerate() {
            if range.len() == 3 {
                continue;
            }
            polygons += 1;
            let corners: Vec<DVec3> = mesh
                .faces()
                .face(face)
                .iter()
                .map(|&v| mesh.positions().at(v) - mesh.positions().at(mesh.faces().face(face)[0]))
                .collect();
            let area: DVec3 = corners.windows(2).map(|pair| pair[0].cross(pair[1])).sum();
            // The parts of any cut add up to the vector area, exactly but for rounding: 1e-9 of the squared size.
            let size = corners.iter().fold(0.0, |m: f64, p| m.max(p.length_squared()));
            let error = (covered[face] - area.dot(axes[face])).abs();
            assert!(error <= 1e-9 * size, "{}: face {face} is covered by {}", row.name(), covered[face]);
        }
    }
    println!("{polygons} polygons");
}
