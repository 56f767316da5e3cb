//! The pictures: a box and a plate under a near lamp, and a plate before a near viewer.

use super::super::stage::{chalk, draw, front, object, settings};
use super::super::{ArtefactError, Moved, Shot, Text, Threshold};
use super::{Lamp, RADIUS, RATIOS, Viewer, paint_plate, squares};
use crate::metric::image_error;
use crate::normals::{NormalRecipe, compute};
use crate::num::{Degrees, LinearRgb};
use crate::raster::{Camera, Image, Interpolation, Shading};
use crate::shade::{Attenuation, Light};
use glam::DVec3;

/// The plate that the number that moves is measured on.
pub(super) fn of_plate(
    lamp: &Lamp,
    moved: &Moved,
    segments: u32,
    size: u32,
) -> Result<Vec<Shot>, ArtefactError> {
    let paint = |cells| paint_plate(cells, chalk(), lamp.light(), front(2.0), size, Shading::Flat);
    Ok(vec![
        moved.bad_shot(
            "plate",
            Text::new("plate, one face", "placa, uma face"),
            [
                Text::new(
                    "A plate under a lamp at two circumradii.",
                    "Uma placa sob uma lâmpada a dois circunraios.",
                ),
                Text::new("All of it has one grey.", "Toda ela tem um só cinza."),
            ],
            paint(1)?,
        ),
        moved.cured_shot(
            "plate-small-faces",
            Text::new("plate, small faces", "placa, faces pequenas"),
            [
                Text::made(
                    format!("The same plate cut into {segments} × {segments} squares."),
                    format!("A mesma placa dividida em {segments} × {segments} quadrados."),
                ),
                Text::new("The light falls off away from the lamp.", "A luz diminui para longe da lâmpada."),
            ],
            paint(segments)?,
        ),
    ])
}

/// A box under a lamp that is near its upper corner, and far away in the same direction.
pub(super) fn of_box(size: u32, segments: u32) -> Result<Vec<Shot>, ArtefactError> {
    let sides = [
        (DVec3::new(-1.0, -1.0, 1.0), DVec3::X * 2.0, DVec3::Y * 2.0),
        (DVec3::new(1.0, -1.0, 1.0), DVec3::Z * -2.0, DVec3::Y * 2.0),
        (DVec3::new(-1.0, 1.0, 1.0), DVec3::X * 2.0, DVec3::Z * -2.0),
    ];
    let camera = Camera { eye: DVec3::new(60.0, 45.0, 80.0), ..front(3.8) };
    let lamp = DVec3::new(1.5, 1.8, 2.1);
    let paint = |cells: u32, away: f64, shading| -> Result<Image, ArtefactError> {
        let mesh = squares(cells, &sides)?;
        let normals = compute(&mesh, &NormalRecipe::default());
        let light =
            Light::Point { position: lamp * away, colour: LinearRgb::WHITE, attenuation: Attenuation::None };
        let settings = settings([size; 2], shading, Interpolation::Perspective);
        draw(vec![object(&mesh, &normals, chalk())], &[light], camera, &settings)
    };
    let near = paint(1, 1.0, Shading::Phong)?;
    let [flat, cut_up] = [1, segments].map(|cells| paint(cells, 1.0, Shading::Flat));
    let (flat, cut_up, far) = (flat?, cut_up?, paint(1, 100.0, Shading::Flat)?);
    let off = |image: &Image, truth: &Image| {
        Ok::<f64, ArtefactError>(image_error(image, truth, 0.5)?.linear.max / 255.0)
    };
    let small = Moved {
        name: Text::new("largest error of a pixel's light", "maior erro da luz de um pixel"),
        unit: "",
        bad: off(&flat, &near)?,
        present: Threshold::HALF_STEP,
        cure: Text::new("smaller faces", "faces menores"),
        cured: off(&cut_up, &near)?,
        // Of faces a third as long already.
        factor: 2.0,
    };
    let away = Moved { cured: off(&far, &paint(1, 100.0, Shading::Phong)?)?, factor: 10.0, ..small.clone() };
    Ok(vec![
        small.bad_shot(
            "flat",
            Text::new("flat, lamp near", "plano, lâmpada próxima"),
            [
                Text::new("A lamp stands near the corner of the box.", "Há uma lâmpada perto do canto da caixa."),
                Text::new(
                    "But each side has one colour: nothing tells that the lamp is near.",
                    "Mas cada lado tem uma só cor: nada mostra que a lâmpada está próxima.",
                ),
            ],
            flat,
        ),
        Shot::truth(
            "every-pixel",
            Text::new("every pixel, lamp near", "cada pixel, lâmpada próxima"),
            Text::new(
                "Lit at every pixel, the sides are bright near the lamp and fade away from it, by the angle of the light alone: distance \
                 takes nothing here.",
                "Iluminados pixel a pixel, os lados são claros perto da lâmpada e escurecem longe dela, só pelo ângulo da luz: a \
                 distância nada tira aqui.",
            ),
            near,
        ),
        small.cured_shot(
            "flat-small-faces",
            Text::new("flat, small faces", "plano, faces pequenas"),
            [
                Text::made(
                    format!("The same flat shading with each side cut into {segments} × {segments} squares."),
                    format!("O mesmo sombreamento plano com cada lado dividido em {segments} × {segments} quadrados."),
                ),
                Text::new("Closer to the truth.", "Mais perto da verdade."),
            ],
            cut_up,
        ),
        away.cured_shot(
            "flat-lamp-far",
            Text::new("flat, lamp far", "plano, lâmpada distante"),
            [
                Text::new(
                    "The lamp moved a hundred times as far away, without fading: all points of a side see it at the same slant.",
                    "A lâmpada cem vezes mais longe, sem enfraquecer: todos os pontos de um lado a veem com a mesma inclinação.",
                ),
                Text::new("Now one colour a side is almost right.", "Agora uma cor por lado está quase certa."),
            ],
            far,
        ),
    ])
}

/// How far to the side the light stands whose highlight a near viewer sees on the plate: closer to the axis than its edges.
pub(super) const ASIDE: Degrees = Degrees(15.0);

/// The plate with nothing but a highlight, its viewer at two circumradii.
pub(super) fn of_highlight(exponent: f64, segments: u32, size: u32) -> Result<Vec<Shot>, ArtefactError> {
    let viewer = Viewer { angle: ASIDE, distance: RATIOS[0] * RADIUS, exponent };
    let (material, light, camera) = viewer.scene();
    let paint = |cells, shading| paint_plate(cells, material, light, camera, size, shading);
    let small = Moved {
        name: Text::with(
            "largest error of the highlight of light {}° to the side",
            "maior erro do brilho de uma luz {}° ao lado",
            &[ASIDE.0],
        ),
        unit: "",
        bad: viewer.error(1, size)?,
        present: Threshold::HALF_STEP,
        cure: Text::new("smaller faces", "faces menores"),
        cured: viewer.error(segments, size)?,
        // Of a few steps less the squares are still seen.
        factor: 20.0,
    };
    Ok(vec![
        small.bad_shot(
            "highlight",
            Text::new("highlight, one face", "brilho, uma face"),
            [
                Text::with(
                    "A plate with nothing but a highlight (Phong's, n = {}) of a far light {}° to the side, the viewer at two circumradii.",
                    "Uma placa só com um brilho (de Phong, n = {}) de uma luz distante {}° ao lado, o observador a dois circunraios.",
                    &[exponent, ASIDE.0],
                ),
                Text::new(
                    "One grey, that of the middle: there is no highlight in its place.",
                    "Um só cinza, o do meio: não há brilho no seu lugar.",
                ),
            ],
            paint(1, Shading::Flat)?,
        ),
        Shot::truth(
            "highlight-every-pixel",
            Text::new("highlight, every pixel", "brilho, cada pixel"),
            Text::new(
                "Lit at every pixel: the direction to the viewer changes from point to point.",
                "Iluminada pixel a pixel: a direção ao observador varia de ponto a ponto.",
            ),
            paint(1, Shading::Phong)?,
        ),
        small.cured_shot(
            "highlight-small-faces",
            Text::new("highlight, small faces", "brilho, faces pequenas"),
            [
                Text::made(
                    format!("Flat shading of {segments} × {segments} squares."),
                    format!("Sombreamento plano de {segments} × {segments} quadrados."),
                ),
                Text::new("The highlight is in its place, in steps.", "O brilho está no lugar, em degraus."),
            ],
            paint(segments, Shading::Flat)?,
        ),
    ])
}
