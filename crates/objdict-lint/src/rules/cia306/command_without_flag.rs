use crate::diagnostic::{Diagnostic, Findings, Fix, say};
use crate::model::{Access, Device, Entry, Field, Object, Place};
use crate::{rule, stated};

rule! {
    "cia306/command-without-flag", Note, Object(check), fix Unsafe;
    summary: "`ObjFlags` does not stop tools from writing a command",
    checks: "Whether the writable entries of command objects (1010h store, 1011h restore, 1023h command, 1F25h, 1F50h and 1F51h program download) have bit 0 of `ObjFlags`, in the entry or in the object. Few real files set the flag: nearly half of them describe 1010h or 1011h, none with the flag. The finding is a note because tools that check the signature (`save`, `load`) before they write are safe without the flag.",
    why: "A tool that downloads a configuration writes every entry that has a value. The flag excludes entries that would store, restore or erase something.",
    example: "`[1010sub1]` without `ObjFlags=0x1`",
    remedy: "Write `ObjFlags=0x1` in the writable sub-indexes.",
    source: "CiA 306-1 §4.6.3.3",
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let command = match index {
        0x1010 => "stores parameters",
        0x1011 => "restores default parameters",
        0x1023 => "executes a command",
        0x1F25 => "makes a node update its configuration",
        0x1F50 | 0x1F51 => "loads or starts a program",
        _ => return,
    };
    if object.orphan
        || object.main.flags().refuses_write()
        || stated::is_invalid(&object.main, &Field::ObjFlags)
    {
        return;
    }
    let places = unguarded(index, object);
    let Some((place, _)) = places.first().cloned() else { return };
    let message =
        say!("writing {:04X}h {}, but `{ObjFlags}` does not stop tools from writing it", index, command);
    let finding = Diagnostic::new(&RULE.info, place, message);
    let fix = Fix::risky(say!("write `{ObjFlags=0x1}` in its writable entries"));
    let fix = places
        .into_iter()
        .fold(fix, |fix, (place, flags)| fix.set(place.field(Field::ObjFlags), format!("0x{:X}", flags | 1)));
    findings.push(finding.help(say!("write `{ObjFlags=0x1}` in its writable entries")).fix(fix));
}

/// The writable entries without the flag, with their current flags.
fn unguarded(index: u16, object: &Object) -> Vec<(Place, u32)> {
    let is_unguarded = |entry: &Entry| {
        entry.access.is_some_and(Access::is_writable)
            && !entry.flags().refuses_write()
            && !stated::is_invalid(entry, &Field::ObjFlags)
    };
    let subs = object.subs.iter().filter(|&(sub, entry)| sub > 0 && is_unguarded(entry));
    let places: Vec<_> = subs.map(|(sub, entry)| (Place::entry(index, sub), entry.flags().0)).collect();
    if places.is_empty() && is_unguarded(&object.main) {
        return vec![(Place::object(index), object.main.flags().0)];
    }
    places
}
