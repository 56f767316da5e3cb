//! Scenes with lengths or positions outside the range of a picture's arithmetic.

use crate::io::Note;
use crate::num::unit_scale;
use crate::raster::load::scene_file::SceneFile;
use crate::shade::Light;
use glam::{DMat4, DVec3};

/// Scenes that are farther from the origin than this many times their size are moved. At this distance positions are
/// rounded to 2⁻²⁹ of the scene's size, far less than a pixel; beyond it cameras are rounded too coarsely.
const FARTHEST: f64 = (1 << 24) as f64;

/// Sizes from 2⁻¹⁰⁰ to 2¹⁰⁰ are unchanged: squares and their products stay in range.
const LARGEST: f64 = (1_u128 << 100) as f64;

/// The exponent of the largest power of two by which a scene is scaled: it and its inverse keep all of their digits.
const MOST: i32 = 1000;

/// A space in which a scene has a size that pictures can be computed at, and its middle at the origin.
///
/// For scenes that are put together from a caller's own meshes; [`SceneFile::recentre`] does it with those from files.
///
/// ```
/// use crease::raster::Recentring;
/// use glam::{DMat4, DVec3};
///
/// // A part of a millimetre in the middle of a map.
/// let (low, high) = (DVec3::splat(5e6), DVec3::splat(5e6 + 1e-3));
/// let recentring = Recentring::of((low, high)).expect("5 000 km from the origin");
/// let mut transform = DMat4::IDENTITY;
/// recentring.apply(&mut transform);
/// assert!(transform.transform_point3(low).length() < 1e-3);
/// assert_eq!(Recentring::of((DVec3::ZERO, DVec3::ONE)), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recentring {
    centre: DVec3,
    /// A power of two.
    scale: f64,
}

impl Recentring {
    /// For a scene of these bounds; `None`, as nearly always, for sizes from 2⁻¹⁰⁰ to 2¹⁰⁰ no farther from the origin than 2²⁴ times
    /// that, and for a single point. The scale is a power of two from 2⁻¹⁰⁰⁰ to 2¹⁰⁰⁰: it rounds nothing.
    pub fn of((low, high): (DVec3, DVec3)) -> Option<Self> {
        // Halved before they are added: the bounds may reach the largest numbers there are.
        let (centre, half) = (low * 0.5 + high * 0.5, high * 0.5 - low * 0.5);
        let (size, place) = (half.max_element(), centre.abs().max_element());
        let is_small_or_large = !(1.0 / LARGEST..=LARGEST).contains(&size);
        if size == 0.0 || !(is_small_or_large || place / size > FARTHEST) {
            return None;
        }
        let scale = if is_small_or_large { unit_scale(size) } else { 1.0 };
        Some(Self { centre, scale: scale.clamp(libm::ldexp(1.0, -MOST), libm::ldexp(1.0, MOST)) })
    }

    /// Changes a map to the old space into one to the new space: x ↦ (x − centre)·scale after the map.
    pub fn apply(self, map: &mut DMat4) {
        for axis in [&mut map.x_axis, &mut map.y_axis, &mut map.z_axis] {
            *axis *= self.scale;
        }
        let place = (map.w_axis.truncate() - self.centre) * self.scale;
        map.w_axis = place.extend(1.0);
    }
}

impl SceneFile {
    /// Moves a scene without a camera to the origin, and scales it by a power of two, if it is so large, small or far away that no
    /// camera in its own space could show it (see [`Recentring::of`]). Returns a note with what was done. Does nothing if it has a
    /// camera or lights with positions.
    pub fn recentre(&mut self) -> Option<Note> {
        let stands = |light: &Light| !matches!(light, Light::Ambient { .. } | Light::Directional { .. });
        if self.camera.is_some() || self.lights.iter().flatten().any(stands) {
            return None;
        }
        let recentring = Recentring::of(self.unframed().bounds()?)?;
        self.objects.iter_mut().for_each(|object| recentring.apply(&mut object.transform));
        let Recentring { centre: DVec3 { x, y, z }, scale } = recentring;
        let larger =
            if scale == 1.0 { String::new() } else { format!(" and 2^{} times as large", libm::log2(scale)) };
        Some(Note::remark(format!(
            "drawn with ({x:e}, {y:e}, {z:e}) as its origin{larger}, to be visible: reported positions and lengths are those of the drawing"
        )))
    }
}
