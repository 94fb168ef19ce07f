//! Every rule has a page, a row in a file of its group, and fixtures that prove it.
//!
//! `fixtures/rules/<group>/<rule>/` holds `bad*` devices, in which the rule finds something and no other rule does, and
//! `good*` devices that come as near as they can without being wrong, in which nothing is found. What is found in a bad
//! one is a snapshot, for the words of a finding and its place are what the user gets.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use objdict::compat::{MESSAGES, REACTIONS, Reaction};
use objdict::config::Config;
use objdict::diagnostic::{Applicability, At, Diagnostic, Findings, FixSafety, Severity, Tool};
use objdict::format::network::NetworkFile;
use objdict::format::patch::{self, Patch};
use objdict::format::{self, Description, Format};
use objdict::lint::{self, Options};
use objdict::profile::Profile;
use objdict::registry;
use objdict::report::Subject;
use objdict::source::{SourceFile, SourceOptions, Span};
use objdict_xdd::xml::Tree;

use crate::support;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn sorted(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

pub(crate) fn name(path: &Path) -> &str {
    path.file_name().unwrap().to_str().unwrap()
}

/// The folders `fixtures/rules/<group>/<rule>` with the rule's id.
pub(crate) fn rule_folders() -> Vec<(String, PathBuf)> {
    let groups = sorted(&support::fixtures().join("rules"));
    let groups = groups.iter().filter(|path| path.is_dir());
    let folders = groups.flat_map(|group| {
        sorted(group).into_iter().map(move |folder| (format!("{}/{}", name(group), name(&folder)), folder))
    });
    folders.collect()
}

const ENDINGS: [&str; 9] = ["eds", "dcf", "xdd", "xdc", "od", "xml", "toml", "yml", "cpj"];

/// The devices and configurations of a folder whose name starts with `prefix`.
pub(crate) fn devices(folder: &Path, prefix: &str) -> Vec<PathBuf> {
    let is_device = |path: &PathBuf| {
        name(path).starts_with(prefix) && ENDINGS.contains(&path.extension().unwrap().to_str().unwrap())
    };
    sorted(folder).into_iter().filter(is_device).collect()
}

pub(crate) fn open(path: &Path) -> Description {
    format::open(path, &SourceOptions::default())
        .unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A configuration with the valid description of its type.
pub(crate) fn with_origin(description: Description) -> Description {
    let eds = description.device().file_info.as_ref().and_then(|info| info.last_eds.clone()).unwrap();
    description.with_origin(open(&support::fixtures().join("eds").join(eds)))
}

/// What a fixture is checked with: the profile beside it, and the tools that its rule is about.
pub(crate) fn options(path: &Path) -> Options {
    let mut options = Options::default();
    if let Ok(text) = fs::read_to_string(path.with_file_name("profile.toml")) {
        options.profiles.push(Arc::new(Profile::from_toml(&text).unwrap()));
    }
    if path.starts_with(support::fixtures().join("rules/portability")) {
        let rule = path.parent().map(|folder| format!("portability/{}", name(folder))).unwrap();
        let of_rule = |reaction: &&Reaction| reaction.rule == rule;
        options.tools.extend(REACTIONS.iter().filter(of_rule).flat_map(|reaction| reaction.tools));
        // CANchkEDS only where no other tool minds: it reports more than the fixture is about
        if options.tools.is_empty() {
            options.tools.extend(MESSAGES.iter().filter(of_rule).flat_map(|reaction| reaction.tools));
        }
    }
    options
}

/// A file with what is found in it.
enum Examined {
    Description(Box<Description>, Findings),
    /// A file that is malformed as XML or in its structure: the defect itself, without its consequences.
    Tree(Box<Tree>, Findings),
    /// A configuration.
    Config(Box<Config>),
    Network(Box<NetworkFile>, Findings),
    /// A patch, with what is found when it is made in a fixture.
    Patch(Box<Patch>, Findings),
}

impl Examined {
    fn new(path: &Path) -> Self {
        let is_of = |group: &str| path.starts_with(support::fixtures().join("rules").join(group));
        if (is_of("network") || is_of("keys")) && NetworkFile::is_network(path).unwrap() {
            let file = NetworkFile::open(path, &Default::default()).unwrap();
            let findings = file.check();
            return Self::Network(Box::new(file), findings);
        }
        if is_of("patch") {
            let patch = Arc::new(Patch::open(path).unwrap());
            let text = fs::read(support::fixtures().join("eds/io-401.eds")).unwrap();
            // messages name the file
            let source = SourceFile::from_bytes("io-401.eds", text, &SourceOptions::default()).unwrap();
            let description = patch::apply(format::read(source, Format::Eds), &[patch]);
            let findings = description.patched().unwrap().findings[0].clone();
            return Self::Patch(Box::new(Patch::open(path).unwrap()), findings);
        }
        if path.extension().is_some_and(|ending| ending == "toml") && !is_of("keys") {
            return Self::Config(Box::new(Config::open(path).unwrap()));
        }
        let is_damaged = is_of("xml") || (is_of("cia311") && name(path).starts_with("bad"));
        if is_of("configuration") {
            let description = with_origin(open(path));
            let findings = objdict::check_with(&description, &options(path));
            return Self::Description(Box::new(description), findings);
        }
        if !is_damaged {
            let description = open(path);
            let findings = objdict::check_with(&description, &options(path));
            return Self::Description(Box::new(description), findings);
        }
        let source = SourceFile::open(path, &SourceOptions::default()).unwrap();
        let mut findings = Findings::new();
        let tree = Tree::new(source, &mut findings);
        if is_of("cia311") {
            findings.append(format::check_structure(&tree));
            // a rule about the device that the structure describes
            if findings.is_empty() {
                let description = open(path);
                let findings = objdict::check_with(&description, &options(path));
                return Self::Description(Box::new(description), findings);
            }
        }
        Self::Tree(Box::new(tree), findings)
    }

    fn findings(&self) -> &Findings {
        match self {
            Self::Description(_, findings) | Self::Tree(_, findings) => findings,
            Self::Config(config) => config.findings(),
            Self::Network(_, findings) | Self::Patch(_, findings) => findings,
        }
    }

    fn source(&self) -> &SourceFile {
        match self {
            Self::Description(description, _) => description.source(),
            Self::Tree(tree, _) => tree.source(),
            Self::Config(config) => config.source(),
            Self::Network(network, _) => &network.source,
            Self::Patch(patch, _) => patch.source(),
        }
    }

    /// The file that a label is in, and where.
    fn resolve(&self, at: &At) -> (&SourceFile, Span) {
        match (self, at) {
            (Self::Description(description, _), at) => {
                let subject = Subject::Description(description);
                (subject.of_label(at).source(), subject.span_of(at))
            }
            (Self::Network(network, _), At::Node(..)) => {
                let subject = Subject::Network(network);
                (subject.of_label(at).source(), subject.span_of(at))
            }
            (_, At::Span(span)) => (self.source(), *span),
            (_, At::Patch(..)) => panic!("no description is patched here"),
            (_, At::Place(place) | At::Node(_, place)) => panic!("there is no place {place}"),
        }
    }
}

/// All findings in a file, a block of lines each: place, severity, rule, message; what the place shows; related places;
/// advice.
fn report(path: &Path) -> String {
    let examined = Examined::new(path);
    let mut report = String::new();
    for finding in examined.findings() {
        report_finding(&examined, finding, &mut report);
    }
    report
}

fn report_finding(examined: &Examined, finding: &Diagnostic, report: &mut String) {
    for (number, label) in finding.labels.iter().enumerate() {
        let (source, span) = examined.resolve(&label.at);
        let at = source.line_column(span.start);
        let shown: String = span.of(source.text()).chars().take(60).collect();
        if number == 0 {
            let (severity, rule, message) = (finding.severity, finding.rule.id, &finding.message);
            writeln!(report, "{}:{} {severity} {rule}: {message}", at.line, at.column).unwrap();
            writeln!(report, "  at {shown:?}").unwrap();
        } else {
            let file = match source.name() == examined.source().name() {
                true => String::new(),
                false => format!("{}:", name(source.name().as_ref())),
            };
            writeln!(report, "  {file}{}:{} {shown:?} {}", at.line, at.column, label.text).unwrap();
        }
    }
    if let Some(help) = &finding.help {
        writeln!(report, "  help: {help}").unwrap();
    }
}

/// The ids of the rules that a report of a file shows: what another finding explains is not among them.
fn fired(path: &Path) -> BTreeSet<&'static str> {
    let findings = match Examined::new(path) {
        Examined::Description(description, findings) => objdict::report::grouped(&*description, findings),
        examined => examined.findings().clone(),
    };
    findings.iter().map(|finding| finding.rule.id).collect()
}

fn assert_clean(path: &Path) {
    if path.ends_with("fixtures/eds/hostile.eds") {
        // its names are there to be hard on generators
        let others: Vec<&str> = fired(path).into_iter().filter(|id| !id.starts_with("naming/")).collect();
        assert!(others.is_empty(), "{}: {others:?}", path.display());
        return;
    }
    if path.ends_with("fixtures/xdd/press-402.xdd") {
        // one of its objects is disabled
        assert_eq!(fired(path), BTreeSet::from(["cia306/disabled-object"]));
        return;
    }
    let report = report(path);
    assert!(report.is_empty(), "{} is healthy, but:\n{report}", path.display());
}

#[test]
fn every_rule_has_fixtures_and_every_fixture_a_rule() {
    let folders = rule_folders();
    for (id, folder) in &folders {
        assert!(registry::rule(id).is_some(), "{}: there is no rule `{id}`", folder.display());
        for prefix in ["bad", "good"] {
            assert!(!devices(folder, prefix).is_empty(), "{id} has no `{prefix}` fixture");
        }
        for file in sorted(folder) {
            let known = ["bad", "good", "profile.toml"].iter().any(|prefix| name(&file).starts_with(prefix));
            assert!(known, "{}: no test reads it", file.display());
        }
    }
    let folders: BTreeSet<&str> = folders.iter().map(|(id, _)| id.as_str()).collect();
    // a change is between two devices: `changes.rs` makes it in a valid one; `probe` makes answers, `traffic` logs
    for rule in
        registry::rules().iter().filter(|rule| !["change", "probe", "traffic"].contains(&rule.group()))
    {
        assert!(folders.contains(rule.id), "`{}` has no folder in fixtures/rules", rule.id);
    }
}

#[test]
fn every_rule_file_is_registered() {
    let mut rules = 0;
    for group in sorted(&root().join("crates/objdict-lint/src/rules")).iter().filter(|path| path.is_dir()) {
        for file in sorted(group) {
            for id in rows(&file) {
                assert!(registry::rule(&id).is_some(), "{}: `{id}` is no registered rule", file.display());
                assert!(id.starts_with(&format!("{}/", name(group))), "{}: `{id}`", file.display());
                rules += 1;
            }
        }
    }
    assert_eq!(rules, lint::rules().count());
}

/// The ids of a table of rules.
fn rows(table: &Path) -> Vec<String> {
    let text = fs::read_to_string(table).unwrap();
    let texts = text.lines().filter_map(|line| line.strip_prefix("    \"")?.split('"').next());
    texts.filter(|text| text.contains('/')).map(str::to_owned).collect()
}

#[test]
fn ids_are_unique_and_in_kebab_case() {
    let mut seen = BTreeSet::new();
    for rule in registry::rules() {
        assert!(seen.insert(rule.id), "`{}` is there twice", rule.id);
        let is_kebab = rule.name().split('-').all(|word| {
            !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
        });
        assert!(is_kebab && !rule.group().is_empty(), "`{}` is not of the form group/kebab-case", rule.id);
    }
}

#[test]
fn every_rule_has_a_page() {
    for rule in registry::rules() {
        let (id, summary) = (rule.id, rule.summary);
        assert!(!summary.ends_with('.') && !summary.starts_with(char::is_uppercase), "{id}: `{summary}`");
        // a change affects several audiences, each in a row of a table
        let is_table =
            |text: &str| rule.group() == "change" && text == rule.why && text.starts_with("| For ");
        for text in [summary, rule.checks, rule.why, rule.example, rule.remedy, rule.source] {
            let is_line = !text.contains('\n') || is_table(text);
            assert!(!text.is_empty() && is_line && text == text.trim(), "{id}: `{text}`");
        }
    }
}

#[test]
fn a_bad_fixture_shows_its_rule_and_no_other() {
    for (id, folder) in rule_folders() {
        for path in devices(&folder, "bad") {
            let fired: Vec<&str> = fired(&path).into_iter().collect();
            assert_eq!(fired, [id.as_str()], "{}:\n{}", path.display(), report(&path));
        }
    }
}

/// Shares of a corpus are shown for the rules that a description alone can raise: each of these has a fixture that does, and no
/// other rule has one.
#[test]
fn groups_say_what_their_rules_need() {
    let options = Options { tools: Tool::ALL.to_vec(), ..Options::default() };
    let is_raised = |id: &str, path: &PathBuf| {
        let format = Format::from_name(name(path)).filter(|format| *format != Format::Toml);
        format.is_some()
            && objdict::check_with(&open(path), &options).iter().any(|finding| finding.rule.id == id)
    };
    for (id, folder) in rule_folders() {
        let group = registry::rule(&id).unwrap().group();
        let needs = registry::GROUPS.iter().find(|known| known.name == group).unwrap().needs;
        let raised: Vec<_> =
            devices(&folder, "bad").into_iter().filter(|path| is_raised(&id, path)).collect();
        // comments and data for objdict are in descriptions, though not in those of others
        if group != "objdict" {
            assert_eq!(raised.is_empty(), needs.is_some(), "{id} needs {needs:?}: {raised:?}");
        }
    }
}

#[test]
fn every_finding_has_a_help() {
    let without = |path: &PathBuf| {
        let examined = Examined::new(path);
        let helpless = examined.findings().iter().filter(|finding| finding.help.is_none());
        helpless.map(|finding| format!("{}: {}", path.display(), finding.message)).collect::<Vec<_>>()
    };
    let bad = rule_folders().into_iter().flat_map(|(_, folder)| devices(&folder, "bad"));
    let found: Vec<String> = bad.flat_map(|path| without(&path)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// A network runs those rules about the model for its nodes whose severity is error.
#[test]
fn errors_of_nodes_are_found_by_rules_that_are_errors() {
    // what no network changes: lists, and `CompactSubObj` of a VAR
    const OF_TEXT: [&str; 2] = ["cia306/wrong-object-list", "cia306/unsupported-key"];
    let errors_of_others = |path: PathBuf| -> Vec<String> {
        let examined = Examined::new(&path);
        let of_model = |found: &&Diagnostic| matches!(found.labels.first(), Some(label) if matches!(label.at, At::Place(_)));
        let errors = examined.findings().iter().filter(of_model).filter(|found| {
            let rule = found.rule;
            let is_of_device = rule.id.starts_with("cia") && !OF_TEXT.contains(&rule.id);
            is_of_device && found.severity == Severity::Error && rule.severity < Severity::Error
        });
        errors.map(|finding| format!("{}: {}", path.display(), finding.message)).collect()
    };
    let bad = rule_folders().into_iter().flat_map(|(_, folder)| devices(&folder, "bad"));
    let found: Vec<String> = bad.flat_map(errors_of_others).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn a_valid_configuration_is_clean_beside_the_description_of_its_type() {
    for path in devices(&support::fixtures().join("dcf"), "") {
        let findings = objdict::check(&with_origin(open(&path)));
        let messages = findings.iter().map(|finding| finding.message.to_string()).collect::<Vec<_>>();
        assert!(messages.is_empty(), "{}: {messages:#?}", path.display());
    }
}

#[test]
fn a_good_fixture_is_clean() {
    for (_, folder) in rule_folders() {
        for path in devices(&folder, "good") {
            assert_clean(&path);
        }
    }
}

/// The declared safety is that of the fixes which the findings of all fixtures offer.
#[test]
fn a_rule_offers_the_fixes_that_it_declares() {
    let mut offered: BTreeMap<&str, BTreeSet<Applicability>> = BTreeMap::new();
    let mut offer = |description: &Description, findings: &Findings| {
        for finding in findings {
            if let Some(fix) = finding.fix.as_ref().filter(|fix| description.can_fix(fix)) {
                offered.entry(finding.rule.id).or_default().insert(fix.safety);
            }
        }
    };
    for (id, folder) in rule_folders() {
        let tools = REACTIONS.iter().filter(|row| row.rule == id).flat_map(|row| row.tools);
        let tools: BTreeSet<&str> = tools.map(|tool| tool.name()).collect();
        for path in devices(&folder, "bad") {
            let (description, findings) = match Examined::new(&path) {
                Examined::Description(description, findings) => (*description, findings),
                Examined::Tree(_, findings) => (open(&path), findings),
                Examined::Config(_) | Examined::Network(..) | Examined::Patch(..) => continue,
            };
            offer(&description, &findings);
            // what is a fix for one of the tools
            for tool in tools.iter().filter_map(|name| Tool::named(name)) {
                let options = Options { tools: vec![tool], ..Options::default() };
                offer(&description, &objdict::check_with(&description, &options));
            }
        }
    }
    for path in ["broken", "torture"].iter().flat_map(|folder| devices(&support::fixtures().join(folder), ""))
    {
        let description = open(&path);
        offer(&description, &objdict::check(&description));
    }
    // characters that ISO 8859-1 does not have cannot be written without the mark
    let text = fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let text = format!("\u{feff}; für Ω\n{text}");
    let source = SourceFile::from_bytes("minimal.eds", text.into_bytes(), &SourceOptions::default()).unwrap();
    let description = format::read(source, Format::Eds);
    offer(&description, &objdict::check(&description));
    let mut wrong = Vec::new();
    for rule in registry::rules() {
        let safeties = offered.get(rule.id).map(|safeties| safeties.iter().copied().collect::<Vec<_>>());
        let shown = safeties.map(|safeties| match safeties[..] {
            [Applicability::Safe] => FixSafety::Safe,
            [Applicability::Unsafe] => FixSafety::Unsafe,
            _ => FixSafety::Mixed,
        });
        if rule.fix != shown {
            wrong.push(format!("{}: declared {:?}, offered {shown:?}", rule.id, rule.fix));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(offered.len() >= 60, "{} rules have fixes", offered.len());
}

/// What a device lacks whose structure lacks it.
const COMPANIONS: [&str; 2] = ["cia301/missing-mandatory-object", "cia306/no-baud-rate"];

#[test]
fn what_the_structure_shows_is_not_said_of_the_model_again() {
    let folders = rule_folders().into_iter().filter(|(id, _)| id.starts_with("cia311/"));
    for path in folders.flat_map(|(_, folder)| devices(&folder, "bad")) {
        let description = open(&path);
        let findings = objdict::check(&description);
        for finding in &findings {
            let rule = finding.rule;
            let is_expected = rule.group() == "cia311" || COMPANIONS.contains(&rule.id);
            assert!(is_expected, "{}: {}: {}", path.display(), rule.id, finding.message);
        }
    }
}

#[test]
fn the_healthy_devices_are_clean() {
    let mut files = 0;
    for folder in ["fixtures/eds", "fixtures/dcf", "fixtures/xdd"] {
        for path in devices(&root().join(folder), "") {
            assert_clean(&path);
            files += 1;
        }
    }
    assert!(files > 0);
}

#[test]
fn findings_say_what_is_wrong_where() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("snapshots/rules");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for (id, folder) in rule_folders() {
        let reports =
            devices(&folder, "bad").into_iter().map(|path| format!("{}\n{}", name(&path), report(&path)));
        let reports: Vec<String> = reports.collect();
        settings.bind(|| insta::assert_snapshot!(id.replace('/', "__"), reports.join("\n")));
    }
    for snapshot in sorted(&root().join("tests/library/snapshots/rules")) {
        let id = snapshot.file_stem().unwrap().to_str().unwrap().replace("__", "/");
        assert!(registry::rule(&id).is_some(), "{}: there is no rule `{id}`", snapshot.display());
    }
}
