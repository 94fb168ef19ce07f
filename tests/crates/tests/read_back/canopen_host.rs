//! canopen-host reads from an EDS or DCF that objdict writes what the model says, in each dialect that does not write a REAL as
//! its bits.

use canopen_host::eds::Eds;
use canopen_rs::{Address, DataType};
use objdict::format::{self, Dialect, Format, WriteOptions};
use objdict::model::DeviceKind;
use objdict::source::SourceFile;

use crate::devices;
use crate::truth::truth;

#[test]
fn canopen_host_reads_what_is_written() {
    let mut compared = 0;
    // a NaN has no spelling but its bits
    for (name, device) in devices::devices().into_iter().filter(|(name, _)| name != "odd") {
        let format = if device.kind == DeviceKind::Node { Format::Dcf } else { Format::Eds };
        for dialect in Dialect::ALL.into_iter().filter(|dialect| *dialect != Dialect::Lely) {
            let mut options = WriteOptions::default();
            options.dialect = dialect;
            let text = format::write(&device, format, &options).unwrap().bytes;
            let Ok(text) = String::from_utf8(text) else { continue };
            let device = match dialect {
                // it leaves out what one of the readers refuses
                Dialect::Portable => {
                    &format::read(SourceFile::from_text("portable", &*text), format).into_device()
                }
                _ => &device,
            };
            let read = Eds::parse(&text).unwrap_or_else(|error| panic!("{name}, {dialect:?}: {error}"));
            for row in truth(device, device.node_id().unwrap_or(0)) {
                let known = row.data_type.and_then(DataType::from_index);
                let is_compact = device.objects[&row.index].compact.is_some();
                // its texts are the characters of the file, its compact storage is one entry
                let Some(known) = known.filter(|known| !known.is_variable() && !is_compact) else { continue };
                let at = Address::new(row.index, row.sub);
                let entry = read.get(at).unwrap_or_else(|| panic!("{name}, {dialect:?}: {row} is missing"));
                let mut bytes = [0; 8];
                let length = entry.default_value.encode_le(&mut bytes).unwrap();
                assert_eq!(
                    (
                        entry.data_type,
                        entry.access.is_readable(),
                        entry.access.is_writable(),
                        &bytes[..length]
                    ),
                    (known, row.read, row.write, &row.default.clone().unwrap()[..]),
                    "{name}, {dialect:?}: {row}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}
