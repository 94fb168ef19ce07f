use crate::diagnostic::{Diagnostic, Findings, counted, say};
use crate::model::{Device, DeviceKind, Field, Part, Place};
use crate::rule;

rule! {
    "cia306/described-network-variable", Error, Device(check);
    summary: "network variables of dynamic channels are described as objects",
    checks: "Whether the EDS of a device with dynamic channels describes objects A000h to AFFFh.",
    why: "The application program of such a device defines these objects; the EDS only describes their segments. Objects described in addition conflict with the program.",
    example: "`DynamicChannelsSupported=1` and `[A040]`",
    remedy: "Remove the objects, or write `DynamicChannelsSupported=0` if they never change.",
    source: "CiA 306-1 §4.6.3.4.3",
}

fn check(device: &Device, findings: &mut Findings) {
    let Some(info) = &device.device_info else { return };
    if device.kind == DeviceKind::Node || info.dynamic_channels_supported.is_none_or(|number| number == 0) {
        return;
    }
    let mut variables = device.objects.range(0xA000..=0xAFFF);
    let Some((&first, _)) = variables.next() else { return };
    let objects = counted(1 + variables.count(), "object is", "objects are");
    let message = say!("the device has dynamic channels, but {} described in A000h to AFFFh", objects);
    let finding = Diagnostic::new(&RULE.info, Place::object(first), message)
        .label(Place::of(Part::DeviceInfo).field(Field::DynamicChannelsSupported), "dynamic channels");
    findings.push(finding.help(say!("remove the objects, or write `{DynamicChannelsSupported=0}`")));
}
