//! Names that are legal in every language.

use std::collections::BTreeSet;

/// Keywords of Verilog, SystemVerilog, VHDL and C++, and names that a module or testbench declares
/// itself. They are in lower case, since VHDL ignores case.
const RESERVED: &[&str] = &[
    // Ports of every module, and names used by testbenches, libraries and tools.
    "clk rst ce valid_in valid_out unused work ieee std main top numeric_std \
     std_logic_1164 textio std_logic std_logic_vector std_ulogic resize shift_left \
     shift_right to_integer to_unsigned to_signed boolean bit bit_vector character string \
     natural positive line text width side input output now true false rising_edge \
     falling_edge hread hwrite read read_mode rom_block rom_style romstyle syn_romstyle write readline writeline \
     to_string to_hstring minimum maximum error note failure",
    // Verilog-2005 and SystemVerilog-2017.
    "accept_on alias always always_comb always_ff always_latch and assert assign assume \
     automatic before begin bind bins binsof break buf bufif0 bufif1 byte case casex \
     casez cell chandle checker class clocking cmos config const constraint context \
     continue cover covergroup coverpoint cross deassign default defparam design disable \
     dist do edge else end endcase endchecker endclass endclocking endconfig endfunction \
     endgenerate endgroup endinterface endmodule endpackage endprimitive endprogram \
     endproperty endsequence endspecify endtable endtask enum event eventually expect \
     export extends extern final first_match for force foreach forever fork forkjoin \
     function generate genvar global highz0 highz1 if iff ifnone ignore_bins illegal_bins \
     implements implies import incdir include initial inout inside instance int integer \
     interconnect interface intersect join join_any join_none large let liblist library \
     local localparam logic longint macromodule matches medium modport module nand \
     negedge nettype new nexttime nmos nor noshowcancelled not notif0 notif1 null or \
     package packed parameter pmos posedge primitive priority program property protected \
     pull0 pull1 pulldown pullup pulsestyle_ondetect pulsestyle_onevent pure rand randc \
     randcase randsequence rcmos real realtime ref reg reject_on release repeat restrict \
     return rnmos rpmos rtran rtranif0 rtranif1 s_always s_eventually s_nexttime s_until \
     s_until_with scalared sequence shortint shortreal showcancelled signed small soft \
     solve specify specparam static strong strong0 strong1 struct super supply0 supply1 \
     sync_accept_on sync_reject_on table tagged task this throughout time timeprecision \
     timeunit tran tranif0 tranif1 tri tri0 tri1 triand trior trireg type typedef union \
     unique unique0 unsigned until until_with untyped use uwire var vectored virtual void \
     wait wait_order wand weak weak0 weak1 while wildcard wire with within wor xnor xor",
    // VHDL-2008.
    "abs access after all architecture array assume_guarantee attribute block body buffer \
     bus component configuration constant disconnect downto elsif entity exit fairness \
     file generic group guarded impure in inertial is label linkage literal loop map mod \
     next of on open others out port postponed procedure process range record register \
     reject rem report restrict_guarantee rol ror select severity signal shared sla sll \
     sra srl subtype then to transport unaffected units variable vmode vprop vunit when",
    // C++, for harnesses, and macros that g++ predefines.
    "alignas alignof and_eq asm auto bitand bitor bool catch char char8_t char16_t char32_t \
     co_await co_return co_yield compl concept const_cast consteval constexpr constinit decltype \
     delete double dynamic_cast errno explicit float friend goto inline int8_t int16_t int32_t \
     int64_t linux long mutable namespace noexcept not_eq nullptr operator private public \
     reinterpret_cast requires short size_t sizeof static_assert static_cast switch template \
     thread_local throw try typeid typename uint8_t uint16_t uint32_t uint64_t unix using \
     volatile wchar_t xor_eq",
    // Common C++ and SystemC words that Verilator warns about as well, and SystemVerilog classes
    // that it treats as keywords.
    "abort atomic_cancel atomic_commit atomic_noexcept cdecl complex const_iterator \
     const_reference deque far huge interrupt iterator list mailbox near pascal queue reference \
     sc_clock sc_in sc_inout sc_out sc_signal semaphore sensitive sensitive_neg sensitive_pos \
     set stack synchronized transaction_safe transaction_safe_dynamic type_info vector",
    // Keywords of Icarus and GHDL beyond the standards that we select.
    "inherit wone wreal",
    // Members of Verilator's classes other than ports.
    "contextp eval eval_end_step eval_step name rootp threads trace",
];

/// True for a name that none of our words may have.
pub(super) fn is_reserved(name: &str) -> bool {
    RESERVED.iter().any(|words| words.split(' ').any(|word| word == name)) || is_valid_bit(name)
}

/// True for the valid bit of a stage: `valid_s1` and so on.
fn is_valid_bit(name: &str) -> bool {
    name.strip_prefix("valid_s").is_some_and(|stage| stage.bytes().all(|b| b.is_ascii_digit()))
}

/// Hands out each name once.
#[derive(Debug, Default)]
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// The wanted name, or one derived from it: a reserved word gets `_w`, a name in use gets a
    /// number.
    pub(super) fn take(&mut self, wanted: &str) -> String {
        let base = if is_reserved(wanted) { format!("{wanted}_w") } else { wanted.to_owned() };
        let name = (1..)
            .map(|n| if n == 1 { base.clone() } else { format!("{base}_{n}") })
            .find(|name| !self.taken.contains(name))
            .expect("bug: there is no end of numbers");
        self.taken.insert(name.clone());
        name
    }
}
