//! Patches: what is made of two descriptions makes the second of the first, in the model and in the text.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use objdict::format::patch::{Patch, apply, make};
use objdict::format::{self, Description};
use objdict::source::{SourceFile, SourceOptions};

use crate::support;

fn open(path: &Path) -> Description {
    format::open(path, &SourceOptions::default()).unwrap()
}

fn files(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(support::fixtures().join(folder)).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.retain(|path| path.extension().is_some_and(|ending| ending != "bin"));
    files.sort();
    files
}

fn patch(text: &str) -> Arc<Patch> {
    Arc::new(Patch::read(SourceFile::from_text("test.patch.toml", text)))
}

/// Asserts that the patch of two descriptions makes the second of the first; says whether the text was edited.
fn assert_makes(one: &Path, other: &Path, in_text: bool) {
    let (original, edited) = (open(one), open(other));
    let text = make(original.described(), edited.described());
    let patch = patch(&text);
    let name = format!("{} → {}", one.display(), other.display());
    assert!(patch.findings().is_empty(), "{name}: {:?}\n{text}", patch.findings());
    let patched = apply(original, &[Arc::clone(&patch)]);
    let findings = |description: &Description| {
        let patched = description.patched();
        patched.map(|patched| format!("{:?}", patched.findings)).unwrap_or_default()
    };
    assert!(patched.patched().is_none_or(|patched| !patched.has_errors()), "{name}: {}", findings(&patched));
    assert!(same(&patched, &edited), "{name}\n{text}\n{}", findings(&patched));
    if in_text {
        let realised = patched.realised().unwrap().unwrap();
        assert!(same(&realised, &edited), "{name}: the text");
    }
}

fn same(one: &Description, other: &Description) -> bool {
    objdict::compare::differences(one.described(), other.described()).is_empty()
}

#[test]
fn what_is_made_of_two_fixtures_makes_the_second_of_the_first() {
    // all pairs take a minute
    let distance = if std::env::var_os("OBJDICT_CORPUS_DIR").is_some() { usize::MAX } else { 2 };
    for folder in ["eds", "dcf", "xdd", "xdc"] {
        let files = files(folder);
        for (position, one) in files.iter().enumerate() {
            let others = files[position + 1..].iter().chain(&files[..position]);
            for (steps, other) in others.take(distance).enumerate() {
                assert_makes(one, other, steps == 0);
            }
        }
    }
}

fn descriptions_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let ending =
            path.extension().and_then(|ending| ending.to_str()).unwrap_or_default().to_ascii_lowercase();
        if path.is_dir() {
            files.extend(descriptions_below(&path));
        } else if ["eds", "dcf", "xdd", "xdc"].contains(&&*ending) {
            files.push(path);
        }
    }
    files.sort();
    files
}

fn fixture(name: &str) -> Description {
    open(&support::fixtures().join(name))
}

/// The lines that differ, with their marks as in a diff.
fn difference(one: &str, other: &str) -> Vec<String> {
    let [left, right]: [Vec<&str>; 2] = [one, other].map(|text| text.lines().map(str::trim_end).collect());
    let mut lines = Vec::new();
    lines.extend(left.iter().filter(|line| !right.contains(line)).map(|line| format!("-{line}")));
    lines.extend(right.iter().filter(|line| !left.contains(line)).map(|line| format!("+{line}")));
    lines
}

/// What the format has a place for is edited in it, and everything else of the text stays.
#[test]
fn the_text_of_the_vendor_stays() {
    let original = fixture("eds/io-401.eds");
    let text = original.source().text().to_owned();
    let patch = Arc::new(Patch::open(&support::fixtures().join("patches/io-401.patch.toml")).unwrap());
    let patched = apply(original, &[patch]);
    assert_eq!(patched.patched().unwrap().lines(), [""; 0]);
    let realised = patched.realised().unwrap().unwrap();
    let lines = difference(&text, realised.source().text());
    let (embedded, edited): (Vec<&String>, Vec<&String>) =
        lines.iter().partition(|line| line.contains("objdict-embed"));
    assert_eq!(
        edited,
        ["-OrderCode=FIX-IO401-16-2", "+OrderCode=IO401-16-2", "+LowLimit=0", "+HighLimit=4095"]
    );
    assert!(!embedded.is_empty());
    assert!(same(&realised, &patched));
}

/// Units, names of values and bits, and groups are those that documentation and generated code ask for.
#[test]
fn words_that_an_eds_does_not_have_reach_the_model() {
    use objdict::model::Meaning;
    let patch = Arc::new(Patch::open(&support::fixtures().join("patches/io-401.patch.toml")).unwrap());
    for name in ["eds/io-401.eds", "dcf/io-401-node5.dcf"] {
        let patched = apply(fixture(name), &[Arc::clone(&patch)]);
        let device = patched.device();
        let meanings = device.meanings();
        let scaling = meanings.scaling_of(device.object(0x6401).unwrap().subs.get(1).unwrap());
        assert_eq!(scaling.multiplier, Some("0.0024"), "{name}");
        assert_eq!(scaling.unit.and_then(|unit| unit.labels.name_in("en")), Some("V"));
        let Some(Meaning::BitStruct(bits)) = meanings.of(0x6200, 1) else { panic!("{name}: no bits") };
        let fields: Vec<_> = bits.fields.iter().map(|field| (field.name, field.first, field.bits)).collect();
        assert_eq!(fields, [("Lamp", 0, 1), ("Valve", 1, 1), ("Speed", 2, 2)]);
        let Some(Meaning::Enumeration(values)) = meanings.of(0x6202, 1) else { panic!("{name}: no names") };
        assert_eq!(values.values.iter().map(|value| value.name).collect::<Vec<_>>(), ["Off", "On"]);
        let group = &device.application[0].groups[0];
        assert_eq!(group.groups[0].parameters, ["UID_SUB_640101".into()]);
    }
}

/// Findings about what a patch changed point into the patch.
#[test]
fn a_finding_points_to_the_patch_that_caused_it() {
    let text = "format = \"objdict-patch/1\"\n[[change]]\nat = \"1017\"\nset = { type = \"u32\" }\n";
    let patched = apply(fixture("eds/io-401.eds"), &[patch(text)]);
    let findings = objdict::check(&patched);
    let finding = findings.iter().next().expect("1017h is an UNSIGNED16");
    let locations = objdict::report::Location::all((&patched).into(), finding);
    let last = locations.last().unwrap();
    assert_eq!((last.source.name(), last.start.line), ("test.patch.toml", 3));
}

/// The files below `OBJDICT_CORPUS_DIR`: of each two descriptions of one product, the patch of them makes the second of the first.
#[test]
fn revisions_of_vendors_become_each_other() {
    let Some(folder) = std::env::var_os("OBJDICT_CORPUS_DIR") else { return };
    let mut products: std::collections::BTreeMap<_, Vec<PathBuf>> = std::collections::BTreeMap::new();
    for path in descriptions_below(Path::new(&folder)) {
        let Ok(description) = format::open(&path, &SourceOptions::default()) else { continue };
        let info = description.device().device_info.clone().unwrap_or_default();
        let vendor = description.device().identity().vendor_id.filter(|id| *id != 0).or(info.vendor_number);
        let Some(vendor) = vendor.filter(|vendor| *vendor != 0) else { continue };
        products.entry((vendor, description.format().name())).or_default().push(path);
    }
    let mut pairs = 0;
    for files in products.values() {
        for pair in files.windows(2) {
            pairs += 1;
            assert_makes(&pair[0], &pair[1], true);
        }
    }
    assert!(pairs >= 15, "{pairs} pairs");
}

/// The page has each key with its meaning: those of the schema, which is made of the tables that patches are read by.
#[test]
fn the_page_has_all_keys() {
    let page = std::fs::read_to_string("docs/reference/patch.md").unwrap();
    let schema = objdict::format::patch::schema::patch();
    let change = &schema["properties"]["change"]["items"];
    let tables = [&schema, change, &schema["properties"]["raw"]["items"]];
    let mut count = 0;
    for (key, property) in tables.iter().flat_map(|table| table["properties"].as_object().unwrap()) {
        let row = format!("| `{key}` | {} |", property["description"].as_str().unwrap());
        assert!(page.contains(&row), "{row}");
        count += 1;
    }
    // the keys of CiA 306 begin with a capital letter
    let fields = change["properties"]["set"]["properties"].as_object().unwrap();
    for (key, property) in fields.iter().filter(|(key, _)| key.starts_with(char::is_lowercase)) {
        let row = format!("| `{key}` | {} |", property["description"].as_str().unwrap());
        assert!(page.contains(&row), "{row}");
        count += 1;
    }
    let rows = page.lines().filter(|line| line.starts_with("| `")).count();
    assert_eq!(rows, count);
}
