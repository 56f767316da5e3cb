//! From a mesh file to a scene.

use crate::io::{Appearance, FileMaterial, FileNode, FileReflection, Format, Loaded, Note, Part};
use crate::io::{FileCamera, Place, Problem, ReadError, Severity};
use crate::mesh::{NONE, normal_matrix};
use crate::num::LinearRgb;
use crate::raster::load::lights::plain_material;
use crate::raster::load::{LoadOptions, SceneFile, SceneMesh, SceneObject, SceneShape, looks, split};
use crate::raster::settings::RenderSettings;
use crate::raster::view::camera::Camera;
use crate::shade::{Light, Material};
use glam::{DMat3, DMat4, DVec3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Most corners of faces that a file may place by standing the same meshes in many places: drawing takes some gigabytes
/// for them. Faces that stand once are not limited here.
pub(super) const MOST_PLACED_CORNERS: u64 = 1 << 28;

/// Most objects.
pub(super) const MOST_OBJECTS: usize = 1 << 17;

impl SceneFile {
    /// A file that is read, as a scene: every part at every place where it stands, in its materials. glTF brings its
    /// first camera and its lights; what has none is framed by itself and lit by [`default_lights`].
    ///
    /// Materials are told by [`FileReflection`]'s terms as follows.
    /// - MTL: K_a = Ka (Kd where it is missing), K_d = Kd, K_s = Ks, n = Ns with (N·H)ⁿ. Faces without a material that a
    ///   library defines are grey plastic.
    /// - glTF: with α = roughness², the exponent of (N·H)ⁿ is n = 2/α² − 2, from 1 to 10⁴; K_s = F₀ (1 − α) (n + 8)/8, no
    ///   component above ½, with F₀ between 0.04 and the base colour by `metallic`;
    ///   K_d = base colour · (1 − metallic (2 − α)/4), since metals have nothing here to mirror, and less where K_d + K_s
    ///   would be above 1; K_a = base colour. Intensities in lux or candela are divided by π, as that standard has it.
    ///
    /// Images and transparency are not drawn, and nothing is cut off at the far distance of a camera, which notes tell where it
    /// matters. Colours of vertices show where they are [given](SceneObject::given), which of materials only unlit ones are.
    ///
    /// [`default_lights`]: crate::raster::load::default_lights
    ///
    /// # Errors
    /// If it has no faces, places beyond all measure, or a first camera that the format does not allow, unless
    /// [`LoadOptions::from_elsewhere`].
    pub fn from_loaded(loaded: Loaded, options: &LoadOptions) -> Result<Self, ReadError> {
        let looks = loaded.appearance();
        let Loaded { format, parts, mut nodes, mut notes, document, .. } = loaded;
        drop(document);
        if format.is_gltf() && nodes.is_empty() {
            notes.push(Note::remark(
                "no node of the scene shows a mesh: all are drawn where their positions stand",
            ));
        }
        if nodes.is_empty() {
            let as_it_stands =
                |(part, name)| FileNode { number: part, name, part, world_from_part: DMat4::IDENTITY };
            nodes = parts.iter().map(|part| part.name.clone()).enumerate().map(as_it_stands).collect();
        }
        nodes.retain(|node| parts[node.part].mesh.face_count() > parts[node.part].non_finite_faces.len());
        let are_flat = leave_out_flat(&mut nodes, &mut notes) && nodes.is_empty();
        check(&nodes, are_flat, &parts)?;
        notes.extend(looks.notes.iter().cloned());

        let mut meshes = Vec::new();
        let pieces = pieces(&nodes, parts, format, &looks.materials, options, &mut meshes, &mut notes);
        let mut objects = Vec::new();
        for node in nodes {
            if objects.len() + pieces[node.part].len() > MOST_OBJECTS {
                let found = format!("more than {MOST_OBJECTS} meshes at their places, each material counted");
                return Err(too_much(found));
            }
            objects.extend(pieces[node.part].iter().map(|piece| SceneObject {
                name: node.name.clone(),
                shape: SceneShape::Mesh(piece.mesh),
                transform: node.world_from_part,
                material: piece.material,
                given: piece.given,
                surface: None,
            }));
        }
        let mut scene = Self {
            meshes,
            objects,
            lights: None,
            camera: None,
            background: LinearRgb::BLACK,
            settings: RenderSettings::default(),
            notes: Vec::new(),
        };
        (scene.camera, scene.lights) = scene.view(&looks, options, &mut notes)?;
        scene.notes = notes;
        Ok(scene)
    }

    /// The camera and lights of a file that shows this.
    fn view(
        &self,
        looks: &Appearance,
        options: &LoadOptions,
        notes: &mut Vec<Note>,
    ) -> Result<(Option<Camera>, Option<Vec<Light>>), ReadError> {
        let (low, high) = self.scene().bounds().unwrap_or_default();
        let distance = |eye: DVec3| match eye.distance(low * 0.5 + high * 0.5) {
            distance if distance > 0.0 && distance.is_finite() => distance,
            _ => 1.0,
        };
        let looks::Seen { camera, lights } = looks::view(looks, distance, options.from_elsewhere, notes)?;
        if let Some((camera, file)) = camera.as_ref().filter(|_| !options.from_elsewhere) {
            notes.extend(self.beyond(camera, file));
        }
        Ok((camera.map(|(camera, _)| camera), lights))
    }

    /// A note if something lies beyond the far distance of a file's camera, where it is drawn all the same.
    fn beyond(&self, camera: &Camera, file: &FileCamera) -> Option<Note> {
        let far = file.far?;
        let forward = (camera.target - camera.eye).normalize_or_zero();
        let mut farthest = f64::NEG_INFINITY;
        self.scene().each_point(|point| farthest = farthest.max((point - camera.eye).dot(forward)));
        // Positions are stored in single precision.
        (farthest > far * (1.0 + f64::from(f32::EPSILON))).then(|| {
            let text = format!(
                "nothing is cut off at the camera's `zfar` of {far}: all is drawn, up to a distance of {farthest}"
            );
            Note::new(Severity::Note, file.place.clone(), text)
        })
    }
}

/// Nodes that squeeze their mesh flat, as animations have them that let things vanish: nothing of it faces anywhere. Gives
/// whether there are any.
fn leave_out_flat(nodes: &mut Vec<FileNode>, notes: &mut Vec<Note>) -> bool {
    let is_flat = |node: &FileNode| normal_matrix(DMat3::from_mat4(node.world_from_part)).is_none();
    let flat: Vec<&str> = nodes.iter().filter(|node| is_flat(node)).map(|node| &*node.name).collect();
    if let Some(name) = flat.first() {
        let text = format!("the node `{name}` squeezes its mesh flat, which is not drawn");
        notes.push(Note { more: flat.len() as u64 - 1, ..Note::remark(text) });
        nodes.retain(|node| !is_flat(node));
        return true;
    }
    false
}

fn check(nodes: &[FileNode], are_flat: bool, parts: &[Part]) -> Result<(), ReadError> {
    if nodes.is_empty() {
        let (found, advice) = match are_flat {
            true => (
                "there are no faces to draw: all nodes squeeze their meshes flat",
                "give a node a matrix that can be undone",
            ),
            false => ("there are no faces to draw", "give a mesh with faces"),
        };
        return Err(ReadError::new(Problem::Unsupported, Place::File, found, advice));
    }
    let corners = |part: usize| parts[part].mesh.faces().corner_count() as u64;
    let once: u64 = (0..parts.len()).map(corners).sum();
    let placed: u64 = nodes.iter().map(|node| corners(node.part)).sum();
    if placed > once.max(MOST_PLACED_CORNERS) {
        return Err(too_much(format!("{placed} corners of faces, each at all places where it stands")));
    }
    Ok(())
}

fn too_much(found: String) -> ReadError {
    ReadError::new(Problem::Limit, Place::File, found, "divide the scene")
}

/// A mesh in one material.
#[derive(Clone)]
struct Piece {
    mesh: usize,
    material: Material,
    given: bool,
}

/// What each part that stands somewhere is made of.
fn pieces(
    nodes: &[FileNode],
    parts: Vec<Part>,
    format: Format,
    materials: &[FileMaterial],
    options: &LoadOptions,
    meshes: &mut Vec<SceneMesh>,
    notes: &mut Vec<Note>,
) -> Vec<Vec<Piece>> {
    let mut stands = vec![false; parts.len()];
    nodes.iter().for_each(|node| stands[node.part] = true);
    let by_name: BTreeMap<&str, &FileMaterial> =
        materials.iter().map(|material| (&*material.name, material)).collect();
    let split = |(part, stands)| match stands {
        true => in_materials(part, format, &by_name, options),
        // What does not stand anywhere needs no normals.
        false => Vec::new(),
    };
    let split: Vec<_> = parts.into_par_iter().zip(stands).map(split).collect();
    let mut plain = Plain::default();
    let mut pieces = Vec::with_capacity(split.len());
    for split in split {
        let mut of_part = Vec::with_capacity(split.len());
        for (file_material, mesh) in split {
            let (material, given) = file_material.map_or((plain_material(), false), looks::material);
            plain.look(file_material);
            of_part.push(Piece { mesh: meshes.len(), material, given });
            meshes.push(mesh);
        }
        pieces.push(of_part);
    }
    plain.tell(notes);
    pieces
}

/// A part by its materials. Unlit ones are given the colours that they show.
fn in_materials<'a>(
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
    let mut split = match split::by_label(&whole, &labels.of_face) {
        Some(split) => split.into_iter().map(|(label, mesh)| (material(label), mesh)).collect(),
        None => {
            let label = labels.of_face.first().copied().unwrap_or(NONE);
            vec![(material(label), whole)]
        }
    };
    for (material, mesh) in &mut split {
        if let Some(FileReflection::MetallicRoughness { base_colour, unlit: true, .. }) =
            material.map(|material| material.reflection)
        {
            let white = || vec![LinearRgb::WHITE; mesh.mesh.vertex_count()];
            let colours = mesh.colours.get_or_insert_with(white);
            colours.iter_mut().for_each(|colour| *colour = *colour * LinearRgb::from(base_colour));
        }
    }
    split
}

/// What is drawn plainer than the file has it.
#[derive(Default)]
struct Plain<'a> {
    images: Option<&'a str>,
    transparent: Option<&'a str>,
}

impl<'a> Plain<'a> {
    fn look(&mut self, material: Option<&'a FileMaterial>) {
        if let Some(material) = material {
            self.images = self.images.or((material.textures > 0).then_some(&*material.name));
            self.transparent = self
                .transparent
                .or(material.opacity.is_some_and(|opacity| opacity < 1.0).then_some(&*material.name));
        }
    }

    fn tell(self, notes: &mut Vec<Note>) {
        if let Some(name) = self.images {
            notes.push(Note::remark(format!("images are not drawn: `{name}` shows its plain colours")));
        }
        if let Some(name) = self.transparent {
            notes.push(Note::remark(format!("nothing shines through: `{name}` is drawn opaque")));
        }
    }
}
