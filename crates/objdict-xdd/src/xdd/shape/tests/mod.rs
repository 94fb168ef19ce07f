//! Each part from an element to the model and back.

mod values;

use proptest::prelude::*;

use self::values::Any;
use super::*;
use crate::diagnostic::Findings;
use crate::model::{
    ApplicationProcess, DataTypeRef, DeviceFunction, DeviceManager, ExtraSection, Labels, LedType,
    ModuleObjects, Parameter, ProfileHeader, SimpleType,
};
use crate::source::SourceFile;
use crate::xdd::markup::Body;
use crate::xdd::version::XddVersion;
use crate::xml::Tree;

/// The tree of a document without anything to complain about.
fn tree(text: &str) -> Tree {
    let mut findings = Findings::new();
    let tree = Tree::new(SourceFile::from_text("test.xdd", text), &mut findings);
    let messages: Vec<_> = findings.iter().map(|finding| finding.message.clone()).collect();
    assert!(messages.is_empty(), "{messages:?} in\n{text}");
    tree
}

/// What stands in a `ProfileBody`.
fn in_body<T>(
    body: &str,
    read: impl for<'a> Fn(Element<'a>, &mut Leftovers<'a>) -> T,
) -> (T, Vec<ExtraSection>) {
    let tree = tree(&format!("<ProfileBody xmlns:q1='urn:1' xmlns:q2='urn:2'>{body}</ProfileBody>"));
    let mut leftovers = Leftovers::default();
    let element = tree.root().and_then(|root| root.children().next());
    let part = element.map(|element| read(element, &mut leftovers));
    (part.unwrap_or_else(|| panic!("no element in {body}")), leftovers.into_sections())
}

/// What is written in a `ProfileBody`, without what surrounds it.
fn written(version: XddVersion, body: Body, write: impl FnOnce(&mut Markup)) -> String {
    let mut out = Markup::new(version);
    out.open_body(body);
    write(&mut out);
    out.close_body();
    let text = out.finish();
    let start = text.find("<ProfileBody").and_then(|at| Some(at + text[at..].find('>')? + 1)).unwrap_or(0);
    let end = text.rfind("</ProfileBody>").unwrap_or(text.len());
    text[start..end].trim_matches('\n').to_owned()
}

/// What is written in a `ProfileBody`, as if it were not indented there. Texts must not have line ends with two blanks.
fn unindented(version: XddVersion, body: Body, write: impl FnOnce(&mut Markup)) -> String {
    format!("\n{}", written(version, body, write)).replace("\n  ", "\n").trim_start_matches('\n').to_owned()
}

fn read_whole<T: Shape>(text: &str) -> T {
    let (part, left) = in_body(text, T::read);
    assert_eq!(left, [], "everything has a place");
    part
}

/// What is left over of an element, a line for each value.
fn left_over<T: Shape>(text: &str) -> String {
    let mut lines = String::new();
    for ExtraSection { name, entries } in in_body(text, T::read).1 {
        lines.push_str(&format!("[{name}]\n"));
        entries.iter().for_each(|(key, value)| lines.push_str(&format!("{key}={value}\n")));
    }
    lines
}

/// A snippet in the style of version 1.1 is read without a rest, and written again as it stands.
fn stays_as_it_is<T: Shape + serde::Serialize>(snippet: &str, name: &str, body: Body) -> T {
    let part: T = read_whole(snippet);
    let write = |out: &mut Markup| Shape::write(&part, name, out);
    assert_same_lines(&unindented(XddVersion::V1_1, body, write), snippet);
    part
}

fn assert_same_lines(text: &str, expected: &str) {
    let mut pairs = text.lines().zip(expected.lines());
    assert_eq!(pairs.find(|(line, expected)| line != expected), None);
    assert_eq!(text.trim_end().len(), expected.trim_end().len());
}

#[test]
fn application_process() {
    let snippet = include_str!("application.xml");
    let process: ApplicationProcess = stays_as_it_is(snippet, "ApplicationProcess", Body::Device);
    insta::assert_json_snapshot!(process);
}

#[test]
fn device_manager() {
    let manager: DeviceManager = stays_as_it_is(include_str!("manager.xml"), "DeviceManager", Body::Device);
    insta::assert_json_snapshot!(manager);
    let module: DeviceManager = stays_as_it_is(include_str!("module.xml"), "DeviceManager", Body::Device);
    insta::assert_json_snapshot!("module", module);
}

#[test]
fn device_function() {
    let function: DeviceFunction =
        stays_as_it_is(include_str!("function.xml"), "DeviceFunction", Body::Device);
    insta::assert_json_snapshot!(function);
}

#[test]
fn objects_of_modules() {
    let snippet = include_str!("module_objects.xml");
    let objects: ModuleObjects = stays_as_it_is(snippet, "moduleManagement", Body::Network);
    insta::assert_json_snapshot!(objects);
    let snippet = include_str!("own_addressing.xml");
    let objects: ModuleObjects = stays_as_it_is(snippet, "moduleManagement", Body::Network);
    insta::assert_json_snapshot!("own_addressing", objects);
}

#[test]
fn identity() {
    let snippet = include_str!("identity.xml");
    let identity: Identity = read_whole(snippet);
    let write = |out: &mut Markup| Shape::write(&identity, "DeviceIdentity", out);
    assert_same_lines(&unindented(XddVersion::V1_1, Body::Device, write), snippet);
    insta::assert_debug_snapshot!(identity);
}

#[test]
fn header() {
    let snippet = include_str!("header.xml");
    let (header, left) =
        in_body(snippet, |element, leftovers| read_header(element, ProfileClass::Network, leftovers));
    assert_eq!(left, []);
    let write = |out: &mut Markup| write_header(&header, ProfileClass::Network, out);
    assert_same_lines(&unindented(XddVersion::V1_1, Body::Device, write).replace("q1:", ""), snippet);
    insta::assert_json_snapshot!(header);
}

/// The lines of a snippet that version 1.0 has no place for, prefixes aside.
fn missing_in_1_0<T: Shape>(snippet: &str, name: &str, body: Body) -> String {
    let part: T = read_whole(snippet);
    let text = unindented(XddVersion::V1_0, body, |out| Shape::write(&part, name, out));
    let mut lines = text.lines().peekable();
    let mut missing = String::new();
    for line in snippet.replace("q1:", "").lines() {
        if lines.next_if_eq(&line).is_none() {
            missing.push_str(line);
            missing.push('\n');
        }
    }
    // what stands there in their place
    lines.for_each(|line| missing.push_str(&format!("+{line}\n")));
    missing
}

#[test]
fn version_1_0_has_less() {
    let missing = missing_in_1_0::<DeviceManager>(include_str!("manager.xml"), "DeviceManager", Body::Device);
    insta::assert_snapshot!("manager_1_0", missing);
    let missing = missing_in_1_0::<DeviceManager>(include_str!("module.xml"), "DeviceManager", Body::Device);
    assert_eq!(missing.lines().count(), 6, "{missing}");
    let missing =
        missing_in_1_0::<DeviceFunction>(include_str!("function.xml"), "DeviceFunction", Body::Device);
    assert_eq!(missing, "");
    let missing = missing_in_1_0::<Identity>(include_str!("identity.xml"), "DeviceIdentity", Body::Device);
    assert_eq!(missing, "");

    let process: ApplicationProcess = read_whole(include_str!("application.xml"));
    let text =
        unindented(XddVersion::V1_0, Body::Device, |out| Shape::write(&process, "ApplicationProcess", out));
    let variable = text.split("<varDeclaration").nth(1).unwrap_or_default();
    insta::assert_snapshot!("variable_1_0", variable.split("</varDeclaration>").next().unwrap_or_default());
}

/// Written and read again, a part is the same. Version 1.0 may lose something, once.
fn survives<T: Shape + std::fmt::Debug>(part: &T, name: &str, body: Body) {
    let again = |version: XddVersion, part: &T| {
        let text = written(version, body, |out| Shape::write(part, name, out));
        let (again, left) = in_body(&text, T::read);
        assert_eq!(left, [], "{text}");
        again
    };
    assert_eq!(again(XddVersion::V1_1, part), *part);
    let old = again(XddVersion::V1_0, part);
    assert_eq!(again(XddVersion::V1_0, &old), old);
    assert_eq!(again(XddVersion::V1_1, &old), old);
}

proptest! {
    // it is large
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn any_application_process_survives(process in ApplicationProcess::any()) {
        survives(&process, "ApplicationProcess", Body::Device);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_parameter_survives(parameter in Parameter::any()) {
        survives(&parameter, "parameter", Body::Device);
    }

    #[test]
    fn any_device_manager_survives(manager in DeviceManager::any()) {
        survives(&manager, "DeviceManager", Body::Device);
    }

    #[test]
    fn any_device_function_survives(function in DeviceFunction::any()) {
        survives(&function, "DeviceFunction", Body::Device);
    }

    #[test]
    fn any_module_objects_survive(objects in ModuleObjects::any()) {
        survives(&objects, "moduleManagement", Body::Network);
    }

    #[test]
    fn any_identity_survives(identity in Identity::any()) {
        survives(&identity, "DeviceIdentity", Body::Device);
    }

    #[test]
    fn any_header_survives(header in ProfileHeader::any()) {
        let text = written(XddVersion::V1_1, Body::Device, |out| write_header(&header, ProfileClass::Device, out));
        let (again, left) =
            in_body(&text, |element, leftovers| read_header(element, ProfileClass::Device, leftovers));
        prop_assert_eq!(left, []);
        prop_assert_eq!(again, header);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn texts_that_xml_cannot_carry_break_nothing(text in "(\\PC|[\u{0}-\u{20}\u{FFFE}\u{FFFF}<&]){0,12}") {
        let label = |text: &str| Labels::name(text, text);
        let carried = text.replace(|c| matches!(c, '\0'..='\u{8}' | '\u{B}' | '\u{C}' | '\u{E}'..='\u{1F}' | '\u{FFFE}' | '\u{FFFF}'), "\u{FFFD}");
        let document = written(XddVersion::V1_1, Body::Device, |out| Shape::write(&label(&text), "denotation", out));
        prop_assert_eq!(read_whole::<Labels>(&document), label(&carried));
    }
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
    insta::assert_snapshot!(left_over::<Parameter>(text));
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
    insta::assert_snapshot!(left_over::<Parameter>(text));
    let parameter = in_body(text, Parameter::read).0;
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
    insta::assert_snapshot!(left_over::<DeviceManager>(text));
    let manager = in_body(text, DeviceManager::read).0;
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
    let (header, left) =
        in_body(text, |element, leftovers| read_header(element, ProfileClass::Device, leftovers));
    assert_eq!((header.date.as_deref(), header.interface_types.len()), (Some(""), 1));
    insta::assert_json_snapshot!(left);
}
