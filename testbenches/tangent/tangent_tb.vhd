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
--   t_angle: mean 7.20e-6 rad, at most 2.61e-5 rad at p0_x=15251 p0_y=15350 p0_z=-6403 p1_x=15202 p1_y=15167 p1_z=-6192 p2_x=15071 p2_y=15193 p2_z=-6395 uv0_u=-14197 uv0_v=2970 uv1_u=-14234 uv1_v=2895 uv2_u=-14159 uv2_v=2919 normal_x=13003 normal_y=-8017 normal_z=-5922 view_x=3191 view_y=1774 view_z=2175 light0_x=5283 light0_y=93 light0_z=-17561
--   t_dot: mean 1.00e-5, at most 2.89e-5 at p0_x=-11645 p0_y=-1904 p0_z=-1750 p1_x=-10734 p1_y=-2165 p1_z=1162 p2_x=-12461 p2_y=-1923 p2_z=2024 uv0_u=-12788 uv0_v=-12303 uv1_u=-14365 uv1_v=-11692 uv2_u=-12027 uv2_v=-12366 normal_x=2519 normal_y=-14322 normal_z=-7549 view_x=10096 view_y=-7492 view_z=4658 light0_x=-25446 light0_y=15390 light0_z=-2513
--   t_x: mean 5.07e-6, at most 2.61e-5 (1.7 ulp) at p0_x=12681 p0_y=-8661 p0_z=-15254 p1_x=12614 p1_y=-8534 p1_z=-15195 p2_x=13049 p2_y=-8362 p2_z=-15304 uv0_u=-8544 uv0_v=-10722 uv1_u=-8575 uv1_v=-10547 uv2_u=-8420 uv2_v=-10593 normal_x=4752 normal_y=6631 normal_z=-14209 view_x=16853 view_y=4556 view_z=-27578 light0_x=6275 light0_y=6184 light0_z=-12687
--   t_y: mean 5.08e-6, at most 2.39e-5 (1.6 ulp) at p0_x=-11471 p0_y=-17164 p0_z=-702 p1_x=-8731 p1_y=-15121 p1_z=-7650 p2_x=-9498 p2_y=-8321 p2_z=-2970 uv0_u=-5467 uv0_v=-12849 uv1_u=-4684 uv1_v=-17230 uv2_u=-2813 uv2_v=-14893 normal_x=15224 normal_y=-215 normal_z=6051 view_x=-1465 view_y=-15077 view_z=8659 light0_x=6548 light0_y=2005 light0_z=-3929
--   t_z: mean 5.06e-6, at most 2.75e-5 (1.8 ulp) at p0_x=-1067 p0_y=-14384 p0_z=-9320 p1_x=-805 p1_y=-12796 p1_z=-9715 p2_x=177 p2_y=-14033 p2_z=-10866 uv0_u=-9028 uv0_v=-49 uv1_u=-9189 uv1_v=-1 uv2_u=-8820 uv2_v=-231 normal_x=-8534 normal_y=-13930 normal_z=1246 view_x=12601 view_y=-23369 view_z=15762 light0_x=9132 light0_y=1134 light0_z=-151
--   b_angle: mean 6.60e-6 rad, at most 1.93e-5 rad at p0_x=-6919 p0_y=5377 p0_z=-5858 p1_x=-8850 p1_y=7130 p1_z=495 p2_x=-10113 p2_y=12436 p2_z=-5383 uv0_u=8061 uv0_v=477 uv1_u=7764 uv1_v=325 uv2_u=8232 uv2_v=-291 normal_x=6756 normal_y=179 normal_z=-14925 view_x=-1906 view_y=5654 view_z=1238 light0_x=12021 light0_y=19 light0_z=-2035
--   b_dot: mean 8.71e-6, at most 2.35e-5 at p0_x=1541 p0_y=-7123 p0_z=-12331 p1_x=1004 p1_y=-8444 p1_z=-17402 p2_x=6829 p2_y=-19739 p2_z=-17228 uv0_u=11018 uv0_v=14438 uv1_u=11543 uv1_v=14117 uv2_u=11489 uv2_v=13525 normal_x=1690 normal_y=-4795 normal_z=-15575 view_x=3186 view_y=-1039 view_z=-8986 light0_x=9491 light0_y=2629 light0_z=-625
--   b_x: mean 4.44e-6, at most 2.09e-5 (1.4 ulp) at p0_x=16287 p0_y=5533 p0_z=-954 p1_x=16127 p1_y=6048 p1_z=-768 p2_x=16438 p2_y=6155 p2_z=-787 uv0_u=-2207 uv0_v=-10990 uv1_u=-2172 uv1_v=-11023 uv2_u=-2218 uv2_v=-10876 normal_x=2627 normal_y=-13556 normal_z=8818 view_x=-5248 view_y=2691 view_z=-1368 light0_x=2107 light0_y=-206 light0_z=-9224
--   b_y: mean 4.44e-6, at most 2.09e-5 (1.4 ulp) at p0_x=-13793 p0_y=13124 p0_z=-2804 p1_x=-14470 p1_y=13425 p1_z=-2866 p2_x=-14148 p2_y=14455 p2_z=-2185 uv0_u=5808 uv0_v=-12907 uv1_u=6001 uv1_v=-13048 uv2_u=5630 uv2_v=-13325 normal_x=-8483 normal_y=-3604 normal_z=13545 view_x=4479 view_y=5388 view_z=-5064 light0_x=-12346 light0_y=6630 light0_z=-4037
--   b_z: mean 4.40e-6, at most 1.95e-5 (1.3 ulp) at p0_x=14455 p0_y=-2094 p0_z=14638 p1_x=15049 p1_y=-4373 p1_z=11625 p2_x=16897 p2_y=859 p2_z=13234 uv0_u=6478 uv0_v=-2254 uv1_u=7324 uv1_v=-4274 uv2_u=7925 uv2_v=-3433 normal_x=8753 normal_y=-13318 normal_z=3803 view_x=-1720 view_y=3429 view_z=-2002 light0_x=5654 light0_y=1873 light0_z=-2627
--   n_angle: mean 0.00e0 rad, at most 0.00e0 rad at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   n_dot: mean 0.00e0, at most 0.00e0 at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   n_x: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   n_y: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   n_z: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   ts_view_angle: mean 3.91e-5 rad, at most 1.99e-4 rad at p0_x=10316 p0_y=-88 p0_z=-13168 p1_x=11289 p1_y=437 p1_z=-13060 p2_x=10298 p2_y=283 p2_z=-13400 uv0_u=-11949 uv0_v=9482 uv1_u=-12564 uv1_v=9517 uv2_u=-12349 uv2_v=9023 normal_x=-3665 normal_y=-11157 normal_z=11425 view_x=-3378 view_y=-1982 view_z=1539 light0_x=7729 light0_y=-23991 light0_z=-2023
--   ts_view_dot: mean 3.02e-5, at most 7.21e-5 at p0_x=15351 p0_y=11547 p0_z=-1801 p1_x=15661 p1_y=10361 p1_z=-1891 p2_x=15019 p2_y=11851 p2_z=-1061 uv0_u=2653 uv0_v=10234 uv1_u=1447 uv1_v=8903 uv2_u=4032 uv2_v=10091 normal_x=9129 normal_y=9722 normal_z=9517 view_x=-10556 view_y=-3247 view_z=29053 light0_x=6853 light0_y=-17037 light0_z=-628
--   ts_view_x: mean 1.59e-5, at most 6.25e-5 (1.0 ulp) at p0_x=5938 p0_y=4965 p0_z=13846 p1_x=5959 p1_y=4798 p1_z=13561 p2_x=6117 p2_y=4895 p2_z=13497 uv0_u=14829 uv0_v=10601 uv1_u=14843 uv1_v=10549 uv2_u=14823 uv2_v=10606 normal_x=12302 normal_y=-10805 normal_z=587 view_x=-19254 view_y=-15667 view_z=-20847 light0_x=-1743 light0_y=6036 light0_z=13969
--   ts_view_y: mean 1.57e-5, at most 5.67e-5 (0.9 ulp) at p0_x=1195 p0_y=5238 p0_z=-7651 p1_x=1455 p1_y=5417 p1_z=-7765 p2_x=1354 p2_y=5125 p2_z=-7600 uv0_u=-5965 uv0_v=13919 uv1_u=-8415 uv1_v=9980 uv2_u=1311 uv2_v=5511 normal_x=-10544 normal_y=-12520 normal_z=706 view_x=-24812 view_y=17315 view_z=323 light0_x=3543 light0_y=1735 light0_z=3617
--   ts_view_z: mean 1.53e-5, at most 3.05e-5 (0.5 ulp) at p0_x=-10953 p0_y=-12463 p0_z=9164 p1_x=-9156 p1_y=-12517 p1_z=8895 p2_x=-9982 p2_y=-14189 p2_z=12694 uv0_u=1910 uv0_v=11098 uv1_u=1883 uv1_v=12080 uv2_u=1085 uv2_v=12118 normal_x=-1969 normal_y=2018 normal_z=-16140 view_x=-7442 view_y=7163 view_z=-2090 light0_x=3157 light0_y=2999 light0_z=2991
--   ts_light0_angle: mean 3.91e-5 rad, at most 1.91e-4 rad at p0_x=-2293 p0_y=-1363 p0_z=15880 p1_x=-2194 p1_y=-1247 p1_z=15794 p2_x=-2278 p2_y=-1371 p2_z=15927 uv0_u=-1905 uv0_v=-16550 uv1_u=-4916 uv1_v=-15260 uv2_u=4251 uv2_v=-17072 normal_x=13444 normal_y=-5901 normal_z=-7273 view_x=-3580 view_y=-6171 view_z=1568 light0_x=1575 light0_y=-3015 light0_z=-2314
--   ts_light0_dot: mean 3.01e-5, at most 7.40e-5 at p0_x=14762 p0_y=-16010 p0_z=-9702 p1_x=13195 p1_y=-17641 p1_z=-8977 p2_x=13142 p2_y=-14778 p2_z=-6780 uv0_u=4435 uv0_v=10615 uv1_u=4537 uv1_v=10551 uv2_u=4652 uv2_v=10696 normal_x=11187 normal_y=11101 normal_z=4477 view_x=2633 view_y=14256 view_z=938 light0_x=1616 light0_y=16721 light0_z=-26234
--   ts_light0_x: mean 1.59e-5, at most 6.74e-5 (1.1 ulp) at p0_x=14762 p0_y=-16010 p0_z=-9702 p1_x=13195 p1_y=-17641 p1_z=-8977 p2_x=13142 p2_y=-14778 p2_z=-6780 uv0_u=4435 uv0_v=10615 uv1_u=4537 uv1_v=10551 uv2_u=4652 uv2_v=10696 normal_x=11187 normal_y=11101 normal_z=4477 view_x=2633 view_y=14256 view_z=938 light0_x=1616 light0_y=16721 light0_z=-26234
--   ts_light0_y: mean 1.56e-5, at most 5.44e-5 (0.9 ulp) at p0_x=-15148 p0_y=-14335 p0_z=5446 p1_x=-14046 p1_y=-16501 p1_z=6128 p2_x=-14672 p2_y=-14087 p2_z=7534 uv0_u=-18615 uv0_v=15600 uv1_u=-26400 uv1_v=2958 uv2_u=-5648 uv2_v=-2428 normal_x=6096 normal_y=11001 normal_z=10500 view_x=-5487 view_y=-3316 view_z=1969 light0_x=-31632 light0_y=-1147 light0_z=3780
--   ts_light0_z: mean 1.52e-5, at most 3.05e-5 (0.5 ulp) at p0_x=-669 p0_y=7292 p0_z=-12617 p1_x=-931 p1_y=6940 p1_z=-13091 p2_x=-1145 p2_y=6951 p2_z=-12930 uv0_u=-9957 uv0_v=9973 uv1_u=-7782 uv1_v=14959 uv2_u=-10903 uv2_v=14627 normal_x=-631 normal_y=-15129 normal_z=-6258 view_x=-2433 view_y=1277 view_z=4973 light0_x=-3600 light0_y=530 light0_z=9359
--   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
--   parallel: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
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
