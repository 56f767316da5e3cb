//! Phong's and Blinn's highlights.

mod behind;
mod widths;

use super::stage::{draw, front, light_at, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters,
    Scale, Setup, Shot, Text, Threshold, Verdict,
};
use crate::metric::image_error;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, RenderSettings, Shading, Shape};
use crate::shade::{Guards, Material, Reflectance, Reflection, blinn_exponent};
use crate::surface::{Primitive, Sphere};
use behind::Behind;
use std::f64::consts::FRAC_PI_2;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "reflection-models",
    title: Text::new("Phong's highlight and Blinn's", "O brilho de Phong e o de Blinn"),
    claim: Text::new(
        "Blinn's half-vector gives about the highlight of Phong's mirrored ray, but with a different exponent, for the \
         angle at the half-vector is half of that at the mirrored ray.",
        "O vetor intermediário de Blinn dá mais ou menos o brilho do raio espelhado de Phong, mas com outro expoente, \
         pois o ângulo ao vetor intermediário é a metade do ângulo ao raio espelhado.",
    ),
    sources: &[
        Text::new("Lectures: 1.3.1.2, 1.3.1.3, 1.6.19, 1.6.23", "Aulas: 1.3.1.2, 1.3.1.3, 1.6.19, 1.6.23"),
        Text::new("Ting 2008: “Phong modificado” (modified Phong)", "Ting 2008: “Phong modificado”"),
        Text::new(
            "Paper: F. Fisher, A. Woo, R·E versus N·H specular highlights, Graphics Gems IV, 1994",
            "Artigo: F. Fisher, A. Woo, R·E versus N·H specular highlights, Graphics Gems IV, 1994",
        ),
    ],
    formulas: &[
        Formula {
            notation: Text::same("(V·R)^n = cos(φ)^n ≈ cos(φ/2)^{4n} = (N·H)^{4n}"),
            says: Text::new(
                "in the plane of L and V, φ the angle from the mirrored ray to the viewer",
                "no plano de L e V, φ o ângulo do raio espelhado ao observador",
            ),
        },
        Formula {
            notation: Text::new(
                "\\frac{w_{across}}{w_{along}} ≈ \\frac{1}{cos(β/2)}",
                "\\frac{w_{transversal}}{w_{longitudinal}} ≈ \\frac{1}{cos(β/2)}",
            ),
            says: Text::new(
                "how much Phong's highlight on a sphere is stretched at right angles to the plane of L and V, β the angle between \
                 them; Blinn's is round",
                "quanto o brilho de Phong numa esfera se alonga na direção perpendicular ao plano de L e V, β o ângulo entre eles; o \
                 de Blinn é redondo",
            ),
        },
        Formula {
            notation: Text::new("I_{behind} = k_s sin(β/2)^n", "I_{trás} = k_s sin(β/2)^n"),
            says: Text::new(
                "Blinn's highlight at the border of light, N·L = 0: without a guard it goes on behind",
                "o brilho de Blinn na fronteira da luz, N·L = 0: sem guarda ele continua atrás",
            ),
        },
        Formula {
            notation: Text::new("I_{behind} = k_s (−cos(β))^n", "I_{trás} = k_s (−cos(β))^n"),
            says: Text::new(
                "the same of Phong's, where the light is behind at all, β > 90°",
                "o mesmo do de Phong, onde a luz está de fato atrás, β > 90°",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Exponent],
    own_mesh: None,
    segments: Parameters::SEGMENTS,
    shown_by: Text::new(
        "a highlight of some pixels (exponents from 1 to 100, or a larger picture) would show it.",
        "um brilho de alguns pixels (expoentes de 1 a 100, ou uma imagem maior) o mostraria.",
    ),
    defaults: Parameters { exponent: 10.0, ..Parameters::USUAL },
    run,
    frame: None,
};

/// Light far round the sphere.
const GRAZING: Degrees = Degrees(120.0);
/// How many times nearer to Phong's highlight four times the exponent has to be.
const FACTOR: f64 = 5.0;
/// The window's side; the sphere has the radius 1.
const WINDOW: f64 = 2.2;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, exponent, .. } = setup.parameters;
    let ball = |reflection, exponent, light, guards| ball(reflection, exponent, light, guards, size);
    let on = Guards::default();
    let head_on = Degrees(0.0);
    let phong = ball(Reflection::Phong, exponent, head_on, on)?;
    let blinn = ball(Reflection::Blinn, exponent, head_on, on)?;
    let matched = ball(Reflection::Blinn, blinn_exponent(exponent), head_on, on)?;
    let largest =
        |image: &Image| Ok::<f64, ArtefactError>(image_error(image, &phong, 0.5)?.linear.max / 255.0);
    let (same, fourfold) = (largest(&blinn)?, largest(&matched)?);
    let law = |own: f64| {
        let difference = |k: u32| {
            let phi = f64::from(k) / 1e4 * std::f64::consts::PI;
            // Mirrored away from the viewer there is nothing, whatever the exponent.
            let phong = if phi < FRAC_PI_2 { libm::pow(libm::cos(phi), exponent) } else { 0.0 };
            (phong - libm::pow(libm::cos(0.5 * phi), own)).abs()
        };
        (0..=10_000).map(difference).fold(0.0, f64::max)
    };
    let (grazing_phong, grazing_blinn) = (
        ball(Reflection::Phong, exponent, GRAZING, on)?,
        ball(Reflection::Blinn, blinn_exponent(exponent), GRAZING, on)?,
    );
    let radius = f64::from(size) / WINDOW;
    // Half a pixel turns the normal by 1/R over the cosine of its angle to the viewer, and the mirrored ray by twice that. Powers
    // change by √n of it at most, and by 1 for the smallest n.
    let pixel = 0.5 / radius * 2.0 * exponent.sqrt().max(1.0);
    let by_scan = Text::new(
        "the largest over φ, by a scan of 10\u{a0}001 angles; half a pixel",
        "o maior em φ, por uma varredura de 10\u{a0}001 ângulos; meio pixel",
    );
    let compared = |measure: Measure, law: f64, tolerance: f64| match pixel < 0.5 {
        true => measure.expect(law, tolerance, by_scan.clone()),
        false => measure.beyond(Text::new(
            "the highlight is hardly wider than a pixel",
            "o brilho mal é mais largo que um pixel",
        )),
    };
    let [across_phong, across_blinn] = [
        widths::measure(
            Text::new(
                "light at 120°: Phong's highlight, width across over width along",
                "luz a 120°: brilho de Phong, largura transversal sobre a longitudinal",
            ),
            &grazing_phong,
            widths::of_phong(exponent),
            widths::phong_at(exponent),
            Text::new(
                "half-widths at half height in closed form; 2 for narrow highlights",
                "meias larguras à meia altura em forma fechada; 2 para brilhos estreitos",
            ),
        ),
        widths::measure(
            Text::new(
                "light at 120°: Blinn's highlight, width across over width along",
                "luz a 120°: brilho de Blinn, largura transversal sobre a longitudinal",
            ),
            &grazing_blinn,
            widths::of_blinn(blinn_exponent(exponent)),
            widths::blinn_at(blinn_exponent(exponent)),
            Text::new("round", "redondo"),
        ),
    ];
    // Where widths cannot be told nothing is said of them.
    let stretch = |measure: &Measure| match measure.beyond {
        None => (measure.value - 1.0).abs(),
        Some(_) => 0.0,
    };
    let moved = Moved {
        name: Text::new("largest difference from Phong's highlight", "maior diferença do brilho de Phong"),
        unit: "",
        bad: same,
        present: Threshold::HALF_STEP,
        cure: Text::new("four times the exponent", "expoente quatro vezes maior"),
        cured: fourfold,
        factor: FACTOR,
    };
    let stretched = Moved {
        name: match across_phong.beyond.is_none() && across_blinn.beyond.is_none() {
            true => Text::new(
                "width across over width along, less 1",
                "largura transversal sobre a longitudinal, menos 1",
            ),
            false => Text::new(
                "width across over width along, less 1, where both can be told",
                "largura transversal sobre a longitudinal, menos 1, onde ambas se podem medir",
            ),
        },
        bad: stretch(&across_phong),
        present: Threshold {
            value: 0.1, why: Text::new("a tenth of its width", "um décimo da sua largura")
        },
        cured: stretch(&across_blinn),
        ..moved.clone()
    };
    let [phong_behind, blinn_behind] = [Reflection::Phong, Reflection::Blinn]
        .map(|reflection| Behind::new(reflection, exponent, size, &moved));
    let (phong_behind, blinn_behind) = (phong_behind?, blinn_behind?);
    let mut measures = vec![
        compared(
            Measure::new(Text::new("same n: largest difference", "mesmo n: maior diferença"), "", same),
            law(exponent),
            0.5 * pixel,
        ),
        compared(
            Measure::new(
                Text::new("Blinn with 4n: largest difference", "Blinn com 4n: maior diferença"),
                "",
                fourfold,
            ),
            law(blinn_exponent(exponent)),
            // Near its largest the difference is flat; where powers are steep it is not.
            (0.1 * law(blinn_exponent(exponent)) + 1e-5).max(if exponent < 2.0 { 0.5 * pixel } else { 0.0 }),
        ),
        across_phong,
        across_blinn,
    ];
    measures.extend(phong_behind.measures());
    measures.extend(blinn_behind.measures());
    Ok(Outcome {
        verdict: verdict(&moved),
        shots: [vec![
            Shot::truth(
                "phong",
                Text::new("Phong, exponent n", "Phong, expoente n"),
                Text::with(
                    "Phong's highlight on a sphere, light and viewer in front; n = {}.",
                    "O brilho de Phong numa esfera, luz e observador em frente; n = {}.",
                    &[exponent],
                ),
                phong,
            ),
            moved.bad_shot(
                "blinn-same-n",
                Text::new("Blinn, exponent n", "Blinn, expoente n"),
                [
                    Text::new("Blinn's with the same exponent.", "O de Blinn com o mesmo expoente."),
                    Text::with(
                        "It is wider: at half its height where the normal is {}° off the viewer, Phong's at {}°.",
                        "É mais largo: à meia altura onde a normal está a {}° do observador, o de Phong a {}°.",
                        &widths::in_front(exponent),
                    ),
                ],
                blinn,
            ),
            moved.cured_shot(
                "blinn-4n",
                Text::new("Blinn, exponent 4n", "Blinn, expoente 4n"),
                [
                    Text::new(
                        "Blinn's with four times the exponent.",
                        "O de Blinn com expoente quatro vezes maior.",
                    ),
                    Text::new("It is much closer to Phong's.", "Fica muito mais perto do de Phong."),
                ],
                matched,
            ),
            stretched.bad_shot(
                "phong-grazing",
                Text::new("Phong, light at 120°", "Phong, luz a 120°"),
                [
                    Text::with(
                        "Light from far round, n = {}.",
                        "Luz vinda de trás e de lado, n = {}.",
                        &[exponent],
                    ),
                    Text::new(
                        "Here it is Phong's highlight that errs: it is drawn out up and down, across the plane of light and view, as \
                         real rough surfaces do not show it.",
                        "Aqui é o brilho de Phong que erra: ele se alonga para cima e para baixo, através do plano da luz e da visão, \
                         como superfícies ásperas reais não o mostram.",
                    ),
                ],
                grazing_phong,
            ),
            stretched.cured_shot(
                "blinn-grazing",
                Text::new("Blinn 4n, light at 120°", "Blinn 4n, luz a 120°"),
                [
                    Text::with(
                        "Blinn's under the same light, with 4n = {}.",
                        "O de Blinn sob a mesma luz, com 4n = {}.",
                        &[blinn_exponent(exponent)],
                    ),
                    Text::new(
                        "It is a circle on the sphere, cut where the sphere turns away from the light.",
                        "É um círculo na esfera, cortado onde a esfera se vira para longe da luz.",
                    ),
                ],
                grazing_blinn,
            ),
        ], phong_behind.shots().into(), blinn_behind.shots().into()].concat(),
        charts: vec![chart(exponent, moved.is_cured())],
        moved,
        measures,
        notes: vec![Text::new(
            "The lectures (1.6.19) give both models one exponent, though with the same one Blinn's highlight is wider; Ting 2008 gives \
             Blinn's one of its own. The guard stops light from behind but leaves an edge, for neither model goes to 0 where N·L \
             does.",
            "As aulas (1.6.19) dão aos dois modelos um só expoente, embora com o mesmo o brilho de Blinn seja mais largo; Ting 2008 dá \
             ao de Blinn um expoente próprio. A guarda retém a luz por trás mas deixa uma borda, pois nenhum dos modelos vai a 0 junto com \
             N·L.",
        )],
    })
}

/// The true sphere with nothing but a highlight.
fn ball(
    reflection: Reflection,
    exponent: f64,
    light: Degrees,
    guards: Guards,
    size: u32,
) -> Result<Image, ArtefactError> {
    let material = Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::NONE,
        specular: Reflectance::Merged(LinearRgb::WHITE),
        exponent,
        reflection,
    };
    let sphere = Object::new(Shape::Surface(Primitive::from(Sphere::default())), material);
    let settings =
        RenderSettings { guards, ..settings([size; 2], Shading::Exact, Interpolation::Perspective) };
    draw(vec![sphere], &[light_at(light)], front(WINDOW), &settings)
}

/// By whether four times the exponent brings Blinn's highlight to Phong's.
fn verdict(moved: &Moved) -> Verdict {
    match moved.is_cured() {
        true => Verdict::HoldsOnlyIf(Text::new(
            "Blinn's exponent is 4n and the light is near the direction of view. With the same n his highlight is twice as wide; at \
             grazing light Phong's is stretched where Blinn's stays round. Both need a guard against light from behind.",
            "o expoente de Blinn é 4n e a luz está perto da direção de visão. Com o mesmo n o seu brilho é duas vezes mais largo; com \
             luz rasante o de Phong se alonga onde o de Blinn fica redondo. Ambos precisam de guarda contra a luz por trás.",
        )),
        false => Verdict::Fails(Text::new(
            "with so small an exponent no other one makes both alike: cos(φ)^n and cos(φ/2)^4n agree near φ = 0, and this highlight \
             is as wide as the sphere.",
            "com um expoente tão pequeno nenhum outro iguala os dois: cos(φ)^n e cos(φ/2)^4n concordam perto de φ = 0, e este \
             brilho é tão largo quanto a esfera.",
        )),
    }
}

fn chart(exponent: f64, is_covered: bool) -> Chart {
    let curve = |name, drawn, value: &dyn Fn(f64) -> f64| Curve {
        name,
        drawn,
        points: (0..=180)
            .map(|k| {
                let degrees = f64::from(k) * 0.5;
                [degrees, value(Radians::from(Degrees(degrees)).0)]
            })
            .collect(),
    };
    let power = |cosine: f64, n: f64| libm::pow(cosine, n);
    Chart {
        name: "highlights",
        title: Text::new("Height of the highlight", "Altura do brilho"),
        caption: match is_covered {
            true => Text::new(
                "Against the angle from mirrored ray to viewer: Blinn's with the same exponent is wide, with four times the exponent \
                 its curve comes close to Phong's.",
                "Em função do ângulo do raio espelhado ao observador: o de Blinn com o mesmo expoente é largo; com expoente quatro \
                 vezes maior a curva se aproxima da de Phong.",
            ),
            false => Text::new(
                "Against the angle from mirrored ray to viewer: with so small an exponent Blinn's curve leaves Phong's, with four times \
                 the exponent too.",
                "Em função do ângulo do raio espelhado ao observador: com um expoente tão pequeno a curva de Blinn se afasta da de \
                 Phong, também com expoente quatro vezes maior.",
            ),
        },
        x: Scale::linear(Text::new("φ in degrees", "φ em graus")),
        y: Scale::linear(Text::new("highlight", "brilho")),
        curves: vec![
            curve(Text::new("Phong, exponent n", "Phong, expoente n"), Drawn::Curve, &|phi| {
                power(libm::cos(phi), exponent)
            }),
            curve(Text::new("Blinn, exponent n", "Blinn, expoente n"), Drawn::Curve, &|phi| {
                power(libm::cos(0.5 * phi), exponent)
            }),
            curve(Text::new("Blinn, exponent 4n", "Blinn, expoente 4n"), Drawn::Curve, &|phi| {
                power(libm::cos(0.5 * phi), blinn_exponent(exponent))
            }),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::artefact::Range;

    #[test]
    fn highlights_differ_as_the_formulas_say() {
        for exponent in [10.0, 50.0] {
            let parameters = Parameters { size: 256, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            outcome.prove();
            // Present: a fifth of full light. Cured: ten times less.
            assert!(outcome.moved.bad > 0.2 && outcome.moved.reduction() > 10.0, "{:?}", outcome.moved);
        }
    }

    /// Published: n = 10 and 4n differ by 0.01425 at most, n = 50 by 0.00273.
    #[test]
    fn fourfold_exponents_have_the_published_differences() {
        for (exponent, published) in [(10.0, 0.014_25), (50.0, 0.002_73)] {
            let parameters = Parameters { size: 200, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            let Some(Range::Near { value, .. }) = outcome.measures[1].expected.as_ref().map(|law| law.range)
            else {
                panic!("{:?}", outcome.measures[1]);
            };
            assert!((value - published).abs() < 5e-6, "{value}");
            let found = outcome.measured("Blinn with 4n");
            assert!((found - published).abs() < 1e-4, "{found}");
        }
    }

    /// A constant highlight is cut off where the mirrored ray turns away, which no exponent of Blinn's does.
    #[test]
    fn small_exponents_have_no_match() {
        for (exponent, fails) in [(0.0, true), (1.0, true), (3.0, false)] {
            let parameters = Parameters { size: 64, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            assert_eq!(
                matches!(outcome.verdict, Verdict::Fails(_)),
                fails,
                "{exponent}: {:?}",
                outcome.moved
            );
        }
    }

    /// Highlights of small exponents come so near to the outline that straight lines between pixels reach beyond it.
    #[test]
    fn widths_agree_near_the_outline() {
        for size in [46, 50, 58, 65, 70, 85, 86, 128] {
            for exponent in [2.0, 3.0, 8.0] {
                let parameters = Parameters { size, exponent, ..EXPERIMENT.defaults };
                let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
                for measure in &outcome.measures {
                    assert_ne!(measure.agrees(), Some(false), "{size} {exponent}: {measure:?}");
                }
            }
        }
    }
}
