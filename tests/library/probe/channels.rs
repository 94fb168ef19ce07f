//! What a log shows besides the transfers of the default channel: resets of the node, and its other SDO channels.

use std::collections::BTreeSet;

use objdict::format::log::{LogOptions, LogReader};
use objdict::format::{self, Format};
use objdict::model::Device;
use objdict::probe::{Conversation, judge};
use objdict::source::{SourceFile, SourceOptions};

use super::{NODE, device, found};
use crate::support;

/// What is found in the frames of a log, one a line: `605#40171000…`.
fn found_in(device: &Device, frames: &str) -> BTreeSet<(&'static str, u16, u8)> {
    let log: String =
        frames.split_whitespace().map(|frame| format!("(0000000000.000000) can0 {frame}\n")).collect();
    let mut reader = LogReader::new(log.as_bytes(), LogOptions::default());
    let mut conversation = Conversation::with(device, NODE);
    while let Some(frame) = reader.next_frame().unwrap() {
        conversation.take(&frame);
    }
    assert_eq!(reader.bad_count(), 0);
    found(&judge(device, NODE, &conversation.into_exchanges()))
}

/// 2003h sub-index 1 is written as 250, and is accepted.
const WRITTEN: &str = "605#2B032001FA000000 585#6003200100000000";
/// It is read: 800, which is the default.
const DEFAULT: &str = "605#4003200100000000 585#4B03200120030000";
/// It is read: 250.
const KEPT: &str = "605#4003200100000000 585#4B032001FA000000";
/// All parameters are saved.
const SAVED: &str = "605#2310100173617665 585#6010100100000000";
/// All defaults are restored with the next reset.
const RESTORED: &str = "605#231110016C6F6164 585#6011100100000000";
const OTHER_THAN_WRITTEN: (&str, u16, u8) = ("probe/other-than-written", 0x2003, 1);
const OTHER_DEFAULT: (&str, u16, u8) = ("probe/other-default", 0x2003, 1);

const NOTHING: [(&str, u16, u8); 0] = [];

/// What is found when the value is written, something happens, and it is read.
fn found_after(between: &str, read: &str) -> Vec<(&'static str, u16, u8)> {
    let frames = format!("{WRITTEN} {between} {read}");
    found_in(&device("eds/drive-402.eds"), &frames).into_iter().collect()
}

#[test]
fn a_reset_gives_back_the_values_from_before() {
    for reset in ["000#8105", "000#8100", "705#00", "000#8105 705#00", "000#8205 000#8105 705#00"] {
        assert_eq!(found_after(reset, DEFAULT), NOTHING, "{reset}");
        assert_eq!(found_after(reset, KEPT), [OTHER_DEFAULT], "{reset}");
    }
    // no reset, of another node, or of the communication objects alone
    for other in ["", "000#8106", "000#0105", "000#8005", "705#7F", "706#00", "000#8205 705#00"] {
        assert_eq!(found_after(other, KEPT), NOTHING, "{other}");
        assert_eq!(found_after(other, DEFAULT), [OTHER_THAN_WRITTEN], "{other}");
    }
}

#[test]
fn a_late_response_does_not_answer_the_next_request() {
    let device = device("eds/drive-402.eds");
    let aborted = "605#4003200100000000 605#8003200100000405";
    let found = |late: &str| {
        let written = format!("605#2B032001FA000000 {late} 585#6003200100000000");
        found_in(&device, &format!("{aborted} {written} {KEPT}"))
    };
    let punctual = found("");
    assert_eq!(found("585#4B03200120030000"), punctual, "a value");
    assert_eq!(found("585#4103200110000000 585#0000000000000000"), punctual, "a value in segments");
}

#[test]
fn a_reset_of_the_communication_gives_back_its_values() {
    let device = device("eds/drive-402.eds");
    let written = "605#2B171000FA000000 585#6017100000000000";
    let kept = "605#4017100000000000 585#4B171000FA000000";
    let found = |between: &str| Vec::from_iter(found_in(&device, &format!("{written} {between} {kept}")));
    assert_eq!(found(""), NOTHING);
    assert_eq!(found("000#8205 705#00"), [("probe/other-default", 0x1017, 0)]);
}

/// Which parameters are saved is the device's business, so both values are right.
#[test]
fn saved_values_may_outlive_a_reset() {
    for read in [KEPT, DEFAULT] {
        assert_eq!(found_after(&format!("{SAVED} 000#8105 705#00"), read), NOTHING);
    }
    let restored = format!("{SAVED} {RESTORED} 000#8105 705#00");
    assert_eq!(found_after(&restored, DEFAULT), NOTHING);
    assert_eq!(found_after(&restored, KEPT), [OTHER_DEFAULT]);
    // a device that refuses to save saves nothing
    let refused = "605#2310100173617665 585#8010100120000008 000#8105 705#00";
    assert_eq!(found_after(refused, KEPT), [OTHER_DEFAULT]);
}

/// A description with a second server, and a third one that is switched off.
fn with_servers() -> Device {
    let path = support::fixtures().join("eds/drive-402.eds");
    let mut text = std::fs::read_to_string(path).unwrap();
    for (index, request, response) in [
        ("1201", "0x640", "0x20001234"),
        ("1202", "0x80000641", "0x5C1"),
        ("1203", "$NODEID+0x650", "$NODEID+0x5D0"),
    ] {
        text += &format!("\n[{index}]\nParameterName=Server\nObjectType=9\nSubNumber=3\n");
        for (sub, data_type, value) in [(0, 5, "2"), (1, 7, request), (2, 7, response)] {
            text += &format!(
                "[{index}sub{sub}]\nParameterName=Of it\nDataType={data_type}\nAccessType=rw\nDefaultValue={value}\n"
            );
        }
    }
    let source = SourceFile::from_bytes("servers.eds", text.into_bytes(), &SourceOptions::default()).unwrap();
    format::read(source, Format::Eds).device().clone()
}

/// Two clients may ask at the same time; bit 29 of a COB-ID says that the CAN-ID has 29 bits.
#[test]
fn each_server_of_the_description_is_a_channel() {
    let device = with_servers();
    let wrong = BTreeSet::from([("probe/other-default", 0x1017, 0)]);
    let answer = "4B171000FA000000";
    let both = format!("640#4017100000000000 605#4003200100000000 00001234#{answer} 585#4B03200120030000");
    assert_eq!(found_in(&device, &both), wrong);
    assert_eq!(found_in(&device, &format!("655#4017100000000000 5D5#{answer}")), wrong);
    for others in ["640#4017100000000000 234#", "641#4017100000000000 5C1#", "655#4017100000000000 5D6#"] {
        let found = found_in(&device, &format!("{others}{answer}"));
        assert!(!found.contains(&("probe/other-default", 0x1017, 0)), "{others}: {found:?}");
    }
}
