//! docs/reference/config.md says what a configuration can say.

use std::fs;
use std::path::Path;

use objdict::config::Config;
use objdict::diagnostic::{Severity, Tool};
use objdict::lint::{Level, Severities};
use objdict::registry;
use objdict::source::SourceFile;

/// The first block of a language on the page.
fn block(language: &str) -> String {
    let page = fs::read_to_string("docs/reference/config.md").unwrap();
    let (_, rest) = page.split_once(&format!("```{language}\n")).unwrap();
    rest.split_once("```").unwrap().0.to_owned()
}

#[test]
fn the_example_of_the_page_holds() {
    let config = Config::read(SourceFile::from_text("objdict.toml", block("toml")), "/project");
    let messages: Vec<_> = config.findings().iter().map(|finding| finding.message.to_string()).collect();
    assert!(messages.is_empty(), "{messages:?}");
    assert!(config.is_toml());
    assert_eq!(config.deny(), Some(Severity::Warning));
    assert_eq!(config.profiles().len(), 1);
    for (path, is_excluded) in
        [("vendor/x/a.eds", true), ("a/b.bak.eds", true), ("b.bak.eds", true), ("a/b.eds", false)]
    {
        assert_eq!(config.excludes(&Path::new("/project").join(path)), is_excluded, "{path}");
    }
    let options = config.options("/project/a.eds", &Severities::default());
    assert_eq!(options.node_id, Some(5));
    assert_eq!(options.tools, [Tool::DcfTools, Tool::CanOpenEditor]);
    let level = |path: &str, rule: &str| {
        let options = config.options(path, &Severities::default());
        options.severities.of(registry::rule(rule).unwrap())
    };
    assert_eq!(level("/project/a.eds", "cia306/file-name"), Some(Level::Off));
    assert_eq!(level("/project/a.eds", "cia306/octal-number"), Some(Level::At(Severity::Warning)));
    assert_eq!(level("/project/a.eds", "cia301/no-error-control"), Some(Level::At(Severity::Error)));
    assert_eq!(level("/project/a.eds", "cia301/wrong-access"), None);
    assert_eq!(level("/project/legacy/x/a.dcf", "cia306/octal-number"), Some(Level::Off));
    assert_eq!(level("/project/legacy/a.eds", "cia306/octal-number"), Some(Level::At(Severity::Warning)));
    assert_eq!(level("/project/simulator/a.eds", "cia301/no-error-control"), Some(Level::Off));
}

#[test]
fn arguments_count_more_than_the_configuration_and_less_than_its_paths() {
    let config = Config::read(SourceFile::from_text("objdict.toml", block("toml")), "/project");
    let rule = registry::rule("cia306/octal-number").unwrap();
    let mut more = Severities::default();
    more.set(registry::select("cia306").unwrap(), Level::At(Severity::Note));
    let level = |path: &str| config.options(path, &more).severities.of(rule);
    assert_eq!(level("/project/a.eds"), Some(Level::At(Severity::Note)));
    assert_eq!(level("/project/legacy/a.dcf"), Some(Level::Off));
    let name = registry::rule("cia306/file-name").unwrap();
    let options = config.options("/project/a.eds", &more);
    assert_eq!(options.severities.of(name), Some(Level::At(Severity::Note)));
}

#[test]
fn the_page_names_every_setting_and_every_rule_about_them() {
    let page = fs::read_to_string("docs/reference/config.md").unwrap();
    let config = Config::read(SourceFile::from_text("objdict.toml", "x = 1"), "/project");
    let finding = config.findings().iter().next().unwrap();
    let help = finding.help.as_ref().unwrap().shown();
    let settings: Vec<&str> = help.split('`').skip(1).step_by(2).collect();
    assert_eq!(settings.len(), 8);
    for setting in settings {
        assert!(page.contains(setting), "{setting}");
    }
    for rule in ["unknown-setting", "unknown-rule", "invalid-setting", "invalid-toml", "unused-suppression"] {
        let id = format!("objdict/{rule}");
        assert!(registry::rule(&id).is_some() && page.contains(&id), "{id}");
    }
}
