//! What came of each target.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::Outcome;

/// What came of one target.
pub(super) struct Column {
    pub(super) name: &'static str,
    outcomes: BTreeMap<String, Outcome>,
}

impl Column {
    pub(super) fn new(name: &'static str) -> Self {
        Self { name, outcomes: BTreeMap::new() }
    }

    pub(super) fn add(&mut self, file: &str, outcome: Outcome) {
        self.outcomes.insert(file.to_owned(), outcome);
    }

    /// Puts another outcome in the place of what came of a file.
    pub(super) fn replace(&mut self, file: &str, outcome: Outcome) {
        self.add(file, outcome);
    }

    /// What failed, a line for each file.
    pub(super) fn failures(&self) -> Vec<String> {
        let failed = self.outcomes.iter().filter_map(|(file, outcome)| match outcome {
            Outcome::Failed(problem) => Some(format!("{}: {file}: {problem}", self.name)),
            _ => None,
        });
        failed.collect()
    }

    fn row(&self) -> String {
        let count = |is: fn(&Outcome) -> bool| self.outcomes.values().filter(|outcome| is(outcome)).count();
        let refused = count(|outcome| matches!(outcome, Outcome::Refused(_)));
        let compiled = count(|outcome| matches!(outcome, Outcome::Generated(_)));
        let failed = count(|outcome| matches!(outcome, Outcome::Failed(_)));
        let mut notes: Vec<usize> = self.outcomes.values().filter_map(noted).collect();
        notes.sort_unstable();
        let median = notes.get(notes.len() / 2).copied().unwrap_or(0);
        let most = notes.last().copied().unwrap_or(0);
        let generated = compiled + failed;
        format!(
            "| {} | {} | {generated} | {refused} | {compiled} | {failed} | {median} | {most} |",
            self.name,
            self.outcomes.len()
        )
    }
}

fn noted(outcome: &Outcome) -> Option<usize> {
    if let Outcome::Generated(notes) = outcome { Some(*notes) } else { None }
}

/// The table, and below it why nothing was generated.
pub(super) fn print(files: usize, columns: &[Column]) -> String {
    let mut text = format!(
        "{files} files\n\n| target | files | generated | refused | compiled | failed | notes (median) | notes (most) |\n|---|---|---|---|---|---|---|---|\n"
    );
    for column in columns {
        let _ = writeln!(text, "{}", column.row());
    }
    let mut reasons: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for column in columns {
        for (file, outcome) in &column.outcomes {
            if let Outcome::Refused(reason) = outcome {
                reasons.entry((file, reason)).or_default().push(column.name);
            }
        }
    }
    for ((file, reason), targets) in reasons {
        let _ = writeln!(text, "refused: {file}: {reason} ({})", targets.join(", "));
    }
    text
}
