//! Options of `crease surface` made into a surface and a tessellation.

use super::args::{Kind, PatternArgs, ShapeArgs, SurfaceArgs};
use crate::cli::common::choice::Choose;
use crate::cli::common::output::Target;
use crate::cli::common::stream::file_target;
use crease::io::Format;
use crease::surface::{
    Catenoid, Cone, Cylinder, Ellipsoid, MonkeySaddle, Pattern, Plane, Sphere, Superquadric, Surface,
    SurfaceError, Tessellation, Torus, Wave,
};
use glam::{DMat4, DQuat};

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
        let surface = surface(args.kind, &args.shape)?;
        let (target, format) = file_target(&args.output, args.to)?;
        let format = format.ok_or("unknown output format of standard output\nhelp: choose it with --to")?;
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
}

/// The value of an option, and its name among those that a surface has.
fn take<T>(taken: &mut Vec<&'static str>, name: &'static str, typed: Option<T>, default: T) -> T {
    taken.push(name);
    typed.unwrap_or(default)
}

/// The surface. An option that it does not have is refused.
fn surface(kind: Kind, shape: &ShapeArgs) -> Result<Surface, String> {
    let mut has = Vec::new();
    let surface = surface_with(kind, shape, &mut has);
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
        return Err(format!("{name} has only one --size"));
    }
    match typed.iter().find(|(option, typed)| *typed && !has.contains(option)) {
        None => surface.map_err(|error| error.to_string()),
        Some((option, _)) if has.is_empty() => {
            Err(format!("{name} has no {option}\nhelp: --scale changes its size"))
        }
        Some((option, _)) => Err(format!("{name} has no {option}\nhelp: it has {}", has.join(" and "))),
    }
}

fn surface_with(
    kind: Kind,
    shape: &ShapeArgs,
    taken: &mut Vec<&'static str>,
) -> Result<Surface, SurfaceError> {
    let mut size = || take(taken, "--size", shape.size, Plane::default().size().to_array());
    Ok(match kind {
        Kind::Plane => {
            let [width, height] = size();
            Plane::new(width, height)?.into()
        }
        Kind::Wave => Surface::Wave(Wave::new(size()[0])?),
        Kind::MonkeySaddle => Surface::MonkeySaddle(MonkeySaddle::new(size()[0])?),
        Kind::Sphere => {
            Sphere::new(take(taken, "--radius", shape.radius, Sphere::default().radius()))?.into()
        }
        Kind::Ellipsoid => {
            let usual = Ellipsoid::default().semi_axes();
            Ellipsoid::new(take(taken, "--semi-axes", shape.semi_axes, usual))?.into()
        }
        Kind::Cylinder => {
            let usual = Cylinder::default();
            let radius = take(taken, "--radius", shape.radius, usual.radius());
            Cylinder::new(radius, take(taken, "--height", shape.height, usual.height()))?.into()
        }
        Kind::Cone => {
            let usual = Cone::default();
            let radius = take(taken, "--radius", shape.radius, usual.radius());
            Cone::new(radius, take(taken, "--height", shape.height, usual.height()))?.into()
        }
        Kind::Torus => {
            let usual = Torus::default();
            let major = take(taken, "--major", shape.major, usual.major());
            Torus::new(major, take(taken, "--minor", shape.minor, usual.minor()))?.into()
        }
        Kind::Catenoid => {
            let usual = Catenoid::default();
            let waist = take(taken, "--waist", shape.waist, usual.waist());
            let height = take(taken, "--height", shape.height, usual.height());
            Surface::Catenoid(Catenoid::new(waist, height)?)
        }
        Kind::Superquadric => {
            let usual = Superquadric::default();
            let semi_axes = take(taken, "--semi-axes", shape.semi_axes, usual.semi_axes());
            let [north, east] = take(taken, "--roundness", shape.roundness, usual.roundness());
            Surface::Superquadric(Superquadric::new(semi_axes, north, east)?)
        }
        Kind::Bezier => Surface::Patch(Box::default()),
        Kind::Teapot => Surface::Teapot,
    })
}

fn tessellation(kind: Kind, args: &PatternArgs) -> Result<Tessellation, String> {
    let mut pattern = args.pattern;
    match &mut pattern {
        Pattern::Stretched(own) | Pattern::Slivers(own) => *own = args.ratio.unwrap_or(*own),
        Pattern::Icosphere(own) => *own = args.level.unwrap_or(*own),
        _ => {}
    }
    let has_ratio = matches!(pattern, Pattern::Stretched(_) | Pattern::Slivers(_));
    let has_levels = matches!(pattern, Pattern::Icosphere(_));
    for (option, typed, has, help) in [
        ("--ratio", args.ratio.is_some(), has_ratio, "--pattern stretched and slivers have it"),
        ("--level", args.level.is_some(), has_levels, "--pattern icosphere has it"),
        ("--segments", args.segments.is_some(), !has_levels, "use --level"),
    ] {
        if typed && !has {
            return Err(format!("the pattern {} has no {option}\nhelp: {help}", pattern.name()));
        }
    }
    let usual = Tessellation::default();
    Ok(Tessellation {
        pattern,
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
