//! The patches that a configuration names.

use std::path::Path;
use std::sync::Arc;

use super::configuration::Config;
use crate::registry::own::invalid_setting;
use objdict_format::patch::Patch;
use objdict_model::diagnostic::{Findings, say};

/// The patches, sorted for each pattern.
pub(super) fn named(config: &Config, folder: &Path, findings: &mut Findings) -> Vec<Arc<Patch>> {
    let mut patches = Vec::new();
    for wanted in config.patches() {
        let pattern = format!("{}/{}", glob::Pattern::escape(&folder.display().to_string()), wanted.pattern);
        let pattern = if folder == Path::new("") { wanted.pattern.clone() } else { pattern };
        let found =
            glob::glob(&pattern).into_iter().flatten().filter_map(Result::ok).filter(|path| path.is_file());
        let before = patches.len();
        for path in found {
            match Patch::open(&path) {
                Ok(patch) => patches.push(Arc::new(patch)),
                Err(error) => {
                    findings.push(invalid_setting(wanted.span, error.to_string()).help("name TOML patches"));
                }
            }
        }
        if patches.len() == before {
            let message = say!("`{}` matches no patch", wanted.pattern.as_str());
            findings.push(
                invalid_setting(wanted.span, message)
                    .help("write a pattern relative to this configuration's folder"),
            );
        }
    }
    patches
}
