//! Logs and what is read of them: a description takes nothing from what is known without it, and every reader sees the same transfers.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use objdict::describe::frames::TransferStep;
use objdict::format;
use objdict::format::log::LogOptions;
use objdict::format::network::NetworkFile;
use objdict::model::{DataType, Device};
use objdict::network::{End, Overview, Service};
use objdict::probe::{Conversation, SdoAnswer};
use objdict::profile::{self, Profile};
use objdict::source::SourceOptions;
use objdict::traffic::{Buses, Descriptions, MergedLogs, NamedLog};

use crate::support;

const NODE: u8 = 5;

/// Numbers that are the same in each run.
struct Dice(u64);

impl Dice {
    /// A number below `count`.
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % count
    }

    fn one_of<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    fn bytes(&mut self, count: usize) -> Vec<u8> {
        // small numbers have meanings more often
        let top = self.one_of(&[4, 16, 256]);
        (0..count).map(|_| self.below(top) as u8).collect()
    }
}

/// A log of one node, frame by frame.
struct Traffic {
    dice: Dice,
    lines: Vec<String>,
}

impl Traffic {
    fn frame(&mut self, can_id: u16, data: &[u8]) {
        let number = self.lines.len();
        let data: String = data.iter().map(|byte| format!("{byte:02X}")).collect();
        self.lines.push(format!("({}.{:03}) can0 {can_id:03X}#{data}", number / 1000, number % 1000));
    }

    fn request(&mut self, data: &[u8]) {
        self.frame(0x600 + u16::from(NODE), data);
    }

    fn response(&mut self, data: &[u8]) {
        self.frame(0x580 + u16::from(NODE), data);
    }

    /// A value of up to four bytes in one frame, with its command.
    fn expedited(command: u8, (index, sub): (u16, u8), bytes: &[u8]) -> [u8; 8] {
        let [low, high] = index.to_le_bytes();
        let mut data = [command, low, high, sub, 0, 0, 0, 0];
        if !bytes.is_empty() {
            data[0] |= 3 | ((4 - bytes.len()) as u8) << 2;
            data[4..4 + bytes.len()].copy_from_slice(bytes);
        }
        data
    }

    fn read(&mut self, entry: (u16, u8), bytes: &[u8]) {
        let request = Self::expedited(0x40, entry, &[]);
        // hand-made requests lack the bytes that mean nothing
        let length = self.dice.one_of(&[4, 8, 8]);
        self.request(&request[..length]);
        if bytes.len() <= 4 {
            return self.response(&Self::expedited(0x40, entry, bytes));
        }
        let mut start = Self::expedited(0x41, entry, &[]);
        start[4] = bytes.len() as u8;
        self.response(&start);
        let count = bytes.chunks(7).count();
        for (number, segment) in bytes.chunks(7).enumerate() {
            let toggle = (number as u8 & 1) << 4;
            self.request(&[0x60 | toggle, 0, 0, 0, 0, 0, 0, 0]);
            let mut data = [0; 8];
            data[0] = toggle | ((7 - segment.len()) as u8) << 1 | u8::from(number + 1 == count);
            data[1..=segment.len()].copy_from_slice(segment);
            self.response(&data);
        }
    }

    fn write(&mut self, entry: (u16, u8), bytes: &[u8]) {
        if bytes.len() <= 4 {
            self.request(&Self::expedited(0x20, entry, bytes));
            if self.dice.below(4) == 0 {
                // a late answer to a read that the client has given up
                let late = self.dice.bytes(2);
                self.response(&Self::expedited(0x40, (0x1017, 0), &late));
            }
            return self.response(&Self::expedited(0x60, entry, &[]));
        }
        let mut start = Self::expedited(0x21, entry, &[]);
        start[4] = bytes.len() as u8;
        self.request(&start);
        self.response(&Self::expedited(0x60, entry, &[]));
        let count = bytes.chunks(7).count();
        for (number, segment) in bytes.chunks(7).enumerate() {
            let toggle = (number as u8 & 1) << 4;
            let mut data = [0; 8];
            data[0] = toggle | ((7 - segment.len()) as u8) << 1 | u8::from(number + 1 == count);
            data[1..=segment.len()].copy_from_slice(segment);
            self.request(&data);
            self.response(&[0x20 | toggle, 0, 0, 0, 0, 0, 0, 0]);
        }
    }

    fn refuse(&mut self, entry: (u16, u8)) {
        self.request(&Self::expedited(0x40, entry, &[]));
        let mut data = Self::expedited(0x80, entry, &[]);
        data[4..].copy_from_slice(&0x0602_0000_u32.to_le_bytes());
        self.response(&data);
    }

    /// An entry of a document or of a manufacturer, and how many bytes it has.
    fn entry(&mut self, profile: &Profile) -> ((u16, u8), usize) {
        if self.dice.below(8) == 0 {
            let entry = (0x2000 + self.dice.below(0x20) as u16, self.dice.below(3) as u8);
            return (entry, self.dice.one_of(&[1, 2, 4]));
        }
        let documents = [profile, profile::named("301").unwrap(), profile::named("302").unwrap()];
        let objects: Vec<_> = documents[self.dice.below(3)].objects().collect();
        let object = &objects[self.dice.below(objects.len())];
        let subs: Vec<u8> =
            (0..=object.highest_sub().min(8)).filter(|sub| object.entry(*sub).is_some()).collect();
        let sub = if subs.is_empty() { 0 } else { self.dice.one_of(&subs) };
        let data_type = object.entry(sub).and_then(|entry| entry.data_types.first().copied());
        let length = data_type.and_then(DataType::byte_length).map_or(9, usize::from);
        // one of eight has another length than the document says
        ((object.first, sub), if self.dice.below(8) == 0 { 1 + self.dice.below(6) } else { length })
    }
}

/// A log of a node of the profile: its first lines are the answer to 1000h.
fn generated(seed: u64, profile: &Profile) -> String {
    let mut traffic = Traffic { dice: Dice(seed), lines: Vec::new() };
    let device_type = u32::from(profile.number.unwrap()) | 0x2_0000;
    traffic.read((0x1000, 0), &device_type.to_le_bytes());
    for _ in 0..60 {
        let (entry, length) = traffic.entry(profile);
        // the device type decides what all others mean, and is what it is
        let is_fixed = entry == (0x1000, 0);
        let bytes = traffic.dice.bytes(length.clamp(1, 20));
        let node = u16::from(NODE);
        match traffic.dice.below(12) {
            0..4 if !is_fixed => traffic.read(entry, &bytes),
            4..7 if !is_fixed => traffic.write(entry, &bytes),
            7 => traffic.refuse(entry),
            8 => {
                let command = traffic.dice.one_of(&[1, 2, 0x80, 0x81, 0x82]);
                traffic.frame(0, &[command, NODE]);
            }
            9 => {
                let state = traffic.dice.one_of(&[0, 4, 5, 0x7F]);
                traffic.frame(0x700 + node, &[state]);
            }
            10 => {
                let (code, rest) =
                    (traffic.dice.one_of(&[0_u16, 0x8130, 0x8611, 0x5000]), traffic.dice.bytes(6));
                traffic.frame(0x80 + node, &[&code.to_le_bytes()[..], &rest].concat());
            }
            _ => {
                let (base, length) =
                    (traffic.dice.one_of(&[0x180, 0x200, 0x280, 0x300, 0x380]), traffic.dice.below(9));
                let bytes = traffic.dice.bytes(length);
                traffic.frame(base + node, &bytes);
            }
        }
    }
    traffic.lines.iter().fold(String::new(), |mut log, line| {
        let _ = writeln!(log, "{line}");
        log
    })
}

fn generated_logs() -> Vec<String> {
    let profiles = ["401", "402", "404", "406"];
    (0..48).map(|seed| generated(seed, profile::named(profiles[seed as usize % 4]).unwrap())).collect()
}

fn open(path: &Path) -> Device {
    format::open(path, &SourceOptions::default()).unwrap().into_device()
}

/// The node with this description, called as without one.
fn descriptions(device: Option<&Device>) -> Descriptions {
    let mut descriptions = Descriptions::default();
    if let Some(device) = device {
        let device = Device { commissioning: None, ..device.clone() };
        descriptions.add_device(device, Some(NODE), Path::new("node 5"), String::new());
    }
    descriptions
}

/// What is said of each frame.
fn words(log: &str, descriptions: &Descriptions) -> Vec<String> {
    let named = NamedLog::new("log".to_owned(), log.as_bytes(), LogOptions::default());
    let (mut logs, mut buses, mut words) =
        (MergedLogs(vec![named]), Buses::new(&[], descriptions), Vec::new());
    while let Some((of, frame)) = logs.next_frame().unwrap() {
        let at = buses.of(of, &frame, &logs);
        let decoded = buses.all[at].decode(&frame);
        words.push(buses.all[at].words(&decoded, &frame));
    }
    words
}

/// What `with` does not say of what `without` says, for a frame about an entry; `None` if it says all of it.
fn kept_back(without: &str, with: &str, device: &Device) -> Option<String> {
    // what only a description can say
    let mut plain =
        with.replace(" (not in the description)", "").replace(", which the description lacks", "");
    while let Some((before, rest)) = plain.split_once(", expected ") {
        let start = before.rfind(" (").unwrap();
        plain = format!("{}{}", &before[..start], rest.split_once(')').unwrap().1);
    }
    let without = match without.split_once(", expected ") {
        Some((before, rest)) => {
            format!("{}{}", &before[..before.rfind(" (").unwrap()], rest.split_once(')').unwrap().1)
        }
        None => without.to_owned(),
    };
    if plain == without {
        return None;
    }
    // a PDO by its mapping: the bytes are in the line anyway
    if ["node 5 TPDO", "node 5 RPDO"].iter().any(|start| without.contains(start)) {
        return (!plain.contains("PDO")).then(|| "the PDO".to_owned());
    }
    // a profile names its own error codes
    if let Some((start, _)) = without.split_once("h (").filter(|_| without.contains(" EMCY ")) {
        // the description may give the CAN-ID to another service
        let is_other = ["PDO ", "SYNC ", "TIME "].iter().any(|service| plain.contains(service));
        return (!plain.contains(start) && !is_other).then(|| start.to_owned());
    }
    let address = without.split(' ').find(|word| word.len() >= 7 && word.as_bytes()[4] == b':')?;
    let entry = (u16::from_str_radix(&address[..4], 16).ok()?, u8::from_str_radix(&address[5..7], 16).ok()?);
    if !plain.contains(&address[..7]) {
        return Some(address.to_owned());
    }
    let Some((named, value)) = without.split_once(" = ") else {
        return (!is_named(&plain, &address[..7]) && is_named(&without, &address[..7]))
            .then(|| "the name".to_owned());
    };
    let Some((other_name, other_value)) = plain.split_once(" = ") else {
        return Some("the value".to_owned());
    };
    if is_named(named, &address[..7]) && !is_named(other_name, &address[..7]) {
        return Some("the name".to_owned());
    }
    // the life time is that of the guard time, which a description may state
    let of_guarding = |value: &str| value.split(" (").next().map(str::to_owned);
    if entry == (0x100D, 0) && of_guarding(value) == of_guarding(other_value) {
        return None;
    }
    // bytes have become a value
    let is_raw = |value: &str| value.split(' ').all(|byte| byte.len() == 3 && byte.ends_with('h'));
    if is_raw(value) && !is_raw(other_value) && !other_value.is_empty() {
        return None;
    }
    // the description has another type: its value is more specific
    let described = device.entry(entry.0, entry.1).and_then(|found| found.implied_type());
    let documents = profile::standard().filter_map(|profile| profile.object(entry.0)?.entry(entry.1));
    let types: Vec<_> = documents.filter_map(|facts| facts.data_types.first().copied()).collect();
    let is_other_type = described.is_some_and(|described| types.iter().any(|known| *known != described));
    (value != other_value && !is_other_type && !other_value.starts_with(value.trim_end_matches(')')))
        .then(|| format!("{value}, but {other_value}"))
}

/// Whether a text has a name after the address.
fn is_named(text: &str, address: &str) -> bool {
    let (_, rest) = text.split_once(address).unwrap();
    rest.starts_with(' ') && !rest.starts_with(" =")
}

/// What is kept back of the last frame of a log, with only the frames before it that it needs.
fn smallest(mut lines: Vec<&str>, device: &Device) -> String {
    let kept_back = |lines: &[&str]| {
        let log = lines.join("\n") + "\n";
        let last = |device| words(&log, &descriptions(device)).pop().unwrap();
        let (without, with) = (last(None), last(Some(device)));
        kept_back(&without, &with, device).map(|fact| (fact, without, with))
    };
    for at in (0..lines.len() - 1).rev() {
        let mut fewer = lines.clone();
        fewer.remove(at);
        if kept_back(&fewer).is_some() {
            lines = fewer;
        }
    }
    let (fact, without, with) = kept_back(&lines).unwrap();
    format!("{fact}\nwithout: {without}\nwith:    {with}\n{}", lines.join("\n"))
}

/// The descriptions of the fixtures, healthy or not.
fn fixtures() -> Vec<PathBuf> {
    support::skips::sample(support::devices_of_all_folders())
}

#[test]
fn a_description_takes_nothing_away() {
    let logs = generated_logs();
    let without: Vec<_> = logs.iter().map(|log| words(log, &descriptions(None))).collect();
    for (position, path) in fixtures().iter().enumerate() {
        let device = open(path);
        // each description with some of the logs
        for at in (position % 16..logs.len()).step_by(16) {
            let with = words(&logs[at], &descriptions(Some(&device)));
            for (number, (without, with)) in without[at].iter().zip(&with).enumerate() {
                if kept_back(without, with, &device).is_some() {
                    let lines = logs[at].lines().take(number + 1).collect();
                    panic!("{}: {}", path.display(), smallest(lines, &device));
                }
            }
        }
    }
}

/// Also where the manager has no description: it is a node like any other.
#[test]
fn a_pdo_is_called_as_its_sender_is_in_the_network() {
    let mut made = 0;
    for path in support::files("network", &["toml", "yml"]) {
        let file = NetworkFile::open(&path, &Default::default()).unwrap();
        let (network, compiled) = (file.network().unwrap(), file.compiled().unwrap());
        let mut descriptions = Descriptions::default();
        descriptions.add_network(&file);
        for message in Overview::new(network, compiled).messages {
            let [End { node, position, service: service @ Service::Pdo(_) }] = message.senders.as_slice()
            else {
                continue;
            };
            made += usize::from(network.is_made(*position));
            let log = format!("(1.0) can0 {}#0000\n", message.can_id.to_string().trim_end_matches('h'));
            let said = words(&log, &descriptions).concat();
            let wanted = format!("{node} {service}");
            assert!(said.starts_with(&wanted), "{}: {wanted}: {said}", path.display());
        }
    }
    assert!(made > 3, "{made}");
}

/// The nodes describe what a manager sends that has no description, and they have its values.
#[test]
fn entries_of_a_made_manager_have_the_meanings_of_the_nodes() {
    let mut descriptions = Descriptions::default();
    descriptions.add_network(&super::network::open("line.toml"));
    let expected = [
        "plc TPDO 4: 6040:00 Controlword = 15 (command: enable operation, switch on, enable voltage, quick stop off, \
         enable operation)",
        "plc: read 1803:01 COB-ID used by TPDO",
        "plc TPDO 4 (1 byte, expected 2): 6040:00 Controlword is missing",
    ];
    let log = "(1.0) can0 20D#0F00\n(1.0) can0 601#4003180100000000\n(1.0) can0 20D#0F\n";
    assert_eq!(words(log, &descriptions), expected);
}

#[test]
fn what_is_not_as_described_is_said() {
    let mut device = open(&support::fixtures().join("eds/drive-402.eds"));
    for index in [0x6098, 0x1801, 0x1A01] {
        device.objects.remove(&index);
    }
    let log = "(1.0) can0 605#4098600000000000\n(1.0) can0 585#4F98600025000000\n\
        (1.0) can0 585#4F011802FE000000\n(1.0) can0 605#2F511F0101000000\n(1.0) can0 585#60511F0100000000\n\
        (1.0) can0 605#2F00210025000000\n(1.0) can0 585#4B60600001000000\n\
        (1.0) can0 285#25\n(1.0) can0 205#0F00010203\n(1.0) can0 205#0F00\n(1.0) can0 185#0F00\n";
    let expected = [
        "node 5: read 6098:00 Homing method (not in the description)",
        "node 5: 6098:00 Homing method (not in the description) = 37 (method: current position)",
        "node 5: 1801:02 Transmission type (not in the description) = 254 (event-driven, events of the manufacturer)",
        "node 5: write 1F51:01 Program control (not in the description) = 1 (command: start program)",
        "node 5: 1F51:01 (not in the description) is written",
        "node 5: write 2100:00 (not in the description) = 25h",
        "node 5: 6060:00 Modes of operation = 01h 00h (2 bytes, expected 1)",
        "node 5 TPDO 2 (not in the description): 25h",
        "to node 5 RPDO 1 (5 bytes, expected 3): 6040:00 Controlword = 15",
        "to node 5 RPDO 1 (2 bytes, expected 3): 6040:00 Controlword = 15",
        "node 5 TPDO 1 (2 bytes, expected 3): 6041:00 Statusword = 15",
    ];
    let said = words(log, &descriptions(Some(&device)));
    assert_eq!(said.len(), expected.len());
    for (said, expected) in said.iter().zip(expected) {
        assert!(said.starts_with(expected), "{said}\n{expected}");
    }
}

/// The end of a transfer: what was read, that something was written, or the abort code.
type Ended = ((u16, u8), Result<Option<Vec<u8>>, u32>);

/// The transfers of each node of each bus that a server ended, as `decode` and as `probe --answers` read them.
fn transfers(log: &[u8], descriptions: &Descriptions) -> [BTreeMap<(usize, u8), Vec<Ended>>; 2] {
    let named = NamedLog::new("log".to_owned(), log, LogOptions::default());
    let (mut logs, mut buses) = (MergedLogs(vec![named]), Buses::new(&[], descriptions));
    let (mut decoded_ones, mut frames) = (BTreeMap::<_, Vec<Ended>>::new(), Vec::new());
    while let Some((of, frame)) = logs.next_frame().unwrap() {
        let at = buses.of(of, &frame, &logs);
        let bus = &mut buses.all[at];
        let decoded = bus.decode(&frame);
        frames.push((at, frame));
        let Some((node_id, sdo)) = decoded.node_id.zip(decoded.sdo).filter(|(_, sdo)| !sdo.is_request) else {
            continue;
        };
        let end = match sdo.step {
            TransferStep::Written => Ok(None),
            TransferStep::Abort(code) => Err(code),
            step if step.has_value() => Ok(Some(bus.reader.transfer(&decoded).unwrap().data().to_vec())),
            _ => continue,
        };
        decoded_ones.entry((at, node_id)).or_default().push((sdo.entry.unwrap(), end));
    }
    let mut probed = BTreeMap::new();
    for &(at, node_id) in decoded_ones.keys() {
        let device = descriptions.nodes.iter().find(|node| node.node_id == Some(node_id));
        let mut conversation = match device {
            Some(node) => Conversation::with(&node.device, node_id),
            None => Conversation::new(node_id),
        };
        frames.iter().filter(|(of, _)| *of == at).for_each(|(_, frame)| conversation.take(frame));
        let ended = conversation.into_exchanges().into_iter().filter_map(|exchange| {
            let end = match exchange.answer {
                SdoAnswer::Bytes(bytes) => Ok(Some(bytes)),
                SdoAnswer::Unsized(bytes) => Ok(Some(bytes.to_vec())),
                SdoAnswer::Done => Ok(None),
                SdoAnswer::Abort(abort) => Err(abort.code()),
                _ => return None,
            };
            Some(((exchange.index, exchange.sub), end))
        });
        probed.insert((at, node_id), ended.collect());
    }
    [decoded_ones, probed]
}

#[test]
fn decode_and_probe_read_the_same_transfers() {
    let device = open(&support::fixtures().join("eds/drive-402.eds"));
    let files = support::files("", &["log", "asc", "trc", "csv", "pcap"]);
    let files = files.iter().map(|path| (path.display().to_string(), std::fs::read(path).unwrap()));
    let generated = generated_logs().into_iter().map(|log| (log.clone(), log.into_bytes()));
    let mut count = 0;
    for (name, log) in files.chain(generated) {
        for descriptions in [descriptions(None), descriptions(Some(&device))] {
            let [decoded, probed] = transfers(&log, &descriptions);
            assert_eq!(decoded, probed, "{name}");
            count += decoded.values().map(Vec::len).sum::<usize>();
        }
    }
    assert!(count > 2000, "{count} transfers");
}
