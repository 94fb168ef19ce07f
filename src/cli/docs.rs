//! `objdict docs`.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::Path;

use serde_json::Value;

use super::args::DocsArgs;
use super::files::{self, File};
use super::input::{Input, name_of};
use super::output::Output;
use super::progress::Progress;
use super::save::{Saved, is_folder, is_stdout, save};
use super::settings::Settings;
use super::{Failure, Outcome};
use crate::diagnostic::{Diagnostic, Findings};
use crate::document::{self, CodeName, Finding, Form, Identifiers, Options, Site, Subject};
use crate::format::Description;
use crate::lint;
use crate::model::Device;
use crate::report::Location;
use crate::{Language, generate};

/// A device with all that its page needs.
struct Documented {
    /// The name of its file, without folders.
    file: String,
    format: &'static str,
    device: Device,
    findings: Vec<Finding>,
    identifiers: Identifiers,
}

impl Documented {
    fn new(file: String, format: &'static str, device: Device, findings: Vec<Finding>) -> Self {
        let names = generate::identifiers(&device, &generate::Options::default()).unwrap_or_default();
        let names = names.into_iter().map(|of| ((of.index, of.sub), CodeName { rust: of.rust, c: of.c }));
        Self { file, format, device, findings, identifiers: names.collect() }
    }

    fn subject(&self) -> Subject<'_> {
        Subject {
            device: &self.device,
            file: &self.file,
            format: self.format,
            findings: Some(&self.findings),
            identifiers: &self.identifiers,
        }
    }
}

pub(super) fn run(args: &DocsArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let form = form(args)?;
    let mut settings = Settings::new(&args.settings)?;
    let (files, failures) = files::gather(&args.files, &mut settings)?;
    let mut outcome = Outcome::Clean;
    for failure in failures {
        failure.print();
        outcome = Outcome::Failed;
    }
    for failure in settings.unusable() {
        failure.print();
        outcome = Outcome::Failed;
    }
    let mut devices = Vec::new();
    let progress = Progress::new("reading", files.len());
    for file in &files {
        match read(args, &settings, file) {
            Ok(read) => devices.extend(read),
            Err(failure) => {
                failure.print();
                outcome = Outcome::Failed;
            }
        }
        progress.step();
    }
    drop(progress);
    require_language(args, &devices)?;
    let options =
        Options { title: args.title.clone(), node_id: args.settings.node_id(), language: args.lang.clone() };
    let is_one = matches!((files.as_slice(), devices.as_slice()), ([_], [_])) && !is_folder(&args.output);
    match (is_one, devices.as_slice()) {
        (_, []) => {}
        (true, [one]) => write_one(args, &document::write(&one.subject(), form, &options), out)?,
        (_, devices) => write_site(args, devices, form, &options, out)?,
    }
    let is_denied = args.settings.stated_deny().is_some_and(|deny| {
        devices.iter().flat_map(|device| &device.findings).any(|finding| finding.severity >= deny)
    });
    Ok(match outcome {
        Outcome::Clean if is_denied => Outcome::Findings,
        outcome => outcome,
    })
}

/// The language that was asked for is one that objdict writes in, or one that a description has texts in.
fn require_language(args: &DocsArgs, devices: &[Documented]) -> Result<(), Failure> {
    let Some(asked) = args.lang.as_deref().filter(|tag| Language::of_tag(tag).is_none()) else {
        return Ok(());
    };
    let mut known: BTreeSet<String> = Language::ALL.map(|language| language.tag().to_owned()).into();
    for device in devices {
        collect_languages(&serde_json::to_value(&device.device).unwrap_or_default(), &mut known);
    }
    let primary = |tag: &str| tag.split(['-', '_']).next().unwrap_or_default().to_lowercase();
    if known.iter().any(|tag| primary(tag) == primary(asked)) {
        return Ok(());
    }
    let message = format!("`{asked}` is neither a language of objdict nor of the descriptions");
    let known: Vec<String> = known.iter().map(|tag| format!("`{tag}`")).collect();
    Err(Failure::new(message).help(format!("available are {}", known.join(", "))))
}

/// The languages of all texts of a device in JSON.
fn collect_languages(value: &Value, known: &mut BTreeSet<String>) {
    match value {
        Value::Object(fields) => {
            known.extend(fields.get("lang").and_then(Value::as_str).map(str::to_owned));
            fields.values().for_each(|value| collect_languages(value, known));
        }
        Value::Array(values) => values.iter().for_each(|value| collect_languages(value, known)),
        _ => {}
    }
}

fn form(args: &DocsArgs) -> Result<Form, Failure> {
    if let Some(format) = args.to {
        return Ok(format.into());
    }
    match args.output.extension().filter(|_| !is_folder(&args.output)) {
        None => Ok(Form::Html),
        Some(ending) => Form::of_extension(&ending.to_string_lossy()).ok_or_else(|| {
            let message = format!("`{}` has no extension of a known format", args.output.display());
            Failure::new(message).help("`.html`, `.md` and `.csv` are known; or name the format with `--to`")
        }),
    }
}

/// The devices of a file; a network file has several.
fn read(args: &DocsArgs, settings: &Settings<'_>, file: &File) -> Result<Vec<Documented>, Failure> {
    let options = settings.options(&file.path, file.project.as_deref());
    let (kind, input) = args.input.read(&file.path)?;
    let name = file_name(&file.path);
    let described = |file: String, description: &Description| {
        let findings = crate::check_with(description, &options);
        let subject = description.into();
        let findings = reported(&findings, |finding| Location::line_of(subject, finding));
        let device = args.expand.device(description.device()).into_owned();
        Documented::new(file, description.format().name(), device, findings)
    };
    match input {
        Input::Description(description) if description.device_count() > 1 && args.input.device.is_none() => {
            let mut next = Some(*description);
            let mut devices = Vec::new();
            while let Some(description) = next.take() {
                devices.push(described(format!("{name} [{}]", devices.len() + 1), &description));
                next = description.select(devices.len());
            }
            Ok(devices)
        }
        Input::Description(description) => {
            Ok(vec![described(name, &args.input.selected(&file.path, *description)?)])
        }
        Input::Device(device) => {
            let findings = options.severities.apply(lint::check(&device, &options));
            let device = args.expand.device(&device).into_owned();
            Ok(vec![Documented::new(name, "JSON", device, reported(&findings, |_| None))])
        }
        Input::NodeList(_) | Input::Concise(_) => {
            let message = format!(
                "`{}` is read as {} and does not describe a device",
                name_of(&file.path),
                kind.name()
            );
            Err(Failure::new(message).help("name the descriptions of the devices"))
        }
    }
}

/// The findings as pages show them; `line` gives the line of one.
fn reported(findings: &Findings, line: impl Fn(&Diagnostic) -> Option<u32>) -> Vec<Finding> {
    findings.iter().map(|finding| Finding::new(finding, line(finding))).collect()
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().filter(|_| path != Path::new("-"));
    name.map_or_else(|| name_of(path), |name| name.to_string_lossy().into_owned())
}

fn write_one(args: &DocsArgs, page: &str, out: &mut Output) -> Result<(), Failure> {
    if is_stdout(&args.output) {
        out.write_all(page.as_bytes())?;
        return Ok(());
    }
    tell_saved(&args.output, page, out)
}

fn tell_saved(path: &Path, page: &str, out: &mut Output) -> Result<(), Failure> {
    let unchanged = match save(path, page.as_bytes())? {
        Saved::Written => "",
        Saved::Unchanged => ", unchanged",
    };
    writeln!(out, "{}: {} bytes{unchanged}", path.display(), page.len())?;
    Ok(())
}

fn write_site(
    args: &DocsArgs,
    devices: &[Documented],
    form: Form,
    options: &Options,
    out: &mut Output,
) -> Result<(), Failure> {
    if is_stdout(&args.output) {
        return Err(Failure::new("several pages cannot go to the standard output").help("name a folder"));
    }
    let mut site = Site::new(form, options);
    let progress = Progress::new("writing", devices.len());
    for device in devices {
        let page = site.add(&device.subject());
        tell_saved(&args.output.join(page.name), &page.text, out)?;
        progress.step_with(out)?;
    }
    drop(progress);
    if devices.len() > 1 {
        let index = site.index();
        tell_saved(&args.output.join(index.name), &index.text, out)?;
    }
    Ok(())
}
