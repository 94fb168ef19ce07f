//! The features of a new device as arguments of `objdict new`, made of [`FEATURES`].

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, ArgAction, ArgMatches, Command};

use objdict_format::scaffold::{FEATURES, Feature, FeatureKind, FeatureValue, Features};

/// The features that were given.
#[derive(Clone, Debug, Default)]
pub(crate) struct FeatureArgs(pub Features);

impl clap::Args for FeatureArgs {
    fn augment_args(command: Command) -> Command {
        FEATURES.iter().fold(command, |command, feature| command.arg(arg(feature)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl clap::FromArgMatches for FeatureArgs {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut args = Self::default();
        args.update_from_arg_matches(matches)?;
        Ok(args)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        for feature in FEATURES {
            let Some(value) = value(feature, matches) else { continue };
            let result = self.0.set(feature.word, &value);
            result.map_err(|error| clap::Error::raw(clap::error::ErrorKind::InvalidValue, error))?;
        }
        Ok(())
    }
}

fn arg(feature: &'static Feature) -> Arg {
    let heading = if feature.profiles.is_empty() { "Communication" } else { "Device profile" };
    let arg = Arg::new(feature.word).long(feature.word).help(feature.meaning).help_heading(heading);
    // the spelling of the documents beside that of CiA's object names
    let arg = match feature.word.strip_prefix("analog-") {
        Some(rest) => arg.alias(format!("analogue-{rest}")),
        None => arg,
    };
    match feature.kind {
        FeatureKind::Flag => arg
            .value_name("BOOL")
            .value_parser(clap::value_parser!(bool))
            .hide_possible_values(true)
            .num_args(0..=1)
            .require_equals(true)
            .default_missing_value("true"),
        FeatureKind::Number { lowest, highest } => arg
            .value_name("N")
            .value_parser(clap::value_parser!(i64).range(i64::from(lowest)..=i64::from(highest))),
        FeatureKind::Bits { .. } => {
            let names = feature.kind.names().into_iter().map(PossibleValue::new);
            let short = feature.kind.abbreviations().map(|short| PossibleValue::new(short).hide(true));
            let parser = PossibleValuesParser::new(names.chain(short));
            arg.value_name("NAME").value_parser(parser).value_delimiter(',').action(ArgAction::Append)
        }
        kind => arg.value_name("NAME").value_parser(PossibleValuesParser::new(kind.names())),
    }
}

fn value(feature: &Feature, matches: &ArgMatches) -> Option<FeatureValue> {
    let word = feature.word;
    Some(match feature.kind {
        FeatureKind::Flag => FeatureValue::Flag(*matches.get_one(word)?),
        FeatureKind::Number { .. } => FeatureValue::Number(*matches.get_one(word)?),
        FeatureKind::Bits { .. } => FeatureValue::Names(matches.get_many(word)?.cloned().collect()),
        _ => FeatureValue::Name(matches.get_one::<String>(word)?.clone()),
    })
}
