//! `objdict completions` and `objdict man`: what packages bring along, made from the declaration of the arguments.

use clap::{Command, CommandFactory};
use clap_mangen::Man;

use super::args::{Args, CompletionsArgs, ManArgs};
use super::ending::{Failure, Outcome};
use super::stdout::Output;
use super::written_files::SaveFolder;

/// The completions of a shell.
pub(super) fn completions(args: &CompletionsArgs, out: &mut Output) -> Result<Outcome, Failure> {
    let mut command = <Args>::command();
    let name = command.get_name().to_owned();
    // the generator panics when it cannot write, and a vector always takes it
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut command, name, &mut text);
    std::io::Write::write_all(&mut out.raw()?, &text)?;
    Ok(Outcome::Clean)
}

/// The manual pages.
pub(super) fn man(args: &ManArgs) -> Result<Outcome, Failure> {
    let mut command = <Args>::command();
    command.build();
    let mut folder = SaveFolder::open(args.output(), "man", &args.overwrite)?;
    save_pages(&command, &mut folder)?;
    folder.finish()?;
    Ok(Outcome::Clean)
}

/// Saves the page of a command and those of its sub-commands, to which it refers.
fn save_pages(command: &Command, folder: &mut SaveFolder) -> Result<(), Failure> {
    let name = command.get_display_name().unwrap_or(command.get_name());
    folder.save(&format!("{name}.1"), &render(command)?)?;
    let mut commands = command.get_subcommands().filter(|command| !command.is_hide_set());
    commands.try_for_each(|command| save_pages(command, folder))
}

fn render(page: &Command) -> Result<Vec<u8>, Failure> {
    let source = concat!("objdict ", env!("CARGO_PKG_VERSION"));
    let mut text = format!(".\\\" Made by {source}; do not edit.\n").into_bytes();
    Man::new(page.clone()).manual("objdict").source(source).render(&mut text)?;
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_that_is_shown_has_a_page() {
        let folders = [tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap()];
        for folder in &folders {
            let args = ManArgs { output: Some(folder.path().to_owned()), ..ManArgs::default() };
            man(&args).unwrap();
        }
        let [page, again] = folders.each_ref().map(|folder| {
            let folder = folder.path();
            move |name: &str| std::fs::read_to_string(folder.join(name))
        });
        let main = page("objdict.1").unwrap();
        let check = page("objdict-check.1").unwrap();
        // no reference leads nowhere
        for file in std::fs::read_dir(folders[0].path()).unwrap().map(|file| file.unwrap().path()) {
            let text = std::fs::read_to_string(&file).unwrap().replace("\\-", "-");
            for (before, _) in text.match_indices("(1)").map(|(at, _)| text.split_at(at)) {
                let name = before.rsplit(|c: char| !c.is_ascii_alphanumeric() && c != '-').next().unwrap();
                assert!(
                    folders[0].path().join(format!("{name}.1")).exists(),
                    "{}: {name}(1)",
                    file.display()
                );
            }
        }
        assert!(main.contains("objdict\\-check(1)"), "{main}");
        assert!(check.contains("\\fB\\-\\-deny\\fR"), "{check}");
        assert!(page("objdict-man.1").is_err());
        assert_eq!(again("objdict-check.1").unwrap(), check, "the same pages each time");
    }
}
