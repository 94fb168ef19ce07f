//! All findings of a description: one call for the rules about the text and about the model, without the findings that
//! comments suppress.

#[cfg(feature = "full")]
mod causes;
mod comments;
pub(crate) mod conflict;
mod origin;
mod suppression;
mod variants;

use std::collections::BTreeSet;

use crate::compat;
use objdict_eds::eds;
use objdict_format::{Description, Format, Syntax};
use objdict_lint as lint;
use objdict_lint::{KnownObjects, Options};
use objdict_model::diagnostic::{Diagnostic, Findings, Reach};
use objdict_model::model::{Device, OBJDICTGEN_SECTION};

pub use self::comments::insertion;
pub use self::origin::{last_eds, with_origin_beside};
pub use self::variants::of_devices;

/// All findings of a description, in text order; errors in the keys of a `device.toml` come first.
pub fn check(description: &Description) -> Findings {
    check_with(description, &Options::default())
}

/// Like [`check`], with options.
pub fn check_with(description: &Description, options: &Options) -> Findings {
    in_order(description, unordered(description, options, None))
}

/// Like [`check_with`], reusing results for objects from before an edit.
#[cfg(feature = "lint")]
pub(crate) fn check_after(
    description: &Description,
    options: &Options,
    known: &mut KnownObjects,
) -> Findings {
    in_order(description, unordered(description, options, Some(known)))
}

fn in_order(description: &Description, mut findings: Findings) -> Findings {
    findings.sort_by_key(|finding| {
        let start = finding.labels.first().map_or(0, |label| description.span_of(&label.at).start);
        (!finding.is_key_error(), start, finding.rule.id)
    });
    findings
}

/// Like [`check_with`], but unordered, for counting findings: ordering them mostly costs time for finding
/// their lines.
pub fn check_unordered(description: &Description, options: &Options) -> Findings {
    unordered(description, options, None)
}

fn unordered(description: &Description, options: &Options, known: Option<&mut KnownObjects>) -> Findings {
    let check = |device: &Device, options: &Options| match known {
        Some(known) => lint::check_after(device, options, known),
        None => lint::check(device, options),
    };
    let is_xml = description.format().syntax() == Syntax::Xml;
    let mut findings = description.findings().clone();
    findings.append(description.text_findings());
    let mut findings = lint::without_disabled(description.described(), findings);
    if options.tools.is_empty() || is_xml {
        // the rules about other tools cover only the text formats of CiA 306
        let options = Options { tools: Vec::new(), ..options.clone() };
        findings.append(check(description.described(), &options));
        if !is_xml {
            findings = compat::without_readers(findings, description);
        }
    } else {
        let seen = description.seen_by_others();
        let device = seen.as_ref().unwrap_or_else(|| description.described());
        findings.append(check(device, options));
        findings.append(description.portability_findings(device));
        findings = compat::react(findings, description, &options.tools);
    }
    #[cfg(feature = "network")]
    findings.append(objdict_network_file::unreadable_configurations(description.device()));
    if let Some(origin) = description.origin() {
        findings.append(lint::check_configured(description.device(), origin.device()));
    }
    let findings = match description.document() {
        Some(document) => eds::findings::idle(document.text(), findings),
        None => findings,
    };
    let findings = without_fixes_of_lost(description, findings);
    #[cfg(feature = "xdd")]
    let findings = if is_xml {
        objdict_xdd::xdd::wording::of_xdd(findings, description.source().text(), |at| description.span_of(at))
    } else {
        findings
    };
    let findings = if is_of_objdictgen(description) {
        findings.filter_map(|finding| (!NOT_OF_OBJDICTGEN.contains(&finding.rule.id)).then_some(finding))
    } else {
        findings
    };
    let findings = if description.format() == Format::Toml { findings.filter_map(of_toml) } else { findings };
    let mut findings = options.severities.apply(findings);
    let about_comments = suppression::apply(description, options, &mut findings);
    findings.append(options.severities.apply(about_comments));
    let findings = conflict::alone(description, findings);
    #[cfg(feature = "full")]
    let findings = causes::named(description, findings);
    variants::named(description, findings)
}

/// Rules about content that objdictgen projects do not support, or that objdictgen itself determines: bit rates, flags,
/// and which objects of CiA documents are arrays.
const NOT_OF_OBJDICTGEN: [&str; 3] =
    ["cia306/no-baud-rate", "cia306/command-without-flag", "cia301/wrong-object-type"];

/// Author and date of a source are in its version control, and in the generated files.
const NOT_OF_TOML: &str = "cia306/missing-file-info-key";

/// A finding in the terms of `device.toml`; `None` for one that does not apply to a source.
fn of_toml(finding: Diagnostic) -> Option<Diagnostic> {
    #[cfg(feature = "full")]
    let finding = finding.in_words(objdict_format::device_toml::wording::words);
    (finding.rule.id != NOT_OF_TOML).then_some(finding)
}

/// Whether the text is a project of objdictgen.
fn is_of_objdictgen(description: &Description) -> bool {
    description.is_project()
        && description.device().extra.iter().any(|section| section.name() == OBJDICTGEN_SECTION)
}

/// Removes the fixes of findings that a lost header explains: the seemingly missing content is in the
/// previous section.
fn without_fixes_of_lost(description: &Description, findings: Findings) -> Findings {
    let is_header = |finding: &Diagnostic| {
        let line = finding.labels.first().map(|label| description.span_of(&label.at)).unwrap_or_default();
        line.of(description.source().text()).trim_end().ends_with(']')
    };
    let is_lost = |finding: &&Diagnostic| {
        let reaches = |reach| finding.rule.explains.iter().any(|explained| explained.reach == reach);
        reaches(Reach::Lost) || reaches(Reach::Header) && is_header(finding)
    };
    let explained = findings.iter().filter(is_lost).flat_map(|finding| finding.rule.explains);
    let rules: BTreeSet<&str> = explained.flat_map(|one| one.rules).copied().collect();
    if rules.is_empty() {
        return findings;
    }
    findings.filter_map(|mut finding| {
        finding.fix = finding.fix.filter(|_| !rules.contains(finding.rule.name()));
        Some(finding)
    })
}
