-- rsqrt: 1/sqrt(a) by a table, a table with interpolation, or a table and a Newton step
-- made by fixpath 0.1.0; the inverse square root unit of US 6,980,218, FIG. 8
--   input_bits=20 input_frac_bits=18 root_int_bits=9 root_scheme=linear root_addr_bits=9
--   root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 6 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   r_relative: mean 1.23e-6, largest seen 4.83e-6 over the result, at a=269281
--   r_scaled: mean 9.98e-7, largest seen 4.76e-6 over the result, at least 1, at a=269281
--   r: mean 5.17e-5, largest seen 1.46e-3 (383.0 ulp) at a=1
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at a=155754
-- stated bound on each relative (relative to the result): 1.37e-5
-- stated bound on each scaled (relative to the result, at least 1): 1.18e-5
-- stated bound on each absolute: 5.08e-3
-- stated bound on each flag: 0.00e0
--
-- Self-checking testbench of rsqrt.
-- Each line of rsqrt_vectors.txt holds the input words and then the
-- expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
-- per cycle. The second pass sends the first 213 again with stalls and gaps,
-- with a reset in mid-stream. Every bit of every output and the latency are compared.
-- The last line says PASS or FAIL; a failure ends with a nonzero status, for which GHDL prints one
-- more line. With --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity rsqrt_tb is
end entity;

architecture test of rsqrt_tb is
    constant latency : natural := 6;
    constant shown : natural := 10; -- of the mismatches

    -- The prefix dut_ keeps the ports' names apart from the names used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_a : unsigned(19 downto 0) := (others => '0');
    signal dut_r : unsigned(26 downto 0);
    signal dut_degenerate : unsigned(0 downto 0);
    signal done : boolean := false;

    function hex(word : std_logic_vector) return string is
        variable digits : string(1 to (word'length + 3) / 4) := to_hstring(word);
    begin
        for i in digits'range loop
            if digits(i) >= 'A' and digits(i) <= 'F' then
                digits(i) := character'val(character'pos(digits(i)) + 32);
            end if;
        end loop;
        return digits;
    end function;
begin
    dut : entity work.rsqrt
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            a => dut_a,
            r => dut_r,
            degenerate => dut_degenerate
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(27 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 213;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_a : std_logic_vector(19 downto 0) := (others => '0');
        variable next_r : std_logic_vector(26 downto 0) := (others => '0');
        variable next_degenerate : std_logic_vector(0 downto 0) := (others => '0');

        procedure print(message : string) is
        begin
            write(output, message & LF);
        end procedure;

        procedure mismatch(message : string) is
        begin
            mismatches := mismatches + 1;
            if mismatches <= shown then
                print("mismatch: " & message);
            end if;
        end procedure;

        procedure open_vectors is
            variable status : file_open_status;
        begin
            sent := 0;
            checked := 0;
            more := true;
            reset_done := false;
            file_open(status, vectors, "rsqrt_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: rsqrt_vectors.txt can't be read");
                std.env.finish(1);
            end if;
        end procedure;

        procedure read_vector is
            variable words : line;
            variable good : boolean;
        begin
            more := false;
            while not endfile(vectors) and not more loop
                readline(vectors, words);
                more := words'length > 0;
            end loop;
            if more then
                hread(words, next_a, good);
                more := more and good;
                hread(words, next_r, good);
                more := more and good;
                hread(words, next_degenerate, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: rsqrt_vectors.txt is cut short after vector " & to_string(sent));
                end if;
            end if;
        end procedure;

        procedure check is
            procedure check_port(port_name : string; want, got : std_logic_vector) is
            begin
                if got /= want then
                    mismatch("vector " & to_string(number(latency)) & " " & port_name
                        & " expected " & hex(want) & " got " & hex(got));
                end if;
            end procedure;
        begin
            -- Nothing is known before the first edge under reset.
            if started and valid_out /= valid(latency) then
                mismatch("vector " & to_string(checked) & " valid_out expected "
                    & to_string(valid(latency)) & " got " & to_string(valid_out));
            end if;
            -- Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if ce = '1' and valid(latency) = '1' then
                check_port("r", expected(latency)(27 downto 1),
                    std_logic_vector(dut_r));
                check_port("degenerate", expected(latency)(0 downto 0),
                    std_logic_vector(dut_degenerate));
                checked := checked + 1;
            end if;
        end procedure;

        procedure move_on is
        begin
            for i in latency downto 1 loop
                if rst = '1' then
                    valid(i) := '0';
                elsif ce = '1' then
                    valid(i) := valid(i - 1);
                end if;
                if ce = '1' then
                    expected(i) := expected(i - 1);
                    number(i) := number(i - 1);
                end if;
            end loop;
        end procedure;

        -- Sets the inputs after this edge. They don't change while the pipeline is stalled.
        procedure drive is
        begin
            lfsr := lfsr(30 downto 0) & (lfsr(31) xor lfsr(21) xor lfsr(1) xor lfsr(0));
            rst <= '0';
            ce <= '1';
            if stalls and lfsr(2 downto 0) = 0 then
                ce <= '0';
            end if;
            if ce = '1' then
                valid(0) := '0';
                if more and not (stalls and lfsr(5 downto 3) = 0) then
                    read_vector;
                    if more then
                        valid(0) := '1';
                        expected(0)(27 downto 1) := next_r;
                        expected(0)(0 downto 0) := next_degenerate;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 213 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- In a gap the inputs are the complement of the latest words.
                if valid(0) = '1' then
                    dut_a <= unsigned(next_a);
                else
                    dut_a <= unsigned(not next_a);
                end if;
            end if;
            -- A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if stalls and not reset_done and sent = 213 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: rsqrt_vectors.txt holds " & to_string(passed)
                    & " vectors and should hold " & to_string(count));
            end if;
            if mismatches = 0 and passed = count then
                print("PASS " & to_string(passed) & " vectors");
                done <= true;
            else
                print("FAIL " & to_string(mismatches) & " mismatches in " & to_string(passed)
                    & " vectors");
                std.env.finish(1);
            end if;
        end procedure;
    begin
        open_vectors;
        while not done loop
            wait until rising_edge(clk);
            check;
            if rst = '1' and stalls then
                -- Words in flight are lost. The word that hasn't entered yet isn't.
                for i in 1 to latency loop
                    if valid(i) = '1' then
                        checked := checked + 1;
                    end if;
                end loop;
            end if;
            move_on;
            drive;
            started := true;
            if not more and checked = sent then
                file_close(vectors);
                if not stalls then
                    passed := checked;
                    stalls := true;
                    open_vectors;
                else
                    finish;
                    wait;
                end if;
            end if;
        end loop;
    end process;
end architecture;
