//! The file of an accuracy profile: JSON whose every member may be left out.

use super::diagnostics::Diagnostics;
use super::problem::{Path, Problems};
use super::reading::read_checked;
use super::rules::Rules;
use super::texture_file::FilterFile;
use super::{Profile, Shortcuts};
use crate::shape::{Method, Search};
use crate::texture::image::Filter;
use crate::texture::relief::BumpDerivative;
use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use std::sync::LazyLock;

/// An accuracy profile: values for what trades accuracy for time. What is left out is as the scene says.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default)]
#[schemars(deny_unknown_fields, title = "rayscope accuracy profile")]
pub struct ProfileFile {
    /// Where the schema of this file is, for editors. Not used otherwise.
    #[serde(rename = "$schema", skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub schema: Option<String>,
    /// A line for people: what the profile is for, or how it was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    pub note: Option<String>,
    /// The numbers that hits are computed with.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "ArithmeticFile")]
    pub arithmetic: Option<ArithmeticFile>,
    /// What finds the roots, in double precision.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "RootsFile")]
    pub roots: Option<RootsFile>,
    /// How hits with superellipsoids are searched for.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "SearchFile")]
    pub search: Option<SearchFile>,
    /// Places in each pixel that rays are sent through.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 65536))]
    pub samples: Option<u32>,
    /// Points of the lens for each place in a pixel.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 65536))]
    pub lens_samples: Option<u32>,
    /// Wavelengths that a ray is split into where it first meets a dispersive surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 256))]
    pub wavelengths: Option<u32>,
    /// Rays deeper than this are not spawned.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(max = 64))]
    pub depth: Option<u32>,
    /// Rays whose colour would count less than this in the pixel are not spawned.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "f64", range(min = 0, max = 1))]
    pub contribution: Option<f64>,
    /// The most octaves of every sum of noise.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "u32", range(min = 1, max = 16))]
    pub octaves: Option<u32>,
    /// How every image is filtered.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "FilterFile")]
    pub filter: Option<FilterFile>,
    /// Whether normals of bumpy surfaces are worked out without the small terms.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "BumpTermsFile")]
    pub bump: Option<BumpTermsFile>,
    /// What is left out of what spares rays their tests. No picture depends on it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Vec<ShortcutFile>")]
    pub without: Option<Vec<ShortcutFile>>,
}

/// The numbers that hits are computed with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
pub enum ArithmeticFile {
    /// Single precision, with nothing to fall back on.
    #[serde(rename = "f32")]
    Single,
    /// Double precision, with nothing to fall back on.
    #[serde(rename = "f64")]
    Double,
    /// Double precision, and 32 digits where that leaves the answer open.
    #[serde(rename = "adaptive")]
    Adaptive,
    /// 32 digits from the start.
    #[serde(rename = "double-double")]
    DoubleDouble,
}

/// What finds the roots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum RootsFile {
    /// The textbook's solvers.
    Textbook,
    /// The program's solvers in double precision alone: the arithmetic f64.
    Recentred,
    /// The same with a certificate for every answer: the arithmetic adaptive.
    Certified,
}

/// How hits with superellipsoids are searched for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum SearchFile {
    /// By a word.
    Word(SearchWord),
    /// By so many equal stretches of the ray's way through the box, each looked at once.
    Stretches(#[schemars(range(min = 2, max = 65536))] u32),
}

/// The search that cannot step over a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SearchWord {
    /// By the program's own solver.
    Certified,
}

/// How normals of bumpy surfaces are worked out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BumpTermsFile {
    /// The terms b n_u and b n_v are dropped.
    Dropped,
    /// Nothing is dropped.
    Exact,
}

/// Something that spares rays their tests.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ShortcutFile {
    /// The boxes around solids and their parts.
    Boxes,
    /// The balls around those for which they are much smaller than boxes.
    Balls,
    /// The rectangles of objects in the picture.
    Projections,
    /// The trees of boxes over the objects, and over what large unions are made of.
    Hierarchy,
    /// The grids of what the eye and the lights see.
    Sights,
}

/// The JSON Schema of accuracy profiles.
#[cfg(not(target_arch = "wasm32"))]
#[must_use]
pub fn profile_schema() -> Schema {
    schemars::schema_for!(ProfileFile)
}

/// The JSON Schema of accuracy profiles, as the program has written it elsewhere.
#[cfg(target_arch = "wasm32")]
#[must_use]
pub fn profile_schema() -> Schema {
    super::file::written_schema(include_str!("../../scenes/profile.schema.json"))
}

impl Profile {
    /// Reads the text of a profile; `origin` names it in messages.
    ///
    /// # Errors
    /// Everything that is wrong with it, each at its line and column.
    pub fn read(text: &str, origin: &str) -> Result<Self, Diagnostics> {
        static RULES: LazyLock<Rules> = LazyLock::new(|| Rules::new(profile_schema().as_value()));
        read_checked(text, origin, &RULES, |file: ProfileFile, problems| Some(compile(&file, problems)))
    }

    /// The text of a profile file that [`read`](Self::read) reads as this profile, with a line for people.
    ///
    /// # Errors
    /// Says so where a number is none that JSON can hold.
    pub fn to_json(&self, note: &str) -> Result<String, String> {
        let file = ProfileFile { note: (!note.is_empty()).then(|| note.to_owned()), ..ProfileFile::from(self) };
        serde_json::to_string_pretty(&file).map(|text| text + "\n").map_err(|error| error.to_string())
    }
}

fn compile(file: &ProfileFile, problems: &mut Problems) -> Profile {
    Profile {
        method: method(file.arithmetic, file.roots, problems),
        search: file.search.map(|search| match search {
            SearchFile::Word(SearchWord::Certified) => Search::Certified,
            SearchFile::Stretches(stretches) => Search::Stretches(stretches),
        }),
        samples: file.samples,
        lens_samples: file.lens_samples,
        wavelengths: file.wavelengths,
        depth: file.depth,
        contribution: file.contribution,
        octaves: file.octaves,
        filter: file.filter.map(Filter::from),
        bump: file.bump.map(|bump| match bump {
            BumpTermsFile::Dropped => BumpDerivative::Dropped,
            BumpTermsFile::Exact => BumpDerivative::Exact,
        }),
        shortcuts: file.without.as_deref().map(without),
    }
}

/// Arithmetic and roots name the same thing from two sides; where both stand they must mean the same.
fn method(arithmetic: Option<ArithmeticFile>, roots: Option<RootsFile>, problems: &mut Problems) -> Option<Method> {
    let by_arithmetic = arithmetic.map(|arithmetic| match arithmetic {
        ArithmeticFile::Single => Method::Single,
        ArithmeticFile::Double => Method::Double,
        ArithmeticFile::Adaptive => Method::Adaptive,
        ArithmeticFile::DoubleDouble => Method::DoubleDouble,
    });
    let by_roots = roots.map(|roots| match roots {
        RootsFile::Textbook => Method::Textbook,
        RootsFile::Recentred => Method::Double,
        RootsFile::Certified => Method::Adaptive,
    });
    if let (Some(arithmetic), Some(roots)) = (by_arithmetic, by_roots)
        && arithmetic != roots
    {
        let message = format!("these roots are not found in the arithmetic {}", arithmetic.name());
        problems.add(Path::Root.field("roots"), message).help(
            "leave out `arithmetic`, or `roots`: \"recentred\" is the arithmetic \"f64\", \"certified\" is \"adaptive\", \
             and \"textbook\" has no other than f64",
        );
    }
    by_roots.or(by_arithmetic)
}

fn without(left_out: &[ShortcutFile]) -> Shortcuts {
    let keeps = |shortcut| !left_out.contains(&shortcut);
    Shortcuts {
        boxes: keeps(ShortcutFile::Boxes),
        balls: keeps(ShortcutFile::Balls),
        projections: keeps(ShortcutFile::Projections),
        hierarchy: keeps(ShortcutFile::Hierarchy),
        sights: keeps(ShortcutFile::Sights),
    }
}

impl From<FilterFile> for Filter {
    fn from(file: FilterFile) -> Self {
        match file {
            FilterFile::Nearest => Self::Nearest,
            FilterFile::Bilinear => Self::Bilinear,
            FilterFile::Trilinear => Self::Trilinear,
            FilterFile::Area => Self::Area,
            FilterFile::Ewa => Self::Ewa,
        }
    }
}

impl From<Filter> for FilterFile {
    fn from(filter: Filter) -> Self {
        match filter {
            Filter::Nearest => Self::Nearest,
            Filter::Bilinear => Self::Bilinear,
            Filter::Trilinear => Self::Trilinear,
            Filter::Area => Self::Area,
            Filter::Ewa => Self::Ewa,
        }
    }
}

impl From<&Profile> for ProfileFile {
    fn from(profile: &Profile) -> Self {
        let (arithmetic, roots) = match profile.method {
            // The exact method is for measuring the others by, and no profile's.
            None | Some(Method::Exact) => (None, None),
            Some(Method::Single) => (Some(ArithmeticFile::Single), None),
            Some(Method::Double) => (Some(ArithmeticFile::Double), None),
            Some(Method::Adaptive) => (Some(ArithmeticFile::Adaptive), None),
            Some(Method::DoubleDouble) => (Some(ArithmeticFile::DoubleDouble), None),
            Some(Method::Textbook) => (None, Some(RootsFile::Textbook)),
        };
        Self {
            arithmetic,
            roots,
            search: profile.search.map(|search| match search {
                Search::Certified => SearchFile::Word(SearchWord::Certified),
                Search::Stretches(stretches) => SearchFile::Stretches(stretches),
            }),
            samples: profile.samples,
            lens_samples: profile.lens_samples,
            wavelengths: profile.wavelengths,
            depth: profile.depth,
            contribution: profile.contribution,
            octaves: profile.octaves,
            filter: profile.filter.map(FilterFile::from),
            bump: profile.bump.map(|bump| match bump {
                BumpDerivative::Dropped => BumpTermsFile::Dropped,
                BumpDerivative::Exact => BumpTermsFile::Exact,
            }),
            without: profile.shortcuts.map(|shortcuts| left_out(&shortcuts)),
            ..Self::default()
        }
    }
}

fn left_out(shortcuts: &Shortcuts) -> Vec<ShortcutFile> {
    let all = [
        (shortcuts.boxes, ShortcutFile::Boxes),
        (shortcuts.balls, ShortcutFile::Balls),
        (shortcuts.projections, ShortcutFile::Projections),
        (shortcuts.hierarchy, ShortcutFile::Hierarchy),
        (shortcuts.sights, ShortcutFile::Sights),
    ];
    all.into_iter().filter(|(kept, _)| !kept).map(|(_, shortcut)| shortcut).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again() {
        let full = Profile {
            search: Some(Search::Stretches(64)),
            bump: Some(BumpDerivative::Exact),
            shortcuts: Some(Shortcuts { balls: false, ..Shortcuts::ALL }),
            ..Profile::DRAFT
        };
        let methods = Method::ALL.map(|method| Profile { method: Some(method), ..Profile::STANDARD });
        let named = Profile::NAMED.map(|(_, profile)| profile);
        for profile in named.into_iter().chain(methods).chain([full]) {
            let text = profile.to_json("a note").unwrap();
            assert_eq!(Profile::read(&text, "test").unwrap(), profile, "{text}");
        }
    }

    #[test]
    fn everything_that_is_wrong_is_said_at_its_place() {
        let text = "{\n  \"samples\": 0,\n  \"arithmetic\": \"f64\",\n  \"roots\": \"textbok\",\n  \"dept\": 3\n}";
        let errors = Profile::read(text, "profile.json").unwrap_err().to_string();
        for expected in ["profile.json:2", "samples", "did you mean \"textbook\"?", "did you mean `depth`?"] {
            assert!(errors.contains(expected), "{expected} is not in\n{errors}");
        }
    }

    #[test]
    fn roots_that_contradict_the_arithmetic_are_refused() {
        let read = |text| Profile::read(text, "test");
        let errors = read(r#"{"arithmetic": "f32", "roots": "certified"}"#).unwrap_err().to_string();
        assert!(errors.contains("these roots are not found in the arithmetic f32"), "{errors}");
        let agreed = read(r#"{"arithmetic": "adaptive", "roots": "certified"}"#).unwrap();
        assert_eq!(agreed.method, Some(Method::Adaptive));
    }
}
