//! The writes that a node rejects.

use objdict_device::{Abort, Dictionary, NmtState, Node, Pdos};

use crate::dictionary::{Map, UNSIGNED8, UNSIGNED16, UNSIGNED32};
use crate::frame;

type Device = Node<Map, 16, 2, 1, 2, 2>;

fn device() -> Device {
    let words = [
        (0x1005, 0, 0x80),
        (0x1006, 0, 0),
        (0x1010, 1, 1),
        (0x1011, 1, 1),
        (0x1007, 0, 0),
        (0x1012, 0, 0x100),
        (0x1028, 1, 0x8000_0000),
        (0x1280, 1, 0x8000_0000),
        (0x1280, 2, 0x8000_0000),
        (0x1F80, 0, 4),
        (0x1014, 0, 0x85),
        (0x1016, 1, 0),
        (0x1016, 2, 0),
        (0x1016, 3, 0),
        (0x1200, 1, 0x605),
        (0x1200, 2, 0x585),
        (0x1201, 1, 0x8000_0000),
        (0x1201, 2, 0x8000_0000),
        (0x1202, 1, 0x8000_0000),
        (0x1400, 1, 0x8000_0205),
    ];
    let map = words
        .into_iter()
        .fold(Map::default(), |map, (index, sub, value)| map.number(index, sub, UNSIGNED32, value));
    let map =
        map.number(0x100C, 0, UNSIGNED16, 0).number(0x100D, 0, UNSIGNED8, 3).number(0x1029, 1, UNSIGNED8, 0);
    let map =
        map.number(0x1003, 0, UNSIGNED8, 0).number(0x1003, 1, UNSIGNED32, 0).number(0x1019, 0, UNSIGNED8, 0);
    let mut device = Device::new(5, map.number(0x1017, 0, UNSIGNED16, 0), Pdos::new([0x1400], [0, 0]));
    device.boot(0);
    device
}

fn write(device: &mut Device, index: u16, sub: u8, value: u32) -> Result<(), Abort> {
    let size = device.dictionary.attributes(index, sub)?.size;
    device.guard().write(index, sub, &value.to_le_bytes()[..size])
}

const INVALID: Result<(), Abort> = Err(Abort::InvalidValue);

/// Each row is written to the same device, in this order.
#[test]
fn a_write_that_no_service_follows_is_refused() {
    let mut device = device();
    for (index, sub, value, expected) in [
        (0x1003, 0, 1, INVALID),
        (0x1003, 0, 0, Ok(())),
        // SYNC: 11 bits, no CAN-ID of a different service, and no change while it is sent
        (0x1005, 0, 0x2000_0080, INVALID),
        (0x1005, 0, 0x0601, INVALID),
        (0x1005, 0, 0x4000_0080, Ok(())),
        (0x1005, 0, 0x4000_0081, INVALID),
        (0x1005, 0, 0x0081, Ok(())),
        (0x1005, 0, 0x0080, Ok(())),
        (0x1006, 0, 1000, Ok(())),
        (0x1019, 0, 10, Err(Abort::DeviceState)),
        (0x1006, 0, 0, Ok(())),
        (0x1019, 0, 1, INVALID),
        (0x1019, 0, 241, INVALID),
        (0x1019, 0, 240, Ok(())),
        // unsupported services cannot be enabled; those that the description enables remain
        (0x1007, 0, 1000, INVALID),
        (0x1007, 0, 0, Ok(())),
        (0x100C, 0, 100, INVALID),
        (0x100D, 0, 3, Ok(())),
        (0x100D, 0, 0, Ok(())),
        (0x100D, 0, 3, INVALID),
        (0x1028, 1, 0x83, INVALID),
        (0x1028, 1, 0x8000_0083, Ok(())),
        (0x1280, 1, 0x603, INVALID),
        (0x1280, 1, 0x8000_0603, Ok(())),
        (0x1F80, 0, 1, INVALID),
        (0x1F80, 0, 0x10, INVALID),
        (0x1F80, 0, 0, Ok(())),
        (0x1012, 0, 0x4000_0100, INVALID),
        (0x1012, 0, 0x8000_0100, INVALID),
        (0x1012, 0, 0x180, Ok(())),
        (0x1029, 1, 2, Ok(())),
        (0x1029, 1, 5, INVALID),
        (0x1014, 0, 0x86, INVALID),
        (0x1014, 0, 0xA000_0085, INVALID),
        (0x1014, 0, 0x8000_0085, Ok(())),
        (0x1014, 0, 0x0701, INVALID),
        (0x1014, 0, 0x0086, Ok(())),
        (0x1016, 1, 0x0007_0064, Ok(())),
        (0x1016, 2, 0x0007_0032, Err(Abort::Incompatible)),
        (0x1016, 1, 0x0007_0032, Ok(())),
        (0x1016, 2, 0x0007_0000, Ok(())),
        (0x1016, 3, 0x0008_0064, Err(Abort::InternalIncompatible)),
        (0x1200, 1, 0x606, INVALID),
        (0x1200, 1, 0x605, Ok(())),
        (0x1201, 1, 0x0601, INVALID),
        (0x1201, 1, 0x2000_0640, INVALID),
        (0x1201, 1, 0x0680, Ok(())),
        // the channel is not valid until both COB-IDs are
        (0x1201, 1, 0x0681, Ok(())),
        (0x1201, 2, 0x0682, Ok(())),
        (0x1201, 1, 0x0680, INVALID),
        (0x1202, 1, 0x0690, Err(Abort::InternalIncompatible)),
        // each SYNC would be an RPDO
        (0x1400, 1, 0x0080, INVALID),
        (0x1400, 1, 0x0205, Ok(())),
    ] {
        let written = write(&mut device, index, sub, value);
        assert_eq!(written, expected, "{index:04X}h:{sub:02X} {value:08X}h");
    }
}

/// Without storage nothing is stored, and 1010h reports this.
#[test]
fn signatures_need_storage() {
    let mut device = device();
    for (index, value) in [(0x1010, *b"save"), (0x1010, *b"load"), (0x1011, *b"load"), (0x1011, [1, 0, 0, 0])]
    {
        let value = u32::from_le_bytes(value);
        assert_eq!(write(&mut device, index, 1, value), Err(Abort::CannotStore));
        assert_eq!(device.guard().number(index, 1), Ok(0));
    }
}

/// Each SYNC would be the data of the PDO.
#[test]
fn sync_and_a_pdo_do_not_share_a_can_id() {
    let mut device = device();
    assert_eq!(write(&mut device, 0x1400, 1, 0x8000_0080), Ok(()));
    assert_eq!(write(&mut device, 0x1400, 1, 0x0080), INVALID);
    assert_eq!(write(&mut device, 0x1400, 1, 0x0205), Ok(()));
    assert_eq!(write(&mut device, 0x1005, 0, 0x0205), INVALID);
    assert_eq!(write(&mut device, 0x1400, 1, 0x8000_0205), Ok(()));
    assert_eq!(write(&mut device, 0x1005, 0, 0x0205), Ok(()));
    // the initial state of the dictionary remains
    let mut map = Map::default().number(0x1005, 0, UNSIGNED32, 0x205).number(0x1400, 1, UNSIGNED32, 0x205);
    let mut pdos = Pdos::<1, 0>::new([0x1400], []);
    assert_eq!(pdos.guard(&mut map).write(0x1005, 0, &0x205_u32.to_le_bytes()), Ok(()));
}

#[test]
fn another_value_clears_the_date_of_the_configuration() {
    let mut device = device();
    let map = std::mem::take(&mut device.dictionary);
    device.dictionary = map.number(0x1020, 1, UNSIGNED32, 15_000).number(0x1020, 2, UNSIGNED32, 20);
    let dates =
        |device: &mut Device| [1, 2].map(|sub| Dictionary::number(&mut device.dictionary, 0x1020, sub));
    write(&mut device, 0x1017, 0, 0).unwrap();
    write(&mut device, 0x1020, 2, 30).unwrap();
    assert_eq!(write(&mut device, 0x1019, 0, 1), INVALID);
    assert_eq!(dates(&mut device), [Ok(15_000), Ok(30)], "no other value has changed");
    write(&mut device, 0x1017, 0, 10).unwrap();
    assert_eq!(dates(&mut device), [Ok(0), Ok(0)]);
}

/// A program that only serves PDOs cannot send SYNC.
#[test]
fn sync_needs_a_producer() {
    let mut device = device();
    let mut pdos = Pdos::<0, 0>::new([], []);
    let mut guarded = pdos.guard(&mut device.dictionary);
    assert_eq!(guarded.write(0x1005, 0, &0x4000_0080_u32.to_le_bytes()), INVALID);
}

/// The services apply accepted values.
#[test]
fn what_is_accepted_is_done() {
    let mut device = device();
    write(&mut device, 0x1017, 0, 10).unwrap();
    assert_eq!(device.next(0), Some(0));
    assert_eq!(device.poll(0), Some(frame(0x705, &[0x7F])));
    assert_eq!(device.next(0), Some(10_000));
    write(&mut device, 0x1019, 0, 2).unwrap();
    write(&mut device, 0x1006, 0, 4000).unwrap();
    write(&mut device, 0x1005, 0, 0x4000_0080).unwrap();
    assert_eq!(device.poll(1000), Some(frame(0x80, &[1])));
    assert_eq!(device.next(1000), Some(5000));
    assert_eq!(device.poll(6000), Some(frame(0x80, &[2])), "late");
    assert_eq!(device.next(6000), Some(9000), "in its phase");
    assert_eq!(device.poll(9000), Some(frame(0x80, &[1])));
    device.receive(&frame(0, &[2, 5]), 9500);
    assert_eq!(device.state(), NmtState::Stopped);
    assert_eq!(device.poll(9500), Some(frame(0x705, &[4])));
    assert_eq!((device.poll(9600), device.next(9600)), (None, Some(10_000)), "no SYNC of a stopped node");
    write(&mut device, 0x1017, 0, 0).unwrap();
    assert_eq!(device.next(9600), None);
}
