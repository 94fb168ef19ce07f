//! The arguments of `objdict open`.

use std::path::PathBuf;

use crate::input::SizeArgs;
use crate::settings::ConfigFileArgs;

#[derive(Debug, clap::Args)]
pub(crate) struct OpenArgs {
    /// Files, folders and patterns such as `devices/**/*.eds`
    ///
    /// The page opens the files that you name. For folders, it lists all descriptions and networks except hidden files and files excluded
    /// by a `.gitignore`.
    #[arg(default_value = ".", value_name = "PATH")]
    pub files: Vec<PathBuf>,
    /// Port of the page on 127.0.0.1 [default: a free one]
    #[arg(long, value_name = "N", default_value_t = 0, hide_default_value = true)]
    pub port: u16,
    /// Print the address without starting a browser
    #[arg(long)]
    pub no_browser: bool,
    #[command(flatten)]
    pub size: SizeArgs,
    #[command(flatten)]
    pub config: ConfigFileArgs,
}
