//! Conversion between EDS and DCF by edits of the text, so that comments, order, spelling, line ends and
//! encoding are kept.

use super::section::SectionName;
use crate::ini::{Document, IniEditor, Section};
use crate::literal::{self, Quirks};
use crate::model::{Commissioning, DataType, Part};
use crate::source::EditError;

/// The keys that only a DCF has (CiA 306-1 §5.3.1).
const DCF_KEYS: [&str; 5] = ["ParameterValue", "Denotation", "UploadFile", "DownloadFile", "ParamRefd"];

/// The section of the node, as other tools expect it.
const COMMISSIONING: &str = "DeviceComissioning";

/// Keys of that section that other tools expect in this spelling and read as decimal numbers.
const PLAIN_KEYS: [&str; 2] = ["NodeID", "Baudrate"];

/// Converts `document` to a DCF named `file_name` for the node `node`. The values of `node` replace
/// those of the document; `last_eds` is the source file.
///
/// # Errors
/// If the document cannot be written in its encoding.
pub fn to_dcf(
    document: &Document,
    file_name: &str,
    last_eds: Option<&str>,
    node: &Commissioning,
) -> Result<Vec<u8>, EditError> {
    let sections = HeadedSections::of(document);
    let mut editor = IniEditor::new(document);
    let mut facts = vec![("FileName", file_name.to_owned())];
    facts.extend(last_eds.map(|name| ("LastEDS", name.to_owned())));
    match sections.find(&Part::FileInfo) {
        Some(section) => facts.iter().for_each(|(key, value)| editor.set(section, key, value)),
        None => editor.insert_section(None, "FileInfo", &facts),
    }
    let settings = settings(node);
    match sections.find(&Part::Commissioning) {
        Some(section) => {
            if !sections.all.iter().any(|(_, section)| has_standard_name(document, section)) {
                editor.rename_section(section, COMMISSIONING);
            }
            for (key, value) in &settings {
                if PLAIN_KEYS.contains(key) {
                    set_plain(&mut editor, document, section, key, value);
                } else if !has_number(document, section, key, value) {
                    editor.set(section, key, value);
                }
            }
        }
        None => {
            let behind = [Part::Comments, Part::DummyUsage, Part::DeviceInfo, Part::FileInfo];
            let behind = behind.iter().find_map(|part| sections.find(part));
            editor.insert_section(behind, COMMISSIONING, &settings);
        }
    }
    editor.to_bytes()
}

/// The bytes of `document` as an EDS with the name `file_name`: without the node and its configured values.
///
/// # Errors
/// If the document cannot be written in its encoding.
pub fn to_eds(document: &Document, file_name: &str) -> Result<Vec<u8>, EditError> {
    let sections = HeadedSections::of(document);
    let mut editor = IniEditor::new(document);
    for (part, section) in &sections.all {
        match part {
            Part::Commissioning
            | Part::ConnectedModules
            | Part::CompactValues(_)
            | Part::CompactDenotations(_) => editor.remove_section(section),
            Part::FileInfo => {
                editor.set(section, "FileName", file_name);
                editor.remove_key(section, "LastEDS");
            }
            Part::Object(_) | Part::Entry(..) => {
                DCF_KEYS.iter().for_each(|key| editor.remove_key(section, key));
            }
            _ => {}
        }
    }
    editor.to_bytes()
}

/// All sections with a header, with their parts.
struct HeadedSections {
    all: Vec<(Part, Section)>,
}

impl HeadedSections {
    fn of(document: &Document) -> Self {
        let mut all = Vec::new();
        document.visit(
            |section| {
                if let Some(header) = section.header {
                    all.push((SectionName::parse(header.name.of(document.text())).part, section.clone()));
                }
            },
            |_| {},
        );
        Self { all }
    }

    fn find(&self, part: &Part) -> Option<&Section> {
        self.all.iter().find(|(other, _)| other == part).map(|(_, section)| section)
    }
}

/// Whether a section header is spelled exactly as in the standard.
fn has_standard_name(document: &Document, section: &Section) -> bool {
    section
        .header
        .is_some_and(|header| header.line.of(document.text()).trim() == format!("[{COMMISSIONING}]"))
}

/// Sets a key that must be spelled as in the standard. All lines of the key get the value, because other
/// tools read the one with this spelling.
fn set_plain(editor: &mut IniEditor<'_>, document: &Document, section: &Section, key: &str, value: &str) {
    let text = document.text();
    let spellings = section.entries.iter().filter(|entry| entry.key.of(text).eq_ignore_ascii_case(key));
    let spellings: Vec<_> = spellings.collect();
    if spellings.is_empty() {
        editor.set(section, key, value);
        return;
    }
    if spellings.iter().all(|entry| entry.key.of(text) != key) {
        editor.replace(spellings[0].key, key);
    }
    for entry in spellings {
        // these tools skip a comment after the number
        let number = entry.value.of(text).split_once(" ;").map_or(entry.value.of(text), |(number, _)| number);
        if number.trim_end() != value {
            editor.replace(entry.value, value);
        }
    }
}

/// Whether a key has this number already, in any spelling.
fn has_number(document: &Document, section: &Section, key: &str, number: &str) -> bool {
    const NUMBERS: [&str; 3] = ["NetNumber", "CANopenManager", "LSS_SerialNumber"];
    let value =
        |text: &str| literal::value_in_line(text, Some(DataType::UNSIGNED32), &mut Quirks::default()).ok();
    let mut entries = section.entries.iter().filter(|_| NUMBERS.contains(&key));
    let entry = entries.find(|entry| entry.key.of(document.text()).eq_ignore_ascii_case(key));
    entry
        .and_then(|entry| value(entry.value.of(document.text())))
        .is_some_and(|old| value(number) == Some(old))
}

/// The keys of `DeviceComissioning` (CiA 306-1 §5.4): keys that readers require, and other keys if set.
fn settings(node: &Commissioning) -> Vec<(&'static str, String)> {
    let number = |number: Option<u32>| number.unwrap_or_default().to_string();
    let text = |text: &Option<String>| text.clone().unwrap_or_default();
    let mut settings = Vec::new();
    settings.extend(node.node_id.map(|node_id| ("NodeID", node_id.to_string())));
    settings.push(("NodeName", text(&node.node_name)));
    settings.extend(node.baud_rate.map(|rate| ("Baudrate", rate.to_string())));
    settings.extend([
        ("NetNumber", number(node.net_number)),
        ("NetworkName", text(&node.network_name)),
        ("CANopenManager", number(node.manager.map(u32::from))),
    ]);
    // Lely rejects a serial number without 1018h sub-index 4, so none is invented
    settings.extend(node.lss_serial_number.map(|number| ("LSS_SerialNumber", number.to_string())));
    let designators =
        [("NodeRefd", &node.node_reference_designator), ("NetRefd", &node.net_reference_designator)];
    settings
        .extend(designators.into_iter().filter_map(|(key, value)| value.clone().map(|value| (key, value))));
    settings
}
