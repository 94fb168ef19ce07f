//! The schema of tables of answers, by a validator of others.

use std::fs;
use std::path::Path;
use std::process::Command;

use objdict::probe::{answers_schema, read_answers};

use crate::interop::environment;

/// Tables that are read.
const RIGHT: [&str; 5] = [
    "[]",
    r#"[{"index": 4120, "sub": 1, "value": 306}, {"index": "1018h", "sub": "0x01", "value": [50, 1], "bench": true}]"#,
    r#"{"answers": [{"index": "0x1017", "sub": 0, "action": "write", "sent": "F4 01", "size": 2}]}"#,
    r#"[{"index": "1008", "sub": 0, "abort": "0x08000020", "bytes": null}, {"index": 4104, "sub": 0, "abort": 134217760}]"#,
    r#"[{"index": 8192, "sub": 0, "bytes": "F401"}, {"index": 8192, "sub": 1, "bytes": [1, 255]}, {"index": 8192, "sub": 2}]"#,
];

/// Tables that are refused: no list, no address, an address that there is not, and cells that are not what their columns need.
const WRONG: [&str; 10] = [
    "{}",
    "[1]",
    r#"[{"index": 4096}]"#,
    r#"[{"index": 65536, "sub": 0}]"#,
    r#"[{"index": "12345", "sub": 0}]"#,
    r#"[{"index": 4096, "sub": 256}]"#,
    r#"[{"index": 4096, "sub": 0, "action": "ask"}]"#,
    r#"[{"index": 4096, "sub": 0, "bytes": "123"}]"#,
    r#"[{"index": 4096, "sub": 0, "bytes": [256]}]"#,
    r#"[{"index": 4096, "sub": 0, "abort": "none"}]"#,
];

/// Prints `true` or `false` for each table.
const VALIDATE: &str = "import json, sys, jsonschema_rs\n\
    schema, *tables = (json.load(open(path)) for path in sys.argv[1:])\n\
    jsonschema_rs.meta.validate(schema)\n\
    print(*(jsonschema_rs.Draft202012Validator(schema).is_valid(table) for table in tables))";

#[test]
fn the_schema_says_what_the_reader_says() {
    for (tables, is_right) in [(&RIGHT[..], true), (&WRONG[..], false)] {
        for table in tables {
            assert_eq!(read_answers(table).is_ok(), is_right, "{table}");
        }
    }
    let Some(programs) = environment() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("probe-schema");
    fs::create_dir_all(&folder).unwrap();
    let schema = answers_schema().to_string();
    let texts = std::iter::once(schema.as_str()).chain(RIGHT).chain(WRONG);
    let paths: Vec<_> = texts
        .enumerate()
        .map(|(number, text)| {
            let path = folder.join(format!("{number}.json"));
            fs::write(&path, text).unwrap();
            path
        })
        .collect();
    let output = Command::new(programs.join("python")).args(["-c", VALIDATE]).args(paths).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let expected = format!("{}{}", "True ".repeat(RIGHT.len()), "False ".repeat(WRONG.len()));
    assert_eq!(said.trim(), expected.trim(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// The text that `objdict schema` prints.
#[test]
fn the_schema_is_in_its_file() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("schemas/answers.json");
    assert_eq!(fs::read_to_string(path).unwrap(), format!("{:#}\n", answers_schema()));
}
