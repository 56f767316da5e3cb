//! Broken and hostile input of every format: no panic, no hang, no flood of memory, nothing that is not finite.
//!
//! `CREASE_LONG=1` tries many times as much.

mod crowded;
mod large;

use crate::random::Random;
use crease::io::{self, Format, Loaded, NonFinite, Part, PartEdit, ReadOptions, WriteOptions};
use crease::mesh::{Column, FaceEdit, Mesh};
use glam::DVec3;
use std::fs;
use std::path::Path;
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Far longer than any test here takes on a busy machine: a test that needs it hangs. With `CREASE_LONG=1` the longest one takes
/// two minutes on two idle cores.
fn patience() -> Duration {
    Duration::from_secs(if is_long() { 1200 } else { 300 })
}

pub fn is_long() -> bool {
    std::env::var_os("CREASE_LONG").is_some_and(|value| value == "1")
}

/// Runs in a thread of its own, so that a hang is reported as one; a panic is passed on.
fn patiently(what: &str, work: impl FnOnce() + Send + 'static) {
    let (done, is_done) = mpsc::channel();
    let worker = thread::spawn(move || {
        work();
        // The receiver may have timed out.
        done.send(()).ok();
    });
    if is_done.recv_timeout(patience()) == Err(mpsc::RecvTimeoutError::Timeout) {
        panic!("{what} hangs");
    }
    worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
}

/// OBJ with everything in it.
const OBJ: &str = "\u{feff}# a\\\nmtllib a.mtl b.mtl\no one\nv 0 0 0\nv 1e0 .5 -1. 0.1 0.2 0.3\r\nv 0 1 \\\n 0\nv 1 1 1\n\
    vt 0 0\nvt 1 1\nvn 0 0 1\nvn 0.6 0 0.8 # c\ng a b\nusemtl m\ns 1\nf 1 2 3\nf -4/1/-1 -3//2 3/-1 \\\n\t4//\ns off\n\
    f 1//1 2//1 3//1 4//1\nl 1 2 3\np 4 -1\nvp 0 1\nlod 1\nwhat 3\n";

/// Small files of each format.
fn seeds() -> Vec<(String, Format, Vec<u8>)> {
    let mut seeds = vec![("everything.obj".to_owned(), Format::Obj, OBJ.as_bytes().to_vec())];
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("data");
    let mut paths: Vec<_> = fs::read_dir(data).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if let Some(format) = Format::from_path(&path) {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            seeds.push((name, format, fs::read(&path).unwrap()));
        }
    }
    assert!(Format::ALL.iter().all(|format| seeds.iter().any(|(_, seed, _)| seed == format)));
    seeds
}

fn finite(mesh: &Mesh) -> bool {
    let columns = mesh.columns();
    mesh.positions().iter().all(|position| position.is_finite())
        && columns.uvs.iter().flat_map(|uvs| &uvs.values).all(|uv| uv.is_finite())
        && columns.colors.iter().flatten().flatten().all(|value| value.is_finite())
        && columns.morph_targets.iter().flatten().all(|moved| moved.is_finite())
}

/// Reads, and writes what could be read: back to its own format, and anew to others.
fn try_bytes(name: &str, format: Format, bytes: &[u8], non_finite: NonFinite) {
    let options = ReadOptions { non_finite, ..ReadOptions::default() };
    let loaded = match io::read_bytes(bytes.to_vec(), Some(format), None, &options) {
        Ok(loaded) => loaded,
        Err(error) => {
            assert!(!error.found.is_empty() && !error.advice.is_empty(), "{name}: {error:?}");
            return;
        }
    };
    assert!(loaded.parts.iter().all(|part| finite(&part.mesh)), "{name}");
    let edits: Vec<PartEdit> = loaded.parts.iter().map(upward).collect();
    for to in [format, Format::Obj, Format::Glb] {
        if let Ok(written) = io::write(&loaded, &edits, to, &WriteOptions::default()) {
            let again = io::read_bytes(written.bytes, Some(to), None, &options);
            check_normals(name, &again.unwrap_or_else(|error| panic!("{name} as {to}: {error}")));
        }
    }
}

/// Normals that all point up, without faces at vertices that are not finite.
fn upward(part: &Part) -> PartEdit {
    let faces = FaceEdit { dropped: part.non_finite_faces.clone(), reversed: Vec::new() };
    let normals = Column::per_corner(vec![DVec3::Z], vec![0; part.mesh.faces().corner_count()]);
    let face_normals = vec![DVec3::Z; part.mesh.face_count()];
    PartEdit { faces, normals: Some(normals), face_normals: Some(face_normals), ..PartEdit::default() }
}

fn check_normals(name: &str, loaded: &Loaded) {
    for part in &loaded.parts {
        let Some(normals) = &part.mesh.columns().normals else { continue };
        // A vertex that no face uses keeps its stored normal.
        for (corner, &vertex) in part.mesh.faces().corners().iter().enumerate() {
            let length = normals.get(corner, vertex).map_or(1.0, |normal| normal.length());
            assert!((length - 1.0).abs() < 1e-5, "{name}: corner {corner}");
        }
    }
}

#[test]
fn any_beginning_of_a_file() {
    patiently("a beginning", || {
        for (name, format, bytes) in seeds() {
            // All lengths up to 200, and some 1500 lengths spread over the file.
            let most = if is_long() { bytes.len() } else { 1500 };
            let step = (bytes.len() / most).max(1);
            let lengths = (0..bytes.len().min(200)).chain((0..=bytes.len()).step_by(step));
            for length in lengths {
                try_bytes(&format!("{name} up to {length}"), format, &bytes[..length], NonFinite::Refuse);
            }
        }
    });
}

#[test]
fn flipped_bytes() {
    patiently("a flipped byte", || {
        let seeds = seeds();
        let rounds = if is_long() { 200_000 } else { 6_000 } / seeds.len();
        for (name, format, bytes) in seeds {
            let mut random = Random(bytes.len() as u64);
            for round in 0..rounds {
                let mut broken = bytes.clone();
                for _ in 0..1 + random.below(4) {
                    break_one(&mut broken, &mut random);
                }
                let non_finite = if round % 2 == 0 { NonFinite::Refuse } else { NonFinite::DropFaces };
                try_bytes(&format!("{name}, round {round}"), format, &broken, non_finite);
            }
        }
    });
}

/// Flips a bit, sets a byte to a likely troublemaker, or takes out, doubles or moves a piece.
fn break_one(bytes: &mut Vec<u8>, random: &mut Random) {
    const TROUBLE: &[u8] = b"\0\xff\x7f\x80-/\\#\n\r 0919e.,{}[]\"v:f";
    if bytes.is_empty() {
        return;
    }
    // Headers are short compared with the data.
    let within = if random.one_in(2) { bytes.len() } else { bytes.len().min(400) };
    let at = random.below(within);
    let piece = at..(at + 1 + random.below(12)).min(bytes.len());
    match random.below(6) {
        0 | 1 => bytes[at] ^= 1 << random.below(8),
        2 | 3 => bytes[at] = TROUBLE[random.below(TROUBLE.len())],
        4 => drop(bytes.drain(piece)),
        _ => {
            let copy = bytes[piece].to_vec();
            let to = random.below(bytes.len());
            bytes.splice(to..to, copy);
        }
    }
}
