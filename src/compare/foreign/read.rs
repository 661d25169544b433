//! Reading the lines of a foreign ray tracer, with every error at its line and column.

use super::line::{Line, MEMBERS, RayWord};
use crate::record::Triple;
use serde_json::{Map, Value};
use std::fmt;

/// What a foreign ray tracer says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForeignTrace {
    /// Its lines that say something, in order.
    pub lines: Vec<Line>,
}

/// Something that cannot be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineError {
    /// The line, from 1.
    pub line: usize,
    /// The column in characters, from 1.
    pub column: usize,
    /// What was read, what was expected, and what to do.
    pub message: String,
}

impl fmt::Display for LineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}, column {}: {}", self.line, self.column, self.message)
    }
}

/// Errors that are kept: nobody reads more.
const MOST_ERRORS: usize = 50;

impl ForeignTrace {
    /// Reads JSON lines. Blank lines and lines that begin with `#` are passed over.
    ///
    /// # Errors
    /// All that cannot be read, the first 50 of it.
    pub fn read(text: &str) -> Result<Self, Vec<LineError>> {
        let (mut lines, mut errors) = (Vec::new(), Vec::new());
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        for (number, line) in (1..).zip(text.lines()) {
            let trimmed = line.trim();
            if trimmed.is_empty() || trimmed.starts_with('#') {
                continue;
            }
            match read_line(number, line) {
                Ok(line) => lines.push(line),
                Err(wrong) => errors.extend(wrong),
            }
            if errors.len() >= MOST_ERRORS {
                errors.truncate(MOST_ERRORS);
                return Err(errors);
            }
        }
        if lines.is_empty() && errors.is_empty() {
            let message = "there is nothing to compare: expected lines such as {\"pixel\": [320, 240]}".to_owned();
            errors.push(LineError { line: 1, column: 1, message });
        }
        if errors.is_empty() { Ok(Self { lines }) } else { Err(errors) }
    }

    /// The size of the picture, where a line tells it.
    #[must_use]
    pub fn size(&self) -> Option<[u32; 2]> {
        self.lines.iter().find_map(|line| line.size)
    }

    /// What is called otherwise than anything in the format, with the line, each name once.
    #[must_use]
    pub fn unknown(&self) -> Vec<String> {
        let mut unknown: Vec<String> = Vec::new();
        let mut known: Vec<&String> = Vec::new();
        for line in &self.lines {
            for message in &line.unknown {
                if !known.contains(&message) {
                    known.push(message);
                    unknown.push(format!("line {}: {message}", line.number));
                }
            }
        }
        unknown
    }
}

fn read_line(number: usize, text: &str) -> Result<Line, Vec<LineError>> {
    let error = |column: usize, message: String| LineError { line: number, column, message };
    let value: Value = serde_json::from_str(text).map_err(|wrong| {
        let said = wrong.to_string();
        let what = said.split(" at line ").next().unwrap_or(&said);
        let help = if ["NaN", "nan", "inf", "Inf"].iter().any(|word| text.contains(word)) {
            "; JSON has no NaN and no infinity: write null"
        } else {
            ""
        };
        vec![error(characters(text, wrong.column()), format!("this is not JSON: {what}{help}"))]
    })?;
    let Value::Object(members) = value else {
        return Err(vec![error(1, format!("expected an object in braces, found {}", short(&value)))]);
    };
    let mut reader = Reader { members, text, errors: Vec::new(), number };
    let line = reader.line();
    if reader.errors.is_empty() { Ok(line) } else { Err(reader.errors) }
}

/// The column in characters of a column in bytes.
fn characters(text: &str, bytes: usize) -> usize {
    let end = text.floor_char_boundary(bytes.saturating_sub(1));
    text[..end].chars().count() + 1
}

struct Reader<'a> {
    members: Map<String, Value>,
    text: &'a str,
    errors: Vec<LineError>,
    number: usize,
}

impl Reader<'_> {
    fn line(&mut self) -> Line {
        Line {
            number: self.number,
            unknown: self.unknown(),
            pixel: self.member("pixel", "a column and a row such as [320, 240], counted from 0", whole_numbers),
            size: self.member("size", "columns and rows such as [640, 480]", whole_numbers),
            ray: self.member("ray", "\"camera\", \"reflected\", \"refracted\" or \"shadow\"", ray_word),
            origin: self.triple("origin"),
            direction: self.direction("direction"),
            depth: self.member("depth", "a whole number", |value| value.as_u64().and_then(|x| x.try_into().ok())),
            object: self.words("object"),
            leaf: self.words("leaf"),
            generic_origin: self.triple("generic_origin"),
            generic_direction: self.direction("generic_direction"),
            hits: self.member("hits", "a list of hit times such as [2.5, 4]", times),
            inside: self.member("inside", "a list of intervals such as [[2.5, 4], [5, null]]", intervals),
            hit: self.or_null("hit", "an object's name, or null for no hit", words),
            t: self.number("t"),
            point: self.triple("point"),
            normal: self.direction("normal"),
            outward: self.direction("outward"),
            light: self.words("light"),
            towards: self.direction("towards"),
            lit: self.member("lit", "true or false", Value::as_bool),
            blocked_by: self.words("blocked_by"),
            diffuse: self.triple("diffuse"),
            specular: self.triple("specular"),
            reflected: self.direction("reflected"),
            refracted: self.or_null("refracted", "a direction such as [0, 0.6, -0.8], or null for none", some_length),
            n1: self.number("n1"),
            n2: self.number("n2"),
            colour: self.triple("colour").or(self.triple("color")),
            ambient: self.triple("ambient"),
            mirrored: self.triple("mirrored"),
            transmitted: self.triple("transmitted"),
            written: self.member("written", "three bytes such as [255, 128, 0]", bytes),
        }
    }

    /// A member that may be there; `null` is as good as nothing.
    fn member<T>(&mut self, name: &str, expected: &str, read: impl Fn(&Value) -> Option<T>) -> Option<T> {
        self.or_null(name, expected, read).flatten()
    }

    /// A member for which `null` says something.
    #[expect(clippy::option_option, reason = "left out, `null`, and a value are three things")]
    fn or_null<T>(&mut self, name: &str, expected: &str, read: impl Fn(&Value) -> Option<T>) -> Option<Option<T>> {
        match self.members.get(name) {
            None => None,
            Some(Value::Null) => Some(None),
            Some(value) => {
                let found = read(value);
                if found.is_none() {
                    let message = format!("`{name}`: expected {expected}, found {}", short(value));
                    self.errors.push(LineError { line: self.number, column: self.column(name), message });
                }
                found.map(Some)
            }
        }
    }

    fn triple(&mut self, name: &str) -> Option<Triple> {
        self.member(name, "three numbers such as [0, 0.5, 1]", triple)
    }

    fn direction(&mut self, name: &str) -> Option<Triple> {
        self.member(name, "three numbers such as [0, 0, 1] that are not all 0", some_length)
    }

    fn number(&mut self, name: &str) -> Option<f64> {
        self.member(name, "a number", Value::as_f64)
    }

    fn words(&mut self, name: &str) -> Option<String> {
        self.member(name, "a name in quotes", words)
    }

    fn column(&self, name: &str) -> usize {
        let place = self.text.find(&format!("\"{name}\"")).unwrap_or(0);
        self.text[..place].chars().count() + 1
    }

    fn unknown(&self) -> Vec<String> {
        let is_known = |name: &str| MEMBERS.contains(&name) || name == "color";
        let names = self.members.keys().filter(|name| !is_known(name));
        names
            .map(|name| match nearest(name) {
                Some(meant) => format!("`{name}` is not part of the format; did you mean `{meant}`?"),
                None => format!("`{name}` is not part of the format, and is not compared"),
            })
            .collect()
    }
}

/// The member that a name is most likely a slip of.
fn nearest(name: &str) -> Option<&'static str> {
    let distance = |known: &str| strsim::damerau_levenshtein(&name.to_lowercase(), known);
    let near = MEMBERS.iter().filter(|known| distance(known) <= (known.len() / 3).max(1));
    near.min_by_key(|known| distance(known)).copied()
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}

fn triple(value: &Value) -> Option<Triple> {
    numbers(value)?.try_into().ok()
}

fn some_length(value: &Value) -> Option<Triple> {
    triple(value).filter(|v| *v != [0.0; 3])
}

fn times(value: &Value) -> Option<Vec<f64>> {
    numbers(value)
}

fn intervals(value: &Value) -> Option<Vec<[Option<f64>; 2]>> {
    let end = |value: &Value| if value.is_null() { Some(None) } else { value.as_f64().map(Some) };
    let interval = |value: &Value| -> Option<[Option<f64>; 2]> {
        value.as_array()?.iter().map(end).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    value.as_array()?.iter().map(interval).collect()
}

fn whole_numbers(value: &Value) -> Option<[u32; 2]> {
    let list: Option<Vec<u32>> = value.as_array()?.iter().map(|x| x.as_u64()?.try_into().ok()).collect();
    list?.try_into().ok()
}

fn bytes(value: &Value) -> Option<[u8; 3]> {
    let list: Option<Vec<u8>> = value.as_array()?.iter().map(|x| x.as_u64()?.try_into().ok()).collect();
    list?.try_into().ok()
}

fn words(value: &Value) -> Option<String> {
    value.as_str().map(str::to_owned)
}

fn ray_word(value: &Value) -> Option<RayWord> {
    let word = value.as_str()?;
    RayWord::ALL.into_iter().find(|kind| kind.name() == word)
}

/// The value as it was written, or the beginning of it.
fn short(value: &Value) -> String {
    let text = value.to_string();
    if text.chars().count() <= 40 { text } else { text.chars().take(39).chain(['…']).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_line_says_what_it_has_and_nothing_is_required() {
        let text = "# my ray tracer\n\n{\"pixel\": [3, 4]}\n{\"ray\": \"camera\", \"direction\": [0, 0, -2]}\n\
                    {\"hit\": null}\n{\"refracted\": null, \"n1\": 1.5}\n{\"inside\": [[1, null]], \"object\": \"floor\"}\n{}";
        let trace = ForeignTrace::read(text).unwrap();
        assert_eq!(trace.lines.len(), 6);
        assert_eq!((trace.lines[0].number, trace.lines[0].pixel), (3, Some([3, 4])));
        assert_eq!((trace.lines[1].ray, trace.lines[1].origin), (Some(RayWord::Camera), None));
        assert_eq!(trace.lines[2].hit, Some(None));
        assert_eq!((trace.lines[3].refracted, trace.lines[3].n1), (Some(None), Some(1.5)));
        assert_eq!(trace.lines[4].inside, Some(vec![[Some(1.0), None]]));
    }

    #[test]
    fn errors_name_line_and_column_and_what_was_expected() {
        for (text, line, column, part) in [
            ("{\"pixel\": [1, 2]}\n{\"t\": \"five\"}", 2, 2, "`t`: expected a number, found \"five\""),
            ("{\"ray\": \"camera\", \"origin\": [1, 2]}", 1, 19, "`origin`: expected three numbers"),
            ("[1, 2]", 1, 1, "expected an object in braces"),
            ("{\"t\": NaN}", 1, 7, "JSON has no NaN"),
            ("{\"ray\": \"primary\"}", 1, 2, "\"camera\", \"reflected\""),
            ("{\"direction\": [0, 0, 0]}", 1, 2, "not all 0"),
            ("{\"pixel\": [1.5, 2]}", 1, 2, "a column and a row"),
            ("", 1, 1, "nothing to compare"),
        ] {
            let errors = ForeignTrace::read(text).unwrap_err();
            assert_eq!((errors[0].line, errors[0].column), (line, column), "{text}: {}", errors[0]);
            assert!(errors[0].message.contains(part), "{}", errors[0]);
        }
    }

    #[test]
    fn names_that_are_not_part_of_the_format_are_told_once() {
        let text = "{\"normel\": [0, 0, 1]}\n{\"normel\": [0, 0, 1], \"time_taken\": 3}";
        let unknown = ForeignTrace::read(text).unwrap().unknown();
        assert_eq!(unknown.len(), 2);
        assert_eq!(unknown[0], "line 1: `normel` is not part of the format; did you mean `normal`?");
        assert!(unknown[1].starts_with("line 2: `time_taken`"));
    }

    #[test]
    fn nonsense_is_answered_and_never_a_panic() {
        for text in
            ["{", "}", "\"", "{\"a\"", "\u{0}", "{\"inside\": [[1]]}", "{\"hits\": [[]]}", "{\"t\": 1e999}", "é{"]
        {
            let _ = ForeignTrace::read(text);
        }
    }
}
