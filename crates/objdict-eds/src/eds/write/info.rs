//! The sections about the file, the device and the node.

use super::Writer;
use super::sheet::Sheet;
use crate::model::{Commissioning, DeviceInfo, DummyUsage, DynamicChannels, Field, FileInfo, Part, Segment};

impl Writer<'_> {
    /// Everything before modules and objects.
    pub(super) fn general(&self, sheet: &mut Sheet<'_>) {
        let device = self.device;
        if let Some(info) = &device.file_info {
            file_info(sheet, info);
        }
        if let Some(info) = &device.device_info {
            device_info(sheet, info);
        }
        if let Some(usage) = &device.dummy_usage {
            dummy_usage(sheet, usage);
        }
        if let Some(lines) = &device.comments {
            comments(sheet, Part::Comments, lines);
        }
        if let Some(node) = &device.commissioning {
            commissioning(sheet, node);
        }
        if let Some(channels) = &device.dynamic_channels {
            dynamic_channels(sheet, channels);
        }
        self.tools(sheet);
    }

    fn tools(&self, sheet: &mut Sheet<'_>) {
        let tools = &self.device.tools;
        if tools.is_empty() {
            return;
        }
        sheet.open(Part::Tools);
        sheet.put(&Field::Items, tools.len().to_string());
        sheet.close();
        for (number, tool) in (1u16..).zip(tools) {
            sheet.open(Part::Tool(number));
            sheet.put(&Field::Name, &tool.name);
            sheet.put(&Field::Command, &tool.command);
            sheet.close();
        }
    }
}

fn file_info(sheet: &mut Sheet<'_>, info: &FileInfo) {
    sheet.open(Part::FileInfo);
    sheet.put_some(&Field::FileName, info.file_name.as_ref());
    sheet.put_number(&Field::FileVersion, info.file_version);
    sheet.put_number(&Field::FileRevision, info.file_revision);
    sheet.put_some(&Field::EdsVersion, info.eds_version.as_ref());
    sheet.put_some(&Field::Description, info.description.as_ref());
    sheet.put_some(&Field::CreationTime, info.creation_time.map(|time| time.to_string()));
    sheet.put_some(&Field::CreationDate, info.creation_date.map(|date| date.to_string()));
    sheet.put_some(&Field::CreatedBy, info.created_by.as_ref());
    sheet.put_some(&Field::ModificationTime, info.modification_time.map(|time| time.to_string()));
    sheet.put_some(&Field::ModificationDate, info.modification_date.map(|date| date.to_string()));
    sheet.put_some(&Field::ModifiedBy, info.modified_by.as_ref());
    sheet.put_some(&Field::LastEds, info.last_eds.as_ref());
    sheet.extra(info.extra.iter());
    sheet.misfits(&info.misfits);
    sheet.close();
}

fn device_info(sheet: &mut Sheet<'_>, info: &DeviceInfo) {
    let hex = |number: Option<u32>| number.map(|number| format!("0x{number:08X}"));
    sheet.open(Part::DeviceInfo);
    sheet.put_some(&Field::VendorName, info.vendor_name.as_ref());
    sheet.put_some(&Field::VendorNumber, hex(info.vendor_number));
    sheet.put_some(&Field::ProductName, info.product_name.as_ref());
    sheet.put_some(&Field::ProductNumber, hex(info.product_number));
    sheet.put_some(&Field::RevisionNumber, hex(info.revision_number));
    sheet.put_some(&Field::OrderCode, info.order_code.as_ref());
    for (_, field, supported) in info.baud_rates.iter() {
        sheet.put_flag(&field, supported);
    }
    sheet.put_flag(&Field::BaudRateAuto, info.baud_rates.auto);
    sheet.put_flag(&Field::SimpleBootUpMaster, info.simple_boot_up_master);
    sheet.put_flag(&Field::SimpleBootUpSlave, info.simple_boot_up_slave);
    sheet.put_number(&Field::Granularity, info.granularity);
    sheet.put_number(&Field::DynamicChannelsSupported, info.dynamic_channels_supported);
    sheet.put_flag(&Field::GroupMessaging, info.group_messaging);
    sheet.put_number(&Field::NrOfRxPdo, info.rpdo_count);
    sheet.put_number(&Field::NrOfTxPdo, info.tpdo_count);
    sheet.put_flag(&Field::LssSupported, info.lss_supported);
    sheet.put_some(&Field::CompactPdo, info.compact_pdo.map(|mask| format!("0x{mask:02X}")));
    sheet.put_flag(&Field::CanOpenSafetySupported, info.safety_supported);
    sheet.extra(info.extra.iter());
    sheet.misfits(&info.misfits);
    sheet.close();
}

fn dummy_usage(sheet: &mut Sheet<'_>, usage: &DummyUsage) {
    sheet.open(Part::DummyUsage);
    for (data_type, allowed) in &usage.types {
        sheet.put_flag(&Field::Named(format!("Dummy{:04X}", data_type.0).into()), Some(*allowed));
    }
    sheet.extra(usage.extra.iter());
    sheet.misfits(&usage.misfits);
    sheet.close();
}

/// A section of comment lines.
pub(super) fn comments(sheet: &mut Sheet<'_>, part: Part, lines: &[String]) {
    sheet.open(part);
    sheet.put(&Field::Lines, lines.len().to_string());
    for (number, line) in (1..).zip(lines) {
        sheet.put(&Field::Named(format!("Line{number}").into()), line);
    }
    sheet.close();
}

fn commissioning(sheet: &mut Sheet<'_>, node: &Commissioning) {
    sheet.open(Part::Commissioning);
    sheet.put_number(&Field::NodeId, node.node_id);
    sheet.put_some(&Field::NodeName, node.node_name.as_ref());
    sheet.put_some(&Field::NodeRefd, node.node_reference_designator.as_ref());
    sheet.put_number(&Field::Baudrate, node.baud_rate);
    sheet.put_number(&Field::NetNumber, node.net_number);
    sheet.put_some(&Field::NetworkName, node.network_name.as_ref());
    sheet.put_some(&Field::NetRefd, node.net_reference_designator.as_ref());
    sheet.put_flag(&Field::CanOpenManager, node.manager);
    sheet.put_number(&Field::LssSerialNumber, node.lss_serial_number);
    sheet.extra(node.extra.iter());
    sheet.misfits(&node.misfits);
    sheet.close();
}

fn dynamic_channels(sheet: &mut Sheet<'_>, channels: &DynamicChannels) {
    sheet.open(Part::DynamicChannels);
    sheet.put(&Field::NrOfSeg, channels.segments.len().to_string());
    for (number, segment) in (1..).zip(&channels.segments) {
        dynamic_segment(sheet, number, segment);
    }
    sheet.extra(channels.extra.iter());
    sheet.misfits(&channels.misfits);
    sheet.close();
}

fn dynamic_segment(sheet: &mut Sheet<'_>, number: usize, segment: &Segment) {
    let key = |word: &str| Field::Named(format!("{word}{number}").into());
    sheet.put_some(&key("Type"), segment.data_type.map(|data_type| format!("0x{:04X}", data_type.0)));
    sheet.put_some(&key("Dir"), segment.direction.as_ref());
    let range = segment.range.map(|(first, last)| format!("0x{first:04X}-0x{last:04X}"));
    sheet.put_some(&key("Range"), range);
    sheet.put_some(&key("PPOffset"), segment.offset.as_ref());
}
