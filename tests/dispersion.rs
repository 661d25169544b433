//! Light taken apart by wavelength, against Snell's law and Sellmeier's formula worked out here.

use glam::DVec3;
use rayscope::record::Effect;
use rayscope::record::{EventId, Value, What};
use rayscope::scene::{Effects, Scene, embedded_scenes, load};
use rayscope::trace::{RayTree, record_pixel, record_ray};
use serde_json::json;

const WAVELENGTHS: u32 = 9;

/// Schott N-SF11 by its data sheet.
fn index(nanometres: f64) -> f64 {
    let x = (nanometres / 1000.0).powi(2);
    let terms = [(1.737_596_95, 0.013_188_707), (0.313_747_346, 0.062_306_814_2), (1.898_781_01, 155.236_29)];
    (1.0 + terms.into_iter().map(|(b, c)| b * x / (x - c)).sum::<f64>()).sqrt()
}

/// A prism of flint glass with its edge along z and an angle of 60° between two of its sides.
fn prism(material: &serde_json::Value) -> Scene {
    let mut glass = json!({
        "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 1,
        "dispersion": { "kind": "glass", "glass": "SF11" }
    });
    glass.as_object_mut().unwrap().extend(material.as_object().unwrap().clone());
    let side = |degrees: f64| {
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        json!({ "normal": [cos, sin, 0], "offset": 1 })
    };
    let scene = json!({
        "materials": { "flint": glass },
        "objects": [{
            "shape": "convex_polyhedron", "material": "flint",
            "planes": [side(ENTRY), side(ENTRY - 120.0), side(ENTRY + 120.0),
                { "normal": [0, 0, 1], "offset": 2 }, { "normal": [0, 0, -1], "offset": 2 }]
        }],
        "sampling": { "wavelengths": WAVELENGTHS },
        "limits": { "depth": 6, "contribution": 0.0 }
    });
    load(&scene.to_string(), "a prism").unwrap_or_else(|errors| panic!("{errors}"))
}

/// Where the normal of the side points that the ray comes in through.
const ENTRY: f64 = 240.0;

/// The ray along x that meets the middle of that side, and its angle of incidence.
fn ray() -> (DVec3, DVec3, f64) {
    let (sin, cos) = ENTRY.to_radians().sin_cos();
    let incidence = (-cos).acos();
    (DVec3::new(cos - 4.0, sin, 0.0), DVec3::X, incidence)
}

fn tree(material: &serde_json::Value) -> RayTree {
    let (origin, direction, _) = ray();
    record_ray(&prism(material), origin, direction)
}

/// The wavelength, depth and direction of each refracted ray.
fn refracted(tree: &RayTree) -> Vec<(f64, u32, DVec3)> {
    let rays = tree.events.iter().filter_map(|event| match &event.what {
        What::Ray { ray: rayscope::record::RayKind::Refracted, direction, depth, wavelength, .. } => {
            Some((wavelength.expect("a wavelength behind the glass"), *depth, DVec3::from_array(*direction)))
        }
        _ => None,
    });
    rays.collect()
}

/// The value of a line of working.
fn line(tree: &RayTree, id: EventId, symbol: &str) -> DVec3 {
    let found = tree.event(id).working.iter().find(|line| line.symbol == symbol);
    match found.unwrap_or_else(|| panic!("no {symbol} in {:?}", tree.event(id))).result {
        Value::Vector(v) => DVec3::from_array(v),
        Value::Number(x) => DVec3::splat(x),
        Value::Truth(_) => panic!("{symbol} is a number"),
    }
}

fn wavelengths(tree: &RayTree) -> Vec<EventId> {
    tree.events.iter().filter(|event| matches!(event.what, What::Wavelength(_))).map(|event| event.id).collect()
}

#[test]
fn each_wavelength_is_deviated_by_the_prism_as_snells_law_says() {
    // δ = i + arcsin(sin A √(n² − sin² i) − cos A sin i) − A for a prism of angle A (Born and Wolf, § 4.7.2).
    let (_, _, incidence) = ray();
    let (sin_a, cos_a) = f64::to_radians(60.0).sin_cos();
    let leaving: Vec<_> = refracted(&tree(&json!({}))).into_iter().filter(|(_, depth, _)| *depth == 2).collect();
    assert_eq!(leaving.len(), WAVELENGTHS as usize);
    for (nanometres, _, direction) in leaving {
        let n = index(nanometres);
        let out = sin_a * (n * n - incidence.sin().powi(2)).sqrt() - cos_a * incidence.sin();
        let expected = incidence + out.asin() - f64::to_radians(60.0);
        let deviation = direction.y.atan2(direction.x).abs();
        assert!((deviation - expected).abs() < 1e-12, "{nanometres} nm: {deviation} is not {expected}");
        assert!(direction.z.abs() < 1e-15);
    }
}

#[test]
fn the_wavelengths_are_the_middles_of_equal_bands() {
    let tree = tree(&json!({}));
    let found: Vec<f64> = wavelengths(&tree).into_iter().map(|id| line(&tree, id, "λ").x).collect();
    for (k, nanometres) in found.iter().enumerate() {
        assert!((nanometres - (380.0 + (k as f64 + 0.5) * 400.0 / f64::from(WAVELENGTHS))).abs() < 1e-12);
    }
}

#[test]
fn nothing_is_lost_where_light_is_taken_apart() {
    for material in [json!({}), json!({ "fresnel": { "kind": "dielectric" } })] {
        let tree = tree(&material);
        let shares: DVec3 = wavelengths(&tree).into_iter().map(|id| line(&tree, id, "S")).sum();
        assert!((shares - DVec3::ONE).abs().max_element() < 1e-14, "white is {shares}");
        let through: DVec3 = wavelengths(&tree).into_iter().map(|id| line(&tree, id, "share through")).sum();
        let mirrored = tree.events.iter().find_map(|event| match &event.what {
            What::Reflection { share, shares, .. } => Some(shares.map_or(DVec3::splat(*share), DVec3::from_array)),
            _ => None,
        });
        let mirrored = mirrored.unwrap_or(DVec3::ZERO);
        assert!((through + mirrored - DVec3::ONE).abs().max_element() < 1e-14, "{through} and {mirrored}");
        assert_eq!(mirrored == DVec3::ZERO, material == json!({}));
    }
}

#[test]
fn a_ray_of_one_wavelength_is_never_taken_apart_again() {
    let tree = tree(&json!({ "fresnel": { "kind": "dielectric" } }));
    assert_eq!(wavelengths(&tree).len(), WAVELENGTHS as usize, "one interface takes light apart");
    let own = |id: EventId| match tree.event(id).what {
        What::Ray { wavelength, .. } => wavelength,
        _ => None,
    };
    let mut followed = 0;
    for id in 0..tree.end() {
        let Some(wavelength) = own(id) else { continue };
        for below in (id..tree.subtree_end(id)).filter(|&below| matches!(tree.event(below).what, What::Ray { .. })) {
            assert_eq!(own(below), Some(wavelength));
            followed += 1;
        }
    }
    assert!(followed > 5 * WAVELENGTHS, "only {followed} rays inside the glass");
}

#[test]
fn blue_light_is_kept_in_where_red_light_comes_out() {
    // Inside a block of flint glass, at an angle between the critical ones of red and of blue light.
    let angle = (1.0 / index(560.0)).asin();
    let scene = json!({
        "materials": { "flint": {
            "ambient": [0, 0, 0], "diffuse": [0, 0, 0], "transparency": 1, "dispersion": { "kind": "glass", "glass": "SF11" }
        } },
        "objects": [{ "shape": "cube", "material": "flint" }],
        "sampling": { "wavelengths": 20 },
        "limits": { "depth": 0, "contribution": 0.0 }
    });
    let scene = load(&scene.to_string(), "a block").unwrap_or_else(|errors| panic!("{errors}"));
    let tree = record_ray(&scene, DVec3::ZERO, DVec3::new(angle.sin(), 0.0, angle.cos()));
    let (mut kept, mut sent) = (DVec3::ZERO, 0);
    for id in wavelengths(&tree) {
        let What::Wavelength(wavelength) = &tree.event(id).what else { unreachable!() };
        assert_eq!(wavelength.theta2.is_none(), wavelength.nanometres < 560.0, "{} nm", wavelength.nanometres);
        match wavelength.theta2 {
            None => kept += DVec3::from_array(wavelength.share),
            Some(_) => sent += 1,
        }
    }
    let shares = tree.events.iter().find_map(|event| match event.what {
        What::Reflection { shares, .. } => shares,
        _ => None,
    });
    assert!((DVec3::from_array(shares.expect("coloured light")) - kept).abs().max_element() < 1e-14);
    assert_eq!(sent, 11, "from 570 to 770 nm");
}

#[test]
fn a_scene_without_dispersive_glass_has_no_wavelengths() {
    let mut without = 0;
    for embedded in embedded_scenes() {
        let scene = load(embedded.text, &embedded.name).unwrap_or_else(|errors| panic!("{errors}"));
        let takes_apart = scene.effects.has(Effect::Dispersion);
        let has_wavelength = scene
            .pixels
            .iter()
            .flat_map(|[x, y]| record_pixel(&scene, *x, *y).events)
            .any(|event| matches!(event.what, What::Wavelength(_) | What::Ray { wavelength: Some(_), .. }));
        assert_eq!(has_wavelength, takes_apart, "{}", embedded.name);
        without += u32::from(!takes_apart);
    }
    assert!(without > 50);
}

#[test]
fn a_scene_whose_dispersion_is_left_out_goes_by_yellow_light() {
    let scene = prism(&json!({}));
    let effects: Effects = scene.effects.without(Effect::Dispersion);
    let (origin, direction, incidence) = ray();
    let tree = record_ray(&Scene { effects, ..scene }, origin, direction);
    let snell = tree.events.iter().find_map(|event| match event.what {
        What::Snell { theta2, .. } => theta2,
        _ => None,
    });
    let expected = (incidence.sin() / index(587.5618)).asin().to_degrees();
    assert!((snell.expect("an angle") - expected).abs() < 1e-12);
    assert!(wavelengths(&tree).is_empty());
}
