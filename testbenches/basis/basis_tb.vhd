-- basis: binormal and tangent from normal and tangent: N x CT, normalised, x N
-- made by fixpath 0.1.0; seed 002 (GL_NV_texgen_emboss), section 2.10.4
--   component_bits=16 guard_bits=0 norm_bits=18 dot_frac_bits=20 root_scheme=linear
--   root_addr_bits=9 root_frac_bits=18 rounding=half-up period_ps=5000 stages=auto rom=block
-- latency 17 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   t_angle: mean 2.57e-5 rad, largest seen 9.63e-5 rad at normal_x=8380 normal_y=9641 normal_z=-7349 ct_x=13930 ct_y=3067 ct_z=4821
--   t_dot: mean 3.53e-5, largest seen 9.39e-5 at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
--   t_x: mean 1.77e-5, largest seen 7.84e-5 (1.3 ulp) at normal_x=9018 normal_y=13214 normal_z=12085 ct_x=-15544 ct_y=-6937 ct_z=8164
--   t_y: mean 1.77e-5, largest seen 7.49e-5 (1.2 ulp) at normal_x=-17534 normal_y=-897 normal_z=-9433 ct_x=8013 ct_y=-16499 ct_z=5940
--   t_z: mean 1.78e-5, largest seen 7.66e-5 (1.3 ulp) at normal_x=12976 normal_y=12042 normal_z=-8607 ct_x=3888 ct_y=-10225 ct_z=8359
--   bn_angle: mean 2.32e-5 rad, largest seen 5.60e-5 rad at normal_x=-10642 normal_y=-5666 normal_z=-5953 ct_x=1726 ct_y=-1464 ct_z=13894
--   bn_dot: mean 2.95e-5, largest seen 5.63e-5 at normal_x=-3329 normal_y=13424 normal_z=8156 ct_x=-4182 ct_y=-3328 ct_z=18276
--   bn_x: mean 1.53e-5, largest seen 3.77e-5 (0.6 ulp) at normal_x=-15816 normal_y=-754 normal_z=-9817 ct_x=-2394 ct_y=16948 ct_z=5363
--   bn_y: mean 1.53e-5, largest seen 3.75e-5 (0.6 ulp) at normal_x=16418 normal_y=-5802 normal_z=-2767 ct_x=-7596 ct_y=-14180 ct_z=-5075
--   bn_z: mean 1.54e-5, largest seen 3.67e-5 (0.6 ulp) at normal_x=4888 normal_y=-14943 normal_z=10350 ct_x=-4569 ct_y=10830 ct_z=11114
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152
-- stated bound on each binormal: 8.03e-5
-- stated bound on each tangent: 3.31e-4
-- stated bound on each flag: 0.00e0
-- renamed, since a language or another word has the name:
--   bn_x is bn_x_2
--   bn_y is bn_y_2
--   bn_z is bn_z_2
--
-- Self-checking testbench of basis. It reads basis_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 247 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity basis_tb is
end entity;

architecture test of basis_tb is
    constant latency : natural := 17;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_normal_x : signed(15 downto 0) := (others => '0');
    signal dut_normal_y : signed(15 downto 0) := (others => '0');
    signal dut_normal_z : signed(15 downto 0) := (others => '0');
    signal dut_ct_x : signed(15 downto 0) := (others => '0');
    signal dut_ct_y : signed(15 downto 0) := (others => '0');
    signal dut_ct_z : signed(15 downto 0) := (others => '0');
    signal dut_t_x : signed(16 downto 0);
    signal dut_t_y : signed(16 downto 0);
    signal dut_t_z : signed(16 downto 0);
    signal dut_bn_x : signed(15 downto 0);
    signal dut_bn_y : signed(15 downto 0);
    signal dut_bn_z : signed(15 downto 0);
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
    dut : entity work.basis
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            normal_x => dut_normal_x,
            normal_y => dut_normal_y,
            normal_z => dut_normal_z,
            ct_x => dut_ct_x,
            ct_y => dut_ct_y,
            ct_z => dut_ct_z,
            t_x => dut_t_x,
            t_y => dut_t_y,
            t_z => dut_t_z,
            bn_x => dut_bn_x,
            bn_y => dut_bn_y,
            bn_z => dut_bn_z,
            degenerate => dut_degenerate
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(99 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 247;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_normal_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_normal_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_normal_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ct_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ct_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ct_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_t_x : std_logic_vector(16 downto 0) := (others => '0');
        variable next_t_y : std_logic_vector(16 downto 0) := (others => '0');
        variable next_t_z : std_logic_vector(16 downto 0) := (others => '0');
        variable next_bn_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_bn_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_bn_z : std_logic_vector(15 downto 0) := (others => '0');
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
            file_open(status, vectors, "basis_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: basis_vectors.txt can't be read");
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
                hread(words, next_normal_x, good);
                more := more and good;
                hread(words, next_normal_y, good);
                more := more and good;
                hread(words, next_normal_z, good);
                more := more and good;
                hread(words, next_ct_x, good);
                more := more and good;
                hread(words, next_ct_y, good);
                more := more and good;
                hread(words, next_ct_z, good);
                more := more and good;
                hread(words, next_t_x, good);
                more := more and good;
                hread(words, next_t_y, good);
                more := more and good;
                hread(words, next_t_z, good);
                more := more and good;
                hread(words, next_bn_x, good);
                more := more and good;
                hread(words, next_bn_y, good);
                more := more and good;
                hread(words, next_bn_z, good);
                more := more and good;
                hread(words, next_degenerate, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: basis_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("t_x", expected(latency)(99 downto 83),
                    std_logic_vector(dut_t_x));
                check_port("t_y", expected(latency)(82 downto 66),
                    std_logic_vector(dut_t_y));
                check_port("t_z", expected(latency)(65 downto 49),
                    std_logic_vector(dut_t_z));
                check_port("bn_x", expected(latency)(48 downto 33),
                    std_logic_vector(dut_bn_x));
                check_port("bn_y", expected(latency)(32 downto 17),
                    std_logic_vector(dut_bn_y));
                check_port("bn_z", expected(latency)(16 downto 1),
                    std_logic_vector(dut_bn_z));
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
                        expected(0)(99 downto 83) := next_t_x;
                        expected(0)(82 downto 66) := next_t_y;
                        expected(0)(65 downto 49) := next_t_z;
                        expected(0)(48 downto 33) := next_bn_x;
                        expected(0)(32 downto 17) := next_bn_y;
                        expected(0)(16 downto 1) := next_bn_z;
                        expected(0)(0 downto 0) := next_degenerate;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 247 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- A gap carries the opposite of the latest word.
                if valid(0) = '1' then
                    dut_normal_x <= signed(next_normal_x);
                    dut_normal_y <= signed(next_normal_y);
                    dut_normal_z <= signed(next_normal_z);
                    dut_ct_x <= signed(next_ct_x);
                    dut_ct_y <= signed(next_ct_y);
                    dut_ct_z <= signed(next_ct_z);
                else
                    dut_normal_x <= signed(not next_normal_x);
                    dut_normal_y <= signed(not next_normal_y);
                    dut_normal_z <= signed(not next_normal_z);
                    dut_ct_x <= signed(not next_ct_x);
                    dut_ct_y <= signed(not next_ct_y);
                    dut_ct_z <= signed(not next_ct_z);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 247 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: basis_vectors.txt holds " & to_string(passed)
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
