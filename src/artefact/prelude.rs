//! The names that the code of every experiment uses.

pub(super) use super::drawing::{
    BACKGROUND, BOX_FACES, Diagonal, GAP, TriangleMesh, box_corners, build, centre, chalk, colour_at,
    differences, direction, draw, errors, far_light, front, lamp, largest_difference, largest_error,
    light_at, linear, luminance, map, object, painted, picture, settings, sheets, shiny, smooth, tiles,
};
pub(super) use super::effect::{Effect, Threshold};
pub(super) use super::error::{ArtefactError, Result};
pub(super) use super::experiment::Experiment;
pub(super) use super::outcome::{Drawn, Outcome, Verdict};
pub(super) use super::parameters::{ParameterName, Parameters, Setup, UserMesh};
pub(super) use super::recorder::{Axis, Check, Recorder};
pub(super) use super::user_mesh::{Normalisation, camera, light_from, not_visible};
pub(super) use crate::mesh::{Faces, Mesh};
pub(super) use crate::normals::{Crease, NormalField, NormalRecipe, Weight, compute};
pub(super) use crate::num::{Degrees, LinearRgb, Radians, angle_between};
pub(super) use crate::raster::{
    Camera, Image, Interpolation, Object, Paint, Projection, RenderSettings, Samples, Shading, Shape, Show,
};
pub(super) use crate::shade::{Attenuation, Light, Material, Reflection};
pub(super) use crate::surface::{Primitive, Sphere};
pub(super) use crate::text::{Catalogue, Value, catalogue};
pub(super) use glam::{DMat4, DVec2, DVec3};
