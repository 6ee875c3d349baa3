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
--   t_angle: mean 6.44e-6 rad, largest seen 2.07e-5 rad at p0_x=10112 p0_y=-13087 p0_z=1777 p1_x=9474 p1_y=-12645 p1_z=1634 p2_x=9790 p2_y=-12829 p2_z=1369 uv0_u=-4264 uv0_v=10910 uv1_u=-4558 uv1_v=11772 uv2_u=-7611 uv2_v=11483 view_x=548 view_y=17311 view_z=12049 light0_x=1261 light0_y=5545 light0_z=2155
--   t_dot: mean 8.59e-6, largest seen 2.48e-5 at p0_x=1385 p0_y=12631 p0_z=-15491 p1_x=1521 p1_y=12473 p1_z=-15566 p2_x=1244 p2_y=12281 p2_z=-15784 uv0_u=-12255 uv0_v=18727 uv1_u=-10160 uv1_v=16132 uv2_u=-10611 uv2_v=14849 view_x=8012 view_y=-2458 view_z=2986 light0_x=-3484 light0_y=-3984 light0_z=-834
--   t_x: mean 4.38e-6, largest seen 2.05e-5 (1.3 ulp) at p0_x=8845 p0_y=-7357 p0_z=8918 p1_x=8982 p1_y=-7495 p1_z=8835 p2_x=8642 p2_y=-7486 p2_z=8723 uv0_u=7356 uv0_v=-1510 uv1_u=861 uv1_v=-14978 uv2_u=1714 uv2_v=-6705 view_x=21907 view_y=8320 view_z=3195 light0_x=-2207 light0_y=-1467 light0_z=9923
--   t_y: mean 4.38e-6, largest seen 1.98e-5 (1.3 ulp) at p0_x=-2916 p0_y=-2788 p0_z=-14527 p1_x=-2891 p1_y=-2951 p1_z=-14658 p2_x=-2936 p2_y=-2975 p2_z=-14683 uv0_u=13249 uv0_v=-3283 uv1_u=11297 uv1_v=-4440 uv2_u=10686 uv2_v=-3368 view_x=21236 view_y=-6071 view_z=19473 light0_x=-3237 light0_y=1137 light0_z=-6504
--   t_z: mean 4.37e-6, largest seen 2.11e-5 (1.4 ulp) at p0_x=582 p0_y=524 p0_z=6901 p1_x=726 p1_y=573 p1_z=7248 p2_x=617 p2_y=494 p2_z=6888 uv0_u=-4050 uv0_v=10840 uv1_u=-4012 uv1_v=10792 uv2_u=-4035 uv2_v=10797 view_x=4349 view_y=-3883 view_z=-2073 light0_x=3612 light0_y=-5188 light0_z=3156
--   b_angle: mean 8.42e-6 rad, largest seen 2.71e-5 rad at p0_x=1963 p0_y=-5912 p0_z=3005 p1_x=-2419 p1_y=-29264 p1_z=3178 p2_x=3140 p2_y=-14491 p2_z=-9385 uv0_u=-12799 uv0_v=-14422 uv1_u=-12907 uv1_v=-14588 uv2_u=-12803 uv2_v=-14411 view_x=19836 view_y=17280 view_z=-21533 light0_x=13751 light0_y=-21034 light0_z=22968
--   b_dot: mean 1.24e-5, largest seen 4.31e-5 at p0_x=-8559 p0_y=3166 p0_z=9556 p1_x=-8963 p1_y=3337 p1_z=9804 p2_x=-9467 p2_y=3695 p2_z=9468 uv0_u=-3765 uv0_v=1694 uv1_u=-398 uv1_v=210 uv2_u=-3397 uv2_v=239 view_x=-9751 view_y=7042 view_z=-6135 light0_x=-5164 light0_y=-18281 light0_z=2614
--   b_x: mean 6.23e-6, largest seen 3.58e-5 (2.3 ulp) at p0_x=-12491 p0_y=-10859 p0_z=770 p1_x=-12550 p1_y=-10848 p1_z=767 p2_x=-12546 p2_y=-10988 p2_z=739 uv0_u=4382 uv0_v=-5922 uv1_u=4734 uv1_v=-5405 uv2_u=4929 uv2_v=-5360 view_x=-2703 view_y=-1919 view_z=-3268 light0_x=-11057 light0_y=-18078 light0_z=5818
--   b_y: mean 6.24e-6, largest seen 3.57e-5 (2.3 ulp) at p0_x=-5519 p0_y=-6920 p0_z=-16251 p1_x=-6543 p1_y=-10156 p1_z=-12356 p2_x=-3878 p2_y=-9401 p2_z=-17652 uv0_u=16327 uv0_v=1287 uv1_u=16274 uv1_v=1188 uv2_u=16300 uv2_v=1216 view_x=-11982 view_y=-3585 view_z=8239 light0_x=14579 light0_y=-4365 light0_z=-1654
--   b_z: mean 6.22e-6, largest seen 3.80e-5 (2.5 ulp) at p0_x=-8559 p0_y=3166 p0_z=9556 p1_x=-8963 p1_y=3337 p1_z=9804 p2_x=-9467 p2_y=3695 p2_z=9468 uv0_u=-3765 uv0_v=1694 uv1_u=-398 uv1_v=210 uv2_u=-3397 uv2_v=239 view_x=-9751 view_y=7042 view_z=-6135 light0_x=-5164 light0_y=-18281 light0_z=2614
--   n_angle: mean 6.36e-6 rad, largest seen 2.03e-5 rad at p0_x=3522 p0_y=-9311 p0_z=-13297 p1_x=3357 p1_y=-9323 p1_z=-12966 p2_x=3631 p2_y=-9200 p2_z=-12705 uv0_u=14991 uv0_v=-10890 uv1_u=15093 uv1_v=-10788 uv2_u=14968 uv2_v=-10772 view_x=1356 view_y=2820 view_z=466 light0_x=-381 light0_y=-197 light0_z=-3135
--   n_dot: mean 8.51e-6, largest seen 2.45e-5 at p0_x=-12498 p0_y=-6604 p0_z=11609 p1_x=-12529 p1_y=-6828 p1_z=11660 p2_x=-12768 p2_y=-6749 p2_z=11792 uv0_u=-6142 uv0_v=-4000 uv1_u=-6192 uv1_v=-3960 uv2_u=-6137 uv2_v=-3885 view_x=-8383 view_y=-17561 view_z=-14050 light0_x=2468 light0_y=-3154 light0_z=2249
--   n_x: mean 4.34e-6, largest seen 1.92e-5 (1.3 ulp) at p0_x=10267 p0_y=-5838 p0_z=15884 p1_x=10309 p1_y=-6415 p1_z=16204 p2_x=10019 p2_y=-5989 p2_z=16833 uv0_u=11841 uv0_v=15625 uv1_u=11793 uv1_v=15714 uv2_u=11814 uv2_v=15848 view_x=-11567 view_y=-17040 view_z=20375 light0_x=4077 light0_y=-4110 light0_z=-2012
--   n_y: mean 4.34e-6, largest seen 2.01e-5 (1.3 ulp) at p0_x=-3279 p0_y=-11425 p0_z=-14595 p1_x=-1417 p1_y=-11167 p1_z=-13271 p2_x=-3268 p2_y=-11185 p2_z=-10092 uv0_u=-12491 uv0_v=-17511 uv1_u=-14563 uv1_v=-17231 uv2_u=-9992 uv2_v=-12759 view_x=2161 view_y=632 view_z=-3148 light0_x=-8712 light0_y=1511 light0_z=-18751
--   n_z: mean 4.35e-6, largest seen 1.94e-5 (1.3 ulp) at p0_x=-8946 p0_y=-7910 p0_z=13506 p1_x=-7691 p1_y=-6861 p1_z=12554 p2_x=-8776 p2_y=-8113 p2_z=13612 uv0_u=1238 uv0_v=11162 uv1_u=-24396 uv1_v=6826 uv2_u=1116 uv2_v=19470 view_x=-7019 view_y=18890 view_z=19636 light0_x=-3540 light0_y=2276 light0_z=864
--   ts_view_angle: mean 4.70e-5 rad, largest seen 1.93e-3 rad at p0_x=-15922 p0_y=-11294 p0_z=15571 p1_x=-16396 p1_y=-12074 p1_z=16206 p2_x=-16189 p2_y=-11575 p2_z=15362 uv0_u=-13956 uv0_v=11730 uv1_u=-14230 uv1_v=11819 uv2_u=-14204 uv2_v=11563 view_x=8 view_y=226 view_z=-193 light0_x=-3370 light0_y=4136 light0_z=-207
--   ts_view_dot: mean 3.07e-5, largest seen 9.87e-5 at p0_x=-12422 p0_y=-584 p0_z=17766 p1_x=-10564 p1_y=-1806 p1_z=15761 p2_x=-10865 p2_y=-707 p2_z=14787 uv0_u=-4921 uv0_v=-9044 uv1_u=-4950 uv1_v=-8878 uv2_u=-4919 uv2_v=-8658 view_x=-25528 view_y=29243 view_z=-23626 light0_x=16463 light0_y=-19456 light0_z=5126
--   ts_view_x: mean 1.57e-5, largest seen 6.94e-5 (1.1 ulp) at p0_x=-11634 p0_y=13444 p0_z=3163 p1_x=-11636 p1_y=13305 p1_z=3163 p2_x=-11498 p2_y=13032 p2_z=2986 uv0_u=-3984 uv0_v=4319 uv1_u=-1406 uv1_v=5555 uv2_u=-8008 uv2_v=4153 view_x=-29173 view_y=27295 view_z=-23629 light0_x=-5624 light0_y=-6697 light0_z=-22017
--   ts_view_y: mean 1.62e-5, largest seen 8.30e-5 (1.4 ulp) at p0_x=-12422 p0_y=-584 p0_z=17766 p1_x=-10564 p1_y=-1806 p1_z=15761 p2_x=-10865 p2_y=-707 p2_z=14787 uv0_u=-4921 uv0_v=-9044 uv1_u=-4950 uv1_v=-8878 uv2_u=-4919 uv2_v=-8658 view_x=-25528 view_y=29243 view_z=-23626 light0_x=16463 light0_y=-19456 light0_z=5126
--   ts_view_z: mean 1.57e-5, largest seen 6.55e-5 (1.1 ulp) at p0_x=-957 p0_y=-8937 p0_z=-7713 p1_x=-364 p1_y=-8872 p1_z=-7780 p2_x=-792 p2_y=-9101 p2_z=-7328 uv0_u=4922 uv0_v=8735 uv1_u=6366 uv1_v=9156 uv2_u=3517 uv2_v=8477 view_x=9889 view_y=-26230 view_z=30407 light0_x=1812 light0_y=9371 light0_z=-4170
--   ts_light0_angle: mean 4.70e-5 rad, largest seen 2.36e-3 rad at p0_x=1272 p0_y=-15486 p0_z=-8368 p1_x=1233 p1_y=-15508 p1_z=-8439 p2_x=1008 p2_y=-15725 p2_z=-7973 uv0_u=-15400 uv0_v=3547 uv1_u=-15342 uv1_v=3546 uv2_u=-15427 uv2_v=3464 view_x=12551 view_y=19257 view_z=19235 light0_x=171 light0_y=29 light0_z=72
--   ts_light0_dot: mean 3.07e-5, largest seen 9.98e-5 at p0_x=-11988 p0_y=-13056 p0_z=13072 p1_x=-11974 p1_y=-13110 p1_z=13097 p2_x=-12054 p2_y=-13094 p2_z=13191 uv0_u=-10382 uv0_v=-595 uv1_u=-9528 uv1_v=2995 uv2_u=-11248 uv2_v=-1849 view_x=6871 view_y=-6359 view_z=2657 light0_x=-23988 light0_y=21120 light0_z=-30573
--   ts_light0_x: mean 1.57e-5, largest seen 6.32e-5 (1.0 ulp) at p0_x=7888 p0_y=3589 p0_z=-13121 p1_x=7875 p1_y=3709 p1_z=-13121 p2_x=7918 p2_y=3694 p2_z=-13148 uv0_u=9779 uv0_v=1962 uv1_u=7432 uv1_v=3608 uv2_u=8427 uv2_v=2441 view_x=3142 view_y=4159 view_z=-5183 light0_x=-27369 light0_y=-16800 light0_z=21689
--   ts_light0_y: mean 1.62e-5, largest seen 8.70e-5 (1.4 ulp) at p0_x=-14343 p0_y=-11991 p0_z=-12374 p1_x=-14372 p1_y=-11824 p1_z=-12446 p2_x=-14291 p2_y=-11975 p2_z=-12373 uv0_u=-5769 uv0_v=1534 uv1_u=-5987 uv1_v=1672 uv2_u=-6200 uv2_v=1332 view_x=-6980 view_y=-3912 view_z=-6879 light0_x=-30401 light0_y=-28173 light0_z=-9748
--   ts_light0_z: mean 1.57e-5, largest seen 7.04e-5 (1.2 ulp) at p0_x=-5690 p0_y=415 p0_z=3882 p1_x=-5589 p1_y=304 p1_z=3842 p2_x=-5536 p2_y=796 p2_z=3703 uv0_u=3040 uv0_v=-7908 uv1_u=2474 uv1_v=-8467 uv2_u=2843 uv2_v=-8413 view_x=13849 view_y=10624 view_z=-14547 light0_x=-30873 light0_y=9385 light0_z=-31244
--   mirrored: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   zero_uv: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
--   zero_area: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
-- stated bound on each tangent: 5.74e-5
-- stated bound on each binormal: 1.28e-4
-- stated bound on each normal: 5.74e-5
-- stated bound on each view: 5.78e-4
-- stated bound on each light0: 5.78e-4
-- stated bound on each flags: 0.00e0
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tangent_faceted is
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
        view_x : in signed(15 downto 0); -- s16f14
        view_y : in signed(15 downto 0); -- s16f14
        view_z : in signed(15 downto 0); -- s16f14
        light0_x : in signed(15 downto 0); -- s16f14
        light0_y : in signed(15 downto 0); -- s16f14
        light0_z : in signed(15 downto 0); -- s16f14
        valid_out : out std_logic;
        t_x : out signed(17 downto 0) := (others => '0'); -- s18f16
        t_y : out signed(17 downto 0) := (others => '0'); -- s18f16
        t_z : out signed(17 downto 0) := (others => '0'); -- s18f16
        b_x : out signed(17 downto 0) := (others => '0'); -- s18f16
        b_y : out signed(17 downto 0) := (others => '0'); -- s18f16
        b_z : out signed(17 downto 0) := (others => '0'); -- s18f16
        n_x : out signed(17 downto 0) := (others => '0'); -- s18f16
        n_y : out signed(17 downto 0) := (others => '0'); -- s18f16
        n_z : out signed(17 downto 0) := (others => '0'); -- s18f16
        ts_view_x : out signed(16 downto 0) := (others => '0'); -- s17f14
        ts_view_y : out signed(16 downto 0) := (others => '0'); -- s17f14
        ts_view_z : out signed(16 downto 0) := (others => '0'); -- s17f14
        ts_light0_x : out signed(16 downto 0) := (others => '0'); -- s17f14
        ts_light0_y : out signed(16 downto 0) := (others => '0'); -- s17f14
        ts_light0_z : out signed(16 downto 0) := (others => '0'); -- s17f14
        mirrored : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        degenerate : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        zero_uv : out unsigned(0 downto 0) := (others => '0'); -- u1f0
        zero_area : out unsigned(0 downto 0) := (others => '0') -- u1f0
    );
end entity;

architecture rtl of tangent_faceted is
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
    signal primitive_n31 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n32 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n34 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n37 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n38 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n40 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n41 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n43 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n44 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_e1_cross_e2_n46 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n47 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n49 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n50 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n52 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n53 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_n61 : signed(16 downto 0) := (others => '0'); -- s17f24
    signal primitive_n63 : signed(16 downto 0) := (others => '0'); -- s17f24
    signal primitive_n65 : signed(16 downto 0) := (others => '0'); -- s17f24
    signal primitive_n67 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n68 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_n85 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_t_n91 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_t_n97 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_t_n103 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_n109 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_length_n229 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_length_n244 : unsigned(0 downto 0) := (others => '0'); -- u1e2
    signal primitive_n254 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n255 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal view_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s1 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_n31_s1 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n32_s1 : signed(33 downto 0) := (others => '0'); -- s34f26
    signal primitive_n37_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n38_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n40_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n41_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n43_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_n44_s1 : signed(33 downto 0) := (others => '0'); -- s34f24
    signal primitive_e1_cross_e2_n46_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n47_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n49_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n50_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n52_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_e1_cross_e2_n53_s1 : signed(33 downto 0) := (others => '0'); -- s34f22
    signal primitive_n61_s1 : signed(16 downto 0) := (others => '0'); -- s17f24
    signal primitive_n63_s1 : signed(16 downto 0) := (others => '0'); -- s17f24
    signal primitive_n65_s1 : signed(16 downto 0) := (others => '0'); -- s17f24
    signal valid_s1 : std_logic;
    -- stage 1
    signal primitive_det : signed(34 downto 0) := (others => '0'); -- s35f26
    signal primitive_zero_uv : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_det_x : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_det_y : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_det_z : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_e1_cross_e2_n48 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_e1_cross_e2_n51 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_e1_cross_e2_n54 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n55 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n56 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n57 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n58 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n62 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n64 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n66 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n69 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n70 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n71 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_n119 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n120 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n121 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n123 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_n124 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n148 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n149 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n150 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n151 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_n152 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n171 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n172 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n173 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n174 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_n175 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n256 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n257 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n258 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n_n301 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n302 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n303 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n305 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_n306 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n330 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n331 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n332 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n333 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_n334 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n353 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n354 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n355 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n356 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_n357 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal view_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s2 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s2 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n69_s2 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n70_s2 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_n71_s2 : signed(34 downto 0) := (others => '0'); -- s35f24
    signal primitive_t_n121_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n124_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n150_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n152_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n173_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n175_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n256_s2 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n257_s2 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n258_s2 : signed(34 downto 0) := (others => '0'); -- s35f22
    signal primitive_n_n303_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n306_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n332_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n334_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n355_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n357_s2 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal valid_s2 : std_logic;
    -- stage 2
    signal primitive_t_n72_neg : unsigned(34 downto 0) := (others => '0');
    signal primitive_t_n72 : unsigned(34 downto 0) := (others => '0'); -- u35f24
    signal primitive_t_n73 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n74_neg : unsigned(34 downto 0) := (others => '0');
    signal primitive_t_n74 : unsigned(34 downto 0) := (others => '0'); -- u35f24
    signal primitive_t_n75 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n76_neg : unsigned(34 downto 0) := (others => '0');
    signal primitive_t_n76 : unsigned(34 downto 0) := (others => '0'); -- u35f24
    signal primitive_t_n77 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n78 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n79 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_largest : unsigned(34 downto 0) := (others => '0'); -- u35f24
    signal primitive_t_n81 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n82 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_t_n83 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n84 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal primitive_t_n86 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n87 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n88 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_t_n90 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal primitive_t_n92 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n259_neg : unsigned(34 downto 0) := (others => '0');
    signal primitive_n_n259 : unsigned(34 downto 0) := (others => '0'); -- u35f22
    signal primitive_n_n260 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n261_neg : unsigned(34 downto 0) := (others => '0');
    signal primitive_n_n261 : unsigned(34 downto 0) := (others => '0'); -- u35f22
    signal primitive_n_n262 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n263_neg : unsigned(34 downto 0) := (others => '0');
    signal primitive_n_n263 : unsigned(34 downto 0) := (others => '0'); -- u35f22
    signal primitive_n_n264 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n265 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n266 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_largest : unsigned(34 downto 0) := (others => '0'); -- u35f22
    signal primitive_n_n268 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n269 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_n_n270 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n271 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal primitive_n_n272 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n273 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n274 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_n_n276 : unsigned(18 downto 0) := (others => '0'); -- u19f0
    signal primitive_n_n277 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n446 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n447 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal view_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s3 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n83_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n87_s3 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n88_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_t_n92_s3 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n121_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n124_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n150_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n152_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n173_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n175_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n270_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n273_s3 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n274_s3 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_n_n277_s3 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n303_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n306_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n332_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n334_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n355_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n357_s3 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n447_s3 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s3 : std_logic;
    -- stage 3
    signal primitive_t_n89 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n93 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n94 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_t_n95 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n96 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal primitive_t_n98 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n99 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n100 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_n101 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n102 : unsigned(30 downto 0) := (others => '0'); -- u31f0
    signal primitive_t_n104 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n105 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n106 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_n108 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal primitive_t_n110 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n114 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_n115 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal primitive_t_n116 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_n275 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n278 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n279 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_n_n280 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n281 : unsigned(26 downto 0) := (others => '0'); -- u27f0
    signal primitive_n_n282 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n283 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n284 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_n285 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n286 : unsigned(30 downto 0) := (others => '0'); -- u31f0
    signal primitive_n_n287 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n288 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n289 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_n291 : unsigned(32 downto 0) := (others => '0'); -- u33f0
    signal primitive_n_n292 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n296 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_n297 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal primitive_n_n298 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal view_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s4 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n105_s4 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n106_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_n110_s4 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n116_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_n121_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n124_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n150_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n152_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n173_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n175_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n288_s4 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n289_s4 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_n292_s4 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n298_s4 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_n303_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n306_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n332_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n334_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n355_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n357_s4 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n447_s4 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s4 : std_logic;
    -- stage 4
    signal primitive_t_n107 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n111 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n112 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n113 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n117 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal primitive_t_places : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal primitive_t_n122 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n125 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n126 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n127 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_t_n128 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n129 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n130 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n131 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal primitive_t_n132 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n133 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n134 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n135 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_t_n136 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n137 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n138 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n139 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal primitive_t_n140 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n141 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n142 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n143 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n144 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n153 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n154 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_t_n155 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n156 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n157 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal primitive_t_n158 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n159 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n160 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_t_n161 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n162 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n163 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal primitive_t_n164 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n165 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n166 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n167 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n176 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n177 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_t_n178 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n179 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n180 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal primitive_t_n181 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n182 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n183 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_t_n184 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n185 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n186 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal primitive_t_n187 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n188 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n189 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_t_n190 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n290 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n293 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n294 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n295 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n299 : unsigned(4 downto 0) := (others => '0'); -- u5f0
    signal primitive_n_places : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal primitive_n_n304 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n307 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n308 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n309 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_n_n310 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n311 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n312 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n313 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal primitive_n_n314 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n315 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n316 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n317 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_n_n318 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n319 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n320 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n321 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal primitive_n_n322 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n323 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n324 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n325 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n326 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n335 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n336 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_n_n337 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n338 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n339 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal primitive_n_n340 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n341 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n342 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_n_n343 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n344 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n345 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal primitive_n_n346 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n347 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n348 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n349 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n358 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n359 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_n_n360 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n361 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n362 : unsigned(27 downto 0) := (others => '0'); -- u28f0
    signal primitive_n_n363 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n364 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n365 : unsigned(31 downto 0) := (others => '0'); -- u32f0
    signal primitive_n_n366 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n367 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n368 : unsigned(33 downto 0) := (others => '0'); -- u34f0
    signal primitive_n_n369 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n370 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n371 : unsigned(34 downto 0) := (others => '0'); -- u35f0
    signal primitive_n_n372 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal view_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s5 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n141_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n142_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_n144_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n165_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n167_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n188_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n190_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n323_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n324_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_n326_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n347_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n349_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n370_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n372_s5 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n447_s5 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s5 : std_logic;
    -- stage 5
    signal primitive_t_n145 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n146 : signed(35 downto 0) := (others => '0'); -- s36f0
    signal primitive_t_x : signed(35 downto 0) := (others => '0'); -- s36f35
    signal primitive_t_n168 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n169 : signed(35 downto 0) := (others => '0'); -- s36f0
    signal primitive_t_y : signed(35 downto 0) := (others => '0'); -- s36f35
    signal primitive_t_n191 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_t_n192 : signed(35 downto 0) := (others => '0'); -- s36f0
    signal primitive_t_z : signed(35 downto 0) := (others => '0'); -- s36f35
    signal primitive_t_norm_x_sum : signed(36 downto 0) := (others => '0');
    signal primitive_t_norm_x_cut : signed(18 downto 0) := (others => '0');
    signal primitive_t_norm_x_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_norm_x : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_sum : signed(36 downto 0) := (others => '0');
    signal primitive_t_norm_y_cut : signed(18 downto 0) := (others => '0');
    signal primitive_t_norm_y_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_norm_y : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_sum : signed(36 downto 0) := (others => '0');
    signal primitive_t_norm_z_cut : signed(18 downto 0) := (others => '0');
    signal primitive_t_norm_z_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_norm_z : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_n327 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n328 : signed(35 downto 0) := (others => '0'); -- s36f0
    signal primitive_n_x : signed(35 downto 0) := (others => '0'); -- s36f35
    signal primitive_n_n350 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n351 : signed(35 downto 0) := (others => '0'); -- s36f0
    signal primitive_n_y : signed(35 downto 0) := (others => '0'); -- s36f35
    signal primitive_n_n373 : unsigned(35 downto 0) := (others => '0'); -- u36f0
    signal primitive_n_n374 : signed(35 downto 0) := (others => '0'); -- s36f0
    signal primitive_n_z : signed(35 downto 0) := (others => '0'); -- s36f35
    signal primitive_n_norm_x_sum : signed(36 downto 0) := (others => '0');
    signal primitive_n_norm_x_cut : signed(18 downto 0) := (others => '0');
    signal primitive_n_norm_x_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_norm_x : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_sum : signed(36 downto 0) := (others => '0');
    signal primitive_n_norm_y_cut : signed(18 downto 0) := (others => '0');
    signal primitive_n_norm_y_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_norm_y : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_sum : signed(36 downto 0) := (others => '0');
    signal primitive_n_norm_z_cut : signed(18 downto 0) := (others => '0');
    signal primitive_n_norm_z_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_norm_z : signed(17 downto 0) := (others => '0'); -- s18f17
    signal view_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s6 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_x_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s6 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n447_s6 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s6 : std_logic;
    -- stage 6
    signal primitive_t_square_n197 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_t_square_n198 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_t_square_n199 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n_square_n379 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n_square_n380 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n_square_n381 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal view_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s7 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_square_n197_s7 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_t_square_n198_s7 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_t_square_n199_s7 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n_norm_x_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s7 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_square_n379_s7 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n_square_n380_s7 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n_square_n381_s7 : signed(35 downto 0) := (others => '0'); -- s36f34
    signal primitive_n447_s7 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s7 : std_logic;
    -- stage 7
    signal primitive_t_square_n200 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal primitive_t_square_n201 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal primitive_n_square_n382 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal primitive_n_square_n383 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal view_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s8 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_square_n201_s8 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal primitive_n_norm_x_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s8 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_square_n383_s8 : signed(37 downto 0) := (others => '0'); -- s38f34
    signal primitive_n447_s8 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s8 : std_logic;
    -- stage 8
    signal primitive_t_length_square_sum : signed(38 downto 0) := (others => '0');
    signal primitive_t_length_square_cut : signed(24 downto 0) := (others => '0');
    signal primitive_t_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal primitive_t_length_n203 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n204 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n205 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_t_length_n206 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_length_n207 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal primitive_t_length_n208 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n209 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n210 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_t_length_n211 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_length_n212 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal primitive_t_length_n213 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n225 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_length_n245 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_length_square_sum : signed(38 downto 0) := (others => '0');
    signal primitive_n_length_square_cut : signed(24 downto 0) := (others => '0');
    signal primitive_n_length_square_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_length_square_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_length_square : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal primitive_n_length_n385 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n386 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n387 : unsigned(15 downto 0) := (others => '0'); -- u16f0
    signal primitive_n_length_n388 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_length_n389 : unsigned(5 downto 0) := (others => '0'); -- u6f0
    signal primitive_n_length_n390 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n391 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n392 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_n_length_n393 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_length_n394 : unsigned(13 downto 0) := (others => '0'); -- u14f0
    signal primitive_n_length_n395 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n407 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_length_n425 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal view_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s9 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_length_n209_s9 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n211_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_length_n213_s9 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n225_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_length_n245_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_norm_x_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s9 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_length_n391_s9 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n393_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_length_n395_s9 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n407_s9 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_length_n425_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n447_s9 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s9 : std_logic;
    -- stage 9
    signal primitive_t_length_n214 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n215 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_length_n216 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_length_n217 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal primitive_t_length_n218 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n219 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n220 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_length_n221 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_length_n222 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_t_length_n223 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n224 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_t_length_n226 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal primitive_t_length_n227 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_length_n228 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_length_n230 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal primitive_t_length_n231 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_t_length_n232 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal primitive_t_length_n233 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_t_length_n234 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal primitive_t_length_recip_root_n235 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_t_length_recip_root_n238 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal primitive_n_length_n396 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n397 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_length_n398 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_length_n399 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal primitive_n_length_n400 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n401 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n402 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_length_n403 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_length_n404 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_n_length_n405 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n406 : unsigned(21 downto 0) := (others => '0'); -- u22f0
    signal primitive_n_length_n408 : unsigned(2 downto 0) := (others => '0'); -- u3f0
    signal primitive_n_length_n409 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_length_n410 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_length_n411 : signed(2 downto 0) := (others => '0'); -- s3f0
    signal primitive_n_length_n412 : unsigned(1 downto 0) := (others => '0'); -- u2f0
    signal primitive_n_length_n413 : unsigned(17 downto 0) := (others => '0'); -- u18f0
    signal primitive_n_length_n414 : unsigned(19 downto 0) := (others => '0'); -- u20f0
    signal primitive_n_length_n415 : unsigned(19 downto 0) := (others => '0'); -- u20f20
    signal primitive_n_length_recip_root_n416 : unsigned(7 downto 0) := (others => '0'); -- u8f0
    signal primitive_n_length_recip_root_n419 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal view_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s10 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_length_n227_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row : unsigned(39 downto 0) := (others => '0');
    signal primitive_t_length_recip_root_n238_s10 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal primitive_t_length_n245_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_norm_x_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s10 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_length_n409_s10 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal recip_root_row_2 : unsigned(39 downto 0) := (others => '0');
    signal primitive_n_length_recip_root_n419_s10 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal primitive_n_length_n425_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n447_s10 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s10 : std_logic;
    -- stage 10
    signal primitive_t_length_recip_root_n236 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal primitive_t_length_recip_root_n237 : signed(16 downto 0) := (others => '0'); -- s17f34
    signal primitive_n_length_recip_root_n417 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal primitive_n_length_recip_root_n418 : signed(16 downto 0) := (others => '0'); -- s17f34
    signal view_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s11 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_length_n227_s11 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_length_recip_root_n236_s11 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal primitive_t_length_recip_root_n237_s11 : signed(16 downto 0) := (others => '0'); -- s17f34
    signal primitive_t_length_recip_root_n238_s11 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal primitive_t_length_n245_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_norm_x_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s11 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_length_n409_s11 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_length_recip_root_n417_s11 : unsigned(22 downto 0) := (others => '0'); -- u23f22
    signal primitive_n_length_recip_root_n418_s11 : signed(16 downto 0) := (others => '0'); -- s17f34
    signal primitive_n_length_recip_root_n419_s11 : unsigned(11 downto 0) := (others => '0'); -- u12f0
    signal primitive_n_length_n425_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n447_s11 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s11 : std_logic;
    -- stage 11
    signal primitive_t_length_recip_root_n239 : signed(28 downto 0) := (others => '0'); -- s29f34
    signal primitive_t_length_recip_root_n240 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal primitive_n_length_recip_root_n420 : signed(28 downto 0) := (others => '0'); -- s29f34
    signal primitive_n_length_recip_root_n421 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal view_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s12 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_length_n227_s12 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_t_length_recip_root_n240_s12 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal primitive_t_length_n245_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_norm_x_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s12 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_length_n409_s12 : unsigned(3 downto 0) := (others => '0'); -- u4f0
    signal primitive_n_length_recip_root_n421_s12 : signed(36 downto 0) := (others => '0'); -- s37f34
    signal primitive_n_length_n425_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n447_s12 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s12 : std_logic;
    -- stage 12
    signal primitive_t_length_recip_root_n241_sum : signed(37 downto 0) := (others => '0');
    signal primitive_t_length_recip_root_n241_cut : signed(23 downto 0) := (others => '0');
    signal primitive_t_length_recip_root_n241_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_length_recip_root_n241_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_length_recip_root_n241 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal primitive_t_length_n242_past : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_length_n242_count : unsigned(3 downto 0) := (others => '0');
    signal primitive_t_length_n242 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal primitive_t_length_n243 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal primitive_t_length_n246 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal primitive_n_length_recip_root_n422_sum : signed(37 downto 0) := (others => '0');
    signal primitive_n_length_recip_root_n422_cut : signed(23 downto 0) := (others => '0');
    signal primitive_n_length_recip_root_n422_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_length_recip_root_n422_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_length_recip_root_n422 : unsigned(21 downto 0) := (others => '0'); -- u22f20
    signal primitive_n_length_n423_past : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_length_n423_count : unsigned(3 downto 0) := (others => '0');
    signal primitive_n_length_n423 : unsigned(32 downto 0) := (others => '0'); -- u33f20
    signal primitive_n_length_n424 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal primitive_n_length_n426 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal view_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s13 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_length_n246_s13 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal primitive_n_norm_x_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s13 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_length_n426_s13 : unsigned(32 downto 0) := (others => '0'); -- u33f21
    signal primitive_n447_s13 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s13 : std_logic;
    -- stage 13
    signal primitive_t_length_t_length_sum : unsigned(33 downto 0) := (others => '0');
    signal primitive_t_length_t_length_cut : unsigned(30 downto 0) := (others => '0');
    signal primitive_t_length_t_length_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_length_t_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal primitive_n_length_n_length_sum : unsigned(33 downto 0) := (others => '0');
    signal primitive_n_length_n_length_cut : unsigned(30 downto 0) := (others => '0');
    signal primitive_n_length_n_length_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_length_n_length : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal view_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s14 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_norm_x_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_y_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_norm_z_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_t_length_t_length_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal primitive_n_norm_x_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_y_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_norm_z_s14 : signed(17 downto 0) := (others => '0'); -- s18f17
    signal primitive_n_length_n_length_s14 : unsigned(19 downto 0) := (others => '0'); -- u20f18
    signal primitive_n447_s14 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s14 : std_logic;
    -- stage 14
    signal primitive_n248 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n250 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n252 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n428 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n430 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n432 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal view_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s15 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n248_s15 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n250_s15 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n252_s15 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n428_s15 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n430_s15 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n432_s15 : signed(37 downto 0) := (others => '0'); -- s38f35
    signal primitive_n447_s15 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal valid_s15 : std_logic;
    -- stage 15
    signal primitive_t_unit_x_sum : signed(38 downto 0) := (others => '0');
    signal primitive_t_unit_x_cut : signed(19 downto 0) := (others => '0');
    signal primitive_t_unit_x_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_unit_x_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_unit_x : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_t_unit_y_sum : signed(38 downto 0) := (others => '0');
    signal primitive_t_unit_y_cut : signed(19 downto 0) := (others => '0');
    signal primitive_t_unit_y_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_unit_y_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_unit_y : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_t_unit_z_sum : signed(38 downto 0) := (others => '0');
    signal primitive_t_unit_z_cut : signed(19 downto 0) := (others => '0');
    signal primitive_t_unit_z_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_unit_z_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_t_unit_z : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_x_sum : signed(38 downto 0) := (others => '0');
    signal primitive_n_unit_x_cut : signed(19 downto 0) := (others => '0');
    signal primitive_n_unit_x_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_unit_x_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_unit_x : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_y_sum : signed(38 downto 0) := (others => '0');
    signal primitive_n_unit_y_cut : signed(19 downto 0) := (others => '0');
    signal primitive_n_unit_y_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_unit_y_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_unit_y : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_z_sum : signed(38 downto 0) := (others => '0');
    signal primitive_n_unit_z_cut : signed(19 downto 0) := (others => '0');
    signal primitive_n_unit_z_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_unit_z_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n_unit_z : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n448 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal primitive_n449 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal primitive_n450_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n450_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n450 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n451 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal primitive_n452 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal primitive_n453_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n453_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n453 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n454 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal primitive_n455 : signed(18 downto 0) := (others => '0'); -- s19f16
    signal primitive_n456_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n456_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n456 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal view_x_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s16 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s16 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_t_unit_x_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_t_unit_y_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_t_unit_z_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_x_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_y_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_z_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n450_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n453_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n456_s16 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal valid_s16 : std_logic;
    -- stage 16
    signal primitive_n_cross_t_n434 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n435 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n437 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n438 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n440 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n441 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal vertex_ts_view_t_n457 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_t_n458 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_t_n459 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_n_n469 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_n_n470 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_n_n471 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_t_n475 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_t_n476 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_t_n477 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_n_n487 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_n_n488 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_n_n489 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal view_x_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s17 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s17 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_unit_x_s17 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_y_s17 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_z_s17 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_cross_t_n434_s17 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n435_s17 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n437_s17 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n438_s17 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n440_s17 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n_cross_t_n441_s17 : signed(35 downto 0) := (others => '0'); -- s36f32
    signal primitive_n450_s17 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n453_s17 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n456_s17 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_ts_view_t_n457_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_t_n458_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_t_n459_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_n_n469_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_n_n470_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_n_n471_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_t_n475_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_t_n476_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_t_n477_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_n_n487_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_n_n488_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_n_n489_s17 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal valid_s17 : std_logic;
    -- stage 17
    signal primitive_n_cross_t_n436 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal primitive_n_cross_t_n439 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal primitive_n_cross_t_n442 : signed(36 downto 0) := (others => '0'); -- s37f32
    signal primitive_n443_sum : signed(37 downto 0) := (others => '0');
    signal primitive_n443_cut : signed(21 downto 0) := (others => '0');
    signal primitive_n443_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n443_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n443 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n444_sum : signed(37 downto 0) := (others => '0');
    signal primitive_n444_cut : signed(21 downto 0) := (others => '0');
    signal primitive_n444_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n444_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n444 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n445_sum : signed(37 downto 0) := (others => '0');
    signal primitive_n445_cut : signed(21 downto 0) := (others => '0');
    signal primitive_n445_over : unsigned(0 downto 0) := (others => '0');
    signal primitive_n445_under : unsigned(0 downto 0) := (others => '0');
    signal primitive_n445 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_ts_view_t_n460 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_t_n461 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_view_n_n472 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_n_n473 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_t_n478 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_t_n479 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_n_n490 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_n_n491 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal view_x_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_y_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal view_z_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_x_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_y_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal light0_z_s18 : signed(15 downto 0) := (others => '0'); -- s16f14
    signal primitive_zero_uv_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s18 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_unit_x_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_y_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_z_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n443_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n444_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n445_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n450_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n453_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n456_s18 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_ts_view_t_n461_s18 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_view_n_n473_s18 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_t_n479_s18 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_n_n491_s18 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal valid_s18 : std_logic;
    -- stage 18
    signal vertex_ts_view_x_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_view_x_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_view_x_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_x_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_x : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_view_b_n463 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n464 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n465 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_z_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_view_z_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_view_z_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_z_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_z : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_x_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_light0_x_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_light0_x_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_x_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_x : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_b_n481 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n482 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n483 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_z_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_light0_z_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_light0_z_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_z_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_z : signed(16 downto 0) := (others => '0'); -- s17f14
    signal primitive_zero_uv_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s19 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_unit_x_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_y_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_z_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n443_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n444_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n445_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n450_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n453_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n456_s19 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_ts_view_x_s19 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_view_b_n463_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n464_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_b_n465_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_view_z_s19 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_x_s19 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_b_n481_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n482_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_b_n483_s19 : signed(33 downto 0) := (others => '0'); -- s34f30
    signal vertex_ts_light0_z_s19 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal valid_s19 : std_logic;
    -- stage 19
    signal vertex_ts_view_b_n466 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_view_b_n467 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_b_n484 : signed(34 downto 0) := (others => '0'); -- s35f30
    signal vertex_ts_light0_b_n485 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal primitive_zero_uv_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_mirrored_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_zero_area_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_degenerate_s20 : unsigned(0 downto 0) := (others => '0'); -- u1f0
    signal primitive_n_unit_x_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_y_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n_unit_z_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n443_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n444_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n445_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n450_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n453_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal primitive_n456_s20 : signed(17 downto 0) := (others => '0'); -- s18f16
    signal vertex_ts_view_x_s20 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_view_b_n467_s20 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_view_z_s20 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_x_s20 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_b_n485_s20 : signed(35 downto 0) := (others => '0'); -- s36f30
    signal vertex_ts_light0_z_s20 : signed(16 downto 0) := (others => '0'); -- s17f14
    signal valid_s20 : std_logic;
    -- stage 20
    signal vertex_ts_view_y_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_view_y_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_view_y_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_y_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_view_y : signed(16 downto 0) := (others => '0'); -- s17f14
    signal vertex_ts_light0_y_sum : signed(36 downto 0) := (others => '0');
    signal vertex_ts_light0_y_cut : signed(20 downto 0) := (others => '0');
    signal vertex_ts_light0_y_over : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_y_under : unsigned(0 downto 0) := (others => '0');
    signal vertex_ts_light0_y : signed(16 downto 0) := (others => '0'); -- s17f14
    signal valid_s21 : std_logic;
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
    primitive_n31 <= primitive_du1 * primitive_dv2;
    primitive_n32 <= primitive_du2 * primitive_dv1;
    primitive_n34 <= "0";
    primitive_n37 <= primitive_dv2 * primitive_e1_x;
    primitive_n38 <= primitive_dv1 * primitive_e2_x;
    primitive_n40 <= primitive_dv2 * primitive_e1_y;
    primitive_n41 <= primitive_dv1 * primitive_e2_y;
    primitive_n43 <= primitive_dv2 * primitive_e1_z;
    primitive_n44 <= primitive_dv1 * primitive_e2_z;
    -- primitive.e1_cross_e2
    primitive_e1_cross_e2_n46 <= primitive_e1_y * primitive_e2_z;
    primitive_e1_cross_e2_n47 <= primitive_e1_z * primitive_e2_y;
    primitive_e1_cross_e2_n49 <= primitive_e1_z * primitive_e2_x;
    primitive_e1_cross_e2_n50 <= primitive_e1_x * primitive_e2_z;
    primitive_e1_cross_e2_n52 <= primitive_e1_x * primitive_e2_y;
    primitive_e1_cross_e2_n53 <= primitive_e1_y * primitive_e2_x;
    -- primitive
    primitive_n61 <= primitive_e1_x;
    primitive_n63 <= primitive_e1_y;
    primitive_n65 <= primitive_e1_z;
    primitive_n67 <= 35x"000000001";
    primitive_n68 <= 35x"000000000";
    -- primitive.t
    primitive_t_n85 <= 32x"00000000";
    primitive_t_n91 <= 16x"0000";
    primitive_t_n97 <= 8x"00";
    primitive_t_n103 <= 4x"0";
    primitive_t_n109 <= "00";
    -- primitive.t_length
    primitive_t_length_n229 <= "1";
    primitive_t_length_n244 <= "1";
    -- primitive
    primitive_n254 <= 35x"000000000";
    primitive_n255 <= 35x"000000001";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s1 <= view_x;
                view_y_s1 <= view_y;
                view_z_s1 <= view_z;
                light0_x_s1 <= light0_x;
                light0_y_s1 <= light0_y;
                light0_z_s1 <= light0_z;
                primitive_n31_s1 <= primitive_n31;
                primitive_n32_s1 <= primitive_n32;
                primitive_n37_s1 <= primitive_n37;
                primitive_n38_s1 <= primitive_n38;
                primitive_n40_s1 <= primitive_n40;
                primitive_n41_s1 <= primitive_n41;
                primitive_n43_s1 <= primitive_n43;
                primitive_n44_s1 <= primitive_n44;
                primitive_e1_cross_e2_n46_s1 <= primitive_e1_cross_e2_n46;
                primitive_e1_cross_e2_n47_s1 <= primitive_e1_cross_e2_n47;
                primitive_e1_cross_e2_n49_s1 <= primitive_e1_cross_e2_n49;
                primitive_e1_cross_e2_n50_s1 <= primitive_e1_cross_e2_n50;
                primitive_e1_cross_e2_n52_s1 <= primitive_e1_cross_e2_n52;
                primitive_e1_cross_e2_n53_s1 <= primitive_e1_cross_e2_n53;
                primitive_n61_s1 <= primitive_n61;
                primitive_n63_s1 <= primitive_n63;
                primitive_n65_s1 <= primitive_n65;
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
    primitive_det <= resize(primitive_n31_s1, 35) - resize(primitive_n32_s1, 35);
    primitive_zero_uv <= "1" when unsigned(primitive_det) = shift_left(resize(primitive_n34, 35), 26) else "0";
    primitive_mirrored <= unsigned(primitive_det(34 downto 34));
    primitive_t_det_x <= resize(primitive_n37_s1, 35) - resize(primitive_n38_s1, 35);
    primitive_t_det_y <= resize(primitive_n40_s1, 35) - resize(primitive_n41_s1, 35);
    primitive_t_det_z <= resize(primitive_n43_s1, 35) - resize(primitive_n44_s1, 35);
    -- primitive.e1_cross_e2
    primitive_e1_cross_e2_n48 <= resize(primitive_e1_cross_e2_n46_s1, 35) - resize(primitive_e1_cross_e2_n47_s1, 35);
    primitive_e1_cross_e2_n51 <= resize(primitive_e1_cross_e2_n49_s1, 35) - resize(primitive_e1_cross_e2_n50_s1, 35);
    primitive_e1_cross_e2_n54 <= resize(primitive_e1_cross_e2_n52_s1, 35) - resize(primitive_e1_cross_e2_n53_s1, 35);
    -- primitive
    primitive_n55 <= "1" when unsigned(primitive_e1_cross_e2_n48) = shift_left(resize(primitive_n34, 35), 22) else "0";
    primitive_n56 <= "1" when unsigned(primitive_e1_cross_e2_n51) = shift_left(resize(primitive_n34, 35), 22) else "0";
    primitive_n57 <= "1" when unsigned(primitive_e1_cross_e2_n54) = shift_left(resize(primitive_n34, 35), 22) else "0";
    primitive_n58 <= primitive_n55 and primitive_n56;
    primitive_zero_area <= primitive_n58 and primitive_n57;
    primitive_degenerate <= primitive_zero_uv or primitive_zero_area;
    primitive_n62 <= resize(primitive_n61_s1, 35) when primitive_zero_uv(0) = '1' else primitive_t_det_x;
    primitive_n64 <= resize(primitive_n63_s1, 35) when primitive_zero_uv(0) = '1' else primitive_t_det_y;
    primitive_n66 <= resize(primitive_n65_s1, 35) when primitive_zero_uv(0) = '1' else primitive_t_det_z;
    primitive_n69 <= primitive_n67 when primitive_zero_area(0) = '1' else primitive_n62;
    primitive_n70 <= primitive_n68 when primitive_zero_area(0) = '1' else primitive_n64;
    primitive_n71 <= primitive_n68 when primitive_zero_area(0) = '1' else primitive_n66;
    -- primitive.t
    primitive_t_n119 <= unsigned(primitive_n69(34 downto 34));
    primitive_t_n120 <= unsigned(primitive_n69);
    primitive_t_n121 <= primitive_t_n119 & primitive_t_n120;
    primitive_t_n123 <= primitive_t_n121(3 downto 0);
    primitive_t_n124 <= primitive_t_n123 & primitive_t_n85;
    primitive_t_n148 <= unsigned(primitive_n70(34 downto 34));
    primitive_t_n149 <= unsigned(primitive_n70);
    primitive_t_n150 <= primitive_t_n148 & primitive_t_n149;
    primitive_t_n151 <= primitive_t_n150(3 downto 0);
    primitive_t_n152 <= primitive_t_n151 & primitive_t_n85;
    primitive_t_n171 <= unsigned(primitive_n71(34 downto 34));
    primitive_t_n172 <= unsigned(primitive_n71);
    primitive_t_n173 <= primitive_t_n171 & primitive_t_n172;
    primitive_t_n174 <= primitive_t_n173(3 downto 0);
    primitive_t_n175 <= primitive_t_n174 & primitive_t_n85;
    -- primitive
    primitive_n256 <= primitive_n254 when primitive_zero_area(0) = '1' else primitive_e1_cross_e2_n48;
    primitive_n257 <= primitive_n254 when primitive_zero_area(0) = '1' else primitive_e1_cross_e2_n51;
    primitive_n258 <= primitive_n255 when primitive_zero_area(0) = '1' else primitive_e1_cross_e2_n54;
    -- primitive.n
    primitive_n_n301 <= unsigned(primitive_n256(34 downto 34));
    primitive_n_n302 <= unsigned(primitive_n256);
    primitive_n_n303 <= primitive_n_n301 & primitive_n_n302;
    primitive_n_n305 <= primitive_n_n303(3 downto 0);
    primitive_n_n306 <= primitive_n_n305 & primitive_t_n85;
    primitive_n_n330 <= unsigned(primitive_n257(34 downto 34));
    primitive_n_n331 <= unsigned(primitive_n257);
    primitive_n_n332 <= primitive_n_n330 & primitive_n_n331;
    primitive_n_n333 <= primitive_n_n332(3 downto 0);
    primitive_n_n334 <= primitive_n_n333 & primitive_t_n85;
    primitive_n_n353 <= unsigned(primitive_n258(34 downto 34));
    primitive_n_n354 <= unsigned(primitive_n258);
    primitive_n_n355 <= primitive_n_n353 & primitive_n_n354;
    primitive_n_n356 <= primitive_n_n355(3 downto 0);
    primitive_n_n357 <= primitive_n_n356 & primitive_t_n85;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s2 <= view_x_s1;
                view_y_s2 <= view_y_s1;
                view_z_s2 <= view_z_s1;
                light0_x_s2 <= light0_x_s1;
                light0_y_s2 <= light0_y_s1;
                light0_z_s2 <= light0_z_s1;
                primitive_zero_uv_s2 <= primitive_zero_uv;
                primitive_mirrored_s2 <= primitive_mirrored;
                primitive_zero_area_s2 <= primitive_zero_area;
                primitive_degenerate_s2 <= primitive_degenerate;
                primitive_n69_s2 <= primitive_n69;
                primitive_n70_s2 <= primitive_n70;
                primitive_n71_s2 <= primitive_n71;
                primitive_t_n121_s2 <= primitive_t_n121;
                primitive_t_n124_s2 <= primitive_t_n124;
                primitive_t_n150_s2 <= primitive_t_n150;
                primitive_t_n152_s2 <= primitive_t_n152;
                primitive_t_n173_s2 <= primitive_t_n173;
                primitive_t_n175_s2 <= primitive_t_n175;
                primitive_n256_s2 <= primitive_n256;
                primitive_n257_s2 <= primitive_n257;
                primitive_n258_s2 <= primitive_n258;
                primitive_n_n303_s2 <= primitive_n_n303;
                primitive_n_n306_s2 <= primitive_n_n306;
                primitive_n_n332_s2 <= primitive_n_n332;
                primitive_n_n334_s2 <= primitive_n_n334;
                primitive_n_n355_s2 <= primitive_n_n355;
                primitive_n_n357_s2 <= primitive_n_n357;
            end if;
            if rst = '1' then
                valid_s2 <= '0';
            elsif ce = '1' then
                valid_s2 <= valid_s1;
            end if;
        end if;
    end process;

    -- ---- stage 2 ----
    -- primitive.t
    primitive_t_n72_neg <= unsigned(-primitive_n69_s2);
    primitive_t_n72 <= primitive_t_n72_neg when primitive_n69_s2(34) = '1' else unsigned(primitive_n69_s2);
    primitive_t_n73 <= primitive_t_n72;
    primitive_t_n74_neg <= unsigned(-primitive_n70_s2);
    primitive_t_n74 <= primitive_t_n74_neg when primitive_n70_s2(34) = '1' else unsigned(primitive_n70_s2);
    primitive_t_n75 <= primitive_t_n74;
    primitive_t_n76_neg <= unsigned(-primitive_n71_s2);
    primitive_t_n76 <= primitive_t_n76_neg when primitive_n71_s2(34) = '1' else unsigned(primitive_n71_s2);
    primitive_t_n77 <= primitive_t_n76;
    primitive_t_n78 <= primitive_t_n73 or primitive_t_n75;
    primitive_t_n79 <= primitive_t_n78 or primitive_t_n77;
    primitive_t_largest <= primitive_t_n79;
    primitive_t_n81 <= primitive_t_largest;
    primitive_t_n82 <= primitive_t_n81(34 downto 3);
    primitive_t_n83 <= "1" when primitive_t_n82 = resize(primitive_n34, 32) else "0";
    primitive_t_n84 <= primitive_t_n81(2 downto 0);
    primitive_t_n86 <= primitive_t_n84 & primitive_t_n85;
    primitive_t_n87 <= primitive_t_n86 when primitive_t_n83(0) = '1' else primitive_t_n81;
    primitive_t_n88 <= primitive_t_n87(34 downto 19);
    primitive_t_n90 <= primitive_t_n87(18 downto 0);
    primitive_t_n92 <= primitive_t_n90 & primitive_t_n91;
    -- primitive.n
    primitive_n_n259_neg <= unsigned(-primitive_n256_s2);
    primitive_n_n259 <= primitive_n_n259_neg when primitive_n256_s2(34) = '1' else unsigned(primitive_n256_s2);
    primitive_n_n260 <= primitive_n_n259;
    primitive_n_n261_neg <= unsigned(-primitive_n257_s2);
    primitive_n_n261 <= primitive_n_n261_neg when primitive_n257_s2(34) = '1' else unsigned(primitive_n257_s2);
    primitive_n_n262 <= primitive_n_n261;
    primitive_n_n263_neg <= unsigned(-primitive_n258_s2);
    primitive_n_n263 <= primitive_n_n263_neg when primitive_n258_s2(34) = '1' else unsigned(primitive_n258_s2);
    primitive_n_n264 <= primitive_n_n263;
    primitive_n_n265 <= primitive_n_n260 or primitive_n_n262;
    primitive_n_n266 <= primitive_n_n265 or primitive_n_n264;
    primitive_n_largest <= primitive_n_n266;
    primitive_n_n268 <= primitive_n_largest;
    primitive_n_n269 <= primitive_n_n268(34 downto 3);
    primitive_n_n270 <= "1" when primitive_n_n269 = resize(primitive_n34, 32) else "0";
    primitive_n_n271 <= primitive_n_n268(2 downto 0);
    primitive_n_n272 <= primitive_n_n271 & primitive_t_n85;
    primitive_n_n273 <= primitive_n_n272 when primitive_n_n270(0) = '1' else primitive_n_n268;
    primitive_n_n274 <= primitive_n_n273(34 downto 19);
    primitive_n_n276 <= primitive_n_n273(18 downto 0);
    primitive_n_n277 <= primitive_n_n276 & primitive_t_n91;
    -- primitive
    primitive_n446 <= primitive_degenerate_s2 xor primitive_t_length_n229;
    primitive_n447 <= primitive_mirrored_s2 and primitive_n446;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s3 <= view_x_s2;
                view_y_s3 <= view_y_s2;
                view_z_s3 <= view_z_s2;
                light0_x_s3 <= light0_x_s2;
                light0_y_s3 <= light0_y_s2;
                light0_z_s3 <= light0_z_s2;
                primitive_zero_uv_s3 <= primitive_zero_uv_s2;
                primitive_mirrored_s3 <= primitive_mirrored_s2;
                primitive_zero_area_s3 <= primitive_zero_area_s2;
                primitive_degenerate_s3 <= primitive_degenerate_s2;
                primitive_t_n83_s3 <= primitive_t_n83;
                primitive_t_n87_s3 <= primitive_t_n87;
                primitive_t_n88_s3 <= primitive_t_n88;
                primitive_t_n92_s3 <= primitive_t_n92;
                primitive_t_n121_s3 <= primitive_t_n121_s2;
                primitive_t_n124_s3 <= primitive_t_n124_s2;
                primitive_t_n150_s3 <= primitive_t_n150_s2;
                primitive_t_n152_s3 <= primitive_t_n152_s2;
                primitive_t_n173_s3 <= primitive_t_n173_s2;
                primitive_t_n175_s3 <= primitive_t_n175_s2;
                primitive_n_n270_s3 <= primitive_n_n270;
                primitive_n_n273_s3 <= primitive_n_n273;
                primitive_n_n274_s3 <= primitive_n_n274;
                primitive_n_n277_s3 <= primitive_n_n277;
                primitive_n_n303_s3 <= primitive_n_n303_s2;
                primitive_n_n306_s3 <= primitive_n_n306_s2;
                primitive_n_n332_s3 <= primitive_n_n332_s2;
                primitive_n_n334_s3 <= primitive_n_n334_s2;
                primitive_n_n355_s3 <= primitive_n_n355_s2;
                primitive_n_n357_s3 <= primitive_n_n357_s2;
                primitive_n447_s3 <= primitive_n447;
            end if;
            if rst = '1' then
                valid_s3 <= '0';
            elsif ce = '1' then
                valid_s3 <= valid_s2;
            end if;
        end if;
    end process;

    -- ---- stage 3 ----
    -- primitive.t
    primitive_t_n89 <= "1" when primitive_t_n88_s3 = resize(primitive_n34, 16) else "0";
    primitive_t_n93 <= primitive_t_n92_s3 when primitive_t_n89(0) = '1' else primitive_t_n87_s3;
    primitive_t_n94 <= primitive_t_n93(34 downto 27);
    primitive_t_n95 <= "1" when primitive_t_n94 = resize(primitive_n34, 8) else "0";
    primitive_t_n96 <= primitive_t_n93(26 downto 0);
    primitive_t_n98 <= primitive_t_n96 & primitive_t_n97;
    primitive_t_n99 <= primitive_t_n98 when primitive_t_n95(0) = '1' else primitive_t_n93;
    primitive_t_n100 <= primitive_t_n99(34 downto 31);
    primitive_t_n101 <= "1" when primitive_t_n100 = resize(primitive_n34, 4) else "0";
    primitive_t_n102 <= primitive_t_n99(30 downto 0);
    primitive_t_n104 <= primitive_t_n102 & primitive_t_n103;
    primitive_t_n105 <= primitive_t_n104 when primitive_t_n101(0) = '1' else primitive_t_n99;
    primitive_t_n106 <= primitive_t_n105(34 downto 33);
    primitive_t_n108 <= primitive_t_n105(32 downto 0);
    primitive_t_n110 <= primitive_t_n108 & primitive_t_n109;
    primitive_t_n114 <= primitive_t_n83_s3 & primitive_t_n89;
    primitive_t_n115 <= primitive_t_n114 & primitive_t_n95;
    primitive_t_n116 <= primitive_t_n115 & primitive_t_n101;
    -- primitive.n
    primitive_n_n275 <= "1" when primitive_n_n274_s3 = resize(primitive_n34, 16) else "0";
    primitive_n_n278 <= primitive_n_n277_s3 when primitive_n_n275(0) = '1' else primitive_n_n273_s3;
    primitive_n_n279 <= primitive_n_n278(34 downto 27);
    primitive_n_n280 <= "1" when primitive_n_n279 = resize(primitive_n34, 8) else "0";
    primitive_n_n281 <= primitive_n_n278(26 downto 0);
    primitive_n_n282 <= primitive_n_n281 & primitive_t_n97;
    primitive_n_n283 <= primitive_n_n282 when primitive_n_n280(0) = '1' else primitive_n_n278;
    primitive_n_n284 <= primitive_n_n283(34 downto 31);
    primitive_n_n285 <= "1" when primitive_n_n284 = resize(primitive_n34, 4) else "0";
    primitive_n_n286 <= primitive_n_n283(30 downto 0);
    primitive_n_n287 <= primitive_n_n286 & primitive_t_n103;
    primitive_n_n288 <= primitive_n_n287 when primitive_n_n285(0) = '1' else primitive_n_n283;
    primitive_n_n289 <= primitive_n_n288(34 downto 33);
    primitive_n_n291 <= primitive_n_n288(32 downto 0);
    primitive_n_n292 <= primitive_n_n291 & primitive_t_n109;
    primitive_n_n296 <= primitive_n_n270_s3 & primitive_n_n275;
    primitive_n_n297 <= primitive_n_n296 & primitive_n_n280;
    primitive_n_n298 <= primitive_n_n297 & primitive_n_n285;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s4 <= view_x_s3;
                view_y_s4 <= view_y_s3;
                view_z_s4 <= view_z_s3;
                light0_x_s4 <= light0_x_s3;
                light0_y_s4 <= light0_y_s3;
                light0_z_s4 <= light0_z_s3;
                primitive_zero_uv_s4 <= primitive_zero_uv_s3;
                primitive_mirrored_s4 <= primitive_mirrored_s3;
                primitive_zero_area_s4 <= primitive_zero_area_s3;
                primitive_degenerate_s4 <= primitive_degenerate_s3;
                primitive_t_n105_s4 <= primitive_t_n105;
                primitive_t_n106_s4 <= primitive_t_n106;
                primitive_t_n110_s4 <= primitive_t_n110;
                primitive_t_n116_s4 <= primitive_t_n116;
                primitive_t_n121_s4 <= primitive_t_n121_s3;
                primitive_t_n124_s4 <= primitive_t_n124_s3;
                primitive_t_n150_s4 <= primitive_t_n150_s3;
                primitive_t_n152_s4 <= primitive_t_n152_s3;
                primitive_t_n173_s4 <= primitive_t_n173_s3;
                primitive_t_n175_s4 <= primitive_t_n175_s3;
                primitive_n_n288_s4 <= primitive_n_n288;
                primitive_n_n289_s4 <= primitive_n_n289;
                primitive_n_n292_s4 <= primitive_n_n292;
                primitive_n_n298_s4 <= primitive_n_n298;
                primitive_n_n303_s4 <= primitive_n_n303_s3;
                primitive_n_n306_s4 <= primitive_n_n306_s3;
                primitive_n_n332_s4 <= primitive_n_n332_s3;
                primitive_n_n334_s4 <= primitive_n_n334_s3;
                primitive_n_n355_s4 <= primitive_n_n355_s3;
                primitive_n_n357_s4 <= primitive_n_n357_s3;
                primitive_n447_s4 <= primitive_n447_s3;
            end if;
            if rst = '1' then
                valid_s4 <= '0';
            elsif ce = '1' then
                valid_s4 <= valid_s3;
            end if;
        end if;
    end process;

    -- ---- stage 4 ----
    -- primitive.t
    primitive_t_n107 <= "1" when primitive_t_n106_s4 = resize(primitive_n34, 2) else "0";
    primitive_t_n111 <= primitive_t_n110_s4 when primitive_t_n107(0) = '1' else primitive_t_n105_s4;
    primitive_t_n112 <= primitive_t_n111(34 downto 34);
    primitive_t_n113 <= "1" when primitive_t_n112 = primitive_n34 else "0";
    primitive_t_n117 <= primitive_t_n116_s4 & primitive_t_n107;
    primitive_t_places <= primitive_t_n117 & primitive_t_n113;
    primitive_t_n122 <= primitive_t_places(5 downto 5);
    primitive_t_n125 <= primitive_t_n124_s4 when primitive_t_n122(0) = '1' else primitive_t_n121_s4;
    primitive_t_n126 <= primitive_t_places(4 downto 4);
    primitive_t_n127 <= primitive_t_n125(19 downto 0);
    primitive_t_n128 <= primitive_t_n127 & primitive_t_n91;
    primitive_t_n129 <= primitive_t_n128 when primitive_t_n126(0) = '1' else primitive_t_n125;
    primitive_t_n130 <= primitive_t_places(3 downto 3);
    primitive_t_n131 <= primitive_t_n129(27 downto 0);
    primitive_t_n132 <= primitive_t_n131 & primitive_t_n97;
    primitive_t_n133 <= primitive_t_n132 when primitive_t_n130(0) = '1' else primitive_t_n129;
    primitive_t_n134 <= primitive_t_places(2 downto 2);
    primitive_t_n135 <= primitive_t_n133(31 downto 0);
    primitive_t_n136 <= primitive_t_n135 & primitive_t_n103;
    primitive_t_n137 <= primitive_t_n136 when primitive_t_n134(0) = '1' else primitive_t_n133;
    primitive_t_n138 <= primitive_t_places(1 downto 1);
    primitive_t_n139 <= primitive_t_n137(33 downto 0);
    primitive_t_n140 <= primitive_t_n139 & primitive_t_n109;
    primitive_t_n141 <= primitive_t_n140 when primitive_t_n138(0) = '1' else primitive_t_n137;
    primitive_t_n142 <= primitive_t_places(0 downto 0);
    primitive_t_n143 <= primitive_t_n141(34 downto 0);
    primitive_t_n144 <= primitive_t_n143 & primitive_n34;
    primitive_t_n153 <= primitive_t_n152_s4 when primitive_t_n122(0) = '1' else primitive_t_n150_s4;
    primitive_t_n154 <= primitive_t_n153(19 downto 0);
    primitive_t_n155 <= primitive_t_n154 & primitive_t_n91;
    primitive_t_n156 <= primitive_t_n155 when primitive_t_n126(0) = '1' else primitive_t_n153;
    primitive_t_n157 <= primitive_t_n156(27 downto 0);
    primitive_t_n158 <= primitive_t_n157 & primitive_t_n97;
    primitive_t_n159 <= primitive_t_n158 when primitive_t_n130(0) = '1' else primitive_t_n156;
    primitive_t_n160 <= primitive_t_n159(31 downto 0);
    primitive_t_n161 <= primitive_t_n160 & primitive_t_n103;
    primitive_t_n162 <= primitive_t_n161 when primitive_t_n134(0) = '1' else primitive_t_n159;
    primitive_t_n163 <= primitive_t_n162(33 downto 0);
    primitive_t_n164 <= primitive_t_n163 & primitive_t_n109;
    primitive_t_n165 <= primitive_t_n164 when primitive_t_n138(0) = '1' else primitive_t_n162;
    primitive_t_n166 <= primitive_t_n165(34 downto 0);
    primitive_t_n167 <= primitive_t_n166 & primitive_n34;
    primitive_t_n176 <= primitive_t_n175_s4 when primitive_t_n122(0) = '1' else primitive_t_n173_s4;
    primitive_t_n177 <= primitive_t_n176(19 downto 0);
    primitive_t_n178 <= primitive_t_n177 & primitive_t_n91;
    primitive_t_n179 <= primitive_t_n178 when primitive_t_n126(0) = '1' else primitive_t_n176;
    primitive_t_n180 <= primitive_t_n179(27 downto 0);
    primitive_t_n181 <= primitive_t_n180 & primitive_t_n97;
    primitive_t_n182 <= primitive_t_n181 when primitive_t_n130(0) = '1' else primitive_t_n179;
    primitive_t_n183 <= primitive_t_n182(31 downto 0);
    primitive_t_n184 <= primitive_t_n183 & primitive_t_n103;
    primitive_t_n185 <= primitive_t_n184 when primitive_t_n134(0) = '1' else primitive_t_n182;
    primitive_t_n186 <= primitive_t_n185(33 downto 0);
    primitive_t_n187 <= primitive_t_n186 & primitive_t_n109;
    primitive_t_n188 <= primitive_t_n187 when primitive_t_n138(0) = '1' else primitive_t_n185;
    primitive_t_n189 <= primitive_t_n188(34 downto 0);
    primitive_t_n190 <= primitive_t_n189 & primitive_n34;
    -- primitive.n
    primitive_n_n290 <= "1" when primitive_n_n289_s4 = resize(primitive_n34, 2) else "0";
    primitive_n_n293 <= primitive_n_n292_s4 when primitive_n_n290(0) = '1' else primitive_n_n288_s4;
    primitive_n_n294 <= primitive_n_n293(34 downto 34);
    primitive_n_n295 <= "1" when primitive_n_n294 = primitive_n34 else "0";
    primitive_n_n299 <= primitive_n_n298_s4 & primitive_n_n290;
    primitive_n_places <= primitive_n_n299 & primitive_n_n295;
    primitive_n_n304 <= primitive_n_places(5 downto 5);
    primitive_n_n307 <= primitive_n_n306_s4 when primitive_n_n304(0) = '1' else primitive_n_n303_s4;
    primitive_n_n308 <= primitive_n_places(4 downto 4);
    primitive_n_n309 <= primitive_n_n307(19 downto 0);
    primitive_n_n310 <= primitive_n_n309 & primitive_t_n91;
    primitive_n_n311 <= primitive_n_n310 when primitive_n_n308(0) = '1' else primitive_n_n307;
    primitive_n_n312 <= primitive_n_places(3 downto 3);
    primitive_n_n313 <= primitive_n_n311(27 downto 0);
    primitive_n_n314 <= primitive_n_n313 & primitive_t_n97;
    primitive_n_n315 <= primitive_n_n314 when primitive_n_n312(0) = '1' else primitive_n_n311;
    primitive_n_n316 <= primitive_n_places(2 downto 2);
    primitive_n_n317 <= primitive_n_n315(31 downto 0);
    primitive_n_n318 <= primitive_n_n317 & primitive_t_n103;
    primitive_n_n319 <= primitive_n_n318 when primitive_n_n316(0) = '1' else primitive_n_n315;
    primitive_n_n320 <= primitive_n_places(1 downto 1);
    primitive_n_n321 <= primitive_n_n319(33 downto 0);
    primitive_n_n322 <= primitive_n_n321 & primitive_t_n109;
    primitive_n_n323 <= primitive_n_n322 when primitive_n_n320(0) = '1' else primitive_n_n319;
    primitive_n_n324 <= primitive_n_places(0 downto 0);
    primitive_n_n325 <= primitive_n_n323(34 downto 0);
    primitive_n_n326 <= primitive_n_n325 & primitive_n34;
    primitive_n_n335 <= primitive_n_n334_s4 when primitive_n_n304(0) = '1' else primitive_n_n332_s4;
    primitive_n_n336 <= primitive_n_n335(19 downto 0);
    primitive_n_n337 <= primitive_n_n336 & primitive_t_n91;
    primitive_n_n338 <= primitive_n_n337 when primitive_n_n308(0) = '1' else primitive_n_n335;
    primitive_n_n339 <= primitive_n_n338(27 downto 0);
    primitive_n_n340 <= primitive_n_n339 & primitive_t_n97;
    primitive_n_n341 <= primitive_n_n340 when primitive_n_n312(0) = '1' else primitive_n_n338;
    primitive_n_n342 <= primitive_n_n341(31 downto 0);
    primitive_n_n343 <= primitive_n_n342 & primitive_t_n103;
    primitive_n_n344 <= primitive_n_n343 when primitive_n_n316(0) = '1' else primitive_n_n341;
    primitive_n_n345 <= primitive_n_n344(33 downto 0);
    primitive_n_n346 <= primitive_n_n345 & primitive_t_n109;
    primitive_n_n347 <= primitive_n_n346 when primitive_n_n320(0) = '1' else primitive_n_n344;
    primitive_n_n348 <= primitive_n_n347(34 downto 0);
    primitive_n_n349 <= primitive_n_n348 & primitive_n34;
    primitive_n_n358 <= primitive_n_n357_s4 when primitive_n_n304(0) = '1' else primitive_n_n355_s4;
    primitive_n_n359 <= primitive_n_n358(19 downto 0);
    primitive_n_n360 <= primitive_n_n359 & primitive_t_n91;
    primitive_n_n361 <= primitive_n_n360 when primitive_n_n308(0) = '1' else primitive_n_n358;
    primitive_n_n362 <= primitive_n_n361(27 downto 0);
    primitive_n_n363 <= primitive_n_n362 & primitive_t_n97;
    primitive_n_n364 <= primitive_n_n363 when primitive_n_n312(0) = '1' else primitive_n_n361;
    primitive_n_n365 <= primitive_n_n364(31 downto 0);
    primitive_n_n366 <= primitive_n_n365 & primitive_t_n103;
    primitive_n_n367 <= primitive_n_n366 when primitive_n_n316(0) = '1' else primitive_n_n364;
    primitive_n_n368 <= primitive_n_n367(33 downto 0);
    primitive_n_n369 <= primitive_n_n368 & primitive_t_n109;
    primitive_n_n370 <= primitive_n_n369 when primitive_n_n320(0) = '1' else primitive_n_n367;
    primitive_n_n371 <= primitive_n_n370(34 downto 0);
    primitive_n_n372 <= primitive_n_n371 & primitive_n34;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s5 <= view_x_s4;
                view_y_s5 <= view_y_s4;
                view_z_s5 <= view_z_s4;
                light0_x_s5 <= light0_x_s4;
                light0_y_s5 <= light0_y_s4;
                light0_z_s5 <= light0_z_s4;
                primitive_zero_uv_s5 <= primitive_zero_uv_s4;
                primitive_mirrored_s5 <= primitive_mirrored_s4;
                primitive_zero_area_s5 <= primitive_zero_area_s4;
                primitive_degenerate_s5 <= primitive_degenerate_s4;
                primitive_t_n141_s5 <= primitive_t_n141;
                primitive_t_n142_s5 <= primitive_t_n142;
                primitive_t_n144_s5 <= primitive_t_n144;
                primitive_t_n165_s5 <= primitive_t_n165;
                primitive_t_n167_s5 <= primitive_t_n167;
                primitive_t_n188_s5 <= primitive_t_n188;
                primitive_t_n190_s5 <= primitive_t_n190;
                primitive_n_n323_s5 <= primitive_n_n323;
                primitive_n_n324_s5 <= primitive_n_n324;
                primitive_n_n326_s5 <= primitive_n_n326;
                primitive_n_n347_s5 <= primitive_n_n347;
                primitive_n_n349_s5 <= primitive_n_n349;
                primitive_n_n370_s5 <= primitive_n_n370;
                primitive_n_n372_s5 <= primitive_n_n372;
                primitive_n447_s5 <= primitive_n447_s4;
            end if;
            if rst = '1' then
                valid_s5 <= '0';
            elsif ce = '1' then
                valid_s5 <= valid_s4;
            end if;
        end if;
    end process;

    -- ---- stage 5 ----
    -- primitive.t
    primitive_t_n145 <= primitive_t_n144_s5 when primitive_t_n142_s5(0) = '1' else primitive_t_n141_s5;
    primitive_t_n146 <= signed(primitive_t_n145);
    primitive_t_x <= primitive_t_n146;
    primitive_t_n168 <= primitive_t_n167_s5 when primitive_t_n142_s5(0) = '1' else primitive_t_n165_s5;
    primitive_t_n169 <= signed(primitive_t_n168);
    primitive_t_y <= primitive_t_n169;
    primitive_t_n191 <= primitive_t_n190_s5 when primitive_t_n142_s5(0) = '1' else primitive_t_n188_s5;
    primitive_t_n192 <= signed(primitive_t_n191);
    primitive_t_z <= primitive_t_n192;
    -- primitive
    primitive_t_norm_x_sum <= resize(primitive_t_x, 37) + 37x"0000020000";
    primitive_t_norm_x_cut <= primitive_t_norm_x_sum(36 downto 18);
    primitive_t_norm_x_over <= "1" when primitive_t_norm_x_cut(18) = '0' and (or primitive_t_norm_x_cut(17 downto 17)) = '1' else "0";
    primitive_t_norm_x <= 18x"1ffff" when primitive_t_norm_x_over(0) = '1' else primitive_t_norm_x_cut(17 downto 0);
    primitive_t_norm_y_sum <= resize(primitive_t_y, 37) + 37x"0000020000";
    primitive_t_norm_y_cut <= primitive_t_norm_y_sum(36 downto 18);
    primitive_t_norm_y_over <= "1" when primitive_t_norm_y_cut(18) = '0' and (or primitive_t_norm_y_cut(17 downto 17)) = '1' else "0";
    primitive_t_norm_y <= 18x"1ffff" when primitive_t_norm_y_over(0) = '1' else primitive_t_norm_y_cut(17 downto 0);
    primitive_t_norm_z_sum <= resize(primitive_t_z, 37) + 37x"0000020000";
    primitive_t_norm_z_cut <= primitive_t_norm_z_sum(36 downto 18);
    primitive_t_norm_z_over <= "1" when primitive_t_norm_z_cut(18) = '0' and (or primitive_t_norm_z_cut(17 downto 17)) = '1' else "0";
    primitive_t_norm_z <= 18x"1ffff" when primitive_t_norm_z_over(0) = '1' else primitive_t_norm_z_cut(17 downto 0);
    -- primitive.n
    primitive_n_n327 <= primitive_n_n326_s5 when primitive_n_n324_s5(0) = '1' else primitive_n_n323_s5;
    primitive_n_n328 <= signed(primitive_n_n327);
    primitive_n_x <= primitive_n_n328;
    primitive_n_n350 <= primitive_n_n349_s5 when primitive_n_n324_s5(0) = '1' else primitive_n_n347_s5;
    primitive_n_n351 <= signed(primitive_n_n350);
    primitive_n_y <= primitive_n_n351;
    primitive_n_n373 <= primitive_n_n372_s5 when primitive_n_n324_s5(0) = '1' else primitive_n_n370_s5;
    primitive_n_n374 <= signed(primitive_n_n373);
    primitive_n_z <= primitive_n_n374;
    -- primitive
    primitive_n_norm_x_sum <= resize(primitive_n_x, 37) + 37x"0000020000";
    primitive_n_norm_x_cut <= primitive_n_norm_x_sum(36 downto 18);
    primitive_n_norm_x_over <= "1" when primitive_n_norm_x_cut(18) = '0' and (or primitive_n_norm_x_cut(17 downto 17)) = '1' else "0";
    primitive_n_norm_x <= 18x"1ffff" when primitive_n_norm_x_over(0) = '1' else primitive_n_norm_x_cut(17 downto 0);
    primitive_n_norm_y_sum <= resize(primitive_n_y, 37) + 37x"0000020000";
    primitive_n_norm_y_cut <= primitive_n_norm_y_sum(36 downto 18);
    primitive_n_norm_y_over <= "1" when primitive_n_norm_y_cut(18) = '0' and (or primitive_n_norm_y_cut(17 downto 17)) = '1' else "0";
    primitive_n_norm_y <= 18x"1ffff" when primitive_n_norm_y_over(0) = '1' else primitive_n_norm_y_cut(17 downto 0);
    primitive_n_norm_z_sum <= resize(primitive_n_z, 37) + 37x"0000020000";
    primitive_n_norm_z_cut <= primitive_n_norm_z_sum(36 downto 18);
    primitive_n_norm_z_over <= "1" when primitive_n_norm_z_cut(18) = '0' and (or primitive_n_norm_z_cut(17 downto 17)) = '1' else "0";
    primitive_n_norm_z <= 18x"1ffff" when primitive_n_norm_z_over(0) = '1' else primitive_n_norm_z_cut(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s6 <= view_x_s5;
                view_y_s6 <= view_y_s5;
                view_z_s6 <= view_z_s5;
                light0_x_s6 <= light0_x_s5;
                light0_y_s6 <= light0_y_s5;
                light0_z_s6 <= light0_z_s5;
                primitive_zero_uv_s6 <= primitive_zero_uv_s5;
                primitive_mirrored_s6 <= primitive_mirrored_s5;
                primitive_zero_area_s6 <= primitive_zero_area_s5;
                primitive_degenerate_s6 <= primitive_degenerate_s5;
                primitive_t_norm_x_s6 <= primitive_t_norm_x;
                primitive_t_norm_y_s6 <= primitive_t_norm_y;
                primitive_t_norm_z_s6 <= primitive_t_norm_z;
                primitive_n_norm_x_s6 <= primitive_n_norm_x;
                primitive_n_norm_y_s6 <= primitive_n_norm_y;
                primitive_n_norm_z_s6 <= primitive_n_norm_z;
                primitive_n447_s6 <= primitive_n447_s5;
            end if;
            if rst = '1' then
                valid_s6 <= '0';
            elsif ce = '1' then
                valid_s6 <= valid_s5;
            end if;
        end if;
    end process;

    -- ---- stage 6 ----
    -- primitive.t_square
    primitive_t_square_n197 <= primitive_t_norm_x_s6 * primitive_t_norm_x_s6;
    primitive_t_square_n198 <= primitive_t_norm_y_s6 * primitive_t_norm_y_s6;
    primitive_t_square_n199 <= primitive_t_norm_z_s6 * primitive_t_norm_z_s6;
    -- primitive.n_square
    primitive_n_square_n379 <= primitive_n_norm_x_s6 * primitive_n_norm_x_s6;
    primitive_n_square_n380 <= primitive_n_norm_y_s6 * primitive_n_norm_y_s6;
    primitive_n_square_n381 <= primitive_n_norm_z_s6 * primitive_n_norm_z_s6;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s7 <= view_x_s6;
                view_y_s7 <= view_y_s6;
                view_z_s7 <= view_z_s6;
                light0_x_s7 <= light0_x_s6;
                light0_y_s7 <= light0_y_s6;
                light0_z_s7 <= light0_z_s6;
                primitive_zero_uv_s7 <= primitive_zero_uv_s6;
                primitive_mirrored_s7 <= primitive_mirrored_s6;
                primitive_zero_area_s7 <= primitive_zero_area_s6;
                primitive_degenerate_s7 <= primitive_degenerate_s6;
                primitive_t_norm_x_s7 <= primitive_t_norm_x_s6;
                primitive_t_norm_y_s7 <= primitive_t_norm_y_s6;
                primitive_t_norm_z_s7 <= primitive_t_norm_z_s6;
                primitive_t_square_n197_s7 <= primitive_t_square_n197;
                primitive_t_square_n198_s7 <= primitive_t_square_n198;
                primitive_t_square_n199_s7 <= primitive_t_square_n199;
                primitive_n_norm_x_s7 <= primitive_n_norm_x_s6;
                primitive_n_norm_y_s7 <= primitive_n_norm_y_s6;
                primitive_n_norm_z_s7 <= primitive_n_norm_z_s6;
                primitive_n_square_n379_s7 <= primitive_n_square_n379;
                primitive_n_square_n380_s7 <= primitive_n_square_n380;
                primitive_n_square_n381_s7 <= primitive_n_square_n381;
                primitive_n447_s7 <= primitive_n447_s6;
            end if;
            if rst = '1' then
                valid_s7 <= '0';
            elsif ce = '1' then
                valid_s7 <= valid_s6;
            end if;
        end if;
    end process;

    -- ---- stage 7 ----
    -- primitive.t_square
    primitive_t_square_n200 <= resize(primitive_t_square_n197_s7, 37) + resize(primitive_t_square_n198_s7, 37);
    primitive_t_square_n201 <= resize(primitive_t_square_n200, 38) + resize(primitive_t_square_n199_s7, 38);
    -- primitive.n_square
    primitive_n_square_n382 <= resize(primitive_n_square_n379_s7, 37) + resize(primitive_n_square_n380_s7, 37);
    primitive_n_square_n383 <= resize(primitive_n_square_n382, 38) + resize(primitive_n_square_n381_s7, 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s8 <= view_x_s7;
                view_y_s8 <= view_y_s7;
                view_z_s8 <= view_z_s7;
                light0_x_s8 <= light0_x_s7;
                light0_y_s8 <= light0_y_s7;
                light0_z_s8 <= light0_z_s7;
                primitive_zero_uv_s8 <= primitive_zero_uv_s7;
                primitive_mirrored_s8 <= primitive_mirrored_s7;
                primitive_zero_area_s8 <= primitive_zero_area_s7;
                primitive_degenerate_s8 <= primitive_degenerate_s7;
                primitive_t_norm_x_s8 <= primitive_t_norm_x_s7;
                primitive_t_norm_y_s8 <= primitive_t_norm_y_s7;
                primitive_t_norm_z_s8 <= primitive_t_norm_z_s7;
                primitive_t_square_n201_s8 <= primitive_t_square_n201;
                primitive_n_norm_x_s8 <= primitive_n_norm_x_s7;
                primitive_n_norm_y_s8 <= primitive_n_norm_y_s7;
                primitive_n_norm_z_s8 <= primitive_n_norm_z_s7;
                primitive_n_square_n383_s8 <= primitive_n_square_n383;
                primitive_n447_s8 <= primitive_n447_s7;
            end if;
            if rst = '1' then
                valid_s8 <= '0';
            elsif ce = '1' then
                valid_s8 <= valid_s7;
            end if;
        end if;
    end process;

    -- ---- stage 8 ----
    -- primitive
    primitive_t_length_square_sum <= resize(primitive_t_square_n201_s8, 39) + 39x"0000002000";
    primitive_t_length_square_cut <= primitive_t_length_square_sum(38 downto 14);
    primitive_t_length_square_over <= "1" when primitive_t_length_square_cut(24) = '0' and (or primitive_t_length_square_cut(23 downto 22)) = '1' else "0";
    primitive_t_length_square_under <= unsigned(primitive_t_length_square_cut(24 downto 24));
    primitive_t_length_square <= 22x"3fffff" when primitive_t_length_square_over(0) = '1' else 22x"000000" when primitive_t_length_square_under(0) = '1' else unsigned(primitive_t_length_square_cut(21 downto 0));
    -- primitive.t_length
    primitive_t_length_n203 <= primitive_t_length_square;
    primitive_t_length_n204 <= primitive_t_length_n203;
    primitive_t_length_n205 <= primitive_t_length_n204(21 downto 6);
    primitive_t_length_n206 <= "1" when primitive_t_length_n205 = resize(primitive_n34, 16) else "0";
    primitive_t_length_n207 <= primitive_t_length_n204(5 downto 0);
    primitive_t_length_n208 <= primitive_t_length_n207 & primitive_t_n91;
    primitive_t_length_n209 <= primitive_t_length_n208 when primitive_t_length_n206(0) = '1' else primitive_t_length_n204;
    primitive_t_length_n210 <= primitive_t_length_n209(21 downto 14);
    primitive_t_length_n211 <= "1" when primitive_t_length_n210 = resize(primitive_n34, 8) else "0";
    primitive_t_length_n212 <= primitive_t_length_n209(13 downto 0);
    primitive_t_length_n213 <= primitive_t_length_n212 & primitive_t_n97;
    primitive_t_length_n225 <= primitive_t_length_n206 & primitive_t_length_n211;
    primitive_t_length_n245 <= "1" when primitive_t_length_square = shift_left(resize(primitive_n34, 22), 20) else "0";
    -- primitive
    primitive_n_length_square_sum <= resize(primitive_n_square_n383_s8, 39) + 39x"0000002000";
    primitive_n_length_square_cut <= primitive_n_length_square_sum(38 downto 14);
    primitive_n_length_square_over <= "1" when primitive_n_length_square_cut(24) = '0' and (or primitive_n_length_square_cut(23 downto 22)) = '1' else "0";
    primitive_n_length_square_under <= unsigned(primitive_n_length_square_cut(24 downto 24));
    primitive_n_length_square <= 22x"3fffff" when primitive_n_length_square_over(0) = '1' else 22x"000000" when primitive_n_length_square_under(0) = '1' else unsigned(primitive_n_length_square_cut(21 downto 0));
    -- primitive.n_length
    primitive_n_length_n385 <= primitive_n_length_square;
    primitive_n_length_n386 <= primitive_n_length_n385;
    primitive_n_length_n387 <= primitive_n_length_n386(21 downto 6);
    primitive_n_length_n388 <= "1" when primitive_n_length_n387 = resize(primitive_n34, 16) else "0";
    primitive_n_length_n389 <= primitive_n_length_n386(5 downto 0);
    primitive_n_length_n390 <= primitive_n_length_n389 & primitive_t_n91;
    primitive_n_length_n391 <= primitive_n_length_n390 when primitive_n_length_n388(0) = '1' else primitive_n_length_n386;
    primitive_n_length_n392 <= primitive_n_length_n391(21 downto 14);
    primitive_n_length_n393 <= "1" when primitive_n_length_n392 = resize(primitive_n34, 8) else "0";
    primitive_n_length_n394 <= primitive_n_length_n391(13 downto 0);
    primitive_n_length_n395 <= primitive_n_length_n394 & primitive_t_n97;
    primitive_n_length_n407 <= primitive_n_length_n388 & primitive_n_length_n393;
    primitive_n_length_n425 <= "1" when primitive_n_length_square = shift_left(resize(primitive_n34, 22), 20) else "0";

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s9 <= view_x_s8;
                view_y_s9 <= view_y_s8;
                view_z_s9 <= view_z_s8;
                light0_x_s9 <= light0_x_s8;
                light0_y_s9 <= light0_y_s8;
                light0_z_s9 <= light0_z_s8;
                primitive_zero_uv_s9 <= primitive_zero_uv_s8;
                primitive_mirrored_s9 <= primitive_mirrored_s8;
                primitive_zero_area_s9 <= primitive_zero_area_s8;
                primitive_degenerate_s9 <= primitive_degenerate_s8;
                primitive_t_norm_x_s9 <= primitive_t_norm_x_s8;
                primitive_t_norm_y_s9 <= primitive_t_norm_y_s8;
                primitive_t_norm_z_s9 <= primitive_t_norm_z_s8;
                primitive_t_length_n209_s9 <= primitive_t_length_n209;
                primitive_t_length_n211_s9 <= primitive_t_length_n211;
                primitive_t_length_n213_s9 <= primitive_t_length_n213;
                primitive_t_length_n225_s9 <= primitive_t_length_n225;
                primitive_t_length_n245_s9 <= primitive_t_length_n245;
                primitive_n_norm_x_s9 <= primitive_n_norm_x_s8;
                primitive_n_norm_y_s9 <= primitive_n_norm_y_s8;
                primitive_n_norm_z_s9 <= primitive_n_norm_z_s8;
                primitive_n_length_n391_s9 <= primitive_n_length_n391;
                primitive_n_length_n393_s9 <= primitive_n_length_n393;
                primitive_n_length_n395_s9 <= primitive_n_length_n395;
                primitive_n_length_n407_s9 <= primitive_n_length_n407;
                primitive_n_length_n425_s9 <= primitive_n_length_n425;
                primitive_n447_s9 <= primitive_n447_s8;
            end if;
            if rst = '1' then
                valid_s9 <= '0';
            elsif ce = '1' then
                valid_s9 <= valid_s8;
            end if;
        end if;
    end process;

    -- ---- stage 9 ----
    -- primitive.t_length
    primitive_t_length_n214 <= primitive_t_length_n213_s9 when primitive_t_length_n211_s9(0) = '1' else primitive_t_length_n209_s9;
    primitive_t_length_n215 <= primitive_t_length_n214(21 downto 18);
    primitive_t_length_n216 <= "1" when primitive_t_length_n215 = resize(primitive_n34, 4) else "0";
    primitive_t_length_n217 <= primitive_t_length_n214(17 downto 0);
    primitive_t_length_n218 <= primitive_t_length_n217 & primitive_t_n103;
    primitive_t_length_n219 <= primitive_t_length_n218 when primitive_t_length_n216(0) = '1' else primitive_t_length_n214;
    primitive_t_length_n220 <= primitive_t_length_n219(21 downto 20);
    primitive_t_length_n221 <= "1" when primitive_t_length_n220 = resize(primitive_n34, 2) else "0";
    primitive_t_length_n222 <= primitive_t_length_n219(19 downto 0);
    primitive_t_length_n223 <= primitive_t_length_n222 & primitive_t_n109;
    primitive_t_length_n224 <= primitive_t_length_n223 when primitive_t_length_n221(0) = '1' else primitive_t_length_n219;
    primitive_t_length_n226 <= primitive_t_length_n225_s9 & primitive_t_length_n216;
    primitive_t_length_n227 <= primitive_t_length_n226 & primitive_t_length_n221;
    primitive_t_length_n228 <= primitive_t_length_n224(21 downto 20);
    primitive_t_length_n230 <= signed(resize(primitive_t_length_n228, 3)) - signed(resize(primitive_t_length_n229, 3));
    primitive_t_length_n231 <= unsigned(primitive_t_length_n230(1 downto 0));
    primitive_t_length_n232 <= primitive_t_length_n224(19 downto 2);
    primitive_t_length_n233 <= primitive_t_length_n231 & primitive_t_length_n232;
    primitive_t_length_n234 <= primitive_t_length_n233;
    -- primitive.t_length.recip_root
    primitive_t_length_recip_root_n235 <= primitive_t_length_n234(19 downto 12);
    primitive_t_length_recip_root_n238 <= primitive_t_length_n234(11 downto 0);
    -- primitive.n_length
    primitive_n_length_n396 <= primitive_n_length_n395_s9 when primitive_n_length_n393_s9(0) = '1' else primitive_n_length_n391_s9;
    primitive_n_length_n397 <= primitive_n_length_n396(21 downto 18);
    primitive_n_length_n398 <= "1" when primitive_n_length_n397 = resize(primitive_n34, 4) else "0";
    primitive_n_length_n399 <= primitive_n_length_n396(17 downto 0);
    primitive_n_length_n400 <= primitive_n_length_n399 & primitive_t_n103;
    primitive_n_length_n401 <= primitive_n_length_n400 when primitive_n_length_n398(0) = '1' else primitive_n_length_n396;
    primitive_n_length_n402 <= primitive_n_length_n401(21 downto 20);
    primitive_n_length_n403 <= "1" when primitive_n_length_n402 = resize(primitive_n34, 2) else "0";
    primitive_n_length_n404 <= primitive_n_length_n401(19 downto 0);
    primitive_n_length_n405 <= primitive_n_length_n404 & primitive_t_n109;
    primitive_n_length_n406 <= primitive_n_length_n405 when primitive_n_length_n403(0) = '1' else primitive_n_length_n401;
    primitive_n_length_n408 <= primitive_n_length_n407_s9 & primitive_n_length_n398;
    primitive_n_length_n409 <= primitive_n_length_n408 & primitive_n_length_n403;
    primitive_n_length_n410 <= primitive_n_length_n406(21 downto 20);
    primitive_n_length_n411 <= signed(resize(primitive_n_length_n410, 3)) - signed(resize(primitive_t_length_n229, 3));
    primitive_n_length_n412 <= unsigned(primitive_n_length_n411(1 downto 0));
    primitive_n_length_n413 <= primitive_n_length_n406(19 downto 2);
    primitive_n_length_n414 <= primitive_n_length_n412 & primitive_n_length_n413;
    primitive_n_length_n415 <= primitive_n_length_n414;
    -- primitive.n_length.recip_root
    primitive_n_length_recip_root_n416 <= primitive_n_length_n415(19 downto 12);
    primitive_n_length_recip_root_n419 <= primitive_n_length_n415(11 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s10 <= view_x_s9;
                view_y_s10 <= view_y_s9;
                view_z_s10 <= view_z_s9;
                light0_x_s10 <= light0_x_s9;
                light0_y_s10 <= light0_y_s9;
                light0_z_s10 <= light0_z_s9;
                primitive_zero_uv_s10 <= primitive_zero_uv_s9;
                primitive_mirrored_s10 <= primitive_mirrored_s9;
                primitive_zero_area_s10 <= primitive_zero_area_s9;
                primitive_degenerate_s10 <= primitive_degenerate_s9;
                primitive_t_norm_x_s10 <= primitive_t_norm_x_s9;
                primitive_t_norm_y_s10 <= primitive_t_norm_y_s9;
                primitive_t_norm_z_s10 <= primitive_t_norm_z_s9;
                primitive_t_length_n227_s10 <= primitive_t_length_n227;
                recip_root_row <= recip_root_rom(to_integer(primitive_t_length_recip_root_n235));
                primitive_t_length_recip_root_n238_s10 <= primitive_t_length_recip_root_n238;
                primitive_t_length_n245_s10 <= primitive_t_length_n245_s9;
                primitive_n_norm_x_s10 <= primitive_n_norm_x_s9;
                primitive_n_norm_y_s10 <= primitive_n_norm_y_s9;
                primitive_n_norm_z_s10 <= primitive_n_norm_z_s9;
                primitive_n_length_n409_s10 <= primitive_n_length_n409;
                recip_root_row_2 <= recip_root_rom(to_integer(primitive_n_length_recip_root_n416));
                primitive_n_length_recip_root_n419_s10 <= primitive_n_length_recip_root_n419;
                primitive_n_length_n425_s10 <= primitive_n_length_n425_s9;
                primitive_n447_s10 <= primitive_n447_s9;
            end if;
            if rst = '1' then
                valid_s10 <= '0';
            elsif ce = '1' then
                valid_s10 <= valid_s9;
            end if;
        end if;
    end process;

    -- ---- stage 10 ----
    -- primitive.t_length.recip_root
    primitive_t_length_recip_root_n236 <= recip_root_row(39 downto 17);
    primitive_t_length_recip_root_n237 <= signed(recip_root_row(16 downto 0));
    -- primitive.n_length.recip_root
    primitive_n_length_recip_root_n417 <= recip_root_row_2(39 downto 17);
    primitive_n_length_recip_root_n418 <= signed(recip_root_row_2(16 downto 0));

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s11 <= view_x_s10;
                view_y_s11 <= view_y_s10;
                view_z_s11 <= view_z_s10;
                light0_x_s11 <= light0_x_s10;
                light0_y_s11 <= light0_y_s10;
                light0_z_s11 <= light0_z_s10;
                primitive_zero_uv_s11 <= primitive_zero_uv_s10;
                primitive_mirrored_s11 <= primitive_mirrored_s10;
                primitive_zero_area_s11 <= primitive_zero_area_s10;
                primitive_degenerate_s11 <= primitive_degenerate_s10;
                primitive_t_norm_x_s11 <= primitive_t_norm_x_s10;
                primitive_t_norm_y_s11 <= primitive_t_norm_y_s10;
                primitive_t_norm_z_s11 <= primitive_t_norm_z_s10;
                primitive_t_length_n227_s11 <= primitive_t_length_n227_s10;
                primitive_t_length_recip_root_n236_s11 <= primitive_t_length_recip_root_n236;
                primitive_t_length_recip_root_n237_s11 <= primitive_t_length_recip_root_n237;
                primitive_t_length_recip_root_n238_s11 <= primitive_t_length_recip_root_n238_s10;
                primitive_t_length_n245_s11 <= primitive_t_length_n245_s10;
                primitive_n_norm_x_s11 <= primitive_n_norm_x_s10;
                primitive_n_norm_y_s11 <= primitive_n_norm_y_s10;
                primitive_n_norm_z_s11 <= primitive_n_norm_z_s10;
                primitive_n_length_n409_s11 <= primitive_n_length_n409_s10;
                primitive_n_length_recip_root_n417_s11 <= primitive_n_length_recip_root_n417;
                primitive_n_length_recip_root_n418_s11 <= primitive_n_length_recip_root_n418;
                primitive_n_length_recip_root_n419_s11 <= primitive_n_length_recip_root_n419_s10;
                primitive_n_length_n425_s11 <= primitive_n_length_n425_s10;
                primitive_n447_s11 <= primitive_n447_s10;
            end if;
            if rst = '1' then
                valid_s11 <= '0';
            elsif ce = '1' then
                valid_s11 <= valid_s10;
            end if;
        end if;
    end process;

    -- ---- stage 11 ----
    -- primitive.t_length.recip_root
    primitive_t_length_recip_root_n239 <= resize(primitive_t_length_recip_root_n237_s11 * signed('0' & primitive_t_length_recip_root_n238_s11), 29);
    primitive_t_length_recip_root_n240 <= signed(shift_left(resize(primitive_t_length_recip_root_n236_s11, 37), 12)) + resize(primitive_t_length_recip_root_n239, 37);
    -- primitive.n_length.recip_root
    primitive_n_length_recip_root_n420 <= resize(primitive_n_length_recip_root_n418_s11 * signed('0' & primitive_n_length_recip_root_n419_s11), 29);
    primitive_n_length_recip_root_n421 <= signed(shift_left(resize(primitive_n_length_recip_root_n417_s11, 37), 12)) + resize(primitive_n_length_recip_root_n420, 37);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s12 <= view_x_s11;
                view_y_s12 <= view_y_s11;
                view_z_s12 <= view_z_s11;
                light0_x_s12 <= light0_x_s11;
                light0_y_s12 <= light0_y_s11;
                light0_z_s12 <= light0_z_s11;
                primitive_zero_uv_s12 <= primitive_zero_uv_s11;
                primitive_mirrored_s12 <= primitive_mirrored_s11;
                primitive_zero_area_s12 <= primitive_zero_area_s11;
                primitive_degenerate_s12 <= primitive_degenerate_s11;
                primitive_t_norm_x_s12 <= primitive_t_norm_x_s11;
                primitive_t_norm_y_s12 <= primitive_t_norm_y_s11;
                primitive_t_norm_z_s12 <= primitive_t_norm_z_s11;
                primitive_t_length_n227_s12 <= primitive_t_length_n227_s11;
                primitive_t_length_recip_root_n240_s12 <= primitive_t_length_recip_root_n240;
                primitive_t_length_n245_s12 <= primitive_t_length_n245_s11;
                primitive_n_norm_x_s12 <= primitive_n_norm_x_s11;
                primitive_n_norm_y_s12 <= primitive_n_norm_y_s11;
                primitive_n_norm_z_s12 <= primitive_n_norm_z_s11;
                primitive_n_length_n409_s12 <= primitive_n_length_n409_s11;
                primitive_n_length_recip_root_n421_s12 <= primitive_n_length_recip_root_n421;
                primitive_n_length_n425_s12 <= primitive_n_length_n425_s11;
                primitive_n447_s12 <= primitive_n447_s11;
            end if;
            if rst = '1' then
                valid_s12 <= '0';
            elsif ce = '1' then
                valid_s12 <= valid_s11;
            end if;
        end if;
    end process;

    -- ---- stage 12 ----
    -- primitive.t_length.recip_root
    primitive_t_length_recip_root_n241_sum <= resize(primitive_t_length_recip_root_n240_s12, 38) + 38x"0000002000";
    primitive_t_length_recip_root_n241_cut <= primitive_t_length_recip_root_n241_sum(37 downto 14);
    primitive_t_length_recip_root_n241_over <= "1" when primitive_t_length_recip_root_n241_cut(23) = '0' and (or primitive_t_length_recip_root_n241_cut(22 downto 22)) = '1' else "0";
    primitive_t_length_recip_root_n241_under <= unsigned(primitive_t_length_recip_root_n241_cut(23 downto 23));
    primitive_t_length_recip_root_n241 <= 22x"3fffff" when primitive_t_length_recip_root_n241_over(0) = '1' else 22x"000000" when primitive_t_length_recip_root_n241_under(0) = '1' else unsigned(primitive_t_length_recip_root_n241_cut(21 downto 0));
    -- primitive.t_length
    primitive_t_length_n242_past <= "1" when 4x"b" < primitive_t_length_n227_s12 else "0";
    primitive_t_length_n242_count <= 4x"b" when primitive_t_length_n242_past(0) = '1' else primitive_t_length_n227_s12;
    primitive_t_length_n242 <= shift_left(resize(primitive_t_length_recip_root_n241, 33), to_integer(primitive_t_length_n242_count));
    primitive_t_length_n243 <= primitive_t_length_n242;
    primitive_t_length_n246 <= shift_left(resize(primitive_t_length_n244, 33), 23) when primitive_t_length_n245_s12(0) = '1' else primitive_t_length_n243;
    -- primitive.n_length.recip_root
    primitive_n_length_recip_root_n422_sum <= resize(primitive_n_length_recip_root_n421_s12, 38) + 38x"0000002000";
    primitive_n_length_recip_root_n422_cut <= primitive_n_length_recip_root_n422_sum(37 downto 14);
    primitive_n_length_recip_root_n422_over <= "1" when primitive_n_length_recip_root_n422_cut(23) = '0' and (or primitive_n_length_recip_root_n422_cut(22 downto 22)) = '1' else "0";
    primitive_n_length_recip_root_n422_under <= unsigned(primitive_n_length_recip_root_n422_cut(23 downto 23));
    primitive_n_length_recip_root_n422 <= 22x"3fffff" when primitive_n_length_recip_root_n422_over(0) = '1' else 22x"000000" when primitive_n_length_recip_root_n422_under(0) = '1' else unsigned(primitive_n_length_recip_root_n422_cut(21 downto 0));
    -- primitive.n_length
    primitive_n_length_n423_past <= "1" when 4x"b" < primitive_n_length_n409_s12 else "0";
    primitive_n_length_n423_count <= 4x"b" when primitive_n_length_n423_past(0) = '1' else primitive_n_length_n409_s12;
    primitive_n_length_n423 <= shift_left(resize(primitive_n_length_recip_root_n422, 33), to_integer(primitive_n_length_n423_count));
    primitive_n_length_n424 <= primitive_n_length_n423;
    primitive_n_length_n426 <= shift_left(resize(primitive_t_length_n244, 33), 23) when primitive_n_length_n425_s12(0) = '1' else primitive_n_length_n424;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s13 <= view_x_s12;
                view_y_s13 <= view_y_s12;
                view_z_s13 <= view_z_s12;
                light0_x_s13 <= light0_x_s12;
                light0_y_s13 <= light0_y_s12;
                light0_z_s13 <= light0_z_s12;
                primitive_zero_uv_s13 <= primitive_zero_uv_s12;
                primitive_mirrored_s13 <= primitive_mirrored_s12;
                primitive_zero_area_s13 <= primitive_zero_area_s12;
                primitive_degenerate_s13 <= primitive_degenerate_s12;
                primitive_t_norm_x_s13 <= primitive_t_norm_x_s12;
                primitive_t_norm_y_s13 <= primitive_t_norm_y_s12;
                primitive_t_norm_z_s13 <= primitive_t_norm_z_s12;
                primitive_t_length_n246_s13 <= primitive_t_length_n246;
                primitive_n_norm_x_s13 <= primitive_n_norm_x_s12;
                primitive_n_norm_y_s13 <= primitive_n_norm_y_s12;
                primitive_n_norm_z_s13 <= primitive_n_norm_z_s12;
                primitive_n_length_n426_s13 <= primitive_n_length_n426;
                primitive_n447_s13 <= primitive_n447_s12;
            end if;
            if rst = '1' then
                valid_s13 <= '0';
            elsif ce = '1' then
                valid_s13 <= valid_s12;
            end if;
        end if;
    end process;

    -- ---- stage 13 ----
    -- primitive.t_length
    primitive_t_length_t_length_sum <= resize(primitive_t_length_n246_s13, 34) + 34x"000000004";
    primitive_t_length_t_length_cut <= primitive_t_length_t_length_sum(33 downto 3);
    primitive_t_length_t_length_over <= "1" when (or primitive_t_length_t_length_cut(30 downto 20)) = '1' else "0";
    primitive_t_length_t_length <= 20x"fffff" when primitive_t_length_t_length_over(0) = '1' else primitive_t_length_t_length_cut(19 downto 0);
    -- primitive.n_length
    primitive_n_length_n_length_sum <= resize(primitive_n_length_n426_s13, 34) + 34x"000000004";
    primitive_n_length_n_length_cut <= primitive_n_length_n_length_sum(33 downto 3);
    primitive_n_length_n_length_over <= "1" when (or primitive_n_length_n_length_cut(30 downto 20)) = '1' else "0";
    primitive_n_length_n_length <= 20x"fffff" when primitive_n_length_n_length_over(0) = '1' else primitive_n_length_n_length_cut(19 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s14 <= view_x_s13;
                view_y_s14 <= view_y_s13;
                view_z_s14 <= view_z_s13;
                light0_x_s14 <= light0_x_s13;
                light0_y_s14 <= light0_y_s13;
                light0_z_s14 <= light0_z_s13;
                primitive_zero_uv_s14 <= primitive_zero_uv_s13;
                primitive_mirrored_s14 <= primitive_mirrored_s13;
                primitive_zero_area_s14 <= primitive_zero_area_s13;
                primitive_degenerate_s14 <= primitive_degenerate_s13;
                primitive_t_norm_x_s14 <= primitive_t_norm_x_s13;
                primitive_t_norm_y_s14 <= primitive_t_norm_y_s13;
                primitive_t_norm_z_s14 <= primitive_t_norm_z_s13;
                primitive_t_length_t_length_s14 <= primitive_t_length_t_length;
                primitive_n_norm_x_s14 <= primitive_n_norm_x_s13;
                primitive_n_norm_y_s14 <= primitive_n_norm_y_s13;
                primitive_n_norm_z_s14 <= primitive_n_norm_z_s13;
                primitive_n_length_n_length_s14 <= primitive_n_length_n_length;
                primitive_n447_s14 <= primitive_n447_s13;
            end if;
            if rst = '1' then
                valid_s14 <= '0';
            elsif ce = '1' then
                valid_s14 <= valid_s13;
            end if;
        end if;
    end process;

    -- ---- stage 14 ----
    -- primitive
    primitive_n248 <= resize(primitive_t_norm_x_s14 * signed('0' & primitive_t_length_t_length_s14), 38);
    primitive_n250 <= resize(primitive_t_norm_y_s14 * signed('0' & primitive_t_length_t_length_s14), 38);
    primitive_n252 <= resize(primitive_t_norm_z_s14 * signed('0' & primitive_t_length_t_length_s14), 38);
    primitive_n428 <= resize(primitive_n_norm_x_s14 * signed('0' & primitive_n_length_n_length_s14), 38);
    primitive_n430 <= resize(primitive_n_norm_y_s14 * signed('0' & primitive_n_length_n_length_s14), 38);
    primitive_n432 <= resize(primitive_n_norm_z_s14 * signed('0' & primitive_n_length_n_length_s14), 38);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s15 <= view_x_s14;
                view_y_s15 <= view_y_s14;
                view_z_s15 <= view_z_s14;
                light0_x_s15 <= light0_x_s14;
                light0_y_s15 <= light0_y_s14;
                light0_z_s15 <= light0_z_s14;
                primitive_zero_uv_s15 <= primitive_zero_uv_s14;
                primitive_mirrored_s15 <= primitive_mirrored_s14;
                primitive_zero_area_s15 <= primitive_zero_area_s14;
                primitive_degenerate_s15 <= primitive_degenerate_s14;
                primitive_n248_s15 <= primitive_n248;
                primitive_n250_s15 <= primitive_n250;
                primitive_n252_s15 <= primitive_n252;
                primitive_n428_s15 <= primitive_n428;
                primitive_n430_s15 <= primitive_n430;
                primitive_n432_s15 <= primitive_n432;
                primitive_n447_s15 <= primitive_n447_s14;
            end if;
            if rst = '1' then
                valid_s15 <= '0';
            elsif ce = '1' then
                valid_s15 <= valid_s14;
            end if;
        end if;
    end process;

    -- ---- stage 15 ----
    -- primitive
    primitive_t_unit_x_sum <= resize(primitive_n248_s15, 39) + 39x"0000040000";
    primitive_t_unit_x_cut <= primitive_t_unit_x_sum(38 downto 19);
    primitive_t_unit_x_over <= "1" when primitive_t_unit_x_cut(19) = '0' and (or primitive_t_unit_x_cut(18 downto 17)) = '1' else "0";
    primitive_t_unit_x_under <= "1" when primitive_t_unit_x_cut(19) = '1' and (and primitive_t_unit_x_cut(18 downto 17)) = '0' else "0";
    primitive_t_unit_x <= 18x"1ffff" when primitive_t_unit_x_over(0) = '1' else 18x"20000" when primitive_t_unit_x_under(0) = '1' else primitive_t_unit_x_cut(17 downto 0);
    primitive_t_unit_y_sum <= resize(primitive_n250_s15, 39) + 39x"0000040000";
    primitive_t_unit_y_cut <= primitive_t_unit_y_sum(38 downto 19);
    primitive_t_unit_y_over <= "1" when primitive_t_unit_y_cut(19) = '0' and (or primitive_t_unit_y_cut(18 downto 17)) = '1' else "0";
    primitive_t_unit_y_under <= "1" when primitive_t_unit_y_cut(19) = '1' and (and primitive_t_unit_y_cut(18 downto 17)) = '0' else "0";
    primitive_t_unit_y <= 18x"1ffff" when primitive_t_unit_y_over(0) = '1' else 18x"20000" when primitive_t_unit_y_under(0) = '1' else primitive_t_unit_y_cut(17 downto 0);
    primitive_t_unit_z_sum <= resize(primitive_n252_s15, 39) + 39x"0000040000";
    primitive_t_unit_z_cut <= primitive_t_unit_z_sum(38 downto 19);
    primitive_t_unit_z_over <= "1" when primitive_t_unit_z_cut(19) = '0' and (or primitive_t_unit_z_cut(18 downto 17)) = '1' else "0";
    primitive_t_unit_z_under <= "1" when primitive_t_unit_z_cut(19) = '1' and (and primitive_t_unit_z_cut(18 downto 17)) = '0' else "0";
    primitive_t_unit_z <= 18x"1ffff" when primitive_t_unit_z_over(0) = '1' else 18x"20000" when primitive_t_unit_z_under(0) = '1' else primitive_t_unit_z_cut(17 downto 0);
    primitive_n_unit_x_sum <= resize(primitive_n428_s15, 39) + 39x"0000040000";
    primitive_n_unit_x_cut <= primitive_n_unit_x_sum(38 downto 19);
    primitive_n_unit_x_over <= "1" when primitive_n_unit_x_cut(19) = '0' and (or primitive_n_unit_x_cut(18 downto 17)) = '1' else "0";
    primitive_n_unit_x_under <= "1" when primitive_n_unit_x_cut(19) = '1' and (and primitive_n_unit_x_cut(18 downto 17)) = '0' else "0";
    primitive_n_unit_x <= 18x"1ffff" when primitive_n_unit_x_over(0) = '1' else 18x"20000" when primitive_n_unit_x_under(0) = '1' else primitive_n_unit_x_cut(17 downto 0);
    primitive_n_unit_y_sum <= resize(primitive_n430_s15, 39) + 39x"0000040000";
    primitive_n_unit_y_cut <= primitive_n_unit_y_sum(38 downto 19);
    primitive_n_unit_y_over <= "1" when primitive_n_unit_y_cut(19) = '0' and (or primitive_n_unit_y_cut(18 downto 17)) = '1' else "0";
    primitive_n_unit_y_under <= "1" when primitive_n_unit_y_cut(19) = '1' and (and primitive_n_unit_y_cut(18 downto 17)) = '0' else "0";
    primitive_n_unit_y <= 18x"1ffff" when primitive_n_unit_y_over(0) = '1' else 18x"20000" when primitive_n_unit_y_under(0) = '1' else primitive_n_unit_y_cut(17 downto 0);
    primitive_n_unit_z_sum <= resize(primitive_n432_s15, 39) + 39x"0000040000";
    primitive_n_unit_z_cut <= primitive_n_unit_z_sum(38 downto 19);
    primitive_n_unit_z_over <= "1" when primitive_n_unit_z_cut(19) = '0' and (or primitive_n_unit_z_cut(18 downto 17)) = '1' else "0";
    primitive_n_unit_z_under <= "1" when primitive_n_unit_z_cut(19) = '1' and (and primitive_n_unit_z_cut(18 downto 17)) = '0' else "0";
    primitive_n_unit_z <= 18x"1ffff" when primitive_n_unit_z_over(0) = '1' else 18x"20000" when primitive_n_unit_z_under(0) = '1' else primitive_n_unit_z_cut(17 downto 0);
    primitive_n448 <= -resize(primitive_t_unit_x, 19);
    primitive_n449 <= primitive_n448 when primitive_n447_s15(0) = '1' else resize(primitive_t_unit_x, 19);
    primitive_n450_over <= "1" when primitive_n449(18) = '0' and (or primitive_n449(17 downto 17)) = '1' else "0";
    primitive_n450_under <= "1" when primitive_n449(18) = '1' and (and primitive_n449(17 downto 17)) = '0' else "0";
    primitive_n450 <= 18x"1ffff" when primitive_n450_over(0) = '1' else 18x"20000" when primitive_n450_under(0) = '1' else primitive_n449(17 downto 0);
    primitive_n451 <= -resize(primitive_t_unit_y, 19);
    primitive_n452 <= primitive_n451 when primitive_n447_s15(0) = '1' else resize(primitive_t_unit_y, 19);
    primitive_n453_over <= "1" when primitive_n452(18) = '0' and (or primitive_n452(17 downto 17)) = '1' else "0";
    primitive_n453_under <= "1" when primitive_n452(18) = '1' and (and primitive_n452(17 downto 17)) = '0' else "0";
    primitive_n453 <= 18x"1ffff" when primitive_n453_over(0) = '1' else 18x"20000" when primitive_n453_under(0) = '1' else primitive_n452(17 downto 0);
    primitive_n454 <= -resize(primitive_t_unit_z, 19);
    primitive_n455 <= primitive_n454 when primitive_n447_s15(0) = '1' else resize(primitive_t_unit_z, 19);
    primitive_n456_over <= "1" when primitive_n455(18) = '0' and (or primitive_n455(17 downto 17)) = '1' else "0";
    primitive_n456_under <= "1" when primitive_n455(18) = '1' and (and primitive_n455(17 downto 17)) = '0' else "0";
    primitive_n456 <= 18x"1ffff" when primitive_n456_over(0) = '1' else 18x"20000" when primitive_n456_under(0) = '1' else primitive_n455(17 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s16 <= view_x_s15;
                view_y_s16 <= view_y_s15;
                view_z_s16 <= view_z_s15;
                light0_x_s16 <= light0_x_s15;
                light0_y_s16 <= light0_y_s15;
                light0_z_s16 <= light0_z_s15;
                primitive_zero_uv_s16 <= primitive_zero_uv_s15;
                primitive_mirrored_s16 <= primitive_mirrored_s15;
                primitive_zero_area_s16 <= primitive_zero_area_s15;
                primitive_degenerate_s16 <= primitive_degenerate_s15;
                primitive_t_unit_x_s16 <= primitive_t_unit_x;
                primitive_t_unit_y_s16 <= primitive_t_unit_y;
                primitive_t_unit_z_s16 <= primitive_t_unit_z;
                primitive_n_unit_x_s16 <= primitive_n_unit_x;
                primitive_n_unit_y_s16 <= primitive_n_unit_y;
                primitive_n_unit_z_s16 <= primitive_n_unit_z;
                primitive_n450_s16 <= primitive_n450;
                primitive_n453_s16 <= primitive_n453;
                primitive_n456_s16 <= primitive_n456;
            end if;
            if rst = '1' then
                valid_s16 <= '0';
            elsif ce = '1' then
                valid_s16 <= valid_s15;
            end if;
        end if;
    end process;

    -- ---- stage 16 ----
    -- primitive.n_cross_t
    primitive_n_cross_t_n434 <= primitive_n_unit_y_s16 * primitive_t_unit_z_s16;
    primitive_n_cross_t_n435 <= primitive_n_unit_z_s16 * primitive_t_unit_y_s16;
    primitive_n_cross_t_n437 <= primitive_n_unit_z_s16 * primitive_t_unit_x_s16;
    primitive_n_cross_t_n438 <= primitive_n_unit_x_s16 * primitive_t_unit_z_s16;
    primitive_n_cross_t_n440 <= primitive_n_unit_x_s16 * primitive_t_unit_y_s16;
    primitive_n_cross_t_n441 <= primitive_n_unit_y_s16 * primitive_t_unit_x_s16;
    -- vertex.ts_view_t
    vertex_ts_view_t_n457 <= primitive_n450_s16 * view_x_s16;
    vertex_ts_view_t_n458 <= primitive_n453_s16 * view_y_s16;
    vertex_ts_view_t_n459 <= primitive_n456_s16 * view_z_s16;
    -- vertex.ts_view_n
    vertex_ts_view_n_n469 <= primitive_n_unit_x_s16 * view_x_s16;
    vertex_ts_view_n_n470 <= primitive_n_unit_y_s16 * view_y_s16;
    vertex_ts_view_n_n471 <= primitive_n_unit_z_s16 * view_z_s16;
    -- vertex.ts_light0_t
    vertex_ts_light0_t_n475 <= primitive_n450_s16 * light0_x_s16;
    vertex_ts_light0_t_n476 <= primitive_n453_s16 * light0_y_s16;
    vertex_ts_light0_t_n477 <= primitive_n456_s16 * light0_z_s16;
    -- vertex.ts_light0_n
    vertex_ts_light0_n_n487 <= primitive_n_unit_x_s16 * light0_x_s16;
    vertex_ts_light0_n_n488 <= primitive_n_unit_y_s16 * light0_y_s16;
    vertex_ts_light0_n_n489 <= primitive_n_unit_z_s16 * light0_z_s16;

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s17 <= view_x_s16;
                view_y_s17 <= view_y_s16;
                view_z_s17 <= view_z_s16;
                light0_x_s17 <= light0_x_s16;
                light0_y_s17 <= light0_y_s16;
                light0_z_s17 <= light0_z_s16;
                primitive_zero_uv_s17 <= primitive_zero_uv_s16;
                primitive_mirrored_s17 <= primitive_mirrored_s16;
                primitive_zero_area_s17 <= primitive_zero_area_s16;
                primitive_degenerate_s17 <= primitive_degenerate_s16;
                primitive_n_unit_x_s17 <= primitive_n_unit_x_s16;
                primitive_n_unit_y_s17 <= primitive_n_unit_y_s16;
                primitive_n_unit_z_s17 <= primitive_n_unit_z_s16;
                primitive_n_cross_t_n434_s17 <= primitive_n_cross_t_n434;
                primitive_n_cross_t_n435_s17 <= primitive_n_cross_t_n435;
                primitive_n_cross_t_n437_s17 <= primitive_n_cross_t_n437;
                primitive_n_cross_t_n438_s17 <= primitive_n_cross_t_n438;
                primitive_n_cross_t_n440_s17 <= primitive_n_cross_t_n440;
                primitive_n_cross_t_n441_s17 <= primitive_n_cross_t_n441;
                primitive_n450_s17 <= primitive_n450_s16;
                primitive_n453_s17 <= primitive_n453_s16;
                primitive_n456_s17 <= primitive_n456_s16;
                vertex_ts_view_t_n457_s17 <= vertex_ts_view_t_n457;
                vertex_ts_view_t_n458_s17 <= vertex_ts_view_t_n458;
                vertex_ts_view_t_n459_s17 <= vertex_ts_view_t_n459;
                vertex_ts_view_n_n469_s17 <= vertex_ts_view_n_n469;
                vertex_ts_view_n_n470_s17 <= vertex_ts_view_n_n470;
                vertex_ts_view_n_n471_s17 <= vertex_ts_view_n_n471;
                vertex_ts_light0_t_n475_s17 <= vertex_ts_light0_t_n475;
                vertex_ts_light0_t_n476_s17 <= vertex_ts_light0_t_n476;
                vertex_ts_light0_t_n477_s17 <= vertex_ts_light0_t_n477;
                vertex_ts_light0_n_n487_s17 <= vertex_ts_light0_n_n487;
                vertex_ts_light0_n_n488_s17 <= vertex_ts_light0_n_n488;
                vertex_ts_light0_n_n489_s17 <= vertex_ts_light0_n_n489;
            end if;
            if rst = '1' then
                valid_s17 <= '0';
            elsif ce = '1' then
                valid_s17 <= valid_s16;
            end if;
        end if;
    end process;

    -- ---- stage 17 ----
    -- primitive.n_cross_t
    primitive_n_cross_t_n436 <= resize(primitive_n_cross_t_n434_s17, 37) - resize(primitive_n_cross_t_n435_s17, 37);
    primitive_n_cross_t_n439 <= resize(primitive_n_cross_t_n437_s17, 37) - resize(primitive_n_cross_t_n438_s17, 37);
    primitive_n_cross_t_n442 <= resize(primitive_n_cross_t_n440_s17, 37) - resize(primitive_n_cross_t_n441_s17, 37);
    -- primitive
    primitive_n443_sum <= resize(primitive_n_cross_t_n436, 38) + 38x"0000008000";
    primitive_n443_cut <= primitive_n443_sum(37 downto 16);
    primitive_n443_over <= "1" when primitive_n443_cut(21) = '0' and (or primitive_n443_cut(20 downto 17)) = '1' else "0";
    primitive_n443_under <= "1" when primitive_n443_cut(21) = '1' and (and primitive_n443_cut(20 downto 17)) = '0' else "0";
    primitive_n443 <= 18x"1ffff" when primitive_n443_over(0) = '1' else 18x"20000" when primitive_n443_under(0) = '1' else primitive_n443_cut(17 downto 0);
    primitive_n444_sum <= resize(primitive_n_cross_t_n439, 38) + 38x"0000008000";
    primitive_n444_cut <= primitive_n444_sum(37 downto 16);
    primitive_n444_over <= "1" when primitive_n444_cut(21) = '0' and (or primitive_n444_cut(20 downto 17)) = '1' else "0";
    primitive_n444_under <= "1" when primitive_n444_cut(21) = '1' and (and primitive_n444_cut(20 downto 17)) = '0' else "0";
    primitive_n444 <= 18x"1ffff" when primitive_n444_over(0) = '1' else 18x"20000" when primitive_n444_under(0) = '1' else primitive_n444_cut(17 downto 0);
    primitive_n445_sum <= resize(primitive_n_cross_t_n442, 38) + 38x"0000008000";
    primitive_n445_cut <= primitive_n445_sum(37 downto 16);
    primitive_n445_over <= "1" when primitive_n445_cut(21) = '0' and (or primitive_n445_cut(20 downto 17)) = '1' else "0";
    primitive_n445_under <= "1" when primitive_n445_cut(21) = '1' and (and primitive_n445_cut(20 downto 17)) = '0' else "0";
    primitive_n445 <= 18x"1ffff" when primitive_n445_over(0) = '1' else 18x"20000" when primitive_n445_under(0) = '1' else primitive_n445_cut(17 downto 0);
    -- vertex.ts_view_t
    vertex_ts_view_t_n460 <= resize(vertex_ts_view_t_n457_s17, 35) + resize(vertex_ts_view_t_n458_s17, 35);
    vertex_ts_view_t_n461 <= resize(vertex_ts_view_t_n460, 36) + resize(vertex_ts_view_t_n459_s17, 36);
    -- vertex.ts_view_n
    vertex_ts_view_n_n472 <= resize(vertex_ts_view_n_n469_s17, 35) + resize(vertex_ts_view_n_n470_s17, 35);
    vertex_ts_view_n_n473 <= resize(vertex_ts_view_n_n472, 36) + resize(vertex_ts_view_n_n471_s17, 36);
    -- vertex.ts_light0_t
    vertex_ts_light0_t_n478 <= resize(vertex_ts_light0_t_n475_s17, 35) + resize(vertex_ts_light0_t_n476_s17, 35);
    vertex_ts_light0_t_n479 <= resize(vertex_ts_light0_t_n478, 36) + resize(vertex_ts_light0_t_n477_s17, 36);
    -- vertex.ts_light0_n
    vertex_ts_light0_n_n490 <= resize(vertex_ts_light0_n_n487_s17, 35) + resize(vertex_ts_light0_n_n488_s17, 35);
    vertex_ts_light0_n_n491 <= resize(vertex_ts_light0_n_n490, 36) + resize(vertex_ts_light0_n_n489_s17, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                view_x_s18 <= view_x_s17;
                view_y_s18 <= view_y_s17;
                view_z_s18 <= view_z_s17;
                light0_x_s18 <= light0_x_s17;
                light0_y_s18 <= light0_y_s17;
                light0_z_s18 <= light0_z_s17;
                primitive_zero_uv_s18 <= primitive_zero_uv_s17;
                primitive_mirrored_s18 <= primitive_mirrored_s17;
                primitive_zero_area_s18 <= primitive_zero_area_s17;
                primitive_degenerate_s18 <= primitive_degenerate_s17;
                primitive_n_unit_x_s18 <= primitive_n_unit_x_s17;
                primitive_n_unit_y_s18 <= primitive_n_unit_y_s17;
                primitive_n_unit_z_s18 <= primitive_n_unit_z_s17;
                primitive_n443_s18 <= primitive_n443;
                primitive_n444_s18 <= primitive_n444;
                primitive_n445_s18 <= primitive_n445;
                primitive_n450_s18 <= primitive_n450_s17;
                primitive_n453_s18 <= primitive_n453_s17;
                primitive_n456_s18 <= primitive_n456_s17;
                vertex_ts_view_t_n461_s18 <= vertex_ts_view_t_n461;
                vertex_ts_view_n_n473_s18 <= vertex_ts_view_n_n473;
                vertex_ts_light0_t_n479_s18 <= vertex_ts_light0_t_n479;
                vertex_ts_light0_n_n491_s18 <= vertex_ts_light0_n_n491;
            end if;
            if rst = '1' then
                valid_s18 <= '0';
            elsif ce = '1' then
                valid_s18 <= valid_s17;
            end if;
        end if;
    end process;

    -- ---- stage 18 ----
    -- vertex
    vertex_ts_view_x_sum <= resize(vertex_ts_view_t_n461_s18, 37) + 37x"0000008000";
    vertex_ts_view_x_cut <= vertex_ts_view_x_sum(36 downto 16);
    vertex_ts_view_x_over <= "1" when vertex_ts_view_x_cut(20) = '0' and (or vertex_ts_view_x_cut(19 downto 16)) = '1' else "0";
    vertex_ts_view_x_under <= "1" when vertex_ts_view_x_cut(20) = '1' and (and vertex_ts_view_x_cut(19 downto 16)) = '0' else "0";
    vertex_ts_view_x <= 17x"0ffff" when vertex_ts_view_x_over(0) = '1' else 17x"10000" when vertex_ts_view_x_under(0) = '1' else vertex_ts_view_x_cut(16 downto 0);
    -- vertex.ts_view_b
    vertex_ts_view_b_n463 <= primitive_n443_s18 * view_x_s18;
    vertex_ts_view_b_n464 <= primitive_n444_s18 * view_y_s18;
    vertex_ts_view_b_n465 <= primitive_n445_s18 * view_z_s18;
    -- vertex
    vertex_ts_view_z_sum <= resize(vertex_ts_view_n_n473_s18, 37) + 37x"0000008000";
    vertex_ts_view_z_cut <= vertex_ts_view_z_sum(36 downto 16);
    vertex_ts_view_z_over <= "1" when vertex_ts_view_z_cut(20) = '0' and (or vertex_ts_view_z_cut(19 downto 16)) = '1' else "0";
    vertex_ts_view_z_under <= "1" when vertex_ts_view_z_cut(20) = '1' and (and vertex_ts_view_z_cut(19 downto 16)) = '0' else "0";
    vertex_ts_view_z <= 17x"0ffff" when vertex_ts_view_z_over(0) = '1' else 17x"10000" when vertex_ts_view_z_under(0) = '1' else vertex_ts_view_z_cut(16 downto 0);
    vertex_ts_light0_x_sum <= resize(vertex_ts_light0_t_n479_s18, 37) + 37x"0000008000";
    vertex_ts_light0_x_cut <= vertex_ts_light0_x_sum(36 downto 16);
    vertex_ts_light0_x_over <= "1" when vertex_ts_light0_x_cut(20) = '0' and (or vertex_ts_light0_x_cut(19 downto 16)) = '1' else "0";
    vertex_ts_light0_x_under <= "1" when vertex_ts_light0_x_cut(20) = '1' and (and vertex_ts_light0_x_cut(19 downto 16)) = '0' else "0";
    vertex_ts_light0_x <= 17x"0ffff" when vertex_ts_light0_x_over(0) = '1' else 17x"10000" when vertex_ts_light0_x_under(0) = '1' else vertex_ts_light0_x_cut(16 downto 0);
    -- vertex.ts_light0_b
    vertex_ts_light0_b_n481 <= primitive_n443_s18 * light0_x_s18;
    vertex_ts_light0_b_n482 <= primitive_n444_s18 * light0_y_s18;
    vertex_ts_light0_b_n483 <= primitive_n445_s18 * light0_z_s18;
    -- vertex
    vertex_ts_light0_z_sum <= resize(vertex_ts_light0_n_n491_s18, 37) + 37x"0000008000";
    vertex_ts_light0_z_cut <= vertex_ts_light0_z_sum(36 downto 16);
    vertex_ts_light0_z_over <= "1" when vertex_ts_light0_z_cut(20) = '0' and (or vertex_ts_light0_z_cut(19 downto 16)) = '1' else "0";
    vertex_ts_light0_z_under <= "1" when vertex_ts_light0_z_cut(20) = '1' and (and vertex_ts_light0_z_cut(19 downto 16)) = '0' else "0";
    vertex_ts_light0_z <= 17x"0ffff" when vertex_ts_light0_z_over(0) = '1' else 17x"10000" when vertex_ts_light0_z_under(0) = '1' else vertex_ts_light0_z_cut(16 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                primitive_zero_uv_s19 <= primitive_zero_uv_s18;
                primitive_mirrored_s19 <= primitive_mirrored_s18;
                primitive_zero_area_s19 <= primitive_zero_area_s18;
                primitive_degenerate_s19 <= primitive_degenerate_s18;
                primitive_n_unit_x_s19 <= primitive_n_unit_x_s18;
                primitive_n_unit_y_s19 <= primitive_n_unit_y_s18;
                primitive_n_unit_z_s19 <= primitive_n_unit_z_s18;
                primitive_n443_s19 <= primitive_n443_s18;
                primitive_n444_s19 <= primitive_n444_s18;
                primitive_n445_s19 <= primitive_n445_s18;
                primitive_n450_s19 <= primitive_n450_s18;
                primitive_n453_s19 <= primitive_n453_s18;
                primitive_n456_s19 <= primitive_n456_s18;
                vertex_ts_view_x_s19 <= vertex_ts_view_x;
                vertex_ts_view_b_n463_s19 <= vertex_ts_view_b_n463;
                vertex_ts_view_b_n464_s19 <= vertex_ts_view_b_n464;
                vertex_ts_view_b_n465_s19 <= vertex_ts_view_b_n465;
                vertex_ts_view_z_s19 <= vertex_ts_view_z;
                vertex_ts_light0_x_s19 <= vertex_ts_light0_x;
                vertex_ts_light0_b_n481_s19 <= vertex_ts_light0_b_n481;
                vertex_ts_light0_b_n482_s19 <= vertex_ts_light0_b_n482;
                vertex_ts_light0_b_n483_s19 <= vertex_ts_light0_b_n483;
                vertex_ts_light0_z_s19 <= vertex_ts_light0_z;
            end if;
            if rst = '1' then
                valid_s19 <= '0';
            elsif ce = '1' then
                valid_s19 <= valid_s18;
            end if;
        end if;
    end process;

    -- ---- stage 19 ----
    -- vertex.ts_view_b
    vertex_ts_view_b_n466 <= resize(vertex_ts_view_b_n463_s19, 35) + resize(vertex_ts_view_b_n464_s19, 35);
    vertex_ts_view_b_n467 <= resize(vertex_ts_view_b_n466, 36) + resize(vertex_ts_view_b_n465_s19, 36);
    -- vertex.ts_light0_b
    vertex_ts_light0_b_n484 <= resize(vertex_ts_light0_b_n481_s19, 35) + resize(vertex_ts_light0_b_n482_s19, 35);
    vertex_ts_light0_b_n485 <= resize(vertex_ts_light0_b_n484, 36) + resize(vertex_ts_light0_b_n483_s19, 36);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                primitive_zero_uv_s20 <= primitive_zero_uv_s19;
                primitive_mirrored_s20 <= primitive_mirrored_s19;
                primitive_zero_area_s20 <= primitive_zero_area_s19;
                primitive_degenerate_s20 <= primitive_degenerate_s19;
                primitive_n_unit_x_s20 <= primitive_n_unit_x_s19;
                primitive_n_unit_y_s20 <= primitive_n_unit_y_s19;
                primitive_n_unit_z_s20 <= primitive_n_unit_z_s19;
                primitive_n443_s20 <= primitive_n443_s19;
                primitive_n444_s20 <= primitive_n444_s19;
                primitive_n445_s20 <= primitive_n445_s19;
                primitive_n450_s20 <= primitive_n450_s19;
                primitive_n453_s20 <= primitive_n453_s19;
                primitive_n456_s20 <= primitive_n456_s19;
                vertex_ts_view_x_s20 <= vertex_ts_view_x_s19;
                vertex_ts_view_b_n467_s20 <= vertex_ts_view_b_n467;
                vertex_ts_view_z_s20 <= vertex_ts_view_z_s19;
                vertex_ts_light0_x_s20 <= vertex_ts_light0_x_s19;
                vertex_ts_light0_b_n485_s20 <= vertex_ts_light0_b_n485;
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
    vertex_ts_view_y_sum <= resize(vertex_ts_view_b_n467_s20, 37) + 37x"0000008000";
    vertex_ts_view_y_cut <= vertex_ts_view_y_sum(36 downto 16);
    vertex_ts_view_y_over <= "1" when vertex_ts_view_y_cut(20) = '0' and (or vertex_ts_view_y_cut(19 downto 16)) = '1' else "0";
    vertex_ts_view_y_under <= "1" when vertex_ts_view_y_cut(20) = '1' and (and vertex_ts_view_y_cut(19 downto 16)) = '0' else "0";
    vertex_ts_view_y <= 17x"0ffff" when vertex_ts_view_y_over(0) = '1' else 17x"10000" when vertex_ts_view_y_under(0) = '1' else vertex_ts_view_y_cut(16 downto 0);
    vertex_ts_light0_y_sum <= resize(vertex_ts_light0_b_n485_s20, 37) + 37x"0000008000";
    vertex_ts_light0_y_cut <= vertex_ts_light0_y_sum(36 downto 16);
    vertex_ts_light0_y_over <= "1" when vertex_ts_light0_y_cut(20) = '0' and (or vertex_ts_light0_y_cut(19 downto 16)) = '1' else "0";
    vertex_ts_light0_y_under <= "1" when vertex_ts_light0_y_cut(20) = '1' and (and vertex_ts_light0_y_cut(19 downto 16)) = '0' else "0";
    vertex_ts_light0_y <= 17x"0ffff" when vertex_ts_light0_y_over(0) = '1' else 17x"10000" when vertex_ts_light0_y_under(0) = '1' else vertex_ts_light0_y_cut(16 downto 0);

    process (clk)
    begin
        if rising_edge(clk) then
            if ce = '1' then
                zero_uv <= primitive_zero_uv_s20;
                mirrored <= primitive_mirrored_s20;
                zero_area <= primitive_zero_area_s20;
                degenerate <= primitive_degenerate_s20;
                n_x <= primitive_n_unit_x_s20;
                n_y <= primitive_n_unit_y_s20;
                n_z <= primitive_n_unit_z_s20;
                b_x <= primitive_n443_s20;
                b_y <= primitive_n444_s20;
                b_z <= primitive_n445_s20;
                t_x <= primitive_n450_s20;
                t_y <= primitive_n453_s20;
                t_z <= primitive_n456_s20;
                ts_view_x <= vertex_ts_view_x_s20;
                ts_view_y <= vertex_ts_view_y;
                ts_view_z <= vertex_ts_view_z_s20;
                ts_light0_x <= vertex_ts_light0_x_s20;
                ts_light0_y <= vertex_ts_light0_y;
                ts_light0_z <= vertex_ts_light0_z_s20;
            end if;
            if rst = '1' then
                valid_s21 <= '0';
            elsif ce = '1' then
                valid_s21 <= valid_s20;
            end if;
        end if;
    end process;

    -- ---- stage 21 ----

    valid_out <= valid_s21;
end architecture;
