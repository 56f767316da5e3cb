//! Ways to shade, compared with the picture of the surface itself.

use super::cases::{NamedSurface, SampleMesh, Tiling};
use super::effort::{Effort, Observer, Progress};
use super::vertex::recipe;
use crate::mesh::Column;
use crate::metric::{ImageError, image_error};
use crate::normals::{NormalField, compute_on};
use crate::num::LinearRgb;
use crate::raster::{
    Camera, Cull, Image, Interpolation, Object, RenderError, RenderSettings, Scene, Shading, Shape, render,
};
use crate::shade::{Light, Material, Reflection, phong_exponent};
use crate::surface::{Plane, Primitive, Surface};
use glam::DVec3;
use serde::Serialize;

/// One way to shade one mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShadingRow {
    /// The surface.
    pub surface: &'static str,
    /// How it is cut.
    pub tiling: Tiling,
    /// Into how many faces.
    pub faces: usize,
    /// The highlight: `phong` with n = 8, or `blinn` with n = 32, which is as wide.
    pub reflection: &'static str,
    /// Where colours are computed.
    pub shading: &'static str,
    /// How they, or normals, are interpolated; only for those that are.
    pub interpolation: Option<&'static str>,
    /// Against the picture of the surface, in steps of 1/255 of linear light; shares over half a step.
    pub error: ImageError,
    /// Milliseconds of the drawing, on all threads.
    pub milliseconds: f64,
}

/// The largest invisible difference of a pixel, in steps of 8 bits.
const THRESHOLD: f64 = 0.5;

/// The ways to shade: shading and interpolation, each with its name; the interpolation has one only if it matters.
const WAYS: [(Shading, &str, Interpolation, Option<&str>); 8] = [
    (Shading::Wireframe, "wireframe", Interpolation::Perspective, None),
    (Shading::Flat, "flat", Interpolation::Perspective, None),
    (Shading::Gouraud, "gouraud", Interpolation::Scanline, Some("scanline")),
    (Shading::Gouraud, "gouraud", Interpolation::Affine, Some("affine")),
    (Shading::Gouraud, "gouraud", Interpolation::Perspective, Some("perspective")),
    (Shading::Phong, "phong", Interpolation::Scanline, Some("scanline")),
    (Shading::Phong, "phong", Interpolation::Affine, Some("affine")),
    (Shading::Phong, "phong", Interpolation::Perspective, Some("perspective")),
];

/// The kinds of highlights and their names.
const REFLECTIONS: [(Reflection, &str); 2] = [(Reflection::Phong, "phong"), (Reflection::Blinn, "blinn")];

/// All rows. Vertices have the surface's exact normals, so that only the shading differs.
///
/// # Errors
/// Those of drawing.
pub fn shading_rows(effort: Effort, observe: Observer) -> Result<Vec<ShadingRow>, RenderError> {
    let size = [160, 320, 640][effort as usize];
    let (surfaces, tilings) = (surfaces(effort), tilings(effort));
    let total = surfaces.len() * tilings.len();
    let mut rows = Vec::new();
    for (number, surface) in surfaces.iter().enumerate() {
        let Surface::Primitive(primitive) = surface.surface else { continue };
        let truths = REFLECTIONS.map(|(reflection, _)| exact(primitive, reflection, size));
        for (place, &(tiling, level)) in tilings.iter().enumerate() {
            let done = number * tilings.len() + place;
            observe(Progress { stage: "shading", done, total });
            if !tiling.fits(&surface.surface) {
                continue;
            }
            let tessellation = tiling.tessellation(&surface.surface, level);
            let Ok(sample) = SampleMesh::new(surface, &tessellation) else { continue };
            let field = with_exact_normals(&sample);
            for ((reflection, reflection_name), truth) in REFLECTIONS.into_iter().zip(&truths) {
                let shape = Shape::Mesh { mesh: &sample.mesh, normals: &field };
                let scene = scene(shape, primitive, reflection);
                for (shading, shading_name, interpolation, interpolation_name) in WAYS {
                    let image = render(&scene, &settings(size, shading, interpolation))?;
                    let truth = truth.as_ref().map_err(Clone::clone)?;
                    rows.push(ShadingRow {
                        surface: surface.name,
                        tiling,
                        faces: sample.mesh.face_count(),
                        reflection: reflection_name,
                        shading: shading_name,
                        interpolation: interpolation_name,
                        error: image_error(&image, truth, THRESHOLD)
                            .expect("both pictures have one size and linear colours"),
                        milliseconds: milliseconds(&image),
                    });
                }
            }
        }
    }
    observe(Progress { stage: "shading", done: total, total });
    Ok(rows)
}

fn surfaces(effort: Effort) -> Vec<NamedSurface> {
    let names: &[&str] = match effort {
        Effort::Quick => &["sphere", "torus"],
        _ => &["sphere", "torus", "ellipsoid", "cylinder", "cone", "plane"],
    };
    let plane = NamedSurface { name: "plane", surface: Plane::default().into() };
    let all = NamedSurface::all(Effort::Full).into_iter().chain([plane]);
    all.filter(|surface| names.contains(&surface.name)).collect()
}

/// Tilings and their levels: several of the regular one, and one of the others.
fn tilings(effort: Effort) -> Vec<(Tiling, u32)> {
    let levels = match effort {
        Effort::Quick => 1..3,
        Effort::Usual => 0..4,
        Effort::Full => 0..5,
    };
    let others = Tiling::ALL.into_iter().filter(|&tiling| match effort {
        Effort::Quick => matches!(tiling, Tiling::Jittered | Tiling::Quads),
        _ => tiling != Tiling::Regular,
    });
    levels.map(|level| (Tiling::Regular, level)).chain(others.map(|tiling| (tiling, 1))).collect()
}

/// The picture of the surface itself.
fn exact(primitive: Primitive, reflection: Reflection, size: u32) -> Result<Image, RenderError> {
    let scene = scene(Shape::Surface(primitive), primitive, reflection);
    render(&scene, &settings(size, Shading::Exact, Interpolation::Perspective))
}

/// A mesh's own field with the surface's normals at vertices.
fn with_exact_normals(sample: &SampleMesh) -> NormalField {
    let field = compute_on(&sample.mesh, &sample.topology, &recipe(Default::default()));
    let stored = sample.mesh.columns().normals.as_ref().map(|column| column.values.clone());
    let corners = sample.mesh.faces().corners().to_vec();
    let entry_vertex = (0..sample.mesh.vertex_count() as u32).collect();
    match stored {
        Some(values) => NormalField { normals: Column::per_corner(values, corners), entry_vertex, ..field },
        None => field,
    }
}

/// Grey plastic under one warm directional light and a little cool ambient light, framed by the surface's own box. The lights
/// are coloured so that luminance differs from every channel.
fn scene<'a>(shape: Shape<'a>, primitive: Primitive, reflection: Reflection) -> Scene<'a> {
    let blinn = Material::default();
    let exponent = match reflection {
        Reflection::Phong => phong_exponent(blinn.exponent),
        Reflection::Blinn => blinn.exponent,
    };
    let half = primitive.half_extents();
    Scene {
        objects: vec![Object {
            surface: Some(primitive),
            ..Object::new(shape, Material { reflection, exponent, ..blinn })
        }],
        lines: Vec::new(),
        lights: vec![
            Light::Ambient { colour: LinearRgb::new(0.6, 0.8, 1.0) },
            Light::Directional { towards: DVec3::new(-1.0, 2.0, 3.0), colour: LinearRgb::new(1.0, 0.8, 0.5) },
        ],
        camera: Camera::framing((-half, half), 1.0),
        background: LinearRgb::BLACK,
    }
}

fn settings(size: u32, shading: Shading, interpolation: Interpolation) -> RenderSettings {
    RenderSettings {
        size: [size; 2],
        shading,
        interpolation,
        cull: Cull::None,
        two_sided: true,
        keep_linear: true,
        ..RenderSettings::default()
    }
}

fn milliseconds(image: &Image) -> f64 {
    let times = image.statistics.times;
    (times.geometry + times.binning + times.tiles).as_secs_f64() * 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn better_shading_and_finer_meshes_come_closer() {
        let rows = shading_rows(Effort::Quick, &|_| ()).unwrap();
        // Two surfaces, two regular meshes, one jittered, one of quads; two highlights; eight ways.
        assert_eq!(rows.len(), 2 * 4 * 2 * 8);
        let find = |faces: usize, shading: &str, interpolation: Option<&str>| {
            let mut found = rows.iter().filter(|row| {
                row.surface == "sphere" && row.tiling == Tiling::Regular && row.reflection == "blinn"
            });
            let row = found.find(|row| {
                (row.faces > 2000) == (faces > 2000)
                    && row.shading == shading
                    && row.interpolation == interpolation
            });
            row.unwrap().error
        };
        let perspective = Some("perspective");
        for faces in [1000, 4000] {
            let [flat, gouraud, phong] = [("flat", None), ("gouraud", perspective), ("phong", perspective)]
                .map(|(shading, interpolation)| find(faces, shading, interpolation));
            assert!(flat.linear.rms > gouraud.linear.rms && gouraud.linear.rms > phong.linear.rms);
            // All ways share one coverage.
            assert_eq!((flat.compared, flat.disagreeing), (phong.compared, phong.disagreeing));
        }
        // Lights are coloured: luminance differs from the channels.
        assert!(rows.iter().any(|row| row.error.luminance.rms < 0.99 * row.error.linear.rms));
        for (shading, interpolation) in [("flat", None), ("gouraud", perspective), ("phong", perspective)] {
            let [coarse, fine] = [1000, 4000].map(|faces| find(faces, shading, interpolation));
            assert!(fine.linear.rms < coarse.linear.rms && fine.disagreement < coarse.disagreement);
        }
    }
}
