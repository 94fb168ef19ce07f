//! Emergency messages.

use crate::{Dictionary, Frame};

/// The emergency message (CiA 301 §7.2.7) with an error code, such as 8130h for a lost heartbeat or 0 for no error, the error register,
/// and bytes of the vendor. `None` while bit 31 of 1014h is set; a device without 1014h has the COB-ID 80h + node-ID.
pub fn emergency<D: Dictionary + ?Sized>(
    dictionary: &mut D,
    node_id: u8,
    code: u16,
    register: u8,
    vendor: [u8; 5],
) -> Option<Frame> {
    let cob_id = dictionary.number(0x1014, 0).map_or(0x80 | u32::from(node_id), |cob_id| cob_id as u32);
    let ([low, high], [a, b, c, d, e]) = (code.to_le_bytes(), vendor);
    (cob_id >> 31 == 0).then(|| Frame::full(cob_id, [low, high, register, a, b, c, d, e]))
}
