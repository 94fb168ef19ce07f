//! Round trips of each part: from an element to the model and back.

use super::*;
use crate::diagnostic::Findings;
use crate::model::{
    ApplicationProcess, DataTypeRef, DeviceFunction, DeviceManager, ExtraSection, Labels, LedType,
    ModuleObjects, Parameter, ProfileHeader, SimpleType,
};
use crate::source::SourceFile;
use crate::xdd::profile_class::ProfileClass::{self, Device, Network};
use crate::xdd::schema::{
    APPLICATION_PROCESS, DEVICE_FUNCTION, DEVICE_HEADER, DEVICE_IDENTITY, DEVICE_MANAGER, MODULE_MANAGEMENT,
    NETWORK_HEADER, Occurrence, PARAMETER, SchemaElement, TextKind, application, device, network,
};
use crate::xdd::version::XddVersion;
use crate::xml::Tree;

/// The part in a `ProfileBody`, and the leftovers.
fn in_body<T>(body: &str, schema: &'static Shape<T>) -> (T, Vec<ExtraSection>) {
    let text = format!("<ProfileBody xmlns:q1='urn:1' xmlns:q2='urn:2'>{body}</ProfileBody>");
    let mut findings = Findings::new();
    let tree = Tree::new(SourceFile::from_text("test.xdd", text.as_str()), &mut findings);
    let messages: Vec<_> = findings.iter().map(|finding| finding.message.clone()).collect();
    assert!(messages.is_empty(), "{messages:?} in\n{text}");
    let mut leftovers = Leftovers::default();
    let element = tree.root().and_then(|root| root.children().next());
    let part = element.map(|element| read(element, schema, &mut leftovers));
    (part.unwrap_or_else(|| panic!("no element in {body}")), leftovers.into_sections())
}

/// The output inside a `ProfileBody`, without its indentation. Texts must not contain line ends with
/// two spaces.
fn unindented(version: XddVersion, body: ProfileClass, put: impl FnOnce(&mut XddWriter)) -> String {
    format!("\n{}", written(version, body, put)).replace("\n  ", "\n").trim_start_matches('\n').to_owned()
}

/// The output inside a `ProfileBody`, without the surrounding elements.
fn written(version: XddVersion, body: ProfileClass, put: impl FnOnce(&mut XddWriter)) -> String {
    let mut out = XddWriter::unchecked(version);
    out.open_body(body, body.body());
    put(&mut out);
    out.close_body();
    let (text, _) = out.finish();
    let start = text.find("<ProfileBody").and_then(|at| Some(at + text[at..].find('>')? + 1)).unwrap_or(0);
    let end = text.rfind("</ProfileBody>").unwrap_or(text.len());
    text[start..end].trim_matches('\n').to_owned()
}

fn read_whole<T>(text: &str, schema: &'static Shape<T>) -> T {
    let (part, left) = in_body(text, schema);
    assert_eq!(left, [], "everything has a place in {text}");
    part
}

/// The leftovers of an element, one line for each value.
fn left_over<T>(text: &str, schema: &'static Shape<T>) -> String {
    let mut lines = String::new();
    for section in in_body::<T>(text, schema).1 {
        lines.push_str(&format!("[{}]\n", section.name()));
        section.entries().for_each(|(key, value)| lines.push_str(&format!("{key}={value}\n")));
    }
    lines
}

/// A snippet in the style of version 1.1 is read without leftovers and written unchanged.
fn stays_as_it_is<T>(snippet: &str, schema: &'static Shape<T>, body: ProfileClass) -> T {
    let part: T = read_whole(snippet, schema);
    let text = unindented(XddVersion::V1_1, body, |out| write(&part, schema, out));
    let mut pairs = text.lines().zip(snippet.lines());
    assert_eq!(pairs.find(|(line, expected)| line != expected), None);
    assert_eq!(text.trim_end().len(), snippet.trim_end().len());
    part
}

#[test]
fn application_process() {
    let snippet = include_str!("application.xml");
    let process: ApplicationProcess = stays_as_it_is(snippet, &APPLICATION_PROCESS, Device);
    insta::assert_json_snapshot!(process);
}

#[test]
fn device_manager() {
    let manager: DeviceManager = stays_as_it_is(include_str!("manager.xml"), &DEVICE_MANAGER, Device);
    insta::assert_json_snapshot!(manager);
    let module: DeviceManager = stays_as_it_is(include_str!("module.xml"), &DEVICE_MANAGER, Device);
    insta::assert_json_snapshot!("module", module);
}

#[test]
fn device_function() {
    let function: DeviceFunction = stays_as_it_is(include_str!("function.xml"), &DEVICE_FUNCTION, Device);
    insta::assert_json_snapshot!(function);
}

#[test]
fn objects_of_modules() {
    let snippet = include_str!("module_objects.xml");
    let objects: ModuleObjects = stays_as_it_is(snippet, &MODULE_MANAGEMENT, Network);
    insta::assert_json_snapshot!(objects);
    let snippet = include_str!("own_addressing.xml");
    let objects: ModuleObjects = stays_as_it_is(snippet, &MODULE_MANAGEMENT, Network);
    insta::assert_json_snapshot!("own_addressing", objects);
}

#[test]
fn identity() {
    let identity: IdentityContent = stays_as_it_is(include_str!("identity.xml"), &DEVICE_IDENTITY, Device);
    let marks = identity.rest.read_only;
    assert!(marks.iter().any(|(name, _)| &**name == "orderNumber[2]"), "{marks:?}");
}

#[test]
fn header() {
    let header: ProfileHeader = stays_as_it_is(include_str!("header.xml"), &NETWORK_HEADER, Network);
    insta::assert_json_snapshot!(header);
}

/// The lines of a snippet that version 1.0 does not have, ignoring prefixes.
fn missing_in_1_0<T>(snippet: &str, schema: &'static Shape<T>, body: ProfileClass) -> String {
    let part: T = read_whole(snippet, schema);
    let text = unindented(XddVersion::V1_0, body, |out| write(&part, schema, out));
    let mut lines = text.lines().peekable();
    let mut missing = String::new();
    for line in snippet.replace("q1:", "").lines() {
        if lines.next_if_eq(&line).is_none() {
            missing.push_str(line);
            missing.push('\n');
        }
    }
    // the lines that replace them
    lines.for_each(|line| missing.push_str(&format!("+{line}\n")));
    missing
}

#[test]
fn version_1_0_has_less() {
    let missing = missing_in_1_0::<DeviceManager>(include_str!("manager.xml"), &DEVICE_MANAGER, Device);
    insta::assert_snapshot!("manager_1_0", missing);
    let missing = missing_in_1_0::<DeviceManager>(include_str!("module.xml"), &DEVICE_MANAGER, Device);
    assert_eq!(missing.lines().count(), 6, "{missing}");
    let missing = missing_in_1_0::<IdentityContent>(include_str!("identity.xml"), &DEVICE_IDENTITY, Device);
    assert_eq!(missing, "");

    let process: ApplicationProcess = read_whole(include_str!("application.xml"), &APPLICATION_PROCESS);
    let text = unindented(XddVersion::V1_0, Device, |out| write(&process, &APPLICATION_PROCESS, out));
    let variable = text.split("<varDeclaration").nth(1).unwrap_or_default();
    insta::assert_snapshot!("variable_1_0", variable.split("</varDeclaration>").next().unwrap_or_default());
}

/// Writes random content that the table allows in an element.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }

    fn value(&mut self, kind: TextKind) -> String {
        // texts that are hard to preserve
        const TEXTS: [&str; 6] = ["a", "<b> & \"c\" ", " '\t", "&#10;]]>", "\r\nд", "<!--😀\u{FEFF}"];
        match kind {
            TextKind::Boolean => ["true", "false"][self.roll(2) as usize].to_owned(),
            TextKind::Number(low, _) => (low.max(0) + i128::from(self.roll(99))).to_string(),
            TextKind::Word(words) => words[self.roll(words.len() as u64) as usize].to_owned(),
            TextKind::Date => "2024-02-29".to_owned(),
            _ => TEXTS[self.roll(6) as usize].to_owned(),
        }
    }

    fn element(&mut self, element: &'static SchemaElement, depth: u32, out: &mut XddWriter) {
        out.open(element);
        for attribute in element.attributes {
            if attribute.need == Occurrence::Key || self.roll(2) == 0 {
                out.attribute(attribute.name, &self.value(attribute.kind));
            }
        }
        match (element.name, element.text) {
            (n::ISO15745Part | n::ISO15745Edition, _) => out.text("1"),
            (n::ProfileTechnology, _) => out.text("CANopen"),
            (n::ProfileClassID, _) => out.text("Device"),
            (_, Some(text)) => out.text(&self.value(text.kind)),
            (_, None) => {}
        }
        for slot in element.content {
            let many = if slot.need == Occurrence::Stray { 2 } else { u64::from(slot.most.min(3)) + 1 };
            // stray elements replace others
            let is_other = depth > 9 || slot.of[0].name == n::variableRef && slot.need == Occurrence::Stray;
            // a text without labels has no mark
            let least = u64::from(slot.least > 0 && element.attribute(n::readOnly).is_some());
            for _ in 0..if is_other { 0 } else { self.roll(many).max(least) } {
                let child = slot.of[self.roll(slot.of.len() as u64) as usize];
                self.element(child, depth + 1, out);
            }
        }
        out.close();
    }
}

/// The fields of a part in debug format, each with its value.
fn fields(part: &impl std::fmt::Debug) -> Vec<String> {
    let shown = format!("{part:#?}").replace("\n     ", "\u{0}");
    let fields = shown.lines().filter_map(|line| line.strip_prefix("    "));
    fields
        .filter(|line| line.starts_with(|first: char| first.is_ascii_lowercase()))
        .map(str::to_owned)
        .collect()
}

/// All content that the table allows has a place in the model and survives a round trip. Version 1.0 may
/// lose content once. Every field is named in the table.
fn survives<T: PartialEq + std::fmt::Debug>(schema: &'static Shape<T>, body: ProfileClass) {
    let again = |version: XddVersion, part: &T| -> T {
        read_whole(&written(version, body, |out| write(part, schema, out)), schema)
    };
    let mut silent = fields(&(schema.new)());
    for seed in 0..100 {
        let text = written(XddVersion::V1_1, body, |out| Dice(seed).element(schema, 0, out));
        let part: T = read_whole(&text, schema);
        assert_eq!(again(XddVersion::V1_1, &part), part, "{text}");
        silent.retain(|field| fields(&part).contains(field));
        let old = again(XddVersion::V1_0, &part);
        assert_eq!(again(XddVersion::V1_1, &old), old, "{text}");
    }
    assert_eq!(silent, [""; 0], "not in the table");
}

#[test]
fn whatever_the_table_allows_survives() {
    survives(&device::LED, Device);
    survives(&device::LED_STATE, Device);
    survives(&device::COMBINED_STATE, Device);
    survives(&device::INTERFACE, Device);
    survives(&device::MODULE_TYPE, Device);
    survives(&device::CONNECTED_MODULE, Device);
    survives(&device::MODULE_INTERFACE, Device);
    survives(&device::CHARACTERISTICS_LIST, Device);
    survives(&device::CHARACTERISTIC, Device);
    survives(&device::COMPLIANT_WITH, Device);
    survives(&device::PICTURE, Device);
    survives(&device::DICTIONARY, Device);
    survives(&application::SUBRANGE, Device);
    survives(&application::ENUM_VALUE, Device);
    survives(&application::COUNT, Device);
    survives(&application::VAR_DECLARATION, Device);
    survives(&application::FUNCTION_TYPE, Device);
    survives(&application::VERSION_INFO, Device);
    survives(&application::FUNCTION_INSTANCE_LIST, Device);
    survives(&application::FUNCTION_INSTANCE, Device);
    survives(&application::CONNECTION, Device);
    survives(&application::ALLOWED_VALUES_TEMPLATE, Device);
    survives(&application::ALLOWED_VALUES, Device);
    survives(&application::VALUE, Device);
    survives(&application::RANGE, Device);
    survives(&application::VARIABLE_REF, Device);
    survives(&application::MEMBER_REF, Device);
    survives(&application::UNIT, Device);
    survives(&application::PROPERTY, Device);
    survives(&application::PARAMETER_GROUP, Device);
    survives(&PARAMETER, Device);
    survives(&network::INTERFACE, Network);
    survives(&network::MODULE_INTERFACE, Network);
    survives(&APPLICATION_PROCESS, Device);
    survives(&DEVICE_MANAGER, Device);
    survives(&DEVICE_FUNCTION, Device);
    survives(&MODULE_MANAGEMENT, Network);
    survives(&DEVICE_IDENTITY, Device);
    survives(&DEVICE_HEADER, Device);
}

#[test]
fn what_a_part_does_not_know_is_left_over() {
    let text = r#"
        <parameter uniqueID="P" colour="red" xml:space="preserve">
            <label lang="en" tone="high">Force<b>!</b></label>
            <label>second</label>
            stray text
            <shade depth="3"><tone>dark</tone><tone n="2"/>  lines
of text </shade>
            <UINT size="2">16</UINT>
            <unit multiplier="1" scale="log"><label lang="en">N</label></unit>
            <property name="a" value="1"/><property name="b" value="2" also="3"/>
        </parameter>"#;
    insta::assert_snapshot!(left_over::<Parameter>(text, &PARAMETER));
}

#[test]
fn the_first_of_two_counts() {
    let text = r#"
        <parameter uniqueID="P">
            <UINT/><INT/><dataTypeIDRef uniqueIDRef="T"/><variableRef position="2"/>
            <unit multiplier="1"/><unit multiplier="2"/>
            <denotation><label lang="en">first</label></denotation>
            <denotation><label lang="de">zweite</label></denotation>
            <allowedValues><range>
                <minValue value="1"/><minValue value="2"/><maxValue value="3"/>
            </range></allowedValues>
        </parameter>"#;
    insta::assert_snapshot!(left_over::<Parameter>(text, &PARAMETER));
    let parameter: Parameter = in_body(text, &PARAMETER).0;
    assert_eq!(parameter.data_type, Some(DataTypeRef::Simple(SimpleType::Uint)));
    assert_eq!(parameter.unit.map(|unit| unit.multiplier).as_deref(), Some("1"));
    assert_eq!(parameter.denotation, Labels::name("en", "first"));
}

#[test]
fn what_is_no_value_of_its_field_is_left_over() {
    let text = r#"
        <DeviceManager><indicatorList lit="yes"><LEDList>
            <LED LEDcolors="tricolor" LEDtype=" IO ">
                <LEDstate uniqueID="S" state="ON" LEDcolor="red" flashingPeriod="4294967296" impulsWidth="-1"/>
            </LED>
            <combinedState><LEDstateRef stateIDRef="S" note="x">text</LEDstateRef><LEDstateRef/></combinedState>
        </LEDList>not here</indicatorList></DeviceManager>"#;
    insta::assert_snapshot!(left_over::<DeviceManager>(text, &DEVICE_MANAGER));
    let manager: DeviceManager = in_body(text, &DEVICE_MANAGER).0;
    assert_eq!(manager.leds.first().and_then(|led| led.kind), Some(LedType::Io));
    assert_eq!(manager.combined_states.first().map(|state| state.states.len()), Some(2));
}

#[test]
fn a_header_of_another_kind_is_left_over() {
    let text = r#"
        <ProfileHeader kind="x">
            <ProfileClassID>Equipment</ProfileClassID>
            <ISO15745Reference>
                <ISO15745Part> 1 </ISO15745Part><ISO15745Part>4</ISO15745Part>
                <ProfileTechnology>Powerlink</ProfileTechnology>
            </ISO15745Reference>
            <ProfileDate/><IASInterfaceType/>
        </ProfileHeader>"#;
    let (header, left): (ProfileHeader, _) = in_body(text, &DEVICE_HEADER);
    assert_eq!((header.date.as_deref(), header.interface_types.len()), (Some(""), 1));
    insta::assert_json_snapshot!(left);
}
