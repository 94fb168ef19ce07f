//! The templates of `crates/objdict-generate` as Rust, so that a build script compiles no template engine.
//!
//! A template has the syntax of askama, as far as [`Expansion::tag`] knows it. Its first line names a method,
//! `{# Tables<'_>::header #}`, that returns its text; a template without such a line is only included by others. A name that is
//! not bound in the template is a field or a method of `self`.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/objdict-generate");

/// Writes the expansions; with `check_only`, fails if one is not what its template says.
pub(crate) fn run(check_only: bool) -> Result<(), String> {
    let (sources, expanded) = (Path::new(FOLDER).join("templates"), Path::new(FOLDER).join("expanded"));
    let mut wanted = BTreeMap::new();
    for path in files_below(&sources)? {
        let text = read(&path)?;
        let name = path.strip_prefix(&sources).unwrap_or(&path).to_string_lossy().replace('\\', "/");
        if let Some((method, body)) = text.strip_prefix("{# ").and_then(|text| text.split_once(" #}\n")) {
            let code = expand(&sources, &name, method, body).map_err(|error| format!("{name}: {error}"))?;
            wanted.insert(expanded.join(format!("{name}.rs")), code);
        }
    }
    let present = if expanded.exists() { files_below(&expanded)? } else { Vec::new() };
    let left_over = present.into_iter().filter(|path| !wanted.contains_key(path));
    let left_over: Vec<PathBuf> = left_over.collect();
    let is_stale =
        |(path, code): &(&PathBuf, &String)| !fs::read_to_string(path).is_ok_and(|text| text == **code);
    let stale: Vec<_> = wanted.iter().filter(is_stale).collect();
    if check_only {
        let names =
            stale.iter().map(|(path, _)| *path).chain(&left_over).map(|path| path.display().to_string());
        let names: Vec<String> = names.collect();
        return if names.is_empty() {
            Ok(())
        } else {
            Err(format!("stale, run `cargo xtask templates`: {}", names.join(", ")))
        };
    }
    for path in left_over {
        fs::remove_file(&path).map_err(|error| format!("cannot remove {}: {error}", path.display()))?;
    }
    for (path, code) in stale {
        path.parent()
            .map_or(Ok(()), fs::create_dir_all)
            .and_then(|()| fs::write(path, code))
            .map_err(|error| format!("cannot write {}: {error}", path.display()))?;
    }
    Ok(())
}

/// All files, in order.
fn files_below(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let entries =
        fs::read_dir(folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    let mut paths: Vec<_> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    let below = |path: PathBuf| if path.is_dir() { files_below(&path) } else { Ok(vec![path]) };
    Ok(paths.into_iter().map(below).collect::<Result<Vec<_>, _>>()?.concat())
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// The method that returns the text of a template.
fn expand(sources: &Path, name: &str, method: &str, body: &str) -> Result<String, String> {
    let (view, method) = method.rsplit_once("::").ok_or("the first line must be `{# VIEW::METHOD #}`")?;
    let mut expansion =
        Expansion { sources, code: String::new(), pieces: Vec::new(), blocks: Vec::new(), bound: Vec::new() };
    expansion.template(name, body)?;
    expansion.flush();
    if let Some(block) = expansion.blocks.last() {
        return Err(format!("`{{% {} %}}` has no end", block.kind));
    }
    let code = expansion.code;
    Ok(format!(
        "// Generated from templates/{name} by `cargo xtask templates`; do not edit.\n\n\
         #[allow(clippy::all, clippy::pedantic, reason = \"generated\")]\n\
         impl {view} {{\n    pub(super) fn {method}(&self) -> String {{\n        let mut out = String::new();\n\
         {code}        out\n    }}\n}}\n"
    ))
}

/// A text, or an expression with its format.
enum Piece {
    Text(String),
    Value { format: String, expression: String },
}

/// A tag that is open.
struct Block {
    kind: &'static str,
    /// How many names were bound before it.
    bound: usize,
    /// The length of the code before it.
    start: usize,
    /// Whether a loop uses `loop`.
    is_counted: bool,
}

struct Expansion<'a> {
    sources: &'a Path,
    code: String,
    /// What the next statement writes.
    pieces: Vec<Piece>,
    blocks: Vec<Block>,
    /// The names that are not of `self`.
    bound: Vec<String>,
}

impl Expansion<'_> {
    /// Expands a text, which tags with `-` trim.
    fn template(&mut self, name: &str, text: &str) -> Result<(), String> {
        let mut rest = text.strip_suffix('\n').unwrap_or(text);
        let mut is_trimmed = false;
        while let Some(start) = rest.find("{{").into_iter().chain(rest.find("{%")).min() {
            let end = if rest[start..].starts_with("{{") { "}}" } else { "%}" };
            let length =
                rest[start..].find(end).ok_or_else(|| format!("`{}` has no end", &rest[start..start + 2]))?;
            let tag = &rest[start + 2..start + length];
            self.text(&rest[..start], is_trimmed, tag.starts_with('-'));
            is_trimmed = tag.ends_with('-');
            rest = &rest[start + length + 2..];
            let tag = tag.strip_prefix('-').unwrap_or(tag);
            let tag = tag.strip_suffix('-').unwrap_or(tag).trim();
            if tag.contains("loop.")
                && let Some(block) = self.blocks.iter_mut().rfind(|block| block.kind == "for")
            {
                block.is_counted = true;
            }
            match end {
                "}}" => self.value(tag)?,
                _ => self.tag(name, tag).map_err(|error| format!("`{tag}`: {error}"))?,
            }
        }
        self.text(rest, is_trimmed, false);
        Ok(())
    }

    fn text(&mut self, text: &str, trim_start: bool, trim_end: bool) {
        let text = if trim_start { text.trim_start() } else { text };
        let text = if trim_end { text.trim_end() } else { text };
        match self.pieces.last_mut() {
            Some(Piece::Text(before)) => before.push_str(text),
            _ if text.is_empty() => {}
            _ => self.pieces.push(Piece::Text(text.to_owned())),
        }
    }

    /// `EXPRESSION`, `EXPRESSION|FILTER` or `"{:X}"|format(EXPRESSION)`.
    fn value(&mut self, text: &str) -> Result<(), String> {
        let (format, expression) = match text.rsplit_once('|') {
            None => ("{}", self.expression(text)),
            Some((format, of)) if format.starts_with('"') => {
                let of = of.strip_prefix("format").ok_or_else(|| format!("`{text}` is not a filter"))?;
                (
                    format.trim_matches('"'),
                    self.expression(of.trim_start_matches('(').strip_suffix(')').unwrap_or(of)),
                )
            }
            Some((of, "upper")) => ("{}", format!("{}.to_string().to_uppercase()", self.expression(of))),
            Some((of, "lower")) => ("{}", format!("{}.to_string().to_lowercase()", self.expression(of))),
            Some((of, filter)) => ("{}", format!("crate::escape::{filter}(&{})", self.expression(of))),
        };
        self.pieces.push(Piece::Value { format: format.to_owned(), expression });
        Ok(())
    }

    fn tag(&mut self, name: &str, tag: &str) -> Result<(), String> {
        let (word, rest) = tag.split_once(' ').unwrap_or((tag, ""));
        if word == "include" {
            let path = rest.trim_matches('"');
            let beside = Path::new(name).with_file_name(path);
            let path = if self.sources.join(&beside).exists() { beside } else { PathBuf::from(path) };
            let text = read(&self.sources.join(&path))?;
            return self.template(&path.to_string_lossy(), &text);
        }
        if word == "when" && self.blocks.last().is_some_and(|block| block.kind == "match") {
            self.pieces.clear(); // only white space is there
        }
        self.flush();
        match word {
            "if" => self.open("if", &self.condition(rest), rest),
            "else" => {
                self.close(&["if", "when"])?;
                match rest.strip_prefix("if ") {
                    Some(rest) => self.open("if", &format!("else {}", self.condition(rest)), rest),
                    None => self.open("if", "else", ""),
                }
            }
            "for" => {
                let (pattern, items) = rest.split_once(" in ").ok_or("a loop is `for PATTERN in ITEMS`")?;
                let items = self.place(items);
                self.open("for", &format!("for {pattern} in {items}"), pattern);
            }
            "match" => self.open("match", &format!("match {}", self.place(rest)), ""),
            "when" => {
                if self.blocks.last().is_some_and(|block| block.kind == "when") {
                    self.close(&["when"])?;
                }
                self.open("when", &format!("{rest} =>"), rest);
            }
            "let" => {
                let (pattern, value) =
                    rest.split_once(" = ").ok_or("a name is bound as `let NAME = VALUE`")?;
                let value = self.place(value);
                self.line(&format!("let {pattern} = {value};"));
                self.bind(pattern);
            }
            "endif" => self.close(&["if"])?,
            "endfor" => self.close(&["for"])?,
            "endmatch" => {
                self.close(&["when"])?;
                self.close(&["match"])?;
            }
            _ => return Err("unknown tag".to_owned()),
        }
        Ok(())
    }

    fn condition(&self, text: &str) -> String {
        match text.strip_prefix("let ").and_then(|text| text.split_once(" = ")) {
            Some((pattern, value)) => format!("if let {pattern} = {}", self.place(value)),
            None => format!("if {}", self.expression(text)),
        }
    }

    fn open(&mut self, kind: &'static str, line: &str, pattern: &str) {
        let start = self.code.len();
        self.line(&format!("{line} {{"));
        self.blocks.push(Block { kind, bound: self.bound.len(), start, is_counted: false });
        if kind != "if" || pattern.starts_with("let ") {
            self.bind(pattern.split(" = ").next().unwrap_or_default());
        }
    }

    fn close(&mut self, kinds: &[&str]) -> Result<(), String> {
        let block =
            self.blocks.pop().filter(|block| kinds.contains(&block.kind)).ok_or("nothing is open to end")?;
        self.bound.truncate(block.bound);
        self.line("}");
        if block.is_counted {
            let rest = self.code.split_off(block.start);
            let (header, body) = rest.split_once(" {\n").unwrap_or_default();
            let (pattern, items) = header.split_once(" in ").unwrap_or_default();
            let pattern = pattern.replace("for ", "for (index0, ");
            let _ = write!(self.code, "{pattern}) in ({items}).into_iter().enumerate() {{\n{body}"); // to a String
        }
        Ok(())
    }

    /// The names in a pattern: what is in lower case, but no keyword, and no path.
    fn bind(&mut self, pattern: &str) {
        let words = pattern.split(|c: char| !c.is_alphanumeric() && c != '_');
        let is_name = |word: &&str| word.starts_with(|c: char| c.is_lowercase()) && *word != "let";
        self.bound.extend(words.filter(is_name).map(str::to_owned));
    }

    /// An expression that is only borrowed.
    fn place(&self, text: &str) -> String {
        let expression = self.expression(text);
        let is_value =
            expression.ends_with(')') || expression.contains("..") || ["true", "false"].contains(&text);
        let is_bound = self.bound.iter().any(|name| name == text);
        if is_value || is_bound { expression } else { format!("&{expression}") }
    }

    /// An expression of Rust, in which names that are not bound are of `self`.
    fn expression(&self, text: &str) -> String {
        let text = text.trim().replace("loop.first", "(index0 == 0)").replace("loop.", "");
        let (mut code, mut is_text) = (String::new(), false);
        let mut rest = text.as_str();
        while let Some(c) = rest.chars().next() {
            let is_word = |c: char| c.is_alphanumeric() || c == '_';
            let length =
                if is_word(c) { rest.find(|c| !is_word(c)).unwrap_or(rest.len()) } else { c.len_utf8() };
            let (word, behind) = rest.split_at(length);
            let is_member = code.ends_with("::") || code.ends_with('.') && !code.ends_with("..");
            let is_free = c.is_lowercase() && !is_text && !is_member && !behind.starts_with("::");
            let is_known = ["self", "true", "false", "as", "index0"].contains(&word);
            if is_free && !is_known && !self.bound.iter().any(|name| name == word) {
                code.push_str("self.");
            }
            code.push_str(word);
            is_text ^= c == '"';
            rest = behind;
        }
        code
    }

    /// Writes what is pending.
    fn flush(&mut self) {
        let pieces = std::mem::take(&mut self.pieces);
        if let [Piece::Text(text)] = &pieces[..] {
            if !text.is_empty() {
                self.line(&format!("out.push_str(\"{}\");", literal(text)));
            }
        } else if !pieces.is_empty() {
            let (mut format, mut values) = (String::new(), String::new());
            for piece in &pieces {
                match piece {
                    Piece::Text(text) => {
                        format.push_str(&literal(text).replace('{', "{{").replace('}', "}}"));
                    }
                    Piece::Value { format: of_it, expression } => {
                        format.push_str(of_it);
                        let _ = write!(values, ", {expression}"); // writing to a String cannot fail
                    }
                }
            }
            self.line(&format!("put!(out, \"{format}\"{values});"));
        }
    }

    fn line(&mut self, line: &str) {
        let indent = "    ".repeat(self.blocks.len() + 2);
        self.code.push_str(&format!("{indent}{line}\n"));
    }
}

/// The content of a string literal, on as many lines as the text.
fn literal(text: &str) -> String {
    text.replace('\\', "\\\\").replace('"', "\\\"")
}

#[cfg(test)]
mod tests {
    #[test]
    fn templates_are_expanded() {
        assert_eq!(super::run(true), Ok(()));
    }
}
