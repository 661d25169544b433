//! The catalogues as they are compiled in.

use super::Language;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource};
use std::sync::OnceLock;

/// The files of a language: one for each area of the interface.
macro_rules! files {
    ($language:literal) => {
        [
            include_str!(concat!("../../assets/words/", $language, "/accuracy.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/compare.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/drawings.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/edit.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/effects.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/everyone.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/frame.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/lesson.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/picture.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/search.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/share.ftl")),
            include_str!(concat!("../../assets/words/", $language, "/step.ftl")),
        ]
    };
}

const fn files(language: Language) -> [&'static str; 12] {
    match language {
        Language::English => files!("en"),
        Language::German => files!("de"),
    }
}

fn bundle(language: Language) -> &'static FluentBundle<FluentResource> {
    static BUNDLES: [OnceLock<FluentBundle<FluentResource>>; Language::ALL.len()] = [OnceLock::new(), OnceLock::new()];
    BUNDLES[language as usize].get_or_init(|| {
        let mut bundle = FluentBundle::new_concurrent(vec![language.tag().parse().unwrap_or_default()]);
        // The marks around arguments serve texts that run both ways, which no language here does; fonts lack them.
        bundle.set_use_isolating(false);
        for text in files(language) {
            // What can be read of a file with an error is used; a test looks for errors.
            let resource = FluentResource::try_new(text.to_owned()).unwrap_or_else(|(resource, _)| resource);
            bundle.add_resource_overriding(resource);
        }
        bundle
    })
}

/// A message of this language; none if it has none of that name.
pub fn message(language: Language, id: &str, arguments: &FluentArgs) -> Option<String> {
    let bundle = bundle(language);
    let pattern = bundle.get_message(id)?.value()?;
    Some(bundle.format_pattern(pattern, Some(arguments), &mut Vec::new()).into_owned())
}

/// Whether there is such a message.
pub fn has(language: Language, id: &str) -> bool {
    bundle(language).has_message(id)
}

/// Every message of a language, in order.
pub fn ids(language: Language) -> Vec<&'static str> {
    files(language).iter().flat_map(|file| file.lines()).filter_map(id_of).collect()
}

/// The name that a line begins a message with.
fn id_of(line: &'static str) -> Option<&'static str> {
    let (name, _) = line.split_once(" =")?;
    let is_name = name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
    is_name.then_some(name)
}

/// The arguments that a message asks for, in order.
#[cfg(test)]
pub fn arguments(language: Language, id: &str) -> std::collections::BTreeSet<String> {
    let text = files(language).join("\n");
    let begin = text.find(&format!("\n{id} =")).map_or(0, |place| place + 1);
    let lines = text[begin..].lines();
    let message: Vec<&str> =
        lines.enumerate().take_while(|(i, line)| *i == 0 || line.starts_with(' ')).map(|(_, line)| line).collect();
    let message = message.join("\n");
    let names = message.split('$').skip(1);
    names.map(|rest| rest.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '-').collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_file_is_read_without_an_error() {
        for language in Language::ALL {
            for text in files(language) {
                if let Err((_, errors)) = FluentResource::try_new(text.to_owned()) {
                    panic!("{language:?}: {errors:?} in\n{text}");
                }
            }
        }
    }

    #[test]
    fn no_message_is_written_twice() {
        for language in Language::ALL {
            let mut seen = BTreeSet::new();
            for id in ids(language) {
                assert!(seen.insert(id), "{id} in {language:?}");
            }
        }
    }
}
