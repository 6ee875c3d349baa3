-- tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
-- made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
--   frame=faceted mirror=handed basis=orthonormal lights=1 position_int_bits=4
--   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
--   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
--   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
--   stages=auto rom=block
-- latency 21 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   t_angle: mean 6.45e-6 rad, at most 2.16e-5 rad at p0_x=-5927 p0_y=-11095 p0_z=1071 p1_x=-6255 p1_y=-11468 p1_z=2690 p2_x=-7080 p2_y=-11329 p2_z=1763 uv0_u=7666 uv0_v=-7496 uv1_u=7588 uv1_v=-7498 uv2_u=7607 uv2_v=-7670 view_x=1754 view_y=474 view_z=-3837 light0_x=17975 light0_y=-1762 light0_z=1258
--   t_dot: mean 8.59e-6, at most 2.42e-5 at p0_x=9122 p0_y=7380 p0_z=-12309 p1_x=9772 p1_y=6738 p1_z=-11756 p2_x=9789 p2_y=7374 p2_z=-11892 uv0_u=-18149 uv0_v=11201 uv1_u=-15610 uv1_v=15227 uv2_u=-15096 uv2_v=14921 view_x=2845 view_y=4743 view_z=3127 light0_x=-12333 light0_y=12814 light0_z=-20561
--   t_x: mean 4.37e-6, at most 1.98e-5 (1.3 ulp) at p0_x=7146 p0_y=3086 p0_z=-3400 p1_x=10193 p1_y=7138 p1_z=-3097 p2_x=11906 p2_y=6187 p2_z=-2749 uv0_u=2656 uv0_v=4926 uv1_u=2825 uv1_v=5250 uv2_u=2738 uv2_v=5092 view_x=2907 view_y=83 view_z=4228 light0_x=-1720 light0_y=-12523 light0_z=-2330
--   t_y: mean 4.38e-6, at most 1.99e-5 (1.3 ulp) at p0_x=7103 p0_y=20970 p0_z=-5182 p1_x=8045 p1_y=11853 p1_z=2486 p2_x=6350 p2_y=21051 p2_z=846 uv0_u=-2171 uv0_v=-2408 uv1_u=-6958 uv1_v=-6607 uv2_u=-5030 uv2_v=-15052 view_x=-6942 view_y=2324 view_z=1897 light0_x=-6388 light0_y=-8447 light0_z=-1975
--   t_z: mean 4.38e-6, at most 2.01e-5 (1.3 ulp) at p0_x=-11415 p0_y=842 p0_z=4640 p1_x=-11699 p1_y=802 p1_z=4722 p2_x=-11615 p2_y=733 p2_z=3407 uv0_u=-5684 uv0_v=-1949 uv1_u=-6008 uv1_v=-2345 uv2_u=-6076 uv2_v=-2388 view_x=4468 view_y=-4073 view_z=104 light0_x=16073 light0_y=-17347 light0_z=-7496
--   b_angle: mean 8.44e-6 rad, at most 2.79e-5 rad at p0_x=-3180 p0_y=-4413 p0_z=-8034 p1_x=2607 p1_y=7970 p1_z=-15239 p2_x=-889 p2_y=-1785 p2_z=-4853 uv0_u=-6230 uv0_v=5969 uv1_u=-6215 uv1_v=6987 uv2_u=-7813 uv2_v=6182 view_x=3819 view_y=-1036 view_z=10073 light0_x=-1610 light0_y=3550 light0_z=-6305
--   b_dot: mean 1.24e-5, at most 4.30e-5 at p0_x=12278 p0_y=11621 p0_z=13990 p1_x=11375 p1_y=8309 p1_z=13387 p2_x=8998 p2_y=7469 p2_z=8703 uv0_u=-7618 uv0_v=-6460 uv1_u=-16281 uv1_v=-2940 uv2_u=-10517 uv2_v=-1200 view_x=1020 view_y=2741 view_z=-3068 light0_x=13149 light0_y=-2778 light0_z=4761
--   b_x: mean 6.22e-6, at most 3.45e-5 (2.3 ulp) at p0_x=7226 p0_y=-14998 p0_z=871 p1_x=7783 p1_y=-15350 p1_z=1294 p2_x=6970 p2_y=-15610 p2_z=1126 uv0_u=7946 uv0_v=-7080 uv1_u=6965 uv1_v=-9584 uv2_u=5758 uv2_v=-5624 view_x=-10997 view_y=13161 view_z=-21944 light0_x=-6761 light0_y=-20247 light0_z=-17922
--   b_y: mean 6.22e-6, at most 4.25e-5 (2.8 ulp) at p0_x=12278 p0_y=11621 p0_z=13990 p1_x=11375 p1_y=8309 p1_z=13387 p2_x=8998 p2_y=7469 p2_z=8703 uv0_u=-7618 uv0_v=-6460 uv1_u=-16281 uv1_v=-2940 uv2_u=-10517 uv2_v=-1200 view_x=1020 view_y=2741 view_z=-3068 light0_x=13149 light0_y=-2778 light0_z=4761
--   b_z: mean 6.21e-6, at most 3.98e-5 (2.6 ulp) at p0_x=1953 p0_y=4070 p0_z=-8777 p1_x=4920 p1_y=1144 p1_z=-12122 p2_x=319 p2_y=4948 p2_z=-11429 uv0_u=-4360 uv0_v=1025 uv1_u=-3521 uv1_v=180 uv2_u=-3925 uv2_v=365 view_x=-1868 view_y=3527 view_z=3114 light0_x=3632 light0_y=-676 light0_z=-4700
--   n_angle: mean 6.37e-6 rad, at most 2.14e-5 rad at p0_x=-4585 p0_y=-16421 p0_z=-5035 p1_x=-4140 p1_y=-16528 p1_z=-5027 p2_x=-4632 p2_y=-16107 p2_z=-4814 uv0_u=-2538 uv0_v=4694 uv1_u=124 uv1_v=10674 uv2_u=1680 uv2_v=9543 view_x=-4033 view_y=13740 view_z=-2396 light0_x=-3659 light0_y=-1270 light0_z=7129
--   n_dot: mean 8.53e-6, at most 2.25e-5 at p0_x=-2609 p0_y=-2968 p0_z=15363 p1_x=-2538 p1_y=-2536 p1_z=15292 p2_x=-2530 p2_y=-2373 p2_z=15629 uv0_u=16058 uv0_v=-10187 uv1_u=16136 uv1_v=-10301 uv2_u=16085 uv2_v=-10253 view_x=-1835 view_y=4401 view_z=-490 light0_x=-2972 light0_y=1054 light0_z=-2876
--   n_x: mean 4.35e-6, at most 1.90e-5 (1.2 ulp) at p0_x=6773 p0_y=-12739 p0_z=-12588 p1_x=7329 p1_y=-20755 p1_z=-9060 p2_x=6998 p2_y=-18531 p2_z=-12147 uv0_u=8057 uv0_v=9867 uv1_u=-482 uv1_v=18225 uv2_u=15940 uv2_v=9621 view_x=-19182 view_y=-10642 view_z=-24299 light0_x=-1312 light0_y=2631 light0_z=-4570
--   n_y: mean 4.36e-6, at most 1.91e-5 (1.3 ulp) at p0_x=-12226 p0_y=634 p0_z=5936 p1_x=-12086 p1_y=700 p1_z=5995 p2_x=-12181 p2_y=676 p2_z=6066 uv0_u=-8051 uv0_v=-2205 uv1_u=-7886 uv1_v=-1724 uv2_u=-7061 uv2_v=-2075 view_x=3247 view_y=-7270 view_z=5894 light0_x=1770 light0_y=-5827 light0_z=2310
--   n_z: mean 4.35e-6, at most 1.98e-5 (1.3 ulp) at p0_x=12610 p0_y=14358 p0_z=-13232 p1_x=9810 p1_y=15863 p1_z=-14406 p2_x=9325 p2_y=14742 p2_z=-14102 uv0_u=-1328 uv0_v=-4113 uv1_u=-1435 uv1_v=-4121 uv2_u=-1295 uv2_v=-4182 view_x=-229 view_y=-1304 view_z=-4233 light0_x=-8364 light0_y=2670 light0_z=4137
--   ts_view_angle: mean 3.96e-5 rad, at most 1.93e-4 rad at p0_x=15106 p0_y=-3934 p0_z=5162 p1_x=15066 p1_y=-4043 p1_z=5130 p2_x=15008 p2_y=-3962 p2_z=5172 uv0_u=-15017 uv0_v=5398 uv1_u=-14584 uv1_v=4987 uv2_u=-14062 uv2_v=5854 view_x=-663 view_y=4135 view_z=341 light0_x=-23420 light0_y=-11490 light0_z=-2403
--   ts_view_dot: mean 3.07e-5, at most 9.45e-5 at p0_x=-15532 p0_y=2060 p0_z=-11307 p1_x=-15380 p1_y=2177 p1_z=-10629 p2_x=-15573 p2_y=2136 p2_z=-10602 uv0_u=8345 uv0_v=12674 uv1_u=8319 uv1_v=12378 uv2_u=8874 uv2_v=12436 view_x=-1149 view_y=10785 view_z=30560 light0_x=2081 light0_y=3962 light0_z=6437
--   ts_view_x: mean 1.57e-5, at most 5.71e-5 (0.9 ulp) at p0_x=-662 p0_y=-15931 p0_z=2486 p1_x=8497 p1_y=-10119 p1_z=1771 p2_x=3517 p2_y=-5095 p2_z=12770 uv0_u=-7221 uv0_v=12978 uv1_u=-7094 uv1_v=13291 uv2_u=-6784 uv2_v=13117 view_x=-2548 view_y=17058 view_z=21522 light0_x=-1889 light0_y=-8567 light0_z=-5681
--   ts_view_y: mean 1.61e-5, at most 7.54e-5 (1.2 ulp) at p0_x=-15532 p0_y=2060 p0_z=-11307 p1_x=-15380 p1_y=2177 p1_z=-10629 p2_x=-15573 p2_y=2136 p2_z=-10602 uv0_u=8345 uv0_v=12674 uv1_u=8319 uv1_v=12378 uv2_u=8874 uv2_v=12436 view_x=-1149 view_y=10785 view_z=30560 light0_x=2081 light0_y=3962 light0_z=6437
--   ts_view_z: mean 1.58e-5, at most 6.52e-5 (1.1 ulp) at p0_x=-18764 p0_y=-12988 p0_z=-5217 p1_x=-17167 p1_y=-14894 p1_z=-4310 p2_x=-15355 p2_y=-7300 p2_z=5766 uv0_u=13987 uv0_v=-3256 uv1_u=13863 uv1_v=-3526 uv2_u=14480 uv2_v=-3348 view_x=-28162 view_y=-10633 view_z=3107 light0_x=-2916 light0_y=5120 light0_z=15558
--   ts_light0_angle: mean 3.97e-5 rad, at most 2.06e-4 rad at p0_x=-4466 p0_y=-7167 p0_z=-14832 p1_x=-10152 p1_y=-7059 p1_z=-15435 p2_x=-6354 p2_y=-7443 p2_z=-16507 uv0_u=15096 uv0_v=1380 uv1_u=12050 uv1_v=3730 uv2_u=12066 uv2_v=2354 view_x=124 view_y=-4039 view_z=6271 light0_x=-632 light0_y=2017 light0_z=-3838
--   ts_light0_dot: mean 3.08e-5, at most 8.86e-5 at p0_x=1974 p0_y=4624 p0_z=-493 p1_x=1962 p1_y=4210 p1_z=-817 p2_x=946 p2_y=4494 p2_z=-1540 uv0_u=-5909 uv0_v=17467 uv1_u=-13442 uv1_v=18880 uv2_u=-23220 uv2_v=5139 view_x=-11415 view_y=-3935 view_z=-6310 light0_x=19077 light0_y=-21787 light0_z=-8618
--   ts_light0_x: mean 1.57e-5, at most 6.23e-5 (1.0 ulp) at p0_x=-8854 p0_y=5319 p0_z=13456 p1_x=-8796 p1_y=6196 p1_z=13262 p2_x=-8582 p2_y=5602 p2_z=13874 uv0_u=-13794 uv0_v=-2022 uv1_u=-14079 uv1_v=-1741 uv2_u=-13968 uv2_v=-1700 view_x=3187 view_y=4303 view_z=-14686 light0_x=3048 light0_y=-26196 light0_z=13009
--   ts_light0_y: mean 1.62e-5, at most 7.97e-5 (1.3 ulp) at p0_x=1974 p0_y=4624 p0_z=-493 p1_x=1962 p1_y=4210 p1_z=-817 p2_x=946 p2_y=4494 p2_z=-1540 uv0_u=-5909 uv0_v=17467 uv1_u=-13442 uv1_v=18880 uv2_u=-23220 uv2_v=5139 view_x=-11415 view_y=-3935 view_z=-6310 light0_x=19077 light0_y=-21787 light0_z=-8618
--   ts_light0_z: mean 1.57e-5, at most 6.13e-5 (1.0 ulp) at p0_x=-14147 p0_y=-3996 p0_z=7610 p1_x=-11250 p1_y=-5660 p1_z=9809 p2_x=-12527 p2_y=-4472 p2_z=3625 uv0_u=-963 uv0_v=13635 uv1_u=-1001 uv1_v=13455 uv2_u=-1046 uv2_v=13552 view_x=-3767 view_y=-2892 view_z=-2228 light0_x=-17184 light0_y=-24469 light0_z=1783
--   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
-- stated bound on each tangent: 5.74e-5
-- stated bound on each binormal: 1.28e-4
-- stated bound on each normal: 5.74e-5
-- stated bound on each view: 5.78e-4
-- stated bound on each light0: 5.78e-4
-- stated bound on each flags: 0.00e0
--
-- Self-checking testbench of tangent_faceted. It reads tangent_faceted_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 305 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tangent_faceted_tb is
end entity;

architecture test of tangent_faceted_tb is
    constant latency : natural := 21;
    constant shown : natural := 10; -- of the mismatches

    -- Each port has its name after dut_, so that it can't be one that is used here.
    signal clk : std_logic := '0';
    signal rst : std_logic := '1';
    signal ce : std_logic := '1';
    signal valid_in : std_logic := '0';
    signal valid_out : std_logic;
    signal dut_p0_x : signed(15 downto 0) := (others => '0');
    signal dut_p0_y : signed(15 downto 0) := (others => '0');
    signal dut_p0_z : signed(15 downto 0) := (others => '0');
    signal dut_p1_x : signed(15 downto 0) := (others => '0');
    signal dut_p1_y : signed(15 downto 0) := (others => '0');
    signal dut_p1_z : signed(15 downto 0) := (others => '0');
    signal dut_p2_x : signed(15 downto 0) := (others => '0');
    signal dut_p2_y : signed(15 downto 0) := (others => '0');
    signal dut_p2_z : signed(15 downto 0) := (others => '0');
    signal dut_uv0_u : signed(15 downto 0) := (others => '0');
    signal dut_uv0_v : signed(15 downto 0) := (others => '0');
    signal dut_uv1_u : signed(15 downto 0) := (others => '0');
    signal dut_uv1_v : signed(15 downto 0) := (others => '0');
    signal dut_uv2_u : signed(15 downto 0) := (others => '0');
    signal dut_uv2_v : signed(15 downto 0) := (others => '0');
    signal dut_view_x : signed(15 downto 0) := (others => '0');
    signal dut_view_y : signed(15 downto 0) := (others => '0');
    signal dut_view_z : signed(15 downto 0) := (others => '0');
    signal dut_light0_x : signed(15 downto 0) := (others => '0');
    signal dut_light0_y : signed(15 downto 0) := (others => '0');
    signal dut_light0_z : signed(15 downto 0) := (others => '0');
    signal dut_t_x : signed(17 downto 0);
    signal dut_t_y : signed(17 downto 0);
    signal dut_t_z : signed(17 downto 0);
    signal dut_b_x : signed(17 downto 0);
    signal dut_b_y : signed(17 downto 0);
    signal dut_b_z : signed(17 downto 0);
    signal dut_n_x : signed(17 downto 0);
    signal dut_n_y : signed(17 downto 0);
    signal dut_n_z : signed(17 downto 0);
    signal dut_ts_view_x : signed(16 downto 0);
    signal dut_ts_view_y : signed(16 downto 0);
    signal dut_ts_view_z : signed(16 downto 0);
    signal dut_ts_light0_x : signed(16 downto 0);
    signal dut_ts_light0_y : signed(16 downto 0);
    signal dut_ts_light0_z : signed(16 downto 0);
    signal dut_mirrored : unsigned(0 downto 0);
    signal dut_degenerate : unsigned(0 downto 0);
    signal dut_zero_uv : unsigned(0 downto 0);
    signal dut_zero_area : unsigned(0 downto 0);
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
    dut : entity work.tangent_faceted
        port map (
            clk => clk, rst => rst, ce => ce,
            valid_in => valid_in, valid_out => valid_out,
            p0_x => dut_p0_x,
            p0_y => dut_p0_y,
            p0_z => dut_p0_z,
            p1_x => dut_p1_x,
            p1_y => dut_p1_y,
            p1_z => dut_p1_z,
            p2_x => dut_p2_x,
            p2_y => dut_p2_y,
            p2_z => dut_p2_z,
            uv0_u => dut_uv0_u,
            uv0_v => dut_uv0_v,
            uv1_u => dut_uv1_u,
            uv1_v => dut_uv1_v,
            uv2_u => dut_uv2_u,
            uv2_v => dut_uv2_v,
            view_x => dut_view_x,
            view_y => dut_view_y,
            view_z => dut_view_z,
            light0_x => dut_light0_x,
            light0_y => dut_light0_y,
            light0_z => dut_light0_z,
            t_x => dut_t_x,
            t_y => dut_t_y,
            t_z => dut_t_z,
            b_x => dut_b_x,
            b_y => dut_b_y,
            b_z => dut_b_z,
            n_x => dut_n_x,
            n_y => dut_n_y,
            n_z => dut_n_z,
            ts_view_x => dut_ts_view_x,
            ts_view_y => dut_ts_view_y,
            ts_view_z => dut_ts_view_z,
            ts_light0_x => dut_ts_light0_x,
            ts_light0_y => dut_ts_light0_y,
            ts_light0_z => dut_ts_light0_z,
            mirrored => dut_mirrored,
            degenerate => dut_degenerate,
            zero_uv => dut_zero_uv,
            zero_area => dut_zero_area
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(267 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 305;
        variable sent, checked, mismatches, passed : natural := 0;
        variable more, stalls, reset_done, started : boolean := false;
        variable lfsr : unsigned(31 downto 0) := 32x"2545f491"; -- decides on stalls and gaps
        variable next_p0_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p0_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p0_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p1_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p1_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p1_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p2_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p2_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_p2_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv0_u : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv0_v : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv1_u : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv1_v : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv2_u : std_logic_vector(15 downto 0) := (others => '0');
        variable next_uv2_v : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_t_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_t_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_ts_view_x : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_view_y : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_view_z : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_light0_x : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_light0_y : std_logic_vector(16 downto 0) := (others => '0');
        variable next_ts_light0_z : std_logic_vector(16 downto 0) := (others => '0');
        variable next_mirrored : std_logic_vector(0 downto 0) := (others => '0');
        variable next_degenerate : std_logic_vector(0 downto 0) := (others => '0');
        variable next_zero_uv : std_logic_vector(0 downto 0) := (others => '0');
        variable next_zero_area : std_logic_vector(0 downto 0) := (others => '0');

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
            file_open(status, vectors, "tangent_faceted_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: tangent_faceted_vectors.txt can't be read");
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
                hread(words, next_p0_x, good);
                more := more and good;
                hread(words, next_p0_y, good);
                more := more and good;
                hread(words, next_p0_z, good);
                more := more and good;
                hread(words, next_p1_x, good);
                more := more and good;
                hread(words, next_p1_y, good);
                more := more and good;
                hread(words, next_p1_z, good);
                more := more and good;
                hread(words, next_p2_x, good);
                more := more and good;
                hread(words, next_p2_y, good);
                more := more and good;
                hread(words, next_p2_z, good);
                more := more and good;
                hread(words, next_uv0_u, good);
                more := more and good;
                hread(words, next_uv0_v, good);
                more := more and good;
                hread(words, next_uv1_u, good);
                more := more and good;
                hread(words, next_uv1_v, good);
                more := more and good;
                hread(words, next_uv2_u, good);
                more := more and good;
                hread(words, next_uv2_v, good);
                more := more and good;
                hread(words, next_view_x, good);
                more := more and good;
                hread(words, next_view_y, good);
                more := more and good;
                hread(words, next_view_z, good);
                more := more and good;
                hread(words, next_light0_x, good);
                more := more and good;
                hread(words, next_light0_y, good);
                more := more and good;
                hread(words, next_light0_z, good);
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
                hread(words, next_n_x, good);
                more := more and good;
                hread(words, next_n_y, good);
                more := more and good;
                hread(words, next_n_z, good);
                more := more and good;
                hread(words, next_ts_view_x, good);
                more := more and good;
                hread(words, next_ts_view_y, good);
                more := more and good;
                hread(words, next_ts_view_z, good);
                more := more and good;
                hread(words, next_ts_light0_x, good);
                more := more and good;
                hread(words, next_ts_light0_y, good);
                more := more and good;
                hread(words, next_ts_light0_z, good);
                more := more and good;
                hread(words, next_mirrored, good);
                more := more and good;
                hread(words, next_degenerate, good);
                more := more and good;
                hread(words, next_zero_uv, good);
                more := more and good;
                hread(words, next_zero_area, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: tangent_faceted_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("t_x", expected(latency)(267 downto 250),
                    std_logic_vector(dut_t_x));
                check_port("t_y", expected(latency)(249 downto 232),
                    std_logic_vector(dut_t_y));
                check_port("t_z", expected(latency)(231 downto 214),
                    std_logic_vector(dut_t_z));
                check_port("b_x", expected(latency)(213 downto 196),
                    std_logic_vector(dut_b_x));
                check_port("b_y", expected(latency)(195 downto 178),
                    std_logic_vector(dut_b_y));
                check_port("b_z", expected(latency)(177 downto 160),
                    std_logic_vector(dut_b_z));
                check_port("n_x", expected(latency)(159 downto 142),
                    std_logic_vector(dut_n_x));
                check_port("n_y", expected(latency)(141 downto 124),
                    std_logic_vector(dut_n_y));
                check_port("n_z", expected(latency)(123 downto 106),
                    std_logic_vector(dut_n_z));
                check_port("ts_view_x", expected(latency)(105 downto 89),
                    std_logic_vector(dut_ts_view_x));
                check_port("ts_view_y", expected(latency)(88 downto 72),
                    std_logic_vector(dut_ts_view_y));
                check_port("ts_view_z", expected(latency)(71 downto 55),
                    std_logic_vector(dut_ts_view_z));
                check_port("ts_light0_x", expected(latency)(54 downto 38),
                    std_logic_vector(dut_ts_light0_x));
                check_port("ts_light0_y", expected(latency)(37 downto 21),
                    std_logic_vector(dut_ts_light0_y));
                check_port("ts_light0_z", expected(latency)(20 downto 4),
                    std_logic_vector(dut_ts_light0_z));
                check_port("mirrored", expected(latency)(3 downto 3),
                    std_logic_vector(dut_mirrored));
                check_port("degenerate", expected(latency)(2 downto 2),
                    std_logic_vector(dut_degenerate));
                check_port("zero_uv", expected(latency)(1 downto 1),
                    std_logic_vector(dut_zero_uv));
                check_port("zero_area", expected(latency)(0 downto 0),
                    std_logic_vector(dut_zero_area));
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
                        expected(0)(267 downto 250) := next_t_x;
                        expected(0)(249 downto 232) := next_t_y;
                        expected(0)(231 downto 214) := next_t_z;
                        expected(0)(213 downto 196) := next_b_x;
                        expected(0)(195 downto 178) := next_b_y;
                        expected(0)(177 downto 160) := next_b_z;
                        expected(0)(159 downto 142) := next_n_x;
                        expected(0)(141 downto 124) := next_n_y;
                        expected(0)(123 downto 106) := next_n_z;
                        expected(0)(105 downto 89) := next_ts_view_x;
                        expected(0)(88 downto 72) := next_ts_view_y;
                        expected(0)(71 downto 55) := next_ts_view_z;
                        expected(0)(54 downto 38) := next_ts_light0_x;
                        expected(0)(37 downto 21) := next_ts_light0_y;
                        expected(0)(20 downto 4) := next_ts_light0_z;
                        expected(0)(3 downto 3) := next_mirrored;
                        expected(0)(2 downto 2) := next_degenerate;
                        expected(0)(1 downto 1) := next_zero_uv;
                        expected(0)(0 downto 0) := next_zero_area;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 305 then
                            more := false;
                        end if;
                    end if;
                end if;
                valid_in <= valid(0);
                -- A gap carries the opposite of the latest word.
                if valid(0) = '1' then
                    dut_p0_x <= signed(next_p0_x);
                    dut_p0_y <= signed(next_p0_y);
                    dut_p0_z <= signed(next_p0_z);
                    dut_p1_x <= signed(next_p1_x);
                    dut_p1_y <= signed(next_p1_y);
                    dut_p1_z <= signed(next_p1_z);
                    dut_p2_x <= signed(next_p2_x);
                    dut_p2_y <= signed(next_p2_y);
                    dut_p2_z <= signed(next_p2_z);
                    dut_uv0_u <= signed(next_uv0_u);
                    dut_uv0_v <= signed(next_uv0_v);
                    dut_uv1_u <= signed(next_uv1_u);
                    dut_uv1_v <= signed(next_uv1_v);
                    dut_uv2_u <= signed(next_uv2_u);
                    dut_uv2_v <= signed(next_uv2_v);
                    dut_view_x <= signed(next_view_x);
                    dut_view_y <= signed(next_view_y);
                    dut_view_z <= signed(next_view_z);
                    dut_light0_x <= signed(next_light0_x);
                    dut_light0_y <= signed(next_light0_y);
                    dut_light0_z <= signed(next_light0_z);
                else
                    dut_p0_x <= signed(not next_p0_x);
                    dut_p0_y <= signed(not next_p0_y);
                    dut_p0_z <= signed(not next_p0_z);
                    dut_p1_x <= signed(not next_p1_x);
                    dut_p1_y <= signed(not next_p1_y);
                    dut_p1_z <= signed(not next_p1_z);
                    dut_p2_x <= signed(not next_p2_x);
                    dut_p2_y <= signed(not next_p2_y);
                    dut_p2_z <= signed(not next_p2_z);
                    dut_uv0_u <= signed(not next_uv0_u);
                    dut_uv0_v <= signed(not next_uv0_v);
                    dut_uv1_u <= signed(not next_uv1_u);
                    dut_uv1_v <= signed(not next_uv1_v);
                    dut_uv2_u <= signed(not next_uv2_u);
                    dut_uv2_v <= signed(not next_uv2_v);
                    dut_view_x <= signed(not next_view_x);
                    dut_view_y <= signed(not next_view_y);
                    dut_view_z <= signed(not next_view_z);
                    dut_light0_x <= signed(not next_light0_x);
                    dut_light0_y <= signed(not next_light0_y);
                    dut_light0_z <= signed(not next_light0_z);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 305 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: tangent_faceted_vectors.txt holds " & to_string(passed)
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
