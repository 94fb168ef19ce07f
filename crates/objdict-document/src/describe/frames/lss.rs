//! LSS in words (CiA 305).

/// The CAN-ID of the slaves.
pub(super) const FROM_SLAVE: u32 = 0x7E4;
/// The CAN-ID of the master.
pub(super) const FROM_MASTER: u32 = 0x7E5;

/// The parts of an LSS address.
const PARTS: [&str; 4] = ["vendor-ID", "product code", "revision number", "serial number"];

/// Bit rates of table 0 in kbit/s.
const BIT_RATES: [&str; 10] = ["1000", "800", "500", "250", "125", "100", "50", "20", "10", "automatic"];

/// What a frame says.
pub(super) fn words(data: &[u8], is_request: bool) -> String {
    let Ok([command, first, second, third, fourth, bit, part, next]) = <[u8; 8]>::try_from(data) else {
        return format!("LSS of {} bytes", data.len());
    };
    let number = u32::from_le_bytes([first, second, third, fourth]);
    let said = match (command, is_request) {
        (0x04, _) if first == 0 => "all nodes to waiting".to_owned(),
        (0x04, _) => "all nodes to configuration".to_owned(),
        (0x40..=0x43, _) => format!("select {} {number:08X}h", PARTS[usize::from(command - 0x40)]),
        (0x44, _) => "the selected node is in configuration".to_owned(),
        (0x11, true) if first == 0xFF => "configure no node-ID".to_owned(),
        (0x11, true) => format!("configure node-ID {first}"),
        (0x13, true) => format!("configure bit rate {}", bit_rate(first, second)),
        (0x15, _) => format!("activate the bit rate after {} ms", u16::from_le_bytes([first, second])),
        (0x17, true) => "store the configuration".to_owned(),
        (0x11 | 0x13 | 0x17, false) => format!("{} {}", configured(command), result(first)),
        (0x5A..=0x5D, true) => format!("inquire {}", PARTS[usize::from(command - 0x5A)]),
        (0x5A..=0x5D, false) => format!("{} {number:08X}h", PARTS[usize::from(command - 0x5A)]),
        (0x5E, true) => "inquire node-ID".to_owned(),
        (0x5E, false) if first == 0xFF => "the node has no node-ID".to_owned(),
        (0x5E, false) => format!("node-ID {first}"),
        (0x46..=0x4B, _) => format!("identify {} {number:08X}h", RANGE[usize::from(command - 0x46)]),
        (0x4C, _) => "identify nodes without node-ID".to_owned(),
        (0x4F, _) => "a node is identified".to_owned(),
        (0x50, _) => "a node without node-ID is there".to_owned(),
        (0x51, _) if bit == 0x80 => "fastscan: all nodes without node-ID".to_owned(),
        (0x51, _) => {
            let part = PARTS.get(usize::from(part)).copied().unwrap_or("unknown part");
            format!("fastscan: {part} {number:08X}h from bit {bit} on, next {next}")
        }
        _ => format!("unknown command {command:02X}h"),
    };
    format!("LSS {}: {said}", if is_request { "master" } else { "node" })
}

/// The parts of a range of LSS addresses.
const RANGE: [&str; 6] = [
    "vendor-ID",
    "product code",
    "revision numbers from",
    "revision numbers to",
    "serial numbers from",
    "serial numbers to",
];

fn configured(command: u8) -> &'static str {
    match command {
        0x11 => "node-ID",
        0x13 => "bit rate",
        _ => "configuration",
    }
}

fn result(error: u8) -> String {
    match error {
        0 => "is accepted".to_owned(),
        0xFF => "is refused, error of the vendor".to_owned(),
        _ => format!("is refused, error {error}"),
    }
}

fn bit_rate(table: u8, at: u8) -> String {
    match BIT_RATES.get(usize::from(at)) {
        Some(&rate) if table == 0 && rate != "automatic" => format!("{rate} kbit/s"),
        Some(&rate) if table == 0 => rate.to_owned(),
        _ => format!("{at} of table {table}"),
    }
}
