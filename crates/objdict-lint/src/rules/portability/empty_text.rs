use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Device, Field, ModulePart, Part, Place};
use crate::rule;

rule! {
    "portability/empty-text", Error, Device(check);
    summary: "a tool does not accept an empty text",
    checks: "Whether `VendorName`, `ProductName` and `OrderCode` of the device and of its modules have a text, if they are there.",
    why: "CANchkEDS reports mandatory keys without a value.",
    example: "`OrderCode=`",
    remedy: "Write the order code.",
    source: "CANchkEDS 4.0",
}

fn check(device: &Device, findings: &mut Findings) {
    if let Some(info) = &device.device_info {
        report(&Part::DeviceInfo, Field::VendorName, info.vendor_name.as_deref(), findings);
        report(&Part::DeviceInfo, Field::ProductName, info.product_name.as_deref(), findings);
        report(&Part::DeviceInfo, Field::OrderCode, info.order_code.as_deref(), findings);
    }
    for (&number, module) in device.modules.iter().flat_map(|modules| &modules.supported) {
        let info = Part::Module(number, ModulePart::Info);
        report(&info, Field::ProductName, module.product_name.as_deref(), findings);
        report(&info, Field::OrderCode, module.order_code.as_deref(), findings);
    }
}

fn report(part: &Part, field: Field, text: Option<&str>, findings: &mut Findings) {
    if text.is_some_and(|text| text.trim().is_empty()) {
        let message = say!("`{}` of `{}` is empty", field, part);
        let finding = Diagnostic::new(&RULE.info, Place::of(part.clone()).field(field), message);
        findings.push(finding.help("write the text"));
    }
}
