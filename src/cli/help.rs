//! `fixpath help`: the formats of files, from the pages that the documentation has, too.

use super::print::{print, printed};
use crate::base::error::{Error, Result, nearest};
use clap::{Args, Command};

/// Name and page of each format, except that of `texgen`, which is in the command's own help.
const FILES: &[(&str, &str)] = &[
    ("scene", include_str!("../../docs/files/scene.md")),
    ("netlist", include_str!("../../docs/files/netlist.md")),
    ("samples", include_str!("../../docs/files/samples.md")),
    ("memory", include_str!("../../docs/files/memory.md")),
];

#[derive(Args)]
pub(super) struct HelpArgs {
    /// A command, or a file format: scene, netlist, samples, memory, texgen.
    topic: Option<String>,
}

/// `whole` is the command line.
pub(super) fn run(args: &HelpArgs, mut whole: Command) -> Result<()> {
    let Some(topic) = args.topic.as_deref() else {
        return printed(whole.print_help());
    };
    if let Some((_, page)) = FILES.iter().find(|(name, _)| *name == topic) {
        return print(page);
    }
    if whole.find_subcommand(topic).is_none() {
        let commands = whole.get_subcommands().map(Command::get_name);
        let known = commands.chain(FILES.iter().map(|(name, _)| *name));
        let near = nearest(topic, known);
        return Err(Error::usage(format!(
            "there is no help on `{topic}`{near}: `fixpath help` lists the commands"
        )));
    }
    let told = whole.try_get_matches_from_mut(["fixpath", topic, "--help"]);
    printed(told.map_or_else(|help| help.print(), |_| Ok(())))
}
