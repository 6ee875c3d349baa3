// tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
// made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
//   frame=faceted mirror=handed basis=orthonormal lights=1 position_int_bits=4
//   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
//   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
//   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
//   stages=auto rom=block
// latency 21 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 6.44e-6 rad, largest seen 2.07e-5 rad at p0_x=10112 p0_y=-13087 p0_z=1777 p1_x=9474 p1_y=-12645 p1_z=1634 p2_x=9790 p2_y=-12829 p2_z=1369 uv0_u=-4264 uv0_v=10910 uv1_u=-4558 uv1_v=11772 uv2_u=-7611 uv2_v=11483 view_x=548 view_y=17311 view_z=12049 light0_x=1261 light0_y=5545 light0_z=2155
//   t_dot: mean 8.59e-6, largest seen 2.48e-5 at p0_x=1385 p0_y=12631 p0_z=-15491 p1_x=1521 p1_y=12473 p1_z=-15566 p2_x=1244 p2_y=12281 p2_z=-15784 uv0_u=-12255 uv0_v=18727 uv1_u=-10160 uv1_v=16132 uv2_u=-10611 uv2_v=14849 view_x=8012 view_y=-2458 view_z=2986 light0_x=-3484 light0_y=-3984 light0_z=-834
//   t_x: mean 4.38e-6, largest seen 2.05e-5 (1.3 ulp) at p0_x=8845 p0_y=-7357 p0_z=8918 p1_x=8982 p1_y=-7495 p1_z=8835 p2_x=8642 p2_y=-7486 p2_z=8723 uv0_u=7356 uv0_v=-1510 uv1_u=861 uv1_v=-14978 uv2_u=1714 uv2_v=-6705 view_x=21907 view_y=8320 view_z=3195 light0_x=-2207 light0_y=-1467 light0_z=9923
//   t_y: mean 4.38e-6, largest seen 1.98e-5 (1.3 ulp) at p0_x=-2916 p0_y=-2788 p0_z=-14527 p1_x=-2891 p1_y=-2951 p1_z=-14658 p2_x=-2936 p2_y=-2975 p2_z=-14683 uv0_u=13249 uv0_v=-3283 uv1_u=11297 uv1_v=-4440 uv2_u=10686 uv2_v=-3368 view_x=21236 view_y=-6071 view_z=19473 light0_x=-3237 light0_y=1137 light0_z=-6504
//   t_z: mean 4.37e-6, largest seen 2.11e-5 (1.4 ulp) at p0_x=582 p0_y=524 p0_z=6901 p1_x=726 p1_y=573 p1_z=7248 p2_x=617 p2_y=494 p2_z=6888 uv0_u=-4050 uv0_v=10840 uv1_u=-4012 uv1_v=10792 uv2_u=-4035 uv2_v=10797 view_x=4349 view_y=-3883 view_z=-2073 light0_x=3612 light0_y=-5188 light0_z=3156
//   b_angle: mean 8.42e-6 rad, largest seen 2.71e-5 rad at p0_x=1963 p0_y=-5912 p0_z=3005 p1_x=-2419 p1_y=-29264 p1_z=3178 p2_x=3140 p2_y=-14491 p2_z=-9385 uv0_u=-12799 uv0_v=-14422 uv1_u=-12907 uv1_v=-14588 uv2_u=-12803 uv2_v=-14411 view_x=19836 view_y=17280 view_z=-21533 light0_x=13751 light0_y=-21034 light0_z=22968
//   b_dot: mean 1.24e-5, largest seen 4.31e-5 at p0_x=-8559 p0_y=3166 p0_z=9556 p1_x=-8963 p1_y=3337 p1_z=9804 p2_x=-9467 p2_y=3695 p2_z=9468 uv0_u=-3765 uv0_v=1694 uv1_u=-398 uv1_v=210 uv2_u=-3397 uv2_v=239 view_x=-9751 view_y=7042 view_z=-6135 light0_x=-5164 light0_y=-18281 light0_z=2614
//   b_x: mean 6.23e-6, largest seen 3.58e-5 (2.3 ulp) at p0_x=-12491 p0_y=-10859 p0_z=770 p1_x=-12550 p1_y=-10848 p1_z=767 p2_x=-12546 p2_y=-10988 p2_z=739 uv0_u=4382 uv0_v=-5922 uv1_u=4734 uv1_v=-5405 uv2_u=4929 uv2_v=-5360 view_x=-2703 view_y=-1919 view_z=-3268 light0_x=-11057 light0_y=-18078 light0_z=5818
//   b_y: mean 6.24e-6, largest seen 3.57e-5 (2.3 ulp) at p0_x=-5519 p0_y=-6920 p0_z=-16251 p1_x=-6543 p1_y=-10156 p1_z=-12356 p2_x=-3878 p2_y=-9401 p2_z=-17652 uv0_u=16327 uv0_v=1287 uv1_u=16274 uv1_v=1188 uv2_u=16300 uv2_v=1216 view_x=-11982 view_y=-3585 view_z=8239 light0_x=14579 light0_y=-4365 light0_z=-1654
//   b_z: mean 6.22e-6, largest seen 3.80e-5 (2.5 ulp) at p0_x=-8559 p0_y=3166 p0_z=9556 p1_x=-8963 p1_y=3337 p1_z=9804 p2_x=-9467 p2_y=3695 p2_z=9468 uv0_u=-3765 uv0_v=1694 uv1_u=-398 uv1_v=210 uv2_u=-3397 uv2_v=239 view_x=-9751 view_y=7042 view_z=-6135 light0_x=-5164 light0_y=-18281 light0_z=2614
//   n_angle: mean 6.36e-6 rad, largest seen 2.03e-5 rad at p0_x=3522 p0_y=-9311 p0_z=-13297 p1_x=3357 p1_y=-9323 p1_z=-12966 p2_x=3631 p2_y=-9200 p2_z=-12705 uv0_u=14991 uv0_v=-10890 uv1_u=15093 uv1_v=-10788 uv2_u=14968 uv2_v=-10772 view_x=1356 view_y=2820 view_z=466 light0_x=-381 light0_y=-197 light0_z=-3135
//   n_dot: mean 8.51e-6, largest seen 2.45e-5 at p0_x=-12498 p0_y=-6604 p0_z=11609 p1_x=-12529 p1_y=-6828 p1_z=11660 p2_x=-12768 p2_y=-6749 p2_z=11792 uv0_u=-6142 uv0_v=-4000 uv1_u=-6192 uv1_v=-3960 uv2_u=-6137 uv2_v=-3885 view_x=-8383 view_y=-17561 view_z=-14050 light0_x=2468 light0_y=-3154 light0_z=2249
//   n_x: mean 4.34e-6, largest seen 1.92e-5 (1.3 ulp) at p0_x=10267 p0_y=-5838 p0_z=15884 p1_x=10309 p1_y=-6415 p1_z=16204 p2_x=10019 p2_y=-5989 p2_z=16833 uv0_u=11841 uv0_v=15625 uv1_u=11793 uv1_v=15714 uv2_u=11814 uv2_v=15848 view_x=-11567 view_y=-17040 view_z=20375 light0_x=4077 light0_y=-4110 light0_z=-2012
//   n_y: mean 4.34e-6, largest seen 2.01e-5 (1.3 ulp) at p0_x=-3279 p0_y=-11425 p0_z=-14595 p1_x=-1417 p1_y=-11167 p1_z=-13271 p2_x=-3268 p2_y=-11185 p2_z=-10092 uv0_u=-12491 uv0_v=-17511 uv1_u=-14563 uv1_v=-17231 uv2_u=-9992 uv2_v=-12759 view_x=2161 view_y=632 view_z=-3148 light0_x=-8712 light0_y=1511 light0_z=-18751
//   n_z: mean 4.35e-6, largest seen 1.94e-5 (1.3 ulp) at p0_x=-8946 p0_y=-7910 p0_z=13506 p1_x=-7691 p1_y=-6861 p1_z=12554 p2_x=-8776 p2_y=-8113 p2_z=13612 uv0_u=1238 uv0_v=11162 uv1_u=-24396 uv1_v=6826 uv2_u=1116 uv2_v=19470 view_x=-7019 view_y=18890 view_z=19636 light0_x=-3540 light0_y=2276 light0_z=864
//   ts_view_angle: mean 4.70e-5 rad, largest seen 1.93e-3 rad at p0_x=-15922 p0_y=-11294 p0_z=15571 p1_x=-16396 p1_y=-12074 p1_z=16206 p2_x=-16189 p2_y=-11575 p2_z=15362 uv0_u=-13956 uv0_v=11730 uv1_u=-14230 uv1_v=11819 uv2_u=-14204 uv2_v=11563 view_x=8 view_y=226 view_z=-193 light0_x=-3370 light0_y=4136 light0_z=-207
//   ts_view_dot: mean 3.07e-5, largest seen 9.87e-5 at p0_x=-12422 p0_y=-584 p0_z=17766 p1_x=-10564 p1_y=-1806 p1_z=15761 p2_x=-10865 p2_y=-707 p2_z=14787 uv0_u=-4921 uv0_v=-9044 uv1_u=-4950 uv1_v=-8878 uv2_u=-4919 uv2_v=-8658 view_x=-25528 view_y=29243 view_z=-23626 light0_x=16463 light0_y=-19456 light0_z=5126
//   ts_view_x: mean 1.57e-5, largest seen 6.94e-5 (1.1 ulp) at p0_x=-11634 p0_y=13444 p0_z=3163 p1_x=-11636 p1_y=13305 p1_z=3163 p2_x=-11498 p2_y=13032 p2_z=2986 uv0_u=-3984 uv0_v=4319 uv1_u=-1406 uv1_v=5555 uv2_u=-8008 uv2_v=4153 view_x=-29173 view_y=27295 view_z=-23629 light0_x=-5624 light0_y=-6697 light0_z=-22017
//   ts_view_y: mean 1.62e-5, largest seen 8.30e-5 (1.4 ulp) at p0_x=-12422 p0_y=-584 p0_z=17766 p1_x=-10564 p1_y=-1806 p1_z=15761 p2_x=-10865 p2_y=-707 p2_z=14787 uv0_u=-4921 uv0_v=-9044 uv1_u=-4950 uv1_v=-8878 uv2_u=-4919 uv2_v=-8658 view_x=-25528 view_y=29243 view_z=-23626 light0_x=16463 light0_y=-19456 light0_z=5126
//   ts_view_z: mean 1.57e-5, largest seen 6.55e-5 (1.1 ulp) at p0_x=-957 p0_y=-8937 p0_z=-7713 p1_x=-364 p1_y=-8872 p1_z=-7780 p2_x=-792 p2_y=-9101 p2_z=-7328 uv0_u=4922 uv0_v=8735 uv1_u=6366 uv1_v=9156 uv2_u=3517 uv2_v=8477 view_x=9889 view_y=-26230 view_z=30407 light0_x=1812 light0_y=9371 light0_z=-4170
//   ts_light0_angle: mean 4.70e-5 rad, largest seen 2.36e-3 rad at p0_x=1272 p0_y=-15486 p0_z=-8368 p1_x=1233 p1_y=-15508 p1_z=-8439 p2_x=1008 p2_y=-15725 p2_z=-7973 uv0_u=-15400 uv0_v=3547 uv1_u=-15342 uv1_v=3546 uv2_u=-15427 uv2_v=3464 view_x=12551 view_y=19257 view_z=19235 light0_x=171 light0_y=29 light0_z=72
//   ts_light0_dot: mean 3.07e-5, largest seen 9.98e-5 at p0_x=-11988 p0_y=-13056 p0_z=13072 p1_x=-11974 p1_y=-13110 p1_z=13097 p2_x=-12054 p2_y=-13094 p2_z=13191 uv0_u=-10382 uv0_v=-595 uv1_u=-9528 uv1_v=2995 uv2_u=-11248 uv2_v=-1849 view_x=6871 view_y=-6359 view_z=2657 light0_x=-23988 light0_y=21120 light0_z=-30573
//   ts_light0_x: mean 1.57e-5, largest seen 6.32e-5 (1.0 ulp) at p0_x=7888 p0_y=3589 p0_z=-13121 p1_x=7875 p1_y=3709 p1_z=-13121 p2_x=7918 p2_y=3694 p2_z=-13148 uv0_u=9779 uv0_v=1962 uv1_u=7432 uv1_v=3608 uv2_u=8427 uv2_v=2441 view_x=3142 view_y=4159 view_z=-5183 light0_x=-27369 light0_y=-16800 light0_z=21689
//   ts_light0_y: mean 1.62e-5, largest seen 8.70e-5 (1.4 ulp) at p0_x=-14343 p0_y=-11991 p0_z=-12374 p1_x=-14372 p1_y=-11824 p1_z=-12446 p2_x=-14291 p2_y=-11975 p2_z=-12373 uv0_u=-5769 uv0_v=1534 uv1_u=-5987 uv1_v=1672 uv2_u=-6200 uv2_v=1332 view_x=-6980 view_y=-3912 view_z=-6879 light0_x=-30401 light0_y=-28173 light0_z=-9748
//   ts_light0_z: mean 1.57e-5, largest seen 7.04e-5 (1.2 ulp) at p0_x=-5690 p0_y=415 p0_z=3882 p1_x=-5589 p1_y=304 p1_z=3842 p2_x=-5536 p2_y=796 p2_z=3703 uv0_u=3040 uv0_v=-7908 uv1_u=2474 uv1_v=-8467 uv2_u=2843 uv2_v=-8413 view_x=13849 view_y=10624 view_z=-14547 light0_x=-30873 light0_y=9385 light0_z=-31244
//   mirrored: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   degenerate: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_uv: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
//   zero_area: mean 0.00e0, largest seen 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=1474 view_y=-4120 view_z=2825 light0_x=-440 light0_y=-6047 light0_z=-8611
// stated bound on each tangent: 5.74e-5
// stated bound on each binormal: 1.28e-4
// stated bound on each normal: 5.74e-5
// stated bound on each view: 5.78e-4
// stated bound on each light0: 5.78e-4
// stated bound on each flags: 0.00e0
module tangent_faceted (
    input  wire clk,
    input  wire rst, // clears the valid bits
    input  wire ce, // the pipeline stands still without
    input  wire valid_in,
    input  wire signed [4:-11] p0_x, // s16f11
    input  wire signed [4:-11] p0_y, // s16f11
    input  wire signed [4:-11] p0_z, // s16f11
    input  wire signed [4:-11] p1_x, // s16f11
    input  wire signed [4:-11] p1_y, // s16f11
    input  wire signed [4:-11] p1_z, // s16f11
    input  wire signed [4:-11] p2_x, // s16f11
    input  wire signed [4:-11] p2_y, // s16f11
    input  wire signed [4:-11] p2_z, // s16f11
    input  wire signed [2:-13] uv0_u, // s16f13
    input  wire signed [2:-13] uv0_v, // s16f13
    input  wire signed [2:-13] uv1_u, // s16f13
    input  wire signed [2:-13] uv1_v, // s16f13
    input  wire signed [2:-13] uv2_u, // s16f13
    input  wire signed [2:-13] uv2_v, // s16f13
    input  wire signed [1:-14] view_x, // s16f14
    input  wire signed [1:-14] view_y, // s16f14
    input  wire signed [1:-14] view_z, // s16f14
    input  wire signed [1:-14] light0_x, // s16f14
    input  wire signed [1:-14] light0_y, // s16f14
    input  wire signed [1:-14] light0_z, // s16f14
    output wire valid_out,
    output reg  signed [1:-16] t_x, // s18f16
    output reg  signed [1:-16] t_y, // s18f16
    output reg  signed [1:-16] t_z, // s18f16
    output reg  signed [1:-16] b_x, // s18f16
    output reg  signed [1:-16] b_y, // s18f16
    output reg  signed [1:-16] b_z, // s18f16
    output reg  signed [1:-16] n_x, // s18f16
    output reg  signed [1:-16] n_y, // s18f16
    output reg  signed [1:-16] n_z, // s18f16
    output reg  signed [2:-14] ts_view_x, // s17f14
    output reg  signed [2:-14] ts_view_y, // s17f14
    output reg  signed [2:-14] ts_view_z, // s17f14
    output reg  signed [2:-14] ts_light0_x, // s17f14
    output reg  signed [2:-14] ts_light0_y, // s17f14
    output reg  signed [2:-14] ts_light0_z, // s17f14
    output reg  mirrored, // u1f0
    output reg  degenerate, // u1f0
    output reg  zero_uv, // u1f0
    output reg  zero_area // u1f0
);

    // table recip_root: recip_sqrt_base u23f22, recip_sqrt_slope s17f34
    (* rom_style = "block" *)
    reg [39:0] recip_root_rom [0:255];
    initial begin
        recip_root_rom[0] = 40'hffff4502f6; recip_root_rom[1] = 40'hfe053908bc; recip_root_rom[2] = 40'hfc16b70e4a; recip_root_rom[3] = 40'hfa335113a5;
        recip_root_rom[4] = 40'hf85aa118cd; recip_root_rom[5] = 40'hf68c411dc6; recip_root_rom[6] = 40'hf4c7d12291; recip_root_rom[7] = 40'hf30cf92733;
        recip_root_rom[8] = 40'hf15b632bab; recip_root_rom[9] = 40'hefb2bd2ffd; recip_root_rom[10] = 40'hee12bb3429; recip_root_rom[11] = 40'hec7b133833;
        recip_root_rom[12] = 40'heaeb7b3c1a; recip_root_rom[13] = 40'he963b33fe2; recip_root_rom[14] = 40'he7e37b438b; recip_root_rom[15] = 40'he66a934716;
        recip_root_rom[16] = 40'he4f8c34a85; recip_root_rom[17] = 40'he38dd14dda; recip_root_rom[18] = 40'he229875115; recip_root_rom[19] = 40'he0cbb35437;
        recip_root_rom[20] = 40'hdf74235741; recip_root_rom[21] = 40'hde22a95a35; recip_root_rom[22] = 40'hdcd7155d13; recip_root_rom[23] = 40'hdb913b5fdc;
        recip_root_rom[24] = 40'hda50f76290; recip_root_rom[25] = 40'hd916196532; recip_root_rom[26] = 40'hd7e07f67c1; recip_root_rom[27] = 40'hd6b0036a3e;
        recip_root_rom[28] = 40'hd584836caa; recip_root_rom[29] = 40'hd45dd96f06; recip_root_rom[30] = 40'hd33be77151; recip_root_rom[31] = 40'hd21e8b738e;
        recip_root_rom[32] = 40'hd105a775bb; recip_root_rom[33] = 40'hcff11f77da; recip_root_rom[34] = 40'hcee0d579ec; recip_root_rom[35] = 40'hcdd4af7bf0;
        recip_root_rom[36] = 40'hcccc8f7de7; recip_root_rom[37] = 40'hcbc85f7fd2; recip_root_rom[38] = 40'hcac80581b1; recip_root_rom[39] = 40'hc9cb698385;
        recip_root_rom[40] = 40'hc8d273854d; recip_root_rom[41] = 40'hc7dd0f870b; recip_root_rom[42] = 40'hc6eb2588be; recip_root_rom[43] = 40'hc5fca18a67;
        recip_root_rom[44] = 40'hc511718c06; recip_root_rom[45] = 40'hc4297d8d9c; recip_root_rom[46] = 40'hc344b78f28; recip_root_rom[47] = 40'hc2630990ac;
        recip_root_rom[48] = 40'hc184619227; recip_root_rom[49] = 40'hc0a8b1939a; recip_root_rom[50] = 40'hbfcfe79505; recip_root_rom[51] = 40'hbef9f19668;
        recip_root_rom[52] = 40'hbe26c197c3; recip_root_rom[53] = 40'hbd56499917; recip_root_rom[54] = 40'hbc88779a64; recip_root_rom[55] = 40'hbbbd3f9baa;
        recip_root_rom[56] = 40'hbaf4939ce9; recip_root_rom[57] = 40'hba2e679e21; recip_root_rom[58] = 40'hb96aa99f53; recip_root_rom[59] = 40'hb8a951a07f;
        recip_root_rom[60] = 40'hb7ea51a1a5; recip_root_rom[61] = 40'hb72d9ba2c6; recip_root_rom[62] = 40'hb67327a3e0; recip_root_rom[63] = 40'hb5bae9a4f5;
        recip_root_rom[64] = 40'hb504d3a604; recip_root_rom[65] = 40'hb450dba70f; recip_root_rom[66] = 40'hb39efba814; recip_root_rom[67] = 40'hb2ef23a914;
        recip_root_rom[68] = 40'hb2414baa10; recip_root_rom[69] = 40'hb1956bab06; recip_root_rom[70] = 40'hb0eb79abf9; recip_root_rom[71] = 40'hb0436bace6;
        recip_root_rom[72] = 40'haf9d37add0; recip_root_rom[73] = 40'haef8d7aeb5; recip_root_rom[74] = 40'hae5641af96; recip_root_rom[75] = 40'hadb56db073;
        recip_root_rom[76] = 40'had1653b14c; recip_root_rom[77] = 40'hac78ebb221; recip_root_rom[78] = 40'habdd2db2f2; recip_root_rom[79] = 40'hab4313b3c0;
        recip_root_rom[80] = 40'haaaa93b48a; recip_root_rom[81] = 40'haa13a9b551; recip_root_rom[82] = 40'ha97e4bb615; recip_root_rom[83] = 40'ha8ea75b6d5;
        recip_root_rom[84] = 40'ha8581fb792; recip_root_rom[85] = 40'ha7c743b84b; recip_root_rom[86] = 40'ha737dbb902; recip_root_rom[87] = 40'ha6a9dfb9b6;
        recip_root_rom[88] = 40'ha61d4bba66; recip_root_rom[89] = 40'ha59219bb14; recip_root_rom[90] = 40'ha50841bbbf; recip_root_rom[91] = 40'ha47fbfbc68;
        recip_root_rom[92] = 40'ha3f88fbd0d; recip_root_rom[93] = 40'ha372a9bdb0; recip_root_rom[94] = 40'ha2ee09be51; recip_root_rom[95] = 40'ha26aadbeee;
        recip_root_rom[96] = 40'ha1e889bf8a; recip_root_rom[97] = 40'ha1679dc023; recip_root_rom[98] = 40'ha0e7e3c0ba; recip_root_rom[99] = 40'ha06957c14e;
        recip_root_rom[100] = 40'h9febf3c1e0; recip_root_rom[101] = 40'h9f6fb3c270; recip_root_rom[102] = 40'h9ef493c2fe; recip_root_rom[103] = 40'h9e7a8fc389;
        recip_root_rom[104] = 40'h9e01a3c413; recip_root_rom[105] = 40'h9d89c9c49b; recip_root_rom[106] = 40'h9d12ffc520; recip_root_rom[107] = 40'h9c9d3fc5a4;
        recip_root_rom[108] = 40'h9c2887c626; recip_root_rom[109] = 40'h9bb4d3c6a5; recip_root_rom[110] = 40'h9b421dc723; recip_root_rom[111] = 40'h9ad063c7a0;
        recip_root_rom[112] = 40'h9a5fa3c81a; recip_root_rom[113] = 40'h99efd9c893; recip_root_rom[114] = 40'h9980ffc90a; recip_root_rom[115] = 40'h991313c97f;
        recip_root_rom[116] = 40'h98a611c9f3; recip_root_rom[117] = 40'h9839f9ca65; recip_root_rom[118] = 40'h97cec3cad6; recip_root_rom[119] = 40'h97646fcb45;
        recip_root_rom[120] = 40'h96faf9cbb3; recip_root_rom[121] = 40'h96925fcc1f; recip_root_rom[122] = 40'h962a9dcc8a; recip_root_rom[123] = 40'h95c3b1ccf3;
        recip_root_rom[124] = 40'h955d95cd5b; recip_root_rom[125] = 40'h94f84bcdc1; recip_root_rom[126] = 40'h9493cfce26; recip_root_rom[127] = 40'h94301bce8a;
        recip_root_rom[128] = 40'h93cd2fceed; recip_root_rom[129] = 40'h936b09cf4e; recip_root_rom[130] = 40'h9309a5cfae; recip_root_rom[131] = 40'h92a901d00d;
        recip_root_rom[132] = 40'h92491bd06a; recip_root_rom[133] = 40'h91e9efd0c7; recip_root_rom[134] = 40'h918b7dd122; recip_root_rom[135] = 40'h912dc1d17c;
        recip_root_rom[136] = 40'h90d0b9d1d5; recip_root_rom[137] = 40'h907463d22d; recip_root_rom[138] = 40'h9018bdd284; recip_root_rom[139] = 40'h8fbdc5d2d9;
        recip_root_rom[140] = 40'h8f6377d32e; recip_root_rom[141] = 40'h8f09d3d382; recip_root_rom[142] = 40'h8eb0d7d3d4; recip_root_rom[143] = 40'h8e587fd426;
        recip_root_rom[144] = 40'h8e00cbd477; recip_root_rom[145] = 40'h8da9bbd4c6; recip_root_rom[146] = 40'h8d5347d515; recip_root_rom[147] = 40'h8cfd71d563;
        recip_root_rom[148] = 40'h8ca837d5b0; recip_root_rom[149] = 40'h8c5397d5fc; recip_root_rom[150] = 40'h8bff8fd647; recip_root_rom[151] = 40'h8bac1dd691;
        recip_root_rom[152] = 40'h8b593fd6db; recip_root_rom[153] = 40'h8b06f5d723; recip_root_rom[154] = 40'h8ab53bd76b; recip_root_rom[155] = 40'h8a6411d7b2;
        recip_root_rom[156] = 40'h8a1375d7f8; recip_root_rom[157] = 40'h89c367d83d; recip_root_rom[158] = 40'h8973e1d882; recip_root_rom[159] = 40'h8924e5d8c6;
        recip_root_rom[160] = 40'h88d66fd909; recip_root_rom[161] = 40'h888881d94b; recip_root_rom[162] = 40'h883b17d98d; recip_root_rom[163] = 40'h87ee31d9cd;
        recip_root_rom[164] = 40'h87a1cbda0d; recip_root_rom[165] = 40'h8755e7da4d; recip_root_rom[166] = 40'h870a7fda8c; recip_root_rom[167] = 40'h86bf97daca;
        recip_root_rom[168] = 40'h86752bdb07; recip_root_rom[169] = 40'h862b39db44; recip_root_rom[170] = 40'h85e1c1db80; recip_root_rom[171] = 40'h8598c1dbbb;
        recip_root_rom[172] = 40'h855037dbf6; recip_root_rom[173] = 40'h850825dc30; recip_root_rom[174] = 40'h84c085dc6a; recip_root_rom[175] = 40'h847959dca3;
        recip_root_rom[176] = 40'h84329fdcdb; recip_root_rom[177] = 40'h83ec57dd13; recip_root_rom[178] = 40'h83a67ddd4a; recip_root_rom[179] = 40'h836111dd81;
        recip_root_rom[180] = 40'h831c15ddb7; recip_root_rom[181] = 40'h82d783dded; recip_root_rom[182] = 40'h82935dde22; recip_root_rom[183] = 40'h824fa1de56;
        recip_root_rom[184] = 40'h820c4dde8a; recip_root_rom[185] = 40'h81c961debe; recip_root_rom[186] = 40'h8186dddef1; recip_root_rom[187] = 40'h8144bfdf23;
        recip_root_rom[188] = 40'h810305df55; recip_root_rom[189] = 40'h80c1afdf86; recip_root_rom[190] = 40'h8080bddfb7; recip_root_rom[191] = 40'h80402bdfe8;
        recip_root_rom[192] = 40'h7ffffbe018; recip_root_rom[193] = 40'h7fc02be047; recip_root_rom[194] = 40'h7f80b9e077; recip_root_rom[195] = 40'h7f41a7e0a5;
        recip_root_rom[196] = 40'h7f02f1e0d3; recip_root_rom[197] = 40'h7ec499e101; recip_root_rom[198] = 40'h7e869be12e; recip_root_rom[199] = 40'h7e48f7e15b;
        recip_root_rom[200] = 40'h7e0bade188; recip_root_rom[201] = 40'h7dcebde1b4; recip_root_rom[202] = 40'h7d9225e1df; recip_root_rom[203] = 40'h7d55e3e20b;
        recip_root_rom[204] = 40'h7d19f9e235; recip_root_rom[205] = 40'h7cde63e260; recip_root_rom[206] = 40'h7ca323e28a; recip_root_rom[207] = 40'h7c6837e2b3;
        recip_root_rom[208] = 40'h7c2d9de2dd; recip_root_rom[209] = 40'h7bf357e306; recip_root_rom[210] = 40'h7bb961e32e; recip_root_rom[211] = 40'h7b7fbde356;
        recip_root_rom[212] = 40'h7b4669e37e; recip_root_rom[213] = 40'h7b0d67e3a5; recip_root_rom[214] = 40'h7ad4b1e3cc; recip_root_rom[215] = 40'h7a9c49e3f3;
        recip_root_rom[216] = 40'h7a6431e419; recip_root_rom[217] = 40'h7a2c63e440; recip_root_rom[218] = 40'h79f4e1e465; recip_root_rom[219] = 40'h79bdabe48b;
        recip_root_rom[220] = 40'h7986c1e4b0; recip_root_rom[221] = 40'h795021e4d4; recip_root_rom[222] = 40'h7919c9e4f9; recip_root_rom[223] = 40'h78e3bbe51d;
        recip_root_rom[224] = 40'h78adf3e541; recip_root_rom[225] = 40'h787875e564; recip_root_rom[226] = 40'h78433de587; recip_root_rom[227] = 40'h780e4be5aa;
        recip_root_rom[228] = 40'h77d99fe5cc; recip_root_rom[229] = 40'h77a537e5ef; recip_root_rom[230] = 40'h777115e611; recip_root_rom[231] = 40'h773d37e632;
        recip_root_rom[232] = 40'h77099be654; recip_root_rom[233] = 40'h76d643e675; recip_root_rom[234] = 40'h76a32de696; recip_root_rom[235] = 40'h767059e6b6;
        recip_root_rom[236] = 40'h763dc5e6d7; recip_root_rom[237] = 40'h760b73e6f7; recip_root_rom[238] = 40'h75d95fe716; recip_root_rom[239] = 40'h75a78be736;
        recip_root_rom[240] = 40'h7575f7e755; recip_root_rom[241] = 40'h7544a1e774; recip_root_rom[242] = 40'h751389e793; recip_root_rom[243] = 40'h74e2afe7b1;
        recip_root_rom[244] = 40'h74b213e7cf; recip_root_rom[245] = 40'h7481b1e7ed; recip_root_rom[246] = 40'h74518de80b; recip_root_rom[247] = 40'h7421a3e829;
        recip_root_rom[248] = 40'h73f1f3e846; recip_root_rom[249] = 40'h73c27fe863; recip_root_rom[250] = 40'h739345e880; recip_root_rom[251] = 40'h736447e89c;
        recip_root_rom[252] = 40'h73357fe8b9; recip_root_rom[253] = 40'h7306f1e8d5; recip_root_rom[254] = 40'h72d899e8f1; recip_root_rom[255] = 40'h72aa7be90d;
    end

    // ---- stage 0 ----
    // primitive
    wire signed [5:-11] primitive_e1_x = {p1_x[4], p1_x} - {p0_x[4], p0_x}; // s17f11
    wire signed [5:-11] primitive_e1_y = {p1_y[4], p1_y} - {p0_y[4], p0_y}; // s17f11
    wire signed [5:-11] primitive_e1_z = {p1_z[4], p1_z} - {p0_z[4], p0_z}; // s17f11
    wire signed [5:-11] primitive_e2_x = {p2_x[4], p2_x} - {p0_x[4], p0_x}; // s17f11
    wire signed [5:-11] primitive_e2_y = {p2_y[4], p2_y} - {p0_y[4], p0_y}; // s17f11
    wire signed [5:-11] primitive_e2_z = {p2_z[4], p2_z} - {p0_z[4], p0_z}; // s17f11
    wire signed [3:-13] primitive_du1 = {uv1_u[2], uv1_u} - {uv0_u[2], uv0_u}; // s17f13
    wire signed [3:-13] primitive_dv1 = {uv1_v[2], uv1_v} - {uv0_v[2], uv0_v}; // s17f13
    wire signed [3:-13] primitive_du2 = {uv2_u[2], uv2_u} - {uv0_u[2], uv0_u}; // s17f13
    wire signed [3:-13] primitive_dv2 = {uv2_v[2], uv2_v} - {uv0_v[2], uv0_v}; // s17f13
    wire signed [7:-26] primitive_n31 = primitive_du1 * primitive_dv2; // s34f26
    wire signed [7:-26] primitive_n32 = primitive_du2 * primitive_dv1; // s34f26
    wire primitive_n34 = 1'b0; // u1f0
    wire signed [9:-24] primitive_n37 = primitive_dv2 * primitive_e1_x; // s34f24
    wire signed [9:-24] primitive_n38 = primitive_dv1 * primitive_e2_x; // s34f24
    wire signed [9:-24] primitive_n40 = primitive_dv2 * primitive_e1_y; // s34f24
    wire signed [9:-24] primitive_n41 = primitive_dv1 * primitive_e2_y; // s34f24
    wire signed [9:-24] primitive_n43 = primitive_dv2 * primitive_e1_z; // s34f24
    wire signed [9:-24] primitive_n44 = primitive_dv1 * primitive_e2_z; // s34f24
    // primitive.e1_cross_e2
    wire signed [11:-22] primitive_e1_cross_e2_n46 = primitive_e1_y * primitive_e2_z; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n47 = primitive_e1_z * primitive_e2_y; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n49 = primitive_e1_z * primitive_e2_x; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n50 = primitive_e1_x * primitive_e2_z; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n52 = primitive_e1_x * primitive_e2_y; // s34f22
    wire signed [11:-22] primitive_e1_cross_e2_n53 = primitive_e1_y * primitive_e2_x; // s34f22
    // primitive
    wire signed [-8:-24] primitive_n61 = primitive_e1_x; // s17f24
    wire signed [-8:-24] primitive_n63 = primitive_e1_y; // s17f24
    wire signed [-8:-24] primitive_n65 = primitive_e1_z; // s17f24
    wire signed [10:-24] primitive_n67 = 35'h1; // s35f24
    wire signed [10:-24] primitive_n68 = 35'h0; // s35f24
    // primitive.t
    wire [31:0] primitive_t_n85 = 32'h0; // u32f0
    wire [15:0] primitive_t_n91 = 16'h0; // u16f0
    wire [7:0] primitive_t_n97 = 8'h0; // u8f0
    wire [3:0] primitive_t_n103 = 4'h0; // u4f0
    wire [1:0] primitive_t_n109 = 2'h0; // u2f0
    // primitive.t_length
    wire primitive_t_length_n229 = 1'b1; // u1f0
    wire primitive_t_length_n244 = 1'b1; // u1e2
    // primitive
    wire signed [12:-22] primitive_n254 = 35'h0; // s35f22
    wire signed [12:-22] primitive_n255 = 35'h1; // s35f22

    reg signed [1:-14] view_x_s1; // s16f14
    reg signed [1:-14] view_y_s1; // s16f14
    reg signed [1:-14] view_z_s1; // s16f14
    reg signed [1:-14] light0_x_s1; // s16f14
    reg signed [1:-14] light0_y_s1; // s16f14
    reg signed [1:-14] light0_z_s1; // s16f14
    reg signed [7:-26] primitive_n31_s1; // s34f26
    reg signed [7:-26] primitive_n32_s1; // s34f26
    reg signed [9:-24] primitive_n37_s1; // s34f24
    reg signed [9:-24] primitive_n38_s1; // s34f24
    reg signed [9:-24] primitive_n40_s1; // s34f24
    reg signed [9:-24] primitive_n41_s1; // s34f24
    reg signed [9:-24] primitive_n43_s1; // s34f24
    reg signed [9:-24] primitive_n44_s1; // s34f24
    reg signed [11:-22] primitive_e1_cross_e2_n46_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n47_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n49_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n50_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n52_s1; // s34f22
    reg signed [11:-22] primitive_e1_cross_e2_n53_s1; // s34f22
    reg signed [-8:-24] primitive_n61_s1; // s17f24
    reg signed [-8:-24] primitive_n63_s1; // s17f24
    reg signed [-8:-24] primitive_n65_s1; // s17f24
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s1;
    always @(posedge clk)
        if (rst) valid_s1 <= 1'b0;
        else if (ce) valid_s1 <= valid_in;

    // ---- stage 1 ----
    // primitive
    wire signed [8:-26] primitive_det = {primitive_n31_s1[7], primitive_n31_s1} - {primitive_n32_s1[7], primitive_n32_s1}; // s35f26
    wire primitive_zero_uv = primitive_det == {8'h0, primitive_n34, 26'h0}; // u1f0
    wire primitive_mirrored = primitive_det[8]; // u1f0
    wire signed [10:-24] primitive_t_det_x = {primitive_n37_s1[9], primitive_n37_s1} - {primitive_n38_s1[9], primitive_n38_s1}; // s35f24
    wire signed [10:-24] primitive_t_det_y = {primitive_n40_s1[9], primitive_n40_s1} - {primitive_n41_s1[9], primitive_n41_s1}; // s35f24
    wire signed [10:-24] primitive_t_det_z = {primitive_n43_s1[9], primitive_n43_s1} - {primitive_n44_s1[9], primitive_n44_s1}; // s35f24
    // primitive.e1_cross_e2
    wire signed [12:-22] primitive_e1_cross_e2_n48 = {primitive_e1_cross_e2_n46_s1[11], primitive_e1_cross_e2_n46_s1} - {primitive_e1_cross_e2_n47_s1[11], primitive_e1_cross_e2_n47_s1}; // s35f22
    wire signed [12:-22] primitive_e1_cross_e2_n51 = {primitive_e1_cross_e2_n49_s1[11], primitive_e1_cross_e2_n49_s1} - {primitive_e1_cross_e2_n50_s1[11], primitive_e1_cross_e2_n50_s1}; // s35f22
    wire signed [12:-22] primitive_e1_cross_e2_n54 = {primitive_e1_cross_e2_n52_s1[11], primitive_e1_cross_e2_n52_s1} - {primitive_e1_cross_e2_n53_s1[11], primitive_e1_cross_e2_n53_s1}; // s35f22
    // primitive
    wire primitive_n55 = primitive_e1_cross_e2_n48 == {12'h0, primitive_n34, 22'h0}; // u1f0
    wire primitive_n56 = primitive_e1_cross_e2_n51 == {12'h0, primitive_n34, 22'h0}; // u1f0
    wire primitive_n57 = primitive_e1_cross_e2_n54 == {12'h0, primitive_n34, 22'h0}; // u1f0
    wire primitive_n58 = primitive_n55 & primitive_n56; // u1f0
    wire primitive_zero_area = primitive_n58 & primitive_n57; // u1f0
    wire primitive_degenerate = primitive_zero_uv | primitive_zero_area; // u1f0
    wire signed [10:-24] primitive_n62 = primitive_zero_uv ? {{18{primitive_n61_s1[-8]}}, primitive_n61_s1} : primitive_t_det_x; // s35f24
    wire signed [10:-24] primitive_n64 = primitive_zero_uv ? {{18{primitive_n63_s1[-8]}}, primitive_n63_s1} : primitive_t_det_y; // s35f24
    wire signed [10:-24] primitive_n66 = primitive_zero_uv ? {{18{primitive_n65_s1[-8]}}, primitive_n65_s1} : primitive_t_det_z; // s35f24
    wire signed [10:-24] primitive_n69 = primitive_zero_area ? primitive_n67 : primitive_n62; // s35f24
    wire signed [10:-24] primitive_n70 = primitive_zero_area ? primitive_n68 : primitive_n64; // s35f24
    wire signed [10:-24] primitive_n71 = primitive_zero_area ? primitive_n68 : primitive_n66; // s35f24
    // primitive.t
    wire primitive_t_n119 = primitive_n69[10]; // u1f0
    wire [34:0] primitive_t_n120 = primitive_n69; // u35f0
    wire [35:0] primitive_t_n121 = {primitive_t_n119, primitive_t_n120}; // u36f0
    wire [3:0] primitive_t_n123 = primitive_t_n121[3:0]; // u4f0
    wire [35:0] primitive_t_n124 = {primitive_t_n123, primitive_t_n85}; // u36f0
    wire primitive_t_n148 = primitive_n70[10]; // u1f0
    wire [34:0] primitive_t_n149 = primitive_n70; // u35f0
    wire [35:0] primitive_t_n150 = {primitive_t_n148, primitive_t_n149}; // u36f0
    wire [3:0] primitive_t_n151 = primitive_t_n150[3:0]; // u4f0
    wire [35:0] primitive_t_n152 = {primitive_t_n151, primitive_t_n85}; // u36f0
    wire primitive_t_n171 = primitive_n71[10]; // u1f0
    wire [34:0] primitive_t_n172 = primitive_n71; // u35f0
    wire [35:0] primitive_t_n173 = {primitive_t_n171, primitive_t_n172}; // u36f0
    wire [3:0] primitive_t_n174 = primitive_t_n173[3:0]; // u4f0
    wire [35:0] primitive_t_n175 = {primitive_t_n174, primitive_t_n85}; // u36f0
    // primitive
    wire signed [12:-22] primitive_n256 = primitive_zero_area ? primitive_n254 : primitive_e1_cross_e2_n48; // s35f22
    wire signed [12:-22] primitive_n257 = primitive_zero_area ? primitive_n254 : primitive_e1_cross_e2_n51; // s35f22
    wire signed [12:-22] primitive_n258 = primitive_zero_area ? primitive_n255 : primitive_e1_cross_e2_n54; // s35f22
    // primitive.n
    wire primitive_n_n301 = primitive_n256[12]; // u1f0
    wire [34:0] primitive_n_n302 = primitive_n256; // u35f0
    wire [35:0] primitive_n_n303 = {primitive_n_n301, primitive_n_n302}; // u36f0
    wire [3:0] primitive_n_n305 = primitive_n_n303[3:0]; // u4f0
    wire [35:0] primitive_n_n306 = {primitive_n_n305, primitive_t_n85}; // u36f0
    wire primitive_n_n330 = primitive_n257[12]; // u1f0
    wire [34:0] primitive_n_n331 = primitive_n257; // u35f0
    wire [35:0] primitive_n_n332 = {primitive_n_n330, primitive_n_n331}; // u36f0
    wire [3:0] primitive_n_n333 = primitive_n_n332[3:0]; // u4f0
    wire [35:0] primitive_n_n334 = {primitive_n_n333, primitive_t_n85}; // u36f0
    wire primitive_n_n353 = primitive_n258[12]; // u1f0
    wire [34:0] primitive_n_n354 = primitive_n258; // u35f0
    wire [35:0] primitive_n_n355 = {primitive_n_n353, primitive_n_n354}; // u36f0
    wire [3:0] primitive_n_n356 = primitive_n_n355[3:0]; // u4f0
    wire [35:0] primitive_n_n357 = {primitive_n_n356, primitive_t_n85}; // u36f0

    reg signed [1:-14] view_x_s2; // s16f14
    reg signed [1:-14] view_y_s2; // s16f14
    reg signed [1:-14] view_z_s2; // s16f14
    reg signed [1:-14] light0_x_s2; // s16f14
    reg signed [1:-14] light0_y_s2; // s16f14
    reg signed [1:-14] light0_z_s2; // s16f14
    reg primitive_zero_uv_s2; // u1f0
    reg primitive_mirrored_s2; // u1f0
    reg primitive_zero_area_s2; // u1f0
    reg primitive_degenerate_s2; // u1f0
    reg signed [10:-24] primitive_n69_s2; // s35f24
    reg signed [10:-24] primitive_n70_s2; // s35f24
    reg signed [10:-24] primitive_n71_s2; // s35f24
    reg [35:0] primitive_t_n121_s2; // u36f0
    reg [35:0] primitive_t_n124_s2; // u36f0
    reg [35:0] primitive_t_n150_s2; // u36f0
    reg [35:0] primitive_t_n152_s2; // u36f0
    reg [35:0] primitive_t_n173_s2; // u36f0
    reg [35:0] primitive_t_n175_s2; // u36f0
    reg signed [12:-22] primitive_n256_s2; // s35f22
    reg signed [12:-22] primitive_n257_s2; // s35f22
    reg signed [12:-22] primitive_n258_s2; // s35f22
    reg [35:0] primitive_n_n303_s2; // u36f0
    reg [35:0] primitive_n_n306_s2; // u36f0
    reg [35:0] primitive_n_n332_s2; // u36f0
    reg [35:0] primitive_n_n334_s2; // u36f0
    reg [35:0] primitive_n_n355_s2; // u36f0
    reg [35:0] primitive_n_n357_s2; // u36f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s2;
    always @(posedge clk)
        if (rst) valid_s2 <= 1'b0;
        else if (ce) valid_s2 <= valid_s1;

    // ---- stage 2 ----
    // primitive.t
    wire [10:-24] primitive_t_n72_neg = -primitive_n69_s2;
    wire [10:-24] primitive_t_n72 = primitive_n69_s2[10] ? primitive_t_n72_neg : primitive_n69_s2; // u35f24
    wire [34:0] primitive_t_n73 = primitive_t_n72; // u35f0
    wire [10:-24] primitive_t_n74_neg = -primitive_n70_s2;
    wire [10:-24] primitive_t_n74 = primitive_n70_s2[10] ? primitive_t_n74_neg : primitive_n70_s2; // u35f24
    wire [34:0] primitive_t_n75 = primitive_t_n74; // u35f0
    wire [10:-24] primitive_t_n76_neg = -primitive_n71_s2;
    wire [10:-24] primitive_t_n76 = primitive_n71_s2[10] ? primitive_t_n76_neg : primitive_n71_s2; // u35f24
    wire [34:0] primitive_t_n77 = primitive_t_n76; // u35f0
    wire [34:0] primitive_t_n78 = primitive_t_n73 | primitive_t_n75; // u35f0
    wire [34:0] primitive_t_n79 = primitive_t_n78 | primitive_t_n77; // u35f0
    wire [10:-24] primitive_t_largest = primitive_t_n79; // u35f24
    wire [34:0] primitive_t_n81 = primitive_t_largest; // u35f0
    wire [31:0] primitive_t_n82 = primitive_t_n81[34:3]; // u32f0
    wire primitive_t_n83 = primitive_t_n82 == {31'h0, primitive_n34}; // u1f0
    wire [2:0] primitive_t_n84 = primitive_t_n81[2:0]; // u3f0
    wire [34:0] primitive_t_n86 = {primitive_t_n84, primitive_t_n85}; // u35f0
    wire [34:0] primitive_t_n87 = primitive_t_n83 ? primitive_t_n86 : primitive_t_n81; // u35f0
    wire [15:0] primitive_t_n88 = primitive_t_n87[34:19]; // u16f0
    wire [18:0] primitive_t_n90 = primitive_t_n87[18:0]; // u19f0
    wire [34:0] primitive_t_n92 = {primitive_t_n90, primitive_t_n91}; // u35f0
    // primitive.n
    wire [12:-22] primitive_n_n259_neg = -primitive_n256_s2;
    wire [12:-22] primitive_n_n259 = primitive_n256_s2[12] ? primitive_n_n259_neg : primitive_n256_s2; // u35f22
    wire [34:0] primitive_n_n260 = primitive_n_n259; // u35f0
    wire [12:-22] primitive_n_n261_neg = -primitive_n257_s2;
    wire [12:-22] primitive_n_n261 = primitive_n257_s2[12] ? primitive_n_n261_neg : primitive_n257_s2; // u35f22
    wire [34:0] primitive_n_n262 = primitive_n_n261; // u35f0
    wire [12:-22] primitive_n_n263_neg = -primitive_n258_s2;
    wire [12:-22] primitive_n_n263 = primitive_n258_s2[12] ? primitive_n_n263_neg : primitive_n258_s2; // u35f22
    wire [34:0] primitive_n_n264 = primitive_n_n263; // u35f0
    wire [34:0] primitive_n_n265 = primitive_n_n260 | primitive_n_n262; // u35f0
    wire [34:0] primitive_n_n266 = primitive_n_n265 | primitive_n_n264; // u35f0
    wire [12:-22] primitive_n_largest = primitive_n_n266; // u35f22
    wire [34:0] primitive_n_n268 = primitive_n_largest; // u35f0
    wire [31:0] primitive_n_n269 = primitive_n_n268[34:3]; // u32f0
    wire primitive_n_n270 = primitive_n_n269 == {31'h0, primitive_n34}; // u1f0
    wire [2:0] primitive_n_n271 = primitive_n_n268[2:0]; // u3f0
    wire [34:0] primitive_n_n272 = {primitive_n_n271, primitive_t_n85}; // u35f0
    wire [34:0] primitive_n_n273 = primitive_n_n270 ? primitive_n_n272 : primitive_n_n268; // u35f0
    wire [15:0] primitive_n_n274 = primitive_n_n273[34:19]; // u16f0
    wire [18:0] primitive_n_n276 = primitive_n_n273[18:0]; // u19f0
    wire [34:0] primitive_n_n277 = {primitive_n_n276, primitive_t_n91}; // u35f0
    // primitive
    wire primitive_n446 = primitive_degenerate_s2 ^ primitive_t_length_n229; // u1f0
    wire primitive_n447 = primitive_mirrored_s2 & primitive_n446; // u1f0

    reg signed [1:-14] view_x_s3; // s16f14
    reg signed [1:-14] view_y_s3; // s16f14
    reg signed [1:-14] view_z_s3; // s16f14
    reg signed [1:-14] light0_x_s3; // s16f14
    reg signed [1:-14] light0_y_s3; // s16f14
    reg signed [1:-14] light0_z_s3; // s16f14
    reg primitive_zero_uv_s3; // u1f0
    reg primitive_mirrored_s3; // u1f0
    reg primitive_zero_area_s3; // u1f0
    reg primitive_degenerate_s3; // u1f0
    reg primitive_t_n83_s3; // u1f0
    reg [34:0] primitive_t_n87_s3; // u35f0
    reg [15:0] primitive_t_n88_s3; // u16f0
    reg [34:0] primitive_t_n92_s3; // u35f0
    reg [35:0] primitive_t_n121_s3; // u36f0
    reg [35:0] primitive_t_n124_s3; // u36f0
    reg [35:0] primitive_t_n150_s3; // u36f0
    reg [35:0] primitive_t_n152_s3; // u36f0
    reg [35:0] primitive_t_n173_s3; // u36f0
    reg [35:0] primitive_t_n175_s3; // u36f0
    reg primitive_n_n270_s3; // u1f0
    reg [34:0] primitive_n_n273_s3; // u35f0
    reg [15:0] primitive_n_n274_s3; // u16f0
    reg [34:0] primitive_n_n277_s3; // u35f0
    reg [35:0] primitive_n_n303_s3; // u36f0
    reg [35:0] primitive_n_n306_s3; // u36f0
    reg [35:0] primitive_n_n332_s3; // u36f0
    reg [35:0] primitive_n_n334_s3; // u36f0
    reg [35:0] primitive_n_n355_s3; // u36f0
    reg [35:0] primitive_n_n357_s3; // u36f0
    reg primitive_n447_s3; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s3;
    always @(posedge clk)
        if (rst) valid_s3 <= 1'b0;
        else if (ce) valid_s3 <= valid_s2;

    // ---- stage 3 ----
    // primitive.t
    wire primitive_t_n89 = primitive_t_n88_s3 == {15'h0, primitive_n34}; // u1f0
    wire [34:0] primitive_t_n93 = primitive_t_n89 ? primitive_t_n92_s3 : primitive_t_n87_s3; // u35f0
    wire [7:0] primitive_t_n94 = primitive_t_n93[34:27]; // u8f0
    wire primitive_t_n95 = primitive_t_n94 == {7'h0, primitive_n34}; // u1f0
    wire [26:0] primitive_t_n96 = primitive_t_n93[26:0]; // u27f0
    wire [34:0] primitive_t_n98 = {primitive_t_n96, primitive_t_n97}; // u35f0
    wire [34:0] primitive_t_n99 = primitive_t_n95 ? primitive_t_n98 : primitive_t_n93; // u35f0
    wire [3:0] primitive_t_n100 = primitive_t_n99[34:31]; // u4f0
    wire primitive_t_n101 = primitive_t_n100 == {3'h0, primitive_n34}; // u1f0
    wire [30:0] primitive_t_n102 = primitive_t_n99[30:0]; // u31f0
    wire [34:0] primitive_t_n104 = {primitive_t_n102, primitive_t_n103}; // u35f0
    wire [34:0] primitive_t_n105 = primitive_t_n101 ? primitive_t_n104 : primitive_t_n99; // u35f0
    wire [1:0] primitive_t_n106 = primitive_t_n105[34:33]; // u2f0
    wire [32:0] primitive_t_n108 = primitive_t_n105[32:0]; // u33f0
    wire [34:0] primitive_t_n110 = {primitive_t_n108, primitive_t_n109}; // u35f0
    wire [1:0] primitive_t_n114 = {primitive_t_n83_s3, primitive_t_n89}; // u2f0
    wire [2:0] primitive_t_n115 = {primitive_t_n114, primitive_t_n95}; // u3f0
    wire [3:0] primitive_t_n116 = {primitive_t_n115, primitive_t_n101}; // u4f0
    // primitive.n
    wire primitive_n_n275 = primitive_n_n274_s3 == {15'h0, primitive_n34}; // u1f0
    wire [34:0] primitive_n_n278 = primitive_n_n275 ? primitive_n_n277_s3 : primitive_n_n273_s3; // u35f0
    wire [7:0] primitive_n_n279 = primitive_n_n278[34:27]; // u8f0
    wire primitive_n_n280 = primitive_n_n279 == {7'h0, primitive_n34}; // u1f0
    wire [26:0] primitive_n_n281 = primitive_n_n278[26:0]; // u27f0
    wire [34:0] primitive_n_n282 = {primitive_n_n281, primitive_t_n97}; // u35f0
    wire [34:0] primitive_n_n283 = primitive_n_n280 ? primitive_n_n282 : primitive_n_n278; // u35f0
    wire [3:0] primitive_n_n284 = primitive_n_n283[34:31]; // u4f0
    wire primitive_n_n285 = primitive_n_n284 == {3'h0, primitive_n34}; // u1f0
    wire [30:0] primitive_n_n286 = primitive_n_n283[30:0]; // u31f0
    wire [34:0] primitive_n_n287 = {primitive_n_n286, primitive_t_n103}; // u35f0
    wire [34:0] primitive_n_n288 = primitive_n_n285 ? primitive_n_n287 : primitive_n_n283; // u35f0
    wire [1:0] primitive_n_n289 = primitive_n_n288[34:33]; // u2f0
    wire [32:0] primitive_n_n291 = primitive_n_n288[32:0]; // u33f0
    wire [34:0] primitive_n_n292 = {primitive_n_n291, primitive_t_n109}; // u35f0
    wire [1:0] primitive_n_n296 = {primitive_n_n270_s3, primitive_n_n275}; // u2f0
    wire [2:0] primitive_n_n297 = {primitive_n_n296, primitive_n_n280}; // u3f0
    wire [3:0] primitive_n_n298 = {primitive_n_n297, primitive_n_n285}; // u4f0

    reg signed [1:-14] view_x_s4; // s16f14
    reg signed [1:-14] view_y_s4; // s16f14
    reg signed [1:-14] view_z_s4; // s16f14
    reg signed [1:-14] light0_x_s4; // s16f14
    reg signed [1:-14] light0_y_s4; // s16f14
    reg signed [1:-14] light0_z_s4; // s16f14
    reg primitive_zero_uv_s4; // u1f0
    reg primitive_mirrored_s4; // u1f0
    reg primitive_zero_area_s4; // u1f0
    reg primitive_degenerate_s4; // u1f0
    reg [34:0] primitive_t_n105_s4; // u35f0
    reg [1:0] primitive_t_n106_s4; // u2f0
    reg [34:0] primitive_t_n110_s4; // u35f0
    reg [3:0] primitive_t_n116_s4; // u4f0
    reg [35:0] primitive_t_n121_s4; // u36f0
    reg [35:0] primitive_t_n124_s4; // u36f0
    reg [35:0] primitive_t_n150_s4; // u36f0
    reg [35:0] primitive_t_n152_s4; // u36f0
    reg [35:0] primitive_t_n173_s4; // u36f0
    reg [35:0] primitive_t_n175_s4; // u36f0
    reg [34:0] primitive_n_n288_s4; // u35f0
    reg [1:0] primitive_n_n289_s4; // u2f0
    reg [34:0] primitive_n_n292_s4; // u35f0
    reg [3:0] primitive_n_n298_s4; // u4f0
    reg [35:0] primitive_n_n303_s4; // u36f0
    reg [35:0] primitive_n_n306_s4; // u36f0
    reg [35:0] primitive_n_n332_s4; // u36f0
    reg [35:0] primitive_n_n334_s4; // u36f0
    reg [35:0] primitive_n_n355_s4; // u36f0
    reg [35:0] primitive_n_n357_s4; // u36f0
    reg primitive_n447_s4; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s4;
    always @(posedge clk)
        if (rst) valid_s4 <= 1'b0;
        else if (ce) valid_s4 <= valid_s3;

    // ---- stage 4 ----
    // primitive.t
    wire primitive_t_n107 = primitive_t_n106_s4 == {1'b0, primitive_n34}; // u1f0
    wire [34:0] primitive_t_n111 = primitive_t_n107 ? primitive_t_n110_s4 : primitive_t_n105_s4; // u35f0
    wire primitive_t_n112 = primitive_t_n111[34]; // u1f0
    wire primitive_t_n113 = primitive_t_n112 == primitive_n34; // u1f0
    wire [4:0] primitive_t_n117 = {primitive_t_n116_s4, primitive_t_n107}; // u5f0
    wire [5:0] primitive_t_places = {primitive_t_n117, primitive_t_n113}; // u6f0
    wire primitive_t_n122 = primitive_t_places[5]; // u1f0
    wire [35:0] primitive_t_n125 = primitive_t_n122 ? primitive_t_n124_s4 : primitive_t_n121_s4; // u36f0
    wire primitive_t_n126 = primitive_t_places[4]; // u1f0
    wire [19:0] primitive_t_n127 = primitive_t_n125[19:0]; // u20f0
    wire [35:0] primitive_t_n128 = {primitive_t_n127, primitive_t_n91}; // u36f0
    wire [35:0] primitive_t_n129 = primitive_t_n126 ? primitive_t_n128 : primitive_t_n125; // u36f0
    wire primitive_t_n130 = primitive_t_places[3]; // u1f0
    wire [27:0] primitive_t_n131 = primitive_t_n129[27:0]; // u28f0
    wire [35:0] primitive_t_n132 = {primitive_t_n131, primitive_t_n97}; // u36f0
    wire [35:0] primitive_t_n133 = primitive_t_n130 ? primitive_t_n132 : primitive_t_n129; // u36f0
    wire primitive_t_n134 = primitive_t_places[2]; // u1f0
    wire [31:0] primitive_t_n135 = primitive_t_n133[31:0]; // u32f0
    wire [35:0] primitive_t_n136 = {primitive_t_n135, primitive_t_n103}; // u36f0
    wire [35:0] primitive_t_n137 = primitive_t_n134 ? primitive_t_n136 : primitive_t_n133; // u36f0
    wire primitive_t_n138 = primitive_t_places[1]; // u1f0
    wire [33:0] primitive_t_n139 = primitive_t_n137[33:0]; // u34f0
    wire [35:0] primitive_t_n140 = {primitive_t_n139, primitive_t_n109}; // u36f0
    wire [35:0] primitive_t_n141 = primitive_t_n138 ? primitive_t_n140 : primitive_t_n137; // u36f0
    wire primitive_t_n142 = primitive_t_places[0]; // u1f0
    wire [34:0] primitive_t_n143 = primitive_t_n141[34:0]; // u35f0
    wire [35:0] primitive_t_n144 = {primitive_t_n143, primitive_n34}; // u36f0
    wire [35:0] primitive_t_n153 = primitive_t_n122 ? primitive_t_n152_s4 : primitive_t_n150_s4; // u36f0
    wire [19:0] primitive_t_n154 = primitive_t_n153[19:0]; // u20f0
    wire [35:0] primitive_t_n155 = {primitive_t_n154, primitive_t_n91}; // u36f0
    wire [35:0] primitive_t_n156 = primitive_t_n126 ? primitive_t_n155 : primitive_t_n153; // u36f0
    wire [27:0] primitive_t_n157 = primitive_t_n156[27:0]; // u28f0
    wire [35:0] primitive_t_n158 = {primitive_t_n157, primitive_t_n97}; // u36f0
    wire [35:0] primitive_t_n159 = primitive_t_n130 ? primitive_t_n158 : primitive_t_n156; // u36f0
    wire [31:0] primitive_t_n160 = primitive_t_n159[31:0]; // u32f0
    wire [35:0] primitive_t_n161 = {primitive_t_n160, primitive_t_n103}; // u36f0
    wire [35:0] primitive_t_n162 = primitive_t_n134 ? primitive_t_n161 : primitive_t_n159; // u36f0
    wire [33:0] primitive_t_n163 = primitive_t_n162[33:0]; // u34f0
    wire [35:0] primitive_t_n164 = {primitive_t_n163, primitive_t_n109}; // u36f0
    wire [35:0] primitive_t_n165 = primitive_t_n138 ? primitive_t_n164 : primitive_t_n162; // u36f0
    wire [34:0] primitive_t_n166 = primitive_t_n165[34:0]; // u35f0
    wire [35:0] primitive_t_n167 = {primitive_t_n166, primitive_n34}; // u36f0
    wire [35:0] primitive_t_n176 = primitive_t_n122 ? primitive_t_n175_s4 : primitive_t_n173_s4; // u36f0
    wire [19:0] primitive_t_n177 = primitive_t_n176[19:0]; // u20f0
    wire [35:0] primitive_t_n178 = {primitive_t_n177, primitive_t_n91}; // u36f0
    wire [35:0] primitive_t_n179 = primitive_t_n126 ? primitive_t_n178 : primitive_t_n176; // u36f0
    wire [27:0] primitive_t_n180 = primitive_t_n179[27:0]; // u28f0
    wire [35:0] primitive_t_n181 = {primitive_t_n180, primitive_t_n97}; // u36f0
    wire [35:0] primitive_t_n182 = primitive_t_n130 ? primitive_t_n181 : primitive_t_n179; // u36f0
    wire [31:0] primitive_t_n183 = primitive_t_n182[31:0]; // u32f0
    wire [35:0] primitive_t_n184 = {primitive_t_n183, primitive_t_n103}; // u36f0
    wire [35:0] primitive_t_n185 = primitive_t_n134 ? primitive_t_n184 : primitive_t_n182; // u36f0
    wire [33:0] primitive_t_n186 = primitive_t_n185[33:0]; // u34f0
    wire [35:0] primitive_t_n187 = {primitive_t_n186, primitive_t_n109}; // u36f0
    wire [35:0] primitive_t_n188 = primitive_t_n138 ? primitive_t_n187 : primitive_t_n185; // u36f0
    wire [34:0] primitive_t_n189 = primitive_t_n188[34:0]; // u35f0
    wire [35:0] primitive_t_n190 = {primitive_t_n189, primitive_n34}; // u36f0
    // primitive.n
    wire primitive_n_n290 = primitive_n_n289_s4 == {1'b0, primitive_n34}; // u1f0
    wire [34:0] primitive_n_n293 = primitive_n_n290 ? primitive_n_n292_s4 : primitive_n_n288_s4; // u35f0
    wire primitive_n_n294 = primitive_n_n293[34]; // u1f0
    wire primitive_n_n295 = primitive_n_n294 == primitive_n34; // u1f0
    wire [4:0] primitive_n_n299 = {primitive_n_n298_s4, primitive_n_n290}; // u5f0
    wire [5:0] primitive_n_places = {primitive_n_n299, primitive_n_n295}; // u6f0
    wire primitive_n_n304 = primitive_n_places[5]; // u1f0
    wire [35:0] primitive_n_n307 = primitive_n_n304 ? primitive_n_n306_s4 : primitive_n_n303_s4; // u36f0
    wire primitive_n_n308 = primitive_n_places[4]; // u1f0
    wire [19:0] primitive_n_n309 = primitive_n_n307[19:0]; // u20f0
    wire [35:0] primitive_n_n310 = {primitive_n_n309, primitive_t_n91}; // u36f0
    wire [35:0] primitive_n_n311 = primitive_n_n308 ? primitive_n_n310 : primitive_n_n307; // u36f0
    wire primitive_n_n312 = primitive_n_places[3]; // u1f0
    wire [27:0] primitive_n_n313 = primitive_n_n311[27:0]; // u28f0
    wire [35:0] primitive_n_n314 = {primitive_n_n313, primitive_t_n97}; // u36f0
    wire [35:0] primitive_n_n315 = primitive_n_n312 ? primitive_n_n314 : primitive_n_n311; // u36f0
    wire primitive_n_n316 = primitive_n_places[2]; // u1f0
    wire [31:0] primitive_n_n317 = primitive_n_n315[31:0]; // u32f0
    wire [35:0] primitive_n_n318 = {primitive_n_n317, primitive_t_n103}; // u36f0
    wire [35:0] primitive_n_n319 = primitive_n_n316 ? primitive_n_n318 : primitive_n_n315; // u36f0
    wire primitive_n_n320 = primitive_n_places[1]; // u1f0
    wire [33:0] primitive_n_n321 = primitive_n_n319[33:0]; // u34f0
    wire [35:0] primitive_n_n322 = {primitive_n_n321, primitive_t_n109}; // u36f0
    wire [35:0] primitive_n_n323 = primitive_n_n320 ? primitive_n_n322 : primitive_n_n319; // u36f0
    wire primitive_n_n324 = primitive_n_places[0]; // u1f0
    wire [34:0] primitive_n_n325 = primitive_n_n323[34:0]; // u35f0
    wire [35:0] primitive_n_n326 = {primitive_n_n325, primitive_n34}; // u36f0
    wire [35:0] primitive_n_n335 = primitive_n_n304 ? primitive_n_n334_s4 : primitive_n_n332_s4; // u36f0
    wire [19:0] primitive_n_n336 = primitive_n_n335[19:0]; // u20f0
    wire [35:0] primitive_n_n337 = {primitive_n_n336, primitive_t_n91}; // u36f0
    wire [35:0] primitive_n_n338 = primitive_n_n308 ? primitive_n_n337 : primitive_n_n335; // u36f0
    wire [27:0] primitive_n_n339 = primitive_n_n338[27:0]; // u28f0
    wire [35:0] primitive_n_n340 = {primitive_n_n339, primitive_t_n97}; // u36f0
    wire [35:0] primitive_n_n341 = primitive_n_n312 ? primitive_n_n340 : primitive_n_n338; // u36f0
    wire [31:0] primitive_n_n342 = primitive_n_n341[31:0]; // u32f0
    wire [35:0] primitive_n_n343 = {primitive_n_n342, primitive_t_n103}; // u36f0
    wire [35:0] primitive_n_n344 = primitive_n_n316 ? primitive_n_n343 : primitive_n_n341; // u36f0
    wire [33:0] primitive_n_n345 = primitive_n_n344[33:0]; // u34f0
    wire [35:0] primitive_n_n346 = {primitive_n_n345, primitive_t_n109}; // u36f0
    wire [35:0] primitive_n_n347 = primitive_n_n320 ? primitive_n_n346 : primitive_n_n344; // u36f0
    wire [34:0] primitive_n_n348 = primitive_n_n347[34:0]; // u35f0
    wire [35:0] primitive_n_n349 = {primitive_n_n348, primitive_n34}; // u36f0
    wire [35:0] primitive_n_n358 = primitive_n_n304 ? primitive_n_n357_s4 : primitive_n_n355_s4; // u36f0
    wire [19:0] primitive_n_n359 = primitive_n_n358[19:0]; // u20f0
    wire [35:0] primitive_n_n360 = {primitive_n_n359, primitive_t_n91}; // u36f0
    wire [35:0] primitive_n_n361 = primitive_n_n308 ? primitive_n_n360 : primitive_n_n358; // u36f0
    wire [27:0] primitive_n_n362 = primitive_n_n361[27:0]; // u28f0
    wire [35:0] primitive_n_n363 = {primitive_n_n362, primitive_t_n97}; // u36f0
    wire [35:0] primitive_n_n364 = primitive_n_n312 ? primitive_n_n363 : primitive_n_n361; // u36f0
    wire [31:0] primitive_n_n365 = primitive_n_n364[31:0]; // u32f0
    wire [35:0] primitive_n_n366 = {primitive_n_n365, primitive_t_n103}; // u36f0
    wire [35:0] primitive_n_n367 = primitive_n_n316 ? primitive_n_n366 : primitive_n_n364; // u36f0
    wire [33:0] primitive_n_n368 = primitive_n_n367[33:0]; // u34f0
    wire [35:0] primitive_n_n369 = {primitive_n_n368, primitive_t_n109}; // u36f0
    wire [35:0] primitive_n_n370 = primitive_n_n320 ? primitive_n_n369 : primitive_n_n367; // u36f0
    wire [34:0] primitive_n_n371 = primitive_n_n370[34:0]; // u35f0
    wire [35:0] primitive_n_n372 = {primitive_n_n371, primitive_n34}; // u36f0

    reg signed [1:-14] view_x_s5; // s16f14
    reg signed [1:-14] view_y_s5; // s16f14
    reg signed [1:-14] view_z_s5; // s16f14
    reg signed [1:-14] light0_x_s5; // s16f14
    reg signed [1:-14] light0_y_s5; // s16f14
    reg signed [1:-14] light0_z_s5; // s16f14
    reg primitive_zero_uv_s5; // u1f0
    reg primitive_mirrored_s5; // u1f0
    reg primitive_zero_area_s5; // u1f0
    reg primitive_degenerate_s5; // u1f0
    reg [35:0] primitive_t_n141_s5; // u36f0
    reg primitive_t_n142_s5; // u1f0
    reg [35:0] primitive_t_n144_s5; // u36f0
    reg [35:0] primitive_t_n165_s5; // u36f0
    reg [35:0] primitive_t_n167_s5; // u36f0
    reg [35:0] primitive_t_n188_s5; // u36f0
    reg [35:0] primitive_t_n190_s5; // u36f0
    reg [35:0] primitive_n_n323_s5; // u36f0
    reg primitive_n_n324_s5; // u1f0
    reg [35:0] primitive_n_n326_s5; // u36f0
    reg [35:0] primitive_n_n347_s5; // u36f0
    reg [35:0] primitive_n_n349_s5; // u36f0
    reg [35:0] primitive_n_n370_s5; // u36f0
    reg [35:0] primitive_n_n372_s5; // u36f0
    reg primitive_n447_s5; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s5;
    always @(posedge clk)
        if (rst) valid_s5 <= 1'b0;
        else if (ce) valid_s5 <= valid_s4;

    // ---- stage 5 ----
    // primitive.t
    wire [35:0] primitive_t_n145 = primitive_t_n142_s5 ? primitive_t_n144_s5 : primitive_t_n141_s5; // u36f0
    wire signed [35:0] primitive_t_n146 = primitive_t_n145; // s36f0
    wire signed [0:-35] primitive_t_x = primitive_t_n146; // s36f35
    wire [35:0] primitive_t_n168 = primitive_t_n142_s5 ? primitive_t_n167_s5 : primitive_t_n165_s5; // u36f0
    wire signed [35:0] primitive_t_n169 = primitive_t_n168; // s36f0
    wire signed [0:-35] primitive_t_y = primitive_t_n169; // s36f35
    wire [35:0] primitive_t_n191 = primitive_t_n142_s5 ? primitive_t_n190_s5 : primitive_t_n188_s5; // u36f0
    wire signed [35:0] primitive_t_n192 = primitive_t_n191; // s36f0
    wire signed [0:-35] primitive_t_z = primitive_t_n192; // s36f35
    // primitive
    wire signed [1:-35] primitive_t_norm_x_sum = {primitive_t_x[0], primitive_t_x} + 37'h20000;
    wire signed [1:-17] primitive_t_norm_x_cut = primitive_t_norm_x_sum[1:-17];
    wire primitive_t_norm_x_over = ~primitive_t_norm_x_cut[1] & (|primitive_t_norm_x_cut[0]);
    wire signed [0:-17] primitive_t_norm_x = primitive_t_norm_x_over ? 18'h1ffff : primitive_t_norm_x_cut[0:-17]; // s18f17
    wire signed [1:-35] primitive_t_norm_y_sum = {primitive_t_y[0], primitive_t_y} + 37'h20000;
    wire signed [1:-17] primitive_t_norm_y_cut = primitive_t_norm_y_sum[1:-17];
    wire primitive_t_norm_y_over = ~primitive_t_norm_y_cut[1] & (|primitive_t_norm_y_cut[0]);
    wire signed [0:-17] primitive_t_norm_y = primitive_t_norm_y_over ? 18'h1ffff : primitive_t_norm_y_cut[0:-17]; // s18f17
    wire signed [1:-35] primitive_t_norm_z_sum = {primitive_t_z[0], primitive_t_z} + 37'h20000;
    wire signed [1:-17] primitive_t_norm_z_cut = primitive_t_norm_z_sum[1:-17];
    wire primitive_t_norm_z_over = ~primitive_t_norm_z_cut[1] & (|primitive_t_norm_z_cut[0]);
    wire signed [0:-17] primitive_t_norm_z = primitive_t_norm_z_over ? 18'h1ffff : primitive_t_norm_z_cut[0:-17]; // s18f17
    // primitive.n
    wire [35:0] primitive_n_n327 = primitive_n_n324_s5 ? primitive_n_n326_s5 : primitive_n_n323_s5; // u36f0
    wire signed [35:0] primitive_n_n328 = primitive_n_n327; // s36f0
    wire signed [0:-35] primitive_n_x = primitive_n_n328; // s36f35
    wire [35:0] primitive_n_n350 = primitive_n_n324_s5 ? primitive_n_n349_s5 : primitive_n_n347_s5; // u36f0
    wire signed [35:0] primitive_n_n351 = primitive_n_n350; // s36f0
    wire signed [0:-35] primitive_n_y = primitive_n_n351; // s36f35
    wire [35:0] primitive_n_n373 = primitive_n_n324_s5 ? primitive_n_n372_s5 : primitive_n_n370_s5; // u36f0
    wire signed [35:0] primitive_n_n374 = primitive_n_n373; // s36f0
    wire signed [0:-35] primitive_n_z = primitive_n_n374; // s36f35
    // primitive
    wire signed [1:-35] primitive_n_norm_x_sum = {primitive_n_x[0], primitive_n_x} + 37'h20000;
    wire signed [1:-17] primitive_n_norm_x_cut = primitive_n_norm_x_sum[1:-17];
    wire primitive_n_norm_x_over = ~primitive_n_norm_x_cut[1] & (|primitive_n_norm_x_cut[0]);
    wire signed [0:-17] primitive_n_norm_x = primitive_n_norm_x_over ? 18'h1ffff : primitive_n_norm_x_cut[0:-17]; // s18f17
    wire signed [1:-35] primitive_n_norm_y_sum = {primitive_n_y[0], primitive_n_y} + 37'h20000;
    wire signed [1:-17] primitive_n_norm_y_cut = primitive_n_norm_y_sum[1:-17];
    wire primitive_n_norm_y_over = ~primitive_n_norm_y_cut[1] & (|primitive_n_norm_y_cut[0]);
    wire signed [0:-17] primitive_n_norm_y = primitive_n_norm_y_over ? 18'h1ffff : primitive_n_norm_y_cut[0:-17]; // s18f17
    wire signed [1:-35] primitive_n_norm_z_sum = {primitive_n_z[0], primitive_n_z} + 37'h20000;
    wire signed [1:-17] primitive_n_norm_z_cut = primitive_n_norm_z_sum[1:-17];
    wire primitive_n_norm_z_over = ~primitive_n_norm_z_cut[1] & (|primitive_n_norm_z_cut[0]);
    wire signed [0:-17] primitive_n_norm_z = primitive_n_norm_z_over ? 18'h1ffff : primitive_n_norm_z_cut[0:-17]; // s18f17

    reg signed [1:-14] view_x_s6; // s16f14
    reg signed [1:-14] view_y_s6; // s16f14
    reg signed [1:-14] view_z_s6; // s16f14
    reg signed [1:-14] light0_x_s6; // s16f14
    reg signed [1:-14] light0_y_s6; // s16f14
    reg signed [1:-14] light0_z_s6; // s16f14
    reg primitive_zero_uv_s6; // u1f0
    reg primitive_mirrored_s6; // u1f0
    reg primitive_zero_area_s6; // u1f0
    reg primitive_degenerate_s6; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s6; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s6; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s6; // s18f17
    reg signed [0:-17] primitive_n_norm_x_s6; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s6; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s6; // s18f17
    reg primitive_n447_s6; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s6;
    always @(posedge clk)
        if (rst) valid_s6 <= 1'b0;
        else if (ce) valid_s6 <= valid_s5;

    // ---- stage 6 ----
    // primitive.t_square
    wire signed [1:-34] primitive_t_square_n197 = primitive_t_norm_x_s6 * primitive_t_norm_x_s6; // s36f34
    wire signed [1:-34] primitive_t_square_n198 = primitive_t_norm_y_s6 * primitive_t_norm_y_s6; // s36f34
    wire signed [1:-34] primitive_t_square_n199 = primitive_t_norm_z_s6 * primitive_t_norm_z_s6; // s36f34
    // primitive.n_square
    wire signed [1:-34] primitive_n_square_n379 = primitive_n_norm_x_s6 * primitive_n_norm_x_s6; // s36f34
    wire signed [1:-34] primitive_n_square_n380 = primitive_n_norm_y_s6 * primitive_n_norm_y_s6; // s36f34
    wire signed [1:-34] primitive_n_square_n381 = primitive_n_norm_z_s6 * primitive_n_norm_z_s6; // s36f34

    reg signed [1:-14] view_x_s7; // s16f14
    reg signed [1:-14] view_y_s7; // s16f14
    reg signed [1:-14] view_z_s7; // s16f14
    reg signed [1:-14] light0_x_s7; // s16f14
    reg signed [1:-14] light0_y_s7; // s16f14
    reg signed [1:-14] light0_z_s7; // s16f14
    reg primitive_zero_uv_s7; // u1f0
    reg primitive_mirrored_s7; // u1f0
    reg primitive_zero_area_s7; // u1f0
    reg primitive_degenerate_s7; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s7; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s7; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s7; // s18f17
    reg signed [1:-34] primitive_t_square_n197_s7; // s36f34
    reg signed [1:-34] primitive_t_square_n198_s7; // s36f34
    reg signed [1:-34] primitive_t_square_n199_s7; // s36f34
    reg signed [0:-17] primitive_n_norm_x_s7; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s7; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s7; // s18f17
    reg signed [1:-34] primitive_n_square_n379_s7; // s36f34
    reg signed [1:-34] primitive_n_square_n380_s7; // s36f34
    reg signed [1:-34] primitive_n_square_n381_s7; // s36f34
    reg primitive_n447_s7; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s7;
    always @(posedge clk)
        if (rst) valid_s7 <= 1'b0;
        else if (ce) valid_s7 <= valid_s6;

    // ---- stage 7 ----
    // primitive.t_square
    wire signed [2:-34] primitive_t_square_n200 = {primitive_t_square_n197_s7[1], primitive_t_square_n197_s7} + {primitive_t_square_n198_s7[1], primitive_t_square_n198_s7}; // s37f34
    wire signed [3:-34] primitive_t_square_n201 = {primitive_t_square_n200[2], primitive_t_square_n200} + {{2{primitive_t_square_n199_s7[1]}}, primitive_t_square_n199_s7}; // s38f34
    // primitive.n_square
    wire signed [2:-34] primitive_n_square_n382 = {primitive_n_square_n379_s7[1], primitive_n_square_n379_s7} + {primitive_n_square_n380_s7[1], primitive_n_square_n380_s7}; // s37f34
    wire signed [3:-34] primitive_n_square_n383 = {primitive_n_square_n382[2], primitive_n_square_n382} + {{2{primitive_n_square_n381_s7[1]}}, primitive_n_square_n381_s7}; // s38f34

    reg signed [1:-14] view_x_s8; // s16f14
    reg signed [1:-14] view_y_s8; // s16f14
    reg signed [1:-14] view_z_s8; // s16f14
    reg signed [1:-14] light0_x_s8; // s16f14
    reg signed [1:-14] light0_y_s8; // s16f14
    reg signed [1:-14] light0_z_s8; // s16f14
    reg primitive_zero_uv_s8; // u1f0
    reg primitive_mirrored_s8; // u1f0
    reg primitive_zero_area_s8; // u1f0
    reg primitive_degenerate_s8; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s8; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s8; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s8; // s18f17
    reg signed [3:-34] primitive_t_square_n201_s8; // s38f34
    reg signed [0:-17] primitive_n_norm_x_s8; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s8; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s8; // s18f17
    reg signed [3:-34] primitive_n_square_n383_s8; // s38f34
    reg primitive_n447_s8; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s8;
    always @(posedge clk)
        if (rst) valid_s8 <= 1'b0;
        else if (ce) valid_s8 <= valid_s7;

    // ---- stage 8 ----
    // primitive
    wire signed [4:-34] primitive_t_length_square_sum = {primitive_t_square_n201_s8[3], primitive_t_square_n201_s8} + 39'h2000;
    wire signed [4:-20] primitive_t_length_square_cut = primitive_t_length_square_sum[4:-20];
    wire primitive_t_length_square_over = ~primitive_t_length_square_cut[4] & (|primitive_t_length_square_cut[3:2]);
    wire primitive_t_length_square_under = primitive_t_length_square_cut[4];
    wire [1:-20] primitive_t_length_square = primitive_t_length_square_over ? 22'h3fffff : primitive_t_length_square_under ? 22'h0 : primitive_t_length_square_cut[1:-20]; // u22f20
    // primitive.t_length
    wire [21:0] primitive_t_length_n203 = primitive_t_length_square; // u22f0
    wire [21:0] primitive_t_length_n204 = primitive_t_length_n203; // u22f0
    wire [15:0] primitive_t_length_n205 = primitive_t_length_n204[21:6]; // u16f0
    wire primitive_t_length_n206 = primitive_t_length_n205 == {15'h0, primitive_n34}; // u1f0
    wire [5:0] primitive_t_length_n207 = primitive_t_length_n204[5:0]; // u6f0
    wire [21:0] primitive_t_length_n208 = {primitive_t_length_n207, primitive_t_n91}; // u22f0
    wire [21:0] primitive_t_length_n209 = primitive_t_length_n206 ? primitive_t_length_n208 : primitive_t_length_n204; // u22f0
    wire [7:0] primitive_t_length_n210 = primitive_t_length_n209[21:14]; // u8f0
    wire primitive_t_length_n211 = primitive_t_length_n210 == {7'h0, primitive_n34}; // u1f0
    wire [13:0] primitive_t_length_n212 = primitive_t_length_n209[13:0]; // u14f0
    wire [21:0] primitive_t_length_n213 = {primitive_t_length_n212, primitive_t_n97}; // u22f0
    wire [1:0] primitive_t_length_n225 = {primitive_t_length_n206, primitive_t_length_n211}; // u2f0
    wire primitive_t_length_n245 = primitive_t_length_square == {1'b0, primitive_n34, 20'h0}; // u1f0
    // primitive
    wire signed [4:-34] primitive_n_length_square_sum = {primitive_n_square_n383_s8[3], primitive_n_square_n383_s8} + 39'h2000;
    wire signed [4:-20] primitive_n_length_square_cut = primitive_n_length_square_sum[4:-20];
    wire primitive_n_length_square_over = ~primitive_n_length_square_cut[4] & (|primitive_n_length_square_cut[3:2]);
    wire primitive_n_length_square_under = primitive_n_length_square_cut[4];
    wire [1:-20] primitive_n_length_square = primitive_n_length_square_over ? 22'h3fffff : primitive_n_length_square_under ? 22'h0 : primitive_n_length_square_cut[1:-20]; // u22f20
    // primitive.n_length
    wire [21:0] primitive_n_length_n385 = primitive_n_length_square; // u22f0
    wire [21:0] primitive_n_length_n386 = primitive_n_length_n385; // u22f0
    wire [15:0] primitive_n_length_n387 = primitive_n_length_n386[21:6]; // u16f0
    wire primitive_n_length_n388 = primitive_n_length_n387 == {15'h0, primitive_n34}; // u1f0
    wire [5:0] primitive_n_length_n389 = primitive_n_length_n386[5:0]; // u6f0
    wire [21:0] primitive_n_length_n390 = {primitive_n_length_n389, primitive_t_n91}; // u22f0
    wire [21:0] primitive_n_length_n391 = primitive_n_length_n388 ? primitive_n_length_n390 : primitive_n_length_n386; // u22f0
    wire [7:0] primitive_n_length_n392 = primitive_n_length_n391[21:14]; // u8f0
    wire primitive_n_length_n393 = primitive_n_length_n392 == {7'h0, primitive_n34}; // u1f0
    wire [13:0] primitive_n_length_n394 = primitive_n_length_n391[13:0]; // u14f0
    wire [21:0] primitive_n_length_n395 = {primitive_n_length_n394, primitive_t_n97}; // u22f0
    wire [1:0] primitive_n_length_n407 = {primitive_n_length_n388, primitive_n_length_n393}; // u2f0
    wire primitive_n_length_n425 = primitive_n_length_square == {1'b0, primitive_n34, 20'h0}; // u1f0

    reg signed [1:-14] view_x_s9; // s16f14
    reg signed [1:-14] view_y_s9; // s16f14
    reg signed [1:-14] view_z_s9; // s16f14
    reg signed [1:-14] light0_x_s9; // s16f14
    reg signed [1:-14] light0_y_s9; // s16f14
    reg signed [1:-14] light0_z_s9; // s16f14
    reg primitive_zero_uv_s9; // u1f0
    reg primitive_mirrored_s9; // u1f0
    reg primitive_zero_area_s9; // u1f0
    reg primitive_degenerate_s9; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s9; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s9; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s9; // s18f17
    reg [21:0] primitive_t_length_n209_s9; // u22f0
    reg primitive_t_length_n211_s9; // u1f0
    reg [21:0] primitive_t_length_n213_s9; // u22f0
    reg [1:0] primitive_t_length_n225_s9; // u2f0
    reg primitive_t_length_n245_s9; // u1f0
    reg signed [0:-17] primitive_n_norm_x_s9; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s9; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s9; // s18f17
    reg [21:0] primitive_n_length_n391_s9; // u22f0
    reg primitive_n_length_n393_s9; // u1f0
    reg [21:0] primitive_n_length_n395_s9; // u22f0
    reg [1:0] primitive_n_length_n407_s9; // u2f0
    reg primitive_n_length_n425_s9; // u1f0
    reg primitive_n447_s9; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s9;
    always @(posedge clk)
        if (rst) valid_s9 <= 1'b0;
        else if (ce) valid_s9 <= valid_s8;

    // ---- stage 9 ----
    // primitive.t_length
    wire [21:0] primitive_t_length_n214 = primitive_t_length_n211_s9 ? primitive_t_length_n213_s9 : primitive_t_length_n209_s9; // u22f0
    wire [3:0] primitive_t_length_n215 = primitive_t_length_n214[21:18]; // u4f0
    wire primitive_t_length_n216 = primitive_t_length_n215 == {3'h0, primitive_n34}; // u1f0
    wire [17:0] primitive_t_length_n217 = primitive_t_length_n214[17:0]; // u18f0
    wire [21:0] primitive_t_length_n218 = {primitive_t_length_n217, primitive_t_n103}; // u22f0
    wire [21:0] primitive_t_length_n219 = primitive_t_length_n216 ? primitive_t_length_n218 : primitive_t_length_n214; // u22f0
    wire [1:0] primitive_t_length_n220 = primitive_t_length_n219[21:20]; // u2f0
    wire primitive_t_length_n221 = primitive_t_length_n220 == {1'b0, primitive_n34}; // u1f0
    wire [19:0] primitive_t_length_n222 = primitive_t_length_n219[19:0]; // u20f0
    wire [21:0] primitive_t_length_n223 = {primitive_t_length_n222, primitive_t_n109}; // u22f0
    wire [21:0] primitive_t_length_n224 = primitive_t_length_n221 ? primitive_t_length_n223 : primitive_t_length_n219; // u22f0
    wire [2:0] primitive_t_length_n226 = {primitive_t_length_n225_s9, primitive_t_length_n216}; // u3f0
    wire [3:0] primitive_t_length_n227 = {primitive_t_length_n226, primitive_t_length_n221}; // u4f0
    wire [1:0] primitive_t_length_n228 = primitive_t_length_n224[21:20]; // u2f0
    wire signed [2:0] primitive_t_length_n230 = {1'b0, primitive_t_length_n228} - {2'h0, primitive_t_length_n229}; // s3f0
    wire [1:0] primitive_t_length_n231 = primitive_t_length_n230[1:0]; // u2f0
    wire [17:0] primitive_t_length_n232 = primitive_t_length_n224[19:2]; // u18f0
    wire [19:0] primitive_t_length_n233 = {primitive_t_length_n231, primitive_t_length_n232}; // u20f0
    wire [-1:-20] primitive_t_length_n234 = primitive_t_length_n233; // u20f20
    // primitive.t_length.recip_root
    wire [7:0] primitive_t_length_recip_root_n235 = primitive_t_length_n234[-1:-8]; // u8f0
    wire [11:0] primitive_t_length_recip_root_n238 = primitive_t_length_n234[-9:-20]; // u12f0
    // primitive.n_length
    wire [21:0] primitive_n_length_n396 = primitive_n_length_n393_s9 ? primitive_n_length_n395_s9 : primitive_n_length_n391_s9; // u22f0
    wire [3:0] primitive_n_length_n397 = primitive_n_length_n396[21:18]; // u4f0
    wire primitive_n_length_n398 = primitive_n_length_n397 == {3'h0, primitive_n34}; // u1f0
    wire [17:0] primitive_n_length_n399 = primitive_n_length_n396[17:0]; // u18f0
    wire [21:0] primitive_n_length_n400 = {primitive_n_length_n399, primitive_t_n103}; // u22f0
    wire [21:0] primitive_n_length_n401 = primitive_n_length_n398 ? primitive_n_length_n400 : primitive_n_length_n396; // u22f0
    wire [1:0] primitive_n_length_n402 = primitive_n_length_n401[21:20]; // u2f0
    wire primitive_n_length_n403 = primitive_n_length_n402 == {1'b0, primitive_n34}; // u1f0
    wire [19:0] primitive_n_length_n404 = primitive_n_length_n401[19:0]; // u20f0
    wire [21:0] primitive_n_length_n405 = {primitive_n_length_n404, primitive_t_n109}; // u22f0
    wire [21:0] primitive_n_length_n406 = primitive_n_length_n403 ? primitive_n_length_n405 : primitive_n_length_n401; // u22f0
    wire [2:0] primitive_n_length_n408 = {primitive_n_length_n407_s9, primitive_n_length_n398}; // u3f0
    wire [3:0] primitive_n_length_n409 = {primitive_n_length_n408, primitive_n_length_n403}; // u4f0
    wire [1:0] primitive_n_length_n410 = primitive_n_length_n406[21:20]; // u2f0
    wire signed [2:0] primitive_n_length_n411 = {1'b0, primitive_n_length_n410} - {2'h0, primitive_t_length_n229}; // s3f0
    wire [1:0] primitive_n_length_n412 = primitive_n_length_n411[1:0]; // u2f0
    wire [17:0] primitive_n_length_n413 = primitive_n_length_n406[19:2]; // u18f0
    wire [19:0] primitive_n_length_n414 = {primitive_n_length_n412, primitive_n_length_n413}; // u20f0
    wire [-1:-20] primitive_n_length_n415 = primitive_n_length_n414; // u20f20
    // primitive.n_length.recip_root
    wire [7:0] primitive_n_length_recip_root_n416 = primitive_n_length_n415[-1:-8]; // u8f0
    wire [11:0] primitive_n_length_recip_root_n419 = primitive_n_length_n415[-9:-20]; // u12f0

    reg signed [1:-14] view_x_s10; // s16f14
    reg signed [1:-14] view_y_s10; // s16f14
    reg signed [1:-14] view_z_s10; // s16f14
    reg signed [1:-14] light0_x_s10; // s16f14
    reg signed [1:-14] light0_y_s10; // s16f14
    reg signed [1:-14] light0_z_s10; // s16f14
    reg primitive_zero_uv_s10; // u1f0
    reg primitive_mirrored_s10; // u1f0
    reg primitive_zero_area_s10; // u1f0
    reg primitive_degenerate_s10; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s10; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s10; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s10; // s18f17
    reg [3:0] primitive_t_length_n227_s10; // u4f0
    reg [39:0] recip_root_row;
    reg [11:0] primitive_t_length_recip_root_n238_s10; // u12f0
    reg primitive_t_length_n245_s10; // u1f0
    reg signed [0:-17] primitive_n_norm_x_s10; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s10; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s10; // s18f17
    reg [3:0] primitive_n_length_n409_s10; // u4f0
    reg [39:0] recip_root_row_2;
    reg [11:0] primitive_n_length_recip_root_n419_s10; // u12f0
    reg primitive_n_length_n425_s10; // u1f0
    reg primitive_n447_s10; // u1f0
    always @(posedge clk)
        if (ce) begin
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
            recip_root_row <= recip_root_rom[primitive_t_length_recip_root_n235];
            primitive_t_length_recip_root_n238_s10 <= primitive_t_length_recip_root_n238;
            primitive_t_length_n245_s10 <= primitive_t_length_n245_s9;
            primitive_n_norm_x_s10 <= primitive_n_norm_x_s9;
            primitive_n_norm_y_s10 <= primitive_n_norm_y_s9;
            primitive_n_norm_z_s10 <= primitive_n_norm_z_s9;
            primitive_n_length_n409_s10 <= primitive_n_length_n409;
            recip_root_row_2 <= recip_root_rom[primitive_n_length_recip_root_n416];
            primitive_n_length_recip_root_n419_s10 <= primitive_n_length_recip_root_n419;
            primitive_n_length_n425_s10 <= primitive_n_length_n425_s9;
            primitive_n447_s10 <= primitive_n447_s9;
        end
    reg valid_s10;
    always @(posedge clk)
        if (rst) valid_s10 <= 1'b0;
        else if (ce) valid_s10 <= valid_s9;

    // ---- stage 10 ----
    // primitive.t_length.recip_root
    wire [0:-22] primitive_t_length_recip_root_n236 = recip_root_row[39:17]; // u23f22
    wire signed [-18:-34] primitive_t_length_recip_root_n237 = recip_root_row[16:0]; // s17f34
    // primitive.n_length.recip_root
    wire [0:-22] primitive_n_length_recip_root_n417 = recip_root_row_2[39:17]; // u23f22
    wire signed [-18:-34] primitive_n_length_recip_root_n418 = recip_root_row_2[16:0]; // s17f34

    reg signed [1:-14] view_x_s11; // s16f14
    reg signed [1:-14] view_y_s11; // s16f14
    reg signed [1:-14] view_z_s11; // s16f14
    reg signed [1:-14] light0_x_s11; // s16f14
    reg signed [1:-14] light0_y_s11; // s16f14
    reg signed [1:-14] light0_z_s11; // s16f14
    reg primitive_zero_uv_s11; // u1f0
    reg primitive_mirrored_s11; // u1f0
    reg primitive_zero_area_s11; // u1f0
    reg primitive_degenerate_s11; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s11; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s11; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s11; // s18f17
    reg [3:0] primitive_t_length_n227_s11; // u4f0
    reg [0:-22] primitive_t_length_recip_root_n236_s11; // u23f22
    reg signed [-18:-34] primitive_t_length_recip_root_n237_s11; // s17f34
    reg [11:0] primitive_t_length_recip_root_n238_s11; // u12f0
    reg primitive_t_length_n245_s11; // u1f0
    reg signed [0:-17] primitive_n_norm_x_s11; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s11; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s11; // s18f17
    reg [3:0] primitive_n_length_n409_s11; // u4f0
    reg [0:-22] primitive_n_length_recip_root_n417_s11; // u23f22
    reg signed [-18:-34] primitive_n_length_recip_root_n418_s11; // s17f34
    reg [11:0] primitive_n_length_recip_root_n419_s11; // u12f0
    reg primitive_n_length_n425_s11; // u1f0
    reg primitive_n447_s11; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s11;
    always @(posedge clk)
        if (rst) valid_s11 <= 1'b0;
        else if (ce) valid_s11 <= valid_s10;

    // ---- stage 11 ----
    // primitive.t_length.recip_root
    wire signed [-6:-34] primitive_t_length_recip_root_n239 = primitive_t_length_recip_root_n237_s11 * $signed({1'b0, primitive_t_length_recip_root_n238_s11}); // s29f34
    wire signed [2:-34] primitive_t_length_recip_root_n240 = {2'h0, primitive_t_length_recip_root_n236_s11, 12'h0} + {{8{primitive_t_length_recip_root_n239[-6]}}, primitive_t_length_recip_root_n239}; // s37f34
    // primitive.n_length.recip_root
    wire signed [-6:-34] primitive_n_length_recip_root_n420 = primitive_n_length_recip_root_n418_s11 * $signed({1'b0, primitive_n_length_recip_root_n419_s11}); // s29f34
    wire signed [2:-34] primitive_n_length_recip_root_n421 = {2'h0, primitive_n_length_recip_root_n417_s11, 12'h0} + {{8{primitive_n_length_recip_root_n420[-6]}}, primitive_n_length_recip_root_n420}; // s37f34

    reg signed [1:-14] view_x_s12; // s16f14
    reg signed [1:-14] view_y_s12; // s16f14
    reg signed [1:-14] view_z_s12; // s16f14
    reg signed [1:-14] light0_x_s12; // s16f14
    reg signed [1:-14] light0_y_s12; // s16f14
    reg signed [1:-14] light0_z_s12; // s16f14
    reg primitive_zero_uv_s12; // u1f0
    reg primitive_mirrored_s12; // u1f0
    reg primitive_zero_area_s12; // u1f0
    reg primitive_degenerate_s12; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s12; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s12; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s12; // s18f17
    reg [3:0] primitive_t_length_n227_s12; // u4f0
    reg signed [2:-34] primitive_t_length_recip_root_n240_s12; // s37f34
    reg primitive_t_length_n245_s12; // u1f0
    reg signed [0:-17] primitive_n_norm_x_s12; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s12; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s12; // s18f17
    reg [3:0] primitive_n_length_n409_s12; // u4f0
    reg signed [2:-34] primitive_n_length_recip_root_n421_s12; // s37f34
    reg primitive_n_length_n425_s12; // u1f0
    reg primitive_n447_s12; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s12;
    always @(posedge clk)
        if (rst) valid_s12 <= 1'b0;
        else if (ce) valid_s12 <= valid_s11;

    // ---- stage 12 ----
    // primitive.t_length.recip_root
    wire signed [3:-34] primitive_t_length_recip_root_n241_sum = {primitive_t_length_recip_root_n240_s12[2], primitive_t_length_recip_root_n240_s12} + 38'h2000;
    wire signed [3:-20] primitive_t_length_recip_root_n241_cut = primitive_t_length_recip_root_n241_sum[3:-20];
    wire primitive_t_length_recip_root_n241_over = ~primitive_t_length_recip_root_n241_cut[3] & (|primitive_t_length_recip_root_n241_cut[2]);
    wire primitive_t_length_recip_root_n241_under = primitive_t_length_recip_root_n241_cut[3];
    wire [1:-20] primitive_t_length_recip_root_n241 = primitive_t_length_recip_root_n241_over ? 22'h3fffff : primitive_t_length_recip_root_n241_under ? 22'h0 : primitive_t_length_recip_root_n241_cut[1:-20]; // u22f20
    // primitive.t_length
    wire primitive_t_length_n242_past = 4'hb < primitive_t_length_n227_s12;
    wire [3:0] primitive_t_length_n242_count = primitive_t_length_n242_past ? 4'hb : primitive_t_length_n227_s12;
    wire [12:-20] primitive_t_length_n242 = {11'h0, primitive_t_length_recip_root_n241} << primitive_t_length_n242_count; // u33f20
    wire [11:-21] primitive_t_length_n243 = primitive_t_length_n242; // u33f21
    wire [11:-21] primitive_t_length_n246 = primitive_t_length_n245_s12 ? {9'h0, primitive_t_length_n244, 23'h0} : primitive_t_length_n243; // u33f21
    // primitive.n_length.recip_root
    wire signed [3:-34] primitive_n_length_recip_root_n422_sum = {primitive_n_length_recip_root_n421_s12[2], primitive_n_length_recip_root_n421_s12} + 38'h2000;
    wire signed [3:-20] primitive_n_length_recip_root_n422_cut = primitive_n_length_recip_root_n422_sum[3:-20];
    wire primitive_n_length_recip_root_n422_over = ~primitive_n_length_recip_root_n422_cut[3] & (|primitive_n_length_recip_root_n422_cut[2]);
    wire primitive_n_length_recip_root_n422_under = primitive_n_length_recip_root_n422_cut[3];
    wire [1:-20] primitive_n_length_recip_root_n422 = primitive_n_length_recip_root_n422_over ? 22'h3fffff : primitive_n_length_recip_root_n422_under ? 22'h0 : primitive_n_length_recip_root_n422_cut[1:-20]; // u22f20
    // primitive.n_length
    wire primitive_n_length_n423_past = 4'hb < primitive_n_length_n409_s12;
    wire [3:0] primitive_n_length_n423_count = primitive_n_length_n423_past ? 4'hb : primitive_n_length_n409_s12;
    wire [12:-20] primitive_n_length_n423 = {11'h0, primitive_n_length_recip_root_n422} << primitive_n_length_n423_count; // u33f20
    wire [11:-21] primitive_n_length_n424 = primitive_n_length_n423; // u33f21
    wire [11:-21] primitive_n_length_n426 = primitive_n_length_n425_s12 ? {9'h0, primitive_t_length_n244, 23'h0} : primitive_n_length_n424; // u33f21

    reg signed [1:-14] view_x_s13; // s16f14
    reg signed [1:-14] view_y_s13; // s16f14
    reg signed [1:-14] view_z_s13; // s16f14
    reg signed [1:-14] light0_x_s13; // s16f14
    reg signed [1:-14] light0_y_s13; // s16f14
    reg signed [1:-14] light0_z_s13; // s16f14
    reg primitive_zero_uv_s13; // u1f0
    reg primitive_mirrored_s13; // u1f0
    reg primitive_zero_area_s13; // u1f0
    reg primitive_degenerate_s13; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s13; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s13; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s13; // s18f17
    reg [11:-21] primitive_t_length_n246_s13; // u33f21
    reg signed [0:-17] primitive_n_norm_x_s13; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s13; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s13; // s18f17
    reg [11:-21] primitive_n_length_n426_s13; // u33f21
    reg primitive_n447_s13; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s13;
    always @(posedge clk)
        if (rst) valid_s13 <= 1'b0;
        else if (ce) valid_s13 <= valid_s12;

    // ---- stage 13 ----
    // primitive.t_length
    wire [12:-21] primitive_t_length_t_length_sum = {1'b0, primitive_t_length_n246_s13} + 34'h4;
    wire [12:-18] primitive_t_length_t_length_cut = primitive_t_length_t_length_sum[12:-18];
    wire primitive_t_length_t_length_over = |primitive_t_length_t_length_cut[12:2];
    wire [1:-18] primitive_t_length_t_length = primitive_t_length_t_length_over ? 20'hfffff : primitive_t_length_t_length_cut[1:-18]; // u20f18
    // primitive.n_length
    wire [12:-21] primitive_n_length_n_length_sum = {1'b0, primitive_n_length_n426_s13} + 34'h4;
    wire [12:-18] primitive_n_length_n_length_cut = primitive_n_length_n_length_sum[12:-18];
    wire primitive_n_length_n_length_over = |primitive_n_length_n_length_cut[12:2];
    wire [1:-18] primitive_n_length_n_length = primitive_n_length_n_length_over ? 20'hfffff : primitive_n_length_n_length_cut[1:-18]; // u20f18

    reg signed [1:-14] view_x_s14; // s16f14
    reg signed [1:-14] view_y_s14; // s16f14
    reg signed [1:-14] view_z_s14; // s16f14
    reg signed [1:-14] light0_x_s14; // s16f14
    reg signed [1:-14] light0_y_s14; // s16f14
    reg signed [1:-14] light0_z_s14; // s16f14
    reg primitive_zero_uv_s14; // u1f0
    reg primitive_mirrored_s14; // u1f0
    reg primitive_zero_area_s14; // u1f0
    reg primitive_degenerate_s14; // u1f0
    reg signed [0:-17] primitive_t_norm_x_s14; // s18f17
    reg signed [0:-17] primitive_t_norm_y_s14; // s18f17
    reg signed [0:-17] primitive_t_norm_z_s14; // s18f17
    reg [1:-18] primitive_t_length_t_length_s14; // u20f18
    reg signed [0:-17] primitive_n_norm_x_s14; // s18f17
    reg signed [0:-17] primitive_n_norm_y_s14; // s18f17
    reg signed [0:-17] primitive_n_norm_z_s14; // s18f17
    reg [1:-18] primitive_n_length_n_length_s14; // u20f18
    reg primitive_n447_s14; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s14;
    always @(posedge clk)
        if (rst) valid_s14 <= 1'b0;
        else if (ce) valid_s14 <= valid_s13;

    // ---- stage 14 ----
    // primitive
    wire signed [2:-35] primitive_n248 = primitive_t_norm_x_s14 * $signed({1'b0, primitive_t_length_t_length_s14}); // s38f35
    wire signed [2:-35] primitive_n250 = primitive_t_norm_y_s14 * $signed({1'b0, primitive_t_length_t_length_s14}); // s38f35
    wire signed [2:-35] primitive_n252 = primitive_t_norm_z_s14 * $signed({1'b0, primitive_t_length_t_length_s14}); // s38f35
    wire signed [2:-35] primitive_n428 = primitive_n_norm_x_s14 * $signed({1'b0, primitive_n_length_n_length_s14}); // s38f35
    wire signed [2:-35] primitive_n430 = primitive_n_norm_y_s14 * $signed({1'b0, primitive_n_length_n_length_s14}); // s38f35
    wire signed [2:-35] primitive_n432 = primitive_n_norm_z_s14 * $signed({1'b0, primitive_n_length_n_length_s14}); // s38f35

    reg signed [1:-14] view_x_s15; // s16f14
    reg signed [1:-14] view_y_s15; // s16f14
    reg signed [1:-14] view_z_s15; // s16f14
    reg signed [1:-14] light0_x_s15; // s16f14
    reg signed [1:-14] light0_y_s15; // s16f14
    reg signed [1:-14] light0_z_s15; // s16f14
    reg primitive_zero_uv_s15; // u1f0
    reg primitive_mirrored_s15; // u1f0
    reg primitive_zero_area_s15; // u1f0
    reg primitive_degenerate_s15; // u1f0
    reg signed [2:-35] primitive_n248_s15; // s38f35
    reg signed [2:-35] primitive_n250_s15; // s38f35
    reg signed [2:-35] primitive_n252_s15; // s38f35
    reg signed [2:-35] primitive_n428_s15; // s38f35
    reg signed [2:-35] primitive_n430_s15; // s38f35
    reg signed [2:-35] primitive_n432_s15; // s38f35
    reg primitive_n447_s15; // u1f0
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s15;
    always @(posedge clk)
        if (rst) valid_s15 <= 1'b0;
        else if (ce) valid_s15 <= valid_s14;

    // ---- stage 15 ----
    // primitive
    wire signed [3:-35] primitive_t_unit_x_sum = {primitive_n248_s15[2], primitive_n248_s15} + 39'h40000;
    wire signed [3:-16] primitive_t_unit_x_cut = primitive_t_unit_x_sum[3:-16];
    wire primitive_t_unit_x_over = ~primitive_t_unit_x_cut[3] & (|primitive_t_unit_x_cut[2:1]);
    wire primitive_t_unit_x_under = primitive_t_unit_x_cut[3] & ~(&primitive_t_unit_x_cut[2:1]);
    wire signed [1:-16] primitive_t_unit_x = primitive_t_unit_x_over ? 18'h1ffff : primitive_t_unit_x_under ? 18'h20000 : primitive_t_unit_x_cut[1:-16]; // s18f16
    wire signed [3:-35] primitive_t_unit_y_sum = {primitive_n250_s15[2], primitive_n250_s15} + 39'h40000;
    wire signed [3:-16] primitive_t_unit_y_cut = primitive_t_unit_y_sum[3:-16];
    wire primitive_t_unit_y_over = ~primitive_t_unit_y_cut[3] & (|primitive_t_unit_y_cut[2:1]);
    wire primitive_t_unit_y_under = primitive_t_unit_y_cut[3] & ~(&primitive_t_unit_y_cut[2:1]);
    wire signed [1:-16] primitive_t_unit_y = primitive_t_unit_y_over ? 18'h1ffff : primitive_t_unit_y_under ? 18'h20000 : primitive_t_unit_y_cut[1:-16]; // s18f16
    wire signed [3:-35] primitive_t_unit_z_sum = {primitive_n252_s15[2], primitive_n252_s15} + 39'h40000;
    wire signed [3:-16] primitive_t_unit_z_cut = primitive_t_unit_z_sum[3:-16];
    wire primitive_t_unit_z_over = ~primitive_t_unit_z_cut[3] & (|primitive_t_unit_z_cut[2:1]);
    wire primitive_t_unit_z_under = primitive_t_unit_z_cut[3] & ~(&primitive_t_unit_z_cut[2:1]);
    wire signed [1:-16] primitive_t_unit_z = primitive_t_unit_z_over ? 18'h1ffff : primitive_t_unit_z_under ? 18'h20000 : primitive_t_unit_z_cut[1:-16]; // s18f16
    wire signed [3:-35] primitive_n_unit_x_sum = {primitive_n428_s15[2], primitive_n428_s15} + 39'h40000;
    wire signed [3:-16] primitive_n_unit_x_cut = primitive_n_unit_x_sum[3:-16];
    wire primitive_n_unit_x_over = ~primitive_n_unit_x_cut[3] & (|primitive_n_unit_x_cut[2:1]);
    wire primitive_n_unit_x_under = primitive_n_unit_x_cut[3] & ~(&primitive_n_unit_x_cut[2:1]);
    wire signed [1:-16] primitive_n_unit_x = primitive_n_unit_x_over ? 18'h1ffff : primitive_n_unit_x_under ? 18'h20000 : primitive_n_unit_x_cut[1:-16]; // s18f16
    wire signed [3:-35] primitive_n_unit_y_sum = {primitive_n430_s15[2], primitive_n430_s15} + 39'h40000;
    wire signed [3:-16] primitive_n_unit_y_cut = primitive_n_unit_y_sum[3:-16];
    wire primitive_n_unit_y_over = ~primitive_n_unit_y_cut[3] & (|primitive_n_unit_y_cut[2:1]);
    wire primitive_n_unit_y_under = primitive_n_unit_y_cut[3] & ~(&primitive_n_unit_y_cut[2:1]);
    wire signed [1:-16] primitive_n_unit_y = primitive_n_unit_y_over ? 18'h1ffff : primitive_n_unit_y_under ? 18'h20000 : primitive_n_unit_y_cut[1:-16]; // s18f16
    wire signed [3:-35] primitive_n_unit_z_sum = {primitive_n432_s15[2], primitive_n432_s15} + 39'h40000;
    wire signed [3:-16] primitive_n_unit_z_cut = primitive_n_unit_z_sum[3:-16];
    wire primitive_n_unit_z_over = ~primitive_n_unit_z_cut[3] & (|primitive_n_unit_z_cut[2:1]);
    wire primitive_n_unit_z_under = primitive_n_unit_z_cut[3] & ~(&primitive_n_unit_z_cut[2:1]);
    wire signed [1:-16] primitive_n_unit_z = primitive_n_unit_z_over ? 18'h1ffff : primitive_n_unit_z_under ? 18'h20000 : primitive_n_unit_z_cut[1:-16]; // s18f16
    wire signed [2:-16] primitive_n448 = -{primitive_t_unit_x[1], primitive_t_unit_x}; // s19f16
    wire signed [2:-16] primitive_n449 = primitive_n447_s15 ? primitive_n448 : {primitive_t_unit_x[1], primitive_t_unit_x}; // s19f16
    wire primitive_n450_over = ~primitive_n449[2] & (|primitive_n449[1]);
    wire primitive_n450_under = primitive_n449[2] & ~(&primitive_n449[1]);
    wire signed [1:-16] primitive_n450 = primitive_n450_over ? 18'h1ffff : primitive_n450_under ? 18'h20000 : primitive_n449[1:-16]; // s18f16
    wire signed [2:-16] primitive_n451 = -{primitive_t_unit_y[1], primitive_t_unit_y}; // s19f16
    wire signed [2:-16] primitive_n452 = primitive_n447_s15 ? primitive_n451 : {primitive_t_unit_y[1], primitive_t_unit_y}; // s19f16
    wire primitive_n453_over = ~primitive_n452[2] & (|primitive_n452[1]);
    wire primitive_n453_under = primitive_n452[2] & ~(&primitive_n452[1]);
    wire signed [1:-16] primitive_n453 = primitive_n453_over ? 18'h1ffff : primitive_n453_under ? 18'h20000 : primitive_n452[1:-16]; // s18f16
    wire signed [2:-16] primitive_n454 = -{primitive_t_unit_z[1], primitive_t_unit_z}; // s19f16
    wire signed [2:-16] primitive_n455 = primitive_n447_s15 ? primitive_n454 : {primitive_t_unit_z[1], primitive_t_unit_z}; // s19f16
    wire primitive_n456_over = ~primitive_n455[2] & (|primitive_n455[1]);
    wire primitive_n456_under = primitive_n455[2] & ~(&primitive_n455[1]);
    wire signed [1:-16] primitive_n456 = primitive_n456_over ? 18'h1ffff : primitive_n456_under ? 18'h20000 : primitive_n455[1:-16]; // s18f16

    reg signed [1:-14] view_x_s16; // s16f14
    reg signed [1:-14] view_y_s16; // s16f14
    reg signed [1:-14] view_z_s16; // s16f14
    reg signed [1:-14] light0_x_s16; // s16f14
    reg signed [1:-14] light0_y_s16; // s16f14
    reg signed [1:-14] light0_z_s16; // s16f14
    reg primitive_zero_uv_s16; // u1f0
    reg primitive_mirrored_s16; // u1f0
    reg primitive_zero_area_s16; // u1f0
    reg primitive_degenerate_s16; // u1f0
    reg signed [1:-16] primitive_t_unit_x_s16; // s18f16
    reg signed [1:-16] primitive_t_unit_y_s16; // s18f16
    reg signed [1:-16] primitive_t_unit_z_s16; // s18f16
    reg signed [1:-16] primitive_n_unit_x_s16; // s18f16
    reg signed [1:-16] primitive_n_unit_y_s16; // s18f16
    reg signed [1:-16] primitive_n_unit_z_s16; // s18f16
    reg signed [1:-16] primitive_n450_s16; // s18f16
    reg signed [1:-16] primitive_n453_s16; // s18f16
    reg signed [1:-16] primitive_n456_s16; // s18f16
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s16;
    always @(posedge clk)
        if (rst) valid_s16 <= 1'b0;
        else if (ce) valid_s16 <= valid_s15;

    // ---- stage 16 ----
    // primitive.n_cross_t
    wire signed [3:-32] primitive_n_cross_t_n434 = primitive_n_unit_y_s16 * primitive_t_unit_z_s16; // s36f32
    wire signed [3:-32] primitive_n_cross_t_n435 = primitive_n_unit_z_s16 * primitive_t_unit_y_s16; // s36f32
    wire signed [3:-32] primitive_n_cross_t_n437 = primitive_n_unit_z_s16 * primitive_t_unit_x_s16; // s36f32
    wire signed [3:-32] primitive_n_cross_t_n438 = primitive_n_unit_x_s16 * primitive_t_unit_z_s16; // s36f32
    wire signed [3:-32] primitive_n_cross_t_n440 = primitive_n_unit_x_s16 * primitive_t_unit_y_s16; // s36f32
    wire signed [3:-32] primitive_n_cross_t_n441 = primitive_n_unit_y_s16 * primitive_t_unit_x_s16; // s36f32
    // vertex.ts_view_t
    wire signed [3:-30] vertex_ts_view_t_n457 = primitive_n450_s16 * view_x_s16; // s34f30
    wire signed [3:-30] vertex_ts_view_t_n458 = primitive_n453_s16 * view_y_s16; // s34f30
    wire signed [3:-30] vertex_ts_view_t_n459 = primitive_n456_s16 * view_z_s16; // s34f30
    // vertex.ts_view_n
    wire signed [3:-30] vertex_ts_view_n_n469 = primitive_n_unit_x_s16 * view_x_s16; // s34f30
    wire signed [3:-30] vertex_ts_view_n_n470 = primitive_n_unit_y_s16 * view_y_s16; // s34f30
    wire signed [3:-30] vertex_ts_view_n_n471 = primitive_n_unit_z_s16 * view_z_s16; // s34f30
    // vertex.ts_light0_t
    wire signed [3:-30] vertex_ts_light0_t_n475 = primitive_n450_s16 * light0_x_s16; // s34f30
    wire signed [3:-30] vertex_ts_light0_t_n476 = primitive_n453_s16 * light0_y_s16; // s34f30
    wire signed [3:-30] vertex_ts_light0_t_n477 = primitive_n456_s16 * light0_z_s16; // s34f30
    // vertex.ts_light0_n
    wire signed [3:-30] vertex_ts_light0_n_n487 = primitive_n_unit_x_s16 * light0_x_s16; // s34f30
    wire signed [3:-30] vertex_ts_light0_n_n488 = primitive_n_unit_y_s16 * light0_y_s16; // s34f30
    wire signed [3:-30] vertex_ts_light0_n_n489 = primitive_n_unit_z_s16 * light0_z_s16; // s34f30

    reg signed [1:-14] view_x_s17; // s16f14
    reg signed [1:-14] view_y_s17; // s16f14
    reg signed [1:-14] view_z_s17; // s16f14
    reg signed [1:-14] light0_x_s17; // s16f14
    reg signed [1:-14] light0_y_s17; // s16f14
    reg signed [1:-14] light0_z_s17; // s16f14
    reg primitive_zero_uv_s17; // u1f0
    reg primitive_mirrored_s17; // u1f0
    reg primitive_zero_area_s17; // u1f0
    reg primitive_degenerate_s17; // u1f0
    reg signed [1:-16] primitive_n_unit_x_s17; // s18f16
    reg signed [1:-16] primitive_n_unit_y_s17; // s18f16
    reg signed [1:-16] primitive_n_unit_z_s17; // s18f16
    reg signed [3:-32] primitive_n_cross_t_n434_s17; // s36f32
    reg signed [3:-32] primitive_n_cross_t_n435_s17; // s36f32
    reg signed [3:-32] primitive_n_cross_t_n437_s17; // s36f32
    reg signed [3:-32] primitive_n_cross_t_n438_s17; // s36f32
    reg signed [3:-32] primitive_n_cross_t_n440_s17; // s36f32
    reg signed [3:-32] primitive_n_cross_t_n441_s17; // s36f32
    reg signed [1:-16] primitive_n450_s17; // s18f16
    reg signed [1:-16] primitive_n453_s17; // s18f16
    reg signed [1:-16] primitive_n456_s17; // s18f16
    reg signed [3:-30] vertex_ts_view_t_n457_s17; // s34f30
    reg signed [3:-30] vertex_ts_view_t_n458_s17; // s34f30
    reg signed [3:-30] vertex_ts_view_t_n459_s17; // s34f30
    reg signed [3:-30] vertex_ts_view_n_n469_s17; // s34f30
    reg signed [3:-30] vertex_ts_view_n_n470_s17; // s34f30
    reg signed [3:-30] vertex_ts_view_n_n471_s17; // s34f30
    reg signed [3:-30] vertex_ts_light0_t_n475_s17; // s34f30
    reg signed [3:-30] vertex_ts_light0_t_n476_s17; // s34f30
    reg signed [3:-30] vertex_ts_light0_t_n477_s17; // s34f30
    reg signed [3:-30] vertex_ts_light0_n_n487_s17; // s34f30
    reg signed [3:-30] vertex_ts_light0_n_n488_s17; // s34f30
    reg signed [3:-30] vertex_ts_light0_n_n489_s17; // s34f30
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s17;
    always @(posedge clk)
        if (rst) valid_s17 <= 1'b0;
        else if (ce) valid_s17 <= valid_s16;

    // ---- stage 17 ----
    // primitive.n_cross_t
    wire signed [4:-32] primitive_n_cross_t_n436 = {primitive_n_cross_t_n434_s17[3], primitive_n_cross_t_n434_s17} - {primitive_n_cross_t_n435_s17[3], primitive_n_cross_t_n435_s17}; // s37f32
    wire signed [4:-32] primitive_n_cross_t_n439 = {primitive_n_cross_t_n437_s17[3], primitive_n_cross_t_n437_s17} - {primitive_n_cross_t_n438_s17[3], primitive_n_cross_t_n438_s17}; // s37f32
    wire signed [4:-32] primitive_n_cross_t_n442 = {primitive_n_cross_t_n440_s17[3], primitive_n_cross_t_n440_s17} - {primitive_n_cross_t_n441_s17[3], primitive_n_cross_t_n441_s17}; // s37f32
    // primitive
    wire signed [5:-32] primitive_n443_sum = {primitive_n_cross_t_n436[4], primitive_n_cross_t_n436} + 38'h8000;
    wire signed [5:-16] primitive_n443_cut = primitive_n443_sum[5:-16];
    wire primitive_n443_over = ~primitive_n443_cut[5] & (|primitive_n443_cut[4:1]);
    wire primitive_n443_under = primitive_n443_cut[5] & ~(&primitive_n443_cut[4:1]);
    wire signed [1:-16] primitive_n443 = primitive_n443_over ? 18'h1ffff : primitive_n443_under ? 18'h20000 : primitive_n443_cut[1:-16]; // s18f16
    wire signed [5:-32] primitive_n444_sum = {primitive_n_cross_t_n439[4], primitive_n_cross_t_n439} + 38'h8000;
    wire signed [5:-16] primitive_n444_cut = primitive_n444_sum[5:-16];
    wire primitive_n444_over = ~primitive_n444_cut[5] & (|primitive_n444_cut[4:1]);
    wire primitive_n444_under = primitive_n444_cut[5] & ~(&primitive_n444_cut[4:1]);
    wire signed [1:-16] primitive_n444 = primitive_n444_over ? 18'h1ffff : primitive_n444_under ? 18'h20000 : primitive_n444_cut[1:-16]; // s18f16
    wire signed [5:-32] primitive_n445_sum = {primitive_n_cross_t_n442[4], primitive_n_cross_t_n442} + 38'h8000;
    wire signed [5:-16] primitive_n445_cut = primitive_n445_sum[5:-16];
    wire primitive_n445_over = ~primitive_n445_cut[5] & (|primitive_n445_cut[4:1]);
    wire primitive_n445_under = primitive_n445_cut[5] & ~(&primitive_n445_cut[4:1]);
    wire signed [1:-16] primitive_n445 = primitive_n445_over ? 18'h1ffff : primitive_n445_under ? 18'h20000 : primitive_n445_cut[1:-16]; // s18f16
    // vertex.ts_view_t
    wire signed [4:-30] vertex_ts_view_t_n460 = {vertex_ts_view_t_n457_s17[3], vertex_ts_view_t_n457_s17} + {vertex_ts_view_t_n458_s17[3], vertex_ts_view_t_n458_s17}; // s35f30
    wire signed [5:-30] vertex_ts_view_t_n461 = {vertex_ts_view_t_n460[4], vertex_ts_view_t_n460} + {{2{vertex_ts_view_t_n459_s17[3]}}, vertex_ts_view_t_n459_s17}; // s36f30
    // vertex.ts_view_n
    wire signed [4:-30] vertex_ts_view_n_n472 = {vertex_ts_view_n_n469_s17[3], vertex_ts_view_n_n469_s17} + {vertex_ts_view_n_n470_s17[3], vertex_ts_view_n_n470_s17}; // s35f30
    wire signed [5:-30] vertex_ts_view_n_n473 = {vertex_ts_view_n_n472[4], vertex_ts_view_n_n472} + {{2{vertex_ts_view_n_n471_s17[3]}}, vertex_ts_view_n_n471_s17}; // s36f30
    // vertex.ts_light0_t
    wire signed [4:-30] vertex_ts_light0_t_n478 = {vertex_ts_light0_t_n475_s17[3], vertex_ts_light0_t_n475_s17} + {vertex_ts_light0_t_n476_s17[3], vertex_ts_light0_t_n476_s17}; // s35f30
    wire signed [5:-30] vertex_ts_light0_t_n479 = {vertex_ts_light0_t_n478[4], vertex_ts_light0_t_n478} + {{2{vertex_ts_light0_t_n477_s17[3]}}, vertex_ts_light0_t_n477_s17}; // s36f30
    // vertex.ts_light0_n
    wire signed [4:-30] vertex_ts_light0_n_n490 = {vertex_ts_light0_n_n487_s17[3], vertex_ts_light0_n_n487_s17} + {vertex_ts_light0_n_n488_s17[3], vertex_ts_light0_n_n488_s17}; // s35f30
    wire signed [5:-30] vertex_ts_light0_n_n491 = {vertex_ts_light0_n_n490[4], vertex_ts_light0_n_n490} + {{2{vertex_ts_light0_n_n489_s17[3]}}, vertex_ts_light0_n_n489_s17}; // s36f30

    reg signed [1:-14] view_x_s18; // s16f14
    reg signed [1:-14] view_y_s18; // s16f14
    reg signed [1:-14] view_z_s18; // s16f14
    reg signed [1:-14] light0_x_s18; // s16f14
    reg signed [1:-14] light0_y_s18; // s16f14
    reg signed [1:-14] light0_z_s18; // s16f14
    reg primitive_zero_uv_s18; // u1f0
    reg primitive_mirrored_s18; // u1f0
    reg primitive_zero_area_s18; // u1f0
    reg primitive_degenerate_s18; // u1f0
    reg signed [1:-16] primitive_n_unit_x_s18; // s18f16
    reg signed [1:-16] primitive_n_unit_y_s18; // s18f16
    reg signed [1:-16] primitive_n_unit_z_s18; // s18f16
    reg signed [1:-16] primitive_n443_s18; // s18f16
    reg signed [1:-16] primitive_n444_s18; // s18f16
    reg signed [1:-16] primitive_n445_s18; // s18f16
    reg signed [1:-16] primitive_n450_s18; // s18f16
    reg signed [1:-16] primitive_n453_s18; // s18f16
    reg signed [1:-16] primitive_n456_s18; // s18f16
    reg signed [5:-30] vertex_ts_view_t_n461_s18; // s36f30
    reg signed [5:-30] vertex_ts_view_n_n473_s18; // s36f30
    reg signed [5:-30] vertex_ts_light0_t_n479_s18; // s36f30
    reg signed [5:-30] vertex_ts_light0_n_n491_s18; // s36f30
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s18;
    always @(posedge clk)
        if (rst) valid_s18 <= 1'b0;
        else if (ce) valid_s18 <= valid_s17;

    // ---- stage 18 ----
    // vertex
    wire signed [6:-30] vertex_ts_view_x_sum = {vertex_ts_view_t_n461_s18[5], vertex_ts_view_t_n461_s18} + 37'h8000;
    wire signed [6:-14] vertex_ts_view_x_cut = vertex_ts_view_x_sum[6:-14];
    wire vertex_ts_view_x_over = ~vertex_ts_view_x_cut[6] & (|vertex_ts_view_x_cut[5:2]);
    wire vertex_ts_view_x_under = vertex_ts_view_x_cut[6] & ~(&vertex_ts_view_x_cut[5:2]);
    wire signed [2:-14] vertex_ts_view_x = vertex_ts_view_x_over ? 17'hffff : vertex_ts_view_x_under ? 17'h10000 : vertex_ts_view_x_cut[2:-14]; // s17f14
    // vertex.ts_view_b
    wire signed [3:-30] vertex_ts_view_b_n463 = primitive_n443_s18 * view_x_s18; // s34f30
    wire signed [3:-30] vertex_ts_view_b_n464 = primitive_n444_s18 * view_y_s18; // s34f30
    wire signed [3:-30] vertex_ts_view_b_n465 = primitive_n445_s18 * view_z_s18; // s34f30
    // vertex
    wire signed [6:-30] vertex_ts_view_z_sum = {vertex_ts_view_n_n473_s18[5], vertex_ts_view_n_n473_s18} + 37'h8000;
    wire signed [6:-14] vertex_ts_view_z_cut = vertex_ts_view_z_sum[6:-14];
    wire vertex_ts_view_z_over = ~vertex_ts_view_z_cut[6] & (|vertex_ts_view_z_cut[5:2]);
    wire vertex_ts_view_z_under = vertex_ts_view_z_cut[6] & ~(&vertex_ts_view_z_cut[5:2]);
    wire signed [2:-14] vertex_ts_view_z = vertex_ts_view_z_over ? 17'hffff : vertex_ts_view_z_under ? 17'h10000 : vertex_ts_view_z_cut[2:-14]; // s17f14
    wire signed [6:-30] vertex_ts_light0_x_sum = {vertex_ts_light0_t_n479_s18[5], vertex_ts_light0_t_n479_s18} + 37'h8000;
    wire signed [6:-14] vertex_ts_light0_x_cut = vertex_ts_light0_x_sum[6:-14];
    wire vertex_ts_light0_x_over = ~vertex_ts_light0_x_cut[6] & (|vertex_ts_light0_x_cut[5:2]);
    wire vertex_ts_light0_x_under = vertex_ts_light0_x_cut[6] & ~(&vertex_ts_light0_x_cut[5:2]);
    wire signed [2:-14] vertex_ts_light0_x = vertex_ts_light0_x_over ? 17'hffff : vertex_ts_light0_x_under ? 17'h10000 : vertex_ts_light0_x_cut[2:-14]; // s17f14
    // vertex.ts_light0_b
    wire signed [3:-30] vertex_ts_light0_b_n481 = primitive_n443_s18 * light0_x_s18; // s34f30
    wire signed [3:-30] vertex_ts_light0_b_n482 = primitive_n444_s18 * light0_y_s18; // s34f30
    wire signed [3:-30] vertex_ts_light0_b_n483 = primitive_n445_s18 * light0_z_s18; // s34f30
    // vertex
    wire signed [6:-30] vertex_ts_light0_z_sum = {vertex_ts_light0_n_n491_s18[5], vertex_ts_light0_n_n491_s18} + 37'h8000;
    wire signed [6:-14] vertex_ts_light0_z_cut = vertex_ts_light0_z_sum[6:-14];
    wire vertex_ts_light0_z_over = ~vertex_ts_light0_z_cut[6] & (|vertex_ts_light0_z_cut[5:2]);
    wire vertex_ts_light0_z_under = vertex_ts_light0_z_cut[6] & ~(&vertex_ts_light0_z_cut[5:2]);
    wire signed [2:-14] vertex_ts_light0_z = vertex_ts_light0_z_over ? 17'hffff : vertex_ts_light0_z_under ? 17'h10000 : vertex_ts_light0_z_cut[2:-14]; // s17f14

    reg primitive_zero_uv_s19; // u1f0
    reg primitive_mirrored_s19; // u1f0
    reg primitive_zero_area_s19; // u1f0
    reg primitive_degenerate_s19; // u1f0
    reg signed [1:-16] primitive_n_unit_x_s19; // s18f16
    reg signed [1:-16] primitive_n_unit_y_s19; // s18f16
    reg signed [1:-16] primitive_n_unit_z_s19; // s18f16
    reg signed [1:-16] primitive_n443_s19; // s18f16
    reg signed [1:-16] primitive_n444_s19; // s18f16
    reg signed [1:-16] primitive_n445_s19; // s18f16
    reg signed [1:-16] primitive_n450_s19; // s18f16
    reg signed [1:-16] primitive_n453_s19; // s18f16
    reg signed [1:-16] primitive_n456_s19; // s18f16
    reg signed [2:-14] vertex_ts_view_x_s19; // s17f14
    reg signed [3:-30] vertex_ts_view_b_n463_s19; // s34f30
    reg signed [3:-30] vertex_ts_view_b_n464_s19; // s34f30
    reg signed [3:-30] vertex_ts_view_b_n465_s19; // s34f30
    reg signed [2:-14] vertex_ts_view_z_s19; // s17f14
    reg signed [2:-14] vertex_ts_light0_x_s19; // s17f14
    reg signed [3:-30] vertex_ts_light0_b_n481_s19; // s34f30
    reg signed [3:-30] vertex_ts_light0_b_n482_s19; // s34f30
    reg signed [3:-30] vertex_ts_light0_b_n483_s19; // s34f30
    reg signed [2:-14] vertex_ts_light0_z_s19; // s17f14
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s19;
    always @(posedge clk)
        if (rst) valid_s19 <= 1'b0;
        else if (ce) valid_s19 <= valid_s18;

    // ---- stage 19 ----
    // vertex.ts_view_b
    wire signed [4:-30] vertex_ts_view_b_n466 = {vertex_ts_view_b_n463_s19[3], vertex_ts_view_b_n463_s19} + {vertex_ts_view_b_n464_s19[3], vertex_ts_view_b_n464_s19}; // s35f30
    wire signed [5:-30] vertex_ts_view_b_n467 = {vertex_ts_view_b_n466[4], vertex_ts_view_b_n466} + {{2{vertex_ts_view_b_n465_s19[3]}}, vertex_ts_view_b_n465_s19}; // s36f30
    // vertex.ts_light0_b
    wire signed [4:-30] vertex_ts_light0_b_n484 = {vertex_ts_light0_b_n481_s19[3], vertex_ts_light0_b_n481_s19} + {vertex_ts_light0_b_n482_s19[3], vertex_ts_light0_b_n482_s19}; // s35f30
    wire signed [5:-30] vertex_ts_light0_b_n485 = {vertex_ts_light0_b_n484[4], vertex_ts_light0_b_n484} + {{2{vertex_ts_light0_b_n483_s19[3]}}, vertex_ts_light0_b_n483_s19}; // s36f30

    reg primitive_zero_uv_s20; // u1f0
    reg primitive_mirrored_s20; // u1f0
    reg primitive_zero_area_s20; // u1f0
    reg primitive_degenerate_s20; // u1f0
    reg signed [1:-16] primitive_n_unit_x_s20; // s18f16
    reg signed [1:-16] primitive_n_unit_y_s20; // s18f16
    reg signed [1:-16] primitive_n_unit_z_s20; // s18f16
    reg signed [1:-16] primitive_n443_s20; // s18f16
    reg signed [1:-16] primitive_n444_s20; // s18f16
    reg signed [1:-16] primitive_n445_s20; // s18f16
    reg signed [1:-16] primitive_n450_s20; // s18f16
    reg signed [1:-16] primitive_n453_s20; // s18f16
    reg signed [1:-16] primitive_n456_s20; // s18f16
    reg signed [2:-14] vertex_ts_view_x_s20; // s17f14
    reg signed [5:-30] vertex_ts_view_b_n467_s20; // s36f30
    reg signed [2:-14] vertex_ts_view_z_s20; // s17f14
    reg signed [2:-14] vertex_ts_light0_x_s20; // s17f14
    reg signed [5:-30] vertex_ts_light0_b_n485_s20; // s36f30
    reg signed [2:-14] vertex_ts_light0_z_s20; // s17f14
    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s20;
    always @(posedge clk)
        if (rst) valid_s20 <= 1'b0;
        else if (ce) valid_s20 <= valid_s19;

    // ---- stage 20 ----
    // vertex
    wire signed [6:-30] vertex_ts_view_y_sum = {vertex_ts_view_b_n467_s20[5], vertex_ts_view_b_n467_s20} + 37'h8000;
    wire signed [6:-14] vertex_ts_view_y_cut = vertex_ts_view_y_sum[6:-14];
    wire vertex_ts_view_y_over = ~vertex_ts_view_y_cut[6] & (|vertex_ts_view_y_cut[5:2]);
    wire vertex_ts_view_y_under = vertex_ts_view_y_cut[6] & ~(&vertex_ts_view_y_cut[5:2]);
    wire signed [2:-14] vertex_ts_view_y = vertex_ts_view_y_over ? 17'hffff : vertex_ts_view_y_under ? 17'h10000 : vertex_ts_view_y_cut[2:-14]; // s17f14
    wire signed [6:-30] vertex_ts_light0_y_sum = {vertex_ts_light0_b_n485_s20[5], vertex_ts_light0_b_n485_s20} + 37'h8000;
    wire signed [6:-14] vertex_ts_light0_y_cut = vertex_ts_light0_y_sum[6:-14];
    wire vertex_ts_light0_y_over = ~vertex_ts_light0_y_cut[6] & (|vertex_ts_light0_y_cut[5:2]);
    wire vertex_ts_light0_y_under = vertex_ts_light0_y_cut[6] & ~(&vertex_ts_light0_y_cut[5:2]);
    wire signed [2:-14] vertex_ts_light0_y = vertex_ts_light0_y_over ? 17'hffff : vertex_ts_light0_y_under ? 17'h10000 : vertex_ts_light0_y_cut[2:-14]; // s17f14

    always @(posedge clk)
        if (ce) begin
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
        end
    reg valid_s21;
    always @(posedge clk)
        if (rst) valid_s21 <= 1'b0;
        else if (ce) valid_s21 <= valid_s20;
    assign valid_out = valid_s21;

    // ---- stage 21 ----


    // bits that rounding and cutting drop
    wire unused = &{1'b0,
        primitive_t_n111[33:0],
        primitive_n_n293[33:0],
        primitive_t_norm_x_sum[-18:-35],
        primitive_t_norm_y_sum[-18:-35],
        primitive_t_norm_z_sum[-18:-35],
        primitive_n_norm_x_sum[-18:-35],
        primitive_n_norm_y_sum[-18:-35],
        primitive_n_norm_z_sum[-18:-35],
        primitive_t_length_square_sum[-21:-34],
        primitive_n_length_square_sum[-21:-34],
        primitive_t_length_n224[1:0],
        primitive_t_length_n230[2],
        primitive_n_length_n406[1:0],
        primitive_n_length_n411[2],
        primitive_t_length_recip_root_n241_sum[-21:-34],
        primitive_n_length_recip_root_n422_sum[-21:-34],
        primitive_t_length_t_length_sum[-19:-21],
        primitive_n_length_n_length_sum[-19:-21],
        primitive_t_unit_x_sum[-17:-35],
        primitive_t_unit_y_sum[-17:-35],
        primitive_t_unit_z_sum[-17:-35],
        primitive_n_unit_x_sum[-17:-35],
        primitive_n_unit_y_sum[-17:-35],
        primitive_n_unit_z_sum[-17:-35],
        primitive_n443_sum[-17:-32],
        primitive_n444_sum[-17:-32],
        primitive_n445_sum[-17:-32],
        vertex_ts_view_x_sum[-15:-30],
        vertex_ts_view_z_sum[-15:-30],
        vertex_ts_light0_x_sum[-15:-30],
        vertex_ts_light0_z_sum[-15:-30],
        vertex_ts_view_y_sum[-15:-30],
        vertex_ts_light0_y_sum[-15:-30]};
endmodule
