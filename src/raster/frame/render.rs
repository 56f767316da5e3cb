//! From a scene to a picture: tiles in parallel, then linear colours to stored numbers.

use crate::num::{self, Kernel, Lanes, Transfer};
use crate::raster::coverage::setup::{SIDE, TILE};
use crate::raster::coverage::tile_bins::{Binning, Bins, tiles};
use crate::raster::coverage::visible_triangle::{BLOCKS, LANES, PIXELS, number};
use crate::raster::error::Result;
use crate::raster::frame::job::Job;
use crate::raster::frame::stopwatch::Stopwatch;
use crate::raster::frame::tile::{Finished, Worker};
use crate::raster::lines::LineJob;
use crate::raster::picture::{Image, Pixels, Statistics, Times};
use crate::raster::scene::Scene;
use crate::raster::settings::{Bits, RenderSettings};
use crate::shade::ToneRule;
use rayon::prelude::*;
use std::sync::Mutex;

/// Draws a scene.
///
/// Visibility first, shading after, in tiles of 64 × 64 pixels. All shading and interpolation modes have the same coverage.
/// Sampling follows Direct3D's rules: 8 sub-pixel bits, and the top-left rule, which covers shared edges once. Of
/// equally near faces the lower index shows.
///
/// Uses the current thread pool of rayon; the picture is the same at any number of threads. In addition to the picture
/// it takes 16 bytes a vertex, 16 bytes a triangle of a cut polygon, about 5 bytes a triangle for the lists of tiles,
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
    let start = Stopwatch::start();
    let job = Job::new(scene, settings)?;
    let lines = LineJob::new(&job, scene)?;
    let geometry = start.elapsed();
    let start = Stopwatch::start();
    let bins = bins(&job);
    let binning = start.elapsed();
    let start = Stopwatch::start();
    let mut image = blank(settings);
    let drawn = draw_tiles(&job, &bins, &lines, &mut image)?;
    image.statistics.covered_pixels = drawn.covered;
    image.statistics.rays = drawn.rays;
    let samples = drawn.covered.saturating_mul(settings.samples.count() as u64);
    image.statistics.light_cut = if drawn.cut > 0.0 { drawn.cut / samples.max(1) as f64 } else { 0.0 };
    image.statistics.triangles_drawn = bins.counts.drawn;
    image.statistics.triangles_clipped = bins.counts.clipped;
    image.statistics.triangles_culled = bins.counts.culled;
    image.statistics.times = Times { geometry, binning, tiles: start.elapsed() };
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
        objects: settings.keep_objects.then(|| vec![0; count]),
        statistics: Statistics::default(),
    }
}

/// What tiles report.
#[derive(Clone, Copy, Debug, Default)]
struct TileCounts {
    covered: u64,
    rays: u64,
    cut: f64,
}

fn draw_tiles(job: &Job, bins: &Bins, lines: &LineJob, image: &mut Image) -> Result<TileCounts> {
    let workers = Mutex::new(Vec::new());
    let spare =
        || workers.lock().ok().and_then(|mut workers: std::sync::MutexGuard<Vec<Worker>>| workers.pop());
    let draw = |mut target: Target| {
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

/// The rows of a picture that lie in a tile.
pub(crate) struct Target<'a> {
    pub(crate) tile: [usize; 2],
    colours: TargetColours<'a>,
    coverage: Vec<&'a mut [u8]>,
    linear: Vec<&'a mut [[f32; 3]]>,
    objects: Vec<&'a mut [u32]>,
}

enum TargetColours<'a> {
    Eight(Vec<&'a mut [[u8; 3]]>),
    Sixteen(Vec<&'a mut [[u16; 3]]>),
}

pub(crate) fn targets(image: &mut Image) -> Vec<Target<'_>> {
    let size = image.size;
    let columns = tiles(size)[0];
    let colours: Vec<TargetColours> = match &mut image.pixels {
        Pixels::Eight(list) => rows_of_tiles(list, size).into_iter().map(TargetColours::Eight).collect(),
        Pixels::Sixteen(list) => rows_of_tiles(list, size).into_iter().map(TargetColours::Sixteen).collect(),
    };
    let mut linear = image.linear.as_mut().map(|list| rows_of_tiles(list, size).into_iter());
    let mut objects = image.objects.as_mut().map(|list| rows_of_tiles(list, size).into_iter());
    let coverage = rows_of_tiles(&mut image.coverage, size);
    let targets = colours.into_iter().zip(coverage).enumerate().map(|(number, (colours, coverage))| {
        let linear = linear.as_mut().and_then(Iterator::next).unwrap_or_default();
        let objects = objects.as_mut().and_then(Iterator::next).unwrap_or_default();
        Target { tile: [number % columns, number / columns], colours, coverage, linear, objects }
    });
    targets.collect()
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

impl Target<'_> {
    pub(crate) fn write(&mut self, job: &Job, tile: Option<&Finished>) -> u64 {
        match tile {
            Some(tile) => num::dispatch(WriteTile { target: self, settings: job.settings, tile }),
            None => {
                self.fill(job);
                0
            }
        }
    }

    /// Background all over. What is covered and the linear colours of a new picture are 0 already.
    fn fill(&mut self, job: &Job) {
        let RenderSettings { tone, transfer, .. } = job.settings;
        let toned = tone.apply(job.background);
        match &mut self.colours {
            TargetColours::Eight(rows) => {
                let pixel = toned.map(|component| transfer.pixel_u8(component));
                rows.iter_mut().for_each(|row| row.fill(pixel));
            }
            TargetColours::Sixteen(rows) => {
                let pixel = toned.map(|component| transfer.to_u16(f64::from(component)));
                rows.iter_mut().for_each(|row| row.fill(pixel));
            }
        }
        self.linear.iter_mut().for_each(|row| row.fill(job.background));
    }
}

/// Writes a tile row by row.
struct WriteTile<'a, 'b> {
    target: &'a mut Target<'b>,
    settings: &'a RenderSettings,
    tile: &'a Finished<'a>,
}

impl Kernel for WriteTile<'_, '_> {
    /// How many pixels are covered.
    type Output = u64;

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) -> u64 {
        let Self { target, settings, tile } = self;
        let mut covered = 0;
        for (y, objects) in target.objects.iter_mut().enumerate() {
            let count = objects.len().min(TILE);
            objects[..count].copy_from_slice(&row_of_tile(tile.objects, y)[..count]);
        }
        for (y, coverage) in target.coverage.iter_mut().enumerate() {
            let samples = row_of_tile(tile.covered, y);
            let count = coverage.len().min(TILE);
            coverage[..count].copy_from_slice(&samples[..count]);
            covered += match tile.edged {
                None => samples[..count].iter().map(|&samples| u64::from(samples > 0)).sum::<u64>(),
                Some(edged) => row_of_tile(edged, y)[..count].iter().map(|&edged| u64::from(edged)).sum(),
            };
        }
        for y in 0..target.coverage.len() {
            let mut row = tile.colours.each_ref().map(|colours| row_of_tile(colours, y));
            if let Some(linear) = target.linear.get_mut(y) {
                for (x, linear) in linear.iter_mut().enumerate().take(TILE) {
                    *linear = [row[0][x], row[1][x], row[2][x]];
                }
            }
            apply_tone(settings.tone, &mut row);
            match &mut target.colours {
                TargetColours::Eight(rows) => quantise(settings.transfer, &row, rows[y]),
                TargetColours::Sixteen(rows) => {
                    for (x, pixel) in rows[y].iter_mut().enumerate().take(TILE) {
                        *pixel = row.each_ref().map(|row| settings.transfer.to_u16(f64::from(row[x])));
                    }
                }
            }
        }
        covered
    }
}

/// A row of pixels out of the blocks that a tile is stored in.
#[inline(always)]
fn row_of_tile<T: Copy + Default>(tile: &[T; PIXELS], y: usize) -> [T; TILE] {
    let mut row = [T::default(); TILE];
    for (block, part) in row.as_chunks_mut::<SIDE>().0.iter_mut().enumerate() {
        let at = (y / SIDE * BLOCKS + block) * LANES + y % SIDE * SIDE;
        part.copy_from_slice(&tile[at..at + SIDE]);
    }
    row
}

/// Applies the tone rule to a row; the choice is made outside the loop.
#[inline(always)]
fn apply_tone(tone: ToneRule, [red, green, blue]: &mut [[f32; TILE]; 3]) {
    let mut apply = |tone: ToneRule| {
        for x in 0..TILE {
            [red[x], green[x], blue[x]] = tone.apply([red[x], green[x], blue[x]]);
        }
    };
    match tone {
        ToneRule::Clamp => apply(ToneRule::Clamp),
        ToneRule::DivideByMax => apply(ToneRule::DivideByMax),
    }
}

/// Makes 8-bit numbers of a row.
#[inline(always)]
fn quantise(transfer: Transfer, row: &[[f32; TILE]; 3], out: &mut [[u8; 3]]) {
    let mut codes = [[0; TILE]; 3];
    for (codes, row) in codes.iter_mut().zip(row) {
        match transfer {
            Transfer::Direct => {
                for x in 0..TILE {
                    codes[x] = Transfer::Direct.pixel_u8(row[x]);
                }
            }
            Transfer::Srgb => {
                for x in 0..out.len().min(TILE) {
                    codes[x] = Transfer::Srgb.pixel_u8(row[x]);
                }
            }
        }
    }
    for (x, pixel) in out.iter_mut().enumerate().take(TILE) {
        *pixel = [codes[0][x], codes[1][x], codes[2][x]];
    }
}
