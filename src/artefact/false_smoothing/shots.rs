//! The pictures, with what there is to see in them.

use super::super::{Moved, Shot, Text};
use super::FULL_ANGLE;
use super::subject::Case;
use super::texts::TEXTS;
use crate::raster::Image;

/// The shots of each body, averaged and split; of the gear, whether all of it is split but the bore.
pub(super) fn all(
    moved: &Moved,
    is_bore_alone: bool,
    [cube, gear, roof, zigzag]: [[Case; 2]; 4],
) -> Vec<Shot> {
    let of = |cases: &[Case; 2]| {
        let [bad, cured] = cases.each_ref().map(|case| case.deviation.mean);
        let name = TEXTS.get("mean-error-pixels");
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
            [TEXTS.get("gear-normal-vertex"), TEXTS.get("teeth-look-inflated")],
            gear,
        ),
        split(
            &of_gear,
            "gear-split",
            gear_name,
            [
                TEXTS.get("split-crease-angle"),
                match is_bore_round {
                    true if is_bore_alone => TEXTS.with("teeth-sides-flat", &[("of-bore", of_bore.into())]),
                    true => TEXTS.get("teeth-sides-flat-bore"),
                    false => TEXTS.get("teeth-sides-flat-but"),
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
            [TEXTS.get("cube-eight-vertices"), TEXTS.get("looks-like-pillow")],
            cube,
        ),
        split(
            &of_cube,
            "cube-split",
            cube_name,
            [TEXTS.get("split-crease-angle-v2"), TEXTS.get("every-face-luminance")],
            sharp_cube,
        ),
        angle_map("cube-angles", cube_name, cube_angles),
        averaged(
            &of_zigzag,
            "zigzag",
            zigzag_name,
            [TEXTS.get("strips-lean-left"), TEXTS.get("all-means-parallel")],
            zigzag,
        ),
        split(
            &of_zigzag,
            "zigzag-split",
            zigzag_name,
            [TEXTS.get("same-sheet-same"), TEXTS.get("strips-their-own")],
            sharp_zigzag,
        ),
        averaged(
            &of_roof,
            "roof",
            roof_name,
            [TEXTS.get("corrugated-roof-flat"), TEXTS.get("averaged-looks-like")],
            roof,
        ),
        split(
            &of_roof,
            "roof-split",
            roof_name,
            [TEXTS.get("roof-split-crease"), TEXTS.get("even-strips-sharp")],
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
    let caption = TEXTS.get("how-far-light");
    Shot::difference(name, labelled(of, ["light", "luz"]), caption, image)
}
