//! Networks in a ring, each node with four links to the next one: reading with all descriptions, making PDOs of the links, and
//! the configuration of every node. The time of a node must not grow with the number of nodes.

use std::fmt::Write;
use std::path::Path;

use divan::Bencher;
use divan::counter::ItemsCount;
use objdict::format::network::NetworkFile;
use objdict::network::DcfgenMode;

fn ring(count: usize) -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/network/island.eds");
    let mut text = String::new();
    for node in 0..count {
        let next = (node + 1) % count;
        writeln!(text, "[node.n{node}]\nfile = \"{}\"\nid = {}", file.display(), node + 1).ok();
        for sub in 1..=4 {
            writeln!(text, "[[link]]\nfrom = \"n{node}.6000:{sub}\"\nto = \"n{next}.6200:{sub}\"").ok();
        }
    }
    text
}

#[divan::bench(args = [16, 127])]
fn build(bencher: Bencher, count: usize) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("network.toml");
    std::fs::write(&path, ring(count)).expect("a file");
    bencher.counter(ItemsCount::new(count)).bench(|| {
        let network = NetworkFile::open(&path, &Default::default()).expect("a network");
        network.build(DcfgenMode::Corrected).and_then(|build| build.concise()).map(|files| files.len()).ok()
    });
}
