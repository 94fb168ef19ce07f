//! `objdict bus save`.

use std::io::Write;

use objdict_can::SavedValues;
use objdict_format as format;
use objdict_format::input::Reading;
use objdict_format::{Format, NodeSettings, WriteOptions, stated_name};
use objdict_model::diagnostic::plural;
use objdict_model::model::{Assignment, Commissioning, Device, DeviceKind};
use objdict_node::parameter::present_values;

use super::session::BusSession;
use super::values::{ValueWords, write_json, write_table};
use crate::args::{BusSaveArgs, ShowFormat};
use crate::configure::tell_left_out;
use crate::ending::{Failure, Outcome};
use crate::input::{Input, name_of, source_name};
use crate::node::commissioning;
use crate::settings::reading;
use crate::stdout::Output;
use crate::written_files::{require_other, save};

pub(super) fn run(args: &BusSaveArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut session = BusSession::open(&args.connect)?;
    let device = session.require_device(args.node)?;
    require_other(&args.output)?;
    session.listen(Some(args.node), &format!("reads the parameters of node {}", args.node))?;
    let saved = session.client.save(args.node, &device)?;
    let (assignments, _) = present_values(&device, args.node, saved.values.iter().cloned());
    let wanted = Commissioning {
        node_id: Some(args.node),
        baud_rate: session.client.bit_rate(),
        ..Commissioning::default()
    };
    let node = commissioning(&device, &wanted, "file")?;
    save(&args.output, &file(args, &device, &node, &assignments)?)?;
    report(args, &device, &saved, &assignments, out)?;
    Ok(if saved.refused.is_empty() { Outcome::Clean } else { Outcome::Findings })
}

/// The file with the values: the text of the description, else a new one.
fn file(
    args: &BusSaveArgs,
    device: &Device,
    node: &Commissioning,
    assignments: &[Assignment],
) -> Result<Vec<u8>, Failure> {
    let name = stated_name(&args.output.file_name().unwrap_or_default().to_string_lossy());
    let [with] = args.connect.with.as_slice() else { return new_file(device, node, assignments) };
    let mut patches = args.connect.input.patch.patches.clone();
    patches.extend(args.connect.input.config.patches_of(&with.path)?);
    match (Reading { patches, is_node: true, ..reading() }).open(&with.path) {
        Ok((_, Input::Description(description))) => {
            let parts = NodeSettings { node, plugged: None, assignments, downloads: &[] };
            Ok(description.configured(&name, &parts).map_err(Failure::new)?.bytes)
        }
        _ => new_file(device, node, assignments),
    }
}

fn new_file(device: &Device, node: &Commissioning, assignments: &[Assignment]) -> Result<Vec<u8>, Failure> {
    let mut device = device.clone();
    (device.kind, device.commissioning) = (DeviceKind::Node, Some(node.clone()));
    device.assign(assignments);
    let options = WriteOptions { embed: true, ..WriteOptions::default() };
    Ok(format::write(&device, Format::Dcf, &options)?.bytes)
}

fn report(
    args: &BusSaveArgs,
    device: &Device,
    saved: &SavedValues,
    assignments: &[Assignment],
    out: &mut Output,
) -> Result<(), Failure> {
    let words = ValueWords::new(device, args.node);
    let is_other = |entry: &(u16, u8)| assignments.iter().any(|at| (at.index, at.sub) == *entry);
    let values = saved.values.iter().filter(|(entry, _)| is_other(entry));
    let values = values.map(|(entry, bytes)| words.row(*entry, Ok(bytes)));
    let refused = saved.refused.iter().map(|(entry, abort)| words.row(*entry, Err(abort.to_string())));
    let rows: Vec<_> = values.chain(refused).collect();
    match args.connect.format {
        ShowFormat::Json => write_json(args.node, rows, out)?,
        ShowFormat::Table => {
            if !rows.is_empty() {
                write_table(rows, out)?;
                writeln!(out)?;
            }
            let (count, others) = (plural(saved.values.len(), "value"), assignments.len());
            let name = name_of(&args.output);
            out.summary(format_args!("{name}: {count} read, {others} not as in `{}`", source_of(args)))?;
        }
    }
    tell_left_out(&saved.left_out);
    Ok(())
}

fn source_of(args: &BusSaveArgs) -> String {
    args.connect.with.first().map_or_else(String::new, |with| source_name(&with.path))
}
