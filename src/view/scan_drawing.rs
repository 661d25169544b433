//! Texture scanning beside inverse scanning: the pixels of both pictures, with holes and overlaps.

use super::drawing::{Anchor, Drawing, Form, Frame, Spot, Stroke, Text};
use super::fonts::{Face, text_width};
use super::labels::{Label, Placer, shortened};
use super::palette::{Colour, Palette, Theme};
use super::scan_text::{Order, subject};
use super::scene_colour::{ink_on, shown};
use crate::texture::image::Scan;
use crate::trace::Scanning;

/// Sizes in points.
const TITLE: f64 = 15.0;
const HEADING: f64 = 13.0;
const TEXT: f64 = 12.0;
const LINE: f64 = 19.0;
const MARGIN: f64 = 16.0;
const SAMPLE: f64 = 13.0;

/// Pixels of the picture from `low` up to but without `high`.
#[derive(Clone, Copy)]
struct Window {
    low: [u32; 2],
    high: [u32; 2],
}

/// Both orders side by side: the part of the picture that is painted, pixel by pixel, with the counts below.
#[must_use]
pub fn scan_drawing(scanning: &Scanning, size: [f64; 2], theme: Theme) -> Drawing {
    let palette = theme.palette();
    let drawing = Drawing::new(size, palette.ground);
    let mut sheet = Sheet { placer: Placer::new(drawing.frame()), drawing, palette };
    let [width, height] = [sheet.drawing.width, sheet.drawing.height];
    let [columns, rows] = scanning.pixels;
    let title = format!("From {} to {columns} × {rows} pixels", subject(scanning));
    sheet.write(&title, [MARGIN, MARGIN + 0.5 * TITLE], width - 2.0 * MARGIN, (TITLE, Face::Bold), palette.ink);
    let panel = 0.5 * (width - 3.0 * MARGIN);
    for (order, left) in Order::both(scanning).into_iter().zip([MARGIN, 2.0 * MARGIN + panel]) {
        let room = Frame { low: [left, MARGIN + 2.2 * TITLE], high: [left + panel, height - MARGIN] };
        sheet.panel(&order, scanning, room);
    }
    sheet.drawing
}

/// A drawing in the making.
struct Sheet {
    drawing: Drawing,
    placer: Placer,
    palette: &'static Palette,
}

impl Sheet {
    fn panel(&mut self, order: &Order, scanning: &Scanning, room: Frame) {
        let [left, mut y] = room.low;
        let width = room.size()[0];
        for (text, size, face, colour) in
            [(order.heading, HEADING, Face::Bold, self.palette.ink), (order.way, TEXT, Face::Sans, self.palette.faint)]
        {
            y += 0.5 * LINE;
            self.write(text, [left, y], width, (size, face), colour);
            y += 0.5 * LINE;
        }
        let grid = Frame { low: [left, y + 8.0], high: [room.high[0], room.high[1] - 3.0 * LINE - 8.0] };
        let below = self.grid(order.scan, scanning, &grid).unwrap_or(grid.low[1]);
        self.legend(order, scanning, [left, below + 8.0 + 0.5 * LINE], width);
    }

    /// The pixels; gives where they end below. Nothing is drawn where there is no room to tell them apart.
    fn grid(&mut self, scan: &Scan, scanning: &Scanning, room: &Frame) -> Option<f64> {
        /// Smaller pixels would be one grey.
        const SMALLEST: f64 = 1.5;
        let window = painted_window(scanning)?;
        let [columns, rows] = [0, 1].map(|i| f64::from(window.high[i] - window.low[i]));
        let [width, height] = room.size();
        // On half points, so that every pixel is as sharp as every other.
        let side = (2.0 * (width / columns).min(height / rows)).floor() / 2.0;
        if side < SMALLEST {
            return None;
        }
        let corner = room.low.map(|x| (2.0 * x).round() / 2.0);
        let whole = Frame { low: corner, high: [corner[0] + columns * side, corner[1] + rows * side] };
        let rim = Some(Stroke::solid(self.palette.faint, 1.0));
        self.drawing.put(Form::Rect { frame: whole, fill: Some(self.palette.grid), stroke: rim }, None);
        for row in window.low[1]..window.high[1] {
            for column in window.low[0]..window.high[0] {
                let place = row as usize * scan.width as usize + column as usize;
                let low = [
                    corner[0] + f64::from(column - window.low[0]) * side,
                    corner[1] + f64::from(row - window.low[1]) * side,
                ];
                // What is left free parts the pixels.
                let frame = Frame { low, high: low.map(|x| x + side - if side > 4.0 { 0.5 } else { 0.0 }) };
                match (scan.painted[place], scanning.inverse.painted[place]) {
                    (0, 0) => {}
                    (0, _) => self.hole(&frame),
                    (times, _) => self.pixel(&frame, shown(scan.colours[place].to_array()), times),
                }
            }
        }
        Some(whole.high[1])
    }

    fn pixel(&mut self, frame: &Frame, colour: Colour, times: u32) {
        self.drawing.put(Form::Rect { frame: *frame, fill: Some(colour), stroke: None }, None);
        if times > 1 {
            self.times(frame, colour, times);
        }
    }

    /// How often a pixel was painted, or a dot where there is no room for a number.
    fn times(&mut self, frame: &Frame, colour: Colour, times: u32) {
        /// Smaller digits cannot be read.
        const SMALLEST: f64 = 5.0;
        let [width, height] = frame.size();
        let ink = ink_on(colour);
        let text = times.to_string();
        let by_width = (width - 0.5) / text_width(&text, 1.0, Face::Bold);
        let size = by_width.min(0.85 * height).min(TEXT);
        if size >= SMALLEST {
            let [x, y] = frame.middle();
            let at = [x, y + Text::baseline_below_middle(size)];
            let text = Text { at, text, anchor: Anchor::Middle, size, colour: ink, face: Face::Bold, halo: None };
            self.drawing.put(Form::Text(text), None);
        } else if width >= 3.0 {
            let radius = 0.2 * width;
            self.drawing.put(Form::Circle { centre: frame.middle(), radius, fill: Some(ink), stroke: None }, None);
        }
    }

    /// A pixel that was left out: outlined and crossed out where there is room for that.
    fn hole(&mut self, frame: &Frame) {
        let colour = self.palette.bad;
        if frame.size()[0] < 4.0 {
            self.drawing.put(Form::Rect { frame: *frame, fill: Some(colour), stroke: None }, None);
            return;
        }
        let stroke = Stroke::solid(colour, 0.8);
        let inner = frame.grown(-0.6);
        self.drawing.put(Form::Rect { frame: inner, fill: Some(self.palette.ground), stroke: Some(stroke) }, None);
        let points = vec![[inner.low[0], inner.high[1]], [inner.high[0], inner.low[1]]];
        self.drawing.put(Form::Line { points, stroke }, None);
    }

    /// Holes, overlaps and all pixels, a line each.
    fn legend(&mut self, order: &Order, scanning: &Scanning, [left, top]: Spot, width: f64) {
        let has = [order.scan.holes(&scanning.inverse) > 0, order.scan.overlaps() > 0, false];
        for (i, text) in [&order.holes, &order.overlaps, &order.total].into_iter().enumerate() {
            let y = top + i as f64 * LINE;
            let indent = if has.contains(&true) { SAMPLE + 7.0 } else { 0.0 };
            let at = [left + indent, y];
            let colour = if has[i] { self.palette.ink } else { self.palette.faint };
            if !self.write(text, at, width - indent, (TEXT, Face::Sans), colour) || !has[i] {
                continue;
            }
            let middle = [left + 0.5 * SAMPLE, y];
            let sample = Frame { low: middle, high: middle }.grown(0.5 * SAMPLE);
            if i == 0 {
                self.hole(&sample);
            } else {
                self.pixel(&sample, self.palette.categories[0], 2);
            }
        }
    }

    /// Writes a line with its middle at the height of `at`, shortened to `width`; whether there was room.
    fn write(&mut self, text: &str, at: Spot, width: f64, (size, face): (f64, Face), colour: Colour) -> bool {
        let text = shortened(text, width, size, face);
        let text = Label::new(text, size, colour).face(face).at(at, Anchor::Start, None);
        !text.text.is_empty() && self.placer.put_at(&mut self.drawing, text, None)
    }
}

/// The pixels that either order painted, with one more around them where the picture goes on.
fn painted_window(scanning: &Scanning) -> Option<Window> {
    let [columns, rows] = scanning.pixels;
    let is_painted = |row: u32, column: u32| {
        let place = row as usize * columns as usize + column as usize;
        scanning.forward.painted[place] > 0 || scanning.inverse.painted[place] > 0
    };
    let any_in_row = |row: &u32| (0..columns).any(|column| is_painted(*row, column));
    let any_in_column = |column: &u32| (0..rows).any(|row| is_painted(row, *column));
    let (left, top) = ((0..columns).find(any_in_column)?, (0..rows).find(any_in_row)?);
    let (right, bottom) = ((0..columns).rfind(any_in_column)?, (0..rows).rfind(any_in_row)?);
    Some(Window {
        low: [left, top].map(|x| x.saturating_sub(1)),
        high: [(right + 2).min(columns), (bottom + 2).min(rows)],
    })
}

#[cfg(test)]
mod tests {
    use super::super::scan_text;
    use super::*;
    use crate::texture::image::Texels;
    use glam::DVec2;

    const SIZE: [f64; 2] = [700.0, 420.0];

    /// Six texels side by side on twelve pixels: the first two each take four, the last four share four.
    fn sample() -> Scanning {
        let grey = |i: u8| [f32::from(i) / 6.0, 0.5, 0.5];
        let texels = Texels::from_linear(6, 1, (0..6).map(grey).collect()).unwrap();
        let across = |s: f64| if s < 1.0 / 3.0 { 24.0 * s } else { 8.0 + 3.0 * (s - 1.0 / 3.0) };
        let back = |x: f64| if x < 8.0 { x / 24.0 } else { 1.0 / 3.0 + (x - 8.0) / 3.0 };
        let pixels = [12, 3];
        let in_row = |y: f64| (1.0..2.0).contains(&y);
        Scanning {
            object: "strip".into(),
            part: "surface".into(),
            texels: [6, 1],
            pixels,
            forward: Scan::forward(&texels, pixels, |st| Some(DVec2::new(across(st.x), 1.5))),
            inverse: Scan::inverse(&texels, pixels, |at| in_row(at.y).then(|| DVec2::new(back(at.x), 0.5))),
        }
    }

    #[test]
    fn the_drawing_is_the_one_that_was_looked_at() {
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("../../snapshots");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.set_description("six texels on a strip of pixels, in both orders");
        let drawing = scan_drawing(&sample(), SIZE, Theme::Light);
        settings.bind(|| insta::assert_snapshot!("scan_drawing", drawing.to_text()));
    }

    #[test]
    fn the_text_counts_what_a_hand_counts() {
        // Texels 0 and 1 come to pixels 2 and 6; texels 2 to 5 to pixels 8 to 9, so that 2 pixels are painted by 4.
        let text = scan_text(&sample());
        let texture = sample().forward;
        assert_eq!(texture.painted[12..24], [0, 0, 1, 0, 0, 0, 1, 0, 2, 2, 0, 0]);
        assert!(
            text.contains("6 holes: no texel comes to them\n  2 pixels painted more than once, up to 2 times"),
            "{text}"
        );
        assert!(
            text.ends_with("no holes\n  no pixel painted more than once\n  each of 10 pixels painted once"),
            "{text}"
        );
    }

    #[test]
    fn every_hole_is_outlined_and_every_overlap_has_its_number() {
        let drawing = scan_drawing(&sample(), SIZE, Theme::Dark);
        let bad = Theme::Dark.palette().bad;
        let outlined = drawing
            .marks
            .iter()
            .filter(|mark| matches!(&mark.form, Form::Rect { stroke: Some(stroke), .. } if stroke.colour == bad));
        // One more of each in the legend.
        assert_eq!(outlined.count(), 6 + 1);
        assert_eq!(drawing.texts().filter(|text| text.text == "2").count(), 2 + 1);
    }

    #[test]
    fn no_text_covers_another_and_nothing_is_cut_off_at_any_size() {
        for size in [[16.0, 16.0], [90.0, 60.0], [160.0, 400.0], [300.0, 150.0], SIZE, [1600.0, 300.0]] {
            let drawing = scan_drawing(&sample(), size, Theme::Light);
            let canvas = drawing.frame();
            for mark in &drawing.marks {
                if let Form::Rect { frame, .. } = &mark.form {
                    assert!(canvas.holds(frame), "{frame:?} is cut off in {size:?}");
                }
            }
            let texts: Vec<&Text> = drawing.texts().collect();
            for (i, text) in texts.iter().enumerate() {
                assert!(canvas.holds(&text.frame()), "“{}” is cut off in {size:?}", text.text);
                for other in &texts[..i] {
                    assert!(!text.frame().overlaps(&other.frame()), "“{}” covers “{}”", text.text, other.text);
                }
            }
        }
    }
}
