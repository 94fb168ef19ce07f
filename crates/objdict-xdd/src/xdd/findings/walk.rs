//! One walk over the elements of a container, along the schema.

use super::ids::{IdReference, Ids};
use super::structure::Forms;
use super::texts::Languages;
use super::{profiles, structure, texts, values};
use crate::diagnostic::Findings;
use crate::xdd::schema::{self, MAX_SLOTS, Occurrence, TextKind};
use crate::xml::{Attribute, Element, Name, n};

/// The findings of the walk, and its state for rules that compare several elements.
pub(super) struct Walk<'a, 'f> {
    pub(super) findings: &'f mut Findings,
    pub(super) forms: Forms<'a>,
    pub(super) ids: Ids<'a>,
    pub(super) references: Vec<IdReference<'a>>,
    pub(super) languages: Languages<'a>,
    pub(super) seen: SeenElements<'a>,
    pub(super) bodies: Vec<Element<'a>>,
    pub(super) object_lists: Vec<Element<'a>>,
}

/// Elements that further rules check, in file order.
#[derive(Default)]
pub(super) struct SeenElements<'a>(Vec<Element<'a>>);

/// The elements in [`SeenElements`].
const LOOKED_AT: [Name; 15] = [
    n::parameter,
    n::varDeclaration,
    n::array,
    n::r#struct,
    n::r#enum,
    n::derived,
    n::parameterTemplate,
    n::allowedValuesTemplate,
    n::labelRef,
    n::descriptionRef,
    n::memberRef,
    n::dictionary,
    n::DeviceIdentity,
    n::identity,
    n::baudRate,
];

impl<'a> SeenElements<'a> {
    /// The elements of the given names.
    pub(super) fn of<const N: usize>(&self, names: [Name; N]) -> impl Iterator<Item = Element<'a>> {
        self.0.iter().copied().filter(move |element| names.contains(&element.tag()))
    }

    /// The definitions of data types.
    pub(super) fn data_types(&self) -> impl Iterator<Item = Element<'a>> {
        self.of([n::array, n::r#struct, n::r#enum, n::derived])
    }
}

impl<'a, 'f> Walk<'a, 'f> {
    /// A walk that begins at a container.
    pub(super) fn new(container: Element<'a>, findings: &'f mut Findings) -> Self {
        Self {
            findings,
            forms: Forms::new(container),
            ids: Ids::default(),
            references: Vec::new(),
            languages: Languages::default(),
            seen: SeenElements::default(),
            bodies: Vec::new(),
            object_lists: Vec::new(),
        }
    }

    /// An element with a known place in the schema, and its content.
    pub(super) fn element(&mut self, element: Element<'a>, schema: &'static schema::SchemaElement) {
        self.forms.look_at(element, schema);
        match element.tag() {
            n::ProfileBody => self.bodies.push(element),
            n::CANopenObjectList => self.object_lists.push(element),
            name if LOOKED_AT.contains(&name) => self.seen.0.push(element),
            _ => {}
        }
        if schema.is_opaque() {
            return;
        }
        self.attributes(element, schema);
        self.text(element, schema);
        self.children(element, schema);
    }

    fn attributes(&mut self, element: Element<'a>, schema: &'static schema::SchemaElement) {
        let mut present = 0_u32;
        for attribute in element.attributes() {
            // `xsi:type` and similar, and extensions in other namespaces
            if !attribute.prefix().is_empty() {
                continue;
            }
            let found = schema
                .attribute(attribute.tag())
                .filter(|(_, known)| known.need != Occurrence::Stray)
                .or_else(|| structure::unknown_attribute(element, schema, attribute, self.findings));
            let Some((number, known)) = found else { continue };
            present |= 1 << number;
            if schema.newer.contains(&known.name) && self.forms.is_version_1_0() {
                let what = format!("attribute `{}` for `{}`", attribute.name(), element.name());
                self.findings.push(structure::newer(attribute.name_span(), &what));
            }
            self.value(element, attribute, known.kind);
        }
        for (number, attribute) in schema.attributes.iter().enumerate() {
            if matches!(attribute.need, Occurrence::Required | Occurrence::Key)
                && present & (1 << number) == 0
            {
                self.findings.push(structure::missing_attribute(element, attribute));
            }
        }
    }

    fn value(&mut self, element: Element<'a>, attribute: Attribute<'a>, kind: TextKind) {
        match kind {
            TextKind::Text => return,
            TextKind::Reference(target) => {
                self.references.push(IdReference { element, attribute, target });
                return;
            }
            _ => {}
        }
        let value = attribute.value();
        let is_name = values::check(&value, kind, attribute.value_span(), attribute.name(), self.findings);
        if matches!(kind, TextKind::Id) && is_name {
            self.ids.define(element, attribute, self.findings);
        }
    }

    fn text(&mut self, element: Element<'a>, schema: &'static schema::SchemaElement) {
        match schema.text.map(|text| text.kind) {
            Some(TextKind::Text) => {}
            Some(kind) => {
                let text = element.text();
                let span = match element.text_span() {
                    span if span.is_empty() => element.tag_span(),
                    span => span,
                };
                values::check(&text, kind, span, element.name(), self.findings);
            }
            None if element.is_empty_tag() => {}
            None => {
                let span = element.text_span();
                if !span.is_empty() {
                    self.findings.push(structure::stray_text(element, span));
                }
            }
        }
    }

    fn children(&mut self, element: Element<'a>, schema: &'static schema::SchemaElement) {
        let mut counts = [0_u32; MAX_SLOTS];
        let mut first: [Option<Element<'a>>; MAX_SLOTS] = [None; MAX_SLOTS];
        let (mut at, mut last) = (0, None);
        let mut is_in_order = true;
        for child in element.children() {
            let found = schema
                .slot(child.tag(), at)
                .filter(|(number, _)| schema.content[*number].need != Occurrence::Stray)
                .or_else(|| {
                    let is_ours = self.forms.is_ours(child);
                    structure::unknown_element(element, schema, child, is_ours, self.findings)
                });
            let Some((number, known)) = found else { continue };
            if number < at && is_in_order {
                self.findings.push(structure::wrong_order(element, child, last));
                // one finding covers all following elements
                is_in_order = false;
            } else if number >= at {
                (at, last) = (number, Some(child));
            }
            counts[number] += 1;
            let before = *first[number].get_or_insert(child);
            let slot = &schema.content[number];
            if counts[number] > slot.most_of(known) {
                self.findings.push(structure::repeated_element(element, child, before));
            }
            if schema.newer.contains(&known.name) && self.forms.is_version_1_0() {
                let what = format!("`{}` in `{}`", child.name(), element.name());
                self.findings.push(structure::newer(child.name_span(), &what));
            }
            match profiles::body(child) {
                Some(body) => self.body(child, body),
                None => self.element(child, known),
            }
        }
        for (number, slot) in schema.content.iter().enumerate() {
            if counts[number] < slot.least {
                self.findings.push(structure::missing_element(element, slot, counts[number]));
            }
        }
        if schema.has_labels() {
            let body = self.bodies.last().copied();
            texts::check(element, body, &mut self.languages, self.findings);
        }
    }

    fn body(&mut self, element: Element<'a>, body: profiles::Body) {
        match body.schema {
            Some(schema) => self.element(element, schema),
            None => self.bodies.push(element),
        }
        profiles::check_type(element, body, self.findings);
    }
}
