//! Interfaces by hand, and against the 40-digit oracle in `tests/oracle/optics.jsonl`.

use glam::DVec3;
use rayscope::optics::{Optics, reflect, refract, snell_entry};
use rayscope::record::What;
use serde_json::Value;

/// A ray that comes down onto the plane z = 0 at this angle to the normal.
fn at(degrees: f64) -> DVec3 {
    let angle = degrees.to_radians();
    DVec3::new(angle.sin(), 0.0, -angle.cos())
}

fn near(got: f64, want: f64) {
    assert!((got - want).abs() <= 1e-14 * want.abs().max(1.0), "{got} is not {want}");
}

fn all_finite(optics: &Optics) -> bool {
    let vectors = optics.reflected.is_finite() && optics.refracted.is_none_or(DVec3::is_finite);
    let [r_s, r_p] = optics.fresnel();
    let numbers = [optics.cos_i, optics.sin_i, r_s, r_p, optics.reflectance(), optics.theta1_degrees()];
    let options = [optics.cos_t, optics.theta2_degrees(), optics.critical_angle_degrees()];
    vectors
        && !optics.w.is_nan()
        && numbers.iter().all(|x| x.is_finite())
        && options.iter().all(|x| x.is_none_or(f64::is_finite))
}

#[test]
fn a_mirror_turns_the_part_along_the_normal_round() {
    assert_eq!(reflect(DVec3::new(3.0, 4.0, -5.0), DVec3::Z), DVec3::new(3.0, 4.0, 5.0));
    assert_eq!(reflect(DVec3::new(3.0, 4.0, -5.0), -DVec3::Z), DVec3::new(3.0, 4.0, 5.0));
}

#[test]
fn thirty_degrees_from_air_into_glass_bend_to_the_arcsine_of_a_third() {
    // sin θ₂ = sin 30° / 1.5 = 1/3, so cos θ₂ = √8 / 3.
    let optics = refract(at(30.0), DVec3::Z, 1.0, 1.5);
    near(optics.theta1_degrees(), 30.0);
    near(optics.theta2_degrees().unwrap(), (1.0_f64 / 3.0).asin().to_degrees());
    near(optics.cos_t.unwrap(), 8.0_f64.sqrt() / 3.0);
    let refracted = optics.refracted.unwrap();
    near(refracted.x, 1.0 / 3.0);
    near(refracted.z, -(8.0_f64.sqrt()) / 3.0);
    assert_eq!(optics.critical_angle_degrees(), None);
}

#[test]
fn fresnel_at_thirty_degrees_follows_the_textbook_formulas() {
    let (c1, c2) = (3.0_f64.sqrt() / 2.0, 8.0_f64.sqrt() / 3.0);
    let r_s = ((c1 - 1.5 * c2) / (c1 + 1.5 * c2)).powi(2);
    let r_p = ((1.5 * c1 - c2) / (1.5 * c1 + c2)).powi(2);
    let optics = refract(at(30.0), DVec3::Z, 1.0, 1.5);
    near(optics.fresnel()[0], r_s);
    near(optics.fresnel()[1], r_p);
    near(optics.reflectance(), f64::midpoint(r_s, r_p));
}

#[test]
fn the_critical_angle_of_glass_is_the_arcsine_of_two_thirds() {
    let optics = refract(at(20.0), DVec3::Z, 1.5, 1.0);
    near(optics.critical_angle_degrees().unwrap(), 41.810_314_895_778_6);
}

#[test]
fn light_passes_just_below_the_critical_angle_and_not_just_above() {
    let below = refract(at(41.81), DVec3::Z, 1.5, 1.0);
    assert!(below.refracted.is_some() && below.theta2_degrees().unwrap() > 89.0);
    let above = refract(at(41.811), DVec3::Z, 1.5, 1.0);
    assert_eq!((above.refracted, above.cos_t, above.reflectance()), (None, None, 1.0));
    assert!(above.w < 0.0);
}

#[test]
fn head_on_a_25th_of_the_light_is_reflected_by_glass() {
    // ((1 − 1.5) / (1 + 1.5))² = 1/25.
    let optics = refract(DVec3::new(0.0, 0.0, -7.0), DVec3::new(0.0, 0.0, 3.0), 1.0, 1.5);
    near(optics.reflectance(), 0.04);
    assert_eq!(optics.refracted, Some(-DVec3::Z));
    assert_eq!(optics.reflected, DVec3::new(0.0, 0.0, 7.0));
    assert_eq!((optics.theta1_degrees(), optics.theta2_degrees()), (0.0, Some(0.0)));
}

#[test]
fn at_brewsters_angle_no_light_that_swings_in_the_plane_of_incidence_is_reflected() {
    let brewster = 1.5_f64.atan().to_degrees();
    let optics = refract(at(brewster), DVec3::Z, 1.0, 1.5);
    assert!(optics.fresnel()[1] < 1e-30);
    near(optics.theta1_degrees() + optics.theta2_degrees().unwrap(), 90.0);
}

#[test]
fn a_grazing_ray_into_a_medium_next_to_nothing_splits_as_fresnel_says() {
    // cos θ₂ = 1, so r_p = (n₂ cos θ₁ − n₁) / (n₂ cos θ₁ + n₁), where n₂ cos θ₁ / n₁ = 3 / √10.
    let optics = refract(DVec3::new(1e150, 1.0, 0.0), DVec3::new(0.0, 3.0, 1.0), 1.0, 1e150);
    let ratio = 3.0 / 10.0_f64.sqrt();
    near(optics.fresnel()[1], ((ratio - 1.0) / (ratio + 1.0)).powi(2));
    near(optics.fresnel()[0], 1.0);
}

#[test]
fn a_ray_along_the_interface_is_reflected_wholly() {
    let optics = refract(DVec3::X, DVec3::Z, 1.0, 1.5);
    assert_eq!((optics.reflectance(), optics.cos_i, optics.theta1_degrees()), (1.0, 0.0, 90.0));
    near(optics.theta2_degrees().unwrap(), 41.810_314_895_778_6);
    assert!(optics.refracted.unwrap().z < 0.0, "beyond the side that the normal points to");
    assert_eq!(optics.reflected, DVec3::X);
}

#[test]
fn equal_indices_let_the_ray_go_straight_on() {
    let direction = DVec3::new(0.6, 0.0, -0.8);
    let optics = refract(direction, DVec3::Z, 1.33, 1.33);
    assert_eq!(optics.reflectance(), 0.0);
    assert!((optics.refracted.unwrap() - direction).length() < 1e-15);
}

#[test]
fn lengths_and_the_side_of_the_normal_do_not_matter() {
    let plain = refract(at(50.0), DVec3::Z, 1.0, 1.33);
    let other = refract(at(50.0) * 1024.0, DVec3::Z * -0.125, 1.0, 1.33);
    assert_eq!(other.refracted, plain.refracted);
    assert_eq!(other.reflectance(), plain.reflectance());
    assert_eq!(other.reflected, plain.reflected * 1024.0);
}

#[test]
fn nothing_is_ever_nan() {
    let numbers = [0.0, 1.0, -1.0, 1e-300, -1e300, 5e-324, f64::MAX];
    let count = numbers.len();
    let vectors: Vec<DVec3> = (0..count.pow(3))
        .map(|i| DVec3::new(numbers[i % count], numbers[i / count % count], numbers[i / count / count]))
        .collect();
    for &direction in &vectors {
        for &normal in vectors.iter().step_by(5) {
            for (n1, n2) in [(1.0, 1.5), (1.5, 1.0), (1.0, 1.0), (1e-300, 1e300), (1e300, 1e-300), (0.0, 1.0)] {
                let optics = refract(direction, normal, n1, n2);
                assert!(all_finite(&optics), "{direction} {normal} {n1} {n2}: {optics:?}");
            }
        }
    }
    assert!(all_finite(&refract(DVec3::NAN, DVec3::Z, 1.0, 1.5)));
}

#[test]
fn the_working_shows_every_number_of_the_event() {
    let (direction, optics) = (at(30.0), refract(at(30.0), DVec3::Z, 1.0, 2.0));
    let entry = snell_entry(direction, DVec3::Z, 1.0, 2.0, &optics);
    let line = |symbol: &str| entry.working.iter().find(|line| line.symbol == symbol).unwrap();
    assert_eq!(line("η").numbers.to_string(), "1 / 2");
    assert_eq!(line("w").numbers.to_string(), "1 − 0.5² 0.5²");
    assert_eq!(line("R").result, optics.reflectance().into());
    assert!(matches!(entry.what, What::Snell { total_internal_reflection: false, critical: None, .. }));
    assert!(entry.source.file.ends_with("optics.rs"));
}

#[test]
fn the_working_of_a_total_internal_reflection_says_so() {
    let optics = refract(at(60.0), DVec3::Z, 1.5, 1.0);
    let entry = snell_entry(at(60.0), DVec3::Z, 1.5, 1.0, &optics);
    assert!(entry.working.iter().any(|line| line.symbol == "total internal reflection"));
    assert!(entry.working.iter().all(|line| line.symbol != "θ₂ in degrees"));
    let What::Snell { total_internal_reflection, theta2, critical, .. } = entry.what else { panic!("not Snell") };
    assert_eq!((total_internal_reflection, theta2), (true, None));
    near(critical.unwrap(), 41.810_314_895_778_6);
}

fn number(value: &Value) -> f64 {
    value.as_str().map_or_else(|| value.as_f64().unwrap(), |text| text.parse().unwrap())
}

fn vector(value: &Value) -> DVec3 {
    DVec3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}

/// Errors up to 16 times what half an ulp in the inputs does, and an ulp of the result.
fn within_floor(id: &str, what: &str, got: f64, want: f64, floor: f64) {
    let allowed = 16.0 * floor + f64::EPSILON * want.abs();
    assert!((got - want).abs() <= allowed, "{id}: {what} is {got}, not {want} (± {allowed})");
}

fn agrees_with(case: &Value) {
    let id = case["id"].as_str().unwrap();
    let (n1, n2) = (number(&case["n1"]), number(&case["n2"]));
    let optics = refract(vector(&case["dir"]), vector(&case["m"]), n1, n2);
    assert!(all_finite(&optics), "{id}: {optics:?}");
    let reflected = (vector(&case["refl"]), vector(&case["refl_floor"]));
    for axis in 0..3 {
        within_floor(id, "reflected", optics.reflected[axis], reflected.0[axis], reflected.1[axis]);
    }
    let critical = case["critical_angle"].as_str().map(|text| text.parse::<f64>().unwrap().to_degrees());
    assert_eq!(optics.critical_angle_degrees().is_some(), critical.is_some(), "{id}");
    if let (Some(got), Some(want)) = (optics.critical_angle_degrees(), critical) {
        // asin(n₂ / n₁) near 90° magnifies the rounding of the quotient.
        let magnified = f64::EPSILON * (n2 / n1) / (1.0 - (n2 / n1).powi(2)).sqrt();
        assert!((got - want).abs() <= 2.0 * magnified.to_degrees() + 4.0 * f64::EPSILON * want, "{id}: {got} {want}");
    }
    if case["tir_amb"] == true {
        return;
    }
    assert_eq!(optics.refracted.is_none(), case["kind"] == "tir", "{id}: whether light passes");
    if case["amb"] == true {
        return;
    }
    within_floor(id, "w", optics.w, number(&case["w"]), number(&case["w_floor"]));
    within_floor(id, "R", optics.reflectance(), number(&case["R"]), number(&case["R_floor"]));
    let Some(refracted) = optics.refracted else { return };
    let (want, floor) = (vector(&case["refr"]), vector(&case["refr_floor"]));
    for axis in 0..3 {
        within_floor(id, "refracted", refracted[axis], want[axis], floor[axis]);
    }
}

#[test]
fn every_case_of_the_oracle_is_within_its_floor() {
    let cases = include_str!("oracle/optics.jsonl");
    let mut checked = 0;
    for line in cases.lines() {
        agrees_with(&serde_json::from_str(line).unwrap());
        checked += 1;
    }
    assert_eq!(checked, 322);
}
