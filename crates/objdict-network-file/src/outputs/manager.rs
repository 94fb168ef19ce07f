//! The manager as a device: the expected properties of the nodes, and their configurations.

use super::{Build, BuildError, BuiltFile};
use objdict_model::model::{
    Access, Assignment, Compact, DataType, Device, Entry, Object, ObjectType, Subs, Value,
};
use objdict_network::Slave;

const CONCISE_DCF: u16 = 0x1F22;

impl Build<'_> {
    /// The DCF of the manager, with the concise DCF of each node in 1F22h. Objects that its description does not have are added.
    ///
    /// # Errors
    /// If there is no manager, or the configuration of a node cannot be sent.
    pub fn manager(&self) -> Result<BuiltFile, BuildError> {
        let manager = self.compiled.manager.as_ref().ok_or(BuildError::NoManager)?;
        self.dcf(manager, &self.manager_device()?)
    }

    /// The manager with its values.
    ///
    /// # Errors
    /// If there is none, or the configuration of a node cannot be sent.
    pub fn manager_device(&self) -> Result<Device, BuildError> {
        let mut device = self.compiled.manager.as_ref().ok_or(BuildError::NoManager)?.described();
        self.configure(&mut device)?;
        if let Some(time) = self.configured_at {
            self.expect(&mut device, 0x1F26, "Expected configuration date", time.days);
            self.expect(&mut device, 0x1F27, "Expected configuration time", time.milliseconds);
        }
        Ok(device)
    }

    /// Puts the concise DCF of each node into 1F22h.
    fn configure(&self, device: &mut Device) -> Result<(), BuildError> {
        if device.object(CONCISE_DCF).is_none() {
            add(device, CONCISE_DCF, domains("Concise DCF"));
        }
        for slave in &self.compiled.slaves {
            let stream = self.arranged(slave)?.write()?;
            let Some(object) = device.objects.get_mut(&CONCISE_DCF) else { continue };
            if let Some(entry) = object.subs.get_mut(slave.node_id) {
                entry.access = Some(Access::Rw);
                entry.configured_mut().upload_file = None;
            }
            let value = Value::Bytes(stream.into());
            device.assign(&[Assignment { index: CONCISE_DCF, sub: slave.node_id, value }]);
        }
        Ok(())
    }

    /// Adds an array with the same number for each node that can store it (1020h).
    fn expect(&self, device: &mut Device, index: u16, name: &str, number: u32) {
        let has_it = |slave: &&Slave| slave.device.object(0x1020).is_some();
        let values = self.compiled.slaves.iter().filter(has_it);
        let mut values: Vec<(u8, Value)> =
            values.map(|slave| (slave.node_id, Value::Unsigned(number.into()))).collect();
        values.sort_unstable_by_key(|(node_id, _)| *node_id);
        if device.object(index).is_some() {
            let values = values.into_iter().map(|(sub, value)| Assignment { index, sub, value });
            return device.assign(&values.collect::<Vec<_>>());
        }
        let main = Entry {
            name: name.into(),
            object_type: Some(ObjectType::Array),
            data_type: Some(DataType::UNSIGNED32),
            access: Some(Access::Rw),
            ..Entry::default()
        };
        let compact = Some(Box::new(Compact { count: 127, values, ..Compact::default() }));
        add(device, index, Object { main, compact, ..Object::default() });
    }
}

/// Adds an object to a dictionary and its lists.
fn add(device: &mut Device, index: u16, object: Object) {
    device.objects.insert(index, object);
    device.lists.add(index);
}

/// An array with a DOMAIN for each node.
fn domains(name: &str) -> Object {
    let entry = |name: String| Entry {
        name: name.into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(DataType::DOMAIN),
        access: Some(Access::Rw),
        ..Entry::default()
    };
    let main = Entry { name: name.into(), object_type: Some(ObjectType::Array), ..Entry::default() };
    let mut subs = Subs::default();
    let highest = Entry {
        data_type: Some(DataType::UNSIGNED8),
        access: Some(Access::Const),
        default: Some(Value::Unsigned(127)),
        ..entry("Highest sub-index supported".to_owned())
    };
    subs.insert(0, highest);
    for node_id in 1..=127 {
        subs.insert(node_id, entry(format!("Node-ID {node_id}")));
    }
    Object { main, subs, sub_number: Some(128), ..Object::default() }
}
