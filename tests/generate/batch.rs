//! Programs in Rust that are compiled at once: a start of the compiler and of the linker takes longer than a generated table.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use objdict::generate::Generated;
use tempfile::TempDir;

use crate::compile::{rustc, succeed};

/// What the program of all begins with. Tables have to do without the standard library; the drivers around them need not.
const ROOT: &str = "#![no_std]\n#[macro_use]\nextern crate std;\n";

/// What each program begins with.
const PRELUDE: &str = "#[allow(unused_imports)]\nuse std::{string::String, vec::Vec};\n";

/// Modules of one program, each with a `main`; its first argument says whose is called.
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

    /// Adds a program by a name, which what the compiler complains of has in its path. What was generated stands beside it,
    /// so it takes a table in with `include!("od.rs")`.
    pub(crate) fn add(&mut self, name: &str, generated: &Generated, source: &str) {
        let module = name.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
        let module = format!("of_{}_{module}", self.count);
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

    /// Compiles all of them.
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

    /// What a program prints.
    pub(crate) fn run(&self, name: &str, input: &str) -> Result<String, String> {
        succeed(Command::new(self.path().join("all")).arg(name), input)
    }

    fn path(&self) -> &Path {
        self.folder.path()
    }
}
