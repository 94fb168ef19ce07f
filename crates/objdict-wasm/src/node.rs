//! Configured nodes: a description with node-ID, bit rate, modules and settings, as `objdict configure` makes it.

use std::borrow::Cow;

use objdict::configure::{Configuration, Rebased, Setting, configuration, rebase};
use objdict::coupler::flatten;
use objdict::format::{Description, NodeSettings};
use objdict::model::{Commissioning, Device};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::answer::BadRequest;
use crate::files::PageFile;

/// What a node is to be.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct WantedNode {
    /// The name of the file.
    pub(crate) name: String,
    node_id: u8,
    /// In kbit/s.
    bit_rate: Option<u16>,
    node_name: Option<String>,
    /// The modules in their physical order, by number.
    #[serde(default)]
    modules: Vec<u16>,
    /// `1017=1000`, a line each.
    #[serde(default)]
    settings: Vec<String>,
}

/// The modules that can be plugged into a coupler.
pub(crate) fn modules(device: &Device) -> Value {
    let Some(modules) = &device.modules else { return json!({ "supported": [], "connected": [] }) };
    let row = |(number, module): (&u16, &objdict::model::Module)| json!({ "number": number, "name": module.product_name, "order_code": module.order_code });
    let supported: Vec<Value> = modules.supported.iter().map(row).collect();
    json!({ "supported": supported, "connected": modules.connected.as_deref().unwrap_or_default() })
}

/// The DCF or XDC of the node, and what is to be said about it.
pub(crate) fn configured(
    description: &Description,
    wanted: &WantedNode,
) -> Result<(PageFile, Vec<String>), BadRequest> {
    let own = description.device();
    if !(1..=127).contains(&wanted.node_id) {
        return Err(BadRequest::new(format_args!("the node-ID {} is not valid", wanted.node_id))
            .help("state a node-ID from 1 to 127"));
    }
    let stated = own.commissioning.clone().unwrap_or_default();
    let node = Commissioning {
        node_id: Some(wanted.node_id),
        baud_rate: wanted.bit_rate.or(stated.baud_rate),
        node_name: wanted.node_name.clone().filter(|name| !name.is_empty()).or(stated.node_name.clone()),
        ..stated
    };
    let plugged = match wanted.modules.is_empty() {
        true => None,
        false => Some(flatten(own, &wanted.modules).map_err(|problems| {
            let first = problems.first().map(ToString::to_string).unwrap_or_default();
            BadRequest::new(first).help("choose other modules, or another order")
        })?),
    };
    let mut base = Cow::Borrowed(plugged.as_ref().unwrap_or(own));
    // CAN-IDs of another node-ID follow it
    let former = own.node_id().filter(|former| (1..=127).contains(former) && *former != wanted.node_id);
    let Rebased { assignments: followers, kept } =
        former.map(|former| rebase(&base, former)).unwrap_or_default();
    if !followers.is_empty() {
        base.to_mut().assign(&followers);
    }
    let settings = wanted.settings.iter().map(|text| Setting::value(text));
    let settings: Vec<Setting> = settings.collect::<Result<_, _>>().map_err(|error| {
        BadRequest::new(error).help("write the address of an entry and its value, as in `1017=1000`")
    })?;
    let Configuration { values, downloads } =
        configuration(&base, wanted.node_id, &settings).map_err(|problems| {
            let first = problems.into_iter().next();
            let help = first.as_ref().and_then(|problem| problem.help.as_ref().map(ToString::to_string));
            BadRequest {
                help,
                ..BadRequest::new(first.map(|problem| problem.to_string()).unwrap_or_default())
            }
        })?;
    let assignments = [followers, values].concat();
    let parts = NodeSettings {
        node: &node,
        plugged: plugged.as_ref(),
        assignments: &assignments,
        downloads: &downloads,
    };
    let made = description.configured(&wanted.name, &parts).map_err(BadRequest::new)?;
    let mut notes: Vec<String> = kept
        .iter()
        .map(|(at, id)| {
            format!(
                "{:04X}h:{:02X} is {id}, which does not depend on the node-ID and stays",
                at.index,
                at.sub.unwrap_or_default()
            )
        })
        .collect();
    if !made.is_edited {
        notes.push(
            "the text has no place for these settings, so the file is written anew, without comments"
                .to_owned(),
        );
    }
    Ok((PageFile { name: wanted.name.clone(), bytes: made.bytes }, notes))
}
