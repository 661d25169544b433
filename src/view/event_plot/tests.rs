//! Tests of the drawings of textures: what they show, and that they can be read.

use super::*;
use crate::record::Triple;
use crate::view::readable::assert_readable;
use crate::view::sample::{Sketch, every_kind};
use crate::view::sample_effects as effects;
use crate::view::sample_texture as sample;
use crate::view::{Form, Spot};

const SIZE: [f64; 2] = [620.0, 380.0];

/// A tree of nothing but this, the mapping with its texels below it.
fn alone(what: What) -> RayTree {
    let mut sketch = Sketch::new();
    let (is_mapping, is_lens) = (matches!(what, What::Mapping(_)), matches!(what, What::Lens(_)));
    sketch.with(what, |s| {
        if is_mapping {
            s.note(What::Texels(sample::texels()));
        }
        if is_lens {
            s.note(effects::confusion());
        }
    });
    sketch.finish()
}

fn drawn(what: What) -> Drawing {
    event_plot(None, &alone(what), 0, SIZE, Theme::Light).unwrap()
}

/// Each kind of drawing with its name.
fn all() -> Vec<(&'static str, What)> {
    vec![
        ("detail", What::Detail(sample::detail())),
        ("mapping", What::Mapping(sample::mapping())),
        ("texels", What::Texels(sample::texels())),
        ("lattice", What::Lattice(sample::lattice())),
        ("octaves", What::Octaves(sample::octaves())),
        ("undulate", What::Undulate(sample::undulate())),
        ("rings", What::Rings(sample::rings())),
        ("bump", What::Bump(sample::bump())),
        ("frame_map", What::FrameMap(sample::frame_map())),
        ("environment", What::Environment(sample::environment())),
        ("lens", effects::lens()),
        ("segment", What::Segment(effects::segment())),
        ("phase", What::Phase(effects::phase())),
    ]
}

#[test]
fn every_drawing_is_the_one_that_was_looked_at() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for (name, what) in all() {
        settings.set_snapshot_suffix(name);
        settings.set_description(format!("the drawing of the sample event, {name}"));
        settings.bind(|| insta::assert_snapshot!("event_plot", drawn(what).to_text()));
    }
}

#[test]
fn no_text_covers_another_and_nothing_is_cut_off_at_any_size() {
    let sizes = [[16.0, 16.0], [90.0, 60.0], [160.0, 400.0], [300.0, 150.0], [420.0, 260.0], SIZE, [1600.0, 300.0]];
    for (name, what) in all() {
        let tree = alone(what);
        for size in sizes {
            let drawing = event_plot(None, &tree, 0, size, Theme::Dark).unwrap();
            assert_readable(&drawing, &format!("{name} in {size:?}"));
        }
    }
}

/// The samples with a number of theirs replaced.
fn spoiled(by: f64) -> Vec<What> {
    let pair: Spot = [by, 0.5];
    let triple: Triple = [by, -by, 0.5];
    let mut detail = sample::detail();
    (detail.uv, detail.polygon[0]) = (pair, pair);
    let mut mapping = sample::mapping();
    (mapping.st, mapping.footprint[1]) = (pair, pair);
    let mut texels = sample::texels();
    (texels.level, texels.texels[0].weight, texels.texels[1].colour) = (by, by, triple);
    let mut lattice = sample::lattice();
    (lattice.offset, lattice.fade, lattice.corners[3].gradient) = (triple, triple, triple);
    lattice.corners[5].weight = by;
    let mut octaves = sample::octaves();
    (octaves.rows[1].term, octaves.rows[2].weight) = (by, by);
    let mut undulate = sample::undulate();
    (undulate.argument, undulate.stops[1].at, undulate.curve[7].colour, undulate.segment) =
        (by, by, triple, usize::MAX);
    let mut rings = sample::rings();
    (rings.stirred, rings.radius) = (by, by);
    let mut bump = sample::bump();
    (bump.p_u, bump.slopes, bump.after) = (triple, pair, triple);
    let mut frame = sample::frame_map();
    (frame.after[0], frame.roughness) = (triple, pair);
    let mut environment = sample::environment();
    (environment.at, environment.footprint[2], environment.size) = (pair, pair, [0, u32::MAX]);
    let What::Lens(lens) = effects::lens() else { unreachable!("it is a lens") };
    let lens = crate::record::Lens { radius: by, at: pair, point: triple, focus: triple, ..lens };
    let mut segment = effects::segment();
    (segment.length, segment.absorption, segment.transmittance) = (by, triple, triple);
    let mut phase = effects::phase();
    (phase.anisotropy, phase.cosine, phase.value) = (by, -by, by);
    vec![
        What::Lens(lens.clone()),
        What::Lens(crate::record::Lens { focus_distance: by, eye: triple, ..lens }),
        What::Segment(segment),
        What::Phase(phase),
        What::Detail(detail),
        What::Mapping(mapping),
        What::Texels(texels),
        What::Lattice(lattice),
        What::Octaves(octaves),
        What::Undulate(undulate),
        What::Rings(rings),
        What::Bump(bump),
        What::FrameMap(frame),
        What::Environment(environment),
    ]
}

#[test]
fn numbers_that_make_no_sense_do_no_harm() {
    for by in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e18, 1e6, 0.0, -0.0, 1e-300] {
        for what in spoiled(by) {
            let name = format!("{what:?} with {by}");
            assert_readable(&event_plot(None, &alone(what), 0, [420.0, 300.0], Theme::Light).unwrap(), &name);
        }
    }
}

#[test]
fn empty_lists_are_drawn_as_nothing() {
    let empty = [
        What::Detail(crate::record::Detail { polygon: Vec::new(), ..sample::detail() }),
        What::Mapping(crate::record::Mapping { footprint: Vec::new(), ..sample::mapping() }),
        What::Texels(crate::record::Texels { texels: Vec::new(), ..sample::texels() }),
        What::Lattice(crate::record::Lattice { corners: Vec::new(), ..sample::lattice() }),
        What::Octaves(crate::record::Octaves { rows: Vec::new(), sum: 0.0 }),
        What::Undulate(crate::record::Undulate { curve: Vec::new(), stops: Vec::new(), ..sample::undulate() }),
        What::Environment(crate::record::Environment { footprint: Vec::new(), ..sample::environment() }),
    ];
    for what in empty {
        assert_readable(&drawn(what), "empty");
    }
}

#[test]
fn a_texture_shows_what_gave_its_colour_and_a_hit_its_texture() {
    let tree = every_kind();
    let find = |wanted: fn(&What) -> bool| tree.events.iter().find(|event| wanted(&event.what)).unwrap().id;
    let mapping = find(|what| matches!(what, What::Mapping(_)));
    assert_eq!(telling(&tree, find(|what| matches!(what, What::Hit { .. }))), Some(mapping));
    for texture in tree.events.iter().filter(|event| matches!(event.what, What::Texture(_))) {
        let What::Texture(content) = &texture.what else { unreachable!() };
        let shown = &tree.event(telling(&tree, texture.id).unwrap()).what;
        match content.texture.as_str() {
            "image" => assert!(matches!(shown, What::Mapping(_))),
            "marble" => assert!(matches!(shown, What::Undulate(_))),
            _ => assert!(matches!(shown, What::Rings(_))),
        }
    }
    let environment = find(|what| matches!(what, What::Environment(_)));
    assert_eq!(telling(&tree, find(|what| matches!(what, What::Nothing { .. }))), Some(environment));
    assert_eq!(telling(&tree, find(|what| matches!(what, What::Quadratic { .. }))), None);
    assert_eq!(event_plot(None, &tree, EventId::MAX, SIZE, Theme::Light), None);
}

#[test]
fn what_another_ray_looked_up_is_not_this_hits() {
    let mut sketch = Sketch::new();
    sketch.with(What::Step { number: 5, title: String::new() }, |s| {
        let ray = What::Ray {
            wavelength: None,
            ray: crate::record::RayKind::Reflected,
            origin: [0.0; 3],
            direction: [0.0, 0.0, 1.0],
            depth: 1,
            medium: "air".into(),
            weight: 0.5,
            left: None,
        };
        s.with(ray, |s| s.note(What::Rings(sample::rings())));
    });
    let tree = sketch.finish();
    assert_eq!(telling(&tree, 0), None);
    assert_eq!(telling(&tree, 1), Some(2));
}

#[test]
fn texels_are_filled_with_their_colours_and_stand_for_their_event() {
    let drawing = drawn(What::Mapping(sample::mapping()));
    let fills: Vec<_> = drawing
        .marks
        .iter()
        .filter_map(|mark| match &mark.form {
            Form::Area { fill, .. } if mark.event != Some(0) => Some((*fill, mark.event)),
            _ => None,
        })
        .collect();
    let expected = sample::texels()
        .texels
        .iter()
        .map(|share| (crate::view::sheet::shown(share.colour), Some(1)))
        .collect::<Vec<_>>();
    assert_eq!(fills, expected);
    let weights = ["0.375", "0.0625"].map(|weight| drawing.texts().filter(|text| text.text == weight).count());
    assert_eq!(weights, [2, 4]);
}

#[test]
fn a_look_up_between_two_levels_shows_the_finer_ones_texels_on_its_own_grid() {
    let texels = |level, texels: Vec<_>| crate::record::Texels { level, texels, ..sample::texels() };
    let share = |at| crate::record::TexelShare { at, weight: 1.0, colour: [0.5; 3] };
    let mut sketch = Sketch::new();
    sketch.with(What::Step { number: 5, title: String::new() }, |s| {
        s.note(What::Mapping(crate::record::Mapping { size: [5, 4], footprint: Vec::new(), ..sample::mapping() }));
        s.with(What::Texels(texels(1.5, Vec::new())), |s| {
            s.note(What::Texels(texels(1.0, vec![share([1, 1])])));
            s.note(What::Texels(texels(2.0, vec![share([0, 0])])));
        });
    });
    let tree = sketch.finish();
    for (selected, shown) in [(1, 3), (2, 3), (3, 3), (4, 4)] {
        let footprint = footprint_of(&tree, selected);
        assert_eq!(footprint.texels.map(|(id, _)| id), Some(shown), "for {selected}");
        assert_eq!(footprint.mapping.map(|(id, _)| id), Some(1), "for {selected}");
    }
    // Half of 5 columns are 3, half of those 2.
    for (selected, size) in [(3, "3 × 2 texels on level 1"), (4, "2 × 1 texels on level 2")] {
        let drawing = event_plot(None, &tree, selected, SIZE, Theme::Light).unwrap();
        assert!(drawing.texts().any(|text| text.text.contains(size)), "{}", drawing.to_text());
    }
}

#[test]
fn the_bars_of_the_octaves_are_as_high_as_their_terms() {
    let drawing = drawn(What::Octaves(sample::octaves()));
    let palette = Theme::Light.palette();
    let bars = |colour| {
        let heights = drawing.marks.iter().filter_map(move |mark| match &mark.form {
            Form::Rect { frame, fill: Some(fill), .. } if *fill == colour => Some(frame.size()[1]),
            _ => None,
        });
        heights.collect::<Vec<f64>>()
    };
    let (up, down, sum) = (bars(palette.outside), bars(palette.inside), bars(palette.combined));
    let unit = up[0] / 0.25;
    assert!((down[0] - 0.1 * unit).abs() < 1e-9 && (up[1] - 0.1 * unit).abs() < 1e-9, "{up:?} {down:?}");
    assert!((sum[0] - 0.2625 * unit).abs() < 1e-9, "{sum:?}");
}

#[test]
fn the_angle_of_a_bump_is_the_one_between_its_normals() {
    let drawing = drawn(What::Bump(sample::bump()));
    let arcs: Vec<f64> = drawing
        .marks
        .iter()
        .filter_map(|mark| match &mark.form {
            Form::Arc { angles: [from, to], .. } => Some(to - from),
            _ => None,
        })
        .collect();
    // N · N′ = 2/3.
    assert!(arcs.len() == 1 && (arcs[0].cos() - 2.0 / 3.0).abs() < 1e-12, "{arcs:?}");
}

#[test]
fn a_log_of_a_million_rings_still_shows_the_ring_of_the_point() {
    let rings = crate::record::Rings { radius: 1e5, stirred: 1_000_001.5, ring: 1_000_001.0, dark: true };
    let drawing = drawn(What::Rings(rings));
    let areas = drawing.marks.iter().filter(|mark| matches!(mark.form, Form::Area { .. })).count();
    assert!((4..40).contains(&areas), "{areas}");
    assert!(drawing.texts().any(|text| text.text == "the point"));
}

#[test]
fn the_image_lies_behind_the_environment_where_it_is_at_hand() {
    let load = |name: &str| crate::scene::load(crate::scene::embedded_scene(name).unwrap().text, name).unwrap();
    let scene = load("textures/environment");
    let tree = crate::trace::record_pixel(&scene, 505, 205);
    let hit = (0..tree.end()).find(|&id| matches!(tree.event(id).what, What::Environment(_))).unwrap();
    let areas = |drawing: &Drawing| drawing.marks.iter().filter(|mark| matches!(mark.form, Form::Area { .. })).count();
    let plain = event_plot(None, &tree, hit, SIZE, Theme::Light).unwrap();
    let with = event_plot(Some(&scene), &tree, hit, SIZE, Theme::Light).unwrap();
    assert!(areas(&with) > areas(&plain) + 100, "{} and {}", areas(&with), areas(&plain));
    assert_readable(&with, "with its image");
    // The image of another environment is not this one's.
    let other = event_plot(Some(&load("textures/environment_cross")), &tree, hit, SIZE, Theme::Light).unwrap();
    assert_eq!(other, plain);
}
