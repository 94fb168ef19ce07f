//! From one place to others: definition, references, links, and new names for objects.

use std::path::{Path, PathBuf};

use lsp_types::{
    DocumentLink, GotoDefinitionResponse, Location, PrepareRenameResponse, Range, WorkspaceEdit,
};

use super::file::File;
use super::mentions::{Mention, MentionKind, mention_at, mentions};
use super::network::named;
use super::uri::of_path;
use super::workspace::Workspace;
use crate::check::last_eds;
use crate::format::Description;
use crate::model::{Field, Part, Place};
use crate::source::Span;

/// Where what an offset names is described.
pub(super) fn definition(
    file: &File,
    workspace: &mut Workspace,
    offset: u32,
) -> Option<GotoDefinitionResponse> {
    let location = match file.description() {
        Some(description) => in_description(file, description, offset)?,
        None => in_network(file, workspace, offset)?,
    };
    Some(GotoDefinitionResponse::Scalar(location))
}

fn in_description(file: &File, description: &Description, offset: u32) -> Option<Location> {
    if let Some(mention) =
        mention_at(description, offset).filter(|mention| mention.kind != MentionKind::Section)
    {
        let span = described(description, &mention)?;
        return Some(Location::new(file.uri.clone(), file.positions().range(span)));
    }
    let place = file.place(offset)?;
    let is_origin = place == Place::of(Part::FileInfo).field(Field::LastEds);
    let origin = description.origin().filter(|_| is_origin)?;
    Some(Location::new(of_path(Path::new(origin.source().name()))?, Range::default()))
}

/// Where the description has what is mentioned: the sub-index, else its object.
fn described(description: &Description, mention: &Mention) -> Option<Span> {
    let sub = mention.sub.unwrap_or(0);
    let device = description.device();
    device.object(mention.index)?;
    let place = mention.sub.map_or(Place::object(mention.index), |_| device.entry_place(mention.index, sub));
    description.locate(&place)
}

fn in_network(file: &File, workspace: &mut Workspace, offset: u32) -> Option<Location> {
    let named =
        named(file).into_iter().find(|named| named.span.start <= offset && offset <= named.span.end)?;
    let uri = of_path(&named.file)?;
    let range = named.place.and_then(|place| {
        let other = workspace.file(&uri)?;
        let span = other.description()?.locate(&place)?;
        Some(other.positions().range(span))
    });
    Some(Location::new(uri, range.unwrap_or_default()))
}

/// All places of a file that mention the object under the cursor.
pub(super) fn references(file: &File, offset: u32) -> Vec<Location> {
    let Some(description) = file.description() else { return Vec::new() };
    let Some((index, sub)) = subject_at(file, description, offset) else { return Vec::new() };
    let is_it = |mention: &Mention| {
        mention.index == index && (sub.is_none() || mention.sub.is_none() || mention.sub == sub)
    };
    let found = mentions(description).into_iter().filter(is_it);
    found.map(|found| Location::new(file.uri.clone(), file.positions().range(found.span))).collect()
}

/// The object or entry that an offset mentions, or in whose section it is.
fn subject_at(file: &File, description: &Description, offset: u32) -> Option<(u16, Option<u8>)> {
    if let Some(mention) = mention_at(description, offset) {
        return Some((mention.index, mention.sub));
    }
    let part = file.place(offset)?.part;
    let sub = if let Part::Entry(_, sub) = part { Some(sub) } else { None };
    Some((part.object()?, sub))
}

/// The digits that a new index replaces; `None` where no object of an EDS or DCF is named.
pub(super) fn prepare_rename(file: &File, offset: u32) -> Option<PrepareRenameResponse> {
    let description = file.description().filter(|description| description.document().is_some())?;
    let mention = mention_at(description, offset)?;
    let digits = mention.index_digits(file.text())?;
    let range = file.positions().range(digits);
    Some(PrepareRenameResponse::RangeWithPlaceholder { range, placeholder: format!("{:04X}", mention.index) })
}

/// Gives an object another index, in sections, lists, links and mappings.
///
/// # Errors
/// When the name is not an index, or is that of another object.
pub(super) fn rename(file: &File, offset: u32, new: &str) -> Result<WorkspaceEdit, String> {
    let nothing = || "there is no object of an EDS or DCF here".to_owned();
    let description = file.description().filter(|description| description.document().is_some());
    let description = description.ok_or_else(nothing)?;
    let mention = mention_at(description, offset).ok_or_else(nothing)?;
    let digits = new.trim().trim_start_matches("0x").trim_end_matches('h');
    let index = u16::from_str_radix(digits, 16).map_err(|_| format!("`{new}` is not an index"))?;
    if index != mention.index && description.device().object(index).is_some() {
        return Err(format!("there is an object {index:04X}h already"));
    }
    let places = mentions(description).into_iter().filter(|other| other.index == mention.index);
    let digits = places.filter_map(|place| place.index_digits(file.text()));
    let edits = file.edits(digits.map(|span| (span, format!("{index:04X}"))).collect());
    Ok(file.workspace_edit(edits))
}

/// The files that a text names.
pub(super) fn links(file: &File) -> Vec<DocumentLink> {
    let of_network = named(file).into_iter().filter(|named| named.place.is_none());
    let mut found: Vec<(Span, PathBuf)> = of_network.map(|named| (named.span, named.file)).collect();
    if let Some(description) = file.description() {
        let last = Place::of(Part::FileInfo).field(Field::LastEds);
        let beside = last_eds(description).map(|name| Path::new(file.source().name()).with_file_name(name));
        let beside = beside.filter(|path| crate::source::is_file(path));
        found.extend(description.locate(&last).zip(beside));
        if let Some(((_, span), path)) = description.extended().zip(description.extended_files().first()) {
            found.push((span, path.clone()));
        }
    }
    let link = |(span, path): (Span, PathBuf)| DocumentLink {
        range: file.positions().range(span),
        target: of_path(&path),
        tooltip: None,
        data: None,
    };
    found.into_iter().map(link).collect()
}
