//! Options of `crease surface` made into a surface and a tessellation.

use super::args::{Kind, PatternArgs, PatternName, ShapeArgs, SurfaceArgs};
use crate::cli::common::choice::Choose;
use crate::cli::common::output::{Target, file_target};
use crease::io::Format;
use crease::surface::{
    Catenoid, Cone, Cylinder, Ellipsoid, MonkeySaddle, Pattern, Plane, Sphere, Superquadric, Surface,
    SurfaceError, Tessellation, Torus, Wave,
};
use glam::{DMat4, DQuat, DVec3};

/// Everything to do, checked as far as it can be before it is done.
#[derive(Debug)]
pub struct Request {
    pub surface: Surface,
    pub tessellation: Tessellation,
    pub placement: DMat4,
    pub target: Target,
    pub format: Format,
}

impl Request {
    /// Checks the options. All errors are wrong usage.
    pub fn resolve(args: &SurfaceArgs) -> Result<Self, String> {
        check_shape(args.kind, &args.shape)?;
        let surface = surface(args.kind, &args.shape).map_err(|error| error.to_string())?;
        let (target, format) = file_target(&args.output, args.to)?;
        let format = format.ok_or("standard output needs --to, to know the format")?;
        Ok(Self {
            surface,
            tessellation: tessellation(args.kind, &args.mesh)?,
            placement: DMat4::from_scale_rotation_translation(
                args.shape.scale,
                DQuat::IDENTITY,
                args.shape.offset,
            ),
            target,
            format,
        })
    }

    /// The output's name without extension, for its companion files; `None` for a stream.
    pub fn stem(&self) -> Option<String> {
        let Target::File(path) = &self.target else { return None };
        Some(path.file_stem()?.to_string_lossy().into_owned())
    }
}

/// The options that each surface has.
fn options_of(kind: Kind) -> &'static [&'static str] {
    match kind {
        Kind::Plane | Kind::Wave | Kind::MonkeySaddle => &["--size"],
        Kind::Sphere => &["--radius"],
        Kind::Ellipsoid => &["--semi-axes"],
        Kind::Cylinder | Kind::Cone => &["--radius", "--height"],
        Kind::Torus => &["--major", "--minor"],
        Kind::Catenoid => &["--waist", "--height"],
        Kind::Superquadric => &["--semi-axes", "--roundness"],
        Kind::Bezier | Kind::Teapot => &[],
    }
}

/// An option that the surface does not have would go unnoticed.
fn check_shape(kind: Kind, shape: &ShapeArgs) -> Result<(), String> {
    let typed = [
        ("--radius", shape.radius.is_some()),
        ("--height", shape.height.is_some()),
        ("--major", shape.major.is_some()),
        ("--minor", shape.minor.is_some()),
        ("--waist", shape.waist.is_some()),
        ("--size", shape.size.is_some()),
        ("--semi-axes", shape.semi_axes.is_some()),
        ("--roundness", shape.roundness.is_some()),
    ];
    let name = kind.choice();
    if matches!(kind, Kind::Wave | Kind::MonkeySaddle) && shape.size.is_some_and(|[w, h]| w != h) {
        return Err(format!("{name} has one --size only"));
    }
    let has = options_of(kind);
    let Some((option, _)) = typed.iter().find(|(option, typed)| *typed && !has.contains(option)) else {
        return Ok(());
    };
    Err(match has {
        [] => format!("{name} has no {option}; --scale makes it larger"),
        _ => format!("{name} has no {option}; it has {}", has.join(" and ")),
    })
}

fn surface(kind: Kind, shape: &ShapeArgs) -> Result<Surface, SurfaceError> {
    let or = |typed: Option<f64>, default: f64| typed.unwrap_or(default);
    let [width, height] = shape.size.unwrap_or(Plane::default().size().to_array());
    Ok(match kind {
        Kind::Plane => Plane::new(width, height)?.into(),
        Kind::Sphere => Sphere::new(or(shape.radius, Sphere::default().radius()))?.into(),
        Kind::Ellipsoid => {
            Ellipsoid::new(shape.semi_axes.unwrap_or(Ellipsoid::default().semi_axes()))?.into()
        }
        Kind::Cylinder => {
            let usual = Cylinder::default();
            Cylinder::new(or(shape.radius, usual.radius()), or(shape.height, usual.height()))?.into()
        }
        Kind::Cone => {
            let usual = Cone::default();
            Cone::new(or(shape.radius, usual.radius()), or(shape.height, usual.height()))?.into()
        }
        Kind::Torus => {
            let usual = Torus::default();
            Torus::new(or(shape.major, usual.major()), or(shape.minor, usual.minor()))?.into()
        }
        Kind::Catenoid => {
            let usual = Catenoid::default();
            let (waist, height) = (or(shape.waist, usual.waist()), or(shape.height, usual.height()));
            Surface::Catenoid(Catenoid::new(waist, height)?)
        }
        Kind::Wave => Surface::Wave(Wave::new(width)?),
        Kind::MonkeySaddle => Surface::MonkeySaddle(MonkeySaddle::new(width)?),
        Kind::Superquadric => {
            let usual = Superquadric::default();
            let [north, east] = shape.roundness.unwrap_or(usual.roundness());
            let semi_axes: DVec3 = shape.semi_axes.unwrap_or(usual.semi_axes());
            Surface::Superquadric(Superquadric::new(semi_axes, north, east)?)
        }
        Kind::Bezier => Surface::Patch(Box::default()),
        Kind::Teapot => Surface::Teapot,
    })
}

fn tessellation(kind: Kind, args: &PatternArgs) -> Result<Tessellation, String> {
    let name = args.pattern.choice();
    let has_ratio = matches!(args.pattern, PatternName::Stretched | PatternName::Slivers);
    let has_levels = args.pattern == PatternName::Icosphere;
    for (option, typed, has) in [
        ("--ratio", args.ratio.is_some(), has_ratio),
        ("--level", args.level.is_some(), has_levels),
        ("--segments", args.segments.is_some(), !has_levels),
    ] {
        if typed && !has {
            return Err(format!("the pattern {name} has no {option}"));
        }
    }
    let usual = Tessellation::default();
    Ok(Tessellation {
        pattern: match args.pattern {
            PatternName::Triangles => Pattern::Triangles,
            PatternName::Stretched => Pattern::Stretched(args.ratio.unwrap_or(10.0)),
            PatternName::Slivers => Pattern::Slivers(args.ratio.unwrap_or(1000.0)),
            PatternName::Quads => Pattern::Quads,
            PatternName::Polygons => Pattern::Polygons,
            PatternName::Icosphere => Pattern::Icosphere(args.level.unwrap_or(3)),
            PatternName::Marching => Pattern::Marching,
            PatternName::Scattered => Pattern::Scattered,
        },
        segments: args.segments.unwrap_or(match kind {
            Kind::Teapot => [8, 8],
            Kind::Bezier => [32, 32],
            _ => usual.segments,
        }),
        jitter: args.jitter,
        noise: args.noise,
        seed: args.seed,
        uvs: args.uv,
    })
}
