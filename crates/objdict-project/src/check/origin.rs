//! The type description of a configured node.

use std::path::Path;

use objdict_format as format;
use objdict_format::Description;
use objdict_model::model::DeviceKind;
use objdict_model::source::{SourceOptions, is_file};

/// Adds the type description that `LastEDS` names to the configuration of a node, if it is in the same
/// folder.
pub fn with_origin_beside(path: &Path, description: Description, options: &SourceOptions) -> Description {
    if description.device().kind != DeviceKind::Node {
        return description;
    }
    let beside = last_eds(&description).map(|name| path.with_file_name(name));
    // the target of a link may be outside the folder
    let is_link = |eds: &Path| eds.symlink_metadata().is_ok_and(|found| found.is_symlink());
    let beside = beside.filter(|eds| eds != path && is_file(eds) && !is_link(eds));
    let origin = beside.and_then(|eds| format::open(&eds, options).ok());
    match origin.filter(|origin| origin.device().kind == DeviceKind::Type) {
        Some(origin) => description.with_origin(origin),
        None => description,
    }
}

/// The name of the file in `LastEDS`, without its folder on another computer.
pub fn last_eds(description: &Description) -> Option<&str> {
    let named = description.device().file_info.as_ref()?.last_eds.as_deref()?;
    named.rsplit(['/', '\\']).next().map(str::trim).filter(|name| !matches!(*name, "" | "." | ".."))
}
