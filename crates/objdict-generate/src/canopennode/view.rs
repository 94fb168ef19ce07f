//! View of templates/canopennode/OD.h and OD.c.

use super::config::config;
use super::hooks::{HookedObject, hooked};
use super::limits::{self, Limited, limited};
use super::node_id::applied;
use super::plan::{Member, ObjectLayout, StackObject, plan};
use super::storage::ValueStorage;
use crate::dictionary::TableDictionary;
use crate::head::Head;
use crate::memory::TypeExtent;
use crate::{Note, Options};
use objdict_model::canopennode::Counters;

/// What the files have.
pub(super) struct CanOpenNodeView<'a> {
    head: Head,
    /// The prefix of identifiers.
    pub(super) prefix: String,
    counters: Counters,
    pub(super) groups: Vec<GroupView>,
    pub(super) objects: Vec<StackObject<'a>>,
    /// Statements that add the node-ID.
    applied: Vec<String>,
    /// Objects with an extension of the application.
    pub(super) hooks: Vec<HookedObject>,
    /// `None` if limits are not enforced.
    pub(super) limits: Option<Vec<Limited>>,
}

include!("../../expanded/canopennode/OD.h.rs");
include!("../../expanded/canopennode/OD.c.rs");

/// A storage group: the variables of its objects.
pub(super) struct GroupView {
    name: String,
    pub(super) fields: Vec<GroupMember>,
}

/// A member of a group's struct.
pub(super) struct GroupMember {
    pub(super) index: u16,
    /// The complete declaration; several lines for a record.
    declaration: String,
    /// `.x1000_deviceType = 0x00000000`; several lines for a record.
    initialiser: String,
    pub(super) extent: TypeExtent,
    pub(super) is_zero: bool,
}

impl<'a> CanOpenNodeView<'a> {
    pub(super) fn new(
        dictionary: &'a TableDictionary<'a>,
        options: &Options,
        prefix: String,
        notes: &mut Vec<Note>,
    ) -> Self {
        let objects = plan(dictionary, options, notes);
        let numbered = objects.iter().enumerate();
        let limits: Vec<Limited> = numbered
            .flat_map(|(position, object)| limited(object, position, options.limits, notes))
            .collect();
        Self {
            head: Head::new(dictionary.device, options, &prefix, &prefix),
            counters: Counters::new(dictionary.objects.iter().map(|object| (object.index, object.object))),
            groups: groups(&objects, &prefix),
            applied: objects.iter().flat_map(|object| applied(object, &prefix)).collect(),
            hooks: hooked(&objects, options, notes),
            limits: options.limits.then_some(limits),
            prefix,
            objects,
        }
    }

    /// Whether a value is set byte by byte.
    fn sets_bytes(&self) -> bool {
        self.applied.iter().any(|applied| applied.starts_with("setBytes("))
    }

    /// Whether math.h is needed.
    fn has_math(&self) -> bool {
        let not_finite = |number: &String| number.ends_with("NAN") || number.ends_with("INFINITY");
        let mut members = self.objects.iter().flat_map(StackObject::members);
        members.any(|member| member.storage.value.iter().any(not_finite))
    }

    /// Whether 1016h exists, which the stack always refers to.
    fn has_consumers(&self) -> bool {
        self.objects.iter().any(|object| object.index == 0x1016)
    }

    /// Members of the stack's configuration with their values.
    fn config(&self) -> Vec<(&'static str, String)> {
        config(&self.counters, &self.objects, &self.prefix)
    }
}

/// The groups in the order of their first objects. Groups without variables are omitted, because C has no
/// empty structs.
fn groups(objects: &[StackObject<'_>], prefix: &str) -> Vec<GroupView> {
    let mut groups: Vec<GroupView> = Vec::new();
    for object in objects {
        let fields = fields(object, prefix);
        if fields.is_empty() {
            continue;
        }
        match groups.iter_mut().find(|group| group.name == object.group) {
            Some(group) => group.fields.extend(fields),
            None => groups.push(GroupView { name: object.group.clone(), fields }),
        }
    }
    groups
}

fn fields(object: &StackObject<'_>, prefix: &str) -> Vec<GroupMember> {
    let index = object.index;
    let name = format!("x{}", object.name());
    match &object.layout {
        ObjectLayout::Var(member) => field(index, &name, "", member).into_iter().collect(),
        ObjectLayout::Array(sub0, elements) => {
            let sub0 = field(index, &format!("{name}_sub0"), "", sub0);
            sub0.into_iter().chain(elements_field(object, prefix, &name, elements)).collect()
        }
        ObjectLayout::Record(members) => {
            let fields = members.iter().filter_map(|member| field(index, &member.name, "    ", member));
            let fields: Vec<GroupMember> = fields.collect();
            let lines = |line: fn(&GroupMember) -> &str, end: &str| {
                fields.iter().map(|field| format!("        {}{end}\n", line(field))).collect::<String>()
            };
            let record = GroupMember {
                index,
                declaration: format!("struct {{\n{}    }} {name}", lines(|field| &field.declaration, ";")),
                initialiser: format!(".{name} = {{\n{}    }}", lines(|field| &field.initialiser, ",")),
                extent: TypeExtent::structure(fields.iter().map(|field| field.extent)),
                is_zero: fields.iter().all(|field| field.is_zero),
            };
            if fields.is_empty() { Vec::new() } else { vec![record] }
        }
    }
}

fn field(index: u16, name: &str, indent: &str, member: &Member<'_>) -> Option<GroupMember> {
    let storage = &member.storage;
    Some(GroupMember {
        index,
        declaration: format!("{} {name}{}", storage.type_?, storage.dimension()),
        initialiser: format!(".{name} = {}", value(storage, indent)),
        extent: TypeExtent::of_c(storage.type_?).times(storage.elements.unwrap_or(1)),
        is_zero: member.entry.resolved.default.is_zero(),
    })
}

/// The elements of an array, as one variable.
fn elements_field(
    object: &StackObject<'_>,
    prefix: &str,
    name: &str,
    elements: &[Member<'_>],
) -> Option<GroupMember> {
    let index = object.index;
    let first = field(index, &format!("{name}[{prefix}_CNT_ARR_{index:04X}]"), "    ", elements.first()?)?;
    let values: Vec<String> = elements.iter().map(|element| value(&element.storage, "    ")).collect();
    Some(GroupMember {
        initialiser: format!(".{name} = {}", braced(&values, "")),
        extent: first.extent.times(elements.len()),
        is_zero: elements.iter().all(|element| element.entry.resolved.default.is_zero()),
        ..first
    })
}

fn value(storage: &ValueStorage, indent: &str) -> String {
    match storage.elements {
        None => storage.value.concat(),
        Some(_) => braced(&storage.value, indent),
    }
}

/// Numbers per line of a block.
const PER_LINE: usize = 12;

/// A list in braces; split into lines if it is long.
fn braced(values: &[String], indent: &str) -> String {
    if values.len() <= PER_LINE && values.iter().all(|value| !value.contains('\n')) {
        return format!("{{{}}}", values.join(", "));
    }
    let lines: Vec<String> =
        values.chunks(PER_LINE).map(|line| format!("        {indent}{}", line.join(", "))).collect();
    format!("{{\n{}\n    {indent}}}", lines.join(",\n"))
}

impl StackObject<'_> {
    /// The kind of the object in the stack.
    fn kind(&self) -> &'static str {
        match &self.layout {
            ObjectLayout::Var(_) => "VAR",
            ObjectLayout::Array(..) => "ARR",
            ObjectLayout::Record(_) => "REC",
        }
    }

    /// The address of a variable, or `NULL`.
    fn address(&self, member: &Member<'_>, prefix: &str) -> String {
        let storage = &member.storage;
        match (storage.type_, storage.elements) {
            (None, _) => "NULL".to_owned(),
            (Some(_), None) => format!("&{}", self.variable(prefix, member)),
            (Some(_), Some(_)) => format!("&{}[0]", self.variable(prefix, member)),
        }
    }
}
