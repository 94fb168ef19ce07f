//! Whether stored configurations still go into the new device.

use std::path::Path;
use std::slice;

use crate::args::DiffArgs;
use crate::convert::{read_data, refusal};
use crate::dcf::{PackedContent, content};
use crate::ending::Failure;
use crate::input::{ExpandArgs, name_of};
use crate::network::refuse_misread;
use objdict_format::identify::{ContentKind, identify_source};
use objdict_lint::changes::{DeviceChange, configuration_refused};
use objdict_model::model::Device;
use objdict_model::source::{SourceFile, SourceOptions};
use objdict_network_file::NetworkFile;
use objdict_node::download::{ConciseDcf, Objection, PlanOptions};

/// A stored configuration.
struct StoredConfiguration {
    /// How messages call it.
    name: String,
    configuration: ConciseDcf,
    node_id: Option<u8>,
}

/// The downloads that the new device refuses.
pub(super) fn refused(args: &DiffArgs, [old, new]: [&Device; 2]) -> Result<Vec<DeviceChange>, Failure> {
    let Some(path) = &args.against else { return Ok(Vec::new()) };
    let expand = ExpandArgs { implicit_pdos: true };
    let (old, new) = (expand.device(old), expand.device(new));
    let all = match is_network(path) {
        true => of_network(args, path, &old)?,
        false => vec![of_node(args, path, [&old, &new])?],
    };
    Ok(all.iter().flat_map(|stored| stored.refused(&old, &new)).collect())
}

/// Whether a file is plainly a network. Hex digits of a concise DCF have no mark, and a file that cannot be opened is reported where it
/// is read.
fn is_network(path: &Path) -> bool {
    let source = SourceFile::open(path, &SourceOptions::default()).ok();
    source.is_some_and(|source| {
        let kind = identify_source(&source).kind;
        matches!(kind, ContentKind::Network | ContentKind::BusConfiguration | ContentKind::NodeList)
    })
}

impl StoredConfiguration {
    fn refused(&self, old: &Device, new: &Device) -> Vec<DeviceChange> {
        let before = self.configuration.verify(old, self.node_id);
        let change = |objection: &Objection| {
            let is_old = before.refusals().any(|other| other.number == objection.number);
            let abort =
                objection.kind.abort().map(|abort| format!(" ({:08X}h)", abort.0)).unwrap_or_default();
            let also = if is_old { ", as does the old device" } else { "" };
            let reason = format!(
                "the new device rejects download {} of {}{also}: {}{abort}",
                objection.number, self.name, objection.kind
            );
            configuration_refused(objection.index, objection.sub, &reason)
        };
        self.configuration.verify(new, self.node_id).refusals().map(change).collect()
    }
}

/// The configuration in a concise DCF, a DCF or an XDC.
fn of_node(args: &DiffArgs, path: &Path, [old, new]: [&Device; 2]) -> Result<StoredConfiguration, Failure> {
    let of_devices = args.node_id.or_else(|| new.node_id()).or_else(|| old.node_id());
    let expand = ExpandArgs { implicit_pdos: true };
    let (configuration, node_id) = match content(path, &args.input, &expand, of_devices)? {
        PackedContent::Stream(configuration) => (configuration, of_devices),
        PackedContent::Device(node) => {
            let node_id = args.node_id.or_else(|| node.node_id()).or(of_devices);
            let options = PlanOptions { node_id, ..PlanOptions::default() };
            let plan = ConciseDcf::plan(&ConciseDcf::rebased(&node, new), &options);
            let folder = args.paths.folder_of(path);
            let plan = plan.map_err(|error| refusal(&error))?;
            (plan.into_concise(|file| read_data(&folder, file))?, node_id)
        }
    };
    Ok(StoredConfiguration { name: "the configuration".to_owned(), configuration, node_id })
}

/// The configurations of the nodes of a network that are the old device, by vendor-ID and product code.
fn of_network(args: &DiffArgs, path: &Path, old: &Device) -> Result<Vec<StoredConfiguration>, Failure> {
    let file = NetworkFile::open(path, &args.paths.options()).map_err(Failure::new)?;
    refuse_misread(&file, slice::from_ref(&path.to_path_buf()))?;
    let (Some(network), Some(compiled)) = (file.network(), file.compiled()) else { return Ok(Vec::new()) };
    let identity = |device: &Device| device.identity().vendor_id.zip(device.identity().product_code);
    let wanted = identity(old);
    let nodes = compiled.nodes().filter(|node| wanted.is_some() && identity(&node.device) == wanted);
    let stored: Vec<StoredConfiguration> = nodes
        .map(|node| StoredConfiguration {
            name: format!("node `{}`", network.nodes[node.node].name.value),
            configuration: node.arranged_or_stated().clone(),
            node_id: Some(node.node_id),
        })
        .collect();
    if stored.is_empty() {
        let message =
            format!("no node of `{}` has the vendor-ID and product code of the old device", name_of(path));
        return Err(Failure::new(message).help("name the network that uses the device, or a DCF of its node"));
    }
    Ok(stored)
}
