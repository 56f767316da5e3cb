//! From a scene to a picture.

use super::bins::{Binning, Bins, tiles};
use super::coverage::number;
use super::error::RenderError;
use super::job::Job;
use super::lines::LineJob;
use super::picture::{Image, Pixels, Statistics, Times};
use super::scene::Scene;
use super::settings::{Bits, RenderSettings};
use super::setup::TILE;
use super::tile::{Finished, Worker};
use rayon::prelude::*;
use std::sync::Mutex;
use std::time::Instant;

/// Draws a scene.
///
/// Visibility first, shading after, in tiles of 64 × 64 pixels. All shading and interpolation modes share one coverage:
/// pictures of the same scene that differ in these settings differ in colours, never in which pixels are covered.
/// Sampling follows Direct3D's rules: 8 sub-pixel bits, the top-left rule, so that shared edges are covered once. Of
/// faces equally near the one with the lower index shows.
///
/// Uses the current thread pool of rayon; the picture is the same at any number of threads. Beside what it returns it
/// takes 16 bytes a vertex, 16 bytes a triangle where polygons are cut, about 5 bytes a triangle for the tiles' lists,
/// and about 250 kB a thread.
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
///     positions: vec![DVec3::ZERO, DVec3::X, DVec3::Y],
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
/// Cameras, sizes, transforms, lists and numbers that make no sense; lights whose colour is not finite somewhere.
pub fn render(scene: &Scene, settings: &RenderSettings) -> Result<Image, RenderError> {
    let start = Instant::now();
    let job = Job::new(scene, settings)?;
    let lines = LineJob::new(&job, &scene.lines)?;
    let geometry = start.elapsed();
    let start = Instant::now();
    let bins = bins(&job);
    let binning = start.elapsed();
    let start = Instant::now();
    let mut image = blank(settings);
    image.statistics.covered_pixels = draw_tiles(&job, &bins, &lines, &mut image)?;
    image.statistics.triangles_drawn = bins.counts.drawn;
    image.statistics.triangles_clipped = bins.counts.clipped;
    image.statistics.triangles_culled = bins.counts.culled;
    image.statistics.times = Times { geometry, binning, tiles: start.elapsed() };
    Ok(image)
}

/// The triangles of all objects, by tile.
pub(super) fn bins(job: &Job) -> Bins {
    let offsets = || job.settings.samples.offsets();
    let samples = [0, 1].map(|axis| {
        offsets()
            .fold([i32::MAX, i32::MIN], |[low, high], place| [low.min(place[axis]), high.max(place[axis])])
    });
    Bins::new(&job.drawn, Binning { view: &job.view, cull: job.settings.cull, samples })
}

fn blank(settings: &RenderSettings) -> Image {
    let count = settings.size.iter().map(|&side| side as usize).product();
    Image {
        size: settings.size,
        pixels: match settings.bits {
            Bits::Eight => Pixels::Eight(vec![[0; 3]; count]),
            Bits::Sixteen => Pixels::Sixteen(vec![[0; 3]; count]),
        },
        coverage: vec![0; count],
        linear: settings.keep_linear.then(|| vec![[0.0; 3]; count]),
        statistics: Statistics::default(),
    }
}

/// The rows of a picture that lie in a tile.
struct Target<'a> {
    tile: [usize; 2],
    colours: TargetColours<'a>,
    coverage: Vec<&'a mut [u8]>,
    linear: Vec<&'a mut [[f32; 3]]>,
}

enum TargetColours<'a> {
    Eight(Vec<&'a mut [[u8; 3]]>),
    Sixteen(Vec<&'a mut [[u16; 3]]>),
}

/// Cuts a list of pixels into the rows of each tile, tile by tile.
fn rows_of_tiles<T>(list: &mut [T], size: [u32; 2]) -> Vec<Vec<&mut [T]>> {
    let [columns, rows] = tiles(size);
    let mut targets: Vec<Vec<&mut [T]>> = Vec::with_capacity(columns * rows);
    targets.resize_with(columns * rows, || Vec::with_capacity(TILE));
    for (y, row) in list.chunks_mut(size[0] as usize).enumerate() {
        for (x, part) in row.chunks_mut(TILE).enumerate() {
            targets[y / TILE * columns + x].push(part);
        }
    }
    targets
}

/// Draws all tiles and returns how many pixels are covered.
fn draw_tiles(job: &Job, bins: &Bins, lines: &LineJob, image: &mut Image) -> Result<u64, RenderError> {
    let size = image.size;
    let columns = tiles(size)[0];
    let colours: Vec<TargetColours> = match &mut image.pixels {
        Pixels::Eight(list) => rows_of_tiles(list, size).into_iter().map(TargetColours::Eight).collect(),
        Pixels::Sixteen(list) => rows_of_tiles(list, size).into_iter().map(TargetColours::Sixteen).collect(),
    };
    let mut linear = image.linear.as_mut().map(|list| rows_of_tiles(list, size).into_iter());
    let coverage = rows_of_tiles(&mut image.coverage, size);
    let targets: Vec<Target> = colours
        .into_iter()
        .zip(coverage)
        .enumerate()
        .map(|(number, (colours, coverage))| {
            let linear = linear.as_mut().and_then(Iterator::next).unwrap_or_default();
            Target { tile: [number % columns, number / columns], colours, coverage, linear }
        })
        .collect();
    let workers = Mutex::new(Vec::new());
    let spare =
        || workers.lock().ok().and_then(|mut workers: std::sync::MutexGuard<Vec<Worker>>| workers.pop());
    let draw = |mut target: Target| {
        let mut worker = spare().unwrap_or_else(Worker::new);
        let covered = worker.draw(job, bins, lines, target.tile).map(|finished| target.write(job, &finished));
        if let Ok(mut workers) = workers.lock() {
            workers.push(worker);
        }
        covered
    };
    // The first error in order of tiles, whichever thread comes to one first.
    let results: Vec<Result<u64, RenderError>> = targets.into_par_iter().with_max_len(1).map(draw).collect();
    results.into_iter().sum()
}

impl Target<'_> {
    /// Quantises a tile and returns how many of its pixels are covered.
    fn write(&mut self, job: &Job, finished: &Finished) -> u64 {
        let (tone, transfer) = (job.settings.tone, job.settings.transfer);
        let mut covered = 0;
        for (y, coverage) in self.coverage.iter_mut().enumerate() {
            for (x, coverage) in coverage.iter_mut().enumerate() {
                let pixel = number([x, y]);
                let colour = finished.colours.each_ref().map(|row| row[pixel]);
                *coverage = finished.covered[pixel];
                covered += u64::from(*coverage > 0);
                if let Some(linear) = self.linear.get_mut(y) {
                    linear[x] = colour;
                }
                let toned = tone.apply(colour);
                match &mut self.colours {
                    TargetColours::Eight(rows) => rows[y][x] = toned.map(|c| transfer.pixel_u8(c)),
                    TargetColours::Sixteen(rows) => {
                        rows[y][x] = toned.map(|c| transfer.to_u16(f64::from(c)));
                    }
                }
            }
        }
        covered
    }
}
