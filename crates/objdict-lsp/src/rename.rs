//! Another index or sub-index, in all files that name it.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::file::CheckedFile;
use super::mentions::mention_at;
use super::mentions::{node_mention_at, path_of_node};
use super::protocol::{Renamed, WorkspaceEdit};
use super::workspace::EditorWorkspace;
use objdict_format::mention::{Digits, Mention, MentionKind};
use objdict_model::model::Device;
use objdict_model::source::{Span, absolute, shown};

/// What gets another number.
struct RenamedPart {
    /// The description that it is in.
    path: PathBuf,
    index: u16,
    /// The sub-index, if that and not the index is under the cursor.
    sub: Option<u8>,
    /// The digits under the cursor.
    digits: Digits,
}

impl RenamedPart {
    /// What is under the cursor.
    fn at(file: &CheckedFile, offset: u32) -> Result<Self, String> {
        const NOTHING: &str = "put the cursor on the index or sub-index of an object";
        let own = || absolute(file.source().name().as_ref());
        let found = match file.description() {
            Some(description) => mention_at(description, offset).map(|mention| (own(), mention)),
            None => node_mention_at(file, offset)
                .and_then(|found| Some((path_of_node(file, found.node)?, found.mention))),
        };
        let (path, mention) = found.ok_or(NOTHING)?;
        let is_here = |digits: &Digits| digits.span.start <= offset && offset <= digits.span.end;
        let (digits, sub) = match (mention.index_at.filter(is_here), mention.sub_at.filter(is_here)) {
            (Some(digits), _) => (digits, None),
            (None, Some(digits)) => (digits, mention.sub),
            (None, None) if mention.index_at.is_some() => return Err(NOTHING.to_owned()),
            (None, None) => return Err(unnumbered(file, &mention)),
        };
        Ok(Self { path, index: mention.index, sub, digits })
    }

    /// The new number of a text, which nothing else of a device has.
    fn number(&self, text: &str, device: &Device) -> Result<u16, String> {
        let digits = text.trim();
        let digits = digits.strip_prefix("0x").or_else(|| digits.strip_suffix('h')).unwrap_or(digits);
        let number = u16::from_str_radix(digits, 16).ok().filter(|_| !digits.starts_with('+'));
        match self.sub {
            None => {
                let index = number.filter(|index| *index > 0).ok_or(format!("`{text}` is not an index"))?;
                let is_taken = index != self.index && device.object(index).is_some();
                if is_taken { Err(format!("object {index:04X}h already exists")) } else { Ok(index) }
            }
            Some(old) => {
                let sub = number.and_then(|sub| u8::try_from(sub).ok());
                let sub = sub.ok_or_else(|| format!("`{text}` is not a sub-index"))?;
                let object = device.object(self.index).filter(|object| sub != old && object.has(sub));
                match object {
                    Some(_) => Err(format!("sub-index {sub:02X} of {:04X}h already exists", self.index)),
                    None => Ok(sub.into()),
                }
            }
        }
    }

    fn is_of(&self, mention: &Mention) -> bool {
        mention.is_of(self.index, self.sub)
    }

    /// The edits of a file for what it mentions.
    fn edits(
        &self,
        file: &CheckedFile,
        mentions: &[Mention],
        number: u16,
    ) -> Result<Vec<(Span, String)>, String> {
        let mut edits = Vec::new();
        for mention in mentions.iter().filter(|mention| self.is_of(mention)) {
            let digits = if self.sub.is_some() { mention.sub_at } else { mention.index_at };
            match digits {
                Some(digits) => edits.push(digits.replaced(number)),
                // its index is that of the table or element that it is in
                None if self.sub.is_none() && mention.kind == MentionKind::Section => {}
                // a name stays the same
                None if mention.index_at.is_none() && mention.kind == MentionKind::List => {}
                None => return Err(unnumbered(file, mention)),
            }
        }
        edits.sort_by_key(|(span, _)| span.start);
        edits.dedup();
        Ok(edits)
    }
}

/// Why what is mentioned cannot get another number.
fn unnumbered(file: &CheckedFile, mention: &Mention) -> String {
    let (text, name) = (mention.span.of(file.text()), file.name());
    match mention.last {
        Some(_) => format!("`{text}` in `{name}` names several sub-indexes; write them one by one first"),
        None => format!("`{text}` in `{name}` has no digits of this number; write it in hex first"),
    }
}

/// Why the objects of a file keep their numbers.
fn refusal(file: &CheckedFile, target: &RenamedPart) -> Option<String> {
    let (description, name) = (file.description()?, file.name());
    if description.source().is_read_only() || description.is_project() {
        return Some(format!("`{name}` is only read, not changed"));
    }
    if description.device_count() > 1 {
        return Some(format!("`{name}` describes several devices"));
    }
    if target.sub.is_some_and(|_| {
        description.device().object(target.index).is_some_and(|object| object.compact.is_some())
    }) {
        return Some(format!(
            "{:04X}h is stored compactly in `{name}`; describe its sub-indexes one by one first",
            target.index
        ));
    }
    None
}

/// The digits that a new number replaces.
///
/// # Errors
/// When nothing with digits is there, or the file cannot be changed: why.
pub(super) fn prepare(file: &CheckedFile, offset: u32) -> Result<Renamed, String> {
    let target = RenamedPart::at(file, offset)?;
    match refusal(file, &target) {
        Some(reason) => Err(reason),
        None => {
            let range = file.positions().range(target.digits.span);
            let placeholder = match target.sub {
                Some(sub) => format!("{sub:X}"),
                None => format!("{:04X}", target.index),
            };
            Ok(Renamed { range, placeholder })
        }
    }
}

/// Gives an object another index, or an entry another sub-index: in its description, in those of its type and of its nodes, and in
/// the networks of the folders.
///
/// # Errors
/// When the name is no such number, is that of another object, or a file does not say the same with it.
pub(super) fn rename(
    file: &CheckedFile,
    workspace: &mut EditorWorkspace,
    offset: u32,
    new: &str,
) -> Result<WorkspaceEdit, String> {
    let target = RenamedPart::at(file, offset)?;
    let mut changes = BTreeMap::new();
    let mut number = None;
    for (other, mentions) in workspace.naming(&target.path) {
        if let Some(description) = other.description() {
            number = Some(target.number(new, description.device())?);
        }
        let number = number.ok_or_else(|| format!("`{}` cannot be read", shown(&target.path)))?;
        let edits = target.edits(&other, &mentions, number)?;
        if edits.is_empty() {
            continue;
        }
        if let Some(reason) = refusal(&other, &target) {
            return Err(reason);
        }
        if !workspace.reading(|| says_the_same(&other, &target, number, &edits)) {
            return Err(format!("the meaning of `{}` would change", other.name()));
        }
        changes.insert(other.uri.clone(), other.edits(edits));
    }
    Ok(WorkspaceEdit::new(changes))
}

/// Whether a text mentions with its edits what it mentioned before, under the new number.
fn says_the_same(file: &CheckedFile, target: &RenamedPart, number: u16, edits: &[(Span, String)]) -> bool {
    let Some(after) = file.again_with(edits) else { return false };
    let (index, sub) = match target.sub {
        Some(_) => (target.index, u8::try_from(number).ok()),
        None => (number, None),
    };
    let count = |file: &CheckedFile, index, sub| {
        let mentions = match (file.description(), file.analysis.network()) {
            (Some(description), _) => super::mentions::mentions(description),
            (None, Some(network)) => network.mentions().into_iter().map(|found| found.mention).collect(),
            (None, None) => Vec::new(),
        };
        mentions.iter().filter(|mention| mention.is_of(index, sub)).count()
    };
    let is_same = (target.index, target.sub) == (index, sub);
    let objects =
        |file: &CheckedFile| file.description().map(|description| description.device().objects.len());
    let before = count(file, target.index, target.sub);
    let clash = if is_same { 0 } else { count(file, index, sub) };
    objects(file) == objects(&after) && count(&after, index, sub) == before + clash
}
