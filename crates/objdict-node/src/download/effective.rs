//! The dictionary of a node after its configuration.

use std::borrow::Cow;

use super::settings::is_command;
use super::{Download, transferred_type};
use crate::model::{Assignment, Device, ExplicitDownload, Moment, Value};

/// The effective dictionary of a described node: its configured values, and over them its [downloads](Device::downloads)
/// in their order. A download before the values counts where the description configures none.
pub fn effective(device: &Device) -> Cow<'_, Device> {
    if device.downloads.is_empty() {
        return Cow::Borrowed(device);
    }
    let is_configured = |index, sub| {
        device.entry(index, sub).is_some_and(|entry: Cow<'_, _>| entry.configured_value().is_some())
    };
    let last = |download: &&ExplicitDownload| {
        let is_covered = download.when == Moment::Before && is_configured(download.index, download.sub);
        !is_command(download.index) && !is_covered
    };
    let assignment = |ExplicitDownload { index, sub, value, .. }: &ExplicitDownload| Assignment {
        index: *index,
        sub: *sub,
        value: value.clone(),
    };
    let of = |when| device.downloads.iter().filter(move |download| download.when == when);
    let values: Vec<Assignment> =
        of(Moment::Before).chain(of(Moment::After)).filter(last).map(assignment).collect();
    let mut device = device.clone();
    device.assign(&values);
    Cow::Owned(device)
}

impl Download {
    /// The bytes as a value of the entry; `None` where they are none of its data type.
    pub fn value(&self, device: &Device) -> Option<Value> {
        Value::from_bytes(&self.data, transferred_type(device, self.index, self.sub)?)
    }

    /// The value that the entry has after the download; `None` where the bytes are none of its data type, or only start an
    /// action, such as those of 1010h (store).
    pub fn assignment(&self, device: &Device) -> Option<Assignment> {
        let value = self.value(device).filter(|_| !is_command(self.index))?;
        Some(Assignment { index: self.index, sub: self.sub, value })
    }
}
