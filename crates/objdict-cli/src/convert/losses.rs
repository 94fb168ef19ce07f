//! Losses of conversions, as text and as JSON.

use serde::Serialize;

use super::super::input::{FileKind, source_name};
use super::Job;
use objdict_format::{Loss, LossKind};
use objdict_model::json;
use objdict_model::json::Version;

/// The losses of all files.
#[derive(Default)]
pub(super) struct LossReport {
    files: Vec<FileLosses>,
}

/// The losses of a file.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "File"))]
struct FileLosses {
    /// The file that was read, as it was given.
    file: String,
    /// Its format.
    from: &'static str,
    /// The format that was written.
    to: &'static str,
    /// The file that was written.
    written: String,
    /// The losses, by kind and in the order of the model.
    losses: Vec<Loss>,
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct LossesJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The converted files.
    files: &'a [FileLosses],
    /// The losses of all files.
    summary: LossCounts,
}

/// The losses of all files, by what became of the data.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Summary"))]
struct LossCounts {
    /// The number of data that are lost.
    lost: usize,
    /// The number of data that belong to a node, or not on the bus.
    left_out: usize,
    /// The number of data that only the written file states.
    invented: usize,
    /// The number of data that objdict reads again.
    carried: usize,
}

impl LossReport {
    pub(super) fn add(&mut self, job: &Job, from: FileKind, losses: Vec<Loss>) {
        self.files.push(FileLosses {
            file: source_name(&job.input),
            from: from.name(),
            to: job.to.name(),
            written: source_name(&job.output),
            losses,
        });
    }

    /// Whether something is gone or invented.
    pub(super) fn has_lost(&self) -> bool {
        self.count(LossKind::Lost) + self.count(LossKind::Invented) > 0
    }

    fn count(&self, kind: LossKind) -> usize {
        self.files.iter().flat_map(|file| &file.losses).filter(|loss| loss.kind == kind).count()
    }

    /// One JSON document (docs/reference/json.md), with a line feed at its end.
    pub(super) fn to_json(&self) -> String {
        let summary = LossCounts {
            lost: self.count(LossKind::Lost),
            left_out: self.count(LossKind::LeftOut),
            invented: self.count(LossKind::Invented),
            carried: self.count(LossKind::Embedded),
        };
        let document = LossesJson { version: Version, files: &self.files, summary };
        // all keys are texts, so there is nothing that could fail
        let mut text = json::pretty(&document).unwrap_or_default();
        text.push('\n');
        text
    }
}

/// A line for each loss, or for all with the same reason, and how many there are.
pub(in super::super) fn text(losses: &[Loss]) -> String {
    if losses.is_empty() {
        return String::new();
    }
    let mut text = String::new();
    for (position, loss) in losses.iter().enumerate() {
        let is_same = |other: &&Loss| (other.kind, &other.reason) == (loss.kind, &loss.reason);
        let others = match loss.reason {
            Some(_) if losses[..position].iter().any(|other| is_same(&other)) => continue,
            Some(_) => losses[position..].iter().filter(is_same).count() - 1,
            None => 0,
        };
        let line = match (&loss.reason, others) {
            (Some(reason), 1..) => {
                format!("{}: {} and {others} more: {reason}", loss.kind.name(), loss.place)
            }
            _ => loss.to_string(),
        };
        text.push_str(&format!("  {line}\n"));
    }
    let counts = [LossKind::Lost, LossKind::LeftOut, LossKind::Invented, LossKind::Embedded].map(|kind| {
        let count = losses.iter().filter(|loss| loss.kind == kind).count();
        (count > 0).then(|| format!("{count} {}", kind.name()))
    });
    let counts: Vec<String> = counts.into_iter().flatten().collect();
    text.push_str(&format!("  {}\n", counts.join(", ")));
    text
}
