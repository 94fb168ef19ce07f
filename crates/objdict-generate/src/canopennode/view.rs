//! View of templates/canopennode/OD.h and OD.c, with the configuration for builds with several object dictionaries, and the
//! extensions through which the stack calls the application (`--hook`).

use super::limits::{self, Limited, is_of_stack, limited};
use super::node_id::applied;
use super::plan::{Member, ObjectLayout, StackObject, plan};
use super::storage::ValueStorage;
use crate::dictionary::TableDictionary;
use crate::head::Head;
use crate::memory::TypeExtent;
use crate::model::{Access, Address, Place};
use crate::{Note, Options};
use objdict_model::canopennode::Counters;

/// The content of the files.
pub(super) struct CanOpenNodeView<'a> {
    pub(super) head: Head,
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
            head: Head::new(
                dictionary.device,
                options,
                &prefix,
                options.prefix.as_deref().unwrap_or(&prefix),
            ),
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

/// The members of `CO_config_t` in order: the number of objects with a label, the number of elements of an object, or an
/// object.
const MEMBERS: &str = "
    CNT_NMT ENTRY_H1017 CNT_HB_CONS CNT_ARR_1016 ENTRY_H1016 ENTRY_H100C ENTRY_H100D CNT_EM ENTRY_H1001 ENTRY_H1014
    ENTRY_H1015 CNT_ARR_1003 ENTRY_H1003 CNT_SDO_SRV ENTRY_H1200 CNT_SDO_CLI ENTRY_H1280 CNT_TIME ENTRY_H1012 CNT_SYNC
    ENTRY_H1005 ENTRY_H1006 ENTRY_H1007 ENTRY_H1019 CNT_RPDO ENTRY_H1400 ENTRY_H1600 CNT_TPDO ENTRY_H1800 ENTRY_H1A00
    CNT_LEDS CNT_GFC ENTRY_H1300 CNT_SRDO ENTRY_H1301 ENTRY_H1381 ENTRY_H13FE ENTRY_H13FF CNT_LSS_SLV CNT_LSS_MST
    CNT_GTWA CNT_TRACE
";

/// Settings that no object dictionary has.
const ZERO: [&str; 5] = ["CNT_LEDS", "CNT_LSS_SLV", "CNT_LSS_MST", "CNT_GTWA", "CNT_TRACE"];

/// Members and their values.
pub(super) fn config(
    counters: &Counters,
    objects: &[StackObject<'_>],
    prefix: &str,
) -> Vec<(&'static str, String)> {
    let object = |index: &str| objects.iter().find(|object| format!("{:04X}", object.index) == index);
    let is_there = |member: &str| match (member.strip_prefix("ENTRY_H"), member.strip_prefix("CNT_ARR_")) {
        (Some(index), _) => object(index).is_some(),
        (_, Some(index)) => object(index).is_some_and(|object| object.count.is_some()),
        _ => !ZERO.contains(&member) && counters.count(member.trim_start_matches("CNT_")) > 0,
    };
    let value = |member: &str| match member {
        member if is_there(member) => format!("{prefix}_{member}"),
        "CNT_SDO_SRV" => "1".to_owned(), // the default one, which needs no object
        "CNT_ARR_1003" => "8".to_owned(), // the EMCY producer needs some room
        member if member.starts_with("CNT_") => "0".to_owned(),
        _ => "NULL".to_owned(),
    };
    MEMBERS.split_ascii_whitespace().map(|member| (member, value(member))).collect()
}

/// An object with an extension of the application.
pub(super) struct HookedObject {
    pub(super) index: u16,
    /// Position of the object in the list.
    pub(super) position: usize,
    /// Whether SDOs or PDOs read an entry of it.
    pub(super) is_read: bool,
    /// Whether SDOs or PDOs write an entry of it.
    pub(super) is_written: bool,
}

/// The objects in the options. Notes report limitations of the stack's extensions.
pub(super) fn hooked(
    objects: &[StackObject<'_>],
    options: &Options,
    notes: &mut Vec<Note>,
) -> Vec<HookedObject> {
    let mut hooked: Vec<HookedObject> = Vec::new();
    for &Address { index, sub } in &options.hooks {
        let place = Place::at(index, sub);
        let has_entry = |object: &StackObject<'_>| {
            sub.is_none_or(|sub| object.members().any(|member| member.entry.sub == sub))
        };
        let mut found = objects.iter().enumerate();
        let Some((position, object)) =
            found.find(|(_, object)| object.index == index).filter(|(_, object)| has_entry(object))
        else {
            notes.push(Note::new(place, "no entry to call a hook for"));
            continue;
        };
        if is_of_stack(index) {
            let text = "the stack has its own extension of the object, so there is no hook";
            notes.push(Note::new(place, text));
            continue;
        }
        if sub.is_some() && object.members().nth(1).is_some() {
            notes.push(Note::new(place, "the stack calls the hook for all entries of the object"));
        }
        if hooked.last().is_some_and(|last| last.index == index) {
            continue;
        }
        let accesses = || object.members().map(|member| member.entry.resolved.access);
        let (is_read, is_written) =
            (accesses().any(Access::is_readable), accesses().any(Access::is_writable));
        hooked.push(HookedObject { index, position, is_read, is_written });
    }
    hooked
}
