//! Generated text with a known meaning, so that everything that is read can be checked.

use super::{Random, at_corners, mesh_of, read};
use crease::io::{self, Document, Format, Loaded, Merge, PartEdit, WriteOptions};
use crease::mesh::{Column, ColumnIndex, NONE};
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use std::fmt::Write;

/// A corner: indices of elements defined so far, and whether they are written as negative numbers.
#[derive(Clone, Debug)]
struct Pick {
    vertex: usize,
    uv: Option<usize>,
    normal: Option<usize>,
    is_relative: bool,
}

#[derive(Clone, Debug)]
enum Line {
    Vertex([f64; 3]),
    Uv([f64; 2]),
    Normal([f64; 3]),
    Face(Vec<Pick>),
    Smoothing(u32),
    Material(u32),
    Other(&'static str),
}

/// The layout of the text.
#[derive(Clone, Debug)]
struct Layout {
    line_end: &'static str,
    blank: &'static str,
    tail: &'static str,
    has_last_line_end: bool,
}

/// The text and its meaning.
#[derive(Debug, Default)]
struct Meaning {
    text: String,
    positions: Vec<DVec3>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
    faces: Vec<Vec<u32>>,
    corner_uvs: Vec<Option<DVec2>>,
    corner_normals: Vec<Option<DVec3>>,
    smoothing: Vec<u32>,
    materials: Vec<Option<u32>>,
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![-10.0..10.0, any::<f32>().prop_map(f64::from), any::<f64>(), Just(0.0), Just(1e-300)]
        .prop_filter("positions are finite", |value: &f64| value.is_finite())
}

/// Lines that say nothing about faces.
const OTHER: &[&str] =
    &["# f 1 2 3", "", "  \t", "l -1 -1", "p -1", "o x", "g a b", "unknown 1", "# \\", "lod 3"];

fn line() -> impl Strategy<Value = Line> {
    let pick = (any::<usize>(), any::<Option<usize>>(), any::<Option<usize>>(), any::<bool>());
    let pick = pick.prop_map(|(vertex, uv, normal, is_relative)| Pick { vertex, uv, normal, is_relative });
    prop_oneof![
        4 => prop::array::uniform3(number()).prop_map(Line::Vertex),
        2 => prop::array::uniform2(number()).prop_map(Line::Uv),
        2 => prop::array::uniform3(number()).prop_map(Line::Normal),
        6 => prop::collection::vec(pick, 1..6).prop_map(Line::Face),
        1 => (0_u32..4).prop_map(Line::Smoothing),
        1 => (0_u32..3).prop_map(Line::Material),
        2 => prop::sample::select(OTHER).prop_map(Line::Other),
    ]
}

fn layout() -> impl Strategy<Value = Layout> {
    let choose = |choices: &'static [&'static str]| prop::sample::select(choices);
    (
        choose(&["\n", "\r\n", "\r"]),
        choose(&[" ", "\t", "  ", " \\\n", " \\\r\n\t"]),
        choose(&["", " ", " # x", "#"]),
        any::<bool>(),
    )
        .prop_map(|(line_end, blank, tail, has_last_line_end)| Layout {
            line_end,
            blank,
            tail,
            has_last_line_end,
        })
}

impl Meaning {
    fn of(lines: &[Line], layout: &Layout) -> Self {
        // Text of unknown statements alone would be refused.
        let mut meaning = Meaning { text: format!("lod 1{}", layout.line_end), ..Meaning::default() };
        let (mut smoothing, mut material) = (0, None);
        for (number, line) in lines.iter().enumerate() {
            let words = match line {
                Line::Vertex(position) => {
                    meaning.positions.push(DVec3::from_array(*position));
                    words("v", position)
                }
                Line::Uv(uv) => {
                    meaning.uvs.push(DVec2::from_array(*uv));
                    words("vt", uv)
                }
                Line::Normal(normal) => {
                    meaning.normals.push(DVec3::from_array(*normal));
                    words("vn", normal)
                }
                Line::Face(_) if meaning.positions.is_empty() => continue,
                Line::Face(picks) => {
                    let words = meaning.face(picks);
                    if picks.len() >= 3 {
                        meaning.smoothing.push(smoothing);
                        meaning.materials.push(material);
                    }
                    words
                }
                Line::Smoothing(group) => {
                    smoothing = *group;
                    vec!["s".to_owned(), if *group == 0 { "off".to_owned() } else { group.to_string() }]
                }
                Line::Material(name) => {
                    material = Some(*name);
                    meaning.text.push_str(&format!("usemtl m{name}{}", layout.line_end));
                    continue;
                }
                Line::Other(text) if text.ends_with("-1") && meaning.positions.is_empty() => continue,
                Line::Other(text) => {
                    meaning.text.push_str(text);
                    meaning.text.push_str(layout.line_end);
                    continue;
                }
            };
            meaning.text.push_str(&words.join(layout.blank));
            meaning.text.push_str(layout.tail);
            if layout.has_last_line_end || number + 1 < lines.len() {
                meaning.text.push_str(layout.line_end);
            }
        }
        meaning
    }

    fn face(&mut self, picks: &[Pick]) -> Vec<String> {
        let mut words = vec!["f".to_owned()];
        let mut face = Vec::new();
        let (mut uvs, mut normals) = (Vec::new(), Vec::new());
        for pick in picks {
            let spell = |index: usize, count: usize| {
                if pick.is_relative { index as i64 - count as i64 } else { index as i64 + 1 }
            };
            let vertex = pick.vertex % self.positions.len();
            let uv = pick.uv.filter(|_| !self.uvs.is_empty()).map(|uv| uv % self.uvs.len());
            let normal =
                pick.normal.filter(|_| !self.normals.is_empty()).map(|normal| normal % self.normals.len());
            let mut word = spell(vertex, self.positions.len()).to_string();
            if uv.is_some() || normal.is_some() {
                word.push('/');
            }
            if let Some(uv) = uv {
                write!(word, "{}", spell(uv, self.uvs.len())).unwrap();
            }
            if let Some(normal) = normal {
                write!(word, "/{}", spell(normal, self.normals.len())).unwrap();
            }
            words.push(word);
            face.push(vertex as u32);
            uvs.push(uv.map(|uv| self.uvs[uv]));
            normals.push(normal.map(|normal| self.normals[normal]));
        }
        // The reader skips shorter ones.
        if face.len() >= 3 {
            self.faces.push(face);
            self.corner_uvs.extend(uvs);
            self.corner_normals.extend(normals);
        }
        words
    }

    fn check(&self, bytes: &[u8]) {
        let mesh = mesh_of(bytes);
        assert_eq!(mesh.positions().to_vec(), self.positions);
        let faces: Vec<Vec<u32>> = mesh.faces().iter().map(<[u32]>::to_vec).collect();
        assert_eq!(faces, self.faces);
        assert_eq!(at_corners(&mesh, &mesh.columns().uvs), self.corner_uvs);
        let columns = mesh.columns();
        if let Some(groups) = &columns.smoothing {
            assert_eq!(groups.of_face, self.smoothing);
        } else {
            assert!(self.smoothing.iter().all(|&group| group == 0));
        }
        let material = |face: usize| {
            let labels = columns.materials.as_ref()?;
            labels.names.get(labels.of_face[face] as usize).cloned()
        };
        for (face, expected) in self.materials.iter().enumerate() {
            assert_eq!(material(face), expected.map(|name| format!("m{name}")));
        }
    }
}

fn words(keyword: &str, values: &[f64]) -> Vec<String> {
    let spelled = values.iter().enumerate().map(|(place, value)| match place % 2 {
        0 => format!("{value:?}"),
        _ => format!("{value:e}"),
    });
    std::iter::once(keyword.to_owned()).chain(spelled).collect()
}

/// A new normal for each corner, some shared, some absent.
fn new_normals(corners: usize, random: &mut Random) -> Column<DVec3> {
    let values: Vec<DVec3> = (0..=corners / 2)
        .map(|_| DVec3::new(random.below(9) as f64 - 4.0, random.below(9) as f64, 1.0).normalize())
        .collect();
    let index = (0..corners).map(|_| if random.one_in(5) { NONE } else { random.below(values.len()) as u32 });
    Column::per_corner(values.clone(), index.collect())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn text_means_what_it_says(lines in prop::collection::vec(line(), 0..60), layout in layout(), seed in any::<u64>()) {
        let meaning = Meaning::of(&lines, &layout);
        let bytes = meaning.text.as_bytes();
        meaning.check(bytes);
        let mesh = mesh_of(bytes);
        prop_assert_eq!(at_corners(&mesh, &mesh.columns().normals), &meaning.corner_normals[..]);

        let normals = new_normals(mesh.faces().corner_count(), &mut Random(seed));
        let edits = [PartEdit { normals: Some(normals.clone()), ..PartEdit::default() }];
        let loaded = read(bytes).unwrap();
        // From another format, the same meshes are written anew.
        let foreign = Loaded { format: Format::Ply, document: Document::None, ..loaded.clone() };
        for source in [loaded, foreign] {
            // Every vertex stays, also where a mesh is facet-wise.
            let options = WriteOptions { merge: Merge::Off, ..WriteOptions::default() };
            let output = io::write(&source, &edits, Format::Obj, &options).unwrap().bytes;
            meaning.check(&output);
            let back = mesh_of(&output);
            let found = at_corners(&back, &back.columns().normals);
            for (found, asked) in found.into_iter().zip(at_corners(&mesh, &Some(normals.clone()))) {
                prop_assert_eq!(found.map(|normal| normal.as_vec3()), asked.map(|normal| normal.as_vec3()));
            }
        }
    }
}

/// Several pieces of text with everything that crosses their borders.
fn long_text() -> (String, Vec<DVec3>, Vec<Vec<u32>>) {
    let mut random = Random(9);
    let (mut text, mut positions, mut faces) = (String::from("v 0 0 0\r\n"), vec![DVec3::ZERO], Vec::new());
    let mut uvs = 0;
    while text.len() < 5 << 20 {
        match random.below(10) {
            0..4 => {
                let position = DVec3::new(
                    random.below(1000) as f64 / 8.0,
                    random.below(9) as f64,
                    positions.len() as f64,
                );
                positions.push(position);
                let end = if random.one_in(40) { " \\\r\n" } else { " " };
                write!(text, "v {:?}{end}{:?} {:e}\r\n", position.x, position.y, position.z).unwrap();
            }
            4 => {
                uvs += 1;
                text.push_str("vt 0.25 0.5\r\nvn 0 0 1\r\n");
            }
            5 => text.push_str(
                ["# a comment \\\r\n", "s 1\r\n", "s off\r\n", "usemtl a\r\n", "g b\r\n"][random.below(5)],
            ),
            _ => {
                let arity = if text.len() < 3 << 20 { 3 } else { 3 + random.below(3) };
                let picked: Vec<u32> = (0..arity).map(|_| random.below(positions.len()) as u32).collect();
                text.push('f');
                for &vertex in &picked {
                    text.push_str([" ", " \\\r\n", "  "][usize::from(random.one_in(30))]);
                    match random.below(3) {
                        0 => write!(text, "{}", i64::from(vertex) - positions.len() as i64).unwrap(),
                        1 if uvs > 0 => write!(text, "{}/-1/{uvs}", vertex + 1).unwrap(),
                        _ => write!(text, "{}", vertex + 1).unwrap(),
                    }
                }
                text.push_str("\r\n");
                faces.push(picked);
            }
        }
    }
    (text, positions, faces)
}

#[test]
fn any_number_of_threads_loads_the_same() {
    let (text, positions, faces) = long_text();
    let mut first = None;
    for threads in [1, 2, 3, 8] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let mesh = pool.install(|| mesh_of(text.as_bytes()));
        assert!(mesh.positions().to_vec() == positions, "{threads} threads");
        assert!(mesh.faces().iter().eq(faces.iter().map(Vec::as_slice)), "{threads} threads");
        assert!(*first.get_or_insert_with(|| mesh.clone()) == mesh, "{threads} threads");
    }
    let mesh = first.unwrap();
    let normals = new_normals(mesh.faces().corner_count(), &mut Random(1));
    let edit = PartEdit { normals: Some(normals.clone()), ..PartEdit::default() };
    let output =
        io::write(&read(text.as_bytes()).unwrap(), &[edit], io::Format::Obj, &WriteOptions::default())
            .unwrap()
            .bytes;
    let back = mesh_of(&output);
    assert!(back.clone().with_normals(None) == mesh.clone().with_normals(None));
    let f32s = |column: Option<Column<DVec3>>| -> Vec<_> {
        at_corners(&mesh, &column).into_iter().map(|normal| normal.map(|normal| normal.as_vec3())).collect()
    };
    assert!(f32s(back.columns().normals.clone()) == f32s(Some(normals)));
}

#[test]
fn the_first_fault_in_the_file_is_the_one_that_is_reported() {
    let (text, ..) = long_text();
    let line_of = |at: usize| text[..at].matches("\r\n").count() as u64 + 1;
    let mut broken = text.clone();
    for at in [4 << 20, 2 << 20] {
        let line = broken[at..].find("\r\nv ").unwrap() + at + 2;
        broken.replace_range(line..line + 3, "v x");
        for threads in [1, 2, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let error = pool.install(|| read(broken.as_bytes())).unwrap_err();
            assert_eq!(error.place, io::Place::Line(line_of(line)), "{error}");
        }
    }
    let unbounded = text + "f 1 2 99999999\r\n";
    assert!(read(unbounded.as_bytes()).unwrap_err().found.contains("vertex index 99999999"));
}

#[test]
fn kept_normals_are_counted_across_pieces() {
    // More normals before the first face than a piece of text holds, and one normal after it.
    let count = 200_000;
    let mut text: String = (0..count).map(|number| format!("vn {number} 0 1\n")).collect();
    write!(text, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//{count} 3//-1\nvn 0 0 7\nf 1//-1 2//-1 3//-1\n")
        .unwrap();
    let loaded = read(text.as_bytes()).unwrap();
    let mut normals = loaded.parts[0].mesh.columns().normals.clone().unwrap();
    let kept = normals.values.len();
    assert_eq!(kept, count + 1);
    normals.values.push(DVec3::X);
    normals.index =
        ColumnIndex::PerCorner(vec![0, kept as u32, count as u32 - 1, count as u32, 0, kept as u32]);
    let asked = Some(normals.clone());
    let edit = PartEdit { normals: Some(normals), kept, ..PartEdit::default() };
    let output = io::write(&loaded, &[edit], Format::Obj, &WriteOptions::default()).unwrap().bytes;
    let back = mesh_of(&output);
    assert_eq!(at_corners(&back, &back.columns().normals), at_corners(&loaded.parts[0].mesh, &asked));
}
