//! Large healthy devices for benchmarks.

use std::fmt::Write;

/// A healthy EDS of about so many bytes: records of a drive with limits and defaults, as a vendor's tool writes them. The
/// indexes of the profile area run out at 4 MB, so larger ones take a padding in every name.
pub(crate) fn of_size(size: usize, padding: &str) -> String {
    let mut text = String::from(include_str!("../../fixtures/eds/minimal.eds")).replace("\r\n", "\n");
    let mut list = String::new();
    let mut count = 0;
    'all: for index in 0x2000..0x6000 {
        count += 1;
        let _ = writeln!(list, "{count}=0x{index:04X}");
        let _ = write!(
            text,
            "\n[{index:X}]\nParameterName=Axis parameters {index:04X} {padding}\nObjectType=0x9\nSubNumber=9\n"
        );
        for sub in 0..9 {
            let (data_type, access, high, value) =
                if sub == 0 { ("0x0005", "const", "0x7F", 8) } else { ("0x0007", "rw", "0x7FFFFFFF", sub) };
            let _ = write!(
                text,
                "\n[{index:X}sub{sub:X}]\nParameterName=Position control gain {sub} {padding}\nObjectType=0x7\nDataType={data_type}\n\
                 LowLimit=0x00000000\nHighLimit={high}\nAccessType={access}\nDefaultValue={value}\nPDOMapping=0\n"
            );
        }
        if text.len() + list.len() >= size {
            break 'all;
        }
    }
    text.replace(
        "[ManufacturerObjects]\nSupportedObjects=0\n",
        &format!("[ManufacturerObjects]\nSupportedObjects={count}\n{list}"),
    )
}
