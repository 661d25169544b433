//! Closures that run with egui's context locked look into nothing that would lock it again.

use super::rust_files;

/// Calls that lock egui's context for as long as what they are handed runs.
const LOCKING: &[&str] = &[
    "data",
    "data_mut",
    "input",
    "input_mut",
    "memory",
    "memory_mut",
    "options",
    "options_mut",
    "fonts",
    "fonts_mut",
    "output",
    "output_mut",
    "graphics",
    "graphics_mut",
    "viewport",
    "widget_info",
];

/// What looks into the context, and what says words, which does so too.
const LOCKED_OUT: &[&str] = &["ui", "ctx", "context", "say", "say_with", "language"];

/// The closures of a source that are run with the context locked.
fn run_locked(text: &str) -> Vec<&str> {
    let opens = |name: &str| [format!(".{name}(|"), format!(".{name}(move |")];
    let patterns: Vec<String> = LOCKING.iter().flat_map(|name| opens(name)).collect();
    let begins = patterns.iter().flat_map(|pattern| text.match_indices(pattern));
    begins.map(|(at, pattern)| within_parentheses(&text[at + pattern.find('(').unwrap()..])).collect()
}

/// What stands between the parenthesis that a text begins with and its partner.
fn within_parentheses(text: &str) -> &str {
    let mut depth = 0;
    for (at, character) in text.char_indices() {
        depth += i32::from(character == '(') - i32::from(character == ')');
        if depth == 0 {
            return &text[1..at];
        }
    }
    text
}

fn words_of(code: &str) -> impl Iterator<Item = &str> {
    code.split(|character: char| !character.is_alphanumeric() && character != '_').filter(|word| !word.is_empty())
}

/// A second look from within waits for ever as soon as a thread waits to ask for a repaint.
#[test]
fn nothing_looks_into_the_context_while_it_is_locked() {
    let mut broken = Vec::new();
    for file in rust_files("src/app") {
        let code: Vec<&str> = file.code().map(|(_, line)| line).collect();
        for closure in run_locked(&code.join("\n")) {
            if let Some(word) = words_of(closure).find(|word| LOCKED_OUT.contains(word)) {
                broken.push(format!("{}: `{word}` in `{closure}`", file.path));
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn the_reader_of_locked_closures_finds_them_to_their_end() {
    let text = "ui.data(|data| data.get(place(ui, (1, 2)))).or(x); ctx.input_mut(move |input| input.take());";
    assert_eq!(run_locked(text), ["|data| data.get(place(ui, (1, 2)))", "move |input| input.take()"]);
    assert!(words_of(run_locked(text)[0]).any(|word| word == "ui"));
    assert_eq!(words_of("quit(ui_of)").collect::<Vec<_>>(), ["quit", "ui_of"]);
}
