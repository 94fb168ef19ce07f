//! Which changes are reported.

use std::ops::RangeInclusive;
use std::str::FromStr;

use objdict_node::{ObjectName, resolve};

use crate::args::indexes;
use objdict_lint::changes::{Audience, CHANGE, ChangeVerdict, DeviceChange};
use objdict_model::diagnostic::{Selection, listing};
use objdict_model::model::{Address, Device};
use objdict_project::registry;

/// Changes of a kind, with a verdict, that affect an audience, or of objects.
#[derive(Clone, Debug)]
pub(crate) enum ChangeChoice {
    Rules(Selection),
    Verdict(ChangeVerdict),
    Audience(Audience),
    Objects(String),
    Indexes(RangeInclusive<u16>),
}

impl FromStr for ChangeChoice {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let lower = text.to_ascii_lowercase();
        if let Some(verdict) = ChangeVerdict::ALL.into_iter().find(|verdict| verdict.name() == lower) {
            return Ok(Self::Verdict(verdict));
        }
        if let Some(audience) = Audience::ALL.into_iter().find(|audience| audience.name() == lower) {
            return Ok(Self::Audience(audience));
        }
        let full = if lower.contains('/') { lower.clone() } else { format!("{CHANGE}/{lower}") };
        if let Some(rule) = registry::rule(&full).filter(|rule| rule.group() == CHANGE) {
            return Ok(Self::Rules(Selection::Rule(rule)));
        }
        if let Ok(indexes) = indexes(text) {
            return Ok(Self::Indexes(indexes));
        }
        let is_name = !lower.contains('/') && text.parse::<ObjectName>().is_ok();
        if is_name { Ok(Self::Objects(text.to_owned())) } else { Err(unknown(text)) }
    }
}

fn unknown(text: &str) -> String {
    let words =
        ChangeVerdict::ALL.map(ChangeVerdict::name).into_iter().chain(Audience::ALL.map(Audience::name));
    format!("`{text}` is not a rule of the group {CHANGE}, an object, or one of {}", listing(words))
}

impl ChangeChoice {
    /// Whether a change between two devices is one of these.
    pub(super) fn has(&self, change: &DeviceChange, devices: [&Device; 2]) -> bool {
        match self {
            Self::Rules(rules) => rules.contains(&change.rule.info),
            Self::Verdict(verdict) => change.verdict() == *verdict,
            Self::Audience(audience) => change.effects().any(|effect| effect.audience == *audience),
            Self::Indexes(indexes) => change.index.is_some_and(|index| indexes.contains(&index)),
            Self::Objects(name) => {
                devices.into_iter().flat_map(|device| resolve(device, name)).any(|address| {
                    let Address { index, sub } = address;
                    change.index == Some(index) && (sub.is_none() || sub == change.sub)
                })
            }
        }
    }
}
