//! `objdict show`: the dictionary as a table, one object or one entry of it in detail.

mod json;
mod nodes;
mod text;

use std::borrow::Cow;
use std::io::Write;

#[cfg(feature = "schema")]
pub(super) use self::json::EntriesJson as EntriesDocument;
#[cfg(feature = "schema")]
pub(super) use self::nodes::NodesJson as NodeListDocument;
use super::args::{ShowArgs, ShowFormat};
use super::ending::{Failure, Outcome};
use super::input::{Input, source_name};
use super::settings::ConfigFileArgs;
use super::stdout::Output;
use super::table::fit;
use objdict_document::describe::ValueReader;
use objdict_format::input::{Reading, of_text};
use objdict_format::json as json_format;
use objdict_model::model::{Address, Device, Entry, Object};
use objdict_node::concise;
use objdict_node::download::{ConciseDcf, Download};
use objdict_node::{meant, resolve};

/// A device to be shown.
struct ShownDevice<'a> {
    file: &'a str,
    format: &'static str,
    device: &'a Device,
    /// The node that formulas are evaluated for.
    node_id: Option<u8>,
    /// Whether only what is configured to another value than its default is shown.
    changed: bool,
}

impl ShownDevice<'_> {
    fn reader(&self, index: u16) -> ValueReader {
        ValueReader { index, node_id: self.node_id }
    }

    /// Whether an entry is to be shown.
    fn shows(&self, entry: &Entry) -> bool {
        !self.changed || entry.is_changed(self.node_id)
    }
}

pub(super) fn run(args: &ShowArgs, out: &mut Output) -> Result<Outcome, Failure> {
    // what a rule finds is shown too
    let patches = ConfigFileArgs::default().patches_of(&args.file)?;
    let reading = Reading { judge: Some(of_text), ..args.input.reading_with(&patches) };
    let (kind, input) = reading.read_one(&source_name(&args.file), args.input.size.read(&args.file)?)?;
    let (device, format) = match &input {
        Input::Description(description) if description.is_project() => (description.device(), kind.name()),
        Input::Description(description) => (description.device(), description.format().name()),
        Input::Device(device) => (device.as_ref(), "JSON"),
        Input::NodeList(list) => return nodes::show(list, args, out).map(|()| Outcome::Clean),
        Input::Concise(configuration) => {
            return show_configuration(configuration, args, out).map(|()| Outcome::Clean);
        }
    };
    let file = source_name(&args.file);
    let device = args.expand.device(device);
    let view = ShownDevice {
        file: &file,
        format,
        device: &device,
        node_id: args.node_id.or(device.node_id()),
        changed: args.changed,
    };
    let Some(name) = &args.object else {
        show_device(&view, args.format, out)?;
        return Ok(Outcome::Clean);
    };
    match resolve(&device, name)[..] {
        [] => return Err(unknown(&view, name)),
        [address] => show_address(&view, address, args.format, out)?,
        ref addresses => show_addresses(&view, addresses, args.format, out)?,
    }
    Ok(Outcome::Clean)
}

/// The downloads of a concise DCF, or those to one object or entry.
fn show_configuration(configuration: &ConciseDcf, args: &ShowArgs, out: &mut Output) -> Result<(), Failure> {
    let address: Option<Address> = match args.object.as_deref().map(str::parse) {
        Some(Err(_)) => {
            let failure = Failure::new("a concise DCF has no object names");
            return Err(failure.help("name an index such as `1018` or `1018:1`"));
        }
        Some(Ok(address)) => Some(address),
        None => None,
    };
    let is_wanted = |download: &Download| {
        address.is_none_or(|at| download.index == at.index && at.sub.is_none_or(|sub| sub == download.sub))
    };
    if args.format == ShowFormat::Json {
        let wanted = configuration.0.iter().filter(|download| is_wanted(download));
        let text = json_format::write_configuration(&ConciseDcf(wanted.cloned().collect()));
        out.raw()?.write_all(text.as_bytes())?;
        return Ok(());
    }
    // two lines of headings, then a line a download
    for (number, line) in concise::table(configuration).lines().enumerate() {
        let download = number.checked_sub(2).and_then(|number| configuration.0.get(number));
        if download.is_none_or(is_wanted) {
            writeln!(out, "{line}")?;
        }
    }
    Ok(())
}

fn show_device(view: &ShownDevice<'_>, format: ShowFormat, out: &mut Output) -> Result<(), Failure> {
    match format {
        ShowFormat::Table => text::device(view, out)?,
        ShowFormat::Json => {
            let objects = view.device.objects.iter().map(|(&index, object)| (index, object));
            json::write(view, objects, |_| true, &view.device.downloads, &mut out.raw()?)?;
        }
    }
    Ok(())
}

fn show_address(
    view: &ShownDevice<'_>,
    at: Address,
    format: ShowFormat,
    out: &mut Output,
) -> Result<(), Failure> {
    let Some(object) = view.device.object(at.index) else {
        return Err(no_object(view, at.index));
    };
    let entry = match at.sub {
        Some(sub) => Some((sub, object.entry(sub).ok_or_else(|| no_entry(at.index, object, sub))?)),
        None => single(object),
    };
    match format {
        ShowFormat::Json => {
            let is_wanted = |sub| at.sub.is_none_or(|wanted| wanted == sub);
            json::write(view, std::iter::once((at.index, object)), is_wanted, &[], &mut out.raw()?)?;
        }
        ShowFormat::Table => match entry {
            Some((sub, entry)) => text::entry(view, (at.index, sub), object, &entry, out)?,
            None => text::object(view, at.index, object, out)?,
        },
    }
    Ok(())
}

/// Several objects or entries, one after the other.
fn show_addresses(
    view: &ShownDevice<'_>,
    addresses: &[Address],
    format: ShowFormat,
    out: &mut Output,
) -> Result<(), Failure> {
    if format == ShowFormat::Json {
        let is_wanted = |index| addresses.iter().any(|at| at.index == index);
        let objects = view.device.objects.iter().filter(|(index, _)| is_wanted(**index));
        let objects = objects.map(|(&index, object)| (index, object));
        json::write(view, objects, |_| true, &[], &mut out.raw()?)?;
        return Ok(());
    }
    for (number, &address) in addresses.iter().enumerate() {
        if number > 0 {
            writeln!(out)?;
        }
        show_address(view, address, format, out)?;
    }
    Ok(())
}

fn unknown(view: &ShownDevice<'_>, name: &str) -> Failure {
    let failure = Failure::new(format_args!("`{}` has no object `{name}`", view.file));
    match meant(view.device, name) {
        Some(meant) => failure.help(format!("did you mean `{meant}`?")),
        None => failure.help("`objdict show FILE` lists the objects"),
    }
}

/// The only entry of a VAR or DOMAIN.
fn single(object: &Object) -> Option<(u8, Cow<'_, Entry>)> {
    let is_single = !object.object_type().has_subs() && object.subs.is_empty();
    if is_single { object.entry(0).map(|entry| (0, entry)) } else { None }
}

fn no_object(view: &ShownDevice<'_>, index: u16) -> Failure {
    let objects = &view.device.objects;
    let below = objects.range(..index).next_back();
    let above = objects.range(index..).next();
    let near: Vec<String> = below
        .into_iter()
        .chain(above)
        .map(|(index, object)| format!("0x{index:04X} {}", fit(object.name(), 60)))
        .collect();
    let failure = Failure::new(format_args!("`{}` has no object 0x{index:04X}", view.file));
    if near.is_empty() { failure } else { failure.help(format!("nearest: {}", near.join(", "))) }
}

fn no_entry(index: u16, object: &Object, sub: u8) -> Failure {
    let subs: Vec<String> = object.entries().map(|(sub, _)| format!("{sub:X}")).take(32).collect();
    let name = fit(object.name(), 60);
    Failure::new(format_args!("0x{index:04X} {name} has no sub-index {sub:X} (hex)"))
        .help(format!("it has {}", subs.join(", ")))
}
