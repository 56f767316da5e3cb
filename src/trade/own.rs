//! The trade on a mesh whose surface nobody knows.

use super::angles::{AngleErrors, Histogram, angle_between};
use super::cost::{Costs, Way};
use super::vertex::weight_name;
use super::{Observer, Progress};
use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, Weight, compute};
use crate::num::{CompensatedSum, Degrees, Radians, three_digits};
use glam::DVec3;
use serde::Serialize;

/// What the weights come to on somebody's own mesh.
///
/// The truth is not known. The quadric method, which is of second order where sums of faces are of first, stands in for it:
/// where the surface is smooth and the mesh fine enough, its own error is far below theirs. On a coarse mesh it is not: on
/// the jittered torus of 64 × 32 the quadric is off by 0.57° and Max's weights by 0.50°, on 128 × 64 by 0.14° and 0.25°. Ranks
/// that are close mean little there; weights that are far off still show.
///
/// Normals where the quadric gives what the angle mean gives to the bit say nothing, and are left out: there was no quadric,
/// having too few neighbours or none that bear it out ([`without_quadric`](Self::without_quadric)), or all is flat. What is
/// left may be little of the mesh; the reasons say how much.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OwnMesh {
    /// Vertices of all parts.
    pub vertices: usize,
    /// Faces of all parts.
    pub faces: usize,
    /// Normals: one for each vertex and smooth group.
    pub normals: usize,
    /// The share of normals that are the same, within 10⁻⁵ degrees, with every weight.
    pub alike: f64,
    /// Normals that errors are estimated from.
    pub estimated_from: usize,
    /// Normals that no quadric could be fitted for.
    pub without_quadric: usize,
    /// One for each of [`Weight::ALL`].
    pub methods: Vec<OwnMethod>,
    /// The rms angle in degrees between the normals of every two of them.
    pub differences: Vec<Vec<f64>>,
    /// Nanoseconds a triangle of the plain loop.
    pub plain_ns: f64,
    /// What to use.
    #[serde(serialize_with = "weight_name")]
    pub recommended: Weight,
    /// Why.
    pub reasons: Vec<String>,
}

/// One weight on the mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OwnMethod {
    /// The weight.
    #[serde(serialize_with = "weight_name")]
    pub weight: Weight,
    /// The angle to the quadric's normals, where those say something.
    pub estimate: AngleErrors,
    /// How these angles are spread.
    pub histogram: Histogram,
    /// Nanoseconds a triangle, on one thread, creases off.
    pub ns_per_triangle: f64,
    /// Times the plain loop.
    pub ratio: f64,
}

/// Normals are alike below this, in degrees: what single precision can tell apart is a hundred times coarser.
const ALIKE: f64 = 1e-5;
/// With fewer normals, or a smaller share of them, estimates mean nothing.
const FEWEST: (usize, f64) = (20, 0.05);
/// With a smaller share they are of a part of the mesh, which has to be said.
const WELL_COVERED: f64 = 0.5;
/// In degrees: the quadric is more accurate than the best sum where that is off by less than about half a degree, as on the
/// torus of [`OwnMesh`]. From twice that on it is no judge.
const MOST_REPORTED: f64 = 1.0;
/// In degrees: where the best sum is this close to the quadric, the quadric is the more accurate of the two. On the same torus
/// of 128 × 64 that is 0.23.
const QUADRIC_WINS: f64 = 0.3;
const SAFE: &str =
    "angle does not change when flat faces are cut into other triangles, so it is the safe choice.";
/// Below so many triangles a run is over in microseconds, and what it costs is not the weight's doing.
const SMALL: usize = 10_000;
/// The usual weight is not worth leaving for less than a tenth.
const SIGNIFICANT: f64 = 1.1;

impl OwnMesh {
    /// Measures all weights on the parts of a mesh, with the recipe's creases and groups.
    pub fn measure(parts: &[&Mesh], recipe: &NormalRecipe, observe: Observer) -> Self {
        let total = Weight::ALL.len() + 1;
        let mut without_quadric = 0;
        let mut compute_all = |(done, weight): (usize, Weight)| {
            observe(Progress { stage: "normals", done, total });
            let recipe = NormalRecipe { weight, ..*recipe };
            let fields: Vec<NormalField> = parts.iter().map(|mesh| compute(mesh, &recipe)).collect();
            without_quadric += fields.iter().map(|field| field.summary.quadric_fallbacks).sum::<usize>();
            fields.into_iter().flat_map(|field| field.normals.values).collect()
        };
        // Groups do not depend on the weight, so the same place in each list is the same corner of the mesh.
        let fields: Vec<Vec<DVec3>> = Weight::ALL.into_iter().enumerate().map(&mut compute_all).collect();
        observe(Progress { stage: "cost", done: total - 1, total });
        let costs = costs(parts);
        observe(Progress { stage: "cost", done: total, total });
        let of = |weight: Weight| {
            let place = Weight::ALL.iter().position(|&other| other == weight);
            &fields[place.expect("all weights are computed")]
        };
        let (angle, quadric) = (of(Weight::Angle), of(Weight::Quadric));
        let reported: Vec<usize> = (0..quadric.len()).filter(|&i| quadric[i] != angle[i]).collect();
        let methods: Vec<OwnMethod> = Weight::ALL
            .into_iter()
            .zip(&fields)
            .map(|(weight, normals)| {
                let angles: Vec<Radians> =
                    reported.iter().map(|&i| angle_between(normals[i], quadric[i])).collect();
                let cost = |of: fn(&super::CostRow) -> f64| {
                    costs.rows.iter().find(|row| row.weight == weight && row.way == Way::Mesh).map_or(0.0, of)
                };
                OwnMethod {
                    weight,
                    estimate: AngleErrors::of(&angles),
                    histogram: Histogram::of(&angles),
                    ns_per_triangle: cost(|row| row.ns_per_triangle),
                    ratio: cost(|row| row.ratio),
                }
            })
            .collect();
        let alike = share_alike(&fields);
        let (recommended, mut reasons) =
            recommend(&methods, [reported.len(), quadric.len(), without_quadric], alike);
        if (1..SMALL).contains(&costs.triangles) {
            reasons.push(format!(
                "Costs were taken on {} triangles: on so few most of it is what every call takes, and ratios change from run to \
                 run. `crease trade` has those of large meshes.",
                costs.triangles
            ));
        }
        Self {
            vertices: parts.iter().map(|mesh| mesh.vertex_count()).sum(),
            faces: parts.iter().map(|mesh| mesh.face_count()).sum(),
            normals: quadric.len(),
            alike,
            estimated_from: reported.len(),
            without_quadric,
            methods,
            differences: fields.iter().map(|a| fields.iter().map(|b| rms_between(a, b)).collect()).collect(),
            plain_ns: costs.plain_ns,
            recommended,
            reasons,
        }
    }
}

/// The normals of a weight on a mesh, and at every vertex the largest angle to the quadric's normals, where those say
/// something. For pictures.
pub fn estimate_map(
    mesh: &Mesh,
    recipe: &NormalRecipe,
    weight: Weight,
) -> (NormalField, Vec<Option<Radians>>) {
    let [own, angle, quadric] = [weight, Weight::Angle, Weight::Quadric]
        .map(|weight| compute(mesh, &NormalRecipe { weight, ..*recipe }));
    let mut largest: Vec<Option<Radians>> = vec![None; mesh.vertex_count()];
    let [normals, usual, truth] = [&own, &angle, &quadric].map(|field| &field.normals.values);
    for (entry, &vertex) in
        own.entry_vertex.iter().enumerate().filter(|&(entry, _)| usual[entry] != truth[entry])
    {
        let found = angle_between(normals[entry], truth[entry]);
        let known = &mut largest[vertex as usize];
        *known = Some(known.map_or(found, |known| Radians(known.0.max(found.0))));
    }
    (own, largest)
}

/// Costs on the largest part; large meshes are timed once, small ones several times.
fn costs(parts: &[&Mesh]) -> Costs {
    let largest = parts.iter().max_by_key(|mesh| mesh.face_count());
    let Some(mesh) = largest.filter(|mesh| mesh.face_count() > 0) else { return Costs::default() };
    Costs::on(mesh, if mesh.face_count() > 100_000 { 1 } else { 3 })
}

fn rms_between(a: &[DVec3], b: &[DVec3]) -> f64 {
    let mut squares = CompensatedSum::default();
    for (&a, &b) in a.iter().zip(b) {
        let angle = Degrees::from(angle_between(a, b)).0;
        squares += angle * angle;
    }
    (squares.value() / a.len().max(1) as f64).sqrt()
}

/// The share of places at which all lists hold the same normal.
fn share_alike(fields: &[Vec<DVec3>]) -> f64 {
    let [first, others @ ..] = fields else { return 1.0 };
    let same = |i: usize| {
        others.iter().all(|field| Degrees::from(angle_between(first[i], field[i])) < Degrees(ALIKE))
    };
    let alike = (0..first.len()).filter(|&i| same(i)).count();
    if first.is_empty() { 1.0 } else { alike as f64 / first.len() as f64 }
}

/// The weight to use, and why: from how many normals tell something, of how many, and for how many there is no quadric.
fn recommend(
    methods: &[OwnMethod],
    [reported, all, without_quadric]: [usize; 3],
    alike: f64,
) -> (Weight, Vec<String>) {
    let mut reasons = Vec::new();
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    if alike > 0.05 {
        reasons.push(format!("{} of the normals are the same with every weight.", percent(alike)));
    }
    if without_quadric > 0 {
        reasons.push(format!(
            "{} of the normals have no quadric: too few neighbours, or none that bear it out, as on two rings of points. They \
             are not in the estimate.",
            percent(without_quadric as f64 / all as f64)
        ));
    }
    let (fewest, share) = FEWEST;
    if reported < fewest || (reported as f64) < share * all as f64 {
        reasons.push(format!(
            "Quadrics tell something of only {reported} of {all} normals, too few to rank weights by: the mesh is flat between \
             its creases, or has too few vertices."
        ));
        reasons.push(SAFE.into());
        return (Weight::Angle, reasons);
    }
    if (reported as f64) < WELL_COVERED * all as f64 {
        reasons.push(format!(
            "Estimates are from {reported} of {all} normals ({}): they say nothing of the rest.",
            percent(reported as f64 / all as f64)
        ));
    }
    let of = |weight: Weight| methods.iter().find(|method| method.weight == weight);
    let sums = methods.iter().filter(|method| method.weight != Weight::Quadric);
    let ranked = sums.min_by(|a, b| a.estimate.rms.total_cmp(&b.estimate.rms));
    let (Some(best), Some(usual), Some(quadric)) = (ranked, of(Weight::Angle), of(Weight::Quadric)) else {
        return (Weight::Angle, reasons);
    };
    let degrees = |method: &OwnMethod| three_digits(method.estimate.rms);
    if best.estimate.rms > MOST_REPORTED {
        reasons.push(format!(
            "Even {}, the closest, is {}° from the quadric normals of {reported} normals: on a mesh as coarse as that the quadric is \
             no nearer to the truth than the sums, and weights cannot be ranked by it.",
            best.weight.name(),
            degrees(best)
        ));
        reasons.push(SAFE.into());
        return (Weight::Angle, reasons);
    }
    let recommended = if usual.estimate.rms <= SIGNIFICANT * best.estimate.rms { usual } else { best };
    reasons.push(match recommended.weight == best.weight {
        true => format!(
            "{} is closest to the quadric normals: rms {}° of {reported} normals.",
            best.weight.name(),
            degrees(best)
        ),
        false => format!(
            "{} is within a tenth of the closest weight, {} ({}° against {}°), and does not change when flat faces are \
             cut into other triangles.",
            usual.weight.name(),
            best.weight.name(),
            degrees(usual),
            degrees(best)
        ),
    });
    if recommended.weight != Weight::Angle {
        reasons.push(format!("angle, the default, is at {}°.", degrees(usual)));
    }
    reasons
        .push(format!("It costs {} times the plain single-precision loop.", three_digits(recommended.ratio)));
    if best.estimate.rms < QUADRIC_WINS {
        reasons.push(format!(
            "Where the surface is smooth and time is no matter, quadric itself is likely to be the most accurate, at {} times \
             that loop.",
            three_digits(quadric.ratio)
        ));
    }
    reasons.push(
        "Estimates take the quadric for the truth, which it nears as edges grow short beside the surface's curves; on a coarse \
         mesh, weights that are close to each other cannot be distinguished by it."
            .into(),
    );
    if recommended.estimate.rms < 0.1 {
        reasons.push(
            "The difference is below a tenth of a degree: any weight will do for diffuse light.".into(),
        );
    }
    (recommended.weight, reasons)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, MeshBuilder};
    use crate::normals::Crease;
    use crate::surface::{Surface, Tessellation, Torus};

    #[test]
    fn a_jittered_torus_is_ranked_as_the_truth_ranks_it() {
        let tessellation = Tessellation { jitter: 0.5, segments: [128, 64], ..Tessellation::default() };
        let mesh = Surface::from(Torus::default()).tessellate(&tessellation).unwrap();
        let recipe = NormalRecipe { crease: Crease::OFF, ..NormalRecipe::default() };
        let own = OwnMesh::measure(&[&mesh], &recipe, &|_| ());
        assert_eq!(own.recommended, Weight::Max, "{:?}", own.reasons);
        let rms = |weight| own.methods.iter().find(|method| method.weight == weight).unwrap().estimate.rms;
        // Estimates are as far from the true errors as the quadric itself is from the truth, at the most: the triangle
        // inequality of root mean squares.
        let truth = &mesh.columns().normals.as_ref().unwrap().values;
        let error =
            |weight| rms_between(&compute(&mesh, &NormalRecipe { weight, ..recipe }).normals.values, truth);
        let of_quadric = error(Weight::Quadric);
        assert!(of_quadric < 0.2, "{of_quadric}");
        for weight in [Weight::Max, Weight::Uniform, Weight::Angle] {
            assert!((rms(weight) - error(weight)).abs() <= of_quadric, "{}: {}", weight.name(), rms(weight));
        }
        assert_eq!(rms(Weight::Quadric), 0.0);
        for (row, of_row) in own.differences.iter().enumerate() {
            assert_eq!(of_row[row], 0.0);
            for (column, &difference) in of_row.iter().enumerate() {
                assert_eq!(difference, own.differences[column][row]);
            }
        }
    }

    /// On a coarse mesh the quadric is farther off than the sums that it would judge.
    #[test]
    fn a_coarse_torus_gets_the_safe_choice() {
        let tessellation = Tessellation { jitter: 0.5, segments: [24, 12], ..Tessellation::default() };
        let mesh = Surface::from(Torus::default()).tessellate(&tessellation).unwrap();
        let recipe = NormalRecipe { crease: Crease::OFF, ..NormalRecipe::default() };
        let own = OwnMesh::measure(&[&mesh], &recipe, &|_| ());
        let truth = &mesh.columns().normals.as_ref().unwrap().values;
        let error =
            |weight| rms_between(&compute(&mesh, &NormalRecipe { weight, ..recipe }).normals.values, truth);
        assert!(error(Weight::Quadric) > error(Weight::Max), "the quadric would be the better judge");
        assert_eq!(own.recommended, Weight::Angle);
        assert!(own.reasons.iter().any(|reason| reason.contains("cannot be ranked")), "{:?}", own.reasons);
    }

    /// The quadric through two rings of rounded points is anything: it was once taken for the truth, and all weights for 90°
    /// off it.
    #[test]
    fn two_rings_tell_nothing() {
        use crate::surface::{Cylinder, Tessellation};
        let tessellation = Tessellation { segments: [48, 1], ..Tessellation::default() };
        let mesh = Surface::from(Cylinder::default()).tessellate(&tessellation).unwrap();
        let turn = glam::DQuat::from_xyzw(0.1, 0.7, -0.3, 0.5).normalize();
        let positions = mesh.positions().iter().map(|&p| (turn * p).as_vec3().as_dvec3()).collect();
        let faces = mesh.faces().clone();
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
        let own = OwnMesh::measure(&[&mesh], &NormalRecipe::default(), &|_| ());
        assert_eq!((own.recommended, own.without_quadric), (Weight::Angle, own.normals));
        assert_eq!(own.estimated_from, 0);
        assert!(own.reasons.iter().any(|reason| reason.starts_with("100 % of the normals have no quadric")));
        for method in &own.methods {
            assert!(method.estimate.rms < 1.0, "{method:?}");
        }
    }

    #[test]
    fn a_box_gets_the_safe_choice() {
        let positions = [0.0, 1.0].into_iter().flat_map(|x| [0.0, 2.0].map(|y| (x, y)));
        let positions = positions.flat_map(|(x, y)| [0.0, 3.0].map(|z| DVec3::new(x, y, z))).collect();
        let quads = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3];
        let faces = Faces::polygons(quads.to_vec(), (0..=6).map(|k| 4 * k).collect());
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build().unwrap();
        let own = OwnMesh::measure(&[&mesh], &NormalRecipe::default(), &|_| ());
        assert_eq!((own.recommended, own.alike), (Weight::Angle, 1.0));
        assert_eq!(own.normals, 24);
        let nothing = OwnMesh::measure(&[], &NormalRecipe::default(), &|_| ());
        assert_eq!((nothing.recommended, nothing.normals), (Weight::Angle, 0));
    }
}
