//! What differs between two texts, line by line: what a recovered edit would change.

/// A line of the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line<'t> {
    /// In both.
    Same(&'t str),
    /// Only before.
    Removed(&'t str),
    /// Only after.
    Added(&'t str),
    /// So many lines that are in both are left out here.
    Skipped(usize),
}

/// The differing middle of longer texts is not compared line by line: a table of its lines' pairs would not fit.
const MOST_PAIRS: usize = 4_000_000;

/// All lines of both, each marked with where it is: a longest common subsequence is kept.
#[must_use]
pub fn compare_lines<'t>(before: &'t str, after: &'t str) -> Vec<Line<'t>> {
    let (old, new): (Vec<_>, Vec<_>) = (before.lines().collect(), after.lines().collect());
    let head = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let tail = old[head..].iter().rev().zip(new[head..].iter().rev()).take_while(|(a, b)| a == b).count();
    let mut lines: Vec<Line> = old[..head].iter().copied().map(Line::Same).collect();
    lines.extend(middle(&old[head..old.len() - tail], &new[head..new.len() - tail]));
    lines.extend(old[old.len() - tail..].iter().copied().map(Line::Same));
    lines
}

fn middle<'t>(old: &[&'t str], new: &[&'t str]) -> Vec<Line<'t>> {
    if old.len().saturating_mul(new.len()) > MOST_PAIRS {
        return old.iter().copied().map(Line::Removed).chain(new.iter().copied().map(Line::Added)).collect();
    }
    // length[i][j]: how many lines old[i..] and new[j..] have in common.
    let mut length = vec![vec![0_u32; new.len() + 1]; old.len() + 1];
    for i in (0..old.len()).rev() {
        for j in (0..new.len()).rev() {
            length[i][j] =
                if old[i] == new[j] { length[i + 1][j + 1] + 1 } else { length[i + 1][j].max(length[i][j + 1]) };
        }
    }
    let (mut i, mut j, mut lines) = (0, 0, Vec::new());
    while i < old.len() || j < new.len() {
        if i < old.len() && j < new.len() && old[i] == new[j] {
            lines.push(Line::Same(old[i]));
            (i, j) = (i + 1, j + 1);
        } else if j == new.len() || (i < old.len() && length[i + 1][j] >= length[i][j + 1]) {
            lines.push(Line::Removed(old[i]));
            i += 1;
        } else {
            lines.push(Line::Added(new[j]));
            j += 1;
        }
    }
    lines
}

/// The lines that differ with so many around them; the others are counted.
#[must_use]
pub fn with_context<'t>(lines: &[Line<'t>], around: usize) -> Vec<Line<'t>> {
    let differs: Vec<usize> =
        (0..lines.len()).filter(|i| matches!(lines[*i], Line::Removed(_) | Line::Added(_))).collect();
    let is_near = |i: usize| {
        let next = differs.partition_point(|place| *place < i);
        let after = differs.get(next).is_some_and(|place| place - i <= around);
        let before = next.checked_sub(1).is_some_and(|next| i - differs[next] <= around);
        after || before
    };
    let mut shown: Vec<Line> = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        if is_near(i) {
            shown.push(*line);
        } else if let Some(Line::Skipped(count)) = shown.last_mut() {
            *count += 1;
        } else {
            shown.push(Line::Skipped(1));
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_line_stands_between_those_that_stayed() {
        let lines = compare_lines("a\nb\nc\nd", "a\nB\nc\nd\ne");
        let expected =
            [Line::Same("a"), Line::Removed("b"), Line::Added("B"), Line::Same("c"), Line::Same("d"), Line::Added("e")];
        assert_eq!(lines, expected);
    }

    #[test]
    fn lines_far_from_a_change_are_counted_and_not_shown() {
        let before: Vec<String> = (0..20).map(|i| i.to_string()).collect();
        let mut after = before.clone();
        after[10] = "ten".to_owned();
        let (before, after) = (before.join("\n"), after.join("\n"));
        let lines = with_context(&compare_lines(&before, &after), 1);
        let expected = [
            Line::Skipped(9),
            Line::Same("9"),
            Line::Removed("10"),
            Line::Added("ten"),
            Line::Same("11"),
            Line::Skipped(8),
        ];
        assert_eq!(lines, expected);
    }
}
