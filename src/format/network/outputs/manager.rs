//! The manager as a device: what it expects of the nodes, and their configurations.

use super::{Build, BuildError, BuiltFile, written};
use crate::format::{self, Format};
use crate::model::{
    Access, Assignment, Compact, DataType, Device, DeviceKind, Entry, Object, ObjectList, ObjectType, Value,
};
use crate::network::{LelyOptions, Slave, lely_master};
use crate::source::SourceFile;

/// The objects about the nodes (CiA 301, CiA 302-2, CiA 302-3).
const OBJECTS: [u16; 18] = [
    0x1016, 0x1028, 0x1F22, 0x1F25, 0x1F26, 0x1F27, 0x1F55, 0x1F80, 0x1F81, 0x1F82, 0x1F84, 0x1F85, 0x1F86,
    0x1F87, 0x1F88, 0x1F89, 0x1F8A, 0x102A,
];

const CONCISE_DCF: u16 = 0x1F22;

impl Build<'_> {
    /// The DCF of the manager, with the concise DCF of each node in 1F22h: of its description, to which missing objects are
    /// added, or else of a manager with a PDO for each PDO of a node.
    ///
    /// # Errors
    /// When there is no manager, or the configuration of a node cannot be sent.
    pub fn manager(&self) -> Result<BuiltFile, BuildError> {
        let device = self.manager_device()?;
        if let Some(manager) = &self.compiled.manager {
            return self.dcf(manager, &device);
        }
        let manager = self.network.manager.as_ref().ok_or(BuildError::NoManager)?;
        let node_id = manager.node_id.ok_or(BuildError::NoManager)?;
        let commissioning = self.commissioning(&manager.name.value, node_id.value, &device, true);
        written(&manager.name.value, device, commissioning)
    }

    /// The manager with its values.
    ///
    /// # Errors
    /// When there is none, or the configuration of a node cannot be sent.
    pub fn manager_device(&self) -> Result<Device, BuildError> {
        let made = self.made()?;
        let Some(manager) = &self.compiled.manager else { return Ok(made) };
        let mut device = manager.described();
        for index in OBJECTS {
            let Some(object) = made.object(index) else { continue };
            if device.object(index).is_none() {
                device.objects.insert(index, object.clone());
                if let Some(list) = ObjectList::of(index) {
                    device.lists.get_mut(list).get_or_insert_default().push(index);
                }
                continue;
            }
            device.assign(&values(index, object));
        }
        Ok(device)
    }

    /// A manager without a description of its own, which has what Lely's master has.
    fn made(&self) -> Result<Device, BuildError> {
        let options = LelyOptions::default();
        let master =
            lely_master(self.network, &self.compiled.slaves, &options).ok_or(BuildError::NoManager)?;
        let description = format::read(SourceFile::from_text("master.dcf", master.dcf), Format::Dcf);
        let mut device = description.device().clone();
        device.kind = DeviceKind::Node;
        for slave in &self.compiled.slaves {
            let stream = self.arranged(slave)?;
            let Some(entry) =
                device.objects.get_mut(&CONCISE_DCF).and_then(|object| object.subs.get_mut(slave.node_id))
            else {
                continue;
            };
            entry.access = Some(Access::Rw);
            let configured = entry.configured_mut();
            configured.upload_file = None;
            configured.value = Some(Value::Bytes(stream.write()?.into()));
        }
        let identity = |position: usize, index| {
            let of = self.compiled.slaves.iter().filter(move |slave| slave.identity[position] != 0);
            of.map(move |slave| Assignment {
                index,
                sub: slave.node_id,
                value: Value::Unsigned(slave.identity[position].into()),
            })
        };
        // without the retry factor that dcfgen states for all nodes
        let assignment = |slave: &Slave| {
            let number = self.network.nodes[slave.node].boot.to_number(slave.guard_time);
            Assignment { index: 0x1F81, sub: slave.node_id, value: Value::Unsigned(number.into()) }
        };
        let assignments = self.compiled.slaves.iter().map(assignment);
        let stated: Vec<Assignment> =
            identity(3, 0x1F87).chain(identity(4, 0x1F88)).chain(assignments).collect();
        device.assign(&stated);
        if let Some(time) = self.configured_at {
            self.expect(&mut device, 0x1F26, "Expected configuration date", time.days);
            self.expect(&mut device, 0x1F27, "Expected configuration time", time.milliseconds);
        }
        Ok(device)
    }
}

impl Build<'_> {
    /// Adds an array with the same number for each node that can keep it (1020h).
    fn expect(&self, device: &mut Device, index: u16, name: &str, number: u32) {
        let has_it = |slave: &&Slave| slave.device.object(0x1020).is_some();
        let values = self.compiled.slaves.iter().filter(has_it);
        let mut values: Vec<(u8, Value)> =
            values.map(|slave| (slave.node_id, Value::Unsigned(number.into()))).collect();
        values.sort_unstable_by_key(|(node_id, _)| *node_id);
        let main = Entry {
            name: name.into(),
            object_type: Some(ObjectType::Array),
            data_type: Some(DataType::UNSIGNED32),
            access: Some(Access::Rw),
            ..Entry::default()
        };
        let compact = Some(Box::new(Compact { count: 127, values, ..Compact::default() }));
        device.objects.insert(index, Object { main, compact, ..Object::default() });
        if let Some(list) = ObjectList::of(index) {
            device.lists.get_mut(list).get_or_insert_default().push(index);
        }
    }
}

/// The values of an object.
fn values(index: u16, object: &Object) -> Vec<Assignment> {
    let stated = object.entries().filter(|(sub, _)| *sub > 0 || !object.object_type().has_subs());
    stated.filter_map(|(sub, entry)| Some(Assignment { index, sub, value: entry.value()?.clone() })).collect()
}
