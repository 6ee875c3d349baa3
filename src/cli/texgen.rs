//! `fixpath texgen`: calls to a texture-coordinate interface, and the configuration they make.

use super::text;
use crate::base::document::{self, Document, Lines};
use crate::base::error::{Error, Result};
use crate::base::json;
use crate::shading::texgen::{Calls, Outcome, Setting};
use clap::Args;
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::PathBuf;

/// Ends with a file that shows every kind of call.
pub(super) const HELP: &str = "\
Each call is checked against the rules of its interface. A call that breaks a rule has no effect and
is reported with its line. For OpenGL, only what GL_NV_texgen_emboss adds is checked: other commands
of OpenGL 1.x, what they enable, and planes are kept or passed on. Texture units whose coordinates
the extension leaves undefined are reported with every condition that fails. Exit code 2 if there is
any such problem. A file has at most 16 MiB. Each reported configuration is one of the unit `emboss`:
pass each of its words after a `-p` to sim, hdl, cost and so on.

Examples:
  fixpath texgen calls.toml
  fixpath texgen calls.toml --json

calls.toml, with one emboss coordinate in each interface:
  [[gx]]
  call = \"SetTexCoordGen\"          # GXSetTexCoordGen; names with or without GX_, GX_TG_
  dst_coord = \"TEXCOORD0\"          # TEXCOORD0 to TEXCOORD7
  func = \"MTX2x4\"                  # MTX2x4, MTX3x4, BUMP0 to BUMP7, SRTG
  src_param = \"TEX0\"               # POS, NRM, BINRM, TANGENT, TEX0…, TEXCOORD0…, COLOR0…
  mat_idx = \"TEXMTX3\"              # TEXMTX0 to TEXMTX9, IDENTITY, or a row

  [[gx]]
  call = \"LoadRegister\"            # the same by a register word: BUMP0 from TEXCOORD0
  dst_coord = \"TEXCOORD1\"
  word = 0x290

  [limits]                         # of [[nv]]; these are the defaults
  lights = 8
  texture_units = 4

  [[nv]]
  call = \"ActiveTexture\"
  texture = \"TEXTURE1\"             # emboss works in odd units only

  [[nv]]
  call = \"TexGen\"                  # likewise for S, T, R and Q
  coord = \"S\"
  pname = \"TEXTURE_GEN_MODE\"       # or EMBOSS_LIGHT_NV, EMBOSS_CONSTANT_NV, OBJECT_PLANE, EYE_PLANE
  param = \"EMBOSS_MAP_NV\"          # or LIGHT0, 0.0078125, [1, 0, 0, 0]

  [[nv]]
  call = \"Enable\"                  # or Disable; likewise for S, T, R and Q
  cap = \"TEXTURE_GEN_S\"            # or LIGHTING, LIGHT0, and other OpenGL capabilities

  [[nv]]
  call = \"GetTexGen\"
  coord = \"S\"
  pname = \"EMBOSS_LIGHT_NV\"";

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
    let toml = document::read(path, MAX_BYTES)?;
    let lines = Document { text: &toml, path }.lines();
    let calls = Calls::parse(&toml, path)?;
    if calls.is_empty() {
        let problem =
            "no calls: each is a table `[[gx]]` or `[[nv]]`; `fixpath texgen --help` shows some";
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
