//! Backgrounds, and the legends of `--show`.

use super::{bytes, gear, picture, with};
use crate::cli::{code, crease, path, text};

fn decoded(args: &[String]) -> image::RgbaImage {
    image::load_from_memory(&bytes(args)).unwrap().to_rgba8()
}

/// A mesh is drawn on light grey, a scene file on its own background, which is black by default.
#[test]
fn meshes_are_drawn_on_light_grey_and_scenes_on_their_own() {
    assert_eq!(picture(&gear()).get_pixel(0, 0).0, [0xda; 3]);
    let black = picture(&with(&gear(), &["--background", "black"]));
    assert_eq!(black.get_pixel(0, 0).0, [0; 3]);
    let scene = |background: &str| {
        let scene =
            format!("[settings]\nsize = [40, 40]\n{background}\n[[object]]\nsurface.sphere.radius = 1\n");
        let folder = crate::cli::folder(&[("a.toml", &scene)]);
        picture(&[path(folder.path().join("a.toml"))]).get_pixel(0, 0).0
    };
    assert_eq!((scene(""), scene("background = \"#102030\"")), ([0; 3], [0x10, 0x20, 0x30]));
}

/// Nothing is behind the gear, its inside is opaque and has the colours that it has on any background, and edges are between.
#[test]
fn a_transparent_background_keeps_the_colours() {
    let cut = decoded(&with(&gear(), &["--background", "transparent"]));
    let on_white = decoded(&with(&gear(), &["--background", "white"]));
    let (mut opaque, mut between) = (0, 0);
    for (found, shown) in cut.pixels().zip(on_white.pixels()) {
        match found.0[3] {
            0 => assert_eq!(shown.0[..3], [255; 3]),
            255 => {
                opaque += 1;
                assert_eq!(found, shown);
            }
            _ => between += 1,
        }
    }
    assert_eq!(cut.get_pixel(0, 0).0[3], 0);
    assert!(opaque > 1000 && between > 50, "{opaque} opaque pixels, {between} at edges");
    for (more, wanted) in
        [(&["--to", "jpeg"][..], "PNG or WebP"), (&["--compare", "flat,phong"], "--compare")]
    {
        let args = with(&with(&gear(), &["--background", "transparent", "-o", "-"]), more);
        let output = crease().arg("render").args(&args).output().unwrap();
        assert_eq!(code(&output), 2, "{more:?}");
        assert!(text(&output.stderr).contains(wanted), "{}", text(&output.stderr));
    }
    let webp = decoded(&with(&gear(), &["--background", "transparent", "--to", "webp"]));
    assert_eq!(webp, cut);
}

#[test]
fn a_gradient_is_lighter_at_the_top() {
    let shown = picture(&with(&gear(), &["--background", "gradient"]));
    let [top, bottom] = [0, shown.height() - 1].map(|y| shown.get_pixel(0, y).0[0]);
    assert!(top > 230 && bottom > 150 && top > bottom + 40, "{top} {bottom}");
}

/// A legend is below the picture, which is the same without it.
#[test]
fn what_is_shown_has_a_legend_below() {
    for show in ["normals", "facing", "depth", "face-id", "deviation", "deviation=5"] {
        let args = with(&gear(), &["--show", show]);
        let (plain, legend) = (picture(&with(&args, &["--no-legend"])), picture(&args));
        let [width, height] = [plain.width(), plain.height()];
        assert_eq!((width, height), (96, 72), "{show}");
        assert!(legend.width() == width && legend.height() > height + 12, "{show}");
        assert!(plain.enumerate_pixels().all(|(x, y, pixel)| legend.get_pixel(x, y) == pixel), "{show}");
        let dark = legend.enumerate_pixels().filter(|(_, y, pixel)| *y >= height && pixel.0[0] < 100).count();
        assert!(dark > 20, "{show}: the legend has text");
    }
    let output = crease().arg("render").args(with(&gear(), &["--no-legend", "-o", "-"])).output().unwrap();
    assert_eq!(code(&output), 2, "{}", text(&output.stderr));
}

/// Deviations on the gear are up to some 40°: at the range of 15° much is white, and at the fitted range nearly nothing.
#[test]
fn fitted_deviations_do_not_saturate() {
    let white = |show: &str| {
        let shown = picture(&with(
            &gear(),
            &["--show", show, "--no-legend", "--background", "black", "--samples", "1"],
        ));
        shown.pixels().filter(|pixel| pixel.0 == [255; 3]).count()
    };
    let (fixed, fitted) = (white("deviation=15"), white("deviation"));
    assert!(fixed > 100 && fitted * 10 < fixed, "{fixed} white pixels at 15°, {fitted} at the fitted range");
}
