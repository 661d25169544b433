//! Powers, indices and limits in words.

use super::{node_words, operator, tidied};
use ratex_parser::ParseNode;

/// A part with what stands above and below it.
pub fn with_base(base: Option<&ParseNode>, sup: Option<&ParseNode>, sub: Option<&ParseNode>) -> String {
    match base {
        Some(base @ (ParseNode::Op { .. } | ParseNode::OperatorName { .. })) => limited(base, sup, sub),
        Some(ParseNode::HorizBrace { base, .. }) => {
            let label = sup.or(sub).map(node_words).unwrap_or_default();
            format!("{}, which is {label},", node_words(base))
        }
        base => scripted(&base.map(node_words).unwrap_or_default(), sup, sub),
    }
}

/// `x sub 1 squared`.
pub fn scripted(base: &str, sup: Option<&ParseNode>, sub: Option<&ParseNode>) -> String {
    let sub = sub.map(|sub| format!("sub {}", node_words(sub))).unwrap_or_default();
    let sup = sup.map(|sup| power(&node_words(sup))).unwrap_or_default();
    tidied(&[base.to_owned(), sub, sup])
}

fn power(sup: &str) -> String {
    match sup {
        "2" => "squared".to_owned(),
        "3" => "cubed".to_owned(),
        "after" => "degrees".to_owned(),
        "top" | "intercal" => "transposed".to_owned(),
        "prime" | "prime prime" => sup.to_owned(),
        other => format!("to the power of {other}"),
    }
}

/// `the sum from i equals 0 to n of`, `sine squared of`, `the limit as t to 0 of`.
fn limited(base: &ParseNode, sup: Option<&ParseNode>, sub: Option<&ParseNode>) -> String {
    let name = operator(base);
    let [sup, sub] = [sup, sub].map(|part| part.map(node_words));
    match (base, sub, sup) {
        (ParseNode::Op { symbol: true, .. }, sub, sup) => {
            let from = sub.map(|sub| if sup.is_some() { format!("from {sub}") } else { format!("over {sub}") });
            let to = sup.map(|sup| format!("to {sup}"));
            tidied(&[name, from.unwrap_or_default(), to.unwrap_or_default(), "of".to_owned()])
        }
        (_, Some(sub), None) if name == "the limit" => format!("{name} as {sub} of"),
        (_, Some(sub), None) => format!("{name} over {sub} of"),
        (_, None, Some(sup)) => format!("{name} {} of", power(&sup)),
        (_, Some(sub), Some(sup)) => format!("{name} sub {sub} {} of", power(&sup)),
        (_, None, None) => format!("{name} of"),
    }
}
