//! Incidents while the frames are read, in memory that does not grow with their number.

use std::collections::{BTreeMap, VecDeque};

use crate::history::{History, NodeEvent, Seen};
use crate::log::LogTime;
use objdict_lint::recorded::traffic::{IncidentKind, KINDS};
use objdict_model::diagnostic::RuleInfo;

/// The most incidents of a kind and node; of more, the last one takes the events.
const MAX_INCIDENTS: usize = 20;

/// So many incidents of a bus are kept, and beyond them the first of each kind and node; of more, the last one of these takes the events.
const MAX_ALL: usize = 4096;

/// How many of the first frames of an incident are kept, and of the last ones.
const MAX_FRAMES: usize = 8;

/// What an incident is about: its kind, the node (0 for the bus), and a number such as a CAN-ID, an entry, a code or an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Subject {
    pub(crate) rule: &'static RuleInfo,
    pub(crate) node: u8,
    pub(crate) about: u32,
}

impl Subject {
    pub(crate) const fn new(rule: &'static RuleInfo, node: u8, about: u32) -> Self {
        Self { rule, node, about }
    }

    const fn key(self) -> (u8, u32, &'static str) {
        (self.node, self.about, self.rule.id)
    }
}

/// An incident that may still go on.
#[derive(Clone, Debug)]
pub(super) struct Draft {
    pub(super) kind: &'static IncidentKind,
    pub(super) nodes: Vec<u8>,
    pub(super) about: u32,
    pub(super) text: String,
    pub(super) start: LogTime,
    pub(super) end: Option<LogTime>,
    pub(super) events: u64,
    /// How many incidents it has led to.
    pub(super) consequences: usize,
    pub(super) frames: KeptFrames,
}

/// The first and the last frames of an incident.
#[derive(Clone, Debug, Default)]
pub(super) struct KeptFrames {
    first: Vec<NodeEvent>,
    last: VecDeque<NodeEvent>,
}

impl KeptFrames {
    fn push(&mut self, event: NodeEvent) {
        if self.first.len() < MAX_FRAMES {
            return self.first.push(event);
        }
        if self.last.len() == MAX_FRAMES {
            self.last.pop_front();
        }
        self.last.push_back(event);
    }

    pub(super) fn into_vec(self) -> Vec<NodeEvent> {
        self.first.into_iter().chain(self.last).collect()
    }

    /// The frames of both in the order of their times.
    pub(super) fn join(&mut self, other: Self) {
        let mut all = std::mem::take(self).into_vec();
        all.extend(other.into_vec());
        all.sort_by_key(|event| event.moment.time);
        all.into_iter().for_each(|event| self.push(event));
    }
}

/// The incidents of a bus.
#[derive(Clone, Debug, Default)]
pub(crate) struct IncidentBook {
    drafts: Vec<Draft>,
    /// The last incident about a subject.
    known: BTreeMap<(u8, u32, &'static str), usize>,
    counts: BTreeMap<(&'static str, u8), (usize, usize)>,
    /// The events that are against a rule, as findings.
    pub(crate) findings: History,
}

impl IncidentBook {
    /// An event that is against the rule of a subject: it begins an incident, or belongs to the one that is not over.
    pub(crate) fn against(&mut self, subject: Subject, moment: Seen, text: impl FnOnce() -> String) {
        let Subject { rule, node, about } = subject;
        let text = text();
        self.findings.add(moment.clone(), node, Some(rule), || text.clone());
        let open = self.known.get(&subject.key()).copied().filter(|at| self.drafts[*at].end.is_none());
        let at = open.or_else(|| {
            let (count, last) = self.counts.get(&(rule.id, node)).copied().unwrap_or_default();
            (count > 0 && (count >= MAX_INCIDENTS || self.drafts.len() >= MAX_ALL)).then_some(last)
        });
        let at = at.or_else(|| {
            let kind = KINDS.iter().find(|kind| kind.rule.id == rule.id)?;
            let (nodes, start) = ([node].into_iter().filter(|node| *node != 0).collect(), moment.time);
            let (end, events, consequences, frames, text) = (None, 0, 0, KeptFrames::default(), text.clone());
            self.drafts.push(Draft { kind, nodes, about, text, start, end, events, consequences, frames });
            let at = self.drafts.len() - 1;
            let count = self.counts.entry((rule.id, node)).or_default();
            *count = (count.0 + 1, at);
            self.known.insert(subject.key(), at);
            Some(at)
        });
        if let Some(draft) = at.and_then(|at| self.drafts.get_mut(at)) {
            (draft.end, draft.events) = (None, draft.events + 1);
            draft.frames.push(NodeEvent { moment, node, rule: Some(rule), text });
        }
    }

    /// A frame that belongs to the last incident about a subject.
    pub(crate) fn step(&mut self, subject: Subject, moment: Seen, text: &str) {
        if let Some(draft) = self.known.get(&subject.key()).and_then(|at| self.drafts.get_mut(*at)) {
            let text = text.to_owned();
            draft.frames.push(NodeEvent { moment, node: subject.node, rule: None, text });
        }
    }

    /// Whether an incident about a subject is not over.
    pub(crate) fn is_open(&self, subject: Subject) -> bool {
        self.known.get(&subject.key()).is_some_and(|at| self.drafts[*at].end.is_none())
    }

    /// A frame that ends the incident about a subject.
    pub(crate) fn end(&mut self, subject: Subject, moment: impl FnOnce() -> Seen, text: &str) {
        if self.is_open(subject) {
            let moment = moment();
            let end = moment.time;
            self.step(subject, moment, text);
            if let Some(draft) = self.known.get(&subject.key()).and_then(|at| self.drafts.get_mut(*at)) {
                draft.end = Some(end);
            }
        }
    }

    /// Forgets the incidents of a kind, which the whole log does not bear out.
    pub(crate) fn forget(&mut self, rule: &'static RuleInfo) {
        self.drafts.retain(|draft| draft.kind.rule.id != rule.id);
        // positions are others now
        self.known.clear();
        self.counts.clear();
        self.findings.forget(rule);
    }

    pub(super) fn take(&mut self) -> Vec<Draft> {
        self.known.clear();
        std::mem::take(&mut self.drafts)
    }
}
