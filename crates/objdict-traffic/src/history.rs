//! The first events of a kind; more are counted.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};

use crate::Origin;
use crate::log::{LogTime, LoggedFrame};
use objdict_model::diagnostic::{Diagnostic, RuleInfo};
use objdict_model::source::Span;

/// The most events of a node that are kept.
const MAX_EVENTS: usize = 1000;

/// The most events of a node that are kept of a rule.
const MAX_FINDINGS: usize = 100;

/// The most events of all nodes; beyond them the first of each rule and node is kept.
const MAX_ALL: usize = 4096;

/// When a frame was seen, and where its log has it.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Seen {
    /// The time, in seconds with the digits of the log.
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub time: LogTime,
    /// The number of the line in the log, or of the packet in a capture, from 1.
    pub line: u64,
    /// The position of the log.
    #[serde(skip)]
    pub log: usize,
    /// The line; in a capture the frame as candump would write it.
    #[serde(skip)]
    pub text: String,
}

impl Seen {
    pub(crate) fn of(frame: &LoggedFrame, Origin { log, line, text }: Origin<'_>) -> Self {
        let text = match text {
            [] => frame.to_string(),
            // most lines are valid, which is found faster than the characters that are not
            text => str::from_utf8(text)
                .map_or_else(|_| String::from_utf8_lossy(text).into_owned(), str::to_owned),
        };
        Self { time: frame.time, line, log, text }
    }
}

/// An event of a node.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct NodeEvent {
    /// When it happened, and the frame that shows it.
    #[serde(flatten)]
    pub moment: Seen,
    /// The node-ID.
    pub node: u8,
    /// The rule that it is against; absent for what no rule forbids.
    #[serde(serialize_with = "id", skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(with = "Option<String>"))]
    pub rule: Option<&'static RuleInfo>,
    /// What happened.
    pub text: String,
}

impl NodeEvent {
    /// The finding of an event that is against a rule, at the line of its frame.
    pub fn finding(&self, line: Span) -> Option<Diagnostic> {
        let rule = self.rule?;
        let message = format!("{}: {}", self.moment.time, self.text);
        Some(Diagnostic::new(rule, line, message).help(crate::probe::help(rule)))
    }
}

fn id<S: Serializer>(rule: &Option<&'static RuleInfo>, serializer: S) -> Result<S::Ok, S::Error> {
    rule.map(|rule| rule.id).serialize(serializer)
}

/// Events in their order.
#[derive(Clone, Debug, Default)]
pub(crate) struct History {
    events: Vec<NodeEvent>,
    /// How many there were of a node, by the id of their rule, and how many of them are not kept.
    counts: BTreeMap<(Option<&'static str>, u8), (usize, usize)>,
}

impl History {
    /// Adds an event of a node, whose text is made if it is kept.
    pub(crate) fn add(
        &mut self,
        moment: Seen,
        node: u8,
        rule: Option<&'static RuleInfo>,
        text: impl FnOnce() -> String,
    ) {
        let (count, further) = self.counts.entry((rule.map(|rule| rule.id), node)).or_default();
        *count += 1;
        let most = if rule.is_some() { MAX_FINDINGS } else { MAX_EVENTS };
        if *count == 1 || *count <= most && self.events.len() < MAX_ALL {
            self.events.push(NodeEvent { moment, node, rule, text: text() });
        } else {
            *further += 1;
        }
    }

    /// Forgets the events of a rule.
    pub(crate) fn forget(&mut self, rule: &'static RuleInfo) {
        self.events.retain(|event| event.rule.is_none_or(|of| of.id != rule.id));
        self.counts.retain(|(of, _), _| *of != Some(rule.id));
    }

    /// Takes the events out. The last one of a rule and node says how many more there were.
    pub(crate) fn take(&mut self) -> Vec<NodeEvent> {
        for (&(rule, node), (_, more)) in self.counts.iter().filter(|((rule, _), _)| rule.is_some()) {
            let of_rule =
                |event: &&mut NodeEvent| event.node == node && event.rule.map(|rule| rule.id) == rule;
            if let (Some(last), 1..) = (self.events.iter_mut().rev().find(of_rule), *more) {
                last.text.push_str(&format!(" (the rule finds {more} more of this node)"));
            }
        }
        std::mem::take(&mut self.events)
    }

    /// How many events are not kept.
    pub(crate) fn further(&self) -> u64 {
        self.counts.values().map(|(_, further)| *further as u64).sum()
    }
}
