//! What a JSON Schema says of the keys of a file: the schemas are made of the tables that the files are read by.

use serde_json::Value;

/// A schema, with the whole one that its references lead into.
#[derive(Clone, Copy)]
pub(super) struct Schema<'a> {
    root: &'a Value,
    at: &'a Value,
}

impl<'a> Schema<'a> {
    pub(super) fn new(root: &'a Value) -> Self {
        Self { root, at: root }
    }

    /// The schema of what is below some keys.
    pub(super) fn below(self, path: &[String]) -> Option<Self> {
        path.iter().try_fold(self, |schema, key| schema.step(key))
    }

    /// The whole schema.
    pub(super) fn root(self) -> &'a Value {
        self.root
    }

    fn with(self, at: &'a Value) -> Self {
        Self { at, ..self }
    }

    /// The schemas that hold for a table here: that of an item for a list, each of several ones.
    fn tables(self) -> Vec<Self> {
        if let Some(name) = self.at["$ref"].as_str().and_then(|name| name.strip_prefix("#/$defs/")) {
            return self.with(&self.root["$defs"][name]).tables();
        }
        if self.at["items"].is_object() {
            return self.with(&self.at["items"]).tables();
        }
        let mut tables = vec![self];
        let choices = self.at["anyOf"].as_array().into_iter().flatten();
        let choices = choices.chain([&self.at["then"], &self.at["else"]]);
        for choice in choices.filter(|choice| choice.is_object()) {
            tables.extend(self.with(choice).tables());
        }
        tables
    }

    fn step(self, key: &str) -> Option<Self> {
        let tables = self.tables();
        let stated = tables.iter().find_map(|table| {
            let value = &table.at["properties"][key];
            value.is_object().then(|| table.with(value))
        });
        stated.or_else(|| {
            tables.iter().find_map(|table| {
                let patterns = table.at["patternProperties"].as_object().into_iter().flatten();
                let values = patterns.map(|(_, value)| value).chain([&table.at["additionalProperties"]]);
                values.into_iter().find(|value| value.is_object()).map(|value| table.with(value))
            })
        })
    }

    /// The keys of a table here, each with its meaning, without former names.
    pub(super) fn keys(self) -> Vec<(&'a str, &'a str)> {
        let mut keys = Vec::new();
        for table in self.tables() {
            for (name, value) in table.at["properties"].as_object().into_iter().flatten() {
                let is_former = value["deprecated"] == true;
                if value.is_object() && !is_former && keys.iter().all(|(known, _)| known != name) {
                    keys.push((name.as_str(), value["description"].as_str().unwrap_or_default()));
                }
            }
        }
        keys
    }

    /// The words that a value may be, each with whether it is a text.
    pub(super) fn words(self) -> Vec<(String, bool)> {
        let mut words = Vec::new();
        for schema in self.tables() {
            let stated = schema.at["enum"].as_array().into_iter().flatten();
            let stated = stated.chain([&schema.at["const"]]).filter_map(Value::as_str);
            words.extend(stated.map(|word| (word.to_owned(), true)));
            if schema.at["type"] == "boolean" {
                words.extend(["true", "false"].map(|word| (word.to_owned(), false)));
            }
        }
        words
    }

    /// Whether a list of tables is here.
    pub(super) fn is_list_of_tables(self) -> bool {
        self.at["items"]["type"] == "object"
    }

    /// Whether a table is here.
    pub(super) fn is_table(self) -> bool {
        self.at["type"] == "object"
    }
}
