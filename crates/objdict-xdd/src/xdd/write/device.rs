//! The device profile: identity, functions, the application process.

use super::Writer;
use crate::model::{ApplicationProcess, DeviceFunction, DeviceIdentity, DeviceInfo, Field, Label, Labels};
use crate::xdd::defaults;
use crate::xdd::markup::Markup;
use crate::xdd::shape::{Identity, Shape};

impl Writer<'_> {
    pub(super) fn device_body(&self, out: &mut Markup) {
        let device = self.device;
        if let Some(identity) = self.identity() {
            identity.write("DeviceIdentity", out);
        }
        if let Some(manager) = &device.manager {
            Shape::write(&**manager, "DeviceManager", out);
        }
        for function in &device.functions {
            complete(function).write("DeviceFunction", out);
        }
        if device.functions.is_empty() {
            defaults::function().write("DeviceFunction", out);
        }
        self.application(out);
    }

    /// `DeviceIdentity`; `None` where nothing is known.
    fn identity(&self) -> Option<Identity> {
        let unknown = DeviceInfo::default();
        let info = self.device.device_info.as_ref().unwrap_or(&unknown);
        let mut rest = self.device.identity.as_deref().cloned().unwrap_or_default();
        let description = self.device.file_info.as_ref().and_then(|info| info.description.as_deref());
        if let Some(text) = description.filter(|_| rest.product_text.is_empty()) {
            let label = Label::Description { lang: defaults::LANGUAGE.into(), text: text.into(), uri: None };
            rest.product_text = Labels(vec![label]);
        }
        let hex = |number: Option<u32>, field: Field| -> Option<Box<str>> {
            let number = number.map(|number| format!("0x{number:08X}").into());
            number.or_else(|| info.misfits.get(&field).map(|misfit| misfit.text.clone()))
        };
        let order_code = info.order_code.as_deref().map(Into::into);
        let further = rest.further_order_numbers.iter().cloned();
        // the first of them is the order code
        let is_missing = order_code.is_none() && further.len() > 0;
        let order_numbers =
            is_missing.then(Box::default).into_iter().chain(order_code).chain(further).collect();
        let identity = Identity {
            vendor_name: info.vendor_name.as_deref().map(Into::into),
            vendor_id: hex(info.vendor_number, Field::VendorNumber),
            product_name: info.product_name.as_deref().map(Into::into),
            product_id: hex(info.product_number, Field::ProductNumber),
            order_numbers,
            rest: DeviceIdentity { further_order_numbers: Vec::new(), ..rest },
        };
        if identity == Identity::default() {
            return None;
        }
        let stated = |name: Option<Box<str>>| Some(name.unwrap_or_else(|| defaults::NOT_STATED.into()));
        Some(Identity {
            vendor_name: stated(identity.vendor_name),
            product_name: stated(identity.product_name),
            ..identity
        })
    }

    /// The application processes; the first one has the parameters of the entries and the types of their objects.
    fn application(&self, out: &mut Markup) {
        let mut processes = self.device.application.iter();
        let mut first = processes.next().cloned().unwrap_or_default();
        first.data_types.extend(self.parameters.types.iter().cloned());
        let own = std::mem::take(&mut first.parameters);
        first.parameters = self.parameters.all().cloned().chain(own).collect();
        if first != ApplicationProcess::default() {
            first.write("ApplicationProcess", out);
        }
        processes.for_each(|process| process.write("ApplicationProcess", out));
    }
}

/// The function with the characteristic that it must have.
fn complete(function: &DeviceFunction) -> DeviceFunction {
    let mut function = function.clone();
    if function.characteristics.is_empty() {
        function.characteristics = defaults::function().characteristics;
    }
    function
}
