//! A concise DCF as a stream or as text, and the same stream layout in Ethernet POWERLINK.

use super::{ContentKind, Identification, list};
use objdict_node::concise::looks_like;
use objdict_node::download::{ConciseDcf, DecodeErrorKind, Download};

/// The size of the count, and the minimum size of an entry.
const COUNT: usize = 4;
const HEADER: usize = 7;

/// Identifies a stream that is entirely a concise DCF.
pub(super) fn of_stream(bytes: &[u8]) -> Option<Identification> {
    let count = u32::from_le_bytes(*bytes.first_chunk()?);
    let least = u64::from(count) * HEADER as u64 + COUNT as u64;
    if least > bytes.len() as u64 {
        return None;
    }
    match ConciseDcf::parse(bytes) {
        Ok(configuration) => Some(identified(&configuration, bytes.len())),
        Err(error) if matches!(error.kind, DecodeErrorKind::PaddedInteger { .. }) => Some(
            Identification::new(ContentKind::ConciseDcf, format!("it has the layout of one, but {error}")),
        ),
        Err(_) => None,
    }
}

/// Identifies objdict's text format of a concise DCF: the first line has an entry and a data type.
pub(super) fn of_text(text: &str) -> Option<Identification> {
    let reason = "its first line has an entry, a data type and a value, as the text of a download";
    looks_like(text).then(|| Identification::new(ContentKind::ConciseText, reason))
}

fn identified(configuration: &ConciseDcf, length: usize) -> Identification {
    let marks = powerlink_marks(configuration);
    let downloads = configuration.0.len();
    let entries = if downloads == 1 { "entry".to_owned() } else { format!("{downloads} entries") };
    let layout = match downloads {
        0 => "the bytes are only a count of 0".to_owned(),
        1 => format!("a count of 1 and one {entries} fill the {length} bytes exactly"),
        _ => format!("a count and {entries} fill the {length} bytes exactly"),
    };
    if marks.len() < 2 {
        return Identification::new(ContentKind::ConciseDcf, layout);
    }
    let reason = format!("{layout}, and only Ethernet POWERLINK has {}", list(&marks));
    let technology = Some("Ethernet POWERLINK".to_owned());
    Identification { technology, ..Identification::new(ContentKind::PowerlinkConcise, reason) }
}

/// Objects that POWERLINK managers receive and CANopen devices do not. A single one may be a peculiarity of a
/// device.
fn powerlink_marks(configuration: &ConciseDcf) -> Vec<String> {
    let has = |test: fn(&Download) -> bool| configuration.0.iter().find(|download| test(download));
    let mut marks = Vec::new();
    if has(|download| is_mapping(download) && download.data.len() == 8).is_some() {
        marks.push("PDO mappings of 64 bits".to_owned());
    }
    // CiA 301 reserves 1C00h to 1EFFh, and EtherCAT has 1C00h and 1C10h to 1C33h
    if let Some(cycle) = has(|download| matches!(download.index, 0x1C01..=0x1C0F)) {
        marks.push(format!("{:04X}h", cycle.index));
    }
    // CiA 302 ends at 1F91h, where network management of POWERLINK continues
    if let Some(timing) = has(|download| matches!(download.index, 0x1F8B..=0x1F8D | 0x1F92..=0x1F9F)) {
        marks.push(format!("{:04X}h", timing.index));
    }
    if has(|download| download.index == 0x1F81 && download.sub > 0x80).is_some() {
        marks.push("nodes above 128 in 1F81h".to_owned());
    }
    marks
}

fn is_mapping(download: &Download) -> bool {
    matches!(download.index, 0x1600..=0x17FF | 0x1A00..=0x1BFF) && download.sub > 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(downloads: Vec<Download>) -> Option<ContentKind> {
        let stream = ConciseDcf(downloads).write().unwrap();
        of_stream(&stream).map(|found| found.kind)
    }

    #[test]
    fn a_stream_is_read_to_its_end() {
        let stream = ConciseDcf(vec![Download::new(0x1017, 0, [0xFA, 0])]).write().unwrap();
        assert_eq!(of_stream(&stream).map(|found| found.kind), Some(ContentKind::ConciseDcf));
        assert_eq!(of_stream(&stream[..stream.len() - 1]), None);
        assert_eq!(of_stream(&[stream, vec![0]].concat()), None);
    }

    #[test]
    fn powerlink_needs_two_marks() {
        let cycle = Download::new(0x1C02, 3, [0; 4]);
        let mapping = Download::new(0x1600, 1, [0; 8]);
        assert_eq!(kind(vec![cycle.clone()]), Some(ContentKind::ConciseDcf));
        assert_eq!(kind(vec![cycle, mapping]), Some(ContentKind::PowerlinkConcise));
    }

    #[test]
    fn what_dcfgen_pads_is_recognised() {
        let mut stream = 2u32.to_le_bytes().to_vec();
        stream.extend([0x00, 0x20, 0, 3, 0, 0, 0, 1, 2, 3, 0]);
        stream.extend([0x17, 0x10, 0, 2, 0, 0, 0, 0xFA, 0]);
        let found = of_stream(&stream).unwrap();
        assert_eq!(found.kind, ContentKind::ConciseDcf);
        assert!(found.reason.contains("dcfgen"), "{}", found.reason);
    }
}
