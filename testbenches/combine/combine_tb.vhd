-- combine: diffuse light plus the differences of height samples: the emboss of one to eight lights
-- made by fixpath 0.1.0; seed 000 (US 6,980,218), the texture combination of the emboss; seed 003 has the same text
--   filter=bilinear lights=1 difference=undisplaced-displaced channel_bits=8 fraction_bits=8
--   guard_bits=4 gain_log2=0 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 4 cycles, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   out_r: mean 1.94e-1, largest seen 5.91e-1 (0.6 ulp) at h_00=188 h_10=50 h_01=155 h_11=31 h_a=110 h_b=236 d0_00=43 d0_10=113 d0_01=189 d0_11=244 d0_a=153 d0_b=59 r=146 g=32 b=19
--   out_g: mean 1.95e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
--   out_b: mean 1.94e-1, largest seen 5.98e-1 (0.6 ulp) at h_00=20 h_10=11 h_01=211 h_11=127 h_a=6 h_b=211 d0_00=155 d0_10=38 d0_01=7 d0_11=98 d0_a=114 d0_b=229 r=133 g=105 b=125
-- stated bound on each channel: 6.25e-1
--
-- Self-checking testbench of combine. It reads combine_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 240 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity combine_tb is
end entity;

architecture test of combine_tb is
    constant latency : natural := 4;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_h_00 : unsigned(7 downto 0) := (others => '0');
    signal dut_h_10 : unsigned(7 downto 0) := (others => '0');
    signal dut_h_01 : unsigned(7 downto 0) := (others => '0');
    signal dut_h_11 : unsigned(7 downto 0) := (others => '0');
    signal dut_h_a : unsigned(7 downto 0) := (others => '0');
    signal dut_h_b : unsigned(7 downto 0) := (others => '0');
    signal dut_d0_00 : unsigned(7 downto 0) := (others => '0');
    signal dut_d0_10 : unsigned(7 downto 0) := (others => '0');
    signal dut_d0_01 : unsigned(7 downto 0) := (others => '0');
    signal dut_d0_11 : unsigned(7 downto 0) := (others => '0');
    signal dut_d0_a : unsigned(7 downto 0) := (others => '0');
    signal dut_d0_b : unsigned(7 downto 0) := (others => '0');
    signal dut_r : unsigned(7 downto 0) := (others => '0');
    signal dut_g : unsigned(7 downto 0) := (others => '0');
    signal dut_b : unsigned(7 downto 0) := (others => '0');
    signal dut_out_r : unsigned(7 downto 0);
    signal dut_out_g : unsigned(7 downto 0);
    signal dut_out_b : unsigned(7 downto 0);
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
    dut : entity work.combine
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            h_00 => dut_h_00,
            h_10 => dut_h_10,
            h_01 => dut_h_01,
            h_11 => dut_h_11,
            h_a => dut_h_a,
            h_b => dut_h_b,
            d0_00 => dut_d0_00,
            d0_10 => dut_d0_10,
            d0_01 => dut_d0_01,
            d0_11 => dut_d0_11,
            d0_a => dut_d0_a,
            d0_b => dut_d0_b,
            r => dut_r,
            g => dut_g,
            b => dut_b,
            out_r => dut_out_r,
            out_g => dut_out_g,
            out_b => dut_out_b
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(23 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 240;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_h_00 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_h_10 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_h_01 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_h_11 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_h_a : std_logic_vector(7 downto 0) := (others => '0');
        variable next_h_b : std_logic_vector(7 downto 0) := (others => '0');
        variable next_d0_00 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_d0_10 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_d0_01 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_d0_11 : std_logic_vector(7 downto 0) := (others => '0');
        variable next_d0_a : std_logic_vector(7 downto 0) := (others => '0');
        variable next_d0_b : std_logic_vector(7 downto 0) := (others => '0');
        variable next_r : std_logic_vector(7 downto 0) := (others => '0');
        variable next_g : std_logic_vector(7 downto 0) := (others => '0');
        variable next_b : std_logic_vector(7 downto 0) := (others => '0');
        variable next_out_r : std_logic_vector(7 downto 0) := (others => '0');
        variable next_out_g : std_logic_vector(7 downto 0) := (others => '0');
        variable next_out_b : std_logic_vector(7 downto 0) := (others => '0');

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
            file_open(status, vectors, "combine_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: combine_vectors.txt can't be read");
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
                hread(words, next_h_00, good);
                more := more and good;
                hread(words, next_h_10, good);
                more := more and good;
                hread(words, next_h_01, good);
                more := more and good;
                hread(words, next_h_11, good);
                more := more and good;
                hread(words, next_h_a, good);
                more := more and good;
                hread(words, next_h_b, good);
                more := more and good;
                hread(words, next_d0_00, good);
                more := more and good;
                hread(words, next_d0_10, good);
                more := more and good;
                hread(words, next_d0_01, good);
                more := more and good;
                hread(words, next_d0_11, good);
                more := more and good;
                hread(words, next_d0_a, good);
                more := more and good;
                hread(words, next_d0_b, good);
                more := more and good;
                hread(words, next_r, good);
                more := more and good;
                hread(words, next_g, good);
                more := more and good;
                hread(words, next_b, good);
                more := more and good;
                hread(words, next_out_r, good);
                more := more and good;
                hread(words, next_out_g, good);
                more := more and good;
                hread(words, next_out_b, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: combine_vectors.txt is cut short after vector " & to_string(sent));
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
            -- Each word counts once: in the cycle after which the pipeline moves on.
            if ce = '1' and valid(latency) = '1' then
                check_port("out_r", expected(latency)(23 downto 16),
                    std_logic_vector(dut_out_r));
                check_port("out_g", expected(latency)(15 downto 8),
                    std_logic_vector(dut_out_g));
                check_port("out_b", expected(latency)(7 downto 0),
                    std_logic_vector(dut_out_b));
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

        -- What goes in after this edge: words stay where the pipeline stood still.
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
                        expected(0)(23 downto 16) := next_out_r;
                        expected(0)(15 downto 8) := next_out_g;
                        expected(0)(7 downto 0) := next_out_b;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 240 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- A gap carries the opposite of the latest word.
                if valid(0) = '1' then
                    dut_h_00 <= unsigned(next_h_00);
                    dut_h_10 <= unsigned(next_h_10);
                    dut_h_01 <= unsigned(next_h_01);
                    dut_h_11 <= unsigned(next_h_11);
                    dut_h_a <= unsigned(next_h_a);
                    dut_h_b <= unsigned(next_h_b);
                    dut_d0_00 <= unsigned(next_d0_00);
                    dut_d0_10 <= unsigned(next_d0_10);
                    dut_d0_01 <= unsigned(next_d0_01);
                    dut_d0_11 <= unsigned(next_d0_11);
                    dut_d0_a <= unsigned(next_d0_a);
                    dut_d0_b <= unsigned(next_d0_b);
                    dut_r <= unsigned(next_r);
                    dut_g <= unsigned(next_g);
                    dut_b <= unsigned(next_b);
                else
                    dut_h_00 <= unsigned(not next_h_00);
                    dut_h_10 <= unsigned(not next_h_10);
                    dut_h_01 <= unsigned(not next_h_01);
                    dut_h_11 <= unsigned(not next_h_11);
                    dut_h_a <= unsigned(not next_h_a);
                    dut_h_b <= unsigned(not next_h_b);
                    dut_d0_00 <= unsigned(not next_d0_00);
                    dut_d0_10 <= unsigned(not next_d0_10);
                    dut_d0_01 <= unsigned(not next_d0_01);
                    dut_d0_11 <= unsigned(not next_d0_11);
                    dut_d0_a <= unsigned(not next_d0_a);
                    dut_d0_b <= unsigned(not next_d0_b);
                    dut_r <= unsigned(not next_r);
                    dut_g <= unsigned(not next_g);
                    dut_b <= unsigned(not next_b);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 240 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: combine_vectors.txt holds " & to_string(passed)
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
                -- Forgotten, but for what hasn't gone in yet.
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
