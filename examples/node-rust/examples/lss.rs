//! Four devices without node-ID on a bus that is a TCP connection, as for the node: they have nothing but LSS until the master gives them
//! node-IDs. Identities are numbers of the command line, four for each device.

#[path = "../src/slcan.rs"]
mod slcan;

use std::io::{self, ErrorKind, Write};
use std::net::TcpListener;
use std::time::Instant;

use objdict_device::{Frame, LssReceived, LssSlave, LssStoreError};

use slcan::Bus;

fn main() -> io::Result<()> {
    let numbers: Vec<u32> = std::env::args().skip(1).filter_map(|number| number.parse().ok()).collect();
    let (identities, _) = numbers.as_chunks();
    let slave = |&identity: &[u32; 4]| {
        LssSlave::new(identity, None).with_bit_rates(&[1000, 500, 250, 125]).with_storage()
    };
    let listener = TcpListener::bind("127.0.0.1:0")?;
    println!("listening on {}", listener.local_addr()?);
    io::stdout().flush()?;
    match run(Bus::new(listener.accept()?.0)?, identities.iter().map(slave).collect()) {
        Err(error) if error.kind() != ErrorKind::UnexpectedEof => Err(error),
        _ => Ok(()),
    }
}

fn run(mut bus: Bus, mut slaves: Vec<LssSlave>) -> io::Result<()> {
    let start = Instant::now();
    let now = || start.elapsed().as_micros() as u64;
    loop {
        for frame in bus.receive()? {
            for slave in &mut slaves {
                match slave.receive(&frame, now()) {
                    LssReceived::Ignored => {}
                    LssReceived::Answer(answer) => bus.send(&answer)?,
                    // here a device starts its node, which sends this with `boot`
                    LssReceived::NodeId(node_id) => {
                        let boot_up = Frame::new(0x700 + u16::from(node_id), &[0]);
                        bus.send(&boot_up.ok_or(ErrorKind::InvalidData)?)?;
                    }
                    LssReceived::Store { node_id, bit_rate } => {
                        println!("stored {node_id:?} {bit_rate:?}");
                        io::stdout().flush()?;
                        // a device that is to have no node-ID is broken here, for the test
                        let result = node_id.map(drop).ok_or(LssStoreError::NoAccess);
                        bus.send(&LssSlave::answer_store(result))?;
                    }
                }
            }
        }
        for slave in &mut slaves {
            if let Some(bit_rate) = slave.poll(now()) {
                println!("{bit_rate} kbit/s");
                io::stdout().flush()?;
            }
        }
    }
}
