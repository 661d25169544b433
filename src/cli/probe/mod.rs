//! `rayscope probe`: rays in, hits out, one JSON line each.

mod answer;
mod request;

use super::failure::{Failure, reason};
use answer::Answer;
use clap::Args;
use request::Request;
use serde_json::Value;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};

/// Answer questions about rays: JSON lines in, JSON lines out
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  rayscope probe < requests.jsonl > answers.jsonl
  echo '{\"id\": 1, \"solid\": {\"shape\": \"sphere\"}, \"ray\": {\"origin\": [0,0,3], \"direction\": [0,0,-1]}}' | rayscope probe
  echo '{\"id\": 2, \"interface\": {\"direction\": [0,1,-1], \"normal\": [0,0,1], \"n1\": 1, \"n2\": 1.5}}' | rayscope probe

A solid is written as in a scene file. Every request is answered by one line, in order: all hits for all t,
behind the origin too, and the intervals inside the solid, with null for an end without bound.
\"arithmetic\" is \"f32\", \"f64\" (if left out) or \"double-double\".
A request that cannot be answered gets {\"id\": …, \"error\": …}; the rest go on, and the exit code is 1 at the end.")]
pub struct Probe {}

/// Large enough that a full pipe is read and written in a few calls.
const BUFFER: usize = 1 << 16;

impl Probe {
    /// Answers until the input ends.
    #[expect(clippy::unused_self, reason = "every command is run in the same way")]
    pub fn run(&self) -> Result<(), Failure> {
        let input = BufReader::with_capacity(BUFFER, io::stdin().lock());
        let mut output = BufWriter::with_capacity(BUFFER, io::stdout().lock());
        let Count { refused, answered } = converse(input, &mut output)?;
        if refused == 0 {
            return Ok(());
        }
        Err(Failure::refused(format!("{refused} of {answered} requests could not be answered")))
    }
}

/// The answers to all requests in `input`, as `rayscope probe` writes them: one line each, in order.
///
/// For programs that ask without a pipe: fuzzers and tests.
#[must_use]
pub fn answers(input: &[u8]) -> Vec<u8> {
    let mut output = Vec::new();
    // Reading from memory and writing to it cannot fail; refusals are answers.
    let _ = converse(BufReader::new(input), &mut output);
    output
}

#[derive(Debug, PartialEq, Eq)]
struct Count {
    answered: usize,
    refused: usize,
}

/// Answers line by line. What is written goes out as soon as there is no further whole line to be read without waiting.
fn converse(mut input: BufReader<impl Read>, output: &mut impl Write) -> Result<Count, Failure> {
    let mut count = Count { answered: 0, refused: 0 };
    let mut line = Vec::new();
    for number in 1_usize.. {
        if !input.buffer().contains(&b'\n') {
            output.flush().map_err(|error| Failure::from_stdout(&error))?;
        }
        line.clear();
        let read = input.read_until(b'\n', &mut line);
        let length = read.map_err(|error| Failure::usage(format!("cannot read the requests: {}", reason(&error))))?;
        if length == 0 {
            break;
        }
        if line.trim_ascii().is_empty() {
            continue;
        }
        let (id, outcome) = answer_line(&line);
        let answer = outcome.unwrap_or_else(|problem| Answer::refusal(number, &problem));
        count.answered += 1;
        count.refused += usize::from(answer.is_refusal());
        answer.write(&id, output).map_err(|error| Failure::from_stdout(&error))?;
    }
    output.flush().map_err(|error| Failure::from_stdout(&error))?;
    Ok(count)
}

/// The request's id, `null` where it has none, and the answer, or what was wrong with the request.
fn answer_line(line: &[u8]) -> (Value, Result<Answer, String>) {
    let value: Value = match serde_json::from_slice(line) {
        Ok(value) => value,
        Err(error) => return (Value::Null, Err(not_json(&error))),
    };
    let id = value.get("id").cloned().unwrap_or(Value::Null);
    (id, Request::parse(&value).map(|request| Answer::to(&request)))
}

fn not_json(error: &serde_json::Error) -> String {
    let message = error.to_string();
    let what = message.split(" at line ").next().unwrap_or(&message);
    format!("column {}: this is not JSON: {what}", error.column())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hands out one line at a time, as a person at a terminal does, and checks what was answered before the next.
    struct Slow<'a> {
        lines: Vec<&'a [u8]>,
        written: std::rc::Rc<std::cell::RefCell<Vec<u8>>>,
        seen: Vec<usize>,
    }

    impl Read for &mut Slow<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.seen.push(self.written.borrow().split(|&byte| byte == b'\n').count() - 1);
            if self.lines.is_empty() {
                return Ok(0);
            }
            let line = self.lines.remove(0);
            buffer[..line.len()].copy_from_slice(line);
            Ok(line.len())
        }
    }

    struct Shared(std::rc::Rc<std::cell::RefCell<Vec<u8>>>);

    impl Write for Shared {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.borrow_mut().extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_line_is_answered_before_the_next_is_waited_for() {
        let written = std::rc::Rc::default();
        let lines: Vec<&[u8]> = vec![b"{\"id\": 1}\n", b"{\"id\": 2}\n", b"{\"id\"", b": 3}"];
        let mut slow = Slow { lines, written: std::rc::Rc::clone(&written), seen: Vec::new() };
        let mut output = BufWriter::new(Shared(written));
        let count = converse(BufReader::new(&mut slow), &mut output).unwrap();
        assert_eq!(count, Count { answered: 3, refused: 3 });
        assert_eq!(slow.seen[..4], [0, 1, 2, 2]);
    }

    #[test]
    fn blank_lines_are_passed_over_and_broken_ones_answered() {
        let mut output = Vec::new();
        let count = converse(BufReader::new(&b"\n  \n{]\n\xff\n"[..]), &mut output).unwrap();
        assert_eq!(count, Count { answered: 2, refused: 2 });
        let text = String::from_utf8(output).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines[0].starts_with("{\"id\":null,\"error\":\"line 3: column 2: this is not JSON"), "{}", lines[0]);
        assert!(lines[1].starts_with("{\"id\":null,\"error\":\"line 4:"), "{}", lines[1]);
    }
}
