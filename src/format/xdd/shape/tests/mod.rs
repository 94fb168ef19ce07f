//! Each part from an element to the model and back.

mod values;

use proptest::prelude::*;

use super::*;
use crate::diagnostic::Findings;
use crate::format::xdd::markup::Body;
use crate::format::xdd::version::XddVersion;
use crate::format::xml::Tree;
use crate::model::{
    ApplicationProcess, DeviceFunction, DeviceManager, ExtraSection, Labels, ModuleObjects, Parameter,
    ProfileHeader,
};
use crate::source::SourceFile;

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

/// What is written in a `ProfileBody`, without what surrounds it and as if it were not indented.
fn written(version: XddVersion, body: Body, write: impl FnOnce(&mut Markup)) -> String {
    let mut out = Markup::new(version);
    out.open_body(body);
    write(&mut out);
    out.close_body();
    let text = out.finish();
    let start = text.find("<ProfileBody").and_then(|at| Some(at + text[at..].find('>')? + 1)).unwrap_or(0);
    let end = text.rfind("</ProfileBody>").unwrap_or(text.len());
    text[start..end].replace("\n  ", "\n").trim_start_matches('\n').to_owned()
}

fn read_whole<T: Shape>(text: &str) -> T {
    let (part, left) = in_body(text, T::read);
    assert_eq!(left, [], "everything has a place");
    part
}

/// A snippet in the style of version 1.1 is read without a rest, and written again as it stands.
fn stays_as_it_is<T: Shape + serde::Serialize>(snippet: &str, name: &str, body: Body) -> T {
    let part: T = read_whole(snippet);
    let write = |out: &mut Markup| Shape::write(&part, name, out);
    assert_same_lines(&written(XddVersion::V1_1, body, write), snippet);
    assert_same_lines(&written(XddVersion::V1_0, body, write), &snippet.replace("q1:", ""));
    part
}

fn assert_same_lines(text: &str, expected: &str) {
    let mut pairs = text.lines().zip(expected.lines());
    assert_eq!(pairs.find(|(line, expected)| line != expected), None);
    assert_eq!(text.len(), expected.len());
}

#[test]
fn application_process() {
    let snippet = include_str!("application.xml");
    let process: ApplicationProcess = stays_as_it_is(snippet, "ApplicationProcess", Body::Device);
    insta::assert_json_snapshot!(process);
}

#[test]
fn parameters_are_written_in_the_order_that_is_asked_for() {
    let process: ApplicationProcess = read_whole(include_str!("application.xml"));
    let parameters = process.parameters.iter().rev().cloned().collect::<Vec<_>>();
    let write = |out: &mut Markup| write_application_process(&process, parameters.clone(), out);
    let again: ApplicationProcess = read_whole(&written(XddVersion::V1_1, Body::Device, write));
    assert_eq!(again, ApplicationProcess { parameters, ..process });
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
    assert_eq!(
        written(XddVersion::V1_1, Body::Device, |out| Shape::write(&identity, "DeviceIdentity", out)),
        snippet
    );
    insta::assert_debug_snapshot!(identity);
}

#[test]
fn header() {
    let snippet = include_str!("header.xml");
    let (header, left) =
        in_body(snippet, |element, leftovers| read_header(element, ProfileClass::Network, leftovers));
    assert_eq!(left, []);
    let text =
        written(XddVersion::V1_1, Body::Device, |out| write_header(&header, ProfileClass::Network, out));
    assert_eq!(text.replace("q1:", ""), snippet);
    insta::assert_json_snapshot!(header);
}
