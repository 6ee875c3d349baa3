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
//   t_angle: mean 6.45e-6 rad, at most 2.16e-5 rad at p0_x=-5927 p0_y=-11095 p0_z=1071 p1_x=-6255 p1_y=-11468 p1_z=2690 p2_x=-7080 p2_y=-11329 p2_z=1763 uv0_u=7666 uv0_v=-7496 uv1_u=7588 uv1_v=-7498 uv2_u=7607 uv2_v=-7670 view_x=1754 view_y=474 view_z=-3837 light0_x=17975 light0_y=-1762 light0_z=1258
//   t_dot: mean 8.59e-6, at most 2.42e-5 at p0_x=9122 p0_y=7380 p0_z=-12309 p1_x=9772 p1_y=6738 p1_z=-11756 p2_x=9789 p2_y=7374 p2_z=-11892 uv0_u=-18149 uv0_v=11201 uv1_u=-15610 uv1_v=15227 uv2_u=-15096 uv2_v=14921 view_x=2845 view_y=4743 view_z=3127 light0_x=-12333 light0_y=12814 light0_z=-20561
//   t_x: mean 4.37e-6, at most 1.98e-5 (1.3 ulp) at p0_x=7146 p0_y=3086 p0_z=-3400 p1_x=10193 p1_y=7138 p1_z=-3097 p2_x=11906 p2_y=6187 p2_z=-2749 uv0_u=2656 uv0_v=4926 uv1_u=2825 uv1_v=5250 uv2_u=2738 uv2_v=5092 view_x=2907 view_y=83 view_z=4228 light0_x=-1720 light0_y=-12523 light0_z=-2330
//   t_y: mean 4.38e-6, at most 1.99e-5 (1.3 ulp) at p0_x=7103 p0_y=20970 p0_z=-5182 p1_x=8045 p1_y=11853 p1_z=2486 p2_x=6350 p2_y=21051 p2_z=846 uv0_u=-2171 uv0_v=-2408 uv1_u=-6958 uv1_v=-6607 uv2_u=-5030 uv2_v=-15052 view_x=-6942 view_y=2324 view_z=1897 light0_x=-6388 light0_y=-8447 light0_z=-1975
//   t_z: mean 4.38e-6, at most 2.01e-5 (1.3 ulp) at p0_x=-11415 p0_y=842 p0_z=4640 p1_x=-11699 p1_y=802 p1_z=4722 p2_x=-11615 p2_y=733 p2_z=3407 uv0_u=-5684 uv0_v=-1949 uv1_u=-6008 uv1_v=-2345 uv2_u=-6076 uv2_v=-2388 view_x=4468 view_y=-4073 view_z=104 light0_x=16073 light0_y=-17347 light0_z=-7496
//   b_angle: mean 8.44e-6 rad, at most 2.79e-5 rad at p0_x=-3180 p0_y=-4413 p0_z=-8034 p1_x=2607 p1_y=7970 p1_z=-15239 p2_x=-889 p2_y=-1785 p2_z=-4853 uv0_u=-6230 uv0_v=5969 uv1_u=-6215 uv1_v=6987 uv2_u=-7813 uv2_v=6182 view_x=3819 view_y=-1036 view_z=10073 light0_x=-1610 light0_y=3550 light0_z=-6305
//   b_dot: mean 1.24e-5, at most 4.30e-5 at p0_x=12278 p0_y=11621 p0_z=13990 p1_x=11375 p1_y=8309 p1_z=13387 p2_x=8998 p2_y=7469 p2_z=8703 uv0_u=-7618 uv0_v=-6460 uv1_u=-16281 uv1_v=-2940 uv2_u=-10517 uv2_v=-1200 view_x=1020 view_y=2741 view_z=-3068 light0_x=13149 light0_y=-2778 light0_z=4761
//   b_x: mean 6.22e-6, at most 3.45e-5 (2.3 ulp) at p0_x=7226 p0_y=-14998 p0_z=871 p1_x=7783 p1_y=-15350 p1_z=1294 p2_x=6970 p2_y=-15610 p2_z=1126 uv0_u=7946 uv0_v=-7080 uv1_u=6965 uv1_v=-9584 uv2_u=5758 uv2_v=-5624 view_x=-10997 view_y=13161 view_z=-21944 light0_x=-6761 light0_y=-20247 light0_z=-17922
//   b_y: mean 6.22e-6, at most 4.25e-5 (2.8 ulp) at p0_x=12278 p0_y=11621 p0_z=13990 p1_x=11375 p1_y=8309 p1_z=13387 p2_x=8998 p2_y=7469 p2_z=8703 uv0_u=-7618 uv0_v=-6460 uv1_u=-16281 uv1_v=-2940 uv2_u=-10517 uv2_v=-1200 view_x=1020 view_y=2741 view_z=-3068 light0_x=13149 light0_y=-2778 light0_z=4761
//   b_z: mean 6.21e-6, at most 3.98e-5 (2.6 ulp) at p0_x=1953 p0_y=4070 p0_z=-8777 p1_x=4920 p1_y=1144 p1_z=-12122 p2_x=319 p2_y=4948 p2_z=-11429 uv0_u=-4360 uv0_v=1025 uv1_u=-3521 uv1_v=180 uv2_u=-3925 uv2_v=365 view_x=-1868 view_y=3527 view_z=3114 light0_x=3632 light0_y=-676 light0_z=-4700
//   n_angle: mean 6.37e-6 rad, at most 2.14e-5 rad at p0_x=-4585 p0_y=-16421 p0_z=-5035 p1_x=-4140 p1_y=-16528 p1_z=-5027 p2_x=-4632 p2_y=-16107 p2_z=-4814 uv0_u=-2538 uv0_v=4694 uv1_u=124 uv1_v=10674 uv2_u=1680 uv2_v=9543 view_x=-4033 view_y=13740 view_z=-2396 light0_x=-3659 light0_y=-1270 light0_z=7129
//   n_dot: mean 8.53e-6, at most 2.25e-5 at p0_x=-2609 p0_y=-2968 p0_z=15363 p1_x=-2538 p1_y=-2536 p1_z=15292 p2_x=-2530 p2_y=-2373 p2_z=15629 uv0_u=16058 uv0_v=-10187 uv1_u=16136 uv1_v=-10301 uv2_u=16085 uv2_v=-10253 view_x=-1835 view_y=4401 view_z=-490 light0_x=-2972 light0_y=1054 light0_z=-2876
//   n_x: mean 4.35e-6, at most 1.90e-5 (1.2 ulp) at p0_x=6773 p0_y=-12739 p0_z=-12588 p1_x=7329 p1_y=-20755 p1_z=-9060 p2_x=6998 p2_y=-18531 p2_z=-12147 uv0_u=8057 uv0_v=9867 uv1_u=-482 uv1_v=18225 uv2_u=15940 uv2_v=9621 view_x=-19182 view_y=-10642 view_z=-24299 light0_x=-1312 light0_y=2631 light0_z=-4570
//   n_y: mean 4.36e-6, at most 1.91e-5 (1.3 ulp) at p0_x=-12226 p0_y=634 p0_z=5936 p1_x=-12086 p1_y=700 p1_z=5995 p2_x=-12181 p2_y=676 p2_z=6066 uv0_u=-8051 uv0_v=-2205 uv1_u=-7886 uv1_v=-1724 uv2_u=-7061 uv2_v=-2075 view_x=3247 view_y=-7270 view_z=5894 light0_x=1770 light0_y=-5827 light0_z=2310
//   n_z: mean 4.35e-6, at most 1.98e-5 (1.3 ulp) at p0_x=12610 p0_y=14358 p0_z=-13232 p1_x=9810 p1_y=15863 p1_z=-14406 p2_x=9325 p2_y=14742 p2_z=-14102 uv0_u=-1328 uv0_v=-4113 uv1_u=-1435 uv1_v=-4121 uv2_u=-1295 uv2_v=-4182 view_x=-229 view_y=-1304 view_z=-4233 light0_x=-8364 light0_y=2670 light0_z=4137
//   ts_view_angle: mean 3.96e-5 rad, at most 1.93e-4 rad at p0_x=15106 p0_y=-3934 p0_z=5162 p1_x=15066 p1_y=-4043 p1_z=5130 p2_x=15008 p2_y=-3962 p2_z=5172 uv0_u=-15017 uv0_v=5398 uv1_u=-14584 uv1_v=4987 uv2_u=-14062 uv2_v=5854 view_x=-663 view_y=4135 view_z=341 light0_x=-23420 light0_y=-11490 light0_z=-2403
//   ts_view_dot: mean 3.07e-5, at most 9.45e-5 at p0_x=-15532 p0_y=2060 p0_z=-11307 p1_x=-15380 p1_y=2177 p1_z=-10629 p2_x=-15573 p2_y=2136 p2_z=-10602 uv0_u=8345 uv0_v=12674 uv1_u=8319 uv1_v=12378 uv2_u=8874 uv2_v=12436 view_x=-1149 view_y=10785 view_z=30560 light0_x=2081 light0_y=3962 light0_z=6437
//   ts_view_x: mean 1.57e-5, at most 5.71e-5 (0.9 ulp) at p0_x=-662 p0_y=-15931 p0_z=2486 p1_x=8497 p1_y=-10119 p1_z=1771 p2_x=3517 p2_y=-5095 p2_z=12770 uv0_u=-7221 uv0_v=12978 uv1_u=-7094 uv1_v=13291 uv2_u=-6784 uv2_v=13117 view_x=-2548 view_y=17058 view_z=21522 light0_x=-1889 light0_y=-8567 light0_z=-5681
//   ts_view_y: mean 1.61e-5, at most 7.54e-5 (1.2 ulp) at p0_x=-15532 p0_y=2060 p0_z=-11307 p1_x=-15380 p1_y=2177 p1_z=-10629 p2_x=-15573 p2_y=2136 p2_z=-10602 uv0_u=8345 uv0_v=12674 uv1_u=8319 uv1_v=12378 uv2_u=8874 uv2_v=12436 view_x=-1149 view_y=10785 view_z=30560 light0_x=2081 light0_y=3962 light0_z=6437
//   ts_view_z: mean 1.58e-5, at most 6.52e-5 (1.1 ulp) at p0_x=-18764 p0_y=-12988 p0_z=-5217 p1_x=-17167 p1_y=-14894 p1_z=-4310 p2_x=-15355 p2_y=-7300 p2_z=5766 uv0_u=13987 uv0_v=-3256 uv1_u=13863 uv1_v=-3526 uv2_u=14480 uv2_v=-3348 view_x=-28162 view_y=-10633 view_z=3107 light0_x=-2916 light0_y=5120 light0_z=15558
//   ts_light0_angle: mean 3.97e-5 rad, at most 2.06e-4 rad at p0_x=-4466 p0_y=-7167 p0_z=-14832 p1_x=-10152 p1_y=-7059 p1_z=-15435 p2_x=-6354 p2_y=-7443 p2_z=-16507 uv0_u=15096 uv0_v=1380 uv1_u=12050 uv1_v=3730 uv2_u=12066 uv2_v=2354 view_x=124 view_y=-4039 view_z=6271 light0_x=-632 light0_y=2017 light0_z=-3838
//   ts_light0_dot: mean 3.08e-5, at most 8.86e-5 at p0_x=1974 p0_y=4624 p0_z=-493 p1_x=1962 p1_y=4210 p1_z=-817 p2_x=946 p2_y=4494 p2_z=-1540 uv0_u=-5909 uv0_v=17467 uv1_u=-13442 uv1_v=18880 uv2_u=-23220 uv2_v=5139 view_x=-11415 view_y=-3935 view_z=-6310 light0_x=19077 light0_y=-21787 light0_z=-8618
//   ts_light0_x: mean 1.57e-5, at most 6.23e-5 (1.0 ulp) at p0_x=-8854 p0_y=5319 p0_z=13456 p1_x=-8796 p1_y=6196 p1_z=13262 p2_x=-8582 p2_y=5602 p2_z=13874 uv0_u=-13794 uv0_v=-2022 uv1_u=-14079 uv1_v=-1741 uv2_u=-13968 uv2_v=-1700 view_x=3187 view_y=4303 view_z=-14686 light0_x=3048 light0_y=-26196 light0_z=13009
//   ts_light0_y: mean 1.62e-5, at most 7.97e-5 (1.3 ulp) at p0_x=1974 p0_y=4624 p0_z=-493 p1_x=1962 p1_y=4210 p1_z=-817 p2_x=946 p2_y=4494 p2_z=-1540 uv0_u=-5909 uv0_v=17467 uv1_u=-13442 uv1_v=18880 uv2_u=-23220 uv2_v=5139 view_x=-11415 view_y=-3935 view_z=-6310 light0_x=19077 light0_y=-21787 light0_z=-8618
//   ts_light0_z: mean 1.57e-5, at most 6.13e-5 (1.0 ulp) at p0_x=-14147 p0_y=-3996 p0_z=7610 p1_x=-11250 p1_y=-5660 p1_z=9809 p2_x=-12527 p2_y=-4472 p2_z=3625 uv0_u=-963 uv0_v=13635 uv1_u=-1001 uv1_v=13455 uv2_u=-1046 uv2_v=13552 view_x=-3767 view_y=-2892 view_z=-2228 light0_x=-17184 light0_y=-24469 light0_z=1783
//   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
//   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-4440 p0_y=-8475 p0_z=-14415 p1_x=-4821 p1_y=-7529 p1_z=-14088 p2_x=-4089 p2_y=-7609 p2_z=-13972 uv0_u=-11442 uv0_v=9922 uv1_u=-11427 uv1_v=10044 uv2_u=-11481 uv2_v=10156 view_x=-7537 view_y=6109 view_z=13094 light0_x=1657 light0_y=-2382 light0_z=-3391
// stated bound on each tangent: 5.74e-5
// stated bound on each binormal: 1.28e-4
// stated bound on each normal: 5.74e-5
// stated bound on each view: 5.78e-4
// stated bound on each light0: 5.78e-4
// stated bound on each flags: 0.00e0
//
// Self-checking testbench of tangent_faceted. It reads tangent_faceted_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 305 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes tangent_faceted_tb.vcd.
module tangent_faceted_tb;
    localparam LATENCY = 21;
    localparam VECTORS = 305;
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
                        if (stalls && sent == 305) more = 1'b0;
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
            if (stalls && !reset_done && sent == 305 / 2) begin
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
