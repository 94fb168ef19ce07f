//! What can be written in files of keys: networks, `device.toml`, patches, `objdict.toml`.

use std::path::Path;
use std::sync::LazyLock;

use serde_json::{Value, json};

use super::completion_item::item;
use super::cursor::{Cursor, CursorSpot};
use super::file::CheckedFile;
use super::protocol::{CompletionItem, CompletionItemKind};
use super::schema::Schema;
use super::sections::{documented, missing};
use super::{values, words};
use objdict_format as format;
use objdict_format::identify::{ContentKind, identify_source};
use objdict_format::scaffold;
use objdict_format::{Description, Format, device_schema, patch};
use objdict_model::model::{Device, PdoKind};
use objdict_model::source::{CONFIG_FILE, SourceFile, Span};
use objdict_network::{Network, Node};
use objdict_network_file as network;
use objdict_network_file::{NetworkFile, PathOptions};
use objdict_node::configure::transmission_word;
use objdict_profile::{ObjectFacts, Profile};
use objdict_project::config::SETTINGS;

static NETWORK: LazyLock<Value> = LazyLock::new(network::schema::network_toml);
static BUS: LazyLock<Value> = LazyLock::new(network::schema::bus_yml);
static DEVICE: LazyLock<Value> = LazyLock::new(device_schema);
static PATCH: LazyLock<Value> = LazyLock::new(patch::schema::patch);
static CONFIG: LazyLock<Value> = LazyLock::new(|| {
    let setting = |(name, meaning): (&str, &str)| (name.to_owned(), json!({ "description": meaning }));
    json!({ "type": "object", "properties": SETTINGS.map(setting).into_iter().collect::<serde_json::Map<_, _>>() })
});

/// So many descriptions of a folder are offered.
const MAX_FILES: usize = 1000;

/// The items at an offset of a file of keys; none of another file.
pub(super) fn completion(file: &CheckedFile, offset: u32) -> Vec<CompletionItem> {
    // a line that is being written may keep the file from being read
    let without = without_line(file.text(), offset);
    let Some(schema) = schema_of(file, &without) else { return Vec::new() };
    let is_yaml = std::ptr::eq(schema, &*BUS);
    let cursor = if is_yaml { Cursor::in_yaml } else { Cursor::in_toml }(file.text(), offset);
    let Some(cursor) = cursor else { return Vec::new() };
    let writer = KeyWriter { file, schema: Schema::new(schema), cursor: &cursor, is_yaml };
    match &cursor.spot {
        CursorSpot::Header(span) => writer.headers(*span),
        CursorSpot::Key(span) => {
            let mut items = writer.keys(*span);
            if std::ptr::eq(schema, &*DEVICE) && cursor.path == ["object"] {
                items.extend(writer.objects(&without, *span));
            }
            if cursor.path.last().is_some_and(|key| key == "set") {
                items.extend(writer.in_network(&without, "set", *span, false));
            }
            items
        }
        CursorSpot::Value { key, span, is_quoted } => {
            let mut items = writer.words(key, *span, *is_quoted);
            items.extend(writer.in_network(&without, key, *span, *is_quoted));
            items.extend(writer.in_device(&without, key, *span, *is_quoted));
            items
        }
    }
}

/// A text without the line of an offset.
fn without_line(text: &str, offset: u32) -> String {
    let at = (offset as usize).min(text.len());
    let (before, behind) = (text.get(..at).unwrap_or_default(), text.get(at..).unwrap_or_default());
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    format!("{}{}", &before[..start], behind.find('\n').map_or("", |end| &behind[end..]))
}

/// The schema of a file, by its content without the line that is being written, else by its name.
fn schema_of(file: &CheckedFile, without: &str) -> Option<&'static Value> {
    let name = file.name();
    let is_toml = name.to_ascii_lowercase().ends_with(".toml");
    if name == CONFIG_FILE {
        return Some(&CONFIG);
    }
    if file.description().is_some() {
        return file.description()?.toml_mentions().map(|_| &*DEVICE);
    }
    let kind = identify_source(&SourceFile::from_text(name, without)).kind;
    match kind {
        ContentKind::Patch => Some(&PATCH),
        ContentKind::NodeList => None,
        kind if kind.is_network() => Some(if is_toml { &NETWORK } else { &BUS }),
        _ if name == "network.toml" => Some(&NETWORK),
        _ if name == "bus.yml" || name == "bus.yaml" => Some(&BUS),
        _ if name.ends_with("device.toml") => Some(&DEVICE),
        _ => None,
    }
}

struct KeyWriter<'a> {
    file: &'a CheckedFile,
    schema: Schema<'a>,
    cursor: &'a Cursor,
    is_yaml: bool,
}

impl KeyWriter<'_> {
    /// The tables of the file, as headers of TOML.
    fn headers(&self, line: Span) -> Vec<CompletionItem> {
        let of = |(name, meaning): (&str, &str)| {
            let below = self.schema.below(&[name.to_owned()])?;
            let text = match (below.is_list_of_tables(), below.is_table()) {
                (true, _) => format!("[[{name}]]"),
                (false, true) => format!("[{name}]"),
                (false, false) => return None,
            };
            let item = item(self.file, line, &text, text.clone(), CompletionItemKind::MODULE);
            Some(CompletionItem { detail: Some(meaning.to_owned()), ..item })
        };
        self.schema.keys().into_iter().filter_map(of).collect()
    }

    /// The keys that the table does not have.
    fn keys(&self, span: Span) -> Vec<CompletionItem> {
        let Some(schema) = self.schema.below(&self.cursor.path) else { return Vec::new() };
        let missing =
            schema.keys().into_iter().filter(|(name, _)| self.cursor.present.iter().all(|key| key != name));
        missing
            .map(|(name, meaning)| {
                let text = if self.is_yaml { format!("{name}: ") } else { format!("{name} = ") };
                let item = item(self.file, span, name, text, CompletionItemKind::PROPERTY);
                CompletionItem { detail: Some(meaning.to_owned()), ..item }
            })
            .collect()
    }

    /// A device without the line that is being written.
    fn device(&self, without: &str) -> Description {
        format::read(SourceFile::from_text(self.file.source().name(), without), Format::Toml)
    }

    /// The objects of the documents that a device does not have, as lines of its table of objects.
    fn objects(&self, without: &str, span: Span) -> Vec<CompletionItem> {
        let description = self.device(without);
        let (device, Some(write)) = (description.device(), format::object_writer(without)) else {
            return Vec::new();
        };
        let item = |(document, facts): (&Profile, ObjectFacts<'_>)| {
            let index = facts.first;
            let line = write(index, &scaffold::object(device, index)?);
            let label = format!("{index:04X} {}", facts.name);
            let item = item(self.file, span, &label, line.trim_end().to_owned(), CompletionItemKind::CLASS);
            Some(documented(device, document, index, item))
        };
        missing(device).filter_map(item).collect()
    }

    /// The words that the table of keys has for a value.
    fn words(&self, key: &str, span: Span, is_quoted: bool) -> Vec<CompletionItem> {
        let path = [&self.cursor.path[..], &[key.to_owned()]].concat();
        let Some(schema) = self.schema.below(&path) else { return Vec::new() };
        let mut words = schema.words();
        let is_type = matches!(key, "type" | "data-type")
            && !path.iter().any(|key| matches!(key.as_str(), "tpdo" | "rpdo" | "link"));
        if is_type
            && (std::ptr::eq(self.schema_root(), &*DEVICE) || std::ptr::eq(self.schema_root(), &*PATCH))
        {
            words.extend(objdict_format::type_words().map(|word| (word.to_owned(), true)));
        }
        let words = words.into_iter().filter(|(_, is_text)| *is_text || !is_quoted);
        words.map(|(word, is_text)| self.text(&word, span, is_text && is_quoted, !is_text)).collect()
    }

    /// What the documents and a device know of a value in a `device.toml`, and the transmission types of any PDO.
    fn in_device(&self, without: &str, key: &str, span: Span, is_quoted: bool) -> Vec<CompletionItem> {
        let pdo = self.cursor.path.iter().find_map(|key| pdo_kind(key));
        let is_device = std::ptr::eq(self.schema_root(), &*DEVICE);
        let item = |value: &str, meaning: String, is_bare: bool| {
            let item = self.text(value, span, is_quoted, is_bare);
            CompletionItem { label: format!("{value} {meaning}"), ..item }
        };
        match (key, pdo) {
            ("transmission", _) => {
                let Some(parameter) = pdo.unwrap_or(PdoKind::Tpdo).communication_index(1) else {
                    return Vec::new();
                };
                let named = values::named(&Device::default(), parameter, 2).into_iter();
                let numbers = named.filter_map(|(number, meaning)| Some((number.parse().ok()?, meaning)));
                numbers.map(|(number, meaning)| item(&transmission_word(number), meaning, false)).collect()
            }
            ("map", Some(kind)) if is_device => {
                let device = self.device(without);
                let items = entries(device.device(), Some(kind));
                items.map(|(address, name)| item(&address, name.unwrap_or_default(), false)).collect()
            }
            ("default" | "value", _) if is_device => {
                let Some((index, sub)) = entry_of(&self.cursor.path) else { return Vec::new() };
                // the line may be the whole object, which is there if the text could be read
                let read = self.file.description().filter(|read| read.device().object(index).is_some());
                let named = match read {
                    Some(read) => values::named(read.device(), index, sub),
                    None => values::named(self.device(without).device(), index, sub),
                };
                // a formula is a text
                let is_bare = |value: &str| !value.starts_with('$');
                let fitting = named.into_iter().filter(|(value, _)| !is_quoted || !is_bare(value));
                fitting.map(|(value, meaning)| item(&value, meaning, is_bare(&value))).collect()
            }
            _ => Vec::new(),
        }
    }

    fn schema_root(&self) -> &Value {
        self.schema.root()
    }

    /// A text as a value: between quotes, unless they are there or the format needs none.
    fn text(&self, text: &str, span: Span, has_quotes: bool, is_bare: bool) -> CompletionItem {
        let new = if has_quotes || is_bare || self.is_yaml { text.to_owned() } else { format!("\"{text}\"") };
        item(self.file, span, text, new, CompletionItemKind::VALUE)
    }

    /// What a network knows: its nodes, their entries, the types, and the descriptions beside it.
    fn in_network(&self, without: &str, key: &str, span: Span, is_quoted: bool) -> Vec<CompletionItem> {
        let text = |text: &str| self.text(text, span, is_quoted, false);
        if matches!(key, "file" | "dcf" | "extends") {
            return files_beside(Path::new(self.file.source().name()))
                .iter()
                .map(|name| text(name))
                .collect();
        }
        let read;
        let network = match self.file.analysis.network().and_then(NetworkFile::network) {
            Some(network) => network,
            None if key == "extends" || self.file.description().is_some() => return Vec::new(),
            None => {
                let name = self.file.source().name();
                let folder = Path::new(name).parent().unwrap_or(Path::new(""));
                let source = SourceFile::from_text(name, without);
                read = NetworkFile::read(source, folder, &PathOptions::default());
                let Some(network) = read.network() else { return Vec::new() };
                network
            }
        };
        match key {
            "from" | "to" => self.ends(network, key, span),
            "manager" | "watches" => network.nodes.iter().map(|node| text(&node.name.value)).collect(),
            "entry" | "set" | "map" => {
                let node = self.cursor.path.get(1).and_then(|name| named(network, name));
                let kind = self.cursor.path.iter().find_map(|key| pdo_kind(key));
                let items = node.into_iter().flat_map(|node| entries(&node.device, kind));
                items.map(|(address, name)| CompletionItem { detail: name, ..text(&address) }).collect()
            }
            _ => Vec::new(),
        }
    }

    /// Nodes, and behind the point the entries of one, by address and by name.
    fn ends(&self, network: &Network, key: &str, span: Span) -> Vec<CompletionItem> {
        let typed = span.of(self.file.text());
        let Some((name, _)) = typed.split_once('.') else {
            let names = network.nodes.iter().map(|node| &node.name.value);
            return names
                .map(|name| item(self.file, span, name, name.clone(), CompletionItemKind::MODULE))
                .collect();
        };
        // a link names a manager that the file does not describe without entries
        let is_named =
            |(position, node): &(usize, &Node)| node.name.value == name && !network.is_made(*position);
        let Some((_, node)) = network.nodes.iter().enumerate().find(is_named) else { return Vec::new() };
        let kind = if key == "from" { PdoKind::Tpdo } else { PdoKind::Rpdo };
        let mut items = Vec::new();
        for (address, title) in entries(&node.device, Some(kind)) {
            let text = format!("{name}.{address}");
            let by_name = title.clone().filter(|title| is_unique(&node.device, title, &address));
            let by_address = item(self.file, span, &text, text.clone(), CompletionItemKind::FIELD);
            items.push(CompletionItem { detail: title, ..by_address });
            if let Some(title) = by_name {
                let text = format!("{name}.{title}");
                let by_name = item(self.file, span, &text, text.clone(), CompletionItemKind::FIELD);
                items.push(CompletionItem { detail: Some(address), ..by_name });
            }
        }
        items
    }
}

fn pdo_kind(key: &str) -> Option<PdoKind> {
    match key {
        "tpdo" => Some(PdoKind::Tpdo),
        "rpdo" => Some(PdoKind::Rpdo),
        _ => None,
    }
}

/// The entry of a `device.toml` whose table has this path, also in a variant.
fn entry_of(path: &[String]) -> Option<(u16, u8)> {
    let at = path.iter().position(|key| key == "object")?;
    let index = u16::from_str_radix(path.get(at + 1)?, 16).ok()?;
    let sub = match path.get(at + 2..)? {
        [] => 0,
        [key, sub] if key == "sub" => u8::from_str_radix(sub, 16).ok()?,
        _ => return None,
    };
    Some((index, sub))
}

fn named<'a>(network: &'a Network, name: &str) -> Option<&'a Node> {
    network.nodes.iter().find(|node| node.name.value == name)
}

/// The entries of a device by their addresses, with their names; those that a PDO of a kind can carry, if one is given.
fn entries(device: &Device, kind: Option<PdoKind>) -> impl Iterator<Item = (String, Option<String>)> {
    device.objects.iter().flat_map(move |(&index, object)| {
        let has_subs = object.object_type().has_subs();
        let fits = object
            .entries()
            .filter(move |(_, entry)| kind.is_none_or(|kind| entry.is_mappable() && entry.fits_pdo(kind)));
        let found: Vec<_> = fits
            .map(|(sub, _)| {
                let address = if has_subs { format!("{index:04X}:{sub:X}") } else { format!("{index:04X}") };
                (address, words::name(device, index, Some(sub)))
            })
            .collect();
        found
    })
}

/// Whether a name says which object is meant, and can be the end of a link.
fn is_unique(device: &Device, name: &str, address: &str) -> bool {
    let is_plain = name.chars().all(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    let [found] = objdict_node::resolve(device, name)[..] else { return false };
    is_plain && address.parse() == Ok(found)
}

/// The descriptions in the folder of a file, by name.
fn files_beside(path: &Path) -> Vec<String> {
    let folder = path.parent().and_then(|folder| std::fs::read_dir(folder).ok());
    let entries = folder.into_iter().flatten().filter_map(Result::ok).take(MAX_FILES);
    let names = entries
        .map(|entry| entry.path())
        .filter(|other| other != path && super::workspace::is_description(other));
    let mut names: Vec<String> =
        names.filter_map(|path| Some(path.file_name()?.to_str()?.to_owned())).collect();
    names.sort_unstable();
    names
}
