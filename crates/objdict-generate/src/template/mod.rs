//! The target `template`: output of a custom template.

mod context;
mod filters;

use std::ffi::OsStr;
use std::io::Write;

use minijinja::syntax::SyntaxConfig;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, Value};
use objdict_model::source::read_text;

use super::dictionary::TableDictionary;
use super::{GenerateError, Generated, Options, OutputFile};
use crate::model::Device;

/// Instruction limit, so that endless templates stop: a base and an amount per entry.
const FUEL: (u64, u64) = (1_000_000, 2_000);

/// Maximum size of the output, and of the result of a filter, in bytes.
const LONGEST: usize = 64 << 20;

/// Maximum size of a template in bytes.
const LONGEST_TEMPLATE: u64 = 1 << 20;

/// Maximum size of a tag in bytes, and maximum number of `elif` in a template: the engine recurses for each operator
/// and each `elif`.
const LONGEST_TAG: usize = 16 << 10;
const MOST_BRANCHES: usize = 1000;

/// The engine's stack size in bytes. It is sufficient for the longest tag, and for values that are nested a
/// million levels deep.
const STACK: usize = 512 << 20;

pub(super) fn make(device: &Device, options: &Options) -> Result<Generated, GenerateError> {
    let path = options.template.as_deref().ok_or(GenerateError::NoTemplate)?;
    let file = path.file_name().map(OsStr::to_string_lossy).unwrap_or_default().into_owned();
    let fail = |message: String| GenerateError::UserTemplate { file: file.clone(), line: None, message };
    let output = file.strip_suffix(".j2").filter(|name| !name.is_empty());
    let output =
        output.ok_or_else(|| fail("name the template after its output, followed by `.j2`".into()))?;
    let source = read_text(path, LONGEST_TEMPLATE).map_err(|error| fail(error.to_string()))?;
    let dictionary = TableDictionary::new(device, options)?;
    let context = context::of(&dictionary, options).map_err(|error| fail(error.to_string()))?;
    let entries = dictionary.objects.iter().map(|object| object.entries.len() as u64).sum::<u64>();
    let fuel = FUEL.0 + FUEL.1 * entries;
    if let Some(message) = too_nested(&source) {
        return Err(fail(message));
    }
    let contents = std::thread::scope(|scope| {
        let engine = std::thread::Builder::new().stack_size(STACK);
        let engine = engine.spawn_scoped(scope, || render(&file, &source, context, fuel));
        let engine = engine.map_err(|error| fail(format!("cannot start the engine: {error}")))?;
        let rendered = engine.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
        rendered.map_err(|error| explained(&file, &error))
    })?;
    Ok(Generated { files: vec![OutputFile { path: output.to_owned(), contents }], notes: dictionary.notes })
}

/// The reason why a template would exceed the stack.
fn too_nested(source: &str) -> Option<String> {
    let tags = [("{{", "}}"), ("{%", "%}")].map(|(start, end)| {
        let tags = source.split(start).skip(1);
        tags.map(|tag| tag.find(end).unwrap_or(tag.len())).max().unwrap_or_default()
    });
    let longest = tags[0].max(tags[1]);
    let branches = source.matches("elif").count();
    match () {
        () if longest > LONGEST_TAG => Some(format!("a tag has more than {LONGEST_TAG} bytes")),
        () if branches > MOST_BRANCHES => Some(format!("there are more than {MOST_BRANCHES} `elif`")),
        () => None,
    }
}

fn render(file: &str, source: &str, context: Value, fuel: u64) -> Result<Vec<u8>, minijinja::Error> {
    let mut environment = Environment::new();
    let syntax =
        SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).keep_trailing_newline(true).build()?;
    environment.set_syntax(syntax);
    environment.set_auto_escape_callback(|_| AutoEscape::None); // generated files are rarely HTML
    environment.set_undefined_behavior(UndefinedBehavior::SemiStrict);
    environment.set_fuel(Some(fuel));
    filters::add(&mut environment);
    filters::bound(&mut environment);
    environment.add_template(file, source)?;
    let mut output = Bounded(Vec::new());
    environment.get_template(file)?.render_captured_to(context, &mut output)?;
    Ok(output.0)
}

/// An error with the template line, including the engine's chain of causes.
fn explained(file: &str, error: &minijinja::Error) -> GenerateError {
    let mut message = error.kind().to_string();
    if let Some(detail) = error.detail() {
        message = format!("{message}: {detail}");
    }
    if let Some(cause) = std::error::Error::source(error) {
        message = format!("{message}: {cause}");
    }
    GenerateError::UserTemplate { file: file.to_owned(), line: error.line(), message }
}

/// A writer with limited size.
struct Bounded(Vec<u8>);

impl Write for Bounded {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.0.len() + bytes.len() > LONGEST {
            return Err(std::io::Error::other(format!("the output has more than {LONGEST} bytes")));
        }
        self.0.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}
