//! Severities that override those of the rules.

use std::collections::BTreeMap;
use std::str::FromStr;

use crate::diagnostic::{Findings, RuleInfo, Selection, Severity};

/// The level of the findings of a rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// The findings are not reported.
    Off,
    /// All findings have this severity.
    At(Severity),
}

impl Level {
    /// All levels, lowest first.
    pub const ALL: [Self; 4] =
        [Self::Off, Self::At(Severity::Note), Self::At(Severity::Warning), Self::At(Severity::Error)];

    /// The name of the level.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::At(severity) => severity.name(),
        }
    }
}

objdict_model::messages! { Level: { level => "{}", level.name(); } }

impl FromStr for Level {
    type Err = UnknownLevel;

    fn from_str(text: &str) -> Result<Self, UnknownLevel> {
        Self::ALL.into_iter().find(|level| level.name() == text).ok_or_else(|| UnknownLevel(text.to_owned()))
    }
}

/// A word that is not a level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownLevel(pub String);

objdict_model::error_messages! { UnknownLevel: {
    Self(name) => "`{name}` is not a valid severity: `off`, `note`, `warning` or `error`";
} }

/// Severities that override those of the rules. A later setting takes precedence.
#[derive(Clone, Debug, Default)]
pub struct Severities {
    rules: BTreeMap<&'static str, Level>,
    groups: BTreeMap<&'static str, Level>,
    /// The only rules that are reported; all rules if empty.
    only: Vec<Selection>,
}

impl Severities {
    /// Sets the level of the findings of rules. A group replaces the levels of its rules.
    pub fn set(&mut self, rules: Selection, level: Level) {
        match rules {
            Selection::Group(group) => {
                self.rules.retain(|id, _| group_of(id) != group);
                self.groups.insert(group, level);
            }
            Selection::Rule(rule) => {
                self.rules.insert(rule.id, level);
            }
        }
    }

    /// Disables all rules that are not selected. Further calls select more rules; a rule that is disabled
    /// for another reason remains so.
    pub fn select(&mut self, rules: Selection) {
        self.only.push(rules);
    }

    /// Adds the settings of `later`, which take precedence.
    pub fn extend(&mut self, later: &Self) {
        let groups = &later.groups;
        self.rules.retain(|id, _| !groups.contains_key(group_of(id)));
        self.groups.extend(groups);
        self.rules.extend(&later.rules);
        if !later.only.is_empty() {
            self.only.clone_from(&later.only);
        }
    }

    /// The level of a rule; `None` if its findings keep their own severity.
    pub fn of(&self, rule: &RuleInfo) -> Option<Level> {
        self.of_id(rule.id)
    }

    /// Whether findings of a rule, or of a whole group, are not reported.
    pub fn is_off(&self, rules: Selection) -> bool {
        let level = match rules {
            Selection::Group(group) => self.groups.get(group).copied(),
            Selection::Rule(rule) => self.of(rule),
        };
        level == Some(Level::Off)
    }

    fn of_id(&self, id: &str) -> Option<Level> {
        let is_selected = |rules: &Selection| rules.name() == id || rules.name() == group_of(id);
        if !self.only.is_empty() && !self.only.iter().any(is_selected) {
            return Some(Level::Off);
        }
        self.rules.get(id).or_else(|| self.groups.get(group_of(id))).copied()
    }

    /// Applies the levels to findings.
    pub fn apply(&self, mut findings: Findings) -> Findings {
        if self.rules.is_empty() && self.groups.is_empty() && self.only.is_empty() {
            return findings;
        }
        findings.remove_rules(|id| self.of_id(id) == Some(Level::Off));
        findings.filter_map(|finding| match self.of(finding.rule) {
            Some(Level::At(severity)) => Some(finding.severity(severity)),
            _ => Some(finding),
        })
    }
}

fn group_of(id: &str) -> &str {
    id.split_once('/').map_or(id, |(group, _)| group)
}
