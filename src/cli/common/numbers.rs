//! Numbers with the words that belong to them.

use crease::num::three_digits;
use std::fmt::Write as _;

pub fn count(number: usize, what: &str) -> String {
    count_of(number, what, &format!("{what}s"))
}

/// The same with an irregular plural.
pub fn count_of(number: usize, one: &str, many: &str) -> String {
    format!("{number} {}", if number == 1 { one } else { many })
}

/// The counts above zero, each with its words.
pub fn counts_above_zero(counts: &[(usize, &str)]) -> Vec<String> {
    counts.iter().filter(|count| count.0 > 0).map(|(number, what)| format!("{number} {what}")).collect()
}

/// Faces by their number of corners: triangles, quads, polygons of five corners or more.
pub fn face_kinds([triangles, quads, polygons]: [usize; 3]) -> String {
    let kinds = [(triangles, "triangle"), (quads, "quad"), (polygons, "polygon")];
    let kinds = kinds.iter().filter(|kind| kind.0 > 0).map(|&(number, what)| count(number, what));
    kinds.collect::<Vec<_>>().join(", ")
}

/// Bytes in the unit that fits, powers of 1000.
pub fn size(bytes: u64) -> String {
    const UNITS: [(u64, &str); 3] = [(1_000_000_000, "GB"), (1_000_000, "MB"), (1_000, "kB")];
    match UNITS.iter().find(|(unit, _)| bytes >= *unit) {
        Some((unit, name)) => format!("{:.1} {name}", bytes as f64 / *unit as f64),
        None => format!("{bytes} B"),
    }
}

pub fn seconds(total: f64, stages: &[(&str, f64)]) -> String {
    let stages: Vec<String> = stages.iter().map(|(name, seconds)| format!("{name} {seconds:.3}")).collect();
    format!("{total:.3} s ({})", stages.join(", "))
}

/// A quantity before and after, with the share that is left.
pub fn change((before, after): (u64, u64), format: impl Fn(u64) -> String) -> String {
    if before == after {
        return format!("{}, unchanged", format(before));
    }
    let share = 100.0 * after as f64 / before.max(1) as f64;
    format!("{} to {} ({} %)", format(before), format(after), three_digits(share))
}

pub fn row(out: &mut String, label: &str, text: &str) {
    let _ = writeln!(out, "  {label:<9}{text}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(count(1, "face"), "1 face");
        assert_eq!(count_of(0, "vertex", "vertices"), "0 vertices");
        assert_eq!(
            [size(0), size(999), size(1_000), size(1_949_999), size(2_500_000_000)],
            ["0 B", "999 B", "1.0 kB", "1.9 MB", "2.5 GB"]
        );
    }
}
