//! The product and revision of a configuration, compared with its EDS.

use crate::configured::ConfiguredDevice;
use crate::diagnostic::{At, Findings, say};
use crate::model::{Device, DeviceInfo, Field, Part, Place};
use crate::rule::rules;

rules! {
    source: "CiA 306-1 §4.4, §5.3; CiA 301 §7.5.2.21";

    "configuration/other-device" = OTHER_DEVICE, Error, Configured(other_device);
    summary: "a configuration is for another device than its EDS",
    checks: "Whether `VendorNumber` and `ProductNumber` of a DCF are those of its EDS, and vendor-ID and product code in 1018h too. If they are not, no other difference is reported.",
    why: "The configuration belongs to another product: its entries may not exist in the device, or mean something else.",
    example: "`ProductNumber=0x11` in the DCF, and `ProductNumber=0x10` in the EDS",
    remedy: "Name the EDS of the device with `--eds`, or in `LastEDS`; or make the DCF anew.",

    "configuration/other-revision" = OTHER_REVISION, Warning, Configured(other_revision);
    summary: "a configuration is for another revision than its EDS",
    checks: "Whether `RevisionNumber` of a DCF is that of its EDS, and the revision number in 1018h too.",
    why: "A manager that compares the revision does not boot the node, and objects of the other revision can differ.",
    example: "`RevisionNumber=0x00010000` in the DCF, and `RevisionNumber=0x00020000` in the EDS",
    remedy: "Make the DCF anew from the EDS of the device, or name the EDS that it was made from.",
}

fn other_device(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    let (device, origin) = (configured.device, configured.written);
    for (field, name, number, sub) in IDENTITY {
        let Some((place, is, other, wanted)) = difference(device, origin, &field, number, sub) else {
            continue;
        };
        let message = say!("the {} is `0x{:08X}`, but that of the {EDS} is `0x{:08X}`", name, is, wanted);
        let finding = OTHER_DEVICE.at(place, message);
        findings.push(
            finding
                .label(At::Node(0, other), say!("in the {EDS}"))
                .help(say!("check with the {EDS} of the device")),
        );
    }
}

type NumberField = fn(&DeviceInfo) -> Option<u32>;

const IDENTITY: [(Field, &str, NumberField, u8); 2] = [
    (Field::VendorNumber, "vendor-ID", |info| info.vendor_number, 1),
    (Field::ProductNumber, "product code", |info| info.product_number, 2),
];

/// Whether both are descriptions of the same product.
pub(crate) fn is_same(device: &Device, origin: &Device) -> bool {
    IDENTITY.iter().all(|(field, _, number, sub)| difference(device, origin, field, *number, *sub).is_none())
}

/// Where two devices state different numbers: in the device information, else in a sub-index of 1018h. The place and the number
/// of each.
fn difference(
    device: &Device,
    origin: &Device,
    field: &Field,
    number: NumberField,
    sub: u8,
) -> Option<(Place, u32, Place, u32)> {
    let of_info = |device: &Device| device.device_info.as_ref().and_then(number);
    let of_object = |device: &Device| u32::try_from(device.value(0x1018, sub)?.as_integer()?).ok();
    let info = || Place::of(Part::DeviceInfo).field(field.clone());
    let differing =
        |left: Option<u32>, right: Option<u32>| left.zip(right).filter(|(left, right)| left != right);
    differing(of_info(device), of_info(origin)).map(|(is, wanted)| (info(), is, info(), wanted)).or_else(
        || {
            let (is, wanted) = differing(of_object(device), of_object(origin))?;
            Some((device.value_place(0x1018, sub), is, origin.value_place(0x1018, sub), wanted))
        },
    )
}

fn other_revision(configured: &ConfiguredDevice<'_>, findings: &mut Findings) {
    let (device, origin) = (configured.device, configured.written);
    let found = difference(device, origin, &Field::RevisionNumber, |info| info.revision_number, 3);
    let Some((place, is, other, wanted)) = found else { return };
    let message = say!("the revision number is `0x{:08X}`, but that of the {EDS} is `0x{:08X}`", is, wanted);
    let finding = OTHER_REVISION.at(place, message).label(At::Node(0, other), say!("in the {EDS}"));
    findings.push(finding.help(say!("make the configuration anew from this {EDS}")));
}
