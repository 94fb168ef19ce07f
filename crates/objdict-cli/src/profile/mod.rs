//! `objdict profile`: the documents that come with the program, and what they demand; custom profiles too.

mod json;
mod text;

use std::io::Write;

#[cfg(feature = "schema")]
pub(super) use self::json::{ListDocument, ProfileDocument};
use super::args::{ProfileCommand, ProfileFormat, ProfileListArgs, ProfileShowArgs};
use super::ending::{Failure, Outcome};
use super::profile_option;
use super::stdout::Output;
use objdict_profile::{ObjectFacts, Profile, standard};

pub(super) fn run(command: &ProfileCommand, out: &mut Output) -> Result<Outcome, Failure> {
    match command {
        ProfileCommand::List(args) => list(args, out),
        ProfileCommand::Show(args) => show(args, out),
    }
    .map(|()| Outcome::Clean)
}

fn list(args: &ProfileListArgs, out: &mut Output) -> Result<(), Failure> {
    match args.format {
        ProfileFormat::Text => text::list(standard(), out)?,
        ProfileFormat::Json => json::list(standard(), &mut out.raw()?)?,
    }
    Ok(())
}

fn show(args: &ProfileShowArgs, out: &mut Output) -> Result<(), Failure> {
    let profile = profile_option::load(&args.profile, std::path::Path::new(""))?;
    let object = args.index.map(|address| find(&profile, address.index)).transpose()?;
    match (args.format, object) {
        (ProfileFormat::Text, None) => text::profile(&profile, out)?,
        (ProfileFormat::Text, Some(object)) => text::object(&profile, &object, out)?,
        (ProfileFormat::Json, None) => json::profile(&profile, profile.objects(), &mut out.raw()?)?,
        (ProfileFormat::Json, Some(object)) => {
            json::profile(&profile, std::iter::once(object), &mut out.raw()?)?;
        }
    }
    Ok(())
}

/// What the documents of CiA say of an object.
pub(super) fn explain(index: u16, out: &mut Output) -> Result<(), Failure> {
    let mut is_first = true;
    for profile in standard() {
        let Ok(facts) = find(profile, index) else { continue };
        if !std::mem::take(&mut is_first) {
            writeln!(out)?;
        }
        text::object(profile, &facts, out)?;
    }
    match is_first {
        true => Err(Failure::new(format_args!("no built-in CiA document describes 0x{index:04X}"))
            .help("`objdict profile list` lists the documents")),
        false => Ok(()),
    }
}

/// What a profile says of an object, of whichever logical device.
fn find(profile: &Profile, index: u16) -> Result<ObjectFacts<'_>, Failure> {
    let blocks = if profile.repeats { objdict_profile::MAX_BLOCKS } else { 1 };
    let found = (0..blocks).find_map(|block| profile.object_in(block, index));
    found.ok_or_else(|| {
        let document = &profile.document;
        let failure = Failure::new(format_args!("{document} does not define 0x{index:04X}"));
        let next = profile.objects().min_by_key(|facts| facts.first.abs_diff(index));
        match next {
            Some(next) => failure.help(format!("nearest: 0x{:04X} {}", next.first, next.name)),
            None => failure,
        }
    })
}
