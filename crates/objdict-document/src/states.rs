//! The state machine and the error codes that the device profile defines.

use super::anchor::Anchor;
use super::context::Context;
use crate::describe::single_codes;
use crate::profile::{self, Profile, Transition, Values};

/// A state machine in tables.
pub(crate) struct StatesView {
    /// `CiA 402`.
    pub(crate) document: &'static str,
    /// The object that has the state, and the one that takes commands.
    pub(crate) objects: [Anchor; 2],
    /// The bits of the first object in each state.
    pub(crate) states: Vec<(String, &'static str)>,
    /// The bits of each command in the second one.
    pub(crate) commands: Vec<(&'static str, &'static str)>,
    pub(crate) transitions: Vec<Transition<'static>>,
}

/// An error code of EMCY with its meaning.
pub(crate) type ErrorCode = (String, &'static str);

/// The state machine of a device that has both of its objects.
pub(super) fn states(context: &Context<'_>) -> Option<StatesView> {
    let profile = profile::of_device(context.device)?;
    let machine = profile.state_machine()?;
    let objects = [machine.status, machine.command];
    if !objects.iter().all(|index| context.device.object(*index).is_some()) {
        return None;
    }
    let states = machine.states.into_iter().map(|(values, name)| (shown(&values), name));
    Some(StatesView {
        document: &profile.document,
        objects: objects.map(Anchor::object),
        states: states.collect(),
        commands: machine.commands,
        transitions: machine.transitions,
    })
}

/// The values in text: `x01x 0111`, `3`, `4–7`.
pub(super) fn shown(values: &Values) -> String {
    match values {
        Values::Mask(mask) => mask.clone(),
        Values::Range(range) if range.start() == range.end() => range.start().to_string(),
        Values::Range(range) => format!("{}–{}", range.start(), range.end()),
    }
}

/// The error codes of a device whose profile defines some: these, and those of communication.
pub(super) fn error_codes(context: &Context<'_>) -> Vec<ErrorCode> {
    let errors = profile::of_device(context.device).map(Profile::errors).filter(|errors| errors.len() > 0);
    let Some(errors) = errors else { return Vec::new() };
    let of_profile = errors.map(|(codes, name)| match (codes.start(), codes.end()) {
        (first, last) if first == last => (format!("0x{first:04X}"), name),
        (first, last) => (format!("0x{first:04X}–0x{last:04X}"), name),
    });
    let single = single_codes(context.language).map(|(code, name)| (format!("0x{code:04X}"), name));
    let mut codes: Vec<ErrorCode> = of_profile.chain(single).collect();
    codes.sort();
    codes
}
