//! What a fix changes in the fixture of a rule, as the pages of the rules show it.

use std::fs;
use std::path::Path;

/// The most lines of an example.
const LINES: usize = 12;

/// The most characters of a line.
const WIDTH: usize = 110;

/// The change that makes the first bad device of a rule a good one, as a Markdown block; `None` if it is long or the rule has none.
pub(crate) fn of_rule(fixtures: &Path, id: &str) -> Option<String> {
    let text = fs::read_to_string(fixtures.join("rules").join(id).with_extension("diff")).ok()?;
    let (before, device) = text.split_once("\n+++ bad")?;
    if before.rsplit('\n').next()?.starts_with("--- bad") {
        return None;
    }
    let lines = device.lines().skip(1).take_while(|line| !line.starts_with("--- "));
    let mut section = "";
    let mut shown: Vec<String> = Vec::new();
    for line in lines {
        let (sign, rest) = line.split_at_checked(1).unwrap_or((" ", ""));
        if rest.starts_with('[') {
            section = rest;
        }
        // what the fixture says about itself
        if matches!(section, "[FileInfo]" | "[Comments]") || rest.trim().is_empty() || rest.starts_with(';') {
            continue;
        }
        let sign = match sign {
            "+" => '-',
            "-" => '+',
            _ => ' ',
        };
        shown.push(format!("{sign}{rest}"));
    }
    // in a diff, what goes stands before what comes
    for run in shown.chunk_by_mut(|first, second| first.starts_with(' ') == second.starts_with(' ')) {
        run.sort_by_key(|line| line.starts_with('+'));
    }
    let is_change = shown.iter().any(|line| !line.starts_with(' '));
    // a DCF beside an EDS differs in more than the rule is about
    let is_change = is_change && !shown.iter().any(|line| line[1..].starts_with("[DeviceComissioning]"));
    let is_short = shown.len() <= LINES && shown.iter().all(|line| line.chars().count() <= WIDTH);
    (is_change && is_short).then(|| format!("\n```diff\n{}\n```\n", shown.join("\n")))
}
