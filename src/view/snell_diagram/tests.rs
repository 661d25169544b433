//! Tests of Snell's diagram: true angles, Fresnel's known values, readable at every size.

use super::*;
use crate::view::drawing::{Form, Spot};
use crate::view::readable::assert_readable;
use crate::view::sample::{Sketch, every_kind};

fn interface(n1: f64, n2: f64, theta1: f64) -> What {
    let sine = n1 / n2 * theta1.to_radians().sin();
    let theta2 = (sine <= 1.0).then(|| sine.asin().to_degrees());
    What::Snell {
        n1,
        n2,
        theta1,
        theta2,
        critical: (n1 >= n2).then(|| (n2 / n1).asin().to_degrees()),
        total_internal_reflection: theta2.is_none(),
        refracted: theta2.map(|_| [0.0, 0.0, -1.0]),
        reflectance: if theta2.is_some() { 0.1 } else { 1.0 },
    }
}

fn alone(what: What) -> RayTree {
    let mut sketch = Sketch::new();
    sketch.note(what);
    sketch.finish()
}

/// The straight lines from point to point that have two ends.
fn lines(drawing: &Drawing) -> Vec<[Spot; 2]> {
    let line = |form: &Form| match form {
        Form::Line { points, .. } if points.len() == 2 => Some([points[0], points[1]]),
        _ => None,
    };
    drawing.marks.iter().filter_map(|mark| line(&mark.form)).collect()
}

/// Degrees from the downward vertical.
fn from_vertical([from, to]: [Spot; 2]) -> f64 {
    (to[0] - from[0]).abs().atan2((to[1] - from[1]).abs()).to_degrees()
}

#[test]
fn rays_are_drawn_at_their_true_angles() {
    for (n1, n2, theta1) in [(1.0, 1.5, 30.0), (1.5, 1.0, 41.0), (1.0, 2.4, 72.5), (1.33, 1.33, 12.0)] {
        let tree = alone(interface(n1, n2, theta1));
        let drawing = snell_diagram(&tree, 0, [380.0, 300.0], Theme::Light).unwrap();
        let theta2 = (n1 / n2 * f64::sin(f64::to_radians(theta1))).asin().to_degrees();
        let angles: Vec<f64> = lines(&drawing).into_iter().map(from_vertical).collect();
        let count = |angle: f64| angles.iter().filter(|found| (**found - angle).abs() < 1e-9).count();
        assert!(count(theta1) >= 2, "θ₁ = {theta1}: {angles:?}");
        assert!(count(theta2) >= 1, "θ₂ = {theta2}: {angles:?}");
    }
}

#[test]
fn beyond_the_critical_angle_nothing_is_drawn_below_the_interface_but_the_normal() {
    let tree = alone(interface(1.5, 1.0, 60.0));
    let drawing = snell_diagram(&tree, 0, [380.0, 300.0], Theme::Dark).unwrap();
    assert!(drawing.description.contains("60°") && drawing.description.contains("41.81°"), "{}", drawing.description);
    assert!(drawing.description.contains("totally"));
    assert!(drawing.texts().all(|text| !text.text.contains("refracted")));
    assert!(drawing.texts().any(|text| text.text.contains("critical")));
}

#[test]
fn fresnels_shares_are_those_of_the_textbook() {
    let tree = alone(interface(1.0, 1.5, 30.0));
    let story = Story::of(&tree, 0).unwrap();
    let interface = read(&story, 0).unwrap();
    // At normal incidence ((n₁ − n₂) / (n₁ + n₂))², at grazing incidence everything, at Brewster's angle no R_p.
    assert!((fresnel::shares(&interface, 0.0)[0] - 0.04).abs() < 1e-15);
    assert!((fresnel::shares(&interface, 90.0)[0] - 1.0).abs() < 1e-12);
    assert!((interface.brewster() - 56.309_932_474_020_21).abs() < 1e-12);
    assert!(fresnel::shares(&interface, interface.brewster())[2] < 1e-30);
}

#[test]
fn a_hit_and_the_rays_that_it_sent_show_its_interface() {
    let tree = every_kind();
    let shown = |selected: EventId| snell_diagram(&tree, selected, [600.0, 300.0], Theme::Light);
    let is = |is_it: &dyn Fn(&What) -> bool| tree.events.iter().find(|event| is_it(&event.what)).unwrap().id;
    let snell = is(&|what| matches!(what, What::Snell { .. }));
    let hit = is(&|what| matches!(what, What::Hit { .. }));
    let refracted = is(&|what| matches!(what, What::Ray { ray: RayKind::Refracted, .. }));
    let drawing = shown(snell).unwrap();
    assert_eq!(shown(hit).as_ref(), Some(&drawing));
    assert_eq!(shown(refracted).as_ref(), Some(&drawing));
    assert!(drawing.marks.iter().any(|mark| mark.event == Some(refracted)));
    for told in ["air", "glass", "30°", "19.47°", "4 %", "56.31°"] {
        assert!(drawing.description.contains(told), "{told}: {}", drawing.description);
    }
}

#[test]
fn nothing_covers_anything_at_any_size() {
    for (n1, n2, theta1) in [(1.0, 1.5, 0.0), (1.0, 1.5, 30.0), (1.5, 1.0, 41.0), (1.5, 1.0, 75.0), (1.0, 2.4, 89.9)] {
        let tree = alone(interface(n1, n2, theta1));
        for size in [[300.0, 200.0], [560.0, 360.0], [900.0, 600.0], [180.0, 700.0], [16.0, 16.0], [f64::NAN, 9.0]] {
            let drawing = snell_diagram(&tree, 0, size, Theme::Light).unwrap();
            assert_readable(&drawing, &format!("{n1} to {n2} at {theta1}° in {size:?}"));
        }
    }
}
