//! JSON: every device reads back equal, and errors in a document have their place.

use objdict::download::{ConciseDcf, Download};
use objdict::format;
use objdict::format::json::{self, DocumentKind, JsonError};
use objdict::model::Device;
use objdict::source::SourceOptions;
use proptest::prelude::*;

use crate::support;
use crate::support::devices::{Texts, device};

#[test]
fn every_good_device_reads_back_equal() {
    for path in support::good_devices() {
        let device = format::open(&path, &SourceOptions::default()).unwrap().into_device();
        let text = json::write_device(&device);
        assert_eq!(json::read_device(&text).as_ref(), Ok(&device), "{}", path.display());
    }
}

#[test]
fn every_damaged_device_reads_back_equal() {
    for path in support::devices_of_all_folders() {
        let device = format::open(&path, &SourceOptions::default()).unwrap().into_device();
        let text = json::write_device(&device);
        assert_eq!(json::read_device(&text).as_ref(), Ok(&device), "{}", path.display());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn every_device_reads_back_equal(device in device(Texts::Any)) {
        let text = json::write_device(&device);
        prop_assert_eq!(json::read_device(&text), Ok(device));
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in any::<String>(), cut in any::<prop::sample::Index>()) {
        let _ = json::read_device(&text);
        let whole = json::write_device(&small_device());
        // without the last line feed it is whole
        let mut cut = cut.index(whole.trim_end().len());
        while !whole.is_char_boundary(cut) {
            cut -= 1;
        }
        prop_assert!(json::read_device(&whole[..cut]).is_err());
    }
}

fn small_device() -> Device {
    let text = "[1000]\r\nParameterName=Device type\r\nDataType=7\r\nAccessType=ro\r\nDefaultValue=$NODEID+0x191\r\n\
        [2000]\r\nParameterName=Gain\r\nObjectType=8\r\nDataType=8\r\nCompactSubObj=2\r\nDefaultValue=1.5\r\n\
        [2000Name]\r\nNrOfEntries=1\r\n2=Second\r\n\
        [60]\r\nDataType=0x60\r\nLowLimit=7\r\n";
    let source = objdict::source::SourceFile::from_text("a.eds", text);
    format::read(source, format::Format::Eds).into_device()
}

#[test]
fn the_names_are_stable() {
    insta::assert_snapshot!(json::write_device(&small_device()));
    let configuration = ConciseDcf(vec![Download::new(0x1017, 0, [0xFA, 0])]);
    insta::assert_snapshot!(json::write_configuration(&configuration));
}

#[test]
fn a_document_says_what_it_holds() {
    let configuration = ConciseDcf(vec![Download::new(0x1017, 0, [0xFA, 0]), Download::new(0x2000, 1, [])]);
    let text = json::write_configuration(&configuration);
    assert_eq!(json::kind(&text), Ok(DocumentKind::ConciseDcf));
    assert_eq!(json::read_configuration(&text), Ok(configuration));
    let error = json::read_device(&text).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 1, column 1: the document contains a concise DCF, not a device description"
    );
}

/// The error of the document with this device, its line and its column.
fn error(device: &str) -> String {
    let text = format!("{{\n\"version\": 1,\n\"kind\": \"device\",\n\"device\": {device}\n}}");
    json::read_device(&text).unwrap_err().to_string()
}

#[test]
fn errors_have_a_place() {
    let errors = [
        json::read_device("{\"version\": 2, \"kind\": \"device\", \"device\": {}}").unwrap_err().to_string(),
        json::read_device("{\"kind\": \"device\", \"device\": {}}").unwrap_err().to_string(),
        json::read_device("{\"version\": 1, \"kind\": \"drawing\"}").unwrap_err().to_string(),
        json::read_device("[1]").unwrap_err().to_string(),
        json::read_device("{\"version\": 1,").unwrap_err().to_string(),
        error("{\"objcets\": {}}"),
        error("{\"objects\": {\"0x1000\": {\n\"nmae\": \"x\"}}}"),
        error("{\"objects\": {\"0x1000\": {},\n\"0x1000\": {}}}"),
        error("{\"objects\": {\"1000\": {}}}"),
        error(
            "{\"objects\": {\"0x1000\": {\"data_type\": \"UNSIGNED8\",\n\"default\": {\"unsigned\": 256}}}}",
        ),
        error("{\"objects\": {\"0x1000\": {\"data_type\": \"UNSIGNED8\",\n\"default\": {\"text\": \"1\"}}}}"),
        error("{\"objects\": {\"0x1000\": {\"subs\": {\"0x01\": {},\n\"0x01\": {}}}}}"),
        error("{\"objects\": {\"0x1000\": {\"compact\": {\"count\": 0}}}}"),
        error("{\"objects\": {\"0x1000\": {\"compact\": {}}}}"),
        error("{\"objects\": {\"0x1000\": {\"compact\": {\"count\": 2, \"names\": {\"0x03\": \"c\"}}}}}"),
        error("{\"file_info\": {\"creation_date\": \"2023-02-29\"}}"),
        error("{\"lists\": {\"mandatory\": [\"0x1000\", 4097]}}"),
    ]
    .join("\n");
    insta::assert_snapshot!(errors);
}

#[test]
fn deep_nesting_is_refused() {
    let deep = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(json::read_device(&deep).is_err());
    assert!(json::read_device(&format!("{{\"version\": 1, \"kind\": {deep}}}")).is_err());
    let JsonError { line, message, .. } =
        json::read_device(&format!("{{\"version\": 1, \"kind\": \"device\",\n\"device\": {deep}}}"))
            .unwrap_err();
    assert_eq!((line, message.as_str()), (2, "expected value"));
}

#[test]
fn a_real_number_beyond_its_type_is_an_error() {
    let path = support::fixtures().join("eds/all-types.eds");
    let text = json::write_device(format::open(&path, &SourceOptions::default()).unwrap().device());
    for number in ["1e39", "-1e39"] {
        let error = json::read_device(&text.replacen("3.4028235e38", number, 1)).unwrap_err();
        assert!(error.message.contains("is not a REAL number"), "{error}");
    }
}
