//! A scene changed by options.

use super::args::RenderArgs;
use super::fields::TypedMaterial;
use super::request::{Request, Subject};
use super::values::{Background, FileKind, GRADIENT, LIGHT_GREY, ReflectionChoice, Shown, Variant};
use crate::cli::common::failure::Failure;
use crease::mesh::{AxisConversion, UpAxis};
use crease::num::{Degrees, LinearRgb, Srgb8, Transfer, UnitVec3};
use crease::raster::{Bits, Camera, RenderError, Samples, SceneFile, Show, default_lights, rotation};
use crease::shade::{Guards, Light, Place, Reflection, ShadeError};
use glam::{DMat3, DMat4, DVec3};

/// Changes a scene as asked.
///
/// # Errors
/// Options that need something that the scene lacks, or that do not suit it.
pub fn change(request: &Request, file: &mut SceneFile) -> Result<(), Failure> {
    let transfer = file.settings.transfer;
    change_settings(request, file);
    request.check_amount(file.settings.size).map_err(Failure::usage)?;
    request.check_probe(&file.settings).map_err(Failure::usage)?;
    change_materials(request.args, file).map_err(Failure::input)?;
    let scene = &request.args.scene;
    file.background = match scene.background {
        Some(Background::Colour(colour)) => colour,
        // Drawn before black and before white.
        Some(Background::Transparent | Background::Gradient) => LinearRgb::BLACK,
        None if request.has_settings() => file.background,
        None => LIGHT_GREY,
    };
    let is_typed = request.args.colour.transfer.is_some();
    if !is_typed && (transfer, file.settings.transfer) == (Transfer::Srgb, Transfer::Direct) {
        // The same codes as behind the lit picture.
        file.background = file.background.to_array().map(|light| Transfer::Srgb.encode(light)).into();
    }
    let behind = match scene.background {
        Some(Background::Transparent) => LinearRgb::WHITE,
        Some(Background::Gradient) => GRADIENT[1],
        _ => file.background,
    };
    let reported = |wire| contrast(wire, behind, file.settings.transfer);
    if !request.has_settings() && reported(LinearRgb::BLACK) > reported(LinearRgb::WHITE) {
        file.settings.wire.colour = LinearRgb::BLACK;
    }
    if let Some(degrees) = scene.rotate {
        let pivot = pivot(file);
        turn(file, rotation(degrees), pivot);
    }
    // From here on the camera is fixed, even if objects rotate.
    let framed = if file.camera.is_none() { file.scene().bounds() } else { None };
    let camera = automatic_camera(file, &request.subject, scene.up)?;
    let camera = scene.camera.map_or(camera, |change| change.apply(&camera, framed));
    if scene.camera.is_some() {
        camera.check().map_err(|error| Failure::usage(format!("--camera: {error}")))?;
    }
    file.camera = Some(camera);
    if !scene.light.is_empty() || scene.ambient.is_some() {
        let before = file.lights.take().unwrap_or_else(|| default_lights(&camera).to_vec());
        file.lights = Some(lights(&before, &scene.light, scene.ambient));
    }
    Ok(())
}

/// The contrast ratio (Y₁ + 0.05)/(Y₂ + 0.05) of the lighter to the darker of two colours, as WCAG 2.1 defines it: 1 of the
/// same luminance, 21 of black and white. Luminances are those that a screen shows for the codes, which it takes for sRGB.
fn contrast(a: LinearRgb, b: LinearRgb, transfer: Transfer) -> f64 {
    let luminance = |colour| LinearRgb::from(code(colour, transfer)).luminance() + 0.05;
    let (a, b) = (luminance(a), luminance(b));
    a.max(b) / a.min(b)
}

fn code(colour: LinearRgb, transfer: Transfer) -> Srgb8 {
    Srgb8(colour.to_array().map(|light| transfer.to_u8(light)))
}

fn change_settings(request: &Request, file: &mut SceneFile) {
    let (output, shading, colour) = (&request.args.output, &request.args.shading, &request.args.colour);
    let set = &mut file.settings;
    if !request.has_settings() {
        set.samples = Samples::Four;
    }
    set.size = output.size.unwrap_or(set.size);
    set.samples = output.samples.unwrap_or(set.samples);
    set.bits = output.bits.unwrap_or(set.bits);
    if request.file == FileKind::Gif {
        set.bits = Bits::Eight;
    }
    set.shading = shading.shading.unwrap_or(set.shading);
    set.interpolation = shading.interpolation.unwrap_or(set.interpolation);
    set.flat_sample = shading.flat_sample.unwrap_or(set.flat_sample);
    set.wire.hide = request.hides_lines(set.wire.hide);
    set.cull = shading.cull.unwrap_or(set.cull);
    set.two_sided |= shading.two_sided;
    for object in &mut file.objects {
        let typed = |is_typed: bool, compares: fn(&Variant) -> bool| {
            is_typed || request.args.output.compare.iter().any(compares)
        };
        if typed(shading.shading.is_some(), |it| matches!(it, Variant::Shading(_))) {
            object.settings.shading = None;
        }
        if typed(shading.interpolation.is_some(), |it| matches!(it, Variant::Interpolation(_))) {
            object.settings.interpolation = None;
        }
        if shading.two_sided {
            object.settings.two_sided = None;
        }
    }
    if let Some(shown) = shading.show {
        let show = match shown {
            Shown::Fixed(show) => show,
            // `fit_deviation` finds the range.
            Shown::FittedDeviation => Show::Deviation(Degrees(180.0)),
        };
        set.show = show;
        // Codes are then proportional to what is shown, as in any normal map.
        if matches!(show, Show::Normals | Show::Depth) {
            set.transfer = Transfer::Direct;
        }
    }
    set.terminator = colour.terminator.unwrap_or(set.terminator);
    set.tone = colour.tone.unwrap_or(set.tone);
    set.transfer = colour.transfer.unwrap_or(set.transfer);
    if colour.literal {
        set.guards = Guards::literal();
    }
    for switch in &colour.guard {
        let known = set.guards.set(&switch.name, switch.on);
        debug_assert!(known, "the parser knows the names");
    }
}

fn change_materials(args: &RenderArgs, file: &mut SceneFile) -> Result<(), String> {
    let shading = &args.shading;
    let wants_given = shading.reflection == Some(ReflectionChoice::Given);
    let lacks = |object| file.mesh_of(object).is_none_or(|mesh| mesh.colours.is_none());
    if let Some(object) = (0..file.objects.len()).find(|&object| wants_given && lacks(object)) {
        let lack = "no vertex colours for --reflection given\nhelp: choose another --reflection, or add colours to the file";
        return Err(format!("object {object}: {lack}"));
    }
    for object in &mut file.objects {
        if let Some(TypedMaterial { material, optics }) = args.scene.material {
            (object.material, object.optics) = (material, optics);
        }
        object.material.exponent = shading.exponent.unwrap_or(object.material.exponent);
        match shading.reflection {
            Some(ReflectionChoice::Phong) => object.material.reflection = Reflection::Phong,
            Some(ReflectionChoice::Blinn) => object.material.reflection = Reflection::Blinn,
            Some(ReflectionChoice::Given) | None => {}
        }
        if shading.reflection.is_some() {
            object.given = wants_given;
        }
    }
    Ok(())
}

fn lights(before: &[Light], new: &[Light], ambient: Option<LinearRgb>) -> Vec<Light> {
    let is_ambient = |light: &&Light| matches!(light, Light::Ambient { .. });
    let old_ambient = before.iter().filter(|light| is_ambient(light) && ambient.is_none());
    let old = before.iter().filter(|light| !is_ambient(light) && new.is_empty());
    let ambient = ambient.map(|colour| Light::Ambient { colour });
    ambient.into_iter().chain(old_ambient.copied()).chain(old.copied()).chain(new.iter().copied()).collect()
}

/// The option that caused an error of drawing, with what is wrong with it.
pub fn blame(args: &RenderArgs, error: &RenderError, lights: usize) -> Option<String> {
    let (scene, shading) = (&args.scene, &args.shading);
    let typed = |is_typed: bool, option: &str, what: &dyn std::fmt::Display| {
        is_typed.then(|| format!("{option}: {what}"))
    };
    let is_typed = |light: usize| !scene.light.is_empty() && light + scene.light.len() >= lights;
    match error {
        RenderError::Camera(error) => typed(scene.camera.is_some(), "--camera", error),
        RenderError::Number { what: "the background", found, expected } => {
            let wrong = format!("the colour is {found}; it must be {expected}");
            typed(scene.background.is_some(), "--background", &wrong)
        }
        RenderError::Shade { error: ShadeError { place, field, found, expected }, .. } => {
            let wrong = format!("{field} is {found}; it must be {expected}");
            match place {
                // Lights that are typed stand last, ambient light first.
                Place::Light(0) if scene.ambient.is_some() => typed(true, "--ambient", &wrong),
                Place::Light(number) => typed(is_typed(*number), "--light", &wrong),
                Place::Material if *field == "exponent" && shading.exponent.is_some() => {
                    typed(true, "--exponent", &wrong)
                }
                Place::Material => typed(scene.material.is_some(), "--material", &wrong),
                Place::Settings => typed(scene.camera.is_some(), "--camera", &wrong),
            }
        }
        // Each for itself is in range, but not what comes of them together.
        RenderError::NotFinite { error, .. } => {
            let light = match error.light {
                Some(number) => (is_typed(number), "--light"),
                None => (scene.ambient.is_some(), "--ambient"),
            };
            let options = [(scene.material.is_some(), "--material"), light];
            let typed: Vec<&str> =
                options.iter().filter(|(is_typed, _)| *is_typed).map(|&(_, option)| option).collect();
            (!typed.is_empty()).then(|| format!("{}: {error}", typed.join(" and ")))
        }
        _ => None,
    }
}

/// The rotation by an angle about a vector, counter-clockwise as seen from its tip.
pub fn about(axis: DVec3, Degrees(degrees): Degrees) -> DMat4 {
    let turned = rotation(DVec3::Y * degrees);
    match UnitVec3::new(axis).map(UnitVec3::get) {
        None | Some(DVec3::Y) => turned,
        Some(axis) => {
            // Into a space where the axis is y, and back.
            let z = axis.any_orthonormal_vector();
            let from_upright = DMat3::from_cols(axis.cross(z), axis, z);
            DMat4::from_mat3(from_upright) * turned * DMat4::from_mat3(from_upright.transpose())
        }
    }
}

/// The point that objects are rotated about: the middle of the box around them, or the target of the camera if there is none.
pub fn pivot(file: &SceneFile) -> DVec3 {
    let scene = file.scene();
    scene.bounds().map_or(scene.camera.target, |(low, high)| low * 0.5 + high * 0.5)
}

/// The file's camera, or one that shows the scene with an axis upwards.
///
/// # Errors
/// If the file has a camera, which determines what is up, and an axis is given.
fn automatic_camera(file: &mut SceneFile, subject: &Subject, up: Option<UpAxis>) -> Result<Camera, Failure> {
    let Some(up) = up else { return Ok(upright_camera(file, subject)) };
    if file.camera.is_some() {
        return Err(Failure::usage(
            "--up is for files without a camera, but this one has a camera\nhelp: --camera up=X,Y,Z changes it",
        ));
    }
    let to_y_up = AxisConversion::to_y_up(up);
    let placed: Vec<DMat4> = file.objects.iter().map(|object| object.transform).collect();
    turn(file, to_y_up.matrix(), DVec3::ZERO);
    let camera = upright_camera(file, subject);
    file.objects.iter_mut().zip(placed).for_each(|(object, transform)| object.transform = transform);
    let back = to_y_up.inverse();
    let [eye, target, up] = [camera.eye, camera.target, camera.up].map(|v| back.rotate(v));
    Ok(Camera { eye, target, up, ..camera })
}

fn upright_camera(file: &SceneFile, subject: &Subject) -> Camera {
    match subject {
        Subject::Turntable(_) => turned_camera(file),
        _ => file.scene().camera,
    }
}

/// The file's camera, or one that holds the objects however they are turned about their upright axis.
fn turned_camera(file: &SceneFile) -> Camera {
    let scene = file.scene();
    let [width, height] = file.settings.size.map(f64::from);
    let turned = if file.camera.is_none() { scene.framing_turned(width / height) } else { None };
    turned.unwrap_or(scene.camera)
}

pub fn turn(file: &mut SceneFile, rotation: DMat4, pivot: DVec3) {
    let map = DMat4::from_translation(pivot) * rotation * DMat4::from_translation(-pivot);
    for object in &mut file.objects {
        object.transform = map * object.transform;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn lights_and_ambient_light_are_replaced_separately() {
        let ambient = |grey| Light::Ambient { colour: LinearRgb::grey(grey) };
        let sun = |x| Light::Directional { towards: DVec3::new(x, 0.0, 0.0), colour: LinearRgb::WHITE };
        let before = [ambient(0.1), sun(1.0), sun(2.0)];
        assert_eq!(lights(&before, &[sun(3.0)], None), [ambient(0.1), sun(3.0)]);
        assert_eq!(lights(&before, &[], Some(LinearRgb::grey(0.5))), [ambient(0.5), sun(1.0), sun(2.0)]);
        assert_eq!(lights(&before, &[sun(3.0)], Some(LinearRgb::BLACK)), [ambient(0.0), sun(3.0)]);
    }

    #[test]
    fn any_turn_is_a_rotation_about_its_axis() {
        assert_eq!(about(DVec3::Y * 3.0, Degrees(90.0)).transform_vector3(DVec3::Z), DVec3::X);
        for axis in [DVec3::X, DVec3::Z, DVec3::NEG_Y, DVec3::new(1.0, -2.0, 0.5)] {
            let unit = axis.normalize();
            let turned = DMat3::from_mat4(about(axis, Degrees(77.0)));
            // Sums of three products of numbers up to 1, three times over.
            assert!((turned * turned.transpose()).abs_diff_eq(DMat3::IDENTITY, 4e-15), "{axis}");
            assert!((turned.determinant() - 1.0).abs() < 4e-15 && (turned * unit).abs_diff_eq(unit, 4e-15));
            // Rodrigues: a vector square to the axis goes towards axis × vector.
            let across = unit.any_orthonormal_vector();
            // sin 77° = 0.97437
            assert!(((turned * across).dot(unit.cross(across)) - 0.974_37).abs() < 1e-6, "{axis}");
        }
    }

    #[test]
    fn contrast_is_that_of_the_codes_on_a_screen() {
        let (black, white) = (LinearRgb::BLACK, LinearRgb::WHITE);
        for transfer in [Transfer::Srgb, Transfer::Direct] {
            assert_eq!(contrast(white, black, transfer), 21.0);
            assert_eq!(contrast(white, white, transfer), 1.0);
        }
        // #767676, the darkest grey that is known for 4.54:1 on white.
        let grey = LinearRgb::from(Srgb8([0x76; 3]));
        assert!((contrast(white, grey, Transfer::Srgb) - 4.54).abs() < 0.005);
        // Without a curve, light of 0.3 is code 77, of luminance 0.0742, and not 149.
        assert!((contrast(white, LinearRgb::grey(0.3), Transfer::Direct) - 1.05 / 0.1242).abs() < 0.01);
        assert!((contrast(LinearRgb::grey(0.3), white, Transfer::Srgb) - 3.0).abs() < 0.02);
    }
}
