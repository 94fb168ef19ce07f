//! The page of a description, as `objdict docs` makes it, of the text in the editor.

use std::path::PathBuf;

use lsp_server::{Request, RequestId};
use serde_json::json;

use super::file::CheckedFile;
use super::protocol::{CodeAction, Command};
use super::uri::of_path;
use super::workspace::EditorWorkspace;
use objdict_document::{Finding, Form, Identifiers, Options, Subject, write};
use objdict_project::report::{Location, grouped};

/// The command that answers the page as HTML.
pub(super) const PAGE: &str = "objdict.documentation";

/// The command that shows the page in the browser.
pub(super) const SHOW: &str = "objdict.showDocumentation";

/// The kind of the action that shows the page.
pub(super) const KIND: &str = "source.documentation";

pub(super) fn action(file: &CheckedFile) -> CodeAction {
    let title = "show the documentation".to_owned();
    let arguments = Some(json!([file.uri]));
    let command = Some(Command { title: title.clone(), command: SHOW, arguments });
    CodeAction { title, kind: KIND, command, ..CodeAction::default() }
}

/// The page of a description, with its findings.
///
/// # Errors
/// When the file is not a description.
pub(super) fn page(file: &CheckedFile) -> Result<String, String> {
    let description = file.description().ok_or_else(|| format!("`{}` is not a description", file.name()))?;
    let shown = file.analysis.map_subjects(|subject, findings| {
        let findings = grouped(subject, findings.clone());
        let line = |finding| Some(Location::start_of(subject, finding).line);
        findings.iter().map(|finding| Finding::new(finding, line(finding))).collect::<Vec<_>>()
    });
    let subject = Subject {
        device: description.device(),
        file: file.name(),
        format: description.format().name(),
        findings: shown.first().map(Vec::as_slice),
        identifiers: &Identifiers::new(),
    };
    Ok(write(&subject, Form::Html, &Options::default()))
}

/// Writes the page into a folder of its own for temporary files, and asks the editor to show it.
///
/// # Errors
/// When the file is not a description, or the page cannot be written.
pub(super) fn show(file: &CheckedFile, workspace: &mut EditorWorkspace) -> Result<(), String> {
    let page = page(file)?;
    let failed = |error: std::io::Error| format!("cannot write the page: {error}");
    let folder = folder(workspace).map_err(failed)?;
    let path = folder.join(format!("{}.html", file.name()));
    std::fs::write(&path, page).map_err(failed)?;
    let uri = of_path(&path).ok_or("cannot name the page")?;
    let params = json!({ "uri": uri, "external": true });
    let id = RequestId::from("show".to_owned());
    workspace.requests.push(Request::new(id, "window/showDocument".to_owned(), params));
    Ok(())
}

/// The folder of the pages, which nothing else has made.
fn folder(workspace: &mut EditorWorkspace) -> std::io::Result<PathBuf> {
    if let Some(folder) = &workspace.pages {
        return Ok(folder.clone());
    }
    let process = std::process::id();
    for number in 0..100 {
        let folder = std::env::temp_dir().join(format!("objdict-{process}-{number}"));
        match std::fs::create_dir(&folder) {
            Ok(()) => return Ok(workspace.pages.insert(folder).clone()),
            Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(std::io::ErrorKind::AlreadyExists.into())
}
