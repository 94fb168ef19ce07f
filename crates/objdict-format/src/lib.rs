//! Description files: what a file is, and from its bytes to the model.

#![cfg_attr(not(feature = "full"), allow(unreachable_pub, reason = "what is used depends on the features"))]

#[cfg(feature = "full")]
pub mod compare;
#[cfg(feature = "full")]
mod complete;
#[cfg(feature = "full")]
mod configured;
#[cfg(feature = "full")]
mod convert;
mod description;
#[cfg(feature = "full")]
pub mod device_toml;
#[cfg(feature = "full")]
mod dialect;
#[cfg(feature = "full")]
pub mod embedded;
pub mod identify;
pub mod input;
#[cfg(feature = "full")]
pub mod json;
#[cfg(feature = "full")]
pub mod mention;
#[cfg(feature = "node-list")]
pub mod nodelist;
#[cfg(feature = "xdd")]
mod objdictgen;
#[cfg(feature = "full")]
pub mod patch;
pub mod scaffold;
mod text;
#[cfg(feature = "full")]
mod write;

#[cfg(feature = "full")]
pub use self::configured::{ConfiguredFile, NodeSettings};
#[cfg(feature = "full")]
pub use self::convert::convert;
pub use self::description::{Description, stated_name};
#[cfg(feature = "full")]
pub use self::dialect::Dialect;
pub use self::input::{ReadError, open};
#[cfg(feature = "full")]
pub use self::write::{Loss, LossKind, WriteOptions, Written};
#[cfg(feature = "full")]
use crate::scaffold::{BaseError, Wanted, scaffold};
pub use objdict_eds::eds;
#[cfg(feature = "full")]
pub use objdict_eds::eds::Style;
pub use objdict_eds::ini;
#[cfg(feature = "xdd")]
use objdict_model::diagnostic::Findings;
use objdict_model::diagnostic::RuleInfo;
pub use objdict_model::literal;
#[cfg(feature = "full")]
use objdict_model::model::Device;
#[cfg(feature = "full")]
use objdict_model::model::Object;
pub use objdict_model::source::EditError;
use objdict_model::source::SourceFile;
pub use objdict_model::{Format, Syntax};
#[cfg(feature = "full")]
pub use objdict_node::concise;
#[cfg(feature = "xdd")]
pub use objdict_xdd::xdd;
#[cfg(feature = "xdd")]
pub use objdict_xdd::xdd::XddVersion;
#[cfg(feature = "xdd")]
pub use objdict_xdd::xml;

/// Reads a source in a format.
pub fn read(source: SourceFile, format: Format) -> Description {
    Description::read(source, format)
}

/// The canonical text of a device that has no source: as an EDS without what was configured for a node, as a DCF with it.
/// With it comes what the text does not give back: the differences of the device and what is read of the text.
///
/// # Errors
/// When the text violates CiA 311, which is an error of objdict, or does not give back more values than allowed.
#[cfg(feature = "full")]
pub fn write(device: &Device, format: Format, options: &WriteOptions) -> Result<Written, EditError> {
    write::write(device, format, options)
}

/// The JSON Schema of `device.toml`, by which editors complete and check it.
#[cfg(feature = "full")]
pub fn device_schema() -> serde_json::Value {
    device_toml::schema()
}

/// The words for data types in files that people write.
#[cfg(feature = "full")]
pub fn type_words() -> impl Iterator<Item = &'static str> {
    objdict_keyed::types::TYPES.iter().map(|(word, _)| *word)
}

/// What writes an object as a line of the table `object` of a `device.toml`; `None` of a text that is none.
#[cfg(feature = "full")]
pub fn object_writer(text: &str) -> Option<impl Fn(u16, &Object) -> String> {
    device_toml::object_writer(text)
}

/// The `device.toml` of a [new device](crate::scaffold::scaffold): its profile, identity and features, with an example of an
/// object and a PDO in comments.
///
/// # Errors
/// As [`crate::scaffold::base()`].
#[cfg(feature = "full")]
pub fn new_device_toml(wanted: &Wanted) -> Result<String, BaseError> {
    device_toml::start(wanted.profile, &wanted.features, &scaffold(wanted)?)
}

/// What a text of a format does not give back of the device that it was made of. Of the options the encoding and the limit count.
///
/// # Errors
/// [`EditError::TooMuchLost`] where that is more than the limit.
#[cfg(feature = "full")]
pub fn losses(
    device: &Device,
    bytes: &[u8],
    format: Format,
    options: &WriteOptions,
) -> Result<Vec<Loss>, EditError> {
    write::losses(device, bytes, format, options)
}

/// Problems in the structure of an XML document against CiA 311: all rules of the group `cia311`. A document
/// without a container of CiA 311 has none to be held against.
#[cfg(feature = "xdd")]
pub fn check_structure(tree: &objdict_xdd::xml::Tree) -> Findings {
    let mut findings = Findings::new();
    objdict_xdd::xdd::findings::check(tree, &mut findings);
    findings
}

/// The rules that the readers raise themselves.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    let of_lines = objdict_eds::ini::findings::RULES
        .iter()
        .chain(objdict_model::literal::RULES)
        .chain(objdict_eds::eds::findings::RULES);
    let rules = of_lines.chain(objdict_eds::eds::portability::RULES).copied();
    #[cfg(feature = "full")]
    let rules = rules.chain(embedded::RULES.iter().copied());
    #[cfg(feature = "full")]
    let rules = rules.chain(objdict_keyed::rules::RULES.iter().copied());
    #[cfg(feature = "full")]
    let rules = rules.chain(patch::RULES.iter().copied());
    #[cfg(feature = "xdd")]
    let rules = rules.chain(objdict_xdd::xml::findings::rules()).chain(objdict_xdd::xdd::findings::rules());
    #[cfg(feature = "xdd")]
    let rules = rules.chain(objdictgen::rules::RULES.iter().copied());
    rules
}
