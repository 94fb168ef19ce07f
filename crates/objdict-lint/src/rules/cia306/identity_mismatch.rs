use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, Severity, say};
use crate::model::{Device, Field, Part, Place, Value};
use crate::rule;

rule! {
    "cia306/identity-mismatch", Error, Device(check), fix Unsafe;
    summary: "`[DeviceInfo]` and the identity object disagree",
    checks: "Whether `VendorNumber`, `ProductNumber` and `RevisionNumber` equal 1018h sub-indexes 1, 2 and 3, where both values are given. In a DCF, the configured value may match instead of the default. If one of the two is 0, it was probably never filled in, and the finding is a warning.",
    why: "A tool looks up the EDS by the values read from 1018h. With different numbers in `[DeviceInfo]`, the tool finds no EDS or the wrong one.",
    example: "`VendorNumber=0x59` and `DefaultValue=0x5A` in `[1018sub1]`",
    remedy: "Write the number that the device reports in both places.",
    source: "CiA 306-1 §4.5",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    let numbers = [
        (1, Field::VendorNumber, info.vendor_number),
        (2, Field::ProductNumber, info.product_number),
        (3, Field::RevisionNumber, info.revision_number),
    ];
    for (sub, field, stated) in numbers {
        let (Some(stated), Some(entry)) = (stated, device.entry(0x1018, sub)) else { continue };
        let values = [entry.default.as_ref(), entry.configured_value()];
        let mut values = values.into_iter().flatten().filter_map(Value::as_integer).peekable();
        let Some(&value) = values.peek() else { continue };
        if values.any(|value| value == i128::from(stated)) {
            continue;
        }
        let key = if entry.default.is_some() { Field::DefaultValue } else { Field::ParameterValue };
        let title = say!("write `{}`", Argument::setting(&field, format_args!("0x{value:X}")));
        // which of the two is right is the decision of the author
        let fix =
            Fix::risky(title).set(Place::of(Part::DeviceInfo).field(field.clone()), format!("0x{value:X}"));
        let message = say!("`{}` is {:#x}, but 1018h sub-index {} is {:#x}", field, stated, sub, value);
        let finding = Diagnostic::new(&RULE.info, Place::of(Part::DeviceInfo).field(field), message)
            .severity(if stated == 0 || value == 0 { Severity::Warning } else { Severity::Error })
            .label(Place::entry(0x1018, sub).field(key), "the identity object");
        let finding = finding.help("write the number that the device reports in both places");
        findings.push(if value > 0 { finding.fix(fix) } else { finding });
    }
}
