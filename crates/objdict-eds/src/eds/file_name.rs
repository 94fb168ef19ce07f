//! The rule about the name under which a file was opened, which is not part of the model.

use super::findings::FILE_NAME;
use crate::diagnostic::{Argument, Diagnostic, Findings, Fix, say};
use crate::model::{Device, Field, Part, Place};
use objdict_model::Format;

/// Compares `FileName` with the name under which the file was opened. Names without a known extension are
/// ignored.
pub fn check(device: &Device, opened_as: &str, findings: &mut Findings) {
    let Some(stated) = device.file_info.as_ref().and_then(|info| info.file_name.as_deref()) else { return };
    let (actual, stated) = (base_name(opened_as), base_name(stated));
    if stated.is_empty() || Format::from_name(actual).is_none() || same(actual, stated) {
        return;
    }
    let place = Place::of(Part::FileInfo).field(Field::FileName);
    let message = say!("the file is called `{}`, not `{}`", actual, stated);
    let title = say!("write `{}`", Argument::setting(Field::FileName, actual));
    let fix = Fix::risky(title.clone()).set(place.clone(), actual);
    findings.push(Diagnostic::new(&FILE_NAME, place, message).help(title).fix(fix));
}

/// The name after the last `/` or `\`, because files are exchanged between systems.
fn base_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path).trim()
}

fn same(a: &str, b: &str) -> bool {
    a.eq_ignore_ascii_case(b) || a.to_lowercase() == b.to_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::FileInfo;

    fn messages(opened_as: &str, stated: &str) -> Vec<String> {
        let file_info = FileInfo { file_name: Some(stated.to_owned()), ..FileInfo::default() };
        let device = Device { file_info: Some(file_info), ..Device::default() };
        let mut findings = Findings::new();
        check(&device, opened_as, &mut findings);
        findings.iter().map(|finding| finding.message.to_string()).collect()
    }

    #[test]
    fn only_the_name_itself_counts() {
        assert_eq!(messages("vendor/DRIVE.EDS", r"C:\eds\drive.eds"), [""; 0]);
        assert_eq!(
            messages("a/drive2.eds", "drive.eds"),
            ["the file is called `drive2.eds`, not `drive.eds`"]
        );
    }

    #[test]
    fn what_has_no_file_name_is_not_compared() {
        assert_eq!(messages("<stdin>", "drive.eds"), [""; 0]);
        assert_eq!(messages("drive.eds", ""), [""; 0]);
    }
}
