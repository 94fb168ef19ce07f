//! Safe fixes leave every entry as python-canopen, dcf-tools and node-canopen read it, or better: as objdict reads it. No fix
//! makes them refuse a file.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use objdict::diagnostic::{Applicability, Tool};
use objdict::format::{self, Description};
use objdict::lint::Options;
use objdict::model::{Entry, PdoMapping, TypeKind, Value};
use objdict::source::SourceOptions;
use objdict_model::literal;
use serde_json::{Value as Json, json};

use super::{environment, readings};
use crate::support;
use crate::support::skips::{sample, samples_all};

const TOOLS: [Tool; 3] = [Tool::DcfTools, Tool::PythonCanopen, Tool::NodeCanopen];
const NODE_ID: u8 = 5;

/// A fixture after its safe fixes, chosen for some tools.
struct Case {
    name: String,
    before: PathBuf,
    after: PathBuf,
    /// What objdict reads before; after, where it reads nothing before.
    meant: BTreeMap<String, [Json; 6]>,
    /// The tools that may not read it worse; after unsafe fixes, they may not refuse it.
    tools: Vec<Tool>,
    safety: Applicability,
}

/// Those of a sample of the fixtures that a fix changes: without `--compat`, and, if it is safe, with each tool.
fn cases(folder: &Path) -> Vec<Case> {
    let mut cases = Vec::new();
    for path in sample(support::devices_of_all_folders()) {
        let none = (&[][..], Applicability::Unsafe);
        let safely =
            [&[][..], &TOOLS[..1], &TOOLS[1..2], &TOOLS[2..]].map(|tools| (tools, Applicability::Safe));
        for (selected, safety) in safely.into_iter().chain([none]) {
            let Ok(description) = format::open(&path, &SourceOptions::default()) else { continue };
            let options = Options { tools: selected.to_vec(), ..Options::default() };
            let before = description.print();
            let mut meant = expected(&description);
            let check = |description: &Description| objdict::check_with(description, &options);
            let fixed = objdict::fix(description, safety, check);
            if fixed.applied.is_empty() {
                continue;
            }
            for (place, columns) in expected(&fixed.description) {
                let before = meant.entry(place).or_insert_with(|| columns.clone());
                before
                    .iter_mut()
                    .zip(columns)
                    .filter(|(old, _)| old.is_null())
                    .for_each(|(old, new)| *old = new);
            }
            let rules: Vec<&str> = fixed.applied.iter().map(|applied| applied.rule).collect();
            let place = folder.join(cases.len().to_string());
            fs::create_dir_all(&place).unwrap();
            let [old, new] = ["before", "after"].map(|name| place.join(name).with_extension("eds"));
            fs::write(&old, before).unwrap();
            fs::write(&new, fixed.bytes()).unwrap();
            cases.push(Case {
                name: format!("{} {selected:?} {safety:?} {rules:?}", path.display()),
                before: old,
                after: new,
                meant,
                tools: if selected.is_empty() { TOOLS.to_vec() } else { selected.to_vec() },
                safety,
            });
        }
    }
    cases
}

/// The value of an entry as a tool must show it.
fn meant(entry: &Entry, value: Option<&Value>) -> Json {
    let Some(data_type) = entry.data_type else { return Json::Null };
    match value.and_then(|value| value.resolve(data_type, NODE_ID)) {
        None => Json::Null,
        Some(value) => match data_type.kind() {
            TypeKind::Real32 | TypeKind::Real64 => {
                json!(literal::print(&value, literal::Spelling::default()))
            }
            TypeKind::OctetString | TypeKind::Domain => {
                json!(literal::print(&value, literal::Spelling::default()).to_lowercase())
            }
            TypeKind::VisibleString | TypeKind::UnicodeString => {
                json!(literal::print(&value, literal::Spelling::default()))
            }
            _ => value
                .as_integer()
                .map_or(Json::Null, |number| json!(i64::try_from(number).unwrap_or(i64::MAX))),
        },
    }
}

/// What objdict reads: type, access, mapping, limits and value of each entry, as `readings.py` shows them.
fn expected(description: &Description) -> BTreeMap<String, [Json; 6]> {
    let mut entries = BTreeMap::new();
    for (index, object) in &description.device().objects {
        for (sub, entry) in object.entries() {
            let row = [
                entry.data_type.map_or(Json::Null, |data_type| json!(data_type.0)),
                entry.access.map_or(Json::Null, |access| json!(access.to_string())),
                json!(entry.pdo_mapping.is_some_and(|mapping| mapping != PdoMapping::No)),
                meant(&entry, entry.low_limit.as_ref()),
                meant(&entry, entry.high_limit.as_ref()),
                meant(&entry, entry.value()),
            ];
            entries.insert(format!("{index:04X}sub{sub:X}"), row);
        }
    }
    entries
}

/// What a tool reads worse than before.
fn worse(
    before: &Json,
    after: &Json,
    meant: &BTreeMap<String, [Json; 6]>,
    safety: Applicability,
) -> Vec<String> {
    // a file that was refused can only be read better
    let Some(before) = before.as_object() else { return Vec::new() };
    let Some(after) = after.as_object() else { return vec![format!("is refused: {after}")] };
    if safety == Applicability::Unsafe {
        return Vec::new();
    }
    let mut worse = Vec::new();
    for (place, old) in before {
        let Some(new) = after.get(place) else {
            worse.push(format!("{place} is lost"));
            continue;
        };
        let right = meant.get(place);
        let columns = old.as_array().unwrap().iter().zip(new.as_array().unwrap()).enumerate();
        for (column, (old, new)) in columns.filter(|(_, (old, new))| old != new) {
            // what was lost or wrong may become what is meant
            if right.is_none_or(|right| right[column] != *new) {
                worse.push(format!("{place}: {old} became {new}"));
            }
        }
    }
    worse
}

/// An unsafe fix may change what is meant, but no tool refuses the file for it.
///
/// For every fixture, `fix::safe_fixes_leave_the_device_as_it_is` compares what objdict itself reads.
#[test]
fn no_tool_reads_a_file_worse_after_fixes() {
    let Some(programs) = environment() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("interop-fixes");
    fs::remove_dir_all(&folder).ok();
    let cases = cases(&folder);
    let paths: Vec<&Path> = cases.iter().flat_map(|case| [&*case.before, &*case.after]).collect();
    let readings = readings(programs, &paths);
    let mut failures = Vec::new();
    let mut accepted = 0;
    for (case, reading) in cases.iter().zip(readings.chunks(2)) {
        for tool in &case.tools {
            let [before, after] = [&reading[0][tool.name()], &reading[1][tool.name()]];
            accepted += usize::from(before.is_string() && !after.is_string());
            let worse = worse(before, after, &case.meant, case.safety);
            failures.extend(worse.iter().map(|worse| format!("{}: {tool}: {worse}", case.name)));
        }
    }
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n"));
    let [most, many] = if samples_all() { [300, 50] } else { [60, 5] };
    assert!(cases.len() > most && accepted > many, "{} cases, {accepted} accepted", cases.len());
}
