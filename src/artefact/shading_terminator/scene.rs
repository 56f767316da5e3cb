//! Light on a sphere and on a prism, one facet of which turns away from it.

use super::super::prelude::*;
use crate::shade::Terminator;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The window's side; prism and sphere have the radius 1.
pub(super) const WINDOW: f64 = 2.2;
/// How high the light stands over the sphere, so that its border crosses facets obliquely.
pub(super) const HEIGHT: Degrees = Degrees(25.0);
/// No height at all: light at right angles to the prism.
pub(super) const LEVEL: Degrees = Degrees(0.0);

/// The direction of a light at an angle from the viewer to the right, raised by another.
pub(super) fn towards(light: Degrees, height: Degrees) -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(light).0);
    let (up, along) = libm::sincos(Radians::from(height).0);
    DVec3::new(sine * along, up, cosine * along)
}

pub(super) fn paint(
    mesh: &TriangleMesh,
    towards: DVec3,
    terminator: Terminator,
    size: [u32; 2],
) -> Result<Image> {
    picture(mesh.object(chalk()), towards, (Shading::Phong, terminator), size)
}

pub(super) fn picture(
    object: Object,
    towards: DVec3,
    (shading, terminator): (Shading, Terminator),
    size: [u32; 2],
) -> Result<Image> {
    let settings = RenderSettings { terminator, ..settings(size, shading) };
    let height = WINDOW * f64::from(size[1]) / f64::from(size[0]);
    draw(vec![object], &[far_light(towards)], front(height), settings)
}

/// 1 for pixels whose normal faces the light and whose facet does not, 0 for others.
pub(super) fn concerned(mesh: &TriangleMesh, towards: DVec3, size: u32) -> Result<Vec<Option<f64>>> {
    let normals = |shading| {
        let settings = RenderSettings { show: Show::Normals, ..settings([size; 2], shading) };
        draw(vec![mesh.object(chalk())], &[], front(WINDOW), settings)
    };
    let light_on = |colour: &[f32; 3]| (DVec3::from(colour.map(f64::from)) * 2.0 - 1.0).dot(towards);
    let (smooth, faces) = (normals(Shading::Phong)?, normals(Shading::Flat)?);
    let pairs = linear(&smooth).iter().zip(linear(&faces)).zip(&smooth.coverage);
    let is_concerned = |((own, face), &covered): ((&[f32; 3], &[f32; 3]), &u8)| {
        (covered > 0).then(|| f64::from(u8::from(light_on(own) > 0.0 && light_on(face) <= 0.0)))
    };
    Ok(pairs.map(is_concerned).collect())
}

pub(super) fn share(map: &[Option<f64>]) -> f64 {
    let covered: Vec<f64> = map.iter().flatten().copied().collect();
    covered.iter().sum::<f64>() / covered.len().max(1) as f64
}

/// The mean of values on pixels that a map has 1 for; 0 if there are none.
pub(super) fn mean_where(map: &[Option<f64>], values: &[Option<f64>]) -> f64 {
    let is_meant = |(&mark, &value): (&Option<f64>, &Option<f64>)| value.filter(|_| mark == Some(1.0));
    let meant: Vec<f64> = map.iter().zip(values).filter_map(is_meant).collect();
    meant.iter().sum::<f64>() / meant.len().max(1) as f64
}

const PICTURES: u32 = 8;

/// A prism of radius 1 about the y axis with the cylinder's normals, an edge towards the viewer.
pub(super) struct Prism {
    pub(super) segments: u32,
    pub(super) size: u32,
}

impl Prism {
    pub(super) fn mesh(&self) -> TriangleMesh {
        TriangleMesh::grid([self.segments, 1], Diagonal::Rising, |u, v| {
            let (sine, cosine) = libm::sincos(TAU * u);
            (DVec3::new(sine, 1.6 * v - 0.8, cosine), DVec3::new(sine, 0.0, cosine))
        })
    }

    fn delta(&self) -> f64 {
        TAU / f64::from(self.segments)
    }

    /// The turn of the light between the two measured pictures: a 45th of a facet's angle, which lights a facet softly.
    pub(super) fn turn(&self) -> Degrees {
        Degrees(360.0 / f64::from(self.segments) / 45.0)
    }

    /// How far it turns from each picture of a film to the next.
    pub(super) fn step(&self) -> Degrees {
        Degrees(4.0 * self.turn().0)
    }

    /// Whether a place across the prism has a positive cosine on a facet turned away; `None` outside the prism.
    fn is_concerned(&self, x: f64, light: f64) -> Option<bool> {
        let of_facet = |facet: u32| {
            let edge = |k: u32| f64::from(facet + k) * self.delta();
            let middle = 0.5 * (edge(0) + edge(1));
            let (low, high) = (libm::sin(edge(0)), libm::sin(edge(1)));
            if libm::cos(middle) <= 0.0 || !(low..high).contains(&x) {
                return None;
            }
            let [a, b] = [0, 1].map(|k| libm::cos(edge(k) - light));
            let own = a + (b - a) * (x - low) / (high - low);
            Some(own > 0.0 && libm::cos(middle - light) <= 0.0)
        };
        (0..self.segments).find_map(of_facet)
    }

    /// The share of concerned pixels by the formulas, and the share that snapping and single precision leave undetermined.
    pub(super) fn share_law(&self, light: Degrees) -> (f64, f64) {
        const SINGLE: f64 = 1e-6;
        let light = Radians::from(light).0;
        let pixel = WINDOW / f64::from(self.size);
        let (mut concerned, mut open, mut seen) = (0.0, 0.0, 0.0);
        for k in 0..self.size {
            let x = (f64::from(k) + 0.5) * pixel - 0.5 * WINDOW;
            let here = self.is_concerned(x, light);
            let near = [(-1.0, 0.0), (1.0, 0.0), (0.0, -SINGLE), (0.0, SINGLE)];
            let near =
                near.map(|(aside, turned)| self.is_concerned(x + aside * pixel / 256.0, light + turned));
            seen += if here.is_some() { 1.0 } else { 0.0 };
            concerned += if here == Some(true) { 1.0 } else { 0.0 };
            open += if near.iter().any(|&other| other != here) { 1.0 } else { 0.0 };
        }
        // And roundings of the quotient.
        (concerned / seen, open / seen + 1e-12)
    }

    /// The light that makes the facet left of the middle turn away, and somewhat more.
    fn light(&self, more: f64) -> Degrees {
        Degrees(Degrees::from(Radians(FRAC_PI_2 - 0.5 * self.delta())).0 + more)
    }

    fn row(&self, light: Degrees, terminator: Terminator) -> Result<Vec<f64>> {
        let image = paint(&self.mesh(), towards(light, LEVEL), terminator, [self.size, 1])?;
        Ok(linear(&image).iter().map(|colour| f64::from(colour[0])).collect())
    }

    /// The pixels of that facet, all but those at its edges, with their places.
    fn facet(&self) -> impl Iterator<Item = (usize, f64)> {
        let place = |pixel: u32| ((f64::from(pixel) + 0.5) / f64::from(self.size) - 0.5) * WINDOW;
        let low = libm::sin(-self.delta());
        let pixel = WINDOW / f64::from(self.size);
        let inside = move |x: f64| x > low + 0.1 * pixel && x < -0.1 * pixel;
        (0..self.size).map(move |k| (k as usize, place(k))).filter(move |&(_, x)| inside(x))
    }

    /// The prism while the light turns, from top to bottom: the facet turns away in the middle.
    pub(super) fn film(&self, terminator: Terminator) -> Result<Image> {
        let height = self.size / PICTURES - GAP;
        let picture = |k: u32| {
            let more = self.step().0 * (f64::from(k) - 0.5 * f64::from(PICTURES) - 0.5);
            Ok(vec![paint(&self.mesh(), towards(self.light(more), LEVEL), terminator, [self.size, height])?])
        };
        Ok(tiles(&(1..=PICTURES).map(picture).collect::<Result<Vec<_>>>()?))
    }

    /// The largest change on that facet when the light turns.
    pub(super) fn pop(&self, terminator: Terminator) -> Result<f64> {
        let half = 0.5 * self.turn().0;
        let [before, after] = [-half, half].map(|more| self.row(self.light(more), terminator));
        let (before, after) = (before?, after?);
        Ok(self.facet().map(|(k, _)| (before[k] - after[k]).abs()).fold(0.0, f64::max))
    }

    pub(super) fn pop_law(&self, terminator: Terminator) -> f64 {
        let half = 0.5 * self.turn().0;
        let change = |(_, x): (usize, f64)| {
            let [before, after] = [-half, half].map(|more| self.law(x, self.light(more), terminator));
            (before - after).abs()
        };
        self.facet().map(change).fold(0.0, f64::max)
    }

    fn law(&self, x: f64, light: Degrees, terminator: Terminator) -> f64 {
        let delta = self.delta();
        // 0 at the edge in the middle, 1 at the other.
        let t = x / libm::sin(-delta);
        let normal = DVec3::new(-t * libm::sin(delta), 0.0, (1.0 - t) + t * libm::cos(delta)).normalize();
        let face = DVec3::new(-libm::sin(0.5 * delta), 0.0, libm::cos(0.5 * delta));
        let towards = towards(light, LEVEL);
        let (own, of_face) = (normal.dot(towards).max(0.0), face.dot(towards));
        let g = of_face / (own * face.dot(normal));
        own * match terminator {
            Terminator::Smooth => 1.0,
            _ if of_face <= 0.0 => 0.0,
            Terminator::Soft if g < 1.0 => ((1.0 - g) * g + 1.0) * g,
            _ => 1.0,
        }
    }

    pub(super) fn chart(&self, out: &mut Recorder) -> Result<()> {
        let pixel = self.facet().last().map_or(0, |(pixel, _)| pixel);
        let mut curves = Vec::new();
        for (name, terminator, drawn) in [
            ("smooth", Terminator::Smooth, Drawn::Guide),
            ("hard", Terminator::Hard, Drawn::Line),
            ("soft", Terminator::Soft, Drawn::Line),
        ] {
            let mut points = Vec::new();
            for k in -20..=10 {
                let light = self.light(self.turn().0 * (f64::from(k) - 0.5));
                points.push([light.0, self.row(light, terminator)?[pixel]]);
            }
            curves.push(out.curve(name, drawn, points));
        }
        out.chart("popping", [Axis::Linear; 2], curves);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Picture by picture the film is what the formulas say: hard, the facet goes out at once, from sin(Δ/2) on; softened, no
    /// step is half as large.
    #[test]
    fn films_pop_and_fade() {
        let prism = Prism { segments: 16, size: 160 };
        let height = prism.size / PICTURES - GAP;
        let (pixel, x) = prism.facet().last().unwrap();
        let [hard, soft] = [Terminator::Hard, Terminator::Soft].map(|terminator| {
            let film = prism.film(terminator).unwrap();
            let shown: Vec<f64> = (0..PICTURES)
                .map(|k| {
                    let index = film.index(pixel as u32, k * (height + GAP) + height / 2).unwrap();
                    let more = prism.step().0 * (f64::from(k) - 3.5);
                    let law = prism.law(x, prism.light(more), terminator);
                    // Edges snap to 1/256 pixel, and light changes by less than 2 over the width of a pixel.
                    assert!((f64::from(linear(&film)[index][0]) - law).abs() < 2e-3, "{more}: {law}");
                    law
                })
                .collect();
            shown.windows(2).map(|pair| (pair[0] - pair[1]).abs()).fold(0.0, f64::max)
        });
        assert!(hard > libm::sin(0.5 * prism.delta()) && soft < 0.5 * hard, "{hard} {soft}");
    }
}
