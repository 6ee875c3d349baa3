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
//   t_angle: mean 7.24e-6 rad, at most 2.67e-5 rad at p0_x=6307 p0_y=11776 p0_z=-7782 p1_x=6341 p1_y=11968 p1_z=-7817 p2_x=6303 p2_y=11854 p2_z=-7706 uv0_u=-971 uv0_v=-2351 uv1_u=-1077 uv1_v=-2180 uv2_u=-1109 uv2_v=-2135 normal_x=-12135 normal_y=-10823 normal_z=-2011 view_x=-6407 view_y=614 view_z=1303 light0_x=-3616 light0_y=-12959 light0_z=3429
//   t_dot: mean 1.01e-5, at most 3.30e-5 at p0_x=-8071 p0_y=1654 p0_z=13781 p1_x=-5340 p1_y=4462 p1_z=-15500 p2_x=-2437 p2_y=5463 p2_z=-14212 uv0_u=15328 uv0_v=4201 uv1_u=15061 uv1_v=17215 uv2_u=6582 uv2_v=2726 normal_x=3874 normal_y=11987 normal_z=-10476 view_x=-16397 view_y=6591 view_z=-4081 light0_x=-1241 light0_y=-4126 light0_z=288
//   t_x: mean 5.07e-6, at most 2.71e-5 (1.8 ulp) at p0_x=-168 p0_y=-7474 p0_z=7202 p1_x=14210 p1_y=-12047 p1_z=2517 p2_x=9768 p2_y=-5021 p2_z=2834 uv0_u=2163 uv0_v=-5872 uv1_u=5115 uv1_v=-6789 uv2_u=6787 uv2_v=-4231 normal_x=-3553 normal_y=-14655 normal_z=6406 view_x=-2067 view_y=-3586 view_z=3548 light0_x=-58 light0_y=-17001 light0_z=-1946
//   t_y: mean 5.08e-6, at most 2.61e-5 (1.7 ulp) at p0_x=-2162 p0_y=12802 p0_z=-839 p1_x=-3410 p1_y=13339 p1_z=-254 p2_x=-2991 p2_y=14052 p2_z=-599 uv0_u=2962 uv0_v=2267 uv1_u=3113 uv1_v=2437 uv2_u=3116 uv2_v=2392 normal_x=12588 normal_y=3105 normal_z=-10017 view_x=10626 view_y=-6078 view_z=-8807 light0_x=-9553 light0_y=6888 light0_z=-3770
//   t_z: mean 5.08e-6, at most 2.49e-5 (1.6 ulp) at p0_x=10683 p0_y=-14509 p0_z=9301 p1_x=10695 p1_y=-14457 p1_z=9433 p2_x=10715 p2_y=-14532 p2_z=9414 uv0_u=-1946 uv0_v=8241 uv1_u=-2166 uv1_v=8121 uv2_u=-2145 uv2_v=8259 normal_x=5834 normal_y=-15237 normal_z=-1491 view_x=-2014 view_y=-3928 view_z=-685 light0_x=-21971 light0_y=-5651 light0_z=7739
//   b_angle: mean 6.64e-6 rad, at most 1.92e-5 rad at p0_x=-5491 p0_y=10305 p0_z=10682 p1_x=-4950 p1_y=7772 p1_z=11733 p2_x=-5079 p2_y=8282 p2_z=12040 uv0_u=-8844 uv0_v=-9274 uv1_u=-7243 uv1_v=-10129 uv2_u=-7269 uv2_v=-7621 normal_x=3005 normal_y=-10143 normal_z=12511 view_x=21916 view_y=235 view_z=-23989 light0_x=4624 light0_y=-4372 light0_z=-196
//   b_dot: mean 8.73e-6, at most 2.44e-5 at p0_x=467 p0_y=3555 p0_z=10009 p1_x=49 p1_y=3536 p1_z=10348 p2_x=-7 p2_y=3343 p2_z=9708 uv0_u=2226 uv0_v=14319 uv1_u=2223 uv1_v=14337 uv2_u=2187 uv2_v=14398 normal_x=-5275 normal_y=171 normal_z=-15511 view_x=-5254 view_y=19385 view_z=3536 light0_x=-3852 light0_y=2266 light0_z=5760
//   b_x: mean 4.44e-6, at most 2.11e-5 (1.4 ulp) at p0_x=-8071 p0_y=1654 p0_z=13781 p1_x=-5340 p1_y=4462 p1_z=-15500 p2_x=-2437 p2_y=5463 p2_z=-14212 uv0_u=15328 uv0_v=4201 uv1_u=15061 uv1_v=17215 uv2_u=6582 uv2_v=2726 normal_x=3874 normal_y=11987 normal_z=-10476 view_x=-16397 view_y=6591 view_z=-4081 light0_x=-1241 light0_y=-4126 light0_z=288
//   b_y: mean 4.44e-6, at most 1.88e-5 (1.2 ulp) at p0_x=-3714 p0_y=11993 p0_z=-4841 p1_x=-3764 p1_y=11931 p1_z=-4739 p2_x=-3759 p2_y=11932 p2_z=-4729 uv0_u=12092 uv0_v=-12014 uv1_u=12267 uv1_v=-11980 uv2_u=12203 uv2_v=-12004 normal_x=-13726 normal_y=-3888 normal_z=8056 view_x=7928 view_y=5000 view_z=-9270 light0_x=-8591 light0_y=-2032 light0_z=2462
//   b_z: mean 4.44e-6, at most 1.98e-5 (1.3 ulp) at p0_x=4141 p0_y=14013 p0_z=-6260 p1_x=4269 p1_y=14979 p1_z=-7029 p2_x=3585 p2_y=15097 p2_z=-6866 uv0_u=-5921 uv0_v=-14115 uv1_u=-4919 uv1_v=-11019 uv2_u=-4604 uv2_v=-11113 normal_x=112 normal_y=-14114 normal_z=-8320 view_x=4104 view_y=-653 view_z=-1311 light0_x=3193 light0_y=10223 light0_z=8490
//   n_angle: mean 0.00e0 rad, at most 0.00e0 rad at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   n_dot: mean 0.00e0, at most 0.00e0 at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   n_x: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   n_y: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   n_z: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   ts_view_angle: mean 3.93e-5 rad, at most 1.91e-4 rad at p0_x=-10379 p0_y=-5989 p0_z=-12594 p1_x=-10455 p1_y=-5549 p1_z=-12755 p2_x=-9709 p2_y=-5739 p2_z=-12952 uv0_u=5256 uv0_v=-6470 uv1_u=5262 uv1_v=-6034 uv2_u=4818 uv2_v=-5248 normal_x=848 normal_y=13600 normal_z=9097 view_x=-4050 view_y=186 view_z=1399 light0_x=5643 light0_y=6660 light0_z=5965
//   ts_view_dot: mean 3.01e-5, at most 8.02e-5 at p0_x=93 p0_y=17274 p0_z=15297 p1_x=-96 p1_y=3762 p1_z=-8987 p2_x=16619 p2_y=4176 p2_z=7976 uv0_u=-1383 uv0_v=2969 uv1_u=1920 uv1_v=1001 uv2_u=-3955 uv2_v=6992 normal_x=-3847 normal_y=8478 normal_z=-13482 view_x=-17726 view_y=15655 view_z=12116 light0_x=-2683 light0_y=3444 light0_z=4548
//   ts_view_x: mean 1.58e-5, at most 6.72e-5 (1.1 ulp) at p0_x=12778 p0_y=-893 p0_z=-1690 p1_x=13532 p1_y=-472 p1_z=-1673 p2_x=13847 p2_y=-805 p2_z=-2306 uv0_u=14279 uv0_v=-11497 uv1_u=14210 uv1_v=-11535 uv2_u=13826 uv2_v=-11581 normal_x=-3885 normal_y=-14892 normal_z=-5618 view_x=-18929 view_y=10081 view_z=-23409 light0_x=-7002 light0_y=3524 light0_z=-2465
//   ts_view_y: mean 1.57e-5, at most 5.53e-5 (0.9 ulp) at p0_x=14966 p0_y=-4901 p0_z=5057 p1_x=14270 p1_y=-5168 p1_z=5855 p2_x=13970 p2_y=-5062 p2_z=5333 uv0_u=6017 uv0_v=2340 uv1_u=5567 uv1_v=2787 uv2_u=5681 uv2_v=2610 normal_x=15873 normal_y=-1072 normal_z=3917 view_x=2653 view_y=27007 view_z=1656 light0_x=16390 light0_y=3803 light0_z=-1999
//   ts_view_z: mean 1.52e-5, at most 3.05e-5 (0.5 ulp) at p0_x=3594 p0_y=11946 p0_z=-523 p1_x=5122 p1_y=12371 p1_z=-1285 p2_x=3431 p2_y=11911 p2_z=-506 uv0_u=6018 uv0_v=10570 uv1_u=7266 uv1_v=9893 uv2_u=9285 uv2_v=7281 normal_x=-1475 normal_y=12091 normal_z=-10958 view_x=-663 view_y=121 view_z=6252 light0_x=1915 light0_y=14656 light0_z=927
//   ts_light0_angle: mean 3.93e-5 rad, at most 1.85e-4 rad at p0_x=-4133 p0_y=6414 p0_z=4611 p1_x=-6787 p1_y=5202 p1_z=4370 p2_x=-6421 p2_y=6226 p2_z=5263 uv0_u=12674 uv0_v=-15695 uv1_u=12664 uv1_v=-15732 uv2_u=13869 uv2_v=-15432 normal_x=3390 normal_y=-6622 normal_z=14598 view_x=-2567 view_y=-1328 view_z=3625 light0_x=-2975 light0_y=-1304 light0_z=-2623
//   ts_light0_dot: mean 3.02e-5, at most 7.79e-5 at p0_x=14042 p0_y=244 p0_z=870 p1_x=13244 p1_y=125 p1_z=1151 p2_x=13458 p2_y=-230 p2_z=818 uv0_u=-8931 uv0_v=-11759 uv1_u=-8598 uv1_v=-11711 uv2_u=-8719 uv2_v=-12141 normal_x=-12332 normal_y=-8894 normal_z=6104 view_x=-8235 view_y=-3 view_z=-9860 light0_x=19580 light0_y=-10606 light0_z=10271
//   ts_light0_x: mean 1.59e-5, at most 6.45e-5 (1.1 ulp) at p0_x=1221 p0_y=-14455 p0_z=-23110 p1_x=-458 p1_y=7451 p1_z=-13623 p2_x=389 p2_y=-15913 p2_z=-20484 uv0_u=9641 uv0_v=-15279 uv1_u=18304 uv1_v=-2656 uv2_u=21139 uv2_v=-9008 normal_x=10502 normal_y=9187 normal_z=-8588 view_x=-838 view_y=-7767 view_z=2349 light0_x=-18601 light0_y=14838 light0_z=18261
//   ts_light0_y: mean 1.57e-5, at most 6.04e-5 (1.0 ulp) at p0_x=2438 p0_y=-14018 p0_z=1104 p1_x=2072 p1_y=-5346 p1_z=313 p2_x=1823 p2_y=-12265 p2_z=4078 uv0_u=-3585 uv0_v=-3488 uv1_u=5415 uv1_v=6678 uv2_u=10042 uv2_v=-3736 normal_x=1193 normal_y=-14634 normal_z=-7270 view_x=-23837 view_y=1801 view_z=-1888 light0_x=-19807 light0_y=-2544 light0_z=-25007
//   ts_light0_z: mean 1.53e-5, at most 3.05e-5 (0.5 ulp) at p0_x=12625 p0_y=15115 p0_z=-8100 p1_x=12746 p1_y=15704 p1_z=-7639 p2_x=12889 p2_y=15622 p2_z=-8084 uv0_u=15295 uv0_v=-10727 uv1_u=14476 uv1_v=-9526 uv2_u=15225 uv2_v=-11996 normal_x=11249 normal_y=6256 normal_z=10137 view_x=216 view_y=-4893 view_z=-2363 light0_x=7415 light0_y=7893 light0_z=-8911
//   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   parallel: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 normal_x=-2432 normal_y=-16174 normal_z=968 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
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
