//! Cameras, held to what the standard says of them (glTF 2.0, §5.12 to §5.14).

use super::fields::{At, Fields, dangling};
use super::nodes::Placed;
use crate::io::{FileCamera, FileProjection, Problem, ReadError};
use std::f64::consts::PI;

/// The camera of a node that has one; `None` of others.
///
/// # Errors
/// Whatever makes it no camera, with the place and, if it has one, its name.
pub(super) fn at_node(node: &Placed<'_>) -> Result<Option<FileCamera>, ReadError> {
    let Some(number) = node.fields.index("camera")? else { return Ok(None) };
    let json = node.fields.json;
    let root = Fields { json, object: json.root(), at: At::default() };
    let mut all = root.array("cameras")?.into_iter().flat_map(|array| json.elements(array));
    let Some(object) = all.nth(number) else {
        let count = root.array("cameras")?.map_or(0, |array| json.elements(array).count());
        return Err(dangling(node.fields.at.member("camera"), "camera", number, count));
    };
    let camera = Fields::new(json, object, At::new("cameras", number))?;
    let name = camera.string("name")?.unwrap_or_default().into_owned();
    let read = projection(&camera).and_then(|(projection, near)| {
        check_rotation(node)?;
        Ok(FileCamera {
            name: name.clone(),
            place: camera.at.place(),
            world_from_camera: node.world,
            projection,
            near,
        })
    });
    match read {
        Err(error) if !name.is_empty() => {
            Err(ReadError { found: format!("the camera `{name}`: {}", error.found), ..error })
        }
        read => read.map(Some),
    }
}

/// How a camera maps, and its near distance.
fn projection(camera: &Fields<'_>) -> Result<(FileProjection, f64), ReadError> {
    let kind = camera.string("type")?.ok_or_else(|| camera.missing("type"))?;
    match &*kind {
        "perspective" => {
            let lens = lens(camera, "perspective")?;
            let angle = needed(&lens, "yfov")?;
            if !(angle > 0.0 && angle < PI) {
                return Err(wrong(&lens, "yfov", angle, "an angle above 0 and below π, in radians"));
            }
            if let Some(aspect) = lens.number("aspectRatio")?.filter(|&aspect| aspect <= 0.0) {
                return Err(wrong(&lens, "aspectRatio", aspect, "a number above 0, or none"));
            }
            let near = needed(&lens, "znear")?;
            if near <= 0.0 {
                return Err(wrong(&lens, "znear", near, "a distance above 0"));
            }
            check_far(&lens, near, lens.number("zfar")?)?;
            Ok((FileProjection::Perspective(angle), near))
        }
        "orthographic" => {
            let lens = lens(camera, "orthographic")?;
            let whole = |name| match needed(&lens, name)? {
                half if half > 0.0 => Ok(2.0 * half),
                half => Err(wrong(&lens, name, half, "half of what is seen, a length above 0")),
            };
            let (width, height) = (whole("xmag")?, whole("ymag")?);
            let near = needed(&lens, "znear")?;
            if near < 0.0 {
                return Err(wrong(&lens, "znear", near, "a distance of 0 or more"));
            }
            check_far(&lens, near, Some(needed(&lens, "zfar")?))?;
            Ok((FileProjection::Orthographic { width, height }, near))
        }
        kind => {
            let found = format!("`type` is `{kind}`");
            let advice = "make it `perspective` or `orthographic`";
            Err(ReadError::new(Problem::Range, camera.at.member("type"), found, advice))
        }
    }
}

fn lens<'a>(camera: &Fields<'a>, name: &'static str) -> Result<Fields<'a>, ReadError> {
    let object = camera.object(name)?.ok_or_else(|| camera.missing(name))?;
    Ok(Fields { object, at: camera.at.member_at(name), ..*camera })
}

fn needed(lens: &Fields<'_>, name: &str) -> Result<f64, ReadError> {
    lens.number(name)?.ok_or_else(|| lens.missing(name))
}

fn check_far(lens: &Fields<'_>, near: f64, far: Option<f64>) -> Result<(), ReadError> {
    match far {
        Some(far) if far <= near => {
            Err(wrong(lens, "zfar", far, &format!("a distance above `znear`, which is {near}")))
        }
        _ => Ok(()),
    }
}

fn check_rotation(node: &Placed<'_>) -> Result<(), ReadError> {
    let Some(at) = node.without_rotation else { return Ok(()) };
    let found = "a camera stands here or below, and a rotation of zeros turns it nowhere";
    let advice = "give a quaternion of length 1, such as 0, 0, 0, 1";
    Err(ReadError::new(Problem::Range, At::new("nodes", at).member("rotation"), found, advice))
}

fn wrong(lens: &Fields<'_>, name: &str, number: f64, wanted: &str) -> ReadError {
    let found = format!("`{name}` is {number}");
    ReadError::new(Problem::Range, lens.at.member(name), found, format!("give {wanted}"))
}
