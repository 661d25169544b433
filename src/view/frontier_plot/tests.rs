//! Tests of the plot: that it can be read, whatever the points are, and that it shows what is true.

use super::marker::staircase;
use super::*;
use crate::view::{Form, Text, png, svg};

const SIZE: [f64; 2] = [900.0, 640.0];

/// A scene with area lights, glass and textures as such scenes come out: a long flight of samples, and a crowd of settings
/// that change little.
fn crowded() -> FrontierPlot {
    let knobs = [
        (
            "arithmetic",
            vec![
                ("f32", 0.151, 0.041),
                ("f64", 0.158, 0.0212),
                ("adaptive", 0.187, 0.0211),
                ("double-double", 3.2, 0.0211),
            ],
        ),
        ("roots", vec![("textbook", 0.149, 0.0216), ("recentred", 0.159, 0.0212), ("certified", 0.188, 0.0211)]),
        (
            "search",
            vec![
                ("16", 0.171, 0.024),
                ("32", 0.178, 0.0217),
                ("64", 0.195, 0.0212),
                ("128", 0.224, 0.0211),
                ("certified", 0.186, 0.0211),
            ],
        ),
        ("samples", vec![("1", 0.0121, 0.083), ("4", 0.0475, 0.0419), ("16", 0.189, 0.0211), ("64", 0.741, 0.0106)]),
        ("lens_samples", vec![("1", 0.185, 0.0211), ("4", 0.73, 0.0131), ("16", 2.9, 0.0096), ("64", 11.6, 0.0088)]),
        (
            "depth",
            vec![
                ("0", 0.071, 0.31),
                ("1", 0.122, 0.118),
                ("2", 0.155, 0.052),
                ("4", 0.182, 0.0231),
                ("8", 0.188, 0.0211),
                ("16", 0.189, 0.0211),
            ],
        ),
        (
            "contribution",
            vec![("0", 0.201, 0.0208), ("0.001", 0.19, 0.0209), ("0.01", 0.184, 0.0212), ("0.1", 0.118, 0.034)],
        ),
        (
            "octaves",
            vec![
                ("1", 0.152, 0.048),
                ("2", 0.16, 0.031),
                ("4", 0.174, 0.0219),
                ("6", 0.188, 0.0211),
                ("8", 0.202, 0.0211),
            ],
        ),
        (
            "filter",
            vec![
                ("nearest", 0.165, 0.0298),
                ("bilinear", 0.17, 0.0262),
                ("trilinear", 0.178, 0.0234),
                ("ewa", 0.192, 0.0213),
                ("area", 0.231, 0.021),
            ],
        ),
    ];
    let mut plot = FrontierPlot {
        title: "still_life/table: what accuracy costs".to_owned(),
        notes: vec![
            "160 × 120 pixels, one thread. Each time is the median of 7, measured in turn with all others.".to_owned(),
        ],
        x_name: "time for the picture".to_owned(),
        y_name: "error: root mean square of linear RGB, against the reference".to_owned(),
        reference_error: 0.0023,
        ..FrontierPlot::default()
    };
    let standard = ("as it stands", None, 0.187, 0.0211);
    let mut rows = vec![standard];
    for (group, (knob, values)) in knobs.iter().enumerate() {
        plot.groups.push((*knob).to_owned());
        rows.extend(values.iter().map(|(value, seconds, error)| (*value, Some(group), *seconds, *error)));
    }
    plot.points = rows
        .into_iter()
        .map(|(value, group, seconds, error)| PlotPoint {
            name: group.map_or(value.to_owned(), |group| format!("{} {value}", plot.groups[group])),
            group,
            seconds,
            spread: 0.02 * seconds,
            error,
            is_standard: group.is_none(),
            ..PlotPoint::default()
        })
        .collect();
    plot.points[20].spread *= 6.0;
    plot.points[20].noisy = true;
    with_controls(&mut plot);
    mark_frontier(&mut plot);
    plot
}

/// A scene without chance, whose picture is the same with most settings.
fn exact() -> FrontierPlot {
    let mut plot = crowded();
    plot.reference_error = 0.0;
    plot.title = "hello/sphere: what accuracy costs".to_owned();
    for (k, point) in plot.points.iter_mut().enumerate() {
        let differs =
            point.name.ends_with("f32") || ["depth 0", "depth 1", "filter nearest"].contains(&point.name.as_str());
        point.error = if differs { point.error * 1e-4 } else { 0.0 };
        point.seconds = 0.02
            * (1.0 + 0.03 * (k as f64 * 7.0 % 11.0))
            * if point.name.contains("double-double") { 40.0 } else { 1.0 };
        point.spread = 0.01 * point.seconds;
    }
    mark_frontier(&mut plot);
    plot
}

fn with_controls(plot: &mut FrontierPlot) {
    plot.groups.push("shortcuts".to_owned());
    for (value, seconds) in [("none", 0.92), ("all", 0.188)] {
        plot.points.push(PlotPoint {
            name: format!("shortcuts {value}"),
            group: Some(plot.groups.len() - 1),
            seconds,
            spread: 0.004,
            is_control: true,
            ..PlotPoint::default()
        });
    }
}

fn mark_frontier(plot: &mut FrontierPlot) {
    let compared = plot.points.iter().filter(|point| !point.is_control);
    let places: Vec<_> = compared.map(|point| (point.seconds, point.error)).collect();
    for point in &mut plot.points {
        let own = (point.seconds, point.error);
        let beaten = places.iter().any(|other| other.0 <= own.0 && other.1 <= own.1 && *other != own);
        point.on_frontier = !beaten && !point.is_control;
    }
}

fn assert_readable(plot: &FrontierPlot, size: [f64; 2], theme: Theme) {
    let drawing = frontier_plot(plot, size, theme);
    let texts: Vec<&Text> = drawing.texts().collect();
    for (k, text) in texts.iter().enumerate() {
        let frame = text.frame();
        assert!(drawing.frame().holds(&frame), "{size:?}: {text:?} is cut off");
        for other in &texts[..k] {
            assert!(!other.frame().overlaps(&frame), "{size:?}: {:?} covers {:?}", text.text, other.text);
        }
    }
    for mark in &drawing.marks {
        let Form::Area { rings, .. } = &mark.form else { continue };
        let middle = middle_of(&rings[0]);
        let covered = texts.iter().find(|text| text.frame().contains(middle));
        assert!(covered.is_none(), "{size:?}: {:?} covers a marker", covered.map(|text| &text.text));
    }
}

fn middle_of(ring: &[Spot]) -> Spot {
    std::array::from_fn(|i| ring.iter().map(|corner| corner[i]).sum::<f64>() / ring.len() as f64)
}

#[test]
fn no_text_covers_another_or_a_marker_and_none_is_cut_off() {
    for plot in [crowded(), exact()] {
        for size in [SIZE, [760.0, 560.0], [560.0, 420.0]] {
            assert_readable(&plot, size, Theme::Light);
        }
    }
}

#[test]
fn every_point_is_named() {
    for plot in [crowded(), exact()] {
        let drawing = frontier_plot(&plot, SIZE, Theme::Light);
        let said: Vec<&str> = drawing.texts().map(|text| text.text.as_str()).collect();
        for point in &plot.points {
            let value = point.name.rsplit(' ').next().unwrap();
            let knob = point.group.map_or("", |group| plot.groups[group].as_str());
            assert!(said.iter().any(|text| text.contains(knob) && text.contains(value)), "{}", point.name);
        }
    }
}

#[test]
fn a_click_on_a_marker_finds_its_point() {
    let plot = crowded();
    let drawing = frontier_plot(&plot, SIZE, Theme::Dark);
    for name in ["samples 1", "lens_samples 64", "depth 0", "shortcuts none"] {
        let wanted = plot.points.iter().position(|point| point.name == name).unwrap();
        let own = drawing.marks.iter().find(|mark| {
            matches!(mark.form, Form::Area { .. }) && mark.event.is_some_and(|event| event as usize == wanted)
        });
        let Form::Area { rings, .. } = &own.unwrap().form else { unreachable!("it is an area") };
        assert_eq!(drawing.event_at(middle_of(&rings[0]), 4.0), u32::try_from(wanted).ok(), "{name}");
    }
}

#[test]
fn the_frontier_falls_in_steps_and_no_point_lies_below_it() {
    let plot = crowded();
    let layout = laid_out(&plot, Frame { low: [60.0, 60.0], high: [700.0, 560.0] }, 3.0);
    let stairs = staircase(&plot, &layout);
    assert!(stairs.len() > 6, "{stairs:?}");
    for step in stairs.windows(2) {
        assert!(step[0][0] <= step[1][0] && step[0][1] <= step[1][1], "error never rises with time: {step:?}");
        assert!(step[0][0] == step[1][0] || step[0][1] == step[1][1], "steps are level or upright: {step:?}");
    }
    for (point, spot) in plot.points.iter().zip(&layout.spots) {
        let (false, Some([x, y])) = (point.is_control, *spot) else { continue };
        let reached = stairs.iter().filter(|stair| stair[0] <= x).map(|stair| stair[1]).fold(f64::MIN, f64::max);
        assert!(y <= reached + 1e-9, "{} lies below the frontier", point.name);
    }
}

#[test]
fn what_has_no_error_stands_in_the_lane_and_all_else_above_it() {
    for plot in [crowded(), exact()] {
        let layout = laid_out(&plot, Frame { low: [60.0, 60.0], high: [700.0, 560.0] }, 3.0);
        let lane = layout.lane.unwrap();
        for (point, spot) in plot.points.iter().zip(&layout.spots) {
            assert_eq!(lane.contains(spot.unwrap()), point.error == 0.0, "{}", point.name);
        }
    }
}

#[test]
fn what_is_no_number_is_left_out_and_nothing_at_all_still_makes_a_drawing() {
    let mut plot = crowded();
    plot.points[3].seconds = f64::NAN;
    plot.points[4].error = f64::INFINITY;
    plot.points[5].seconds = 0.0;
    plot.points[6].spread = f64::NAN;
    assert_readable(&plot, SIZE, Theme::Light);
    for size in [SIZE, [40.0, 40.0]] {
        let empty = frontier_plot(&FrontierPlot::default(), size, Theme::Light);
        assert!(!png(&empty, 1.0).is_empty() && svg(&empty).starts_with("<svg"));
    }
}

#[test]
fn the_same_points_make_the_same_drawing() {
    assert_eq!(frontier_plot(&crowded(), SIZE, Theme::Light), frontier_plot(&crowded(), SIZE, Theme::Light));
}

#[test]
fn the_drawing_is_the_one_that_was_looked_at() {
    let mut plot = crowded();
    plot.points.retain(|point| point.group.is_none_or(|group| [3, 5, 9].contains(&group)));
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description("samples, depth and a control: error against seconds");
    let drawing = frontier_plot(&plot, SIZE, Theme::Light);
    settings.bind(|| insta::assert_snapshot!("frontier_plot", drawing.to_text()));
}
