//! A step with its rays recorded: what its expressions, questions and drawings are about.

use super::expression::{Expression, ExpressionError, Known, Question as Asked, Value};
use super::model::{Aim, Condition, Lesson, Sited, Step};
use super::place::{Finding, Place};
use super::prose::{Block, Inline, Line, Piece, Prose, Reference, Told};
use super::scenes::{Compiled, Scenes, Shelf, record};
use crate::document::Syntax;
use crate::query::Query;
use crate::record::EventId;
use crate::scene::Scene;
use crate::trace::RayTree;
use std::cell::Cell;
use std::sync::{Arc, OnceLock};

/// A step, traced.
#[derive(Clone)]
pub struct Stage {
    /// The lesson's file, for messages.
    pub file: String,
    /// The lesson that it is a step of.
    pub lesson: String,
    /// What is aimed at.
    pub aim: Aim,
    /// The scene and its text.
    pub scene: Arc<Compiled>,
    /// The recorded ray.
    pub tree: Arc<RayTree>,
    /// The selected event; the root where the step names none.
    pub event: EventId,
    /// The names of the step.
    names: Vec<(String, Sited<Expression>)>,
    /// The other traces of the step.
    also: Vec<(String, Arc<Compiled>, Arc<RayTree>)>,
    /// The scene's file as a value.
    file_value: Arc<OnceLock<Value>>,
}

impl Stage {
    /// Sets a step up.
    ///
    /// # Errors
    /// If something that it looks at is not there; where in the lesson, and why.
    pub fn new(lesson: &Lesson, step: &Step, scenes: &Scenes, shelf: &dyn Shelf) -> Result<Self, Finding> {
        Self::with_aim(lesson, step, &step.aim, scenes, shelf)
    }

    /// Sets a step up with another aim: one of its variants.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn with_aim(
        lesson: &Lesson,
        step: &Step,
        aim: &Aim,
        scenes: &Scenes,
        shelf: &dyn Shelf,
    ) -> Result<Self, Finding> {
        let finding = |place: Place, message: String| Finding { file: lesson.file.clone(), place, message };
        let trace = |aim: &Aim| scenes.trace(&lesson.id, aim, shelf).map_err(|message| finding(aim.place, message));
        let (scene, tree) = trace(aim)?;
        let event = match &step.event {
            None => 0,
            Some(query) => query.value.first(&tree).ok_or_else(|| {
                finding(query.place, format!("no event of the recorded ray answers `{}`", query.value))
            })?,
        };
        let mut also = Vec::new();
        for (name, other) in &step.also {
            let (scene, tree) = trace(other)?;
            also.push((name.clone(), scene, tree));
        }
        Ok(Self {
            file: lesson.file.clone(),
            lesson: lesson.id.clone(),
            aim: aim.clone(),
            scene,
            tree,
            event,
            names: step.names.clone(),
            also,
            file_value: Arc::default(),
        })
    }

    /// The same stage about another scene and ray: for edited scenes.
    ///
    /// # Errors
    /// If the ray or pixel cannot be traced in the scene.
    pub fn edited(&self, text: String, scene: Scene) -> Result<Self, String> {
        let at = self.aim.at.ok_or("nothing is aimed at")?;
        let tree = Arc::new(record(&scene, at)?);
        let scene = Arc::new(Compiled { name: self.scene.name.clone(), text, scene: Arc::new(scene) });
        Ok(Self { scene, tree, event: 0, file_value: Arc::default(), ..self.clone() })
    }

    /// What is looked at, in words: `csg/bowl, changed, pixel 333, 150`.
    #[must_use]
    pub fn aim_in_words(&self) -> String {
        let changed = if self.aim.changes.is_empty() { "" } else { ", changed" };
        let at = self.aim.at.map_or(String::new(), |at| format!(", {at}"));
        format!("{}{changed}{at}", self.aim.scene)
    }

    /// Whether the recorded ray fulfils a condition.
    ///
    /// # Errors
    /// If an expression has no value.
    pub fn fulfils(&self, condition: &Condition) -> Result<bool, ExpressionError> {
        match condition {
            Condition::Event(query) => Ok(query.first(&self.tree).is_some()),
            Condition::Holds(expression) => expression.holds(&self.known()),
        }
    }

    /// What expressions ask.
    #[must_use]
    pub fn known(&self) -> OnStage<'_> {
        OnStage { stage: self, seen: Cell::new(None), several: Cell::new(false), depth: Cell::new(0) }
    }

    /// A value of the text, as it is told.
    ///
    /// # Errors
    /// If it has none.
    pub fn told(&self, reference: &Reference) -> Result<Told, Finding> {
        let known = self.known();
        let value = reference.expression.evaluate(&known).map_err(|error| self.wrong(reference, &error.message))?;
        let text = match &value {
            Value::None | Value::Record(_) | Value::Trace(_) => {
                return Err(
                    self.wrong(reference, &format!("this is {}, and no text: name one of its fields", value.kind()))
                );
            }
            value => reference.format.written(value),
        };
        Ok(Told { text, from: reference.expression.text().to_owned(), event: known.looked_at() })
    }

    fn wrong(&self, reference: &Reference, message: &str) -> Finding {
        let message = format!("`{}`: {message}", reference.expression.text());
        Finding { file: self.file.clone(), place: reference.place, message }
    }

    /// What is wrong with an expression of the step.
    #[must_use]
    pub fn finding(&self, expression: &Sited<Expression>, error: &ExpressionError) -> Finding {
        let message = format!("`{}`: {}", expression.value.text(), error.message);
        Finding { file: self.file.clone(), place: expression.place, message }
    }

    /// A text with its values. What has none is left out, and told among the findings.
    pub fn tell(&self, prose: &[Block<Reference>], findings: &mut Vec<Finding>) -> Prose<Told> {
        prose.iter().map(|block| self.block(block, findings)).collect()
    }

    /// A line with its values.
    pub fn line(&self, line: &[Inline<Reference>], findings: &mut Vec<Finding>) -> Line<Told> {
        line.iter().filter_map(|inline| self.inline(inline, findings)).collect()
    }

    fn block(&self, block: &Block<Reference>, findings: &mut Vec<Finding>) -> Block<Told> {
        match block {
            Block::Paragraph(line) => Block::Paragraph(self.line(line, findings)),
            Block::Heading(line) => Block::Heading(self.line(line, findings)),
            Block::List { numbered, items } => {
                let items = items.iter().map(|item| self.tell(item, findings)).collect();
                Block::List { numbered: *numbered, items }
            }
            Block::Quote(blocks) => Block::Quote(self.tell(blocks, findings)),
            Block::Code(pieces) => Block::Code(self.pieces(pieces, findings)),
            Block::Formula(pieces) => Block::Formula(self.pieces(pieces, findings)),
            Block::Table { head, rows } => {
                let head = head.iter().map(|line| self.line(line, findings)).collect();
                let row = |row: &Vec<Line<Reference>>, findings: &mut Vec<Finding>| {
                    row.iter().map(|line| self.line(line, findings)).collect()
                };
                Block::Table { head, rows: rows.iter().map(|cells| row(cells, findings)).collect() }
            }
        }
    }

    fn inline(&self, inline: &Inline<Reference>, findings: &mut Vec<Finding>) -> Option<Inline<Told>> {
        Some(match inline {
            Inline::Text(text) => Inline::Text(text.clone()),
            Inline::Value(reference) => Inline::Value(self.value(reference, findings)?),
            Inline::Emphasis(line) => Inline::Emphasis(self.line(line, findings)),
            Inline::Strong(line) => Inline::Strong(self.line(line, findings)),
            Inline::Code(pieces) => Inline::Code(self.pieces(pieces, findings)),
            Inline::Formula(pieces) => Inline::Formula(self.pieces(pieces, findings)),
            Inline::Link(target, line) => Inline::Link(target.clone(), self.line(line, findings)),
            Inline::Break => Inline::Break,
        })
    }

    fn pieces(&self, pieces: &[Piece<Reference>], findings: &mut Vec<Finding>) -> Vec<Piece<Told>> {
        let piece = |piece: &Piece<Reference>| match piece {
            Piece::Text(text) => Some(Piece::Text(text.clone())),
            Piece::Value(reference) => self.value(reference, findings).map(Piece::Value),
        };
        pieces.iter().filter_map(piece).collect()
    }

    fn value(&self, reference: &Reference, findings: &mut Vec<Finding>) -> Option<Told> {
        self.told(reference).map_err(|finding| findings.push(finding)).ok()
    }

    fn tree_of(&self, trace: Option<&str>) -> Result<&RayTree, String> {
        match trace {
            None => Ok(&self.tree),
            Some(name) => self
                .also
                .iter()
                .find(|(known, ..)| known == name)
                .map(|(_, _, tree)| tree.as_ref())
                .ok_or_else(|| format!("the step has no trace `{name}`")),
        }
    }

    fn scene_value(&self) -> Value {
        let parsed = || {
            let (text, syntax) = (&self.scene.text, Syntax::of(&self.scene.text));
            syntax.root().map_or(Value::None, |root| Value::from(syntax.value(text, root)))
        };
        self.file_value.get_or_init(parsed).clone()
    }
}

/// A stage that is asked, and the events that it was asked for.
pub struct OnStage<'a> {
    stage: &'a Stage,
    seen: Cell<Option<EventId>>,
    several: Cell<bool>,
    depth: Cell<usize>,
}

/// Names may stand for names, this deep.
const MOST_DEPTH: usize = 16;

impl OnStage<'_> {
    /// The one event of the step's trace whose values were asked for; none where there were several or none.
    #[must_use]
    pub fn looked_at(&self) -> Option<EventId> {
        self.seen.get().filter(|_| !self.several.get())
    }

    fn see(&self, id: EventId) {
        if self.seen.get().is_some_and(|seen| seen != id) {
            self.several.set(true);
        }
        self.seen.set(Some(id));
    }
}

impl Known for OnStage<'_> {
    fn name(&self, name: &str) -> Option<Result<Value, String>> {
        if let Some((_, expression)) = self.stage.names.iter().find(|(known, _)| known == name) {
            if self.depth.get() >= MOST_DEPTH {
                return Some(Err(format!("`{name}` is explained by itself")));
            }
            self.depth.set(self.depth.get() + 1);
            let value = expression.value.evaluate(self);
            self.depth.set(self.depth.get() - 1);
            return Some(value.map_err(|error| format!("`{name}`: {}", error.message)));
        }
        if self.stage.also.iter().any(|(known, ..)| known == name) {
            return Some(Ok(Value::Trace(name.to_owned())));
        }
        match name {
            "event" => Some(self.event(None, self.stage.event)),
            "scene" => Some(Ok(self.stage.scene_value())),
            _ => None,
        }
    }

    fn names(&self) -> Vec<String> {
        let mut names = vec!["event".to_owned(), "scene".to_owned()];
        names.extend(self.stage.names.iter().map(|(name, _)| name.clone()));
        names.extend(self.stage.also.iter().map(|(name, ..)| name.clone()));
        names
    }

    fn events(&self, question: &Asked) -> Result<Vec<EventId>, String> {
        let tree = self.stage.tree_of(question.trace)?;
        let query = Query::parse(question.text).map_err(|error| format!("`{}`: {error}", question.text))?;
        let range = question.within.map_or(0..tree.end(), |id| id + 1..tree.subtree_end(id));
        let path = question.above.map(|id| tree.path(id));
        let is_meant = |id: &EventId| {
            range.contains(id) && path.as_ref().is_none_or(|path| path.contains(id) && question.above != Some(*id))
        };
        Ok(query.matches(tree).filter(is_meant).collect())
    }

    fn event(&self, trace: Option<&str>, id: EventId) -> Result<Value, String> {
        let tree = self.stage.tree_of(trace)?;
        if trace.is_none() {
            self.see(id);
        }
        let event = tree.events.get(id as usize).ok_or("there is no such event")?;
        Ok(Value::from(serde_json::to_value(event).map_err(|error| error.to_string())?))
    }
}
