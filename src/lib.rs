//! The object-dictionary toolchain for CANopen: reads the description of a device (EDS, XDD) or of a configured node (DCF,
//! XDC), reports problems with their places, and generates what a product needs.
//!
//! This is the library. The command `objdict` is in the feature `cli`, which is on by default; build scripts and your
//! own tools do not need it (`default-features = false`).
//!
//! # Reading
//!
//! [`format::open`] reads a file. Its defects are not errors, however malformed it is: the reader parses as much as it
//! can and keeps the rest as text. The [`Device`](model::Device) has *objects* at an index, and these have *entries* at
//! a sub-index.
//!
//! ```
//! use objdict::model::{Access, Value};
//! use objdict::source::SourceOptions;
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/eds");
//! # let path = std::path::Path::new(folder).join("io-401.eds");
//! let description = objdict::format::open(&path, &SourceOptions::default())?;
//! let device = description.device();
//! assert_eq!(device.profile(), Some(401));
//!
//! let object = device.object(0x1400).expect("the device has an RPDO");
//! assert_eq!(object.name(), "RPDO 1 communication parameter");
//!
//! let cob_id = device.entry(0x1400, 1).expect("an RPDO has a COB-ID");
//! assert_eq!(cob_id.access, Some(Access::Rw));
//! assert_eq!(cob_id.default, Some(Value::NodeId(0x200))); // `$NODEID+0x200`
//! assert_eq!(cob_id.default.as_ref().and_then(|value| value.integer_for(5)), Some(0x205));
//! # Ok::<(), objdict::format::ReadError>(())
//! ```
//!
//! # Checking
//!
//! [`check()`] finds problems: in the lines of the text, in their spelling, and in the device. A
//! [`Diagnostic`](diagnostic::Diagnostic) names its rule and the places of the model; the description locates them in the
//! text.
//!
//! ```
//! use objdict::diagnostic::Severity;
//! use objdict::format::{self, Format};
//! use objdict::source::SourceFile;
//!
//! let text = "\
//! [2000]
//! ParameterName=Brightness
//! ObjectType=0x7
//! DataType=0x0005
//! AccessType=rw
//! DefaultValue=300
//! PDOMapping=0
//! ";
//! let description = format::read(SourceFile::from_text("lamp.eds", text), Format::Eds);
//! let findings = objdict::check(&description);
//!
//! let finding = findings.iter().find(|finding| finding.rule.id == "cia306/invalid-value").expect("300 is no byte");
//! assert_eq!(finding.severity, Severity::Error);
//! assert_eq!(finding.message, "`300` is out of range for `DefaultValue` of type UNSIGNED8 (0 to 255)");
//! let span = description.span_of(&finding.labels[0].at);
//! let at = description.source().line_column(span.start);
//! assert_eq!((at.line, at.column), (6, 14));
//!
//! // a text that is not valid for its type is kept as text, never read as a number
//! let brightness = description.device().entry(0x2000, 0).expect("the entry is there");
//! assert_eq!(brightness.default, None);
//! assert_eq!(brightness.invalid_values.iter().next().map(|invalid| &*invalid.text), Some("300"));
//! ```
//!
//! [`report`] renders findings, [`registry`] lists the rules with their pages.
//!
//! # Generating
//!
//! [`build_script`] generates tables for firmware, checks their description, and registers the inputs with
//! Cargo:
//!
//! ```no_run
//! // build.rs
//! fn main() -> Result<(), objdict::build_script::Error> {
//!     objdict::build_script::generate("motor.eds")?;
//!     Ok(())
//! }
//! ```
//!
//! It calls [`generate`], which works on a device without files:
//!
//! ```
//! use objdict::generate::{Options, Target, generate};
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/eds");
//! # let path = std::path::Path::new(folder).join("drive-402.eds");
//! let description = objdict::format::open(&path, &Default::default())?;
//! assert!(!objdict::check(&description).has_errors());
//!
//! let generated = generate(description.device(), Target::named("rust")?, &Options::default())?;
//! let file = &generated.files[0];
//! assert_eq!(file.path, "od.rs");
//! // std::fs::write(out_dir.join(&file.path), &file.contents)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Converting
//!
//! Editing the text of the EDS creates a DCF, so comments, order and spelling are kept. From a DCF, [`download`] plans
//! the SDO downloads that configure the node, in an order that a device accepts:
//!
//! ```
//! use objdict::download::{ConciseDcf, PlanOptions, Scope};
//! use objdict::format::{self, Format, json};
//! use objdict::model::Commissioning;
//! use objdict::source::SourceFile;
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/eds");
//! # let path = std::path::Path::new(folder).join("io-401.eds");
//! let eds = format::open(&path, &Default::default())?;
//! let node = Commissioning { node_id: Some(5), baud_rate: Some(250), ..Commissioning::default() };
//! let text = eds.to_node("door.dcf", &node)?;
//! let source = SourceFile::from_bytes("door.dcf", text, &Default::default())?;
//! let dcf = format::read(source, Format::Dcf);
//! assert_eq!(dcf.device().node_id(), Some(5));
//!
//! let options = PlanOptions { scope: Scope::All, ..PlanOptions::default() };
//! let plan = ConciseDcf::plan(dcf.device(), &options)?;
//! let configuration = plan.into_concise(|file| std::fs::read(&*file.name))?;
//! let stream = configuration.write()?;
//! assert_eq!(ConciseDcf::parse(&stream)?, configuration);
//!
//! // JSON holds the whole model
//! let document = json::write_device(dcf.device());
//! assert_eq!(json::read_device(&document)?, *dcf.device());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Configuring
//!
//! [`configure()`](configure::configure) checks a node's settings against its dictionary and reports all errors at
//! once. The description then receives the resulting values:
//!
//! ```
//! use objdict::configure::{Setting, configure};
//! use objdict::format::{self, NodeSettings};
//! use objdict::model::Commissioning;
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/eds");
//! # let path = std::path::Path::new(folder).join("io-401.eds");
//! let eds = format::open(&path, &Default::default())?;
//! let wanted = [Setting::value("1017=250")?, Setting::map("tpdo1=6000:1,6401:2")?];
//! let assignments = configure(eds.device(), 5, &wanted).expect("the device has all that");
//!
//! let node = &Commissioning { node_id: Some(5), baud_rate: Some(250), ..Commissioning::default() };
//! let settings = NodeSettings { node, plugged: None, assignments: &assignments, downloads: &[] };
//! let dcf = eds.configured("door.dcf", &settings)?;
//! assert!(dcf.is_edited && dcf.device.node_id() == Some(5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Between lines and XML
//!
//! Converting between EDS and XML writes the description from scratch. The written text is read back and
//! compared, and the conversion returns its losses. Content that the target format does not support can
//! be embedded in it.
//!
//! ```
//! use objdict::format::{self, Format, LossKind, WriteOptions};
//! use objdict::source::SourceFile;
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/fixtures/eds");
//! # let path = std::path::Path::new(folder).join("io-401.eds");
//! let eds = format::open(&path, &Default::default())?;
//! let mut options = WriteOptions::default();
//! let plain = format::write(eds.device(), Format::Xdd, &options)?;
//! assert_eq!(plain.losses[2].to_string(), "lost: FileInfo / EDSVersion: `\"4.0\"`");
//!
//! options.embed = true;
//! let whole = format::write(eds.device(), Format::Xdd, &options)?;
//! assert!(whole.losses.iter().all(|loss| loss.kind == LossKind::Embedded));
//! let source = SourceFile::from_bytes("io-401.xdd", whole.bytes, &Default::default())?;
//! assert_eq!(format::read(source, Format::Xdd).device(), eds.device());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The folder `examples` of the repository contains these as programs, and a check with custom requirements.
//!
//! # The pipeline
//!
//! Each stage can be used on its own and depends only on earlier ones:
//!
//! 1. [`source`]: bytes to text and positions; encodings are detected, remembered and restored.
//! 2. [`format`](mod@format): text to [`model::Device`] and back, without losing a byte on the way.
//! 3. [`lint`]: rules about the model, independent of files; [`registry`] adds those about the text.
//! 4. [`diagnostic`] and [`report`]: findings as data, located when they are shown.
//! 5. [`generate`] and [`download`]: sources and SDO downloads, generated from the model only.
//! 6. [`document`]: reports about a device, for users and spreadsheets (feature `full`).

#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(any(feature = "c", feature = "canopennode", feature = "rust", feature = "template"))]
pub use objdict_build::build_script;
#[cfg(feature = "full")]
pub use objdict_bus as bus;
#[cfg(feature = "can")]
#[doc(hidden)] // for the command and the module of Python
pub use objdict_can as can;
#[cfg(feature = "cli")]
#[doc(hidden)] // for the command alone
pub use objdict_cli as cli;
#[cfg(feature = "full")]
pub use objdict_document::{self as document, describe};
#[cfg(feature = "toml")]
pub use objdict_format::compare;
#[cfg(any(feature = "c", feature = "canopennode", feature = "rust", feature = "template"))]
pub use objdict_generate as generate;
pub use objdict_lint as lint;
pub use objdict_model::{Language, model, source};
#[cfg(feature = "full")]
pub use objdict_network as network;
#[cfg(feature = "can")]
#[doc(hidden)] // for the module of Python
pub use objdict_node::parameter;
#[cfg(feature = "toml")]
pub use objdict_node::{configure, coupler, download};
pub use objdict_profile as profile;
#[cfg(feature = "toml")]
pub use objdict_project::baseline;
#[doc(hidden)] // the tests compare its table with the tools
pub use objdict_project::compat;
#[cfg(feature = "lint")]
pub use objdict_project::{AppliedFix, Fixed, config, fix, fix_for_readers, with_sound_fixes, workspace};
pub use objdict_project::{check, check_unordered, check_with, registry, report};
#[cfg(feature = "full")]
#[doc(hidden)] // for the command, the workbench and the module of Python
pub use objdict_traffic as traffic;
#[cfg(feature = "full")]
pub use objdict_traffic::probe;

/// Findings as plain data: a rule, a severity, a message, places or spans, a help and a fix.
pub mod diagnostic {
    pub use objdict_model::diagnostic::{
        Applicability, At, Change, Diagnostic, Findings, Fix, FixSafety, MAX_PER_RULE, RuleInfo, Selection,
        Severity, SourceLabel, Span, Text, Tidy, Tool,
    };
}

/// Description files: format detection, reading and writing.
pub mod format {
    #[cfg(feature = "xdd")]
    pub use objdict_format::XddVersion;
    #[cfg(feature = "xdd")]
    pub use objdict_format::check_structure;
    #[cfg(feature = "full")]
    pub use objdict_format::nodelist;
    #[doc(hidden)] // for the language server
    pub use objdict_format::read_after;
    #[cfg(feature = "toml")]
    pub use objdict_format::{
        ConfiguredFile, Dialect, Loss, LossKind, NodeSettings, Style, WriteOptions, Written, canopeneditor,
        concise, convert, device_schema, has_meaning_keys, json, losses, new_device_toml, object_table,
        patch, unread, write,
    };
    pub use objdict_format::{Description, ReadError, identify, input, open, read};
    pub use objdict_model::source::EditError;
    pub use objdict_model::{Format, Syntax};
    #[cfg(feature = "full")]
    pub use objdict_network_file as network;
    #[cfg(feature = "full")]
    pub use objdict_traffic::log;
}

/// New descriptions: devices with only the objects that their profile requires.
pub mod scaffold {
    pub use objdict_format::scaffold::{
        BaseError, EncoderClass, FEATURES, Feature, FeatureError, FeatureKind, FeatureValue, Features,
        PROFILES, Wanted, add_objects, base, identify, infer, newest_version, scaffold,
    };
    #[cfg(feature = "full")]
    pub use objdict_traffic::probe::learn;
}

/// The pages of the rules, which `objdict explain` prints: the addresses of rules lead here.
#[cfg(all(doc, not(doctest)))]
pub mod rules {
    include!("rule_pages.rs");
}

/// Compiles the examples of the README with those of this page.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;

/// Compiles the build script of the tutorial.
#[cfg(doctest)]
#[doc = include_str!("../docs/tutorials/device.md")]
pub struct TutorialOfDevices;
