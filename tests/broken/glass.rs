//! Materials whose light cannot be.

use super::Case;

/// Materials; they stand in line 2 of a file, under the name `odd`.
pub const GLASS: &[Case] = &[
    Case {
        text: r#"{"fresnel": {"kind": "dielectric"}, "reflectivity": 0.25}"#,
        place: "2:53 at materials.odd.reflectivity",
        message: "`odd` has both `fresnel` and a `reflectivity` of 0.25",
        help: "Fresnel's equations decide how much is mirrored: leave `reflectivity` out, or `fresnel`",
    },
    Case {
        text: r#"{"fresnel": {"kind": "metal", "metal": "gold"}, "transparency": 0.5}"#,
        place: "2:65 at materials.odd.transparency",
        message: "`odd` is a metal with a `transparency` of 0.5",
        help: "light does not come through metals: leave `transparency` out, or take `dielectric`",
    },
    Case {
        text: r#"{"fresnel": {"kind": "conductor", "eta": [1, 0, 1], "k": [2, 0, 2]}}"#,
        place: "2:13 at materials.odd.fresnel",
        message: "an index of refraction η + i k that no metal has",
        help: "for each colour `eta` and `k` are at most 1000000, and not both 0",
    },
    Case {
        text: r#"{"fresnel": {"kind": "conductor", "eta": [1, 1, 1], "k": [2, 1e200, 2]}}"#,
        place: "2:13 at materials.odd.fresnel",
        message: "an index of refraction η + i k that no metal has",
        help: "for each colour `eta` and `k` are at most 1000000, and not both 0",
    },
    Case {
        text: r#"{"dispersion": {"kind": "glass", "glass": "BK7"}}"#,
        place: "2:16 at materials.odd.dispersion",
        message: "`odd` has a `dispersion`, and no light comes in to meet it",
        help: "give it a `transparency` above 0, or leave `dispersion` out",
    },
    Case {
        text: r#"{"medium": {"absorption": [0.1, 0.2, 0.3]}}"#,
        place: "2:12 at materials.odd.medium",
        message: "`odd` has a `medium`, and no light comes in to meet it",
        help: "give it a `transparency` above 0, or leave `medium` out",
    },
    Case {
        text: r#"{"transparency": 1, "dispersion": {"kind": "cauchy", "coefficients": [-1, 0.5, 0]}}"#,
        place: "2:35 at materials.odd.dispersion",
        message: "the index of refraction of `odd` at 707 nm is 0.000302091",
        help: "expected a number of at least 0.001 for every wavelength from 380 to 780 nm; λ is in micrometres in the formula",
    },
    Case {
        text: r#"{"transparency": 1, "dispersion": {"kind": "sellmeier", "b": [1, 0, 0], "c": [0.25, 0, 0]}}"#,
        place: "2:35 at materials.odd.dispersion",
        message: "the index of refraction of `odd` at 500 nm is ∞",
        help: "expected a number of at least 0.001 for every wavelength from 380 to 780 nm; λ is in micrometres in the formula",
    },
    Case {
        text: r#"{"transparency": 1, "dispersion": {"kind": "glass", "glass": "SF12"}}"#,
        place: "2:62 at materials.odd.dispersion.glass",
        message: r#"expected one of "BK7", "SF11", "water", "diamond", found "SF12""#,
        help: r#"did you mean "SF11"?"#,
    },
];
