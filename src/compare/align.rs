//! Two lists laid side by side: which items belong together, in order.
//!
//! **Method.** A longest common subsequence by dynamic programming, in which a pair counts more if its items are not only of one
//! name but equal throughout; so of several items with one name those are paired that are equal. Long lists are first divided
//! at the names that each of them holds exactly once (patience sorting, as version control systems do).
//!
//! **Source.** J. W. Hunt, M. D. McIlroy, An Algorithm for Differential File Comparison (Bell Laboratories, 1976), for the
//! table; B. Cohen's patience diff, for the anchors.

use std::collections::BTreeMap;

/// Cells of one table. Fewer would lay long lists side by side by their unique names alone; more would take seconds.
const MOST_CELLS: usize = 1 << 20;

/// A pair counts this much for its name, and one more if its items are equal: no number of equal items outweighs a pair.
const NAMES_AGREE: u32 = 1 << 12;

/// An item of both lists or of one.
pub type Aligned = (Option<usize>, Option<usize>);

/// Lays lists of names side by side; `equal` says whether two items with one name are equal throughout.
pub fn align<K: Ord>(left: &[K], right: &[K], equal: &impl Fn(usize, usize) -> bool) -> Vec<Aligned> {
    let mut aligned = Vec::with_capacity(left.len().max(right.len()));
    stretch(&Lists { left, right }, [0, left.len()], [0, right.len()], equal, &mut aligned);
    aligned
}

struct Lists<'a, K> {
    left: &'a [K],
    right: &'a [K],
}

fn stretch<K: Ord>(
    lists: &Lists<K>,
    [mut from, mut to]: [usize; 2],
    [mut start, mut end]: [usize; 2],
    equal: &impl Fn(usize, usize) -> bool,
    aligned: &mut Vec<Aligned>,
) {
    let same = |a: usize, b: usize| lists.left[a] == lists.right[b] && equal(a, b);
    while from < to && start < end && same(from, start) {
        aligned.push((Some(from), Some(start)));
        (from, start) = (from + 1, start + 1);
    }
    let mut tail = Vec::new();
    while from < to && start < end && same(to - 1, end - 1) {
        (to, end) = (to - 1, end - 1);
        tail.push((Some(to), Some(end)));
    }
    let (rows, columns) = (to - from, end - start);
    if rows == columns && lists.left[from..to] == lists.right[start..end] {
        aligned.extend((from..to).zip(start..end).map(|(a, b)| (Some(a), Some(b))));
    } else if (rows + 1).saturating_mul(columns + 1) <= MOST_CELLS {
        by_table(lists, [from, to], [start, end], equal, aligned);
    } else {
        by_anchors(lists, [from, to], [start, end], equal, aligned);
    }
    aligned.extend(tail.into_iter().rev());
}

/// The heaviest common subsequence.
fn by_table<K: Ord>(
    lists: &Lists<K>,
    [from, to]: [usize; 2],
    [start, end]: [usize; 2],
    equal: &impl Fn(usize, usize) -> bool,
    aligned: &mut Vec<Aligned>,
) {
    let (rows, columns) = (to - from, end - start);
    let worth = |a: usize, b: usize| {
        let agree = lists.left[from + a] == lists.right[start + b];
        if agree { NAMES_AGREE + u32::from(equal(from + a, start + b)) } else { 0 }
    };
    // best[a][b]: the weight of what follows from item a on the left and b on the right.
    let mut best = vec![0_u32; (rows + 1) * (columns + 1)];
    let at = |a: usize, b: usize| a * (columns + 1) + b;
    let mut pairs = vec![0_u32; rows * columns];
    for a in (0..rows).rev() {
        for b in (0..columns).rev() {
            let pair = worth(a, b);
            pairs[a * columns + b] = pair;
            let together = if pair > 0 { pair + best[at(a + 1, b + 1)] } else { 0 };
            best[at(a, b)] = together.max(best[at(a + 1, b)]).max(best[at(a, b + 1)]);
        }
    }
    let (mut a, mut b) = (0, 0);
    while a < rows || b < columns {
        let pair = if a < rows && b < columns { pairs[a * columns + b] } else { 0 };
        if pair > 0 && best[at(a, b)] == pair + best[at(a + 1, b + 1)] {
            aligned.push((Some(from + a), Some(start + b)));
            (a, b) = (a + 1, b + 1);
        } else if a < rows && (b == columns || best[at(a, b)] == best[at(a + 1, b)]) {
            aligned.push((Some(from + a), None));
            a += 1;
        } else {
            aligned.push((None, Some(start + b)));
            b += 1;
        }
    }
}

/// Divides two long lists at the names that both hold once, in the longest order that they have in common.
fn by_anchors<K: Ord>(
    lists: &Lists<K>,
    [from, to]: [usize; 2],
    [start, end]: [usize; 2],
    equal: &impl Fn(usize, usize) -> bool,
    aligned: &mut Vec<Aligned>,
) {
    let anchors = rising(&unique_in_both(&lists.left[from..to], &lists.right[start..end]));
    if anchors.is_empty() {
        aligned.extend((from..to).map(|a| (Some(a), None)));
        aligned.extend((start..end).map(|b| (None, Some(b))));
        return;
    }
    let (mut a, mut b) = (from, start);
    for [left, right] in anchors {
        stretch(lists, [a, from + left], [b, start + right], equal, aligned);
        aligned.push((Some(from + left), Some(start + right)));
        (a, b) = (from + left + 1, start + right + 1);
    }
    stretch(lists, [a, to], [b, end], equal, aligned);
}

/// The places of the names that each list holds exactly once, in the order of the left one.
fn unique_in_both<K: Ord>(left: &[K], right: &[K]) -> Vec<[usize; 2]> {
    let once = |list| {
        let mut places: BTreeMap<&K, Option<usize>> = BTreeMap::new();
        for (place, name) in std::iter::zip(0.., list) {
            places.entry(name).and_modify(|seen| *seen = None).or_insert(Some(place));
        }
        places
    };
    let (left, right) = (once(left), once(right));
    let mut both: Vec<[usize; 2]> =
        left.iter().filter_map(|(name, place)| Some([(*place)?, (*right.get(name)?)?])).collect();
    both.sort_unstable();
    both
}

/// The longest subsequence whose second places rise.
fn rising(places: &[[usize; 2]]) -> Vec<[usize; 2]> {
    // last[k]: the item that ends the best subsequence of k + 1 items; before[i]: the item before item i in its own.
    let (mut last, mut before): (Vec<usize>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
    for (i, [_, right]) in places.iter().enumerate() {
        let length = last.partition_point(|&j| places[j][1] < *right);
        before.push(length.checked_sub(1).map(|k| last[k]));
        if length == last.len() { last.push(i) } else { last[length] = i }
    }
    let mut chain: Vec<_> = std::iter::successors(last.last().copied(), |&i| before[i]).map(|i| places[i]).collect();
    chain.reverse();
    chain
}

#[cfg(test)]
mod tests {
    use super::*;

    fn aligned(left: &str, right: &str) -> String {
        let [a, b] = [left, right].map(|text| text.chars().collect::<Vec<_>>());
        let pairs = align(&a, &b, &|_, _| true);
        let one = |(left, right): Aligned| match (left, right) {
            (Some(i), Some(_)) => format!("{}", a[i]),
            (Some(i), None) => format!("-{}", a[i]),
            (None, Some(j)) => format!("+{}", b[j]),
            (None, None) => String::new(),
        };
        pairs.into_iter().map(one).collect()
    }

    #[test]
    fn what_was_put_in_or_taken_out_is_found_and_nothing_else() {
        assert_eq!(aligned("abcd", "abcd"), "abcd");
        assert_eq!(aligned("abcd", "abXcd"), "ab+Xcd");
        assert_eq!(aligned("abXcd", "abcd"), "ab-Xcd");
        assert_eq!(aligned("", "ab"), "+a+b");
        assert_eq!(aligned("axb", "ayb"), "a-x+yb");
    }

    #[test]
    fn of_items_with_one_name_the_equal_ones_are_paired() {
        let (left, right) = (["a"; 2], ["a"; 3]);
        // The first on the left equals the second on the right, the second the third.
        let pairs = align(&left, &right, &|a, b| a + 1 == b);
        assert_eq!(pairs, [(None, Some(0)), (Some(0), Some(1)), (Some(1), Some(2))]);
    }

    #[test]
    fn long_lists_are_aligned_at_the_names_that_they_hold_once() {
        let left: Vec<usize> = (0..5000).collect();
        let right: Vec<usize> = (0..5000).filter(|k| k % 7 != 3).flat_map(|k| [k, 10_000 + k]).collect();
        let pairs = align(&left, &right, &|_, _| false);
        let both = pairs.iter().filter(|(a, b)| a.is_some() && b.is_some()).count();
        assert_eq!(both, (0..5000).filter(|k| k % 7 != 3).count());
        assert!(pairs.iter().all(|(a, b)| a.is_none() || b.is_none() || left[a.unwrap()] == right[b.unwrap()]));
    }
}
