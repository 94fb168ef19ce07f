//! Every output of findings, over all fixtures that have some: each is what its readers take.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::{Mutex, PoisonError};

use serde_json::Value;

use crate::support;

/// The command where all fixtures are files.
fn command() -> Command {
    let mut command = Command::new(crate::program());
    command.current_dir(support::fixtures().join(".."));
    command
}

fn objdict(arguments: &[&str]) -> Output {
    command().args(arguments).output().expect("the command runs")
}

/// What `check` writes in a format, and with the options behind it, over the broken fixtures and those of the rules; once for
/// all tests.
fn check(format: &str) -> &'static str {
    once(&format!("check --format {format}"), checked)
}

fn checked(command: &str) -> String {
    found(command, ["fixtures/broken", "fixtures/rules", "fixtures/xdd"].map(str::to_owned))
}

/// What `network check` writes in a format over the networks of the rules.
fn networks(format: &str) -> &'static str {
    once(&format!("network check --format {format}"), |command| {
        let folders = std::fs::read_dir(support::fixtures().join("rules/network")).expect("the fixtures");
        let folders: BTreeSet<_> = folders.map(|folder| folder.expect("a folder").path()).collect();
        let files = folders.iter().flat_map(|folder| {
            ["yml", "toml", "cpj"].map(|ending| folder.join(format!("bad.{ending}"))).into_iter()
        });
        let name = |file: PathBuf| {
            let name = file.strip_prefix(support::fixtures()).expect("a fixture");
            format!("fixtures/{}", name.to_str().expect("UTF-8"))
        };
        found(command, files.filter(|file| file.exists()).map(name))
    })
}

fn once(command: &str, run: impl FnOnce(&str) -> String) -> &'static str {
    static TEXTS: Mutex<BTreeMap<String, &'static str>> = Mutex::new(BTreeMap::new());
    let mut texts = TEXTS.lock().unwrap_or_else(PoisonError::into_inner);
    texts.entry(command.to_owned()).or_insert_with(|| run(command).leak())
}

/// What a command writes that finds something in files.
fn found(command: &str, files: impl IntoIterator<Item = String>) -> String {
    let arguments: Vec<String> = command.split(' ').map(str::to_owned).chain(files).collect();
    let output = objdict(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The logs about descriptions and about networks.
fn logs() -> [Value; 2] {
    [check("sarif"), networks("sarif")].map(|text| serde_json::from_str(text).expect("JSON"))
}

/// What a property holds.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Text,
    Number,
    Truth,
    Words(&'static [&'static str]),
    One(&'static str),
    Many(&'static str),
    Texts,
    Map(&'static str),
    Bag,
}

const LEVELS: Kind = Kind::Words(&["none", "note", "warning", "error"]);

/// The objects of SARIF that are written, by the sections of the standard: their properties, those that must be there with
/// an exclamation mark.
fn shape(object: &str) -> &'static [(&'static str, Kind)] {
    use Kind::{Bag, Many, Map, Number, One, Text, Texts, Truth, Words};
    match object {
        "log" => &[("version!", Words(&["2.1.0"])), ("$schema", Text), ("runs!", Many("run"))],
        "run" => &[
            ("tool!", One("tool")),
            ("results", Many("result")),
            ("artifacts", Many("artifact")),
            ("invocations", Many("invocation")),
            ("originalUriBaseIds", Map("base")),
            ("newlineSequences", Texts),
            ("columnKind", Words(&["utf16CodeUnits", "unicodeCodePoints"])),
        ],
        "tool" => &[("driver!", One("driver"))],
        "driver" => &[
            ("name!", Text),
            ("version", Text),
            ("semanticVersion", Text),
            ("informationUri", Text),
            ("rules", Many("rule")),
        ],
        "rule" => &[
            ("id!", Text),
            ("name", Text),
            ("shortDescription", One("message")),
            ("fullDescription", One("message")),
            ("help", One("help")),
            ("helpUri", Text),
            ("defaultConfiguration", One("configuration")),
            ("properties", Bag),
        ],
        "message" => &[("text!", Text)],
        "help" => &[("text!", Text), ("markdown", Text)],
        "configuration" => &[("level", LEVELS)],
        "result" => &[
            ("message!", One("message")),
            ("ruleId", Text),
            ("ruleIndex", Number),
            ("level", LEVELS),
            ("locations", Many("location")),
            ("relatedLocations", Many("location")),
            ("partialFingerprints", Map("")),
            ("fixes", Many("fix")),
        ],
        "location" => &[
            ("id", Number),
            ("physicalLocation", One("physicalLocation")),
            ("logicalLocations", Many("logicalLocation")),
            ("message", One("message")),
        ],
        "physicalLocation" => &[("artifactLocation!", One("artifactLocation")), ("region", One("region"))],
        "artifactLocation" => &[("uri", Text), ("uriBaseId", Text), ("index", Number)],
        "logicalLocation" => &[("name", Text), ("fullyQualifiedName", Text), ("kind", Text)],
        "region" => &[
            ("startLine!", Number),
            ("startColumn", Number),
            ("endLine", Number),
            ("endColumn", Number),
            ("byteOffset", Number),
            ("byteLength", Number),
        ],
        "fix" => &[
            ("description", One("message")),
            ("artifactChanges!", Many("artifactChange")),
            ("properties", Bag),
        ],
        "artifactChange" => {
            &[("artifactLocation!", One("artifactLocation")), ("replacements!", Many("replacement"))]
        }
        "replacement" => &[("deletedRegion!", One("region")), ("insertedContent", One("message"))],
        "artifact" => &[("location", One("artifactLocation")), ("encoding", Text), ("roles", Texts)],
        "base" => &[("description", One("message"))],
        "invocation" => &[
            ("executionSuccessful!", Truth),
            ("exitCode", Number),
            ("exitCodeDescription", Text),
            ("toolExecutionNotifications", Many("notification")),
        ],
        "notification" => {
            &[("message!", One("message")), ("level", LEVELS), ("associatedRule", One("ruleReference"))]
        }
        "ruleReference" => &[("id", Text), ("index", Number)],
        _ => panic!("no shape of {object}"),
    }
}

fn assert_shape(object: &str, value: &Value, path: &str) {
    let properties = shape(object);
    let map = value.as_object().unwrap_or_else(|| panic!("{path} is no object"));
    for (name, _) in properties {
        let required = name.strip_suffix('!');
        assert!(required.is_none_or(|name| map.contains_key(name)), "{path} has no {name}");
    }
    for (name, value) in map {
        let path = format!("{path}.{name}");
        let property = properties.iter().find(|(known, _)| known.trim_end_matches('!') == name);
        let (_, kind) = property.unwrap_or_else(|| panic!("{path} is unknown"));
        let items = || value.as_array().unwrap_or_else(|| panic!("{path} is no list"));
        match *kind {
            Kind::Text => assert!(value.is_string(), "{path}"),
            Kind::Number => assert!(value.is_u64(), "{path}"),
            Kind::Truth => assert!(value.is_boolean(), "{path}"),
            Kind::Words(words) => {
                assert!(value.as_str().is_some_and(|w| words.contains(&w)), "{path}: {value}");
            }
            Kind::One(object) => assert_shape(object, value, &path),
            Kind::Many(object) => items().iter().for_each(|item| assert_shape(object, item, &path)),
            Kind::Texts => assert!(items().iter().all(Value::is_string), "{path}"),
            Kind::Map(object) => {
                for (key, value) in value.as_object().expect("an object") {
                    match object {
                        "" => assert!(value.is_string(), "{path}.{key}"),
                        object => assert_shape(object, value, &path),
                    }
                }
            }
            Kind::Bag => assert!(value.is_object(), "{path}"),
        }
    }
}

fn list<'a>(value: &'a Value, name: &str) -> &'a [Value] {
    value[name].as_array().map_or(&[], Vec::as_slice)
}

#[test]
fn sarif_has_the_shape_of_the_standard() {
    logs().iter().for_each(|log| assert_shape("log", log, "log"));
}

#[test]
fn sarif_refers_to_rules_and_files_that_it_lists() {
    let [descriptions, networks] = logs();
    assert_refers_to_what_is_listed(&descriptions["runs"][0], 150);
    let run = &networks["runs"][0];
    assert_refers_to_what_is_listed(run, 40);
    let files = list(run, "artifacts").iter().filter_map(|file| file["location"]["uri"].as_str());
    assert!(
        files.clone().any(|file| file == "fixtures/network/servo.eds"),
        "{:?}",
        files.collect::<Vec<_>>()
    );
}

fn assert_refers_to_what_is_listed(run: &Value, least: usize) {
    let rules = list(&run["tool"]["driver"], "rules");
    let ids: HashSet<&str> = rules.iter().filter_map(|rule| rule["id"].as_str()).collect();
    assert_eq!(ids.len(), rules.len(), "a rule is listed once");
    assert!(rules.len() > least, "the fixtures are about most rules, and {} found something", rules.len());
    for rule in rules {
        assert!(rule["shortDescription"]["text"].as_str().is_some_and(|text| !text.is_empty()), "{rule}");
        assert!(rule["fullDescription"]["text"].as_str().is_some_and(|text| !text.is_empty()), "{rule}");
        assert!(
            rule["help"]["markdown"].as_str().is_some_and(|text| text.contains("## How to fix")),
            "{rule}"
        );
    }
    let artifacts = list(run, "artifacts");
    let is_listed = |location: &Value| {
        let index = location["index"].as_u64().expect("an index") as usize;
        artifacts[index]["location"]["uri"] == location["uri"]
    };
    for result in list(run, "results") {
        let index = result["ruleIndex"].as_u64().expect("an index") as usize;
        assert_eq!(rules[index]["id"], result["ruleId"]);
        assert_eq!(list(result, "locations").len(), 1, "{result}");
        for location in list(result, "locations").iter().chain(list(result, "relatedLocations")) {
            assert!(is_listed(&location["physicalLocation"]["artifactLocation"]), "{location}");
        }
        assert!(result["partialFingerprints"]["objdict/v2"].is_string(), "{result}");
    }
}

/// The bytes and the lines of a region are the same text.
#[test]
fn regions_of_sarif_are_right_in_bytes_and_in_utf_16() {
    let logs = logs();
    let mut compared = 0;
    let mut beyond_ascii = 0;
    let results = || logs.iter().flat_map(|log| list(&log["runs"][0], "results"));
    let related = results().flat_map(|result| list(result, "relatedLocations"));
    for location in results().map(|result| &result["locations"][0]).chain(related) {
        let location = &location["physicalLocation"];
        let region = &location["region"];
        let number = |name: &str| region[name].as_u64().expect("a number") as usize;
        if region.get("byteOffset").is_none() {
            continue;
        }
        let uri = location["artifactLocation"]["uri"].as_str().expect("a path").replace("%20", " ");
        let bytes = std::fs::read(support::fixtures().join("..").join(&uri)).expect("the fixture");
        let by_bytes = &bytes[number("byteOffset")..][..number("byteLength")];
        let text = String::from_utf8(bytes.clone()).expect("offsets are only told of UTF-8");
        let text = text.strip_prefix('\u{FEFF}').unwrap_or(&text);
        let from = offset(text, number("startLine"), number("startColumn"));
        let to = offset(text, number("endLine"), number("endColumn"));
        assert_eq!(&text.as_bytes()[from..to], by_bytes, "{location}");
        compared += 1;
        beyond_ascii += usize::from(!text.is_ascii());
    }
    assert!(compared > 300 && beyond_ascii > 3, "{compared} regions, {beyond_ascii} in texts beyond ASCII");
}

/// The byte of a line and a column of UTF-16, both counted from 1.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let mut start = 0;
    for _ in 1..line {
        let rest = &text[start..];
        let end = rest.find(['\r', '\n']).expect("the line is there");
        start += end + if rest[end..].starts_with("\r\n") { 2 } else { 1 };
    }
    let mut units = 1;
    for (at, character) in text[start..].char_indices() {
        if units >= column {
            return start + at;
        }
        units += character.len_utf16();
    }
    text.len()
}

#[test]
fn sarif_says_how_the_run_ended() {
    let run = |arguments: &[&str]| {
        let output = objdict(&[&["check", "--format", "sarif"], arguments].concat());
        let log: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        (output.status.code(), log["runs"][0]["invocations"][0].clone())
    };
    let (code, invocation) = run(&["fixtures/eds/minimal.eds"]);
    assert_eq!((code, &invocation["exitCode"]), (Some(0), &Value::from(0)));
    assert_eq!(invocation["executionSuccessful"], true);
    let (code, invocation) = run(&["fixtures/broken/octal.eds", "no-such.eds"]);
    assert_eq!((code, &invocation["exitCode"]), (Some(2), &Value::from(2)));
    assert_eq!(invocation["executionSuccessful"], false);
    let told = &invocation["toolExecutionNotifications"][0]["message"]["text"];
    assert!(told.as_str().is_some_and(|text| text.contains("no-such.eds")), "{told}");
}

/// The schema of OASIS is no part of the project: the crate serde-sarif has a copy.
fn sarif_schema() -> Result<PathBuf, String> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sarif-schema");
    let schema = folder.join("vendor/serde-sarif/src/schema.json");
    if schema.exists() {
        return Ok(schema);
    }
    let manifest = "[package]\nname = \"schema\"\nedition = \"2024\"\n[lib]\npath = \"lib.rs\"\n[workspace]\n\
        [dependencies]\nserde-sarif = \"=0.8.0\"\n";
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text);
    let made = std::fs::create_dir_all(&folder).and_then(|()| write("Cargo.toml", manifest));
    made.and_then(|()| write("lib.rs", "")).map_err(|error| error.to_string())?;
    support::run(Command::new(env!("CARGO")).args(["vendor", "--quiet"]).current_dir(&folder))?;
    Ok(schema)
}

#[test]
fn sarif_is_valid_against_its_schema() {
    let needed = sarif_schema()
        .and_then(|schema| Ok((schema, support::python("sarif-venv", &["fastjsonschema==2.22.3"])?)));
    let Some((schema, programs)) = support::unless_offline(needed) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in
        [("all", check("sarif --all")), ("joined", check("sarif")), ("networks", networks("sarif"))]
    {
        let log = folder.path().join("log.sarif");
        std::fs::write(&log, text).expect("it is written");
        let script = "import json, sys, fastjsonschema\n\
            schema, log = (json.load(open(path, encoding='utf-8')) for path in sys.argv[1:])\n\
            fastjsonschema.compile(schema)(log)";
        let mut python = Command::new(programs.join("python"));
        let judged = support::run(python.args(["-c", script]).arg(&schema).arg(&log));
        assert_eq!(judged, Ok(()), "{name}");
    }
}

/// The place of each section of an object or sub-index, by its first line; `None` for other sections.
fn sections(text: &str) -> BTreeMap<u64, Option<String>> {
    let digits = |text: &str, radix| u16::from_str_radix(text, radix).ok();
    let place = |name: &str| {
        let index = digits(name.get(..4)?, 16)?;
        let sub = name[4..].strip_prefix("sub").map(|sub| digits(sub, 16));
        match sub {
            // above FFh it is no sub-index, so the section has no place
            Some(sub) => sub.filter(|sub| *sub <= 0xFF).map(|sub| format!("0x{index:04X}sub{sub:X}")),
            None => (name.len() == 4).then(|| format!("0x{index:04X}")),
        }
    };
    let header = |line: &str| Some(line.trim().strip_prefix('[')?.split(']').next()?.to_ascii_lowercase());
    let lines = (1..).zip(text.lines());
    lines.filter_map(|(number, line)| Some((number, place(&header(line)?)))).collect()
}

/// The place of each object and sub-object of an XDD, by its first line; `None` behind it.
fn elements(text: &str) -> BTreeMap<u64, Option<String>> {
    let attribute = |tag: &str, name: &str| {
        let (_, value) = tag.split_once(&format!(" {name}=\""))?;
        u16::from_str_radix(value.split('"').next()?, 16).ok()
    };
    let (mut places, mut object, mut line) = (BTreeMap::new(), None, 1);
    for tag in text.split('<') {
        let (tag_text, _) = tag.split_once('>').unwrap_or((tag, ""));
        let name = tag_text.split_whitespace().next().unwrap_or_default().trim_end_matches('/');
        let end = line + tag_text.matches('\n').count() as u64;
        let is_closed = tag_text.ends_with('/');
        match name.rsplit(':').next().unwrap_or_default() {
            "CANopenObject" => {
                object = attribute(tag_text, "index").map(|index| format!("0x{index:04X}"));
                places.insert(line, object.clone());
                object = object.filter(|_| !is_closed);
                places.insert(end + 1, object.clone());
            }
            "CANopenSubObject" => {
                let sub = attribute(tag_text, "subIndex");
                places.insert(
                    line,
                    object.as_ref().zip(sub).map(|(object, sub)| format!("{object}sub{sub:X}")),
                );
                places.insert(end + 1, object.clone());
            }
            "/CANopenObject" => {
                object = None;
                places.insert(end + 1, None);
            }
            _ => {}
        }
        line += tag.matches('\n').count() as u64;
    }
    places
}

#[test]
fn findings_in_the_section_of_an_object_have_its_place() {
    let document: Value = serde_json::from_str(check("json --all")).expect("JSON");
    let mut texts = BTreeMap::new();
    let mut compared = [0; 2];
    for finding in list(&document, "findings") {
        let file = finding["file"].as_str().expect("a path");
        let is_xml = file.ends_with(".xdd") || file.ends_with(".xdc");
        let sections = texts.entry(file).or_insert_with(|| {
            let bytes = std::fs::read(support::fixtures().join("..").join(file)).expect("the fixture");
            let of_text = if is_xml { elements } else { sections };
            of_text(&String::from_utf8_lossy(&bytes))
        });
        let line = finding["line"].as_u64().expect("a line");
        let Some((_, Some(section))) = sections.range(..=line).next_back() else { continue };
        let place = finding["place"].as_str().unwrap_or_default();
        assert!(place.starts_with(&**section), "{section}: {finding}");
        compared[usize::from(is_xml)] += 1;
    }
    assert!(compared[0] > 400 && compared[1] > 40, "{compared:?} findings");
}

#[test]
fn elements_without_names_are_one_finding_for_people_and_three_for_programs() {
    let file = "fixtures/rules/cia306/missing-name/bad-elements.eds";
    let document: Value = serde_json::from_str(check("json")).expect("JSON");
    let findings = list(&document, "findings").iter().filter(|finding| finding["file"] == file);
    let places: Vec<_> = findings.map(|one| one["place"].as_str().unwrap_or_default()).collect();
    assert_eq!(places, [1, 2, 3].map(|sub| format!("0x2000sub{sub} / ParameterName")));
    let concise = check("concise");
    let line = concise.lines().find(|line| line.contains(file)).unwrap_or_default();
    assert!(
        line.ends_with("sub-index 1 of 2000h has no name; 2 more like this: 2000h:02 to 2000h:03"),
        "{line}"
    );
}

/// What is related to a finding about a network may be in the description of a node.
#[test]
fn a_related_place_in_a_description_names_its_file() {
    let document: Value = serde_json::from_str(networks("json")).expect("JSON");
    let findings = list(&document, "findings").iter();
    let mut rates = findings.filter(|finding| finding["rule"] == "network/unsupported-bit-rate");
    let [of_network, of_node] = list(rates.next().expect("a finding"), "related") else {
        panic!("two related places")
    };
    assert_eq!((of_network.get("file"), of_network.get("place")), (None, None));
    let file = of_node["file"].as_str().expect("a path");
    assert!(file.ends_with("/network/servo.eds"), "{file}");
    let text = std::fs::read_to_string(support::fixtures().join("..").join(file)).expect("the description");
    let line = of_node["line"].as_u64().expect("a line") as usize;
    assert_eq!(text.lines().nth(line - 1), Some("BaudRate_50=0"));
    assert_eq!(of_node["place"], "DeviceInfo / BaudRate_50");
}

#[test]
fn issues_of_gitlab_have_different_fingerprints() {
    let issues: Value = serde_json::from_str(check("gitlab")).expect("JSON");
    let issues = issues.as_array().expect("a list");
    assert!(issues.len() > 300);
    let mut seen = HashSet::new();
    for issue in issues {
        for name in ["description", "check_name", "fingerprint"] {
            assert!(issue[name].as_str().is_some_and(|text| !text.is_empty()), "{name}: {issue}");
        }
        assert!(["info", "minor", "major"].contains(&issue["severity"].as_str().expect("a word")), "{issue}");
        let location = &issue["location"];
        assert!(location["path"].as_str().is_some_and(|path| path.starts_with("fixtures/")), "{issue}");
        assert!(location["lines"]["begin"].as_u64().is_some_and(|line| line > 0), "{issue}");
        assert!(seen.insert(issue["fingerprint"].to_string()), "twice: {issue}");
    }
}

#[test]
fn annotations_of_github_are_lines_of_commands() {
    let text = check("github");
    let (last, commands) =
        text.lines().collect::<Vec<_>>().split_last().map(|(a, b)| (*a, b.to_vec())).expect("lines");
    assert!(last.contains(" errors, "), "{last}");
    assert!(commands.len() > 300);
    for line in commands {
        let (command, _) = line[2..].split_once("::").unwrap_or_else(|| panic!("{line}"));
        let (level, properties) = command.split_once(' ').unwrap_or_else(|| panic!("{line}"));
        assert!(["error", "warning", "notice"].contains(&level), "{line}");
        for property in properties.split(',') {
            let (name, value) = property.split_once('=').unwrap_or_else(|| panic!("{line}"));
            match name {
                "file" => assert!(value.starts_with("fixtures/"), "{line}"),
                "line" | "endLine" | "col" | "endColumn" => assert!(value.parse::<u32>().is_ok(), "{line}"),
                name => assert_eq!(name, "title", "{line}"),
            }
        }
    }
}

#[test]
fn junit_counts_what_it_has() {
    let text = check("junit");
    let document = roxmltree::Document::parse(text).expect("well-formed XML");
    let suites: Vec<_> = document.root_element().children().filter(roxmltree::Node::is_element).collect();
    assert!(suites.len() > 100);
    let mut has_clean = false;
    for suite in suites {
        let count =
            |name: &str| suite.descendants().filter(|node| node.has_tag_name(name)).count().to_string();
        assert_eq!(suite.attribute("tests"), Some(&*count("testcase")));
        assert_eq!(suite.attribute("failures"), Some(&*count("failure")));
        let names: Vec<_> = suite.children().filter_map(|case| case.attribute("name")).collect();
        assert_eq!(names.iter().collect::<HashSet<_>>().len(), names.len(), "{names:?}");
        has_clean |= names == ["no findings"];
    }
    assert!(has_clean, "the good fixtures have a case too");
}

/// The checks of a device on a bus, and those of a plan, are the same in each format.
#[test]
fn conformance_has_the_same_checks_in_each_format() {
    let bus = ["--node-id", "5", "--bus", "sim:fixtures/bus/cell.toml", "--listen", "10"];
    for (file, more) in [("fixtures/eds/io-401.eds", None), ("fixtures/eds/drive-402.eds", Some("--dry-run"))]
    {
        let written = |format: &str| {
            let arguments: Vec<&str> =
                ["conformance", file, "--format", format].into_iter().chain(bus).collect();
            let output = objdict(&arguments.into_iter().chain(more).collect::<Vec<_>>());
            assert_eq!(output.status.code(), Some(i32::from(more.is_none())), "{file}");
            String::from_utf8(output.stdout).expect("UTF-8")
        };
        let json: Value = serde_json::from_str(&written("json")).expect("JSON");
        let checks = list(&json, "checks");
        let failed = checks.iter().filter(|check| check["result"] == "failed").count();
        assert_eq!(failed == 0, more.is_some());
        let xml = written("junit");
        let document = roxmltree::Document::parse(&xml).expect("well-formed XML");
        let count = |name| document.descendants().filter(|node| node.has_tag_name(name)).count();
        assert_eq!((count("testcase"), count("failure")), (checks.len(), failed));
        assert_eq!(
            count("skipped"),
            checks.iter().filter(|check| check["result"] != "passed").count() - failed
        );
        let cases = document.descendants().filter(|node| node.has_tag_name("testcase"));
        let names: HashSet<_> =
            cases.map(|case| (case.attribute("classname"), case.attribute("name"))).collect();
        assert_eq!(names.len(), checks.len(), "readers merge cases with one name");
        let page = written("html");
        assert_eq!(page.matches("<tr><td>").count(), checks.len());
        assert_eq!(page.matches("<strong>").count(), failed);
    }
}

#[test]
fn concise_is_a_line_a_finding() {
    let json: Value = serde_json::from_str(check("json --all")).expect("JSON");
    let findings = list(&json, "findings");
    let concise = check("concise --all");
    let lines: Vec<&str> = concise.lines().collect();
    assert_eq!(lines.len(), findings.len() + 1, "and the sum");
    for (line, finding) in lines.iter().zip(findings) {
        let start = ["file", "line", "column"].map(|name| finding[name].to_string().replace('"', ""));
        let (severity, rule) = (finding["severity"].as_str(), finding["rule"].as_str());
        let start = format!("{}: {} {}: ", start.join(":"), severity.unwrap_or(""), rule.unwrap_or(""));
        assert!(line.starts_with(&start), "{line} is not of {finding}");
    }
}

#[test]
fn statistics_count_what_is_found() {
    let broken = |arguments: &[&str]| {
        let output = objdict(&[&["check", "--format", "json", "fixtures/broken"], arguments].concat());
        serde_json::from_slice::<Value>(&output.stdout).expect("JSON")
    };
    let both = broken(&["--statistics"]);
    let sum: u64 = list(&both, "statistics").iter().filter_map(|row| row["findings"].as_u64()).sum();
    assert_eq!(sum, list(&both, "findings").len() as u64);
    let only = broken(&["--statistics=only"]);
    assert_eq!(only["statistics"], both["statistics"]);
    assert_eq!(only["summary"], both["summary"]);
    assert!(only.get("findings").is_none());
    let output = objdict(&["check", "--format", "sarif", "--statistics", "fixtures/broken"]);
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn the_same_run_gives_the_same_bytes() {
    for format in ["sarif", "junit"] {
        assert!(check(format) == checked(&format!("check --format {format}")), "{format}");
    }
}

/// A reader that goes away, as `head` does, is no error, whatever is written.
#[test]
fn a_closed_pipe_is_no_failure() {
    let formats = ["text", "concise", "json", "sarif", "github", "gitlab", "junit"];
    let checks =
        formats.map(|format| (vec!["check", "--format", format, "fixtures/broken", "fixtures/rules"], 1));
    let others = [
        (vec!["check", "--statistics=only", "fixtures/broken"], 1),
        (vec!["rules"], 0),
        (vec!["rules", "--format", "json"], 0),
        (vec!["explain", "cia306/duplicate-key"], 0),
        (vec!["completions", "bash"], 0),
    ];
    for (arguments, code) in checks.into_iter().chain(others) {
        let mut child = command()
            .args(&arguments)
            .arg("--quiet")
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut first = [0; 5];
        child.stdout.take().expect("a pipe").read_exact(&mut first).expect("five bytes");
        // the pipe is closed here: `take` moved its end into a temporary that is gone
        let output = child.wait_with_output().expect("the command ends");
        assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        assert!(output.stderr.is_empty(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
