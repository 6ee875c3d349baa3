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
--   t_angle: mean 7.21e-6 rad, largest seen 2.54e-5 rad at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
--   t_dot: mean 1.01e-5, largest seen 3.06e-5 at p0_x=6054 p0_y=-8713 p0_z=-8201 p1_x=6085 p1_y=-8615 p1_z=-7909 p2_x=5792 p2_y=-8522 p2_z=-8101 uv0_u=4564 uv0_v=5160 uv1_u=2779 uv1_v=4462 uv2_u=3578 uv2_v=3905 normal_x=12043 normal_y=-10167 normal_z=4476 view_x=2660 view_y=-1823 view_z=-11081 light0_x=8046 light0_y=-6155 light0_z=-4370
--   t_x: mean 5.06e-6, largest seen 2.58e-5 (1.7 ulp) at p0_x=-2944 p0_y=-2889 p0_z=-15380 p1_x=-1989 p1_y=-3042 p1_z=-15024 p2_x=35 p2_y=-907 p2_z=-15910 uv0_u=7874 uv0_v=-4729 uv1_u=7659 uv1_v=-5304 uv2_u=7814 uv2_v=-4572 normal_x=-5414 normal_y=14396 normal_z=-5646 view_x=-6397 view_y=-7256 view_z=184 light0_x=9737 light0_y=-6526 light0_z=-23310
--   t_y: mean 5.08e-6, largest seen 2.63e-5 (1.7 ulp) at p0_x=-5717 p0_y=-7520 p0_z=6199 p1_x=-6348 p1_y=-7947 p1_z=6354 p2_x=-5905 p2_y=-7260 p2_z=6487 uv0_u=-5576 uv0_v=-14859 uv1_u=-5475 uv1_v=-15100 uv2_u=-5440 uv2_v=-15020 normal_x=10034 normal_y=-493 normal_z=12942 view_x=13000 view_y=-2147 view_z=4664 light0_x=2385 light0_y=2146 light0_z=-3481
--   t_z: mean 5.08e-6, largest seen 2.65e-5 (1.7 ulp) at p0_x=11563 p0_y=11423 p0_z=-13723 p1_x=11421 p1_y=11299 p1_z=-13637 p2_x=11555 p2_y=11375 p2_z=-13787 uv0_u=-8499 uv0_v=13103 uv1_u=-7478 uv1_v=7491 uv2_u=-5140 uv2_v=11461 normal_x=-15164 normal_y=-4331 normal_z=-4443 view_x=-8107 view_y=1299 view_z=-3290 light0_x=-3604 light0_y=-1965 light0_z=440
--   b_angle: mean 6.61e-6 rad, largest seen 2.02e-5 rad at p0_x=21760 p0_y=-8046 p0_z=-19764 p1_x=14314 p1_y=-6846 p1_z=-24032 p2_x=12189 p2_y=-1901 p2_z=-15526 uv0_u=-22738 uv0_v=-3849 uv1_u=-23752 uv1_v=1069 uv2_u=-9213 uv2_v=2636 normal_x=-12722 normal_y=-9837 normal_z=-3133 view_x=9645 view_y=-6931 view_z=4827 light0_x=9603 light0_y=-8865 light0_z=-8833
--   b_dot: mean 8.71e-6, largest seen 2.37e-5 at p0_x=5680 p0_y=11679 p0_z=-9279 p1_x=5746 p1_y=11714 p1_z=-9304 p2_x=5771 p2_y=11695 p2_z=-9339 uv0_u=10373 uv0_v=-9936 uv1_u=10462 uv1_v=-9889 uv2_u=10455 uv2_v=-9822 normal_x=-13791 normal_y=8267 normal_z=-3145 view_x=4674 view_y=15361 view_z=-4755 light0_x=19009 light0_y=22102 light0_z=-24134
--   b_x: mean 4.44e-6, largest seen 1.88e-5 (1.2 ulp) at p0_x=-1736 p0_y=11116 p0_z=-16007 p1_x=-158 p1_y=11485 p1_z=-16948 p2_x=-1615 p2_y=13286 p2_z=-16701 uv0_u=1006 uv0_v=13794 uv1_u=1018 uv1_v=13841 uv2_u=1173 uv2_v=13774 normal_x=2071 normal_y=16139 normal_z=1917 view_x=1686 view_y=4755 view_z=-5926 light0_x=-2682 light0_y=5065 light0_z=3979
--   b_y: mean 4.43e-6, largest seen 2.10e-5 (1.4 ulp) at p0_x=16361 p0_y=11747 p0_z=-5803 p1_x=17315 p1_y=13651 p1_z=-4641 p2_x=13325 p2_y=13955 p2_z=-4680 uv0_u=-5823 uv0_v=-9319 uv1_u=-5674 uv1_v=-9605 uv2_u=-5470 uv2_v=-9514 normal_x=-222 normal_y=-9338 normal_z=-13460 view_x=16239 view_y=-23962 view_z=-7113 light0_x=-1942 light0_y=2415 light0_z=-9419
--   b_z: mean 4.44e-6, largest seen 1.95e-5 (1.3 ulp) at p0_x=-11834 p0_y=478 p0_z=2468 p1_x=-12147 p1_y=607 p1_z=2446 p2_x=-11996 p2_y=633 p2_z=2585 uv0_u=14968 uv0_v=4654 uv1_u=15202 uv1_v=4821 uv2_u=14888 uv2_v=4438 normal_x=6949 normal_y=-14815 normal_z=819 view_x=1968 view_y=-7156 view_z=-750 light0_x=-14564 light0_y=-2007 light0_z=1544
--   n_angle: mean 0.00e0 rad, largest seen 0.00e0 rad at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   n_dot: mean 0.00e0, largest seen 0.00e0 at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   n_x: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   n_y: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   n_z: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   ts_view_angle: mean 4.65e-5 rad, largest seen 1.84e-3 rad at p0_x=-9855 p0_y=-11563 p0_z=4028 p1_x=-14143 p1_y=-4409 p1_z=482 p2_x=-8004 p2_y=7008 p2_z=-4249 uv0_u=-4218 uv0_v=9266 uv1_u=-4223 uv1_v=9363 uv2_u=-4208 uv2_v=9267 normal_x=-15042 normal_y=-4819 normal_z=-4353 view_x=72 view_y=-168 view_z=98 light0_x=2154 light0_y=-1130 light0_z=-105
--   ts_view_dot: mean 3.01e-5, largest seen 9.03e-5 at p0_x=6141 p0_y=-13767 p0_z=-7992 p1_x=6118 p1_y=-13719 p1_z=-7838 p2_x=6123 p2_y=-13790 p2_z=-7826 uv0_u=7545 uv0_v=-11434 uv1_u=7546 uv1_v=-10295 uv2_u=6797 uv2_v=-11328 normal_x=-403 normal_y=-14238 normal_z=8096 view_x=16190 view_y=26021 view_z=27329 light0_x=-4445 light0_y=5173 light0_z=5980
--   ts_view_x: mean 1.58e-5, largest seen 7.72e-5 (1.3 ulp) at p0_x=-9548 p0_y=7900 p0_z=-11270 p1_x=-9660 p1_y=7935 p1_z=-11194 p2_x=-9357 p2_y=7961 p2_z=-11076 uv0_u=-11107 uv0_v=12419 uv1_u=-11523 uv1_v=11905 uv2_u=-10978 uv2_v=12656 normal_x=-5642 normal_y=12921 normal_z=-8346 view_x=23883 view_y=22119 view_z=16603 light0_x=6062 light0_y=11713 light0_z=2836
--   ts_view_y: mean 1.57e-5, largest seen 6.24e-5 (1.0 ulp) at p0_x=15652 p0_y=10540 p0_z=7166 p1_x=15633 p1_y=10607 p1_z=7228 p2_x=15553 p2_y=10667 p2_z=7290 uv0_u=-1788 uv0_v=-6270 uv1_u=-322 uv1_v=-6844 uv2_u=-1575 uv2_v=-7200 normal_x=-1833 normal_y=16240 normal_z=1159 view_x=-29460 view_y=31001 view_z=3770 light0_x=6127 light0_y=-7450 light0_z=7013
--   ts_view_z: mean 1.52e-5, largest seen 3.05e-5 (0.5 ulp) at p0_x=-302 p0_y=1691 p0_z=-6673 p1_x=-221 p1_y=1773 p1_z=-6705 p2_x=-254 p2_y=1753 p2_z=-6603 uv0_u=7868 uv0_v=821 uv1_u=8711 uv1_v=2841 uv2_u=6860 uv2_v=2720 normal_x=-10163 normal_y=-7193 normal_z=10649 view_x=4532 view_y=-9269 view_z=10375 light0_x=-2930 light0_y=-241 light0_z=2769
--   ts_light0_angle: mean 4.66e-5 rad, largest seen 2.30e-3 rad at p0_x=1272 p0_y=-15486 p0_z=-8368 p1_x=1233 p1_y=-15508 p1_z=-8439 p2_x=1008 p2_y=-15725 p2_z=-7973 uv0_u=-15400 uv0_v=3547 uv1_u=-15342 uv1_v=3546 uv2_u=-15427 uv2_v=3464 normal_x=-13112 normal_y=6323 normal_z=-7519 view_x=12551 view_y=19257 view_z=19235 light0_x=171 light0_y=29 light0_z=72
--   ts_light0_dot: mean 3.01e-5, largest seen 8.52e-5 at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
--   ts_light0_x: mean 1.58e-5, largest seen 7.53e-5 (1.2 ulp) at p0_x=4623 p0_y=93 p0_z=-11681 p1_x=1115 p1_y=2879 p1_z=-11038 p2_x=-2614 p2_y=-2532 p2_z=-6132 uv0_u=4801 uv0_v=7643 uv1_u=4785 uv1_v=7656 uv2_u=4827 uv2_v=7658 normal_x=-9446 normal_y=5706 normal_z=-12110 view_x=6001 view_y=15627 view_z=-16959 light0_x=25729 light0_y=-15361 light0_z=-23275
--   ts_light0_y: mean 1.57e-5, largest seen 6.57e-5 (1.1 ulp) at p0_x=15543 p0_y=13758 p0_z=-4075 p1_x=14753 p1_y=14130 p1_z=-3927 p2_x=15086 p2_y=13483 p2_z=-3280 uv0_u=-1025 uv0_v=12037 uv1_u=1063 uv1_v=12449 uv2_u=-1376 uv2_v=6924 normal_x=-3845 normal_y=-15786 normal_z=2110 view_x=-2307 view_y=-1803 view_z=2775 light0_x=-13005 light0_y=25943 light0_z=-29219
--   ts_light0_z: mean 1.52e-5, largest seen 3.05e-5 (0.5 ulp) at p0_x=12149 p0_y=11346 p0_z=-31 p1_x=12282 p1_y=11313 p1_z=-4 p2_x=12253 p2_y=11302 p2_z=-166 uv0_u=-16266 uv0_v=8823 uv1_u=-11398 uv1_v=9264 uv2_u=-14519 uv2_v=5465 normal_x=-2913 normal_y=-16026 normal_z=1769 view_x=-3200 view_y=-5150 view_z=-2933 light0_x=3519 light0_y=12209 light0_z=-5007
--   mirrored: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   zero_uv: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   zero_area: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   parallel: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
-- stated bound on each tangent: 2.12e-4
-- stated bound on each binormal: 5.74e-5
-- stated bound on each normal: 0.00e0
-- stated bound on each view: 8.14e-4
-- stated bound on each light0: 8.14e-4
-- stated bound on each flags: 0.00e0
--
-- Self-checking testbench of tangent. It reads tangent_vectors.txt: per line the words of the
-- inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
-- one a cycle; then, after a reset in mid-stream, the first 344 go again with stalls and
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
        constant count : natural := 344;
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
                        if stalls and sent = 344 then
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
            if stalls and not reset_done and sent = 344 / 2 then
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
