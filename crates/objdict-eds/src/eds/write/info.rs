//! The sections about the file, the device and the node.

use super::EdsWriter;
use super::section_writer::SectionWriter;
use crate::model::{Commissioning, DeviceInfo, DummyUsage, DynamicChannels, Field, FileInfo, Part, Segment};

impl EdsWriter<'_> {
    /// Everything before modules and objects.
    pub(super) fn general(&self, sections: &mut SectionWriter<'_>) {
        let device = self.device;
        if let Some(info) = &device.file_info {
            file_info(sections, info);
        }
        if let Some(info) = &device.device_info {
            device_info(sections, info);
        }
        if let Some(usage) = &device.dummy_usage {
            dummy_usage(sections, usage);
        }
        if let Some(lines) = &device.comments {
            comments(sections, Part::Comments, lines);
        }
        if let Some(node) = &device.commissioning {
            commissioning(sections, node);
        }
        if let Some(channels) = &device.dynamic_channels {
            dynamic_channels(sections, channels);
        }
        self.tools(sections);
    }

    fn tools(&self, sections: &mut SectionWriter<'_>) {
        let tools = &self.device.tools;
        if tools.is_empty() {
            return;
        }
        sections.open(Part::Tools);
        sections.put(&Field::Items, tools.len().to_string());
        sections.close();
        for (number, tool) in (1u16..).zip(tools) {
            sections.open(Part::Tool(number));
            sections.put(&Field::Name, &tool.name);
            sections.put(&Field::Command, &tool.command);
            sections.close();
        }
    }
}

fn file_info(sections: &mut SectionWriter<'_>, info: &FileInfo) {
    sections.open(Part::FileInfo);
    sections.put_some(&Field::FileName, info.file_name.as_ref());
    sections.put_number(&Field::FileVersion, info.file_version);
    sections.put_number(&Field::FileRevision, info.file_revision);
    sections.put_some(&Field::EdsVersion, info.eds_version.as_ref());
    sections.put_some(&Field::Description, info.description.as_ref());
    sections.put_some(&Field::CreationTime, info.creation_time.map(|time| time.to_string()));
    sections.put_some(&Field::CreationDate, info.creation_date.map(|date| date.to_string()));
    sections.put_some(&Field::CreatedBy, info.created_by.as_ref());
    sections.put_some(&Field::ModificationTime, info.modification_time.map(|time| time.to_string()));
    sections.put_some(&Field::ModificationDate, info.modification_date.map(|date| date.to_string()));
    sections.put_some(&Field::ModifiedBy, info.modified_by.as_ref());
    sections.put_some(&Field::LastEds, info.last_eds.as_ref());
    sections.close_with(&info.extra, &info.invalid_values);
}

fn device_info(sections: &mut SectionWriter<'_>, info: &DeviceInfo) {
    let hex = |number: Option<u32>| number.map(|number| format!("0x{number:08X}"));
    sections.open(Part::DeviceInfo);
    sections.put_some(&Field::VendorName, info.vendor_name.as_ref());
    sections.put_some(&Field::VendorNumber, hex(info.vendor_number));
    sections.put_some(&Field::ProductName, info.product_name.as_ref());
    sections.put_some(&Field::ProductNumber, hex(info.product_number));
    sections.put_some(&Field::RevisionNumber, hex(info.revision_number));
    sections.put_some(&Field::OrderCode, info.order_code.as_ref());
    for (_, field, supported) in info.baud_rates.iter() {
        sections.put_flag(&field, supported);
    }
    sections.put_flag(&Field::BaudRateAuto, info.baud_rates.auto);
    sections.put_flag(&Field::SimpleBootUpMaster, info.simple_boot_up_master);
    sections.put_flag(&Field::SimpleBootUpSlave, info.simple_boot_up_slave);
    sections.put_number(&Field::Granularity, info.granularity);
    sections.put_number(&Field::DynamicChannelsSupported, info.dynamic_channels_supported);
    sections.put_flag(&Field::GroupMessaging, info.group_messaging);
    sections.put_number(&Field::NrOfRxPdo, info.rpdo_count);
    sections.put_number(&Field::NrOfTxPdo, info.tpdo_count);
    sections.put_flag(&Field::LssSupported, info.lss_supported);
    sections.put_some(&Field::CompactPdo, info.compact_pdo.map(|mask| format!("0x{mask:02X}")));
    sections.put_flag(&Field::CanOpenSafetySupported, info.safety_supported);
    sections.close_with(&info.extra, &info.invalid_values);
}

fn dummy_usage(sections: &mut SectionWriter<'_>, usage: &DummyUsage) {
    sections.open(Part::DummyUsage);
    for (data_type, allowed) in &usage.types {
        sections.put_flag(&Field::Named(format!("Dummy{:04X}", data_type.0).into()), Some(*allowed));
    }
    sections.close_with(&usage.extra, &usage.invalid_values);
}

/// A section of comment lines.
pub(super) fn comments(sections: &mut SectionWriter<'_>, part: Part, lines: &[String]) {
    sections.open(part);
    sections.put(&Field::Lines, lines.len().to_string());
    for (number, line) in (1..).zip(lines) {
        sections.put(&Field::Named(format!("Line{number}").into()), line);
    }
    sections.close();
}

fn commissioning(sections: &mut SectionWriter<'_>, node: &Commissioning) {
    sections.open(Part::Commissioning);
    sections.put_number(&Field::NodeId, node.node_id);
    sections.put_some(&Field::NodeName, node.node_name.as_ref());
    sections.put_some(&Field::NodeRefd, node.node_reference_designator.as_ref());
    sections.put_number(&Field::Baudrate, node.baud_rate);
    sections.put_number(&Field::NetNumber, node.net_number);
    sections.put_some(&Field::NetworkName, node.network_name.as_ref());
    sections.put_some(&Field::NetRefd, node.net_reference_designator.as_ref());
    sections.put_flag(&Field::CanOpenManager, node.manager);
    sections.put_number(&Field::LssSerialNumber, node.lss_serial_number);
    sections.close_with(&node.extra, &node.invalid_values);
}

fn dynamic_channels(sections: &mut SectionWriter<'_>, channels: &DynamicChannels) {
    sections.open(Part::DynamicChannels);
    sections.put(&Field::NrOfSeg, channels.segments.len().to_string());
    for (number, segment) in (1..).zip(&channels.segments) {
        dynamic_segment(sections, number, segment);
    }
    sections.close_with(&channels.extra, &channels.invalid_values);
}

fn dynamic_segment(sections: &mut SectionWriter<'_>, number: usize, segment: &Segment) {
    let key = |word: &str| Field::Named(format!("{word}{number}").into());
    sections.put_some(&key("Type"), segment.data_type.map(|data_type| format!("0x{:04X}", data_type.0)));
    sections.put_some(&key("Dir"), segment.direction.as_ref());
    let range = segment.range.map(|(first, last)| format!("0x{first:04X}-0x{last:04X}"));
    sections.put_some(&key("Range"), range);
    sections.put_some(&key("PPOffset"), segment.offset.as_ref());
}
