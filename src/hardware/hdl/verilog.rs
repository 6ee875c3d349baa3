//! Verilog-2005, in a form that Icarus, Verilator and Yosys accept without a warning.
//!
//! Every extension and every width is written out, so that no result depends on Verilog's own rules
//! for signs and contexts. The index of a bit is the exponent of its weight, so the binary point
//! lies above index -1.

use super::language::{Language, ROWS_A_LINE, rom_attributes};
use super::module::{
    Bit, Bitwise, Driver, Enable, Expr, File, Item, Module, Next, Operand, Register, RomTable,
    Stage, Tables, Valid, View, Word, WordId, WritePort,
};
use super::testbench;
use crate::base::cast;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Verilog-2005.
#[derive(Debug)]
pub struct Verilog;

impl Language for Verilog {
    fn name(&self) -> &'static str {
        "verilog"
    }

    fn summary(&self) -> &'static str {
        "Verilog-2005, for Icarus, Verilator, Yosys and others"
    }

    fn extension(&self) -> &'static str {
        "v"
    }

    fn companions(&self, module: &Module, vectors: u64) -> Vec<File> {
        let testbench = include_str!("templates/testbench.v");
        let text = testbench::render(testbench, module, vectors, &shape);
        let plain = |suffix, template| testbench::companion(module, suffix, template, vectors);
        let bench = testbench::bench(module, "v", include_str!("templates/bench.v"), &shape);
        let mut files = Vec::from_iter(bench);
        files.extend([
            File { name: format!("{}_tb.v", module.name), text },
            plain("_harness.cpp", include_str!("templates/harness.cpp")),
            plain("_icarus.mk", include_str!("templates/icarus.mk")),
            plain("_verilator.mk", include_str!("templates/verilator.mk")),
            plain(".ys", include_str!("templates/yosys.ys")),
        ]);
        files
    }

    fn module(&self, module: &Module) -> String {
        let mut text = String::new();
        for line in &module.header {
            let _ = writeln!(text, "{}", format!("// {line}").trim_end());
        }
        ports(module, &mut text);
        for table in &module.tables {
            rom(module, table, &mut text);
        }
        let declared: BTreeSet<WordId> =
            module.stages.iter().flat_map(|stage| stage.declared.iter().copied()).collect();
        for stage in &module.stages {
            let _ = writeln!(text, "\n    // ---- {} ----", stage.title);
            declarations(module, stage, &mut text);
            for item in &stage.items {
                match item {
                    Item::Scope(path) if path.is_empty() => text.push_str("    // (unit)\n"),
                    Item::Scope(path) => {
                        let _ = writeln!(text, "    // {path}");
                    }
                    Item::Assign(id, expr) => {
                        let word = module.word(*id);
                        let value = Printer { module }.expr(expr, word);
                        let _ = if declared.contains(id) {
                            writeln!(text, "    assign {} = {value};", word.name)
                        } else {
                            let (shape, note) = (shape(word), comment(word));
                            writeln!(text, "    wire {shape}{} = {value};{note}", word.name)
                        };
                    }
                }
            }
            registers(module, stage, &declared, &mut text);
        }
        text.push('\n');
        for (port, id) in module.driven() {
            let word = module.word(id);
            if word.name != port {
                let _ = writeln!(text, "    assign {port} = {};", word.name);
            }
        }
        if module.latency == 0 {
            text.push_str("    assign valid_out = valid_in;\n");
        }
        for (port, flag) in module.readies() {
            let _ = writeln!(text, "    assign {port} = {};", Printer { module }.bit(flag));
        }
        unused(module, &mut text);
        text.push_str("endmodule\n");
        text
    }
}

/// Verilog that compares a module with its reference cycle by cycle, and a Yosys script that proves
/// that they never differ.
#[must_use]
pub fn proof(module: &Module) -> [File; 2] {
    let comparison = testbench::render(include_str!("templates/equal.v"), module, 0, &shape);
    [
        File { name: format!("{}_equal.v", module.name), text: comparison },
        testbench::companion(module, "_equal.ys", include_str!("templates/equal.ys"), 0),
    ]
}

/// `signed [1:-14] `, `[9:0] ` or the empty string.
fn shape(word: &Word) -> String {
    let sign = if word.signed { "signed " } else { "" };
    if word.bits == 1 {
        return sign.to_owned();
    }
    let (top, least) = (index(word, word.bits - 1), index(word, 0));
    format!("{sign}[{top}:{least}] ")
}

/// Index of a bit as declared.
fn index(word: &Word, bit: u32) -> i32 {
    cast::signed_count(bit) - word.frac
}

fn comment(word: &Word) -> String {
    word.format.map(|format| noted(&format.to_string())).unwrap_or_default()
}

fn noted(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!(" // {text}") }
}

fn ports(module: &Module, text: &mut String) {
    let _ = writeln!(text, "module {} (", module.name);
    let ports = module.ports();
    let last = ports.len() - 1;
    for (number, port) in ports.iter().enumerate() {
        let way = match (port.is_output, port.is_register()) {
            (false, _) => "input  wire",
            (true, false) => "output wire",
            (true, true) => "output reg ",
        };
        let comma = if number == last { "" } else { "," };
        let shape = port.word.map(shape).unwrap_or_default();
        let note = noted(&port.comment);
        let _ = writeln!(text, "    {way} {shape}{}{comma}{note}", port.name);
    }
    text.push_str(");\n");
}

fn rom(module: &Module, table: &RomTable, text: &mut String) {
    let RomTable { name, title, addr_bits, row_bits, columns, copy_of, write } = table;
    let columns: Vec<String> =
        columns.iter().map(|column| format!("{} {}", column.name, column.format)).collect();
    let copy = if copy_of.is_some() { "a copy of " } else { "" };
    let kind = if write.is_some() { "memory" } else { "table" };
    let _ = writeln!(text, "\n    // {copy}{kind} {title}: {}", columns.join(", "));
    let attributes: Vec<String> = rom_attributes(module.block_rom)
        .iter()
        .map(|(attribute, value)| format!("{attribute} = \"{value}\""))
        .collect();
    let attributes = attributes.join(", ");
    let range = if *row_bits == 1 { String::new() } else { format!("[{}:0] ", row_bits - 1) };
    let last = table.len() - 1;
    if let Some(WritePort { enable, address, data }) = write {
        let name_of = |id: &WordId| module.word(*id).name.clone();
        let row: Vec<String> = data.iter().map(name_of).collect();
        let (enable, address) = (name_of(enable), name_of(address));
        let _ = writeln!(text, "    reg {range}{name} [0:{last}];");
        let _ = writeln!(
            text,
            "    always @(posedge clk)\n        if ({enable}) {name}[{address}] <= {{{}}};",
            row.join(", ")
        );
        return;
    }
    if module.tables_in == Tables::Case {
        let _ = writeln!(text, "    function {range}{name};");
        let _ = writeln!(text, "        input [{}:0] address;", addr_bits - 1);
        let _ = writeln!(text, "        (* {attributes} *)\n        case (address)");
        for (address, row) in table.rows().enumerate() {
            let label = if cast::count_of(address) == last {
                "default".to_owned()
            } else {
                format!("{addr_bits}'d{address}")
            };
            let _ = writeln!(text, "            {label}: {name} = {row_bits}'h{row};");
        }
        text.push_str("        endcase\n    endfunction\n");
        return;
    }
    // Without the attributes, an unclocked read and the register after it could still become block
    // RAM.
    let _ = writeln!(text, "    (* {attributes} *)");
    let _ = writeln!(text, "    reg {range}{name} [0:{last}];");
    if module.tables_in == Tables::Files {
        let _ = writeln!(text, "    initial $readmemh(\"{}\", {name});", module.table_file(table));
        return;
    }
    text.push_str("    initial begin\n");
    let rows: Vec<String> = table.rows().collect();
    for (line, rows) in rows.chunks(ROWS_A_LINE).enumerate() {
        text.push_str("       ");
        for (at, row) in rows.iter().enumerate() {
            let address = line * ROWS_A_LINE + at;
            let _ = write!(text, " {name}[{address}] = {row_bits}'h{row};");
        }
        text.push('\n');
    }
    text.push_str("    end\n");
}

/// Words that are used before they are driven.
fn declarations(module: &Module, stage: &Stage, text: &mut String) {
    for id in &stage.declared {
        let word = module.word(*id);
        let kind = if word.driver == Driver::Logic { "wire" } else { "reg" };
        let _ = writeln!(text, "    {kind} {}{};{}", shape(word), word.name, comment(word));
    }
}

/// Registers between a stage and the next, and the valid bits.
fn registers(module: &Module, stage: &Stage, declared: &BTreeSet<WordId>, text: &mut String) {
    if stage.registers.is_empty() && stage.valid.is_empty() {
        return;
    }
    text.push('\n');
    for Register { word: id, .. } in &stage.registers {
        let word = module.word(*id);
        if word.driver != Driver::OutputRegister && !declared.contains(id) {
            let _ = writeln!(text, "    reg {}{};{}", shape(word), word.name, comment(word));
        }
    }
    let printer = Printer { module };
    let enable = |(load, valid): &Enable| {
        let flag = load.map(|flag| format!(" & {}", printer.bit(flag))).unwrap_or_default();
        let valid = valid.as_ref().map(|valid| format!(" & {valid}")).unwrap_or_default();
        format!("ce{flag}{valid}")
    };
    let taken = |next: &Next| match next {
        Next::Word(from) => module.word(*from).name.clone(),
        Next::Read(table, address) => printer.read(*table, *address),
    };
    for (under, group) in stage.groups() {
        let _ = writeln!(text, "    always @(posedge clk)\n        if ({}) begin", enable(&under));
        for register in group {
            let name = &module.word(register.word).name;
            let _ = writeln!(text, "            {name} <= {};", taken(&register.next));
        }
        text.push_str("        end\n");
    }
    for register in stage.registers.iter().filter(|register| register.reset) {
        let word = module.word(register.word);
        let _ = writeln!(
            text,
            "    always @(posedge clk)\n        if (rst) {0} <= {1};\n        else if ({2}) {0} <= {3};",
            word.name,
            literal(0, word.bits),
            enable(&register.enable()),
            taken(&register.next)
        );
    }
    for Valid { from, to, load } in &stage.valid {
        let _ = writeln!(
            text,
            "    reg {to};\n    always @(posedge clk)\n        if (rst) {to} <= 1'b0;\n        else if ({}) {to} <= {from};",
            enable(&(*load, None))
        );
        if *to == module.valid.0 {
            let _ = match module.valid.1 {
                None => writeln!(text, "    assign valid_out = {to};"),
                Some(flag) => {
                    writeln!(text, "    assign valid_out = {to} & {};", printer.bit(flag))
                }
            };
        }
    }
}

/// Uses every bit that is dropped on purpose, so that no tool warns about it.
fn unused(module: &Module, text: &mut String) {
    let mut parts = module.idle_rates.clone();
    for word in &module.words {
        let mut bit = 0;
        while bit < word.bits {
            let free = |bit: u32| !word.used[usize::try_from(bit).expect("bug: 32 bits fit")];
            if free(bit) {
                let lo = bit;
                while bit < word.bits && free(bit) {
                    bit += 1;
                }
                parts.push(part(word, lo, bit - lo));
            } else {
                bit += 1;
            }
        }
    }
    if !parts.is_empty() {
        let _ = writeln!(
            text,
            "\n    // bits that rounding and cutting drop\n    wire unused = &{{1'b0,\n        {}}};",
            parts.join(",\n        ")
        );
    }
}

/// `bits` bits of a word from bit `lo`.
fn part(word: &Word, lo: u32, bits: u32) -> String {
    if bits == word.bits {
        word.name.clone()
    } else if bits == 1 {
        format!("{}[{}]", word.name, index(word, lo))
    } else {
        format!("{}[{}:{}]", word.name, index(word, lo + bits - 1), index(word, lo))
    }
}

fn literal(pattern: u128, bits: u32) -> String {
    if bits == 1 { format!("1'b{pattern}") } else { format!("{bits}'h{pattern:x}") }
}

struct Printer<'a> {
    module: &'a Module,
}

impl Printer<'_> {
    fn name(&self, id: WordId) -> &str {
        &self.module.word(id).name
    }

    fn read(&self, table: usize, address: WordId) -> String {
        let RomTable { name, write, .. } = &self.module.tables[table];
        let address = self.name(address);
        if self.module.tables_in == Tables::Case && write.is_none() {
            format!("{name}({address})")
        } else {
            format!("{name}[{address}]")
        }
    }

    fn bit(&self, bit: Bit) -> String {
        part(self.module.word(bit.word), bit.bit, 1)
    }

    fn operand(&self, operand: Operand) -> String {
        match operand {
            Operand::Literal { pattern, bits } => literal(pattern, bits),
            Operand::View(View { word, lo, zeros, bits }) => {
                let word = self.module.word(word);
                let room = bits.saturating_sub(zeros);
                let have = (word.bits - lo).min(room);
                if have == 0 {
                    return literal(0, bits);
                }
                let mut parts = Vec::new();
                let above = room - have;
                if above > 0 && word.signed {
                    let sign = part(word, word.bits - 1, 1);
                    parts.push(if above == 1 { sign } else { format!("{{{above}{{{sign}}}}}") });
                } else if above > 0 {
                    parts.push(literal(0, above));
                }
                parts.push(part(word, lo, have));
                if zeros > 0 {
                    parts.push(literal(0, zeros));
                }
                if parts.len() == 1 { parts.remove(0) } else { format!("{{{}}}", parts.join(", ")) }
            }
        }
    }

    /// The operand as a signed number.
    fn signed(&self, operand: Operand) -> String {
        match operand {
            Operand::View(View { word, lo: 0, zeros: 0, bits })
                if self.module.word(word).signed && self.module.word(word).bits == bits =>
            {
                self.operand(operand)
            }
            Operand::View(_) | Operand::Literal { .. } => {
                format!("$signed({})", self.operand(operand))
            }
        }
    }

    fn expr(&self, expr: &Expr, to: &Word) -> String {
        match expr {
            Expr::Copy(a) => self.operand(*a),
            Expr::Add(a, b) => format!("{} + {}", self.operand(*a), self.operand(*b)),
            Expr::Sub(a, b) => format!("{} - {}", self.operand(*a), self.operand(*b)),
            Expr::AddCarry(a, b, bit) => {
                let carry = match to.bits - 1 {
                    0 => self.bit(*bit),
                    above => format!("{{{}, {}}}", literal(0, above), self.bit(*bit)),
                };
                format!("{} + {} + {carry}", self.operand(*a), self.operand(*b))
            }
            Expr::InvertIf(bit, a) => {
                format!("{} ^ {{{}{{{}}}}}", self.operand(*a), to.bits, self.bit(*bit))
            }
            Expr::Negate(a) => format!("-{}", self.operand(*a)),
            Expr::Multiply(a, b) => {
                let any = self.module.word(*a).signed || self.module.word(*b).signed;
                let factor = |id: WordId| {
                    let word = self.module.word(id);
                    if any && !word.signed {
                        format!("$signed({{1'b0, {}}})", word.name)
                    } else {
                        word.name.clone()
                    }
                };
                format!("{} * {}", factor(*a), factor(*b))
            }
            Expr::Bitwise(operator, a, b) => {
                let operator = match operator {
                    Bitwise::And => '&',
                    Bitwise::Or => '|',
                    Bitwise::Xor => '^',
                };
                format!("{} {operator} {}", self.name(*a), self.name(*b))
            }
            Expr::Equal(a, b) => format!("{} == {}", self.operand(*a), self.operand(*b)),
            Expr::Less { a, b, signed: true } => {
                format!("{} < {}", self.signed(*a), self.signed(*b))
            }
            Expr::Less { a, b, signed: false } => {
                format!("{} < {}", self.operand(*a), self.operand(*b))
            }
            Expr::Choose { cases, default } => {
                let mut text = String::new();
                for (bit, operand) in cases {
                    let _ = write!(text, "{} ? {} : ", self.bit(*bit), self.operand(*operand));
                }
                text + &self.operand(*default)
            }
            Expr::Concat(parts) => {
                let parts: Vec<String> = parts.iter().map(|part| self.operand(*part)).collect();
                format!("{{{}}}", parts.join(", "))
            }
            Expr::ShiftLeft(a, count) => format!("{} << {}", self.operand(*a), self.name(*count)),
            Expr::Above { word, keep } => {
                let word = self.module.word(*word);
                if word.signed {
                    let sign = part(word, word.bits - 1, 1);
                    format!("~{sign} & (|{})", part(word, *keep, word.bits - 1 - keep))
                } else {
                    format!("|{}", part(word, *keep, word.bits - keep))
                }
            }
            Expr::Below { word, keep } => {
                let word = self.module.word(*word);
                let sign = part(word, word.bits - 1, 1);
                format!("{sign} & ~(&{})", part(word, *keep, word.bits - 1 - keep))
            }
            Expr::Read(table, address) => self.read(*table, *address),
        }
    }
}
