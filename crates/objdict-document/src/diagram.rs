//! PDO frame diagrams: one row per byte with bit 7 on the left, as in data sheets.

use super::anchor::Anchor;
use super::layout::{BitSpan, FieldKind, FrameLayout, LayoutField};
use crate::Language;

/// Left edge of the bits; byte numbers are to the left, bit numbers above.
const LEFT: u32 = 22;
const TOP: u32 = 16;

/// Width of a bit.
const WIDTH: u32 = 62;
const HEIGHT: u32 = 30;

/// Right edge of the bits.
const RIGHT: u32 = LEFT + 8 * WIDTH;

/// Font sizes; keep in sync with `_communication.css`.
const NAME_SIZE: f64 = 11.5;
const PLACE_SIZE: f64 = 8.5;

/// Number of colours used in turn. Not a divisor of 8, so vertically adjacent fields have different colours.
const HUES: usize = 6;

/// A PDO diagram.
pub(crate) struct Diagram {
    /// The layout as text.
    pub(crate) label: String,
    pub(crate) shapes: Vec<DiagramField>,
    /// The unused bits of the last byte.
    pub(crate) rest: Option<Rest>,
    /// Depends on the length of the PDO.
    pub(crate) height: u32,
}

/// The unused bits of a frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Rest {
    /// Their outline.
    pub(crate) path: String,
    /// Position of the label, if it fits.
    pub(crate) place: Option<(u32, u32)>,
}

/// A field in the diagram.
pub(crate) struct DiagramField {
    /// Its outline.
    pub(crate) path: String,
    /// `f0` to `f5`, `dummy`, `missing`.
    pub(crate) class: String,
    /// The mapped entry.
    pub(crate) anchor: Option<Anchor>,
    /// The complete text of the tooltip.
    pub(crate) title: String,
    pub(crate) texts: Vec<DiagramText>,
}

/// The part common to all diagrams: byte and bit numbers, and marks between the bits.
pub(crate) struct Grid {
    pub(crate) numbers: Vec<DiagramText>,
    /// Lines over the full height; CSS decides where they are visible.
    pub(crate) lines: String,
}

impl Grid {
    pub(crate) fn new() -> Self {
        let number = |x, y, number: u32| DiagramText { x, y, is_place: false, text: number.to_string() };
        let bits = (0..8).map(|bit| number(LEFT + (7 - bit) * WIDTH + WIDTH / 2, TOP - 5, bit));
        let bytes = (0..8).map(|byte| number(LEFT / 2, top(byte) + HEIGHT / 2 + 4, byte));
        let bottom = top(8);
        let line = |bit| match LEFT + bit * WIDTH {
            // names are here
            x if bit == 4 => format!("M{x} {TOP}v3M{x} {bottom}v-3"),
            x => format!("M{x} {TOP}V{bottom}"),
        };
        let lines = (1..8).map(line);
        Self { numbers: bits.chain(bytes).collect(), lines: lines.collect() }
    }
}

/// Centred text in the diagram.
pub(crate) struct DiagramText {
    pub(crate) x: u32,
    pub(crate) y: u32,
    /// Whether it is an index and a sub-index, in small letters.
    pub(crate) is_place: bool,
    pub(crate) text: String,
}

impl Diagram {
    /// The diagram of a layout; `None` if it is empty.
    pub(crate) fn new(title: &str, layout: &FrameLayout, language: Language) -> Option<Self> {
        let mut shapes = Vec::new();
        for (hue, (field, span)) in layout.shown().enumerate() {
            let class = match field.kind {
                FieldKind::Dummy | FieldKind::Gap => "dummy".to_owned(),
                FieldKind::Missing => "missing".to_owned(),
                FieldKind::Object => format!("f{}", hue % HUES),
            };
            shapes.push(DiagramField {
                path: outline(span),
                class,
                anchor: field.anchor(),
                title: in_words(field, span, language),
                texts: texts(field, span),
            });
        }
        if shapes.is_empty() {
            return None;
        }
        let mut label = format!("{title}: ");
        for (at, (field, span)) in layout.shown().enumerate() {
            label += if at == 0 { "" } else { "; " };
            label += &format!("{} {}", span, name(field));
        }
        Some(Self { label, shapes, rest: rest(layout), height: top(layout.bytes()) + 2 })
    }
}

/// The unused bits; unknown if a mapped object is unknown.
fn rest(layout: &FrameLayout) -> Option<Rest> {
    let span = layout.rest()?;
    let room = rooms(span).into_iter().next().filter(|_| layout.bits().is_some());
    let place = |room: TextBox| (room.left.midpoint(room.right), room.top.midpoint(room.bottom) + 4);
    Some(Rest { path: outline(span), place: room.map(place) })
}

/// The label of a field.
fn name(field: &LayoutField) -> String {
    match (field.kind, field.object) {
        (FieldKind::Object, _) if !field.name.is_empty() => field.name.clone(),
        (FieldKind::Dummy, _) => field.data_type.map(|data_type| data_type.to_string()).unwrap_or_default(),
        (_, Some(object)) => Anchor::entry(object.index, object.sub).spoken(),
        (_, None) => "?".to_owned(),
    }
}

fn in_words(field: &LayoutField, span: BitSpan, language: Language) -> String {
    let mut words = vec![name(field)];
    match field.kind {
        FieldKind::Object => {
            words.extend(field.anchor().map(Anchor::spoken));
            words.extend(field.data_type.map(|data_type| data_type.to_string()));
        }
        FieldKind::Dummy => words.push("Dummy".to_owned()),
        FieldKind::Missing | FieldKind::Gap => {
            words.push(language.pick("not in the description", "nicht in der Beschreibung").to_owned());
        }
    }
    let unit = if field.bits == 1 { language.pick("bit", "Bit") } else { language.pick("bits", "Bit") };
    words.push(format!("{} {unit}", field.bits));
    words.push(span.to_string());
    words.join(" · ")
}

/// The left and right edge of bits; the highest bit is the leftmost.
const fn edges(low: u32, end: u32) -> (u32, u32) {
    (LEFT + (8 - end) * WIDTH, LEFT + (8 - low) * WIDTH)
}

const fn top(byte: u32) -> u32 {
    TOP + byte * HEIGHT
}

/// The outline of bits: one shape over all rows, or two if the parts in two rows do not touch.
fn outline(span: BitSpan) -> String {
    let rows: Vec<(u32, u32, u32)> = span.rows().collect();
    let (Some(&(first, low, _)), Some(&(last, _, end))) = (rows.first(), rows.last()) else {
        return String::new();
    };
    // the first byte contains the bits from `low` on, the last one those below `end`
    let (_, right) = edges(low, 8);
    let (left, _) = edges(0, end);
    let (y, bottom) = (top(first), top(last + 1));
    if first == last {
        let (left, right) = edges(low, end);
        return format!("M{left} {y}H{right}V{bottom}H{left}z");
    }
    let (second, before_last) = (top(first + 1), top(last));
    if last == first + 1 && left >= right {
        return format!("M{LEFT} {y}H{right}V{second}H{LEFT}zM{left} {second}H{RIGHT}V{bottom}H{left}z");
    }
    let mut path = format!("M{LEFT} {y}H{right}");
    if right != RIGHT {
        path += &format!("V{second}H{RIGHT}");
    }
    path += &format!("V{bottom}H{left}");
    if left != LEFT {
        path += &format!("V{before_last}H{LEFT}");
    }
    path + "z"
}

/// A rectangle for a text.
#[derive(Clone, Copy)]
struct TextBox {
    left: u32,
    right: u32,
    top: u32,
    bottom: u32,
}

/// The texts of a field: its name and, if it fits, its index and sub-index.
fn texts(field: &LayoutField, span: BitSpan) -> Vec<DiagramText> {
    rooms(span).into_iter().flat_map(|room| texts_in(field, room)).collect()
}

/// Rectangles for the texts of a field: its full rows, otherwise its longest part; both parts if they
/// do not touch.
fn rooms(span: BitSpan) -> Vec<TextBox> {
    let room = |(byte, low, end): (u32, u32, u32)| {
        let (left, right) = edges(low, end);
        TextBox { left, right, top: top(byte), bottom: top(byte + 1) }
    };
    let rows: Vec<(u32, u32, u32)> = span.rows().collect();
    let whole = rows.iter().filter(|(_, low, end)| end - low == 8).map(|&row| room(row));
    if let Some(room) = whole.reduce(|all, room| TextBox { bottom: room.bottom, ..all }) {
        return vec![room];
    }
    let rooms: Vec<TextBox> = rows.into_iter().map(room).collect();
    match rooms.as_slice() {
        [first, second] if second.left < first.right => {
            let longest = if first.right - first.left > second.right - second.left { first } else { second };
            vec![*longest]
        }
        _ => rooms,
    }
}

fn texts_in(field: &LayoutField, room: TextBox) -> Vec<DiagramText> {
    let width = f64::from(room.right - room.left) - 5.0;
    let (x, middle) = (room.left.midpoint(room.right), room.top.midpoint(room.bottom));
    let text = |y, text| DiagramText { x, y, is_place: false, text };
    let name = name(field);
    let place = field.object.filter(|_| field.kind == FieldKind::Object).map(|object| {
        let place = Anchor::entry(object.index, object.sub).spoken();
        fit(&place, width, PLACE_SIZE)
    });
    let lines = wrap(&name, width, NAME_SIZE);
    let is_high = room.bottom - room.top > HEIGHT;
    let y_of_place = |y| place.clone().map(|text| DiagramText { x, y, is_place: true, text });
    match (lines, place.is_some()) {
        (Some((first, Some(second))), _) => {
            let (above, below) = if is_high { (middle - 8, middle + 5) } else { (middle - 3, middle + 10) };
            let mut texts = vec![text(above, first), text(below, second)];
            texts.extend(y_of_place(middle + 17).filter(|_| is_high));
            texts
        }
        (Some((line, None)), false) => vec![text(middle + 4, line)],
        (lines, _) => {
            let line = lines.map_or_else(|| fit(&name, width, NAME_SIZE), |(line, _)| line);
            let y = if place.is_some() { middle - 1 } else { middle + 4 };
            std::iter::once(text(y, line)).chain(y_of_place(middle + 9)).collect()
        }
    }
}

/// The width of a text in a sans-serif font, rounded up.
fn width(text: &str, size: f64) -> f64 {
    text.chars().map(of).sum::<f64>() * size
}

/// The width of a character relative to the font size.
fn of(character: char) -> f64 {
    match character {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '|' | '!' | '\'' | '`' => 0.29,
        ' ' | 'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '/' | '\\' | '-' | '"' => 0.39,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | '…' => 0.93,
        'A'..='Z' | '&' | '+' | '=' | '<' | '>' | '_' | '#' | '~' => 0.70,
        '\u{0}'..='\u{2FF}' => 0.58,
        // Greek, Cyrillic and similar; then full-width characters
        '\u{300}'..='\u{10FF}' => 0.66,
        _ => 1.05,
    }
}

/// Shortens a text with an ellipsis in the middle if it is too long, because names of a series differ at
/// the end.
pub(super) fn fit(text: &str, room: f64, size: f64) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let characters: Vec<char> = text.chars().collect();
    let mut left = room - width("…", size);
    let (mut head, mut tail) = (0, 0);
    while head + tail < characters.len() {
        // two characters of the start for each one of the end
        let is_tail = head > 2 * tail;
        let next = if is_tail { characters[characters.len() - 1 - tail] } else { characters[head] };
        left -= of(next) * size;
        if left < 0.0 {
            break;
        }
        if is_tail { tail += 1 } else { head += 1 }
    }
    // drop a partial word at the start of the tail
    let end = &characters[characters.len() - tail..];
    let end = end.iter().position(|&character| character == ' ').map_or(end, |space| &end[space + 1..]);
    let text = |part: &[char]| part.iter().collect::<String>();
    format!("{}…{}", text(&characters[..head]).trim_end(), text(end))
}

/// Breaks the text between words into one or two lines; `None` if they do not suffice.
pub(super) fn wrap(text: &str, room: f64, size: f64) -> Option<(String, Option<String>)> {
    if width(text, size) <= room {
        return Some((text.to_owned(), None));
    }
    let breaks = text.match_indices([' ', '_', '-']).map(|(at, mark)| {
        let (first, second) = text.split_at(at + mark.len());
        (first.trim_end(), second)
    });
    let longest = |(first, second): &(&str, &str)| width(first, size).max(width(second, size));
    let best = breaks.min_by(|a, b| longest(a).total_cmp(&longest(b)))?;
    (longest(&best) <= room).then(|| (best.0.to_owned(), Some(best.1.to_owned())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(start: u32, end: u32) -> String {
        super::outline(BitSpan { start, end })
    }

    #[test]
    fn outlines_follow_the_bits() {
        assert_eq!(outline(0, 1), "M456 16H518V46H456z");
        assert_eq!(outline(7, 8), "M22 16H84V46H22z");
        assert_eq!(outline(0, 8), "M22 16H518V46H22z");
        assert_eq!(outline(0, 64), "M22 16H518V256H22z");
        // bits 4 to 7, then a whole byte
        assert_eq!(outline(4, 16), "M22 16H270V46H518V76H22z");
        // a whole byte, then bits 0 to 3
        assert_eq!(outline(8, 20), "M22 46H518V106H270V76H22z");
        // bit 6 to bit 1 two bytes later
        assert_eq!(outline(6, 18), "M22 16H146V46H518V106H394V76H22z");
        // bits 6 and 7, then bits 0 and 1: no common edge
        assert_eq!(outline(6, 10), "M22 16H146V46H22zM394 46H518V76H394z");
        // bits 2 to 7, then 0 to 3: common edge
        assert_eq!(outline(2, 12), "M22 16H394V46H518V76H270V46H22z");
    }

    #[test]
    fn names_stand_in_the_room_of_their_field() {
        let count = |start, end| rooms(BitSpan { start, end }).len();
        assert_eq!((count(6, 10), count(2, 12), count(0, 64), count(6, 18)), (2, 1, 1, 1));
        let room = rooms(BitSpan { start: 6, end: 26 })[0];
        assert_eq!((room.left, room.right, room.top, room.bottom), (22, 518, 46, 106));
    }

    /// Twice the area of closed outlines (shoelace formula).
    fn doubled_area(path: &str) -> u32 {
        let area = |part: &str| {
            let mut corners = Vec::new();
            let (mut x, mut y) = (0, 0);
            for (at, _) in part.match_indices(['M', 'H', 'V']) {
                let (letter, rest) = part[at..].split_at(1);
                let number = rest.split(['H', 'V']).next().unwrap();
                match letter {
                    "M" => {
                        let (left, top) = number.split_once(' ').unwrap();
                        (x, y) = (left.parse::<i64>().unwrap(), top.parse().unwrap());
                    }
                    "H" => x = number.parse().unwrap(),
                    _ => y = number.parse().unwrap(),
                }
                corners.push((x, y));
            }
            let next = corners.iter().cycle().skip(1);
            corners.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<i64>()
        };
        // all parts have the same orientation, so areas do not cancel out
        path.split_terminator('z').map(|part| u32::try_from(area(part)).unwrap()).sum()
    }

    #[test]
    fn every_outline_has_the_area_of_its_bits() {
        for start in 0..64 {
            for end in start + 1..=64 {
                let path = outline(start, end);
                assert_eq!(
                    doubled_area(&path),
                    2 * (end - start) * WIDTH * HEIGHT,
                    "{start} to {end}: {path}"
                );
            }
        }
    }

    #[test]
    fn beginning_and_end_are_kept() {
        assert_eq!(fit("Digital input 13", 200.0, 10.0), "Digital input 13");
        assert_eq!(fit("Digital input 13", 60.0, 10.0), "Digital…13");
        assert_eq!(fit("Digital input 13", 0.0, 10.0), "…");
        assert_eq!(fit("", 0.0, 10.0), "");
    }

    #[test]
    fn lines_break_between_words() {
        let wrap = |text| wrap(text, 60.0, 10.0);
        assert_eq!(wrap("Input 1"), Some(("Input 1".into(), None)));
        assert_eq!(wrap("Digital input 13"), Some(("Digital".into(), Some("input 13".into()))));
        assert_eq!(wrap("motor_speed"), Some(("motor_".into(), Some("speed".into()))));
        assert_eq!(wrap("Geschwindigkeitsregelung"), None);
    }
}
