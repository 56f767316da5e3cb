//! One polygon, cut in two ways.

use super::body::{Body, Diagonal};
use super::stage::{BACKGROUND, chalk, differences, draw, front, light_at, linear, map, picture, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters,
    Scale, Setup, Shot, Text, Threshold, Verdict,
};
use crate::metric::image_error;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, Paint, Shading};
use glam::DVec3;
use std::borrow::Cow;
use std::f64::consts::TAU;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "triangulation",
    title: Text::new("Different diagonals", "Diagonais diferentes"),
    claim: Text::new(
        "Linear interpolation gives different results for different triangulations of the same polygon.",
        "A interpolação linear dá resultados distintos para diferentes triangulações do mesmo polígono.",
    ),
    sources: &[
        Text::new(
            "Ting 2008: “resultados distintos para diferentes triangulações” (different results for different triangulations)",
            "Ting 2008: “resultados distintos para diferentes triangulações”",
        ),
        Text::new(
            "Lectures: exercise 1.6.25, whose diamond is used",
            "Aulas: exercício 1.6.25, cujo losango é usado",
        ),
    ],
    formulas: &[
        Formula {
            notation: Text::same("c_{13} = \\frac{c_1 + c_3}{2}, \\quad c_{24} = \\frac{c_2 + c_4}{2}"),
            says: Text::new(
                "the colour in the middle of the diamond, cut from corner 1 (right) to 3 (left) or from 2 (above) to 4 (below)",
                "a cor no meio do losango, cortado do canto 1 (direito) ao 3 (esquerdo) ou do 2 (acima) ao 4 (abaixo)",
            ),
        },
        Formula {
            notation: Text::same("c = \\frac{c_1 + c_2 + c_3 + c_4}{4}"),
            says: Text::new(
                "with a vertex of the mean colour in the middle, whichever way it is cut",
                "com um vértice da cor média no meio, seja como for cortado",
            ),
        },
        Formula {
            notation: Text::same("|ΔI| = O(h^2)"),
            says: Text::new(
                "on a smooth surface the two diagonals of a square of side h differ in the middle by h²/2 times the mixed second \
                 derivative, and less elsewhere",
                "numa superfície lisa as duas diagonais de um quadrado de lado h diferem no meio por h²/2 vezes a derivada segunda \
                 mista, e menos no resto",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    own_mesh: None,
    // More, and four times as many in the cured picture, would be hardly larger than pixels.
    segments: 3..=256,
    shown_by: Text::new(
        "fewer squares (--segments), and light from the side, would show it on the waves; the diamond shows it in any light.",
        "menos quadrados (--segments), e luz de lado, o mostrariam nas ondas; o losango o mostra sob qualquer luz.",
    ),
    defaults: Parameters { segments: 12, light: Degrees(50.0), ..Parameters::USUAL },
    run,
    frame: None,
};

/// The corners' colours, from the right one counter-clockwise as the exercise counts them.
const CORNERS: [LinearRgb; 4] = [
    LinearRgb::new(0.0, 0.4, 0.4),
    LinearRgb::new(0.0, 0.2, 0.2),
    LinearRgb::new(0.2, 0.6, 0.6),
    LinearRgb::new(0.4, 0.4, 0.0),
];
/// How many times more squares the cured surface has along a side.
const FINER: u32 = 4;
/// The window's side; bodies are 2 wide.
const WINDOW: f64 = 2.2;
/// Height of the waves.
const HEIGHT: f64 = 0.12;
/// How many waves lie along a side: few squares to each, so that it shows how these are cut.
const WAVES: f64 = 2.0;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let [across, upright, fan] = [Cut::Across, Cut::Upright, Cut::Fan].map(|cut| diamond(cut, size));
    let (across, upright, fan) = (across?, upright?, fan?);
    let draw_waves = |cells, diagonal, shading| waves(cells, diagonal, shading, light, size);
    let pair = |cells, shading| -> Result<[Image; 2], ArtefactError> {
        Ok([draw_waves(cells, Diagonal::Rising, shading)?, draw_waves(cells, Diagonal::Falling, shading)?])
    };
    let [rising, falling] = pair(segments, Shading::Gouraud)?;
    let fine = draw_waves(FINER * segments, Diagonal::Rising, Shading::Gouraud)?;
    let [phong, phong_falling] = pair(segments, Shading::Phong)?;
    let exact = waves_themselves(light, size);
    let apart = |a: &Image, b: &Image| image_error(a, b, 0.5).map(|error| error.linear.rms / 255.0);
    let mut orders = Vec::new();
    for cells in [segments, 2 * segments, FINER * segments] {
        let [a, b] = pair(cells, Shading::Gouraud)?;
        orders.push([f64::from(cells), apart(&a, &b)?]);
    }
    let mean = |corners: &[usize]| {
        let sum = corners.iter().fold(LinearRgb::BLACK, |sum, &corner| sum + CORNERS[corner]);
        (sum * (1.0 / corners.len() as f64)).to_array()
    };
    // A pixel's centre is up to 0.71 pixels off the middle; from there to a corner colours change by 0.5 at most.
    let tolerance = 0.5 * 0.71 * WINDOW / f64::from(size) + 1e-6;
    let mut measures = Vec::new();
    for (image, name, corners) in [
        (&across, ["cut 1–3", "corte 1–3"], &[0, 2][..]),
        (&upright, ["cut 2–4", "corte 2–4"], &[1, 3]),
        (&fan, ["vertex in the middle", "vértice no meio"], &[0, 1, 2, 3]),
    ] {
        for (axis, colour) in
            [["red", "vermelho"], ["green", "verde"], ["blue", "azul"]].into_iter().enumerate()
        {
            let text = |k: usize| match k {
                0 => format!("diamond, {}: {} in the middle", name[0], colour[0]),
                _ => format!("losango, {}: {} no meio", name[1], colour[1]),
            };
            measures.push(Measure::new(Text::made(text(0), text(1)), "", centre(image)[axis]).expect(
                mean(corners)[axis],
                tolerance,
                Text::new(
                    "the mean of these corners; half a pixel's diagonal",
                    "a média desses cantos; meia diagonal de pixel",
                ),
            ));
        }
    }
    let middle = |image: &Image| centre(image);
    let blue = (middle(&across)[2] - middle(&upright)[2]).abs();
    let order = order(&orders, light, size);
    let is_square = order.as_ref().is_some_and(|order| order.agrees() == Some(true));
    measures.extend(order);
    measures.push(Measure::new(
        Text::new("diamond: largest difference of the middle", "losango: maior diferença do meio"),
        "",
        blue,
    ));
    measures.push(Measure::new(
        Text::new(
            "waves, Gouraud: difference of the diagonals (rms)",
            "ondas, Gouraud: diferença das diagonais (rms)",
        ),
        "",
        apart(&rising, &falling)?,
    ));
    measures.push(Measure::new(
        Text::new(
            "waves, Phong: difference of the diagonals (rms)",
            "ondas, Phong: diferença das diagonais (rms)",
        ),
        "",
        apart(&phong, &phong_falling)?,
    ));
    let full = 0.3;
    let difference = map([size; 2], &differences(&rising, &falling), full);
    let waves = Moved {
        name: Text::new(
            "light on the waves, off that of the surface itself (rms)",
            "luz nas ondas, diferença à da própria superfície (rms)",
        ),
        unit: "",
        bad: apart(&rising, &exact)?,
        present: Threshold::HALF_STEP,
        cure: Text::made(
            format!("{FINER} times as many squares along a side"),
            format!("{FINER} vezes mais quadrados por lado"),
        ),
        cured: apart(&fine, &exact)?,
        factor: 8.0,
    };
    let along = Moved { cured: apart(&falling, &exact)?, factor: 1.5, ..waves.clone() };
    let off_surface = |(value, name, cut): (f64, &'static str, &'static str)| {
        Measure::new(
            Text::made(
                format!("waves, {name}: light off that of the surface itself (rms)"),
                format!("ondas, {cut}: luz, diferença à da própria superfície (rms)"),
            ),
            "",
            value,
        )
    };
    measures.extend(
        [
            (waves.bad, "cut across", "cortadas de través"),
            (along.cured, "cut along", "cortadas ao longo"),
            (waves.cured, "cut across, finer", "cortadas de través, mais finas"),
        ]
        .map(off_surface),
    );
    let of_all = mean(&[0, 1, 2, 3]);
    let from_mean = |image: &Image| (0..3).map(|k| (centre(image)[k] - of_all[k]).abs()).fold(0.0, f64::max);
    let diamond = Moved {
        name: Text::new(
            "colour of the middle, off the mean of all corners",
            "cor do meio, diferença à média de todos os cantos",
        ),
        bad: from_mean(&across),
        cured: from_mean(&fan),
        // From 0.2 to what half a pixel's diagonal makes of it, an eighth of that in the smallest picture.
        factor: 5.0,
        ..waves.clone()
    };
    let off = |image: &Image| Moved { bad: from_mean(image), ..diamond.clone() };
    Ok(Outcome {
        verdict: Verdict::Holds(Text::new(
            "wherever the corners' values do not lie in one plane. The colours of triangles do not change as the polygon is turned, but \
             how it is cut shows; on smooth surfaces the difference falls as the square of the facets' size.",
            "sempre que os valores dos cantos não estão num plano. As cores dos triângulos não mudam quando o polígono gira, mas o seu \
             corte aparece; em superfícies lisas a diferença cai com o quadrado do tamanho das facetas.",
        )),
        shots: vec![
            waves.bad_shot(
                "waves-rising",
                Text::new("waves, cut across", "ondas, cortadas de través"),
                [
                    Text::new(
                        "Slanting waves with Gouraud's shading; each square is cut across them, from the lower left to the upper right.",
                        "Ondas oblíquas com Gouraud; cada quadrado é cortado de través, do canto inferior esquerdo ao superior direito.",
                    ),
                    Text::new("They fall into beads.", "Elas se desfazem em contas."),
                ],
                rising,
            ),
            along.cured_shot(
                "waves-falling",
                Text::new("waves, cut along", "ondas, cortadas ao longo"),
                [
                    Text::new(
                        "The same vertices and normals; only the diagonals run the other way, along the waves.",
                        "Os mesmos vértices e normais; só as diagonais vão no outro sentido, ao longo das ondas.",
                    ),
                    Text::new(
                        "The stripes are straight, but not as soft as those of the waves themselves.",
                        "As listras são retas, mas não tão suaves quanto as das próprias ondas.",
                    ),
                ],
                falling,
            ),
            Shot::difference(
                "waves-difference",
                Text::new("difference", "diferença"),
                Text::with(
                    "How much both differ, from violet for 0 to yellow for {} and more.",
                    "Quanto as duas diferem, de violeta para 0 a amarelo para {} ou mais.",
                    &[full],
                ),
                difference,
            ),
            waves.cured_shot(
                "waves-fine",
                Text::new("waves, finer", "ondas, mais finas"),
                [
                    Text::new(
                        "Cut across as the first, with four times the squares along a side.",
                        "Cortadas de través como as primeiras, com quatro vezes mais quadrados por lado.",
                    ),
                    Text::new("The cut is hardly seen any more.", "O corte quase não se vê mais."),
                ],
                fine,
            ),
            Shot::truth(
                "waves-themselves",
                Text::new("the waves themselves", "as próprias ondas"),
                Text::new(
                    "The surface with its own normal at every pixel.",
                    "A superfície com a sua própria normal em cada pixel.",
                ),
                exact,
            ),
            off(&across).bad_shot(
                "diamond-1-3",
                Text::new("diamond, cut 1–3", "losango, corte 1–3"),
                [
                    Text::new(
                        "Cut from the right to the left corner.",
                        "Cortado do canto direito ao esquerdo.",
                    ),
                    Text::new("A light band runs across.", "Uma faixa clara corre na horizontal."),
                ],
                across,
            ),
            off(&upright).bad_shot(
                "diamond-2-4",
                Text::new("diamond, cut 2–4", "losango, corte 2–4"),
                [
                    Text::new(
                        "Cut from the upper to the lower corner.",
                        "Cortado do canto de cima ao de baixo.",
                    ),
                    Text::new(
                        "A dark olive band runs upright, and the middle has another colour.",
                        "Uma faixa oliva escura corre na vertical, e o meio tem outra cor.",
                    ),
                ],
                upright,
            ),
            diamond.cured_shot(
                "diamond-fan",
                Text::new("diamond, vertex in the middle", "losango, vértice no meio"),
                [
                    Text::new(
                        "Four triangles about a vertex with the mean of the corners.",
                        "Quatro triângulos em torno de um vértice com a média dos cantos.",
                    ),
                    Text::new("No diagonal is preferred.", "Nenhuma diagonal é preferida."),
                ],
                fan,
            ),
        ],
        moved: waves,
        measures,
        charts: vec![chart(orders, is_square)],
        notes: vec![Text::new(
            "Each of the two triangles knows nothing of the fourth corner: along the diagonal only its two ends count. The scanline algorithm on \
             the whole polygon prefers no diagonal, but depends on how the polygon is turned (see the experiment on \
             orientation). The number that moved is how far light on the triangles is off that of the surface itself, for both cuts \
             err: at least one of them by half of what they differ by.",
            "Cada um dos dois triângulos nada sabe do quarto canto: ao longo da diagonal só contam as suas pontas. O algoritmo de varredura no \
             polígono inteiro não prefere diagonal, mas depende de como o polígono está girado (veja o experimento sobre \
             orientação). O número que mudou é quanto a luz nos triângulos difere da luz da própria superfície, pois os dois cortes \
             erram: ao menos um deles por metade do que diferem.",
        )],
    })
}

/// By which power of h both diagonals differ on the waves; none where there is no light on them.
fn order(by_cells: &[[f64; 2]], light: Degrees, size: u32) -> Option<Measure> {
    // Of both finer ones: those of the coarsest mesh are far from small.
    let [[cells, _], [half, coarse], [most, fine]] = by_cells else { return None };
    if *coarse == 0.0 || *fine == 0.0 {
        return None;
    }
    let order = Measure::new(
        Text::new("waves: order of the difference in h", "ondas: ordem da diferença em h"),
        "",
        libm::log2(coarse / fine) / libm::log2(most / half),
    );
    let steepest = 0.5 * TAU * WAVES * HEIGHT;
    let is_lit = light.0.abs() < 90.0 && libm::tan(Radians::from(light).0.abs()) * steepest < 1.0;
    Some(if !is_lit {
        order.beyond(Text::new(
            "not held against O(h²): slopes turned away from the light are black, and light has a kink at their borders",
            "não comparado com O(h²): encostas viradas para longe da luz são pretas, e a luz tem uma quebra nas suas bordas",
        ))
    } else if *fine < 100.0 * f64::from(f32::EPSILON) {
        order.beyond(Text::new(
            "not held against O(h²): the finest squares differ by little more than single precision",
            "não comparado com O(h²): os quadrados mais finos diferem por pouco mais que a precisão simples",
        ))
    } else if 2.0 * most > f64::from(size) {
        order.beyond(Text::new(
            "not held against O(h²): the finest squares are smaller than two pixels",
            "não comparado com O(h²): os quadrados mais finos são menores que dois pixels",
        ))
    } else if *cells < 5.0 * WAVES {
        order.beyond(Text::new(
            "not held against O(h²): so few squares to a wave are not small",
            "não comparado com O(h²): tão poucos quadrados por onda não são pequenos",
        ))
    } else {
        order.expect(
            2.0,
            0.25,
            Text::new(
                "O(h²); facets of a twelfth of a wave are not small yet",
                "O(h²); facetas de um doze avos de onda ainda não são pequenas",
            ),
        )
    })
}

/// How the diamond is cut.
#[derive(Clone, Copy, Debug)]
enum Cut {
    /// From corner 1 to 3.
    Across,
    /// From corner 2 to 4.
    Upright,
    /// By a vertex in the middle.
    Fan,
}

/// The diamond of exercise 1.6.25 with its corners' colours, unlit.
fn diamond(cut: Cut, size: u32) -> Result<Image, ArtefactError> {
    let places = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y, DVec3::ZERO];
    let triangles = match cut {
        Cut::Across => vec![[0, 1, 2], [0, 2, 3]],
        Cut::Upright => vec![[0, 1, 3], [1, 2, 3]],
        Cut::Fan => vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    };
    let body = Body::new(&places, triangles, &[DVec3::Z; 5]);
    let mean = CORNERS.iter().fold(LinearRgb::BLACK, |sum, &colour| sum + colour) * 0.25;
    let colours: Vec<LinearRgb> = CORNERS.into_iter().chain([mean]).collect();
    let object = Object { paint: Paint::Given(Cow::Owned(colours)), ..body.object(chalk()) };
    let settings = settings([size; 2], Shading::Gouraud, Interpolation::Affine);
    draw(vec![object], &[], front(WINDOW), &settings)
}

/// The pixel in the middle.
fn centre(image: &Image) -> [f64; 3] {
    let index = image.index(image.size[0] / 2, image.size[1] / 2);
    index.map_or([f64::NAN; 3], |index| linear(image)[index].map(f64::from))
}

/// A surface of waves that run aslant, with its own normals.
fn waves(
    cells: u32,
    diagonal: Diagonal,
    shading: Shading,
    light: Degrees,
    size: u32,
) -> Result<Image, ArtefactError> {
    let body = Body::grid([cells; 2], diagonal, |u, v| {
        let height = HEIGHT * libm::sin(TAU * WAVES * (u + v));
        (DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, height), wave_normal(u, v))
    });
    let settings = settings([size; 2], shading, Interpolation::Perspective);
    draw(vec![body.object(chalk())], &[light_at(light)], front(WINDOW), &settings)
}

/// The normal of the waves; they rise by 2π HEIGHT WAVES / 2 at the most, in x = 2u − 1 as in y = 2v − 1.
fn wave_normal(u: f64, v: f64) -> DVec3 {
    let slope = 0.5 * TAU * WAVES * HEIGHT * libm::cos(TAU * WAVES * (u + v));
    DVec3::new(-slope, -slope, 1.0).normalize()
}

/// The waves without triangles: every pixel has the light of its own normal.
fn waves_themselves(light: Degrees, size: u32) -> Image {
    let (sine, cosine) = libm::sincos(Radians::from(light).0);
    let at = |pixel: u32| WINDOW * ((f64::from(pixel) + 0.5) / f64::from(size) - 0.5);
    let places = (0..size).flat_map(|y| (0..size).map(move |x| [at(x), -at(y)]));
    let shown = places.map(|[x, y]| {
        if x.abs() > 1.0 || y.abs() > 1.0 {
            return (BACKGROUND.to_array().map(|component| component as f32), 0);
        }
        let cosine = wave_normal(0.5 * (x + 1.0), 0.5 * (y + 1.0)).dot(DVec3::new(sine, 0.0, cosine));
        ([cosine.max(0.0) as f32; 3], 1)
    });
    let (colours, coverage) = shown.unzip();
    picture([size; 2], colours, coverage)
}

fn chart(orders: Vec<[f64; 2]>, is_square: bool) -> Chart {
    // Through the finest: a law of the small holds there.
    let [most, least] = orders[orders.len() - 1];
    let square = orders.iter().map(|&[cells, _]| [cells, least * (most / cells) * (most / cells)]).collect();
    Chart {
        name: "difference-by-cells",
        title: Text::new("Difference of both diagonals", "Diferença das duas diagonais"),
        caption: match is_square {
            true => Text::new(
                "The difference on the waves against the number of squares along a side: the more there are, the more nearly it falls as one over their square.",
                "A diferença nas ondas em função do número de quadrados por lado: quanto mais há, mais ela cai como um sobre o seu quadrado.",
            ),
            false => Text::new(
                "The difference on the waves against the number of squares along a side, beside one over its square.",
                "A diferença nas ondas em função do número de quadrados por lado, junto a um sobre o seu quadrado.",
            ),
        },
        x: Scale::log(Text::new("squares along a side", "quadrados por lado")),
        y: Scale::log(Text::new("rms difference", "diferença rms")),
        curves: vec![
            Curve { name: Text::new("measured", "medido"), drawn: Drawn::Points, points: orders },
            Curve {
                name: Text::new("as h², h = 1/number", "como h², h = 1/número"),
                drawn: Drawn::Guide,
                points: square,
            },
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn diagonals_show_and_stop_showing() {
        for segments in [10, 12] {
            let parameters = Parameters { size: 160, segments, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Means of two or four of the exercise's colours, in green and blue; half a pixel's diagonal.
            for (name, printed) in [
                ("diamond, cut 1–3: green", 0.5),
                ("diamond, cut 1–3: blue", 0.5),
                ("diamond, cut 2–4: green", 0.3),
                ("diamond, cut 2–4: blue", 0.1),
                ("diamond, vertex in the middle: blue", 0.3),
            ] {
                assert!(
                    (outcome.measured(name) - printed).abs() < 0.006,
                    "{name}: {}",
                    outcome.measured(name)
                );
            }
            // Present: several steps of 8 bits on average. Cured: a sixteenth in the limit, an eighth at least.
            assert!(
                outcome.moved.bad > 3.0 / 255.0 && outcome.moved.reduction() > 8.0,
                "{:?}",
                outcome.moved
            );
        }
    }
}
