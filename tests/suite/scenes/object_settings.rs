//! Settings of single objects: each object of a mixed picture is drawn as it is in a picture of one kind.

use super::from_text;
use crease::raster::{Image, LoadOptions, Pixels, SceneFile, render};
use std::path::Path;

/// A coarse sphere on the left and one on the right, with keys of their own, below settings of the picture.
fn spheres(settings: &str, left: &str, right: &str) -> Image {
    let sphere = |x: f64, keys: &str| {
        format!(
            "[[object]]\nsurface = {{ sphere = {{ radius = 1 }} }}\ntessellation = {{ segments = [9, 6] }}\n\
             transform = [{{ translate = [{x}, 0, 0] }}]\n{keys}\n"
        )
    };
    let head = format!(
        "[settings]\nsize = [96, 48]\n{settings}\n[camera]\neye = [0, 1, 4]\ntarget = [0, 0, 0]\nangle = 50\n\
         [[light.directional]]\ntowards = [1, 1, 2]\n"
    );
    drawn(&from_text(&(head + &sphere(-1.2, left) + &sphere(1.2, right))))
}

fn drawn(file: &SceneFile) -> Image {
    render(&file.scene(), &file.settings).unwrap()
}

/// The left and the right half of a picture.
fn halves(image: &Image) -> [Vec<[u8; 3]>; 2] {
    let Pixels::Eight(pixels) = &image.pixels else { panic!("8 bits") };
    let half = |from: usize| pixels.chunks(96).flat_map(|row| row[from..from + 48].to_vec()).collect();
    [half(0), half(48)]
}

#[test]
fn objects_are_drawn_by_their_own_settings() {
    let keys = [
        ("shading = \"flat\"", "shading = \"gouraud\""),
        ("shading = \"phong\"", "shading = \"exact\""),
        ("interpolation = \"affine\"", "interpolation = \"perspective\""),
        ("weight = \"area\"", "weight = \"max\""),
        ("crease = 0", "crease = \"off\""),
        ("normal-format = \"oct8\"", "normal-format = \"i8\""),
    ];
    for (left, right) in keys {
        let mixed = halves(&spheres("", left, right));
        assert_eq!(mixed[0], halves(&spheres(left, "", ""))[0], "{left}");
        assert_eq!(mixed[1], halves(&spheres(right, "", ""))[1], "{right}");
        assert_ne!(halves(&spheres(left, "", ""))[1], mixed[1], "{right} differs from {left}");
        // What an object states takes precedence over what the picture does.
        assert_eq!(mixed, halves(&spheres(left, left, right)));
    }
}

/// One side of an open surface is lit or not, by its own key.
#[test]
fn objects_are_lit_on_both_sides_by_their_own_setting() {
    let draw = |settings: &str, keys: &str| {
        let text = format!(
            "[settings]\nsize = [8, 8]\n{settings}\n[camera]\neye = [0, 0, -4]\ntarget = [0, 0, 0]\n\
             [[light.directional]]\ntowards = [0, 0, -1]\n\
             [[object]]\n{keys}\npolygons = {{ vertices = [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], faces = [[0, 1, 2]] }}\n"
        );
        halves_sum(&drawn(&from_text(&text)))
    };
    assert_eq!(draw("", ""), 0);
    assert!(draw("", "two-sided = true") > 0);
    assert_eq!(draw("two-sided = true", "two-sided = false"), 0);
}

fn halves_sum(image: &Image) -> u64 {
    let Pixels::Eight(pixels) = &image.pixels else { panic!("8 bits") };
    pixels.iter().flatten().map(|&code| u64::from(code)).sum()
}

/// Groups mark edges hard whatever the angle; `crease = "none"` ignores them too.
#[test]
fn one_normal_per_vertex_ignores_smoothing_groups() {
    let splits = |crease: &str| {
        let text = format!("[[object]]\nmesh = \"data/gear.obj\"\ncrease = {crease}\n");
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let file = SceneFile::from_toml(&text, root, &LoadOptions::default()).unwrap();
        let mesh = &file.meshes[0];
        mesh.normals.normals.values.len() - mesh.mesh.vertex_count()
    };
    assert!(splits("40") > splits("\"off\"") && splits("\"off\"") > 0);
    assert_eq!(splits("\"none\""), 0);
}

#[test]
fn marked_objects_and_lights_are_listed() {
    let scene = from_text(
        "[[light.ambient]]\ncolour = 0.2\n[[light.point]]\nplan = \"keep\"\nposition = [0, 9, 0]\n\
         [[object]]\nplan = \"keep\"\nsurface = { sphere = { radius = 1 } }\n[[object]]\nsurface = { sphere = { radius = 1 } }\n",
    );
    assert_eq!(scene.kept_lights, [1]);
    assert_eq!(scene.objects.iter().map(|object| object.is_kept).collect::<Vec<_>>(), [true, false]);
}
