//! Scenes, lights, bodies of triangles with chosen normals, and tiled pictures that experiments share.

use super::error::Result;
use crate::mesh::{Faces, Mesh};
use crate::metric::image_error;
use crate::normals::{Crease, NormalField, NormalRecipe, Weight, compute};
use crate::num::{Degrees, LinearRgb, Radians, Transfer, viridis};
use crate::raster::{
    Camera, Image, Object, Paint, Pixels, Projection, RenderSettings, Scene, Shading, Shape, Statistics,
    Triangles, render,
};
use crate::shade::{Attenuation, Light, Material, Reflectance};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// The background: a grey that differs from black and white surfaces, and that paper shows well.
pub(super) const BACKGROUND: LinearRgb = LinearRgb::grey(0.4);

/// A white surface that only diffuses: its luminance is N·L.
pub(super) fn chalk() -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(LinearRgb::WHITE),
        ..Material::matte(LinearRgb::WHITE)
    }
}

/// A material of white light: its diffuse share, the share of its highlight, and the exponent of that.
pub(super) fn shiny([diffuse, specular]: [f64; 2], exponent: f64) -> Material {
    Material {
        ambient: Reflectance::NONE,
        diffuse: Reflectance::Merged(LinearRgb::grey(diffuse)),
        specular: Reflectance::Merged(LinearRgb::grey(specular)),
        exponent,
        ..Material::default()
    }
}

/// The direction at an angle from the viewer (+z) to the right.
pub(super) fn direction(angle: Degrees) -> DVec3 {
    let (sine, cosine) = libm::sincos(Radians::from(angle).0);
    DVec3::new(sine, 0.0, cosine)
}

pub(super) fn far_light(towards: DVec3) -> Light {
    Light::Directional { towards, colour: LinearRgb::WHITE }
}

/// A white light from far away, turned by an angle from the viewer to the right.
pub(super) fn light_at(angle: Degrees) -> Light {
    far_light(direction(angle))
}

/// A white lamp at a point, whose light does not fade.
pub(super) fn lamp(position: DVec3) -> Light {
    Light::Point { position, colour: LinearRgb::WHITE, attenuation: Attenuation::None }
}

/// A parallel camera that looks at the origin from +z at a window of this height.
pub(super) fn front(height: f64) -> Camera {
    let projection = Projection::Orthographic(height);
    Camera { eye: DVec3::Z * 100.0, target: DVec3::ZERO, up: DVec3::Y, projection, near: 0.0 }
}

/// Both sides lit, linear samples kept, interpolation in the scene.
pub(super) fn settings(size: [u32; 2], shading: Shading) -> RenderSettings {
    RenderSettings { size, shading, two_sided: true, keep_linear: true, ..RenderSettings::default() }
}

pub(super) fn draw(
    objects: Vec<Object>,
    lights: &[Light],
    camera: Camera,
    settings: RenderSettings,
) -> Result<Image> {
    let scene = Scene { objects, lines: Vec::new(), lights: lights.to_vec(), camera, background: BACKGROUND };
    Ok(render(&scene, &settings)?)
}

pub(super) fn object<'a>(mesh: &'a Mesh, normals: &'a NormalField, material: Material) -> Object<'a> {
    Object::new(Shape::Mesh { mesh, normals }, material)
}

/// A mesh with its normals as an object whose vertices have these colours, unlit.
pub(super) fn painted<'a>(mesh: &'a Mesh, normals: &'a NormalField, colours: &'a [LinearRgb]) -> Object<'a> {
    Object { paint: Paint::Given(colours.into()), ..object(mesh, normals, Material::default()) }
}

pub(super) fn build(positions: Vec<DVec3>, faces: Faces) -> Result<Mesh> {
    Ok(Mesh::new(positions, faces)?)
}

/// A mesh of sheets of quadrilaterals in so many columns and rows, over the positions of their corners row by row.
pub(super) fn sheets(positions: Vec<DVec3>, [columns, rows]: [u32; 2]) -> Result<Mesh> {
    let (row, sheet) = (columns + 1, (columns + 1) * (rows + 1));
    let mut faces = Faces::new();
    for first in (0..positions.len() as u32).step_by(sheet as usize) {
        for corner in (0..columns * rows).map(|k| first + k / columns * row + k % columns) {
            faces.push(&[0, 1, row + 1, row].map(|step| corner + step));
        }
    }
    build(positions, faces)
}

/// Normals by a weight, smooth over every edge.
pub(super) fn smooth(mesh: &Mesh, weight: Weight) -> NormalField {
    compute(mesh, &NormalRecipe { weight, crease: Crease::OFF, ..NormalRecipe::default() })
}

/// The linear samples of a picture, which every picture of an experiment has.
pub(super) fn linear(image: &Image) -> &[[f32; 3]] {
    image.linear.as_deref().unwrap_or_default()
}

/// The linear colour of a pixel; not a number outside the picture.
pub(super) fn colour_at(image: &Image, [x, y]: [u32; 2]) -> DVec3 {
    image.index(x, y).map_or(DVec3::NAN, |index| DVec3::from(linear(image)[index].map(f64::from)))
}

pub(super) fn centre(image: &Image) -> DVec3 {
    colour_at(image, image.size.map(|side| side / 2))
}

/// The largest error of a component of a pixel, and the root mean square of all.
pub(super) fn errors(image: &Image, truth: &Image) -> Result<[f64; 2]> {
    let error = image_error(image, truth, 0.5)?.linear;
    Ok([error.max / 255.0, error.rms / 255.0])
}

pub(super) fn largest_error(image: &Image, truth: &Image) -> Result<f64> {
    Ok(errors(image, truth)?[0])
}

pub(super) fn luminance(image: &Image) -> Vec<f64> {
    linear(image).iter().map(|&colour| LinearRgb::from(colour.map(f64::from)).luminance()).collect()
}

pub(super) fn picture(size: [u32; 2], linear: Vec<[f32; 3]>, coverage: Vec<u8>) -> Image {
    let code = |component: f32| Transfer::Srgb.to_u8(f64::from(component).clamp(0.0, 1.0));
    Image {
        size,
        pixels: Pixels::Eight(linear.iter().map(|colour| colour.map(code)).collect()),
        coverage,
        linear: Some(linear),
        objects: None,
        statistics: Statistics::default(),
    }
}

/// Numbers from 0 to `full` as colours of the map *viridis*, which are distinct without colour vision. `None` is background.
pub(super) fn map(size: [u32; 2], values: &[Option<f64>], full: f64) -> Image {
    let colour = |value: f64| viridis(value / full).to_array().map(|component| component as f32);
    let background = BACKGROUND.to_array().map(|component| component as f32);
    let linear = values.iter().map(|value| value.map_or(background, colour)).collect();
    picture(size, linear, values.iter().map(|value| u8::from(value.is_some())).collect())
}

/// The largest difference of components, pixel by pixel, where both pictures are covered.
pub(super) fn differences(first: &Image, second: &Image) -> Vec<Option<f64>> {
    let (colours, others) = (linear(first), linear(second));
    let difference = |pixel: usize| {
        let pairs = colours[pixel].into_iter().zip(others[pixel]);
        let largest = pairs.map(|(a, b)| (f64::from(a) - f64::from(b)).abs()).fold(0.0, f64::max);
        (first.coverage[pixel] > 0 && second.coverage[pixel] > 0).then_some(largest)
    };
    (0..colours.len()).map(difference).collect()
}

pub(super) fn largest_difference(first: &Image, second: &Image) -> f64 {
    differences(first, second).into_iter().flatten().fold(0.0, f64::max)
}

/// What is free between pictures that are shown as one, in pixels.
pub(super) const GAP: u32 = 2;

/// Pictures of one size as one: rows of them, with a narrow gap of background between.
pub(super) fn tiles(rows: &[Vec<Image>]) -> Image {
    let [width, height] = rows.first().and_then(|row| row.first()).map_or([0; 2], |image| image.size);
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0) as u32;
    let side = |count: u32, length: u32| (count * (length + GAP)).saturating_sub(GAP);
    let size = [side(columns, width), side(rows.len() as u32, height)];
    let background = BACKGROUND.to_array().map(|component| component as f32);
    let (mut colours, mut coverage) = (Vec::new(), Vec::new());
    for (y, x) in (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (y, x))) {
        let tile =
            rows.get((y / (height + GAP)) as usize).and_then(|row| row.get((x / (width + GAP)) as usize));
        let pixel = tile.and_then(|tile| Some((tile, tile.index(x % (width + GAP), y % (height + GAP))?)));
        colours.push(pixel.map_or(background, |(tile, index)| linear(tile)[index]));
        coverage.push(pixel.map_or(0, |(tile, index)| tile.coverage[index]));
    }
    picture(size, colours, coverage)
}

/// The corners of a box about the origin. Bits of their numbers say on which side of each axis they lie.
pub(super) fn box_corners(sides: DVec3) -> Vec<DVec3> {
    let sign = |k: u32, bit: u32| if k >> bit & 1 == 0 { -0.5 } else { 0.5 };
    (0..8).map(|k| sides * DVec3::new(sign(k, 0), sign(k, 1), sign(k, 2))).collect()
}

/// The faces of a box by its corners, counter-clockwise from outside: of each axis the low and the high one.
pub(super) const BOX_FACES: [[u32; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

#[derive(Clone, Debug)]
pub(super) struct TriangleMesh {
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) face_normals: Vec<[f32; 3]>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Diagonal {
    /// From the lower left to the upper right.
    Rising,
    /// From the upper left to the lower right.
    Falling,
}

impl TriangleMesh {
    /// Triangles with area only: others have no normal and are omitted.
    pub(super) fn new(positions: &[DVec3], triangles: Vec<[u32; 3]>, normals: &[DVec3]) -> Self {
        let single = |v: &DVec3| v.as_vec3().to_array();
        let area = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|vertex| positions[vertex as usize]);
            (b - a).cross(c - a).try_normalize()
        };
        let (triangles, face_normals) =
            triangles.into_iter().filter_map(|t| Some((t, area(&t)?.as_vec3().to_array()))).unzip();
        Self {
            positions: positions.iter().map(single).collect(),
            triangles,
            normals: normals.iter().map(single).collect(),
            face_normals,
        }
    }

    /// Squares over 0…1 by 0…1, so many each way, cut into triangles; `point` gives a place and its normal.
    pub(super) fn grid(
        cells: [u32; 2],
        diagonal: Diagonal,
        point: impl Fn(f64, f64) -> (DVec3, DVec3),
    ) -> Self {
        let [columns, rows] = cells;
        let at = |k: u32| {
            let (u, v) = (k % (columns + 1), k / (columns + 1));
            point(f64::from(u) / f64::from(columns), f64::from(v) / f64::from(rows))
        };
        let (positions, normals): (Vec<DVec3>, Vec<DVec3>) = (0..(columns + 1) * (rows + 1)).map(at).unzip();
        let cut = |k: u32| {
            let a = k / columns * (columns + 1) + k % columns;
            let (b, c, d) = (a + 1, a + columns + 2, a + columns + 1);
            match diagonal {
                Diagonal::Rising => [[a, b, c], [a, c, d]],
                Diagonal::Falling => [[a, b, d], [b, c, d]],
            }
        };
        Self::new(&positions, (0..columns * rows).flat_map(cut).collect(), &normals)
    }

    /// The unit sphere with its own normals: circles of so many vertices around the y axis, of which one is the
    /// equator. A vertex of the equator is rotated from +z to the right by an angle in radians.
    pub(super) fn globe(segments: u32, turn: f64) -> Self {
        let rows = 2 * segments.div_ceil(4);
        Self::grid([segments, rows], Diagonal::Rising, |u, v| {
            let (latitude, longitude) = (PI * (v - 0.5), TAU * u + turn);
            // Of the poles, exactly one point each, so that their triangles are seen to have no area.
            let ring = if v == 0.0 || v == 1.0 { 0.0 } else { libm::cos(latitude) };
            let place =
                DVec3::new(ring * libm::sin(longitude), libm::sin(latitude), ring * libm::cos(longitude));
            (place, place)
        })
    }

    pub(super) fn object(&self, material: Material) -> Object<'_> {
        let Self { positions, triangles, normals, face_normals } = self;
        Object::new(Shape::Triangles(Triangles { positions, triangles, normals, face_normals }), material)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_stand_in_rows() {
        let grey = |value: f32| picture([3, 1], vec![[value; 3]; 3], vec![1; 3]);
        let all = tiles(&[vec![grey(0.1), grey(0.2)], vec![grey(0.3)]]);
        assert_eq!(all.size, [8, 4]);
        assert_eq!(all.coverage.iter().filter(|&&covered| covered > 0).count(), 9);
        let at = |x, y| linear(&all)[all.index(x, y).unwrap()][0];
        assert_eq!([at(0, 0), at(5, 0), at(2, 3)], [0.1, 0.2, 0.3]);
    }

    #[test]
    fn maps_get_lighter_all_the_way() {
        let values: Vec<Option<f64>> = (0..=40).map(|k| Some(f64::from(k) / 40.0)).collect();
        let shown = luminance(&map([41, 1], &values, 1.0));
        assert!(shown.windows(2).all(|pair| pair[1] > pair[0]), "{shown:?}");
    }
}
