//! Values of a node that are set: the description becomes that of a node, as `objdict configure` makes it.

use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use objdict::configure::{Configuration, Setting, SettingProblem, SettingsFile, configuration, rebase};
use objdict::format::{self, Description, Format, NodeSettings, Syntax, WriteOptions};
use objdict::model::{Assignment, Commissioning, Device, DeviceKind, NoAddress};
use objdict::source::{MAX_TOML_SIZE, SourceFile, SourceOptions, read_text};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::shared::{Described, SharedDescription, SharedDevice};
use super::{raised, unreadable};

/// What a node is to be.
#[derive(Default)]
pub(crate) struct WantedValues {
    /// Names of entries with the texts of their values.
    settings: Vec<(String, String)>,
    file: Option<PathBuf>,
    node_id: Option<u8>,
    bit_rate: Option<u16>,
}

impl WantedValues {
    /// The values of a file, then those of entries, for a node.
    pub(crate) fn new(
        settings: Vec<(String, String)>,
        file: Option<PathBuf>,
        node_id: Option<u8>,
        bit_rate: Option<u16>,
    ) -> Self {
        Self { settings, file, node_id, bit_rate }
    }

    /// The value of one entry.
    pub(crate) fn value(setting: (String, String)) -> Self {
        Self { settings: vec![setting], ..Self::default() }
    }
}

/// Sets values of a device; all of them, or none.
pub(crate) fn set(device: &SharedDevice, wanted: WantedValues) -> PyResult<()> {
    let shared = device.now();
    let file = match &wanted.file {
        Some(path) => {
            SettingsFile::parse(&read_text(path, MAX_TOML_SIZE).map_err(unreadable)?).map_err(raised)?
        }
        None => SettingsFile::default(),
    };
    let values = wanted
        .settings
        .iter()
        .map(|(name, text)| Ok(Setting::Value { at: name.parse()?, text: text.clone() }));
    let values: Vec<Setting> = values.collect::<Result<_, NoAddress>>().map_err(raised)?;
    let settings = [file.settings.clone(), values].concat();
    let node = node(&shared, &file, &wanted)?;
    device.set(configured(&shared, &node, &settings)?);
    Ok(())
}

/// The node that the values are for.
fn node(shared: &SharedDescription, file: &SettingsFile, wanted: &WantedValues) -> PyResult<Commissioning> {
    let own = shared.device().commissioning.clone().unwrap_or_default();
    let node_id = wanted.node_id.or(file.node_id).or(shared.node_id);
    if node_id.is_none_or(|node_id| !(1..=127).contains(&node_id)) {
        let message = "values are those of a node: give its `node_id`, 1 to 127, to `load` or `configure`";
        return Err(PyValueError::new_err(message));
    }
    Ok(Commissioning {
        node_id,
        baud_rate: wanted.bit_rate.or(file.baud_rate).or(own.baud_rate),
        node_name: file.name.clone().or(own.node_name),
        net_number: file.net_number.or(own.net_number),
        network_name: file.network_name.clone().or(own.network_name),
        manager: file.manager.or(own.manager),
        lss_serial_number: file.lss_serial_number.or(own.lss_serial_number),
        ..own
    })
}

/// The description with the values that a node has now.
pub(crate) fn with_present(
    shared: &SharedDescription,
    node_id: u8,
    assignments: &[Assignment],
) -> PyResult<SharedDescription> {
    let node = node(
        shared,
        &SettingsFile::default(),
        &WantedValues { node_id: Some(node_id), ..WantedValues::default() },
    )?;
    assigned(shared, &node, &Configuration { values: assignments.to_vec(), ..Configuration::default() })
}

/// The description with the values of settings.
fn configured(
    shared: &SharedDescription,
    node: &Commissioning,
    settings: &[Setting],
) -> PyResult<SharedDescription> {
    let node_id = node.node_id.unwrap_or_default();
    let mut device = Cow::Borrowed(shared.device());
    let former = device.node_id().filter(|former| *former != node_id && (1..=127).contains(former));
    // CAN-IDs that follow the node-ID
    let followers = former.map(|former| rebase(&device, former).assignments).unwrap_or_default();
    if !followers.is_empty() {
        device.to_mut().assign(&followers);
    }
    let found = configuration(&device, node_id, settings).map_err(|problems| {
        let line = |problem: &SettingProblem| {
            let help = problem.help.as_ref().map(|help| format!(" ({help})")).unwrap_or_default();
            format!("{problem}{help}")
        };
        PyValueError::new_err(problems.iter().map(line).collect::<Vec<_>>().join("\n"))
    })?;
    let values = [followers, found.values].concat();
    assigned(shared, node, &Configuration { values, downloads: found.downloads })
}

/// The description with these values.
fn assigned(
    shared: &SharedDescription,
    node: &Commissioning,
    configuration: &Configuration,
) -> PyResult<SharedDescription> {
    let of_model;
    let description = match &shared.described {
        Described::Text(description) => description,
        Described::Model(device, source) => {
            of_model = text_of(device, source.name())?;
            &of_model
        }
    };
    let written = Format::of(description.format().syntax(), DeviceKind::Node);
    let ending = match written.syntax() {
        Syntax::Ini => "dcf",
        Syntax::Xml => "xdc",
        Syntax::Toml => "toml",
    };
    let name = Path::new(description.source().name()).with_extension(ending);
    let name = name.to_string_lossy().into_owned();
    let Configuration { values: assignments, downloads } = configuration;
    let parts = NodeSettings { node, plugged: None, assignments, downloads };
    let bytes = description.configured(&name, &parts).map_err(raised)?.bytes;
    let source = SourceFile::from_bytes(&*name, bytes, &SourceOptions::default()).map_err(raised)?;
    Ok(SharedDescription {
        described: Described::Text(Box::new(format::read(source, written))),
        path: shared.path.clone(),
        node_id: node.node_id,
        revision: shared.revision.wrapping_add(1),
        project: shared.project.clone(),
        meanings: OnceLock::new(),
    })
}

/// The EDS or DCF that the JSON of a device becomes.
fn text_of(device: &Device, name: &str) -> PyResult<Box<Description>> {
    let mut options = WriteOptions::default();
    options.embed = true;
    let kind = Format::of(Syntax::Ini, device.kind);
    let bytes = format::write(device, kind, &options).map_err(raised)?.bytes;
    let source = SourceFile::from_bytes(name, bytes, &SourceOptions::default()).map_err(raised)?;
    Ok(Box::new(format::read(source, kind)))
}
