//! The rules about which elements and attributes there are, and in which order.

use crate::diagnostic::{Diagnostic, Severity, listing, text_rules};
use crate::source::Span;
use crate::xdd::schema::{self, Need, Slot};
use crate::xml::{Attribute, Element, n};

text_rules! {
    /// an element is missing
    ///
    /// ## What it checks
    /// Whether each element contains those that CiA 311 wants in it. What nothing works without, such as `ApplicationLayers` and `CANopenObjectList`, is an error, the rest a warning.
    ///
    /// ## Why it matters
    /// Tools that check a file against the schema refuse it.
    ///
    /// ## Example
    /// `<DeviceFunction/>` without `capabilities`
    ///
    /// ## How to mend
    /// Add the element.
    ///
    /// ## Source
    /// CiA 311 annex A
    MISSING_ELEMENT = "cia311/missing-element", Warning;

    /// an attribute is missing
    ///
    /// ## What it checks
    /// Whether each element has the attributes that CiA 311 wants. Those without which the element means nothing, such as `index` of an object and `uniqueID` of a parameter, are an error, the rest a warning.
    ///
    /// ## Why it matters
    /// Tools that check a file against the schema refuse it, others put in zeros.
    ///
    /// ## Example
    /// `<CANopenGeneralFeatures nrOfRxPDO="4"/>` without `granularity`
    ///
    /// ## How to mend
    /// Add the attribute.
    ///
    /// ## Source
    /// CiA 311 annex A
    MISSING_ATTRIBUTE = "cia311/missing-attribute", Warning;

    /// an element that the standard does not have there
    ///
    /// ## What it checks
    /// Whether CiA 311 has each element in the place where it stands. Elements in a namespace of their own are a note. They are kept.
    ///
    /// ## Why it matters
    /// Tools that check a file against the schema refuse it, others pass over the element with everything in it.
    ///
    /// ## Example
    /// `<defaultvalue value="1"/>` in `allowedValues`
    ///
    /// ## How to mend
    /// Check the spelling and the place. What a manufacturer adds to a parameter belongs into `property`.
    ///
    /// ## Source
    /// CiA 311 annex A
    UNKNOWN_ELEMENT = "cia311/unknown-element", Warning;

    /// an attribute that its element does not have
    ///
    /// ## What it checks
    /// Whether CiA 311 has each attribute in its element. Attributes with a prefix belong to others and are not looked at. They are kept.
    ///
    /// ## Why it matters
    /// Tools that check a file against the schema refuse it, others pass over the attribute.
    ///
    /// ## Example
    /// `<CANopenObject index="1000" sub="0">`
    ///
    /// ## How to mend
    /// Check the spelling, or remove the attribute.
    ///
    /// ## Source
    /// CiA 311 annex A
    UNKNOWN_ATTRIBUTE = "cia311/unknown-attribute", Warning;

    /// a name differs from that of the standard in capital letters
    ///
    /// ## What it checks
    /// Whether elements and attributes that CiA 311 does not have are names of CiA 311 in other letters. They are taken for those.
    ///
    /// ## Why it matters
    /// XML tells capital letters from small ones: other tools do not find the value. Some versions of CANopenEditor write `NodeID` for `nodeID`.
    ///
    /// ## Example
    /// `<deviceCommissioning NodeID="5">`
    ///
    /// ## How to mend
    /// Write the name as the standard has it.
    ///
    /// ## Source
    /// CiA 311 annex A
    MISSPELT_NAME = "cia311/misspelt-name", Warning;

    /// elements stand in another order than the standard has
    ///
    /// ## What it checks
    /// Whether the elements in an element stand in the order of CiA 311. The first one that does not is shown.
    ///
    /// ## Why it matters
    /// Tools that check a file against the schema refuse it. Most read it all the same.
    ///
    /// ## Example
    /// `<defaultValue value="1"/>` before `<UINT/>`
    ///
    /// ## How to mend
    /// Move the element.
    ///
    /// ## Source
    /// CiA 311 annex A
    WRONG_ORDER = "cia311/wrong-order", Warning;

    /// an element stands twice
    ///
    /// ## What it checks
    /// Whether elements that CiA 311 has once, such as the data type of a parameter, stand once. The first one is read.
    ///
    /// ## Why it matters
    /// Some tools take the first one, some the last one, some refuse the file.
    ///
    /// ## Example
    /// `<UINT/>` and `<UDINT/>` in one parameter
    ///
    /// ## How to mend
    /// Keep one of them.
    ///
    /// ## Source
    /// CiA 311 annex A
    REPEATED_ELEMENT = "cia311/repeated-element", Error;

    /// text stands where only elements belong
    ///
    /// ## What it checks
    /// Whether there is text directly in an element that takes none.
    ///
    /// ## Why it matters
    /// Nobody reads it. Perhaps a tag around it was lost, or it was meant to be a comment.
    ///
    /// ## Example
    /// `<parameter uniqueID="P1">Speed<UINT/></parameter>`
    ///
    /// ## How to mend
    /// Put it into a `label` or `description`, or between `<!--` and `-->`.
    ///
    /// ## Source
    /// CiA 311 annex A
    STRAY_TEXT = "cia311/stray-text", Warning;

    /// version 1.0 does not have this
    ///
    /// ## What it checks
    /// Whether a file in the namespace of version 1.0 has elements or attributes that came with version 1.1.
    ///
    /// ## Why it matters
    /// Tools for version 1.0 pass over them, or refuse the file.
    ///
    /// ## Example
    /// `<moduleManagement>` in `http://www.canopen.org/xml/1.0`
    ///
    /// ## How to mend
    /// Remove it, or make the file one of version 1.1.
    ///
    /// ## Source
    /// CiA 311 annex A
    NEWER_VERSION = "cia311/newer-version", Warning;
}

/// The attribute whose name someone wrote in other letters.
pub(super) fn meant_attribute(
    element: Element<'_>,
    schema: &'static schema::Element,
    attribute: Attribute<'_>,
) -> Option<(usize, &'static schema::Attribute)> {
    let is_meant = |known: &schema::Attribute| {
        known.need != Need::Stray && known.name.text().eq_ignore_ascii_case(attribute.name())
    };
    let (number, known) = schema.attributes.iter().enumerate().find(|(_, known)| is_meant(known))?;
    element.attribute(known.name).is_none().then_some((number, known))
}

pub(super) fn unknown_attribute(
    element: Element<'_>,
    attribute: Attribute<'_>,
    meant: Option<(usize, &schema::Attribute)>,
) -> Diagnostic {
    if let Some((_, meant)) = meant {
        return misspelt(attribute.name_span(), attribute.name(), meant.name.text());
    }
    let message = format!("`{}` has no attribute `{}`; it is kept", element.name(), attribute.name());
    Diagnostic::new(&UNKNOWN_ATTRIBUTE, attribute.name_span(), message)
        .help("check the spelling; tools that check against the schema refuse it")
}

/// The element whose name someone wrote in other letters.
pub(super) fn meant_element(
    schema: &'static schema::Element,
    child: Element<'_>,
) -> Option<(usize, &'static schema::Element)> {
    let name = child.name();
    schema.content.iter().enumerate().find_map(|(number, slot)| {
        let meant = slot
            .of
            .iter()
            .find(|element| element.name.text().eq_ignore_ascii_case(name) && slot.need != Need::Stray)?;
        Some((number, *meant))
    })
}

pub(super) fn unknown_element(
    parent: Element<'_>,
    child: Element<'_>,
    meant: Option<(usize, &schema::Element)>,
    is_ours: bool,
) -> Diagnostic {
    if let Some((_, meant)) = meant {
        return misspelt(child.name_span(), child.name(), meant.name.text());
    }
    let message = format!("`{}` has no element `{}` in it; it is kept", parent.name(), child.name());
    Diagnostic::new(&UNKNOWN_ELEMENT, child.name_span(), message)
        .severity(if is_ours { Severity::Warning } else { Severity::Note })
        .help("check the spelling and the place; tools that check against the schema refuse it")
}

fn misspelt(at: Span, name: &str, meant: &str) -> Diagnostic {
    let message = format!("`{name}` is spelt `{meant}` in the standard");
    Diagnostic::new(&MISSPELT_NAME, at, message).help(format!("write `{meant}`"))
}

pub(super) fn missing_attribute(element: Element<'_>, attribute: &schema::Attribute) -> Diagnostic {
    let message = format!("`{}` lacks the attribute `{}`", element.name(), attribute.name.text());
    Diagnostic::new(&MISSING_ATTRIBUTE, element.name_span(), message)
        .severity(severity(attribute.need))
        .help(format!("add `{}=\"…\"`", attribute.name.text()))
}

fn severity(need: Need) -> Severity {
    if need == Need::Key { Severity::Error } else { Severity::Warning }
}

pub(super) fn missing_element(element: Element<'_>, slot: &Slot, count: u32) -> Diagnostic {
    let parent = element.name();
    let names = slot.of.iter().map(|element| element.name.text());
    let (message, help) = match (slot.of, count) {
        ([one], 0) => {
            (format!("`{parent}` lacks `{}`", one.name.text()), format!("add `{}`", one.name.text()))
        }
        ([one], _) => {
            let message =
                format!("`{parent}` has {count} `{}`; it takes {} at least", one.name.text(), slot.least);
            (message, format!("add another `{}`", one.name.text()))
        }
        ([first, ..], _) if first.name == n::label => {
            (format!("`{parent}` has neither a name nor a description"), "add a `label`".to_owned())
        }
        ([_, _, _, _, _, ..], _) => (
            format!("`{parent}` has no data type"),
            "add the element of a simple type, such as `UINT`, or `dataTypeIDRef`".to_owned(),
        ),
        _ => (format!("`{parent}` has none of {}", listing(names)), "add one of them".to_owned()),
    };
    Diagnostic::new(&MISSING_ELEMENT, element.name_span(), message).severity(severity(slot.need)).help(help)
}

/// `child` belongs before `last`.
pub(super) fn wrong_order(parent: Element<'_>, child: Element<'_>, last: Option<Element<'_>>) -> Diagnostic {
    let last_name = last.map_or("", Element::name);
    let message = format!("in `{}`, `{}` belongs before `{last_name}`", parent.name(), child.name());
    let finding = Diagnostic::new(&WRONG_ORDER, child.name_span(), message);
    let finding = match last {
        Some(last) => finding.label(last.name_span(), "stands before it"),
        None => finding,
    };
    finding.help(format!("move `{}` up", child.name()))
}

pub(super) fn repeated_element(parent: Element<'_>, child: Element<'_>, first: Element<'_>) -> Diagnostic {
    let (parent, name, first_name) = (parent.name(), child.name(), first.name());
    let message = if name == first_name {
        format!("`{name}` stands in `{parent}` once only; the first one is read")
    } else {
        format!("`{parent}` has `{first_name}` already, so it takes no `{name}`")
    };
    Diagnostic::new(&REPEATED_ELEMENT, child.name_span(), message)
        .label(first.name_span(), "first here")
        .help("keep one of the two")
}

pub(super) fn stray_text(element: Element<'_>, at: Span) -> Diagnostic {
    let text = at.of(element.tree().text());
    let text = match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    };
    let message = format!("`{}` takes no text, but there is `{text}`", element.name());
    Diagnostic::new(&STRAY_TEXT, at, message)
        .help("put it into a `label` or `description`, or make it a comment")
}

pub(super) fn newer_attribute(element: Element<'_>, attribute: Attribute<'_>) -> Diagnostic {
    let message = format!("version 1.0 has no attribute `{}` of `{}`", attribute.name(), element.name());
    Diagnostic::new(&NEWER_VERSION, attribute.name_span(), message)
        .help("remove it, or make the file one of version 1.1")
}

pub(super) fn newer_element(parent: Element<'_>, child: Element<'_>) -> Diagnostic {
    let message = format!("version 1.0 has no `{}` in `{}`", child.name(), parent.name());
    Diagnostic::new(&NEWER_VERSION, child.name_span(), message)
        .help("remove it, or make the file one of version 1.1")
}
