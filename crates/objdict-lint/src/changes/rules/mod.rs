//! The kinds of changes as data: the page of each, and the effect on each audience, with the reason.

use super::{Audience, ChangeVerdict};
use crate::diagnostic::{RuleInfo, Severity};

mod device;
mod entries;
mod pdos;

pub(super) use self::device::*;
pub(super) use self::entries::*;
pub(super) use self::pdos::*;

/// A kind of change.
#[derive(Debug)]
pub struct ChangeRule {
    /// The id, severity and page.
    pub info: RuleInfo,
    /// The effect of the change on each audience that it can affect.
    pub effects: &'static [ChangeImpact],
}

/// The effect of a kind of change on an audience.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChangeImpact {
    /// Who is affected.
    pub audience: Audience,
    /// How.
    pub verdict: ChangeVerdict,
    /// Why, as a clause.
    pub reason: &'static str,
}

/// The kinds of changes, in the order of the documentation.
pub fn rules() -> impl Iterator<Item = &'static ChangeRule> {
    [entries::RULES, pdos::RULES, device::RULES].into_iter().flatten().copied()
}

const fn effect(audience: Audience, verdict: ChangeVerdict, reason: &'static str) -> ChangeImpact {
    ChangeImpact { audience, verdict, reason }
}

/// The severity of the worst effect.
const fn severity(effects: &[ChangeImpact]) -> Severity {
    let mut worst = Severity::Note;
    let mut at = 0;
    while at < effects.len() {
        match effects[at].verdict {
            ChangeVerdict::Breaking => return Severity::Error,
            ChangeVerdict::Risky => worst = Severity::Warning,
            ChangeVerdict::Compatible => {}
        }
        at += 1;
    }
    worst
}

/// The name of a verdict, for such a text.
macro_rules! word {
    (Breaking) => {
        "breaking"
    };
    (Risky) => {
        "risky"
    };
    (Compatible) => {
        "compatible"
    };
}
use word;

/// Declares kinds of changes: their effects on each audience, and the texts of the page; `RULES` is their list. The
/// default source is stated once before them.
macro_rules! changes {
    (source: $usual:literal; $(
        $id:literal = $NAME:ident {
            $First:ident: $FirstVerdict:ident, $first:literal;
            $($Audience:ident: $Verdict:ident, $reason:literal;)*
        }
        summary: $summary:literal,
        checks: $checks:literal,
        example: $example:literal,
        remedy: $remedy:literal,
        $(source: $source:literal,)?
    )+) => {
        const SOURCE: &str = $usual;

        /// The kinds of changes of this module.
        pub(super) static RULES: &[&super::ChangeRule] = &[$(&$NAME),+];

        $(
            pub(in super::super) static $NAME: super::ChangeRule = {
                const EFFECTS: &[super::ChangeImpact] = &[
                    super::effect(super::Audience::$First, super::ChangeVerdict::$FirstVerdict, $first),
                    $(super::effect(super::Audience::$Audience, super::ChangeVerdict::$Verdict, $reason),)*
                ];
                super::ChangeRule {
                    info: super::RuleInfo {
                        summary: $summary,
                        checks: $checks,
                        why: concat!(
                            "| For | Verdict | Reason |\n|---|---|---|",
                            "\n| ", super::super::audience::title!($First), " | ", super::word!($FirstVerdict), " | ", $first, " |",
                            $("\n| ", super::super::audience::title!($Audience), " | ", super::word!($Verdict), " | ", $reason, " |",)*
                        ),
                        example: $example,
                        remedy: $remedy,
                        source: objdict_model::source_of!($($source)?),
                        ..super::RuleInfo::bare($id, super::severity(EFFECTS))
                    },
                    effects: EFFECTS,
                }
            };
        )+
    };
}
use changes;
