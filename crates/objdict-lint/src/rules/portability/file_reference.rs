use crate::diagnostic::{Diagnostic, Findings};
use crate::model::{Device, Entry, Field};
use crate::{rule, stated, with_others};

rule! {
    "portability/file-reference", Note, Device(check);
    summary: "a tool ignores the file of a DOMAIN",
    checks: "Whether an entry of a DCF has an `UploadFile` or a `DownloadFile`. The first one is shown with the others.",
    why: "python-canopen and CANopenEditor neither load the file nor write its name back.",
    example: "`DownloadFile=firmware.bin`",
    remedy: "Load the file in the application, or use a tool that supports it.",
    source: "python-canopen 2.4.1, CANopenEditor of 2026",
}

fn check(device: &Device, findings: &mut Findings) {
    let mut places = stated::entries(device).filter_map(|(place, entry)| Some(place.field(field_of(entry)?)));
    let Some(first) = places.next() else { return };
    let finding = Diagnostic::new(&RULE.info, first, "not all tools load the file of this entry")
        .help("load the file in the application");
    findings.push(with_others(finding, places.map(|place| (place, "another one"))));
}

fn field_of(entry: &Entry) -> Option<Field> {
    let configured = entry.configured.as_ref()?;
    let stated = [
        (Field::DownloadFile, configured.download_file.is_some()),
        (Field::UploadFile, configured.upload_file.is_some()),
    ];
    stated.into_iter().find(|(_, stated)| *stated).map(|(field, _)| field)
}
