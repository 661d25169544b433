//! Events in words: the one-line row, the structured detail, and the tree as text.

mod beneath;
mod detail;
mod effect_detail;
mod effect_row;
mod explain;
mod format;
mod row;
mod tables;
mod texture_detail;
mod texture_row;
mod tree;

pub use beneath::{beneath, equated};
pub use detail::{Detail, DetailLine, detail};
pub use format::{brief, brief_vector, significant, span_list};
pub(super) use format::{count, degrees, times};
pub(super) use row::titled;
pub use row::{Row, row, untold_row};
pub(super) use texture_row::{angle_between, place, solid_angle, spoken};
pub use tree::{indent, tree_text};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::{Face, has_glyph, sample};

    #[test]
    fn every_character_of_every_event_has_a_glyph() {
        let tree = sample::every_kind();
        let mut text = tree_text(&tree);
        for event in &tree.events {
            let row = row(event);
            text.push(row.icon);
            text.extend([&row.label, &row.numbers, detail(event).explanation]);
        }
        for face in [Face::Sans, Face::Mono] {
            let missing: String = text.chars().filter(|&c| c != '\n' && !has_glyph(face, c)).collect();
            assert_eq!(missing, "", "in {face:?}");
        }
    }

    #[test]
    fn an_early_out_is_told_in_the_row_and_its_reason_below() {
        let text = tree_text(&sample::every_kind());
        assert!(text.contains("∩ pin = left ∩ right: early out   nothing\n"), "{text}");
        assert!(text.contains("early out: left is empty, so nothing can be inside both\n"), "{text}");
    }

    #[test]
    fn lists_of_intervals_name_leaf_and_part() {
        let text = tree_text(&sample::every_kind());
        let combined = "left − right: [4.5 surface of inner (turned round), 5 surface of outer]\n";
        assert!(text.contains(combined), "{text}");
    }

    #[test]
    fn rows_are_indented_below_their_parents() {
        let tree = sample::every_kind();
        let text = tree_text(&tree);
        for event in &tree.events {
            let row = row(event);
            let line = format!("\n{}{} {}", "  ".repeat(tree.depth(event.id)), row.icon, row.label);
            assert!(format!("\n{text}").contains(&line), "{line}");
        }
    }

    #[test]
    fn deep_rows_tell_their_level_and_stay_short() {
        assert_eq!(indent(3), "      ");
        assert_eq!(indent(60).len(), 120);
        assert_eq!(indent(61).trim_start(), "61: ");
        assert!(indent(20_000).len() < 130);
    }

    #[test]
    fn the_terms_of_a_turbulence_are_a_table_that_adds_up() {
        let text = tree_text(&sample::every_kind());
        let cells: Vec<Vec<&str>> = text.lines().map(|line| line.split_whitespace().collect()).collect();
        assert!(cells.contains(&vec!["2", "8", "0.125", "0.8", "0.1", "0.25"]), "{text}");
        assert!(cells.contains(&vec!["3", "16", "0.0625", "0.2", "0.0125", "0.2625"]), "{text}");
        assert!(text.contains("∿ turbulence: 4 terms   sum = 0.2625\n"), "{text}");
    }

    #[test]
    fn every_event_has_a_label_and_an_explanation() {
        for event in &sample::every_kind().events {
            assert!(!row(event).label.is_empty() && !detail(event).explanation.is_empty(), "{:?}", event.what);
        }
    }

    #[test]
    fn an_explanation_is_given_once() {
        let text = tree_text(&sample::every_kind());
        let sentence = "The ray from the eye through the pixel.";
        assert!(text.matches(sentence).count() <= 1);
        assert_eq!(text.matches("d(t) is positive outside the shape").count(), 1);
    }
}
