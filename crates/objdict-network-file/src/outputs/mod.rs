//! The files built from a network.

mod bus;
mod manager;
mod replay;

pub use self::replay::BuildObjection;
use std::borrow::Cow;

use super::NetworkFile;
use super::lock::locked;
use objdict_format as format;
use objdict_format::{Description, EditError, Format, NodeSettings, WriteOptions};
use objdict_model::Language;
use objdict_model::model::{Assignment, Commissioning, Device, DeviceKind, Field, Value};
use objdict_network::{
    Compiled, DcfgenMode, LelyOptions, Network, NetworkLock, Overview, Slave, Timing, TimingOptions, compile,
    configuration_file, lely_master,
};
use objdict_node::download::{ConciseDcf, EncodeError, PlanError};

/// A file that is built.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BuiltFile {
    /// Its name, without a folder.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Why a network cannot be built.
#[derive(Debug)]
#[non_exhaustive]
pub enum BuildError {
    /// The file of the network cannot be read.
    NoNetwork,
    /// There is no manager.
    NoManager,
    /// The configuration of a node cannot be sent.
    Plan {
        /// The name of the node.
        node: String,
        /// The reason.
        error: PlanError,
    },
    /// A stream is too long.
    Encode(EncodeError),
    /// A DCF cannot be written.
    Edit {
        /// The name of the node.
        node: String,
        /// The reason.
        error: EditError,
    },
}

objdict_model::error_messages! { BuildError: from EncodeError as Encode {
    Self::NoNetwork => "the file does not describe a network";
    Self::NoManager => "the network has no manager";
    Self::Plan { node, error } => "the configuration of `{node}`: {error}";
    Self::Encode(error) => "{error}";
    Self::Edit { node, error } => "the DCF of `{node}`: {error}";
} }

/// A network that was compiled, for its outputs.
#[derive(Debug)]
pub struct Build<'a> {
    file: &'a NetworkFile,
    network: &'a Network,
    compiled: Cow<'a, Compiled>,
    configured_at: Option<ConfigurationTime>,
    /// The file stems of the nodes; see [`Network::file_stems`].
    stems: Vec<String>,
}

/// A node after its configuration.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ConfiguredNode {
    /// Its position in [`Network::nodes`].
    pub node: usize,
    /// Whether it is a manager that is not in the file: its PDOs are the counterparts of the nodes' PDOs.
    pub is_made: bool,
    /// Its name.
    pub name: String,
    /// Its node-ID.
    pub node_id: u8,
    /// The effective dictionary, including the network's settings for the node.
    pub device: Device,
}

/// The time of a configuration (1020h of a node, 1F26h and 1F27h of the manager). A node that already has it
/// is not configured again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConfigurationTime {
    /// Days since 1984-01-01, not 0.
    pub days: u32,
    /// Milliseconds since midnight, not 0: for a manager, 0 means that nothing is expected.
    pub milliseconds: u32,
}

impl NetworkFile {
    /// Compiles the network.
    ///
    /// # Errors
    /// If the file does not contain one.
    pub fn build(&self, mode: DcfgenMode) -> Result<Build<'_>, BuildError> {
        let resolved = self.resolved.as_ref().ok_or(BuildError::NoNetwork)?;
        let network = resolved.network();
        let compiled = match mode {
            DcfgenMode::Corrected => Cow::Borrowed(resolved.compiled()),
            DcfgenMode::Exact => Cow::Owned(compile(network, mode)),
        };
        Ok(Build { file: self, network, compiled, configured_at: None, stems: network.file_stems() })
    }
}

impl Build<'_> {
    /// Sets the time of the configuration.
    #[must_use]
    pub fn configured_at(self, time: ConfigurationTime) -> Self {
        Self { configured_at: Some(time), ..self }
    }

    /// The values that a later build keeps.
    pub fn lock(&self) -> NetworkLock {
        locked(self.network, &self.compiled)
    }

    /// A node as its DCF describes it.
    fn described(&self, slave: &Slave) -> Device {
        let mut device = slave.described();
        if let Some(time) = self.configured_at {
            let numbers = [(1, time.days), (2, time.milliseconds)];
            let values = numbers.map(|(sub, number)| Assignment {
                index: 0x1020,
                sub,
                value: Value::Unsigned(number.into()),
            });
            device.assign(&values);
        }
        device
    }

    /// The files of Lely's master: `master.dcf`, `master.bin` and one `.bin` a node.
    ///
    /// # Errors
    /// If there is no manager, or a stream is too long.
    pub fn lely(&self, options: &LelyOptions) -> Result<Vec<BuiltFile>, BuildError> {
        let master =
            lely_master(self.network, &self.compiled.slaves, options).ok_or(BuildError::NoManager)?;
        let mut files = vec![BuiltFile { name: "master.dcf".to_owned(), bytes: master.dcf.into_bytes() }];
        if !master.bin.0.is_empty() {
            files.push(BuiltFile { name: "master.bin".to_owned(), bytes: master.bin.write()? });
        }
        for slave in &self.compiled.slaves {
            let Some(name) = configuration_file(self.network, &self.stems, slave) else { continue };
            let downloads = slave.sent(self.network.order).map_err(|error| self.unplanned(slave, error))?;
            files.push(BuiltFile { name, bytes: downloads.write()? });
        }
        Ok(files)
    }

    /// One concise DCF a node, in an order that nodes accept.
    ///
    /// # Errors
    /// If the configuration of a node cannot be sent.
    pub fn concise(&self) -> Result<Vec<BuiltFile>, BuildError> {
        let stream = |slave: &Slave| {
            let name = format!("{}.cdcf", self.stems[slave.node]);
            Ok(BuiltFile { name, bytes: self.arranged(slave)?.write()? })
        };
        self.compiled.slaves.iter().map(stream).collect()
    }

    /// The DCFs of the nodes and the manager.
    ///
    /// # Errors
    /// If a DCF cannot be written.
    pub fn dcfs(&self) -> Result<Vec<BuiltFile>, BuildError> {
        self.each_dcf().map(|(_, dcf)| dcf).collect()
    }

    /// The same, each with the position of its node in [`Network::nodes`].
    pub fn each_dcf(&self) -> impl Iterator<Item = (usize, Result<BuiltFile, BuildError>)> {
        let nodes = self.compiled.slaves.iter();
        let nodes = nodes.map(|slave| (slave.node, self.dcf(slave, &self.described(slave))));
        nodes.chain(self.compiled.manager.iter().map(|manager| (manager.node, self.manager())))
    }

    /// The nodes as their DCFs describe them, the manager last.
    ///
    /// # Errors
    /// If the configuration of a node cannot be sent.
    pub fn configured_nodes(&self) -> Result<Vec<ConfiguredNode>, BuildError> {
        let configured = |slave: &Slave, mut device: Device, is_manager| {
            let (name, node_id) = (self.name(slave), slave.node_id);
            device.commissioning = Some(self.commissioning(name, node_id, &device, is_manager));
            let is_made = self.network.is_made(slave.node);
            ConfiguredNode { node: slave.node, is_made, name: name.to_owned(), node_id, device }
        };
        let slaves = self.compiled.slaves.iter();
        let slaves = slaves.map(|slave| Ok(configured(slave, self.described(slave), false)));
        let manager = self.compiled.manager.iter();
        let manager = manager.map(|slave| Ok(configured(slave, self.manager_device()?, true)));
        slaves.chain(manager).collect()
    }

    /// The network in tables, in a language.
    pub fn overview(&self, tag: &str) -> Overview {
        Overview::in_language(self.network, &self.compiled, tag)
    }

    /// Load and response times, in a language; `None` without a bit rate.
    pub fn timing(&self, options: &TimingOptions, language: Language) -> Option<Timing> {
        Timing::in_language(self.network, &self.compiled, options, language)
    }

    /// The node list (CiA 306-3) with its DCFs.
    ///
    /// # Errors
    /// If a DCF cannot be written.
    pub fn node_list(&self) -> Result<Vec<BuiltFile>, BuildError> {
        let mut files = self.dcfs()?;
        let nodes = self.compiled.nodes().zip(&files);
        let mut nodes: Vec<(u8, &str, &str)> =
            nodes.map(|(slave, file)| (slave.node_id, self.name(slave), file.name.as_str())).collect();
        nodes.sort_unstable();
        let mut text = format!(
            "[Topology]\r\nNetName={}\r\nNodes=0x{:02X}\r\n",
            self.network.name.as_deref().unwrap_or_default(),
            nodes.len()
        );
        for (node_id, name, file) in nodes {
            text += &format!(
                "Node{node_id}Present=0x01\r\nNode{node_id}Name={name}\r\nNode{node_id}DCFName={file}\r\n"
            );
        }
        files.push(BuiltFile { name: "nodelist.cpj".to_owned(), bytes: text.into_bytes() });
        Ok(files)
    }

    fn name(&self, slave: &Slave) -> &str {
        &self.network.nodes[slave.node].name.value
    }

    fn arranged<'s>(&self, slave: &'s Slave) -> Result<Cow<'s, ConciseDcf>, BuildError> {
        let arranged = match self.configured_at {
            Some(_) => slave.arrange(&self.described(slave)).map(Cow::Owned),
            None => slave.arranged().map(Cow::Borrowed),
        };
        arranged.map_err(|error| self.unplanned(slave, error))
    }

    fn unplanned(&self, slave: &Slave, error: PlanError) -> BuildError {
        BuildError::Plan { node: self.name(slave).to_owned(), error }
    }

    /// The commissioning of a node's DCF according to the network.
    fn commissioning(&self, name: &str, node_id: u8, device: &Device, is_manager: bool) -> Commissioning {
        let own = device.commissioning.clone().unwrap_or_default();
        Commissioning {
            node_id: Some(node_id),
            node_name: Some(name.to_owned()),
            baud_rate: self.network.bit_rate.map(|rate| rate.value).or(own.baud_rate),
            network_name: self.network.name.clone().or(own.network_name),
            manager: Some(is_manager),
            ..own
        }
    }

    /// The DCF of a node: the text of an EDS or DCF with the configured values, or a new text for other
    /// formats.
    fn dcf(&self, slave: &Slave, device: &Device) -> Result<BuiltFile, BuildError> {
        let node = &self.network.nodes[slave.node];
        let name = &node.name.value;
        let failed = |error| BuildError::Edit { node: name.clone(), error };
        let is_manager = self.compiled.manager.as_ref().is_some_and(|manager| manager.node == slave.node);
        let commissioning = self.commissioning(name, slave.node_id, device, is_manager);
        let file_name = format!("{}.dcf", self.stems[slave.node]);
        let Some(description) = self.file.descriptions.get(&node.file.value).filter(|of| is_ini(of)) else {
            return written(name, file_name, device.clone(), commissioning);
        };
        let settings = NodeSettings {
            node: &commissioning,
            plugged: Some(device),
            assignments: &[],
            downloads: &device.downloads,
        };
        let configured = description.configured(&file_name, &settings).map_err(failed)?;
        Ok(BuiltFile { name: file_name, bytes: configured.bytes })
    }
}

/// Whether a description is a text in the format of CiA 306.
fn is_ini(description: &Description) -> bool {
    description.format().syntax() == format::Syntax::Ini
}

/// A new DCF of a device.
fn written(
    name: &str,
    file_name: String,
    mut device: Device,
    commissioning: Commissioning,
) -> Result<BuiltFile, BuildError> {
    let title = if commissioning.manager == Some(true) { "Manager" } else { "Node" };
    (device.kind, device.commissioning) = (DeviceKind::Node, Some(commissioning));
    let info = device.file_info.get_or_insert_default();
    info.file_name = Some(file_name.clone());
    // non-numeric versions in the vendor's file
    info.invalid_values.retain(|of| !matches!(of.field, Field::FileVersion | Field::FileRevision));
    info.file_version.get_or_insert(1);
    info.file_revision.get_or_insert(0);
    info.description.get_or_insert_with(|| format!("{title} `{name}`"));
    info.created_by.get_or_insert_with(|| "objdict".to_owned());
    let options = WriteOptions { embed: true, ..WriteOptions::default() };
    let written = format::write(&device, Format::Dcf, &options);
    let written = written.map_err(|error| BuildError::Edit { node: name.to_owned(), error })?;
    Ok(BuiltFile { name: file_name, bytes: written.bytes })
}
