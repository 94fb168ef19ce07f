//! `objdict conformance`.

use std::io::{self, Write};

use serde::Serialize;

use super::args::{ChecksFormat, ConformanceArgs};
use super::ending::{Failure, Outcome};
use super::input::{Input, name_of, source_name};
use super::settings::ConfigFileArgs;
use super::stdout::Output;
use super::table::TextTable;
use objdict_bus::{CheckEffect, Conformance, ConformanceCheck, Verdict, conformance_of};
use objdict_document::TablePage;
use objdict_model::json::Version;
use objdict_model::model::Device;
use objdict_project::report::{TestCase, TestResult, junit_suite};

/// The most characters of a cell.
const CELL: usize = 80;

const HEADINGS: [&str; 4] = ["Service", "Check", "Section", "Result"];

/// The node-ID of a description that does not say one.
const NODE_ID: u8 = 1;

pub(super) fn run(args: &ConformanceArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let (_, input) = args.input.read_node(&args.file, &ConfigFileArgs::default())?;
    let device: &Device = match &input {
        Input::Description(description) => description.device(),
        Input::Device(device) => device,
        _ => return Err(Failure::new(format_args!("`{}` does not describe a device", name_of(&args.file)))),
    };
    let node_id = args.node_id.or_else(|| device.node_id()).unwrap_or(NODE_ID);
    let (tested, heading, results) = tested(args, device, node_id)?;
    let (file, is_clean) = (source_name(&args.file), results.is_clean());
    match args.format {
        ChecksFormat::Table => text(&heading, &results, args.summary, out)?,
        ChecksFormat::Json => write_json(&file, tested, node_id, &results, out)?,
        ChecksFormat::Junit => {
            let tests: Vec<TestCase<'_>> = results.checks.iter().map(test_case).collect();
            out.raw()?.write_all(junit_suite(&format!("{file}: {heading}"), &tests).as_bytes())?;
        }
        ChecksFormat::Html => {
            let rows = results.checks.iter().map(|check| (cells(check).to_vec(), is_failed(check))).collect();
            let summary = format!("{heading}: {}", verdict(&results));
            let page = TablePage { file: &file, heading: &file, summary, headings: &HEADINGS, rows };
            out.raw()?.write_all(page.html().as_bytes())?;
        }
    }
    Ok(if is_clean { Outcome::Clean } else { Outcome::Findings })
}

/// The test object, as in JSON and as the heading, with the results.
fn tested(
    args: &ConformanceArgs,
    device: &Device,
    node_id: u8,
) -> Result<(&'static str, String, Conformance), Failure> {
    #[cfg(feature = "bus")]
    if args.bus.bus.is_some() {
        let groups = objdict_bus::RemoteGroups { writes: args.write, commands: args.nmt };
        if args.dry_run {
            let plan = objdict_bus::conformance_plan(device, node_id, groups);
            return Ok(("device", format!("plan for node {node_id}; nothing is sent"), plan));
        }
        let results = super::bus::check(&args.bus, groups, args.yes, node_id, device)?;
        return Ok(("device", format!("node {node_id} on a bus"), results));
    }
    let heading = "objdict's own node, generated from this description (not a real device)".to_owned();
    let results = conformance_of(device, node_id, &args.groups, |dictionary| dictionary);
    Ok(("objdict-node", heading, results))
}

fn text(heading: &str, results: &Conformance, is_short: bool, out: &mut Output) -> io::Result<()> {
    writeln!(out, "{heading}\n")?;
    let mut table = TextTable::new(HEADINGS, CELL);
    for service in results.checks.chunk_by(|a, b| a.service == b.service) {
        // an object that is as described is said in one line with the others
        let is_object = service[0].service.starts_with("objects");
        for check in service {
            let is_shown = if is_short || is_object { is_failed(check) } else { true };
            if is_shown {
                table.row(cells(check));
            }
        }
        if is_object && !is_short {
            let passed = service.iter().filter(|check| check.verdict == Verdict::Passed).count();
            let result = match &service[0].verdict {
                planned @ Verdict::Planned(_) => words(planned),
                _ => format!("{passed} of {} passed", service.len()),
            };
            table.row([service[0].service.to_owned(), "each entry".to_owned(), "7.4".to_owned(), result]);
        }
    }
    if !table.is_empty() {
        table.write(out)?;
        writeln!(out)?;
    }
    writeln!(out, "{}", verdict(results))
}

fn is_failed(check: &ConformanceCheck) -> bool {
    matches!(check.verdict, Verdict::Failed(_))
}

fn cells(check: &ConformanceCheck) -> [String; 4] {
    let [service, name, section] = [check.service, &check.name, check.section].map(str::to_owned);
    [service, name, section, words(&check.verdict)]
}

fn test_case(check: &ConformanceCheck) -> TestCase<'_> {
    let result = match &check.verdict {
        Verdict::Passed => TestResult::Passed,
        Verdict::Failed(why) => TestResult::Failed(why.clone()),
        other => TestResult::Skipped(words(other)),
    };
    TestCase { class: check.service, name: format!("{} ({})", check.name, check.section), result }
}

/// The result of a check in words.
fn words(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Failed(why) => format!("FAILED: {why}"),
        Verdict::NotServed => "not served".to_owned(),
        Verdict::Absent(what) => format!("not in the description: {what}"),
        Verdict::Impossible(why) => format!("not possible: {why}"),
        Verdict::Planned(effect) => effect.to_string(),
        _ => "passed".to_owned(),
    }
}

/// Such as: 214 of 220; not served: node guarding, TIME
fn verdict(results: &Conformance) -> String {
    let count = |is_meant: &dyn Fn(&Verdict) -> bool| {
        results.checks.iter().filter(|check| is_meant(&check.verdict)).count()
    };
    let planned = |wanted: CheckEffect| count(&|verdict| *verdict == Verdict::Planned(wanted));
    let left_out = count(&|verdict| matches!(verdict, Verdict::Absent(_) | Verdict::Impossible(_)));
    let [reads, writes, commands] =
        [CheckEffect::Reads, CheckEffect::Writes, CheckEffect::Commands].map(planned);
    if reads > 0 {
        return format!(
            "{} checks: {reads} read, {writes} write, {commands} start and stop the device; {left_out} are left out",
            reads + writes + commands
        );
    }
    let (passed, applicable) = results.passed();
    let mut verdict = format!("{passed} of {applicable}");
    let failed = count(&|verdict| matches!(verdict, Verdict::Failed(_)));
    if failed > 0 {
        verdict += &format!("; {failed} failed");
    }
    let unserved = results.checks.iter().filter(|check| check.verdict == Verdict::NotServed);
    let unserved: Vec<&str> = unserved.map(|check| check.name.as_str()).collect();
    if !unserved.is_empty() {
        verdict += &format!("; not served: {}", unserved.join(", "));
    }
    if left_out > 0 {
        verdict += &format!("; {left_out} do not apply to this description");
    }
    verdict
}

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct ConformanceJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The file as it was given.
    file: &'a str,
    /// What was tested: `objdict-node` is objdict's own node, made from the description, and not a real device; `device` is a device on a
    /// bus.
    tested: &'static str,
    /// The node-ID.
    node_id: u8,
    /// The number of checks that passed.
    passed: usize,
    /// The number of checks that apply to the description: without `absent` and `impossible`.
    count: usize,
    /// Whether no check failed.
    is_clean: bool,
    /// The checks, service by service; of the dictionary one for each object.
    checks: Vec<ConformanceRow<'a>>,
}

/// A check.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Check"))]
struct ConformanceRow<'a> {
    /// The service that it is about.
    service: &'a str,
    /// What is checked; of an object its index.
    name: &'a str,
    /// The section of CiA 301, or another document of CiA.
    section: &'a str,
    /// The result.
    result: CheckResult,
    /// What failed, what is absent, or why it is impossible.
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

/// The result of a check.
#[derive(Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema), schemars(rename = "Result"))]
enum CheckResult {
    /// The device responds as CiA 301 requires.
    Passed,
    /// It does not.
    Failed,
    /// The node does not have the service.
    NotServed,
    /// The objects are not in the description.
    Absent,
    /// The description makes the check impossible.
    Impossible,
    /// In a dry run: the check would be made; `reason` is its effect on the device.
    Planned,
}

fn row(check: &ConformanceCheck) -> ConformanceRow<'_> {
    let (result, reason) = match &check.verdict {
        Verdict::Failed(why) => (CheckResult::Failed, Some(why.clone())),
        Verdict::NotServed => (CheckResult::NotServed, None),
        Verdict::Absent(what) => (CheckResult::Absent, Some(what.clone())),
        Verdict::Impossible(why) => (CheckResult::Impossible, Some(why.clone())),
        Verdict::Planned(effect) => (CheckResult::Planned, Some(effect.to_string())),
        _ => (CheckResult::Passed, None),
    };
    ConformanceRow { service: check.service, name: &check.name, section: check.section, result, reason }
}

fn write_json(
    file: &str,
    tested: &'static str,
    node_id: u8,
    results: &Conformance,
    out: &mut Output,
) -> io::Result<()> {
    let (passed, count) = results.passed();
    let checks = results.checks.iter().map(row).collect();
    let document = ConformanceJson {
        version: Version,
        file,
        tested,
        node_id,
        passed,
        count,
        is_clean: results.is_clean(),
        checks,
    };
    out.json(&document)
}
