//! Description files: format detection, reading and writing.

#![cfg_attr(not(feature = "full"), allow(unreachable_pub, reason = "what is used depends on the features"))]

#[cfg(feature = "full")]
pub mod canopeneditor;
#[cfg(feature = "full")]
mod complete;
#[cfg(feature = "full")]
mod configured;
#[cfg(feature = "full")]
mod convert;
#[cfg(feature = "full")]
pub mod csv;
mod description;
#[cfg(feature = "full")]
pub mod device_toml;
#[cfg(feature = "full")]
mod dialect;
#[cfg(feature = "full")]
pub mod embedded;
#[cfg(feature = "esi")]
mod esi;
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
pub mod object_table;
#[cfg(feature = "full")]
pub mod patch;
pub mod scaffold;
mod text;
#[cfg(feature = "full")]
mod write;

pub use self::description::{Description, stated_name};
pub use self::input::{ReadError, open};
#[cfg(feature = "full")]
pub use self::{
    configured::{ConfiguredFile, NodeSettings},
    convert::{convert, has_meaning_keys, unread},
    device_toml::{new_device_toml, object_writer, schema as device_schema},
    dialect::Dialect,
    write::{Loss, LossKind, WriteOptions, Written, losses, write},
};
pub use objdict_eds::{eds, ini};
#[cfg(feature = "full")]
pub use objdict_model::compare;
use objdict_model::diagnostic::RuleInfo;
pub use objdict_model::source::EditError;
use objdict_model::source::SourceFile;
pub use objdict_model::{Format, Syntax, literal};
#[cfg(feature = "full")]
pub use {objdict_eds::eds::Style, objdict_node::concise};
#[cfg(feature = "xdd")]
pub use {objdict_xdd::xdd, objdict_xdd::xdd::XddVersion, objdict_xdd::xml};

/// Reads a source in a format.
pub fn read(source: SourceFile, format: Format) -> Description {
    Description::read(source, format, None)
}

/// Like [`read`], based on the description of an earlier text of the file: in an EDS or DCF, only objects
/// whose sections differ are read.
#[doc(hidden)] // for the language server
pub fn read_after(source: SourceFile, format: Format, before: Option<&Description>) -> Description {
    Description::read(source, format, before)
}

/// The keywords for data types in files that users write.
#[cfg(feature = "full")]
pub fn type_words() -> impl Iterator<Item = &'static str> {
    objdict_keyed::types::TYPES.iter().map(|(word, _)| *word)
}

/// Problems in the structure of an XML document according to CiA 311: all rules of the group `cia311`. A
/// document without a CiA 311 container has none.
#[cfg(feature = "xdd")]
pub fn check_structure(tree: &objdict_xdd::xml::Tree) -> objdict_model::diagnostic::Findings {
    let mut findings = objdict_model::diagnostic::Findings::new();
    objdict_xdd::xdd::findings::check(tree, &mut findings);
    findings
}

/// The rules of the readers.
pub fn rules() -> impl Iterator<Item = &'static RuleInfo> {
    let rules = [
        objdict_eds::ini::findings::RULES,
        objdict_model::literal::RULES,
        objdict_eds::eds::findings::RULES,
        objdict_eds::eds::portability::RULES,
        #[cfg(feature = "full")]
        embedded::RULES,
        #[cfg(feature = "full")]
        objdict_keyed::rules::RULES,
        #[cfg(feature = "full")]
        patch::RULES,
    ];
    let rules = rules.into_iter().flatten().copied();
    #[cfg(feature = "xdd")]
    let rules = rules.chain(objdict_xdd::xml::findings::rules()).chain(objdict_xdd::xdd::findings::rules());
    #[cfg(feature = "xdd")]
    let rules = rules.chain(objdictgen::RULES.iter().copied());
    #[cfg(feature = "esi")]
    let rules = rules.chain(esi::RULES.iter().copied());
    rules
}
