//! Tests of the maps: true colours, no text on another, nothing cut off.

use super::colours::viridis;
use super::*;
use crate::view::{Colour, Text, png};

/// Waves, with a hole and a spot off the scale.
fn waves([width, height]: [usize; 2]) -> HeatMap {
    let value = |x: usize, y: usize| {
        let [u, v] = [x as f64 / width as f64 - 0.5, y as f64 / height as f64 - 0.5];
        match u.hypot(v) {
            r if r < 0.06 => f64::INFINITY,
            r if r > 0.47 => f64::NAN,
            r => 4.0 * (1.0 + (24.0 * r).sin()),
        }
    };
    HeatMap {
        title: "Digits lost, f32".to_owned(),
        notes: vec!["Of the 7.2 digits of the hit time of the ray through each pixel's middle.".to_owned()],
        size: [width, height],
        scale: HeatScale::Linear([0.0, 7.2]),
        unit: "digits".to_owned(),
        nothing: Some("nothing is hit".to_owned()),
        beyond: Some("a hit is lost or made up".to_owned()),
        values: (0..height).flat_map(|y| (0..width).map(move |x| value(x, y))).collect(),
        ..HeatMap::default()
    }
}

fn others() -> [HeatMap; 3] {
    let plain = waves([80, 60]);
    let values = |of: fn(f64) -> f64| plain.values.iter().map(|&value| of(value)).collect();
    let [nothing, beyond] = [None, None];
    let error = HeatMap {
        title: "Error".to_owned(),
        scale: HeatScale::Log([1e-5, 0.3]),
        unit: "error".to_owned(),
        zero: Some("no error at all".to_owned()),
        values: values(|value| if value > 0.0 && value.is_finite() { 1e-3 * value.powi(3) } else { 0.0 }),
        nothing: nothing.clone(),
        beyond: beyond.clone(),
        ..plain.clone()
    };
    let names = ["certain", "decided by the fallback", "undecidable at input precision"];
    let tier = HeatMap {
        title: "What it took to be sure".to_owned(),
        scale: HeatScale::Classes(names.map(str::to_owned).to_vec()),
        values: values(|value| {
            if value.is_infinite() {
                2.0
            } else if value > 7.0 {
                1.0
            } else {
                0.0
            }
        }),
        nothing: nothing.clone(),
        beyond: beyond.clone(),
        ..plain.clone()
    };
    let time = HeatMap {
        title: "Time".to_owned(),
        scale: HeatScale::Log([90.0, 4_000.0]),
        unit: "ns".to_owned(),
        values: values(|value| if value.is_finite() { 90.0 * (1.0 + value).powi(2) } else { 60.0 }),
        nothing,
        beyond,
        ..plain
    };
    [error, tier, time]
}

#[test]
fn no_text_covers_another_and_none_is_cut_off() {
    for map in [waves([80, 60]), waves([640, 480]), waves([30, 90]), kinds()].iter().chain(&others()) {
        for size in [[760.0, 480.0], [560.0, 420.0], [330.0, 520.0]] {
            let drawing = heat_map(map, size, Theme::Light);
            let frames: Vec<Frame> = drawing.texts().map(Text::frame).collect();
            for (k, frame) in frames.iter().enumerate() {
                let text = &drawing.texts().nth(k).unwrap().text;
                assert!(drawing.frame().holds(frame), "{}: {text:?} at {frame:?}", map.title);
                assert!(frames[..k].iter().all(|other| !other.overlaps(frame)), "{}: {text:?}", map.title);
            }
        }
    }
}

#[test]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places within a small picture")]
fn a_pixel_has_the_colour_of_its_value_in_its_place() {
    let mut map = waves([8, 6]);
    map.values = vec![0.0; 48];
    map.values[8 * 2 + 3] = 7.2;
    map.values[8 * 5 + 7] = f64::INFINITY;
    let drawing = heat_map(&map, [760.0, 480.0], Theme::Light);
    let (frame, pixels) =
        squares(&map, heading(&mut Drawing::new([760.0, 480.0], drawing.background), &map, Theme::Light.palette()));
    assert_eq!(pixels, 1);
    let painted = crate::view::paint(&drawing, 1.0);
    let side = frame.size()[0] / 8.0;
    let at = |x: f64, y: f64| {
        let [x, y] = [frame.low[0] + (x + 0.5) * side, frame.low[1] + (y + 0.5) * side];
        let place = 4 * (y as usize * painted.width as usize + x as usize);
        <[u8; 3]>::try_from(&painted.rgba[place..place + 3]).unwrap()
    };
    let bytes = |share: f64| [viridis(share).r, viridis(share).g, viridis(share).b];
    assert_eq!(at(3.0, 2.0), bytes(1.0));
    assert_eq!(at(2.0, 2.0), bytes(0.0));
    assert_eq!(at(7.0, 5.0), [0xff, 0x1f, 0xc4]);
}

#[test]
fn a_square_of_many_pixels_shows_the_worst_of_them() {
    let mut map = waves([4, 2]);
    map.values = vec![1.0, f64::NAN, 2.0, 3.0, 0.5, f64::NAN, f64::INFINITY, 1.0];
    assert_eq!(worst(&map, [0, 0], 2), 1.0);
    assert_eq!(worst(&map, [1, 0], 2), f64::INFINITY);
    map.values = vec![f64::NAN; 8];
    assert!(worst(&map, [0, 0], 2).is_nan());
}

/// The values are those of the table of Matplotlib.
#[test]
fn the_colours_are_those_of_viridis_and_grow_lighter_all_the_way() {
    for (share, colour) in [
        (0.0, [0.267_004, 0.004_874, 0.329_415]),
        (0.25, [0.229_739, 0.322_361, 0.545_706]),
        (0.5, [0.127_568, 0.566_949, 0.550_556]),
        (0.75, [0.369_214, 0.788_888, 0.382_914]),
        (1.0, [0.993_248, 0.906_157, 0.143_936]),
    ] {
        let Colour { r, g, b, .. } = viridis(share);
        for (byte, value) in [r, g, b].into_iter().zip(colour) {
            assert!((f64::from(byte) / 255.0 - value).abs() < 0.025, "{share}: {byte} is not {value}");
        }
    }
    let luma = |k: u32| {
        let Colour { r, g, b, .. } = viridis(f64::from(k) / 32.0);
        0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
    };
    assert!((0..32).all(|k| luma(k) < luma(k + 1)));
}

/// How a colour looks to people who lack one kind of cone, in linear RGB.
///
/// **Source** G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, A Physiologically-based Model for Simulation of Color Vision
/// Deficiency (2009), severity 1: protanopia, deuteranopia, tritanopia.
const DICHROMATS: [[[f64; 3]; 3]; 3] = [
    [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]],
    [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]],
    [[1.255_528, -0.076_749, -0.178_779], [-0.078_411, 0.930_809, 0.147_602], [0.004_733, 0.691_367, 0.303_900]],
];

fn seen_by(eyes: [[f64; 3]; 3], colour: Colour) -> [f64; 3] {
    let linear = [colour.r, colour.g, colour.b].map(|byte| {
        let share = f64::from(byte) / 255.0;
        if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    });
    eyes.map(|row| row.iter().zip(linear).map(|(a, b)| a * b).sum::<f64>().clamp(0.0, 1.0))
}

/// A colour in CIE L*a*b* (D65), in which equal distances look about equally large.
fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
    let xyz = [
        (0.412_456 * r + 0.357_576 * g + 0.180_437 * b) / 0.950_47,
        0.212_673 * r + 0.715_152 * g + 0.072_175 * b,
        (0.019_334 * r + 0.119_192 * g + 0.950_304 * b) / 1.088_83,
    ];
    let [x, y, z] = xyz.map(|t: f64| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 });
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

#[test]
fn values_grow_lighter_to_every_eye() {
    for eyes in DICHROMATS {
        let lightness = |k: u32| lab(seen_by(eyes, viridis(f64::from(k) / 24.0)))[0];
        assert!((0..24).all(|k| lightness(k) < lightness(k + 1)), "{eyes:?}");
    }
}

#[test]
fn what_is_off_the_scale_is_told_from_every_value_by_every_eye() {
    let beyond = Paint::Beyond.colour(Theme::Light.palette());
    for eyes in DICHROMATS {
        let near =
            (0..=64).map(|k| distance(lab(seen_by(eyes, viridis(f64::from(k) / 64.0))), lab(seen_by(eyes, beyond))));
        assert!(near.fold(f64::INFINITY, f64::min) > 10.0, "{eyes:?}");
    }
}

/// A distance of 2.3 is just seen.
#[test]
fn the_first_eight_kinds_are_told_apart_by_every_eye() {
    for eyes in DICHROMATS {
        for (a, b) in (0..8).flat_map(|a| (0..a).map(move |b| (a, b))) {
            let between = distance(lab(seen_by(eyes, colours::kind(a))), lab(seen_by(eyes, colours::kind(b))));
            assert!(between > 14.0, "{a} and {b}: {between} {eyes:?}");
        }
    }
}

/// Four blocks of three kinds; the last pixel of each row has none.
fn kinds() -> HeatMap {
    let value = |x: usize, y: usize| match (x, y) {
        (47, _) => f64::NAN,
        (16..32, 0..18) => 1.0,
        (16..32, _) => 2.0,
        _ => 0.0,
    };
    HeatMap {
        title: "Objects".to_owned(),
        size: [48, 36],
        scale: HeatScale::Kinds(["bowl", "glass ball", "ground"].map(str::to_owned).to_vec()),
        nothing: Some("nothing is hit".to_owned()),
        values: (0..36).flat_map(|y| (0..48).map(move |x| value(x, y))).collect(),
        ..HeatMap::default()
    }
}

#[test]
fn each_stretch_of_a_kind_has_the_number_of_its_name() {
    let (size, palette) = ([760.0, 480.0], Theme::Light.palette());
    let drawing = heat_map(&kinds(), size, Theme::Light);
    let (map, _) = squares(&kinds(), heading(&mut Drawing::new(size, palette.ground), &kinds(), palette));
    let mut numbers: Vec<&str> =
        drawing.texts().filter(|text| map.contains(text.at)).map(|text| text.text.as_str()).collect();
    numbers.sort_unstable();
    // Kind 1 lies on the left and on the right.
    assert_eq!(numbers, ["1", "1", "2", "3"]);
    let beside: Vec<&str> =
        drawing.texts().filter(|text| !map.contains(text.at)).map(|text| text.text.as_str()).collect();
    for telling in ["1", "2", "3", "glass ball: 16.7 %"] {
        assert!(beside.contains(&telling), "{telling} in {beside:?}");
    }
    assert!(drawing.description.contains("glass ball: 16.7 %"), "{}", drawing.description);
}

#[test]
fn directions_have_their_colours_and_lean_where_they_point() {
    let mut map = kinds();
    let up = [0.0, 1.0, 0.0];
    map.scale = HeatScale::Directions(vec![up; 48 * 36]);
    let drawing = heat_map(&map, [760.0, 480.0], Theme::Dark);
    let green = Paint::of_direction(up).colour(Theme::Dark.palette());
    assert!(green.g == 255 && green.r.abs_diff(127) < 5 && green.b.abs_diff(127) < 5, "{green:?}");
    assert_eq!(map.colours(Theme::Dark)[0], green);
    let rises = drawing.marks.iter().filter(|mark| match &mark.form {
        Form::Line { points, .. } => {
            points.len() == 2 && points[1][1] < points[0][1] - 5.0 && points[1][0] == points[0][0]
        }
        _ => false,
    });
    assert!(rises.count() > 20);
}

#[test]
fn a_place_in_the_drawing_is_that_of_a_pixel() {
    let (map, size) = (kinds(), [760.0, 480.0]);
    let palette = Theme::Light.palette();
    let (frame, _) = squares(&map, heading(&mut Drawing::new(size, palette.ground), &map, palette));
    let side = frame.size()[0] / 48.0;
    assert_eq!(map.pixel_at(size, [frame.low[0] + 3.5 * side, frame.low[1] + 2.5 * side]), Some([3, 2]));
    assert_eq!(map.pixel_at(size, [frame.low[0] - 1.0, frame.low[1] + 2.0]), None);
    assert_eq!(map.pixel_at(size, [759.0, 479.0]), None);
}

#[test]
fn a_map_without_pixels_is_still_a_drawing() {
    assert!(!png(&heat_map(&HeatMap::default(), [300.0, 200.0], Theme::Dark), 1.0).is_empty());
}

#[test]
fn the_drawing_is_the_one_that_was_looked_at() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_description("digits lost in waves about the middle of a small picture");
    let drawing = heat_map(&waves([24, 18]), [560.0, 400.0], Theme::Light);
    settings.bind(|| insta::assert_snapshot!("heat_map", drawing.to_text()));
}
