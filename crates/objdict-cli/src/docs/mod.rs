//! `objdict docs`.

mod network;

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

use serde_json::Value;

use self::network::DocumentedNetwork;
use super::args::DocsArgs;
use super::ending::{Failure, Outcome};
use super::files::{self, InputFile};
use super::input::{FileKind, Input, name_of, source_name};
use super::progress::Progress;
use super::settings::CommandSettings;
use super::stdout::Output;
use super::written_files::{SaveFolder, Saved, is_folder, is_stdout, save};
use objdict_document as document;
use objdict_document::{CodeName, Finding, Form, Identifiers, Options, Site, SiteFile, Subject};
use objdict_format::Description;
use objdict_format::identify::identify;
use objdict_generate as generate;
use objdict_lint as lint;
use objdict_model::Language;
use objdict_model::diagnostic::{Diagnostic, Findings, one_line};
use objdict_model::model::Device;
use objdict_model::source::SourceOptions;
use objdict_project::report::{Location, grouped};
use objdict_project::workspace::with_origin_beside;

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
        let names = generate::identifiers(&device).unwrap_or_default();
        let names = names.into_iter().map(|of| ((of.index, of.sub), CodeName { rust: of.rust, c: of.c }));
        let findings = findings.into_iter().map(|finding| finding.on_page_of(&device)).collect();
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

    /// The name of its page in a folder of its own.
    fn page_name(&self, form: Form) -> PathBuf {
        PathBuf::from(&self.file).with_extension(form.extension())
    }
}

pub(super) fn run(args: &DocsArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let form = form(args)?;
    let mut settings = CommandSettings::new(&args.settings)?;
    let (files, failures) = files::gather(&args.files, &mut settings)?;
    let mut outcome = Outcome::Clean;
    for failure in failures {
        failure.print();
        outcome = Outcome::Failed;
    }
    if let Some(failure) = settings.unusable().next() {
        return Err(failure);
    }
    let mut read = DocumentedFile::default();
    let has_pages = files.len() > 1 || !is_file(args);
    let progress = Progress::new("reading", files.len());
    for file in &files {
        if let Err(failure) = read.add(args, &settings, file, has_pages, &mut outcome) {
            failure.print();
            outcome = Outcome::Failed;
        }
        progress.step();
    }
    drop(progress);
    require_language(args, &read)?;
    let is_denied = args
        .settings
        .stated_deny()
        .is_some_and(|deny| read.findings().any(|finding| finding.severity >= deny));
    write(args, read, files.len(), form, out)?;
    Ok(match outcome {
        Outcome::Clean if is_denied => Outcome::Findings,
        outcome => outcome,
    })
}

/// Writes what was read of so many files: one page, or a site.
fn write(
    args: &DocsArgs,
    read: DocumentedFile,
    files: usize,
    form: Form,
    out: &mut Output,
) -> Result<(), Failure> {
    let (title, node_id, language) = (args.title.clone(), args.settings.node_id(), args.lang.clone());
    let options = Options { title, node_id, language, workbench: args.workbench.clone() };
    match (read.devices.as_slice(), read.networks.as_slice()) {
        ([], []) => Ok(()),
        ([one], []) if files == 1 => {
            let page = document::write(&one.subject(), form, &options);
            match is_folder(&args.output) {
                true => {
                    let mut folder = SaveFolder::open(&args.output, "docs", &args.overwrite)?;
                    save_page(args, &mut folder, &one.page_name(form).to_string_lossy(), &page, out)?;
                    folder.finish()
                }
                false => write_one(args, &page, out),
            }
        }
        ([], [_]) if files == 1 && is_file(args) => {
            if form == Form::Csv {
                let failure = Failure::new("the tables of a network do not fit into one file");
                return Err(failure.help("name a folder"));
            }
            let index = read.into_site(form, &options, |_| Ok(()))?.index();
            index.first().map_or(Ok(()), |index| write_one(args, &index.text, out))
        }
        _ => write_site(args, read, form, &options, out),
    }
}

/// Whether the output is one file, whatever is documented: the standard output, or a name with an extension.
fn is_file(args: &DocsArgs) -> bool {
    is_stdout(&args.output) || args.output.extension().is_some() && !is_folder(&args.output)
}

/// What is documented.
#[derive(Default)]
struct DocumentedFile {
    devices: Vec<Documented>,
    networks: Vec<DocumentedNetwork>,
}

impl DocumentedFile {
    /// Adds the devices or the network of a file; `has_pages` says whether the nodes of a network have pages.
    fn add(
        &mut self,
        args: &DocsArgs,
        settings: &CommandSettings,
        file: &InputFile,
        has_pages: bool,
        outcome: &mut Outcome,
    ) -> Result<(), Failure> {
        let bytes = args.input.size.read(&file.path)?;
        let name = source_name(&file.path);
        let is_network = match args.input.from {
            None => identify(&name, &bytes).kind.is_network(),
            Some(kind) => kind == FileKind::Cpj,
        };
        if is_network {
            self.networks.push(DocumentedNetwork::read(args, settings, file, has_pages, outcome)?);
        } else {
            let patches = file.project.as_ref().map(|project| &project.patches[..]).unwrap_or_default();
            let (kind, input) = args.input.reading_with(patches).read(&name, bytes)?;
            self.devices.extend(devices(args, settings, file, kind, input)?);
        }
        Ok(())
    }

    /// All devices, those of networks among them.
    fn all(&self) -> impl Iterator<Item = &Documented> {
        self.devices.iter().chain(self.networks.iter().flat_map(|network| network.nodes.iter().flatten()))
    }

    fn findings(&self) -> impl Iterator<Item = &Finding> {
        let of_networks = self.networks.iter().flat_map(|network| &network.findings);
        self.all().flat_map(|device| &device.findings).chain(of_networks)
    }

    /// The site; `write` is given each page.
    fn into_site(
        self,
        form: Form,
        options: &Options,
        mut write: impl FnMut(&SiteFile) -> Result<(), Failure>,
    ) -> Result<Site, Failure> {
        let mut site = Site::new(form, options);
        let mut add = |site: &mut Site, device: &Documented| {
            let page = site.add(&device.subject());
            write(&page).map(|()| page.name)
        };
        for device in &self.devices {
            add(&mut site, device)?;
        }
        for network in self.networks {
            let pages = network.nodes.iter();
            let pages = pages.map(|node| node.as_ref().map(|node| add(&mut site, node)).transpose());
            let pages = pages.collect::<Result<_, _>>()?;
            site.add_network(network.into_part(pages));
        }
        Ok(site)
    }
}

/// The language that was asked for is one that objdict writes in, or one that a description has texts in.
fn require_language(args: &DocsArgs, read: &DocumentedFile) -> Result<(), Failure> {
    let Some(asked) = args.lang.as_deref().filter(|tag| Language::of_tag(tag).is_none()) else {
        return Ok(());
    };
    let mut known: BTreeSet<String> = Language::ALL.map(|language| language.tag().to_owned()).into();
    for device in read.all() {
        collect_languages(&serde_json::to_value(&device.device).unwrap_or_default(), &mut known);
    }
    let primary = |tag: &str| tag.split(['-', '_']).next().unwrap_or_default().to_lowercase();
    if known.iter().any(|tag| primary(tag) == primary(asked)) {
        return Ok(());
    }
    let message = format!("`{asked}` is neither a language of objdict nor of the descriptions");
    let known: Vec<String> = known.iter().map(|tag| format!("`{tag}`")).collect();
    Err(Failure::new(message).help(format!("available languages: {}", known.join(", "))))
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
        return Ok(format);
    }
    match args.output.extension().filter(|_| !is_folder(&args.output)) {
        None => Ok(Form::Html),
        Some(ending) => Form::of_extension(&ending.to_string_lossy()).ok_or_else(|| {
            let message = format!("`{}` has no extension of a known format", name_of(&args.output));
            Failure::new(message).help("use `.html`, `.md` or `.csv`, or name the format with `--to`")
        }),
    }
}

/// The devices of a file; one of CANopenEditor may have several.
fn devices(
    args: &DocsArgs,
    settings: &CommandSettings,
    file: &InputFile,
    kind: FileKind,
    input: Input,
) -> Result<Vec<Documented>, Failure> {
    let options = settings.options(&file.path, file.project.as_deref());
    let name = file_name(&file.path);
    match input {
        Input::Description(description) if description.device_count() > 1 && args.input.device.is_none() => {
            let described = |description: &Description| {
                let name = format!("{name} [{}]", description.number() + 1);
                described(args, &options, name, description)
            };
            Ok(description.map_devices(described))
        }
        Input::Description(description) => {
            let description = args.input.selected(&file.path, *description)?;
            let options_of_files = SourceOptions { encoding: None, max_size: args.input.size.max_size };
            let description = with_origin_beside(&file.path, description, &options_of_files);
            Ok(vec![described(args, &options, name, &description)])
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

/// A description with its findings.
fn described(
    args: &DocsArgs,
    options: &lint::Options,
    file: String,
    description: &Description,
) -> Documented {
    let subject = description.into();
    let findings = grouped(subject, objdict_project::check_with(description, options));
    let findings = reported(&findings, |finding| Location::line_of(subject, finding));
    let device = args.expand.device(description.device()).into_owned();
    Documented::new(file, description.format().name(), device, findings)
}

/// The findings as pages show them; `line` gives the line of one.
fn reported(findings: &Findings, line: impl Fn(&Diagnostic) -> Option<u32>) -> Vec<Finding> {
    findings.iter().map(|finding| Finding::new(finding, line(finding))).collect()
}

fn file_name(path: &Path) -> String {
    let name = path.file_name().filter(|_| path != Path::new("-"));
    name.map_or_else(|| name_of(path), |name| one_line(&name.to_string_lossy()))
}

fn write_one(args: &DocsArgs, page: &str, out: &mut Output) -> Result<(), Failure> {
    if is_stdout(&args.output) {
        out.raw()?.write_all(page.as_bytes())?;
        return Ok(());
    }
    tell_saved(&args.output, page, save(&args.output, page.as_bytes())?, out)
}

fn save_page(
    args: &DocsArgs,
    folder: &mut SaveFolder,
    name: &str,
    page: &str,
    out: &mut Output,
) -> Result<(), Failure> {
    let saved = folder.save(name, page.as_bytes())?;
    tell_saved(&args.output.join(name), page, saved, out)
}

fn tell_saved(path: &Path, page: &str, saved: Saved, out: &mut Output) -> Result<(), Failure> {
    let unchanged = match saved {
        Saved::Written => "",
        Saved::Unchanged => ", unchanged",
    };
    Ok(out.summary(format_args!("{}: {} bytes{unchanged}", name_of(path), page.len()))?)
}

fn write_site(
    args: &DocsArgs,
    read: DocumentedFile,
    form: Form,
    options: &Options,
    out: &mut Output,
) -> Result<(), Failure> {
    if is_stdout(&args.output) {
        return Err(Failure::new("several pages cannot go to the standard output").help("name a folder"));
    }
    let mut folder = SaveFolder::open(&args.output, "docs", &args.overwrite)?;
    // it is written last, and each page as soon as it is made
    folder.admit(&format!("index.{}", form.extension()), &[])?;
    let progress = Progress::new("writing", read.all().count());
    let site = read.into_site(form, options, |page| {
        save_page(args, &mut folder, &page.name, &page.text, out)?;
        Ok(progress.step_with(out)?)
    })?;
    drop(progress);
    for file in site.index() {
        save_page(args, &mut folder, &file.name, &file.text, out)?;
    }
    folder.finish()
}
