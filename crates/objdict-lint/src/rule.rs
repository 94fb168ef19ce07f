//! Rules about the model.

#[cfg(feature = "catalogue")]
use crate::Drive;
use crate::configured::ConfiguredDevice;
use crate::demands::{Against, Applied, Expected};
use crate::diagnostic::{Diagnostic, Findings, RuleInfo, Text};
use crate::model::{Device, Entry, Field, ModulePart, Object, ObjectType, Part, Place};
use crate::{Facts, PdoFacts, stated};

/// A rule about the model.
pub struct Rule {
    /// The id, severity and page.
    pub info: RuleInfo,
    /// The check and its subject.
    pub(crate) check: Check,
}

impl Rule {
    /// A finding of this rule.
    pub(crate) fn at(&'static self, place: Place, message: impl Into<Text>) -> Diagnostic {
        Diagnostic::new(&self.info, place, message)
    }

    /// Reports the same finding at each of `places`.
    #[cfg(feature = "catalogue")]
    pub(crate) fn report_each(
        &'static self,
        places: impl Iterator<Item = Place>,
        (message, help): (impl Into<Text>, impl Into<Text>),
        findings: &mut Findings,
    ) {
        let (message, help) = (message.into(), help.into());
        for place in places {
            findings.push_with(&self.info, || self.at(place, message.clone()).help(help.clone()));
        }
    }
}

/// The subject of a rule. The linter walks over the device once and calls each rule at its places.
#[derive(Clone, Copy)]
pub(crate) enum Check {
    /// The device as a whole.
    Device(fn(&Device, &mut Findings)),
    /// Like `Device`, including disabled objects, which no other rule sees.
    Described(fn(&Device, &mut Findings)),
    /// Each object with its index, including those without their own section ([`Object::orphan`]). The result depends
    /// only on the object, so it is reused while the object is unchanged.
    Object(fn(u16, &Object, &mut Findings)),
    /// Each object, for a check that also depends on the device.
    ObjectOf(fn(&Device, u16, &Object, &mut Findings)),
    /// Each described entry, also of modules: the section of an object, or a sub-index. The result depends
    /// only on its object.
    Entry(fn(&EntryAt<'_>, &mut Findings)),
    /// Each described entry, for a check that also depends on the device.
    EntryOf(fn(&Device, &EntryAt<'_>, &mut Findings)),
    /// The communication as a whole.
    Facts(fn(&Facts<'_>, &mut Findings)),
    /// Each PDO with at least one described object.
    Pdo(fn(&Facts<'_>, &PdoFacts<'_>, &mut Findings)),
    /// Each logical device that the document of the rule's group applies to.
    Applied(fn(&Facts<'_>, &Applied<'_>, &mut Findings)),
    /// Each requirement, for a check that the rules of several groups share.
    #[cfg(feature = "catalogue")]
    Demand(fn(&'static RuleInfo, &Facts<'_>, &Applied<'_>, &mut Findings)),
    /// Each axis of a drive.
    #[cfg(feature = "catalogue")]
    Drive(fn(Drive<'_>, &mut Findings)),
    /// Each object that the document defines.
    Against(fn(&'static RuleInfo, &Against<'_>, &mut Findings)),
    /// A configuration together with its type description.
    Configured(fn(&ConfiguredDevice<'_>, &mut Findings)),
    /// Each described entry that the document defines, in objects with the structure of the document.
    Expected(fn(&'static RuleInfo, &Expected<'_>, &mut Findings)),
}

/// An entry with its position.
#[derive(Clone, Copy)]
pub(crate) struct EntryAt<'a> {
    pub origin: EntryOwner,
    pub index: u16,
    /// The object of the entry; for an extension, an object with only this entry.
    pub object: &'a Object,
    /// The sub-index; `None` for the section of the object.
    pub sub: Option<u8>,
    pub entry: &'a Entry,
}

/// The owner of an entry.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum EntryOwner {
    /// The device.
    Device,
    /// A fixed object of the module with this number.
    Fixed(u16),
    /// An extension of an object by the module with this number.
    Extension(u16),
}

impl EntryAt<'_> {
    /// The entry as a place.
    pub(crate) fn place(&self) -> Place {
        let index = self.index;
        Place::of(match (self.origin, self.sub) {
            (EntryOwner::Device, Some(sub)) => Part::Entry(index, sub),
            (EntryOwner::Device, None) => Part::Object(index),
            (EntryOwner::Fixed(module), Some(sub)) => {
                Part::Module(module, ModulePart::FixedEntry(index, sub))
            }
            (EntryOwner::Fixed(module), None) => Part::Module(module, ModulePart::Fixed(index)),
            (EntryOwner::Extension(module), _) => Part::Module(module, ModulePart::SubExt(index)),
        })
    }

    /// The section of the object as a place.
    pub(crate) fn object_place(&self) -> Place {
        Self { sub: None, ..*self }.place()
    }

    /// A field of the entry as a place.
    pub(crate) fn field(&self, field: Field) -> Place {
        self.place().field(field)
    }

    /// The object type of the entry, VAR if it is missing; `None` if the description is ambiguous.
    pub(crate) fn object_type(&self) -> Option<ObjectType> {
        match self.sub {
            None => stated::object_type(self.object),
            Some(_) if stated::is_invalid(self.entry, &Field::ObjectType) => None,
            Some(_) => Some(self.entry.object_type.unwrap_or(ObjectType::Var)),
        }
    }

    /// Whether the entry has a value: a sub-index, a VAR or DOMAIN, or the shared attributes of a compact
    /// object; not the header of an ARRAY or RECORD.
    pub(crate) fn holds_value(&self) -> bool {
        self.sub.is_some() || !self.object.object_type().has_subs() || self.object.compact.is_some()
    }
}

/// A [`Rule`]: the fields of [`rule_info!`](objdict_model::rule_info), with the check after the severity.
macro_rules! rule {
    (
        $id:literal, $severity:ident, $kind:ident($check:path) $(, fix $safety:ident)?
            $(, explains $reach:ident [$($rule:literal),+])*
            $(, stops $target:literal $(at [$($field:ident),+])?)*;
        $($part:ident: $text:literal,)+
    ) => {
        $crate::Rule {
            info: objdict_model::rule_info! {
                $id, $severity $(, fix $safety)? $(, explains $reach [$($rule),+])*
                    $(, stops $target $(at [$($field),+])?)*;
                $($part: $text,)+
            },
            check: $crate::Check::$kind($check),
        }
    };
}
pub(crate) use rule;

/// Declares the rules of a file, `RULES`: `"cia306/name" = NAME, Error, Entry(name), fix Safe; summary: "…", …` for
/// each. A check reports with `NAME.at(place, message)`. If every check gets its rule as an argument, the rows have no
/// names. The default source may be stated once before them.
macro_rules! rules {
    ($(source: $source:literal;)? $(
        $id:literal = $name:ident, $severity:ident, $kind:ident($check:path) $(, fix $safety:ident)?
            $(, explains $reach:ident [$($rule:literal),+])*
            $(, stops $target:literal $(at [$($field:ident),+])?)*;
        $($part:ident: $text:literal,)+
    )+) => {
        $(const SOURCE: &str = $source;)?
        $(static $name: $crate::Rule = $crate::rule::rule! {
            $id, $severity, $kind($check) $(, fix $safety)? $(, explains $reach [$($rule),+])*
                $(, stops $target $(at [$($field),+])?)*;
            $($part: $text,)+
        };)+

        pub(crate) const RULES: &[&$crate::Rule] = &[$(&$name,)+];
    };
    ($(source: $source:literal;)? $(
        $id:literal, $severity:ident, $kind:ident($check:path) $(, fix $safety:ident)?;
        $($part:ident: $text:literal,)+
    )+) => {
        $(const SOURCE: &str = $source;)?
        pub(crate) const RULES: &[&$crate::Rule] =
            &[$(&$crate::rule::rule! { $id, $severity, $kind($check) $(, fix $safety)?; $($part: $text,)+ },)+];
    };
}
pub(crate) use rules;
