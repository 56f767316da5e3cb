//! Pictures of the cylinder, and luminance across it with its derivatives.

use super::super::stage::map;
use super::super::{ArtefactError, Chart, Curve, Drawn, Language, Moved, Scale, Shot, Text};
use super::tube::{Profile, Tube, WINDOW};
use super::{GRAZING, Lines, Shown};
use crate::num::Degrees;
use crate::raster::{Image, Shading};

/// Of the tube, the finer one, and the one in grazing light.
pub(super) fn shots(
    size: u32,
    light: Degrees,
    [tube, fine, grazing]: [&Tube; 3],
    shown: &Shown,
) -> Result<Vec<Shot>, ArtefactError> {
    let square = [size; 2];
    let worse = shown.worse;
    let drawn_gouraud = Text::new(
        "Gouraud's shading of the same facets: luminance is continuous, its slope is not.",
        "O sombreamento de Gouraud das mesmas facetas: a luminância é contínua, a inclinação não.",
    );
    let drawn_phong = Text::new(
        "Phong's shading of the same facets: luminance is bent on each of them.",
        "O sombreamento de Phong das mesmas facetas: a luminância é curva em cada uma.",
    );
    let bands = Text::new("Bands stand at the edges.", "Há bandas nas arestas.");
    let less = Text::new(
        "Slopes jump less under this light than with the other shading.",
        "As inclinações saltam menos sob esta luz do que no outro sombreamento.",
    );
    let [gouraud, phong] =
        [Shading::Gouraud, Shading::Phong].map(|shading| tube.draw(square, light, shading));
    let (gouraud, phong) = (gouraud?, phong?);
    let [of_gouraud, of_phong] = [Text::same("Gouraud"), Text::same("Phong")];
    let other = &shown.other;
    let both = match worse.shading {
        Shading::Gouraud => [
            other.bad_shot("gouraud", of_gouraud, [drawn_gouraud, bands], gouraud),
            other.cured_shot("phong", of_phong, [drawn_phong, less], phong),
        ],
        _ => [
            other.cured_shot("gouraud", of_gouraud, [drawn_gouraud, less], gouraud),
            other.bad_shot("phong", of_phong, [drawn_phong, bands], phong),
        ],
    };
    let flat = shown.step.bad_shot(
        "flat",
        Text::new("flat", "plano"),
        [
            Text::with(
                "Flat shading of {} facets, the light {}° off the direction of view: one luminance for each facet.",
                "Sombreamento plano de {} facetas, a luz a {}° da direção de visão: uma luminância para cada faceta.",
                &[f64::from(tube.segments), light.0],
            ),
            Text::new(
                "Each stands out as a stripe of one grey.",
                "Cada uma se destaca como uma faixa de um só cinza.",
            ),
        ],
        tube.draw(square, light, Shading::Flat)?,
    );
    let finer = shown.finer.cured_shot(
        "fine",
        Text::made(
            format!("{}, {} segments", worse.name, fine.segments),
            format!("{}, {} segmentos", worse.name, fine.segments),
        ),
        [
            Text::made(
                format!("{}'s shading with four times the segments.", worse.name),
                format!("O sombreamento de {} com quatro vezes mais segmentos.", worse.name),
            ),
            Text::new(
                "Jumps are about a quarter of what they were.",
                "Os saltos são cerca de um quarto do que eram.",
            ),
        ],
        fine.draw(square, light, worse.shading)?,
    );
    let exact = Shot::truth(
        "exact",
        Text::new("the cylinder itself", "o próprio cilindro"),
        Text::new(
            "The cylinder lit at every pixel with its own normal: no bands but where the light ends.",
            "O cilindro iluminado em cada pixel com a sua própria normal: sem bandas senão onde a luz acaba.",
        ),
        tube.draw(square, light, Shading::Exact)?,
    );
    let [gouraud_80, phong_80] =
        [Shading::Gouraud, Shading::Phong].map(|shading| grazing.draw(square, GRAZING, shading));
    let (gouraud_80, phong_80) = (gouraud_80?, phong_80?);
    let full = shown.at_80.bad.max(shown.at_80.cured);
    let [of_phong_80, of_gouraud_80] =
        shown.jumps_at_80.each_ref().map(|jumps| jump_map(&phong_80, grazing, jumps, full));
    let of_80 = vec![
        shown.at_80.bad_shot(
            "phong-80-jumps",
            jumps("Phong"),
            [
                bars(full),
                Text::new(
                    "The slope of Phong's luminance jumps more.",
                    "A inclinação da luminância de Phong salta mais.",
                ),
            ],
            of_phong_80,
        ),
        shown.at_80.cured_shot(
            "gouraud-80-jumps",
            jumps("Gouraud"),
            [
                bars(full),
                Text::new(
                    "Gouraud's shading has the smaller jumps here.",
                    "O sombreamento de Gouraud tem aqui os saltos menores.",
                ),
            ],
            of_gouraud_80,
        ),
        Shot::seen(
            "phong-80",
            Text::new("Phong, light at 80°", "Phong, luz a 80°"),
            Text::new(
                "The light 80° off the direction of view, Phong's shading. Luminance bends within each facet; the jumps of its slope, \
                 which the map shows, are hardly seen.",
                "A luz a 80° da direção de visão, sombreamento de Phong. A luminância se curva dentro de cada faceta; os saltos da sua \
                 inclinação, que o mapa mostra, quase não se veem.",
            ),
            phong_80,
        ),
        Shot::seen(
            "gouraud-80",
            Text::new("Gouraud, light at 80°", "Gouraud, luz a 80°"),
            Text::new(
                "The same light: where facets are lit as a whole, luminance is nearly linear across the picture.",
                "A mesma luz: onde as facetas estão iluminadas por inteiro, a luminância é quase linear ao longo da imagem.",
            ),
            gouraud_80,
        ),
    ];
    let [gouraud, phong] = both;
    let mut shots = vec![flat, gouraud, phong, finer, exact];
    shots.extend(of_80);
    Ok(shots)
}

/// Half the width of the bars in maps of jumps, in pixels.
const HALF_BAR: f64 = 2.5;

/// Where the slope jumps at 80°: a bar at each edge that is measured, as light as the jump is large. Facets beside which nothing is
/// measured are left out.
fn jump_map(drawn: &Image, grazing: &Tube, jumps: &[[f64; 2]], full: f64) -> Image {
    let pixel = WINDOW / f64::from(drawn.size[0]);
    let (from, to) = grazing.beside_edges(GRAZING);
    let column = |index: usize| (index as u32 % drawn.size[0], drawn.coverage[index] > 0);
    let value = |(column, is_covered): (u32, bool)| {
        let x = (f64::from(column) + 0.5) * pixel - 0.5 * WINDOW;
        let here = jumps.iter().filter(|[at, _]| (x - at).abs() < HALF_BAR * pixel);
        (is_covered && (from..to).contains(&x)).then(|| here.map(|jump| jump[1]).fold(0.0, f64::max))
    };
    let values: Vec<Option<f64>> = (0..drawn.coverage.len()).map(|index| value(column(index))).collect();
    map(drawn.size, &values, full.max(f64::MIN_POSITIVE))
}

fn jumps(shading: &str) -> Text {
    Text::made(
        format!("{shading}, light at 80°: jumps of the slope"),
        format!("{shading}, luz a 80°: saltos da inclinação"),
    )
}

fn bars(full: f64) -> Text {
    Text::with(
        "Bars at the edges up to 60° round whose facets are lit all over, as light as the slope jumps there: violet 0, yellow {}. What \
         is not measured is left out.",
        "Barras nas arestas até 60° cujas facetas estão iluminadas por inteiro, tanto mais claras quanto mais a inclinação salta ali: \
         violeta 0, amarelo {}. O que não se mede fica de fora.",
        &[full],
    )
}

/// Luminance, its slope and its curvature.
pub(super) fn charts(lines: &Lines, shown: &Shown) -> Vec<Chart> {
    let Lines { flat, gouraud, phong, exact } = lines;
    let (moved, name) = (&shown.other, shown.worse.name);
    let other = if shown.worse.shading == Shading::Gouraud { "Phong" } else { "Gouraud" };
    let slopes = Text::each(|language| {
        let [bad, cured] = [moved.bad, moved.cured].map(|jump| language.short(jump, ""));
        match language {
            Language::English => format!(
                "The slope of luminance: Gouraud's is constant on each facet that is lit as a whole. {name}'s jumps at edges by up to \
                 {bad}, {other}'s by up to {cured}."
            ),
            Language::Portuguese => format!(
                "A inclinação da luminância: a de Gouraud é constante em cada faceta iluminada por inteiro. A de {name} salta nas arestas \
                 até {bad}, a de {other} até {cured}."
            ),
        }
    });
    let luminance = Text::new(
        "Where there is light, flat shading has steps, Gouraud's is a polygon, Phong's is bent on each facet.",
        "Onde há luz, o sombreamento plano tem degraus, o de Gouraud é uma poligonal, o de Phong é curvo em cada faceta.",
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
pub(super) fn charts_of_grazing_light(grazing: &Tube, at_80: &Moved) -> Result<Vec<Chart>, ArtefactError> {
    let line = |shading| grazing.profile(GRAZING, shading);
    let lines = [line(Shading::Gouraud)?, line(Shading::Phong)?, line(Shading::Exact)?];
    let [gouraud, phong, exact] = &lines;
    let captions = [
        Text::new(
            "The light at 80°: the cylinder's luminance is nearly straight where it is lit, and so is Gouraud's. Phong's is bent.",
            "A luz a 80°: a luminância do cilindro é quase reta onde há luz, e a de Gouraud também. A de Phong é curva.",
        ),
        Text::with(
            "The slope of that, on the facets beside the edges that are measured: Phong's goes up and down on each facet and jumps back \
             at edges, by up to {}; Gouraud's jumps by up to {}.",
            "A inclinação disso, nas facetas junto às arestas medidas: a de Phong sobe e desce em cada faceta e salta de volta nas \
             arestas, até {}; a de Gouraud salta até {}.",
            &[at_80.bad, at_80.cured],
        ),
    ];
    let three = [
        (Text::same("Gouraud"), gouraud),
        (Text::same("Phong"), phong),
        (Text::new("exact", "exato"), exact),
    ];
    let of = Text::new("light at 80°", "luz a 80°");
    let mut charts = derivatives(["luminance-80", "slope-80", "curvature-80"], Some(of), captions, &three);
    // Where the light ends, and far round, slopes jump more, but there it is no matter of the shading.
    let (from, to) = grazing.beside_edges(GRAZING);
    let curves = charts.iter_mut().skip(1).flat_map(|chart| &mut chart.curves);
    curves.for_each(|curve| curve.points.retain(|[x, _]| (from..to).contains(x)));
    Ok(charts)
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
        "The slope of the slope: where the slope jumps there is a narrow spike, and the larger the jump the higher the spike.",
        "A inclinação da inclinação: onde a inclinação salta há um pico estreito, tanto mais alto quanto maior é o salto.",
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
