//! Normals of parts of a file where they meet in the world.

use crate::io::Loaded;
use crate::mesh::{Mesh, NormalMatrix, normal_matrix, place_key, stored_unit};
use crate::num::{Degrees, angle_between};
use crate::quality::estimate::recipe::SAME;
use glam::{DMat3, DMat4, DVec3};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};

/// The bits of a position in the world.
type Key = [u64; 3];

/// The points at which several parts stand, and what normals they have there.
pub(in crate::quality) struct Borders {
    /// Where the first place of each part puts it; `None` if that is no place that normals can be taken to.
    worlds: Vec<Option<World>>,
    /// Of each part and point.
    normals: FxHashMap<Key, Vec<(u32, DVec3)>>,
}

struct World {
    matrix: DMat4,
    normals: NormalMatrix,
}

impl World {
    fn key(&self, position: DVec3) -> Key {
        place_key(self.matrix.transform_point3(position))
    }
}

impl Borders {
    pub(in crate::quality) fn new(loaded: &Loaded) -> Self {
        let world = |places: Vec<DMat4>| {
            let matrix = *places.first()?;
            Some(World { matrix, normals: normal_matrix(DMat3::from_mat4(matrix))? })
        };
        let worlds: Vec<Option<World>> = loaded.places().into_iter().map(world).collect();
        let mut borders = Self { worlds, normals: FxHashMap::default() };
        let meshes: Vec<&Mesh> = loaded.parts.iter().map(|part| &part.mesh).collect();
        if meshes.len() > 1 {
            borders.look_at(&meshes);
        }
        borders
    }

    fn look_at(&mut self, meshes: &[&Mesh]) {
        let standing = || {
            let parts = (0..).zip(meshes.iter().zip(&self.worlds));
            parts.filter_map(|(part, (&mesh, world))| Some((part, mesh, world.as_ref()?)))
        };
        // Sixteen bytes a vertex, for as long as it takes to see which points are of several parts.
        let hashes_of = |(part, mesh, world): (u32, &Mesh, &World)| -> Vec<(u64, u32)> {
            mesh.positions().iter().map(|&position| (hash(world.key(position)), part)).collect()
        };
        let mut hashes: Vec<(u64, u32)> = standing().flat_map(hashes_of).collect();
        hashes.sort_unstable();
        let meet = |pair: &[(u64, u32)]| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1;
        let shared: FxHashSet<u64> =
            hashes.windows(2).filter(|pair| meet(pair)).map(|pair| pair[0].0).collect();
        drop(hashes);
        let mut normals: FxHashMap<Key, Vec<(u32, DVec3)>> = FxHashMap::default();
        for (part, mesh, world) in standing() {
            let Some(stored) = mesh.columns().normals.as_ref() else { continue };
            for (corner, &vertex) in mesh.faces().corners().iter().enumerate() {
                let key = world.key(mesh.positions()[vertex as usize]);
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
        self.normals = normals;
    }

    /// Whether another part has a normal at a point of one: the surface was smoothed over what is a border now.
    pub(in crate::quality) fn go_on(&self, part: usize, position: DVec3, normal: DVec3) -> bool {
        let Some(world) = &self.worlds[part] else { return false };
        let others = self.normals.get(&world.key(position)).into_iter().flatten();
        let Some(normal) = world.normals.apply(normal) else { return false };
        let is_same = |&(of, other): &(u32, DVec3)| {
            of as usize != part && Degrees::from(angle_between(other, normal)).0 <= SAME
        };
        others.into_iter().any(is_same)
    }
}

fn hash(key: Key) -> u64 {
    let mut hasher = FxHasher::default();
    key.hash(&mut hasher);
    hasher.finish()
}
