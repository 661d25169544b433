//! Changes to JSON that leave it JSON: bytes changed at random hardly ever come past the parser.

use libfuzzer_sys::fuzzer_mutate;
use serde_json::{Map, Value, json};

/// Numbers at which arithmetic changes its ways.
const NUMBERS: [f64; 28] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    3.0,
    -2.0,
    0.1,
    1e-3,
    1e-8,
    1e-16,
    1e-150,
    1e-300,
    5e-324,
    f64::MIN_POSITIVE,
    f64::EPSILON,
    1.0 + f64::EPSILON,
    1.0 - f64::EPSILON / 2.0,
    10.0,
    90.0,
    180.0,
    1e8,
    1e16,
    1e150,
    1e300,
    f64::MAX,
    -1e154,
];

/// Solids to put in place of others.
const SOLIDS: [&str; 14] = [
    r#"{"shape": "sphere"}"#,
    r#"{"shape": "plane"}"#,
    r#"{"shape": "square"}"#,
    r#"{"shape": "cube"}"#,
    r#"{"shape": "cylinder"}"#,
    r#"{"shape": "cone"}"#,
    r#"{"shape": "tapered_cylinder", "s": 0.4}"#,
    r#"{"shape": "torus", "d": 0.3}"#,
    r#"{"shape": "torus", "d": 3}"#,
    r#"{"shape": "superellipsoid", "n": 0.5, "m": 3}"#,
    r#"{"shape": "superellipsoid", "n": 4, "m": 0.7}"#,
    r#"{"shape": "superellipsoid", "n": 10, "m": 10}"#,
    r#"{"shape": "convex_polyhedron", "planes": [{"normal": [1,0,0], "offset": 1}, {"normal": [0,1,0], "offset": 1},
        {"normal": [0,0,1], "offset": 1}, {"normal": [-1,-1,-1], "offset": 1}]}"#,
    r#"{"shape": "copy", "solid": "part"}"#,
];

/// Steps of a transform.
const STEPS: [&str; 6] = [
    r#"{"scale": 2}"#,
    r#"{"scale": [1, -1, 1e-6]}"#,
    r#"{"rotate": {"axis": [1, 2, 3], "degrees": 30}}"#,
    r#"{"rotate": {"axis": [0, 0, 1], "degrees": 90}}"#,
    r#"{"translate": [1e8, 0, 1]}"#,
    r#"{"matrix": [[1, 0.5, 0, 1], [0, 1, 0.25, 0], [0, 0, 1, -1]]}"#,
];

/// A linear congruential step (Knuth's MMIX constants): enough to spread a seed over a few choices.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(self.0 >> 33).unwrap_or(0) % sides.max(1)
    }
}

/// A mutation as libFuzzer asks for it: one in four, and whatever is not JSON, is left to libFuzzer's own ways.
pub fn json(data: &mut [u8], size: usize, max_size: usize, seed: u32) -> usize {
    let mut dice = Dice(u64::from(seed) ^ 0x9e37_79b9_7f4a_7c15);
    dice.roll(2);
    let parsed = serde_json::from_slice::<Value>(&data[..size]).ok().filter(|_| dice.roll(4) > 0);
    let Some(mut value) = parsed else { return fuzzer_mutate(data, size, max_size) };
    for _ in 0..=dice.roll(3) {
        change(&mut value, &mut dice);
    }
    match serde_json::to_vec(&value) {
        Ok(text) if text.len() <= max_size => {
            data[..text.len()].copy_from_slice(&text);
            text.len()
        }
        _ => fuzzer_mutate(data, size, max_size),
    }
}

fn count(value: &Value) -> usize {
    1 + match value {
        Value::Array(items) => items.iter().map(count).sum(),
        Value::Object(members) => members.values().map(count).sum(),
        _ => 0,
    }
}

/// The part with this number, counted in depth-first order.
fn part<'a>(value: &'a mut Value, number: &mut usize) -> Option<&'a mut Value> {
    if *number == 0 {
        return Some(value);
    }
    *number -= 1;
    match value {
        Value::Array(items) => items.iter_mut().find_map(|item| part(item, number)),
        Value::Object(members) => members.values_mut().find_map(|member| part(member, number)),
        _ => None,
    }
}

fn any_part<'a>(value: &'a mut Value, dice: &mut Dice) -> Option<&'a mut Value> {
    let mut number = dice.roll(count(value));
    part(value, &mut number)
}

fn change(value: &mut Value, dice: &mut Dice) {
    let other = any_part(value, dice).map(|part| part.clone()).unwrap_or_default();
    let Some(part) = any_part(value, dice) else { return };
    match part {
        Value::Number(number) => {
            let old = number.as_f64().unwrap_or(0.0);
            *part = json!(other_number(old, &other, dice));
        }
        Value::Array(items) => change_list(items, other, dice),
        Value::Object(members) => change_members(members, dice),
        _ => *part = other,
    }
}

fn other_number(old: f64, other: &Value, dice: &mut Dice) -> f64 {
    match dice.roll(9) {
        0..=2 => NUMBERS[dice.roll(NUMBERS.len())],
        3 => old.next_up(),
        4 => -old,
        5 => old * 2.0,
        6 => old * 1e-3,
        7 => other.as_f64().unwrap_or(old + 1.0),
        _ => (dice.roll(2001) as f64 - 1000.0) / 100.0,
    }
}

fn change_list(items: &mut Vec<Value>, other: Value, dice: &mut Dice) {
    let place = dice.roll(items.len());
    match dice.roll(4) {
        0 if !items.is_empty() => {
            items.remove(place);
        }
        1 if !items.is_empty() => items.push(items[place].clone()),
        2 if !items.is_empty() => items[place] = other,
        _ => items.rotate_left(place),
    }
}

fn change_members(members: &mut Map<String, Value>, dice: &mut Dice) {
    let parse = |texts: &[&str], dice: &mut Dice| {
        serde_json::from_str::<Value>(texts[dice.roll(texts.len())]).unwrap_or_default()
    };
    if !members.contains_key("shape") {
        let names: Vec<_> = members.keys().cloned().collect();
        if let Some(name) = names.get(dice.roll(names.len() * 2)) {
            members.shift_remove(name);
        }
        return;
    }
    match dice.roll(4) {
        0 => {
            let operator = ["union", "intersection", "difference"][dice.roll(3)];
            let second = if dice.roll(2) == 0 { parse(&SOLIDS, dice) } else { Value::Object(members.clone()) };
            let whole = json!({"shape": operator, "of": [members.clone(), second]});
            if let (Value::Object(mut whole), material) = (whole, members.get("material").cloned()) {
                whole.extend(material.map(|material| ("material".to_owned(), material)));
                *members = whole;
            }
        }
        1 => {
            let kept: Vec<_> = ["name", "material", "transform"]
                .into_iter()
                .filter_map(|name| Some((name.to_owned(), members.get(name)?.clone())))
                .collect();
            if let Value::Object(mut solid) = parse(&SOLIDS, dice) {
                solid.extend(kept);
                *members = solid;
            }
        }
        _ => {
            let step = parse(&STEPS, dice);
            if let Value::Array(steps) = members.entry("transform").or_insert_with(|| json!([])) {
                steps.push(step);
            }
        }
    }
}
