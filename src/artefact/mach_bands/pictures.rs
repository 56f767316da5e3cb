//! Pictures of the cylinder, and luminance across it with its derivatives.

use super::super::{ArtefactError, Chart, Curve, Drawn, Role, Scale, Shot, Text};
use super::tube::{Profile, Tube};
use super::{GRAZING, half};
use crate::num::Degrees;
use crate::raster::{Image, Shading};

pub(super) fn shots(size: u32, light: Degrees, tube: &Tube, fine: &Tube) -> Result<Vec<Shot>, ArtefactError> {
    let square = [size; 2];
    let shot = |name, role, label, caption, image: Result<Image, ArtefactError>| {
        Ok::<_, ArtefactError>(Shot { name, role, label, caption, image: image? })
    };
    let grazing = Tube::new(tube.segments, half(GRAZING))?;
    Ok(vec![
        shot(
            "flat",
            Role::Bad,
            Text::new("flat", "plano"),
            Text::new(
                "Flat shading: one luminance a facet. Each seems lighter at the edge with a darker one, though it is even.",
                "Sombreamento plano: uma luminância por faceta. Cada uma parece mais clara na aresta com uma mais escura, \
                 embora seja uniforme.",
            ),
            tube.draw(square, light, Shading::Flat),
        )?,
        shot(
            "gouraud",
            Role::Bad,
            Text::same("Gouraud"),
            Text::new(
                "Gouraud's shading of the same facets: luminance is continuous, its slope is not. Bands stand at the edges.",
                "O sombreamento de Gouraud das mesmas facetas: a luminância é contínua, a inclinação não. Há bandas nas \
                 arestas.",
            ),
            tube.draw(square, light, Shading::Gouraud),
        )?,
        shot(
            "phong",
            Role::Cured,
            Text::same("Phong"),
            Text::new(
                "Phong's shading: slopes still jump, but less under this light.",
                "O sombreamento de Phong: as inclinações ainda saltam, mas menos sob esta luz.",
            ),
            tube.draw(square, light, Shading::Phong),
        )?,
        shot(
            "fine",
            Role::Cured,
            Text::made(
                format!("Gouraud, {} segments", fine.segments),
                format!("Gouraud, {} segmentos", fine.segments),
            ),
            Text::new(
                "Gouraud's shading with four times the segments: jumps are a quarter of what they were.",
                "O sombreamento de Gouraud com quatro vezes mais segmentos: os saltos são um quarto do que eram.",
            ),
            fine.draw(square, light, Shading::Gouraud),
        )?,
        shot(
            "exact",
            Role::Truth,
            Text::new("the cylinder itself", "o próprio cilindro"),
            Text::new(
                "The cylinder lit at every pixel with its own normal: no bands.",
                "O cilindro iluminado em cada pixel com a sua própria normal: sem bandas.",
            ),
            tube.draw(square, light, Shading::Exact),
        )?,
        shot(
            "gouraud-80",
            Role::Cured,
            Text::new("Gouraud, light at 80°", "Gouraud, luz a 80°"),
            Text::new(
                "The light 80° off the direction of view: on facets that are lit as a whole Gouraud's shading is almost \
                 exact, for luminance is nearly linear across the picture. The kink is where the shadow begins: one corner \
                 of that facet is black.",
                "A luz a 80° da direção de visão: nas facetas iluminadas por inteiro o sombreamento de Gouraud é quase exato, \
                 pois a luminância é quase linear ao longo da imagem. A quebra está onde começa a sombra: um vértice dessa \
                 faceta é preto.",
            ),
            grazing.draw(square, GRAZING, Shading::Gouraud),
        )?,
        shot(
            "phong-80",
            Role::Bad,
            Text::new("Phong, light at 80°", "Phong, luz a 80°"),
            Text::new(
                "The same light with Phong's shading, whose slope jumps more at the edges half-way between the viewer and \
                 the light: it bends within each facet.",
                "A mesma luz com o sombreamento de Phong, cuja inclinação salta mais nas arestas a meio caminho entre o \
                 observador e a luz: ele se curva dentro de cada faceta.",
            ),
            grazing.draw(square, GRAZING, Shading::Phong),
        )?,
    ])
}

pub(super) fn charts(flat: &Profile, gouraud: &Profile, phong: &Profile, exact: &Profile) -> Vec<Chart> {
    /// Pixels between the samples that differences are taken of.
    const STEP: usize = 8;
    let unit = Profile::x(STEP) - Profile::x(0);
    let at = |values: &[f64], pixel: usize| values[pixel.min(values.len() - 1)];
    let value = move |values: &[f64], pixel: usize| at(values, pixel);
    let first = move |values: &[f64], pixel: usize| {
        (at(values, pixel + STEP) - at(values, pixel.saturating_sub(STEP))) / (2.0 * unit)
    };
    let second = move |values: &[f64], pixel: usize| {
        let around = at(values, pixel + STEP) + at(values, pixel.saturating_sub(STEP));
        (around - 2.0 * at(values, pixel)) / (unit * unit)
    };
    let curve = |name, line: &Profile, value: &dyn Fn(&[f64], usize) -> f64| Curve {
        name,
        drawn: Drawn::Curve,
        points: line.points(STEP, value),
    };
    let three = |value: &dyn Fn(&[f64], usize) -> f64| {
        vec![
            curve(Text::same("Gouraud"), gouraud, value),
            curve(Text::same("Phong"), phong, value),
            curve(Text::new("exact", "exato"), exact, value),
        ]
    };
    let x = || Scale::linear(Text::new("x across the picture, in radii", "x ao longo da imagem, em raios"));
    let mut luminances = three(&value);
    luminances.insert(0, curve(Text::new("flat", "plano"), flat, &value));
    vec![
        Chart {
            name: "luminance",
            title: Text::new("Luminance along a scanline", "Luminância ao longo de uma linha de varredura"),
            caption: Text::new(
                "Flat shading has steps, Gouraud's is a polygon, Phong's lies close to the exact curve.",
                "O sombreamento plano tem degraus, o de Gouraud é uma poligonal, o de Phong fica perto da curva exata.",
            ),
            x: x(),
            y: Scale::linear(Text::new("linear luminance Y", "luminância linear Y")),
            curves: luminances,
        },
        Chart {
            name: "slope",
            title: Text::new("First derivative", "Primeira derivada"),
            caption: Text::new(
                "The slope of luminance: Gouraud's is constant on each facet and jumps at edges, Phong's jumps less.",
                "A inclinação da luminância: a de Gouraud é constante em cada faceta e salta nas arestas, a de Phong salta \
                 menos.",
            ),
            x: x(),
            y: Scale::linear(Text::new("dY/dx, per radius", "dY/dx, por raio")),
            curves: three(&first),
        },
        Chart {
            name: "curvature",
            title: Text::new("Second derivative", "Segunda derivada"),
            caption: Text::new(
                "A jump of the slope is a spike here, as high as it is sharp: eight pixels of 4096 wide.",
                "Um salto da inclinação é aqui um pico, tão alto quanto é agudo: oito pixels de 4096 de largura.",
            ),
            x: x(),
            y: Scale::linear(Text::new("d²Y/dx², per radius²", "d²Y/dx², por raio²")),
            curves: three(&second),
        },
    ]
}
