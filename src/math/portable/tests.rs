use super::*;
use crate::math::{Precise, Real};
use proptest::prelude::*;

fn exact(x: f64) -> Precise {
    Precise::from_f64(x)
}

/// The sum of xᵏ/k! for k = first, first + step, …, with signs that alternate where `turns`: eˣ, sin x and cos x to 60 digits for
/// |x| up to 12.
fn series(x: Precise, first: u32, step: u32, turns: bool) -> Precise {
    let (mut term, mut sum) = (Precise::ONE, Precise::ZERO);
    for k in 0..160 {
        if k > 0 {
            term = term * x / exact(f64::from(k));
        }
        if k >= first && (k - first).is_multiple_of(step) {
            let minus = turns && (k - first) / step % 2 == 1;
            sum = if minus { sum - term } else { sum + term };
        }
    }
    sum
}

fn exact_sin(x: Precise) -> Precise {
    series(x, 1, 2, true)
}

fn exact_cos(x: Precise) -> Precise {
    series(x, 0, 2, true)
}

fn exact_exp(x: Precise) -> Precise {
    series(x, 0, 1, false)
}

/// Whether a number is within so many units in its last place of the exact one.
fn is_near(found: f64, truth: Precise, units: f64) -> bool {
    let ulp = found.abs().next_up() - found.abs();
    (exact(found) - truth).abs() <= exact(units * ulp)
}

/// Whether x lies between what a rising function makes of the numbers so many units below and above `found`.
fn is_inverse(found: f64, units: f64, x: f64, rising: impl Fn(Precise) -> Precise) -> bool {
    let margin = exact(units * (found.abs().next_up() - found.abs()));
    rising(exact(found) - margin) <= exact(x) && exact(x) <= rising(exact(found) + margin)
}

proptest! {
    #[test]
    fn angles_to_numbers_are_right_within_one_unit(x in -12.0..12.0_f64) {
        let (sine, cosine) = (exact_sin(exact(x)), exact_cos(exact(x)));
        prop_assert!(is_near(sin(x), sine, 1.0) && is_near(cos(x), cosine, 1.0) && is_near(tan(x), sine / cosine, 1.0));
        prop_assert_eq!(sin_cos(x), (sin(x), cos(x)));
    }

    #[test]
    fn numbers_to_angles_are_right_within_one_unit(x in -1.0..1.0_f64, far in -30.0..30.0_f64) {
        prop_assert!(is_inverse(asin(x), 1.0, x, exact_sin));
        prop_assert!(is_inverse(acos(x), 1.0, -x, |angle| -exact_cos(angle)));
        let tangent = |angle| exact_sin(angle) / exact_cos(angle);
        prop_assert!(is_inverse(atan(far), 1.0, far, tangent));
        // The angle whose tangent is far / x, in the half plane that x is in.
        let angle = exact(atan2(far, x));
        let (sine, cosine) = (exact_sin(angle), exact_cos(angle));
        let off = (sine * exact(x) - cosine * exact(far)).abs();
        prop_assert!(off <= exact(2.0 * f64::EPSILON) * (exact(x.abs()) + exact(far.abs())));
        prop_assert!(cosine * exact(x) + sine * exact(far) > Precise::ZERO);
    }

    #[test]
    fn exponentials_and_logarithms_are_right_within_one_or_two_units(x in -12.0..12.0_f64) {
        let power = exact_exp(exact(x));
        prop_assert!(is_near(exp(x), power, 1.0) && is_near(exp_m1(x), power - Precise::ONE, 1.0));
        let y = exp(x);
        prop_assert!(is_inverse(ln(y), 1.0, y, exact_exp));
        prop_assert!(is_inverse(log2(y), 1.0, y, |log| exact(2.0).pow(log)));
        prop_assert!(is_inverse(log10(y), 2.0, y, |log| exact(10.0).pow(log)));
        prop_assert!(is_inverse(asinh(x), 2.0, x, |z| (exact_exp(z) - exact_exp(-z)) / exact(2.0)));
    }

    #[test]
    fn powers_and_roots_are_right_within_one_unit(x in 1e-3..1e3_f64, p in -20.0..20.0_f64, y in -1e3..1e3_f64) {
        prop_assert!(is_near(powf(x, p), exact(x).pow(exact(p)), 1.0));
        prop_assert!(is_inverse(cbrt(y), 0.5, y, |root| root * root * root));
        prop_assert!(is_near(hypot(x, y), (exact(x) * exact(x) + exact(y) * exact(y)).sqrt(), 1.0));
    }

    #[test]
    fn whole_powers_are_products(x in -2.0..2.0_f64, n in 0..40_i32) {
        let product = (0..n).fold(1.0, |product, _| product * x);
        prop_assert!((powi(x, n) - product).abs() <= f64::from(n) * f64::EPSILON * product.abs());
        prop_assert_eq!((powi(x, 1), powi(x, 2), powi(x, 3)), (x, x * x, x * x * x));
        prop_assert_eq!(powi(x, -n), 1.0 / powi(x, n));
    }
}

#[test]
fn powers_of_ten_and_their_logarithms_are_the_numbers_that_people_write() {
    for n in -22..=22 {
        let written: f64 = format!("1e{n}").parse().unwrap();
        assert_eq!((power_of_ten(f64::from(n)), log10(written)), (written, f64::from(n)), "10^{n}");
    }
    assert_eq!((power_of_ten(400.0), power_of_ten(-400.0)), (f64::INFINITY, 0.0));
}

#[test]
fn powers_of_two_are_exact_to_both_ends_of_the_range() {
    let mut power = 1.0;
    for n in 0..=1_025 {
        assert_eq!(power_of_two(n), power, "2^{n}");
        power *= 2.0;
    }
    power = 1.0;
    for n in 0..=1_080 {
        assert_eq!(power_of_two(-n), power, "2^-{n}");
        power /= 2.0;
    }
    assert_eq!((power_of_two(i32::MAX), power_of_two(i32::MIN)), (f64::INFINITY, 0.0));
}

/// What the functions below are asked, and the parts of it that suit those with narrower domains.
const ARGUMENTS: [f64; 12] = [-2.5, -1.0, -0.7, -0.1, 1e-8, 0.1, 0.5, 0.9, 1.1, 2.0, 3.7, 12.5];

type Row = (&'static str, fn(f64) -> f64, [u64; 12]);

/// The bits of every function, so that another version of the library shows.
const PINNED: &[Row] = &[
    (
        "sin",
        sin,
        [
            0xbfe3_26af_0dcf_cab0,
            0xbfea_ed54_8f09_0cee,
            0xbfe4_9d6e_6946_19b8,
            0xbfb9_8eae_cb8b_cb2c,
            0x3e45_798e_e230_8c3a,
            0x3fb9_8eae_cb8b_cb2c,
            0x3fde_aee8_744b_05f0,
            0x3fe9_1103_985d_a841,
            0x3fec_84c5_4c2d_6338,
            0x3fed_18f6_ead1_b446,
            0xbfe0_f46a_ec2e_1b41,
            0xbfb0_fa78_cc21_cfbb,
        ],
    ),
    (
        "cos",
        cos,
        [
            0xbfe9_a2f7_ef85_8b7d,
            0x3fe1_4a28_0fb5_068c,
            0x3fe8_7996_529f_9d93,
            0x3fef_d712_f9a8_17c1,
            0x3ff0_0000_0000_0000,
            0x3fef_d712_f9a8_17c1,
            0x3fec_1528_065b_7d50,
            0x3fe3_e43a_9692_e21c,
            0x3fdd_07b8_06c7_6111,
            0xbfda_a226_5753_7205,
            0xbfeb_23a2_ad7d_d937,
            0x3fef_edf6_a822_7774,
        ],
    ),
    (
        "tan",
        tan,
        [
            0x3fe7_e79b_4e00_bb15,
            0xbff8_eb24_5cbe_e3a6,
            0xbfea_f406_c2fc_78ae,
            0xbfb9_af88_7743_0b80,
            0x3e45_798e_e230_8c3a,
            0x3fb9_af88_7743_0b80,
            0x3fe1_7b4f_5bf3_474a,
            0x3ff4_299b_a9c2_a138,
            0x3fff_6fa7_d286_214e,
            0xc001_7af6_2e09_50f8,
            0x3fe3_fdd0_37da_3554,
            0xbfb1_0410_0d06_7f5b,
        ],
    ),
    (
        "asin of a part",
        |x| asin(x / 12.5),
        [
            0xbfc9_c618_aa4a_e23d,
            0xbfb4_807d_1320_318c,
            0xbfac_afdf_b247_e5e3,
            0xbf80_6259_470f_3852,
            0x3e0b_7cdf_d9d7_bdbb,
            0x3f80_6259_470f_3852,
            0x3fa4_7c47_73ae_bd59,
            0x3fb2_72ad_abd9_2524,
            0x3fb6_8ea3_3687_1ec8,
            0x3fc4_9182_e599_c592,
            0x3fd3_3b6d_d882_9a64,
            0x3ff9_21fb_5444_2d18,
        ],
    ),
    (
        "acos of a part",
        |x| acos(x / 12.5),
        [
            0x3ffc_5abe_698d_8960,
            0x3ffa_6a03_2576_3031,
            0x3ffa_077a_51d6_6c47,
            0x3ff9_42c0_06d2_4b89,
            0x3ff9_21fb_540d_3359,
            0x3ff9_0136_a1b6_0ea8,
            0x3ff8_7e19_18a6_b72d,
            0x3ff7_fad0_7986_9ac6,
            0x3ff7_b911_20db_bb2c,
            0x3ff6_8fca_f790_f466,
            0x3ff4_531f_de23_8680,
            0x0000_0000_0000_0000,
        ],
    ),
    (
        "atan",
        atan,
        [
            0xbff3_0b6d_796a_4da8,
            0xbfe9_21fb_5444_2d18,
            0xbfe3_8b11_2d7b_d4ad,
            0xbfb9_83e2_82e2_cc4d,
            0x3e45_798e_e230_8c3a,
            0x3fb9_83e2_82e2_cc4d,
            0x3fdd_ac67_0561_bb4f,
            0x3fe7_7338_a806_03be,
            0x3fea_a7c8_5451_83cd,
            0x3ff1_b6e1_92eb_be44,
            0x3ff4_e8c9_4dbf_54e5,
            0x3ff7_daff_85a6_3058,
        ],
    ),
    (
        "atan2",
        |x| atan2(x, -0.7),
        [
            0xbffd_8039_b3f8_ab3d,
            0xc001_73c1_f581_0bb8,
            0xc002_d97c_7f33_21d2,
            0xc007_ff60_67fc_c98a,
            0x4009_21fb_5259_52a0,
            0x4007_ff60_67fc_c98a,
            0x4004_2bb5_f776_eb80,
            0x4001_dace_aa5d_c057,
            0x4001_19a6_fe19_b276,
            0x3ffe_8500_76ee_9e8e,
            0x3ffc_1fd9_4dd9_7ba8,
            0x3ffa_071e_5173_22da,
        ],
    ),
    (
        "hypot",
        |x| hypot(x, 0.7),
        [
            0x4004_c4ea_d061_e07a,
            0x3ff3_87ce_204a_35d2,
            0x3fef_adaa_8f7e_ed51,
            0x3fe6_a09e_667f_3bcc,
            0x3fe6_6666_6666_6667,
            0x3fe6_a09e_667f_3bcc,
            0x3feb_8706_5d24_cee3,
            0x3ff2_3e28_9628_0f23,
            0x3ff4_dc87_d614_51da,
            0x4000_f3a2_5ab4_c3b7,
            0x400e_2004_c242_d7bd,
            0x4029_0a07_0010_32a5,
        ],
    ),
    (
        "exp",
        exp,
        [
            0x3fb5_0385_c094_f425,
            0x3fd7_8b56_362c_ef38,
            0x3fdf_c80d_b9dd_5542,
            0x3fec_f46d_99d5_2b3a,
            0x3ff0_0000_02af_31dc,
            0x3ff1_aec7_b35a_00d4,
            0x3ffa_6129_8e1e_069c,
            0x4003_ad44_655c_78bc,
            0x4008_0888_3244_d593,
            0x401d_8e64_b8d4_ddae,
            0x4044_3941_44ee_ec81,
            0x4110_60c5_2565_ba66,
        ],
    ),
    (
        "exp_m1",
        exp_m1,
        [
            0xbfed_5f8f_47ed_617c,
            0xbfe4_3a54_e4e9_8864,
            0xbfe0_1bf9_2311_555f,
            0xbfb8_5c93_3156_a62c,
            0x3e45_798e_e3fd_b764,
            0x3fba_ec7b_35a0_0d3a,
            0x3fe4_c253_1c3c_0d38,
            0x3ff7_5a88_cab8_f178,
            0x4000_0888_3244_d593,
            0x4019_8e64_b8d4_ddae,
            0x4043_b941_44ee_ec81,
            0x4110_60c1_2565_ba66,
        ],
    ),
    (
        "ln of the size",
        |x| ln(x.abs()),
        [
            0x3fed_5240_f0e0_e078,
            0x0000_0000_0000_0000,
            0xbfd6_d3c3_24e1_3f50,
            0xc002_6bb1_bbb5_5515,
            0xc032_6bb1_bbb5_5516,
            0xc002_6bb1_bbb5_5515,
            0xbfe6_2e42_fefa_39ef,
            0xbfba_f8e8_210a_415c,
            0x3fb8_663f_793c_46cc,
            0x3fe6_2e42_fefa_39ef,
            0x3ff4_eeee_650a_e550,
            0x4004_34b1_382e_feb8,
        ],
    ),
    (
        "log2 of the size",
        |x| log2(x.abs()),
        [
            0x3ff5_269e_12f3_46e3,
            0x0000_0000_0000_0000,
            0xbfe0_7762_2896_7d13,
            0xc00a_934f_0979_a371,
            0xc03a_934f_0979_a371,
            0xc00a_934f_0979_a371,
            0xbff0_0000_0000_0000,
            0xbfc3_74d6_5d9e_608d,
            0x3fc1_99b7_28cb_9d0c,
            0x3ff0_0000_0000_0000,
            0x3ffe_334d_b2c3_56b0,
            0x400d_269e_12f3_46e3,
        ],
    ),
    (
        "log10 of the size",
        |x| log10(x.abs()),
        [
            0x3fd9_77d9_5ec1_0c02,
            0x0000_0000_0000_0000,
            0xbfc3_d3d3_d21c_cf04,
            0xbff0_0000_0000_0000,
            0xc020_0000_0000_0000,
            0xbff0_0000_0000_0000,
            0xbfd3_4413_509f_79ff,
            0xbfa7_6d86_9b02_a02e,
            0x3fa5_316c_0a18_add7,
            0x3fd3_4413_509f_79ff,
            0x3fe2_2eb5_61cc_c100,
            0x3ff1_8cf1_8388_6481,
        ],
    ),
    (
        "asinh",
        asinh,
        [
            0xbffa_5b0f_0be9_dcf6,
            0xbfec_3436_6179_d427,
            0xbfe4_e2a4_fe90_85dd,
            0xbfb9_8eb9_e7e5_fc3f,
            0x3e45_798e_e230_8c3a,
            0x3fb9_8eb9_e7e5_fc3f,
            0x3fde_cc2c_aec5_160a,
            0x3fe9_e23c_e96e_38d4,
            0x3fee_693d_f6ed_f1e7,
            0x3ff7_1921_8313_d087,
            0x4000_2772_2182_47cc,
            0x4009_c386_d2b8_b56e,
        ],
    ),
    (
        "cbrt",
        cbrt,
        [
            0xbff5_b720_9557_b0ee,
            0xbff0_0000_0000_0000,
            0xbfec_69b5_a72f_1a99,
            0xbfdd_b4c7_760b_cff3,
            0x3f61_a62d_511f_2b53,
            0x3fdd_b4c7_760b_cff3,
            0x3fe9_65fe_a53d_6e3d,
            0x3fee_e549_fe70_85e7,
            0x3ff0_8438_2783_23a4,
            0x3ff4_28a2_f98d_728b,
            0x3ff8_bf33_eb6b_7486,
            0x4002_90fc_a9c7_61f8,
        ],
    ),
    (
        "powf of the size",
        |x| powf(x.abs(), 2.4),
        [
            0x4022_08a3_c34e_ac07,
            0x3ff0_0000_0000_0000,
            0x3fdb_30bc_b6ea_848e,
            0x3f70_4e74_cc73_ee88,
            0x3bf2_9f60_ffec_df70,
            0x3f70_4e74_cc73_ee88,
            0x3fc8_4060_03b2_ae5d,
            0x3fe8_d9ae_a11b_d810,
            0x3ff4_1cc1_c85f_4457,
            0x4015_1cb4_53b9_536c,
            0x4037_1a95_26da_51f5,
            0x407a_d200_de89_c68a,
        ],
    ),
    (
        "powf with it as the exponent",
        |x| powf(0.7, x),
        [
            0x4003_8391_5751_388f,
            0x3ff6_db6d_b6db_6db7,
            0x3ff4_89a5_4f2d_42c0,
            0x3ff0_94bb_1030_b017,
            0x3fef_ffff_fe15_ca29,
            0x3fee_e0f6_172e_7679,
            0x3fea_c5eb_3f7a_b2f8,
            0x3fe7_369f_7d10_f686,
            0x3fe5_9d79_103a_1fba,
            0x3fdf_5c28_f5c2_8f5b,
            0x3fd1_1a11_e26a_d98e,
            0x3f87_b77d_eb2c_a3c6,
        ],
    ),
    (
        "powi",
        |x| powi(x, -7),
        [
            0xbf5a_d7f2_9abc_af48,
            0xbff0_0000_0000_0000,
            0xc028_490a_4f86_c9a5,
            0xc163_12cf_ffff_fffc,
            0x4b90_5031_e250_3da7,
            0x4163_12cf_ffff_fffc,
            0x4060_0000_0000_0000,
            0x4000_b9db_f70d_86fc,
            0x3fe0_6bca_92ef_4a05,
            0x3f80_0000_0000_0000,
            0x3f1b_9d28_fda9_7c3b,
            0x3e56_849b_86a1_2b9b,
        ],
    ),
];

#[test]
fn bits_are_the_same_as_ever() {
    for (name, function, pinned) in PINNED {
        for (x, bits) in ARGUMENTS.into_iter().zip(pinned) {
            assert_eq!(function(x).to_bits(), *bits, "{name} of {x}");
        }
    }
}
