//! Texts for users, in several languages (CiA 311, `g_labels`).

/// The names and descriptions of a part of the profile, in file order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(transparent))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Labels(pub Vec<Label>);

/// A name or description, or a reference to one.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case", deny_unknown_fields))]
pub enum Label {
    /// `label`: a name in one language.
    Name {
        /// The language, such as `en` or `de-ch` (RFC 5646).
        lang: Box<str>,
        /// The name.
        text: Box<str>,
    },
    /// `description`: a text in one language.
    Description {
        /// The language.
        lang: Box<str>,
        /// The text; may have several lines.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "super::is_default"))]
        text: Box<str>,
        /// `URI`: where to find more.
        #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
        uri: Option<Box<str>>,
    },
    /// `labelRef`: a name in a text resource.
    NameRef(TextRef),
    /// `descriptionRef`: a text in a text resource.
    DescriptionRef(TextRef),
}

use super::part::part;

part! {
    /// A text in a text resource file (CiA 311, `dictionaryList`).
    pub struct TextRef {
        /// `dictID`: the dictionary.
        always() pub dictionary: Box<str>,
        /// `textID`: the text in it.
        always() pub text_id: Box<str>,
        /// The content of the element: usually empty, or a URI.
        pub uri: Box<str>,
    }
}

/// The language of texts in formats that do not state one.
pub const LANGUAGE: &str = "en";

impl Labels {
    /// Whether there are no labels.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// A single name.
    pub fn name(lang: &str, text: &str) -> Self {
        Self(vec![Label::Name { lang: lang.into(), text: text.into() }])
    }

    /// A single description.
    pub fn description(lang: &str, text: &str) -> Self {
        Self(vec![Label::Description { lang: lang.into(), text: text.into(), uri: None }])
    }

    /// All names with their languages.
    pub fn names(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().filter_map(|label| match label {
            Label::Name { lang, text } => Some((lang.as_ref(), text.as_ref())),
            _ => None,
        })
    }

    /// All descriptions with their languages.
    pub fn descriptions(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().filter_map(|label| match label {
            Label::Description { lang, text, .. } => Some((lang.as_ref(), text.as_ref())),
            _ => None,
        })
    }

    /// The name in `lang`; otherwise in a variant of it (`en-us` for `en`), in English, or the first
    /// one.
    pub fn name_in(&self, lang: &str) -> Option<&str> {
        best(self.names(), lang)
    }

    /// The description in a language, selected like [`name_in`](Self::name_in).
    pub fn description_in(&self, lang: &str) -> Option<&str> {
        best(self.descriptions(), lang)
    }
}

fn best<'a>(texts: impl Iterator<Item = (&'a str, &'a str)>, lang: &str) -> Option<&'a str> {
    let closeness = |tag: &str| {
        let is = |wanted: &str| tag.eq_ignore_ascii_case(wanted);
        let primary = tag.split('-').next().unwrap_or_default();
        match () {
            () if is(lang) => 3,
            () if primary.eq_ignore_ascii_case(lang.split('-').next().unwrap_or_default()) => 2,
            () if primary.eq_ignore_ascii_case("en") => 1,
            () => 0,
        }
    };
    // `max_by_key` would return the last of several equal names
    texts
        .reduce(|best, next| if closeness(next.0) > closeness(best.0) { next } else { best })
        .map(|(_, text)| text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_language_is_taken() {
        let name = |lang: &str, text: &str| Label::Name { lang: lang.into(), text: text.into() };
        let labels = Labels(vec![name("de", "Drehzahl"), name("en-us", "Speed"), name("en", "Velocity")]);
        assert_eq!(labels.name_in("en"), Some("Velocity"));
        assert_eq!(labels.name_in("en-gb"), Some("Speed"));
        assert_eq!(labels.name_in("de-ch"), Some("Drehzahl"));
        assert_eq!(labels.name_in("fr"), Some("Speed"));
        assert_eq!(Labels::default().name_in("en"), None);
    }
}
