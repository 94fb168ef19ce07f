//! The examples on the target pages compile with the generated files.

use std::path::Path;

use objdict::generate::{CTable, Options, Target, generate};

use crate::compile::{c_compiler, cc};
use crate::devices::device;
use crate::processors::host;
use crate::stacks::beside;
use crate::support::fixtures;
use crate::verdicts::accepts;

/// The subject of a page's examples.
struct Page {
    name: &'static str,
    fixture: &'static str,
    /// The file stem used to generate the fixture.
    stem: &'static str,
    table: CTable,
    /// The folder with the declarations of the stack.
    stack: Option<&'static str>,
    /// Text before and after an example that is not a complete file.
    around: Option<(&'static str, &'static str)>,
    /// The expected output of an example that is a program.
    prints: Option<&'static str>,
}

const PLAIN: Page = Page {
    name: "",
    fixture: "eds/dspic-sensors.eds",
    stem: "sensors",
    table: CTable::Compact,
    stack: None,
    around: None,
    prints: None,
};

const PAGES: [Page; 9] = [
    Page {
        name: "c",
        around: Some((
            "#include \"od.h\"\nvoid irq_disable(void);\nvoid irq_enable(void);\nvoid serve(uint16_t index, uint8_t sub, const uint8_t *bytes, size_t length);\nstatic od_data_t data;\nvoid serve(uint16_t index, uint8_t sub, const uint8_t *bytes, size_t length)\n{\n",
            "(void)answer;\n}\n",
        )),
        ..PLAIN
    },
    Page {
        name: "c-structs",
        fixture: "eds/minimal.eds",
        table: CTable::Structs,
        around: Some((
            "#include <stdio.h>\n#include \"od.h\"\nint main(void)\n{\nod_init(5);\n",
            "return 0;\n}\n",
        )),
        prints: Some("Producer heartbeat time: 1000\n"),
        ..PLAIN
    },
    Page { name: "canopennode", stack: Some("canopennode"), ..PLAIN },
    Page { name: "canfestival", stack: Some("canfestival"), ..PLAIN },
    Page { name: "canopennode-v1", stack: Some("canopennode_v1"), ..PLAIN },
    Page { name: "canopen-stack", stack: Some("canopen_stack"), ..PLAIN },
    Page { name: "lely", stack: Some("lely"), ..PLAIN },
    Page {
        name: "microcanopen",
        fixture: "eds/io-401.eds",
        stack: Some("microcanopen"),
        around: Some((
            "#include \"sensors_pimg.h\"\nvoid MCO_Init(UNSIGNED16 baud_rate, UNSIGNED8 node_id, UNSIGNED16 heartbeat);\nvoid MCOUSER_ResetCommunication(void);\n",
            "",
        )),
        ..PLAIN
    },
    Page { name: "objdict-macros", fixture: "eds/encoder-406.eds", ..PLAIN },
];

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/targets").join(name);
    std::fs::read_to_string(path).unwrap()
}

/// The examples of a page in one language.
fn examples<'t>(page: &'t str, language: &str) -> Vec<&'t str> {
    let fence = format!("```{language}\n");
    page.split(&fence).skip(1).filter_map(|rest| rest.split("```").next()).collect()
}

#[test]
fn the_examples_of_the_pages_compile() {
    let Some(compiler) = c_compiler() else { return };
    for about in PAGES {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        let mut options = Options::default();
        options.node_id = Some(5);
        options.file_stem = about.stem.to_owned();
        options.table = about.table;
        let target = Target::named(if about.name == "c-structs" { "c" } else { about.name }).unwrap();
        let generated = generate(&device(&fixtures().join(about.fixture)), target, &options).unwrap();
        let mut sources = Vec::new();
        let mut text = String::new();
        for file in &generated.files {
            std::fs::write(folder.join(&file.path), &file.contents).unwrap();
            text.push_str(std::str::from_utf8(&file.contents).unwrap());
            sources.extend(file.path.ends_with(".c").then_some(file.path.as_str()));
        }
        let page = page(&format!("{}.md", about.name));
        let examples = examples(&page, "c");
        assert!(!examples.is_empty(), "{}: no example", about.name);
        for example in examples {
            if about.around.is_none() && !example.contains("#include") {
                // an excerpt of the output
                for line in example.lines().filter(|line| !line.is_empty()) {
                    assert!(text.contains(line), "{}: `{line}` is not in the output", about.name);
                }
                continue;
            }
            let (before, behind) = about.around.unwrap_or_default();
            std::fs::write(folder.join("example.c"), format!("{before}{example}{behind}")).unwrap();
            let mut cc = cc(&compiler, folder);
            cc.arg("-I.");
            if let Some(stack) = about.stack {
                cc.arg("-I").arg(beside(stack, "include"));
            }
            match about.prints {
                None => {
                    accepts(cc.args(["-c", "example.c"])).unwrap();
                }
                Some(prints) => {
                    host(cc.args(["-o", "example", "example.c"]).args(&sources)).expect(&[], prints).unwrap();
                }
            }
        }
    }
}

/// Every page with a C example is in the list above; examples for third-party crates are compiled in
/// tests/crates.
#[test]
fn every_example_is_tried() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/targets");
    for entry in folder.read_dir().unwrap() {
        let name = entry.unwrap().file_name().to_string_lossy().into_owned();
        let page = page(&name);
        let is_known = PAGES.iter().any(|known| name == format!("{}.md", known.name));
        assert!(is_known || examples(&page, "c").is_empty(), "{name}: an example that nobody compiles");
        assert_eq!(examples(&page, "rust").len(), 0, "{name}: an example that nobody compiles");
        for example in examples(&page, "rust,ignore") {
            let tests = match name.as_str() {
                "canopen-rs.md" => include_str!("../../crates/tests/read_back/canopen_rs.rs").to_owned(),
                "zencan.md" => include_str!("../../crates/build.rs").to_owned(),
                _ => panic!("{name}: an example that nobody compiles"),
            };
            for call in calls(example) {
                assert!(tests.contains(call), "{name}: tests/crates does not call `{call}`");
            }
        }
    }
}

/// The calls in an example up to the first argument, which are the same in every program.
fn calls(example: &str) -> impl Iterator<Item = &str> {
    let lines = example.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    let called = lines.filter_map(|line| Some(line.split_once('(')?.0));
    called.map(|called| called.rsplit([' ', '(']).next().unwrap_or(called))
}
