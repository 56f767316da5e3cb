//! The file of a part, as far as findings about one part need the others: materials, cavities, and normals at positions that
//! several parts share.

use crate::io::{FileMaterial, Format, Loaded};
use crate::mesh::{Mesh, NormalMatrix, Placed, Weld, cavities, normal_matrix, place_key, stored_unit};
use crate::quality::angles::{SAME, degrees_between};
use crate::quality::thresholds::Thresholds;
use glam::{DMat3, DMat4, DVec3};
use rustc_hash::{FxBuildHasher, FxHashMap, FxHashSet};
use std::hash::BuildHasher;
use std::sync::OnceLock;

type Key = [u64; 3];

/// The normals at positions that several parts share.
pub(crate) struct Borders {
    /// The first placement of each part; `None` if it has no inverse.
    worlds: Vec<Option<World>>,
    /// The part and the normal in the world.
    normals: FxHashMap<Key, Vec<(u32, DVec3)>>,
}

/// The placement of a part in the world.
struct World {
    matrix: DMat4,
    normals: NormalMatrix,
}

impl World {
    fn new(places: &[DMat4]) -> Option<Self> {
        let matrix = *places.first()?;
        Some(Self { matrix, normals: normal_matrix(DMat3::from_mat4(matrix))? })
    }

    fn key(&self, position: DVec3) -> Key {
        place_key(self.matrix.transform_point3(position))
    }
}

impl Borders {
    pub(crate) fn new(loaded: &Loaded) -> Self {
        let worlds: Vec<Option<World>> =
            loaded.places().into_iter().map(|places| World::new(&places)).collect();
        let meshes = loaded.parts.iter().map(|part| &part.mesh);
        let placed = (0..).zip(meshes).zip(&worlds);
        let placed: Vec<(u32, &Mesh, &World)> =
            placed.filter_map(|((part, mesh), world)| Some((part, mesh, world.as_ref()?))).collect();
        let shared = shared_positions(&placed);
        let mut normals: FxHashMap<Key, Vec<(u32, DVec3)>> = FxHashMap::default();
        for (part, mesh, world) in placed {
            let Some(stored) = mesh.columns().normals.as_ref() else { continue };
            for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
                let key = world.key(mesh.positions().at(vertex));
                if shared.contains(&hash(key))
                    && let Some(unit) = stored_unit(stored, mesh, corner)
                    && let Some(normal) = world.normals.apply(unit)
                {
                    let here = normals.entry(key).or_default();
                    if !here.contains(&(part, normal)) {
                        here.push((part, normal));
                    }
                }
            }
        }
        Self { worlds, normals }
    }

    /// Whether another part has the normal of a part at the same position: the surface was smoothed over the border.
    pub(crate) fn has(&self, part: usize, position: DVec3, normal: DVec3) -> bool {
        let Some(world) = &self.worlds[part] else { return false };
        let Some(normal) = world.normals.apply(normal) else { return false };
        let mut here = self.normals.get(&world.key(position)).into_iter().flatten();
        here.any(|&(other, its)| other as usize != part && degrees_between(its, normal) <= SAME)
    }
}

/// Hashes of the positions that several parts have: 16 bytes a vertex rather than a map of all positions.
fn shared_positions(placed: &[(u32, &Mesh, &World)]) -> FxHashSet<u64> {
    let hashes_of = |&(part, mesh, world): &(u32, &Mesh, &World)| {
        let hashes = mesh.positions().iter().map(|position| (hash(world.key(position)), part));
        hashes.collect::<Vec<(u64, u32)>>()
    };
    let mut hashes: Vec<(u64, u32)> = placed.iter().flat_map(hashes_of).collect();
    hashes.sort_unstable();
    let are_shared = |pair: &&[(u64, u32)]| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1;
    hashes.windows(2).filter(are_shared).map(|pair| pair[0].0).collect()
}

fn hash(key: Key) -> u64 {
    FxBuildHasher.hash_one(key)
}

/// A file and the thresholds of its diagnosis. What concerns several parts is computed when a part first needs it.
pub(crate) struct FileContext<'a> {
    pub(crate) loaded: &'a Loaded,
    pub(crate) thresholds: &'a Thresholds,
    cavities: OnceLock<Vec<Vec<usize>>>,
    borders: OnceLock<Borders>,
    materials: OnceLock<Vec<FileMaterial>>,
}

impl<'a> FileContext<'a> {
    pub(crate) fn new(loaded: &'a Loaded, thresholds: &'a Thresholds) -> Self {
        let (cavities, borders, materials) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        Self { loaded, thresholds, cavities, borders, materials }
    }

    /// Whether the format can share vertices at all; STL cannot.
    pub(crate) fn shares_vertices(&self) -> bool {
        self.loaded.format != Format::Stl
    }

    /// Whether the format has a choice of how normals are stored; only glTF has.
    pub(crate) fn has_normal_formats(&self) -> bool {
        self.loaded.format.is_gltf()
    }

    /// The materials, unless the thresholds give one exponent for all.
    pub(crate) fn materials(&self) -> &[FileMaterial] {
        self.materials.get_or_init(|| match self.thresholds.exponent {
            Some(_) => Vec::new(),
            None => self.loaded.appearance().materials,
        })
    }

    /// Components of a part that face inwards because other meshes of the file enclose them.
    pub(crate) fn cavities(&self, part: usize) -> &[usize] {
        let find = || {
            let parts = self.loaded.parts.iter().zip(self.loaded.places());
            let parts = parts.map(|(part, places)| Placed { mesh: &part.mesh, places });
            cavities(&parts.collect::<Vec<Placed<'_>>>(), Weld::Exact)
        };
        &self.cavities.get_or_init(find)[part]
    }

    /// Whether another part has the normal of a part at the same position.
    pub(crate) fn has_in_other_part(&self, part: usize, position: DVec3, normal: DVec3) -> bool {
        self.loaded.parts.len() > 1
            && self.borders.get_or_init(|| Borders::new(self.loaded)).has(part, position, normal)
    }
}
