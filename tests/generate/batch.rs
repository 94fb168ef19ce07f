//! Rust programs compiled together: starting compiler and linker takes longer than compiling a generated
//! table.

use std::collections::BTreeMap;
use std::fmt::{Debug, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

use objdict::generate::{Generated, Options, Target, generate};
use objdict::model::Device;
use tempfile::TempDir;

use crate::compile::{rustc, succeed};
use crate::devices::{arbitrary_devices, devices};
use crate::verdicts::Key;
use crate::{defaults, handles};

/// Header of the combined program. Tables must work without the standard library; the drivers may use it.
const ROOT: &str = "#![no_std]\n#[macro_use]\nextern crate std;\n";

/// Header of each program.
const PRELUDE: &str = "#[allow(unused_imports)]\nuse std::{string::String, vec::Vec};\n";

/// A program about a table, which it has as `mod od { include!("od.rs"); }`.
pub(crate) struct Part {
    name: String,
    source: String,
    key: Key,
    allowed: &'static str,
}

impl Part {
    /// The name is in the path of compiler errors, if it is the first about its table. The verdict about what the program
    /// prints may depend on the expected value, which includes the input, and on nothing else.
    #[track_caller]
    pub(crate) fn new(name: &str, source: &str, expected: &dyn Debug) -> Self {
        let mut key = Key::new();
        key.debug(expected);
        Self::with(name, source, key)
    }

    /// A program whose verdict depends on more.
    pub(crate) fn with(name: &str, source: &str, key: Key) -> Self {
        Self { name: name.to_owned(), source: source.to_owned(), key, allowed: "unused_imports" }
    }

    /// Allows these lints too.
    pub(crate) fn allowing(self, allowed: &'static str) -> Self {
        Self { allowed, ..self }
    }

    /// The source as a module beside the table.
    fn module(&self) -> String {
        let (before, table) = self.source.split_once("mod od {").unwrap();
        let (table, behind) = table.split_once('}').unwrap();
        assert_eq!(table.trim(), "include!(\"od.rs\");");
        let behind = behind.replace("fn main()", "pub(crate) fn main()");
        format!("{PRELUDE}{before}use super::od;{behind}")
    }
}

/// Modules of one program, each with a table and the parts about it, whose `main` functions are selected by the first
/// argument. Parts whose verdicts are in the record are not in the program.
pub(crate) struct Batch {
    folder: PathBuf,
    /// Removed in the end.
    _temporary: Option<TempDir>,
    flags: Vec<String>,
    modules: String,
    calls: String,
    /// For each name its key, and whether the record has it.
    keys: BTreeMap<String, (Key, bool)>,
}

impl Batch {
    /// A program that is compiled with these flags.
    pub(crate) fn new(flags: &[&str]) -> Self {
        let temporary = tempfile::tempdir().unwrap();
        let batch = Self::at(temporary.path().to_owned(), flags);
        Self { _temporary: Some(temporary), ..batch }
    }

    fn at(folder: PathBuf, flags: &[&str]) -> Self {
        Self {
            folder,
            _temporary: None,
            flags: flags.iter().map(|&flag| flag.to_owned()).collect(),
            modules: ROOT.to_owned(),
            calls: String::new(),
            keys: BTreeMap::new(),
        }
    }

    /// Adds a program.
    #[track_caller]
    pub(crate) fn add(&mut self, name: &str, generated: &Generated, source: &str, expected: &dyn Debug) {
        self.add_parts(generated, vec![Part::new(name, source, expected)]);
    }

    /// Adds programs about one table.
    pub(crate) fn add_parts(&mut self, generated: &Generated, mut parts: Vec<Part>) {
        let [table] = &*generated.files else { panic!("one file") };
        let number = self.keys.len();
        parts.retain_mut(|Part { name, source, key, allowed }| {
            key.tool(rustc(&self.folder).args(&self.flags));
            key.add(&table.contents);
            key.debug(&(source, allowed));
            let is_kept = key.is_kept();
            self.keys.insert(name.clone(), (key.clone(), is_kept));
            !is_kept
        });
        let Some(first) = parts.first() else { return };
        let file =
            Path::new(&first.name).file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let words = file.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        let module = format!("of_{number}_{}", words.collect::<Vec<_>>().join("_"));
        let folder = self.folder.join(&module);
        std::fs::create_dir(&folder).unwrap();
        std::fs::write(folder.join("od.rs"), &table.contents).unwrap();
        let mut main = String::from("mod od { include!(\"od.rs\"); }\n");
        for (at, part) in parts.iter().enumerate() {
            std::fs::write(folder.join(format!("part_{at}.rs")), part.module()).unwrap();
            writeln!(
                main,
                "#[allow({})]\n#[path = \"part_{at}.rs\"]\npub(crate) mod part_{at};",
                part.allowed
            )
            .unwrap();
            writeln!(self.calls, "        {:?} => {module}::part_{at}::main(),", part.name).unwrap();
        }
        std::fs::write(folder.join("main.rs"), main).unwrap();
        writeln!(self.modules, "#[path = \"{module}/main.rs\"]\nmod {module};").unwrap();
    }

    /// Compiles all programs that the record lacks.
    pub(crate) fn build(&self) {
        let Self { modules, calls, .. } = self;
        if calls.is_empty() {
            return;
        }
        let all = format!(
            "{modules}\nfn main() {{\n    match std::env::args().nth(1).unwrap().as_str() {{\n{calls}        \
             name => panic!(\"{{name}}\"),\n    }}\n}}\n"
        );
        std::fs::write(self.folder.join("all.rs"), all).unwrap();
        let built = succeed(rustc(&self.folder).args(&self.flags).args(["-o", "all", "all.rs"]), "");
        built.unwrap_or_else(|error| panic!("{error}"));
    }

    /// Compares what a program prints, unless the record has that it passed.
    pub(crate) fn check(
        &self,
        name: &str,
        input: &str,
        compare: impl FnOnce(&str) -> Result<(), String>,
    ) -> Result<(), String> {
        let (key, is_kept) = &self.keys[name];
        if *is_kept {
            return Ok(());
        }
        compare(&succeed(Command::new(self.folder.join("all")).arg(name), input)?)?;
        key.keep();
        Ok(())
    }
}

/// The tables of all devices without options, with the programs of several tests: a table is compiled once for all of
/// them. The name of a program is its test and the device.
pub(crate) static TABLES: LazyLock<Batch> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("generate-tables");
    std::fs::remove_dir_all(&folder).ok();
    std::fs::create_dir_all(&folder).unwrap();
    let mut batch = Batch::at(folder, &[]);
    let mut add = |device: &Device, parts: fn(&str, &Device, &Generated) -> Vec<Part>, name: &str| {
        let generated = generate(device, Target::RUST, &Options::default()).unwrap();
        batch.add_parts(&generated, parts(name, device, &generated));
    };
    for (name, device) in devices() {
        let parts = |name: &str, device: &Device, generated: &Generated| {
            vec![
                crate::answers(name, device),
                handles::part(name, device, generated),
                defaults::part(name, device, generated),
            ]
        };
        add(&device, parts, &name);
    }
    for (name, device) in arbitrary_devices(8) {
        add(&device, |name, device, _| vec![crate::answers(name, device)], &name);
    }
    let services =
        |name: &str, device: &Device, generated: &Generated| vec![defaults::part(name, device, generated)];
    add(&defaults::odd(), services, "services");
    batch.build();
    batch
});
