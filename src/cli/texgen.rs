//! `fixpath texgen`: calls to a texture-coordinate interface, and the configuration they make.

use super::text;
use crate::base::document::{Document, Lines};
use crate::base::error::{Error, Result};
use crate::base::{input, json};
use crate::shading::texgen::{Calls, Outcome, Setting};
use clap::Args;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;

/// Examples, and the format of the file.
pub(super) const HELP: &str = concat!(
    "Examples:\n  fixpath texgen calls.toml\n  fixpath texgen calls.toml --json\n\n",
    include_str!("../../docs/files/texgen.md")
);

#[derive(Args)]
pub(super) struct TexgenArgs {
    /// TOML file with the calls in order.
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,
    /// As JSON.
    #[arg(long)]
    json: bool,
}

/// Largest file to read: some 780 000 calls.
const MAX_BYTES: u64 = 16 << 20;

/// Runs the calls; returns the text to print, and an error if there are problems.
pub(super) fn run(args: &TexgenArgs) -> Result<(String, Option<Error>)> {
    let path = args.file.as_path();
    let toml = input::text(path, MAX_BYTES)?;
    let lines = Document { text: &toml, path }.lines();
    let calls = Calls::parse(&toml, path)?;
    if calls.is_empty() {
        let problem =
            "no calls: each is a table `[[gx]]` or `[[nv]]`; `fixpath help texgen` shows some";
        return Err(Error::file(path, problem.to_owned()));
    }
    let outcome = calls.run();
    let told =
        if args.json { json::text(&json_of(&lines, &outcome)) } else { told(&lines, &outcome) };
    let problems = outcome.problems();
    let wrong = (problems > 0).then(|| {
        let what = if problems == 1 { "problem" } else { "problems" };
        Error::file(path, format!("{problems} {what} in these calls"))
    });
    Ok((told, wrong))
}

fn told(lines: &Lines, outcome: &Outcome) -> String {
    let mut told = String::new();
    for api in [Setting::Gx, Setting::Nv] {
        let events = outcome.events.iter().filter(|event| event.api == api);
        let cells: Vec<Vec<String>> = events
            .map(|event| {
                let effect = match &event.outcome {
                    Ok(effect) => effect.clone(),
                    Err(refused) => format!("REFUSED: {}", refused.message),
                };
                let line = lines.of(event.span.start).to_string();
                vec![event.number.to_string(), line, event.call.clone(), effect]
            })
            .collect();
        if !cells.is_empty() {
            let _ = writeln!(told, "{api}");
            told.push_str(&text::table(&[">#", ">line", "call", "effect"], &cells));
        }
        if api == Setting::Gx {
            if let Some(broken) = &outcome.unfinished {
                let _ = writeln!(
                    told,
                    "  at the end: REFUSED: {broken}; registers are left out until it is complete"
                );
            }
            for advice in &outcome.advice {
                let _ = writeln!(told, "  note: {advice}");
            }
            for register in &outcome.registers {
                let _ = writeln!(
                    told,
                    "  register {:#06x} = {:#010x}  {}",
                    register.address, register.word, register.name
                );
            }
        }
        for emboss in outcome.emboss.iter().filter(|emboss| emboss.setting == api) {
            let _ = writeln!(told, "  emboss: {emboss}");
        }
        if api == Setting::Nv {
            for undefined in &outcome.undefined {
                let coords: Vec<String> =
                    undefined.coords.iter().map(|coord| format!("{coord:?}")).collect();
                let _ = writeln!(
                    told,
                    "  UNDEFINED: {} of texture unit {}",
                    coords.join(", "),
                    undefined.unit
                );
                for condition in &undefined.conditions {
                    let _ = writeln!(told, "    {condition}");
                }
            }
        }
    }
    told
}

fn json_of(lines: &Lines, outcome: &Outcome) -> Value {
    let calls: Vec<Value> = outcome
        .events
        .iter()
        .map(|event| {
            let mut call = json!({
                "api": event.api,
                "number": event.number,
                "line": lines.of(event.span.start),
                "call": event.call,
            });
            match &event.outcome {
                Ok(effect) => call["effect"] = json!(effect),
                Err(refused) => {
                    call["refused"] = json!(refused.message);
                    call["gl_error"] = json!(refused.gl_error);
                }
            }
            call
        })
        .collect();
    let undefined: Vec<Value> = outcome
        .undefined
        .iter()
        .map(|undefined| {
            let conditions: Vec<String> =
                undefined.conditions.iter().map(ToString::to_string).collect();
            json!({
                "texture_unit": undefined.unit,
                "coordinates": undefined.coords,
                "conditions": conditions,
            })
        })
        .collect();
    json::document(
        "texgen",
        json!({
            "calls": calls,
            "unfinished": outcome.unfinished.as_ref().map(ToString::to_string),
            "notes": outcome.advice.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "registers": outcome.registers,
            "emboss": outcome.emboss,
            "undefined": undefined,
            "problems": outcome.problems(),
        }),
    )
}
