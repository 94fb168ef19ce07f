//! Conversions there and back: what a real file says must come back whole.

use objdict::compare::differences;
use objdict::format::{self, Format, LossKind, Syntax, WriteOptions, XddVersion};
use objdict::model::Device;
use objdict::source::{Encoding, SourceFile, SourceOptions};

/// What went wrong on the way through the formats of the other syntax and back; nothing for a whole device.
pub(crate) fn problems(device: &Device, format: Format) -> Vec<String> {
    let mut problems = Vec::new();
    let other = if format.syntax() == Syntax::Ini { Syntax::Xml } else { Syntax::Ini };
    let (there, back) = (Format::of(other, device.kind), Format::of(format.syntax(), device.kind));
    for version in [XddVersion::V1_1, XddVersion::V1_0] {
        let mut options = WriteOptions::default();
        options.embed = true;
        options.xdd_version = version;
        let mut through = |device: &Device, format: Format, way: &str| {
            let written = match format::write(device, format, &options) {
                Ok(written) => written,
                Err(error) => {
                    problems.push(format!("{way} {}: {error}", format.name()));
                    return Device::default();
                }
            };
            let lost = written.losses.iter().filter(|loss| loss.kind == LossKind::Lost);
            problems.extend(lost.take(3).map(|loss| format!("{way} {}: {loss}", format.name())));
            read(&written.bytes, format)
        };
        let converted = through(device, there, "to");
        let returned = through(&converted, back, "back to");
        let found = differences(device, &returned);
        let text = |value: &Option<_>| value.as_ref().map_or("nothing".to_owned(), ToString::to_string);
        problems.extend(found.iter().take(3).map(|found| {
            format!("there and back: {}: {} became {}", found.path, text(&found.left), text(&found.right))
        }));
    }
    problems
}

fn read(bytes: &[u8], format: Format) -> Device {
    let mut options = SourceOptions::default();
    options.encoding = Some(Encoding::Utf8);
    match SourceFile::from_bytes("written", bytes.to_vec(), &options) {
        Ok(source) => format::read(source, format).into_device(),
        Err(_) => Device::default(),
    }
}
