//! Texture scanning and inverse scanning in words.

use super::text::count;
use crate::texture::image::Scan;
use crate::trace::Scanning;

/// Both orders with what they leave out and paint again, as text.
#[must_use]
pub fn scan_text(scanning: &Scanning) -> String {
    let [columns, rows] = scanning.pixels;
    let orders = Order::both(scanning).map(|order| {
        let Order { heading, way, holes, overlaps, .. } = &order;
        format!("{heading}: {way}\n  {holes}\n  {overlaps}\n  {}", order.total)
    });
    format!("{}, in a picture of {columns} × {rows} pixels\n\n{}", subject(scanning), orders.join("\n\n"))
}

/// What is scanned.
pub(super) fn subject(scanning: &Scanning) -> String {
    let Scanning { object, part, texels: [columns, rows], .. } = scanning;
    format!("the picture on “{object}” ({part}), {columns} × {rows} texels")
}

/// One of the two orders in words.
pub(super) struct Order<'a> {
    pub scan: &'a Scan,
    pub heading: &'static str,
    /// From where to where, by which maps.
    pub way: &'static str,
    pub holes: String,
    pub overlaps: String,
    pub total: String,
}

impl<'a> Order<'a> {
    /// Texture scanning and inverse scanning.
    pub fn both(scanning: &'a Scanning) -> [Self; 2] {
        let Scanning { forward, inverse, .. } = scanning;
        let carried: u64 = forward.painted.iter().map(|times| u64::from(*times)).sum();
        let covered = scanning.covered();
        let order = |scan: &'a Scan, heading, way, total| Self {
            scan,
            heading,
            way,
            holes: match scan.holes(inverse) {
                0 => "no holes".to_owned(),
                holes => format!("{}: no texel comes to them", count(holes, "hole")),
            },
            overlaps: match (scan.overlaps(), scan.painted.iter().max()) {
                (0, _) | (_, None) => "no pixel painted more than once".to_owned(),
                (overlaps, Some(most)) => {
                    format!("{} painted more than once, up to {most} times", count(overlaps, "pixel"))
                }
            },
            total,
        };
        [
            order(
                forward,
                "Texture scanning, texel by texel",
                "(s, t) → (u, v) by M_T → pixel by M_VP",
                format!("{carried} texels carried to a patch of {}", count(covered, "pixel")),
            ),
            order(
                inverse,
                "Inverse scanning, pixel by pixel",
                "pixel → (u, v) by M_VP⁻¹ → (s, t) by M_T⁻¹",
                format!("each of {} painted once", count(covered, "pixel")),
            ),
        ]
    }
}
