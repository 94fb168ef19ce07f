//! A server without the feature `block-transfer`.

#![cfg(not(feature = "block-transfer"))]

use objdict_device::table::{Data, Entry, READ, Table, UNSIGNED16, WRITE};
use objdict_device::{Abort, Frame, SdoServer};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Od;

impl Table for Od {
    const ENTRIES: &'static [Entry<Self>] = &[Entry::new(0x2000, 0, UNSIGNED16, READ | WRITE, 1, 0)];
    const ROM: &'static [u8] = &[7, 0];
}

/// The response to a request.
fn answer(server: &mut SdoServer<8>, request: [u8; 8]) -> Option<[u8; 8]> {
    let mut values = Data::<Od, 3>::new(5);
    let frame = server.receive(&mut values, &Frame::new(0x605, &request)?, 0)?;
    frame.data().try_into().ok()
}

#[test]
fn block_transfers_are_unknown_and_others_go_on() {
    let mut server = SdoServer::new(0, 5);
    let [a, b, c, d] = Abort::UnknownCommand.code().to_le_bytes();
    // a block upload, a block download, and a different entry, which is not looked up
    for request in
        [[0xA4, 0, 0x20, 0, 127, 0, 0, 0], [0xC6, 0, 0x20, 0, 2, 0, 0, 0], [0xC6, 0, 0x30, 0, 2, 0, 0, 0]]
    {
        assert_eq!(answer(&mut server, request), Some([0x80, request[1], request[2], 0, a, b, c, d]));
        assert!(!server.is_busy());
    }
    assert_eq!(answer(&mut server, [0x40, 0, 0x20, 0, 0, 0, 0, 0]), Some([0x4B, 0, 0x20, 0, 7, 0, 0, 0]));
}
