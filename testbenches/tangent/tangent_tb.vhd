-- tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
-- made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
--   frame=smooth mirror=handed basis=orthonormal lights=1 position_int_bits=4
--   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
--   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
--   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
--   stages=auto rom=block
-- latency 23 cycles, interval 1 cycle; tables read on the clock
-- absolute errors against the golden of the quantised inputs, over 65536 random inputs
-- (sampler sphere, seed 1), and the input words of the worst:
--   t_angle: mean 7.24e-6 rad, at most 2.67e-5 rad at p0_x=6307 p0_y=11776 p0_z=-7782 p1_x=6341 p1_y=11968 p1_z=-7817 p2_x=6303 p2_y=11854 p2_z=-7706 uv0_u=-971 uv0_v=-2351 uv1_u=-1077 uv1_v=-2180 uv2_u=-1109 uv2_v=-2135 normal_x=-12135 normal_y=-10823 normal_z=-2011 view_x=-6407 view_y=614 view_z=1303 light0_x=-3616 light0_y=-12959 light0_z=3429
--   t_dot: mean 1.01e-5, at most 3.30e-5 at p0_x=-8071 p0_y=1654 p0_z=13781 p1_x=-5340 p1_y=4462 p1_z=-15500 p2_x=-2437 p2_y=5463 p2_z=-14212 uv0_u=15328 uv0_v=4201 uv1_u=15061 uv1_v=17215 uv2_u=6582 uv2_v=2726 normal_x=3874 normal_y=11987 normal_z=-10476 view_x=-16397 view_y=6591 view_z=-4081 light0_x=-1241 light0_y=-4126 light0_z=288
--   t_x: mean 5.07e-6, at most 2.71e-5 (1.8 ulp) at p0_x=-168 p0_y=-7474 p0_z=7202 p1_x=14210 p1_y=-12047 p1_z=2517 p2_x=9768 p2_y=-5021 p2_z=2834 uv0_u=2163 uv0_v=-5872 uv1_u=5115 uv1_v=-6789 uv2_u=6787 uv2_v=-4231 normal_x=-3553 normal_y=-14655 normal_z=6406 view_x=-2067 view_y=-3586 view_z=3548 light0_x=-58 light0_y=-17001 light0_z=-1946
--   t_y: mean 5.08e-6, at most 2.61e-5 (1.7 ulp) at p0_x=-2162 p0_y=12802 p0_z=-839 p1_x=-3410 p1_y=13339 p1_z=-254 p2_x=-2991 p2_y=14052 p2_z=-599 uv0_u=2962 uv0_v=2267 uv1_u=3113 uv1_v=2437 uv2_u=3116 uv2_v=2392 normal_x=12588 normal_y=3105 normal_z=-10017 view_x=10626 view_y=-6078 view_z=-8807 light0_x=-9553 light0_y=6888 light0_z=-3770
--   t_z: mean 5.08e-6, at most 2.49e-5 (1.6 ulp) at p0_x=10683 p0_y=-14509 p0_z=9301 p1_x=10695 p1_y=-14457 p1_z=9433 p2_x=10715 p2_y=-14532 p2_z=9414 uv0_u=-1946 uv0_v=8241 uv1_u=-2166 uv1_v=8121 uv2_u=-2145 uv2_v=8259 normal_x=5834 normal_y=-15237 normal_z=-1491 view_x=-2014 view_y=-3928 view_z=-685 light0_x=-21971 light0_y=-5651 light0_z=7739
--   b_angle: mean 6.64e-6 rad, at most 1.92e-5 rad at p0_x=-5491 p0_y=10305 p0_z=10682 p1_x=-4950 p1_y=7772 p1_z=11733 p2_x=-5079 p2_y=8282 p2_z=12040 uv0_u=-8844 uv0_v=-9274 uv1_u=-7243 uv1_v=-10129 uv2_u=-7269 uv2_v=-7621 normal_x=3005 normal_y=-10143 normal_z=12511 view_x=21916 view_y=235 view_z=-23989 light0_x=4624 light0_y=-4372 light0_z=-196
--   b_dot: mean 8.73e-6, at most 2.44e-5 at p0_x=467 p0_y=3555 p0_z=10009 p1_x=49 p1_y=3536 p1_z=10348 p2_x=-7 p2_y=3343 p2_z=9708 uv0_u=2226 uv0_v=14319 uv1_u=2223 uv1_v=14337 uv2_u=2187 uv2_v=14398 normal_x=-5275 normal_y=171 normal_z=-15511 view_x=-5254 view_y=19385 view_z=3536 light0_x=-3852 light0_y=2266 light0_z=5760
--   b_x: mean 4.44e-6, at most 2.11e-5 (1.4 ulp) at p0_x=-8071 p0_y=1654 p0_z=13781 p1_x=-5340 p1_y=4462 p1_z=-15500 p2_x=-2437 p2_y=5463 p2_z=-14212 uv0_u=15328 uv0_v=4201 uv1_u=15061 uv1_v=17215 uv2_u=6582 uv2_v=2726 normal_x=3874 normal_y=11987 normal_z=-10476 view_x=-16397 view_y=6591 view_z=-4081 light0_x=-1241 light0_y=-4126 light0_z=288
--   b_y: mean 4.44e-6, at most 1.88e-5 (1.2 ulp) at p0_x=-3714 p0_y=11993 p0_z=-4841 p1_x=-3764 p1_y=11931 p1_z=-4739 p2_x=-3759 p2_y=11932 p2_z=-4729 uv0_u=12092 uv0_v=-12014 uv1_u=12267 uv1_v=-11980 uv2_u=12203 uv2_v=-12004 normal_x=-13726 normal_y=-3888 normal_z=8056 view_x=7928 view_y=5000 view_z=-9270 light0_x=-8591 light0_y=-2032 light0_z=2462
--   b_z: mean 4.44e-6, at most 1.98e-5 (1.3 ulp) at p0_x=4141 p0_y=14013 p0_z=-6260 p1_x=4269 p1_y=14979 p1_z=-7029 p2_x=3585 p2_y=15097 p2_z=-6866 uv0_u=-5921 uv0_v=-14115 uv1_u=-4919 uv1_v=-11019 uv2_u=-4604 uv2_v=-11113 normal_x=112 normal_y=-14114 normal_z=-8320 view_x=4104 view_y=-653 view_z=-1311 light0_x=3193 light0_y=10223 light0_z=8490
--   n_angle: mean 0.00e0 rad, at most 0.00e0 rad at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   n_dot: mean 0.00e0, at most 0.00e0 at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   n_x: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   n_y: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   n_z: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   ts_view_angle: mean 3.93e-5 rad, at most 1.91e-4 rad at p0_x=-10379 p0_y=-5989 p0_z=-12594 p1_x=-10455 p1_y=-5549 p1_z=-12755 p2_x=-9709 p2_y=-5739 p2_z=-12952 uv0_u=5256 uv0_v=-6470 uv1_u=5262 uv1_v=-6034 uv2_u=4818 uv2_v=-5248 normal_x=848 normal_y=13600 normal_z=9097 view_x=-4050 view_y=186 view_z=1399 light0_x=5643 light0_y=6660 light0_z=5965
--   ts_view_dot: mean 3.01e-5, at most 8.02e-5 at p0_x=93 p0_y=17274 p0_z=15297 p1_x=-96 p1_y=3762 p1_z=-8987 p2_x=16619 p2_y=4176 p2_z=7976 uv0_u=-1383 uv0_v=2969 uv1_u=1920 uv1_v=1001 uv2_u=-3955 uv2_v=6992 normal_x=-3847 normal_y=8478 normal_z=-13482 view_x=-17726 view_y=15655 view_z=12116 light0_x=-2683 light0_y=3444 light0_z=4548
--   ts_view_x: mean 1.58e-5, at most 6.72e-5 (1.1 ulp) at p0_x=12778 p0_y=-893 p0_z=-1690 p1_x=13532 p1_y=-472 p1_z=-1673 p2_x=13847 p2_y=-805 p2_z=-2306 uv0_u=14279 uv0_v=-11497 uv1_u=14210 uv1_v=-11535 uv2_u=13826 uv2_v=-11581 normal_x=-3885 normal_y=-14892 normal_z=-5618 view_x=-18929 view_y=10081 view_z=-23409 light0_x=-7002 light0_y=3524 light0_z=-2465
--   ts_view_y: mean 1.57e-5, at most 5.53e-5 (0.9 ulp) at p0_x=14966 p0_y=-4901 p0_z=5057 p1_x=14270 p1_y=-5168 p1_z=5855 p2_x=13970 p2_y=-5062 p2_z=5333 uv0_u=6017 uv0_v=2340 uv1_u=5567 uv1_v=2787 uv2_u=5681 uv2_v=2610 normal_x=15873 normal_y=-1072 normal_z=3917 view_x=2653 view_y=27007 view_z=1656 light0_x=16390 light0_y=3803 light0_z=-1999
--   ts_view_z: mean 1.52e-5, at most 3.05e-5 (0.5 ulp) at p0_x=3594 p0_y=11946 p0_z=-523 p1_x=5122 p1_y=12371 p1_z=-1285 p2_x=3431 p2_y=11911 p2_z=-506 uv0_u=6018 uv0_v=10570 uv1_u=7266 uv1_v=9893 uv2_u=9285 uv2_v=7281 normal_x=-1475 normal_y=12091 normal_z=-10958 view_x=-663 view_y=121 view_z=6252 light0_x=1915 light0_y=14656 light0_z=927
--   ts_light0_angle: mean 3.93e-5 rad, at most 1.85e-4 rad at p0_x=-4133 p0_y=6414 p0_z=4611 p1_x=-6787 p1_y=5202 p1_z=4370 p2_x=-6421 p2_y=6226 p2_z=5263 uv0_u=12674 uv0_v=-15695 uv1_u=12664 uv1_v=-15732 uv2_u=13869 uv2_v=-15432 normal_x=3390 normal_y=-6622 normal_z=14598 view_x=-2567 view_y=-1328 view_z=3625 light0_x=-2975 light0_y=-1304 light0_z=-2623
--   ts_light0_dot: mean 3.02e-5, at most 7.79e-5 at p0_x=14042 p0_y=244 p0_z=870 p1_x=13244 p1_y=125 p1_z=1151 p2_x=13458 p2_y=-230 p2_z=818 uv0_u=-8931 uv0_v=-11759 uv1_u=-8598 uv1_v=-11711 uv2_u=-8719 uv2_v=-12141 normal_x=-12332 normal_y=-8894 normal_z=6104 view_x=-8235 view_y=-3 view_z=-9860 light0_x=19580 light0_y=-10606 light0_z=10271
--   ts_light0_x: mean 1.59e-5, at most 6.45e-5 (1.1 ulp) at p0_x=1221 p0_y=-14455 p0_z=-23110 p1_x=-458 p1_y=7451 p1_z=-13623 p2_x=389 p2_y=-15913 p2_z=-20484 uv0_u=9641 uv0_v=-15279 uv1_u=18304 uv1_v=-2656 uv2_u=21139 uv2_v=-9008 normal_x=10502 normal_y=9187 normal_z=-8588 view_x=-838 view_y=-7767 view_z=2349 light0_x=-18601 light0_y=14838 light0_z=18261
--   ts_light0_y: mean 1.57e-5, at most 6.04e-5 (1.0 ulp) at p0_x=2438 p0_y=-14018 p0_z=1104 p1_x=2072 p1_y=-5346 p1_z=313 p2_x=1823 p2_y=-12265 p2_z=4078 uv0_u=-3585 uv0_v=-3488 uv1_u=5415 uv1_v=6678 uv2_u=10042 uv2_v=-3736 normal_x=1193 normal_y=-14634 normal_z=-7270 view_x=-23837 view_y=1801 view_z=-1888 light0_x=-19807 light0_y=-2544 light0_z=-25007
--   ts_light0_z: mean 1.53e-5, at most 3.05e-5 (0.5 ulp) at p0_x=12625 p0_y=15115 p0_z=-8100 p1_x=12746 p1_y=15704 p1_z=-7639 p2_x=12889 p2_y=15622 p2_z=-8084 uv0_u=15295 uv0_v=-10727 uv1_u=14476 uv1_v=-9526 uv2_u=15225 uv2_v=-11996 normal_x=11249 normal_y=6256 normal_z=10137 view_x=216 view_y=-4893 view_z=-2363 light0_x=7415 light0_y=7893 light0_z=-8911
--   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
--   parallel: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
-- stated bound on each tangent: 2.12e-4
-- stated bound on each binormal: 5.74e-5
-- stated bound on each normal: 0.00e0
-- stated bound on each view: 8.14e-4
-- stated bound on each light0: 8.14e-4
-- stated bound on each flags: 0.00e0
--
-- Self-checking testbench of tangent. It reads tangent_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 338 go again with stalls and
-- gaps. Every bit of every output and the latency are compared. The last line says PASS or
-- FAIL, and a failure ends with a status that isn't 0, of which GHDL says a line more. With
-- --vcd=FILE, GHDL writes waves.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tangent_tb is
end entity;

architecture test of tangent_tb is
    constant latency : natural := 23;
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
    signal dut_normal_x : signed(15 downto 0) := (others => '0');
    signal dut_normal_y : signed(15 downto 0) := (others => '0');
    signal dut_normal_z : signed(15 downto 0) := (others => '0');
    signal dut_view_x : signed(15 downto 0) := (others => '0');
    signal dut_view_y : signed(15 downto 0) := (others => '0');
    signal dut_view_z : signed(15 downto 0) := (others => '0');
    signal dut_light0_x : signed(15 downto 0) := (others => '0');
    signal dut_light0_y : signed(15 downto 0) := (others => '0');
    signal dut_light0_z : signed(15 downto 0) := (others => '0');
    signal dut_t_x : signed(18 downto 0);
    signal dut_t_y : signed(18 downto 0);
    signal dut_t_z : signed(18 downto 0);
    signal dut_b_x : signed(17 downto 0);
    signal dut_b_y : signed(17 downto 0);
    signal dut_b_z : signed(17 downto 0);
    signal dut_n_x : signed(15 downto 0);
    signal dut_n_y : signed(15 downto 0);
    signal dut_n_z : signed(15 downto 0);
    signal dut_ts_view_x : signed(18 downto 0);
    signal dut_ts_view_y : signed(18 downto 0);
    signal dut_ts_view_z : signed(18 downto 0);
    signal dut_ts_light0_x : signed(18 downto 0);
    signal dut_ts_light0_y : signed(18 downto 0);
    signal dut_ts_light0_z : signed(18 downto 0);
    signal dut_mirrored : unsigned(0 downto 0);
    signal dut_degenerate : unsigned(0 downto 0);
    signal dut_zero_uv : unsigned(0 downto 0);
    signal dut_zero_area : unsigned(0 downto 0);
    signal dut_parallel : unsigned(0 downto 0);
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
    dut : entity work.tangent
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
            normal_x => dut_normal_x,
            normal_y => dut_normal_y,
            normal_z => dut_normal_z,
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
            zero_area => dut_zero_area,
            parallel => dut_parallel
        );

    clk <= not clk after 5 ns when not done;

    process
        type words_t is array (0 to latency) of std_logic_vector(277 downto 0);
        type numbers_t is array (0 to latency) of natural;

        -- What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
        variable expected : words_t;
        variable valid : std_logic_vector(0 to latency) := (others => '0');
        variable number : numbers_t;

        file vectors : text;
        constant count : natural := 338;
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
        variable next_normal_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_normal_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_normal_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_view_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_light0_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_t_x : std_logic_vector(18 downto 0) := (others => '0');
        variable next_t_y : std_logic_vector(18 downto 0) := (others => '0');
        variable next_t_z : std_logic_vector(18 downto 0) := (others => '0');
        variable next_b_x : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_y : std_logic_vector(17 downto 0) := (others => '0');
        variable next_b_z : std_logic_vector(17 downto 0) := (others => '0');
        variable next_n_x : std_logic_vector(15 downto 0) := (others => '0');
        variable next_n_y : std_logic_vector(15 downto 0) := (others => '0');
        variable next_n_z : std_logic_vector(15 downto 0) := (others => '0');
        variable next_ts_view_x : std_logic_vector(18 downto 0) := (others => '0');
        variable next_ts_view_y : std_logic_vector(18 downto 0) := (others => '0');
        variable next_ts_view_z : std_logic_vector(18 downto 0) := (others => '0');
        variable next_ts_light0_x : std_logic_vector(18 downto 0) := (others => '0');
        variable next_ts_light0_y : std_logic_vector(18 downto 0) := (others => '0');
        variable next_ts_light0_z : std_logic_vector(18 downto 0) := (others => '0');
        variable next_mirrored : std_logic_vector(0 downto 0) := (others => '0');
        variable next_degenerate : std_logic_vector(0 downto 0) := (others => '0');
        variable next_zero_uv : std_logic_vector(0 downto 0) := (others => '0');
        variable next_zero_area : std_logic_vector(0 downto 0) := (others => '0');
        variable next_parallel : std_logic_vector(0 downto 0) := (others => '0');

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
            file_open(status, vectors, "tangent_vectors.txt", read_mode);
            if status /= open_ok then
                print("FAIL: tangent_vectors.txt can't be read");
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
                hread(words, next_normal_x, good);
                more := more and good;
                hread(words, next_normal_y, good);
                more := more and good;
                hread(words, next_normal_z, good);
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
                hread(words, next_parallel, good);
                more := more and good;
                if not more then
                    mismatches := mismatches + 1;
                    print("mismatch: tangent_vectors.txt is cut short after vector " & to_string(sent));
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
                check_port("t_x", expected(latency)(277 downto 259),
                    std_logic_vector(dut_t_x));
                check_port("t_y", expected(latency)(258 downto 240),
                    std_logic_vector(dut_t_y));
                check_port("t_z", expected(latency)(239 downto 221),
                    std_logic_vector(dut_t_z));
                check_port("b_x", expected(latency)(220 downto 203),
                    std_logic_vector(dut_b_x));
                check_port("b_y", expected(latency)(202 downto 185),
                    std_logic_vector(dut_b_y));
                check_port("b_z", expected(latency)(184 downto 167),
                    std_logic_vector(dut_b_z));
                check_port("n_x", expected(latency)(166 downto 151),
                    std_logic_vector(dut_n_x));
                check_port("n_y", expected(latency)(150 downto 135),
                    std_logic_vector(dut_n_y));
                check_port("n_z", expected(latency)(134 downto 119),
                    std_logic_vector(dut_n_z));
                check_port("ts_view_x", expected(latency)(118 downto 100),
                    std_logic_vector(dut_ts_view_x));
                check_port("ts_view_y", expected(latency)(99 downto 81),
                    std_logic_vector(dut_ts_view_y));
                check_port("ts_view_z", expected(latency)(80 downto 62),
                    std_logic_vector(dut_ts_view_z));
                check_port("ts_light0_x", expected(latency)(61 downto 43),
                    std_logic_vector(dut_ts_light0_x));
                check_port("ts_light0_y", expected(latency)(42 downto 24),
                    std_logic_vector(dut_ts_light0_y));
                check_port("ts_light0_z", expected(latency)(23 downto 5),
                    std_logic_vector(dut_ts_light0_z));
                check_port("mirrored", expected(latency)(4 downto 4),
                    std_logic_vector(dut_mirrored));
                check_port("degenerate", expected(latency)(3 downto 3),
                    std_logic_vector(dut_degenerate));
                check_port("zero_uv", expected(latency)(2 downto 2),
                    std_logic_vector(dut_zero_uv));
                check_port("zero_area", expected(latency)(1 downto 1),
                    std_logic_vector(dut_zero_area));
                check_port("parallel", expected(latency)(0 downto 0),
                    std_logic_vector(dut_parallel));
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
                        expected(0)(277 downto 259) := next_t_x;
                        expected(0)(258 downto 240) := next_t_y;
                        expected(0)(239 downto 221) := next_t_z;
                        expected(0)(220 downto 203) := next_b_x;
                        expected(0)(202 downto 185) := next_b_y;
                        expected(0)(184 downto 167) := next_b_z;
                        expected(0)(166 downto 151) := next_n_x;
                        expected(0)(150 downto 135) := next_n_y;
                        expected(0)(134 downto 119) := next_n_z;
                        expected(0)(118 downto 100) := next_ts_view_x;
                        expected(0)(99 downto 81) := next_ts_view_y;
                        expected(0)(80 downto 62) := next_ts_view_z;
                        expected(0)(61 downto 43) := next_ts_light0_x;
                        expected(0)(42 downto 24) := next_ts_light0_y;
                        expected(0)(23 downto 5) := next_ts_light0_z;
                        expected(0)(4 downto 4) := next_mirrored;
                        expected(0)(3 downto 3) := next_degenerate;
                        expected(0)(2 downto 2) := next_zero_uv;
                        expected(0)(1 downto 1) := next_zero_area;
                        expected(0)(0 downto 0) := next_parallel;
                        number(0) := sent;
                        sent := sent + 1;
                        if stalls and sent = 338 then
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
                    dut_normal_x <= signed(next_normal_x);
                    dut_normal_y <= signed(next_normal_y);
                    dut_normal_z <= signed(next_normal_z);
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
                    dut_normal_x <= signed(not next_normal_x);
                    dut_normal_y <= signed(not next_normal_y);
                    dut_normal_z <= signed(not next_normal_z);
                    dut_view_x <= signed(not next_view_x);
                    dut_view_y <= signed(not next_view_y);
                    dut_view_z <= signed(not next_view_z);
                    dut_light0_x <= signed(not next_light0_x);
                    dut_light0_y <= signed(not next_light0_y);
                    dut_light0_z <= signed(not next_light0_z);
                end if;
            end if;
            -- A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if stalls and not reset_done and sent = 338 / 2 then
                rst <= '1';
                ce <= '0';
                reset_done := true;
            end if;
        end procedure;

        procedure finish is
        begin
            if passed /= count then
                print("mismatch: tangent_vectors.txt holds " & to_string(passed)
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
