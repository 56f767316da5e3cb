//! The cause of an empty picture.

use crate::raster::scene::{Scene, Shape};
use crate::raster::settings::{Cull, RenderSettings, Shading};
use crate::raster::view::screen_transform::{ObjectMap, View};
use glam::{DMat4, DVec3};
use std::fmt;

/// The likely cause of a picture that shows nothing but its background.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unseen {
    /// There are only analytic surfaces, which have no edges to draw.
    NoEdges,
    /// Everything is behind the camera, or nearer than its near distance.
    Behind,
    /// Everything in front of the camera is outside the picture.
    OutsidePicture,
    /// All of it would fit between two samples.
    Small,
    /// All faces show the side that is culled.
    Culled,
    /// No face has an area that could be seen.
    NoArea,
}

impl fmt::Display for Unseen {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::NoEdges => "analytic surfaces have no edges to draw; give them a tessellation",
            Self::Behind => "everything is behind the camera, or nearer than its near distance",
            Self::OutsidePicture => "everything is outside the picture",
            Self::Small => "everything is smaller than the distance of two samples",
            Self::Culled => "all faces show the culled side",
            Self::NoArea => "no face has a visible area",
        })
    }
}

impl Scene<'_> {
    /// The likely cause of a picture that covers no pixel; `None` without a valid camera or anything to draw.
    pub fn unseen(&self, settings: &RenderSettings) -> Option<Unseen> {
        let is_solid = |shape: &Shape| matches!(shape, Shape::Surface(_));
        if settings.shading == Shading::Wireframe && self.objects.iter().all(|object| is_solid(&object.shape))
        {
            return Some(Unseen::NoEdges);
        }
        let view = View::new(&self.camera, settings.size).ok()?;
        let map = ObjectMap::new(&view, DMat4::IDENTITY, DVec3::ZERO);
        let size = settings.size.map(f64::from);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let (mut any, mut is_clipped) = (false, false);
        self.each_point(|point| {
            any = true;
            let seen = map.view(point);
            if seen.z <= view.near {
                is_clipped = true;
                return;
            }
            for (axis, place) in view.on_picture(seen).into_iter().enumerate() {
                low[axis] = low[axis].min(place);
                high[axis] = high[axis].max(place);
            }
        });
        if !any {
            return None;
        }
        let is_outside = (0..2).any(|axis| high[axis] < 0.0 || low[axis] > size[axis]);
        Some(if low[0] > high[0] {
            Unseen::Behind
        } else if is_outside && !is_clipped {
            Unseen::OutsidePicture
        } else if !is_clipped && (0..2).all(|axis| high[axis] - low[axis] < 1.0) {
            Unseen::Small
        } else if settings.cull != Cull::None {
            Unseen::Culled
        } else if is_clipped {
            Unseen::OutsidePicture
        } else {
            Unseen::NoArea
        })
    }
}
