//! What Rust tables take on a Cortex-M4: core is built with the compiler of Debian (`rustc-web`, `rust-web-src`), and
//! each device is linked alone. Without these packages the test is skipped, or fails with `CI=true`.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};

use objdict::generate::{Options, SizeReport, Sizes, Target, size};
use objdict::model::Device;

use crate::compile::{generate_into, succeed};
use crate::stacks::figures;
use crate::support::skips::{has, skip_unless_ci};
use crate::verdicts::Key;
use crate::{device, odd, support};

const RUSTC: &str = "/usr/bin/rustc";
const TARGET: &str = "thumbv7em-none-eabihf";
const LINKER: &str = "arm-none-eabi-ld";

/// The promise: the code for any device.
const MOST: usize = 3 * 1024;

pub(crate) const MANIFEST: &str = "[package]\nname = \"tables\"\nversion = \"0.0.0\"\nedition = \"2021\"\n
[lib]\ncrate-type = [\"staticlib\"]\n
[profile.release]\nopt-level = \"s\"\npanic = \"abort\"\ncodegen-units = 1\nlto = \"off\"\n\n[workspace]\n";

pub(crate) const HEAD: &str =
    "#![no_std]\n#[panic_handler]\nfn panic(_: &core::panic::PanicInfo) -> ! { loop {} }\n";

/// Whether the compilers are here.
pub(crate) fn can_build() -> bool {
    let has_core = Path::new("/usr/lib/rustlib/src/rust/library/core").is_dir();
    if !has_core {
        skip_unless_ci("no sources of core: install the package `rust-web-src`");
    }
    has_core && has(RUSTC, "rustc-web") && has(LINKER, "binutils-arm-none-eabi")
}

/// Devices with few and many entries, with and without limits and texts.
fn devices() -> Vec<(&'static str, Device)> {
    let fixture = |name: &'static str| (name, device(&support::fixtures().join("eds").join(name)));
    let names = ["minimal.eds", "io-401.eds", "all-types.eds", "manager-302.eds"];
    let large = ("1,028 entries", figures::device(600, 107));
    names.into_iter().map(fixture).chain([("odd", odd::device()), large]).collect()
}

/// The functions of an SDO server for a device.
fn functions(number: usize) -> String {
    format!(
        "mod od{number} {{
    include!(\"od{number}/od.rs\");
    #[no_mangle] pub fn new_{number}(data: &mut Data, node_id: u8) {{ *data = Data::new(node_id); }}
    #[no_mangle] pub fn read_{number}(data: &Data, index: u16, sub: u8, buffer: &mut [u8]) -> Result<usize, Abort> {{
        data.read(index, sub, buffer)
    }}
    #[no_mangle] pub fn write_{number}(data: &mut Data, index: u16, sub: u8, bytes: &[u8]) -> Result<(), Abort> {{
        data.write(index, sub, bytes)
    }}
}}\n"
    )
}

/// Typed access to an entry of the first device.
const HANDLES: &str = "
#[no_mangle] pub fn get(data: &od0::Data) -> u16 { data.get(od0::PRODUCER_HEARTBEAT_TIME) }
#[no_mangle] pub fn put(data: &mut od0::Data, value: u16) { data.put(od0::PRODUCER_HEARTBEAT_TIME, value) }
";

/// Builds the devices, optimised at link time with core or not; returns the archive. Core is built once for both, which takes
/// 30 seconds: as machine code and as bitcode.
pub(crate) fn build(folder: &Path, lto: &str) -> Result<PathBuf, String> {
    // all have the same name there
    static ONE: Mutex<()> = Mutex::new(());
    let _one = ONE.lock().unwrap_or_else(PoisonError::into_inner);
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("thumb");
    let mut cargo = Command::new(std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    cargo.args(["rustc", "--quiet", "--release", "-Zbuild-std=core", "--target", TARGET]);
    cargo
        .args(["--", &format!("-Clto={lto}")])
        .current_dir(folder)
        .env("RUSTC", RUSTC)
        .env("RUSTC_BOOTSTRAP", "1")
        .env("CARGO_TARGET_DIR", &target)
        .env("RUSTFLAGS", "-Cembed-bitcode=yes");
    succeed(&mut cargo, "")?;
    let archive = folder.join(format!("{lto}.a"));
    let built = target.join(TARGET).join("release/libtables.a");
    std::fs::copy(built, &archive).map_err(|error| error.to_string())?;
    Ok(archive)
}

/// Links functions of the archive; returns the size of each symbol, and of all.
pub(crate) fn link(folder: &Path, archive: &Path, roots: &[String]) -> (Vec<(String, usize)>, usize) {
    let undefined = roots.iter().flat_map(|root| ["-u", root]);
    let mut ld = Command::new(LINKER);
    ld.current_dir(folder)
        .args(["--gc-sections", "-e", &roots[0], "-o", "out.elf"])
        .args(undefined)
        .arg(archive);
    succeed(&mut ld, "").unwrap();
    let symbols =
        succeed(Command::new("arm-none-eabi-nm").args(["-S", "out.elf"]).current_dir(folder), "").unwrap();
    let symbols = symbols.lines().filter_map(|line| {
        let [_, size, _, name] = line.split_whitespace().collect::<Vec<_>>()[..] else { return None };
        Some((name.to_owned(), usize::from_str_radix(size, 16).unwrap()))
    });
    let sizes = succeed(Command::new("arm-none-eabi-size").arg("out.elf").current_dir(folder), "").unwrap();
    let text = sizes.lines().nth(1).unwrap().split_whitespace().next().unwrap().parse().unwrap();
    (symbols.collect(), text)
}

/// What decides about the verdict, except for the sizes that are reported.
#[track_caller]
pub(crate) fn key(folder: &Path) -> Key {
    let mut key = Key::new();
    key.folder(folder);
    for program in [RUSTC, LINKER, "cargo", "arm-none-eabi-nm", "arm-none-eabi-size"] {
        key.tool(&Command::new(program));
    }
    key
}

#[test]
fn the_code_is_small_for_any_device_and_a_handle_is_a_load() {
    if !can_build() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::create_dir(folder.join("src")).unwrap();
    std::fs::write(folder.join("Cargo.toml"), MANIFEST).unwrap();
    let mut source = HEAD.to_owned();
    let devices = devices();
    for (number, (_, device)) in devices.iter().enumerate() {
        let module = folder.join(format!("src/od{number}"));
        std::fs::create_dir(&module).unwrap();
        generate_into(&module, device, "rust");
        source.push_str(&functions(number));
    }
    write!(source, "{HANDLES}").unwrap();
    std::fs::write(folder.join("src/lib.rs"), source).unwrap();
    let reports =
        devices.iter().map(|(name, device)| match size(device, Target::RUST, &Options::default()).unwrap() {
            Sizes::Known(report) => (*name, report),
            Sizes::Unknown(why) => panic!("{name}: {why}"),
        });
    let reports: Vec<(&str, SizeReport)> = reports.collect();
    let mut key = key(folder);
    key.debug(&reports);
    key.or_try(|| {
        let archives = [build(folder, "fat")?, build(folder, "off")?];
        check_functions(folder, &archives, reports.len());
        check_sizes(folder, &reports)
    })
    .unwrap();
}

/// Links each device in a program of its own, as firmware does.
fn check_sizes(folder: &Path, reports: &[(&str, SizeReport)]) -> Result<(), String> {
    let mut most = 0;
    for (number, (name, SizeReport { total, code, .. })) in reports.iter().enumerate() {
        let roots = ["new", "read", "write"].map(|root| format!("{root}_{number}"));
        std::fs::write(folder.join("src/lib.rs"), [HEAD, &functions(number)].concat()).unwrap();
        let (_, flash) = link(folder, &build(folder, "fat")?, &roots);
        let wrong = total.flash.abs_diff(flash) * 100;
        assert!(wrong <= 2 * flash, "{name}: {flash} bytes of flash, {} reported", total.flash);
        most = most.max(flash + code - total.flash);
    }
    assert!((1..=MOST).contains(&most), "{most} bytes of code");
    Ok(())
}

fn check_functions(folder: &Path, archives: &[PathBuf], devices: usize) {
    let handles = ["get", "put"].map(str::to_owned);
    let roots: Vec<_> = (0..devices)
        .flat_map(|number| ["new", "read", "write"].map(|root| format!("{root}_{number}")))
        .chain(handles.clone())
        .collect();
    // without optimisation at link time, core stays as it is
    for archive in archives {
        let (symbols, _) = link(folder, archive, &roots);
        for handle in &handles {
            let (_, size) = symbols.iter().find(|(name, _)| name == handle).unwrap();
            assert!(*size <= 12, "`{handle}` has {size} bytes");
        }
        let panic = symbols.iter().find(|(name, _)| name.contains("panic"));
        assert_eq!(panic, None, "a function that panics");
    }
}
