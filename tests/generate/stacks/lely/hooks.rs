//! Functions of the application that the library calls (`--hook`).

use objdict::generate::Options;

use super::real::Library;
use super::write;
use crate::compile::{c_compiler, cc, succeed};
use crate::devices::device;
use crate::stacks::beside;

const HOOKED: &str = "
[OptionalObjects]
SupportedObjects=1
1=0x1017
[ManufacturerObjects]
SupportedObjects=2
1=0x2101
2=0x2102
[1017]
ParameterName=Producer heartbeat time
DataType=0x0006
AccessType=rw
[2101]
ParameterName=Speed
DataType=0x0003
AccessType=rw
DefaultValue=1
[2102]
ParameterName=Levels
ObjectType=0x8
DataType=0x0003
AccessType=rw
DefaultValue=2
CompactSubObj=2
";

#[test]
fn hooks_answer_uploads_and_downloads() {
    let Some(compiler) = c_compiler() else { return };
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("hooked.eds"), HOOKED).unwrap();
    let mut options = Options::default();
    options.file_stem = "hooked".to_owned();
    options.hooks = ["1017", "2101", "2102:1", "7000"].map(|at| at.parse().unwrap()).into();
    let notes = write(folder, &device(&folder.join("hooked.eds")), &options);
    let notes: Vec<&str> = notes.iter().map(|note| &*note.message).collect();
    let uploads = "the library has its own function for downloads, so the hook is called for uploads only";
    assert_eq!(notes, ["no entry to call a hook for", uploads]);
    let mut cc = cc(&compiler, folder);
    cc.arg("-I.").arg(format!("-I{}", beside("lely", "include").display()));
    cc.args(["-o", "registered", "hooked_sdev.c"]).arg(beside("lely", "registered.c"));
    succeed(&mut cc, "").unwrap();
    let registered = succeed(&mut std::process::Command::new(folder.join("registered")), "").unwrap();
    let expected = ["dn 2101 00 9", "dn 2102 01 9", "up 1017 00 9", "up 2101 00 9", "up 2102 01 9"];
    assert_eq!(registered.lines().collect::<Vec<_>>(), expected);
    let Some(library) = Library::with(&[]) else { return };
    let printed = library.print(folder, "hooked.c", &["hooked_sdev.c"], &[]).unwrap();
    let expected = [
        "2101 00: 06090030",
        "2101 00: 00000000",
        "2101 00 = 1000: 00000000",
        "2102 01: 00000000",
        "2102 01 = 1234: 00000000",
        "2102 02 = 2: 00000000",
    ];
    assert_eq!(printed.lines().collect::<Vec<_>>(), expected);
}
