//! Newell's teapot.

use crate::surface::shapes::bezier::BezierPatch;
use glam::DVec3;
use std::sync::OnceLock;

/// The published figures; the file itself says where they are from.
const FIGURES: &str = include_str!("../../../data/teapot.txt");

/// The 32 patches of Newell's teapot, facing outward, with y up, the spout along +x, the bottom at y = 0 and the top of the lid
/// at y = 3.15: rim 4, body 8, handle 4, spout 4, lid 8, bottom 4.
///
/// Four pieces that interpenetrate but share no edge: the pot, the lid, the handle and the spout. Within each the patches
/// meet smoothly. At the top of the lid and in the middle of the bottom sides are collapsed, see [`BezierPatch`].
pub fn teapot() -> &'static [BezierPatch] {
    static PATCHES: OnceLock<Vec<BezierPatch>> = OnceLock::new();
    PATCHES.get_or_init(|| read(FIGURES).expect("the figures that this program was built with are complete"))
}

/// The patches of the figures, turned from z up to y up.
fn read(figures: &str) -> Option<Vec<BezierPatch>> {
    let lines = figures.lines().filter(|line| !line.starts_with('#'));
    let mut words = lines.flat_map(str::split_whitespace);
    let count = heading(&mut words, "points")?;
    let mut number = || words.next()?.parse::<f64>().ok();
    let points: Vec<DVec3> = (0..count)
        .map(|_| {
            let [x, y, z] = [number()?, number()?, number()?];
            Some(DVec3::new(x, z, 0.0 - y))
        })
        .collect::<Option<_>>()?;
    let count = heading(&mut words, "patches")?;
    let mut point = || points.get(words.next()?.parse::<usize>().ok()?).copied();
    (0..count)
        .map(|_| {
            let mut rows = [[DVec3::ZERO; 4]; 4];
            for slot in rows.as_flattened_mut() {
                *slot = point()?;
            }
            BezierPatch::new(rows).ok()
        })
        .collect()
}

/// The count that follows a name.
fn heading<'a>(words: &mut impl Iterator<Item = &'a str>, name: &str) -> Option<usize> {
    if words.next()? == name { words.next()?.parse().ok() } else { None }
}
