//! The identity of a node according to its description.

use crate::compiled::DcfgenMode;
use crate::download::Order;
use crate::identity_level::IdentityLevel;
use crate::model::{Device, Field, Part, Place};
use crate::network::{Network, Node};

/// The value with which vendors mark an unknown number.
pub(crate) const PLACEHOLDER: u32 = u32::MAX;

/// The number in an entry.
pub(crate) fn number(device: &Device, index: u16, sub: u8, node_id: u8) -> Option<u32> {
    let number = device.object(index)?.value(sub)?.integer_for(node_id)?;
    u32::try_from(number).ok()
}

/// A number with the place that states it.
pub(crate) type Stated = (u32, Place);

/// The numbers that `DeviceInfo` and the commissioning state: vendor-ID, product code, revision number and serial number.
pub(crate) fn stated(device: &Device) -> [Option<Stated>; 4] {
    let info = device.device_info.as_ref();
    let of_info = |number: Option<u32>, field| Some((number?, Place::of(Part::DeviceInfo).field(field)));
    let serial = device.commissioning.as_ref().and_then(|node| node.lss_serial_number);
    let serial = serial.map(|serial| (serial, Place::of(Part::Commissioning).field(Field::LssSerialNumber)));
    [
        info.and_then(|info| of_info(info.vendor_number, Field::VendorNumber)),
        info.and_then(|info| of_info(info.product_number, Field::ProductNumber)),
        info.and_then(|info| of_info(info.revision_number, Field::RevisionNumber)),
        serial,
    ]
}

/// The number of 1018h; `None` for a placeholder.
pub(crate) fn present(device: &Device, sub: u8, node_id: u8) -> Option<Stated> {
    let number = number(device, 0x1018, sub, node_id).filter(|number| *number != PLACEHOLDER)?;
    Some((number, device.value_place(0x1018, sub)))
}

/// A node's response for a number of 1018h: its value there, otherwise the one stated elsewhere in its description.
/// `None` if the description does not contain the number; the default of a serial number does not belong to any device.
pub fn answered(device: &Device, sub: u8, node_id: u8) -> Option<u32> {
    let is_configured = || device.entry(0x1018, sub).is_some_and(|entry| entry.configured_value().is_some());
    let own = number(device, 0x1018, sub, node_id).filter(|_| sub != 4 || is_configured());
    let stated = stated(device).into_iter().nth(usize::from(sub).checked_sub(1)?).flatten();
    [own, stated.map(|(number, _)| number)].into_iter().flatten().find(|number| *number != 0)
}

/// Device type, vendor-ID, product code, revision number and serial number (0 if not stated), each with its place.
/// 1018h is the node's response, so it has priority over `DeviceInfo`; in dcfgen it is the other way round. The default
/// of a serial number does not belong to any device.
pub(crate) fn described(device: &Device, node_id: u8, order: Order) -> [Stated; 5] {
    let device_type = number(device, 0x1000, 0, node_id).unwrap_or(0);
    let mut identity = [0, 1, 2, 3, 4].map(|_: u8| (device_type, device.value_place(0x1000, 0)));
    for (sub, stated) in (1..).zip(stated(device)) {
        let is_default = || device.entry(0x1018, sub).is_none_or(|entry| entry.configured_value().is_none());
        let own = number(device, 0x1018, sub, node_id)
            .filter(|number| *number != 0 && (sub != 4 || order == Order::Dcfgen || !is_default()));
        let own = own.map(|number| (number, device.value_place(0x1018, sub)));
        // the node does not return a number that is stated in addition to a placeholder
        let is_unknown = own.as_ref().is_some_and(|(number, _)| *number == PLACEHOLDER);
        let (first, second) = if order == Order::Dcfgen { (stated, own) } else { (own, stated) };
        let known = [first, second].into_iter().flatten().find(|(number, _)| *number != PLACEHOLDER);
        identity[usize::from(sub)] =
            known.filter(|_| !is_unknown).unwrap_or_else(|| (0, device.value_place(0x1018, sub)));
    }
    identity
}

/// The manager's expectations of the node: the network file has priority over the description.
pub(crate) fn expected(network: &Network, node: &Node, node_id: u8, mode: DcfgenMode) -> [u32; 5] {
    let device = &node.device;
    let mut identity = described(device, node_id, network.order).map(|(number, _)| number);
    if mode == DcfgenMode::Exact {
        // dcfgen knows no placeholders
        for (number, stated) in identity[1..].iter_mut().zip(stated(device)) {
            *number = stated.map_or(*number, |(number, _)| number);
        }
    }
    let level = node.identity.or(network.identity).unwrap_or_default();
    for (number, of) in identity.iter_mut().zip(IdentityLevel::OF_NUMBERS) {
        *number = if of <= level { *number } else { 0 };
    }
    for (stated, place) in [(node.revision_number, 3), (node.serial_number, 4)] {
        let stated = stated.filter(|stated| mode == DcfgenMode::Exact || stated.value != PLACEHOLDER);
        identity[place] = stated.map_or(identity[place], |stated| stated.value);
    }
    if mode == DcfgenMode::Corrected {
        // a node aborts the upload of missing entries
        for (sub, number) in (1..).zip(&mut identity[1..]) {
            *number = if device.entry(0x1018, sub).is_some() { *number } else { 0 };
        }
    }
    identity
}
