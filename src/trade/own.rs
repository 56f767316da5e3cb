//! All weights on a user mesh, whose true normals are not known.

use super::advice::{digits, sentence};
use super::angles::{AngleErrors, Histogram, angle_between};
use super::cost::{CostRow, Costs, Way};
use super::effort::{Observer, Progress};
use super::vertex::weight_name;
use crate::mesh::Mesh;
use crate::normals::{NormalField, NormalRecipe, Weight, compute};
use crate::num::{CompensatedSum, Degrees, Radians};
use glam::DVec3;
use serde::Serialize;

/// The errors and costs of all weights on a user mesh.
///
/// The true normals are not known. The quadric method, of second order where sums of faces are of first, replaces them:
/// where the surface is smooth and the mesh fine enough, its own error is far below theirs. On a coarse mesh it is not: on
/// the jittered torus of 64 × 32 the error of the quadric is 0.57° and that of Max's weights 0.50°, on 128 × 64 0.14° and
/// 0.25°. Small differences mean little there; weights with large errors still show.
///
/// Normals for which the quadric is bitwise the angle mean are omitted: no quadric could be fitted
/// ([`without_quadric`](Self::without_quadric)), or the faces are coplanar. The rest may be a small part of the mesh; the
/// reasons say how much.
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
    /// The angle to the quadric's normals, where they differ from the angle mean.
    pub estimate: AngleErrors,
    /// How these angles are spread.
    pub histogram: Histogram,
    /// Nanoseconds a triangle, on one thread, creases off.
    pub ns_per_triangle: f64,
    /// Times the plain loop.
    pub ratio: f64,
}

/// Normals count as equal below this angle, in degrees: single precision is a hundred times coarser.
const ALIKE: f64 = 1e-5;
/// With fewer normals, or a smaller share of them, estimates mean nothing.
const FEWEST: (usize, f64) = (20, 0.05);
/// With a smaller share, estimates are of a part of the mesh, which has to be said.
const WELL_COVERED: f64 = 0.5;
/// In degrees: the quadric is more accurate than the best sum where that is off by less than about half a degree, as on the
/// torus of [`OwnMesh`]. From twice that on weights cannot be ranked by it.
const TOO_COARSE: f64 = 1.0;
/// In degrees: where the best sum is this close to the quadric, the quadric is the more accurate of the two. On the same torus
/// of 128 × 64 that is 0.23.
const QUADRIC_WINS: f64 = 0.3;
/// On fewer triangles a run takes microseconds, most of them independent of the weight.
const SMALL: usize = 10_000;
/// The default weight is recommended if its error is within this factor of the smallest.
const SIGNIFICANT: f64 = 1.1;

impl OwnMesh {
    /// Measures all weights on the parts of a mesh, with the recipe's creases and groups.
    pub fn measure(parts: &[&Mesh], recipe: &NormalRecipe, observe: Observer) -> Self {
        let total = Weight::ALL.len() + 1;
        let mut without_quadric = 0;
        // Groups do not depend on the weight: the same index in each list is the same corner of the mesh.
        let mut fields: Vec<Vec<DVec3>> = Vec::new();
        for (done, weight) in Weight::ALL.into_iter().enumerate() {
            observe(Progress { stage: "normals", done, total });
            let recipe = NormalRecipe { weight, ..*recipe };
            let computed: Vec<NormalField> = parts.iter().map(|mesh| compute(mesh, &recipe)).collect();
            if weight == Weight::Quadric {
                without_quadric = computed.iter().map(|field| field.summary.quadric_fallbacks).sum();
            }
            fields.push(computed.into_iter().flat_map(|field| field.normals.values).collect());
        }
        observe(Progress { stage: "cost", done: total - 1, total });
        let costs = costs(parts);
        observe(Progress { stage: "cost", done: total, total });
        let [angle, quadric] = [Weight::Angle, Weight::Quadric].map(|weight| &fields[weight as usize]);
        let estimated: Vec<usize> = (0..quadric.len()).filter(|&i| quadric[i] != angle[i]).collect();
        let method = |(weight, normals): (Weight, &Vec<DVec3>)| {
            let angles: Vec<Radians> =
                estimated.iter().map(|&i| angle_between(normals[i], quadric[i])).collect();
            let cost = |of: fn(&CostRow) -> f64| costs.row(Way::Mesh, weight).map_or(0.0, of);
            OwnMethod {
                weight,
                estimate: AngleErrors::of(&angles),
                histogram: Histogram::of(&angles),
                ns_per_triangle: cost(|row| row.ns_per_triangle),
                ratio: cost(|row| row.ratio),
            }
        };
        let mut own = Self {
            vertices: parts.iter().map(|mesh| mesh.vertex_count()).sum(),
            faces: parts.iter().map(|mesh| mesh.face_count()).sum(),
            normals: quadric.len(),
            alike: share_alike(&fields),
            estimated_from: estimated.len(),
            without_quadric,
            methods: Weight::ALL.into_iter().zip(&fields).map(method).collect(),
            differences: fields.iter().map(|a| fields.iter().map(|b| rms_between(a, b)).collect()).collect(),
            plain_ns: costs.plain_ns,
            recommended: Weight::Angle,
            reasons: Vec::new(),
        };
        own.recommend();
        if (1..SMALL).contains(&costs.triangles) {
            let triangles = costs.triangles.to_string().into();
            own.reasons.push(sentence("few-triangles", &[("triangles", triangles)]));
        }
        own
    }

    /// Chooses the weight to use, with the reasons.
    fn recommend(&mut self) {
        self.reasons = self.reasons_of_coverage();
        let (estimated, all) = (self.estimated_from, self.normals);
        let (fewest, share) = FEWEST;
        let counts = || [("estimated", estimated.to_string().into()), ("all", all.to_string().into())];
        if estimated < fewest || (estimated as f64) < share * all as f64 {
            self.reasons.extend([sentence("too-few", &counts()), sentence("safe", &[])]);
            return;
        }
        if (estimated as f64) < WELL_COVERED * all as f64 {
            let [estimated_from, of] = counts();
            let share = percent(estimated as f64 / all as f64).into();
            self.reasons.push(sentence("partial", &[estimated_from, of, ("share", share)]));
        }
        let method = |weight: Weight| self.methods.iter().find(|method| method.weight == weight);
        let sums = self.methods.iter().filter(|method| !method.weight.is_fit());
        let closest = sums.min_by(|a, b| a.estimate.rms.total_cmp(&b.estimate.rms));
        let (Some(best), Some(usual), Some(quadric)) =
            (closest, method(Weight::Angle), method(Weight::Quadric))
        else {
            return;
        };
        let [rms, usual_rms] = [best, usual].map(|method| method.estimate.rms);
        let name = ("best", best.weight.name().into());
        let [estimated_from, _] = counts();
        if rms > TOO_COARSE {
            let sentences = [
                sentence("too-coarse", &[name, ("rms", digits(rms)), estimated_from]),
                sentence("safe", &[]),
            ];
            self.reasons.extend(sentences);
            return;
        }
        let recommended = if usual_rms <= SIGNIFICANT * rms { usual } else { best };
        let mut reasons = vec![match recommended.weight == best.weight {
            true => sentence("closest", &[name, ("rms", digits(rms)), estimated_from]),
            false => {
                let usual = [("usual", usual.weight.name().into()), ("usual-rms", digits(usual_rms))];
                let [usual, usual_rms] = usual;
                sentence("near-closest", &[usual, name, usual_rms, ("rms", digits(rms))])
            }
        }];
        if recommended.weight != Weight::Angle {
            reasons.push(sentence("default", &[("rms", digits(usual_rms))]));
        }
        reasons.push(sentence("cost", &[("ratio", digits(recommended.ratio))]));
        if rms < QUADRIC_WINS {
            reasons.push(sentence("quadric-wins", &[("ratio", digits(quadric.ratio))]));
        }
        reasons.push(sentence("estimates", &[]));
        if recommended.estimate.rms < 0.1 {
            reasons.push(sentence("any-weight", &[]));
        }
        self.recommended = recommended.weight;
        self.reasons.extend(reasons);
    }

    /// The share of normals that do not depend on the weight, and of those without a quadric.
    fn reasons_of_coverage(&self) -> Vec<String> {
        let alike = (self.alike > 0.05).then(|| sentence("alike", &[("share", percent(self.alike).into())]));
        let without = (self.without_quadric > 0).then(|| {
            let share = percent(self.without_quadric as f64 / self.normals as f64);
            sentence("without-quadric", &[("share", share.into())])
        });
        alike.into_iter().chain(without).collect()
    }
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

/// The normals of a weight on a mesh, and at every vertex the largest angle to the quadric's normals, where they differ from
/// the angle mean. For pictures.
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
        let positions = mesh.positions().iter().map(|p| (turn * p).as_vec3().as_dvec3()).collect();
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
