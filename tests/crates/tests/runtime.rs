//! Tables that use `objdict-device`: its PDOs are those of the generated structs.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use objdict_device::table::{Data, Table};
use objdict_device::{Dictionary, Frame, Pdo, Pdos, Reception};

include!(concat!(env!("OUT_DIR"), "/runtime.rs"));

/// Bytes that are different, and small enough for most limits.
const BYTES: [u8; 8] = [0x11, 0, 0x13, 0, 0x15, 0, 0x17, 0];

/// A valid COB-ID and an event-driven transmission type, as far as the device lets them be written.
fn enable<V: Dictionary, const R: usize, const T: usize>(pdos: &mut Pdos<R, T>, data: &mut V, index: u16) {
    pdos.load(data);
    let mut guarded = pdos.guard(data);
    guarded.write(index, 2, &[255]).ok();
    guarded.write(index, 1, &0x333_u32.to_le_bytes()).ok();
    pdos.start();
}

/// Whether the TPDO was sent. It has the values of its struct.
fn transmits<D: Table, P: Pdo<Data = Data<D, RAM>>, const RAM: usize>(mut data: Data<D, RAM>) -> bool {
    P::from_bytes(BYTES).store(&mut data);
    let mut pdos = Pdos::new([], [P::INDEX]);
    enable(&mut pdos, &mut data, P::INDEX);
    let Some(frame) = pdos.poll(&mut data, 0) else { return false };
    assert_eq!(frame.data(), &P::load(&data).to_bytes()[..P::LENGTH]);
    true
}

/// Whether the RPDO was written. Its values are those that its struct writes.
fn receives<D: Table, P: Pdo<Data = Data<D, RAM>>, const RAM: usize>(mut data: Data<D, RAM>) -> bool {
    let mut pdos = Pdos::new([P::INDEX], []);
    enable(&mut pdos, &mut data, P::INDEX);
    let mut expected = data.clone();
    P::from_bytes(BYTES).store(&mut expected);
    let cob_id = data.number(P::INDEX, 1).unwrap();
    let frame = Frame::new((cob_id & 0x7FF) as u16, &BYTES[..P::LENGTH]).unwrap();
    let reception = pdos.receive(&mut data, &frame, 0);
    if reception == Reception::Written(P::INDEX) {
        assert_eq!(data, expected);
    }
    reception == Reception::Written(P::INDEX)
}

#[test]
fn pdos_are_those_of_the_structs() {
    let exchanged: Vec<(&str, bool)> = PDOS.iter().map(|(name, exchange)| (*name, exchange())).collect();
    let (done, others): (Vec<_>, Vec<_>) = exchanged.into_iter().partition(|(_, is_done)| *is_done);
    assert!(done.len() > 20 && others.len() < 5, "{} exchanged, not {others:?}", done.len());
}

/// With `--cell critical-section` the values are a `static`, with the defaults of the node-ID.
#[test]
fn the_values_of_a_table_are_shared() {
    let set = |value: u16| io_401::SHARED.with(|data| data.write(0x1017, 0, &value.to_le_bytes()).unwrap());
    std::thread::spawn(move || set(250)).join().unwrap();
    let number = |index, sub| io_401::SHARED.with(|data| data.number(index, sub)).unwrap();
    assert_eq!(number(0x1017, 0), Ok(250));
    assert_eq!(number(0x1014, 0), Ok(0x85), "node-ID 5");
}
