-- emboss: texture coordinates displaced by the direction of a light, for embossing
-- made by fixpath 0.1.0; seeds 000 and 003 (US 6,980,218; US 7,307,640), seed 002 (GL_NV_texgen_emboss)
--   setting=nv frame=auto normalise_basis=auto s_vector=auto l_sign=light-vertex t_sign=auto
--   scale_q=auto constants=auto ks=1 kt=1 input20=off component_bits=16 matrix_bits=16
--   matrix_int_bits=2 position_bits=28 position_frac_bits=15 guard_bits=4 norm_bits=18
--   dot_frac_bits=20 root_scheme=linear root_addr_bits=9 root_frac_bits=18 constant_int_bits=auto
--   constant_frac_bits=auto texture_int_bits=6 texture_frac_bits=18 overflow=saturate
--   rounding=half-up texture_size=256 light=0 source=0 destination=1 period_ps=5000 stages=auto
--   rom=block
-- latency 25 cycles, interval 1 cycle; tables read on the clock
-- errors, absolute where nothing else is said, against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   ds_texels: mean 8.34e-4 texel, largest seen 6.81e-3 texel at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
--   ds_relative: mean 2.65e-6, largest seen 1.57e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=16750 normal_y=-6938 normal_z=100 ct_x=370 ct_y=-1703 ct_z=18454 light_x=-21858093 light_y=11862104 light_z=22208289 vertex_x=-20247618 vertex_y=12204548 vertex_z=17798660 s0=2324101 t0=-917458 q0=289204 r0=140514
--   ds: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
--   dt_texels: mean 7.78e-4 texel, largest seen 6.34e-3 texel at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
--   dt_relative: mean 2.48e-6, largest seen 1.69e-5 over the vector's length times its factor, each 1/4 where it is less, at normal_x=539 normal_y=10101 normal_z=11796 ct_x=-4134 ct_y=-13685 ct_z=9001 light_x=-16348031 light_y=19544902 light_z=11919376 vertex_x=-16890033 vertex_y=19483858 vertex_z=11791741 s0=601665 t0=-1430898 q0=258948 r0=-148469
--   dt: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
--   s1: mean 3.26e-6, largest seen 2.66e-5 (7.0 ulp) at normal_x=-403 normal_y=4343 normal_z=17658 ct_x=-16730 ct_y=-4206 ct_z=-10791 light_x=-19512504 light_y=-18114054 light_z=8315440 vertex_x=-16955403 vertex_y=-18333786 vertex_z=3893611 s0=2208087 t0=-3181104 q0=504736 r0=-29596
--   t1: mean 3.04e-6, largest seen 2.48e-5 (6.5 ulp) at normal_x=7206 normal_y=-1587 normal_z=-17062 ct_x=-15241 ct_y=-684 ct_z=-1332 light_x=13815813 light_y=18380882 light_z=25053412 vertex_x=13614035 vertex_y=18660875 vertex_z=25060581 s0=-3345646 t0=-547138 q0=402065 r0=5114
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
--   q1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
--   r1: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at normal_x=-2531 normal_y=7271 normal_z=-13448 ct_x=-2894 ct_y=-19246 ct_z=1152 light_x=22420812 light_y=22017016 light_z=19624152 vertex_x=22724046 vertex_y=26548838 vertex_z=18617859 s0=2750663 t0=-1626897 q0=492838 r0=-122705
-- stated bound on each relative displacement (over the vector's length times its factor, each 1/4 where it is less): 1.09e-4
-- stated bound on each displacement: 1.32e-2
-- stated bound on each displacement in texels: 3.38e0
-- stated bound on each coordinate: 1.32e-2
-- stated bound on each flag and what is passed: 0.00e0
--
-- Self-checking testbench of emboss_nv. It reads emboss_nv_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 299 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity emboss_nv_tb is
end entity;

architecture test of emboss_nv_tb is
    constant latency : natural := 25;
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
    signal dut_light_x : signed(27 downto 0) := (others => '0');
    signal dut_light_y : signed(27 downto 0) := (others => '0');
    signal dut_light_z : signed(27 downto 0) := (others => '0');
    signal dut_vertex_x : signed(27 downto 0) := (others => '0');
    signal dut_vertex_y : signed(27 downto 0) := (others => '0');
    signal dut_vertex_z : signed(27 downto 0) := (others => '0');
    signal dut_s0 : signed(24 downto 0) := (others => '0');
    signal dut_t0 : signed(24 downto 0) := (others => '0');
    signal dut_q0 : signed(24 downto 0) := (others => '0');
    signal dut_r0 : signed(24 downto 0) := (others => '0');
    signal dut_ds : signed(29 downto 0);
    signal dut_dt : signed(33 downto 0);
    signal dut_s1 : signed(24 downto 0);
    signal dut_t1 : signed(24 downto 0);
    signal dut_degenerate : unsigned(0 downto 0);
    signal dut_q1 : signed(24 downto 0);
    signal dut_r1 : signed(24 downto 0);
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
    dut : entity work.emboss_nv
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            normal_x => dut_normal_x,
            normal_y => dut_normal_y,
            normal_z => dut_normal_z,
            ct_x => dut_ct_x,
            ct_y => dut_ct_y,
            ct_z => dut_ct_z,
            light_x => dut_light_x,
            light_y => dut_light_y,
            light_z => dut_light_z,
            vertex_x => dut_vertex_x,
            vertex_y => dut_vertex_y,
            vertex_z => dut_vertex_z,
            s0 => dut_s0,
            t0 => dut_t0,
            q0 => dut_q0,
            r0 => dut_r0,
            ds => dut_ds,
            dt => dut_dt,
            s1 => dut_s1,
            t1 => dut_t1,
            degenerate => dut_degenerate,
            q1 => dut_q1,
            r1 => dut_r1
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(164 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 299;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_normal_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_normal_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_normal_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ct_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ct_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ct_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light_x : std_logic_vector(27 downto 0) := (others => '0');
        variable next_light_y : std_logic_vector(27 downto 0) := (others => '0');
        variable next_light_z : std_logic_vector(27 downto 0) := (others => '0');
        variable next_vertex_x : std_logic_vector(27 downto 0) := (others => '0');
        variable next_vertex_y : std_logic_vector(27 downto 0) := (others => '0');
        variable next_vertex_z : std_logic_vector(27 downto 0) := (others => '0');
        variable next_s0 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_t0 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_q0 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_r0 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_ds : std_logic_vector(29 downto 0) := (others => '0');
        variable next_dt : std_logic_vector(33 downto 0) := (others => '0');
        variable next_s1 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_t1 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_degenerate : std_logic_vector(0 downto 0) := (others => '0');
        variable next_q1 : std_logic_vector(24 downto 0) := (others => '0');
        variable next_r1 : std_logic_vector(24 downto 0) := (others => '0');

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
            file_open(status, vectors, "emboss_nv_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: emboss_nv_vectors.txt can't be read");
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
                hread(words, next_q0, good);
                more := more and good;
                hread(words, next_r0, good);
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
                hread(words, next_q1, good);
                more := more and good;
                hread(words, next_r1, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: emboss_nv_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("ds", expected(latency)(164 downto 135),
                    std_logic_vector(dut_ds));
                check_port("dt", expected(latency)(134 downto 101),
                    std_logic_vector(dut_dt));
                check_port("s1", expected(latency)(100 downto 76),
                    std_logic_vector(dut_s1));
                check_port("t1", expected(latency)(75 downto 51),
                    std_logic_vector(dut_t1));
                check_port("degenerate", expected(latency)(50 downto 50),
                    std_logic_vector(dut_degenerate));
                check_port("q1", expected(latency)(49 downto 25),
                    std_logic_vector(dut_q1));
                check_port("r1", expected(latency)(24 downto 0),
                    std_logic_vector(dut_r1));
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
                        expected(0)(164 downto 135) := next_ds;
                        expected(0)(134 downto 101) := next_dt;
                        expected(0)(100 downto 76) := next_s1;
                        expected(0)(75 downto 51) := next_t1;
                        expected(0)(50 downto 50) := next_degenerate;
                        expected(0)(49 downto 25) := next_q1;
                        expected(0)(24 downto 0) := next_r1;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 299 then
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
                    dut_light_x <= signed(next_light_x);
                    dut_light_y <= signed(next_light_y);
                    dut_light_z <= signed(next_light_z);
                    dut_vertex_x <= signed(next_vertex_x);
                    dut_vertex_y <= signed(next_vertex_y);
                    dut_vertex_z <= signed(next_vertex_z);
                    dut_s0 <= signed(next_s0);
                    dut_t0 <= signed(next_t0);
                    dut_q0 <= signed(next_q0);
                    dut_r0 <= signed(next_r0);
                else
                    dut_normal_x <= signed(not next_normal_x);
                    dut_normal_y <= signed(not next_normal_y);
                    dut_normal_z <= signed(not next_normal_z);
                    dut_ct_x <= signed(not next_ct_x);
                    dut_ct_y <= signed(not next_ct_y);
                    dut_ct_z <= signed(not next_ct_z);
                    dut_light_x <= signed(not next_light_x);
                    dut_light_y <= signed(not next_light_y);
                    dut_light_z <= signed(not next_light_z);
                    dut_vertex_x <= signed(not next_vertex_x);
                    dut_vertex_y <= signed(not next_vertex_y);
                    dut_vertex_z <= signed(not next_vertex_z);
                    dut_s0 <= signed(not next_s0);
                    dut_t0 <= signed(not next_t0);
                    dut_q0 <= signed(not next_q0);
                    dut_r0 <= signed(not next_r0);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 299 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: emboss_nv_vectors.txt holds " & to_string(passed)
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
