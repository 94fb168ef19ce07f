//! The variants of a device: the differences of each from the file.

use super::keys::variant_keys;
use super::merge::Merged;
use objdict_keyed::rules::{OUT_OF_RANGE, SHARED_PRODUCT_CODE, WRONG_TYPE};
use objdict_keyed::section::KeyedTable;
use objdict_keyed::tree::{KeyedTree, Kind, Pair};
use objdict_model::diagnostic::{Diagnostic, Findings, say};
use objdict_model::model::Device;

/// Limited because each is read and checked like a file.
const MAX_VARIANTS: usize = 64;

/// The names of the variants of a tree, in its order.
pub(super) fn names(tree: &KeyedTree) -> Vec<String> {
    let entries = tree.get("variant").and_then(KeyedTree::entries).unwrap_or_default();
    let names = entries.iter().map(|entry| entry.key.spelled());
    names.filter(|name| is_name(name)).take(MAX_VARIANTS).collect()
}

/// Whether a name is valid as an argument and as a part of file names.
fn is_name(name: &str) -> bool {
    let is_part = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.');
    name.starts_with(|first: char| first.is_ascii_alphanumeric()) && name.bytes().all(is_part)
}

/// Reports names that no variant can have.
pub(super) fn check(root: &KeyedTable<'_>, findings: &mut Findings) {
    let entries = root.named("variant", findings);
    for Pair { key, .. } in entries.iter().filter(|entry| !is_name(&entry.key.spelled())) {
        let message = say!("`{}` is not a name for a variant", key.spelled());
        let finding = Diagnostic::new(&WRONG_TYPE, key.span, message);
        findings.push(finding.help("write a name of letters and digits, `-`, `_` and `.`"));
    }
    if let Some(Pair { key, .. }) = entries.get(MAX_VARIANTS) {
        let message = say!("there are {} variants, more than {}", entries.len(), MAX_VARIANTS);
        findings.push(Diagnostic::new(&OUT_OF_RANGE, key.span, message).help("write a file for each family"));
    }
}

/// Reports variants that a manager cannot know from each other.
pub(super) fn check_product_codes(base: &KeyedTree, findings: &mut Findings) {
    let variants = base.get("variant").and_then(KeyedTree::entries).unwrap_or_default();
    let of_base = product_code(base);
    let mut seen: Vec<(i128, Option<&Pair>)> = of_base.map(|code| (code, None)).into_iter().collect();
    for variant in variants.iter().take(MAX_VARIANTS) {
        let own = product_code(&variant.value);
        let Some(code) = own.or(of_base).filter(|code| *code != 0) else { continue };
        let Some((_, other)) = seen.iter().find(|(known, _)| *known == code) else {
            seen.push((code, Some(variant)));
            continue;
        };
        let other = match other {
            Some(other) => say!("variant `{}`", other.key.spelled()),
            None => say!("the device without variants"),
        };
        let name = variant.key.spelled();
        let message =
            say!("variant `{}` has the product code of {}: `{}`", name, other, format!("0x{code:X}"));
        let finding = Diagnostic::new(&SHARED_PRODUCT_CODE, variant.key.span, message);
        findings.push(finding.help("give it a different `device.product-number`"));
    }
}

/// The product code that a table states.
fn product_code(tree: &KeyedTree) -> Option<i128> {
    let at = |path: &[&str]| match &*path.iter().try_fold(tree, |tree, key| tree.get(key))?.kind {
        Kind::Integer(number) => Some(*number),
        _ => None,
    };
    at(&["object", "1018", "sub", "2", "default"]).or_else(|| at(&["device", "product-number"]))
}

/// The keys of a variant in the file.
fn own<'t>(tree: &'t KeyedTree, name: &str) -> Option<&'t KeyedTree> {
    let variants = tree.get("variant").and_then(KeyedTree::entries).unwrap_or_default();
    variants.iter().find(|entry| entry.key.spelled() == name).map(|entry| &entry.value)
}

/// The tree of a variant.
pub(super) fn merged(base: Merged, name: &str, findings: &mut Findings) -> Merged {
    let Some(own) = own(&base.tree, name).cloned() else { return base };
    let Some(section) = KeyedTable::new(name, &own, variant_keys(), findings) else { return base };
    let entries = own.entries().unwrap_or_default().iter();
    let known = entries.filter(|entry| variant_keys().iter().any(|key| key.name == entry.key.spelled()));
    base.with(&KeyedTree::new(section.span(), Kind::Map(known.cloned().collect())))
}

/// Sets the file name of a variant that does not state one.
pub(super) fn name_file(tree: &KeyedTree, variant: &str, device: &mut Device) {
    let has_own = |tree: &KeyedTree| tree.get("file").is_some_and(|file| file.get("file-name").is_some());
    let name = device.file_info.as_mut().and_then(|info| info.file_name.as_mut());
    if let Some(name) = name.filter(|_| !own(tree, variant).is_some_and(has_own)) {
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "eds"));
        *name = format!("{stem}-{variant}.{ending}");
    }
}
