//! A node on a bus that is a TCP connection, which keeps what a master stores: its values (1010h) and its node-ID (LSS). The flash is a
//! file of the command line, and the node-ID is in a second one beside it, so the next run finds both.

#[path = "../src/flash.rs"]
mod flash;
#[path = "../src/slcan.rs"]
mod slcan;

use std::fs;
use std::io::{self, ErrorKind, Write};
use std::net::TcpListener;
use std::path::PathBuf;
use std::time::Instant;

use objdict_device::{FlashStorage, LssReceived, LssSlave, LssStoreError, NmtCommand, Received, Region};

use flash::Flash;
use slcan::Bus;

mod od {
    include!(concat!(env!("OUT_DIR"), "/stored.rs"));
}

fn main() -> io::Result<()> {
    let file = std::env::args().nth(1).ok_or_else(|| io::Error::other("name the file of the flash"))?;
    let listener = TcpListener::bind("127.0.0.1:0")?;
    println!("listening on {}", listener.local_addr()?);
    io::stdout().flush()?;
    match run(Bus::new(listener.accept()?.0)?, PathBuf::from(file)) {
        Err(error) if error.kind() != ErrorKind::UnexpectedEof => Err(error),
        _ => Ok(()),
    }
}

fn run(mut bus: Bus, file: PathBuf) -> io::Result<()> {
    let start = Instant::now();
    let now = || start.elapsed().as_micros() as u64;
    let kept = file.with_extension("node-id");
    let node_id = fs::read(&kept).ok().and_then(|bytes| bytes.first().copied()).unwrap_or(od::NODE_ID);

    let beyond = || io::Error::other("not a region of this flash");
    let region = Region::new(Flash::new(0x4000, Some(file)), 0, 0x4000).ok_or_else(beyond)?;
    let storage = FlashStorage::new(region, od::groups::COUNT).ok_or_else(beyond)?;
    let mut device: od::Node<64, 1, _> =
        od::Node::new(node_id, od::Stored::new(node_id, storage), od::pdos());
    let mut lss = LssSlave::new([0x3F9, 0x10, 0x1_0001, 0], Some(node_id)).with_storage();

    bus.send(&device.boot(now()))?;
    loop {
        for frame in bus.receive()? {
            match lss.receive(&frame, now()) {
                LssReceived::Answer(answer) => bus.send(&answer)?,
                LssReceived::Store { node_id, .. } => {
                    let stored = node_id.map(|node_id| fs::write(&kept, [node_id]));
                    let is_stored = stored.is_some_and(|stored| stored.is_ok());
                    let result = if is_stored { Ok(()) } else { Err(LssStoreError::NoAccess) };
                    bus.send(&LssSlave::answer_store(result))?;
                }
                _ => {}
            }
            match device.receive(&frame, now()) {
                Received::Answer(answer) => bus.send(&answer)?,
                Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                    // the node-ID that LSS configured
                    if let Some(node_id) = lss.reset().filter(|&node_id| node_id != device.node_id()) {
                        device.set_node_id(node_id);
                    }
                    bus.send(&device.boot(now()))?;
                }
                _ => {}
            }
        }
        while let Some(frame) = device.poll(now()) {
            bus.send(&frame)?;
        }
    }
}
