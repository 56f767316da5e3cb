//! Pictures of the cylinder, and luminance across it with its derivatives.

use super::super::stage::map;
use super::super::{ArtefactError, Chart, Curve, Drawn, Language, Moved, Scale, Shot, Text};
use super::texts::TEXTS;
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
    let drawn_gouraud = TEXTS.get("gouraud-shading-same");
    let drawn_phong = TEXTS.get("phong-shading-same");
    let bands = TEXTS.get("bands-stand-edges");
    let less = TEXTS.get("slopes-jump-less");
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
        TEXTS.get("flat-title"),
        [
            TEXTS.with(
                "flat-caption-flat-shading-facets",
                &[("from", (f64::from(tube.segments)).into()), ("value", light.0.into())],
            ),
            TEXTS.get("flat-caption-each-stands-out"),
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
            TEXTS.get("fine-caption-jumps-about-quarter"),
        ],
        fine.draw(square, light, worse.shading)?,
    );
    let exact = Shot::truth(
        "exact",
        TEXTS.get("exact-title"),
        TEXTS.get("exact-caption-cylinder-lit-every"),
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
            [bars(full), TEXTS.get("phong-80-jumps-title")],
            of_phong_80,
        ),
        shown.at_80.cured_shot(
            "gouraud-80-jumps",
            jumps("Gouraud"),
            [bars(full), TEXTS.get("gouraud-80-jumps-title")],
            of_gouraud_80,
        ),
        Shot::seen(
            "phong-80",
            TEXTS.get("phong-80-title"),
            TEXTS.get("phong-80-caption-light-off-direction"),
            phong_80,
        ),
        Shot::seen(
            "gouraud-80",
            TEXTS.get("gouraud-80-title"),
            TEXTS.get("gouraud-80-caption-same-light-facets"),
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
    let (from, to) = grazing.near_edges(GRAZING);
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
    TEXTS.with("shading-light-jumps", &[("shading", shading.into())])
}

fn bars(full: f64) -> Text {
    TEXTS.with("bars-edges-up", &[("full", full.into())])
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
    let luminance = TEXTS.get("light-flat-shading");
    let three = [(Text::same("Gouraud"), gouraud), (Text::same("Phong"), phong), (TEXTS.get("exact"), exact)];
    let mut charts = derivatives(["luminance", "slope", "curvature"], None, [luminance, slopes], &three);
    let steps = curve(TEXTS.get("flat-title"), flat, &Derivative::Zeroth);
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
        TEXTS.get("light-cylinder-luminance"),
        TEXTS.with("slope-facets-beside", &[("bad", at_80.bad.into()), ("cured", at_80.cured.into())]),
    ];
    let three = [(Text::same("Gouraud"), gouraud), (Text::same("Phong"), phong), (TEXTS.get("exact"), exact)];
    let of = TEXTS.get("light");
    let mut charts = derivatives(["luminance-80", "slope-80", "curvature-80"], Some(of), captions, &three);
    // Where the light ends, and far round, slopes jump more, but there it is no matter of the shading.
    let (from, to) = grazing.near_edges(GRAZING);
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
    let spike = TEXTS.get("slope-slope-slope");
    let all = [
        (
            Derivative::Zeroth,
            TEXTS.get("luminance-along-scanline"),
            luminance,
            TEXTS.get("linear-luminance-y"),
        ),
        (Derivative::First, TEXTS.get("first-derivative"), slope, TEXTS.get("dy-dx-per")),
        (Derivative::Second, TEXTS.get("second-derivative"), spike, TEXTS.get("d-y-dx")),
    ];
    let chart =
        |(name, (derivative, title, caption, y)): (&'static str, (Derivative, Text, Text, Text))| Chart {
            name,
            title: match &of {
                None => title,
                Some(of) => Text::each(|language| format!("{}, {}", title.get(language), of.get(language))),
            },
            caption,
            x: Scale::linear(TEXTS.get("axis-x-across-picture")),
            y: Scale::linear(y),
            curves: lines.iter().map(|(name, line)| curve(name.clone(), line, &derivative)).collect(),
        };
    names.into_iter().zip(all).map(chart).collect()
}
