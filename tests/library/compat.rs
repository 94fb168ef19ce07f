//! Findings about other tools: only where they are asked for, and of those alone that are asked about.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use objdict::compat::{Effect, MESSAGES, REACTIONS, Reaction};
use objdict::diagnostic::{Applicability, Diagnostic, Findings, Severity, Tool};
use objdict::format::{self, Format};
use objdict::lint::Options;
use objdict::registry;
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn check(path: &Path, tools: &[Tool]) -> Findings {
    let description = format::open(path, &SourceOptions::default()).unwrap();
    let mut options = Options::default();
    options.tools.extend(tools);
    objdict::check_with(&description, &options)
}

/// The bad fixtures of the group.
fn fixtures() -> Vec<PathBuf> {
    let folders = std::fs::read_dir(support::fixtures().join("rules/portability")).unwrap();
    let files = folders.flat_map(|folder| std::fs::read_dir(folder.unwrap().path()).unwrap());
    let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    files.retain(|path| path.file_name().unwrap().to_string_lossy().starts_with("bad"));
    files.sort();
    files
}

#[test]
fn the_table_is_of_rules_that_exist_and_has_all_rules_about_tools() {
    let all = || REACTIONS.iter().chain(MESSAGES);
    let causes: BTreeSet<&str> = all().map(|reaction| reaction.rule).collect();
    for cause in &causes {
        assert!(registry::rule(cause).is_some(), "there is no rule `{cause}`");
    }
    for rule in registry::rules().iter().filter(|rule| rule.group() == "portability") {
        let worst = all().filter(|reaction| reaction.rule == rule.id);
        let worst = worst.map(|reaction| reaction.effect.severity()).max();
        assert_eq!(worst, Some(rule.severity), "{}", rule.id);
    }
    for table in [REACTIONS, MESSAGES] {
        assert!(table.is_sorted_by_key(|reaction| reaction.rule), "the table is in the order of the rules");
    }
    assert!(all().all(|reaction| !reaction.tools.is_empty() && !reaction.what.is_empty()));
}

#[test]
fn nothing_is_said_of_tools_unless_they_are_asked_for() {
    for path in fixtures() {
        let findings = check(&path, &[]);
        assert!(findings.iter().all(|finding| finding.rule.group() != "portability"), "{}", path.display());
    }
}

#[test]
fn only_the_tools_of_the_selection_are_named() {
    for path in fixtures() {
        let mut named = 0;
        for tool in Tool::ALL {
            for finding in &check(&path, &[tool]) {
                let message = finding.message.shown();
                assert!(message.contains(tool.name()), "{}: {message}", path.display());
                let others = Tool::ALL.into_iter().filter(|other| *other != tool);
                for other in others {
                    let names = format!("{other}: ");
                    assert!(!message.contains(&names), "{}: {message}", path.display());
                }
                named += 1;
            }
        }
        assert!(named > 0, "{}", path.display());
    }
}

#[test]
fn a_finding_of_another_rule_says_what_tools_do_and_is_as_grave_as_that() {
    let path = support::fixtures().join("torture/05_unknown_key.eds");
    let plain = check(&path, &[]);
    assert!(plain.iter().all(|finding| finding.severity == Severity::Note));
    let findings = check(&path, &[Tool::DcfTools]);
    assert_eq!(findings.len(), plain.len());
    for finding in &findings {
        assert_eq!(finding.severity, Severity::Error);
        assert!(finding.help.as_ref().unwrap().shown().ends_with("; dcf-tools: the file is rejected"));
    }
    for finding in &check(&path, &[Tool::PythonCanopen]) {
        let help = finding.help.as_ref().unwrap().shown();
        // it reads units
        let is_lost = !finding.message.to_string().contains("`Unit`");
        assert_eq!(help.ends_with("; python-canopen: the key is lost"), is_lost, "{help}");
        assert!(!is_lost || finding.severity == Effect::Dropped.severity());
    }
    let silent = check(&path, &[Tool::Codesys]);
    assert_eq!(
        silent.iter().map(|f| &f.help).collect::<Vec<_>>(),
        plain.iter().map(|f| &f.help).collect::<Vec<_>>()
    );
}

#[test]
fn what_a_tool_does_may_depend_on_the_text() {
    let help = |file: &str| {
        let findings = check(&support::fixtures().join("torture").join(file), &[Tool::CanOpenEditor]);
        findings.iter().next().and_then(|finding| finding.help.clone()).unwrap_or_default().to_string()
    };
    assert!(help("02_latin1.eds").ends_with("canopeneditor: each such character becomes U+FFFD"));
    assert!(!help("03_bom.eds").contains("canopeneditor"));
}

/// node-canopen compares the limits as they are written.
#[test]
fn a_low_limit_that_is_read_as_positive_is_refused() {
    let text = std::fs::read_to_string(support::fixtures().join("eds/io-401.eds")).unwrap();
    let refused = |high: &str| {
        let limits = format!("[6411sub1]\r\nLowLimit=0x8000\r\nHighLimit={high}\r\n");
        let source = SourceFile::from_text("io-401.eds", text.replace("[6411sub1]\r\n", &limits));
        let options = Options { tools: vec![Tool::NodeCanopen], ..Options::default() };
        let findings = objdict::check_with(&format::read(source, Format::Eds), &options);
        findings.iter().any(|finding| finding.severity == Severity::Error)
    };
    assert!(refused("0x7FFF") && !refused("0xFFFF"));
}

#[test]
fn an_xdd_is_none_of_their_texts() {
    // CANopenNode is compiled with what an XDD says as well as with any other
    let readers = Tool::ALL.into_iter().filter(|tool| *tool != Tool::CanOpenNode).collect::<Vec<_>>();
    for path in support::files("xdd", &["xdd"]) {
        let findings = check(&path, &readers);
        let mut about_tools = findings.iter().filter(|finding| finding.rule.id != "cia306/disabled-object");
        assert!(about_tools.next().is_none(), "{}", path.display());
    }
}

#[test]
fn a_vendor_sees_the_severity_that_canchkeds_has() {
    let path = support::fixtures().join("rules/cia301/gap-in-mapping/bad.eds");
    assert!(check(&path, &[]).iter().all(|finding| finding.severity == Severity::Note));
    for finding in &check(&path, &[Tool::CanChkEds]) {
        assert_eq!(finding.severity, Severity::Error);
        assert!(finding.help.as_ref().unwrap().shown().ends_with("; canchkeds: error E11"));
    }
}

/// Each message is shown by a device of its rule.
#[test]
fn every_message_of_canchkeds_has_a_fixture() {
    let is_shown = |message: &&Reaction| {
        let folder = support::fixtures().join("rules").join(message.rule);
        let text = format!("canchkeds: {}", message.what);
        crate::rules::devices(&folder, "bad").iter().any(|path| {
            let findings = check(path, &[Tool::CanChkEds]);
            let is_it = |finding: &Diagnostic| {
                let texts = finding.help.iter().chain([&finding.message]);
                finding.rule.id == message.rule
                    && finding.severity >= message.effect.severity()
                    && texts.map(ToString::to_string).any(|shown| shown.ends_with(&text))
            };
            findings.iter().any(is_it)
        })
    };
    let missing: Vec<_> = MESSAGES.iter().filter(|message| !is_shown(message)).collect();
    let missing: Vec<_> = missing.iter().map(|message| (message.rule, message.what)).collect();
    assert!(missing.is_empty(), "{missing:#?}");
}

/// A fixture after the safe fixes for a tool.
fn fixed_for(tool: Tool, text: &str) -> String {
    let source = SourceFile::from_bytes("device.eds", text.into(), &SourceOptions::default()).unwrap();
    let options = Options { tools: vec![tool], ..Options::default() };
    let fixed = objdict::fix(format::read(source, Format::Eds), Applicability::Safe, |description| {
        objdict::check_with(description, &options)
    });
    String::from_utf8(fixed.bytes()).unwrap()
}

#[test]
fn fixes_are_those_that_the_tool_needs() {
    let read = |path: &str| std::fs::read_to_string(support::fixtures().join(path)).unwrap();
    let bits = read("rules/cia306/real-as-bits/bad.eds");
    assert_eq!(fixed_for(Tool::DcfTools, &bits), bits);
    assert!(fixed_for(Tool::PythonCanopen, &bits).contains("DefaultValue=1.5"));
    let decimal = read("rules/portability/real-as-decimal/bad.eds");
    let for_lely = fixed_for(Tool::DcfTools, &decimal);
    assert!(for_lely.contains("DefaultValue=0x3FC00000") && for_lely.contains("DefaultValue=0x40000000"));
    assert_eq!(fixed_for(Tool::PythonCanopen, &decimal), decimal);
    let device = read("eds/minimal.eds");
    let before_header = device.replacen("[DeviceInfo]", "50 [DeviceInfo]", 1);
    assert!(fixed_for(Tool::PythonCanopen, &before_header).contains("; 50\r\n[DeviceInfo]\r\n"));
    let vendor = format!("{device}[Tool Data]\r\nColour=red\r\n");
    assert!(fixed_for(Tool::DcfTools, &vendor).ends_with("; [Tool Data]\r\n; Colour=red\r\n"));
    let twice = device.replacen("[1001]", "[1000]\r\nParameterName=Other\r\n[1001]", 1);
    for tool in Tool::ALL {
        assert!(fixed_for(tool, &twice).contains("\n; [1000]\r\n; ParameterName=Other\r\n[1001]"));
    }
    let stray = format!("Stray=1\r\n{device}");
    assert_eq!(fixed_for(Tool::PythonCanopen, &stray), format!("; {stray}"));
    let unit = device.replacen("[1001]\r\n", "[1001]\r\nUnit=V\r\n", 1);
    assert!(fixed_for(Tool::DcfTools, &unit).contains("\n; Unit=V\r\n"));
    let compact = read("rules/cia306/unsupported-key/bad-compact.eds");
    assert!(fixed_for(Tool::NodeCanopen, &compact).contains("\n; CompactSubObj="));
    let start = device.find("[DeviceInfo]").unwrap();
    let without_info = fixed_for(Tool::CanOpenEditor, &device[start..]);
    assert!(without_info.contains("[FileInfo]\r\nEDSVersion=4.0\r\n"));
}

#[test]
fn what_a_lost_header_explains_is_left() {
    let device = std::fs::read_to_string(support::fixtures().join("eds/io-401.eds")).unwrap();
    for header in ["1008", "1003sub0", "1003sub2"] {
        for rest in ["", &format!("{header}]\r\n")] {
            let lost = device.replacen(&format!("[{header}]\r\n"), rest, 1);
            assert!(lost.len() < device.len());
            assert!(fixed_for(Tool::DcfTools, &lost) == lost, "{header}");
        }
    }
}

#[test]
fn canchkeds_does_not_check_configurations() {
    for path in support::files("dcf", &["dcf"]) {
        assert!(check(&path, &[Tool::CanChkEds]).is_empty(), "{}", path.display());
    }
}
