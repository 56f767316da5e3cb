//! Cameras, checked against the standard (glTF 2.0, §5.12 to §5.14).

use crate::io::gltf::document::nodes::Placed;
use crate::io::gltf::json::fields::{At, Fields, checked_index};
use crate::io::{FileCamera, FileProjection, Problem, ReadError};
use glam::DMat4;
use std::f64::consts::PI;

/// The camera of a node; `None` if it has none. It looks along its node's −z with +y up. Scaling does not affect its
/// orientation (glTF 2.0, §3.10.2): it has the position of its node, and the product of the rotations from the root on.
///
/// # Errors
/// What the standard does not allow, with the place and, if the camera has one, its name.
pub fn at_node(node: &Placed<'_>) -> Result<Option<FileCamera>, ReadError> {
    let json = node.fields.json;
    let Some(number) = node.fields.index("camera")? else { return Ok(None) };
    let all: Vec<_> = Fields::root(json).items("cameras")?.collect();
    checked_index(number, all.len(), "camera", || node.fields.at.member("camera"))?;
    let camera = Fields::new(json, all[number], At::new("cameras", number))?;
    let name = camera.string("name")?.unwrap_or_default().into_owned();
    let read = projection(&camera).and_then(|(projection, [near, far])| {
        check_rotation(node)?;
        let position = node.frame.world.w_axis.truncate();
        Ok(FileCamera {
            name: name.clone(),
            place: camera.at.place(),
            world_from_camera: DMat4::from_rotation_translation(node.frame.rotation, position),
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

/// The projection of a camera, and its near and far distances, the latter infinite if there is none.
fn projection(camera: &Fields<'_>) -> Result<(FileProjection, [f64; 2]), ReadError> {
    let kind = camera.string("type")?.ok_or_else(|| camera.missing("type"))?;
    let (lens, projection, is_near, near_range) = match &*kind {
        "perspective" => {
            let lens = camera.required_child("perspective")?;
            let is_angle = |angle| angle > 0.0 && angle < PI;
            let angle = needed(&lens, "yfov", is_angle, "an angle above 0 and below π, in radians")?;
            optional(&lens, "aspectRatio", |aspect| aspect > 0.0, "a number above 0, or none")?;
            let is_near: fn(f64) -> bool = |near| near > 0.0;
            (lens, FileProjection::Perspective(angle), is_near, "a distance above 0")
        }
        "orthographic" => {
            let lens = camera.required_child("orthographic")?;
            let wanted = "half of what is seen, a length above 0";
            let whole = |name| Ok(2.0 * needed(&lens, name, |half| half > 0.0, wanted)?);
            let (width, height) = (whole("xmag")?, whole("ymag")?);
            let is_near: fn(f64) -> bool = |near| near >= 0.0;
            (lens, FileProjection::Orthographic { width, height }, is_near, "a distance of 0 or more")
        }
        kind => {
            let found = format!("`type` is `{kind}`");
            let advice = "make it `perspective` or `orthographic`";
            return Err(ReadError::new(Problem::Range, camera.at.member("type"), found, advice));
        }
    };
    let near = needed(&lens, "znear", is_near, near_range)?;
    let far_range = format!("a distance above `znear`, which is {near}");
    let far = optional(&lens, "zfar", |far| far > near, &far_range)?;
    if far.is_none() && matches!(projection, FileProjection::Orthographic { .. }) {
        return Err(lens.missing("zfar"));
    }
    Ok((projection, [near, far.unwrap_or(f64::INFINITY)]))
}

/// A number of a lens that has to be there.
fn needed(
    lens: &Fields<'_>,
    name: &str,
    is_allowed: impl Fn(f64) -> bool,
    wanted: &str,
) -> Result<f64, ReadError> {
    optional(lens, name, is_allowed, wanted)?.ok_or_else(|| lens.missing(name))
}

/// A number of a lens.
fn optional(
    lens: &Fields<'_>,
    name: &str,
    is_allowed: impl Fn(f64) -> bool,
    wanted: &str,
) -> Result<Option<f64>, ReadError> {
    match lens.number(name)? {
        Some(number) if !is_allowed(number) => {
            let found = format!("`{name}` is {number}");
            Err(ReadError::new(Problem::Range, lens.at.member(name), found, format!("give {wanted}")))
        }
        number => Ok(number),
    }
}

fn check_rotation(node: &Placed<'_>) -> Result<(), ReadError> {
    let Some((at, member)) = node.frame.without_rotation else { return Ok(()) };
    let (what, advice) = match member {
        "matrix" => {
            ("a matrix without an inverse", "give `rotation`, `translation` and `scale` in its place")
        }
        _ => ("a rotation of zeros", "give a quaternion of length 1, such as 0, 0, 0, 1"),
    };
    let found = format!("a camera stands here or below, and {what} gives it no orientation");
    Err(ReadError::new(Problem::Range, At::new("nodes", at).member(member), found, advice))
}
