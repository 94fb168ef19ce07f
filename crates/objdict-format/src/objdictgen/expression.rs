//! The Python expressions in projects: names such as `Receive PDO %d Mapping[(idx)]`, and values such as
//! `{True:"$NODEID+0x%X00"%(base+2),False:0x80000000}[base<4]`. Only expressions that objdictgen writes are
//! supported.

/// Longer texts are not expressions.
const LONGEST: usize = 1000;

/// Brackets in brackets.
const DEEPEST: u8 = 20;

/// The result of an expression.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Evaluated {
    Number(i64),
    Text(String),
    /// A list in parentheses.
    Tuple(Vec<Evaluated>),
    /// Keys and values in braces.
    Map(Vec<(Evaluated, Evaluated)>),
}

/// The value of an expression with these variables; `None` if it is not supported.
pub(super) fn evaluate(text: &str, variables: &[(&str, i64)]) -> Option<Evaluated> {
    if text.len() > LONGEST {
        return None;
    }
    let mut parser = ExpressionParser { rest: text, variables, depth: 0 };
    let result = parser.comparison()?;
    parser.rest.trim_start().is_empty().then_some(result)
}

/// The name of an object or entry: a format if an expression in brackets follows. Text after the brackets is ignored.
pub(super) fn name(text: &str, index: i64, sub: i64) -> String {
    let format = || {
        let (format, arguments) = text.rsplit_once(']')?.0.rsplit_once('[')?;
        formatted(format, evaluate(arguments, &[("idx", index), ("sub", sub)])?)
    };
    format().unwrap_or_else(|| text.to_owned())
}

/// A string with `%d` and `%X` replaced.
fn formatted(format: &str, arguments: Evaluated) -> Option<String> {
    let mut arguments = match arguments {
        Evaluated::Tuple(arguments) => arguments,
        single => vec![single],
    }
    .into_iter();
    let mut parts = format.split('%');
    let mut text = parts.next()?.to_owned();
    while let Some(part) = parts.next() {
        if part.is_empty() {
            text.push('%');
            text.push_str(parts.next()?);
            continue;
        }
        let kind = part.find(|c: char| !c.is_ascii_digit() && c != '.')?;
        let width: usize = part[..kind].rsplit('.').next()?.parse().unwrap_or(0);
        let width = width.min(16);
        let argument = arguments.next()?;
        text += &match (part.as_bytes()[kind], argument) {
            (b'd' | b'i' | b'u', Evaluated::Number(number)) => format!("{number:0width$}"),
            (b'X', Evaluated::Number(number)) => format!("{number:0width$X}"),
            (b'x', Evaluated::Number(number)) => format!("{number:0width$x}"),
            (b's', Evaluated::Number(number)) => number.to_string(),
            (b's', Evaluated::Text(argument)) => argument,
            _ => return None,
        };
        text.push_str(&part[kind + 1..]);
    }
    (arguments.next().is_none() && text.len() <= LONGEST).then_some(text)
}

struct ExpressionParser<'a> {
    rest: &'a str,
    variables: &'a [(&'a str, i64)],
    depth: u8,
}

impl ExpressionParser<'_> {
    fn take(&mut self, sign: char) -> bool {
        let rest = self.rest.trim_start();
        let found = rest.strip_prefix(sign);
        self.rest = found.unwrap_or(rest);
        found.is_some()
    }

    fn comparison(&mut self) -> Option<Evaluated> {
        let left = self.sum()?;
        if !self.take('<') {
            return Some(left);
        }
        match (left, self.sum()?) {
            (Evaluated::Number(left), Evaluated::Number(right)) => {
                Some(Evaluated::Number(i64::from(left < right)))
            }
            _ => None,
        }
    }

    fn sum(&mut self) -> Option<Evaluated> {
        let mut left = self.product()?;
        loop {
            let is_sum = self.take('+');
            if !is_sum && !self.take('-') {
                return Some(left);
            }
            left = match (left, self.product()?) {
                (Evaluated::Number(left), Evaluated::Number(right)) if is_sum => {
                    Evaluated::Number(left.checked_add(right)?)
                }
                (Evaluated::Number(left), Evaluated::Number(right)) => {
                    Evaluated::Number(left.checked_sub(right)?)
                }
                (Evaluated::Text(left), Evaluated::Text(right)) if is_sum => Evaluated::Text(left + &right),
                _ => return None,
            };
        }
    }

    fn product(&mut self) -> Option<Evaluated> {
        let mut left = self.item()?;
        loop {
            let is_product = self.take('*');
            if !is_product && !self.take('%') {
                return Some(left);
            }
            left = match (left, self.item()?) {
                (Evaluated::Number(left), Evaluated::Number(right)) if is_product => {
                    Evaluated::Number(left.checked_mul(right)?)
                }
                (Evaluated::Number(left), Evaluated::Number(right)) => {
                    Evaluated::Number(left.checked_rem_euclid(right)?)
                }
                (Evaluated::Text(format), arguments) if !is_product => {
                    Evaluated::Text(formatted(&format, arguments)?)
                }
                _ => return None,
            };
        }
    }

    /// A value with its subscripts applied.
    fn item(&mut self) -> Option<Evaluated> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let mut value = self.value()?;
        while self.take('[') {
            let wanted = self.comparison()?;
            let found =
                |items: Vec<(Evaluated, Evaluated)>| items.into_iter().find(|(key, _)| *key == wanted);
            value = match value {
                Evaluated::Map(items) => found(items)?.1,
                _ => return None,
            };
            self.take(']').then_some(())?;
        }
        self.depth -= 1;
        Some(value)
    }

    fn value(&mut self) -> Option<Evaluated> {
        if self.take('(') {
            return self.tuple();
        }
        if self.take('{') {
            return self.map();
        }
        if self.take('-') {
            let Evaluated::Number(number) = self.item()? else { return None };
            return Some(Evaluated::Number(number.checked_neg()?));
        }
        for quote in ['"', '\''] {
            if self.take(quote) {
                let (text, rest) = self.rest.split_once(quote)?;
                self.rest = rest;
                return Some(Evaluated::Text(text.to_owned()));
            }
        }
        let end = self.rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest;
        let known = self.variables.iter().find(|(name, _)| *name == word).map(|(_, value)| *value);
        let number = match word {
            "True" => Some(1),
            "False" => Some(0),
            _ => known.or_else(|| number(word)),
        };
        number.map(Evaluated::Number)
    }

    fn tuple(&mut self) -> Option<Evaluated> {
        let first = self.comparison()?;
        if self.take(')') {
            return Some(first);
        }
        let mut items = vec![first];
        while self.take(',') {
            if self.take(')') {
                return Some(Evaluated::Tuple(items));
            }
            items.push(self.comparison()?);
        }
        self.take(')').then_some(Evaluated::Tuple(items))
    }

    fn map(&mut self) -> Option<Evaluated> {
        let mut items = Vec::new();
        while !self.take('}') {
            let key = self.comparison()?;
            self.take(':').then_some(())?;
            items.push((key, self.comparison()?));
            if !self.take(',') {
                self.take('}').then_some(())?;
                break;
            }
        }
        Some(Evaluated::Map(items))
    }
}

/// A whole number as Python writes it.
fn number(word: &str) -> Option<i64> {
    let word = word.trim_end_matches(['l', 'L']);
    match word.strip_prefix("0x").or_else(|| word.strip_prefix("0X")) {
        Some(digits) => i64::from_str_radix(digits, 16).ok(),
        None => word.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_objects() {
        assert_eq!(name("Device Type", 1, 0), "Device Type");
        assert_eq!(name("Receive PDO %d Mapping[(idx)]", 12, 0), "Receive PDO 12 Mapping");
        assert_eq!(name("PDO %d Mapping %d[(idx,sub)]", 2, 3), "PDO 2 Mapping 3");
        assert_eq!(name("Store %d[(sub - 3)]", 1, 5), "Store 2");
        assert_eq!(name("CAM%d Low Limit[(idx)] (ARRAY)", 1, 0), "CAM1 Low Limit");
        assert_eq!(name("Input %1.1d to %1.1d[(sub*8-7,sub*8)]", 1, 2), "Input 9 to 16");
        for unknown in ["x[", "x]", "x[y]", "%d[(nothing)]", "%d %d[(idx)]", "%[(idx)]", "%q[(idx)]"] {
            assert_eq!(name(unknown, 1, 1), unknown);
        }
    }

    #[test]
    fn values_of_pdos() {
        let cob_id = "{True:\"$NODEID+0x%X80\"%(base+1),False:0x80000000}[base<4]";
        assert_eq!(evaluate(cob_id, &[("base", 3)]), Some(Evaluated::Text("$NODEID+0x480".to_owned())));
        assert_eq!(evaluate(cob_id, &[("base", 4)]), Some(Evaluated::Number(0x8000_0000)));
        assert_eq!(evaluate("\"$NODEID+0x80\"", &[]), Some(Evaluated::Text("$NODEID+0x80".to_owned())));
        let deep = "(".repeat(500);
        for unknown in
            ["", "$NODEID+1", "{}[0]", "1+", "__import__('os')", "9223372036854775807+1", "1%0", &deep]
        {
            assert_eq!(evaluate(unknown, &[]), None, "{unknown}");
        }
    }
}
