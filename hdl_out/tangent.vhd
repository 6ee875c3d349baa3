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
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tangent is
    port (
        clk : in std_logic;
        rst : in std_logic; -- clears the valid bits
        ce : in std_logic; -- the pipeline stands still without
        valid_in : in std_logic;
        p0_x : in signed(15 downto 0); -- s16f11
        p0_y : in signed(15 downto 0); -- s16f11
        p0_z : in signed(15 downto 0); -- s16f11
        p1_x : in signed(15 downto 0); -- s16f11
        p1_y : in signed(15 downto 0); -- s16f11
        p1_z : in signed(15 downto 0); -- s16f11
        p2_x : in signed(15 downto 0); -- s16f11
        p2_y : in signed(15 downto 0); -- s16f11
        p2_z : in signed(15 downto 0); -- s16f11
        uv0_u : in signed(15 downto 0); -- s16f13
        uv0_v : in signed(15 downto 0); -- s16f13
        uv1_u : in signed(15 downto 0); -- s16f13
        uv1_v : in signed(15 downto 0); -- s16f13
        uv2_u : in signed(15 downto 0); -- s16f13
        uv2_v : in signed(15 downto 0); -- s16f13
        normal_x : in signed(15 downto 0); -- s16f14
        normal_y : in signed(15 downto 0); -- s16f14
        normal_z : in signed(15 downto 0); -- s16f14
        view_x : in signed(15 downto 0); -- s16f14
        view_y : in signed(15 downto 0); -- s16f14
        view_z : in signed(15 downto 0); -- s16f14
        light0_x : in signed(15 downto 0); -- s16f14
        light0_y : in signed(15 downto 0); -- s16f14
        light0_z : in signed(15 downto 0); -- s16f14
        valid_out : out std_logic;
        t_x : out signed(18 downto 0) := (others => '0'); -- s19f16
        t_y : out signed(18 downto 0) := (others => '0'); -- s19f16
        t_z : out signed(18 downto 0) := (others => '0'); -- s19f16
        b_x : out signed(17 downto 0) := (others => '0'); -- s18f16
        b_y : out signed(17 downto 0) := (others => '0'); -- s18f16
        b_z : out signed(17 downto 0) := (others => '0'); -- s18f16
        n_x : out signed(15 downto 0) := (others => '0'); -- s16f14
        n_y : out signed(15 downto 0) := (others => '0'); -- s16f14
        n_z : out signed(15 downto 0) := (others => '0'); -- s16f14
        ts_view_x : out signed(18 downto 0) := (others => '0'); -- s19f14
        ts_view_y : out signed(18 downto 0) := (others => '0'); -- s19f14
        ts_view_z : out signed(18 downto 0) := (others => '0'); -- s19f14
        ts_light0_x : out signed(18 downto 0) := (others => '0'); -- s19f14
        ts_light0_y : out signed(18 downto 0) := (others => '0'); -- s19f14
        ts_light0_z : out signed(18 downto 0) := (others => '0'); -- s19f14
        mirrored : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        degenerate : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        zero_uv : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        zero_area : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        parallel : out unsigned(0 downto 0) := (others => '0') -- u1f0
    );
end entity;

architecture rtl of tangent is
    attribute rom_style : string;

    -- table recip_root: recip_sqrt_base u23f22, recip_sqrt_slope s17f34
    type recip_root_rom_rows is array (0 to 255) of unsigned(39 downto 0);
    constant recip_root_rom : recip_root_rom_rows := (
        40x"ffff4502f6", 40x"fe053908bc", 40x"fc16b70e4a", 40x"fa335113a5",
        40x"f85aa118cd", 40x"f68c411dc6", 40x"f4c7d12291", 40x"f30cf92733",
        40x"f15b632bab", 40x"efb2bd2ffd", 40x"ee12bb3429", 40x"ec7b133833",
        40x"eaeb7b3c1a", 40x"e963b33fe2", 40x"e7e37b438b", 40x"e66a934716",
        40x"e4f8c34a85", 40x"e38dd14dda", 40x"e229875115", 40x"e0cbb35437",
        40x"df74235741", 40x"de22a95a35", 40x"dcd7155d13", 40x"db913b5fdc",
        40x"da50f76290", 40x"d916196532", 40x"d7e07f67c1", 40x"d6b0036a3e",
        40x"d584836caa", 40x"d45dd96f06", 40x"d33be77151", 40x"d21e8b738e",
        40x"d105a775bb", 40x"cff11f77da", 40x"cee0d579ec", 40x"cdd4af7bf0",
        40x"cccc8f7de7", 40x"cbc85f7fd2", 40x"cac80581b1", 40x"c9cb698385",
        40x"c8d273854d", 40x"c7dd0f870b", 40x"c6eb2588be", 40x"c5fca18a67",
        40x"c511718c06", 40x"c4297d8d9c", 40x"c344b78f28", 40x"c2630990ac",
        40x"c184619227", 40x"c0a8b1939a", 40x"bfcfe79505", 40x"bef9f19668",
        40x"be26c197c3", 40x"bd56499917", 40x"bc88779a64", 40x"bbbd3f9baa",
        40x"baf4939ce9", 40x"ba2e679e21", 40x"b96aa99f53", 40x"b8a951a07f",
        40x"b7ea51a1a5", 40x"b72d9ba2c6", 40x"b67327a3e0", 40x"b5bae9a4f5",
        40x"b504d3a604", 40x"b450dba70f", 40x"b39efba814", 40x"b2ef23a914",
        40x"b2414baa10", 40x"b1956bab06", 40x"b0eb79abf9", 40x"b0436bace6",
        40x"af9d37add0", 40x"aef8d7aeb5", 40x"ae5641af96", 40x"adb56db073",
        40x"ad1653b14c", 40x"ac78ebb221", 40x"abdd2db2f2", 40x"ab4313b3c0",
        40x"aaaa93b48a", 40x"aa13a9b551", 40x"a97e4bb615", 40x"a8ea75b6d5",
        40x"a8581fb792", 40x"a7c743b84b", 40x"a737dbb902", 40x"a6a9dfb9b6",
        40x"a61d4bba66", 40x"a59219bb14", 40x"a50841bbbf", 40x"a47fbfbc68",
        40x"a3f88fbd0d", 40x"a372a9bdb0", 40x"a2ee09be51", 40x"a26aadbeee",
        40x"a1e889bf8a", 40x"a1679dc023", 40x"a0e7e3c0ba", 40x"a06957c14e",
        40x"9febf3c1e0", 40x"9f6fb3c270", 40x"9ef493c2fe", 40x"9e7a8fc389",
        40x"9e01a3c413", 40x"9d89c9c49b", 40x"9d12ffc520", 40x"9c9d3fc5a4",
        40x"9c2887c626", 40x"9bb4d3c6a5", 40x"9b421dc723", 40x"9ad063c7a0",
        40x"9a5fa3c81a", 40x"99efd9c893", 40x"9980ffc90a", 40x"991313c97f",
        40x"98a611c9f3", 40x"9839f9ca65", 40x"97cec3cad6", 40x"97646fcb45",
        40x"96faf9cbb3", 40x"96925fcc1f", 40x"962a9dcc8a", 40x"95c3b1ccf3",
        40x"955d95cd5b", 40x"94f84bcdc1", 40x"9493cfce26", 40x"94301bce8a",
        40x"93cd2fceed", 40x"936b09cf4e", 40x"9309a5cfae", 40x"92a901d00d",
        40x"92491bd06a", 40x"91e9efd0c7", 40x"918b7dd122", 40x"912dc1d17c",
        40x"90d0b9d1d5", 40x"907463d22d", 40x"9018bdd284", 40x"8fbdc5d2d9",
        40x"8f6377d32e", 40x"8f09d3d382", 40x"8eb0d7d3d4", 40x"8e587fd426",
        40x"8e00cbd477", 40x"8da9bbd4c6", 40x"8d5347d515", 40x"8cfd71d563",
        40x"8ca837d5b0", 40x"8c5397d5fc", 40x"8bff8fd647", 40x"8bac1dd691",
        40x"8b593fd6db", 40x"8b06f5d723", 40x"8ab53bd76b", 40x"8a6411d7b2",
        40x"8a1375d7f8", 40x"89c367d83d", 40x"8973e1d882", 40x"8924e5d8c6",
        40x"88d66fd909", 40x"888881d94b", 40x"883b17d98d", 40x"87ee31d9cd",
        40x"87a1cbda0d", 40x"8755e7da4d", 40x"870a7fda8c", 40x"86bf97daca",
        40x"86752bdb07", 40x"862b39db44", 40x"85e1c1db80", 40x"8598c1dbbb",
        40x"855037dbf6", 40x"850825dc30", 40x"84c085dc6a", 40x"847959dca3",
        40x"84329fdcdb", 40x"83ec57dd13", 40x"83a67ddd4a", 40x"836111dd81",
        40x"831c15ddb7", 40x"82d783dded", 40x"82935dde22", 40x"824fa1de56",
        40x"820c4dde8a", 40x"81c961debe", 40x"8186dddef1", 40x"8144bfdf23",
        40x"810305df55", 40x"80c1afdf86", 40x"8080bddfb7", 40x"80402bdfe8",
        40x"7ffffbe018", 40x"7fc02be047", 40x"7f80b9e077", 40x"7f41a7e0a5",
        40x"7f02f1e0d3", 40x"7ec499e101", 40x"7e869be12e", 40x"7e48f7e15b",
        40x"7e0bade188", 40x"7dcebde1b4", 40x"7d9225e1df", 40x"7d55e3e20b",
        40x"7d19f9e235", 40x"7cde63e260", 40x"7ca323e28a", 40x"7c6837e2b3",
        40x"7c2d9de2dd", 40x"7bf357e306", 40x"7bb961e32e", 40x"7b7fbde356",
        40x"7b4669e37e", 40x"7b0d67e3a5", 40x"7ad4b1e3cc", 40x"7a9c49e3f3",
        40x"7a6431e419", 40x"7a2c63e440", 40x"79f4e1e465", 40x"79bdabe48b",
        40x"7986c1e4b0", 40x"795021e4d4", 40x"7919c9e4f9", 40x"78e3bbe51d",
        40x"78adf3e541", 40x"787875e564", 40x"78433de587", 40x"780e4be5aa",
        40x"77d99fe5cc", 40x"77a537e5ef", 40x"777115e611", 40x"773d37e632",
        40x"77099be654", 40x"76d643e675", 40x"76a32de696", 40x"767059e6b6",
        40x"763dc5e6d7", 40x"760b73e6f7", 40x"75d95fe716", 40x"75a78be736",
        40x"7575f7e755", 40x"7544a1e774", 40x"751389e793", 40x"74e2afe7b1",
        40x"74b213e7cf", 40x"7481b1e7ed", 40x"74518de80b", 40x"7421a3e829",
        40x"73f1f3e846", 40x"73c27fe863", 40x"739345e880", 40x"736447e89c",
        40x"73357fe8b9", 40x"7306f1e8d5", 40x"72d899e8f1", 40x"72aa7be90d"
    );
    attribute rom_style of recip_root_rom : constant is "block";

    -- Words start at zero: numeric_std would warn of what it compares or looks up before.
    -- Valid bits don't, so that one that a reset misses shows as unknown.
    -- stage 0
    signal primitive_e1_x : signed(16 downto 0) := (others => '0'); -- s17f11
    signal primitive_e1_y : signed(16 downto 0) := (others => '0'); -- s17f11
    signal primitive_e1_z : signed(16 downto 0) := (others => '0'); -- s17f11
    signal primitive_e2_x : signed(16 downto 0) := (others => '0'); -- s17f11
    signal primitive_e2_y : signed(16 downto 0) := (others => '0'); -- s17f11
    signal primitive_e2_z : signed(16 downto 0) := (others => '0'); -- s17f11
    signal primitive_du1 : signed(16 downto 0) := (others => '0'); -- s17f13
    signal primitive_dv1 : signed(16 downto 0) := (others => '0'); -- s17f13
    signal primitive_du2 : signed(16 downto 0) := (others => '0'); -- s17f13
    signal primitive_dv2 : signed(16 downto 0) := (others => '0'); -- s17f13
    signal primitive_n34 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n35 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n37 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n40 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n41 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n43 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n44 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n46 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n47 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_e1_cross_e2_n49 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n50 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n52 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n53 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n55 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n56 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal vertex_n63_neg : unsigned(15 downto 0) := (others => '0');
    signal vertex_n63 : unsigned(15 downto 0) := (others => '0'); -- u16f14
    signal vertex_n64_neg : unsigned(15 downto 0) := (others => '0');
    signal vertex_n64 : unsigned(15 downto 0) := (others => '0'); -- u16f14
    signal vertex_along_x : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n66 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal vertex_n67 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_n68 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_n69 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_n70 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal vertex_n71 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_n88 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_n90 : signed(15 downto 0) := (others => '0'); -- s16f38
    signal vertex_n92 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_b_n107 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal vertex_b_n113 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal vertex_b_n119 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal vertex_b_n125 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_n131 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_length_n251 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_length_n266 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal vertex_ts_view_n_n311 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_view_n_n312 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_view_n_n313 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_light0_n_n329 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_light0_n_n330 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_light0_n_n331 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal normal_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_n34_s1 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n35_s1 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n40_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n41_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n43_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n44_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n46_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n47_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_e1_cross_e2_n49_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n50_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n52_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n53_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n55_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n56_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal vertex_n88_s1 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_n90_s1 : signed(15 downto 0) := (others => '0'); -- s16f38
    signal vertex_n92_s1 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_ts_view_n_n311_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_view_n_n312_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_view_n_n313_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_light0_n_n329_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_light0_n_n330_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal vertex_ts_light0_n_n331_s1 : signed(31 downto 0) := (others => '0'); -- s32f28
    signal valid_s1 : std_logic;
    -- stage 1
    signal primitive_det : signed(34 downto 0) := (others => '0'); -- s35f26
    signal primitive_zero_uv : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_det_x : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_det_y : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_det_z : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_e1_cross_e2_n51 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_e1_cross_e2_n54 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_e1_cross_e2_n57 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n58 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n59 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n60 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n61 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n72 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_n_n314 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal vertex_ts_view_n_n315 : signed(33 downto 0) := (others => '0'); -- s34f28
    signal vertex_ts_light0_n_n332 : signed(32 downto 0) := (others => '0'); -- s33f28
    signal vertex_ts_light0_n_n333 : signed(33 downto 0) := (others => '0'); -- s34f28
    signal normal_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_det_x_s2 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_det_y_s2 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_det_z_s2 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_zero_area_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n72_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n88_s2 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_n90_s2 : signed(15 downto 0) := (others => '0'); -- s16f38
    signal vertex_n92_s2 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_ts_view_n_n315_s2 : signed(33 downto 0) := (others => '0'); -- s34f28
    signal vertex_ts_light0_n_n333_s2 : signed(33 downto 0) := (others => '0'); -- s34f28
    signal valid_s2 : std_logic;
    -- stage 2
    signal vertex_n_cross_t_n73 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n74 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n76 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n77 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n79 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n80 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_ts_view_z_sum : signed(34 downto 0) := (others => '0');
    signal vertex_ts_view_z_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_view_z_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_z_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_z : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_sum : signed(34 downto 0) := (others => '0');
    signal vertex_ts_light0_z_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_light0_z_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_z_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_z : signed(18 downto 0) := (others => '0'); -- s19f14
    signal normal_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n72_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n_cross_t_n73_s3 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n74_s3 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n76_s3 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n77_s3 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n79_s3 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n_cross_t_n80_s3 : signed(50 downto 0) := (others => '0'); -- s51f38
    signal vertex_n88_s3 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_n90_s3 : signed(15 downto 0) := (others => '0'); -- s16f38
    signal vertex_n92_s3 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_ts_view_z_s3 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s3 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s3 : std_logic;
    -- stage 3
    signal vertex_n_cross_t_n75 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n_cross_t_n78 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n_cross_t_n81 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n82 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n83 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n84 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n85 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n72_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n_cross_t_n75_s4 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n_cross_t_n78_s4 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n_cross_t_n81_s4 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n84_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n85_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n88_s4 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_n90_s4 : signed(15 downto 0) := (others => '0'); -- s16f38
    signal vertex_n92_s4 : signed(16 downto 0) := (others => '0'); -- s17f38
    signal vertex_ts_view_z_s4 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s4 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s4 : std_logic;
    -- stage 4
    signal vertex_parallel : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n89 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n91 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_n93 : signed(51 downto 0) := (others => '0'); -- s52f38
    signal vertex_b_n94_neg : unsigned(51 downto 0) := (others => '0');
    signal vertex_b_n94 : unsigned(51 downto 0) := (others => '0'); -- u52f38
    signal vertex_b_n95 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n96_neg : unsigned(51 downto 0) := (others => '0');
    signal vertex_b_n96 : unsigned(51 downto 0) := (others => '0'); -- u52f38
    signal vertex_b_n97 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n98_neg : unsigned(51 downto 0) := (others => '0');
    signal vertex_b_n98 : unsigned(51 downto 0) := (others => '0'); -- u52f38
    signal vertex_b_n99 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n100 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n101 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_largest : unsigned(51 downto 0) := (others => '0'); -- u52f38
    signal vertex_b_n103 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n104 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal vertex_b_n106 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal vertex_b_n108 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n141 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n142 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n143 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n145 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal vertex_b_n146 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n170 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n171 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n172 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n173 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal vertex_b_n174 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n193 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n194 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n195 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n196 : unsigned(20 downto 0) := (others => '0'); -- u21f0
    signal vertex_b_n197 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_n288 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n289 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n103_s5 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n104_s5 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal vertex_b_n108_s5 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n143_s5 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n146_s5 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n172_s5 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n174_s5 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n195_s5 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n197_s5 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_n289_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s5 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s5 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s5 : std_logic;
    -- stage 5
    signal vertex_b_n105 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n109 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n110 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal vertex_b_n111 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n112 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal vertex_b_n114 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n115 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n116 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal vertex_b_n117 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n118 : unsigned(43 downto 0) := (others => '0'); -- u44f0
    signal vertex_b_n120 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n136 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_n137 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal normal_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n115_s6 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n117_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n120_s6 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n137_s6 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal vertex_b_n143_s6 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n146_s6 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n172_s6 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n174_s6 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n195_s6 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n197_s6 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_n289_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s6 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s6 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s6 : std_logic;
    -- stage 6
    signal vertex_b_n121 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n122 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_n123 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n124 : unsigned(47 downto 0) := (others => '0'); -- u48f0
    signal vertex_b_n126 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n127 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n128 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_n129 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n130 : unsigned(49 downto 0) := (others => '0'); -- u50f0
    signal vertex_b_n132 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n133 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n134 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n135 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n138 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_n139 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal vertex_b_places : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal vertex_b_n144 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n147 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n148 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n149 : unsigned(36 downto 0) := (others => '0'); -- u37f0
    signal vertex_b_n150 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n151 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n152 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n153 : unsigned(44 downto 0) := (others => '0'); -- u45f0
    signal vertex_b_n154 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n156 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n160 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n164 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n175 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n176 : unsigned(36 downto 0) := (others => '0'); -- u37f0
    signal vertex_b_n177 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n178 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n179 : unsigned(44 downto 0) := (others => '0'); -- u45f0
    signal vertex_b_n180 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n198 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n199 : unsigned(36 downto 0) := (others => '0'); -- u37f0
    signal vertex_b_n200 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n201 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n202 : unsigned(44 downto 0) := (others => '0'); -- u45f0
    signal vertex_b_n203 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal normal_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n151_s7 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n152_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n154_s7 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n156_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n160_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n164_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_n178_s7 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n180_s7 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n201_s7 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n203_s7 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_n289_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s7 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s7 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s7 : std_logic;
    -- stage 7
    signal vertex_b_n155 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n157 : unsigned(48 downto 0) := (others => '0'); -- u49f0
    signal vertex_b_n158 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n159 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n161 : unsigned(50 downto 0) := (others => '0'); -- u51f0
    signal vertex_b_n162 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n163 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n165 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n166 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n167 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n168 : signed(52 downto 0) := (others => '0'); -- s53f0
    signal vertex_b_x : signed(52 downto 0) := (others => '0'); -- s53f52
    signal vertex_b_n181 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n182 : unsigned(48 downto 0) := (others => '0'); -- u49f0
    signal vertex_b_n183 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n184 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n185 : unsigned(50 downto 0) := (others => '0'); -- u51f0
    signal vertex_b_n186 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n187 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n188 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n189 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n190 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n191 : signed(52 downto 0) := (others => '0'); -- s53f0
    signal vertex_b_y : signed(52 downto 0) := (others => '0'); -- s53f52
    signal vertex_b_n204 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n205 : unsigned(48 downto 0) := (others => '0'); -- u49f0
    signal vertex_b_n206 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n207 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n208 : unsigned(50 downto 0) := (others => '0'); -- u51f0
    signal vertex_b_n209 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n210 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n211 : unsigned(51 downto 0) := (others => '0'); -- u52f0
    signal vertex_b_n212 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n213 : unsigned(52 downto 0) := (others => '0'); -- u53f0
    signal vertex_b_n214 : signed(52 downto 0) := (others => '0'); -- s53f0
    signal vertex_b_z : signed(52 downto 0) := (others => '0'); -- s53f52
    signal vertex_b_norm_x_sum : signed(53 downto 0) := (others => '0');
    signal vertex_b_norm_x_cut : signed(18 downto 0) := (others => '0');
    signal vertex_b_norm_x_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_norm_x : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_sum : signed(53 downto 0) := (others => '0');
    signal vertex_b_norm_y_cut : signed(18 downto 0) := (others => '0');
    signal vertex_b_norm_y_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_norm_y : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_sum : signed(53 downto 0) := (others => '0');
    signal vertex_b_norm_z_cut : signed(18 downto 0) := (others => '0');
    signal vertex_b_norm_z_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_norm_z : signed(17 downto 0) := (others => '0'); -- s18f17
    signal normal_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_n289_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s8 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s8 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s8 : std_logic;
    -- stage 8
    signal vertex_b_square_n219 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal vertex_b_square_n220 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal vertex_b_square_n221 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal normal_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_square_n219_s9 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal vertex_b_square_n220_s9 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal vertex_b_square_n221_s9 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal vertex_n289_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s9 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s9 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s9 : std_logic;
    -- stage 9
    signal vertex_b_square_n222 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal vertex_b_square_n223 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal normal_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_square_n223_s10 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal vertex_n289_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s10 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s10 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s10 : std_logic;
    -- stage 10
    signal vertex_b_length_square_sum : signed(38 downto 0) := (others => '0');
    signal vertex_b_length_square_cut : signed(24 downto 0) := (others => '0');
    signal vertex_b_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal vertex_b_length_n225 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n226 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n227 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal vertex_b_length_n228 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_length_n229 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal vertex_b_length_n230 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n231 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n232 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal vertex_b_length_n233 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_length_n234 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal vertex_b_length_n235 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n247 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_length_n267 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal normal_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_length_n231_s11 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n233_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_length_n235_s11 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n247_s11 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_length_n267_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n289_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s11 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s11 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s11 : std_logic;
    -- stage 11
    signal vertex_b_length_n236 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n237 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_length_n238 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_length_n239 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal vertex_b_length_n240 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n241 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n242 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_length_n243 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_length_n244 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal vertex_b_length_n245 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n246 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal vertex_b_length_n248 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal vertex_b_length_n249 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_length_n250 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_length_n252 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal vertex_b_length_n253 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal vertex_b_length_n254 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal vertex_b_length_n255 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal vertex_b_length_n256 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal vertex_b_length_recip_root_n257 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal vertex_b_length_recip_root_n260 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal normal_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_length_n249_s12 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row : unsigned(39 downto 0) := (others => '0');
    signal vertex_b_length_recip_root_n260_s12 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal vertex_b_length_n267_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n289_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s12 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s12 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s12 : std_logic;
    -- stage 12
    signal vertex_b_length_recip_root_n258 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal vertex_b_length_recip_root_n259 : signed(16 downto 0) := (others => '0'); -- s17f34
    signal normal_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_length_n249_s13 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_length_recip_root_n258_s13 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal vertex_b_length_recip_root_n259_s13 : signed(16 downto 0) := (others => '0'); -- s17f34
    signal vertex_b_length_recip_root_n260_s13 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal vertex_b_length_n267_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n289_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s13 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s13 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s13 : std_logic;
    -- stage 13
    signal vertex_b_length_recip_root_n261 : signed(28 downto 0) := (others => '0'); -- s29f34
    signal vertex_b_length_recip_root_n262 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal normal_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_length_n249_s14 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal vertex_b_length_recip_root_n262_s14 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal vertex_b_length_n267_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n289_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s14 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s14 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s14 : std_logic;
    -- stage 14
    signal vertex_b_length_recip_root_n263_sum : signed(37 downto 0) := (others => '0');
    signal vertex_b_length_recip_root_n263_cut : signed(23 downto 0) := (others => '0');
    signal vertex_b_length_recip_root_n263_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_length_recip_root_n263_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_length_recip_root_n263 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal vertex_b_length_n264_past : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_length_n264_count : unsigned(3 downto 0) := (others => '0');
    signal vertex_b_length_n264 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal vertex_b_length_n265 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal vertex_b_length_n268 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal normal_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s15 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s15 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s15 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_length_n268_s15 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal vertex_n289_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s15 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s15 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s15 : std_logic;
    -- stage 15
    signal vertex_b_length_b_length_sum : unsigned(33 downto 0) := (others => '0');
    signal vertex_b_length_b_length_cut : unsigned(30 downto 0) := (others => '0');
    signal vertex_b_length_b_length_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_length_b_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal normal_x_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_norm_x_s16 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_y_s16 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_norm_z_s16 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal vertex_b_length_b_length_s16 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal vertex_n289_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s16 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s16 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s16 : std_logic;
    -- stage 16
    signal vertex_n270 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal vertex_n272 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal vertex_n274 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal normal_x_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n270_s17 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal vertex_n272_s17 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal vertex_n274_s17 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal vertex_n289_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s17 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s17 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s17 : std_logic;
    -- stage 17
    signal vertex_b_unit_x_sum : signed(38 downto 0) := (others => '0');
    signal vertex_b_unit_x_cut : signed(19 downto 0) := (others => '0');
    signal vertex_b_unit_x_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_unit_x_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_unit_x : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_y_sum : signed(38 downto 0) := (others => '0');
    signal vertex_b_unit_y_cut : signed(19 downto 0) := (others => '0');
    signal vertex_b_unit_y_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_unit_y_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_unit_y : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_z_sum : signed(38 downto 0) := (others => '0');
    signal vertex_b_unit_z_cut : signed(19 downto 0) := (others => '0');
    signal vertex_b_unit_z_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_unit_z_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_b_unit_z : signed(17 downto 0) := (others => '0'); -- s18f16
    signal normal_x_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_unit_x_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_y_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_z_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_n289_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_z_s18 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s18 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s18 : std_logic;
    -- stage 18
    signal vertex_b_cross_n_n276 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n277 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n279 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n280 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n282 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n283 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n305 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n306 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n307 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n323 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n324 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n325 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal normal_x_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s19 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_unit_x_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_y_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_z_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_cross_n_n276_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n277_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n279_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n280_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n282_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_b_cross_n_n283_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_n289_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_ts_view_b_n305_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n306_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n307_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_z_s19 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_b_n323_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n324_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n325_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_z_s19 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s19 : std_logic;
    -- stage 19
    signal vertex_b_cross_n_n278 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_b_cross_n_n281 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_b_cross_n_n284 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_n285_sum : signed(35 downto 0) := (others => '0');
    signal vertex_n285_cut : signed(21 downto 0) := (others => '0');
    signal vertex_n285_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_n285_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_n285 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n286_sum : signed(35 downto 0) := (others => '0');
    signal vertex_n286_cut : signed(21 downto 0) := (others => '0');
    signal vertex_n286_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_n286_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_n286 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n287_sum : signed(35 downto 0) := (others => '0');
    signal vertex_n287_cut : signed(21 downto 0) := (others => '0');
    signal vertex_n287_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_n287_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_n287 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n290 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n293 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n296 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_ts_view_b_n308 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_b_n309 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_b_n326 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_b_n327 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal normal_x_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_x_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s20 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_unit_x_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_y_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_z_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_n285_s20 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n286_s20 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n287_s20 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n289_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_n290_s20 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n293_s20 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n296_s20 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_ts_view_b_n309_s20 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_view_z_s20 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_b_n327_s20 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_z_s20 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s20 : std_logic;
    -- stage 20
    signal vertex_n291 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n292_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_n292_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_n292 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n294 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n295_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_n295_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_n295 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n297 : signed(19 downto 0) := (others => '0'); -- s20f16
    signal vertex_n298_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_n298_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_n298 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_ts_view_t_n299 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_t_n300 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_t_n301 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_y_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_view_y_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_view_y_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_y_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_y : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_t_n317 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_t_n318 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_t_n319 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_y_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_light0_y_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_light0_y_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_y_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_y : signed(18 downto 0) := (others => '0'); -- s19f14
    signal normal_x_s21 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s21 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s21 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s21 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_unit_x_s21 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_y_s21 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_z_s21 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_n292_s21 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n295_s21 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n298_s21 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_ts_view_t_n299_s21 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_t_n300_s21 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_t_n301_s21 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_y_s21 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_view_z_s21 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_t_n317_s21 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_t_n318_s21 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_t_n319_s21 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_y_s21 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s21 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s21 : std_logic;
    -- stage 21
    signal vertex_ts_view_t_n302 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_view_t_n303 : signed(36 downto 0) := (others => '0'); -- s37f30
    signal vertex_ts_light0_t_n320 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_t_n321 : signed(36 downto 0) := (others => '0'); -- s37f30
    signal normal_x_s22 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_y_s22 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal normal_z_s22 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_parallel_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_degenerate_s22 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal vertex_b_unit_x_s22 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_y_s22 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_b_unit_z_s22 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_n292_s22 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n295_s22 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_n298_s22 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal vertex_ts_view_t_n303_s22 : signed(36 downto 0) := (others => '0'); -- s37f30
    signal vertex_ts_view_y_s22 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_view_z_s22 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_t_n321_s22 : signed(36 downto 0) := (others => '0'); -- s37f30
    signal vertex_ts_light0_y_s22 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_z_s22 : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s22 : std_logic;
    -- stage 22
    signal vertex_ts_view_x_sum : signed(37 downto 0) := (others => '0');
    signal vertex_ts_view_x_cut : signed(21 downto 0) := (others => '0');
    signal vertex_ts_view_x_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_x_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_x : signed(18 downto 0) := (others => '0'); -- s19f14
    signal vertex_ts_light0_x_sum : signed(37 downto 0) := (others => '0');
    signal vertex_ts_light0_x_cut : signed(21 downto 0) := (others => '0');
    signal vertex_ts_light0_x_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_x_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_x : signed(18 downto 0) := (others => '0'); -- s19f14
    signal valid_s23 : std_logic;
begin

    -- ---- stage 0 ----
    -- primitive
    primitive_e1_x <= resize(p1_x, 17) - resize(p0_x, 17);
    primitive_e1_y <= resize(p1_y, 17) - resize(p0_y, 17);
    primitive_e1_z <= resize(p1_z, 17) - resize(p0_z, 17);
    primitive_e2_x <= resize(p2_x, 17) - resize(p0_x, 17);
    primitive_e2_y <= resize(p2_y, 17) - resize(p0_y, 17);
    primitive_e2_z <= resize(p2_z, 17) - resize(p0_z, 17);
    primitive_du1 <= resize(uv1_u, 17) - resize(uv0_u, 17);
    primitive_dv1 <= resize(uv1_v, 17) - resize(uv0_v, 17);
    primitive_du2 <= resize(uv2_u, 17) - resize(uv0_u, 17);
    primitive_dv2 <= resize(uv2_v, 17) - resize(uv0_v, 17);
    primitive_n34 <= primitive_du1 * primitive_dv2;
    primitive_n35 <= primitive_du2 * primitive_dv1;
    primitive_n37 <= "0";
    primitive_n40 <= primitive_dv2 * primitive_e1_x;
    primitive_n41 <= primitive_dv1 * primitive_e2_x;
    primitive_n43 <= primitive_dv2 * primitive_e1_y;
    primitive_n44 <= primitive_dv1 * primitive_e2_y;
    primitive_n46 <= primitive_dv2 * primitive_e1_z;
    primitive_n47 <= primitive_dv1 * primitive_e2_z;
    -- primitive.e1_cross_e2
    primitive_e1_cross_e2_n49 <= primitive_e1_y * primitive_e2_z;
    primitive_e1_cross_e2_n50 <= primitive_e1_z * primitive_e2_y;
    primitive_e1_cross_e2_n52 <= primitive_e1_z * primitive_e2_x;
    primitive_e1_cross_e2_n53 <= primitive_e1_x * primitive_e2_z;
    primitive_e1_cross_e2_n55 <= primitive_e1_x * primitive_e2_y;
    primitive_e1_cross_e2_n56 <= primitive_e1_y * primitive_e2_x;
    -- vertex
    vertex_n63_neg <= unsigned(-normal_x);
    vertex_n63 <= vertex_n63_neg when normal_x(15) = '1' else unsigned(normal_x);
    vertex_n64_neg <= unsigned(-normal_y);
    vertex_n64 <= vertex_n64_neg when normal_y(15) = '1' else unsigned(normal_y);
    vertex_along_x <= "1" when vertex_n64 < vertex_n63 else "0";
    vertex_n66 <= 16x"0000";
    vertex_n67 <= -resize(normal_y, 17);
    vertex_n68 <= -resize(normal_z, 17);
    vertex_n69 <= vertex_n68 when vertex_along_x(0) = '1' else resize(vertex_n66, 17);
    vertex_n70 <= vertex_n66 when vertex_along_x(0) = '1' else normal_z;
    vertex_n71 <= resize(normal_x, 17) when vertex_along_x(0) = '1' else vertex_n67;
    vertex_n88 <= vertex_n69;
    vertex_n90 <= vertex_n70;
    vertex_n92 <= vertex_n71;
    -- vertex.b
    vertex_b_n107 <= 32x"00000000";
    vertex_b_n113 <= 16x"0000";
    vertex_b_n119 <= 8x"00";
    vertex_b_n125 <= 4x"0";
    vertex_b_n131 <= "00";
    -- vertex.b_length
    vertex_b_length_n251 <= "1";
    vertex_b_length_n266 <= "1";
    -- vertex.ts_view_n
    vertex_ts_view_n_n311 <= normal_x * view_x;
    vertex_ts_view_n_n312 <= normal_y * view_y;
    vertex_ts_view_n_n313 <= normal_z * view_z;
    -- vertex.ts_light0_n
    vertex_ts_light0_n_n329 <= normal_x * light0_x;
    vertex_ts_light0_n_n330 <= normal_y * light0_y;
    vertex_ts_light0_n_n331 <= normal_z * light0_z;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s1 <= normal_x;
                normal_y_s1 <= normal_y;
                normal_z_s1 <= normal_z;
                view_x_s1 <= view_x;
                view_y_s1 <= view_y;
                view_z_s1 <= view_z;
                light0_x_s1 <= light0_x;
                light0_y_s1 <= light0_y;
                light0_z_s1 <= light0_z;
                primitive_n34_s1 <= primitive_n34;
                primitive_n35_s1 <= primitive_n35;
                primitive_n40_s1 <= primitive_n40;
                primitive_n41_s1 <= primitive_n41;
                primitive_n43_s1 <= primitive_n43;
                primitive_n44_s1 <= primitive_n44;
                primitive_n46_s1 <= primitive_n46;
                primitive_n47_s1 <= primitive_n47;
                primitive_e1_cross_e2_n49_s1 <= primitive_e1_cross_e2_n49;
                primitive_e1_cross_e2_n50_s1 <= primitive_e1_cross_e2_n50;
                primitive_e1_cross_e2_n52_s1 <= primitive_e1_cross_e2_n52;
                primitive_e1_cross_e2_n53_s1 <= primitive_e1_cross_e2_n53;
                primitive_e1_cross_e2_n55_s1 <= primitive_e1_cross_e2_n55;
                primitive_e1_cross_e2_n56_s1 <= primitive_e1_cross_e2_n56;
                vertex_n88_s1 <= vertex_n88;
                vertex_n90_s1 <= vertex_n90;
                vertex_n92_s1 <= vertex_n92;
                vertex_ts_view_n_n311_s1 <= vertex_ts_view_n_n311;
                vertex_ts_view_n_n312_s1 <= vertex_ts_view_n_n312;
                vertex_ts_view_n_n313_s1 <= vertex_ts_view_n_n313;
                vertex_ts_light0_n_n329_s1 <= vertex_ts_light0_n_n329;
                vertex_ts_light0_n_n330_s1 <= vertex_ts_light0_n_n330;
                vertex_ts_light0_n_n331_s1 <= vertex_ts_light0_n_n331;
            end if;
            if rst = '1' then
                valid_s1 <= '0';
            elsif ce = '1' then
                valid_s1 <= valid_in;
            end if;
        end if;
    end process;

    -- ---- stage 1 ----
    -- primitive
    primitive_det <= resize(primitive_n34_s1, 35) - resize(primitive_n35_s1, 35);
    primitive_zero_uv <= "1" when unsigned(primitive_det) = shift_left(resize(primitive_n37, 35), 26) else "0";
    primitive_mirrored <= unsigned(primitive_det(34 downto 34));
    primitive_t_det_x <= resize(primitive_n40_s1, 35) - resize(primitive_n41_s1, 35);
    primitive_t_det_y <= resize(primitive_n43_s1, 35) - resize(primitive_n44_s1, 35);
    primitive_t_det_z <= resize(primitive_n46_s1, 35) - resize(primitive_n47_s1, 35);
    -- primitive.e1_cross_e2
    primitive_e1_cross_e2_n51 <= resize(primitive_e1_cross_e2_n49_s1, 35) - resize(primitive_e1_cross_e2_n50_s1, 35);
    primitive_e1_cross_e2_n54 <= resize(primitive_e1_cross_e2_n52_s1, 35) - resize(primitive_e1_cross_e2_n53_s1, 35);
    primitive_e1_cross_e2_n57 <= resize(primitive_e1_cross_e2_n55_s1, 35) - resize(primitive_e1_cross_e2_n56_s1, 35);
    -- primitive
    primitive_n58 <= "1" when unsigned(primitive_e1_cross_e2_n51) = shift_left(resize(primitive_n37, 35), 22) else "0";
    primitive_n59 <= "1" when unsigned(primitive_e1_cross_e2_n54) = shift_left(resize(primitive_n37, 35), 22) else "0";
    primitive_n60 <= "1" when unsigned(primitive_e1_cross_e2_n57) = shift_left(resize(primitive_n37, 35), 22) else "0";
    primitive_n61 <= primitive_n58 and primitive_n59;
    primitive_zero_area <= primitive_n61 and primitive_n60;
    -- vertex
    vertex_n72 <= primitive_zero_uv or primitive_zero_area;
    -- vertex.ts_view_n
    vertex_ts_view_n_n314 <= resize(vertex_ts_view_n_n311_s1, 33) + resize(vertex_ts_view_n_n312_s1, 33);
    vertex_ts_view_n_n315 <= resize(vertex_ts_view_n_n314, 34) + resize(vertex_ts_view_n_n313_s1, 34);
    -- vertex.ts_light0_n
    vertex_ts_light0_n_n332 <= resize(vertex_ts_light0_n_n329_s1, 33) + resize(vertex_ts_light0_n_n330_s1, 33);
    vertex_ts_light0_n_n333 <= resize(vertex_ts_light0_n_n332, 34) + resize(vertex_ts_light0_n_n331_s1, 34);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s2 <= normal_x_s1;
                normal_y_s2 <= normal_y_s1;
                normal_z_s2 <= normal_z_s1;
                view_x_s2 <= view_x_s1;
                view_y_s2 <= view_y_s1;
                view_z_s2 <= view_z_s1;
                light0_x_s2 <= light0_x_s1;
                light0_y_s2 <= light0_y_s1;
                light0_z_s2 <= light0_z_s1;
                primitive_zero_uv_s2 <= primitive_zero_uv;
                primitive_mirrored_s2 <= primitive_mirrored;
                primitive_t_det_x_s2 <= primitive_t_det_x;
                primitive_t_det_y_s2 <= primitive_t_det_y;
                primitive_t_det_z_s2 <= primitive_t_det_z;
                primitive_zero_area_s2 <= primitive_zero_area;
                vertex_n72_s2 <= vertex_n72;
                vertex_n88_s2 <= vertex_n88_s1;
                vertex_n90_s2 <= vertex_n90_s1;
                vertex_n92_s2 <= vertex_n92_s1;
                vertex_ts_view_n_n315_s2 <= vertex_ts_view_n_n315;
                vertex_ts_light0_n_n333_s2 <= vertex_ts_light0_n_n333;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- vertex.n_cross_t
    vertex_n_cross_t_n73 <= normal_y_s2 * primitive_t_det_z_s2;
    vertex_n_cross_t_n74 <= normal_z_s2 * primitive_t_det_y_s2;
    vertex_n_cross_t_n76 <= normal_z_s2 * primitive_t_det_x_s2;
    vertex_n_cross_t_n77 <= normal_x_s2 * primitive_t_det_z_s2;
    vertex_n_cross_t_n79 <= normal_x_s2 * primitive_t_det_y_s2;
    vertex_n_cross_t_n80 <= normal_y_s2 * primitive_t_det_x_s2;
    -- vertex
    vertex_ts_view_z_sum <= resize(vertex_ts_view_n_n315_s2, 35) + 35x"000002000";
    vertex_ts_view_z_cut <= vertex_ts_view_z_sum(34 downto 14);
    vertex_ts_view_z_over <= "1" when vertex_ts_view_z_cut(20) = '0' and (or vertex_ts_view_z_cut(19 downto 18)) = '1' else "0";
    vertex_ts_view_z_under <= "1" when vertex_ts_view_z_cut(20) = '1' and (and vertex_ts_view_z_cut(19 downto 18)) = '0' else "0";
    vertex_ts_view_z <= 19x"3ffff" when vertex_ts_view_z_over(0) = '1' else 19x"40000" when vertex_ts_view_z_under(0) = '1' else vertex_ts_view_z_cut(18 downto 0);
    vertex_ts_light0_z_sum <= resize(vertex_ts_light0_n_n333_s2, 35) + 35x"000002000";
    vertex_ts_light0_z_cut <= vertex_ts_light0_z_sum(34 downto 14);
    vertex_ts_light0_z_over <= "1" when vertex_ts_light0_z_cut(20) = '0' and (or vertex_ts_light0_z_cut(19 downto 18)) = '1' else "0";
    vertex_ts_light0_z_under <= "1" when vertex_ts_light0_z_cut(20) = '1' and (and vertex_ts_light0_z_cut(19 downto 18)) = '0' else "0";
    vertex_ts_light0_z <= 19x"3ffff" when vertex_ts_light0_z_over(0) = '1' else 19x"40000" when vertex_ts_light0_z_under(0) = '1' else vertex_ts_light0_z_cut(18 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s3 <= normal_x_s2;
                normal_y_s3 <= normal_y_s2;
                normal_z_s3 <= normal_z_s2;
                view_x_s3 <= view_x_s2;
                view_y_s3 <= view_y_s2;
                view_z_s3 <= view_z_s2;
                light0_x_s3 <= light0_x_s2;
                light0_y_s3 <= light0_y_s2;
                light0_z_s3 <= light0_z_s2;
                primitive_zero_uv_s3 <= primitive_zero_uv_s2;
                primitive_mirrored_s3 <= primitive_mirrored_s2;
                primitive_zero_area_s3 <= primitive_zero_area_s2;
                vertex_n72_s3 <= vertex_n72_s2;
                vertex_n_cross_t_n73_s3 <= vertex_n_cross_t_n73;
                vertex_n_cross_t_n74_s3 <= vertex_n_cross_t_n74;
                vertex_n_cross_t_n76_s3 <= vertex_n_cross_t_n76;
                vertex_n_cross_t_n77_s3 <= vertex_n_cross_t_n77;
                vertex_n_cross_t_n79_s3 <= vertex_n_cross_t_n79;
                vertex_n_cross_t_n80_s3 <= vertex_n_cross_t_n80;
                vertex_n88_s3 <= vertex_n88_s2;
                vertex_n90_s3 <= vertex_n90_s2;
                vertex_n92_s3 <= vertex_n92_s2;
                vertex_ts_view_z_s3 <= vertex_ts_view_z;
                vertex_ts_light0_z_s3 <= vertex_ts_light0_z;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- vertex.n_cross_t
    vertex_n_cross_t_n75 <= resize(vertex_n_cross_t_n73_s3, 52) - resize(vertex_n_cross_t_n74_s3, 52);
    vertex_n_cross_t_n78 <= resize(vertex_n_cross_t_n76_s3, 52) - resize(vertex_n_cross_t_n77_s3, 52);
    vertex_n_cross_t_n81 <= resize(vertex_n_cross_t_n79_s3, 52) - resize(vertex_n_cross_t_n80_s3, 52);
    -- vertex
    vertex_n82 <= "1" when unsigned(vertex_n_cross_t_n75) = shift_left(resize(primitive_n37, 52), 38) else "0";
    vertex_n83 <= "1" when unsigned(vertex_n_cross_t_n78) = shift_left(resize(primitive_n37, 52), 38) else "0";
    vertex_n84 <= "1" when unsigned(vertex_n_cross_t_n81) = shift_left(resize(primitive_n37, 52), 38) else "0";
    vertex_n85 <= vertex_n82 and vertex_n83;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s4 <= normal_x_s3;
                normal_y_s4 <= normal_y_s3;
                normal_z_s4 <= normal_z_s3;
                view_x_s4 <= view_x_s3;
                view_y_s4 <= view_y_s3;
                view_z_s4 <= view_z_s3;
                light0_x_s4 <= light0_x_s3;
                light0_y_s4 <= light0_y_s3;
                light0_z_s4 <= light0_z_s3;
                primitive_zero_uv_s4 <= primitive_zero_uv_s3;
                primitive_mirrored_s4 <= primitive_mirrored_s3;
                primitive_zero_area_s4 <= primitive_zero_area_s3;
                vertex_n72_s4 <= vertex_n72_s3;
                vertex_n_cross_t_n75_s4 <= vertex_n_cross_t_n75;
                vertex_n_cross_t_n78_s4 <= vertex_n_cross_t_n78;
                vertex_n_cross_t_n81_s4 <= vertex_n_cross_t_n81;
                vertex_n84_s4 <= vertex_n84;
                vertex_n85_s4 <= vertex_n85;
                vertex_n88_s4 <= vertex_n88_s3;
                vertex_n90_s4 <= vertex_n90_s3;
                vertex_n92_s4 <= vertex_n92_s3;
                vertex_ts_view_z_s4 <= vertex_ts_view_z_s3;
                vertex_ts_light0_z_s4 <= vertex_ts_light0_z_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- vertex
    vertex_parallel <= vertex_n85_s4 and vertex_n84_s4;
    vertex_degenerate <= vertex_n72_s4 or vertex_parallel;
    vertex_n89 <= resize(vertex_n88_s4, 52) when vertex_degenerate(0) = '1' else vertex_n_cross_t_n75_s4;
    vertex_n91 <= resize(vertex_n90_s4, 52) when vertex_degenerate(0) = '1' else vertex_n_cross_t_n78_s4;
    vertex_n93 <= resize(vertex_n92_s4, 52) when vertex_degenerate(0) = '1' else vertex_n_cross_t_n81_s4;
    -- vertex.b
    vertex_b_n94_neg <= unsigned(-vertex_n89);
    vertex_b_n94 <= vertex_b_n94_neg when vertex_n89(51) = '1' else unsigned(vertex_n89);
    vertex_b_n95 <= vertex_b_n94;
    vertex_b_n96_neg <= unsigned(-vertex_n91);
    vertex_b_n96 <= vertex_b_n96_neg when vertex_n91(51) = '1' else unsigned(vertex_n91);
    vertex_b_n97 <= vertex_b_n96;
    vertex_b_n98_neg <= unsigned(-vertex_n93);
    vertex_b_n98 <= vertex_b_n98_neg when vertex_n93(51) = '1' else unsigned(vertex_n93);
    vertex_b_n99 <= vertex_b_n98;
    vertex_b_n100 <= vertex_b_n95 or vertex_b_n97;
    vertex_b_n101 <= vertex_b_n100 or vertex_b_n99;
    vertex_b_largest <= vertex_b_n101;
    vertex_b_n103 <= vertex_b_largest;
    vertex_b_n104 <= vertex_b_n103(51 downto 20);
    vertex_b_n106 <= vertex_b_n103(19 downto 0);
    vertex_b_n108 <= vertex_b_n106 & vertex_b_n107;
    vertex_b_n141 <= unsigned(vertex_n89(51 downto 51));
    vertex_b_n142 <= unsigned(vertex_n89);
    vertex_b_n143 <= vertex_b_n141 & vertex_b_n142;
    vertex_b_n145 <= vertex_b_n143(20 downto 0);
    vertex_b_n146 <= vertex_b_n145 & vertex_b_n107;
    vertex_b_n170 <= unsigned(vertex_n91(51 downto 51));
    vertex_b_n171 <= unsigned(vertex_n91);
    vertex_b_n172 <= vertex_b_n170 & vertex_b_n171;
    vertex_b_n173 <= vertex_b_n172(20 downto 0);
    vertex_b_n174 <= vertex_b_n173 & vertex_b_n107;
    vertex_b_n193 <= unsigned(vertex_n93(51 downto 51));
    vertex_b_n194 <= unsigned(vertex_n93);
    vertex_b_n195 <= vertex_b_n193 & vertex_b_n194;
    vertex_b_n196 <= vertex_b_n195(20 downto 0);
    vertex_b_n197 <= vertex_b_n196 & vertex_b_n107;
    -- vertex
    vertex_n288 <= vertex_degenerate xor vertex_b_length_n251;
    vertex_n289 <= primitive_mirrored_s4 and vertex_n288;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s5 <= normal_x_s4;
                normal_y_s5 <= normal_y_s4;
                normal_z_s5 <= normal_z_s4;
                view_x_s5 <= view_x_s4;
                view_y_s5 <= view_y_s4;
                view_z_s5 <= view_z_s4;
                light0_x_s5 <= light0_x_s4;
                light0_y_s5 <= light0_y_s4;
                light0_z_s5 <= light0_z_s4;
                primitive_zero_uv_s5 <= primitive_zero_uv_s4;
                primitive_mirrored_s5 <= primitive_mirrored_s4;
                primitive_zero_area_s5 <= primitive_zero_area_s4;
                vertex_parallel_s5 <= vertex_parallel;
                vertex_degenerate_s5 <= vertex_degenerate;
                vertex_b_n103_s5 <= vertex_b_n103;
                vertex_b_n104_s5 <= vertex_b_n104;
                vertex_b_n108_s5 <= vertex_b_n108;
                vertex_b_n143_s5 <= vertex_b_n143;
                vertex_b_n146_s5 <= vertex_b_n146;
                vertex_b_n172_s5 <= vertex_b_n172;
                vertex_b_n174_s5 <= vertex_b_n174;
                vertex_b_n195_s5 <= vertex_b_n195;
                vertex_b_n197_s5 <= vertex_b_n197;
                vertex_n289_s5 <= vertex_n289;
                vertex_ts_view_z_s5 <= vertex_ts_view_z_s4;
                vertex_ts_light0_z_s5 <= vertex_ts_light0_z_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- vertex.b
    vertex_b_n105 <= "1" when vertex_b_n104_s5 = resize(primitive_n37, 32) else "0";
    vertex_b_n109 <= vertex_b_n108_s5 when vertex_b_n105(0) = '1' else vertex_b_n103_s5;
    vertex_b_n110 <= vertex_b_n109(51 downto 36);
    vertex_b_n111 <= "1" when vertex_b_n110 = resize(primitive_n37, 16) else "0";
    vertex_b_n112 <= vertex_b_n109(35 downto 0);
    vertex_b_n114 <= vertex_b_n112 & vertex_b_n113;
    vertex_b_n115 <= vertex_b_n114 when vertex_b_n111(0) = '1' else vertex_b_n109;
    vertex_b_n116 <= vertex_b_n115(51 downto 44);
    vertex_b_n117 <= "1" when vertex_b_n116 = resize(primitive_n37, 8) else "0";
    vertex_b_n118 <= vertex_b_n115(43 downto 0);
    vertex_b_n120 <= vertex_b_n118 & vertex_b_n119;
    vertex_b_n136 <= vertex_b_n105 & vertex_b_n111;
    vertex_b_n137 <= vertex_b_n136 & vertex_b_n117;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s6 <= normal_x_s5;
                normal_y_s6 <= normal_y_s5;
                normal_z_s6 <= normal_z_s5;
                view_x_s6 <= view_x_s5;
                view_y_s6 <= view_y_s5;
                view_z_s6 <= view_z_s5;
                light0_x_s6 <= light0_x_s5;
                light0_y_s6 <= light0_y_s5;
                light0_z_s6 <= light0_z_s5;
                primitive_zero_uv_s6 <= primitive_zero_uv_s5;
                primitive_mirrored_s6 <= primitive_mirrored_s5;
                primitive_zero_area_s6 <= primitive_zero_area_s5;
                vertex_parallel_s6 <= vertex_parallel_s5;
                vertex_degenerate_s6 <= vertex_degenerate_s5;
                vertex_b_n115_s6 <= vertex_b_n115;
                vertex_b_n117_s6 <= vertex_b_n117;
                vertex_b_n120_s6 <= vertex_b_n120;
                vertex_b_n137_s6 <= vertex_b_n137;
                vertex_b_n143_s6 <= vertex_b_n143_s5;
                vertex_b_n146_s6 <= vertex_b_n146_s5;
                vertex_b_n172_s6 <= vertex_b_n172_s5;
                vertex_b_n174_s6 <= vertex_b_n174_s5;
                vertex_b_n195_s6 <= vertex_b_n195_s5;
                vertex_b_n197_s6 <= vertex_b_n197_s5;
                vertex_n289_s6 <= vertex_n289_s5;
                vertex_ts_view_z_s6 <= vertex_ts_view_z_s5;
                vertex_ts_light0_z_s6 <= vertex_ts_light0_z_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- vertex.b
    vertex_b_n121 <= vertex_b_n120_s6 when vertex_b_n117_s6(0) = '1' else vertex_b_n115_s6;
    vertex_b_n122 <= vertex_b_n121(51 downto 48);
    vertex_b_n123 <= "1" when vertex_b_n122 = resize(primitive_n37, 4) else "0";
    vertex_b_n124 <= vertex_b_n121(47 downto 0);
    vertex_b_n126 <= vertex_b_n124 & vertex_b_n125;
    vertex_b_n127 <= vertex_b_n126 when vertex_b_n123(0) = '1' else vertex_b_n121;
    vertex_b_n128 <= vertex_b_n127(51 downto 50);
    vertex_b_n129 <= "1" when vertex_b_n128 = resize(primitive_n37, 2) else "0";
    vertex_b_n130 <= vertex_b_n127(49 downto 0);
    vertex_b_n132 <= vertex_b_n130 & vertex_b_n131;
    vertex_b_n133 <= vertex_b_n132 when vertex_b_n129(0) = '1' else vertex_b_n127;
    vertex_b_n134 <= vertex_b_n133(51 downto 51);
    vertex_b_n135 <= "1" when vertex_b_n134 = primitive_n37 else "0";
    vertex_b_n138 <= vertex_b_n137_s6 & vertex_b_n123;
    vertex_b_n139 <= vertex_b_n138 & vertex_b_n129;
    vertex_b_places <= vertex_b_n139 & vertex_b_n135;
    vertex_b_n144 <= vertex_b_places(5 downto 5);
    vertex_b_n147 <= vertex_b_n146_s6 when vertex_b_n144(0) = '1' else vertex_b_n143_s6;
    vertex_b_n148 <= vertex_b_places(4 downto 4);
    vertex_b_n149 <= vertex_b_n147(36 downto 0);
    vertex_b_n150 <= vertex_b_n149 & vertex_b_n113;
    vertex_b_n151 <= vertex_b_n150 when vertex_b_n148(0) = '1' else vertex_b_n147;
    vertex_b_n152 <= vertex_b_places(3 downto 3);
    vertex_b_n153 <= vertex_b_n151(44 downto 0);
    vertex_b_n154 <= vertex_b_n153 & vertex_b_n119;
    vertex_b_n156 <= vertex_b_places(2 downto 2);
    vertex_b_n160 <= vertex_b_places(1 downto 1);
    vertex_b_n164 <= vertex_b_places(0 downto 0);
    vertex_b_n175 <= vertex_b_n174_s6 when vertex_b_n144(0) = '1' else vertex_b_n172_s6;
    vertex_b_n176 <= vertex_b_n175(36 downto 0);
    vertex_b_n177 <= vertex_b_n176 & vertex_b_n113;
    vertex_b_n178 <= vertex_b_n177 when vertex_b_n148(0) = '1' else vertex_b_n175;
    vertex_b_n179 <= vertex_b_n178(44 downto 0);
    vertex_b_n180 <= vertex_b_n179 & vertex_b_n119;
    vertex_b_n198 <= vertex_b_n197_s6 when vertex_b_n144(0) = '1' else vertex_b_n195_s6;
    vertex_b_n199 <= vertex_b_n198(36 downto 0);
    vertex_b_n200 <= vertex_b_n199 & vertex_b_n113;
    vertex_b_n201 <= vertex_b_n200 when vertex_b_n148(0) = '1' else vertex_b_n198;
    vertex_b_n202 <= vertex_b_n201(44 downto 0);
    vertex_b_n203 <= vertex_b_n202 & vertex_b_n119;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s7 <= normal_x_s6;
                normal_y_s7 <= normal_y_s6;
                normal_z_s7 <= normal_z_s6;
                view_x_s7 <= view_x_s6;
                view_y_s7 <= view_y_s6;
                view_z_s7 <= view_z_s6;
                light0_x_s7 <= light0_x_s6;
                light0_y_s7 <= light0_y_s6;
                light0_z_s7 <= light0_z_s6;
                primitive_zero_uv_s7 <= primitive_zero_uv_s6;
                primitive_mirrored_s7 <= primitive_mirrored_s6;
                primitive_zero_area_s7 <= primitive_zero_area_s6;
                vertex_parallel_s7 <= vertex_parallel_s6;
                vertex_degenerate_s7 <= vertex_degenerate_s6;
                vertex_b_n151_s7 <= vertex_b_n151;
                vertex_b_n152_s7 <= vertex_b_n152;
                vertex_b_n154_s7 <= vertex_b_n154;
                vertex_b_n156_s7 <= vertex_b_n156;
                vertex_b_n160_s7 <= vertex_b_n160;
                vertex_b_n164_s7 <= vertex_b_n164;
                vertex_b_n178_s7 <= vertex_b_n178;
                vertex_b_n180_s7 <= vertex_b_n180;
                vertex_b_n201_s7 <= vertex_b_n201;
                vertex_b_n203_s7 <= vertex_b_n203;
                vertex_n289_s7 <= vertex_n289_s6;
                vertex_ts_view_z_s7 <= vertex_ts_view_z_s6;
                vertex_ts_light0_z_s7 <= vertex_ts_light0_z_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- vertex.b
    vertex_b_n155 <= vertex_b_n154_s7 when vertex_b_n152_s7(0) = '1' else vertex_b_n151_s7;
    vertex_b_n157 <= vertex_b_n155(48 downto 0);
    vertex_b_n158 <= vertex_b_n157 & vertex_b_n125;
    vertex_b_n159 <= vertex_b_n158 when vertex_b_n156_s7(0) = '1' else vertex_b_n155;
    vertex_b_n161 <= vertex_b_n159(50 downto 0);
    vertex_b_n162 <= vertex_b_n161 & vertex_b_n131;
    vertex_b_n163 <= vertex_b_n162 when vertex_b_n160_s7(0) = '1' else vertex_b_n159;
    vertex_b_n165 <= vertex_b_n163(51 downto 0);
    vertex_b_n166 <= vertex_b_n165 & primitive_n37;
    vertex_b_n167 <= vertex_b_n166 when vertex_b_n164_s7(0) = '1' else vertex_b_n163;
    vertex_b_n168 <= signed(vertex_b_n167);
    vertex_b_x <= vertex_b_n168;
    vertex_b_n181 <= vertex_b_n180_s7 when vertex_b_n152_s7(0) = '1' else vertex_b_n178_s7;
    vertex_b_n182 <= vertex_b_n181(48 downto 0);
    vertex_b_n183 <= vertex_b_n182 & vertex_b_n125;
    vertex_b_n184 <= vertex_b_n183 when vertex_b_n156_s7(0) = '1' else vertex_b_n181;
    vertex_b_n185 <= vertex_b_n184(50 downto 0);
    vertex_b_n186 <= vertex_b_n185 & vertex_b_n131;
    vertex_b_n187 <= vertex_b_n186 when vertex_b_n160_s7(0) = '1' else vertex_b_n184;
    vertex_b_n188 <= vertex_b_n187(51 downto 0);
    vertex_b_n189 <= vertex_b_n188 & primitive_n37;
    vertex_b_n190 <= vertex_b_n189 when vertex_b_n164_s7(0) = '1' else vertex_b_n187;
    vertex_b_n191 <= signed(vertex_b_n190);
    vertex_b_y <= vertex_b_n191;
    vertex_b_n204 <= vertex_b_n203_s7 when vertex_b_n152_s7(0) = '1' else vertex_b_n201_s7;
    vertex_b_n205 <= vertex_b_n204(48 downto 0);
    vertex_b_n206 <= vertex_b_n205 & vertex_b_n125;
    vertex_b_n207 <= vertex_b_n206 when vertex_b_n156_s7(0) = '1' else vertex_b_n204;
    vertex_b_n208 <= vertex_b_n207(50 downto 0);
    vertex_b_n209 <= vertex_b_n208 & vertex_b_n131;
    vertex_b_n210 <= vertex_b_n209 when vertex_b_n160_s7(0) = '1' else vertex_b_n207;
    vertex_b_n211 <= vertex_b_n210(51 downto 0);
    vertex_b_n212 <= vertex_b_n211 & primitive_n37;
    vertex_b_n213 <= vertex_b_n212 when vertex_b_n164_s7(0) = '1' else vertex_b_n210;
    vertex_b_n214 <= signed(vertex_b_n213);
    vertex_b_z <= vertex_b_n214;
    -- vertex
    vertex_b_norm_x_sum <= resize(vertex_b_x, 54) + 54x"00000400000000";
    vertex_b_norm_x_cut <= vertex_b_norm_x_sum(53 downto 35);
    vertex_b_norm_x_over <= "1" when vertex_b_norm_x_cut(18) = '0' and (or vertex_b_norm_x_cut(17 downto 17)) = '1' else "0";
    vertex_b_norm_x <= 18x"1ffff" when vertex_b_norm_x_over(0) = '1' else vertex_b_norm_x_cut(17 downto 0);
    vertex_b_norm_y_sum <= resize(vertex_b_y, 54) + 54x"00000400000000";
    vertex_b_norm_y_cut <= vertex_b_norm_y_sum(53 downto 35);
    vertex_b_norm_y_over <= "1" when vertex_b_norm_y_cut(18) = '0' and (or vertex_b_norm_y_cut(17 downto 17)) = '1' else "0";
    vertex_b_norm_y <= 18x"1ffff" when vertex_b_norm_y_over(0) = '1' else vertex_b_norm_y_cut(17 downto 0);
    vertex_b_norm_z_sum <= resize(vertex_b_z, 54) + 54x"00000400000000";
    vertex_b_norm_z_cut <= vertex_b_norm_z_sum(53 downto 35);
    vertex_b_norm_z_over <= "1" when vertex_b_norm_z_cut(18) = '0' and (or vertex_b_norm_z_cut(17 downto 17)) = '1' else "0";
    vertex_b_norm_z <= 18x"1ffff" when vertex_b_norm_z_over(0) = '1' else vertex_b_norm_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s8 <= normal_x_s7;
                normal_y_s8 <= normal_y_s7;
                normal_z_s8 <= normal_z_s7;
                view_x_s8 <= view_x_s7;
                view_y_s8 <= view_y_s7;
                view_z_s8 <= view_z_s7;
                light0_x_s8 <= light0_x_s7;
                light0_y_s8 <= light0_y_s7;
                light0_z_s8 <= light0_z_s7;
                primitive_zero_uv_s8 <= primitive_zero_uv_s7;
                primitive_mirrored_s8 <= primitive_mirrored_s7;
                primitive_zero_area_s8 <= primitive_zero_area_s7;
                vertex_parallel_s8 <= vertex_parallel_s7;
                vertex_degenerate_s8 <= vertex_degenerate_s7;
                vertex_b_norm_x_s8 <= vertex_b_norm_x;
                vertex_b_norm_y_s8 <= vertex_b_norm_y;
                vertex_b_norm_z_s8 <= vertex_b_norm_z;
                vertex_n289_s8 <= vertex_n289_s7;
                vertex_ts_view_z_s8 <= vertex_ts_view_z_s7;
                vertex_ts_light0_z_s8 <= vertex_ts_light0_z_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- vertex.b_square
    vertex_b_square_n219 <= vertex_b_norm_x_s8 * vertex_b_norm_x_s8;
    vertex_b_square_n220 <= vertex_b_norm_y_s8 * vertex_b_norm_y_s8;
    vertex_b_square_n221 <= vertex_b_norm_z_s8 * vertex_b_norm_z_s8;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s9 <= normal_x_s8;
                normal_y_s9 <= normal_y_s8;
                normal_z_s9 <= normal_z_s8;
                view_x_s9 <= view_x_s8;
                view_y_s9 <= view_y_s8;
                view_z_s9 <= view_z_s8;
                light0_x_s9 <= light0_x_s8;
                light0_y_s9 <= light0_y_s8;
                light0_z_s9 <= light0_z_s8;
                primitive_zero_uv_s9 <= primitive_zero_uv_s8;
                primitive_mirrored_s9 <= primitive_mirrored_s8;
                primitive_zero_area_s9 <= primitive_zero_area_s8;
                vertex_parallel_s9 <= vertex_parallel_s8;
                vertex_degenerate_s9 <= vertex_degenerate_s8;
                vertex_b_norm_x_s9 <= vertex_b_norm_x_s8;
                vertex_b_norm_y_s9 <= vertex_b_norm_y_s8;
                vertex_b_norm_z_s9 <= vertex_b_norm_z_s8;
                vertex_b_square_n219_s9 <= vertex_b_square_n219;
                vertex_b_square_n220_s9 <= vertex_b_square_n220;
                vertex_b_square_n221_s9 <= vertex_b_square_n221;
                vertex_n289_s9 <= vertex_n289_s8;
                vertex_ts_view_z_s9 <= vertex_ts_view_z_s8;
                vertex_ts_light0_z_s9 <= vertex_ts_light0_z_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- vertex.b_square
    vertex_b_square_n222 <= resize(vertex_b_square_n219_s9, 37) + resize(vertex_b_square_n220_s9, 37);
    vertex_b_square_n223 <= resize(vertex_b_square_n222, 38) + resize(vertex_b_square_n221_s9, 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s10 <= normal_x_s9;
                normal_y_s10 <= normal_y_s9;
                normal_z_s10 <= normal_z_s9;
                view_x_s10 <= view_x_s9;
                view_y_s10 <= view_y_s9;
                view_z_s10 <= view_z_s9;
                light0_x_s10 <= light0_x_s9;
                light0_y_s10 <= light0_y_s9;
                light0_z_s10 <= light0_z_s9;
                primitive_zero_uv_s10 <= primitive_zero_uv_s9;
                primitive_mirrored_s10 <= primitive_mirrored_s9;
                primitive_zero_area_s10 <= primitive_zero_area_s9;
                vertex_parallel_s10 <= vertex_parallel_s9;
                vertex_degenerate_s10 <= vertex_degenerate_s9;
                vertex_b_norm_x_s10 <= vertex_b_norm_x_s9;
                vertex_b_norm_y_s10 <= vertex_b_norm_y_s9;
                vertex_b_norm_z_s10 <= vertex_b_norm_z_s9;
                vertex_b_square_n223_s10 <= vertex_b_square_n223;
                vertex_n289_s10 <= vertex_n289_s9;
                vertex_ts_view_z_s10 <= vertex_ts_view_z_s9;
                vertex_ts_light0_z_s10 <= vertex_ts_light0_z_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- vertex
    vertex_b_length_square_sum <= resize(vertex_b_square_n223_s10, 39) + 39x"0000002000";
    vertex_b_length_square_cut <= vertex_b_length_square_sum(38 downto 14);
    vertex_b_length_square_over <= "1" when vertex_b_length_square_cut(24) = '0' and (or vertex_b_length_square_cut(23 downto 22)) = '1' else "0";
    vertex_b_length_square_under <= unsigned(vertex_b_length_square_cut(24 downto 24));
    vertex_b_length_square <= 22x"3fffff" when vertex_b_length_square_over(0) = '1' else 22x"000000" when vertex_b_length_square_under(0) = '1' else unsigned(vertex_b_length_square_cut(21 downto 0));
    -- vertex.b_length
    vertex_b_length_n225 <= vertex_b_length_square;
    vertex_b_length_n226 <= vertex_b_length_n225;
    vertex_b_length_n227 <= vertex_b_length_n226(21 downto 6);
    vertex_b_length_n228 <= "1" when vertex_b_length_n227 = resize(primitive_n37, 16) else "0";
    vertex_b_length_n229 <= vertex_b_length_n226(5 downto 0);
    vertex_b_length_n230 <= vertex_b_length_n229 & vertex_b_n113;
    vertex_b_length_n231 <= vertex_b_length_n230 when vertex_b_length_n228(0) = '1' else vertex_b_length_n226;
    vertex_b_length_n232 <= vertex_b_length_n231(21 downto 14);
    vertex_b_length_n233 <= "1" when vertex_b_length_n232 = resize(primitive_n37, 8) else "0";
    vertex_b_length_n234 <= vertex_b_length_n231(13 downto 0);
    vertex_b_length_n235 <= vertex_b_length_n234 & vertex_b_n119;
    vertex_b_length_n247 <= vertex_b_length_n228 & vertex_b_length_n233;
    vertex_b_length_n267 <= "1" when vertex_b_length_square = shift_left(resize(primitive_n37, 22), 20) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s11 <= normal_x_s10;
                normal_y_s11 <= normal_y_s10;
                normal_z_s11 <= normal_z_s10;
                view_x_s11 <= view_x_s10;
                view_y_s11 <= view_y_s10;
                view_z_s11 <= view_z_s10;
                light0_x_s11 <= light0_x_s10;
                light0_y_s11 <= light0_y_s10;
                light0_z_s11 <= light0_z_s10;
                primitive_zero_uv_s11 <= primitive_zero_uv_s10;
                primitive_mirrored_s11 <= primitive_mirrored_s10;
                primitive_zero_area_s11 <= primitive_zero_area_s10;
                vertex_parallel_s11 <= vertex_parallel_s10;
                vertex_degenerate_s11 <= vertex_degenerate_s10;
                vertex_b_norm_x_s11 <= vertex_b_norm_x_s10;
                vertex_b_norm_y_s11 <= vertex_b_norm_y_s10;
                vertex_b_norm_z_s11 <= vertex_b_norm_z_s10;
                vertex_b_length_n231_s11 <= vertex_b_length_n231;
                vertex_b_length_n233_s11 <= vertex_b_length_n233;
                vertex_b_length_n235_s11 <= vertex_b_length_n235;
                vertex_b_length_n247_s11 <= vertex_b_length_n247;
                vertex_b_length_n267_s11 <= vertex_b_length_n267;
                vertex_n289_s11 <= vertex_n289_s10;
                vertex_ts_view_z_s11 <= vertex_ts_view_z_s10;
                vertex_ts_light0_z_s11 <= vertex_ts_light0_z_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- vertex.b_length
    vertex_b_length_n236 <= vertex_b_length_n235_s11 when vertex_b_length_n233_s11(0) = '1' else vertex_b_length_n231_s11;
    vertex_b_length_n237 <= vertex_b_length_n236(21 downto 18);
    vertex_b_length_n238 <= "1" when vertex_b_length_n237 = resize(primitive_n37, 4) else "0";
    vertex_b_length_n239 <= vertex_b_length_n236(17 downto 0);
    vertex_b_length_n240 <= vertex_b_length_n239 & vertex_b_n125;
    vertex_b_length_n241 <= vertex_b_length_n240 when vertex_b_length_n238(0) = '1' else vertex_b_length_n236;
    vertex_b_length_n242 <= vertex_b_length_n241(21 downto 20);
    vertex_b_length_n243 <= "1" when vertex_b_length_n242 = resize(primitive_n37, 2) else "0";
    vertex_b_length_n244 <= vertex_b_length_n241(19 downto 0);
    vertex_b_length_n245 <= vertex_b_length_n244 & vertex_b_n131;
    vertex_b_length_n246 <= vertex_b_length_n245 when vertex_b_length_n243(0) = '1' else vertex_b_length_n241;
    vertex_b_length_n248 <= vertex_b_length_n247_s11 & vertex_b_length_n238;
    vertex_b_length_n249 <= vertex_b_length_n248 & vertex_b_length_n243;
    vertex_b_length_n250 <= vertex_b_length_n246(21 downto 20);
    vertex_b_length_n252 <= signed(resize(vertex_b_length_n250, 3)) - signed(resize(vertex_b_length_n251, 3));
    vertex_b_length_n253 <= unsigned(vertex_b_length_n252(1 downto 0));
    vertex_b_length_n254 <= vertex_b_length_n246(19 downto 2);
    vertex_b_length_n255 <= vertex_b_length_n253 & vertex_b_length_n254;
    vertex_b_length_n256 <= vertex_b_length_n255;
    -- vertex.b_length.recip_root
    vertex_b_length_recip_root_n257 <= vertex_b_length_n256(19 downto 12);
    vertex_b_length_recip_root_n260 <= vertex_b_length_n256(11 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s12 <= normal_x_s11;
                normal_y_s12 <= normal_y_s11;
                normal_z_s12 <= normal_z_s11;
                view_x_s12 <= view_x_s11;
                view_y_s12 <= view_y_s11;
                view_z_s12 <= view_z_s11;
                light0_x_s12 <= light0_x_s11;
                light0_y_s12 <= light0_y_s11;
                light0_z_s12 <= light0_z_s11;
                primitive_zero_uv_s12 <= primitive_zero_uv_s11;
                primitive_mirrored_s12 <= primitive_mirrored_s11;
                primitive_zero_area_s12 <= primitive_zero_area_s11;
                vertex_parallel_s12 <= vertex_parallel_s11;
                vertex_degenerate_s12 <= vertex_degenerate_s11;
                vertex_b_norm_x_s12 <= vertex_b_norm_x_s11;
                vertex_b_norm_y_s12 <= vertex_b_norm_y_s11;
                vertex_b_norm_z_s12 <= vertex_b_norm_z_s11;
                vertex_b_length_n249_s12 <= vertex_b_length_n249;
                recip_root_row <= recip_root_rom(to_integer(vertex_b_length_recip_root_n257));
                vertex_b_length_recip_root_n260_s12 <= vertex_b_length_recip_root_n260;
                vertex_b_length_n267_s12 <= vertex_b_length_n267_s11;
                vertex_n289_s12 <= vertex_n289_s11;
                vertex_ts_view_z_s12 <= vertex_ts_view_z_s11;
                vertex_ts_light0_z_s12 <= vertex_ts_light0_z_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- vertex.b_length.recip_root
    vertex_b_length_recip_root_n258 <= recip_root_row(39 downto 17);
    vertex_b_length_recip_root_n259 <= signed(recip_root_row(16 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s13 <= normal_x_s12;
                normal_y_s13 <= normal_y_s12;
                normal_z_s13 <= normal_z_s12;
                view_x_s13 <= view_x_s12;
                view_y_s13 <= view_y_s12;
                view_z_s13 <= view_z_s12;
                light0_x_s13 <= light0_x_s12;
                light0_y_s13 <= light0_y_s12;
                light0_z_s13 <= light0_z_s12;
                primitive_zero_uv_s13 <= primitive_zero_uv_s12;
                primitive_mirrored_s13 <= primitive_mirrored_s12;
                primitive_zero_area_s13 <= primitive_zero_area_s12;
                vertex_parallel_s13 <= vertex_parallel_s12;
                vertex_degenerate_s13 <= vertex_degenerate_s12;
                vertex_b_norm_x_s13 <= vertex_b_norm_x_s12;
                vertex_b_norm_y_s13 <= vertex_b_norm_y_s12;
                vertex_b_norm_z_s13 <= vertex_b_norm_z_s12;
                vertex_b_length_n249_s13 <= vertex_b_length_n249_s12;
                vertex_b_length_recip_root_n258_s13 <= vertex_b_length_recip_root_n258;
                vertex_b_length_recip_root_n259_s13 <= vertex_b_length_recip_root_n259;
                vertex_b_length_recip_root_n260_s13 <= vertex_b_length_recip_root_n260_s12;
                vertex_b_length_n267_s13 <= vertex_b_length_n267_s12;
                vertex_n289_s13 <= vertex_n289_s12;
                vertex_ts_view_z_s13 <= vertex_ts_view_z_s12;
                vertex_ts_light0_z_s13 <= vertex_ts_light0_z_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- vertex.b_length.recip_root
    vertex_b_length_recip_root_n261 <= resize(vertex_b_length_recip_root_n259_s13 * signed('0' & vertex_b_length_recip_root_n260_s13), 29);
    vertex_b_length_recip_root_n262 <= signed(shift_left(resize(vertex_b_length_recip_root_n258_s13, 37), 12)) + resize(vertex_b_length_recip_root_n261, 37);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s14 <= normal_x_s13;
                normal_y_s14 <= normal_y_s13;
                normal_z_s14 <= normal_z_s13;
                view_x_s14 <= view_x_s13;
                view_y_s14 <= view_y_s13;
                view_z_s14 <= view_z_s13;
                light0_x_s14 <= light0_x_s13;
                light0_y_s14 <= light0_y_s13;
                light0_z_s14 <= light0_z_s13;
                primitive_zero_uv_s14 <= primitive_zero_uv_s13;
                primitive_mirrored_s14 <= primitive_mirrored_s13;
                primitive_zero_area_s14 <= primitive_zero_area_s13;
                vertex_parallel_s14 <= vertex_parallel_s13;
                vertex_degenerate_s14 <= vertex_degenerate_s13;
                vertex_b_norm_x_s14 <= vertex_b_norm_x_s13;
                vertex_b_norm_y_s14 <= vertex_b_norm_y_s13;
                vertex_b_norm_z_s14 <= vertex_b_norm_z_s13;
                vertex_b_length_n249_s14 <= vertex_b_length_n249_s13;
                vertex_b_length_recip_root_n262_s14 <= vertex_b_length_recip_root_n262;
                vertex_b_length_n267_s14 <= vertex_b_length_n267_s13;
                vertex_n289_s14 <= vertex_n289_s13;
                vertex_ts_view_z_s14 <= vertex_ts_view_z_s13;
                vertex_ts_light0_z_s14 <= vertex_ts_light0_z_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- vertex.b_length.recip_root
    vertex_b_length_recip_root_n263_sum <= resize(vertex_b_length_recip_root_n262_s14, 38) + 38x"0000002000";
    vertex_b_length_recip_root_n263_cut <= vertex_b_length_recip_root_n263_sum(37 downto 14);
    vertex_b_length_recip_root_n263_over <= "1" when vertex_b_length_recip_root_n263_cut(23) = '0' and (or vertex_b_length_recip_root_n263_cut(22 downto 22)) = '1' else "0";
    vertex_b_length_recip_root_n263_under <= unsigned(vertex_b_length_recip_root_n263_cut(23 downto 23));
    vertex_b_length_recip_root_n263 <= 22x"3fffff" when vertex_b_length_recip_root_n263_over(0) = '1' else 22x"000000" when vertex_b_length_recip_root_n263_under(0) = '1' else unsigned(vertex_b_length_recip_root_n263_cut(21 downto 0));
    -- vertex.b_length
    vertex_b_length_n264_past <= "1" when 4x"b" < vertex_b_length_n249_s14 else "0";
    vertex_b_length_n264_count <= 4x"b" when vertex_b_length_n264_past(0) = '1' else vertex_b_length_n249_s14;
    vertex_b_length_n264 <= shift_left(resize(vertex_b_length_recip_root_n263, 33), to_integer(vertex_b_length_n264_count));
    vertex_b_length_n265 <= vertex_b_length_n264;
    vertex_b_length_n268 <= shift_left(resize(vertex_b_length_n266, 33), 23) when vertex_b_length_n267_s14(0) = '1' else vertex_b_length_n265;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s15 <= normal_x_s14;
                normal_y_s15 <= normal_y_s14;
                normal_z_s15 <= normal_z_s14;
                view_x_s15 <= view_x_s14;
                view_y_s15 <= view_y_s14;
                view_z_s15 <= view_z_s14;
                light0_x_s15 <= light0_x_s14;
                light0_y_s15 <= light0_y_s14;
                light0_z_s15 <= light0_z_s14;
                primitive_zero_uv_s15 <= primitive_zero_uv_s14;
                primitive_mirrored_s15 <= primitive_mirrored_s14;
                primitive_zero_area_s15 <= primitive_zero_area_s14;
                vertex_parallel_s15 <= vertex_parallel_s14;
                vertex_degenerate_s15 <= vertex_degenerate_s14;
                vertex_b_norm_x_s15 <= vertex_b_norm_x_s14;
                vertex_b_norm_y_s15 <= vertex_b_norm_y_s14;
                vertex_b_norm_z_s15 <= vertex_b_norm_z_s14;
                vertex_b_length_n268_s15 <= vertex_b_length_n268;
                vertex_n289_s15 <= vertex_n289_s14;
                vertex_ts_view_z_s15 <= vertex_ts_view_z_s14;
                vertex_ts_light0_z_s15 <= vertex_ts_light0_z_s14;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- vertex.b_length
    vertex_b_length_b_length_sum <= resize(vertex_b_length_n268_s15, 34) + 34x"000000004";
    vertex_b_length_b_length_cut <= vertex_b_length_b_length_sum(33 downto 3);
    vertex_b_length_b_length_over <= "1" when (or vertex_b_length_b_length_cut(30 downto 20)) = '1' else "0";
    vertex_b_length_b_length <= 20x"fffff" when vertex_b_length_b_length_over(0) = '1' else vertex_b_length_b_length_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s16 <= normal_x_s15;
                normal_y_s16 <= normal_y_s15;
                normal_z_s16 <= normal_z_s15;
                view_x_s16 <= view_x_s15;
                view_y_s16 <= view_y_s15;
                view_z_s16 <= view_z_s15;
                light0_x_s16 <= light0_x_s15;
                light0_y_s16 <= light0_y_s15;
                light0_z_s16 <= light0_z_s15;
                primitive_zero_uv_s16 <= primitive_zero_uv_s15;
                primitive_mirrored_s16 <= primitive_mirrored_s15;
                primitive_zero_area_s16 <= primitive_zero_area_s15;
                vertex_parallel_s16 <= vertex_parallel_s15;
                vertex_degenerate_s16 <= vertex_degenerate_s15;
                vertex_b_norm_x_s16 <= vertex_b_norm_x_s15;
                vertex_b_norm_y_s16 <= vertex_b_norm_y_s15;
                vertex_b_norm_z_s16 <= vertex_b_norm_z_s15;
                vertex_b_length_b_length_s16 <= vertex_b_length_b_length;
                vertex_n289_s16 <= vertex_n289_s15;
                vertex_ts_view_z_s16 <= vertex_ts_view_z_s15;
                vertex_ts_light0_z_s16 <= vertex_ts_light0_z_s15;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- vertex
    vertex_n270 <= resize(vertex_b_norm_x_s16 * signed('0' & vertex_b_length_b_length_s16), 38);
    vertex_n272 <= resize(vertex_b_norm_y_s16 * signed('0' & vertex_b_length_b_length_s16), 38);
    vertex_n274 <= resize(vertex_b_norm_z_s16 * signed('0' & vertex_b_length_b_length_s16), 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s17 <= normal_x_s16;
                normal_y_s17 <= normal_y_s16;
                normal_z_s17 <= normal_z_s16;
                view_x_s17 <= view_x_s16;
                view_y_s17 <= view_y_s16;
                view_z_s17 <= view_z_s16;
                light0_x_s17 <= light0_x_s16;
                light0_y_s17 <= light0_y_s16;
                light0_z_s17 <= light0_z_s16;
                primitive_zero_uv_s17 <= primitive_zero_uv_s16;
                primitive_mirrored_s17 <= primitive_mirrored_s16;
                primitive_zero_area_s17 <= primitive_zero_area_s16;
                vertex_parallel_s17 <= vertex_parallel_s16;
                vertex_degenerate_s17 <= vertex_degenerate_s16;
                vertex_n270_s17 <= vertex_n270;
                vertex_n272_s17 <= vertex_n272;
                vertex_n274_s17 <= vertex_n274;
                vertex_n289_s17 <= vertex_n289_s16;
                vertex_ts_view_z_s17 <= vertex_ts_view_z_s16;
                vertex_ts_light0_z_s17 <= vertex_ts_light0_z_s16;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- vertex
    vertex_b_unit_x_sum <= resize(vertex_n270_s17, 39) + 39x"0000040000";
    vertex_b_unit_x_cut <= vertex_b_unit_x_sum(38 downto 19);
    vertex_b_unit_x_over <= "1" when vertex_b_unit_x_cut(19) = '0' and (or vertex_b_unit_x_cut(18 downto 17)) = '1' else "0";
    vertex_b_unit_x_under <= "1" when vertex_b_unit_x_cut(19) = '1' and (and vertex_b_unit_x_cut(18 downto 17)) = '0' else "0";
    vertex_b_unit_x <= 18x"1ffff" when vertex_b_unit_x_over(0) = '1' else 18x"20000" when vertex_b_unit_x_under(0) = '1' else vertex_b_unit_x_cut(17 downto 0);
    vertex_b_unit_y_sum <= resize(vertex_n272_s17, 39) + 39x"0000040000";
    vertex_b_unit_y_cut <= vertex_b_unit_y_sum(38 downto 19);
    vertex_b_unit_y_over <= "1" when vertex_b_unit_y_cut(19) = '0' and (or vertex_b_unit_y_cut(18 downto 17)) = '1' else "0";
    vertex_b_unit_y_under <= "1" when vertex_b_unit_y_cut(19) = '1' and (and vertex_b_unit_y_cut(18 downto 17)) = '0' else "0";
    vertex_b_unit_y <= 18x"1ffff" when vertex_b_unit_y_over(0) = '1' else 18x"20000" when vertex_b_unit_y_under(0) = '1' else vertex_b_unit_y_cut(17 downto 0);
    vertex_b_unit_z_sum <= resize(vertex_n274_s17, 39) + 39x"0000040000";
    vertex_b_unit_z_cut <= vertex_b_unit_z_sum(38 downto 19);
    vertex_b_unit_z_over <= "1" when vertex_b_unit_z_cut(19) = '0' and (or vertex_b_unit_z_cut(18 downto 17)) = '1' else "0";
    vertex_b_unit_z_under <= "1" when vertex_b_unit_z_cut(19) = '1' and (and vertex_b_unit_z_cut(18 downto 17)) = '0' else "0";
    vertex_b_unit_z <= 18x"1ffff" when vertex_b_unit_z_over(0) = '1' else 18x"20000" when vertex_b_unit_z_under(0) = '1' else vertex_b_unit_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s18 <= normal_x_s17;
                normal_y_s18 <= normal_y_s17;
                normal_z_s18 <= normal_z_s17;
                view_x_s18 <= view_x_s17;
                view_y_s18 <= view_y_s17;
                view_z_s18 <= view_z_s17;
                light0_x_s18 <= light0_x_s17;
                light0_y_s18 <= light0_y_s17;
                light0_z_s18 <= light0_z_s17;
                primitive_zero_uv_s18 <= primitive_zero_uv_s17;
                primitive_mirrored_s18 <= primitive_mirrored_s17;
                primitive_zero_area_s18 <= primitive_zero_area_s17;
                vertex_parallel_s18 <= vertex_parallel_s17;
                vertex_degenerate_s18 <= vertex_degenerate_s17;
                vertex_b_unit_x_s18 <= vertex_b_unit_x;
                vertex_b_unit_y_s18 <= vertex_b_unit_y;
                vertex_b_unit_z_s18 <= vertex_b_unit_z;
                vertex_n289_s18 <= vertex_n289_s17;
                vertex_ts_view_z_s18 <= vertex_ts_view_z_s17;
                vertex_ts_light0_z_s18 <= vertex_ts_light0_z_s17;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- vertex.b_cross_n
    vertex_b_cross_n_n276 <= vertex_b_unit_y_s18 * normal_z_s18;
    vertex_b_cross_n_n277 <= vertex_b_unit_z_s18 * normal_y_s18;
    vertex_b_cross_n_n279 <= vertex_b_unit_z_s18 * normal_x_s18;
    vertex_b_cross_n_n280 <= vertex_b_unit_x_s18 * normal_z_s18;
    vertex_b_cross_n_n282 <= vertex_b_unit_x_s18 * normal_y_s18;
    vertex_b_cross_n_n283 <= vertex_b_unit_y_s18 * normal_x_s18;
    -- vertex.ts_view_b
    vertex_ts_view_b_n305 <= vertex_b_unit_x_s18 * view_x_s18;
    vertex_ts_view_b_n306 <= vertex_b_unit_y_s18 * view_y_s18;
    vertex_ts_view_b_n307 <= vertex_b_unit_z_s18 * view_z_s18;
    -- vertex.ts_light0_b
    vertex_ts_light0_b_n323 <= vertex_b_unit_x_s18 * light0_x_s18;
    vertex_ts_light0_b_n324 <= vertex_b_unit_y_s18 * light0_y_s18;
    vertex_ts_light0_b_n325 <= vertex_b_unit_z_s18 * light0_z_s18;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s19 <= normal_x_s18;
                normal_y_s19 <= normal_y_s18;
                normal_z_s19 <= normal_z_s18;
                view_x_s19 <= view_x_s18;
                view_y_s19 <= view_y_s18;
                view_z_s19 <= view_z_s18;
                light0_x_s19 <= light0_x_s18;
                light0_y_s19 <= light0_y_s18;
                light0_z_s19 <= light0_z_s18;
                primitive_zero_uv_s19 <= primitive_zero_uv_s18;
                primitive_mirrored_s19 <= primitive_mirrored_s18;
                primitive_zero_area_s19 <= primitive_zero_area_s18;
                vertex_parallel_s19 <= vertex_parallel_s18;
                vertex_degenerate_s19 <= vertex_degenerate_s18;
                vertex_b_unit_x_s19 <= vertex_b_unit_x_s18;
                vertex_b_unit_y_s19 <= vertex_b_unit_y_s18;
                vertex_b_unit_z_s19 <= vertex_b_unit_z_s18;
                vertex_b_cross_n_n276_s19 <= vertex_b_cross_n_n276;
                vertex_b_cross_n_n277_s19 <= vertex_b_cross_n_n277;
                vertex_b_cross_n_n279_s19 <= vertex_b_cross_n_n279;
                vertex_b_cross_n_n280_s19 <= vertex_b_cross_n_n280;
                vertex_b_cross_n_n282_s19 <= vertex_b_cross_n_n282;
                vertex_b_cross_n_n283_s19 <= vertex_b_cross_n_n283;
                vertex_n289_s19 <= vertex_n289_s18;
                vertex_ts_view_b_n305_s19 <= vertex_ts_view_b_n305;
                vertex_ts_view_b_n306_s19 <= vertex_ts_view_b_n306;
                vertex_ts_view_b_n307_s19 <= vertex_ts_view_b_n307;
                vertex_ts_view_z_s19 <= vertex_ts_view_z_s18;
                vertex_ts_light0_b_n323_s19 <= vertex_ts_light0_b_n323;
                vertex_ts_light0_b_n324_s19 <= vertex_ts_light0_b_n324;
                vertex_ts_light0_b_n325_s19 <= vertex_ts_light0_b_n325;
                vertex_ts_light0_z_s19 <= vertex_ts_light0_z_s18;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- vertex.b_cross_n
    vertex_b_cross_n_n278 <= resize(vertex_b_cross_n_n276_s19, 35) - resize(vertex_b_cross_n_n277_s19, 35);
    vertex_b_cross_n_n281 <= resize(vertex_b_cross_n_n279_s19, 35) - resize(vertex_b_cross_n_n280_s19, 35);
    vertex_b_cross_n_n284 <= resize(vertex_b_cross_n_n282_s19, 35) - resize(vertex_b_cross_n_n283_s19, 35);
    -- vertex
    vertex_n285_sum <= resize(vertex_b_cross_n_n278, 36) + 36x"000002000";
    vertex_n285_cut <= vertex_n285_sum(35 downto 14);
    vertex_n285_over <= "1" when vertex_n285_cut(21) = '0' and (or vertex_n285_cut(20 downto 18)) = '1' else "0";
    vertex_n285_under <= "1" when vertex_n285_cut(21) = '1' and (and vertex_n285_cut(20 downto 18)) = '0' else "0";
    vertex_n285 <= 19x"3ffff" when vertex_n285_over(0) = '1' else 19x"40000" when vertex_n285_under(0) = '1' else vertex_n285_cut(18 downto 0);
    vertex_n286_sum <= resize(vertex_b_cross_n_n281, 36) + 36x"000002000";
    vertex_n286_cut <= vertex_n286_sum(35 downto 14);
    vertex_n286_over <= "1" when vertex_n286_cut(21) = '0' and (or vertex_n286_cut(20 downto 18)) = '1' else "0";
    vertex_n286_under <= "1" when vertex_n286_cut(21) = '1' and (and vertex_n286_cut(20 downto 18)) = '0' else "0";
    vertex_n286 <= 19x"3ffff" when vertex_n286_over(0) = '1' else 19x"40000" when vertex_n286_under(0) = '1' else vertex_n286_cut(18 downto 0);
    vertex_n287_sum <= resize(vertex_b_cross_n_n284, 36) + 36x"000002000";
    vertex_n287_cut <= vertex_n287_sum(35 downto 14);
    vertex_n287_over <= "1" when vertex_n287_cut(21) = '0' and (or vertex_n287_cut(20 downto 18)) = '1' else "0";
    vertex_n287_under <= "1" when vertex_n287_cut(21) = '1' and (and vertex_n287_cut(20 downto 18)) = '0' else "0";
    vertex_n287 <= 19x"3ffff" when vertex_n287_over(0) = '1' else 19x"40000" when vertex_n287_under(0) = '1' else vertex_n287_cut(18 downto 0);
    vertex_n290 <= -resize(vertex_n285, 20);
    vertex_n293 <= -resize(vertex_n286, 20);
    vertex_n296 <= -resize(vertex_n287, 20);
    -- vertex.ts_view_b
    vertex_ts_view_b_n308 <= resize(vertex_ts_view_b_n305_s19, 35) + resize(vertex_ts_view_b_n306_s19, 35);
    vertex_ts_view_b_n309 <= resize(vertex_ts_view_b_n308, 36) + resize(vertex_ts_view_b_n307_s19, 36);
    -- vertex.ts_light0_b
    vertex_ts_light0_b_n326 <= resize(vertex_ts_light0_b_n323_s19, 35) + resize(vertex_ts_light0_b_n324_s19, 35);
    vertex_ts_light0_b_n327 <= resize(vertex_ts_light0_b_n326, 36) + resize(vertex_ts_light0_b_n325_s19, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s20 <= normal_x_s19;
                normal_y_s20 <= normal_y_s19;
                normal_z_s20 <= normal_z_s19;
                view_x_s20 <= view_x_s19;
                view_y_s20 <= view_y_s19;
                view_z_s20 <= view_z_s19;
                light0_x_s20 <= light0_x_s19;
                light0_y_s20 <= light0_y_s19;
                light0_z_s20 <= light0_z_s19;
                primitive_zero_uv_s20 <= primitive_zero_uv_s19;
                primitive_mirrored_s20 <= primitive_mirrored_s19;
                primitive_zero_area_s20 <= primitive_zero_area_s19;
                vertex_parallel_s20 <= vertex_parallel_s19;
                vertex_degenerate_s20 <= vertex_degenerate_s19;
                vertex_b_unit_x_s20 <= vertex_b_unit_x_s19;
                vertex_b_unit_y_s20 <= vertex_b_unit_y_s19;
                vertex_b_unit_z_s20 <= vertex_b_unit_z_s19;
                vertex_n285_s20 <= vertex_n285;
                vertex_n286_s20 <= vertex_n286;
                vertex_n287_s20 <= vertex_n287;
                vertex_n289_s20 <= vertex_n289_s19;
                vertex_n290_s20 <= vertex_n290;
                vertex_n293_s20 <= vertex_n293;
                vertex_n296_s20 <= vertex_n296;
                vertex_ts_view_b_n309_s20 <= vertex_ts_view_b_n309;
                vertex_ts_view_z_s20 <= vertex_ts_view_z_s19;
                vertex_ts_light0_b_n327_s20 <= vertex_ts_light0_b_n327;
                vertex_ts_light0_z_s20 <= vertex_ts_light0_z_s19;
            end if;
            if rst = '1' then
                valid_s20 <= '0';
            elsif ce = '1' then
                valid_s20 <= valid_s19;
            end if;
        end if;
    end process;

    -- ---- stage 20 ----
    -- vertex
    vertex_n291 <= vertex_n290_s20 when vertex_n289_s20(0) = '1' else resize(vertex_n285_s20, 20);
    vertex_n292_over <= "1" when vertex_n291(19) = '0' and (or vertex_n291(18 downto 18)) = '1' else "0";
    vertex_n292_under <= "1" when vertex_n291(19) = '1' and (and vertex_n291(18 downto 18)) = '0' else "0";
    vertex_n292 <= 19x"3ffff" when vertex_n292_over(0) = '1' else 19x"40000" when vertex_n292_under(0) = '1' else vertex_n291(18 downto 0);
    vertex_n294 <= vertex_n293_s20 when vertex_n289_s20(0) = '1' else resize(vertex_n286_s20, 20);
    vertex_n295_over <= "1" when vertex_n294(19) = '0' and (or vertex_n294(18 downto 18)) = '1' else "0";
    vertex_n295_under <= "1" when vertex_n294(19) = '1' and (and vertex_n294(18 downto 18)) = '0' else "0";
    vertex_n295 <= 19x"3ffff" when vertex_n295_over(0) = '1' else 19x"40000" when vertex_n295_under(0) = '1' else vertex_n294(18 downto 0);
    vertex_n297 <= vertex_n296_s20 when vertex_n289_s20(0) = '1' else resize(vertex_n287_s20, 20);
    vertex_n298_over <= "1" when vertex_n297(19) = '0' and (or vertex_n297(18 downto 18)) = '1' else "0";
    vertex_n298_under <= "1" when vertex_n297(19) = '1' and (and vertex_n297(18 downto 18)) = '0' else "0";
    vertex_n298 <= 19x"3ffff" when vertex_n298_over(0) = '1' else 19x"40000" when vertex_n298_under(0) = '1' else vertex_n297(18 downto 0);
    -- vertex.ts_view_t
    vertex_ts_view_t_n299 <= vertex_n292 * view_x_s20;
    vertex_ts_view_t_n300 <= vertex_n295 * view_y_s20;
    vertex_ts_view_t_n301 <= vertex_n298 * view_z_s20;
    -- vertex
    vertex_ts_view_y_sum <= resize(vertex_ts_view_b_n309_s20, 37) + 37x"0000008000";
    vertex_ts_view_y_cut <= vertex_ts_view_y_sum(36 downto 16);
    vertex_ts_view_y_over <= "1" when vertex_ts_view_y_cut(20) = '0' and (or vertex_ts_view_y_cut(19 downto 18)) = '1' else "0";
    vertex_ts_view_y_under <= "1" when vertex_ts_view_y_cut(20) = '1' and (and vertex_ts_view_y_cut(19 downto 18)) = '0' else "0";
    vertex_ts_view_y <= 19x"3ffff" when vertex_ts_view_y_over(0) = '1' else 19x"40000" when vertex_ts_view_y_under(0) = '1' else vertex_ts_view_y_cut(18 downto 0);
    -- vertex.ts_light0_t
    vertex_ts_light0_t_n317 <= vertex_n292 * light0_x_s20;
    vertex_ts_light0_t_n318 <= vertex_n295 * light0_y_s20;
    vertex_ts_light0_t_n319 <= vertex_n298 * light0_z_s20;
    -- vertex
    vertex_ts_light0_y_sum <= resize(vertex_ts_light0_b_n327_s20, 37) + 37x"0000008000";
    vertex_ts_light0_y_cut <= vertex_ts_light0_y_sum(36 downto 16);
    vertex_ts_light0_y_over <= "1" when vertex_ts_light0_y_cut(20) = '0' and (or vertex_ts_light0_y_cut(19 downto 18)) = '1' else "0";
    vertex_ts_light0_y_under <= "1" when vertex_ts_light0_y_cut(20) = '1' and (and vertex_ts_light0_y_cut(19 downto 18)) = '0' else "0";
    vertex_ts_light0_y <= 19x"3ffff" when vertex_ts_light0_y_over(0) = '1' else 19x"40000" when vertex_ts_light0_y_under(0) = '1' else vertex_ts_light0_y_cut(18 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s21 <= normal_x_s20;
                normal_y_s21 <= normal_y_s20;
                normal_z_s21 <= normal_z_s20;
                primitive_zero_uv_s21 <= primitive_zero_uv_s20;
                primitive_mirrored_s21 <= primitive_mirrored_s20;
                primitive_zero_area_s21 <= primitive_zero_area_s20;
                vertex_parallel_s21 <= vertex_parallel_s20;
                vertex_degenerate_s21 <= vertex_degenerate_s20;
                vertex_b_unit_x_s21 <= vertex_b_unit_x_s20;
                vertex_b_unit_y_s21 <= vertex_b_unit_y_s20;
                vertex_b_unit_z_s21 <= vertex_b_unit_z_s20;
                vertex_n292_s21 <= vertex_n292;
                vertex_n295_s21 <= vertex_n295;
                vertex_n298_s21 <= vertex_n298;
                vertex_ts_view_t_n299_s21 <= vertex_ts_view_t_n299;
                vertex_ts_view_t_n300_s21 <= vertex_ts_view_t_n300;
                vertex_ts_view_t_n301_s21 <= vertex_ts_view_t_n301;
                vertex_ts_view_y_s21 <= vertex_ts_view_y;
                vertex_ts_view_z_s21 <= vertex_ts_view_z_s20;
                vertex_ts_light0_t_n317_s21 <= vertex_ts_light0_t_n317;
                vertex_ts_light0_t_n318_s21 <= vertex_ts_light0_t_n318;
                vertex_ts_light0_t_n319_s21 <= vertex_ts_light0_t_n319;
                vertex_ts_light0_y_s21 <= vertex_ts_light0_y;
                vertex_ts_light0_z_s21 <= vertex_ts_light0_z_s20;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----
    -- vertex.ts_view_t
    vertex_ts_view_t_n302 <= resize(vertex_ts_view_t_n299_s21, 36) + resize(vertex_ts_view_t_n300_s21, 36);
    vertex_ts_view_t_n303 <= resize(vertex_ts_view_t_n302, 37) + resize(vertex_ts_view_t_n301_s21, 37);
    -- vertex.ts_light0_t
    vertex_ts_light0_t_n320 <= resize(vertex_ts_light0_t_n317_s21, 36) + resize(vertex_ts_light0_t_n318_s21, 36);
    vertex_ts_light0_t_n321 <= resize(vertex_ts_light0_t_n320, 37) + resize(vertex_ts_light0_t_n319_s21, 37);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                normal_x_s22 <= normal_x_s21;
                normal_y_s22 <= normal_y_s21;
                normal_z_s22 <= normal_z_s21;
                primitive_zero_uv_s22 <= primitive_zero_uv_s21;
                primitive_mirrored_s22 <= primitive_mirrored_s21;
                primitive_zero_area_s22 <= primitive_zero_area_s21;
                vertex_parallel_s22 <= vertex_parallel_s21;
                vertex_degenerate_s22 <= vertex_degenerate_s21;
                vertex_b_unit_x_s22 <= vertex_b_unit_x_s21;
                vertex_b_unit_y_s22 <= vertex_b_unit_y_s21;
                vertex_b_unit_z_s22 <= vertex_b_unit_z_s21;
                vertex_n292_s22 <= vertex_n292_s21;
                vertex_n295_s22 <= vertex_n295_s21;
                vertex_n298_s22 <= vertex_n298_s21;
                vertex_ts_view_t_n303_s22 <= vertex_ts_view_t_n303;
                vertex_ts_view_y_s22 <= vertex_ts_view_y_s21;
                vertex_ts_view_z_s22 <= vertex_ts_view_z_s21;
                vertex_ts_light0_t_n321_s22 <= vertex_ts_light0_t_n321;
                vertex_ts_light0_y_s22 <= vertex_ts_light0_y_s21;
                vertex_ts_light0_z_s22 <= vertex_ts_light0_z_s21;
            end if;
            if rst = '1' then
                valid_s22 <= '0';
            elsif ce = '1' then
                valid_s22 <= valid_s21;
            end if;
        end if;
    end process;

    -- ---- stage 22 ----
    -- vertex
    vertex_ts_view_x_sum <= resize(vertex_ts_view_t_n303_s22, 38) + 38x"0000008000";
    vertex_ts_view_x_cut <= vertex_ts_view_x_sum(37 downto 16);
    vertex_ts_view_x_over <= "1" when vertex_ts_view_x_cut(21) = '0' and (or vertex_ts_view_x_cut(20 downto 18)) = '1' else "0";
    vertex_ts_view_x_under <= "1" when vertex_ts_view_x_cut(21) = '1' and (and vertex_ts_view_x_cut(20 downto 18)) = '0' else "0";
    vertex_ts_view_x <= 19x"3ffff" when vertex_ts_view_x_over(0) = '1' else 19x"40000" when vertex_ts_view_x_under(0) = '1' else vertex_ts_view_x_cut(18 downto 0);
    vertex_ts_light0_x_sum <= resize(vertex_ts_light0_t_n321_s22, 38) + 38x"0000008000";
    vertex_ts_light0_x_cut <= vertex_ts_light0_x_sum(37 downto 16);
    vertex_ts_light0_x_over <= "1" when vertex_ts_light0_x_cut(21) = '0' and (or vertex_ts_light0_x_cut(20 downto 18)) = '1' else "0";
    vertex_ts_light0_x_under <= "1" when vertex_ts_light0_x_cut(21) = '1' and (and vertex_ts_light0_x_cut(20 downto 18)) = '0' else "0";
    vertex_ts_light0_x <= 19x"3ffff" when vertex_ts_light0_x_over(0) = '1' else 19x"40000" when vertex_ts_light0_x_under(0) = '1' else vertex_ts_light0_x_cut(18 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                n_x <= normal_x_s22;
                n_y <= normal_y_s22;
                n_z <= normal_z_s22;
                zero_uv <= primitive_zero_uv_s22;
                mirrored <= primitive_mirrored_s22;
                zero_area <= primitive_zero_area_s22;
                parallel <= vertex_parallel_s22;
                degenerate <= vertex_degenerate_s22;
                b_x <= vertex_b_unit_x_s22;
                b_y <= vertex_b_unit_y_s22;
                b_z <= vertex_b_unit_z_s22;
                t_x <= vertex_n292_s22;
                t_y <= vertex_n295_s22;
                t_z <= vertex_n298_s22;
                ts_view_x <= vertex_ts_view_x;
                ts_view_y <= vertex_ts_view_y_s22;
                ts_view_z <= vertex_ts_view_z_s22;
                ts_light0_x <= vertex_ts_light0_x;
                ts_light0_y <= vertex_ts_light0_y_s22;
                ts_light0_z <= vertex_ts_light0_z_s22;
            end if;
            if rst = '1' then
                valid_s23 <= '0';
            elsif ce = '1' then
                valid_s23 <= valid_s22;
            end if;
        end if;
    end process;

    -- ---- stage 23 ----

    valid_out <= valid_s23;
end architecture;
