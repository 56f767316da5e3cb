//! Vertices that neighbours do not share: T-junctions, cracks, seams.

use super::stage::{chalk, draw, front, light_at, linear, luminance, object, settings};
use super::{
    ArtefactError, Chart, Curve, Drawn, Experiment, Formula, Knob, Measure, Moved, Outcome, Parameters,
    Scale, Setup, Shot, Text, Threshold, Verdict,
};
use crate::mesh::{Faces, Mesh, MeshBuilder, Weld};
use crate::normals::{Crease, NormalRecipe, Weight, compute};
use crate::num::{Degrees, LinearRgb, Radians};
use crate::raster::{Image, Interpolation, Object, Paint, RenderSettings, Samples, Shading, Shape};
use crate::shade::Material;
use glam::DVec3;
use std::f64::consts::TAU;

pub(super) const EXPERIMENT: Experiment = Experiment {
    id: "shared-vertices",
    title: Text::new("Vertices that are not shared", "Vértices não compartilhados"),
    claim: Text::new(
        "Where faces meet without sharing their vertices, interpolated shading has discontinuities.",
        "Onde faces se encontram sem compartilhar os vértices, o sombreamento interpolado tem descontinuidades.",
    ),
    sources: &[
        Text::new("Lectures: 1.5.2.3, 1.6.15, 1.6.47", "Aulas: 1.5.2.3, 1.6.15, 1.6.47"),
        Text::new("Welding as the cure: crease normals --weld", "A solda como cura: crease normals --weld"),
    ],
    formulas: &[
        Formula {
            notation: Text::same("ΔI = |c − ((1 − t) a + t b)|"),
            says: Text::new(
                "the jump at a vertex of colour c that lies at the share t of an edge with the colours a and b at its ends",
                "o salto num vértice de cor c que está na fração t de uma aresta com as cores a e b nas pontas",
            ),
        },
        Formula {
            notation: Text::same("ΔI = 2 |sin(θ − θ_L)| sin(Δ/2)"),
            says: Text::new(
                "the jump along an unwelded seam, at the angle θ from the viewer, of a tube of N facets, Δ = 2π/N, with the light at θ_L: \
                 each side has the normal of its own facet; here θ = 0",
                "o salto ao longo de uma emenda não soldada, no ângulo θ a partir do observador, de um tubo de N facetas, Δ = 2π/N, com a \
                 luz em θ_L: cada lado tem a normal da sua faceta; aqui θ = 0",
            ),
        },
        Formula {
            notation: Text::same("A = \\frac{1}{2} L δ"),
            says: Text::new(
                "the area of the crack beside an edge of length L that a vertex is off by δ",
                "a área da fenda ao lado de uma aresta de comprimento L da qual um vértice dista δ",
            ),
        },
    ],
    takes: &[Knob::Size, Knob::Segments, Knob::Light],
    own_mesh: None,
    segments: Parameters::SEGMENTS,
    shown_by: Text::new(
        "light that comes from the side of the seam (--light 50), and fewer segments, would show it there; the T-junction and the \
         crack are seen in any light.",
        "luz que vem do lado da emenda (--light 50), e menos segmentos, o mostrariam ali; a junção em T e a fenda se veem sob \
         qualquer luz.",
    ),
    defaults: Parameters { segments: 16, light: Degrees(50.0), ..Parameters::USUAL },
    run,
    frame: None,
};

/// The colours at the ends of the long edge and at the vertex on it.
const ENDS: [f64; 2] = [0.2, 0.8];
const MIDDLE: f64 = 0.9;
/// Half the height of the wall of faces, in a window of height 2.
const HALF: f64 = 0.9;
/// How far the vertex of the crack is off its edge, in pixels.
const OFF: f64 = 6.0;

fn run(setup: &Setup) -> Result<Outcome, ArtefactError> {
    let Parameters { size, segments, light, .. } = setup.parameters;
    let wall = Wall::new(size);
    let bad = wall.draw(&wall.mesh(0.0, false)?, size, Samples::One)?;
    let cured = wall.draw(&wall.mesh(0.0, true)?, size, Samples::One)?;
    let law = (MIDDLE - (ENDS[0] + wall.share() * (ENDS[1] - ENDS[0]))).abs();
    let [jump, mended] = [&bad, &cured].map(|image| largest(&jumps(image)));

    let cracked = wall.draw(&wall.mesh(OFF, false)?, size, Samples::Sixteen)?;
    let whole = wall.draw(&wall.mesh(OFF, true)?, size, Samples::Sixteen)?;
    let [crack, closed] = [&cracked, &whole].map(|image| wall.uncovered(image));
    let edge = 2.0 * HALF * f64::from(size) / 2.0;
    // How far the pixel to the left of the edge is from it: of an odd number of pixels the middle one has its centre on the edge.
    let beside = if size.is_multiple_of(2) { 0.5 } else { 1.0 };

    let tube = Tube::new(segments)?;
    let [open, welded] = [Weld::Off, Weld::Exact].map(|weld| tube.draw(size, light, weld));
    let (open, welded) = (open?, welded?);
    let seam_law = tube.law(light);
    let [seam_open, seam_welded] = [Weld::Off, Weld::Exact].map(|weld| tube.jump(light, weld));
    let (seam_open, seam_welded) = (seam_open?, seam_welded?);

    let measures = vec![
        Measure::new(Text::new("T-junction: largest jump across the edge", "junção em T: maior salto através da aresta"), "", jump).expect(
            law,
            1e-3,
            Text::new(
                "|c − ((1 − t)a + tb)|; the vertex lies on the row of pixels that is measured, within 1/256 of a pixel",
                "|c − ((1 − t)a + tb)|; o vértice está na linha de pixels medida, a menos de 1/256 de pixel",
            ),
        ),
        Measure::new(
            Text::new("the same with the vertex in both faces", "o mesmo com o vértice nas duas faces"),
            "",
            mended,
        )
        .expect(law * beside / (HALF * f64::from(size) / 2.0), 2e-4, Text::new(
            "on the edge none; a pixel's centre beside it, the large face is on its way to the colour of its far edge",
            "na aresta nenhum; no centro do pixel ao lado, a face grande está a caminho da cor da sua aresta oposta",
        )),
        Measure::new(Text::new("crack: area not covered", "fenda: área não coberta"), "px²", crack).expect(
            0.5 * edge * OFF,
            edge / 16.0 + 2.0,
            Text::new(
                "Lδ/2; a sixteenth of a pixel for every pixel of its length, and one at either end",
                "Lδ/2; um dezesseis avos de pixel por pixel do comprimento, e um em cada ponta",
            ),
        ),
        Measure::new(
            Text::new("the same with the vertex in both faces", "o mesmo com o vértice nas duas faces"),
            "px²",
            closed,
        )
        .expect(0.0, 0.0, Text::new(
            "faces that share an edge cover each sample once",
            "faces que compartilham uma aresta cobrem cada amostra uma vez",
        )),
        Measure::new(Text::new("seam: jump of luminance", "emenda: salto de luminância"), "", seam_open).expect(
            seam_law,
            2e-3,
            Text::new(
                "2 |sin(θ − θ_L)| sin(Δ/2); measured a pixel and a half off the seam on both sides",
                "2 |sin(θ − θ_L)| sin(Δ/2); medido a um pixel e meio da emenda dos dois lados",
            ),
        ),
        Measure::new(Text::new("seam, welded", "emenda soldada"), "", seam_welded).expect(
            0.0,
            2e-3,
            Text::new("one normal a vertex; as above", "uma normal por vértice; como acima"),
        ),
    ];
    let seam = Moved {
        name: Text::new("jump of luminance across the seam", "salto de luminância através da emenda"),
        unit: "",
        bad: seam_open,
        present: Threshold::HALF_STEP,
        cure: Text::new("welded", "soldado"),
        cured: seam_welded,
        factor: 100.0,
    };
    let t_junction = Moved {
        name: Text::new("largest jump across the edge", "maior salto através da aresta"),
        bad: jump,
        cured: mended,
        // Beside the edge the large face has gone half a pixel towards its far edge: or a whole one: of the smallest picture a fourteenth.
        factor: 10.0,
        ..seam.clone()
    };
    let crack = Moved {
        name: Text::new("area that is not covered", "área não coberta"),
        unit: "px²",
        bad: crack,
        present: Threshold { value: 0.5, why: Text::new("half of one pixel", "metade de um pixel") },
        cured: closed,
        ..seam.clone()
    };
    Ok(Outcome {
        verdict: Verdict::HoldsOnlyIf(Text::new(
            "the colour or normal that one side has at a vertex is not what the other side interpolates there. A T-junction in a \
             flat, evenly lit wall is not seen, and neither is a seam whose sides have the same normals.",
            "a cor ou normal que um lado tem num vértice não é a que o outro lado interpola ali. Uma junção em T numa parede \
             plana e iluminada por igual não se vê, nem uma emenda cujos lados têm as mesmas normais.",
        )),
        charts: vec![chart(&wall, &bad, &cured)],
        shots: shots(
            [&t_junction, &crack, &seam],
            [bad, cured, cracked, whole, open, welded],
            [edge, f64::from(segments), light.0],
        ),
        moved: seam,
        measures,
        notes: vec![
            Text::new(
                "The vertex on the long edge belongs to the two small faces only. The large face knows nothing of its colour and \
                 interpolates straight past it: beside it the two sides differ.",
                "O vértice na aresta longa pertence só às duas faces pequenas. A face grande nada sabe da sua cor e interpola \
                 direto por ele: ao seu lado, os dois lados diferem.",
            ),
            Text::new(
                "Moved off the edge, as rounding does, it leaves a crack, through which the background shows. Put into the large \
                 face as a corner of its own, it cures both.",
                "Movido para fora da aresta, como faz o arredondamento, ele deixa uma fenda, pela qual se vê o fundo. Posto na \
                 face grande como um canto seu, ele cura os dois.",
            ),
            Text::new(
                "Along a seam two rows of vertices lie at the same places. Normals are means over the faces at a vertex, and each \
                 row has the faces of one side only. Welding takes vertices at one place as one.",
                "Numa emenda, duas fileiras de vértices estão nos mesmos lugares. Normais são médias das faces num vértice, e cada \
                 fileira só tem as faces de um lado. A solda toma como um só os vértices no mesmo lugar.",
            ),
        ],
    })
}

/// A large face at the left, two small ones at the right, and a vertex between those on the large one's edge.
struct Wall {
    /// Pixels of the window's height of 2.
    size: u32,
    /// The height of the vertex: that of a row of pixel centres, at about a fifth of the wall.
    height: f64,
}

impl Wall {
    fn new(size: u32) -> Self {
        let row = libm::floor(0.4 * f64::from(size));
        Self { size, height: 1.0 - (row + 0.5) * 2.0 / f64::from(size) }
    }

    /// Where on the long edge it is, from below.
    fn share(&self) -> f64 {
        (self.height + HALF) / (2.0 * HALF)
    }

    /// The faces, with the vertex so many pixels to the right of the edge, and in the large face too if it is shared.
    fn mesh(&self, off: f64, is_shared: bool) -> Result<Mesh, ArtefactError> {
        let x = off * 2.0 / f64::from(self.size);
        let points = [
            [-HALF, -HALF],
            [0.0, -HALF],
            [0.0, HALF],
            [-HALF, HALF],
            [HALF, -HALF],
            [HALF, self.height],
            [HALF, HALF],
            [x, self.height],
        ];
        let mut faces = Faces::new();
        match is_shared {
            true => faces.push(&[0, 1, 7, 2, 3]),
            false => faces.push(&[0, 1, 2, 3]),
        }
        faces.push(&[1, 4, 5, 7]);
        faces.push(&[7, 5, 6, 2]);
        let positions = points.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        Ok(MeshBuilder { positions, faces, ..MeshBuilder::default() }.build()?)
    }

    /// By the lectures' algorithm, in colours that depend on the height alone.
    fn draw(&self, mesh: &Mesh, size: u32, samples: Samples) -> Result<Image, ArtefactError> {
        let [low, high] = ENDS;
        let colours = [low, low, high, high, low, MIDDLE, high, MIDDLE].map(LinearRgb::grey);
        let normals = super::stage::smooth(mesh, Weight::Angle);
        let object = Object {
            paint: Paint::Given(colours.as_slice().into()),
            ..Object::new(Shape::Mesh { mesh, normals: &normals }, Material::default())
        };
        let settings =
            RenderSettings { samples, ..settings([size; 2], Shading::Gouraud, Interpolation::Scanline) };
        draw(vec![object], &[], front(2.0), &settings)
    }

    /// The area within the wall that is not covered, in pixels.
    fn uncovered(&self, image: &Image) -> f64 {
        let margin = libm::ceil((1.0 - HALF) / 2.0 * f64::from(self.size)) as u32 + 1;
        let inside = margin..self.size - margin;
        let pixels = inside.clone().flat_map(|y| inside.clone().map(move |x| (x, y)));
        let full = Samples::Sixteen.count() as f64;
        let missing = pixels
            .filter_map(|(x, y)| image.index(x, y))
            .map(|index| full - f64::from(image.coverage[index]));
        missing.sum::<f64>() / full
    }
}

/// The luminance of each row to the right of the upright line through the middle less that to the left, where both are
/// covered.
fn jumps(image: &Image) -> Vec<(u32, f64)> {
    let [width, height] = image.size;
    let values = luminance(image);
    let jump = |row: u32| {
        let [left, right] = [image.index(width / 2 - 1, row)?, image.index(width / 2, row)?];
        (image.coverage[left] > 0 && image.coverage[right] > 0).then(|| (row, values[right] - values[left]))
    };
    (0..height).filter_map(jump).collect()
}

fn largest(jumps: &[(u32, f64)]) -> f64 {
    jumps.iter().map(|(_, jump)| jump.abs()).fold(0.0, f64::max)
}

/// A tube that is not closed at the edge that faces the viewer: two rows of vertices at the same places.
struct Tube {
    mesh: Mesh,
    segments: u32,
}

impl Tube {
    fn new(segments: u32) -> Result<Self, ArtefactError> {
        let ring = |y: f64| {
            (0..=segments).map(move |k| {
                let angle = TAU * f64::from(k % segments) / f64::from(segments);
                DVec3::new(libm::sin(angle), y, libm::cos(angle))
            })
        };
        let quad = |k: u32| [k, k + 1, k + segments + 2, k + segments + 1];
        let corners: Vec<u32> = (0..segments).flat_map(quad).collect();
        let builder = MeshBuilder {
            positions: ring(-0.8).chain(ring(0.8)).collect(),
            faces: Faces::polygons(corners, (0..=segments).map(|k| 4 * k).collect()),
            ..MeshBuilder::default()
        };
        Ok(Self { mesh: builder.build()?, segments })
    }

    fn image(&self, size: [u32; 2], light: Degrees, weld: Weld) -> Result<Image, ArtefactError> {
        let recipe =
            NormalRecipe { weight: Weight::Uniform, crease: Crease::OFF, weld, ..NormalRecipe::default() };
        let normals = compute(&self.mesh, &recipe);
        let camera = front(2.2 * f64::from(size[1]) / f64::from(size[0]));
        let settings = settings(size, Shading::Phong, Interpolation::Perspective);
        draw(vec![object(&self.mesh, &normals, chalk())], &[light_at(light)], camera, &settings)
    }

    fn draw(&self, size: u32, light: Degrees, weld: Weld) -> Result<Image, ArtefactError> {
        self.image([size; 2], light, weld)
    }

    /// The jump at the seam, along a scanline of many pixels.
    fn jump(&self, light: Degrees, weld: Weld) -> Result<f64, ArtefactError> {
        const LINE: u32 = 8192;
        let image = self.image([LINE, 1], light, weld)?;
        let red = |pixel: u32| f64::from(linear(&image)[pixel as usize][0]);
        Ok((red(LINE / 2 + 1) - red(LINE / 2 - 2)).abs())
    }

    fn law(&self, light: Degrees) -> f64 {
        let half = TAU / f64::from(self.segments) / 2.0;
        let side = |angle: f64| libm::cos(angle - Radians::from(light).0).max(0.0);
        (side(half) - side(-half)).abs()
    }
}

/// The pictures; and the length of the long edge in pixels, how many facets the tube has, and the light's angle in degrees.
fn shots(
    [t_junction, crack, seam]: [&Moved; 3],
    [bad, cured, cracked, whole, open, welded]: [Image; 6],
    [edge, facets, light]: [f64; 3],
) -> Vec<Shot> {
    vec![
        t_junction.bad_shot(
            "t-junction",
            Text::new("T-junction", "junção em T"),
            [
                Text::new(
                    "Three faces whose corners' colours depend on their height alone. The small ones at the right are brightest at their common \
                     vertex, which the large one lacks.",
                    "Três faces cujas cores nos cantos só dependem da altura deles. As pequenas à direita são mais claras no vértice comum, que falta à \
                     grande.",
                ),
                Text::new("An edge is seen in the middle.", "Vê-se uma aresta no meio."),
            ],
            bad,
        ),
        t_junction.cured_shot(
            "t-junction-shared",
            Text::new("vertex in all faces", "vértice em todas as faces"),
            [
                Text::new(
                    "The vertex is a corner of the large face too.",
                    "O vértice é também um canto da face grande.",
                ),
                Text::new(
                    "There is no jump at the edge any more, only a bend of the slope.",
                    "Não há mais salto na aresta, só uma quebra da inclinação.",
                ),
            ],
            cured,
        ),
        crack.bad_shot(
            "crack",
            Text::new("crack", "fenda"),
            [
                Text::with(
                    "The vertex δ = {} px off the long edge of L = {} px.",
                    "O vértice a δ = {} px da aresta longa, de L = {} px.",
                    &[OFF, edge],
                ),
                Text::new(
                    "The background shows through a dark crack.",
                    "O fundo aparece por uma fenda escura.",
                ),
            ],
            cracked,
        ),
        crack.cured_shot(
            "crack-closed",
            Text::new("crack closed", "fenda fechada"),
            [
                Text::new(
                    "The same vertex as a corner of all three faces.",
                    "O mesmo vértice como canto das três faces.",
                ),
                Text::new("No sample is left open.", "Nenhuma amostra fica aberta."),
            ],
            whole,
        ),
        seam.bad_shot(
            "seam",
            Text::new("seam", "emenda"),
            [
                Text::with(
                    "A tube of N = {} facets, the light at θ_L = {}°. Its first and last column of vertices are at the same places (θ = 0) \
                     but not the same.",
                    "Um tubo de N = {} facetas, a luz em θ_L = {}°. A sua primeira e a sua última coluna de vértices estão nos mesmos lugares \
                     (θ = 0) mas não são as mesmas.",
                    &[facets, light],
                ),
                Text::new("There is a line down its middle.", "Há uma linha no seu meio."),
            ],
            open,
        ),
        seam.cured_shot(
            "seam-welded",
            Text::new("seam welded", "emenda soldada"),
            [
                Text::new(
                    "Welded, so that normals are means over the faces of both sides.",
                    "Soldado, e as normais são médias das faces dos dois lados.",
                ),
                Text::new("The line is gone.", "A linha sumiu."),
            ],
            welded,
        ),
    ]
}

fn chart(wall: &Wall, bad: &Image, cured: &Image) -> Chart {
    let height = |row: u32| 1.0 - (f64::from(row) + 0.5) * 2.0 / f64::from(wall.size);
    let curve = |name, image: &Image| Curve {
        name,
        drawn: Drawn::Curve,
        points: jumps(image).into_iter().map(|(row, jump)| [height(row), jump]).collect(),
    };
    Chart {
        name: "jump",
        title: Text::new("Jump across the long edge", "Salto através da aresta longa"),
        caption: Text::new(
            "The jump grows from both ends of the edge to the vertex that the large face lacks; shared, there is none.",
            "O salto cresce das duas pontas da aresta até o vértice que falta à face grande; compartilhado, não há salto.",
        ),
        x: Scale::linear(Text::new("height along the edge", "altura ao longo da aresta")),
        y: Scale::linear(Text::new("jump of luminance", "salto de luminância")),
        curves: vec![
            curve(Text::new("T-junction", "junção em T"), bad),
            curve(Text::new("vertex shared", "vértice compartilhado"), cured),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_artefact_is_there_and_is_cured() {
        let setup = Setup { parameters: Parameters { size: 96, ..EXPERIMENT.defaults }, mesh: None };
        let outcome = EXPERIMENT.run(&setup).unwrap();
        outcome.prove();
        // 2 sin 50° sin 11.25°, computed apart from this program; a pixel and a half on both sides.
        assert!((outcome.moved.bad - 0.298_90).abs() < 2e-3, "{:?}", outcome.moved);
        // A tube of 16 facets jumps by 0.3 under a light at 50°; welded, luminance moves by its slope over three pixels.
        assert!(outcome.moved.bad > 0.2 && outcome.moved.reduction() > 100.0, "{:?}", outcome.moved);
    }
}
