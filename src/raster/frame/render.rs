//! From a scene to a picture: tiles in parallel.

use crate::raster::coverage::setup::TILE;
use crate::raster::coverage::tile_bins::{Binning, Bins};
use crate::raster::coverage::visible_triangle::number;
use crate::raster::error::Result;
use crate::raster::frame::job::Job;
use crate::raster::frame::stopwatch::Stopwatch;
use crate::raster::frame::target::{Target, targets};
use crate::raster::frame::tile::Worker;
use crate::raster::lines::LineJob;
use crate::raster::picture::{Image, Pixels, Statistics, Times};
use crate::raster::scene::Scene;
use crate::raster::settings::{Bits, RenderSettings};
use crate::raster::shading::lighting::light_in_advance;
use crate::raster::view::project::ScreenVertex;
use rayon::prelude::*;
use std::sync::Mutex;

/// Draws a scene.
///
/// Visibility first, shading after, in tiles of 64 × 64 pixels. All shading and interpolation modes have the same coverage.
/// Sampling follows Direct3D's rules: 8 sub-pixel bits, and the top-left rule, which covers shared edges once. Of
/// equally near faces the lower index shows.
///
/// Uses the current thread pool of rayon; the picture is the same at any number of threads. In addition to the picture
/// it takes 16 bytes a vertex (with Gouraud shading 28), 16 bytes a triangle of a cut polygon, about 5 bytes a triangle for the lists
/// of tiles, and about 250 kB a thread.
///
/// Shares of a triangle's corners have a relative error of at most 3·10⁻⁷: they are computed in single precision where edge functions
/// are exact in it, that is up to about 13 pixels from a corner, elsewhere in double precision.
///
/// ```
/// use crease::mesh::{Faces, MeshBuilder};
/// use crease::normals::{NormalRecipe, compute};
/// use crease::num::LinearRgb;
/// use crease::raster::{Camera, Object, RenderSettings, Scene, Shape, render};
/// use crease::shade::{Light, Material};
/// use glam::DVec3;
///
/// let mesh = MeshBuilder {
///     positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y].into(),
///     faces: Faces::triangles(vec![0, 1, 2]),
///     ..MeshBuilder::default()
/// }
/// .build()?;
/// let normals = compute(&mesh, &NormalRecipe::default());
/// let scene = Scene {
///     objects: vec![Object::new(Shape::Mesh { mesh: &mesh, normals: &normals }, Material::default())],
///     lines: Vec::new(),
///     lights: vec![Light::Directional { towards: DVec3::Z, colour: LinearRgb::WHITE }],
///     camera: Camera::framing(mesh.bounds().unwrap(), 1.0),
///     background: LinearRgb::BLACK,
/// };
/// let image = render(&scene, &RenderSettings { size: [64, 64], ..RenderSettings::default() })?;
/// assert!(image.statistics.covered_pixels > 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Invalid cameras, sizes, transforms, lists and numbers; colours that are not finite.
pub fn render(scene: &Scene, settings: &RenderSettings) -> Result<Image> {
    render_reusing(scene, settings, &mut RenderScratch::default())
}

/// The memory of pictures that were drawn before.
#[derive(Default)]
pub struct RenderScratch {
    vertices: Vec<Vec<ScreenVertex>>,
    workers: Vec<Worker>,
    image: Option<Image>,
    observer: Option<Box<dyn Fn() + Send + Sync>>,
}

impl RenderScratch {
    /// Memory of which `observer` is called before each tile of a picture, by all threads. A panic of it ends the picture.
    pub fn observed(observer: impl Fn() + Send + Sync + 'static) -> Self {
        Self { observer: Some(Box::new(observer)), ..Self::default() }
    }

    /// Gives back the memory of a picture that is no longer needed.
    pub fn recycle(&mut self, image: Image) {
        self.image = Some(image);
    }
}

/// Draws a scene as [`render`] does, in the memory of pictures before, for one frame after the other.
///
/// ```
/// use crease::num::LinearRgb;
/// use crease::raster::{Camera, RenderScratch, RenderSettings, Scene, render_reusing};
/// use glam::DVec3;
///
/// let camera = Camera::framing((DVec3::ZERO, DVec3::ONE), 1.0);
/// let scene =
///     Scene { objects: Vec::new(), lines: Vec::new(), lights: Vec::new(), camera, background: LinearRgb::BLACK };
/// let mut scratch = RenderScratch::default();
/// for _frame in 0..3 {
///     let image = render_reusing(&scene, &RenderSettings::default(), &mut scratch)?;
///     scratch.recycle(image);
/// }
/// # Ok::<(), crease::raster::RenderError>(())
/// ```
///
/// # Errors
/// As [`render`].
pub fn render_reusing(
    scene: &Scene,
    settings: &RenderSettings,
    scratch: &mut RenderScratch,
) -> Result<Image> {
    let start = Stopwatch::start();
    let mut job = Job::reusing(scene, settings, &mut scratch.vertices)?;
    let lines = LineJob::new(&job, scene)?;
    let geometry = start.elapsed();
    let start = Stopwatch::start();
    let bins = bins(&job);
    let binning = start.elapsed();
    let start = Stopwatch::start();
    job.lit = light_in_advance(&job, bins.counts.drawn);
    let mut image = blank(settings, scratch.image.take());
    let drawn = draw_tiles(&job, &bins, &lines, &mut image, scratch)?;
    image.statistics = Statistics { covered_pixels: drawn.covered, ..Statistics::default() };
    image.statistics.rays = drawn.rays;
    let samples = drawn.covered.saturating_mul(settings.samples.count() as u64);
    image.statistics.light_cut = if drawn.cut > 0.0 { drawn.cut / samples.max(1) as f64 } else { 0.0 };
    image.statistics.triangles_drawn = bins.counts.drawn;
    image.statistics.triangles_clipped = bins.counts.clipped;
    image.statistics.triangles_culled = bins.counts.culled;
    image.statistics.times = Times { geometry, binning, tiles: start.elapsed() };
    let vertices = job.drawn.into_iter().map(|object| object.vertices);
    // Small objects do not keep the memory of large ones.
    scratch.vertices = vertices.rev().filter(|list| list.capacity() <= 2 * list.len()).collect();
    Ok(image)
}

/// The linear colour of a pixel of the picture that [`render`] draws, to the bit, without the other tiles.
pub(crate) fn pixel_colour(scene: &Scene, settings: &RenderSettings, pixel: [u32; 2]) -> Result<[f32; 3]> {
    let job = Job::new(scene, settings)?;
    let lines = LineJob::new(&job, scene)?;
    let mut worker = Worker::new();
    let tile = pixel.map(|n| n as usize / TILE);
    let finished = worker.draw(&job, &bins(&job), &lines, tile)?;
    let at = number(pixel.map(|n| n as usize % TILE));
    Ok(finished.map_or(job.background, |tile| tile.colours.each_ref().map(|channel| channel[at])))
}

/// The triangles of all objects, by tile.
pub(crate) fn bins(job: &Job) -> Bins {
    let offsets = || job.settings.samples.offsets();
    let samples = [0, 1].map(|axis| {
        offsets()
            .fold([i32::MAX, i32::MIN], |[low, high], place| [low.min(place[axis]), high.max(place[axis])])
    });
    Bins::new(&job.drawn, Binning { view: &job.view, cull: job.settings.cull, samples })
}

/// A picture of which every pixel is still to be written, in the memory of another if there is one.
fn blank(settings: &RenderSettings, before: Option<Image>) -> Image {
    let count = settings.size.iter().map(|&side| side as usize).product();
    let (pixels, coverage, linear, objects) = match before {
        Some(image) => (Some(image.pixels), image.coverage, image.linear, image.objects),
        None => (None, Vec::new(), None, None),
    };
    Image {
        size: settings.size,
        pixels: match (settings.bits, pixels) {
            (Bits::Eight, Some(Pixels::Eight(list))) => Pixels::Eight(resized(list, count)),
            (Bits::Eight, _) => Pixels::Eight(vec![[0; 3]; count]),
            (Bits::Sixteen, Some(Pixels::Sixteen(list))) => Pixels::Sixteen(resized(list, count)),
            (Bits::Sixteen, _) => Pixels::Sixteen(vec![[0; 3]; count]),
        },
        coverage: resized(coverage, count),
        linear: settings.keep_linear.then(|| resized(linear.unwrap_or_default(), count)),
        objects: settings.keep_objects.then(|| resized(objects.unwrap_or_default(), count)),
        statistics: Statistics::default(),
    }
}

/// So many numbers of any value.
fn resized<T: Default + Clone>(mut list: Vec<T>, count: usize) -> Vec<T> {
    if list.is_empty() {
        return vec![T::default(); count];
    }
    list.resize(count, T::default());
    list
}

/// What tiles report.
#[derive(Clone, Copy, Debug, Default)]
struct TileCounts {
    covered: u64,
    rays: u64,
    cut: f64,
}

fn draw_tiles(
    job: &Job,
    bins: &Bins,
    lines: &LineJob,
    image: &mut Image,
    scratch: &mut RenderScratch,
) -> Result<TileCounts> {
    let observe = scratch.observer.as_deref().unwrap_or(&|| {});
    let workers = Mutex::new(&mut scratch.workers);
    let spare =
        || workers.lock().ok().and_then(|mut workers: std::sync::MutexGuard<&mut Vec<Worker>>| workers.pop());
    let draw = |mut target: Target| {
        observe();
        let mut worker = spare().unwrap_or_else(Worker::new);
        (worker.tracer.count, worker.tracer.cut) = (0, 0.0);
        let covered = worker.draw(job, bins, lines, target.tile).map(|tile| target.write(job, tile.as_ref()));
        let (rays, cut) = (worker.tracer.count, worker.tracer.cut);
        let counts = covered.map(|covered| TileCounts { covered, rays, cut });
        if let Ok(mut workers) = workers.lock() {
            workers.push(worker);
        }
        counts
    };
    // The first error in order of tiles, whichever thread comes to one first; sums in that order, too.
    let results: Vec<Result<TileCounts>> = targets(image).into_par_iter().with_max_len(1).map(draw).collect();
    results.into_iter().try_fold(TileCounts::default(), |sum, tile| {
        let tile = tile?;
        Ok(TileCounts {
            covered: sum.covered + tile.covered,
            rays: sum.rays + tile.rays,
            cut: sum.cut + tile.cut,
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::LinearRgb;
    use crate::raster::{Camera, Object, Shading, Shape, Triangles};
    use crate::shade::{Light, Material};
    use glam::DVec3;

    const POSITIONS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.5]];

    /// Two triangles, of which the second may show its back.
    fn scene(triangles: &[[u32; 3]; 2]) -> Scene<'_> {
        let shape = Shape::Triangles(Triangles {
            positions: &POSITIONS,
            triangles,
            normals: &[[0.0, 0.0, 1.0], [0.0, 0.6, 0.8], [0.6, 0.0, 0.8], [0.0, 0.0, 1.0]],
            face_normals: &[[0.0, 0.0, 1.0]; 2],
        });
        Scene {
            objects: vec![Object::new(shape, Material::default())],
            lines: Vec::new(),
            lights: vec![Light::Directional { towards: DVec3::Z, colour: LinearRgb::WHITE }],
            camera: Camera::framing((DVec3::new(-2.0, -2.0, 0.0), DVec3::new(3.0, 3.0, 0.5)), 1.0),
            background: LinearRgb::new(0.2, 0.1, 0.4),
        }
    }

    /// Against single pixels, whose corners are lit one by one.
    #[test]
    fn light_in_advance_changes_no_bit() {
        for (triangles, two_sided) in
            [([[0, 1, 2], [2, 1, 3]], false), ([[0, 1, 2], [2, 3, 1]], false), ([[0, 1, 2], [2, 3, 1]], true)]
        {
            let scene = scene(&triangles);
            let settings = RenderSettings {
                size: [100, 100],
                shading: Shading::Gouraud,
                keep_linear: true,
                two_sided,
                ..RenderSettings::default()
            };
            let image = render(&scene, &settings).unwrap();
            let covered = (0..10_000_u32).filter(|&pixel| image.coverage[pixel as usize] > 0).step_by(7);
            let mut compared = 0;
            for pixel in covered {
                let alone = pixel_colour(&scene, &settings, [pixel % 100, pixel / 100]).unwrap();
                assert_eq!(alone, image.linear.as_ref().unwrap()[pixel as usize], "{pixel} {two_sided}");
                compared += 1;
            }
            assert!(compared > 5, "{compared}");
        }
    }

    /// Edges leave the picture through the tiles at its right and lower border.
    #[test]
    fn edges_outside_the_picture_are_not_counted() {
        let mut scene = scene(&[[0, 1, 2], [2, 1, 3]]);
        scene.camera = Camera::framing((DVec3::ZERO, DVec3::new(0.4, 0.4, 0.5)), 1.0);
        let settings = RenderSettings {
            size: [100, 90],
            shading: Shading::Wireframe,
            keep_linear: true,
            ..RenderSettings::default()
        };
        let image = render(&scene, &settings).unwrap();
        let background = scene.background.to_array().map(|c| c as f32);
        let drawn = image.linear.unwrap().iter().filter(|&&colour| colour != background).count();
        assert!(drawn > 50, "{drawn}");
        assert_eq!(image.statistics.covered_pixels, drawn as u64);
    }

    /// Pictures of other sizes, depths, lists and shadings in between change nothing, also on tiles with nothing but background.
    #[test]
    fn reused_memory_changes_no_picture() {
        let scene = scene(&[[0, 1, 2], [2, 1, 3]]);
        let plain = RenderSettings { size: [200, 140], ..RenderSettings::default() };
        let rich = RenderSettings {
            size: [130, 260],
            bits: Bits::Sixteen,
            keep_linear: true,
            keep_objects: true,
            ..RenderSettings::default()
        };
        let mut scratch = RenderScratch::default();
        let larger = RenderSettings { size: [300, 300], ..rich };
        let shaded = [Shading::Flat, Shading::Gouraud, Shading::Traced, Shading::Wireframe, Shading::Phong];
        let shaded = shaded.map(|shading| RenderSettings { shading, ..plain });
        for settings in [plain, rich, plain, larger, rich].into_iter().chain(shaded).chain([plain]) {
            let expected = render(&scene, &settings).unwrap();
            assert!(expected.statistics.covered_pixels > 50, "{:?}", expected.statistics);
            let image = render_reusing(&scene, &settings, &mut scratch).unwrap();
            let statistics = Statistics { times: expected.statistics.times, ..image.statistics };
            assert!(Image { statistics, ..image.clone() } == expected);
            scratch.recycle(image);
        }
    }
}
