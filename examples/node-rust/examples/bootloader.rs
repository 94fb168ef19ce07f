//! A bootloader on a bus that is a TCP connection, as for the node: it takes a program of any length into its flash, and keeps its heartbeat
//! time. The flash is RAM here.

#[path = "../src/flash.rs"]
mod flash;
#[path = "../src/slcan.rs"]
mod slcan;

use std::io::{self, ErrorKind, Write};
use std::net::TcpListener;
use std::time::Instant;

use objdict_device::{FlashStorage, NmtCommand, Received, Region, WithProgram, error_code};

use flash::Flash;
use slcan::Bus;

mod od {
    include!(concat!(env!("OUT_DIR"), "/bootloader.rs"));
}

fn main() -> io::Result<()> {
    let listener = TcpListener::bind("127.0.0.1:0")?;
    println!("listening on {}", listener.local_addr()?);
    io::stdout().flush()?;
    match run(Bus::new(listener.accept()?.0)?) {
        Err(error) if error.kind() != ErrorKind::UnexpectedEof => Err(error),
        _ => Ok(()),
    }
}

fn run(mut bus: Bus) -> io::Result<()> {
    let start = Instant::now();
    let now = || start.elapsed().as_micros() as u64;
    let (pages, program) = (Flash::new(0x4_0000, None), Flash::new(0x4_0000, None));
    let beyond = || io::Error::other("not a region of this flash");

    // the values that 1010h stores, in the last pages
    let region = Region::new(pages, 0x3_E000, 0x4_0000).ok_or_else(beyond)?;
    let storage = FlashStorage::new(region, od::groups::COUNT).ok_or_else(beyond)?;
    let values = od::Stored::new(od::NODE_ID, storage);
    // there is no program yet
    let region = Region::new(program, 0x1_0000, 0x3_E000).ok_or_else(beyond)?;
    let dictionary = WithProgram::new(values, region, 0);
    let mut device: od::Node<64, 1, _> = od::Node::new(od::NODE_ID, dictionary, od::pdos());

    bus.send(&device.boot(now()))?;
    if let Some(loss) = device.dictionary.data.lost() {
        device.report(error_code::DATA_SET, [loss.group as u8, 0, 0, 0, 0]);
    }
    loop {
        for frame in bus.receive()? {
            match device.receive(&frame, now()) {
                Received::Answer(answer) => bus.send(&answer)?,
                Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                    bus.send(&device.boot(now()))?;
                }
                _ => {}
            }
        }
        // here the bootloader stops or starts the program
        if let Some(request) = device.dictionary.take_request() {
            println!("{request:?} {} bytes", device.dictionary.length());
            io::stdout().flush()?;
        }
        while let Some(frame) = device.poll(now()) {
            bus.send(&frame)?;
        }
    }
}
