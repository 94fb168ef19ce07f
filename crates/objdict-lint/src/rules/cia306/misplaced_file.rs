use crate::diagnostic::{Diagnostic, Findings, say};
use crate::model::{Access, DataType, Field, ObjectType};
use crate::{EntryAt, rule};

rule! {
    "cia306/misplaced-file", Error, Entry(check);
    summary: "a file is given for an entry without file transfer",
    checks: "Whether `UploadFile` and `DownloadFile` belong to a DOMAIN, whether only one of them is given, and whether `UploadFile` belongs to a readable and `DownloadFile` to a writable DOMAIN.",
    why: "The file holds the data of a DOMAIN. For other entries, or in the wrong direction, tools do not transfer the file.",
    example: "`DownloadFile=program.bin` of an UNSIGNED32",
    remedy: "Remove the key and write `ParameterValue`, or correct the object type or access.",
    source: "CiA 306-1 §5.3.1",
}

fn check(at: &EntryAt<'_>, findings: &mut Findings) {
    let Some(configured) = &at.entry.configured else { return };
    let field = match (&configured.upload_file, &configured.download_file) {
        (None, None) => return,
        (Some(_), None) => Field::UploadFile,
        (_, Some(_)) => Field::DownloadFile,
    };
    let entry = at.entry;
    let is_domain =
        entry.object_type == Some(ObjectType::Domain) || entry.data_type == Some(DataType::DOMAIN);
    let access = entry.access;
    let (message, help) = if !is_domain {
        let what = entry.data_type.map_or("not a DOMAIN".into(), |data_type| say!("{}", data_type));
        (
            say!("`{}` is for a DOMAIN, but the entry is {}", field, what),
            say!("remove {the key} and write `{ParameterValue}`"),
        )
    } else if configured.upload_file.is_some() && configured.download_file.is_some() {
        (say!("the entry has both `{UploadFile}` and `{DownloadFile}`"), "remove one of the two".into())
    } else if field == Field::UploadFile && access == Some(Access::Wo) {
        (
            say!("`{UploadFile}` is for readable data, but the entry is `wo`"),
            say!("remove {the key}, or correct `{AccessType}`"),
        )
    } else if field == Field::DownloadFile && access.is_some_and(|access| !access.is_writable()) {
        (
            say!("`{DownloadFile}` is for writable data, but the entry is not writable"),
            say!("remove {the key}, or correct `{AccessType}`"),
        )
    } else {
        return;
    };
    findings.push(Diagnostic::new(&RULE.info, at.field(field), message).help(help));
}
