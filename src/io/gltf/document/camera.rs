//! Cameras, held to what the standard says of them (glTF 2.0, §5.12 to §5.14).

use crate::io::gltf::document::nodes::Placed;
use crate::io::gltf::json::fields::{At, Fields, dangling};
use crate::io::{FileCamera, FileProjection, Problem, ReadError};
use glam::DMat4;
use std::f64::consts::PI;

/// The camera of a node that has one; `None` of others. It looks along its node's −z with +y up. Its view comes from where
/// that node is in the world, with all scaling left out (glTF 2.0, §3.10.2): it stands where the node stands, which the
/// scales above it have a part in, and looks as the rotations turn it, one after the other.
///
/// # Errors
/// Whatever makes it no camera, with the place and, if it has one, its name.
pub fn at_node(node: &Placed<'_>) -> Result<Option<FileCamera>, ReadError> {
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
    let read = projection(&camera).and_then(|(projection, [near, far])| {
        check_rotation(node)?;
        Ok(FileCamera {
            name: name.clone(),
            place: camera.at.place(),
            world_from_camera: DMat4::from_rotation_translation(node.turn, node.world.w_axis.truncate()),
            projection,
            near,
            far: far.is_finite().then_some(far),
        })
    });
    match read {
        Err(error) if !name.is_empty() => {
            Err(ReadError { found: format!("the camera `{name}`: {}", error.found), ..error })
        }
        read => read.map(Some),
    }
}

/// How a camera maps, and its near and far distances, the latter infinite if there is none.
fn projection(camera: &Fields<'_>) -> Result<(FileProjection, [f64; 2]), ReadError> {
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
            let far = lens.number("zfar")?.unwrap_or(f64::INFINITY);
            check_far(&lens, near, far)?;
            Ok((FileProjection::Perspective(angle), [near, far]))
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
            let far = needed(&lens, "zfar")?;
            check_far(&lens, near, far)?;
            Ok((FileProjection::Orthographic { width, height }, [near, far]))
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

fn check_far(lens: &Fields<'_>, near: f64, far: f64) -> Result<(), ReadError> {
    match far > near {
        true => Ok(()),
        false => Err(wrong(lens, "zfar", far, &format!("a distance above `znear`, which is {near}"))),
    }
}

fn check_rotation(node: &Placed<'_>) -> Result<(), ReadError> {
    let Some((at, member)) = node.without_rotation else { return Ok(()) };
    let (what, advice) = match member {
        "matrix" => {
            ("a matrix without an inverse", "give `rotation`, `translation` and `scale` in its place")
        }
        _ => ("a rotation of zeros", "give a quaternion of length 1, such as 0, 0, 0, 1"),
    };
    let found = format!("a camera stands here or below, and {what} turns it nowhere");
    Err(ReadError::new(Problem::Range, At::new("nodes", at).member(member), found, advice))
}

fn wrong(lens: &Fields<'_>, name: &str, number: f64, wanted: &str) -> ReadError {
    let found = format!("`{name}` is {number}");
    ReadError::new(Problem::Range, lens.at.member(name), found, format!("give {wanted}"))
}
