//! Tests of the drawing of light taken apart.

use super::*;
use crate::optics::{Dispersion, bands};
use crate::record::Wavelength;
use crate::view::readable::assert_readable;
use crate::view::sample::Sketch;
use crate::view::{Form, Spot};

const SIZE: [f64; 2] = [620.0, 380.0];
const ANGLE: f64 = 63.0;

/// Light that comes from air into a glass.
fn wavelengths(count: u32, glass: &Dispersion) -> Vec<Wavelength> {
    let one = |band: crate::optics::Band| {
        let n2 = glass.index(band.nanometres);
        Wavelength {
            number: band.number,
            of: band.of,
            nanometres: band.nanometres,
            band: band.width(),
            share: band.share.to_array(),
            n1: 1.0,
            n2,
            theta1: ANGLE,
            theta2: Some((ANGLE.to_radians().sin() / n2).asin().to_degrees()),
            direction: Some([0.0, 0.0, -1.0]),
            reflectance: 0.1,
        }
    };
    bands(count, 0.5).map(one).collect()
}

/// The tree of one interface; its wavelengths are the events from 1 on.
fn tree(all: Vec<Wavelength>) -> RayTree {
    let mut sketch = Sketch::new();
    sketch.with(What::Step { number: 5, title: String::new() }, |s| {
        for one in all {
            s.note(What::Wavelength(one));
        }
    });
    sketch.finish()
}

fn drawn(all: Vec<Wavelength>, selected: EventId, size: [f64; 2], theme: Theme) -> Drawing {
    event_plot(None, &tree(all), selected, size, theme).unwrap()
}

/// The ends of all lines that stand for events, by event.
fn rays(drawing: &Drawing) -> Vec<(EventId, Spot, Spot)> {
    let lines = drawing.marks.iter().filter_map(|mark| match &mark.form {
        Form::Line { points, stroke } if stroke.width == 1.7 || stroke.width == 3.0 => {
            Some((mark.event?, points[0], points[points.len() - 1]))
        }
        _ => None,
    });
    lines.collect()
}

#[test]
fn the_fan_is_the_one_that_was_looked_at() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_suffix("fan");
    settings.set_description("the drawing of white light taken apart by flint glass");
    let drawing = drawn(wavelengths(6, &Dispersion::SF11), 3, SIZE, Theme::Light);
    settings.bind(|| insta::assert_snapshot!("event_plot", drawing.to_text()));
}

#[test]
fn each_ray_goes_on_at_its_own_angle_as_much_larger_as_the_drawing_says() {
    for (glass, times) in
        [(Dispersion::DIAMOND, 50.0), (Dispersion::SF11, 20.0), (Dispersion::Cauchy([1.0, 0.2, 0.0]), 1.0)]
    {
        let all = wavelengths(8, &glass);
        let drawing = drawn(all.clone(), 2, SIZE, Theme::Dark);
        let rays = rays(&drawing);
        assert_eq!(rays.len(), all.len());
        let own = |event: EventId| all[event as usize - 1].theta2.unwrap();
        let middle = f64::midpoint(own(1), own(8));
        for (event, [x1, y1], [x2, y2]) in rays {
            let angle = (x2 - x1).atan2(y2 - y1).to_degrees();
            let expected = middle + times * (own(event) - middle);
            assert!((angle - expected).abs() < 1e-9, "{angle} is not {expected}");
        }
        let said: Vec<&str> = drawing.texts().map(|text| text.text.as_str()).collect();
        let says_so = said.join(" ").contains(&format!("drawn {times} times as large"));
        assert_eq!(says_so, times > 1.0, "{said:?}");
    }
}

#[test]
fn what_is_reflected_as_a_whole_is_counted_and_not_drawn() {
    let mut all = wavelengths(5, &Dispersion::BK7);
    all[0].theta2 = None;
    let drawing = drawn(all, 1, SIZE, Theme::Light);
    assert_eq!(rays(&drawing).len(), 4);
    let text: Vec<&str> = drawing.texts().map(|text| text.text.as_str()).collect();
    assert!(text.join(" ").contains("1 of 5 are reflected as a whole"), "{text:?}");
}

#[test]
fn the_fan_is_readable_at_any_size_and_with_any_number_of_rays() {
    let sizes = [[16.0, 16.0], [90.0, 60.0], [160.0, 400.0], [300.0, 150.0], [420.0, 260.0], SIZE, [1600.0, 300.0]];
    for count in [1, 2, 16, 256] {
        for size in sizes {
            let drawing = drawn(wavelengths(count, &Dispersion::WATER), 1, size, Theme::Dark);
            assert_readable(&drawing, &format!("{count} in {size:?}"));
        }
    }
}

#[test]
fn a_fan_of_nonsense_does_no_harm() {
    for by in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e18, 0.0, 1e-300] {
        let mut all = wavelengths(4, &Dispersion::BK7);
        (all[0].n2, all[1].nanometres, all[2].theta2, all[3].theta1) = (by, by, Some(by), by);
        for selected in 1..=4 {
            assert_readable(
                &drawn(all.clone(), selected, [420.0, 300.0], Theme::Light),
                &format!("{by} at {selected}"),
            );
        }
    }
}
