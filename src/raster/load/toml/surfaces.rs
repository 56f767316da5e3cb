//! The analytic surfaces of a scene file.

use crate::raster::load::toml::keys::{PatternKeys, SurfaceKeys, TessellationKeys};
use crate::raster::load::toml::values::Number;
use crate::surface::{
    Catenoid, Cone, Cylinder, Ellipsoid, MonkeySaddle, Pattern, Plane, Sphere, Superquadric, Surface,
    SurfaceError, Tessellation, Torus, Wave,
};

pub(super) fn surface(keys: SurfaceKeys) -> Result<Surface, SurfaceError> {
    Ok(match keys {
        SurfaceKeys::Plane { width, height } => Plane::new(width.0, height.0)?.into(),
        SurfaceKeys::Sphere { radius } => Sphere::new(radius.0)?.into(),
        SurfaceKeys::Ellipsoid { semi_axes } => Ellipsoid::new(semi_axes.get())?.into(),
        SurfaceKeys::Cylinder { radius, height } => Cylinder::new(radius.0, height.0)?.into(),
        SurfaceKeys::Cone { radius, height } => Cone::new(radius.0, height.0)?.into(),
        SurfaceKeys::Torus { major, minor } => Torus::new(major.0, minor.0)?.into(),
        SurfaceKeys::Catenoid { waist, height } => Surface::Catenoid(Catenoid::new(waist.0, height.0)?),
        SurfaceKeys::Wave { size } => Surface::Wave(Wave::new(size.0)?),
        SurfaceKeys::MonkeySaddle { size } => Surface::MonkeySaddle(MonkeySaddle::new(size.0)?),
        SurfaceKeys::Superquadric { semi_axes, roundness: [Number(north), Number(east)] } => {
            Surface::Superquadric(Superquadric::new(semi_axes.get(), north, east)?)
        }
        SurfaceKeys::Teapot {} => Surface::Teapot,
    })
}

pub(super) fn tessellation(keys: &TessellationKeys) -> Tessellation {
    let default = Tessellation::default();
    Tessellation {
        pattern: match keys.pattern {
            PatternKeys::Triangles => Pattern::Triangles,
            PatternKeys::Stretched(Number(ratio)) => Pattern::Stretched(ratio),
            PatternKeys::Slivers(Number(ratio)) => Pattern::Slivers(ratio),
            PatternKeys::Quads => Pattern::Quads,
            PatternKeys::Polygons => Pattern::Polygons,
            PatternKeys::Icosphere(level) => Pattern::Icosphere(level),
            PatternKeys::Marching => Pattern::Marching,
            PatternKeys::Scattered => Pattern::Scattered,
        },
        segments: keys.segments.unwrap_or(default.segments),
        jitter: keys.jitter.map_or(default.jitter, |Number(jitter)| jitter),
        noise: keys.noise.map_or(default.noise, |Number(noise)| noise),
        seed: keys.seed.unwrap_or(default.seed),
        uvs: default.uvs,
    }
}
