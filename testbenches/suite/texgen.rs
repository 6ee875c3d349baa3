//! The two texture-coordinate interfaces: each rule is broken once, and its message is pinned.

use crate::common::{fixpath, told};
use fixpath::texgen::gx::{Function, IDENTITY, MATRIX_ROWS, Source, TexCoords, TexGen};
use fixpath::texgen::{Calls, Outcome};
use fixpath::units::Unit;
use proptest::prelude::*;
use std::fs;

fn run(toml: &str) -> Outcome {
    Calls::parse(toml, "calls.toml".as_ref()).unwrap_or_else(|why| panic!("{why}\n{toml}")).run()
}

/// `GXSetTexCoordGen`, with arguments in the order of the patent.
fn set(arguments: &[&str; 4]) -> String {
    let [dst, func, src, mat] = arguments;
    format!(
        "[[gx]]\ncall = \"SetTexCoordGen\"\ndst_coord = \"{dst}\"\nfunc = \"{func}\"\nsrc_param = \"{src}\"\nmat_idx = \"{mat}\"\n"
    )
}

fn gx(calls: &[[&str; 4]]) -> Outcome {
    run(&calls.iter().map(set).collect::<String>())
}

const BASE: [&str; 4] = ["TEXCOORD0", "MTX2x4", "TEX0", "TEXMTX3"];
const BUMP: [&str; 4] = ["TEXCOORD1", "BUMP0", "TEXCOORD0", "IDENTITY"];

/// Expects every call except the last to succeed, and the last to report `message` and to change
/// nothing.
fn gx_refuses(calls: &[[&str; 4]], message: &str) {
    let outcome = gx(calls);
    let (last, before) = outcome.events.split_last().unwrap();
    assert!(before.iter().all(|event| event.outcome.is_ok()), "{outcome:?}");
    assert_eq!(last.outcome.as_ref().unwrap_err().message, message, "{calls:?}");
    assert_eq!(outcome.problems(), 1, "{calls:?}");
    let without = gx(&calls[..calls.len() - 1]);
    assert_eq!(outcome.registers, without.registers, "{calls:?}");
    assert_eq!(outcome.emboss, without.emboss, "{calls:?}");
}

/// The example that the patent prints, and its register words.
#[test]
fn the_seeds_example_configures_the_emboss_unit() {
    let outcome = gx(&[
        ["GX_TEXCOORD0", "GX_TG_MTX2x4", "GX_TG_TEX0", "GX_TEXMTX3"],
        ["GX_TEXCOORD1", "GX_TG_BUMP0", "GX_TG_TEXCOORD0", "GX_IDENTITY"],
    ]);
    assert_eq!(outcome.problems(), 0);
    let words: Vec<(u16, u32)> = outcome.registers.iter().map(|r| (r.address, r.word)).collect();
    // Rows 39 and 60; two coordinates; texture row 5; emboss of coordinate 0 by light 0.
    let expected = [
        (0x1018, 39 << 6 | 60 << 12),
        (0x1019, 0),
        (0x103f, 2),
        (0x1040, 5 << 7),
        (0x1041, 5 << 7 | 1 << 4),
    ];
    assert_eq!(words, expected);
    assert_eq!(outcome.emboss.len(), 1);
    let told = "setting=gx light=0 source=0 destination=1 ks=1 kt=1";
    assert_eq!(outcome.emboss[0].to_string(), told);
}

#[test]
fn each_light_is_a_function_and_several_follow_one_base() {
    let mut calls = vec![BASE];
    let numbers = ["1", "2", "3", "4", "5", "6", "7"];
    let names: Vec<(String, String)> =
        numbers.iter().map(|i| (format!("TEXCOORD{i}"), format!("BUMP{i}"))).collect();
    calls.extend(names.iter().map(|(to, func)| [to, func, "TEXCOORD0", "IDENTITY"]));
    let outcome = gx(&calls);
    assert_eq!(outcome.problems(), 0, "{outcome:?}");
    let lights: Vec<(u32, u32)> = outcome.emboss.iter().map(|e| (e.destination, e.light)).collect();
    assert_eq!(lights, (1..8).map(|i| (i, i)).collect::<Vec<_>>());
    // A chain of displacements: the source is itself a displaced coordinate.
    let chain = gx(&[BASE, BUMP, ["TEXCOORD2", "BUMP7", "TEXCOORD1", "IDENTITY"]]);
    assert_eq!(chain.problems(), 0);
    assert_eq!((chain.emboss[1].source, chain.emboss[1].light), (1, 7));
}

#[test]
fn every_rule_of_a_single_coordinate_has_its_message() {
    let cases: &[([&str; 4], &str)] = &[
        (
            ["TEXCOORD8", "MTX2x4", "TEX0", "TEXMTX0"],
            "dst_coord TEXCOORD8: legal is TEXCOORD0 to TEXCOORD7",
        ),
        (
            ["TEXCORD0", "MTX2x4", "TEX0", "TEXMTX0"],
            "dst_coord `TEXCORD0`, did you mean `TEXCOORD0`: legal is TEXCOORD0 to TEXCOORD7",
        ),
        (
            ["TEXCOORD0", "BUMP8", "TEX0", "IDENTITY"],
            "func BUMP8: legal is BUMP0 to BUMP7, one for each of eight lights",
        ),
        (
            ["TEXCOORD0", "MTX4x4", "TEX0", "TEXMTX0"],
            "func `MTX4x4`, did you mean `MTX2x4`: legal is MTX2x4, MTX3x4, BUMP0 to BUMP7, SRTG",
        ),
        (["TEXCOORD0", "MTX2x4", "TEX8", "TEXMTX0"], "src_param TEX8: legal is TEX0 to TEX7"),
        (
            ["TEXCOORD0", "MTX2x4", "TEXCOORD7", "TEXMTX0"],
            "src_param TEXCOORD7: legal is TEXCOORD0 to TEXCOORD6",
        ),
        (
            ["TEXCOORD0", "SRTG", "COLOR2", "TEXMTX0"],
            "src_param COLOR2: legal is COLOR0 and COLOR1",
        ),
        (
            ["TEXCOORD0", "MTX2x4", "NORMAL", "TEXMTX0"],
            "src_param `NORMAL`: legal is POS, NRM, BINRM, TANGENT, TEX0 to TEX7, TEXCOORD0 to TEXCOORD6, COLOR0, COLOR1",
        ),
        (
            ["TEXCOORD0", "MTX2x4", "TEX0", "TEXMTX10"],
            "mat_idx TEXMTX10: legal is TEXMTX0 to TEXMTX9",
        ),
        (
            ["TEXCOORD0", "MTX2x4", "TEX0", "IDENTITIY"],
            "mat_idx `IDENTITIY`, did you mean `IDENTITY`: legal is TEXMTX0 to TEXMTX9, IDENTITY or a row from 0 to 63",
        ),
        (
            ["TEXCOORD0", "MTX3x4", "COLOR0", "TEXMTX0"],
            "MTX3x4 from COLOR0: a matrix transforms an attribute of the vertex, POS, NRM, BINRM, TANGENT or TEX0 to TEX7",
        ),
        (
            ["TEXCOORD1", "MTX2x4", "TEXCOORD0", "TEXMTX0"],
            "MTX2x4 from TEXCOORD0: a matrix transforms an attribute of the vertex, POS, NRM, BINRM, TANGENT or TEX0 to TEX7",
        ),
        (
            ["TEXCOORD1", "BUMP3", "TEX0", "IDENTITY"],
            "BUMP3 from TEX0: emboss displaces an already generated coordinate, TEXCOORD0 to TEXCOORD6",
        ),
        (
            ["TEXCOORD0", "SRTG", "TEX0", "IDENTITY"],
            "SRTG from TEX0: coordinates from lighting channels come from COLOR0 or COLOR1",
        ),
        // Numbers in tokens have no leading zeros and no signs; messages show them as given.
        (
            ["TEXCOORD01", "MTX2x4", "TEX0", "TEXMTX0"],
            "dst_coord `TEXCOORD01`, did you mean `TEXCOORD0`: legal is TEXCOORD0 to TEXCOORD7",
        ),
        (
            ["GX_TEXCOORD+1", "MTX2x4", "TEX0", "TEXMTX0"],
            "dst_coord `GX_TEXCOORD+1`, did you mean `TEXCOORD0`: legal is TEXCOORD0 to TEXCOORD7",
        ),
        (
            ["TEXCOORD1", "BUMP00", "TEXCOORD0", "IDENTITY"],
            "func `BUMP00`, did you mean `BUMP0`: legal is MTX2x4, MTX3x4, BUMP0 to BUMP7, SRTG",
        ),
        (
            ["TEXCOORD1", "BUMP0", "TEXCOORD00", "IDENTITY"],
            "src_param `TEXCOORD00`, did you mean `TEXCOORD0`: legal is POS, NRM, BINRM, TANGENT, TEX0 to TEX7, TEXCOORD0 to TEXCOORD6, COLOR0, COLOR1",
        ),
        (
            ["TEXCOORD0", "MTX2x4", "TEX0", "TEXMTX01"],
            "mat_idx `TEXMTX01`, did you mean `TEXMTX0`: legal is TEXMTX0 to TEXMTX9, IDENTITY or a row from 0 to 63",
        ),
        (
            ["TEXCOORD0", "MTX2x4", "GX_TG_TEX99999999999999999999", "TEXMTX0"],
            "src_param GX_TG_TEX99999999999999999999: legal is TEX0 to TEX7",
        ),
    ];
    for (call, message) in cases {
        gx_refuses(&[*call], message);
    }
    gx_refuses(
        &[BASE, ["TEXCOORD1", "BUMP0", "TEXCOORD0", "TEXMTX1"]],
        "BUMP0 with matrix TEXMTX1: no matrix is used for a displaced coordinate, give IDENTITY",
    );
    let past = |func: &str, row: u8, rows: u8| {
        format!(
            "{func} with matrix row {row}: its {rows} rows end at row {}, and the last row is 63: start it at row {} or below",
            row + rows - 1,
            64 - rows
        )
    };
    let range = |row| Some(format!("mat_idx {row}: legal is a row from 0 to 63"));
    for (func, row, message) in [
        ("MTX2x4", "64", range("64")),
        ("MTX2x4", "-1", range("-1")),
        ("MTX2x4", "63", Some(past("MTX2x4", 63, 2))),
        ("MTX2x4", "62", None),
        ("MTX3x4", "63", Some(past("MTX3x4", 63, 3))),
        ("MTX3x4", "62", Some(past("MTX3x4", 62, 3))),
        ("MTX3x4", "61", None),
        ("MTX3x4", "0", None),
    ] {
        let outcome = run(&set(&["TEXCOORD0", func, "TEX0", "x"]).replace("\"x\"", row));
        let refused = outcome.events[0].outcome.as_ref().err().map(|why| why.message.clone());
        assert_eq!(refused, message);
    }
}

#[test]
fn every_rule_between_coordinates_has_its_message() {
    for (to, from) in
        [("TEXCOORD0", "TEXCOORD0"), ("TEXCOORD1", "TEXCOORD1"), ("TEXCOORD1", "TEXCOORD6")]
    {
        gx_refuses(
            &[BASE, [to, "BUMP0", from, "IDENTITY"]],
            &format!(
                "{to} from {from}: coordinates are generated in the order of their numbers, so emboss needs a source with a lower number"
            ),
        );
    }
    gx_refuses(
        &[BUMP],
        "TEXCOORD1 from TEXCOORD0, which no call has set: set the base coordinate first",
    );
    let order = "coordinates from lighting channels (SRTG) come after all others";
    let color = ["TEXCOORD0", "SRTG", "COLOR0", "IDENTITY"];
    gx_refuses(
        &[color, ["TEXCOORD1", "MTX3x4", "POS", "TEXMTX0"]],
        &format!("TEXCOORD1 (MTX3x4) after TEXCOORD0 (SRTG): {order}"),
    );
    gx_refuses(&[color, BUMP], &format!("TEXCOORD1 (BUMP0) after TEXCOORD0 (SRTG): {order}"));
    // An existing setting may not be changed if that breaks another rule.
    gx_refuses(&[BASE, BUMP, color], &format!("TEXCOORD1 (BUMP0) after TEXCOORD0 (SRTG): {order}"));
}

/// With two bases that have one bump each, the patents' two "should" rules can't both be kept.
/// Either order is legal, and is noted.
#[test]
fn two_bases_each_have_their_bump_in_either_order() {
    let advice = |calls: &[[&str; 4]]| -> Vec<String> {
        let outcome = gx(calls);
        assert_eq!(outcome.problems(), 0, "{outcome:?}");
        assert_eq!(outcome.registers.len(), 3 + calls.len());
        outcome.advice.iter().map(ToString::to_string).collect()
    };
    let base = |to| [to, "MTX2x4", "TEX1", "IDENTITY"];
    let bump = |to, func, from| [to, func, from, "IDENTITY"];
    // Each bump after its base.
    let pairs = [BASE, BUMP, base("TEXCOORD2"), bump("TEXCOORD3", "BUMP1", "TEXCOORD2")];
    let order = "TEXCOORD2 (MTX2x4) after TEXCOORD1 (BUMP0): transformed coordinates should come before all bump coordinates";
    assert_eq!(advice(&pairs), [order]);
    let of: Vec<String> = gx(&pairs).emboss.iter().map(ToString::to_string).collect();
    assert_eq!(
        of,
        [
            "setting=gx light=0 source=0 destination=1 ks=1 kt=1",
            "setting=gx light=1 source=2 destination=3 ks=1 kt=1"
        ]
    );
    // Both bases first.
    let bases = [
        BASE,
        base("TEXCOORD1"),
        bump("TEXCOORD2", "BUMP0", "TEXCOORD0"),
        bump("TEXCOORD3", "BUMP1", "TEXCOORD1"),
    ];
    let apart = |to: u8, from: u8, between: u8, is: &str| {
        format!(
            "TEXCOORD{to} from TEXCOORD{from}: base and displaced coordinate should be numbered n and n + 1, but TEXCOORD{between} between them is {is}"
        )
    };
    assert_eq!(
        advice(&bases),
        [apart(2, 0, 1, "MTX2x4 from TEX1"), apart(3, 1, 2, "BUMP0 from TEXCOORD0")]
    );
    // Orders that the patents recommend need no note; nor do several lights over one base.
    assert!(advice(&[BASE, BUMP, bump("TEXCOORD2", "BUMP1", "TEXCOORD0")]).is_empty());
    // The order of the calls doesn't matter: a gap counts only at the end.
    let [first, second, third, fourth] = bases;
    assert_eq!(advice(&[first, third, second, fourth]), advice(&bases));
    assert_eq!(gx(&[first, third]).problems(), 1);
    let text: String = pairs.iter().map(set).collect();
    let (code, stdout, _) = command(&text, &[]);
    assert_eq!(code, 0);
    assert!(stdout.contains(&format!("  note: {order}\n")), "{stdout}");
    let told: serde_json::Value = serde_json::from_str(&command(&text, &["--json"]).1).unwrap();
    assert_eq!(told["notes"], serde_json::json!([order]));
}

#[test]
fn a_gap_is_told_once_all_calls_are_made() {
    let above = ["TEXCOORD3", "SRTG", "COLOR1", "IDENTITY"];
    let outcome = gx(&[BASE, above]);
    assert!(outcome.events.iter().all(|event| event.outcome.is_ok()));
    let message = "TEXCOORD1 is not set, but TEXCOORD3 is: number coordinates from 0 without a gap";
    assert_eq!(outcome.unfinished.as_ref().unwrap().to_string(), message);
    assert_eq!(outcome.problems(), 1);
    // Its registers would announce two coordinates, but hold words of the first and the fourth.
    assert!(outcome.registers.is_empty(), "{:?}", outcome.registers);
    let toml = format!("{}{}", set(&BASE), set(&above));
    let (code, stdout, _) = command(&toml, &[]);
    assert_eq!(code, 2);
    assert!(stdout.contains(message) && !stdout.contains("  register 0x"), "{stdout}");
    let told: serde_json::Value = serde_json::from_str(&command(&toml, &["--json"]).1).unwrap();
    assert_eq!(
        (&told["unfinished"], &told["registers"]),
        (&message.into(), &serde_json::json!([]))
    );
    // If all are filled, from the last to the first, there is nothing to report.
    let fill = |to| [to, "MTX2x4", "TEX1", "TEXMTX1"];
    assert_eq!(gx(&[above, fill("TEXCOORD2"), fill("TEXCOORD1"), BASE]).problems(), 0);
}

/// Every legal way to generate a coordinate.
fn all_generated() -> Vec<TexGen> {
    let sources = [Source::Pos, Source::Nrm, Source::Binrm, Source::Tangent]
        .into_iter()
        .chain((0..=u8::MAX).map(Source::Tex))
        .chain((0..=u8::MAX).map(Source::TexCoord))
        .chain((0..=u8::MAX).map(Source::Color));
    let functions = [Function::Mtx2x4, Function::Mtx3x4, Function::Srtg]
        .into_iter()
        .chain((0..=u8::MAX).map(Function::Bump));
    let functions: Vec<Function> = functions.collect();
    let mut all = Vec::new();
    for source in sources {
        for function in &functions {
            for matrix in [0, 30, IDENTITY, MATRIX_ROWS - 1, MATRIX_ROWS, u8::MAX] {
                all.extend(TexGen::new(*function, source, matrix));
            }
        }
    }
    all
}

#[test]
fn register_words_hold_every_legal_coordinate() {
    let all = all_generated();
    // 12 attributes with 2 matrix types at 3 rows, since no matrix starts at the last row; 2
    // colours at 4 rows; 8 lights over 7 coordinates with IDENTITY.
    assert_eq!(all.len(), 2 * 12 * 3 + 2 * 4 + 8 * 7);
    for generated in all {
        assert_eq!(TexGen::unpack(generated.pack(), generated.matrix()), Ok(generated));
    }
}

#[test]
fn register_words_are_legal_or_refused_over_every_field() {
    let legal = (0..1_u32 << 18).filter(|word| match TexGen::unpack(*word, IDENTITY) {
        Ok(generated) => {
            assert_eq!(generated.pack(), *word, "{generated:?}");
            true
        }
        Err(why) => {
            assert!(why.to_string().contains(": "), "{why}");
            false
        }
    });
    assert_eq!(legal.count(), 2 * 12 + 2 + 8 * 7);
}

#[test]
fn every_field_of_a_register_word_is_checked() {
    let cases = [
        (0x0000_0001 | 5 << 7, "word 0x00000281: bits 0 (unused) are 1, legal is 0 here"),
        (
            5 << 7 | 1 << 2,
            "word 0x00000284: bits 2-3 (form of the input) are 1, legal is 1 for vectors, 0 for all else",
        ),
        (
            0,
            "word 0x00000000: bits 2-3 (form of the input) are 0, legal is 1 for vectors, 0 for all else",
        ),
        (
            5 << 7 | 2 << 2,
            "word 0x00000288: bits 2-3 (form of the input) are 2, legal is 1 for vectors, 0 for all else",
        ),
        (5 << 7 | 4 << 4, "word 0x000002c0: bits 4-6 (kind) are 4, legal is 0 to 3"),
        (13 << 7, "word 0x00000680: bits 7-11 (row of the source) are 13, legal is 0 to 12"),
        (
            6 << 7 | 1 << 4,
            "word 0x00000310: bits 7-11 (row of the source) are 6, legal is 5 with emboss",
        ),
        (
            5 << 7 | 1 << 4 | 7 << 12,
            "word 0x00007290: bits 12-14 (displaced coordinate) are 7, legal is 0 to 6",
        ),
        (
            5 << 7 | 1 << 12,
            "word 0x00001280: bits 12-14 (displaced coordinate) are 1, legal is 0 here",
        ),
        (5 << 7 | 3 << 15, "word 0x00018280: bits 15-17 (light of emboss) are 3, legal is 0 here"),
        (5 << 7 | 1 << 4 | 1 << 1, "word 0x00000292: bits 1 (projection) are 1, legal is 0 here"),
        (5 << 7 | 1 << 18, "word 0x00040280: bits 18-31 (unused) are 1, legal is 0 here"),
        (5 << 7 | 1 << 31, "word 0x80000280: bits 18-31 (unused) are 8192, legal is 0 here"),
        (
            5 << 7 | 2 << 4,
            "SRTG from TEX0: coordinates from lighting channels come from COLOR0 or COLOR1",
        ),
        (
            2 << 7,
            "MTX2x4 from COLOR0: a matrix transforms an attribute of the vertex, POS, NRM, BINRM, TANGENT or TEX0 to TEX7",
        ),
    ];
    for (word, message) in cases {
        assert_eq!(TexGen::unpack(word, IDENTITY).unwrap_err().to_string(), message);
        let toml =
            format!("[[gx]]\ncall = \"LoadRegister\"\ndst_coord = \"TEXCOORD0\"\nword = {word}\n");
        assert_eq!(run(&toml).events[0].outcome.as_ref().unwrap_err().message, message);
    }
}

#[test]
fn a_register_word_has_32_bits() {
    for (word, told) in
        [(-1_i64, "-1"), (1 << 32, "4294967296"), (i64::MIN, "-9223372036854775808")]
    {
        let call =
            format!("[[gx]]\ncall = \"LoadRegister\"\ndst_coord = \"TEXCOORD0\"\nword = {word}\n");
        let outcome = run(&format!("{}{call}", set(&BASE)));
        let message = format!("word {told}: legal is a word of 32 bits, 0 to 0xffffffff");
        assert_eq!(outcome.events[1].outcome.as_ref().unwrap_err().message, message);
        assert_eq!(outcome.events[1].call, format!("LoadRegister(TEXCOORD0, {told})"));
        assert_eq!(outcome.registers, gx(&[BASE]).registers);
    }
}

proptest! {
    #[test]
    fn any_word_is_refused_or_packs_again(word: u32, matrix: u8) {
        if let Ok(generated) = TexGen::unpack(word, matrix) {
            prop_assert_eq!(generated.pack(), word);
        }
    }

    /// For any calls in any order, all rules hold for the result.
    #[test]
    fn no_order_of_calls_leaves_a_broken_rule(
        calls in proptest::collection::vec((0..8_u8, 0..4_usize, 0..8_u8, 0..7_u8), 0..40)
    ) {
        let mut state = TexCoords::default();
        for (to, kind, light, from) in calls {
            let (function, source) = match kind {
                0 => (Function::Mtx2x4, Source::Tex(from)),
                1 | 2 => (Function::Bump(light), Source::TexCoord(from)),
                _ => (Function::Srtg, Source::Color(from % 2)),
            };
            let _ = state.set(to, TexGen::new(function, source, IDENTITY).unwrap());
        }
        let set: Vec<(u8, TexGen)> = state.iter().collect();
        prop_assert!(set.is_sorted_by_key(|(_, is)| is.function() == Function::Srtg));
        for (to, generated) in &set {
            if let Source::TexCoord(from) = generated.source() {
                prop_assert!(from < *to && state.get(from).is_some());
            }
        }
    }
}

/// One call of the NV interface from `name key=value …`; numbers stay numbers.
fn nv_call(line: &str) -> String {
    let mut words = line.split_whitespace();
    let mut toml = format!("[[nv]]\ncall = \"{}\"\n", words.next().unwrap());
    for word in words {
        let (key, value) = word.split_once('=').unwrap();
        let number = key == "param" && (value.parse::<f64>().is_ok() || value.starts_with("0x"));
        toml +=
            &if number { format!("{key} = {value}\n") } else { format!("{key} = \"{value}\"\n") };
    }
    toml
}

fn nv(calls: &str) -> Outcome {
    run(&calls.lines().filter(|line| !line.trim().is_empty()).map(nv_call).collect::<String>())
}

fn nv_limits(limits: &str, calls: &str) -> Outcome {
    let calls = calls.lines().filter(|line| !line.trim().is_empty()).map(nv_call);
    run(&format!("[limits]\n{limits}\n{}", calls.collect::<String>()))
}

/// All conditions of a defined result in unit 1.
const DEFINED: &str = "
    ActiveTexture texture=TEXTURE1
    TexGen coord=S pname=TEXTURE_GEN_MODE param=EMBOSS_MAP_NV
    TexGen coord=T pname=TEXTURE_GEN_MODE param=EMBOSS_MAP_NV
    TexGen coord=R pname=TEXTURE_GEN_MODE param=EMBOSS_MAP_NV
    TexGen coord=Q pname=TEXTURE_GEN_MODE param=EMBOSS_MAP_NV
    Enable cap=TEXTURE_GEN_S
    Enable cap=TEXTURE_GEN_T
    Enable cap=TEXTURE_GEN_R
    Enable cap=TEXTURE_GEN_Q
    Enable cap=LIGHTING
    Enable cap=LIGHT0
";

#[test]
fn a_texture_unit_with_all_conditions_met_configures_the_emboss_unit() {
    let outcome = nv(DEFINED);
    assert_eq!(outcome.problems(), 0, "{outcome:?}");
    let told = "setting=nv light=0 source=0 destination=1 ks=1 kt=1";
    assert_eq!(outcome.emboss[0].to_string(), told);
    let set = "
        TexGen coord=S pname=EMBOSS_CONSTANT_NV param=0.0078125
        TexGen coord=T pname=GL_EMBOSS_CONSTANT_NV param=-2
        TexGen coord=S pname=EMBOSS_LIGHT_NV param=GL_LIGHT7
        TexGen coord=GL_T pname=EMBOSS_LIGHT_NV param=0x4007
        Enable cap=GL_LIGHT7
        Disable cap=LIGHT0
    ";
    let outcome = nv(&format!("{DEFINED}{set}"));
    assert_eq!(outcome.problems(), 0, "{outcome:?}");
    let told = "setting=nv light=7 source=0 destination=1 ks=0.0078125 kt=-2";
    assert_eq!(outcome.emboss[0].to_string(), told);
    let third = DEFINED.replace("TEXTURE1", "TEXTURE3");
    assert_eq!(nv(&third).emboss[0].source, 2);
    // Tokens by their numbers, as listed in the extension.
    let numbers = DEFINED.replace("EMBOSS_MAP_NV", "0x855F");
    assert_eq!(nv(&numbers).emboss, nv(DEFINED).emboss);
    // Floats too: the extension has TexGen{ifd}.
    let light = |param| {
        let calls =
            ["S", "T"].map(|c| format!("TexGen coord={c} pname=EMBOSS_LIGHT_NV param={param}\n"));
        format!("{DEFINED}Enable cap=LIGHT7\n{}", calls.concat())
    };
    let floats = light("16384.0").replace("EMBOSS_MAP_NV", "34143.0");
    assert_eq!(nv(&floats).emboss, nv(DEFINED).emboss);
    assert_eq!(nv(&light("16391.0")).emboss[0].light, 7);
    let last = nv_limits("lights = 32", &light("16415.0").replace("LIGHT7", "LIGHT31"));
    assert_eq!((last.problems(), last.emboss[0].light), (0, 31), "{last:?}");
}

#[test]
fn initial_values_are_those_of_the_state_table() {
    for unit in 0..4 {
        for coord in ["S", "T", "R", "Q"] {
            for (pname, value) in [
                ("TEXTURE_GEN_MODE", "EYE_LINEAR"),
                ("EMBOSS_CONSTANT_NV", "1"),
                ("EMBOSS_LIGHT_NV", "LIGHT0"),
            ] {
                let outcome = nv(&format!(
                    "ActiveTexture texture=TEXTURE{unit}\nGetTexGen coord={coord} pname={pname}"
                ));
                let told = outcome.events[1].outcome.as_ref().unwrap();
                assert_eq!(*told, format!("unit {unit}: {pname} of {coord} = {value}"));
            }
        }
    }
}

#[test]
fn every_error_of_the_extension_has_its_message() {
    let odd = "ActiveTexture texture=TEXTURE1\n";
    let even = "ActiveTexture texture=TEXTURE2\n";
    let cases = [
        (
            even,
            "TexGen coord=S pname=TEXTURE_GEN_MODE param=EMBOSS_MAP_NV",
            "INVALID_ENUM: EMBOSS_MAP_NV with texture unit 2 active: only odd units accept it",
        ),
        (
            even,
            "TexGen coord=Q pname=TEXTURE_GEN_MODE param=0x855F",
            "INVALID_ENUM: EMBOSS_MAP_NV with texture unit 2 active: only odd units accept it",
        ),
        (
            even,
            "TexGen coord=S pname=EMBOSS_CONSTANT_NV param=0.5",
            "INVALID_ENUM: EMBOSS_CONSTANT_NV with texture unit 2 active: only odd units accept it",
        ),
        (
            even,
            "TexGen coord=T pname=EMBOSS_LIGHT_NV param=LIGHT1",
            "INVALID_ENUM: EMBOSS_LIGHT_NV with texture unit 2 active: only odd units accept it",
        ),
        (
            odd,
            "TexGen coord=R pname=EMBOSS_CONSTANT_NV param=0.5",
            "INVALID_ENUM: EMBOSS_CONSTANT_NV of coordinate R: only S and T accept it",
        ),
        (
            odd,
            "TexGen coord=Q pname=EMBOSS_CONSTANT_NV param=0.5",
            "INVALID_ENUM: EMBOSS_CONSTANT_NV of coordinate Q: only S and T accept it",
        ),
        (
            odd,
            "TexGen coord=R pname=EMBOSS_LIGHT_NV param=LIGHT1",
            "INVALID_ENUM: EMBOSS_LIGHT_NV of coordinate R: only S and T accept it",
        ),
        (
            odd,
            "TexGen coord=Q pname=EMBOSS_LIGHT_NV param=LIGHT1",
            "INVALID_ENUM: EMBOSS_LIGHT_NV of coordinate Q: only S and T accept it",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT8",
            "INVALID_ENUM: LIGHT8: i of LIGHTi is from 0 to MAX_LIGHTS - 1 = 7",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT-1",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LIGHT-1`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=0x3fff",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 16383: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=1.5",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 1.5: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LAMP0",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LAMP0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_CONSTANT_NV param=LIGHT0",
            "EMBOSS_CONSTANT_NV = LIGHT0: legal is a finite number, such as 1 over the width of the texture",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_CONSTANT_NV param=inf",
            "EMBOSS_CONSTANT_NV = inf: legal is a finite number, such as 1 over the width of the texture",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_CONSTANT_NV param=nan",
            "EMBOSS_CONSTANT_NV = NaN: legal is a finite number, such as 1 over the width of the texture",
        ),
        (
            odd,
            "TexGen coord=S pname=TEXTURE_GEN_MODE param=EMBOSS_NV",
            "INVALID_ENUM: TEXTURE_GEN_MODE `EMBOSS_NV`, did you mean `EMBOSS_MAP_NV`: legal is EYE_LINEAR, OBJECT_LINEAR, SPHERE_MAP, NORMAL_MAP, REFLECTION_MAP or EMBOSS_MAP_NV",
        ),
        (
            odd,
            "TexGen coord=R pname=TEXTURE_GEN_MODE param=SPHERE_MAP",
            "INVALID_ENUM: SPHERE_MAP of coordinate R: only S and T accept it",
        ),
        (
            odd,
            "TexGen coord=U pname=TEXTURE_GEN_MODE param=SPHERE_MAP",
            "INVALID_ENUM: coord `U`: legal is S, T, R or Q",
        ),
        (
            odd,
            "TexGen coord=S pname=OBJECT_PLAIN param=1",
            "INVALID_ENUM: pname `OBJECT_PLAIN`, did you mean `OBJECT_PLANE`: legal is TEXTURE_GEN_MODE, OBJECT_PLANE, EYE_PLANE, EMBOSS_LIGHT_NV or EMBOSS_CONSTANT_NV",
        ),
        (
            odd,
            "GetTexGen coord=S pname=EYE_PLANES",
            "INVALID_ENUM: pname `EYE_PLANES`, did you mean `EYE_PLANE`: legal is TEXTURE_GEN_MODE, OBJECT_PLANE, EYE_PLANE, EMBOSS_LIGHT_NV or EMBOSS_CONSTANT_NV",
        ),
        (
            odd,
            "TexGen coord=Q pname=TEXTURE_GEN_MODE param=REFLECTION_MAP",
            "INVALID_ENUM: REFLECTION_MAP of coordinate Q: only S, T and R accept it",
        ),
        (
            odd,
            "ActiveTexture texture=TEXTURE4",
            "INVALID_ENUM: TEXTURE4: i of TEXTUREi is from 0 to MAX_TEXTURE_UNITS - 1 = 3",
        ),
        (odd, "ActiveTexture texture=unit1", "INVALID_ENUM: texture `unit1`: legal is TEXTUREi"),
        (
            odd,
            "Enable cap=LIGHT8",
            "INVALID_ENUM: LIGHT8: i of LIGHTi is from 0 to MAX_LIGHTS - 1 = 7",
        ),
        (
            odd,
            "Disable cap=TEXTURE_GEN_U",
            "INVALID_ENUM: cap `TEXTURE_GEN_U`, did you mean `TEXTURE_GEN_Q`: legal is what glEnable accepts in OpenGL 1.x, such as LIGHTING, LIGHTi, TEXTURE_GEN_S",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT99999999999999999999",
            "INVALID_ENUM: LIGHT99999999999999999999: i of LIGHTi is from 0 to MAX_LIGHTS - 1 = 7",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=5",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 5: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=-5",
            "INVALID_ENUM: EMBOSS_LIGHT_NV -5: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=16392",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 16392: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=16392.0",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 16392: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=16383.0",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 16383: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=16384.5",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 16384.5: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=nan",
            "INVALID_ENUM: EMBOSS_LIGHT_NV NaN: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=1e300",
            "INVALID_ENUM: EMBOSS_LIGHT_NV 1e300: legal is LIGHT0 = 16384 to LIGHT7 = 16391",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT007",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LIGHT007`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT00",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LIGHT00`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT-0",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LIGHT-0`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT+0",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LIGHT+0`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=LIGHT",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `LIGHT`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "TexGen coord=S pname=EMBOSS_LIGHT_NV param=GL_GL_LIGHT0",
            "INVALID_ENUM: EMBOSS_LIGHT_NV `GL_GL_LIGHT0`, did you mean `LIGHT0`: legal is LIGHTi",
        ),
        (
            odd,
            "ActiveTexture texture=TEXTURE01",
            "INVALID_ENUM: texture `TEXTURE01`, did you mean `TEXTURE0`: legal is TEXTUREi",
        ),
        (
            odd,
            "ActiveTexture texture=TEXTURE-1",
            "INVALID_ENUM: texture `TEXTURE-1`, did you mean `TEXTURE0`: legal is TEXTUREi",
        ),
        (
            odd,
            "ActiveTexture texture=GL_GL_TEXTURE1",
            "INVALID_ENUM: texture `GL_GL_TEXTURE1`, did you mean `TEXTURE0`: legal is TEXTUREi",
        ),
        (
            odd,
            "ActiveTexture texture=GL_TEXTURE99999999999999999999",
            "INVALID_ENUM: GL_TEXTURE99999999999999999999: i of TEXTUREi is from 0 to MAX_TEXTURE_UNITS - 1 = 3",
        ),
        (
            odd,
            "Enable cap=TEXTURE_GEN_GL_S",
            "INVALID_ENUM: cap `TEXTURE_GEN_GL_S`, did you mean `TEXTURE_GEN_S`: legal is what glEnable accepts in OpenGL 1.x, such as LIGHTING, LIGHTi, TEXTURE_GEN_S",
        ),
        (
            odd,
            "Enable cap=LIGHT00",
            "INVALID_ENUM: cap `LIGHT00`, did you mean `LIGHT0`: legal is what glEnable accepts in OpenGL 1.x, such as LIGHTING, LIGHTi, TEXTURE_GEN_S",
        ),
    ];
    for (before, call, message) in cases {
        let outcome = nv(&format!("{before}{call}"));
        let refused = outcome.events[1].outcome.as_ref().unwrap_err();
        assert_eq!(refused.message, message, "{call}");
        let code = message.starts_with("INVALID_ENUM").then_some("INVALID_ENUM");
        assert_eq!(refused.gl_error, code);
        assert_eq!(outcome.problems(), 1);
        // Nothing has changed: previously defined results are still defined, with the same values.
        let after = nv(&format!("{DEFINED}{before}{call}\n{odd}"));
        assert_eq!(after.emboss, nv(DEFINED).emboss, "{call}");
    }
}

/// The rules apply to what the extension adds. The rest of OpenGL is kept as given, or passed on.
#[test]
fn what_opengl_has_itself_is_kept_or_passed_on() {
    let plane = |call: &str, pname: &str, value: &str| {
        format!("[[nv]]\ncall = \"{call}\"\ncoord = \"S\"\npname = \"{pname}\"\n{value}\n")
    };
    let effects = |toml: &str| -> Vec<String> {
        let outcome = run(toml);
        assert_eq!(outcome.problems(), 0, "{toml}: {outcome:?}");
        outcome.events.into_iter().map(|event| event.outcome.unwrap()).collect()
    };
    // Planes, with every entry point, on an even unit too.
    for call in ["TexGen", "glTexGeniv", "TexGenfv", "glTexGendv"] {
        for pname in ["OBJECT_PLANE", "GL_EYE_PLANE"] {
            let toml = plane(call, pname, "params = [1, 0.5, 0, -2]");
            let name = pname.trim_start_matches("GL_");
            assert_eq!(effects(&toml), [format!("unit 0: {name} of S = [1, 0.5, 0, -2]")]);
        }
    }
    // `TexGen` alone implies neither one value nor a pointer to four; glTexGenf does.
    assert_eq!(
        effects(&plane("TexGen", "OBJECT_PLANE", "param = 1.0")),
        ["unit 0: OBJECT_PLANE of S = 1"]
    );
    let refused = |call: &str, value: &str| {
        let outcome = run(&plane(call, "OBJECT_PLANE", value));
        let refused = outcome.events.into_iter().next().unwrap().outcome.unwrap_err();
        (refused.gl_error, refused.message)
    };
    for call in ["TexGend", "glTexGenf", "TexGeni"] {
        let message = "INVALID_ENUM: OBJECT_PLANE needs four values, and this command passes one: use glTexGendv, fv or iv";
        assert_eq!(refused(call, "param = 1"), (Some("INVALID_ENUM"), message.to_owned()));
    }
    for (value, told) in [
        ("param = \"FOO\"", "FOO"),
        ("param = nan", "NaN"),
        ("params = [\"FOO\", true, [1, 2], nan]", "[FOO, TRUE, [1, 2], NaN]"),
        ("params = [1, 0, inf, 0]", "[1, 0, inf, 0]"),
    ] {
        let message = format!("OBJECT_PLANE = {told}: legal are four finite numbers");
        assert_eq!(refused("TexGen", value), (None, message));
    }
    for (coord, plane) in [("S", "[1, 0, 0, 0]"), ("T", "[0, 1, 0, 0]"), ("Q", "[0, 0, 0, 0]")] {
        for call in ["GetTexGen", "glGetTexGeniv", "glGetTexGenfv", "GetTexGendv"] {
            let got = nv(&format!("{call} coord={coord} pname=EYE_PLANE"));
            let told = got.events[0].outcome.as_ref().unwrap();
            assert_eq!(*told, format!("unit 0: EYE_PLANE of {coord} = {plane}"));
        }
    }
    // The extension's parameters, with the vector entry points.
    for (call, param) in [
        ("glTexGenfv", "params = [0.25]"),
        ("glTexGenfv", "param = 0.25"),
        ("TexGendv", "param = [0.25]"),
        ("glTexGend", "param = 0.25"),
    ] {
        let toml = format!(
            "{}{}",
            nv_call("ActiveTexture texture=GL_TEXTURE1_ARB"),
            plane(call, "EMBOSS_CONSTANT_NV", param)
        );
        assert_eq!(effects(&toml)[1], "unit 1: EMBOSS_CONSTANT_NV of S = 0.25");
    }
    for mode in ["REFLECTION_MAP", "NORMAL_MAP_ARB", "GL_REFLECTION_MAP_EXT", "0x8511"] {
        assert_eq!(
            nv(&format!("TexGeni coord=R pname=TEXTURE_GEN_MODE param={mode}")).problems(),
            0
        );
    }
    // All capabilities, per unit and global.
    for (cap, unit) in [
        ("TEXTURE_2D", "unit 1: "),
        ("GL_TEXTURE_CUBE_MAP_ARB", "unit 1: "),
        ("NORMALIZE", ""),
        ("GL_MAP2_TEXTURE_COORD_3", ""),
        ("MAP1_VERTEX_4", ""),
        ("AUTO_NORMAL", ""),
        ("CLIP_PLANE5", ""),
        ("RESCALE_NORMAL_EXT", ""),
        ("POLYGON_OFFSET_FILL", ""),
        ("REGISTER_COMBINERS_NV", ""),
        ("COLOR_SUM_EXT", ""),
        ("ALPHA_TEST", ""),
    ] {
        let outcome = nv(&format!(
            "ActiveTexture texture=TEXTURE1\nIsEnabled cap={cap}\nglEnable cap={cap}\nglIsEnabled cap={cap}\n\
             ActiveTexture texture=TEXTURE0\nIsEnabled cap={cap}\nActiveTexture texture=TEXTURE1\nDisable cap={cap}"
        ));
        assert_eq!(outcome.problems(), 0, "{cap}: {outcome:?}");
        let told = |i: usize| outcome.events[i].outcome.as_ref().unwrap().as_str();
        let name = cap.trim_start_matches("GL_").trim_end_matches("_ARB").trim_end_matches("_EXT");
        assert_eq!(told(1), format!("{unit}{name} disabled"));
        assert_eq!(told(3), format!("{unit}{name} enabled"));
        let elsewhere = if unit.is_empty() { "enabled" } else { "disabled" };
        assert!(told(5).ends_with(elsewhere), "{cap}: {}", told(5));
        assert_eq!(told(7), format!("{unit}{name} disabled"));
    }
    assert_eq!(nv("IsEnabled cap=DITHER").events[0].outcome.as_deref(), Ok("DITHER enabled"));
    for wrong in ["CLIP_PLANE6", "CLIP_PLANE999", "DITHER_NV", "TEXTURE_CUBE_MAP_SGIS"] {
        assert_eq!(nv(&format!("Enable cap={wrong}")).problems(), 1, "{wrong}");
    }
    // Arrays are enabled by another command.
    let arrays = "EnableClientState array=VERTEX_ARRAY\nIsEnabled cap=VERTEX_ARRAY";
    let told: Vec<String> =
        nv(arrays).events.into_iter().map(|event| event.outcome.unwrap()).collect();
    assert_eq!(
        told,
        [
            "passed on; its effect on the state checked here isn't modelled",
            "VERTEX_ARRAY: passed on; client arrays aren't modelled"
        ]
    );
    for call in ["glUnmapBuffer", "UnmapBufferARB", "GetLight", "glGetPixelMapusv", "GetTexEnv"] {
        assert_eq!(effects(&format!("[[nv]]\ncall = \"{call}\"\n")), ["passed on"], "{call}");
    }
    assert!(Calls::parse("[[nv]]\ncall = \"UnMapBuffer\"\n", "c.toml".as_ref()).is_err());
    // Other commands, with their arguments unchanged.
    let toml = "[[nv]]\ncall = \"glLightfv\"\nlight = \"LIGHT0\"\npname = \"POSITION\"\nparams = [0, 0.5, 1, 0]\n\
                [[nv]]\ncall = \"MultiTexCoord3fARB\"\ntarget = \"TEXTURE1\"\ns = 1\nt = 0\nr = 0\n\
                [[nv]]\ncall = \"glMap2f\"\ntarget = \"MAP2_TEXTURE_COORD_3\"\n\
                [[nv]]\ncall = \"glGetIntegerv\"\npname = \"MAX_LIGHTS\"\n\
                [[nv]]\ncall = \"glDepthMask\"\nflag = true\n[[nv]]\ncall = \"glFlush\"\n";
    assert_eq!(effects(toml), ["passed on"; 6]);
    let calls: Vec<String> = run(toml).events.into_iter().map(|event| event.call).collect();
    let told = [
        "glLightfv(LIGHT0, POSITION, [0, 0.5, 1, 0])",
        "glMultiTexCoord3fARB(TEXTURE1, 1, 0, 0)",
        "glMap2f(MAP2_TEXTURE_COORD_3)",
        "glGetIntegerv(MAX_LIGHTS)",
        "glDepthMask(TRUE)",
        "glFlush()",
    ];
    assert_eq!(calls, told);
    // Commands that could change the judged state say so.
    let attrib = effects("[[nv]]\ncall = \"glPopAttrib\"\n");
    assert_eq!(attrib, ["passed on; its effect on the state checked here isn't modelled"]);
    // None of these change the judged state.
    let between = "Enable cap=TEXTURE_2D\nTexGen coord=S pname=EYE_PLANE param=1\nglFlush\n";
    assert_eq!(nv(&format!("{DEFINED}{between}")).emboss, nv(DEFINED).emboss);
}

/// The unit accepts every reported configuration, for all words.
#[test]
fn the_unit_takes_every_configuration_that_is_told() {
    let with = |ks: &str, kt: &str| {
        let set = [("S", ks), ("T", kt)]
            .map(|(c, k)| format!("TexGen coord={c} pname=EMBOSS_CONSTANT_NV param={k}\n"));
        let calls = format!("{DEFINED}{}", set.concat()).replace("TEXTURE1", "TEXTURE3");
        let outcome = nv(&calls);
        assert_eq!(outcome.problems(), 0, "{outcome:?}");
        outcome.emboss[0]
    };
    let design = |told: &str| {
        let words: Vec<&str> = told.split(' ').collect();
        Unit::find("emboss").unwrap().values(&words).and_then(|values| values.build())
    };
    let bump = ["TEXCOORD1", "BUMP7", "TEXCOORD0", "IDENTITY"];
    design(&gx(&[BASE, bump]).emboss[0].to_string()).unwrap();
    for (ks, kt) in [
        ("4", "1"),
        ("0.00390625", "-0.0078125"),
        ("-2", "3.75"),
        ("1e-6", "100"),
        ("1000", "-12345.678"),
        ("65536", "-65536"),
    ] {
        let emboss = with(ks, kt);
        let built = design(&emboss.to_string()).unwrap_or_else(|why| panic!("{emboss}: {why}"));
        assert_eq!(built.values.int("light"), Some(0));
        assert_eq!(
            (built.values.int("source"), built.values.int("destination")),
            (Some(2), Some(3))
        );
        assert_eq!(built.values.real("ks"), ks.parse::<f64>().unwrap());
    }
    let refused = |told: &str| design(told).unwrap_err().to_string();
    assert_eq!(
        refused("setting=nv ks=4 kt=-3 constant_int_bits=1"),
        "parameter `ks` = `4`: legal is -2 to 1.9999990463256836 in format s22f20 of constant_int_bits=1; constant_int_bits=3 holds it"
    );
    assert_eq!(
        refused("setting=nv kt=-2 constant_int_bits=0 constant_frac_bits=8"),
        "parameter `ks` = `1`: legal is -1 to 0.99609375 in format s9f8 of constant_int_bits=0; constant_int_bits=1 holds it"
    );
    let far = with("1e6", "1").to_string();
    assert_eq!(
        refused(&far),
        "parameter `ks` = `1000000`: legal is -65536 to 65536, fractions allowed"
    );
}

/// Reading a long file takes time proportional to its length; a file over the limit is refused at
/// once.
#[test]
fn long_files_are_read_in_proportion_or_refused() {
    let seconds = |calls: usize| {
        let text = set(&BASE).repeat(calls);
        let start = std::time::Instant::now();
        let (code, stdout, _) = command(&text, &[]);
        assert_eq!((code, stdout.lines().count()), (0, calls + 6));
        assert!(stdout.contains(&format!("{}", 6 * (calls - 1) + 1)));
        start.elapsed().as_secs_f64()
    };
    let (short, long) = (seconds(4_000), seconds(40_000));
    // Ten times as many calls, not a hundred times the time; with a margin for a busy machine.
    assert!(long < 40.0 * short.max(0.1), "{short} s, {long} s");
    let (code, _, stderr) = command(&format!("{}#{}", set(&BASE), "x".repeat(16 << 20)), &[]);
    assert_eq!(code, 2);
    assert_eq!(stderr, "error: calls.toml: is larger than the maximum of 16777216 bytes\n");
}

/// Neither a call, nor its effect, nor a configuration is hundreds of digits long.
#[test]
fn extreme_constants_are_told_in_scientific_form() {
    for (param, told) in [
        ("-1e300", "-1e300"),
        ("5e-324", "5e-324"),
        ("0.0000099", "9.9e-6"),
        ("1e16", "1e16"),
        ("9007199254740991.0", "9007199254740991"),
        ("0.0001220703125", "0.0001220703125"),
        ("-0.0", "-0"),
    ] {
        let calls = format!("{DEFINED}TexGen coord=S pname=EMBOSS_CONSTANT_NV param={param}\n");
        let outcome = nv(&calls);
        let last = outcome.events.last().unwrap();
        assert_eq!(last.call, format!("glTexGen(S, EMBOSS_CONSTANT_NV, {told})"));
        let effect = format!("unit 1: EMBOSS_CONSTANT_NV of S = {told}");
        assert_eq!(last.outcome.as_ref().unwrap(), &effect);
        let toml: String =
            calls.lines().filter(|line| !line.trim().is_empty()).map(nv_call).collect();
        let (_, stdout, _) = command(&toml, &[]);
        let line = format!("setting=nv light=0 source=0 destination=1 ks={told} kt=1\n");
        assert!(stdout.contains(&line), "{stdout}");
        assert_eq!(told.parse::<f64>().unwrap().to_bits(), outcome.emboss[0].ks.to_bits());
    }
}

#[test]
fn every_condition_of_an_undefined_result_is_told() {
    let cases = [
        (
            "TexGen coord=R pname=TEXTURE_GEN_MODE param=EYE_LINEAR",
            &["TEXTURE_GEN_MODE of R is EYE_LINEAR: all of S, T, R and Q must be EMBOSS_MAP_NV"][..],
            "STQ",
        ),
        (
            "TexGen coord=S pname=TEXTURE_GEN_MODE param=SPHERE_MAP",
            &["TEXTURE_GEN_MODE of S is SPHERE_MAP: all of S, T, R and Q must be EMBOSS_MAP_NV"],
            "TRQ",
        ),
        (
            "Disable cap=TEXTURE_GEN_Q",
            &["TEXTURE_GEN_Q is disabled: it must be enabled for all of S, T, R and Q"],
            "STRQ",
        ),
        ("Disable cap=LIGHTING", &["LIGHTING is disabled: it must be enabled"], "STRQ"),
        (
            "Disable cap=LIGHT0",
            &["LIGHT0 is disabled: the light of the emboss must be enabled"],
            "STRQ",
        ),
        (
            "Enable cap=LIGHT2\nTexGen coord=T pname=EMBOSS_LIGHT_NV param=LIGHT2",
            &["EMBOSS_LIGHT_NV of S is LIGHT0 and of T is LIGHT2: they must be the same"],
            "STRQ",
        ),
        (
            "TexGen coord=T pname=EMBOSS_LIGHT_NV param=LIGHT2",
            &[
                "EMBOSS_LIGHT_NV of S is LIGHT0 and of T is LIGHT2: they must be the same",
                "LIGHT2 is disabled: the light of the emboss must be enabled",
            ],
            "STRQ",
        ),
        (
            "Disable cap=TEXTURE_GEN_T\nDisable cap=LIGHTING",
            &[
                "TEXTURE_GEN_T is disabled: it must be enabled for all of S, T, R and Q",
                "LIGHTING is disabled: it must be enabled",
            ],
            "STRQ",
        ),
    ];
    for (calls, conditions, coords) in cases {
        let outcome = nv(&format!("{DEFINED}{calls}"));
        assert!(outcome.emboss.is_empty(), "{calls}");
        assert_eq!(outcome.problems(), 1);
        let undefined = &outcome.undefined[0];
        let told: Vec<String> = undefined.conditions.iter().map(ToString::to_string).collect();
        assert_eq!(told, conditions, "{calls}");
        let of: String = undefined.coords.iter().map(|coord| format!("{coord:?}")).collect();
        assert_eq!((undefined.unit, of.as_str()), (1, coords));
    }
    // Each unit has its own state, and a unit without the mode has no conditions.
    let other = nv(&format!("{DEFINED}ActiveTexture texture=TEXTURE3\nEnable cap=TEXTURE_GEN_S"));
    assert_eq!((other.emboss.len(), other.problems()), (1, 0));
}

/// Runs `fixpath texgen` on a text: exit code, standard output, standard error.
fn command(toml: &str, arguments: &[&str]) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("calls.toml"), toml).unwrap();
    let mut command = fixpath();
    let command = command.current_dir(folder.path()).args(["texgen", "calls.toml"]);
    told(command.args(arguments).output().unwrap())
}

#[test]
fn malformed_files_are_refused_with_the_line() {
    let call = "[[gx]]\ncall = \"SetTexCoordGen\"\ndst_coord = \"TEXCOORD0\"\n";
    let cases = [
        (
            "",
            "calls.toml: no calls: each is a table `[[gx]]` or `[[nv]]`; `fixpath help texgen` shows some",
        ),
        ("[[gx]\n", "calls.toml, line 1: "),
        (
            "[[xg]]\n",
            "calls.toml, line 1: unknown field `xg`, expected one of `limits`, `gx`, `nv` in `[[xg]]`",
        ),
        (
            // Each in its own call, far from the first line.
            &format!("{}\n# a note\n{}foo = 1\n", set(&BASE), set(&BUMP)),
            "calls.toml, line 15: unknown field `foo`, expected one of",
        ),
        (
            &format!("{}{}[[gx]]\ncall = \"SetTexCoordGen\"\n", set(&BASE), set(&BUMP)),
            "calls.toml, line 13: missing field `dst_coord` in `[[gx]]`",
        ),
        (
            &format!(
                "{}[[gx]]\ncall = \"LoadRegister\"\ndst_coord = \"TEXCOORD1\"\nword = \"0x290\"\n",
                set(&BASE)
            ),
            "calls.toml, line 10: invalid type: string \"0x290\", expected a whole number in `word = \"0x290\"`",
        ),
        (
            "\n[[gx]]\ndst_coord = \"TEXCOORD0\"\n",
            "calls.toml, line 2: missing field `call` in `[[gx]]`",
        ),
        (
            "[[gx]]\ncall = \"Set\"\n",
            "calls.toml, line 2: no call `Set`: legal is SetTexCoordGen or LoadRegister in `call = \"Set\"`",
        ),
        ("[[gx]]\ncall = 3\n", "calls.toml, line 2: `call` must be a name in quotes in `call = 3`"),
        (call, "calls.toml, line 1: missing field `func` in `[[gx]]`"),
        (
            &format!("{call}function = \"SRTG\"\n"),
            "calls.toml, line 4: unknown field `function`, expected one of `dst_coord`, `func`, `src_param`, `mat_idx`",
        ),
        (
            &format!("{call}func = \"SRTG\"\nsrc_param = 4\nmat_idx = 60\n"),
            "calls.toml, line 5: invalid type: integer `4`, expected a string in `src_param = 4`",
        ),
        (
            &format!("{call}func = \"SRTG\"\nsrc_param = \"COLOR0\"\nmat_idx = 1.5\n"),
            "calls.toml, line 6: a matrix is TEXMTX0 to TEXMTX9, IDENTITY or the number of its first row",
        ),
        (
            "gx = 3\n",
            "calls.toml, line 1: invalid type: integer `3`, expected a sequence in `gx = 3`",
        ),
        ("gx = [3]\n", "calls.toml, line 1: expected a table with `call` in `gx = [3]`"),
        (
            "\nlimits = [8, 4, 99]\n",
            "calls.toml, line 2: invalid type: sequence, expected a table in `limits = [8, 4, 99]`",
        ),
        (
            "[limits]\nlights = 4\n[[nv]]\ncall = \"Enable\"\ncap = \"LIGHTING\"\n",
            "calls.toml, line 1: `lights` = 4: legal is 8 to 32",
        ),
        (
            "[limits]\ntexture_units = 0\n",
            "calls.toml, line 1: `texture_units` = 0: legal is 1 to 32",
        ),
        (
            "[limits]\ntexture_units = 300\n",
            "calls.toml, line 1: `texture_units` = 300: legal is 1 to 32",
        ),
        ("[limits]\nlights = -1\n", "calls.toml, line 1: `lights` = -1: legal is 8 to 32"),
        (
            "[limits]\nlights = 8.5\n",
            "calls.toml, line 2: invalid type: floating point `8.5`, expected a whole number in `lights = 8.5`",
        ),
        (
            "[limits]\nlight = 8\n",
            "calls.toml, line 2: unknown field `light`, expected `lights` or `texture_units`",
        ),
        (
            "[[nv]]\ncall = \"TexGen\"\ncoord = \"S\"\npname = \"EMBOSS_LIGHT_NV\"\nparam = {}\n",
            "calls.toml, line 5: param is a number or the name of a token, or an array of them",
        ),
        (
            "[[nv]]\ncall = \"TexGen\"\ncoord = \"S\"\npname = \"EMBOSS_CONSTANT_NV\"\nparam = [1.0, 2.0]\n",
            "calls.toml, line 5: `param` has 2 values, but EMBOSS_CONSTANT_NV takes 1",
        ),
        (
            "[[nv]]\ncall = \"glTexGenfv\"\ncoord = \"S\"\npname = \"GL_EYE_PLANE\"\n\nparams = [1, 2, 3]\n",
            "calls.toml, line 6: `param` has 3 values, but GL_EYE_PLANE takes 4",
        ),
        (
            "[[nv]]\ncall = \"glEnabel\"\n",
            "calls.toml, line 2: no call `glEnabel`, did you mean `Enable`: legal are the commands of OpenGL 1.x in `call = \"glEnabel\"`",
        ),
        (
            "[[nv]]\ncall = \"glLightfv\"\nlight = 1979-05-27\n",
            "calls.toml, line 3: param is a number or the name of a token, or an array of them",
        ),
    ];
    for (toml, message) in cases {
        let (code, stdout, stderr) = command(toml, &[]);
        assert_eq!((code, stdout.as_str()), (2, ""), "{toml}: {stderr}");
        assert_eq!(stderr.lines().count(), 1, "{toml}: {stderr}");
        assert!(stderr.starts_with("error: ") && stderr.contains(message), "{toml}: {stderr}");
    }
    let mut missing = fixpath();
    let output = missing.args(["texgen", "no/such.toml"]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.starts_with("error: no/such.toml: can't read: "), "{stderr}");
}

#[test]
fn the_command_tells_every_call_and_what_it_configures() {
    let toml = format!(
        "{}{}\n# two lines\n{}",
        set(&BASE),
        set(&BUMP),
        DEFINED
            .lines()
            .skip(1)
            .map(|line| { if line.trim().is_empty() { String::new() } else { nv_call(line) } })
            .collect::<String>()
    );
    let (code, stdout, stderr) = command(&toml, &[]);
    assert_eq!((code, stderr.as_str()), (0, ""), "{stdout}");
    for line in [
        "  # line call                                                  effect",
        "  1    1 GXSetTexCoordGen(TEXCOORD0, MTX2x4, TEX0, TEXMTX3)    TEXCOORD0 = TEX0 by the 2x4 matrix TEXMTX3",
        "  2    7 GXSetTexCoordGen(TEXCOORD1, BUMP0, TEXCOORD0, IDENTITY) TEXCOORD1 = TEXCOORD0 displaced by light 0",
        "  register 0x1041 = 0x00000290  TEXCOORD1",
        "  emboss: setting=gx light=0 source=0 destination=1 ks=1 kt=1",
        "  emboss: setting=nv light=0 source=0 destination=1 ks=1 kt=1",
    ] {
        let squeeze = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let found = stdout.lines().any(|told| squeeze(told) == squeeze(line));
        assert!(found, "{line}\n{stdout}");
    }
    let (code, stdout, _) = command(&toml, &["--json"]);
    let told: serde_json::Value = serde_json::from_str(&stdout).unwrap();
    assert_eq!((code, told["problems"].as_u64()), (0, Some(0)));
    assert_eq!(told["calls"][1]["line"], 7);
    assert_eq!(told["emboss"][1]["setting"], "nv");
    assert_eq!(told["registers"][4]["word"], 0x290);
}

#[test]
fn a_broken_rule_or_an_undefined_result_is_exit_code_2_with_all_else_told() {
    let broken = format!("{}{}", set(&BASE), set(&["TEXCOORD1", "BUMP0", "TEX0", "IDENTITY"]));
    let (code, stdout, stderr) = command(&broken, &[]);
    assert_eq!(code, 2);
    assert_eq!(stderr, "error: calls.toml: 1 problem in these calls\n");
    assert!(stdout.contains("REFUSED: BUMP0 from TEX0: "), "{stdout}");
    assert!(stdout.contains("register 0x1040 = 0x00000280  TEXCOORD0"), "{stdout}");
    let undefined = format!(
        "{}{}",
        nv_call("ActiveTexture texture=TEXTURE1"),
        nv_call("TexGen coord=S pname=TEXTURE_GEN_MODE param=EMBOSS_MAP_NV")
    );
    let (code, stdout, _) = command(&undefined, &[]);
    assert_eq!(code, 2);
    assert!(
        stdout.contains("UNDEFINED: S of texture unit 1\n    TEXTURE_GEN_MODE of T is EYE_LINEAR"),
        "{stdout}"
    );
    let (code, stdout, _) = command(&undefined, &["--json"]);
    let told: serde_json::Value = serde_json::from_str(&stdout).unwrap();
    assert_eq!((code, told["problems"].as_u64()), (2, Some(1)));
    assert_eq!(told["undefined"][0]["conditions"].as_array().unwrap().len(), 9);
    assert!(told["emboss"].as_array().unwrap().is_empty());
    // Names from the file are escaped: no terminal obeys them.
    let escape = set(&["TEXCOORD0", "\\u001b[2J", "TEX0", "IDENTITY"]);
    assert!(!command(&escape, &[]).1.contains('\u{1b}'));
}

/// The file that `fixpath help texgen` shows, without what it leaves to "likewise for T, R and Q".
#[test]
fn the_example_of_the_help_runs() {
    let page = include_str!("../../docs/files/texgen.md");
    let example = page.split_once("```toml\n").unwrap().1.split_once("```").unwrap().0;
    let outcome = run(example);
    let refused: Vec<_> = outcome.events.iter().filter(|event| event.outcome.is_err()).collect();
    assert!(refused.is_empty(), "{refused:?}");
    assert_eq!((outcome.events.len(), outcome.emboss.len()), (6, 1));
    assert_eq!(outcome.undefined[0].coords.len(), 1);
    // The limits that it writes out are the defaults: the last light and unit are taken, the next
    // ones refused, with and without them.
    let limits = &example[example.find("[limits]").unwrap()..];
    let limits = &limits[..limits.find("[[nv]]").unwrap()];
    for limits in ["", limits] {
        for (last, taken) in [(7, true), (8, false)] {
            let call = format!("[[nv]]\ncall = \"Enable\"\ncap = \"LIGHT{last}\"\n");
            let events = run(&format!("{limits}{call}")).events;
            assert_eq!(events[0].outcome.is_ok(), taken, "{limits} LIGHT{last}");
        }
        for (last, taken) in [(3, true), (4, false)] {
            let call = format!("[[nv]]\ncall = \"ActiveTexture\"\ntexture = \"TEXTURE{last}\"\n");
            let events = run(&format!("{limits}{call}")).events;
            assert_eq!(events[0].outcome.is_ok(), taken, "{limits} TEXTURE{last}");
        }
    }
}

#[test]
fn the_example_of_the_pages_runs() {
    let page = include_str!("../../docs/pictures.md");
    let example = page.split("```toml\n").find(|text| text.starts_with("[[gx]]")).unwrap();
    let outcome = run(example.split_once("```").unwrap().0);
    assert_eq!(outcome.problems(), 0);
    assert!(page.contains(&format!("(`{}`)", outcome.emboss[0])));
}
