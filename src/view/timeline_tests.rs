//! What the timeline shows, and what it must never lose.

use super::*;
use crate::record::{Entry, Recorder};
use crate::trace::TreeRecorder;
use crate::view::{Face, has_glyph, sample};

const SIZE: [f64; 2] = [600.0, 96.0];

fn ray(kind: RayKind, depth: u32) -> Entry {
    Entry::new(What::Ray {
        ray: kind,
        origin: [0.0; 3],
        direction: [0.0, 0.0, 1.0],
        depth,
        medium: "air".to_owned(),
        weight: 1.0,
        wavelength: None,
        left: None,
    })
}

fn limit() -> Entry {
    let (limit, consequence) = ("depth".to_owned(), "the ray is not sent".to_owned());
    Entry::new(What::Limit { limit, at: 5.0, value: 6.0, consequence })
}

/// A pixel with so many reflected rays beside each other, each with a rejected hit; a limit is met in one of them.
fn many(rays: u32, limited: u32) -> RayTree {
    let mut recorder = TreeRecorder::new();
    recorder.begin();
    for number in 0..rays {
        recorder.begin();
        recorder.note(|| {
            let [object, leaf, part, reason] = ["a", "a", "wall", "later"].map(str::to_owned);
            Entry::new(What::Rejected { object, leaf, part, t: 1.0, reason })
        });
        if number == limited {
            recorder.note(limit);
        }
        recorder.end(|| ray(RayKind::Reflected, 1 + number % 12));
    }
    recorder.end(|| Entry::new(What::Pixel { x: 0, y: 0, width: 1, height: 1 }));
    recorder.finish()
}

fn timed<'a>(tree: &'a RayTree, stops: &'a [EventId], selected: Option<EventId>) -> Timed<'a> {
    Timed { tree, told: tree.end(), stops, selected }
}

fn drawn(tree: &RayTree) -> Drawing {
    timeline(timed(tree, &[], None), SIZE, Theme::Light).unwrap()
}

fn signs(drawing: &Drawing, sign: &str) -> Vec<Option<EventId>> {
    let is_sign = |mark: &&super::super::drawing::Mark| match &mark.form {
        Form::Text(text) => text.text == sign,
        _ => false,
    };
    drawing.marks.iter().filter(is_sign).map(|mark| mark.event).collect()
}

#[test]
fn one_limit_among_a_hundred_thousand_events_is_seen_and_can_be_clicked() {
    for limited in [0, 31_234, 49_999] {
        let tree = many(50_000, limited);
        let event = tree.events.iter().find(|event| matches!(event.what, What::Limit { .. })).unwrap().id;
        let drawing = drawn(&tree);
        assert_eq!(signs(&drawing, "⊘"), [None, Some(event)], "the head of the line and the limit itself");
        assert!(
            drawing.description.contains(&format!("limit met: 1, first at {}", event + 1)),
            "{}",
            drawing.description
        );
    }
}

#[test]
fn a_hundred_thousand_events_need_no_more_marks_than_there_is_room_for() {
    let [few, many] = [many(5_000, 3), many(50_000, 3)].map(|tree| drawn(&tree).marks.len());
    assert!(many < 2 * few && many < 6_000, "{few} marks for 10,000 events, {many} for 100,000");
}

#[test]
fn everything_stays_inside_at_every_size() {
    let tree = sample::every_kind();
    for size in [[200.0, 40.0], [300.0, 60.0], [600.0, 96.0], [1400.0, 160.0]] {
        let drawing = timeline(timed(&tree, &[1, 5], Some(3)), size, Theme::Dark).unwrap();
        for text in drawing.texts() {
            assert!(drawing.frame().holds(&text.frame()), "{size:?}: {} at {:?}", text.text, text.frame());
            assert!(text.text.chars().all(|c| has_glyph(Face::Sans, c)), "{}", text.text);
        }
    }
}

#[test]
fn the_numbers_of_the_axis_do_not_touch() {
    for rays in [3, 40, 700, 50_000] {
        let drawing = drawn(&many(rays, 0));
        let frames: Vec<_> = drawing
            .texts()
            .filter(|text| text.anchor == Anchor::Middle && text.text.parse::<u32>().is_ok())
            .map(Text::frame)
            .collect();
        assert!(frames.len() >= 2);
        for (i, frame) in frames.iter().enumerate() {
            assert!(frames[i + 1..].iter().all(|other| !frame.overlaps(other)), "{rays} rays");
        }
    }
}

#[test]
fn a_place_on_the_scale_is_that_of_its_event_and_the_ends_hold() {
    for events in [1, 7, 100_000] {
        let scale = TimelineScale::new(600.0, events);
        for id in (0..events).step_by(1 + events as usize / 50) {
            assert_eq!(scale.event(scale.x(id)), id);
        }
        assert_eq!((scale.event(-50.0), scale.event(1e9)), (0, events - 1));
    }
}

#[test]
fn a_ray_is_a_bracket_over_its_own_events() {
    let tree = many(2, 9);
    let drawing = drawn(&tree);
    let scale = TimelineScale::new(SIZE[0], tree.end());
    let ray = tree.events.iter().find(|event| matches!(event.what, What::Ray { .. })).unwrap().id;
    let spans = |mark: &super::super::drawing::Mark| match &mark.form {
        Form::Line { points, .. } => mark.event == Some(ray) && points[0][0] < points[1][0],
        _ => false,
    };
    let bracket = drawing.marks.iter().find(|mark| spans(mark)).unwrap();
    let Form::Line { points, .. } = &bracket.form else { unreachable!() };
    assert_eq!(points[0][0], scale.edge(ray));
    assert!((points[1][0] - scale.edge(tree.subtree_end(ray))).abs() < 1.0);
}

#[test]
fn breakpoints_and_the_current_place_are_marked() {
    let tree = many(20, 3);
    let drawing = timeline(timed(&tree, &[4, 30], Some(12)), SIZE, Theme::Light).unwrap();
    let flags = drawing.marks.iter().filter(|mark| matches!(mark.form, Form::Area { .. }));
    assert_eq!(flags.map(|mark| mark.event).collect::<Vec<_>>(), [Some(4), Some(30)]);
    assert_eq!(drawing.marks.last().unwrap().event, Some(12));
    assert!(drawing.description.ends_with("Breakpoints stop at 2 events."), "{}", drawing.description);
}

#[test]
fn a_timeline_of_the_height_that_it_needs_fills_it_and_stays_within() {
    for rays in [1, 3, 40] {
        let tree = many(rays, 0);
        let height = timeline_height(&tree, false);
        let drawing = timeline(timed(&tree, &[], None), [600.0, height], Theme::Light).unwrap();
        let baselines = drawing.marks.iter().filter_map(|mark| match &mark.form {
            Form::Text(text) => Some(text.at[1]),
            _ => None,
        });
        let lowest = baselines.fold(0.0, f64::max);
        assert!(lowest < height && lowest > height - 8.0, "{rays} rays: {lowest} of {height}");
    }
}

#[test]
fn the_numbers_of_the_axis_stand_below_its_ticks() {
    let drawing = drawn(&many(40, 0));
    let ticks = drawing.marks.iter().filter_map(|mark| match &mark.form {
        Form::Line { points, .. } if points.len() == 2 && points[0][0] == points[1][0] => Some(points[1]),
        _ => None,
    });
    let end = ticks.map(|end| end[1]).fold(0.0, f64::max);
    let numbers = drawing.marks.iter().filter_map(|mark| match &mark.form {
        Form::Text(text) if text.at[1] > end => Some(text.at[1] - 0.72 * text.size),
        _ => None,
    });
    let top = numbers.fold(f64::INFINITY, f64::min);
    assert!(top.is_finite() && top > end, "a number from {top}, a tick to {end}");
}

#[test]
fn nothing_is_said_of_events_that_are_not_told() {
    let tree = many(20, 9);
    let limit = tree.events.iter().find(|event| matches!(event.what, What::Limit { .. })).unwrap().id;
    let drawn = |told: EventId| timeline(Timed { told, ..timed(&tree, &[4, 30], None) }, SIZE, Theme::Light).unwrap();
    let (at, behind) = (drawn(limit + 1), drawn(limit + 2));
    assert_eq!(signs(&at, "⊘"), [], "the last one is told without what came of it");
    assert_eq!(signs(&behind, "⊘"), [None, Some(limit)]);
    assert!(at.marks.iter().all(|mark| mark.event <= Some(limit)), "the flag at event 30 is not told either");
    assert!(!at.description.contains("limit met"), "{}", at.description);
}
