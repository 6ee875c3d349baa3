//! Output as other programs read it: JSON by its schema, CSV in typed readers, Markdown in a strict
//! renderer, PNG by its colours. Text from outside has no effect in any of them, nor on a terminal.

use crate::common::{done, fixpath, written};
use fixpath::json::{SCHEMA, SCHEMA_VERSION};
use fixpath::units::UNITS;
use pulldown_cmark::{Event, Options, Parser, Tag};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fs;

fn json_of(args: &[&str]) -> Value {
    serde_json::from_str(&done(args)).unwrap()
}

const SMALL: &str = "[image]\nwidth = 24\nheight = 16\n[height]\nsource = \"brick\"\nscale = 3.0\n[[object]]\nshape = \"cube\"\n";

/// A JSON Schema with the keywords that ours uses. Any other keyword is an error, and so is a field
/// that the schema doesn't name.
struct Schema(Value);

impl Schema {
    fn check(&self, schema: &Value, value: &Value, place: &str) -> Result<(), String> {
        let schema = schema.as_object().unwrap();
        let fail = |why: &str| Err(format!("{place}: {why}: {}", excerpt(value)));
        for (keyword, of) in schema {
            match keyword.as_str() {
                "$schema"
                | "$id"
                | "$defs"
                | "title"
                | "description"
                | "required"
                | "additionalProperties" => {}
                "$ref" => {
                    let name = of.as_str().unwrap().strip_prefix("#/$defs/").unwrap();
                    self.check(&self.0["$defs"][name], value, place)?;
                }
                "const" if value == of => {}
                "enum" if of.as_array().unwrap().contains(value) => {}
                "const" | "enum" => return fail("isn't it"),
                "type" => {
                    let is = |name: &Value| match name.as_str().unwrap() {
                        "null" => value.is_null(),
                        "boolean" => value.is_boolean(),
                        "integer" => value.is_i64() || value.is_u64(),
                        "number" => value.is_number(),
                        "string" => value.is_string(),
                        "array" => value.is_array(),
                        "object" => value.is_object(),
                        other => panic!("type `{other}`"),
                    };
                    let known = of.as_array().map_or_else(|| is(of), |all| all.iter().any(is));
                    if !known {
                        return fail(&format!("isn't {of}"));
                    }
                }
                "anyOf" | "oneOf" => {
                    let tried = of.as_array().unwrap().iter();
                    let tried: Vec<_> = tried.map(|of| self.check(of, value, place)).collect();
                    let fits = tried.iter().filter(|tried| tried.is_ok()).count();
                    if fits == 0 || keyword == "oneOf" && fits > 1 {
                        let why: Vec<String> = tried.into_iter().filter_map(Result::err).collect();
                        return fail(&format!("fits {fits} of {}", why.join("; ")));
                    }
                }
                "items" => {
                    for (i, item) in value.as_array().into_iter().flatten().enumerate() {
                        self.check(of, item, &format!("{place}[{i}]"))?;
                    }
                }
                "properties" => {
                    let Some(fields) = value.as_object() else { continue };
                    for (name, field) in fields {
                        let place = format!("{place}.{name}");
                        match (of.get(name), schema.get("additionalProperties")) {
                            (Some(of), _) => self.check(of, field, &place)?,
                            (None, Some(others)) => self.check(others, field, &place)?,
                            (None, None) => return Err(format!("{place} isn't written down")),
                        }
                    }
                }
                other => panic!("{place}: keyword `{other}`"),
            }
        }
        if let (Some(required), Some(fields)) = (schema.get("required"), value.as_object()) {
            for name in required.as_array().unwrap() {
                if !fields.contains_key(name.as_str().unwrap()) {
                    return fail(&format!("has no {name}"));
                }
            }
        }
        Ok(())
    }
}

fn excerpt(value: &Value) -> String {
    value.to_string().chars().take(80).collect()
}

/// Every document of every command, and every file, matches the schema; each kind of document
/// occurs.
#[test]
fn every_json_document_keeps_to_the_schema() {
    let schema = Schema(serde_json::from_str(SCHEMA).unwrap());
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let mut seen = BTreeSet::new();
    let mut check = |what: &str, document: &Value| {
        let head: Vec<&String> = document.as_object().unwrap().keys().take(4).collect();
        assert_eq!(head, ["tool", "version", "document", "schema_version"], "{what}");
        assert_eq!(document["schema_version"], SCHEMA_VERSION, "{what}");
        let kind = document["document"].as_str().unwrap();
        schema.check(&schema.0, document, &format!("{what}: {kind}")).unwrap();
        seen.insert(kind.to_owned());
    };
    let list = json_of(&["list", "--json"]);
    schema.check(&schema.0, &list, "list").unwrap();
    for unit in list.as_array().unwrap() {
        check("list", unit);
        let name = unit["name"].as_str().unwrap();
        // The same parameters, and numbers as numbers.
        let parameters = unit["parameters"].as_array().unwrap();
        check("show", &json_of(&["show", name, "--json"]));
        let sim = json_of(&["sim", name, "--samples", "50", "--json"]);
        for parameter in parameters {
            let value = &sim["parameters"][parameter["name"].as_str().unwrap()];
            let number = parameter.get("min").is_some() && value != "auto";
            assert_eq!(value.is_number(), number, "{name}: {parameter} is {value}");
            let default = &parameter["default"];
            assert!(default == "auto" || default.is_number() == parameter.get("min").is_some());
        }
        check("sim", &sim);
        check("sim", &json_of(&["sim", name, "--hard", "--json", "--basis", "total"]));
    }
    check("sim", &json_of(&["sim", "bump", "--samples", "50", "--profile", "--json"]));
    let cone = ["sim", "rotation", "-p", "variant=corrected", "-p", "angle_bits=6", "--json"];
    check("cone", &json_of(&[&cone[..], &["--cone", "sin_theta_x"]].concat()));
    let shared = ["-p", "schedule=shared", "-p", "share_mul=1", "-p", "share_add=2"];
    check("schedule", &json_of(&[&["schedule", "illumination", "--json"][..], &shared].concat()));
    check("show", &json_of(&[&["show", "illumination", "--json"][..], &shared].concat()));
    check("schedule", &json_of(&["schedule", "rotation", "--json"]));
    let compare = ["compare", "--samples", "100", "--json"];
    check("compare", &json_of(&[&compare[..], &["--scenes", "none"]].concat()));
    let scene = written(folder.path(), "small.toml", SMALL);
    let scene = scene.to_str().unwrap();
    check("compare", &json_of(&[&compare[..], &["--scenes", scene, "-p", "exponent=8"]].concat()));

    let mut made = |args: &[&str], file: &str| {
        let out = path("out");
        let args = [args, &["--out", &out]].concat();
        let stdout = done(&args);
        let text = fs::read_to_string(folder.path().join("out").join(file)).unwrap();
        let value: Value = serde_json::from_str(&text).unwrap();
        if args.contains(&"--json") {
            assert_eq!(serde_json::from_str::<Value>(&stdout).unwrap(), value);
        }
        check(file, &value);
        fs::remove_dir_all(folder.path().join("out")).unwrap();
        value
    };
    let render = ["render", scene, "--json"];
    let figures = made(&[&render[..], &["-p", "table_addr_bits=6"]].concat(), "figures.json");
    for pipeline in figures["pipelines"].as_array().unwrap() {
        assert_eq!(pipeline["parameters"]["table_addr_bits"], 6);
        assert!(pipeline["parameters"]["exponent"].is_u64());
        assert_eq!(pipeline["parameters"]["rounding"], "half-up");
    }
    for more in [
        &["--pipelines", "tangent-smooth,tangent-faceted,exact-polar"][..],
        &["--pipelines", "emboss-gx,emboss-nv"],
        &["--pipelines", "exact-polar,kim", "--specialise"],
        &["--pipelines", "exact-polar", "--frames", "setup"],
    ] {
        made(&[&render[..], more].concat(), "figures.json");
    }
    let orbit = format!("{SMALL}[orbit]\nframes = 2\n");
    let orbit = written(folder.path(), "orbit.toml", &orbit);
    let args = ["render", orbit.to_str().unwrap(), "--pipelines", "exact-polar", "--json"];
    made(&args, "figures.json");
    let ladder = ["--ladder=5,22", "--exponents", "8"];
    let refusing = ["--pipelines", "printed", "-p", "guard_bits=8", "-p", "table_addr_bits=4"];
    made(&[&render[..], &ladder, &refusing].concat(), "ladder.json");
    made(&[&render[..], &["--ladder=8", "--pipelines", "emboss-gx"]].concat(), "ladder.json");
    let sweep = ["sweep", "bump", "--axis", "frac_bits=8,32", "-p", "guard_bits=8"];
    made(&[&sweep[..], &["--samples", "100"]].concat(), "sweep.json");
    made(&[&sweep[..], &["--scene", scene]].concat(), "sweep.json");

    let calls = "[[gx]]\ncall = \"SetTexCoordGen\"\ndst_coord = \"TEXCOORD0\"\nfunc = \"MTX2x4\"\nsrc_param = \"TEX0\"\nmat_idx = \"TEXMTX3\"\n\
                 [[gx]]\ncall = \"LoadRegister\"\ndst_coord = \"TEXCOORD1\"\nword = 0x290\n\
                 [[nv]]\ncall = \"ActiveTexture\"\ntexture = \"TEXTURE1\"\n\
                 [[nv]]\ncall = \"TexGen\"\ncoord = \"S\"\npname = \"TEXTURE_GEN_MODE\"\nparam = \"EMBOSS_MAP_NV\"\n\
                 [[nv]]\ncall = \"Enable\"\ncap = \"TEXTURE_GEN_S\"\n\
                 [[nv]]\ncall = \"ActiveTexture\"\ntexture = \"TEXTURE99\"\n";
    let calls = written(folder.path(), "calls.toml", calls);
    let output = fixpath().args(["texgen", calls.to_str().unwrap(), "--json"]).output().unwrap();
    check("texgen", &serde_json::from_slice(&output.stdout).unwrap());

    // The other kinds need external tools.
    let mut kinds: BTreeSet<String> = kinds(&schema).collect();
    for outside in ["cost", "verify"] {
        assert!(kinds.remove(outside), "{outside}");
    }
    assert_eq!(seen, kinds);
    assert_eq!(done(&["schema"]), SCHEMA);
}

/// Names of the documents of a schema.
fn kinds(schema: &Schema) -> impl Iterator<Item = String> {
    let all = schema.0["oneOf"].as_array().unwrap().iter();
    // A document without a name is a list of one kind.
    let names = all.filter_map(|of| of["$ref"].as_str());
    names.map(|name| name.trim_start_matches("#/$defs/document-").to_owned())
}

#[test]
#[ignore = "needs iverilog, ghdl, yosys and nextpnr-ice40: testbenches/run installs them"]
fn json_of_outside_tools_keeps_to_the_schema() {
    let schema = Schema(serde_json::from_str(SCHEMA).unwrap());
    for args in [
        &["verify", "dot", "--with", "icarus", "--vectors", "10", "--json"][..],
        &[
            "verify",
            "dot",
            "--with",
            "icarus,ghdl",
            "--vectors",
            "10",
            "--time-limit",
            "1",
            "--json",
        ],
        &["cost", "dot", "--target", "ice40", "--json"],
    ] {
        let value = serde_json::from_slice(&fixpath().args(args).output().unwrap().stdout).unwrap();
        schema.check(&schema.0, &value, &args.join(" ")).unwrap();
    }
}

/// The type that a typed reader infers from this field alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Type {
    Whole,
    Real,
    Truth,
    Text,
}

fn type_of(field: &str) -> Option<Type> {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let unsigned = field.strip_prefix('-').unwrap_or(field);
    match field {
        "" => None,
        "true" | "false" => Some(Type::Truth),
        "inf" | "-inf" | "NaN" => Some(Type::Real),
        _ if digits(unsigned) => Some(Type::Whole),
        // A point or an exponent; otherwise some readers take it for an integer.
        _ if field.parse::<f64>().is_ok() && unsigned.starts_with(|c: char| c.is_ascii_digit()) => {
            Some(Type::Real)
        }
        _ => Some(Type::Text),
    }
}

/// Every column has one type in all rows, and a name that is unique even without case.
fn check_csv(text: &str, what: &str) {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let names = reader.headers().unwrap().clone();
    let lower: BTreeSet<String> = names.iter().map(str::to_lowercase).collect();
    assert_eq!(lower.len(), names.len(), "{what}: {names:?}");
    assert!(!text.contains(['\r', '\t']) && text.ends_with('\n'), "{what}");
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    // One line per row: a reader may split the file at line ends.
    assert_eq!(text.lines().count(), 1 + rows.len(), "{what}");
    let different: BTreeSet<&str> = names.iter().collect();
    assert_eq!(different.len(), names.len(), "{what}: {names:?}");
    for (column, name) in names.iter().enumerate() {
        let types: BTreeSet<Type> = rows.iter().filter_map(|row| type_of(&row[column])).collect();
        assert!(types.len() < 2, "{what}: column `{name}` is {types:?}");
        let real = ["_db", "_abs", "_rad", "_mean", "_max", "_flip", "ssim", "_golden"];
        // A quantised value is beside its word; parameters have any names.
        let quantised = name
            .strip_suffix("_q")
            .is_some_and(|port| names.iter().any(|other| other == format!("{port}_raw")));
        let said = quantised || real.iter().any(|end| name.ends_with(end));
        let said = said && !types.is_empty();
        assert!(!said || types == [Type::Real].into(), "{what}: column `{name}` is {types:?}");
        for end in ["_px", "_bits", "_raw", "_codes", "_cycles"] {
            let whole = types.is_empty() || types == [Type::Whole].into();
            let auto = rows.iter().any(|row| matches!(&row[column], "auto" | "scene"));
            assert!(!name.ends_with(end) || whole || auto, "{what}: `{name}` is {types:?}");
        }
    }
}

#[test]
fn every_csv_has_a_type_for_each_column() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let scene = written(folder.path(), "a, \"b\".toml", SMALL);
    let scene = scene.to_str().unwrap();
    for unit in UNITS.iter() {
        // Exact units have integer errors and infinite signal-to-noise ratios.
        done(&["sim", &unit.name, "--hard", "--cases", &path("c.csv"), "--basis", "total"]);
        check_csv(&text("c.csv"), &format!("hard cases of {}", unit.name));
        let args = ["sweep", &unit.name, "--axis", "latency_cycles=auto", "--samples", "20"];
        let args = if unit.all_params().any(|param| param.name == "latency_cycles") {
            args
        } else {
            ["sweep", &unit.name, "--axis", "period_ps=2000,4000", "--samples", "20"]
        };
        done(&[&args[..], &["--out", &path("s"), "--fresh"]].concat());
        check_csv(&text("s/sweep.csv"), &format!("sweep of {}", unit.name));
        // Each error that isn't absolute names its reference.
        for (quantity, what) in unit.defaults().build().unwrap().scales() {
            assert!(
                text("s/report.md").contains(&format!("`{quantity}` over {what}")),
                "{quantity}"
            );
        }
    }
    let sweep = ["sweep", "bump", "--axis", "frac_bits=8,32", "-p", "guard_bits=8"];
    done(&[&sweep[..], &["--scene", scene, "--out", &path("p")]].concat());
    check_csv(&text("p/sweep.csv"), "sweep over a scene");
    let ladder = ["render", scene, "--ladder=5,22", "--exponents", "0,8", "--pipelines", "printed"];
    let more = ["-p", "guard_bits=8", "-p", "table_addr_bits=4", "--out", &path("l")];
    done(&[&ladder[..], &more].concat());
    check_csv(&text("l/ladder.csv"), "ladder");
    check_csv(&text("l/exponents.csv"), "exponents");
    let ladder = ["render", scene, "--ladder=8", "--pipelines", "emboss-gx"];
    done(&[&ladder[..], &["--out", &path("e")]].concat());
    check_csv(&text("e/ladder.csv"), "ladder of an emboss");
    // The list of scenes is split at commas.
    let other = written(folder.path(), "a \"b\".toml", SMALL);
    let (dot, scenes) =
        (written(folder.path(), "dot", SMALL), format!("{0},{0},", other.display()));
    let scenes = scenes + dot.to_str().unwrap();
    let compare = ["compare", "--samples", "100", "--scenes", &scenes];
    done(&[&compare[..], &["--out", &path("t.csv")]].concat());
    check_csv(&text("t.csv"), "compare");
    assert!(text("t.csv").starts_with("architecture,stage,"));
    let vectors = "phi_a,theta_a,phi_n,theta_n\n0,90,0,0\n45,45,0,30\n";
    let vectors = written(folder.path(), "v.csv", vectors);
    let eval = ["eval", "rotation", "--angle", "degrees", "--in", vectors.to_str().unwrap()];
    check_csv(&done(&[&eval[..], &["--out", "-"]].concat()), "eval");
}

/// Raw HTML, links and pictures of a Markdown text; every row of a table has as many cells as its
/// heading.
#[allow(clippy::wildcard_enum_match_arm, reason = "the enumeration is another crate's")]
fn marks(text: &str) -> (Vec<String>, Vec<String>) {
    let (mut html, mut links) = (Vec::new(), Vec::new());
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        match event {
            Event::Html(text) | Event::InlineHtml(text) => html.push(text.to_string()),
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                links.push(dest_url.to_string());
            }
            Event::Text(text) => {
                // A row that isn't recognised as part of a table.
                assert!(!text.contains("| ") || text.contains("|c"), "{text}");
            }
            _ => {}
        }
    }
    // The renderer pads and cuts rows, so their cells are counted here.
    let mut cells = Vec::new();
    for line in text.lines().chain([""]) {
        if line.starts_with('|') {
            let bars = line.replace("\\|", "").matches('|').count();
            cells.push(bars);
            assert_eq!(bars, cells[0], "{line}");
        } else {
            // A table needs an empty line before and after.
            assert!(cells.is_empty() || line.is_empty(), "{line}");
            cells.clear();
        }
    }
    (html, links)
}

/// Names that could act as markup, in every Markdown file; plots and tables still work.
#[test]
fn markdown_shows_names_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let name = "a|c <script>alert(1)<_script> *x* `y` [l](http:e) _z_\n\u{1b}[31m.toml";
    let scene = written(folder.path(), name, SMALL);
    let scene = scene.to_str().unwrap();
    let refusing = ["-p", "guard_bits=8", "-p", "table_addr_bits=4"];
    done(
        &[
            &[
                "render",
                scene,
                "--ladder=5,22",
                "--exponents",
                "8",
                "--pipelines",
                "printed",
                "--out",
                &path("l"),
            ][..],
            &refusing,
        ]
        .concat(),
    );
    done(&["render", scene, "--ladder=8", "--pipelines", "emboss-gx", "--out", &path("e")]);
    let sweep = ["sweep", "bump", "--axis", "frac_bits=8,32", "-p", "guard_bits=8"];
    done(&[&sweep[..], &["--scene", scene, "--out", &path("s")]].concat());
    done(&[&sweep[..], &["--samples", "100", "--out", &path("d")]].concat());
    done(&["compare", "--samples", "100", "--scenes", scene, "--out", &path("t.md")]);
    for (file, named) in [
        ("l/ladder.md", true),
        ("e/ladder.md", true),
        ("s/report.md", true),
        ("d/report.md", false),
        ("t.md", true),
    ] {
        let text = fs::read_to_string(folder.path().join(file)).unwrap();
        let (html, links) = marks(&text);
        assert!(html.is_empty(), "{file}: {html:?}");
        assert!(links.iter().all(|link| link.ends_with(".svg")), "{file}: {links:?}");
        assert!(!text.contains(|c: char| c.is_control() && c != '\n'), "{file}");
        assert!(!named || text.contains("a\\|c &lt;script&gt;alert(1)"), "{file}: {text}");
        for link in links {
            let svg = folder.path().join(file).parent().unwrap().join(link);
            let svg = fs::read_to_string(svg).unwrap();
            assert!(!svg.contains("<script") && !svg.contains('\u{1b}'), "{file}");
        }
    }
}

/// Text from outside is printed as it is: on one line in messages, with nothing hidden.
#[test]
fn nothing_from_outside_acts_on_a_terminal() {
    let folder = tempfile::tempdir().unwrap();
    let evil = "\u{1b}]0;x\u{7}\u{9b}2J\r\u{202e}y";
    let long = evil.repeat(2000);
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let file = |name: &str, text: &str| written(folder.path(), name, text).display().to_string();
    let in_toml: String = long.chars().map(|c| format!("\\U{:08x}", u32::from(c))).collect();
    let toml = |name: &str, text: &str| file(name, &text.replace("EVIL", &in_toml));
    let obj = file("m.obj", &format!("v 0 0 {long}\n"));
    let mesh = format!("[[object]]\nshape = \"mesh\"\nfile = \"{obj}\"\n");
    let evil_scene = file(&format!("{}.toml", evil), SMALL);
    let cases: Vec<Vec<String>> = [
        vec!["show", &long],
        vec!["show", "rotation", "-p", &long],
        vec!["show", "rotation", "-p", &format!("angle_bits={long}")],
        vec!["show", "rotation", "-p", &format!("{long}=1")],
        vec![&long],
        vec!["show", &format!("--{long}")],
        vec!["sim", "rotation", "--samples", &long],
        vec!["sim", "rotation", "--cone", &long],
        vec!["sim", "rotation", "--sampler", &long],
        vec!["sweep", "rotation", "--axis", &format!("angle_bits={long}"), "--out", &path("o")],
        vec!["sweep", "rotation", "--axis", &format!("{long}=1"), "--out", &path("o")],
        vec!["sweep", "rotation", "--axis", &long, "--out", &path("o")],
        vec!["eval", "rotation", "--in", &path(&format!("{evil}.csv")), "--out", &path("o.csv")],
        vec!["eval", "rotation", "--in", &file("h.csv", &format!("{long}\n1\n")), "--out", "-"],
        vec!["eval", "rotation", "--in", &file("r.csv", &format!("phi_a,theta_a,phi_n,theta_n\n1,{long},2,3\n")), "--out", "-"],
        vec!["wave", "rotation", "--signals", &long, "--out", &path("o.vcd")],
        vec!["wave", "rotation", "--cycles", &long, "--out", &path("o.vcd")],
        vec!["hdl", "rotation", "--name", &long, "--out", &path("o")],
        vec!["render", &long, "--out", &path("o")],
        vec!["render", &evil_scene, "--out", &path("o"), "--pipelines", &long],
        vec!["render", &evil_scene, "--out", &path("o"), "-p", &format!("{long}=3")],
        vec!["render", &evil_scene, "--out", &path("o"), &format!("--ladder={long}")],
        vec!["render", &evil_scene, "--out", &path(&format!("o{evil}")), "--pipelines", "exact-polar"],
        vec!["render", &evil_scene, "--out", &path("o"), "--pipelines", "exact-polar", "--ladder=8", "--exponents", "8"],
        vec!["render", &file("s.toml", &mesh), "--out", &path("o")],
        vec!["render", &toml("n.toml", "[texture]\nfile = \"EVIL\"\n[[object]]\nshape = \"cube\"\n"), "--out", &path("o")],
        vec!["render", &toml("t.toml", "[texture]\nsource = \"EVIL\"\n"), "--out", &path("o")],
        vec!["render", &toml("k.toml", "\"EVIL\" = 1\n"), "--out", &path("o")],
        vec!["render", &file("raw.toml", &format!("x = {long}\n")), "--out", &path("o")],
        vec!["texgen", &toml("g.toml", "[[gx]]\ncall = \"SetTexCoordGen\"\ndst_coord = \"EVIL\"\nfunc = \"EVIL\"\nsrc_param = \"EVIL\"\nmat_idx = \"EVIL\"\n")],
        vec!["texgen", &toml("v.toml", "[[nv]]\ncall = \"Enable\"\ncap = \"EVIL\"\n")],
        vec!["texgen", &toml("v.toml", "[[nv]]\ncall = \"Enable\"\ncap = \"EVIL\"\n"), "--json"],
        vec!["verify", "dot", "--with", &long],
        vec!["compare", "--scenes", &evil_scene, "--samples", "100"],
        vec!["compare", "--out", &format!("{long}.txt")],
    ]
    .into_iter()
    .map(|args| args.into_iter().map(str::to_owned).collect())
    .collect();
    for args in cases {
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let output = fixpath().args(&args).output().unwrap();
        let what: Vec<String> = args.iter().map(|a| a.chars().take(30).collect()).collect();
        for text in [&output.stdout, &output.stderr] {
            let text = String::from_utf8(text.clone()).unwrap();
            let hidden = |c: char| c != '\n' && (c.is_control() || c == '\u{202e}');
            assert!(!text.contains(hidden), "{what:?}: {text:?}");
            assert!(text.len() < 20_000, "{what:?}: {}", text.len());
        }
        let stderr = String::from_utf8(output.stderr).unwrap();
        let lines = stderr.lines().filter(|line| !line.starts_with("  tip: "));
        assert!(lines.count() < 2, "{what:?}: {stderr}");
        assert!(stderr.len() < 6000, "{what:?}: {stderr}");
        assert!(output.status.code().is_some_and(|code| code < 3), "{what:?}: {stderr}");
    }
}

/// Chunks of a PNG: name and data.
fn chunks(png: &[u8]) -> Vec<(String, Vec<u8>)> {
    let mut rest = &png[8..];
    let mut all = Vec::new();
    while !rest.is_empty() {
        let len = u32::from_be_bytes(rest[..4].try_into().unwrap()) as usize;
        let name = String::from_utf8(rest[4..8].to_vec()).unwrap();
        all.push((name, rest[8..8 + len].to_vec()));
        rest = &rest[12 + len..];
    }
    all
}

/// Each picture declares sRGB before its pixels, and is 8-bit RGB.
#[test]
fn pictures_say_what_their_codes_are() {
    let folder = tempfile::tempdir().unwrap();
    let scene = written(folder.path(), "small.toml", SMALL);
    let out = folder.path().join("out");
    let pipelines = ["--pipelines", "exact-polar,tangent-faceted"];
    let args = [&["render", scene.to_str().unwrap()][..], &pipelines, &["--out"]].concat();
    done(&[&args[..], &[out.to_str().unwrap()]].concat());
    let mut count = 0;
    for entry in fs::read_dir(&out).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|ending| ending != "png") {
            continue;
        }
        count += 1;
        let bytes = fs::read(&path).unwrap();
        let chunks = chunks(&bytes);
        let at = |name: &str| chunks.iter().position(|(known, _)| known == name).unwrap();
        assert!(at("sRGB") < at("IDAT") && at("gAMA") < at("IDAT") && at("cHRM") < at("IDAT"));
        assert_eq!(chunks[at("sRGB")].1, [0], "perceptual");
        assert_eq!(chunks[at("gAMA")].1, 45455u32.to_be_bytes());
        assert_eq!(chunks[at("IHDR")].1[8..], [8, 2, 0, 0, 0]);
    }
    assert!(count >= 10, "{count}");
}

/// Every field of the schema has a description.
#[test]
fn every_field_of_the_schema_is_described() {
    fn walk(of: &Map<String, Value>, place: &str, missing: &mut Vec<String>) {
        for (name, field) in of.get("properties").and_then(Value::as_object).into_iter().flatten() {
            let field = field.as_object().unwrap();
            let told = ["description", "$ref", "const"].iter().any(|key| field.contains_key(*key));
            if !told {
                missing.push(format!("{place}.{name}"));
            }
            walk(field, &format!("{place}.{name}"), missing);
            if let Some(items) = field.get("items").and_then(Value::as_object) {
                walk(items, &format!("{place}.{name}[]"), missing);
            }
        }
    }
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let mut missing = Vec::new();
    for (name, of) in schema["$defs"].as_object().unwrap() {
        walk(of.as_object().unwrap(), name, &mut missing);
    }
    assert!(missing.is_empty(), "{missing:#?}");
}
