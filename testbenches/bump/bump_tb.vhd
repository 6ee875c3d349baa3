-- bump: light of a bump-mapped pixel from light, halfway vector, normal and bump vector
-- made by fixpath 0.1.0; seed 001 (Lee et al.), Fig. 8; the turn psi and the exact pipelines are this project's
--   pipeline=exact-polar conversion=table angle_bits=16 table_addr_bits=10 scheme=direct
--   quarter_wave=off frac_bits=16 guard_bits=2 rounding=half-up sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   cos_addr_bits=auto recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto
--   highlight=on diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16
--   ambient=0.1 diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
-- latency 24 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 4.50e-4, largest seen 8.09e-3 (529.9 ulp) at phi_l=54099 theta_l=21061 phi_h=60333 theta_h=25870 phi_n=4085 theta_n=24243 psi=15789 phi_p=37530 theta_p=7850
--   diffuse: mean 3.83e-4, largest seen 4.02e-3 (263.2 ulp) at phi_l=44654 theta_l=8576 phi_h=60159 theta_h=5510 phi_n=58665 theta_n=10045 psi=11801 phi_p=60790 theta_p=4186
--   specular: mean 1.09e-4, largest seen 7.98e-3 (522.8 ulp) at phi_l=40708 theta_l=14134 phi_h=34659 theta_h=13276 phi_n=35527 theta_n=15280 psi=31916 phi_p=11259 theta_p=2671
--   dot_l: mean 1.24e-3, largest seen 6.37e-3 (417.4 ulp) at phi_l=61704 theta_l=22170 phi_h=4275 theta_h=14080 phi_n=20110 theta_n=22175 psi=22018 phi_p=55143 theta_p=8416
--   dot_h: mean 1.25e-3, largest seen 6.38e-3 (417.8 ulp) at phi_l=40990 theta_l=19166 phi_h=52190 theta_h=15291 phi_n=57641 theta_n=20094 psi=62778 phi_p=9870 theta_p=8515
--   lt_angle: mean 1.43e-3 rad, largest seen 4.45e-3 rad at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
--   lt_dot: mean 1.43e-3, largest seen 4.45e-3 at phi_l=43319 theta_l=16515 phi_h=51482 theta_h=13337 phi_n=3571 theta_n=9794 psi=27030 phi_p=28221 theta_p=6758
--   lt_x: mean 7.74e-4, largest seen 4.05e-3 at phi_l=6884 theta_l=16156 phi_h=11810 theta_h=14024 phi_n=5223 theta_n=13921 psi=46897 phi_p=28640 theta_p=7461
--   lt_y: mean 6.21e-4, largest seen 3.10e-3 at phi_l=40221 theta_l=13057 phi_h=11896 theta_h=1741 phi_n=6618 theta_n=8346 psi=32754 phi_p=13032 theta_p=5385
--   lt_z: mean 7.41e-4, largest seen 4.08e-3 at phi_l=55938 theta_l=23167 phi_h=56369 theta_h=21833 phi_n=7227 theta_n=16515 psi=2242 phi_p=14438 theta_p=4655
--   ht_angle: mean 1.43e-3 rad, largest seen 5.28e-3 rad at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
--   ht_dot: mean 1.43e-3, largest seen 5.28e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
--   ht_x: mean 7.83e-4, largest seen 4.09e-3 at phi_l=31111 theta_l=19790 phi_h=29735 theta_h=16324 phi_n=29676 theta_n=17022 psi=22911 phi_p=3532 theta_p=8126
--   ht_y: mean 6.21e-4, largest seen 3.21e-3 at phi_l=15384 theta_l=20283 phi_h=16010 theta_h=30916 phi_n=33483 theta_n=20732 psi=60970 phi_p=20741 theta_p=7238
--   ht_z: mean 7.39e-4, largest seen 4.45e-3 at phi_l=53874 theta_l=21815 phi_h=50989 theta_h=16126 phi_n=18283 theta_n=2943 psi=27084 phi_p=38880 theta_p=9075
-- stated bound on each dot: 2.73e-2
-- stated bound on each diffuse: 1.67e-2
-- stated bound on each specular: 1.81e-1
-- stated bound on each intensity: 1.97e-1
-- stated bound on the angle: 1.82e-2 rad
--
-- Self-checking testbench of bump. It reads bump_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 260 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity bump_tb is
end entity;

architecture test of bump_tb is
    constant latency : natural := 24;
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
    dut : entity work.bump
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
        constant count : natural := 260;
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
            file_open(status, vectors, "bump_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: bump_vectors.txt can't be read");
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
                    print("mismatch: bump_vectors.txt is cut short after vector " & to_string(sent));
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
                        if stalls and sent = 260 then
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
            if stalls and not reset_done and sent = 260 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: bump_vectors.txt holds " & to_string(passed)
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
