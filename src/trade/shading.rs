//! Ways to shade against the picture of the surface itself.

use super::cases::{Specimen, Subject, Tiling};
use super::{Effort, Observer, Progress};
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
    /// Whose highlight: `phong` with n = 8, or `blinn` with n = 32, which is as wide.
    pub reflection: &'static str,
    /// Where colours are computed.
    pub shading: &'static str,
    /// How they, or normals, spread; only for those that do.
    pub interpolation: Option<&'static str>,
    /// Against the picture of the surface, in steps of 1/255 of linear light; shares over half a step.
    pub error: ImageError,
    /// Milliseconds of the drawing, on all threads.
    pub milliseconds: f64,
}

/// Where pixels that both pictures cover may differ unseen, in steps of 8 bits.
const THRESHOLD: f64 = 0.5;

/// The ways to shade.
const WAYS: [(Shading, Interpolation); 8] = [
    (Shading::Wireframe, Interpolation::Perspective),
    (Shading::Flat, Interpolation::Perspective),
    (Shading::Gouraud, Interpolation::Scanline),
    (Shading::Gouraud, Interpolation::Affine),
    (Shading::Gouraud, Interpolation::Perspective),
    (Shading::Phong, Interpolation::Scanline),
    (Shading::Phong, Interpolation::Affine),
    (Shading::Phong, Interpolation::Perspective),
];

/// All rows. Vertices have the surface's exact normals, so that what differs is shading alone.
///
/// # Errors
/// Those of drawing.
pub fn shading_rows(effort: Effort, observe: Observer) -> Result<Vec<ShadingRow>, RenderError> {
    let (size, levels): (u32, &[u32]) = match effort {
        Effort::Quick => (160, &[1, 2]),
        Effort::Usual => (320, &[0, 1, 2, 3]),
        Effort::Full => (640, &[0, 1, 2, 3, 4]),
    };
    let names: &[&str] = match effort {
        Effort::Quick => &["sphere", "torus"],
        _ => &["sphere", "torus", "ellipsoid", "cylinder", "cone", "plane"],
    };
    let plane = Subject { name: "plane", surface: Plane::default().into() };
    let all = Subject::all(Effort::Full).into_iter().chain([plane]);
    let subjects: Vec<Subject> = all.filter(|subject| names.contains(&subject.name)).collect();
    // Several levels of one, and one of the others: what a cut changes shows on one level.
    let regular = levels.iter().map(|&level| (Tiling::Regular, level));
    let others = Tiling::ALL.into_iter().filter(|&tiling| match effort {
        Effort::Quick => matches!(tiling, Tiling::Jittered | Tiling::Quads),
        _ => tiling != Tiling::Regular,
    });
    let cuts: Vec<(Tiling, u32)> = regular.chain(others.map(|tiling| (tiling, 1))).collect();
    let total = subjects.len() * cuts.len();
    let mut rows = Vec::new();
    for (number, subject) in subjects.iter().enumerate() {
        let Surface::Primitive(primitive) = subject.surface else { continue };
        let truths = [Reflection::Phong, Reflection::Blinn]
            .map(|reflection| (reflection, exact(primitive, reflection, size)));
        for (place, &(tiling, level)) in cuts.iter().enumerate() {
            let done = number * cuts.len() + place;
            observe(Progress { stage: "shading", done, total });
            if !tiling.fits(&subject.surface) {
                continue;
            }
            let tessellation = tiling.tessellation(&subject.surface, level);
            let Ok(specimen) = Specimen::new(subject, &tessellation) else { continue };
            let field = with_exact_normals(&specimen);
            for (reflection, truth) in &truths {
                let shape = Shape::Mesh { mesh: &specimen.mesh, normals: &field };
                let scene = scene(shape, primitive, *reflection);
                for (shading, interpolation) in WAYS {
                    let image = render(&scene, &settings(size, shading, interpolation))?;
                    let truth = truth.as_ref().map_err(Clone::clone)?;
                    let spreads = matches!(shading, Shading::Gouraud | Shading::Phong);
                    rows.push(ShadingRow {
                        surface: subject.name,
                        tiling,
                        faces: specimen.mesh.face_count(),
                        reflection: if *reflection == Reflection::Phong { "phong" } else { "blinn" },
                        shading: shading_name(shading),
                        interpolation: spreads.then(|| interpolation_name(interpolation)),
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

/// The picture of the surface itself.
fn exact(primitive: Primitive, reflection: Reflection, size: u32) -> Result<Image, RenderError> {
    let scene = scene(Shape::Surface(primitive), primitive, reflection);
    render(&scene, &settings(size, Shading::Exact, Interpolation::Perspective))
}

/// A mesh's own field with the surface's normals at vertices.
fn with_exact_normals(specimen: &Specimen) -> NormalField {
    let field = compute_on(&specimen.mesh, &specimen.topology, &super::vertex::recipe(Default::default()));
    let stored = specimen.mesh.columns().normals.as_ref().map(|column| column.values.clone());
    let corners = specimen.mesh.faces().corners().to_vec();
    let entry_vertex = (0..specimen.mesh.vertex_count() as u32).collect();
    match stored {
        Some(values) => NormalField { normals: Column::per_corner(values, corners), entry_vertex, ..field },
        None => field,
    }
}

/// Grey plastic under one warm far light and a little cool light of everywhere, framed by the surface's own box. The lights
/// are coloured so that luminance is not what every channel is.
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

fn shading_name(shading: Shading) -> &'static str {
    match shading {
        Shading::Flat => "flat",
        Shading::Gouraud => "gouraud",
        Shading::Phong => "phong",
        Shading::Wireframe => "wireframe",
        Shading::Exact => "exact",
    }
}

fn interpolation_name(interpolation: Interpolation) -> &'static str {
    match interpolation {
        Interpolation::Scanline => "scanline",
        Interpolation::Affine => "affine",
        Interpolation::Perspective => "perspective",
    }
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
        // Lights are coloured: luminance is a measure of its own.
        assert!(rows.iter().any(|row| row.error.luminance.rms < 0.99 * row.error.linear.rms));
        for (shading, interpolation) in [("flat", None), ("gouraud", perspective), ("phong", perspective)] {
            let [coarse, fine] = [1000, 4000].map(|faces| find(faces, shading, interpolation));
            assert!(fine.linear.rms < coarse.linear.rms && fine.disagreement < coarse.disagreement);
        }
    }
}
