//! What a profile says of itself (`ProfileHeader`, ISO 15745-1).

use std::borrow::Cow;

use super::text::collapsed;
use super::{AttributeField, Leftovers, Markup};
use crate::model::ProfileHeader;
use crate::xml::Element;

/// What a profile is about (`ProfileClassID`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ProfileClass {
    /// The device.
    Device,
    /// The communication network.
    Network,
}

impl ProfileClass {
    const fn name(self) -> &'static str {
        match self {
            Self::Device => "Device",
            Self::Network => "CommunicationNetwork",
        }
    }
}

/// An element that always says the same.
struct Fixed {
    text: &'static str,
    is_read: bool,
}

impl Fixed {
    const fn new(text: &'static str) -> Self {
        Self { text, is_read: false }
    }
}

impl AttributeField for Fixed {
    fn accept(&mut self, text: &str) -> bool {
        let is_it = !self.is_read && collapsed(text) == self.text;
        self.is_read |= is_it;
        is_it
    }

    fn is_set(&self) -> bool {
        self.is_read
    }

    fn text(&self) -> Option<Cow<'_, str>> {
        Some(Cow::Borrowed(self.text))
    }
}

/// Lists the elements once, for reading (`take`) and writing (`put`).
macro_rules! header {
    ($direction:ident, $header:expr, $class:expr, $($context:expr),+) => {
        let ProfileHeader {
            identification, revision, name, source, date, additional_information, interface_types,
        } = $header;
        let class = &mut Fixed::new($class.name());
        let (part, edition, technology) = (&mut Fixed::new("1"), &mut Fixed::new("1"), &mut Fixed::new("CANopen"));
        $direction!($($context),+, [] {
            "ProfileIdentification" @ "#text" => identification,
            "ProfileRevision" @ "#text" => revision,
            "ProfileName" @ "#text" => name,
            "ProfileSource" @ "#text" => source,
            "ProfileClassID" @ "#text" => class,
            "ProfileDate" @ "#text" => date,
            "AdditionalInformation" @ "#text" => additional_information,
            "ISO15745Reference" => [
                "ISO15745Part" @ "#text" => part,
                "ISO15745Edition" @ "#text" => edition,
                "ProfileTechnology" @ "#text" => technology,
            ],
            "IASInterfaceType" @ "#text" => interface_types,
        });
    };
}

/// What a `ProfileHeader` says.
pub(crate) fn read_header<'a>(
    element: Element<'a>,
    class: ProfileClass,
    leftovers: &mut Leftovers<'a>,
) -> ProfileHeader {
    let mut read = ProfileHeader::default();
    header!(take, &mut read, class, element, leftovers);
    read
}

/// Writes a `ProfileHeader`.
pub(crate) fn write_header(header: &ProfileHeader, class: ProfileClass, out: &mut Markup) {
    header!(put, header, class, out, "ProfileHeader");
}
