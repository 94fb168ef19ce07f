//! `objdict bus read`.

use std::io::Write;

use objdict_can::ClientError;
use objdict_model::diagnostic::plural;
use objdict_model::model::{Address, Device};
use objdict_node::{meant, resolve};

use super::session::BusSession;
use super::values::{ValueRow, ValueWords, write_json, write_table};
use crate::args::{BusReadArgs, ShowFormat};
use crate::ending::{Failure, Outcome};
use crate::stdout::Output;

pub(super) fn run(args: &BusReadArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let device = session.device(args.node).unwrap_or_default();
    let entries = entries(&device, &args.entries)?;
    let count = plural(entries.len(), "value");
    session.listen(Some(args.node), &format!("reads {count} of node {}", args.node))?;
    let words = ValueWords::new(&device, args.node);
    let read = read(&mut session, args.node, &entries)?;
    let rows: Vec<ValueRow> =
        entries.iter().zip(&read).map(|(entry, value)| words.row(*entry, shown(value))).collect();
    match args.connect.format {
        ShowFormat::Table => write_table(rows, out)?,
        ShowFormat::Json => write_json(args.node, rows, out)?,
    }
    let outcome = if read.iter().all(Result::is_ok) { Outcome::Clean } else { Outcome::Findings };
    if let Some(pause) = args.watch {
        watch(args, pause, &mut session, &words, (entries, read), out)?;
    }
    Ok(outcome)
}

/// The bytes of an entry, or why the node rejects the request.
type ReadValue = Result<Vec<u8>, String>;

fn shown(value: &ReadValue) -> Result<&[u8], String> {
    value.as_deref().map_err(Clone::clone)
}

fn read(session: &mut BusSession, node_id: u8, entries: &[(u16, u8)]) -> Result<Vec<ReadValue>, ClientError> {
    let mut read = Vec::new();
    for (index, sub) in entries {
        read.push(match session.client.upload(node_id, *index, *sub) {
            Ok(bytes) => Ok(bytes),
            Err(ClientError::Refused { abort, .. }) => Err(abort.to_string()),
            Err(error) => return Err(error),
        });
    }
    Ok(read)
}

/// Reads again after each pause in milliseconds, and writes what has changed, until the end or an interrupt.
fn watch(
    args: &BusReadArgs,
    pause: u32,
    session: &mut BusSession,
    words: &ValueWords<'_>,
    (entries, mut known): (Vec<(u16, u8)>, Vec<ReadValue>),
    out: &mut Output,
) -> Result<(), Failure> {
    let end = session.end(args.duration).unwrap_or(u64::MAX);
    let mut next = session.client.now();
    while next < end {
        out.flush()?;
        next = next.saturating_add(u64::from(pause) * 1000).min(end);
        let read = session.wait(next).and_then(|()| read(session, args.node, &entries));
        let read = match read {
            Ok(read) => read,
            Err(ClientError::Interrupted) => return Ok(()),
            Err(error) => return Err(error.into()),
        };
        for ((entry, known), value) in entries.iter().zip(&mut known).zip(read) {
            if *known != value {
                words.row(*entry, shown(&value)).write_change(
                    session.client.now(),
                    args.connect.format,
                    out,
                )?;
                *known = value;
            }
        }
    }
    Ok(())
}

/// The entries that texts name.
fn entries(device: &Device, names: &[String]) -> Result<Vec<(u16, u8)>, Failure> {
    let mut entries = Vec::new();
    for name in names {
        let found = resolve(device, name);
        if found.is_empty() {
            let failure = Failure::new(format_args!("no entry is called `{name}`"));
            return Err(failure.help(match meant(device, name) {
                Some(near) => format!("did you mean `{near}`? `objdict show FILE` lists all"),
                None => "name its index, or its description with `--with`".to_owned(),
            }));
        }
        found.into_iter().for_each(|address| add(device, address, &mut entries));
    }
    Ok(entries)
}

/// The entry of an address, or the readable entries of an object.
fn add(device: &Device, Address { index, sub }: Address, entries: &mut Vec<(u16, u8)>) {
    match (sub, device.object(index)) {
        (Some(sub), _) => entries.push((index, sub)),
        (None, Some(object)) => {
            let is_readable = |access: Option<objdict_model::model::Access>| {
                access.is_none_or(objdict_model::model::Access::is_readable)
            };
            let readable = object.entries().filter(|(_, entry)| is_readable(entry.implied_access()));
            entries.extend(readable.map(|(sub, _)| (index, sub)));
        }
        (None, None) => entries.push((index, 0)),
    }
}
