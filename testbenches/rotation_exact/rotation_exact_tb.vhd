-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
-- Angular Operation, section 3.1 and Fig. 7
--   variant=exact output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
--   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
--   stages=auto rom=block
-- latency 3 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   angle: mean 1.41e-3 rad, largest seen 4.85e-3 rad at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   dot: mean 1.65e-3, largest seen 4.85e-3 at phi_a=471 theta_a=18178 phi_n=31386 theta_n=13058
--   x: mean 9.18e-4, largest seen 4.10e-3 (268.8 ulp) at phi_a=29150 theta_a=16832 phi_n=13217 theta_n=8896
--   y: mean 7.11e-4, largest seen 2.97e-3 (194.4 ulp) at phi_a=63595 theta_a=15808 phi_n=31274 theta_n=12249
--   z: mean 8.46e-4, largest seen 3.82e-3 (250.3 ulp) at phi_a=1717 theta_a=16513 phi_n=13490 theta_n=25983
-- stated bound on each component: 6.05e-3
--
-- Self-checking testbench of rotation_exact.
-- Each line of rotation_exact_vectors.txt holds the input words and then the
-- expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
-- per cycle. The second pass sends the first 358 again with stalls and gaps,
-- with a reset in mid-stream. Every bit of every output and the latency are compared.
-- The last line says PASS or FAIL; a failure ends with a nonzero status, for which GHDL prints one
-- more line. With --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity rotation_exact_tb is
end entity;

architecture test of rotation_exact_tb is
    constant latency : natural := 3;
    constant shown : natural := 10; -- of the mismatches

    -- The prefix dut_ keeps the ports' names apart from the names used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_phi_a : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_a : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_n : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_n : unsigned(15 downto 0) := (others => '0');
    signal dut_x : signed(17 downto 0);
    signal dut_y : signed(17 downto 0);
    signal dut_z : signed(17 downto 0);
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
    dut : entity work.rotation_exact
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            phi_a => dut_phi_a,
            theta_a => dut_theta_a,
            phi_n => dut_phi_n,
            theta_n => dut_theta_n,
            x => dut_x,
            y => dut_y,
            z => dut_z
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(53 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 358;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_phi_a : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_a : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_n : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_n : std_logic_vector(15 downto 0) := (others => '0');
        variable next_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_z : std_logic_vector(17 downto 0) := (others => '0');

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
            file_open(status, vectors, "rotation_exact_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: rotation_exact_vectors.txt can't be read");
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
                hread(words, next_phi_a, good);
                more := more and good;
                hread(words, next_theta_a, good);
                more := more and good;
                hread(words, next_phi_n, good);
                more := more and good;
                hread(words, next_theta_n, good);
                more := more and good;
                hread(words, next_x, good);
                more := more and good;
                hread(words, next_y, good);
                more := more and good;
                hread(words, next_z, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: rotation_exact_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("x", expected(latency)(53 downto 36),
                    std_logic_vector(dut_x));
                check_port("y", expected(latency)(35 downto 18),
                    std_logic_vector(dut_y));
                check_port("z", expected(latency)(17 downto 0),
                    std_logic_vector(dut_z));
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
                        expected(0)(53 downto 36) := next_x;
                        expected(0)(35 downto 18) := next_y;
                        expected(0)(17 downto 0) := next_z;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 358 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- In a gap the inputs are the complement of the latest words.
                if valid(0) = '1' then
                    dut_phi_a <= unsigned(next_phi_a);
                    dut_theta_a <= unsigned(next_theta_a);
                    dut_phi_n <= unsigned(next_phi_n);
                    dut_theta_n <= unsigned(next_theta_n);
                else
                    dut_phi_a <= unsigned(not next_phi_a);
                    dut_theta_a <= unsigned(not next_theta_a);
                    dut_phi_n <= unsigned(not next_phi_n);
                    dut_theta_n <= unsigned(not next_theta_n);
                end if;
            end if;
            -- A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if stalls and not reset_done and sent = 358 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: rotation_exact_vectors.txt holds " & to_string(passed)
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
