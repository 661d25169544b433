//! Digests of what is traced, by which machines and builds are compared: where they are equal, so is every bit.

use super::export::TraceFile;
use super::picture::{Progress, render};
use super::pixel::record_pixel;
use crate::scene::{Image, Scene};
use glam::DVec3;
use std::io::{self, Write};

/// The digest by Fowler, Noll and Vo (FNV-1a) with 64 bits: for mistakes of machines, not of people.
struct Digest(u64);

impl Digest {
    const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Write for Digest {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// A line for the picture of a scene, so many pixels wide, and one for each of its telling pixels, recorded in full in its own size.
///
/// Records name lines of the source: they are compared between builds of the same source.
#[must_use]
pub fn digests(name: &str, scene: &Scene, width: u32) -> Vec<String> {
    let picture = format!("{:016x} {name}, {width} wide", of_picture(scene, width));
    let record = |&[x, y]: &[u32; 2]| format!("{:016x} {name} at {x},{y}", of_record(name, scene, [x, y]));
    std::iter::once(picture).chain(scene.pixels.iter().map(record)).collect()
}

fn of_picture(scene: &Scene, width: u32) -> u64 {
    let Image { width: columns, height: rows } = scene.image;
    let height = u64::from(width) * u64::from(rows) / u64::from(columns.max(1));
    let mut scene = scene.clone();
    scene.image = Image { width, height: u32::try_from(height).unwrap_or(u32::MAX).max(1) };
    let (picture, _) = render(&scene, &Progress::new());
    let mut digest = Digest::new();
    for channel in picture.pixels().iter().flat_map(DVec3::to_array) {
        // A digest takes whatever it is given.
        let _ = digest.write_all(&channel.to_bits().to_le_bytes());
    }
    digest.0
}

fn of_record(name: &str, scene: &Scene, [x, y]: [u32; 2]) -> u64 {
    let tree = record_pixel(scene, x, y);
    let mut digest = Digest::new();
    // As above; and a record can always be written.
    let _ = serde_json::to_writer(&mut digest, &TraceFile::new(name, &tree));
    digest.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{embedded_scene, load};

    #[test]
    fn the_digest_is_the_published_one() {
        let mut digest = Digest::new();
        digest.write_all(b"foobar").unwrap();
        assert_eq!(digest.0, 0x8594_4171_f739_67e8, "Fowler, Noll, Vo: test vectors of FNV-1a, 64 bits");
    }

    #[test]
    fn a_change_in_the_last_place_changes_the_digest() {
        let name = "hello/sphere";
        let scene = load(embedded_scene(name).unwrap().text, name).unwrap();
        let mut other = scene.clone();
        other.materials[0].diffuse.x = other.materials[0].diffuse.x.next_up();
        let [before, after] = [&scene, &other].map(|scene| digests(name, scene, 16));
        assert_eq!(before.len(), 1 + scene.pixels.len());
        assert_ne!(before, after);
        assert_eq!(before, digests(name, &scene, 16));
    }
}
