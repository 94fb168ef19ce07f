//! Downloads to a node, with what undoes them.

use std::collections::{BTreeMap, BTreeSet};

use objdict_bus::Abort;
use objdict_node::download::{ConciseDcf, Download, remaining};

use crate::client::{BusClient, ClientError, unless_refused};

/// Index and sub-index.
type WrittenEntry = (u16, u8);

/// What became of a download.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum WriteResult {
    /// The node has accepted it.
    Written,
    /// It has accepted it, and answers another value.
    Differs(Vec<u8>),
    /// It has refused it.
    Refused(Abort),
    /// It was not sent.
    Unsent,
}

/// How downloads are made.
#[derive(Clone, Copy, Debug, Default)]
pub struct ApplyOptions {
    /// Reads back the value of each entry after the last download.
    pub verify: bool,
    /// Goes on after the node has refused a download.
    pub go_on: bool,
    /// The number of downloads to leave out at the beginning.
    pub skip: usize,
}

/// The downloads that undo others, and the entries whose values are lost, because they cannot be read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Undo {
    /// The downloads.
    pub downloads: ConciseDcf,
    /// The entries that cannot be undone.
    pub lost: Vec<WrittenEntry>,
}

impl BusClient {
    /// Reads the present values of the entries that downloads write. Entries that the node does not let read are left out.
    ///
    /// # Errors
    /// When the node does not answer, another client interferes, the user interrupts or the adapter is lost.
    pub fn present(
        &mut self,
        node_id: u8,
        downloads: &[Download],
    ) -> Result<BTreeMap<WrittenEntry, Vec<u8>>, ClientError> {
        let mut present = BTreeMap::new();
        for (index, sub) in downloads.iter().map(Download::entry).collect::<BTreeSet<_>>() {
            if let Some(bytes) = unless_refused(self.upload(node_id, index, sub))? {
                present.insert((index, sub), bytes);
            }
        }
        Ok(present)
    }

    /// Makes downloads in their order. The results are there after an error too: what follows it is unsent.
    pub fn apply(
        &mut self,
        node_id: u8,
        downloads: &[Download],
        options: ApplyOptions,
    ) -> (Vec<WriteResult>, Option<ClientError>) {
        let mut results = vec![WriteResult::Unsent; downloads.len()];
        for (result, Download { index, sub, data }) in results.iter_mut().zip(downloads).skip(options.skip) {
            match self.download(node_id, *index, *sub, data) {
                Ok(()) => *result = WriteResult::Written,
                Err(ClientError::Refused { abort, .. }) => {
                    *result = WriteResult::Refused(abort);
                    if !options.go_on {
                        return (results, None);
                    }
                }
                Err(error) => return (results, Some(error)),
            }
        }
        let error = if options.verify { self.verify(node_id, downloads, &mut results).err() } else { None };
        (results, error)
    }

    /// Reads back the last value of each entry.
    fn verify(
        &mut self,
        node_id: u8,
        downloads: &[Download],
        results: &mut [WriteResult],
    ) -> Result<(), ClientError> {
        for ((download, remains), result) in downloads.iter().zip(remaining(downloads)).zip(results) {
            if !remains || *result != WriteResult::Written {
                continue;
            }
            // what cannot be read cannot be compared
            let bytes = unless_refused(self.upload(node_id, download.index, download.sub))?;
            if let Some(bytes) = bytes.filter(|bytes| *bytes != download.data) {
                *result = WriteResult::Differs(bytes);
            }
        }
        Ok(())
    }
}

/// What undoes downloads: the same in their order, the last one of each entry with its present value. So a PDO is disabled while it
/// is changed, as in the downloads.
pub fn undo(downloads: &[Download], present: &BTreeMap<WrittenEntry, Vec<u8>>) -> Undo {
    let mut undo = Undo::default();
    for (download, remains) in downloads.iter().zip(remaining(downloads)) {
        match present.get(&download.entry()) {
            None if remains => undo.lost.push(download.entry()),
            None => {}
            Some(_) if !remains => undo.downloads.0.push(download.clone()),
            Some(value) => {
                undo.downloads.0.push(Download::new(download.index, download.sub, value.clone()));
            }
        }
    }
    undo
}
