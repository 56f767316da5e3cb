//! What is shown in place of shaded colours: normals, sides, distances, faces, deviations.

use crate::num::{LinearRgb, Radians};
use crate::raster::coverage::records::Record;
use crate::raster::frame::job::{Job, Prepared};
use crate::raster::settings::Show;
use crate::raster::shading::ray_cast::CastHit;
use glam::{DVec3, Vec3};

pub(crate) struct Sample<'a> {
    pub(crate) record: &'a Record,
    /// What its ray hit, if it was cast.
    pub(crate) hit: Option<&'a CastHit>,
    /// Its normal, of any length.
    pub(crate) value: Vec3,
    /// Relative to the view's origin, in units of the frame; only for deviations from an analytic surface.
    pub(crate) position: Vec3,
    pub(crate) depth: f32,
    /// Its place on the picture, in 256ths of a pixel.
    pub(crate) at: [i32; 2],
}

impl Sample<'_> {
    fn is_front(&self) -> bool {
        self.hit.map_or(self.record.front, |hit| hit.front)
    }

    /// Whether its normal is that of the other side.
    fn turned(&self, object: &Prepared) -> bool {
        self.hit.map_or(self.record.turned, |hit| object.settings.two_sided && !hit.front)
    }

    fn distance(&self, job: &Job) -> f64 {
        let distance = match self.hit {
            Some(hit) => hit.position.as_dvec3().dot(job.view.axes[2]),
            None => {
                let has_level = job.view.has_level();
                let nearness = if has_level { self.record.nearness_at(self.at) } else { self.depth };
                f64::from(job.rays.distance(self.depth, nearness))
            }
        };
        distance * job.frame.unit + job.view.away
    }
}

/// The brightness of faces seen edge-on, as a share of that of faces seen from straight above.
const EDGE_ON: f32 = 0.35;

pub(crate) fn colour(job: &Job, object: &Prepared, sample: &Sample) -> Vec3 {
    match job.settings.show {
        // Shaded samples do not come here: the values of their rows are their colours.
        Show::Shaded => sample.value,
        Show::Normals => (sample.value.normalize_or_zero() + 1.0) * 0.5,
        Show::Facing => {
            let colour = if sample.is_front() { Show::FRONT } else { Show::BACK };
            let cosine = sample.value.normalize_or_zero().dot(job.view.axes[2].as_vec3()).abs();
            colour
                .to_array()
                .map(|component| component as f32)
                .map(|c| c * (EDGE_ON + (1.0 - EDGE_ON) * cosine))
                .into()
        }
        Show::Depth => {
            let [low, high] = job.distances;
            Vec3::splat(((high - sample.distance(job)) / (high - low)).clamp(0.0, 1.0) as f32)
        }
        Show::FaceId => face_colour(sample.record.object, sample.record.face),
        Show::Deviation(full) => {
            let share = deviation(job, object, sample).0 / Radians::from(full).0;
            Show::deviation_colour(share).to_array().map(|component| component as f32).into()
        }
    }
}

fn deviation(job: &Job, object: &Prepared, sample: &Sample) -> Radians {
    let turned = if sample.turned(object) { -1.0 } else { 1.0 };
    let truth = match &object.truth {
        Some(surface) => {
            let point = job.frame.to_world(sample.position.as_dvec3());
            surface.normal_at(point).map_or(DVec3::ZERO, |normal| normal.get() * turned)
        }
        None => object.face_normal(sample.record.face, sample.record.turned).as_dvec3(),
    };
    let normal = sample.value.as_dvec3();
    Radians(libm::atan2(normal.cross(truth).length(), normal.dot(truth)))
}

/// A colour that distinguishes a face from its neighbours: not too dark, and the same in every picture of the scene.
fn face_colour(object: u32, face: u32) -> Vec3 {
    // The finaliser of splitmix64 (Steele, Lea & Flood 2014).
    let mut hash = (u64::from(object) << 32 | u64::from(face)).wrapping_add(0x9e37_79b9_7f4a_7c15);
    hash = (hash ^ (hash >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    hash = (hash ^ (hash >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    hash ^= hash >> 31;
    let component = |shift: u32| 0.1 + 0.9 * (hash >> shift & 0xff) as f32 / 255.0;
    Vec3::new(component(0), component(8), component(16))
}

impl Show {
    /// The colour of front faces seen from straight above. Front and back differ in lightness too, for eyes and printers without
    /// colour: 0.48 and 0.15 of white.
    pub const FRONT: LinearRgb = LinearRgb::new(0.25, 0.5, 1.0);
    /// The colour of back faces seen from straight above.
    pub const BACK: LinearRgb = LinearRgb::new(0.6, 0.03, 0.02);

    /// The colour of a share of the scale of [`Deviation`](Self::Deviation): black, red, yellow, white for 0 to 1.
    pub fn deviation_colour(share: f64) -> LinearRgb {
        let ramp = |from: f64| (3.0 * share - from).clamp(0.0, 1.0);
        LinearRgb::new(ramp(0.0), ramp(1.0), ramp(2.0))
    }
}
