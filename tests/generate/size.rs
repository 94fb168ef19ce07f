//! The size report agrees with the compilers.

use objdict::generate::{Options, SizeReport, Sizes, Target, generate, size};
use objdict::model::Device;

use crate::batch::Batch;
use crate::compile::{c_compiler, cc, generate_into};
use crate::processors::host;
use crate::{device, odd, support};

/// Prints the sizes of rows and values.
pub(crate) const RUST: &str = r#"
mod od {
    include!("od.rs");
}

fn main() {
    println!("{} {}", size_of_val(&od::ENTRIES), size_of::<od::Data>());
}
"#;

/// Prints the sizes in flash and in RAM.
pub(crate) const C: &str = r#"
#include <stdio.h>
#include "od.c"

int main(void)
{
    printf("%lu %lu\n", (unsigned long)(sizeof od_entries + sizeof od_kinds + sizeof od_objects + sizeof od_rom), (unsigned long)sizeof(od_data_t));
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
    // defaults and limits are the same in both languages, so what C reports without its rows is what Rust has beside its own
    let printed = |device: &Device| {
        let SizeReport { total: in_rust, code, .. } = report(device, "rust");
        let SizeReport { total: in_c, objects, rest, .. } = report(device, "c");
        let rows: usize = objects.iter().map(|object| object.entries).sum();
        let rom = in_c.flash - (6 * rows + 4 * objects.len() + rest.flash);
        format!("{} {}\n", in_rust.flash - code - rom, in_rust.ram)
    };
    let mut batch = Batch::new(&["-Adead-code"]);
    for (name, device) in devices() {
        let generated = generate(&device, Target::RUST, &Options::default()).unwrap();
        batch.add(name, &generated, RUST, &printed(&device));
    }
    batch.build();
    for (name, device) in devices() {
        let expected = printed(&device);
        let compare = |output: &str| match output == expected {
            true => Ok(()),
            false => Err(format!("{name}, Rust: {output} where {expected} was expected")),
        };
        batch.check(name, "", compare).unwrap();

        let Some(compiler) = c_compiler() else { continue };
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path();
        generate_into(folder, &device, "c");
        std::fs::write(folder.join("size.c"), C).unwrap();
        let in_c = report(&device, "c").total;
        let programs = host(cc(&compiler, folder).args(["-I.", "-o", "in-c", "size.c"]));
        let expected = format!("{} {}\n", in_c.flash, in_c.ram);
        programs.expect(&[], &expected).unwrap_or_else(|error| panic!("{name}, C: {error}"));
    }
}

#[test]
fn the_objects_make_up_the_total() {
    for (name, device) in devices() {
        for target in ["rust", "c"] {
            let SizeReport { objects, rest, code, total, .. } = report(&device, target);
            let flash: usize = objects.iter().map(|object| object.size.flash).sum();
            let ram: usize = objects.iter().map(|object| object.size.ram).sum();
            assert_eq!(
                (flash + rest.flash + code, ram + rest.ram),
                (total.flash, total.ram),
                "{name}, {target}"
            );
            let kinds = if target == "c" { 160 } else { 0 }; // pairs of data type and flags, 2 bytes each
            assert!(rest.flash <= 1 + kinds && rest.ram < 32, "{name}, {target}: {rest:?}");
        }
    }
}
