//! `objdict schema`: the JSON Schemas of the documents that objdict writes. They are made of the types that write them
//! (`cargo xtask docs`, feature `schema`) and are part of the program.
//!
//! The texts in `schemas` are compiled in, so the command needs no crate for them. For a document that is written
//! piece by piece, a type behind the feature `schema` declares the outer fields. A new field needs a comment,
//! which becomes its description.

use std::io::Write;

use super::Texts;
use super::args::SchemaArgs;
use super::ending::{Failure, Outcome};
use super::stdout::Output;
use super::table::TextTable;
use objdict_model::diagnostic::{listing, nearest};

/// The schema of a document.
struct DocumentSchema {
    name: &'static str,
    /// What the document is, as a sentence.
    about: &'static str,
}

/// The documents that others write, whose schemas are made of what reads them.
const PATCH: &str = "patch";
const ANSWERS: &str = "answers";

/// Declares the documents: name, type, and a sentence. A new one begins with an empty file in `schemas`.
macro_rules! documents {
    ($($(#[$when:meta])* $name:literal $Type:ty: $about:literal,)*) => {
        const SCHEMAS: &[DocumentSchema] = &[
            $($(#[$when])* DocumentSchema {
                name: $name,
                about: $about,
            },)*
            DocumentSchema { name: PATCH, about: "A patch, which is read as TOML: `objdict patch make`." },
            DocumentSchema { name: ANSWERS, about: "Answers of a device, which are read: `objdict probe --answers`." },
        ];

        /// The schemas of all documents by their names, made of the types that write them.
        #[cfg(feature = "schema")]
        pub fn schemas() -> Vec<(&'static str, serde_json::Value)> {
            vec![$($(#[$when])* ($name, made::schema_of::<$Type>($name, $about)),)* (PATCH, objdict_format::patch::schema::patch()), (ANSWERS, objdict_traffic::probe::answers_schema())]
        }
    };
}

documents! {
    "device-json" objdict_format::json::DeviceDocument<objdict_model::model::Device>: "A device description: `objdict convert IN -o OUT.json`.",
    "concise-dcf" objdict_format::json::ConciseDocument<objdict_node::download::ConciseDcf>: "A concise DCF: `objdict convert IN.cdcf -o OUT.json`.",
    "findings" objdict_project::report::CheckJson<'_>: "Findings: `objdict check --format json`, `objdict network check --format json`.",
    "changes" super::changes::ChangesDocument<'_>: "The changes between descriptions: `objdict diff --format json`.",
    "baseline" objdict_project::baseline::BaselineJson: "Known findings: `objdict check --write-baseline`.",
    "identify" super::identify::IdentifyJson<'_>: "What files are: `objdict identify --format json`.",
    "entries" super::show::EntriesDocument<'_>: "The entries of a dictionary: `objdict show --format json`.",
    "node-list" super::show::NodeListDocument<'_>: "A node list: `objdict show NETWORK.cpj --format json`.",
    "modules" super::modules::ModulesJson<'_>: "The modules of a coupler: `objdict modules --format json`.",
    "losses" super::convert::LossDocument<'_>: "The losses of conversions: `objdict convert --loss-report`.",
    "sizes" super::sizes::SizesJson<'_>: "The sizes of tables: `objdict generate --report size --format json`.",
    "tables" super::generate::TableDifferences<'_>: "Existing tables compared with generated ones: `objdict generate --compare OD.h --format json`.",
    "variants" super::variants::VariantsJson: "The variants of a `device.toml`: `objdict variants --format json`.",
    "network" super::network::ShowDocument<'_>: "A network: `objdict network show --format json`.",
    "boot" super::network::BootDocument<'_>: "A simulated boot: `objdict network boot --format json`.",
    "timing" super::network::TimingDocument<'_>: "A network in time: `objdict network timing --format json`.",
    "conformance" super::conformance::ConformanceJson<'_>: "What a node does of CiA 301: `objdict conformance --format json`.",
    "frame" objdict_traffic::FrameDocument<'_>: "A frame, on one line: `objdict decode --format json`.",
    "traffic" super::decode::SummaryDocument: "Sums over logs: `objdict decode --summary --format json`.",
    "verify" super::dcf::VerifyDocument<'_>: "What a node refuses: `objdict dcf verify --format json`.",
    #[cfg(feature = "bus")]
    "bus-scan" super::bus::ScanDocument: "The nodes on a bus: `objdict bus scan --format json`.",
    #[cfg(feature = "bus")]
    "bus-values" super::bus::ValuesDocument: "Values of a node: `objdict bus read --format json`, `objdict bus save --format json`.",
    #[cfg(feature = "bus")]
    "bus-writes" super::bus::WritesDocument: "Downloads to a node: `objdict bus write --format json`, `objdict bus apply --format json`, `objdict bus replace --format json`.",
    #[cfg(feature = "bus")]
    "bus-comparison" super::bus::ComparisonDocument: "A network and its description: `objdict bus compare --format json`.",
    #[cfg(feature = "bus")]
    "bus-command" super::bus::CommandDocument: "A command to nodes: `objdict bus restore --format json`, `objdict bus nmt --format json`, `objdict bus lss assign --format json`.",
    #[cfg(feature = "bus")]
    "bus-lss" super::bus::LssDocument: "A device without a node-ID: `objdict bus lss scan --format json`.",
    #[cfg(feature = "bus")]
    "bus-lss-plan" super::bus::LssPlanDocument: "The steps that assign node-IDs: `objdict bus lss plan --format json`.",
    "profiles" super::profile::ListDocument<'_>: "The built-in profiles: `objdict profile list --format json`.",
    "profile" super::profile::ProfileDocument<'_>: "The objects of a profile: `objdict profile show --format json`.",
    "rules" super::rules::RulesJson: "The rules of `check`: `objdict rules --format json`.",
}

/// The name and the meaning of the one document that people write, whose schema is made of the table of its keys.
const SOURCE: [&str; 2] = ["device", "The short source of a device, `device.toml`."];

pub(super) fn run(args: &SchemaArgs, texts: &Texts, out: &mut Output) -> Result<Outcome, Failure> {
    let Some(name) = &args.name else {
        let mut table = TextTable::new(["Name", "Document"], usize::MAX);
        table.row(SOURCE.map(str::to_owned));
        for DocumentSchema { name, about, .. } in SCHEMAS {
            table.row([name, about].map(|text| (*text).to_owned()));
        }
        table.write(out)?;
        return Ok(Outcome::Clean);
    };
    if name.eq_ignore_ascii_case(SOURCE[0]) {
        let text = objdict_model::json::pretty(&objdict_format::device_schema()).unwrap_or_default();
        out.raw()?.write_all(format!("{text}\n").as_bytes())?;
        return Ok(Outcome::Clean);
    }
    let schema = SCHEMAS.iter().find(|schema| schema.name.eq_ignore_ascii_case(name));
    let schema = schema.ok_or_else(|| unknown(name))?;
    let text = texts.schemas.iter().find(|(name, _)| *name == schema.name).map_or("", |(_, text)| text);
    out.raw()?.write_all(text.as_bytes())?;
    Ok(Outcome::Clean)
}

fn unknown(name: &str) -> Failure {
    let failure = Failure::new(format_args!("unknown document `{name}`"));
    let names = || std::iter::once(SOURCE[0]).chain(SCHEMAS.iter().map(|schema| schema.name));
    failure.help(match nearest(name, names()) {
        Some(near) => format!("did you mean `{near}`? `objdict schema` lists all"),
        None => format!("the documents are {}", listing(names())),
    })
}

/// How schemas are made.
#[cfg(feature = "schema")]
mod made {
    use schemars::JsonSchema;
    use schemars::generate::SchemaSettings;
    use serde_json::{Map, Value, json};

    /// The schema of a document. What is not in it is not written, so an unknown field is an error.
    pub(super) fn schema_of<T: JsonSchema>(name: &str, about: &str) -> Value {
        let generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
        let mut made = generator.into_root_schema_for::<T>().to_value();
        tidy(&mut made);
        let version = made["properties"]["version"]["const"].clone();
        let mut schema = Map::new();
        let mut set = |key: &str, value: Value| schema.insert(key.to_owned(), value);
        // the order of keys is that of the alphabet, in which these are first
        set("$schema", made["$schema"].take());
        set("$id", json!(format!("urn:objdict:{name}:{version}")));
        set("title", json!(format!("{name} of objdict, version {version}")));
        set("description", json!(about));
        if let Value::Object(fields) = made {
            for (key, value) in fields {
                schema.entry(key).or_insert(value);
            }
        }
        Value::Object(schema)
    }

    /// Closes objects, says what optional fields are, and puts the words of the library into those of JSON.
    fn tidy(schema: &mut Value) {
        let Value::Object(fields) = schema else { return };
        // documents are written, so what a reader takes for an absent field is of no use
        fields.remove("default");
        let required = fields.get("required").cloned().unwrap_or_default();
        if let Some(Value::Object(properties)) = fields.get_mut("properties") {
            for (name, property) in properties {
                let is_required = required.as_array().is_some_and(|names| names.contains(&json!(name)));
                if !is_required {
                    remove_null(property);
                }
                describe(property, if is_required { "`null`" } else { "absent" });
            }
            fields.entry("additionalProperties").or_insert(json!(false));
        }
        describe(schema, "absent");
        let Value::Object(fields) = schema else { return };
        for (key, value) in fields {
            match (key.as_str(), value) {
                ("properties" | "patternProperties" | "$defs", Value::Object(schemas)) => {
                    schemas.values_mut().for_each(tidy);
                }
                ("anyOf" | "oneOf" | "allOf" | "prefixItems", Value::Array(schemas)) => {
                    schemas.iter_mut().for_each(tidy);
                }
                ("items" | "additionalProperties", schema) => tidy(schema),
                _ => {}
            }
        }
    }

    /// A field that may be absent is never null.
    fn remove_null(property: &mut Value) {
        let Value::Object(fields) = property else { return };
        if let Some(Value::Array(types)) = fields.get_mut("type") {
            types.retain(|name| name != "null");
            if let [only] = types.as_slice() {
                let only = only.clone();
                fields.insert("type".to_owned(), only);
            }
        }
        if let Some(Value::Array(words)) = fields.get_mut("enum") {
            words.retain(|word| !word.is_null());
        }
        let Some(Value::Array(schemas)) = fields.get_mut("anyOf") else { return };
        schemas.retain(|schema| *schema != json!({ "type": "null" }));
        if schemas.len() == 1 {
            let only = schemas.remove(0);
            fields.remove("anyOf");
            if let Value::Object(only) = only {
                for (key, value) in only {
                    fields.entry(key).or_insert(value);
                }
            }
        }
    }

    /// The description in one line, without links into the documentation of the library.
    fn describe(schema: &mut Value, none: &str) {
        let Some(Value::String(text)) = schema.get_mut("description") else { return };
        let mut plain = text.replace('\n', " ").replace("`None`", none);
        while let Some(start) = plain.find("](") {
            let Some(length) = plain[start..].find(')') else { break };
            plain.replace_range(start + 1..=start + length, "");
        }
        *text = plain.replace("[`", "`").replace("`]", "`");
    }
}
