//! The size report agrees with the compiler to the byte, for every C target.

use std::path::Path;
use std::process::Command;

use objdict::generate::{CTable, Options, SizeReport, Sizes, StorageGroup, Target, generate, size};
use objdict::model::Device;

use crate::compile::succeed;
use crate::devices::{arbitrary_devices, devices, for_all};
use crate::stacks::beside;
use crate::stacks::measure::{Tools, tools};
use crate::verdicts::Key;

/// A target with options, and the folder of its declarations.
struct Case {
    target: &'static str,
    declarations: &'static str,
    options: fn(&mut Options),
}

const CASES: [Case; 10] = [
    Case { target: "c", declarations: "c_structs", options: |_| {} },
    Case { target: "c", declarations: "c_structs", options: |options| options.table = CTable::Structs },
    Case {
        target: "c",
        declarations: "c_structs",
        options: |options| {
            options.table = CTable::Structs;
            options.entry_names = false;
        },
    },
    Case { target: "canopennode", declarations: "canopennode/include", options: |_| {} },
    Case {
        target: "canopennode",
        declarations: "canopennode/include",
        options: |options| options.limits = true,
    },
    Case {
        target: "canopen-stack",
        declarations: "canopen_stack/include",
        options: |options| {
            let group = |text: &str| text.parse::<StorageGroup>().unwrap();
            options.groups = vec![group("1000-1FFF=COMM"), group("2000-9FFF=APP"), group("2100=ram")];
        },
    },
    Case { target: "canopennode-v1", declarations: "canopennode_v1/include", options: |_| {} },
    Case { target: "canfestival", declarations: "canfestival/include", options: |_| {} },
    Case { target: "microcanopen", declarations: "microcanopen/include", options: |_| {} },
    Case { target: "objdict-macros", declarations: "objdict_macros", options: |_| {} },
];

/// A row of limits of `canopennode`.
const ONLY_LIMIT: usize = 24;

impl Case {
    fn options(&self, node_id: Option<u8>) -> Options {
        let mut options = Options::default();
        options.node_id = node_id;
        (self.options)(&mut options);
        options
    }

    /// The compiler of the files; for plain `c`, also of a variable for the values, which the application defines.
    fn compiler(&self, tools: &Tools, folder: &Path, device: &Device, options: &Options) -> Command {
        let target = Target::named(self.target).unwrap();
        let mut cc = tools.cc(folder);
        cc.arg("-I.").arg(format!("-I{}", beside(self.declarations, "").display()));
        for file in generate(device, target, options).unwrap().files {
            std::fs::write(folder.join(&file.path), &file.contents).unwrap();
            let is_scaffold = file.path.ends_with("_spec.c");
            if file.path.ends_with(".c") && !is_scaffold {
                cc.arg(file.path);
            }
        }
        if self.target == "c" && options.table == CTable::Compact {
            std::fs::write(folder.join("data.c"), "#include \"od.h\"\nod_data_t data;\n").unwrap();
            cc.arg("data.c");
        }
        cc
    }
}

fn report(device: &Device, target: &str, options: &Options) -> SizeReport {
    match size(device, Target::named(target).unwrap(), options).unwrap() {
        Sizes::Known(report) => report,
        Sizes::Unknown(why) => panic!("no sizes of `{target}`: {why}"),
    }
}

#[test]
fn the_report_is_what_the_compiler_makes_of_the_files() {
    let Some(tools) = tools() else { return };
    let mut devices = [devices(), arbitrary_devices(8)].concat();
    // a name of it is like those of layouts, which are measured as code
    devices.retain(|(name, _)| name != "words");
    for_all(&devices, |(name, device)| {
        let mut key = Key::new();
        tools.add_to(&mut key);
        let mut compilers = Vec::new();
        for (number, case) in CASES.iter().enumerate() {
            let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
            let options = case.options((number % 2 == 0).then_some(5));
            let total = report(device, case.target, &options).total;
            let cc = case.compiler(&tools, folder.path(), device, &options);
            key.command(&cc);
            key.debug(&total);
            compilers.push((folder, options, total, cc));
        }
        key.or_try(|| {
            compilers.iter_mut().enumerate().try_for_each(|(number, (folder, options, total, cc))| {
                let fail = |error: String| format!("{name}, {} ({number}): {error}", CASES[number].target);
                succeed(cc, "").map_err(fail)?;
                let measured = tools.measure(folder.path()).map_err(fail)?;
                if options.limits && total.flash == measured.flash + ONLY_LIMIT {
                    total.flash = measured.flash; // the compiler inlines the only row
                }
                match (total.flash, total.ram) == (measured.flash, measured.ram) {
                    true => Ok(()),
                    false => Err(fail(format!("{total:?} reported, {measured:?} measured"))),
                }
            })
        })
    });
}

/// Some targets report why their sizes are unknown.
#[test]
fn where_sizes_are_not_known_the_reason_is() {
    let device = crate::odd::device();
    for target in Target::all() {
        match size(&device, target, &Options::default()).unwrap() {
            Sizes::Known(report) => {
                assert!(!report.counted.is_empty());
                let mut sum = report.objects.iter().fold(report.rest, |sum, object| sum + object.size);
                sum.flash += report.code;
                assert_eq!(sum, report.total, "{}", target.name());
            }
            Sizes::Unknown(why) => {
                assert!(why.starts_with(char::is_lowercase) && !why.ends_with('.'), "{why}");
            }
        }
    }
}
