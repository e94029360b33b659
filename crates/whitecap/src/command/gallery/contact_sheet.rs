//! All pictures on one, small and with their names.

use super::Exhibit;
use crate::sheet::Sheet;
use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_9X15;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::text::{Baseline, Text};
use image::{Rgba, RgbaImage, imageops};
use whitecap_render::picture::Picture;

/// The longest side of a thumbnail, pixels.
const LONGEST: u32 = 320;
/// Around and between the thumbnails, pixels.
const GAP: u32 = 16;
/// For a name under its thumbnail, pixels.
const LABEL: u32 = 24;
const GROUND: Rgba<u8> = Rgba([24, 27, 32, 255]);
const INK: Rgb888 = Rgb888::new(226, 230, 235);

/// A sheet as square as whole cells make it, in the order of the gallery.
pub(super) fn draw(exhibits: &[Exhibit]) -> Picture {
    let shown: Vec<(&str, &Picture)> =
        exhibits.iter().map(|exhibit| (exhibit.named.name, &exhibit.picture)).collect();
    let sheet = sheet(&shown);
    Picture { width: sheet.width(), height: sheet.height(), rgba8: sheet.into_raw() }
}

fn sheet(shown: &[(&str, &Picture)]) -> RgbaImage {
    let thumbnails: Vec<RgbaImage> = shown.iter().map(|(_, picture)| thumbnail(picture)).collect();
    let names = shown.iter().map(|(name, _)| name.len() as u32 * FONT_9X15.character_size.width);
    let cell_width = thumbnails.iter().map(RgbaImage::width).chain(names).max().unwrap_or(1);
    let cell_height = thumbnails.iter().map(RgbaImage::height).max().unwrap_or(1) + LABEL;
    let columns = (1..).find(|columns| columns * columns >= shown.len() as u32).unwrap_or(1).max(1);
    let rows = (shown.len() as u32).div_ceil(columns);
    let side = |cells: u32, cell: u32| GAP + cells * (cell + GAP);
    let mut sheet = RgbaImage::from_pixel(side(columns, cell_width), side(rows, cell_height), GROUND);
    for ((place, (name, _)), thumbnail) in (0..).zip(shown).zip(&thumbnails) {
        let x = GAP + place % columns * (cell_width + GAP);
        let y = GAP + place / columns * (cell_height + GAP);
        imageops::replace(&mut sheet, thumbnail, x.into(), y.into());
        let under = Point::new(x as i32, (y + thumbnail.height() + 6) as i32);
        let style = MonoTextStyle::new(&FONT_9X15, INK);
        let Ok(_) = Text::with_baseline(name, under, style, Baseline::Top).draw(&mut Sheet(&mut sheet));
    }
    sheet
}

/// The picture with its longest side at most [`LONGEST`], by the mean of the pixels that become one.
fn thumbnail(picture: &Picture) -> RgbaImage {
    let (width, height) = (picture.width, picture.height);
    // `rgba8` has four bytes for each pixel.
    let whole = RgbaImage::from_raw(width, height, picture.rgba8.clone()).unwrap_or_default();
    let longest = width.max(height);
    if longest <= LONGEST {
        return whole;
    }
    let shrunk = |side: u32| ((u64::from(side) * u64::from(LONGEST) / u64::from(longest)) as u32).max(1);
    imageops::thumbnail(&whole, shrunk(width), shrunk(height))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(width: u32, height: u32, level: u8) -> Picture {
        Picture { width, height, rgba8: [level, level, level, 255].repeat((width * height) as usize) }
    }

    #[test]
    fn every_picture_is_on_the_sheet_with_its_name_under_it() {
        let pictures: Vec<Picture> = (1..=5).map(|n| plain(640, 360, 40 * n)).collect();
        let shown: Vec<(&str, &Picture)> = pictures.iter().map(|picture| ("name", picture)).collect();
        let sheet = sheet(&shown);
        assert_eq!(sheet.dimensions(), (3 * 336 + 16, 2 * (180 + 24 + 16) + 16));
        for n in 0..5u32 {
            let (x, y) = (16 + n % 3 * 336, 16 + n / 3 * 220);
            assert_eq!(sheet.get_pixel(x, y)[0], 40 * (n as u8 + 1));
            assert_eq!(sheet.get_pixel(x + 319, y + 179)[0], 40 * (n as u8 + 1));
            let label = (y + 180..y + 204).flat_map(|y| (x..x + 320).map(move |x| (x, y)));
            let ink = label.filter(|&(x, y)| sheet.get_pixel(x, y).0 == [226, 230, 235, 255]).count();
            assert!((40..400).contains(&ink), "{ink} pixels of ink");
        }
        assert_eq!(*sheet.get_pixel(16 + 2 * 336, 16 + 220), GROUND, "the sixth place is empty");
    }

    #[test]
    fn thumbnails_keep_their_shape_and_are_never_larger_than_the_picture() {
        for (picture, expected) in [
            (plain(4000, 1000, 9), (320, 80)),
            (plain(100, 800, 9), (40, 320)),
            (plain(8, 6, 9), (8, 6)),
            (plain(1, 1, 9), (1, 1)),
            (plain(3000, 1, 9), (320, 1)),
        ] {
            assert_eq!(thumbnail(&picture).dimensions(), expected);
        }
    }

    #[test]
    fn a_long_name_widens_its_cell() {
        let picture = plain(16, 9, 9);
        let sheet = sheet(&[("a-very-long-name-of-a-scene", &picture)]);
        assert!(sheet.width() >= 27 * 9);
    }
}
