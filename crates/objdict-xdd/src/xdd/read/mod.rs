//! Reads XDD and XDC texts into the model. Reading never fails: unreadable content becomes a finding,
//! an invalid value or a leftover.

mod absorb;
mod entry;
mod identity;
mod network;
mod objects;
mod parameters;
mod project;

pub(crate) use self::entry::EntryAttributes;
use self::parameters::ParameterSlot;
use super::defaults::{self, Placeholders};
use super::layout::{DescriptionProfile, Layout, containers};
use super::leftovers::Leftovers;
use super::schema::{APPLICATION_PROCESS, DEVICE_FUNCTION, DEVICE_MANAGER};
use super::shape;
use crate::diagnostic::Findings;
use crate::model::{ApplicationProcess, Device, DeviceInfo, DeviceKind, FileInfo};
use crate::xml::{Element, Tree, n};

/// Clears the fields of the communication network profile that are equal in the device profile.
macro_rules! drop_same {
    ($own:ident, $device:ident: $($field:ident)+) => {
        $(if $own.$field == $device.$field {
            $own.$field = Default::default();
        })+
    };
}
use drop_same;

/// Reads one of the [`containers`] of a tree as the description of a device type or, if `kind` requests it
/// or the container has a node, of a node.
pub fn read(tree: &Tree, number: usize, kind: DeviceKind) -> (Device, Findings) {
    match containers(tree).get(number) {
        Some(&container) => read_container(container, kind),
        None => (Device { kind, ..Device::default() }, Findings::new()),
    }
}

/// Reads one of the [`containers`] of a tree.
fn read_container(container: Element<'_>, kind: DeviceKind) -> (Device, Findings) {
    let mut reader = XddReader::new(Layout::of_container(container), Placeholders::Dropped);
    reader.headers();
    reader.files();
    reader.device_body();
    reader.network_body();
    if let Some(device) = reader.layout.project() {
        reader.project(device);
    }
    reader.derive_lists();
    reader.finish(kind)
}

/// The file, device and node of the first of the [`containers`], as seen by a tool that does not know the writer's
/// placeholders. Objects are not read.
pub fn read_literally(tree: &Tree, kind: DeviceKind) -> Device {
    let Some(&container) = containers(tree).first() else { return Device::default() };
    let mut reader = XddReader::new(Layout::of_container(container), Placeholders::Kept);
    reader.files();
    let identity = reader.layout.device.and_then(|profile| profile.body.child(n::DeviceIdentity));
    if let Some(identity) = identity {
        reader.device_identity(identity);
    }
    reader.network_body();
    reader.finish(kind).0
}

/// A description during reading.
struct XddReader<'a> {
    layout: Layout<'a>,
    device: Device,
    findings: Findings,
    leftovers: Leftovers<'a>,
    placeholders: Placeholders,
}

impl<'a> XddReader<'a> {
    fn new(layout: Layout<'a>, placeholders: Placeholders) -> Self {
        Self {
            layout,
            device: Device::default(),
            findings: Findings::new(),
            leftovers: Leftovers::default(),
            placeholders,
        }
    }

    /// The device information, created if needed.
    fn info(&mut self) -> &mut DeviceInfo {
        self.device.device_info.get_or_insert_default()
    }

    /// The device profile without its file attributes, and the objects that refer to it.
    fn device_body(&mut self) {
        let (mut application, parameters) = match self.layout.device {
            Some(DescriptionProfile { body, .. }) => self.device_parts(body),
            None => Default::default(),
        };
        self.objects(&mut application, parameters);
        application.retain(|process| *process != Default::default());
        self.device.application = application;
        self.device.manager = self.device.manager.take().filter(|manager| **manager != Default::default());
        if defaults::is_function_invented(&self.device.functions) {
            self.device.functions = Vec::new();
        }
    }

    /// Reads the parts of the device profile. Parameters of the application processes are only collected,
    /// because objects refer to them.
    fn device_parts(&mut self, body: Element<'a>) -> (Vec<ApplicationProcess>, Vec<ParameterSlot<'a>>) {
        let mut application = Vec::new();
        let mut slots = Vec::new();
        let mut has_identity = false;
        for element in body.children() {
            match element.tag() {
                n::DeviceIdentity if !std::mem::replace(&mut has_identity, true) => {
                    self.device_identity(element);
                }
                n::DeviceManager if self.device.manager.is_none() => {
                    self.device.manager =
                        Some(Box::new(shape::read(element, &DEVICE_MANAGER, &mut self.leftovers)));
                }
                n::DeviceFunction => {
                    let function = shape::read(element, &DEVICE_FUNCTION, &mut self.leftovers);
                    self.device.functions.push(function);
                }
                n::ApplicationProcess => {
                    let (process, found) =
                        shape::read_without(element, &APPLICATION_PROCESS, n::parameter, &mut self.leftovers);
                    slots.extend(
                        found.into_iter().map(|parameter| ParameterSlot::new(parameter, application.len())),
                    );
                    application.push(process);
                }
                _ => self.leftovers.element(element),
            }
        }
        self.leftovers.text(body);
        (application, slots)
    }

    fn finish(mut self, kind: DeviceKind) -> (Device, Findings) {
        let device = &mut self.device;
        device.file_info = device.file_info.take().filter(|info| *info != FileInfo::default());
        device.device_info = device.device_info.take().filter(|info| *info != DeviceInfo::default());
        device.identity = device.identity.take().filter(|identity| **identity != Default::default());
        device.kind = match device.commissioning {
            Some(_) => DeviceKind::Node,
            None => kind,
        };
        device.extra = self.leftovers.into_sections();
        (self.device, self.findings)
    }
}
