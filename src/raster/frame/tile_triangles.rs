//! Drawing the triangles of a tile.

use crate::num::{Kernel, Lanes};
use crate::raster::coverage::bins::CLIPPED;
use crate::raster::coverage::setup::{CornerRows, GROUP, LARGE, Setup};
use crate::raster::coverage::tile_list::TileList;
use crate::raster::coverage::visible_triangle::Visible;
use crate::raster::frame::job::Job;
use crate::raster::view::project::ScreenVertex;

/// Draws the triangles of a tile in order, a group at a time.
pub(crate) struct DrawTriangles<'a> {
    pub(crate) job: &'a Job<'a>,
    pub(crate) list: &'a TileList,
    /// The sample of the tile's first pixel, in 256ths of a pixel of the picture.
    pub(crate) origin: [i32; 2],
    pub(crate) visible: &'a mut Visible,
}

impl Kernel for DrawTriangles<'_> {
    type Output = ();

    #[inline(always)]
    fn run<A: Lanes>(self, _: A) {
        let Self { job, list, origin, visible } = self;
        let (triangles, pieces) = (&list.triangles[..], &list.pieces[..]);
        let mut group = Group { corners: CornerRows::new(), owners: [0; GROUP], count: 0, origin };
        let mut setups = Setup::rows();
        let (mut piece, mut from) = (0, 0);
        for (number, object) in job.drawn.iter().enumerate() {
            let end = match job.drawn.get(number + 1) {
                None => triangles.len(),
                Some(next) => from + triangles[from..].partition_point(|&t| t & !CLIPPED < next.first),
            };
            for (at, &triangle) in triangles.iter().enumerate().take(end).skip(from) {
                if triangle & CLIPPED == 0 {
                    group.add(&object.screen(triangle - object.first), at as u32);
                    group.draw_if(GROUP, &mut setups, visible);
                    continue;
                }
                while piece < pieces.len() && pieces[piece].0 as usize == at {
                    group.add(&pieces[piece].1.vertices, (triangles.len() + piece) as u32);
                    group.draw_if(GROUP, &mut setups, visible);
                    piece += 1;
                }
            }
            from = end;
        }
        group.draw_if(1, &mut setups, visible);
    }
}

/// Triangles gathered to be prepared side by side.
struct Group {
    corners: CornerRows,
    owners: [u32; GROUP],
    count: usize,
    origin: [i32; 2],
}

impl Group {
    #[inline(always)]
    fn add(&mut self, v: &[ScreenVertex; 3], owner: u32) {
        self.corners.set(self.count, v);
        self.owners[self.count] = owner;
        self.count += 1;
    }

    /// Draws the group if it has so many.
    #[inline(always)]
    fn draw_if(
        &mut self,
        least: usize,
        setups: &mut Setup<[i32; GROUP], [f32; GROUP]>,
        visible: &mut Visible,
    ) {
        if self.count < least {
            return;
        }
        setups.prepare(&self.corners, self.origin);
        let mut masks = [0; GROUP];
        setups.masks(&mut masks);
        for (lane, &mask) in masks.iter().enumerate().take(self.count) {
            if mask != LARGE {
                visible.draw_small(setups, lane, mask, self.owners[lane]);
                continue;
            }
            let setup = setups.get(lane);
            if !setup.is_empty() {
                visible.draw(&setup, self.owners[lane]);
            }
        }
        self.count = 0;
    }
}
