//! A mesh or glTF file as a scene.

use crate::io::{
    FileCamera, FileMaterial, FileNode, FileReflection, Format, Loaded, Note, Part, Place, Problem,
    ReadError, Severity,
};
use crate::mesh::{NONE, normal_matrix};
use crate::num::parallel;
use crate::num::{LinearRgb, three_digits};
use crate::raster::load::appearance;
use crate::raster::load::scene_file::{
    LoadOptions, MOST_OBJECTS, MOST_PLACED_CORNERS, SceneFile, SceneMesh, SceneObject, SceneShape,
};
use crate::raster::load::scene_mesh::by_label;
use crate::raster::view::camera::Camera;
use crate::shade::Optics;
use glam::{DMat3, DMat4, DVec3};
use std::collections::BTreeMap;

impl SceneFile {
    /// A file as a scene: every instance of every part, in its materials. glTF has cameras and lights; other files are framed and
    /// lit by [`default_lights`].
    ///
    /// - Materials of MTL: K_a = Ka (Kd if it is missing), K_d = Kd, K_s = Ks, n = Ns with (N·H)ⁿ. Faces without one are grey plastic.
    /// - glTF, with α = roughness²: n is [`roughness_exponent`](crate::shade::roughness_exponent); K_s = F₀ (1 − α) (n + 8)/8, at most
    ///   ½, with F₀ between 0.04 and the base colour by `metallic`; K_d = base colour · (1 − metallic (2 − α)/4), at most 1 − K_s;
    ///   K_a = base colour. Intensities in lux or candela are divided by π.
    ///
    /// Images and transparency are not drawn, and the far distance of a camera is ignored; notes report both. Colours of vertices
    /// are shown where they are [given](SceneObject::given): of materials, only in unlit ones.
    ///
    /// [`default_lights`]: crate::raster::load::default_lights
    ///
    /// # Errors
    /// If it has no faces, too many instances, or an invalid first camera, unless [`LoadOptions::from_elsewhere`].
    pub fn from_loaded(loaded: Loaded, options: &LoadOptions) -> Result<Self, ReadError> {
        let appearance = loaded.appearance();
        let Loaded { format, parts, mut nodes, mut notes, document, .. } = loaded;
        drop(document);
        if format.is_gltf() && nodes.is_empty() {
            notes.push(Note::remark(
                "no node of the scene refers to a mesh: all meshes are drawn untransformed",
            ));
        }
        if nodes.is_empty() {
            let untransformed =
                |(part, name)| FileNode { number: part, name, part, world_from_part: DMat4::IDENTITY };
            nodes = parts.iter().map(|part| part.name.clone()).enumerate().map(untransformed).collect();
        }
        nodes.retain(|node| parts[node.part].mesh.face_count() > parts[node.part].non_finite_faces.len());
        remove_flat(&mut nodes, &mut notes)?;
        check_corners(&nodes, &parts)?;
        notes.extend(appearance.notes.iter().cloned());

        let mut scene = Self { notes, ..Self::default() };
        let materials: BTreeMap<&str, &FileMaterial> =
            appearance.materials.iter().map(|material| (&*material.name, material)).collect();
        let prototypes = scene.add_meshes(&nodes, parts, format, &materials, options);
        for node in nodes {
            if scene.objects.len() + prototypes[node.part].len() > MOST_OBJECTS {
                let found = format!("more than {MOST_OBJECTS} instances of meshes, counting each material");
                return Err(too_much(found));
            }
            scene.objects.extend(prototypes[node.part].iter().map(|prototype| SceneObject {
                name: node.name.clone(),
                transform: node.world_from_part,
                ..prototype.clone()
            }));
        }
        let mut notes = std::mem::take(&mut scene.notes);
        let (low, high) = scene.scene().bounds().unwrap_or_default();
        let distance = |eye: DVec3| match eye.distance(low * 0.5 + high * 0.5) {
            distance if distance > 0.0 && distance.is_finite() => distance,
            _ => 1.0,
        };
        let first = appearance::first_camera(&appearance, distance, options.from_elsewhere, &mut notes)?;
        scene.lights = appearance::lights(&appearance, &mut notes);
        if let Some((camera, file)) = first.as_ref().filter(|_| !options.from_elsewhere) {
            notes.extend(scene.far_note(camera, file));
        }
        scene.camera = first.map(|(camera, _)| camera);
        scene.notes = notes;
        Ok(scene)
    }

    /// A note if something lies beyond the far distance of a file's camera, where it is still drawn.
    fn far_note(&self, camera: &Camera, file: &FileCamera) -> Option<Note> {
        let far = file.far?;
        let forward = (camera.target - camera.eye).normalize_or_zero();
        let mut farthest = f64::NEG_INFINITY;
        self.scene().each_point(|point| farthest = farthest.max((point - camera.eye).dot(forward)));
        // Positions are stored in single precision.
        (farthest > far * (1.0 + f64::from(f32::EPSILON))).then(|| {
            let text = format!(
                "the camera's `zfar` of {far} is ignored: everything is drawn, up to a distance of {}",
                three_digits(farthest)
            );
            Note::new(Severity::Note, file.place.clone(), text)
        })
    }

    /// Adds the meshes of all parts that nodes show, one a material. Returns each part's objects without name and transform.
    fn add_meshes(
        &mut self,
        nodes: &[FileNode],
        parts: Vec<Part>,
        format: Format,
        materials: &BTreeMap<&str, &FileMaterial>,
        options: &LoadOptions,
    ) -> Vec<Vec<SceneObject>> {
        let mut is_shown = vec![false; parts.len()];
        nodes.iter().for_each(|node| is_shown[node.part] = true);
        let split = |(part, is_shown)| match is_shown {
            true => by_material(part, format, materials, options),
            // Parts that no node shows need no normals.
            false => Vec::new(),
        };
        let split = parallel::map_owned(parts.into_iter().zip(is_shown).collect(), split);
        let used = || split.iter().flatten().filter_map(|(material, _)| *material);
        if let Some(FileMaterial { name, .. }) = used().find(|material| material.textures > 0) {
            self.notes.push(Note::remark(format!("images are not drawn: `{name}` shows its plain colours")));
        }
        let is_transparent = |material: &&FileMaterial| {
            material.opacity.is_some_and(|opacity| opacity < 1.0) && material.optics.transmit == [0.0; 3]
        };
        if let Some(FileMaterial { name, .. }) = used().find(is_transparent) {
            self.notes.push(Note::remark(format!("transparency is not drawn: `{name}` is opaque")));
        }
        if let Some(FileMaterial { name, optics, .. }) = used().find(|it| appearance::optics(it).1) {
            let text = format!(
                "the refractive index of `{name}` is {}, below 1 or not finite: it does not bend light",
                optics.ior
            );
            self.notes.push(Note::warning(Place::File, text));
        }
        let mut object = |(material, mesh): (Option<&FileMaterial>, SceneMesh)| {
            self.meshes.push(mesh);
            let object = SceneObject::new(SceneShape::Mesh(self.meshes.len() - 1));
            let optics = material.map_or(Optics::NONE, |material| appearance::optics(material).0);
            match material.map(appearance::material) {
                Some((material, given)) => SceneObject { material, given, optics, ..object },
                None => object,
            }
        };
        split.into_iter().map(|part| part.into_iter().map(&mut object).collect()).collect()
    }
}

/// Removes nodes whose transform makes their mesh flat, as animations do to hide it: its normals have no direction.
fn remove_flat(nodes: &mut Vec<FileNode>, notes: &mut Vec<Note>) -> Result<(), ReadError> {
    let is_flat = |node: &FileNode| normal_matrix(DMat3::from_mat4(node.world_from_part)).is_none();
    let flat: Vec<FileNode> = nodes.extract_if(.., |node| is_flat(node)).collect();
    if let Some(FileNode { name, .. }) = flat.first() {
        let text = format!("the node `{name}` flattens its mesh, which is not drawn");
        notes.push(Note { more: flat.len() as u64 - 1, ..Note::remark(text) });
    }
    let (found, advice) = match flat.is_empty() {
        false => ("there are no faces to draw: all nodes flatten their meshes", "use an invertible matrix"),
        true => ("there are no faces to draw", "give a mesh with faces"),
    };
    match nodes.is_empty() {
        true => Err(ReadError::new(Problem::Unsupported, Place::File, found, advice)),
        false => Ok(()),
    }
}

fn check_corners(nodes: &[FileNode], parts: &[Part]) -> Result<(), ReadError> {
    let corners = |part: usize| parts[part].mesh.faces().corner_count() as u64;
    let once: u64 = (0..parts.len()).map(corners).sum();
    let placed: u64 = nodes.iter().map(|node| corners(node.part)).sum();
    if placed > once.max(MOST_PLACED_CORNERS) {
        return Err(too_much(format!("{placed} corners of faces, counting each instance")));
    }
    Ok(())
}

fn too_much(found: String) -> ReadError {
    ReadError::new(Problem::Limit, Place::File, found, "divide the scene")
}

/// The meshes of a part, one a material. Those in unlit materials are given the colours that they show.
fn by_material<'a>(
    part: Part,
    format: Format,
    materials: &BTreeMap<&str, &'a FileMaterial>,
    options: &LoadOptions,
) -> Vec<(Option<&'a FileMaterial>, SceneMesh)> {
    let whole = SceneMesh::new(part, format, options);
    let labels = whole.mesh.columns().materials.clone().unwrap_or_default();
    let material = |label: u32| match label {
        NONE => None,
        label => materials.get(&*labels.names[label as usize]).copied(),
    };
    let mut split: Vec<_> =
        by_label(whole, &labels.of_face).into_iter().map(|(label, mesh)| (material(label), mesh)).collect();
    for (material, mesh) in &mut split {
        if let Some(FileReflection::MetallicRoughness { base_colour, unlit: true, .. }) =
            material.map(|material| material.reflection)
        {
            let white = || vec![LinearRgb::WHITE; mesh.mesh.vertex_count()];
            let colours = mesh.colours.get_or_insert_with(white);
            colours.iter_mut().for_each(|colour| *colour = *colour * LinearRgb::from(base_colour));
        }
    }
    split.into_iter().map(|(material, mesh)| (material, mesh.stored(&options.normals))).collect()
}
