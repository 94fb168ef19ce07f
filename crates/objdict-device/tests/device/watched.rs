//! Hooks and flags of a table, for SDOs, RPDOs and the application alike.

use objdict_device::table::{Change, Data, Entry, HOOK, Handle, Hooked, Hooks, READ, RPDO, Rw, Table, WRITE};
use objdict_device::table::{HIGH, UNSIGNED8, UNSIGNED16, UNSIGNED32};
use objdict_device::{Abort, Dictionary, Node, Pdos, Received, Reception, SdoServer, Watched};

use crate::client::request;
use crate::frame;

/// A table as `objdict generate` writes it: RPDO 1 carries the speed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Od;

static ENTRIES: [Entry<Od>; 6] = [
    Entry::new(0x1400, 1, UNSIGNED32, READ | WRITE, 1, 0),
    Entry::new(0x1400, 2, UNSIGNED8, READ | WRITE, 5, 4),
    Entry::new(0x1600, 0, UNSIGNED8, READ | WRITE, 6, 5),
    Entry::new(0x1600, 1, UNSIGNED32, READ | WRITE, 7, 6),
    Entry::new(0x2000, 0, UNSIGNED16, READ | WRITE | RPDO | HIGH | HOOK, 11, 10),
    Entry::new(0x2001, 0, UNSIGNED16, READ | WRITE, 13, 14),
];

impl Table for Od {
    const ENTRIES: &'static [Entry<Self>] = &ENTRIES;
    const ROM: &'static [u8] = &[0x05, 0x02, 0, 0, 255, 1, 0x10, 0, 0, 0x20, 0x10, 0, 0x88, 0x13, 0, 0];
}

impl Hooked for Od {
    type Room = [u8; 8];
    const ROOM: [u8; 8] = [0; 8];
}

type Values = Data<Od, 15>;

mod od {
    use super::{Handle, Od, Rw};

    pub(super) const SPEED: Handle<Od, u16, Rw> = Handle::of(0x2000, 0);
    pub(super) const OTHER: Handle<Od, u16, Rw> = Handle::of(0x2001, 0);
}

#[derive(Default)]
struct Motor {
    steps: Vec<(u16, u16)>,
}

impl Hooks<Values> for Motor {
    fn after_write(&mut self, data: &mut Values, change: Change<'_>) -> Result<(), Abort> {
        if let Some(old) = change.old(od::SPEED) {
            let new = data.get(od::SPEED);
            if new > old + 1000 {
                return Err(Abort::DeviceState);
            }
            self.steps.push((old, new));
        }
        Ok(())
    }
}

type Device = Node<Watched<Values, Motor, 1>, 16, 1, 1, 0, 0>;

#[test]
fn hooks_see_what_sdos_rpdos_and_the_application_write() {
    let watched = Watched::new(Values::new(5), Motor::default());
    let mut device = Device::new(5, watched, Pdos::new([0x1400], []));
    device.boot(0);
    device.receive(&frame(0, &[1, 5]), 0);

    let answer = device.receive(&frame(0x605, &request(0x2B, 0x2000, 0, [100, 0, 0, 0])), 0);
    assert!(matches!(answer, Received::Answer(answer) if answer.data()[0] == 0x60));
    assert_eq!(device.receive(&frame(0x205, &[200, 0]), 0), Received::Pdo(Reception::Written(0x1400)));
    assert_eq!(device.dictionary.set(od::SPEED, 300), Ok(()));
    assert_eq!(device.dictionary.hooks.steps, [(16, 100), (100, 200), (200, 300)]);

    // a value that a hook or a limit rejects remains unchanged
    assert_eq!(device.dictionary.set(od::SPEED, 1301), Err(Abort::DeviceState));
    assert_eq!(device.dictionary.set(od::SPEED, 5001), Err(Abort::TooHigh));
    let rpdo = device.receive(&frame(0x205, &1301_u16.to_le_bytes()), 0);
    assert_eq!(rpdo, Received::Pdo(Reception::Refused(0x1400, Abort::DeviceState)));
    assert_eq!(device.dictionary.data.get(od::SPEED), 300);
    assert_eq!(device.dictionary.hooks.steps.len(), 3);
}

#[test]
fn a_flag_is_raised_by_a_write_and_taken_once() {
    let mut watched = Watched::<Values, Motor, 1>::new(Values::new(5), Motor::default());
    let taken = |watched: &mut Watched<Values, Motor, 1>| {
        [watched.take_changed(od::SPEED.entry()), watched.take_changed(od::OTHER.entry())]
    };
    assert_eq!(taken(&mut watched), [false, false]);
    assert_eq!(watched.write(0x2001, 0, &[1, 0]), Ok(()));
    assert_eq!(watched.write(0x2000, 0, &[0xFF, 0xFF]), Err(Abort::TooHigh));
    assert_eq!(taken(&mut watched), [false, true]);
    assert_eq!(watched.set(od::SPEED, 17), Ok(()));
    assert_eq!(taken(&mut watched), [true, false]);
}

#[test]
fn a_table_is_a_dictionary() {
    let mut data = Values::new(5);
    let attributes = data.attributes(0x2000, 0).unwrap();
    assert_eq!((attributes.size, attributes.data_type), (2, UNSIGNED16));
    assert!(attributes.readable && attributes.writable && attributes.fits_rpdo && !attributes.fits_tpdo);
    assert_eq!(data.number(0x1600, 1), Ok(0x2000_0010));
    let mut server = SdoServer::<16>::new(0, 5);
    let upload = frame(0x605, &request(0x40, 0x2000, 0, [0; 4]));
    let answer = server.receive(&mut data, &upload, 0).unwrap();
    assert_eq!(answer.data(), request(0x4B, 0x2000, 0, [0x10, 0, 0, 0]));
}
