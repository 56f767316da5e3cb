//! The source of an object's colour: shaders of its material, or colours of its vertices.

use crate::num::LinearRgb;
use crate::shade::{
    Light, Material, NotFinite, SeenFrom, ShadeError, ShadeSettings, Shader, SurfacePoint, SurfaceRows,
};
use glam::DVec3;

pub(crate) enum ObjectColour<'a> {
    /// Light on a material.
    Lit(Box<Shaders>),
    /// A colour for each vertex.
    Given(&'a [LinearRgb]),
}

/// Shaders of a material: in single precision for rows of points, in double precision for points that it rounds to a light.
pub(crate) struct Shaders {
    single: Shader<f32>,
    double: Shader<f64>,
}

impl Shaders {
    pub(crate) fn new(
        lights: &[Light],
        material: &Material,
        settings: &ShadeSettings,
    ) -> Result<Self, ShadeError> {
        let single = Shader::new(lights, material, settings)?;
        Ok(Self { single, double: Shader::new(lights, material, settings)? })
    }

    pub(crate) fn needs_positions(&self) -> bool {
        self.single.needs_positions()
    }

    /// Shades rows of points, on faces with normals if there are any.
    ///
    /// A point may have been rounded to the position of a lamp: without a finite colour it is shaded in double
    /// precision at
    /// `exactly`, in the frame of the settings. It is an error only if that colour is not finite either.
    pub(crate) fn shade_rows(
        &self,
        rows: &SurfaceRows,
        mut out: [&mut [f32]; 3],
        exactly: impl Fn(usize) -> DVec3,
    ) -> Result<(), NotFinite> {
        let in_rows = out.each_mut().map(|row| &mut **row);
        match self.single.shade_rows(rows, in_rows) {
            Err(_) if self.needs_positions() => {
                // One by one: what is finite has the bits that it has in rows, whatever its neighbours are.
                (0..out[0].len()).try_for_each(|index| {
                    let at = |rows: [&[f32]; 3]| rows.map(|row| row[index]);
                    let colour =
                        self.shade_alone(at(rows.positions), at(rows.normals), rows.faces.map(at), || {
                            exactly(index)
                        });
                    let colour = colour.map_err(|error| NotFinite { index, ..error })?;
                    out.iter_mut().zip(colour).for_each(|(row, component)| row[index] = component);
                    Ok(())
                })
            }
            done => done,
        }
    }

    fn shade_alone(
        &self,
        position: [f32; 3],
        normal: [f32; 3],
        face: Option<[f32; 3]>,
        exactly: impl FnOnce() -> DVec3,
    ) -> Result<[f32; 3], NotFinite> {
        let point = SurfacePoint { position, normal };
        self.single.shade_on(&point, face).or_else(|rounded| {
            let point = SurfacePoint { position: exactly().to_array(), normal: wide(normal) };
            narrow(self.double.shade_on(&point, face.map(wide))?).ok_or(rounded)
        })
    }

    /// Shades the point of a ray, with the bits of [`shade_rows`](Self::shade_rows) where all lights are visible and the ray is the
    /// viewer's; see [`Shader::shade_ray`].
    pub(crate) fn shade_ray(
        &self,
        position: DVec3,
        normal: [f32; 3],
        face: Option<[f32; 3]>,
        seen_from: Option<SeenFrom<f32>>,
        visible: &mut dyn FnMut(usize) -> [f64; 3],
    ) -> Result<[f32; 3], NotFinite> {
        let point = SurfacePoint { position: position.as_vec3().to_array(), normal };
        let mut single = |light: usize| visible(light).map(|share| share as f32);
        self.single.shade_ray(&point, face, seen_from, &mut single).or_else(|rounded| {
            let point = SurfacePoint { position: position.to_array(), normal: wide(normal) };
            let seen_from =
                seen_from.map(|from| SeenFrom { view: wide(from.view), distance: f64::from(from.distance) });
            narrow(self.double.shade_ray(&point, face.map(wide), seen_from, visible)?).ok_or(rounded)
        })
    }
}

fn wide(v: [f32; 3]) -> [f64; 3] {
    v.map(f64::from)
}

/// In single precision, if that is finite.
fn narrow(colour: [f64; 3]) -> Option<[f32; 3]> {
    let colour = colour.map(|component| component as f32);
    colour.iter().all(|component| component.is_finite()).then_some(colour)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::{Degrees, Radians};
    use crate::shade::{AreaShape, Attenuation, Cone};

    /// Numbers from −1 to 1 that are the same in each run: Knuth's 64-bit congruential generator.
    fn numbers() -> impl Iterator<Item = f32> {
        let mut state = 1_u64;
        std::iter::repeat_with(move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 40) as f32 / (1 << 23) as f32 - 1.0
        })
    }

    /// One given hit point and normal has the same bits by rows, which Phong shading draws, and by the shader of traced rays.
    #[test]
    fn a_ray_that_nothing_hides_from_lights_has_the_bits_of_phong_shading() {
        const COUNT: usize = 1000;
        let (position, colour) = (DVec3::new(0.5, 3.0, 2.0), LinearRgb::new(0.9, 0.7, 0.5));
        let half = Radians::from(Degrees(40.0));
        let cone = Cone { axis: DVec3::NEG_Y, cut_off: half, soft_edge: Radians(0.2), exponent: 2.0 };
        let shape = AreaShape::Disc {
            centre: DVec3::new(-2.0, 2.0, 1.0),
            normal: DVec3::new(1.0, -1.0, 0.0),
            radius: 0.5,
        };
        let attenuation = Attenuation::InverseSquare;
        let lights = [
            Light::Ambient { colour },
            Light::Directional { towards: DVec3::new(-0.3, 1.0, 0.5), colour },
            Light::Point { position, colour, attenuation },
            Light::Spot { position, colour, attenuation, cone },
            Light::Area { shape, colour },
        ];
        let shaders = Shaders::new(&lights, &Material::default(), &ShadeSettings::default()).unwrap();
        let mut numbers = numbers();
        let rows: [Vec<f32>; 6] = std::array::from_fn(|_| numbers.by_ref().take(COUNT).collect());
        let [x, y, z, nx, ny, nz] = rows.each_ref().map(|row| &row[..]);
        let rows = SurfaceRows { positions: [x, y, z], normals: [nx, ny, nz], faces: None };
        let mut out: [Vec<f32>; 3] = std::array::from_fn(|_| vec![0.0; COUNT]);
        let exactly = |index: usize| DVec3::new(x[index].into(), y[index].into(), z[index].into());
        shaders.shade_rows(&rows, out.each_mut().map(|row| &mut row[..]), exactly).unwrap();
        let mut lit = 0;
        for index in 0..COUNT {
            let normal = [nx[index], ny[index], nz[index]];
            let ray = shaders.shade_ray(exactly(index), normal, None, None, &mut |_| [1.0; 3]).unwrap();
            let row = out.each_ref().map(|row| row[index]);
            assert_eq!(ray.map(f32::to_bits), row.map(f32::to_bits), "{index}: {ray:?} is not {row:?}");
            lit += usize::from(row[0] > 0.3);
        }
        assert!(lit > COUNT / 4, "{lit} points are lit");
    }
}
