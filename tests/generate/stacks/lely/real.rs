//! With the library: `OBJDICT_LELY_DIR` names a checkout. Its loader takes the tables, and its generator dcf2c writes the same
//! ones but for its errors.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::diagnostic::Tool;
use objdict::format;
use objdict::generate::Options;
use objdict::model::{Device, ObjectType};
use objdict::source::SourceOptions;

use super::{LACKS, without_files, write};
use crate::compile::{c_compiler, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::stacks::truth::{Lack, compare, truth, without};
use crate::stacks::{beside, checkout, for_node, startup};

/// The library, compiled.
pub(super) struct Library {
    compiler: String,
    checkout: PathBuf,
    folder: tempfile::TempDir,
    /// The macros with which it and its users are compiled.
    macros: &'static [&'static str],
}

impl Library {
    /// With dcf2c, which needs all of it.
    pub(super) fn build() -> Option<Self> {
        let library = Self::with(&[])?;
        let mut dcf2c = library.cc(library.folder.path());
        dcf2c
            .args(["-std=gnu99", "-D_GNU_SOURCE", "-w", "-o", "dcf2c"])
            .arg(library.checkout.join("tools/dcf2c.c"));
        succeed(dcf2c.arg("-I").arg(library.checkout.join("src")).args(["lely.a", "-lm", "-lpthread"]), "")
            .unwrap();
        Some(library)
    }

    pub(super) fn with(macros: &'static [&'static str]) -> Option<Self> {
        let (checkout, compiler) = (checkout("OBJDICT_LELY_DIR")?, c_compiler()?);
        let library = Self { compiler, checkout, folder: tempfile::tempdir().unwrap(), macros };
        let mut cc = library.cc(library.folder.path());
        cc.args(["-std=gnu99", "-D_GNU_SOURCE", "-w", "-c"]).arg("-I").arg(library.checkout.join("src"));
        for part in ["util", "libc", "co", "can"] {
            let files = std::fs::read_dir(library.checkout.join("src").join(part)).unwrap();
            let files = files.map(|file| file.unwrap().path());
            cc.args(files.filter(|path| path.extension().is_some_and(|extension| extension == "c")));
        }
        succeed(&mut cc, "").unwrap();
        let objects = std::fs::read_dir(library.folder.path()).unwrap().map(|file| file.unwrap().path());
        let objects: Vec<PathBuf> = objects.collect();
        succeed(Command::new("ar").arg("rcs").arg(library.path("lely.a")).args(objects), "").unwrap();
        Some(library)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn cc(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.compiler);
        command
            .current_dir(folder)
            .arg("-isystem")
            .arg(self.checkout.join("include"))
            .arg("-I.")
            .args(self.macros);
        command
    }

    /// Builds a program of the tests with a table, and returns what it prints.
    pub(super) fn print(
        &self,
        folder: &Path,
        program: &str,
        sources: &[&str],
        arguments: &[&str],
    ) -> Result<String, String> {
        let program = self.program(folder, program, sources)?;
        succeed(Command::new(program).args(arguments), "")
    }

    /// Builds a program of the tests in a folder.
    pub(super) fn program(&self, folder: &Path, program: &str, sources: &[&str]) -> Result<PathBuf, String> {
        let mut cc = self.cc(folder);
        cc.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-o", "program"]).args(sources);
        cc.arg(beside("lely", program)).arg(self.path("lely.a")).args(["-lm", "-lpthread"]);
        succeed(&mut cc, "")?;
        Ok(folder.join("program"))
    }
}

#[test]
fn the_library_loads_the_tables_for_any_node() {
    if let Some(library) = Library::with(&[]) {
        loads_the_tables(&library, "-DSDEV=od_sdev", &LACKS);
    }
}

#[test]
fn without_malloc_the_device_is_in_static_memory() {
    if let Some(library) = Library::with(&["-DLELY_NO_MALLOC=1"]) {
        let [texts_are_whole @ .., _] = &LACKS;
        loads_the_tables(&library, "-DCREATE=od_create", texts_are_whole);
    }
}

fn loads_the_tables(library: &Library, source: &str, lacks: &[Lack]) {
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let device = &without_files(device);
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        write(folder.path(), device, &for_node(5));
        let fail = |error: String| format!("{name}: {error}");
        for node_id in [5, 127] {
            let arguments = [node_id.to_string()];
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let sources = [source, "device_sdev.c"];
            let printed = library.print(folder.path(), "loaded.c", &sources, &arguments).map_err(fail)?;
            compare(name, &without(lacks, truth(device, node_id)), &printed).map_err(fail)?;
        }
        Ok(())
    });
}

/// PDOs that the library serves and others, by transmission type and mapping.
fn served_or_not() -> Device {
    let bytes = [0x2001_0008; 9];
    let missing = [&bytes[..8], &[0x2003_0008][..]].concat();
    startup::device(&[
        (0x1400, 255, 0x4000_0200, &[0x2000_0010]),
        (0x1401, 241, 0x4000_0300, &[0x2000_0010]),
        (0x1402, 255, 0x4000_0400, &[0x2000_0020]),
        (0x1403, 1, 0x4000_0500, &[0x2000_0008]),
        (0x1404, 255, 0x4000_0201, &missing),
        (0x1800, 255, 0x4000_0180, &[0x2000_0010]),
        (0x1801, 250, 0x4000_0280, &[0x2000_0010]),
        (0x1802, 253, 0x4000_0380, &[0x2000_0010]),
        (0x1803, 253, 0x0000_0480, &[0x2000_0010]),
        (0x1804, 252, 0x0000_0181, &[0x2000_0010]),
        (0x1805, 240, 0x4000_0281, &[0x2000_0008]),
        (0x1806, 0, 0x4000_0381, &bytes),
    ])
}

#[test]
fn notes_predict_which_pdos_are_not_served() {
    let device = served_or_not();
    let folder = tempfile::tempdir().unwrap();
    let predicted = startup::predicted(&device, &write(folder.path(), &device, &for_node(5)));
    let expected = [
        "RPDO 2 without effect",
        "RPDO 3 rejected",
        "RPDO 4 rejected",
        "RPDO 5 rejected",
        "TPDO 2 silent",
        "TPDO 3 silent",
        "TPDO 7 silent",
    ];
    assert_eq!(predicted.into_iter().collect::<Vec<_>>(), expected);
}

/// What PDOs do is what the notes predict.
#[test]
fn the_library_serves_the_pdos_as_the_notes_predict() {
    let Some(library) = Library::with(&[]) else { return };
    let [started, found] = [const { AtomicUsize::new(0) }; 2];
    let devices = [devices(), vec![("served or not".to_owned(), served_or_not())]].concat();
    for_all(&devices, |(name, device)| {
        let fail = |error: String| format!("{name}: {error}");
        let device = &without_files(device);
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let notes = write(folder.path(), device, &for_node(5));
        let sources = ["-DSDEV=od_sdev", "device_sdev.c"];
        let printed = library.print(folder.path(), "pdos.c", &sources, &["5"]).map_err(fail)?;
        found.fetch_add(startup::compare(device, &notes, &printed).map_err(fail)?, Ordering::Relaxed);
        started.fetch_add(1, Ordering::Relaxed);
        Ok(())
    });
    eprintln!("Lely: {started:?} nodes started, {found:?} predictions");
}

const COMPACT: &str = "denotations, flags of configured values and the number of errors in compact storage";

/// Why a row of dcf2c differs, if it is an error of dcf2c or of the description; the first ones also occur in fixtures.
const CAUSES: [&str; 14] = [
    COMPACT,
    "a file name without its end",
    "OCTET_STRINGs and DOMAINs are empty",
    "REALs are read as bits",
    "quotes and backslashes in texts",
    "`#` and `;` in names begin comments",
    "`0x80+$NODEID` is not read",
    "`LSS_SerialNumber=0` is a value",
    "limits of 40 to 56 bits",
    "hexadecimal numbers below zero are the largest one",
    "a negative limit of an unsigned number wraps",
    "an object without list, a sub-index behind `SubNumber`, a VAR with compact sub-objects",
    "the last of two equal keys counts",
    "`DeviceCommissioning` is misspelled in the standard",
];

/// How many of them fixtures have.
const IN_FIXTURES: usize = 4;

/// The number of the cause; `None` if there is no difference or nothing explains it.
fn cause(device: &Device, theirs: Option<&str>, ours: &str) -> Option<usize> {
    let Some(theirs) = theirs else { return Some(11) };
    let (theirs, ours): (Vec<&str>, Vec<&str>) = (theirs.split(' ').collect(), ours.split(' ').collect());
    let (address, data_type) = match theirs[0] {
        "device" => return Some(if theirs[1] == ours[1] { 4 } else { 13 }),
        "object" => (theirs[1], ""),
        address => (address, theirs[2]),
    };
    let object = u16::from_str_radix(address, 16).ok().and_then(|index| device.object(index));
    let is_compact = object.is_some_and(|object| object.compact.is_some());
    if is_compact && object.is_some_and(|object| object.object_type() == ObjectType::Var) {
        return Some(11);
    }
    let pairs = theirs.iter().zip(&ours).enumerate().filter(|(_, (theirs, ours))| theirs != ours);
    let mut causes = pairs.map(|(at, (theirs, ours_here))| {
        let is_value = at == 5 || theirs.starts_with("def=");
        let is_limit = theirs.starts_with("min=") || theirs.starts_with("max=");
        match data_type {
            _ if is_compact && (theirs.starts_with("name=") || theirs.starts_with("flags=")) => Some(0),
            "05" if is_compact && address == "1003" => Some(0),
            _ if theirs.starts_with("name=") && ours_here.starts_with(theirs) => Some(5),
            "0F" if *ours_here == format!("{theirs}00") => Some(1),
            "0A" | "0F" if is_value && theirs.ends_with('-') => Some(2),
            "08" | "11" if is_value => Some(3),
            "09" if is_value => Some(4),
            _ if ours.last() == Some(&"flags=C0") => Some(6),
            "07" if (address, at) == ("1018", 5) => Some(7),
            "12" | "13" | "14" if is_limit => Some(8),
            "02" | "03" | "04" if (is_value || is_limit) && is_largest(theirs) => Some(9),
            "02" | "03" | "04" if theirs.starts_with("min=00") => Some(10),
            "05" | "06" | "07" if theirs.starts_with("min=") => Some(10),
            "05" if address == "1018" => Some(12),
            _ => None,
        }
    });
    causes.try_fold(None, |first: Option<usize>, cause| Some(first.or(Some(cause?)))).flatten()
}

/// Whether a column ends with the highest number of a signed type.
fn is_largest(column: &str) -> bool {
    let digits = column.rsplit('=').next().unwrap_or_default();
    digits.strip_suffix("7F").is_some_and(|rest| rest.chars().all(|digit| digit == 'F'))
}

/// The rows by index and sub-index.
fn by_address(printed: &str) -> BTreeMap<String, &str> {
    let address = |row: &str| {
        let parts = if row.starts_with("device") { 1 } else { 2 };
        row.split(' ').take(parts).collect::<Vec<_>>().join(" ")
    };
    printed.lines().map(|row| (address(row), row)).collect()
}

/// The EDS or DCF of a device.
fn file_of(name: &str) -> Option<PathBuf> {
    let fixtures = crate::support::good_devices().into_iter();
    let mut files = fixtures.filter(|path| path.ends_with(name)).chain([PathBuf::from(name)]);
    let is_text =
        |path: &PathBuf| path.extension().is_some_and(|extension| extension == "eds" || extension == "dcf");
    files.find(|path| path.is_file() && is_text(path))
}

#[test]
fn dcf2c_writes_the_same() {
    let Some(library) = Library::build() else { return };
    let [rows, files] = [const { AtomicUsize::new(0) }; 2];
    let explained = CAUSES.map(|_| AtomicUsize::new(0));
    for_all(&devices(), |(name, device)| {
        let info = device.device_info.as_ref();
        let Some(path) = file_of(name).filter(|_| info.is_none_or(|info| info.compact_pdo.unwrap_or(0) == 0))
        else {
            return Ok(()); // no file, or one with implicit PDOs, which dcf2c describes
        };
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let mut dcf2c = Command::new(library.path("dcf2c"));
        dcf2c.current_dir(folder.path()).arg(path).args(["theirs", "-o", "theirs.c"]);
        if succeed(&mut dcf2c, "").is_err() {
            return Ok(()); // it does not read the file
        }
        write(folder.path(), device, &Options { file_stem: "device".to_owned(), ..Options::default() });
        let print = |sources: &[&str]| library.print(folder.path(), "harness.c", sources, &["all"]);
        let Ok(theirs) = print(&["-w", "-DSDEV=theirs", "theirs.c"]) else {
            return Ok(()); // its output does not compile
        };
        let ours = print(&["-DSDEV=od_sdev", "device_sdev.c"])?;
        let (theirs, ours) = (by_address(&theirs), by_address(&ours));
        let only_theirs = theirs.keys().filter(|address| !ours.contains_key(*address));
        let mut differences: Vec<String> =
            only_theirs.map(|address| format!("only dcf2c: {address}")).collect();
        for (address, ours) in &ours {
            rows.fetch_add(1, Ordering::Relaxed);
            let theirs = theirs.get(address).copied();
            if theirs == Some(ours) {
                continue;
            }
            let cause = cause(device, theirs, ours);
            if let Some(cause) = cause {
                explained[cause].fetch_add(1, Ordering::Relaxed);
            }
            let is_fixture = !Path::new(name).is_absolute();
            if cause.is_none_or(|cause| is_fixture && cause >= IN_FIXTURES) {
                differences.push(format!("dcf2c: {theirs:?}\nours:  {ours}"));
            }
        }
        files.fetch_add(1, Ordering::Relaxed);
        differences.truncate(6);
        if differences.is_empty() { Ok(()) } else { Err(format!("{name}:\n{}", differences.join("\n"))) }
    });
    let [rows, files] = [rows, files].map(AtomicUsize::into_inner);
    for (cause, count) in CAUSES.iter().zip(explained) {
        eprintln!("{:6} rows differ: {cause}", count.into_inner());
    }
    eprintln!("of {rows} rows of {files} files");
    assert!(rows > 1_000, "only {rows} rows of {files} files were compared");
}

/// The loader refuses the fixtures, and with `OBJDICT_CORPUS_DIR` the files below that folder, that findings say it refuses, and no other.
#[test]
fn the_loader_refuses_what_findings_say() {
    let Some(library) = Library::with(&[]) else { return };
    let folder = tempfile::tempdir().unwrap();
    let program = library.program(folder.path(), "loaded.c", &[]).unwrap();
    let corpus = std::env::var_os("OBJDICT_CORPUS_DIR").map(PathBuf::from);
    let folders = corpus.into_iter().chain([crate::support::fixtures()]);
    let paths: Vec<PathBuf> =
        folders.flat_map(|folder| crate::support::files_below(&folder, &["eds", "dcf"])).collect();
    let mut options = objdict::lint::Options::default();
    options.tools.push(Tool::Lely);
    let (mut refused, mut wrong) = (0, Vec::new());
    for path in &paths {
        let Ok(description) = format::open(path, &SourceOptions::default()) else { continue };
        let findings = objdict::check_with(&description, &options);
        let is_claimed = findings.iter().any(|finding| finding.rule.id == "portability/unloadable");
        let output = Command::new(&program).arg("5").arg(path).output().unwrap();
        if output.status.success() == is_claimed {
            wrong.push(format!("{}: claimed {is_claimed}", path.display()));
        }
        refused += usize::from(is_claimed);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(refused > 30, "only {refused} of {} files are refused", paths.len());
}
