-- peercy: light and halfway vector in the texture frame, by matrix, with the bump vector normalised
-- made by fixpath 0.1.0; Peercy et al. 1997, as seed 001 (Lee et al.) counts it in Table 1 and section 4.3
--   normalise=divide divider=non-restoring root=digits frac_bits=16 guard_bits=2 rounding=half-up
--   table_addr_bits=10 scheme=direct recip_addr_bits=auto root_addr_bits=auto period_ps=5000
--   stages=auto rom=block
-- latency 27 cycles, interval 1 cycle; no tables
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   lt_angle: mean 5.96e-6 rad, largest seen 1.52e-5 rad at l_x=-46104 l_y=2218 l_z=46524 h_x=-34894 h_y=-9840 h_z=54594 n_x=-8835 n_y=57118 n_z=30893 t_x=27988 t_y=31483 t_z=-50204 b_x=-58597 b_y=6425 b_z=-28637 p_x=-41292 p_y=29455 p_z=41501
--   lt_dot: mean 7.58e-6, largest seen 1.60e-5 at l_x=-51507 l_y=24581 l_z=-32215 h_x=-48499 h_y=-39070 h_z=-20406 n_x=-49786 n_y=-42007 n_z=7192 t_x=-40759 t_y=43701 t_z=-26905 b_x=12449 b_y=-24912 b_z=-59324 p_x=18646 p_y=26903 p_z=56776
--   lt_x: mean 3.93e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-15279 l_y=5067 l_z=63528 h_x=29170 h_y=-18014 h_z=55853 n_x=53184 n_y=30871 n_z=22658 t_x=9050 t_y=-47812 t_z=43899 b_x=37209 b_y=-32496 b_z=-43064 p_x=30395 p_y=-14945 p_z=56105
--   lt_y: mean 3.92e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=-33544 l_y=8570 l_z=55645 h_x=3237 h_y=45027 h_z=47509 n_x=51579 n_y=35193 n_z=-19899 t_x=-23525 t_y=-107 t_z=-61168 b_x=-32880 b_y=55285 b_z=12549 p_x=35175 p_y=37290 p_z=40831
--   lt_z: mean 3.90e-6, largest seen 1.06e-5 (0.7 ulp) at l_x=60216 l_y=-731 l_z=25854 h_x=28155 h_y=-38009 h_z=45360 n_x=49800 n_y=-42419 n_z=3954 t_x=-7689 t_y=-2967 t_z=65016 b_x=-41903 b_y=-49868 b_z=-7231 p_x=38689 p_y=13334 p_z=51189
--   ht_angle: mean 5.97e-6 rad, largest seen 1.55e-5 rad at l_x=-42413 l_y=5315 l_z=-49678 h_x=-49190 h_y=10077 h_z=-42117 n_x=31825 n_y=43565 n_z=-37205 t_x=52333 t_y=-39424 t_z=-1398 b_x=-23310 b_y=-29031 b_z=-53933 p_x=41501 p_y=24164 p_z=44595
--   ht_dot: mean 7.59e-6, largest seen 1.61e-5 at l_x=39313 l_y=33020 l_z=40732 h_x=45349 h_y=44689 h_z=15535 n_x=-37342 n_y=44334 n_z=30579 t_x=53162 t_y=24386 t_z=29565 b_x=8622 b_y=41651 b_z=-49858 p_x=-25251 p_y=-37777 p_z=47226
--   ht_x: mean 3.92e-6, largest seen 1.07e-5 (0.7 ulp) at l_x=39149 l_y=-824 l_z=-52551 h_x=24132 h_y=-60683 h_z=-5494 n_x=-27035 n_y=-45260 n_z=-38931 t_x=-59525 t_y=17166 t_z=21378 b_x=-4566 b_y=44180 b_z=-48190 p_x=-12132 p_y=43147 p_z=47813
--   ht_y: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=32246 l_y=-33688 l_z=-46046 h_x=26934 h_y=-37639 h_z=-46399 n_x=15761 n_y=17121 n_z=-61265 t_x=59086 t_y=-27325 t_z=7564 b_x=-23568 b_y=-57054 b_z=-22007 p_x=-27119 p_y=36491 p_z=47201
--   ht_z: mean 3.92e-6, largest seen 1.08e-5 (0.7 ulp) at l_x=-37898 l_y=-11533 l_z=52209 h_x=-54011 h_y=-33479 h_z=-16030 n_x=-19265 n_y=-61659 n_z=-11046 t_x=-4008 t_y=12746 t_z=-64159 b_x=62512 b_y=-18185 b_z=-7518 p_x=10839 p_y=-28061 p_z=58224
--   np_angle: mean 1.05e-7 rad, largest seen 1.14e-5 rad at l_x=-40259 l_y=38473 l_z=-34554 h_x=-62469 h_y=18472 h_z=7165 n_x=-17576 n_y=-62519 n_z=-8800 t_x=63081 t_y=-17011 t_z=-5134 b_x=2613 b_y=-9848 b_z=64739 p_x=30234 p_y=-38348 p_z=43708
--   np_dot: mean 3.63e-6, largest seen 1.26e-5 at l_x=43816 l_y=-17055 l_z=45654 h_x=58637 h_y=21533 h_z=19825 n_x=-24996 n_y=19982 n_z=-57192 t_x=-60291 t_y=-2150 t_z=25600 b_x=5929 b_y=62378 b_z=19203 p_x=44305 p_y=17978 p_z=44819
--   np_x: mean 1.37e-6, largest seen 8.79e-6 (0.6 ulp) at l_x=53829 l_y=-34799 l_z=-13657 h_x=33881 h_y=-19546 h_z=-52583 n_x=-62351 n_y=15867 n_z=-12474 t_x=17659 t_y=62500 t_z=-8765 b_x=9774 b_y=-11700 b_z=-63738 p_x=-43754 p_y=-14907 p_z=46457
--   np_y: mean 1.36e-6, largest seen 8.80e-6 (0.6 ulp) at l_x=1647 l_y=28987 l_z=-58754 h_x=19397 h_y=-15505 h_z=-60649 n_x=8309 n_y=10136 n_z=-64212 t_x=58689 t_y=26669 t_z=11804 b_x=27956 b_y=-59000 b_z=-5696 p_x=-9330 p_y=43692 p_z=47948
--   np_z: mean 2.89e-6, largest seen 9.12e-6 (0.6 ulp) at l_x=-20101 l_y=-58433 l_z=21828 h_x=17471 h_y=-54069 h_z=-32654 n_x=35033 n_y=-55386 n_z=-98 t_x=46038 t_y=29056 t_z=36486 b_x=-30792 b_y=-19573 b_z=54440 p_x=13763 p_y=-11159 p_z=63096
-- stated bound on each component: 1.81e-5
-- bounds hold for L and H in the texture frame, and N', from 1/2 to 2 long
--
-- Self-checking testbench of peercy. It reads peercy_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 270 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity peercy_tb is
end entity;

architecture test of peercy_tb is
    constant latency : natural := 27;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_l_x : signed(17 downto 0) := (others => '0');
    signal dut_l_y : signed(17 downto 0) := (others => '0');
    signal dut_l_z : signed(17 downto 0) := (others => '0');
    signal dut_h_x : signed(17 downto 0) := (others => '0');
    signal dut_h_y : signed(17 downto 0) := (others => '0');
    signal dut_h_z : signed(17 downto 0) := (others => '0');
    signal dut_n_x : signed(17 downto 0) := (others => '0');
    signal dut_n_y : signed(17 downto 0) := (others => '0');
    signal dut_n_z : signed(17 downto 0) := (others => '0');
    signal dut_t_x : signed(17 downto 0) := (others => '0');
    signal dut_t_y : signed(17 downto 0) := (others => '0');
    signal dut_t_z : signed(17 downto 0) := (others => '0');
    signal dut_b_x : signed(17 downto 0) := (others => '0');
    signal dut_b_y : signed(17 downto 0) := (others => '0');
    signal dut_b_z : signed(17 downto 0) := (others => '0');
    signal dut_p_x : signed(17 downto 0) := (others => '0');
    signal dut_p_y : signed(17 downto 0) := (others => '0');
    signal dut_p_z : signed(17 downto 0) := (others => '0');
    signal dut_lt_x : signed(17 downto 0);
    signal dut_lt_y : signed(17 downto 0);
    signal dut_lt_z : signed(17 downto 0);
    signal dut_ht_x : signed(17 downto 0);
    signal dut_ht_y : signed(17 downto 0);
    signal dut_ht_z : signed(17 downto 0);
    signal dut_np_x : signed(17 downto 0);
    signal dut_np_y : signed(17 downto 0);
    signal dut_np_z : signed(17 downto 0);
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
    dut : entity work.peercy
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            l_x => dut_l_x,
            l_y => dut_l_y,
            l_z => dut_l_z,
            h_x => dut_h_x,
            h_y => dut_h_y,
            h_z => dut_h_z,
            n_x => dut_n_x,
            n_y => dut_n_y,
            n_z => dut_n_z,
            t_x => dut_t_x,
            t_y => dut_t_y,
            t_z => dut_t_z,
            b_x => dut_b_x,
            b_y => dut_b_y,
            b_z => dut_b_z,
            p_x => dut_p_x,
            p_y => dut_p_y,
            p_z => dut_p_z,
            lt_x => dut_lt_x,
            lt_y => dut_lt_y,
            lt_z => dut_lt_z,
            ht_x => dut_ht_x,
            ht_y => dut_ht_y,
            ht_z => dut_ht_z,
            np_x => dut_np_x,
            np_y => dut_np_y,
            np_z => dut_np_z
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(161 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 270;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_l_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_l_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_l_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_h_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_h_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_h_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_p_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_p_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_p_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_lt_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_lt_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_lt_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_ht_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_ht_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_ht_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_np_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_np_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_np_z : std_logic_vector(17 downto 0) := (others => '0');

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
            file_open(status, vectors, "peercy_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: peercy_vectors.txt can't be read");
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
                hread(words, next_l_x, good);
                more := more and good;
                hread(words, next_l_y, good);
                more := more and good;
                hread(words, next_l_z, good);
                more := more and good;
                hread(words, next_h_x, good);
                more := more and good;
                hread(words, next_h_y, good);
                more := more and good;
                hread(words, next_h_z, good);
                more := more and good;
                hread(words, next_n_x, good);
                more := more and good;
                hread(words, next_n_y, good);
                more := more and good;
                hread(words, next_n_z, good);
                more := more and good;
                hread(words, next_t_x, good);
                more := more and good;
                hread(words, next_t_y, good);
                more := more and good;
                hread(words, next_t_z, good);
                more := more and good;
                hread(words, next_b_x, good);
                more := more and good;
                hread(words, next_b_y, good);
                more := more and good;
                hread(words, next_b_z, good);
                more := more and good;
                hread(words, next_p_x, good);
                more := more and good;
                hread(words, next_p_y, good);
                more := more and good;
                hread(words, next_p_z, good);
                more := more and good;
                hread(words, next_lt_x, good);
                more := more and good;
                hread(words, next_lt_y, good);
                more := more and good;
                hread(words, next_lt_z, good);
                more := more and good;
                hread(words, next_ht_x, good);
                more := more and good;
                hread(words, next_ht_y, good);
                more := more and good;
                hread(words, next_ht_z, good);
                more := more and good;
                hread(words, next_np_x, good);
                more := more and good;
                hread(words, next_np_y, good);
                more := more and good;
                hread(words, next_np_z, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: peercy_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("lt_x", expected(latency)(161 downto 144),
                    std_logic_vector(dut_lt_x));
                check_port("lt_y", expected(latency)(143 downto 126),
                    std_logic_vector(dut_lt_y));
                check_port("lt_z", expected(latency)(125 downto 108),
                    std_logic_vector(dut_lt_z));
                check_port("ht_x", expected(latency)(107 downto 90),
                    std_logic_vector(dut_ht_x));
                check_port("ht_y", expected(latency)(89 downto 72),
                    std_logic_vector(dut_ht_y));
                check_port("ht_z", expected(latency)(71 downto 54),
                    std_logic_vector(dut_ht_z));
                check_port("np_x", expected(latency)(53 downto 36),
                    std_logic_vector(dut_np_x));
                check_port("np_y", expected(latency)(35 downto 18),
                    std_logic_vector(dut_np_y));
                check_port("np_z", expected(latency)(17 downto 0),
                    std_logic_vector(dut_np_z));
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
                        expected(0)(161 downto 144) := next_lt_x;
                        expected(0)(143 downto 126) := next_lt_y;
                        expected(0)(125 downto 108) := next_lt_z;
                        expected(0)(107 downto 90) := next_ht_x;
                        expected(0)(89 downto 72) := next_ht_y;
                        expected(0)(71 downto 54) := next_ht_z;
                        expected(0)(53 downto 36) := next_np_x;
                        expected(0)(35 downto 18) := next_np_y;
                        expected(0)(17 downto 0) := next_np_z;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 270 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- A gap carries the opposite of the latest word.
                if valid(0) = '1' then
                    dut_l_x <= signed(next_l_x);
                    dut_l_y <= signed(next_l_y);
                    dut_l_z <= signed(next_l_z);
                    dut_h_x <= signed(next_h_x);
                    dut_h_y <= signed(next_h_y);
                    dut_h_z <= signed(next_h_z);
                    dut_n_x <= signed(next_n_x);
                    dut_n_y <= signed(next_n_y);
                    dut_n_z <= signed(next_n_z);
                    dut_t_x <= signed(next_t_x);
                    dut_t_y <= signed(next_t_y);
                    dut_t_z <= signed(next_t_z);
                    dut_b_x <= signed(next_b_x);
                    dut_b_y <= signed(next_b_y);
                    dut_b_z <= signed(next_b_z);
                    dut_p_x <= signed(next_p_x);
                    dut_p_y <= signed(next_p_y);
                    dut_p_z <= signed(next_p_z);
                else
                    dut_l_x <= signed(not next_l_x);
                    dut_l_y <= signed(not next_l_y);
                    dut_l_z <= signed(not next_l_z);
                    dut_h_x <= signed(not next_h_x);
                    dut_h_y <= signed(not next_h_y);
                    dut_h_z <= signed(not next_h_z);
                    dut_n_x <= signed(not next_n_x);
                    dut_n_y <= signed(not next_n_y);
                    dut_n_z <= signed(not next_n_z);
                    dut_t_x <= signed(not next_t_x);
                    dut_t_y <= signed(not next_t_y);
                    dut_t_z <= signed(not next_t_z);
                    dut_b_x <= signed(not next_b_x);
                    dut_b_y <= signed(not next_b_y);
                    dut_b_z <= signed(not next_b_z);
                    dut_p_x <= signed(not next_p_x);
                    dut_p_y <= signed(not next_p_y);
                    dut_p_z <= signed(not next_p_z);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 270 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: peercy_vectors.txt holds " & to_string(passed)
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
