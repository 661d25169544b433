//! Reading a JSON file by its schema: all errors at once, each at its place.

use super::check::check;
use super::diagnostics::Diagnostics;
use super::problem::{Path, Problem, Problems};
use super::rules::Rules;
use super::source::{locate, parse, to_value};
use serde::de::DeserializeOwned;

/// Checks `text` by `rules`, reads it as a `File` and makes of it what `compile` says, which notes what else is wrong and gives
/// `Some` where nothing is. `origin` names the file in messages.
///
/// # Errors
/// Everything that is wrong with the file, not only the first.
pub(super) fn read_checked<File: DeserializeOwned, T>(
    text: &str,
    origin: &str,
    rules: &Rules,
    compile: impl FnOnce(File, &mut Problems) -> Option<T>,
) -> Result<T, Diagnostics> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let ast = parse(text).map_err(|(range, message)| {
        let problem = Problem { steps: Vec::new(), at_name: false, message, help: Vec::new() };
        Diagnostics::new(origin, text, vec![(range, problem)], 0)
    })?;
    let mut problems = Problems::default();
    let value = to_value(&ast, Path::Root, &mut problems);
    check(rules, &rules.root, &value, Path::Root, &mut problems);
    let read = File::deserialize(&value).ok().and_then(|file| compile(file, &mut problems));
    match read {
        Some(read) if problems.list.is_empty() => Ok(read),
        _ => {
            let place = |problem: Problem| (locate(&ast, &problem.steps, problem.at_name), problem);
            let left_out = problems.left_out;
            Err(Diagnostics::new(origin, text, problems.distinct().into_iter().map(place).collect(), left_out))
        }
    }
}
