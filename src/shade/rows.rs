//! Many points at once, in blocks of rows that stay in the nearest cache, with one loop for each step. The bits are those of
//! single points.

use super::error::NotFinite;
use super::formula::{self, Triple};
use super::settings::Terminator;
use super::shader::{Shader, SurfacePoint, View, turned};
use super::source::{Highlight, LightTerm, PointSource, PreparedPoint, Source, SpotSource};
use crate::num::{Kernel, Lanes, dispatch};

/// Points of surfaces, a row for each coordinate, in the frame of the settings.
#[derive(Clone, Copy, Debug)]
pub struct SurfaceRows<'a> {
    /// x, y and z of positions. All three may be empty if the shader doesn't [need positions](Shader::needs_positions).
    pub positions: [&'a [f32]; 3],
    /// x, y and z of normals.
    pub normals: [&'a [f32]; 3],
    /// x, y and z of the unit normals of their faces, for the terminator.
    pub faces: Option<[&'a [f32]; 3]>,
}

impl Shader<f32> {
    /// Shades rows of points with the bits of [`shade_on`](Self::shade_on), linear and before the tone rule, into a row for each
    /// of red, green and blue. The longer the rows the better; hundreds of points are enough.
    ///
    /// # Errors
    /// The first point without a finite colour.
    ///
    /// # Panics
    /// If rows differ in length.
    pub fn shade_rows(&self, rows: &SurfaceRows, out: [&mut [f32]; 3]) -> Result<(), NotFinite> {
        let count = out[0].len();
        let check = |row: &[f32]| assert_eq!(row.len(), count, "rows of different lengths");
        let faces = rows.faces.filter(|_| self.terminator != Terminator::Smooth);
        rows.normals.into_iter().chain(faces.into_iter().flatten()).for_each(check);
        out.iter().for_each(|row| check(row));
        if self.needs_positions() {
            rows.positions.into_iter().for_each(check);
        }
        match dispatch(Shading { shader: self, rows, faces, out }) {
            None => Ok(()),
            Some(index) => Err(self.not_finite(index, &self.point(rows, index))),
        }
    }

    fn point(&self, rows: &SurfaceRows, index: usize) -> SurfacePoint<f32> {
        SurfacePoint {
            // Positions may be missing if they are not needed.
            position: rows.positions.map(|row| row.get(index).copied().unwrap_or(f32::NAN)),
            normal: rows.normals.map(|row| row[index]),
        }
    }
}

/// Points in a block: several vectors, few enough that all rows stay in the nearest cache.
const LANES: usize = 128;

type Row = [f32; LANES];

/// The bits of a finite number without its sign are below these.
const INFINITE: u32 = f32::INFINITY.to_bits();

/// One value of each point of a block.
struct Block {
    position: [Row; 3],
    normal: [Row; 3],
    view: [Row; 3],
    view_distance: Row,
    /// L.
    towards: [Row; 3],
    /// Attenuation and cone.
    factor: Row,
    /// The factor of the light's diffuse colour.
    diffuse: Row,
    /// The factor of the light's specular colour.
    specular: Row,
    /// Only for the terminator.
    face: [Row; 3],
    sum: [Row; 3],
}

#[inline(always)]
fn get(rows: &[Row; 3], i: usize) -> Triple<f32> {
    [rows[0][i], rows[1][i], rows[2][i]]
}

#[inline(always)]
fn set(rows: &mut [Row; 3], i: usize, [x, y, z]: Triple<f32>) {
    rows[0][i] = x;
    rows[1][i] = y;
    rows[2][i] = z;
}

struct Shading<'a> {
    shader: &'a Shader<f32>,
    rows: &'a SurfaceRows<'a>,
    /// Normals of faces, if the terminator needs them.
    faces: Option<[&'a [f32]; 3]>,
    out: [&'a mut [f32]; 3],
}

impl Kernel for Shading<'_> {
    /// The first point without a finite colour.
    type Output = Option<usize>;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> Option<usize> {
        let Self { shader, rows, faces, out: [red, green, blue] } = self;
        let zero = [0.0; LANES];
        let mut block = Block {
            position: [zero; 3],
            normal: [zero; 3],
            view: [zero; 3],
            view_distance: zero,
            towards: [zero; 3],
            factor: zero,
            diffuse: zero,
            specular: zero,
            face: [zero; 3],
            sum: [zero; 3],
        };
        if let Some(View::Same([x, y, z])) = shader.view {
            block.view = [[x; LANES], [y; LANES], [z; LANES]];
        }
        let count = red.len();
        for start in (0..count).step_by(LANES) {
            let lanes = start..count.min(start + LANES);
            if shader.needs_normals() {
                block.load(shader, rows, lanes.clone());
            }
            if let Some(faces) = faces {
                for (row, source) in block.face.iter_mut().zip(faces) {
                    row[..lanes.len()].copy_from_slice(&source[lanes.clone()]);
                }
            }
            for term in &shader.lights {
                block.reflect_all(shader, term, lanes.len());
                if faces.is_some() {
                    block.hide(shader, term, lanes.len());
                }
                block.paint(term, lanes.len());
            }
            let out = [&mut red[lanes.clone()], &mut green[lanes.clone()], &mut blue[lanes]];
            if !block.finish(shader, out) {
                let finite = |i: &usize| [&red[*i], &green[*i], &blue[*i]].iter().all(|c| c.is_finite());
                return (start..count).find(|i| !finite(i));
            }
        }
        None
    }
}

impl Block {
    /// Some of the points: all of [`PreparedPoint`].
    #[inline(always)]
    fn load(&mut self, shader: &Shader<f32>, rows: &SurfaceRows, lanes: std::ops::Range<usize>) {
        let count = lanes.len().min(LANES);
        self.sum = [[0.0; LANES]; 3];
        if shader.needs_positions() {
            for (row, source) in self.position.iter_mut().zip(rows.positions) {
                row[..count].copy_from_slice(&source[lanes.clone()]);
            }
        }
        if let Some(View::From(eye)) = shader.view {
            for i in 0..count {
                let (view, distance) = formula::towards(get(&self.position, i), eye);
                set(&mut self.view, i, view);
                self.view_distance[i] = distance;
            }
        }
        let [x, y, z] = rows.normals.map(|row| &row[lanes.start..][..count]);
        if shader.limits.renormalise {
            for i in 0..count {
                set(&mut self.normal, i, formula::normalised([x[i], y[i], z[i]]));
            }
        } else {
            for i in 0..count {
                set(&mut self.normal, i, [x[i], y[i], z[i]]);
            }
        }
        if shader.two_sided {
            for i in 0..count {
                let normal = turned(get(&self.normal, i), get(&self.view, i));
                set(&mut self.normal, i, normal);
            }
        }
    }

    #[inline(always)]
    fn reflect_all(&mut self, shader: &Shader<f32>, term: &LightTerm<f32>, count: usize) {
        match &term.source {
            Source::Directional(towards) => {
                // One constant in place of four rows.
                let at = |_: &Self, _: usize| (*towards, 1.0);
                self.reflect(shader, term, count, at);
            }
            Source::Point(point) => {
                self.arrive(point, count);
                self.reflect(shader, term, count, Self::arrived);
            }
            Source::Spot(point, spot) => {
                self.arrive(point, count);
                self.aim(spot, count);
                self.reflect(shader, term, count, Self::arrived);
            }
            Source::Area(_) => self.reflect_area(shader, term, count),
        }
    }

    /// Applies the terminator. Not inlined: it is rarely needed.
    fn hide(&mut self, shader: &Shader<f32>, term: &LightTerm<f32>, count: usize) {
        for i in 0..count.min(LANES) {
            let normal = get(&self.normal, i);
            let towards = match &term.source {
                Source::Directional(towards) => *towards,
                Source::Point(_) | Source::Spot(..) => get(&self.towards, i),
                Source::Area(_) => term.incoming(&self.point(i), true).towards,
            };
            let share = shader.reaching(get(&self.face, i), normal, towards);
            self.diffuse[i] *= share;
            self.specular[i] *= share;
        }
    }

    #[inline(always)]
    fn paint(&mut self, term: &LightTerm<f32>, count: usize) {
        let count = count.min(LANES);
        let paint = |sum: &mut [Row; 3], colour: Triple<f32>, amount: &Row| {
            for (sum, colour) in sum.iter_mut().zip(colour) {
                for i in 0..count {
                    sum[i] += colour * amount[i];
                }
            }
        };
        if let Some(colour) = term.diffuse {
            paint(&mut self.sum, colour, &self.diffuse);
        }
        if let Some((colour, _)) = term.specular {
            paint(&mut self.sum, colour, &self.specular);
        }
    }

    #[inline(always)]
    fn arrived(&self, i: usize) -> (Triple<f32>, f32) {
        (get(&self.towards, i), self.factor[i])
    }

    #[inline(always)]
    fn arrive(&mut self, point: &PointSource<f32>, count: usize) {
        for i in 0..count.min(LANES) {
            let (towards, _, factor) = point.at(get(&self.position, i));
            set(&mut self.towards, i, towards);
            self.factor[i] = factor;
        }
    }

    #[inline(always)]
    fn aim(&mut self, spot: &SpotSource<f32>, count: usize) {
        let count = count.min(LANES);
        // The row of diffuse factors is not in use yet.
        let powers = &mut self.diffuse;
        match &spot.concentration {
            Some(concentration) => {
                for (i, power) in powers[..count].iter_mut().enumerate() {
                    *power = SpotSource::base(spot.cosine(get(&self.towards, i)));
                }
                concentration.of_row(&mut powers[..count]);
            }
            None => *powers = [1.0; LANES],
        }
        for (i, &power) in powers[..count].iter().enumerate() {
            let towards = get(&self.towards, i);
            self.factor[i] *= spot.factor(towards, spot.cosine(towards), power);
        }
    }

    /// Both kinds of reflection of light that comes from `at`.
    #[inline(always)]
    fn reflect(
        &mut self,
        shader: &Shader<f32>,
        term: &LightTerm<f32>,
        count: usize,
        at: impl Fn(&Self, usize) -> (Triple<f32>, f32),
    ) {
        let count = count.min(LANES);
        if term.diffuse.is_some() {
            for i in 0..count {
                let (towards, factor) = at(self, i);
                self.diffuse[i] = factor * shader.diffuse_cosine(get(&self.normal, i), towards);
            }
        }
        let Some((_, highlight)) = term.specular else { return };
        // Each kind has a loop of its own: no choice at every point.
        match highlight {
            Highlight::Phong => self.cosines(shader, &Highlight::Phong, count, &at),
            Highlight::Blinn => self.cosines(shader, &Highlight::Blinn, count, &at),
            Highlight::BlinnSame(half) => self.cosines(shader, &Highlight::BlinnSame(half), count, &at),
        }
        shader.power.of_row(&mut self.specular[..count]);
        for i in 0..count {
            self.specular[i] *= at(self, i).1;
        }
    }

    #[inline(always)]
    fn cosines(
        &mut self,
        shader: &Shader<f32>,
        highlight: &Highlight<f32>,
        count: usize,
        at: &impl Fn(&Self, usize) -> (Triple<f32>, f32),
    ) {
        for i in 0..count.min(LANES) {
            let (towards, _) = at(self, i);
            let (normal, view) = (get(&self.normal, i), get(&self.view, i));
            self.specular[i] = shader.highlight_cosine(highlight, normal, towards, view);
        }
    }

    /// Area lights are computed point by point.
    fn reflect_area(&mut self, shader: &Shader<f32>, term: &LightTerm<f32>, count: usize) {
        for i in 0..count {
            let point = self.point(i);
            let incoming = term.incoming(&point, term.specular.is_some());
            self.diffuse[i] = shader.diffuse(&incoming, &point);
            if let Some((_, highlight)) = &term.specular {
                self.specular[i] = shader.specular(highlight, &incoming, &point);
            }
        }
    }

    fn point(&self, i: usize) -> PreparedPoint<f32> {
        PreparedPoint {
            position: get(&self.position, i),
            normal: get(&self.normal, i),
            view: get(&self.view, i),
            view_distance: self.view_distance[i],
            own_view: false,
            face: None,
        }
    }

    /// Writes the colours; returns whether all are finite.
    #[inline(always)]
    fn finish(&self, shader: &Shader<f32>, [red, green, blue]: [&mut [f32]; 3]) -> bool {
        let count = red.len().min(LANES).min(green.len()).min(blue.len());
        let mut largest = 0;
        for i in 0..count {
            let [r, g, b] = shader.finish(get(&self.sum, i), self.view_distance[i]);
            (red[i], green[i], blue[i]) = (r, g, b);
            for component in [r, g, b] {
                largest = largest.max(component.abs().to_bits());
            }
        }
        largest < INFINITE
    }
}
