//! canopen-rs: the function creates an `ObjectDictionary`, and the node of the crate answers from it.

use canopen_rs::node::Node;
use canopen_rs::{
    AccessType, Address, DataType, Entry, Error, NodeId, ObjectDictionary, SdoClient, SdoEvent, Value,
};
use objdict::model::TypeKind;

use crate::truth::{Row, truth};
use crate::{counted, devices, generated, noted};

include!(concat!(env!("OUT_DIR"), "/canopen_rs.rs"));

/// Creates the node of a device with a node-ID.
type Start = fn(u8) -> Box<dyn Served>;

/// A node with a dictionary of any size.
pub(crate) trait Served {
    fn capacity(&self) -> usize;
    fn entry(&self, index: u16, sub: u8) -> Option<Entry>;
    fn refuses_more(&mut self) -> bool;
    /// The result of an SDO upload, or the abort code.
    fn upload(&mut self, index: u16, sub: u8, data_type: DataType) -> Result<Value, u32>;
}

impl<const N: usize> Served for Node<N> {
    fn capacity(&self) -> usize {
        N
    }

    fn entry(&self, index: u16, sub: u8) -> Option<Entry> {
        self.od().entry(Address::new(index, sub)).copied()
    }

    fn refuses_more(&mut self) -> bool {
        let more = Entry::rw(Value::Boolean(false));
        self.od_mut().insert(Address::new(0xFFFF, 0xFF), more) == Err(Error::DictionaryFull)
    }

    fn upload(&mut self, index: u16, sub: u8, data_type: DataType) -> Result<Value, u32> {
        let mut client = SdoClient::new(self.node_id());
        let mut request = client.read(Address::new(index, sub), data_type);
        loop {
            let response = self.on_frame(client.request_cob_id(), &request).unwrap();
            match client.on_response(response.data().try_into().unwrap()) {
                SdoEvent::Send(next) => request = next,
                SdoEvent::Complete(Some(value)) => return Ok(value),
                SdoEvent::Aborted(code) => return Err(code),
                SdoEvent::Complete(None) => panic!("no value was read"),
            }
        }
    }
}

/// The node of a dictionary.
fn served<const N: usize>(od: ObjectDictionary<N>, node_id: u8) -> Box<dyn Served> {
    let mut node = Node::new(NodeId::new(node_id).unwrap(), od);
    node.boot();
    node.configure_pdos_from_od();
    Box::new(node)
}

/// Results for the entries of a device.
#[derive(Default)]
struct Outcomes {
    same: usize,
    left_out: Vec<(u16, u8)>,
    octets: Vec<(u16, u8)>,
}

fn bytes(value: Value) -> Vec<u8> {
    let mut buffer = [0; 32];
    let length = value.encode_le(&mut buffer).unwrap();
    buffer[..length].to_vec()
}

fn compare(name: &str, row: &Row, node: &mut dyn Served, outcomes: &mut Outcomes) {
    let at = (row.index, row.sub);
    let Some(entry) = node.entry(row.index, row.sub) else {
        outcomes.left_out.push(at);
        return;
    };
    assert_eq!(bytes(entry.value), row.default.clone().unwrap(), "{name}: {row}");
    let access = (entry.access.is_readable(), entry.access.is_writable());
    assert_eq!(access, (row.read, row.write), "{name}: {row}");
    let data_type = entry.value.data_type();
    if row.data_type == Some(data_type.index()) {
        outcomes.same += 1;
    } else {
        assert_eq!(data_type, DataType::OctetString, "{name}: {row}");
        outcomes.octets.push(at);
    }
    let uploaded = node.upload(row.index, row.sub, data_type);
    match (row.read, entry.value) {
        (false, _) => assert_eq!(uploaded, Err(0x0601_0001), "{name}: {row}"),
        (true, Value::Real32(number)) if number.is_nan() => {}
        (true, Value::Real64(number)) if number.is_nan() => {}
        (true, value) => assert_eq!(uploaded, Ok(value), "{name}: {row}"),
    }
}

#[test]
fn every_entry_is_read_back_or_has_its_note() {
    let mut same = 0;
    for ((name, device), &(known, make)) in devices::devices().iter().zip(DEVICES) {
        assert_eq!(name, known);
        let notes = generated(device, "canopen-rs").notes;
        for node_id in [1, 5, 127] {
            let mut node = make(node_id);
            let mut outcomes = Outcomes::default();
            let rows = truth(device, node_id);
            rows.iter().for_each(|row| compare(name, row, node.as_mut(), &mut outcomes));
            assert_eq!(
                node.capacity(),
                rows.len() - outcomes.left_out.len(),
                "{name}: entries that nobody described"
            );
            assert!(node.refuses_more(), "{name}");
            assert_eq!(
                counted(&outcomes.left_out),
                noted(&notes, "is omitted: the crate supports"),
                "{name}"
            );
            assert_eq!(counted(&outcomes.octets), noted(&notes, "stored as an octet string"), "{name}");
            same += outcomes.same;
        }
    }
    assert!(same > 3000, "only {same} entries were compared");
}

/// SDO writes follow the description, except for limits, which the notes mention.
#[test]
fn limits_have_their_notes() {
    for (name, device) in devices::devices() {
        let limited: Vec<(u16, u8)> = crate::oracle::facts_of(&device)
            .filter(|(_, facts)| facts.low.is_some() || facts.high.is_some())
            .filter(|(_, facts)| !matches!(facts.kind, None | Some(TypeKind::Domain)))
            .map(|(at, _)| at)
            .collect();
        assert_eq!(counted(&limited), noted(&generated(&device, "canopen-rs").notes, "limits are"), "{name}");
    }
}

/// The example in docs/targets/canopen-rs.md.
#[test]
fn the_example_of_the_page() {
    use minimal::{address, od};

    let mut node = Node::new(NodeId::new(5).unwrap(), od(5));
    node.boot();
    node.configure_pdos_from_od();
    assert_eq!(node.od().read(address::PRODUCER_HEARTBEAT_TIME), Ok(Value::Unsigned16(1000)));
    node.od_mut().write(address::PRODUCER_HEARTBEAT_TIME, Value::Unsigned16(500)).unwrap();
    let access = node.od().entry(address::DEVICE_TYPE).unwrap().access;
    assert!(matches!(access, AccessType::Ro | AccessType::Const));
}
