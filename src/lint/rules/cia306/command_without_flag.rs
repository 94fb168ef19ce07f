use crate::diagnostic::{Diagnostic, Findings};
use crate::lint::{rule, stated};
use crate::model::{Access, Device, Entry, Field, Object, Place};

rule! {
    /// writing a command, and no flag keeps tools from it
    ///
    /// ## What it checks
    /// Whether the writable entries of objects that do something when they are written (1010h store, 1011h restore, 1023h command, 1F25h, 1F50h and 1F51h program download) have bit 0 of `ObjFlags`, or the object as a whole has it.
    ///
    /// ## Why it matters
    /// A tool that downloads a configuration writes every entry that has a value. With the flag it leaves those out that would store, restore or erase something.
    ///
    /// ## Example
    /// `[1010sub1]` without `ObjFlags=0x1`
    ///
    /// ## How to mend
    /// Write `ObjFlags=0x1` into the writable sub-indexes.
    ///
    /// ## Source
    /// CiA 306-1 §4.6.3.3
    "cia306/command-without-flag", Note, Object(check)
}

fn check(_: &Device, index: u16, object: &Object, findings: &mut Findings) {
    let command = match index {
        0x1010 => "stores parameters",
        0x1011 => "restores default parameters",
        0x1023 => "executes a command",
        0x1F25 => "tells a node to update its configuration",
        0x1F50 | 0x1F51 => "loads or starts a program",
        _ => return,
    };
    if object.orphan
        || object.main.flags().refuses_write()
        || stated::is_misfit(&object.main, &Field::ObjFlags)
    {
        return;
    }
    let Some(place) = unguarded(index, object) else { return };
    let message = format!("writing {index:04X}h {command}, but no flag keeps a tool from it");
    let finding = Diagnostic::new(&RULE.info, place, message);
    findings.push(finding.help("write `ObjFlags=0x1` into its writable entries"));
}

/// The first entry that can be written and has no flag.
fn unguarded(index: u16, object: &Object) -> Option<Place> {
    let is_unguarded = |entry: &Entry| {
        entry.access.is_some_and(Access::is_writable)
            && !entry.flags().refuses_write()
            && !stated::is_misfit(entry, &Field::ObjFlags)
    };
    let sub = object.subs.iter().find(|&(sub, entry)| sub > 0 && is_unguarded(entry));
    match sub {
        Some((sub, _)) => Some(Place::entry(index, sub)),
        None => is_unguarded(&object.main).then(|| Place::object(index)),
    }
}
