//! The osculating jet of degree 3: third order in the edge length, on surfaces without noise.

use crate::normals::fits::fitted_normals::FitFailures;
use crate::normals::fits::polynomial::Polynomial;
use crate::num::Pivoting;

/// The smallest distance of a column from the span of those before it: condition numbers above 2²⁴ are refused.
const NEAREST: f64 = 1.0 / (1 << 24) as f64;

/// The polynomial of degree 3 through a vertex that fits its neighbours best, with rows of weight 1/d² (F. Cazals, M. Pouget, *Estimating
/// differential quantities using polynomial fitting of osculating jets*, CAGD 22(2), 2005), and that of degree 2 for where there
/// is none. Each takes at least 1.5 times as many neighbours as it has unknowns.
///
/// Rows are multiplied by 1/d², so a squared residual counts 1/d⁴. With rows of weight 1/d the errors on meshes without noise
/// are 1.3 to 5 times as large, with 1/d³ and 1/d⁴ larger on stretched meshes, icospheres and slivers.
pub(crate) const JET: [Polynomial; 2] = [of_degree(3, 14), of_degree(2, 8)];

const fn of_degree(degree: usize, fewest: usize) -> Polynomial {
    Polynomial {
        degree,
        row_power: 2,
        fewest,
        adds_rings: true,
        nearest: NEAREST,
        pivoting: Pivoting::Columns,
    }
}

/// How many normals of [`Weight::Jet`](crate::normals::Weight::Jet) are of lower order, by the reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct JetFallbacks {
    /// Without a fit of degree 3.
    pub degree_3: FitFailures,
    /// Of these, those without a fit of degree 2 as well, which are the angle mean.
    pub degree_2: FitFailures,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::normals::compute::compute;
    use crate::normals::fits::polynomial::Neighbourhoods;
    use crate::normals::fits::quadric::QUADRIC;
    use crate::normals::fits::test_surfaces::{
        angle, build, errors, normals_of, patch, rms_on_torus, rms_on_wave, torus, turn_by_numbering,
    };
    use crate::normals::recipe::{Crease, NormalRecipe, Weight};
    use crate::normals::test_meshes::with_threads;
    use crate::num::test_numbers::Numbers;
    use glam::DVec3;

    fn smooth(mesh: &Mesh) -> (Vec<DVec3>, JetFallbacks) {
        let (normals, [degree_3, degree_2]) = normals_of(mesh, mesh.faces().corners(), JET);
        (normals, JetFallbacks { degree_3, degree_2 })
    }

    /// Figures computed outside this program: polynomials of degree 2 with equal rows, and with squared residuals that count by
    /// 1/d².
    #[test]
    fn degree_2_has_its_published_errors() {
        let assert_printed = |found: f64, printed: f64, unit: f64| {
            assert!((found - printed).abs() <= 0.500_001 * unit, "{found} is not {printed}");
        };
        let weighted = Polynomial { row_power: 1, ..JET[1] };
        for (n, of_weighted, of_equal) in [(32, 0.9424, 1.196), (64, 0.2391, 0.303)] {
            assert_printed(rms_on_wave(n, [weighted]), of_weighted, 1e-4);
            assert_printed(rms_on_wave(n, [QUADRIC]), of_equal, 1e-3);
        }
        // Found: 0.09533.
        assert_printed(rms_on_torus(128, 64, [weighted]), 0.0954, 2e-4);
        assert_printed(rms_on_torus(128, 64, [QUADRIC]), 0.1401, 1e-4);
    }

    /// Half the edge length gives an eighth of the error.
    #[test]
    fn errors_shrink_with_the_third_power_of_the_edges() {
        let waves = [32, 64, 128].map(|n| rms_on_wave(n, JET));
        let tori = [48, 96, 192].map(|m| rms_on_torus(m, m / 2, JET));
        for [coarse, middle, fine] in [waves, tori] {
            let orders = [coarse / middle, middle / fine].map(libm::log2);
            assert!(
                orders.iter().all(|order| (order - 3.0).abs() < 0.25),
                "{orders:?}: {coarse} {middle} {fine}"
            );
        }
    }

    /// Where the surface is a cubic over the plane that the fit starts from, nothing but rounding remains.
    #[test]
    fn cubics_are_fitted_exactly() {
        let mut numbers = Numbers::new(3);
        for count in [14, 20, 64] {
            for _ in 0..200 {
                let mut signed = || 2.0 * numbers.unit() - 1.0;
                let c: [f64; 9] = std::array::from_fn(|_| signed());
                let points: Vec<DVec3> = (0..count)
                    .map(|_| {
                        let (x, y) = (signed(), signed());
                        let square = c[2] * x * x + c[3] * x * y + c[4] * y * y;
                        let cube = c[5] * x * x * x + c[6] * x * x * y + c[7] * x * y * y + c[8] * y * y * y;
                        DVec3::new(x, y, c[0] * x + c[1] * y + square + cube)
                    })
                    .collect();
                let mut neighbourhoods = Neighbourhoods::new();
                neighbourhoods.push(DVec3::ZERO, DVec3::Z, &points);
                let normal = neighbourhoods.normals(JET[0])[0].unwrap();
                let error = angle(normal, DVec3::new(-c[0], -c[1], 1.0));
                assert!(error < 1e-12, "{error:e}");
            }
        }
    }

    #[test]
    fn fallbacks_are_counted_by_reason() {
        let (_, fallbacks) = smooth(&patch(1, |_, _| (0.0, 0.0, 0.0)).0);
        let few = FitFailures { few_neighbours: 4, ..FitFailures::default() };
        assert_eq!(fallbacks, JetFallbacks { degree_3: few, degree_2: few });
        // Each vertex of an octahedron has the five others around it.
        let axes = [DVec3::X, DVec3::Y, DVec3::Z, -DVec3::X, -DVec3::Y, -DVec3::Z];
        let faces = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
        let (normals, fallbacks) = smooth(&build(axes.to_vec(), faces.concat()));
        let folded = FitFailures { folded: 6, ..FitFailures::default() };
        assert_eq!(fallbacks, JetFallbacks { degree_3: folded, degree_2: folded });
        assert!(normals.iter().zip(axes).all(|(&normal, axis)| angle(normal, axis) < 1e-15));
        // Points on three lines lie on a cubic, but not on a conic.
        let grid: Vec<DVec3> =
            (0..27).map(|i| DVec3::new(f64::from(i % 9), f64::from(i / 9 - 1), 0.0)).collect();
        let cells = (0..16).map(|i| i / 8 * 9 + i % 8).flat_map(|a| [a, a + 1, a + 10, a, a + 10, a + 9]);
        let (normals, fallbacks) = smooth(&build(grid, cells.collect()));
        let ill = FitFailures { ill_conditioned: 27, ..FitFailures::default() };
        assert_eq!(fallbacks, JetFallbacks { degree_3: ill, degree_2: FitFailures::default() });
        assert!(normals.iter().all(|&normal| normal == DVec3::Z));
    }

    /// The two-ring of a corner of a sheet has too few vertices; with a third ring there is a fit.
    #[test]
    fn rings_are_added_until_there_are_enough() {
        let (mesh, exact) = patch(12, |x, y| (x * y + 0.5 * x * x * x, y + 1.5 * x * x, x));
        let (normals, fallbacks) = smooth(&mesh);
        assert_eq!(fallbacks, JetFallbacks::default());
        let (_, largest) = errors(&normals, &exact);
        // At corners, where fits are one-sided: 0.367° was measured.
        assert!(largest < 0.5, "{largest}");
    }

    #[test]
    fn neither_power_nor_threads_change_a_bit() {
        let (mesh, _) = torus(48, 24);
        let normals = smooth(&mesh);
        for power in [-900, -300, -40, 1, 300, 900] {
            let scale = |p: DVec3| DVec3::from(p.to_array().map(|x| libm::ldexp(x, power)));
            let scaled = mesh.positions().iter().map(scale).collect();
            assert_eq!(smooth(&build(scaled, mesh.faces().corners().to_vec())), normals, "2^{power}");
        }
        assert!([1, 2, 3].iter().all(|&threads| with_threads(threads, || smooth(&mesh)) == normals));
        let recipe = NormalRecipe { weight: Weight::Jet, crease: Crease::OFF, ..NormalRecipe::default() };
        let field = compute(&mesh, &recipe);
        assert_eq!((field.normals.values, field.summary.jet_fallbacks), normals);
    }

    /// Numbering reaches a fit only through the last bits of the mean that it starts from.
    #[test]
    fn numbering_turns_normals_by_rounding_only() {
        let largest = turn_by_numbering(&torus(64, 32).0, 1, |mesh| smooth(mesh).0);
        assert!(0.0 < largest && largest < 1e-14, "{largest:e}");
    }
}
