//! Interval lists to choose from, wherever a question is read.

use super::pose::{Reckoned, Stretch};
use crate::record::format_number;

/// The interval lists that are offered: the right one among the others, in an order that does not tell which it is.
#[must_use]
pub fn offered_lists(reckoned: &Reckoned<Vec<Stretch>>) -> Vec<&Vec<Stretch>> {
    let mut lists: Vec<_> =
        std::iter::once(&reckoned.answer).chain(reckoned.wrong.iter().map(|(list, _)| list)).collect();
    lists.sort_by_key(|list| list_text(list));
    lists.dedup();
    lists
}

/// An interval list in signs: `[1.5, 2] ∪ [3, ∞]`.
#[must_use]
pub fn list_text(list: &[Stretch]) -> String {
    let end = |t: Option<f64>, unbounded: &str| t.map_or(unbounded.to_owned(), format_number);
    let stretches: Vec<_> =
        list.iter().map(|[from, to]| format!("[{}, {}]", end(*from, "−∞"), end(*to, "∞"))).collect();
    if stretches.is_empty() { "∅".to_owned() } else { stretches.join(" ∪ ") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_lists_are_offered_once_and_the_right_one_is_among_them() {
        let list = |from: f64| vec![[Some(from), None]];
        let wrong = vec![(list(2.0), Vec::new()), (list(3.0), Vec::new()), (list(2.0), Vec::new())];
        let reckoned = Reckoned { answer: list(1.0), tolerance: 0.0, unit: String::new(), wrong };
        let lists = offered_lists(&reckoned);
        assert_eq!(lists.len(), 3);
        assert!(lists.contains(&&list(1.0)));
    }

    #[test]
    fn an_unbounded_end_and_an_empty_list_have_their_signs() {
        assert_eq!(list_text(&[[None, Some(1.5)], [Some(2.0), None]]), "[−∞, 1.5] ∪ [2, ∞]");
        assert_eq!(list_text(&[]), "∅");
    }
}
