//! Names and contents of files that would steer a terminal, or be commands to a CI service that reads the output: every command
//! is run with them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use objdict::format::{self, json};

/// What takes the place of `@` in names: an escape sequence that sets the title, line breaks with a command of GitHub, a C1
/// character, a change of direction, and a command that counts anywhere in a line.
const NAMES: [&str; 2] =
    ["a\u{1B}]0;x\u{7}\r\n::error::b\u{9B}31m\u{202E}##[error]c", "::error::d ##vso[task.complete]"];

/// The same in a value of a description, which is one line.
const TEXT: &str = "::error::a\u{1B}]0;x\u{7}\u{9B}31m\u{202E}##[error]c";

/// What the output of a command is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    /// Text or JSON, which quotes the content of files.
    Text,
    /// A file, with its content as it is.
    Data,
}
use Kind::{Data, Text};

/// What is run, with `@` in the names of files.
const LINES: &[(Kind, &str)] = &[
    (Text, "check @.eds @.dcf @.xdd @-none.eds"),
    (Text, "check @.eds --all --color always"),
    (Text, "check @.eds --format concise --statistics"),
    (Text, "check @.eds --format json --statistics"),
    (Text, "check @.eds @-none.eds --format sarif"),
    (Text, "check @.eds @-none.eds --format github"),
    (Text, "check @.eds --format gitlab"),
    (Text, "check @.eds @-none.eds --format junit"),
    (Text, "bus scan --bus candump:@.log --with @.eds"),
    (Text, "bus scan --bus sim:@.toml --with @.eds"),
    (Text, "bus read 5 1018 --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus watch --for 1 --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus write 5 1017=1 --dry-run --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus save 5 -o @-saved.dcf --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus apply 5 @.dcf --dry-run --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus compare @.toml --bus sim:@.toml"),
    (Text, "bus restore 5 --dry-run --bus sim:@.toml"),
    (Text, "bus lss assign 9 --dry-run --alone --format json --bus sim:@.toml,new=5"),
    (Text, "bus nmt start 5 --dry-run --bus sim:@.toml"),
    (Text, "bus lss scan --bus sim:@.toml"),
    (Text, "bus lss assign 9 --dry-run --bus sim:@.toml"),
    (Text, "bus lss plan @.toml"),
    (Text, "bus replace 5 @.toml --dry-run --bus sim:@.toml"),
    (Text, "conformance @.eds"),
    (Text, "decode @.log --with 5=@.eds"),
    (Text, "decode @.log --with @.eds --summary"),
    (Text, "decode @.log --with 5=@.eds --check"),
    (Text, "decode @.log --with 5=@.eds --check --format junit"),
    (Text, "decode @.log --with 5=@.eds --format json"),
    (Text, "decode @.log --with 5=@.eds --format csv"),
    (Text, "decode @.log --with 5=@.eds --format csv --wide"),
    (Text, "decode @.log --with 5=@.eds --plot @ --html @-log.html"),
    (Text, "decode @.eds"),
    (Text, "decode @-none.log"),
    (Text, "new --from @.eds -o @-made.eds"),
    (Text, "convert @.eds --to canopeneditor-json -o @-project.json"),
    (Text, "probe @.eds -o @-probe"),
    (Text, "probe --answers @.eds --learn -o @-learned.eds"),
    (Text, "probe @.eds --write --overwrite -o @-probe"),
    (Text, "probe @.eds --answers @.txt --html @-probe.html"),
    (Text, "check @.eds --diff"),
    (Text, "check @-fixed.eds --fix --unsafe-fixes -v"),
    (Text, "check @.eds --write-baseline @-new.json"),
    (Text, "check @.eds --baseline @-new.json"),
    (Text, "check @.eds --baseline @.eds"),
    (Text, "check @.eds --profile ./@.eds"),
    (Text, "check @.eds --config @.eds"),
    (Text, "check @-folder"),
    (Text, "open @-none.eds --no-browser"),
    (Text, "check --@=x"),
    (Text, "identify @.eds @.xdd @.toml @.txt @-none"),
    (Text, "identify @.eds @.txt --format json"),
    (Text, "bus scan --bus candump:@.log --with @.eds"),
    (Text, "bus scan --bus sim:@.toml --with @.eds"),
    (Text, "bus read 5 1018 --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus write 5 1017=1 --dry-run --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus save 5 -o @-saved.dcf --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus apply 5 @.dcf --dry-run --bus sim:@.toml --with 5=@.eds"),
    (Text, "bus compare @.toml --bus sim:@.toml"),
    (Text, "bus restore 5 --dry-run --bus sim:@.toml"),
    (Text, "bus nmt start 5 --dry-run --bus sim:@.toml"),
    (Text, "bus lss scan --bus sim:@.toml"),
    (Text, "bus lss assign 9 --dry-run --bus sim:@.toml"),
    (Text, "bus lss plan @.toml"),
    (Text, "bus replace 5 @.toml --dry-run --bus sim:@.toml"),
    (Text, "conformance @.eds"),
    (Text, "conformance @.eds --format json"),
    (Text, "conformance @.eds --format junit"),
    (Text, "conformance @.eds --format html"),
    (Text, "conformance @.eds --dry-run --bus sim:@.toml"),
    (Text, "show @.eds"),
    (Text, "show @.eds 1018"),
    (Text, "show @.eds @"),
    (Text, "show @.eds --format json"),
    (Text, "show @.xdd --format json"),
    (Text, "show @.cpj"),
    (Text, "show @.cpj --format json"),
    (Text, "show @.cdcf"),
    (Text, "show @.txt"),
    (Text, "generate @.eds --target rust,c,concise,canopennode,lely --force -o @-out --report size"),
    (Text, "generate @.eds --target rust,c,concise --force -o @-out -v"),
    (Text, "generate @.eds --target c --force -o @-out --report size --format json"),
    (Text, "generate @.eds --target c --force --list -o @-out"),
    (Text, "generate @.eds --target template --template @.j2 --force -o @-out"),
    (Text, "generate @.eds --target c --rename @.eds --force -o @-out"),
    (Text, "generate @-fixed.eds --target canopennode --add-missing --force -o @-out"),
    (Text, "generate @.eds --target c -o @.txt --stamp @-stamp --depfile @-dep"),
    (Text, "diff @.eds @.xdd"),
    (Text, "diff @.eds @.dcf --against @.cdcf --format json"),
    (Text, "diff @.eds @.dcf --format markdown"),
    (Text, "diff @.eds @.dcf --format github"),
    (Text, "diff @.eds @.dcf --format html"),
    (Text, "diff @.eds @.toml --select @"),
    (Text, "diff --git @ @.eds"),
    (Text, "release @.eds @.xdd"),
    (Text, "release @.eds @-fixed.eds --diff"),
    (Text, "release @.eds @.dcf"),
    (Text, "release @.xdd @-fixed.eds --fix"),
    (Text, "release --git @ @.eds"),
    (Text, "docs @.eds @.dcf @.toml -o @-site"),
    (Text, "docs @.eds -o @.html"),
    (Text, "docs @.eds -o -"),
    (Text, "docs @.eds -o - --to markdown"),
    (Text, "docs @.eds -o - --to csv"),
    (Text, "docs @.eds -o @.zip"),
    (Text, "convert @.eds -o @-new.xdd"),
    (Text, "convert @.eds @.dcf -o @-out/ --to json --loss-report -"),
    (Text, "convert @.dcf -o @.dbc"),
    (Text, "convert @.eds -o @-device.toml"),
    (Text, "convert @.eds --to json"),
    (Text, "convert @.eds @.dcf -o @-other"),
    (Text, "convert @.eds -o @"),
    (Data, "convert @.eds --to eds"),
    (Data, "convert @.eds --to xdd"),
    (Text, "configure @.eds --node-id 5 --bit-rate 125 --set 1017=250 -o @-new.dcf"),
    (Text, "configure @.eds --node-id 5 --set 5fff=1"),
    (Text, "configure @.eds --settings @.eds"),
    (Text, "configure @.eds --node-id 5 --in-place"),
    (Data, "configure @.eds --node-id 5 --bit-rate 125"),
    (Text, "patch apply @.eds -p @.toml -o @-patched.eds"),
    (Text, "patch make @.eds @.dcf -o @-new.toml"),
    (Text, "patch make @.eds @.dcf"),
    (Text, "patch check @.eds @-folder -p @.toml"),
    (Text, "check @.eds -p @.toml --vendor-report @-vendor.md"),
    (Text, "check @.eds -p @-none.toml"),
    (Text, "modules @-coupler.dcf"),
    (Text, "modules @-coupler.dcf --format json"),
    (Text, "modules @.eds"),
    (Text, "variants @.toml"),
    (Text, "variants @.eds"),
    (Text, "network check @.toml"),
    (Text, "network check @.toml @.cpj @.eds --format json"),
    (Text, "network build @.toml --target dcf -o @-built"),
    (Text, "network build @.toml --target cpj -o @-built"),
    (Text, "network build @.toml --target c -o @-tables --force"),
    (Text, "network verify @-built"),
    (Text, "network boot @-built"),
    (Text, "network boot @.toml --format json"),
    (Text, "network timing @.toml"),
    (Text, "network timing @.toml --format json --svg @-timing.svg"),
    (Text, "network verify @-none"),
    (Text, "network show @.toml"),
    (Text, "network show @.toml --format json"),
    (Text, "network show @.dcf @-coupler.dcf"),
    (Text, "network graph @.toml"),
    (Text, "network graph @.toml --format dot"),
    (Text, "network diff @.toml @.cpj"),
    (Text, "network init @.eds @.dcf"),
    (Text, "network schema network"),
    (Text, "schema device"),
    (Text, "schema @"),
    (Text, "dcf pack @.dcf -o @-new.cdcf"),
    (Text, "dcf pack @.dcf --to c --eds @.eds"),
    (Text, "dcf pack @.dcf --to rust"),
    (Text, "dcf pack @.dcf --to text"),
    (Text, "dcf unpack @.cdcf --eds @.eds"),
    (Text, "dcf unpack @.txt"),
    (Text, "dcf diff @.cdcf @-new.cdcf --eds @.eds"),
    (Text, "dcf verify @.cdcf --eds @.eds"),
    (Text, "dcf verify @.cdcf --eds @.eds --format json"),
    (Text, "new --digital-inputs 8 --date 2026-11-21 --overwrite -o @-new.eds"),
    (Text, "new --digital-inputs 8 --date 2026-11-21 -o @-new.eds"),
    (Text, "profile list"),
    (Text, "profile show @-profile.toml"),
    (Text, "profile show @-profile.toml --format json"),
    (Text, "profile show ./@.eds"),
    (Text, "fmt @-fixed.eds"),
    (Text, "fmt @.eds --check"),
    (Text, "fmt @.eds --diff"),
    (Text, "fmt @.xdd"),
    (Text, "rules --group @"),
    (Text, "explain @"),
    (Text, "help @"),
    (Text, "completions @"),
    (Text, "lsp"),
    (Text, "man -o @-man"),
];

/// A folder with a file of each kind, called `@…`.
fn folder(name: &str, text: Option<&str>) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let write =
        |file: &str, bytes: &[u8]| fs::write(folder.path().join(file.replace('@', name)), bytes).unwrap();
    let read = |file: &str| {
        let found = fs::read_to_string(Path::new("fixtures").join(file)).unwrap();
        let Some(text) = text else { return found };
        // names of objects, of the product and of a node; a value that is not valid
        let keys = ["ParameterName=", "ProductName=", "VendorName=", "NodeName=", "NetName=", "Node3Name="];
        let found = keys.iter().fold(found, |found, key| found.replace(key, &format!("{key}{text}")));
        found
            .replace("AccessType=const", &format!("AccessType={text}"))
            .replace("name=\"", &format!("name=\"{}", text.replace(['\u{1B}', '\u{7}'], "")))
    };
    let eds = read("broken/octal.eds").replace("[1000]", "[1000]\nKey\n");
    for file in ["@.eds", "@-fixed.eds"] {
        write(file, eds.as_bytes());
    }
    write("@.dcf", read("dcf/io-401-node5.dcf").as_bytes());
    write("@-coupler.dcf", read("dcf/coupler-modular-node10.dcf").as_bytes());
    write("@.xdd", read("xdd/press-402.xdd").as_bytes());
    write("@.cpj", read("nodelist/line.cpj").replace("../dcf/", "").as_bytes());
    write("@.cdcf", &fs::read("fixtures/concise/careless.cdcf").unwrap());
    write("@.log", read("logs/chapter4.log").replace("can0", "::error::can0\u{1B}]0;x\u{7}").as_bytes());
    write("@.txt", text.unwrap_or("words").as_bytes());
    write("@.j2", b"{{ device.file_info.description }}\n");
    let profile = fs::read_to_string("fixtures/profiles/project-drives.toml").unwrap();
    let name_of = |text: &str| serde_json::to_string(text).unwrap();
    let title = name_of(text.unwrap_or_default());
    write(
        "@-profile.toml",
        profile.replace("title = \"", &format!("title = {}", title.trim_end_matches('"'))).as_bytes(),
    );
    let title = name_of(text.unwrap_or("bus"));
    let file = name_of(&format!("{name}.dcf"));
    let network = format!(
        "[bus]\nname = {title}\nbit-rate = 125\n[manager]\nid = 1\n[node.io]\nfile = {file}\nid = 5\n[node.none]\nfile = {}\nid = 6\n",
        name_of(&format!("{name}-none"))
    );
    write("@.toml", network.as_bytes());
    fs::create_dir(folder.path().join(format!("{name}-folder"))).unwrap();
    let device = format::open(&folder.path().join(format!("{name}.dcf")), &Default::default()).unwrap();
    write("@.json", json::write_device(device.device()).as_bytes());
    folder
}

/// The commands without commands of their own, from what clap declares.
fn commands() -> BTreeSet<String> {
    let output = objdict(Path::new("."), &["completions", "bash"]).0;
    let names = output
        .lines()
        .filter_map(|line| line.trim().strip_prefix("cmd=\"objdict__subcmd__")?.strip_suffix('"'));
    let all: BTreeSet<String> = names.map(|name| name.replace("__subcmd__", " ")).collect();
    let is_leaf = |name: &&String| !all.iter().any(|other| other.starts_with(&format!("{name} ")));
    all.iter().filter(is_leaf).cloned().collect()
}

/// What a command writes to the standard output and to the standard error.
fn objdict(folder: &Path, arguments: &[&str]) -> (String, String, Option<i32>) {
    let output = Command::new(crate::program()).args(arguments).current_dir(folder).output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    (out, err, output.status.code())
}

/// Whether a character steers a terminal or the direction of a text.
fn steers(character: char) -> bool {
    match character {
        '\t' => false,
        '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}' => true,
        _ => character.is_control(),
    }
}

/// The first line of an output that steers something.
fn danger(line: &str, output: &str) -> Option<String> {
    let output = if line.contains("--color always") { without_colours(output) } else { output.to_owned() };
    let annotations = ["::error file=", "::warning file=", "::notice file=", "::error title="];
    let is_ours = |start: &str| {
        line.contains("--format github") && annotations.iter().any(|annotation| start.starts_with(annotation))
    };
    let lines = output.split('\n').map(|line| line.strip_suffix('\r').unwrap_or(line));
    let is_command = |line: &str| {
        let start = line.trim_start();
        (start.starts_with("::") && !is_ours(start)) || line.contains("##[") || line.contains("##vso[")
    };
    lines.filter(|line| line.contains(steers) || is_command(line)).map(str::to_owned).next()
}

/// A report without the codes of its colours.
fn without_colours(output: &str) -> String {
    let mut parts = output.split("\u{1B}[");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| {
        let rest = part.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';');
        text + rest.strip_prefix('m').unwrap_or("\u{1B}")
    })
}

#[test]
fn every_command_is_run() {
    let is_of = |line: &str, command: &str| line == command || line.starts_with(&format!("{command} "));
    let is_run = |command: &&String| LINES.iter().any(|(_, line)| is_of(line, command));
    let commands = commands();
    assert!(commands.len() > 25 && commands.contains("network build"), "{commands:?}");
    let missing: Vec<&String> = commands.iter().filter(|command| !is_run(command)).collect();
    assert!(missing.is_empty(), "add a line to LINES for {missing:?}");
}

/// What `objdict` says of a name is one line that steers nothing.
#[cfg(unix)]
#[test]
fn no_name_steers_anything() {
    for name in NAMES {
        run_all(name, None);
    }
}

#[cfg(unix)]
#[test]
fn no_content_steers_anything() {
    run_all(NAMES[0], Some(TEXT));
}

/// JSON escapes what steers a terminal, and has the names as they are.
#[cfg(unix)]
#[test]
fn json_has_names_as_they_are() {
    for name in NAMES {
        let folder = folder(name, Some(TEXT));
        let file = format!("{name}.eds");
        for arguments in [
            ["show", &file, "--format", "json"],
            ["check", &file, "--format", "json"],
            ["identify", &file, "--format", "json"],
        ] {
            let (text, ..) = objdict(folder.path(), &arguments);
            let document: serde_json::Value = serde_json::from_str(&text).unwrap();
            let first = ["files", "findings"].iter().find_map(|list| document[list][0]["file"].as_str());
            assert_eq!(first.or(document["file"].as_str()), Some(file.as_str()), "{arguments:?}");
        }
    }
}

/// The files of a folder and of those in it.
#[cfg(unix)]
fn files_in(folder: &Path) -> BTreeSet<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files_in(&path) } else { BTreeSet::from([path]) }).collect()
}

/// What steers something in the files that commands wrote, but in descriptions, which have the content as it is.
#[cfg(unix)]
fn dangers_in(folder: &Path, given: &BTreeSet<PathBuf>) -> Vec<String> {
    const WRITTEN: [&str; 12] =
        ["c", "csv", "dot", "h", "html", "json", "md", "py", "rs", "svg", "toml", "txt"];
    let mut found = Vec::new();
    for path in files_in(folder).difference(given) {
        let ending = path.extension().map(|ending| ending.to_string_lossy().into_owned());
        let is_text = ending.is_some_and(|ending| WRITTEN.contains(&&*ending));
        let text = if is_text { fs::read_to_string(path).unwrap() } else { String::new() };
        let line = text.lines().find(|line| line.contains(steers));
        found.extend(line.map(|line| format!("{path:?}\n    {line:?}")));
    }
    found
}

#[cfg(unix)]
fn run_all(name: &str, text: Option<&str>) {
    let folder = folder(name, text);
    let given = files_in(folder.path());
    let mut found = Vec::new();
    for (kind, line) in LINES {
        let arguments: Vec<String> = line.split(' ').map(|word| word.replace('@', name)).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let (out, err, code) = objdict(folder.path(), &arguments);
        assert!(code.is_some_and(|code| code < 3), "{line}: {code:?}: {err}");
        assert!(line.contains(" --@") || !err.contains("Usage: "), "{line}: {err}");
        let out = if *kind == Data && text.is_some() { String::new() } else { out };
        for output in [out, err] {
            found.extend(danger(line, &output).map(|danger| format!("{line}\n    {danger:?}")));
        }
    }
    found.extend(dangers_in(folder.path(), &given));
    assert!(found.is_empty(), "{}", found.join("\n"));
}
