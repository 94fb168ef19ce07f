//! What configures a node, in the order in which it is sent.

use objdict_node::download::{ConciseDcf, Download, PlanOptions, Step, transferred_type};

use super::anchor::Anchor;
use super::context::Context;
use super::sentence::anchor;
use crate::describe::ValueReader;
use crate::model::Value;

/// A download to the device.
pub(crate) struct DownloadView {
    pub(crate) entry: Anchor,
    /// Where the page has the entry.
    pub(crate) anchor: Option<Anchor>,
    /// The names of object and entry: `Identity object / Vendor-ID`.
    pub(crate) name: String,
    /// The value; `None` for data in a file.
    pub(crate) value: Option<Value>,
    /// The value in text, or the name of the file.
    pub(crate) shown: String,
    /// The meaning of the value in words.
    pub(crate) meaning: Option<String>,
}

/// The downloads of a configured node; none where its values cannot be sent, which `check` reports.
pub(super) fn downloads(context: &Context<'_>) -> Vec<DownloadView> {
    let options = PlanOptions { node_id: context.node_id, ..PlanOptions::default() };
    let plan = ConciseDcf::plan(context.device, &options).unwrap_or_default();
    let view = |step| match step {
        Step::Write(download) => written(context, &download),
        Step::File(file) => DownloadView { shown: file.name.into(), ..view(context, file.index, file.sub) },
    };
    plan.steps.into_iter().map(view).collect()
}

fn written(context: &Context<'_>, download: &Download) -> DownloadView {
    let (index, sub) = (download.index, download.sub);
    let value = download.value(context.device).unwrap_or_else(|| Value::Bytes(download.data.clone().into()));
    let reader = ValueReader { index, node_id: context.node_id };
    DownloadView {
        shown: reader.short(Some(&value), transferred_type(context.device, index, sub)),
        meaning: context.decoder.of(index, sub, &value),
        value: Some(value),
        ..view(context, index, sub)
    }
}

fn view(context: &Context<'_>, index: u16, sub: u8) -> DownloadView {
    let object = context.device.object(index);
    let names = object.map(|object| {
        let of_object = context.name(&object.main);
        match object.entry(sub).filter(|_| object.object_type().has_subs()) {
            Some(entry) => format!("{of_object} / {}", context.name(&entry)),
            None => of_object.to_owned(),
        }
    });
    DownloadView {
        entry: Anchor::entry(index, sub),
        anchor: anchor(context.device, index, sub),
        name: names.unwrap_or_default(),
        value: None,
        shown: String::new(),
        meaning: None,
    }
}
