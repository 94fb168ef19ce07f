//! Path patterns of a configuration.

use std::path::{Component, Path};

use glob::{MatchOptions, Pattern, PatternError};

/// A pattern of paths, with `/` between folders on every system. A pattern without a folder matches files and folders
/// of that name at any depth, and a pattern that matches a folder includes everything in it.
#[derive(Debug)]
pub(super) struct PathPattern {
    itself: Pattern,
    inside: Pattern,
}

impl PathPattern {
    pub(super) fn new(text: &str) -> Result<Self, PatternError> {
        let path = text.strip_prefix("./").unwrap_or(text).trim_end_matches('/');
        let path = match path.contains('/') {
            true => path.trim_start_matches('/').to_owned(),
            false => format!("**/{path}"),
        };
        Ok(Self { itself: Pattern::new(&path)?, inside: Pattern::new(&format!("{path}/**"))? })
    }

    pub(super) fn matches(&self, path: &str) -> bool {
        let options = MatchOptions {
            case_sensitive: true,
            require_literal_separator: true,
            require_literal_leading_dot: false,
        };
        self.itself.matches_with(path, options) || self.inside.matches_with(path, options)
    }
}

/// A path relative to a folder, with `/`; if it is outside the folder, from the root.
pub(super) fn relative(path: &Path, folder: &Path) -> String {
    let path = path.strip_prefix(folder).unwrap_or(path);
    let names = path.components().filter_map(|component| match component {
        Component::Normal(name) => Some(name.to_string_lossy()),
        _ => None,
    });
    names.collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;
    use objdict_model::source::absolute;

    #[test]
    fn patterns_mean_files_and_what_is_in_folders() {
        let matches = |pattern: &str, path: &str| PathPattern::new(pattern).unwrap().matches(path);
        for (pattern, path) in [
            ("*.dcf", "a.dcf"),
            ("*.dcf", "line/a.dcf"),
            ("old", "line/old/a.eds"),
            ("line/*.eds", "line/a.eds"),
            ("./line/", "line/1/a.eds"),
            ("/line", "line/a.eds"),
            ("line/**/a.eds", "line/a.eds"),
            ("line/**/a.eds", "line/1/2/a.eds"),
            ("[ab]?.eds", "b1.eds"),
        ] {
            assert!(matches(pattern, path), "{pattern} {path}");
        }
        for (pattern, path) in [
            ("*.dcf", "a.dcf.eds"),
            ("line/*.eds", "line/1/a.eds"),
            ("line/*.eds", "x/line/a.eds"),
            ("old", "older/a.eds"),
            ("a.eds", "A.eds"),
        ] {
            assert!(!matches(pattern, path), "{pattern} {path}");
        }
        assert!(PathPattern::new("a[").is_err());
    }

    #[test]
    fn paths_are_called_from_a_folder() {
        let called = |path: &str, folder: &str| relative(&absolute(Path::new(path)), Path::new(folder));
        assert_eq!(called("/a/./b/../c/d.eds", "/a/c"), "d.eds");
        assert_eq!(called("/x/d.eds", "/a/c"), "x/d.eds");
    }
}
