//! Text in pictures, in the one font that the crate carries.
//!
//! The font is a part of DejaVu Sans; its licence is `src/report/font/LICENSE`. No font of the machine is used, so the
//! same text gives the same pixels everywhere.

use super::picture::Picture;
use ab_glyph::{Font, FontRef, GlyphId, PxScale, ScaleFont, point};
use std::sync::LazyLock;

static FONT: LazyLock<FontRef<'static>> = LazyLock::new(|| {
    let font = FontRef::try_from_slice(include_bytes!("font/DejaVuSans-subset.ttf"));
    font.expect("the font that the crate carries can be read")
});

/// The replacement of characters that the font lacks.
const REPLACEMENT: char = '?';

/// The width of a line of text in pixels, at a height from the top of the tallest to the bottom of the lowest letter.
pub fn text_width(text: &str, height: f32) -> f32 {
    let font = FONT.as_scaled(PxScale::from(height));
    text.chars().map(|c| font.h_advance(glyph(c))).sum()
}

/// Draws a line of text, its upper left corner at `at`, in a colour given as shares of the full code.
///
/// Edges are anti-aliased by mixing codes. Characters that the font lacks become question marks: it has ASCII, accented
/// letters of Portuguese, and a few signs such as ° · × µ → θ.
pub fn draw_text(picture: &mut Picture, text: &str, at: [i64; 2], height: f32, colour: [f32; 3]) {
    let scale = PxScale::from(height);
    let font = FONT.as_scaled(scale);
    // Whole pixels: the strokes of all letters then have the same sharpness.
    let baseline = font.ascent().round();
    let mut x = 0.0;
    for c in text.chars() {
        let id = glyph(c);
        let placed = id.with_scale_and_position(scale, point(x, baseline));
        if let Some(outline) = FONT.outline_glyph(placed) {
            let bounds = outline.px_bounds();
            let corner = [at[0] + bounds.min.x as i64, at[1] + bounds.min.y as i64];
            outline.draw(|x, y, share| {
                let pixel = [corner[0] + i64::from(x), corner[1] + i64::from(y)];
                picture.blend(pixel, colour, share.min(1.0));
            });
        }
        x += font.h_advance(id);
    }
}

fn glyph(c: char) -> GlyphId {
    match FONT.glyph_id(c) {
        GlyphId(0) => FONT.glyph_id(REPLACEMENT),
        id => id,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::Pixels;

    fn drawn(text: &str, height: f32) -> Picture {
        let width = text_width(text, height).ceil() as u32;
        let mut picture = Picture::filled([width, height as u32 + 1], false, [0.0; 3]);
        draw_text(&mut picture, text, [0, 0], height, [1.0; 3]);
        picture
    }

    fn rows(picture: &Picture) -> Vec<String> {
        let Pixels::Eight(list) = &picture.pixels else { panic!("8 bits") };
        let row = |row: &[[u8; 3]]| row.iter().map(|p| if p[0] > 127 { '#' } else { '.' }).collect();
        list.chunks(picture.size[0] as usize).map(row).collect()
    }

    #[test]
    fn letters_have_their_shapes() {
        let rows = rows(&drawn("L", 24.0));
        let dark = |row: &&String| row.contains('#');
        let shape: Vec<&String> = rows.iter().filter(dark).collect();
        assert!(shape.len() >= 14, "an L of 24 pixels is as high as a capital letter: {rows:#?}");
        let width = |row: &str| row.matches('#').count();
        let (foot, stem) = (width(shape[shape.len() - 1]), width(shape[1]));
        assert!(foot >= 3 * stem && stem >= 1, "{rows:#?}");
    }

    #[test]
    fn text_stays_within_its_width_and_height() {
        let (text, height) = ("Gouraud, 40° × gjpq", 16.0);
        let width = text_width(text, height);
        let mut picture = Picture::filled([width as u32 + 40, 56], false, [0.0; 3]);
        draw_text(&mut picture, text, [20, 20], height, [1.0; 3]);
        let Pixels::Eight(list) = &picture.pixels else { panic!("8 bits") };
        let lit = |i: &usize| list[*i] != [0; 3];
        let places =
            (0..list.len()).filter(lit).map(|i| (i % picture.size[0] as usize, i / picture.size[0] as usize));
        let (columns, lines): (Vec<usize>, Vec<usize>) = places.unzip();
        // One pixel of anti-aliasing and side bearing around.
        assert!(
            *columns.iter().min().unwrap() >= 19 && *columns.iter().max().unwrap() <= 21 + width as usize
        );
        assert!(*lines.iter().min().unwrap() >= 19 && *lines.iter().max().unwrap() <= 37);
    }

    #[test]
    fn every_promised_character_is_there() {
        for c in (' '..='~').chain("áàâãçéêíóôõúÁÉÇ°·×µ→θαφσπ–".chars()) {
            assert_ne!(FONT.glyph_id(c), GlyphId(0), "{c}");
        }
        assert_eq!(drawn("\u{4e2d}", 20.0), drawn("?", 20.0));
    }

    #[test]
    fn text_outside_the_picture_is_left_out() {
        let mut picture = Picture::filled([4, 4], false, [0.0; 3]);
        draw_text(&mut picture, "much too long", [-30, -6], 16.0, [1.0; 3]);
        draw_text(&mut picture, "below", [0, 4000], 16.0, [1.0; 3]);
    }
}
