//! Rust programs compiled together: starting compiler and linker takes longer than compiling a generated
//! table.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use objdict::generate::Generated;
use tempfile::TempDir;

use crate::compile::{rustc, succeed};

/// Header of the combined program. Tables must work without the standard library; the drivers may use it.
const ROOT: &str = "#![no_std]\n#[macro_use]\nextern crate std;\n";

/// Header of each program.
const PRELUDE: &str = "#[allow(unused_imports)]\nuse std::{string::String, vec::Vec};\n";

/// Modules of one program, each with a `main` function selected by the first argument.
pub(crate) struct Batch {
    folder: TempDir,
    modules: String,
    calls: String,
    count: usize,
}

impl Batch {
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        Self { folder, modules: ROOT.to_owned(), calls: String::new(), count: 0 }
    }

    /// Adds a program; its name is in the path of compiler errors. The generated files are in the same
    /// folder, so the program can use `include!("od.rs")`.
    pub(crate) fn add(&mut self, name: &str, generated: &Generated, source: &str) {
        let file = Path::new(name).file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let words = file.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        let module = format!("of_{}_{}", self.count, words.collect::<Vec<_>>().join("_"));
        let folder = self.path().join(&module);
        std::fs::create_dir(&folder).unwrap();
        for file in &generated.files {
            std::fs::write(folder.join(&file.path), &file.contents).unwrap();
        }
        let source = source.replace("fn main()", "pub(crate) fn main()");
        std::fs::write(folder.join("main.rs"), format!("{PRELUDE}{source}")).unwrap();
        writeln!(self.modules, "#[path = \"{module}/main.rs\"]\nmod {module};").unwrap();
        writeln!(self.calls, "        {name:?} => {module}::main(),").unwrap();
        self.count += 1;
    }

    /// Compiles all programs.
    pub(crate) fn build(&self, flags: &[&str]) {
        let Self { modules, calls, .. } = self;
        let all = format!(
            "{modules}\nfn main() {{\n    match std::env::args().nth(1).unwrap().as_str() {{\n{calls}        \
             name => panic!(\"{{name}}\"),\n    }}\n}}\n"
        );
        std::fs::write(self.path().join("all.rs"), all).unwrap();
        let built = succeed(rustc(self.path()).args(flags).args(["-o", "all", "all.rs"]), "");
        built.unwrap_or_else(|error| panic!("{error}"));
    }

    /// Returns the output of a program.
    pub(crate) fn run(&self, name: &str, input: &str) -> Result<String, String> {
        succeed(Command::new(self.path().join("all")).arg(name), input)
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }
}
