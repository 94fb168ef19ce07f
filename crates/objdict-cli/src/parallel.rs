//! Work on many files at the same time, with results in their order.
//!
//! A batch is limited in files and bytes, so the output does not depend on the number of threads and thousands of
//! files are never in memory together.

use std::num::NonZeroUsize;
use std::sync::mpsc;
use std::thread;

use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use super::ending::Failure;
use super::files::InputFile;
use super::progress::Progress;

/// So many files are in memory at once, and as many are waiting to be reported.
const MAX_FILES: usize = 256;

/// And so many bytes of them, unless one file alone is larger.
const MAX_BYTES: u64 = 16 << 20;

/// Does `work` on each file, which `verb` names for the progress, on as many threads as `jobs` says, and hands each result to `take`, on this thread and in the
/// order of the files, while the next ones are worked on.
///
/// # Errors
/// The first one of `take`, and when no threads can be had. What was not begun by then is left.
pub(super) fn in_order<R: Send>(
    files: &[InputFile],
    jobs: Option<NonZeroUsize>,
    verb: &'static str,
    work: impl Fn(&InputFile) -> R + Sync,
    mut take: impl FnMut(R) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let progress = Progress::new(verb, files.len());
    let work = |file: &InputFile| {
        let result = work(file);
        progress.step();
        result
    };
    let jobs = jobs.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    if jobs == 1 || files.len() < 2 {
        return files.iter().try_for_each(|file| take(work(file)));
    }
    let pool = ThreadPoolBuilder::new().num_threads(jobs.min(files.len())).build();
    let pool = pool.map_err(|error| Failure::new(format_args!("cannot start threads: {error}")))?;
    let work = &work;
    thread::scope(|scope| {
        let (sender, results) = mpsc::sync_channel(1);
        scope.spawn(move || {
            for batch in Batches(files) {
                let results: Vec<R> = pool.install(|| batch.par_iter().with_max_len(1).map(work).collect());
                // no more results are wanted once `take` has failed
                if sender.send(results).is_err() {
                    break;
                }
            }
        });
        results.into_iter().flatten().try_for_each(&mut take)
    })
}

/// Files that are in memory together.
struct Batches<'a>(&'a [InputFile]);

impl<'a> Iterator for Batches<'a> {
    type Item = &'a [InputFile];

    fn next(&mut self) -> Option<&'a [InputFile]> {
        let mut bytes = 0u64;
        let fits = |file: &&InputFile| {
            bytes = bytes.saturating_add(file.size);
            bytes <= MAX_BYTES
        };
        let count = self.0.iter().take(MAX_FILES).take_while(fits).count().max(1).min(self.0.len());
        let (batch, rest) = self.0.split_at(count);
        self.0 = rest;
        (count > 0).then_some(batch)
    }
}
