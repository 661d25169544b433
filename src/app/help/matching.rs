//! How well a name goes with a few typed letters.

/// How well `name` goes with what was typed: its letters in order, better where they stand together and at the beginnings of words,
/// placed as well as they can be. None if they are not in it.
#[must_use]
pub fn score(typed: &str, name: &str) -> Option<i32> {
    let name: Vec<char> = name.to_lowercase().chars().collect();
    // For each place the best score of the letters so far with the last of them there.
    let mut best: Option<Vec<Option<i32>>> = None;
    for letter in typed.to_lowercase().chars().filter(|letter| !letter.is_whitespace()) {
        let here = |place: usize| (name[place] == letter).then(|| placed(&name, place, best.as_deref())).flatten();
        best = Some((0..name.len()).map(here).collect());
    }
    let score = best.map_or(Some(0), |best| best.into_iter().flatten().max())?;
    // Of two names that go equally well, the shorter one is meant.
    Some(score * 64 - i32::try_from(name.len().min(63)).unwrap_or(63))
}

/// The best score with a letter at a place, after those before it.
fn placed(name: &[char], place: usize, before: Option<&[Option<i32>]>) -> Option<i32> {
    let alone = if place == 0 || !name[place - 1].is_alphanumeric() { 3 } else { 1 };
    let Some(before) = before else { return Some(alone) };
    let together = place.checked_sub(1).and_then(|last| before[last]).map(|score| score + 4);
    let apart = before[..place].iter().flatten().max().map(|score| score + alone);
    together.max(apart)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_have_to_be_there_in_order() {
        assert!(score("zin", "Zoom in").is_some());
        assert!(score("niz", "Zoom in").is_none());
    }

    #[test]
    fn beginnings_of_words_go_before_letters_in_the_middle() {
        assert!(score("nt", "Next total") > score("nt", "Intent"));
        assert!(score("theme", "Theme: dark") > score("theme", "The meadow"));
    }

    #[test]
    fn what_is_typed_in_full_is_found_whatever_words_begin_with() {
        assert!(score("save slides as", "Save slides as PDF…").is_some());
        assert!(score("slides", "Save slides as PDF…") > score("slides", "Sides, lines and other edges"));
    }

    #[test]
    fn nothing_typed_goes_with_everything_and_the_shorter_first() {
        assert!(score("", "Out") > score("", "Overview"));
    }
}
