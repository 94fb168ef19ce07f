//! Edits links in the text of a `network.toml`.

use super::{NetworkFile, keyed};
use objdict_model::json::quoted;
use objdict_model::source::{Edits, Span};
use objdict_network::LinkEnd;

/// A change of the links of a network. Link ends are spelled as in the file: `left.6000:1`, or the name of a
/// manager without a description.
#[derive(Clone, Copy, Debug)]
pub enum LinkEdit<'a> {
    /// A link more.
    Add {
        /// The end that sends.
        from: &'a str,
        /// The end that receives.
        to: &'a str,
    },
    /// A different end for a link.
    Move {
        /// The position of the link in the network.
        link: usize,
        /// The link end: 0 sends, the others receive.
        end: usize,
        /// The end now.
        to: &'a str,
    },
    /// A link less.
    Remove {
        /// The position of the link in the network.
        link: usize,
    },
}

impl NetworkFile {
    /// The edits that change a link; `None` if that is impossible: only a `network.toml` has links, and a list of
    /// inline tables must be edited by hand.
    pub fn link_edits(&self, edit: LinkEdit<'_>) -> Option<Edits<'_>> {
        let text = self.source.text();
        let network = self.network().filter(|_| keyed::toml::is_toml(text))?;
        let has_headers = network.links.iter().all(|link| self.link_table(link.from.at).is_some());
        let mut edits = Edits::new(&self.source);
        match edit {
            LinkEdit::Add { from, to } => {
                let end = u32::try_from(text.len()).ok()?;
                let newline = if text.contains("\r\n") { "\r\n" } else { "\n" };
                let before = if text.is_empty() || text.ends_with('\n') { "" } else { newline };
                let (from, to) = (quoted(from), quoted(to));
                let table =
                    format!("{before}{newline}[[link]]{newline}from = {from}{newline}to = {to}{newline}");
                edits.replace(Span::empty(end), table);
            }
            LinkEdit::Move { link, end, to } => {
                let link = network.links.get(link)?;
                let ends: Vec<&LinkEnd> = std::iter::once(&link.from).chain(&link.to).collect();
                edits.replace(ends.get(end)?.at, quoted(to));
            }
            LinkEdit::Remove { link } => {
                edits.replace(self.link_table(network.links.get(link)?.from.at)?, "");
            }
        }
        has_headers.then_some(edits)
    }

    /// The lines of the `[[link]]` table that contains this value, with the blank lines after it. Comments
    /// above the next table belong to that one.
    fn link_table(&self, value: Span) -> Option<Span> {
        let text = self.source.text();
        let is_header = |line: &str| line.trim_start().starts_with("[[link]]");
        let before = text.get(..value.start as usize)?;
        let start = before.match_indices('\n').map(|(at, _)| at + 1).chain(Some(0));
        let start = start
            .filter(|&at| text[at..].lines().next().is_some_and(|line| line.trim_start().starts_with('[')))
            .max()?;
        if !text[start..].lines().next().is_some_and(is_header) {
            return None;
        }
        let (mut at, mut end, mut has_end) = (start, start, false);
        for line in text[start..].split_inclusive('\n') {
            let trimmed = line.trim();
            if at > start && trimmed.starts_with('[') {
                break;
            }
            at += line.len();
            match trimmed.is_empty() {
                true if has_end => end = at,
                true => {}
                // comments after the last key are not removed
                false if trimmed.starts_with('#') => has_end = false,
                false => (end, has_end) = (at, true),
            }
        }
        Some(Span::new(u32::try_from(start).ok()?, u32::try_from(end).ok()?))
    }
}
