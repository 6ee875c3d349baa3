//! The command line: see `fixpath --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    fixpath::main(&[])
}
