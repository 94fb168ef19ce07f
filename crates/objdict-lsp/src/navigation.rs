//! From one place to others: definition, references, links.

use std::path::{Path, PathBuf};

use super::file::CheckedFile;
use super::mentions::mention_at;
use super::mentions::{named_files, node_mention_at, path_of_node};
use super::position::Positions;
use super::protocol::{DocumentLink, Location, Range};
use super::uri::of_path;
use super::workspace::EditorWorkspace;
use objdict_format::Description;
use objdict_format::mention::{Mention, MentionKind};
use objdict_model::model::{Device, Field, Part, Place};
use objdict_model::source::{Span, absolute};
use objdict_project::check::last_eds;

/// Where what an offset names is described.
pub(super) fn definition(file: &CheckedFile, offset: u32) -> Option<Location> {
    match file.description() {
        Some(description) => in_description(file, description, offset),
        None => in_network(file, offset),
    }
}

fn in_description(file: &CheckedFile, description: &Description, offset: u32) -> Option<Location> {
    if let Some(mention) =
        mention_at(description, offset).filter(|mention| mention.kind != MentionKind::Section)
    {
        let span = description.locate(&described(description.device(), &mention)?)?;
        return Some(Location::new(file.uri.clone(), file.positions().range(span)));
    }
    let place = file.place(offset)?;
    let is_origin = place == Place::of(Part::FileInfo).field(Field::LastEds);
    let origin = description.origin().filter(|_| is_origin)?;
    Some(Location::new(of_path(Path::new(origin.source().name()))?, Range::default()))
}

/// The place of what is mentioned: the sub-index, else its object.
fn described(device: &Device, mention: &Mention) -> Option<Place> {
    device.object(mention.index)?;
    Some(match mention.sub {
        Some(sub) => device.entry_place(mention.index, sub),
        None => Place::object(mention.index),
    })
}

/// The description of a node, or the place in it.
fn in_network(file: &CheckedFile, offset: u32) -> Option<Location> {
    if let Some(found) = node_mention_at(file, offset) {
        let description = file.analysis.network()?.description(found.node)?;
        let place = described(description.device(), &found.mention);
        let span = place.and_then(|place| description.locate(&place)).unwrap_or_default();
        let positions = Positions::new(description.source(), file.unit);
        return Some(Location::new(of_path(&path_of_node(file, found.node)?)?, positions.range(span)));
    }
    let is_here = |span: Span| span.start <= offset && offset <= span.end;
    let named = named_files(file).into_iter().find(|named| is_here(named.span))?;
    Some(Location::new(of_path(&named.path)?, Range::default()))
}

/// All places that mention the object under the cursor: in its description, in those of its type and its nodes, and in networks.
pub(super) fn references(file: &CheckedFile, workspace: &mut EditorWorkspace, offset: u32) -> Vec<Location> {
    let Some((path, index, sub)) = subject_at(file, offset) else { return Vec::new() };
    let is_it =
        |mention: &Mention| mention.is_of(index, sub) || mention.index == index && mention.sub.is_none();
    let mut found = Vec::new();
    for (file, mentions) in workspace.naming(&path) {
        let mut spans: Vec<Span> = mentions.into_iter().filter(is_it).map(|mention| mention.span).collect();
        spans.dedup();
        found.extend(
            spans.into_iter().map(|span| Location::new(file.uri.clone(), file.positions().range(span))),
        );
    }
    found
}

/// The object or entry that an offset mentions, or in whose section it is, and the file of its description.
fn subject_at(file: &CheckedFile, offset: u32) -> Option<(PathBuf, u16, Option<u8>)> {
    let Some(description) = file.description() else {
        let found = node_mention_at(file, offset)?;
        return Some((path_of_node(file, found.node)?, found.mention.index, found.mention.sub));
    };
    let path = absolute(file.source().name().as_ref());
    if let Some(mention) = mention_at(description, offset) {
        return Some((path, mention.index, mention.sub));
    }
    let part = file.place(offset)?.part;
    let sub = if let Part::Entry(_, sub) = part { Some(sub) } else { None };
    Some((path, part.object()?, sub))
}

/// The files that a text names.
pub(super) fn links(file: &CheckedFile) -> Vec<DocumentLink> {
    let of_network = named_files(file).into_iter();
    let mut found: Vec<(Span, PathBuf)> = of_network.map(|named| (named.span, named.path)).collect();
    if let Some(description) = file.description() {
        let last = Place::of(Part::FileInfo).field(Field::LastEds);
        let beside = last_eds(description).map(|name| Path::new(file.source().name()).with_file_name(name));
        let beside = beside.filter(|path| objdict_model::source::is_file(path));
        found.extend(description.locate(&last).zip(beside));
        if let Some(((_, span), path)) = description.extended().zip(description.extended_files().first()) {
            found.push((span, path.clone()));
        }
    }
    let link = |(span, path): (Span, PathBuf)| DocumentLink {
        range: file.positions().range(span),
        target: of_path(&path),
    };
    found.into_iter().map(link).collect()
}
