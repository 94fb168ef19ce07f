//! A device beside its description: what to ask it over SDO ([`ProbePlan`]), what it answered ([`Exchange`]), and where its answers
//! contradict the description ([`judge`]).
//!
//! A plan is written as a script for python-canopen, as a table and as a log for `canplayer`. Answers come from that script, from a
//! table of a bench ([`read_answers`]) or from recorded frames ([`Conversation`]); they are judged alike, by what was asked and not by
//! who asked.

mod answers;
mod conversation;
mod exchange;
mod expectation;
mod files;
mod judge;
mod learn;
mod plan;
mod schema;
mod verdicts;

pub use answers::{AnswersError, read_answers};
pub use conversation::Conversation;
pub use exchange::{Exchange, NodeReset, SdoAnswer, SdoRequest};
pub use judge::help;
pub use judge::{Judged, Judgement, judge};
pub use learn::learn;
pub use objdict_lint::recorded::probe::RULES;
pub use plan::{ProbeOptions, ProbePlan};
pub use schema::answers_schema;
