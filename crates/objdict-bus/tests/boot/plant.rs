//! Small networks.

use objdict_bus::{
    Conditions, Configurations, EventKind, Milestone, NodeRun, Plant, PlantNode, PowerOn, Run, boot,
};
use objdict_model::model::{Access, DataType, Device, Entry, Object, ObjectType, PdoMapping, Value};
use objdict_node::download::Download;

pub(crate) const MILLISECOND: u64 = 1_000_000;

/// An entry: index, sub-index, length in bits, access, value.
pub(crate) type Row = (u16, u8, u8, Access, u32);

/// A device with these entries; values above 6000h are mappable.
pub(crate) fn device(rows: &[Row]) -> Device {
    let mut device = Device::default();
    for &(index, sub, bits, access, value) in rows {
        let data_type = match bits {
            8 => DataType::UNSIGNED8,
            16 => DataType::UNSIGNED16,
            _ => DataType::UNSIGNED32,
        };
        let entry = Entry {
            data_type: Some(data_type),
            access: Some(access),
            pdo_mapping: (index >= 0x6000).then_some(PdoMapping::Optional),
            default: Some(Value::Unsigned(value.into())),
            ..Entry::default()
        };
        let is_var = sub == 0 && !rows.iter().any(|row| row.0 == index && row.1 > 0);
        let object = device.objects.get_or_insert_with(index, Object::default);
        if is_var {
            object.main = entry;
        } else {
            object.main.object_type = Some(ObjectType::Record);
            object.subs.insert(sub, entry);
        }
    }
    device
}

/// What every node has: device type, identity, heartbeat, an output with its RPDO, an input with its TPDO.
pub(crate) fn node_rows(node_id: u32) -> Vec<Row> {
    use Access::{Const, Ro, Rw, Rww};
    vec![
        (0x1000, 0, 32, Ro, 0x191),
        (0x1001, 0, 8, Ro, 0),
        (0x1005, 0, 32, Rw, 0x80),
        (0x1014, 0, 32, Rw, 0x80 + node_id),
        (0x1016, 0, 8, Const, 1),
        (0x1016, 1, 32, Rw, 0),
        (0x1017, 0, 16, Rw, 0),
        (0x1018, 0, 8, Const, 4),
        (0x1018, 1, 32, Ro, 0x3F9),
        (0x1018, 2, 32, Ro, 7),
        (0x1018, 3, 32, Ro, 0x10000),
        (0x1018, 4, 32, Ro, 99),
        (0x1400, 0, 8, Const, 2),
        (0x1400, 1, 32, Rw, 0x200 + node_id),
        (0x1400, 2, 8, Rw, 255),
        (0x1600, 0, 8, Rw, 1),
        (0x1600, 1, 32, Rw, 0x6200_0108),
        (0x1800, 0, 8, Const, 2),
        (0x1800, 1, 32, Rw, 0x180 + node_id),
        (0x1800, 2, 8, Rw, 1),
        (0x1A00, 0, 8, Rw, 1),
        (0x1A00, 1, 32, Rw, 0x6000_0108),
        (0x6000, 0, 8, Const, 1),
        (0x6000, 1, 8, Ro, 0x55),
        (0x6200, 0, 8, Const, 1),
        (0x6200, 1, 8, Rww, 0),
    ]
}

/// A manager without nodes: NMT startup, all objects about nodes with zeros.
pub(crate) fn manager_rows() -> Vec<Row> {
    use Access::{Const, Ro, Rw};
    let mut rows = vec![
        (0x1000, 0, 32, Ro, 0),
        (0x1005, 0, 32, Rw, 0x4000_0080),
        (0x1006, 0, 32, Rw, 50_000),
        (0x1016, 0, 8, Const, 3),
        (0x1016, 1, 32, Rw, 0),
        (0x1016, 2, 32, Rw, 0),
        (0x1016, 3, 32, Rw, 0),
        (0x1017, 0, 16, Rw, 0),
        (0x102A, 0, 16, Rw, 0),
        (0x1F80, 0, 32, Rw, 1),
        (0x1F89, 0, 32, Rw, 0),
    ];
    for index in [0x1F26, 0x1F27, 0x1F55, 0x1F81, 0x1F84, 0x1F85, 0x1F86, 0x1F87, 0x1F88, 0x1F8A] {
        let bits = if index == 0x1F8A { 8 } else { 32 };
        rows.extend((0..=127).map(|sub| (index, sub, if sub == 0 { 8 } else { bits }, Rw, 0)));
    }
    rows
}

/// Sets values in rows, which must be there.
pub(crate) fn set(rows: &mut [Row], values: &[(u16, u8, u32)]) {
    for &(index, sub, value) in values {
        let row = rows.iter_mut().find(|row| (row.0, row.1) == (index, sub));
        row.unwrap_or_else(|| panic!("{index:04X}:{sub:02X}")).4 = value;
    }
}

/// A network at 125 kbit/s: node 1 is the manager.
pub(crate) struct Network {
    pub(crate) manager: Vec<Row>,
    pub(crate) nodes: Vec<(u8, Vec<Row>)>,
    pub(crate) configurations: Configurations,
    pub(crate) conditions: Conditions,
    pub(crate) bit_rate: u16,
}

impl Network {
    /// With these nodes, which the manager boots.
    pub(crate) fn new(node_ids: &[u8]) -> Self {
        let mut manager = manager_rows();
        for &node_id in node_ids {
            set(&mut manager, &[(0x1F81, node_id, 5), (0x1F84, node_id, 0x191), (0x1F85, node_id, 0x3F9)]);
        }
        let nodes = node_ids.iter().map(|&node_id| (node_id, node_rows(node_id.into()))).collect();
        let conditions = Conditions::default();
        Self { manager, nodes, configurations: Configurations::new(), conditions, bit_rate: 125 }
    }

    pub(crate) fn with_manager(mut self, values: &[(u16, u8, u32)]) -> Self {
        set(&mut self.manager, values);
        self
    }

    pub(crate) fn with_node(mut self, node_id: u8, values: &[(u16, u8, u32)]) -> Self {
        let node = self.nodes.iter_mut().find(|(id, _)| *id == node_id);
        set(&mut node.expect("a node").1, values);
        self
    }

    /// The node has further entries.
    pub(crate) fn with_entries(mut self, node_id: u8, rows: &[Row]) -> Self {
        let node = self.nodes.iter_mut().find(|(id, _)| *id == node_id);
        node.expect("a node").1.extend(rows);
        self
    }

    /// The node is configured by these downloads: index, sub-index, bytes, value.
    pub(crate) fn configured(mut self, node_id: u8, downloads: &[(u16, u8, usize, u32)]) -> Self {
        let download = |&(index, sub, size, value): &(u16, u8, usize, u32)| {
            Download::new(index, sub, &value.to_le_bytes()[..size])
        };
        self.configurations.insert(node_id, Ok(downloads.iter().map(download).collect()));
        self
    }

    pub(crate) fn plant(&self) -> Plant {
        let node = |node_id: u8, rows: &[Row]| PlantNode {
            name: format!("n{node_id}"),
            node_id,
            device: device(rows),
            power_on: PowerOn::Defaults,
            must_boot: None,
        };
        Plant {
            bit_rate: self.bit_rate,
            manager: node(1, &self.manager),
            configurations: self.configurations.clone(),
            nodes: self.nodes.iter().map(|(node_id, rows)| node(*node_id, rows)).collect(),
        }
    }

    pub(crate) fn boot(&self) -> Run {
        boot(&self.plant(), &self.conditions)
    }
}

/// The frames as text: `000 8200`.
pub(crate) fn frames(run: &Run) -> Vec<String> {
    let hex = |data: &[u8]| data.iter().map(|byte| format!("{byte:02X}")).collect::<String>();
    run.frames()
        .map(|(_, _, frame)| {
            let data = if frame.is_remote() { "R".to_owned() } else { hex(frame.data()) };
            format!("{:03X} {data}", frame.id()).trim_end().to_owned()
        })
        .collect()
}

/// What became of a node.
pub(crate) fn outcome(run: &Run, node_id: u8) -> &NodeRun {
    run.nodes.iter().find(|node| node.node_id == node_id).expect("a node")
}

/// Why a node was not booted, in the words of the report.
pub(crate) fn failure(run: &Run, node_id: u8) -> (char, String) {
    match &outcome(run, node_id).milestone {
        Some(Milestone::Failed(failure)) => (failure.status(), failure.to_string()),
        milestone => panic!("{milestone:?}"),
    }
}

/// All that the manager found out, in order.
pub(crate) fn milestones(run: &Run) -> Vec<(u8, &Milestone)> {
    let found = run.events.iter().filter_map(|event| match &event.kind {
        EventKind::Milestone { node, milestone } => Some((run.nodes[*node].node_id, milestone)),
        _ => None,
    });
    found.collect()
}
