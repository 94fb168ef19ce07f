//! Reads a patch from its text.

use std::sync::Mutex;
use std::sync::atomic::AtomicBool;

use super::keys::{CHANGE, PATCH, RAW};
use super::{ChangeWords, ChangedPart, Patch, PatchChange, Selector, Worded, no_part};
use crate::compare::{Datum, DatumChange};
use crate::patch::words::{FACTS, FIELDS, word_of};
use objdict_keyed::section::{self, KeyedTable};
use objdict_keyed::toml;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, say, text_rules};
use objdict_model::model::{Address, Part};
use objdict_model::source::{Said, SourceFile};

pub(super) fn read(source: SourceFile) -> Patch {
    let mut findings = Findings::new();
    let mut patch = Patch {
        title: None,
        selector: Selector::default(),
        changes: Vec::new(),
        findings: Findings::new(),
        is_used: AtomicBool::new(false),
        warnings: Mutex::default(),
        source,
    };
    if let Some(tree) = toml::read(patch.source.text(), &mut findings)
        && let Some(section) = KeyedTable::new("the patch", &tree, PATCH, &mut findings)
    {
        patch.title = section.text("title", &mut findings).map(|title| title.value);
        patch.selector = selector(&section, &mut findings);
        let mut list = |name| section.list(name, &mut findings).filter(|_| section.get(name).is_some());
        let (changes, raws) = (list("change").unwrap_or_default(), list("raw").unwrap_or_default());
        let changes = changes.iter().filter_map(|tree| change(tree, &mut findings));
        patch.changes = changes.collect();
        patch.changes.extend(raws.iter().filter_map(|tree| raw(tree, &mut findings)));
        section::check("the patch", &tree, PATCH, &mut findings);
    }
    patch.findings = findings;
    patch
}

fn selector(section: &KeyedTable<'_>, findings: &mut Findings) -> Selector {
    let number = |section: &KeyedTable<'_>, name: &str, findings: &mut Findings| {
        section.integer(name, findings).map(|number: Said<u32>| number.value)
    };
    let is_any = section.get("revision").and_then(KeyedTree::text) == Some("any");
    let sha256 =
        section.text("sha256", findings).map(|hash| Said::new(hash.value.to_ascii_lowercase(), hash.at));
    let is_hash = |hash: &str| hash.len() == 64 && hash.bytes().all(|byte| byte.is_ascii_hexdigit());
    if let Some(hash) = sha256.as_ref().filter(|hash| !is_hash(&hash.value)) {
        let message = say!("`{}` is not a SHA-256 hash", hash.value.as_str());
        findings.push(
            Diagnostic::new(&INVALID_CHANGE, hash.at, message)
                .help("write the 64 digits that `sha256sum` prints"),
        );
    }
    Selector {
        vendor_id: number(section, "vendor-id", findings),
        product_code: number(section, "product-code", findings),
        revision: if is_any { None } else { number(section, "revision", findings) },
        sha256,
    }
}

fn change(tree: &KeyedTree, findings: &mut Findings) -> Option<PatchChange> {
    let section = KeyedTable::new("change", tree, CHANGE, findings)?;
    let at = section.required("change", "at", findings)?;
    let is_text = at.text().is_some();
    let at = Said::new(at.spelled(), at.span);
    // a number of TOML would be read as decimal
    let Some(part) = part_of(&at.value).filter(|_| is_text) else {
        let help = "write a quoted index in hex, with or without a sub-index: `\"2001\"`, `\"2001:3\"`";
        findings.push(Diagnostic::new(&INVALID_CHANGE, at.at, no_part(&at.value)).help(help));
        return None;
    };
    let rename = section.text("rename", findings).and_then(|text| match text.value.parse::<Address>() {
        Ok(address) => Some(Said::new(address, text.at)),
        Err(error) => {
            findings.push(
                Diagnostic::new(
                    &INVALID_CHANGE,
                    text.at,
                    say!("`{}` is not an address", text.value.as_str()),
                )
                .help(error.to_string()),
            );
            None
        }
    });
    let words = ChangeWords {
        expect: fields(&section, "expect", findings),
        absent: names(&section, "absent", findings),
        set: fields(&section, "set", findings),
        unset: names(&section, "unset", findings),
        add: section.get("add").map(|_| fields(&section, "add", findings)),
        is_removed: section.flag("remove", findings).is_some_and(|flag| flag.value),
        rename,
        part,
    };
    let is_stated = |key: &str| section.get(key).is_some();
    let does_something = ["set", "unset", "add", "rename"].into_iter().any(is_stated) || words.is_removed;
    if !does_something {
        let finding = Diagnostic::new(
            &INVALID_CHANGE,
            at.at,
            say!("the change of `{}` changes nothing", at.value.as_str()),
        );
        findings.push(finding.help("add `set`, `unset`, `add`, `remove` or `rename`"));
        return None;
    }
    let reason = section.text("reason", findings).map(|reason| reason.value);
    let source = section.text("source", findings).map(|source| source.value);
    Some(PatchChange { span: at.at, what: ChangedPart::Words(words), reason, source })
}

/// The part that a string refers to.
fn part_of(text: &str) -> Option<Part> {
    if let Some((_, part, _)) = FACTS.iter().find(|(word, ..)| *word == text) {
        return Some(part.clone());
    }
    let Address { index, sub } = text.parse().ok()?;
    Some(Part::at(index, sub))
}

/// The name of a field as the model calls it: the word for a key of CiA 306.
fn named(name: &str) -> String {
    word_of(name).unwrap_or(name).to_owned()
}

/// Fields with their values, the type before the values that it decides about.
fn fields(section: &KeyedTable<'_>, name: &str, findings: &mut Findings) -> Vec<Worded> {
    let Some(tree) = section.get(name) else { return Vec::new() };
    if KeyedTable::new(name, tree, FIELDS, findings).is_none() {
        return Vec::new();
    }
    let known = |entry: &&Pair| {
        let key = entry.key.spelled();
        FIELDS.iter().any(|field| field.name == key) && !matches!(&*entry.value.kind, Kind::List(_))
    };
    let entries = tree.entries().unwrap_or_default().iter().filter(known);
    let mut fields: Vec<Worded> = entries
        .map(|entry| Worded { word: named(&entry.key.spelled()), value: entry.value.clone() })
        .collect();
    fields.sort_by_key(|field| FIELDS.iter().position(|key| key.name == field.word));
    fields
}

fn names(section: &KeyedTable<'_>, name: &str, findings: &mut Findings) -> Vec<Said<String>> {
    let mut names = Vec::new();
    for said in section.texts(name, findings) {
        let word = named(said.value);
        if FIELDS.iter().any(|key| key.name == word) {
            names.push(Said::new(word, said.at));
        } else {
            let finding = Diagnostic::new(&INVALID_CHANGE, said.at, say!("unknown field `{}`", said.value));
            findings.push(finding.help("write one of the words of docs/reference/patch.md"));
        }
    }
    names
}

/// A change without keywords.
fn raw(tree: &KeyedTree, findings: &mut Findings) -> Option<PatchChange> {
    let section = KeyedTable::new("raw", tree, RAW, findings)?;
    let path = section.text("path", findings)?;
    let mut datum = |name: &str| match section.text(name, findings) {
        None => Some(None),
        Some(text) => match serde_json::from_str::<serde_json::Value>(&text.value) {
            Ok(value) => Some(Some(Datum::from(value))),
            Err(error) => {
                let message = say!("`{}` is not JSON: {}", name, error.to_string());
                findings
                    .push(Diagnostic::new(&INVALID_CHANGE, text.at, message).help("write JSON in quotes"));
                None
            }
        },
    };
    let (expect, after) = (datum("expect")?, datum("set")?);
    let before = expect.map(|expect| expect.fingerprint());
    let change = DatumChange { path: path.value, before, after };
    let reason = section.text("reason", findings).map(|reason| reason.value);
    let source = section.text("source", findings).map(|source| source.value);
    Some(PatchChange { span: path.at, what: ChangedPart::Raw(change), reason, source })
}

text_rules! {
    source: "objdict, docs/guides/patches.md";

    "patch/invalid-change" = INVALID_CHANGE, Error;
    summary: "a change cannot be applied",
    checks: "Each change must specify its target and its effect. `at` must be an address or `file`, `device` or `commissioning`. Something must be set, added, removed or renamed. Each value must be valid for its field and its data type.",
    why: "The change is not applied, so the description keeps its error.",
    example: "`at = \"20011:3\"`, `set = { default = 300 }` for an UNSIGNED8",
    remedy: "Correct the change.",

    "patch/expect-not-met" = EXPECT_NOT_MET, Error;
    summary: "the file does not match a patch's expectation",
    checks: "The file must contain the values in `expect` and must not contain the fields in `absent`. It must have the objects and entries that are changed.",
    why: "The vendor changed the file, or it is a different file. The correction may be wrong there, or no longer needed.",
    example: "`expect = { type = \"u8\" }` where the file has UNSIGNED16",
    remedy: "Compare the patch with the new file and correct `expect`, or remove the change.",

    "patch/no-effect" = NO_EFFECT, Warning;
    summary: "a change has no effect",
    checks: "Each change must modify the description.",
    why: "The vendor corrected the file; the change is no longer needed.",
    example: "`set = { type = \"u16\" }` where the file has UNSIGNED16",
    remedy: "Remove the change, or limit the patch to the revisions that need it with `revision`.",

    "patch/other-file" = OTHER_FILE, Error;
    summary: "the file's hash differs from the patch",
    checks: "If the patch states a hash in `sha256`, the bytes of the file must have this hash.",
    why: "The patch was created for a different edition of the file.",
    example: "a new edition of the vendor with the same revision number",
    remedy: "Check the changes with the new file and then correct or remove `sha256`.",
}
