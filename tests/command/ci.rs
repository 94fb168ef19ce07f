//! The files that run objdict in CI: their keys, and the scripts of the action and of GitLab's component with a `cargo` that brings
//! the command of this build. The workflows of the project itself: what their first run would stumble over.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// The values of a key in a YAML text of one line a value.
fn values<'t>(text: &'t str, key: &str) -> Vec<&'t str> {
    let value = |line: &'t str| {
        let line = line.trim_start().trim_start_matches("- ");
        line.strip_prefix(key)?.strip_prefix(':').map(str::trim)
    };
    text.lines().filter_map(value).collect()
}

#[test]
fn the_hooks_call_what_there_is() {
    let hooks = fs::read_to_string(".pre-commit-hooks.yaml").expect("the hooks");
    assert_eq!(values(&hooks, "id"), ["objdict-check", "objdict-check-system"]);
    assert_eq!(values(&hooks, "language"), ["rust", "system"]);
    for files in values(&hooks, "files") {
        assert_eq!(files, r"(?i)(\.(eds|dcf|xdd|xdc|nxdd|nxdc)|(^|[/._-])device\.toml)$");
    }
    for entry in values(&hooks, "entry") {
        let mut words = entry.split(' ');
        assert_eq!(words.next(), Some("objdict"));
        let mut command = Command::new(crate::program());
        let output = command.args(words).arg("fixtures/eds/minimal.eds").output().expect("it runs");
        assert_eq!(output.status.code(), Some(0), "{entry}");
    }
}

#[test]
fn the_inputs_of_the_action_are_documented() {
    let action = fs::read_to_string("action.yml").expect("the action");
    let page = fs::read_to_string("docs/guides/ci-github.md").expect("the page");
    let (_, inputs) = action.split_once("\ninputs:\n").expect("inputs");
    let (inputs, _) = inputs.split_once("\nruns:\n").expect("runs");
    let names: Vec<&str> = inputs
        .lines()
        .filter_map(|line| line.strip_prefix("  ")?.strip_suffix(':'))
        .filter(|name| !name.starts_with(' '))
        .collect();
    let expected = "files args baseline config format output deny version working-directory";
    assert_eq!(names.join(" "), expected);
    for name in names {
        assert!(page.contains(&format!("\n| `{name}` |")), "{name} is not in docs/guides/ci-github.md");
        assert!(action.contains(&format!("${{{{ inputs.{name} }}}}")), "{name} is not used");
    }
}

/// The scripts of a YAML file, each of which is a block of lines behind `head`.
fn scripts(file: &str, head: &str) -> Vec<String> {
    let text = fs::read_to_string(file).expect("a file");
    let mut scripts = Vec::new();
    for part in text.split(head).skip(1) {
        // behind the head only a comment
        let lines = part.lines().skip(1).map_while(|line| match line.trim_start() {
            "" => Some(""),
            _ => line.strip_prefix("        ").or_else(|| line.strip_prefix("      ")),
        });
        scripts.push(lines.collect::<Vec<_>>().join("\n"));
    }
    scripts
}

/// Writes a program that stands before others in the path.
fn stub(file: &Path, script: &str) {
    fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
    fs::write(file, format!("#!/bin/sh\n{script}\n")).expect("the stub");
    let executable = std::os::unix::fs::PermissionsExt::from_mode(0o755);
    fs::set_permissions(file, executable).expect("the stub");
}

/// A `cargo` that installs the command of this build.
fn cargo() -> String {
    let program = crate::program();
    format!(
        "while [ \"$1\" != --root ]; do shift; done\nmkdir -p \"$2/bin\"\nln -sf {program} \"$2/bin/objdict\""
    )
}

/// Runs the action as a workflow does, in `folder`, with inputs beside the defaults.
fn act(folder: &Path, inputs: &[(&str, &str)]) -> Output {
    let bin = folder.join("stub");
    stub(&bin.join("cargo"), &cargo());
    let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap_or_default());
    let defaults = [
        ("FILES", "."),
        ("ARGS", ""),
        ("BASELINE", ""),
        ("CONFIG", ""),
        ("FORMAT", "github"),
        ("OUTPUT", ""),
        ("DENY", "warning"),
    ];
    let [outputs, paths] = ["outputs", "paths"].map(|name| bin.join(name));
    fs::write(&paths, "").expect("a file");
    let mut last = None;
    for script in scripts("action.yml", "      run: |") {
        let mut command = Command::new("bash");
        command.args(["--noprofile", "--norc", "-e", "-o", "pipefail", "-c", &script]).current_dir(folder);
        // as a runner does with what a step adds to the path
        let added = fs::read_to_string(&paths).expect("a file").trim().to_owned();
        command.env("PATH", format!("{added}:{path}")).env("RUNNER_TEMP", folder.join("temp"));
        command.env("GITHUB_OUTPUT", &outputs).env("GITHUB_PATH", &paths);
        let published = fs::read_to_string(&outputs).unwrap_or_default();
        command.env("PUBLISHED", if published.contains("published=true\n") { "true" } else { "false" });
        command.env("SOURCE", env!("CARGO_MANIFEST_DIR")).env("VERSION", "");
        command.envs(defaults).envs(inputs.iter().copied());
        let output = command.output().expect("bash");
        let goes_on = output.status.success();
        last = Some(output);
        if !goes_on {
            break;
        }
    }
    last.expect("a step")
}

#[test]
fn the_action_checks_what_it_is_given() {
    let folder = tempfile::tempdir().expect("a folder");
    let devices = folder.path().join("my devices");
    fs::create_dir(&devices).expect("a folder");
    fs::copy("fixtures/eds/minimal.eds", devices.join("minimal.eds")).expect("a file");
    let output = act(folder.path(), &[]);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "no findings in 1 file\n");

    fs::copy("fixtures/broken/orphan-sub.eds", folder.path().join("orphan-sub.eds")).expect("a file");
    let output = act(folder.path(), &[("FILES", "my devices\n*.eds\n")]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stdout).starts_with("::error file=orphan-sub.eds,line=183"));
    let output = act(folder.path(), &[("FILES", "my devices")]);
    assert_eq!(output.status.code(), Some(0));

    let output = act(folder.path(), &[("FORMAT", "sarif"), ("OUTPUT", "out.sarif")]);
    assert_eq!((output.status.code(), output.stdout.is_empty()), (Some(1), true));
    let log = fs::read(folder.path().join("out.sarif")).expect("the log");
    assert!(serde_json::from_slice::<serde_json::Value>(&log).is_ok());
}

#[test]
fn the_action_takes_a_baseline_and_arguments() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy("fixtures/broken/orphan-sub.eds", folder.path().join("orphan-sub.eds")).expect("a file");
    let mut write = Command::new(crate::program());
    write.args(["check", "--write-baseline", "known.json", "."]).current_dir(folder.path());
    write.output().expect("it runs");
    assert_eq!(act(folder.path(), &[("BASELINE", "known.json")]).status.code(), Some(0));
    let ignored = "--ignore\ncia306/sub-without-object\n";
    assert_eq!(act(folder.path(), &[("ARGS", ignored)]).status.code(), Some(0));
    assert_eq!(act(folder.path(), &[]).status.code(), Some(1));
}

#[test]
fn the_action_finds_out_whether_there_are_packages() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy("fixtures/eds/minimal.eds", folder.path().join("minimal.eds")).expect("a file");
    act(folder.path(), &[]);
    let outputs = fs::read_to_string(folder.path().join("stub/outputs")).expect("outputs");
    let published = format!("published={}\n", objdict_model::diagnostic::PUBLISHED);
    assert!(outputs.contains(&published) && outputs.starts_with("hash="), "{outputs}");
}

#[test]
fn the_action_insists_on_a_version() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::copy("fixtures/eds/minimal.eds", folder.path().join("minimal.eds")).expect("a file");
    assert_eq!(act(folder.path(), &[("VERSION", env!("CARGO_PKG_VERSION"))]).status.code(), Some(0));
    assert_eq!(act(folder.path(), &[("VERSION", "99.0.0")]).status.code(), Some(2));
}

/// Runs git in a folder, as an author with a name, and returns what it prints.
fn git(folder: &Path, words: &str) -> String {
    let mut git = Command::new("git");
    git.args(["-c", "user.name=test", "-c", "user.email=test@localhost"]).args(words.split(' '));
    let output = git.current_dir(folder).output().expect("git");
    assert!(output.status.success(), "git {words}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

#[test]
fn the_component_of_gitlab_builds_the_ref_that_it_is_given() {
    let folder = tempfile::tempdir().expect("a folder");
    let [repository, job] = ["repository", "job"].map(|name| folder.path().join(name));
    fs::create_dir_all(&repository).expect("a folder");
    fs::create_dir_all(&job).expect("a folder");
    git(&repository, "init --quiet --initial-branch main");
    // a commit for each ref; `feature/main` is listed before `main`
    let commits = [
        ("main", "tag first"),
        ("feature/main", "branch feature/main"),
        ("v1", "tag -a -m v1 v1"),
        ("feature/v1", "branch feature/v1"),
        ("light", "tag light"),
        ("both-branch", "branch both"),
        ("both-tag", "tag both"),
        ("last", "branch other"),
    ];
    for (subject, names) in commits {
        git(&repository, &format!("commit --quiet --allow-empty -m {subject}"));
        git(&repository, names);
    }
    git(&repository, "reset --quiet --hard first");
    fs::copy("fixtures/eds/minimal.eds", job.join("minimal.eds")).expect("a file");
    let bin = folder.path().join("bin");
    stub(&bin.join("cargo"), &format!("echo \"$@\" > called\n{}", cargo()));
    let path = format!("{}:{}", bin.display(), std::env::var("PATH").unwrap_or_default());
    let template = scripts("templates/objdict.yml", "    - |").remove(0);

    let commit = git(&repository, "rev-parse other");
    let subjects = [
        ("main", "main"),
        ("feature/main", "feature/main"),
        ("v1", "v1"),
        ("light", "light"),
        ("both", "both-branch"),
        (&*commit, "last"),
    ];
    for (reference, subject) in subjects {
        let mut script = template.clone();
        for (input, value) in
            [("repository", &*repository.to_string_lossy()), ("ref", reference), ("working-directory", ".")]
        {
            script = script.replace(&format!("$[[ inputs.{input} ]]"), value);
        }
        for input in ["version", "baseline", "args"] {
            script = script.replace(&format!("$[[ inputs.{input} ]]"), "");
        }
        let mut bash = Command::new("bash");
        bash.args(["-e", "-o", "pipefail", "-c", &script]).current_dir(&job).env("PATH", &path);
        let output = bash.output().expect("bash");
        assert!(output.status.success(), "{reference}: {}", String::from_utf8_lossy(&output.stderr));
        let called = fs::read_to_string(job.join("called")).expect("cargo was called");
        let (_, revision) = called.split_once("--rev ").expect("a revision");
        let revision = revision.split(' ').next().unwrap_or_default();
        assert_eq!(git(&repository, &format!("log -1 --format=%s {revision}")), subject, "{reference}");
        let report = fs::read_to_string(job.join("gl-code-quality-report.json")).expect("the report");
        assert!(report.starts_with('['), "{report}");
    }
}

/// The workflows of the project, each with its name.
fn workflows() -> Vec<(String, String)> {
    let files = fs::read_dir(".github/workflows").expect("the workflows");
    let paths = files.map(|file| file.expect("a file").path());
    paths.map(|path| (path.display().to_string(), fs::read_to_string(&path).expect("a workflow"))).collect()
}

#[test]
fn actions_are_pinned_by_hash() {
    let mut files = workflows();
    files.push(("action.yml".to_owned(), fs::read_to_string("action.yml").expect("the action")));
    for (file, text) in files {
        for action in values(&text, "uses").into_iter().filter(|action| !action.starts_with("./")) {
            let (_, version) = action.split_once('@').expect("a version");
            let (hash, comment) = version.split_once(' ').unwrap_or((version, ""));
            let is_hash = hash.len() == 40 && hash.bytes().all(|byte| byte.is_ascii_hexdigit());
            assert!(
                is_hash && comment.starts_with("# v"),
                "{file}: `{action}` needs a commit and its version"
            );
        }
    }
}

/// git refuses a checkout of another user, as that of a job in a container is, and Debian's Node is too old for vite and vsce.
#[test]
fn jobs_can_use_git_and_node() {
    for (file, text) in workflows() {
        let (_, jobs) = text.split_once("\njobs:\n").expect("jobs");
        let mut parts: Vec<String> = Vec::new();
        for line in jobs.lines() {
            let is_name =
                line.starts_with("  ") && line.as_bytes().get(2).is_some_and(u8::is_ascii_lowercase);
            if is_name || parts.is_empty() {
                parts.push(String::new());
            }
            parts.last_mut().expect("a job").extend([line, "\n"]);
        }
        for job in parts {
            let steps: Vec<&str> = job.split("\n      - ").collect();
            let has = |step: &str, word: &str| {
                step.lines().any(|line| line.contains(word) && !line.trim_start().starts_with('#'))
            };
            let first = |word: &str| steps.iter().position(|step| has(step, word));
            let uses = ["npm ", "cargo xtask dist", ".ci/run"].iter().filter_map(|word| first(word)).min();
            let Some(uses) = uses else { continue };
            let node = first("uses: actions/setup-node@").filter(|node| *node < uses);
            let node = steps[node.unwrap_or_else(|| panic!("{file}: no Node before `{}`", steps[uses]))];
            let version = values(node, "node-version")[0].parse::<u32>().expect("a number");
            assert!(
                version >= 20 && !node.contains("if:"),
                "{file}: not every leg has Node 20 or newer: {node}"
            );
            let is_safe = first("safe.directory \"$GITHUB_WORKSPACE\"").is_some_and(|safe| safe < uses);
            assert!(is_safe || !job.contains("\n    container:"), "{file}: git refuses the checkout: {job}");
        }
    }
}
