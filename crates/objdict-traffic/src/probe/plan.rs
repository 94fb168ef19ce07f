//! What to ask a device.

use std::ops::{Range, RangeInclusive};

use super::exchange::{Exchange, SdoAnswer, SdoRequest};
use super::expectation::Expectation;
use objdict_bus::Abort;
use objdict_model::model::Device;

/// What is asked beside reading every readable entry.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ProbeOptions {
    /// Also try what must be refused, and write other values and the ones before.
    pub write: bool,
    /// Objects to write that are otherwise not written, because writing them is a command.
    pub also: Vec<RangeInclusive<u16>>,
}

/// What to ask a device, in its order.
#[derive(Clone, Debug)]
pub struct ProbePlan {
    pub(super) node_id: u8,
    pub(super) steps: Vec<Question>,
}

/// One question.
#[derive(Clone, Debug)]
pub(super) struct Question {
    pub(super) index: u16,
    pub(super) sub: u8,
    /// The entry; `None` for one that must not be there.
    pub(super) entry: Option<Expectation>,
    pub(super) attempt: Attempt,
    /// With what it must be refused.
    pub(super) refusal: Option<Abort>,
}

/// What is tried with an entry.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Attempt {
    Read,
    /// Writing the value that was read, which changes nothing.
    Own,
    /// The value with a byte more.
    Longer,
    /// The value without its last byte.
    Shorter,
    /// A value beyond a limit.
    Beyond(Vec<u8>),
    /// The first of these that is not the present one.
    Other(Vec<Vec<u8>>),
}

/// Objects whose values are commands: parameters are stored or lost, programs are replaced, a drive moves.
const COMMANDS: [(u16, u16); 7] = [
    (0x1003, 0x1003), // the error history is erased
    (0x1010, 0x1011), // store and restore parameters
    (0x1023, 0x1026), // commands of the operating system, prompt
    (0x1F50, 0x1F5F), // programs
    (0x1F80, 0x1F9F), // NMT master
    (0x6040, 0x6040), // controlword
    (0x1200, 0x12FF), // the SDO channel itself
];

/// The objects of communication: their values are never changed, as the client would lose the device.
const COMMUNICATION: Range<u16> = 0x1000..0x2000;

pub(super) fn is_command(index: u16) -> bool {
    COMMANDS.iter().any(|&(first, last)| (first..=last).contains(&index))
}

impl ProbePlan {
    /// What to ask the node of a description.
    pub fn new(device: &Device, node_id: u8, options: &ProbeOptions) -> Self {
        let device = device.with_implicit_pdos();
        let mut plan = Self { node_id, steps: Vec::new() };
        let objects = || device.objects.iter().filter(|(index, _)| **index >= COMMUNICATION.start);
        for (&index, object) in objects() {
            for (sub, entry) in object.entries() {
                let entry = Expectation::new(object, index, sub, &entry, node_id);
                if entry.is_readable() {
                    plan.ask(entry, Attempt::Read, None);
                } else if options.write {
                    plan.ask(entry, Attempt::Read, Some(Abort::WriteOnly));
                }
            }
        }
        if !options.write {
            return plan;
        }
        for (&index, object) in objects() {
            if object.object_type().has_subs()
                && let Some(sub) =
                    (1..=0xFE).find(|sub| !object.has(*sub) && Some(*sub) > object.highest_sub())
            {
                plan.ask_nothing(index, sub, Abort::NoSubIndex);
            }
            for (sub, entry) in object.entries() {
                let entry = Expectation::new(object, index, sub, &entry, node_id);
                plan.try_writing(entry, options.also.iter().any(|named| named.contains(&index)));
            }
        }
        if let Some(index) = (0x2000..=0xFFFF).rev().find(|index| !device.objects.contains_key(index)) {
            plan.ask_nothing(index, 0, Abort::NoObject);
        }
        plan
    }

    /// How many questions there are.
    pub const fn len(&self) -> usize {
        self.steps.len()
    }

    /// Whether the description has nothing to ask for.
    pub const fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// Whether values are written.
    pub fn writes(&self) -> bool {
        self.steps.iter().any(|step| step.attempt != Attempt::Read)
    }

    /// Asks over the SDO client of the application, as the script does: what was accepted is read, and the value before is written back.
    /// `transfer` makes one transfer.
    pub fn run(&self, transfer: impl FnMut(u16, u8, &SdoRequest) -> SdoAnswer) -> Vec<Exchange> {
        let mut asking = Asking { transfer, exchanges: Vec::new() };
        for step in &self.steps {
            asking.take(step);
        }
        asking.exchanges
    }

    fn ask(&mut self, entry: Expectation, attempt: Attempt, refusal: Option<Abort>) {
        self.steps.push(Question {
            index: entry.index,
            sub: entry.sub,
            entry: Some(entry),
            attempt,
            refusal,
        });
    }

    fn ask_nothing(&mut self, index: u16, sub: u8, refusal: Abort) {
        self.steps.push(Question { index, sub, entry: None, attempt: Attempt::Read, refusal: Some(refusal) });
    }

    /// What is tried with an entry that has a value, so that it can be written back.
    fn try_writing(&mut self, entry: Expectation, is_named: bool) {
        // without a type nothing is known of the answer
        if !entry.is_readable() || entry.data_type.is_none() || entry.access.is_none() {
            return;
        }
        if !entry.is_writable() {
            return self.ask(entry, Attempt::Own, Some(Abort::ReadOnly));
        }
        if is_command(entry.index) && !is_named {
            return;
        }
        let Some(length) = entry.length() else { return };
        self.ask(entry.clone(), Attempt::Longer, Some(Abort::TooLong));
        if COMMUNICATION.contains(&entry.index) && !is_named {
            return;
        }
        if length > 1 {
            self.ask(entry.clone(), Attempt::Shorter, Some(Abort::TooShort));
        }
        for bytes in entry.beyond_limits() {
            let is_low = entry.exceeded(&bytes).is_some_and(|(_, side)| side.is_lt());
            let refusal = if is_low { Abort::TooLow } else { Abort::TooHigh };
            self.ask(entry.clone(), Attempt::Beyond(bytes), Some(refusal));
        }
        let values = entry.allowed_values();
        if values.len() > 1 {
            self.ask(entry, Attempt::Other(values), None);
        }
    }
}

/// A plan that is carried out.
struct Asking<T> {
    transfer: T,
    exchanges: Vec<Exchange>,
}

impl<T: FnMut(u16, u8, &SdoRequest) -> SdoAnswer> Asking<T> {
    fn take(&mut self, step: &Question) {
        let before = self.read(step);
        let (false, Some(before)) = (step.attempt == Attempt::Read, before.filter(|bytes| !bytes.is_empty()))
        else {
            return;
        };
        let Some(sent) = step.attempt.bytes(&before) else { return };
        if self.write(step, sent.clone()) && sent != before {
            self.read(step);
            self.write(step, before);
            self.read(step);
        }
    }

    fn read(&mut self, step: &Question) -> Option<Vec<u8>> {
        let answer = self.transfer(step, SdoRequest::Upload);
        answer.bytes(step.entry.as_ref().and_then(|entry| entry.data_type))
    }

    fn write(&mut self, step: &Question, bytes: Vec<u8>) -> bool {
        self.transfer(step, SdoRequest::Download(bytes)) == SdoAnswer::Done
    }

    fn transfer(&mut self, step: &Question, request: SdoRequest) -> SdoAnswer {
        let (index, sub) = (step.index, step.sub);
        let answer = (self.transfer)(index, sub, &request);
        self.exchanges.push(Exchange { reset: None, index, sub, request, answer: answer.clone() });
        answer
    }
}

impl Attempt {
    /// What is written to an entry with this value.
    fn bytes(&self, before: &[u8]) -> Option<Vec<u8>> {
        match self {
            Self::Read => None,
            Self::Own => Some(before.to_vec()),
            Self::Longer => Some([before, &[0]].concat()),
            Self::Shorter => before.split_last().map(|(_, rest)| rest.to_vec()),
            Self::Beyond(bytes) => Some(bytes.clone()),
            Self::Other(values) => values.iter().find(|value| *value != before).cloned(),
        }
    }
}
