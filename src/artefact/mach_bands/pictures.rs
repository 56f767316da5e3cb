//! Pictures of the cylinder, and luminance across it with its derivatives.

use super::super::{ArtefactError, Chart, Curve, Drawn, Role, Scale, Shot, Text};
use super::tube::{Profile, Tube};
use super::{GRAZING, Lines, Worse};
use crate::num::Degrees;
use crate::raster::{Image, Shading};

/// Of the tube, the finer one, and the one in grazing light.
pub(super) fn shots(
    size: u32,
    light: Degrees,
    [tube, fine, grazing]: [&Tube; 3],
    worse: &Worse,
) -> Result<Vec<Shot>, ArtefactError> {
    let square = [size; 2];
    let shot = |name, role, label, caption, image: Result<Image, ArtefactError>| {
        Ok::<_, ArtefactError>(Shot { name, role, label, caption, image: image? })
    };
    let is_gouraud_worse = worse.shading == Shading::Gouraud;
    let [(gouraud_role, in_gouraud), (phong_role, in_phong)] = match is_gouraud_worse {
        true => [
            (Role::Bad, Text::new("Bands stand at the edges.", "Há bandas nas arestas.")),
            (
                Role::Cured,
                Text::new(
                    "Phong's shading: slopes still jump, but less under this light.",
                    "O sombreamento de Phong: as inclinações ainda saltam, mas menos sob esta luz.",
                ),
            ),
        ],
        false => [
            (Role::Cured, Text::new("Under this light it jumps little.", "Sob esta luz ela salta pouco.")),
            (
                Role::Bad,
                Text::new(
                    "Phong's shading: under this light slopes jump more than with Gouraud's.",
                    "O sombreamento de Phong: sob esta luz as inclinações saltam mais do que no de Gouraud.",
                ),
            ),
        ],
    };
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
            gouraud_role,
            Text::same("Gouraud"),
            Text::each(|language| {
                let same = Text::new(
                    "Gouraud's shading of the same facets: luminance is continuous, its slope is not.",
                    "O sombreamento de Gouraud das mesmas facetas: a luminância é contínua, a inclinação não.",
                );
                format!("{} {}", same.get(language), in_gouraud.get(language))
            }),
            tube.draw(square, light, Shading::Gouraud),
        )?,
        shot("phong", phong_role, Text::same("Phong"), in_phong, tube.draw(square, light, Shading::Phong))?,
        shot(
            "fine",
            Role::Cured,
            Text::made(
                format!("{}, {} segments", worse.name, fine.segments),
                format!("{}, {} segmentos", worse.name, fine.segments),
            ),
            Text::made(
                format!(
                    "{}'s shading with four times the segments: jumps are a quarter of what they were.",
                    worse.name
                ),
                format!(
                    "O sombreamento de {} com quatro vezes mais segmentos: os saltos são um quarto do que eram.",
                    worse.name
                ),
            ),
            fine.draw(square, light, worse.shading),
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
                "The light 80° off the direction of view: Gouraud's shading is almost exact, for luminance is nearly linear across \
                 the picture. The one band is where the shadow begins, as on the cylinder itself.",
                "A luz a 80° da direção de visão: o sombreamento de Gouraud é quase exato, pois a luminância é quase linear ao \
                 longo da imagem. A única banda está onde começa a sombra, como no próprio cilindro.",
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

/// Luminance, its slope and its curvature.
pub(super) fn charts(lines: &Lines, is_gouraud_worse: bool) -> Vec<Chart> {
    let Lines { flat, gouraud, phong, exact } = lines;
    let slopes = match is_gouraud_worse {
        true => Text::new(
            "The slope of luminance: Gouraud's is constant on each facet and jumps at edges, Phong's jumps less.",
            "A inclinação da luminância: a de Gouraud é constante em cada faceta e salta nas arestas, a de Phong salta menos.",
        ),
        false => Text::new(
            "The slope of luminance: Gouraud's is constant on each facet and jumps at edges, Phong's jumps more.",
            "A inclinação da luminância: a de Gouraud é constante em cada faceta e salta nas arestas, a de Phong salta mais.",
        ),
    };
    let luminance = Text::new(
        "Flat shading has steps, Gouraud's is a polygon, Phong's is bent on each facet.",
        "O sombreamento plano tem degraus, o de Gouraud é uma poligonal, o de Phong é curvo em cada faceta.",
    );
    let three = [
        (Text::same("Gouraud"), gouraud),
        (Text::same("Phong"), phong),
        (Text::new("exact", "exato"), exact),
    ];
    let mut charts = derivatives(["luminance", "slope", "curvature"], None, [luminance, slopes], &three);
    let steps = curve(Text::new("flat", "plano"), flat, &Derivative::Zeroth);
    // Last, so that the others look alike in all plots.
    charts[0].curves.push(steps);
    charts
}

/// The same in grazing light, where Phong's jumps are the larger ones.
pub(super) fn charts_of_grazing_light(grazing: &Tube) -> Result<Vec<Chart>, ArtefactError> {
    let line = |shading| grazing.profile(GRAZING, shading);
    let lines = [line(Shading::Gouraud)?, line(Shading::Phong)?, line(Shading::Exact)?];
    let [gouraud, phong, exact] = &lines;
    let captions = [
        Text::new(
            "The light at 80°: the cylinder's luminance is nearly straight where it is lit, and so is Gouraud's. Phong's is bent.",
            "A luz a 80°: a luminância do cilindro é quase reta onde há luz, e a de Gouraud também. A de Phong é curva.",
        ),
        Text::new(
            "The slope of that: Phong's goes up and down on each facet and jumps back at edges, about twice as far as Gouraud's.",
            "A inclinação disso: a de Phong sobe e desce em cada faceta e salta de volta nas arestas, cerca de duas vezes mais que a de \
             Gouraud.",
        ),
    ];
    let three = [
        (Text::same("Gouraud"), gouraud),
        (Text::same("Phong"), phong),
        (Text::new("exact", "exato"), exact),
    ];
    let of = Text::new("light at 80°", "luz a 80°");
    Ok(derivatives(["luminance-80", "slope-80", "curvature-80"], Some(of), captions, &three))
}

/// Pixels between the samples that differences are taken of.
const STEP: usize = 32;

enum Derivative {
    Zeroth,
    First,
    Second,
}

fn curve(name: Text, line: &Profile, derivative: &Derivative) -> Curve {
    let unit = Profile::x(STEP) - Profile::x(0);
    let value = |values: &[f64], pixel: usize| {
        let at = |pixel: usize| values[pixel.min(values.len() - 1)];
        let (before, here, after) = (at(pixel.saturating_sub(STEP)), at(pixel), at(pixel + STEP));
        match derivative {
            Derivative::Zeroth => here,
            Derivative::First => (after - before) / (2.0 * unit),
            Derivative::Second => (after + before - 2.0 * here) / (unit * unit),
        }
    };
    Curve { name, drawn: Drawn::Curve, points: line.points(STEP, value) }
}

/// Some lines with their first and second derivatives. `of` stands behind each title.
fn derivatives(
    names: [&'static str; 3],
    of: Option<Text>,
    [luminance, slope]: [Text; 2],
    lines: &[(Text, &Profile)],
) -> Vec<Chart> {
    let spike = Text::new(
        "A jump of the slope is a spike here, as high as it is sharp: 32 pixels of 16 384 wide.",
        "Um salto da inclinação é aqui um pico, tão alto quanto é agudo: 32 pixels de 16 384 de largura.",
    );
    let all = [
        (
            Derivative::Zeroth,
            Text::new("Luminance along a scanline", "Luminância ao longo de uma linha de varredura"),
            luminance,
            Text::new("linear luminance Y", "luminância linear Y"),
        ),
        (
            Derivative::First,
            Text::new("First derivative", "Primeira derivada"),
            slope,
            Text::new("dY/dx, per radius", "dY/dx, por raio"),
        ),
        (
            Derivative::Second,
            Text::new("Second derivative", "Segunda derivada"),
            spike,
            Text::new("d²Y/dx², per radius²", "d²Y/dx², por raio²"),
        ),
    ];
    let chart =
        |(name, (derivative, title, caption, y)): (&'static str, (Derivative, Text, Text, Text))| Chart {
            name,
            title: match &of {
                None => title,
                Some(of) => Text::each(|language| format!("{}, {}", title.get(language), of.get(language))),
            },
            caption,
            x: Scale::linear(Text::new("x across the picture, in radii", "x ao longo da imagem, em raios")),
            y: Scale::linear(y),
            curves: lines.iter().map(|(name, line)| curve(name.clone(), line, &derivative)).collect(),
        };
    names.into_iter().zip(all).map(chart).collect()
}
