//! The 256 colours that a drawing needs most.
//!
//! Drawings have a few colours that fill nearly all of them, which must stay exact, and thousands where edges are smoothed,
//! which may be rounded. The commonest colours are kept; the others are cut into boxes at their medians (Heckbert 1982), and each
//! box becomes its mean.

use std::collections::BTreeMap;

/// Colours that stay exact. More would leave too few for smooth edges, fewer would round flat areas.
const KEPT: usize = 96;

/// Colours altogether.
const ALL: usize = 256;

type Rgb = [u8; 3];

/// How often each colour occurs.
#[derive(Default)]
pub struct Histogram(BTreeMap<Rgb, u64>);

impl Histogram {
    /// Counts the pixels of a picture: red, green, blue and opacity, which is left out.
    pub fn add(&mut self, rgba: &[u8]) {
        // Runs of one colour are counted at once: most of a drawing is its ground.
        for run in rgba.as_chunks::<4>().0.chunk_by(|a, b| a == b) {
            let [r, g, b, _] = run[0];
            *self.0.entry([r, g, b]).or_default() += run.len() as u64;
        }
    }

    /// The colours to paint with.
    pub fn quantised(&self) -> Quantised {
        let mut colours: Vec<(Rgb, u64)> = self.0.iter().map(|(&colour, &count)| (colour, count)).collect();
        // Of equally common ones the darkest first, so that the order is fixed.
        colours.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(&b.0)));
        if colours.len() <= ALL {
            return Quantised::of(colours.into_iter().map(|(colour, _)| colour).collect());
        }
        let rest = colours.split_off(KEPT);
        let mut kept: Vec<Rgb> = colours.into_iter().map(|(colour, _)| colour).collect();
        kept.extend(boxes(rest, ALL - KEPT).iter().map(|colours| mean(colours)));
        Quantised::of(kept)
    }
}

/// The colours cut into so many boxes, each time the one that has most to lose.
fn boxes(colours: Vec<(Rgb, u64)>, count: usize) -> Vec<Vec<(Rgb, u64)>> {
    let mut boxes = vec![colours];
    while boxes.len() < count {
        let loss = |colours: &Vec<(Rgb, u64)>| {
            let (_, extent) = longest(colours);
            u64::from(extent) * u64::from(extent) * weight(colours)
        };
        let Some(at) = (0..boxes.len()).filter(|&i| boxes[i].len() > 1).max_by_key(|&i| (loss(&boxes[i]), i)) else {
            break;
        };
        let mut cut = boxes.swap_remove(at);
        let (channel, _) = longest(&cut);
        cut.sort_by_key(|(colour, _)| (colour[channel], *colour));
        let half = weight(&cut) / 2;
        let mut seen = 0;
        let middle = cut.iter().position(|(_, count)| {
            seen += count;
            seen > half
        });
        let upper = cut.split_off(middle.unwrap_or(1).clamp(1, cut.len() - 1));
        boxes.extend([cut, upper]);
    }
    boxes
}

/// The channel in which the colours lie farthest apart, and how far.
fn longest(colours: &[(Rgb, u64)]) -> (usize, u8) {
    let extent = |channel: usize| {
        let values = colours.iter().map(|(colour, _)| colour[channel]);
        values.clone().max().unwrap_or(0) - values.min().unwrap_or(0)
    };
    // Of equally long ones green, which the eye tells apart best.
    [1, 0, 2]
        .into_iter()
        .map(|channel| (channel, extent(channel)))
        .rev()
        .max_by_key(|(_, extent)| *extent)
        .unwrap_or((1, 0))
}

fn weight(colours: &[(Rgb, u64)]) -> u64 {
    colours.iter().map(|(_, count)| count).sum()
}

fn mean(colours: &[(Rgb, u64)]) -> Rgb {
    let whole = weight(colours).max(1);
    let channel = |i: usize| {
        let sum: u64 = colours.iter().map(|(colour, count)| u64::from(colour[i]) * count).sum();
        u8::try_from((sum + whole / 2) / whole).unwrap_or(u8::MAX)
    };
    std::array::from_fn(channel)
}

/// At most 256 colours, and for any colour the nearest of them.
pub struct Quantised {
    colours: Vec<Rgb>,
}

impl Quantised {
    fn of(mut colours: Vec<Rgb>) -> Self {
        colours.sort_unstable();
        colours.dedup();
        Self { colours }
    }

    /// The nearest colour there is.
    pub fn nearest(&self, colour: Rgb) -> Rgb {
        if self.colours.binary_search(&colour).is_ok() {
            return colour;
        }
        // Green counts most for the eye and blue least.
        let distance = |other: &&Rgb| -> u32 {
            let apart = |i: usize| u32::from(colour[i].abs_diff(other[i])).pow(2);
            3 * apart(0) + 6 * apart(1) + apart(2)
        };
        self.colours.iter().min_by_key(distance).copied().unwrap_or(colour)
    }

    /// Gives every pixel of a picture the nearest colour, and makes it opaque.
    pub fn replace(&self, rgba: &mut [u8]) {
        let mut known: BTreeMap<Rgb, Rgb> = BTreeMap::new();
        let mut last = None;
        for pixel in rgba.as_chunks_mut::<4>().0 {
            let colour = [pixel[0], pixel[1], pixel[2]];
            let nearest = match last {
                Some((before, nearest)) if before == colour => nearest,
                _ => *known.entry(colour).or_insert_with(|| self.nearest(colour)),
            };
            last = Some((colour, nearest));
            *pixel = [nearest[0], nearest[1], nearest[2], 255];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels(colours: impl Iterator<Item = Rgb>) -> Vec<u8> {
        colours.flat_map(|[r, g, b]| [r, g, b, 255]).collect()
    }

    #[test]
    fn few_colours_stay_as_they_are() {
        let picture = pixels((0..=255).map(|i| [i, 255 - i, 7]));
        let mut histogram = Histogram::default();
        histogram.add(&picture);
        let mut replaced = picture.clone();
        histogram.quantised().replace(&mut replaced);
        assert_eq!(replaced, picture);
    }

    #[test]
    fn of_many_colours_the_common_stay_exact_and_the_others_move_little() {
        let ground = [251, 250, 249];
        let ramp = (0..4096_u32).map(|i| {
            let part = |shift: u32| u8::try_from((i >> shift & 15) * 17).unwrap();
            [part(0), part(4), part(8)]
        });
        let picture = pixels(std::iter::repeat_n(ground, 100_000).chain(ramp));
        let mut histogram = Histogram::default();
        histogram.add(&picture);
        let colours = histogram.quantised();
        assert!(colours.colours.len() <= 256);
        assert_eq!(colours.nearest(ground), ground);
        let mut replaced = picture.clone();
        colours.replace(&mut replaced);
        let error: f64 = picture.iter().zip(&replaced).map(|(a, b)| f64::from(a.abs_diff(*b))).sum();
        // 160 boxes cut a cube of 16³ colours into pieces of some 3 × 3 × 3: most are within 17 of their middle.
        assert!(error / (4096.0 * 3.0) < 17.0, "{}", error / (4096.0 * 3.0));
    }

    #[test]
    fn the_same_picture_gives_the_same_colours_in_whatever_order_it_is_counted() {
        let forward: Vec<Rgb> =
            (0..2000_u32).map(|i| [i % 251, i / 8 % 256, i * 7 % 256].map(|c| u8::try_from(c).unwrap())).collect();
        let mut backward = forward.clone();
        backward.reverse();
        let colours = |list: Vec<Rgb>| {
            let mut histogram = Histogram::default();
            histogram.add(&pixels(list.into_iter()));
            histogram.quantised().colours
        };
        assert_eq!(colours(forward), colours(backward));
    }
}
