//! PDOs with changing parameters and mapping.

use std::collections::BTreeSet;

use objdict_device::{Abort, Dictionary, Frame, Pdos, Reception};
use proptest::prelude::*;

use crate::dictionary::{BOOLEAN, INTEGER16, Map, UNSIGNED8, UNSIGNED16, UNSIGNED32};
use crate::frame;

const NOT_VALID: u32 = 1 << 31;
const MILLISECOND: u64 = 1000;

/// A device with RPDO 2 and TPDO 1, both not valid and without mapped entries.
struct Device {
    map: Map,
    pdos: Pdos<1, 1>,
}

impl Device {
    fn new() -> Self {
        let mut map = Map::default();
        for (index, cob_id) in [(0x1401, 0x305), (0x1800, 0x185)] {
            map = map.number(index, 1, UNSIGNED32, NOT_VALID | cob_id).number(index, 2, UNSIGNED8, 254);
            map = [3, 5]
                .into_iter()
                .fold(map, |map, sub| map.number(index, sub, UNSIGNED16, 0))
                .number(index, 6, UNSIGNED8, 0);
            map = map.number(index + 0x200, 0, UNSIGNED8, 0);
            map = (1..=10).fold(map, |map, sub| map.number(index + 0x200, sub, UNSIGNED32, 0));
        }
        map = map
            .number(0x1019, 0, UNSIGNED8, 0)
            .number(0x2000, 1, UNSIGNED16, 0x1234)
            .number(0x2000, 2, BOOLEAN, 1)
            .number(0x2000, 3, UNSIGNED32, 0x89AB_CDEF)
            .number(0x2000, 4, UNSIGNED8, 0x5A)
            .domain(0x2001, 8, b"abc")
            .number(0x2002, 0, UNSIGNED8, 1)
            .with(0x2002, 0, |attributes| attributes.fits_tpdo = false)
            .number(0x2003, 0, UNSIGNED8, 1)
            .with(0x2003, 0, |attributes| attributes.fits_rpdo = false);
        let mut device = Self { map, pdos: Pdos::new([0x1401], [0x1800]) };
        device.pdos.load(&mut device.map);
        device.pdos.start();
        device
    }

    fn write(&mut self, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {
        self.pdos.guard(&mut self.map).write(index, sub, bytes)
    }

    fn cob_id(&mut self, index: u16, cob_id: u32) -> Result<(), Abort> {
        self.write(index, 1, &cob_id.to_le_bytes())
    }

    /// Maps entries like a master, up to the first abort.
    fn map(&mut self, index: u16, mapped: &[u32]) -> Result<(), Abort> {
        self.write(index, 0, &[0])?;
        for (value, sub) in mapped.iter().zip(1..) {
            self.write(index, sub, &value.to_le_bytes())?;
        }
        self.write(index, 0, &[mapped.len() as u8])
    }

    fn receive(&mut self, id: u16, data: &[u8]) -> Reception {
        self.pdos.receive(&mut self.map, &frame(id, data), 0)
    }

    /// The TPDOs that are sent at a time.
    fn sent(&mut self, now: u64) -> Vec<Frame> {
        std::iter::from_fn(|| self.pdos.poll(&mut self.map, now)).collect()
    }
}

/// A device whose TPDO has the number of 16 bits.
fn with_tpdo(transmission_type: u8) -> Device {
    let mut device = Device::new();
    device.map(0x1A00, &[0x2000_0110]).unwrap();
    device.write(0x1800, 2, &[transmission_type]).unwrap();
    device
}

#[test]
fn a_tpdo_is_mapped_and_sent() {
    let mut device = Device::new();
    assert_eq!(device.map(0x1A00, &[0x2000_0201, 0x2000_0110, 0x2001_0018]), Ok(()));
    assert_eq!(device.sent(0), []);
    assert_eq!(device.cob_id(0x1800, 0x4000_0285), Ok(()));
    // 1, 1234h and `abc`, bit by bit
    assert_eq!(device.sent(0), [frame(0x285, &[0x69, 0x24, 0xC2, 0xC4, 0xC6, 0])]);
    assert_eq!(device.sent(1), []);
    device.pdos.stop();
    device.pdos.request(0x1800);
    assert_eq!(device.sent(2), []);
}

#[test]
fn an_rpdo_is_mapped_and_received() {
    let mut device = Device::new();
    // a dummy of 8 bits in between
    assert_eq!(device.map(0x1601, &[0x2000_0110, 0x0005_0008, 0x2000_0201]), Ok(()));
    assert_eq!(device.receive(0x305, &[1, 2, 3, 0]), Reception::Ignored);
    assert_eq!(device.cob_id(0x1401, 0x305), Ok(()));
    assert_eq!(device.receive(0x305, &[1, 2, 3]), Reception::TooShort(0x1401));
    assert_eq!(device.receive(0x305, &[1, 2, 3, 0xFE, 9]), Reception::TooLong(0x1401));
    assert_eq!((device.map.value(0x2000, 1), device.map.value(0x2000, 2)), (&[1, 2][..], &[0][..]));
    device.map = device.map.with(0x2000, 1, |attributes| attributes.writable = false);
    assert_eq!(device.receive(0x305, &[5, 5, 5, 1]), Reception::Refused(0x1401, Abort::ReadOnly));
    assert_eq!((device.map.value(0x2000, 1), device.map.value(0x2000, 2)), (&[1, 2][..], &[1][..]));
}

/// A mapping without entries is disabled: no frame is too long for it, and its absence is not a timeout.
#[test]
fn an_rpdo_without_entries_receives_nothing() {
    let mut device = Device::new();
    device.map(0x1601, &[]).unwrap();
    device.cob_id(0x1401, 0x305).unwrap();
    assert_eq!(device.receive(0x305, &[1, 2, 3]), Reception::Ignored);
    assert_eq!((device.pdos.next(0), device.pdos.overdue(u64::MAX)), (None, None));
}

/// No master can map a part of a number, but a description may.
#[test]
fn a_part_of_a_number_keeps_its_sign() {
    let mut device = Device::new();
    device.map = device.map.number(0x2004, 0, INTEGER16, 0);
    assert_eq!(device.map(0x1601, &[0x2004_000C]), Err(Abort::NotMappable));
    device.map.set(0x1601, 1, &0x2004_000C_u32.to_le_bytes());
    device.map.set(0x1601, 2, &0x2000_010C_u32.to_le_bytes());
    device.map.set(0x1601, 0, &[2]);
    device.cob_id(0x1401, 0x305).unwrap();
    assert_eq!(device.receive(0x305, &[0xFE, 0xEF, 0xFF]), Reception::Written(0x1401));
    assert_eq!(device.map.value(0x2004, 0), (-2_i16).to_le_bytes());
    assert_eq!(device.map.value(0x2000, 1), 0x0FFE_u16.to_le_bytes());
}

#[test]
fn a_mapping_must_fit() {
    let mut device = Device::new();
    let abort = Err(Abort::NotMappable);
    for (mapping, mapped) in [
        (0x1A00, 0x3000_0008_u32),
        (0x1A00, 0x2000_0908),
        (0x1A00, 0x2000_0108),
        (0x1A00, 0x2000_0120),
        (0x1A00, 0x2000_0100),
        (0x1A00, 0x2000_0202),
        (0x1A00, 0x2001_0048),
        (0x1A00, 0x2001_0004),
        (0x1A00, 0x2002_0008),
        (0x1A00, 0x0005_0008),
        (0x1601, 0x2003_0008),
        (0x1601, 0x0005_0010),
        (0x1601, 0x0008_0020),
    ] {
        assert_eq!(device.map(mapping, &[mapped]), abort, "{mapped:08X}");
    }
    let long = [0x2000_0320, 0x2000_0320, 0x2000_0201];
    assert_eq!(device.map(0x1A00, &long), Err(Abort::PdoTooLong));
    assert_eq!(device.map(0x1A00, &long[..2]), Ok(()));
    assert_eq!(device.map(0x1A00, &[0x2000_0201; 10]), Ok(()));
    assert_eq!(device.write(0x1A00, 0, &[11]), Err(Abort::PdoTooLong), "ten entries");
    assert_eq!(device.write(0x1A00, 0, &[254]), Err(Abort::PdoTooLong), "no MPDO");
    assert_eq!(device.write(0x1A00, 0, &[0]), Ok(()));
    assert_eq!(device.write(0x1A00, 3, &[0; 4]), Ok(()), "an empty entry");
    assert_eq!(device.write(0x1A00, 0, &[11]), Err(Abort::PdoTooLong), "ten entries, one of them empty");
    assert_eq!(device.write(0x1A00, 0, &[3]), abort);
    assert_eq!(device.write(0x1A00, 0, &[2]), Ok(()));
    // first the number, then the entries
    assert_eq!(device.write(0x1A00, 1, &[0; 4]), Err(Abort::UnsupportedAccess));
    assert_eq!(device.cob_id(0x1800, 0x185), Ok(()));
    assert_eq!(device.write(0x1A00, 0, &[0]), Err(Abort::UnsupportedAccess));
}

#[test]
fn a_valid_pdo_keeps_its_parameters() {
    let mut device = Device::new();
    for cob_id in [0, 0x7F, 0x101, 0x585, 0x605, 0x6E0, 0x705, 0x2000_0185, 0x885] {
        assert_eq!(device.cob_id(0x1800, cob_id), Err(Abort::InvalidValue), "{cob_id:X}");
    }
    for (transmission_type, answer) in
        [(240, Ok(())), (241, Err(Abort::InvalidValue)), (253, Err(Abort::InvalidValue)), (255, Ok(()))]
    {
        assert_eq!(device.write(0x1800, 2, &[transmission_type]), answer);
    }
    assert_eq!(device.write(0x1800, 3, &[1, 0]), Ok(()));
    assert_eq!(device.write(0x1800, 6, &[241]), Err(Abort::InvalidValue));
    assert_eq!(device.cob_id(0x1800, 0x4000_0185), Ok(()));
    assert_eq!(device.cob_id(0x1800, 0x4000_0186), Err(Abort::InvalidValue));
    assert_eq!(device.cob_id(0x1800, 0x185), Err(Abort::InvalidValue), "remote frames are not answered");
    assert_eq!(device.write(0x1800, 3, &[2, 0]), Err(Abort::InvalidValue));
    assert_eq!(device.write(0x1800, 3, &[1, 0]), Ok(()), "as it is");
    assert_eq!(device.write(0x1800, 6, &[1]), Err(Abort::InvalidValue));
    assert_eq!(device.write(0x1800, 5, &[100, 0]), Ok(()));
    assert_eq!(device.cob_id(0x1800, NOT_VALID | 0x286), Ok(()));
    assert_eq!(device.cob_id(0x1800, 0x286), Ok(()));
    // the dictionary decides on access, on length and on other objects
    assert_eq!(device.write(0x1800, 1, &[1]), Err(Abort::TooShort));
    assert_eq!(device.write(0x3000, 1, &[1]), Err(Abort::NoObject));
}

#[test]
fn timers_of_an_event_driven_tpdo() {
    let mut device = with_tpdo(254);
    device.write(0x1800, 3, &50_u16.to_le_bytes()).unwrap();
    device.write(0x1800, 5, &20_u16.to_le_bytes()).unwrap();
    device.cob_id(0x1800, 0x185).unwrap();
    let sent = |now: u64, device: &mut Device| device.sent(now * MILLISECOND).len();
    assert_eq!(sent(0, &mut device), 1, "once at the start");
    device.pdos.request(0x1800);
    assert_eq!(sent(4, &mut device), 0, "inhibited for 5 ms");
    assert_eq!(sent(5, &mut device), 1);
    assert_eq!(sent(24, &mut device), 0);
    assert_eq!(sent(25, &mut device), 1, "after 20 ms");
    // a change is a request
    device.pdos.request_changed(&mut device.map);
    assert_eq!(sent(30, &mut device), 0);
    device.map.set(0x2000, 1, &[1, 1]);
    device.pdos.request_changed(&mut device.map);
    assert_eq!(device.sent(30 * MILLISECOND), [frame(0x185, &[1, 1])]);
}

#[test]
fn synchronous_tpdos_count_syncs() {
    let syncs = |device: &mut Device, count: u8| -> Vec<u8> {
        (1..=count)
            .filter(|&counter| {
                assert_eq!(device.receive(0x80, &[counter]), Reception::Sync);
                !device.sent(0).is_empty()
            })
            .collect()
    };
    let mut device = with_tpdo(3);
    device.cob_id(0x1800, 0x185).unwrap();
    assert_eq!(syncs(&mut device, 9), [3, 6, 9]);
    // the SYNC with counter 5 is the first one
    device.cob_id(0x1800, NOT_VALID | 0x185).unwrap();
    device.write(0x1019, 0, &[10]).unwrap();
    device.write(0x1800, 6, &[5]).unwrap();
    device.cob_id(0x1800, 0x185).unwrap();
    assert_eq!(syncs(&mut device, 10), [7, 10]);

    let mut device = with_tpdo(0);
    device.cob_id(0x1800, 0x185).unwrap();
    assert_eq!(syncs(&mut device, 2), [0_u8; 0]);
    device.pdos.request(0x1800);
    assert_eq!(device.sent(0), []);
    assert_eq!(syncs(&mut device, 2), [1]);
}

#[test]
fn a_synchronous_rpdo_waits_for_sync() {
    let mut device = Device::new();
    device.map(0x1601, &[0x2000_0110]).unwrap();
    device.write(0x1401, 2, &[1]).unwrap();
    device.write(0x1401, 5, &10_u16.to_le_bytes()).unwrap();
    device.cob_id(0x1401, 0x305).unwrap();
    assert_eq!(device.receive(0x305, &[7, 7]), Reception::Held(0x1401));
    assert_eq!(device.map.value(0x2000, 1), [0x34, 0x12]);
    assert_eq!(device.receive(0x80, &[]), Reception::Sync);
    assert_eq!(device.map.value(0x2000, 1), [7, 7]);
    assert_eq!(device.pdos.overdue(9 * MILLISECOND), None);
    assert_eq!(device.pdos.overdue(10 * MILLISECOND), Some(0x1401));
    assert_eq!(device.pdos.overdue(20 * MILLISECOND), None);
}

proptest! {
    /// A device with the same mapping unpacks the values that another one packs.
    #[test]
    fn a_tpdo_is_the_rpdo_of_another_device(
        mapped in prop::collection::vec(prop::sample::select(&MAPPABLE[..]), 1..8),
        values in any::<[u32; 5]>(),
    ) {
        let (mut sender, mut receiver) = (Device::new(), Device::new());
        let bits: u32 = mapped.iter().map(|mapped| mapped & 0xFF).sum();
        let answer = if bits > 64 { Err(Abort::PdoTooLong) } else { Ok(()) };
        prop_assert_eq!(sender.map(0x1A00, &mapped), answer);
        prop_assert_eq!(receiver.map(0x1601, &mapped), answer);
        if answer.is_ok() {
            for (&mapped, value) in MAPPABLE.iter().zip(values) {
                let (index, sub) = ((mapped >> 16) as u16, (mapped >> 8) as u8);
                let value = if mapped & 0xFF == 1 { value & 1 } else { value };
                let length = sender.map.attributes(index, sub).unwrap().size.min(4);
                sender.map.set(index, sub, &value.to_le_bytes()[..length]);
            }
            sender.cob_id(0x1800, 0x305).unwrap();
            receiver.cob_id(0x1401, 0x305).unwrap();
            let frames = sender.sent(0);
            prop_assert_eq!(frames[0].data().len(), bits.div_ceil(8) as usize);
            prop_assert_eq!(receiver.receive(0x305, frames[0].data()), Reception::Written(0x1401));
            for mapped in mapped.into_iter().collect::<BTreeSet<_>>() {
                let (index, sub) = ((mapped >> 16) as u16, (mapped >> 8) as u8);
                prop_assert_eq!(sender.map.value(index, sub), receiver.map.value(index, sub));
            }
        }
    }

    /// No write to the parameters makes the PDOs panic, and a sent PDO never has more than eight bytes.
    #[test]
    fn any_parameters_are_survived(writes in prop::collection::vec((0..4_usize, 0..12_u8, any::<u32>(), 0..6_usize), 0..80)) {
        let mut device = Device::new();
        for (object, sub, value, mapped) in writes {
            let index = [0x1401, 0x1601, 0x1800, 0x1A00][object];
            let value = MAPPABLE.get(mapped).copied().filter(|_| index & 0x200 != 0).unwrap_or(value);
            let size = device.map.attributes(index, sub).map_or(4, |attributes| attributes.size);
            let _ = device.write(index, sub, &value.to_le_bytes()[..size]);
            device.receive(0x80, &[value as u8]);
            device.receive((value & 0x7FF) as u16, &[1; 8]);
            prop_assert!(device.sent(u64::from(value)).len() <= 1);
        }
    }
}

const MAPPABLE: [u32; 5] = [0x2000_0110, 0x2000_0201, 0x2000_0320, 0x2000_0408, 0x2001_0020];
