//! Description files: what a file is, and from its bytes to the model.

#[cfg(all(feature = "json", feature = "xdd"))]
mod complete;
#[cfg(feature = "node")]
mod configured;
#[cfg(all(feature = "generate", feature = "json", feature = "xdd"))]
mod convert;
mod description;
#[cfg(feature = "toml")]
pub(crate) mod device_toml;
#[cfg(all(feature = "json", feature = "xdd"))]
mod dialect;
#[cfg(all(feature = "json", feature = "xdd"))]
pub(crate) mod embedded;
pub mod identify;
pub mod input;
#[cfg(feature = "json")]
pub mod json;
#[cfg(feature = "toml")]
#[cfg_attr(not(feature = "network"), expect(dead_code, reason = "networks have more kinds of keys"))]
mod keyed;
#[cfg(feature = "document")]
pub mod log;
#[cfg(feature = "lsp")]
pub(crate) mod mention;
#[cfg(feature = "network")]
pub mod network;
#[cfg(feature = "node")]
pub mod nodelist;
#[cfg(feature = "xdd")]
mod objdictgen;
#[cfg(feature = "patch")]
pub mod patch;
#[cfg(all(feature = "json", feature = "xdd"))]
mod write;

#[cfg(feature = "node")]
pub use self::configured::{ConfiguredFile, NodeSettings};
#[cfg(all(feature = "generate", feature = "json", feature = "xdd"))]
pub use self::convert::convert;
pub use self::description::Description;
#[cfg(feature = "cli")]
pub(crate) use self::description::stated_name;
#[cfg(all(feature = "json", feature = "xdd"))]
pub use self::dialect::Dialect;
pub use self::input::{ReadError, open};
#[cfg(all(feature = "json", feature = "xdd"))]
pub use self::write::{Loss, LossKind, WriteOptions, Written};
#[cfg(feature = "xdd")]
use crate::diagnostic::Findings;
use crate::diagnostic::RuleInfo;
#[cfg(all(feature = "json", feature = "xdd"))]
use crate::model::Device;
#[cfg(feature = "lsp")]
use crate::model::Object;
#[cfg(feature = "toml")]
use crate::scaffold::{BaseError, Wanted, scaffold};
pub use crate::source::EditError;
use crate::source::SourceFile;
pub(crate) use objdict_eds::eds;
#[cfg(feature = "json")]
pub use objdict_eds::eds::Style;
pub(crate) use objdict_eds::ini;
pub(crate) use objdict_model::literal;
pub use objdict_model::{Format, Syntax};
#[cfg(feature = "node")]
pub use objdict_node::concise;
#[cfg(feature = "xdd")]
pub(crate) use objdict_xdd::xdd;
#[cfg(feature = "xdd")]
pub use objdict_xdd::xdd::XddVersion;
#[cfg(feature = "xdd")]
pub(crate) use objdict_xdd::xml;

/// Reads a source in a format.
pub fn read(source: SourceFile, format: Format) -> Description {
    Description::read(source, format)
}

/// The canonical text of a device that has no source: as an EDS without what was configured for a node, as a DCF with it.
/// With it comes what the text does not give back: the differences of the device and what is read of the text.
///
/// # Errors
/// When the text violates CiA 311, which is an error of objdict, or does not give back more values than allowed.
#[cfg(all(feature = "json", feature = "xdd"))]
pub fn write(device: &Device, format: Format, options: &WriteOptions) -> Result<Written, EditError> {
    write::write(device, format, options)
}

/// The JSON Schema of `device.toml`, by which editors complete and check it.
#[cfg(feature = "toml")]
pub fn device_schema() -> serde_json::Value {
    device_toml::schema()
}

/// The words for data types in files that people write.
#[cfg(feature = "lsp")]
pub(crate) fn type_words() -> impl Iterator<Item = &'static str> {
    keyed::types::TYPES.iter().map(|(word, _)| *word)
}

/// What writes an object as a line of the table `object` of a `device.toml`; `None` of a text that is none.
#[cfg(feature = "lsp")]
pub(crate) fn object_writer(text: &str) -> Option<impl Fn(u16, &Object) -> String> {
    device_toml::object_writer(text)
}

/// The `device.toml` of a [new device](crate::scaffold::scaffold): its profile, identity and features, with an example of an
/// object and a PDO in comments.
///
/// # Errors
/// As [`crate::scaffold::base`].
#[cfg(feature = "toml")]
pub fn new_device_toml(wanted: &Wanted) -> Result<String, BaseError> {
    device_toml::start(wanted.profile, &wanted.features, &scaffold(wanted)?)
}

/// What a text of a format does not give back of the device that it was made of. Of the options the encoding and the limit count.
///
/// # Errors
/// [`EditError::TooMuchLost`] where that is more than the limit.
#[cfg(all(feature = "json", feature = "xdd"))]
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
pub fn check_structure(tree: &xml::Tree) -> Findings {
    let mut findings = Findings::new();
    xdd::findings::check(tree, &mut findings);
    findings
}

/// The rules that the readers raise themselves.
pub(crate) fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    let of_lines = ini::findings::RULES.iter().chain(literal::RULES).chain(eds::findings::RULES);
    let rules = of_lines.chain(eds::portability::RULES).copied();
    #[cfg(all(feature = "json", feature = "xdd"))]
    let rules = rules.chain(embedded::RULES.iter().copied());
    #[cfg(feature = "network")]
    let rules = rules.chain(network::rules());
    #[cfg(feature = "toml")]
    let rules = rules.chain(keyed::rules::RULES.iter().copied());
    #[cfg(feature = "patch")]
    let rules = rules.chain(patch::RULES.iter().copied());
    #[cfg(feature = "xdd")]
    let rules = rules.chain(xml::findings::rules()).chain(xdd::findings::rules());
    #[cfg(feature = "xdd")]
    let rules = rules.chain(objdictgen::rules::RULES.iter().copied());
    rules
}
