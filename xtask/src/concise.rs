//! Real concise DCF: each is unpacked to text and packed again, and played against the description that its network was
//! made of.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use objdict::download::ConciseDcf;
use objdict::format::identify::{ContentKind, identify};
use objdict::format::{self, concise};
use objdict::model::Device;
use objdict::source::SourceOptions;

/// What came of the blobs.
#[derive(Default)]
struct Tally {
    blobs: usize,
    identical: usize,
    verified: usize,
    accepted: usize,
    /// Why a blob is not accepted or could not be verified.
    reasons: Vec<String>,
}

/// A file of a network, as `sets.csv` lists it.
struct Member {
    set: String,
    /// Its name in the network.
    name: String,
    path: PathBuf,
}

/// Runs over the folder of a corpus, which has `sets.csv` and `dev/concise`, and prints a line and the reasons.
pub(crate) fn run(corpus: &Path) -> Result<(), String> {
    let members = members(corpus)?;
    let folder = corpus.join("dev/concise");
    let files =
        fs::read_dir(&folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    let mut files: Vec<PathBuf> = files.filter_map(|file| Some(file.ok()?.path())).collect();
    files.sort();
    let mut tally = Tally::default();
    for file in &files {
        one(file, &members, &mut tally)?;
    }
    for reason in &tally.reasons {
        println!("{reason}");
    }
    let Tally { blobs, identical, verified, accepted, .. } = tally;
    println!("{blobs} blobs, {identical} identical, {verified} verified, {accepted} of them accepted");
    if identical < blobs { Err(format!("{} blobs do not come back", blobs - identical)) } else { Ok(()) }
}

fn one(file: &Path, members: &[Member], tally: &mut Tally) -> Result<(), String> {
    let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let bytes = fs::read(file).map_err(|error| format!("cannot read {}: {error}", file.display()))?;
    tally.blobs += 1;
    let stream = match ConciseDcf::parse(&bytes) {
        Ok(stream) => stream,
        Err(error) => {
            tally.reasons.push(format!("{name}: {error}"));
            return Ok(());
        }
    };
    let text = concise::print(&stream, |_| concise::Annotation::default());
    let again = concise::parse(&text, None).ok().and_then(|stream| stream.write().ok());
    tally.identical += usize::from(again.as_ref() == Some(&bytes));
    if identify(&name, &bytes).kind == ContentKind::PowerlinkConcise {
        tally.reasons.push(format!("{name}: of Ethernet POWERLINK"));
        return Ok(());
    }
    let Some(member) = members.iter().find(|member| member.path == file) else {
        tally.reasons.push(format!("{name}: nothing says what it was made of"));
        return Ok(());
    };
    match described(member, members) {
        Ok((device, node_id)) => {
            tally.verified += 1;
            let verification = stream.verify(&device, node_id);
            tally.accepted += usize::from(verification.is_accepted());
            let refusals = verification.refusals().take(3);
            tally.reasons.extend(refusals.map(|objection| format!("{name}: {objection}")));
        }
        Err(reason) => tally.reasons.push(format!("{name}: {reason}")),
    }
    Ok(())
}

/// The description of the node that a blob is for, and its node-ID.
fn described(blob: &Member, members: &[Member]) -> Result<(Device, Option<u8>), String> {
    let of_set = |name: &str| {
        let is_it = |member: &&Member| member.set == blob.set && member.name.eq_ignore_ascii_case(name);
        members.iter().find(is_it).map(|member| member.path.clone())
    };
    let stem = blob.name.rsplit('/').next().unwrap_or_default().trim_end_matches(".bin");
    if let Some(dcf) = of_set(&format!("{stem}.dcf")) {
        let device = open(&dcf)?;
        return Ok((device, None));
    }
    let is_bus = |member: &&Member| {
        let ending = member.path.extension().is_some_and(|ending| ending == "yml" || ending == "yaml");
        member.set == blob.set && ending
    };
    let bus = members.iter().find(is_bus).ok_or("the network has no bus configuration")?;
    let text = fs::read_to_string(&bus.path).map_err(|error| format!("{}: {error}", bus.path.display()))?;
    let facts = facts_of(&text, stem);
    let eds = facts.get("dcf").ok_or("the bus configuration names no description")?;
    let path = of_set(eds).ok_or_else(|| format!("`{eds}` is not in the corpus"))?;
    let node_id = facts.get("node_id").and_then(|text| parse_number(text));
    Ok((open(&path)?, node_id))
}

fn open(path: &Path) -> Result<Device, String> {
    let description = format::open(path, &SourceOptions::default());
    description.map(format::Description::into_device).map_err(|error| error.to_string())
}

/// The scalars of a block of the YAML; where it lacks one, the first of that name in the file.
fn facts_of(text: &str, block: &str) -> BTreeMap<String, String> {
    let mut facts = BTreeMap::new();
    let mut inside: Option<usize> = None;
    for line in text.lines().map(|line| line.split(" #").next().unwrap_or(line)) {
        let key = line.trim_start().trim_start_matches("- ");
        let Some((key, value)) = key.split_once(':') else { continue };
        let indent = line.len() - line.trim_start().len();
        inside = match inside {
            None if key.trim() == block => Some(indent),
            Some(outer) if indent <= outer => None,
            inside => inside,
        };
        let value = value.trim().trim_matches(['"', '\'']);
        let value = value.rsplit('/').next().unwrap_or(value).to_owned();
        if inside.is_some() {
            facts.insert(key.trim().to_owned(), value);
        } else {
            facts.entry(key.trim().to_owned()).or_insert(value);
        }
    }
    facts
}

fn parse_number(text: &str) -> Option<u8> {
    match text.strip_prefix("0x") {
        Some(digits) => u8::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

fn members(corpus: &Path) -> Result<Vec<Member>, String> {
    let path = corpus.join("sets.csv");
    let text =
        fs::read_to_string(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
    let member = |line: &str| {
        let mut cells = line.split(',');
        let (set, _, _) = (cells.next()?.to_owned(), cells.next()?, cells.next()?);
        let name = cells.next()?.to_owned();
        Some(Member { set, name, path: corpus.join(cells.next()?) })
    };
    Ok(text.lines().skip(1).filter_map(member).collect())
}
