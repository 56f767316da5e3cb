//! Vertex normals against the truth: every weight on every surface, cut in every way, at four resolutions.

use super::angles::{AngleErrors, Histogram, angle_between, order_of_convergence};
use super::cases::{NamedSurface, SampleMesh, Tiling};
use super::effort::{Effort, Observer, Progress};
use crate::mesh::Mesh;
use crate::normals::{Crease, NormalField, NormalRecipe, Weight, compute_on};
use crate::num::Radians;
use crate::num::parallel;
use serde::Serialize;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The errors of all weights on one surface cut one way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VertexCase {
    /// The surface.
    pub surface: &'static str,
    /// How it is cut.
    pub tiling: Tiling,
    /// The meshes, coarse to fine, each with edges half as long as the one before.
    pub meshes: Vec<MeshSize>,
    /// Which of them errors are quoted and drawn of: 64 × 32 and its like.
    pub quoted: usize,
    /// One for each of [`Weight::ALL`].
    pub methods: Vec<MethodErrors>,
}

/// The size of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct MeshSize {
    /// Cells along the parameters (of a lattice: the first along its longest side).
    pub segments: [u32; 2],
    /// Its vertices.
    pub vertices: usize,
    /// Its faces.
    pub faces: usize,
    /// Vertices whose errors are not counted: on open sides, and at the tip of a cone.
    pub excluded: usize,
}

/// The errors of one weight.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MethodErrors {
    /// The weight.
    pub weight: Weight,
    /// Against the exact normals, for each mesh.
    pub errors: Vec<AngleErrors>,
    /// The order of convergence of the root mean square; `None` where it is exact.
    pub order: Option<f64>,
    /// The rms errors on the [quoted](VertexCase::quoted) mesh with four other seeds; none where it has no random numbers.
    pub seeds: Vec<f64>,
    /// The errors on the quoted mesh.
    pub histogram: Histogram,
}

/// The level whose errors are quoted and drawn.
const QUOTED: u32 = 2;

/// Seeds in addition to the first that errors are quoted of.
const MORE_SEEDS: u32 = 4;

impl VertexCase {
    /// Measures one surface cut one way, at the given levels of resolution. A surface that cannot be cut like this has no
    /// meshes.
    pub fn measure(surface: &NamedSurface, tiling: Tiling, levels: std::ops::Range<u32>) -> Self {
        let methods = Weight::ALL.map(|weight| MethodErrors {
            weight,
            errors: Vec::new(),
            order: None,
            seeds: Vec::new(),
            histogram: Histogram::default(),
        });
        let quoted =
            (QUOTED.clamp(levels.start, levels.end.max(levels.start + 1) - 1) - levels.start) as usize;
        let first = levels.start;
        let mut case =
            Self { surface: surface.name, tiling, meshes: Vec::new(), quoted, methods: methods.into() };
        for level in levels {
            let tessellation = tiling.tessellation(&surface.surface, level);
            let Ok(sample) = SampleMesh::new(surface, &tessellation) else { continue };
            case.meshes.push(MeshSize {
                segments: tessellation.segments,
                vertices: sample.mesh.vertex_count(),
                faces: sample.mesh.face_count(),
                excluded: sample.excluded(),
            });
            for method in &mut case.methods {
                let angles = sample.errors(&sample.field(method.weight));
                method.errors.push(AngleErrors::of(&angles));
                if case.meshes.len() == quoted + 1 {
                    method.histogram = Histogram::of(&angles);
                }
            }
        }
        for more in (1..=MORE_SEEDS).filter(|_| tiling.is_random()) {
            let mut tessellation = tiling.tessellation(&surface.surface, first + quoted as u32);
            tessellation.seed += more;
            let Ok(sample) = SampleMesh::new(surface, &tessellation) else { continue };
            for method in &mut case.methods {
                method.seeds.push(AngleErrors::of(&sample.errors(&sample.field(method.weight))).rms);
            }
        }
        for method in &mut case.methods {
            let rms: Vec<f64> = method.errors.iter().map(|errors| errors.rms).collect();
            method.order = order_of_convergence(&rms);
        }
        case
    }

    /// The errors of a weight on the quoted mesh.
    pub fn quoted_errors(&self, weight: Weight) -> Option<AngleErrors> {
        self.method(weight)?.errors.get(self.quoted).copied()
    }

    /// The errors of a weight.
    pub fn method(&self, weight: Weight) -> Option<&MethodErrors> {
        self.methods.iter().find(|method| method.weight == weight)
    }
}

/// All cases of an effort, several at a time. The numbers do not depend on how many.
pub fn vertex_cases(effort: Effort, observe: Observer) -> Vec<VertexCase> {
    let surfaces = NamedSurface::all(effort);
    let pairs: Vec<(&NamedSurface, Tiling)> = surfaces
        .iter()
        .flat_map(|surface| Tiling::ALL.map(|tiling| (surface, tiling)))
        .filter(|(surface, tiling)| tiling.fits(&surface.surface))
        .collect();
    let (done, total) = (AtomicUsize::new(0), pairs.len());
    let measure = |&(surface, tiling): &(&NamedSurface, Tiling)| {
        let case = VertexCase::measure(surface, tiling, tiling.levels(effort));
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        observe(Progress { stage: "vertex normals", done, total });
        case
    };
    parallel::map_each(&pairs, measure)
}

impl SampleMesh {
    /// The vertex normals of a weight.
    fn field(&self, weight: Weight) -> NormalField {
        compute_on(&self.mesh, &self.topology, &recipe(weight))
    }
}

/// The recipe that weights are compared with: no edge is hard.
pub(super) fn recipe(weight: Weight) -> NormalRecipe {
    NormalRecipe { weight, crease: Crease::OFF, ..NormalRecipe::default() }
}

/// The angle to the truth at every vertex of a mesh of a surface, 0 where it is not counted; and the mesh with its field.
/// For pictures.
pub fn error_map(
    surface: &NamedSurface,
    tiling: Tiling,
    weight: Weight,
) -> Option<(Mesh, NormalField, Vec<Radians>)> {
    let sample = SampleMesh::new(surface, &tiling.tessellation(&surface.surface, QUOTED)).ok()?;
    let field = sample.field(weight);
    let mut angles = vec![Radians(0.0); sample.mesh.vertex_count()];
    for (&normal, &vertex) in field.normals.values.iter().zip(&field.entry_vertex) {
        if let Some(truth) = sample.truth[vertex as usize] {
            angles[vertex as usize] = angle_between(normal, truth);
        }
    }
    Some((sample.mesh, field, angles))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::{Pattern, Tessellation};

    fn surface(name: &str) -> NamedSurface {
        NamedSurface::all(Effort::Full).into_iter().find(|surface| surface.name == name).unwrap()
    }

    /// Errors to as many digits as are printed.
    fn assert_printed(found: f64, printed: f64, digits: i32) {
        let unit = libm::exp10(f64::from(-digits));
        assert!((found - printed).abs() <= 0.500_001 * unit, "{found} is not {printed}");
    }

    /// Figures computed outside this program, in double precision, to all their digits.
    #[test]
    fn icosphere_figures_come_out() {
        let case = VertexCase::measure(&surface("sphere"), Tiling::Icosphere, 0..4);
        assert_eq!(case.meshes[2].vertices, 642);
        let at = |level: usize, weight| {
            let method = case.method(weight).unwrap();
            (method.errors[level].rms, method.errors[level].max)
        };
        for (level, weight, rms, max) in [
            (2, Weight::Uniform, 0.292_900, 0.473_844),
            (2, Weight::Area, 0.422_980, 0.676_912),
            (2, Weight::Angle, 0.166_633, 0.298_514),
            (2, Weight::Edge, 0.108_986, 0.242_017),
            (1, Weight::Uniform, 0.651_007, 0.759_910),
            (1, Weight::Area, 0.943_064, 1.354_141),
            (1, Weight::Angle, 0.369_381, 0.595_582),
        ] {
            let found = at(level, weight);
            assert_printed(found.0, rms, 6);
            assert_printed(found.1, max, 6);
        }
        for level in 0..4 {
            // Positions are rounded by 1.1e-16 over edges of 0.07 and more, up to a sixth part of a turn about them: 57°·6·1.6e-15.
            assert!(at(level, Weight::Max).1 < 5e-13, "{level}: {}", at(level, Weight::Max).1);
        }
        // Level 1 (42 vertices): exact by symmetry, whatever the weight of the first order.
        for weight in Weight::SUMS {
            assert!(at(0, weight).1 < 1e-13, "{}", weight.name());
        }
    }

    /// From 64 × 32 to 512 × 256: first order on the jittered torus, second order on the regular one, and quadrics of second
    /// order on both.
    #[test]
    fn the_torus_converges_as_published() {
        let case = VertexCase::measure(&surface("torus"), Tiling::Jittered, 2..6);
        let method = |case: &VertexCase, weight| case.method(weight).cloned().unwrap();
        for (weight, rms, max) in [(Weight::Uniform, 1.644, 4.677), (Weight::Max, 0.498, 2.054)] {
            let found = method(&case, weight);
            assert_printed(found.errors[0].rms, rms, 3);
            assert_printed(found.errors[0].max, max, 3);
            assert!((found.order.unwrap() - 1.0).abs() < 0.05, "{:?}", found.order);
        }
        let quadric = method(&case, Weight::Quadric).order.unwrap();
        assert!((quadric - 2.0).abs() < 0.15, "{quadric}");
        let regular = VertexCase::measure(&surface("torus"), Tiling::Regular, 2..6);
        for weight in [Weight::Uniform, Weight::Area, Weight::Angle, Weight::Edge] {
            let order = method(&regular, weight).order.unwrap();
            assert!((order - 2.0).abs() < 0.05, "{}: {order}", weight.name());
        }
        // Exact on grids of the torus's own parameters.
        assert!(method(&regular, Weight::Max).errors.iter().all(|errors| errors.max < 1e-10));
    }

    /// Of second and third order inside, on every surface that is smooth enough.
    #[test]
    fn fits_have_their_orders_on_jittered_meshes() {
        for name in ["wave", "monkey-saddle", "ellipsoid", "bezier"] {
            let case = VertexCase::measure(&surface(name), Tiling::Jittered, 2..6);
            for (weight, expected) in [(Weight::Quadric, 2.0), (Weight::Jet, 3.0)] {
                let method = case.method(weight).unwrap();
                let order = method.order.unwrap();
                assert!((order - expected).abs() < 0.15, "{name}: {order} from {:?}", method.errors);
            }
        }
    }

    /// Without noise the error of jets is at most a tenth of that of angle means, on stretched meshes three tenths; on noisy
    /// meshes the choice is the quadric's.
    #[test]
    fn jets_have_a_tenth_of_the_error_of_angle_means() {
        for tiling in Tiling::ALL {
            let name = if tiling == Tiling::Icosphere { "ellipsoid" } else { "wave" };
            if !tiling.fits(&surface(name).surface) {
                continue;
            }
            let case = VertexCase::measure(&surface(name), tiling, 2..3);
            let rms = |weight| case.quoted_errors(weight).unwrap().rms;
            let [angle, quadric, jet, best] =
                [Weight::Angle, Weight::Quadric, Weight::Jet, Weight::Best].map(rms);
            if tiling == Tiling::Noisy {
                assert!(best <= 1.1 * quadric, "{best} {quadric}");
            } else {
                let most = if tiling == Tiling::Stretched { 0.3 } else { 0.1 };
                assert!(jet <= most * angle, "{}: {jet} {angle}", tiling.name());
                assert_eq!(best, jet, "{}: {quadric}", tiling.name());
            }
        }
    }

    #[test]
    fn threads_change_no_bit() {
        let measure = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| VertexCase::measure(&surface("wave"), Tiling::Scattered, 0..3))
        };
        assert_eq!(measure(1), measure(3));
    }

    /// On the small triangles of marching cubes a tenth of the vertices has most of the error of jets, 29 times that of quadrics.
    #[test]
    fn slight_noise_makes_quadrics_the_choice() {
        let pattern = Pattern::Marching;
        let cut =
            Tessellation { pattern, segments: [48, 48], noise: 3e-4, seed: 8, ..Tessellation::default() };
        let sample = SampleMesh::new(&surface("catenoid"), &cut).unwrap();
        assert_eq!(sample.field(Weight::Best).summary.choice.unwrap().weight, Weight::Quadric);
        let rms = |weight| AngleErrors::of(&sample.errors(&sample.field(weight))).rms;
        assert!(rms(Weight::Jet) > 20.0 * rms(Weight::Quadric));
    }

    /// On every surface in every tiling.
    #[test]
    fn the_choice_has_nearly_the_smallest_error() {
        let surfaces = NamedSurface::all(Effort::Full);
        let pairs = surfaces.iter().flat_map(|surface| Tiling::ALL.map(|tiling| (surface, tiling)));
        let pairs: Vec<_> = pairs.filter(|(surface, tiling)| tiling.fits(&surface.surface)).collect();
        assert_eq!(pairs.len(), 91);
        let is_close = |&(surface, tiling): &(&NamedSurface, Tiling)| {
            let sample = SampleMesh::new(surface, &tiling.tessellation(&surface.surface, QUOTED)).unwrap();
            let rms = |weight| AngleErrors::of(&sample.errors(&sample.field(weight))).rms;
            let [angle, quadric, jet, best] =
                [Weight::Angle, Weight::Quadric, Weight::Jet, Weight::Best].map(rms);
            let smallest = angle.min(quadric).min(jet);
            // 1.38 times on the noisy teapot; 0.0018 degrees on the cone with slivers, whose angle means are exact.
            let is_close = best <= (1.4 * smallest).max(smallest + 0.002);
            (!is_close).then(|| format!("{} {}: {best} {smallest}", surface.name, tiling.name()))
        };
        let far: Vec<String> = parallel::map_each(&pairs, is_close).into_iter().flatten().collect();
        assert!(far.is_empty(), "{far:?}");
    }
}
