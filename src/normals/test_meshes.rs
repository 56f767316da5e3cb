//! Meshes for tests of kernels.

use crate::num::test_numbers::Numbers;
use glam::DVec3;

/// A height field of n × n cells, two triangles each, whose coordinates are `f32` values.
pub(crate) fn bumpy(n: u32, seed: u64) -> (Vec<[u32; 3]>, Vec<DVec3>) {
    let mut numbers = Numbers::new(seed);
    let points = (0..(n + 1) * (n + 1)).map(|i| {
        let (x, y) = (f64::from(i % (n + 1)), f64::from(i / (n + 1)));
        let jitter: [f64; 3] = std::array::from_fn(|_| 0.5 * numbers.unit());
        (DVec3::new(x, y, 0.0) + DVec3::from(jitter)).as_vec3().as_dvec3()
    });
    let points = points.collect();
    let cell = |i: u32| {
        let a = i / n * (n + 1) + i % n;
        [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]
    };
    ((0..n * n).flat_map(cell).collect(), points)
}

/// Runs in a pool of so many threads.
pub(crate) fn with_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool").install(work)
}
