// Generated from templates/c/_meanings.h by `cargo xtask templates`; do not edit.

#[allow(clippy::all, clippy::pedantic, reason = "generated")]
impl MeaningMacros<'_> {
    pub(super) fn text(&self) -> String {
        let mut out = String::new();
        if !self.enums.is_empty() {
            out.push_str("/* Named values of entries. With ..._MASK, the value is that of these bits; any others are possible. */");
            for view in &self.enums {
                put!(out, "

/** {}: {} */", crate::escape::doxygen(&view.of.title), self::entries(&view.of.entries));
                for value in &view.values {
                    put!(out, "
#define {}_{} {} /**< {} */", self.upper, value.name.to_string().to_uppercase(), value.number, crate::escape::doxygen(&value.label));
                }
            }
            if !self.words.is_empty() {
                out.push_str("

");
            }
        }
        if !self.words.is_empty() {
            out.push_str("/* Bit fields of entries: ..._GET(word) extracts the value, ..._WITH(word, value) returns the word with a new value, of which
   only the lowest bits are used. */");
            for view in &self.words {
                put!(out, "

/** {}: {} */", crate::escape::doxygen(&view.of.title), self::entries(&view.of.entries));
                for part in &view.parts {
                    put!(out, "
#define {}_SHIFT {}u /**< {} */
#define {}_BITS {}u
#define {}_MASK {}
#define {}_GET(word) {}
#define {}_WITH(word, value) {}", part.name, part.of.first, crate::escape::doxygen(&part.of.label), part.name, part.of.bits, part.name, part.mask, part.name, part.get, part.name, part.with);
                }
            }
        }
        out
    }
}
