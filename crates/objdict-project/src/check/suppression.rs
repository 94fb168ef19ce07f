//! Suppression of findings by comments.
//!
//! Comments apply wherever a file is checked, also in build scripts. A baseline belongs to a run over files, so
//! the command applies it. Both count the findings that they remove.

use super::comments::{Directive, directives};
use crate::registry;
use crate::registry::own::{INVALID_SUPPRESSION, UNUSED_SUPPRESSION, unknown_rule};
use objdict_format::{Description, Format, Syntax};
use objdict_lint::Options;
use objdict_model::diagnostic::{Diagnostic, Findings, Fix, RuleInfo, Selection, listing, say};
use objdict_model::source::Span;

/// Removes the findings that comments suppress, and returns findings about these comments.
pub(super) fn apply(description: &Description, options: &Options, findings: &mut Findings) -> Findings {
    let mut about = Findings::new();
    let text = description.source().text();
    let mut suppressions: Vec<Suppression> = directives(description)
        .into_iter()
        .filter_map(|directive| Suppression::new(text, directive, &mut about))
        .collect();
    if suppressions.is_empty() {
        return about;
    }
    findings.suppress(|finding| {
        let start = finding.labels.first().map_or(0, |label| description.span_of(&label.at).start);
        let mut is_allowed = false;
        // every comment that allows the finding is considered used
        for suppression in &mut suppressions {
            is_allowed |= suppression.allows(finding.rule, start);
        }
        is_allowed
    });
    // only one of a file's devices is checked here, so another one may use the comment
    if description.device_count() == 1 {
        let format = description.format();
        suppressions.iter().for_each(|suppression| suppression.report_unused(format, options, &mut about));
    }
    about
}

/// A comment that allows rules.
struct Suppression {
    directive: Directive,
    allowed: Vec<Allowed>,
}

/// A rule or group that a comment names.
struct Allowed {
    span: Span,
    rules: Selection,
    is_used: bool,
}

impl Suppression {
    fn new(text: &str, directive: Directive, about: &mut Findings) -> Option<Self> {
        let verb = directive.verb.of(text);
        if !verb.eq_ignore_ascii_case("allow") {
            let message = if verb.is_empty() {
                "the comment has no instruction for objdict".into()
            } else {
                say!("`{}` is not an objdict instruction", verb)
            };
            let finding = Diagnostic::new(&INVALID_SUPPRESSION, directive.text, message);
            about.push(finding.help("write `objdict: allow` followed by the ids of rules"));
            return None;
        }
        if directive.rules.is_empty() {
            let finding = Diagnostic::new(&INVALID_SUPPRESSION, directive.text, "the comment allows no rule");
            about.push(finding.help("add the rules after `allow`, such as `cia306/file-name`"));
            return None;
        }
        let mut allowed = Vec::new();
        for &span in &directive.rules {
            let name = span.of(text);
            match registry::select(name) {
                Some(rules) => allowed.push(Allowed { span, rules, is_used: false }),
                None => about.push(unknown_rule(span, name)),
            }
        }
        Some(Self { directive, allowed })
    }

    /// Whether the comment suppresses a finding that starts at an offset.
    fn allows(&mut self, rule: &RuleInfo, start: u32) -> bool {
        if self.directive.scope.is_some_and(|scope| !(scope.start..scope.end).contains(&start)) {
            return false;
        }
        let mut is_allowed = false;
        for allowed in self.allowed.iter_mut().filter(|allowed| allowed.rules.contains(rule)) {
            allowed.is_used = true;
            is_allowed = true;
        }
        is_allowed
    }

    fn report_unused(&self, format: Format, options: &Options, about: &mut Findings) {
        let is_unused = |allowed: &&Allowed| !allowed.is_used && is_active(allowed.rules, format, options);
        let unused: Vec<&Allowed> = self.allowed.iter().filter(is_unused).collect();
        let place = match self.directive.scope {
            None => "in this file",
            Some(_) => "in the following section",
        };
        if unused.len() == self.directive.rules.len() {
            let message = say!(
                "the comment allows {}, but there is no such finding {}",
                listing(unused.iter().map(|one| one.rules)),
                place
            );
            let finding = Diagnostic::new(&UNUSED_SUPPRESSION, self.directive.text, message);
            let fix = Fix::safe("remove the comment").replace(self.directive.removed, "");
            about.push(finding.help("remove the comment").fix(fix));
            return;
        }
        for allowed in unused {
            let rules = allowed.rules;
            let message = say!("the comment allows `{}`, but there is no such finding {}", rules, place);
            let finding = Diagnostic::new(&UNUSED_SUPPRESSION, allowed.span, message);
            let fix = Fix::safe(say!("remove `{}` from the comment", rules))
                .replace(self.with_gap(allowed.span), "");
            about.push(finding.help("remove the rule from the comment").fix(fix));
        }
    }

    /// The name of a rule with the separator to the next one; for the last one, with the separator before it.
    fn with_gap(&self, span: Span) -> Span {
        let rules = &self.directive.rules;
        let at = rules.iter().position(|rule| *rule == span).unwrap_or_default();
        match (rules.get(at + 1), at.checked_sub(1).and_then(|before| rules.get(before))) {
            (Some(next), _) => Span::new(span.start, next.start),
            (None, Some(before)) => Span::new(before.end, span.end),
            (None, None) => span,
        }
    }
}

/// Whether rules are checked in files of this format.
fn is_active(rules: Selection, format: Format, options: &Options) -> bool {
    let group = match rules {
        Selection::Group(group) => group,
        Selection::Rule(rule) => rule.group(),
    };
    !options.severities.is_off(rules)
        && match group {
            "portability" => !options.tools.is_empty() && format.syntax() == Syntax::Ini,
            "custom" => !options.profiles.is_empty(),
            _ => true,
        }
}
