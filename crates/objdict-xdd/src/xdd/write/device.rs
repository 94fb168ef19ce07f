//! The device profile: identity, functions, the application process.

use super::Writer;
use crate::model::{ApplicationProcess, DeviceFunction, DeviceInfo, Field, Label, Labels};
use crate::xdd::defaults;
use crate::xdd::schema::{APPLICATION_PROCESS, DEVICE_FUNCTION, DEVICE_IDENTITY, DEVICE_MANAGER, PARAMETER};
use crate::xdd::shape::{self, IdentityContent};
use crate::xdd::types::with_type;
use crate::xdd::version::XddVersion;
use crate::xdd::xdd_writer::XddWriter;
use crate::xml::n;

impl Writer<'_> {
    pub(super) fn device_body(&self, out: &mut XddWriter) {
        let device = self.device;
        if let Some(identity) = self.identity(out.version()) {
            shape::write(&identity, &DEVICE_IDENTITY, out);
        }
        if let Some(manager) = &device.manager {
            shape::write(&**manager, &DEVICE_MANAGER, out);
        }
        for function in &device.functions {
            shape::write(&complete(function), &DEVICE_FUNCTION, out);
        }
        if out.count_of(n::DeviceFunction) == 0 {
            shape::write(&defaults::function(), &DEVICE_FUNCTION, out);
        }
        self.application(out);
    }

    /// `DeviceIdentity`; `None` if it would be empty.
    fn identity(&self, version: XddVersion) -> Option<IdentityContent> {
        let unknown = DeviceInfo::default();
        let info = self.device.device_info.as_ref().unwrap_or(&unknown);
        let mut rest = self.device.identity.as_deref().cloned().unwrap_or_default();
        let description = self.device.file_info.as_ref().and_then(|info| info.description.as_deref());
        // CANopenEditor crashes on an empty text in version 1.0
        let description = description.filter(|text| version == XddVersion::V1_1 || !text.is_empty());
        if let Some(text) = description.filter(|_| rest.product_text.is_empty()) {
            let label = Label::Description { lang: defaults::LANGUAGE.into(), text: text.into(), uri: None };
            rest.product_text = Labels(vec![label]);
        }
        let hex = |number: Option<u32>, field: Field| -> Option<Box<str>> {
            let number = number.map(|number| format!("0x{number:08X}").into());
            number.or_else(|| info.invalid_values.get(&field).map(|invalid| invalid.text.clone()))
        };
        let text = |text: &Option<String>| text.as_deref().map(Box::from);
        let order_code = text(&info.order_code);
        let further = std::mem::take(&mut rest.further_order_numbers);
        // the first one is the order code
        let is_missing = order_code.is_none() && !further.is_empty();
        let first = is_missing.then(Box::default).or(order_code);
        let mut identity = IdentityContent {
            vendor_name: text(&info.vendor_name),
            vendor_id: hex(info.vendor_number, Field::VendorNumber),
            product_name: text(&info.product_name),
            product_id: hex(info.product_number, Field::ProductNumber),
            order_numbers: first.into_iter().chain(further).collect(),
            rest,
        };
        if version == XddVersion::V1_0 {
            // CANopenEditor cannot read a file without them
            for id in [&mut identity.vendor_id, &mut identity.product_id] {
                id.get_or_insert_with(|| defaults::ID.into());
            }
            if identity.rest.product_text.is_empty() {
                identity.rest.product_text = defaults::product_text();
            }
        }
        if identity == IdentityContent::default() {
            return None;
        }
        for name in [&mut identity.vendor_name, &mut identity.product_name] {
            name.get_or_insert_with(|| defaults::NOT_STATED.into());
        }
        Some(identity)
    }

    /// The application processes; the first one contains the parameters of the entries and the types of
    /// their objects.
    fn application(&self, out: &mut XddWriter) {
        let mut processes = self.device.application.iter().map(complete_process);
        let mut first = processes.next().unwrap_or_default();
        first.data_types.extend(self.parameters.definitions.take());
        if first != ApplicationProcess::default() || !self.parameters.is_empty() {
            shape::write_with(&first, &APPLICATION_PROCESS, out, &mut |name, out| {
                if name == PARAMETER.name {
                    let mut write = |parameter| shape::write(&with_type(parameter), &PARAMETER, out);
                    self.parameters.each(self.device, &mut write);
                }
            });
        }
        processes.for_each(|process| shape::write(&process, &APPLICATION_PROCESS, out));
    }
}

/// The process with the types of its parameters.
fn complete_process(process: &ApplicationProcess) -> ApplicationProcess {
    let mut process = process.clone();
    process.parameters = process.parameters.into_iter().map(with_type).collect();
    process
}

/// The function with its mandatory characteristic.
fn complete(function: &DeviceFunction) -> DeviceFunction {
    let mut function = function.clone();
    if function.characteristics.is_empty() {
        function.characteristics = defaults::function().characteristics;
    }
    function
}
