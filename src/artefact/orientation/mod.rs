//! The lectures' diamond: turning a polygon changes its colours under the scanline algorithm.

mod aslant;
mod back;
mod pictures;
mod polygon;

use super::stage::linear;
use super::{
    ArtefactError, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters, Setup, Text, Threshold,
    Verdict,
};
use crate::num::Degrees;
use crate::raster::{Image, Interpolation};
use glam::{DVec2, DVec3};
use polygon::Polygon;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "orientation",
    title: Text::new("Dependence on orientation", "Dependência da orientação"),
    claim: Text::new(
        "Interpolation along scanlines depends on how a polygon is turned: the centre of the diamond of exercise 1.6.25 has \
         the colour (0.1, 0.5, 0.5) in one position and (0.2, 0.3, 0.1) a quarter turn later.",
        "A interpolação por linhas de varredura depende da orientação do polígono: o centro do losango do exercício 1.6.25 \
         tem a cor (0,1; 0,5; 0,5) numa posição e (0,2; 0,3; 0,1) um quarto de volta depois.",
    ),
    sources: &[
        Text::new("Lectures: 1.5.2.1, 1.5.2.3, 1.6.15, 1.6.25", "Aulas: 1.5.2.1, 1.5.2.3, 1.6.15, 1.6.25"),
        Text::new(
            "Ting 2008: “different results for different triangulations”",
            "Ting 2008: “Resultados distintos para diferentes triangulações”",
        ),
    ],
    formulas: &[Formula {
        notation: Text::same(
            "c(θ) = \\frac{|cos(θ)| (c_1 + c_3)/2 + |sin(θ)| (c_2 + c_4)/2}{|cos(θ)| + |sin(θ)|}",
        ),
        says: Text::new(
            "the colour at the centre of the diamond turned by θ; c₁ to c₄ are the colours of its corners, counter-clockwise from the \
             right one, and θ = 0 is position 1",
            "a cor no centro do losango girado de θ; c₁ a c₄ são as cores dos cantos, no sentido anti-horário a partir do direito, e \
             θ = 0 é a posição 1",
        ),
    }],
    takes: &[Knob::Size, Knob::Interpolation, Knob::Mesh],
    own_mesh: Some(Text::new(
        "its first face of four corners or more, with the colours of its vertices if it has them",
        "a sua primeira face de quatro cantos ou mais, com as cores dos seus vértices se as tiver",
    )),
    segments: Parameters::SEGMENTS,
    shown_by: Text::new(
        "a polygon of four corners or more, whose colours do not lie in one plane over it, would show it.",
        "um polígono de quatro cantos ou mais, cujas cores não estão num plano sobre ele, o mostraria.",
    ),
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
    let as_law = || {
        Text::new(
            "the law of the scanline; corners snap to 256ths of pixels",
            "a lei da linha de varredura; os cantos se ajustam a 1/256 de pixel",
        )
    };
    let mut measures = vec![
        Measure::new(
            Text::new("largest distance from the law, over 72 turns", "maior distância da lei, em 72 giros"),
            "",
            off,
        )
        .expect(0.0, tolerance, as_law()),
        Measure::new(
            Text::new("largest change of the centre's colour", "maior mudança da cor do centro"),
            "",
            most,
        )
        .expect(most_law, 2.0 * tolerance, as_law()),
        Measure::new(
            Text::new("mean change of the centre's colour", "mudança média da cor do centro"),
            "",
            mean,
        )
        .expect(mean_law, 2.0 * tolerance, as_law()),
        Measure::new(
            Text::new("largest change, in triangles", "maior mudança, em triângulos"),
            "",
            of_triangles,
        )
        .expect(
            0.0,
            2.0 * tolerance,
            Text::new(
                "barycentric coordinates do not turn; corners snap to 256ths of pixels",
                "coordenadas baricêntricas não giram; os cantos se ajustam a 1/256 de pixel",
            ),
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
        measures.extend(aslant::measures(&polygon, size, tolerance)?);
    }
    let upright = polygon.draw(size, Degrees(0.0), Interpolation::Scanline)?;
    let turned = polygon.draw(size, Degrees(90.0), Interpolation::Scanline)?;
    let back = back::turned_back(&turned, Degrees(90.0));
    let triangles_back =
        back::turned_back(&first.draw(size, Degrees(90.0), Interpolation::Affine)?, Degrees(90.0));
    let half = polygon.draw(size, Degrees(45.0), Interpolation::Scanline)?;
    let moved = Moved {
        name: Text::new(
            "largest change of the centre's colour while it turns",
            "maior mudança da cor do centro durante o giro",
        ),
        unit: "",
        bad: most,
        present: Threshold::HALF_STEP,
        cure: Text::new("cut into triangles", "cortado em triângulos"),
        cured: of_triangles,
        factor: 50.0,
    };
    Ok(Outcome {
        verdict: Verdict::Holds(Text::new(
            "for polygons of four corners and more, whose colours are not those of one plane. Triangles do not depend on \
             how they are turned, but a polygon's colours then depend on how it is cut into them.",
            "para polígonos de quatro cantos ou mais, cujas cores não são as de um plano. Triângulos não dependem de \
             como são girados, mas as cores de um polígono passam a depender de como ele é cortado neles.",
        )),
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
            Text::new(
                "Seen from in front all triangles are alike. Aslant their colours have to be mixed by 1/depth (perspective): mixed by \
                 distances in the picture they change with the turn, too, by less than scanlines' do.",
                "Vistos de frente todos os triângulos são iguais. Em vista oblíqua as suas cores têm de ser misturadas por 1/profundidade \
                 (perspectiva): misturadas por distâncias na imagem também mudam com o giro, menos que as da linha de varredura.",
            ),
            Text::new(
                "The algorithm interpolates down the two edges that a scanline cuts, then across between them. Turn the \
                 polygon, and the scanline through its centre cuts other edges at other places.",
                "O algoritmo interpola ao longo das duas arestas que a linha de varredura corta, e depois entre elas. Gire o \
                 polígono, e a linha pelo seu centro corta outras arestas em outros lugares.",
            ),
            Text::new(
                "The animation (--animate) shows the turn; --interpolation affine or perspective shows it in triangles, where nothing \
                 changes but the place.",
                "A animação (--animate) mostra o giro; --interpolation affine ou perspective o mostra em triângulos, onde nada muda \
                 senão o lugar.",
            ),
            Text::new(
                "Triangles cure that: three corners determine a plane of colours. The price is the choice of the diagonal: \
                 the diamond's centre has the mean of the corners that the diagonal joins.",
                "Triângulos curam isso: três cantos determinam um plano de cores. O preço é a escolha da diagonal: o centro \
                 do losango tem a média dos cantos que a diagonal liga.",
            ),
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
    let why = Text::new(
        "this polygon has edges shorter than a pixel, which scanlines may pass over",
        "este polígono tem arestas menores que um pixel, que as linhas de varredura podem saltar",
    );
    measures.into_iter().map(|measure| Measure { expected: None, ..measure }.beyond(why.clone())).collect()
}

/// The answers of exercise 1.6.25, and the centre in triangles.
fn of_the_diamond(scanline: &[DVec3], one: &Image, other: &Image, tolerance: f64) -> Vec<Measure> {
    let exercise = Text::new("exercise 1.6.25 b, answer C", "exercício 1.6.25 b, resposta C");
    let diagonal = Text::new(
        "the mean of the corners that the diagonal joins",
        "a média dos cantos que a diagonal liga",
    );
    let quarter = scanline.len() / 4;
    let cases = [
        (Text::new("position 1", "posição 1"), scanline[0], [0.1, 0.5, 0.5], &exercise),
        (Text::new("position 2", "posição 2"), scanline[quarter], [0.2, 0.3, 0.1], &exercise),
        (
            Text::new("diagonal 1–3 (triangles)", "diagonal 1–3 (triângulos)"),
            centre(one),
            [0.1, 0.5, 0.5],
            &diagonal,
        ),
        (
            Text::new("diagonal 2–4 (triangles)", "diagonal 2–4 (triângulos)"),
            centre(other),
            [0.2, 0.3, 0.1],
            &diagonal,
        ),
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
    fn a_second_cut_is_told_only_where_there_is_one() {
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
