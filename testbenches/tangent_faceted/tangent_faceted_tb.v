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
//
// Self-checking testbench of tangent_faceted. It reads tangent_faceted_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 311 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes tangent_faceted_tb.vcd.
module tangent_faceted_tb;
    localparam LATENCY = 21;
    localparam VECTORS = 311;
    localparam SHOWN = 10; // of the mismatches

    reg clk = 1'b0;
    reg rst = 1'b1;
    reg ce = 1'b1;
    reg valid_in = 1'b0;
    wire valid_out;
    // No port can have a name that stands here for something else.
    reg signed [4:-11] port_p0_x;
    reg signed [4:-11] port_p0_y;
    reg signed [4:-11] port_p0_z;
    reg signed [4:-11] port_p1_x;
    reg signed [4:-11] port_p1_y;
    reg signed [4:-11] port_p1_z;
    reg signed [4:-11] port_p2_x;
    reg signed [4:-11] port_p2_y;
    reg signed [4:-11] port_p2_z;
    reg signed [2:-13] port_uv0_u;
    reg signed [2:-13] port_uv0_v;
    reg signed [2:-13] port_uv1_u;
    reg signed [2:-13] port_uv1_v;
    reg signed [2:-13] port_uv2_u;
    reg signed [2:-13] port_uv2_v;
    reg signed [1:-14] port_view_x;
    reg signed [1:-14] port_view_y;
    reg signed [1:-14] port_view_z;
    reg signed [1:-14] port_light0_x;
    reg signed [1:-14] port_light0_y;
    reg signed [1:-14] port_light0_z;
    wire signed [1:-16] port_t_x;
    wire signed [1:-16] port_t_y;
    wire signed [1:-16] port_t_z;
    wire signed [1:-16] port_b_x;
    wire signed [1:-16] port_b_y;
    wire signed [1:-16] port_b_z;
    wire signed [1:-16] port_n_x;
    wire signed [1:-16] port_n_y;
    wire signed [1:-16] port_n_z;
    wire signed [2:-14] port_ts_view_x;
    wire signed [2:-14] port_ts_view_y;
    wire signed [2:-14] port_ts_view_z;
    wire signed [2:-14] port_ts_light0_x;
    wire signed [2:-14] port_ts_light0_y;
    wire signed [2:-14] port_ts_light0_z;
    wire port_mirrored;
    wire port_degenerate;
    wire port_zero_uv;
    wire port_zero_area;

    tangent_faceted dut (
        .clk(clk), .rst(rst), .ce(ce),
        .valid_in(valid_in), .valid_out(valid_out),
        .p0_x(port_p0_x),
        .p0_y(port_p0_y),
        .p0_z(port_p0_z),
        .p1_x(port_p1_x),
        .p1_y(port_p1_y),
        .p1_z(port_p1_z),
        .p2_x(port_p2_x),
        .p2_y(port_p2_y),
        .p2_z(port_p2_z),
        .uv0_u(port_uv0_u),
        .uv0_v(port_uv0_v),
        .uv1_u(port_uv1_u),
        .uv1_v(port_uv1_v),
        .uv2_u(port_uv2_u),
        .uv2_v(port_uv2_v),
        .view_x(port_view_x),
        .view_y(port_view_y),
        .view_z(port_view_z),
        .light0_x(port_light0_x),
        .light0_y(port_light0_y),
        .light0_z(port_light0_z),
        .t_x(port_t_x),
        .t_y(port_t_y),
        .t_z(port_t_z),
        .b_x(port_b_x),
        .b_y(port_b_y),
        .b_z(port_b_z),
        .n_x(port_n_x),
        .n_y(port_n_y),
        .n_z(port_n_z),
        .ts_view_x(port_ts_view_x),
        .ts_view_y(port_ts_view_y),
        .ts_view_z(port_ts_view_z),
        .ts_light0_x(port_ts_light0_x),
        .ts_light0_y(port_ts_light0_y),
        .ts_light0_z(port_ts_light0_z),
        .mirrored(port_mirrored),
        .degenerate(port_degenerate),
        .zero_uv(port_zero_uv),
        .zero_area(port_zero_area)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [267:0] expected [0:LATENCY];
    reg valid [0:LATENCY];
    integer number [0:LATENCY];

    integer file, fields, sent, checked, mismatches, passed, i;
    reg more, stalls, reset_done, started;
    reg [31:0] lfsr; // decides on stalls and gaps
    reg signed [4:-11] next_p0_x;
    reg signed [4:-11] next_p0_y;
    reg signed [4:-11] next_p0_z;
    reg signed [4:-11] next_p1_x;
    reg signed [4:-11] next_p1_y;
    reg signed [4:-11] next_p1_z;
    reg signed [4:-11] next_p2_x;
    reg signed [4:-11] next_p2_y;
    reg signed [4:-11] next_p2_z;
    reg signed [2:-13] next_uv0_u;
    reg signed [2:-13] next_uv0_v;
    reg signed [2:-13] next_uv1_u;
    reg signed [2:-13] next_uv1_v;
    reg signed [2:-13] next_uv2_u;
    reg signed [2:-13] next_uv2_v;
    reg signed [1:-14] next_view_x;
    reg signed [1:-14] next_view_y;
    reg signed [1:-14] next_view_z;
    reg signed [1:-14] next_light0_x;
    reg signed [1:-14] next_light0_y;
    reg signed [1:-14] next_light0_z;
    reg signed [1:-16] next_t_x;
    reg signed [1:-16] next_t_y;
    reg signed [1:-16] next_t_z;
    reg signed [1:-16] next_b_x;
    reg signed [1:-16] next_b_y;
    reg signed [1:-16] next_b_z;
    reg signed [1:-16] next_n_x;
    reg signed [1:-16] next_n_y;
    reg signed [1:-16] next_n_z;
    reg signed [2:-14] next_ts_view_x;
    reg signed [2:-14] next_ts_view_y;
    reg signed [2:-14] next_ts_view_z;
    reg signed [2:-14] next_ts_light0_x;
    reg signed [2:-14] next_ts_light0_y;
    reg signed [2:-14] next_ts_light0_z;
    reg next_mirrored;
    reg next_degenerate;
    reg next_zero_uv;
    reg next_zero_area;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("tangent_faceted_tb.vcd");
            $dumpvars(0, tangent_faceted_tb);
        end
        lfsr = 32'h2545f491;
        mismatches = 0;
        passed = 0;
        stalls = 1'b0;
        started = 1'b0; // nothing is known before the first edge under reset
        for (i = 0; i <= LATENCY; i = i + 1) valid[i] = 1'b0;
        open_vectors;
    end

    task finish_failed;
        begin
`ifdef __ICARUS__
            $finish_and_return(1);
`else
            $fatal(0);
`endif
        end
    endtask

    task open_vectors;
        begin
            sent = 0;
            checked = 0;
            more = 1'b1;
            reset_done = 1'b0;
            file = $fopen("tangent_faceted_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: tangent_faceted_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_p0_x, next_p0_y, next_p0_z, next_p1_x, next_p1_y, next_p1_z, next_p2_x, next_p2_y, next_p2_z, next_uv0_u, next_uv0_v, next_uv1_u, next_uv1_v, next_uv2_u, next_uv2_v, next_view_x, next_view_y, next_view_z, next_light0_x, next_light0_y, next_light0_z, next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_n_x, next_n_y, next_n_z, next_ts_view_x, next_ts_view_y, next_ts_view_z, next_ts_light0_x, next_ts_light0_y, next_ts_light0_z, next_mirrored, next_degenerate, next_zero_uv, next_zero_area);
            more = fields == 40;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: tangent_faceted_vectors.txt is cut short after vector %0d", sent);
            end
        end
    endtask

    task check;
        begin
            if (started && valid_out !== valid[LATENCY]) begin
                mismatches = mismatches + 1;
                if (mismatches <= SHOWN)
                    $display("mismatch: vector %0d valid_out expected %b got %b", checked, valid[LATENCY], valid_out);
            end
            // Each word counts once: in the cycle after which the pipeline moves on.
            if (ce && valid[LATENCY]) begin
                if (port_t_x !== expected[LATENCY][267:250]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][267:250], port_t_x);
                end
                if (port_t_y !== expected[LATENCY][249:232]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][249:232], port_t_y);
                end
                if (port_t_z !== expected[LATENCY][231:214]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][231:214], port_t_z);
                end
                if (port_b_x !== expected[LATENCY][213:196]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][213:196], port_b_x);
                end
                if (port_b_y !== expected[LATENCY][195:178]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][195:178], port_b_y);
                end
                if (port_b_z !== expected[LATENCY][177:160]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][177:160], port_b_z);
                end
                if (port_n_x !== expected[LATENCY][159:142]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][159:142], port_n_x);
                end
                if (port_n_y !== expected[LATENCY][141:124]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][141:124], port_n_y);
                end
                if (port_n_z !== expected[LATENCY][123:106]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][123:106], port_n_z);
                end
                if (port_ts_view_x !== expected[LATENCY][105:89]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][105:89], port_ts_view_x);
                end
                if (port_ts_view_y !== expected[LATENCY][88:72]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][88:72], port_ts_view_y);
                end
                if (port_ts_view_z !== expected[LATENCY][71:55]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][71:55], port_ts_view_z);
                end
                if (port_ts_light0_x !== expected[LATENCY][54:38]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][54:38], port_ts_light0_x);
                end
                if (port_ts_light0_y !== expected[LATENCY][37:21]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][37:21], port_ts_light0_y);
                end
                if (port_ts_light0_z !== expected[LATENCY][20:4]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][20:4], port_ts_light0_z);
                end
                if (port_mirrored !== expected[LATENCY][3:3]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d mirrored expected %h got %h",
                            number[LATENCY], expected[LATENCY][3:3], port_mirrored);
                end
                if (port_degenerate !== expected[LATENCY][2:2]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d degenerate expected %h got %h",
                            number[LATENCY], expected[LATENCY][2:2], port_degenerate);
                end
                if (port_zero_uv !== expected[LATENCY][1:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d zero_uv expected %h got %h",
                            number[LATENCY], expected[LATENCY][1:1], port_zero_uv);
                end
                if (port_zero_area !== expected[LATENCY][0:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d zero_area expected %h got %h",
                            number[LATENCY], expected[LATENCY][0:0], port_zero_area);
                end
                checked = checked + 1;
            end
        end
    endtask

    task move_on;
        begin
            for (i = LATENCY; i > 0; i = i - 1) begin
                if (rst) valid[i] = 1'b0;
                else if (ce) valid[i] = valid[i - 1];
                if (ce) expected[i] = expected[i - 1];
                if (ce) number[i] = number[i - 1];
            end
        end
    endtask

    // What goes in after this edge: words stay where the pipeline stood still.
    task drive;
        begin
            lfsr = {lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]};
            rst <= 1'b0;
            ce <= !(stalls && lfsr[2:0] == 3'd0);
            if (ce) begin
                valid[0] = 1'b0;
                if (more && !(stalls && lfsr[5:3] == 3'd0)) begin
                    read_vector;
                    if (more) begin
                        valid[0] = 1'b1;
                        expected[0] = {next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_n_x, next_n_y, next_n_z, next_ts_view_x, next_ts_view_y, next_ts_view_z, next_ts_light0_x, next_ts_light0_y, next_ts_light0_z, next_mirrored, next_degenerate, next_zero_uv, next_zero_area};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 311) more = 1'b0;
                    end
                end
                valid_in <= valid[0];
                port_p0_x <= valid[0] ? next_p0_x : 16'bx;
                port_p0_y <= valid[0] ? next_p0_y : 16'bx;
                port_p0_z <= valid[0] ? next_p0_z : 16'bx;
                port_p1_x <= valid[0] ? next_p1_x : 16'bx;
                port_p1_y <= valid[0] ? next_p1_y : 16'bx;
                port_p1_z <= valid[0] ? next_p1_z : 16'bx;
                port_p2_x <= valid[0] ? next_p2_x : 16'bx;
                port_p2_y <= valid[0] ? next_p2_y : 16'bx;
                port_p2_z <= valid[0] ? next_p2_z : 16'bx;
                port_uv0_u <= valid[0] ? next_uv0_u : 16'bx;
                port_uv0_v <= valid[0] ? next_uv0_v : 16'bx;
                port_uv1_u <= valid[0] ? next_uv1_u : 16'bx;
                port_uv1_v <= valid[0] ? next_uv1_v : 16'bx;
                port_uv2_u <= valid[0] ? next_uv2_u : 16'bx;
                port_uv2_v <= valid[0] ? next_uv2_v : 16'bx;
                port_view_x <= valid[0] ? next_view_x : 16'bx;
                port_view_y <= valid[0] ? next_view_y : 16'bx;
                port_view_z <= valid[0] ? next_view_z : 16'bx;
                port_light0_x <= valid[0] ? next_light0_x : 16'bx;
                port_light0_y <= valid[0] ? next_light0_y : 16'bx;
                port_light0_z <= valid[0] ? next_light0_z : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 311 / 2) begin
                rst <= 1'b1;
                ce <= 1'b0;
                reset_done = 1'b1;
            end
        end
    endtask

    always @(posedge clk) begin
        check;
        if (rst && stalls) begin
            // Forgotten, but for what hasn't gone in yet.
            for (i = 1; i <= LATENCY; i = i + 1) if (valid[i]) checked = checked + 1;
        end
        move_on;
        drive;
        started = 1'b1;
        if (!more && checked == sent) begin
            $fclose(file);
            if (!stalls) begin
                passed = checked;
                stalls = 1'b1;
                open_vectors;
            end else finish;
        end
    end

    task finish;
        begin
            if (passed != VECTORS)
                $display("mismatch: tangent_faceted_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
            if (mismatches == 0 && passed == VECTORS) begin
                $display("PASS %0d vectors", passed);
                $finish(0);
            end else begin
                $display("FAIL %0d mismatches in %0d vectors", mismatches, passed);
                finish_failed;
            end
        end
    endtask
endmodule
