//! The nodes of a CSG tree in the order in which they are drawn, each with what the ray has in it.

use crate::csg::{Node, Solid};
use crate::record::{CandidateFate, Certificate, Edge, EventId, Operator, Sense, Span, What};
use crate::trace::RayTree;
use crate::view::text::titled;

/// A node of the tree.
pub(super) struct Row {
    /// The event that tells of it; none where it was never asked.
    pub event: Option<EventId>,
    pub depth: usize,
    pub operator: Option<Operator>,
    pub name: String,
    /// Whether it is the left or the right operand of the node above it; none for the root.
    pub side: Option<usize>,
    /// The inside intervals, or why it was never asked.
    pub spans: Result<Vec<Span>, String>,
    /// What is to be said of it besides.
    pub remark: Option<String>,
}

/// The rows of an object, the root first and operands below what they are combined to.
pub(super) fn rows(solid: &Solid, tree: &RayTree, object: EventId) -> Option<Vec<Row>> {
    let below = (object + 1)..tree.subtree_end(object);
    let is_root = |id: &EventId| matches!(tree.event(*id).what, What::Combine { .. } | What::Primitive { .. });
    let root = below.into_iter().find(is_root)?;
    let mut gather = Gather { solid, tree, rows: Vec::new() };
    let index = solid.nodes.len() - 1;
    let spans = match &tree.event(root).what {
        What::Combine { combined, .. } => combined.clone(),
        _ => gather.own_spans(root),
    };
    gather.node(index, Place { event: Some(root), depth: 0, side: None }, Ok(spans));
    Some(gather.rows)
}

struct Gather<'a> {
    solid: &'a Solid,
    tree: &'a RayTree,
    rows: Vec<Row>,
}

#[derive(Clone, Copy)]
struct Place {
    event: Option<EventId>,
    depth: usize,
    side: Option<usize>,
}

impl Gather<'_> {
    fn node(&mut self, index: usize, place: Place, spans: Result<Vec<Span>, String>) {
        let Place { event, depth, side } = place;
        match &self.solid.nodes[index] {
            Node::Leaf { leaf, .. } => {
                let leaf = &self.solid.leaves[*leaf];
                let remark = event.filter(|event| self.is_missed_by_extent(*event));
                let remark = remark.map(|_| "misses its extent".to_owned());
                let name = titled(leaf.shape.name(), &leaf.name);
                self.rows.push(Row { event, depth, operator: None, name, side, spans, remark });
            }
            Node::Pair { name, operator, left, right, .. } => {
                let reason = match &spans {
                    Err(reason) => reason.clone(),
                    Ok(_) => self.early_out(event).unwrap_or_default(),
                };
                let remark = spans.is_ok().then(|| self.early_out(event)).flatten();
                let remark = remark.map(|reason| format!("early out: {reason}"));
                self.rows.push(Row {
                    event,
                    depth,
                    operator: Some(*operator),
                    name: name.clone(),
                    side,
                    spans,
                    remark,
                });
                let operands = self.operands(event, [*left, *right]);
                for (side, (index, (event, list))) in [*left, *right].into_iter().zip(operands).enumerate() {
                    let spans = list.ok_or_else(|| reason.clone());
                    self.node(index, Place { event, depth: depth + 1, side: Some(side) }, spans);
                }
            }
        }
    }

    fn early_out(&self, event: Option<EventId>) -> Option<String> {
        match &self.tree.event(event?).what {
            What::Combine { early_out, .. } => early_out.clone(),
            _ => None,
        }
    }

    /// The events of both operands and their lists; none for those that were not asked.
    fn operands(&self, event: Option<EventId>, nodes: [usize; 2]) -> [(Option<EventId>, Option<Vec<Span>>); 2] {
        let Some(event) = event else { return [(None, None), (None, None)] };
        let What::Combine { left, right, .. } = &self.tree.event(event).what else {
            return [(None, None), (None, None)];
        };
        let mut combined = self.tree.children(event).filter(|child| matches!(child.what, What::Combine { .. }));
        let mut find = |node: usize| match &self.solid.nodes[node] {
            Node::Pair { .. } => combined.next().map(|child| child.id),
            Node::Leaf { leaf: wanted, .. } => {
                let is_it = |what: &What| matches!(what, What::Primitive { leaf, .. } if leaf == wanted);
                self.tree.children(event).find(|child| is_it(&child.what)).map(|child| child.id)
            }
        };
        let first = find(nodes[0]);
        let second = right.as_ref().and_then(|_| find(nodes[1]));
        [(first, first.map(|_| left.clone())), (second, second.and(right.clone()))]
    }

    /// A primitive's inside intervals from the hit times that it kept.
    fn own_spans(&self, primitive: EventId) -> Vec<Span> {
        let What::Primitive { leaf, name, .. } = &self.tree.event(primitive).what else { return Vec::new() };
        let found = (primitive..self.tree.subtree_end(primitive)).find_map(|id| match &self.tree.event(id).what {
            What::Roots { candidates } => Some(candidates),
            _ => None,
        });
        let mut spans: Vec<Span> = Vec::new();
        for candidate in found.into_iter().flatten().filter(|candidate| candidate.fate == CandidateFate::Accepted) {
            let (leaf, name, part) = (*leaf, name.clone(), candidate.part.clone());
            let certificate = Certificate::Certain;
            let edge = Some(Edge { t: candidate.t, leaf, name, part, flipped: false, certificate });
            match (candidate.sense, spans.last_mut().filter(|last| last.leave.is_none())) {
                (Sense::Leave, Some(last)) => last.leave = edge,
                (Sense::Leave, None) => spans.push(Span { enter: None, leave: edge }),
                (Sense::Enter, _) => spans.push(Span { enter: edge, leave: None }),
                (Sense::Touch, _) => spans.push(Span { enter: edge.clone(), leave: edge }),
            }
        }
        spans
    }

    /// Whether the ray was found to miss what holds the primitive, so that it was not worked out.
    fn is_missed_by_extent(&self, primitive: EventId) -> bool {
        self.tree
            .children(primitive)
            .any(|child| matches!(child.what, What::Extent { inside: None, .. } | What::Ball { is_met: false, .. }))
    }
}
