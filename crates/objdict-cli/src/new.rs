//! `objdict new`.

use std::io::Write;
use std::path::Path;

use super::args::{NewArgs, outputs};
use super::convert::losses;
use super::ending::{Failure, Outcome, note};
use super::input::{FileKind, name_of};
use super::stdout::Output;
use super::written_files::{is_stdout, keep, save};
use objdict_format as format;
use objdict_format::input::Reading;
use objdict_format::scaffold::{
    BaseError, FEATURES, Feature, Features, MIDNIGHT, NO_VENDOR, Wanted, now, scaffold,
};
use objdict_format::{ReadError, WriteOptions, json, object_table};
use objdict_model::diagnostic::plural;
use objdict_model::model::{ClockTime, Date, Device, PdoKind};
use objdict_model::source::{self, DEFAULT_MAX_SIZE};

pub(super) fn run(args: &NewArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let profile = profile(args)?;
    let table = args.from.as_ref().map(|path| table(args, path)).transpose()?;
    let identity = |sub| u32::try_from(table.as_ref()?.value(0x1018, sub)?.as_integer()?).ok();
    let vendor_id = args.vendor_id.or_else(|| identity(1));
    if vendor_id.is_none() {
        note(&format!("note: the vendor-ID is 0x{NO_VENDOR:08X}; set yours with `--vendor-id`\n"));
    }
    let (date, time) = date_and_time(args.date)?;
    let name = args.output.file_name().unwrap_or_default().to_string_lossy();
    let is_stdout = is_stdout(&args.output);
    let by_name = if is_stdout { Some(FileKind::Eds) } else { FileKind::of(&args.output) };
    let Some(kind) = args.to.or(by_name) else {
        let message = format!("`{}` has no extension of a known format", name_of(&args.output));
        return Err(Failure::new(message).help(outputs_help()));
    };
    let wanted = Wanted {
        profile,
        features: args.features.0.clone(),
        file_name: if is_stdout { format!("device.{}", kind.ending()) } else { name.into_owned() },
        vendor_name: args.vendor_name.clone(),
        vendor_id: vendor_id.unwrap_or(NO_VENDOR),
        product_name: args.product_name.clone(),
        product_code: args.product_code.or_else(|| identity(2)).unwrap_or(1),
        revision: args.revision.or_else(|| identity(3)).unwrap_or(0x0001_0000),
        author: args.author.clone().unwrap_or_else(|| args.vendor_name.clone()),
        date,
        time,
    };
    let is_described = table.is_some();
    let mut device = scaffold(&wanted).map_err(failure)?;
    if let Some(Device { objects, lists, application, .. }) = table {
        device = Device { objects, lists, application, ..device };
        let count = |kind| u16::try_from(device.pdo_count(kind)).ok();
        let counts = [PdoKind::Rpdo, PdoKind::Tpdo].map(count);
        if let Some(info) = &mut device.device_info {
            [info.rpdo_count, info.tpdo_count] = counts;
            // as in a device.toml: whole bytes can be mapped
            if counts != [Some(0); 2] {
                info.granularity = Some(8);
            }
        }
    }
    let bytes = match kind {
        FileKind::Json => json::write_device(&device).into_bytes(),
        FileKind::Toml if !is_described => format::new_device_toml(&wanted).map_err(failure)?.into_bytes(),
        kind => match kind.format().filter(|format| format.kind() == device.kind) {
            Some(format) => {
                let options = WriteOptions { embed: is_described, ..WriteOptions::default() };
                let written = format::write(&device, format, &options)?;
                if is_described {
                    note(&losses(&written.losses));
                }
                written.bytes
            }
            None => {
                let message = format!("a new device cannot be a {}", kind.name());
                return Err(Failure::new(message).help(outputs_help()));
            }
        },
    };
    if is_stdout {
        out.raw()?.write_all(&bytes)?;
        return Ok(Outcome::Clean);
    }
    if args.output.exists() && !args.overwrite {
        let message = format!("`{}` exists", name_of(&args.output));
        return Err(Failure::new(message).help("name a different file, or replace it with `--overwrite`"));
    }
    save(&args.output, &bytes)?;
    let objects = plural(device.objects.len(), "object");
    let pdos = plural(device.pdos().count(), "PDO");
    out.summary(format_args!("{} ({}), {objects}, {pdos}", name_of(&args.output), kind.name()))?;
    Ok(Outcome::Clean)
}

/// The objects of a table.
fn table(args: &NewArgs, path: &Path) -> Result<Device, Failure> {
    if args.features.0 != Features::default() {
        let failure = Failure::new("a table defines all objects, so features add none");
        return Err(failure.help("omit the features or `--from`"));
    }
    keep(path);
    let name = name_of(path);
    let source =
        source::read(path, DEFAULT_MAX_SIZE).and_then(|bytes| Reading::default().source(&name, bytes));
    let source = source.map_err(ReadError::from)?;
    object_table::read(source.text()).map_err(|error| {
        let failure = Failure::new(format_args!("cannot read `{name}`: {error}"));
        failure.help("`objdict docs --to csv` writes all columns (docs/guides/docs.md)")
    })
}

fn outputs_help() -> String {
    format!("name an output that ends in {}, or the format with `--to`", outputs())
}

/// The profile that was said, else the first one that has the features.
fn profile(args: &NewArgs) -> Result<u16, Failure> {
    let given = FEATURES.iter().filter(|feature| args.features.0.get(feature.word).is_some());
    let given: Vec<&Feature> = given.filter(|feature| !feature.profiles.is_empty()).collect();
    let has_all = |profile: &u16| given.iter().all(|feature| feature.is_of(*profile));
    let profile = match (args.profile, given.first()) {
        (Some(profile), _) => profile,
        (None, None) => 301,
        (None, Some(first)) => *first.profiles.iter().find(|profile| has_all(profile)).ok_or_else(|| {
            Failure::new("no profile has all of these features").help("name the profile with `--profile`")
        })?,
    };
    match profile {
        401 if given.is_empty() => Err(Failure::new("an I/O module needs inputs or outputs")
            .help("set their number with `--digital-inputs`, `--digital-outputs`, `--analog-inputs`, `--analog-outputs`")),
        402 if args.features.0.modes.is_none() => Err(Failure::new("a drive needs modes of operation")
            .help("name them with `--modes`, for example `--modes profile-position,homing`")),
        _ => Ok(profile),
    }
}

fn failure(error: BaseError) -> Failure {
    let help = match &error {
        BaseError::Feature { word, .. } => Feature::named(word)
            .and_then(|feature| feature.profiles.first())
            .map_or_else(|| error.help(), |profile| format!("use `--profile {profile}`")),
        _ => error.help(),
    };
    Failure::new(error).help(help)
}

/// The date and time that a description states: those that were said, else now, in Coordinated Universal Time.
pub(super) fn date_and_time(said: Option<Date>) -> Result<(Date, ClockTime), Failure> {
    if let Some(date) = said {
        return Ok((date, ClockTime { hour: 12, ..MIDNIGHT }));
    }
    now().ok_or_else(|| Failure::new("the clock has no valid date").help("set one with `--date`"))
}
