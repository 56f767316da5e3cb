//! The lectures' diamond: rotating a polygon changes its colours under the scanline algorithm.

// A rotated polygon, and the law of its scanline.
mod polygon;
// Pictures of the polygon in its positions, under scanlines and in triangles, and of the rotated one rotated back.
mod pictures;

use super::prelude::*;
use pictures::Pictures;
use polygon::Polygon;

static TEXTS: Catalogue = catalogue!("texts");

pub(super) static EXPERIMENT: Experiment = Experiment {
    takes: &[ParameterName::Size, ParameterName::Turn, ParameterName::Interpolation, ParameterName::Mesh],
    defaults: Parameters { size: 321, interpolation: Interpolation::Scanline, ..Parameters::USUAL },
    frame: Some(frame),
    ..Experiment::new("orientation", &TEXTS, run)
};

/// The number of rotations that are measured: one every five degrees.
const TURNS: u32 = 72;

fn run(setup: &Setup) -> Result<Outcome> {
    // An odd number of pixels has one in the middle, whose centre is the polygon's.
    let size = setup.parameters.size | 1;
    let polygon = Polygon::of(setup.mesh.as_ref(), size)?;
    let is_diamond = setup.mesh.is_none();
    let shape = if is_diamond { "diamond" } else { "polygon" };
    let turn = setup.parameters.turn;
    let mut out = Recorder::new(
        &TEXTS,
        &[("shape", shape.into()), ("full", pictures::FULL.into()), ("turn", turn.0.into())],
    );
    let pictures = Pictures::draw(&polygon, size, turn)?;
    measure_turned(&polygon, size, turn, &pictures, &mut out)?;
    let colours = CentreColours::measure(&polygon, size, &mut out)?;
    pictures::measure(&polygon, size, &mut out)?;
    if is_diamond {
        let (tolerance, [one, other]) = (polygon.tolerance(size), &pictures.cuts);
        measure_diamond(&colours.scanline, [one, other], tolerance, &mut out);
        measure_oblique(&polygon, size, tolerance, &mut out)?;
    }
    let numbers = [largest_change(&colours.scanline), largest_change(&colours.triangles)];
    let effect = out.effect("centre", "", numbers, Threshold::half_step(), 50.0);
    out.set("bad", effect.bad);
    out.set("cured", effect.cured);
    colours.chart(&mut out);
    pictures.show(&effect, &mut out);
    Ok(out.finish(Verdict::Holds(out.text("holds")), effect))
}

struct CentreColours {
    scanline: Vec<DVec3>,
    laws: Vec<DVec3>,
    triangles: Vec<DVec3>,
}

impl CentreColours {
    fn measure(polygon: &Polygon, size: u32, out: &mut Recorder) -> Result<Self> {
        let angle = |turn: u32| Degrees(360.0 * f64::from(turn) / f64::from(TURNS));
        let centres = |interpolation| -> Result<Vec<DVec3>> {
            (0..TURNS).map(|turn| Ok(centre(&polygon.draw(size, angle(turn), interpolation)?))).collect()
        };
        let scanline = centres(Interpolation::Scanline)?;
        let triangles = centres(Interpolation::Affine)?;
        let tolerance = polygon.tolerance(size);
        // Where the law has a jump, either side is right: not compared.
        let law =
            |(turn, &found): (u32, &DVec3)| match polygon.jumps(DVec2::ZERO, angle(turn), size, tolerance) {
                true => found,
                false => polygon.scanline(DVec2::ZERO, angle(turn)),
            };
        let laws: Vec<DVec3> = (0..).zip(&scanline).map(law).collect();
        let off = scanline.iter().zip(&laws).map(|(found, law)| (*found - *law).abs().max_element());
        out.measure("law", "", off.fold(0.0, f64::max), polygon.check(size, 0.0, tolerance));
        let check = |law| polygon.check(size, law, 2.0 * tolerance);
        out.measure("largest-change", "", largest_change(&scanline), check(largest_change(&laws)));
        out.measure("mean-change", "", mean_change(&scanline), check(mean_change(&laws)));
        out.measure("triangles-change", "", largest_change(&triangles), check(0.0));
        Ok(Self { scanline, laws, triangles })
    }

    fn chart(&self, out: &mut Recorder) {
        let curve = |name, drawn, colours: &[DVec3], axis: usize| {
            let angle = |turn: usize| 360.0 * turn as f64 / colours.len() as f64;
            let points = colours.iter().enumerate().map(|(turn, colour)| [angle(turn), colour[axis]]);
            out.curve(name, drawn, points.collect())
        };
        let curves = vec![
            curve("r-scanline", Drawn::Points, &self.scanline, 0),
            curve("g-scanline", Drawn::Points, &self.scanline, 1),
            curve("b-scanline", Drawn::Points, &self.scanline, 2),
            curve("g-triangles", Drawn::Curve, &self.triangles, 1),
            curve("r-law", Drawn::Guide, &self.laws, 0),
            curve("g-law", Drawn::Guide, &self.laws, 1),
            curve("b-law", Drawn::Guide, &self.laws, 2),
        ];
        out.chart("centre", [Axis::Linear; 2], curves);
    }
}

/// How far a rotation changes the colour at the centre, under scanlines and in triangles.
fn measure_turned(
    polygon: &Polygon,
    size: u32,
    turn: Degrees,
    pictures: &Pictures,
    out: &mut Recorder,
) -> Result<()> {
    let change = |[one, other]: [DVec3; 2]| (one - other).abs().max_element();
    let tolerance = polygon.tolerance(size);
    let turns = [Degrees(0.0), turn];
    let jumps = turns.iter().any(|&turn| polygon.jumps(DVec2::ZERO, turn, size, tolerance));
    let check = match jumps {
        true => Check::None,
        false => polygon.check(
            size,
            change(turns.map(|turn| polygon.scanline(DVec2::ZERO, turn))),
            2.0 * tolerance,
        ),
    };
    let found = change([&pictures.upright, &pictures.turned].map(centre));
    out.measure("turned-scanline", "", found, check);
    let [upright, turned] = turns.map(|turn| polygon.draw(size, turn, Interpolation::Affine));
    let found = change([centre(&upright?), centre(&turned?)]);
    out.measure("turned-triangles", "", found, polygon.check(size, 0.0, 2.0 * tolerance));
    Ok(())
}

/// How far colours are from the first, in the component that changes most.
fn changes(colours: &[DVec3]) -> impl Iterator<Item = f64> {
    colours.iter().map(|&colour| (colour - colours[0]).abs().max_element())
}

fn largest_change(colours: &[DVec3]) -> f64 {
    changes(colours).fold(0.0, f64::max)
}

fn mean_change(colours: &[DVec3]) -> f64 {
    changes(colours).sum::<f64>() / colours.len() as f64
}

/// The answers of exercise 1.6.25, and the centre in triangles.
fn measure_diamond(scanline: &[DVec3], [one, other]: [&Image; 2], tolerance: f64, out: &mut Recorder) {
    let quarter = scanline.len() / 4;
    for (name, title, found, law) in [
        ("exercise", "position-1", scanline[0], [0.1, 0.5, 0.5]),
        ("exercise", "position-2", scanline[quarter], [0.2, 0.3, 0.1]),
        ("diagonal", "diagonal-13-cut", centre(one), [0.1, 0.5, 0.5]),
        ("diagonal", "diagonal-24-cut", centre(other), [0.2, 0.3, 0.1]),
    ] {
        out.set("case", out.text(title));
        for (axis, letter) in ["R", "G", "B"].into_iter().enumerate() {
            out.set("component", letter);
            out.measure(name, "", found[axis], Check::Near(law[axis], tolerance));
        }
    }
}

fn frame(setup: &Setup, number: u32, count: u32) -> Result<Image> {
    let size = setup.parameters.size | 1;
    let polygon = Polygon::of(setup.mesh.as_ref(), size)?;
    let angle = Degrees(360.0 * f64::from(number) / f64::from(count));
    polygon.draw(size, angle, setup.parameters.interpolation)
}

/// How far the eye is from the middle, over the distance of a corner from it.
const EYE: f64 = 2.0;

/// By how much the right side is turned away from the viewer, about the upright axis.
const AWAY: Degrees = Degrees(60.0);

/// The shortest edge has three quarters of its frontal length: snapped corners move its colours by so many times as much.
const FORESHORTENED: f64 = 4.0 / 3.0;

fn camera() -> Camera {
    // The window of the frontal pictures, at the middle.
    let angle = Radians(2.0 * libm::atan(0.5 * Polygon::WINDOW / EYE));
    let projection = Projection::Perspective(angle);
    Camera { eye: DVec3::Z * EYE, target: DVec3::ZERO, up: DVec3::Y, projection, near: 0.1 }
}

/// By how much the colour at the centre changes by a quarter turn in the diamond's own plane.
fn change(diamond: &Polygon, size: u32, interpolation: Interpolation) -> Result<f64> {
    let oblique = DMat4::from_rotation_y(Radians::from(AWAY).0);
    let colour = |turn: f64| -> Result<DVec3> {
        Ok(centre(&diamond.draw_from(camera(), oblique, size, Degrees(turn), interpolation)?))
    };
    Ok((colour(90.0)? - colour(0.0)?).abs().max_element())
}

/// The change under scanlines, in triangles, and in triangles by perspective, against the law: the middle of a line with ends at
/// depths d ± s mixes their colours in parts of (d ∓ s)/2d. That is the line from corner 3 to corner 1; in the other position
/// scanlines run from corner 2 to corner 4, and the triangles' upright edge has one depth.
fn measure_oblique(diamond: &Polygon, size: u32, tolerance: f64, out: &mut Recorder) -> Result<()> {
    let triangles = diamond.cut(false)?;
    let [c1, c2, c3, c4] = Polygon::LECTURES.map(DVec3::from);
    let lean = libm::sin(Radians::from(AWAY).0) / EYE;
    // The left end is nearer, and so larger: the middle of the picture's line is beyond the middle of the edge.
    let mixed = |left: DVec3, right: DVec3| 0.5 * (left * (1.0 - lean) + right * (1.0 + lean));
    let largest = |a: DVec3, b: DVec3| (a - b).abs().max_element();
    let upright = mixed(c3, c1);
    for (name, polygon, interpolation, law) in [
        ("oblique-scanline", diamond, Interpolation::Scanline, largest(mixed(c2, c4), upright)),
        ("oblique-triangles", &triangles, Interpolation::Affine, largest(0.5 * (c1 + c3), upright)),
        ("oblique-perspective", &triangles, Interpolation::Perspective, 0.0),
    ] {
        let found = change(polygon, size, interpolation)?;
        out.measure(name, "", found, Check::Near(law, 2.0 * FORESHORTENED * tolerance));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::drawing::linear;
    use super::*;
    use crate::artefact::UserMesh;
    use crate::mesh::{Faces, MeshBuilder};

    fn setup(size: u32) -> Setup<'static> {
        Setup { parameters: Parameters { size, ..EXPERIMENT.defaults }, mesh: None }
    }

    /// c(θ) of the diamond at angles that were computed outside this program.
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
            assert_eq!(measure.agrees, Some(true), "{measure:?}");
        }
        // 0.4 in blue between the two positions; the rest in triangles is the snapping of corners.
        assert!(
            (outcome.effect.bad - 0.4).abs() < 0.01 && outcome.effect.reduction() > 50.0,
            "{:?}",
            outcome.effect
        );
        let by_name = |name| outcome.shots.iter().find(|shot| shot.name == name).unwrap();
        assert!(linear(&by_name("position-1").image) != linear(&by_name("position-2").image));
    }

    #[test]
    fn a_square_of_a_users_mesh_is_turned_too() {
        let positions = [[5.0, 1.0, 1.0], [5.0, 4.0, 1.0], [5.0, 4.0, 3.0], [5.0, 1.0, 3.0]];
        let builder = |faces| MeshBuilder {
            positions: positions.map(DVec3::from).to_vec().into(),
            faces,
            ..MeshBuilder::default()
        };
        let mesh = builder(Faces::polygons(vec![0, 1, 2, 3], vec![0, 4])).build().unwrap();
        let own = |mesh| Some(UserMesh { name: "square.obj", mesh, finer: None });
        let outcome = EXPERIMENT.run(&Setup { mesh: own(&mesh), ..setup(65) }).unwrap();
        assert!(
            outcome.measures.iter().all(|measure| measure.agrees == Some(true)),
            "{:?}",
            outcome.measures
        );
        assert!(outcome.effect.bad > 0.1, "{:?}", outcome.effect);
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
                assert_ne!(measure.agrees, Some(false), "{measure:?}");
            }
            let shot = |name| &outcome.shots.iter().find(|shot| shot.name == name).unwrap().image;
            let [whole, one, other] = ["position-1", "diagonal-13", "diagonal-24"].map(shot);
            assert_eq!((&one.coverage, &other.coverage), (&whole.coverage, &whole.coverage));
            assert!(linear(one) != linear(other), "both cuts are the same");
        }
    }

    /// A triangle keeps its colours when it rotates. A concave polygon rotates about a point within it.
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
                assert_eq!(measure.agrees, Some(true), "{points:?}: {measure:?}");
            }
            outcome
        };
        let triangle = run(&[[0.0, 0.0], [3.0, 0.0], [0.0, 2.0]]);
        assert!(matches!(triangle.verdict, Verdict::Absent(_)), "{:?}", triangle.effect);
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
                positions: positions.map(DVec3::from).to_vec().into(),
                faces: Faces::polygons((0..4).collect(), vec![0, 4]),
                ..MeshBuilder::default()
            };
            let mesh = builder.build().unwrap();
            let mesh = Some(UserMesh { name: "dart", mesh: &mesh, finer: None });
            let outcome = EXPERIMENT.run(&Setup { mesh, ..setup(65) }).unwrap();
            let second = outcome.shots.iter().find(|shot| shot.name == "diagonal-24").unwrap();
            let caption = second.caption.get(crate::artefact::Language::English);
            assert_eq!(caption.starts_with("No other triangulation"), has_one_cut, "{caption}");
            assert_eq!(caption.starts_with("Another triangulation"), !has_one_cut, "{caption}");
            // With a single cut there is no difference to show.
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
