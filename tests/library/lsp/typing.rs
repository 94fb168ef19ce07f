//! A user at the keyboard: each key that makes a description is counted.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;

use objdict::format::input::{Input, Reading};
use serde_json::{Value, json};

use super::client::{Client, edited, position};

/// The place of the cursor in a text, while the edits around it are made.
const CARET: char = '\u{E000}';

/// A user with an editor that expands snippets, shows completions in alphabetical order below the cursor, leaves out those that
/// do not have the typed characters in their order, and has keys for the next finding and for the menu of actions.
struct User {
    client: Client,
    name: &'static str,
    before: String,
    behind: String,
    keys: usize,
    /// What was done, with the keys of each step.
    log: String,
}

impl User {
    fn start(name: &'static str) -> Self {
        let item = json!({ "snippetSupport": true });
        let capabilities = json!({ "textDocument": { "completion": { "completionItem": item } } });
        let mut client = Client::start_with(&capabilities);
        client.open(name, "");
        Self { client, name, before: String::new(), behind: String::new(), keys: 0, log: String::new() }
    }

    fn text(&self) -> String {
        format!("{}{}", self.before, self.behind)
    }

    fn done(&mut self, keys: usize, what: &str) {
        self.keys += keys;
        let _ = writeln!(self.log, "{keys:3} {what}");
    }

    /// Types characters, chooses an item of the list below the cursor, and fills in its blanks; `""` leaves one as it is.
    fn complete(&mut self, typed: &str, label: &str, blanks: &[&str]) {
        self.before += typed;
        let text = self.text();
        self.client.change(self.name, &text);
        let params = json!({ "textDocument": self.client.document(self.name), "position": position(&text, self.before.len()) });
        let answer = self.client.ask("textDocument/completion", params);
        let line = self.before.rsplit('\n').next().unwrap().to_owned();
        let mut items: Vec<&Value> =
            answer.as_array().unwrap().iter().filter(|item| is_shown(item, &line)).collect();
        items.sort_by_key(|item| item["sortText"].as_str().or(item["label"].as_str()).unwrap());
        let labels: Vec<&str> = items.iter().map(|item| item["label"].as_str().unwrap()).collect();
        let down = labels.iter().position(|shown| *shown == label);
        let down = down.unwrap_or_else(|| panic!("no `{label}` in {labels:?}"));
        self.done(typed.len() + down + 1, &format!("`{typed}`, {down} down, accept: {label}"));
        self.insert(items[down].clone(), blanks);
    }

    fn insert(&mut self, item: Value, blanks: &[&str]) {
        let mut item = self.client.ask("completionItem/resolve", item);
        let new = item["textEdit"]["newText"].as_str().unwrap().to_owned();
        item["textEdit"]["newText"] = json!(CARET.to_string());
        let mut edits = item["additionalTextEdits"].as_array().cloned().unwrap_or_default();
        edits.push(item["textEdit"].take());
        let text = edited(&self.text(), &Value::Array(edits));
        let (before, behind) = text.split_once(CARET).unwrap();
        let new = match item["insertTextFormat"] == 2 {
            true => self.fill_in(Snippet::parse(&new), blanks),
            false => new,
        };
        (self.before, self.behind) = (format!("{before}{new}"), behind.to_owned());
    }

    /// Types what belongs into each blank, and the key that leads to the next one.
    fn fill_in(&mut self, mut snippet: Snippet, blanks: &[&str]) -> String {
        let stops: Vec<usize> = snippet.values.keys().copied().collect();
        assert!(blanks.len() <= stops.len(), "{blanks:?}");
        for (at, stop) in stops.into_iter().enumerate() {
            let typed = blanks.get(at).copied().unwrap_or_default();
            if !typed.is_empty() {
                snippet.values.insert(stop, typed.to_owned());
            }
            self.done(typed.chars().count() + 1, &format!("`{typed}`, next blank"));
        }
        snippet.text()
    }

    /// Goes to the first finding, opens the menu and chooses the first quick fix, until there is no finding.
    fn fix_findings(&mut self) {
        loop {
            let text = self.text();
            let found = self.client.change(self.name, &text);
            let Some(first) = found.as_array().unwrap().first() else { return };
            let range = first["range"].clone();
            let context = json!({ "diagnostics": [first], "only": ["quickfix"] });
            let params = json!({ "textDocument": self.client.document(self.name), "range": range, "context": context });
            let actions = self.client.ask("textDocument/codeAction", params);
            let action = actions[0].clone();
            assert!(action["edit"].is_object(), "no fix of {first}");
            self.done(3, &format!("next finding, menu, first: {}", action["title"].as_str().unwrap()));
            let uri = self.client.uri(self.name);
            (self.before, self.behind) = (edited(&text, &action["edit"]["changes"][uri]), String::new());
            assert!(self.keys < 1000, "the fixes do not end:\n{}", self.log);
        }
    }
}

/// Whether the characters of a line are in an item, in their order.
fn is_shown(item: &Value, line: &str) -> bool {
    let text = item["filterText"].as_str().or(item["label"].as_str()).unwrap().to_lowercase();
    let mut rest = text.chars();
    line.to_lowercase().chars().all(|wanted| rest.any(|c| c == wanted))
}

/// A text with blanks, as the protocol writes it: `${1:word}`, `${1}`, and `$0` for the place of the cursor behind it.
struct Snippet {
    parts: Vec<Part>,
    values: BTreeMap<usize, String>,
}

enum Part {
    Text(String),
    Blank(usize),
}

impl Snippet {
    fn parse(text: &str) -> Self {
        let mut snippet = Self { parts: Vec::new(), values: BTreeMap::new() };
        let mut plain = String::new();
        let mut rest = text;
        while let Some(c) = rest.chars().next() {
            rest = &rest[c.len_utf8()..];
            match c {
                '\\' => {
                    plain.extend(rest.chars().next());
                    rest = &rest[1..];
                }
                '$' if rest == "0" => break,
                '$' => {
                    let (blank, behind) = rest.strip_prefix('{').unwrap().split_once('}').unwrap();
                    let (number, word) = blank.split_once(':').unwrap_or((blank, ""));
                    let number: usize = number.parse().unwrap();
                    snippet.parts.push(Part::Text(std::mem::take(&mut plain)));
                    snippet.parts.push(Part::Blank(number));
                    snippet.values.entry(number).or_insert_with(|| word.to_owned());
                    rest = behind;
                }
                c => plain.push(c),
            }
        }
        snippet.parts.push(Part::Text(plain));
        snippet
    }

    fn text(&self) -> String {
        let part = |part: &Part| match part {
            Part::Text(text) => text.clone(),
            Part::Blank(number) => self.values[number].clone(),
        };
        self.parts.iter().map(part).collect()
    }
}

#[test]
fn a_device_is_written_with_at_most_150_keys() {
    let mut user = User::start("new.eds");
    user.complete("[", "[FileInfo] a device of CiA 301", &["Acme", "0x3F9", "Lamp"]);
    user.complete("[rec", "[2000] new RECORD of the vendor", &["Limits", "Lowest", "Highest"]);
    user.complete("[arr", "[2001] new ARRAY of the vendor", &["Brightness"]);
    user.complete("[tpd", "[1800] TPDO 1 with its mapping", &[]);
    user.fix_findings();
    let total = user.keys;
    insta::assert_snapshot!(format!("{}{total:3} keys\n", user.log));
    assert!(total <= 150, "{total} keys:\n{}", user.log);
    let bytes = user.text().into_bytes();
    let (_, input) = Reading::default().read("new.eds", bytes.clone()).unwrap();
    let Input::Description(description) = input else { panic!("no description") };
    let found: Vec<String> =
        objdict::check(&description).iter().map(|found| found.message.to_string()).collect();
    assert_eq!(found, [] as [String; 0]);
    let device = description.device();
    let record: Vec<String> =
        device.object(0x2000).unwrap().entries().map(|(_, entry)| entry.name.to_string()).skip(1).collect();
    assert_eq!(record, ["Lowest", "Highest"]);
    let carried: Vec<u32> = device
        .pdos()
        .flat_map(|pdo| pdo.slots)
        .filter_map(|slot| slot.object)
        .map(objdict::model::MappedObject::to_number)
        .collect();
    assert_eq!(carried, [0x2001_0110, 0x2001_0210]);
    read_by_others(&bytes);
}

/// What python-canopen reads.
fn read_by_others(bytes: &[u8]) {
    let Some(programs) = crate::interop::environment() else { return };
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("new.eds"), bytes).unwrap();
    let script = "import canopen\n\
        od = canopen.import_od('new.eds', node_id=5)\n\
        print([od[0x2000][n].name for n in (1, 2)], [od[0x2001][n].name for n in (1, 2)])\n\
        node = canopen.LocalNode(5, od)\n\
        canopen.Network().add_node(node)\n\
        node.tpdo.read(from_od=True)\n\
        print(hex(node.tpdo[1].cob_id), [variable.name for variable in node.tpdo[1]])\n\
        print(hex(od[0x1018][1].default), od.device_information.vendor_name)\n";
    let output = Command::new(programs.join("python"))
        .args(["-c", script])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert_eq!(
        said,
        "['Lowest', 'Highest'] ['Brightness 1', 'Brightness 2']\n\
         0x185 ['Brightness.Brightness 1', 'Brightness.Brightness 2']\n\
         0x3f9 Acme\n",
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
}
