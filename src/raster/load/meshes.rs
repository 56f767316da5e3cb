//! From a part of a file to a mesh with the normals that it would be written with.

use crate::io::{Format, Part};
use crate::mesh::FaceEdit;
use crate::normals::compute;
use crate::num::{LinearRgb, Transfer};
use crate::raster::load::{LoadOptions, SceneMesh};
use rayon::prelude::*;

impl SceneMesh {
    /// A part of a file in this format, whose faces that use no finite positions are left out.
    pub(super) fn new(part: Part, format: Format, options: &LoadOptions) -> Self {
        let Part { mesh, non_finite_faces, .. } = part;
        let source_faces = (!non_finite_faces.is_empty()).then(|| {
            let all = 0..mesh.face_count() as u32;
            all.filter(|face| non_finite_faces.binary_search(face).is_err()).collect()
        });
        let mesh = mesh.with_faces(&FaceEdit { dropped: non_finite_faces, reversed: Vec::new() });
        let colours = mesh.columns().colors.as_ref().map(|colours| linear(colours, format));
        let normals = compute(&mesh, &options.recipe).selected(&mesh, options.when.unwrap_or_default());
        Self { mesh, normals, colours, source_faces }
    }
}

/// Colours of vertices. Those of glTF are linear; other formats do not say, and their programs write what screens show.
fn linear(colours: &[[f32; 4]], format: Format) -> Vec<LinearRgb> {
    let decode = |component: f32| match format {
        Format::Gltf | Format::Glb => f64::from(component),
        Format::Obj | Format::Ply | Format::Stl => Transfer::Srgb.decode(f64::from(component)),
    };
    colours.par_iter().map(|&[r, g, b, _]| [r, g, b].map(decode).into()).collect()
}
