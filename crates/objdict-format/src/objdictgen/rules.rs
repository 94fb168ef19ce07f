//! The rules about projects of objdictgen.

use objdict_model::diagnostic::text_rules;

text_rules! {
    source: "CanFestival 3, objdictgen";

    "objdictgen/not-read" = NOT_READ, Warning;
    summary: "a part of the project cannot be read",
    checks: "Whether each part of a project of objdictgen has the form that objdictgen writes: a number, a text, a list or a map where it has one, at most 254 values in a list, names of at most 241 characters.",
    why: "The part is left out of everything that is made of the project.",
    example: "`<val type=\"complex\" value=\"1j\" />` as the value of an object",
    remedy: "Open the project with objdictedit, correct the object and save it.",

    "objdictgen/unknown-object" = UNKNOWN_OBJECT, Warning;
    summary: "no part of the project describes an object",
    checks: "Whether the project describes each object that it has a value for: in the map of the user, in that of its profile or of CiA 302, or in that of CiA 301, which objdictgen has itself.",
    why: "Its name, type and access are not known, so it is left out. objdictgen stops with an exception.",
    example: "a value for 2004h in `Dictionary`, and no 2004h in `UserMapping`",
    remedy: "Open the project with objdictedit and add the object anew.",
}
