-- kim: light of a bump-mapped pixel by a matrix of sines and cosines and polar dot products
-- made by fixpath 0.1.0; Kim et al. 2001: eqs (3), (4) of seed 001 (Lee et al.); the set-up is a reconstruction
--   conversion=table angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
--   guard_bits=2 rounding=half-up sincos_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto
--   cordic_iterations=auto highlight=on diffuse_addr_bits=10 specular_addr_bits=10
--   light_scheme=direct light_bits=16 ambient=0.1 diffuse=0.6 specular=0.3 exponent=32
--   period_ps=5000 stages=auto rom=block
-- latency 30 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 6.91e-4, largest seen 1.28e-2 (836.5 ulp) at phi_l=12249 theta_l=10042 phi_h=25129 theta_h=12990 phi_n=27856 theta_n=18250 psi=18706 phi_p=19124 theta_p=3769
--   diffuse: mean 5.92e-4, largest seen 7.09e-3 (464.8 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
--   specular: mean 1.54e-4, largest seen 1.15e-2 (756.4 ulp) at phi_l=46792 theta_l=23943 phi_h=48621 theta_h=15295 phi_n=56540 theta_n=7516 psi=771 phi_p=53306 theta_p=8323
--   dot_l: mean 1.94e-3, largest seen 1.17e-2 (766.0 ulp) at phi_l=5887 theta_l=21190 phi_h=20694 theta_h=21693 phi_n=7057 theta_n=377 psi=41054 phi_p=32253 theta_p=7036
--   dot_h: mean 1.93e-3, largest seen 1.09e-2 (713.0 ulp) at phi_l=60553 theta_l=18372 phi_h=64636 theta_h=22235 phi_n=8005 theta_n=19253 psi=1559 phi_p=20130 theta_p=8069
--   lt_angle: mean 2.77e-3 rad, largest seen 7.77e-3 rad at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
--   lt_dot: mean 2.77e-3, largest seen 7.77e-3 at phi_l=6915 theta_l=10368 phi_h=4641 theta_h=3798 phi_n=44602 theta_n=12480 psi=59670 phi_p=22351 theta_p=3078
--   lt_x: mean 1.43e-3, largest seen 7.31e-3 at phi_l=3004 theta_l=11455 phi_h=6745 theta_h=15411 phi_n=16385 theta_n=5769 psi=61008 phi_p=44796 theta_p=5705
--   lt_y: mean 1.26e-3, largest seen 6.21e-3 at phi_l=58622 theta_l=14345 phi_h=63015 theta_h=26871 phi_n=27904 theta_n=24597 psi=39862 phi_p=34182 theta_p=8142
--   lt_z: mean 1.47e-3, largest seen 6.89e-3 at phi_l=46077 theta_l=10290 phi_h=47299 theta_h=13859 phi_n=55937 theta_n=20227 psi=54458 phi_p=65410 theta_p=4451
--   ht_angle: mean 2.77e-3 rad, largest seen 7.83e-3 rad at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
--   ht_dot: mean 2.77e-3, largest seen 7.83e-3 at phi_l=27736 theta_l=15792 phi_h=15742 theta_h=17078 phi_n=13120 theta_n=9730 psi=31698 phi_p=62952 theta_p=6764
--   ht_x: mean 1.43e-3, largest seen 6.94e-3 at phi_l=60765 theta_l=22077 phi_h=12545 theta_h=23229 phi_n=26302 theta_n=28297 psi=58283 phi_p=51185 theta_p=7747
--   ht_y: mean 1.26e-3, largest seen 5.92e-3 at phi_l=17506 theta_l=13432 phi_h=12930 theta_h=16780 phi_n=13695 theta_n=13345 psi=2824 phi_p=40130 theta_p=3617
--   ht_z: mean 1.46e-3, largest seen 6.74e-3 at phi_l=15954 theta_l=3967 phi_h=34558 theta_h=10628 phi_n=23439 theta_n=21371 psi=29040 phi_p=61493 theta_p=6921
-- stated bound on each dot: 8.61e-2
-- stated bound on each diffuse: 5.20e-2
-- stated bound on each specular: 2.88e-1
-- stated bound on each intensity: 3.40e-1
-- stated bound on the angle: 7.10e-2 rad
--
-- Self-checking testbench of kim. It reads kim_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 270 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity kim_tb is
end entity;

architecture test of kim_tb is
    constant latency : natural := 30;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_phi_l : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_l : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_h : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_h : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_n : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_n : unsigned(15 downto 0) := (others => '0');
    signal dut_psi : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_p : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_p : unsigned(15 downto 0) := (others => '0');
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
    dut : entity work.kim
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            phi_l => dut_phi_l,
            theta_l => dut_theta_l,
            phi_h => dut_phi_h,
            theta_h => dut_theta_h,
            phi_n => dut_phi_n,
            theta_n => dut_theta_n,
            psi => dut_psi,
            phi_p => dut_phi_p,
            theta_p => dut_theta_p,
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
        variable next_phi_l : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_l : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_h : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_h : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_n : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_n : std_logic_vector(15 downto 0) := (others => '0');
        variable next_psi : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_p : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_p : std_logic_vector(15 downto 0) := (others => '0');
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
            file_open(status, vectors, "kim_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: kim_vectors.txt can't be read");
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
                hread(words, next_phi_l, good);
                more := more and good;
                hread(words, next_theta_l, good);
                more := more and good;
                hread(words, next_phi_h, good);
                more := more and good;
                hread(words, next_theta_h, good);
                more := more and good;
                hread(words, next_phi_n, good);
                more := more and good;
                hread(words, next_theta_n, good);
                more := more and good;
                hread(words, next_psi, good);
                more := more and good;
                hread(words, next_phi_p, good);
                more := more and good;
                hread(words, next_theta_p, good);
                more := more and good;
                hread(words, next_intensity, good);
                more := more and good;
                hread(words, next_diffuse, good);
                more := more and good;
                hread(words, next_specular, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: kim_vectors.txt is cut short after vector " & to_string(sent));
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
                    dut_phi_l <= unsigned(next_phi_l);
                    dut_theta_l <= unsigned(next_theta_l);
                    dut_phi_h <= unsigned(next_phi_h);
                    dut_theta_h <= unsigned(next_theta_h);
                    dut_phi_n <= unsigned(next_phi_n);
                    dut_theta_n <= unsigned(next_theta_n);
                    dut_psi <= unsigned(next_psi);
                    dut_phi_p <= unsigned(next_phi_p);
                    dut_theta_p <= unsigned(next_theta_p);
                else
                    dut_phi_l <= unsigned(not next_phi_l);
                    dut_theta_l <= unsigned(not next_theta_l);
                    dut_phi_h <= unsigned(not next_phi_h);
                    dut_theta_h <= unsigned(not next_theta_h);
                    dut_phi_n <= unsigned(not next_phi_n);
                    dut_theta_n <= unsigned(not next_theta_n);
                    dut_psi <= unsigned(not next_psi);
                    dut_phi_p <= unsigned(not next_phi_p);
                    dut_theta_p <= unsigned(not next_theta_p);
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
                print("mismatch: kim_vectors.txt holds " & to_string(passed)
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
