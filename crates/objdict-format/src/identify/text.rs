//! Other texts: JSON, YAML, and files mistaken for CANopen that are neither INI nor XML.

use super::{ContentKind, ExaminedContent, Identification, list, quoted};

pub(super) fn identify(content: &ExaminedContent<'_>, text: &str) -> Option<Identification> {
    if text.starts_with('{') {
        return json(text);
    }
    #[cfg(feature = "full")]
    if let Some(found) = super::concise::of_text(text) {
        return Some(found);
    }
    gsd(text)
        .or_else(|| network(content, text))
        .or_else(|| dbc(text))
        .or_else(|| fpga_constraints(text))
        .or_else(|| bus_configuration(content, text))
}

/// TOML of objdict, identified by its first key.
pub(super) fn toml(text: &str) -> Option<Identification> {
    const FORMATS: [(&str, ContentKind); 2] =
        [("objdict-device/", ContentKind::DeviceToml), ("objdict-patch/", ContentKind::Patch)];
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let (key, value) = lines.next()?.split_once('=')?;
    let stated = value.trim_start().get(1..).filter(|_| key.trim() == "format")?;
    let (format, kind) = FORMATS.into_iter().find(|(format, _)| stated.starts_with(format))?;
    Some(Identification::new(kind, format!("its first key is `format`, with `{format}1`")))
}

/// A JSON document of objdict or of an editor. Names may be in any order, so every `kind` is checked.
fn json(text: &str) -> Option<Identification> {
    if text.contains("\"od data\"") {
        let reason = "it is JSON with the `$id` `od data`";
        return Some(Identification::new(ContentKind::ObjdictgenJson, reason));
    }
    let is_field = |name: &str| text.contains(&format!("\"{name}\""));
    if is_field("subObjects") || is_field("deviceInfo") && is_field("fileInfo") {
        let reason = "it is JSON with fields of the message `CanOpenDevice`, such as `subObjects`";
        return Some(Identification::new(ContentKind::CanopenEditorJson, reason));
    }
    if !is_field("version") {
        return None;
    }
    text.match_indices("\"kind\"").find_map(|(at, key)| {
        let value = text[at + key.len()..].trim_start().strip_prefix(':')?.trim_start();
        let kinds = [("device", ContentKind::JsonDevice), ("concise-dcf", ContentKind::JsonConciseDcf)];
        let is = |word: &str| value.strip_prefix('"').and_then(|rest| rest.strip_prefix(word));
        let (word, kind) =
            kinds.into_iter().find(|(word, _)| is(word).is_some_and(|rest| rest.starts_with('"')))?;
        Some(Identification::new(kind, format!("it is JSON with a `version` and the `kind` `{word}`")))
    })
}

/// PROFIBUS: `#Profibus_DP` is the first line that is not a comment.
fn gsd(text: &str) -> Option<Identification> {
    let mut lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with(';'));
    let first = lines.next()?;
    let is_gsd = first.get(.."#Profibus_DP".len())?.eq_ignore_ascii_case("#Profibus_DP");
    is_gsd.then(|| foreign(ContentKind::Gsd, "PROFIBUS", "it starts with `#Profibus_DP`"))
}

/// CAN database: a version, new symbols or nodes, and messages.
fn dbc(text: &str) -> Option<Identification> {
    let has = |words: &[&str]| {
        let line = text.lines().find(|line| words.iter().any(|word| line.starts_with(word)))?;
        line.split_whitespace().next().map(|word| format!("`{}`", quoted(word)))
    };
    let message = has(&["BO_ "])?;
    let start = has(&["VERSION ", "NS_ ", "NS_:", "BS_:", "BU_:"])?;
    let reason = format!("it has lines that start with {start} and {message}");
    Some(Identification::new(ContentKind::Dbc, reason))
}

/// Tcl commands of Vivado about ports, pins and clocks. In files supplied with boards, all of them are
/// comments.
fn fpga_constraints(text: &str) -> Option<Identification> {
    let commands = [
        "set_property",
        "create_clock",
        "create_generated_clock",
        "set_input_delay",
        "set_output_delay",
        "set_clock_groups",
        "set_false_path",
        "set_max_delay",
        "set_multicycle_path",
    ];
    let objects = [
        "get_ports",
        "get_pins",
        "get_clocks",
        "get_cells",
        "get_nets",
        "get_iobanks",
        "current_design",
        "PACKAGE_PIN",
    ];
    text.lines().find_map(|line| {
        let line = line.trim_start_matches(|c: char| c == '#' || c.is_whitespace());
        let first = line.split_whitespace().next()?;
        let command = commands.into_iter().find(|&command| command == first)?;
        let object = objects.into_iter().find(|object| line.contains(object))?;
        let reason = format!("it has Tcl commands such as `{command} … {object}`");
        Some(foreign(ContentKind::FpgaConstraints, "Vivado", reason))
    })
}

/// TOML for objdict: at least two of the tables of nodes, links and the bus.
fn network(content: &ExaminedContent<'_>, text: &str) -> Option<Identification> {
    const TABLES: [(&str, &str); 4] =
        [("[bus]", "[bus]"), ("[manager]", "[manager]"), ("[node.", "[node.…]"), ("[[link]]", "[[link]]")];
    let is_there = |start: &str| text.lines().any(|line| line.trim_start().starts_with(start));
    let found = TABLES.into_iter().filter(|(start, _)| is_there(start));
    let found: Vec<String> = found.map(|(_, table)| format!("`{table}`")).collect();
    let enough = if content.is_called(&["toml"]) { 1 } else { 2 };
    let reason = || format!("it is TOML with the tables {}", list(&found));
    (found.len() >= enough).then(|| Identification::new(ContentKind::Network, reason()))
}

/// YAML for dcfgen: keys of nodes, including at least the description or the node-ID.
fn bus_configuration(content: &ExaminedContent<'_>, text: &str) -> Option<Identification> {
    const NEEDED: [&str; 2] = ["dcf", "node_id"];
    const USUAL: [&str; 16] = [
        "dcf_path",
        "driver",
        "package",
        "sync_period",
        "heartbeat_producer",
        "heartbeat_consumer",
        "heartbeat_multiplier",
        "reset_communication",
        "rpdo",
        "tpdo",
        "sdo",
        "boot",
        "mandatory",
        "revision_number",
        "serial_number",
        "master",
    ];
    let mut found: Vec<&str> = Vec::new();
    // a key starts a line, or follows a brace or a comma, as in `{node_id: 1, dcf: a.eds}`
    let lines = text.lines().filter(|line| !line.trim_start().starts_with('#'));
    for part in lines.flat_map(|line| line.split(['{', ','])) {
        let Some((key, _)) = part.split_once(':') else { continue };
        let key = key.trim().trim_start_matches("- ").trim_matches(['"', '\'']);
        let known = NEEDED.into_iter().chain(USUAL).find(|known| *known == key);
        if let Some(known) = known.filter(|known| !found.contains(known)) {
            found.push(known);
        }
    }
    found.sort_by_key(|key| !NEEDED.contains(key));
    let needed = found.first().is_some_and(|key| NEEDED.contains(key));
    let enough = if content.is_called(&["yml", "yaml"]) { 2 } else { 3 };
    if !needed || found.len() < enough {
        return None;
    }
    let keys: Vec<String> = found.iter().take(3).map(|key| format!("`{key}`")).collect();
    let reason = format!("it is YAML with the keys {}", list(&keys));
    Some(Identification::new(ContentKind::BusConfiguration, reason))
}

fn foreign(kind: ContentKind, technology: &str, reason: impl Into<String>) -> Identification {
    Identification { technology: Some(technology.to_owned()), ..Identification::new(kind, reason) }
}
