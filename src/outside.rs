//! Outside tools: whether they are there, what version they are, and running them with a
//! time limit.

use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// A program that others make.
#[derive(Debug)]
pub struct Tool {
    /// Its name to people.
    pub name: &'static str,
    /// The program.
    pub program: &'static str,
    /// Debian's package that brings it.
    pub package: &'static str,
    /// Arguments that make it print its version.
    pub version: &'static [&'static str],
}

/// Icarus Verilog.
pub const ICARUS: Tool =
    Tool { name: "icarus", program: "iverilog", package: "iverilog", version: &["-V"] };
/// Verilator.
pub const VERILATOR: Tool =
    Tool { name: "verilator", program: "verilator", package: "verilator", version: &["--version"] };
/// The compiler of what Verilator makes.
pub const CXX: Tool = Tool { name: "g++", program: "g++", package: "g++", version: &["--version"] };
/// What builds it.
pub const MAKE: Tool =
    Tool { name: "make", program: "make", package: "make", version: &["--version"] };
/// GHDL.
pub const GHDL: Tool =
    Tool { name: "ghdl", program: "ghdl", package: "ghdl", version: &["--version"] };
/// Yosys.
pub const YOSYS: Tool =
    Tool { name: "yosys", program: "yosys", package: "yosys", version: &["-V"] };
/// nextpnr for iCE40.
pub const NEXTPNR_ICE40: Tool = Tool {
    name: "nextpnr-ice40",
    program: "nextpnr-ice40",
    package: "nextpnr-ice40",
    version: &["--version"],
};
/// nextpnr for ECP5.
pub const NEXTPNR_ECP5: Tool = Tool {
    name: "nextpnr-ecp5",
    program: "nextpnr-ecp5",
    package: "nextpnr-ecp5",
    version: &["--version"],
};

impl Tool {
    /// Its version, as the first number with a dot that it prints; `None` if it isn't there.
    #[must_use]
    pub fn version(&self) -> Option<String> {
        // Some print their version and then fail.
        let output =
            Command::new(self.program).args(self.version).stdin(Stdio::null()).output().ok()?;
        let text = [output.stdout, output.stderr].concat();
        let text = String::from_utf8_lossy(&text);
        let number =
            |word: &&str| word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '.');
        Some(words.into_iter().find(number).unwrap_or("unknown").to_owned())
    }

    /// What to say where it is missing.
    #[must_use]
    pub fn missing(&self) -> String {
        format!("not found: `apt-get install {}` brings it", self.package)
    }
}

/// How a run ended.
#[derive(Debug)]
pub struct Outcome {
    /// Exit status; `None` if it was ended by a signal, or by the time limit.
    pub status: Option<i32>,
    /// True if it ran past the limit.
    pub timed_out: bool,
    /// What it printed.
    pub stdout: String,
    /// What it printed as errors and warnings.
    pub stderr: String,
    /// How long it ran.
    pub seconds: f64,
}

impl Outcome {
    /// True if it ended well.
    #[must_use]
    pub fn success(&self) -> bool {
        self.status == Some(0)
    }
}

/// Process groups that are running now.
static RUNNING: Mutex<BTreeSet<u32>> = Mutex::new(BTreeSet::new());

fn running() -> std::sync::MutexGuard<'static, BTreeSet<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends what is running; for a handler of interrupts, which ends the process next.
pub(crate) fn abandon() {
    running().iter().for_each(|id| end_group(*id));
}

/// Ends a process and all that it started.
fn end_group(id: u32) {
    // What is gone already is well.
    let _ = Command::new("kill").args(["-KILL", "--", &format!("-{id}")]).output();
}

/// Reads all, so that the writer never waits.
fn collect(mut from: impl Read + Send + 'static) -> thread::JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // A broken pipe is an end.
        let _ = from.read_to_end(&mut bytes);
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// What writes a program's standard input.
pub type Feed<'a> = dyn FnMut(&mut dyn Write) -> io::Result<()> + Send + 'a;

/// Runs a program in a folder. `feed` writes its standard input.
///
/// # Errors
/// If it can't be started.
///
/// # Panics
/// Never: its streams are piped.
pub fn run(
    program: &str,
    arguments: &[&str],
    folder: &Path,
    limit: Duration,
    feed: Option<&mut Feed<'_>>,
) -> Result<Outcome> {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.stdin(if feed.is_some() { Stdio::piped() } else { Stdio::null() });
    #[cfg(unix)]
    {
        // A group of its own: what it starts ends with it.
        use std::os::unix::process::CommandExt;
        command.process_group(0);
    }
    let start = Instant::now();
    let mut child =
        command.spawn().map_err(|why| Error::io(Path::new(program), "can't start", why))?;
    let id = child.id();
    running().insert(id);
    let stdout = collect(child.stdout.take().expect("bug: piped"));
    let stderr = collect(child.stderr.take().expect("bug: piped"));
    let stdin = child.stdin.take();
    let (status, timed_out) = thread::scope(|scope| {
        if let (Some(mut stdin), Some(feed)) = (stdin, feed) {
            // A program that stops reading says why by itself.
            scope.spawn(move || {
                let _ = feed(&mut stdin).and_then(|()| stdin.flush());
            });
        }
        wait(&mut child, start, limit)
    });
    running().remove(&id);
    let text = |thread: thread::JoinHandle<String>| thread.join().unwrap_or_default();
    Ok(Outcome {
        status,
        timed_out,
        stdout: text(stdout),
        stderr: text(stderr),
        seconds: start.elapsed().as_secs_f64(),
    })
}

fn wait(child: &mut Child, start: Instant, limit: Duration) -> (Option<i32>, bool) {
    let mut pause = Duration::from_millis(1);
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return (status.code(), false),
            Ok(None) if start.elapsed() < limit => {
                thread::sleep(pause);
                pause = (pause * 2).min(Duration::from_millis(50));
            }
            Ok(None) | Err(_) => {
                end_group(child.id());
                let _ = child.kill();
                let _ = child.wait();
                return (None, true);
            }
        }
    }
}
