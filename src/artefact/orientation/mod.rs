//! The lectures' diamond: turning a polygon changes its colours under the scanline algorithm.

mod back;
mod oblique;
mod pictures;
mod polygon;
mod texts;

use super::stage::linear;
use super::{
    ArtefactError, Experiment, Knob, Measure, Moved, Outcome, Parameters, Setup, Text, Threshold, Verdict,
};
use crate::num::Degrees;
use crate::raster::{Image, Interpolation};
use glam::{DVec2, DVec3};
use polygon::Polygon;
use texts::TEXTS;

pub(super) static EXPERIMENT: Experiment = Experiment {
    id: "orientation",
    texts: &TEXTS,
    takes: &[Knob::Size, Knob::Interpolation, Knob::Mesh],
    segments: Parameters::SEGMENTS,
    defaults: Parameters { size: 321, interpolation: Interpolation::Scanline, ..Parameters::USUAL },
    run,
    frame: Some(frame),
};

/// Turns that are measured: every five degrees.
const TURNS: u32 = 72;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    // An odd number of pixels has one in the middle, whose centre is the polygon's.
    let size = setup.parameters.size | 1;
    let polygon = Polygon::of(setup.mesh.as_ref(), size)?;
    let is_diamond = setup.mesh.is_none();
    let angle = |turn: u32| Degrees(360.0 * f64::from(turn) / f64::from(TURNS));
    let centres = |interpolation| -> Result<Vec<DVec3>, ArtefactError> {
        (0..TURNS).map(|turn| Ok(centre(&polygon.draw(size, angle(turn), interpolation)?))).collect()
    };
    let scanline = centres(Interpolation::Scanline)?;
    let triangles = centres(Interpolation::Affine)?;
    let tolerance = tolerance(&polygon, size);
    // Where the law jumps it is that of either side: not asked.
    let law = |(turn, &found): (u32, &DVec3)| match polygon.jumps(DVec2::ZERO, angle(turn), size, tolerance) {
        true => found,
        false => polygon.scanline(DVec2::ZERO, angle(turn)),
    };
    let laws: Vec<DVec3> = (0..).zip(&scanline).map(law).collect();

    let spread = |colours: &[DVec3]| -> (f64, f64) {
        let far = colours.iter().map(|&colour| (colour - colours[0]).abs().max_element());
        (far.clone().fold(0.0, f64::max), far.sum::<f64>() / colours.len() as f64)
    };
    let off = scanline.iter().zip(&laws).map(|(found, law)| (*found - *law).abs().max_element());
    let off = off.fold(0.0, f64::max);
    let (most, mean) = spread(&scanline);
    let (most_law, mean_law) = spread(&laws);
    let (of_triangles, _) = spread(&triangles);
    let as_law = || TEXTS.get("law-scanline-corners");
    let mut measures = vec![
        Measure::new(TEXTS.get("measure-largest-distance-law"), "", off).expect(0.0, tolerance, as_law()),
        Measure::new(TEXTS.get("measure-largest-change-centre"), "", most).expect(
            most_law,
            2.0 * tolerance,
            as_law(),
        ),
        Measure::new(TEXTS.get("measure-mean-change-centre"), "", mean).expect(
            mean_law,
            2.0 * tolerance,
            as_law(),
        ),
        Measure::new(TEXTS.get("measure-largest-change-triangles"), "", of_triangles).expect(
            0.0,
            2.0 * tolerance,
            TEXTS.get("by-barycentric-coordinates-do"),
        ),
    ];
    measures.extend(back::measures(&polygon, size, tolerance)?);
    let mut measures = held(measures, &polygon, size);
    let cuts = [false, true].map(|other_way| polygon.cut(other_way));
    let [first, second] = cuts;
    let (first, second) = (first?, second?);
    let [one, other] = [&first, &second].map(|cut| cut.draw(size, Degrees(0.0), Interpolation::Affine));
    let (one, other) = (one?, other?);
    if is_diamond {
        measures.extend(of_the_diamond(&scanline, &one, &other, tolerance));
        measures.extend(oblique::measures(&polygon, size, tolerance)?);
    }
    let upright = polygon.draw(size, Degrees(0.0), Interpolation::Scanline)?;
    let turned = polygon.draw(size, Degrees(90.0), Interpolation::Scanline)?;
    let back = back::turned_back(&turned, Degrees(90.0));
    let triangles_back =
        back::turned_back(&first.draw(size, Degrees(90.0), Interpolation::Affine)?, Degrees(90.0));
    let half = polygon.draw(size, Degrees(45.0), Interpolation::Scanline)?;
    let moved = Moved {
        name: TEXTS.get("moved"),
        unit: "",
        bad: most,
        present: Threshold::HALF_STEP,
        cure: TEXTS.get("cure"),
        cured: of_triangles,
        factor: 50.0,
    };
    Ok(Outcome {
        verdict: Verdict::Holds(TEXTS.get("holds-polygons-four-corners")),
        charts: vec![pictures::chart(&scanline, &laws, &triangles, &moved)],
        shots: pictures::shots(
            [upright, half, turned, back],
            &triangles_back,
            [one, other],
            first.is_cut_as(&second),
            is_diamond,
            &moved,
        ),
        moved,
        measures,
        notes: vec![
            TEXTS.get("note-seen-front-all"),
            TEXTS.get("note-algorithm-interpolates-down"),
            TEXTS.get("note-animation-animate-shows"),
            TEXTS.get("note-triangles-cure-three"),
        ],
    })
}

/// Corners are moved by up to 1/512 of a pixel each way, over colours that change along edges; and from one edge of a narrow corner
/// to the next within a fifth of the picture's side. Colours themselves are of single precision: a few roundings of them.
fn tolerance(polygon: &Polygon, size: u32) -> f64 {
    let [change, shortest] = polygon.steepest(size);
    let snapped = 4.0 * change / (256.0 * shortest.min(0.2 * f64::from(size)));
    snapped + 4.0 * f64::from(f32::EPSILON) * polygon.brightest()
}

/// Numbers that the law does not cover: edges shorter than a pixel are passed over by scanlines.
fn held(measures: Vec<Measure>, polygon: &Polygon, size: u32) -> Vec<Measure> {
    let [_, shortest] = polygon.steepest(size);
    if shortest >= 1.0 {
        return measures;
    }
    let why = TEXTS.get("polygon-edges-shorter");
    measures.into_iter().map(|measure| Measure { expected: None, ..measure }.beyond(why.clone())).collect()
}

/// The answers of exercise 1.6.25, and the centre in triangles.
fn of_the_diamond(scanline: &[DVec3], one: &Image, other: &Image, tolerance: f64) -> Vec<Measure> {
    let exercise = TEXTS.get("exercise-b-answer");
    let diagonal = TEXTS.get("mean-corners-diagonal");
    let quarter = scanline.len() / 4;
    let cases = [
        (TEXTS.get("position"), scanline[0], [0.1, 0.5, 0.5], &exercise),
        (TEXTS.get("position-v2"), scanline[quarter], [0.2, 0.3, 0.1], &exercise),
        (TEXTS.get("diagonal-triangles"), centre(one), [0.1, 0.5, 0.5], &diagonal),
        (TEXTS.get("diagonal-triangles-v2"), centre(other), [0.2, 0.3, 0.1], &diagonal),
    ];
    let components = |(name, found, law, by): (Text, DVec3, [f64; 3], &Text)| {
        use super::Language::{English, Portuguese};
        let component = |axis: usize| {
            let letter = ["R", "G", "B"][axis];
            let name = Text::made(
                format!("{}: {letter} at the centre", name.get(English)),
                format!("{}: {letter} no centro", name.get(Portuguese)),
            );
            Measure::new(name, "", found[axis]).expect(law[axis], tolerance, by.clone())
        };
        [0, 1, 2].map(component)
    };
    cases.into_iter().flat_map(components).collect()
}

fn frame(setup: &Setup, number: u32, count: u32) -> Result<Image, ArtefactError> {
    let size = setup.parameters.size | 1;
    let polygon = Polygon::of(setup.mesh.as_ref(), size)?;
    let angle = Degrees(360.0 * f64::from(number) / f64::from(count));
    polygon.draw(size, angle, setup.parameters.interpolation)
}

/// The colour of the pixel in the middle.
fn centre(image: &Image) -> DVec3 {
    let middle = linear(image)[linear(image).len() / 2];
    DVec3::from(middle.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::UserMesh;
    use crate::mesh::{Faces, MeshBuilder};

    fn setup(size: u32) -> Setup<'static> {
        Setup { parameters: Parameters { size, ..EXPERIMENT.defaults }, mesh: None }
    }

    /// c(θ) of the diamond at angles that were computed apart from this program.
    #[test]
    fn the_law_has_its_printed_values() {
        let diamond = Polygon::of(None, 33).unwrap();
        for (angle, printed) in [
            (0.0, [0.1, 0.5, 0.5]),
            (15.0, [0.121_132, 0.457_735, 0.415_47]),
            (30.0, [0.136_603, 0.426_795, 0.353_59]),
            (45.0, [0.15, 0.4, 0.3]),
            (60.0, [0.163_397, 0.373_205, 0.246_41]),
            (90.0, [0.2, 0.3, 0.1]),
        ] {
            let found = diamond.scanline(DVec2::ZERO, Degrees(angle));
            assert!((found - DVec3::from(printed)).abs().max_element() < 6e-7, "{angle}: {found}");
        }
    }

    #[test]
    fn the_artefact_is_there_and_is_cured() {
        let outcome = EXPERIMENT.run(&setup(65)).unwrap();
        for measure in &outcome.measures {
            assert_eq!(measure.agrees(), Some(true), "{measure:?}");
        }
        // 0.4 in blue between the two positions; what triangles leave is the snapping of corners.
        assert!(
            (outcome.moved.bad - 0.4).abs() < 0.01 && outcome.moved.reduction() > 50.0,
            "{:?}",
            outcome.moved
        );
        let by_name = |name| outcome.shots.iter().find(|shot| shot.name == name).unwrap();
        assert!(linear(&by_name("position-1").image) != linear(&by_name("position-2").image));
    }

    #[test]
    fn a_square_of_a_users_mesh_is_turned_too() {
        let positions = [[5.0, 1.0, 1.0], [5.0, 4.0, 1.0], [5.0, 4.0, 3.0], [5.0, 1.0, 3.0]];
        let builder = |faces| MeshBuilder {
            positions: positions.map(DVec3::from).to_vec(),
            faces,
            ..MeshBuilder::default()
        };
        let mesh = builder(Faces::polygons(vec![0, 1, 2, 3], vec![0, 4])).build().unwrap();
        let own = |mesh| Some(UserMesh { name: "square.obj", mesh, finer: None });
        let outcome = EXPERIMENT.run(&Setup { mesh: own(&mesh), ..setup(65) }).unwrap();
        assert!(
            outcome.measures.iter().all(|measure| measure.agrees() == Some(true)),
            "{:?}",
            outcome.measures
        );
        assert!(outcome.moved.bad > 0.1, "{:?}", outcome.moved);
    }

    /// Letters with notches, whose mean lies outside or whose edges lie on scanlines: cut within themselves, and right.
    #[test]
    fn concave_polygons_are_cut_within_themselves() {
        let ell = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]];
        let tee = vec![
            [0.0, 0.0],
            [3.0, 0.0],
            [3.0, 1.0],
            [2.0, 1.0],
            [2.0, 2.0],
            [1.0, 2.0],
            [1.0, 1.0],
            [0.0, 1.0],
        ];
        for corners in [ell, tee] {
            let count = corners.len() as u32;
            let builder = MeshBuilder {
                positions: corners.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)).collect(),
                faces: Faces::polygons((0..count).collect(), vec![0, count]),
                ..MeshBuilder::default()
            };
            let own = Some(UserMesh { name: "letter.obj", mesh: &builder.build().unwrap(), finer: None });
            let outcome = EXPERIMENT.run(&Setup { mesh: own, ..setup(65) }).unwrap();
            for measure in &outcome.measures {
                assert_ne!(measure.agrees(), Some(false), "{measure:?}");
            }
            let shot = |name| &outcome.shots.iter().find(|shot| shot.name == name).unwrap().image;
            let [whole, one, other] = ["position-1", "diagonal-13", "diagonal-24"].map(shot);
            assert_eq!((&one.coverage, &other.coverage), (&whole.coverage, &whole.coverage));
            assert!(linear(one) != linear(other), "both cuts are the same");
        }
    }

    /// A triangle does not depend on its turn, and a polygon bent round its own middle is turned about a place within.
    #[test]
    fn any_polygon_will_do() {
        let run = |points: &[[f64; 2]]| {
            let count = points.len() as u32;
            let builder = MeshBuilder {
                positions: points.iter().map(|&[x, y]| DVec3::new(x, y, 7.0)).collect(),
                faces: Faces::polygons((0..count).collect(), vec![0, count]),
                ..MeshBuilder::default()
            };
            let mesh = builder.build().unwrap();
            let own = Some(UserMesh { name: "own.obj", mesh: &mesh, finer: None });
            let outcome = EXPERIMENT.run(&Setup { mesh: own, ..setup(65) }).unwrap();
            for measure in &outcome.measures {
                assert_eq!(measure.agrees(), Some(true), "{points:?}: {measure:?}");
            }
            outcome
        };
        let triangle = run(&[[0.0, 0.0], [3.0, 0.0], [0.0, 2.0]]);
        assert!(matches!(triangle.verdict, Verdict::Absent(_)), "{:?}", triangle.moved);
        let bent =
            [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [3.0, 3.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]];
        assert!(matches!(run(&bent).verdict, Verdict::Holds(_)));
    }

    #[test]
    fn frames_are_the_turned_pictures() {
        let image = EXPERIMENT.frame(&setup(33), 1, 4).unwrap();
        let expected =
            Polygon::of(None, 33).unwrap().draw(33, Degrees(90.0), Interpolation::Scanline).unwrap();
        assert_eq!(linear(&image), linear(&expected));
        let mut setup = setup(33);
        setup.parameters.interpolation = Interpolation::Affine;
        assert_ne!(linear(&EXPERIMENT.frame(&setup, 1, 4).unwrap()), linear(&expected));
    }

    /// A dart has one diagonal inside, a convex quadrilateral two.
    #[test]
    fn a_second_cut_is_reported_only_where_there_is_one() {
        for (notch, has_one_cut) in [([0.5, 0.5, 0.0], true), ([3.0, 3.0, 0.0], false)] {
            let positions = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], notch, [0.0, 4.0, 0.0]];
            let builder = MeshBuilder {
                positions: positions.map(DVec3::from).to_vec(),
                faces: Faces::polygons((0..4).collect(), vec![0, 4]),
                ..MeshBuilder::default()
            };
            let mesh = builder.build().unwrap();
            let mesh = Some(UserMesh { name: "dart", mesh: &mesh, finer: None });
            let outcome = EXPERIMENT.run(&Setup { mesh, ..setup(65) }).unwrap();
            let second = outcome.shots.iter().find(|shot| shot.name == "diagonal-24").unwrap();
            let caption = second.caption.get(crate::artefact::Language::English);
            assert_eq!(caption.starts_with("No other cut"), has_one_cut, "{caption}");
            assert_eq!(caption.starts_with("Cut another way"), !has_one_cut, "{caption}");
            // Of one cut only there is no difference to show.
            assert_eq!(outcome.shots.iter().any(|shot| shot.name == "diagonals"), !has_one_cut);
            for shot in &outcome.shots {
                use crate::artefact::Language;
                let [en, pt] = Language::ALL.map(|language| shot.caption.get(language).to_lowercase());
                assert!(!en.contains("position") && !en.contains("diagonal"), "{en}");
                assert!(!pt.contains("posição") && !pt.contains("diagonal"), "{pt}");
            }
        }
    }
}
