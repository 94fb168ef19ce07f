//! Networks.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use objdict::format::network::{Build, BuildError, BuiltFile, NetworkFile, PathOptions};
use objdict::network::{DcfgenMode, LelyOptions};
use objdict::report::{Report, Subject, by_place, grouped};
use objdict::workspace::Workspace;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::dictionary::project_of;
use super::findings::{document, errors_among};
use super::{raised, unreadable};

/// The name of a node and its node-ID.
type NamedNode = (String, Option<u8>);

/// The nodes of a network file with their node-IDs, and its findings.
#[pyfunction]
pub(crate) fn check_network(py: Python<'_>, path: PathBuf) -> PyResult<(Vec<NamedNode>, String)> {
    py.detach(|| {
        let file = opened(&path)?;
        let nodes = file.network().into_iter().flat_map(|network| &network.nodes);
        let nodes = nodes
            .map(|node| (node.name.value.clone(), node.node_id.as_ref().map(|node_id| node_id.value)))
            .collect();
        let findings = document(|report| {
            let mut subjects = Subject::of_network(&file, file.check()).into_iter();
            subjects.try_for_each(|(subject, findings)| report.file(subject, &by_place(subject, findings)))
        });
        Ok((nodes, findings?))
    })
}

/// The files that are built of a network, by their names.
#[pyfunction]
pub(crate) fn build_network<'py>(
    py: Python<'py>,
    path: PathBuf,
    target: &str,
    force: bool,
) -> PyResult<BTreeMap<String, Bound<'py, PyBytes>>> {
    let files = py.detach(|| {
        let file = opened(&path)?;
        if !force {
            refuse(&file)?;
        }
        let build = file.build(DcfgenMode::Corrected).map_err(raised)?;
        files(&build, target)?.map_err(raised)
    })?;
    Ok(files.into_iter().map(|file| (file.name, PyBytes::new(py, &file.bytes))).collect())
}

/// A network, its descriptions with the patches of the nearest configuration.
pub(crate) fn opened(path: &Path) -> PyResult<NetworkFile> {
    let mut options = PathOptions { judge: Some(objdict::workspace::judge), ..PathOptions::default() };
    options.patches = project_of(&mut Workspace::default(), path)?
        .map(|project| project.patches.clone())
        .unwrap_or_default();
    NetworkFile::open(path, &options).map_err(unreadable)
}

/// Builds nothing of a network with errors.
fn refuse(file: &NetworkFile) -> PyResult<()> {
    let subjects = Subject::of_network(file, file.check()).into_iter();
    let errors = subjects.map(|(subject, findings)| errors_among(subject, grouped(subject, findings)));
    let errors: String = errors.collect::<PyResult<_>>()?;
    if errors.is_empty() { Ok(()) } else { Err(raised(errors.trim_end())) }
}

fn files(build: &Build<'_>, target: &str) -> PyResult<Result<Vec<BuiltFile>, BuildError>> {
    Ok(match target {
        "dcf" => build.dcfs(),
        "concise" => build.concise(),
        "lely" => build.lely(&LelyOptions { mode: DcfgenMode::Corrected, remote_pdos: false }),
        "manager" => build.manager().map(|file| vec![file]),
        "cpj" => build.node_list(),
        "busyml" => build.bus_yml(),
        _ => return Err(raised(format_args!("there is no target `{target}`"))),
    })
}
