//! The files of Lely's master: `master.dcf` and `master.bin`, as dcfgen 2.4.2 writes them.
//!
//! The master has an RPDO for each TPDO of a node, and a TPDO for each RPDO, with its own objects for their
//! entries.

mod objects;
mod text;

use std::collections::BTreeSet;

use self::text::MasterText;
use crate::compiled::{DcfgenMode, PdoState, Slave};
use crate::configure::PdoName;
use crate::download::{ConciseDcf, Download};
use crate::manager::Knowledge;
use crate::messages::MessageId;
use crate::model::{BaudRates, PdoKind};
use crate::network::{Manager, Network, Node};

/// Options of Lely's files.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LelyOptions {
    /// Whether the errors of dcfgen are copied.
    pub mode: DcfgenMode,
    /// Whether the master knows the mappings of the nodes' PDOs (5800h to 5FFFh), so that programs can use their entries by
    /// index.
    pub remote_pdos: bool,
}

/// The files of the master.
#[derive(Clone, Debug)]
pub struct LelyMaster {
    /// `master.dcf`.
    pub dcf: String,
    /// The downloads of `master.bin`, which is not written if there are none.
    pub bin: ConciseDcf,
}

/// The file name for the configuration of a node; `None` without downloads. `stems` is the result of
/// [`Network::file_stems`].
pub fn configuration_file(network: &Network, stems: &[String], slave: &Slave) -> Option<String> {
    let is_empty = slave.sent(network.order).is_ok_and(|downloads| downloads.0.is_empty());
    (!is_empty).then(|| format!("{}.bin", stems[slave.node]))
}

/// The files of the master; `None` for a network without one.
pub fn lely_master(network: &Network, slaves: &[Slave], options: &LelyOptions) -> Option<LelyMaster> {
    let manager = network.manager.as_ref()?;
    let writer = LelyWriter::new(network, manager, slaves, options);
    Some(LelyMaster { dcf: writer.dcf(), bin: bin(network, manager, slaves) })
}

fn bin(network: &Network, manager: &Manager, slaves: &[Slave]) -> ConciseDcf {
    let mut downloads = Vec::new();
    let mut put = |index, sub, number: u32| {
        if number != 0 {
            downloads.push(Download::new(index, sub, number.to_le_bytes()));
        }
    };
    put(0x1018, 4, manager.serial_number);
    for slave in slaves {
        let node = &network.nodes[slave.node];
        let [_, _, _, revision, serial] = slave.identity;
        let stated = |sub, number| if node.device.entry(0x1018, sub).is_some() { number } else { 0 };
        put(0x1F55, slave.node_id, node.boot.software_version.value);
        put(0x1F87, slave.node_id, stated(3, revision));
        put(0x1F88, slave.node_id, stated(4, serial));
    }
    ConciseDcf(downloads)
}

/// The nodes' PDOs in a direction, with the numbers of their counterparts in a manager whose description is
/// [generated](Manager::is_made).
pub fn mirrored_numbers<'a>(
    network: &'a Network,
    slaves: &'a [Slave],
    kind: PdoKind,
) -> Vec<(&'a Slave, PdoName, u16)> {
    let Some(manager) = network.manager.as_ref().filter(|manager| manager.is_made) else { return Vec::new() };
    let options = &LelyOptions { mode: DcfgenMode::Corrected, remote_pdos: false };
    let writer = LelyWriter::new(network, manager, slaves, options);
    let mirrored = writer.mirrored(kind).into_iter();
    mirrored.map(|pdo| (pdo.slave, pdo.state.pdo, pdo.number)).collect()
}

/// A PDO of a node, whose counterpart belongs to the master.
#[derive(Clone, Copy)]
struct Mirrored<'a> {
    /// The number of the counterpart.
    number: u16,
    node: &'a Node,
    slave: &'a Slave,
    state: &'a PdoState,
}

impl Mirrored<'_> {
    /// The index of the counterpart's object; `first` is the index for number 1.
    const fn index(&self, first: u16) -> u16 {
        first.saturating_add(self.number - 1)
    }
}

struct LelyWriter<'a> {
    network: &'a Network,
    manager: &'a Manager,
    slaves: &'a [Slave],
    options: &'a LelyOptions,
    stems: Vec<String>,
    out: MasterText,
}

impl<'a> LelyWriter<'a> {
    fn new(
        network: &'a Network,
        manager: &'a Manager,
        slaves: &'a [Slave],
        options: &'a LelyOptions,
    ) -> Self {
        Self { network, manager, slaves, options, stems: network.file_stems(), out: MasterText::default() }
    }

    fn is_strict(&self) -> bool {
        self.options.mode == DcfgenMode::Exact
    }

    fn node(&self, slave: &Slave) -> &'a Node {
        &self.network.nodes[slave.node]
    }

    fn knowledge(&self) -> Knowledge<'a> {
        let Self { network, manager, slaves, options, .. } = *self;
        Knowledge { network, manager, slaves, mode: options.mode }
    }

    /// The nodes' PDOs in a direction, by node and number. dcfgen includes those that are finally disabled.
    fn mirrored(&self, kind: PdoKind) -> Vec<Mirrored<'a>> {
        let pdos = self.slaves.iter().flat_map(|slave| &slave.pdos);
        let sent = pdos.filter(|state| state.pdo.kind == PdoKind::Tpdo && state.is_active());
        let sent: BTreeSet<MessageId> = sent.map(PdoState::can_id).collect();
        // if the manager also sent a message between nodes, it would be a second sender
        let is_between_nodes =
            |state: &PdoState| state.pdo.kind == PdoKind::Rpdo && sent.contains(&state.can_id());
        let is_used = |state: &&PdoState| {
            state.pdo.kind == kind
                && state.cob_id >> 31 == 0
                && !state.mapping.is_empty()
                && (state.is_enabled || self.is_strict())
                && (self.is_strict() || !is_between_nodes(state))
        };
        let of_slave = |slave: &'a Slave| {
            let node = self.node(slave);
            let mut pdos: Vec<_> = slave.pdos.iter().filter(is_used).collect();
            pdos.sort_by_key(|state| state.pdo.number);
            pdos.into_iter().map(move |state| Mirrored { number: 0, node, slave, state })
        };
        let mut mirrored: Vec<_> = self.slaves.iter().flat_map(of_slave).collect();
        let lock = &self.network.lock;
        let mut unlocked = (1..).filter(|number| !lock.has_manager_pdo(kind, *number));
        let mut taken = BTreeSet::new();
        for pdo in &mut mirrored {
            let locked = lock.pdo(&pdo.node.name.value, pdo.state.pdo).and_then(|locked| locked.manager);
            let locked = locked.filter(|number| taken.insert(*number));
            pdo.number = locked.or_else(|| unlocked.next()).unwrap_or(u16::MAX);
        }
        mirrored.sort_by_key(|pdo| pdo.number);
        mirrored
    }

    /// The path of a node's configuration for 1F22h. dcfgen omits it if it only contains 1016h.
    fn upload(&self, slave: &Slave) -> Option<String> {
        let file = configuration_file(self.network, &self.stems, slave)
            .filter(|_| !self.is_strict() || !slave.has_only_consumers)?;
        let folder = self.node(slave).run_time_folder.as_deref().unwrap_or(&self.network.run_time_folder);
        let between = if folder.is_empty() || folder.ends_with('/') { "" } else { "/" };
        Some(format!("{folder}{between}{file}"))
    }

    fn dcf(mut self) -> String {
        let (received, sent) = (self.mirrored(PdoKind::Tpdo), self.mirrored(PdoKind::Rpdo));
        self.head(received.len(), sent.len());
        self.lists(&received, &sent);
        self.communication();
        self.pdos(&received, &sent);
        self.boot();
        self.application(&received, &sent);
        self.out.0
    }

    fn head(&mut self, received: usize, sent: usize) {
        let manager = self.manager;
        let [vendor, product, revision] = manager.identity;
        let out = &mut self.out;
        out.section("DeviceComissioning");
        out.key("NodeID", manager.node_id.map_or(255, |node_id| node_id.value));
        out.keys(&["NodeName", "NodeRefd"]);
        match self.network.bit_rate {
            Some(rate) => out.key("Baudrate", rate.value),
            None => out.keys(&["Baudrate"]),
        }
        out.key("NetNumber", 1);
        out.keys(&["NetworkName", "NetRefd"]);
        out.key("CANopenManager", 1);
        out.hex("LSS_SerialNumber", manager.serial_number);
        out.section("DeviceInfo");
        out.keys(&["VendorName"]);
        out.hex("VendorNumber", vendor);
        out.keys(&["ProductName"]);
        out.hex("ProductNumber", product);
        out.hex("RevisionNumber", revision);
        out.keys(&["OrderCode"]);
        for rate in BaudRates::DEFINED {
            out.key(&format!("BaudRate_{rate}"), 1);
        }
        for (key, value) in [
            ("SimpleBootUpMaster", 1),
            ("SimpleBootUpSlave", 0),
            ("Granularity", 1),
            ("DynamicChannelsSupported", 0),
            ("GroupMessaging", 0),
            ("NrOfRxPDO", received),
            ("NrOfTxPDO", sent),
            ("LSS_Supported", 1),
        ] {
            out.key(key, value);
        }
        out.section("DummyUsage");
        for data_type in (1..=7).chain([0x10]).chain(0x12..=0x16).chain(0x18..=0x1B) {
            out.key(&format!("Dummy{data_type:04X}"), 1);
        }
    }

    /// The objects of the master, in the order of its object lists.
    fn lists(&mut self, received: &[Mirrored<'_>], sent: &[Mirrored<'_>]) {
        let range = |first: u16, pdos: &[Mirrored<'_>]| -> Vec<u16> {
            pdos.iter().map(|pdo| pdo.index(first)).collect()
        };
        let some = |index, is_there: bool| is_there.then_some(index);
        let optional = [0x1003, 0x1005, 0x1006, 0x1007, 0x1012, 0x1013, 0x1014, 0x1015].into_iter();
        let optional = optional
            .chain(some(0x1016, self.manager.monitors_nodes()))
            .chain([0x1017, 0x1019, 0x1028, 0x1029, 0x102A])
            .chain(range(0x1400, received))
            .chain(range(0x1600, received))
            .chain(range(0x1800, sent))
            .chain(range(0x1A00, sent))
            .chain(some(0x1F22, self.slaves.iter().any(|slave| self.upload(slave).is_some())))
            .chain([0x1F25, 0x1F55])
            .chain(some(
                0x1F58,
                self.slaves.iter().any(|slave| self.node(slave).boot.software_file.is_some()),
            ))
            .chain(0x1F80..=0x1F82)
            .chain(0x1F84..=0x1F8A)
            .collect();
        let has_remote = self.options.remote_pdos;
        let remote = |first, pdos| if has_remote { range(first, pdos) } else { Vec::new() };
        let manufacturer = objects::indexes(0x2000, received)
            .chain(objects::indexes(0x2200, sent))
            .chain(remote(0x5800, received))
            .chain(remote(0x5A00, received))
            .chain(remote(0x5C00, sent))
            .chain(remote(0x5E00, sent))
            .collect();
        self.out.list("MandatoryObjects", vec![0x1000, 0x1001, 0x1018]);
        self.out.list("OptionalObjects", optional);
        self.out.list("ManufacturerObjects", manufacturer);
    }
}
