//! A node configured: what somebody wants of it, checked against its dictionary, and the values that this makes.
//!
//! Nothing is written before everything was checked, and all that is wrong is told at once. The room knows no files: what
//! becomes of a text is the business of its format.
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
#[cfg(feature = "toml")]
mod file;
mod heartbeat;
mod pdo;
mod setting;

use std::collections::BTreeMap;
use std::fmt;

use crate::model::{Assignment, Device, Value};

#[cfg(feature = "toml")]
pub use file::{SettingsFile, SettingsFileError};
pub use setting::{CanId, NoSetting, PdoName, Setting};

/// Why a setting cannot be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SettingProblem {
    /// The setting, as it was written.
    pub setting: String,
    /// What is wrong: lower case, offending text in backticks, no full stop.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
}

impl fmt::Display for SettingProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`: {}", self.setting, self.message)
    }
}

/// What is wrong with a setting, before it is known which one it is.
pub(crate) struct Wrong {
    message: String,
    help: Option<String>,
}

impl Wrong {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None }
    }

    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// The values that the settings make on the node `node_id`, in ascending order of index and sub-index. A later setting of
/// the same entry counts.
///
/// # Errors
/// Everything that stands in the way of any of them.
pub fn configure(
    device: &Device,
    node_id: u8,
    settings: &[Setting],
) -> Result<Vec<Assignment>, Vec<SettingProblem>> {
    let mut desk = Desk { device, node_id, values: BTreeMap::new() };
    let mut problems = Vec::new();
    for setting in settings {
        if let Err(wrong) = desk.take(setting) {
            let Wrong { message, help } = wrong;
            problems.push(SettingProblem { setting: setting.to_string(), message, help });
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let values = desk.values.into_iter();
    Ok(values.map(|((index, sub), value)| Assignment { index, sub, value }).collect())
}

/// What was set so far.
struct Desk<'a> {
    device: &'a Device,
    node_id: u8,
    values: BTreeMap<(u16, u8), Value>,
}

impl Desk<'_> {
    fn take(&mut self, setting: &Setting) -> Result<(), Wrong> {
        match setting {
            Setting::Value { at, text } => self.address(at).and_then(|at| self.set(at, text)),
            Setting::Map { pdo, objects } => self.map(*pdo, objects),
            Setting::CobId { pdo, id } => self.cob_id(*pdo, *id),
            Setting::HeartbeatConsumer { node_id, milliseconds } => self.watch(*node_id, *milliseconds),
        }
    }

    /// The value that an entry has with what was set so far; `None` where nobody knows.
    fn value(&self, index: u16, sub: u8) -> Option<Value> {
        if let Some(value) = self.values.get(&(index, sub)) {
            return Some(value.clone());
        }
        self.device.object(index)?.value(sub).map(std::borrow::Cow::into_owned)
    }

    /// The same as a number on the node.
    fn number(&self, index: u16, sub: u8) -> Option<u64> {
        u64::try_from(self.value(index, sub)?.integer_for(self.node_id)?).ok()
    }
}
