//! The polygon in its positions, and its centre over a whole turn.

use super::super::stage::{differences, map};
use super::super::{Chart, Curve, Drawn, Role, Scale, Shot, Text};
use crate::raster::Image;
use glam::DVec3;

pub(super) fn shots([upright, half, turned, back]: [Image; 4], one: Image, other: Image) -> Vec<Shot> {
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
            Text::new("triangles, diagonal 1–3", "triângulos, diagonal 1–3"),
            Text::new(
                "Cut from corner 1 to corner 3: the same colours however it is turned.",
                "Cortado do canto 1 ao canto 3: as mesmas cores como quer que seja girado.",
            ),
            one,
        ),
        Shot::new(
            "diagonal-24",
            Role::Cured,
            Text::new("triangles, diagonal 2–4", "triângulos, diagonal 2–4"),
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

pub(super) fn chart(scanline: &[DVec3], laws: &[DVec3], triangles: &[DVec3]) -> Chart {
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
