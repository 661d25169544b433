//! A formula in words, as a person would read it out: signs, fractions, powers and roots by their names, brackets kept.

mod scripts;
mod symbols;
mod tables;

use ratex_parser::ParseNode;
use symbols::{function, word};

/// The parts of a formula, read out one after the other.
pub fn of(nodes: &[ParseNode]) -> String {
    let mut words = Words::default();
    let mut i = 0;
    while i < nodes.len() {
        if let Some((call, after)) = call(nodes, i) {
            words.push(&call);
            i = after;
        } else {
            words.node(&nodes[i]);
            i += 1;
        }
    }
    tidied(&words.said)
}

/// What has been said of a row of parts.
#[derive(Default)]
struct Words {
    said: Vec<String>,
    /// Whether a number may go on: its digits come one by one.
    in_number: bool,
}

impl Words {
    fn push(&mut self, words: &str) {
        self.in_number = false;
        self.said.push(words.to_owned());
    }

    fn node(&mut self, node: &ParseNode) {
        if let Some(digit) = digit(node) {
            match self.said.last_mut() {
                Some(number) if self.in_number => number.push_str(digit),
                _ => self.said.push(digit.to_owned()),
            }
            self.in_number = true;
            return;
        }
        match node {
            ParseNode::SupSub { base, sup, sub, .. } => {
                // Of 1.5² the power belongs to the whole number, but hangs on its last digit.
                if let Some(base) = base.as_deref().filter(|base| digit(base).is_some()) {
                    self.node(base);
                    let base = self.said.pop().unwrap_or_default();
                    self.push(&scripts::scripted(&base, sup.as_deref(), sub.as_deref()));
                } else {
                    self.push(&scripts::with_base(base.as_deref(), sup.as_deref(), sub.as_deref()));
                }
            }
            other => self.push(&node_words(other)),
        }
    }
}

fn digit(node: &ParseNode) -> Option<&str> {
    match node {
        ParseNode::TextOrd { text, .. } if text == "." || text.bytes().all(|byte| byte.is_ascii_digit()) => Some(text),
        _ => None,
    }
}

/// One part.
fn node_words(node: &ParseNode) -> String {
    match node {
        ParseNode::Atom { text, .. }
        | ParseNode::MathOrd { text, .. }
        | ParseNode::TextOrd { text, .. }
        | ParseNode::OpToken { text, .. }
        | ParseNode::SpacingNode { text, .. } => word(text).to_owned(),
        ParseNode::SupSub { base, sup, sub, .. } => scripts::with_base(base.as_deref(), sup.as_deref(), sub.as_deref()),
        ParseNode::GenFrac { numer, denom, has_bar_line, .. } => {
            let [numer, denom] = [numer, denom].map(|part| grouped(&node_words(part)));
            if *has_bar_line { format!("{numer} over {denom}") } else { format!("{numer} choose {denom}") }
        }
        ParseNode::Sqrt { body, index, .. } => {
            let body = grouped(&node_words(body));
            match index.as_deref().map(node_words).as_deref() {
                None => format!("the square root of {body}"),
                Some("3") => format!("the cube root of {body}"),
                Some(index) => format!("the root of order {index} of {body}"),
            }
        }
        ParseNode::Accent { label, base, .. } => accented(label, &node_words(base)),
        ParseNode::Overline { body, .. } => accented("\\bar", &node_words(body)),
        ParseNode::Op { .. } | ParseNode::OperatorName { .. } => format!("{} of", operator(node)),
        ParseNode::Text { body, .. } => body.iter().map(raw).collect(),
        // Upright letters are a name.
        ParseNode::Font { font, body, .. } if matches!(font.as_str(), "mathrm" | "mathtt" | "mathsf") => name(body),
        ParseNode::LeftRight { body, left, right, .. } => tables::delimited(body, left, right),
        ParseNode::Array { .. } => tables::rows(node),
        other => wrapped(other),
    }
}

/// Of what only changes the looks: what is in it.
fn wrapped(node: &ParseNode) -> String {
    match node {
        ParseNode::OrdGroup { body, .. }
        | ParseNode::Styling { body, .. }
        | ParseNode::Sizing { body, .. }
        | ParseNode::Color { body, .. }
        | ParseNode::MClass { body, .. }
        | ParseNode::HBox { body, .. }
        | ParseNode::Pmb { body, .. }
        | ParseNode::Html { body, .. }
        | ParseNode::HtmlMathMl { html: body, .. }
        | ParseNode::MathChoice { text: body, .. }
        | ParseNode::Tag { body, .. } => of(body),
        ParseNode::Font { body, .. }
        | ParseNode::Underline { body, .. }
        | ParseNode::Smash { body, .. }
        | ParseNode::Lap { body, .. }
        | ParseNode::RaiseBox { body, .. }
        | ParseNode::VCenter { body, .. }
        | ParseNode::Enclose { body, .. }
        | ParseNode::AccentUnder { base: body, .. }
        | ParseNode::HorizBrace { base: body, .. } => node_words(body),
        ParseNode::DelimSizing { delim, .. } | ParseNode::Middle { delim, .. } => word(delim).to_owned(),
        ParseNode::XArrow { body, .. } => format!("arrow {}", node_words(body)),
        // Gaps, rules and what is there to take up room only.
        _ => String::new(),
    }
}

fn name(body: &ParseNode) -> String {
    let is_letter = |node: &ParseNode| matches!(node, ParseNode::MathOrd { text, .. } if text.chars().count() == 1);
    match body {
        ParseNode::OrdGroup { body, .. } if body.iter().all(is_letter) => body.iter().map(raw).collect(),
        other => node_words(other),
    }
}

/// Texts within a formula, as they stand.
fn raw(node: &ParseNode) -> String {
    match node {
        ParseNode::SpacingNode { .. } => " ".to_owned(),
        ParseNode::TextOrd { text, .. } | ParseNode::MathOrd { text, .. } | ParseNode::Atom { text, .. } => {
            if text.starts_with('\\') { word(text).to_owned() } else { text.clone() }
        }
        ParseNode::OrdGroup { body, .. } | ParseNode::Text { body, .. } => body.iter().map(raw).collect(),
        other => node_words(other),
    }
}

/// `sine`, `the sum`, `area`.
fn operator(node: &ParseNode) -> String {
    match node {
        ParseNode::Op { symbol: true, name: Some(name), .. } => word(name).to_owned(),
        ParseNode::Op { name: Some(name), .. } => {
            let named = word(name);
            if named == "the limit" { named.to_owned() } else { function(named).to_owned() }
        }
        ParseNode::Op { body: Some(body), .. } => of(body),
        ParseNode::OperatorName { body, .. } => function(&body.iter().map(raw).collect::<String>()).to_owned(),
        other => node_words(other),
    }
}

fn accented(label: &str, base: &str) -> String {
    match label {
        "\\vec" | "\\overrightarrow" => format!("the vector {base}"),
        "\\hat" | "\\widehat" => format!("{base} hat"),
        "\\bar" | "\\overline" => format!("{base} bar"),
        "\\dot" => format!("{base} dot"),
        "\\tilde" | "\\widetilde" => format!("{base} tilde"),
        _ => base.to_owned(),
    }
}

/// In brackets, unless it is one word or in brackets already.
fn grouped(words: &str) -> String {
    if words.contains(' ') { format!("({words})") } else { words.to_owned() }
}

/// `d of t` for d(t): a letter before brackets that hold nothing but single letters or numbers. A product is not written so.
fn call(nodes: &[ParseNode], at: usize) -> Option<(String, usize)> {
    let name = named(&nodes[at])?;
    let is = |node: &ParseNode, sign: &str| matches!(node, ParseNode::Atom { text, .. } if text == sign);
    nodes.get(at + 1).filter(|node| is(node, "("))?;
    let inside = &nodes[at + 2..];
    let length = inside.iter().position(|node| is(node, ")"))?;
    let holds_names = length > 0 && inside[..length].iter().all(|node| named(node).is_some() || is(node, ","));
    let starts_apart = inside[..length].windows(2).all(|pair| is(&pair[0], ",") != is(&pair[1], ","));
    (holds_names && starts_apart).then(|| (format!("{name} of {}", of(&inside[..length])), at + 3 + length))
}

/// A letter, with marks below or a prime.
fn named(node: &ParseNode) -> Option<String> {
    match node {
        ParseNode::MathOrd { text, .. } => Some(word(text).to_owned()),
        ParseNode::Font { body, .. } => named(body),
        ParseNode::OrdGroup { body, .. } if body.len() == 1 => named(&body[0]),
        ParseNode::SupSub { base: Some(base), sup: None, .. } => named(base).map(|_| node_words(node)),
        _ => None,
    }
}

/// The words with single spaces, and brackets and commas close to what they belong to.
fn tidied(said: &[String]) -> String {
    let joined = said.join(" ");
    let mut out = String::with_capacity(joined.len());
    for word in joined.split_whitespace() {
        let close = out.ends_with(['(', '[', '{']) || word.starts_with([')', ']', '}', ',', ';', '!']);
        if !out.is_empty() && !close {
            out.push(' ');
        }
        out.push_str(word);
    }
    out
}
