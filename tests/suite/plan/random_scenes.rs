//! Small random scenes, and every model that a plan may give them, written as the texts of scenes.

use crate::random::Random;
use crease::plan::Axis;

/// An object and its model.
#[derive(Clone, Debug)]
pub struct Thing {
    pub shape: Shape,
    rotate: [f64; 3],
    place: [f64; 3],
    pub shading: &'static str,
    pub is_affine: bool,
    pub is_two_sided: bool,
    /// The weight and whether normals are computed in single precision; `None` for those of the shape.
    pub computed: Option<(&'static str, bool)>,
    pub has_creases: bool,
    pub format: Option<&'static str>,
    pub is_merged: bool,
    colour: [f64; 3],
    ambient: f64,
    diffuse: f64,
    pub specular: f64,
    exponent: f64,
    pub is_blinn: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Sphere([u32; 2]),
    Cube,
    Roof,
    /// The roof as separate triangles.
    Facets,
}

/// A light.
#[derive(Clone, Copy, Debug)]
pub enum Lamp {
    Ambient(f64),
    Sun([f64; 3], f64),
    /// Position, colour, and whether it has the inverse-square law.
    Point([f64; 3], f64, bool),
    /// A point light with a cone of this axis, cut-off in degrees and exponent.
    Spot([f64; 3], f64, bool, ([f64; 3], f64, f64)),
    /// A square of sides 2h that shines down, with its centre and h.
    Square([f64; 3], f64, f64),
}

/// A scene.
#[derive(Clone, Debug)]
pub struct RandomScene {
    head: String,
    pub things: Vec<Thing>,
    pub lamps: Vec<Lamp>,
}

const CUBE: &str = "vertices = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], \
     faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [1, 2, 6, 5], [0, 4, 7, 3]]";

/// Two rectangles, at 30° to each other.
const ROOF: &str = "vertices = [[-1, 0, 1], [1, 0, 1], [1, 0.27, 0], [-1, 0.27, 0], [1, 0, -1], [-1, 0, -1]], \
     faces = [[0, 1, 2, 3], [3, 2, 4, 5]]";

/// [`ROOF`] as four triangles without common vertices.
fn facets() -> String {
    let corners = ["[-1, 0, 1]", "[1, 0, 1]", "[1, 0.27, 0]", "[-1, 0.27, 0]", "[1, 0, -1]", "[-1, 0, -1]"];
    let vertices = [0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5].map(|corner: usize| corners[corner]).join(", ");
    format!("vertices = [{vertices}], faces = [[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]]")
}

impl Thing {
    fn new(random: &mut Random, x: f64) -> Self {
        let mut between = |low: f64, high: f64| low + (high - low) * random.unit();
        let (rotate, place) =
            ([0.0; 3].map(|_: f64| between(-180.0, 180.0)), [x, between(-0.4, 0.4), between(-0.5, 0.5)]);
        let (colour, ambient, diffuse) =
            ([0.0; 3].map(|_: f64| between(0.1, 1.0)), between(0.0, 0.5), between(0.2, 0.9));
        let exponent = between(2.0, 60.0);
        let specular = if random.one_in(3) { 0.0 } else { 0.5 * random.unit() };
        let shape = match random.below(4) {
            0 => Shape::Cube,
            1 if random.one_in(2) => Shape::Roof,
            1 => Shape::Facets,
            _ => Shape::Sphere([12 + random.below(10) as u32, 8 + random.below(6) as u32]),
        };
        Self {
            shape,
            rotate,
            place,
            shading: if random.one_in(4) { "gouraud" } else { "phong" },
            is_affine: false,
            is_two_sided: random.one_in(2),
            computed: random.one_in(2).then_some(("angle", false)),
            has_creases: true,
            format: None,
            is_merged: false,
            colour,
            ambient,
            diffuse,
            specular,
            exponent,
            is_blinn: random.one_in(2),
        }
    }

    pub fn text(&self) -> String {
        let mut text = "[[object]]\n".to_owned();
        match self.shape {
            Shape::Sphere(segments) => {
                text += "surface = { sphere = { radius = 1 } }\n";
                text += &format!("tessellation = {{ segments = {segments:?} }}\n");
            }
            Shape::Cube => text += &format!("polygons = {{ {CUBE} }}\n"),
            Shape::Roof => text += &format!("polygons = {{ {ROOF} }}\n"),
            Shape::Facets => text += &format!("polygons = {{ {} }}\n", facets()),
        }
        text += &format!(
            "transform = [{{ scale = 0.7 }}, {{ rotate = {:?} }}, {{ translate = {:?} }}]\nshading = \"{}\"\ntwo-sided = {}\n",
            self.rotate, self.place, self.shading, self.is_two_sided
        );
        text += if self.is_affine { "interpolation = \"affine\"\n" } else { "" };
        if let Some((weight, is_fast)) = self.computed {
            text += &format!("weight = \"{weight}\"\n");
            text += if is_fast { "precision = \"fast\"\n" } else { "" };
        }
        text += if self.has_creases { "" } else { "crease = \"none\"\n" };
        text += if self.is_merged { "merge = \"exact\"\n" } else { "" };
        if let Some(format) = self.format {
            text += &format!("normal-format = \"{format}\"\n");
        }
        text + &format!(
            "material = {{ colour = {:?}, ambient = {:?}, diffuse = {:?}, specular = {:?}, exponent = {:?}, reflection = \"{}\" }}\n",
            self.colour,
            self.ambient,
            self.diffuse,
            self.specular,
            self.exponent,
            if self.is_blinn { "blinn" } else { "phong" }
        )
    }

    /// The cheaper values of an axis, with everything else unchanged. Flat shading comes last: it has no other choices.
    fn cheaper(&self, axis: Axis) -> Vec<Self> {
        let it = || self.clone();
        match axis {
            Axis::Shading => {
                let flat =
                    Self { shading: "flat", is_affine: false, format: None, has_creases: true, ..it() };
                let flat = Self { computed: flat.computed.map(|_| ("angle", false)), ..flat };
                match self.shading {
                    "phong" => vec![Self { shading: "gouraud", ..it() }, flat],
                    _ => vec![flat],
                }
            }
            Axis::Weight => match self.computed {
                Some((_, is_fast)) => {
                    ["uniform", "area"].map(|name| Self { computed: Some((name, is_fast)), ..it() }).into()
                }
                None => Vec::new(),
            },
            Axis::Creases if self.computed.is_some() && self.shape == Shape::Cube => {
                vec![Self { has_creases: false, ..it() }]
            }
            Axis::Precision => {
                let fast = self.computed.map(|(weight, _)| Self { computed: Some((weight, true)), ..it() });
                fast.into_iter().collect()
            }
            Axis::Storage => {
                ["i16", "oct12", "i8", "oct8"].map(|format| Self { format: Some(format), ..it() }).into()
            }
            Axis::Merging if self.shape == Shape::Facets => vec![Self { is_merged: true, ..it() }],
            Axis::Interpolation => vec![Self { is_affine: true, ..it() }],
            Axis::Reflection => {
                let mut list = vec![Self { diffuse: 0.0, specular: 0.0, ..it() }];
                if self.specular > 0.0 {
                    list.push(Self { specular: 0.0, ..it() });
                    if !self.is_blinn {
                        list.push(Self { is_blinn: true, exponent: 4.0 * self.exponent, ..it() });
                    }
                }
                list
            }
            Axis::Tessellation => {
                let (mut list, mut shape) = (Vec::new(), self.shape);
                while let Shape::Sphere([u, v]) = shape {
                    let fewer = [u * 3 / 4, v * 3 / 4];
                    if fewer[0] < 4 || fewer[1] < 3 {
                        break;
                    }
                    shape = Shape::Sphere(fewer);
                    list.push(Self { shape, ..it() });
                }
                list
            }
            Axis::TwoSided if self.is_two_sided => vec![Self { is_two_sided: false, ..it() }],
            Axis::Creases | Axis::Merging | Axis::TwoSided | Axis::Lights | Axis::Antialiasing => Vec::new(),
        }
    }

    pub fn has_diffuse(&self) -> bool {
        self.diffuse > 0.0
    }

    /// All models with the open axes, this one first.
    pub fn models(&self, open: &[Axis]) -> Vec<Self> {
        let mut models = vec![self.clone()];
        let order = Axis::ALL.into_iter().filter(|axis| open.contains(axis) && *axis != Axis::Shading);
        for axis in order.chain(open.iter().copied().filter(|axis| *axis == Axis::Shading)) {
            let more: Vec<Self> = models.iter().flat_map(|model| model.cheaper(axis)).collect();
            models.extend(more);
        }
        let mut texts = std::collections::HashSet::new();
        models.retain(|model| texts.insert(model.text()));
        models
    }
}

impl Lamp {
    fn new(random: &mut Random) -> Self {
        let position = [0.0; 3].map(|_: f64| 8.0 * random.unit() - 4.0);
        let position = [position[0], position[1] + 2.0, position[2].abs() + 2.0];
        match random.below(8) {
            0 => Self::Ambient(0.4 * random.unit()),
            1..=4 => Self::Sun(position, random.unit() * random.unit()),
            kind => Self::Point(
                position.map(|x| 2.0 * x),
                if kind == 5 { 30.0 * random.unit() } else { random.unit() },
                kind == 5,
            ),
        }
    }

    pub fn text(&self) -> String {
        match self {
            Self::Ambient(colour) => format!("[[light.ambient]]\ncolour = {colour:?}\n"),
            Self::Sun(towards, colour) => {
                format!("[[light.directional]]\ntowards = {towards:?}\ncolour = {colour:?}\n")
            }
            Self::Point(position, colour, is_attenuated) | Self::Spot(position, colour, is_attenuated, _) => {
                let attenuation = if *is_attenuated { "inverse-square" } else { "none" };
                let common = format!(
                    "position = {position:?}\ncolour = {colour:?}\nattenuation = \"{attenuation}\"\n"
                );
                match self {
                    Self::Spot(.., (axis, cut_off, exponent)) => format!(
                        "[[light.spot]]\n{common}axis = {axis:?}\ncut-off = {cut_off:?}\nexponent = {exponent:?}\n"
                    ),
                    _ => format!("[[light.point]]\n{common}"),
                }
            }
            Self::Square(centre, half, colour) => format!(
                "[[light.rectangle]]\ncentre = {centre:?}\nu = [{half:?}, 0, 0]\nv = [0, 0, {half:?}]\ncolour = {colour:?}\n"
            ),
        }
    }

    /// What may replace it, with the same light at the middle of the objects; `None` omits it.
    pub fn models(&self, middle: [f64; 3]) -> Vec<Option<Self>> {
        let mut models = vec![Some(*self)];
        let way = |position: [f64; 3]| [0, 1, 2].map(|axis| position[axis] - middle[axis]);
        let product = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        match *self {
            Self::Ambient(_) | Self::Sun(..) => {}
            Self::Square(centre, half, colour) => {
                // u × v = −y. A Lambert emitter of area 4h² sends I·4h²/π along its normal.
                let power = colour * 4.0 * half * half * std::f64::consts::FRAC_1_PI;
                let spot = Self::Spot(centre, power, true, ([0.0, -1.0, 0.0], 90.0, 1.0));
                models.extend(spot.models(middle));
                return models;
            }
            Self::Spot(position, colour, is_attenuated, cone) => {
                let towards = way(position);
                let square = product(towards, towards);
                if is_attenuated {
                    models.push(Some(Self::Spot(position, colour / square, false, cone)));
                }
                let (axis, cut_off, exponent) = cone;
                let cosine = -product(towards, axis) / (square * product(axis, axis)).sqrt();
                let is_inside = cosine >= libm::cos(cut_off.to_radians());
                if is_inside && cosine > 0.0 {
                    let factor = libm::pow(cosine, exponent);
                    models.extend(Self::Point(position, colour * factor, is_attenuated).models(middle));
                    return models;
                }
            }
            Self::Point(position, colour, is_attenuated) => {
                let towards = way(position);
                let colour = if is_attenuated { colour / product(towards, towards) } else { colour };
                if is_attenuated {
                    models.push(Some(Self::Point(position, colour, false)));
                }
                models.push(Some(Self::Sun(towards, colour)));
            }
        }
        models.push(None);
        models
    }
}

impl RandomScene {
    pub fn new(seed: u64) -> Self {
        let mut random = Random(seed.wrapping_mul(0x1234_5679));
        let samples = if random.one_in(5) { 4 } else { 1 };
        let tone = if random.one_in(4) { "max" } else { "clamp" };
        let transfer = if random.one_in(4) { "direct" } else { "srgb" };
        let lens = if random.one_in(3) { "height = 3.4" } else { "angle = 36" };
        let eye = [3.0 * random.unit() - 1.5, 3.0 * random.unit() - 1.5, 5.0];
        let head = format!(
            "[settings]\nsize = [48, 48]\nsamples = {samples}\ntone = \"{tone}\"\ntransfer = \"{transfer}\"\n\
             [camera]\neye = {eye:?}\ntarget = [0, 0, 0]\n{lens}\n"
        );
        let count = 1 + random.below(2);
        let things = (0..count)
            .map(|number| Thing::new(&mut random, 0.6 * number as f64 - 0.3 * (count - 1) as f64))
            .collect();
        let mut lamps: Vec<Lamp> = (0..=random.below(2)).map(|_| Lamp::new(&mut random)).collect();
        let place = [4.0 * random.unit() - 2.0, 5.0 + 6.0 * random.unit(), 4.0 * random.unit() - 2.0];
        match random.below(6) {
            0 => lamps.push(Lamp::Square(place, 0.2 + random.unit(), 12.0 * random.unit())),
            1 => {
                let axis = [0.3 * random.unit() - place[0], -place[1], 0.3 * random.unit() - place[2]];
                let cone = (
                    axis,
                    12.0 + 40.0 * random.unit(),
                    if random.one_in(2) { 0.0 } else { 8.0 * random.unit() },
                );
                lamps.push(Lamp::Spot(place, 40.0 * random.unit(), true, cone));
            }
            _ => {}
        }
        // Each light adds its part without guards, too.
        let guards = if random.one_in(5) { "guards = { diffuse = false, highlight = false }\n" } else { "" };
        let head = head.replace("[camera]", &format!("{guards}[camera]"));
        Self { head, things, lamps }
    }

    /// The scene of a seed with a strong lamp and four that add a few steps each. Some of these can be omitted together, and those that
    /// save most are not always among them.
    pub fn with_weak_lamps(seed: u64) -> Self {
        let mut random = Random(seed.wrapping_mul(0x9876_5431));
        let mut weak = || {
            let lamp = Lamp::new(&mut random);
            let share = 0.005 + 0.015 * random.unit();
            match lamp {
                Lamp::Ambient(_) => Lamp::Ambient(share),
                Lamp::Sun(towards, _) => Lamp::Sun(towards, share),
                Lamp::Spot(..) | Lamp::Square(..) => lamp,
                Lamp::Point(position, _, is_attenuated) => {
                    let square: f64 = position.iter().map(|x| x * x).sum();
                    Lamp::Point(position, if is_attenuated { share * square } else { share }, is_attenuated)
                }
            }
        };
        let mut lamps = vec![Lamp::Sun([1.0, 2.0, 3.0], 0.7)];
        lamps.extend((0..4).map(|_| weak()));
        Self { lamps, ..Self::new(seed) }
    }

    pub fn text(&self) -> String {
        self.text_of(&self.things, &self.lamps.iter().copied().map(Some).collect::<Vec<_>>())
    }

    /// The scene with other models.
    pub fn text_of(&self, things: &[Thing], lamps: &[Option<Lamp>]) -> String {
        let mut lights: String = lamps.iter().flatten().map(Lamp::text).collect();
        if lights.is_empty() {
            // A scene without any light has default lights.
            lights = Lamp::Ambient(0.0).text();
        }
        let things: String = things.iter().map(Thing::text).collect();
        format!("{}{lights}{things}", self.head)
    }

    /// Axes in random order, as many as leave at most so many combinations, and the number of these.
    pub fn open_axes(&self, seed: u64, most: usize) -> (Vec<Axis>, usize) {
        let mut random = Random(seed);
        let mut rest = Axis::ALL.to_vec();
        let (mut open, mut count) = (Vec::new(), 1);
        while !rest.is_empty() {
            let axis = rest.swap_remove(random.below(rest.len()));
            let more: Vec<Axis> = open.iter().copied().chain([axis]).collect();
            let models: usize = self.things.iter().map(|thing| thing.models(&more).len()).product();
            let lights: usize = match more.contains(&Axis::Lights) {
                true => self.lamps.iter().map(|lamp| lamp.models([0.0; 3]).len()).product(),
                false => 1,
            };
            if models * lights <= most {
                (open, count) = (more, models * lights);
            }
        }
        (open, count)
    }
}
