//! `objdict configure`.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;

use objdict_node::ObjectName;

use super::args::ConfigureArgs;
use super::ending::{Failure, Outcome, note, tell};
use super::input::{FileKind, Input, name_of, source_name};
use super::node::{commissioning, former_node_id};
use super::probe::answers;
use super::settings::{CommandSettings, SettingsArgs};
use super::stdout::Output;
use super::written_files::{keep, save, save_in_place};
use objdict_format as format;
use objdict_format::patch::Patch;
use objdict_format::{Description, Format, NodeSettings, Syntax, WriteOptions, stated_name};
use objdict_lint as lint;
use objdict_lint::Options;
use objdict_model::diagnostic::plural;
use objdict_model::diagnostic::{At, Diagnostic, Severity};
use objdict_model::model::{Assignment, Commissioning, Device, DeviceKind, Part};
use objdict_model::source::{MAX_TOML_SIZE, read_text};
use objdict_node::configure::{
    Configuration, Rebased, Setting, SettingProblem, SettingsFile, configuration, configure, rebase,
};
use objdict_node::coupler::flatten;
use objdict_node::download::transferred_type;
use objdict_node::parameter::{NoParameter, present_values};
use objdict_traffic::probe::{Exchange, SdoRequest};

pub(super) fn run(args: &ConfigureArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let of_config = SettingsArgs::from(&args.config);
    let mut config = CommandSettings::new(&of_config)?;
    let patches = config.patches_of(&args.file)?;
    if args.in_place {
        args.patch.none_with("`--in-place`")?;
    }
    let description = description(args, &patches)?;
    let file = settings_file(args)?;
    let own = description.device();
    if args.in_place && (own.kind != DeviceKind::Node || args.file == Path::new("-")) {
        let failure = Failure::new(format_args!(
            "`{}` is not a DCF or XDC, so it cannot be changed in place",
            name_of(&args.file)
        ));
        return Err(failure.help("name the file to write with `--output`"));
    }
    let plugged = if args.modules.is_empty() { None } else { Some(plugged(own, &args.modules)?) };
    let kind = Format::of(description.format().syntax(), DeviceKind::Node);
    other_syntax(args, kind)?;
    let wanted = wanted(args, &file);
    let (exchanges, answering) = match &args.answers {
        Some(path) => answers(&args.size, path, wanted.node_id.or(own.node_id()), Some(own))?,
        None => (Vec::new(), None),
    };
    let wanted = Commissioning { node_id: wanted.node_id.or(own.node_id()).or(answering), ..wanted };
    let node = commissioning(own, &wanted, kind.name())?;
    let mut base = Cow::Borrowed(plugged.as_ref().unwrap_or(own));
    let followers = if args.no_rebase { Vec::new() } else { followers(&base, &node) };
    if !followers.is_empty() {
        base.to_mut().assign(&followers);
    }
    let settings = settings(args, &file);
    let Configuration { values, downloads } =
        match configuration(&base, node.node_id.unwrap_or_default(), &settings) {
            Ok(configuration) => configuration,
            Err(problems) => return Ok(refuse(&problems)),
        };
    let mut present = present(&base, node.node_id.unwrap_or_default(), &exchanges);
    present.retain(|at| values.iter().all(|value| (value.index, value.sub) != (at.index, at.sub)));
    let assignments = [followers, present, values].concat();
    let file_name = file_name(args, kind);
    let parts = NodeSettings {
        node: &node,
        plugged: plugged.as_ref(),
        assignments: &assignments,
        downloads: &downloads,
    };
    let mut configured = description.configured(&file_name, &parts).map_err(Failure::new)?;
    let worse = worse(own, &configured.device, &options(args, &mut config, configured.device.node_id())?);
    if !worse.is_empty() && !args.force {
        let causes = Causes { args, settings: &settings, base: &base, node: &node };
        return Ok(refuse_findings(&worse, &causes));
    }
    if args.dialect.is_other() && kind == Format::Dcf {
        let options = WriteOptions { embed: true, ..args.dialect.options() };
        configured.bytes = format::write(&configured.device, Format::Dcf, &options)?.bytes;
        tell("note: the file is rewritten for the dialect, without comments\n");
    } else if !configured.is_edited {
        tell(
            "note: these settings do not fit into the existing text, so the file is rewritten without comments\n",
        );
    }
    match args.output() {
        Some(path) => {
            match args.in_place {
                true => save_in_place(path, &configured.bytes)?,
                false => save(path, &configured.bytes)?,
            };
            let count = plural(assignments.len(), "value");
            let also = |count: usize, what: &str| match count {
                0 => String::new(),
                count => format!(", {}", plural(count, what)),
            };
            let more = also(args.modules.len(), "module") + &also(downloads.len(), "download");
            let node_id = node.node_id.unwrap_or_default();
            out.summary(format_args!("{}: node {node_id}, {count}{more}", name_of(path)))?;
        }
        None => out.raw()?.write_all(&configured.bytes)?,
    }
    Ok(Outcome::Clean)
}

/// The values that a device has answered last, where they are not as described.
fn present(device: &Device, node_id: u8, exchanges: &[Exchange]) -> Vec<Assignment> {
    let mut last: BTreeMap<(u16, u8), Vec<u8>> = BTreeMap::new();
    for exchange in exchanges.iter().filter(|exchange| exchange.request == SdoRequest::Upload) {
        let data_type = transferred_type(device, exchange.index, exchange.sub);
        if let Some(bytes) = exchange.answer.bytes(data_type) {
            last.insert((exchange.index, exchange.sub), bytes);
        }
    }
    let (present, left_out) = present_values(device, node_id, last);
    tell_left_out(&left_out);
    present
}

/// Lists the entries that are no parameters, by reason.
pub(super) fn tell_left_out(left_out: &[((u16, u8), NoParameter)]) {
    for reason in [NoParameter::Command, NoParameter::ProcessData, NoParameter::Domain] {
        let of_reason = left_out.iter().filter(|(_, own)| *own == reason);
        let mut indexes: Vec<String> = of_reason.map(|((index, _), _)| format!("{index:04X}h")).collect();
        indexes.dedup();
        if !indexes.is_empty() {
            note(&format!("note: left out ({reason}): {}\n", indexes.join(", ")));
        }
    }
}

/// A file that would have another syntax than its name says.
fn other_syntax(args: &ConfigureArgs, written: Format) -> Result<(), Failure> {
    let Some(output) = args.output().filter(|_| !args.in_place) else { return Ok(()) };
    let ending = output.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let named = ending.as_deref().and_then(Format::from_name);
    if named.is_none_or(|format| format.syntax() == written.syntax()) {
        return Ok(());
    }
    let (what, help) = match written.syntax() {
        Syntax::Xml => {
            ("an XDD becomes an XDC", "name a file `.xdc`; `objdict convert --to dcf` converts it to DCF")
        }
        Syntax::Ini => {
            ("an EDS becomes a DCF", "name a file `.dcf`; `objdict convert --to xdc` converts it to XDC")
        }
        Syntax::Toml => (
            "a device.toml becomes one with `[node]`",
            "name a file `.toml`; `objdict convert --to dcf` converts it to DCF",
        ),
    };
    Err(Failure::new(format_args!("{what}, but `{}` has a different extension", name_of(output))).help(help))
}

/// The description that is configured; a device as JSON is one that is written as an EDS first.
fn description(args: &ConfigureArgs, patches: &[Arc<Patch>]) -> Result<Description, Failure> {
    let mut reading = args.reading();
    if !args.in_place {
        reading.patches.extend_from_slice(patches);
    }
    match reading.read_one(&source_name(&args.file), args.size.read(&args.file)?)? {
        (_, Input::Description(description)) => Ok(*description),
        (_, Input::Device(device)) => {
            let options = WriteOptions { embed: true, ..WriteOptions::default() };
            let kind = if device.kind == DeviceKind::Node { Format::Dcf } else { Format::Eds };
            let bytes = format::write(&device, kind, &options)?.bytes;
            let text = String::from_utf8_lossy(&bytes).into_owned();
            let source = objdict_model::source::SourceFile::from_text(source_name(&args.file), text);
            Ok(format::read(source, kind))
        }
        (kind, _) => {
            let message =
                format!("`{}` is a {}, which does not describe a device", name_of(&args.file), kind.name());
            Err(Failure::new(message).help("name the node's EDS"))
        }
    }
}

fn settings_file(args: &ConfigureArgs) -> Result<SettingsFile, Failure> {
    let Some(path) = args.settings() else { return Ok(SettingsFile::default()) };
    keep(path);
    let text = read_text(path, MAX_TOML_SIZE).map_err(Failure::new)?;
    let file = SettingsFile::parse(&text)
        .map_err(|error| Failure::new(format_args!("`{}`: {error}", name_of(path))))?;
    match file.node_id.filter(|node_id| !(1..=127).contains(node_id)) {
        Some(node_id) => {
            Err(Failure::new(format_args!("`{}`: `{node_id}` is not a valid node-ID", name_of(path)))
                .help("a node-ID is a number from 1 to 127"))
        }
        None => Ok(file),
    }
}

/// What is stated of the node.
fn wanted(args: &ConfigureArgs, file: &SettingsFile) -> Commissioning {
    Commissioning {
        node_id: args.node_id.or(file.node_id),
        baud_rate: args.bit_rate.or(file.baud_rate),
        node_name: args.name.clone().or_else(|| file.name.clone()),
        net_number: args.net_number.or(file.net_number),
        network_name: args.network_name.clone().or_else(|| file.network_name.clone()),
        manager: args.manager.or(file.manager),
        lss_serial_number: args.lss_serial_number.or(file.lss_serial_number),
        ..Commissioning::default()
    }
}

/// The CAN-IDs that follow the node-ID when it changes. All that do not are reported.
fn followers(device: &Device, node: &Commissioning) -> Vec<Assignment> {
    let Some(former) = former_node_id(device, node) else { return Vec::new() };
    let Rebased { assignments, kept } = rebase(device, former);
    if !assignments.is_empty() {
        let shown = assignments
            .iter()
            .map(|Assignment { index, sub, value }| format!("{index:04X}:{sub:X} = {value}"));
        let shown: Vec<String> = shown.collect();
        note(&format!("note: the node-ID was {former}, so these CAN-IDs follow it: {}\n", shown.join(", ")));
    }
    if !kept.is_empty() {
        let shown: Vec<String> =
            kept.iter().map(|(at, id)| format!("{} = {id}", ObjectName::Address(*at))).collect();
        note(&format!(
            "note: these CAN-IDs do not depend on the node-ID and are unchanged: {}\n",
            shown.join(", ")
        ));
    }
    assignments
}

/// What is wanted, in the order in which it is taken: a later one of the same entry counts.
fn settings(args: &ConfigureArgs, file: &SettingsFile) -> Vec<Setting> {
    let repeatable = [
        &args.set,
        &args.map,
        &args.cob_id,
        &args.transmission,
        &args.inhibit,
        &args.event_timer,
        &args.sync_start,
    ];
    let services = [&args.sync, &args.emcy, &args.time, &args.guard];
    let options = repeatable.into_iter().flatten().chain(services.into_iter().flatten());
    let rest = [&args.heartbeat_consumer, &args.sdo_before, &args.sdo];
    file.settings.iter().chain(options).chain(rest.into_iter().flatten()).cloned().collect()
}

fn plugged(device: &Device, modules: &[u16]) -> Result<Device, Failure> {
    flatten(device, modules).map_err(|problems| {
        let problems: Vec<String> = problems.iter().map(ToString::to_string).collect();
        Failure::of_lines(problems).help("`objdict modules` lists the modules")
    })
}

/// The name that the description states of itself.
fn file_name(args: &ConfigureArgs, kind: Format) -> String {
    let name = |path: &Path| path.file_name().map(|name| stated_name(&name.to_string_lossy()));
    let ending = FileKind::from(kind).ending();
    args.output().and_then(name).unwrap_or_else(|| {
        let stem = args.file.file_stem().filter(|_| args.file != Path::new("-")).unwrap_or_default();
        let stem = if stem.is_empty() { Cow::Borrowed("device") } else { stem.to_string_lossy() };
        stated_name(&format!("{stem}.{ending}"))
    })
}

/// How the node is checked: as `objdict check` checks the description that it is made of.
fn options(
    args: &ConfigureArgs,
    settings: &mut CommandSettings,
    node_id: Option<u8>,
) -> Result<Options, Failure> {
    let project = settings.project_of(&args.file)?;
    Ok(Options { node_id, ..settings.options(&args.file, project.as_deref()) })
}

/// What a check finds in the node and not in what it was made of: errors that the settings brought.
fn worse(before: &Device, after: &Device, options: &Options) -> Vec<Diagnostic> {
    let check = |device| options.severities.apply(lint::check(device, options));
    let old = check(before);
    let key = |finding: &Diagnostic| (finding.rule.id, finding.message.to_string());
    let old: std::collections::BTreeSet<_> = old.iter().map(key).collect();
    let found = check(after);
    let is_new = |finding: &&Diagnostic| finding.severity == Severity::Error && !old.contains(&key(finding));
    found.iter().filter(is_new).cloned().collect()
}

fn refuse(problems: &[SettingProblem]) -> Outcome {
    for problem in problems {
        let failure = Failure::new(problem);
        match &problem.help {
            Some(help) => failure.help(help.clone()).print(),
            None => failure.print(),
        }
    }
    tell(&format!("{} cannot be applied, so nothing is written\n", plural(problems.len(), "setting")));
    Outcome::Findings
}

fn refuse_findings(findings: &[Diagnostic], causes: &Causes<'_>) -> Outcome {
    for finding in findings {
        let message = format!("{}: {}", finding.rule.id, finding.message);
        let failure = Failure::new(match causes.of(finding) {
            Some(cause) => format!("`{cause}`: {message}"),
            None => message,
        });
        match &finding.help {
            Some(help) => failure.help(help.to_string()).print(),
            None => failure.print(),
        }
    }
    tell("the settings cause these errors, so nothing is written; `--force` writes the file anyway\n");
    Outcome::Findings
}

/// What may bring an error into a description.
struct Causes<'a> {
    args: &'a ConfigureArgs,
    settings: &'a [Setting],
    base: &'a Device,
    node: &'a Commissioning,
}

impl Causes<'_> {
    /// The setting of an object that the finding is about, else the option about the node.
    fn of(&self, finding: &Diagnostic) -> Option<String> {
        let places = finding.labels.iter().filter_map(|label| match &label.at {
            At::Place(place) => Some(place),
            At::Span(_) | At::Node(..) | At::Patch(..) => None,
        });
        let node_id = self.node.node_id?;
        let objects: Vec<u16> = places.clone().filter_map(|place| place.part.object()).collect();
        let sets = |setting: &&Setting| {
            let assignments =
                configure(self.base, node_id, std::slice::from_ref(*setting)).unwrap_or_default();
            assignments.iter().any(|assignment| objects.contains(&assignment.index))
        };
        // the last one of an entry counts
        if let Some(setting) = self.settings.iter().rev().find(sets) {
            return Some(setting.to_string());
        }
        let is_of_node = places.clone().any(|place| place.part == Part::Commissioning);
        match self.args.bit_rate.filter(|_| is_of_node) {
            Some(rate) => Some(format!("--bit-rate {rate}")),
            None => former_node_id(self.base, self.node).map(|_| format!("--node-id {node_id}")),
        }
    }
}
