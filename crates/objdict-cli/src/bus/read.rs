//! `objdict bus read`.

use objdict_can::ClientError;
use objdict_model::diagnostic::plural;
use objdict_model::model::{Address, Device};
use objdict_node::{meant, resolve};

use super::session::BusSession;
use super::values::{ValueWords, write_json, write_table};
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
    let (mut rows, mut outcome) = (Vec::new(), Outcome::Clean);
    for entry in entries {
        let bytes = match session.client.upload(args.node, entry.0, entry.1) {
            Ok(bytes) => Ok(bytes),
            Err(ClientError::Refused { abort, .. }) => {
                outcome = Outcome::Findings;
                Err(abort.to_string())
            }
            Err(error) => return Err(error.into()),
        };
        rows.push(words.row(entry, bytes.as_deref().map_err(Clone::clone)));
    }
    match args.format {
        ShowFormat::Table => write_table(rows, out)?,
        ShowFormat::Json => write_json(args.node, rows, out)?,
    }
    Ok(outcome)
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
