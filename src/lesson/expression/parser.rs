//! From words and signs to the tree of an expression, by recursive descent: `or`, `and`, `not`, comparisons, sums, products,
//! signs, powers, fields.

use super::token::{Token, TokenKind, tokens};
use super::{ExpressionError, Kind, Node, Operator, Value};

/// Deeper ones are refused: every level takes some of the stack.
const MOST_DEPTH: usize = 64;

/// Reads a whole expression.
pub fn parse(text: &str) -> Result<Node, ExpressionError> {
    let mut parser = Parser { tokens: tokens(text)?, next: 0, end: text.len(), depth: 0 };
    let node = parser.or()?;
    match parser.peek() {
        None => Ok(node),
        Some(token) => Err(Parser::expected("the end or an operator", token)),
    }
}

struct Parser {
    tokens: Vec<Token>,
    next: usize,
    end: usize,
    depth: usize,
}

const COMPARISONS: [(&str, Operator); 6] = [
    ("==", Operator::Equal),
    ("!=", Operator::Unequal),
    ("<=", Operator::LessOrEqual),
    (">=", Operator::GreaterOrEqual),
    ("<", Operator::Less),
    (">", Operator::Greater),
];
const SUMS: [(&str, Operator); 2] = [("+", Operator::Add), ("-", Operator::Subtract)];
const PRODUCTS: [(&str, Operator); 2] = [("*", Operator::Multiply), ("/", Operator::Divide)];

impl Parser {
    fn or(&mut self) -> Result<Node, ExpressionError> {
        self.descend()?;
        let mut left = self.and()?;
        while self.take_word("or") {
            left = binary(Operator::Or, left, self.and()?);
        }
        self.depth -= 1;
        Ok(left)
    }

    fn and(&mut self) -> Result<Node, ExpressionError> {
        let mut left = self.not()?;
        while self.take_word("and") {
            left = binary(Operator::And, left, self.not()?);
        }
        Ok(left)
    }

    fn not(&mut self) -> Result<Node, ExpressionError> {
        let mut begins = Vec::new();
        while let Some(start) = self.peek().map(|token| token.range.start)
            && self.take_word("not")
        {
            begins.push(start);
        }
        let node = self.comparison()?;
        Ok(begins.into_iter().rev().fold(node, |node, start| {
            let range = start..node.range.end;
            Node { kind: Kind::Not(Box::new(node)), range }
        }))
    }

    fn comparison(&mut self) -> Result<Node, ExpressionError> {
        let left = self.sum()?;
        if self.take_sign("~") {
            let right = self.sum()?;
            let within = if self.take_word("within") { Some(Box::new(self.sum()?)) } else { None };
            let range = left.range.start..within.as_ref().map_or(right.range.end, |node| node.range.end);
            return Ok(Node { kind: Kind::Near(Box::new(left), Box::new(right), within), range });
        }
        match self.take_one_of(&COMPARISONS) {
            Some(operator) => Ok(binary(operator, left, self.sum()?)),
            None => Ok(left),
        }
    }

    fn sum(&mut self) -> Result<Node, ExpressionError> {
        let mut left = self.product()?;
        while let Some(operator) = self.take_one_of(&SUMS) {
            left = binary(operator, left, self.product()?);
        }
        Ok(left)
    }

    fn product(&mut self) -> Result<Node, ExpressionError> {
        let mut left = self.minus()?;
        while let Some(operator) = self.take_one_of(&PRODUCTS) {
            left = binary(operator, left, self.minus()?);
        }
        Ok(left)
    }

    /// A sign binds weaker than a power: −2^2 is −4.
    fn minus(&mut self) -> Result<Node, ExpressionError> {
        let start = self.peek().map_or(self.end, |token| token.range.start);
        if self.take_sign("-") {
            let node = self.power()?;
            let range = start..node.range.end;
            return Ok(Node { kind: Kind::Minus(Box::new(node)), range });
        }
        self.power()
    }

    fn power(&mut self) -> Result<Node, ExpressionError> {
        let base = self.postfix()?;
        if self.take_sign("^") {
            self.descend()?;
            let power = binary(Operator::Power, base, self.minus()?);
            self.depth -= 1;
            return Ok(power);
        }
        Ok(base)
    }

    fn descend(&mut self) -> Result<(), ExpressionError> {
        self.depth += 1;
        if self.depth > MOST_DEPTH { Err(self.error_here("this is nested too deeply")) } else { Ok(()) }
    }

    fn postfix(&mut self) -> Result<Node, ExpressionError> {
        let mut node = self.primary()?;
        loop {
            if self.take_sign(".") {
                let Some(Token { kind: TokenKind::Word(name), .. }) = self.take() else {
                    return Err(self.error_here("expected the name of a field after the dot"));
                };
                let start = node.range.start;
                // `grazing.count("…")` asks another trace: the trace is the first argument.
                let kind = if self.take_sign("(") {
                    let mut arguments = vec![node];
                    arguments.extend(self.items(")")?);
                    Kind::Call(name, arguments)
                } else {
                    Kind::Field(Box::new(node), name)
                };
                node = Node { kind, range: start..self.last_end() };
            } else if self.take_sign("[") {
                let item = self.or()?;
                self.close("]")?;
                let range = node.range.start..self.last_end();
                node = Node { kind: Kind::Item(Box::new(node), Box::new(item)), range };
            } else {
                return Ok(node);
            }
        }
    }

    fn primary(&mut self) -> Result<Node, ExpressionError> {
        let Some(token) = self.take() else { return Err(self.error_here("expected a value")) };
        let start = token.range.start;
        let kind = match token.kind {
            TokenKind::Number(number) => Kind::Literal(Value::Number(number)),
            TokenKind::Text(text) => Kind::Literal(Value::Text(text)),
            TokenKind::Word(word) if self.take_sign("(") => Kind::Call(word, self.items(")")?),
            TokenKind::Word(word) => match word.as_str() {
                "true" => Kind::Literal(Value::Truth(true)),
                "false" => Kind::Literal(Value::Truth(false)),
                "none" => Kind::Literal(Value::None),
                "pi" => Kind::Literal(Value::Number(std::f64::consts::PI)),
                _ => Kind::Name(word),
            },
            TokenKind::Sign("[") => Kind::List(self.items("]")?),
            TokenKind::Sign("(") => {
                let node = self.or()?;
                self.close(")")?;
                return Ok(Node { range: start..self.last_end(), ..node });
            }
            TokenKind::Sign(_) => return Err(Self::expected("a value", &token)),
        };
        Ok(Node { kind, range: start..self.last_end() })
    }

    fn items(&mut self, closing: &'static str) -> Result<Vec<Node>, ExpressionError> {
        let mut items = Vec::new();
        if self.take_sign(closing) {
            return Ok(items);
        }
        loop {
            items.push(self.or()?);
            if !self.take_sign(",") {
                self.close(closing)?;
                return Ok(items);
            }
        }
    }

    fn close(&mut self, closing: &'static str) -> Result<(), ExpressionError> {
        if self.take_sign(closing) { Ok(()) } else { Err(self.error_here(&format!("expected `{closing}`"))) }
    }

    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.next)
    }

    fn take(&mut self) -> Option<Token> {
        let token = self.tokens.get(self.next).cloned();
        self.next += usize::from(token.is_some());
        token
    }

    fn take_word(&mut self, wanted: &str) -> bool {
        let is_it = matches!(self.peek(), Some(Token { kind: TokenKind::Word(word), .. }) if word == wanted);
        self.next += usize::from(is_it);
        is_it
    }

    fn take_sign(&mut self, wanted: &str) -> bool {
        let is_it = matches!(self.peek(), Some(Token { kind: TokenKind::Sign(sign), .. }) if *sign == wanted);
        self.next += usize::from(is_it);
        is_it
    }

    fn take_one_of(&mut self, operators: &[(&str, Operator)]) -> Option<Operator> {
        operators.iter().find(|(sign, _)| self.take_sign(sign)).map(|(_, operator)| *operator)
    }

    fn last_end(&self) -> usize {
        self.next.checked_sub(1).and_then(|last| self.tokens.get(last)).map_or(self.end, |token| token.range.end)
    }

    fn error_here(&self, message: &str) -> ExpressionError {
        let range = self.peek().map_or(self.end..self.end, |token| token.range.clone());
        ExpressionError { message: message.to_owned(), range }
    }

    fn expected(what: &str, token: &Token) -> ExpressionError {
        let read = match &token.kind {
            TokenKind::Number(number) => number.to_string(),
            TokenKind::Text(text) => format!("\"{text}\""),
            TokenKind::Word(word) => word.clone(),
            TokenKind::Sign(sign) => (*sign).to_owned(),
        };
        ExpressionError { message: format!("expected {what}, read `{read}`"), range: token.range.clone() }
    }
}

fn binary(operator: Operator, left: Node, right: Node) -> Node {
    let range = left.range.start..right.range.end;
    Node { kind: Kind::Binary(operator, Box::new(left), Box::new(right)), range }
}
