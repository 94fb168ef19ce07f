//! Where a file mentions objects: sections, lists, links and mappings of a description, and nodes of a network; and what a
//! network file names: descriptions, nodes and their entries.

use std::path::PathBuf;

use super::file::CheckedFile;
use objdict_eds::eds::SectionName;
use objdict_eds::ini::Section;
use objdict_format::Description;
use objdict_format::mention::{Digits, Mention, MentionKind};
use objdict_model::model::{Part, PdoKind};
use objdict_model::source::{Span, absolute};
use objdict_network_file::NodeMention;
use objdict_xdd::xml::{Attribute, Element, Tree};

/// All mentions, in the order of the text.
pub(super) fn mentions(description: &Description) -> Vec<Mention> {
    let mut found = Vec::new();
    if let Some(document) = description.document() {
        document.visit(|section| of_section(document.text(), section, &mut found), |_| {});
    } else if let Some(tree) = description.tree() {
        of_tree(tree, &mut found);
    } else if let Some(of_toml) = description.toml_mentions() {
        found = of_toml;
    }
    found.sort_by_key(|mention| mention.span.start);
    found
}

/// The mention that an offset is in.
pub(super) fn mention_at(description: &Description, offset: u32) -> Option<Mention> {
    mentions(description).into_iter().find(|mention| mention.has(offset))
}

/// What a file mentions of the objects that one of these files describes.
pub(super) fn mentions_of(file: &CheckedFile, described: &[PathBuf]) -> Vec<Mention> {
    if let Some(description) = file.description() {
        let is_it = described.contains(&absolute(file.source().name().as_ref()));
        return if is_it { mentions(description) } else { Vec::new() };
    }
    let Some(network) = file.analysis.network() else { return Vec::new() };
    let is_it = |node: usize| path_of_node(file, node).is_some_and(|path| described.contains(&path));
    let found = network.mentions().into_iter().filter(|found| is_it(found.node));
    found.map(|found| found.mention).collect()
}

fn of_section(text: &str, section: &Section, found: &mut Vec<Mention>) {
    let Some(header) = section.header else { return };
    let part = SectionName::parse(header.name.of(text)).part;
    if let Some(index) = part.object() {
        let sub = if let Part::Entry(_, sub) = part { Some(sub) } else { None };
        found.push(of_header(text, header.name, index, sub));
    }
    let values = section.entries.iter().map(|entry| (entry.key.of(text), entry.value));
    match part {
        Part::List(_) | Part::Links(_) => {
            let items = values.filter(|(key, _)| key.bytes().all(|byte| byte.is_ascii_digit()));
            found.extend(items.filter_map(|(_, span)| {
                let index = u16::try_from(number(span.of(text))?).ok()?;
                let index_at = Some(Digits::of_number(text, span));
                let kind = MentionKind::List;
                Some(Mention { kind, span, index, sub: None, index_at, sub_at: None, last: None })
            }));
        }
        Part::Entry(index, 1..) | Part::CompactValues(index) if PdoKind::of_mapping(index).is_some() => {
            let is_value = |key: &str| {
                let names = ["DefaultValue", "ParameterValue"];
                matches!(part, Part::CompactValues(_)) && key.bytes().all(|byte| byte.is_ascii_digit())
                    || names.iter().any(|name| name.eq_ignore_ascii_case(key))
            };
            let values = values.filter(|(key, _)| is_value(key));
            found.extend(
                values.filter_map(|(_, span)| Mention::of_mapping(text, span, number(span.of(text))?)),
            );
        }
        _ => {}
    }
}

/// The name of a section: `6041`, `1018sub1`, `1018Value`.
fn of_header(text: &str, span: Span, index: u16, sub: Option<u8>) -> Mention {
    let name = span.of(text).to_ascii_lowercase();
    let digits = format!("{index:x}");
    let index_at = name.find(&digits).map(|at| {
        let start = span.start + at as u32;
        Digits::hex(Span::new(start, start + digits.len() as u32))
    });
    let sub_at = sub.zip(name.find("sub")).and_then(|(_, at)| {
        let from = at + "sub".len();
        let width = name[from..].bytes().take_while(u8::is_ascii_hexdigit).count();
        let start = span.start + from as u32;
        (width > 0).then(|| Digits::hex(Span::new(start, start + width as u32)))
    });
    Mention { kind: MentionKind::Section, span, index, sub, index_at, sub_at, last: None }
}

/// The attributes of objects and sub-objects, and the values of mapping parameters.
fn of_tree(tree: &Tree, found: &mut Vec<Mention>) {
    let text = tree.text();
    let hex = |span: Span| u16::from_str_radix(span.of(text), 16).ok();
    for object in tree.root().into_iter().flat_map(Element::descendants) {
        if object.name() != "CANopenObject" {
            continue;
        }
        let Some(at) = object.attribute("index").map(Attribute::value_span) else { continue };
        let Some(index) = hex(at) else { continue };
        let kind = MentionKind::Section;
        let (index_at, sub_at, last) = (Some(Digits::hex(at)), None, None);
        found.push(Mention { kind, span: at, index, sub: None, index_at, sub_at, last });
        for entry in object.children() {
            let Some(at) = entry.attribute("subIndex").map(Attribute::value_span) else {
                continue;
            };
            let Some(sub) = hex(at).and_then(|sub| u8::try_from(sub).ok()) else { continue };
            let (sub_at, index_at) = (Some(Digits::hex(at)), None);
            found.push(Mention { kind, span: at, index, sub: Some(sub), index_at, sub_at, last });
            if sub == 0 || PdoKind::of_mapping(index).is_none() {
                continue;
            }
            let values = ["defaultValue", "actualValue"].into_iter().filter_map(|name| entry.attribute(name));
            found.extend(values.filter_map(|value| {
                let span = value.value_span();
                Mention::of_mapping(text, span, number(span.of(text))?)
            }));
        }
    }
}

/// A number in hex or decimal, as lists and mappings have it.
fn number(text: &str) -> Option<u32> {
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u32::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

/// The description of a node that the text names.
pub(super) struct NamedFile {
    pub(super) span: Span,
    pub(super) path: PathBuf,
}

/// All descriptions that a network names, in the order of its nodes.
pub(super) fn named_files(file: &CheckedFile) -> Vec<NamedFile> {
    let network = file.analysis.network();
    let nodes = network.and_then(|of_file| of_file.network()).map(|network| &network.nodes[..]);
    let nodes = nodes.unwrap_or_default().iter().enumerate();
    nodes
        .filter_map(|(number, node)| {
            Some(NamedFile { span: node.file.at, path: path_of_node(file, number)? })
        })
        .collect()
}

/// The file that describes a node.
pub(super) fn path_of_node(file: &CheckedFile, node: usize) -> Option<PathBuf> {
    let description = file.analysis.network()?.description(node)?;
    Some(absolute(description.source().name().as_ref()))
}

/// The entry of a node that an offset names.
pub(super) fn node_mention_at(file: &CheckedFile, offset: u32) -> Option<NodeMention> {
    let mentions = file.analysis.network()?.mentions();
    mentions.into_iter().find(|found| found.mention.has(offset))
}
