//! The rules about the profiles of a container: a device profile and a communication network profile.

use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Severity, text_rules};
use crate::source::Span;
use crate::xdd::profile_class::ProfileClass;
use crate::xdd::schema::{self, EXTERNAL_NETWORK_BODY};
use crate::xml::{Attribute, Element, Name, n};

use super::walk::Walk;

text_rules! {
    source: "CiA 311 annex A";

    "cia311/missing-body-type" = MISSING_BODY_TYPE, Error;
    summary: "a profile body does not state its type",
    checks: "`ProfileBody` must have `xsi:type`. Without it the type is derived from the content.",
    why: "The type is abstract in the schema: tools that rely on `xsi:type` cannot read the body.",
    example: r#"`<ProfileBody fileName="drive.xdd">`"#,
    remedy: r#"Add `xsi:type="ProfileBody_Device_CANopen"` or `xsi:type="ProfileBody_CommunicationNetwork_CANopen"`, with the prefix of the namespace if it has one."#,

    "cia311/unknown-body-type" = UNKNOWN_BODY_TYPE, Error;
    summary: "a profile body has a type that CiA 311 does not define",
    checks: "`xsi:type` must be `ProfileBody_Device_CANopen` or `ProfileBody_CommunicationNetwork_CANopen`, with any prefix. Otherwise the type is derived from the content.",
    why: "Tools reject the file or ignore the body.",
    example: r#"`xsi:type="ProfileBody_CANopen"`"#,
    remedy: "Write one of the two types.",

    "cia311/missing-profile" = MISSING_PROFILE, Warning,
        explains NoObjects ["missing-mandatory-object", "no-baud-rate"];
    summary: "one of the two profiles is missing",
    checks: "The container needs a device profile and a communication network profile. A missing communication network profile, which contains the object dictionary, is an error. A missing device profile is a warning.",
    why: "Tools read the vendor and the parameters from the device profile, and the objects from the communication network profile.",
    example: "A container with only a body of type `ProfileBody_Device_CANopen`",
    remedy: "Add the other profile.",
    source: "CiA 311 §5",

    "cia311/duplicate-profile" = DUPLICATE_PROFILE, Error;
    summary: "a profile is defined twice",
    checks: "Only one body of each type is allowed. The first one is used.",
    why: "Some tools use the first one, some the last one.",
    example: r#"Two profiles with `xsi:type="ProfileBody_CommunicationNetwork_CANopen"`"#,
    remedy: "Keep one of them; describe a different device in a separate file.",
    source: "CiA 311 §5",

    "cia311/profile-class-mismatch" = PROFILE_CLASS_MISMATCH, Warning;
    summary: "the header and body of a profile have different classes",
    checks: "`ProfileClassID` must be `Device` before a device body and `CommunicationNetwork` before a communication network body.",
    why: "Tools that select the profile by its header use the wrong body.",
    example: "`<ProfileClassID>Device</ProfileClassID>` before `ProfileBody_CommunicationNetwork_CANopen`",
    remedy: "Write the class of the body.",

    "cia311/contradicting-file-attribute" = CONTRADICTING_FILE_ATTRIBUTE, Warning;
    summary: "the two profiles contradict each other about the file",
    checks: "If both bodies have them, `fileName`, `fileVersion`, and the creation date, time and author must be the same.",
    why: "Both describe the same file. Some tools show one, some the other.",
    example: r#"`fileVersion="2"` in one body and `fileVersion="1"` in the other"#,
    remedy: "Write the same value to both.",

    "cia311/file-name-with-path" = FILE_NAME_WITH_PATH, Note;
    summary: "the file name contains a path",
    checks: "`fileName` must be a name with an extension and without folders.",
    why: "The path is specific to the author's computer.",
    example: r#"`fileName="C:\xdd\drive.xdd"`"#,
    remedy: "Write `drive.xdd`.",

    "cia311/contradicting-identity" = CONTRADICTING_IDENTITY, Warning;
    summary: "the two profiles name different vendors or products",
    checks: "If `DeviceIdentity` and `identity` of the application layers both have `vendorID` or `productID`, the numbers must be the same.",
    why: "Tools compare one or the other with the identity object of the device on the bus.",
    example: "`<vendorID>0x1A3</vendorID>` in one and `<vendorID>0x1A4</vendorID>` in the other",
    remedy: "Write the same number to both.",
}

/// A body, its stated class and its actual class.
#[derive(Clone, Copy)]
pub(super) struct Body {
    stated: Option<ProfileClass>,
    /// Derived from the type, or else from the content.
    class: Option<ProfileClass>,
    /// The class as an element of the schema.
    pub(super) schema: Option<&'static schema::SchemaElement>,
}

/// The body in an element; `None` for any other element.
pub(super) fn body(element: Element<'_>) -> Option<Body> {
    if element.tag() != n::ProfileBody {
        return None;
    }
    let stated = element.attribute(n::r#type).and_then(|attribute| {
        let value = attribute.value();
        let name = value.trim_ascii();
        let local = name.rsplit_once(':').map_or(name, |(_, local)| local);
        ProfileClass::ALL.into_iter().find(|class| class.type_name() == local)
    });
    let has = |class: &ProfileClass| {
        let is_part = |name: Name| class.body().slot(name, 0).is_some() && name != n::ExternalProfileHandle;
        element.children().any(|child| is_part(child.tag()))
    };
    let class = stated.or_else(|| [ProfileClass::Network, ProfileClass::Device].into_iter().find(has));
    let names_file = element.child(n::ExternalProfileHandle).is_some();
    let schema = match class {
        Some(ProfileClass::Network) if names_file && element.child(n::ApplicationLayers).is_none() => {
            Some(&EXTERNAL_NETWORK_BODY.element)
        }
        class => class.map(|class| &class.body().element),
    };
    Some(Body { stated, class, schema })
}

/// Whether a body states its type.
pub(super) fn check_type(element: Element<'_>, body: Body, findings: &mut Findings) {
    if body.stated.is_some() {
        return;
    }
    let [device, network] = ProfileClass::ALL.map(ProfileClass::type_name);
    let help = match body.class {
        Some(class) => format!("write `xsi:type=\"{}\"`", class.type_name()),
        None => format!("write `{device}` or `{network}`"),
    };
    let finding = match element.attribute(n::r#type) {
        Some(attribute) => {
            let message = format!("`{}` is not a profile body type of CiA 311", attribute.value());
            Diagnostic::new(&UNKNOWN_BODY_TYPE, attribute.value_span(), message)
        }
        None => {
            let message = "`ProfileBody` does not state its type";
            Diagnostic::new(&MISSING_BODY_TYPE, element.name_span(), message)
        }
    };
    findings.push(finding.help(help));
}

/// Whether the profiles are consistent.
pub(super) fn check(container: Element<'_>, walk: &mut Walk<'_, '_>) {
    let found = walk.bodies.iter();
    let bodies: Vec<_> = found.filter_map(|&element| Some((element, body(element)?.class?))).collect();
    let first = |class| bodies.iter().find(|(_, other)| *other == class).map(|(element, _)| *element);
    let [device, network] = ProfileClass::ALL.map(first);
    let findings = &mut *walk.findings;
    for &(element, class) in &bodies {
        if let Some(first) = first(class).filter(|first| first.id() != element.id()) {
            findings.push(duplicate(element, first, class));
        }
        check_class(element, class, findings);
    }
    // a body of unknown class may be the missing one
    if bodies.len() == walk.bodies.len() && !bodies.is_empty() {
        check_missing(container, device, network, findings);
    }
    if let (Some(device), Some(network)) = (device, network) {
        check_file_attributes(device, network, findings);
    }
    if let Some(attribute) = device.or(network).and_then(|body| body.attribute(n::fileName)) {
        let value = attribute.value();
        if let Some((_, name)) = value.rsplit_once(['/', '\\']).filter(|(_, name)| !name.is_empty()) {
            let message = format!("`{value}` contains a path");
            let finding = Diagnostic::new(&FILE_NAME_WITH_PATH, attribute.value_span(), message);
            let other = network.and_then(|network| network.attribute(n::fileName)).map(Attribute::value);
            let is_in_both = device.is_some() && other.is_some_and(|other| other == value);
            findings.push(
                finding.help(format!("write `{name}`{}", if is_in_both { " in both profiles" } else { "" })),
            );
        }
    }
}

fn duplicate(element: Element<'_>, first: Element<'_>, class: ProfileClass) -> Diagnostic {
    let what = class.pick("device profile", "communication network profile");
    let message = format!("a second {what}; the first one is used");
    Diagnostic::new(&DUPLICATE_PROFILE, element.name_span(), message)
        .label(first.name_span(), "first here")
        .help("keep one of the two; describe each device in its own file")
}

fn check_class(body: Element<'_>, class: ProfileClass, findings: &mut Findings) {
    let id = body.parent().and_then(|profile| profile.child(n::ProfileHeader)?.child(n::ProfileClassID));
    let Some(id) = id else { return };
    let text = id.text();
    let (stated, right) = (text.trim_ascii(), class.name());
    // other names are not classes of CiA 311
    if stated != right && ProfileClass::ALL.iter().any(|class| class.name() == stated) {
        let message = format!("the class in the header is `{stated}`, but the body is of class `{right}`");
        let finding = Diagnostic::new(&PROFILE_CLASS_MISMATCH, id.text_span(), message);
        findings.push(finding.label(body.name_span(), "the body").help(format!("write `{right}`")));
    }
}

fn check_missing(
    container: Element<'_>,
    device: Option<Element<'_>>,
    network: Option<Element<'_>>,
    findings: &mut Findings,
) {
    let (message, help, severity) = match (device, network) {
        (Some(_), None) => (
            "the communication network profile with the object dictionary is missing",
            "add a profile with a body of type `ProfileBody_CommunicationNetwork_CANopen`",
            Severity::Error,
        ),
        (None, Some(_)) => (
            "the device profile with vendor and product is missing",
            "add a profile with a body of type `ProfileBody_Device_CANopen`",
            Severity::Warning,
        ),
        _ => return,
    };
    let finding = Diagnostic::new(&MISSING_PROFILE, container.name_span(), message);
    findings.push(finding.severity(severity).help(help));
}

fn check_file_attributes(device: Element<'_>, network: Element<'_>, findings: &mut Findings) {
    for name in [n::fileName, n::fileVersion, n::fileCreator, n::fileCreationDate, n::fileCreationTime] {
        let (Some(there), Some(here)) = (device.attribute(name), network.attribute(name)) else { continue };
        let (text_there, text_here) = (there.value(), here.value());
        if text_there.trim_ascii() != text_here.trim_ascii() {
            let places = [(there.value_span(), &*text_there), (here.value_span(), &*text_here)];
            let finding = contradiction(&CONTRADICTING_FILE_ATTRIBUTE, name, places);
            findings.push(finding.help("write the same value to both"));
        }
    }
}

/// The value of `name` in the device profile, and the contradicting one in the communication network profile.
fn contradiction(
    rule: &'static RuleInfo,
    name: Name,
    [(there, text_there), (here, text_here)]: [(Span, &str); 2],
) -> Diagnostic {
    let message =
        format!("`{}` is `{text_here}` here, but `{text_there}` in the device profile", name.text());
    Diagnostic::new(rule, here, message).label(there, "there")
}

/// Whether both profiles identify the same device.
pub(super) fn check_identities(walk: &mut Walk<'_, '_>) {
    let find = |name: Name| walk.seen.of([name]).next();
    let (Some(device), Some(network)) = (find(n::DeviceIdentity), find(n::identity)) else { return };
    for name in [n::vendorID, n::productID] {
        let (Some(there), Some(here)) = (device.child(name), network.child(name)) else { continue };
        let (text_there, text_here) = (there.text(), here.text());
        let (Some(a), Some(b)) = (id_number(&text_there), id_number(&text_here)) else { continue };
        if a != b {
            let places =
                [(there.text_span(), text_there.trim_ascii()), (here.text_span(), text_here.trim_ascii())];
            let finding = contradiction(&CONTRADICTING_IDENTITY, name, places);
            walk.findings.push(finding.help("write the same number to both"));
        }
    }
}

fn id_number(text: &str) -> Option<u64> {
    let text = text.trim_ascii();
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => u64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}
