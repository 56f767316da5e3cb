//! The files of `data/`: they are what the generator makes, and they are geometrically right.

mod brushed;
mod shapes;
mod stage;
mod write;

use std::fs;
use std::path::PathBuf;

fn data() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("data")
}

/// With `CREASE_BLESS=1` the files are written again; the test fails even so, so that a blessing run never
/// passes for a check.
#[test]
fn the_committed_files_are_those_of_the_generator() {
    let bless = std::env::var_os("CREASE_BLESS").is_some_and(|value| value == "1");
    let mut different = Vec::new();
    for (name, made) in write::files() {
        let path = data().join(name);
        if fs::read(&path).ok().as_ref() != Some(&made) {
            different.push(name);
            if bless {
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(&path, made).unwrap();
            }
        }
    }
    assert!(
        different.is_empty(),
        "not what the generator makes: {different:?}; CREASE_BLESS=1 rewrites them"
    );
    assert!(!bless, "a blessing run does not pass; run again without CREASE_BLESS");
}

#[test]
fn no_other_file_is_there_and_all_are_small() {
    // The numbers of the teapot are published, and scenes are authored.
    let made = write::files();
    // The program makes these; the test of `crease artefact` checks them and their sizes.
    let is_picture = |name: &str| name.starts_with("gallery/") && name.ends_with(".png");
    let is_known = |name: &str| {
        made.iter().any(|&(known, _)| known == name)
            || ["README.md", "teapot.txt"].contains(&name)
            || name.starts_with("scenes/") && name.ends_with(".toml")
            || is_picture(name)
            // Other programs make these; `compressed.rs` checks them.
            || name.starts_with("bracket-draco") || name.starts_with("bracket-meshopt") || name == "pyramids.3mf"
    };
    let readme = fs::read_to_string(data().join("README.md")).unwrap();
    let mut total = 0;
    for folder in ["", "gallery/", "scenes/", "scenes/lectures/"] {
        for entry in fs::read_dir(data().join(folder)).unwrap() {
            let entry = entry.unwrap();
            let name = format!("{folder}{}", entry.file_name().into_string().unwrap());
            if entry.file_type().unwrap().is_dir() {
                assert!(
                    ["gallery", "scenes", "scenes/lectures"].contains(&name.as_str()),
                    "{name} is not checked"
                );
                continue;
            }
            assert!(is_known(&name), "{name} has no generator");
            let listed = name == "README.md" || readme.contains(&format!("`{name}`"));
            assert!(listed, "{name} is not in the README");
            if !is_picture(&name) {
                total += entry.metadata().unwrap().len();
            }
        }
    }
    assert!(total < 400_000, "{total} bytes");
}

#[test]
fn closed_shapes_face_outward() {
    for (name, shape) in [
        ("gear", shapes::gear()),
        ("bracket", shapes::bracket()),
        ("polygons", shapes::polygons()),
        ("slivers", shapes::slivers()),
        ("part", shapes::part()),
        ("wedge", shapes::wedge()),
        ("cube", stage::cube()),
    ] {
        assert!(shape.is_closed(), "{name} is not closed");
        assert!(shape.signed_volume() > 0.0, "{name} has the volume {}", shape.signed_volume());
    }
    // The sphere's seam is closed by position only, so its edges do not show that it is closed, but its volume does. A sphere of
    // this tessellation has 0.96 of the ball's 4π/3.
    let (sphere, _) = shapes::seamed_sphere();
    let ball = 4.0 / 3.0 * std::f64::consts::PI;
    assert!((0.95..1.0).contains(&(sphere.signed_volume() / ball)), "{}", sphere.signed_volume() / ball);
}

#[test]
fn the_checks_can_fail() {
    let mut shape = shapes::wedge();
    shape.faces[0].corners.reverse();
    assert!(!shape.is_closed());
    shape.faces.pop();
    assert!(!shape.is_closed());
    let mut shape = shapes::part();
    for face in &mut shape.faces {
        face.corners.reverse();
    }
    assert!(shape.is_closed() && shape.signed_volume() < 0.0);
}

#[test]
fn open_sheets_face_up() {
    let patch = shapes::patch(2, 1.0, |_, _| 0.0);
    for [a, b, c] in patch.triangles() {
        let [a, b, c] = [a, b, c].map(|v| patch.positions[v as usize]);
        let up = (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]);
        assert!(up > 0.0);
    }
}
