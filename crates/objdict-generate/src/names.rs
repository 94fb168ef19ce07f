//! Identifiers from the names of a description.
//!
//! A name becomes words of lower-case ASCII letters and digits, joined by `_`; constants and macros use the
//! same words in upper case. All languages share the result, so an entry has the same name in each of them.
//! The identifiers of one [`NameScope`] are valid and unique for any names, and the same description always gives
//! the same identifiers.

use std::borrow::Cow;
use std::collections::HashSet;
use std::fmt;
use std::sync::LazyLock;

/// Maximum length of an identifier: C99 compilers need not distinguish longer ones (§5.2.4.1).
pub(crate) const LONGEST: usize = 63;

/// Maximum length of an identifier from one name, before names are joined.
const LONGEST_PART: usize = 48;

/// Keywords of Rust 2015 to 2024, primitive types, standard crates, and the tools that attributes name.
const RUST: &str = "
    abstract alloc as async await become bool box break char clippy const continue core crate do dyn else enum
    extern f128 f16 f32 f64 false final fn for gen i128 i16 i32 i64 i8 if impl in isize let loop macro
    match mod move mut override priv proc_macro pub raw ref return rustfmt safe self static std str struct super
    trait true try type typeof u128 u16 u32 u64 u8 union unsafe unsized use usize virtual where while
    yield
";

/// Keywords of C, and additional ones of compilers and headers for microcontrollers.
const C: &str = "
    alignas alignof asm assert auto case complex constexpr data default double errno far float fortran
    goto huge i386 imaginary inline int interrupt linux long main near noreturn nullptr offsetof pascal
    register restrict short signed sizeof stderr stdin stdout switch thread_local typedef typeof_unqual
    unix unsigned void volatile xdata
";

/// Additional keywords of C++.
const CPP: &str = "
    and and_eq bitand bitor catch class co_await co_return co_yield compl concept const_cast consteval
    constinit decltype delete dynamic_cast explicit export friend import module mutable namespace new
    noexcept not not_eq operator or or_eq private protected public reinterpret_cast requires
    static_assert static_cast template this throw typeid typename using xor xor_eq
";

/// Whether an identifier is reserved: a keyword, or like a type name in C.
fn is_reserved(identifier: &str) -> bool {
    static WORDS: LazyLock<HashSet<&str>> =
        LazyLock::new(|| [RUST, C, CPP].into_iter().flat_map(str::split_ascii_whitespace).collect());
    identifier.ends_with("_t") || WORDS.contains(identifier)
}

/// The words of a name, joined by `_`; empty if the name has no ASCII letter or digit.
///
/// Accents of Latin letters are removed; all other characters that are not letters or digits separate words.
/// A name of one word is also split before capitals, as in `maxSpeed`.
pub(crate) fn words(name: &str) -> String {
    let plain = if name.is_ascii() {
        Cow::Borrowed(name)
    } else {
        Cow::Owned(name.chars().map(without_mark).collect())
    };
    let mut joined = String::with_capacity(LONGEST_PART + 8);
    let mut parts = plain.split(|c: char| !c.is_ascii_alphanumeric()).filter(|part| !part.is_empty());
    let first = parts.next().unwrap_or_default();
    match parts.next() {
        None => push_split(&mut joined, first.as_bytes()),
        Some(second) => {
            joined.push_str(first);
            for part in std::iter::once(second).chain(parts) {
                if joined.len() > LONGEST_PART {
                    break; // the rest would be truncated
                }
                joined.push('_');
                joined.push_str(part);
            }
            joined.make_ascii_lowercase();
        }
    }
    if joined.starts_with(|c: char| c.is_ascii_digit()) {
        joined.insert(0, 'x');
    }
    joined.truncate(clip(&joined, LONGEST_PART).len());
    joined
}

/// Appends a word, split where a capital starts a new one: `maxSpeed`, `CANState`, but neither `PDOs` nor
/// `0x1A00`.
fn push_split(joined: &mut String, word: &[u8]) {
    let lower = |at: usize| word.get(at).is_some_and(u8::is_ascii_lowercase);
    for (at, &byte) in word.iter().enumerate().take(LONGEST_PART + 1) {
        let starts_word = at > 0 && byte.is_ascii_uppercase() && {
            let before = word[at - 1];
            let plural = word.get(at + 1) == Some(&b's') && !lower(at + 2);
            before.is_ascii_lowercase() || (lower(at + 1) && !plural)
        };
        if starts_word {
            joined.push('_');
        }
        joined.push(char::from(byte.to_ascii_lowercase()));
    }
}

/// Removes the accent of a Latin-1 letter; other characters are unchanged.
pub(crate) fn without_mark(c: char) -> char {
    match c {
        'À'..='Å' => 'A',
        'Ç' => 'C',
        'È'..='Ë' => 'E',
        'Ì'..='Ï' => 'I',
        'Ñ' => 'N',
        'Ò'..='Ö' | 'Ø' => 'O',
        'Ù'..='Ü' => 'U',
        'ß' => 's',
        'à'..='å' => 'a',
        'ç' => 'c',
        'è'..='ë' => 'e',
        'ì'..='ï' => 'i',
        'ñ' => 'n',
        'ò'..='ö' | 'ø' => 'o',
        'ù'..='ü' | 'µ' | 'μ' => 'u',
        'ý' | 'ÿ' => 'y',
        other => other,
    }
}

/// The words of an identifier that fit into `length` bytes; a longer first word is truncated.
pub(crate) fn clip(identifier: &str, length: usize) -> &str {
    let Some(rest) = identifier.get(length..) else { return identifier.trim_end_matches('_') };
    let whole = if rest.is_empty() || rest.starts_with('_') { Some(length) } else { None };
    let end = whole.or_else(|| identifier[..length].rfind('_').filter(|&end| end > 0)).unwrap_or(length);
    identifier[..end].trim_end_matches('_')
}

/// A namespace of generated code with the identifiers in use.
#[derive(Default)]
pub(crate) struct NameScope {
    taken: HashSet<String>,
    /// Names that several claims will share; see [`NameScope::foresee`].
    shared: HashSet<String>,
    keywords: bool,
}

impl NameScope {
    /// A namespace for constants and macros with these words in use. No language has upper-case keywords.
    pub(crate) fn of_constants(taken: &str) -> Self {
        Self { taken: taken.split_whitespace().map(str::to_owned).collect(), ..Self::default() }
    }

    /// A namespace for fields and modules, which must also differ from keywords.
    pub(crate) fn of_lower_case(taken: &str) -> Self {
        Self { keywords: true, ..Self::of_constants(taken) }
    }

    /// Releases all identifiers except these.
    pub(crate) fn reset(&mut self, taken: &str) {
        self.taken.clear();
        self.taken.extend(taken.split_whitespace().map(str::to_owned));
    }

    /// Whether an identifier is free.
    pub(crate) fn is_free(&self, identifier: &str) -> bool {
        !self.taken.contains(identifier)
    }

    /// Reserves an identifier.
    pub(crate) fn take(&mut self, identifier: String) {
        self.taken.insert(identifier);
    }

    /// Records the names of all future claims: names that several claims share get a suffix in each, so that names
    /// never depend on the order of the others.
    pub(crate) fn foresee<'a>(&mut self, all: impl IntoIterator<Item = &'a str>) {
        let all = all.into_iter();
        let mut once = HashSet::with_capacity(all.size_hint().0);
        self.shared = all
            .map(|words| clip(words, LONGEST))
            .filter(|words| !once.insert(*words))
            .map(str::to_owned)
            .collect();
    }

    /// Claims an identifier for `words`.
    ///
    /// It is the plain identifier, a keyword with `_` appended; if that is taken or will be claimed again, with
    /// `suffix` (the index and usually the sub-index) appended.
    pub(crate) fn claim(&mut self, words: &str, suffix: fmt::Arguments<'_>) -> String {
        let words = clip(words, LONGEST);
        let is_shared = self.shared.contains(words);
        let mut plain = if words.is_empty() { format!("x{suffix}") } else { words.to_owned() };
        if self.keywords && is_reserved(&plain) {
            plain.push('_');
        }
        if (!is_shared || words.is_empty()) && self.taken.insert(plain.clone()) {
            return plain;
        }
        let mut behind = format!("_{suffix}");
        for number in 2_u32.. {
            let candidate = format!("{}{behind}", clip(&plain, LONGEST - behind.len()));
            if self.taken.insert(candidate.clone()) {
                return candidate;
            }
            behind = format!("_{suffix}_{number}");
        }
        plain // there are fewer entries than numbers
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn names_become_words() {
        for (name, expected) in [
            ("Producer heartbeat time", "producer_heartbeat_time"),
            ("COB-ID SYNC message", "cob_id_sync_message"),
            ("  Vendor--ID!! ", "vendor_id"),
            ("maxSpeed", "max_speed"),
            ("CANState", "can_state"),
            ("CiA 402 profile", "cia_402_profile"),
            ("PDOs", "pdos"),
            ("0x1A00", "x0x1a00"),
            ("2nd axis", "x2nd_axis"),
            ("Größe in µm", "grose_in_um"),
            ("速度", ""),
            ("*/ -- \"", ""),
            ("__init__", "init"),
        ] {
            assert_eq!(words(name), expected, "{name}");
        }
    }

    #[test]
    fn long_names_are_cut_between_words() {
        assert_eq!(words(&"a".repeat(10_000)).len(), LONGEST_PART);
        assert_eq!(words(&"Ab".repeat(10_000)).len(), LONGEST_PART - 1);
        let name = "Maximum number of bytes in the receive buffer of the second interface";
        assert_eq!(words(name), "maximum_number_of_bytes_in_the_receive_buffer_of");
        assert_eq!(words(&format!("{} tail", "b".repeat(LONGEST_PART - 2))), "b".repeat(LONGEST_PART - 2));
        assert_eq!(words(&format!("{} tail", "b".repeat(LONGEST_PART - 1))), "b".repeat(LONGEST_PART - 1));
    }

    #[test]
    fn the_first_keeps_its_name_and_later_ones_say_who_they_are() {
        let mut scope = NameScope::of_lower_case("node_id");
        assert_eq!(scope.claim("speed", format_args!("2000")), "speed");
        assert_eq!(scope.claim("speed", format_args!("2001")), "speed_2001");
        assert_eq!(scope.claim("speed_2001", format_args!("2002")), "speed_2001_2002");
        assert_eq!(scope.claim("speed_2001", format_args!("2002")), "speed_2001_2002_2");
        assert_eq!(scope.claim("node_id", format_args!("2003")), "node_id_2003");
        assert_eq!(scope.claim("", format_args!("2004")), "x2004");
        assert_eq!(scope.claim("type", format_args!("2005")), "type_");
        assert_eq!(scope.claim("type", format_args!("2006")), "type_2006");
        assert_eq!(scope.claim("uint8_t", format_args!("2007")), "uint8_t_");
    }

    #[test]
    fn what_several_claim_is_plain_for_none() {
        let names = |all: [(&str, u16); 3]| {
            let mut scope = NameScope::of_lower_case("");
            scope.foresee(all.map(|(words, _)| words));
            all.map(|(words, index)| scope.claim(words, format_args!("{index:04x}")))
        };
        let in_order = names([("speed", 0x2000), ("gain", 0x2001), ("speed", 0x2002)]);
        assert_eq!(in_order, ["speed_2000", "gain", "speed_2002"]);
        let mut reversed = names([("speed", 0x2002), ("gain", 0x2001), ("speed", 0x2000)]);
        reversed.reverse();
        assert_eq!(in_order, reversed);
    }

    #[test]
    fn constants_may_be_called_like_keywords() {
        assert_eq!(NameScope::of_constants("index").claim("type", format_args!("01")), "type");
        assert_eq!(NameScope::of_constants("index").claim("index", format_args!("01")), "index_01");
    }

    fn is_identifier(text: &str) -> bool {
        let mut bytes = text.bytes();
        let letter = |byte: u8| byte.is_ascii_lowercase();
        bytes.next().is_some_and(letter)
            && bytes.all(|byte| letter(byte) || byte.is_ascii_digit() || byte == b'_')
            && text.len() <= LONGEST
            && !text.contains("__")
    }

    proptest! {
        #[test]
        fn any_names_become_valid_and_unique_identifiers(
            names in proptest::collection::vec(
                prop_oneof![
                    any::<String>(),
                    "[a-c_ ]{0,4}",
                    proptest::sample::select(C.split_whitespace().collect::<Vec<_>>()).prop_map(str::to_owned),
                    "([A-Z][a-z]{0,3}){1,40}",
                    "x?[0-9a-f]{4}(_[0-9]{1,2}){0,2}",
                    "[a-z]{1,3} t",
                ],
                0..60,
            )
        ) {
            let mut scope = NameScope::of_lower_case("");
            let mut seen = HashSet::new();
            for (number, name) in names.iter().enumerate() {
                let identifier = scope.claim(&words(name), format_args!("{:04x}", number / 2));
                prop_assert!(is_identifier(&identifier), "`{}` of `{}`", identifier, name);
                prop_assert!(!is_reserved(&identifier), "`{}`", identifier);
                prop_assert!(seen.insert(identifier.clone()), "`{}` twice", identifier);
            }
        }
    }
}
