//! What the nodes of `objdict-device` take on a Cortex-M4: each is linked alone, with the objects of some services.

use std::fmt::Write;
use std::path::Path;

use objdict::generate::Options;

use crate::compile::generate_with;
use crate::device;
use crate::thumb::{HEAD, MANIFEST, build, can_build, key, link};

const PROJECT: &str = env!("CARGO_MANIFEST_DIR");

/// The promises: a node without further services, and one with all.
const MINIMAL: usize = 9_000;
const ALL: usize = 21_000;

/// A device with an RPDO and a TPDO, whose other services are in `[features]`.
const DEVICE: &str = r#"format = "objdict-device/1"
profile = "301@1"
[device]
vendor-name = "objdict fixtures"
vendor-number = 0x3F9
product-name = "Sensor"
product-number = 1
revision-number = 0x10000
[rpdo.1]
map = ["2000"]
[tpdo.1]
map = ["2001"]
[object]
2000 = { name = "Output", type = "u16", access = "rww", map = "rpdo", group = "VALUES" }
2001 = { name = "Input", type = "u16", access = "ro", map = "tpdo" }
[features]
device-name = false
rpdos = 1
tpdos = 1
"#;

/// The main loop of docs/guides/runtime.md.
const MAIN: &str = "
#[allow(warnings)] mod od { include!(\"od.rs\"); }
use objdict_device::{Frame, Received};
#[no_mangle] pub fn boot(node: &mut Node, now: u64) -> Frame { node.boot(now) }
#[no_mangle] pub fn receive(node: &mut Node, frame: &Frame, now: u64) -> Received { node.receive(frame, now) }
#[no_mangle] pub fn poll(node: &mut Node, now: u64) -> Option<Frame> {
    node.pdos.request_changed(&mut node.dictionary);
    node.poll(now)
}
";

const PLAIN: &str = "
pub type Node = od::Node<64, 1>;
#[no_mangle] pub fn start(node: &mut Node, id: u8) { *node = od::node(id); }
";

const STORED: &str = "
use objdict_device::{Abort, Storage};
pub type Node = od::Node<64, 1, od::Stored<Memory>>;
pub struct Memory([u8; 64]);
impl Storage for Memory {
    fn save(&mut self, _: usize, image: &[u8]) -> Result<(), Abort> {
        self.0.iter_mut().zip(image).for_each(|(to, from)| *to = *from);
        Ok(())
    }
    fn load(&mut self, _: usize, image: &mut [u8]) -> Result<(), Abort> {
        image.iter_mut().zip(&self.0).for_each(|(to, from)| *to = *from);
        Ok(())
    }
    fn erase(&mut self, _: usize) -> Result<(), Abort> {
        self.0.fill(0xFF);
        Ok(())
    }
}
#[no_mangle] pub fn start(node: &mut Node, id: u8) {
    *node = od::Node::new(id, od::Stored::new(id, Memory([0xFF; 64])), od::pdos());
}
";

/// Services beside the node, which are linked with the functions that use them.
const BESIDE: &str = "
use objdict_device::{LssReceived, LssSlave, SdoClient, SdoStep};
#[no_mangle] pub fn lss(slave: &mut LssSlave, frame: &Frame, now: u64) -> (LssReceived, bool) {
    (slave.receive(frame, now), slave.poll(now).is_some())
}
#[no_mangle] pub fn client(client: &mut SdoClient, value: &mut [u8], frame: &Frame, now: u64) -> [SdoStep; 4] {
    let (start, next) = (client.download(value, 0x2000, 0, value.len(), now), client.receive(value, frame, now));
    [start, next, client.upload(0x2000, 0, now), client.poll(value, now)]
}
";

/// The functions of a node, and those of what is beside it.
const ROOTS: [&str; 4] = ["start", "boot", "receive", "poll"];
const FURTHER: [(&str, &str); 2] = [("LSS slave: `LssSlave`", "lss"), ("SDO client: `SdoClient`", "client")];

/// What a node has more than the first one: its row in the table, its `[features]`, the source, and the features of the crate.
const NODES: [(&str, &str, &str, &str); 7] = [
    ("NMT, heartbeat, one SDO server, two PDOs", "emcy = false\nsync = false", PLAIN, ""),
    (
        "block transfers of the SDO server (feature `block-transfer`)",
        "emcy = false\nsync = false",
        PLAIN,
        "\"block-transfer\"",
    ),
    ("emergency messages and history: 1003h, 1014h, 1015h", EMCY, PLAIN, ""),
    (
        "SYNC producer: 1005h, 1006h, 1019h",
        "emcy = false\nsync-producer = true\nsync-counter = true",
        PLAIN,
        "",
    ),
    ("heartbeats of four nodes: 1016h", "emcy = false\nsync = false\nheartbeat-consumers = 4", PLAIN, ""),
    ("stored values: 1010h, 1011h", "emcy = false\nsync = false\nstore = 1", STORED, ""),
    ("all of these", EVERYTHING, STORED, "\"block-transfer\""),
];

const EMCY: &str = "sync = false\nerror-history = 4\nemcy-inhibit-time = true";
const EVERYTHING: &str =
    "error-history = 4\nemcy-inhibit-time = true\nsync-producer = true\nsync-counter = true
heartbeat-consumers = 4\nstore = 1";

/// Writes the package of a node.
fn package(folder: &Path, (_, features, source, crate_features): (&str, &str, &str, &str)) {
    std::fs::create_dir_all(folder.join("src")).unwrap();
    let project = Path::new(PROJECT);
    let runtime = project.join("crates/objdict-device");
    let dependency = format!(
        "[dependencies]\nobjdict-device = {{ path = {runtime:?}, default-features = false, features = [{crate_features}] }}\n"
    );
    std::fs::write(folder.join("Cargo.toml"), format!("{MANIFEST}{dependency}")).unwrap();
    std::fs::copy(project.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    std::fs::write(folder.join("src/lib.rs"), [HEAD, MAIN, BESIDE, source].concat()).unwrap();
    std::fs::write(folder.join("device.toml"), format!("{DEVICE}{features}\n")).unwrap();
    let mut options = Options::default();
    options.runtime = true;
    options.node_id = Some(5);
    generate_with(&folder.join("src"), &device(&folder.join("device.toml")), "rust", &options);
}

/// The rows of the table: what each node takes more than the first one, and what the services beside it take.
fn measure(folder: &Path) -> Result<Vec<(&'static str, usize)>, String> {
    let mut rows: Vec<(&str, usize)> = Vec::new();
    for (number, node) in NODES.into_iter().enumerate() {
        let label = node.0;
        let folder = folder.join(number.to_string());
        // the packages are one for Cargo, which builds it again if its files are newer
        package(&folder, node);
        let archive = build(&folder, "fat")?;
        let linked = |further: &[&str]| {
            let roots: Vec<String> = [&ROOTS, further].concat().into_iter().map(str::to_owned).collect();
            let (symbols, flash) = link(&folder, &archive, &roots);
            let panic = symbols.iter().find(|(name, _)| name.contains("panic"));
            assert_eq!(panic, None, "{label}: a function that panics");
            flash
        };
        let node = linked(&[]);
        let first = rows.first().map_or(0, |(_, flash)| *flash);
        match number {
            0 => {
                rows.push((label, node));
                rows.extend(FURTHER.map(|(label, root)| (label, linked(&[root]) - node)));
            }
            6 => rows.push((label, linked(&FURTHER.map(|(_, root)| root)))),
            _ => rows.push((label, node - first)),
        }
    }
    Ok(rows)
}

/// A row of docs/reference/table-size.md, whose number may be off by 2 %, or by 40 bytes.
fn is_stated(page: &str, label: &str, bytes: usize) -> bool {
    let row = page.lines().find_map(|line| line.strip_prefix(&format!("| {label} | "))?.strip_suffix(" |"));
    let stated = row.and_then(|number| number.replace([',', '+'], "").parse::<usize>().ok());
    stated.is_some_and(|stated| stated.abs_diff(bytes) <= 40.max(bytes / 50))
}

#[test]
fn a_node_takes_the_flash_that_its_services_need() {
    if !can_build() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (number, node) in NODES.into_iter().enumerate() {
        package(&folder.join(number.to_string()), node);
    }
    let project = Path::new(PROJECT);
    let page = std::fs::read_to_string(project.join("docs/reference/table-size.md")).unwrap();
    // the packages name the folder of the project, which decides nothing
    let mut key = key(&project.join("crates/objdict-device/src"));
    key.add(std::fs::read(project.join("crates/objdict-device/Cargo.toml")).unwrap());
    (0..NODES.len()).for_each(|number| key.folder(&folder.join(number.to_string()).join("src")));
    key.add(&page);
    key.or_try(|| {
        let rows = measure(folder)?;
        let table = rows.iter().fold(String::new(), |mut table, (label, bytes)| {
            writeln!(table, "| {label} | {bytes} |").unwrap();
            table
        });
        let (minimal, all) = (rows[0].1, rows[rows.len() - 1].1);
        assert!(minimal <= MINIMAL && all <= ALL, "more than {MINIMAL} or {ALL} bytes:\n{table}");
        let is_stated = rows.iter().all(|(label, bytes)| is_stated(&page, label, *bytes));
        assert!(is_stated, "docs/reference/table-size.md has other sizes than:\n{table}");
        Ok(())
    })
    .unwrap();
}
