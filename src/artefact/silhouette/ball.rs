//! Outlines that are known: a ball seen along its axis is a regular polygon, a torus two of them.

use super::super::body::{Body, Diagonal};
use super::super::stage::{front, light_at};
use super::super::{
    ArtefactError, Chart, Curve, Drawn, Language, Measure, Moved, Outcome, Parameters, Scale, Shot, Text,
    Threshold, Verdict,
};
use super::{Outline, View, between, material};
use crate::metric::ContourDistance;
use crate::raster::{Image, Object, Shading, Shape};
use crate::surface::{Parametric, Primitive, Sphere, Torus};
use glam::{DMat4, DVec3, DVec4};
use std::f64::consts::{PI, TAU};

/// The window's side over the outer radius of what is in it.
const WINDOW: f64 = 2.2;
/// The radius of the torus' outer outline.
const OUTER: f64 = 1.4;
/// The y axis, about which things are round, to the viewer.
const TOWARDS_VIEWER: DMat4 = DMat4::from_cols(DVec4::X, DVec4::Z, DVec4::NEG_Y, DVec4::W);

pub(super) fn run(parameters: &Parameters) -> Result<Outcome, ArtefactError> {
    let &Parameters { size, segments, light, .. } = parameters;
    let radius = f64::from(size) / WINDOW;
    let view = |height: f64| View { size, camera: front(height), light: light_at(light) };
    let ball = Subject { primitive: Sphere::default().into(), view: view(WINDOW) };
    let torus = Subject { primitive: Torus::default().into(), view: view(WINDOW * OUTER) };
    let (enough, open) = (enough(radius), ball.view.open());
    let circle = ball.outline_of_truth()?;
    let outline = ball.outline(segments, Shading::Phong)?;
    let flat = ball.outline(segments, Shading::Flat)?;
    let of_coarse = outline.distance(&circle)?;
    // Less than half a pixel with all that outlines of pixels add, unless they add that much, and finer than what it cures.
    let left = (0.5 - open).clamp(0.125, 0.25);
    let fine = for_error(left, radius).max(2 * segments);
    let of_fine = ball.error(fine, &circle)?;
    let true_torus = torus.outline_of_truth()?;
    let [of_torus, of_fine_torus] = [segments, fine].map(|segments| torus.error(segments, &true_torus));
    let (of_torus, of_fine_torus) = (of_torus?, of_fine_torus?);
    let found = ball.found_enough(enough, &circle)?;
    let measures = vec![
        largest(Text::new("ball", "bola"), segments, &of_coarse, radius, open),
        Measure::new(
            Text::new("ball: mean distance of the outlines", "bola: distância média dos contornos"),
            "px",
            of_coarse.mean,
        )
        .expect(
            mean(segments, radius),
            open,
            Text::new(
                "the mean of e over the polygon and over the circle; a third of the outlines' own pixels from either",
                "a média de e sobre o polígono e sobre o círculo; um terço dos pixels dos próprios contornos de cada um",
            ),
        ),
        area(Text::new("ball", "bola"), segments, &of_coarse, open * 2.0 / radius),
        largest(Text::new("ball", "bola"), fine, &of_fine, radius, open),
        Measure::new(
            Text::new(
                "ball: fewest segments whose outline is off by at most half a pixel more than that of a very fine ball",
                "bola: menor número de segmentos cujo contorno erra no máximo meio pixel a mais que o de uma bola muito fina",
            ),
            "",
            f64::from(found),
        )
        .expect(
            f64::from(enough),
            (f64::from(enough) * ((0.5 / (0.5 - 0.5 * open)).sqrt() - 1.0)).ceil(),
            Text::new(
                "π/(2 arcsin(1/(2√R))), found by halving in pictures, whose own pixels keep even a circle's outline from being right; \
                 what distances leave open beside that, in segments",
                "π/(2 arcsin(1/(2√R))), achado por bissecção em imagens, cujos próprios pixels impedem até o contorno de um círculo de \
                 estar certo; o que as distâncias deixam em aberto além disso, em segmentos",
            ),
        ),
        largest(Text::new("torus", "toro"), segments, &of_torus, radius, open),
        largest(Text::new("torus", "toro"), fine, &of_fine_torus, radius, open),
        // Between two outlines, 1 and 3/7 of the radius.
        area(Text::new("torus", "toro"), segments, &of_torus, open * 2.0 / (radius * (1.0 - 3.0 / 7.0))),
        Measure::new(
            Text::new(
                "flat shading against Phong's: distance of the outlines",
                "sombreamento plano contra o de Phong: distância dos contornos",
            ),
            "px",
            flat.distance(&outline)?.hausdorff,
        )
        .expect(0.0, 0.0, Text::new("shading does not move edges", "o sombreamento não move arestas")),
    ];
    let moved = Moved {
        name: Text::new("largest distance of the outline", "maior distância do contorno"),
        unit: "px",
        bad: of_coarse.hausdorff,
        present: Threshold {
            value: Threshold::HALF_PIXEL.value + open,
            why: Text::new(
                "half a pixel, and what outlines of pixels leave open",
                "meio pixel, e o que contornos de pixels deixam em aberto",
            ),
        },
        cure: Text::made(format!("{fine} segments"), format!("{fine} segmentos")),
        cured: of_fine.hausdorff,
        factor: (sagitta(segments, radius) / (left + open)).max(1.0),
    };
    let of_torus = Moved { bad: of_torus.hausdorff, cured: of_fine_torus.hausdorff, ..moved.clone() };
    Ok(Outcome {
        verdict: Verdict::Holds(Text::made(
            format!(
                "whatever the shading; only more faces help. The error falls as 1/n². For half a pixel this ball of a radius of {radius:.0} \
                 pixels needs {enough} segments, one of 200 pixels 45; outlines in pictures are made of pixels, so that up to {} px more \
                 are measured.",
                Language::English.short(open, "")
            ),
            format!(
                "seja qual for o sombreamento; só mais faces ajudam. O erro cai como 1/n². Para meio pixel esta bola de raio de \
                 {radius:.0} pixels precisa de {enough} segmentos, uma de 200 pixels de 45; contornos em imagens são feitos de pixels, e \
                 por isso se medem até {} px a mais.",
                Language::Portuguese.short(open, "")
            ),
        )),
        charts: vec![ball.chart(&circle, radius)?],
        shots: shots([&ball, &torus], [segments, fine], [left, open], [&moved, &of_torus])?,
        moved,
        measures,
        notes: vec![
            Text::new(
                "The vertices have the ball's own normals, so light runs over the faces as over a ball. But the picture ends where \
                 the faces end, and the eye looks at outlines first.",
                "Os vértices têm as normais da própria bola, e a luz corre sobre as faces como sobre uma bola. Mas a imagem \
                 acaba onde as faces acabam, e o olho olha primeiro os contornos.",
            ),
            Text::new(
                "Near the outline faces are seen from the side: they are few pixels wide there, and every one of them is a \
                 side of the polygon. So meshes are best refined where they turn away from the viewer.",
                "Perto do contorno as faces são vistas de lado: ali têm poucos pixels de largura, e cada uma é um lado do \
                 polígono. Por isso vale mais refinar a malha onde ela se vira para longe do observador.",
            ),
        ],
    })
}

/// How far the middle of a side of an n-gon lies within its circle.
pub(super) fn sagitta(segments: u32, radius: f64) -> f64 {
    let sine = libm::sin(PI / (2.0 * f64::from(segments)));
    2.0 * radius * sine * sine
}

/// The smallest n for which that is below half a pixel.
pub(super) fn enough(radius: f64) -> u32 {
    for_error(0.5, radius)
}

/// The smallest n for which it is below an error.
fn for_error(error: f64, radius: f64) -> u32 {
    let least = PI / (2.0 * libm::asin((0.5 * error / radius).sqrt()));
    least.floor() as u32 + 1
}

/// The area of an n-gon over that of its circle.
pub(super) fn area_ratio(segments: u32) -> f64 {
    let turn = TAU / f64::from(segments);
    libm::sin(turn) / turn
}

/// The mean distance of an n-gon and its circle: half of that from the points of the sides to the circle, half of that back.
fn mean(segments: u32, radius: f64) -> f64 {
    let half = PI / f64::from(segments);
    let (sine, cosine) = libm::sincos(half);
    // ∫√(a² + t²) dt over a side at the distance a = R cos δ, and R sin δ/δ − a over the arc.
    let to_circle = 1.0 - 0.5 * (1.0 + cosine * cosine / sine * libm::asinh(sine / cosine));
    radius * 0.5 * (to_circle + sine / half - cosine)
}

fn largest(of: Text, segments: u32, found: &ContourDistance, radius: f64, open: f64) -> Measure {
    let name = Text::each(|language| match (language, of.get(language)) {
        (Language::English, of) => format!("{of}, {segments} segments: largest distance of the outline"),
        (Language::Portuguese, of) => format!("{of}, {segments} segmentos: maior distância do contorno"),
    });
    Measure::new(name, "px", found.hausdorff).expect(
        sagitta(segments, radius),
        open,
        Text::new(
            "R (1 − cos(π/n)); a third of the outlines' own pixels from either",
            "R (1 − cos(π/n)); um terço dos pixels dos próprios contornos de cada um",
        ),
    )
}

/// `open` is the share of the area that outlines leave open.
fn area(of: Text, segments: u32, found: &ContourDistance, open: f64) -> Measure {
    let name = Text::each(|language| match (language, of.get(language)) {
        (Language::English, of) => format!("{of}, {segments} segments: area over the true one"),
        (Language::Portuguese, of) => format!("{of}, {segments} segmentos: área sobre a verdadeira"),
    });
    Measure::new(name, "", found.area_ratio).expect(
        area_ratio(segments),
        open,
        Text::new(
            "n/(2π) sin(2π/n); the outline's length times what distances leave open",
            "n/(2π) sin(2π/n); o comprimento do contorno vezes o que as distâncias deixam em aberto",
        ),
    )
}

/// A surface that is round about the y axis, seen along it.
struct Subject {
    primitive: Primitive,
    view: View,
}

impl Subject {
    fn itself(&self) -> Object<'_> {
        let object = Object::new(Shape::Surface(self.primitive), material());
        Object { transform: TOWARDS_VIEWER, ..object }
    }

    /// The surface with so many segments round its axis.
    fn cut(&self, segments: u32) -> Body {
        match &self.primitive {
            Primitive::Torus(torus) => {
                // An even number: one circle of vertices is the outermost, one the innermost.
                let cells = [segments, 2 * segments.div_ceil(4)];
                Body::grid(cells, Diagonal::Rising, |u, v| {
                    torus
                        .at(u, v)
                        .map_or((DVec3::ZERO, DVec3::Y), |sample| (sample.position, sample.normal.get()))
                })
            }
            _ => Body::globe(segments, 0.0),
        }
    }

    fn picture(&self, segments: u32) -> Result<Image, ArtefactError> {
        self.view.draw(turned(&self.cut(segments)), Shading::Phong)
    }

    fn outline(&self, segments: u32, shading: Shading) -> Result<Outline, ArtefactError> {
        self.view.outline(turned(&self.cut(segments)), shading)
    }

    fn outline_of_truth(&self) -> Result<Outline, ArtefactError> {
        self.view.outline(self.itself(), Shading::Flat)
    }

    fn error(&self, segments: u32, circle: &Outline) -> Result<ContourDistance, ArtefactError> {
        self.outline(segments, Shading::Flat)?.distance(circle)
    }

    /// The fewest segments whose outline is measured to be right to half a pixel, near those that should be, beside what outlines
    /// of pixels are off even with so many segments that their polygon is a circle to a hundredth of a pixel.
    fn found_enough(&self, expected: u32, circle: &Outline) -> Result<u32, ArtefactError> {
        let of_pixels = self.error(8 * expected, circle)?.hausdorff;
        let (mut low, mut high) = (3, 2 * expected);
        while high - low > 1 {
            let middle = low.midpoint(high);
            if self.error(middle, circle)?.hausdorff < 0.5 + of_pixels { high = middle } else { low = middle }
        }
        Ok(high)
    }

    /// Errors by the number of segments.
    fn chart(&self, circle: &Outline, radius: f64) -> Result<Chart, ArtefactError> {
        const SEGMENTS: [u32; 11] = [4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128];
        let (mut farthest, mut means) = (Vec::new(), Vec::new());
        for segments in SEGMENTS {
            let error = self.error(segments, circle)?;
            farthest.push([f64::from(segments), error.hausdorff]);
            means.push([f64::from(segments), error.mean]);
        }
        let law =
            |law: &dyn Fn(u32) -> f64| SEGMENTS.map(|segments| [f64::from(segments), law(segments)]).to_vec();
        let curve = |name, drawn, points| Curve { name, drawn, points };
        Ok(Chart {
            name: "error-by-segments",
            title: Text::new("Error of the outline", "Erro do contorno"),
            caption: Text::new(
                "How far the outline of the ball is from the circle against the number of segments: both the largest and the mean \
                 distance fall as 1/n², as the closed forms say, until the outlines' own pixels are all that is left.",
                "Quanto o contorno da bola se afasta do círculo em função do número de segmentos: a maior distância e a média caem \
                 como 1/n², como dizem as fórmulas, até que só restem os pixels dos próprios contornos.",
            ),
            x: Scale::log(Text::new("segments n", "segmentos n")),
            y: Scale::log(Text::new("distance in pixels", "distância em pixels")),
            curves: vec![
                curve(Text::new("largest", "maior"), Drawn::Points, farthest),
                curve(Text::new("mean", "média"), Drawn::Points, means),
                curve(
                    Text::new("largest, closed form", "maior, fórmula"),
                    Drawn::Guide,
                    law(&|n| sagitta(n, radius)),
                ),
                curve(
                    Text::new("mean, closed form", "média, fórmula"),
                    Drawn::Guide,
                    law(&|n| mean(n, radius)),
                ),
            ],
        })
    }
}

fn turned(body: &Body) -> Object<'_> {
    Object { transform: TOWARDS_VIEWER, ..body.object(material()) }
}

fn shots(
    [ball, torus]: [&Subject; 2],
    [segments, fine]: [u32; 2],
    [left, open]: [f64; 2],
    [of_ball, of_torus]: [&Moved; 2],
) -> Result<Vec<Shot>, ArtefactError> {
    let round = ball.view.draw(ball.itself(), Shading::Phong)?;
    let coarse = ball.picture(segments)?;
    let lacking = between(&coarse, &round);
    let label = |en: &str, pt: &str, count: u32| {
        Text::made(format!("{en}, {count} segments"), format!("{pt}, {count} segmentos"))
    };
    Ok(vec![
        of_ball.bad_shot(
            "ball",
            label("ball", "bola", segments),
            [
                Text::new(
                    "Phong's shading with the ball's own normals: within, all is round.",
                    "O sombreamento de Phong com as normais da própria bola: por dentro tudo é redondo.",
                ),
                Text::new("Its outline is a polygon.", "O contorno é um polígono."),
            ],
            coarse,
        ),
        Shot::difference(
            "lacking",
            Text::new("what is lacking", "o que falta"),
            Text::new(
                "Yellow where the ball covers the picture and the polygons do not: a sickle over every side, the thinner the more \
                 sides there are.",
                "Amarelo onde a bola cobre a imagem e os polígonos não: uma lua fina sobre cada lado, tanto mais fina quanto mais lados há.",
            ),
            lacking,
        ),
        of_ball.cured_shot(
            "ball-fine",
            label("ball", "bola", fine),
            [
                Text::with(
                    "At least twice as many segments as before, and enough for an error below {} px by the closed form; what is measured \
                     may be up to {} px more, as outlines are made of pixels.",
                    "Ao menos o dobro de segmentos de antes, e bastantes para um erro abaixo de {} px pela fórmula; o que se mede pode ser \
                     até {} px maior, pois contornos são feitos de pixels.",
                    &[left, open],
                ),
                Text::new("The outline is round to the eye.", "O contorno é redondo para o olho."),
            ],
            ball.picture(fine)?,
        ),
        Shot::truth(
            "ball-itself",
            Text::new("the ball itself", "a própria bola"),
            Text::new("The ball by its equation, without faces.", "A bola pela sua equação, sem faces."),
            round,
        ),
        of_torus.bad_shot(
            "torus",
            label("torus", "toro", segments),
            [
                Text::new("A torus along its axis.", "Um toro visto ao longo do eixo."),
                Text::new(
                    "Outside as inside the outline is a polygon.",
                    "Por fora como por dentro o contorno é um polígono.",
                ),
            ],
            torus.picture(segments)?,
        ),
        of_torus.cured_shot(
            "torus-fine",
            label("torus", "toro", fine),
            [
                Text::new("The torus with as many segments as the finer ball.", "O toro com tantos segmentos quanto a bola mais fina."),
                Text::new("It is round to the eye.", "É redondo para o olho."),
            ],
            torus.picture(fine)?,
        ),
    ])
}
