//! A node on a bus that is a TCP connection with frames in SLCAN, the text of many CAN adapters: `t6058401810` … is a frame of eight
//! bytes with the CAN-ID 605h. With a CAN driver in place of the connection this is the main loop of a firmware.

mod slcan;

use std::io::{self, ErrorKind, Write};
use std::net::TcpListener;
use std::time::Instant;

use objdict_device::{NmtCommand, Received};

use slcan::Bus;

mod od {
    include!(concat!(env!("OUT_DIR"), "/od.rs"));
}

fn main() -> io::Result<()> {
    let address = std::env::args().nth(1).unwrap_or_else(|| "127.0.0.1:0".to_owned());
    let listener = TcpListener::bind(address)?;
    println!("listening on {}", listener.local_addr()?);
    io::stdout().flush()?;
    for stream in listener.incoming() {
        match run(Bus::new(stream?)?) {
            Err(error) if error.kind() != ErrorKind::UnexpectedEof => return Err(error),
            _ => {}
        }
    }
    Ok(())
}

fn run(mut bus: Bus) -> io::Result<()> {
    let start = Instant::now();
    let now = || start.elapsed().as_micros() as u64;
    // one SDO server for values of at most 1000 bytes
    let mut device = od::node::<1000, 1>(od::NODE_ID);
    bus.send(&device.boot(now()))?;
    loop {
        for frame in bus.receive()? {
            match device.receive(&frame, now()) {
                Received::Answer(answer) => bus.send(&answer)?,
                Received::Nmt(NmtCommand::ResetNode | NmtCommand::ResetCommunication) => {
                    bus.send(&device.boot(now()))?;
                }
                Received::Ignored | Received::Nmt(_) | Received::Pdo(_) | Received::Heartbeat(_) => {}
            }
        }
        // here the application works with the values, `device.dictionary`
        device.pdos.request_changed(&mut device.dictionary);
        while let Some(frame) = device.poll(now()) {
            bus.send(&frame)?;
        }
    }
}
