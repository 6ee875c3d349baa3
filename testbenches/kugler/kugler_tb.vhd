-- kugler: light of a bump-mapped pixel by rotations and light maps, without dot products
-- made by fixpath 0.1.0; Kugler 1998 (IMEM), as seed 001 (Lee et al.) describes it; largely a reconstruction
--   conversion=table tilt_addr_bits=14 map_angle_bits=8 map_addr_bits=12 angle_bits=16
--   table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up
--   recip_addr_bits=auto atan_addr_bits=auto cordic_iterations=auto highlight=on light_bits=16
--   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
-- latency 21 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 1.64e-2, largest seen 3.21e-1 (21034.8 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
--   diffuse: mean 1.43e-2, largest seen 1.61e-1 (10548.1 ulp) at n_x=64337 n_y=68 n_z=-12481 psi=46469 phi_p=59889 theta_p=8345 phi_l=60553 theta_l=24577 phi_h=60753 theta_h=28326
--   specular: mean 3.33e-3, largest seen 2.10e-1 (13738.9 ulp) at n_x=-56529 n_y=31196 n_z=11234 psi=16437 phi_p=60731 theta_p=6337 phi_l=24836 theta_l=12014 phi_h=33009 theta_h=16304
--   pw_angle: mean 6.11e-2 rad, largest seen 1.66e-1 rad at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
--   pw_dot: mean 6.11e-2, largest seen 1.66e-1 at n_x=-20635 n_y=-14506 n_z=-60487 psi=49532 phi_p=56925 theta_p=9312 phi_l=47085 theta_l=24477 phi_h=52484 theta_h=24320
--   pw_x: mean 2.72e-2, largest seen 1.50e-1 at n_x=-40953 n_y=22153 n_z=46120 psi=61767 phi_p=36536 theta_p=8148 phi_l=60944 theta_l=4014 phi_h=33548 theta_h=9549
--   pw_y: mean 2.71e-2, largest seen 1.47e-1 at n_x=13068 n_y=52261 n_z=-37322 psi=50906 phi_p=20746 theta_p=8211 phi_l=13848 theta_l=18740 phi_h=19374 theta_h=27605
--   pw_z: mean 3.70e-2, largest seen 1.56e-1 at n_x=58525 n_y=-14807 n_z=25506 psi=44588 phi_p=12702 theta_p=8159 phi_l=49639 theta_l=20508 phi_h=63118 theta_h=22796
--   pl_angle: mean 8.82e-2 rad, largest seen 2.91e-1 rad at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
--   pl_dot: mean 8.82e-2, largest seen 2.90e-1 at n_x=-62258 n_y=15402 n_z=13480 psi=25126 phi_p=44526 theta_p=6092 phi_l=34830 theta_l=12436 phi_h=33197 theta_h=20245
--   pl_x: mean 4.70e-2, largest seen 2.78e-1 at n_x=36200 n_y=-53003 n_z=-13238 psi=14755 phi_p=47780 theta_p=7407 phi_l=57722 theta_l=28642 phi_h=58499 theta_h=19711
--   pl_y: mean 3.86e-2, largest seen 1.99e-1 at n_x=1054 n_y=243 n_z=65527 psi=4485 phi_p=44708 theta_p=8256 phi_l=16693 theta_l=28786 phi_h=40236 theta_h=23869
--   pl_z: mean 4.65e-2, largest seen 2.53e-1 at n_x=-21222 n_y=60550 n_z=-13354 psi=8628 phi_p=51032 theta_p=3342 phi_l=50666 theta_l=26736 phi_h=12630 theta_h=28946
--   ph_angle: mean 8.83e-2 rad, largest seen 2.92e-1 rad at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
--   ph_dot: mean 8.83e-2, largest seen 2.91e-1 at n_x=23355 n_y=8851 n_z=60590 psi=55836 phi_p=32370 theta_p=6217 phi_l=26943 theta_l=19308 phi_h=31160 theta_h=12227
--   ph_x: mean 4.70e-2, largest seen 2.42e-1 at n_x=40289 n_y=36933 n_z=-36161 psi=5281 phi_p=51702 theta_p=5800 phi_l=12406 theta_l=11093 phi_h=11666 theta_h=24712
--   ph_y: mean 3.87e-2, largest seen 1.90e-1 at n_x=18685 n_y=41876 n_z=-46821 psi=56218 phi_p=58881 theta_p=9312 phi_l=60146 theta_l=20332 phi_h=65052 theta_h=17648
--   ph_z: mean 4.67e-2, largest seen 2.45e-1 at n_x=63088 n_y=-17640 n_z=1940 psi=34649 phi_p=1283 theta_p=7197 phi_l=57191 theta_l=29307 phi_h=60648 theta_h=22533
-- no bound is stated: near a pole, a cell of a map has azimuths of the whole turn in it: no cell size bounds the light
--
-- Self-checking testbench of kugler. It reads kugler_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 270 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity kugler_tb is
end entity;

architecture test of kugler_tb is
    constant latency : natural := 21;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_n_x : signed(17 downto 0) := (others => '0');
    signal dut_n_y : signed(17 downto 0) := (others => '0');
    signal dut_n_z : signed(17 downto 0) := (others => '0');
    signal dut_psi : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_p : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_p : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_l : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_l : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_h : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_h : unsigned(15 downto 0) := (others => '0');
    signal dut_intensity : unsigned(15 downto 0);
    signal dut_diffuse : unsigned(15 downto 0);
    signal dut_specular : unsigned(15 downto 0);
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
    dut : entity work.kugler
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            n_x => dut_n_x,
            n_y => dut_n_y,
            n_z => dut_n_z,
            psi => dut_psi,
            phi_p => dut_phi_p,
            theta_p => dut_theta_p,
            phi_l => dut_phi_l,
            theta_l => dut_theta_l,
            phi_h => dut_phi_h,
            theta_h => dut_theta_h,
            intensity => dut_intensity,
            diffuse => dut_diffuse,
            specular => dut_specular
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(47 downto 0);
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
        variable next_n_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_psi : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_p : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_p : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_l : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_l : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_h : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_h : std_logic_vector(15 downto 0) := (others => '0');
        variable next_intensity : std_logic_vector(15 downto 0) := (others => '0');
        variable next_diffuse : std_logic_vector(15 downto 0) := (others => '0');
        variable next_specular : std_logic_vector(15 downto 0) := (others => '0');

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
            file_open(status, vectors, "kugler_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: kugler_vectors.txt can't be read");
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
                hread(words, next_n_x, good);
                more := more and good;
                hread(words, next_n_y, good);
                more := more and good;
                hread(words, next_n_z, good);
                more := more and good;
                hread(words, next_psi, good);
                more := more and good;
                hread(words, next_phi_p, good);
                more := more and good;
                hread(words, next_theta_p, good);
                more := more and good;
                hread(words, next_phi_l, good);
                more := more and good;
                hread(words, next_theta_l, good);
                more := more and good;
                hread(words, next_phi_h, good);
                more := more and good;
                hread(words, next_theta_h, good);
                more := more and good;
                hread(words, next_intensity, good);
                more := more and good;
                hread(words, next_diffuse, good);
                more := more and good;
                hread(words, next_specular, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: kugler_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("intensity", expected(latency)(47 downto 32),
                    std_logic_vector(dut_intensity));
                check_port("diffuse", expected(latency)(31 downto 16),
                    std_logic_vector(dut_diffuse));
                check_port("specular", expected(latency)(15 downto 0),
                    std_logic_vector(dut_specular));
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
                        expected(0)(47 downto 32) := next_intensity;
                        expected(0)(31 downto 16) := next_diffuse;
                        expected(0)(15 downto 0) := next_specular;
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
                    dut_n_x <= signed(next_n_x);
                    dut_n_y <= signed(next_n_y);
                    dut_n_z <= signed(next_n_z);
                    dut_psi <= unsigned(next_psi);
                    dut_phi_p <= unsigned(next_phi_p);
                    dut_theta_p <= unsigned(next_theta_p);
                    dut_phi_l <= unsigned(next_phi_l);
                    dut_theta_l <= unsigned(next_theta_l);
                    dut_phi_h <= unsigned(next_phi_h);
                    dut_theta_h <= unsigned(next_theta_h);
                else
                    dut_n_x <= signed(not next_n_x);
                    dut_n_y <= signed(not next_n_y);
                    dut_n_z <= signed(not next_n_z);
                    dut_psi <= unsigned(not next_psi);
                    dut_phi_p <= unsigned(not next_phi_p);
                    dut_theta_p <= unsigned(not next_theta_p);
                    dut_phi_l <= unsigned(not next_phi_l);
                    dut_theta_l <= unsigned(not next_theta_l);
                    dut_phi_h <= unsigned(not next_phi_h);
                    dut_theta_h <= unsigned(not next_theta_h);
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
                print("mismatch: kugler_vectors.txt holds " & to_string(passed)
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
