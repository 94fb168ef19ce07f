//! The headers of the profiles, and the file attributes of their bodies.

use super::{XddReader, drop_same};
use crate::diagnostic::Findings;
use crate::model::{FileInfo, ProfileHeader};
use crate::xdd::defaults::Placeholders;
use crate::xdd::fact::PlacedText;
use crate::xdd::layout::DescriptionProfile;
use crate::xdd::leftovers::Leftovers;
use crate::xdd::profile_class::ProfileClass;
use crate::xdd::schema::container::DEVICE_BODY;
use crate::xdd::shape;
use crate::xdd::shape::facts;
use crate::xml::{Element, n};

impl<'a> XddReader<'a> {
    /// The headers of both profiles; headers equal to the placeholders are dropped.
    pub(super) fn headers(&mut self) {
        let header = |profile: Option<DescriptionProfile<'a>>| profile.and_then(|profile| profile.header);
        let (device, network) = (header(self.layout.device), header(self.layout.network));
        self.device.headers.device = device.and_then(|element| self.header(element, ProfileClass::Device));
        self.device.headers.network = network.and_then(|element| self.header(element, ProfileClass::Network));
    }

    fn header(&mut self, element: Element<'a>, class: ProfileClass) -> Option<ProfileHeader> {
        let header = shape::read(element, class.header(), &mut self.leftovers);
        let says_nothing = header == class.unstated_header() || header == ProfileHeader::default();
        Some(header).filter(|_| !says_nothing)
    }

    /// The file attributes of the bodies. Of the communication network profile, only differences are kept.
    pub(super) fn files(&mut self) {
        let placeholders = self.placeholders;
        let mut info = |profile: Option<DescriptionProfile<'a>>| {
            profile
                .map(|profile| file_info(profile.body, placeholders, &mut self.leftovers, &mut self.findings))
        };
        let (device, network) = (info(self.layout.device), info(self.layout.network));
        match (device, network) {
            (Some(device), Some(mut network)) => {
                drop_same! { network, device: file_name file_version file_revision creation_time creation_date created_by modification_time
                modification_date modified_by languages device_class invalid_values }
                let says_something = network != FileInfo::default();
                self.device.headers.network_file = Some(Box::new(network)).filter(|_| says_something);
                self.device.file_info = Some(device);
            }
            (device, network) => self.device.file_info = device.or(network),
        }
    }
}

/// The file attributes of a body.
fn file_info<'a>(
    body: Element<'a>,
    placeholders: Placeholders,
    leftovers: &mut Leftovers<'a>,
    findings: &mut Findings,
) -> FileInfo {
    let mut info = FileInfo::default();
    for attribute in body.attributes() {
        let text = PlacedText::of(attribute);
        // the network profile has fewer attributes
        let is_taken = match attribute.tag() {
            n::formatName => text.trimmed() == "CANopen",
            n::formatVersion => text.trimmed() == "1.0",
            // the type of the profile
            n::r#type => true,
            name => facts::take(&mut info, &DEVICE_BODY, name, &text, placeholders, findings),
        };
        if !is_taken {
            leftovers.attribute(body, attribute);
        }
    }
    info
}
