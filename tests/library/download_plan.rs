//! Plans of devices built here, compared byte for byte with streams that were made by hand.

use objdict::download::{
    ConciseDcf, Download, Order, PlanError, PlanOptions, Problem, ProblemKind, Scope, SkipReason, Step,
};
use objdict::model::{
    Access, Commissioning, Compact, DataType, Device, Entry, ExplicitDownload, Field, Moment, ObjFlags,
    Object, ObjectType, Place, Reason, Value,
};

const U8: DataType = DataType::UNSIGNED8;
const U16: DataType = DataType::UNSIGNED16;
const U32: DataType = DataType::UNSIGNED32;

fn unsigned(number: u64) -> Option<Value> {
    Some(Value::Unsigned(number))
}

fn entry(data_type: DataType, default: Option<Value>, value: Option<Value>) -> Entry {
    let mut entry = Entry {
        name: "Entry".into(),
        object_type: Some(ObjectType::Var),
        data_type: Some(data_type),
        access: Some(Access::Rw),
        default,
        ..Entry::default()
    };
    if value.is_some() {
        entry.configured_mut().value = value;
    }
    entry
}

/// A device of objects that are VARs (one entry, sub-index 0) or RECORDs.
#[derive(Default)]
struct Node(Device);

impl Node {
    fn new(node_id: u8) -> Self {
        let commissioning = Commissioning { node_id: Some(node_id), ..Commissioning::default() };
        Self(Device { commissioning: Some(commissioning), ..Device::default() })
    }

    fn var(mut self, index: u16, entry: Entry) -> Self {
        self.0.objects.insert(index, Object { main: entry, ..Object::default() });
        self
    }

    fn sub(mut self, index: u16, sub: u8, entry: Entry) -> Self {
        let object = self.0.objects.get_or_insert_with(index, Object::default);
        object.main.object_type = Some(ObjectType::Record);
        object.subs.insert(sub, entry);
        self
    }

    /// A PDO with `$NODEID+offset` and the mapping `default`, configured as `mapping`.
    fn pdo(
        self,
        communication: u16,
        offset: u64,
        new: Option<Value>,
        default: &[u64],
        mapping: &[u64],
    ) -> Self {
        let count = |mapping: &[u64]| unsigned(mapping.len() as u64);
        let configured = if mapping.is_empty() { None } else { count(mapping) };
        let mut node = self
            .sub(communication, 1, entry(U32, Some(Value::NodeId(offset)), new))
            .sub(communication, 2, entry(U8, unsigned(255), None))
            .sub(communication + 0x200, 0, entry(U8, count(default), configured));
        for (position, &object) in default.iter().enumerate() {
            let value = mapping.get(position).map(|&value| Value::Unsigned(value));
            node = node.sub(communication + 0x200, position as u8 + 1, entry(U32, unsigned(object), value));
        }
        node
    }

    fn stream(&self, options: &PlanOptions) -> String {
        hex(&self.configuration(options).write().unwrap())
    }

    fn configuration(&self, options: &PlanOptions) -> ConciseDcf {
        let plan = ConciseDcf::plan(&self.0, options).unwrap_or_else(|error| panic!("{error}"));
        plan.into_concise(|file| Err(format!("needs {file:?}"))).unwrap()
    }

    fn downloads(&self) -> Vec<Download> {
        self.configuration(&PlanOptions::default()).0
    }

    fn changed(&self) -> String {
        self.stream(&PlanOptions::default())
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect()
}

fn download(index: u16, sub: u8, data: &[u8]) -> Download {
    Download::new(index, sub, data)
}

/// Heartbeat producer and consumers of node 5.
#[test]
fn heartbeat() {
    let node = Node::new(5)
        .sub(0x1016, 0, Entry { access: Some(Access::Const), ..entry(U8, unsigned(2), None) })
        .sub(0x1016, 1, entry(U32, unsigned(0), unsigned(0x0007_02EE)))
        .sub(0x1016, 2, entry(U32, unsigned(0), unsigned(0x0009_05DC)))
        .var(0x1017, entry(U16, unsigned(0), unsigned(250)));
    let expected = "0300000017100002000000FA0016100104000000EE02070016100204000000DC050900";
    assert_eq!(node.changed(), expected);
}

/// RPDO 1 of node 5 listens to TPDO 1 of node 6.
#[test]
fn another_cob_id_needs_the_pdo_off() {
    let node = Node::new(5).pdo(0x1400, 0x200, unsigned(0x186), &[0x6200_0108], &[]);
    assert_eq!(node.changed(), "0200000000140104000000050200800014010400000086010000");
}

/// RPDO 2 and 3 of node 31 with other identifiers and mappings.
#[test]
fn remapping_is_off_clear_fill_count_on() {
    let objects = |subs: &[u64]| -> Vec<u64> { subs.iter().map(|sub| 0x6411_0010 | sub << 8).collect() };
    let node = Node::new(0x1F)
        .pdo(0x1401, 0x300, unsigned(0x2AA), &objects(&[1, 2, 3, 4]), &objects(&[1, 2]))
        .pdo(0x1402, 0x400, unsigned(0x3AD), &objects(&[5, 6, 7, 8]), &objects(&[3, 4]));
    let expected = "0C000000011401040000001F030080011600010000000001160104000000100111640116020400000010021164\
        011600010000000201140104000000AA020000021401040000001F04008002160001000000000216010400000010031164\
        0216020400000010041164021600010000000202140104000000AD030000";
    assert_eq!(node.changed(), expected);
}

/// TPDO 1 of the encoder on node 3: transmission type 254, inhibit time 10 ms, event timer 100 ms, position mapped.
#[test]
fn communication_parameters_come_before_the_mapping() {
    let node = Node::new(3)
        .pdo(0x1800, 0x180, Some(Value::NodeId(0x180)), &[0x6000_0010], &[0x6004_0020])
        .sub(0x1800, 2, entry(U8, unsigned(1), unsigned(254)))
        .sub(0x1800, 3, entry(U16, unsigned(0), unsigned(100)))
        .sub(0x1800, 5, entry(U16, unsigned(50), unsigned(100)));
    let expected = "08000000001801040000008301008000180201000000FE00180302000000640000180502000000640000\
        1A000100000000001A010400000020000460001A0001000000010018010400000083010000";
    assert_eq!(node.changed(), expected);
}

/// Verify configuration, then store; storing is a command and needs to be asked for.
#[test]
fn storing_comes_last_and_only_on_request() {
    let node = Node::new(5)
        .sub(0x1010, 1, entry(U32, unsigned(1), unsigned(0x6576_6173)))
        .sub(0x1020, 1, entry(U32, unsigned(0), unsigned(23)))
        .sub(0x1020, 2, entry(U32, unsigned(0), unsigned(0x5E_C9A0)));
    let on_request = PlanOptions { commands: true, ..PlanOptions::default() };
    let expected = "03000000201001040000001700000020100204000000A0C95E001010010400000073617665";
    assert_eq!(node.stream(&on_request), expected);

    let plan = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap();
    assert_eq!(plan.steps.len(), 2);
    assert_eq!(plan.skipped.len(), 1);
    assert_eq!(plan.skipped[0].place, Place::entry(0x1010, 1));
    assert_eq!(plan.skipped[0].reason, SkipReason::Command);
}

#[test]
fn nothing_to_configure_is_an_empty_stream() {
    let node = Node::new(5).var(0x1017, entry(U16, unsigned(0), unsigned(0)));
    assert_eq!(node.changed(), "00000000");
}

/// Data types of all sizes. The plan has them in the order of the dictionary.
#[test]
fn every_value_has_the_size_of_its_type() {
    let stream = "06000000236400010000000111640102000000FEFF00200003000000563412136401040000000000C03F\
        01200003000000616263022000080000000807060504030201";
    let ConciseDcf(mut expected) = ConciseDcf::parse(&bytes(stream)).unwrap();
    assert_eq!(hex(&ConciseDcf(expected.clone()).write().unwrap()), stream);
    let node = Node::new(1)
        .var(0x2000, entry(DataType::UNSIGNED24, None, unsigned(0x12_3456)))
        .var(0x2001, entry(DataType::VISIBLE_STRING, None, Some(Value::Text("abc".into()))))
        .var(0x2002, entry(DataType::UNSIGNED64, None, unsigned(0x0102_0304_0506_0708)))
        .sub(0x6411, 1, entry(DataType::INTEGER16, Some(Value::Signed(0)), Some(Value::Signed(-2))))
        .sub(0x6413, 1, entry(DataType::REAL32, None, Some(Value::Real32(1.5))))
        .var(0x6423, entry(DataType::BOOLEAN, Some(Value::Boolean(false)), Some(Value::Boolean(true))));
    expected.sort_by_key(|download| (download.index, download.sub));
    assert_eq!(node.downloads(), expected);
}

fn bytes(hex: &str) -> Vec<u8> {
    let digits: Vec<char> = hex.chars().collect();
    digits.chunks(2).map(|pair| u8::from_str_radix(&pair.iter().collect::<String>(), 16).unwrap()).collect()
}

/// Node 2 produces SYNC as 90h every 10 ms with a counter, and EMCY as A2h.
#[test]
fn sync_and_emcy_get_other_identifiers() {
    let node = Node::new(2)
        .var(0x1005, entry(U32, unsigned(0x4000_0080), unsigned(0x4000_0090)))
        .var(0x1006, entry(U32, unsigned(1000), unsigned(10_000)))
        .var(0x1014, entry(U32, Some(Value::NodeId(0x80)), unsigned(0xA2)))
        .var(0x1019, entry(U8, unsigned(0), unsigned(10)));
    let expected = "0800000006100004000000000000000510000400000080000000051000040000009000000019100001000000\
        0A0610000400000010270000051000040000009000004014100004000000820000801410000400\
        0000A2000000";
    assert_eq!(node.changed(), expected);
}

/// Node 9 changes from guarding to heartbeat.
#[test]
fn the_error_control_that_ends_is_switched_off_first() {
    let guarding = |guard: u64, factor: u64, heartbeat: u64| {
        Node::new(9)
            .var(0x100C, entry(U16, unsigned(500), unsigned(guard)))
            .var(0x100D, entry(U8, unsigned(3), unsigned(factor)))
            .var(0x1017, entry(U16, unsigned(1), unsigned(heartbeat)))
    };
    let to_heartbeat = guarding(0, 0, 1000);
    assert_eq!(to_heartbeat.changed(), "030000000C10000200000000000D1000010000000017100002000000E803");
    let to_guarding = guarding(100, 2, 0).downloads();
    let order: Vec<u16> = to_guarding.iter().map(|download| download.index).collect();
    assert_eq!(order, [0x1017, 0x100C, 0x100D]);
}

#[test]
fn sync_starts_after_the_pdos_that_wait_for_it() {
    let node = Node::new(1)
        .var(0x1005, entry(U32, unsigned(0x80), unsigned(0x4000_0080)))
        .var(0x1006, entry(U32, unsigned(0), unsigned(10_000)))
        .sub(0x1800, 1, entry(U32, Some(Value::NodeId(0x180)), None))
        .sub(0x1800, 2, entry(U8, unsigned(255), unsigned(1)));
    let expected = [
        download(0x1800, 1, &[0x81, 1, 0, 0x80]),
        download(0x1800, 2, &[1]),
        download(0x1800, 1, &[0x81, 1, 0, 0]),
        download(0x1006, 0, &[0x10, 0x27, 0, 0]),
        download(0x1005, 0, &[0x80, 0, 0, 0x40]),
    ];
    assert_eq!(node.downloads(), expected);
}

#[test]
fn a_pdo_that_is_to_be_off_is_only_switched_off() {
    let node = Node::new(4).pdo(0x1800, 0x180, Some(Value::NodeId(0x8000_0180)), &[0x6000_0108], &[]);
    assert_eq!(node.downloads(), [download(0x1800, 1, &[0x84, 1, 0, 0x80])]);
}

#[test]
fn a_pdo_whose_identifier_goes_to_another_one_is_off_before() {
    let node = Node::new(4).pdo(0x1800, 0x180, unsigned(0x284), &[0x6000_0108], &[]).pdo(
        0x1801,
        0x280,
        unsigned(0x184),
        &[0x6000_0108],
        &[],
    );
    let identifiers: Vec<(u16, u32)> = node
        .downloads()
        .iter()
        .map(|download| (download.index, u32::from_le_bytes(download.data[..].try_into().unwrap())))
        .collect();
    let expected = [(0x1801, 0x8000_0284), (0x1800, 0x8000_0184), (0x1800, 0x284), (0x1801, 0x184)];
    assert_eq!(identifiers, expected);
}

#[test]
fn entries_behind_the_last_mapped_object_stay_away_when_they_are_empty() {
    let node = Node::new(5).pdo(0x1600 - 0x200, 0x200, None, &[0x6200_0108, 0x6200_0208], &[]);
    let node = node.sub(0x1600, 0, entry(U8, unsigned(2), unsigned(1))).sub(
        0x1600,
        2,
        entry(U32, unsigned(0x6200_0208), unsigned(0)),
    );
    let plan = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap();
    assert_eq!(plan.skipped.len(), 1);
    assert_eq!(plan.skipped[0].to_string(), "`0x1600sub2` is not written: no object is mapped there");
    let expected = [
        download(0x1400, 1, &[5, 2, 0, 0x80]),
        download(0x1600, 0, &[0]),
        download(0x1600, 1, &[8, 1, 0, 0x62]),
        download(0x1600, 0, &[1]),
        download(0x1400, 1, &[5, 2, 0, 0]),
    ];
    assert_eq!(node.downloads(), expected);
}

#[test]
fn an_sdo_is_off_while_its_identifiers_change() {
    let node = Node::new(1)
        .sub(0x1280, 1, entry(U32, unsigned(0x8000_0000), unsigned(0x605)))
        .sub(0x1280, 2, entry(U32, unsigned(0x8000_0000), unsigned(0x585)))
        .sub(0x1280, 3, entry(U8, unsigned(1), unsigned(5)));
    let expected = [
        download(0x1280, 1, &[0, 0, 0, 0x80]),
        download(0x1280, 2, &[0, 0, 0, 0x80]),
        download(0x1280, 3, &[5]),
        download(0x1280, 1, &[5, 6, 0, 0]),
        download(0x1280, 2, &[0x85, 5, 0, 0]),
    ];
    assert_eq!(node.downloads(), expected);
}

#[test]
fn a_watched_node_leaves_its_old_entry_before_it_gets_another() {
    let node = Node::new(1).sub(0x1016, 1, entry(U32, unsigned(0x0007_0100), unsigned(0x0009_0100))).sub(
        0x1016,
        2,
        entry(U32, unsigned(0x0009_0100), unsigned(0x0007_0100)),
    );
    let expected = [
        download(0x1016, 2, &[0, 0, 0, 0]),
        download(0x1016, 1, &[0, 1, 9, 0]),
        download(0x1016, 2, &[0, 1, 7, 0]),
    ];
    assert_eq!(node.downloads(), expected);
}

#[test]
fn time_is_neither_consumed_nor_produced_while_its_identifier_changes() {
    let node = Node::new(1).var(0x1012, entry(U32, unsigned(0x8000_0100), unsigned(0xC000_0101)));
    let expected = [download(0x1012, 0, &[0, 1, 0, 0]), download(0x1012, 0, &[1, 1, 0, 0xC0])];
    assert_eq!(node.downloads(), expected);
}

#[test]
fn safety_parameters_are_validated_last() {
    let node = Node::new(1)
        .sub(0x1301, 1, entry(U8, unsigned(0), unsigned(1)))
        .sub(0x1301, 2, entry(U16, unsigned(50), unsigned(60)))
        .sub(0x1381, 0, entry(U8, unsigned(2), None))
        .sub(0x1381, 1, entry(U32, unsigned(0x6000_0108), unsigned(0x6000_0208)))
        .sub(0x1381, 2, entry(U32, unsigned(0x6100_0108), None))
        .var(0x13FE, entry(U8, unsigned(0), unsigned(0xA5)))
        .sub(0x13FF, 1, entry(U16, unsigned(0), unsigned(0x1234)));
    let expected = [
        download(0x13FE, 0, &[0]),
        download(0x1301, 1, &[0]),
        download(0x1301, 2, &[60, 0]),
        download(0x1381, 0, &[0]),
        download(0x1381, 1, &[8, 2, 0, 0x60]),
        download(0x1381, 2, &[8, 1, 0, 0x61]),
        download(0x1381, 0, &[2]),
        download(0x1301, 1, &[1]),
        download(0x13FF, 1, &[0x34, 0x12]),
        download(0x13FE, 0, &[0xA5]),
    ];
    assert_eq!(node.downloads(), expected);
}

#[test]
fn what_may_not_be_written_is_left_out_and_reported() {
    let ro = Entry { access: Some(Access::Ro), ..entry(U8, unsigned(0), unsigned(1)) };
    let flagged = Entry { flags: Some(ObjFlags(1)), ..entry(U8, unsigned(0), unsigned(1)) };
    let unknown = Entry { access: None, ..entry(U8, unsigned(0), unsigned(1)) };
    let node = Node::new(1)
        .var(0x60, Entry { object_type: Some(ObjectType::DefType), ..entry(U32, unsigned(8), unsigned(9)) })
        .sub(0x1003, 0, entry(U8, unsigned(1), unsigned(0)))
        .var(0x2000, ro)
        .var(0x2001, flagged)
        .var(0x2002, unknown)
        .var(0x2003, entry(U8, unsigned(0), unsigned(1)));
    let plan = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap();
    assert_eq!(plan.steps, [Step::Write(download(0x2003, 0, &[1]))]);
    let skipped: Vec<_> =
        plan.skipped.iter().map(|skipped| (skipped.place.to_string(), skipped.reason)).collect();
    let expected = [
        ("0x0060".to_owned(), SkipReason::Definition),
        ("0x1003sub0".to_owned(), SkipReason::ClearsHistory),
        ("0x2000".to_owned(), SkipReason::NotWritable),
        ("0x2001".to_owned(), SkipReason::RefusesWrite),
        ("0x2002".to_owned(), SkipReason::NoAccess),
    ];
    assert_eq!(skipped, expected);
}

#[test]
fn a_full_download_writes_every_value_but_counts() {
    let node = Node::new(1)
        .sub(0x2000, 0, entry(U8, unsigned(2), None))
        .sub(0x2000, 1, entry(U8, unsigned(7), None))
        .sub(0x2000, 2, entry(U8, None, None))
        .var(0x2001, entry(U8, unsigned(8), unsigned(9)));
    let all = PlanOptions { scope: Scope::All, ..PlanOptions::default() };
    let expected = [download(0x2000, 1, &[7]), download(0x2001, 0, &[9])];
    assert_eq!(node.configuration(&all).0, expected);
    // a configured count is written: it is requested
    let node = node.sub(0x2000, 0, entry(U8, unsigned(2), unsigned(1)));
    assert_eq!(node.downloads()[0], download(0x2000, 0, &[1]));
}

#[test]
fn compactly_stored_entries_are_planned_like_described_ones() {
    let compact = Compact { count: 3, values: vec![(2, Value::Unsigned(9))], ..Compact::default() };
    let mut object = Object { main: entry(U8, unsigned(7), None), ..Object::default() };
    object.main.object_type = Some(ObjectType::Array);
    object.compact = Some(Box::new(compact));
    let mut node = Node::new(1).var(0x2001, entry(U8, unsigned(8), unsigned(8)));
    node.0.objects.insert(0x2000, object);
    let all = PlanOptions { scope: Scope::All, ..PlanOptions::default() };
    let elements = [(1, 7), (2, 9), (3, 7)].map(|(sub, value)| download(0x2000, sub, &[value]));
    assert_eq!(node.configuration(&all).0, [&elements[..], &[download(0x2001, 0, &[8])]].concat());
    assert_eq!(node.downloads(), elements[1..2]);

    // an invalid text is named, in every entry
    let compact = node.0.objects.get_mut(&0x2000).and_then(|object| object.compact.as_mut()).unwrap();
    compact.values.clear();
    compact.invalid_values.push(Field::Item(3), "many", Reason::NotANumber);
    let error = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap_err();
    assert_eq!(error, ConciseDcf::plan(&node.0.expanded(), &PlanOptions::default()).unwrap_err());
    let kind = ProblemKind::Unreadable("many".into());
    assert_eq!(error, PlanError::Problems(vec![Problem { place: Place::entry(0x2000, 3), kind }]));
}

#[test]
fn every_entry_that_needs_the_node_id_is_named() {
    let mut node = Node::new(1)
        .pdo(0x1400, 0x200, unsigned(0x186), &[], &[])
        .pdo(0x1800, 0x180, Some(Value::NodeId(0x280)), &[], &[])
        .var(0x2000, entry(U16, unsigned(0), Some(Value::NodeId(5))))
        .var(0x2001, entry(U16, Some(Value::NodeId(5)), Some(Value::NodeId(5))));
    node.0.commissioning = None;
    let error = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap_err();
    assert_eq!(error.to_string(), "these values need the node-ID: `0x1400sub1`, `0x1800sub1`, `0x2000`");
    assert!(error.help().unwrap().contains("--node-id"));
    let with_node = PlanOptions { node_id: Some(3), ..PlanOptions::default() };
    assert_eq!(node.configuration(&with_node).0[0], download(0x2000, 0, &[8, 0]));
    let wrong = PlanOptions { node_id: Some(128), ..PlanOptions::default() };
    assert_eq!(ConciseDcf::plan(&node.0, &wrong), Err(PlanError::NodeId(128)));
}

#[test]
fn every_value_that_does_not_fit_is_named() {
    let limited = |value| Entry {
        low_limit: Some(Value::Signed(-5)),
        high_limit: Some(Value::Signed(5)),
        ..entry(DataType::INTEGER8, Some(Value::Signed(0)), Some(Value::Signed(value)))
    };
    let mut unreadable = entry(U8, unsigned(1), None);
    unreadable.invalid_values.push(Field::ParameterValue, "0x1G", Reason::NotANumber);
    let mut node = Node::new(127)
        .var(0x2000, limited(-6))
        .var(0x2001, limited(6))
        .var(0x2002, limited(5))
        .var(0x2003, entry(U8, unsigned(0), unsigned(256)))
        .var(0x2004, unreadable)
        .var(0x2005, entry(U8, unsigned(0), Some(Value::NodeId(200))))
        .var(0x2006, entry(DataType(0x60), None, Some(Value::Raw("x".into()))));
    // only what is written must fit
    node = node.var(0x2007, entry(U8, unsigned(300), None));
    let error = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap_err();
    insta::assert_snapshot!(error.to_string(), @r"
    `0x2000`: the value `-6` is below the low limit `-5`
    `0x2001`: the value `6` is above the high limit `5`
    `0x2003`: the value `256` does not fit UNSIGNED8
    `0x2004`: the string `0x1G` is not valid for its data type
    `0x2005`: the value `$NODEID+0xC8` does not fit UNSIGNED8
    `0x2006`: the bytes of `x` are unknown because the data type 0060h is
    ");
    let PlanError::Problems(problems) = error else { panic!("{error}") };
    assert!(problems.iter().all(|problem| !matches!(problem.kind, ProblemKind::NoCobId)));
}

#[test]
fn a_pdo_without_known_identifier_cannot_be_switched_off() {
    let node = Node::new(1).sub(0x1800, 1, entry(U32, None, None)).sub(
        0x1800,
        5,
        entry(U16, unsigned(0), unsigned(100)),
    );
    let error = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "`0x1800sub1`: a change requires that the PDO is not valid, but its COB-ID is unknown"
    );
    // where sub-index 1 cannot be written, there is nothing to switch
    let fixed = Entry { access: Some(Access::Const), ..entry(U32, None, None) };
    let node = node.sub(0x1800, 1, fixed);
    assert_eq!(node.downloads(), [download(0x1800, 5, &[100, 0])]);
}

#[test]
fn files_are_read_by_the_caller() {
    let mut domain = entry(DataType::DOMAIN, None, None);
    domain.object_type = Some(ObjectType::Domain);
    domain.configured_mut().download_file = Some("routes.bin".into());
    let node = Node::new(1).var(0x2101, domain).var(0x2100, entry(U8, unsigned(0), unsigned(1)));
    let plan = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap();
    let names: Vec<&str> = plan.files().map(|file| &*file.name).collect();
    assert_eq!(names, ["routes.bin"]);
    let refused = plan.clone().into_concise(|file| Err(file.name.clone()));
    assert_eq!(refused, Err("routes.bin".into()));
    let configuration = plan.into_concise(|_| Ok::<_, ()>(vec![1, 2, 3])).unwrap();
    let expected = vec![download(0x2100, 0, &[1]), download(0x2101, 0, &[1, 2, 3])];
    assert_eq!(configuration, ConciseDcf(expected));
}

#[test]
fn types_of_the_device_itself_have_a_length() {
    let node = Node::new(1)
        .var(0x60, Entry { object_type: Some(ObjectType::DefType), ..entry(U32, unsigned(16), None) })
        .sub(0x61, 1, entry(U16, unsigned(0x0003), None))
        .var(0x2000, entry(DataType(0x60), Some(Value::Raw("50".into())), Some(Value::Raw("0x1FF".into()))))
        .var(0x2001, entry(DataType(0x61), Some(Value::Raw("50".into())), Some(Value::Raw("-2".into()))));
    let expected = [download(0x2000, 0, &[0xFF, 1]), download(0x2001, 0, &[0xFE, 0xFF])];
    assert_eq!(node.downloads(), expected);
}

fn explicit(when: Moment, index: u16, number: u64) -> ExplicitDownload {
    ExplicitDownload { when, index, sub: 0, value: Value::Unsigned(number) }
}

#[test]
fn explicit_downloads_surround_the_values() {
    let mut node = Node::new(5)
        .var(0x1017, entry(U16, unsigned(0), unsigned(250)))
        .var(0x6040, entry(U16, unsigned(6), None));
    node.0.downloads = vec![
        explicit(Moment::After, 0x6040, 6),
        explicit(Moment::Before, 0x6040, 0x80),
        explicit(Moment::After, 0x6040, 7),
    ];
    let expected = [
        download(0x6040, 0, &[0x80, 0]),
        download(0x1017, 0, &[250, 0]),
        download(0x6040, 0, &[6, 0]),
        download(0x6040, 0, &[7, 0]),
    ];
    assert_eq!(node.downloads(), expected);
    let only = PlanOptions { only: Some([0x1017].into()), ..PlanOptions::default() };
    assert_eq!(node.configuration(&only).0, [download(0x1017, 0, &[250, 0])]);
    node.0.downloads = vec![explicit(Moment::After, 0x6040, 0x1_0000), explicit(Moment::After, 0x7000, 1)];
    let error = ConciseDcf::plan(&node.0, &PlanOptions::default()).unwrap_err().to_string();
    assert_eq!(error.lines().count(), 2, "{error}");
}

/// The complete configuration of PDOs has unchanged ones too; other entries only when they changed.
#[test]
fn complete_pdos() {
    let node = Node::new(5)
        .var(0x1017, entry(U16, unsigned(0), unsigned(250)))
        .var(0x2000, entry(U16, unsigned(7), None))
        .pdo(0x1800, 0x180, None, &[0x6000_0108], &[]);
    let expected = [
        download(0x1017, 0, &[250, 0]),
        download(0x1800, 1, &[0x85, 1, 0, 0x80]),
        download(0x1800, 2, &[255]),
        download(0x1A00, 0, &[0]),
        download(0x1A00, 1, &[8, 1, 0, 0x60]),
        download(0x1A00, 0, &[1]),
        download(0x1800, 1, &[0x85, 1, 0, 0]),
    ];
    let pdos = PlanOptions { scope: Scope::Pdos, ..PlanOptions::default() };
    assert_eq!(node.configuration(&pdos).0, expected);
}

/// The file that dcfgen writes for a drive: services, PDOs, all others, each PDO with its new CAN-ID.
#[test]
fn the_order_of_dcfgen() {
    let mapping = |node: Node, index, objects: [(u64, Option<u64>); 2], counts: (u64, u64)| {
        let changed =
            |(default, value): (u64, Option<u64>)| entry(U32, unsigned(default), value.map(Value::Unsigned));
        node.sub(index, 0, entry(U8, unsigned(counts.0), unsigned(counts.1)))
            .sub(index, 1, changed(objects[0]))
            .sub(index, 2, changed(objects[1]))
    };
    let per_node = |offset| Some(Value::NodeId(offset));
    let mut node = Node::new(5)
        .var(0x100C, entry(U16, unsigned(0), unsigned(100)))
        .var(0x1012, entry(U32, unsigned(0x100), unsigned(0x8000_0100)))
        .sub(0x1016, 1, entry(U32, unsigned(0), unsigned(0x0001_05DC)))
        .var(0x1017, entry(U16, unsigned(0), unsigned(200)))
        .sub(0x1029, 1, entry(U8, unsigned(0), unsigned(2)))
        .sub(0x1400, 1, entry(U32, per_node(0x200), None))
        .sub(0x1400, 2, entry(U8, unsigned(255), unsigned(1)))
        .sub(0x1401, 1, entry(U32, per_node(0x300), unsigned(0x8000_0305)))
        .sub(0x1402, 1, entry(U32, unsigned(0x8000_0000), unsigned(0x405)))
        .sub(0x1800, 1, entry(U32, per_node(0x4000_0180), None))
        .sub(0x1800, 2, entry(U8, unsigned(255), unsigned(1)))
        .sub(0x1800, 3, entry(U16, unsigned(0), unsigned(10)))
        .sub(0x1800, 5, entry(U16, unsigned(0), unsigned(100)))
        .sub(0x1800, 6, entry(U8, unsigned(0), unsigned(3)))
        .sub(0x1801, 1, entry(U32, per_node(0x4000_0280), unsigned(0x8000_0285)))
        .sub(0x1804, 1, entry(U32, unsigned(0xC000_0000), unsigned(0x680)))
        .var(0x6040, entry(U16, None, None))
        .var(0x6081, entry(U32, unsigned(1000), None));
    node = mapping(node, 0x1600, [(0x6040_0010, None), (0, Some(0x607A_0020))], (1, 2));
    node = mapping(node, 0x1A00, [(0x6041_0010, None), (0, Some(0x6064_0020))], (1, 2));
    node = mapping(node, 0x1A04, [(0, Some(0x6041_0010)), (0, None)], (0, 1));
    node.0.downloads = [(0x6081, 1000), (0x6040, 6), (0x6040, 7)]
        .map(|(index, value)| explicit(Moment::After, index, value))
        .into();
    let expected = "2200000016100104000000DC050100121000040000000001008017100002000000C8000C1000020000006400291001010000000200140104000000050200800014020100000001001600010000000000160104000000100040600016020400000020007A600016000100000002001401040000\
        000502000001140104000000050300800214010400000005040080021401040000000504000000180104000000850100C00018020100000001001803020000000A000018050200000064000018060100000003001A000100000000001A010400000010004160001A020400000020006460001A\
        000100000002001801040000008501004001180104000000850200800418010400000080060080041A000100000000041A010400000010004160041A000100000001041801040000008006000081600004000000E8030000406000020000000600406000020000000700";
    let dcfgen = PlanOptions { order: Order::Dcfgen, ..PlanOptions::default() };
    assert_eq!(node.stream(&dcfgen), expected);
}
