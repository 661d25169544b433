use super::super::site::turning;
use super::*;
use crate::record::NullRecorder;
use crate::texture::solid::testing::{Kept, assert_every_line_holds};
use glam::{DMat3, DVec2};
use std::f64::consts::TAU;

/// A surface by its point and outward unit normal at (u, v).
type Surface = (&'static str, fn(f64, f64) -> (DVec3, DVec3));

const SURFACES: [Surface; 3] = [("sphere", sphere), ("torus", torus), ("cylinder", cylinder)];

fn sphere(u: f64, v: f64) -> (DVec3, DVec3) {
    let ((sin, cos), (up, out)) = ((u * TAU).sin_cos(), ((v - 0.5) * TAU / 2.0).sin_cos());
    let point = DVec3::new(out * cos, out * sin, up);
    (point, point)
}

fn torus(u: f64, v: f64) -> (DVec3, DVec3) {
    let ((sin, cos), (up, out)) = ((u * TAU).sin_cos(), (v * TAU).sin_cos());
    let normal = DVec3::new(out * cos, out * sin, up);
    (DVec3::new(2.5 * cos, 2.5 * sin, 0.0) + normal, normal)
}

/// With v downwards, so that P_u × P_v points inwards.
fn cylinder(u: f64, v: f64) -> (DVec3, DVec3) {
    let (sin, cos) = (u * TAU).sin_cos();
    (DVec3::new(cos, sin, -v), DVec3::new(cos, sin, 0.0))
}

/// A bump of the height 1, and its slopes.
fn bump(u: f64, v: f64) -> (f64, [f64; 2]) {
    let ((sin_u, cos_u), (sin_v, cos_v)) = ((3.0 * u + 0.4).sin_cos(), (2.0 * v + 1.1).sin_cos());
    (sin_u * cos_v, [3.0 * cos_u * cos_v, -2.0 * sin_u * sin_v])
}

/// The derivatives of a vector of u and v, to about 13 digits: central differences of four steps, of the eighth order.
fn derivatives(f: impl Fn(f64, f64) -> DVec3, u: f64, v: f64) -> [DVec3; 2] {
    const H: f64 = 4e-3;
    const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let along = |du: f64, dv: f64| {
        let step = |(k, weight): (f64, f64)| (f(u + k * du, v + k * dv) - f(u - k * du, v - k * dv)) * (weight / H);
        [1.0, 2.0, 3.0, 4.0].into_iter().zip(WEIGHTS).map(step).sum()
    };
    [along(H, 0.0), along(0.0, H)]
}

fn site(surface: fn(f64, f64) -> (DVec3, DVec3), u: f64, v: f64) -> Site {
    Site {
        texture_point: DVec3::ZERO,
        texture_from_world: DMat3::IDENTITY,
        uv: DVec2::new(u, v),
        tangents: derivatives(|u, v| surface(u, v).0, u, v),
        normal: surface(u, v).1,
    }
}

fn rise(amplitude: f64, u: f64, v: f64) -> Rise {
    let (height, slopes) = bump(u, v);
    Rise { height: amplitude * height, slopes: slopes.map(|slope| amplitude * slope) }
}

/// The angle between the perturbed normal and that of the surface that is really raised.
fn error(surface: fn(f64, f64) -> (DVec3, DVec3), amplitude: f64, u: f64, v: f64) -> f64 {
    let site = site(surface, u, v);
    let found = raised(("test", BumpDerivative::Dropped), &site, rise(amplitude, u, v), || None, &mut NullRecorder);
    let displaced = |u: f64, v: f64| {
        let (point, normal) = surface(u, v);
        point + normal * (amplitude * bump(u, v).0)
    };
    let [p_u, p_v] = derivatives(displaced, u, v);
    let exact = p_u.cross(p_v).normalize();
    let exact = if exact.dot(site.normal) < 0.0 { -exact } else { exact };
    found.cross(exact).length().atan2(found.dot(exact))
}

#[test]
fn the_error_falls_as_the_square_of_the_height() {
    for (name, surface) in SURFACES {
        for (u, v) in [(0.1, 0.4), (0.37, 0.62), (0.8, 0.3)] {
            // Heights over two and a half decades, evenly spread in the logarithm.
            let logarithms: Vec<_> = (0..=10).map(|k| -4.0 + 0.25 * f64::from(k)).collect();
            let points: Vec<_> =
                logarithms.iter().map(|x| (*x, error(surface, 10_f64.powf(*x), u, v).log10())).collect();
            let count = points.len() as f64;
            let (x, y) = points.iter().fold((0.0, 0.0), |(x, y), p| (x + p.0 / count, y + p.1 / count));
            let (up, across) =
                points.iter().fold((0.0, 0.0), |(a, b), p| (a + (p.0 - x) * (p.1 - y), b + (p.0 - x).powi(2)));
            assert!((up / across - 2.0).abs() < 0.1, "{name} at {u}, {v}: slope {}, {points:?}", up / across);
        }
    }
}

#[test]
fn on_a_plane_nothing_is_dropped() {
    fn plane(u: f64, v: f64) -> (DVec3, DVec3) {
        (DVec3::new(u, v, 0.0), DVec3::Z)
    }
    assert!(error(plane, 0.5, 0.3, 0.7) < 1e-12);
}

#[test]
fn the_recorded_angle_is_that_to_the_surface_that_is_really_raised() {
    for (name, surface) in SURFACES {
        let (u, v, amplitude) = (0.37, 0.62, 0.05);
        let site = site(surface, u, v);
        let turned = || Some(derivatives(|u, v| surface(u, v).1, u, v));
        let mut kept = Kept::default();
        let recorded = raised(("test", BumpDerivative::Dropped), &site, rise(amplitude, u, v), turned, &mut kept);
        assert_eq!(
            recorded,
            raised(("test", BumpDerivative::Dropped), &site, rise(amplitude, u, v), turned, &mut NullRecorder)
        );
        let What::Bump(record) = &kept.0[0].what else { panic!("{kept:?}", kept = kept.0) };
        let (dropped, expected) = (record.dropped.unwrap(), error(surface, amplitude, u, v).to_degrees());
        assert!((dropped - expected).abs() < 1e-8, "{name}: {dropped} {expected}");
        assert_every_line_holds(&kept);
    }
}

#[test]
fn differences_along_the_tangents_turn_the_normal_as_the_derivatives_do() {
    let (u, v) = (0.37, 0.62);
    let site = site(torus, u, v);
    let point = torus(u, v).0;
    let outward = |beside: DVec3| {
        let p = point + beside;
        p - (p.truncate().normalize() * 2.5).extend(0.0)
    };
    let (found, expected) = (turning(site.tangents, outward).unwrap(), derivatives(|u, v| torus(u, v).1, u, v));
    for (a, b) in found.iter().zip(expected) {
        assert!((*a - b).length() < 1e-7 * b.length(), "{a} {b}");
    }
}

#[test]
fn a_slope_along_u_tilts_the_normal_against_u_whichever_way_the_product_points() {
    for flip in [1.0, -1.0] {
        let site = Site {
            texture_point: DVec3::ZERO,
            texture_from_world: DMat3::IDENTITY,
            uv: DVec2::ZERO,
            tangents: [DVec3::X, DVec3::Y * flip],
            normal: DVec3::Z,
        };
        let rise = Rise { height: 0.0, slopes: [0.75, 0.0] };
        // z = 0.75 x has the normal (−0.75, 0, 1).
        let after = raised(("test", BumpDerivative::Dropped), &site, rise, || None, &mut NullRecorder);
        assert!((after - DVec3::new(-0.6, 0.0, 0.8)).length() < 1e-15, "{after}");
    }
}

#[test]
fn at_a_pole_the_normal_stays() {
    let pole = Site { tangents: [DVec3::ZERO, DVec3::X], ..site(sphere, 0.2, 0.4) };
    let mut kept = Kept::default();
    assert_eq!(raised(("test", BumpDerivative::Dropped), &pole, rise(0.1, 0.2, 0.4), || None, &mut kept), pole.normal);
    assert_every_line_holds(&kept);
}
