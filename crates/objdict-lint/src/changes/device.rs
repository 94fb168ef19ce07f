//! The device as a whole: its capabilities and names.

use std::collections::BTreeSet;

use super::{DeviceComparison, Spot, rules};
use crate::diagnostic::say;
use crate::model::{DataType, Device, DeviceInfo, Field, Module, ModulePart, Part, Place};

/// The capabilities of a device, by field; a missing one means no.
fn features(device: &Device) -> Vec<(Place, String, bool)> {
    let info = device.device_info.as_ref();
    let flag = |field: Field, value: fn(&DeviceInfo) -> Option<bool>| {
        let name = field.name().into_owned();
        (Place::of(Part::DeviceInfo).field(field), name, info.and_then(value).unwrap_or(false))
    };
    vec![
        flag(Field::LssSupported, |info| info.lss_supported),
        flag(Field::GroupMessaging, |info| info.group_messaging),
        flag(Field::SimpleBootUpMaster, |info| info.simple_boot_up_master),
        flag(Field::SimpleBootUpSlave, |info| info.simple_boot_up_slave),
        flag(Field::DynamicChannelsSupported, |info| info.dynamic_channels_supported.map(|count| count > 0)),
        flag(Field::CanOpenSafetySupported, |info| info.safety_supported),
    ]
}

/// The data types of dummy entries.
fn dummies(device: &Device) -> BTreeSet<DataType> {
    let types = device.dummy_usage.iter().flat_map(|usage| &usage.types);
    types.filter(|(_, is_allowed)| **is_allowed).map(|(data_type, _)| *data_type).collect()
}

/// The supported bit rates.
fn bit_rates(device: &Device) -> Vec<(Field, String)> {
    let Some(info) = &device.device_info else { return Vec::new() };
    let rates = info.baud_rates.iter().filter(|(.., is_supported)| *is_supported == Some(true));
    let mut found: Vec<_> = rates.map(|(rate, field, _)| (field, format!("{rate} kbit/s"))).collect();
    if info.baud_rates.auto == Some(true) {
        found.push((Field::BaudRateAuto, "automatic detection".to_owned()));
    }
    found
}

impl DeviceComparison<'_> {
    pub(super) fn device(&mut self) {
        // without the section there is no information
        if self.old.device.device_info.is_some() && self.new.device.device_info.is_some() {
            self.bit_rates();
            self.features();
            self.granularity();
        }
        self.dummies();
        self.modules();
    }

    fn bit_rates(&mut self) {
        let (old, new) = (bit_rates(self.old.device), bit_rates(self.new.device));
        for (field, name) in old.iter().filter(|rate| !new.contains(rate)) {
            let spot = Spot::part(&Place::of(Part::DeviceInfo).field(field.clone()));
            let message = say!("{} is no longer supported", name);
            self.report(&rules::BIT_RATE_REMOVED, &spot, [Some(name.clone()), None], message);
        }
        for (field, name) in new.iter().filter(|rate| !old.contains(rate)) {
            let spot = Spot::part(&Place::of(Part::DeviceInfo).field(field.clone()));
            let message = say!("{} is supported", name);
            self.report(&rules::BIT_RATE_ADDED, &spot, [None, Some(name.clone())], message);
        }
    }

    fn features(&mut self) {
        let (old, new) = (features(self.old.device), features(self.new.device));
        for ((place, name, was), (.., is)) in old.into_iter().zip(new) {
            self.feature(&place, &name, was, is);
        }
    }

    fn feature(&mut self, place: &Place, name: &str, was: bool, is: bool) {
        let values = [was, is].map(|is| is.then(|| name.to_owned()));
        match (was, is) {
            (true, false) => {
                let message = say!("`{}` is no longer supported", name);
                self.report(&rules::FEATURE_REMOVED, &Spot::part(place), values, message);
            }
            (false, true) => {
                let message = say!("`{}` is supported", name);
                self.report(&rules::FEATURE_ADDED, &Spot::part(place), values, message);
            }
            _ => {}
        }
    }

    fn dummies(&mut self) {
        let (old, new) = (self.old.device, self.new.device);
        if old.dummy_usage.is_none() || new.dummy_usage.is_none() {
            return;
        }
        let (old, new) = (dummies(old), dummies(new));
        for data_type in old.union(&new) {
            let name = format!("Dummy{:04X}", data_type.0);
            let place = Place::of(Part::DummyUsage).field(Field::Named((*name).into()));
            self.feature(&place, &name, old.contains(data_type), new.contains(data_type));
        }
    }

    fn granularity(&mut self) {
        let granularity = |device: &Device| device.device_info.as_ref().and_then(|info| info.granularity);
        let (Some(old), Some(new)) = (granularity(self.old.device), granularity(self.new.device)) else {
            return;
        };
        if old == new {
            return;
        }
        // 0 is a fixed mapping, which is coarser than any other
        let steps = |granularity: u8| if granularity == 0 { u8::MAX } else { granularity };
        let is_coarser = steps(new) > steps(old);
        let rule = if is_coarser { &rules::GRANULARITY_COARSER } else { &rules::GRANULARITY_FINER };
        let spot = Spot::part(&Place::of(Part::DeviceInfo).field(Field::Granularity));
        let message = say!("{Granularity} changes from {} to {}", old, new);
        self.report(rule, &spot, [Some(old.to_string()), Some(new.to_string())], message);
    }

    fn modules(&mut self) {
        let none = Default::default();
        let supported = |device: &'_ Device| -> Vec<u16> {
            device.modules.iter().flat_map(|modules| modules.supported.keys().copied()).collect()
        };
        let numbers: BTreeSet<u16> =
            supported(self.old.device).into_iter().chain(supported(self.new.device)).collect();
        for number in numbers {
            let module = |device: &'_ Device| {
                device.modules.as_ref().and_then(|all| all.supported.get(&number).cloned())
            };
            let pair = [module(self.old.device), module(self.new.device)];
            self.module(number, pair);
        }
        let connected =
            |device: &Device| device.modules.as_ref().and_then(|modules| modules.connected.clone());
        let pair = [connected(self.old.device), connected(self.new.device)];
        if pair[0].as_ref().unwrap_or(&none) != pair[1].as_ref().unwrap_or(&none) {
            let list = |modules: &Option<Vec<u16>>| {
                let numbers = modules.iter().flatten().map(ToString::to_string);
                numbers.collect::<Vec<_>>().join(", ")
            };
            let [old, new] = [list(&pair[0]), list(&pair[1])];
            let message = say!("the connected modules change from {} to {}", &old, &new);
            let spot = Spot::part(&Place::of(Part::ConnectedModules));
            self.report(&rules::MODULE_CHANGED, &spot, [Some(old), Some(new)], message);
        }
    }

    fn module(&mut self, number: u16, [old, new]: [Option<Module>; 2]) {
        let spot = Spot::part(&Place::of(Part::Module(number, ModulePart::Info)));
        let name = |module: &Module| module.product_name.clone().unwrap_or_else(|| number.to_string());
        match (old, new) {
            (Some(old), None) => {
                let spot = Spot { new: None, ..spot };
                let message = say!("the module {} `{}` is removed", number, name(&old));
                self.report(&rules::MODULE_REMOVED, &spot, [Some(name(&old)), None], message);
            }
            (None, Some(new)) => {
                let spot = Spot { old: None, ..spot };
                let message = say!("the module {} `{}` is added", number, name(&new));
                self.report(&rules::MODULE_ADDED, &spot, [None, Some(name(&new))], message);
            }
            (Some(old), Some(new)) if essence(&old) != essence(&new) => {
                let message = say!("the module {} `{}` changes", number, name(&new));
                self.report(&rules::MODULE_CHANGED, &spot, [Some(name(&old)), Some(name(&new))], message);
            }
            _ => {}
        }
    }
}

/// A module without its comments.
fn essence(module: &Module) -> Module {
    Module { comments: Vec::new(), ..module.clone() }
}
