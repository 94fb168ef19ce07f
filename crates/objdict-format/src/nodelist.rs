//! CANopen project files, `nodelist.cpj` (CiA 306-3): small INI files that list the nodes of networks.
//!
//! They are read with rust-ini, not by the scanner for EDS and DCF: findings need no positions, and nothing is written
//! back.

use ini::{Ini, ParseOption, Properties};

use super::identify::ini::is_topology;
use objdict_eds::ini::Lines;
use objdict_model::literal::{self, Quirks};
use objdict_model::model::{NodeList, Topology, TopologyNode};
use objdict_model::source::SourceFile;

/// The reason why a text is not a node list.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NodeListError {
    /// The text is XML.
    Xml,
    /// The text is not an INI file.
    Ini {
        /// The line, counted from 1, at which rust-ini stopped.
        line: usize,
        /// The message of rust-ini.
        message: String,
    },
    /// It contains no network.
    NoTopology,
    /// A number is not valid or out of range.
    Number {
        /// The section.
        section: String,
        /// The key.
        key: String,
        /// The text.
        text: String,
        /// The smallest number that it may be.
        low: u8,
        /// The largest number that it may be.
        high: u8,
    },
}

objdict_model::error_messages! { NodeListError: {
    Self::Xml => "the file is XML; a node list of CiA 306-3 is an INI file with a section `[Topology]`";
    Self::Ini { line, message } => "line {line} cannot be read: {message}";
    Self::NoTopology => "missing section `[Topology]`";
    Self::Number { section, key, text, low, high } =>
        "`{key}={text}` in `[{section}]` is not a number from {low} to {high}";
} }

/// Reads a node list.
///
/// # Errors
/// If the text is not an INI file, has no network, or has invalid numbers.
pub fn read(source: &SourceFile) -> Result<NodeList, NodeListError> {
    let text = source.text();
    if text.trim_start().starts_with('<') {
        return Err(NodeListError::Xml);
    }
    let ini = parse(text)?;
    let mut networks = Vec::new();
    for (section, properties) in &ini {
        if let Some(section) = section.filter(|name| is_topology(name)) {
            networks.push(network(section, properties)?);
        }
    }
    if networks.is_empty() { Err(NodeListError::NoTopology) } else { Ok(NodeList { networks }) }
}

/// Calls rust-ini with all conversions of values disabled. Lines are passed without surrounding whitespace and with CR
/// LF: at a lone LF, a backslash before it would join two lines.
fn parse(text: &str) -> Result<Ini, NodeListError> {
    let mut lines = String::with_capacity(text.len());
    for line in Lines::new(text) {
        let trimmed =
            line.span.of(text).trim_matches(|c: char| c.is_whitespace() || matches!(c, '\0' | '\u{1A}'));
        lines.push_str(trimmed);
        lines.push_str("\r\n");
    }
    let options = ParseOption { enabled_quote: false, enabled_escape: false, ..ParseOption::default() };
    Ini::load_from_str_opt(&lines, options)
        .map_err(|error| NodeListError::Ini { line: error.line, message: error.msg.into_owned() })
}

fn network(section: &str, properties: &Properties) -> Result<Topology, NodeListError> {
    let mut network = Topology::default();
    for (key, text) in properties {
        let number = |low, high| number(section, key, text, (low, high));
        let word = || Some(text.to_owned()).filter(|text| !text.is_empty());
        match key.to_ascii_lowercase().as_str() {
            "netname" => network.name = word(),
            "netrefd" => network.reference_designator = word(),
            "edsbasename" => network.eds_folder = word(),
            "nodes" => network.stated_count = number(0, 127)?,
            _ => match node_key(key) {
                Some((id, "present")) => node(&mut network, id).present = number(0, 1)? == Some(1),
                Some((id, "name")) => node(&mut network, id).name = word(),
                Some((id, "refd")) => node(&mut network, id).reference_designator = word(),
                Some((id, "dcfname")) => node(&mut network, id).dcf = word(),
                _ => network.extra.push(key, text),
            },
        }
    }
    network.nodes.sort_by_key(|node| node.id);
    Ok(network)
}

/// The node-ID and the property: `(12, "name")` for `Node12Name`.
fn node_key(key: &str) -> Option<(u8, &'static str)> {
    let rest = key.get(..4).filter(|word| word.eq_ignore_ascii_case("Node")).map(|_| &key[4..])?;
    let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
    let id = rest[..digits].parse().ok().filter(|id| (1..=127).contains(id))?;
    let what = ["present", "name", "refd", "dcfname"];
    let what = what.into_iter().find(|what| what.eq_ignore_ascii_case(&rest[digits..]))?;
    Some((id, what))
}

fn node(network: &mut Topology, id: u8) -> &mut TopologyNode {
    let position = network.nodes.iter().position(|node| node.id == id).unwrap_or_else(|| {
        network.nodes.push(TopologyNode { id, ..TopologyNode::default() });
        network.nodes.len() - 1
    });
    &mut network.nodes[position]
}

fn number(section: &str, key: &str, text: &str, (low, high): (u8, u8)) -> Result<Option<u8>, NodeListError> {
    if text.is_empty() {
        return Ok(None);
    }
    let number = literal::integer_in_line(text, low.into(), high.into(), &mut Quirks::default());
    match number.ok().and_then(|number| u8::try_from(number).ok()) {
        Some(number) => Ok(Some(number)),
        None => {
            let (section, key, text) = (section.to_owned(), key.to_owned(), text.to_owned());
            Err(NodeListError::Number { section, key, text, low, high })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<NodeList, NodeListError> {
        super::read(&SourceFile::from_text("nodelist.cpj", text))
    }

    #[test]
    fn what_vendors_write() {
        let list = read(
            "; project\n[TOPOLOGY]\nNetName=Press\\\nNodes=0x02\nNode16Present=0x01\nNode16Name=Pump \"2\"\n\
             node16dcfname = ..\\eds\\pump.dcf\nNode3Present=0x00\nNode3Name=spare\nNode200Name=x\nColour=red\n\x1A",
        )
        .unwrap();
        let network = &list.networks[0];
        assert_eq!(network.name.as_deref(), Some("Press\\"));
        assert_eq!((network.stated_count, network.present()), (Some(2), 1));
        let nodes: Vec<(u8, bool)> = network.nodes.iter().map(|node| (node.id, node.present)).collect();
        assert_eq!(nodes, [(3, false), (16, true)]);
        assert_eq!(network.nodes[1].name.as_deref(), Some("Pump \"2\""));
        assert_eq!(network.nodes[1].dcf.as_deref(), Some("..\\eds\\pump.dcf"));
        assert_eq!((network.extra.get("Colour"), network.extra.get("Node200Name")), (Some("red"), Some("x")));
    }

    #[test]
    fn what_is_no_node_list() {
        assert_eq!(read("<?xml version=\"1.0\"?>\n"), Err(NodeListError::Xml));
        assert_eq!(read("[FileInfo]\nFileName=a.eds\n"), Err(NodeListError::NoTopology));
        assert!(matches!(read("[Topology\nNodes=1\n"), Err(NodeListError::Ini { .. })));
        let error = read("[Topology]\nNode1Present=2\n").unwrap_err().to_string();
        assert_eq!(error, "`Node1Present=2` in `[Topology]` is not a number from 0 to 1");
    }
}
