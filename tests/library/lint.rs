//! What rules share, seen in their findings: severities, sets of indexes, lists with more members, checksums, and parts that move.

use objdict::diagnostic::{Applicability, Diagnostic, Findings, MAX_PER_RULE, RuleInfo, Selection, Severity};
use objdict::format::{self, Description, Format};
use objdict::lint::changes::compare;
use objdict::lint::{Level, Options, Severities};
use objdict::model::{Device, ObjectList};
use objdict::source::{SourceFile, SourceOptions, Span};

use crate::support;

static FIRST: RuleInfo = RuleInfo::bare("test/first", Severity::Note);
static SECOND: RuleInfo = RuleInfo::bare("test/second", Severity::Error);

fn applied(severities: &Severities) -> Vec<(&'static str, Severity)> {
    let mut findings = Findings::new();
    findings.push(Diagnostic::new(&FIRST, Span::empty(0), "message"));
    findings.push(Diagnostic::new(&SECOND, Span::empty(0), "message"));
    severities.apply(findings).iter().map(|finding| (finding.rule.name(), finding.severity)).collect()
}

#[test]
fn what_is_set_later_counts_more() {
    let mut severities = Severities::default();
    assert_eq!(applied(&severities), [("first", Severity::Note), ("second", Severity::Error)]);
    severities.set(Selection::Group("test"), Level::At(Severity::Warning));
    severities.set(Selection::Rule(&FIRST), Level::Off);
    assert_eq!(applied(&severities), [("second", Severity::Warning)]);
    severities.set(Selection::Group("test"), Level::At(Severity::Note));
    assert_eq!(applied(&severities), [("first", Severity::Note), ("second", Severity::Note)]);
}

#[test]
fn a_rule_that_is_off_is_not_counted_either() {
    let mut findings = Findings::new();
    for _ in 0..3 * MAX_PER_RULE {
        findings.push(Diagnostic::new(&FIRST, Span::empty(0), "message"));
    }
    let mut severities = Severities::default();
    severities.set(Selection::Rule(&FIRST), Level::Off);
    assert_eq!(severities.apply(findings).omitted().count(), 0);
}

fn read(text: String) -> Description {
    format::read(SourceFile::from_text("a.eds", text), Format::Eds)
}

/// A small device whose optional objects are listed so, beside 1018h, and are described.
fn with_list(listed: &[u16], described: &[u16]) -> Description {
    let text = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    let device = read(text.clone()).into_device();
    let before = device.lists.get(ObjectList::Optional).to_vec();
    let start = text.find("[OptionalObjects]").unwrap();
    let end = start + text[start..].find("\r\n\r\n").unwrap();
    let members: Vec<u16> = before.iter().copied().filter(|index| !described.contains(index)).collect();
    let members = [&members[..], listed].concat();
    let items: String =
        (1..).zip(&members).map(|(number, index)| format!("\r\n{number}=0x{index:04X}")).collect();
    let list = format!("[OptionalObjects]\r\nSupportedObjects={}{items}", members.len());
    let objects: String = described
        .iter()
        .map(|index| {
            format!(
                "\r\n[{index:04X}]\r\nParameterName=Object {index:04X}\r\nObjectType=0x7\r\nDataType=0x0007\r\n\
                 AccessType=rw\r\nDefaultValue=1\r\nPDOMapping=0\r\n"
            )
        })
        .collect();
    read(format!("{}{list}{}{objects}", &text[..start], &text[end..]))
}

fn messages(description: &Description, rule: &str) -> Vec<String> {
    let findings = objdict::check(description);
    let of_rule = findings.iter().filter(|finding| finding.rule.id == rule);
    of_rule.map(|finding| finding.message.to_string()).collect()
}

/// Indexes at the edges of the words and pages of a set of indexes.
#[test]
fn the_edges_of_a_set_are_in_it() {
    const EDGES: [u16; 6] = [0x6000, 0x603F, 0x6040, 0x60FF, 0x6100, 0xFFFF];
    const NEIGHBOURS: [u16; 4] = [0x6001, 0x6041, 0x6101, 0xFFFE];
    let once = with_list(&EDGES, &EDGES);
    assert_eq!(messages(&once, "cia306/object-listed-twice"), [""; 0]);
    assert_eq!(messages(&once, "cia306/object-not-listed"), [""; 0]);
    let twice = with_list(&[EDGES, EDGES].concat(), &EDGES);
    let expected = EDGES.map(|index| format!("{index:04X}h is listed twice in `[OptionalObjects]`"));
    assert_eq!(messages(&twice, "cia306/object-listed-twice"), expected);
    let unlisted = with_list(&EDGES, &[&EDGES[..], &NEIGHBOURS].concat());
    let expected = NEIGHBOURS.map(|index| format!("{index:04X}h is described, but not in any object list"));
    assert_eq!(messages(&unlisted, "cia306/object-not-listed"), expected);
}

#[test]
fn members_come_where_they_belong() {
    let fixed = |listed: &[u16]| {
        let description = with_list(listed, &[0x6001, 0x6003, 0x6005]);
        // alone, because another rule sorts lists
        let mut options = Options::default();
        options.severities.select(objdict::registry::select("cia306/object-not-listed").unwrap());
        let check = |description: &Description| objdict::check_with(description, &options);
        let fixed = objdict::fix(description, Applicability::Safe, check);
        let mut members = fixed.description.device().lists.get(ObjectList::Optional).to_vec();
        members.retain(|index| *index >= 0x6000);
        members
    };
    assert_eq!(fixed(&[0x6001, 0x6005]), [0x6001, 0x6003, 0x6005]);
    assert_eq!(fixed(&[0x6005, 0x6001]), [0x6005, 0x6001, 0x6003]);
}

/// CRC-16: polynomial 1021h, initial value 0, most significant bit first.
fn crc(bytes: &[u8]) -> u16 {
    let mut crc = 0_u16;
    for bit in bytes.iter().flat_map(|byte| (0..8).rev().map(move |at| byte >> at & 1 == 1)) {
        let is_set = (crc & 0x8000 != 0) != bit;
        crc = crc << 1 ^ if is_set { 0x1021 } else { 0 };
    }
    crc
}

#[test]
fn the_checksum_of_the_digits() {
    // the check value for this polynomial and initial value in CRC catalogues
    assert_eq!(crc(b"123456789"), 0x31C3);
    // direction, refresh time, validation time, COB-IDs, and two mapped objects of SRDO 1
    let parameters = [
        &[1, 25, 0, 20][..],
        &[0x01, 0x01, 0, 0, 0x02, 0x01, 0, 0],
        &[2, 1, 0x08, 0x01, 0x00, 0x61, 2, 0x08, 0x01, 0x01, 0x61],
    ];
    let folder = support::fixtures().join("rules/cia304/wrong-checksum");
    let open = |name: &str| format::open(&folder.join(name), &SourceOptions::default()).unwrap();
    assert_eq!(messages(&open("good.eds"), "cia304/wrong-checksum"), [""; 0]);
    let [message] = messages(&open("bad.eds"), "cia304/wrong-checksum").try_into().unwrap();
    let expected = format!("its parameters yield 0x{:04X}", crc(&parameters.concat()));
    assert!(message.ends_with(&expected), "{message}, {expected}");
}

/// A record with these sub-indexes and names.
fn record(names: &[(u8, &str)]) -> Device {
    let highest = names.last().unwrap().0;
    let mut text = format!(
        "[2000]\nParameterName=Axis\nObjectType=9\nSubNumber={}\n[2000sub0]\nParameterName=n\nDataType=5\nAccessType=const\n\
         DefaultValue={highest}\n",
        names.len() + 1
    );
    for (sub, name) in names {
        text +=
            &format!("[2000sub{sub:X}]\nParameterName={name}\nDataType=7\nAccessType=rw\nDefaultValue=1\n");
    }
    read(text).into_device()
}

/// The changes of sub-indexes, but of the number of them.
fn changes(old: &[(u8, &str)], new: &[(u8, &str)]) -> Vec<String> {
    let changes = compare(&record(old), &record(new));
    let of_subs = changes.iter().filter(|change| change.sub.is_some_and(|sub| sub > 0));
    of_subs.map(|change| format!("{} {}", change.rule.info.id, change.message)).collect()
}

#[test]
fn parts_move_behind_an_inserted_one() {
    let found = changes(&[(1, "Gain"), (2, "Offset")], &[(1, "Mode"), (2, "Gain"), (3, "Offset")]);
    let expected = [
        "change/entry-moved `Gain` moves from sub-index 1 to 2",
        "change/entry-moved `Offset` moves from sub-index 2 to 3",
        "change/entry-added sub-index 1 `Mode` is added",
    ];
    assert_eq!(found, expected);
}

#[test]
fn another_name_is_no_move() {
    let found = changes(&[(1, "Gain"), (2, "Offset")], &[(1, "GAIN"), (2, "Shift")]);
    let rules: Vec<_> = found.iter().filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(rules, ["change/name-respelled", "change/entry-renamed"], "{found:?}");
}

#[test]
fn a_name_that_occurs_twice_does_not_move() {
    let found = changes(&[(1, "Gain"), (2, "Gain")], &[(2, "Gain"), (3, "Gain")]);
    let expected = [
        "change/entry-removed sub-index 1 `Gain` is removed",
        "change/entry-added sub-index 3 `Gain` is added",
    ];
    assert_eq!(found, expected);
}

/// The messages of a rule with their helps.
fn helps(text: &str, rule: &str) -> Vec<String> {
    let findings = objdict::check(&read(text.to_owned()));
    let of_rule = findings.iter().filter(|finding| finding.rule.id == rule);
    of_rule.map(|finding| format!("{}: {}", finding.message, finding.help.as_ref().unwrap())).collect()
}

fn minimal(objects: &str) -> String {
    let text = std::fs::read_to_string(support::fixtures().join("eds/minimal.eds")).unwrap();
    text.replace("\r\n", "\n") + "\n" + objects
}

/// The fixtures cannot have these cases, because another rule reports them too.
#[test]
fn helps_say_what_the_document_defines() {
    let sdo = "[1234]\nParameterName=Names\nObjectType=0x9\nSubNumber=1\n\n\
        [1234sub0]\nParameterName=Name\nDataType=0x0009\nAccessType=ro\n";
    let found = helps(&minimal(sdo), "cia301/incomplete-sdo-parameter");
    assert_eq!(
        found,
        ["1234h is in the range of SDO parameters, but its sub-index 0 is VISIBLE_STRING: \
          move the object to 2000h to 5FFFh"]
    );
    assert!(helps(&minimal(sdo), "cia301/gap-in-sdo-numbers").is_empty());
    let structure = "[1280]\nParameterName=Client\nObjectType=0x9\nSubNumber=4\n\n[1280sub2]\nParameterName=COB-ID\n\
        ObjectType=0x7\nDataType=0x0022\nAccessType=rw\n";
    let found = helps(&minimal(structure), "cia306/nested-structure");
    assert!(found.len() == 1 && found[0].ends_with(": write `DataType=0x0007`"), "{found:?}");
    let malformed = "[2000]\nParameterName=Levels\nObjectType=0x9\nSubNumber=2\n\n[2000sub0]\nParameterName=Number\n\
        DataType=0x0005\nAccessType=ro\nDefaultValue=1\n\n[2000sub1]\nParameterName=Level\nDataType=0x0005\n\
        AccessType=rw\n\n[2000subx]\nParameterName=Level\nDataType=0x0005\nAccessType=rw\n";
    let found = helps(&minimal(malformed), "cia306/sub-number-mismatch");
    assert_eq!(
        found,
        ["`SubNumber` is 2, but 3 sub-indexes are described: \
          correct the section name `[2000subx]`, then write `SubNumber=3`"]
    );
    let right = malformed.replacen("SubNumber=2", "SubNumber=3", 1);
    assert!(helps(&minimal(&right), "cia306/sub-number-mismatch").is_empty());
}

/// A number as `ParameterValue` is right for its node; in an EDS, the default counts.
#[test]
fn the_default_of_an_eds_needs_the_node_id() {
    let emcy = "[1014]\nParameterName=COB-ID EMCY\nDataType=0x0007\nAccessType=rw\nDefaultValue=$NODEID+0x80\n\
        ParameterValue=0x85\n";
    assert!(helps(&minimal(emcy), "cia301/fixed-node-id").is_empty());
    let wrong = emcy.replace("$NODEID+0x80", "0x85");
    assert_eq!(helps(&minimal(&wrong), "cia301/fixed-node-id").len(), 1);
}

/// An EDS with the ending of a DCF is renamed; a DCF without its node is completed.
#[test]
fn an_eds_named_as_a_dcf_keeps_its_sections() {
    let rules = |name: &str, text: &str| -> Vec<(&'static str, String)> {
        let description = format::read(SourceFile::from_text(name, text), Format::Dcf);
        let findings = objdict::check(&description);
        let of_node = findings.iter().filter(|finding| finding.rule.name().starts_with("missing-"));
        of_node.map(|finding| (finding.rule.name(), finding.help.as_ref().unwrap().to_string())).collect()
    };
    let found = rules("minimal.dcf", &minimal(""));
    assert!(found.len() == 1 && found[0].1.starts_with("rename the file"), "{found:?}");
    let configured = minimal("").replacen("[1017]\n", "[1017]\nParameterValue=500\n", 1);
    let found = rules("minimal.dcf", &configured);
    assert!(found.len() == 2 && found.iter().all(|(_, help)| !help.starts_with("rename")), "{found:?}");
}

/// Who asks about one of two objects that are compared gets what is found, whichever has the place of the finding.
#[test]
fn a_finding_belongs_to_both_objects_that_are_compared() {
    let object = |index: &str, count: u8| {
        let subs: String = (1..=count)
            .map(|sub| format!("[{index}sub{sub}]\nParameterName=p{sub}\nDataType=0x0005\nAccessType=rw\n"))
            .collect();
        format!(
            "[{index}]\nParameterName=Programs\nObjectType=0x8\nSubNumber={}\n[{index}sub0]\nParameterName=n\nDataType=0x0005\n\
             AccessType=const\nDefaultValue={count}\n{subs}",
            count + 1
        )
    };
    let text = minimal(&(object("1F50", 2) + &object("1F51", 1)));
    let device = format::read(SourceFile::from_text("a.eds", text), Format::Eds).into_device();
    for (asked, is_found) in [(0x1F50, true), (0x1F51, true), (0x1017, false)] {
        let is_wanted = |rule: &RuleInfo| rule.id == "cia302/different-program-count";
        let found =
            objdict::lint::check_some(&device, &Options::default(), &is_wanted, &|index| index == asked);
        assert_eq!(found.len() == 1, is_found, "{asked:04X}");
    }
}
