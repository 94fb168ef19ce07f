//! The compiled size of generated files for a 32-bit processor: a Cortex-M4 if its compiler is installed,
//! else the host with the alignment of a Cortex-M4.

use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;

use crate::compile::{c_compiler, succeed};
use crate::processors::{CORTEX_M4, CORTEX_M4_FLAGS, builds_for_32_bits, compiles_for_cortex_m4};
use crate::verdicts::Key;

/// Sizes in object files, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Measured {
    /// Constants and initial values.
    pub(crate) flash: usize,
    /// Variables.
    pub(crate) ram: usize,
    /// Functions, including the tables of `switch` statements.
    pub(crate) code: usize,
}

/// A 32-bit compiler and its tools.
pub(crate) struct Tools {
    compiler: Box<dyn Fn(&Path) -> Command + Sync>,
    nm: &'static str,
    objdump: &'static str,
}

/// The tools for a Cortex-M4, else for 32 bits; `None` if neither is installed.
pub(crate) fn tools() -> Option<Tools> {
    if compiles_for_cortex_m4() {
        let compiler = Box::new(|folder: &Path| {
            let mut command = Command::new(CORTEX_M4);
            command.current_dir(folder).args(CORTEX_M4_FLAGS).arg("-Os");
            command
        });
        return Some(Tools { compiler, nm: "arm-none-eabi-nm", objdump: "arm-none-eabi-objdump" });
    }
    let name = c_compiler().filter(|name| builds_for_32_bits(OsStr::new(name)))?;
    let compiler = Box::new(move |folder: &Path| {
        let mut command = Command::new(&name);
        command.current_dir(folder).args([
            "-m32",
            "-malign-double",
            "-fshort-enums",
            "-fno-pic",
            "-Os",
            "-c",
        ]);
        command.arg("-DBOOL_T=uint32_t");
        command
    });
    Some(Tools { compiler, nm: "nm", objdump: "objdump" })
}

impl Tools {
    /// The compiler command that creates an object file of each source.
    pub(crate) fn cc(&self, folder: &Path) -> Command {
        let mut command = (self.compiler)(folder);
        command.arg("-DOD_NO_NAMES"); // which a linker also removes
        command
    }

    /// Adds what decides about a measurement, except for the command of the compiler.
    pub(crate) fn add_to(&self, key: &mut Key) {
        key.add(include_str!("measure.rs"));
        for program in [self.nm, self.objdump] {
            key.tool(&Command::new(program));
        }
    }

    /// Measures all object files of a folder.
    pub(crate) fn measure(&self, folder: &Path) -> Result<Measured, String> {
        let files = std::fs::read_dir(folder).map_err(|error| error.to_string())?;
        let objects: Vec<_> = files
            .map(|file| file.unwrap().path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "o"))
            .collect();
        let symbols = succeed(Command::new(self.nm).args(["-S", "--defined-only"]).args(&objects), "")?;
        let sections = succeed(Command::new(self.objdump).arg("-h").args(&objects), "")?;
        let mut measured = Measured::default();
        symbols.lines().for_each(|line| measured.symbol(line));
        sections.lines().for_each(|line| measured.literals(line));
        Ok(measured)
    }
}

impl Measured {
    /// A line of nm: address, size, kind and name.
    fn symbol(&mut self, line: &str) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let &[_, size, kind, name] = words.as_slice() else { return };
        let size = usize::from_str_radix(size, 16).unwrap();
        match kind.to_ascii_lowercase().as_str() {
            // the state of CanFestival, whose length the configuration of the stack decides
            _ if ["od_Data", "od_PDO_status", "od_heartBeatTimers"].contains(&name) => {}
            // layouts of images belong to the functions, because the compiler inlines parts of them
            "r" if name.starts_with("CSWTCH") || name.ends_with("_kept") => self.code += size,
            "r" => self.flash += size,
            "d" => {
                self.flash += size;
                self.ram += size;
            }
            "b" => self.ram += size,
            "t" => self.code += size,
            _ => panic!("what is `{line}`?"),
        }
    }

    /// A line of objdump: number, name and size of a section. Literals have no symbols.
    fn literals(&mut self, line: &str) {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let &[_, name, size, ..] = words.as_slice()
            && name.starts_with(".rodata")
            && name.contains(".str")
        {
            self.flash += usize::from_str_radix(size, 16).unwrap();
        }
    }
}
