//! The table of docs/reference/lsp.md beside what the server announces, and what it answers about files of each column.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::client::{Client, fixture, position};

/// What is asked to know whether a cell says `no`.
enum Ask {
    /// The findings.
    Findings,
    /// A request about a place.
    Place(&'static str),
    /// A request about a whole file.
    File(&'static str),
    /// Actions of this kind whose titles have these words.
    Action(&'static str, &'static str),
    /// Another row asks; the cells are about parts of an answer.
    Elsewhere,
}
use Ask::{Action, Elsewhere, File, Findings, Place};

/// How a row begins, what the server announces for it, and what is asked.
const ROWS: [(&str, &[&str], Ask); 20] = [
    ("findings", &["textDocumentSync"], Findings),
    ("quick fixes", &["quickfix", "source.fixAll", "source.fixAllUnsafe"], Action("quickfix", "")),
    ("a comment that accepts", &["quickfix"], Action("quickfix", "allow")),
    ("formatting", &["documentFormattingProvider"], File("formatting")),
    ("hover", &["hoverProvider"], Place("hover")),
    ("completion: keys", &["completionProvider"], Place("completion")),
    ("completion: mappings", &["completionProvider"], Elsewhere),
    ("completion: rules", &["completionProvider"], Elsewhere),
    ("definition", &["definitionProvider", "referencesProvider"], Place("definition")),
    ("changing an index", &["renameProvider"], Place("prepareRename")),
    (
        "outline",
        &["documentSymbolProvider", "foldingRangeProvider", "selectionRangeProvider"],
        File("documentSymbol"),
    ),
    ("names next to", &["inlayHintProvider"], File("inlayHint")),
    ("contents of each PDO", &["codeLensProvider"], File("codeLens")),
    ("semantic colours", &["semanticTokensProvider"], File("semanticTokens/full")),
    ("links to files", &["documentLinkProvider"], File("documentLink")),
    ("objects by index", &["workspaceSymbolProvider"], Elsewhere),
    ("adding a sub-index", &["refactor"], Action("refactor", "add")),
    ("a new file in", &["refactor"], Action("refactor", "convert")),
    ("a node of the network", &["refactor"], Action("refactor", "network of the folder")),
    (
        "documentation",
        &["source.documentation", "executeCommandProvider"],
        Action("source.documentation", ""),
    ),
];

/// The names of what a server announces; kinds of actions by themselves.
fn announced(client: &Client) -> BTreeSet<String> {
    let capabilities = client.offered["capabilities"].as_object().unwrap();
    let kinds = capabilities["codeActionProvider"]["codeActionKinds"].as_array().unwrap();
    let kinds = kinds.iter().map(|kind| kind.as_str().unwrap().to_owned());
    let others = ["codeActionProvider", "positionEncoding", "workspace"];
    let providers = capabilities.keys().filter(|name| !others.contains(&&***name)).cloned();
    providers.chain(kinds).collect()
}

/// Files of each column, every one with a mistake.
fn columns() -> [Vec<(&'static str, String)>; 4] {
    let broken = |text: String, from: &str, to: &str| {
        assert!(text.contains(from), "no `{from}`");
        text.replacen(from, to, 1)
    };
    // not as `fmt` writes it
    let xdc = broken(fixture("xdc/io-401-node5.xdc"), "access=\"read\"", "access=\"reed\"");
    let xdc = broken(xdc, "  <ISO15745Profile>", "<ISO15745Profile>");
    let extended = "format = \"objdict-device/1\"\nextends = \"device.toml\"\n";
    let network = "[node.a]\nfile = \"island.eds\"\nid = 2\nhartbeat = 500\n[node.a.set]\n\"1017\" = 500\n";
    let settings = "exclud = [\"old/**\"]\n[rules]\n\"cia306/sub-0-type\" = \"off\"\n";
    [
        vec![("a.dcf", broken(fixture("dcf/encoder-406-node3.dcf"), "AccessType=ro", "AccessType = ro"))],
        vec![
            ("device.toml", broken(fixture("toml/io.toml"), "product-name", "product-nme")),
            ("extended.device.toml", extended.to_owned()),
            ("b.xdc", xdc),
        ],
        vec![("network.toml", network.to_owned())],
        vec![("objdict.toml", settings.to_owned())],
    ]
}

fn is_something(answer: &Value) -> bool {
    let answer = answer.get("data").unwrap_or(answer);
    !answer.is_null() && answer.as_array().is_none_or(|list| !list.is_empty())
}

/// The starts of the words of a text.
fn words(text: &str) -> impl Iterator<Item = Value> {
    text.lines().enumerate().flat_map(|(line, row)| {
        let mut before = ' ';
        let mut column = 0;
        let starts = row.chars().filter_map(move |c| {
            let is_start = c.is_alphanumeric() && !before.is_alphanumeric();
            (before, column) = (c, column + c.len_utf16());
            is_start.then(|| json!({ "line": line, "character": column - c.len_utf16() }))
        });
        starts.collect::<Vec<_>>()
    })
}

/// Whether the server answers with anything.
fn answers(client: &mut Client, name: &str, text: &str, ask: &Ask) -> bool {
    let document = client.document(name);
    let end = position(text, text.len());
    let all = json!({ "start": { "line": 0, "character": 0 }, "end": end });
    match ask {
        Findings => is_something(&client.change(name, text)),
        Place(method) => words(text).any(|position| {
            let params = json!({ "textDocument": document, "position": position });
            let id = client.send_request(&format!("textDocument/{method}"), params);
            client.answer_to(&id).response_result.is_ok_and(|answer| is_something(&answer))
        }),
        File(method) => {
            let options = json!({ "tabSize": 2, "insertSpaces": true });
            let params = json!({ "textDocument": document, "range": all, "options": options });
            is_something(&client.ask(&format!("textDocument/{method}"), params))
        }
        Action(kind, title) => words(text).any(|position| {
            let range = json!({ "start": position, "end": position });
            let context = json!({ "diagnostics": [], "only": [kind] });
            let params = json!({ "textDocument": document, "range": range, "context": context });
            let actions = client.ask("textDocument/codeAction", params);
            actions.as_array().unwrap().iter().any(|action| action["title"].as_str().unwrap().contains(title))
        }),
        Elsewhere => false,
    }
}

#[test]
fn the_table_of_the_page_is_what_the_server_does() {
    let edit = json!({ "documentChanges": true, "resourceOperations": ["create"] });
    let window = json!({ "showDocument": { "support": true } });
    let mut client = Client::start_with(&json!({ "workspace": { "workspaceEdit": edit }, "window": window }));
    let named: BTreeSet<String> =
        ROWS.iter().flat_map(|(_, names, _)| *names).map(|&name| name.to_owned()).collect();
    assert_eq!(announced(&client), named);
    client.write("encoder-406.eds", fixture("eds/encoder-406.eds"));
    client.write("island.eds", fixture("network/island.eds"));
    let columns = columns();
    for (name, text) in columns.iter().flatten() {
        client.write(name, text);
        client.open(name, text);
    }
    let page = std::fs::read_to_string("docs/reference/lsp.md").unwrap();
    let rows: Vec<Vec<&str>> = page
        .lines()
        .skip_while(|line| !line.starts_with("|---"))
        .skip(1)
        .map_while(|line| {
            Some(line.strip_prefix('|')?.trim_end_matches('|').split('|').map(str::trim).collect())
        })
        .collect();
    assert_eq!(rows.len(), ROWS.len());
    let mut wrong = Vec::new();
    for (row, (start, _, ask)) in rows.iter().zip(&ROWS) {
        assert!(row[0].starts_with(start) && row.len() == 5, "{row:?} is not about {start}");
        if matches!(ask, Elsewhere) {
            continue;
        }
        for (cell, files) in row[1..].iter().zip(&columns) {
            let does = files.iter().any(|(name, text)| answers(&mut client, name, text, ask));
            if does == (*cell == "no") {
                wrong.push(format!("{}: `{cell}` for {}", row[0], files[0].0));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
