//! SDO transfers: what is written and read (CiA 301 §7.2.4.3).

use std::collections::BTreeMap;

use objdict_device::Abort;

use super::talker::Talkers;

/// The most bytes of a value that are kept to show it.
const LONGEST: usize = 1 << 16;

/// A transfer of one server, from its request on.
#[derive(Debug)]
struct Transfer {
    entry: (u16, u8),
    is_download: bool,
    /// What is known of the value.
    data: Vec<u8>,
    is_complete: bool,
}

/// The transfers by the node-IDs of their servers.
#[derive(Debug, Default)]
pub(super) struct Transfers(BTreeMap<u8, Transfer>);

impl Transfers {
    /// What a client sends.
    pub(super) fn request(&mut self, talkers: &Talkers<'_>, node_id: u8, data: &[u8]) -> String {
        let name = talkers.name(node_id);
        let Ok(bytes) = <[u8; 8]>::try_from(data) else {
            return format!("SDO of {} bytes to {name}", data.len());
        };
        let [command, low, high, sub, value @ ..] = bytes;
        let entry = (u16::from_le_bytes([low, high]), sub);
        match command >> 5 {
            1 => {
                let expedited = expedited(command, value);
                let text = match &expedited {
                    Some(value) => format!("write {}", talkers.value(node_id, entry, value)),
                    None => format!("write {}{}", talkers.entry(node_id, entry), sized(command, value)),
                };
                self.begin(node_id, entry, true, expedited);
                format!("{name}: {text}")
            }
            2 => {
                self.begin(node_id, entry, false, None);
                format!("{name}: read {}", talkers.entry(node_id, entry))
            }
            0 => self.segment(talkers, node_id, &bytes, true, &name),
            3 => format!("{name}: next segment"),
            4 => format!("{name}: {}", abort(talkers, node_id, entry, value)),
            5 | 6 => format!("{name}: block transfer"),
            _ => format!("{name}: unknown SDO command {command:02X}h"),
        }
    }

    /// What a server sends.
    pub(super) fn response(&mut self, talkers: &Talkers<'_>, node_id: u8, data: &[u8]) -> String {
        let name = talkers.name(node_id);
        let Ok(bytes) = <[u8; 8]>::try_from(data) else {
            return format!("SDO of {} bytes from {name}", data.len());
        };
        let [command, low, high, sub, value @ ..] = bytes;
        let entry = (u16::from_le_bytes([low, high]), sub);
        let address = format!("{:04X}:{:02X}", entry.0, entry.1);
        match command >> 5 {
            3 => match self.0.get(&node_id) {
                Some(transfer) if transfer.is_complete => format!("{name}: {address} is written"),
                _ => format!("{name}: {address} is expected"),
            },
            2 => match expedited(command, value) {
                Some(value) => format!("{name}: {}", talkers.value(node_id, entry, &value)),
                None => format!("{name}: {}{}", talkers.entry(node_id, entry), sized(command, value)),
            },
            1 => match self.0.get(&node_id) {
                Some(Transfer { entry: (index, sub), is_complete: true, .. }) => {
                    format!("{name}: {index:04X}:{sub:02X} is written")
                }
                _ => format!("{name}: segment is accepted"),
            },
            0 => self.segment(talkers, node_id, &bytes, false, &name),
            4 => format!("{name}: {}", abort(talkers, node_id, entry, value)),
            5 | 6 => format!("{name}: block transfer"),
            _ => format!("{name}: unknown SDO command {command:02X}h"),
        }
    }

    fn begin(&mut self, node_id: u8, entry: (u16, u8), is_download: bool, value: Option<Vec<u8>>) {
        let is_complete = value.is_some();
        let transfer = Transfer { entry, is_download, data: value.unwrap_or_default(), is_complete };
        self.0.insert(node_id, transfer);
    }

    /// A segment of a value; with the last one the value is known.
    fn segment(
        &mut self,
        talkers: &Talkers<'_>,
        node_id: u8,
        bytes: &[u8; 8],
        is_download: bool,
        name: &str,
    ) -> String {
        let Some(transfer) = self.0.get_mut(&node_id).filter(|found| found.is_download == is_download) else {
            return format!("{name}: segment without a transfer");
        };
        let [command, segment @ ..] = bytes;
        let used = 7 - usize::from(command >> 1 & 7);
        if transfer.data.len() < LONGEST {
            transfer.data.extend(&segment[..used]);
        }
        if command & 1 == 0 {
            return format!("{name}: segment of {used} bytes");
        }
        transfer.is_complete = true;
        let (entry, data) = (transfer.entry, std::mem::take(&mut transfer.data));
        format!("{name}: last segment, {}", talkers.value(node_id, entry, &data))
    }
}

fn abort(talkers: &Talkers<'_>, node_id: u8, entry: (u16, u8), code: [u8; 4]) -> String {
    format!("{}: {}", talkers.entry(node_id, entry), Abort::from(u32::from_le_bytes(code)))
}

/// The bytes of an expedited transfer.
fn expedited(command: u8, value: [u8; 4]) -> Option<Vec<u8>> {
    let length = if command & 1 == 0 { 4 } else { 4 - usize::from(command >> 2 & 3) };
    (command & 2 != 0).then(|| value[..length].to_vec())
}

/// The stated size of a segmented transfer.
fn sized(command: u8, size: [u8; 4]) -> String {
    if command & 1 == 0 { String::new() } else { format!(", {} bytes", u32::from_le_bytes(size)) }
}
