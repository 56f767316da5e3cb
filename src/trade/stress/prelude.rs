//! The names that the cases of every group use.

pub(super) use super::case::{Bound, Group, StressCase, Unit};
pub(super) use super::measured::{Measured, Outcome, Worst};
pub(super) use super::plain;
pub(super) use super::random::{rotation, signed, vector};
pub(super) use crate::mesh::{Faces, Mesh, Storage};
pub(super) use crate::normals::{
    Crease, FaultReason, NormalField, NormalRecipe, Precision, Scratch, Slivers, Weight, compute,
    face_normals,
};
pub(super) use crate::num::numbers::Numbers;
pub(super) use crate::num::{Degrees, LinearRgb, Real};
pub(super) use crate::shade::{
    Attenuation, Light, Material, Reflectance, Reflection, ShadeSettings, Shader, SurfacePoint, Viewer,
};
pub(super) use crate::trade::exact::{self, Big, big, small};
pub(super) use dashu_base::Abs;
pub(super) use glam::{DQuat, DVec3, Vec3};
pub(super) use std::f64::consts::{PI, TAU};
