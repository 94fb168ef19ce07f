//! The comments of a text, at any position.

use super::markup::Markup;
use crate::source::Span;

/// The comments of a text in order, from `<!--` to `-->`. Similar text in a CDATA section, a processing
/// instruction or an attribute value is not a comment.
pub fn comments(text: &str) -> impl Iterator<Item = Span> {
    let bytes = text.as_bytes();
    let mut at = 0;
    std::iter::from_fn(move || {
        while let Some(start) = memchr::memchr(b'<', bytes.get(at..)?).map(|length| at + length) {
            let rest = &bytes[start..];
            let markup = Markup::at(rest);
            let length = match markup {
                Some(markup) => markup.length(rest).unwrap_or(rest.len()),
                None => tag_length(rest),
            };
            at = start + length;
            if markup == Some(Markup::Comment) {
                return Some(Span::new(start as u32, at as u32));
            }
        }
        None
    })
}

/// The length of a tag, including `>` in quoted values; of a document type declaration, up to the internal
/// subset.
fn tag_length(tag: &[u8]) -> usize {
    let mut quote = None;
    for (length, &byte) in tag.iter().enumerate().skip(1) {
        match (quote, byte) {
            (None, b'>') => return length + 1,
            // unclosed, or an internal subset, which can contain comments
            (None, b'<') => return length,
            (None, b'"' | b'\'') => quote = Some(byte),
            (Some(open), byte) if byte == open => quote = None,
            _ => {}
        }
    }
    tag.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_are_told_from_what_looks_like_them() {
        let text = "<?x <!--0--> ?><!--1--><a b='<!--0-->'><![CDATA[<!--0-->]]><!----></a><!-->--><!--2";
        let found: Vec<&str> = comments(text).map(|span| span.of(text)).collect();
        assert_eq!(found, ["<!--1-->", "<!---->", "<!-->-->", "<!--2"]);
        assert_eq!(comments("").count(), 0);
        assert_eq!(comments("<").count(), 0);
        assert_eq!(comments("<a b='").count(), 0);
    }
}
