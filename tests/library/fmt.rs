//! `objdict fmt`: order and spelling change, and nothing else. Every description of the fixtures is put in order, the malformed
//! ones before all.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use objdict::format::input::{Input, Reading};
use objdict::format::{self, Description, Format};
use objdict::source::{EditError, SourceFile, SourceOptions};

use crate::support;

fn folders(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        if path.is_dir() {
            folders(&path, files);
        } else if ["eds", "dcf", "xdd", "xdc", "nxdd"].contains(&ending) {
            files.push(path);
        }
    }
}

fn descriptions() -> impl Iterator<Item = Description> {
    let mut files = Vec::new();
    folders(&support::fixtures(), &mut files);
    assert!(files.len() > 200);
    files.into_iter().filter_map(|path| format::open(&path, &SourceOptions::default()).ok())
}

fn read(like: &Description, bytes: Vec<u8>) -> Description {
    let mut options = SourceOptions::default();
    options.encoding = Some(like.source().encoding());
    format::read(SourceFile::from_bytes(like.source().name(), bytes, &options).unwrap(), like.format())
}

/// What is not data, counted: comments, and what is no line of an EDS.
fn notes(description: &Description) -> BTreeMap<String, usize> {
    let mut notes = BTreeMap::new();
    let Some(document) = description.document() else {
        let text = description.source().text();
        for comment in objdict_xdd::xml::comments(text) {
            *notes.entry(comment.of(text).to_owned()).or_default() += 1;
        }
        return notes;
    };
    for line in document.lines() {
        use objdict_eds::ini::LineKind;
        if matches!(line.kind, LineKind::Comment | LineKind::Junk) {
            *notes.entry(line.span.of(document.text()).trim().to_owned()).or_default() += 1;
        }
    }
    notes
}

/// XML has to be well-formed for it.
fn can_be_arranged(description: &Description) -> bool {
    let is_sound =
        description.tree().is_none_or(|tree| tree.is_complete() && !tree.text().contains("<!DOCTYPE"));
    is_sound && !description.source().is_read_only()
}

#[test]
fn what_is_read_stays_the_same() {
    for description in descriptions() {
        let name = description.source().name();
        let bytes = description.arranged();
        if !can_be_arranged(&description) {
            assert!(bytes.is_err(), "{name}");
            continue;
        }
        let arranged = read(&description, bytes.unwrap());
        let sorted = |description: &Description| {
            let mut device = description.device().clone();
            device.extra.sort_by_key(|section| section.name().to_ascii_lowercase());
            device
        };
        assert_eq!(sorted(&arranged), sorted(&description), "{name}");
        for (note, count) in notes(&description) {
            assert!(notes(&arranged).get(&note) >= Some(&count), "{name}: `{note}` is lost");
        }
    }
}

#[test]
fn what_is_in_order_stays_as_it_is() {
    for description in descriptions().filter(can_be_arranged) {
        let once = description.arranged().unwrap();
        let twice = read(&description, once.clone()).arranged().unwrap();
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        assert_eq!(text(&once), text(&twice), "{}", description.source().name());
    }
}

fn arrange(text: &str) -> String {
    let description = format::read(SourceFile::from_text("test.eds", text), Format::Eds);
    String::from_utf8(description.arranged().unwrap()).unwrap()
}

/// A line feed of printers is junk to the reader of lines, and an empty line for everyone else.
#[test]
fn a_line_of_other_blanks_is_empty() {
    let once = arrange("[1000]\nDataType=7\n\u{B}\n[1001]\nDataType=5\n");
    assert_eq!(once, "[1000]\nDataType=0x0007\n\n[1001]\nDataType=0x0005\n");
    assert_eq!(arrange(&once), once);
}

#[test]
fn sections_take_their_comments_with_them() {
    let text = "; made by hand\n\n; of 2000h\n[2000] ; a remark\n; its type\ndatatype=7\n\
        PARAMETERNAME = Speed\n; behind\n\n[tools data]\nX y = 1\n\n; --- the file ---\n\n; of the file\n[fileinfo]\nFileName=test.eds\n\n; last";
    let expected = "; made by hand\n\n; --- the file ---\n\n; of the file\n[FileInfo]\nFileName=test.eds\n\n; of 2000h\n; a remark\n[2000]\nParameterName=Speed\n; its type\nDataType=0x0007\n; behind\n\n\
        [tools data]\nX y=1\n\n; last\n";
    assert_eq!(arrange(text), expected);
}

#[test]
fn values_are_spelled_alike_where_they_say_the_same() {
    let text = "[1A00]\nParameterName=x\nObjectType=7\nDataType=0X7\nAccessType=RW\n\
        DefaultValue= 0xab + $nodeid\nLowLimit=010\nObjFlags=0x0a\n\n[2000]\nParameterName=0xab\nDataType=9\n\
        DefaultValue=0xab\n";
    let expected = "[1A00]\nParameterName=x\nObjectType=0x7\nDataType=0x0007\nAccessType=rw\n\
        DefaultValue=$NODEID+0xAB\nLowLimit=010\nObjFlags=0x0A\n\n[2000]\nParameterName=0xab\nDataType=0x0009\n\
        DefaultValue=0xab\n";
    assert_eq!(arrange(text), expected);
}

/// One line without order becomes what the file was, with its comments at their places.
#[test]
fn xml_gets_the_order_of_the_standard() {
    let arrange = |text: &str| {
        let description = format::read(SourceFile::from_text("device.xdd", text), Format::Xdd);
        String::from_utf8(description.arranged().unwrap()).unwrap()
    };
    let path = support::fixtures().join("bases/device.xdd");
    let mut text = std::fs::read_to_string(path).unwrap();
    let (first, end) = (r#"<CANopenObject index="1000""#, "</q2:CANopenObjectList>");
    for (at, comment) in [(first, "<!-- before -->"), (end, "<!-- last -->")] {
        text = text.replacen(at, &format!("{comment}{at}"), 1);
    }
    let expected = arrange(&text);
    let list = expected.find("<!-- before -->").unwrap()..expected.find("<!-- last -->").unwrap();
    let second = expected[list.clone()].match_indices("<CANopenObject ").nth(1).unwrap().0 + list.start;
    let (first, others) = (&expected[list.start..second], &expected[second..list.end]);
    let mixed = [&expected[..list.start], others, first, &expected[list.end..]].concat();
    let mixed: String = mixed.lines().map(str::trim_start).collect();
    assert_ne!(mixed, expected);
    assert_eq!(
        arrange(&mixed.replace(r#" dataType="0007" accessType="ro""#, " accessType='ro' dataType='0007'")),
        expected
    );
}

/// The error names the reason: the format is read and never written.
#[test]
fn projects_of_other_programs_are_not_formatted() {
    for name in ["esi/press.xml", "objdictgen/pump.od"] {
        let path = support::fixtures().join(name);
        let (_, input) = Reading::default().open(&path).unwrap();
        let Input::Description(description) = input else { panic!("{name}") };
        let error = description.arranged().unwrap_err();
        assert_eq!(error, EditError::NotWritten(path.to_str().unwrap().to_owned()));
    }
}
