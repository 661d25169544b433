//! Expressions, by hand.
