//! Phong's and Blinn's highlights.

use super::stage::{draw, front, light_at, linear, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters, Role,
    Scale, Setup, Shot, Text, Verdict,
};
use crate::metric::image_error;
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, RenderSettings, Shading, Shape};
use crate::shade::{Guards, Material, Reflectance, Reflection, blinn_exponent};
use crate::surface::{Primitive, Sphere};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "reflection-models",
    title: Text::new("Phong's highlight and Blinn's", "O brilho de Phong e o de Blinn"),
    claim: Text::new(
        "Blinn's half-vector gives about the highlight of Phong's mirrored ray, at less cost; with a different exponent, for the \
         angle at the half-vector is half of that at the mirrored ray.",
        "O vetor intermediário de Blinn dá mais ou menos o brilho do raio espelhado de Phong, a menor custo; com outro expoente, \
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
            notation: "(V·R)^n = cos(φ)^n ≈ cos(φ/2)^{4n} = (N·H)^{4n}",
            says: Text::new(
                "in the plane of L and V, φ the angle from the mirrored ray to the viewer",
                "no plano de L e V, φ o ângulo do raio espelhado ao observador",
            ),
        },
        Formula {
            notation: "\\frac{w_{across}}{w_{along}} ≈ \\frac{1}{cos(β/2)}",
            says: Text::new(
                "how much Phong's highlight on a sphere is stretched at right angles to the plane of L and V, β the angle between \
                 them; Blinn's is round",
                "quanto o brilho de Phong numa esfera se alonga na direção perpendicular ao plano de L e V, β o ângulo entre eles; o \
                 de Blinn é redondo",
            ),
        },
        Formula {
            notation: "I_{behind} = k_s sin(β/2)^n",
            says: Text::new(
                "Blinn's highlight at the border of light, N·L = 0: without a guard it goes on behind",
                "o brilho de Blinn na fronteira da luz, N·L = 0: sem guarda ele continua atrás",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Exponent],
    own_mesh: None,
    defaults: Parameters { exponent: 10.0, ..Parameters::USUAL },
    run,
    frame: None,
};

/// Light far round the sphere.
const GRAZING: Degrees = Degrees(120.0);
/// Light almost behind it.
const BEHIND: Degrees = Degrees(150.0);
/// The window's side; the sphere has the radius 1.
const WINDOW: f64 = 2.2;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, exponent, .. } = setup.parameters;
    let ball = |reflection, exponent, light, guards| ball(reflection, exponent, light, guards, size);
    let on = Guards::default();
    let off = Guards { highlight: false, ..on };
    let head_on = Degrees(0.0);
    let phong = ball(Reflection::Phong, exponent, head_on, on)?;
    let blinn = ball(Reflection::Blinn, exponent, head_on, on)?;
    let matched = ball(Reflection::Blinn, blinn_exponent(exponent), head_on, on)?;
    let largest =
        |image: &Image| Ok::<f64, ArtefactError>(image_error(image, &phong, 0.5)?.linear.max / 255.0);
    let (same, fourfold) = (largest(&blinn)?, largest(&matched)?);
    let law = |own: f64| {
        let difference = |k: u32| {
            let phi = f64::from(k) / 1e4 * std::f64::consts::FRAC_PI_2;
            (libm::pow(libm::cos(phi), exponent) - libm::pow(libm::cos(0.5 * phi), own)).abs()
        };
        (0..=10_000).map(difference).fold(0.0, f64::max)
    };
    let (grazing_phong, grazing_blinn) = (
        ball(Reflection::Phong, exponent, GRAZING, on)?,
        ball(Reflection::Blinn, blinn_exponent(exponent), GRAZING, on)?,
    );
    let (unguarded, guarded) =
        (ball(Reflection::Blinn, exponent, BEHIND, off)?, ball(Reflection::Blinn, exponent, BEHIND, on)?);
    let behind = behind(&unguarded);
    let radius = f64::from(size) / WINDOW;
    // Between pixel centres the difference of both powers changes by its slope, √n at most, times half a pixel.
    let pixel = 0.5 / radius * exponent.sqrt();
    let by_scan = Text::new(
        "the largest over φ, by a scan of 10 001 angles; half a pixel",
        "o maior em φ, por uma varredura de 10 001 ângulos; meio pixel",
    );
    // Half-widths in pixels are right to a tenth, as widths of some ten pixels are shares of.
    let aspect = |image: &Image| widths(image, GRAZING);
    let measures = vec![
        Measure::new(Text::new("same n: largest difference", "mesmo n: maior diferença"), "", same).expect(
            law(exponent),
            pixel * 0.5,
            by_scan.clone(),
        ),
        Measure::new(
            Text::new("Blinn with 4n: largest difference", "Blinn com 4n: maior diferença"),
            "",
            fourfold,
        )
        .expect(law(blinn_exponent(exponent)), 0.1 * law(blinn_exponent(exponent)) + 1e-5, by_scan),
        Measure::new(
            Text::new(
                "light at 120°: Phong's highlight, width across over width along",
                "luz a 120°: brilho de Phong, largura transversal sobre a longitudinal",
            ),
            "",
            aspect(&grazing_phong),
        )
        .expect(
            phong_aspect(exponent),
            0.05,
            Text::new(
                "half-widths at half height in closed form; 2 for narrow highlights. A tenth of a pixel",
                "meias larguras à meia altura em forma fechada; 2 para brilhos estreitos. Um décimo de pixel",
            ),
        ),
        Measure::new(
            Text::new(
                "light at 120°: Blinn's highlight, width across over width along",
                "luz a 120°: brilho de Blinn, largura transversal sobre a longitudinal",
            ),
            "",
            aspect(&grazing_blinn),
        )
        .expect(1.0, 0.05, Text::new("round; a tenth of a pixel", "redondo; um décimo de pixel")),
        Measure::new(
            Text::new(
                "light at 150°, no guard: brightest pixel that faces away from the light",
                "luz a 150°, sem guarda: pixel mais claro voltado para longe da luz",
            ),
            "",
            behind,
        )
        .expect(
            libm::pow(libm::sin(0.5 * Radians::from(BEHIND).0), exponent),
            2.0 * pixel,
            Text::new("sin(β/2)^n; half a pixel, seen at 60°", "sin(β/2)^n; meio pixel, visto a 60°"),
        ),
        Measure::new(
            Text::new("the same with the guard", "o mesmo com a guarda"),
            "",
            self::behind(&guarded),
        )
        .expect(0.0, 0.0, Text::new("nothing from behind", "nada por trás")),
    ];
    Ok(Outcome {
        verdict: Verdict::HoldsOnlyIf(Text::new(
            "Blinn's exponent is 4n and the light is near the direction of view. With the same n his highlight is twice as wide; at \
             grazing light Phong's is stretched where Blinn's stays round. Both need a guard against light from behind.",
            "o expoente de Blinn é 4n e a luz está perto da direção de visão. Com o mesmo n o seu brilho é duas vezes mais largo; com \
             luz rasante o de Phong se alonga onde o de Blinn fica redondo. Ambos precisam de guarda contra a luz por trás.",
        )),
        moved: Moved {
            name: Text::new(
                "largest difference from Phong's highlight",
                "maior diferença do brilho de Phong",
            ),
            unit: "",
            bad: same,
            cure: Text::new("four times the exponent", "expoente quatro vezes maior"),
            cured: fourfold,
        },
        measures,
        shots: vec![
            Shot::new(
                "phong",
                Role::Truth,
                Text::new("Phong, exponent n", "Phong, expoente n"),
                Text::new(
                    "Phong's highlight on a sphere, light and viewer in front.",
                    "O brilho de Phong numa esfera, luz e observador em frente.",
                ),
                phong,
            ),
            Shot::new(
                "blinn-same-n",
                Role::Bad,
                Text::new("Blinn, exponent n", "Blinn, expoente n"),
                Text::new(
                    "Blinn's with the same exponent: twice as wide.",
                    "O de Blinn com o mesmo expoente: duas vezes mais largo.",
                ),
                blinn,
            ),
            Shot::new(
                "blinn-4n",
                Role::Cured,
                Text::new("Blinn, exponent 4n", "Blinn, expoente 4n"),
                Text::new(
                    "Blinn's with four times the exponent: not to be told from Phong's.",
                    "O de Blinn com expoente quatro vezes maior: não se distingue do de Phong.",
                ),
                matched,
            ),
            Shot::new(
                "phong-grazing",
                Role::Bad,
                Text::new("Phong, light at 120°", "Phong, luz a 120°"),
                Text::new(
                    "Light from far round: Phong's highlight is drawn out up and down, twice as high as it should be for its width.",
                    "Luz vinda de trás do lado: o brilho de Phong se alonga para cima e para baixo, ao dobro.",
                ),
                grazing_phong,
            ),
            Shot::new(
                "blinn-grazing",
                Role::Cured,
                Text::new("Blinn 4n, light at 120°", "Blinn 4n, luz a 120°"),
                Text::new(
                    "Blinn's under the same light is a circle on the sphere.",
                    "O de Blinn sob a mesma luz é um círculo na esfera.",
                ),
                grazing_blinn,
            ),
            Shot::new(
                "behind",
                Role::Bad,
                Text::new("light behind, no guard", "luz atrás, sem guarda"),
                Text::new(
                    "The light is almost behind the sphere, yet the highlight spreads over its dark side.",
                    "A luz está quase atrás da esfera, mas o brilho se espalha pelo lado escuro.",
                ),
                unguarded,
            ),
            Shot::new(
                "behind-guarded",
                Role::Cured,
                Text::new("light behind, guard", "luz atrás, com guarda"),
                Text::new(
                    "With the guard N·L > 0 the highlight ends where the light does, at a hard edge.",
                    "Com a guarda N·L > 0 o brilho termina onde a luz termina, numa borda dura.",
                ),
                guarded,
            ),
        ],
        charts: vec![chart(exponent)],
        notes: vec![Text::new(
            "The lectures give one exponent for both models (exercise 1.6.19 differs most: 0 by Phong, 0.35 by Blinn). The guard \
             stops light from behind but leaves an edge, for neither model goes to 0 where N·L does.",
            "As aulas dão um só expoente aos dois modelos (o exercício 1.6.19 é o que mais difere: 0 com Phong, 0,35 com Blinn). A \
             guarda retém a luz por trás mas deixa uma borda, pois nenhum dos modelos vai a 0 junto com N·L.",
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

/// The brightest pixel with N·L < 0 under the light from behind.
fn behind(image: &Image) -> f64 {
    let size = f64::from(image.size[0]);
    let (sine, cosine) = libm::sincos(Radians::from(BEHIND).0);
    let place = |k: u32| ((f64::from(k) + 0.5) / size - 0.5) * WINDOW;
    let facing = |k: u32| {
        let (x, y) = (place(k % image.size[0]), place(k / image.size[0]));
        let square = 1.0 - x * x - y * y;
        (square > 0.0).then(|| x * sine + square.sqrt() * cosine)
    };
    let pixels = linear(image).iter().zip(0..).filter(|&(_, k)| facing(k).is_some_and(|light| light < 0.0));
    pixels.map(|(colour, _)| f64::from(colour[0])).fold(0.0, f64::max)
}

/// The width of the highlight across the plane of light and view over that along it, as angles on the sphere at half
/// height.
fn widths(image: &Image, light: Degrees) -> f64 {
    let (sine, cosine) = libm::sincos(0.5 * Radians::from(light).0);
    let size = f64::from(image.size[0]);
    let values = linear(image);
    // Between pixel centres, linearly.
    let at = |x: f64, y: f64| {
        let [x, y] = [x, -y].map(|c| (c / WINDOW + 0.5) * size - 0.5);
        let value = |dx: f64, dy: f64| {
            let index = image.index((x.floor() + dx) as u32, (y.floor() + dy) as u32);
            index.map_or(0.0, |i| f64::from(values[i][0]))
        };
        let (s, t) = (x - x.floor(), y - y.floor());
        (value(0.0, 0.0) * (1.0 - s) + value(1.0, 0.0) * s) * (1.0 - t)
            + (value(0.0, 1.0) * (1.0 - s) + value(1.0, 1.0) * s) * t
    };
    // The angle at which half height is reached, by halving.
    let half = |value: &dyn Fn(f64) -> f64| {
        let (mut low, mut high) = (0.0, 0.5);
        for _ in 0..30 {
            let middle = 0.5 * (low + high);
            if value(middle) > 0.5 { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    // Towards the viewer, where the sphere is seen less from the side.
    let along = half(&|t| at(sine * libm::cos(t) - cosine * libm::sin(t), 0.0));
    let across = half(&|t| at(sine * libm::cos(t), libm::sin(t)));
    across / along
}

/// The same in closed form for Phong: along, cos(2t) = q; across, 2 cos²(t) cos²(β/2) − cos β = q; q = 2^(−1/n).
fn phong_aspect(exponent: f64) -> f64 {
    let beta = Radians::from(GRAZING).0;
    let q = libm::pow(2.0, -1.0 / exponent);
    let half = libm::cos(0.5 * beta);
    libm::acos(((q + libm::cos(beta)) / (2.0 * half * half)).sqrt()) / (0.5 * libm::acos(q))
}

fn chart(exponent: f64) -> Chart {
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
        caption: Text::new(
            "Against the angle from mirrored ray to viewer: Blinn's with the same exponent is wide, with four times the exponent \
             its curve covers Phong's.",
            "Em função do ângulo do raio espelhado ao observador: o de Blinn com o mesmo expoente é largo; com expoente quatro vezes \
             maior a curva cobre a de Phong.",
        ),
        x: Scale::linear(Text::new("φ in degrees", "φ em graus")),
        y: Scale::linear(Text::new("highlight", "brilho")),
        curves: vec![
            curve(Text::new("Phong, exponent n", "Phong, expoente n"), Drawn::Curve, &|phi| {
                power(libm::cos(phi), exponent)
            }),
            curve(Text::new("Blinn, exponent n", "Blinn, expoente n"), Drawn::Curve, &|phi| {
                power(libm::cos(0.5 * phi), exponent)
            }),
            curve(Text::new("Blinn, exponent 4n", "Blinn, expoente 4n"), Drawn::Guide, &|phi| {
                power(libm::cos(0.5 * phi), blinn_exponent(exponent))
            }),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn highlights_differ_as_the_formulas_say() {
        for exponent in [10.0, 50.0] {
            let parameters = Parameters { size: 256, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            for measure in &outcome.measures {
                assert_ne!(measure.agrees(), Some(false), "{measure:?}");
            }
            // Present: a fifth of full light. Cured: ten times less.
            assert!(outcome.moved.bad > 0.2 && outcome.moved.factor() > 10.0, "{:?}", outcome.moved);
        }
    }

    /// Published: n = 10 and 4n differ by 0.01425 at most, n = 50 by 0.00273.
    #[test]
    fn fourfold_exponents_have_the_published_differences() {
        for (exponent, published) in [(10.0, 0.014_25), (50.0, 0.002_73)] {
            let parameters = Parameters { size: 200, exponent, ..EXPERIMENT.defaults };
            let outcome = EXPERIMENT.run(&Setup { parameters, mesh: None }).unwrap();
            let expected = outcome.measures[1].expected.as_ref().unwrap().value;
            assert!((expected - published).abs() < 5e-6, "{expected}");
        }
    }
}
