//! The languages of the documentation that objdict generates.

/// A language of headings and sentences. Texts of a description may be in any other language; see
/// [`Labels::name_in`](crate::model::Labels::name_in).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// Both languages.
    pub const ALL: [Self; 2] = [Self::English, Self::German];

    /// The language of a tag such as `de` or `de-AT` (RFC 5646), if objdict supports it.
    pub fn of_tag(tag: &str) -> Option<Self> {
        let primary = tag.split(['-', '_']).next().unwrap_or_default();
        Self::ALL.into_iter().find(|language| language.tag().eq_ignore_ascii_case(primary))
    }

    /// `en` or `de`.
    pub const fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
        }
    }

    /// Selects the text in this language.
    pub const fn pick<'a>(self, english: &'a str, german: &'a str) -> &'a str {
        match self {
            Self::English => english,
            Self::German => german,
        }
    }
}

crate::messages! { Language: { language => "{}", language.tag(); } }

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn varieties_of_a_language_are_it() {
        let found = ["en", "DE", "de-AT", "en_GB", "fr", ""].map(Language::of_tag);
        let (english, german) = (Some(Language::English), Some(Language::German));
        assert_eq!(found, [english, german, german, english, None, None]);
    }
}
