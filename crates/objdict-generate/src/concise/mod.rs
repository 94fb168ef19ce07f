//! The target `concise`: the stream of SDO downloads that a CANopen manager stores for the node (1F22h, CiA
//! 302-3).

use super::{GenerateError, Generated, Note, Options, OutputFile};
use crate::model::{Device, Place};
use objdict_node::download::{ConciseDcf, Plan, PlanError, PlanOptions};

pub(super) fn make(device: &Device, options: &Options) -> Result<Generated, GenerateError> {
    if device.is_ethercat() {
        let note =
            Note::new(Place::device(), "an EtherCAT device has no concise DCF: it is not a CANopen node");
        return Err(GenerateError::Inexpressible(vec![note]));
    }
    let node_id = options.node_id_of(device)?;
    let plan = ConciseDcf::plan(device, &PlanOptions { node_id, ..PlanOptions::default() })
        .map_err(inexpressible)?;
    let notes = notes(&plan);
    let contents = plan
        .without_files()
        .write()
        .map_err(|error| GenerateError::Inexpressible(vec![Note::new(Place::device(), error.to_string())]))?;
    let path = format!("{}.cdcf", options.file_stem);
    Ok(Generated { files: vec![OutputFile { path, contents }], notes })
}

fn notes(plan: &Plan) -> Vec<Note> {
    let mut notes: Vec<Note> = plan
        .skipped
        .iter()
        .map(|skipped| {
            Note::new(skipped.place.clone(), format!("not part of the stream: {}", skipped.reason))
        })
        .collect();
    notes.extend(plan.files().map(|file| {
        let place = Place::entry(file.index, file.sub);
        Note::new(place, format!("not part of the stream: its data are in the file `{}`", file.name))
            .help("`objdict convert` to a `.cdcf` file reads it")
    }));
    notes.sort_by(|a, b| a.place.cmp(&b.place));
    if plan.steps.is_empty() {
        let note = Note::new(
            Place::device(),
            "no entry is configured to a value other than its default: the stream is empty",
        );
        notes.push(note.help("set values in a DCF (`ParameterValue`)"));
    }
    notes
}

fn inexpressible(error: PlanError) -> GenerateError {
    let help = error.help();
    match error {
        PlanError::NodeId(node_id) => GenerateError::NodeId { node_id },
        PlanError::Problems(problems) => {
            let note = |(place, message)| Note { help: help.map(Into::into), ..Note::new(place, message) };
            let notes = problems.into_iter().map(|problem| (problem.place, problem.kind.to_string()));
            GenerateError::Inexpressible(notes.map(note).collect())
        }
        error => GenerateError::Inexpressible(vec![Note::new(Place::device(), error.to_string())]),
    }
}
