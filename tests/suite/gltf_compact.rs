//! Compact glTF: vertices are merged and unused bytes removed, and everything else stays. Files are decoded by code of this test.

use super::gltf::{entries, load};
use crease::io::gltf::edit;
use crease::io::{
    Document, Format, Loaded, NormalFormat, Part, PartEdit, TangentPolicy, WriteOptions, Written,
};
use crease::mesh::Column;
use glam::DVec3;
use serde_json::{Value, json};
use std::collections::BTreeSet;

/// A GLB: its JSON and its BIN chunk.
struct Glb<'a> {
    json: Value,
    bin: &'a [u8],
}

impl<'a> Glb<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        let json = word(12);
        let bin = if bytes.len() > 20 + json { &bytes[28 + json..28 + json + word(20 + json)] } else { &[] };
        Self { json: serde_json::from_slice(&bytes[20..20 + json]).unwrap(), bin }
    }

    fn list(&self, name: &str) -> &[Value] {
        self.json[name].as_array().map_or(&[], |list| list)
    }

    /// Bytes of a view; `None` if they are not in the BIN chunk.
    fn view(&self, number: &Value) -> Option<&'a [u8]> {
        let view = &self.json["bufferViews"][index(number)];
        let is_bin = view["buffer"] == 0 && self.json["buffers"][0].get("uri").is_none();
        let (offset, length) =
            (view["byteOffset"].as_u64().unwrap_or(0) as usize, index(&view["byteLength"]));
        is_bin.then(|| &self.bin[offset..offset + length])
    }

    /// The elements of an accessor with its type.
    fn elements(&self, number: &Value) -> Option<Vec<Vec<u8>>> {
        let accessor = &self.json["accessors"][index(number)];
        let component = match accessor["componentType"].as_u64().unwrap() {
            5120 | 5121 => 1,
            5122 | 5123 => 2,
            _ => 4,
        };
        let width = match accessor["type"].as_str().unwrap() {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "MAT4" => 16,
            _ => 4,
        };
        let (size, count) = (component * width, index(&accessor["count"]));
        let mut elements = vec![vec![0; size]; count];
        let at = |site: &Value| site["byteOffset"].as_u64().unwrap_or(0) as usize;
        if let Some(number) = accessor.get("bufferView") {
            let view = self.view(number)?;
            let stride = self.json["bufferViews"][index(number)]["byteStride"].as_u64();
            let stride = stride.map_or(size, |stride| stride as usize);
            for (number, element) in elements.iter_mut().enumerate() {
                element.copy_from_slice(&view[at(accessor) + number * stride..][..size]);
            }
        }
        if let Some(sparse) = accessor.get("sparse") {
            let (indices, values) = (&sparse["indices"], &sparse["values"]);
            let wide = match indices["componentType"].as_u64().unwrap() {
                5121 => 1,
                5123 => 2,
                _ => 4,
            };
            let (list, data) = (self.view(&indices["bufferView"])?, self.view(&values["bufferView"])?);
            for number in 0..index(&sparse["count"]) {
                let mut place = [0; 8];
                place[..wide].copy_from_slice(&list[at(indices) + number * wide..][..wide]);
                elements[u64::from_le_bytes(place) as usize]
                    .copy_from_slice(&data[at(values) + number * size..][..size]);
            }
        }
        Some(elements)
    }

    /// Each attribute of the vertices of a primitive in the order in which they are drawn.
    fn drawn(&self, primitive: &Value) -> Option<Vec<(String, Vec<Vec<u8>>)>> {
        let sets = std::iter::once(&primitive["attributes"])
            .chain(primitive["targets"].as_array().into_iter().flatten());
        let order: Option<Vec<usize>> = match primitive.get("indices") {
            None => None,
            Some(indices) => Some(
                self.elements(indices)?
                    .iter()
                    .map(|bytes| {
                        let mut wide = [0; 8];
                        wide[..bytes.len()].copy_from_slice(bytes);
                        u64::from_le_bytes(wide) as usize
                    })
                    .collect(),
            ),
        };
        let mut all = Vec::new();
        for (set, attributes) in sets.enumerate() {
            for (name, accessor) in attributes.as_object().unwrap() {
                let elements = self.elements(accessor)?;
                let drawn = match &order {
                    Some(order) => order.iter().map(|&vertex| elements[vertex].clone()).collect(),
                    None => elements,
                };
                all.push((format!("{set} {name}"), drawn));
            }
        }
        Some(all)
    }

    fn primitives(&self) -> impl Iterator<Item = &Value> {
        self.list("meshes").iter().flat_map(|mesh| mesh["primitives"].as_array().unwrap())
    }

    /// The content behind everything else that refers to accessors or views.
    fn others(&self) -> Vec<Option<Vec<Vec<u8>>>> {
        let samplers = self.list("animations").iter().flat_map(|it| it["samplers"].as_array().unwrap());
        let of_samplers = samplers.flat_map(|it| [&it["input"], &it["output"]]);
        let of_skins = self.list("skins").iter().filter_map(|skin| skin.get("inverseBindMatrices"));
        let images = self.list("images").iter().filter_map(|image| image.get("bufferView"));
        let images = images.map(|view| self.view(view).map(|bytes| vec![bytes.to_vec()]));
        of_samplers.chain(of_skins).map(|accessor| self.elements(accessor)).chain(images).collect()
    }

    /// The accessors and views that something uses.
    fn used(&self) -> [BTreeSet<usize>; 2] {
        let mut accessors = BTreeSet::new();
        for primitive in self.primitives() {
            let sets = std::iter::once(&primitive["attributes"])
                .chain(primitive["targets"].as_array().into_iter().flatten());
            accessors.extend(sets.flat_map(|set| set.as_object().unwrap().values()).map(index));
            accessors.extend(primitive.get("indices").map(index));
        }
        for sampler in self.list("animations").iter().flat_map(|it| it["samplers"].as_array().unwrap()) {
            accessors.extend([index(&sampler["input"]), index(&sampler["output"])]);
        }
        accessors
            .extend(self.list("skins").iter().filter_map(|skin| skin.get("inverseBindMatrices")).map(index));
        let mut views: BTreeSet<usize> =
            self.list("images").iter().filter_map(|it| it.get("bufferView")).map(index).collect();
        for accessor in accessors.iter().map(|&accessor| &self.json["accessors"][accessor]) {
            views.extend(accessor.get("bufferView").map(index));
            if let Some(sparse) = accessor.get("sparse") {
                views.extend([
                    index(&sparse["indices"]["bufferView"]),
                    index(&sparse["values"]["bufferView"]),
                ]);
            }
        }
        [accessors, views]
    }
}

fn index(number: &Value) -> usize {
    number.as_u64().unwrap_or_else(|| panic!("{number} is no index")) as usize
}

fn document(loaded: &Loaded) -> &crease::io::gltf::GltfDocument {
    let Document::Gltf(document) = &loaded.document else { panic!("no glTF") };
    document
}

/// The normals that a file has, all of them its own; any where it has none.
fn own(part: &Part) -> PartEdit {
    let normals = part.mesh.columns().normals.clone();
    let kept = normals.as_ref().map_or(0, |normals| normals.values.len());
    let any = || Column::per_vertex(vec![DVec3::Z; part.mesh.vertex_count()]);
    PartEdit { normals: Some(normals.unwrap_or_else(any)), kept, ..PartEdit::default() }
}

fn write(loaded: &Loaded, options: &WriteOptions) -> Written {
    let edits: Vec<PartEdit> = loaded.parts.iter().map(own).collect();
    edit(document(loaded), loaded, &edits, Format::Glb, options).unwrap()
}

fn compact() -> WriteOptions {
    WriteOptions { compact: true, tangents: TangentPolicy::Keep, ..WriteOptions::default() }
}

/// Compares a compact file with one that differs in nothing else. Attributes that normals are stored in may differ.
fn compare(name: &str, plain: &[u8], compact: &[u8]) {
    let (plain, compact) = (Glb::new(plain), Glb::new(compact));
    assert_eq!(plain.others(), compact.others(), "{name}");
    for list in ["nodes", "scenes", "materials", "textures", "cameras", "asset", "extensionsUsed"] {
        assert_eq!(plain.json[list], compact.json[list], "{name}: {list}");
    }
    assert_eq!(plain.primitives().count(), compact.primitives().count(), "{name}");
    for (old, new) in plain.primitives().zip(compact.primitives()) {
        // Merged strips become triangles: the reader below compares them.
        if old.get("mode") == new.get("mode") {
            assert!(plain.drawn(old) == compact.drawn(new), "{name}: {old} {new}");
        }
        assert_eq!(old.get("material"), new.get("material"));
    }
}

/// Positions, texture coordinates and normals at all corners.
fn corners(loaded: &Loaded) -> Vec<String> {
    let of_part = |part: &Part| {
        let (mesh, columns) = (&part.mesh, part.mesh.columns());
        let corner = |(corner, &vertex): (usize, &u32)| {
            let uv = columns.uvs.as_ref().and_then(|uvs| uvs.get(corner, vertex));
            let normal = columns.normals.as_ref().and_then(|normals| normals.get(corner, vertex));
            format!("{:?} {uv:?} {normal:?}", mesh.positions().at(vertex))
        };
        mesh.faces().corners().iter().enumerate().map(corner).collect::<Vec<_>>()
    };
    loaded.parts.iter().flat_map(of_part).collect()
}

#[test]
fn compact_files_have_all_that_they_had() {
    let mut saved = 0;
    for entry in entries("gltf/").into_iter().filter(|entry| entry.expect.starts_with("load")) {
        let loaded = load(&entry.path).unwrap();
        for normal_format in [NormalFormat::Same, NormalFormat::I8] {
            let options = WriteOptions { normal_format, ..compact() };
            let plain = write(&loaded, &WriteOptions { compact: false, ..options.clone() });
            let small = write(&loaded, &options);
            compare(&entry.name, &plain.bytes, &small.bytes);
            let read = |bytes: &[u8]| {
                crease::io::gltf::read(bytes.to_vec(), entry.path.parent(), &Default::default()).unwrap()
            };
            let (before, after) = (read(&plain.bytes), read(&small.bytes));
            assert!(corners(&before) == corners(&after), "{}", entry.name);
            let glb = Glb::new(&small.bytes);
            if small.notes.iter().any(|note| note.text.starts_with("bytes that nothing uses stay")) {
                continue;
            }
            saved += plain.bytes.len() - small.bytes.len();
            let [accessors, views] = glb.used();
            assert_eq!(
                (accessors.len(), views.len()),
                (glb.list("accessors").len(), glb.list("bufferViews").len()),
                "{}",
                entry.name
            );
            // Only fillers are between the views.
            let sum: usize = glb
                .list("bufferViews")
                .iter()
                .map(|view| index(&view["byteLength"]).next_multiple_of(4))
                .sum();
            let most = sum + 4 * views.len();
            assert!(glb.bin.len() <= most, "{}: {} bytes, {most} at most", entry.name, glb.bin.len());
        }
    }
    println!("{saved} bytes saved");
}

#[test]
fn omitted_normals_stay_where_others_need_them() {
    for entry in entries("gltf/").into_iter().filter(|entry| entry.expect.starts_with("load")) {
        let loaded = load(&entry.path).unwrap();
        let flat = write(&loaded, &WriteOptions { omit_normals: true, ..compact() });
        let glb = Glb::new(&flat.bytes);
        let lines = |primitive: &Value| primitive["mode"].as_u64().is_some_and(|mode| mode < 4);
        for primitive in glb.primitives().filter(|primitive| !lines(primitive)) {
            let has = |set: &Value, name: &str| set.get(name).is_some();
            let attributes = &primitive["attributes"];
            let targets = primitive["targets"].as_array().cloned().unwrap_or_default();
            let needs = has(attributes, "TANGENT")
                || targets.iter().any(|target| has(target, "NORMAL") || has(target, "TANGENT"));
            assert!(needs || !has(attributes, "NORMAL"), "{}: {primitive}", entry.name);
        }
        let again =
            crease::io::gltf::read(flat.bytes.clone(), entry.path.parent(), &Default::default()).unwrap();
        let positions = |loaded: &Loaded| -> Vec<String> {
            corners(loaded)
                .iter()
                .map(|corner| corner.split(" Some(").next().unwrap().replace(" None", ""))
                .collect()
        };
        assert!(positions(&loaded) == positions(&again), "{}", entry.name);
    }
}

/// A GLB of triangles whose attributes are interleaved in one view, in front of an image and of an accessor that nothing uses.
fn interleaved(root: &str) -> Vec<u8> {
    let mut bin: Vec<u8> = Vec::new();
    for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0_f32)] {
        let row = [x, y, 0.0, 0.0, 0.0, 1.0, x, y];
        bin.extend(row.iter().flat_map(|number| number.to_le_bytes()));
    }
    bin.extend(*b"junkjunk");
    bin.extend(*b"\x89PNG image");
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"meshes":[{{"primitives":[{{"attributes":{{"POSITION":2,"NORMAL":3,"TEXCOORD_0":4}}}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR"}},
        {{"componentType":5126,"count":9,"type":"VEC3"}},
        {{"bufferView":2,"componentType":5126,"count":6,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}},
        {{"bufferView":2,"byteOffset":12,"componentType":5126,"count":6,"type":"VEC3"}},
        {{"bufferView":2,"byteOffset":24,"componentType":5126,"count":6,"type":"VEC2"}}],
        "bufferViews":[{{"buffer":0,"byteOffset":192,"byteLength":8}},{{"buffer":0,"byteOffset":200,"byteLength":10}},
        {{"buffer":0,"byteLength":192,"byteStride":32,"target":34962}}],
        "images":[{{"bufferView":1,"mimeType":"image/png"}}],"buffers":[{{"byteLength":212}}]{root}}}"#
    );
    let text = text.into_bytes();
    let padded = |mut bytes: Vec<u8>, filler| {
        bytes.resize(bytes.len().next_multiple_of(4), filler);
        bytes
    };
    let (text, bin) = (padded(text, b' '), padded(bin, 0));
    let mut glb = b"glTF".to_vec();
    for word in [2, (28 + text.len() + bin.len()) as u32, text.len() as u32, u32::from_le_bytes(*b"JSON")] {
        glb.extend(word.to_le_bytes());
    }
    glb.extend(&text);
    glb.extend((bin.len() as u32).to_le_bytes());
    glb.extend(*b"BIN\0");
    glb.extend(bin);
    glb
}

fn open(bytes: &[u8]) -> Loaded {
    crease::io::gltf::read(bytes.to_vec(), None, &Default::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn interleaved_attributes_close_up() {
    let loaded = open(&interleaved(""));
    let options = WriteOptions { normal_format: NormalFormat::I8, ..compact() };
    let written = write(&loaded, &options);
    let glb = Glb::new(&written.bytes);
    // Two of six corners are equal to others: with indices of two bytes nothing would be saved.
    assert_eq!(written.vertices, 6);
    assert_eq!((glb.list("accessors").len(), glb.list("bufferViews").len()), (3, 3));
    assert_eq!(glb.json["bufferViews"][1]["byteStride"], 20);
    assert_eq!(glb.json["accessors"][2]["byteOffset"], 12);
    assert_eq!(glb.view(&json!(0)), Some(&b"\x89PNG image"[..10]));
    assert!(glb.bin.len() <= 6 * 20 + 6 * 4 + 12, "{}", glb.bin.len());
    assert_eq!(corners(&open(&written.bytes)).len(), 6);
    let drawn = |glb: &Glb| glb.drawn(glb.primitives().next().unwrap()).unwrap();
    let (old, new) = (interleaved(""), drawn(&glb));
    let old = drawn(&Glb::new(&old));
    assert_eq!((&old[1], &old[2]), (&new[1], &new[2]), "positions and texture coordinates");
}

#[test]
fn numbers_in_unknown_extensions_keep_what_they_may_refer_to() {
    let loaded =
        open(&interleaved(r#","extensions":{"ACME_uses":{"accessor":1}},"extensionsUsed":["ACME_uses"]"#));
    let written = write(&loaded, &compact());
    let glb = Glb::new(&written.bytes);
    assert_eq!((glb.list("accessors").len(), glb.list("bufferViews").len()), (5, 3));
    assert!(written.notes.iter().any(|note| note.text.starts_with("bytes that nothing uses stay")));
}
