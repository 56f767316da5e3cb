//! The pictures, with what there is to see in them.

use super::super::{Role, Shot, Text};
use super::FULL_ANGLE;
use super::subject::Case;
use crate::raster::Image;

pub(super) fn all([cube, gear, roof, zigzag]: [[Case; 2]; 4]) -> Vec<Shot> {
    let averaged = |name, of: [&'static str; 2], en, pt, image| {
        Shot::new(name, Role::Bad, labelled(of, ["averaged", "média"]), Text::new(en, pt), image)
    };
    let split = |name, of: [&'static str; 2], en, pt, image| {
        Shot::new(name, Role::Cured, labelled(of, ["split", "separado"]), Text::new(en, pt), image)
    };
    let ([gear_angles, gear_light], cube_angles) = (gear[0].maps(), cube[0].maps()[0].clone());
    let [[cube, sharp_cube], [gear, sharp_gear], [roof, sharp_roof], [zigzag, sharp_zigzag]] =
        [cube, gear, roof, zigzag].map(|pair| pair.map(|case| case.lit));
    vec![
        averaged(
            "gear",
            ["gear", "engrenagem"],
            "One normal a vertex: the teeth look inflated, light runs round every edge.",
            "Uma normal por vértice: os dentes parecem inflados, a luz corre por cima de cada aresta.",
            gear,
        ),
        split(
            "gear-split",
            ["gear", "engrenagem"],
            "Split at the crease angle: teeth and sides are flat, the bore stays round.",
            "Separada pelo ângulo de vinco: dentes e lados são planos, o furo continua redondo.",
            sharp_gear,
        ),
        angle_map("gear-angles", ["gear", "engrenagem"], gear_angles),
        light_map("gear-light", ["gear", "engrenagem"], gear_light),
        averaged(
            "cube",
            ["cube", "cubo"],
            "Eight vertices, eight normals along the diagonals: the cube looks like a pillow.",
            "Oito vértices, oito normais ao longo das diagonais: o cubo parece uma almofada.",
            cube,
        ),
        split(
            "cube-split",
            ["cube", "cubo"],
            "Three normals a vertex: every face has one luminance.",
            "Três normais por vértice: cada face tem uma só luminância.",
            sharp_cube,
        ),
        angle_map("cube-angles", ["cube", "cubo"], cube_angles),
        averaged(
            "zigzag",
            ["zig-zag", "zigue-zague"],
            "Strips that lean to the left and to the right by 45°: all means are parallel, and only the outline tells of them.",
            "Faixas inclinadas 45° para a esquerda e para a direita: todas as médias são paralelas, e só o contorno as revela.",
            zigzag,
        ),
        split(
            "zigzag-split",
            ["zig-zag", "zigue-zague"],
            "The same sheet with the strips' own normals, in the same light from the right.",
            "A mesma chapa com as normais das próprias faixas, sob a mesma luz vinda da direita.",
            sharp_zigzag,
        ),
        averaged(
            "roof",
            ["roof", "telhado"],
            "A corrugated roof of flat strips: averaged it looks like waves.",
            "Um telhado trapezoidal de faixas planas: com a média parece feito de ondas.",
            roof,
        ),
        split(
            "roof-split",
            ["roof", "telhado"],
            "The roof as it is: even strips with sharp bends.",
            "O telhado como ele é: faixas uniformes com dobras vivas.",
            sharp_roof,
        ),
    ]
}

pub(super) fn labelled([en, pt]: [&'static str; 2], [how_en, how_pt]: [&'static str; 2]) -> Text {
    Text::made(format!("{en}, {how_en}"), format!("{pt}, {how_pt}"))
}

pub(super) fn angle_map(name: &'static str, of: [&'static str; 2], image: Image) -> Shot {
    let caption = Text::made(
        format!(
            "The angle between the averaged normal and that of the face: violet 0°, yellow {FULL_ANGLE}° and more."
        ),
        format!("O ângulo entre a normal média e a da face: violeta 0°, amarelo {FULL_ANGLE}° ou mais."),
    );
    Shot::new(name, Role::Difference, labelled(of, ["angle", "ângulo"]), caption, image)
}

pub(super) fn light_map(name: &'static str, of: [&'static str; 2], image: Image) -> Shot {
    let caption = Text::new(
        "How far the light by Lambert's law is off: violet 0, yellow half of the full range and more.",
        "Quanto erra a luz pela lei de Lambert: violeta 0, amarelo metade da faixa ou mais.",
    );
    Shot::new(name, Role::Difference, labelled(of, ["light", "luz"]), caption, image)
}
