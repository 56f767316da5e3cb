//! Reading OBJ on one thread and on all, compared with `tobj` on the same bytes, and writing it again.
//!
//! `cargo bench --bench obj`. Only ratios between rows of one run mean anything. The meshes are displaced grids of a
//! million triangles: positions and faces alone, and with texture coordinates and normals.

use crease::io::{self, Format, Loaded, PartEdit, ReadOptions, WriteOptions};
use crease::mesh::Column;
use divan::counter::BytesCount;
use divan::{Bencher, black_box};
use std::fmt::Write;
use std::sync::LazyLock;

/// Cells along each side of the grid: two triangles each.
const CELLS: usize = 707;

static PLAIN: LazyLock<Vec<u8>> = LazyLock::new(|| grid(false));
static FULL: LazyLock<Vec<u8>> = LazyLock::new(|| grid(true));

fn main() {
    divan::main();
}

fn grid(is_full: bool) -> Vec<u8> {
    let mut text = String::new();
    let side = CELLS + 1;
    let at = |vertex: usize| ((vertex % side) as f64 / CELLS as f64, (vertex / side) as f64 / CELLS as f64);
    // A rough surface without the platform's sine: the digits are what matters.
    let height = |x: f64, y: f64| ((x * 61.3) % 1.0) * ((y * 47.7) % 1.0) * 0.1 - 0.05;
    for (x, y) in (0..side * side).map(at) {
        writeln!(text, "v {x:.6} {y:.6} {:.6}", height(x, y)).unwrap();
    }
    if is_full {
        for (x, y) in (0..side * side).map(at) {
            writeln!(text, "vt {x:.6} {y:.6}").unwrap();
        }
        for (x, y) in (0..side * side).map(at) {
            let (a, b) = (height(y, x), height(x, y));
            let length = (a * a + b * b + 1.0).sqrt();
            writeln!(text, "vn {:.6} {:.6} {:.6}", a / length, b / length, 1.0 / length).unwrap();
        }
    }
    for cell in 0..CELLS * CELLS {
        let a = cell / CELLS * side + cell % CELLS + 1;
        for corners in [[a, a + 1, a + side + 1], [a, a + side + 1, a + side]] {
            text.push('f');
            for corner in corners {
                match is_full {
                    true => write!(text, " {corner}/{corner}/{corner}").unwrap(),
                    false => write!(text, " {corner}").unwrap(),
                }
            }
            text.push('\n');
        }
    }
    text.into_bytes()
}

fn text(name: &str) -> &'static [u8] {
    if name == "plain" { &PLAIN } else { &FULL }
}

fn read(bytes: Vec<u8>) -> Loaded {
    io::read_bytes(bytes, Some(Format::Obj), None, &ReadOptions::default()).unwrap()
}

#[divan::bench(args = ["plain", "full"])]
fn crease_1_thread(bencher: Bencher, name: &str) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let text = text(name);
    let bencher = bencher.counter(BytesCount::of_slice(text)).with_inputs(|| text.to_vec());
    bencher.bench_local_values(|bytes| pool.install(|| read(bytes)));
}

#[divan::bench(args = ["plain", "full"])]
fn crease_all_threads(bencher: Bencher, name: &str) {
    let text = text(name);
    let bencher = bencher.counter(BytesCount::of_slice(text)).with_inputs(|| text.to_vec());
    bencher.bench_local_values(read);
}

#[divan::bench(args = ["plain", "full"])]
fn tobj(bencher: Bencher, name: &str) {
    let text = text(name);
    bencher.counter(BytesCount::of_slice(text)).bench_local(|| {
        let no_materials = |_: &std::path::Path| Err(tobj::LoadError::GenericFailure);
        tobj::load_obj_buf(&mut black_box(text), &tobj::GPU_LOAD_OPTIONS, no_materials).unwrap()
    });
}

/// One new normal a vertex put into the text.
#[divan::bench(args = ["plain", "full"])]
fn edit_normals(bencher: Bencher, name: &str) {
    let text = text(name);
    let loaded = read(text.to_vec());
    let positions = loaded.parts[0].mesh.positions();
    let normals = positions.iter().map(|position| (position + 1.0).normalize()).collect();
    let edits = [PartEdit { normals: Some(Column::per_vertex(normals)), ..PartEdit::default() }];
    let bencher = bencher.counter(BytesCount::of_slice(text));
    bencher.bench_local(|| io::write(&loaded, &edits, Format::Obj, &WriteOptions::default()).unwrap());
}
