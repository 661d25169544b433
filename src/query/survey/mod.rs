//! Surveys: a quantity of every pixel of a picture, coarse to fine.

mod cell;
mod quantity;

pub use quantity::Quantity;

use super::passes::{Grid, ask_all};
use crate::laboratory::{Times, map_of_digits, map_of_times, time_pixels};
use crate::scene::{Scene, Sights};
use crate::trace::{Progress, Tracer};
use crate::view::{HeatMap, HeatScale, brief};
use cell::{Cell, NOTHING};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::time::Duration;

/// Says how much time has passed.
pub type Clock<'a> = &'a dyn Fn() -> Duration;

/// A quantity of every pixel of a scene, as far as it is known.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Survey {
    /// What it is.
    pub quantity: Quantity,
    grid: Grid<Cell>,
    times: Option<Times>,
}

/// Surveys a scene, coarse to fine from blocks of the given side. `on_pass` sees what is known after each pass. None if it was
/// cancelled before the last. The clock is asked only for times, which are taken on one thread.
pub fn survey(
    scene: &Scene,
    quantity: Quantity,
    side: u32,
    clock: Clock,
    progress: &Progress,
    mut on_pass: impl FnMut(Survey),
) -> Option<Survey> {
    let image = scene.image;
    if quantity == Quantity::Time {
        let known = |times: &Times| {
            let grid = Grid {
                size: [image.width, image.height],
                cells: times.values.iter().map(|&ns| [ns, 0.0, 0.0]).collect(),
                side: times.side,
            };
            Survey { quantity, grid, times: Some(times.clone()) }
        };
        let times = time_pixels(scene, side, clock, progress, &mut |times| on_pass(known(times)))?;
        return Some(known(&times));
    }
    let sights = scene.shortcuts.sights.then(|| Sights::new(scene));
    let tracer = sights.as_ref().map_or(Tracer::new(scene), |sights| Tracer::new(scene).with_sights(sights));
    let known = |grid: &Grid<Cell>| Survey { quantity, grid: grid.clone(), times: None };
    let ask = |pixel| cell::of(quantity, &tracer, pixel);
    let grid = ask_all(image, side, NOTHING, progress, ask, |grid| on_pass(known(grid)))?;
    Some(known(&grid))
}

impl Survey {
    /// The values, row by row from the top; not a number where there is nothing to tell. Of objects their places in the list.
    pub fn values(&self) -> impl Iterator<Item = f64> {
        self.grid.cells.iter().map(|cell| cell[0])
    }

    /// Whether every pixel was asked.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.grid.side == 1
    }

    /// The value of a pixel in words; none outside the picture. Where the pixel was not asked yet, that of its block.
    #[must_use]
    pub fn told(&self, scene: &Scene, pixel: [u32; 2]) -> Option<String> {
        let cell = self.grid.at(pixel)?;
        if cell[0].is_nan() {
            return Some("nothing is hit".to_owned());
        }
        let number = brief(cell[0]);
        Some(match self.quantity {
            Quantity::Rays => plural(cell[0], "ray"),
            Quantity::Tests => plural(cell[0], "test"),
            Quantity::Depth => format!("depth {number}"),
            Quantity::Time => format!("{number} ns"),
            Quantity::Error => format!("t ± {number}"),
            Quantity::Object => object(scene, cell[0]).to_owned(),
            Quantity::Normal => format!("normal {}", crate::view::brief_vector(cell)),
            Quantity::Digits if cell[0].is_infinite() => "a hit is lost or made up".to_owned(),
            Quantity::Digits => format!("{number} digits lost"),
        })
    }

    /// The map of it, with its legend.
    #[must_use]
    pub fn map(&self, scene: &Scene) -> HeatMap {
        let mut map = match (self.quantity, &self.times) {
            (Quantity::Time, Some(times)) => map_of_times(scene, times),
            (Quantity::Digits, _) => map_of_digits(scene, self.values().collect()),
            (Quantity::Object, _) => self.map_of_objects(scene),
            (Quantity::Normal, _) => self.map_of_normals(scene),
            _ => self.map_of_numbers(),
        };
        if !self.is_complete() {
            map.notes.push(format!("So far one pixel in {0} × {0}.", self.grid.side));
        }
        map
    }

    fn plain(&self, note: &str) -> HeatMap {
        HeatMap {
            title: self.quantity.title().to_owned(),
            notes: vec![note.to_owned()],
            size: self.grid.size.map(|side| side as usize),
            values: self.values().collect(),
            ..HeatMap::default()
        }
    }

    fn map_of_numbers(&self) -> HeatMap {
        let known = || self.values().filter(|value| value.is_finite());
        let most = known().fold(0.0, f64::max);
        let least = known().filter(|value| *value > 0.0).fold(f64::INFINITY, f64::min);
        let mean = known().sum::<f64>() / known().count().max(1) as f64;
        let mut map = self.plain(self.quantity.note());
        self.quantity.unit().clone_into(&mut map.unit);
        // Where the largest is many times the smallest, most pixels would have one colour on a linear scale.
        let is_wide = most > 30.0 * least;
        if self.quantity == Quantity::Error {
            map.scale = HeatScale::Log([least.min(most), most.max(f64::MIN_POSITIVE)]);
            (map.zero, map.nothing) = (Some("no error at all".to_owned()), Some("nothing is hit".to_owned()));
        } else {
            map.scale = if is_wide { HeatScale::Log([least, most]) } else { HeatScale::Linear([0.0, most.max(1.0)]) };
            map.zero = is_wide.then(|| "none".to_owned());
            map.notes.push(format!("{} on average.", brief(mean)));
        }
        map
    }

    /// The objects that are seen, by name, in the order of the list.
    fn map_of_objects(&self, scene: &Scene) -> HeatMap {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places in the list of objects")]
        let place = |value: f64| (!value.is_nan()).then_some(value as usize);
        let seen: Vec<usize> = self.values().filter_map(place).collect::<BTreeSet<_>>().into_iter().collect();
        let class = |value: f64| {
            let class = place(value).and_then(|place| seen.binary_search(&place).ok());
            class.map_or(f64::NAN, |class| class as f64)
        };
        let mut map = self.plain(self.quantity.note());
        map.scale = HeatScale::Kinds(seen.iter().map(|&place| scene.objects[place].name.clone()).collect());
        map.nothing = Some("nothing is hit".to_owned());
        map.values = self.values().map(class).collect();
        map
    }

    /// The normals as they are seen from the eye: to the right, up, and towards the eye.
    fn map_of_normals(&self, scene: &Scene) -> HeatMap {
        let camera = &scene.camera;
        let axes = [camera.right, camera.up, -camera.forward];
        let seen = |cell: &Cell| axes.map(|axis| axis.dot(glam::DVec3::from_array(*cell)));
        let mut map = self.plain(self.quantity.note());
        map.scale = HeatScale::Directions(self.grid.cells.iter().map(seen).collect());
        map.nothing = Some("nothing is hit".to_owned());
        map
    }
}

/// The name of an object by its place in the list.
fn object(scene: &Scene, place: f64) -> &str {
    let name = scene.objects.iter().zip(0_u32..).find(|(_, k)| f64::from(*k) == place);
    name.map_or("nothing", |(object, _)| object.name.as_str())
}

fn plural(count: f64, noun: &str) -> String {
    let s = if count == 1.0 { "" } else { "s" };
    format!("{} {noun}{s}", brief(count))
}
