//! `fixpath help`: the formats of files, from the pages that the documentation has, too.

use super::command;
use super::print::{print, printed};
use crate::base::error::{Error, Result, nearest};
use clap::Args;

/// Name, what it is, and page of each format that has no command of its own name.
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

pub(super) fn run(args: &HelpArgs) -> Result<()> {
    let Some(topic) = args.topic.as_deref() else {
        return printed(command().print_help());
    };
    if let Some((_, page)) = FILES.iter().find(|(name, _)| *name == topic) {
        return print(page);
    }
    let mut whole = command();
    // Gives each command its full name, which its usage line shows.
    whole.build();
    match whole.find_subcommand_mut(topic) {
        Some(found) => printed(found.print_long_help()),
        None => {
            let commands = whole.get_subcommands().map(clap::Command::get_name);
            let known = commands.chain(FILES.iter().map(|(name, _)| *name));
            let near = nearest(topic, known);
            Err(Error::usage(format!(
                "there is no help on `{topic}`{near}: `fixpath help` lists the commands"
            )))
        }
    }
}
