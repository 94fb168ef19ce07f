//! Output for make: the input files of a stamp.

use std::path::{Path, PathBuf};

/// The rule of a stamp for its input files, as written by compilers. Each file also has an empty rule, so that make
/// continues if one of them is missing. `None` if a name contains a line break, which rules do not support.
pub fn depfile(stamp: &Path, files: &[PathBuf]) -> Option<String> {
    let mut names: Vec<String> = Vec::new();
    for file in files {
        let name = escaped(file)?;
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let rest: String = names.iter().skip(1).map(|name| format!("\n{name}:\n")).collect();
    Some(format!("{}: {}\n{rest}", escaped(stamp)?, names.join(" ")))
}

/// A name as make reads it.
fn escaped(path: &Path) -> Option<String> {
    let mut escaped = String::new();
    for character in path.display().to_string().chars() {
        match character {
            '\n' | '\r' => return None,
            ' ' | '#' => escaped.extend(['\\', character]),
            '$' => escaped.push_str("$$"),
            _ => escaped.push(character),
        }
    }
    Some(escaped)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_of_make() {
        let files = ["my motor.eds", "objdict.toml", "objdict.toml", "$x#y.toml"].map(PathBuf::from);
        let rule = "od.stamp: my\\ motor.eds objdict.toml $$x\\#y.toml\n\nobjdict.toml:\n\n$$x\\#y.toml:\n";
        assert_eq!(depfile(Path::new("od.stamp"), &files).as_deref(), Some(rule));
        assert_eq!(depfile(Path::new("a\nb"), &files), None);
    }
}
