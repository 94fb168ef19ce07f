//! The answers of a device, judged one after the other.

use std::collections::{BTreeMap, BTreeSet};

use super::exchange::{Exchange, NodeReset, SdoAnswer, SdoRequest};
use super::expectation::{Expectation, hex, place};
use super::verdicts::{Aspect, Contradiction, KnownValue, of_download, of_undescribed, of_upload, words};
use objdict_bus::Abort;
use objdict_lint::recorded::probe as rules;
use objdict_model::diagnostic::{Diagnostic, Findings, RuleInfo};
use objdict_model::model::{Device, Place};

/// What came of the answers.
#[derive(Clone, Debug, Default)]
pub struct Judgement {
    /// The contradictions, each once, with places in the description.
    pub findings: Findings,
    /// The exchanges in their order.
    pub rows: Vec<Judged>,
    /// Readable entries of the description that were not read.
    pub unasked: Vec<(u16, u8)>,
}

/// An exchange in words, with its problem.
#[derive(Clone, Debug)]
pub struct Judged {
    /// The index.
    pub index: u16,
    /// The sub-index.
    pub sub: u8,
    /// The name of the entry; empty without one.
    pub name: String,
    /// `read`, or `write` and the bytes.
    pub asked: String,
    /// The value, or the abort code.
    pub answer: String,
    /// The rule that the answer contradicts, and how.
    pub problem: Option<(&'static RuleInfo, String)>,
}

impl Judgement {
    /// How many exchanges are as the description says.
    pub fn passed(&self) -> usize {
        self.rows.iter().filter(|row| row.problem.is_none()).count()
    }
}

/// Judges the answers of the node of a description.
pub fn judge(device: &Device, node_id: u8, exchanges: &[Exchange]) -> Judgement {
    let device = device.with_implicit_pdos();
    let mut judge = Judge::new(&device, node_id, exchanges);
    let rows = exchanges.iter().map(|exchange| judge.take(exchange)).collect();
    let unasked = judge.unasked(exchanges);
    Judgement { findings: judge.findings, rows, unasked }
}

struct Judge<'d> {
    device: &'d Device,
    node_id: u8,
    memory: BTreeMap<(u16, u8), KnownValue>,
    /// Entries that were written before the device saved its parameters.
    saved: BTreeSet<(u16, u8)>,
    /// What the device states as the highest sub-index.
    highest: BTreeMap<u16, u8>,
    /// Contradictions that are reported: a rule once for an entry.
    reported: BTreeSet<(&'static str, u16, Option<u8>)>,
    findings: Findings,
}

impl<'d> Judge<'d> {
    fn new(device: &'d Device, node_id: u8, exchanges: &[Exchange]) -> Self {
        let highest =
            exchanges.iter().filter(|exchange| exchange.sub == 0 && exchange.request == SdoRequest::Upload);
        let highest = highest.filter_map(|exchange| match exchange.answer.bytes(None).as_deref() {
            Some(&[highest]) => Some((exchange.index, highest)),
            _ => None,
        });
        Self {
            device,
            node_id,
            memory: BTreeMap::new(),
            saved: BTreeSet::new(),
            highest: highest.collect(),
            reported: BTreeSet::new(),
            findings: Findings::new(),
        }
    }

    fn take(&mut self, exchange: &Exchange) -> Judged {
        let Exchange { reset, index, sub, request, answer } = exchange;
        if let Some(reset) = reset {
            self.restart(*reset);
        }
        let entry = Expectation::of(self.device, *index, *sub, self.node_id);
        let problem = match &entry {
            None => self.of_undescribed(exchange),
            Some(entry) => self.of_described(entry, request, answer),
        };
        if let Some(problem) = &problem {
            self.report(exchange, problem);
        }
        Judged {
            index: *index,
            sub: *sub,
            name: entry.as_ref().map(|entry| entry.name.clone()).unwrap_or_default(),
            asked: match request {
                SdoRequest::Upload => "read".to_owned(),
                SdoRequest::Download(bytes) => format!("write {}", hex(bytes)),
            },
            answer: shown(entry.as_ref(), answer),
            problem: problem.map(|problem| (problem.rule, problem.message.to_string())),
        }
    }

    /// Forgets what was written before a reset; a device decides which parameters it saves.
    fn restart(&mut self, reset: NodeReset) {
        self.memory.retain(|(index, _), _| !reset.concerns(*index));
        let saved = self.saved.iter().filter(|(index, _)| reset.concerns(*index));
        self.memory.extend(saved.map(|&entry| (entry, KnownValue::Saved)));
    }

    /// What an accepted write does to other entries: saving keeps them over a reset (1010h), restoring undoes that (1011h).
    fn command(&mut self, index: u16, bytes: &[u8]) {
        match (index, bytes) {
            (0x1010, b"save") => self.saved.extend(self.memory.keys()),
            (0x1011, b"load") => self.saved.clear(),
            _ => {}
        }
    }

    fn of_undescribed(&self, exchange: &Exchange) -> Option<Contradiction> {
        let has_object = self.device.objects.contains_key(&exchange.index);
        let place = place(exchange.index, exchange.sub);
        of_undescribed(&place, &exchange.request, &exchange.answer, has_object)
    }

    fn of_described(
        &mut self,
        entry: &Expectation,
        request: &SdoRequest,
        answer: &SdoAnswer,
    ) -> Option<Contradiction> {
        match request {
            SdoRequest::Upload => {
                // what is above the highest sub-index of the device is said once, of sub-index 0
                let is_above = entry.sub > 0
                    && self.highest.get(&entry.index).is_some_and(|highest| *highest < entry.sub);
                let is_counted = is_above && matches!(answer, SdoAnswer::Abort(Abort::NoSubIndex));
                let memory = self.memory.get(&(entry.index, entry.sub)).unwrap_or(&KnownValue::Untouched);
                of_upload(entry, answer, memory).filter(|_| !is_counted || self.is_counted_right(entry.index))
            }
            SdoRequest::Download(bytes) => {
                let problem = of_download(entry, bytes, answer);
                if *answer == SdoAnswer::Done {
                    self.command(entry.index, bytes);
                }
                let memory = match problem {
                    None => KnownValue::Written(bytes.clone()),
                    Some(_) => KnownValue::Unknown,
                };
                if *answer == SdoAnswer::Done && (problem.is_none() || entry.is_writable()) {
                    self.memory.insert((entry.index, entry.sub), memory);
                }
                problem
            }
        }
    }

    /// Whether the highest sub-index of an object is not a finding itself.
    fn is_counted_right(&self, index: u16) -> bool {
        let Some(entry) = Expectation::of(self.device, index, 0, self.node_id) else { return true };
        let answer = self.highest.get(&index).map(|highest| SdoAnswer::Bytes(vec![*highest]));
        let problem = answer.and_then(|answer| of_upload(&entry, &answer, &KnownValue::Untouched));
        problem.is_none_or(|problem| problem.rule.id != rules::HIGHEST_SUB_INDEX.id)
    }

    fn report(&mut self, exchange: &Exchange, problem: &Contradiction) {
        let Exchange { index, sub, answer, .. } = exchange;
        // an object that is not there has no entries either, and those of compact storage are described once
        let object = self.device.object(*index);
        let is_object = *answer == SdoAnswer::Abort(Abort::NoObject)
            || object.is_some_and(|object| object.compact.is_some() && object.has(*sub));
        let key = (problem.rule.id, *index, Some(*sub).filter(|_| !is_object));
        if !self.reported.insert(key) {
            return;
        }
        let place = match (&problem.at, self.device.objects.contains_key(index)) {
            (_, false) => Place::device(),
            (Aspect::Entry, _) => self.device.entry_place(*index, *sub),
            (Aspect::Value, _) => self.device.value_place(*index, *sub),
            (Aspect::Field(field), _) => self.device.entry_place(*index, *sub).field(field.clone()),
        };
        self.findings
            .push(Diagnostic::new(problem.rule, place, problem.message.clone()).help(help(problem.rule)));
    }

    fn unasked(&self, exchanges: &[Exchange]) -> Vec<(u16, u8)> {
        let reads = exchanges.iter().filter(|exchange| exchange.request == SdoRequest::Upload);
        let asked: BTreeSet<(u16, u8)> = reads.map(|exchange| (exchange.index, exchange.sub)).collect();
        let objects = self.device.objects.iter().filter(|(index, _)| **index >= 0x1000);
        let entries = objects.flat_map(|(&index, object)| {
            object.entries().filter_map(move |(sub, entry)| {
                entry
                    .implied_access()
                    .is_none_or(objdict_model::model::Access::is_readable)
                    .then_some((index, sub))
            })
        });
        entries.filter(|entry| !asked.contains(entry)).collect()
    }
}

/// What to do about a finding.
pub fn help(rule: &RuleInfo) -> String {
    let mut characters = rule.remedy.trim_end_matches('.').chars();
    let first = characters.next().map(|first| first.to_ascii_lowercase());
    first.into_iter().chain(characters).collect()
}

/// An answer in words.
fn shown(entry: Option<&Expectation>, answer: &SdoAnswer) -> String {
    match answer {
        SdoAnswer::Length(Some(length)) => format!("{length} bytes"),
        SdoAnswer::Length(None) => "a value".to_owned(),
        SdoAnswer::Done => "accepted".to_owned(),
        SdoAnswer::Abort(abort) => format!("aborted with {}", words(*abort)),
        SdoAnswer::Silence => "no answer".to_owned(),
        SdoAnswer::Text(text) => text.clone(),
        answer => {
            let bytes = answer.bytes(entry.and_then(|entry| entry.data_type)).unwrap_or_default();
            entry.filter(|entry| entry.fits(&bytes)).map_or_else(|| hex(&bytes), |entry| entry.shown(&bytes))
        }
    }
}
