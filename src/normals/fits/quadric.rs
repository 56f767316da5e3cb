//! The least-squares quadric: second order in the edge length, where weighted means are first order; its equal rows average noise.

use crate::normals::fits::polynomial::Polynomial;
use crate::num::Pivoting;

/// The quadric z = ax + by + cx² + dxy + ey² through a vertex that fits its two-ring best; z is along the given normal.
///
/// There is no fit with fewer than 6 neighbours, one more than there are unknowns, and none where they lie on a conic through
/// the vertex, as all of a line do.
pub(crate) const QUADRIC: Polynomial = Polynomial {
    degree: 2,
    row_power: 0,
    fewest: 6,
    adds_rings: false,
    // Some millions of roundings, yet far below the angles between the columns of any stretched mesh.
    nearest: 1.0 / (1 << 30) as f64,
    pivoting: Pivoting::None,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::normals::compute::compute;
    use crate::normals::fits::polynomial::Neighbourhoods;
    use crate::normals::fits::test_surfaces::{
        self, angle, build, cones, errors, patch, sphere_cap, torus, turn_by_numbering,
    };
    use crate::normals::recipe::{Crease, NormalRecipe, Weight};
    use crate::normals::test_meshes::with_threads;
    use crate::num::test_numbers::Numbers;
    use glam::DVec3;
    use std::f64::consts::TAU;

    fn normals_of(mesh: &Mesh, corner_group: &[u32]) -> (Vec<DVec3>, usize) {
        let (normals, [failures]) = test_surfaces::normals_of(mesh, corner_group, [QUADRIC]);
        (normals, failures.total())
    }

    fn smooth(mesh: &Mesh) -> (Vec<DVec3>, usize) {
        normals_of(mesh, mesh.faces().corners())
    }

    /// The fit at the origin.
    fn fit(neighbours: &[DVec3]) -> Option<DVec3> {
        if neighbours.len() < QUADRIC.fewest {
            return None;
        }
        let mut neighbourhoods = Neighbourhoods::new();
        neighbourhoods.push(DVec3::ZERO, DVec3::Z, neighbours);
        neighbourhoods.normals(QUADRIC)[0]
    }

    /// Doubling the number of cells must divide the error by four; a weighted mean divides it by two. Measured root
    /// mean squares: torus 2.385°, 0.570°, 0.140°; sphere, where cubic terms are small, 0.0103°, 0.0013°, 0.00015°.
    #[test]
    fn errors_shrink_with_the_square_of_the_edges() {
        // One-sided fits at the rim of a patch are not what is measured.
        let error = |(mesh, exact): (Mesh, Vec<DVec3>), counted: fn(DVec3) -> bool| {
            let pairs = smooth(&mesh).0.into_iter().zip(exact).zip(mesh.positions().iter());
            let (normals, exact): (Vec<_>, Vec<_>) =
                pairs.filter(|(_, p)| counted(*p)).map(|(pair, _)| pair).unzip();
            errors(&normals, &exact)
        };
        let torus = [32, 64, 128].map(|m| error(torus(m, m / 2), |_| true));
        let cap = [12, 24, 48].map(|n| error(sphere_cap(n), |p| p.x.abs().max(p.y.abs()) < 0.4));
        for [coarse, middle, fine] in [torus, cap] {
            assert!(coarse.0 > 4.0 * middle.0 && middle.0 > 4.0 * fine.0, "{coarse:?} {middle:?} {fine:?}");
            assert!(coarse.1 > 3.5 * middle.1 && middle.1 > 3.5 * fine.1, "{coarse:?} {middle:?} {fine:?}");
        }
        assert!(torus[1].0 < 0.6 && cap[1].0 < 0.0014, "{torus:?} {cap:?}");
    }

    /// Where the surface is a quadric over the plane that the fit starts from, nothing but rounding remains:
    /// 1.3e-15 rad was the most.
    #[test]
    fn quadrics_are_fitted_exactly() {
        let mut numbers = Numbers::new(3);
        for count in [7, 20, 64] {
            for _ in 0..200 {
                let mut signed = || 2.0 * numbers.unit() - 1.0;
                let [a, b, c, d, e]: [f64; 5] = std::array::from_fn(|_| signed());
                let points: Vec<DVec3> = (0..count)
                    .map(|_| {
                        let (x, y) = (signed(), signed());
                        DVec3::new(x, y, a * x + b * y + c * x * x + d * x * y + e * y * y)
                    })
                    .collect();
                let normal = fit(&points).unwrap();
                let error = angle(normal, DVec3::new(-a, -b, 1.0));
                assert!(error < 5e-15, "{error:e}");
            }
        }
    }

    #[test]
    fn planes_stay_planes() {
        /// Corners of this patch that lie in one triangle and have too few neighbours.
        const FEW: usize = 1;
        let (mesh, exact) = patch(12, |_, _| (0.0, 0.0, 0.0));
        assert_eq!(smooth(&mesh), (exact, FEW));
        let (mesh, exact) = patch(12, |x, y| (0.3 * x - 0.7 * y, 0.3, -0.7));
        let (normals, fallbacks) = smooth(&mesh);
        // 7.6e-14 degrees were measured: rounding of the heights over the cell size.
        assert!(errors(&normals, &exact).1 < 3e-13);
        assert_eq!(fallbacks, FEW);
    }

    #[test]
    fn too_little_to_fit_leaves_the_mean() {
        let circle = |count: u32| -> Vec<DVec3> {
            let angles = (0..count).map(|i| TAU * f64::from(i) / f64::from(count));
            angles.map(|t| DVec3::new(libm::cos(t), 0.7 * libm::sin(t), 0.1)).collect()
        };
        assert!(fit(&circle(6)).is_some());
        assert_eq!(fit(&circle(5)), None);
        let line: Vec<DVec3> = (1..20).map(|i| f64::from(i) * DVec3::new(1.0, 0.3, 0.0)).collect();
        assert_eq!(fit(&line), None);
        let cross: Vec<DVec3> = (1..9).flat_map(|i| [DVec3::X, DVec3::Y].map(|a| f64::from(i) * a)).collect();
        assert_eq!(fit(&cross), None, "a conic through the vertex");

        // Each vertex of an octahedron has the five others around it.
        let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
        let faces = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
        let (normals, fallbacks) = smooth(&build(axes.to_vec(), faces.concat()));
        assert_eq!(fallbacks, 6);
        assert!(normals.iter().zip(axes).all(|(&normal, axis)| angle(normal, axis) < 1e-15));
    }

    /// Columns of such a fit are dependent but for the rounding of positions. Without the test against the neighbours
    /// normals were wrong by up to 90°; angle means are right to the rounding over the shorter edge.
    #[test]
    fn two_rings_of_rounded_positions_do_not_mislead() {
        let mut numbers = Numbers::new(11);
        type Store = fn(f64) -> f64;
        let stores: [(Store, f64); 4] = [
            (|x| x, 1e-16),
            (|x| f64::from(x as f32), 6e-8),
            (|x| (x * 1e6).round() / 1e6, 5e-7),
            (|x| (x * 1e4).round() / 1e4, 5e-5),
        ];
        for (sides, (store, grain)) in
            [16_u32, 32, 64].into_iter().flat_map(|s| stores.map(|store| (s, store)))
        {
            let turn = glam::DQuat::from_xyzw(numbers.unit(), numbers.unit(), numbers.unit(), numbers.unit());
            let turn = turn.normalize();
            let spoke = |v: u32| {
                let angle = TAU * f64::from(v / 2) / f64::from(sides);
                DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
            };
            let place = |v: u32| turn * (spoke(v) + 2.0 * f64::from(v % 2) * DVec3::Z);
            let positions = (0..2 * sides).map(|v| DVec3::from(place(v).to_array().map(store))).collect();
            let exact: Vec<DVec3> = (0..2 * sides).map(|v| turn * spoke(v)).collect();
            let wall = |i: u32| {
                let [a, b] = [2 * i, (2 * i + 2) % (2 * sides)];
                [a, b, b + 1, a, b + 1, a + 1]
            };
            let (normals, _) = smooth(&build(positions, (0..sides).flat_map(wall).collect()));
            // A corner that moves by √3 grains tilts a face by that over its shorter edge; the fit may triple it.
            let shorter = TAU / f64::from(sides);
            let allowed = (3.0 * 4.0 * 3.0_f64.sqrt() * grain / shorter).to_degrees() + 1e-12;
            let (_, largest) = errors(&normals, &exact);
            assert!(largest < allowed, "{sides} sides, {grain:e}: {largest:e}, allowed {allowed:e}");
        }
    }

    #[test]
    fn a_power_of_two_changes_no_bit() {
        let (mesh, _) = torus(24, 12);
        let (normals, _) = smooth(&mesh);
        for power in [-900, -300, -40, 1, 300, 900] {
            let scale = |p: DVec3| DVec3::from(p.to_array().map(|x| libm::ldexp(x, power)));
            let scaled = mesh.positions().iter().map(scale).collect();
            assert_eq!(smooth(&build(scaled, mesh.faces().corners().to_vec())).0, normals, "2^{power}");
        }
    }

    /// Numbering reaches a fit only through the last bits of the mean that it starts from.
    #[test]
    fn numbering_turns_normals_by_rounding_only() {
        let largest = turn_by_numbering(&torus(64, 32).0, 4, |mesh| smooth(mesh).0);
        // 2.8e-16 rad were measured, as much as the means turn themselves.
        assert!(largest < 1e-15, "{largest:e}");
        assert!(largest > 0.0, "the means must have been summed in another order");
    }

    #[test]
    fn copies_of_a_vertex_count_once() {
        let (mesh, _) = torus(24, 12);
        let places = mesh.faces().corners().iter().map(|&v| mesh.positions().at(v)).collect();
        let soup = build(places, (0..mesh.faces().corner_count() as u32).collect());
        assert_eq!(normals_of(&soup, mesh.faces().corners()), smooth(&mesh));
    }

    /// A roof whose ridge is hard: each side is a plane and must be fitted as one.
    #[test]
    fn hard_edges_are_not_crossed() {
        let (mesh, _) = patch(12, |_, _| (0.0, 0.0, 0.0));
        let ridge = |p: DVec3| DVec3::new((p.x * 12.0).round(), p.y * 12.0, -(p.x * 12.0).round().abs());
        let roof = build(mesh.positions().iter().map(ridge).collect(), mesh.faces().corners().to_vec());
        let side = |face: &[u32]| face.iter().any(|&v| roof.positions().at(v).x > 0.0);
        let vertices = roof.vertex_count() as u32;
        let groups: Vec<u32> = roof
            .faces()
            .iter()
            .flat_map(|face| face.iter().map(move |&v| v + vertices * u32::from(side(face))))
            .collect();
        let (normals, _) = normals_of(&roof, &groups);
        for (&group, face) in groups.iter().zip(0..) {
            let right = side(roof.faces().face(face / 3));
            let plane = DVec3::new(if right { 1.0 } else { -1.0 }, 0.0, 1.0);
            assert!(angle(normals[group as usize], plane) < 1e-15);
        }
        let (rounded, _) = smooth(&roof);
        assert!(angle(rounded[6 * 13 + 6], DVec3::new(1.0, 0.0, 1.0)) > 0.1, "smoothed over, it is round");
    }

    #[test]
    fn computing_normals_gives_these() {
        let recipe = NormalRecipe { weight: Weight::Quadric, crease: Crease::OFF, ..NormalRecipe::default() };
        let (mesh, _) = torus(24, 12);
        let field = compute(&mesh, &recipe);
        let fitted = smooth(&mesh);
        assert_eq!((field.normals.values, field.summary.quadric_fallbacks), fitted);
        let mean = compute(&mesh, &NormalRecipe { weight: Weight::Angle, ..recipe }).normals.values;
        assert!(fitted.0.iter().zip(mean).all(|(&fit, mean)| fit != mean));

        // A single square is too small to fit.
        let square = patch(1, |_, _| (0.0, 0.0, 0.0)).0;
        let field = compute(&square, &recipe);
        assert_eq!((field.normals.values, field.summary.quadric_fallbacks), (vec![DVec3::Z; 4], 4));
    }

    /// Looking at every pair of rim vertices would take minutes.
    #[test]
    fn a_crowded_tip_costs_little() {
        assert_eq!(smooth(&cones(50_000)).0.len(), 50_002);
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let (mesh, _) = torus(64, 32);
        let one = with_threads(1, || smooth(&mesh));
        assert!([2, 3, 8].iter().all(|&threads| with_threads(threads, || smooth(&mesh)) == one));
    }
}
