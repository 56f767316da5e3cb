//! Many faces at one vertex, faces that meet as in no smooth surface, and quadrics through rounded points.

use super::face_normals::indexed;
use super::fans::{self, Fan, recipe};
use super::prelude::*;
use crate::normals::Faults;
use crate::trade::exact;

/// The height of the cones whose valence varies: their faces are tilted by 1/10.
const HEIGHT: f64 = 10.0;
/// The largest valence that all weights are computed with; beyond it, only the uniform one.
const FEW: usize = 1000;
/// The valence of the fans that nearly cancel.
const FACES: usize = 10_000;

pub(super) fn valence_cases() -> Vec<StressCase> {
    let valences = [3, 10, 100, FEW, 100_000, 1_000_000].map(|valence| {
        let weights = if valence <= FEW { &fans::WEIGHTS[..] } else { &[Weight::Uniform] };
        cone_case("valence", format!("{valence} faces"), valence, HEIGHT, weights)
    });
    // Sums shrink by one over the tilt of faces from the vertical.
    let tilts = [1e-1, 1e-2, 1e-3, 1e-4, 1e-5].map(|tilt: f64| {
        cone_case("tilt", format!("tilt {tilt:.0e}"), FACES, 1.0 / tilt, &[Weight::Uniform])
    });
    // In the range of `fast`, up to where a sum loses all but three digits, and beyond.
    let steep = [1e-1, 1e-2, 2e-3, 5e-4].map(|tilt: f64| {
        cone_case("steep-tilt", format!("tilt {tilt:.0e}, 8 faces"), 8, 1.0 / tilt, &fans::WEIGHTS)
    });
    valences.into_iter().chain(tilts).chain(steep).collect()
}

fn cone_case(
    texts: &'static str,
    name: String,
    valence: usize,
    height: f64,
    weights: &'static [Weight],
) -> StressCase {
    // The bounds depend on the shape only through its condition number, which is that of a smaller fan.
    let bounds = Fan::cone(valence.min(FACES), height).bounds(valence);
    StressCase::new(Group::Valence, texts, name, bounds, move || {
        fans::measure(&[Fan::cone(valence, height)], weights)
    })
}

pub(super) fn fan_cases() -> Vec<StressCase> {
    let bound = Bound::none_wrong("opposite-bound");
    let bounds = (bound, Some(bound));
    let opposite = StressCase::new(Group::Fan, "opposite", "opposite faces", bounds, measure_opposite);
    let folds = [10.0, 1.0, 0.1].map(|degrees| {
        fans::case(Group::Fan, "folded", format!("folded to {degrees} degrees"), folded_fans(degrees))
    });
    let fins = fans::case(Group::Fan, "fins", "edges of three faces", fins());
    let tips = [1e-4, 1e-2, 1.0, 1e2, 1e4].map(|height| {
        let fans = [3, 8, 64].map(|n| Fan::cone(n, height)).to_vec();
        fans::case(Group::Fan, "cone-tips", format!("cone tips of height {height}"), fans)
    });
    let quadrics = STORED.map(quadric_case);
    [opposite].into_iter().chain(folds).chain([fins]).chain(tips).chain(quadrics).collect()
}

/// Spokes forth and back, the way back lifted by an angle.
fn folded_fans(degrees: f64) -> Vec<Fan> {
    let mut numbers = Numbers::new(7);
    let fan = |_| {
        let lift = libm::tan(degrees.to_radians());
        let rim = |k: usize| {
            let turn = 0.6 * k as f64;
            DVec3::new(libm::cos(turn), libm::sin(turn), 0.0)
        };
        let back = |k: usize, numbers: &mut Numbers| rim(k) + DVec3::Z * lift * (0.5 + numbers.unit());
        let mut ring: Vec<DVec3> = (0..5).map(rim).collect();
        ring.extend((1..4).rev().map(|k| back(k, &mut numbers)));
        let ring: Vec<Vec3> = ring.into_iter().map(|p| p.as_vec3()).collect();
        Fan::closed(Vec3::ZERO, &ring)
    };
    (0..10).map(fan).collect()
}

/// Three blades on one edge, and a fourth next to it.
fn fins() -> Vec<Fan> {
    let mut numbers = Numbers::new(8);
    let fan = |_| {
        let [edge, a, b, c, d] = [0; 5].map(|_| vector(&mut numbers).as_vec3());
        Fan { centre: Vec3::splat(0.1), triangles: vec![[edge, a], [edge, b], [edge, c], [a, d]] }
    };
    (0..20).map(fan).collect()
}

/// The same triangle from both sides: the sum cancels, which has to be reported.
fn measure_opposite() -> Measured {
    let mut numbers = Numbers::new(9);
    let positions: Vec<Vec3> =
        (0..60).map(|_| Vec3::from_array([0; 3].map(|_| numbers.unit() as f32))).collect();
    let triangles: Vec<[u32; 3]> =
        (0..20).flat_map(|i| [[3 * i, 3 * i + 1, 3 * i + 2], [3 * i, 3 * i + 2, 3 * i + 1]]).collect();
    let (mesh, corners) = (indexed(&positions, &triangles), 3 * triangles.len());
    // Corners that are not reported, and normals that are not unit.
    let wrong = |field: &NormalField| {
        let is_unit = |normal: &DVec3| (normal.length() - 1.0).abs() < 1e-6;
        let reported = Faults::count(&field.faults.corners, FaultReason::CancellingFan);
        corners - reported + field.normals.values.iter().filter(|normal| !is_unit(normal)).count()
    };
    let mut measured = Measured::default();
    let (mut faithful_wrong, mut fast_wrong, mut plain) = (0, 0, Worst::default());
    for weight in fans::WEIGHTS {
        let [faithful, fast] = [Precision::Faithful, Precision::Fast]
            .map(|precision| compute(&mesh, &fans::recipe(weight, precision)));
        faithful_wrong += wrong(&faithful);
        fast_wrong += wrong(&fast);
        measured.samples += corners;
        measured.declined += if fast.summary.fast_declined { corners } else { 0 };
        for [a, b, c] in positions.as_chunks::<3>().0 {
            for [centre, e1, e2] in [[a, b, c], [b, c, a], [c, a, b]] {
                let normal = plain::vertex_normal(*centre, &[[*e1, *e2], [*e2, *e1]], weight);
                plain.add(Outcome::vector(normal.as_dvec3(), |_| 1.0));
            }
        }
    }
    Measured {
        faithful: Worst::wrong(faithful_wrong),
        fast: Some(Worst::wrong(fast_wrong)),
        plain: Some(plain),
        // 0/0.
        definition: Worst::not_a_number(measured.samples),
        ..measured
    }
}

/// Sides of the cylinders.
const SIDES: [u32; 3] = [16, 32, 64];
/// Rotations of each.
const TURNS: usize = 5;

/// A name of the way that positions are stored, by how much that moves a coordinate, and the stored coordinate.
type Stored = (&'static str, f64, fn(f64) -> f64);

const STORED: [Stored; 4] = [
    ("f64", 2.3e-16, |x| x),
    ("f32", 1.2e-7, |x| f64::from(x as f32)),
    ("6 decimals", 5e-7, |x| (x * 1e6).round() / 1e6),
    ("4 decimals", 5e-5, |x| (x * 1e4).round() / 1e4),
];

fn quadric_case((name, moved, store): Stored) -> StressCase {
    // A corner that moves by d = √3 coordinates tilts a face by 2d over its shorter edge, here the side of the cylinder of
    // most sides, and a mean no more. Fits may differ from their neighbours by twice as much, 2·2 such tilts.
    let shorter = TAU / f64::from(SIDES[2]);
    let most = (10.0 * 3.0_f64.sqrt() * moved / shorter).to_degrees() + 1e-10;
    let bounds = (Bound::new(most, Unit::Degrees, "quadric-bound"), None);
    let name = format!("quadric on two rings, {name}");
    StressCase::new(Group::Fan, "quadric", name, bounds, move || measure(store))
}

fn measure(store: fn(f64) -> f64) -> Measured {
    let mut numbers = Numbers::new(41);
    let (mut outcomes, mut definition) = (Vec::new(), Worst::default());
    for sides in SIDES {
        for _ in 0..TURNS {
            let turn = rotation(&mut numbers);
            let mesh = cylinder(sides, turn, store);
            let field = compute(&mesh, &recipe(Weight::Quadric, Precision::Faithful));
            for (&normal, &vertex) in field.normals.values.iter().zip(&field.entry_vertex) {
                let truth = exact::unit(&(turn * spoke(vertex, sides)).to_array().map(exact::big));
                let truth = truth.expect("a spoke has a direction");
                let (centre, fan) = (mesh.positions().at(vertex), fan_at(&mesh, vertex));
                let mean = exact::vertex_normal(centre, &fan, Weight::Uniform).expect("a sum of half a turn");
                definition.add(small(&exact::angle(&mean, &truth)).to_degrees());
                let fan: Vec<[Vec3; 2]> = fan.iter().map(|pair| pair.map(|p| p.as_vec3())).collect();
                let plain = plain::vertex_normal(centre.as_vec3(), &fan, Weight::Uniform).as_dvec3();
                outcomes.push([normal, plain].map(|normal| Outcome::degrees(normal, &truth)));
            }
        }
    }
    Measured { definition, ..Measured::pairs(outcomes) }
}

/// The direction from the axis to a vertex before rotation.
fn spoke(vertex: u32, sides: u32) -> DVec3 {
    let angle = TAU * f64::from(vertex / 2) / f64::from(sides);
    DVec3::new(libm::cos(angle), libm::sin(angle), 0.0)
}

/// Radius 1 and height 2, each side cut in two.
fn cylinder(sides: u32, turn: DQuat, store: fn(f64) -> f64) -> Mesh {
    let place = |v: u32| turn * (spoke(v, sides) + 2.0 * f64::from(v % 2) * DVec3::Z);
    let positions: Vec<DVec3> = (0..2 * sides).map(|v| DVec3::from(place(v).to_array().map(store))).collect();
    let side = |i: u32| {
        let [a, b] = [2 * i, (2 * i + 2) % (2 * sides)];
        [a, b, b + 1, a, b + 1, a + 1]
    };
    let faces = Faces::triangles((0..sides).flat_map(side).collect());
    Mesh::new(positions, faces).expect("a good mesh")
}

/// The two other corners of each triangle at a vertex.
fn fan_at(mesh: &Mesh, vertex: u32) -> Vec<[DVec3; 2]> {
    let others = |face: &[u32]| {
        let first = face.iter().position(|&corner| corner == vertex)?;
        Some([1, 2].map(|k| mesh.positions().at(face[(first + k) % 3])))
    };
    mesh.faces().iter().filter_map(others).collect()
}
