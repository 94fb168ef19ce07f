//! SYNC as the device under test expects it (CiA 301 §7.2.5).

use objdict_device::Frame;

use super::bench::Bench;
use super::{CheckStep, impossible};

/// The CAN-ID of SYNC.
pub(super) fn sync_id(bench: &Bench<'_>) -> CheckStep<u16> {
    let id = match bench.described.find(0x1005, 0) {
        Some(_) => (bench.described.number(0x1005, 0) & 0x7FF) as u16,
        None => 0x80,
    };
    if id < 0x80 { impossible(format!("1005h has the CAN-ID {id:03X}h, that of NMT or LSS")) } else { Ok(id) }
}

/// Whether SYNC has a counter by default.
pub(super) fn counts(bench: &Bench<'_>) -> bool {
    bench.described.number(0x1019, 0) != 0
}

/// Sends SYNC with the length that the node expects.
pub(super) fn send_sync(bench: &mut Bench<'_>, counter: u8) -> CheckStep<Vec<Frame>> {
    let id = sync_id(bench)?;
    Ok(if counts(bench) { bench.send(id, &[counter]) } else { bench.send(id, &[]) })
}

/// A SYNC with a byte more or less than it must have, to an operational node.
pub(super) fn send_wrong_sync(bench: &mut Bench<'_>) -> CheckStep<Vec<Frame>> {
    let id = sync_id(bench)?;
    Ok(if counts(bench) { bench.send(id, &[]) } else { bench.send(id, &[1]) })
}
