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
//   t_angle: mean 6.48e-6 rad, at most 1.96e-5 rad at p0_x=17354 p0_y=8360 p0_z=19876 p1_x=12416 p1_y=2144 p1_z=6776 p2_x=6288 p2_y=7448 p2_z=26840 uv0_u=-11814 uv0_v=-11791 uv1_u=-11843 uv1_v=-11706 uv2_u=-11757 uv2_v=-11667 view_x=-578 view_y=-3659 view_z=1930 light0_x=3235 light0_y=7280 light0_z=8272
//   t_dot: mean 8.62e-6, at most 2.31e-5 at p0_x=-3977 p0_y=-2247 p0_z=12757 p1_x=-7571 p1_y=-7658 p1_z=12820 p2_x=156 p2_y=-4587 p2_z=10504 uv0_u=9002 uv0_v=13737 uv1_u=9046 uv1_v=13793 uv2_u=9051 uv2_v=13663 view_x=-1267 view_y=4021 view_z=-333 light0_x=389 light0_y=-3071 light0_z=2715
//   t_x: mean 4.40e-6, at most 1.97e-5 (1.3 ulp) at p0_x=9284 p0_y=-3493 p0_z=-3736 p1_x=9160 p1_y=-3452 p1_z=-3609 p2_x=9019 p2_y=-3386 p2_z=-3771 uv0_u=-16367 uv0_v=-7717 uv1_u=-13327 uv1_v=-5585 uv2_u=-18661 uv2_v=-10805 view_x=-5671 view_y=-8782 view_z=-1494 light0_x=-3709 light0_y=-8505 light0_z=6138
//   t_y: mean 4.40e-6, at most 1.96e-5 (1.3 ulp) at p0_x=3279 p0_y=8679 p0_z=-15980 p1_x=2427 p1_y=8671 p1_z=-15309 p2_x=2885 p2_y=8087 p2_z=-15477 uv0_u=-13104 uv0_v=-4401 uv1_u=-14609 uv1_v=-7850 uv2_u=-15592 uv2_v=-6185 view_x=3937 view_y=-16021 view_z=6330 light0_x=297 light0_y=9264 light0_z=-17765
//   t_z: mean 4.38e-6, at most 2.01e-5 (1.3 ulp) at p0_x=-8725 p0_y=14727 p0_z=13006 p1_x=-8699 p1_y=14847 p1_z=12986 p2_x=-8743 p2_y=14816 p2_z=13059 uv0_u=939 uv0_v=-2961 uv1_u=-1521 uv1_v=-6402 uv2_u=1418 uv2_v=-5400 view_x=-1506 view_y=3177 view_z=3849 light0_x=14610 light0_y=-7690 light0_z=-621
//   b_angle: mean 8.45e-6 rad, at most 2.69e-5 rad at p0_x=4185 p0_y=7298 p0_z=5131 p1_x=5334 p1_y=10722 p1_z=2325 p2_x=9456 p2_y=8256 p2_z=4578 uv0_u=-6024 uv0_v=-2922 uv1_u=-5129 uv1_v=-3864 uv2_u=-4903 uv2_v=-2852 view_x=-31824 view_y=3119 view_z=-5355 light0_x=16649 light0_y=-8093 light0_z=7604
//   b_dot: mean 1.24e-5, at most 4.13e-5 at p0_x=2727 p0_y=-15657 p0_z=-1825 p1_x=2139 p1_y=-13562 p1_z=-2014 p2_x=1581 p2_y=-15644 p2_z=-3682 uv0_u=-14348 uv0_v=-2260 uv1_u=-14803 uv1_v=-1795 uv2_u=-13838 uv2_v=-1973 view_x=4453 view_y=1001 view_z=-845 light0_x=-1055 light0_y=3371 light0_z=8300
//   b_x: mean 6.24e-6, at most 3.38e-5 (2.2 ulp) at p0_x=-9895 p0_y=1127 p0_z=8564 p1_x=-5361 p1_y=-5195 p1_z=-2305 p2_x=-4941 p2_y=2729 p2_z=9830 uv0_u=4016 uv0_v=-13259 uv1_u=4394 uv1_v=-13444 uv2_u=4313 uv2_v=-13581 view_x=-1478 view_y=8678 view_z=540 light0_x=-4528 light0_y=-5963 light0_z=19418
//   b_y: mean 6.23e-6, at most 3.39e-5 (2.2 ulp) at p0_x=-15019 p0_y=9014 p0_z=-13295 p1_x=-14507 p1_y=8933 p1_z=-12869 p2_x=-14987 p2_y=8562 p2_z=-13317 uv0_u=-14881 uv0_v=15595 uv1_u=-14823 uv1_v=15588 uv2_u=-14894 uv2_v=15693 view_x=2866 view_y=-4790 view_z=4016 light0_x=9546 light0_y=-921 light0_z=-8693
//   b_z: mean 6.24e-6, at most 3.48e-5 (2.3 ulp) at p0_x=-3692 p0_y=8154 p0_z=-10601 p1_x=-3711 p1_y=7749 p1_z=-10993 p2_x=-3945 p2_y=8012 p2_z=-10163 uv0_u=1555 uv0_v=-2538 uv1_u=1241 uv1_v=-2775 uv2_u=1226 uv2_v=-2342 view_x=6019 view_y=4765 view_z=1213 light0_x=-15436 light0_y=-2902 light0_z=13127
//   n_angle: mean 6.35e-6 rad, at most 2.11e-5 rad at p0_x=-8525 p0_y=5610 p0_z=14302 p1_x=-7985 p1_y=5335 p1_z=14453 p2_x=-8307 p2_y=6017 p2_z=14413 uv0_u=-14033 uv0_v=10384 uv1_u=-14566 uv1_v=9742 uv2_u=-15380 uv2_v=9625 view_x=-4112 view_y=4 view_z=465 light0_x=-4351 light0_y=-1403 light0_z=6776
//   n_dot: mean 8.50e-6, at most 2.54e-5 at p0_x=5670 p0_y=-1432 p0_z=-9760 p1_x=6211 p1_y=-2614 p1_z=-10342 p2_x=5615 p2_y=-1477 p2_z=-10166 uv0_u=6046 uv0_v=-13851 uv1_u=6205 uv1_v=-13667 uv2_u=6116 uv2_v=-13752 view_x=-5628 view_y=-10551 view_z=1846 light0_x=-2820 light0_y=3776 light0_z=-729
//   n_x: mean 4.32e-6, at most 1.97e-5 (1.3 ulp) at p0_x=-5587 p0_y=-9777 p0_z=-4927 p1_x=-5685 p1_y=-10675 p1_z=-13686 p2_x=-7131 p2_y=-14045 p2_z=-11875 uv0_u=18660 uv0_v=5079 uv1_u=18028 uv1_v=6508 uv2_u=15304 uv2_v=3518 view_x=10808 view_y=13351 view_z=-12460 light0_x=-2302 light0_y=585 light0_z=5071
//   n_y: mean 4.33e-6, at most 1.99e-5 (1.3 ulp) at p0_x=-10042 p0_y=-1339 p0_z=-3039 p1_x=-9952 p1_y=-1055 p1_z=-3726 p2_x=-10343 p2_y=-1458 p2_z=-3187 uv0_u=-7735 uv0_v=3129 uv1_u=-9856 uv1_v=147 uv2_u=-5085 uv2_v=6386 view_x=4704 view_y=-870 view_z=-148 light0_x=-1652 light0_y=8593 light0_z=26892
//   n_z: mean 4.35e-6, at most 1.97e-5 (1.3 ulp) at p0_x=14877 p0_y=-20515 p0_z=-17729 p1_x=14758 p1_y=543 p1_z=-10852 p2_x=2720 p2_y=3217 p2_z=-6578 uv0_u=-16018 uv0_v=-4401 uv1_u=-8707 uv1_v=3321 uv2_u=-11736 uv2_v=2209 view_x=8990 view_y=-905 view_z=2405 light0_x=1272 light0_y=-3105 light0_z=3092
//   ts_view_angle: mean 3.95e-5 rad, at most 2.00e-4 rad at p0_x=-15816 p0_y=1594 p0_z=-5449 p1_x=-9136 p1_y=-967 p1_z=-9324 p2_x=-8817 p2_y=7877 p2_z=-10436 uv0_u=-3252 uv0_v=-1882 uv1_u=-3334 uv1_v=-2003 uv2_u=-3218 uv2_v=-1654 view_x=489 view_y=3026 view_z=-2754 light0_x=4389 light0_y=-1970 light0_z=-4583
//   ts_view_dot: mean 3.07e-5, at most 8.46e-5 at p0_x=14650 p0_y=5324 p0_z=-11359 p1_x=14934 p1_y=5318 p1_z=-11666 p2_x=14912 p2_y=5480 p2_z=-11532 uv0_u=-16511 uv0_v=1868 uv1_u=-12104 uv1_v=-4 uv2_u=-13683 uv2_v=-1262 view_x=-5426 view_y=-31528 view_z=-4848 light0_x=-6143 light0_y=-4864 light0_z=-5443
//   ts_view_x: mean 1.57e-5, at most 5.88e-5 (1.0 ulp) at p0_x=5878 p0_y=7518 p0_z=16795 p1_x=5739 p1_y=12805 p1_z=18195 p2_x=5657 p2_y=7023 p2_z=13923 uv0_u=4015 uv0_v=-9102 uv1_u=3078 uv1_v=-9754 uv2_u=453 uv2_v=-9180 view_x=7735 view_y=-14355 view_z=-23535 light0_x=-2007 light0_y=-4241 light0_z=4390
//   ts_view_y: mean 1.62e-5, at most 7.65e-5 (1.3 ulp) at p0_x=-15315 p0_y=-5364 p0_z=-7467 p1_x=-15280 p1_y=-5299 p1_z=-7428 p2_x=-15302 p2_y=-5390 p2_z=-7483 uv0_u=-14473 uv0_v=4154 uv1_u=-16381 uv1_v=3415 uv2_u=-14957 uv2_v=4258 view_x=15606 view_y=25390 view_z=8391 light0_x=-4073 light0_y=1815 light0_z=2848
//   ts_view_z: mean 1.57e-5, at most 6.11e-5 (1.0 ulp) at p0_x=2993 p0_y=-1901 p0_z=-15333 p1_x=2596 p1_y=-1843 p1_z=-15320 p2_x=2677 p2_y=-1826 p2_z=-15494 uv0_u=-12722 uv0_v=8038 uv1_u=-12488 uv1_v=6556 uv2_u=-11750 uv2_v=6793 view_x=-14610 view_y=27993 view_z=7804 light0_x=2639 light0_y=7019 light0_z=-6813
//   ts_light0_angle: mean 3.95e-5 rad, at most 2.02e-4 rad at p0_x=-14877 p0_y=-12093 p0_z=10707 p1_x=-14855 p1_y=-13082 p1_z=11444 p2_x=-15811 p2_y=-13450 p2_z=12922 uv0_u=-6384 uv0_v=11918 uv1_u=-7618 uv1_v=14629 uv2_u=-6954 uv2_v=12881 view_x=-4883 view_y=3104 view_z=4535 light0_x=3630 light0_y=-372 light0_z=1907
//   ts_light0_dot: mean 3.07e-5, at most 7.62e-5 at p0_x=-5249 p0_y=1656 p0_z=-8042 p1_x=-5147 p1_y=1461 p1_z=-7922 p2_x=-4034 p2_y=2058 p2_z=-8565 uv0_u=-16871 uv0_v=7696 uv1_u=-16727 uv1_v=8704 uv2_u=-17083 uv2_v=7924 view_x=13448 view_y=7249 view_z=23744 light0_x=24517 light0_y=13885 light0_z=-4514
//   ts_light0_x: mean 1.57e-5, at most 6.33e-5 (1.0 ulp) at p0_x=-5836 p0_y=3280 p0_z=3011 p1_x=-5771 p1_y=6594 p1_z=6951 p2_x=-7742 p2_y=6237 p2_z=2998 uv0_u=-5577 uv0_v=-8593 uv1_u=-5536 uv1_v=-8633 uv2_u=-5220 uv2_v=-8711 view_x=-4235 view_y=8857 view_z=16296 light0_x=685 light0_y=12183 light0_z=27317
//   ts_light0_y: mean 1.62e-5, at most 7.48e-5 (1.2 ulp) at p0_x=11802 p0_y=-7858 p0_z=4797 p1_x=12464 p1_y=-8360 p1_z=2055 p2_x=14542 p2_y=-8593 p2_z=6048 uv0_u=6880 uv0_v=-5961 uv1_u=6256 uv1_v=-5671 uv2_u=7430 uv2_v=-3745 view_x=3647 view_y=2488 view_z=-1186 light0_x=-29774 light0_y=7315 light0_z=1107
//   ts_light0_z: mean 1.57e-5, at most 6.10e-5 (1.0 ulp) at p0_x=4679 p0_y=2416 p0_z=-2219 p1_x=4733 p1_y=2362 p1_z=-2206 p2_x=4771 p2_y=2354 p2_z=-2255 uv0_u=-12814 uv0_v=-14947 uv1_u=-12760 uv1_v=-15047 uv2_u=-12793 uv2_v=-15042 view_x=-9785 view_y=8500 view_z=-2064 light0_x=17552 light0_y=27551 light0_z=234
//   mirrored: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   degenerate: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   zero_uv: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
//   zero_area: mean 0.00e0, at most 0.00e0 (0.0 ulp) at p0_x=-2251 p0_y=-12103 p0_z=-4471 p1_x=-2315 p1_y=-12265 p1_z=-4389 p2_x=-2396 p2_y=-12196 p2_z=-4368 uv0_u=-15135 uv0_v=-8131 uv1_u=-7065 uv1_v=-24240 uv2_u=-5879 uv2_v=-14467 view_x=-498 view_y=-7436 view_z=1651 light0_x=-5316 light0_y=3367 light0_z=5947
// stated bound on each tangent: 5.74e-5
// stated bound on each binormal: 1.28e-4
// stated bound on each normal: 5.74e-5
// stated bound on each view: 5.78e-4
// stated bound on each light0: 5.78e-4
// stated bound on each flags: 0.00e0
//
// Self-checking testbench of tangent_faceted. It reads tangent_faceted_vectors.txt: per line the words of the
// inputs, then of the expected outputs, in hexadecimal. First all vectors go straight through,
// one a cycle; then, after a reset in mid-stream, the first 336 go again with stalls and
// gaps. Every bit of every output and the latency are compared. The last line says PASS or
// FAIL, and a failure ends with a status that isn't 0. With +vcd it writes tangent_faceted_tb.vcd.
module tangent_faceted_tb;
    localparam LATENCY = 21;
    localparam VECTORS = 336;
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
                        if (stalls && sent == 336) more = 1'b0;
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
            if (stalls && !reset_done && sent == 336 / 2) begin
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
