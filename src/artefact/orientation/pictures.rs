//! The polygon in its positions, and its centre over a whole turn.

use super::super::stage::{differences, linear, map, picture};
use super::super::{Chart, Curve, Drawn, Moved, Scale, Shot, Text, Threshold};
use crate::raster::Image;
use glam::DVec3;

/// The upper half of a picture above the lower half of another of the same size: where both show the same, there is no seam.
fn halves(upper: &Image, lower: &Image) -> Image {
    let [width, height] = upper.size;
    let middle = (width * (height / 2)) as usize;
    let colours = [&linear(upper)[..middle], &linear(lower)[middle..]].concat();
    let coverage = [&upper.coverage[..middle], &lower.coverage[middle..]].concat();
    picture(upper.size, colours, coverage)
}

/// What is to be said of a special case (the lectures' diamond), or of any polygon.
fn either(is_special: bool, special: Text, any: Text) -> Text {
    if is_special { special } else { any }
}

/// The pictures of what was drawn under scanlines (unturned, turned by 45° and 90°, and turned back), under triangles turned
/// back, and cut one way and the other, which are the same where it has one cut only: then they have no difference to show.
pub(super) fn shots(
    [upright, half, turned, back]: [Image; 4],
    triangles_back: &Image,
    [one, other]: [Image; 2],
    has_one_cut: bool,
    is_diamond: bool,
    moved: &Moved,
) -> Vec<Shot> {
    let captioned = |diamond, any| either(is_diamond, diamond, any);
    let largest = |a: &Image, b: &Image| differences(a, b).into_iter().flatten().fold(0.0, f64::max);
    let seam = Moved {
        name: Text::new(
            "largest change of a pixel's colour by a quarter turn, turned back",
            "maior mudança da cor de um pixel por um quarto de volta, girado de volta",
        ),
        bad: largest(&upright, &back),
        cured: largest(&one, triangles_back),
        factor: 10.0,
        ..moved.clone()
    };
    let difference = map(upright.size, &differences(&upright, &back), 0.4);
    let between = map(upright.size, &differences(&one, &other), 0.4);
    let cuts_differ = largest(&one, &other) > Threshold::HALF_STEP.value;
    let same_however_turned =
        || Text::new("The same colours however it is turned.", "As mesmas cores como quer que seja girado.");
    let but_not_the_other = match cuts_differ {
        true => Text::new(
            "Also the same however it is turned, but not the same as the other.",
            "Também as mesmas como quer que seja girado, mas não as do outro.",
        ),
        false => same_however_turned(),
    };
    let mut shots = vec![
        seam.bad_shot(
            "halves",
            Text::new("scanline: 0° above, 90° below", "varredura: 0° acima, 90° abaixo"),
            [
                captioned(
                    Text::new(
                        "Above, the diamond as it stands; below, drawn turned by 90° and turned back. Corner 1 is at the right, 2 above, 3 \
                         at the left (the brightest), 4 below (olive).",
                        "Acima, o losango como está; abaixo, desenhado girado de 90° e girado de volta. O canto 1 está à direita, o 2 acima, \
                         o 3 à esquerda (o mais claro), o 4 abaixo (oliva).",
                    ),
                    Text::new(
                        "Above, the polygon as it stands; below, drawn turned by 90° and turned back.",
                        "Acima, o polígono como está; abaixo, desenhado girado de 90° e girado de volta.",
                    ),
                ),
                Text::new(
                    "Were the colours its own, there would be no seam.",
                    "Se as cores fossem dele, não haveria emenda.",
                ),
            ],
            halves(&upright, &back),
        ),
        seam.cured_shot(
            "halves-triangles",
            Text::new("triangles: 0° above, 90° below", "triângulos: 0° acima, 90° abaixo"),
            [
                Text::new("The same in triangles.", "O mesmo em triângulos."),
                Text::new("There is no seam.", "Não há emenda."),
            ],
            halves(&one, triangles_back),
        ),
        moved.bad_shot(
            "position-1",
            Text::new("scanline, 0°", "linha de varredura, 0°"),
            [
                captioned(
                    Text::new(
                        "Position 1: the scanline through the centre runs from corner 3 to corner 1.",
                        "Posição 1: a linha de varredura pelo centro vai do canto 3 ao canto 1.",
                    ),
                    Text::new(
                        "As it stands: every pixel lies between the two edges that its scanline meets first.",
                        "Como está: cada pixel fica entre as duas arestas que a sua linha de varredura encontra primeiro.",
                    ),
                ),
                Text::new("Turned it has other colours.", "Girado ele tem outras cores."),
            ],
            upright,
        ),
        moved.bad_shot(
            "turned-45",
            Text::new("scanline, 45°", "linha de varredura, 45°"),
            [
                captioned(
                    Text::new(
                        "An eighth of a turn: the scanline cuts two edges in their middles, and the centre is the mean of all corners.",
                        "Um oitavo de volta: a linha corta duas arestas nos seus meios, e o centro é a média de todos os cantos.",
                    ),
                    Text::new(
                        "An eighth of a turn: scanlines meet the edges elsewhere.",
                        "Um oitavo de volta: as linhas encontram as arestas em outros lugares.",
                    ),
                ),
                Text::new("Colours change with the turn.", "As cores mudam com o giro."),
            ],
            half,
        ),
        moved.bad_shot(
            "position-2",
            Text::new("scanline, 90°", "linha de varredura, 90°"),
            [
                captioned(
                    Text::new(
                        "Position 2: the scanline runs from corner 2 to corner 4.",
                        "Posição 2: a linha vai do canto 2 ao canto 4.",
                    ),
                    Text::new(
                        "A quarter turn: scanlines meet other edges.",
                        "Um quarto de volta: as linhas encontram outras arestas.",
                    ),
                ),
                Text::new("The same polygon has other colours.", "O mesmo polígono tem outras cores."),
            ],
            turned,
        ),
        Shot::difference(
            "difference",
            Text::new("difference, 90° turned back", "diferença, 90° girado de volta"),
            captioned(
                Text::new(
                    "Position 2 turned back, less position 1: dark is none, yellow 0.4 of the full range in a component.",
                    "A posição 2 girada de volta, menos a posição 1: escuro é nenhuma, amarelo 0,4 da faixa numa componente.",
                ),
                Text::new(
                    "Drawn turned and turned back, less as it stands: dark is none, yellow 0.4 of the full range in a component.",
                    "Desenhado girado e girado de volta, menos como está: escuro é nenhuma, amarelo 0,4 da faixa numa componente.",
                ),
            ),
            difference,
        ),
        moved.cured_shot(
            "diagonal-13",
            captioned(
                Text::new("triangles, diagonal 1–3", "triângulos, diagonal 1–3"),
                Text::new("triangles, cut one way", "triângulos, um corte"),
            ),
            [
                captioned(
                    Text::new(
                        "Cut from corner 1 to corner 3: what scanlines draw in position 1, whose middle one is this diagonal.",
                        "Cortado do canto 1 ao canto 3: o que as linhas de varredura desenham na posição 1, cuja linha do meio é esta \
                         diagonal.",
                    ),
                    Text::new("Cut one way.", "Cortado de um modo."),
                ),
                same_however_turned(),
            ],
            one,
        ),
        moved.cured_shot(
            "diagonal-24",
            captioned(
                Text::new("triangles, diagonal 2–4", "triângulos, diagonal 2–4"),
                either(
                    has_one_cut,
                    Text::new("triangles, the same cut", "triângulos, o mesmo corte"),
                    Text::new("triangles, cut another way", "triângulos, outro corte"),
                ),
            ),
            [
                captioned(
                    Text::new(
                        "Cut from corner 2 to corner 4: what scanlines draw in position 2.",
                        "Cortado do canto 2 ao canto 4: o que as linhas de varredura desenham na posição 2.",
                    ),
                    either(
                        has_one_cut,
                        Text::new(
                            "No other cut lies inside this polygon: the same once more.",
                            "Nenhum outro corte fica dentro deste polígono: o mesmo mais uma vez.",
                        ),
                        Text::new("Cut another way.", "Cortado de outro modo."),
                    ),
                ),
                but_not_the_other,
            ],
            other,
        ),
    ];
    if !has_one_cut {
        shots.push(Shot::difference(
            "diagonals",
            captioned(
                Text::new("difference of the diagonals", "diferença das diagonais"),
                Text::new("difference of the cuts", "diferença dos cortes"),
            ),
            captioned(
                Text::new(
                    "One diagonal less the other: what the cut decides, which is what the turn decides under scanlines. Yellow is 0.4 of \
                     the full range in a component.",
                    "Uma diagonal menos a outra: o que o corte decide, e é o que o giro decide nas linhas de varredura. Amarelo é 0,4 da \
                     faixa numa componente.",
                ),
                Text::new(
                    "One cut less the other: what the cut decides. Yellow is 0.4 of the full range in a component.",
                    "Um corte menos o outro: o que o corte decide. Amarelo é 0,4 da faixa numa componente.",
                ),
            ),
            between,
        ));
    }
    shots
}

pub(super) fn chart(scanline: &[DVec3], laws: &[DVec3], triangles: &[DVec3], moved: &Moved) -> Chart {
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
    let names = [
        Text::new("R, the law", "R, a lei"),
        Text::new("G, the law", "G, a lei"),
        Text::new("B, the law", "B, a lei"),
    ];
    curves.extend(names.into_iter().enumerate().map(|(axis, name)| curve(name, Drawn::Guide, laws, axis)));
    Chart {
        name: "centre",
        title: Text::new("Colour of the centre over a whole turn", "Cor do centro numa volta inteira"),
        caption: Text::with(
            "Under the scanline algorithm the centre's colour changes by up to {} over a turn, as the law says; in triangles by up to {}.",
            "No algoritmo de linhas de varredura a cor do centro muda até {} numa volta, como diz a lei; em triângulos até {}.",
            &[moved.bad, moved.cured],
        ),
        x: Scale::linear(Text::new("turned by, degrees", "giro, graus")),
        y: Scale::linear(Text::new("linear component", "componente linear")),
        curves,
    }
}

#[cfg(test)]
mod tests {
    use super::super::EXPERIMENT;
    use crate::artefact::stage::luminance;
    use crate::artefact::{Parameters, Setup};

    /// The seam's height at the centre: the colours of the exercise's two positions against none.
    #[test]
    fn halves_fit_only_in_triangles() {
        let parameters = Parameters { size: 129, ..EXPERIMENT.defaults };
        let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
        let seam = |name: &str| {
            let image = &outcome.shots.iter().find(|shot| shot.name == name).unwrap().image;
            let at = |y| luminance(image)[image.index(64, y).unwrap()];
            (at(63) - at(64)).abs()
        };
        // (0.1, 0.5, 0.5) and (0.2, 0.3, 0.1) as luminances, and what changes from a row to the next.
        let [one, two] =
            [[0.1, 0.5, 0.5], [0.2, 0.3, 0.1]].map(|[r, g, b]| 0.2126 * r + 0.7152 * g + 0.0722 * b);
        let row = 2.0 * 0.6 / 112.0;
        let [scanline, triangles] = ["halves", "halves-triangles"].map(seam);
        assert!((scanline - (one - two)).abs() < row && triangles < row, "{scanline} {triangles}");
    }
}
