//! The file names in reports for use on other machines: relative to the project folder, with `/`.

use std::path::{Path, PathBuf};

use objdict_model::source::absolute;

/// The folder that paths are relative to.
#[derive(Clone, Debug, Default)]
pub(super) struct RelativeBase(Option<PathBuf>);

impl RelativeBase {
    pub(super) fn new(folder: &Path) -> Self {
        Self(Some(folder.to_owned()))
    }

    /// The path of a file relative to the folder; paths outside it, and names that are not paths, are
    /// unchanged.
    pub(super) fn relative(&self, name: &str) -> String {
        // a drive has a shorter name than `\\?\C:`, which is not valid in a URI
        let plain = name.strip_prefix(r"\\?\").filter(|rest| rest.as_bytes().get(1) == Some(&b':'));
        let path = Path::new(plain.unwrap_or(name));
        let full = if name.starts_with('<') { path.to_owned() } else { absolute(path) };
        let inside = self.0.as_deref().and_then(|base| full.strip_prefix(base).ok());
        let shown = inside.unwrap_or(path).to_string_lossy();
        let shown = if cfg!(windows) { shown.replace('\\', "/") } else { shown.into_owned() };
        let mut rest = shown.as_str();
        while let Some(behind) = rest.strip_prefix("./") {
            rest = behind.trim_start_matches('/');
        }
        if rest.is_empty() { shown } else { rest.replace("/./", "/") }
    }
}

/// A path as a URI reference (RFC 3986): a relative one unchanged, an absolute one as `file:`, without segments that
/// `..` removes, as URI readers do (§5.2.4).
#[cfg(feature = "full")]
pub(super) fn uri(path: &str) -> String {
    let path = &without_detours(path);
    let mut uri = String::with_capacity(path.len() + 8);
    let is_drive = path.as_bytes().get(1) == Some(&b':') && cfg!(windows);
    if path.starts_with('/') {
        uri.push_str("file://");
    } else if is_drive {
        uri.push_str("file:///");
    }
    for byte in path.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' => uri.push(byte.into()),
            _ if b"/-._~!$&'()*+,;=@".contains(&byte) => uri.push(byte.into()),
            b':' if is_drive => uri.push(':'),
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    uri
}

#[cfg(feature = "full")]
fn without_detours(path: &str) -> String {
    let mut segments: Vec<&str> = Vec::new();
    for segment in path.split('/') {
        match segments.last() {
            Some(last) if segment == ".." && !["", ".", ".."].contains(last) => _ = segments.pop(),
            _ => segments.push(segment),
        }
    }
    segments.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(not(windows))]
    fn paths_are_relative_to_the_folder() {
        let base = RelativeBase::new(Path::new("/home/me/product"));
        for (name, told) in [
            ("drive.eds", "drive.eds"),
            ("./eds/./drive.eds", "eds/drive.eds"),
            (".//drive.eds", "drive.eds"),
            ("/home/me/product/eds/drive.eds", "eds/drive.eds"),
            ("/home/you/drive.eds", "/home/you/drive.eds"),
            ("../drive.eds", "../drive.eds"),
            ("<stdin>", "<stdin>"),
        ] {
            assert_eq!(base.relative(name), told);
        }
        let here = std::env::current_dir().unwrap();
        let above = RelativeBase::new(here.parent().unwrap());
        let folder = here.file_name().unwrap().to_string_lossy();
        assert_eq!(above.relative("src/a.eds"), format!("{folder}/src/a.eds"));
        assert_eq!(above.relative("../other/a.eds"), "other/a.eds");
        assert_eq!(above.relative("<stdin>"), "<stdin>");
        assert_eq!(RelativeBase::default().relative("/home/me/a.eds"), "/home/me/a.eds");
    }

    #[test]
    fn what_has_a_meaning_in_a_uri_is_escaped() {
        assert_eq!(uri("eds/a b#1%.eds"), "eds/a%20b%231%25.eds");
        assert_eq!(
            uri("c:ä?.eds"),
            if cfg!(windows) { "file:///c:%C3%A4%3F.eds" } else { "c%3A%C3%A4%3F.eds" }
        );
        assert_eq!(uri("/a/<b>"), "file:///a/%3Cb%3E");
        assert_eq!(uri("rules/one/../../network/a.eds"), "network/a.eds");
        assert_eq!(uri("../../rules/../a.eds"), "../../a.eds");
    }
}
