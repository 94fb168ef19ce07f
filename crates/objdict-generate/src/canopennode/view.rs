//! View of templates/canopennode/OD.h and OD.c.

use askama::Template;

use super::config::config;
use super::hooks::{Hooked, hooked};
use super::limits::{Limited, limited};
use super::node_id::{Applied, applied};
use super::plan::{Layout, Member, Planned};
use super::storage::Storage;
use crate::dictionary::Dictionary;
use crate::escape::filters;
use crate::{Note, Options};
use objdict_model::canopennode::Counters;

/// The header.
#[derive(Template)]
#[template(path = "canopennode/OD.h", escape = "none")]
pub(super) struct Header<'a> {
    pub(super) tables: &'a Tables,
}

/// The source.
#[derive(Template)]
#[template(path = "canopennode/OD.c", escape = "none")]
pub(super) struct Source<'a> {
    pub(super) tables: &'a Tables,
}

/// Data common to both files.
pub(super) struct Tables {
    made_by: String,
    product: String,
    vendor: String,
    /// The prefix of identifiers.
    prefix: String,
    /// Labels with their number of objects.
    counters: Vec<(String, usize)>,
    groups: Vec<GroupView>,
    objects: Vec<ObjectView>,
    applied: Vec<Applied>,
    /// Objects with an extension of the application.
    pub(super) hooks: Vec<Hooked>,
    /// `None` if limits are not enforced.
    pub(super) limits: Option<Limits>,
    /// Whether math.h is needed.
    math: bool,
    /// Whether 1016h exists, which the stack always refers to.
    has_consumers: bool,
    /// Members of the stack's configuration with their values.
    config: Vec<(&'static str, String)>,
}

/// A storage group: the variables of its objects.
struct GroupView {
    name: String,
    fields: Vec<FieldView>,
}

/// A member of a group's struct.
struct FieldView {
    /// The complete declaration; several lines for a record.
    declaration: String,
    /// `.x1000_deviceType = 0x00000000`; several lines for a record.
    initialiser: String,
}

/// An object in the list.
struct ObjectView {
    index: u16,
    /// `2000_setpoint`.
    name: String,
    /// Empty if there is none.
    cname: String,
    /// The number of elements, if the stack requires it.
    count: Option<usize>,
    /// Number of entries including sub-index 0.
    entries: usize,
    /// `VAR`, `ARR` or `REC`.
    kind: &'static str,
    /// The suffix of the member in `ODObjs_t`.
    dimension: String,
    /// The lines of the initialiser between the braces.
    lines: Vec<String>,
}

/// Entries with limits and the extensions that enforce them.
pub(super) struct Limits {
    pub(super) rows: Vec<Limited>,
    /// Number of objects with limits.
    pub(super) objects: usize,
    real: bool,
}

impl Tables {
    pub(super) fn new(
        dictionary: &Dictionary<'_>,
        objects: &[Planned<'_>],
        options: &Options,
        prefix: &str,
        notes: &mut Vec<Note>,
    ) -> Self {
        let info = dictionary.device.device_info.clone().unwrap_or_default();
        let counters = Counters::new(dictionary.objects.iter().map(|object| (object.index, object.object)));
        let mut limits = Limits { rows: Vec::new(), objects: 0, real: false };
        for (position, object) in objects.iter().enumerate() {
            let rows = limited(object, position, options.limits, notes);
            limits.objects += usize::from(!rows.is_empty());
            limits.real |= rows.iter().any(|row| row.real);
            limits.rows.extend(rows);
        }
        let not_finite = |number: &String| number.ends_with("NAN") || number.ends_with("INFINITY");
        let mut members = objects.iter().flat_map(Planned::members);
        Self {
            made_by: options.made_by(),
            product: info.product_name.unwrap_or_default(),
            vendor: info.vendor_name.unwrap_or_default(),
            prefix: prefix.to_owned(),
            counters: counters.iter().map(|(label, count)| (label.to_owned(), count)).collect(),
            groups: groups(objects, prefix),
            objects: objects.iter().map(|object| object_view(object, prefix)).collect(),
            applied: objects.iter().flat_map(|object| applied(object, prefix)).collect(),
            hooks: hooked(objects, options, notes),
            limits: options.limits.then_some(limits),
            math: members.any(|member| member.storage.value.iter().any(not_finite)),
            has_consumers: objects.iter().any(|object| object.index == 0x1016),
            config: config(&counters, objects, prefix),
        }
    }

    /// Whether a value is set byte by byte.
    fn sets_bytes(&self) -> bool {
        self.applied.iter().any(|applied| applied.type_.is_none())
    }
}

/// The groups in the order of their first objects. Groups without variables are omitted, because C has no
/// empty structs.
fn groups(objects: &[Planned<'_>], prefix: &str) -> Vec<GroupView> {
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

fn fields(object: &Planned<'_>, prefix: &str) -> Vec<FieldView> {
    let name = format!("x{}", object.name());
    match &object.layout {
        Layout::Var(member) => field(&name, "", &member.storage).into_iter().collect(),
        Layout::Array(sub0, elements) => {
            let sub0 = field(&format!("{name}_sub0"), "", &sub0.storage);
            sub0.into_iter().chain(elements_field(object, prefix, &name, elements)).collect()
        }
        Layout::Record(members) => {
            let fields: Vec<FieldView> =
                members.iter().filter_map(|member| field(&member.name, "    ", &member.storage)).collect();
            if fields.is_empty() {
                return Vec::new();
            }
            let lines = |line: fn(&FieldView) -> &str, end: &str| {
                fields.iter().map(|field| format!("        {}{end}\n", line(field))).collect::<String>()
            };
            vec![FieldView {
                declaration: format!("struct {{\n{}    }} {name}", lines(|field| &field.declaration, ";")),
                initialiser: format!(".{name} = {{\n{}    }}", lines(|field| &field.initialiser, ",")),
            }]
        }
    }
}

fn field(name: &str, indent: &str, storage: &Storage) -> Option<FieldView> {
    Some(FieldView {
        declaration: format!("{} {name}{}", storage.type_?, storage.dimension()),
        initialiser: format!(".{name} = {}", value(storage, indent)),
    })
}

/// The elements of an array, as one variable.
fn elements_field(
    object: &Planned<'_>,
    prefix: &str,
    name: &str,
    elements: &[Member<'_>],
) -> Option<FieldView> {
    let first = &elements.first()?.storage;
    let (type_, dimension) = (first.type_?, first.dimension());
    let values: Vec<String> = elements.iter().map(|element| value(&element.storage, "    ")).collect();
    Some(FieldView {
        declaration: format!("{type_} {name}[{prefix}_CNT_ARR_{:04X}]{dimension}", object.index),
        initialiser: format!(".{name} = {}", braced(&values, "")),
    })
}

fn value(storage: &Storage, indent: &str) -> String {
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

fn object_view(object: &Planned<'_>, prefix: &str) -> ObjectView {
    let (kind, dimension, lines) = match &object.layout {
        Layout::Var(member) => ("VAR", String::new(), var_lines(object, member, prefix)),
        Layout::Array(sub0, elements) => ("ARR", String::new(), array_lines(object, sub0, elements, prefix)),
        Layout::Record(members) => {
            let lines = members.iter().map(|member| record_line(object, member, prefix)).collect();
            ("REC", format!("[{}]", members.len()), lines)
        }
    };
    ObjectView {
        index: object.index,
        name: object.name(),
        cname: object.cname.clone(),
        count: object.count,
        entries: object.members().count(),
        kind,
        dimension,
        lines,
    }
}

fn var_lines(object: &Planned<'_>, member: &Member<'_>, prefix: &str) -> Vec<String> {
    vec![
        format!(".dataOrig = {}", address(object, member, prefix)),
        format!(".attribute = {}", member.storage.attribute),
        format!(".dataLength = {}", member.storage.length),
    ]
}

fn array_lines(
    object: &Planned<'_>,
    sub0: &Member<'_>,
    elements: &[Member<'_>],
    prefix: &str,
) -> Vec<String> {
    let Some(first) = elements.first() else { return Vec::new() };
    let storage = &first.storage;
    let size =
        storage.type_.map_or("0".to_owned(), |type_| format!("sizeof({type_}{})", storage.dimension()));
    vec![
        format!(".dataOrig0 = {}", address(object, sub0, prefix)),
        format!(".dataOrig = {}", address(object, first, prefix)),
        format!(".attribute0 = {}", sub0.storage.attribute),
        format!(".attribute = {}", storage.attribute),
        format!(".dataElementLength = {}", storage.length),
        format!(".dataElementSizeof = {size}"),
    ]
}

fn record_line(object: &Planned<'_>, member: &Member<'_>, prefix: &str) -> String {
    let (address, sub) = (address(object, member, prefix), member.entry.sub);
    let (attribute, length) = (&member.storage.attribute, member.storage.length);
    format!("{{.dataOrig = {address}, .subIndex = {sub}, .attribute = {attribute}, .dataLength = {length}}}")
}

/// The address of a variable, or `NULL`.
fn address(object: &Planned<'_>, member: &Member<'_>, prefix: &str) -> String {
    let storage = &member.storage;
    match (storage.type_, storage.elements) {
        (None, _) => "NULL".to_owned(),
        (Some(_), None) => format!("&{}", object.variable(prefix, member)),
        (Some(_), Some(_)) => format!("&{}[0]", object.variable(prefix, member)),
    }
}
