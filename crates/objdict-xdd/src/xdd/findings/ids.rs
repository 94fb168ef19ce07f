//! The rules about ids and references to them.

use std::borrow::Cow;
use std::collections::HashMap;

use crate::diagnostic::{Diagnostic, Findings, RuleInfo, text_rules};
use crate::xdd::fact::trimmed;
use crate::xdd::schema::ReferenceTarget;
use crate::xml::{Attribute, Element, ElementId, Name, n};

use super::walk::Walk;

text_rules! {
    source: "CiA 311 annex A";

    "cia311/duplicate-unique-id" = DUPLICATE_UNIQUE_ID, Error;
    summary: "two elements have the same id",
    checks: "Each `uniqueID` must be unique among all elements of the file. References lead to the first one.",
    why: "References are ambiguous, and tools resolve them differently.",
    example: r#"Two parameters with `uniqueID="UID_OBJ_2000"`"#,
    remedy: "Change one of the ids and its references.",
    source: "CiA 311 annex A, XML Schema (ID)",

    // an object gets its data type, access and value from the parameter
    "cia311/dangling-unique-id-ref" = DANGLING_UNIQUE_ID_REF, Error,
        explains Around ["missing-key", "device-type-without-value", "missing-constant"];
    summary: "an object refers to a parameter that does not exist",
    checks: "The id in `uniqueIDRef` of each object and sub-object must exist.",
    why: "The parameter defines the object's data type, access, limits and default: without it, tools lack them or reject the file.",
    example: r#"`uniqueIDRef="UID_OBJ_2000"` in a file without a parameter with that id"#,
    remedy: "Correct the id, add the parameter, or write `dataType` and `accessType` for the object instead.",

    "cia311/dangling-parameter-ref" = DANGLING_PARAMETER_REF, Error;
    summary: "a group or a condition refers to a parameter that does not exist",
    checks: "The ids in `parameterRef` and `conditionalSupport` must exist.",
    why: "The group does not show the parameter, or the condition is never met.",
    example: r#"`<parameterRef uniqueIDRef="UID_SPEED"/>` in a file without a parameter with that id"#,
    remedy: "Correct the id, or remove the reference.",

    "cia311/dangling-data-type-id-ref" = DANGLING_DATA_TYPE_REF, Error;
    summary: "a parameter refers to a data type that does not exist",
    checks: "The id in each `dataTypeIDRef` must exist.",
    why: "The parameter has no data type.",
    example: r#"`<dataTypeIDRef uniqueIDRef="UID_ARR_1003"/>` in a file without an array with that id"#,
    remedy: "Correct the id, or define the type in `dataTypeList`.",

    "cia311/dangling-template-id-ref" = DANGLING_TEMPLATE_REF, Error;
    summary: "a parameter refers to a template that does not exist",
    checks: "The id in each `templateIDRef` must exist.",
    why: "The parameter lacks the properties of the template.",
    example: r#"`templateIDRef="UID_PERCENT"` in a file without a template with that id"#,
    remedy: "Correct the id, or add the template to `templateList`.",

    "cia311/dangling-led-state-ref" = DANGLING_LED_STATE_REF, Warning;
    summary: "a combined LED state refers to a state that does not exist",
    checks: "An `LEDstate` must exist for the id in each `LEDstateRef`.",
    why: "The description of the LEDs is incomplete, and schema validation rejects the file.",
    example: r#"`<LEDstateRef stateIDRef="UID_RUN"/>` in a file without a state with that id"#,
    remedy: "Correct the id.",

    "cia311/dangling-function-ref" = DANGLING_FUNCTION_REF, Error;
    summary: "a reference leads to a function or variable that does not exist",
    checks: "The type id of each function instance must exist, and so must the instance, variable and member ids in each `variableRef`.",
    why: "The parameter or the function has no type.",
    example: r#"`typeIDRef="UID_PID"` in a file without a function type with that id"#,
    remedy: "Correct the id, or add the missing element.",

    "cia311/dangling-interface-ref" = DANGLING_INTERFACE_REF, Error;
    summary: "ranges refer to a module interface that does not exist",
    checks: "The device manager needs an interface with the id in `interface` of the application layers.",
    why: "The objects of the modules get no indexes.",
    example: r#"`<interface uniqueIDRef="UID_BUS" addressing="auto">` in a file without `<interface uniqueID="UID_BUS" …>`"#,
    remedy: "Correct the id, or add the interface to the device manager.",

    "cia311/reference-to-wrong-kind" = REFERENCE_TO_WRONG_KIND, Error;
    summary: "a reference leads to an element of the wrong kind",
    checks: "Data type references must lead to data types, template references to templates, references of groups to parameters and so on. An object may refer to any element of the application process that describes a value.",
    why: "Schema validation does not detect this, and tools resolve the reference differently.",
    example: r#"`<dataTypeIDRef uniqueIDRef="UID_SPEED"/>` where `UID_SPEED` is a parameter"#,
    remedy: "Write the id of an element of the right kind.",

    "cia311/recursive-data-type" = RECURSIVE_DATA_TYPE, Error;
    summary: "a data type contains itself",
    checks: "Arrays, structs and derived types must not refer to themselves through their `dataTypeIDRef`.",
    why: "Such a type has no size, and tools that follow the references loop forever.",
    example: "A struct with a member of its own type",
    remedy: "Use a different type.",

    "cia311/recursive-template" = RECURSIVE_TEMPLATE, Error;
    summary: "a parameter template refers to itself",
    checks: "Parameter templates must not refer to themselves through `templateIDRef`, directly or indirectly.",
    why: "Tools that follow the references loop forever.",
    example: "Two templates, each with the id of the other in `templateIDRef`",
    remedy: "Remove one of the references.",
}

/// The rules about constraints of the XML Schema: ids are unique, and references resolve to one.
pub(super) static OF_SCHEMA: &[&RuleInfo] = &[
    &DUPLICATE_UNIQUE_ID,
    &DANGLING_UNIQUE_ID_REF,
    &DANGLING_PARAMETER_REF,
    &DANGLING_DATA_TYPE_REF,
    &DANGLING_TEMPLATE_REF,
    &DANGLING_LED_STATE_REF,
    &DANGLING_FUNCTION_REF,
    &DANGLING_INTERFACE_REF,
];

/// The ids of a container with their elements.
#[derive(Default)]
pub(super) struct Ids<'a> {
    elements: HashMap<Cow<'a, str>, (Element<'a>, Attribute<'a>)>,
    /// How many objects and sub-objects refer to an element.
    uses: HashMap<ElementId, u32>,
}

/// An attribute that refers to an element.
#[derive(Clone, Copy)]
pub(super) struct IdReference<'a> {
    pub(super) element: Element<'a>,
    pub(super) attribute: Attribute<'a>,
    pub(super) target: ReferenceTarget,
}

impl<'a> Ids<'a> {
    /// Assigns an id to its element, unless it is already taken.
    pub(super) fn define(&mut self, element: Element<'a>, attribute: Attribute<'a>, findings: &mut Findings) {
        let id = trimmed(attribute.value());
        if let Some((first, first_at)) = self.elements.get(&id) {
            let message = match (first.name(), element.name()) {
                (first, second) if first == second => format!("two `{second}` have the id `{id}`"),
                (first, second) => {
                    format!("a `{first}` and a `{second}` have the id `{id}`")
                }
            };
            let finding = Diagnostic::new(&DUPLICATE_UNIQUE_ID, attribute.value_span(), message);
            let finding = finding.label(first_at.value_span(), "first here");
            findings.push(finding.help("change one of the ids and its references"));
        } else {
            self.elements.insert(id, (element, attribute));
        }
    }

    /// The element with the id in an attribute.
    pub(super) fn element(&self, attribute: Attribute<'_>) -> Option<Element<'a>> {
        self.elements.get(&trimmed(attribute.value())).map(|(element, _)| *element)
    }

    /// How many objects and sub-objects refer to an element.
    pub(super) fn uses(&self, element: Element<'_>) -> u32 {
        self.uses.get(&element.id()).copied().unwrap_or(0)
    }

    /// Whether exactly one object or sub-object refers to an element.
    pub(super) fn belongs_to_entry(&self, element: Element<'_>) -> bool {
        self.uses(element) == 1
    }

    /// An id that differs from `id` only in case.
    fn similar(&self, id: &str) -> Option<&str> {
        self.elements.keys().map(|known| &**known).find(|known| known.eq_ignore_ascii_case(id))
    }
}

/// Checks all references.
pub(super) fn check(walk: &mut Walk<'_, '_>) {
    for reference in std::mem::take(&mut walk.references) {
        let found = walk.ids.elements.get(&trimmed(reference.attribute.value())).copied();
        match found {
            None => dangling(&reference, &walk.ids, walk.findings),
            Some((element, at)) => {
                if reference.target == ReferenceTarget::Application {
                    *walk.ids.uses.entry(element.id()).or_default() += 1;
                }
                if !accepts(&reference, element.tag()) {
                    walk.findings.push(wrong_kind(&reference, element, at));
                }
            }
        }
    }
    check_cycles(walk);
}

fn dangling(reference: &IdReference<'_>, ids: &Ids<'_>, findings: &mut Findings) {
    let (rule, what, _) = about(reference.target);
    if findings.is_full(rule) {
        // a finding above the limit is only counted and needs no message
        findings.push(Diagnostic::new(rule, reference.attribute.value_span(), String::new()));
        return;
    }
    let id = trimmed(reference.attribute.value());
    let at = reference.attribute.value_span();
    let message = match &*id {
        "" => format!("`{}` refers to no {what}", reference.element.name()),
        id => format!("no {what} has the id `{id}`"),
    };
    let help = match ids.similar(&id) {
        Some(similar) => format!("did you mean `{similar}`?"),
        None => format!("correct the id or add the {what}"),
    };
    findings.push(Diagnostic::new(rule, at, message).help(help));
}

/// Whether a reference may refer to an element of this name.
fn accepts(reference: &IdReference<'_>, name: Name) -> bool {
    match reference.target {
        // these do not describe values
        ReferenceTarget::Application => !matches!(
            name,
            n::LEDstate | n::interface | n::functionType | n::parameterGroup | n::allowedValuesTemplate
        ),
        ReferenceTarget::Parameter if reference.element.tag() == n::conditionalSupport => {
            matches!(name, n::parameter | n::parameterTemplate | n::varDeclaration)
        }
        _ => about(reference.target).2.contains(&name),
    }
}

/// The rule for dangling references, a description of the expected target, and the elements of that kind.
fn about(target: ReferenceTarget) -> (&'static RuleInfo, &'static str, &'static [Name]) {
    match target {
        ReferenceTarget::Application => {
            (&DANGLING_UNIQUE_ID_REF, "parameter", &[n::parameter, n::varDeclaration])
        }
        ReferenceTarget::Parameter => (&DANGLING_PARAMETER_REF, "parameter", &[n::parameter]),
        ReferenceTarget::DataType => {
            (&DANGLING_DATA_TYPE_REF, "data type", &[n::array, n::r#struct, n::r#enum, n::derived])
        }
        ReferenceTarget::ParameterTemplate => {
            (&DANGLING_TEMPLATE_REF, "parameter template", &[n::parameterTemplate])
        }
        ReferenceTarget::AllowedValuesTemplate => {
            (&DANGLING_TEMPLATE_REF, "template of allowed values", &[n::allowedValuesTemplate])
        }
        ReferenceTarget::LedState => (&DANGLING_LED_STATE_REF, "LED state", &[n::LEDstate]),
        ReferenceTarget::FunctionType => (&DANGLING_FUNCTION_REF, "function type", &[n::functionType]),
        ReferenceTarget::FunctionInstance => {
            (&DANGLING_FUNCTION_REF, "function instance", &[n::functionInstance])
        }
        ReferenceTarget::Variable => (&DANGLING_FUNCTION_REF, "variable", &[n::varDeclaration]),
        ReferenceTarget::ModuleInterface => (&DANGLING_INTERFACE_REF, "module interface", &[n::interface]),
    }
}

fn wrong_kind(reference: &IdReference<'_>, element: Element<'_>, at: Attribute<'_>) -> Diagnostic {
    let (id, kind) = (trimmed(reference.attribute.value()), element.name());
    let message = format!("`{}` refers to `{id}`, which is a `{kind}`", reference.element.name());
    Diagnostic::new(&REFERENCE_TO_WRONG_KIND, reference.attribute.value_span(), message)
        .label(at.value_span(), "the element with this id")
        .help(format!("write the id of {}", listing_or(about(reference.target).2)))
}

/// "a `x`", or "a `x` or `y`".
fn listing_or(names: &[Name]) -> String {
    match names {
        [name] => format!("a `{}`", name.text()),
        [names @ .., last] => {
            let names: Vec<String> = names.iter().map(|name| format!("`{}`", name.text())).collect();
            format!("a {} or `{}`", names.join(", "), last.text())
        }
        [] => String::new(),
    }
}

fn check_cycles(walk: &mut Walk<'_, '_>) {
    let mut found = Vec::new();
    for attribute in cycles(walk.seen.data_types().collect(), &walk.ids, type_references) {
        let message = format!("the data type `{}` contains itself", attribute.value().trim_ascii());
        found.push((&RECURSIVE_DATA_TYPE, attribute, message, "use a different type"));
    }
    for attribute in cycles(walk.seen.of([n::parameterTemplate]).collect(), &walk.ids, template_references) {
        let message = format!("the template `{}` refers to itself", attribute.value().trim_ascii());
        found.push((&RECURSIVE_TEMPLATE, attribute, message, "remove one of the references"));
    }
    for (rule, attribute, message, help) in found {
        let finding = Diagnostic::new(rule, attribute.value_span(), message);
        let finding = match walk.ids.elements.get(&trimmed(attribute.value())) {
            Some((_, at)) => finding.label(at.value_span(), "defined here"),
            None => finding,
        };
        walk.findings.push(finding.help(help));
    }
}

fn type_references(element: Element<'_>) -> Vec<Attribute<'_>> {
    match element.tag() {
        n::r#struct => element.children_named(n::varDeclaration).filter_map(type_reference).collect(),
        _ => type_reference(element).into_iter().collect(),
    }
}

fn template_references(element: Element<'_>) -> Vec<Attribute<'_>> {
    element.attribute(n::templateIDRef).into_iter().collect()
}

fn type_reference(element: Element<'_>) -> Option<Attribute<'_>> {
    element.child(n::dataTypeIDRef)?.attribute(n::uniqueIDRef)
}

/// One reference from each reference cycle. Iterative, because a hostile file can contain a chain of any
/// length.
fn cycles<'a>(
    elements: Vec<Element<'a>>,
    ids: &Ids<'a>,
    references: impl Fn(Element<'a>) -> Vec<Attribute<'a>>,
) -> Vec<Attribute<'a>> {
    let known: HashMap<ElementId, Element<'a>> =
        elements.iter().map(|element| (element.id(), *element)).collect();
    let mut is_done: HashMap<ElementId, bool> = HashMap::new();
    let mut found = Vec::new();
    for element in elements {
        if is_done.contains_key(&element.id()) {
            continue;
        }
        is_done.insert(element.id(), false);
        let mut open = vec![(element.id(), references(element))];
        while let Some((id, next)) = open.last_mut() {
            let Some(attribute) = next.pop() else {
                is_done.insert(*id, true);
                open.pop();
                continue;
            };
            let target = ids.element(attribute).filter(|element| known.contains_key(&element.id()));
            let Some(target) = target else { continue };
            match is_done.get(&target.id()) {
                Some(true) => {}
                Some(false) => found.push(attribute),
                None => {
                    is_done.insert(target.id(), false);
                    open.push((target.id(), references(target)));
                }
            }
        }
    }
    found
}
