//! Tangents that go with new normals.

use super::group::{Group, unreadable};
use super::member::Member;
use super::mikktspace::{Surface, perpendicular};
use super::rows::{CornerRows, NewTangents, Rows, Tangents};
use super::store::{Remark, Store};
use crate::io::gltf::records::{Component, Format};
use crate::io::gltf::tangent_space::{Coordinates, TangentSpace};
use crate::io::{TangentPolicy, WriteError};
use crate::num::{Degrees, angle_between};
use glam::Vec3;
use rustc_hash::FxHashMap;

/// Without texture coordinates, tangents stay if each normal turned by less than this. Made perpendicular to a normal that turned
/// by θ, a tangent turns about it by atan((1 − cos θ) / (2 √cos θ)) at most: by 4.1°.
const LARGEST_TURN: Degrees = Degrees(30.0);

impl Group<'_, '_> {
    /// Tangents to go with the new normals; `locals` are the vertices of corners.
    pub fn tangents(
        &self,
        store: &mut Store<'_>,
        rows: &CornerRows<'_>,
        locals: &[u32],
    ) -> Result<Tangents, WriteError> {
        let has_tangents = self.vertices.get("TANGENT").is_some();
        let is_automatic = match self.options.tangents {
            TangentPolicy::Keep => return Ok(Tangents::Stay),
            TangentPolicy::Drop => {
                if has_tangents {
                    store.remark(Remark::TANGENTS_REMOVED, self.members.len());
                }
                return Ok(Tangents::Go);
            }
            TangentPolicy::Auto => true,
            TangentPolicy::Regenerate => false,
        };
        let spaces = self.tangent_spaces();
        if !has_tangents && !spaces.iter().any(|space| space.is_required) {
            return Ok(Tangents::Stay);
        }
        let uvs: Vec<Option<usize>> =
            spaces.iter().map(|space| self.uv_accessor(space.coordinates.set)).collect();
        if uvs.contains(&None) && !(is_automatic && self.turned_little(rows, locals)) {
            if has_tangents {
                self.report_loss(store, &spaces);
            }
            return Ok(if has_tangents { Tangents::Go } else { Tangents::Stay });
        }
        let mut new = self.stored_tangents()?;
        // Corners whose normals did not change keep their tangents too.
        let keeps =
            |corner: usize, vertex: usize| is_automatic && has_tangents && rows.is_as_stored(corner, vertex);
        let is_changed = locals.iter().enumerate().any(|(corner, &vertex)| !keeps(corner, vertex as usize));
        if !is_changed {
            return Ok(Tangents::Stay);
        }
        let rows_of = locals.iter().flat_map(|&vertex| new.stored.get(vertex as usize));
        new.rows.bytes = rows_of.copied().collect();
        for shape in 0..=new.sets.len() {
            let coordinates = uvs.iter().copied().zip(spaces.iter().map(|space| space.coordinates));
            let values = self.shape_tangents(&new, shape, rows, locals, coordinates)?;
            for (corner, (&vertex, value)) in locals.iter().zip(values).enumerate() {
                if !keeps(corner, vertex as usize) {
                    new.set(corner, shape, value);
                }
            }
        }
        new.of_corner = self.number(store, &new.rows, rows, locals);
        store.remark(Remark::TANGENTS_COMPUTED, self.members.len());
        Ok(Tangents::New(new))
    }

    fn tangent_spaces(&self) -> Vec<TangentSpace> {
        let space =
            |member: &Member<'_>| TangentSpace::new(self.source.records, self.materials, member.primitive);
        self.members.iter().map(space).collect()
    }

    /// Whether there are no tangents, and none are needed.
    pub fn is_without_tangents(&self) -> bool {
        self.vertices.get("TANGENT").is_none() && !self.tangent_spaces().iter().any(|space| space.is_required)
    }

    /// The first of equal rows for each corner. Where vertices may not be split for tangents alone, the first corner of a vertex and a
    /// normal gives its tangent to all.
    fn number(&self, store: &Store<'_>, own: &Rows, rows: &CornerRows<'_>, locals: &[u32]) -> Vec<u32> {
        if self.members.iter().any(|member| member.has_ordered_vertices(store.document)) {
            let mut first: FxHashMap<(u32, u32), u32> = FxHashMap::default();
            let corners = locals.iter().zip(&rows.of_corner).zip(0..);
            return corners
                .map(|((&vertex, &row), corner)| *first.entry((vertex, row)).or_insert(corner))
                .collect();
        }
        let mut first: FxHashMap<&[u8], u32> = FxHashMap::default();
        (0..locals.len()).map(|corner| *first.entry(own.get(corner)).or_insert(corner as u32)).collect()
    }

    /// The tangents as they are stored. Without any, unit vectors.
    fn stored_tangents(&self) -> Result<NewTangents, WriteError> {
        let elements = |set| {
            let accessor = self.vertices.of_set(set, "TANGENT");
            accessor.map(|accessor| self.source.elements(accessor).map_err(unreadable)).transpose()
        };
        let base = elements(0)?;
        let as_stored = |format: &Format| match format.component {
            Component::I8 | Component::I16 => format.normalized && format.width == 4,
            _ => false,
        };
        let format = base.map(|base| base.format).filter(as_stored);
        let format = format.unwrap_or(Format::vector(Component::F32, false, 4));
        let sets: Vec<usize> = self.vertices.target_sets().collect();
        let sets: Vec<usize> =
            sets.into_iter().filter(|&set| self.vertices.of_set(set, "TANGENT").is_some()).collect();
        let targets = sets.iter().map(|&set| Ok(elements(set)?.map(|it| it.floats::<3>(0.0).collect())));
        let targets: Vec<Option<Vec<[f32; 3]>>> = targets.collect::<Result<_, WriteError>>()?;
        let base = match base {
            Some(base) if base.format == format => base.raw(),
            Some(base) => base.floats::<4>(0.0).flatten().flat_map(f32::to_le_bytes).collect(),
            None => {
                let count = self.members[0].block.count as usize;
                bytemuck::bytes_of(&[1.0_f32, 0.0, 0.0, 1.0]).repeat(count).into()
            }
        };
        let stored = Rows::new(base, format.size(), &targets);
        let rows = stored.with(Vec::new());
        Ok(NewTangents { format, sets, of_corner: Vec::new(), rows, stored })
    }

    /// The tangent of each corner in a shape: by MikkTSpace where there are coordinates, else the stored one, made
    /// perpendicular to its new normal.
    fn shape_tangents(
        &self,
        new: &NewTangents,
        shape: usize,
        rows: &CornerRows<'_>,
        locals: &[u32],
        coordinates: impl Iterator<Item = (Option<usize>, Coordinates)>,
    ) -> Result<Vec<[f32; 4]>, WriteError> {
        let target = shape.checked_sub(1).map(|number| new.sets[number] - 1);
        let mut values: Vec<[f32; 4]> = Vec::with_capacity(locals.len());
        for (member, (accessor, coordinates)) in self.members.iter().zip(coordinates) {
            let range = values.len()..values.len() + member.corner_count();
            let normals: Vec<Vec3> = range.clone().map(|corner| rows.normal(corner, target)).collect();
            let locals = &locals[range];
            let old = locals.iter().map(|&vertex| new.stored(vertex as usize, shape));
            let tangents = old.zip(&normals).map(|(old, &normal)| made_perpendicular(old, normal)).collect();
            let Some(accessor) = accessor else {
                values.extend::<Vec<[f32; 4]>>(tangents);
                continue;
            };
            let uvs = self.source.elements(accessor).map_err(unreadable)?.floats::<2>(0.0);
            let uvs: Vec<[f32; 2]> = uvs.map(|uv| coordinates.transform(uv)).collect();
            let mut surface = Surface {
                positions: member.corners().map(|corner| position(member, corner, target)).collect(),
                normals,
                uvs: locals.iter().map(|&vertex| uvs[vertex as usize]).collect(),
                tangents,
            };
            surface.generate();
            values.extend(surface.tangents);
        }
        Ok(values)
    }

    /// The accessor of a set of texture coordinates.
    fn uv_accessor(&self, set: u64) -> Option<usize> {
        let accessor = self.vertices.get(&format!("TEXCOORD_{set}"))?;
        let format = self.source.records.accessors[accessor].format?;
        (format.width == 2 && format.columns == 1 && format.component != Component::U32).then_some(accessor)
    }

    /// Whether there are tangents, and each new normal is within [`LARGEST_TURN`] of the stored one.
    fn turned_little(&self, rows: &CornerRows<'_>, locals: &[u32]) -> bool {
        let are_there = ["TANGENT", "NORMAL"].iter().all(|name| self.vertices.get(name).is_some());
        are_there
            && locals.iter().enumerate().all(|(corner, &vertex)| {
                let (old, new) = (rows.stored_normal(vertex as usize), rows.normal(corner, None));
                let has_direction = old.is_finite() && old.length_squared() > 0.0;
                let turn = angle_between(old.as_dvec3(), new.as_dvec3());
                has_direction && Degrees::from(turn) < LARGEST_TURN
            })
    }

    /// Warns for each primitive that its material loses tangents.
    fn report_loss(&self, store: &mut Store<'_>, spaces: &[TangentSpace]) {
        let why = match self.options.tangents {
            TangentPolicy::Regenerate => String::new(),
            _ if self.vertices.get("NORMAL").is_none() => "they had no normals, and ".to_owned(),
            _ => format!("normals rotated by {}° or more, and ", LARGEST_TURN.0),
        };
        for (member, space) in self.members.iter().zip(spaces) {
            let material = member.primitive.material.and_then(|number| self.materials.get(number));
            let name = material.map_or("the default material", |material| &material.name);
            let uses: Vec<&str> = space.uses.iter().map(|it| it.words()).collect();
            let what = if uses.is_empty() {
                "tangents, which it does not use".to_owned()
            } else {
                format!("the tangents of {}", uses.join(" and "))
            };
            let text = format!(
                "{name} lost {what}: {why}there are no texture coordinates to compute new ones from (see --tangents)"
            );
            store.warn(member.primitive.place(), text);
        }
    }
}

/// The position of a corner, displaced by a morph target if one is given.
fn position(member: &Member<'_>, corner: u32, target: Option<usize>) -> [f32; 3] {
    let vertex = member.mesh.faces().corners()[corner as usize];
    let displacement = target.and_then(|target| member.mesh.columns().morph_targets.get(target));
    let displacement = displacement.map_or(glam::DVec3::ZERO, |target| target[vertex as usize]);
    (member.mesh.position(vertex) + displacement).as_vec3().to_array()
}

/// The direction of a tangent in the plane perpendicular to a normal; any unit vector in it if the tangent has none there.
fn made_perpendicular(tangent: [f32; 4], normal: Vec3) -> [f32; 4] {
    let [x, y, z, w] = tangent;
    let direction = Vec3::new(x, y, z).reject_from_normalized(normal).try_normalize();
    let Some(direction) = direction else { return perpendicular(normal) };
    let [x, y, z] = direction.to_array();
    [x, y, z, if w < 0.0 { -1.0 } else { 1.0 }]
}
