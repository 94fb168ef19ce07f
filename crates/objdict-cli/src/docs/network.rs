//! Networks in `objdict docs`: their part of the index, and the DCFs of their nodes as `network build` writes them.

use std::path::Path;
use std::slice;

use super::super::args::DocsArgs;
use super::super::ending::{Failure, Outcome};
use super::super::files::InputFile;
use super::super::input::{Input, name_of};
use super::super::network;
use super::super::settings::CommandSettings;
use super::{Documented, described, file_name, reported};
use objdict_document::{Finding, SiteNetwork};
use objdict_format::input::Reading;
use objdict_network::{DcfgenMode, Overview, Timing, TimingOptions};
use objdict_network_file::BuiltFile;
use objdict_project::report::{Location, grouped};

/// A network with all that its index and the pages of its nodes need.
pub(super) struct DocumentedNetwork {
    file: String,
    overview: Overview,
    timing: Option<Timing>,
    pub(super) findings: Vec<Finding>,
    /// The nodes by their position in the network; `None` for one without a page.
    pub(super) nodes: Vec<Option<Documented>>,
}

impl DocumentedNetwork {
    /// Reads a network; `has_pages` says whether its nodes have pages. A node whose DCF cannot be written has none.
    pub(super) fn read(
        args: &DocsArgs,
        settings: &CommandSettings,
        file: &InputFile,
        has_pages: bool,
        outcome: &mut Outcome,
    ) -> Result<Self, Failure> {
        if file.path == Path::new("-") {
            let failure = Failure::new("a network cannot be read from the standard input");
            return Err(failure.help("name its file: the paths of descriptions are relative to it"));
        }
        if args.settings.node_id().is_some() {
            let message = format!("`{}` is a network, whose nodes have node-IDs", name_of(&file.path));
            return Err(Failure::new(message).help("omit `--node-id`"));
        }
        let options = settings.options(&file.path, file.project.as_deref());
        let input = args.network.with(&args.input.patch, args.settings.config_file());
        let opened = network::open(&file.path, &input)?;
        network::refuse_misread(&opened, slice::from_ref(&file.path))?;
        let findings = grouped(&opened, options.severities.apply(opened.check()));
        let findings = reported(&findings, |finding| Location::line_of((&opened).into(), finding));
        let unreadable = |error| {
            let help = format!("run `objdict network check {}` for the reason", name_of(&file.path));
            Failure::new(format_args!("`{}`: {error}", name_of(&file.path))).help(help)
        };
        let build = opened.build(DcfgenMode::Corrected).map_err(unreadable)?;
        let mut nodes: Vec<Option<Documented>> = Vec::new();
        nodes.resize_with(opened.network().map_or(0, |network| network.nodes.len()), || None);
        for (position, dcf) in build.each_dcf().filter(|_| has_pages) {
            let Some(node) = nodes.get_mut(position) else { continue };
            match dcf.map_err(Failure::new).and_then(|dcf| page(args, &options, dcf)) {
                Ok(page) => *node = page,
                Err(failure) => {
                    failure.print();
                    *outcome = Outcome::Failed;
                }
            }
        }
        let tag = args.lang.as_deref().unwrap_or("en");
        let overview = build.overview(tag);
        let timing = build.timing(&TimingOptions::default(), overview.language);
        Ok(Self { file: file_name(&file.path), overview, timing, findings, nodes })
    }

    /// The part of the index; `pages` are the names of the nodes' pages.
    pub(super) fn into_part(self, pages: Vec<Option<String>>) -> SiteNetwork {
        let Self { file, overview, timing, findings, .. } = self;
        SiteNetwork { overview, timing, file: Some(file), pages, findings: Some(findings) }
    }
}

/// The page of a node, of its DCF.
fn page(
    args: &DocsArgs,
    options: &objdict_lint::Options,
    BuiltFile { name, bytes }: BuiltFile,
) -> Result<Option<Documented>, Failure> {
    // the patches are in it
    let reading =
        Reading { from: None, device: None, encoding: None, patches: Vec::new(), ..args.input.reading() };
    Ok(match reading.read(&name, bytes)? {
        (_, Input::Description(description)) => Some(described(args, options, name, &description)),
        _ => None,
    })
}
