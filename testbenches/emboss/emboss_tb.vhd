-- emboss: texture coordinates displaced by the direction of a light, for embossing
-- made by fixpath 0.1.0; US 6,980,218; US 7,307,640; GL_NV_texgen_emboss
--   setting=gx frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
--   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
--   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
--   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
--   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
--   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
--   rom=block
-- latency 14 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute unless a scale is named, against the golden model of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst case:
--   ds_texels: mean 5.15e-4 texel, largest seen 4.51e-3 texel at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
--   ds_relative: mean 2.03e-6, largest seen 1.43e-5 over the vector's length times its factor, each at least 1/4, at m0_x=4132 m0_y=-131 m0_z=429 m1_x=133 m1_y=4154 m1_z=-11 m2_x=-428 m2_y=25 m2_z=4134 tangent_x=-10615 tangent_y=137 tangent_z=12480 binormal_x=-202 binormal_y=16379 binormal_z=-351 light_x=26912091 light_y=-19929090 light_z=-1678718 vertex_x=27451608 vertex_y=-19638454 vertex_z=-1458906 s0=-3142235 t0=-300807
--   ds: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
--   dt_texels: mean 5.17e-4 texel, largest seen 5.30e-3 texel at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
--   dt_relative: mean 2.03e-6, largest seen 1.55e-5 over the vector's length times its factor, each at least 1/4, at m0_x=1817 m0_y=-3955 m0_z=169 m1_x=460 m1_y=27 m1_z=-4332 m2_x=3932 m2_y=1825 m2_z=429 tangent_x=6988 tangent_y=-14240 tangent_z=4101 binormal_x=-170 binormal_y=4457 binormal_z=15765 light_x=-9167663 light_y=7142069 light_z=-10596957 vertex_x=-8884124 vertex_y=7444365 vertex_z=-9525055 s0=2333965 t0=3659718
--   dt: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
--   s1: mean 2.01e-6, largest seen 1.76e-5 (4.6 ulp) at m0_x=-442 m0_y=5407 m0_z=-14755 m1_x=-6142 m1_y=13528 m1_z=5141 m2_x=-14465 m2_y=-5909 m2_z=-1732 tangent_x=17214 tangent_y=6208 tangent_z=1262 binormal_x=6018 binormal_y=-11008 binormal_z=-11948 light_x=21336975 light_y=-15834250 light_z=24525963 vertex_x=21358568 vertex_y=-15697823 vertex_z=24496530 s0=3521428 t0=-2064244
--   t1: mean 2.02e-6, largest seen 2.07e-5 (5.4 ulp) at m0_x=16045 m0_y=65 m0_z=143 m1_x=-64 m1_y=16045 m1_z=-102 m2_x=-143 m2_y=101 m2_z=16045 tangent_x=8966 tangent_y=7112 tangent_z=-11725 binormal_x=-10345 binormal_y=-5688 binormal_z=-11360 light_x=-522867 light_y=-20208394 light_z=-19716311 vertex_x=689069 vertex_y=-19977840 vertex_z=-24049337 s0=3380560 t0=141093
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at m0_x=4674 m0_y=5079 m0_z=-2162 m1_x=-3514 m1_y=4923 m1_z=3966 m2_x=-4257 m2_y=1512 m2_z=-5648 tangent_x=-2894 tangent_y=-19246 tangent_z=1152 binormal_x=-2531 binormal_y=7271 binormal_z=-13448 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897
-- stated bound on each relative displacement (relative to the vector's length times its factor, each at least 1/4): 5.21e-5
-- stated bound on each displacement: 1.15e-3
-- stated bound on each displacement in texels: 2.93e-1
-- stated bound on each coordinate: 1.15e-3
-- stated bound on each flag and what is passed: 0.00e0
--
-- Self-checking testbench of emboss.
-- Each line of emboss_vectors.txt holds the input words and then the
-- expected output words, in hexadecimal. The first pass sends all vectors without stalls, one
-- per cycle. The second pass sends the first 303 again with stalls and gaps,
-- with a reset in mid-stream. Every bit of every output and the latency are compared.
-- The last line says PASS or FAIL; a failure ends with a nonzero status, for which GHDL prints one
-- more line. With --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity emboss_tb is
end entity;

architecture test of emboss_tb is
    constant latency : natural := 14;
    constant shown : natural := 10; -- of the mismatches

    -- The prefix dut_ keeps the ports' names apart from the names used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_m0_x : signed(15 downto 0) := (others => '0');
    signal dut_m0_y : signed(15 downto 0) := (others => '0');
    signal dut_m0_z : signed(15 downto 0) := (others => '0');
    signal dut_m1_x : signed(15 downto 0) := (others => '0');
    signal dut_m1_y : signed(15 downto 0) := (others => '0');
    signal dut_m1_z : signed(15 downto 0) := (others => '0');
    signal dut_m2_x : signed(15 downto 0) := (others => '0');
    signal dut_m2_y : signed(15 downto 0) := (others => '0');
    signal dut_m2_z : signed(15 downto 0) := (others => '0');
    signal dut_tangent_x : signed(15 downto 0) := (others => '0');
    signal dut_tangent_y : signed(15 downto 0) := (others => '0');
    signal dut_tangent_z : signed(15 downto 0) := (others => '0');
    signal dut_binormal_x : signed(15 downto 0) := (others => '0');
    signal dut_binormal_y : signed(15 downto 0) := (others => '0');
    signal dut_binormal_z : signed(15 downto 0) := (others => '0');
    signal dut_light_x : signed(27 downto 0) := (others => '0');
    signal dut_light_y : signed(27 downto 0) := (others => '0');
    signal dut_light_z : signed(27 downto 0) := (others => '0');
    signal dut_vertex_x : signed(27 downto 0) := (others => '0');
    signal dut_vertex_y : signed(27 downto 0) := (others => '0');
    signal dut_vertex_z : signed(27 downto 0) := (others => '0');
    signal dut_s0 : signed(24 downto 0) := (others => '0');
    signal dut_t0 : signed(24 downto 0) := (others => '0');
    signal dut_ds : signed(26 downto 0);
    signal dut_dt : signed(26 downto 0);
    signal dut_s1 : signed(24 downto 0);
    signal dut_t1 : signed(24 downto 0);
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
    dut : entity work.emboss
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            m0_x => dut_m0_x,
            m0_y => dut_m0_y,
            m0_z => dut_m0_z,
            m1_x => dut_m1_x,
            m1_y => dut_m1_y,
            m1_z => dut_m1_z,
            m2_x => dut_m2_x,
            m2_y => dut_m2_y,
            m2_z => dut_m2_z,
            tangent_x => dut_tangent_x,
            tangent_y => dut_tangent_y,
            tangent_z => dut_tangent_z,
            binormal_x => dut_binormal_x,
            binormal_y => dut_binormal_y,
            binormal_z => dut_binormal_z,
            light_x => dut_light_x,
            light_y => dut_light_y,
            light_z => dut_light_z,
            vertex_x => dut_vertex_x,
            vertex_y => dut_vertex_y,
            vertex_z => dut_vertex_z,
            s0 => dut_s0,
            t0 => dut_t0,
            ds => dut_ds,
            dt => dut_dt,
            s1 => dut_s1,
            t1 => dut_t1,
            degenerate => dut_degenerate
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(104 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- Expected outputs, shifted along with the pipeline; entry 0 belongs to the current inputs.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 303;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_m0_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m0_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m0_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m1_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m1_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m1_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m2_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m2_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_m2_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_tangent_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_tangent_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_tangent_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_binormal_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_binormal_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_binormal_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light_x : std_logic_vector(27 downto 0) := (others => '0');
        variable next_light_y : std_logic_vector(27 downto 0) := (others => '0');
        variable next_light_z : std_logic_vector(27 downto 0) := (others => '0');
        variable next_vertex_x : std_logic_vector(27 downto 0) := (others => '0');
        variable next_vertex_y : std_logic_vector(27 downto 0) := (others => '0');
        variable next_vertex_z : std_logic_vector(27 downto 0) := (others => '0');
        variable next_s0 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_t0 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_ds : std_logic_vector(26 downto 0) := (others => '0');
        variable next_dt : std_logic_vector(26 downto 0) := (others => '0');
        variable next_s1 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_t1 : std_logic_vector(24 downto 0) := (others => '0');
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
            file_open(status, vectors, "emboss_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: emboss_vectors.txt can't be read");
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
                hread(words, next_m0_x, good);
                more := more and good;
                hread(words, next_m0_y, good);
                more := more and good;
                hread(words, next_m0_z, good);
                more := more and good;
                hread(words, next_m1_x, good);
                more := more and good;
                hread(words, next_m1_y, good);
                more := more and good;
                hread(words, next_m1_z, good);
                more := more and good;
                hread(words, next_m2_x, good);
                more := more and good;
                hread(words, next_m2_y, good);
                more := more and good;
                hread(words, next_m2_z, good);
                more := more and good;
                hread(words, next_tangent_x, good);
                more := more and good;
                hread(words, next_tangent_y, good);
                more := more and good;
                hread(words, next_tangent_z, good);
                more := more and good;
                hread(words, next_binormal_x, good);
                more := more and good;
                hread(words, next_binormal_y, good);
                more := more and good;
                hread(words, next_binormal_z, good);
                more := more and good;
                hread(words, next_light_x, good);
                more := more and good;
                hread(words, next_light_y, good);
                more := more and good;
                hread(words, next_light_z, good);
                more := more and good;
                hread(words, next_vertex_x, good);
                more := more and good;
                hread(words, next_vertex_y, good);
                more := more and good;
                hread(words, next_vertex_z, good);
                more := more and good;
                hread(words, next_s0, good);
                more := more and good;
                hread(words, next_t0, good);
                more := more and good;
                hread(words, next_ds, good);
                more := more and good;
                hread(words, next_dt, good);
                more := more and good;
                hread(words, next_s1, good);
                more := more and good;
                hread(words, next_t1, good);
                more := more and good;
                hread(words, next_degenerate, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: emboss_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("ds", expected(latency)(104 downto 78),
                    std_logic_vector(dut_ds));
                check_port("dt", expected(latency)(77 downto 51),
                    std_logic_vector(dut_dt));
                check_port("s1", expected(latency)(50 downto 26),
                    std_logic_vector(dut_s1));
                check_port("t1", expected(latency)(25 downto 1),
                    std_logic_vector(dut_t1));
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
                        expected(0)(104 downto 78) := next_ds;
                        expected(0)(77 downto 51) := next_dt;
                        expected(0)(50 downto 26) := next_s1;
                        expected(0)(25 downto 1) := next_t1;
                        expected(0)(0 downto 0) := next_degenerate;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 303 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- In a gap the inputs are the complement of the latest words.
                if valid(0) = '1' then
                    dut_m0_x <= signed(next_m0_x);
                    dut_m0_y <= signed(next_m0_y);
                    dut_m0_z <= signed(next_m0_z);
                    dut_m1_x <= signed(next_m1_x);
                    dut_m1_y <= signed(next_m1_y);
                    dut_m1_z <= signed(next_m1_z);
                    dut_m2_x <= signed(next_m2_x);
                    dut_m2_y <= signed(next_m2_y);
                    dut_m2_z <= signed(next_m2_z);
                    dut_tangent_x <= signed(next_tangent_x);
                    dut_tangent_y <= signed(next_tangent_y);
                    dut_tangent_z <= signed(next_tangent_z);
                    dut_binormal_x <= signed(next_binormal_x);
                    dut_binormal_y <= signed(next_binormal_y);
                    dut_binormal_z <= signed(next_binormal_z);
                    dut_light_x <= signed(next_light_x);
                    dut_light_y <= signed(next_light_y);
                    dut_light_z <= signed(next_light_z);
                    dut_vertex_x <= signed(next_vertex_x);
                    dut_vertex_y <= signed(next_vertex_y);
                    dut_vertex_z <= signed(next_vertex_z);
                    dut_s0 <= signed(next_s0);
                    dut_t0 <= signed(next_t0);
                else
                    dut_m0_x <= signed(not next_m0_x);
                    dut_m0_y <= signed(not next_m0_y);
                    dut_m0_z <= signed(not next_m0_z);
                    dut_m1_x <= signed(not next_m1_x);
                    dut_m1_y <= signed(not next_m1_y);
                    dut_m1_z <= signed(not next_m1_z);
                    dut_m2_x <= signed(not next_m2_x);
                    dut_m2_y <= signed(not next_m2_y);
                    dut_m2_z <= signed(not next_m2_z);
                    dut_tangent_x <= signed(not next_tangent_x);
                    dut_tangent_y <= signed(not next_tangent_y);
                    dut_tangent_z <= signed(not next_tangent_z);
                    dut_binormal_x <= signed(not next_binormal_x);
                    dut_binormal_y <= signed(not next_binormal_y);
                    dut_binormal_z <= signed(not next_binormal_z);
                    dut_light_x <= signed(not next_light_x);
                    dut_light_y <= signed(not next_light_y);
                    dut_light_z <= signed(not next_light_z);
                    dut_vertex_x <= signed(not next_vertex_x);
                    dut_vertex_y <= signed(not next_vertex_y);
                    dut_vertex_z <= signed(not next_vertex_z);
                    dut_s0 <= signed(not next_s0);
                    dut_t0 <= signed(not next_t0);
                end if;
            end if;
            -- A reset in mid-stream takes effect despite the stall: words in flight are lost.
            if stalls and not reset_done and sent = 303 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: emboss_vectors.txt holds " & to_string(passed)
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
