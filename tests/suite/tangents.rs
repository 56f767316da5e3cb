//! Tangents of a glTF whose normals change, in documents made for one point each.

use base64::Engine;
use crease::io::gltf::{edit, read};
use crease::io::{
    Document, Format, Loaded, Merge, PartEdit, ReadOptions, TangentPolicy, WriteOptions, Written,
};
use crease::mesh::Column;
use glam::{DVec2, DVec3, Vec3, Vec4};
use serde_json::{Value, json};
use std::f64::consts::FRAC_1_SQRT_2;
use std::path::Path;

/// A document with one primitive, which has these attributes and these of one morph target.
#[derive(Clone, Default)]
struct Made {
    attributes: Vec<(&'static str, Vec<Vec<f32>>)>,
    target: Vec<(&'static str, Vec<Vec<f32>>)>,
    indices: Vec<u16>,
    material: Value,
    extensions: Value,
}

impl Made {
    fn with(mut self, name: &'static str, values: impl IntoIterator<Item = Vec<f32>>) -> Self {
        self.attributes.retain(|attribute| attribute.0 != name);
        self.attributes.push((name, values.into_iter().collect()));
        self
    }

    fn without(mut self, name: &str) -> Self {
        self.attributes.retain(|attribute| attribute.0 != name);
        self
    }

    fn material(self, material: Value) -> Self {
        Self { material, ..self }
    }

    fn bytes(&self) -> Vec<u8> {
        let (mut bin, mut views, mut accessors) = (Vec::new(), Vec::new(), Vec::new());
        let mut put = |bytes: Vec<u8>, count: usize, component: u32, kind: &str| {
            views.push(json!({"buffer": 0, "byteOffset": bin.len(), "byteLength": bytes.len()}));
            let bounds = if kind == "VEC3" { json!([-9, -9, -9]) } else { Value::Null };
            accessors.push(json!({"bufferView": views.len() - 1, "componentType": component, "count": count, "type": kind}));
            if bounds.is_array() && views.len() == 1 {
                accessors[0]["min"] = bounds;
                accessors[0]["max"] = json!([9, 9, 9]);
            }
            bin.extend(bytes);
            bin.resize(bin.len().next_multiple_of(4), 0);
            accessors.len() - 1
        };
        let mut list = |attributes: &[(&str, Vec<Vec<f32>>)]| {
            let put = |(name, values): &(&str, Vec<Vec<f32>>)| {
                let bytes = values.iter().flatten().flat_map(|x| x.to_le_bytes()).collect();
                let kind = format!("VEC{}", values[0].len());
                ((*name).to_owned(), put(bytes, values.len(), 5126, &kind).into())
            };
            attributes.iter().map(put).collect::<serde_json::Map<String, Value>>()
        };
        let mut primitive = json!({"attributes": list(&self.attributes), "material": 0});
        if !self.target.is_empty() {
            primitive["targets"] = json!([list(&self.target)]);
        }
        if !self.extensions.is_null() {
            primitive["extensions"] = self.extensions.clone();
        }
        if !self.indices.is_empty() {
            let bytes = self.indices.iter().flat_map(|index| index.to_le_bytes()).collect();
            primitive["indices"] = put(bytes, self.indices.len(), 5123, "SCALAR").into();
        }
        let data = base64::engine::general_purpose::STANDARD.encode(&bin);
        let uri = format!("data:application/octet-stream;base64,{data}");
        let plain = json!({"name": "plain"});
        let brushed =
            json!({"name": "brushed", "extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 1}}});
        let materials = json!([if self.material.is_null() { plain } else { self.material.clone() }, brushed]);
        let document = json!({
            "asset": {"version": "2.0"}, "meshes": [{"primitives": [primitive]}], "materials": materials,
            "textures": [{"source": 0}], "images": [{"uri": "data:image/png;base64,AAAA"}], "accessors": accessors, "bufferViews": views,
            "buffers": [{"byteLength": bin.len(), "uri": uri}],
        });
        serde_json::to_vec(&document).unwrap()
    }

    fn open(&self) -> Loaded {
        read(self.bytes(), None, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
    }
}

/// A unit square in the plane z = 0 with u = x and v = 1 − y, so that the picture is upright, and with normals that lean by 45°.
fn square() -> Made {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let made = Made { indices: vec![0, 1, 2, 0, 2, 3], ..Made::default() };
    let lean = FRAC_1_SQRT_2 as f32;
    made.with("POSITION", corners.map(|[x, y]| vec![x, y, 0.0]))
        .with("NORMAL", corners.map(|_| vec![0.0, lean, lean]))
        .with("TANGENT", corners.map(|_| vec![1.0, 0.0, 0.0, 1.0]))
        .with("TEXCOORD_0", corners.map(|[x, y]| vec![x, 1.0 - y]))
}

/// A material whose anisotropy texture needs tangents.
fn anisotropic() -> Value {
    let texture = json!({"index": 0});
    json!({"name": "brushed", "extensions": {"KHR_materials_anisotropy": {"anisotropyTexture": texture}}})
}

fn normal_mapped(texture: Value) -> Value {
    json!({"name": "mapped", "normalTexture": texture})
}

/// The same new normal everywhere.
fn towards(loaded: &Loaded, normal: DVec3) -> PartEdit {
    let values = vec![normal; loaded.parts[0].mesh.vertex_count()];
    let morph_normals = vec![values.clone(); loaded.parts[0].mesh.columns().morph_targets.len()];
    PartEdit { normals: Some(Column::per_vertex(values)), morph_normals, ..PartEdit::default() }
}

fn write(loaded: &Loaded, change: PartEdit, options: &WriteOptions) -> Written {
    let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    edit(document, loaded, &[change], Format::Gltf, options).unwrap_or_else(|error| panic!("{error}"))
}

fn with(tangents: TangentPolicy) -> WriteOptions {
    WriteOptions { tangents, ..WriteOptions::default() }
}

/// Writes the document with all normals along z, and returns the tangents.
fn upright(made: &Made, options: &WriteOptions) -> Option<Vec<Vec4>> {
    let loaded = made.open();
    tangents(&write(&loaded, towards(&loaded, DVec3::Z), options).bytes)
}

/// What the `gltf` crate reads from the only primitive.
fn with_primitive<T>(bytes: &[u8], get: impl FnOnce(gltf::Primitive<'_>, &[Vec<u8>]) -> T) -> T {
    let gltf = gltf::Gltf::from_slice(bytes).unwrap();
    let buffers = super::gltf::buffers(&gltf, Path::new(""));
    let primitive = gltf.meshes().next().unwrap().primitives().next().unwrap();
    get(primitive, &buffers)
}

fn tangents(bytes: &[u8]) -> Option<Vec<Vec4>> {
    with_primitive(bytes, |primitive, buffers| {
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
        Some(reader.read_tangents()?.map(Vec4::from_array).collect())
    })
}

fn positions(bytes: &[u8]) -> Vec<Vec3> {
    with_primitive(bytes, |primitive, buffers| {
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
        reader.read_positions().unwrap().map(Vec3::from_array).collect()
    })
}

#[test]
fn materials_without_a_normal_texture_keep_what_they_need() {
    let coat = json!({"extensions": {"KHR_materials_clearcoat": {"clearcoatNormalTexture": {"index": 0}}}});
    let strength = json!({"extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 0.5}}});
    let variants = json!({"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]}]}});
    let mapped = normal_mapped(json!({"index": 0}));
    for (made, needs, is_generated) in [
        (square().material(anisotropic()), true, true),
        (square().material(coat), true, true),
        (square().material(strength), true, true),
        (Made { extensions: variants, ..square() }, true, true),
        (square(), true, false),
        // Viewers generate missing tangents from the coordinates of the normal texture.
        (square().material(mapped.clone()), true, false),
    ] {
        let along_x = Some(vec![Vec4::new(1.0, 0.0, 0.0, 1.0); 4]);
        let name = format!("{} {}", made.material, made.extensions);
        assert_eq!(upright(&made, &with(TangentPolicy::Auto)), along_x.clone().filter(|_| needs), "{name}");
        assert_eq!(upright(&made, &with(TangentPolicy::Drop)), None, "{name}");
        // Missing ones are added if the file is invalid without them.
        let missing = upright(&made.without("TANGENT"), &with(TangentPolicy::Auto));
        assert_eq!(missing, along_x.filter(|_| is_generated), "{name}");
    }
}

/// The tangent is the direction in which the transformed u rises and v stays, and the bitangent points up the image.
#[test]
fn tangents_follow_the_coordinates_of_the_texture() {
    let second = |[x, y]: [f32; 2]| vec![0.3 * x + 0.4 * y, 0.5 * x - 0.2 * y + 0.1];
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let made = square().with("TEXCOORD_1", corners.map(second));
    let transform =
        |transform: Value| json!({"index": 0, "extensions": {"KHR_texture_transform": transform}});
    let with_set = |mut texture: Value| {
        texture["texCoord"] = 1.into();
        texture
    };
    for (texture, set, rotation, scale) in [
        (json!({"index": 0}), 0, 0.0, [1.0, 1.0]),
        (with_set(json!({"index": 0})), 1, 0.0, [1.0, 1.0]),
        (transform(json!({"rotation": 0.5})), 0, 0.5, [1.0, 1.0]),
        (transform(json!({"scale": [2, -0.5], "offset": [3, 4]})), 0, 0.0, [2.0, -0.5]),
        (transform(json!({"scale": [2, 0.25], "rotation": -2})), 0, -2.0, [2.0, 0.25]),
        (with_set(transform(json!({"scale": [-1, 3], "rotation": 1}))), 1, 1.0, [-1.0, 3.0]),
        (transform(json!({"texCoord": 1, "rotation": 4})), 1, 4.0, [1.0, 1.0]),
        (with_set(transform(json!({"texCoord": 0, "rotation": 4}))), 0, 4.0, [1.0, 1.0]),
    ] {
        let shown = |p: DVec2| {
            let uv = if set == 0 {
                DVec2::new(p.x, 1.0 - p.y)
            } else {
                DVec2::new(0.3 * p.x + 0.4 * p.y, 0.5 * p.x - 0.2 * p.y + 0.1)
            };
            // Rotated counter-clockwise, where v is downwards.
            DVec2::from_angle(-rotation).rotate(uv * DVec2::from_array(scale))
        };
        let slope = |direction: DVec2| shown(direction) - shown(DVec2::ZERO);
        let material = normal_mapped(texture);
        for policy in [TangentPolicy::Auto, TangentPolicy::Regenerate] {
            let found = upright(&made.clone().material(material.clone()), &with(policy)).unwrap();
            assert_eq!(found.len(), 4);
            for tangent in found {
                let direction = tangent.truncate().as_dvec3().truncate();
                assert!(tangent.z == 0.0 && (direction.length() - 1.0).abs() < 1e-6, "{material}: {tangent}");
                let slope_of_tangent = slope(direction);
                assert!(slope_of_tangent.x > 0.1 && slope_of_tangent.y.abs() < 1e-6, "{material}: {tangent}");
                let bitangent = direction.perp() * f64::from(tangent.w);
                assert!(slope(bitangent).y < -0.1, "{material}: {tangent}");
            }
        }
    }
}

/// A strip of two squares whose texture is mirrored at x = 0, where the squares share vertices.
fn mirrored() -> Made {
    let points = [-1.0, 0.0, 1.0].map(|x| [[x, 0.0], [x, 1.0]]).concat();
    let made = Made { indices: vec![0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5], ..Made::default() };
    made.with("POSITION", points.iter().map(|&[x, y]| vec![x, y, 0.0]))
        .with("NORMAL", points.iter().map(|_| vec![0.0, 1.0, 0.0]))
        .with("TANGENT", points.iter().map(|_| vec![1.0, 0.0, 0.0, 1.0]))
        .with("TEXCOORD_0", points.iter().map(|&[x, y]| vec![x.abs(), 1.0 - y]))
        .material(normal_mapped(json!({"index": 0})))
}

#[test]
fn mirrored_coordinates_have_the_other_handedness_and_vertices_of_their_own() {
    let loaded = mirrored().open();
    let written = write(&loaded, towards(&loaded, DVec3::Z), &WriteOptions::default());
    assert_eq!((written.vertices, written.added_vertices), (8, 2));
    let (places, found) = (positions(&written.bytes), tangents(&written.bytes).unwrap());
    let (left, right) = (Vec4::new(-1.0, 0.0, 0.0, -1.0), Vec4::new(1.0, 0.0, 0.0, 1.0));
    for (place, tangent) in places.iter().zip(&found) {
        let wanted = if place.x < 0.0 { left } else { right };
        assert!(*tangent == wanted || place.x == 0.0, "{place} {tangent}");
    }
    for side in [left, right] {
        let shared = places.iter().zip(&found).filter(|(place, tangent)| place.x == 0.0 && **tangent == side);
        assert_eq!(shared.count(), 2);
    }
}

/// Normals that stay keep the file as it is, unless all tangents are to be computed.
#[test]
fn regenerated_tangents_do_not_need_new_normals() {
    let made = mirrored();
    let loaded = made.with("NORMAL", (0..6).map(|_| vec![0.0, 0.0, 1.0])).open();
    let kept = write(&loaded, towards(&loaded, DVec3::Z), &with(TangentPolicy::Auto));
    assert_eq!((kept.vertices, tangents(&kept.bytes).unwrap()), (6, vec![Vec4::new(1.0, 0.0, 0.0, 1.0); 6]));
    let written = write(&loaded, towards(&loaded, DVec3::Z), &with(TangentPolicy::Regenerate));
    let again = write(&mirrored().open(), towards(&loaded, DVec3::Z), &with(TangentPolicy::Auto));
    assert_eq!((written.vertices, written.added_vertices), (8, 2));
    assert_eq!(tangents(&written.bytes), tangents(&again.bytes));
}

#[test]
fn vertices_that_an_extension_numbers_are_not_split_for_tangents() {
    let extensions = json!({"CESIUM_primitive_outline": {"indices": 4}});
    let loaded = Made { extensions, ..mirrored() }.open();
    let written = write(&loaded, towards(&loaded, DVec3::Z), &WriteOptions::default());
    assert_eq!((written.vertices, tangents(&written.bytes).unwrap().len()), (6, 6));
}

#[test]
fn morph_targets_have_the_difference_of_tangents() {
    // (x, y, 0) becomes (0, x, y): z becomes x, and x becomes y.
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let same = |value: [f32; 3]| vec![value.to_vec(); 4];
    let target = [
        ("POSITION", corners.map(|[x, y]: [f32; 2]| vec![-x, x - y, y]).to_vec()),
        ("NORMAL", same([0.0, 0.0, 0.0])),
        ("TANGENT", same([9.0, 9.0, 9.0])),
    ];
    for has_tangents in [true, false] {
        let target = target.iter().filter(|it| has_tangents || it.0 != "TANGENT").cloned().collect();
        let loaded = Made { target, ..square().material(anisotropic()) }.open();
        let change = PartEdit { morph_normals: vec![vec![DVec3::X; 4]], ..towards(&loaded, DVec3::Z) };
        for policy in [TangentPolicy::Auto, TangentPolicy::Regenerate] {
            let written = write(&loaded, change.clone(), &with(policy));
            assert_eq!(tangents(&written.bytes).unwrap(), vec![Vec4::new(1.0, 0.0, 0.0, 1.0); 4]);
            with_primitive(&written.bytes, |primitive, buffers| {
                let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
                let (_, normals, tangents) = reader.read_morph_targets().next().unwrap();
                assert!(normals.unwrap().all(|delta| delta == [1.0, 0.0, -1.0]));
                assert_eq!(tangents.is_some(), has_tangents);
                assert!(tangents.into_iter().flatten().all(|delta| delta == [-1.0, 1.0, 0.0]));
            });
        }
    }
}

#[test]
fn without_coordinates_tangents_stay_where_normals_turn_little() {
    let along = [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.8, 0.0), DVec3::new(-0.6, 0.8, 0.0)];
    let made = square()
        .without("TEXCOORD_0")
        .with("NORMAL", [(); 4].map(|()| vec![0.0, 0.0, 1.0]))
        .with("TANGENT", along.map(|t| t.as_vec3().extend(-1.0).to_array().to_vec()))
        .material(
            json!({"name": "brushed", "extensions": {"KHR_materials_anisotropy": {"anisotropyStrength": 1}}}),
        );
    for (degrees, stays) in [(1.0_f64, true), (29.9, true), (30.1, false), (120.0, false)] {
        let normal = DVec3::new(0.0, libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
        let loaded = made.open();
        let written = write(&loaded, towards(&loaded, normal), &WriteOptions::default());
        let lost: Vec<String> = written.notes.iter().map(ToString::to_string).collect();
        let lost: Vec<&String> = lost.iter().filter(|text| text.contains("lost")).collect();
        let Some(found) = tangents(&written.bytes) else {
            assert!(!stays, "{degrees}°");
            let wanted = "/meshes/0/primitives/0: material \"brushed\" lost the tangents of its anisotropy: normals rotated by 30°";
            assert!(lost.len() == 1 && lost[0].starts_with(wanted), "{lost:?}");
            continue;
        };
        assert!(stays && lost.is_empty(), "{degrees}°: {lost:?}");
        for (tangent, old) in found.iter().zip(along) {
            let direction = tangent.truncate().as_dvec3();
            let turn = (old - normal * old.dot(normal)).normalize();
            assert!((direction - turn).length() < 1e-6 && tangent.w == -1.0, "{degrees}°: {tangent}");
        }
        // Nothing says what has no tangents and loses none.
        let loaded = made.clone().without("TANGENT").open();
        let written = write(&loaded, towards(&loaded, normal), &WriteOptions::default());
        assert!(written.notes.is_empty() && tangents(&written.bytes).is_none(), "{:?}", written.notes);
    }
}

#[test]
fn tangents_stay_byte_for_byte_where_normals_stay() {
    let authored: [Vec<f32>; 4] = [
        vec![0.6, 0.8, 0.0, -1.0],
        vec![0.0, 1.0, 0.0, 1.0],
        vec![2.0, 0.0, 0.0, 1.0],
        vec![f32::NAN, 0.0, 0.0, 0.5],
    ];
    let made = square().with("TANGENT", authored.clone()).material(anisotropic());
    let loaded = made.open();
    let normals = loaded.parts[0].mesh.columns().normals.clone().unwrap();
    let own = PartEdit { kept: 4, normals: Some(normals.clone()), ..PartEdit::default() };
    for policy in [TangentPolicy::Auto, TangentPolicy::Regenerate, TangentPolicy::Drop] {
        assert!(write(&loaded, own.clone(), &with(policy)).bytes == made.bytes(), "{policy:?}");
    }
    // One normal of four changes.
    let mut values = normals.values.clone();
    values[1] = DVec3::Z;
    let one = PartEdit { normals: Some(Column::per_vertex(values)), ..PartEdit::default() };
    let found = tangents(&write(&loaded, one.clone(), &WriteOptions::default()).bytes).unwrap();
    for (vertex, (found, authored)) in found.iter().zip(&authored).enumerate() {
        let bits = |x: &f32| x.to_bits();
        let is_same = found.to_array().iter().map(bits).eq(authored.iter().map(bits));
        assert_eq!(is_same, vertex != 1, "vertex {vertex}: {found}");
    }
    let new = tangents(&write(&loaded, one, &with(TangentPolicy::Regenerate)).bytes).unwrap();
    assert!(new.iter().all(|tangent| (tangent.truncate().length() - 1.0).abs() < 1e-6), "{new:?}");
}

#[test]
fn new_tangents_do_not_keep_equal_vertices_from_merging() {
    let shared = square().material(anisotropic());
    let facets = shared.attributes.iter().map(|(name, values)| {
        let values = shared.indices.iter().map(|&index| values[usize::from(index)].clone());
        (*name, values.collect())
    });
    let facets = Made { attributes: facets.collect(), indices: Vec::new(), ..shared.clone() };
    for tangents in [TangentPolicy::Auto, TangentPolicy::Regenerate] {
        let loaded = facets.open();
        let options = WriteOptions { merge: Merge::Exact, ..with(tangents) };
        let written = write(&loaded, towards(&loaded, DVec3::Z), &options);
        assert_eq!((written.vertices, written.merged_vertices), (4, 2), "{tangents:?}");
        let found = self::tangents(&written.bytes).unwrap();
        assert_eq!(found, vec![Vec4::new(1.0, 0.0, 0.0, 1.0); 4]);
        assert_eq!(positions(&written.bytes), positions(&shared.bytes()));
    }
    // Where the handedness differs, vertices stay two.
    let loaded = mirrored().open();
    let options = WriteOptions { merge: Merge::Exact, ..WriteOptions::default() };
    assert_eq!(write(&loaded, towards(&loaded, DVec3::Z), &options).vertices, 8);
}
