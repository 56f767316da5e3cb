//! The loop that speed is measured against.

/// Vertex normals as an engineer writes them first: one thread, single precision, area weights, no care for anything that
/// may go wrong. Triangles without area leave vertices of none else with NaN.
///
/// Every cost of this module, and every ratio of the benches, is against it, measured in the same run.
///
/// # Panics
/// If a triangle names a vertex that is not there, or there are fewer normals than positions.
pub fn plain_vertex_normals(positions: &[[f32; 3]], triangles: &[[u32; 3]], normals: &mut [[f32; 3]]) {
    normals.fill([0.0; 3]);
    for corners in triangles {
        let [p, q, r] = corners.map(|vertex| positions[vertex as usize]);
        let u = [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
        let v = [r[0] - p[0], r[1] - p[1], r[2] - p[2]];
        let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for &vertex in corners {
            let sum = &mut normals[vertex as usize];
            sum[0] += n[0];
            sum[1] += n[1];
            sum[2] += n[2];
        }
    }
    for n in normals {
        let scale = 1.0 / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
        *n = [n[0] * scale, n[1] * scale, n[2] * scale];
    }
}
