//! `objdict bus`: the devices of a CAN bus.

mod apply;
mod ask;
mod change;
mod command;
mod compare;
mod lss;
mod nmt;
mod question;
mod read;
mod replace;
mod restore;
mod save;
mod scan;
mod session;
mod values;
mod watch;
mod write;

pub(super) use self::ask::{ask, check};
#[cfg(feature = "schema")]
pub(super) use self::change::WritesJson as WritesDocument;
#[cfg(feature = "schema")]
pub(super) use self::command::BusCommandJson as CommandDocument;
#[cfg(feature = "schema")]
pub(super) use self::compare::ComparisonJson as ComparisonDocument;
#[cfg(feature = "schema")]
pub(super) use self::lss::{LssJson as LssDocument, LssPlanJson as LssPlanDocument};
#[cfg(feature = "schema")]
pub(super) use self::scan::ScanJson as ScanDocument;
#[cfg(feature = "schema")]
pub(super) use self::values::ValuesJson as ValuesDocument;
use super::args::BusCommand;
use super::ending::{Failure, Outcome};
use super::stdout::Output;

pub(super) fn run(command: &BusCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        BusCommand::Scan(args) => scan::run(args, out),
        BusCommand::Read(args) => read::run(args, out),
        BusCommand::Write(args) => write::run(args, out),
        BusCommand::Save(args) => save::run(args, out),
        BusCommand::Apply(args) => apply::run(args, out),
        BusCommand::Compare(args) => compare::run(args, out),
        BusCommand::Restore(args) => restore::run(args, out),
        BusCommand::Nmt(args) => nmt::run(args, out),
        BusCommand::Lss(args) => lss::run(&args.command, out),
        BusCommand::Watch(args) => watch::run(args, out),
        BusCommand::Replace(args) => replace::run(args, out),
    }
}
