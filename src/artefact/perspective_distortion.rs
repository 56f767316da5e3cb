//! Interpolation on the picture against interpolation in the scene.

use super::stage::{draw, linear, map, picture, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Language, Measure, Moved, Outcome,
    Parameters, Scale, Setup, Shot, Text, Threshold, Verdict,
};
use crate::mesh::{Faces, Mesh, MeshBuilder};
use crate::normals::Weight;
use crate::num::LinearRgb;
use crate::raster::{Camera, Image, Interpolation, Object, Paint, Projection, Shading, Shape};
use crate::shade::Material;
use glam::DVec3;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "perspective-distortion",
    title: Text::new("Perspective distortion", "Distorção de perspectiva"),
    claim: Text::new(
        "Interpolating evenly on the picture is wrong under perspective: equal steps on the screen are not equal steps on the \
         surface.",
        "Interpolar por igual na imagem é errado em perspectiva: passos iguais na tela não são passos iguais na superfície.",
    ),
    sources: &[
        Text::new("Lectures: 1.5.2.3, 1.6.15, 1.6.47", "Aulas: 1.5.2.3, 1.6.15, 1.6.47"),
        Text::new(
            "J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992",
            "J. F. Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992 (em inglês)",
        ),
    ],
    formulas: &[
        Formula {
            notation: Text::same("s(t) = \\frac{t}{t + ρ (1 − t)}"),
            says: Text::new(
                "the place s on the surface that is seen at the place t of the picture, both from 0 to 1; ρ = z_far/z_near",
                "o lugar s na superfície que se vê no lugar t da imagem, ambos de 0 a 1; ρ = z_longe/z_perto",
            ),
        },
        Formula {
            notation: Text::same("max |t − s| = \\frac{\\sqrt{ρ} − 1}{\\sqrt{ρ} + 1}"),
            says: Text::new(
                "the largest error of even interpolation; ½ step of 255 as soon as ρ > 1.0079 for colours from 0 to 1",
                "o maior erro da interpolação uniforme; ½ passo de 255 assim que ρ > 1,0079 para cores de 0 a 1",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Segments],
    own_mesh: None,
    segments: Parameters::SEGMENTS,
    shown_by: Text::new("a deeper wall would show it.", "uma parede mais funda o mostraria."),
    // As many as it takes for half a step of 8 bits.
    defaults: Parameters { segments: 20, ..Parameters::USUAL },
    run,
    frame: None,
};

/// The depth ratio of the pictures.
const RATIO: f64 = 4.0;
/// Those of the plot.
const RATIOS: [f64; 6] = [1.1, 1.5, 2.0, 4.0, 6.0, 10.0];
/// Squares of the board along each side: of a wall in nine pieces or a multiple of that ten, for corners of pieces are right, and
/// squares with corners nowhere else would hide what is wrong between them.
fn squares(pieces: u32) -> f64 {
    if pieces.is_multiple_of(9) { 10.0 } else { 9.0 }
}
/// Half the width of the wall on the picture, whose half is 1.
const REACH: f64 = 0.9;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, .. } = setup.parameters;
    let wall = |pieces, interpolation| Wall::new(RATIO, pieces)?.draw([size; 2], interpolation);
    let affine = wall(1, Interpolation::Affine)?;
    let right = wall(1, Interpolation::Perspective)?;
    let cut = wall(segments, Interpolation::Affine)?;

    let law = |ratio: f64| (ratio.sqrt() - 1.0) / (ratio.sqrt() + 1.0);
    let error = |ratio, pieces, interpolation| Wall::new(ratio, pieces)?.error(interpolation);
    let measured: Vec<f64> =
        RATIOS.into_iter().map(|ratio| error(ratio, 1, Interpolation::Affine)).collect::<Result<_, _>>()?;
    let corrected = error(RATIO, 1, Interpolation::Perspective)?;
    let scanline = error(RATIO, 1, Interpolation::Scanline)?;
    let in_pieces = error(RATIO, segments, Interpolation::Affine)?;
    let up = Wall::new(RATIO, 1)?.error_up(Interpolation::Affine)?;
    let up_in_pieces = Wall::new(RATIO, segments)?.error_up(Interpolation::Affine)?;
    let by = || {
        Text::new(
            "(√ρ − 1)/(√ρ + 1); the nearest pixel of 4096, and single precision",
            "(√ρ − 1)/(√ρ + 1); o pixel mais próximo de 4096, e precisão simples",
        )
    };
    let mut measures: Vec<Measure> = RATIOS
        .into_iter()
        .zip(&measured)
        .map(|(ratio, &found)| {
            let name = Text::each(|language| {
                let affine = if language == Language::English { "affine" } else { "afim" };
                format!("{affine}, ρ = {}", language.number(ratio))
            });
            Measure::new(name, "", found).expect(law(ratio), TOLERANCE, by())
        })
        .collect();
    measures.push(
        Measure::new(Text::new("scanline, ρ = 4", "linha de varredura, ρ = 4"), "", scanline).expect(
            law(RATIO),
            TOLERANCE,
            by(),
        ),
    );
    measures.push(
        Measure::new(Text::new("perspective-correct, ρ = 4", "correta em perspectiva, ρ = 4"), "", corrected)
            .expect(
                0.0,
                TOLERANCE,
                Text::new("a/w and 1/w are linear on the picture", "a/w e 1/w são lineares na imagem"),
            ),
    );
    measures.push(
        Measure::new(
            Text::made(
                format!("affine, {segments} × {segments} pieces"),
                format!("afim, {segments} × {segments} pedaços"),
            ),
            "",
            in_pieces,
        )
        .expect(
            pieces_law(RATIO, segments),
            TOLERANCE,
            Text::new(
                "the nearest piece has the largest depth ratio, 1 + (ρ − 1)/n; its error over n",
                "o pedaço mais próximo tem a maior razão de profundidades, 1 + (ρ − 1)/n; o seu erro sobre n",
            ),
        ),
    );
    for (pieces, found) in [(1, up), (segments, up_in_pieces)] {
        measures.push(
            Measure::new(
                Text::made(
                    format!("affine, {pieces} × {pieces} pieces: place up"),
                    format!("afim, {pieces} × {pieces} pedaços: lugar na altura"),
                ),
                "",
                found,
            )
            .at_most(
                pieces_law(RATIO, pieces) + TOLERANCE,
                Text::new(
                    "as much as across, on the diagonal of a piece; pixels lie beside it",
                    "tanto quanto na largura, na diagonal de um pedaço; os pixels ficam ao lado dela",
                ),
            ),
        );
    }
    let bad = measured[3];
    let moved = Moved {
        name: Text::new("largest error of the place across", "maior erro do lugar na largura"),
        unit: "",
        bad,
        present: Threshold::HALF_STEP,
        cure: Text::new("perspective-correct interpolation", "interpolação correta em perspectiva"),
        cured: corrected,
        factor: 1000.0,
    };
    let cut_up = Moved { cured: in_pieces, ..moved.clone() };
    let shots = shots([&moved, &cut_up], [&affine, &right, &cut], segments);
    Ok(Outcome {
        verdict: Verdict::HoldsOnlyIf(Text::new(
            "the depths of a triangle's corners differ under a central projection. In a parallel projection, or facing the viewer, \
             both ways are the same; and an error below half a step of 255 is not seen: depths within 0.8 % for colours from \
             0 to 1.",
            "as profundidades dos cantos de um triângulo diferem sob projeção central. Em projeção paralela, ou de frente para o \
             observador, os dois modos são o mesmo; e um erro menor que meio passo de 255 não se vê: profundidades a menos de \
             0,8 % para cores de 0 a 1.",
        )),
        moved,
        charts: vec![error_chart(&measured, law), place_chart(law_place)],
        measures,
        shots,
        notes: vec![
            Text::new(
                "The board is not an image pasted on: two numbers are interpolated between the four corners of one face, the \
                 places across and up, and a square's colour is read off them. Whatever is interpolated, colours and normals too, \
                 goes wrong alike.",
                "O tabuleiro não é uma imagem colada: dois números são interpolados entre os quatro cantos de uma face, os \
                 lugares na largura e na altura, e deles se tira a cor de cada quadrado. O que quer que se interpole, também cores e \
                 normais, erra do mesmo modo.",
            ),
            Text::new(
                "Cut into more pieces both ways, each is smaller and has a smaller depth ratio: the error falls with the square of \
                 their number along a side. Dividing by depth makes it vanish.",
                "Cortada em mais pedaços nos dois sentidos, cada um é menor e tem razão de profundidades menor: o erro cai com o \
                 quadrado do número deles ao longo de um lado. Dividir pela profundidade o faz sumir.",
            ),
        ],
    })
}

/// The error's derivative by the place is up to ρ: half a pixel of 4096·0.9 is 10/7400 at ρ = 10 beside the largest error, where it
/// is 0 to first order; vertices snap to 256ths of pixels; single precision, 6·10⁻⁸, is far below.
const TOLERANCE: f64 = 2e-5;

/// The place t of the middle of a pixel: from 0 at the wall's left end on the picture to 1 at its right end.
fn across(pixel: u32, width: u32) -> f64 {
    let x = (f64::from(pixel) + 0.5) / f64::from(width) * 2.0 - 1.0;
    (x / REACH + 1.0) / 2.0
}

/// Where on the surface the place t of the picture is.
fn law_place(ratio: f64, t: f64) -> f64 {
    t / (t + ratio * (1.0 - t))
}

/// Cut into pieces of the same length, the nearest one has the largest ratio and the largest error.
fn pieces_law(ratio: f64, pieces: u32) -> f64 {
    let nearest = 1.0 + (ratio - 1.0) / f64::from(pieces);
    (nearest.sqrt() - 1.0) / (nearest.sqrt() + 1.0) / f64::from(pieces)
}

/// A wall that runs away from the viewer, from the left at depth 1 to the right at depth ρ, in as many equal pieces across as
/// up. Its colours are places: red across, green up.
struct Wall {
    mesh: Mesh,
    colours: Vec<LinearRgb>,
    ratio: f64,
}

impl Wall {
    fn new(ratio: f64, pieces: u32) -> Result<Self, ArtefactError> {
        let (near, far) = (DVec3::new(-REACH, 0.0, -1.0), DVec3::new(REACH * ratio, 0.0, -ratio));
        let (mut positions, mut colours) = (Vec::new(), Vec::new());
        let row = pieces + 1;
        let share = |k: u32| f64::from(k) / f64::from(pieces);
        for (s, v) in (0..row * row).map(|k| (share(k / row), share(k % row))) {
            positions.push(near.lerp(far, s) + DVec3::Y * REACH * (2.0 * v - 1.0));
            colours.push(LinearRgb::new(s, v, 0.0));
        }
        let piece = |k: u32| {
            let first = k / pieces * row + k % pieces;
            [0, row, row + 1, 1].map(|corner| first + corner)
        };
        let corners: Vec<u32> = (0..pieces * pieces).flat_map(piece).collect();
        let faces = Faces::polygons(corners, (0..=pieces * pieces).map(|k| 4 * k).collect());
        let mesh = MeshBuilder { positions, faces, ..MeshBuilder::default() }.build()?;
        Ok(Self { mesh, colours, ratio })
    }

    fn draw(&self, size: [u32; 2], interpolation: Interpolation) -> Result<Image, ArtefactError> {
        let normals = super::stage::smooth(&self.mesh, Weight::Angle);
        let object = Object {
            paint: Paint::Given(self.colours.as_slice().into()),
            ..Object::new(Shape::Mesh { mesh: &self.mesh, normals: &normals }, Material::default())
        };
        // As wide as 90°, whatever the height.
        let slope = f64::from(size[1]) / f64::from(size[0]);
        let camera = Camera {
            eye: DVec3::ZERO,
            target: DVec3::NEG_Z,
            up: DVec3::Y,
            projection: Projection::Perspective(crate::num::Radians(2.0 * libm::atan(slope))),
            near: 0.1,
        };
        draw(vec![object], &[], camera, &settings(size, Shading::Gouraud, interpolation))
    }

    /// The largest error of the place across, along the middle row of a picture of 4096 pixels.
    fn error(&self, interpolation: Interpolation) -> Result<f64, ArtefactError> {
        const LINE: u32 = 4096;
        let image = self.draw([LINE, 3], interpolation)?;
        let error = |pixel: u32| {
            let index = image.index(pixel, 1)?;
            let place = law_place(self.ratio, across(pixel, LINE));
            (image.coverage[index] > 0).then(|| (f64::from(linear(&image)[index][0]) - place).abs())
        };
        Ok((0..LINE).filter_map(error).fold(0.0, f64::max))
    }

    /// The largest error of the place up, of all pixels of a picture of 1024 by 1024. Its supremum is where the diagonals of
    /// pieces are, which pixels come close to and do not meet.
    fn error_up(&self, interpolation: Interpolation) -> Result<f64, ArtefactError> {
        const SIDE: u32 = 1024;
        let image = self.draw([SIDE; 2], interpolation)?;
        let error = |(index, colour): (usize, &[f32; 3])| {
            let [x, y] = [index as u32 % SIDE, index as u32 / SIDE];
            let depth = 1.0 + (self.ratio - 1.0) * law_place(self.ratio, across(x, SIDE));
            let up = 0.5 - (f64::from(y) + 0.5 - 0.5 * f64::from(SIDE)) / f64::from(SIDE) * depth / REACH;
            (image.coverage[index] > 0).then(|| (f64::from(colour[1]) - up).abs())
        };
        Ok(linear(&image).iter().enumerate().filter_map(error).fold(0.0, f64::max))
    }
}

/// So many squares along a side, coloured by interpolated places.
fn board(image: &Image, squares: f64) -> Image {
    const DARK: [f32; 3] = [0.03, 0.1, 0.35];
    const LIGHT: [f32; 3] = [0.95, 0.85, 0.5];
    let square = |place: f32| (libm::floor(f64::from(place) * squares) as i64).clamp(0, squares as i64 - 1);
    let colour = |(colour, &covered): (&[f32; 3], &u8)| match covered {
        0 => *colour,
        _ if (square(colour[0]) + square(colour[1])) % 2 == 0 => DARK,
        _ => LIGHT,
    };
    let colours = linear(image).iter().zip(&image.coverage).map(colour).collect();
    picture(image.size, colours, image.coverage.clone())
}

fn shots([moved, cut_up]: [&Moved; 2], [affine, right, cut]: [&Image; 3], pieces: u32) -> Vec<Shot> {
    let board = |image: &Image| board(image, squares(pieces));
    let off = |image: &Image| {
        let pairs = linear(image).iter().zip(linear(right)).zip(&image.coverage);
        let error = |((a, b), &covered): ((&[f32; 3], &[f32; 3]), &u8)| {
            (covered > 0).then(|| f64::from((a[0] - b[0]).abs().max((a[1] - b[1]).abs())))
        };
        map(image.size, &pairs.map(error).collect::<Vec<_>>(), 0.35)
    };
    vec![
        moved.bad_shot(
            "affine",
            Text::new("affine", "afim"),
            [
                Text::new(
                    "A wall that runs away to the right, to four times the depth.",
                    "Uma parede que se afasta para a direita, até quatro vezes a profundidade.",
                ),
                Text::new(
                    "Interpolated on the picture, squares bend at the diagonal and are as wide far away as near.",
                    "Interpolados na imagem, os quadrados quebram na diagonal e são tão largos longe quanto perto.",
                ),
            ],
            board(affine),
        ),
        moved.cured_shot(
            "perspective",
            Text::new("perspective-correct", "correta em perspectiva"),
            [
                Text::new("The same face interpolated in the scene.", "A mesma face interpolada na cena."),
                Text::new(
                    "Squares become smaller with their distance.",
                    "Os quadrados diminuem com a distância.",
                ),
            ],
            board(right),
        ),
        cut_up.cured_shot(
            "pieces",
            Text::new("affine, in pieces", "afim, em pedaços"),
            [
                Text::made(
                    format!("Affine again, but the wall is cut into {pieces} × {pieces} pieces."),
                    format!("De novo afim, mas com a parede cortada em {pieces} × {pieces} pedaços."),
                ),
                Text::new(
                    "Each errs so little that nothing of it is seen.",
                    "Cada um erra tão pouco que nada disso se vê.",
                ),
            ],
            board(cut),
        ),
        Shot::difference(
            "error",
            Text::new("error of the affine one", "erro da afim"),
            Text::new(
                "How far the affine place is from the true one, across or up, whichever is more: yellow is 0.35 of the wall.",
                "Quanto o lugar afim dista do verdadeiro, na largura ou na altura, o que for maior: amarelo é 0,35 da parede.",
            ),
            off(affine),
        ),
        Shot::difference(
            "error-pieces",
            Text::new("error in pieces", "erro em pedaços"),
            Text::with(
                "The same scale for the wall in pieces: {} at most.",
                "A mesma escala para a parede em pedaços: no máximo {}.",
                &[cut_up.cured],
            ),
            off(cut),
        ),
    ]
}

fn error_chart(measured: &[f64], law: impl Fn(f64) -> f64) -> Chart {
    let ratios = (0..=60).map(|k| libm::exp10(f64::from(k) / 60.0));
    Chart {
        name: "largest-error",
        title: Text::new(
            "Largest error against the depth ratio",
            "Maior erro em função da razão de profundidades",
        ),
        caption: Text::new(
            "Measured errors lie on the curve (√ρ − 1)/(√ρ + 1): a third of the length at ρ = 4, half at 9.",
            "Os erros medidos estão na curva (√ρ − 1)/(√ρ + 1): um terço do comprimento em ρ = 4, metade em 9.",
        ),
        x: Scale::log(Text::new("depth ratio ρ", "razão de profundidades ρ")),
        y: Scale::linear(Text::new("largest |t − s|", "maior |t − s|")),
        curves: vec![
            Curve {
                name: Text::new("measured", "medido"),
                drawn: Drawn::Points,
                points: RATIOS.into_iter().zip(measured).map(|(ratio, &error)| [ratio, error]).collect(),
            },
            Curve {
                name: Text::new("closed form", "fórmula"),
                drawn: Drawn::Guide,
                points: ratios.map(|ratio| [ratio, law(ratio)]).collect(),
            },
        ],
    }
}

fn place_chart(place: impl Fn(f64, f64) -> f64) -> Chart {
    let curve = |ratio: f64| Curve {
        name: Text::each(|language| format!("ρ = {}", language.number(ratio))),
        drawn: Drawn::Curve,
        points: (0..=50).map(|k| f64::from(k) / 50.0).map(|t| [t, place(ratio, t)]).collect(),
    };
    Chart {
        name: "place",
        title: Text::new(
            "Place on the surface against place on the picture",
            "Lugar na superfície em função do lugar na imagem",
        ),
        caption: Text::new(
            "Even interpolation takes the straight line; what ought to be seen lies on the curves.",
            "A interpolação uniforme toma a reta; o que se deveria ver está nas curvas.",
        ),
        x: Scale::linear(Text::new("t on the picture", "t na imagem")),
        y: Scale::linear(Text::new("s on the surface", "s na superfície")),
        curves: [1.0, 2.0, 4.0, 10.0].map(curve).to_vec(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_artefact_is_there_and_is_cured() {
        let setup = Setup { parameters: Parameters { size: 64, ..EXPERIMENT.defaults }, mesh: None };
        let outcome = EXPERIMENT.run(&setup).unwrap();
        outcome.prove();
        // A third at ρ = 4, which single precision cures.
        assert!(outcome.moved.bad > 0.33 && outcome.moved.reduction() > 1e3, "{:?}", outcome.moved);
    }

    /// Figures computed apart from this program.
    #[test]
    fn largest_errors_have_their_published_values() {
        for (ratio, printed) in [(1.5, 0.101_02), (2.0, 0.171_57), (4.0, 0.333_33), (10.0, 0.519_49)] {
            let found = Wall::new(ratio, 1).unwrap().error(Interpolation::Affine).unwrap();
            assert!((found - printed).abs() < 2.5e-5, "{ratio}: {found}");
        }
    }
}
