//! Drawings in the colours of whoever reads: light or dark, by one picture.
//!
//! A drawing is made twice, for light and for dark ground. Where the two differ in nothing but colours, each pair of colours
//! becomes a variable of the page's style, which the reader's system sets.

use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Pairs of colours for light and dark ground, each with its number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Colours {
    known: BTreeMap<[String; 2], usize>,
}

/// What stands before a colour in SVG, and how long it is: `fill="#1c1f24"`.
const BEFORE: &str = "=\"#";
const DIGITS: usize = 6;

impl Colours {
    /// One drawing for light and dark of those two; both, each with its class, where they differ in more than colours.
    pub fn of_both(&mut self, light: &str, dark: &str) -> String {
        self.merged(light, dark).unwrap_or_else(|| {
            let classed = |svg: &str, class: &str| svg.replacen("<svg ", &format!("<svg class=\"{class}\" "), 1);
            classed(light, "light") + &classed(dark, "dark")
        })
    }

    fn merged(&mut self, light: &str, dark: &str) -> Option<String> {
        let pairs = light.split(BEFORE).zip(dark.split(BEFORE));
        if light.matches(BEFORE).count() != dark.matches(BEFORE).count() {
            return None;
        }
        let mut merged = String::with_capacity(light.len());
        for (i, (of_light, of_dark)) in pairs.enumerate() {
            let rest = if i == 0 {
                (of_light == of_dark).then_some(of_light)?
            } else {
                let ([light, rest], [dark, other]) = (colour_and_rest(of_light)?, colour_and_rest(of_dark)?);
                if rest != other {
                    return None;
                }
                let count = self.known.len();
                let number = *self.known.entry([light.to_owned(), dark.to_owned()]).or_insert(count);
                let _ = write!(merged, "=\"var(--c{number})");
                rest
            };
            merged.push_str(rest);
        }
        Some(merged)
    }

    /// The variables as CSS.
    pub fn css(&self) -> String {
        if self.known.is_empty() {
            return String::new();
        }
        let all = |of: usize| {
            self.known.iter().fold(String::new(), |mut css, (pair, number)| {
                let _ = write!(css, "--c{number}:#{};", pair[of]);
                css
            })
        };
        // On paper drawings are light, whatever the screen is.
        format!(":root{{{}}}@media screen and (prefers-color-scheme:dark){{:root{{{}}}}}", all(0), all(1))
    }
}

fn colour_and_rest(text: &str) -> Option<[&str; 2]> {
    let colour = text.get(..DIGITS).filter(|colour| colour.bytes().all(|byte| byte.is_ascii_hexdigit()))?;
    Some([colour, &text[DIGITS..]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_that_differ_in_colours_alone_become_one() {
        let mut colours = Colours::default();
        let [light, dark] =
            ["1c1f24", "e8eaed"].map(|ink| format!("<svg a=\"1\"><path fill=\"#{ink}\" stroke=\"#ffffff\"/></svg>"));
        let merged = colours.of_both(&light, &dark);
        assert_eq!(merged, "<svg a=\"1\"><path fill=\"var(--c0)\" stroke=\"var(--c1)\"/></svg>");
        assert!(colours.css().starts_with(":root{--c0:#1c1f24;--c1:#ffffff;}"), "{}", colours.css());
        assert!(colours.css().contains("dark){:root{--c0:#e8eaed;--c1:#ffffff;}}"));
    }

    #[test]
    fn drawings_that_differ_in_more_are_both_kept() {
        let both = Colours::default().of_both("<svg x=\"1\"/>", "<svg x=\"2\"/>");
        assert_eq!(both, "<svg class=\"light\" x=\"1\"/><svg class=\"dark\" x=\"2\"/>");
    }
}
