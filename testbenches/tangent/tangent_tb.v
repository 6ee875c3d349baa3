// tangent: tangent-space set-up of a triangle's vertex: map, view vector and lights in texture space
// made by fixpath 0.1.0; seed 004 (US 7,843,463), with its mirroring rule and facets as printed and mended
//   frame=smooth mirror=handed basis=orthonormal lights=1 position_int_bits=4
//   position_frac_bits=11 uv_int_bits=2 uv_frac_bits=13 component_bits=16 guard_bits=2
//   vector_int_bits=1 vector_bits=16 out_frac_bits=14 norm_bits=18 dot_frac_bits=20
//   root_scheme=linear root_addr_bits=8 root_frac_bits=18 rounding=half-up period_ps=5000
//   stages=auto rom=block
// latency 23 cycles, interval 1 cycle; tables read on the clock
// absolute errors against the golden of the quantised inputs, over 65536 random inputs
// (sampler sphere, seed 1), and the input words of the worst:
//   t_angle: mean 7.20e-6 rad, at most 2.61e-5 rad at p0_x=15251 p0_y=15350 p0_z=-6403 p1_x=15202 p1_y=15167 p1_z=-6192 p2_x=15071 p2_y=15193 p2_z=-6395 uv0_u=-14197 uv0_v=2970 uv1_u=-14234 uv1_v=2895 uv2_u=-14159 uv2_v=2919 normal_x=13003 normal_y=-8017 normal_z=-5922 view_x=3191 view_y=1774 view_z=2175 light0_x=5283 light0_y=93 light0_z=-17561
//   t_dot: mean 1.00e-5, at most 2.89e-5 at p0_x=-11645 p0_y=-1904 p0_z=-1750 p1_x=-10734 p1_y=-2165 p1_z=1162 p2_x=-12461 p2_y=-1923 p2_z=2024 uv0_u=-12788 uv0_v=-12303 uv1_u=-14365 uv1_v=-11692 uv2_u=-12027 uv2_v=-12366 normal_x=2519 normal_y=-14322 normal_z=-7549 view_x=10096 view_y=-7492 view_z=4658 light0_x=-25446 light0_y=15390 light0_z=-2513
//   t_x: mean 5.07e-6, at most 2.61e-5 (1.7 ulp) at p0_x=12681 p0_y=-8661 p0_z=-15254 p1_x=12614 p1_y=-8534 p1_z=-15195 p2_x=13049 p2_y=-8362 p2_z=-15304 uv0_u=-8544 uv0_v=-10722 uv1_u=-8575 uv1_v=-10547 uv2_u=-8420 uv2_v=-10593 normal_x=4752 normal_y=6631 normal_z=-14209 view_x=16853 view_y=4556 view_z=-27578 light0_x=6275 light0_y=6184 light0_z=-12687
//   t_y: mean 5.08e-6, at most 2.39e-5 (1.6 ulp) at p0_x=-11471 p0_y=-17164 p0_z=-702 p1_x=-8731 p1_y=-15121 p1_z=-7650 p2_x=-9498 p2_y=-8321 p2_z=-2970 uv0_u=-5467 uv0_v=-12849 uv1_u=-4684 uv1_v=-17230 uv2_u=-2813 uv2_v=-14893 normal_x=15224 normal_y=-215 normal_z=6051 view_x=-1465 view_y=-15077 view_z=8659 light0_x=6548 light0_y=2005 light0_z=-3929
//   t_z: mean 5.06e-6, at most 2.75e-5 (1.8 ulp) at p0_x=-1067 p0_y=-14384 p0_z=-9320 p1_x=-805 p1_y=-12796 p1_z=-9715 p2_x=177 p2_y=-14033 p2_z=-10866 uv0_u=-9028 uv0_v=-49 uv1_u=-9189 uv1_v=-1 uv2_u=-8820 uv2_v=-231 normal_x=-8534 normal_y=-13930 normal_z=1246 view_x=12601 view_y=-23369 view_z=15762 light0_x=9132 light0_y=1134 light0_z=-151
//   b_angle: mean 6.60e-6 rad, at most 1.93e-5 rad at p0_x=-6919 p0_y=5377 p0_z=-5858 p1_x=-8850 p1_y=7130 p1_z=495 p2_x=-10113 p2_y=12436 p2_z=-5383 uv0_u=8061 uv0_v=477 uv1_u=7764 uv1_v=325 uv2_u=8232 uv2_v=-291 normal_x=6756 normal_y=179 normal_z=-14925 view_x=-1906 view_y=5654 view_z=1238 light0_x=12021 light0_y=19 light0_z=-2035
//   b_dot: mean 8.71e-6, at most 2.35e-5 at p0_x=1541 p0_y=-7123 p0_z=-12331 p1_x=1004 p1_y=-8444 p1_z=-17402 p2_x=6829 p2_y=-19739 p2_z=-17228 uv0_u=11018 uv0_v=14438 uv1_u=11543 uv1_v=14117 uv2_u=11489 uv2_v=13525 normal_x=1690 normal_y=-4795 normal_z=-15575 view_x=3186 view_y=-1039 view_z=-8986 light0_x=9491 light0_y=2629 light0_z=-625
//   b_x: mean 4.44e-6, at most 2.09e-5 (1.4 ulp) at p0_x=16287 p0_y=5533 p0_z=-954 p1_x=16127 p1_y=6048 p1_z=-768 p2_x=16438 p2_y=6155 p2_z=-787 uv0_u=-2207 uv0_v=-10990 uv1_u=-2172 uv1_v=-11023 uv2_u=-2218 uv2_v=-10876 normal_x=2627 normal_y=-13556 normal_z=8818 view_x=-5248 view_y=2691 view_z=-1368 light0_x=2107 light0_y=-206 light0_z=-9224
//   b_y: mean 4.44e-6, at most 2.09e-5 (1.4 ulp) at p0_x=-13793 p0_y=13124 p0_z=-2804 p1_x=-14470 p1_y=13425 p1_z=-2866 p2_x=-14148 p2_y=14455 p2_z=-2185 uv0_u=5808 uv0_v=-12907 uv1_u=6001 uv1_v=-13048 uv2_u=5630 uv2_v=-13325 normal_x=-8483 normal_y=-3604 normal_z=13545 view_x=4479 view_y=5388 view_z=-5064 light0_x=-12346 light0_y=6630 light0_z=-4037
//   b_z: mean 4.40e-6, at most 1.95e-5 (1.3 ulp) at p0_x=14455 p0_y=-2094 p0_z=14638 p1_x=15049 p1_y=-4373 p1_z=11625 p2_x=16897 p2_y=859 p2_z=13234 uv0_u=6478 uv0_v=-2254 uv1_u=7324 uv1_v=-4274 uv2_u=7925 uv2_v=-3433 normal_x=8753 normal_y=-13318 normal_z=3803 view_x=-1720 view_y=3429 view_z=-2002 light0_x=5654 light0_y=1873 light0_z=-2627
//   n_angle: mean 0.00e0 rad, at most 0.00e0 rad at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   n_dot: mean 0.00e0, at most 0.00e0 at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   n_x: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   n_y: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   n_z: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   ts_view_angle: mean 3.91e-5 rad, at most 1.99e-4 rad at p0_x=10316 p0_y=-88 p0_z=-13168 p1_x=11289 p1_y=437 p1_z=-13060 p2_x=10298 p2_y=283 p2_z=-13400 uv0_u=-11949 uv0_v=9482 uv1_u=-12564 uv1_v=9517 uv2_u=-12349 uv2_v=9023 normal_x=-3665 normal_y=-11157 normal_z=11425 view_x=-3378 view_y=-1982 view_z=1539 light0_x=7729 light0_y=-23991 light0_z=-2023
//   ts_view_dot: mean 3.02e-5, at most 7.21e-5 at p0_x=15351 p0_y=11547 p0_z=-1801 p1_x=15661 p1_y=10361 p1_z=-1891 p2_x=15019 p2_y=11851 p2_z=-1061 uv0_u=2653 uv0_v=10234 uv1_u=1447 uv1_v=8903 uv2_u=4032 uv2_v=10091 normal_x=9129 normal_y=9722 normal_z=9517 view_x=-10556 view_y=-3247 view_z=29053 light0_x=6853 light0_y=-17037 light0_z=-628
//   ts_view_x: mean 1.59e-5, at most 6.25e-5 (1.0 ulp) at p0_x=5938 p0_y=4965 p0_z=13846 p1_x=5959 p1_y=4798 p1_z=13561 p2_x=6117 p2_y=4895 p2_z=13497 uv0_u=14829 uv0_v=10601 uv1_u=14843 uv1_v=10549 uv2_u=14823 uv2_v=10606 normal_x=12302 normal_y=-10805 normal_z=587 view_x=-19254 view_y=-15667 view_z=-20847 light0_x=-1743 light0_y=6036 light0_z=13969
//   ts_view_y: mean 1.57e-5, at most 5.67e-5 (0.9 ulp) at p0_x=1195 p0_y=5238 p0_z=-7651 p1_x=1455 p1_y=5417 p1_z=-7765 p2_x=1354 p2_y=5125 p2_z=-7600 uv0_u=-5965 uv0_v=13919 uv1_u=-8415 uv1_v=9980 uv2_u=1311 uv2_v=5511 normal_x=-10544 normal_y=-12520 normal_z=706 view_x=-24812 view_y=17315 view_z=323 light0_x=3543 light0_y=1735 light0_z=3617
//   ts_view_z: mean 1.53e-5, at most 3.05e-5 (0.5 ulp) at p0_x=-10953 p0_y=-12463 p0_z=9164 p1_x=-9156 p1_y=-12517 p1_z=8895 p2_x=-9982 p2_y=-14189 p2_z=12694 uv0_u=1910 uv0_v=11098 uv1_u=1883 uv1_v=12080 uv2_u=1085 uv2_v=12118 normal_x=-1969 normal_y=2018 normal_z=-16140 view_x=-7442 view_y=7163 view_z=-2090 light0_x=3157 light0_y=2999 light0_z=2991
//   ts_light0_angle: mean 3.91e-5 rad, at most 1.91e-4 rad at p0_x=-2293 p0_y=-1363 p0_z=15880 p1_x=-2194 p1_y=-1247 p1_z=15794 p2_x=-2278 p2_y=-1371 p2_z=15927 uv0_u=-1905 uv0_v=-16550 uv1_u=-4916 uv1_v=-15260 uv2_u=4251 uv2_v=-17072 normal_x=13444 normal_y=-5901 normal_z=-7273 view_x=-3580 view_y=-6171 view_z=1568 light0_x=1575 light0_y=-3015 light0_z=-2314
//   ts_light0_dot: mean 3.01e-5, at most 7.40e-5 at p0_x=14762 p0_y=-16010 p0_z=-9702 p1_x=13195 p1_y=-17641 p1_z=-8977 p2_x=13142 p2_y=-14778 p2_z=-6780 uv0_u=4435 uv0_v=10615 uv1_u=4537 uv1_v=10551 uv2_u=4652 uv2_v=10696 normal_x=11187 normal_y=11101 normal_z=4477 view_x=2633 view_y=14256 view_z=938 light0_x=1616 light0_y=16721 light0_z=-26234
//   ts_light0_x: mean 1.59e-5, at most 6.74e-5 (1.1 ulp) at p0_x=14762 p0_y=-16010 p0_z=-9702 p1_x=13195 p1_y=-17641 p1_z=-8977 p2_x=13142 p2_y=-14778 p2_z=-6780 uv0_u=4435 uv0_v=10615 uv1_u=4537 uv1_v=10551 uv2_u=4652 uv2_v=10696 normal_x=11187 normal_y=11101 normal_z=4477 view_x=2633 view_y=14256 view_z=938 light0_x=1616 light0_y=16721 light0_z=-26234
//   ts_light0_y: mean 1.56e-5, at most 5.44e-5 (0.9 ulp) at p0_x=-15148 p0_y=-14335 p0_z=5446 p1_x=-14046 p1_y=-16501 p1_z=6128 p2_x=-14672 p2_y=-14087 p2_z=7534 uv0_u=-18615 uv0_v=15600 uv1_u=-26400 uv1_v=2958 uv2_u=-5648 uv2_v=-2428 normal_x=6096 normal_y=11001 normal_z=10500 view_x=-5487 view_y=-3316 view_z=1969 light0_x=-31632 light0_y=-1147 light0_z=3780
//   ts_light0_z: mean 1.52e-5, at most 3.05e-5 (0.5 ulp) at p0_x=-669 p0_y=7292 p0_z=-12617 p1_x=-931 p1_y=6940 p1_z=-13091 p2_x=-1145 p2_y=6951 p2_z=-12930 uv0_u=-9957 uv0_v=9973 uv1_u=-7782 uv1_v=14959 uv2_u=-10903 uv2_v=14627 normal_x=-631 normal_y=-15129 normal_z=-6258 view_x=-2433 view_y=1277 view_z=4973 light0_x=-3600 light0_y=530 light0_z=9359
//   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   parallel: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 normal_x=-13461 normal_y=8047 normal_z=-4742 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
// stated bound on each tangent: 2.12e-4
// stated bound on each binormal: 5.74e-5
// stated bound on each normal: 0.00e0
// stated bound on each view: 8.14e-4
// stated bound on each light0: 8.14e-4
// stated bound on each flags: 0.00e0
//
// Self-checking testbench of tangent. It reads tangent_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 338 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes tangent_tb.vcd.
module tangent_tb;
    localparam LATENCY = 23;
    localparam VECTORS = 338;
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
    reg signed [1:-14] port_normal_x;
    reg signed [1:-14] port_normal_y;
    reg signed [1:-14] port_normal_z;
    reg signed [1:-14] port_view_x;
    reg signed [1:-14] port_view_y;
    reg signed [1:-14] port_view_z;
    reg signed [1:-14] port_light0_x;
    reg signed [1:-14] port_light0_y;
    reg signed [1:-14] port_light0_z;
    wire signed [2:-16] port_t_x;
    wire signed [2:-16] port_t_y;
    wire signed [2:-16] port_t_z;
    wire signed [1:-16] port_b_x;
    wire signed [1:-16] port_b_y;
    wire signed [1:-16] port_b_z;
    wire signed [1:-14] port_n_x;
    wire signed [1:-14] port_n_y;
    wire signed [1:-14] port_n_z;
    wire signed [4:-14] port_ts_view_x;
    wire signed [4:-14] port_ts_view_y;
    wire signed [4:-14] port_ts_view_z;
    wire signed [4:-14] port_ts_light0_x;
    wire signed [4:-14] port_ts_light0_y;
    wire signed [4:-14] port_ts_light0_z;
    wire port_mirrored;
    wire port_degenerate;
    wire port_zero_uv;
    wire port_zero_area;
    wire port_parallel;

    tangent dut (
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
        .normal_x(port_normal_x),
        .normal_y(port_normal_y),
        .normal_z(port_normal_z),
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
        .zero_area(port_zero_area),
        .parallel(port_parallel)
    );

    // What should come out, moving beside the pipeline; entry 0 belongs to what goes in.
    reg [277:0] expected [0:LATENCY];
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
    reg signed [1:-14] next_normal_x;
    reg signed [1:-14] next_normal_y;
    reg signed [1:-14] next_normal_z;
    reg signed [1:-14] next_view_x;
    reg signed [1:-14] next_view_y;
    reg signed [1:-14] next_view_z;
    reg signed [1:-14] next_light0_x;
    reg signed [1:-14] next_light0_y;
    reg signed [1:-14] next_light0_z;
    reg signed [2:-16] next_t_x;
    reg signed [2:-16] next_t_y;
    reg signed [2:-16] next_t_z;
    reg signed [1:-16] next_b_x;
    reg signed [1:-16] next_b_y;
    reg signed [1:-16] next_b_z;
    reg signed [1:-14] next_n_x;
    reg signed [1:-14] next_n_y;
    reg signed [1:-14] next_n_z;
    reg signed [4:-14] next_ts_view_x;
    reg signed [4:-14] next_ts_view_y;
    reg signed [4:-14] next_ts_view_z;
    reg signed [4:-14] next_ts_light0_x;
    reg signed [4:-14] next_ts_light0_y;
    reg signed [4:-14] next_ts_light0_z;
    reg next_mirrored;
    reg next_degenerate;
    reg next_zero_uv;
    reg next_zero_area;
    reg next_parallel;

    always #5 clk = ~clk;

    initial begin
        if ($test$plusargs("vcd")) begin
            $dumpfile("tangent_tb.vcd");
            $dumpvars(0, tangent_tb);
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
            file = $fopen("tangent_vectors.txt", "r");
            if (file == 0) begin
                $display("FAIL: tangent_vectors.txt can't be read");
                finish_failed;
            end
        end
    endtask

    task read_vector;
        begin
            fields = $fscanf(file, "%h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h %h ", next_p0_x, next_p0_y, next_p0_z, next_p1_x, next_p1_y, next_p1_z, next_p2_x, next_p2_y, next_p2_z, next_uv0_u, next_uv0_v, next_uv1_u, next_uv1_v, next_uv2_u, next_uv2_v, next_normal_x, next_normal_y, next_normal_z, next_view_x, next_view_y, next_view_z, next_light0_x, next_light0_y, next_light0_z, next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_n_x, next_n_y, next_n_z, next_ts_view_x, next_ts_view_y, next_ts_view_z, next_ts_light0_x, next_ts_light0_y, next_ts_light0_z, next_mirrored, next_degenerate, next_zero_uv, next_zero_area, next_parallel);
            more = fields == 44;
            if (!more && fields > 0) begin
                mismatches = mismatches + 1;
                $display("mismatch: tangent_vectors.txt is cut short after vector %0d", sent);
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
                if (port_t_x !== expected[LATENCY][277:259]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][277:259], port_t_x);
                end
                if (port_t_y !== expected[LATENCY][258:240]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][258:240], port_t_y);
                end
                if (port_t_z !== expected[LATENCY][239:221]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d t_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][239:221], port_t_z);
                end
                if (port_b_x !== expected[LATENCY][220:203]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][220:203], port_b_x);
                end
                if (port_b_y !== expected[LATENCY][202:185]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][202:185], port_b_y);
                end
                if (port_b_z !== expected[LATENCY][184:167]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d b_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][184:167], port_b_z);
                end
                if (port_n_x !== expected[LATENCY][166:151]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][166:151], port_n_x);
                end
                if (port_n_y !== expected[LATENCY][150:135]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][150:135], port_n_y);
                end
                if (port_n_z !== expected[LATENCY][134:119]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d n_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][134:119], port_n_z);
                end
                if (port_ts_view_x !== expected[LATENCY][118:100]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][118:100], port_ts_view_x);
                end
                if (port_ts_view_y !== expected[LATENCY][99:81]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][99:81], port_ts_view_y);
                end
                if (port_ts_view_z !== expected[LATENCY][80:62]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_view_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][80:62], port_ts_view_z);
                end
                if (port_ts_light0_x !== expected[LATENCY][61:43]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_x expected %h got %h",
                            number[LATENCY], expected[LATENCY][61:43], port_ts_light0_x);
                end
                if (port_ts_light0_y !== expected[LATENCY][42:24]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_y expected %h got %h",
                            number[LATENCY], expected[LATENCY][42:24], port_ts_light0_y);
                end
                if (port_ts_light0_z !== expected[LATENCY][23:5]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d ts_light0_z expected %h got %h",
                            number[LATENCY], expected[LATENCY][23:5], port_ts_light0_z);
                end
                if (port_mirrored !== expected[LATENCY][4:4]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d mirrored expected %h got %h",
                            number[LATENCY], expected[LATENCY][4:4], port_mirrored);
                end
                if (port_degenerate !== expected[LATENCY][3:3]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d degenerate expected %h got %h",
                            number[LATENCY], expected[LATENCY][3:3], port_degenerate);
                end
                if (port_zero_uv !== expected[LATENCY][2:2]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d zero_uv expected %h got %h",
                            number[LATENCY], expected[LATENCY][2:2], port_zero_uv);
                end
                if (port_zero_area !== expected[LATENCY][1:1]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d zero_area expected %h got %h",
                            number[LATENCY], expected[LATENCY][1:1], port_zero_area);
                end
                if (port_parallel !== expected[LATENCY][0:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= SHOWN)
                        $display("mismatch: vector %0d parallel expected %h got %h",
                            number[LATENCY], expected[LATENCY][0:0], port_parallel);
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
                        expected[0] = {next_t_x, next_t_y, next_t_z, next_b_x, next_b_y, next_b_z, next_n_x, next_n_y, next_n_z, next_ts_view_x, next_ts_view_y, next_ts_view_z, next_ts_light0_x, next_ts_light0_y, next_ts_light0_z, next_mirrored, next_degenerate, next_zero_uv, next_zero_area, next_parallel};
                        number[0] = sent;
                        sent = sent + 1;
                        if (stalls && sent == 338) more = 1'b0;
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
                port_normal_x <= valid[0] ? next_normal_x : 16'bx;
                port_normal_y <= valid[0] ? next_normal_y : 16'bx;
                port_normal_z <= valid[0] ? next_normal_z : 16'bx;
                port_view_x <= valid[0] ? next_view_x : 16'bx;
                port_view_y <= valid[0] ? next_view_y : 16'bx;
                port_view_z <= valid[0] ? next_view_z : 16'bx;
                port_light0_x <= valid[0] ? next_light0_x : 16'bx;
                port_light0_y <= valid[0] ? next_light0_y : 16'bx;
                port_light0_z <= valid[0] ? next_light0_z : 16'bx;
            end
            // A reset in mid-stream, which a stall doesn't hold up: what is on its way is forgotten.
            if (stalls && !reset_done && sent == 338 / 2) begin
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
                $display("mismatch: tangent_vectors.txt holds %0d vectors and should hold %0d", passed, VECTORS);
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
