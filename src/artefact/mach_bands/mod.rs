//! Mach bands on a cylinder: steps of flat shading, slope jumps of Gouraud's and Phong's.

mod pictures;
mod predicted;
mod tube;

use super::{
    ArtefactError, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters, Setup, Text, Verdict,
};
use crate::num::{Degrees, Radians};
use crate::raster::Shading;
use tube::{Found, Profile, Tube};

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "mach-bands",
    title: Text::new("Mach bands on a cylinder", "Bandas de Mach num cilindro"),
    claim: Text::new(
        "Mach bands are worse with Gouraud's shading than with Phong's.",
        "As bandas de Mach são piores no sombreamento de Gouraud do que no de Phong.",
    ),
    sources: &[
        Text::new("Lectures: Table 1, 1.6.13, 1.6.46, 1.6.50", "Aulas: Tabela 1, 1.6.13, 1.6.46, 1.6.50"),
        Text::new(
            "Against it: T. Duff, Smoothly shaded renderings of polyhedral objects on raster displays, SIGGRAPH 1979",
            "Em contrário: T. Duff, Smoothly shaded renderings of polyhedral objects on raster displays, SIGGRAPH 1979",
        ),
    ],
    formulas: &[
        Formula {
            notation: "ΔI_{flat} = 2 |sin(θ − θ_L)| sin(Δ/2)",
            says: Text::new(
                "the step between two flat facets whose common edge is at the angle θ; Δ = 2π/N",
                "o degrau entre duas facetas planas cuja aresta comum está no ângulo θ; Δ = 2π/N",
            ),
        },
        Formula {
            notation: "ΔI′_{Gouraud} = −cos(θ_L) [tan(θ + Δ/2) − tan(θ − Δ/2)]",
            says: Text::new(
                "the jump of the slope across the picture at that edge",
                "o salto da inclinação, ao longo da imagem, nessa aresta",
            ),
        },
        Formula {
            notation: "\\frac{ΔI′_{Phong}}{ΔI′_{Gouraud}} = \\frac{sin(θ − θ_L) sin(θ)}{cos(θ_L)}",
            says: Text::new(
                "so Phong's is the larger one somewhere as soon as cos(θ_L) < 1/3: θ_L > 70.5288°",
                "portanto o de Phong é o maior em algum lugar assim que cos(θ_L) < 1/3: θ_L > 70,5288°",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    own_mesh: None,
    defaults: Parameters { segments: 16, light: Degrees(30.0), ..Parameters::USUAL },
    run,
    frame: None,
};

/// Where Phong's shading is the worse one.
const GRAZING: Degrees = Degrees(80.0);
/// How many times more segments the cured cylinder has.
const FINER: u32 = 4;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let tube = Tube::new(segments, 0.0)?;
    let lines = [Shading::Flat, Shading::Gouraud, Shading::Phong, Shading::Exact]
        .map(|shading| tube.profile(light, shading));
    let [flat, gouraud, phong, exact] = lines;
    let (flat, gouraud, phong, exact) = (flat?, gouraud?, phong?, exact?);
    let fine = Tube::new(FINER * segments, 0.0)?;
    let fine_line = fine.profile(light, Shading::Gouraud)?;

    let step = tube.largest(light, |theta| (flat.step(&tube, theta), flat_step(theta, light, tube.delta())));
    let of = |line: &Profile, law: Law| {
        tube.largest(light, |theta| (line.slope_jump(&tube, theta), law(theta, light, tube.delta())))
    };
    let (of_gouraud, of_phong) = (of(&gouraud, gouraud_jump), of(&phong, phong_jump));
    // At the same edges, which the finer one has too.
    let of_fine = tube.largest(light, |theta| {
        (fine_line.slope_jump(&fine, theta), gouraud_jump(theta, light, fine.delta()))
    });
    let worst = ratio(GRAZING, segments)?;
    let worst_law =
        phong_jump(half(GRAZING), GRAZING, tube.delta()) / gouraud_jump(half(GRAZING), GRAZING, tube.delta());
    let border = border(segments)?;
    let tolerance = slope_tolerance(segments);

    let jump = |name, of: Found, notation: Text| {
        Measure::new(name, "1/R", of.measured).expect(of.law, tolerance, notation)
    };
    let mut measures = vec![
        Measure::new(
            Text::new("flat: largest step of luminance", "plano: maior degrau de luminância"),
            "",
            step.measured,
        )
        .expect(
            step.law,
            1e-6,
            Text::new(
                "2 |sin(θ − θ_L)| sin(Δ/2); single precision",
                "2 |sin(θ − θ_L)| sin(Δ/2); precisão simples",
            ),
        ),
        jump(
            Text::new("Gouraud: largest slope jump", "Gouraud: maior salto de inclinação"),
            of_gouraud,
            Text::new(
                "−cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; rounding of samples over a tenth of a facet",
                "−cos θ_L [tan(θ + Δ/2) − tan(θ − Δ/2)]; arredondamento das amostras num décimo de faceta",
            ),
        ),
        jump(
            Text::new("Phong: largest slope jump", "Phong: maior salto de inclinação"),
            of_phong,
            Text::new(
                "−sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; as for Gouraud",
                "−sin(θ − θ_L) sin θ [tan(θ + Δ/2) − tan(θ − Δ/2)]; como em Gouraud",
            ),
        ),
        jump(
            Text::made(
                format!("Gouraud with {} segments: largest slope jump", FINER * segments),
                format!("Gouraud com {} segmentos: maior salto de inclinação", FINER * segments),
            ),
            of_fine,
            Text::new("the same with the smaller Δ", "o mesmo com o Δ menor"),
        ),
        Measure::new(
            Text::new(
                "light at 80°: slope jump of Phong over that of Gouraud at θ = 40°",
                "luz a 80°: salto de Phong sobre o de Gouraud em θ = 40°",
            ),
            "",
            worst,
        )
        .expect(
            worst_law,
            0.02,
            Text::new(
                "sin(θ − θ_L) sin θ / cos θ_L; 1 % of the smaller jump",
                "sin(θ − θ_L) sin θ / cos θ_L; 1 % do salto menor",
            ),
        ),
        Measure::new(
            Text::new(
                "the light's angle beyond which Phong has the larger jump",
                "ângulo da luz além do qual Phong tem o salto maior",
            ),
            "°",
            border.0,
        )
        .expect(
            70.528_779_365_509_31,
            0.1,
            Text::new(
                "arccos(1/3), found by halving in pictures; 0.7 % of a jump is 0.1°",
                "arccos(1/3), achado por bissecção em imagens; 0,7 % de um salto são 0,1°",
            ),
        ),
    ];
    measures.extend(predicted::measures(&tube, &fine, light)?);
    let mut charts = pictures::charts(&flat, &gouraud, &phong, &exact);
    charts.extend(predicted::charts(&tube, light)?);
    Ok(Outcome {
        verdict: Verdict::HoldsOnlyIf(Text::new(
            "the light is less than 70.5288° off the direction of view. Beyond that there are edges where Phong's slope \
             jump is the larger one; at 90° Gouraud's shading of facets lit as a whole is exact, and only Phong's has bands.",
            "a luz está a menos de 70,5288° da direção de visão. Além disso há arestas em que o salto de inclinação de \
             Phong é o maior; a 90° o sombreamento de Gouraud das facetas iluminadas por inteiro é exato, e só o de Phong \
             tem bandas.",
        )),
        moved: Moved {
            name: Text::new("Gouraud's largest slope jump", "o maior salto de inclinação de Gouraud"),
            unit: "1/R",
            bad: of_gouraud.measured,
            cure: Text::made(format!("{FINER} times the segments"), format!("{FINER} vezes mais segmentos")),
            cured: of_fine.measured,
        },
        measures,
        shots: pictures::shots(size, light, &tube, &fine)?,
        charts,
        notes: notes(),
    })
}

fn notes() -> Vec<Text> {
    vec![
        Text::new(
            "Where the slope of luminance jumps, the eye sees a dark line at the foot and a bright line at the knee, \
             though no pixel there is darker or brighter than its neighbours on both sides. Flat shading jumps in \
             luminance itself. Gouraud's and Phong's are continuous, but their slopes are not.",
            "Onde a inclinação da luminância salta, o olho vê uma linha escura no pé e uma clara no joelho, embora \
             nenhum pixel ali seja mais escuro ou mais claro que os vizinhos dos dois lados. O sombreamento plano salta na \
             própria luminância. Os de Gouraud e de Phong são contínuos, mas as suas inclinações não.",
        ),
        Text::new(
            "The overshoot called predicted is that of a difference of Gaussians, a model of lateral inhibition. It says where bands \
             may be seen and how they compare on one picture, not how strongly they are seen.",
            "O excesso chamado de previsto é o de uma diferença de gaussianas, um modelo da inibição lateral. Ele diz onde bandas podem \
             ser vistas e como se comparam numa imagem, não com que força são vistas.",
        ),
        Text::new(
            "Jumps are of first order in the width of a facet: four times the segments make them about a quarter.",
            "Os saltos são de primeira ordem na largura da faceta: quatro vezes mais segmentos os reduzem a cerca de um \
             quarto.",
        ),
    ]
}

/// The jump at an edge at the angle θ (radians) under a light, for facets of the angle Δ (radians).
type Law = fn(f64, Degrees, f64) -> f64;

fn flat_step(theta: f64, light: Degrees, delta: f64) -> f64 {
    2.0 * libm::sin(theta - Radians::from(light).0).abs() * libm::sin(delta / 2.0)
}

fn gouraud_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    -libm::cos(Radians::from(light).0) * (libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0))
}

fn phong_jump(theta: f64, light: Degrees, delta: f64) -> f64 {
    let bend = libm::tan(theta + delta / 2.0) - libm::tan(theta - delta / 2.0);
    -libm::sin(theta - Radians::from(light).0) * libm::sin(theta) * bend
}

/// Rounding of single-precision samples, 6·10⁻⁸, over a tenth of a facet with weights of up to 6, both sides; and
/// vertices that snap to 256ths of pixels. Measured at 16 segments: 10⁻⁴.
fn slope_tolerance(segments: u32) -> f64 {
    5e-4 * f64::from(segments.max(16)) / 16.0
}

fn half(Degrees(angle): Degrees) -> f64 {
    Radians::from(Degrees(angle / 2.0)).0
}

/// Phong's slope jump over Gouraud's at the edge where it is worst, half-way between the viewer and the light.
fn ratio(light: Degrees, segments: u32) -> Result<f64, ArtefactError> {
    let tube = Tube::new(segments, half(light))?;
    let jump = |shading| tube.profile(light, shading).map(|line| line.slope_jump(&tube, half(light)));
    Ok(jump(Shading::Phong)? / jump(Shading::Gouraud)?)
}

/// The angle of the light at which Phong's jump is as large as Gouraud's, by halving.
fn border(segments: u32) -> Result<Degrees, ArtefactError> {
    let (mut low, mut high) = (60.0, 80.0);
    for _ in 0..10 {
        let middle = 0.5 * (low + high);
        if ratio(Degrees(middle), segments)?.abs() > 1.0 { high = middle } else { low = middle }
    }
    Ok(Degrees(0.5 * (low + high)))
}

#[cfg(test)]
mod tests {
    use super::tube::slope_at;
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn every_edge_follows_its_closed_form() {
        for light in [Degrees(0.0), Degrees(30.0), Degrees(-45.0)] {
            let tube = Tube::new(16, 0.1).unwrap();
            let profile = |shading| tube.profile(light, shading).unwrap();
            let (gouraud, phong) = (profile(Shading::Gouraud), profile(Shading::Phong));
            let flat = profile(Shading::Flat);
            assert!(tube.edges(light).count() >= 3);
            for theta in tube.edges(light) {
                let near = |found: f64, law: f64, tolerance: f64| {
                    assert!((found - law).abs() <= tolerance, "{theta} {light:?}: {found} is not {law}");
                };
                near(
                    gouraud.slope_jump(&tube, theta),
                    gouraud_jump(theta, light, tube.delta()),
                    slope_tolerance(16),
                );
                near(
                    phong.slope_jump(&tube, theta),
                    phong_jump(theta, light, tube.delta()),
                    slope_tolerance(16),
                );
                near(flat.step(&tube, theta), flat_step(theta, light, tube.delta()), 1e-6);
            }
        }
    }

    /// Figures computed apart from this program: N = 16 at θ = 30° under a light from the viewer, and at −45° under one at
    /// −80°.
    #[test]
    fn closed_forms_have_their_published_values() {
        let delta = TAU / 16.0;
        let [theta, across] = [30.0, -45.0].map(|angle| Radians::from(Degrees(angle)).0);
        for (found, printed) in [
            (gouraud_jump(theta, Degrees(0.0), delta), -0.537_52),
            (phong_jump(theta, Degrees(0.0), delta), -0.134_38),
            (gouraud_jump(across, Degrees(-80.0), delta), -0.143_85),
            (phong_jump(across, Degrees(-80.0), delta), 0.335_99),
        ] {
            assert!((found - printed).abs() < 6e-6, "{found} is not {printed}");
        }
    }

    #[test]
    fn the_artefact_is_there_and_is_cured() {
        let setup = Setup { parameters: Parameters { size: 64, ..EXPERIMENT.defaults }, mesh: None };
        let outcome = EXPERIMENT.run(&setup).unwrap();
        for measure in &outcome.measures {
            assert_eq!(measure.agrees(), Some(true), "{measure:?}");
        }
        // Jumps of first order: a quarter, and a little more where tangents grow.
        assert!(outcome.moved.bad.abs() > 0.3 && outcome.moved.factor() > 3.0, "{:?}", outcome.moved);
        assert!(matches!(outcome.verdict, Verdict::HoldsOnlyIf(_)));
    }

    #[test]
    fn slopes_of_polynomials_are_exact() {
        let nodes = [1.0, 1.5, 2.0, 3.0].map(|x: f64| [x, x * x * x - x]);
        // 3x² − 1 at 0.5; a few roundings of numbers up to 24.
        assert!((slope_at(0.5, &nodes) + 0.25).abs() < 1e-13);
    }
}
