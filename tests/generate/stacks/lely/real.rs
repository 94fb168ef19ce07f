//! With the library: `OBJDICT_LELY_DIR` names a checkout. Its loader takes the tables, and its generator dcf2c writes the same
//! ones but for its errors.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use objdict::generate::Options;
use objdict::model::Device;

use super::{LACKS, without_files, write};
use crate::compile::{c_compiler, succeed};
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::stacks::truth::{compare, truth, without};
use crate::stacks::{beside, checkout, for_node};

/// The library, compiled.
struct Library {
    compiler: String,
    checkout: PathBuf,
    folder: tempfile::TempDir,
}

impl Library {
    fn build() -> Option<Self> {
        let (checkout, compiler) = (checkout("OBJDICT_LELY_DIR")?, c_compiler()?);
        let library = Self { compiler, checkout, folder: tempfile::tempdir().unwrap() };
        let mut cc = library.cc(library.folder.path());
        cc.args(["-std=gnu99", "-D_GNU_SOURCE", "-w", "-c"]).arg("-I").arg(library.checkout.join("src"));
        for part in ["util", "libc", "co", "can"] {
            let files = std::fs::read_dir(library.checkout.join("src").join(part)).unwrap();
            let files = files.map(|file| file.unwrap().path());
            cc.args(files.filter(|path| path.extension().is_some_and(|extension| extension == "c")));
        }
        succeed(cc.arg(library.checkout.join("tools/dcf2c.c")), "").unwrap();
        let objects = std::fs::read_dir(library.folder.path()).unwrap().map(|file| file.unwrap().path());
        let objects: Vec<PathBuf> = objects.filter(|path| !path.ends_with("dcf2c.o")).collect();
        succeed(Command::new("ar").arg("rcs").arg(library.path("lely.a")).args(objects), "").unwrap();
        let mut link = library.cc(library.folder.path());
        succeed(link.args(["-o", "dcf2c", "dcf2c.o", "lely.a", "-lm", "-lpthread"]), "").unwrap();
        Some(library)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn cc(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.compiler);
        command.current_dir(folder).arg("-isystem").arg(self.checkout.join("include")).arg("-I.");
        command
    }

    /// Builds a program of the tests with a table, and returns what it prints.
    fn print(
        &self,
        folder: &Path,
        program: &str,
        sources: &[&str],
        arguments: &[&str],
    ) -> Result<String, String> {
        let mut cc = self.cc(folder);
        cc.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-o", "program"]).args(sources);
        cc.arg(beside("lely", program)).arg(self.path("lely.a")).args(["-lm", "-lpthread"]);
        succeed(&mut cc, "")?;
        succeed(Command::new(folder.join("program")).args(arguments), "")
    }
}

#[test]
fn the_library_loads_the_tables_for_any_node() {
    let Some(library) = Library::build() else { return };
    for_all(&[devices(), arbitrary_devices(12)].concat(), |(name, device)| {
        let device = &without_files(device);
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        write(folder.path(), device, &for_node(5));
        let fail = |error: String| format!("{name}: {error}");
        for node_id in [5, 127] {
            let arguments = [node_id.to_string()];
            let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
            let sources = ["-DSDEV=od_sdev", "device_sdev.c"];
            let printed = library.print(folder.path(), "loaded.c", &sources, &arguments).map_err(fail)?;
            compare(name, &without(&LACKS, truth(device, node_id)), &printed).map_err(fail)?;
        }
        Ok(())
    });
}

/// Whether a row differs only in what dcf2c loses or reads wrong: values of OCTET_STRINGs and DOMAINs, REALs, the end of
/// the name of a file, and the denotation and the flag of a configured value in compact storage.
fn is_error_of_dcf2c(device: &Device, theirs: &str, ours: &str) -> bool {
    let words = |line: &str| line.split(' ').map(str::to_owned).collect::<Vec<String>>();
    let (theirs, ours) = (words(theirs), words(ours));
    let index = theirs.first().and_then(|index| u16::from_str_radix(index, 16).ok());
    let is_compact =
        index.and_then(|index| device.object(index)).is_some_and(|object| object.compact.is_some());
    let data_type = theirs.get(2).map_or("", String::as_str);
    theirs.len() == ours.len()
        && theirs.iter().zip(&ours).enumerate().filter(|(_, (theirs, ours))| theirs != ours).all(
            |(at, (theirs, ours))| match data_type {
                _ if is_compact && (theirs.starts_with("name=") || theirs == "flags=0") => true,
                "0F" if *ours == format!("{theirs}00") => true, // the zero behind the name of a file
                "0A" | "0F" => (at == 5 || theirs.starts_with("def=")) && theirs.ends_with('-'),
                "08" | "11" => at == 5 || theirs.starts_with("def="),
                _ => false,
            },
        )
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
    let [rows, equal, files] = [const { AtomicUsize::new(0) }; 3];
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
        let mut differences = Vec::new();
        if theirs.lines().count() != ours.lines().count() {
            differences.push("dcf2c has other rows".to_owned());
        }
        for (theirs, ours) in theirs.lines().zip(ours.lines()) {
            rows.fetch_add(1, Ordering::Relaxed);
            if theirs == ours || is_error_of_dcf2c(device, theirs, ours) {
                equal.fetch_add(1, Ordering::Relaxed);
            } else {
                differences.push(format!("dcf2c: {theirs}\nours:  {ours}"));
            }
        }
        files.fetch_add(1, Ordering::Relaxed);
        differences.truncate(6);
        // files of others also have what only dcf2c misreads: `0x80+$NODEID`, `#` in a name, objects without lists
        let is_fixture = !Path::new(name).is_absolute();
        if is_fixture && !differences.is_empty() {
            return Err(format!("{name}:\n{}", differences.join("\n")));
        }
        Ok(())
    });
    let [rows, equal, files] = [rows, equal, files].map(AtomicUsize::into_inner);
    eprintln!("{equal} of {rows} rows of {files} files are those of dcf2c");
    assert!(rows > 1_000, "only {rows} rows of {files} files were compared");
}
