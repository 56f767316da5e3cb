//! Inputs and numbers at the ends of their ranges: a picture or a clear error, never anything else.

use super::{BEFORE, pixels_unlike, render, square, with};
use crate::cli::{code, folder, path, text};

/// A picture that can be read, or the error of a bad input.
fn picture_or_error(args: &[String]) -> Result<image::RgbImage, String> {
    let output = render(with(args, &["-o", "-", "-q"]));
    match code(&output) {
        // The message has the option and its value.
        2 => Err(text(&output.stderr).to_owned()),
        0 => Ok(image::load_from_memory(&output.stdout).unwrap().into_rgb8()),
        3 => {
            let message = text(&output.stderr).to_owned();
            assert!(
                message.starts_with("error: ") && !message.contains("fault of crease"),
                "{args:?}: {message}"
            );
            assert!(output.stdout.is_empty());
            Err(message)
        }
        other => panic!("{args:?}: exit code {other}, {}", text(&output.stderr)),
    }
}

/// The same tetrahedron at any size and place that positions in double precision resolve.
#[test]
fn meshes_of_any_size_and_place_are_framed() {
    let draw = |scale: f64, offset: f64| {
        let half = 0.5 * scale;
        // In halves, because the width of the largest mesh exceeds every number.
        let at = |x: f64| (offset + x * half) + x * half;
        let corner = |x: f64, y: f64, z: f64| format!("v {:e} {:e} {:e}\n", at(x), at(y), at(z));
        let mesh = [corner(0., 0., 0.), corner(1., 0., 0.), corner(0., 1., 0.), corner(0., 0., 1.)].concat()
            + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
        let folder = folder(&[("a.obj", &mesh)]);
        let file = path(folder.path().join("a.obj"));
        let args = with(&[file.as_str()], &["--size", "64x48", "--background", "#0000ff"]);
        let picture = picture_or_error(&args).unwrap_or_else(|error| panic!("{scale:e} {offset:e}: {error}"));
        pixels_unlike(&picture, [0, 0, 255])
    };
    let expected = draw(1.0, 0.0);
    assert!((600..2000).contains(&expected), "{expected} of 3072 pixels");
    let sizes =
        [1e-300, 1e-250, 1e-165, 1e-154, 1e-30, 1e-9, 1e9, 1e30, 1e100, 1e154, 1e165, 1e250, 1e300, 1e307];
    let places = [1e7, 1e9, 1e12, 3e12, 1e13, 1e14, 3e14, 1e15];
    let both =
        [(1e-30, 1e-28), (1e30, -1e31), (1e-3, 1e7), (1e-200, 1e-190), (1e290, 1e300), (f64::MAX, 0.0)];
    let cases = sizes.map(|size| (size, 0.0)).into_iter().chain(places.map(|place| (1.0, place))).chain(both);
    for (scale, offset) in cases {
        let seen = draw(scale, offset);
        // Roundings of rims.
        assert!(seen.abs_diff(expected) <= 4, "{scale:e} {offset:e}: {seen} pixels, not {expected}");
    }
}

/// No area, no extent, or everything in one place.
#[test]
fn degenerate_meshes_are_drawn_or_refused() {
    let meshes = [
        "v 1 1 1\nf 1 1 1\n",
        "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n",
        "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n",
        "v 0 0 0\nv 5e-324 0 0\nv 0 5e-324 0\nf 1 2 3\n",
        "v 1.7e308 0 0\nv -1.7e308 0 0\nv 0 1.7e308 0\nf 1 2 3\n",
        "v 0 0 0\nv 1e-9 0 0\nv 0 1e9 0\nf 1 2 3\n",
        "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 1e999 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 1 2 3 4\n",
    ];
    for mesh in meshes {
        for option in
            [&["--shading", "phong"][..], &["--show", "deviation"], &["--overlay", "wire,vertex-normals"]]
        {
            let folder = folder(&[("a.obj", mesh)]);
            let args = with(&[path(folder.path().join("a.obj"))], &["--size", "32x24"]);
            let _ = picture_or_error(&with(&args, option));
        }
    }
}

/// A colour that is not finite is an error, and so are cameras and lights that make no sense.
#[test]
fn numbers_at_the_ends_of_their_ranges() {
    let (_folder, square) = square();
    let [camera, place, size, sides] = BEFORE;
    // An option may be given once.
    let but = |option: &str| match option {
        "--camera" => with(&[square.as_str()], &[size, sides]),
        "--size" => with(&[square.as_str()], &[camera, place]),
        _ => with(&[square.as_str()], &BEFORE),
    };
    let refused: &[&[&str]] = &[
        &["--light", "point position=0,0,1 colour=1e300"],
        &["--light", "directional towards=0,0,0"],
        &["--camera", "eye=1e308,0,0 target=-1e308,0,0 up=1,0,0"],
        &["--camera", "eye=0,0,0 target=0,0,1e-320 up=0,0,1"],
        &["--background", "1e300"],
        &["--material", "kd=1e300"],
        &["--light", "point position=0,0,1e300"],
    ];
    for more in refused {
        assert!(picture_or_error(&with(&but(more[0]), more)).is_err(), "{more:?} makes a picture");
    }
    let drawn: &[&[&str]] = &[
        &["--exponent", "1e9"],
        &["--exponent", "0"],
        &["--camera", "eye=0,0,1e30"],
        &["--camera", "near=1e-300"],
        &["--camera", "angle=179.9999"],
        &["--camera", "angle=1e-5"],
        &["--rotate", "1e15,-1e15,0.5"],
        &["--light", "point position=0,0,0"],
        &["--light", "point position=0,0,1e-200 attenuation=inverse-square colour=1e30"],
        &["--light", "spot position=0,0,3 axis=0,0,-1 cut-off=0.001 exponent=1e6"],
        &["--literal", "--light", "directional towards=0,0,-1"],
        &["--size", "1x1"],
        &["--size", "16384x1"],
        &["--size", "1x16384"],
    ];
    for more in drawn {
        if let Err(message) = picture_or_error(&with(&but(more[0]), more)) {
            panic!("{more:?}: {message}");
        }
    }
}

/// The eye in the middle of the mesh, and behind it.
#[test]
fn faces_around_and_behind_the_eye_are_clipped() {
    let gear = super::gear();
    for camera in [
        "eye=0,0,0 target=0,0,-1 angle=100",
        "eye=0,0.3,0.5 target=0,0.2,-1 angle=150",
        "eye=0,0,9 target=0,0,10",
    ] {
        picture_or_error(&with(&gear, &["--camera", camera, "--shading", "gouraud"])).unwrap();
    }
    let inside =
        super::report(&with(&gear, &["--camera", "eye=0,0.3,0.5 target=0,0.2,-1 angle=150 near=0.01"]));
    assert!(inside["drawings"][0]["triangles_clipped"].as_u64().unwrap() > 0, "{inside}");
}

/// The most memory that a run of the program takes, in bytes; `None` where that cannot be read.
fn peak(args: &[&str]) -> Option<u64> {
    if !std::path::Path::new("/proc/self/status").exists() {
        println!("skipped: peak memory is read from /proc");
        return None;
    }
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_crease")).args(args).spawn().unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    // The kernel's mark only rises, so it is enough to read it often while the program runs.
    while child.try_wait().unwrap().is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let mark = text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB"));
        peak = mark.and_then(|mark| mark.parse::<u64>().ok()).unwrap_or(peak).max(peak);
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert!(child.wait().unwrap().success(), "{args:?}");
    Some(peak << 10)
}

const MIB: u64 = 1 << 20;

/// A large picture takes at most 8 bytes a pixel and 64 MiB more than a small one.
#[test]
fn memory_grows_by_few_bytes_a_pixel() {
    let (folder, square) = square();
    let out = path(folder.path().join("out.png"));
    let drawing = |size: &str| peak(&["render", &square, "--size", size, "-q", "-o", &out]);
    let (Some(small), Some(large)) = (drawing("64x64"), drawing("6000x6000")) else { return };
    let grown = large.saturating_sub(small);
    let pixels = 36_000_000;
    assert!(grown < 8 * pixels + 64 * MIB, "{} MiB more", grown / MIB);
    // The mark was read: the colours alone are 3 bytes a pixel.
    assert!(grown > 3 * pixels, "{} MiB more", grown / MIB);
}

/// The memory that overlays may take in addition to that of `crease normals`, without the 64 MiB of a picture.
#[test]
fn overlays_keep_to_the_memory_of_a_drawing() {
    let folder = folder(&[]);
    let [torus, out] = ["torus.ply", "out.png"].map(|name| path(folder.path().join(name)));
    if peak(&["surface", "torus", "--segments", "300x200", "-q", "-o", &torus]).is_none() {
        return;
    }
    // It ends soon after its peak, which a single run may miss.
    let normals = (0..5).filter_map(|_| peak(&["normals", &torus, "-q", "--dry-run"])).max().unwrap();
    let all = "wire,creases,vertex-normals,face-normals";
    let drawing = peak(&["render", &torus, "--size", "320x240", "--overlay", all, "-q", "-o", &out]).unwrap();
    let (pixels, vertices, triangles) = (320 * 240, 60_000, 120_000);
    let allowed = normals + 8 * pixels + 64 * vertices + 16 * triangles;
    assert!(drawing <= allowed, "{} MiB, not {}", drawing / MIB, allowed / MIB);
}

/// Of 72 MB of frames less than half are kept until their palette is known, and the others are drawn again.
#[test]
fn an_animation_takes_no_more_memory_the_longer_it_is() {
    let (folder, square) = square();
    let out = path(folder.path().join("out.gif"));
    let turn = |frames: &str| {
        let options = ["--size", "1000x1000", "--samples", "1", "--turntable", frames];
        peak(&[&["render", &square, "-q", "-o", &out][..], &options].concat())
    };
    let (Some(short), Some(long)) = (turn("12"), turn("72")) else { return };
    let grown = long.saturating_sub(short);
    // 32 MiB are kept, which the short one fills as well, so that 4 MiB are measured; all frames would be 180 MB more.
    assert!(grown <= 34 * MIB, "{} MiB more", grown / MIB);
}
