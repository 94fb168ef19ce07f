//! `objdict diff`: the old description of a revision, severities of the configuration, equal changes of several entries.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::support::skips::{has, sample};

fn git(folder: &Path, arguments: &[&str]) {
    let mut git = Command::new("git");
    git.args([
        "-c",
        "user.name=objdict",
        "-c",
        "user.email=objdict@example.org",
        "-c",
        "init.defaultBranch=main",
    ]);
    let output = git.arg("-C").arg(folder).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

fn objdict(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(crate::program());
    // a folder above may be a repository
    command.env("GIT_CEILING_DIRECTORIES", std::env::temp_dir());
    command.current_dir(folder).args(arguments).output().unwrap()
}

/// What is printed, and the exit code.
fn said(folder: &Path, arguments: &[&str]) -> (String, i32) {
    let Output { status, stdout, stderr } = objdict(folder, arguments);
    let text = [stdout, stderr].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
    (text, status.code().unwrap())
}

#[test]
fn the_old_description_is_that_of_a_revision() {
    if !has("git", "git") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let copy = |from: &str, to: &str| fs::copy(Path::new("fixtures").join(from), folder.join(to)).unwrap();
    fs::create_dir(folder.join("devices")).unwrap();
    copy("bases/drive.eds", "devices/drive.eds");

    let (text, code) = said(folder, &["diff", "--git", "HEAD", "devices/drive.eds"]);
    assert_eq!(
        (text.lines().next(), code),
        (Some("error: `devices/drive.eds` is not in a git repository"), 2)
    );

    git(folder, &["init", "--quiet"]);
    git(folder, &["add", "."]);
    git(folder, &["commit", "--quiet", "--message", "first"]);
    assert_eq!(said(folder, &["diff", "--git", "HEAD", "devices/drive.eds"]), ("no changes\n".to_owned(), 0));

    copy("diff/drive-2.eds", "devices/drive.eds");
    let (text, code) = said(folder, &["diff", "--git", "main", "devices/drive.eds", "--select", "6084"]);
    assert_eq!(code, 0);
    assert!(text.contains("6084h") && text.contains("  devices/drive.eds:321:2\n"), "{text}");
    let (text, code) = said(folder, &["diff", "--git", "HEAD", "devices/drive.eds", "--select", "1800"]);
    assert_eq!(code, 1);
    assert!(text.contains("HEAD:devices/drive.eds:230:2 → devices/drive.eds:231:2"), "{text}");
    // from the folder of the file
    assert_eq!(said(&folder.join("devices"), &["release", "--git", "HEAD", "drive.eds"]).1, 1);
    assert_eq!(said(folder, &["release", "--git", "HEAD", "devices/drive.eds", "--fix"]).1, 0);
    assert_eq!(said(folder, &["release", "--git", "HEAD", "devices/drive.eds"]).1, 0);
    let fixed = fs::read_to_string(folder.join("devices/drive.eds")).unwrap();
    assert!(fixed.contains("RevisionNumber=0x00020000") && fixed.contains("FileRevision=1"), "{fixed}");

    copy("bases/drive.eds", "new.eds");
    for (arguments, error) in [
        (["HEAD", "new.eds"], "git has no file `new.eds` at `HEAD`"),
        (["origin/main", "devices/drive.eds"], "git has no revision `origin/main`"),
        (["HEAD~1", "devices/drive.eds"], "git has no revision `HEAD~1`"),
        (["HEAD", "-"], "`<stdin>` is not a file in a git repository"),
    ] {
        let (text, code) = said(folder, &["diff", "--git", arguments[0], arguments[1]]);
        assert_eq!((text.lines().next(), code), (Some(&*format!("error: {error}")), 2), "{text}");
    }
    // no option of git
    let (text, code) = said(folder, &["diff", "--git=--output=x", "new.eds"]);
    assert_eq!((&*text, code), ("error: `--output=x` is not a git revision\n", 2));
    assert!(!folder.join("x").exists());
}

#[test]
fn git_is_needed() {
    let mut command = Command::new(crate::program());
    command.env("PATH", "").args(["diff", "--git", "HEAD", "fixtures/bases/drive.eds"]);
    let text = String::from_utf8(command.output().unwrap().stderr).unwrap();
    let error = "error: cannot find git, which provides the former version of the file\n";
    assert!(text.starts_with(error), "{text}");
}

#[test]
fn the_configuration_says_what_counts() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let old = fs::read_to_string("fixtures/eds/drive-402.eds").unwrap();
    // all sub-indexes of a mapping but the first
    let new = (1..=8).fold(old.clone(), |text, sub| {
        let (before, section) = text.split_once(&format!("[1A00sub{sub}]")).unwrap();
        format!("{before}[1A00sub{sub}]{}", section.replacen("AccessType=rw", "AccessType=ro", 1))
    });
    fs::write(folder.join("old.eds"), old).unwrap();
    fs::write(folder.join("new.eds"), new).unwrap();
    let select = ["diff", "--select", "access-narrowed", "old.eds", "new.eds"];
    let (text, code) = said(folder, &select);
    let joined =
        "breaking    1A00h:01-08  the access type changes from `rw` to `ro` [change/access-narrowed]";
    assert_eq!((text.lines().next(), code), (Some(joined), 1));
    assert_eq!(text.lines().last(), Some("8 changes: 8 breaking"));
    for (level, changes, codes) in
        [("off", 0, (0, 0)), ("note", 8, (0, 0)), ("warning", 8, (0, 1)), ("error", 8, (1, 1))]
    {
        let config = format!("[rules]\n\"change/access-narrowed\" = \"{level}\"\n");
        fs::write(folder.join("objdict.toml"), config).unwrap();
        let (json, code) = said(folder, &[&select[..], &["--format", "json"]].concat());
        let found = json.matches("\"rule\": \"change/access-narrowed\"").count();
        let (_, risky) = said(folder, &[&select[..], &["--deny", "risky"]].concat());
        assert_eq!((found, (code, risky)), (changes, codes), "{level}");
        assert_eq!(said(folder, &[&select[..], &["--no-config"]].concat()).1, 1, "{level}");
    }
}

/// The identifiers that a change names are in the generated headers: of the moved and respelled entries of a list, of neighbours
/// among the fixtures and, with `OBJDICT_CORPUS_DIR`, of neighbours below that folder.
#[test]
fn identifiers_are_those_of_the_headers() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let write = |name: &str, entries: &str| {
        let head =
            "format = \"objdict-device/1\"\nprofile = \"301@1\"\n[device]\nproduct-name = \"L\"\n[object]\n";
        fs::write(folder.join(name), format!("{head}{entries}\n")).unwrap();
        folder.join(name)
    };
    let old = "2000.name = \"List\"\n2000.sub.1 = { name = \"A\", type = \"u8\" }\n2000.sub.2 = { name = \"Node ID\", type = \"u8\" }";
    let new = old.replace("Node ID", "All states") + "\n2000.sub.3 = { name = \"Node Id\", type = \"u8\" }";
    let (old, new) = (write("old.toml", old), write("new.toml", &new));
    assert!(named_by_diff(folder, &old, &new).is_empty(), "the entry has its identifier at its new place");

    let mut pairs = vec![(old, new), ("fixtures/bases/drive.eds".into(), "fixtures/diff/drive-2.eds".into())];
    let folders = ["fixtures/eds".into()].into_iter();
    let corpus = std::env::var_os("OBJDICT_CORPUS_DIR").map(|corpus| Path::new(&corpus).join("eds"));
    for descriptions in folders.chain(corpus) {
        let entries = fs::read_dir(&descriptions).unwrap().map(|entry| entry.unwrap().path());
        let mut files: Vec<PathBuf> = entries.collect();
        files.sort();
        pairs.extend(sample(files.windows(2).map(|pair| (pair[0].clone(), pair[1].clone()))));
    }
    let mut count = 0;
    for (old, new) in &pairs {
        let [old, new] = [old, new].map(|file| fs::canonicalize(file).unwrap());
        let named = named_by_diff(folder, &old, &new);
        count += named.len();
        for (file, number) in [(&old, 0), (&new, 1)] {
            let header = header(folder, file);
            let missing = named.iter().map(|names| &names[number]).find(|name| !header.contains(*name));
            assert_eq!(missing, None, "{}", file.display());
        }
    }
    assert!(count > 0, "no identifier changed");
}

/// What C identifiers become, as `diff` prints it.
fn named_by_diff(folder: &Path, old: &Path, new: &Path) -> Vec<[String; 2]> {
    let (text, _) = said(folder, &["diff", old.to_str().unwrap(), new.to_str().unwrap()]);
    let names = text.lines().filter_map(|line| {
        let (_, names) = line.split_once("in C `")?;
        let (before, rest) = names.split_once("` becomes `")?;
        Some([before.to_owned(), rest.split_once('`')?.0.to_owned()])
    });
    names.collect()
}

/// The words of the header that `generate` writes; of a device without tables, none that `diff` could name.
fn header(folder: &Path, file: &Path) -> BTreeSet<String> {
    let tables = folder.join("tables");
    let arguments = ["generate", "--force", "--target", "c", "-o", tables.to_str().unwrap(), "--overwrite"];
    let arguments = [&arguments[..], &[file.to_str().unwrap()]].concat();
    let (said, code) = said(folder, &arguments);
    assert_eq!(code, 0, "{said}");
    let mut words = BTreeSet::new();
    for entry in fs::read_dir(&tables).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "h") {
            let text = fs::read_to_string(path).unwrap();
            words.extend(text.split(|c: char| !c.is_alphanumeric() && c != '_').map(str::to_owned));
        }
    }
    fs::remove_dir_all(&tables).unwrap();
    words
}
