//! VHDL-2008, using only `numeric_std`, in a form that GHDL accepts without a warning.
//!
//! Every word is `unsigned` or `signed`, even a single bit. Each operand is converted to the sign
//! and number of bits of its result before it is used. `resize` is used only to extend, because it
//! keeps the sign instead of the low bits when it cuts a signed number: cuts are slices.

use super::language::{Language, ROWS_A_LINE, rom_attributes};
use super::module::{
    Bit, Bitwise, Driver, Enable, Expr, File, Item, Module, Next, Operand, Register, RomTable,
    Stage, Tables, Valid, View, Word, WordId, WritePort,
};
use super::testbench;
use crate::base::cast;
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// VHDL-2008.
#[derive(Debug)]
pub struct Vhdl;

/// Initial value of every word used in arithmetic.
const ZERO: &str = " := (others => '0')";

impl Language for Vhdl {
    fn name(&self) -> &'static str {
        "vhdl"
    }

    fn summary(&self) -> &'static str {
        "VHDL-2008, for GHDL and others"
    }

    fn extension(&self) -> &'static str {
        "vhd"
    }

    fn companions(&self, module: &Module, vectors: u64) -> Vec<File> {
        let testbench = include_str!("templates/testbench.vhd");
        let text = testbench::render(testbench, module, vectors, &shape);
        let makefile = include_str!("templates/ghdl.mk");
        let bench = testbench::bench(module, "vhd", include_str!("templates/bench.vhd"), &shape);
        let mut files = Vec::from_iter(bench);
        files.extend([
            File { name: format!("{}_tb.vhd", module.name), text },
            testbench::companion(module, "_ghdl.mk", makefile, vectors),
        ]);
        files
    }

    fn module(&self, module: &Module) -> String {
        let mut text = String::new();
        for line in &module.header {
            let _ = writeln!(text, "{}", format!("-- {line}").trim_end());
        }
        ports(module, &mut text);
        let _ = writeln!(text, "\narchitecture rtl of {} is", module.name);
        declarations(module, &mut text);
        text.push_str("begin\n");
        for table in &module.tables {
            writes(module, table, &mut text);
        }
        for stage in &module.stages {
            let _ = writeln!(text, "\n    -- ---- {} ----", stage.title);
            for item in &stage.items {
                match item {
                    Item::Scope(path) if path.is_empty() => text.push_str("    -- (unit)\n"),
                    Item::Scope(path) => {
                        let _ = writeln!(text, "    -- {path}");
                    }
                    Item::Assign(id, expr) => {
                        let word = module.word(*id);
                        let value = Printer { module }.expr(expr, word);
                        let _ = writeln!(text, "    {} <= {value};", word.name);
                    }
                }
            }
            registers(module, stage, &mut text);
        }
        text.push('\n');
        for (port, id) in module.driven() {
            let word = module.word(id);
            if word.name != port {
                let _ = writeln!(text, "    {port} <= {};", word.name);
            }
        }
        let printer = Printer { module };
        for (port, flag) in module.readies() {
            let _ = writeln!(text, "    {port} <= {};", printer.bit(flag));
        }
        let valid = &module.valid.0;
        let _ = match module.valid.1 {
            None => writeln!(text, "    valid_out <= {valid};"),
            Some(flag) => writeln!(text, "    valid_out <= {valid} and {};", printer.bit(flag)),
        };
        text.push_str("end architecture;\n");
        text
    }
}

/// `signed(15 downto 0)`.
fn shape(word: &Word) -> String {
    format!("{}({} downto 0)", sign(word.signed), word.bits - 1)
}

fn sign(signed: bool) -> &'static str {
    if signed { "signed" } else { "unsigned" }
}

fn comment(word: &Word) -> String {
    word.format.map(|format| noted(&format.to_string())).unwrap_or_default()
}

fn noted(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!(" -- {text}") }
}

fn has_roms(module: &Module) -> bool {
    module.tables.iter().any(|table| table.write.is_none())
}

fn ports(module: &Module, text: &mut String) {
    text.push_str("library ieee;\nuse ieee.std_logic_1164.all;\nuse ieee.numeric_std.all;\n");
    if has_roms(module) && module.tables_in == Tables::Files {
        text.push_str("use std.textio.all;\n");
    }
    let _ = writeln!(text, "\nentity {} is\n    port (", module.name);
    let ports = module.ports();
    let last = ports.len() - 1;
    for (number, port) in ports.iter().enumerate() {
        let way = if port.is_output { "out" } else { "in" };
        let shape = port.word.map_or_else(|| "std_logic".to_owned(), shape);
        let zero = if port.is_register() { ZERO } else { "" };
        let semicolon = if number == last { "" } else { ";" };
        let (name, note) = (port.name, noted(&port.comment));
        let _ = writeln!(text, "        {name} : {way} {shape}{zero}{semicolon}{note}");
    }
    text.push_str("    );\nend entity;\n");
}

fn declarations(module: &Module, text: &mut String) {
    if has_roms(module) && module.tables_in != Tables::Case {
        for (attribute, _) in rom_attributes(module.block_rom) {
            let _ = writeln!(text, "    attribute {attribute} : string;");
        }
    }
    for table in &module.tables {
        rom(module, table, text);
    }
    if !module.tables.is_empty() {
        text.push('\n');
    }
    // Synthesis ignores initial values of wires and uses those of registers as power-up values.
    text.push_str(
        "    -- Words start at zero: numeric_std warns about comparing or indexing with undefined words.\n",
    );
    if module.latency > 0 {
        text.push_str("    -- Valid bits don't, so a bit that a reset misses shows as unknown.\n");
    }
    let declare = |text: &mut String, id: WordId| {
        let word = module.word(id);
        let _ =
            writeln!(text, "    signal {} : {}{ZERO};{}", word.name, shape(word), comment(word));
    };
    let declared: BTreeSet<WordId> =
        module.stages.iter().flat_map(|stage| stage.declared.iter().copied()).collect();
    for (number, stage) in module.stages.iter().enumerate() {
        let last = number + 1 == module.stages.len();
        if !(last && stage.items.is_empty()) {
            let _ = writeln!(text, "    -- {}", stage.title);
        }
        for id in &stage.declared {
            declare(text, *id);
        }
        for item in &stage.items {
            match item {
                Item::Assign(id, _) if !declared.contains(id) => declare(text, *id),
                Item::Assign(..) | Item::Scope(_) => {}
            }
        }
        for Register { word, .. } in &stage.registers {
            if module.word(*word).driver != Driver::OutputRegister && !declared.contains(word) {
                declare(text, *word);
            }
        }
        for valid in &stage.valid {
            let _ = writeln!(text, "    signal {} : std_logic;", valid.to);
        }
    }
}

/// The wanted name, or a longer one if a word has it: hiding a word would cause a warning.
fn own_name(module: &Module, wanted: &str) -> String {
    let words = module.words.iter().map(|word| &word.name);
    let outputs = module.driven().map(|(name, _)| name);
    let tables = module.tables.iter().map(|table| table.name.as_str());
    let words = words.map(String::as_str);
    let taken: BTreeSet<&str> = words.chain(outputs).chain(tables).collect();
    let mut name = wanted.to_owned();
    while taken.contains(&name[..]) {
        name.push_str("_l");
    }
    name
}

fn rom(module: &Module, table: &RomTable, text: &mut String) {
    let RomTable { name, title, addr_bits, row_bits, columns, copy_of, write } = table;
    let columns: Vec<String> =
        columns.iter().map(|column| format!("{} {}", column.name, column.format)).collect();
    let copy = if copy_of.is_some() { "a copy of " } else { "" };
    let kind = if write.is_some() { "memory" } else { "table" };
    let _ = writeln!(text, "\n    -- {copy}{kind} {title}: {}", columns.join(", "));
    let row_of = |digits: &str| {
        if *row_bits == 1 { format!("\"{digits}\"") } else { format!("{row_bits}x\"{digits}\"") }
    };
    let (top, last) = (row_bits - 1, table.len() - 1);
    let own = |wanted: &str| own_name(module, wanted);
    let address = own("address");
    if write.is_some() {
        let rows = own(&format!("{name}_rows"));
        let _ = writeln!(
            text,
            "    type {rows} is array (0 to {last}) of unsigned({top} downto 0);\n    signal {name} : {rows} := (others => (others => '0'));"
        );
        return;
    }
    if module.tables_in == Tables::Case {
        let top = addr_bits - 1;
        let _ = write!(
            text,
            "    function {name}({address} : unsigned({top} downto 0)) return unsigned is
    begin
        case {address} is
"
        );
        for (number, row) in table.rows().enumerate() {
            let number = cast::count_of(number);
            let label = if number == last {
                "others".to_owned()
            } else {
                literal(number.into(), *addr_bits)
            };
            let _ = writeln!(text, "            when {label} => return {};", row_of(&row));
        }
        text.push_str("        end case;\n    end function;\n");
        return;
    }
    let original = copy_of.map_or(name, |of| &module.tables[of].name);
    let rows = own(&format!("{original}_rows"));
    let array = format!("array (0 to {last}) of unsigned({top} downto 0)");
    if copy_of.is_some() {
        let _ = writeln!(text, "    constant {name} : {rows} := {original};");
    } else if module.tables_in == Tables::Files {
        let _ = writeln!(text, "    type {rows} is {array};");
        let read = own(&format!("{name}_file"));
        let (source, row, all_rows) = (own("source"), own("row"), own("all_rows"));
        let file = module.table_file(table);
        let _ = write!(
            text,
            "    impure function {read} return {rows} is
        file {source} : text open read_mode is \"{file}\";
        variable {row} : line;
        variable {all_rows} : {rows};
    begin
        for {address} in {all_rows}'range loop
            readline({source}, {row});
            hread({row}, {all_rows}({address}));
        end loop;
        return {all_rows};
    end function;
    constant {name} : {rows} := {read};
"
        );
    } else {
        let _ = writeln!(text, "    type {rows} is {array};\n    constant {name} : {rows} := (");
        let all: Vec<String> = table.rows().map(|row| row_of(&row)).collect();
        let lines: Vec<String> = all.chunks(ROWS_A_LINE).map(|rows| rows.join(", ")).collect();
        let _ = writeln!(text, "        {}\n    );", lines.join(",\n        "));
    }
    for (attribute, value) in rom_attributes(module.block_rom) {
        let _ = writeln!(text, "    attribute {attribute} of {name} : constant is \"{value}\";");
    }
}

/// The write port of a RAM.
fn writes(module: &Module, table: &RomTable, text: &mut String) {
    let Some(WritePort { enable, address, data }) = &table.write else { return };
    let name_of = |id: &WordId| &module.word(*id).name[..];
    let row: Vec<String> = data.iter().map(|id| format!("unsigned({})", name_of(id))).collect();
    let _ = write!(
        text,
        "
    process (clk)
    begin
        if rising_edge(clk) then
            if {} = \"1\" then
                {}(to_integer({})) <= {};
            end if;
        end if;
    end process;
",
        name_of(enable),
        table.name,
        name_of(address),
        row.join(" & ")
    );
}

/// Registers between a stage and the next, and the valid bits.
fn registers(module: &Module, stage: &Stage, text: &mut String) {
    if stage.registers.is_empty() && stage.valid.is_empty() {
        return;
    }
    text.push_str("\n    process (clk)\n    begin\n        if rising_edge(clk) then\n");
    let printer = Printer { module };
    let enable = |(load, valid): &Enable| {
        let is_set = |name: String| format!(" and {name} = '1'");
        let flag = load.map(|flag| is_set(printer.bit(flag))).unwrap_or_default();
        let valid = valid.clone().map(is_set).unwrap_or_default();
        format!("ce = '1'{flag}{valid}")
    };
    let taken = |next: &Next| match next {
        Next::Word(from) => module.word(*from).name.clone(),
        Next::Read(table, address) => printer.read_on_clock(*table, *address),
    };
    for (under, group) in stage.groups() {
        let _ = writeln!(text, "            if {} then", enable(&under));
        for register in group {
            let name = &module.word(register.word).name;
            let _ = writeln!(text, "                {name} <= {};", taken(&register.next));
        }
        text.push_str("            end if;\n");
    }
    let mut cleared = |to: &str, zero: &str, under: &Enable, from: &str| {
        let enable = enable(under);
        let _ = write!(
            text,
            "            if rst = '1' then
                {to} <= {zero};
            elsif {enable} then
                {to} <= {from};
            end if;
"
        );
    };
    for register in stage.registers.iter().filter(|register| register.reset) {
        let name = &module.word(register.word).name;
        cleared(name, "(others => '0')", &register.enable(), &taken(&register.next));
    }
    for Valid { from, to, load } in &stage.valid {
        cleared(to, "'0'", &(*load, None), from);
    }
    text.push_str("        end if;\n    end process;\n");
}

fn literal(pattern: u128, bits: u32) -> String {
    if bits <= 3 {
        let digits = usize::try_from(bits).expect("bug: small");
        return format!("\"{pattern:0digits$b}\"");
    }
    let digits = usize::try_from(bits.div_ceil(4)).expect("bug: 32 bits fit");
    format!("{bits}x\"{pattern:0digits$x}\"")
}

/// A whole word, extended or cut to `bits`.
fn whole(word: WordId, bits: u32) -> Operand {
    Operand::View(View { word, lo: 0, zeros: 0, bits })
}

struct Printer<'a> {
    module: &'a Module,
}

impl Printer<'_> {
    /// A row for a register, as loaded by a block RAM's own register.
    fn read_on_clock(&self, table: usize, address: WordId) -> String {
        let RomTable { name, addr_bits, write, .. } = &self.module.tables[table];
        let address = self.operand(whole(address, *addr_bits), false);
        if self.module.tables_in == Tables::Case && write.is_none() {
            format!("{name}({address})")
        } else {
            format!("{name}(to_integer({address}))")
        }
    }

    /// A row for logic. It is selected from one row of each half of the table, so that no row goes
    /// directly into a register: a tool that loses GHDL's attributes of constants on the way would
    /// infer a block RAM.
    fn read(&self, table: usize, address: WordId) -> String {
        let RomTable { name, addr_bits, .. } = &self.module.tables[table];
        let top = addr_bits - 1;
        if self.module.tables_in == Tables::Case || top == 0 {
            return self.read_on_clock(table, address);
        }
        let chosen = self.bit(Bit { word: address, bit: top });
        let low = self.operand(whole(address, top), false);
        let half = |bit: u32| format!("{name}(to_integer('{bit}' & {low}))");
        format!("{} when {chosen} = '1' else {}", half(1), half(0))
    }

    fn bit(&self, bit: Bit) -> String {
        format!("{}({})", self.module.word(bit.word).name, bit.bit)
    }

    /// True if the operand is part of a signed word.
    fn is_signed(&self, operand: Operand) -> bool {
        match operand {
            Operand::Literal { .. } => false,
            Operand::View(view) => self.module.word(view.word).signed,
        }
    }

    /// The operand with all its bits, as `signed` or `unsigned`.
    fn operand(&self, operand: Operand, signed: bool) -> String {
        match operand {
            Operand::Literal { pattern, bits } => literal(pattern, bits),
            Operand::View(View { word, lo, zeros, bits }) => {
                let word = self.module.word(word);
                let room = bits.saturating_sub(zeros);
                let have = (word.bits - lo).min(room);
                if have == 0 {
                    return literal(0, bits);
                }
                let mut text = word.name.clone();
                if have < word.bits {
                    let _ = write!(text, "({} downto {lo})", lo + have - 1);
                }
                if have < bits {
                    text = format!("resize({text}, {bits})");
                }
                if zeros > 0 {
                    text = format!("shift_left({text}, {zeros})");
                }
                if word.signed == signed { text } else { format!("{}({text})", sign(signed)) }
            }
        }
    }

    fn expr(&self, expr: &Expr, to: &Word) -> String {
        let operand = |operand: &Operand| self.operand(*operand, to.signed);
        match expr {
            Expr::Copy(a) => operand(a),
            Expr::Add(a, b) => format!("{} + {}", operand(a), operand(b)),
            Expr::Sub(a, b) => format!("{} - {}", operand(a), operand(b)),
            Expr::AddCarry(a, b, bit) => {
                format!("{} + {} + {}", operand(a), operand(b), self.bit(*bit))
            }
            // VHDL-2008 has an operator for a word and a single bit, but GHDL doesn't synthesise
            // it.
            Expr::InvertIf(bit, a) => {
                format!("{} xor ({} downto 0 => {})", operand(a), to.bits - 1, self.bit(*bit))
            }
            Expr::Negate(a) if to.signed => format!("-{}", operand(a)),
            // Only signed numbers have a unary minus.
            Expr::Negate(a) => format!("unsigned(-{})", self.operand(*a, true)),
            Expr::Multiply(a, b) => self.product(*a, *b, to),
            Expr::Bitwise(operator, a, b) => {
                let operator = match operator {
                    Bitwise::And => "and",
                    Bitwise::Or => "or",
                    Bitwise::Xor => "xor",
                };
                let side = |id: &WordId| self.operand(whole(*id, to.bits), to.signed);
                format!("{} {operator} {}", side(a), side(b))
            }
            Expr::Equal(a, b) => {
                let signed = self.is_signed(*a) && self.is_signed(*b);
                let (a, b) = (self.operand(*a, signed), self.operand(*b, signed));
                format!("\"1\" when {a} = {b} else \"0\"")
            }
            Expr::Less { a, b, signed } => {
                let (a, b) = (self.operand(*a, *signed), self.operand(*b, *signed));
                format!("\"1\" when {a} < {b} else \"0\"")
            }
            Expr::Choose { cases, default } => {
                let mut text = String::new();
                for (bit, value) in cases {
                    let _ = write!(text, "{} when {} = '1' else ", operand(value), self.bit(*bit));
                }
                text + &operand(default)
            }
            Expr::Concat(parts) => {
                let parts: Vec<String> = parts.iter().map(operand).collect();
                parts.join(" & ")
            }
            Expr::ShiftLeft(a, count) => {
                let count = self.operand(whole(*count, self.module.word(*count).bits), false);
                format!("shift_left({}, to_integer({count}))", operand(a))
            }
            Expr::Above { word, keep } => {
                let Word { name, bits, signed, .. } = self.module.word(*word);
                let top = bits - 1;
                if *signed {
                    let above = format!("{name}({} downto {keep})", top - 1);
                    format!("\"1\" when {name}({top}) = '0' and (or {above}) = '1' else \"0\"")
                } else {
                    format!("\"1\" when (or {name}({top} downto {keep})) = '1' else \"0\"")
                }
            }
            Expr::Below { word, keep } => {
                let Word { name, bits, .. } = self.module.word(*word);
                let top = bits - 1;
                let above = format!("{name}({} downto {keep})", top - 1);
                format!("\"1\" when {name}({top}) = '1' and (and {above}) = '0' else \"0\"")
            }
            Expr::Read(table, address) => self.read(*table, *address),
        }
    }

    /// A product has the bits of both factors. Where the result has fewer, the missing bits carry
    /// no information: this is the only place where a number may be resized to fewer bits.
    fn product(&self, a: WordId, b: WordId, to: &Word) -> String {
        let any = self.module.word(a).signed || self.module.word(b).signed;
        let factor = |id: WordId| {
            let word = self.module.word(id);
            if any && !word.signed {
                (format!("signed('0' & {})", word.name), word.bits + 1)
            } else {
                (word.name.clone(), word.bits)
            }
        };
        let ((a, a_bits), (b, b_bits)) = (factor(a), factor(b));
        let mut text = format!("{a} * {b}");
        if any != to.signed {
            text = format!("{}({text})", sign(to.signed));
        }
        if a_bits + b_bits == to.bits { text } else { format!("resize({text}, {})", to.bits) }
    }
}
