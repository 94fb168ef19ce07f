//! What is shown beside the text: names of mapped objects, COB-IDs of the node, bits of PDOs; and what the words of an EDS or DCF
//! are, for their colours. There is no Tree-sitter grammar: the server knows more about a value than a grammar can express.

use super::file::CheckedFile;
use super::mentions::mentions;
use super::protocol::{CodeLens, Command, InlayHint, Range, SemanticTokens};
use super::words;
use objdict_document::describe::Decoder;
use objdict_eds::ini::LineKind;
use objdict_format::Description;
use objdict_format::mention::MentionKind;
use objdict_model::diagnostic::plural;
use objdict_model::model::{Device, Pdo, Place, Value};
use objdict_model::source::Span;

/// The bits of a frame.
const FRAME: u32 = 64;

/// The hints in a range of the text.
pub(super) fn hints(file: &CheckedFile, range: Range) -> Vec<InlayHint> {
    let Some(description) = file.description() else { return Vec::new() };
    let wanted = file.positions().span(range);
    let is_wanted = |span: &Span| wanted.start <= span.end && span.start <= wanted.end;
    let device = description.device();
    let mapped = mentions(description).into_iter().filter(|mention| mention.kind != MentionKind::Section);
    let names = mapped.filter(|mention| is_wanted(&mention.span)).filter_map(|mention| {
        let name = words::name(device, mention.index, mention.sub)?;
        Some(hint(file, mention.span, name))
    });
    let cob_ids =
        device.pdos().filter_map(|pdo| cob_id(description, &pdo)).filter(|(span, _)| is_wanted(span));
    let free =
        device.pdos().filter_map(|pdo| free_bits(description, &pdo)).filter(|(span, _)| is_wanted(span));
    let others = cob_ids.chain(free).map(|(span, text)| hint(file, span, text));
    names.chain(others).collect()
}

fn hint(file: &CheckedFile, span: Span, text: String) -> InlayHint {
    InlayHint { position: file.positions().of(span.end), label: text, padding_left: true }
}

/// The CAN-ID of a PDO whose COB-ID is a formula, or has flags.
fn cob_id(description: &Description, pdo: &Pdo<'_>) -> Option<(Span, String)> {
    let device = description.device();
    let index = pdo.communication_index();
    let value = device.object(index)?.value(1)?;
    let span = description.locate(&device.value_place(index, 1))?;
    let decoder = Decoder::english(device, device.node_id());
    Some((span, decoder.of(index, 1, &value)?))
}

/// How much of the frame is left, at the number of mapped objects.
fn free_bits(description: &Description, pdo: &Pdo<'_>) -> Option<(Span, String)> {
    let device = description.device();
    let index = pdo.mapping_index();
    pdo.mapped_count.filter(|count| *count <= 64)?;
    let span = description.locate(&device.value_place(index, 0))?;
    let free = FRAME.checked_sub(pdo.bit_length())?;
    Some((span, format!("{} free", plural(free as usize, "bit"))))
}

/// What each PDO carries, above its mapping parameter.
pub(super) fn lenses(file: &CheckedFile) -> Vec<CodeLens> {
    let Some(description) = file.description() else { return Vec::new() };
    let device = description.device();
    let lens = |pdo: Pdo<'_>| {
        let span = description.locate(&Place::object(pdo.mapping_index()))?;
        let command = Command { title: title(device, &pdo), ..Command::default() };
        Some(CodeLens { range: file.positions().range(span), command })
    };
    device.pdos().filter_map(lens).collect()
}

fn title(device: &Device, pdo: &Pdo<'_>) -> String {
    let mut parts = vec![format!("{pdo}: {} of {FRAME} bits", pdo.bit_length())];
    let names = pdo.mapped().filter_map(|mapped| words::name(device, mapped.index, Some(mapped.sub)));
    let names: Vec<String> = names.collect();
    if !names.is_empty() {
        parts.push(names.join(", "));
    }
    let decoder = Decoder::english(device, device.node_id());
    let number = pdo.communication_index();
    let words = |sub: u8, value: &Value| decoder.of(number, sub, value);
    let object = device.object(number);
    let value = |sub: u8| object.and_then(|object| words(sub, object.value(sub)?.as_ref()));
    parts.extend([value(1), value(2)].into_iter().flatten());
    parts.join(" | ")
}

/// The kinds of words; a token names one by its position.
pub(super) const KINDS: [&str; 6] = ["comment", "namespace", "property", "number", "string", "macro"];
const COMMENT: u32 = 0;
const SECTION: u32 = 1;
const KEY: u32 = 2;
const NUMBER: u32 = 3;
const TEXT: u32 = 4;
const FORMULA: u32 = 5;

/// The tokens of a text, each relative to the one before.
pub(super) fn tokens(file: &CheckedFile) -> Option<SemanticTokens> {
    let document = file.description()?.document()?;
    let text = document.text();
    let mut data = Vec::new();
    let mut last = (0, 0);
    let mut push = |span: Span, kind: u32| {
        let range = file.positions().range(span);
        let (line, start) = (range.start.line, range.start.character);
        let delta_start = if line == last.0 { start - last.1 } else { start };
        let length = range.end.character - start;
        if length > 0 {
            // without modifiers
            data.extend([line - last.0, delta_start, length, kind, 0]);
            last = (line, start);
        }
    };
    for line in document.lines() {
        match line.kind {
            LineKind::Comment => push(line.span, COMMENT),
            LineKind::Section { name } => push(name, SECTION),
            LineKind::Entry { key, value } => {
                push(key, KEY);
                push(value, kind_of(value.of(text)));
            }
            LineKind::Blank | LineKind::Junk => {}
        }
    }
    Some(SemanticTokens { data })
}

fn kind_of(value: &str) -> u32 {
    let lower = value.to_ascii_lowercase();
    let digits = lower.strip_prefix("0x").unwrap_or(&lower);
    let is_number = !digits.is_empty()
        && (digits.len() < lower.len() && digits.bytes().all(|byte| byte.is_ascii_hexdigit())
            || digits.trim_start_matches('-').bytes().all(|byte| byte.is_ascii_digit()));
    match () {
        () if lower.contains("$nodeid") => FORMULA,
        () if is_number => NUMBER,
        () => TEXT,
    }
}
