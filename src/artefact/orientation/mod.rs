//! The lectures' diamond: turning a polygon changes its colours under the scanline algorithm.

mod polygon;

use super::stage::{differences, linear, map, picture};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters, Role,
    Scale, Setup, Shot, Text, Verdict,
};
use crate::num::Degrees;
use crate::raster::{Image, Interpolation};
use glam::DVec3;
use polygon::{Polygon, sin_cos};

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
        notation: "c(θ) = \\frac{|cos(θ)| (c_1 + c_3)/2 + |sin(θ)| (c_2 + c_4)/2}{|cos(θ)| + |sin(θ)|}",
        says: Text::new(
            "the colour at the centre of the diamond turned by θ",
            "a cor no centro do losango girado de θ",
        ),
    }],
    takes: &[Knob::Size, Knob::Mesh],
    own_mesh: Some(Text::new(
        "its first face of four corners or more",
        "sua primeira face de quatro cantos ou mais",
    )),
    defaults: Parameters { size: 321, ..Parameters::USUAL },
    run,
    frame: Some(frame),
};

/// Turns that are measured: every five degrees.
const TURNS: u32 = 72;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    // An odd number of pixels has one in the middle, whose centre is the polygon's.
    let size = setup.parameters.size | 1;
    let polygon = Polygon::of(setup.mesh.as_ref())?;
    let is_diamond = setup.mesh.is_none();
    let angle = |turn: u32| Degrees(360.0 * f64::from(turn) / f64::from(TURNS));
    let centres = |interpolation| -> Result<Vec<DVec3>, ArtefactError> {
        (0..TURNS).map(|turn| Ok(centre(&polygon.draw(size, angle(turn), interpolation)?))).collect()
    };
    let scanline = centres(Interpolation::Scanline)?;
    let triangles = centres(Interpolation::Affine)?;
    let laws: Vec<DVec3> = (0..TURNS).map(|turn| polygon.scanline(angle(turn))).collect();

    let spread = |colours: &[DVec3]| -> (f64, f64) {
        let far = colours.iter().map(|&colour| (colour - colours[0]).abs().max_element());
        (far.clone().fold(0.0, f64::max), far.sum::<f64>() / colours.len() as f64)
    };
    let off = scanline.iter().zip(&laws).map(|(found, law)| (*found - *law).abs().max_element());
    let off = off.fold(0.0, f64::max);
    let tolerance = tolerance(size);
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
    let cuts = [0, 1].map(|cut| polygon.cut(cut));
    let [first, second] = cuts;
    let (first, second) = (first?, second?);
    let [one, other] = [&first, &second].map(|cut| cut.draw(size, Degrees(0.0), Interpolation::Affine));
    let (one, other) = (one?, other?);
    if is_diamond {
        measures.extend(of_the_diamond(&scanline, &one, &other, tolerance));
    }
    let upright = polygon.draw(size, Degrees(0.0), Interpolation::Scanline)?;
    let turned = polygon.draw(size, Degrees(90.0), Interpolation::Scanline)?;
    let back = turned_back(&turned, Degrees(90.0));
    let half = polygon.draw(size, Degrees(45.0), Interpolation::Scanline)?;
    Ok(Outcome {
        verdict: match most_law > 0.01 {
            true => Verdict::Holds(Text::new(
                "for polygons of four corners and more, whose colours are not those of one plane. Triangles do not depend on \
                 how they are turned, but a polygon's colours then depend on how it is cut into them.",
                "para polígonos de quatro cantos ou mais, cujas cores não são as de um plano. Triângulos não dependem de \
                 como são girados, mas as cores de um polígono passam a depender de como ele é cortado neles.",
            )),
            false => Verdict::Fails(Text::new(
                "the colours of this polygon's corners lie in one plane over it, or almost: interpolation is then linear, \
                 however it is turned.",
                "as cores dos cantos deste polígono estão num plano sobre ele, ou quase: a interpolação é então linear, como \
                 quer que ele seja girado.",
            )),
        },
        moved: Moved {
            name: Text::new(
                "largest change of the centre's colour while it turns",
                "maior mudança da cor do centro durante o giro",
            ),
            unit: "",
            bad: most,
            cure: Text::new("cut into triangles", "cortado em triângulos"),
            cured: of_triangles,
        },
        charts: vec![chart(&scanline, &laws, &triangles)],
        shots: shots([upright, half, turned, back], one, other),
        measures,
        notes: vec![
            Text::new(
                "The algorithm interpolates down the two edges that a scanline cuts, then across between them. Turn the \
                 polygon, and the scanline through its centre cuts other edges at other places.",
                "O algoritmo interpola ao longo das duas arestas que a linha de varredura corta, e depois entre elas. Gire o \
                 polígono, e a linha pelo seu centro corta outras arestas em outros lugares.",
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

/// Corners are moved by up to 1/512 of a pixel each way, over colours that change by up to 0.6 across 0.2 of the picture's side.
fn tolerance(size: u32) -> f64 {
    4.0 * 0.6 / (256.0 * 0.2 * f64::from(size))
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
        (Text::new("diagonal 1–3", "diagonal 1–3 (triângulos)"), centre(one), [0.1, 0.5, 0.5], &diagonal),
        (Text::new("diagonal 2–4", "diagonal 2–4 (triângulos)"), centre(other), [0.2, 0.3, 0.1], &diagonal),
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
    let polygon = Polygon::of(setup.mesh.as_ref())?;
    let angle = Degrees(360.0 * f64::from(number) / f64::from(count));
    polygon.draw(setup.parameters.size | 1, angle, Interpolation::Scanline)
}

/// The colour of the pixel in the middle.
fn centre(image: &Image) -> DVec3 {
    let middle = linear(image)[linear(image).len() / 2];
    DVec3::from(middle.map(f64::from))
}

/// A picture of something turned by an angle, turned back: every pixel is where its centre came from, bilinear between the
/// four pixels about it, and background if one of those is.
fn turned_back(image: &Image, angle: Degrees) -> Image {
    let (sin, cos) = sin_cos(angle);
    let [width, height] = image.size;
    let (mid_x, mid_y) = (f64::from(width - 1) / 2.0, f64::from(height - 1) / 2.0);
    let pixels = linear(image);
    let (mut colours, mut coverage) = (Vec::new(), Vec::new());
    for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
        // Rows run downwards.
        let (right, up) = (f64::from(x) - mid_x, mid_y - f64::from(y));
        let from = [mid_x + cos * right - sin * up, mid_y - (sin * right + cos * up)];
        let corner = from.map(libm::floor);
        let [share_x, share_y] = [from[0] - corner[0], from[1] - corner[1]];
        let mut sum = DVec3::ZERO;
        let mut covered = true;
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let weight = (if dx == 0 { 1.0 - share_x } else { share_x })
                * (if dy == 0 { 1.0 - share_y } else { share_y });
            if weight == 0.0 {
                continue;
            }
            let [column, row] = [corner[0] + f64::from(dx), corner[1] + f64::from(dy)];
            let inside = column >= 0.0 && row >= 0.0;
            let index = inside.then(|| image.index(column as u32, row as u32)).flatten();
            covered &= index.is_some_and(|index| image.coverage[index] > 0);
            if let Some(index) = index {
                sum += DVec3::from(pixels[index].map(f64::from)) * weight;
            }
        }
        let colour = if covered { sum } else { DVec3::from(super::stage::BACKGROUND.to_array()) };
        colours.push(colour.to_array().map(|component| component as f32));
        coverage.push(u8::from(covered));
    }
    picture(image.size, colours, coverage)
}

fn shots([upright, half, turned, back]: [Image; 4], one: Image, other: Image) -> Vec<Shot> {
    let difference = map(upright.size, &differences(&upright, &back), 0.4);
    let between = map(upright.size, &differences(&one, &other), 0.4);
    vec![
        Shot::new(
            "position-1",
            Role::Bad,
            Text::new("scanline, 0°", "linha de varredura, 0°"),
            Text::new(
                "Position 1: the scanline through the centre runs from corner 3 to corner 1.",
                "Posição 1: a linha de varredura pelo centro vai do canto 3 ao canto 1.",
            ),
            upright,
        ),
        Shot::new(
            "turned-45",
            Role::Bad,
            Text::new("scanline, 45°", "linha de varredura, 45°"),
            Text::new(
                "An eighth of a turn: the scanline cuts two edges in their middles, and the centre is the mean of all corners.",
                "Um oitavo de volta: a linha corta duas arestas nos seus meios, e o centro é a média de todos os cantos.",
            ),
            half,
        ),
        Shot::new(
            "position-2",
            Role::Bad,
            Text::new("scanline, 90°", "linha de varredura, 90°"),
            Text::new(
                "Position 2: the scanline runs from corner 2 to corner 4, and the same polygon has other colours.",
                "Posição 2: a linha vai do canto 2 ao canto 4, e o mesmo polígono tem outras cores.",
            ),
            turned,
        ),
        Shot::new(
            "difference",
            Role::Difference,
            Text::new("difference, 90° turned back", "diferença, 90° girado de volta"),
            Text::new(
                "Position 2 turned back, less position 1: dark is none, yellow 0.4 of the full range in a component.",
                "A posição 2 girada de volta, menos a posição 1: escuro é nenhuma, amarelo 0,4 da faixa numa componente.",
            ),
            difference,
        ),
        Shot::new(
            "diagonal-13",
            Role::Cured,
            Text::new("triangles, diagonal 1–3", "triângulos, diagonal 1–3 "),
            Text::new(
                "Cut from corner 1 to corner 3: the same colours however it is turned.",
                "Cortado do canto 1 ao canto 3: as mesmas cores como quer que seja girado.",
            ),
            one,
        ),
        Shot::new(
            "diagonal-24",
            Role::Cured,
            Text::new("triangles, diagonal 2–4", "triângulos, diagonal 2–4 "),
            Text::new(
                "Cut from corner 2 to corner 4: also the same however it is turned, but not the same as the other.",
                "Cortado do canto 2 ao canto 4: também as mesmas como quer que seja girado, mas não as do outro.",
            ),
            other,
        ),
        Shot::new(
            "diagonals",
            Role::Difference,
            Text::new("difference of the diagonals", "diferença das diagonais"),
            Text::new(
                "One diagonal less the other: what the cut decides. Yellow is 0.4 of the full range in a component.",
                "Uma diagonal menos a outra: o que o corte decide. Amarelo é 0,4 da faixa numa componente.",
            ),
            between,
        ),
    ]
}

fn chart(scanline: &[DVec3], laws: &[DVec3], triangles: &[DVec3]) -> Chart {
    let angle = |turn: usize| 360.0 * turn as f64 / scanline.len() as f64;
    let curve = |name, drawn, colours: &[DVec3], axis: usize| Curve {
        name,
        drawn,
        points: colours.iter().enumerate().map(|(turn, colour)| [angle(turn), colour[axis]]).collect(),
    };
    let mut curves = vec![
        curve(Text::new("R, scanline", "R, linha de varredura"), Drawn::Points, scanline, 0),
        curve(Text::new("G, scanline", "G, linha de varredura"), Drawn::Points, scanline, 1),
        curve(Text::new("B, scanline", "B, linha de varredura"), Drawn::Points, scanline, 2),
        curve(Text::new("G, triangles", "G, triângulos"), Drawn::Curve, triangles, 1),
    ];
    curves.extend((0..3).map(|axis| {
        let name = if axis == 0 { Text::new("the law", "a lei") } else { Text::same("") };
        curve(name, Drawn::Guide, laws, axis)
    }));
    Chart {
        name: "centre",
        title: Text::new("Colour of the centre over a whole turn", "Cor do centro numa volta inteira"),
        caption: Text::new(
            "Under the scanline algorithm the centre's colour swings with every quarter turn, as the law says; in triangles \
             it stays.",
            "No algoritmo de linhas de varredura a cor do centro oscila a cada quarto de volta, como diz a lei; em \
             triângulos ela fica.",
        ),
        x: Scale::linear(Text::new("turned by, degrees", "giro, graus")),
        y: Scale::linear(Text::new("linear component", "componente linear")),
        curves,
    }
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
        let diamond = Polygon::of(None).unwrap();
        for (angle, printed) in [
            (0.0, [0.1, 0.5, 0.5]),
            (15.0, [0.121_132, 0.457_735, 0.415_47]),
            (30.0, [0.136_603, 0.426_795, 0.353_59]),
            (45.0, [0.15, 0.4, 0.3]),
            (60.0, [0.163_397, 0.373_205, 0.246_41]),
            (90.0, [0.2, 0.3, 0.1]),
        ] {
            let found = diamond.scanline(Degrees(angle));
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
            (outcome.moved.bad - 0.4).abs() < 0.01 && outcome.moved.factor() > 50.0,
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
        let triangles = builder(Faces::triangles(vec![0, 1, 2])).build().unwrap();
        let error = EXPERIMENT.run(&Setup { mesh: own(&triangles), ..setup(65) }).unwrap_err();
        assert!(error.to_string().contains("four corners"), "{error}");
    }

    #[test]
    fn a_picture_turned_back_a_quarter_is_the_same_pixels() {
        let size = 33;
        let image = Polygon::of(None).unwrap().draw(size, Degrees(0.0), Interpolation::Affine).unwrap();
        let mut back = image.clone();
        for _ in 0..4 {
            back = turned_back(&back, Degrees(90.0));
        }
        assert_eq!((linear(&back), &back.coverage), (linear(&image), &image.coverage));
    }

    #[test]
    fn frames_are_the_turned_pictures() {
        let image = EXPERIMENT.frame(&setup(33), 1, 4).unwrap();
        let expected = Polygon::of(None).unwrap().draw(33, Degrees(90.0), Interpolation::Scanline).unwrap();
        assert_eq!(linear(&image), linear(&expected));
    }
}
