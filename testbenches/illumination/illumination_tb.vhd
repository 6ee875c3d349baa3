-- illumination: light of a pixel from light, halfway and perturbed normal vector in the texture frame
-- made by fixpath 0.1.0; seed 001 (Lee et al.), sections 3.2 and 4.2, Fig. 8; variant kim: its eqs (3) and (4)
--   variant=corrected angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off frac_bits=16
--   guard_bits=2 rounding=half-up sincos_addr_bits=auto cos_addr_bits=auto highlight=on
--   diffuse_addr_bits=10 specular_addr_bits=10 light_scheme=direct light_bits=16 ambient=0.1
--   diffuse=0.6 specular=0.3 exponent=32 period_ps=5000 stages=auto rom=block
-- latency 6 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   intensity: mean 3.82e-4, largest seen 6.81e-3 (446.6 ulp) at phi_lt=37053 theta_lt=4180 phi_ht=35367 theta_ht=8197 phi_p=34886 theta_p=6598
--   diffuse: mean 3.22e-4, largest seen 2.59e-3 (169.6 ulp) at phi_lt=54705 theta_lt=16284 phi_ht=62205 theta_ht=13786 phi_p=39476 theta_p=7521
--   specular: mean 9.58e-5, largest seen 6.87e-3 (450.0 ulp) at phi_lt=9407 theta_lt=14751 phi_ht=20560 theta_ht=8847 phi_p=19346 theta_p=7827
--   dot_l: mean 1.03e-3, largest seen 4.01e-3 (262.7 ulp) at phi_lt=9033 theta_lt=16932 phi_ht=2260 theta_ht=13923 phi_p=24522 theta_p=8033
--   dot_h: mean 1.03e-3, largest seen 3.98e-3 (260.8 ulp) at phi_lt=8635 theta_lt=24817 phi_ht=7806 theta_ht=14338 phi_p=58302 theta_p=9088
-- stated bound on each dot: 9.08e-3
-- stated bound on each diffuse: 5.76e-3
-- stated bound on each specular: 8.05e-2
-- stated bound on each intensity: 8.63e-2
--
-- Self-checking testbench of illumination. It reads illumination_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 250 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity illumination_tb is
end entity;

architecture test of illumination_tb is
    constant latency : natural := 6;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_phi_lt : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_lt : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_ht : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_ht : unsigned(15 downto 0) := (others => '0');
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
    dut : entity work.illumination
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            phi_lt => dut_phi_lt,
            theta_lt => dut_theta_lt,
            phi_ht => dut_phi_ht,
            theta_ht => dut_theta_ht,
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
        constant count : natural := 250;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_phi_lt : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_lt : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_ht : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_ht : std_logic_vector(15 downto 0) := (others => '0');
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
            file_open(status, vectors, "illumination_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: illumination_vectors.txt can't be read");
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
                hread(words, next_phi_lt, good);
                more := more and good;
                hread(words, next_theta_lt, good);
                more := more and good;
                hread(words, next_phi_ht, good);
                more := more and good;
                hread(words, next_theta_ht, good);
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
                    print("mismatch: illumination_vectors.txt is cut short after vector " & to_string(sent));
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
                        if stalls and sent = 250 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- A gap carries the opposite of the latest word.
                if valid(0) = '1' then
                    dut_phi_lt <= unsigned(next_phi_lt);
                    dut_theta_lt <= unsigned(next_theta_lt);
                    dut_phi_ht <= unsigned(next_phi_ht);
                    dut_theta_ht <= unsigned(next_theta_ht);
                    dut_phi_p <= unsigned(next_phi_p);
                    dut_theta_p <= unsigned(next_theta_p);
                else
                    dut_phi_lt <= unsigned(not next_phi_lt);
                    dut_theta_lt <= unsigned(not next_theta_lt);
                    dut_phi_ht <= unsigned(not next_phi_ht);
                    dut_theta_ht <= unsigned(not next_theta_ht);
                    dut_phi_p <= unsigned(not next_phi_p);
                    dut_theta_p <= unsigned(not next_theta_p);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 250 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: illumination_vectors.txt holds " & to_string(passed)
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
