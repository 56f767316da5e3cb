//! Mesh normals: compute them, split them where a surface should stay sharp, write them back.
//!
//! # Conventions
//! Right-handed space, y up, counter-clockwise front faces; screen y down with pixel centres at +0.5; radians
//! inside and degrees at the command line and in reports; colour linear until a named transfer step.

pub mod io;
pub mod mesh;
pub mod normals;
pub mod num;
