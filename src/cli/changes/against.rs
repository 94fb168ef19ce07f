//! Whether a stored configuration still goes into the new device.

use crate::cli::args::DiffArgs;
use crate::cli::convert::{read_data, refusal};
use crate::cli::dcf::{Content, content};
use crate::cli::input::ExpandArgs;
use crate::cli::outcome::Failure;
use crate::download::{ConciseDcf, Objection, PlanOptions};
use crate::lint::changes::{DeviceChange, configuration_refused};
use crate::model::Device;

/// The downloads that the new device refuses.
pub(super) fn refused(args: &DiffArgs, [old, new]: [&Device; 2]) -> Result<Vec<DeviceChange>, Failure> {
    let Some(path) = &args.against else { return Ok(Vec::new()) };
    let expand = ExpandArgs { implicit_pdos: true };
    let (old, new) = (expand.device(old), expand.device(new));
    let of_devices = args.node_id.or_else(|| new.node_id()).or_else(|| old.node_id());
    let (configuration, node_id) = match content(path, &args.input, &expand, of_devices)? {
        Content::Stream(configuration) => (configuration, of_devices),
        Content::Device(node) => {
            let node_id = args.node_id.or_else(|| node.node_id()).or(of_devices);
            let options = PlanOptions { node_id, ..PlanOptions::default() };
            let plan = ConciseDcf::plan(&ConciseDcf::rebased(&node, &new), &options);
            let folder = args.paths.folder_of(path);
            let plan = plan.map_err(|error| refusal(&error))?;
            (plan.into_concise(|file| read_data(&folder, file))?, node_id)
        }
    };
    let before = configuration.verify(&old, node_id);
    let verification = configuration.verify(&new, node_id);
    let change = |objection: &Objection| {
        let is_old = before.refusals().any(|other| other.number == objection.number);
        let abort = objection.kind.abort().map(|abort| format!(" ({:08X}h)", abort.0)).unwrap_or_default();
        let also = if is_old { ", as does the old device" } else { "" };
        let number = objection.number;
        let reason = format!(
            "the new device refuses download {number} of the configuration{also}: {}{abort}",
            objection.kind
        );
        configuration_refused(objection.index, objection.sub, &reason)
    };
    Ok(verification.refusals().map(change).collect())
}
