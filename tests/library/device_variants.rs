//! Variants of a `device.toml`: what each has otherwise than the file, on top of it.

use std::fs;

use objdict::diagnostic::Severity;
use objdict::format::input::{Input, Reading};
use objdict::format::network::{NetworkFile, PathOptions};
use objdict::format::{self, Description, Format, ReadError};
use objdict::model::{Device, Place, Value};
use objdict::source::{SourceFile, SourceOptions};

fn read(text: &str) -> Description {
    format::read(SourceFile::from_text("device.toml", text), Format::Toml)
}

fn reading(variant: &str) -> Reading {
    let mut reading = Reading::default();
    reading.variant = Some(variant.to_owned());
    reading
}

fn variant(text: &str, name: &str) -> Result<Description, ReadError> {
    let reading = Reading { judge: None, ..reading(name) };
    match reading.read_one("device.toml", text.as_bytes().to_vec())?.1 {
        Input::Description(description) => Ok(*description),
        other => panic!("{other:?}"),
    }
}

const FAMILY: &str = include_str!("../../fixtures/toml/family.toml");

fn product(device: &Device) -> (Option<u32>, Option<&str>) {
    let (info, file) = (device.device_info.as_ref().unwrap(), device.file_info.as_ref().unwrap());
    (info.product_number, file.file_name.as_deref())
}

#[test]
fn a_variant_is_the_device_with_what_it_says_otherwise() {
    let base = read(FAMILY);
    assert_eq!(product(base.device()), (Some(0x1610), Some("io16.eds")));
    assert_eq!(base.variant(), None);
    let small = variant(FAMILY, "io8").unwrap();
    assert_eq!(small.variant(), Some("io8"));
    assert_eq!(
        product(small.device()),
        (Some(0x1608), Some("io16-io8.eds")),
        "its file has a name of its own"
    );
    let inputs = |device: &Device| device.object(0x6000).unwrap().highest_sub();
    assert_eq!((inputs(base.device()), inputs(small.device())), (Some(2), Some(1)));
    assert!(base.device().object(0x2005).is_some());
    assert!(small.device().object(0x2005).is_none(), "`remove` takes objects of the file");
    let fast = variant(FAMILY, "io8-fast").unwrap();
    assert_eq!(product(fast.device()), (Some(0x1618), Some("fast8.eds")));
    let default = |index| fast.device().object(index).and_then(|object| object.entry(0)?.default.clone());
    assert_eq!(default(0x2005), Some(Value::Unsigned(1)), "one key of an object");
    assert_eq!(default(0x2006), Some(Value::Boolean(false)), "an object of its own");
    assert_eq!(fast.device().object(0x2005).unwrap().name(), base.device().object(0x2005).unwrap().name());
    let event = fast.device().object(0x1802).and_then(|object| object.entry(5)?.default.clone());
    assert_eq!(event, Some(Value::Unsigned(100)), "a PDO of the file with another time");
    for description in [&base, &small, &fast] {
        assert_eq!(objdict::check(description).len(), 0, "{:?}", description.variant());
    }
}

#[test]
fn a_former_name_of_a_key_means_the_same_in_a_file_and_its_variant() {
    for [of_file, of_variant] in [["event-timer", "event"], ["event", "event-timer"], ["event", "event"]] {
        let text = FAMILY.replace("event-timer = \"1s\"", &format!("{of_file} = \"1s\""));
        let text = text.replace("event-timer = \"100ms\"", &format!("{of_variant} = \"100ms\""));
        let event =
            |device: &Device| device.object(0x1802).and_then(|object| object.entry(5)?.default.clone());
        assert_eq!(event(read(&text).device()), Some(Value::Unsigned(1000)), "{of_file}");
        assert_eq!(
            event(variant(&text, "io8-fast").unwrap().device()),
            Some(Value::Unsigned(100)),
            "{of_variant}"
        );
    }
}

#[test]
fn what_a_variant_removes_may_be_of_the_profile_or_of_the_file() {
    let text = |variant: &str| {
        format!(
            "format = 'objdict-device/1'\nprofile = '301@1'\nremove = ['1018:4']\n[object]\n\
             2000 = {{ name = 'A', type = 'u8' }}\n2001.sub.1 = {{ name = 'B', type = 'u8' }}\n\
             2001.sub.2 = {{ name = 'C', type = 'u8' }}\n2001.name = 'R'\n[variant.a]\n{variant}\n"
        )
    };
    let device = |own: &str| {
        let description = variant(&text(own), "a").unwrap();
        assert_eq!(description.findings().len(), 0, "{own}: {:?}", description.findings());
        description.into_device()
    };
    let all = device("");
    assert!(all.object(0x1018).unwrap().subs.get(4).is_none());
    let without = device("remove = { 1017 = 'no heartbeat', '2001:2' = 'no C' }\nfeatures.heartbeat = true");
    assert!(without.object(0x1017).is_none());
    assert!(without.object(0x1018).unwrap().subs.get(4).is_none(), "what the file removes stays away");
    assert_eq!(without.object(0x2001).unwrap().highest_sub(), Some(1));
    let again = device("object.1018.sub.4.default = 7");
    assert!(again.object(0x1018).unwrap().subs.get(4).is_some(), "what it describes is there again");
    let wrong = variant(&text("remove = ['2009']"), "a").unwrap();
    assert_eq!(wrong.findings().iter().next().unwrap().rule.name(), "wrong-type");
}

#[test]
fn findings_name_the_variant_and_point_to_what_it_says() {
    let text = FAMILY.replace("features.digital-inputs = 8", "features.digital-inputs = 'x'");
    let found = |description: &Description| -> Vec<String> {
        let shown = objdict::check(description);
        let text = description.source().text();
        shown
            .iter()
            .map(|found| {
                format!("{}: {}", description.span_of(&found.labels[0].at).of(text), found.message.shown())
            })
            .collect()
    };
    assert_eq!(found(&read(&text)), [""; 0]);
    let fast = variant(&text, "io8-fast").unwrap();
    assert_eq!(
        found(&fast),
        ["'x': `digital-inputs` is `x`, a string instead of a whole number (variant `io8-fast`)"]
    );
    let limit = Place::object(0x2005).field(objdict::model::Field::DefaultValue);
    assert_eq!(fast.locate(&limit).unwrap().of(&text), "1");
    let number = Place::object(0x2001).field(objdict::model::Field::DataType);
    assert_eq!(fast.locate(&number).unwrap().of(&text), "\"[i16; 2]\"", "the rest is where the file says it");
    // a file with its variants, as `check` sees them
    let names = read(&text).map_devices(|device| device.variant().map(str::to_owned));
    assert_eq!(names, [None, Some("io8".to_owned()), Some("io8-fast".to_owned())]);
}

#[test]
fn there_are_only_the_variants_that_the_file_names() {
    let error = variant(FAMILY, "io9").unwrap_err();
    assert_eq!(error.to_string(), "`device.toml` has no variant `io9`");
    assert_eq!(error.help().unwrap(), "it has `io8` and `io8-fast`");
    let error = reading("io8").read("a.eds", b"[DeviceInfo]\nVendorName=a\n".to_vec()).unwrap_err();
    assert_eq!(error.help().unwrap(), "only a `device.toml` with `[variant.…]` has variants");
    const HEAD: &str = "format = 'objdict-device/1'\n";
    for (own, marked, rule) in [
        ("[variant.'a b']\n", "'a b'", "wrong-type"),
        ("variant = 1\n", "1", "wrong-type"),
        ("variant.a = 1\n", "1", "wrong-type"),
        ("[variant.a]\nvariant = {}\n", "variant", "unknown-key"),
        ("[variant.a]\nformat = 'x'\n", "format", "unknown-key"),
        ("[variant.a]\nobjct = {}\n", "objct", "unknown-key"),
    ] {
        let text = format!("{HEAD}{own}");
        let read = read(&text);
        let all = read.map_devices(|device| device.findings().clone());
        let found: Vec<_> = all
            .iter()
            .flat_map(|findings| findings.iter())
            .map(|found| (read.span_of(&found.labels[0].at).of(&text), found.rule.name()))
            .collect();
        assert_eq!(found, [(marked, rule)], "{own}");
    }
    let many: String = (0..70).map(|number| format!("[variant.v{number}]\n")).collect();
    let read = read(&format!("{HEAD}{many}"));
    assert_eq!(read.map_devices(|_| ()).len(), 65);
    assert_eq!(read.findings().iter().next().unwrap().rule.name(), "out-of-range");
}

#[test]
fn a_variant_is_written_whole() {
    let small = variant(FAMILY, "io8").unwrap();
    let node = objdict::model::Commissioning { node_id: Some(7), ..Default::default() };
    let text = String::from_utf8(small.to_node("io8.toml", &node).unwrap()).unwrap();
    let again = read(&text);
    assert_eq!(again.findings().len(), 0);
    assert_eq!(again.map_devices(|_| ()).len(), 1, "it has no variants");
    assert_eq!(again.device().objects, small.device().objects);
    assert_eq!(again.device().node_id(), Some(7));
}

/// A folder of a project with these files.
fn project(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("objdict.toml"), "").unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

fn open(folder: &tempfile::TempDir, name: &str) -> Description {
    format::open(&folder.path().join(name), &SourceOptions::default()).unwrap()
}

#[test]
fn a_file_is_the_one_that_it_extends_with_what_it_says_otherwise() {
    let middle = "format = 'objdict-device/1'\nextends = '../family.toml'\nremove = ['2000', '1802', '1A02']\n\
                  [object.2005]\ndefault = 20\n";
    let near = "format = 'objdict-device/1'\nextends = 'parts/middle.toml'\n[device]\nproduct-number = 7\n\
                [variant.a.device]\nproduct-number = 8\n";
    let folder = project(&[("family.toml", FAMILY), ("parts/middle.toml", middle), ("near.toml", near)]);
    let read = open(&folder, "near.toml");
    assert_eq!(read.findings().len(), 0, "{:?}", read.findings());
    assert_eq!(objdict::check(&read).len(), 0, "{:?}", objdict::check(&read));
    let device = read.device();
    assert_eq!(product(device), (Some(7), Some("io16.eds")));
    assert!(
        device.object(0x2000).is_none() && device.object(0x1802).is_none() && device.object(0x2001).is_some()
    );
    let default = device.object(0x2005).and_then(|object| object.entry(0)?.default.clone());
    assert_eq!(default, Some(Value::Unsigned(20)), "the nearer file wins");
    let numbers = read.map_devices(|device| product(device.device()).0);
    assert_eq!(numbers, [Some(7), Some(8)], "variants are of the file that names them");
    let vendor = Place::of(objdict::model::Part::DeviceInfo).field(objdict::model::Field::VendorNumber);
    let text = read.source().text();
    assert_eq!(read.locate(&vendor).unwrap().of(text), "'parts/middle.toml'");
    let node = objdict::model::Commissioning { node_id: Some(7), ..Default::default() };
    let whole = String::from_utf8(read.to_node("near.toml", &node).unwrap()).unwrap();
    assert!(!whole.contains("extends"), "{whole}");
}

#[test]
fn what_cannot_be_extended_is_a_finding_at_the_key() {
    let head = |rest: &str| format!("format = 'objdict-device/1'\n{rest}");
    let long: Vec<(String, String)> = (0..20)
        .map(|number| (format!("f{number}.toml"), head(&format!("extends = 'f{}.toml'\n", number + 1))))
        .collect();
    let mut files: Vec<(&str, &str)> = long.iter().map(|(name, text)| (&**name, &**text)).collect();
    let (one, other) = (head("extends = 'other.toml'\n"), head("extends = 'one.toml'\n"));
    let wrong = head("[object.2000]\nname = 'A'\ntype = 'u17'\n");
    let texts: Vec<String> =
        ["one.toml", "no.toml", "../outside.toml", "a.eds", "bad.toml", "f0.toml", "wrong.toml"]
            .iter()
            .map(|name| head(&format!("extends = '{name}'\n")))
            .collect();
    files.extend([
        ("one.toml", &*one),
        ("other.toml", &*other),
        ("a.eds", "[FileInfo]\n"),
        ("bad.toml", "format = 'objdict-device/1'\n["),
    ]);
    files.push(("wrong.toml", &wrong));
    let folder = project(&files);
    for (text, message) in texts.iter().zip([
        "files extend each other: one.toml → other.toml → one.toml",
        "`no.toml` cannot be extended: ",
        "`../outside.toml` cannot be extended: ",
        "`a.eds` cannot be extended: it is not a `device.toml`",
        "`bad.toml` cannot be extended: ",
        "more than 16 files extend each other",
        "`u17` is not a data type",
    ]) {
        fs::write(folder.path().join("near.toml"), text).unwrap();
        let read = open(&folder, "near.toml");
        let found: Vec<_> = objdict::check(&read)
            .iter()
            .filter(|found| found.rule.group() == "keys")
            .map(|found| {
                (read.span_of(&found.labels[0].at).of(text).to_owned(), found.message.shown().into_owned())
            })
            .collect();
        let [(at, found)] = &found[..] else { panic!("{text}: {found:?}") };
        assert!(at.starts_with('\'') && at.ends_with(".toml'") || at == "'a.eds'", "{at}");
        assert!(found.starts_with(message), "{found}");
        assert_eq!(found.ends_with(" (in `wrong.toml`)"), text.contains("wrong"), "{found}");
    }
    let unnamed = read(&texts[0]);
    assert_eq!(
        unnamed.findings().iter().next().unwrap().message.shown(),
        "the location of `one.toml` is unknown"
    );
}

#[test]
fn each_variant_has_a_product_code_of_its_own() {
    let shared = |text: &str| -> Vec<String> {
        let findings = objdict::check(&read(text));
        let found = findings.iter().filter(|finding| finding.rule.id == "keys/shared-product-code");
        found.map(|finding| finding.message.to_string()).collect()
    };
    assert!(shared(FAMILY).is_empty());
    let same = FAMILY.replace("product-number = 0x1618", "product-number = 0x1608");
    assert_eq!(shared(&same), ["variant `io8-fast` has the product code of variant `io8`: `0x1608`"]);
    let none = FAMILY.replace("product-number = 0x1608\n", "");
    assert_eq!(
        shared(&none),
        ["variant `io8` has the product code of the device without variants: `0x1610`"]
    );
}

/// A node of a network is a variant when its name follows the path, in TOML and in the YAML of dcf-tools.
#[test]
fn nodes_are_variants() {
    let folder = crate::network::new_folder("variants-of-nodes");
    fs::write(folder.join("family.toml"), FAMILY).unwrap();
    let more = "format = \"objdict-device/1\"\nextends = \"family.toml\"\n\
                [variant.more]\ndevice.product-number = 0x1618\n";
    fs::write(folder.join("more.toml"), more).unwrap();
    let nodes = "[node.big]\nfile = \"family.toml\"\nid = 1\n\
                 [node.small]\nfile = \"family.toml#io8\"\nid = 2\n\
                 [node.more]\nfile = \"more.toml#more\"\nid = 3\n";
    fs::write(folder.join("network.toml"), nodes).unwrap();
    let yaml = "master:\n  dcf: family.toml\n  node_id: 9\nbig:\n  dcf: family.toml\n  node_id: 1\nsmall:\n  dcf: family.toml#io8\n  node_id: 2\n\
                more:\n  dcf: more.toml#more\n  node_id: 3\n";
    fs::write(folder.join("bus.yml"), yaml).unwrap();
    for name in ["network.toml", "bus.yml"] {
        let network = NetworkFile::open(&folder.join(name), &PathOptions::default()).unwrap();
        let findings = network.check();
        let errors = findings.iter().filter(|finding| finding.severity == Severity::Error);
        let errors: Vec<String> = errors.map(|finding| finding.message.to_string()).collect();
        assert!(errors.is_empty(), "{name}: {errors:?}");
        let nodes = network.network().unwrap().slaves();
        let codes: Vec<_> = nodes.map(|(_, node)| product(&node.device).0).collect();
        assert_eq!(codes, [Some(0x1610), Some(0x1608), Some(0x1618)], "{name}");
    }
    fs::write(folder.join("network.toml"), "[node.a]\nfile = \"family.toml#io9\"\nid = 1\n").unwrap();
    let findings = NetworkFile::open(&folder.join("network.toml"), &PathOptions::default()).unwrap().check();
    let message = findings.iter().next().unwrap().message.to_string();
    assert!(message.ends_with("has no variant `io9`; it has `io8` and `io8-fast`"), "{message}");
}
