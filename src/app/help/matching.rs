//! How well a name goes with a few typed letters.

/// How well `name` goes with what was typed: its letters in order, better where they stand together and at the beginnings of words.
/// None if they are not in it.
#[must_use]
pub fn score(typed: &str, name: &str) -> Option<i32> {
    let name: Vec<char> = name.to_lowercase().chars().collect();
    let mut score = 0;
    let mut at = 0;
    let mut previous: Option<usize> = None;
    for letter in typed.to_lowercase().chars().filter(|letter| !letter.is_whitespace()) {
        let starts_word = |place: usize| place == 0 || !name[place - 1].is_alphanumeric();
        let mut places = (at..name.len()).filter(|&place| name[place] == letter);
        let first = places.clone().next()?;
        // The next letter of the same word, or the beginning of another one, rather than the first that comes.
        let follows = |place: &usize| previous.is_some_and(|before| *place == before + 1);
        let place = if follows(&first) { first } else { places.find(|&place| starts_word(place)).unwrap_or(first) };
        score += match () {
            () if follows(&place) => 4,
            () if starts_word(place) => 3,
            () => 1,
        };
        previous = Some(place);
        at = place + 1;
    }
    // Of two names that go equally well, the shorter one is meant.
    Some(score * 64 - i32::try_from(name.len().min(63)).unwrap_or(63))
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
    fn nothing_typed_goes_with_everything_and_the_shorter_first() {
        assert!(score("", "Out") > score("", "Overview"));
    }
}
