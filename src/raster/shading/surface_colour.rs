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
