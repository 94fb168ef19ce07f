//! One cause is one incident: what it leads to belongs to it.

use super::book::Draft;
use super::found::{Incident, IncidentState};
use crate::log::LogTime;
use objdict_lint::recorded::traffic::{self as rules, KINDS};
use objdict_model::diagnostic::{RuleInfo, Severity, plural};

const SECOND: i64 = 1_000_000_000;

/// What begins so much later is a consequence; a report of it may come earlier.
const SLACK: i64 = 2 * SECOND;

/// Axes and drives that stop within this time stop together.
const TOGETHER: i64 = SECOND / 10;

/// The incidents of a bus, each with its consequences.
pub(super) fn incidents(mut drafts: Vec<Draft>, channel: &str) -> Vec<Incident> {
    drafts.sort_by_key(|draft| draft.start);
    let mut drafts = with_interruptions(together(drafts));
    for kind in KINDS.iter().filter(|kind| !kind.leads_to.is_empty()) {
        drafts = with_consequences(drafts, kind.rule, kind.leads_to);
    }
    repeated(drafts).into_iter().map(|draft| draft.into_incident(channel)).collect()
}

impl Draft {
    fn is(&self, rule: &RuleInfo) -> bool {
        self.kind.rule.id == rule.id
    }

    fn is_of_drive(&self) -> bool {
        let of_drives = [
            &rules::DRIVE_FAULT,
            &rules::QUICK_STOP,
            &rules::REFUSED_TRANSITION,
            &rules::LIMIT_SWITCH,
            &rules::MOTION_ERROR,
            &rules::SET_POINT,
            &rules::INTERNAL_LIMIT,
        ];
        of_drives.iter().any(|rule| self.is(rule))
    }

    fn starts(&self) -> i64 {
        self.start.nanoseconds()
    }

    /// When it is over, in nanoseconds.
    fn ends(&self) -> i64 {
        self.end.map_or(i64::MAX, LogTime::nanoseconds)
    }

    /// Takes the nodes, the frames and the time of another one.
    fn join(&mut self, other: Self) {
        self.nodes.extend(other.nodes);
        self.nodes.sort_unstable();
        self.nodes.dedup();
        self.end = self.end.zip(other.end).map(|(end, other)| end.max(other));
        self.frames.join(other.frames);
        self.events += other.events;
        self.consequences += other.consequences;
    }

    fn into_incident(self, channel: &str) -> Incident {
        let state = match (self.kind.rule.severity, self.end) {
            (Severity::Error, None) => IncidentState::Unresolved,
            (Severity::Error, Some(_)) => IncidentState::Recovered,
            _ => IncidentState::Warning,
        };
        let is_drive = self.is_of_drive();
        let axes = (1..=8).filter(|axis| is_drive && self.about >> axis & 1 == 1).collect();
        let mut text = self.text;
        if self.events > 1 {
            text.push_str(&format!(", {} times", self.events));
        } else if let (IncidentState::Recovered, Some(end)) = (state, self.end) {
            let time = end.nanoseconds().saturating_sub(self.start.nanoseconds());
            text.push_str(&format!("; recovered after {} s", seconds(time)));
        }
        if self.consequences > 0 {
            text.push_str(&format!(", with {}", plural(self.consequences, "consequence")));
        }
        Incident {
            number: 0,
            fingerprint: String::new(),
            kind: self.kind,
            state,
            channel: channel.to_owned(),
            nodes: self.nodes,
            axes,
            start: self.start,
            end: self.end,
            text,
            events: self.events,
            frames: self.frames.into_vec(),
            causes: self.kind.causes,
            checks: self.kind.look,
            why: self.kind.rule.why,
            needs: self.kind.rule.needs,
            about: self.about,
        }
    }
}

/// Nanoseconds as seconds with three digits.
fn seconds(nanoseconds: i64) -> String {
    let milliseconds = (nanoseconds.unsigned_abs() + 500_000) / 1_000_000;
    format!("{}.{:03}", milliseconds / 1000, milliseconds % 1000)
}

/// Joins each incident to the last one before that it belongs to.
fn joined(
    drafts: Vec<Draft>,
    belongs: impl Fn(&Draft, &Draft) -> bool,
    join: impl Fn(&mut Draft, Draft),
) -> Vec<Draft> {
    let mut kept: Vec<Draft> = Vec::new();
    for draft in drafts {
        match kept.iter_mut().rev().find(|first| belongs(first, &draft)) {
            Some(first) => join(first, draft),
            None => kept.push(draft),
        }
    }
    kept
}

/// Drives whose axes are in a fault at one time, with the axes as bits.
fn together(mut drafts: Vec<Draft>) -> Vec<Draft> {
    for draft in drafts.iter_mut().filter(|draft| draft.is_of_drive()) {
        draft.about = 1 << draft.about.min(31);
    }
    let belongs = |first: &Draft, draft: &Draft| {
        draft.is_of_drive() && first.is(draft.kind.rule) && draft.starts() - first.starts() <= TOGETHER
    };
    joined(drafts, belongs, |first, draft| {
        first.about |= draft.about;
        first.text = format!("{}, {}", first.text, draft.text);
        first.join(draft);
        first.events = 1;
    })
}

/// Whether two nodes are silent at the same time.
fn is_one_silence(a: &Draft, b: &Draft) -> bool {
    let is_open = a.end.is_none() && b.end.is_none();
    let ends_with = || a.end.is_some() && b.end.is_some() && a.ends().abs_diff(b.ends()) <= SLACK as u64;
    a.starts().abs_diff(b.starts()) <= SLACK as u64
        && (is_open || ends_with())
        && a.starts().max(b.starts()) < a.ends().min(b.ends())
        && a.nodes != b.nodes
}

/// Several nodes that are silent at one time are one incident of the bus.
fn with_interruptions(drafts: Vec<Draft>) -> Vec<Draft> {
    let is_silence = |draft: &Draft| draft.is(&rules::LATE_HEARTBEAT) || draft.is(&rules::SILENT_NODE);
    let belongs = |first: &Draft, draft: &Draft| {
        (is_silence(first) || first.is(&rules::INTERRUPTED_BUS))
            && is_silence(draft)
            && is_one_silence(first, draft)
    };
    let kind = KINDS.iter().find(|kind| kind.rule.id == rules::INTERRUPTED_BUS.id);
    joined(drafts, belongs, |first, draft| {
        first.kind = kind.unwrap_or(first.kind);
        first.join(draft);
        let nodes: Vec<String> = first.nodes.iter().map(ToString::to_string).collect();
        first.text = format!("nodes {} are silent at the same time", nodes.join(", "));
        (first.about, first.events) = (0, 1);
    })
}

/// Gives the consequences of a kind to the incidents that lead to them.
fn with_consequences(drafts: Vec<Draft>, rule: &RuleInfo, leads_to: &[&RuleInfo]) -> Vec<Draft> {
    let (mut causes, others): (Vec<Draft>, Vec<Draft>) = drafts.into_iter().partition(|draft| draft.is(rule));
    let mut kept = Vec::new();
    for draft in others {
        let is_effect = leads_to.iter().any(|effect| draft.is(effect));
        match causes.iter_mut().rev().find(|cause| is_effect && cause.leads_to(&draft)) {
            Some(cause) => cause.take_effect(draft),
            None => kept.push(draft),
        }
    }
    causes.append(&mut kept);
    causes.sort_by_key(|draft| draft.start);
    causes
}

impl Draft {
    fn leads_to(&self, effect: &Draft) -> bool {
        let (start, at) = (self.starts(), effect.starts());
        let is_of_bus = self.nodes.is_empty() || self.is(&rules::INTERRUPTED_BUS);
        // a manager that is silent sends no SYNC
        let is_sync =
            effect.is(&rules::SYNC_CYCLE) && effect.end.is_none() && self.end.is_none() && effect.about == 2;
        let is_own = !effect.nodes.is_empty() && effect.nodes.iter().all(|node| self.nodes.contains(node));
        let is_same = is_of_bus || is_own || is_sync;
        // consumers report a node that is silent with 81xxh
        let is_reported = effect.is(&rules::EMERGENCY) && effect.about & 0xFF00 == 0x8100;
        let until = if is_same && !effect.is(&rules::EMERGENCY) { self.ends() } else { start };
        let may_be = is_same || is_reported && !self.is(&rules::DRIVE_FAULT);
        // a report may come before what it reports, and a node is silent before it boots
        let is_early = self.is(&rules::DRIVE_FAULT) || self.is(&rules::UNEXPECTED_BOOT_UP);
        let from = if is_early { start.saturating_sub(SLACK / 2) } else { start };
        may_be && at >= from && at <= until.saturating_add(SLACK)
    }

    fn take_effect(&mut self, effect: Self) {
        if self.is(&rules::DRIVE_FAULT) && effect.is(&rules::EMERGENCY) {
            let report = effect.text.find("EMCY").map_or("", |at| &effect.text[at..]);
            self.text = format!("{}: {report}", self.text);
            // the error code distinguishes two faults of a drive
            self.about |= effect.about << 16;
        } else {
            self.consequences += 1;
        }
        self.frames.join(effect.frames);
    }
}

/// What happens again and is over each time is one incident, but each fault of a drive is an incident.
fn repeated(drafts: Vec<Draft>) -> Vec<Draft> {
    let subject = |draft: &Draft| (draft.kind.rule.id, draft.nodes.clone(), draft.about, draft.end.is_some());
    let belongs = |first: &Draft, draft: &Draft| {
        first.is(draft.kind.rule) && !draft.is(&rules::DRIVE_FAULT) && subject(first) == subject(draft)
    };
    joined(drafts, belongs, Draft::join)
}
