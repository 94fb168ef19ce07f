//! The folder that `docker build` makes an image of: the static program, and nothing else of a system.

use super::{Built, copy, write};

const DOCKERFILE: &str = include_str!("Dockerfile");

/// `docker/`, with Dockerfile, program and licences.
pub(super) fn make(built: &Built) -> Result<(), String> {
    let folder = built.dist.join("docker");
    copy(&built.program, &folder.join("objdict"))?;
    built.licences(&folder)?;
    write(&folder.join("Dockerfile"), DOCKERFILE.as_bytes())
}
