//! Skipped tests are visible: `support/skips.rs` alone reports them, and alone reads `CI`.

use std::fs;
use std::path::Path;

use crate::support::files_below;
use crate::support::skips::is_used;

#[test]
fn skips_are_reported_in_one_way() {
    let project = Path::new(env!("CARGO_MANIFEST_DIR"));
    let exempt = ["tests/support/skips.rs", "tests/library/skipping.rs"].map(|name| project.join(name));
    let mut others = Vec::new();
    for path in
        ["tests", "crates", "xtask"].iter().flat_map(|folder| files_below(&project.join(folder), &["rs"]))
    {
        let text = fs::read_to_string(&path).unwrap();
        let is_report =
            |line: &&str| line.contains("skipped:") && line.contains('!') || line.contains("(\"CI\")");
        let lines = text.lines().filter(is_report).filter(|_| !exempt.contains(&path));
        others.extend(lines.map(|line| format!("{}: {}", path.display(), line.trim())));
    }
    assert!(others.is_empty(), "call `skip` or `skip_unless_ci` instead:\n{}", others.join("\n"));
}

#[test]
fn four_successive_samples_use_every_item_once() {
    for all in 0..20 {
        for number in 0..all {
            // the last group may be smaller, and is used more often
            let times = (7..11).filter(|&seed| is_used(number, all, seed)).count();
            assert!(times == 1 || number >= all / 4 * 4 && times > 1, "{number} of {all}: {times}");
        }
        let used = (0..all).filter(|&number| is_used(number, all, 0)).count();
        assert_eq!(used, all.div_ceil(4));
    }
}
