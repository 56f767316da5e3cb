//! Objects whose cheapest model follows from a formula.

use super::{assert_near, change, drawn, only, planned, scene, srgb, steps, switch};
use crease::normals::encoding::Encoding;
use crease::num::{Radians, largest_exponent};
use crease::plan::{Axis, Minimise, PlanOptions, plan};
use crease::raster::{LoadOptions, StoredFormat};
use glam::{DQuat, DVec3};
use std::f64::consts::PI;

/// A camera on the z axis that sees 2 units from bottom to top, orthographically.
const FRONT: &str = "[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 2\n";

const CUBE: &str = "polygons = { vertices = [[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], \
     [1, -1, 1], [1, 1, 1], [-1, 1, 1]], faces = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], \
     [1, 2, 6, 5], [0, 4, 7, 3]] }\n";

/// Seen from infinity, each face of a matt cube under a sun has one colour: flat shading is exact.
#[test]
fn a_cube_under_a_sun_is_flat() {
    let text = format!(
        "[settings]\nsize = [48, 48]\n[camera]\neye = [4, 3, 5]\ntarget = [0, 0, 0]\nheight = 4\n\
         [[light.directional]]\ntowards = [1, 2, 3]\n[[object]]\n{CUBE}material = {{ specular = 0 }}\n"
    );
    let plan = planned(&text, &PlanOptions { tolerance: 0.01, ..PlanOptions::default() });
    assert_eq!(change(&plan, Axis::Shading), Some("flat"));
    assert_eq!(plan.decisions.len(), 1, "{:?}", plan.decisions);
    assert!(plan.worst.steps < 1e-4 && plan.is_cheapest);
    // 24 pairs of vertex and normal become 8 vertices: 30 operations to place each, 6 + 12 to light each of 6 faces.
    assert_eq!((plan.declared.vertices, plan.planned.vertices), (24, 8));
    assert_eq!(plan.planned.bytes, 8 * 12 + 12 * 12);
    assert_eq!(plan.planned.work, 8 * 30 + 6 * (6 + 12));
    assert!(steps(&scene(&text), &scene(&plan.text)) < 1e-4);
}

/// Light from everywhere: one colour, 255 encode(k_a I), and no normals.
#[test]
fn an_object_in_ambient_light_has_no_normals() {
    let text = format!(
        "[settings]\nsize = [32, 32]\n{FRONT}[[light.ambient]]\ncolour = 0.25\n[[object]]\n\
         surface = {{ sphere = {{ radius = 0.8 }} }}\ntessellation = {{ segments = [24, 12] }}\n\
         material = {{ colour = 1, ambient = 0.8 }}\n"
    );
    let plan = planned(&text, &PlanOptions { keep: vec![Axis::Tessellation], ..PlanOptions::default() });
    assert_eq!(change(&plan, Axis::Shading), Some("flat"));
    let (vertices, triangles) = (plan.planned.vertices, 2 * 24 * 11);
    assert_eq!(plan.planned.bytes, 12 * vertices + 12 * triangles);
    assert!(plan.worst.steps < 1e-4);
    let picture = drawn(&scene(&plan.text));
    let middle = picture.linear.as_ref().unwrap()[picture.index(16, 16).unwrap()];
    assert_near(srgb(f64::from(middle[0])), srgb(0.8 * 0.25), 1e-5);
}

/// A square between two depths under Gouraud shading, whose corners have the colours c₀ below and c₁ above. Colours depend on the row alone.
/// At the share s of the rows, perspective interpolation is at t = s/(s + (1 − s) r) with the ratio r of the depths, affine at s. Their
/// largest distance, at t = 1/(√r + 1), is (√r − 1)/(√r + 1).
fn tilted_square(degrees: f64) -> (String, f64) {
    let (sine, cosine) = libm::sincos(degrees.to_radians());
    let text = format!(
        "[settings]\nsize = [64, 128]\nshading = \"gouraud\"\ntransfer = \"direct\"\n[camera]\neye = [0, 0, 4]\n\
         target = [0, 0, 0]\nangle = 40\n[[light.directional]]\ntowards = [0, 0, 1]\n[[object]]\npolygons = {{ \
         vertices = [[-1, {0:?}, {sine:?}], [1, {0:?}, {sine:?}], [1, {cosine:?}, {1:?}], [-1, {cosine:?}, {1:?}]], \
         faces = [[0, 1, 2, 3]], normals = [[0, 0, 1], [0, 0, 1], [0, 3, 4], [0, 3, 4]] }}\n\
         material = {{ colour = 1, diffuse = 1, specular = 0 }}\n",
        -cosine, -sine
    );
    let root = ((4.0 + sine) / (4.0 - sine)).sqrt();
    (text, 255.0 * (1.0 - 0.8) * (root - 1.0) / (root + 1.0))
}

#[test]
fn a_frontal_square_is_affine_and_a_tilted_one_is_not() {
    let is_affine = |text: &str, tolerance: f64| {
        let plan = planned(text, &only(&[Axis::Interpolation], tolerance));
        (change(&plan, Axis::Interpolation) == Some("affine"), plan.worst.steps)
    };
    let (frontal, none) = tilted_square(0.0);
    assert_eq!(none, 0.0);
    let (is_frontal_affine, worst) = is_affine(&frontal, 1e-3);
    assert!(is_frontal_affine && worst < 1e-3, "{worst}");
    for degrees in [20.0, 40.0, 60.0] {
        let (text, expected) = tilted_square(degrees);
        let switch = switch(0.5 * expected, 2.0 * expected, |tolerance| !is_affine(&text, tolerance).0);
        assert_near(switch, expected, 0.01);
    }
    // At the default tolerance the tilt decides: 2 = 51 (√r − 1)/(√r + 1).
    let switch = switch(10.0, 80.0, |degrees| is_affine(&tilted_square(degrees).0, 2.0).0);
    assert_near(tilted_square(switch).1, 2.0, 0.05);
}

/// The outline of a sphere of n × m cells, seen along its axis, is a polygon of n corners at the ring next to the equator: at most
/// R (1 − ρ cos(π/n)) inside the circle, where ρ is 1 if m is even, else cos(π/(2m)).
#[test]
fn the_outline_decides_the_cells_of_a_sphere() {
    let text = "[settings]\nsize = [220, 220]\nsamples = 16\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\n\
         height = 2.2\n[[light.ambient]]\ncolour = 0.5\n[[object]]\nsurface = { sphere = { radius = 1 } }\n\
         tessellation = { segments = [64, 32] }\ntransform = [{ rotate = [90, 0, 0] }]\n\
         material = { diffuse = 0, ambient = 1, specular = 0 }\n";
    let sag = |[u, v]: [u32; 2]| {
        let ring = if v % 2 == 0 { 1.0 } else { libm::cos(0.5 * PI / f64::from(v)) };
        100.0 * (1.0 - ring * libm::cos(PI / f64::from(u)))
    };
    let mut sequence = vec![[64, 32]];
    while let Some([u, v]) =
        sequence.last().map(|[u, v]| [u * 3 / 4, v * 3 / 4]).filter(|[u, v]| *u >= 4 && *v >= 3)
    {
        sequence.push([u, v]);
    }
    for outline in [0.9, 1.8, 3.3, 6.0] {
        let plan = planned(text, &PlanOptions { outline, ..only(&[Axis::Tessellation], 2.0) });
        // The reference is a polygon, too: its outline is up to 0.12 pixels inside the circle.
        let expected = sequence.iter().rev().find(|cells| sag(**cells) <= outline).unwrap();
        let [u, v] = expected;
        assert_eq!(change(&plan, Axis::Tessellation), Some(format!("{u}×{v}").as_str()), "{outline} pixels");
        assert!((plan.outline - sag(*expected)).abs() < 0.3, "{} and {}", plan.outline, sag(*expected));
        // The bound covers other views, where the corners of rows matter as well; samples move outlines by a quarter of a pixel.
        let shift = plan.decisions[0].outline.unwrap();
        let all = 100.0 * (1.0 - libm::cos(PI / f64::from(*u)) * libm::cos(0.5 * PI / f64::from(*v)));
        assert!((shift.bound.unwrap() - all).abs() < 1e-9 && shift.measured < all + 0.25, "{shift:?}, {all}");
    }
}

/// Light on the axis of a square at height h: Phong's centre has k_d + k_s. Gouraud takes the colour of the corners for all, where the
/// cosine is h/√(h² + 2a²), and flat shading that of the centre.
#[test]
fn a_highlight_between_vertices_keeps_phong() {
    let text = format!(
        "[settings]\nsize = [65, 65]\ntransfer = \"direct\"\n{FRONT}[[light.point]]\nposition = [0, 0, 1]\n[[object]]\n\
         polygons = {{ vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], faces = [[0, 1, 2, 3]] }}\n\
         material = {{ colour = 1, ambient = 0, diffuse = 0.5, specular = 0.4, exponent = 50, reflection = \"blinn\" }}\n"
    );
    let cosine = 1.0 / 3.0_f64.sqrt();
    let half = (0.5 * (1.0 + cosine)).sqrt();
    let corner = 0.5 * cosine + 0.4 * libm::pow(half, 50.0);
    let expected = 255.0 * (0.9 - corner);
    let shading = |tolerance: f64| {
        let plan = planned(&text, &only(&[Axis::Shading], tolerance));
        change(&plan, Axis::Shading).map(str::to_owned)
    };
    assert_eq!(shading(2.0), None);
    let switch = switch(2.0, 200.0, |tolerance| shading(tolerance).is_none());
    assert_near(switch, expected, 0.03);
}

/// With the light at the camera, the mean of two unit normals at an angle α has the length cos(α/2): Gouraud shading is darker by
/// up to k (1 − cos(α/2)). The largest α is that of a cell's diagonal.
#[test]
fn a_fine_matt_ball_takes_gouraud() {
    let text = format!(
        "[settings]\nsize = [128, 128]\ntransfer = \"direct\"\n{FRONT}[[light.directional]]\ntowards = [0, 0, 1]\n[[object]]\n\
         surface = {{ sphere = {{ radius = 0.9 }} }}\ntessellation = {{ segments = [48, 24] }}\n\
         material = {{ colour = 1, diffuse = 0.9, specular = 0 }}\n"
    );
    let side = 2.0 * PI / 48.0;
    let diagonal = side * 2.0_f64.sqrt();
    let bound = 255.0 * 0.9 * (1.0 - libm::cos(0.5 * diagonal));
    let shading = |tolerance: f64| {
        let plan = planned(&text, &only(&[Axis::Shading], tolerance));
        change(&plan, Axis::Shading).map(str::to_owned)
    };
    assert_eq!(shading(bound), Some("Gouraud".to_owned()), "{bound}");
    // Sides of cells have half of that, and some pixel shows the middle of one that is lit from the front.
    assert_eq!(shading(0.5 * 255.0 * 0.9 * (1.0 - libm::cos(0.5 * side))), None);
    assert_eq!(shading(2.0), Some("Gouraud".to_owned()));
    assert_eq!(shading(60.0), Some("flat".to_owned()));
}

/// A block whose front face has 3 × 3 cells. The inner cell has the same normals with and without creases, those at the rim have not.
fn block() -> (String, String) {
    let mut vertices = String::new();
    for index in 0..16 {
        vertices += &format!("[{}, {}, 1], ", index % 4 * 2 - 3, index / 4 * 2 - 3);
    }
    let mut faces = String::new();
    for (x, y) in (0..9).map(|cell| (cell % 3, cell / 3)) {
        let first = 4 * y + x;
        faces += &format!("[{}, {}, {}, {}], ", first, first + 1, first + 5, first + 4);
    }
    for (side, [a, b, c, d]) in
        [[0, 1, 2, 3], [3, 7, 11, 15], [15, 14, 13, 12], [12, 8, 4, 0]].into_iter().enumerate()
    {
        faces += &format!("[{d}, {c}, {b}, {a}, {}, {}], ", 16 + side, 16 + (side + 1) % 4);
    }
    vertices += "[-3, -3, -1], [3, -3, -1], [3, 3, -1], [-3, 3, -1], ";
    (vertices, faces)
}

/// The block in a scene with the keys of its object.
fn scene_of_block(height: f64, keys: &str) -> String {
    format!(
        "[settings]\nsize = [32, 32]\ntransfer = \"direct\"\n[camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = {height}\n\
         [[light.directional]]\ntowards = [0, 0, 1]\n[[object]]\nmaterial = {{ colour = 1, diffuse = 1, specular = 0 }}\n{keys}\n"
    )
}

#[test]
fn creases_that_no_pixel_shows_are_dropped() {
    let options = PlanOptions { minimise: Minimise::Bytes, ..only(&[Axis::Creases], 2.0) };
    let (vertices, faces) = block();
    let keys = format!("weight = \"angle\"\npolygons = {{ vertices = [{vertices}], faces = [{faces}] }}");
    let plan = planned(&scene_of_block(1.9, &keys), &options);
    assert_eq!(change(&plan, Axis::Creases), Some("none"));
    assert!(plan.worst.steps < 1e-4);
    // 20 vertices: the corners in front have three normals, the 8 others of the rim two. Those behind have two.
    assert_eq!((plan.declared.vertices, plan.planned.vertices), (20 + 4 * 2 + 8 + 4, 20));
    // A corner of three right angles has the mean (1, 1, 1)/√3: the face becomes darker by up to 1 − 1/√3.
    let plan = planned(&scene_of_block(6.1, &keys), &options);
    assert_eq!(change(&plan, Axis::Creases), None);
    let most = 255.0 * (1.0 - 1.0 / 3.0_f64.sqrt());
    let plan = planned(&scene_of_block(6.1, &keys), &PlanOptions { tolerance: most, ..options });
    assert_eq!(change(&plan, Axis::Creases), Some("none"));
    assert!(plan.worst.steps > 0.8 * most, "{} of {most}", plan.worst.steps);
}

/// The same block as an OBJ file whose front face is a smoothing group of its own, so that the edges around it are hard at any angle.
#[test]
fn edges_of_a_smoothing_group_that_no_pixel_shows_are_dropped() {
    let (vertices, faces) = block();
    let lists = |text: &str| -> Vec<Vec<i32>> {
        let list = |list: &str| list.split(", ").map(|number| number.parse().unwrap()).collect();
        text.trim_end_matches("], ").split("], ").map(|it| list(it.trim_start_matches('['))).collect()
    };
    let line = |letter: char, numbers: Vec<i32>| {
        let words: Vec<String> = numbers.iter().map(i32::to_string).collect();
        format!("{letter} {}\n", words.join(" "))
    };
    let mut text: String = lists(&vertices).into_iter().map(|position| line('v', position)).collect();
    for (number, face) in lists(&faces).into_iter().enumerate() {
        text += if number < 9 { "s 1\n" } else { "s 2\n" };
        text += &line('f', face.iter().map(|vertex| vertex + 1).collect());
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("block.obj"), text).unwrap();
    let options = PlanOptions { minimise: Minimise::Bytes, ..only(&[Axis::Creases], 2.0) };
    let creases = |height: f64| {
        let text = scene_of_block(height, "mesh = \"block.obj\"");
        let plan = plan(&text, folder.path(), &LoadOptions::default(), &options, &|_| ()).unwrap();
        (change(&plan, Axis::Creases).map(str::to_owned), plan.declared.vertices, plan.planned.vertices)
    };
    // The twelve vertices at the rim of the front have two normals each.
    assert_eq!(creases(1.9), (Some("none".to_owned()), 20 + 12, 20));
    assert_eq!(creases(6.1), (None, 20 + 12, 20 + 12));
}

/// A square of 8 × 8 cells, each of two triangles with vertices of their own: 384 vertices. Merged they are 81, each with one normal.
#[test]
fn vertices_that_agree_are_merged() {
    let corner = |cell: usize, [x, y]: [usize; 2]| {
        let at = |place: usize, by: usize| (place + by) as f64 / 4.0 - 1.0;
        format!("[{:?}, {:?}, 0], ", at(cell % 8, x), at(cell / 8, y))
    };
    let triangles = [[0, 0], [1, 0], [1, 1], [0, 0], [1, 1], [0, 1]];
    let vertices: String = (0..64).flat_map(|cell| triangles.map(|place| corner(cell, place))).collect();
    let faces: String =
        (0..128).map(|face| format!("[{}, {}, {}], ", 3 * face, 3 * face + 1, 3 * face + 2)).collect();
    let text = format!(
        "[settings]\nsize = [32, 32]\n{FRONT}[[light.point]]\nposition = [0, 0, 4]\n[[object]]\nPOLYGONS\n"
    );
    for keys in ["", "weight = \"angle\"\n"] {
        let text = text.replace(
            "POLYGONS",
            &format!("{keys}polygons = {{ vertices = [{vertices}], faces = [{faces}] }}"),
        );
        let options = PlanOptions { minimise: Minimise::Vertices, ..only(&[Axis::Merging], 0.0) };
        let plan = planned(&text, &options);
        assert_eq!(change(&plan, Axis::Merging), Some("exact"), "{keys}");
        assert_eq!((plan.declared.vertices, plan.planned.vertices), (384, 81), "{keys}");
        assert_eq!(plan.planned.bytes, 81 * 24 + 128 * 12);
        assert!(plan.decisions[0].bound.is_some_and(|bound| bound < 0.1), "{:?}", plan.decisions);
        let (declared, merged) = (drawn(&scene(&text)), drawn(&scene(&plan.text)));
        assert_eq!((plan.worst.steps, declared.linear), (0.0, merged.linear), "{keys}");
        // There is nothing more to merge.
        assert!(planned(&plan.text, &options).decisions.is_empty());
        // With flat shading only positions count.
        let flat = text.replace("[settings]\n", "[settings]\nshading = \"flat\"\n");
        assert_eq!(planned(&flat, &options).planned.vertices, 81);
    }
}

#[test]
fn a_closed_mesh_is_lit_on_one_side_and_an_open_one_from_behind_on_both() {
    let head = "[settings]\nsize = [32, 32]\ntwo-sided = true\n[camera]\neye = [0, 0, -10]\ntarget = [0, 0, 0]\nheight = 3\n\
         [[light.directional]]\ntowards = [0, 1, -2]\n[[object]]\nmaterial = { colour = 1, specular = 0 }\n";
    let two_sided = |object: &str, tolerance: f64| {
        let plan = planned(&format!("{head}{object}"), &only(&[Axis::TwoSided], tolerance));
        let bound = plan.decisions.first().and_then(|decision| decision.bound);
        (change(&plan, Axis::TwoSided).map(str::to_owned), bound, plan.worst.steps)
    };
    assert_eq!(two_sided(CUBE, 2.0), (Some("off".to_owned()), Some(0.0), 0.0));
    let square = "polygons = { vertices = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], faces = [[0, 1, 2, 3]] }\n";
    assert_eq!(two_sided(square, 2.0).0, None);
    // Its rear face is seen, so there is no bound, and the picture becomes dark.
    let (dark, bound, worst) = two_sided(square, 255.0);
    assert!(dark.as_deref() == Some("off") && bound.is_none() && worst > 100.0, "{dark:?} {bound:?} {worst}");
}

/// A frontal square under a sun in front shows k_d + k_s everywhere: without its highlight it is darker by
/// 255 (encode(k_d + k_s) − encode(k_d)).
#[test]
fn a_faint_highlight_is_omitted() {
    let difference = |specular: f64| 255.0 * (srgb(0.5 + specular) - srgb(0.5));
    let reflection = |specular: f64| {
        let text = format!(
            "[settings]\nsize = [16, 16]\n{FRONT}[[light.directional]]\ntowards = [0, 0, 1]\n[[object]]\npolygons = {{ vertices = \
             [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], faces = [[0, 1, 2, 3]] }}\nmaterial = {{ colour = 1, \
             ambient = 0, diffuse = 0.5, specular = {specular:?}, exponent = 30, reflection = \"blinn\" }}\n"
        );
        let plan = planned(&text, &only(&[Axis::Reflection], 2.0));
        change(&plan, Axis::Reflection).map(str::to_owned)
    };
    let switch = switch(1e-3, 0.4, |specular| reflection(specular).as_deref() == Some("diffuse"));
    assert_near(difference(switch), 2.0, 0.01);
}

/// A quad whose normals point to an octant's centre, where octahedral codes are almost at their worst, lit so that the highlight is
/// steepest half way between the normal and its code. A normal off by δ changes it by M(n) δ there, so a format fails where
/// `largest_exponent` says: to 3 %, for the curvature of cosⁿ over δ and the distance of δ from the worst angle. `i8` has the octant's
/// centre exactly; the quad next to it has a normal that `i8` rounds badly.
#[test]
fn larger_exponents_need_finer_normals() {
    let tolerance = 6.0;
    let code = |format: StoredFormat, normal: DVec3| {
        let encoding = format.encoding();
        encoding.decode(encoding.encode(normal)).normalize()
    };
    let format = |worse: StoredFormat, exponent: f64| {
        let normal = DVec3::ONE.normalize();
        let stored = code(worse, normal);
        // The half vector is in the plane of both normals, at the angle of the steepest slope from their middle.
        let steepest = libm::atan(1.0 / (exponent - 1.0).sqrt());
        let axis = normal.cross(stored).normalize();
        let half = DQuat::from_axis_angle(axis, steepest) * (normal + stored).normalize();
        let around = |turn: i32| DQuat::from_axis_angle(half, 0.01 * f64::from(turn)) * normal;
        let off_by_i8 = |normal: &DVec3| (code(StoredFormat::I8, *normal) - *normal).dot(half).abs();
        let other = (0..628).map(around).max_by(|a, b| off_by_i8(a).total_cmp(&off_by_i8(b))).unwrap();
        let (a, b) = half.any_orthonormal_pair();
        let corner = |[x, y]: [f64; 2]| (a * x + b * y).to_array();
        let corners = [
            [-1.0, -1.0],
            [0.0, -1.0],
            [0.0, 1.0],
            [-1.0, 1.0],
            [0.0, -1.0],
            [1.0, -1.0],
            [1.0, 1.0],
            [0.0, 1.0],
        ];
        let (corners, eye) = (corners.map(corner), (10.0 * half).to_array());
        let normals =
            [normal, normal, normal, normal, other, other, other, other].map(|normal| normal.to_array());
        // Seen and lit along the half vector.
        let text = format!(
            "[settings]\nsize = [16, 16]\ntransfer = \"direct\"\n[camera]\neye = {eye:?}\ntarget = [0, 0, 0]\nheight = 1\n\
             [[light.directional]]\ntowards = {eye:?}\n[[object]]\npolygons = {{ vertices = {corners:?}, \
             faces = [[0, 1, 2, 3], [4, 5, 6, 7]], normals = {normals:?} }}\n\
             material = {{ colour = 1, ambient = 0, diffuse = 0, specular = 1, exponent = {exponent:?}, reflection = \"blinn\" }}\n"
        );
        let options = PlanOptions { minimise: Minimise::Bytes, ..only(&[Axis::Storage], tolerance) };
        change(&planned(&text, &options), Axis::Storage).unwrap_or("f32").to_owned()
    };
    let bytes = |name: &str| {
        let format = StoredFormat::ALL.into_iter().find(|format| format.name() == name).unwrap();
        format.encoding().bytes()
    };
    assert_eq!([12, 3, 2], [Encoding::Single.bytes(), bytes("oct12"), bytes("oct8")]);
    for stored in [StoredFormat::Oct8, StoredFormat::Oct12] {
        let worst = Radians::from(stored.encoding().worst_angle());
        let proven = largest_exponent(worst, tolerance / 255.0).unwrap() as f64;
        let is_enough = |exponent: f64| bytes(&format(stored, exponent)) <= stored.encoding().bytes();
        // It is the largest whole exponent.
        let found = switch(2.0, 100.0 * proven, is_enough);
        assert!(
            (0.97 * proven..1.03 * (proven + 1.0)).contains(&found),
            "{stored:?}: {found}, proven {proven}"
        );
    }
    let worst = |stored: StoredFormat| Radians::from(stored.encoding().worst_angle());
    let proven = |stored| largest_exponent(worst(stored), tolerance / 255.0).unwrap() as f64;
    // The formats come one after another.
    let between = (proven(StoredFormat::Oct8) * proven(StoredFormat::Oct12)).sqrt();
    assert_eq!(format(StoredFormat::Oct8, 0.9 * proven(StoredFormat::Oct8)), "oct8");
    assert_eq!(format(StoredFormat::Oct8, between), "oct12");
    assert_eq!(format(StoredFormat::Oct12, 1.1 * proven(StoredFormat::Oct12)), "i16");
}

/// A scene that declares cheap models is planned from the accurate ones: a plan from the declared scene leaves flat shading, one from the
/// accurate scene goes back to Phong shading.
#[test]
fn the_most_accurate_scene_is_a_reference_as_well() {
    let declared = "# Rough.\n[settings]\nsize = [32, 32]\nshading = \"flat\"\nprecision = \"fast\"\n\
        [camera]\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nheight = 3\n[[light.directional]]\ntowards = [1, 1, 1]\n\
        [[object]]\nsurface = { sphere = { radius = 1 } }\ntessellation = { segments = [12, 8] }\nnormal-format = \"i8\"\n";
    let accurate = crease::plan::most_accurate(declared).unwrap();
    assert!(accurate.starts_with("# Rough.\n") && !accurate.contains("i8") && !accurate.contains("fast"));
    // Analytic surfaces have better normals than any weight computes.
    assert!(!accurate.contains("weight"));
    let mesh = declared.replace(
        "surface = { sphere = { radius = 1 } }\ntessellation = { segments = [12, 8] }",
        "mesh = \"gear.obj\"",
    );
    assert!(crease::plan::most_accurate(&mesh).unwrap().contains("weight = \"best\""));
    let shading = |text: &str| {
        let plan = planned(text, &only(&[Axis::Shading], 2.0));
        let file = scene(&plan.text);
        let own = file.objects[0].settings.shading;
        own.unwrap_or(file.settings.shading)
    };
    assert_eq!(shading(declared), crease::raster::Shading::Flat);
    assert_eq!(shading(&accurate), crease::raster::Shading::Phong);
}
