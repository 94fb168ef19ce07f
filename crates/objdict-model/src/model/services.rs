//! The services of CiA 301 except PDOs, as configured by the communication objects (§7.5.2).

use super::{CobId, Device, Object, predefined};

/// The services of a device after configuration ([`Entry::value`](super::Entry::value)). A field is `None`
/// if the description has no such entry, no value, or a value that is not valid.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Services {
    /// COB-ID of SYNC, 1005h. Bit 30: the device produces it.
    pub sync: Option<CobId>,
    /// Communication cycle period in microseconds, 1006h; 0: SYNC is not produced.
    pub communication_cycle_period: Option<u32>,
    /// Synchronous window length in microseconds, 1007h.
    pub synchronous_window: Option<u32>,
    /// Synchronous counter overflow value, 1019h; 0: SYNC has no counter.
    pub sync_counter_overflow: Option<u8>,
    /// COB-ID of TIME, 1012h. Bit 31: the device consumes it. Bit 30: it produces it.
    pub time: Option<CobId>,
    /// COB-ID of EMCY, 1014h. Bit 31: the device does not send EMCY.
    pub emcy: Option<CobId>,
    /// Inhibit time of EMCY in multiples of 100 µs, 1015h.
    pub emcy_inhibit_time: Option<u16>,
    /// Producer heartbeat time in milliseconds, 1017h; 0: the device sends no heartbeat.
    pub heartbeat_time: Option<u16>,
    /// The nodes whose heartbeat the device monitors, 1016h, by sub-index; without unused entries.
    pub heartbeat_consumers: Vec<HeartbeatConsumer>,
    /// SDO servers, 1200h to 127Fh, by number.
    pub sdo_servers: Vec<SdoChannel>,
    /// SDO clients, 1280h to 12FFh, by number.
    pub sdo_clients: Vec<SdoChannel>,
}

/// An entry of 1016h in use (CiA 301 §7.5.2.19).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct HeartbeatConsumer {
    /// Sub-index, 1 to 127.
    pub sub: u8,
    /// The node that sends the heartbeat, 1 to 127.
    pub node_id: u8,
    /// The maximum time between two heartbeats in milliseconds, not 0.
    pub time: u16,
}

impl HeartbeatConsumer {
    /// The content of a sub-index; `None` if it is unused.
    pub const fn from_number(sub: u8, number: u32) -> Option<Self> {
        let [low, high, node_id, _] = number.to_le_bytes();
        let time = u16::from_le_bytes([low, high]);
        if node_id == 0 || node_id > 127 || time == 0 {
            return None;
        }
        Some(Self { sub, node_id, time })
    }
}

/// An SDO channel (CiA 301 §7.5.2.33, §7.5.2.34). Bit 31 of a COB-ID: the channel is not valid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SdoChannel {
    /// Number, 1 to 128.
    pub number: u16,
    /// The index of its parameter.
    pub index: u16,
    /// COB-ID from client to server, sub-index 1. The default of the first server is 600h plus the node-ID.
    pub request: Option<CobId>,
    /// COB-ID from server to client, sub-index 2. The default of the first server is 580h plus the node-ID.
    pub response: Option<CobId>,
    /// The node-ID of the peer, sub-index 3.
    pub node_id: Option<u8>,
}

impl Device {
    /// The services that the communication objects configure.
    pub fn services(&self) -> Services {
        Services {
            sync: self.cob_id(0x1005, 0),
            communication_cycle_period: self.number(0x1006, 0),
            synchronous_window: self.number(0x1007, 0),
            sync_counter_overflow: self.number(0x1019, 0),
            time: self.cob_id(0x1012, 0),
            emcy: self.cob_id(0x1014, 0),
            emcy_inhibit_time: self.number(0x1015, 0),
            heartbeat_time: self.number(0x1017, 0),
            heartbeat_consumers: self.heartbeat_consumers(),
            sdo_servers: self.sdo_channels(0x1200),
            sdo_clients: self.sdo_channels(0x1280),
        }
    }

    fn number<T: TryFrom<i128>>(&self, index: u16, sub: u8) -> Option<T> {
        number(self.object(index)?, sub)
    }

    fn cob_id(&self, index: u16, sub: u8) -> Option<CobId> {
        CobId::from_value(self.value(index, sub)?.as_ref())
    }

    fn heartbeat_consumers(&self) -> Vec<HeartbeatConsumer> {
        let Some(object) = self.object(0x1016) else { return Vec::new() };
        let subs = 1..=object.highest_sub().unwrap_or(0).min(127);
        subs.filter_map(|sub| HeartbeatConsumer::from_number(sub, number(object, sub)?)).collect()
    }

    /// The channels whose parameters start at an index, at most 128.
    fn sdo_channels(&self, first: u16) -> Vec<SdoChannel> {
        let channel = |(&index, object): (&u16, &Object)| {
            let implied = |base| (index == 0x1200).then_some(predefined::per_node(base));
            let cob_id = |sub, base| match object.value(sub) {
                Some(value) => CobId::from_value(&value),
                None => implied(base),
            };
            SdoChannel {
                number: index - first + 1,
                index,
                request: cob_id(1, predefined::SDO_REQUEST),
                response: cob_id(2, predefined::SDO_RESPONSE),
                node_id: number(object, 3),
            }
        };
        self.objects.range(first..first + 0x80).map(channel).collect()
    }
}

/// The value of a sub-index as a number.
fn number<T: TryFrom<i128>>(object: &Object, sub: u8) -> Option<T> {
    object.value(sub)?.as_integer().and_then(|number| T::try_from(number).ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Entry, ObjectType, Value};

    fn put(device: &mut Device, index: u16, values: &[(u8, Option<Value>)]) {
        let mut object = Object::default();
        object.main.object_type = Some(ObjectType::Record);
        for (sub, value) in values {
            object.subs.insert(*sub, Entry { default: value.clone(), ..Entry::default() });
        }
        device.objects.insert(index, object);
    }

    #[test]
    fn consumers_in_use_are_decoded() {
        let mut device = Device::default();
        let number = |number: u64| Some(Value::Unsigned(number));
        let numbers = [0, 0x0003_01F4, 0x0004_0000, 0x0080_0001, 0x007F_FFFF];
        let subs: Vec<_> = (1..).zip(numbers.map(number)).collect();
        put(&mut device, 0x1016, &subs);
        let consumers = device.services().heartbeat_consumers;
        let consumers: Vec<_> =
            consumers.iter().map(|found| (found.sub, found.node_id, found.time)).collect();
        assert_eq!(consumers, [(2, 3, 500), (5, 127, 0xFFFF)]);
    }

    #[test]
    fn only_the_first_server_has_cob_ids_of_its_own() {
        let mut device = Device::default();
        for index in [0x1200, 0x1201, 0x1280] {
            put(&mut device, index, &[(1, None), (2, Some(Value::Raw("?".into())))]);
        }
        let services = device.services();
        let channels = services.sdo_servers.iter().chain(&services.sdo_clients);
        let found: Vec<_> =
            channels.map(|channel| (channel.number, channel.request, channel.response)).collect();
        assert_eq!(found, [(1, Some(predefined::per_node(0x600)), None), (2, None, None), (1, None, None)]);
    }
}
