//! Tables of what was recorded.

use super::expression::{Expression, ExpressionError, Known, Question, Value};
use super::model::{Sited, Table};
use super::place::Finding;
use super::prose::{Inline, Line, Told};
use super::stage::{OnStage, Stage};
use crate::record::EventId;

/// A table, told.
#[derive(Clone, Debug, PartialEq)]
pub struct ToldTable {
    /// What stands above its columns.
    pub head: Vec<Line<Told>>,
    /// Its rows.
    pub rows: Vec<Vec<Line<Told>>>,
}

impl Stage {
    /// A table with a row for each item of its list.
    pub fn table(&self, table: &Table, findings: &mut Vec<Finding>) -> ToldTable {
        let head = table.columns.iter().map(|column| self.line(&column.head, findings)).collect();
        let items = match table.of.value.evaluate(&self.known()) {
            Ok(Value::List(items)) => items,
            Ok(value) => {
                let message = format!("this is {}, and a list is needed", value.kind());
                findings.push(self.finding(&table.of, &ExpressionError { message, range: 0..0 }));
                Vec::new()
            }
            Err(error) => {
                findings.push(self.finding(&table.of, &error));
                Vec::new()
            }
        };
        let mut rows = Vec::new();
        for item in &items {
            let known = WithItem { on: self.known(), item };
            let mut row = Vec::new();
            for column in &table.columns {
                row.push(self.cell(&column.cell, column.format, &known, findings));
            }
            rows.push(row);
        }
        ToldTable { head, rows }
    }

    fn cell(
        &self,
        cell: &Sited<Expression>,
        format: super::expression::Format,
        known: &WithItem,
        findings: &mut Vec<Finding>,
    ) -> Line<Told> {
        match cell.value.evaluate(known) {
            // What a row does not have is a dash.
            Ok(Value::None) => vec![Inline::Text("–".to_owned())],
            Ok(value) => {
                let event = known.on.looked_at();
                vec![Inline::Value(Told { text: format.written(&value), from: cell.value.text().to_owned(), event })]
            }
            Err(error) => {
                findings.push(self.finding(cell, &error));
                Vec::new()
            }
        }
    }
}

/// What is known, and the item of a row.
struct WithItem<'a> {
    on: OnStage<'a>,
    item: &'a Value,
}

impl Known for WithItem<'_> {
    fn name(&self, name: &str) -> Option<Result<Value, String>> {
        if name == "item" { Some(Ok(self.item.clone())) } else { self.on.name(name) }
    }

    fn names(&self) -> Vec<String> {
        self.on.names()
    }

    fn events(&self, question: &Question) -> Result<Vec<EventId>, String> {
        self.on.events(question)
    }

    fn event(&self, trace: Option<&str>, id: EventId) -> Result<Value, String> {
        self.on.event(trace, id)
    }
}
