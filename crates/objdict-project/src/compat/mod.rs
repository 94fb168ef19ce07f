//! The reactions of other tools to findings: one table, applied to the findings of a check in one place.
//!
//! A rule knows a problem, but not the affected tools. If a check includes tools
//! ([`Options::tools`](objdict_lint::Options::tools)), each finding that affects one of them names it, and has at least
//! the severity of the effect. Findings of the group `portability` are reported only for affected tools.

#[cfg(feature = "lint")]
mod adapted;
mod canchkeds;
mod fixes;
mod reactions;
#[cfg(feature = "lint")]
mod spellings;

use objdict_format::Description;
use objdict_lint::PORTABILITY;
use objdict_model::diagnostic::{Diagnostic, Findings, Severity, Text, Tool, say};
use objdict_model::model::DeviceKind;
#[cfg(feature = "lint")]
pub use {adapted::adapt, spellings::with_refused_spellings};

pub use canchkeds::MESSAGES;
pub use reactions::REACTIONS;

/// The reaction of tools to a finding of a rule.
#[derive(Clone, Copy, Debug)]
pub struct Reaction {
    /// The id of the rule.
    pub rule: &'static str,
    /// The tools with the same reaction.
    pub tools: &'static [Tool],
    /// The effect on the file.
    pub effect: Effect,
    /// The reaction, as a passive sentence: "the file is rejected".
    pub what: &'static str,
    /// The affected findings of the rule; `None` for all.
    pub when: Option<When>,
}

/// The condition of a reaction.
#[derive(Clone, Copy, Debug)]
pub struct When {
    /// As text: "in `[DummyUsage]`".
    pub text: &'static str,
    /// Whether a finding meets the condition.
    pub holds: fn(&Description, &Diagnostic) -> bool,
}

objdict_model::named! {
    /// The effect of a finding on a tool.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Effect {
        /// The tool rejects the file, or crashes.
        Refused = "refused",
        /// The tool misreads the file.
        Wrong = "wrong",
        /// The tool ignores the content, or drops it when writing the file.
        Dropped = "dropped",
        /// The tool reports an error.
        Failed = "error",
        /// The tool reports a warning.
        Warned = "warning",
    }
}

impl Effect {
    /// The lowest severity of a finding with this effect.
    pub const fn severity(self) -> Severity {
        match self {
            Self::Refused | Self::Failed => Severity::Error,
            Self::Wrong | Self::Warned => Severity::Warning,
            Self::Dropped => Severity::Note,
        }
    }
}

/// Removes the fixes that one reader needs and another rejects, if no reader is selected.
pub fn without_readers(findings: Findings, description: &Description) -> Findings {
    findings.filter_map(|finding| fixes::choose(finding, description, &[]))
}

/// Adds the reactions of the selected tools to the findings, and selects suitable fixes; removes findings of the group
/// `portability` that affect none of them.
pub fn react(findings: Findings, description: &Description, tools: &[Tool]) -> Findings {
    // CANchkEDS does not check configurations
    let is_type = description.device().kind == DeviceKind::Type;
    findings.filter_map(|finding| {
        let finding = fixes::choose(finding, description, tools)?;
        let messages = MESSAGES.iter().filter(|_| is_type);
        let reactions = REACTIONS.iter().chain(messages).filter(|reaction| reaction.rule == finding.rule.id);
        let of_these = |reaction: &&Reaction| {
            reaction.tools.iter().any(|tool| tools.contains(tool))
                && reaction.when.is_none_or(|when| (when.holds)(description, &finding))
        };
        let reactions: Vec<&Reaction> = reactions.filter(of_these).collect();
        let is_own = finding.rule.group() == PORTABILITY;
        match reactions.iter().map(|reaction| reaction.effect.severity()).max() {
            None => (!is_own).then_some(finding),
            Some(severity) => Some(with_reactions(finding, &reactions, severity, tools)),
        }
    })
}

fn with_reactions(
    mut finding: Diagnostic,
    reactions: &[&Reaction],
    severity: Severity,
    tools: &[Tool],
) -> Diagnostic {
    let text = reactions.iter().map(|reaction| {
        let names = reaction.tools.iter().filter(|tool| tools.contains(tool)).map(|tool| tool.name());
        format!("{}: {}", names.collect::<Vec<_>>().join(", "), reaction.what)
    });
    let text = text.collect::<Vec<_>>().join("; ");
    if finding.rule.group() == PORTABILITY {
        finding.message = say!("{}; {}", finding.message, Text::from(text));
        finding.severity = severity;
    } else {
        finding.help = Some(match finding.help {
            Some(help) => say!("{}; {}", help, Text::from(text)),
            None => text.into(),
        });
        finding.severity = finding.severity.max(severity);
    }
    finding
}
