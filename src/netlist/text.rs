//! A netlist as text, and as a graph for Graphviz.

use super::{Netlist, Node, Quantity, Rate, ScopeId};
use crate::base::cast;
use crate::netlist::op::Op;
use std::fmt::Write as _;

impl Netlist {
    /// Readable text form: one line per node.
    #[must_use]
    pub fn to_text(&self) -> String {
        let mut text = format!("netlist {}\n", self.name);
        let tables: Vec<String> = self.tables.iter().map(|table| table.name.clone()).collect();
        for table in &self.tables {
            let columns: Vec<String> =
                table.columns.iter().map(|c| format!("{} {}", c.name, c.format)).collect();
            let kind = if table.memory.is_some() { "memory" } else { "table" };
            let _ = writeln!(
                text,
                "  {kind} {}[{}]: {}",
                table.name,
                1u64 << table.addr_bits,
                columns.join(", ")
            );
        }
        for (id, node) in self.ids().zip(&self.nodes) {
            let _ = write!(text, "  %{} = {}", id.number, self.describe(node, &tables));
            for operand in &node.operands {
                let _ = write!(text, " %{}", operand.number);
            }
            let _ = write!(text, " : {}", node.format);
            if node.quantity != Quantity::Number {
                let _ = write!(text, " {}", node.quantity.name());
            }
            if node.op == Op::Input && node.rate != Rate::default() {
                let _ = write!(text, " per {}", node.rate);
            }
            if node.name.is_some() {
                let _ = write!(text, "  # {}", self.label(id));
            }
            text.push('\n');
        }
        for output in &self.outputs {
            let _ = writeln!(text, "  output {} = %{}", output.name, output.node.number);
        }
        text
    }

    /// An operation with its attributes, without operands. `tables` are the names of the tables.
    pub(super) fn describe(&self, node: &Node, tables: &[String]) -> String {
        let name = node.op.name();
        if let Op::Const { raw } = node.op {
            format!("{name} {raw}")
        } else if let Op::Slice { lo } = node.op {
            format!("{name}[{}:{lo}]", lo + node.format.bits() - 1)
        } else if let Op::Shift { left } = node.op {
            format!("{name} {left:+}")
        } else if let Op::ShiftLeft { max } = node.op {
            format!("{name} max {max}")
        } else if let Op::Read { table, column } = node.op {
            let columns = &self.tables[table.index()].columns;
            let column = &columns[cast::index_of_u32(column)];
            format!("{name} {}.{}", tables[table.index()], column.name)
        } else if let Op::Delay { samples } = node.op {
            format!("{name} {samples}")
        } else if let Op::Narrow { round, overflow } = node.op {
            format!("{name} {round} {overflow}")
        } else {
            name.to_owned()
        }
    }

    /// Graphviz form; scopes become clusters.
    #[must_use]
    pub fn to_dot(&self) -> String {
        let mut text = format!(
            "digraph {} {{\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\", fontsize=10];\n",
            self.name
        );
        let tables: Vec<String> = self.tables.iter().map(|table| table.name.clone()).collect();
        for (s, scope) in self.scopes.iter().enumerate() {
            let indent = if s == 0 { "  " } else { "    " };
            if s > 0 {
                let path = self.scope_path(ScopeId(cast::id_of(s))).join(".");
                let _ = writeln!(text, "  subgraph cluster_{s} {{ label=\"{path}\"; color=gray;");
            }
            for (id, node) in self.ids().zip(&self.nodes).filter(|(_, n)| n.scope.index() == s) {
                let name = node.name.as_deref().map(|n| format!("{n}\\n")).unwrap_or_default();
                let shape = if node.op == Op::Input {
                    ", shape=cds"
                } else if matches!(node.op, Op::Read { .. }) {
                    ", shape=cylinder"
                } else if node.op == Op::Mul {
                    ", style=filled, fillcolor=\"#ffd9b3\""
                } else if scope.part.is_some() {
                    ", style=dotted"
                } else {
                    ""
                };
                let _ = writeln!(
                    text,
                    "{indent}n{} [label=\"{name}{}\\n{}\"{shape}];",
                    id.number,
                    self.describe(node, &tables),
                    node.format
                );
            }
            if s > 0 {
                text.push_str("  }\n");
            }
        }
        for (id, node) in self.ids().zip(&self.nodes) {
            for operand in &node.operands {
                let _ = writeln!(text, "  n{} -> n{};", operand.number, id.number);
            }
        }
        for output in &self.outputs {
            let _ = writeln!(
                text,
                "  out_{0} [label=\"{0}\", shape=cds]; n{1} -> out_{0};",
                output.name, output.node.number
            );
        }
        text.push_str("}\n");
        text
    }
}
