-- rotation: turns a direction in polar form into the frame of a surface normal
-- made by fixpath 0.1.0; Lee et al., An Effective Hardware Architecture for Bump Mapping Using
-- Angular Operation, section 3.1 and Fig. 7
--   variant=corrected output=auto angle_bits=16 table_addr_bits=10 scheme=direct quarter_wave=off
--   frac_bits=16 int_bits=1 guard_bits=2 rounding=half-up overflow=saturate sincos_addr_bits=auto
--   asin_addr_bits=auto recip_addr_bits=auto atan_addr_bits=auto prop_addr_bits=auto
--   recip_int_bits=8 atan_int_bits=auto quadrants=full cordic_iterations=auto period_ps=5000
--   stages=auto rom=block schedule=shared interval=auto share_dot=auto share_mul=1 share_add=auto
--   share_table=auto share_root=auto share_divide=auto share_latency=auto share_loads=no
-- latency 13 cycles, interval 3 cycles; tables read on the clock
-- absolute errors against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   angle: mean 2.96e-1 rad, largest seen 1.03e0 rad at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
--   dot: mean 2.93e-1, largest seen 9.83e-1 at phi_a=63191 theta_a=16419 phi_n=6223 theta_n=16703
--   x: mean 1.90e-1, largest seen 7.70e-1 at phi_a=34757 theta_a=16352 phi_n=57388 theta_n=19960
--   y: mean 6.21e-2, largest seen 2.97e-1 at phi_a=12448 theta_a=16689 phi_n=28272 theta_n=16284
--   z: mean 1.80e-1, largest seen 7.54e-1 at phi_a=46723 theta_a=16419 phi_n=40254 theta_n=12730
-- no bound is stated: asin, 1/sin and 1/cos have infinite slopes, so no word length bounds the error; each table's own error is stated
--
-- Self-checking testbench of rotation_corrected_shared.
-- Each line of rotation_corrected_shared_vectors.txt holds the input words and then the
-- expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
-- every 3 cycles when the module is ready, with words that it must ignore in between.
-- The second pass sends the first 358 again with stalls and gaps,
-- with a reset in mid-stream. Every bit of every output and the latency are compared.
-- The last line says PASS or FAIL; a failure ends with a nonzero status, for which GHDL prints one
-- more line. With --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity rotation_corrected_shared_tb is
end entity;

architecture test of rotation_corrected_shared_tb is
    constant latency : natural := 13;
    constant interval : natural := 3;
    constant shown : natural := 10; -- of the mismatches

    -- The prefix dut_ keeps the ports' names apart from the names used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal ready : std_logic;
    signal dut_phi_a : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_a : unsigned(15 downto 0) := (others => '0');
    signal dut_phi_n : unsigned(15 downto 0) := (others => '0');
    signal dut_theta_n : unsigned(15 downto 0) := (others => '0');
    signal dut_phi : unsigned(15 downto 0);
    signal dut_theta : unsigned(15 downto 0);
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
    dut : entity work.rotation_corrected_shared
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            ready => ready,
            phi_a => dut_phi_a,
            theta_a => dut_theta_a,
            phi_n => dut_phi_n,
            theta_n => dut_theta_n,
            phi => dut_phi,
            theta => dut_theta
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(31 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 358;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable phase : natural := 0; -- as the module should count it
        variable should_be_ready : std_logic;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_phi_a : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_a : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi_n : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta_n : std_logic_vector(15 downto 0) := (others => '0');
        variable next_phi : std_logic_vector(15 downto 0) := (others => '0');
        variable next_theta : std_logic_vector(15 downto 0) := (others => '0');

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
            file_open(status, vectors, "rotation_corrected_shared_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: rotation_corrected_shared_vectors.txt can't be read");
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
                hread(words, next_phi, good);
                more := more and good;
                hread(words, next_theta, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: rotation_corrected_shared_vectors.txt is cut short after vector " & to_string(sent));
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
            should_be_ready := '0';
            if phase = 0 then
                should_be_ready := '1';
            end if;
            if started and ready /= should_be_ready then
                mismatch("vector " & to_string(sent) & " ready expected "
                    & to_string(should_be_ready) & " got " & to_string(ready));
            end if;
            -- Each word is checked once: in a cycle with ce, after which the pipeline advances.
            if ce = '1' and valid(latency) = '1' then
                check_port("phi", expected(latency)(31 downto 16),
                    std_logic_vector(dut_phi));
                check_port("theta", expected(latency)(15 downto 0),
                    std_logic_vector(dut_theta));
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
            if rst = '1' then
                phase := 0;
            elsif ce = '1' then
                phase := (phase + 1) mod interval;
            end if;
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
            if ce = '1' or valid(0) = '0' then
                valid(0) := '0';
                if phase = 0 and more and not (stalls and lfsr(5 downto 3) = 0) then
                    read_vector;
                    if more then
                        valid(0) := '1';
                        expected(0)(31 downto 16) := next_phi;
                        expected(0)(15 downto 0) := next_theta;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 358 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                if phase /= 0 and lfsr(6) = '1' then
                    valid_in <= '1';
                end if;
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
            if stalls and not reset_done and sent = 358 / 2 and phase = interval / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: rotation_corrected_shared_vectors.txt holds " & to_string(passed)
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
