//! Names that are an attack on the code that is made of them.

use objdict::model::Device;

/// One after the other; all that a name may be in a file.
const NAMES: [&str; 12] = [
    "x */ } \"); system(\"id\"); // \u{202E} ??/ \\",
    "#error `\n\"\"\"\n]]\n'''",
    "default",
    "Self",
    "NULL",
    "od_read",
    "",
    "4711",
    "_",
    "OD_ENTRY_H1000",
    "\u{901F}\u{5EA6}",
    "\\u0041 %s {{ x }} \0",
];

/// Gives every object and entry one of the names, and the device too.
pub(super) fn rename(device: &mut Device) {
    let mut names = NAMES.iter().cycle().map(|&name| name.into());
    let mut next = || names.next().unwrap_or_default();
    for object in device.objects.values_mut() {
        object.main.name = next();
        object.subs.iter_mut().for_each(|(_, entry)| entry.name = next());
    }
}
