//! The client on a simulated bus, and its errors for faults.

use std::path::Path;

use objdict_bus::{Abort, BusFrame, Frame, LiveBus, PlantNode, PowerOn};
use objdict_format::{self as format, Description};
use objdict_model::model::Device;
use objdict_model::source::SourceOptions;
use objdict_node::download::{ConciseDcf, Download};
use objdict_node::parameter::present_values;
use objdict_traffic::log::LoggedFrame;

use crate::sim::logged;
use crate::{
    ApplyOptions, BusClient, ClientError, Danger, ExpectedNode, LssPlace, NodeDifference, OtherIdentity,
    SimulatedBus, Transport, TransportError, WriteResult, undo,
};

fn description(name: &str) -> Description {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/eds");
    format::open(&fixtures.join(name), &SourceOptions::default()).unwrap()
}

fn plant(name: &str, node_id: u8) -> PlantNode {
    let device = description(name).device().clone();
    PlantNode { name: name.to_owned(), node_id, device, power_on: PowerOn::Defaults, must_boot: None }
}

/// A drive as node 5 and an I/O module as node 6.
fn simulated(new: &[u8]) -> SimulatedBus {
    SimulatedBus::new(LiveBus::new(vec![plant("drive-402.eds", 5), plant("io-401.eds", 6)], 500, new))
}

fn client() -> BusClient {
    BusClient::new(Box::new(simulated(&[])))
}

/// What goes wrong on a bus.
#[derive(Clone, Copy, PartialEq)]
enum Fault {
    /// After so many frames no node is heard.
    Vanishes(usize),
    /// Answers come so many microseconds later.
    Late(u64),
    /// Another node sends without a pause.
    Babbles,
    /// Another client asks node 5.
    OtherClient,
    /// After so many frames the adapter is gone.
    Unplugged(usize),
    /// The controller leaves the bus.
    BusOff,
    /// No node is heard after the first change of the bit rate.
    Lost,
    /// No heartbeat is heard.
    Mute,
    /// No node is heard at another bit rate than the first one.
    DeafAtOtherRates,
    /// Answers with these bytes from a position on have others.
    Answers(usize, &'static [u8], &'static [u8]),
}

struct Faulty {
    bus: SimulatedBus,
    fault: Fault,
    received: usize,
    is_changed: bool,
    late: Vec<(u64, LoggedFrame)>,
}

impl Faulty {
    fn client(fault: Fault) -> BusClient {
        BusClient::new(Box::new(Self::new(simulated(&[]), fault)))
    }

    fn new(bus: SimulatedBus, fault: Fault) -> Self {
        Self { bus, fault, received: 0, is_changed: false, late: Vec::new() }
    }
}

impl Transport for Faulty {
    fn send(&mut self, frame: &BusFrame) -> Result<(), TransportError> {
        self.bus.send(frame)
    }

    fn receive(&mut self, until: u64) -> Result<Option<LoggedFrame>, TransportError> {
        let extra = |id: u16, data: &[u8]| Ok(Some(logged(&Frame::new(id, data).unwrap().into(), 0)));
        match self.fault {
            Fault::Unplugged(count) if self.received >= count => {
                return Err(TransportError::Lost("no such device".to_owned()));
            }
            Fault::Babbles if self.bus.now() < until => {
                let until = (self.bus.now() + 130).min(until);
                return self.bus.receive(until).map(|frame| frame.or(extra(0x181, &[0]).unwrap()));
            }
            Fault::OtherClient => return extra(0x605, &[0x40, 0, 0x10, 0, 0, 0, 0, 0]),
            Fault::BusOff => {
                let mut frame = extra(0, &[0; 8]).unwrap().unwrap();
                (frame.is_error, frame.can_id) = (true, 0x40);
                return Ok(Some(frame));
            }
            _ => {}
        }
        if let Some(at) = self.late.iter().position(|(due, _)| *due <= self.bus.now()) {
            return Ok(Some(self.late.remove(at).1));
        }
        let frame = self.bus.receive(until)?;
        // heartbeats are not answers
        self.received += usize::from(frame.as_ref().is_some_and(|frame| frame.can_id == 0x585));
        match (self.fault, frame) {
            (Fault::Vanishes(count), Some(_)) if self.received > count => Ok(None),
            (Fault::Mute, Some(frame)) if frame.can_id > 0x700 => Ok(None),
            (Fault::Lost, _) if self.is_changed => Ok(None),
            (Fault::DeafAtOtherRates, _) if self.bus.bit_rate() != Some(500) => Ok(None),
            (Fault::Late(by), Some(frame)) => {
                self.late.push((self.bus.now() + by, frame));
                Ok(None)
            }
            (Fault::Answers(at, own, other), Some(mut frame))
                if frame.data().len() == 8 && frame.data()[at..].starts_with(own) =>
            {
                let mut data = frame.data().to_vec();
                data[at..at + other.len()].copy_from_slice(other);
                frame = frame.with_data(&data);
                Ok(Some(frame))
            }
            (_, frame) => Ok(frame),
        }
    }

    fn now(&self) -> u64 {
        self.bus.now()
    }

    fn bit_rate(&self) -> Option<u16> {
        self.bus.bit_rate()
    }

    fn has_bit_rates(&self) -> bool {
        matches!(self.fault, Fault::DeafAtOtherRates | Fault::Lost)
    }

    fn set_bit_rate(&mut self, bit_rate: u16) -> Result<(), TransportError> {
        self.is_changed = true;
        self.bus.set_bit_rate(bit_rate)
    }
}

#[test]
fn entries_are_read_and_written_in_every_length() {
    let mut client = client();
    assert_eq!(client.number(5, 0x1018, 1).unwrap(), 0x3F9);
    assert_eq!(client.upload(5, 0x1008, 0).unwrap(), b"Servo drive SD400");
    let no_number = client.number(5, 0x1008, 0).unwrap_err();
    assert!(matches!(no_number, ClientError::NoNumber { length: 17, .. }), "{no_number}");
    client.download(5, 0x1017, 0, &[250, 0]).unwrap();
    assert_eq!(client.number(5, 0x1017, 0).unwrap(), 250);
    let refused = client.download(5, 0x1018, 1, &[0; 4]).unwrap_err();
    assert_eq!(refused.abort(), Some(Abort::ReadOnly));
    assert_eq!(client.download(5, 0x1017, 0, &[0; 200]).unwrap_err().abort(), Some(Abort::TooLong));
}

/// A PDO does not show its sender, but another node sends it.
#[test]
fn pdos_are_of_other_nodes() {
    let mut client = Faulty::client(Fault::Babbles);
    assert!(client.require_alone(&[]).is_ok());
    client.listen(5).unwrap();
    let refused = client.require_alone(&[5, 6]).unwrap_err();
    assert!(refused.to_string().ends_with("senders of PDOs"), "{refused}");
}

#[test]
fn each_fault_ends_with_its_error() {
    let read = |fault| Faulty::client(fault).upload(5, 0x1008, 0).unwrap_err();
    let is_silent = |error: ClientError| matches!(error, ClientError::Silent { node_id: 5, .. });
    assert!(is_silent(read(Fault::Vanishes(0))));
    assert!(is_silent(read(Fault::Vanishes(1))), "in the middle of a transfer");
    assert!(is_silent(read(Fault::Late(700_000))));
    assert!(matches!(read(Fault::OtherClient), ClientError::OtherClient(5)));
    assert!(matches!(read(Fault::Unplugged(1)), ClientError::Transport(TransportError::Lost(_))));
    assert!(matches!(read(Fault::BusOff), ClientError::BusOff));
    let stopped = client().with_stop(|| true).upload(5, 0x1008, 0).unwrap_err();
    assert!(matches!(stopped, ClientError::Interrupted));
    // a node that babbles takes no answer away, and holds up no time-out
    assert_eq!(Faulty::client(Fault::Babbles).upload(5, 0x1008, 0).unwrap(), b"Servo drive SD400");
    let mut babbling = Faulty::client(Fault::Babbles);
    assert!(matches!(babbling.upload(9, 0x1000, 0), Err(ClientError::Silent { node_id: 9, .. })));
    assert!(babbling.now() < 700_000, "{}", babbling.now());
    let mut shared = Faulty::client(Fault::Late(100_000)).shared(true);
    assert_eq!(shared.upload(5, 0x1008, 0).unwrap(), b"Servo drive SD400");
}

#[test]
fn an_interrupted_transfer_is_aborted() {
    use std::cell::RefCell;
    use std::rc::Rc;
    let frames: Rc<RefCell<Vec<String>>> = Rc::default();
    let seen = Rc::clone(&frames);
    let mut client = Faulty::client(Fault::OtherClient)
        .with_observer(Box::new(move |frame| seen.borrow_mut().push(frame.to_string())));
    assert!(client.upload(5, 0x1008, 0).is_err());
    assert_eq!(frames.borrow().last().unwrap(), "605#8008100000000008", "general error");
    let seen = Rc::clone(&frames);
    let mut client = Faulty::client(Fault::BusOff)
        .with_observer(Box::new(move |frame| seen.borrow_mut().push(frame.to_string())));
    assert!(client.upload(5, 0x1008, 0).is_err());
    let is_off = |frame: &String| frame.starts_with("20000040#");
    assert!(frames.borrow().iter().any(is_off), "bus off is in a log too");
}

#[test]
fn nodes_are_found_with_their_identity() {
    let mut client = client();
    client.listen(1000).unwrap();
    let found = client.scan(1..=127, 100).unwrap();
    let nodes: Vec<_> = found.iter().map(|node| (node.node_id, node.state, node.identity[1])).collect();
    assert_eq!(nodes, [(5, Some(0x7F), Some(0x402)), (6, None, Some(0x10))]);
    assert!(client.require_alone(&[5]).is_err() && client.require_alone(&[5, 6]).is_ok());
}

/// What is saved from a node and applied to another one gives the same values; undoing it restores the values before.
#[test]
fn a_node_is_saved_applied_and_undone() {
    let drive = description("drive-402.eds");
    let mut source = client();
    for (index, sub, data) in [(0x1017, 0, &[200, 0][..]), (0x2003, 1, &[44, 1]), (0x1800, 5, &[30, 0])] {
        source.download(5, index, sub, data).unwrap();
    }
    let saved = source.save(5, drive.device()).unwrap();
    let left_out: Vec<u16> = saved.left_out.iter().map(|((index, _), _)| *index).collect();
    assert!([0x6040, 0x6060, 0x607A, 0x60FF, 0x1010, 0x1011].iter().all(|index| left_out.contains(index)));
    let (assignments, _) = present_values(drive.device(), 5, saved.values.clone());
    // 2033h has no described value
    let indexes: Vec<u16> = assignments.iter().map(|at| at.index).collect();
    assert_eq!(indexes, [0x1017, 0x1800, 0x2003, 0x2033]);
    let mut device: Device = drive.device().clone();
    device.assign(&assignments);
    let plan = ConciseDcf::plan(
        &device,
        &objdict_node::download::PlanOptions { node_id: Some(5), ..Default::default() },
    );
    let downloads = plan.unwrap().without_files().0;

    let mut target = client();
    let before = target.save(5, drive.device()).unwrap();
    let present = target.present(5, &downloads).unwrap();
    let options = ApplyOptions { verify: true, ..ApplyOptions::default() };
    let (results, error) = target.apply(5, &downloads, options);
    assert!(error.is_none() && results.iter().all(|result| *result == WriteResult::Written), "{results:?}");
    assert_eq!(target.save(5, drive.device()).unwrap().values, saved.values);
    let undo = undo(&downloads, &present);
    assert_eq!(undo.lost, []);
    assert!(target.apply(5, &undo.downloads.0, options).1.is_none());
    assert_eq!(target.save(5, drive.device()).unwrap(), before);
}

/// Whichever download fails, the results say what was written.
#[test]
fn each_refusal_and_each_loss_is_known() {
    let good = || Download::new(0x1017, 0, [200, 0]);
    for at in 0..4 {
        let mut downloads: Vec<Download> = (0..4).map(|_| good()).collect();
        downloads[at] = Download::new(0x1018, 1, [0; 4]);
        let (results, error) = client().apply(5, &downloads, ApplyOptions::default());
        assert!(error.is_none());
        assert!(results[..at].iter().all(|result| *result == WriteResult::Written));
        assert_eq!(results[at], WriteResult::Refused(Abort::ReadOnly));
        assert!(results[at + 1..].iter().all(|result| *result == WriteResult::Unsent));
        let (all, _) = client().apply(5, &downloads, ApplyOptions { go_on: true, ..ApplyOptions::default() });
        assert_eq!(all.iter().filter(|result| **result == WriteResult::Written).count(), 3);
        let lost = Faulty::client(Fault::Unplugged(at)).apply(
            5,
            &[good(), good(), good(), good()],
            ApplyOptions::default(),
        );
        assert!(matches!(lost.1, Some(ClientError::Transport(_))));
        assert_eq!(lost.0.iter().filter(|result| **result == WriteResult::Written).count(), at);
    }
}

#[test]
fn dangers_are_seen() {
    let drive = description("drive-402.eds");
    let mut client = client();
    assert_eq!(client.dangers(5, drive.device()).unwrap(), []);
    client.command(1, 5).unwrap();
    assert!(client.wait_for(5, 5, 2000).unwrap());
    assert_eq!(client.dangers(5, drive.device()).unwrap(), [Danger::Operational]);
}

#[test]
fn a_network_is_compared() {
    let wanted = |node_id, product, values| ExpectedNode {
        node_id,
        identity: [0, 0x3F9, product, 0, 0],
        values,
        state: Some(0x7F),
    };
    let heartbeat = |time: u8| vec![Download::new(0x1017, 0, [0; 2]), Download::new(0x1017, 0, [time, 1])];
    let mut client = client();
    client.listen(1000).unwrap();
    let found = client.scan(1..=127, 100).unwrap();
    let nodes = [wanted(5, 0x402, heartbeat(0xF4)), wanted(7, 1, Vec::new())];
    let expected = [(6, NodeDifference::Extra), (7, NodeDifference::Missing)];
    assert_eq!(client.compare(&nodes, &found).unwrap(), expected);
    let nodes = [wanted(5, 0x403, heartbeat(0)), wanted(6, 0x10, vec![Download::new(0x5FFF, 0, [0])])];
    let expected = [
        (
            5,
            NodeDifference::Identity(OtherIdentity {
                index: 0x1018,
                sub: 2,
                expected: 0x403,
                found: Some(0x402),
            }),
        ),
        (5, NodeDifference::Value(0x1017, 0, vec![0, 1], vec![0xF4, 1])),
        (6, NodeDifference::Unreadable(0x5FFF, 0, Abort::NoObject)),
        (6, NodeDifference::State(0x7F, None)),
    ];
    assert_eq!(client.compare(&nodes, &found).unwrap(), expected);
}

/// A bit rate at which the device is not heard is never stored; one that the adapter cannot test is.
#[test]
fn a_bit_rate_is_tested_before_it_is_stored() {
    let stored = |fault: Fault| {
        let sent = std::rc::Rc::new(std::cell::RefCell::new(Vec::new()));
        let seen = sent.clone();
        let bus = Faulty::new(simulated(&[5]), fault);
        let mut client = BusClient::new(Box::new(bus)).with_observer(Box::new(move |frame| {
            if frame.can_id == 0x7E5 {
                seen.borrow_mut().push(frame.data()[0]);
            }
        }));
        client.fastscan().unwrap().unwrap();
        let result = client.lss_configure(5, Some(250)).unwrap();
        assert_eq!(client.bit_rate(), Some(500), "the adapter is back");
        (result, sent.borrow().contains(&0x15), sent.borrow().contains(&0x17))
    };
    // a device that answers at the old bit rate alone cannot change without a power-on
    assert_eq!(stored(Fault::DeafAtOtherRates), (Ok(false), true, true));
    assert_eq!(stored(Fault::Lost), (Err(LssPlace::Test), true, false));
    assert_eq!(stored(Fault::Late(0)), (Ok(false), false, true));
}

/// A node that should send heartbeats, answers, and is not heard.
#[test]
fn a_silent_heartbeat_is_a_difference() {
    let mut client = Faulty::client(Fault::Mute);
    client.listen(1000).unwrap();
    let found = client.scan(5..=5, 100).unwrap();
    let node = |period: u16| ExpectedNode {
        node_id: 5,
        identity: [0; 5],
        values: vec![Download::new(0x1017, 0, period.to_le_bytes())],
        state: None,
    };
    assert_eq!(client.compare(&[node(500)], &found).unwrap(), [(5, NodeDifference::NoHeartbeat(500))]);
    // one that may only be due later
    client.download(5, 0x1017, 0, &60_000_u16.to_le_bytes()).unwrap();
    assert_eq!(client.compare(&[node(60_000)], &found).unwrap(), []);
}

#[test]
fn a_new_device_is_found_and_gets_its_node_id() {
    let mut client = BusClient::new(Box::new(simulated(&[5])));
    assert!(client.upload(5, 0x1000, 0).is_err());
    let identity = client.fastscan().unwrap().unwrap();
    assert_eq!(identity, [0x3F9, 0x402, 0x10001, 0]);
    assert_eq!(client.lss_configure(5, Some(250)).unwrap(), Ok(true));
    assert_eq!(client.bit_rate(), Some(250), "the adapter has changed with the device");
    client.lss_waiting().unwrap();
    assert_eq!(client.number(5, 0x1018, 2).unwrap(), 0x402);
    assert_eq!(client.fastscan().unwrap(), None, "it has a node-ID now");
    assert!(client.lss_select(identity).unwrap());
    assert!(!client.lss_select([1, 2, 3, 4]).unwrap());
}

/// The node that the simulation has passes every check that a device on a bus can pass; one with another description does not.
#[test]
fn a_device_is_checked_against_its_description() {
    use std::cell::RefCell;
    use std::rc::Rc;

    use objdict_bus::{Conformance, RemoteGroups, Verdict, conformance_on, conformance_plan};

    use crate::CheckedDevice;

    let check = |file: &str, writes: bool| {
        let mut client = client().with_timeout(50);
        client.listen(10).unwrap();
        client.download(5, 0x1017, 0, &700_u16.to_le_bytes()).unwrap();
        client.download(5, 0x2000, 0, b"a label that is not the default").unwrap();
        let described = description(file);
        let before = client.save(5, described.device()).unwrap();
        let device = Rc::new(RefCell::new(CheckedDevice { client, failure: None }));
        let groups = RemoteGroups { writes, commands: writes };
        let plan = conformance_plan(described.device(), 5, groups);
        let results = conformance_on(described.device(), 5, device.clone(), groups);
        let rows = |results: &Conformance| -> Vec<_> {
            results.checks.iter().map(|check| (check.service, check.name.clone())).collect()
        };
        assert_eq!(rows(&plan), rows(&results));
        for (planned, check) in plan.checks.iter().zip(&results.checks) {
            let is_planned = matches!(planned.verdict, Verdict::Planned(_));
            assert!(is_planned || planned.verdict == check.verdict, "{check:?}");
        }
        let CheckedDevice { client, failure } = &mut *device.borrow_mut();
        assert!(failure.is_none());
        // the reset clears what was not stored
        let cleared = if writes { vec![(0x1017, 0), (0x2000, 0)] } else { Vec::new() };
        assert_eq!(client.put_back(5, &before).unwrap(), (cleared, Vec::new()));
        assert_eq!(client.save(5, described.device()).unwrap(), before);
        results
    };
    for writes in [false, true] {
        let results = check("drive-402.eds", writes);
        let failed: Vec<_> =
            results.checks.iter().filter(|check| matches!(check.verdict, Verdict::Failed(_))).collect();
        assert!(failed.is_empty(), "{failed:#?}");
        let passed = results.passed().0;
        assert!(if writes { passed > 150 } else { (100..150).contains(&passed) }, "{passed}");
    }
    assert!(!check("io-401.eds", false).is_clean());
}

/// Nodes with other answers that CiA 301 allows: no CRC in block downloads, and an abort for an object that does not exist.
#[test]
fn other_answers_that_the_standard_allows_pass() {
    use objdict_bus::{RemoteGroups, Verdict, conformance_on};

    use crate::CheckedDevice;

    let checked = |fault: Fault| {
        let device = CheckedDevice { client: Faulty::client(fault).with_timeout(50), failure: None };
        let groups = RemoteGroups { writes: true, commands: false };
        let device = std::rc::Rc::new(std::cell::RefCell::new(device));
        let mut results = conformance_on(description("drive-402.eds").device(), 5, device, groups).checks;
        results.retain(|check| check.verdict != Verdict::Passed);
        results
    };
    let without_crc = checked(Fault::Answers(0, &[0xA4], &[0xA0]));
    let crc = without_crc.iter().find(|check| check.name.ends_with("a wrong CRC in a block download"));
    assert_eq!(crc.unwrap().verdict, Verdict::Impossible("the server makes no CRC".to_owned()));
    // 0604 0041h and 0602 0000h
    let no_object = checked(Fault::Answers(4, &[0x41, 0, 4, 6], &[0, 0, 2, 6]));
    let failed: Vec<_> =
        no_object.iter().filter(|check| matches!(check.verdict, Verdict::Failed(_))).collect();
    assert!(failed.iter().all(|check| check.name.ends_with("not mappable is rejected")), "{failed:#?}");
}

/// Even of a device without other entries no setpoint and no command is written.
#[test]
fn no_check_writes_what_a_machine_obeys() {
    use std::cell::RefCell;
    use std::rc::Rc;

    use objdict_bus::{RemoteGroups, conformance_on};
    use objdict_node::parameter::no_parameter;

    use crate::CheckedDevice;

    let mut device = description("drive-402.eds").device().clone();
    device.objects.retain(|index, _| !(0x2000..0x6000).contains(index) && *index != 0x1017);
    let written = Rc::new(RefCell::new(Vec::new()));
    let seen = written.clone();
    let client = client().with_timeout(50).with_observer(Box::new(move |frame| {
        if let (0x605, &[command, low, high, sub, ..]) = (frame.can_id, frame.data())
            && (command & 0xF0 == 0x20 || command & 0xE1 == 0xC0)
        {
            seen.borrow_mut().push((u16::from_le_bytes([low, high]), sub));
        }
    }));
    let checked = Rc::new(RefCell::new(CheckedDevice { client, failure: None }));
    conformance_on(&device, 5, checked, RemoteGroups { writes: true, commands: true });
    let written = written.borrow();
    let obeyed: Vec<_> = written.iter().filter(|(index, _)| *index >= 0x2000 && *index < 0xA000).collect();
    assert!(written.len() > 20, "{written:?}");
    let obeyed = obeyed.into_iter().filter(|(index, sub)| no_parameter(&device, *index, *sub).is_some());
    assert_eq!(obeyed.collect::<Vec<_>>(), [&(0, 0); 0]);
}

/// A serial adapter whose other end is a pseudo-terminal with simulated nodes behind it.
#[cfg(unix)]
#[test]
fn a_serial_adapter_works_on_a_pseudo_terminal() {
    use std::time::Duration;

    use serialport::{SerialPort, TTYPort};

    use crate::SlcanAdapter;

    let (mut adapter, mut port) = TTYPort::pair().unwrap();
    adapter.set_timeout(Duration::from_millis(20)).unwrap();
    port.set_timeout(Duration::from_millis(10)).unwrap();
    let behind = std::thread::spawn(move || serve(&mut adapter));
    let mut client = BusClient::new(Box::new(SlcanAdapter::new(port, 500).unwrap()));
    assert_eq!(client.bit_rate(), Some(500));
    assert_eq!(client.upload(5, 0x1008, 0).unwrap(), b"Servo drive SD400");
    client.download(5, 0x1017, 0, &[100, 0]).unwrap();
    assert_eq!(client.number(5, 0x1017, 0).unwrap(), 100);
    assert_eq!(client.upload(5, 0x5FFF, 0).unwrap_err().abort(), Some(Abort::NoObject));
    let found: Vec<u8> = client.scan(1..=8, 200).unwrap().iter().map(|node| node.node_id).collect();
    assert_eq!(found, [5, 6]);
    drop(client);
    // what is written before a pseudo-terminal closes may be lost with it
    assert_eq!(behind.join().unwrap()[..4], ["", "C", "S6", "O"]);
}

/// A serial port of an adapter that hears a node once these commands were the last ones, and never without any.
struct RecordedPort(std::rc::Rc<std::cell::RefCell<Vec<u8>>>, Option<&'static [u8]>);

impl std::io::Read for RecordedPort {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if !self.1.is_some_and(|commands| self.0.borrow().ends_with(commands)) {
            return Err(std::io::ErrorKind::TimedOut.into());
        }
        buffer[..8].copy_from_slice(b"t705105\r");
        Ok(8)
    }
}

impl std::io::Write for RecordedPort {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.borrow_mut().extend(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_serial_adapter_is_closed_at_the_end() {
    let written = std::rc::Rc::default();
    drop(crate::SlcanAdapter::new(RecordedPort(std::rc::Rc::clone(&written), None), 125).unwrap());
    assert_eq!(*written.borrow(), b"\rC\rS4\rO\rC\r");
}

#[test]
fn the_bit_rate_of_a_bus_is_found_by_listening() {
    let adapter =
        crate::SlcanAdapter::listening(RecordedPort(std::rc::Rc::default(), Some(b"S4\rL\r")), 1000)
            .unwrap()
            .unwrap();
    assert_eq!(adapter.bit_rate(), Some(125));
    let written = std::rc::Rc::default();
    let silent = RecordedPort(std::rc::Rc::clone(&written), None);
    assert!(crate::SlcanAdapter::listening(silent, 1000).unwrap().is_none());
    assert!(!written.borrow().contains(&b'O'), "a bus whose bit rate is unknown is not disturbed");
}

/// Serves the nodes behind an adapter until it is closed for the second time; returns the commands.
#[cfg(unix)]
fn serve(adapter: &mut (impl std::io::Read + std::io::Write)) -> Vec<String> {
    let mut bus = simulated(&[]);
    let (mut line, mut commands, mut byte) = (Vec::new(), Vec::new(), [0]);
    while commands.iter().filter(|command| *command == "C").count() < 2 {
        match adapter.read(&mut byte) {
            Ok(1) if byte[0] != b'\r' => line.push(byte[0]),
            Ok(1) => {
                let text = String::from_utf8(std::mem::take(&mut line)).unwrap();
                let Some(frame) = text.strip_prefix('t') else {
                    commands.push(text);
                    // the other end may be closed already
                    let _ = adapter.write_all(b"\r");
                    continue;
                };
                let byte = |at: usize| u8::from_str_radix(&frame[4 + 2 * at..6 + 2 * at], 16).unwrap();
                let data: Vec<u8> = (0..frame.len() / 2 - 2).map(byte).collect();
                let id = u16::from_str_radix(&frame[..3], 16).unwrap();
                bus.send(&Frame::new(id, &data).unwrap().into()).unwrap();
                let mut answer = "z\r".to_owned();
                let until = bus.now() + 4000;
                while let Some(frame) = bus.receive(until).unwrap() {
                    let digits: String = frame.data().iter().map(|byte| format!("{byte:02X}")).collect();
                    answer += &format!("t{:03X}{}{digits}\r", frame.can_id, frame.data().len());
                }
                adapter.write_all(answer.as_bytes()).unwrap();
            }
            Err(error) if error.kind() == std::io::ErrorKind::TimedOut => {}
            // the other end is closed
            _ => break,
        }
    }
    commands
}
