//! Tables of objects as CSV are read as the objects that they were written from.

use objdict::document::{self, Form, Identifiers, Options, Subject};
use objdict::format::{self, object_table};
use objdict::model::{Device, PdoMapping, Value};
use objdict::source::SourceOptions;

use crate::support::{files_below, fixtures, good_devices};

fn table(device: &Device) -> String {
    let identifiers = Identifiers::default();
    let subject = Subject { device, file: "", format: "EDS", findings: None, identifiers: &identifiers };
    document::write(&subject, Form::Csv, &Options::default())
}

/// A device with the objects of a table, and what no table has: the facts of the file and the node.
fn restored(text: &str, device: &Device) -> Device {
    let Device { objects, lists, application, .. } = object_table::read(text).unwrap();
    Device { objects, lists, application, ..device.clone() }
}

#[test]
fn tables_come_back() {
    let of_xml = ["xdd", "xdc"].map(|folder| files_below(&fixtures().join(folder), &["xdd", "xdc"]));
    for path in good_devices().into_iter().chain(of_xml.concat()) {
        let description = format::open(&path, &SourceOptions::default()).unwrap();
        let device = description.device();
        let text = table(device);
        let back = table(&restored(&text, device));
        for (line, (left, right)) in text.lines().zip(back.lines()).enumerate() {
            assert_eq!(left, right, "{}, line {}", path.display(), line + 1);
        }
        assert_eq!(text, back);
        // as a German spreadsheet saves it: quoted cells may have its separator
        let cells = |line: &str| {
            let (mut is_quoted, mut cells) = (false, String::new());
            for character in line.chars() {
                is_quoted ^= character == '"';
                cells.push(if character == ',' && !is_quoted { ';' } else { character });
            }
            cells
        };
        let lines: Vec<String> = text.trim_start_matches('\u{FEFF}').lines().map(cells).collect();
        assert_eq!(table(&restored(&lines.join("\n"), device)), text, "{}", path.display());
    }
}

#[test]
fn a_table_of_people_has_few_columns() {
    let text = "index;sub;object_name;name;object_type;data_type;access;pdo;default;unit\r\n\
        0x2000;0x00;\"Speed; \"\"set\"\"\";\"Speed; \"\"set\"\"\";VAR;INTEGER16;rww;RPDO;-16;'-rpm\r\n\
        0x2001;0x00;Gains;Highest sub-index;ARRAY;UNSIGNED8;ro;;1;\r\n\
        0x2001;0x01;;Gain;;REAL32;rw;;0.5;\r\n\
        0x2002;;Mode;Mode;VAR;UNSIGNED8;rw;;3;\r\n";
    let device = object_table::read(text).unwrap();
    let speed = &device.objects[&0x2000].main;
    assert_eq!((&*speed.name, speed.pdo_mapping), ("Speed; \"set\"", Some(PdoMapping::Optional)));
    assert_eq!(speed.default, Some(Value::Signed(-16)));
    let unit = speed.parameter.as_ref().unwrap().unit.as_ref().unwrap();
    assert_eq!(unit.labels.name_in("en"), Some("-rpm"));
    assert_eq!(device.entry(0x2001, 1).unwrap().default, Some(Value::Real32(0.5)));
    assert_eq!(device.entry(0x2002, 0).unwrap().default, Some(Value::Unsigned(3)));
    assert_eq!(device.lists.manufacturer, Some(vec![0x2000, 0x2001, 0x2002]));
}

#[test]
fn faults_are_named_with_line_and_column() {
    const HEADINGS: &str =
        "index,sub,object_type,data_type,access,object_name,pdo,default,facts,bit_fields,colour\n";
    let known = HEADINGS.replace(",colour", "");
    for (row, fault) in [
        (
            "2000,0x00,VAR,UNSIGNED8,rw",
            "line 2, column `index`: expected at most 4 hex digits after `0x`: `2000`",
        ),
        (
            "0x2000,0x100,VAR,UNSIGNED8,rw",
            "line 2, column `sub`: expected at most 2 hex digits after `0x`: `0x100`",
        ),
        ("0x2000,0x00,VARIABLE,UNSIGNED8,rw", "line 2, column `object_type`: unknown word: `VARIABLE`"),
        ("0x2000,0x00,VAR,U8,rw", "line 2, column `data_type`: unknown word: `U8`"),
        ("0x2000,0x00,VAR,UNSIGNED8,r/w", "line 2, column `access`: unknown word: `r/w`"),
        (
            "0x2000,0x00,VAR,UNSIGNED8,ro,A,RPDO",
            "line 2, column `pdo`: the access type does not allow these PDOs: `RPDO`",
        ),
        ("0x2000,0x00,VAR,UNSIGNED8,rw,A,,300", "line 2, column `default`: no UNSIGNED8: `300`"),
        (
            "0x2000,0x00,VAR,UNSIGNED8,rw,A,,3,colour = red",
            "line 2, column `facts`: unknown field `colour = red`",
        ),
        (
            "0x2000,0x00,VAR,UNSIGNED8,rw,A,,3,,8–4: a",
            "line 2, column `bit_fields`: expected bits such as `3` or `4–7`",
        ),
        ("0x2000,0x00,VAR,UNSIGNED8,rw,A,,3,,,red", "line 2, column `red`: a cell without a heading"),
        (
            "0x2000,0x00,VAR,UNSIGNED8,rw,\"A\nB\"\n0x2000,0x00,VAR,UNSIGNED8,rw",
            "line 4, column `sub`: the entry is defined twice: `0x00`",
        ),
        (
            "0x2000,,ARRAY,UNSIGNED8,rw",
            "line 2, column `data_type`: the sub-index of the entry is missing: `UNSIGNED8`",
        ),
        (
            "0x2000,0x00,ARRAY,UNSIGNED8,rw\n0x2000,0x01,RECORD,UNSIGNED8,rw",
            "line 3, column `object_type`: differs from an earlier row of the object: `RECORD`",
        ),
    ] {
        let error = object_table::read(&format!("{known}{row}\n")).unwrap_err();
        assert!(error.starts_with(fault), "{error}\ninstead of {fault}");
    }
    let unknown = object_table::read(HEADINGS).unwrap_err();
    assert_eq!(unknown, "line 1, column `colour`: unknown or duplicate column");
    let missing = object_table::read("index,sub,object_type,data_type\n").unwrap_err();
    assert_eq!(missing, "line 1, column `access`: the column is missing");
    assert!(object_table::read("").is_err());
}

#[test]
fn damaged_tables_are_no_panic() {
    let description = format::open(&fixtures().join("xdd/press-402.xdd"), &SourceOptions::default()).unwrap();
    let text = table(description.device());
    let starts: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
    for &at in starts.iter().step_by(397) {
        let _ = object_table::read(&text[..at]);
        for insertion in ["\"", "\n", ",", ";", " = ", " / ", "–", "'=", "0x", "("] {
            let _ = object_table::read(&[&text[..at], insertion, &text[at..]].concat());
        }
    }
}
