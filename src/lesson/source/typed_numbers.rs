//! Numbers that were typed: a lesson takes its numbers from recorded rays.

/// The first typed number of a text, with its byte: digits on their own. Sections (`§ 6.2.3`) and names with a letter (`f64`) are
/// none.
pub fn in_text(text: &str) -> Option<(usize, &str)> {
    let mut at = 0;
    let mut after_section = false;
    while at < text.len() {
        let rest = &text[at..];
        let length = rest.find(|c: char| !is_of_token(c)).unwrap_or(rest.len());
        if length == 0 {
            let c = rest.chars().next().unwrap_or(' ');
            after_section = c == '§' || (after_section && (c.is_whitespace() || c == '–'));
            at += c.len_utf8();
            continue;
        }
        let token = &rest[..length];
        let has_letter = token.chars().any(char::is_alphabetic);
        if token.starts_with(|c: char| c.is_ascii_digit()) && !has_letter && !after_section {
            return Some((at, token.trim_end_matches('.')));
        }
        after_section = after_section && token.chars().all(|c| c.is_ascii_digit() || c == '.' || c == '–');
        at += length;
    }
    None
}

fn is_of_token(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '.' | '_' | '′')
}

/// The first number with decimals in a formula or in code, with its byte: whole numbers belong to formulas, others are measured.
pub fn in_formula(text: &str) -> Option<(usize, &str)> {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    text.match_indices('.').find_map(|(dot, _)| {
        let before = text[..dot].chars().next_back();
        if !is_digit(before) || !is_digit(text[dot + 1..].chars().next()) {
            return None;
        }
        let start = text[..dot].rfind(|c: char| !c.is_ascii_digit()).map_or(0, |at| at + 1);
        let start = text[start..].char_indices().find(|(_, c)| c.is_ascii_digit()).map_or(start, |(at, _)| start + at);
        let end = text[dot + 1..].find(|c: char| !c.is_ascii_digit()).map_or(text.len(), |at| dot + 1 + at);
        // A section's number has more than one dot.
        let is_section = text[end..].starts_with('.') && is_digit(text[end + 1..].chars().next());
        (!is_section && !text[..start].ends_with('.')).then(|| (start, &text[start..end]))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_on_their_own_are_typed_numbers() {
        assert_eq!(in_text("The ray hits at t = 3.5 and goes on."), Some((20, "3.5")));
        assert_eq!(in_text("It has 6 planes."), Some((7, "6")));
        assert_eq!(in_text("a share of −12 %"), Some((14, "12")));
    }

    #[test]
    fn sections_names_and_words_are_none() {
        assert_eq!(in_text("As § 6.2.3 says, f64 and BK7 in 3D: six planes, S₁ and t₂."), None);
        assert_eq!(in_text("§§ 6.3.0 – 6.3.8"), None);
    }

    #[test]
    fn formulas_have_whole_numbers_alone() {
        assert_eq!(in_formula("x^2 + y^2 - (1 + (s - 1) z)^2"), None);
        assert_eq!(in_formula("t = 3.25 + s"), Some((4, "3.25")));
    }
}
