//! Node lists.

use std::io::{self, Write};
use std::path::Path;

use serde::Serialize;

use crate::args::{ShowArgs, ShowFormat};
use crate::ending::Failure;
use crate::input::{name_of, source_name};
use crate::stdout::Output;
use crate::table::{TextTable, fit};
use objdict_model::diagnostic::plural;
use objdict_model::json::Version;
use objdict_model::model::{NodeList, Topology};

/// The most characters of a name.
const CELL: usize = 60;

#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct NodesJson<'a> {
    /// The version of the document.
    version: Version<1>,
    /// The file as it was given.
    file: &'a str,
    /// The networks, in the order of the file.
    networks: &'a [Topology],
}

pub(super) fn show(list: &NodeList, args: &ShowArgs, out: &mut Output) -> Result<(), Failure> {
    if args.object.is_some() {
        let failure =
            Failure::new(format_args!("`{}` is a node list and has no objects", name_of(&args.file)));
        return Err(failure.help("name the description of one of its nodes"));
    }
    match args.format {
        ShowFormat::Table => write_tables(list, &args.file, out)?,
        ShowFormat::Json => {
            let document =
                NodesJson { version: Version, file: &source_name(&args.file), networks: &list.networks };
            out.json(&document)?;
        }
    }
    Ok(())
}

fn write_tables(list: &NodeList, file: &Path, out: &mut dyn Write) -> io::Result<()> {
    for (position, network) in list.networks.iter().enumerate() {
        if position > 0 {
            writeln!(out)?;
        }
        writeln!(out, "{}\n", fit(&summary(network), CELL * 4))?;
        let mut table = TextTable::new(["Node", "Name", "Present", "DCF", "", "Reference"], CELL);
        for node in &network.nodes {
            let text = |text: &Option<String>| text.clone().unwrap_or_default();
            let dcf = node.dcf.as_deref();
            let is_missing = node.present && dcf.is_some_and(|dcf| !exists(file, network, dcf));
            table.row([
                node.id.to_string(),
                text(&node.name),
                if node.present { "yes" } else { "no" }.to_owned(),
                text(&node.dcf),
                if is_missing { "not found" } else { "" }.to_owned(),
                text(&node.reference_designator),
            ]);
        }
        table.write(out)?;
    }
    Ok(())
}

/// Whether a file is there, seen from the node list or from the folder of descriptions that it names. Projects come from
/// systems with the other separator.
fn exists(node_list: &Path, network: &Topology, name: &str) -> bool {
    let folder = node_list.parent().unwrap_or(Path::new(""));
    let is_file = |name: &str| folder.join(name).is_file() || folder.join(name.replace('\\', "/")).is_file();
    let in_eds_folder = network.eds_folder.as_ref().map(|folder| format!("{folder}/{name}"));
    is_file(name) || in_eds_folder.is_some_and(|name| is_file(&name))
}

fn summary(network: &Topology) -> String {
    let name = network.name.as_deref().unwrap_or("network without a name");
    let reference =
        network.reference_designator.as_ref().map(|text| format!(" ({text})")).unwrap_or_default();
    let present = network.present();
    let mut summary = format!("{name}{reference}: {}", plural(present, "node"));
    if let Some(stated) = network.stated_count.filter(|&stated| usize::from(stated) != present) {
        summary.push_str(&format!(", but the list has {stated}"));
    }
    if let Some(folder) = &network.eds_folder {
        summary.push_str(&format!(", EDS files in {folder}"));
    }
    summary
}
