//! The LSS slave beside a node whose description says `LSS_Supported` (CiA 305).

use objdict_device::{Frame, LssReceived, LssSlave};

use super::bench::{Bench, MS};
use super::described::hex;
use super::{CheckStep, absent, checks, ensure, impossible};

checks! { "LSS":
    "CiA 305" "no response to inquiries in the waiting state" |bench| line(bench)?.says(&[0x5A], NOTHING);
    "CiA 305" "switch state global, and inquire the identity" inquire;
    "CiA 305" "switch state selective" |bench| by_identity(bench, &[0x40, 0x41, 0x42, 0x43], 0x44);
    "CiA 305" "identify a slave" |bench| by_identity(bench, &[0x46, 0x47, 0x48, 0x49, 0x4A, 0x4B], 0x4F);
    "CiA 305" "identify a slave without node-ID" |bench| { line(bench)?.says(&[0x4C], NOTHING)?; without_node_id(bench)?.says(&[0x4C], &[0x50]) };
    "CiA 305" "fastscan finds the identity of a slave without node-ID" fastscan;
    "CiA 305" "fastscan: a slave with a node-ID does not respond" |bench| line(bench)?.says(&[0x51, 0, 0, 0, 0, 0x80], NOTHING);
    "CiA 305" "a node-ID of 0 and of 128 is rejected" |bench| { let mut line = line(bench)?; line.configure()?; line.says(&[0x11, 0], &[0x11, 1])?; line.says(&[0x11, 128], &[0x11, 1]) };
    "CiA 305" "a node-ID is valid after a reset" node_id;
    "CiA 305" "a slave without node-ID begins with the first one" first_node_id;
    "CiA 305" "only bit rates of the description" bit_rates;
    "CiA 305" "activate a bit rate: silent for both delays" activate;
    "CiA 305" "store without a memory is rejected" |bench| { let mut line = line(bench)?; line.configure()?; line.says(&[0x17], &[0x17, 1]) };
    "CiA 305" "store gives the application the node-ID" store;
}

/// The bit rates of CiA 305 in the order of their rows, each as a list of its own: a slave has those that its driver has.
const RATES: [[u16; 1]; 10] = [[1000], [800], [500], [250], [125], [100], [50], [20], [10], [0]];

const NOTHING: &[u8] = &[];

/// A slave, and the time.
struct LssLine {
    slave: LssSlave,
    identity: [u32; 4],
    now: u64,
}

/// A slave with the identity of the description and the node-ID.
fn line(bench: &mut Bench<'_>) -> CheckStep<LssLine> {
    let node_id = bench.described.node_id;
    with(bench, Some(node_id))
}

fn without_node_id(bench: &mut Bench<'_>) -> CheckStep<LssLine> {
    with(bench, None)
}

fn with(bench: &mut Bench<'_>, node_id: Option<u8>) -> CheckStep<LssLine> {
    if !bench.described.has_lss {
        return absent("LSS");
    }
    let mut identity = [0; 4];
    for (sub, number) in (1..).zip(&mut identity) {
        *number = bench.number(0x1018, sub)? as u32;
    }
    let slave = LssSlave::new(identity, node_id);
    Ok(LssLine { slave, identity, now: 0 })
}

impl LssLine {
    fn request(&mut self, request: &[u8]) -> LssReceived {
        let mut bytes = [0; 8];
        bytes[..request.len()].copy_from_slice(request);
        let frame = Frame::new(0x7E5, &bytes);
        frame.map_or(LssReceived::Ignored, |frame| self.slave.receive(&frame, self.now))
    }

    /// Checks the answer, whose further bytes are 0.
    fn says(&mut self, request: &[u8], expected: &[u8]) -> CheckStep {
        let received = self.request(request);
        let data = match &received {
            LssReceived::Answer(frame) if frame.id() == 0x7E4 => frame.data(),
            _ => NOTHING,
        };
        let is_expected = data.starts_with(expected) && data[expected.len()..].iter().all(|byte| *byte == 0);
        ensure(is_expected && data.is_empty() == expected.is_empty(), || {
            format!("after {}: {}, not {}", hex(request), hex(data), hex(expected))
        })
    }

    /// A service with a number.
    fn says_to(&mut self, command: u8, number: u32, expected: &[u8]) -> CheckStep {
        let [a, b, c, d] = number.to_le_bytes();
        self.says(&[command, a, b, c, d], expected)
    }

    /// Switches to the configuration state.
    fn configure(&mut self) -> CheckStep {
        self.says(&[0x04, 1], NOTHING)
    }
}

fn inquire(bench: &mut Bench<'_>) -> CheckStep {
    let mut line = line(bench)?;
    line.configure()?;
    for (command, number) in (0x5A..).zip(line.identity) {
        let [a, b, c, d] = number.to_le_bytes();
        line.says(&[command], &[command, a, b, c, d])?;
    }
    line.says(&[0x5E], &[0x5E, bench.described.node_id])
}

/// Sends the identity by these services, the last of which is answered, unless a number is that of another device.
fn by_identity(bench: &mut Bench<'_>, commands: &[u8], answer: u8) -> CheckStep {
    let mut line = line(bench)?;
    let [vendor, product, revision, serial] = line.identity;
    let own = |command: u8| match command {
        0x40 | 0x46 => vendor,
        0x41 | 0x47 => product,
        0x42 | 0x48 | 0x49 => revision,
        _ => serial,
    };
    // a lowest number above that of the device, a highest one below it
    let other = |command: u8| match command {
        0x48 | 0x4A => own(command).checked_add(1),
        0x49 | 0x4B => own(command).checked_sub(1),
        _ => Some(own(command) ^ 1),
    };
    for wrong in commands {
        let Some(other) = other(*wrong) else { continue };
        for &command in commands {
            line.says_to(command, if command == *wrong { other } else { own(command) }, NOTHING)?;
        }
    }
    for &command in commands {
        let is_last = commands.last() == Some(&command);
        line.says_to(command, own(command), if is_last { std::slice::from_ref(&answer) } else { NOTHING })?;
    }
    Ok(())
}

/// As a master does it that knows nothing: it asks for a bit, and the answer says that the bit is 0.
fn fastscan(bench: &mut Bench<'_>) -> CheckStep {
    let mut line = without_node_id(bench)?;
    line.says(&[0x51, 0, 0, 0, 0, 0x80], &[0x4F])?;
    let mut found = [0_u32; 4];
    for part in 0..4_u8 {
        let mut number = 0_u32;
        let scan = |line: &mut LssLine, number: u32, bit: u8, next: u8| {
            let [a, b, c, d] = number.to_le_bytes();
            line.request(&[0x51, a, b, c, d, bit, part, next]) != LssReceived::Ignored
        };
        for bit in (0..32).rev() {
            number |= u32::from(!scan(&mut line, number, bit, part)) << bit;
        }
        ensure(scan(&mut line, number, 0, (part + 1) % 4), || format!("{number:08X}h is not confirmed"))?;
        found[usize::from(part)] = number;
    }
    ensure(found == line.identity, || format!("{found:X?}, not {:X?}", line.identity))?;
    line.says(&[0x5E], &[0x5E, 0xFF])
}

fn node_id(bench: &mut Bench<'_>) -> CheckStep {
    let (mut line, old, new) = (line(bench)?, bench.described.node_id, bench.neighbour());
    line.configure()?;
    line.says(&[0x11, new], &[0x11])?;
    line.says(&[0x5E], &[0x5E, old])?;
    let valid = line.slave.reset();
    ensure(valid == Some(new), || format!("the node-ID after the reset is {valid:?}"))
}

fn first_node_id(bench: &mut Bench<'_>) -> CheckStep {
    let (mut line, new) = (without_node_id(bench)?, bench.neighbour());
    line.configure()?;
    line.says(&[0x11, new], &[0x11])?;
    let received = line.request(&[0x04, 0]);
    ensure(received == LssReceived::NodeId(new), || format!("{received:?}"))
}

/// A slave in the configuration state whose driver has a bit rate of the description, and its row.
fn with_bit_rate(bench: &mut Bench<'_>) -> CheckStep<(LssLine, u8)> {
    let (mut line, rates) = (line(bench)?, &bench.described.bit_rates);
    let Some((row, rate)) = (0..).zip(&RATES).find(|(_, rate)| rates.contains(&rate[0])) else {
        return impossible("the description has no bit rate of CiA 305");
    };
    line.slave = line.slave.clone().with_bit_rates(rate);
    line.configure()?;
    Ok((line, row))
}

fn bit_rates(bench: &mut Bench<'_>) -> CheckStep {
    let (mut line, row) = with_bit_rate(bench)?;
    line.says(&[0x13, 0, row], &[0x13])?;
    line.says(&[0x13, 0, (row + 1) % 9], &[0x13, 1])?;
    line.says(&[0x13, 1, row], &[0x13, 1])
}

fn activate(bench: &mut Bench<'_>) -> CheckStep {
    const DELAY: u64 = 100 * MS;
    let (mut line, row) = with_bit_rate(bench)?;
    line.says(&[0x13, 0, row], &[0x13])?;
    line.says(&[0x15, 100, 0], NOTHING)?;
    let mut rates = Vec::new();
    for now in [0, DELAY - 1, DELAY, 2 * DELAY - 1] {
        line.now = now;
        rates.extend(line.slave.poll(now));
        line.says(&[0x5A], NOTHING)?;
    }
    line.now = 2 * DELAY;
    rates.extend(line.slave.poll(line.now));
    ensure(rates == RATES[usize::from(row)], || format!("the driver changes to {rates:?}"))?;
    line.says(&[0x5E], &[0x5E, bench.described.node_id])
}

fn store(bench: &mut Bench<'_>) -> CheckStep {
    let (mut line, new) = (line(bench)?, bench.neighbour());
    line.slave = line.slave.clone().with_storage();
    line.configure()?;
    line.says(&[0x11, new], &[0x11])?;
    let received = line.request(&[0x17]);
    let expected = LssReceived::Store { node_id: Some(new), bit_rate: None };
    ensure(received == expected, || format!("{received:?}"))?;
    let answer = LssSlave::answer_store(Ok(()));
    ensure(answer.data().starts_with(&[0x17, 0, 0]), || hex(answer.data()))
}
