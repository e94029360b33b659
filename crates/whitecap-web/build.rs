//! The panel's fonts, less what no panel shows: a page is loaded before it is seen.
//!
//! Of egui's own fonts the letters of European languages, Greek, and the signs of formulas and keys are kept. What is left out:
//! other glyphs, hints for coarse screens, kerning, names. Tables are as in OpenType 1.9, "glyf", "loca", "cmap" and others.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Latin, Greek, punctuation, superscripts and subscripts, letters like signs, arrows and operators.
const LETTERS: &[std::ops::RangeInclusive<u32>] =
    &[0x20..=0x17F, 0x370..=0x3FF, 0x2010..=0x2044, 0x2070..=0x209F, 0x20AC..=0x20AC, 0x2190..=0x22FF];

/// What is looked for in the second font: superscripts, arrows and shapes.
const SIGNS: &[std::ops::RangeInclusive<u32>] = &[0x2070..=0x207F, 0x2190..=0x21FF, 0x25A0..=0x25FF];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let folder = std::env::var_os("OUT_DIR").expect("cargo names a folder");
    for (name, font, kept) in [
        ("letters.ttf", epaint_default_fonts::UBUNTU_LIGHT, LETTERS),
        ("signs.ttf", epaint_default_fonts::HACK_REGULAR, SIGNS),
    ] {
        let subset = subset(font, kept).expect("egui's fonts are TrueType fonts");
        std::fs::write(Path::new(&folder).join(name), subset).expect("cargo's folder can be written");
    }
}

/// The font with these characters alone.
fn subset(font: &[u8], kept: &[std::ops::RangeInclusive<u32>]) -> Option<Vec<u8>> {
    let tables = tables(font)?;
    let table = |tag: &[u8; 4]| tables.get(tag).copied();
    let (head, loca, glyf) = (table(b"head")?, table(b"loca")?, table(b"glyf")?);
    let glyphs = usize::from(u16_at(table(b"maxp")?, 4)?);
    let is_long = u16_at(head, 50)? == 1;
    let offset = |glyph: usize| match is_long {
        true => Some(u32_at(loca, 4 * glyph)? as usize),
        false => Some(2 * usize::from(u16_at(loca, 2 * glyph)?)),
    };
    let outline = |glyph: u16| glyf.get(offset(glyph.into())?..offset(usize::from(glyph) + 1)?);

    let mut characters = characters(table(b"cmap")?)?;
    characters.retain(|character, _| kept.iter().any(|range| range.contains(character)));
    let mut used: BTreeSet<u16> = characters.values().copied().chain([0]).collect();
    let mut open: Vec<u16> = used.iter().copied().collect();
    while let Some(glyph) = open.pop() {
        open.extend(parts(outline(glyph)?).into_iter().filter(|part| used.insert(*part)));
    }

    let (mut new_glyf, mut new_loca) = (Vec::new(), Vec::new());
    for glyph in 0..=u16::try_from(glyphs).ok()? {
        new_loca.extend(u32::try_from(new_glyf.len()).ok()?.to_be_bytes());
        if used.contains(&glyph) {
            new_glyf.extend(unhinted(outline(glyph)?)?);
            new_glyf.resize(new_glyf.len().next_multiple_of(4), 0);
        }
    }
    let mut new_head = head.to_vec();
    new_head[50..52].copy_from_slice(&1u16.to_be_bytes());
    let new_cmap = cmap(&characters);
    // In the order of their tags, as the directory must be.
    Some(packed(&[
        (b"OS/2", table(b"OS/2")?),
        (b"cmap", &new_cmap),
        (b"glyf", &new_glyf),
        (b"head", &new_head),
        (b"hhea", table(b"hhea")?),
        (b"hmtx", table(b"hmtx")?),
        (b"loca", &new_loca),
        (b"maxp", table(b"maxp")?),
    ]))
}

fn u16_at(bytes: &[u8], at: usize) -> Option<u16> {
    Some(u16::from_be_bytes(bytes.get(at..at + 2)?.try_into().ok()?))
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}

fn tables(font: &[u8]) -> Option<BTreeMap<[u8; 4], &[u8]>> {
    let count = usize::from(u16_at(font, 4)?);
    let table = |i: usize| {
        let at = 12 + 16 * i;
        let (start, length) = (u32_at(font, at + 8)? as usize, u32_at(font, at + 12)? as usize);
        Some((font.get(at..at + 4)?.try_into().ok()?, font.get(start..start + length)?))
    };
    (0..count).map(table).collect()
}

/// Every character of the font's first table of format 4 (16 bits), with its glyph.
fn characters(cmap: &[u8]) -> Option<BTreeMap<u32, u16>> {
    let count = usize::from(u16_at(cmap, 2)?);
    let tables = (0..count).filter_map(|i| cmap.get(u32_at(cmap, 8 + 8 * i)? as usize..));
    let table = tables.into_iter().find(|table| u16_at(table, 0) == Some(4))?;
    let doubled = usize::from(u16_at(table, 6)?);
    let mut characters = BTreeMap::new();
    for segment in (0..doubled).step_by(2) {
        let end = u16_at(table, 14 + segment)?;
        let start = u16_at(table, 16 + doubled + segment)?;
        let delta = u16_at(table, 16 + 2 * doubled + segment)?;
        let range_at = 16 + 3 * doubled + segment;
        let range = usize::from(u16_at(table, range_at)?);
        for character in start..=end.min(0xFFFE) {
            let glyph = match range {
                0 => character.wrapping_add(delta),
                _ => match u16_at(table, range_at + range + 2 * usize::from(character - start))? {
                    0 => 0,
                    glyph => glyph.wrapping_add(delta),
                },
            };
            if glyph != 0 {
                characters.insert(u32::from(character), glyph);
            }
        }
    }
    Some(characters)
}

/// The glyphs that a glyph is put together from.
fn parts(outline: &[u8]) -> Vec<u16> {
    let mut parts = Vec::new();
    if u16_at(outline, 0).is_none_or(|contours| contours < 0x8000) {
        return parts;
    }
    let mut at = 10;
    while let (Some(flags), Some(glyph)) = (u16_at(outline, at), u16_at(outline, at + 2)) {
        parts.push(glyph);
        let has = |flag: u16| usize::from(flags & flag != 0);
        // Arguments as words; a scale, two of them, or a matrix.
        at += 6 + 2 * has(0x1) + 2 * has(0x8) + 4 * has(0x40) + 8 * has(0x80);
        if has(0x20) == 0 {
            break;
        }
    }
    parts
}

/// A glyph without its instructions.
fn unhinted(outline: &[u8]) -> Option<Vec<u8>> {
    let contours = u16_at(outline, 0).unwrap_or(0x8000);
    if contours >= 0x8000 {
        return Some(outline.to_vec());
    }
    let at = 10 + 2 * usize::from(contours);
    let instructions = usize::from(u16_at(outline, at)?);
    Some([&outline[..at], &[0, 0], outline.get(at + 2 + instructions..)?].concat())
}

/// A table of format 12, each character a group of its own.
fn cmap(characters: &BTreeMap<u32, u16>) -> Vec<u8> {
    let count = characters.len() as u32;
    let mut cmap = [[0, 0, 0, 1, 0, 3, 0, 10], [0, 0, 0, 12, 0, 12, 0, 0]].concat();
    for number in [16 + 12 * count, 0, count] {
        cmap.extend(number.to_be_bytes());
    }
    for (&character, &glyph) in characters {
        for number in [character, character, u32::from(glyph)] {
            cmap.extend(number.to_be_bytes());
        }
    }
    cmap
}

/// A font of these tables. Nobody reads its sums.
fn packed(tables: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let count = tables.len() as u16;
    let mut font = [&0x0001_0000_u32.to_be_bytes()[..], &count.to_be_bytes(), &[0; 6]].concat();
    let mut start = font.len() + 16 * tables.len();
    for (tag, bytes) in tables {
        font.extend(*tag);
        for number in [0, start as u32, bytes.len() as u32] {
            font.extend(number.to_be_bytes());
        }
        start += bytes.len().next_multiple_of(4);
    }
    for (_, bytes) in tables {
        font.extend(*bytes);
        font.resize(font.len().next_multiple_of(4), 0);
    }
    font
}
