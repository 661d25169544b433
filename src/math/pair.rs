//! Two numbers at once: what is done to one is done to the other, so that a processor with vectors can do both in one go.

use super::Real;
use std::ops::{Add, Div, Mul, Sub};

/// Two numbers that go through the same steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair<A>(pub [A; 2]);

impl<A: Copy> Pair<A> {
    /// Twice the same number.
    #[must_use]
    #[inline]
    pub fn both(x: A) -> Self {
        Self([x, x])
    }

    /// `function` of each.
    #[must_use]
    #[inline]
    pub fn map<B>(self, function: impl Fn(A) -> B) -> Pair<B> {
        let [a, b] = self.0;
        Pair([function(a), function(b)])
    }

    /// Each with its fellow in `other`.
    #[must_use]
    #[inline]
    pub fn zip<B: Copy>(self, other: Pair<B>) -> Pair<(A, B)> {
        self.with(other, |a, b| (a, b))
    }

    /// `function` of each and its fellow in `other`.
    #[must_use]
    #[inline]
    pub fn with<B: Copy, C>(self, other: Pair<B>, function: impl Fn(A, B) -> C) -> Pair<C> {
        let ([a, b], [c, d]) = (self.0, other.0);
        Pair([function(a, c), function(b, d)])
    }
}

impl Pair<bool> {
    /// Each number from `yes` or from `no`.
    #[must_use]
    #[inline]
    pub fn choose<A: Copy>(self, yes: Pair<A>, no: Pair<A>) -> Pair<A> {
        self.with(yes.zip(no), |is_yes, (yes, no)| if is_yes { yes } else { no })
    }
}

impl<A: Real> Pair<A> {
    /// The square roots; NaN for negative numbers.
    #[must_use]
    #[inline]
    pub fn sqrt(self) -> Self {
        self.map(A::sqrt)
    }
}

macro_rules! number_by_number {
    ($($operator:ident $method:ident),*) => {$(
        impl<A: Real> $operator for Pair<A> {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                self.with(other, A::$method)
            }
        }

        impl<A: Real> $operator<A> for Pair<A> {
            type Output = Self;

            #[inline]
            fn $method(self, other: A) -> Self {
                self.map(|x| x.$method(other))
            }
        }
    )*};
}

number_by_number!(Add add, Sub sub, Mul mul, Div div);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_number_goes_its_own_way() {
        let (a, b) = (Pair([1.0, -6.0]), Pair([4.0, 3.0]));
        assert_eq!(a + b, Pair([5.0, -3.0]));
        assert_eq!(a - b, Pair([-3.0, -9.0]));
        assert_eq!(a * b, Pair([4.0, -18.0]));
        assert_eq!(a / b, Pair([0.25, -2.0]));
        assert_eq!(a * 0.5 + 1.0, Pair([1.5, -2.0]));
        assert_eq!(Pair([4.0, 9.0]).sqrt(), Pair([2.0, 3.0]));
    }
}
