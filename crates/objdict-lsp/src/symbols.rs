//! The outline of a file, what can be folded, and ranges around a place.

use super::file::CheckedFile;
use super::protocol::{
    DocumentSymbol, FoldingRange, Location, Position, Range, SelectionRange, SymbolInformation, SymbolKind,
};
use super::words;
use objdict_eds::eds::SectionName;
use objdict_format::Description;
use objdict_model::model::{Part, Place};
use objdict_model::source::Span;

/// A section of the text, up to the next one.
struct SectionSymbol {
    name: Span,
    span: Span,
    part: Part,
}

/// The sections of an EDS or DCF.
fn blocks(description: &Description) -> Vec<SectionSymbol> {
    let Some(document) = description.document() else { return Vec::new() };
    let text = document.text();
    let mut blocks: Vec<SectionSymbol> = Vec::new();
    document.visit(
        |section| {
            let Some(header) = section.header else { return };
            let last = section.entries.last().map(|entry| entry.value.end.max(entry.key.end));
            let span = Span::new(header.line.start, last.unwrap_or(header.line.end));
            let part = SectionName::parse(header.name.of(text)).part;
            blocks.push(SectionSymbol { name: header.name, span, part });
        },
        |_| {},
    );
    blocks
}

/// The areas of the object dictionary (CiA 301 §7.4.1), by their first index.
const AREAS: [(u16, &str); 5] = [
    (0xA000, "Network variables and system"),
    (0x6000, "Device profile"),
    (0x2000, "Manufacturer"),
    (0x1000, "Communication"),
    (0, "Data types"),
];

fn area(index: u16) -> &'static str {
    AREAS.iter().find(|(first, _)| index >= *first).map_or("", |(_, name)| name)
}

/// The outline: areas, their objects, and the sub-indexes of these.
pub(super) fn outline(file: &CheckedFile) -> Vec<DocumentSymbol> {
    let Some(description) = file.description() else { return of_network(file) };
    let blocks = match description.document() {
        Some(_) => blocks(description),
        None => of_model(description),
    };
    let mut areas: Vec<DocumentSymbol> = Vec::new();
    for block in &blocks {
        if matches!(block.part, Part::List(_)) {
            let name = block.name.of(file.text()).to_owned();
            areas.push(symbol(file, name, None, SymbolKind::ARRAY, block.span, block.name));
            continue;
        }
        let (name, kind) = match block.part.object() {
            Some(index) => (area(index), SymbolKind::NAMESPACE),
            None => ("File and device", SymbolKind::FILE),
        };
        if areas.last().is_none_or(|area| area.name != name) {
            areas.push(symbol(file, name.to_owned(), None, kind, block.span, block.name));
        }
        let Some(area) = areas.last_mut() else { continue };
        add(file, description, area, block);
    }
    areas
}

/// Adds a section to its area, below the object that it belongs to.
fn add(file: &CheckedFile, description: &Description, area: &mut DocumentSymbol, block: &SectionSymbol) {
    let device = description.device();
    let (name, detail, kind) = match block.part {
        Part::Object(index) => (format!("{index:04X}"), words::name(device, index, None), SymbolKind::OBJECT),
        Part::Entry(index, sub) => {
            let entry = device.object(index).and_then(|object| object.entry(sub));
            (format!("{index:04X}:{sub:02X}"), entry.map(|entry| entry.name.to_string()), SymbolKind::FIELD)
        }
        _ => (block.name.of(file.text()).to_owned(), None, SymbolKind::STRUCT),
    };
    let made = symbol(file, name, detail, kind, block.span, block.name);
    area.range.end = area.range.end.max(made.range.end);
    let siblings = area.children.get_or_insert_default();
    let owner = block.part.object().filter(|_| !matches!(block.part, Part::Object(_)));
    let parent =
        siblings.last_mut().filter(|last| owner.is_some_and(|index| last.name == format!("{index:04X}")));
    match parent {
        Some(parent) => {
            parent.range.end = parent.range.end.max(made.range.end);
            parent.children.get_or_insert_default().push(made);
        }
        None => siblings.push(made),
    }
}

/// The same of a text with other places: its objects and entries.
fn of_model(description: &Description) -> Vec<SectionSymbol> {
    let mut blocks = Vec::new();
    let mut take = |part: Part| {
        if let Some(name) = description.locate(&Place::of(part.clone())) {
            blocks.push(SectionSymbol { name, span: name, part });
        }
    };
    for (&index, object) in &description.described().objects {
        take(Part::Object(index));
        object.subs.iter().for_each(|(sub, _)| take(Part::Entry(index, sub)));
    }
    blocks
}

/// The nodes of a network.
fn of_network(file: &CheckedFile) -> Vec<DocumentSymbol> {
    let network = file.analysis.network().and_then(|file| file.network());
    let nodes = network.into_iter().flat_map(|network| &network.nodes);
    let symbols = nodes.map(|node| {
        let id = node.node_id.as_ref().map(|id| format!("node-ID {}", id.value));
        symbol(file, node.name.value.clone(), id, SymbolKind::MODULE, node.name.at, node.name.at)
    });
    symbols.collect()
}

fn symbol(
    file: &CheckedFile,
    name: String,
    detail: Option<String>,
    kind: SymbolKind,
    span: Span,
    selected: Span,
) -> DocumentSymbol {
    let (range, selection_range) = (file.positions().range(span), file.positions().range(selected));
    // a name that is empty is refused
    let name = if name.is_empty() { "?".to_owned() } else { name };
    DocumentSymbol { name, kind, range, selection_range, detail, children: None }
}

/// The objects of a file whose index or name has a text.
pub(super) fn found(file: &CheckedFile, query: &str) -> Vec<SymbolInformation> {
    let Some(description) = file.description() else { return Vec::new() };
    let wanted = query.trim().trim_start_matches("0x").to_lowercase();
    let mut found = Vec::new();
    for (&index, object) in &description.described().objects {
        let name = format!("{index:04X} {}", object.name());
        if !name.to_lowercase().contains(&wanted) {
            continue;
        }
        let Some(span) = description.locate(&Place::object(index)) else { continue };
        let location = Location::new(file.uri.clone(), file.positions().range(span));
        let (kind, container_name) = (SymbolKind::OBJECT, area(index));
        found.push(SymbolInformation { name, kind, location, container_name });
    }
    found
}

/// The sections, and the objects with their sub-indexes.
pub(super) fn folds(file: &CheckedFile) -> Vec<FoldingRange> {
    let mut folds = Vec::new();
    let mut symbols: Vec<DocumentSymbol> = outline(file);
    while let Some(symbol) = symbols.pop() {
        let (start, end) = (symbol.range.start.line, symbol.range.end.line);
        // an area begins with the line of its first section, which folds that section
        let is_area = [SymbolKind::NAMESPACE, SymbolKind::FILE].contains(&symbol.kind);
        if end > start && !is_area {
            folds.push(FoldingRange { start_line: start, end_line: end, kind: "region" });
        }
        symbols.extend(symbol.children.unwrap_or_default());
    }
    folds.sort_by_key(|fold| (fold.start_line, fold.end_line));
    folds
}

/// The ranges around a position: word, line, section, object, area, file.
pub(super) fn around(file: &CheckedFile, position: Position) -> SelectionRange {
    let offset = file.offset(position);
    let (text, lines) = (file.text(), file.source().lines());
    let line = lines.line_span(text, lines.line_of(text, offset));
    let line = Span::new(line.start, line.start + line.of(text).trim_end().len() as u32);
    let mut ranges = vec![file.positions().range(Span::new(0, text.len() as u32))];
    let mut level = outline(file);
    let is_inside = |range: &Range| range.start <= position && position <= range.end;
    while let Some(symbol) = level.into_iter().find(|symbol| is_inside(&symbol.range)) {
        ranges.push(symbol.range);
        level = symbol.children.unwrap_or_default();
    }
    ranges.extend([line, file.word(offset)].map(|span| file.positions().range(span)));
    ranges.dedup();
    // each is inside of the one before
    let mut parent: Option<SelectionRange> = None;
    for range in ranges {
        let outer = parent.as_ref().map(|parent| parent.range);
        if outer.is_none_or(|outer| outer.start <= range.start && range.end <= outer.end) {
            parent = Some(SelectionRange { range, parent: parent.map(Box::new) });
        }
    }
    parent.unwrap_or(SelectionRange { range: Range::new(position, position), parent: None })
}
