//! The pictures, with what there is to see in them.

use super::super::{Moved, Shot, Text};
use super::FULL_ANGLE;
use super::subject::Case;
use crate::raster::Image;

/// The shots of each body, averaged and split; of the gear, whether all of it is split but the bore.
pub(super) fn all(
    moved: &Moved,
    is_bore_alone: bool,
    [cube, gear, roof, zigzag]: [[Case; 2]; 4],
) -> Vec<Shot> {
    let of = |cases: &[Case; 2]| {
        let [bad, cured] = cases.each_ref().map(|case| case.deviation.mean);
        let name = Text::new("mean error of the pixels' normals", "erro médio das normais dos pixels");
        Moved { name, bad, cured, ..moved.clone() }
    };
    let averaged = |moved: &Moved, name, body, texts, image| {
        moved.bad_shot(name, labelled(body, ["averaged", "média"]), texts, image)
    };
    let split = |moved: &Moved, name, body, texts, image| {
        moved.cured_shot(name, labelled(body, ["split", "separado"]), texts, image)
    };
    let [of_cube, of_gear, of_roof, of_zigzag] = [&cube, &gear, &roof, &zigzag].map(of);
    let of_bore = gear[1].largest();
    let is_bore_round = of_bore > 0.0;
    let ([gear_angles, gear_light], cube_angles) = (gear[0].maps(), cube[0].maps()[0].clone());
    let [[cube, sharp_cube], [gear, sharp_gear], [roof, sharp_roof], [zigzag, sharp_zigzag]] =
        [cube, gear, roof, zigzag].map(|pair| pair.map(|case| case.lit));
    let [cube_name, gear_name, zigzag_name, roof_name] =
        [["cube", "cubo"], ["gear", "engrenagem"], ["zig-zag", "zigue-zague"], ["roof", "telhado"]];
    vec![
        averaged(
            &of_gear,
            "gear",
            gear_name,
            [
                Text::new("A gear with one normal a vertex.", "Uma engrenagem com uma normal por vértice."),
                Text::new(
                    "The teeth look inflated, light runs round every edge.",
                    "Os dentes parecem inflados, a luz corre por cima de cada aresta.",
                ),
            ],
            gear,
        ),
        split(
            &of_gear,
            "gear-split",
            gear_name,
            [
                Text::new("Split at the crease angle.", "Separada pelo ângulo de vinco."),
                match is_bore_round {
                    true if is_bore_alone => Text::with(
                        "Teeth and sides are flat; the bore stays round on purpose, with normals up to {}° off its facets.",
                        "Dentes e lados são planos; o furo continua redondo de propósito, com normais a até {}° das suas facetas.",
                        &[of_bore],
                    ),
                    true => Text::new(
                        "Teeth and sides are flat, the bore stays round.",
                        "Dentes e lados são planos, o furo continua redondo.",
                    ),
                    false => Text::new(
                        "Teeth and sides are flat, but so are the facets of the bore, which is meant to be round.",
                        "Dentes e lados são planos, mas também as facetas do furo, que devia ser redondo.",
                    ),
                },
            ],
            sharp_gear,
        ),
        angle_map("gear-angles", gear_name, gear_angles),
        light_map("gear-light", gear_name, gear_light),
        averaged(
            &of_cube,
            "cube",
            cube_name,
            [
                Text::new(
                    "A cube of eight vertices with eight normals.",
                    "Um cubo de oito vértices com oito normais.",
                ),
                Text::new("It looks like a pillow.", "Ele parece uma almofada."),
            ],
            cube,
        ),
        split(
            &of_cube,
            "cube-split",
            cube_name,
            [
                Text::new("Split at the crease angle.", "Separado pelo ângulo de vinco."),
                Text::new("Every face has one luminance.", "Cada face tem uma só luminância."),
            ],
            sharp_cube,
        ),
        angle_map("cube-angles", cube_name, cube_angles),
        averaged(
            &of_zigzag,
            "zigzag",
            zigzag_name,
            [
                Text::new(
                    "Strips that lean to the left and to the right by 45°.",
                    "Faixas inclinadas 45° para a esquerda e para a direita.",
                ),
                Text::new(
                    "All means are parallel, and only the outline tells of them.",
                    "Todas as médias são paralelas, e só o contorno as revela.",
                ),
            ],
            zigzag,
        ),
        split(
            &of_zigzag,
            "zigzag-split",
            zigzag_name,
            [
                Text::new(
                    "The same sheet in the same light, split at the crease angle.",
                    "A mesma chapa sob a mesma luz, separada pelo ângulo de vinco.",
                ),
                Text::new("The strips have their own normals.", "As faixas têm as suas próprias normais."),
            ],
            sharp_zigzag,
        ),
        averaged(
            &of_roof,
            "roof",
            roof_name,
            [
                Text::new("A corrugated roof of flat strips.", "Um telhado trapezoidal de faixas planas."),
                Text::new("Averaged it looks like waves.", "Com a média parece feito de ondas."),
            ],
            roof,
        ),
        split(
            &of_roof,
            "roof-split",
            roof_name,
            [
                Text::new(
                    "The roof, split at the crease angle.",
                    "O telhado, separado pelo ângulo de vinco.",
                ),
                Text::new("Even strips with sharp bends.", "Faixas uniformes com dobras vivas."),
            ],
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
    Shot::difference(name, labelled(of, ["angle", "ângulo"]), caption, image)
}

pub(super) fn light_map(name: &'static str, of: [&'static str; 2], image: Image) -> Shot {
    let caption = Text::new(
        "How far the light by Lambert's law is off: violet 0, yellow half of the full range and more.",
        "Quanto erra a luz pela lei de Lambert: violeta 0, amarelo metade da faixa ou mais.",
    );
    Shot::difference(name, labelled(of, ["light", "luz"]), caption, image)
}
