//! The report of sizes says what the compilers make of the tables.

use std::process::Command;

use objdict::generate::{Options, SizeReport, Sizes, Target, size};
use objdict::model::Device;

use crate::compile::{c_compiler, cc, generate_into, rustc, succeed};
use crate::{device, odd, support};

const RUST: &str = r#"
mod od {
    include!(env!("OD_RS"));
}

fn main() {
    println!("{} {}", size_of_val(&od::ENTRIES), size_of::<od::Data>());
}
"#;

const C: &str = r#"
#include <stdio.h>
#include "od.c"

int main(void)
{
    printf("%lu %lu\n", (unsigned long)(OD_ENTRY_COUNT * sizeof(od_entry_t) + OD_ROM_SIZE), (unsigned long)sizeof(od_data_t));
    return 0;
}
"#;

fn report(device: &Device, target: &str) -> SizeReport {
    match size(device, Target::named(target).unwrap(), &Options::default()).unwrap() {
        Sizes::Known(report) => report,
        Sizes::Unknown(why) => panic!("no sizes of `{target}`: {why}"),
    }
}

fn devices() -> Vec<(&'static str, Device)> {
    let fixture = |name: &'static str| (name, device(&support::fixtures().join("eds").join(name)));
    let names = ["minimal.eds", "io-401.eds", "all-types.eds", "manager-302.eds"];
    names.into_iter().map(fixture).chain([("odd", odd::device()), ("constant", odd::constant())]).collect()
}

#[test]
fn sizes_are_those_of_the_compilers() {
    for (name, device) in devices() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        generate_into(folder, &device, "rust");
        std::fs::write(folder.join("size.rs"), RUST).unwrap();
        succeed(rustc(folder).args(["-Adead-code", "size.rs", "-o", "in-rust"]), "").unwrap();
        let output = succeed(&mut Command::new(folder.join("in-rust")), "").unwrap();
        let in_rust = report(&device, "rust").total;
        let numbers: Vec<usize> = output.split_whitespace().map(|word| word.parse().unwrap()).collect();
        let rom = in_rust.flash - numbers[0];
        assert_eq!(in_rust.ram, numbers[1], "{name}, Rust");

        let Some(compiler) = c_compiler() else { continue };
        generate_into(folder, &device, "c");
        std::fs::write(folder.join("size.c"), C).unwrap();
        let in_c = report(&device, "c").total;
        succeed(cc(&compiler, folder).args(["-I.", "-o", "in-c", "size.c"]), "").unwrap();
        let output = succeed(&mut Command::new(folder.join("in-c")), "").unwrap();
        assert_eq!(output.trim(), format!("{} {}", in_c.flash, in_c.ram), "{name}, C");
        let rows: usize = report(&device, "c").objects.iter().map(|object| object.entries).sum();
        let rows_in_c = in_c.flash - rom; // the same defaults and limits in both
        assert!(
            [10, 16].contains(&(rows_in_c / rows)) && rows_in_c.is_multiple_of(rows),
            "{name}: {rows_in_c}"
        );
    }
}

#[test]
fn the_objects_make_up_the_total() {
    for (name, device) in devices() {
        for target in ["rust", "c"] {
            let SizeReport { objects, rest, total, .. } = report(&device, target);
            let flash: usize = objects.iter().map(|object| object.size.flash).sum();
            let ram: usize = objects.iter().map(|object| object.size.ram).sum();
            assert_eq!((flash + rest.flash, ram + rest.ram), (total.flash, total.ram), "{name}, {target}");
            assert!(rest.flash <= 1 && rest.ram < 32, "{name}, {target}: {rest:?}");
        }
    }
}
