//! What is fuzzed: every reader, writer and transformer takes any bytes without a panic and keeps its promise about them. The
//! driver of this package and libFuzzer (`fuzz`) call the same functions.

#[path = "session.rs"]
mod session;

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::{Arc, LazyLock};

use objdict::bus::{Conditions, boot};
use objdict::compare::{DatumDifference, differences};
use objdict::config::Config;
use objdict::configure::{SettingsFile, configure};
use objdict::describe::frames::{FrameReader, RawFrame, Talker};
use objdict::diagnostic::{Applicability, Fix, Tool};
use objdict::document::dbc::{self, BusNode, DbcOptions};
use objdict::document::{self, Form};
use objdict::download::ConciseDcf;
use objdict::format::input::{Input, Reading};
use objdict::format::log::{LogOptions, LogReader, LogTime};
use objdict::format::network::{BootFiles, Installation, NetworkFile};
use objdict::format::patch::{self, Patch};
use objdict::format::{
    self, Description, Dialect, Format, NodeSettings, WriteOptions, canopeneditor, concise, json, nodelist,
};
use objdict::generate::{self, Target};
use objdict::lint::Options;
use objdict::model::{Commissioning, DeviceKind};
use objdict::network::{DcfgenMode, LelyOptions, Overview, compile, graph};
use objdict::profile::Profile;
use objdict::source::{SourceFile, SourceOptions};

/// A part of the library that takes foreign bytes, and the endings of the files that it is for.
pub(crate) struct Fuzzed {
    pub name: &'static str,
    pub endings: &'static [&'static str],
    run: fn(Format, &[u8]),
}

impl Fuzzed {
    /// Runs on a file with this ending.
    pub(crate) fn run(&self, ending: &str, bytes: &[u8]) {
        (self.run)(Format::from_name(ending).unwrap_or(Format::Eds), bytes);
    }

    /// Runs on an input of libFuzzer: a byte for the ending, and the file.
    pub(crate) fn run_input(&self, input: &[u8]) {
        let Some((first, bytes)) = input.split_first() else { return };
        self.run(self.ending(*first), bytes);
    }

    /// The ending that the first byte of an input stands for.
    pub(crate) fn ending(&self, first: u8) -> &'static str {
        self.endings[usize::from(first) % self.endings.len()]
    }
}

const DESCRIPTIONS: &[&str] = &["eds", "dcf", "xdd", "xdc"];

/// All of them.
pub(crate) const FUZZED: [Fuzzed; 19] = [
    Fuzzed { name: "check", endings: DESCRIPTIONS, run: check },
    Fuzzed { name: "fix", endings: DESCRIPTIONS, run: fix },
    Fuzzed { name: "fmt", endings: DESCRIPTIONS, run: arrange },
    Fuzzed { name: "convert", endings: DESCRIPTIONS, run: convert },
    Fuzzed { name: "configure", endings: DESCRIPTIONS, run: configured },
    Fuzzed { name: "patch", endings: DESCRIPTIONS, run: patched },
    Fuzzed { name: "generate", endings: DESCRIPTIONS, run: tables },
    Fuzzed { name: "docs", endings: DESCRIPTIONS, run: pages },
    Fuzzed { name: "dbc", endings: DESCRIPTIONS, run: messages },
    Fuzzed {
        name: "open",
        endings: &[
            "eds", "dcf", "xdd", "xdc", "nxdd", "xml", "json", "cdcf", "txt", "cpj", "gsd", "od", "bin",
        ],
        run: |_, bytes| any_file(bytes),
    },
    Fuzzed { name: "json", endings: &["json"], run: |_, bytes| json_of(bytes) },
    Fuzzed { name: "concise", endings: &["cdcf"], run: |_, bytes| stream(bytes) },
    Fuzzed { name: "text", endings: &["txt", "cpj"], run: |_, bytes| text(bytes) },
    Fuzzed { name: "toml", endings: &["toml"], run: |_, bytes| toml(bytes) },
    Fuzzed { name: "network", endings: &["toml", "yml", "cpj"], run: |_, bytes| network(bytes) },
    Fuzzed {
        name: "log",
        endings: &["log", "asc", "trc", "csv", "pcap", "pcapng"],
        run: |_, bytes| log(bytes),
    },
    Fuzzed { name: "device", endings: &["toml"], run: source_of_a_device },
    Fuzzed { name: "session", endings: &["eds", "dcf", "xdd", "xdc", "toml"], run: session::run },
    Fuzzed { name: "boot", endings: &["toml", "yml", "cpj"], run: |_, bytes| booted(bytes) },
];

/// All profiles and all tools.
static EVERYTHING: LazyLock<Options> = LazyLock::new(|| {
    let mut options = Options::default();
    options.profiles = objdict::profile::standard().cloned().map(Arc::new).collect();
    options.tools = Tool::ALL.to_vec();
    options
});

fn read(format: Format, bytes: &[u8]) -> Option<Description> {
    let source = SourceFile::from_bytes("fuzzed", bytes.to_vec(), &SourceOptions::default()).ok()?;
    Some(format::read(source, format))
}

/// Text that the reader of a format without a place for errors is for.
fn utf8(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap_or_default()
}

fn check(format: Format, bytes: &[u8]) {
    let Some(description) = read(format, bytes) else { return };
    assert_eq!(description.print(), bytes, "what is printed is what was read");
    for finding in &objdict::check_with(&description, &EVERYTHING) {
        let _ = (finding.message.to_string(), finding.help.as_ref().map(ToString::to_string));
        for label in &finding.labels {
            let span = description.span_of(&label.at);
            let quoted = description.source().text().get(span.start as usize..span.end as usize);
            assert!(quoted.is_some(), "{}: {span:?} is a part of the text", finding.rule.id);
        }
    }
}

fn fix(format: Format, bytes: &[u8]) {
    for safety in [Applicability::Safe, Applicability::Unsafe] {
        let Some(description) = read(format, bytes) else { return };
        let once = objdict::fix(description, safety, objdict::check);
        assert!(!once.is_unfinished, "fixes come to an end");
        let Some(before) = read(format, bytes) else { return };
        assert!(is_as_valid(&before, &once.description), "fixes do not violate CiA 311");
        let once = once.bytes();
        let Some(description) = read(format, &once) else { return };
        let twice = objdict::fix(description, safety, objdict::check);
        assert!(twice.bytes() == once, "the second fix changes nothing, not {:?}", twice.applied);
        let findings = objdict::check(&twice.description);
        let offers = objdict::with_sound_fixes(&twice.description, findings, objdict::check);
        let is_offer = |fix: &Fix| fix.is_offered && fix.safety <= safety;
        assert!(
            !offers.iter().filter_map(|finding| finding.fix.as_ref()).any(is_offer),
            "reports offer nothing"
        );
    }
}

/// Whether a text has no violation of a rule that another one does not have.
fn is_as_valid(before: &Description, after: &Description) -> bool {
    let rules = |description: &Description| -> BTreeSet<&str> {
        description.violations().iter().map(|found| found.rule.id).collect()
    };
    rules(after).is_subset(&rules(before))
}

fn arrange(format: Format, bytes: &[u8]) {
    let arranged = |bytes: &[u8]| read(format, bytes)?.arranged().ok();
    let Some(once) = arranged(bytes) else { return };
    assert!(arranged(&once).is_none_or(|twice| twice == once), "what is arranged stays as it is");
}

fn convert(format: Format, bytes: &[u8]) {
    let Some(device) = read(format, bytes).map(Description::into_device) else { return };
    let again = json::read_device(&json::write_device(&device));
    assert!(again.as_ref() == Ok(&device), "JSON gives back the device: {:?}", again.err());
    for to in [Format::Eds, Format::Dcf, Format::Xdd, Format::Xdc] {
        // each dialect by turns
        let mut options = WriteOptions::from(Dialect::ALL[bytes.len() % Dialect::ALL.len()]);
        options.embed = true;
        let written = format::write(&device, to, &options);
        assert!(written.is_ok(), "what is written is a valid {}: {:?}", to.name(), written.err());
        let Ok(written) = written else { return };
        let Some(description) = read(to, &written.bytes) else { continue };
        // an empty section of the node says nothing that could be lost
        let is_lost = |found: &&DatumDifference| found.left.as_ref().is_some_and(|left| left.text() != "{}");
        for found in differences(&device, description.device()).iter().filter(is_lost) {
            let is_named = written
                .losses
                .iter()
                .any(|loss| loss.path.starts_with(&found.path) || found.path.starts_with(&loss.path));
            assert!(is_named, "{} is lost in the {} and not reported", found.path, to.name());
        }
    }
}

fn configured(format: Format, bytes: &[u8]) {
    let Some(description) = read(format, bytes) else { return };
    // the text is settings too, which are mostly refused
    let file = SettingsFile::parse(utf8(bytes)).unwrap_or_default();
    let wanted = "[set]\n\"1017\" = 100\n[map]\ntpdo1 = [\"1001\"]\n";
    let settings = SettingsFile::parse(wanted).expect("these are settings").settings;
    let node = Commissioning { node_id: Some(5), baud_rate: Some(250), ..Commissioning::default() };
    for settings in [&file.settings[..], &settings, &settings[..settings.len().min(1)], &[]] {
        let Ok(assignments) = configure(description.device(), 5, settings) else { continue };
        let parts = NodeSettings { node: &node, plugged: None, assignments: &assignments, downloads: &[] };
        let Ok(configured) = description.configured("node.dcf", &parts) else { continue };
        let to = Format::of(format.syntax(), DeviceKind::Node);
        let Some(read) = read(to, &configured.bytes) else { continue };
        assert_eq!(read.device().node_id(), Some(5), "the file says what was configured");
        assert!(is_as_valid(&description, &read), "values do not violate CiA 311");
    }
}

fn tables(format: Format, bytes: &[u8]) {
    let Some(device) = read(format, bytes).map(Description::into_device) else { return };
    for target in Target::all() {
        let Ok(generated) = generate::generate(&device, target, &generate::Options::default()) else {
            continue;
        };
        for file in
            generated.files.iter().filter(|file| file.path.ends_with(".c") || file.path.ends_with(".h"))
        {
            assert!(is_balanced(utf8(&file.contents)), "{} of {}", file.path, target.name());
        }
    }
}

/// Whether strings, comments and brackets of a C file end where they should.
fn is_balanced(text: &str) -> bool {
    let mut open = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let mut length = c.len_utf8();
        match c {
            '/' if rest.starts_with("/*") => match rest[2..].find("*/") {
                Some(end) => length = end + 4,
                None => return false,
            },
            '/' if rest.starts_with("//") => length = rest.find('\n').unwrap_or(rest.len()),
            '"' | '\'' => match literal(rest, c) {
                Some(end) => length = end,
                None => return false,
            },
            '(' | '[' | '{' => open.push(c),
            ')' | ']' | '}' => {
                let expected = match c {
                    ')' => '(',
                    ']' => '[',
                    _ => '{',
                };
                if open.pop() != Some(expected) {
                    return false;
                }
            }
            _ => {}
        }
        rest = &rest[length..];
    }
    open.is_empty()
}

/// The length of a literal with its quotes, which ends in its line.
fn literal(text: &str, quote: char) -> Option<usize> {
    let mut is_escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            '\n' => return None,
            _ if is_escaped => is_escaped = false,
            '\\' => is_escaped = true,
            _ if c == quote => return Some(at + 1),
            _ => {}
        }
    }
    None
}

fn pages(format: Format, bytes: &[u8]) {
    let Some(description) = read(format, bytes) else { return };
    let identifiers = document::Identifiers::default();
    let subject = document::Subject {
        device: description.device(),
        file: "fuzzed",
        format: format.name(),
        findings: None,
        identifiers: &identifiers,
    };
    for form in Form::ALL {
        assert!(!document::write(&subject, form, &document::Options::default()).is_empty());
    }
}

fn messages(format: Format, bytes: &[u8]) {
    let Some(device) = read(format, bytes).map(Description::into_device) else { return };
    let nodes = [BusNode { device: &device, node_id: 5, name: None, is_counterpart: false }];
    for (sdo, bits) in [(false, false), (true, true)] {
        let text: String =
            dbc::write(&nodes, DbcOptions { sdo, bits }).bytes.into_iter().map(char::from).collect();
        assert!(text.matches('"').count().is_multiple_of(2), "texts have an end");
        let mut room = 0;
        for line in text.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            match words[..] {
                ["BO_", _, _, length, _] => room = 8 * length.parse::<u32>().unwrap_or_default(),
                ["SG_", ..] => {
                    let layout = words.iter().skip_while(|word| **word != ":").nth(1).unwrap_or(&"");
                    let numbers = layout.split_once('@').and_then(|(bits, _)| bits.split_once('|'));
                    let end = numbers.and_then(|(start, length)| {
                        start.parse::<u32>().ok()?.checked_add(length.parse().ok()?)
                    });
                    assert!(end.is_some_and(|end| end <= room), "`{line}` is inside its message");
                }
                _ => {}
            }
        }
    }
}

fn any_file(bytes: &[u8]) {
    match Reading::default().read("fuzzed", bytes.to_vec()) {
        Ok((_, Input::Description(description))) => {
            assert_eq!(description.print(), bytes, "what is printed is what was read");
        }
        Ok(_) => {}
        Err(error) => assert!(!error.to_string().is_empty() && error.help().as_deref() != Some("")),
    }
}

fn json_of(bytes: &[u8]) {
    if let Ok(device) = json::read_device(utf8(bytes)) {
        let again = json::read_device(&json::write_device(&device));
        assert!(again.as_ref() == Ok(&device), "JSON gives back the device: {:?}", again.err());
    }
    if let Ok(configuration) = json::read_configuration(utf8(bytes)) {
        let again = json::read_configuration(&json::write_configuration(&configuration));
        assert_eq!(again.as_ref(), Ok(&configuration), "JSON gives back the downloads");
    }
    if let Ok(device) = canopeneditor::read(utf8(bytes)) {
        let written = canopeneditor::write(&device, usize::MAX).expect("any number of losses");
        assert!(canopeneditor::read(utf8(&written.bytes)).is_ok(), "a project is read again");
    }
}

fn stream(bytes: &[u8]) {
    let Ok(configuration) = ConciseDcf::parse(bytes) else { return };
    let written = configuration.write().ok().and_then(|bytes| ConciseDcf::parse(&bytes).ok());
    assert_eq!(written.as_ref(), Some(&configuration), "a stream gives back the downloads");
    let text = concise::print(&configuration, |_| concise::Annotation::default());
    assert_eq!(concise::parse(&text, None).ok(), Some(configuration), "so does its text");
}

fn text(bytes: &[u8]) {
    if let Ok(configuration) = concise::parse(utf8(bytes), Some(5)) {
        let again = concise::print(&configuration, |_| concise::Annotation::default());
        assert_eq!(concise::parse(&again, None).ok(), Some(configuration), "a text gives back the downloads");
    }
    if let Ok(source) = SourceFile::from_bytes("fuzzed", bytes.to_vec(), &SourceOptions::default()) {
        let _ = nodelist::read(&source);
    }
}

fn toml(bytes: &[u8]) {
    let text = utf8(bytes);
    let _ = (Profile::from_toml(text), SettingsFile::parse(text), generate::renames(text));
    Config::read(SourceFile::from_text("objdict.toml", text), ".");
    let patch = Arc::new(Patch::read(SourceFile::from_text("fuzzed.patch.toml", text)));
    let patched = patch::apply(original(Format::Eds), &[patch]);
    let _ = (patched.patched().map(objdict::format::patch::Patched::lines), patched.realised());
}

/// A device.toml does all that a description does.
fn source_of_a_device(format: Format, bytes: &[u8]) {
    for part in [check, fix, convert, configured, tables, pages, messages] {
        part(format, bytes);
    }
}

/// A healthy device.
fn original(format: Format) -> Description {
    static BYTES: &[u8] = include_bytes!("../../../fixtures/eds/minimal.eds");
    read(format, BYTES).expect("it is a fixture")
}

/// The patch of a healthy device and another one makes the other one of it.
fn patched(format: Format, bytes: &[u8]) {
    let Some(edited) = read(format, bytes) else { return };
    let original = original(Format::Eds);
    let text = patch::make(original.device(), edited.device());
    let patch = Arc::new(Patch::read(SourceFile::from_text("fuzzed.patch.toml", text)));
    assert!(patch.findings().is_empty(), "what is made can be read: {:?}", patch.findings());
    let patched = patch::apply(original, &[patch]);
    let left = differences(patched.device(), edited.device());
    assert!(left.is_empty(), "the patch makes the device: {left:?}");
    if let Ok(Some(realised)) = patched.realised() {
        let _ = realised.print();
    }
}

/// A network file beside those of the fixtures.
fn network_file(bytes: &[u8]) -> NetworkFile {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/network");
    let text = String::from_utf8_lossy(bytes).replace("../../../network/", "");
    NetworkFile::read(SourceFile::from_text("fuzzed", text), &folder, &Default::default())
}

/// A network that can be built is switched on, and its run ends.
fn booted(bytes: &[u8]) {
    let file = network_file(bytes);
    let conditions = Conditions { limit: 5_000_000, frames: 5_000, ..Conditions::default() };
    for files in [BootFiles::Dcf, BootFiles::Lely] {
        let Ok(Installation { plant, .. }) = file.install(files) else { continue };
        let run = boot(&plant, &conditions);
        assert_eq!(run.is_booted(), boot(&plant, &conditions).is_booted(), "two runs are alike");
    }
}

/// Every frame of a log has words, and its time is read again as it is shown.
fn log(bytes: &[u8]) {
    let drive = original(Format::Eds);
    let talker = Talker { name: "drive", node_id: 5, device: drive.device(), is_counterpart: false };
    let mut frames = FrameReader::of_bus(vec![talker]);
    for frame in LogReader::new(bytes, LogOptions::default()) {
        let frame = frame.expect("memory can be read");
        let shown = frame.time.to_string();
        let again = shown.parse::<LogTime>().map(LogTime::nanoseconds);
        assert_eq!(again, Ok(frame.time.nanoseconds()), "{shown}");
        let raw = RawFrame {
            can_id: frame.can_id,
            is_extended: frame.is_extended,
            is_remote: frame.is_remote,
            data: frame.data(),
        };
        let decoded = frames.decode(&raw);
        assert!(frames.signals(&decoded, &raw).iter().all(|signal| signal.bits <= 64), "{raw:?}");
        frames.transferred(&decoded);
        assert!(!frames.words(&decoded, &raw).is_empty(), "{raw:?}");
    }
}

/// A network of the descriptions in `fixtures/network`, with all that is made of it.
fn network(bytes: &[u8]) {
    let file = network_file(bytes);
    let findings = file.check();
    let Some(network) = file.network() else {
        assert!(!findings.is_empty(), "what is no network has a finding");
        return;
    };
    for mode in [DcfgenMode::Corrected, DcfgenMode::Exact] {
        let compiled = compile(network, mode);
        let overview = Overview::new(network, &compiled);
        let _ = (graph::svg(&overview, |can_id| can_id.to_string()), graph::dot(&overview));
        let Ok(build) = file.build(mode) else { continue };
        let _ = (build.lely(&LelyOptions { mode, remote_pdos: true }), build.concise(), build.dcfs());
        let _ = (build.manager_device(), build.node_list(), build.bus_yml());
    }
}
