//! Configuration of a node: checks settings against the object dictionary and computes the resulting values.
//!
//! Nothing is applied before all settings are checked, and all problems are reported together. This module
//! does not read or write files; formats do that.
//!
//! ```
//! use objdict_node::configure::{Setting, configure};
//! # use objdict_model::model::{Access, DataType, Device, Entry, Object, Value};
//! # let mut device = Device::default();
//! # let main = Entry {
//! #     name: "Producer heartbeat time".into(),
//! #     data_type: Some(DataType::UNSIGNED16),
//! #     access: Some(Access::Rw),
//! #     ..Entry::default()
//! # };
//! # device.objects.insert(0x1017, Object { main, ..Object::default() });
//! let configured = configure(&device, 5, &[Setting::value("1017=250")?]).expect("the device has 1017h");
//! assert_eq!(configured[0].value, Value::Unsigned(250));
//!
//! let problems = configure(&device, 5, &[Setting::value("1071=250")?]).expect_err("it has no 1071h");
//! assert_eq!(problems[0].help.as_deref(), Some("did you mean `1017`?"));
//! # Ok::<(), objdict_node::configure::NoSetting>(())
//! ```

mod entry;
#[cfg(feature = "serde")]
mod file;
mod pdo;
mod rebase;
mod service;
mod setting;
mod time;

use std::collections::BTreeMap;

use crate::model::{Address, Assignment, Device, ExplicitDownload, Place, Value};
use crate::resolve::ObjectName;

#[cfg(feature = "serde")]
pub use file::{SettingsFile, SettingsFileError};
pub use objdict_model::literal::nanoseconds;
pub use rebase::{Rebased, rebase};
pub use setting::{CanId, NoSetting, PdoName, PdoParameter, Setting, transmission_type, transmission_word};

/// A setting that cannot be applied.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SettingProblem {
    /// The setting as written.
    pub setting: String,
    /// The message: lower case, offending text in backticks, no full stop.
    pub message: String,
    /// How to fix it.
    pub help: Option<String>,
    /// The part of the description that contradicts the setting.
    pub place: Option<Place>,
}

objdict_model::messages! { SettingProblem: { Self { setting, message, .. } => "`{setting}`: {message}"; } }

/// A problem not yet assigned to its setting.
pub(crate) struct Wrong {
    message: String,
    help: Option<String>,
    place: Option<Place>,
}

impl Wrong {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None, place: None }
    }

    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Adds the place in the description that causes the problem.
    pub(crate) fn at(mut self, place: Place) -> Self {
        self.place = Some(place);
        self
    }

    /// The problem of an entry that the setting does not name.
    pub(crate) fn about(mut self, at: Address) -> Self {
        self.message = format!("`{}`: {}", ObjectName::Address(at), self.message);
        self
    }
}

/// Computes the values that the settings assign to the node `node_id`, in ascending order of index
/// and sub-index. If several settings write the same entry, the last one wins.
///
/// # Errors
/// Lists every setting that cannot be applied.
pub fn configure(
    device: &Device,
    node_id: u8,
    settings: &[Setting],
) -> Result<Vec<Assignment>, Vec<SettingProblem>> {
    configuration(device, node_id, settings).map(|configuration| configuration.values)
}

/// The result of applying settings to a node.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Configuration {
    /// The values that [`configure`] returns.
    pub values: Vec<Assignment>,
    /// The downloads of [`Setting::Downloads`], in the order of the settings.
    pub downloads: Vec<ExplicitDownload>,
}

/// Computes the values like [`configure`], and the explicit downloads.
///
/// # Errors
/// Lists every setting that cannot be applied.
pub fn configuration(
    device: &Device,
    node_id: u8,
    settings: &[Setting],
) -> Result<Configuration, Vec<SettingProblem>> {
    let mut configurator = Configurator { device, node_id, values: BTreeMap::new(), downloads: Vec::new() };
    let mut problems = Vec::new();
    for setting in settings {
        if let Err(wrong) = configurator.take(setting) {
            let Wrong { message, help, place } = wrong;
            problems.push(SettingProblem { setting: setting.to_string(), message, help, place });
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let values = configurator.values.into_iter();
    let values = values.map(|((index, sub), value)| Assignment { index, sub, value }).collect();
    Ok(Configuration { values, downloads: configurator.downloads })
}

/// The device and the values set so far.
struct Configurator<'a> {
    device: &'a Device,
    node_id: u8,
    values: BTreeMap<(u16, u8), Value>,
    downloads: Vec<ExplicitDownload>,
}

impl Configurator<'_> {
    fn take(&mut self, setting: &Setting) -> Result<(), Wrong> {
        match setting {
            Setting::Value { at, text } => self.address(at).and_then(|at| self.set(at, text)),
            Setting::Map { pdo, objects } => self.map(*pdo, objects),
            Setting::CobId { pdo, id } => self.cob_id(*pdo, *id),
            Setting::HeartbeatConsumer { node_id, milliseconds } => self.watch(*node_id, *milliseconds),
            Setting::Pdo { pdo, parameter, text } => self.pdo_parameter(*pdo, *parameter, text),
            Setting::Sync { id, producer, period } => self.sync(*id, *producer, period.as_deref()),
            Setting::Emcy(id) => self.emcy(*id),
            Setting::TimeStamp { id, producer, consumer } => self.time_stamp(*id, *producer, *consumer),
            Setting::Downloads { when, at, texts } => {
                self.address(at).and_then(|at| self.download(*when, at, texts))
            }
            Setting::Guard { milliseconds, factor } => self.guard(*milliseconds, *factor),
        }
    }

    /// The value of an entry, including the settings so far; `None` if unknown.
    fn value(&self, index: u16, sub: u8) -> Option<Value> {
        if let Some(value) = self.values.get(&(index, sub)) {
            return Some(value.clone());
        }
        self.device.object(index)?.value(sub).map(std::borrow::Cow::into_owned)
    }

    /// The same value as a number, for this node-ID.
    fn number(&self, index: u16, sub: u8) -> Option<u64> {
        u64::try_from(self.value(index, sub)?.integer_for(self.node_id)?).ok()
    }
}
