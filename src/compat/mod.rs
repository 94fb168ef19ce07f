//! What other tools do with what the rules find: one table, applied to the findings of a check in one place.
//!
//! A rule knows a cause and not who suffers from it. When a check is told which tools the description shall be fit for
//! ([`Options::tools`](crate::lint::Options::tools)), each finding that one of them chokes on says so, and is no less grave
//! than what happens there. Rules of the group `portability` are silent but for that.

mod reactions;

use crate::diagnostic::{Diagnostic, Findings, Severity, Text, Tool, say};
use crate::format::Description;
use crate::lint::PORTABILITY;

pub use reactions::REACTIONS;

/// What tools do with a file in which a rule finds something.
#[derive(Clone, Copy, Debug)]
pub struct Reaction {
    /// The id of the rule.
    pub rule: &'static str,
    /// The tools that do the same.
    pub tools: &'static [Tool],
    /// How bad it is.
    pub effect: Effect,
    /// What happens, as a sentence without a subject for the tools: "the file is refused".
    pub what: &'static str,
    /// Which findings of the rule it is about; all, where this is `None`.
    pub when: Option<When>,
}

/// Which findings of a rule a reaction is about.
#[derive(Clone, Copy, Debug)]
pub struct When {
    /// In words: "in `[DummyUsage]`".
    pub text: &'static str,
    /// Whether it is about this one.
    pub holds: fn(&Description, &Diagnostic) -> bool,
}

/// How bad it is what a tool does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// It does not read the file, or crashes.
    Refused,
    /// It reads something else than what the file says.
    Wrong,
    /// It does not know what it reads, or loses it when it writes the file.
    Dropped,
}

impl Effect {
    /// The least severity of a finding with this effect.
    pub const fn severity(self) -> Severity {
        match self {
            Self::Refused | Self::Wrong => Severity::Warning,
            Self::Dropped => Severity::Note,
        }
    }

    /// The word for it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Refused => "refused",
            Self::Wrong => "wrong",
            Self::Dropped => "dropped",
        }
    }
}

/// What the tools of the selection do is added to the findings; those that only tools make are gone where none of these
/// does.
pub(crate) fn react(findings: Findings, description: &Description, tools: &[Tool]) -> Findings {
    findings.filter_map(|finding| {
        let reactions = REACTIONS.iter().filter(|reaction| reaction.rule == finding.rule.id);
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
