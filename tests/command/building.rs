//! What docs/guides/cmake.md says of make, as it is written there, and docs/reference/features.md of the features.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::{Duration, SystemTime};

use tempfile::TempDir;

use crate::support::skips::has;

/// The only block of a language on the page.
fn block(language: &str) -> String {
    let page = fs::read_to_string("docs/guides/cmake.md").unwrap();
    let rest = page.split_once(&format!("```{language}\n")).unwrap().1;
    rest.split_once("```").unwrap().0.to_owned()
}

struct Project(TempDir);

impl Project {
    fn new() -> Self {
        let folder = TempDir::new().unwrap();
        fs::copy("examples/climate-sensor.eds", folder.path().join("climate-sensor.eds")).unwrap();
        let program = "#include \"od_pdo.h\"\nint main(void)\n{\n    static od_data_t data;\n    \
                       od_init(&data, OD_NODE_ID);\n    return data.tpdo_1_cob_id == OD_TPDO1_COB_ID(5) ? 0 : 1;\n}\n";
        fs::write(folder.path().join("main.c"), program).unwrap();
        fs::write(folder.path().join("Makefile"), block("make")).unwrap();
        Self(folder)
    }

    fn path(&self, name: &str) -> std::path::PathBuf {
        self.0.path().join(name)
    }

    /// What make does and prints, and whether it succeeds.
    fn make(&self) -> (String, bool) {
        let objdict = format!("OBJDICT={}", crate::program());
        let output = Command::new("make").arg(objdict).current_dir(self.0.path()).output().unwrap();
        let printed = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        (printed, output.status.success())
    }

    /// Makes a file newer than all others.
    fn touch(&self, name: &str) {
        let file = fs::File::options().append(true).open(self.path(name)).unwrap();
        file.set_modified(SystemTime::now() + Duration::from_secs(2)).unwrap();
    }

    fn modified(&self, name: &str) -> SystemTime {
        fs::metadata(self.path(name)).unwrap().modified().unwrap()
    }
}

fn has_make() -> bool {
    has("make", "make") && has("cc", "gcc")
}

#[test]
fn the_rule_of_make() {
    if !has_make() {
        return;
    }
    let project = Project::new();
    let (printed, is_well) = project.make();
    assert!(is_well, "{printed}");
    let firmware = project.path("firmware");
    assert!(Command::new(&firmware).status().unwrap().success());

    // nothing to do, although no table is newer than the description
    let (printed, _) = project.make();
    assert!(printed.contains("up to date"), "{printed}");

    // a description that is touched is read once, and the tables stay
    let table = project.modified("build/od.c");
    project.touch("climate-sensor.eds");
    let (printed, is_well) = project.make();
    assert!(is_well && printed.contains("unchanged"), "{printed}");
    assert_eq!(project.modified("build/od.c"), table);
    assert!(Path::new(&project.path("build/od.stamp.d")).is_file());
}

/// What is read beside the description makes the tables old too, and may go again.
#[test]
fn make_knows_what_was_read() {
    if !has_make() {
        return;
    }
    let project = Project::new();
    fs::write(project.path("objdict.toml"), "deny = \"error\"\n").unwrap();
    let (printed, is_well) = project.make();
    assert!(is_well, "{printed}");
    let rule = fs::read_to_string(project.path("build/od.stamp.d")).unwrap();
    assert!(rule.contains("objdict.toml"), "{rule}");
    project.touch("objdict.toml");
    assert!(project.make().0.contains("generate"), "the configuration counts");
    fs::remove_file(project.path("objdict.toml")).unwrap();
    assert!(project.make().1, "a file that is gone stops nothing");
}

/// An error stops make, and leaves no stamp that says otherwise.
#[test]
fn an_error_stops_make() {
    if !has_make() {
        return;
    }
    let project = Project::new();
    let eds = fs::read_to_string(project.path("climate-sensor.eds")).unwrap();
    let broken = eds.replace("DefaultValue=600\n", "DefaultValue=60000\n");
    assert_ne!(broken, eds);
    fs::write(project.path("climate-sensor.eds"), broken).unwrap();
    let (printed, is_well) = project.make();
    assert!(!is_well && printed.contains("`60000` is out of range"), "{printed}");
    assert!(!project.path("build/od.stamp").exists());
}

/// The crates that a build script compiles with each feature. Other systems have crates of their own.
#[test]
#[cfg(target_os = "linux")]
fn features_need_so_many_crates() {
    let page = fs::read_to_string("docs/reference/features.md").unwrap();
    let table = page.split_once("| feature | adds | crates |\n|---|---|---|\n").expect("the table").1;
    let mut wrong = Vec::new();
    for row in table.lines().take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [feature, _, stated] = cells[..] else { panic!("{row}") };
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args([
            "tree",
            "--package",
            "objdict",
            "--locked",
            "-e",
            "normal",
            "--prefix",
            "none",
            "--no-default-features",
        ]);
        if feature != "none" {
            cargo.args(["--features", feature.trim_matches('`')]);
        }
        let output = cargo.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let printed = String::from_utf8(output.stdout).unwrap();
        let crates = printed.lines().map(|line| line.trim_end_matches(" (*)"));
        let crates: std::collections::BTreeSet<&str> = crates.collect();
        if crates.len().to_string() != stated {
            wrong.push(format!("{feature} needs {}, not {stated}", crates.len()));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}
