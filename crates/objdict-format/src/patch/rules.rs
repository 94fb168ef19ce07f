//! The rules about patches.

use objdict_model::diagnostic::text_rules;

text_rules! {
    source: "objdict, docs/patches.md";

    "patch/invalid-change" = INVALID_CHANGE, Error;
    summary: "a change that cannot be made",
    checks: "Whether each change says what it is about and what becomes of it: `at` is an address or `file`, `device`, `commissioning`; there is something to set, add, remove or rename; each value is valid for its field and its data type.",
    why: "The change is not made, so the description keeps its mistake.",
    example: "`at = \"20011:3\"`, `set = { default = 300 }` for an UNSIGNED8",
    remedy: "Correct the change.",

    "patch/expect-not-met" = EXPECT_NOT_MET, Error;
    summary: "the file does not say what a patch expects",
    checks: "Whether the file says what `expect` states, does not state the fields of `absent`, and has the objects and entries that are changed.",
    why: "The vendor changed the file, or it is another one. The correction may be wrong there, or no longer needed.",
    example: "`expect = { type = \"u8\" }` where the file says UNSIGNED16",
    remedy: "Compare the patch with the new file, and correct `expect` or remove the change.",

    "patch/no-effect" = NO_EFFECT, Warning;
    summary: "a change without effect",
    checks: "Whether each change changes the description.",
    why: "The vendor corrected the file; the change is no longer needed.",
    example: "`set = { type = \"u16\" }` where the file says UNSIGNED16",
    remedy: "Remove the change, or limit the patch to the revisions that need it with `revision`.",

    "patch/other-file" = OTHER_FILE, Error;
    summary: "the file has another hash than the patch states",
    checks: "Whether the bytes of the file have the hash `sha256` of the patch, if it states one.",
    why: "The patch was made for another edition of the file.",
    example: "a new edition of the vendor with the same revision number",
    remedy: "Check the changes with the new file, and then correct or remove `sha256`.",
}
